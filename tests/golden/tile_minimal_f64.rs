// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 3; the worst over 73 sampled configurations is 0.773 of its nominal size.
// Cost of rates: 3227 operations (3 abs, 695 add, 10 div, 2 min, 1944 mul, 4 sqrt, 569 sub).
// Cost of energy: 908 operations (187 add, 7 div, 582 mul, 4 sqrt, 128 sub).
// Cost of speeds: 0 operations ().
// Cost of outputs: 98 operations (19 add, 3 asin, 3 atan2, 4 div, 54 mul, 1 sqrt, 14 sub).
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
///3227 operations.
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
    let t4 = t1 * (2.0_f64 * (0.5_f64 * (hB + hC) - hA));
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
    let t150 = t5 * t110 - t149;
    let t151 = t75 * t18;
    let t152 = t112 - t151;
    let t153 = t19 * t150 - t25 * t152 + t16 * t100;
    let t154 = k * t76;
    let t155 = t154 - t3 * t110;
    let t156 = t6 * (t16 * t108 - t75);
    let t157 = t12 * (t15 * t155 + t25 * t150 + 2.0_f64 * (t19 * t152)) - (t15 * t100 + t19 * t156);
    let t158 = t30 * t156 - (t12 * t152 - t16 * t155);
    let t159 = t7 * t2;
    let t160 = t75 * t37;
    let t161 = t36 * (t159 + t160 - t38 * t108);
    let t162 = 3.0_f64 * t1;
    let t163 = t162 * cos2;
    let t164 = t41 * t76;
    let t165 = t163 - t164;
    let t166 = t36 * (k * t165 - cos3 * t110 - shift * t108);
    let t167 = t75 * shift;
    let t168 = t35 * (t161 + (t2 * t166 + t167));
    let t169 = t36 * (t77 - t46 * t108);
    let t170 = t1 * shift;
    let t171 = t35 * (t169 - (t4 * t166 + t170));
    let t172 = t35 * t165;
    let t173 = 0.3333333333333333_f64 + (k * t172 - t49 * t110);
    let t174 = 0.8660254037844386_f64 * t156;
    let t175 = 0.5_f64 * t100;
    let t176 = t174 + t175;
    let t177 = 2.0_f64 * (t95 * t176);
    let t178 = t99 * t177;
    let t179 = t97 * (t97 * t178);
    let t180 = 0.8660254037844386_f64 * t152;
    let t181 = 0.5_f64 * t150;
    let t182 = t180 + t181;
    let t183 = t96 * t179 + t97 * t182;
    let t184 = t95 * t183 + t105 * t176;
    let t185 = 0.8660254037844386_f64 * t155;
    let t186 = 0.5_f64 * t152;
    let t187 = t185 - t186;
    let t188 = t106 * t179 + t97 * t187;
    let t189 = t95 * t188 + t114 * t176;
    let t190 = t96 * t183 + t105 * t182 + (t106 * t188 + t114 * t187);
    let t191 = t96 * t184 + t106 * t189 - t95 * t190;
    let t192 = t120 * t188 - t121 * t183;
    let t193 = t105 * t187 - t114 * t182;
    let t194 = 2.0_f64 * (t12 * t100);
    let t195 = t127 * t194;
    let t196 = t126 * (t126 * t195);
    let t197 = t15 * t196 + t126 * t150;
    let t198 = t12 * t197 + t100 * t132;
    let t199 = t19 * t196 + t126 * t152;
    let t200 = t12 * t199 + t100 * t135;
    let t201 = t15 * t197 + t132 * t150 + (t19 * t199 + t135 * t152);
    let t202 = t15 * t198 + t19 * t200 - t12 * t201;
    let t203 = t140 * t199 - t141 * t197;
    let t204 = t132 * t152 - t135 * t150;
    let t205 = t119 * t191 - t123 * t192 - t125 * t193 - (t139 * t202 + t143 * t203 - t145 * t204);
    let t206 = t174 - t175;
    let t207 = 2.0_f64 * (dzC * t206);
    let t208 = t64 * t207;
    let t209 = t59 * (t59 * t208);
    let t210 = t181 - t180;
    let t211 = t53 * t209 + t59 * t210;
    let t212 = t185 + t186;
    let t213 = t72 * t209 + t59 * t212;
    let t214 = t53 * t211 + t60 * t210 + (t72 * t213 + t84 * t212);
    let t215 = dzC * t211 + t60 * t206;
    let t216 = dzC * t213 + t84 * t206;
    let t217 = dzC * t214 - (t53 * t215 + t72 * t216);
    let t218 = t90 * t211 - t89 * t213;
    let t219 = t60 * t212 - t84 * t210;
    let t220 = M * (t45 * t168 - t48 * t171 + t50 * t173) - (t205 - (t88 * t217 + t92 * t218 + t94 * t219));
    let mass_u_hA_u_hB = t34 * t153 - (t29 * t157 - t32 * t158) + t220;
    let t221 = t148 * mass_u_hA_u_hB;
    let t222 = Iy * t157;
    let t223 = Ix * t158;
    let t224 = Iz * t153;
    let t225 = Ic2 * t217;
    let t226 = Ic1 * t218;
    let t227 = Ic3 * t219;
    let t228 = Ic2 * t191;
    let t229 = Ic1 * t192;
    let t230 = Ic3 * t193;
    let t231 = Ic2 * t202;
    let t232 = Ic1 * t203;
    let t233 = Ic3 * t204;
    let t234 = t191 * t228 + t192 * t229 + t193 * t230 + (mc + (mr + (ms + (t202 * t231 + t203 * t232 + t204 * t233))));
    let t235 = M * (t168 * t168 + t171 * t171 + t173 * t173) + (t217 * t225 + t218 * t226 + t219 * t227 + t234);
    let mass_u_hB_u_hB = t157 * t222 + t158 * t223 + t153 * t224 + t235;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t221;
    let t236 = 1.0_f64 / pivot_1;
    let t237 = t6 * (t75 + t16 * t78);
    let t238 = t154 + t3 * t80;
    let t239 = t149 - t5 * t80;
    let t240 = t82 - t151;
    let t241 = t19 * t237 - t15 * t56 + t12 * (t15 * t238 + t25 * t239 + 2.0_f64 * (t19 * t240));
    let t242 = t12 * t240 - t16 * t238 + t30 * t237;
    let t243 = t19 * t239 - t25 * t240 + t16 * t56;
    let t244 = 0.8660254037844386_f64 * t237 + 0.5_f64 * t56;
    let t245 = 2.0_f64 * (dzC * t244);
    let t246 = t64 * t245;
    let t247 = t59 * (t59 * t246);
    let t248 = 0.5_f64 * t239;
    let t249 = 0.8660254037844386_f64 * t240;
    let t250 = t248 - t249;
    let t251 = t53 * t247 - t59 * t250;
    let t252 = dzC * t251 + t60 * t244;
    let t253 = 0.8660254037844386_f64 * t238;
    let t254 = 0.5_f64 * t240;
    let t255 = t253 + t254;
    let t256 = t59 * t255 - t72 * t247;
    let t257 = t84 * t244 - dzC * t256;
    let t258 = t60 * t250 - t53 * t251 + (t72 * t256 + t84 * t255);
    let t259 = t53 * t252 + t72 * t257 + dzC * t258;
    let t260 = t89 * t256 + t90 * t251;
    let t261 = t60 * t255 - t84 * t250;
    let t262 = 2.0_f64 * (t12 * t56);
    let t263 = t127 * t262;
    let t264 = t126 * (t126 * t263);
    let t265 = t19 * t264 + t126 * t240;
    let t266 = t15 * t264 + t126 * t239;
    let t267 = t140 * t265 - t141 * t266;
    let t268 = t15 * t266 + t132 * t239 + (t19 * t265 + t135 * t240);
    let t269 = t12 * t266 + t56 * t132;
    let t270 = t12 * t265 + t56 * t135;
    let t271 = t12 * t268 - (t15 * t269 + t19 * t270);
    let t272 = t135 * t239 - t132 * t240;
    let t273 = t249 + t248;
    let t274 = t254 - t253;
    let t275 = t114 * t273 + t105 * t274;
    let t276 = 2.0_f64 * (t95 * t206);
    let t277 = t99 * t276;
    let t278 = t97 * (t97 * t277);
    let t279 = t96 * t278 + t97 * t273;
    let t280 = t95 * t279 + t105 * t206;
    let t281 = t97 * t274 - t106 * t278;
    let t282 = t114 * t206 - t95 * t281;
    let t283 = t106 * t281 + t114 * t274 - (t96 * t279 + t105 * t273);
    let t284 = t96 * t280 + t106 * t282 + t95 * t283;
    let t285 = t120 * t281 + t121 * t279;
    let t286 = t232 * t267 - t231 * t271 - t233 * t272 - (t230 * t275 - (t228 * t284 - t229 * t285));
    let t287 = t163 + t164;
    let t288 = t35 * t287;
    let t289 = 0.3333333333333333_f64 + (k * t288 - t49 * t80);
    let t290 = t36 * (t46 * t78 - t107);
    let t291 = t36 * (shift * t78 + (cos3 * t80 - k * t287));
    let t292 = t35 * (t290 + (t170 - t4 * t291));
    let t293 = t36 * (t159 - t160 - t38 * t78);
    let t294 = t35 * (t293 - (t167 + t2 * t291));
    let t295 = t225 * t259 - t226 * t260 + t227 * t261 + t286 - M * (t173 * t289 - (t171 * t292 - t168 * t294));
    let t296 = t119 * t284 + t123 * t285 + t125 * t275 - (t143 * t267 - t139 * t271 + t145 * t272);
    let t297 = t94 * t261 - (t92 * t260 - t88 * t259) - t296 - M * (t45 * t294 + t48 * t292 + t50 * t289);
    let t298 = t34 * t243 - (t29 * t241 + t32 * t242) + t297;
    let t299 = t222 * t241 - t223 * t242 + t224 * t243 + t295 - t221 * t298;
    let t300 = t236 * t299;
    let g = p.g;
    let t301 = g * (ms + mc);
    let t302 = u_hA * u_hC;
    let t303 = t7 * t7;
    let t304 = t303 * t8;
    let t305 = t6 * (t8 * t11);
    let t306 = t304 - t77 * t305;
    let t307 = t75 * t39;
    let t308 = t1 * t7;
    let t309 = 2.0_f64 * t80;
    let t310 = k * (k * (t308 + (t14 * t306 + t11 * t78)) - t20 * t309);
    let t311 = t42 * t76;
    let t312 = t162 * t10;
    let t313 = k * (t311 + t312);
    let t314 = shift * t306 - t44 * t78 + (t43 * t80 + cos3 * t310 - (t313 - t21 * t287));
    let t315 = t36 * (t314 - t11 * t291);
    let t316 = t75 * t44;
    let t317 = t36 * (t11 * t293 - (t40 * t78 - t38 * t306 - t307)) + (t2 * t315 - t316);
    let t318 = u_hC * u_hC;
    let t319 = 2.0_f64 * t303;
    let t320 = t319 * t8;
    let t321 = t320 - t77 * (t6 * (t8 * t78));
    let t322 = 2.0_f64 * t78;
    let t323 = 2.0_f64 * t291;
    let t324 = k * (t311 - t312);
    let t325 = k * (t79 * t309 - k * (t303 + (t14 * t321 + t78 * t78)));
    let t326 = t78 * t323 - (shift * t321 + (t80 * (2.0_f64 * t287) - (t324 + cos3 * t325)));
    let t327 = t36 * t326;
    let t328 = t36 * (t307 + t38 * t321 + t293 * t322) - t2 * t327 - t75 * t323;
    let t329 = u_hB * u_hC;
    let t330 = t6 * (t8 * t108);
    let t331 = t304 + t77 * t330;
    let t332 = k * (t319 * t41);
    let t333 = k * (t109 * t309 + k * (t308 - (t78 * t108 - t14 * t331)));
    let t334 = t332 - t110 * t287 + (cos3 * t333 - t80 * t165) - (t78 * t166 - shift * t331);
    let t335 = t36 * (t334 + t108 * t291);
    let t336 = t36 * (t38 * t331 - t78 * t161 - t108 * t293) + t2 * t335 - t75 * (t166 + t291);
    let t337 = t329 * (t35 * t336);
    let t338 = u_hA * u_hB;
    let t339 = t304 - t107 * t305;
    let t340 = 2.0_f64 * t110;
    let t341 = k * (k * (t308 + (t14 * t339 + t11 * t108)) - t20 * t340);
    let t342 = shift * t339 - t44 * t108 + (t324 + t21 * t165 + (t43 * t110 + cos3 * t341));
    let t343 = t36 * (t342 + t11 * t166);
    let t344 = t36 * (t11 * t161 - (t307 + (t40 * t108 - t38 * t339))) + (t2 * t343 + t316);
    let t345 = t338 * (t35 * t344);
    let t346 = u_hA * u_hA;
    let t347 = t320 - t10 * t305;
    let t348 = t11 * t44;
    let t349 = 2.0_f64 * t21;
    let t350 = k * (t20 * t349 - k * (t303 + (t14 * t347 + t11 * t11)));
    let t351 = shift * t347 - (t348 + (t332 + cos3 * t350 + t348)) + t21 * (2.0_f64 * t43);
    let t352 = t36 * t351;
    let t353 = t346 * (t35 * (t2 * t352 - t36 * (t11 * (2.0_f64 * t40) - t38 * t347)));
    let t354 = u_hB * u_hB;
    let t355 = t320 - t107 * t330;
    let t356 = k * (t109 * t340 - k * (t303 + (t14 * t355 + t108 * t108)));
    let t357 = 2.0_f64 * t108;
    let t358 = shift * t355 + (t313 - cos3 * t356 + t110 * (2.0_f64 * t165)) + t166 * t357;
    let t359 = t36 * t358;
    let t360 = t36 * (t38 * t355 - t307 + t108 * (2.0_f64 * t161)) + t2 * t359 - t75 * (2.0_f64 * t166);
    let t361 = t318 * (t35 * t328) - (t337 + (t345 - (t353 - t345) - t354 * (t35 * t360) + t337));
    let t362 = t302 * (2.0_f64 * (t35 * t317)) - t361;
    let t363 = t7 * t291;
    let t364 = t1 * t44;
    let t365 = t36 * (t303 - (t47 * t78 + t46 * t306) + t11 * t290) + (t4 * t315 + t363 + t364);
    let t366 = t302 * (t35 * t365);
    let t367 = t7 * t166;
    let t368 = t36 * (t11 * t169 - (t303 - (t47 * t108 + t46 * t339))) + (t367 - t4 * t343 - t364);
    let t369 = t36 * (t46 * t347 - t319 + t11 * (2.0_f64 * t47)) - t4 * t352 - t39 * t44;
    let t370 = t35 * (t367 + (t36 * (t303 + t46 * t355 + t169 * t357) - t4 * t359));
    let t371 = t366 - (t338 * (2.0_f64 * (t35 * t368)) - (t366 + t346 * (t35 * t369))) + t354 * t370;
    let t372 = t36 * (t303 + t46 * t321 - t78 * (2.0_f64 * t290)) + t4 * t327 - t363;
    let t373 = t4 * t335 - t36 * (t319 + (t46 * t331 - t78 * t169) + t108 * t290);
    let t374 = t371 + t318 * (t35 * t372) + t329 * (2.0_f64 * (t35 * (t373 - t364)));
    let t375 = k * t107;
    let t376 = t302 * (t375 - t21 * t288 - (cos2 * t80 + t49 * t310));
    let t377 = k * t77;
    let t378 = t338 * (t21 * t172 - t377 + (cos2 * t110 + t49 * t341));
    let t379 = t376 - (t378 + (t378 - t376 + t346 * (t23 + t49 * t350 - cos2 * t349)));
    let t380 = t379 + t354 * (t375 - t49 * t356 + t110 * (2.0_f64 * t172)) + t318 * (t80 * (2.0_f64 * t288) - (t49 * t325 - t377));
    let t381 = t380 + t329 * (2.0_f64 * (t110 * t288 - t23 + (t80 * t172 - t49 * t333)));
    let t382 = g - t381;
    let FC = inputs[2];
    let c = p.c;
    let t383 = u_hC * t271 + (u_hB * t202 + u_hA * t138);
    let t384 = u_hB * t203 + u_hA * t142 - u_hC * t267;
    let t385 = Ic1 - Ic2;
    let t386 = t303 * k - t9 * t21;
    let t387 = t386 - (t5 * t310 + t10 * t80);
    let t388 = t302 * t387;
    let t389 = t10 * t110;
    let t390 = t386 - (t5 * t341 + t389);
    let t391 = t338 * t390;
    let t392 = t5 * t350 + t319 * k - t10 * t349;
    let t393 = t308 * k;
    let t394 = t5 * t356 + t393 - t389;
    let t395 = t9 * t80;
    let t396 = t393 - t395;
    let t397 = t396 - (t395 - t5 * t325);
    let t398 = t388 + (t391 + (t388 + t391 - t346 * t392)) - t354 * t394 - t318 * t397;
    let t399 = t396 - (t9 * t110 - t5 * t333);
    let t400 = t398 - t329 * (2.0_f64 * t399);
    let t401 = t75 * t111;
    let t402 = t75 * t81;
    let t403 = t2 * (t1 * t21 - t4 * t333);
    let t404 = t402 - t403;
    let t405 = t401 + t404;
    let t406 = t329 * t405;
    let t407 = t21 * t76;
    let t408 = t3 * t341 + t407;
    let t409 = t2 * (t39 * t21 - t4 * t350);
    let t410 = 0.5_f64 * t409;
    let t411 = t3 * t350;
    let t412 = 0.8660254037844386_f64 * t411;
    let t413 = t410 - t412;
    let t414 = t75 * t26;
    let t415 = t413 - t414;
    let t416 = 0.8660254037844386_f64 * t408 + 0.5_f64 * t415;
    let t417 = t416 + t401;
    let t418 = t412 + t410;
    let t419 = t418 + t414;
    let t420 = t302 * t419;
    let t421 = t407 - t3 * t310;
    let t422 = 0.8660254037844386_f64 * t421 + 0.5_f64 * t419;
    let t423 = t402 + t422;
    let t424 = t406 - (t354 * t417 - (t420 + (t420 - t346 * t409)) - t406) - t318 * t423;
    let t425 = t424 + t338 * (2.0_f64 * t415);
    let t426 = u_hC * t265 - (u_hB * t199 + u_hA * t134);
    let t427 = u_hC * t239 - (u_hB * t150 + u_hA * t24);
    let t428 = u_hB * t197 + u_hA * t131 - u_hC * t266;
    let t429 = u_hC * t240 - (u_hB * t152 + u_hA * t27);
    let t430 = t383 * t384 * t385 + Ic3 * (t135 * t400 + t132 * t425 - (t426 * t427 + t428 * t429));
    let t431 = u_hA * t144 - u_hB * t204 - u_hC * t272;
    let t432 = Ic2 - Ic3;
    let t433 = u_hB * t198 + u_hA * t133 - u_hC * t269;
    let t434 = u_hC * t270 - (u_hB * t200 + u_hA * t136);
    let t435 = 2.0_f64 * t264;
    let t436 = t6 * (t16 * t306 - t17 * t78 - t11 * t237);
    let t437 = 0.8660254037844386_f64 * t436;
    let t438 = t6 * (t11 * (2.0_f64 * t17) - t16 * t347);
    let t439 = 0.8660254037844386_f64 * t438;
    let t440 = t6 * (3.0_f64 * (t11 * t13));
    let t441 = 0.5_f64 * t440;
    let t442 = t439 + t441;
    let t443 = 0.5_f64 * t442;
    let t444 = t437 + t443;
    let t445 = t126 * (t127 * t195);
    let t446 = t195 * t435 + t126 * (t127 * (2.0_f64 * (t12 * t444 + t56 * t100)) + t262 * t445);
    let t447 = t126 * t446;
    let t448 = t19 * t447 + t152 * t264 + (t196 * t240 - t126 * t405);
    let t449 = 2.0_f64 * t196;
    let t450 = t439 - t441;
    let t451 = t129 * t449 + t126 * (t128 * t445 + t127 * (2.0_f64 * (t13 * t100 - t12 * t450)));
    let t452 = t126 * t451;
    let t453 = t19 * t452 + t27 * t196 + (t130 * t152 + t126 * t415);
    let t454 = t338 * t453;
    let t455 = t126 * (t127 * t263);
    let t456 = t129 * t435 + t126 * (t128 * t455 + t127 * (2.0_f64 * (t13 * t56 - t12 * t442)));
    let t457 = t126 * t456;
    let t458 = t19 * t457 + t27 * t264 + (t130 * t240 - t126 * t419);
    let t459 = t302 * t458;
    let t460 = 2.0_f64 * t130;
    let t461 = t127 * (2.0_f64 * (t12 * t440 - t13 * t13)) - t128 * (t126 * (t127 * t129));
    let t462 = t126 * (t129 * t460 - t126 * t461);
    let t463 = t19 * t462 - t126 * t409 + t27 * t460;
    let t464 = t6 * (t11 * t156 - (t16 * t339 - t17 * t108));
    let t465 = 0.8660254037844386_f64 * t464 + 0.5_f64 * t450;
    let t466 = t100 * t100;
    let t467 = t195 * t449 + t126 * (t127 * (2.0_f64 * (t12 * t465 + t466)) + t194 * t445);
    let t468 = t126 * t467;
    let t469 = t19 * t468 - t126 * t417 + t196 * (2.0_f64 * t152);
    let t470 = t56 * t56;
    let t471 = t443 - t437;
    let t472 = t263 * t435 + t126 * (t127 * (2.0_f64 * (t470 - t12 * t471)) + t262 * t455);
    let t473 = t126 * t472;
    let t474 = t240 * t435 - (t126 * t423 - t19 * t473);
    let t475 = t454 - (t459 - (t454 + t346 * t463)) - t459 + t354 * t469 + t318 * t474;
    let t476 = t15 * t457 + t130 * t239 + (t126 * t387 + t24 * t264);
    let t477 = t302 * t476;
    let t478 = t24 * t130;
    let t479 = t15 * t462 + t478 + (t478 + t126 * t392);
    let t480 = 2.0_f64 * t338;
    let t481 = t15 * t452 + t24 * t196 - (t126 * t390 - t130 * t150);
    let t482 = t15 * t468 + t126 * t394 + t150 * t449;
    let t483 = t15 * t473 + t126 * t397 + t239 * t435;
    let t484 = t477 - (t346 * t479 - t477 + t480 * t481) - t354 * t482 - t318 * t483;
    let t485 = t15 * t447 + t150 * t264 + (t196 * t239 - t126 * t399);
    let t486 = t140 * (t329 * (2.0_f64 * t448) - t475) - t141 * (t484 + t329 * (2.0_f64 * t485));
    let t487 = t383 * t431 * t432 + Ic1 * (t426 * t433 - t428 * t434 + t486);
    let t488 = Ic1 - Ic3;
    let t489 = u_hB * t100 + u_hA * t13 - u_hC * t56;
    let t490 = t429 * t434 - t427 * t433 - (u_hB * t201 + u_hA * t137 - u_hC * t268) * t489;
    let t491 = 2.0_f64 * t266;
    let t492 = t302 * (t12 * t476 + t13 * t266 + (t56 * t131 - t132 * t442));
    let t493 = 2.0_f64 * t131;
    let t494 = t338 * (2.0_f64 * (t132 * t450 - t100 * t131 - (t12 * t481 + t13 * t197)));
    let t495 = t492 + (t492 + t346 * (t132 * t440 - t12 * t479 - t13 * t493) + t494);
    let t496 = 2.0_f64 * t197;
    let t497 = t318 * (t56 * t491 - (t132 * t471 - t12 * t483)) - (t495 - t354 * (t12 * t482 + t132 * t465 + t100 * t496));
    let t498 = t329 * (2.0_f64 * (t12 * t485 + t100 * t266 + (t56 * t197 + t132 * t444)));
    let t499 = 2.0_f64 * t265;
    let t500 = t302 * (t12 * t458 + t13 * t265 + (t56 * t134 - t135 * t442));
    let t501 = t338 * (t12 * t453 + t13 * t199 - (t135 * t450 - t100 * t134));
    let t502 = 2.0_f64 * t134;
    let t503 = t501 + (t501 - t500 + t346 * (t12 * t463 - t135 * t440 + t13 * t502));
    let t504 = 2.0_f64 * t199;
    let t505 = t318 * (t12 * t474 - t135 * t471 + t56 * t499) - (t500 - t503 - t354 * (t12 * t469 + t135 * t465 + t100 * t504));
    let t506 = t329 * (2.0_f64 * (t12 * t448 + t100 * t265 + (t56 * t199 + t135 * t444)));
    let t507 = t15 * t485 + t150 * t266 - (t132 * t399 - t197 * t239) + (t19 * t448 + t152 * t265 - (t135 * t405 - t199 * t240));
    let t508 = t329 * t507;
    let t509 = t15 * t481 + t24 * t197 - (t132 * t390 - t131 * t150) + (t19 * t453 + t27 * t199 + (t134 * t152 + t135 * t415));
    let t510 = t338 * t509;
    let t511 = t15 * t479 + t132 * t392 + t24 * t493 + (t27 * t502 - (t135 * t409 - t19 * t463));
    let t512 = t15 * t482 + t132 * t394 + t150 * t496 + (t19 * t469 - t135 * t417 + t152 * t504);
    let t513 = t132 * t397 + (t19 * t474 - t135 * t423 + t240 * t499) + t15 * t483;
    let t514 = t508 + (t508 - (t510 + (t510 + t346 * t511) + t354 * t512)) - t318 * (t513 + t239 * t491);
    let t515 = t135 * t419 - t134 * t240 - (t19 * t458 + t27 * t265) - (t15 * t476 + t24 * t266 + (t131 * t239 + t132 * t387));
    let t516 = t15 * (t497 - t498) + t19 * (t505 - t506) + t12 * (t514 - t302 * (2.0_f64 * t515));
    let t517 = t488 * (t384 * t431) + Ic2 * (t490 + t516);
    let t518 = u_hB * t191 - u_hA * t118 - u_hC * t284;
    let t519 = u_hC * t285 + (u_hB * t192 + u_hA * t122);
    let t520 = 0.8660254037844386_f64 * t423;
    let t521 = 0.5_f64 * t397;
    let t522 = t520 - t521;
    let t523 = 0.8660254037844386_f64 * t405;
    let t524 = 0.5_f64 * t399;
    let t525 = t523 + t524;
    let t526 = t329 * t525;
    let t527 = 0.5_f64 * t390;
    let t528 = 0.8660254037844386_f64 * t415;
    let t529 = t527 - t528;
    let t530 = t338 * t529;
    let t531 = 0.5_f64 * t392;
    let t532 = 0.8660254037844386_f64 * t409;
    let t533 = t531 - t532;
    let t534 = 0.5_f64 * t394;
    let t535 = 0.8660254037844386_f64 * t417;
    let t536 = t534 - t535;
    let t537 = t318 * t522 - (t526 + (t526 - (t530 - (t346 * t533 - t530) - t354 * t536)));
    let t538 = 0.8660254037844386_f64 * t419;
    let t539 = 0.5_f64 * t387;
    let t540 = t538 - t539;
    let t541 = 0.5_f64 * t423;
    let t542 = t76 * t80;
    let t543 = 2.0_f64 * (t75 * t75) * k;
    let t544 = t542 + t3 * t325 + (t543 + t542);
    let t545 = 0.8660254037844386_f64 * t544;
    let t546 = t541 - t545;
    let t547 = t76 * t110;
    let t548 = t547 - t543;
    let t549 = t548 + (t3 * t333 - t542);
    let t550 = 0.8660254037844386_f64 * t549;
    let t551 = 0.5_f64 * t405;
    let t552 = t550 + t551;
    let t553 = t329 * t552;
    let t554 = t338 * t416;
    let t555 = t548 - (t3 * t356 - t547);
    let t556 = 0.8660254037844386_f64 * t555;
    let t557 = 0.5_f64 * t417;
    let t558 = t556 + t557;
    let t559 = t318 * t546 - (t553 + (t554 - (t346 * t413 - t554) - t354 * t558 + t553));
    let t560 = t401 - t403;
    let t561 = t114 * (t537 - t302 * (2.0_f64 * t540)) + t105 * (t559 + t302 * (2.0_f64 * t560));
    let t562 = u_hC * t281 + (u_hB * t188 + u_hA * t113);
    let t563 = u_hB * t182 + u_hA * t98 - u_hC * t273;
    let t564 = u_hC * t279 - (u_hB * t183 + u_hA * t104);
    let t565 = u_hC * t274 + (u_hB * t187 + u_hA * t112);
    let t566 = t385 * (t518 * t519) + Ic3 * (t561 - (t562 * t563 + t564 * t565));
    let t567 = FC - u_hC * c + t272 * t430 + t267 * t487 + t271 * t517 + t275 * t566;
    let t568 = u_hC * t280 + (u_hA * t117 - u_hB * t184);
    let t569 = u_hC * t282 - (u_hB * t189 + u_hA * t116);
    let t570 = 2.0_f64 * t278;
    let t571 = 0.5_f64 * t444;
    let t572 = t6 * (t78 * t156 + t16 * t331 + t108 * t237);
    let t573 = 0.8660254037844386_f64 * t572;
    let t574 = t571 - t573;
    let t575 = t97 * (t99 * t277);
    let t576 = t178 * t570 + t97 * (t99 * (2.0_f64 * (t95 * t574 + t206 * t176)) + t177 * t575);
    let t577 = t97 * t576;
    let t578 = t97 * t525 - t179 * t273 - (t96 * t577 + t182 * t278);
    let t579 = t329 * t578;
    let t580 = 2.0_f64 * t179;
    let t581 = t6 * (t16 * t355 - t108 * (2.0_f64 * t156));
    let t582 = 0.5_f64 * t465 - 0.8660254037844386_f64 * t581;
    let t583 = t97 * (t99 * t178);
    let t584 = t178 * t580 + t97 * (t99 * (2.0_f64 * (t95 * t582 + t176 * t176)) + t177 * t583);
    let t585 = t97 * t584;
    let t586 = t96 * t585 + t97 * t536 + t182 * t580;
    let t587 = t102 * t570 + t97 * (t101 * t575 + t99 * (2.0_f64 * (t95 * t444 + t100 * t206)));
    let t588 = t97 * t587;
    let t589 = t98 * t278 - t96 * t588 - (t103 * t273 + t97 * t540);
    let t590 = t302 * t589;
    let t591 = 2.0_f64 * t103;
    let t592 = t97 * (t101 * (t97 * (t99 * t102)) + t99 * (2.0_f64 * (t466 + t95 * t450)));
    let t593 = t97 * (t102 * t591 + t592);
    let t594 = t98 * t591 - (t96 * t593 + t97 * t533);
    let t595 = t206 * t206;
    let t596 = t573 + t571;
    let t597 = t277 * t570 + t97 * (t99 * (2.0_f64 * (t595 - t95 * t596)) + t276 * t575);
    let t598 = t97 * t597;
    let t599 = t273 * t570 - (t97 * t522 - t96 * t598);
    let t600 = t579 + (t354 * t586 - (t590 + (t590 + t346 * t594)) + t579) + t318 * t599;
    let t601 = t102 * t580 + t97 * (t101 * t583 + t99 * (2.0_f64 * (t95 * t465 + t100 * t176)));
    let t602 = t97 * t601;
    let t603 = t96 * t602 - t98 * t179 + (t103 * t182 + t97 * t529);
    let t604 = t106 * t598 + t97 * t546 - t274 * t570;
    let t605 = t103 * t274 - t97 * t560 - (t106 * t588 - t112 * t278);
    let t606 = t302 * t605;
    let t607 = t106 * t593 + t97 * t413 - t112 * t591;
    let t608 = t106 * t602 - t112 * t179 + (t103 * t187 + t97 * t416);
    let t609 = t106 * t585 + t97 * t558 + t187 * t580;
    let t610 = t318 * t604 - (t606 + (t606 - t346 * t607 + t338 * (2.0_f64 * t608)) - t354 * t609);
    let t611 = t179 * t274 - t97 * t552 - (t106 * t577 + t187 * t278);
    let t612 = t562 * t568 + t564 * t569 + (t121 * (t600 - t480 * t603) - t120 * (t610 + t329 * (2.0_f64 * t611)));
    let t613 = u_hC * t275 + (u_hB * t193 + u_hA * t124);
    let t614 = Ic1 * t612 - t432 * (t518 * t613);
    let t615 = (u_hC * t283 + (u_hB * t190 + u_hA * t115)) * (u_hC * t206 + (u_hA * t100 - u_hB * t176));
    let t616 = t302 * (2.0_f64 * (t100 * t279 - t95 * t589 + (t105 * t444 - t104 * t206)));
    let t617 = t329 * (t206 * t183 + t105 * t574 - (t95 * t578 - t176 * t279));
    let t618 = t338 * (t104 * t176 - t105 * t465 - (t95 * t603 + t100 * t183));
    let t619 = t346 * (t95 * t594 - t105 * t450 + t100 * (2.0_f64 * t104)) - t618 - t618;
    let t620 = 2.0_f64 * t183;
    let t621 = t617 + (t619 - t354 * (t95 * t586 + t105 * t582 + t176 * t620) + t617);
    let t622 = t616 - (t621 - t318 * (t95 * t599 - t105 * t596 + t206 * (2.0_f64 * t279)));
    let t623 = t329 * (t95 * t611 + t176 * t281 - (t206 * t188 + t114 * t574));
    let t624 = 2.0_f64 * t113;
    let t625 = t338 * (t95 * t608 + t100 * t188 - (t113 * t176 - t114 * t465));
    let t626 = 2.0_f64 * t188;
    let t627 = t346 * (t95 * t607 + t114 * t450 - t100 * t624) - t625 - t625 + t354 * (t95 * t609 + t114 * t582 + t176 * t626);
    let t628 = 2.0_f64 * t281;
    let t629 = t623 + (t627 + t623) + t318 * (t95 * t604 - t114 * t596 - t206 * t628);
    let t630 = t302 * (2.0_f64 * (t95 * t605 + t100 * t281 + (t113 * t206 - t114 * t444)));
    let t631 = t112 * t281 - t106 * t605 + (t113 * t274 + t114 * t560) - (t96 * t589 + t98 * t279 - (t105 * t540 - t104 * t273));
    let t632 = t302 * t631;
    let t633 = t98 * t104;
    let t634 = t633 + (t106 * t607 + t114 * t413 + t633 + t105 * t533) - t96 * t594;
    let t635 = t105 * t529 - t104 * t182 - (t98 * t183 - t96 * t603) + (t106 * t608 - t112 * t188 + (t114 * t416 - t113 * t187));
    let t636 = t105 * t536 + (t106 * t609 + t114 * t558 + t187 * t626) + t96 * t586;
    let t637 = t632 + (t632 + t346 * (t634 + t112 * t624) - t338 * (2.0_f64 * t635)) + t354 * (t636 + t182 * t620);
    let t638 = t273 * t279;
    let t639 = t105 * t522 - (t106 * t604 + t114 * t546 + t638) - t638 - t96 * t599;
    let t640 = t106 * t611 + t187 * t281 + (t188 * t274 - t114 * t552) - (t182 * t279 - t96 * t578 + (t183 * t273 - t105 * t525));
    let t641 = t96 * t622 + t106 * (t629 - t630) - t95 * (t637 - t318 * (t639 - t274 * t628) + t329 * (2.0_f64 * t640));
    let t642 = t488 * (t519 * t613) + Ic2 * (t563 * t568 + t565 * t569 - t615 - t641);
    let t643 = u_hB * t219 + u_hA * t93 - u_hC * t261;
    let t644 = u_hC * t260 + (u_hB * t218 + u_hA * t91);
    let t645 = t523 - t524;
    let t646 = 2.0_f64 * t247;
    let t647 = t59 * (t64 * t246);
    let t648 = t208 * t646 + t59 * (t64 * (2.0_f64 * (dzC * t596 + t206 * t244)) + t207 * t647);
    let t649 = t59 * t648;
    let t650 = t209 * t250 + t59 * t645 - (t53 * t649 + t210 * t247);
    let t651 = t329 * (2.0_f64 * (dzC * t650 - t206 * t251 - (t211 * t244 + t60 * t596)));
    let t652 = 2.0_f64 * t209;
    let t653 = t59 * (t64 * t208);
    let t654 = t208 * t652 + t59 * (t64 * (2.0_f64 * (t595 + dzC * t574)) + t207 * t653);
    let t655 = t59 * t654;
    let t656 = t535 + t534;
    let t657 = t53 * t655 + t59 * t656 + t210 * t652;
    let t658 = 2.0_f64 * t211;
    let t659 = t538 + t539;
    let t660 = t59 * (t64 * t66);
    let t661 = t66 * t646 + t59 * (t245 * t660 + t64 * (2.0_f64 * (dzC * t471 + t56 * t244)));
    let t662 = t59 * t661;
    let t663 = t59 * t659 - t67 * t250 - (t63 * t247 - t53 * t662);
    let t664 = t302 * (dzC * t663 + t56 * t251 + (t60 * t471 - t68 * t244));
    let t665 = 2.0_f64 * t67;
    let t666 = t66 * t665 + t59 * (t65 * t660 + t64 * (2.0_f64 * (t470 + dzC * t442)));
    let t667 = t59 * t666;
    let t668 = t532 + t531;
    let t669 = t63 * t665 - (t53 * t667 + t59 * t668);
    let t670 = 2.0_f64 * t68;
    let t671 = t66 * t652 + t59 * (t65 * t653 + t64 * (2.0_f64 * (dzC * t444 + t56 * t206)));
    let t672 = t59 * t671;
    let t673 = t528 + t527;
    let t674 = t63 * t209 - t53 * t672 - (t67 * t210 + t59 * t673);
    let t675 = t338 * (2.0_f64 * (t56 * t211 - dzC * t674 + (t60 * t444 - t68 * t206)));
    let t676 = t664 + (t664 - t346 * (t60 * t442 - dzC * t669 - t56 * t670) + t675);
    let t677 = t6 * (t16 * t321 - t237 * t322);
    let t678 = 0.5_f64 * t471 - 0.8660254037844386_f64 * t677;
    let t679 = t246 * t646 + t59 * (t64 * (2.0_f64 * (dzC * t678 + t244 * t244)) + t245 * t647);
    let t680 = t59 * t679;
    let t681 = t520 + t521;
    let t682 = t53 * t680 + t59 * t681 - t250 * t646;
    let t683 = 2.0_f64 * t251;
    let t684 = t354 * (dzC * t657 + t60 * t574 + t206 * t658) - t676 + t318 * (dzC * t682 + t60 * t678 + t244 * t683);
    let t685 = t551 - t550;
    let t686 = t72 * t649 + t212 * t247 + (t59 * t685 - t209 * t255);
    let t687 = t329 * (2.0_f64 * (dzC * t686 - t206 * t256 + (t213 * t244 + t84 * t596)));
    let t688 = t82 * t247 - t72 * t662 + (t67 * t255 + t59 * t422);
    let t689 = t302 * (t83 * t244 + t84 * t471 - (dzC * t688 + t56 * t256));
    let t690 = t72 * t672 - t82 * t209 + (t67 * t212 + t59 * t404);
    let t691 = t338 * (dzC * t690 + t56 * t213 + (t83 * t206 + t84 * t444));
    let t692 = t59 * t418 - t72 * t667 + t82 * t665;
    let t693 = 2.0_f64 * t83;
    let t694 = t691 + (t689 + (t691 + t346 * (dzC * t692 - t84 * t442 - t56 * t693)));
    let t695 = t557 - t556;
    let t696 = t212 * t652 - (t59 * t695 - t72 * t655);
    let t697 = 2.0_f64 * t213;
    let t698 = t545 + t541;
    let t699 = t59 * t698 - t72 * t680 + t255 * t646;
    let t700 = 2.0_f64 * t256;
    let t701 = t689 + t694 - t354 * (dzC * t696 + t84 * t574 + t206 * t697) + t318 * (dzC * t699 - t84 * t678 + t244 * t700);
    let t702 = t60 * t681 + (t255 * t700 - (t72 * t699 + t84 * t698)) + t53 * t682;
    let t703 = t53 * t663 - t63 * t251 + (t68 * t250 + t60 * t659) - (t83 * t255 + t84 * t422 - (t82 * t256 - t72 * t688));
    let t704 = t302 * t703;
    let t705 = t72 * t690 - t82 * t213 + (t83 * t212 + t84 * t404) - (t53 * t674 + t63 * t211 + (t68 * t210 - t60 * t673));
    let t706 = t338 * t705;
    let t707 = t72 * t692 + t84 * t418 + t82 * t693 - t60 * t668 + t53 * t669;
    let t708 = t60 * t656 + (t72 * t696 - t84 * t695 + t212 * t697) + t53 * t657;
    let t709 = t704 + (t706 + (t704 + (t706 + t346 * (t707 - t63 * t670)))) - t354 * (t708 + t210 * t658);
    let t710 = t72 * t686 - t212 * t256 + (t84 * t685 - t213 * t255) - (t53 * t650 - t210 * t251 + (t211 * t250 + t60 * t645));
    let t711 = t53 * (t651 - t684) - t72 * (t687 - t701) + dzC * (t318 * (t702 - t250 * t683) - t709 + t329 * (2.0_f64 * t710));
    let t712 = u_hC * t257 - (u_hA * t85 - u_hB * t216);
    let t713 = u_hB * t212 + u_hA * t82 - u_hC * t255;
    let t714 = u_hC * t252 + (u_hB * t215 - u_hA * t69);
    let t715 = u_hC * t250 - (u_hB * t210 + u_hA * t63);
    let t716 = (u_hC * t258 - (u_hB * t214 + u_hA * t86)) * (u_hC * t244 + (u_hB * t206 - u_hA * t56));
    let t717 = t488 * (t643 * t644) - Ic2 * (t711 - (t712 * t713 - t714 * t715 + t716));
    let t718 = u_hB * t217 + u_hA * t87 - u_hC * t259;
    let t719 = u_hC * t256 - (u_hB * t213 - u_hA * t83);
    let t720 = u_hC * t251 + (u_hB * t211 + u_hA * t68);
    let t721 = t329 * t686;
    let t722 = t338 * t690;
    let t723 = t318 * t699 - (t721 + (t354 * t696 - (t722 + (t722 + t346 * t692)) + t721));
    let t724 = t302 * t663;
    let t725 = t329 * t650;
    let t726 = t354 * t657 - (t724 + (t724 + t346 * t669)) - t725 - t725 + t318 * t682;
    let t727 = t89 * (t723 - t302 * (2.0_f64 * t688)) + t90 * (t726 + t338 * (2.0_f64 * t674));
    let t728 = t432 * (t643 * t718) + Ic1 * (t714 * t719 + t712 * t720 + t727);
    let t729 = t302 * t659;
    let t730 = t346 * t668 - t729 - t480 * t673 - t729 + t354 * t656 + t318 * t681;
    let t731 = t329 * t685;
    let t732 = t338 * t404;
    let t733 = t318 * t698 - (t731 + (t731 - (t732 + (t732 + t346 * t418) + t354 * t695)));
    let t734 = t84 * (t730 - t329 * (2.0_f64 * t645)) + t60 * (t733 - t302 * (2.0_f64 * t422));
    let t735 = t385 * (t644 * t718) - Ic3 * (t715 * t719 - t713 * t720 + t734);
    let t736 = t567 - t285 * t614 + t284 * t642 + (t259 * t717 + t260 * t728 - t261 * t735);
    let t737 = u_hC * t242 + (u_hB * t158 + u_hA * t31);
    let t738 = u_hC * t241 + (u_hA * t28 - u_hB * t157);
    let t739 = u_hC * t237 + (u_hB * t156 - u_hA * t17);
    let t740 = t329 * t444;
    let t741 = t302 * t442;
    let t742 = t740 + (t346 * t440 - t741 - t741 - t354 * t465 + t740) + t318 * t471;
    let t743 = t742 + t338 * (2.0_f64 * t450);
    let t744 = u_hB * t155 + u_hA * t22 - u_hC * t238;
    let t745 = t489 * t739 - (t16 * t743 + t25 * t425 + t19 * t400) + t429 * (t427 + t744);
    let t746 = t737 * t738 * (Ix - Iy) + Iz * t745;
    let t747 = u_hC * t243 - (u_hB * t153 + u_hA * t33);
    let t748 = t302 * t436;
    let t749 = t338 * (2.0_f64 * t464) - (t748 + t346 * t438) - t748 + t354 * t581 + t318 * t677;
    let t750 = t749 - t329 * (2.0_f64 * t572);
    let t751 = t24 * t155 - t15 * t408 - (t25 * t390 - t22 * t150) + 2.0_f64 * (t19 * t415 + t27 * t152);
    let t752 = 2.0_f64 * (t152 * t240 - t19 * t405) - (t25 * t399 - t155 * t239 - (t15 * t549 + t150 * t238));
    let t753 = t329 * t752;
    let t754 = t15 * t421 - t24 * t238 - (t22 * t239 + t25 * t387) - 2.0_f64 * (t27 * t240 - t19 * t419);
    let t755 = t302 * t754;
    let t756 = t25 * t392 - t15 * t411 + t22 * (2.0_f64 * t24) - 2.0_f64 * (t19 * t409 - t27 * t27);
    let t757 = t25 * t394 - 2.0_f64 * (t19 * t417 - t152 * t152) + t15 * t555 + t150 * (2.0_f64 * t155);
    let t758 = 2.0_f64 * (t19 * t423 - t240 * t240) - t25 * t397 + t15 * t544 - t239 * (2.0_f64 * t238);
    let t759 = t753 + (t753 - (t755 + (t755 + t346 * t756) + t354 * t757)) + t318 * t758;
    let t760 = t429 * t739 + (t15 * t743 + t19 * t750 + t12 * (t480 * t751 - t759));
    let t761 = (Ix - Iz) * (t747 * t737) + Iy * (t489 * t744 - t760);
    let t762 = t329 * t549;
    let t763 = t338 * t408;
    let t764 = t762 + (t763 + (t763 + t346 * t411) - t354 * t555 + t762) + t318 * t544;
    let t765 = t30 * t750 - t16 * (t302 * (2.0_f64 * t421) - t764) + t12 * t425 - (t429 * t489 - t427 * t739);
    let t766 = t747 * t738 * (Iy - Iz) + Ix * t765;
    let t767 = M * (t294 * t362 + t292 * t374 + t289 * t382) - t736 + (t243 * t746 - (t241 * t761 - t242 * t766));
    let t768 = t148 * t298;
    let FA = inputs[0];
    let t769 = t124 * t566 - (t144 * t430 + (u_hA * c - FA) + t142 * t487 - t138 * t517);
    let t770 = t769 - t122 * t614 + t118 * t642 + (t91 * t728 - t87 * t717 + t93 * t735);
    let t771 = t770 - M * (t45 * t362 + t48 * t374 + t50 * t382) + (t28 * t761 - t31 * t766 + t33 * t746);
    let forcing_u_hA = t771 - t301;
    let FB = inputs[1];
    let t772 = t202 * t517 - (t203 * t487 - (t204 * t430 - (u_hB * c - FB))) + t193 * t566;
    let t773 = t191 * t642 - (t772 - t192 * t614) - (t218 * t728 - t217 * t717 + t219 * t735);
    let t774 = t773 + M * (t168 * t362 - t171 * t374 + t173 * t382) - (t153 * t746 - (t157 * t761 + t158 * t766));
    let t775 = t301 + (t774 + t221 * forcing_u_hA);
    let t776 = t284 * (Ic2 * t284) + t285 * (Ic1 * t285) + t275 * (Ic3 * t275) + (t271 * (Ic2 * t271) + t267 * (Ic1 * t267) + t272 * (Ic3 * t272));
    let t777 = t259 * (Ic2 * t259) + t260 * (Ic1 * t260) + t261 * (Ic3 * t261) + (mc + (mr + (ms + t776)));
    let mass_u_hC_u_hC = t241 * (Iy * t241) + t242 * (Ix * t242) + t243 * (Iz * t243) + (M * (t294 * t294 + t292 * t292 + t289 * t289) + t777);
    let pivot_2 = mass_u_hC_u_hC - t298 * t768 - t299 * t300;
    let t778 = (t301 + (t767 - t768 * forcing_u_hA + t300 * t775)) / pivot_2;
    let t779 = t300 * t778 + t236 * t775;
    let t780 = t221 * t779 + t148 * forcing_u_hA - t768 * t778;
    let t781 = Real::min(Real::min(0.21652832912306028_f64 * Real::abs(mass_u_hA_u_hA), 0.21680787182359307_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t780, -t779, -t778], t781)
}
///Kinetic and potential energy (J).
///
///908 operations.
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
    let u_hB = u[1];
    let R = p.R;
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let hA = q[0];
    let t2 = t1 * (2.0_f64 * (0.5_f64 * (hB + hC) - hA));
    let t3 = t1 * (1.7320508075688772_f64 * (hB - hC));
    let t4 = t3 * t3;
    let t5 = t2 * t2;
    let root = Real::sqrt(t4 + (1.0_f64 + t5));
    let t6 = 1.0_f64 / root;
    let t7 = t2 * t6;
    let t8 = 1.0_f64 + root;
    let k = 1.0_f64 / (root * t8);
    let t9 = t5 * k - 1.0_f64;
    let t10 = 1.7320508075688772_f64 * t1;
    let t11 = 2.0_f64 * (t10 * t3);
    let t12 = k * t11;
    let t13 = root + t8;
    let t14 = 0.5_f64 * t6;
    let t15 = 2.0_f64 * t1;
    let t16 = t15 * t2;
    let t17 = t16 + t11;
    let t18 = t14 * t17;
    let t19 = k * (k * (t13 * t18));
    let t20 = t12 - t4 * t19;
    let t21 = 1.0_f64 - t4 * k;
    let t22 = t16 * k;
    let t23 = t5 * t19 - t22;
    let t24 = t2 * k;
    let t25 = t3 * t24;
    let t26 = t1 * k;
    let t27 = t3 * (t2 * t19 - t26);
    let t28 = t10 * t24;
    let t29 = t27 - t28;
    let t30 = 2.0_f64 * t16;
    let t31 = t14 * t30;
    let t32 = t3 * t6;
    let t33 = t6 * (t31 * t32);
    let t34 = 0.8660254037844386_f64 * t33;
    let t35 = t6 * (t15 - t31 * t7);
    let t36 = 0.5_f64 * t35;
    let t37 = t34 - t36;
    let t38 = t6 * (t32 * t18 - t10);
    let t39 = t7 * (t9 * t20 + t21 * t23 + 2.0_f64 * (t25 * t29)) - (t9 * t37 + t25 * t38);
    let Iy = p.Iy;
    let t40 = Iy * t39;
    let t41 = t9 * t21 + t25 * t25;
    let t42 = t41 * t38 - (t7 * t29 - t32 * t20);
    let Ix = p.Ix;
    let t43 = Ix * t42;
    let t44 = t25 * t23 - t21 * t29 + t32 * t37;
    let Iz = p.Iz;
    let t45 = Iz * t44;
    let M = p.M;
    let t46 = 0.5_f64 * R;
    let t47 = 1.0_f64 / t8;
    let t48 = t15 * t3;
    let t49 = 2.0_f64 * t2;
    let t50 = t10 * t49;
    let t51 = t3 * t49 * t47;
    let cos2 = t5 - t4;
    let t52 = 3.0_f64 * t1 * cos2;
    let t53 = 3.0_f64 * t2;
    let t54 = t53 * t11;
    let t55 = t52 - t54;
    let cos3 = t2 * t5 - t4 * t53;
    let shift = t47 * (k * cos3);
    let t56 = t47 * (k * t55 - cos3 * t19 - shift * t18);
    let t57 = t10 * shift;
    let t58 = t46 * (t47 * (t48 + t50 - t51 * t18) + (t3 * t56 + t57));
    let t59 = t16 - t11;
    let t60 = t47 * cos2;
    let t61 = t1 * shift;
    let t62 = t46 * (t47 * (t59 - t60 * t18) - (t2 * t56 + t61));
    let t63 = t46 * cos3;
    let t64 = 0.3333333333333333_f64 + (k * (t46 * t55) - t63 * t19);
    let t65 = 0.8660254037844386_f64 * t32;
    let t66 = 0.5_f64 * t7;
    let dzC = t65 - t66;
    let t67 = 0.5_f64 * t9;
    let t68 = 0.8660254037844386_f64 * t25;
    let t69 = t67 - t68;
    let t70 = 1.0_f64 / Real::sqrt(1.0_f64 - dzC * dzC);
    let t71 = 0.5_f64 * t70;
    let t72 = 0.8660254037844386_f64 * t38;
    let t73 = 0.5_f64 * t37;
    let t74 = t72 - t73;
    let t75 = t70 * (t70 * (t71 * (2.0_f64 * (dzC * t74))));
    let t76 = 0.5_f64 * t23;
    let t77 = 0.8660254037844386_f64 * t29;
    let t78 = t76 - t77;
    let t79 = t69 * t75 + t70 * t78;
    let t80 = t70 * t69;
    let t81 = 0.8660254037844386_f64 * t21;
    let t82 = 0.5_f64 * t25;
    let t83 = t81 + t82;
    let t84 = 0.8660254037844386_f64 * t20;
    let t85 = 0.5_f64 * t29;
    let t86 = t84 + t85;
    let t87 = t83 * t75 + t70 * t86;
    let t88 = t70 * t83;
    let t89 = t69 * (dzC * t79 + t80 * t74) + t83 * (dzC * t87 + t88 * t74);
    let t90 = dzC * (t69 * t79 + t80 * t78 + (t83 * t87 + t88 * t86)) - t89;
    let Ic2 = p.Ic2;
    let t91 = Ic2 * t90;
    let t92 = dzC * t88;
    let t93 = dzC * t80;
    let t94 = t92 * t79 - t93 * t87;
    let Ic1 = p.Ic1;
    let t95 = Ic1 * t94;
    let t96 = t80 * t86 - t88 * t78;
    let Ic3 = p.Ic3;
    let t97 = Ic3 * t96;
    let t98 = t68 + t67;
    let t99 = t65 + t66;
    let t100 = 1.0_f64 / Real::sqrt(1.0_f64 - t99 * t99);
    let t101 = 0.5_f64 * t100;
    let t102 = t72 + t73;
    let t103 = t100 * (t100 * (t101 * (2.0_f64 * (t99 * t102))));
    let t104 = t77 + t76;
    let t105 = t98 * t103 + t100 * t104;
    let t106 = t100 * t98;
    let t107 = t81 - t82;
    let t108 = t84 - t85;
    let t109 = t107 * t103 + t100 * t108;
    let t110 = t100 * t107;
    let t111 = t98 * (t99 * t105 + t106 * t102) + t107 * (t99 * t109 + t110 * t102);
    let t112 = t111 - t99 * (t98 * t105 + t106 * t104 + (t107 * t109 + t110 * t108));
    let t113 = Ic2 * t112;
    let t114 = t99 * t106;
    let t115 = t99 * t110;
    let t116 = t114 * t109 - t115 * t105;
    let t117 = Ic1 * t116;
    let t118 = t106 * t108 - t110 * t104;
    let t119 = Ic3 * t118;
    let mc = p.mc;
    let mr = p.mr;
    let ms = p.ms;
    let t120 = 1.0_f64 / Real::sqrt(1.0_f64 - t7 * t7);
    let t121 = 0.5_f64 * t120;
    let t122 = t120 * (t120 * (t121 * (2.0_f64 * (t7 * t37))));
    let t123 = t9 * t122 + t120 * t23;
    let t124 = t9 * t120;
    let t125 = t25 * t122 + t120 * t29;
    let t126 = t25 * t120;
    let t127 = t9 * (t7 * t123 + t37 * t124) + t25 * (t7 * t125 + t37 * t126);
    let t128 = t127 - t7 * (t9 * t123 + t124 * t23 + (t25 * t125 + t126 * t29));
    let t129 = Ic2 * t128;
    let t130 = t7 * t124;
    let t131 = t7 * t126;
    let t132 = t130 * t125 - t131 * t123;
    let t133 = Ic1 * t132;
    let t134 = t124 * t29 - t126 * t23;
    let t135 = Ic3 * t134;
    let t136 = t112 * t113 + t116 * t117 + t118 * t119 + (mc + (mr + (ms + (t128 * t129 + t132 * t133 + t134 * t135))));
    let t137 = M * (t58 * t58 + t62 * t62 + t64 * t64) + (t90 * t91 + t94 * t95 + t96 * t97 + t136);
    let mass_u_hB_u_hB = t39 * t40 + t42 * t43 + t44 * t45 + t137;
    let u_hA = u[0];
    let t138 = k * (k * (t16 + t31 * t8));
    let t139 = t4 * t138;
    let t140 = t30 * k - t5 * t138;
    let t141 = t3 * (t15 * k - t2 * t138);
    let t142 = t35 * t9 - t33 * t25 - t7 * (t9 * t139 + t140 * t21 + 2.0_f64 * (t25 * t141));
    let t143 = Iy * t142;
    let t144 = t32 * t139 - t7 * t141 - t33 * t41;
    let t145 = Ix * t144;
    let t146 = t25 * t140 - t21 * t141 + t35 * t32;
    let t147 = Iz * t146;
    let t148 = t31 * shift + (t138 * cos3 - k * (t2 * (3.0_f64 * t16) - 6.0_f64 * t1 * t4));
    let t149 = t47 * t148;
    let t150 = t46 * (t47 * (t31 * t51 - 4.0_f64 * t1 * t3) + t3 * t149);
    let t151 = t46 * (t47 * (t30 - t31 * t60) + (t2 * t149 - t15 * shift));
    let t152 = 0.3333333333333333_f64 + (t138 * t63 - k * cos2);
    let t153 = t34 + t36;
    let t154 = 0.5_f64 * t140;
    let t155 = 0.8660254037844386_f64 * t141;
    let t156 = t154 - t155;
    let t157 = t70 * (t70 * (t71 * (2.0_f64 * (dzC * t153))));
    let t158 = t70 * t156 - t157 * t69;
    let t159 = t14 * t59;
    let t160 = k * (k * (t13 * t159));
    let t161 = t3 * (t26 - t2 * t160);
    let t162 = t157 * t83 - t70 * t161;
    let t163 = t69 * (t153 * t80 - dzC * t158) + t83 * (dzC * t162 + t153 * t88);
    let t164 = t163 + dzC * (t69 * t158 + t156 * t80 - (t83 * t162 - t161 * t88));
    let t165 = Ic2 * t164;
    let t166 = t162 * t93 + t158 * t92;
    let t167 = Ic1 * t166;
    let t168 = t80 * t161 - t156 * t88;
    let t169 = Ic3 * t168;
    let t170 = t155 + t154;
    let t171 = t100 * (t100 * (t101 * (2.0_f64 * (t99 * t37))));
    let t172 = t100 * t170 - t171 * t98;
    let t173 = t100 * t27 - t171 * t107;
    let t174 = t107 * (t99 * t173 - t37 * t110) - t98 * (t37 * t106 - t99 * t172);
    let t175 = t99 * (t98 * t172 + t170 * t106 + (t107 * t173 + t27 * t110)) - t174;
    let t176 = Ic2 * t175;
    let t177 = t173 * t114 - t172 * t115;
    let t178 = Ic1 * t177;
    let t179 = t106 * t27 - t170 * t110;
    let t180 = Ic3 * t179;
    let t181 = t120 * (t120 * (t121 * (2.0_f64 * (t7 * t35))));
    let t182 = t9 * t181 + t140 * t120;
    let t183 = t25 * t181 + t141 * t120;
    let t184 = t9 * (t7 * t182 + t35 * t124) + t25 * (t7 * t183 + t35 * t126);
    let t185 = t184 - t7 * (t9 * t182 + t140 * t124 + (t25 * t183 + t141 * t126));
    let t186 = Ic2 * t185;
    let t187 = t183 * t130 - t182 * t131;
    let t188 = Ic1 * t187;
    let t189 = t140 * t126 - t141 * t124;
    let t190 = Ic3 * t189;
    let t191 = t175 * t176 + t177 * t178 + t179 * t180 + (mc + (ms + mr) + (t185 * t186 + t187 * t188 + t189 * t190));
    let t192 = M * (t150 * t150 + t151 * t151 + t152 * t152) + (t164 * t165 + t166 * t167 + t168 * t169 + t191);
    let mass_u_hA_u_hA = t142 * t143 + t144 * t145 + t146 * t147 + t192;
    let u_hC = u[2];
    let t193 = t6 * (t10 + t32 * t159);
    let t194 = t12 + t4 * t160;
    let t195 = t22 - t5 * t160;
    let t196 = t161 - t28;
    let t197 = t25 * t193 - t9 * t153 + t7 * (t9 * t194 + t21 * t195 + 2.0_f64 * (t25 * t196));
    let t198 = t7 * t196 - t32 * t194 + t41 * t193;
    let t199 = t25 * t195 - t21 * t196 + t32 * t153;
    let t200 = t52 + t54;
    let t201 = t47 * (shift * t159 + (cos3 * t160 - k * t200));
    let t202 = t46 * (t47 * (t48 - t50 - t51 * t159) - (t57 + t3 * t201));
    let t203 = t46 * (t47 * (t60 * t159 - t17) + (t61 - t2 * t201));
    let t204 = 0.3333333333333333_f64 + (k * (t46 * t200) - t63 * t160);
    let t205 = 0.8660254037844386_f64 * t193 + 0.5_f64 * t153;
    let t206 = t70 * (t70 * (t71 * (2.0_f64 * (dzC * t205))));
    let t207 = 0.5_f64 * t195;
    let t208 = 0.8660254037844386_f64 * t196;
    let t209 = t207 - t208;
    let t210 = t69 * t206 - t70 * t209;
    let t211 = 0.8660254037844386_f64 * t194;
    let t212 = 0.5_f64 * t196;
    let t213 = t211 + t212;
    let t214 = t70 * t213 - t83 * t206;
    let t215 = t69 * (dzC * t210 + t80 * t205) + t83 * (t88 * t205 - dzC * t214);
    let t216 = t215 + dzC * (t80 * t209 - t69 * t210 + (t83 * t214 + t88 * t213));
    let t217 = t93 * t214 + t92 * t210;
    let t218 = t80 * t213 - t88 * t209;
    let t219 = t100 * (t100 * (t101 * (2.0_f64 * (t99 * t74))));
    let t220 = t208 + t207;
    let t221 = t98 * t219 + t100 * t220;
    let t222 = t212 - t211;
    let t223 = t100 * t222 - t107 * t219;
    let t224 = t98 * (t99 * t221 + t106 * t74) + t107 * (t110 * t74 - t99 * t223);
    let t225 = t224 + t99 * (t107 * t223 + t110 * t222 - (t98 * t221 + t106 * t220));
    let t226 = t114 * t223 + t115 * t221;
    let t227 = t110 * t220 + t106 * t222;
    let t228 = t120 * (t120 * (t121 * (2.0_f64 * (t7 * t153))));
    let t229 = t9 * t228 + t120 * t195;
    let t230 = t25 * t228 + t120 * t196;
    let t231 = t9 * (t7 * t229 + t153 * t124) + t25 * (t7 * t230 + t153 * t126);
    let t232 = t7 * (t9 * t229 + t124 * t195 + (t25 * t230 + t126 * t196)) - t231;
    let t233 = t130 * t230 - t131 * t229;
    let t234 = t126 * t195 - t124 * t196;
    let t235 = t225 * (Ic2 * t225) + t226 * (Ic1 * t226) + t227 * (Ic3 * t227) + (t232 * (Ic2 * t232) + t233 * (Ic1 * t233) + t234 * (Ic3 * t234));
    let t236 = t216 * (Ic2 * t216) + t217 * (Ic1 * t217) + t218 * (Ic3 * t218) + (mc + (mr + (ms + t235)));
    let mass_u_hC_u_hC = t197 * (Iy * t197) + t198 * (Ix * t198) + t199 * (Iz * t199) + (M * (t202 * t202 + t203 * t203 + t204 * t204) + t236);
    let t237 = 0.5_f64 * (u_hB * u_hB * mass_u_hB_u_hB + u_hA * u_hA * mass_u_hA_u_hA + u_hC * u_hC * mass_u_hC_u_hC);
    let t238 = t176 * t112 - t178 * t116 - t180 * t118 - (t186 * t128 + t188 * t132 - t190 * t134);
    let t239 = M * (t150 * t58 - t151 * t62 + t152 * t64) - (t238 - (t165 * t90 + t167 * t94 + t169 * t96));
    let mass_u_hA_u_hB = t147 * t44 - (t143 * t39 - t145 * t42) + t239;
    let t240 = t176 * t225 + t178 * t226 + t180 * t227 - (t188 * t233 - t186 * t232 + t190 * t234);
    let t241 = t169 * t218 - (t167 * t217 - t165 * t216) - t240 - M * (t150 * t202 + t151 * t203 + t152 * t204);
    let t242 = u_hA * u_hB * mass_u_hA_u_hB - u_hA * u_hC * (t147 * t199 - (t143 * t197 + t145 * t198) + t241);
    let t243 = t133 * t233 - t129 * t232 - t135 * t234 - (t119 * t227 - (t113 * t225 - t117 * t226));
    let t244 = t91 * t216 - t95 * t217 + t97 * t218 + t243 - M * (t64 * t204 - (t62 * t203 - t58 * t202));
    let t245 = t242 - u_hB * u_hC * (t40 * t197 - t43 * t198 + t45 * t199 + t244);
    let t246 = t237 + t245;
    let g = p.g;
    let heave = 0.3333333333333333_f64 * (hC + (hA + hB));
    let rise = k * t63;
    let t247 = ms + mc;
    let t248 = hB * g;
    let t249 = hC * g * t247 + (mc * t248 + (ms * t248 + hA * g * t247));
    let t250 = M * (g * (heave + rise)) + t249;
    (t246, t250)
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
///98 operations.
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
    let t4 = t2 * (2.0_f64 * (0.5_f64 * (hB + hC) - hA));
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
