// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 3; the worst over 73 sampled configurations is 0.773 of its nominal size.
// Cost of rates: 4552 operations (3 abs, 1346 add, 10 div, 2 min, 2491 mul, 4 sqrt, 696 sub).
// Cost of energy: 1000 operations (232 add, 7 div, 631 mul, 4 sqrt, 126 sub).
// Cost of speeds: 0 operations ().
// Cost of outputs: 102 operations (18 add, 3 asin, 3 atan2, 4 div, 58 mul, 1 sqrt, 15 sub).
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
///4552 operations.
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
    let FA = inputs[0];
    let c = p.c;
    let mc = p.mc;
    let g = p.g;
    let t1 = mc * g;
    let ms = p.ms;
    let t2 = ms * g;
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let R = p.R;
    let t3 = 1.0_f32 / (3.0_f32 * R);
    let t4 = 2.0_f32 * (hA - 0.5_f32 * hB - 0.5_f32 * hC) * t3;
    let t5 = t4 * t4;
    let t6 = 2.0_f32 * (0.8660254_f32 * hB - 0.8660254_f32 * hC) * t3;
    let t7 = t6 * t6;
    let root = Real::sqrt(1.0_f32 + t5 + t7);
    let t8 = 1.0_f32 + root;
    let k = 1.0_f32 / (root * t8);
    let t9 = t5 * k;
    let t10 = t9 - 1.0_f32;
    let t11 = 1.0_f32 / root;
    let t12 = t4 * t11;
    let t13 = 1.0_f32 / Real::sqrt(1.0_f32 - t12 * t12);
    let t14 = t10 * t13;
    let t15 = 2.0_f32 * t3;
    let t16 = 2.0_f32 * (t4 * t15);
    let t17 = 0.5_f32 * t11;
    let t18 = t16 * t17;
    let t19 = t8 * t18 + root * t18;
    let t20 = k * (k * t19);
    let t21 = k * t15 - t4 * t20;
    let t22 = t6 * t21;
    let t23 = t4 * k;
    let t24 = t6 * t23;
    let t25 = t24 * t13;
    let t26 = t5 * t20;
    let t27 = k * t16;
    let t28 = t26 - t27;
    let t29 = t14 * t22 + t25 * t28;
    let Ic3 = p.Ic3;
    let t30 = u_hA * u_hB;
    let t31 = 1.7320508_f32 * t3;
    let t32 = t21 * t31;
    let t33 = 2.0_f32 * (t6 * t31);
    let t34 = 2.0_f32 * (t3 * t4);
    let t35 = t33 - t34;
    let t36 = t17 * t35;
    let t37 = t8 * t36 + root * t36;
    let t38 = k * (k * t37);
    let t39 = t15 * t38;
    let t40 = t18 * t36;
    let t41 = 2.0_f32 * (t3 * t15);
    let t42 = t17 * t41;
    let t43 = t11 * (t17 * t36);
    let t44 = t42 + t16 * t43;
    let t45 = t19 * t38;
    let t46 = t20 * t37;
    let t47 = k * (k * (t40 - t8 * t44 + (t40 - root * t44)) - t45 - t46);
    let t48 = t3 * t20;
    let t49 = t6 * (t39 + (t4 * t47 - t48));
    let t50 = t32 - t49;
    let t51 = u_hA * u_hA;
    let t52 = t15 * t20;
    let t53 = t18 * t18;
    let t54 = 2.0_f32 * (t15 * t15);
    let t55 = t11 * (t17 * t18);
    let t56 = t17 * t54 - t16 * t55;
    let t57 = t19 * t20;
    let t58 = k * (k * (t53 + t8 * t56 + (t53 + root * t56)) - t57 - t57);
    let t59 = t6 * (t52 + (t52 + t4 * t58));
    let t60 = t51 * t59;
    let t61 = u_hA * u_hC;
    let t62 = t34 + t33;
    let t63 = t17 * t62;
    let t64 = t8 * t63 + root * t63;
    let t65 = k * (k * t64);
    let t66 = t19 * t65;
    let t67 = t11 * (t17 * t63);
    let t68 = t16 * t67 - t42;
    let t69 = t18 * t63;
    let t70 = t20 * t64;
    let t71 = k * (t66 + k * (t8 * t68 - t69 + (root * t68 - t69)) + t70);
    let t72 = t15 * t65;
    let t73 = t32 + t6 * (t4 * t71 - t48 - t72);
    let t74 = t61 * t73;
    let t75 = t42 + t35 * t55;
    let t76 = k * (k * (t40 - t8 * t75 + (t40 - root * t75)) - t46 - t45);
    let t77 = t6 * (t39 + t4 * t76 - t48);
    let t78 = t32 - t77;
    let t79 = u_hB * u_hB;
    let t80 = t3 * k;
    let t81 = t80 + t4 * t38;
    let t82 = t31 * t81;
    let t83 = t36 * t36;
    let t84 = 2.0_f32 * (t3 * t3);
    let t85 = 2.0_f32 * (t31 * t31);
    let t86 = t84 + t85;
    let t87 = t17 * t86;
    let t88 = t87 - t35 * t43;
    let t89 = t37 * t38;
    let t90 = k * (k * (t83 + t8 * t88 + (t83 + root * t88)) - t89 - t89);
    let t91 = t3 * t38;
    let t92 = t82 + (t82 + t6 * (t4 * t90 - t91 - t91));
    let t93 = t79 * t92;
    let t94 = u_hB * u_hC;
    let t95 = t4 * t65 - t80;
    let t96 = t31 * t95;
    let t97 = t3 * t65;
    let t98 = t37 * t65;
    let t99 = t84 - t85;
    let t100 = t17 * t99;
    let t101 = t35 * t67 + t100;
    let t102 = t36 * t63;
    let t103 = t38 * t64;
    let t104 = k * (t98 + k * (t8 * t101 - t102 + (root * t101 - t102)) + t103);
    let t105 = t96 + (t82 - t6 * (t97 + (t4 * t104 - t91)));
    let t106 = t94 * t105;
    let t107 = t62 * t55 - t42;
    let t108 = k * (t66 + (t70 + k * (t8 * t107 - t69 + (root * t107 - t69))));
    let t109 = t32 + t6 * (t4 * t108 - t72 - t48);
    let t110 = t61 * t109;
    let t111 = t100 + t62 * t43;
    let t112 = k * (t98 + (t103 + k * (t8 * t111 - t102 + (root * t111 - t102))));
    let t113 = t82 + (t96 - t6 * (t97 + t4 * t112 - t91));
    let t114 = t94 * t113;
    let t115 = t30 * t50 - t60 - t74 + t30 * t78 - t93 + t106 - t110 + t114;
    let t116 = u_hC * u_hC;
    let t117 = t63 * t63;
    let t118 = t87 - t62 * t67;
    let t119 = t64 * t65;
    let t120 = k * (k * (t117 + t8 * t118 + (t117 + root * t118)) - t119 - t119);
    let t121 = t96 + (t96 + t6 * (t97 + (t97 + t4 * t120)));
    let t122 = t116 * t121;
    let t123 = t115 - t122;
    let t124 = t16 * t20;
    let t125 = t124 + t5 * t58;
    let t126 = k * t54 - t124;
    let t127 = t125 - t126;
    let t128 = t16 * t38;
    let t129 = k * t41;
    let t130 = t20 * t34;
    let t131 = t128 + t129 + (t5 * t47 - t130);
    let t132 = t5 * t71 - t130;
    let t133 = t16 * t65;
    let t134 = t133 - t129;
    let t135 = t132 - t134;
    let t136 = t128 + t5 * t76;
    let t137 = t130 - t129;
    let t138 = t136 - t137;
    let t139 = t34 * t38;
    let t140 = t5 * t90 - t139;
    let t141 = k * t84;
    let t142 = t139 + t141;
    let t143 = t140 - t142;
    let t144 = t51 * t127 + t30 * t131 + t61 * t135 + t30 * t138 + t79 * t143;
    let t145 = t5 * t104 - t139;
    let t146 = t34 * t65;
    let t147 = t141 - t146;
    let t148 = t145 - t147;
    let t149 = t5 * t108 - t133;
    let t150 = t149 - t137;
    let t151 = t146 + t5 * t112;
    let t152 = t151 - t142;
    let t153 = t146 + t5 * t120;
    let t154 = t153 - t147;
    let t155 = t144 + t94 * t148 + t61 * t150 + t94 * t152 + t116 * t154;
    let t156 = t23 * t31;
    let t157 = t156 - t6 * t81;
    let t158 = t6 * t95 - t156;
    let t159 = u_hA * t22 + u_hB * t157 + u_hC * t158;
    let t160 = t27 - t26;
    let t161 = t11 * (t15 - t12 * t18);
    let t162 = 2.0_f32 * (t12 * t161);
    let t163 = 0.5_f32 * t13;
    let t164 = t162 * t163;
    let t165 = t13 * (t13 * t164);
    let t166 = t13 * t160 + t10 * t165;
    let t167 = k * t34;
    let t168 = t167 + t5 * t38;
    let t169 = t11 * (t3 + t12 * t36);
    let t170 = 2.0_f32 * (t12 * t169);
    let t171 = t163 * t170;
    let t172 = t13 * (t13 * t171);
    let t173 = t13 * t168 + t10 * t172;
    let t174 = t5 * t65;
    let t175 = t174 - t167;
    let t176 = t11 * (t12 * t63 - t3);
    let t177 = 2.0_f32 * (t12 * t176);
    let t178 = t163 * t177;
    let t179 = t13 * (t13 * t178);
    let t180 = t13 * t175 + t10 * t179;
    let t181 = u_hA * t166 - u_hB * t173 + u_hC * t180;
    let t182 = t167 - t174;
    let t183 = u_hA * t28 + u_hB * t168 + u_hC * t182;
    let t184 = t13 * t22 + t24 * t165;
    let t185 = t13 * t157 - t24 * t172;
    let t186 = t13 * t158 + t24 * t179;
    let t187 = u_hA * t184 + u_hB * t185 + u_hC * t186;
    let Ic2 = p.Ic2;
    let Ic1 = p.Ic1;
    let t188 = Ic2 - Ic1;
    let t189 = t12 * t14;
    let t190 = t12 * t25;
    let t191 = t189 * t184 - t190 * t166;
    let t192 = t190 * t173 + t189 * t185;
    let t193 = t189 * t186 - t190 * t180;
    let t194 = u_hA * t191 + u_hB * t192 + u_hC * t193;
    let t195 = 1.0_f32 - t9;
    let t196 = t25 * t22 + t24 * t184 - (t14 * t28 + t195 * t166);
    let t197 = t14 * t161 + t12 * t166;
    let t198 = t25 * t161 + t12 * t184;
    let t199 = t12 * t196 + (t195 * t197 - t24 * t198);
    let t200 = t25 * t157 + t24 * t185 - (t14 * t168 - t195 * t173);
    let t201 = t12 * t185 - t25 * t169;
    let t202 = t14 * t169 + t12 * t173;
    let t203 = t12 * t200 - (t24 * t201 + t195 * t202);
    let t204 = t25 * t158 + t24 * t186 - (t14 * t182 + t195 * t180);
    let t205 = t14 * t176 + t12 * t180;
    let t206 = t25 * t176 + t12 * t186;
    let t207 = t12 * t204 + (t195 * t205 - t24 * t206);
    let t208 = u_hA * t199 + u_hB * t203 + u_hC * t207;
    let t209 = Ic3 * (t14 * t123 + t25 * t155 + (t159 * t181 + t183 * t187)) + t188 * (t194 * t208);
    let t210 = t22 * t165;
    let t211 = t164 * t165;
    let t212 = t18 * t161;
    let t213 = t11 * (t212 + (t212 + t12 * t56));
    let t214 = t13 * (t163 * t164);
    let t215 = t211 + t13 * (t163 * (2.0_f32 * (t161 * t161 - t12 * t213)) + t162 * t214);
    let t216 = t13 * (t211 + t215);
    let t217 = t210 - t13 * t59 + (t210 + t24 * t216);
    let t218 = t22 * t172;
    let t219 = t157 * t165;
    let t220 = t164 * t172;
    let t221 = t161 * t169;
    let t222 = t36 * t161;
    let t223 = t18 * t169;
    let t224 = t11 * (t222 - (t223 + t12 * t44));
    let t225 = t13 * (t163 * t171);
    let t226 = t165 * t171;
    let t227 = t220 + t13 * (t163 * (2.0_f32 * (t221 + t12 * t224)) + t162 * t225) + t226;
    let t228 = t13 * t227;
    let t229 = t13 * t50 - t218 + (t219 - t24 * t228);
    let t230 = t22 * t179;
    let t231 = t158 * t165;
    let t232 = t164 * t179;
    let t233 = t161 * t176;
    let t234 = t18 * t176;
    let t235 = t63 * t161;
    let t236 = t11 * (t234 + t12 * t68 - t235);
    let t237 = t13 * (t163 * t178);
    let t238 = t165 * t178;
    let t239 = t232 + t13 * (t163 * (2.0_f32 * (t233 - t12 * t236)) + t162 * t237) + t238;
    let t240 = t13 * t239;
    let t241 = t230 - t13 * t73 + (t231 + t24 * t240);
    let t242 = t11 * (t222 - t12 * t75 - t223);
    let t243 = t220 + (t226 + t13 * (t170 * t214 + t163 * (2.0_f32 * (t221 + t12 * t242))));
    let t244 = t13 * t243;
    let t245 = t219 + t13 * t78 - (t218 + t24 * t244);
    let t246 = t171 * t172;
    let t247 = t36 * t169;
    let t248 = t11 * (t12 * t88 - t247 - t247);
    let t249 = t246 + t13 * (t170 * t225 + t163 * (2.0_f32 * (t169 * t169 - t12 * t248)));
    let t250 = t13 * (t246 + t249);
    let t251 = t157 * t172;
    let t252 = t24 * t250 - t251 - (t251 + t13 * t92);
    let t253 = t51 * t217 + t30 * t229 + t61 * t241 + t30 * t245 + t79 * t252;
    let t254 = t157 * t179;
    let t255 = t158 * t172;
    let t256 = t171 * t179;
    let t257 = t169 * t176;
    let t258 = t36 * t176;
    let t259 = t63 * t169;
    let t260 = t11 * (t258 + t12 * t101 + t259);
    let t261 = t172 * t178;
    let t262 = t256 + t13 * (t170 * t237 + t163 * (2.0_f32 * (t257 + t12 * t260))) + t261;
    let t263 = t13 * t262;
    let t264 = t254 + t13 * t105 - (t255 + t24 * t263);
    let t265 = t11 * (t234 + (t12 * t107 - t235));
    let t266 = t232 + (t238 + t13 * (t177 * t214 + t163 * (2.0_f32 * (t233 - t12 * t265))));
    let t267 = t13 * t266;
    let t268 = t231 - t13 * t109 + (t230 + t24 * t267);
    let t269 = t11 * (t258 + (t259 + t12 * t111));
    let t270 = t256 + (t261 + t13 * (t177 * t225 + t163 * (2.0_f32 * (t257 + t12 * t269))));
    let t271 = t13 * t270;
    let t272 = t13 * t113 - t255 + (t254 - t24 * t271);
    let t273 = t158 * t179;
    let t274 = t178 * t179;
    let t275 = t63 * t176;
    let t276 = t11 * (t12 * t118 - t275 - t275);
    let t277 = t274 + t13 * (t177 * t237 + t163 * (2.0_f32 * (t176 * t176 - t12 * t276)));
    let t278 = t13 * (t274 + t277);
    let t279 = t273 - t13 * t121 + (t273 + t24 * t278);
    let t280 = t189 * (t253 + t94 * t264 + t61 * t268 + t94 * t272 + t116 * t279);
    let t281 = t160 * t165;
    let t282 = t281 + t13 * (t126 - t125) + (t281 + t10 * t216);
    let t283 = t160 * t172;
    let t284 = t168 * t165;
    let t285 = t283 + t13 * t131 + (t284 + t10 * t228);
    let t286 = t160 * t179;
    let t287 = t175 * t165;
    let t288 = t286 + t13 * (t134 - t132) + (t287 + t10 * t240);
    let t289 = t13 * (t137 - t136) - t284 - (t283 + t10 * t244);
    let t290 = t168 * t172;
    let t291 = t290 + t13 * (t142 - t140) + (t290 + t10 * t250);
    let t292 = t51 * t282 - t30 * t285 + t61 * t288 + t30 * t289 + t79 * t291;
    let t293 = t168 * t179;
    let t294 = t175 * t172;
    let t295 = t13 * (t147 - t145) - t293 - (t294 + t10 * t263);
    let t296 = t287 + t13 * (t137 - t149) + (t286 + t10 * t267);
    let t297 = t13 * (t142 - t151) - t294 - (t293 + t10 * t271);
    let t298 = t175 * t179;
    let t299 = t298 + t13 * (t147 - t153) + (t298 + t10 * t278);
    let t300 = t190 * (t292 + t94 * t295 + t61 * t296 + t94 * t297 + t116 * t299);
    let t301 = u_hA * t197 - u_hB * t202 + u_hC * t205;
    let t302 = u_hA * t198 + u_hB * t201 + u_hC * t206;
    let t303 = Ic3 - Ic2;
    let t304 = t14 * t157 + t25 * t168;
    let t305 = t14 * t158 + t25 * t182;
    let t306 = u_hA * t29 + u_hB * t304 + u_hC * t305;
    let t307 = Ic1 * (t280 - t300 + (t187 * t301 - t181 * t302)) + t303 * (t208 * t306);
    let t308 = t22 * t184;
    let t309 = t28 * t166;
    let t310 = t308 - t25 * t59 + (t308 + t24 * t217) - (t309 + t14 * t127 + (t309 + t195 * t282));
    let t311 = t22 * t185;
    let t312 = t157 * t184;
    let t313 = t28 * t173;
    let t314 = t168 * t166;
    let t315 = t311 + t25 * t50 + (t312 + t24 * t229) - (t14 * t131 - t313 + (t314 - t195 * t285));
    let t316 = t22 * t186;
    let t317 = t158 * t184;
    let t318 = t28 * t180;
    let t319 = t182 * t166;
    let t320 = t316 - t25 * t73 + (t317 + t24 * t241) - (t318 + t14 * t135 + (t319 + t195 * t288));
    let t321 = t312 + t25 * t78 + (t311 + t24 * t245) - (t314 + t14 * t138 + (t195 * t289 - t313));
    let t322 = t157 * t185;
    let t323 = t168 * t173;
    let t324 = t322 - t25 * t92 + (t322 + t24 * t252) - (t14 * t143 - t323 + (t195 * t291 - t323));
    let t325 = t51 * t310 + t30 * t315 + t61 * t320 + t30 * t321 + t79 * t324;
    let t326 = t157 * t186;
    let t327 = t158 * t185;
    let t328 = t168 * t180;
    let t329 = t182 * t173;
    let t330 = t326 + t25 * t105 + (t327 + t24 * t264) - (t328 + t14 * t148 + (t195 * t295 - t329));
    let t331 = t317 - t25 * t109 + (t316 + t24 * t268) - (t319 + t14 * t150 + (t318 + t195 * t296));
    let t332 = t327 + t25 * t113 + (t326 + t24 * t272) - (t14 * t152 - t329 + (t328 + t195 * t297));
    let t333 = t158 * t186;
    let t334 = t182 * t180;
    let t335 = t333 - t25 * t121 + (t333 + t24 * t279) - (t334 + t14 * t154 + (t334 + t195 * t299));
    let t336 = t12 * (t325 + t94 * t330 + t61 * t331 + t94 * t332 + t116 * t335);
    let t337 = t161 * t166;
    let t338 = t161 * t173;
    let t339 = t169 * t166;
    let t340 = t51 * (t337 - t14 * t213 + (t337 + t12 * t282)) - t30 * (t338 + t14 * t224 + (t339 + t12 * t285));
    let t341 = t161 * t180;
    let t342 = t176 * t166;
    let t343 = t340 + t61 * (t341 - t14 * t236 + (t342 + t12 * t288)) + t30 * (t12 * t289 - t338 - (t339 + t14 * t242));
    let t344 = t169 * t173;
    let t345 = t176 * t173;
    let t346 = t169 * t180;
    let t347 = t343 + t79 * (t344 - t14 * t248 + (t344 + t12 * t291)) + t94 * (t12 * t295 - t345 - (t346 + t14 * t260));
    let t348 = t347 + t61 * (t342 - t14 * t265 + (t341 + t12 * t296)) + t94 * (t12 * t297 - t346 - (t345 + t14 * t269));
    let t349 = t176 * t180;
    let t350 = t161 * t184;
    let t351 = t161 * t185;
    let t352 = t169 * t184;
    let t353 = t51 * (t350 - t25 * t213 + (t350 + t12 * t217)) + t30 * (t351 - t25 * t224 + (t12 * t229 - t352));
    let t354 = t161 * t186;
    let t355 = t176 * t184;
    let t356 = t353 + t61 * (t354 - t25 * t236 + (t355 + t12 * t241)) + t30 * (t351 + t12 * t245 - (t352 + t25 * t242));
    let t357 = t169 * t185;
    let t358 = t176 * t185;
    let t359 = t169 * t186;
    let t360 = t356 + t79 * (t12 * t252 - t357 - (t357 + t25 * t248)) + t94 * (t358 + t12 * t264 - (t359 + t25 * t260));
    let t361 = t360 + t61 * (t355 - t25 * t265 + (t354 + t12 * t268)) + t94 * (t358 - t25 * t269 + (t12 * t272 - t359));
    let t362 = t176 * t186;
    let t363 = t195 * (t348 + t116 * (t349 - t14 * t276 + (t349 + t12 * t299))) - t24 * (t361 + t116 * (t362 - t25 * t276 + (t362 + t12 * t279)));
    let t364 = u_hA * t161 - u_hB * t169 + u_hC * t176;
    let t365 = t364 * (u_hA * t196 + u_hB * t200 + u_hC * t204) + (t183 * t301 - t159 * t302);
    let t366 = Ic1 - Ic3;
    let t367 = Ic2 * (t336 + t363 + t365) + t366 * (t194 * t306);
    let t368 = 0.5_f32 * t24;
    let t369 = t7 * k;
    let t370 = 0.8660254_f32 * (1.0_f32 - t369);
    let t371 = t368 + t370;
    let t372 = 0.5_f32 * t12;
    let t373 = t6 * t11;
    let t374 = 0.8660254_f32 * t373;
    let dzB = t372 - t374;
    let t375 = 1.0_f32 / Real::sqrt(1.0_f32 - dzB * dzB);
    let t376 = t371 * t375;
    let t377 = 0.5_f32 * t28;
    let t378 = 0.8660254_f32 * t22;
    let t379 = t377 + t378;
    let t380 = 0.5_f32 * t195;
    let t381 = 0.8660254_f32 * t24;
    let t382 = t380 + t381;
    let t383 = t382 * t375;
    let t384 = 0.5_f32 * t22;
    let t385 = t7 * t20;
    let t386 = 0.8660254_f32 * t385;
    let t387 = t384 + t386;
    let t388 = t376 * t379 - t383 * t387;
    let t389 = 0.5_f32 * t59;
    let t390 = t7 * t58;
    let t391 = 0.8660254_f32 * t390;
    let t392 = 0.5_f32 * t50;
    let t393 = t20 * t33;
    let t394 = t393 + t7 * t47;
    let t395 = 0.8660254_f32 * t394;
    let t396 = t392 + t395;
    let t397 = t7 * t71 - t393;
    let t398 = 0.8660254_f32 * t397;
    let t399 = 0.5_f32 * t73;
    let t400 = t398 - t399;
    let t401 = 0.5_f32 * t78;
    let t402 = t393 + t7 * t76;
    let t403 = 0.8660254_f32 * t402;
    let t404 = t401 + t403;
    let t405 = t33 * t38;
    let t406 = t405 + t7 * t90;
    let t407 = k * t85;
    let t408 = t407 - t405;
    let t409 = 0.8660254_f32 * (t406 - t408);
    let t410 = 0.5_f32 * t92;
    let t411 = t409 - t410;
    let t412 = t51 * (t389 - t391) - t30 * t396 - t61 * t400 - t30 * t404 - t79 * t411;
    let t413 = 0.5_f32 * t105;
    let t414 = t7 * t104 - t405;
    let t415 = t33 * t65;
    let t416 = t415 - t407;
    let t417 = 0.8660254_f32 * (t414 - t416);
    let t418 = t413 + t417;
    let t419 = t7 * t108 - t393;
    let t420 = 0.8660254_f32 * t419;
    let t421 = 0.5_f32 * t109;
    let t422 = t420 - t421;
    let t423 = 0.5_f32 * t113;
    let t424 = t7 * t112 - t415;
    let t425 = t405 - t407;
    let t426 = 0.8660254_f32 * (t424 - t425);
    let t427 = t423 + t426;
    let t428 = t415 + t7 * t120;
    let t429 = t407 - t415;
    let t430 = 0.8660254_f32 * (t428 - t429);
    let t431 = 0.5_f32 * t121;
    let t432 = t430 - t431;
    let t433 = t383 * (t412 - t94 * t418 - t61 * t422 - t94 * t427 - t116 * t432);
    let t434 = 0.8660254_f32 * t59;
    let t435 = 0.5_f32 * t127;
    let t436 = 0.5_f32 * t131;
    let t437 = 0.8660254_f32 * t50;
    let t438 = t436 + t437;
    let t439 = 0.5_f32 * t135;
    let t440 = 0.8660254_f32 * t73;
    let t441 = t439 - t440;
    let t442 = 0.5_f32 * t138;
    let t443 = 0.8660254_f32 * t78;
    let t444 = t442 + t443;
    let t445 = 0.5_f32 * t143;
    let t446 = 0.8660254_f32 * t92;
    let t447 = t445 - t446;
    let t448 = t51 * (t434 - t435) - t30 * t438 - t61 * t441 - t30 * t444 - t79 * t447;
    let t449 = 0.5_f32 * t148;
    let t450 = 0.8660254_f32 * t105;
    let t451 = t449 + t450;
    let t452 = 0.5_f32 * t150;
    let t453 = 0.8660254_f32 * t109;
    let t454 = t452 - t453;
    let t455 = 0.5_f32 * t152;
    let t456 = 0.8660254_f32 * t113;
    let t457 = t455 + t456;
    let t458 = 0.5_f32 * t154;
    let t459 = 0.8660254_f32 * t121;
    let t460 = t458 - t459;
    let t461 = t376 * (t448 - t94 * t451 - t61 * t454 - t94 * t457 - t116 * t460);
    let t462 = 0.5_f32 * t168;
    let t463 = 0.8660254_f32 * t157;
    let t464 = t462 + t463;
    let t465 = 0.5_f32 * t182;
    let t466 = 0.8660254_f32 * t158;
    let t467 = t465 + t466;
    let t468 = u_hA * t379 + u_hB * t464 + u_hC * t467;
    let t469 = 0.5_f32 * t161;
    let t470 = t11 * (t373 * t18);
    let t471 = 0.8660254_f32 * t470;
    let t472 = t469 + t471;
    let t473 = 2.0_f32 * (dzB * t472);
    let t474 = 0.5_f32 * t375;
    let t475 = t473 * t474;
    let t476 = t375 * (t375 * t475);
    let t477 = t375 * t387 + t371 * t476;
    let t478 = 0.5_f32 * t157;
    let t479 = t7 * t38;
    let t480 = k * t33;
    let t481 = 0.8660254_f32 * (t479 - t480);
    let t482 = t478 + t481;
    let t483 = 0.5_f32 * t169;
    let t484 = t11 * (t31 - t373 * t36);
    let t485 = 0.8660254_f32 * t484;
    let t486 = t483 + t485;
    let t487 = 2.0_f32 * (dzB * t486);
    let t488 = t474 * t487;
    let t489 = t375 * (t375 * t488);
    let t490 = t375 * t482 - t371 * t489;
    let t491 = 0.5_f32 * t158;
    let t492 = t7 * t65;
    let t493 = 0.8660254_f32 * (t480 - t492);
    let t494 = t491 + t493;
    let t495 = 0.5_f32 * t176;
    let t496 = t11 * (t373 * t63 - t31);
    let t497 = 0.8660254_f32 * t496;
    let t498 = t495 - t497;
    let t499 = 2.0_f32 * (dzB * t498);
    let t500 = t474 * t499;
    let t501 = t375 * (t375 * t500);
    let t502 = t375 * t494 + t371 * t501;
    let t503 = u_hA * t477 + u_hB * t490 + u_hC * t502;
    let t504 = u_hA * t387 + u_hB * t482 + u_hC * t494;
    let t505 = t375 * t379 + t382 * t476;
    let t506 = t375 * t464 - t382 * t489;
    let t507 = t375 * t467 + t382 * t501;
    let t508 = u_hA * t505 + u_hB * t506 + u_hC * t507;
    let t509 = t374 - t372;
    let t510 = t509 * t376;
    let t511 = t509 * t383;
    let t512 = t510 * t505 - t511 * t477;
    let t513 = t510 * t506 - t511 * t490;
    let t514 = t510 * t507 - t511 * t502;
    let t515 = u_hA * t512 + u_hB * t513 + u_hC * t514;
    let t516 = t376 * t387 + t371 * t477 + (t383 * t379 + t382 * t505);
    let t517 = t509 * t477 - t376 * t472;
    let t518 = t509 * t505 - t383 * t472;
    let t519 = t509 * t516 - (t371 * t517 + t382 * t518);
    let t520 = t376 * t482 + t371 * t490 + (t383 * t464 + t382 * t506);
    let t521 = t376 * t486 + t509 * t490;
    let t522 = t383 * t486 + t509 * t506;
    let t523 = t509 * t520 - (t371 * t521 + t382 * t522);
    let t524 = t376 * t494 + t371 * t502 + (t383 * t467 + t382 * t507);
    let t525 = t497 - t495;
    let t526 = t376 * t525 + t509 * t502;
    let t527 = t383 * t525 + t509 * t507;
    let t528 = t509 * t524 - (t371 * t526 + t382 * t527);
    let t529 = u_hA * t519 + u_hB * t523 + u_hC * t528;
    let t530 = Ic3 * (t433 - t461 + (t468 * t503 - t504 * t508)) + t188 * (t515 * t529);
    let t531 = t379 * t476;
    let t532 = t435 - t434;
    let t533 = t475 * t476;
    let t534 = t18 * t470;
    let t535 = t11 * (t373 * t56 - t534 - t534);
    let t536 = 0.8660254_f32 * t535;
    let t537 = 0.5_f32 * t213;
    let t538 = t536 - t537;
    let t539 = t375 * (t474 * t475);
    let t540 = t533 + t375 * (t474 * (2.0_f32 * (t472 * t472 + dzB * t538)) + t473 * t539);
    let t541 = t375 * (t533 + t540);
    let t542 = t531 + t375 * t532 + (t531 + t382 * t541);
    let t543 = t379 * t489;
    let t544 = t464 * t476;
    let t545 = t18 * t484;
    let t546 = t36 * t470;
    let t547 = t11 * (t545 - t373 * t44 - t546);
    let t548 = 0.8660254_f32 * t547;
    let t549 = 0.5_f32 * t224;
    let t550 = t548 - t549;
    let t551 = t472 * t486;
    let t552 = t375 * (t474 * t488);
    let t553 = t475 * t489;
    let t554 = t476 * t488;
    let t555 = t375 * (t474 * (2.0_f32 * (dzB * t550 - t551)) - t473 * t552) - t553 - t554;
    let t556 = t375 * t555;
    let t557 = t375 * t438 - t543 + (t544 + t382 * t556);
    let t558 = t379 * t501;
    let t559 = t467 * t476;
    let t560 = t475 * t501;
    let t561 = t472 * t498;
    let t562 = t18 * t496;
    let t563 = t63 * t470;
    let t564 = t11 * (t562 + t373 * t68 + t563);
    let t565 = 0.8660254_f32 * t564;
    let t566 = 0.5_f32 * t236;
    let t567 = t565 - t566;
    let t568 = t375 * (t474 * t500);
    let t569 = t476 * t500;
    let t570 = t560 + t375 * (t474 * (2.0_f32 * (t561 + dzB * t567)) + t473 * t568) + t569;
    let t571 = t375 * t570;
    let t572 = t558 + t375 * t441 + (t559 + t382 * t571);
    let t573 = 0.5_f32 * t242;
    let t574 = t11 * (t546 + t373 * t75 - t545);
    let t575 = 0.8660254_f32 * t574;
    let t576 = t573 + t575;
    let t577 = t553 + (t554 + t375 * (t487 * t539 + t474 * (2.0_f32 * (t551 + dzB * t576))));
    let t578 = t375 * t577;
    let t579 = t544 + t375 * t444 - (t543 + t382 * t578);
    let t580 = t464 * t489;
    let t581 = t488 * t489;
    let t582 = t36 * t484;
    let t583 = t11 * (t582 + (t582 + t373 * t88));
    let t584 = 0.8660254_f32 * t583;
    let t585 = 0.5_f32 * t248;
    let t586 = t375 * (t487 * t552 + t474 * (2.0_f32 * (t486 * t486 + dzB * (t584 - t585))));
    let t587 = t375 * (t581 + (t581 + t586));
    let t588 = t375 * t447 - t580 + (t382 * t587 - t580);
    let t589 = t51 * t542 + t30 * t557 + t61 * t572 + t30 * t579 + t79 * t588;
    let t590 = t464 * t501;
    let t591 = t36 * t496;
    let t592 = t63 * t484;
    let t593 = t11 * (t591 + t373 * t101 - t592);
    let t594 = 0.8660254_f32 * t593;
    let t595 = 0.5_f32 * t260;
    let t596 = t486 * t498;
    let t597 = t488 * t501;
    let t598 = t375 * (t474 * (2.0_f32 * (dzB * (t594 - t595) - t596)) - t487 * t568) - t597;
    let t599 = t489 * t500;
    let t600 = t375 * (t598 - t599);
    let t601 = t467 * t489;
    let t602 = t590 + t375 * t451 + (t382 * t600 - t601);
    let t603 = 0.5_f32 * t265;
    let t604 = t11 * (t562 + (t563 + t373 * t107));
    let t605 = 0.8660254_f32 * t604;
    let t606 = t603 - t605;
    let t607 = t560 + (t569 + t375 * (t499 * t539 + t474 * (2.0_f32 * (t561 - dzB * t606))));
    let t608 = t375 * t607;
    let t609 = t559 + t375 * t454 + (t558 + t382 * t608);
    let t610 = t11 * (t591 + (t373 * t111 - t592));
    let t611 = 0.8660254_f32 * t610;
    let t612 = 0.5_f32 * t269;
    let t613 = t375 * (t474 * (2.0_f32 * (dzB * (t611 - t612) - t596)) - t499 * t552) - t599;
    let t614 = t375 * (t613 - t597);
    let t615 = t375 * t457 - t601 + (t590 + t382 * t614);
    let t616 = t467 * t501;
    let t617 = t500 * t501;
    let t618 = t63 * t496;
    let t619 = t11 * (t373 * t118 - t618 - t618);
    let t620 = 0.8660254_f32 * t619;
    let t621 = 0.5_f32 * t276;
    let t622 = t375 * (t499 * t568 + t474 * (2.0_f32 * (t498 * t498 + dzB * (t620 - t621))));
    let t623 = t375 * (t617 + (t617 + t622));
    let t624 = t616 + t375 * t460 + (t616 + t382 * t623);
    let t625 = t510 * (t589 + t94 * t602 + t61 * t609 + t94 * t615 + t116 * t624);
    let t626 = t387 * t476;
    let t627 = t391 - t389;
    let t628 = t626 + t375 * t627 + (t626 + t371 * t541);
    let t629 = t387 * t489;
    let t630 = t482 * t476;
    let t631 = t375 * t396 - t629 + (t630 + t371 * t556);
    let t632 = t387 * t501;
    let t633 = t494 * t476;
    let t634 = t632 + t375 * t400 + (t633 + t371 * t571);
    let t635 = t630 + t375 * t404 - (t629 + t371 * t578);
    let t636 = t482 * t489;
    let t637 = t375 * t411 - t636 + (t371 * t587 - t636);
    let t638 = t51 * t628 + t30 * t631 + t61 * t634 + t30 * t635 + t79 * t637;
    let t639 = t482 * t501;
    let t640 = t494 * t489;
    let t641 = t639 + t375 * t418 + (t371 * t600 - t640);
    let t642 = t633 + t375 * t422 + (t632 + t371 * t608);
    let t643 = t375 * t427 - t640 + (t639 + t371 * t614);
    let t644 = t494 * t501;
    let t645 = t644 + t375 * t432 + (t644 + t371 * t623);
    let t646 = t511 * (t638 + t94 * t641 + t61 * t642 + t94 * t643 + t116 * t645);
    let t647 = u_hA * t517 + u_hB * t521 + u_hC * t526;
    let t648 = u_hA * t518 + u_hB * t522 + u_hC * t527;
    let t649 = t376 * t464 - t383 * t482;
    let t650 = t376 * t467 - t383 * t494;
    let t651 = u_hA * t388 + u_hB * t649 + u_hC * t650;
    let t652 = Ic1 * (t625 - t646 + (t508 * t647 - t503 * t648)) + t303 * (t529 * t651);
    let t653 = t387 * t477;
    let t654 = t379 * t505;
    let t655 = t653 + t376 * t627 + (t653 + t371 * t628) + (t654 + t383 * t532 + (t654 + t382 * t542));
    let t656 = t387 * t490;
    let t657 = t482 * t477;
    let t658 = t379 * t506;
    let t659 = t464 * t505;
    let t660 = t656 + t376 * t396 + (t657 + t371 * t631) + (t658 + t383 * t438 + (t659 + t382 * t557));
    let t661 = t387 * t502;
    let t662 = t494 * t477;
    let t663 = t379 * t507;
    let t664 = t467 * t505;
    let t665 = t661 + t376 * t400 + (t662 + t371 * t634) + (t663 + t383 * t441 + (t664 + t382 * t572));
    let t666 = t657 + t376 * t404 + (t656 + t371 * t635) + (t659 + t383 * t444 + (t658 + t382 * t579));
    let t667 = t482 * t490;
    let t668 = t464 * t506;
    let t669 = t667 + t376 * t411 + (t667 + t371 * t637) + (t668 + t383 * t447 + (t668 + t382 * t588));
    let t670 = t51 * t655 + t30 * t660 + t61 * t665 + t30 * t666 + t79 * t669;
    let t671 = t482 * t502;
    let t672 = t494 * t490;
    let t673 = t464 * t507;
    let t674 = t467 * t506;
    let t675 = t671 + t376 * t418 + (t672 + t371 * t641) + (t673 + t383 * t451 + (t674 + t382 * t602));
    let t676 = t662 + t376 * t422 + (t661 + t371 * t642) + (t664 + t383 * t454 + (t663 + t382 * t609));
    let t677 = t672 + t376 * t427 + (t671 + t371 * t643) + (t674 + t383 * t457 + (t673 + t382 * t615));
    let t678 = t494 * t502;
    let t679 = t467 * t507;
    let t680 = t678 + t376 * t432 + (t678 + t371 * t645) + (t679 + t383 * t460 + (t679 + t382 * t624));
    let t681 = t509 * (t670 + t94 * t675 + t61 * t676 + t94 * t677 + t116 * t680);
    let t682 = t472 * t477;
    let t683 = t486 * t477;
    let t684 = t472 * t490;
    let t685 = t51 * (t509 * t628 - t682 - (t682 + t376 * t538)) + t30 * (t683 + t509 * t631 - (t684 + t376 * t550));
    let t686 = t525 * t477;
    let t687 = t472 * t502;
    let t688 = t685 + t61 * (t686 + t509 * t634 - (t687 + t376 * t567)) + t30 * (t683 + t376 * t576 + (t509 * t635 - t684));
    let t689 = t486 * t490;
    let t690 = t585 - t584;
    let t691 = t486 * t502;
    let t692 = t595 - t594;
    let t693 = t525 * t490;
    let t694 = t688 + t79 * (t689 + t376 * t690 + (t689 + t509 * t637)) + t94 * (t691 + t376 * t692 + (t693 + t509 * t641));
    let t695 = t612 - t611;
    let t696 = t694 + t61 * (t686 + t376 * t606 + (t509 * t642 - t687)) + t94 * (t693 + t376 * t695 + (t691 + t509 * t643));
    let t697 = t525 * t502;
    let t698 = t621 - t620;
    let t699 = t472 * t505;
    let t700 = t486 * t505;
    let t701 = t472 * t506;
    let t702 = t51 * (t509 * t542 - t699 - (t699 + t383 * t538)) + t30 * (t700 + t509 * t557 - (t701 + t383 * t550));
    let t703 = t525 * t505;
    let t704 = t472 * t507;
    let t705 = t702 + t61 * (t703 + t509 * t572 - (t704 + t383 * t567)) + t30 * (t700 + t383 * t576 + (t509 * t579 - t701));
    let t706 = t486 * t506;
    let t707 = t486 * t507;
    let t708 = t525 * t506;
    let t709 = t705 + t79 * (t706 + t383 * t690 + (t706 + t509 * t588)) + t94 * (t707 + t383 * t692 + (t708 + t509 * t602));
    let t710 = t709 + t61 * (t703 + t383 * t606 + (t509 * t609 - t704)) + t94 * (t708 + t383 * t695 + (t707 + t509 * t615));
    let t711 = t525 * t507;
    let t712 = t371 * (t696 + t116 * (t697 + t376 * t698 + (t697 + t509 * t645))) + t382 * (t710 + t116 * (t711 + t383 * t698 + (t711 + t509 * t624)));
    let t713 = (u_hB * t486 - u_hA * t472 + u_hC * t525) * (u_hA * t516 + u_hB * t520 + u_hC * t524);
    let t714 = Ic2 * (t681 - t712 + (t713 - (t504 * t647 + t468 * t648))) + t366 * (t515 * t651);
    let t715 = t29 * t209 + (t191 * t307 + t199 * t367) + (t388 * t530 + (t512 * t652 + t519 * t714));
    let t716 = t380 - t381;
    let dzC = t372 + t374;
    let t717 = 1.0_f32 / Real::sqrt(1.0_f32 - dzC * dzC);
    let t718 = t716 * t717;
    let t719 = t386 - t384;
    let t720 = t370 - t368;
    let t721 = t720 * t717;
    let t722 = t378 - t377;
    let t723 = t718 * t719 + t721 * t722;
    let t724 = t389 + t391;
    let t725 = t395 - t392;
    let t726 = t399 + t398;
    let t727 = t403 - t401;
    let t728 = t410 + t409;
    let t729 = t51 * t724 + t30 * t725 + t61 * t726 + t30 * t727 + t79 * t728;
    let t730 = t417 - t413;
    let t731 = t421 + t420;
    let t732 = t426 - t423;
    let t733 = t431 + t430;
    let t734 = t718 * (t729 + t94 * t730 + t61 * t731 + t94 * t732 + t116 * t733);
    let t735 = t437 - t436;
    let t736 = t435 + t434;
    let t737 = t439 + t440;
    let t738 = t443 - t442;
    let t739 = t445 + t446;
    let t740 = t30 * t735 - t51 * t736 - t61 * t737 + t30 * t738 - t79 * t739;
    let t741 = t450 - t449;
    let t742 = t452 + t453;
    let t743 = t456 - t455;
    let t744 = t458 + t459;
    let t745 = t721 * (t740 + t94 * t741 - t61 * t742 + t94 * t743 - t116 * t744);
    let t746 = t481 - t478;
    let t747 = t493 - t491;
    let t748 = u_hA * t719 + u_hB * t746 + u_hC * t747;
    let t749 = t377 - t378;
    let t750 = t469 - t471;
    let t751 = 2.0_f32 * (dzC * t750);
    let t752 = 0.5_f32 * t717;
    let t753 = t751 * t752;
    let t754 = t717 * (t717 * t753);
    let t755 = t717 * t749 + t716 * t754;
    let t756 = t462 - t463;
    let t757 = t485 - t483;
    let t758 = 2.0_f32 * (dzC * t757);
    let t759 = t752 * t758;
    let t760 = t717 * (t717 * t759);
    let t761 = t717 * t756 + t716 * t760;
    let t762 = t465 - t466;
    let t763 = t495 + t497;
    let t764 = 2.0_f32 * (dzC * t763);
    let t765 = t752 * t764;
    let t766 = t717 * (t717 * t765);
    let t767 = t717 * t762 + t716 * t766;
    let t768 = u_hA * t755 + u_hB * t761 + u_hC * t767;
    let t769 = t463 - t462;
    let t770 = t466 - t465;
    let t771 = u_hA * t722 + u_hB * t769 + u_hC * t770;
    let t772 = t717 * t719 + t720 * t754;
    let t773 = t717 * t746 + t720 * t760;
    let t774 = t717 * t747 + t720 * t766;
    let t775 = u_hA * t772 + u_hB * t773 + u_hC * t774;
    let t776 = dzC * t721;
    let t777 = dzC * t718;
    let t778 = t776 * t755 - t777 * t772;
    let t779 = t776 * t761 - t777 * t773;
    let t780 = t776 * t767 - t777 * t774;
    let t781 = u_hA * t778 + u_hB * t779 + u_hC * t780;
    let t782 = t721 * t750 + dzC * t772;
    let t783 = t381 - t380;
    let t784 = t718 * t750 + dzC * t755;
    let t785 = t721 * t719 + t720 * t772 - (t718 * t722 + t783 * t755);
    let t786 = t720 * t782 - t783 * t784 - dzC * t785;
    let t787 = t721 * t757 + dzC * t773;
    let t788 = t718 * t757 + dzC * t761;
    let t789 = t721 * t746 + t720 * t773 - (t718 * t769 + t783 * t761);
    let t790 = t720 * t787 - t783 * t788 - dzC * t789;
    let t791 = t721 * t763 + dzC * t774;
    let t792 = t718 * t763 + dzC * t767;
    let t793 = t721 * t747 + t720 * t774 - (t718 * t770 + t783 * t767);
    let t794 = t720 * t791 - t783 * t792 - dzC * t793;
    let t795 = u_hA * t786 + u_hB * t790 + u_hC * t794;
    let t796 = Ic3 * (t734 + t745 + (t748 * t768 + t771 * t775)) + t188 * (t781 * t795);
    let t797 = t749 * t754;
    let t798 = t753 * t754;
    let t799 = t537 + t536;
    let t800 = t717 * (t752 * t753);
    let t801 = t798 + t717 * (t752 * (2.0_f32 * (t750 * t750 - dzC * t799)) + t751 * t800);
    let t802 = t717 * (t798 + t801);
    let t803 = t797 + t717 * t736 + (t797 + t716 * t802);
    let t804 = t749 * t760;
    let t805 = t754 * t756;
    let t806 = t753 * t760;
    let t807 = t750 * t757;
    let t808 = t549 + t548;
    let t809 = t717 * (t752 * t759);
    let t810 = t754 * t759;
    let t811 = t806 + t717 * (t752 * (2.0_f32 * (t807 - dzC * t808)) + t751 * t809) + t810;
    let t812 = t717 * t811;
    let t813 = t804 + t717 * (t436 - t437) + (t805 + t716 * t812);
    let t814 = t749 * t766;
    let t815 = t754 * t762;
    let t816 = t753 * t766;
    let t817 = t750 * t763;
    let t818 = t566 + t565;
    let t819 = t717 * (t752 * t765);
    let t820 = t754 * t765;
    let t821 = t816 + t717 * (t752 * (2.0_f32 * (t817 - dzC * t818)) + t751 * t819) + t820;
    let t822 = t717 * t821;
    let t823 = t814 + t717 * t737 + (t815 + t716 * t822);
    let t824 = t575 - t573;
    let t825 = t806 + (t810 + t717 * (t758 * t800 + t752 * (2.0_f32 * (t807 + dzC * t824))));
    let t826 = t717 * t825;
    let t827 = t805 + t717 * (t442 - t443) + (t804 + t716 * t826);
    let t828 = t756 * t760;
    let t829 = t759 * t760;
    let t830 = t585 + t584;
    let t831 = t829 + t717 * (t758 * t809 + t752 * (2.0_f32 * (t757 * t757 - dzC * t830)));
    let t832 = t717 * (t829 + t831);
    let t833 = t828 + t717 * t739 + (t828 + t716 * t832);
    let t834 = t51 * t803 + t30 * t813 + t61 * t823 + t30 * t827 + t79 * t833;
    let t835 = t756 * t766;
    let t836 = t760 * t762;
    let t837 = t759 * t766;
    let t838 = t757 * t763;
    let t839 = t595 + t594;
    let t840 = t760 * t765;
    let t841 = t837 + t717 * (t758 * t819 + t752 * (2.0_f32 * (t838 - dzC * t839))) + t840;
    let t842 = t717 * t841;
    let t843 = t835 + t717 * (t449 - t450) + (t836 + t716 * t842);
    let t844 = t603 + t605;
    let t845 = t816 + (t820 + t717 * (t764 * t800 + t752 * (2.0_f32 * (t817 - dzC * t844))));
    let t846 = t717 * t845;
    let t847 = t815 + t717 * t742 + (t814 + t716 * t846);
    let t848 = t612 + t611;
    let t849 = t837 + (t840 + t717 * (t764 * t809 + t752 * (2.0_f32 * (t838 - dzC * t848))));
    let t850 = t717 * t849;
    let t851 = t836 + t717 * (t455 - t456) + (t835 + t716 * t850);
    let t852 = t762 * t766;
    let t853 = t765 * t766;
    let t854 = t621 + t620;
    let t855 = t853 + t717 * (t764 * t819 + t752 * (2.0_f32 * (t763 * t763 - dzC * t854)));
    let t856 = t717 * (t853 + t855);
    let t857 = t852 + t717 * t744 + (t852 + t716 * t856);
    let t858 = t776 * (t834 + t94 * t843 + t61 * t847 + t94 * t851 + t116 * t857);
    let t859 = t719 * t754;
    let t860 = t859 + t717 * t724 + (t859 + t720 * t802);
    let t861 = t719 * t760;
    let t862 = t746 * t754;
    let t863 = t861 + t717 * t725 + (t862 + t720 * t812);
    let t864 = t719 * t766;
    let t865 = t747 * t754;
    let t866 = t864 + t717 * t726 + (t865 + t720 * t822);
    let t867 = t862 + t717 * t727 + (t861 + t720 * t826);
    let t868 = t746 * t760;
    let t869 = t868 + t717 * t728 + (t868 + t720 * t832);
    let t870 = t51 * t860 + t30 * t863 + t61 * t866 + t30 * t867 + t79 * t869;
    let t871 = t746 * t766;
    let t872 = t747 * t760;
    let t873 = t871 + t717 * t730 + (t872 + t720 * t842);
    let t874 = t865 + t717 * t731 + (t864 + t720 * t846);
    let t875 = t872 + t717 * t732 + (t871 + t720 * t850);
    let t876 = t747 * t766;
    let t877 = t876 + t717 * t733 + (t876 + t720 * t856);
    let t878 = t777 * (t870 + t94 * t873 + t61 * t874 + t94 * t875 + t116 * t877);
    let t879 = u_hA * t782 + u_hB * t787 + u_hC * t791;
    let t880 = u_hA * t784 + u_hB * t788 + u_hC * t792;
    let t881 = t718 * t746 + t721 * t769;
    let t882 = t718 * t747 + t721 * t770;
    let t883 = u_hA * t723 + u_hB * t881 + u_hC * t882;
    let t884 = Ic1 * (t858 - t878 + (t768 * t879 - t775 * t880)) + t303 * (t795 * t883);
    let t885 = t750 * t772;
    let t886 = t750 * t773;
    let t887 = t757 * t772;
    let t888 = t51 * (t885 - t721 * t799 + (t885 + dzC * t860)) + t30 * (t886 - t721 * t808 + (t887 + dzC * t863));
    let t889 = t750 * t774;
    let t890 = t763 * t772;
    let t891 = t888 + t61 * (t889 - t721 * t818 + (t890 + dzC * t866)) + t30 * (t887 + t721 * t824 + (t886 + dzC * t867));
    let t892 = t757 * t773;
    let t893 = t757 * t774;
    let t894 = t763 * t773;
    let t895 = t891 + t79 * (t892 - t721 * t830 + (t892 + dzC * t869)) + t94 * (t893 - t721 * t839 + (t894 + dzC * t873));
    let t896 = t895 + t61 * (t890 - t721 * t844 + (t889 + dzC * t874)) + t94 * (t894 - t721 * t848 + (t893 + dzC * t875));
    let t897 = t763 * t774;
    let t898 = t750 * t755;
    let t899 = t750 * t761;
    let t900 = t757 * t755;
    let t901 = t51 * (t898 - t718 * t799 + (t898 + dzC * t803)) + t30 * (t899 - t718 * t808 + (t900 + dzC * t813));
    let t902 = t750 * t767;
    let t903 = t763 * t755;
    let t904 = t901 + t61 * (t902 - t718 * t818 + (t903 + dzC * t823)) + t30 * (t900 + t718 * t824 + (t899 + dzC * t827));
    let t905 = t757 * t761;
    let t906 = t757 * t767;
    let t907 = t763 * t761;
    let t908 = t904 + t79 * (t905 - t718 * t830 + (t905 + dzC * t833)) + t94 * (t906 - t718 * t839 + (t907 + dzC * t843));
    let t909 = t908 + t61 * (t903 - t718 * t844 + (t902 + dzC * t847)) + t94 * (t907 - t718 * t848 + (t906 + dzC * t851));
    let t910 = t763 * t767;
    let t911 = t720 * (t896 + t116 * (t897 - t721 * t854 + (t897 + dzC * t877))) - t783 * (t909 + t116 * (t910 - t718 * t854 + (t910 + dzC * t857)));
    let t912 = t719 * t772;
    let t913 = t722 * t755;
    let t914 = t912 + t721 * t724 + (t912 + t720 * t860) - (t913 - t718 * t736 + (t913 + t783 * t803));
    let t915 = t719 * t773;
    let t916 = t746 * t772;
    let t917 = t722 * t761;
    let t918 = t769 * t755;
    let t919 = t915 + t721 * t725 + (t916 + t720 * t863) - (t917 + t718 * t735 + (t918 + t783 * t813));
    let t920 = t719 * t774;
    let t921 = t747 * t772;
    let t922 = t722 * t767;
    let t923 = t770 * t755;
    let t924 = t920 + t721 * t726 + (t921 + t720 * t866) - (t922 - t718 * t737 + (t923 + t783 * t823));
    let t925 = t916 + t721 * t727 + (t915 + t720 * t867) - (t918 + t718 * t738 + (t917 + t783 * t827));
    let t926 = t746 * t773;
    let t927 = t769 * t761;
    let t928 = t926 + t721 * t728 + (t926 + t720 * t869) - (t927 - t718 * t739 + (t927 + t783 * t833));
    let t929 = t51 * t914 + t30 * t919 + t61 * t924 + t30 * t925 + t79 * t928;
    let t930 = t746 * t774;
    let t931 = t747 * t773;
    let t932 = t769 * t767;
    let t933 = t770 * t761;
    let t934 = t930 + t721 * t730 + (t931 + t720 * t873) - (t932 + t718 * t741 + (t933 + t783 * t843));
    let t935 = t921 + t721 * t731 + (t920 + t720 * t874) - (t923 - t718 * t742 + (t922 + t783 * t847));
    let t936 = t931 + t721 * t732 + (t930 + t720 * t875) - (t933 + t718 * t743 + (t932 + t783 * t851));
    let t937 = t747 * t774;
    let t938 = t770 * t767;
    let t939 = t937 + t721 * t733 + (t937 + t720 * t877) - (t938 - t718 * t744 + (t938 + t783 * t857));
    let t940 = dzC * (t929 + t94 * t934 + t61 * t935 + t94 * t936 + t116 * t939);
    let t941 = (u_hA * (t471 - t469) - u_hB * t757 - u_hC * t763) * (u_hA * t785 + u_hB * t789 + u_hC * t793);
    let t942 = Ic2 * (t911 - t940 + (t941 + (t748 * t879 - t771 * t880))) + t366 * (t781 * t883);
    let M = p.M;
    let t943 = 0.5_f32 * R;
    let t944 = 6.0_f32 * t3;
    let t945 = t7 * t944 - (t5 * t15 + t4 * t16);
    let t946 = t943 * t945;
    let t947 = 3.0_f32 * t4;
    let cos3 = t7 * t947 - t4 * t5;
    let t948 = t943 * cos3;
    let t949 = 0.33333334_f32 + (k * t946 - t948 * t20);
    let t950 = t15 * t34;
    let t951 = t3 * t16;
    let t952 = t4 * t41;
    let t953 = t950 + (t951 + t952);
    let t954 = t33 * t944;
    let t955 = t953 + t954;
    let t956 = t38 * t946;
    let t957 = t3 * t5 + t4 * t34;
    let t958 = t947 * t33;
    let t959 = 3.0_f32 * t3;
    let t960 = t7 * t959;
    let t961 = t957 + (t958 - t960);
    let t962 = t943 * t961;
    let t963 = t20 * t962;
    let t964 = t20 * t946;
    let t965 = t15 * t16;
    let t966 = t965 + (t965 + t4 * t54);
    let t967 = t30 * (k * (t943 * t955) - t956 - (t963 + t948 * t47)) - t51 * (t964 + t948 * t58 + (t964 + k * (t943 * t966)));
    let t968 = t65 * t946;
    let t969 = t953 - t954;
    let t970 = t957 - (t958 + t960);
    let t971 = t943 * t970;
    let t972 = t20 * t971;
    let t973 = t951 + (t950 + t952);
    let t974 = t954 + t973;
    let t975 = t967 + t61 * (t968 + k * (t943 * t969) - (t972 + t948 * t71)) + t30 * (k * (t943 * t974) - t963 - (t956 + t948 * t76));
    let t976 = t947 * t85;
    let t977 = t33 * t959;
    let t978 = t3 * t34;
    let t979 = t978 + (t978 + t4 * t84);
    let t980 = t976 - t977 - t977 - t979;
    let t981 = t38 * t962;
    let t982 = t65 * t962;
    let t983 = t979 + t976;
    let t984 = t38 * t971;
    let t985 = t975 + t79 * (k * (t943 * t980) - t981 - (t981 + t948 * t90)) + t94 * (t982 - k * (t943 * t983) - (t984 + t948 * t104));
    let t986 = t973 - t954;
    let t987 = t977 - t976 - t977 - t979;
    let t988 = t985 + t61 * (k * (t943 * t986) - t972 - (t948 * t108 - t968)) + t94 * (k * (t943 * t987) - t984 - (t948 * t112 - t982));
    let t989 = t65 * t971;
    let t990 = t977 + (t977 + t976) - t979;
    let t991 = t988 + t116 * (t989 + k * (t943 * t990) - (t948 * t120 - t989));
    let t992 = 1.0_f32 / t8;
    let shift = k * cos3 * t992;
    let t993 = t992 * (k * t945 - cos3 * t20 - shift * t18);
    let cos2 = t5 - t7;
    let t994 = t992 * cos2;
    let t995 = t992 * (t16 - t994 * t18);
    let t996 = t943 * (shift * t15 + t4 * t993 + t995);
    let t997 = t15 * t993;
    let t998 = t18 * t993;
    let t999 = t20 * t945;
    let t1000 = t998 + (t999 + cos3 * t58 + (t999 + k * t966) + (t998 + shift * t56));
    let t1001 = t992 * t1000;
    let t1002 = t18 * t995;
    let t1003 = t997 + (t997 - t4 * t1001) + t992 * (t54 - (t1002 + t994 * t56) - t1002);
    let t1004 = t992 * (k * t961 - cos3 * t38 - shift * t36);
    let t1005 = t15 * t1004;
    let t1006 = t38 * t945;
    let t1007 = t20 * t961;
    let t1008 = t18 * t1004;
    let t1009 = t36 * t993;
    let t1010 = k * t955 - t1006 - (t1007 + cos3 * t47) - (t1008 - shift * t44) - t1009;
    let t1011 = t992 * t1010;
    let t1012 = t3 * t993;
    let t1013 = t992 * (t62 + t994 * t36);
    let t1014 = t18 * t1013;
    let t1015 = t36 * t995;
    let t1016 = t1005 + (t4 * t1011 - t1012) + t992 * (t1014 + t994 * t44 - t41 - t1015);
    let t1017 = t992 * (cos3 * t65 + k * t970 + shift * t63);
    let t1018 = t15 * t1017;
    let t1019 = t65 * t945;
    let t1020 = t20 * t970;
    let t1021 = t18 * t1017;
    let t1022 = t63 * t993;
    let t1023 = t1019 + k * t969 - (t1020 + cos3 * t71) - (t1021 + shift * t68) + t1022;
    let t1024 = t992 * t1023;
    let t1025 = t63 * t995;
    let t1026 = t992 * (t35 + t994 * t63);
    let t1027 = t18 * t1026;
    let t1028 = t1018 + (t4 * t1024 - t1012) + t992 * (t1025 - (t41 + (t1027 + t994 * t68)));
    let t1029 = k * t974 - t1007 - (t1006 + cos3 * t76) - (t1009 - shift * t75) - t1008;
    let t1030 = t992 * t1029;
    let t1031 = t1005 + t4 * t1030 - t1012 + t992 * (t1014 - (t41 + (t1015 - t994 * t75)));
    let t1032 = t51 * (t943 * t1003) + t30 * (t943 * t1016) + t61 * (t943 * t1028) + t30 * (t943 * t1031);
    let t1033 = t38 * t961;
    let t1034 = t36 * t1004;
    let t1035 = k * t980 - t1033 - (t1033 + cos3 * t90) - (t1034 + shift * t88) - t1034;
    let t1036 = t992 * t1035;
    let t1037 = t3 * t1004;
    let t1038 = t36 * t1013;
    let t1039 = t4 * t1036 - t1037 - t1037 + t992 * (t1038 + (t99 - (t994 * t88 - t1038)));
    let t1040 = t65 * t961;
    let t1041 = t38 * t970;
    let t1042 = t36 * t1017;
    let t1043 = t63 * t1004;
    let t1044 = t1040 - k * t983 - (t1041 + cos3 * t104) - (t1042 + shift * t101) + t1043;
    let t1045 = t992 * t1044;
    let t1046 = t3 * t1017;
    let t1047 = t36 * t1026;
    let t1048 = t63 * t1013;
    let t1049 = t4 * t1045 - t1037 - t1046 + t992 * (t86 - (t1047 + t994 * t101) - t1048);
    let t1050 = k * t986 - t1020 - (cos3 * t108 - t1019) - (shift * t107 - t1022) - t1021;
    let t1051 = t992 * t1050;
    let t1052 = t1018 + t4 * t1051 - t1012 - t992 * (t1027 + (t41 + (t994 * t107 - t1025)));
    let t1053 = t1032 + t79 * (t943 * t1039) + t94 * (t943 * t1049) + t61 * (t943 * t1052);
    let t1054 = k * t987 - t1041 - (cos3 * t112 - t1040) - (shift * t111 - t1043) - t1042;
    let t1055 = t992 * t1054;
    let t1056 = t4 * t1055 - t1046 - t1037 + t992 * (t86 - (t1048 + t994 * t111) - t1047);
    let t1057 = t63 * t1017;
    let t1058 = t65 * t970;
    let t1059 = t1057 + (t1058 + k * t990 - (cos3 * t120 - t1058) - (shift * t118 - t1057));
    let t1060 = t992 * t1059;
    let t1061 = t63 * t1026;
    let t1062 = t4 * t1060 - t1046 - t1046 + t992 * (t1061 + (t99 - (t994 * t118 - t1061)));
    let t1063 = t1053 + t94 * (t943 * t1056) + t116 * (t943 * t1062);
    let t1064 = 4.0_f32 * t3;
    let t1065 = 2.0_f32 * t4;
    let sin2 = t6 * t1065;
    let t1066 = t992 * sin2;
    let t1067 = t992 * (t6 * t1064 - t1066 * t18);
    let t1068 = t943 * (t1067 - t6 * t993);
    let t1069 = t18 * t1067;
    let t1070 = t31 * t1064;
    let t1071 = t1065 * t31;
    let t1072 = t6 * t15;
    let t1073 = t992 * (t1071 - t1072 - t1066 * t36);
    let t1074 = t18 * t1073;
    let t1075 = t36 * t1067;
    let t1076 = t31 * t993;
    let t1077 = t943 * (t992 * (t1070 - (t1074 - t1066 * t44) - t1075) - (t1076 + t6 * t1011));
    let t1078 = t51 * (t943 * (t6 * t1001 - t992 * (t1069 + (t1069 + t1066 * t56)))) + t30 * t1077;
    let t1079 = t63 * t1067;
    let t1080 = t992 * (t1066 * t63 - (t1071 + t1072));
    let t1081 = t18 * t1080;
    let t1082 = t943 * (t992 * (t1079 - (t1070 + (t1081 + t1066 * t68))) - (t6 * t1024 - t1076));
    let t1083 = t943 * (t992 * (t1070 - (t1075 - t1066 * t75) - t1074) - (t1076 + t6 * t1030));
    let t1084 = t31 * t1004;
    let t1085 = t36 * t1073;
    let t1086 = 2.0_f32 * (t15 * t31);
    let t1087 = t1084 + (t1084 + t6 * t1036) + t992 * (t1085 + (t1086 + (t1085 + t1066 * t88)));
    let t1088 = t63 * t1073;
    let t1089 = t36 * t1080;
    let t1090 = t31 * t1017;
    let t1091 = t943 * (t992 * (t1088 - (t1089 + t1066 * t101)) - (t1090 + (t6 * t1045 - t1084)));
    let t1092 = t1078 + t61 * t1082 + t30 * t1083 - t79 * (t943 * t1087) + t94 * t1091;
    let t1093 = t943 * (t6 * t1051 - t1076 + t992 * (t1081 + (t1070 + (t1066 * t107 - t1079))));
    let t1094 = t943 * (t992 * (t1088 - t1066 * t111 - t1089) - (t1090 + t6 * t1055 - t1084));
    let t1095 = t63 * t1080;
    let t1096 = t992 * (t1095 + (t1086 - (t1066 * t118 - t1095))) - (t6 * t1060 - t1090 - t1090);
    let t1097 = t1092 - t61 * t1093 + t94 * t1094 + t116 * (t943 * t1096);
    let t1098 = t715 + (t723 * t796 + (t778 * t884 + t786 * t942)) + M * (t949 * t991 + (t996 * t1063 + t1068 * t1097));
    let t1099 = t369 - 1.0_f32;
    let t1100 = t373 * t161 + (t1099 * t22 - t24 * t28);
    let Iz = p.Iz;
    let t1101 = t51 * t213 + t30 * t224 + t61 * t236 + t30 * t242 + t79 * t248;
    let t1102 = t373 * (t1101 + t94 * t260 + t61 * t265 + t94 * t269 + t116 * t276);
    let t1103 = u_hB * t484 - u_hA * t470 + u_hC * t496;
    let t1104 = t480 - t479;
    let t1105 = t492 - t480;
    let t1106 = u_hB * t1104 - u_hA * t385 + u_hC * t1105;
    let t1107 = t1099 * t123 - t24 * t155 - t1102 + (t364 * t1103 + (t159 * t1106 - t159 * t183));
    let Iy = p.Iy;
    let Ix = p.Ix;
    let t1108 = t24 * t24 + t195 * t1099;
    let t1109 = t195 * t373 + t24 * t12;
    let t1110 = t12 * t1099 - t24 * t373;
    let t1111 = t1108 * t470 - (t1109 * t385 + t1110 * t22);
    let t1112 = t1109 * t1104 - t1110 * t157 - t1108 * t484;
    let t1113 = t1109 * t1105 - t1110 * t158 - t1108 * t496;
    let t1114 = u_hA * t1111 + u_hB * t1112 + u_hC * t1113;
    let t1115 = t373 * t28 - t195 * t470 + (t12 * t22 + t24 * t161);
    let t1116 = t1099 * t161 - t12 * t385 - (t373 * t22 - t24 * t470);
    let t1117 = 2.0_f32 * (t24 * t22) + (t1099 * t28 - t195 * t385);
    let t1118 = t24 * t1115 + t195 * t1116 - t12 * t1117;
    let t1119 = t373 * t168 + t195 * t484 + (t12 * t157 - t24 * t169);
    let t1120 = t12 * t1104 - t1099 * t169 - (t373 * t157 + t24 * t484);
    let t1121 = 2.0_f32 * (t24 * t157) + (t1099 * t168 + t195 * t1104);
    let t1122 = t24 * t1119 + t195 * t1120 - t12 * t1121;
    let t1123 = t373 * t182 + t195 * t496 + (t12 * t158 + t24 * t176);
    let t1124 = t1099 * t176 + t12 * t1105 - (t373 * t158 + t24 * t496);
    let t1125 = 2.0_f32 * (t24 * t158) + (t1099 * t182 + t195 * t1105);
    let t1126 = t24 * t1123 + t195 * t1124 - t12 * t1125;
    let t1127 = u_hA * t1118 + u_hB * t1122 + u_hC * t1126;
    let t1128 = Iz * t1107 + (Iy - Ix) * (t1114 * t1127);
    let t1129 = t408 - t406;
    let t1130 = t79 * t1129 - (t51 * t390 + t30 * t394 + t61 * t397 + t30 * t402);
    let t1131 = t416 - t414;
    let t1132 = t425 - t424;
    let t1133 = t429 - t428;
    let t1134 = t1109 * (t1130 + t94 * t1131 - t61 * t419 + t94 * t1132 + t116 * t1133);
    let t1135 = t93 + (t74 + (t60 + t30 * (t49 - t32)) + t30 * (t77 - t32)) - t106;
    let t1136 = t30 * t574 - (t51 * t535 + t30 * t547 + t61 * t564) - t79 * t583;
    let t1137 = t1108 * (t1136 - t94 * t593 - t61 * t604 - t94 * t610 - t116 * t619);
    let t1138 = u_hA * t1115 + u_hB * t1119 + u_hC * t1123;
    let t1139 = u_hA * t1116 + u_hB * t1120 + u_hC * t1124;
    let t1140 = u_hA * t1117 + u_hB * t1121 + u_hC * t1125;
    let t1141 = t1134 + t1110 * (t122 + (t110 + t1135 - t114)) - t1137 + (t1106 * t1138 - t159 * t1139 - t1103 * t1140);
    let t1142 = t1099 * t157 - t24 * t168 - t373 * t169;
    let t1143 = t373 * t176 + (t1099 * t158 - t24 * t182);
    let t1144 = u_hA * t1100 + u_hB * t1142 + u_hC * t1143;
    let t1145 = Ix * t1141 + (Iz - Iy) * (t1127 * t1144);
    let t1146 = t28 * t470;
    let t1147 = t22 * t161;
    let t1148 = t373 * t127 - t1146 - (t1146 + t195 * t535) + (t1147 - t12 * t59 + (t1147 - t24 * t213));
    let t1149 = t28 * t484;
    let t1150 = t168 * t470;
    let t1151 = t22 * t169;
    let t1152 = t157 * t161;
    let t1153 = t1149 + t373 * t131 - (t1150 + t195 * t547) + (t12 * t50 - t1151 + (t1152 - t24 * t224));
    let t1154 = t28 * t496;
    let t1155 = t182 * t470;
    let t1156 = t22 * t176;
    let t1157 = t158 * t161;
    let t1158 = t1154 + t373 * t135 - (t1155 + t195 * t564) + (t1156 - t12 * t73 + (t1157 - t24 * t236));
    let t1159 = t373 * t138 - t1150 + (t1149 + t195 * t574) + (t1152 + t12 * t78 - (t1151 + t24 * t242));
    let t1160 = t168 * t484;
    let t1161 = t157 * t169;
    let t1162 = t1160 + t373 * t143 + (t1160 - t195 * t583) - (t1161 + t12 * t92 + (t1161 + t24 * t248));
    let t1163 = t51 * t1148 + t30 * t1153 + t61 * t1158 + t30 * t1159 + t79 * t1162;
    let t1164 = t168 * t496;
    let t1165 = t182 * t484;
    let t1166 = t157 * t176;
    let t1167 = t158 * t169;
    let t1168 = t1164 + t373 * t148 + (t1165 - t195 * t593) + (t1166 + t12 * t105 - (t1167 + t24 * t260));
    let t1169 = t373 * t150 - t1155 + (t1154 - t195 * t604) + (t1157 - t12 * t109 + (t1156 - t24 * t265));
    let t1170 = t1165 + t373 * t152 + (t1164 - t195 * t610) + (t12 * t113 - t1167 + (t1166 - t24 * t269));
    let t1171 = t182 * t496;
    let t1172 = t158 * t176;
    let t1173 = t1171 + t373 * t154 + (t1171 - t195 * t619) + (t1172 - t12 * t121 + (t1172 - t24 * t276));
    let t1174 = t24 * (t1163 + t94 * t1168 + t61 * t1169 + t94 * t1170 + t116 * t1173);
    let t1175 = t22 * t470;
    let t1176 = t161 * t385;
    let t1177 = t1175 + t373 * t59 + (t1175 + t24 * t535) - (t1176 + t1099 * t213 + (t1176 + t12 * t390));
    let t1178 = t161 * t1104;
    let t1179 = t169 * t385;
    let t1180 = t22 * t484;
    let t1181 = t157 * t470;
    let t1182 = t1178 - t1099 * t224 - (t12 * t394 - t1179) - (t1180 + t373 * t50 - (t1181 + t24 * t547));
    let t1183 = t161 * t1105;
    let t1184 = t176 * t385;
    let t1185 = t22 * t496;
    let t1186 = t158 * t470;
    let t1187 = t1183 - t1099 * t236 - (t1184 + t12 * t397) - (t1185 - t373 * t73 - (t1186 + t24 * t564));
    let t1188 = t1178 - t12 * t402 - (t1099 * t242 - t1179) - (t373 * t78 - t1181 + (t1180 + t24 * t574));
    let t1189 = t169 * t1104;
    let t1190 = t157 * t484;
    let t1191 = t12 * t1129 - t1189 - (t1189 + t1099 * t248) - (t1190 - t373 * t92 + (t1190 - t24 * t583));
    let t1192 = t51 * t1177 + t30 * t1182 + t61 * t1187 + t30 * t1188 + t79 * t1191;
    let t1193 = t176 * t1104;
    let t1194 = t169 * t1105;
    let t1195 = t157 * t496;
    let t1196 = t158 * t484;
    let t1197 = t1193 + t12 * t1131 - (t1194 + t1099 * t260) - (t1195 + t373 * t105 + (t1196 - t24 * t593));
    let t1198 = t1183 - t12 * t419 - (t1184 + t1099 * t265) - (t1185 - t24 * t604 - (t1186 + t373 * t109));
    let t1199 = t1193 - t1099 * t269 + (t12 * t1132 - t1194) - (t1196 + t373 * t113 + (t1195 - t24 * t610));
    let t1200 = t176 * t1105;
    let t1201 = t158 * t496;
    let t1202 = t1200 - t1099 * t276 + (t1200 + t12 * t1133) - (t1201 - t373 * t121 + (t1201 - t24 * t619));
    let t1203 = t195 * (t1192 + t94 * t1197 + t61 * t1198 + t94 * t1199 + t116 * t1202);
    let t1204 = t28 * t385;
    let t1205 = 2.0_f32 * (t22 * t22 - t24 * t59) + (t1099 * t127 - t1204 - (t1204 + t195 * t390));
    let t1206 = t22 * t157;
    let t1207 = t28 * t1104;
    let t1208 = t168 * t385;
    let t1209 = 2.0_f32 * (t1206 + t24 * t50) + (t1207 + t1099 * t131 - (t1208 + t195 * t394));
    let t1210 = t22 * t158;
    let t1211 = t28 * t1105;
    let t1212 = t182 * t385;
    let t1213 = 2.0_f32 * (t1210 - t24 * t73) + (t1211 + t1099 * t135 - (t1212 + t195 * t397));
    let t1214 = 2.0_f32 * (t1206 + t24 * t78) + (t1099 * t138 - t1208 + (t1207 - t195 * t402));
    let t1215 = t168 * t1104;
    let t1216 = 2.0_f32 * (t157 * t157 - t24 * t92) + (t1215 + t1099 * t143 + (t1215 + t195 * t1129));
    let t1217 = t51 * t1205 + t30 * t1209 + t61 * t1213 + t30 * t1214 + t79 * t1216;
    let t1218 = t157 * t158;
    let t1219 = t168 * t1105;
    let t1220 = t182 * t1104;
    let t1221 = 2.0_f32 * (t1218 + t24 * t105) + (t1219 + t1099 * t148 + (t1220 + t195 * t1131));
    let t1222 = 2.0_f32 * (t1210 - t24 * t109) + (t1099 * t150 - t1212 + (t1211 - t195 * t419));
    let t1223 = 2.0_f32 * (t1218 + t24 * t113) + (t1220 + t1099 * t152 + (t1219 + t195 * t1132));
    let t1224 = t182 * t1105;
    let t1225 = 2.0_f32 * (t158 * t158 - t24 * t121) + (t1224 + t1099 * t154 + (t1224 + t195 * t1133));
    let t1226 = t12 * (t1217 + t94 * t1221 + t61 * t1222 + t94 * t1223 + t116 * t1225);
    let t1227 = Iy * (t1174 + t1203 - t1226 + (t159 * t1138 + t183 * t1139 - t364 * t1140));
    let t1228 = t1227 + (Ix - Iz) * (t1114 * t1144);
    let t1229 = M * g;
    let t1230 = t1 + (t2 + (t1098 + (t1100 * t1128 + (t1111 * t1145 + t1118 * t1228)))) + t1229 * t949;
    let forcing_u_hA = FA - u_hA * c - t1230;
    let mr = p.mr;
    let t1231 = Ic3 * t29;
    let t1232 = Ic1 * t191;
    let t1233 = Ic2 * t199;
    let t1234 = Ic3 * t388;
    let t1235 = Ic1 * t512;
    let t1236 = Ic2 * t519;
    let t1237 = mc + (ms + mr) + (t29 * t1231 + (t191 * t1232 + t199 * t1233)) + (t388 * t1234 + (t512 * t1235 + t519 * t1236));
    let t1238 = Ic3 * t723;
    let t1239 = Ic1 * t778;
    let t1240 = Ic2 * t786;
    let t1241 = t1237 + (t723 * t1238 + (t778 * t1239 + t786 * t1240)) + M * (t949 * t949 + (t996 * t996 + t1068 * t1068));
    let t1242 = Iz * t1100;
    let t1243 = Ix * t1111;
    let t1244 = Iy * t1118;
    let mass_u_hA_u_hA = t1241 + (t1100 * t1242 + (t1111 * t1243 + t1118 * t1244));
    let t1245 = 1.0_f32 / mass_u_hA_u_hA;
    let t1246 = t304 * t1231 + (t192 * t1232 + t203 * t1233) + (t649 * t1234 + (t513 * t1235 + t523 * t1236));
    let t1247 = 0.33333334_f32 + (k * t962 - t948 * t38);
    let t1248 = t3 * shift;
    let t1249 = t943 * (t4 * t1004 - t1248 - t1013);
    let t1250 = shift * t31;
    let t1251 = t943 * (t1073 - (t1250 + t6 * t1004));
    let t1252 = t1246 + (t881 * t1238 + (t779 * t1239 + t790 * t1240)) + M * (t949 * t1247 + (t996 * t1249 + t1068 * t1251));
    let mass_u_hA_u_hB = t1252 + (t1142 * t1242 + (t1112 * t1243 + t1122 * t1244));
    let t1253 = mass_u_hA_u_hB * t1245;
    let t1254 = Ic3 * t304;
    let t1255 = Ic1 * t192;
    let t1256 = Ic2 * t203;
    let t1257 = Ic3 * t649;
    let t1258 = Ic1 * t513;
    let t1259 = Ic2 * t523;
    let t1260 = mc + (mr + (ms + (t304 * t1254 + (t192 * t1255 + t203 * t1256)))) + (t649 * t1257 + (t513 * t1258 + t523 * t1259));
    let t1261 = Ic3 * t881;
    let t1262 = Ic1 * t779;
    let t1263 = Ic2 * t790;
    let t1264 = t1260 + (t881 * t1261 + (t779 * t1262 + t790 * t1263)) + M * (t1247 * t1247 + (t1249 * t1249 + t1251 * t1251));
    let t1265 = Iz * t1142;
    let t1266 = Ix * t1112;
    let t1267 = Iy * t1122;
    let mass_u_hB_u_hB = t1264 + (t1142 * t1265 + (t1112 * t1266 + t1122 * t1267));
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t1253;
    let t1268 = 1.0_f32 / pivot_1;
    let FB = inputs[1];
    let t1269 = t304 * t209 + (t192 * t307 + t203 * t367) + (t649 * t530 + (t513 * t652 + t523 * t714));
    let t1270 = t1269 + (t881 * t796 + (t779 * t884 + t790 * t942)) + M * (t1247 * t991 + (t1249 * t1063 + t1251 * t1097));
    let t1271 = t1 + (t2 + (t1270 + (t1142 * t1128 + (t1112 * t1145 + t1122 * t1228)))) + t1229 * t1247;
    let forcing_u_hB = FB - u_hB * c - t1271;
    let t1272 = forcing_u_hB - forcing_u_hA * t1253;
    let t1273 = t305 * t1254 + (t193 * t1255 + t207 * t1256) + (t650 * t1257 + (t514 * t1258 + t528 * t1259));
    let t1274 = 0.33333334_f32 + (t948 * t65 + k * t971);
    let t1275 = t943 * (t4 * t1017 - t1248 + t1026);
    let t1276 = t943 * (t1080 - (t6 * t1017 - t1250));
    let t1277 = t1273 + (t882 * t1261 + (t780 * t1262 + t794 * t1263)) + M * (t1247 * t1274 + (t1249 * t1275 + t1251 * t1276));
    let mass_u_hB_u_hC = t1277 + (t1143 * t1265 + (t1113 * t1266 + t1126 * t1267));
    let t1278 = t305 * t1231 + (t193 * t1232 + t207 * t1233) + (t650 * t1234 + (t514 * t1235 + t528 * t1236));
    let t1279 = t1278 + (t882 * t1238 + (t780 * t1239 + t794 * t1240)) + M * (t949 * t1274 + (t996 * t1275 + t1068 * t1276));
    let mass_u_hA_u_hC = t1279 + (t1143 * t1242 + (t1113 * t1243 + t1126 * t1244));
    let t1280 = mass_u_hB_u_hC - mass_u_hA_u_hC * t1253;
    let t1281 = t1280 * t1268;
    let FC = inputs[2];
    let t1282 = t305 * t209 + (t193 * t307 + t207 * t367) + (t650 * t530 + (t514 * t652 + t528 * t714));
    let t1283 = t1282 + (t882 * t796 + (t780 * t884 + t794 * t942)) + M * (t1274 * t991 + (t1275 * t1063 + t1276 * t1097));
    let t1284 = t1 + (t2 + (t1283 + (t1143 * t1128 + (t1113 * t1145 + t1126 * t1228)))) + t1229 * t1274;
    let forcing_u_hC = FC - u_hC * c - t1284;
    let t1285 = mass_u_hA_u_hC * t1245;
    let t1286 = t305 * (Ic3 * t305) + (t193 * (Ic1 * t193) + t207 * (Ic2 * t207)) + (t650 * (Ic3 * t650) + (t514 * (Ic1 * t514) + t528 * (Ic2 * t528)));
    let t1287 = mc + (mr + (ms + t1286)) + (t882 * (Ic3 * t882) + (t780 * (Ic1 * t780) + t794 * (Ic2 * t794)));
    let mass_u_hC_u_hC = t1287 + M * (t1274 * t1274 + (t1275 * t1275 + t1276 * t1276)) + (t1143 * (Iz * t1143) + (t1113 * (Ix * t1113) + t1126 * (Iy * t1126)));
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t1285 - t1280 * t1281;
    let t1288 = (forcing_u_hC - forcing_u_hA * t1285 - t1281 * t1272) / pivot_2;
    let t1289 = t1268 * t1272 - t1281 * t1288;
    let t1290 = forcing_u_hA * t1245 - t1253 * t1289 - t1285 * t1288;
    let t1291 = Real::min(Real::min(0.21652833_f32 * Real::abs(mass_u_hA_u_hA), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t1290, t1289, t1288], t1291)
}
///Kinetic and potential energy (J).
///
///1000 operations.
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
    let u_hA = u[0];
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let R = p.R;
    let t1 = 1.0_f32 / (3.0_f32 * R);
    let t2 = 2.0_f32 * (hA - 0.5_f32 * hB - 0.5_f32 * hC) * t1;
    let t3 = t2 * t2;
    let t4 = 2.0_f32 * (0.8660254_f32 * hB - 0.8660254_f32 * hC) * t1;
    let t5 = t4 * t4;
    let root = Real::sqrt(1.0_f32 + t3 + t5);
    let t6 = 1.0_f32 + root;
    let k = 1.0_f32 / (root * t6);
    let t7 = t3 * k;
    let t8 = t7 - 1.0_f32;
    let t9 = 1.0_f32 / root;
    let t10 = t2 * t9;
    let t11 = 1.0_f32 / Real::sqrt(1.0_f32 - t10 * t10);
    let t12 = t8 * t11;
    let t13 = 2.0_f32 * t1;
    let t14 = 2.0_f32 * (t2 * t13);
    let t15 = 0.5_f32 * t9;
    let t16 = t14 * t15;
    let t17 = k * (k * (t6 * t16 + root * t16));
    let t18 = t4 * (k * t13 - t2 * t17);
    let t19 = t2 * k;
    let t20 = t4 * t19;
    let t21 = t20 * t11;
    let t22 = t3 * t17;
    let t23 = k * t14;
    let t24 = t22 - t23;
    let t25 = t12 * t18 + t21 * t24;
    let Ic3 = p.Ic3;
    let t26 = Ic3 * t25;
    let t27 = t10 * t12;
    let t28 = t9 * (t13 - t10 * t16);
    let t29 = 0.5_f32 * t11;
    let t30 = t11 * (t11 * (2.0_f32 * (t10 * t28) * t29));
    let t31 = t11 * t18 + t20 * t30;
    let t32 = t10 * t21;
    let t33 = t11 * (t23 - t22) + t8 * t30;
    let t34 = t27 * t31 - t32 * t33;
    let Ic1 = p.Ic1;
    let t35 = Ic1 * t34;
    let t36 = 1.0_f32 - t7;
    let t37 = t36 * (t12 * t28 + t10 * t33) - t20 * (t21 * t28 + t10 * t31);
    let t38 = t10 * (t21 * t18 + t20 * t31 - (t12 * t24 + t36 * t33)) + t37;
    let Ic2 = p.Ic2;
    let t39 = Ic2 * t38;
    let t40 = 0.5_f32 * t20;
    let t41 = t5 * k;
    let t42 = 0.8660254_f32 * (1.0_f32 - t41);
    let t43 = t40 + t42;
    let t44 = 0.5_f32 * t10;
    let t45 = t4 * t9;
    let t46 = 0.8660254_f32 * t45;
    let dzB = t44 - t46;
    let t47 = 1.0_f32 / Real::sqrt(1.0_f32 - dzB * dzB);
    let t48 = t43 * t47;
    let t49 = 0.5_f32 * t24;
    let t50 = 0.8660254_f32 * t18;
    let t51 = t49 + t50;
    let t52 = 0.5_f32 * t36;
    let t53 = 0.8660254_f32 * t20;
    let t54 = t52 + t53;
    let t55 = t54 * t47;
    let t56 = 0.5_f32 * t18;
    let t57 = t5 * t17;
    let t58 = 0.8660254_f32 * t57;
    let t59 = t56 + t58;
    let t60 = t48 * t51 - t55 * t59;
    let t61 = Ic3 * t60;
    let t62 = t46 - t44;
    let t63 = t62 * t48;
    let t64 = 0.5_f32 * t28;
    let t65 = t9 * (t45 * t16);
    let t66 = 0.8660254_f32 * t65;
    let t67 = t64 + t66;
    let t68 = 0.5_f32 * t47;
    let t69 = t47 * (t47 * (2.0_f32 * (dzB * t67) * t68));
    let t70 = t47 * t51 + t54 * t69;
    let t71 = t62 * t55;
    let t72 = t47 * t59 + t43 * t69;
    let t73 = t63 * t70 - t71 * t72;
    let t74 = Ic1 * t73;
    let t75 = t43 * (t62 * t72 - t48 * t67) + t54 * (t62 * t70 - t55 * t67);
    let t76 = t62 * (t48 * t59 + t43 * t72 + (t55 * t51 + t54 * t70)) - t75;
    let t77 = Ic2 * t76;
    let t78 = mc + (ms + mr) + (t25 * t26 + (t34 * t35 + t38 * t39)) + (t60 * t61 + (t73 * t74 + t76 * t77));
    let t79 = t52 - t53;
    let dzC = t44 + t46;
    let t80 = 1.0_f32 / Real::sqrt(1.0_f32 - dzC * dzC);
    let t81 = t79 * t80;
    let t82 = t58 - t56;
    let t83 = t42 - t40;
    let t84 = t83 * t80;
    let t85 = t50 - t49;
    let t86 = t81 * t82 + t84 * t85;
    let t87 = Ic3 * t86;
    let t88 = dzC * t84;
    let t89 = t64 - t66;
    let t90 = 0.5_f32 * t80;
    let t91 = t80 * (t80 * (2.0_f32 * (dzC * t89) * t90));
    let t92 = t80 * (t49 - t50) + t79 * t91;
    let t93 = dzC * t81;
    let t94 = t80 * t82 + t83 * t91;
    let t95 = t88 * t92 - t93 * t94;
    let t96 = Ic1 * t95;
    let t97 = t53 - t52;
    let t98 = t83 * (t84 * t89 + dzC * t94) - t97 * (t81 * t89 + dzC * t92);
    let t99 = t98 - dzC * (t84 * t82 + t83 * t94 - (t81 * t85 + t97 * t92));
    let t100 = Ic2 * t99;
    let M = p.M;
    let t101 = 0.5_f32 * R;
    let t102 = t5 * (6.0_f32 * t1) - (t3 * t13 + t2 * t14);
    let t103 = 3.0_f32 * t2;
    let cos3 = t5 * t103 - t2 * t3;
    let t104 = t101 * cos3;
    let t105 = 0.33333334_f32 + (k * (t101 * t102) - t104 * t17);
    let t106 = 1.0_f32 / t6;
    let shift = k * cos3 * t106;
    let t107 = t106 * (k * t102 - cos3 * t17 - shift * t16);
    let cos2 = t3 - t5;
    let t108 = t106 * cos2;
    let t109 = t101 * (shift * t13 + t2 * t107 + t106 * (t14 - t108 * t16));
    let t110 = 2.0_f32 * t2;
    let sin2 = t4 * t110;
    let t111 = t106 * sin2;
    let t112 = t101 * (t106 * (t4 * (4.0_f32 * t1) - t111 * t16) - t4 * t107);
    let t113 = t78 + (t86 * t87 + (t95 * t96 + t99 * t100)) + M * (t105 * t105 + (t109 * t109 + t112 * t112));
    let t114 = t41 - 1.0_f32;
    let t115 = t45 * t28 + (t114 * t18 - t20 * t24);
    let Iz = p.Iz;
    let t116 = Iz * t115;
    let t117 = t20 * t20 + t36 * t114;
    let t118 = t36 * t45 + t20 * t10;
    let t119 = t10 * t114 - t20 * t45;
    let t120 = t117 * t65 - (t118 * t57 + t119 * t18);
    let Ix = p.Ix;
    let t121 = Ix * t120;
    let t122 = t20 * (t45 * t24 - t36 * t65 + (t10 * t18 + t20 * t28)) + t36 * (t114 * t28 - t10 * t57 - (t45 * t18 - t20 * t65));
    let t123 = t122 - t10 * (2.0_f32 * (t20 * t18) + (t114 * t24 - t36 * t57));
    let Iy = p.Iy;
    let t124 = Iy * t123;
    let mass_u_hA_u_hA = t113 + (t115 * t116 + (t120 * t121 + t123 * t124));
    let u_hB = u[1];
    let t125 = 1.7320508_f32 * t1;
    let t126 = t19 * t125;
    let t127 = t1 * k;
    let t128 = 2.0_f32 * (t4 * t125);
    let t129 = 2.0_f32 * (t1 * t2);
    let t130 = t128 - t129;
    let t131 = t15 * t130;
    let t132 = k * (k * (t6 * t131 + root * t131));
    let t133 = t126 - t4 * (t127 + t2 * t132);
    let t134 = k * t129;
    let t135 = t134 + t3 * t132;
    let t136 = t12 * t133 + t21 * t135;
    let t137 = t9 * (t1 + t10 * t131);
    let t138 = t11 * (t11 * (t29 * (2.0_f32 * (t10 * t137))));
    let t139 = t11 * t135 + t8 * t138;
    let t140 = t11 * t133 - t20 * t138;
    let t141 = t32 * t139 + t27 * t140;
    let t142 = t20 * (t10 * t140 - t21 * t137) + t36 * (t12 * t137 + t10 * t139);
    let t143 = t10 * (t21 * t133 + t20 * t140 - (t12 * t135 - t36 * t139)) - t142;
    let t144 = 0.5_f32 * t135;
    let t145 = 0.8660254_f32 * t133;
    let t146 = t144 + t145;
    let t147 = 0.5_f32 * t133;
    let t148 = t5 * t132;
    let t149 = k * t128;
    let t150 = 0.8660254_f32 * (t148 - t149);
    let t151 = t147 + t150;
    let t152 = t48 * t146 - t55 * t151;
    let t153 = 0.5_f32 * t137;
    let t154 = t9 * (t125 - t45 * t131);
    let t155 = 0.8660254_f32 * t154;
    let t156 = t153 + t155;
    let t157 = t47 * (t47 * (t68 * (2.0_f32 * (dzB * t156))));
    let t158 = t47 * t146 - t54 * t157;
    let t159 = t47 * t151 - t43 * t157;
    let t160 = t63 * t158 - t71 * t159;
    let t161 = t43 * (t48 * t156 + t62 * t159) + t54 * (t55 * t156 + t62 * t158);
    let t162 = t62 * (t48 * t151 + t43 * t159 + (t55 * t146 + t54 * t158)) - t161;
    let t163 = t136 * t26 + (t141 * t35 + t143 * t39) + (t152 * t61 + (t160 * t74 + t162 * t77));
    let t164 = t150 - t147;
    let t165 = t145 - t144;
    let t166 = t81 * t164 + t84 * t165;
    let t167 = t155 - t153;
    let t168 = t80 * (t80 * (t90 * (2.0_f32 * (dzC * t167))));
    let t169 = t80 * (t144 - t145) + t79 * t168;
    let t170 = t80 * t164 + t83 * t168;
    let t171 = t88 * t169 - t93 * t170;
    let t172 = t83 * (t84 * t167 + dzC * t170) - t97 * (t81 * t167 + dzC * t169);
    let t173 = t172 - dzC * (t84 * t164 + t83 * t170 - (t81 * t165 + t97 * t169));
    let t174 = t1 * t3 + t2 * t129;
    let t175 = t103 * t128;
    let t176 = t5 * (3.0_f32 * t1);
    let t177 = t174 + (t175 - t176);
    let t178 = 0.33333334_f32 + (k * (t101 * t177) - t104 * t132);
    let t179 = t106 * (k * t177 - cos3 * t132 - shift * t131);
    let t180 = t1 * shift;
    let t181 = t129 + t128;
    let t182 = t101 * (t2 * t179 - t180 - t106 * (t181 + t108 * t131));
    let t183 = t110 * t125;
    let t184 = t4 * t13;
    let t185 = shift * t125;
    let t186 = t101 * (t106 * (t183 - t184 - t111 * t131) - (t185 + t4 * t179));
    let t187 = t163 + (t166 * t87 + (t171 * t96 + t173 * t100)) + M * (t105 * t178 + (t109 * t182 + t112 * t186));
    let t188 = t114 * t133 - t20 * t135 - t45 * t137;
    let t189 = t149 - t148;
    let t190 = t118 * t189 - t119 * t133 - t117 * t154;
    let t191 = t20 * (t45 * t135 + t36 * t154 + (t10 * t133 - t20 * t137)) + t36 * (t10 * t189 - t114 * t137 - (t45 * t133 + t20 * t154));
    let t192 = t191 - t10 * (2.0_f32 * (t20 * t133) + (t114 * t135 + t36 * t189));
    let mass_u_hA_u_hB = t187 + (t188 * t116 + (t190 * t121 + t192 * t124));
    let u_hC = u[2];
    let t193 = t15 * t181;
    let t194 = k * (k * (t6 * t193 + root * t193));
    let t195 = t4 * (t2 * t194 - t127) - t126;
    let t196 = t3 * t194;
    let t197 = t134 - t196;
    let t198 = t12 * t195 + t21 * t197;
    let t199 = t9 * (t10 * t193 - t1);
    let t200 = t11 * (t11 * (t29 * (2.0_f32 * (t10 * t199))));
    let t201 = t11 * t195 + t20 * t200;
    let t202 = t11 * (t196 - t134) + t8 * t200;
    let t203 = t27 * t201 - t32 * t202;
    let t204 = t36 * (t12 * t199 + t10 * t202) - t20 * (t21 * t199 + t10 * t201);
    let t205 = t10 * (t21 * t195 + t20 * t201 - (t12 * t197 + t36 * t202)) + t204;
    let t206 = 0.5_f32 * t197;
    let t207 = 0.8660254_f32 * t195;
    let t208 = t206 + t207;
    let t209 = 0.5_f32 * t195;
    let t210 = t5 * t194;
    let t211 = 0.8660254_f32 * (t149 - t210);
    let t212 = t209 + t211;
    let t213 = t48 * t208 - t55 * t212;
    let t214 = 0.5_f32 * t199;
    let t215 = t9 * (t45 * t193 - t125);
    let t216 = 0.8660254_f32 * t215;
    let t217 = t47 * (t47 * (t68 * (2.0_f32 * (dzB * (t214 - t216)))));
    let t218 = t47 * t208 + t54 * t217;
    let t219 = t47 * t212 + t43 * t217;
    let t220 = t63 * t218 - t71 * t219;
    let t221 = t216 - t214;
    let t222 = t43 * (t48 * t221 + t62 * t219) + t54 * (t55 * t221 + t62 * t218);
    let t223 = t62 * (t48 * t212 + t43 * t219 + (t55 * t208 + t54 * t218)) - t222;
    let t224 = t198 * t26 + (t203 * t35 + t205 * t39) + (t213 * t61 + (t220 * t74 + t223 * t77));
    let t225 = t211 - t209;
    let t226 = t207 - t206;
    let t227 = t81 * t225 + t84 * t226;
    let t228 = t214 + t216;
    let t229 = t80 * (t80 * (t90 * (2.0_f32 * (dzC * t228))));
    let t230 = t80 * (t206 - t207) + t79 * t229;
    let t231 = t80 * t225 + t83 * t229;
    let t232 = t88 * t230 - t93 * t231;
    let t233 = t83 * (t84 * t228 + dzC * t231) - t97 * (t81 * t228 + dzC * t230);
    let t234 = t233 - dzC * (t84 * t225 + t83 * t231 - (t81 * t226 + t97 * t230));
    let t235 = t174 - (t175 + t176);
    let t236 = 0.33333334_f32 + (t104 * t194 + k * (t101 * t235));
    let t237 = t106 * (cos3 * t194 + k * t235 + shift * t193);
    let t238 = t101 * (t2 * t237 - t180 + t106 * (t130 + t108 * t193));
    let t239 = t101 * (t106 * (t111 * t193 - (t183 + t184)) - (t4 * t237 - t185));
    let t240 = t224 + (t227 * t87 + (t232 * t96 + t234 * t100)) + M * (t105 * t236 + (t109 * t238 + t112 * t239));
    let t241 = t45 * t199 + (t114 * t195 - t20 * t197);
    let t242 = t210 - t149;
    let t243 = t118 * t242 - t119 * t195 - t117 * t215;
    let t244 = t20 * (t45 * t197 + t36 * t215 + (t10 * t195 + t20 * t199)) + t36 * (t114 * t199 + t10 * t242 - (t45 * t195 + t20 * t215));
    let t245 = t244 - t10 * (2.0_f32 * (t20 * t195) + (t114 * t197 + t36 * t242));
    let mass_u_hA_u_hC = t240 + (t241 * t116 + (t243 * t121 + t245 * t124));
    let t246 = 0.5_f32 * (u_hA * u_hA * mass_u_hA_u_hA) + u_hA * u_hB * mass_u_hA_u_hB + u_hA * u_hC * mass_u_hA_u_hC;
    let t247 = Ic3 * t136;
    let t248 = Ic1 * t141;
    let t249 = Ic2 * t143;
    let t250 = Ic3 * t152;
    let t251 = Ic1 * t160;
    let t252 = Ic2 * t162;
    let t253 = mc + (mr + (ms + (t136 * t247 + (t141 * t248 + t143 * t249)))) + (t152 * t250 + (t160 * t251 + t162 * t252));
    let t254 = Ic3 * t166;
    let t255 = Ic1 * t171;
    let t256 = Ic2 * t173;
    let t257 = t253 + (t166 * t254 + (t171 * t255 + t173 * t256)) + M * (t178 * t178 + (t182 * t182 + t186 * t186));
    let t258 = Iz * t188;
    let t259 = Ix * t190;
    let t260 = Iy * t192;
    let mass_u_hB_u_hB = t257 + (t188 * t258 + (t190 * t259 + t192 * t260));
    let t261 = t198 * t247 + (t203 * t248 + t205 * t249) + (t213 * t250 + (t220 * t251 + t223 * t252));
    let t262 = t261 + (t227 * t254 + (t232 * t255 + t234 * t256)) + M * (t178 * t236 + (t182 * t238 + t186 * t239));
    let mass_u_hB_u_hC = t262 + (t241 * t258 + (t243 * t259 + t245 * t260));
    let t263 = t198 * (Ic3 * t198) + (t203 * (Ic1 * t203) + t205 * (Ic2 * t205)) + (t213 * (Ic3 * t213) + (t220 * (Ic1 * t220) + t223 * (Ic2 * t223)));
    let t264 = mc + (mr + (ms + t263)) + (t227 * (Ic3 * t227) + (t232 * (Ic1 * t232) + t234 * (Ic2 * t234)));
    let mass_u_hC_u_hC = t264 + M * (t236 * t236 + (t238 * t238 + t239 * t239)) + (t241 * (Iz * t241) + (t243 * (Ix * t243) + t245 * (Iy * t245)));
    let t265 = t246 + 0.5_f32 * (u_hB * u_hB * mass_u_hB_u_hB) + u_hB * u_hC * mass_u_hB_u_hC + 0.5_f32 * (u_hC * u_hC * mass_u_hC_u_hC);
    let g = p.g;
    let t266 = hA * g;
    let t267 = hB * g;
    let t268 = hC * g;
    let t269 = ms * t266 + mc * t266 + ms * t267 + mc * t267 + ms * t268;
    let heave = 0.33333334_f32 * (hC + (hA + hB));
    let rise = k * t104;
    let t270 = t269 + mc * t268 + M * (g * (heave + rise));
    (t265, t270)
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
///102 operations.
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
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let t2 = 1.0_f32 / (3.0_f32 * R);
    let t3 = 2.0_f32 * (hA - 0.5_f32 * hB - 0.5_f32 * hC) * t2;
    let t4 = t3 * t3;
    let t5 = 2.0_f32 * (0.8660254_f32 * hB - 0.8660254_f32 * hC) * t2;
    let t6 = t5 * t5;
    let root = Real::sqrt(1.0_f32 + t4 + t6);
    let t7 = 1.0_f32 + root;
    let t8 = 1.0_f32 / t7;
    let sin2 = t5 * (2.0_f32 * t3);
    let k = 1.0_f32 / (root * t7);
    let cos3 = t6 * (3.0_f32 * t3) - t3 * t4;
    let shift = k * cos3 * t8;
    let shift_y = t1 * (t8 * sin2 - t5 * shift);
    let cos2 = t4 - t6;
    let shift_x = -t1 * (t3 * shift + t8 * cos2);
    let heave = 0.33333334_f32 * (hC + (hA + hB));
    let rise = k * (t1 * cos3);
    let t9 = heave + rise;
    let t10 = t5 * (t3 * k);
    let t11 = 1.0_f32 - t4 * k;
    let t12 = Real::atan2(-t10, t11);
    let t13 = 1.0_f32 / root;
    let t14 = t3 * t13;
    let t15 = 0.5_f32 * (t4 + t6);
    let sA = R * (1.0_f32 + t8 * (cos2 + t15));
    let t16 = 0.5_f32 * t11;
    let t17 = 0.8660254_f32 * t10;
    let t18 = t16 + t17;
    let t19 = 0.5_f32 * t10;
    let t20 = 0.8660254_f32 * (1.0_f32 - t6 * k);
    let t21 = t19 + t20;
    let t22 = Real::atan2(0.8660254_f32 * t18 - 0.5_f32 * t21, 0.8660254_f32 * t21 + 0.5_f32 * t18);
    let t23 = 0.5_f32 * t14;
    let t24 = 0.8660254_f32 * (t5 * t13);
    let dzB = t23 - t24;
    let t25 = Real::asin(dzB);
    let t26 = t15 - 0.5_f32 * cos2;
    let t27 = 0.8660254_f32 * sin2;
    let sB = R * (1.0_f32 + t8 * (t26 - t27));
    let t28 = t19 - t20;
    let t29 = t16 - t17;
    let t30 = Real::atan2(-(0.5_f32 * t28 + 0.8660254_f32 * t29), 0.5_f32 * t29 - 0.8660254_f32 * t28);
    let dzC = t23 + t24;
    let t31 = Real::asin(dzC);
    let sC = R * (1.0_f32 + t8 * (t26 + t27));
    [-shift_y, shift_x, t9, t12, -Real::asin(t14), sA, t22, t25, sB, t30, t31, sC]
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
