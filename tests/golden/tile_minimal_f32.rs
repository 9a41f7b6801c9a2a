// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 3; the worst over 73 sampled configurations is 0.773 of its nominal size.
// Cost of rates: 2438 operations (3 abs, 505 add, 10 div, 2 min, 1477 mul, 4 sqrt, 437 sub).
// Cost of energy: 911 operations (186 add, 7 div, 584 mul, 4 sqrt, 130 sub).
// Cost of speeds: 0 operations ().
// Cost of outputs: 99 operations (18 add, 3 asin, 3 atan2, 4 div, 55 mul, 1 sqrt, 15 sub).
// Cost of projection: 0 operations ().

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f32;
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
pub const NOMINAL: [f32; 3usize] = [0f32, 0f32, 0f32];
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
            R: 0.2_f32,
            ms: 0.8_f32,
            mr: 2.0_f32,
            mc: 0.15_f32,
            Ic1: 0.0001_f32,
            Ic2: 0.0001_f32,
            Ic3: 0.0002_f32,
            M: 6.0_f32,
            Ix: 0.09_f32,
            Iy: 0.09_f32,
            Iz: 0.17_f32,
            c: 40.0_f32,
            g: 9.81_f32,
        }
    }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///2438 operations.
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
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t1 = ms + mr;
    let R = p.R;
    let t2 = 1.0_f32 / (3.0_f32 * R);
    let hC = q[2];
    let hA = q[0];
    let hB = q[1];
    let t3 = t2 * (2.0_f32 * (0.5_f32 * hC - (hA - 0.5_f32 * hB)));
    let t4 = t3 * t3;
    let t5 = t2 * (1.7320508_f32 * (hB - hC));
    let t6 = t5 * t5;
    let root = Real::sqrt(t6 + (1.0_f32 + t4));
    let t7 = 1.0_f32 + root;
    let k = 1.0_f32 / (root * t7);
    let t8 = t4 * k - 1.0_f32;
    let t9 = 1.0_f32 / root;
    let t10 = t3 * t9;
    let t11 = 1.0_f32 / Real::sqrt(1.0_f32 - t10 * t10);
    let t12 = 0.5_f32 * t11;
    let t13 = 2.0_f32 * t2;
    let t14 = 0.5_f32 * t9;
    let t15 = t13 * t3;
    let t16 = 2.0_f32 * t15;
    let t17 = t14 * t16;
    let t18 = t9 * (t13 - t10 * t17);
    let t19 = 2.0_f32 * (t10 * t18);
    let t20 = t11 * (t11 * (t12 * t19));
    let t21 = t15 + t17 * t7;
    let t22 = k * (k * t21);
    let t23 = t16 * k - t4 * t22;
    let t24 = t20 * t8 + t11 * t23;
    let t25 = t11 * t8;
    let t26 = t10 * t24 + t18 * t25;
    let t27 = t3 * k;
    let t28 = t5 * t27;
    let t29 = t13 * k - t3 * t22;
    let t30 = t5 * t29;
    let t31 = t20 * t28 + t11 * t30;
    let t32 = t11 * t28;
    let t33 = t10 * t31 + t18 * t32;
    let t34 = t8 * t24 + t23 * t25 + (t28 * t31 + t30 * t32);
    let t35 = t8 * t26 + t28 * t33 - t10 * t34;
    let Ic2 = p.Ic2;
    let t36 = Ic2 * t35;
    let t37 = t10 * t25;
    let t38 = t10 * t32;
    let t39 = t31 * t37 - t24 * t38;
    let Ic1 = p.Ic1;
    let t40 = Ic1 * t39;
    let t41 = t23 * t32 - t25 * t30;
    let Ic3 = p.Ic3;
    let t42 = Ic3 * t41;
    let t43 = t5 * t9;
    let t44 = 0.8660254_f32 * t43;
    let t45 = 0.5_f32 * t10;
    let t46 = t44 + t45;
    let t47 = 0.8660254_f32 * t28;
    let t48 = 0.5_f32 * t8;
    let t49 = t47 + t48;
    let t50 = 1.0_f32 / Real::sqrt(1.0_f32 - t46 * t46);
    let t51 = 0.8660254_f32 * t30;
    let t52 = 0.5_f32 * t23;
    let t53 = t51 + t52;
    let t54 = 0.5_f32 * t50;
    let t55 = t9 * (t17 * t43);
    let t56 = 0.8660254_f32 * t55;
    let t57 = 0.5_f32 * t18;
    let t58 = t56 - t57;
    let t59 = 2.0_f32 * (t46 * t58);
    let t60 = t50 * (t50 * (t54 * t59));
    let t61 = t50 * t53 - t60 * t49;
    let t62 = t50 * t49;
    let t63 = 1.0_f32 - t6 * k;
    let t64 = 0.8660254_f32 * t63;
    let t65 = 0.5_f32 * t28;
    let t66 = t64 - t65;
    let t67 = t6 * t22;
    let t68 = 0.8660254_f32 * t67;
    let t69 = 0.5_f32 * t30;
    let t70 = t68 - t69;
    let t71 = t50 * t70 - t60 * t66;
    let t72 = t50 * t66;
    let t73 = t49 * t61 + t53 * t62 + (t66 * t71 + t70 * t72);
    let t74 = t46 * t71 - t58 * t72;
    let t75 = t58 * t62 - t46 * t61;
    let t76 = t46 * t73 - (t66 * t74 - t49 * t75);
    let t77 = Ic2 * t76;
    let t78 = t46 * t62;
    let t79 = t46 * t72;
    let t80 = t71 * t78 - t61 * t79;
    let t81 = Ic1 * t80;
    let t82 = t62 * t70 - t53 * t72;
    let t83 = Ic3 * t82;
    let t84 = mc + t1 + (t35 * t36 + t39 * t40 + t41 * t42) + (t76 * t77 + t80 * t81 + t82 * t83);
    let t85 = t48 - t47;
    let t86 = t56 + t57;
    let dzC = t44 - t45;
    let t87 = 1.0_f32 / Real::sqrt(1.0_f32 - dzC * dzC);
    let t88 = t87 * t85;
    let t89 = t52 - t51;
    let t90 = 0.5_f32 * t87;
    let t91 = 2.0_f32 * (dzC * t86);
    let t92 = t87 * (t87 * (t90 * t91));
    let t93 = t87 * t89 - t92 * t85;
    let t94 = t86 * t88 - dzC * t93;
    let t95 = t64 + t65;
    let t96 = t68 + t69;
    let t97 = t92 * t95 - t87 * t96;
    let t98 = t87 * t95;
    let t99 = dzC * t97 + t86 * t98;
    let t100 = t85 * t93 + t89 * t88 - (t95 * t97 - t96 * t98);
    let t101 = t85 * t94 + t95 * t99 + dzC * t100;
    let t102 = Ic2 * t101;
    let t103 = dzC * t88;
    let t104 = dzC * t98;
    let t105 = t97 * t103 + t93 * t104;
    let t106 = Ic1 * t105;
    let t107 = t88 * t96 - t89 * t98;
    let t108 = Ic3 * t107;
    let M = p.M;
    let t109 = 0.5_f32 * R;
    let t110 = 1.0_f32 / t7;
    let t111 = 2.0_f32 * t3;
    let t112 = t5 * t111 * t110;
    let t113 = 4.0_f32 * t2;
    let t114 = t110 * (t17 * t112 - t113 * t5);
    let t115 = 3.0_f32 * t3;
    let cos3 = t3 * t4 - t6 * t115;
    let shift = t110 * (k * cos3);
    let t116 = 6.0_f32 * t2;
    let t117 = t3 * (3.0_f32 * t15) - t116 * t6;
    let t118 = t110 * (t17 * shift + (t22 * cos3 - k * t117));
    let t119 = t109 * (t114 + t5 * t118);
    let cos2 = t4 - t6;
    let t120 = t110 * cos2;
    let t121 = t110 * (t16 - t17 * t120);
    let t122 = t109 * (t121 + (t3 * t118 - t13 * shift));
    let t123 = t109 * cos3;
    let t124 = 0.33333334_f32 + (t22 * t123 - k * cos2);
    let t125 = t84 + (t101 * t102 + t105 * t106 + t107 * t108) + M * (t119 * t119 + t122 * t122 + t124 * t124);
    let t126 = t18 * t8 - t28 * t55 - t10 * (t8 * t67 + t23 * t63 + 2.0_f32 * (t28 * t30));
    let Iy = p.Iy;
    let t127 = Iy * t126;
    let t128 = t8 * t63 + t28 * t28;
    let t129 = t43 * t67 - t10 * t30 - t55 * t128;
    let Ix = p.Ix;
    let t130 = Ix * t129;
    let t131 = t23 * t28 - t30 * t63 + t18 * t43;
    let Iz = p.Iz;
    let t132 = Iz * t131;
    let mass_u_hA_u_hA = t125 + (t126 * t127 + t129 * t130 + t131 * t132);
    let t133 = 1.0_f32 / mass_u_hA_u_hA;
    let t134 = 1.7320508_f32 * t2;
    let t135 = 2.0_f32 * (t134 * t5);
    let t136 = k * t135;
    let t137 = root + t7;
    let t138 = t15 - t135;
    let t139 = t14 * t138;
    let t140 = t137 * t139;
    let t141 = k * (k * t140);
    let t142 = t136 + t6 * t141;
    let t143 = 0.8660254_f32 * t142;
    let t144 = t134 * t27;
    let t145 = t96 - t144;
    let t146 = 0.5_f32 * t145;
    let t147 = t143 + t146;
    let t148 = t15 * k;
    let t149 = t148 - t4 * t141;
    let t150 = 0.5_f32 * t149;
    let t151 = 0.8660254_f32 * t145;
    let t152 = t150 - t151;
    let t153 = t88 * t147 - t98 * t152;
    let t154 = t9 * (t134 + t43 * t139);
    let t155 = 0.8660254_f32 * t154;
    let t156 = 0.5_f32 * t86;
    let t157 = t155 + t156;
    let t158 = 2.0_f32 * (dzC * t157);
    let t159 = t90 * t158;
    let t160 = t87 * (t87 * t159);
    let t161 = t87 * t147 - t95 * t160;
    let t162 = t85 * t160 - t87 * t152;
    let t163 = t103 * t161 + t104 * t162;
    let t164 = dzC * t162 + t88 * t157;
    let t165 = t98 * t157 - dzC * t161;
    let t166 = t88 * t152 - t85 * t162 + (t95 * t161 + t98 * t147);
    let t167 = t85 * t164 + t95 * t165 + dzC * t166;
    let t168 = t156 - t155;
    let t169 = 2.0_f32 * (t46 * t168);
    let t170 = t50 * (t50 * (t54 * t169));
    let t171 = t151 + t150;
    let t172 = t49 * t170 + t50 * t171;
    let t173 = t46 * t172 + t62 * t168;
    let t174 = t146 - t143;
    let t175 = t50 * t174 - t66 * t170;
    let t176 = t72 * t168 - t46 * t175;
    let t177 = t66 * t175 + t72 * t174 - (t49 * t172 + t62 * t171);
    let t178 = t49 * t173 + t66 * t176 + t46 * t177;
    let t179 = t78 * t175 + t79 * t172;
    let t180 = t72 * t171 + t62 * t174;
    let t181 = 2.0_f32 * (t10 * t86);
    let t182 = t11 * (t11 * (t12 * t181));
    let t183 = t28 * t182 + t11 * t145;
    let t184 = t8 * t182 + t11 * t149;
    let t185 = t37 * t183 - t38 * t184;
    let t186 = t8 * t184 + t25 * t149 + (t28 * t183 + t32 * t145);
    let t187 = t10 * t184 + t25 * t86;
    let t188 = t10 * t183 + t32 * t86;
    let t189 = t10 * t186 - (t8 * t187 + t28 * t188);
    let t190 = t32 * t149 - t25 * t145;
    let t191 = t77 * t178 + t81 * t179 + t83 * t180 - (t40 * t185 - t36 * t189 + t42 * t190);
    let t192 = t13 * t5;
    let t193 = t134 * t111;
    let t194 = t110 * (t192 - t193 - t112 * t139);
    let t195 = t134 * shift;
    let t196 = 3.0_f32 * t2;
    let t197 = t196 * t4;
    let t198 = t115 * t135;
    let t199 = t196 * t6;
    let t200 = t197 + (t198 - t199);
    let t201 = t110 * (shift * t139 + (cos3 * t141 - k * t200));
    let t202 = t109 * (t194 - (t195 + t5 * t201));
    let t203 = t15 + t135;
    let t204 = t110 * (t120 * t139 - t203);
    let t205 = t2 * shift;
    let t206 = t109 * (t204 + (t205 - t3 * t201));
    let t207 = t109 * t200;
    let t208 = 0.33333334_f32 + (k * t207 - t123 * t141);
    let t209 = t108 * t153 - (t106 * t163 - t102 * t167) - t191 - M * (t119 * t202 + t122 * t206 + t124 * t208);
    let t210 = t28 * t149 - t63 * t145 + t43 * t86;
    let t211 = t28 * t154 - t8 * t86 + t10 * (t8 * t142 + t63 * t149 + 2.0_f32 * (t28 * t145));
    let t212 = t10 * t145 - t43 * t142 + t128 * t154;
    let t213 = t209 + (t132 * t210 - (t127 * t211 + t130 * t212));
    let t214 = t133 * t213;
    let FC = inputs[2];
    let c = p.c;
    let t215 = t14 * t203;
    let t216 = t9 * (t43 * t215 - t134);
    let t217 = t70 - t144;
    let t218 = t215 * t137;
    let t219 = k * (k * t218);
    let t220 = t136 - t6 * t219;
    let t221 = t128 * t216 - (t10 * t217 - t43 * t220);
    let t222 = u_hC * t212 + (u_hB * t221 + u_hA * t129);
    let t223 = t4 * t219 - t148;
    let t224 = t10 * (t8 * t220 + t63 * t223 + 2.0_f32 * (t28 * t217)) - (t8 * t58 + t28 * t216);
    let t225 = u_hC * t211 + (u_hA * t126 - u_hB * t224);
    let t226 = u_hC * t145 - (u_hB * t217 + u_hA * t30);
    let t227 = u_hC * t149 - (u_hB * t223 + u_hA * t23);
    let t228 = t2 * (1.7320508_f32 * (u_hC - u_hB));
    let t229 = 2.0_f32 * (t5 * t228);
    let t230 = t2 * (2.0_f32 * (0.5_f32 * u_hC + (0.5_f32 * u_hB - u_hA)));
    let t231 = 2.0_f32 * (t3 * t230);
    let t232 = t14 * (t229 - t231);
    let t233 = k * (k * (t137 * t232));
    let t234 = t6 * t233 - k * t229;
    let t235 = t227 + t234;
    let t236 = u_hB * t58 + u_hA * t18 - u_hC * t86;
    let t237 = t9 * (t228 - t43 * t232);
    let t238 = t21 * t233;
    let t239 = t13 * t230;
    let t240 = t9 * (t14 * t232);
    let t241 = 2.0_f32 * t239;
    let t242 = t16 * t240 + t14 * t241;
    let t243 = k * (t238 + (k * (t239 - (t17 * t232 - t7 * t242)) + t238));
    let t244 = t22 * t229 - t6 * t243;
    let t245 = 0.8660254_f32 * t244;
    let t246 = t5 * (t13 * t233 - (t3 * t243 + t22 * t230)) - t29 * t228;
    let t247 = 0.5_f32 * t246;
    let t248 = t245 - t247;
    let t249 = t3 * t233 + k * t230;
    let t250 = t134 * t249;
    let t251 = t248 + t250;
    let t252 = t245 + t247;
    let t253 = t250 + t252;
    let t254 = u_hC * t251 - (u_hB * t253 - u_hA * t246);
    let t255 = t140 * t233;
    let t256 = t134 * t228;
    let t257 = t2 * t230;
    let t258 = 2.0_f32 * t256;
    let t259 = t239 + t258;
    let t260 = t14 * t259 + t138 * t240;
    let t261 = k * (t255 + (k * (t256 + t257 - (t139 * t232 - t7 * t260)) + t255));
    let t262 = k * t239 + t15 * t233;
    let t263 = t4 * t261 + t141 * t231 - t262;
    let t264 = t218 * t233;
    let t265 = t239 - t258;
    let t266 = t14 * t265 + t203 * t240;
    let t267 = k * (t264 + (k * (t257 - t256 - (t215 * t232 - t7 * t266)) + t264));
    let t268 = t4 * t267 + t219 * t231 - t262;
    let t269 = k * t241 + t16 * t233 - (t4 * t243 + t22 * t231);
    let t270 = u_hC * t263 + (u_hB * t268 + u_hA * t269);
    let t271 = t9 * (t17 * t237 - t43 * t242 - t55 * t232);
    let t272 = 0.8660254_f32 * t271;
    let t273 = t9 * (t10 * (2.0_f32 * t242) - t18 * t232);
    let t274 = 0.5_f32 * t273;
    let t275 = t272 - t274;
    let t276 = t272 + t274;
    let t277 = u_hB * t275 + u_hA * t273 - u_hC * t276;
    let t278 = t226 * t235 + t236 * t237 + (t63 * t254 - t28 * t270 + t43 * t277);
    let t279 = t222 * t225 * (Ix - Iy) + Iz * t278;
    let t280 = t28 * t223 - t63 * t217 + t43 * t58;
    let t281 = u_hC * t210 - (u_hB * t280 + u_hA * t131);
    let t282 = t9 * (t230 + t10 * t232);
    let t283 = t9 * (t154 * t232 + (t43 * t260 - t139 * t237));
    let t284 = t9 * (t215 * t237 - t43 * t266 - t216 * t232);
    let t285 = u_hC * t283 - (u_hB * t284 - u_hA * t271);
    let t286 = t5 * t249 - t27 * t228;
    let t287 = k * t258 - t135 * t233;
    let t288 = t141 * t229 - t6 * t261 + t287;
    let t289 = t4 * t233 + k * t231;
    let t290 = 2.0_f32 * (t145 * t286 - t28 * t251) - (t8 * t288 - t142 * t289 + (t63 * t263 + t149 * t234));
    let t291 = t287 - (t219 * t229 - t6 * t267);
    let t292 = 2.0_f32 * (t217 * t286 - t28 * t253) - (t8 * t291 - t220 * t289 - (t63 * t268 - t223 * t234));
    let t293 = t67 * t289 - t8 * t244 + (t63 * t269 - t23 * t234) + 2.0_f32 * (t28 * t246 + t30 * t286);
    let t294 = t28 * t285 - t8 * t277 + t10 * (u_hC * t290 - (u_hB * t292 + u_hA * t293));
    let t295 = (Ix - Iz) * (t281 * t222) + Iy * (t227 * t282 - t226 * t237 + t236 * t235 - t294);
    let t296 = t10 * t254 + t43 * (u_hB * t291 + u_hA * t244 - u_hC * t288) - t128 * t285;
    let t297 = Ix * (t237 * t234 - t226 * t282 - t237 * t235 + t296) - t281 * t225 * (Iy - Iz);
    let t298 = Ic1 - Ic3;
    let t299 = t25 * t217 - t32 * t223;
    let t300 = u_hA * t41 - u_hB * t299 - u_hC * t190;
    let t301 = 2.0_f32 * (t10 * t58);
    let t302 = t12 * t301;
    let t303 = t11 * (t11 * t302);
    let t304 = t28 * t303 + t11 * t217;
    let t305 = t8 * t303 + t11 * t223;
    let t306 = t37 * t304 - t38 * t305;
    let t307 = u_hB * t306 + u_hA * t39 - u_hC * t185;
    let t308 = t12 * (2.0_f32 * (t10 * t282));
    let t309 = t11 * (t11 * t308);
    let t310 = t182 * t308;
    let t311 = t11 * (t12 * t308);
    let t312 = t11 * (t12 * (2.0_f32 * (t10 * t276 - t86 * t282)) - t181 * t311) - t310;
    let t313 = t11 * (t310 - t312);
    let t314 = t11 * t263 - t149 * t309 - (t8 * t313 + t182 * t289);
    let t315 = t8 * t309 + t11 * t289;
    let t316 = t28 * t313 + t182 * t286 + (t145 * t309 - t11 * t251);
    let t317 = t28 * t309 + t11 * t286;
    let t318 = t184 * t289 - t8 * t314 + (t149 * t315 - t25 * t263) + (t28 * t316 + t183 * t286 + (t145 * t317 - t32 * t251));
    let t319 = t302 * t309;
    let t320 = t11 * (t12 * (2.0_f32 * (t58 * t282 - t10 * t275)) + t301 * t311) + t319;
    let t321 = t11 * (t319 + t320);
    let t322 = t28 * t321 + t303 * t286 - (t11 * t253 - t217 * t309);
    let t323 = t8 * t321 + t303 * t289 + (t11 * t268 + t223 * t309);
    let t324 = t32 * t253 - t217 * t317 - (t28 * t322 + t304 * t286) - (t8 * t323 + t305 * t289 + (t25 * t268 + t223 * t315));
    let t325 = t20 * t308;
    let t326 = t325 - t11 * (t12 * (2.0_f32 * (t10 * t273 - t18 * t282)) - t19 * t311);
    let t327 = t11 * (t325 + t326);
    let t328 = t8 * t327 + t20 * t289 + (t11 * t269 + t23 * t309);
    let t329 = t28 * t327 + t20 * t286 + (t11 * t246 + t30 * t309);
    let t330 = t8 * t328 + t24 * t289 + (t25 * t269 + t23 * t315) + (t28 * t329 + t31 * t286 + (t32 * t246 + t30 * t317));
    let t331 = u_hA * (t25 * t273 - t18 * t315 - (t10 * t328 + t24 * t282)) - u_hB * (t10 * t323 + t305 * t282 + (t58 * t315 - t25 * t275));
    let t332 = t331 - u_hC * (t25 * t276 - t86 * t315 - (t184 * t282 - t10 * t314));
    let t333 = u_hA * (t10 * t329 + t31 * t282 + (t18 * t317 - t32 * t273)) - u_hB * (t32 * t275 - t58 * t317 - (t10 * t322 + t304 * t282));
    let t334 = u_hC * (t10 * t316 + t183 * t282 - (t32 * t276 - t86 * t317)) - t333;
    let t335 = t10 * (u_hC * t318 + (u_hB * t324 - u_hA * t330)) - (t8 * t332 + t28 * t334);
    let t336 = t10 * t304 + t32 * t58;
    let t337 = u_hC * t188 - (u_hB * t336 + u_hA * t33);
    let t338 = t10 * t305 + t25 * t58;
    let t339 = u_hB * t338 + u_hA * t26 - u_hC * t187;
    let t340 = t8 * t305 + t25 * t223 + (t28 * t304 + t32 * t217);
    let t341 = t337 * t226 - t339 * t227 - (u_hB * t340 + u_hA * t34 - u_hC * t186) * t236;
    let t342 = t298 * (t300 * t307) - Ic2 * (t335 - t341);
    let t343 = t8 * t338 + t28 * t336 - t10 * t340;
    let t344 = u_hC * t189 + (u_hB * t343 + u_hA * t35);
    let t345 = Ic2 - Ic3;
    let t346 = u_hC * t183 - (u_hB * t304 + u_hA * t31);
    let t347 = u_hB * t305 + u_hA * t24 - u_hC * t184;
    let t348 = t37 * (u_hB * t322 + u_hA * t329 - u_hC * t316) - t38 * (u_hC * t314 + (u_hB * t323 + u_hA * t328));
    let t349 = t300 * t344 * t345 + Ic1 * (t339 * t346 - t337 * t347 + t348);
    let t350 = Ic1 - Ic2;
    let t351 = Ic3 * (t227 * t346 + t226 * t347 + (t25 * t254 - t32 * t270)) - t307 * t344 * t350;
    let g = p.g;
    let t352 = ms * g;
    let t353 = 0.8660254_f32 * t216 + 0.5_f32 * t58;
    let t354 = 2.0_f32 * (t46 * t353);
    let t355 = t54 * t354;
    let t356 = t50 * (t50 * t355);
    let t357 = 0.8660254_f32 * t220;
    let t358 = 0.5_f32 * t217;
    let t359 = t357 - t358;
    let t360 = t66 * t356 + t50 * t359;
    let t361 = 0.8660254_f32 * t217;
    let t362 = 0.5_f32 * t223;
    let t363 = t361 + t362;
    let t364 = t49 * t356 + t50 * t363;
    let t365 = t78 * t360 - t79 * t364;
    let t366 = u_hC * t179 + (u_hB * t365 + u_hA * t80);
    let t367 = t46 * t364 + t62 * t353;
    let t368 = t46 * t360 + t72 * t353;
    let t369 = t49 * t364 + t62 * t363 + (t66 * t360 + t72 * t359);
    let t370 = t49 * t367 + t66 * t368 - t46 * t369;
    let t371 = u_hB * t370 - u_hA * t76 - u_hC * t178;
    let t372 = u_hB * t363 + u_hA * t53 - u_hC * t171;
    let t373 = u_hC * t175 + (u_hB * t360 + u_hA * t71);
    let t374 = u_hC * t174 + (u_hB * t359 + u_hA * t70);
    let t375 = u_hC * t172 - (u_hB * t364 + u_hA * t61);
    let t376 = 0.5_f32 * t253;
    let t377 = 0.8660254_f32 * t291;
    let t378 = t376 - t377;
    let t379 = 0.5_f32 * t251;
    let t380 = 0.8660254_f32 * t288;
    let t381 = t379 - t380;
    let t382 = 0.8660254_f32 * t251;
    let t383 = 0.5_f32 * t263;
    let t384 = t382 + t383;
    let t385 = 0.5_f32 * t268;
    let t386 = 0.8660254_f32 * t253;
    let t387 = t385 - t386;
    let t388 = 0.8660254_f32 * t246;
    let t389 = 0.5_f32 * t269;
    let t390 = t388 + t389;
    let t391 = t62 * (u_hB * t378 - u_hA * t252 - u_hC * t381) - t72 * (u_hC * t384 + (u_hB * t387 + u_hA * t390));
    let t392 = t350 * (t366 * t371) - Ic3 * (t372 * t373 + t374 * t375 + t391);
    let t393 = u_hC * t173 + (u_hA * t75 - u_hB * t367);
    let t394 = u_hC * t176 - (u_hB * t368 + u_hA * t74);
    let t395 = 0.5_f32 * t282;
    let t396 = 0.8660254_f32 * t237;
    let t397 = t395 - t396;
    let t398 = t54 * (2.0_f32 * (t46 * t397));
    let t399 = t170 * t398;
    let t400 = t50 * (t54 * t398);
    let t401 = 0.8660254_f32 * t284;
    let t402 = 0.5_f32 * t275;
    let t403 = t401 - t402;
    let t404 = t50 * (t169 * t400 - t54 * (2.0_f32 * (t46 * t403 - t168 * t397))) + t399;
    let t405 = t50 * (t399 + t404);
    let t406 = 0.8660254_f32 * t286;
    let t407 = 0.5_f32 * t289;
    let t408 = t406 + t407;
    let t409 = t50 * (t50 * t398);
    let t410 = t49 * t405 + t170 * t408 - (t50 * t384 - t171 * t409);
    let t411 = t355 * t409;
    let t412 = t401 + t402;
    let t413 = t50 * (t354 * t400 - t54 * (2.0_f32 * (t46 * t412 - t353 * t397))) + t411;
    let t414 = t50 * (t411 + t413);
    let t415 = t49 * t414 + t356 * t408 + (t50 * t387 + t363 * t409);
    let t416 = t60 * t398;
    let t417 = t50 * (t59 * t400 + t54 * (2.0_f32 * (t58 * t397 - t46 * t275))) + t416;
    let t418 = t50 * (t416 + t417);
    let t419 = t50 * t390 + t53 * t409 - (t49 * t418 + t60 * t408);
    let t420 = 0.8660254_f32 * t234;
    let t421 = 0.5_f32 * t286;
    let t422 = t420 + t421;
    let t423 = t66 * t405 - t170 * t422 + (t50 * t381 - t174 * t409);
    let t424 = t66 * t418 - t60 * t422 + (t50 * t252 - t70 * t409);
    let t425 = t50 * t378 + t359 * t409 - (t356 * t422 - t66 * t414);
    let t426 = t79 * (u_hC * t410 - (u_hB * t415 + u_hA * t419)) - t78 * (u_hC * t423 + (u_hA * t424 - u_hB * t425));
    let t427 = t62 * t359 - t72 * t363;
    let t428 = u_hC * t180 + (u_hB * t427 + u_hA * t82);
    let t429 = Ic1 * (t393 * t373 + t394 * t375 + t426) - t345 * (t428 * t371);
    let t430 = t393 * t372 + t394 * t374 - (u_hC * t177 + (u_hB * t369 + u_hA * t73)) * t397;
    let t431 = t49 * t409 + t50 * t408;
    let t432 = t50 * t422 - t66 * t409;
    let t433 = t49 * t415 + t364 * t408 + (t62 * t387 + t363 * t431) + (t72 * t378 - t359 * t432 - (t360 * t422 - t66 * t425));
    let t434 = t49 * t419 + t61 * t408 + (t62 * t390 + t53 * t431) - (t66 * t424 + t71 * t422 + (t72 * t252 + t70 * t432));
    let t435 = t49 * t410 + t172 * t408 + (t171 * t431 - t62 * t384) + (t66 * t423 + t175 * t422 + (t72 * t381 + t174 * t432));
    let t436 = u_hB * (t46 * t425 + t360 * t397 - (t72 * t412 + t353 * t432)) + u_hA * (t72 * t275 + t58 * t432 - (t46 * t424 - t71 * t397));
    let t437 = u_hC * (t175 * t397 - t46 * t423 + (t72 * t403 + t168 * t432)) + t436;
    let t438 = u_hB * (t46 * t415 + t364 * t397 + (t353 * t431 - t62 * t412)) + u_hA * (t46 * t419 + t61 * t397 + (t62 * t275 - t58 * t431));
    let t439 = u_hC * (t46 * t410 + t172 * t397 + (t168 * t431 - t62 * t403)) - t438;
    let t440 = t46 * (u_hB * t433 + u_hA * t434 - u_hC * t435) - (t66 * t437 - t49 * t439);
    let t441 = t298 * (t428 * t366) + Ic2 * (t430 - t440);
    let t442 = t189 * t342 + t185 * t349 - t190 * t351 - t352 + (t180 * t392 - (t179 * t429 - t178 * t441));
    let t443 = mc * g;
    let t444 = t357 + t358;
    let t445 = t362 - t361;
    let t446 = t88 * t444 - t98 * t445;
    let t447 = u_hB * t446 + u_hA * t107 - u_hC * t153;
    let t448 = 2.0_f32 * (dzC * t168);
    let t449 = t87 * (t87 * (t90 * t448));
    let t450 = t85 * t449 + t87 * t445;
    let t451 = t95 * t449 + t87 * t444;
    let t452 = t104 * t450 - t103 * t451;
    let t453 = u_hC * t163 + (u_hB * t452 + u_hA * t105);
    let t454 = 0.8660254_f32 * t283 - 0.5_f32 * t276;
    let t455 = t396 + t395;
    let t456 = t90 * (2.0_f32 * (dzC * t455));
    let t457 = t87 * (t87 * t456);
    let t458 = t407 - t406;
    let t459 = t85 * t457 - t87 * t458;
    let t460 = t159 * t457;
    let t461 = t87 * (t90 * t456);
    let t462 = t87 * (t90 * (2.0_f32 * (t157 * t455 - dzC * t454)) + t158 * t461) + t460;
    let t463 = t87 * (t460 + t462);
    let t464 = t383 - t382;
    let t465 = t160 * t458 - t85 * t463 + (t87 * t464 + t152 * t457);
    let t466 = t92 * t456;
    let t467 = t87 * (t91 * t461 + t90 * (2.0_f32 * (dzC * t276 + t86 * t455))) + t466;
    let t468 = t87 * (t466 + t467);
    let t469 = t388 - t389;
    let t470 = t92 * t458 - t85 * t468 + (t87 * t469 + t89 * t457);
    let t471 = t386 + t385;
    let t472 = t449 * t456;
    let t473 = t87 * (t90 * (2.0_f32 * (dzC * t403 + t168 * t455)) + t448 * t461) + t472;
    let t474 = t87 * (t472 + t473);
    let t475 = t87 * t471 - t445 * t457 - (t85 * t474 - t449 * t458);
    let t476 = u_hA * (t88 * t276 + t86 * t459 - (dzC * t470 + t93 * t455)) - u_hB * (t450 * t455 - dzC * t475 + (t88 * t403 + t168 * t459));
    let t477 = u_hC * (t88 * t454 - t157 * t459 - (t162 * t455 - dzC * t465)) + t476;
    let t478 = t420 - t421;
    let t479 = t95 * t457 + t87 * t478;
    let t480 = t380 + t379;
    let t481 = t95 * t463 + t160 * t478 - (t87 * t480 + t147 * t457);
    let t482 = t377 + t376;
    let t483 = t95 * t474 + t449 * t478 + (t87 * t482 + t444 * t457);
    let t484 = t87 * t248 + t96 * t457 - (t95 * t468 + t92 * t478);
    let t485 = u_hB * (dzC * t483 + t451 * t455 + (t98 * t403 + t168 * t479)) - u_hA * (t97 * t455 - dzC * t484 + (t98 * t276 + t86 * t479));
    let t486 = u_hC * (t157 * t479 - t98 * t454 - (t161 * t455 - dzC * t481)) + t485;
    let t487 = t85 * t465 + t162 * t458 + (t88 * t464 + t152 * t459) + (t161 * t478 - t95 * t481 + (t98 * t480 + t147 * t479));
    let t488 = t93 * t458 - t85 * t470 - (t88 * t469 + t89 * t459) - (t95 * t484 - t97 * t478 + (t98 * t248 + t96 * t479));
    let t489 = t95 * t483 + t451 * t478 + (t98 * t482 + t444 * t479) - (t85 * t475 + t450 * t458 + (t88 * t471 - t445 * t459));
    let t490 = t85 * t477 - t95 * t486 - dzC * (u_hC * t487 + (u_hA * t488 - u_hB * t489));
    let t491 = dzC * t451 + t98 * t168;
    let t492 = u_hC * t165 - (u_hA * t99 - u_hB * t491);
    let t493 = u_hB * t444 + u_hA * t96 - u_hC * t147;
    let t494 = dzC * t450 + t88 * t168;
    let t495 = u_hC * t164 + (u_hB * t494 - u_hA * t94);
    let t496 = u_hC * t152 - (u_hB * t445 + u_hA * t89);
    let t497 = t85 * t450 + t88 * t445 + (t95 * t451 + t98 * t444);
    let t498 = t492 * t493 - t495 * t496 + (u_hC * t166 - (u_hB * t497 + u_hA * t100)) * t455;
    let t499 = t298 * (t447 * t453) - Ic2 * (t490 - t498);
    let t500 = dzC * t497 - (t85 * t494 + t95 * t491);
    let t501 = u_hB * t500 + u_hA * t101 - u_hC * t167;
    let t502 = u_hC * t161 - (u_hB * t451 - u_hA * t97);
    let t503 = u_hC * t162 + (u_hB * t450 + u_hA * t93);
    let t504 = t103 * (u_hC * t481 + (u_hB * t483 + u_hA * t484)) + t104 * (u_hC * t465 + (u_hB * t475 - u_hA * t470));
    let t505 = t345 * (t447 * t501) + Ic1 * (t495 * t502 + t492 * t503 - t504);
    let t506 = t98 * (u_hA * t469 - u_hB * t471 - u_hC * t464) + t88 * (u_hC * t480 - (u_hB * t482 + u_hA * t248));
    let t507 = t350 * (t453 * t501) - Ic3 * (t496 * t502 - t493 * t503 + t506);
    let t508 = t110 * (t192 + t193 - t112 * t215);
    let t509 = 2.0_f32 * t230;
    let t510 = t134 * t509;
    let t511 = t13 * t228;
    let t512 = t110 * (t112 * t232 - (t111 * t228 - t5 * t509));
    let t513 = 3.0_f32 * t230;
    let t514 = t6 * t513 - t115 * t229 - (t3 * t231 + t4 * t230);
    let t515 = t110 * (shift * t232 + (cos3 * t233 - k * t514));
    let t516 = t134 * t515;
    let t517 = t197 - (t199 + t198);
    let t518 = t110 * (k * t517 - cos3 * t219 - shift * t215);
    let t519 = t15 * t513;
    let t520 = t135 * t513 - t115 * t258;
    let t521 = t196 * t229;
    let t522 = t519 - (t520 - t521);
    let t523 = k * t522 + t517 * t233 + (t219 * t514 - cos3 * t267) - (shift * t266 + t215 * t515);
    let t524 = t110 * (t518 * t232 + t523);
    let t525 = t110 * (t508 * t232 + (t510 - t511 - (t112 * t266 + t215 * t512))) + (t516 + (t5 * t524 - t518 * t228));
    let t526 = t229 + t231;
    let t527 = k * (t116 * t526) + t117 * t233 + (t22 * t514 - cos3 * t243) - (shift * t242 + t17 * t515);
    let t528 = t110 * (t527 - t118 * t232);
    let t529 = t5 * t528 + t118 * t228 - t110 * (t114 * t232 + (t112 * t242 + t17 * t512 + t113 * t228));
    let t530 = t521 + t520 + t519;
    let t531 = shift * t260 + t139 * t515 - (k * t530 + t200 * t233 - (cos3 * t261 - t141 * t514));
    let t532 = t110 * (t201 * t232 + t531);
    let t533 = t5 * t532 - t201 * t228 + t516 - t110 * (t194 * t232 - (t112 * t260 + t139 * t512 + (t511 + t510)));
    let t534 = u_hB * (t109 * t525) - u_hA * (t109 * t529) - u_hC * (t109 * t533);
    let t535 = t110 * (t526 + t120 * t232);
    let t536 = t2 * t515;
    let t537 = t110 * (t265 - (t120 * t260 + t139 * t535) - t204 * t232) + (t3 * t532 + t201 * t230 - t536);
    let t538 = t110 * (t138 - t120 * t215);
    let t539 = t536 + (t3 * t524 + t518 * t230) - t110 * (t538 * t232 - (t120 * t266 + t215 * t535 - t259));
    let t540 = t110 * (t120 * t242 + t17 * t535 - t241 - t121 * t232) + (t3 * t528 - t118 * t230 + t13 * t515);
    let t541 = u_hC * (t109 * t537) - (u_hB * (t109 * t539) - u_hA * (t109 * t540));
    let t542 = t109 * t514;
    let t543 = u_hC * (k * (t109 * t530) + t207 * t233 + (t141 * t542 - t123 * t261));
    let t544 = t109 * t517;
    let t545 = u_hB * (k * (t109 * t522) + t544 * t233 + (t219 * t542 - t123 * t267));
    let t546 = t545 + u_hA * (t123 * t243 - t22 * t542 - (k * t526 + cos2 * t233));
    let t547 = g + (t543 + t546);
    let t548 = t442 - t443 + (t167 * t499 + t163 * t505 - t153 * t507) - M * (t202 * t534 - t206 * t541 + t208 * t547);
    let forcing_u_hC = FC - u_hC * c - (t210 * t279 - (t211 * t295 + t212 * t297) - t548);
    let t549 = t76 * t441 - t80 * t429 + t82 * t392 - (t352 + t443 + (t39 * t349 - t35 * t342 - t41 * t351));
    let t550 = M * (t119 * t534 - t122 * t541 + t124 * t547) - (t549 + (t105 * t505 - t101 * t499 + t107 * t507));
    let FA = inputs[0];
    let t551 = t550 - (t126 * t295 + t129 * t297 + t131 * t279) + (u_hA * c - FA);
    let t552 = Ic2 * t343;
    let t553 = Ic1 * t306;
    let t554 = Ic3 * t299;
    let t555 = Ic2 * t370;
    let t556 = Ic1 * t365;
    let t557 = Ic3 * t427;
    let t558 = mc + (t1 + (t343 * t552 + t306 * t553 + t299 * t554)) + (t370 * t555 + t365 * t556 + t427 * t557);
    let t559 = Ic2 * t500;
    let t560 = Ic1 * t452;
    let t561 = Ic3 * t446;
    let t562 = t109 * (t508 + (t5 * t518 + t195));
    let t563 = t109 * (t538 - (t3 * t518 + t205));
    let t564 = 0.33333334_f32 + (k * t544 - t123 * t219);
    let t565 = t558 + (t500 * t559 + t452 * t560 + t446 * t561) + M * (t562 * t562 + t563 * t563 + t564 * t564);
    let t566 = Iy * t224;
    let t567 = Ix * t221;
    let t568 = Iz * t280;
    let mass_u_hB_u_hB = t565 + (t224 * t566 + t221 * t567 + t280 * t568);
    let t569 = t77 * t370 - t81 * t365 - t83 * t427 - (t36 * t343 + t40 * t306 - t42 * t299);
    let t570 = M * (t119 * t562 - t122 * t563 + t124 * t564) - (t569 - (t102 * t500 + t106 * t452 + t108 * t446));
    let mass_u_hA_u_hB = t570 + (t132 * t280 - (t127 * t224 - t130 * t221));
    let t571 = t133 * mass_u_hA_u_hB;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t571;
    let t572 = 1.0_f32 / pivot_1;
    let t573 = t553 * t185 - t552 * t189 - t554 * t190 - (t557 * t180 - (t555 * t178 - t556 * t179));
    let t574 = t573 + (t559 * t167 - t560 * t163 + t561 * t153) - M * (t564 * t208 - (t563 * t206 - t562 * t202));
    let t575 = t574 + (t566 * t211 - t567 * t212 + t568 * t210) - t571 * t213;
    let t576 = t572 * t575;
    let t577 = t443 + (t352 + (t299 * t351 - (t343 * t342 - t306 * t349))) - (t427 * t392 - (t370 * t441 + t365 * t429));
    let t578 = t577 - (t452 * t505 - t500 * t499 + t446 * t507) + M * (t562 * t534 + t563 * t541 + t564 * t547);
    let FB = inputs[1];
    let t579 = t578 - (t280 * t279 - (t224 * t295 - t221 * t297)) + (u_hB * c - FB);
    let t580 = t579 - t571 * t551;
    let t581 = t1 + (t189 * (Ic2 * t189) + t185 * (Ic1 * t185) + t190 * (Ic3 * t190));
    let t582 = t581 + (t178 * (Ic2 * t178) + t179 * (Ic1 * t179) + t180 * (Ic3 * t180));
    let t583 = mc + t582 + (t167 * (Ic2 * t167) + t163 * (Ic1 * t163) + t153 * (Ic3 * t153));
    let mass_u_hC_u_hC = t583 + M * (t202 * t202 + t206 * t206 + t208 * t208) + (t211 * (Iy * t211) + t212 * (Ix * t212) + t210 * (Iz * t210));
    let pivot_2 = mass_u_hC_u_hC - t213 * t214 - t575 * t576;
    let t584 = (forcing_u_hC - t214 * t551 - t576 * t580) / pivot_2;
    let t585 = t572 * t580;
    let t586 = t576 * t584;
    let t587 = t214 * t584 - (t133 * t551 - t571 * (t585 - t586));
    let t588 = t586 - t585;
    let t589 = Real::min(Real::min(0.21652833_f32 * Real::abs(mass_u_hA_u_hA), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t587, t588, t584], t589)
}
///Kinetic and potential energy (J).
///
///911 operations.
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
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t1 = ms + mr;
    let R = p.R;
    let t2 = 1.0_f32 / (3.0_f32 * R);
    let hC = q[2];
    let hA = q[0];
    let hB = q[1];
    let t3 = t2 * (2.0_f32 * (0.5_f32 * hC - (hA - 0.5_f32 * hB)));
    let t4 = t2 * (1.7320508_f32 * (hB - hC));
    let t5 = t4 * t4;
    let t6 = t3 * t3;
    let root = Real::sqrt(t5 + (1.0_f32 + t6));
    let t7 = 1.0_f32 / root;
    let t8 = t3 * t7;
    let t9 = 1.0_f32 + root;
    let k = 1.0_f32 / (root * t9);
    let t10 = t6 * k - 1.0_f32;
    let t11 = 1.0_f32 / Real::sqrt(1.0_f32 - t8 * t8);
    let t12 = 0.5_f32 * t11;
    let t13 = 0.5_f32 * t7;
    let t14 = 2.0_f32 * t2;
    let t15 = t14 * t3;
    let t16 = 2.0_f32 * t15;
    let t17 = t13 * t16;
    let t18 = t4 * t7;
    let t19 = t7 * (t17 * t18);
    let t20 = 0.8660254_f32 * t19;
    let t21 = t7 * (t14 - t8 * t17);
    let t22 = 0.5_f32 * t21;
    let t23 = t20 + t22;
    let t24 = t11 * (t11 * (t12 * (2.0_f32 * (t8 * t23))));
    let t25 = t15 * k;
    let t26 = root + t9;
    let t27 = 1.7320508_f32 * t2;
    let t28 = 2.0_f32 * (t27 * t4);
    let t29 = t15 - t28;
    let t30 = t13 * t29;
    let t31 = k * (k * (t26 * t30));
    let t32 = t25 - t6 * t31;
    let t33 = t10 * t24 + t11 * t32;
    let t34 = t11 * t10;
    let t35 = t3 * k;
    let t36 = t4 * t35;
    let t37 = k * (k * (t15 + t17 * t9));
    let t38 = t5 * t37;
    let t39 = 0.8660254_f32 * t38;
    let t40 = t4 * (t14 * k - t3 * t37);
    let t41 = 0.5_f32 * t40;
    let t42 = t39 + t41;
    let t43 = t27 * t35;
    let t44 = t42 - t43;
    let t45 = t36 * t24 + t11 * t44;
    let t46 = t11 * t36;
    let t47 = t10 * (t8 * t33 + t34 * t23) + t36 * (t8 * t45 + t46 * t23);
    let t48 = t8 * (t10 * t33 + t34 * t32 + (t36 * t45 + t46 * t44)) - t47;
    let Ic2 = p.Ic2;
    let t49 = t8 * t34;
    let t50 = t8 * t46;
    let t51 = t49 * t45 - t50 * t33;
    let Ic1 = p.Ic1;
    let t52 = t46 * t32 - t34 * t44;
    let Ic3 = p.Ic3;
    let t53 = t1 + (t48 * (Ic2 * t48) + t51 * (Ic1 * t51) + t52 * (Ic3 * t52));
    let t54 = 0.8660254_f32 * t36;
    let t55 = 0.5_f32 * t10;
    let t56 = t54 + t55;
    let t57 = 0.8660254_f32 * t18;
    let t58 = 0.5_f32 * t8;
    let t59 = t57 + t58;
    let t60 = 1.0_f32 / Real::sqrt(1.0_f32 - t59 * t59);
    let t61 = 0.5_f32 * t60;
    let t62 = 0.5_f32 * t23;
    let t63 = t7 * (t27 + t18 * t30);
    let t64 = 0.8660254_f32 * t63;
    let t65 = t62 - t64;
    let t66 = t60 * (t60 * (t61 * (2.0_f32 * (t59 * t65))));
    let t67 = 0.8660254_f32 * t44;
    let t68 = 0.5_f32 * t32;
    let t69 = t67 + t68;
    let t70 = t56 * t66 + t60 * t69;
    let t71 = t60 * t56;
    let t72 = 1.0_f32 - t5 * k;
    let t73 = 0.8660254_f32 * t72;
    let t74 = 0.5_f32 * t36;
    let t75 = t73 - t74;
    let t76 = t60 * t75;
    let t77 = 0.5_f32 * t44;
    let t78 = k * t28;
    let t79 = t78 + t5 * t31;
    let t80 = 0.8660254_f32 * t79;
    let t81 = t77 - t80;
    let t82 = t60 * t81 - t75 * t66;
    let t83 = t56 * (t59 * t70 + t71 * t65) + t75 * (t76 * t65 - t59 * t82);
    let t84 = t83 + t59 * (t75 * t82 + t76 * t81 - (t56 * t70 + t71 * t69));
    let t85 = t59 * t71;
    let t86 = t59 * t76;
    let t87 = t85 * t82 + t86 * t70;
    let t88 = t76 * t69 + t71 * t81;
    let t89 = t53 + (t84 * (Ic2 * t84) + t87 * (Ic1 * t87) + t88 * (Ic3 * t88));
    let t90 = t55 - t54;
    let dzC = t57 - t58;
    let t91 = 1.0_f32 / Real::sqrt(1.0_f32 - dzC * dzC);
    let t92 = 0.5_f32 * t91;
    let t93 = t64 + t62;
    let t94 = t91 * (t91 * (t92 * (2.0_f32 * (dzC * t93))));
    let t95 = t68 - t67;
    let t96 = t90 * t94 - t91 * t95;
    let t97 = t91 * t90;
    let t98 = t73 + t74;
    let t99 = t91 * t98;
    let t100 = t80 + t77;
    let t101 = t91 * t100 - t98 * t94;
    let t102 = t90 * (dzC * t96 + t97 * t93) + t98 * (t99 * t93 - dzC * t101);
    let t103 = t102 + dzC * (t97 * t95 - t90 * t96 + (t98 * t101 + t99 * t100));
    let t104 = dzC * t97;
    let t105 = dzC * t99;
    let t106 = t104 * t101 + t105 * t96;
    let t107 = t97 * t100 - t99 * t95;
    let t108 = mc + t89 + (t103 * (Ic2 * t103) + t106 * (Ic1 * t106) + t107 * (Ic3 * t107));
    let M = p.M;
    let t109 = 0.5_f32 * R;
    let t110 = 1.0_f32 / t9;
    let t111 = t14 * t4;
    let t112 = 2.0_f32 * t3;
    let t113 = t27 * t112;
    let t114 = t4 * t112 * t110;
    let t115 = 3.0_f32 * t3;
    let cos3 = t3 * t6 - t5 * t115;
    let shift = t110 * (k * cos3);
    let t116 = t27 * shift;
    let t117 = 3.0_f32 * t2;
    let t118 = t117 * t6;
    let t119 = t115 * t28;
    let t120 = t117 * t5;
    let t121 = t118 + (t119 - t120);
    let t122 = t110 * (shift * t30 + (cos3 * t31 - k * t121));
    let t123 = t109 * (t110 * (t111 - t113 - t114 * t30) - (t116 + t4 * t122));
    let cos2 = t6 - t5;
    let t124 = t110 * cos2;
    let t125 = t15 + t28;
    let t126 = t2 * shift;
    let t127 = t109 * (t110 * (t124 * t30 - t125) + (t126 - t3 * t122));
    let t128 = t109 * cos3;
    let t129 = 0.33333334_f32 + (k * (t109 * t121) - t128 * t31);
    let t130 = t36 * t63 - t10 * t23 + t8 * (t10 * t79 + t72 * t32 + 2.0_f32 * (t36 * t44));
    let Iy = p.Iy;
    let t131 = t10 * t72 + t36 * t36;
    let t132 = t8 * t44 - t18 * t79 + t131 * t63;
    let Ix = p.Ix;
    let t133 = t36 * t32 - t72 * t44 + t18 * t23;
    let Iz = p.Iz;
    let mass_u_hC_u_hC = t108 + M * (t123 * t123 + t127 * t127 + t129 * t129) + (t130 * (Iy * t130) + t132 * (Ix * t132) + t133 * (Iz * t133));
    let u_hB = u[1];
    let t134 = t20 - t22;
    let t135 = t11 * (t11 * (t12 * (2.0_f32 * (t8 * t134))));
    let t136 = t39 - t41;
    let t137 = t136 - t43;
    let t138 = t36 * t135 + t11 * t137;
    let t139 = t13 * t125;
    let t140 = k * (k * (t139 * t26));
    let t141 = t6 * t140 - t25;
    let t142 = t10 * t135 + t11 * t141;
    let t143 = t49 * t138 - t50 * t142;
    let t144 = Ic1 * t143;
    let t145 = t10 * (t8 * t142 + t34 * t134) + t36 * (t8 * t138 + t46 * t134);
    let t146 = t145 - t8 * (t10 * t142 + t34 * t141 + (t36 * t138 + t46 * t137));
    let t147 = Ic2 * t146;
    let t148 = t34 * t137 - t46 * t141;
    let t149 = Ic3 * t148;
    let t150 = t78 - t5 * t140;
    let t151 = 0.8660254_f32 * t150;
    let t152 = 0.5_f32 * t137;
    let t153 = t151 - t152;
    let t154 = 0.8660254_f32 * t137;
    let t155 = 0.5_f32 * t141;
    let t156 = t154 + t155;
    let t157 = t71 * t153 - t76 * t156;
    let t158 = Ic3 * t157;
    let t159 = t7 * (t18 * t139 - t27);
    let t160 = 0.8660254_f32 * t159 + 0.5_f32 * t134;
    let t161 = t60 * (t60 * (t61 * (2.0_f32 * (t59 * t160))));
    let t162 = t56 * t161 + t60 * t156;
    let t163 = t75 * t161 + t60 * t153;
    let t164 = t56 * (t59 * t162 + t71 * t160) + t75 * (t59 * t163 + t76 * t160);
    let t165 = t164 - t59 * (t56 * t162 + t71 * t156 + (t75 * t163 + t76 * t153));
    let t166 = Ic2 * t165;
    let t167 = t85 * t163 - t86 * t162;
    let t168 = Ic1 * t167;
    let t169 = t144 * t51 - t147 * t48 - t149 * t52 - (t158 * t88 - (t166 * t84 - t168 * t87));
    let t170 = t91 * (t91 * (t92 * (2.0_f32 * (dzC * t65))));
    let t171 = t155 - t154;
    let t172 = t90 * t170 + t91 * t171;
    let t173 = t151 + t152;
    let t174 = t98 * t170 + t91 * t173;
    let t175 = t90 * (dzC * t172 + t97 * t65) + t98 * (dzC * t174 + t99 * t65);
    let t176 = dzC * (t90 * t172 + t97 * t171 + (t98 * t174 + t99 * t173)) - t175;
    let t177 = Ic2 * t176;
    let t178 = t105 * t172 - t104 * t174;
    let t179 = Ic1 * t178;
    let t180 = t97 * t173 - t99 * t171;
    let t181 = Ic3 * t180;
    let t182 = t118 - (t120 + t119);
    let t183 = 0.33333334_f32 + (k * (t109 * t182) - t128 * t140);
    let t184 = t110 * (k * t182 - cos3 * t140 - shift * t139);
    let t185 = t109 * (t110 * (t29 - t124 * t139) - (t3 * t184 + t126));
    let t186 = t109 * (t110 * (t111 + t113 - t114 * t139) + (t4 * t184 + t116));
    let t187 = t169 + (t177 * t103 - t179 * t106 + t181 * t107) - M * (t183 * t129 - (t185 * t127 - t186 * t123));
    let t188 = t8 * (t10 * t150 + t72 * t141 + 2.0_f32 * (t36 * t137)) - (t10 * t134 + t36 * t159);
    let t189 = Iy * t188;
    let t190 = t131 * t159 - (t8 * t137 - t18 * t150);
    let t191 = Ix * t190;
    let t192 = t36 * t141 - t72 * t137 + t18 * t134;
    let t193 = Iz * t192;
    let t194 = mc + (t1 + (t146 * t147 + t143 * t144 + t148 * t149)) + (t165 * t166 + t167 * t168 + t157 * t158);
    let t195 = t194 + (t176 * t177 + t178 * t179 + t180 * t181) + M * (t186 * t186 + t185 * t185 + t183 * t183);
    let mass_u_hB_u_hB = t195 + (t188 * t189 + t190 * t191 + t192 * t193);
    let u_hA = u[0];
    let t196 = t17 * shift + (t37 * cos3 - k * (t3 * (3.0_f32 * t15) - 6.0_f32 * t2 * t5));
    let t197 = t110 * t196;
    let t198 = t109 * (t110 * (t17 * t114 - 4.0_f32 * t2 * t4) + t4 * t197);
    let t199 = t109 * (t110 * (t16 - t17 * t124) + (t3 * t197 - t14 * shift));
    let t200 = 0.33333334_f32 + (t37 * t128 - k * cos2);
    let t201 = 0.8660254_f32 * t40;
    let t202 = t16 * k - t6 * t37;
    let t203 = 0.5_f32 * t202;
    let t204 = t201 + t203;
    let t205 = t60 * (t60 * (t61 * (2.0_f32 * (t59 * t134))));
    let t206 = t60 * t204 - t205 * t56;
    let t207 = t60 * t136 - t205 * t75;
    let t208 = t75 * (t59 * t207 - t134 * t76) - t56 * (t134 * t71 - t59 * t206);
    let t209 = t59 * (t56 * t206 + t204 * t71 + (t75 * t207 + t136 * t76)) - t208;
    let t210 = Ic2 * t209;
    let t211 = t207 * t85 - t206 * t86;
    let t212 = Ic1 * t211;
    let t213 = t71 * t136 - t204 * t76;
    let t214 = Ic3 * t213;
    let t215 = t11 * (t11 * (t12 * (2.0_f32 * (t8 * t21))));
    let t216 = t215 * t10 + t11 * t202;
    let t217 = t215 * t36 + t11 * t40;
    let t218 = t10 * (t8 * t216 + t21 * t34) + t36 * (t8 * t217 + t21 * t46);
    let t219 = t218 - t8 * (t10 * t216 + t202 * t34 + (t36 * t217 + t40 * t46));
    let t220 = Ic2 * t219;
    let t221 = t217 * t49 - t216 * t50;
    let t222 = Ic1 * t221;
    let t223 = t202 * t46 - t34 * t40;
    let t224 = Ic3 * t223;
    let t225 = t210 * t165 - t212 * t167 - t214 * t157 - (t220 * t146 + t222 * t143 - t224 * t148);
    let t226 = t203 - t201;
    let t227 = t91 * (t91 * (t92 * (2.0_f32 * (dzC * t23))));
    let t228 = t91 * t226 - t227 * t90;
    let t229 = t227 * t98 - t91 * t42;
    let t230 = t90 * (t23 * t97 - dzC * t228) + t98 * (dzC * t229 + t23 * t99);
    let t231 = t230 + dzC * (t90 * t228 + t226 * t97 - (t98 * t229 - t42 * t99));
    let t232 = Ic2 * t231;
    let t233 = t229 * t104 + t228 * t105;
    let t234 = Ic1 * t233;
    let t235 = t97 * t42 - t226 * t99;
    let t236 = Ic3 * t235;
    let t237 = M * (t198 * t186 - t199 * t185 + t200 * t183) - (t225 - (t232 * t176 + t234 * t178 + t236 * t180));
    let t238 = t202 * t36 - t40 * t72 + t21 * t18;
    let t239 = Iz * t238;
    let t240 = t21 * t10 - t36 * t19 - t8 * (t10 * t38 + t202 * t72 + 2.0_f32 * (t36 * t40));
    let t241 = Iy * t240;
    let t242 = t18 * t38 - t8 * t40 - t19 * t131;
    let t243 = Ix * t242;
    let mass_u_hA_u_hB = t237 + (t239 * t192 - (t241 * t188 - t243 * t190));
    let t244 = mc + t1 + (t219 * t220 + t221 * t222 + t223 * t224) + (t209 * t210 + t211 * t212 + t213 * t214);
    let t245 = t244 + (t231 * t232 + t233 * t234 + t235 * t236) + M * (t198 * t198 + t199 * t199 + t200 * t200);
    let mass_u_hA_u_hA = t245 + (t240 * t241 + t242 * t243 + t238 * t239);
    let t246 = t210 * t84 + t212 * t87 + t214 * t88 - (t222 * t51 - t220 * t48 + t224 * t52);
    let t247 = t236 * t107 - (t234 * t106 - t232 * t103) - t246 - M * (t198 * t123 + t199 * t127 + t200 * t129);
    let t248 = u_hA * u_hB * mass_u_hA_u_hB + 0.5_f32 * (u_hA * u_hA * mass_u_hA_u_hA) - u_hA * u_hC * (t247 + (t239 * t133 - (t241 * t130 + t243 * t132)));
    let t249 = u_hB * u_hC * (t187 + (t189 * t130 - t191 * t132 + t193 * t133)) - (0.5_f32 * (u_hB * u_hB * mass_u_hB_u_hB) + t248);
    let t250 = 0.5_f32 * (u_hC * u_hC * mass_u_hC_u_hC) - t249;
    let g = p.g;
    let heave = 0.33333334_f32 * (hC + (hA + hB));
    let rise = k * t128;
    let t251 = hC * g;
    let t252 = hB * g;
    let t253 = ms * t251 + (mc * t252 + (ms * t252 + hA * g * (ms + mc)));
    let t254 = M * (g * (heave + rise)) + (mc * t251 + t253);
    (t250, t254)
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
    let t1 = 0.5_f32 * R;
    let t2 = 1.0_f32 / (3.0_f32 * R);
    let hB = q[1];
    let hC = q[2];
    let t3 = t2 * (1.7320508_f32 * (hB - hC));
    let hA = q[0];
    let t4 = t2 * (2.0_f32 * (0.5_f32 * hC - (hA - 0.5_f32 * hB)));
    let t5 = t3 * (2.0_f32 * t4);
    let t6 = t3 * t3;
    let t7 = t4 * t4;
    let root = Real::sqrt(t6 + (1.0_f32 + t7));
    let t8 = 1.0_f32 + root;
    let t9 = 1.0_f32 / t8;
    let k = 1.0_f32 / (root * t8);
    let cos3 = t4 * t7 - t6 * (3.0_f32 * t4);
    let shift = t9 * (k * cos3);
    let t10 = t1 * (t5 * t9 + t3 * shift);
    let cos2 = t7 - t6;
    let shift_x = t1 * (t4 * shift - t9 * cos2);
    let heave = 0.33333334_f32 * (hC + (hA + hB));
    let rise = k * (t1 * cos3);
    let t11 = heave + rise;
    let t12 = t3 * (t4 * k);
    let t13 = t7 * k;
    let t14 = Real::atan2(t12, 1.0_f32 - t13);
    let t15 = 1.0_f32 / root;
    let t16 = t4 * t15;
    let t17 = Real::asin(t16);
    let sA = R * (1.0_f32 + t9 * (cos2 + 0.5_f32 * (t6 + t7)));
    let t18 = 0.8660254_f32 * t12;
    let t19 = 0.5_f32 * (t13 - 1.0_f32);
    let t20 = t18 + t19;
    let t21 = 0.8660254_f32 * (1.0_f32 - t6 * k);
    let t22 = 0.5_f32 * t12;
    let t23 = t21 - t22;
    let t24 = Real::atan2(-(0.8660254_f32 * t20 + 0.5_f32 * t23), 0.8660254_f32 * t23 - 0.5_f32 * t20);
    let t25 = 0.8660254_f32 * (t3 * t15);
    let t26 = 0.5_f32 * t16;
    let t27 = 0.8660254_f32 * t5;
    let sB = R * (1.0_f32 + t9 * (t6 + t27));
    let t28 = t19 - t18;
    let t29 = t21 + t22;
    let t30 = Real::atan2(0.8660254_f32 * t28 + 0.5_f32 * t29, 0.8660254_f32 * t29 - 0.5_f32 * t28);
    let dzC = t25 - t26;
    let t31 = Real::asin(dzC);
    let sC = R * (1.0_f32 + t9 * (t6 - t27));
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
    ([], 0.0_f32)
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
