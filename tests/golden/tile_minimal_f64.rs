// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 3; the worst over 73 sampled configurations is 0.773 of its nominal size.
// Cost of rates: 3289 operations (3 abs, 752 add, 10 div, 2 min, 1862 mul, 4 sqrt, 656 sub).
// Cost of energy: 916 operations (187 add, 7 div, 587 mul, 4 sqrt, 131 sub).
// Cost of speeds: 0 operations ().
// Cost of outputs: 99 operations (18 add, 3 asin, 3 atan2, 4 div, 55 mul, 1 sqrt, 15 sub).
// Cost of projection: 0 operations ().

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f64;
/// Number of coordinates q.
pub const NQ: usize = 3usize;
/// Number of independent speeds u.
pub const NU: usize = 3usize;
/// Number of inputs.
pub const N_INPUTS: usize = 3usize;
///Coordinates in order.
pub const Q_NAMES: [&str; 3usize] = ["hA", "hB", "hC"];
///Independent speeds in order.
pub const U_NAMES: [&str; 3usize] = ["u_hA", "u_hB", "u_hC"];
///Inputs in order.
pub const INPUT_NAMES: [&str; 3usize] = ["FA", "FB", "FC"];
///Tunable parameters in order.
pub const PARAMETER_NAMES: [&str; 13usize] = [
    "R",
    "ms",
    "mr",
    "mc",
    "Ic1",
    "Ic2",
    "Ic3",
    "M",
    "Ix",
    "Iy",
    "Iz",
    "c",
    "g",
];
///All speeds in order.
pub const SPEED_NAMES: [&str; 3usize] = ["u_hA", "u_hB", "u_hC"];
///Outputs in order.
pub const OUTPUT_NAMES: [&str; 12usize] = [
    "Gx",
    "Gy",
    "Gz",
    "psiA",
    "thA",
    "sA",
    "psiB",
    "thB",
    "sB",
    "psiC",
    "thC",
    "sC",
];
/// Indices of the coordinates that the projection corrects.
pub const CORRECTED: [usize; 0usize] = [];
/// Coordinates read only by sines and cosines: they may be wrapped by whole turns.
pub const IS_ANGLE: [bool; 3usize] = [false, false, false];
/// The nominal configuration.
pub const NOMINAL: [f64; 3usize] = [0f64, 0f64, 0f64];
/// Tunable parameters, SI units.
#[derive(Clone, Copy, Debug)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Parameters {
    ///Radius of the circle of screws (m), models/tile_minimal.toml:12.
    pub R: S,
    ///Mass that moves with a screw (kg), models/tile_minimal.toml:13.
    pub ms: S,
    ///Inertia of motor, worm and screw reflected on the height; has no weight (kg), models/tile_minimal.toml:14.
    pub mr: S,
    ///Mass of a connector (kg), models/tile_minimal.toml:15.
    pub mc: S,
    ///Connector about its rod (kg m^2), models/tile_minimal.toml:16.
    pub Ic1: S,
    ///Connector about its horizontal axis (kg m^2), models/tile_minimal.toml:17.
    pub Ic2: S,
    ///Connector about its third axis (kg m^2), models/tile_minimal.toml:18.
    pub Ic3: S,
    ///Mass of the platform (kg), models/tile_minimal.toml:19.
    pub M: S,
    ///Platform about rod A (kg m^2), models/tile_minimal.toml:20.
    pub Ix: S,
    ///Platform across rod A (kg m^2), models/tile_minimal.toml:21.
    pub Iy: S,
    ///Platform about its normal (kg m^2), models/tile_minimal.toml:22.
    pub Iz: S,
    ///Viscous friction of a screw (N s/m), models/tile_minimal.toml:23.
    pub c: S,
    ///Gravity (m/s^2), models/tile_minimal.toml:24.
    pub g: S,
}
impl Default for Parameters {
    fn default() -> Self {
        Self {
            R: 0.2_f64,
            ms: 0.8_f64,
            mr: 2.0_f64,
            mc: 0.15_f64,
            Ic1: 0.0001_f64,
            Ic2: 0.0001_f64,
            Ic3: 0.0002_f64,
            M: 6.0_f64,
            Ix: 0.09_f64,
            Iy: 0.09_f64,
            Iz: 0.17_f64,
            c: 40.0_f64,
            g: 9.81_f64,
        }
    }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///3289 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn rates(
    _t: S,
    q: &[S; 3usize],
    u: &[S; 3usize],
    inputs: &[S; 3usize],
    p: &Parameters,
) -> ([S; 3usize], [S; 3usize], S) {
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let R = p.R;
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let t2 = t1 * (1.7320508075688772_f64 * (hB - hC));
    let t3 = t2 * t2;
    let hA = q[0];
    let t4 = t1 * (2.0_f64 * (0.5_f64 * hC - (hA - 0.5_f64 * hB)));
    let t5 = t4 * t4;
    let root = Real::sqrt(t3 + (1.0_f64 + t5));
    let t6 = 1.0_f64 / root;
    let t7 = 2.0_f64 * t1;
    let t8 = 0.5_f64 * t6;
    let t9 = t7 * t4;
    let t10 = 2.0_f64 * t9;
    let t11 = t8 * t10;
    let t12 = t4 * t6;
    let t13 = t6 * (t7 - t11 * t12);
    let t14 = 1.0_f64 + root;
    let k = 1.0_f64 / (root * t14);
    let t15 = t5 * k - 1.0_f64;
    let t16 = t2 * t6;
    let t17 = t6 * (t11 * t16);
    let t18 = t4 * k;
    let t19 = t2 * t18;
    let t20 = t9 + t11 * t14;
    let t21 = k * (k * t20);
    let t22 = t3 * t21;
    let t23 = t10 * k;
    let t24 = t23 - t5 * t21;
    let t25 = 1.0_f64 - t3 * k;
    let t26 = t7 * k - t4 * t21;
    let t27 = t2 * t26;
    let t28 = t13 * t15 - t17 * t19 - t12 * (t15 * t22 + t24 * t25 + 2.0_f64 * (t19 * t27));
    let Iy = p.Iy;
    let t29 = Iy * t28;
    let t30 = t15 * t25 + t19 * t19;
    let t31 = t16 * t22 - t12 * t27 - t17 * t30;
    let Ix = p.Ix;
    let t32 = Ix * t31;
    let t33 = t19 * t24 - t25 * t27 + t13 * t16;
    let Iz = p.Iz;
    let t34 = Iz * t33;
    let M = p.M;
    let t35 = 0.5_f64 * R;
    let t36 = 1.0_f64 / t14;
    let t37 = 2.0_f64 * t4;
    let t38 = t2 * t37 * t36;
    let t39 = 4.0_f64 * t1;
    let t40 = t36 * (t11 * t38 - t39 * t2);
    let t41 = 3.0_f64 * t4;
    let cos3 = t4 * t5 - t3 * t41;
    let shift = t36 * (k * cos3);
    let t42 = 6.0_f64 * t1;
    let t43 = t4 * (3.0_f64 * t9) - t42 * t3;
    let t44 = t36 * (t11 * shift + (t21 * cos3 - k * t43));
    let t45 = t35 * (t40 + t2 * t44);
    let cos2 = t5 - t3;
    let t46 = t36 * cos2;
    let t47 = t36 * (t10 - t11 * t46);
    let t48 = t35 * (t47 + (t4 * t44 - t7 * shift));
    let t49 = t35 * cos3;
    let t50 = 0.3333333333333333_f64 + (t21 * t49 - k * cos2);
    let t51 = 0.5_f64 * t15;
    let t52 = 0.8660254037844386_f64 * t19;
    let t53 = t51 - t52;
    let t54 = 0.8660254037844386_f64 * t17;
    let t55 = 0.5_f64 * t13;
    let t56 = t54 + t55;
    let t57 = 0.8660254037844386_f64 * t16;
    let t58 = 0.5_f64 * t12;
    let dzC = t57 - t58;
    let t59 = 1.0_f64 / Real::sqrt(1.0_f64 - dzC * dzC);
    let t60 = t59 * t53;
    let t61 = 0.5_f64 * t24;
    let t62 = 0.8660254037844386_f64 * t27;
    let t63 = t61 - t62;
    let t64 = 0.5_f64 * t59;
    let t65 = 2.0_f64 * (dzC * t56);
    let t66 = t64 * t65;
    let t67 = t59 * (t59 * t66);
    let t68 = t59 * t63 - t67 * t53;
    let t69 = t56 * t60 - dzC * t68;
    let t70 = 0.8660254037844386_f64 * t25;
    let t71 = 0.5_f64 * t19;
    let t72 = t70 + t71;
    let t73 = t1 * k;
    let t74 = root + t14;
    let t75 = 1.7320508075688772_f64 * t1;
    let t76 = 2.0_f64 * (t75 * t2);
    let t77 = t9 - t76;
    let t78 = t8 * t77;
    let t79 = t74 * t78;
    let t80 = k * (k * t79);
    let t81 = t73 - t4 * t80;
    let t82 = t2 * t81;
    let t83 = t67 * t72 - t59 * t82;
    let t84 = t59 * t72;
    let t85 = dzC * t83 + t56 * t84;
    let t86 = t53 * t68 + t63 * t60 - (t72 * t83 - t82 * t84);
    let t87 = t53 * t69 + t72 * t85 + dzC * t86;
    let Ic2 = p.Ic2;
    let t88 = Ic2 * t87;
    let t89 = dzC * t60;
    let t90 = dzC * t84;
    let t91 = t83 * t89 + t68 * t90;
    let Ic1 = p.Ic1;
    let t92 = Ic1 * t91;
    let t93 = t60 * t82 - t63 * t84;
    let Ic3 = p.Ic3;
    let t94 = Ic3 * t93;
    let t95 = t57 + t58;
    let t96 = t52 + t51;
    let t97 = 1.0_f64 / Real::sqrt(1.0_f64 - t95 * t95);
    let t98 = t62 + t61;
    let t99 = 0.5_f64 * t97;
    let t100 = t54 - t55;
    let t101 = 2.0_f64 * (t95 * t100);
    let t102 = t99 * t101;
    let t103 = t97 * (t97 * t102);
    let t104 = t97 * t98 - t103 * t96;
    let t105 = t97 * t96;
    let t106 = t70 - t71;
    let t107 = t9 + t76;
    let t108 = t8 * t107;
    let t109 = t74 * t108;
    let t110 = k * (k * t109);
    let t111 = t4 * t110 - t73;
    let t112 = t2 * t111;
    let t113 = t97 * t112 - t103 * t106;
    let t114 = t97 * t106;
    let t115 = t96 * t104 + t98 * t105 + (t106 * t113 + t112 * t114);
    let t116 = t95 * t113 - t100 * t114;
    let t117 = t100 * t105 - t95 * t104;
    let t118 = t95 * t115 - (t106 * t116 - t96 * t117);
    let t119 = Ic2 * t118;
    let t120 = t95 * t105;
    let t121 = t95 * t114;
    let t122 = t113 * t120 - t104 * t121;
    let t123 = Ic1 * t122;
    let t124 = t105 * t112 - t98 * t114;
    let t125 = Ic3 * t124;
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t126 = 1.0_f64 / Real::sqrt(1.0_f64 - t12 * t12);
    let t127 = 0.5_f64 * t126;
    let t128 = 2.0_f64 * (t12 * t13);
    let t129 = t127 * t128;
    let t130 = t126 * (t126 * t129);
    let t131 = t15 * t130 + t24 * t126;
    let t132 = t15 * t126;
    let t133 = t12 * t131 + t13 * t132;
    let t134 = t19 * t130 + t27 * t126;
    let t135 = t19 * t126;
    let t136 = t12 * t134 + t13 * t135;
    let t137 = t15 * t131 + t24 * t132 + (t19 * t134 + t27 * t135);
    let t138 = t15 * t133 + t19 * t136 - t12 * t137;
    let t139 = Ic2 * t138;
    let t140 = t12 * t132;
    let t141 = t12 * t135;
    let t142 = t134 * t140 - t131 * t141;
    let t143 = Ic1 * t142;
    let t144 = t24 * t135 - t27 * t132;
    let t145 = Ic3 * t144;
    let t146 = t118 * t119 + t122 * t123 + t124 * t125 + (mc + (ms + mr) + (t138 * t139 + t142 * t143 + t144 * t145));
    let t147 = M * (t45 * t45 + t48 * t48 + t50 * t50) + (t87 * t88 + t91 * t92 + t93 * t94 + t146);
    let mass_u_hA_u_hA = t28 * t29 + t31 * t32 + t33 * t34 + t147;
    let t148 = 1.0_f64 / mass_u_hA_u_hA;
    let t149 = t9 * k;
    let t150 = t149 - t5 * t80;
    let t151 = t75 * t18;
    let t152 = t82 - t151;
    let t153 = t19 * t150 - t25 * t152 + t16 * t56;
    let t154 = t6 * (t75 + t16 * t78);
    let t155 = k * t76;
    let t156 = t155 + t3 * t80;
    let t157 = t19 * t154 - t15 * t56 + t12 * (t15 * t156 + t25 * t150 + 2.0_f64 * (t19 * t152));
    let t158 = t12 * t152 - t16 * t156 + t30 * t154;
    let t159 = 0.8660254037844386_f64 * t156;
    let t160 = 0.5_f64 * t152;
    let t161 = t159 + t160;
    let t162 = 0.5_f64 * t150;
    let t163 = 0.8660254037844386_f64 * t152;
    let t164 = t162 - t163;
    let t165 = t60 * t161 - t84 * t164;
    let t166 = 0.8660254037844386_f64 * t154;
    let t167 = 0.5_f64 * t56;
    let t168 = t166 + t167;
    let t169 = 2.0_f64 * (dzC * t168);
    let t170 = t64 * t169;
    let t171 = t59 * (t59 * t170);
    let t172 = t59 * t161 - t72 * t171;
    let t173 = t53 * t171 - t59 * t164;
    let t174 = t89 * t172 + t90 * t173;
    let t175 = dzC * t173 + t60 * t168;
    let t176 = t84 * t168 - dzC * t172;
    let t177 = t60 * t164 - t53 * t173 + (t72 * t172 + t84 * t161);
    let t178 = t53 * t175 + t72 * t176 + dzC * t177;
    let t179 = t167 - t166;
    let t180 = 2.0_f64 * (t95 * t179);
    let t181 = t99 * t180;
    let t182 = t97 * (t97 * t181);
    let t183 = t163 + t162;
    let t184 = t96 * t182 + t97 * t183;
    let t185 = t95 * t184 + t105 * t179;
    let t186 = t160 - t159;
    let t187 = t97 * t186 - t106 * t182;
    let t188 = t114 * t179 - t95 * t187;
    let t189 = t106 * t187 + t114 * t186 - (t96 * t184 + t105 * t183);
    let t190 = t96 * t185 + t106 * t188 + t95 * t189;
    let t191 = t120 * t187 + t121 * t184;
    let t192 = t114 * t183 + t105 * t186;
    let t193 = 2.0_f64 * (t12 * t56);
    let t194 = t127 * t193;
    let t195 = t126 * (t126 * t194);
    let t196 = t19 * t195 + t126 * t152;
    let t197 = t15 * t195 + t126 * t150;
    let t198 = t140 * t196 - t141 * t197;
    let t199 = t15 * t197 + t132 * t150 + (t19 * t196 + t135 * t152);
    let t200 = t12 * t197 + t56 * t132;
    let t201 = t12 * t196 + t56 * t135;
    let t202 = t12 * t199 - (t15 * t200 + t19 * t201);
    let t203 = t135 * t150 - t132 * t152;
    let t204 = t119 * t190 + t123 * t191 + t125 * t192 - (t143 * t198 - t139 * t202 + t145 * t203);
    let t205 = t7 * t2;
    let t206 = t75 * t37;
    let t207 = t36 * (t205 - t206 - t38 * t78);
    let t208 = t75 * shift;
    let t209 = 3.0_f64 * t1;
    let t210 = t209 * t5;
    let t211 = t41 * t76;
    let t212 = t209 * t3;
    let t213 = t210 + (t211 - t212);
    let t214 = t36 * (shift * t78 + (cos3 * t80 - k * t213));
    let t215 = t35 * (t207 - (t208 + t2 * t214));
    let t216 = t36 * (t46 * t78 - t107);
    let t217 = t1 * shift;
    let t218 = t35 * (t216 + (t217 - t4 * t214));
    let t219 = t35 * t213;
    let t220 = 0.3333333333333333_f64 + (k * t219 - t49 * t80);
    let t221 = t94 * t165 - (t92 * t174 - t88 * t178) - t204 - M * (t45 * t215 + t48 * t218 + t50 * t220);
    let t222 = t34 * t153 - (t29 * t157 + t32 * t158) + t221;
    let t223 = t148 * t222;
    let FC = inputs[2];
    let c = p.c;
    let t224 = t6 * (t16 * t108 - t75);
    let t225 = t112 - t151;
    let t226 = t155 - t3 * t110;
    let t227 = t30 * t224 - (t12 * t225 - t16 * t226);
    let t228 = u_hC * t158 + (u_hB * t227 + u_hA * t31);
    let t229 = t5 * t110 - t149;
    let t230 = t12 * (t15 * t226 + t25 * t229 + 2.0_f64 * (t19 * t225)) - (t15 * t100 + t19 * t224);
    let t231 = u_hC * t157 + (u_hA * t28 - u_hB * t230);
    let t232 = u_hC * t152 - (u_hB * t225 + u_hA * t27);
    let t233 = u_hC * t150 - (u_hB * t229 + u_hA * t24);
    let t234 = u_hB * t226 + u_hA * t22 - u_hC * t156;
    let t235 = t233 + t234;
    let t236 = u_hB * t100 + u_hA * t13 - u_hC * t56;
    let t237 = u_hC * t154 + (u_hB * t224 - u_hA * t17);
    let t238 = u_hC * u_hC;
    let t239 = t11 * t17;
    let t240 = t1 * t7;
    let t241 = 4.0_f64 * t240;
    let t242 = t8 * t241;
    let t243 = t6 * (t8 * t11);
    let t244 = t242 - t10 * t243;
    let t245 = t6 * (t239 - (t16 * t244 - t239));
    let t246 = 0.8660254037844386_f64 * t245;
    let t247 = t6 * (3.0_f64 * (t12 * t244));
    let t248 = 0.5_f64 * t247;
    let t249 = t246 + t248;
    let t250 = 0.5_f64 * t249;
    let t251 = 2.0_f64 * t240;
    let t252 = t251 * t8;
    let t253 = t252 - t77 * t243;
    let t254 = t6 * (t16 * t253 - t11 * t154 - t17 * t78);
    let t255 = 0.8660254037844386_f64 * t254;
    let t256 = t250 - t255;
    let t257 = u_hB * u_hC;
    let t258 = t255 + t250;
    let t259 = t257 * t258;
    let t260 = u_hB * u_hB;
    let t261 = t252 - t107 * t243;
    let t262 = t6 * (t17 * t108 - (t16 * t261 - t11 * t224));
    let t263 = t246 - t248;
    let t264 = 0.8660254037844386_f64 * t262 + 0.5_f64 * t263;
    let t265 = u_hA * u_hB;
    let t266 = t265 * t263;
    let t267 = u_hA * u_hA;
    let t268 = u_hA * u_hC;
    let t269 = t268 * t249;
    let t270 = t259 + (t259 - (t260 * t264 - (t266 + (t266 + t267 * t247 - t269))) - t269);
    let t271 = t238 * t256 + t270;
    let t272 = t240 * k;
    let t273 = t9 * t80;
    let t274 = t79 * t80;
    let t275 = t6 * (t8 * t78);
    let t276 = t242 - t77 * t275;
    let t277 = k * (t274 - (k * (t251 + (t14 * t276 + t78 * t78)) - t274));
    let t278 = t272 - t273 - (t273 - t5 * t277);
    let t279 = t79 * t110;
    let t280 = t252 + t107 * t275;
    let t281 = k * (t279 + (k * (t240 - (t78 * t108 - t14 * t280)) + t279));
    let t282 = t9 * t110;
    let t283 = t282 - t272;
    let t284 = t5 * t281 - t273 - t283;
    let t285 = t257 * t284;
    let t286 = t251 * k - t9 * t21;
    let t287 = t20 * t110;
    let t288 = k * (k * (t240 + (t14 * t261 + t11 * t108)) - t287 - t287);
    let t289 = t286 - (t5 * t288 + t10 * t110);
    let t290 = t265 * t289;
    let t291 = t21 * t79;
    let t292 = k * (k * (t240 + (t14 * t253 + t11 * t78)) - t291 - t291);
    let t293 = t286 - (t5 * t292 + t10 * t80);
    let t294 = t268 * t293;
    let t295 = t10 * t21;
    let t296 = t20 * t21;
    let t297 = k * (t296 - (k * (t251 + (t14 * t244 + t11 * t11)) - t296));
    let t298 = t295 - t5 * t297 + (t295 - k * t241);
    let t299 = t109 * t110;
    let t300 = t242 - t107 * (t6 * (t8 * t108));
    let t301 = k * (t299 - (k * (t251 + (t14 * t300 + t108 * t108)) - t299));
    let t302 = t5 * t301 - t282 - t283;
    let t303 = t285 + (t285 - (t290 + (t294 + (t290 + t267 * t298)) - t260 * t302) - t294);
    let t304 = t238 * t278 + t303;
    let t305 = t21 * t76;
    let t306 = t305 - t3 * t292;
    let t307 = 0.8660254037844386_f64 * t306;
    let t308 = t3 * t297;
    let t309 = 0.8660254037844386_f64 * t308;
    let t310 = t7 * t21;
    let t311 = t2 * (t310 - (t4 * t297 - t310));
    let t312 = 0.5_f64 * t311;
    let t313 = t309 + t312;
    let t314 = t75 * t26;
    let t315 = t313 + t314;
    let t316 = 0.5_f64 * t315;
    let t317 = t307 + t316;
    let t318 = t317 + t75 * t81;
    let t319 = t305 + t3 * t288;
    let t320 = 0.8660254037844386_f64 * t319;
    let t321 = t312 - t309;
    let t322 = t321 - t314;
    let t323 = 0.5_f64 * t322;
    let t324 = t320 - t323;
    let t325 = t75 * t111;
    let t326 = t324 + t325;
    let t327 = t257 * t326;
    let t328 = t268 * t315;
    let t329 = t320 + t323;
    let t330 = t325 + t329;
    let t331 = t265 * t322;
    let t332 = t327 + (t328 + (t327 - (t260 * t330 + (t267 * t311 - t331 - t328 - t331))));
    let t333 = t238 * t318 - t332;
    let t334 = t232 * t235 + t236 * t237 - (t16 * t271 - (t19 * t304 + t25 * t333));
    let t335 = t228 * t231 * (Ix - Iy) + Iz * t334;
    let t336 = t76 * t80;
    let t337 = k * (3.0_f64 * t240);
    let t338 = t3 * t277 + t336 + (t336 + t337);
    let t339 = t76 * t110;
    let t340 = t339 - t337;
    let t341 = t3 * t281 - t336 + t340;
    let t342 = t257 * t341;
    let t343 = t268 * t306;
    let t344 = t265 * t319;
    let t345 = t340 - (t3 * t301 - t339);
    let t346 = t342 - (t343 - (t342 + (t344 - (t343 - (t344 + t267 * t308)) - t260 * t345)));
    let t347 = t78 * t154;
    let t348 = t6 * (t347 + (t347 - t16 * t276));
    let t349 = t257 * (t6 * (t78 * t224 + (t16 * t280 + t108 * t154)));
    let t350 = t268 * t254;
    let t351 = t108 * t224;
    let t352 = t6 * (t16 * t300 - t351 - t351);
    let t353 = t265 * t262;
    let t354 = t349 + (t350 + (t349 - (t260 * t352 + (t353 - (t350 + (t267 * t245 - t353))))));
    let t355 = t238 * t348 + t354;
    let t356 = t236 * t232 + t237 * t234 - t237 * t235 + (t12 * t333 - t16 * (t238 * t338 + t346) + t30 * t355);
    let t357 = t19 * t229 - t25 * t225 + t16 * t100;
    let t358 = u_hC * t153 - (u_hB * t357 + u_hA * t33);
    let t359 = Ix * t356 - t358 * t231 * (Iy - Iz);
    let t360 = t15 * t306 - t24 * t156 - (t22 * t150 + t25 * t293) - 2.0_f64 * (t27 * t152 - t19 * t315);
    let t361 = t268 * t360;
    let t362 = 2.0_f64 * (t225 * t152 - t19 * t326) - (t25 * t284 - t226 * t150 - (t15 * t341 + t229 * t156));
    let t363 = t257 * t362;
    let t364 = t226 * t229;
    let t365 = 2.0_f64 * (t19 * t330 - t225 * t225) - (t15 * t345 + t364 + (t364 + t25 * t302));
    let t366 = t24 * t226 - t15 * t319 - (t25 * t289 - t22 * t229) + 2.0_f64 * (t19 * t322 + t27 * t225);
    let t367 = t265 * t366;
    let t368 = t22 * t24;
    let t369 = t368 - t15 * t308 + (t368 - t25 * t298) - 2.0_f64 * (t19 * t311 - t27 * t27);
    let t370 = t361 - (t363 + (t260 * t365 - (t367 + (t361 + (t367 + t267 * t369))))) - t363;
    let t371 = t156 * t150;
    let t372 = t15 * t338 - t371 - (t371 + t25 * t278) + 2.0_f64 * (t19 * t318 - t152 * t152);
    let t373 = t236 * t233 + t237 * t232 - t236 * t235 + (t15 * t271 - t19 * t355 + t12 * (t370 - t238 * t372));
    let t374 = Iy * t373 - (Ix - Iz) * (t358 * t228);
    let t375 = Ic1 - Ic3;
    let t376 = 0.8660254037844386_f64 * t226;
    let t377 = 0.5_f64 * t225;
    let t378 = t376 + t377;
    let t379 = 0.5_f64 * t229;
    let t380 = 0.8660254037844386_f64 * t225;
    let t381 = t379 - t380;
    let t382 = t60 * t378 - t84 * t381;
    let t383 = u_hB * t382 + u_hA * t93 - u_hC * t165;
    let t384 = 2.0_f64 * (dzC * t179);
    let t385 = t64 * t384;
    let t386 = t59 * (t59 * t385);
    let t387 = t53 * t386 + t59 * t381;
    let t388 = t72 * t386 + t59 * t378;
    let t389 = t90 * t387 - t89 * t388;
    let t390 = u_hC * t174 + (u_hB * t389 + u_hA * t91);
    let t391 = t66 * t171;
    let t392 = t59 * (t64 * t170);
    let t393 = t59 * (t65 * t392 + t64 * (2.0_f64 * (dzC * t256 + t56 * t168))) + t391;
    let t394 = t59 * (t391 + t393);
    let t395 = 0.8660254037844386_f64 * t315;
    let t396 = 0.5_f64 * t293;
    let t397 = t395 + t396;
    let t398 = t53 * t394 - t67 * t164 - (t63 * t171 - t59 * t397);
    let t399 = t268 * (dzC * t398 + t56 * t173 + (t60 * t256 - t68 * t168));
    let t400 = 0.8660254037844386_f64 * t322;
    let t401 = 0.5_f64 * t289;
    let t402 = t400 + t401;
    let t403 = t66 * t386;
    let t404 = t59 * (t64 * t385);
    let t405 = t59 * (t65 * t404 + t64 * (2.0_f64 * (dzC * t258 + t56 * t179))) + t403;
    let t406 = t59 * (t403 + t405);
    let t407 = t63 * t386 - t59 * t402 - (t53 * t406 + t67 * t381);
    let t408 = t265 * (t56 * t387 - dzC * t407 + (t60 * t258 - t68 * t179));
    let t409 = t56 * t68;
    let t410 = t67 * t63;
    let t411 = 0.8660254037844386_f64 * t311;
    let t412 = 0.5_f64 * t298;
    let t413 = t411 - t412;
    let t414 = t66 * t67;
    let t415 = t56 * t56;
    let t416 = t59 * (t65 * (t59 * (t64 * t66)) + t64 * (2.0_f64 * (dzC * t249 + t415)));
    let t417 = t59 * (t414 + (t416 + t414));
    let t418 = t410 - t59 * t413 - (t53 * t417 - t410);
    let t419 = t408 + (t399 - (t267 * (t60 * t249 - t409 - (dzC * t418 + t409)) - t408));
    let t420 = t385 * t386;
    let t421 = t179 * t179;
    let t422 = 0.8660254037844386_f64 * t352;
    let t423 = 0.5_f64 * t264;
    let t424 = t422 + t423;
    let t425 = t420 + (t59 * (t64 * (2.0_f64 * (t421 - dzC * t424)) + t384 * t404) + t420);
    let t426 = t59 * t425;
    let t427 = t386 * t381;
    let t428 = 0.8660254037844386_f64 * t330;
    let t429 = 0.5_f64 * t302;
    let t430 = t428 + t429;
    let t431 = t53 * t426 + t427 + (t427 + t59 * t430);
    let t432 = t179 * t387;
    let t433 = t385 * t171;
    let t434 = 0.5_f64 * t256;
    let t435 = 0.8660254037844386_f64 * t348;
    let t436 = t434 - t435;
    let t437 = t59 * (t64 * (2.0_f64 * (dzC * t436 + t179 * t168)) + t169 * t404) + t433;
    let t438 = t59 * (t433 + t437);
    let t439 = 0.8660254037844386_f64 * t326;
    let t440 = 0.5_f64 * t284;
    let t441 = t439 - t440;
    let t442 = t386 * t164 - t53 * t438 - (t381 * t171 - t59 * t441);
    let t443 = t257 * (t387 * t168 - dzC * t442 + (t60 * t436 + t179 * t173));
    let t444 = t399 + (t419 - t260 * (dzC * t431 + t432 - (t60 * t424 - t432)) - t443);
    let t445 = 0.8660254037844386_f64 * t318;
    let t446 = 0.5_f64 * t278;
    let t447 = t445 + t446;
    let t448 = t171 * t164;
    let t449 = t170 * t171;
    let t450 = t435 + t434;
    let t451 = t59 * (t64 * (2.0_f64 * (dzC * t450 + t168 * t168)) + t169 * t392) + t449;
    let t452 = t59 * (t449 + t451);
    let t453 = t59 * t447 - t448 - (t448 - t53 * t452);
    let t454 = t168 * t173;
    let t455 = t53 * (t444 - t443 - t238 * (dzC * t453 + t454 + (t454 + t60 * t450)));
    let t456 = t171 * t161;
    let t457 = 0.8660254037844386_f64 * t338;
    let t458 = 0.5_f64 * t318;
    let t459 = t457 + t458;
    let t460 = t456 - t72 * t452 + (t456 + t59 * t459);
    let t461 = t168 * t172;
    let t462 = t82 * t171 - t72 * t394 + (t67 * t161 + t59 * t317);
    let t463 = t268 * (t83 * t168 - dzC * t462 - (t56 * t172 - t84 * t256));
    let t464 = 0.5_f64 * t326;
    let t465 = 0.8660254037844386_f64 * t341;
    let t466 = t464 - t465;
    let t467 = t72 * t438 - t386 * t161 + (t59 * t466 + t378 * t171);
    let t468 = t257 * (dzC * t467 + t388 * t168 + (t84 * t436 - t179 * t172));
    let t469 = t72 * t406 - t82 * t386 + (t67 * t378 + t59 * t324);
    let t470 = t265 * (dzC * t469 + t83 * t179 + (t84 * t258 + t56 * t388));
    let t471 = t56 * t83;
    let t472 = t67 * t82;
    let t473 = t472 + t59 * t313 - (t72 * t417 - t472);
    let t474 = t470 + (t463 - (t267 * (t471 - dzC * t473 + (t471 + t84 * t249)) - t470));
    let t475 = t386 * t378;
    let t476 = 0.5_f64 * t330;
    let t477 = 0.8660254037844386_f64 * t345;
    let t478 = t476 - t477;
    let t479 = t72 * t426 + t475 + (t475 - t59 * t478);
    let t480 = t179 * t388;
    let t481 = t463 - (t468 - (t474 - t260 * (dzC * t479 + t480 + (t480 - t84 * t424))));
    let t482 = t72 * (t238 * (dzC * t460 + t461 - (t84 * t450 - t461)) + (t481 - t468));
    let t483 = t164 * t173;
    let t484 = t161 * t172;
    let t485 = t53 * t453 - t483 - (t483 - t60 * t447) + (t484 - t72 * t460 + (t484 - t84 * t459));
    let t486 = t72 * t467 - t378 * t172 + (t84 * t466 - t388 * t161) - (t53 * t442 - t381 * t173 + (t387 * t164 + t60 * t441));
    let t487 = t257 * t486;
    let t488 = t63 * t173 - t60 * t397 - (t53 * t398 + t68 * t164) + (t72 * t462 + t83 * t161 + (t84 * t317 - t82 * t172));
    let t489 = t268 * t488;
    let t490 = t72 * t469 - t82 * t388 + (t83 * t378 + t84 * t324) - (t53 * t407 + t63 * t387 + (t68 * t381 - t60 * t402));
    let t491 = t265 * t490;
    let t492 = t82 * t83;
    let t493 = t63 * t68;
    let t494 = t72 * t473 + t492 + (t492 + t84 * t313) - (t493 - t53 * t418 + (t493 + t60 * t413));
    let t495 = t381 * t387;
    let t496 = t378 * t388;
    let t497 = t53 * t431 + t495 + (t495 + t60 * t430) - (t84 * t478 - t496 - (t72 * t479 + t496));
    let t498 = t487 + (t489 - (t491 + (t491 + t267 * t494 - t489) - t260 * t497 - t487));
    let t499 = dzC * t388 + t84 * t179;
    let t500 = u_hC * t176 - (u_hA * t85 - u_hB * t499);
    let t501 = u_hB * t378 + u_hA * t82 - u_hC * t161;
    let t502 = dzC * t387 + t60 * t179;
    let t503 = u_hC * t175 + (u_hB * t502 - u_hA * t69);
    let t504 = u_hC * t164 - (u_hB * t381 + u_hA * t63);
    let t505 = t53 * t387 + t60 * t381 + (t72 * t388 + t84 * t378);
    let t506 = (u_hC * t177 - (u_hB * t505 + u_hA * t86)) * (u_hC * t168 + (u_hB * t179 - u_hA * t56));
    let t507 = t455 + t482 + dzC * (t238 * t485 + t498) - (t500 * t501 - t503 * t504 + t506);
    let t508 = t375 * (t383 * t390) - Ic2 * t507;
    let t509 = dzC * t505 - (t53 * t502 + t72 * t499);
    let t510 = u_hB * t509 + u_hA * t87 - u_hC * t178;
    let t511 = Ic2 - Ic3;
    let t512 = u_hC * t172 - (u_hB * t388 - u_hA * t83);
    let t513 = u_hC * t173 + (u_hB * t387 + u_hA * t68);
    let t514 = t257 * t467;
    let t515 = t268 * t462;
    let t516 = t265 * t469;
    let t517 = t514 + (t515 + (t514 - (t516 - (t515 - (t516 + t267 * t473)) - t260 * t479)));
    let t518 = t257 * t442;
    let t519 = t268 * t398;
    let t520 = t265 * t407;
    let t521 = t518 + (t519 + (t518 - (t260 * t431 + (t520 + (t520 - t267 * t418 - t519)))));
    let t522 = t503 * t512 + t500 * t513 + (t89 * (t238 * t460 - t517) - t90 * (t521 - t238 * t453));
    let t523 = t383 * t510 * t511 + Ic1 * t522;
    let t524 = Ic1 - Ic2;
    let t525 = t257 * t441;
    let t526 = t268 * t397;
    let t527 = t265 * t402;
    let t528 = t525 + (t526 + (t525 + (t527 + (t526 - (t267 * t413 - t527)) - t260 * t430)));
    let t529 = t257 * t466;
    let t530 = t268 * t317;
    let t531 = t265 * t324;
    let t532 = t529 + (t530 + (t529 - (t260 * t478 + (t531 + (t531 + t267 * t313 - t530)))));
    let t533 = t504 * t512 - t501 * t513 + (t84 * (t238 * t447 - t528) + t60 * (t238 * t459 - t532));
    let t534 = t390 * t510 * t524 - Ic3 * t533;
    let g = p.g;
    let t535 = mc * g;
    let t536 = ms * g;
    let t537 = 0.8660254037844386_f64 * t224 + 0.5_f64 * t100;
    let t538 = 2.0_f64 * (t95 * t537);
    let t539 = t99 * t538;
    let t540 = t97 * (t97 * t539);
    let t541 = t376 - t377;
    let t542 = t106 * t540 + t97 * t541;
    let t543 = t380 + t379;
    let t544 = t96 * t540 + t97 * t543;
    let t545 = t120 * t542 - t121 * t544;
    let t546 = u_hC * t191 + (u_hB * t545 + u_hA * t122);
    let t547 = t95 * t544 + t105 * t537;
    let t548 = t95 * t542 + t114 * t537;
    let t549 = t96 * t544 + t105 * t543 + (t106 * t542 + t114 * t541);
    let t550 = t96 * t547 + t106 * t548 - t95 * t549;
    let t551 = u_hB * t550 - u_hA * t118 - u_hC * t190;
    let t552 = u_hB * t543 + u_hA * t98 - u_hC * t183;
    let t553 = u_hC * t187 + (u_hB * t542 + u_hA * t113);
    let t554 = u_hC * t186 + (u_hB * t541 + u_hA * t112);
    let t555 = u_hC * t184 - (u_hB * t544 + u_hA * t104);
    let t556 = t465 + t464;
    let t557 = t257 * t556;
    let t558 = t477 + t476;
    let t559 = t265 * t329;
    let t560 = t307 - t316;
    let t561 = t268 * t560;
    let t562 = t557 + (t557 - (t260 * t558 - (t559 - (t561 + (t267 * t321 - t559)))) - t561);
    let t563 = t458 - t457;
    let t564 = t445 - t446;
    let t565 = t439 + t440;
    let t566 = t257 * t565;
    let t567 = t395 - t396;
    let t568 = t268 * t567;
    let t569 = t429 - t428;
    let t570 = t401 - t400;
    let t571 = t265 * t570;
    let t572 = t411 + t412;
    let t573 = t566 + (t568 + (t566 + (t260 * t569 - (t571 + (t571 + t267 * t572 - t568)))));
    let t574 = t552 * t553 + t554 * t555 + (t105 * (t562 - t238 * t563) - t114 * (t238 * t564 - t573));
    let t575 = t524 * (t546 * t551) - Ic3 * t574;
    let t576 = u_hC * t185 + (u_hA * t117 - u_hB * t547);
    let t577 = u_hC * t188 - (u_hB * t548 + u_hA * t116);
    let t578 = t181 * t182;
    let t579 = t97 * (t99 * t181);
    let t580 = t578 + (t97 * (t99 * (2.0_f64 * (t421 - t95 * t436)) + t180 * t579) + t578);
    let t581 = t97 * t580;
    let t582 = t182 * t183;
    let t583 = t96 * t581 + t582 - (t97 * t564 - t582);
    let t584 = t540 * t181;
    let t585 = t97 * (t538 * t579 - t99 * (2.0_f64 * (t95 * t424 - t179 * t537))) + t584;
    let t586 = t97 * (t584 + t585);
    let t587 = t97 * t565 - t540 * t183 - (t96 * t586 + t543 * t182);
    let t588 = t257 * t587;
    let t589 = t102 * t540;
    let t590 = t97 * (t99 * t102);
    let t591 = t97 * (t538 * t590 + t99 * (2.0_f64 * (t95 * t264 + t100 * t537))) + t589;
    let t592 = t97 * (t589 + t591);
    let t593 = t96 * t592 - t98 * t540 + (t103 * t543 + t97 * t570);
    let t594 = t265 * t593;
    let t595 = t102 * t182;
    let t596 = t97 * (t180 * t590 + t99 * (2.0_f64 * (t95 * t258 + t100 * t179))) + t595;
    let t597 = t97 * (t595 + t596);
    let t598 = t98 * t182 - t96 * t597 - (t103 * t183 + t97 * t567);
    let t599 = t268 * t598;
    let t600 = t103 * t98;
    let t601 = t102 * t103;
    let t602 = t100 * t100;
    let t603 = t601 + (t97 * (t101 * t590 + t99 * (2.0_f64 * (t95 * t263 + t602))) + t601);
    let t604 = t97 * t603;
    let t605 = t600 - t96 * t604 + (t600 + t97 * t572);
    let t606 = t539 * t540;
    let t607 = t423 - t422;
    let t608 = t99 * (2.0_f64 * (t95 * t607 + t537 * t537)) + t538 * (t97 * (t99 * t539));
    let t609 = t97 * (t606 + (t97 * t608 + t606));
    let t610 = t540 * t543;
    let t611 = t96 * t609 + t610 + (t610 + t97 * t569);
    let t612 = t588 + (t588 - (t594 + (t599 + (t594 + t267 * t605)) - t260 * t611) - t599);
    let t613 = t182 * t186;
    let t614 = t97 * t563 - t613 - (t613 - t106 * t581);
    let t615 = t540 * t186 - t97 * t556 - (t106 * t586 + t541 * t182);
    let t616 = t257 * t615;
    let t617 = t106 * t597 - t103 * t186 + (t97 * t560 - t112 * t182);
    let t618 = t268 * t617;
    let t619 = t540 * t541;
    let t620 = t106 * t609 + t619 + (t619 + t97 * t558);
    let t621 = t106 * t592 + t103 * t541 - (t112 * t540 - t97 * t329);
    let t622 = t265 * t621;
    let t623 = t103 * t112;
    let t624 = t106 * t604 - t623 + (t97 * t321 - t623);
    let t625 = t616 + (t618 + (t616 + (t260 * t620 - (t622 - (t618 - (t622 - t267 * t624))))));
    let t626 = t576 * t553 + t577 * t555 + (t121 * (t238 * t583 + t612) - t120 * (t238 * t614 + t625));
    let t627 = t105 * t541 - t114 * t543;
    let t628 = u_hC * t192 + (u_hB * t627 + u_hA * t124);
    let t629 = Ic1 * t626 - t511 * (t628 * t551);
    let t630 = (u_hC * t189 + (u_hB * t549 + u_hA * t115)) * (u_hC * t179 + (u_hA * t100 - u_hB * t537));
    let t631 = t179 * t184;
    let t632 = t257 * (t95 * t587 - t537 * t184 + (t105 * t424 - t179 * t544));
    let t633 = t268 * (t105 * t258 + t100 * t184 - (t95 * t598 + t104 * t179));
    let t634 = t537 * t544;
    let t635 = t265 * (t104 * t537 - t95 * t593 - (t105 * t264 + t100 * t544));
    let t636 = t100 * t104;
    let t637 = t635 - (t267 * (t95 * t605 + t636 + (t636 - t105 * t263)) - t635 - t633);
    let t638 = t633 + (t632 + (t260 * (t95 * t611 + t634 + (t634 + t105 * t607)) + t637));
    let t639 = t96 * (t238 * (t95 * t583 + t631 - (t105 * t436 - t631)) + (t632 + t638));
    let t640 = t179 * t187;
    let t641 = t257 * (t95 * t615 + t537 * t187 - (t179 * t542 - t114 * t424));
    let t642 = t268 * (t114 * t258 - t100 * t187 - (t113 * t179 - t95 * t617));
    let t643 = t537 * t542;
    let t644 = t265 * (t114 * t264 + t100 * t542 - (t113 * t537 - t95 * t621));
    let t645 = t100 * t113;
    let t646 = t644 - (t642 + (t267 * (t95 * t624 - t645 + (t114 * t263 - t645)) - t644));
    let t647 = t642 + (t641 + (t260 * (t95 * t620 + t643 + (t643 + t114 * t607)) - t646));
    let t648 = t106 * (t238 * (t95 * t614 - t640 - (t640 + t114 * t436)) + (t641 + t647));
    let t649 = t183 * t184;
    let t650 = t186 * t187;
    let t651 = t96 * t583 + t649 + (t649 - t105 * t564) + (t106 * t614 + t650 + (t650 + t114 * t563));
    let t652 = t106 * t615 + t542 * t186 + (t541 * t187 - t114 * t556) - (t543 * t184 - t96 * t587 + (t544 * t183 - t105 * t565));
    let t653 = t257 * t652;
    let t654 = t106 * t617 + t112 * t187 + (t113 * t186 + t114 * t560) - (t96 * t598 + t104 * t183 + (t98 * t184 - t105 * t567));
    let t655 = t268 * t654;
    let t656 = t543 * t544;
    let t657 = t541 * t542;
    let t658 = t96 * t611 + t656 + (t656 + t105 * t569) + (t106 * t620 + t657 + (t657 + t114 * t558));
    let t659 = t104 * t543 - t96 * t593 + (t98 * t544 - t105 * t570) - (t106 * t621 - t112 * t542 + (t114 * t329 - t113 * t541));
    let t660 = t265 * t659;
    let t661 = t98 * t104;
    let t662 = t112 * t113;
    let t663 = t661 - t96 * t605 - (t105 * t572 - t661) + (t106 * t624 + t662 + (t662 + t114 * t321));
    let t664 = t653 + (t655 + (t653 + (t260 * t658 + (t660 + (t655 + (t660 + t267 * t663))))));
    let t665 = t576 * t552 + t577 * t554 - t630 - (t639 + t648 - t95 * (t238 * t651 + t664));
    let t666 = t375 * (t628 * t546) + Ic2 * t665;
    let t667 = t132 * t225 - t135 * t229;
    let t668 = u_hA * t144 - u_hB * t667 - u_hC * t203;
    let t669 = 2.0_f64 * (t12 * t100);
    let t670 = t127 * t669;
    let t671 = t126 * (t126 * t670);
    let t672 = t19 * t671 + t126 * t225;
    let t673 = t15 * t671 + t126 * t229;
    let t674 = t140 * t672 - t141 * t673;
    let t675 = u_hB * t674 + u_hA * t142 - u_hC * t198;
    let t676 = t56 * t196;
    let t677 = t194 * t195;
    let t678 = t126 * (t127 * (2.0_f64 * (t415 - t12 * t256)) + t193 * (t126 * (t127 * t194)));
    let t679 = t126 * (t677 + (t678 + t677));
    let t680 = t152 * t195;
    let t681 = t19 * t679 + t680 + (t680 - t126 * t318);
    let t682 = t671 * t194;
    let t683 = t126 * (t127 * t670);
    let t684 = t126 * (t127 * (2.0_f64 * (t12 * t258 + t56 * t100)) + t193 * t683) + t682;
    let t685 = t126 * (t682 + t684);
    let t686 = t19 * t685 + t671 * t152 + (t225 * t195 - t126 * t326);
    let t687 = t257 * (t12 * t686 + t56 * t672 + (t135 * t258 + t100 * t196));
    let t688 = t130 * t194;
    let t689 = t126 * (t127 * t129);
    let t690 = t126 * (t193 * t689 + t127 * (2.0_f64 * (t13 * t56 - t12 * t249))) + t688;
    let t691 = t126 * (t688 + t690);
    let t692 = t19 * t691 + t130 * t152 + (t27 * t195 - t126 * t315);
    let t693 = t268 * (t12 * t692 + t56 * t134 + (t13 * t196 - t135 * t249));
    let t694 = t670 * t671;
    let t695 = t694 + (t126 * (t127 * (2.0_f64 * (t602 + t12 * t264)) + t669 * t683) + t694);
    let t696 = t126 * t695;
    let t697 = t225 * t671;
    let t698 = t19 * t696 + t697 - (t126 * t330 - t697);
    let t699 = t100 * t672;
    let t700 = t130 * t670;
    let t701 = t126 * (t669 * t689 + t127 * (2.0_f64 * (t13 * t100 - t12 * t263))) + t700;
    let t702 = t126 * (t700 + t701);
    let t703 = t19 * t702 + t27 * t671 + (t130 * t225 + t126 * t322);
    let t704 = t265 * (t12 * t703 + t100 * t134 + (t13 * t672 - t135 * t263));
    let t705 = t129 * t130;
    let t706 = t126 * (t127 * (2.0_f64 * (t12 * t247 - t13 * t13)) - t128 * t689) - t705;
    let t707 = t126 * (t705 - t706);
    let t708 = t27 * t130;
    let t709 = t19 * t707 + t708 - (t126 * t311 - t708);
    let t710 = t13 * t134;
    let t711 = t693 - (t704 + t267 * (t12 * t709 + t710 + (t710 - t135 * t247))) - t704;
    let t712 = t693 + (t687 - (t260 * (t12 * t698 + t699 + (t699 + t135 * t264)) - t711));
    let t713 = t19 * (t238 * (t135 * t256 - t676 - (t12 * t681 + t676)) + (t687 + t712));
    let t714 = t150 * t195;
    let t715 = t15 * t679 + t714 + (t714 + t126 * t278);
    let t716 = t56 * t197;
    let t717 = t15 * t685 + t229 * t195 + (t671 * t150 - t126 * t284);
    let t718 = t257 * (t12 * t717 + t56 * t673 + (t132 * t258 + t100 * t197));
    let t719 = t15 * t691 + t130 * t150 + (t126 * t293 + t24 * t195);
    let t720 = t268 * (t12 * t719 + t13 * t197 + (t56 * t131 - t132 * t249));
    let t721 = t15 * t702 + t130 * t229 - (t126 * t289 - t24 * t671);
    let t722 = t265 * (t132 * t263 - t100 * t131 - (t12 * t721 + t13 * t673));
    let t723 = t24 * t130;
    let t724 = t15 * t707 + t723 + (t723 - t126 * t298);
    let t725 = t13 * t131;
    let t726 = t722 + (t720 - (t267 * (t12 * t724 + t725 + (t725 - t132 * t247)) - t722));
    let t727 = t229 * t671;
    let t728 = t15 * t696 + t727 + (t727 + t126 * t302);
    let t729 = t100 * t673;
    let t730 = t720 + (t718 + (t726 - t260 * (t12 * t728 + t729 + (t729 + t132 * t264))));
    let t731 = t15 * (t238 * (t12 * t715 + t716 - (t132 * t256 - t716)) - (t718 + t730));
    let t732 = t150 * t197;
    let t733 = t152 * t196;
    let t734 = t15 * t715 + t732 + (t732 + t132 * t278) + (t19 * t681 + t733 + (t733 - t135 * t318));
    let t735 = t135 * t315 - t134 * t152 - (t19 * t692 + t27 * t196) - (t15 * t719 + t131 * t150 + (t132 * t293 + t24 * t197));
    let t736 = t268 * t735;
    let t737 = t15 * t721 + t24 * t673 - (t132 * t289 - t131 * t229) + (t19 * t703 + t134 * t225 + (t135 * t322 + t27 * t672));
    let t738 = t265 * t737;
    let t739 = t27 * t134;
    let t740 = t24 * t131;
    let t741 = t19 * t709 + t739 - (t135 * t311 - t739) - (t132 * t298 - t740 - (t15 * t724 + t740));
    let t742 = t225 * t672;
    let t743 = t229 * t673;
    let t744 = t135 * t330 - t742 - (t19 * t698 + t742) - (t15 * t728 + t743 + (t743 + t132 * t302));
    let t745 = t15 * t717 + t229 * t197 - (t132 * t284 - t673 * t150) + (t19 * t686 + t672 * t152 + (t225 * t196 - t135 * t326));
    let t746 = t257 * t745;
    let t747 = t736 + (t738 + (t736 + (t738 + t267 * t741)) - t260 * t744 - t746) - t746;
    let t748 = t12 * t672 + t100 * t135;
    let t749 = u_hC * t201 - (u_hB * t748 + u_hA * t136);
    let t750 = t12 * t673 + t100 * t132;
    let t751 = u_hB * t750 + u_hA * t133 - u_hC * t200;
    let t752 = t15 * t673 + t132 * t229 + (t19 * t672 + t135 * t225);
    let t753 = t232 * t749 - t233 * t751 - t236 * (u_hB * t752 + u_hA * t137 - u_hC * t199);
    let t754 = t375 * (t668 * t675) - Ic2 * (t713 - t731 + t12 * (t238 * t734 + t747) - t753);
    let t755 = t15 * t750 + t19 * t748 - t12 * t752;
    let t756 = u_hC * t202 + (u_hB * t755 + u_hA * t138);
    let t757 = u_hC * t196 - (u_hB * t672 + u_hA * t134);
    let t758 = u_hB * t673 + u_hA * t131 - u_hC * t197;
    let t759 = t257 * t717;
    let t760 = t268 * t719;
    let t761 = t265 * t721;
    let t762 = t759 + (t760 - (t260 * t728 + (t761 + (t761 + t267 * t724 - t760)) - t759));
    let t763 = t265 * t703;
    let t764 = t268 * t692;
    let t765 = t257 * t686;
    let t766 = t260 * t698 + (t763 - (t764 - (t763 + t267 * t709))) - t765 - t764 - t765;
    let t767 = t751 * t757 - t749 * t758 + (t141 * (t238 * t715 - t762) - t140 * (t238 * t681 + t766));
    let t768 = t511 * (t668 * t756) + Ic1 * t767;
    let t769 = Ic3 * (t233 * t757 + t232 * t758 + (t135 * t304 + t132 * t333)) - t524 * (t675 * t756);
    let t770 = t192 * t575 - (t191 * t629 - t190 * t666) + (t202 * t754 + t198 * t768 - t203 * t769);
    let t771 = t36 * (t205 + t206 - t38 * t108);
    let t772 = t75 * t214;
    let t773 = k * (t42 * t10);
    let t774 = t210 - (t212 + t211);
    let t775 = t36 * (k * t774 - cos3 * t110 - shift * t108);
    let t776 = t773 - t110 * t213 + (cos3 * t281 - t80 * t774) - (t78 * t775 - shift * t280);
    let t777 = t36 * (t776 + t108 * t214);
    let t778 = t75 * t775;
    let t779 = t36 * (t38 * t280 - t78 * t771 - t108 * t207) - (t772 - t2 * t777 + t778);
    let t780 = t257 * (t35 * t779);
    let t781 = t75 * t39;
    let t782 = k * (t42 * t107);
    let t783 = shift * t253 - t11 * t214 + (t43 * t80 + cos3 * t292 - (t782 - t21 * t213));
    let t784 = t36 * (t783 - t44 * t78);
    let t785 = t75 * t44;
    let t786 = t36 * (t11 * t207 - (t40 * t78 - t38 * t253 - t781)) + (t2 * t784 - t785);
    let t787 = t268 * (t35 * t786);
    let t788 = k * (t42 * t77);
    let t789 = shift * t261 + t11 * t775 + (t21 * t774 - t788 + (t43 * t110 + cos3 * t288));
    let t790 = t36 * (t44 * t108 - t789);
    let t791 = t2 * t790 - t785 - t36 * (t11 * t771 - (t781 + (t40 * t108 - t38 * t261)));
    let t792 = t265 * (t35 * t791);
    let t793 = t11 * t40;
    let t794 = t11 * t44;
    let t795 = t21 * t43;
    let t796 = t36 * (t794 + (t794 - shift * t244 + (t773 - t795 + (cos3 * t297 - t795))));
    let t797 = t792 - t267 * (t35 * (t36 * (t793 - (t38 * t244 - t793)) + t2 * t796));
    let t798 = t108 * t771;
    let t799 = t108 * t775;
    let t800 = t110 * t774;
    let t801 = t36 * (t799 + (shift * t300 + t799 + (t800 + t782 - (cos3 * t301 - t800))));
    let t802 = t36 * (t798 + (t38 * t300 + t798 - t781)) - (t778 - (t2 * t801 - t778));
    let t803 = t78 * t207;
    let t804 = t78 * t214;
    let t805 = t80 * t213;
    let t806 = t36 * (t804 - (shift * t276 - t804 + (t805 + t788 + (t805 - cos3 * t277))));
    let t807 = t36 * (t803 + (t781 + (t38 * t276 + t803))) - (t772 + (t2 * t806 + t772));
    let t808 = t780 + (t787 + (t780 + (t787 - t797 - t792 - t260 * (t35 * t802)))) - t238 * (t35 * t807);
    let t809 = t78 * t216;
    let t810 = t1 * t214;
    let t811 = t36 * (t251 + (t46 * t276 - t809) - t809) - (t810 - (t4 * t806 - t810));
    let t812 = t36 * (t77 - t46 * t108);
    let t813 = t1 * t775;
    let t814 = t36 * (t78 * t812 - (t241 + (t46 * t280 + t108 * t216))) + (t4 * t777 + t813 - t810);
    let t815 = t257 * (t35 * t814);
    let t816 = t1 * t44;
    let t817 = t36 * (t251 + (t11 * t216 - t46 * t253) - t47 * t78) + (t4 * t784 + t816 + t7 * t214);
    let t818 = t268 * (t35 * t817);
    let t819 = t36 * (t11 * t812 - (t251 - (t47 * t108 + t46 * t261))) + (t4 * t790 + t7 * t775 - t816);
    let t820 = t265 * (t35 * t819);
    let t821 = t11 * t47;
    let t822 = t7 * t44;
    let t823 = t36 * (t241 - (t46 * t244 + t821) - t821) + (t822 + (t822 - t4 * t796));
    let t824 = t108 * t812;
    let t825 = t36 * (t824 + (t251 + (t46 * t300 + t824))) + (t813 + (t813 - t4 * t801));
    let t826 = t815 - (t820 + (t820 + t267 * (t35 * t823) - t818) - t260 * (t35 * t825));
    let t827 = t238 * (t35 * t811) + (t815 + (t818 + t826));
    let t828 = t35 * t774;
    let t829 = t257 * (t23 - t80 * t828 + (t49 * t281 - t110 * t219));
    let t830 = k * t107;
    let t831 = t268 * (t830 - t21 * t219 - (cos2 * t80 + t49 * t292));
    let t832 = t110 * t828;
    let t833 = k * t77;
    let t834 = t265 * (t49 * t288 + t21 * t828 - (t833 - cos2 * t110));
    let t835 = t21 * cos2;
    let t836 = t260 * (t832 + t830 + (t832 - t49 * t301)) + (t831 - (t834 + t267 * (t23 - t835 - (t835 - t49 * t297))) - t834);
    let t837 = t80 * t219;
    let t838 = t829 - (t831 - (t829 - t836)) - t238 * (t837 + t833 + (t837 - t49 * t277));
    let t839 = g + t838;
    let t840 = t178 * t508 + t174 * t523 - t165 * t534 - (t535 + (t536 - t770)) - M * (t215 * t808 + t218 * t827 + t220 * t839);
    let forcing_u_hC = FC - u_hC * c - (t153 * t335 - (t158 * t359 - t157 * t374) - t840);
    let t841 = t118 * t666 - t122 * t629 + t124 * t575 - (t536 + t535 + (t142 * t768 - t138 * t754 - t144 * t769));
    let t842 = M * (t45 * t808 + t48 * t827 + t50 * t839) - (t91 * t523 - t87 * t508 + t93 * t534 + t841);
    let FA = inputs[0];
    let t843 = t842 - (t31 * t359 - t28 * t374 + t33 * t335) + (u_hA * c - FA);
    let t844 = Iy * t230;
    let t845 = Ix * t227;
    let t846 = Iz * t357;
    let t847 = t35 * (t771 + (t2 * t775 + t208));
    let t848 = t35 * (t812 - (t4 * t775 + t217));
    let t849 = 0.3333333333333333_f64 + (k * t828 - t49 * t110);
    let t850 = Ic2 * t509;
    let t851 = Ic1 * t389;
    let t852 = Ic3 * t382;
    let t853 = Ic2 * t550;
    let t854 = Ic1 * t545;
    let t855 = Ic3 * t627;
    let t856 = Ic2 * t755;
    let t857 = Ic1 * t674;
    let t858 = Ic3 * t667;
    let t859 = t550 * t853 + t545 * t854 + t627 * t855 + (mc + (mr + (ms + (t755 * t856 + t674 * t857 + t667 * t858))));
    let t860 = M * (t847 * t847 + t848 * t848 + t849 * t849) + (t509 * t850 + t389 * t851 + t382 * t852 + t859);
    let mass_u_hB_u_hB = t230 * t844 + t227 * t845 + t357 * t846 + t860;
    let t861 = t119 * t550 - t123 * t545 - t125 * t627 - (t139 * t755 + t143 * t674 - t145 * t667);
    let t862 = M * (t45 * t847 - t48 * t848 + t50 * t849) - (t861 - (t88 * t509 + t92 * t389 + t94 * t382));
    let mass_u_hA_u_hB = t34 * t357 - (t29 * t230 - t32 * t227) + t862;
    let t863 = t148 * mass_u_hA_u_hB;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t863;
    let t864 = 1.0_f64 / pivot_1;
    let t865 = t857 * t198 - t856 * t202 - t858 * t203 - (t855 * t192 - (t853 * t190 - t854 * t191));
    let t866 = t850 * t178 - t851 * t174 + t852 * t165 + t865 - M * (t849 * t220 - (t848 * t218 - t847 * t215));
    let t867 = t844 * t157 - t845 * t158 + t846 * t153 + t866 - t863 * t222;
    let t868 = t864 * t867;
    let t869 = t535 + (t536 + (t667 * t769 - (t755 * t754 - t674 * t768))) - (t627 * t575 - (t550 * t666 + t545 * t629));
    let t870 = M * (t847 * t808 - t848 * t827 + t849 * t839) + (t869 - (t389 * t523 - t509 * t508 + t382 * t534));
    let FB = inputs[1];
    let t871 = t870 - (t230 * t374 + t227 * t359 + t357 * t335) + (u_hB * c - FB);
    let t872 = t871 - t863 * t843;
    let t873 = t190 * (Ic2 * t190) + t191 * (Ic1 * t191) + t192 * (Ic3 * t192) + (t202 * (Ic2 * t202) + t198 * (Ic1 * t198) + t203 * (Ic3 * t203));
    let t874 = t178 * (Ic2 * t178) + t174 * (Ic1 * t174) + t165 * (Ic3 * t165) + (mc + (mr + (ms + t873)));
    let mass_u_hC_u_hC = t157 * (Iy * t157) + t158 * (Ix * t158) + t153 * (Iz * t153) + (M * (t215 * t215 + t218 * t218 + t220 * t220) + t874);
    let pivot_2 = mass_u_hC_u_hC - t222 * t223 - t867 * t868;
    let t875 = (forcing_u_hC - t223 * t843 - t868 * t872) / pivot_2;
    let t876 = t864 * t872;
    let t877 = t868 * t875;
    let t878 = t223 * t875 - (t148 * t843 - t863 * (t876 - t877));
    let t879 = t877 - t876;
    let t880 = Real::min(Real::min(0.21652832912306028_f64 * Real::abs(mass_u_hA_u_hA), 0.21680787182359307_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t878, t879, t875], t880)
}
///Kinetic and potential energy (J).
///
///916 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn energy(
    _t: S,
    q: &[S; 3usize],
    u: &[S; 3usize],
    _inputs: &[S; 3usize],
    p: &Parameters,
) -> (S, S) {
    let u_hC = u[2];
    let R = p.R;
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let t2 = t1 * (1.7320508075688772_f64 * (hB - hC));
    let hA = q[0];
    let t3 = t1 * (2.0_f64 * (0.5_f64 * hC - (hA - 0.5_f64 * hB)));
    let t4 = t2 * t2;
    let t5 = t3 * t3;
    let root = Real::sqrt(t4 + (1.0_f64 + t5));
    let t6 = 1.0_f64 + root;
    let k = 1.0_f64 / (root * t6);
    let t7 = t3 * k;
    let t8 = t2 * t7;
    let t9 = 1.0_f64 / root;
    let t10 = 1.7320508075688772_f64 * t1;
    let t11 = t2 * t9;
    let t12 = 0.5_f64 * t9;
    let t13 = 2.0_f64 * t1;
    let t14 = t13 * t3;
    let t15 = 2.0_f64 * (t10 * t2);
    let t16 = t14 - t15;
    let t17 = t12 * t16;
    let t18 = t9 * (t10 + t11 * t17);
    let t19 = t5 * k - 1.0_f64;
    let t20 = 2.0_f64 * t14;
    let t21 = t12 * t20;
    let t22 = t9 * (t21 * t11);
    let t23 = 0.8660254037844386_f64 * t22;
    let t24 = t3 * t9;
    let t25 = t9 * (t13 - t21 * t24);
    let t26 = 0.5_f64 * t25;
    let t27 = t23 + t26;
    let t28 = k * t15;
    let t29 = root + t6;
    let t30 = k * (k * (t29 * t17));
    let t31 = t28 + t4 * t30;
    let t32 = 1.0_f64 - t4 * k;
    let t33 = t14 * k;
    let t34 = t33 - t5 * t30;
    let t35 = t1 * k;
    let t36 = t2 * (t35 - t3 * t30);
    let t37 = t10 * t7;
    let t38 = t36 - t37;
    let t39 = t8 * t18 - t19 * t27 + t24 * (t19 * t31 + t32 * t34 + 2.0_f64 * (t8 * t38));
    let Iy = p.Iy;
    let t40 = t19 * t32 + t8 * t8;
    let t41 = t24 * t38 - t11 * t31 + t40 * t18;
    let Ix = p.Ix;
    let t42 = t8 * t34 - t32 * t38 + t11 * t27;
    let Iz = p.Iz;
    let M = p.M;
    let t43 = 0.5_f64 * R;
    let t44 = 1.0_f64 / t6;
    let t45 = t13 * t2;
    let t46 = 2.0_f64 * t3;
    let t47 = t10 * t46;
    let t48 = t2 * t46 * t44;
    let t49 = 3.0_f64 * t3;
    let cos3 = t3 * t5 - t4 * t49;
    let shift = t44 * (k * cos3);
    let t50 = t10 * shift;
    let t51 = 3.0_f64 * t1;
    let t52 = t51 * t5;
    let t53 = t49 * t15;
    let t54 = t51 * t4;
    let t55 = t52 + (t53 - t54);
    let t56 = t44 * (shift * t17 + (cos3 * t30 - k * t55));
    let t57 = t43 * (t44 * (t45 - t47 - t48 * t17) - (t50 + t2 * t56));
    let cos2 = t5 - t4;
    let t58 = t44 * cos2;
    let t59 = t14 + t15;
    let t60 = t1 * shift;
    let t61 = t43 * (t44 * (t58 * t17 - t59) + (t60 - t3 * t56));
    let t62 = t43 * cos3;
    let t63 = 0.3333333333333333_f64 + (k * (t43 * t55) - t62 * t30);
    let t64 = 0.5_f64 * t19;
    let t65 = 0.8660254037844386_f64 * t8;
    let t66 = t64 - t65;
    let t67 = 0.8660254037844386_f64 * t11;
    let t68 = 0.5_f64 * t24;
    let dzC = t67 - t68;
    let t69 = 1.0_f64 / Real::sqrt(1.0_f64 - dzC * dzC);
    let t70 = 0.5_f64 * t69;
    let t71 = 0.8660254037844386_f64 * t18;
    let t72 = 0.5_f64 * t27;
    let t73 = t71 + t72;
    let t74 = t69 * (t69 * (t70 * (2.0_f64 * (dzC * t73))));
    let t75 = 0.5_f64 * t34;
    let t76 = 0.8660254037844386_f64 * t38;
    let t77 = t75 - t76;
    let t78 = t66 * t74 - t69 * t77;
    let t79 = t69 * t66;
    let t80 = 0.8660254037844386_f64 * t32;
    let t81 = 0.5_f64 * t8;
    let t82 = t80 + t81;
    let t83 = t69 * t82;
    let t84 = 0.8660254037844386_f64 * t31;
    let t85 = 0.5_f64 * t38;
    let t86 = t84 + t85;
    let t87 = t69 * t86 - t82 * t74;
    let t88 = t66 * (dzC * t78 + t79 * t73) + t82 * (t83 * t73 - dzC * t87);
    let t89 = t88 + dzC * (t79 * t77 - t66 * t78 + (t82 * t87 + t83 * t86));
    let Ic2 = p.Ic2;
    let t90 = dzC * t79;
    let t91 = dzC * t83;
    let t92 = t90 * t87 + t91 * t78;
    let Ic1 = p.Ic1;
    let t93 = t79 * t86 - t83 * t77;
    let Ic3 = p.Ic3;
    let mc = p.mc;
    let mr = p.mr;
    let ms = p.ms;
    let t94 = t65 + t64;
    let t95 = t67 + t68;
    let t96 = 1.0_f64 / Real::sqrt(1.0_f64 - t95 * t95);
    let t97 = 0.5_f64 * t96;
    let t98 = t72 - t71;
    let t99 = t96 * (t96 * (t97 * (2.0_f64 * (t95 * t98))));
    let t100 = t76 + t75;
    let t101 = t94 * t99 + t96 * t100;
    let t102 = t96 * t94;
    let t103 = t80 - t81;
    let t104 = t96 * t103;
    let t105 = t85 - t84;
    let t106 = t96 * t105 - t103 * t99;
    let t107 = t94 * (t95 * t101 + t102 * t98) + t103 * (t104 * t98 - t95 * t106);
    let t108 = t107 + t95 * (t103 * t106 + t104 * t105 - (t94 * t101 + t102 * t100));
    let t109 = t95 * t102;
    let t110 = t95 * t104;
    let t111 = t109 * t106 + t110 * t101;
    let t112 = t104 * t100 + t102 * t105;
    let t113 = 1.0_f64 / Real::sqrt(1.0_f64 - t24 * t24);
    let t114 = 0.5_f64 * t113;
    let t115 = t113 * (t113 * (t114 * (2.0_f64 * (t24 * t27))));
    let t116 = t19 * t115 + t113 * t34;
    let t117 = t19 * t113;
    let t118 = t8 * t115 + t113 * t38;
    let t119 = t8 * t113;
    let t120 = t19 * (t24 * t116 + t27 * t117) + t8 * (t24 * t118 + t27 * t119);
    let t121 = t24 * (t19 * t116 + t117 * t34 + (t8 * t118 + t119 * t38)) - t120;
    let t122 = t24 * t117;
    let t123 = t24 * t119;
    let t124 = t122 * t118 - t123 * t116;
    let t125 = t119 * t34 - t117 * t38;
    let t126 = t108 * (Ic2 * t108) + t111 * (Ic1 * t111) + t112 * (Ic3 * t112) + (t121 * (Ic2 * t121) + t124 * (Ic1 * t124) + t125 * (Ic3 * t125));
    let t127 = t89 * (Ic2 * t89) + t92 * (Ic1 * t92) + t93 * (Ic3 * t93) + (mc + (mr + (ms + t126)));
    let mass_u_hC_u_hC = t39 * (Iy * t39) + t41 * (Ix * t41) + t42 * (Iz * t42) + (M * (t57 * t57 + t61 * t61 + t63 * t63) + t127);
    let u_hB = u[1];
    let t128 = t12 * t59;
    let t129 = k * (k * (t29 * t128));
    let t130 = t28 - t4 * t129;
    let t131 = t5 * t129 - t33;
    let t132 = t2 * (t3 * t129 - t35);
    let t133 = t132 - t37;
    let t134 = t23 - t26;
    let t135 = t9 * (t11 * t128 - t10);
    let t136 = t24 * (t19 * t130 + t32 * t131 + 2.0_f64 * (t8 * t133)) - (t19 * t134 + t8 * t135);
    let t137 = Iy * t136;
    let t138 = t40 * t135 - (t24 * t133 - t11 * t130);
    let t139 = Ix * t138;
    let t140 = t8 * t131 - t32 * t133 + t11 * t134;
    let t141 = Iz * t140;
    let t142 = t69 * (t69 * (t70 * (2.0_f64 * (dzC * t98))));
    let t143 = 0.5_f64 * t131;
    let t144 = 0.8660254037844386_f64 * t133;
    let t145 = t143 - t144;
    let t146 = t66 * t142 + t69 * t145;
    let t147 = 0.8660254037844386_f64 * t130;
    let t148 = 0.5_f64 * t133;
    let t149 = t147 + t148;
    let t150 = t82 * t142 + t69 * t149;
    let t151 = t66 * (dzC * t146 + t79 * t98) + t82 * (dzC * t150 + t83 * t98);
    let t152 = dzC * (t66 * t146 + t79 * t145 + (t82 * t150 + t83 * t149)) - t151;
    let t153 = Ic2 * t152;
    let t154 = t91 * t146 - t90 * t150;
    let t155 = Ic1 * t154;
    let t156 = t79 * t149 - t83 * t145;
    let t157 = Ic3 * t156;
    let t158 = t113 * (t113 * (t114 * (2.0_f64 * (t24 * t134))));
    let t159 = t8 * t158 + t113 * t133;
    let t160 = t19 * t158 + t113 * t131;
    let t161 = t122 * t159 - t123 * t160;
    let t162 = Ic1 * t161;
    let t163 = t19 * (t24 * t160 + t134 * t117) + t8 * (t24 * t159 + t134 * t119);
    let t164 = t163 - t24 * (t19 * t160 + t117 * t131 + (t8 * t159 + t119 * t133));
    let t165 = Ic2 * t164;
    let t166 = t117 * t133 - t119 * t131;
    let t167 = Ic3 * t166;
    let t168 = t147 - t148;
    let t169 = t144 + t143;
    let t170 = t102 * t168 - t104 * t169;
    let t171 = Ic3 * t170;
    let t172 = 0.8660254037844386_f64 * t135 + 0.5_f64 * t134;
    let t173 = t96 * (t96 * (t97 * (2.0_f64 * (t95 * t172))));
    let t174 = t94 * t173 + t96 * t169;
    let t175 = t103 * t173 + t96 * t168;
    let t176 = t94 * (t95 * t174 + t102 * t172) + t103 * (t95 * t175 + t104 * t172);
    let t177 = t176 - t95 * (t94 * t174 + t102 * t169 + (t103 * t175 + t104 * t168));
    let t178 = Ic2 * t177;
    let t179 = t109 * t175 - t110 * t174;
    let t180 = Ic1 * t179;
    let t181 = t162 * t124 - t165 * t121 - t167 * t125 - (t171 * t112 - (t178 * t108 - t180 * t111));
    let t182 = t52 - (t54 + t53);
    let t183 = 0.3333333333333333_f64 + (k * (t43 * t182) - t62 * t129);
    let t184 = t44 * (k * t182 - cos3 * t129 - shift * t128);
    let t185 = t43 * (t44 * (t16 - t58 * t128) - (t3 * t184 + t60));
    let t186 = t43 * (t44 * (t45 + t47 - t48 * t128) + (t2 * t184 + t50));
    let t187 = t153 * t89 - t155 * t92 + t157 * t93 + t181 - M * (t183 * t63 - (t185 * t61 - t186 * t57));
    let t188 = t177 * t178 + t179 * t180 + t170 * t171 + (mc + (mr + (ms + (t164 * t165 + t161 * t162 + t166 * t167))));
    let t189 = M * (t186 * t186 + t185 * t185 + t183 * t183) + (t152 * t153 + t154 * t155 + t156 * t157 + t188);
    let mass_u_hB_u_hB = t136 * t137 + t138 * t139 + t140 * t141 + t189;
    let u_hA = u[0];
    let t190 = k * (k * (t14 + t21 * t6));
    let t191 = t20 * k - t5 * t190;
    let t192 = t2 * (t13 * k - t3 * t190);
    let t193 = t8 * t191 - t32 * t192 + t25 * t11;
    let t194 = Iz * t193;
    let t195 = t4 * t190;
    let t196 = t25 * t19 - t22 * t8 - t24 * (t19 * t195 + t191 * t32 + 2.0_f64 * (t8 * t192));
    let t197 = Iy * t196;
    let t198 = t11 * t195 - t24 * t192 - t22 * t40;
    let t199 = Ix * t198;
    let t200 = t21 * shift + (t190 * cos3 - k * (t3 * (3.0_f64 * t14) - 6.0_f64 * t1 * t4));
    let t201 = t44 * t200;
    let t202 = t43 * (t44 * (t21 * t48 - 4.0_f64 * t1 * t2) + t2 * t201);
    let t203 = t43 * (t44 * (t20 - t21 * t58) + (t3 * t201 - t13 * shift));
    let t204 = 0.3333333333333333_f64 + (t190 * t62 - k * cos2);
    let t205 = 0.8660254037844386_f64 * t192;
    let t206 = 0.5_f64 * t191;
    let t207 = t205 + t206;
    let t208 = t96 * (t96 * (t97 * (2.0_f64 * (t95 * t134))));
    let t209 = t96 * t207 - t208 * t94;
    let t210 = t96 * t132 - t208 * t103;
    let t211 = t103 * (t95 * t210 - t134 * t104) - t94 * (t134 * t102 - t95 * t209);
    let t212 = t95 * (t94 * t209 + t207 * t102 + (t103 * t210 + t132 * t104)) - t211;
    let t213 = Ic2 * t212;
    let t214 = t210 * t109 - t209 * t110;
    let t215 = Ic1 * t214;
    let t216 = t102 * t132 - t207 * t104;
    let t217 = Ic3 * t216;
    let t218 = t113 * (t113 * (t114 * (2.0_f64 * (t24 * t25))));
    let t219 = t19 * t218 + t191 * t113;
    let t220 = t8 * t218 + t192 * t113;
    let t221 = t19 * (t24 * t219 + t25 * t117) + t8 * (t24 * t220 + t25 * t119);
    let t222 = t221 - t24 * (t19 * t219 + t191 * t117 + (t8 * t220 + t192 * t119));
    let t223 = Ic2 * t222;
    let t224 = t220 * t122 - t219 * t123;
    let t225 = Ic1 * t224;
    let t226 = t191 * t119 - t192 * t117;
    let t227 = Ic3 * t226;
    let t228 = t213 * t177 - t215 * t179 - t217 * t170 - (t223 * t164 + t225 * t161 - t227 * t166);
    let t229 = t206 - t205;
    let t230 = t69 * (t69 * (t70 * (2.0_f64 * (dzC * t27))));
    let t231 = t69 * t229 - t230 * t66;
    let t232 = t230 * t82 - t69 * t36;
    let t233 = t66 * (t27 * t79 - dzC * t231) + t82 * (dzC * t232 + t27 * t83);
    let t234 = t233 + dzC * (t66 * t231 + t229 * t79 - (t82 * t232 - t36 * t83));
    let t235 = Ic2 * t234;
    let t236 = t232 * t90 + t231 * t91;
    let t237 = Ic1 * t236;
    let t238 = t79 * t36 - t229 * t83;
    let t239 = Ic3 * t238;
    let t240 = M * (t202 * t186 - t203 * t185 + t204 * t183) - (t228 - (t235 * t152 + t237 * t154 + t239 * t156));
    let mass_u_hA_u_hB = t194 * t140 - (t197 * t136 - t199 * t138) + t240;
    let t241 = t212 * t213 + t214 * t215 + t216 * t217 + (mc + (ms + mr) + (t222 * t223 + t224 * t225 + t226 * t227));
    let t242 = M * (t202 * t202 + t203 * t203 + t204 * t204) + (t234 * t235 + t236 * t237 + t238 * t239 + t241);
    let mass_u_hA_u_hA = t196 * t197 + t198 * t199 + t193 * t194 + t242;
    let t243 = t213 * t108 + t215 * t111 + t217 * t112 - (t225 * t124 - t223 * t121 + t227 * t125);
    let t244 = t239 * t93 - (t237 * t92 - t235 * t89) - t243 - M * (t202 * t57 + t203 * t61 + t204 * t63);
    let t245 = u_hA * u_hB * mass_u_hA_u_hB + 0.5_f64 * (u_hA * u_hA * mass_u_hA_u_hA) - u_hA * u_hC * (t194 * t42 - (t197 * t39 + t199 * t41) + t244);
    let t246 = u_hB * u_hC * (t137 * t39 - t139 * t41 + t141 * t42 + t187) - (0.5_f64 * (u_hB * u_hB * mass_u_hB_u_hB) + t245);
    let t247 = 0.5_f64 * (u_hC * u_hC * mass_u_hC_u_hC) - t246;
    let g = p.g;
    let heave = 0.3333333333333333_f64 * (hC + (hA + hB));
    let rise = k * t62;
    let t248 = hC * g;
    let t249 = hB * g;
    let t250 = ms * t248 + (mc * t249 + (ms * t249 + hA * g * (ms + mc)));
    let t251 = M * (g * (heave + rise)) + (mc * t248 + t250);
    (t247, t251)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///0 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn speeds(
    _t: S,
    _q: &[S; 3usize],
    u: &[S; 3usize],
    _inputs: &[S; 3usize],
    _p: &Parameters,
) -> [S; 3usize] {
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    [u_hA, u_hB, u_hC]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///99 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn outputs(
    _t: S,
    q: &[S; 3usize],
    _u: &[S; 3usize],
    _inputs: &[S; 3usize],
    p: &Parameters,
) -> [S; 12usize] {
    let R = p.R;
    let t1 = 0.5_f64 * R;
    let t2 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let t3 = t2 * (1.7320508075688772_f64 * (hB - hC));
    let hA = q[0];
    let t4 = t2 * (2.0_f64 * (0.5_f64 * hC - (hA - 0.5_f64 * hB)));
    let t5 = t3 * (2.0_f64 * t4);
    let t6 = t3 * t3;
    let t7 = t4 * t4;
    let root = Real::sqrt(t6 + (1.0_f64 + t7));
    let t8 = 1.0_f64 + root;
    let t9 = 1.0_f64 / t8;
    let k = 1.0_f64 / (root * t8);
    let cos3 = t4 * t7 - t6 * (3.0_f64 * t4);
    let shift = t9 * (k * cos3);
    let t10 = t1 * (t5 * t9 + t3 * shift);
    let cos2 = t7 - t6;
    let shift_x = t1 * (t4 * shift - t9 * cos2);
    let heave = 0.3333333333333333_f64 * (hC + (hA + hB));
    let rise = k * (t1 * cos3);
    let t11 = heave + rise;
    let t12 = t3 * (t4 * k);
    let t13 = t7 * k;
    let t14 = Real::atan2(t12, 1.0_f64 - t13);
    let t15 = 1.0_f64 / root;
    let t16 = t4 * t15;
    let t17 = Real::asin(t16);
    let sA = R * (1.0_f64 + t9 * (cos2 + 0.5_f64 * (t6 + t7)));
    let t18 = 0.8660254037844386_f64 * t12;
    let t19 = 0.5_f64 * (t13 - 1.0_f64);
    let t20 = t18 + t19;
    let t21 = 0.8660254037844386_f64 * (1.0_f64 - t6 * k);
    let t22 = 0.5_f64 * t12;
    let t23 = t21 - t22;
    let t24 = Real::atan2(-(0.8660254037844386_f64 * t20 + 0.5_f64 * t23), 0.8660254037844386_f64 * t23 - 0.5_f64 * t20);
    let t25 = 0.8660254037844386_f64 * (t3 * t15);
    let t26 = 0.5_f64 * t16;
    let t27 = 0.8660254037844386_f64 * t5;
    let sB = R * (1.0_f64 + t9 * (t6 + t27));
    let t28 = t19 - t18;
    let t29 = t21 + t22;
    let t30 = Real::atan2(0.8660254037844386_f64 * t28 + 0.5_f64 * t29, 0.8660254037844386_f64 * t29 - 0.5_f64 * t28);
    let dzC = t25 - t26;
    let t31 = Real::asin(dzC);
    let sC = R * (1.0_f64 + t9 * (t6 - t27));
    [t10, shift_x, t11, t14, t17, sA, t24, -Real::asin(t25 + t26), sB, t30, t31, sC]
}
///Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them.
///
///0 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn projection(
    _t: S,
    _q: &[S; 3usize],
    _u: &[S; 3usize],
    _inputs: &[S; 3usize],
    _p: &Parameters,
) -> ([S; 0usize], S) {
    ([], 0.0_f64)
}
///Three-legged tile in minimal coordinates: three heights, everything else in closed form.
#[derive(Clone, Copy, Debug, Default)]
pub struct TileMinimal {
    /// Tunable parameters.
    pub parameters: Parameters,
}
impl TileMinimal {
    /// The parameter at a position of `PARAMETER_NAMES`, to read or set.
    pub fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
        Some(
            match index {
                0usize => &mut self.parameters.R,
                1usize => &mut self.parameters.ms,
                2usize => &mut self.parameters.mr,
                3usize => &mut self.parameters.mc,
                4usize => &mut self.parameters.Ic1,
                5usize => &mut self.parameters.Ic2,
                6usize => &mut self.parameters.Ic3,
                7usize => &mut self.parameters.M,
                8usize => &mut self.parameters.Ix,
                9usize => &mut self.parameters.Iy,
                10usize => &mut self.parameters.Iz,
                11usize => &mut self.parameters.c,
                12usize => &mut self.parameters.g,
                _ => return None,
            },
        )
    }
}
impl smartbed_runtime::mechanism::Mechanism<S> for TileMinimal {
    fn n_q(&self) -> usize {
        NQ
    }
    fn n_u(&self) -> usize {
        NU
    }
    fn n_inputs(&self) -> usize {
        N_INPUTS
    }
    fn is_angle(&self, index: usize) -> bool {
        IS_ANGLE.get(index).copied().unwrap_or(false)
    }
    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        inputs: &[S],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, smartbed_runtime::mechanism::Fault> {
        let (Ok(q), Ok(u), Ok(inputs), Ok(q_out), Ok(u_out)) = (
            <&[S; NQ]>::try_from(q),
            <&[S; NU]>::try_from(u),
            <&[S; N_INPUTS]>::try_from(inputs),
            <&mut [S; NQ]>::try_from(q_dot),
            <&mut [S; NU]>::try_from(u_dot),
        ) else {
            return Err(smartbed_runtime::mechanism::Fault::Shape);
        };
        let pivot;
        (*q_out, *u_out, pivot) = rates(t, q, u, inputs, &self.parameters);
        Ok(pivot)
    }
    #[allow(
        clippy::assign_op_pattern,
        reason = "scalars need not have assigning operators"
    )]
    fn project(&mut self, q: &mut [S]) -> Result<S, smartbed_runtime::mechanism::Fault> {
        let Ok(q) = <&mut [S; NQ]>::try_from(q) else {
            return Err(smartbed_runtime::mechanism::Fault::Shape);
        };
        let (correction, residual) = projection(
            <S as Real>::ZERO,
            q,
            &[<S as Real>::ZERO; NU],
            &[<S as Real>::ZERO; N_INPUTS],
            &self.parameters,
        );
        for (&index, &change) in CORRECTED.iter().zip(&correction) {
            if let Some(coordinate) = q.get_mut(index) {
                *coordinate = *coordinate + change;
            }
        }
        Ok(residual)
    }
    fn energy(
        &mut self,
        q: &[S],
        u: &[S],
    ) -> Result<(S, S), smartbed_runtime::mechanism::Fault> {
        let (Ok(q), Ok(u)) = (<&[S; NQ]>::try_from(q), <&[S; NU]>::try_from(u)) else {
            return Err(smartbed_runtime::mechanism::Fault::Shape);
        };
        Ok(
            energy(
                <S as Real>::ZERO,
                q,
                u,
                &[<S as Real>::ZERO; N_INPUTS],
                &self.parameters,
            ),
        )
    }
}
