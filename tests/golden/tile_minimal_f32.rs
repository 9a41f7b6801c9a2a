// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 3; the worst over 73 sampled configurations is 0.773 of its nominal size.
// Cost of rates: 4538 operations (3 abs, 1337 add, 10 div, 2 min, 2486 mul, 4 sqrt, 696 sub).
// Cost of energy: 996 operations (228 add, 7 div, 631 mul, 4 sqrt, 126 sub).
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
///4538 operations.
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
    let g = p.g;
    let ms = p.ms;
    let mc = p.mc;
    let t1 = ms + mc;
    let t2 = g * t1;
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
    let t9 = 0.5_f32 * R;
    let t10 = 6.0_f32 * t3;
    let t11 = 2.0_f32 * t3;
    let t12 = 2.0_f32 * (t4 * t11);
    let t13 = t7 * t10 - (t5 * t11 + t4 * t12);
    let t14 = t9 * t13;
    let t15 = 3.0_f32 * t4;
    let cos3 = t7 * t15 - t4 * t5;
    let t16 = t9 * cos3;
    let t17 = 1.0_f32 / root;
    let t18 = 0.5_f32 * t17;
    let t19 = t12 * t18;
    let t20 = t8 * t19 + root * t19;
    let t21 = k * (k * t20);
    let t22 = 0.33333334_f32 + (k * t14 - t16 * t21);
    let M = p.M;
    let t23 = u_hA * u_hB;
    let t24 = 2.0_f32 * (t3 * t4);
    let t25 = t11 * t24;
    let t26 = t3 * t12;
    let t27 = 2.0_f32 * (t3 * t11);
    let t28 = t4 * t27;
    let t29 = t25 + (t26 + t28);
    let t30 = 1.7320508_f32 * t3;
    let t31 = 2.0_f32 * (t6 * t30);
    let t32 = t31 * t10;
    let t33 = t29 + t32;
    let t34 = t31 - t24;
    let t35 = t18 * t34;
    let t36 = t8 * t35 + root * t35;
    let t37 = k * (k * t36);
    let t38 = t37 * t14;
    let t39 = t3 * t5 + t4 * t24;
    let t40 = t15 * t31;
    let t41 = 3.0_f32 * t3;
    let t42 = t7 * t41;
    let t43 = t39 + (t40 - t42);
    let t44 = t9 * t43;
    let t45 = t21 * t44;
    let t46 = t19 * t35;
    let t47 = t18 * t27;
    let t48 = t17 * (t18 * t35);
    let t49 = t47 + t12 * t48;
    let t50 = t20 * t37;
    let t51 = t21 * t36;
    let t52 = k * (k * (t46 - t8 * t49 + (t46 - root * t49)) - t50 - t51);
    let t53 = u_hA * u_hA;
    let t54 = t21 * t14;
    let t55 = t19 * t19;
    let t56 = 2.0_f32 * (t11 * t11);
    let t57 = t17 * (t18 * t19);
    let t58 = t18 * t56 - t12 * t57;
    let t59 = t20 * t21;
    let t60 = k * (k * (t55 + t8 * t58 + (t55 + root * t58)) - t59 - t59);
    let t61 = t11 * t12;
    let t62 = t61 + (t61 + t4 * t56);
    let t63 = t23 * (k * (t9 * t33) - t38 - (t45 + t16 * t52)) - t53 * (t54 + t16 * t60 + (t54 + k * (t9 * t62)));
    let t64 = u_hA * u_hC;
    let t65 = t24 + t31;
    let t66 = t18 * t65;
    let t67 = t8 * t66 + root * t66;
    let t68 = k * (k * t67);
    let t69 = t68 * t14;
    let t70 = t29 - t32;
    let t71 = t39 - (t40 + t42);
    let t72 = t9 * t71;
    let t73 = t21 * t72;
    let t74 = t20 * t68;
    let t75 = t17 * (t18 * t66);
    let t76 = t12 * t75 - t47;
    let t77 = t19 * t66;
    let t78 = t21 * t67;
    let t79 = k * (t74 + k * (t8 * t76 - t77 + (root * t76 - t77)) + t78);
    let t80 = t26 + (t25 + t28);
    let t81 = t32 + t80;
    let t82 = t47 + t34 * t57;
    let t83 = k * (k * (t46 - t8 * t82 + (t46 - root * t82)) - t51 - t50);
    let t84 = t63 + t64 * (t69 + k * (t9 * t70) - (t73 + t16 * t79)) + t23 * (k * (t9 * t81) - t45 - (t38 + t16 * t83));
    let t85 = u_hB * u_hB;
    let t86 = 2.0_f32 * (t30 * t30);
    let t87 = t15 * t86;
    let t88 = t31 * t41;
    let t89 = t3 * t24;
    let t90 = 2.0_f32 * (t3 * t3);
    let t91 = t89 + (t89 + t4 * t90);
    let t92 = t87 - t88 - t88 - t91;
    let t93 = t37 * t44;
    let t94 = t35 * t35;
    let t95 = t90 + t86;
    let t96 = t18 * t95;
    let t97 = t96 - t34 * t48;
    let t98 = t36 * t37;
    let t99 = k * (k * (t94 + t8 * t97 + (t94 + root * t97)) - t98 - t98);
    let t100 = u_hB * u_hC;
    let t101 = t68 * t44;
    let t102 = t91 + t87;
    let t103 = t37 * t72;
    let t104 = t36 * t68;
    let t105 = t90 - t86;
    let t106 = t18 * t105;
    let t107 = t34 * t75 + t106;
    let t108 = t35 * t66;
    let t109 = t37 * t67;
    let t110 = k * (t104 + k * (t8 * t107 - t108 + (root * t107 - t108)) + t109);
    let t111 = t84 + t85 * (k * (t9 * t92) - t93 - (t93 + t16 * t99)) + t100 * (t101 - k * (t9 * t102) - (t103 + t16 * t110));
    let t112 = t80 - t32;
    let t113 = t65 * t57 - t47;
    let t114 = k * (t74 + (t78 + k * (t8 * t113 - t77 + (root * t113 - t77))));
    let t115 = t88 - t87 - t88 - t91;
    let t116 = t106 + t65 * t48;
    let t117 = k * (t104 + (t109 + k * (t8 * t116 - t108 + (root * t116 - t108))));
    let t118 = t111 + t64 * (k * (t9 * t112) - t73 - (t16 * t114 - t69)) + t100 * (k * (t9 * t115) - t103 - (t16 * t117 - t101));
    let t119 = u_hC * u_hC;
    let t120 = t68 * t72;
    let t121 = t88 + (t88 + t87) - t91;
    let t122 = t66 * t66;
    let t123 = t96 - t65 * t75;
    let t124 = t67 * t68;
    let t125 = k * (k * (t122 + t8 * t123 + (t122 + root * t123)) - t124 - t124);
    let t126 = g + (t118 + t119 * (t120 + k * (t9 * t121) - (t16 * t125 - t120)));
    let t127 = M * t126;
    let t128 = 1.0_f32 / t8;
    let t129 = 4.0_f32 * t3;
    let t130 = 2.0_f32 * t4;
    let sin2 = t6 * t130;
    let t131 = t128 * sin2;
    let t132 = t128 * (t6 * t129 - t131 * t19);
    let shift = k * cos3 * t128;
    let t133 = t128 * (k * t13 - cos3 * t21 - shift * t19);
    let t134 = t9 * (t132 - t6 * t133);
    let t135 = t19 * t133;
    let t136 = t21 * t13;
    let t137 = t135 + (t136 + cos3 * t60 + (t136 + k * t62) + (t135 + shift * t58));
    let t138 = t128 * t137;
    let t139 = t19 * t132;
    let t140 = t30 * t129;
    let t141 = t130 * t30;
    let t142 = t6 * t11;
    let t143 = t128 * (t141 - t142 - t131 * t35);
    let t144 = t19 * t143;
    let t145 = t35 * t132;
    let t146 = t30 * t133;
    let t147 = t37 * t13;
    let t148 = t21 * t43;
    let t149 = t128 * (k * t43 - cos3 * t37 - shift * t35);
    let t150 = t19 * t149;
    let t151 = t35 * t133;
    let t152 = k * t33 - t147 - (t148 + cos3 * t52) - (t150 - shift * t49) - t151;
    let t153 = t128 * t152;
    let t154 = t9 * (t128 * (t140 - (t144 - t131 * t49) - t145) - (t146 + t6 * t153));
    let t155 = t53 * (t9 * (t6 * t138 - t128 * (t139 + (t139 + t131 * t58)))) + t23 * t154;
    let t156 = t66 * t132;
    let t157 = t128 * (t131 * t66 - (t141 + t142));
    let t158 = t19 * t157;
    let t159 = t68 * t13;
    let t160 = t21 * t71;
    let t161 = t128 * (cos3 * t68 + k * t71 + shift * t66);
    let t162 = t19 * t161;
    let t163 = t66 * t133;
    let t164 = t159 + k * t70 - (t160 + cos3 * t79) - (t162 + shift * t76) + t163;
    let t165 = t128 * t164;
    let t166 = t9 * (t128 * (t156 - (t140 + (t158 + t131 * t76))) - (t6 * t165 - t146));
    let t167 = k * t81 - t148 - (t147 + cos3 * t83) - (t151 - shift * t82) - t150;
    let t168 = t128 * t167;
    let t169 = t9 * (t128 * (t140 - (t145 - t131 * t82) - t144) - (t146 + t6 * t168));
    let t170 = t30 * t149;
    let t171 = t37 * t43;
    let t172 = t35 * t149;
    let t173 = k * t92 - t171 - (t171 + cos3 * t99) - (t172 + shift * t97) - t172;
    let t174 = t128 * t173;
    let t175 = t35 * t143;
    let t176 = 2.0_f32 * (t11 * t30);
    let t177 = t170 + (t170 + t6 * t174) + t128 * (t175 + (t176 + (t175 + t131 * t97)));
    let t178 = t66 * t143;
    let t179 = t35 * t157;
    let t180 = t30 * t161;
    let t181 = t68 * t43;
    let t182 = t37 * t71;
    let t183 = t35 * t161;
    let t184 = t66 * t149;
    let t185 = t181 - k * t102 - (t182 + cos3 * t110) - (t183 + shift * t107) + t184;
    let t186 = t128 * t185;
    let t187 = t9 * (t128 * (t178 - (t179 + t131 * t107)) - (t180 + (t6 * t186 - t170)));
    let t188 = t155 + t64 * t166 + t23 * t169 - t85 * (t9 * t177) + t100 * t187;
    let t189 = k * t112 - t160 - (cos3 * t114 - t159) - (shift * t113 - t163) - t162;
    let t190 = t128 * t189;
    let t191 = t9 * (t6 * t190 - t146 + t128 * (t158 + (t140 + (t131 * t113 - t156))));
    let t192 = k * t115 - t182 - (cos3 * t117 - t181) - (shift * t116 - t184) - t183;
    let t193 = t128 * t192;
    let t194 = t9 * (t128 * (t178 - t131 * t116 - t179) - (t180 + t6 * t193 - t170));
    let t195 = t66 * t157;
    let t196 = t66 * t161;
    let t197 = t68 * t71;
    let t198 = t196 + (t197 + k * t121 - (cos3 * t125 - t197) - (shift * t123 - t196));
    let t199 = t128 * t198;
    let t200 = t128 * (t195 + (t176 - (t131 * t123 - t195))) - (t6 * t199 - t180 - t180);
    let t201 = M * (t188 - t64 * t191 + t100 * t194 + t119 * (t9 * t200));
    let cos2 = t5 - t7;
    let t202 = t128 * cos2;
    let t203 = t128 * (t12 - t202 * t19);
    let t204 = t9 * (shift * t11 + t4 * t133 + t203);
    let t205 = t11 * t133;
    let t206 = t19 * t203;
    let t207 = t205 + (t205 - t4 * t138) + t128 * (t56 - (t206 + t202 * t58) - t206);
    let t208 = t11 * t149;
    let t209 = t3 * t133;
    let t210 = t128 * (t65 + t202 * t35);
    let t211 = t19 * t210;
    let t212 = t35 * t203;
    let t213 = t208 + (t4 * t153 - t209) + t128 * (t211 + t202 * t49 - t27 - t212);
    let t214 = t11 * t161;
    let t215 = t66 * t203;
    let t216 = t128 * (t34 + t202 * t66);
    let t217 = t19 * t216;
    let t218 = t214 + (t4 * t165 - t209) + t128 * (t215 - (t27 + (t217 + t202 * t76)));
    let t219 = t208 + t4 * t168 - t209 + t128 * (t211 - (t27 + (t212 - t202 * t82)));
    let t220 = t53 * (t9 * t207) + t23 * (t9 * t213) + t64 * (t9 * t218) + t23 * (t9 * t219);
    let t221 = t3 * t149;
    let t222 = t35 * t210;
    let t223 = t4 * t174 - t221 - t221 + t128 * (t222 + (t105 - (t202 * t97 - t222)));
    let t224 = t3 * t161;
    let t225 = t35 * t216;
    let t226 = t66 * t210;
    let t227 = t4 * t186 - t221 - t224 + t128 * (t95 - (t225 + t202 * t107) - t226);
    let t228 = t214 + t4 * t190 - t209 - t128 * (t217 + (t27 + (t202 * t113 - t215)));
    let t229 = t220 + t85 * (t9 * t223) + t100 * (t9 * t227) + t64 * (t9 * t228);
    let t230 = t4 * t193 - t224 - t221 + t128 * (t95 - (t226 + t202 * t116) - t225);
    let t231 = t66 * t216;
    let t232 = t4 * t199 - t224 - t224 + t128 * (t231 + (t105 - (t202 * t123 - t231)));
    let t233 = M * (t229 + t100 * (t9 * t230) + t119 * (t9 * t232));
    let t234 = t5 * k;
    let t235 = t234 - 1.0_f32;
    let t236 = t4 * t17;
    let t237 = 1.0_f32 / Real::sqrt(1.0_f32 - t236 * t236);
    let t238 = t235 * t237;
    let t239 = k * t11 - t4 * t21;
    let t240 = t6 * t239;
    let t241 = t4 * k;
    let t242 = t6 * t241;
    let t243 = t242 * t237;
    let t244 = t5 * t21;
    let t245 = k * t12;
    let t246 = t244 - t245;
    let t247 = t238 * t240 + t243 * t246;
    let Ic3 = p.Ic3;
    let t248 = t239 * t30;
    let t249 = t11 * t37;
    let t250 = t3 * t21;
    let t251 = t6 * (t249 + (t4 * t52 - t250));
    let t252 = t248 - t251;
    let t253 = t11 * t21;
    let t254 = t6 * (t253 + (t253 + t4 * t60));
    let t255 = t53 * t254;
    let t256 = t11 * t68;
    let t257 = t248 + t6 * (t4 * t79 - t250 - t256);
    let t258 = t64 * t257;
    let t259 = t6 * (t249 + t4 * t83 - t250);
    let t260 = t248 - t259;
    let t261 = t3 * k;
    let t262 = t261 + t4 * t37;
    let t263 = t30 * t262;
    let t264 = t3 * t37;
    let t265 = t263 + (t263 + t6 * (t4 * t99 - t264 - t264));
    let t266 = t85 * t265;
    let t267 = t4 * t68 - t261;
    let t268 = t30 * t267;
    let t269 = t3 * t68;
    let t270 = t268 + (t263 - t6 * (t269 + (t4 * t110 - t264)));
    let t271 = t100 * t270;
    let t272 = t248 + t6 * (t4 * t114 - t256 - t250);
    let t273 = t64 * t272;
    let t274 = t263 + (t268 - t6 * (t269 + t4 * t117 - t264));
    let t275 = t100 * t274;
    let t276 = t23 * t252 - t255 - t258 + t23 * t260 - t266 + t271 - t273 + t275;
    let t277 = t268 + (t268 + t6 * (t269 + (t269 + t4 * t125)));
    let t278 = t119 * t277;
    let t279 = t276 - t278;
    let t280 = t12 * t21;
    let t281 = t280 + t5 * t60;
    let t282 = k * t56 - t280;
    let t283 = t281 - t282;
    let t284 = t12 * t37;
    let t285 = k * t27;
    let t286 = t21 * t24;
    let t287 = t284 + t285 + (t5 * t52 - t286);
    let t288 = t5 * t79 - t286;
    let t289 = t12 * t68;
    let t290 = t289 - t285;
    let t291 = t288 - t290;
    let t292 = t284 + t5 * t83;
    let t293 = t286 - t285;
    let t294 = t292 - t293;
    let t295 = t24 * t37;
    let t296 = t5 * t99 - t295;
    let t297 = k * t90;
    let t298 = t295 + t297;
    let t299 = t296 - t298;
    let t300 = t53 * t283 + t23 * t287 + t64 * t291 + t23 * t294 + t85 * t299;
    let t301 = t5 * t110 - t295;
    let t302 = t24 * t68;
    let t303 = t297 - t302;
    let t304 = t301 - t303;
    let t305 = t5 * t114 - t289;
    let t306 = t305 - t293;
    let t307 = t302 + t5 * t117;
    let t308 = t307 - t298;
    let t309 = t302 + t5 * t125;
    let t310 = t309 - t303;
    let t311 = t300 + t100 * t304 + t64 * t306 + t100 * t308 + t119 * t310;
    let t312 = t241 * t30;
    let t313 = t312 - t6 * t262;
    let t314 = t6 * t267 - t312;
    let t315 = u_hA * t240 + u_hB * t313 + u_hC * t314;
    let t316 = t245 - t244;
    let t317 = t17 * (t11 - t236 * t19);
    let t318 = 2.0_f32 * (t236 * t317);
    let t319 = 0.5_f32 * t237;
    let t320 = t318 * t319;
    let t321 = t237 * (t237 * t320);
    let t322 = t237 * t316 + t235 * t321;
    let t323 = k * t24;
    let t324 = t323 + t5 * t37;
    let t325 = t17 * (t3 + t236 * t35);
    let t326 = 2.0_f32 * (t236 * t325);
    let t327 = t319 * t326;
    let t328 = t237 * (t237 * t327);
    let t329 = t237 * t324 + t235 * t328;
    let t330 = t5 * t68;
    let t331 = t330 - t323;
    let t332 = t17 * (t236 * t66 - t3);
    let t333 = 2.0_f32 * (t236 * t332);
    let t334 = t319 * t333;
    let t335 = t237 * (t237 * t334);
    let t336 = t237 * t331 + t235 * t335;
    let t337 = u_hA * t322 - u_hB * t329 + u_hC * t336;
    let t338 = t323 - t330;
    let t339 = u_hA * t246 + u_hB * t324 + u_hC * t338;
    let t340 = t237 * t240 + t242 * t321;
    let t341 = t237 * t313 - t242 * t328;
    let t342 = t237 * t314 + t242 * t335;
    let t343 = u_hA * t340 + u_hB * t341 + u_hC * t342;
    let Ic2 = p.Ic2;
    let Ic1 = p.Ic1;
    let t344 = Ic2 - Ic1;
    let t345 = t236 * t238;
    let t346 = t236 * t243;
    let t347 = t345 * t340 - t346 * t322;
    let t348 = t346 * t329 + t345 * t341;
    let t349 = t345 * t342 - t346 * t336;
    let t350 = u_hA * t347 + u_hB * t348 + u_hC * t349;
    let t351 = 1.0_f32 - t234;
    let t352 = t243 * t240 + t242 * t340 - (t238 * t246 + t351 * t322);
    let t353 = t238 * t317 + t236 * t322;
    let t354 = t243 * t317 + t236 * t340;
    let t355 = t236 * t352 + (t351 * t353 - t242 * t354);
    let t356 = t243 * t313 + t242 * t341 - (t238 * t324 - t351 * t329);
    let t357 = t236 * t341 - t243 * t325;
    let t358 = t238 * t325 + t236 * t329;
    let t359 = t236 * t356 - (t242 * t357 + t351 * t358);
    let t360 = t243 * t314 + t242 * t342 - (t238 * t338 + t351 * t336);
    let t361 = t238 * t332 + t236 * t336;
    let t362 = t243 * t332 + t236 * t342;
    let t363 = t236 * t360 + (t351 * t361 - t242 * t362);
    let t364 = u_hA * t355 + u_hB * t359 + u_hC * t363;
    let t365 = Ic3 * (t238 * t279 + t243 * t311 + (t315 * t337 + t339 * t343)) + t344 * (t350 * t364);
    let t366 = t240 * t321;
    let t367 = t320 * t321;
    let t368 = t19 * t317;
    let t369 = t17 * (t368 + (t368 + t236 * t58));
    let t370 = t237 * (t319 * t320);
    let t371 = t367 + t237 * (t319 * (2.0_f32 * (t317 * t317 - t236 * t369)) + t318 * t370);
    let t372 = t237 * (t367 + t371);
    let t373 = t366 - t237 * t254 + (t366 + t242 * t372);
    let t374 = t240 * t328;
    let t375 = t313 * t321;
    let t376 = t320 * t328;
    let t377 = t317 * t325;
    let t378 = t35 * t317;
    let t379 = t19 * t325;
    let t380 = t17 * (t378 - (t379 + t236 * t49));
    let t381 = t237 * (t319 * t327);
    let t382 = t321 * t327;
    let t383 = t376 + t237 * (t319 * (2.0_f32 * (t377 + t236 * t380)) + t318 * t381) + t382;
    let t384 = t237 * t383;
    let t385 = t237 * t252 - t374 + (t375 - t242 * t384);
    let t386 = t240 * t335;
    let t387 = t314 * t321;
    let t388 = t320 * t335;
    let t389 = t317 * t332;
    let t390 = t19 * t332;
    let t391 = t66 * t317;
    let t392 = t17 * (t390 + t236 * t76 - t391);
    let t393 = t237 * (t319 * t334);
    let t394 = t321 * t334;
    let t395 = t388 + t237 * (t319 * (2.0_f32 * (t389 - t236 * t392)) + t318 * t393) + t394;
    let t396 = t237 * t395;
    let t397 = t386 - t237 * t257 + (t387 + t242 * t396);
    let t398 = t17 * (t378 - t236 * t82 - t379);
    let t399 = t376 + (t382 + t237 * (t326 * t370 + t319 * (2.0_f32 * (t377 + t236 * t398))));
    let t400 = t237 * t399;
    let t401 = t375 + t237 * t260 - (t374 + t242 * t400);
    let t402 = t327 * t328;
    let t403 = t35 * t325;
    let t404 = t17 * (t236 * t97 - t403 - t403);
    let t405 = t402 + t237 * (t326 * t381 + t319 * (2.0_f32 * (t325 * t325 - t236 * t404)));
    let t406 = t237 * (t402 + t405);
    let t407 = t313 * t328;
    let t408 = t242 * t406 - t407 - (t407 + t237 * t265);
    let t409 = t53 * t373 + t23 * t385 + t64 * t397 + t23 * t401 + t85 * t408;
    let t410 = t313 * t335;
    let t411 = t314 * t328;
    let t412 = t327 * t335;
    let t413 = t325 * t332;
    let t414 = t35 * t332;
    let t415 = t66 * t325;
    let t416 = t17 * (t414 + t236 * t107 + t415);
    let t417 = t328 * t334;
    let t418 = t412 + t237 * (t326 * t393 + t319 * (2.0_f32 * (t413 + t236 * t416))) + t417;
    let t419 = t237 * t418;
    let t420 = t410 + t237 * t270 - (t411 + t242 * t419);
    let t421 = t17 * (t390 + (t236 * t113 - t391));
    let t422 = t388 + (t394 + t237 * (t333 * t370 + t319 * (2.0_f32 * (t389 - t236 * t421))));
    let t423 = t237 * t422;
    let t424 = t387 - t237 * t272 + (t386 + t242 * t423);
    let t425 = t17 * (t414 + (t415 + t236 * t116));
    let t426 = t412 + (t417 + t237 * (t333 * t381 + t319 * (2.0_f32 * (t413 + t236 * t425))));
    let t427 = t237 * t426;
    let t428 = t237 * t274 - t411 + (t410 - t242 * t427);
    let t429 = t314 * t335;
    let t430 = t334 * t335;
    let t431 = t66 * t332;
    let t432 = t17 * (t236 * t123 - t431 - t431);
    let t433 = t430 + t237 * (t333 * t393 + t319 * (2.0_f32 * (t332 * t332 - t236 * t432)));
    let t434 = t237 * (t430 + t433);
    let t435 = t429 - t237 * t277 + (t429 + t242 * t434);
    let t436 = t345 * (t409 + t100 * t420 + t64 * t424 + t100 * t428 + t119 * t435);
    let t437 = t316 * t321;
    let t438 = t437 + t237 * (t282 - t281) + (t437 + t235 * t372);
    let t439 = t316 * t328;
    let t440 = t324 * t321;
    let t441 = t439 + t237 * t287 + (t440 + t235 * t384);
    let t442 = t316 * t335;
    let t443 = t331 * t321;
    let t444 = t442 + t237 * (t290 - t288) + (t443 + t235 * t396);
    let t445 = t237 * (t293 - t292) - t440 - (t439 + t235 * t400);
    let t446 = t324 * t328;
    let t447 = t446 + t237 * (t298 - t296) + (t446 + t235 * t406);
    let t448 = t53 * t438 - t23 * t441 + t64 * t444 + t23 * t445 + t85 * t447;
    let t449 = t324 * t335;
    let t450 = t331 * t328;
    let t451 = t237 * (t303 - t301) - t449 - (t450 + t235 * t419);
    let t452 = t443 + t237 * (t293 - t305) + (t442 + t235 * t423);
    let t453 = t237 * (t298 - t307) - t450 - (t449 + t235 * t427);
    let t454 = t331 * t335;
    let t455 = t454 + t237 * (t303 - t309) + (t454 + t235 * t434);
    let t456 = t346 * (t448 + t100 * t451 + t64 * t452 + t100 * t453 + t119 * t455);
    let t457 = u_hA * t353 - u_hB * t358 + u_hC * t361;
    let t458 = u_hA * t354 + u_hB * t357 + u_hC * t362;
    let t459 = Ic3 - Ic2;
    let t460 = t238 * t313 + t243 * t324;
    let t461 = t238 * t314 + t243 * t338;
    let t462 = u_hA * t247 + u_hB * t460 + u_hC * t461;
    let t463 = Ic1 * (t436 - t456 + (t343 * t457 - t337 * t458)) + t459 * (t364 * t462);
    let t464 = t240 * t340;
    let t465 = t246 * t322;
    let t466 = t464 - t243 * t254 + (t464 + t242 * t373) - (t465 + t238 * t283 + (t465 + t351 * t438));
    let t467 = t240 * t341;
    let t468 = t313 * t340;
    let t469 = t246 * t329;
    let t470 = t324 * t322;
    let t471 = t467 + t243 * t252 + (t468 + t242 * t385) - (t238 * t287 - t469 + (t470 - t351 * t441));
    let t472 = t240 * t342;
    let t473 = t314 * t340;
    let t474 = t246 * t336;
    let t475 = t338 * t322;
    let t476 = t472 - t243 * t257 + (t473 + t242 * t397) - (t474 + t238 * t291 + (t475 + t351 * t444));
    let t477 = t468 + t243 * t260 + (t467 + t242 * t401) - (t470 + t238 * t294 + (t351 * t445 - t469));
    let t478 = t313 * t341;
    let t479 = t324 * t329;
    let t480 = t478 - t243 * t265 + (t478 + t242 * t408) - (t238 * t299 - t479 + (t351 * t447 - t479));
    let t481 = t53 * t466 + t23 * t471 + t64 * t476 + t23 * t477 + t85 * t480;
    let t482 = t313 * t342;
    let t483 = t314 * t341;
    let t484 = t324 * t336;
    let t485 = t338 * t329;
    let t486 = t482 + t243 * t270 + (t483 + t242 * t420) - (t484 + t238 * t304 + (t351 * t451 - t485));
    let t487 = t473 - t243 * t272 + (t472 + t242 * t424) - (t475 + t238 * t306 + (t474 + t351 * t452));
    let t488 = t483 + t243 * t274 + (t482 + t242 * t428) - (t238 * t308 - t485 + (t484 + t351 * t453));
    let t489 = t314 * t342;
    let t490 = t338 * t336;
    let t491 = t489 - t243 * t277 + (t489 + t242 * t435) - (t490 + t238 * t310 + (t490 + t351 * t455));
    let t492 = t236 * (t481 + t100 * t486 + t64 * t487 + t100 * t488 + t119 * t491);
    let t493 = t317 * t322;
    let t494 = t317 * t329;
    let t495 = t325 * t322;
    let t496 = t53 * (t493 - t238 * t369 + (t493 + t236 * t438)) - t23 * (t494 + t238 * t380 + (t495 + t236 * t441));
    let t497 = t317 * t336;
    let t498 = t332 * t322;
    let t499 = t496 + t64 * (t497 - t238 * t392 + (t498 + t236 * t444)) + t23 * (t236 * t445 - t494 - (t495 + t238 * t398));
    let t500 = t325 * t329;
    let t501 = t332 * t329;
    let t502 = t325 * t336;
    let t503 = t499 + t85 * (t500 - t238 * t404 + (t500 + t236 * t447)) + t100 * (t236 * t451 - t501 - (t502 + t238 * t416));
    let t504 = t503 + t64 * (t498 - t238 * t421 + (t497 + t236 * t452)) + t100 * (t236 * t453 - t502 - (t501 + t238 * t425));
    let t505 = t332 * t336;
    let t506 = t317 * t340;
    let t507 = t317 * t341;
    let t508 = t325 * t340;
    let t509 = t53 * (t506 - t243 * t369 + (t506 + t236 * t373)) + t23 * (t507 - t243 * t380 + (t236 * t385 - t508));
    let t510 = t317 * t342;
    let t511 = t332 * t340;
    let t512 = t509 + t64 * (t510 - t243 * t392 + (t511 + t236 * t397)) + t23 * (t507 + t236 * t401 - (t508 + t243 * t398));
    let t513 = t325 * t341;
    let t514 = t332 * t341;
    let t515 = t325 * t342;
    let t516 = t512 + t85 * (t236 * t408 - t513 - (t513 + t243 * t404)) + t100 * (t514 + t236 * t420 - (t515 + t243 * t416));
    let t517 = t516 + t64 * (t511 - t243 * t421 + (t510 + t236 * t424)) + t100 * (t514 - t243 * t425 + (t236 * t428 - t515));
    let t518 = t332 * t342;
    let t519 = t351 * (t504 + t119 * (t505 - t238 * t432 + (t505 + t236 * t455))) - t242 * (t517 + t119 * (t518 - t243 * t432 + (t518 + t236 * t435)));
    let t520 = u_hA * t317 - u_hB * t325 + u_hC * t332;
    let t521 = t520 * (u_hA * t352 + u_hB * t356 + u_hC * t360) + (t339 * t457 - t315 * t458);
    let t522 = Ic1 - Ic3;
    let t523 = Ic2 * (t492 + t519 + t521) + t522 * (t350 * t462);
    let t524 = t2 + (t22 * t127 + (t134 * t201 + t204 * t233)) + (t247 * t365 + (t347 * t463 + t355 * t523));
    let t525 = 0.5_f32 * t242;
    let t526 = t7 * k;
    let t527 = 0.8660254_f32 * (1.0_f32 - t526);
    let t528 = t525 + t527;
    let t529 = 0.5_f32 * t236;
    let t530 = t6 * t17;
    let t531 = 0.8660254_f32 * t530;
    let dzB = t529 - t531;
    let t532 = 1.0_f32 / Real::sqrt(1.0_f32 - dzB * dzB);
    let t533 = t528 * t532;
    let t534 = 0.5_f32 * t246;
    let t535 = 0.8660254_f32 * t240;
    let t536 = t534 + t535;
    let t537 = 0.5_f32 * t351;
    let t538 = 0.8660254_f32 * t242;
    let t539 = t537 + t538;
    let t540 = t539 * t532;
    let t541 = 0.5_f32 * t240;
    let t542 = t7 * t21;
    let t543 = 0.8660254_f32 * t542;
    let t544 = t541 + t543;
    let t545 = t533 * t536 - t540 * t544;
    let t546 = 0.5_f32 * t254;
    let t547 = t7 * t60;
    let t548 = 0.8660254_f32 * t547;
    let t549 = 0.5_f32 * t252;
    let t550 = t21 * t31;
    let t551 = t550 + t7 * t52;
    let t552 = 0.8660254_f32 * t551;
    let t553 = t549 + t552;
    let t554 = t7 * t79 - t550;
    let t555 = 0.8660254_f32 * t554;
    let t556 = 0.5_f32 * t257;
    let t557 = t555 - t556;
    let t558 = 0.5_f32 * t260;
    let t559 = t550 + t7 * t83;
    let t560 = 0.8660254_f32 * t559;
    let t561 = t558 + t560;
    let t562 = t31 * t37;
    let t563 = t562 + t7 * t99;
    let t564 = k * t86;
    let t565 = t564 - t562;
    let t566 = 0.8660254_f32 * (t563 - t565);
    let t567 = 0.5_f32 * t265;
    let t568 = t566 - t567;
    let t569 = t53 * (t546 - t548) - t23 * t553 - t64 * t557 - t23 * t561 - t85 * t568;
    let t570 = 0.5_f32 * t270;
    let t571 = t7 * t110 - t562;
    let t572 = t31 * t68;
    let t573 = t572 - t564;
    let t574 = 0.8660254_f32 * (t571 - t573);
    let t575 = t570 + t574;
    let t576 = t7 * t114 - t550;
    let t577 = 0.8660254_f32 * t576;
    let t578 = 0.5_f32 * t272;
    let t579 = t577 - t578;
    let t580 = 0.5_f32 * t274;
    let t581 = t7 * t117 - t572;
    let t582 = t562 - t564;
    let t583 = 0.8660254_f32 * (t581 - t582);
    let t584 = t580 + t583;
    let t585 = t572 + t7 * t125;
    let t586 = t564 - t572;
    let t587 = 0.8660254_f32 * (t585 - t586);
    let t588 = 0.5_f32 * t277;
    let t589 = t587 - t588;
    let t590 = t540 * (t569 - t100 * t575 - t64 * t579 - t100 * t584 - t119 * t589);
    let t591 = 0.8660254_f32 * t254;
    let t592 = 0.5_f32 * t283;
    let t593 = 0.5_f32 * t287;
    let t594 = 0.8660254_f32 * t252;
    let t595 = t593 + t594;
    let t596 = 0.5_f32 * t291;
    let t597 = 0.8660254_f32 * t257;
    let t598 = t596 - t597;
    let t599 = 0.5_f32 * t294;
    let t600 = 0.8660254_f32 * t260;
    let t601 = t599 + t600;
    let t602 = 0.5_f32 * t299;
    let t603 = 0.8660254_f32 * t265;
    let t604 = t602 - t603;
    let t605 = t53 * (t591 - t592) - t23 * t595 - t64 * t598 - t23 * t601 - t85 * t604;
    let t606 = 0.5_f32 * t304;
    let t607 = 0.8660254_f32 * t270;
    let t608 = t606 + t607;
    let t609 = 0.5_f32 * t306;
    let t610 = 0.8660254_f32 * t272;
    let t611 = t609 - t610;
    let t612 = 0.5_f32 * t308;
    let t613 = 0.8660254_f32 * t274;
    let t614 = t612 + t613;
    let t615 = 0.5_f32 * t310;
    let t616 = 0.8660254_f32 * t277;
    let t617 = t615 - t616;
    let t618 = t533 * (t605 - t100 * t608 - t64 * t611 - t100 * t614 - t119 * t617);
    let t619 = 0.5_f32 * t324;
    let t620 = 0.8660254_f32 * t313;
    let t621 = t619 + t620;
    let t622 = 0.5_f32 * t338;
    let t623 = 0.8660254_f32 * t314;
    let t624 = t622 + t623;
    let t625 = u_hA * t536 + u_hB * t621 + u_hC * t624;
    let t626 = 0.5_f32 * t317;
    let t627 = t17 * (t530 * t19);
    let t628 = 0.8660254_f32 * t627;
    let t629 = t626 + t628;
    let t630 = 2.0_f32 * (dzB * t629);
    let t631 = 0.5_f32 * t532;
    let t632 = t630 * t631;
    let t633 = t532 * (t532 * t632);
    let t634 = t532 * t544 + t528 * t633;
    let t635 = 0.5_f32 * t313;
    let t636 = t7 * t37;
    let t637 = k * t31;
    let t638 = 0.8660254_f32 * (t636 - t637);
    let t639 = t635 + t638;
    let t640 = 0.5_f32 * t325;
    let t641 = t17 * (t30 - t530 * t35);
    let t642 = 0.8660254_f32 * t641;
    let t643 = t640 + t642;
    let t644 = 2.0_f32 * (dzB * t643);
    let t645 = t631 * t644;
    let t646 = t532 * (t532 * t645);
    let t647 = t532 * t639 - t528 * t646;
    let t648 = 0.5_f32 * t314;
    let t649 = t7 * t68;
    let t650 = 0.8660254_f32 * (t637 - t649);
    let t651 = t648 + t650;
    let t652 = 0.5_f32 * t332;
    let t653 = t17 * (t530 * t66 - t30);
    let t654 = 0.8660254_f32 * t653;
    let t655 = t652 - t654;
    let t656 = 2.0_f32 * (dzB * t655);
    let t657 = t631 * t656;
    let t658 = t532 * (t532 * t657);
    let t659 = t532 * t651 + t528 * t658;
    let t660 = u_hA * t634 + u_hB * t647 + u_hC * t659;
    let t661 = u_hA * t544 + u_hB * t639 + u_hC * t651;
    let t662 = t532 * t536 + t539 * t633;
    let t663 = t532 * t621 - t539 * t646;
    let t664 = t532 * t624 + t539 * t658;
    let t665 = u_hA * t662 + u_hB * t663 + u_hC * t664;
    let t666 = t531 - t529;
    let t667 = t666 * t533;
    let t668 = t666 * t540;
    let t669 = t667 * t662 - t668 * t634;
    let t670 = t667 * t663 - t668 * t647;
    let t671 = t667 * t664 - t668 * t659;
    let t672 = u_hA * t669 + u_hB * t670 + u_hC * t671;
    let t673 = t533 * t544 + t528 * t634 + (t540 * t536 + t539 * t662);
    let t674 = t666 * t634 - t533 * t629;
    let t675 = t666 * t662 - t540 * t629;
    let t676 = t666 * t673 - (t528 * t674 + t539 * t675);
    let t677 = t533 * t639 + t528 * t647 + (t540 * t621 + t539 * t663);
    let t678 = t533 * t643 + t666 * t647;
    let t679 = t540 * t643 + t666 * t663;
    let t680 = t666 * t677 - (t528 * t678 + t539 * t679);
    let t681 = t533 * t651 + t528 * t659 + (t540 * t624 + t539 * t664);
    let t682 = t654 - t652;
    let t683 = t533 * t682 + t666 * t659;
    let t684 = t540 * t682 + t666 * t664;
    let t685 = t666 * t681 - (t528 * t683 + t539 * t684);
    let t686 = u_hA * t676 + u_hB * t680 + u_hC * t685;
    let t687 = Ic3 * (t590 - t618 + (t625 * t660 - t661 * t665)) + t344 * (t672 * t686);
    let t688 = t536 * t633;
    let t689 = t592 - t591;
    let t690 = t632 * t633;
    let t691 = t19 * t627;
    let t692 = t17 * (t530 * t58 - t691 - t691);
    let t693 = 0.8660254_f32 * t692;
    let t694 = 0.5_f32 * t369;
    let t695 = t693 - t694;
    let t696 = t532 * (t631 * t632);
    let t697 = t690 + t532 * (t631 * (2.0_f32 * (t629 * t629 + dzB * t695)) + t630 * t696);
    let t698 = t532 * (t690 + t697);
    let t699 = t688 + t532 * t689 + (t688 + t539 * t698);
    let t700 = t536 * t646;
    let t701 = t621 * t633;
    let t702 = t19 * t641;
    let t703 = t35 * t627;
    let t704 = t17 * (t702 - t530 * t49 - t703);
    let t705 = 0.8660254_f32 * t704;
    let t706 = 0.5_f32 * t380;
    let t707 = t705 - t706;
    let t708 = t629 * t643;
    let t709 = t532 * (t631 * t645);
    let t710 = t632 * t646;
    let t711 = t633 * t645;
    let t712 = t532 * (t631 * (2.0_f32 * (dzB * t707 - t708)) - t630 * t709) - t710 - t711;
    let t713 = t532 * t712;
    let t714 = t532 * t595 - t700 + (t701 + t539 * t713);
    let t715 = t536 * t658;
    let t716 = t624 * t633;
    let t717 = t632 * t658;
    let t718 = t629 * t655;
    let t719 = t19 * t653;
    let t720 = t66 * t627;
    let t721 = t17 * (t719 + t530 * t76 + t720);
    let t722 = 0.8660254_f32 * t721;
    let t723 = 0.5_f32 * t392;
    let t724 = t722 - t723;
    let t725 = t532 * (t631 * t657);
    let t726 = t633 * t657;
    let t727 = t717 + t532 * (t631 * (2.0_f32 * (t718 + dzB * t724)) + t630 * t725) + t726;
    let t728 = t532 * t727;
    let t729 = t715 + t532 * t598 + (t716 + t539 * t728);
    let t730 = 0.5_f32 * t398;
    let t731 = t17 * (t703 + t530 * t82 - t702);
    let t732 = 0.8660254_f32 * t731;
    let t733 = t730 + t732;
    let t734 = t710 + (t711 + t532 * (t644 * t696 + t631 * (2.0_f32 * (t708 + dzB * t733))));
    let t735 = t532 * t734;
    let t736 = t701 + t532 * t601 - (t700 + t539 * t735);
    let t737 = t621 * t646;
    let t738 = t645 * t646;
    let t739 = t35 * t641;
    let t740 = t17 * (t739 + (t739 + t530 * t97));
    let t741 = 0.8660254_f32 * t740;
    let t742 = 0.5_f32 * t404;
    let t743 = t532 * (t644 * t709 + t631 * (2.0_f32 * (t643 * t643 + dzB * (t741 - t742))));
    let t744 = t532 * (t738 + (t738 + t743));
    let t745 = t532 * t604 - t737 + (t539 * t744 - t737);
    let t746 = t53 * t699 + t23 * t714 + t64 * t729 + t23 * t736 + t85 * t745;
    let t747 = t621 * t658;
    let t748 = t35 * t653;
    let t749 = t66 * t641;
    let t750 = t17 * (t748 + t530 * t107 - t749);
    let t751 = 0.8660254_f32 * t750;
    let t752 = 0.5_f32 * t416;
    let t753 = t643 * t655;
    let t754 = t645 * t658;
    let t755 = t532 * (t631 * (2.0_f32 * (dzB * (t751 - t752) - t753)) - t644 * t725) - t754;
    let t756 = t646 * t657;
    let t757 = t532 * (t755 - t756);
    let t758 = t624 * t646;
    let t759 = t747 + t532 * t608 + (t539 * t757 - t758);
    let t760 = 0.5_f32 * t421;
    let t761 = t17 * (t719 + (t720 + t530 * t113));
    let t762 = 0.8660254_f32 * t761;
    let t763 = t760 - t762;
    let t764 = t717 + (t726 + t532 * (t656 * t696 + t631 * (2.0_f32 * (t718 - dzB * t763))));
    let t765 = t532 * t764;
    let t766 = t716 + t532 * t611 + (t715 + t539 * t765);
    let t767 = t17 * (t748 + (t530 * t116 - t749));
    let t768 = 0.8660254_f32 * t767;
    let t769 = 0.5_f32 * t425;
    let t770 = t532 * (t631 * (2.0_f32 * (dzB * (t768 - t769) - t753)) - t656 * t709) - t756;
    let t771 = t532 * (t770 - t754);
    let t772 = t532 * t614 - t758 + (t747 + t539 * t771);
    let t773 = t624 * t658;
    let t774 = t657 * t658;
    let t775 = t66 * t653;
    let t776 = t17 * (t530 * t123 - t775 - t775);
    let t777 = 0.8660254_f32 * t776;
    let t778 = 0.5_f32 * t432;
    let t779 = t532 * (t656 * t725 + t631 * (2.0_f32 * (t655 * t655 + dzB * (t777 - t778))));
    let t780 = t532 * (t774 + (t774 + t779));
    let t781 = t773 + t532 * t617 + (t773 + t539 * t780);
    let t782 = t667 * (t746 + t100 * t759 + t64 * t766 + t100 * t772 + t119 * t781);
    let t783 = t544 * t633;
    let t784 = t548 - t546;
    let t785 = t783 + t532 * t784 + (t783 + t528 * t698);
    let t786 = t544 * t646;
    let t787 = t639 * t633;
    let t788 = t532 * t553 - t786 + (t787 + t528 * t713);
    let t789 = t544 * t658;
    let t790 = t651 * t633;
    let t791 = t789 + t532 * t557 + (t790 + t528 * t728);
    let t792 = t787 + t532 * t561 - (t786 + t528 * t735);
    let t793 = t639 * t646;
    let t794 = t532 * t568 - t793 + (t528 * t744 - t793);
    let t795 = t53 * t785 + t23 * t788 + t64 * t791 + t23 * t792 + t85 * t794;
    let t796 = t639 * t658;
    let t797 = t651 * t646;
    let t798 = t796 + t532 * t575 + (t528 * t757 - t797);
    let t799 = t790 + t532 * t579 + (t789 + t528 * t765);
    let t800 = t532 * t584 - t797 + (t796 + t528 * t771);
    let t801 = t651 * t658;
    let t802 = t801 + t532 * t589 + (t801 + t528 * t780);
    let t803 = t668 * (t795 + t100 * t798 + t64 * t799 + t100 * t800 + t119 * t802);
    let t804 = u_hA * t674 + u_hB * t678 + u_hC * t683;
    let t805 = u_hA * t675 + u_hB * t679 + u_hC * t684;
    let t806 = t533 * t621 - t540 * t639;
    let t807 = t533 * t624 - t540 * t651;
    let t808 = u_hA * t545 + u_hB * t806 + u_hC * t807;
    let t809 = Ic1 * (t782 - t803 + (t665 * t804 - t660 * t805)) + t459 * (t686 * t808);
    let t810 = t544 * t634;
    let t811 = t536 * t662;
    let t812 = t810 + t533 * t784 + (t810 + t528 * t785) + (t811 + t540 * t689 + (t811 + t539 * t699));
    let t813 = t544 * t647;
    let t814 = t639 * t634;
    let t815 = t536 * t663;
    let t816 = t621 * t662;
    let t817 = t813 + t533 * t553 + (t814 + t528 * t788) + (t815 + t540 * t595 + (t816 + t539 * t714));
    let t818 = t544 * t659;
    let t819 = t651 * t634;
    let t820 = t536 * t664;
    let t821 = t624 * t662;
    let t822 = t818 + t533 * t557 + (t819 + t528 * t791) + (t820 + t540 * t598 + (t821 + t539 * t729));
    let t823 = t814 + t533 * t561 + (t813 + t528 * t792) + (t816 + t540 * t601 + (t815 + t539 * t736));
    let t824 = t639 * t647;
    let t825 = t621 * t663;
    let t826 = t824 + t533 * t568 + (t824 + t528 * t794) + (t825 + t540 * t604 + (t825 + t539 * t745));
    let t827 = t53 * t812 + t23 * t817 + t64 * t822 + t23 * t823 + t85 * t826;
    let t828 = t639 * t659;
    let t829 = t651 * t647;
    let t830 = t621 * t664;
    let t831 = t624 * t663;
    let t832 = t828 + t533 * t575 + (t829 + t528 * t798) + (t830 + t540 * t608 + (t831 + t539 * t759));
    let t833 = t819 + t533 * t579 + (t818 + t528 * t799) + (t821 + t540 * t611 + (t820 + t539 * t766));
    let t834 = t829 + t533 * t584 + (t828 + t528 * t800) + (t831 + t540 * t614 + (t830 + t539 * t772));
    let t835 = t651 * t659;
    let t836 = t624 * t664;
    let t837 = t835 + t533 * t589 + (t835 + t528 * t802) + (t836 + t540 * t617 + (t836 + t539 * t781));
    let t838 = t666 * (t827 + t100 * t832 + t64 * t833 + t100 * t834 + t119 * t837);
    let t839 = t629 * t634;
    let t840 = t643 * t634;
    let t841 = t629 * t647;
    let t842 = t53 * (t666 * t785 - t839 - (t839 + t533 * t695)) + t23 * (t840 + t666 * t788 - (t841 + t533 * t707));
    let t843 = t682 * t634;
    let t844 = t629 * t659;
    let t845 = t842 + t64 * (t843 + t666 * t791 - (t844 + t533 * t724)) + t23 * (t840 + t533 * t733 + (t666 * t792 - t841));
    let t846 = t643 * t647;
    let t847 = t742 - t741;
    let t848 = t643 * t659;
    let t849 = t752 - t751;
    let t850 = t682 * t647;
    let t851 = t845 + t85 * (t846 + t533 * t847 + (t846 + t666 * t794)) + t100 * (t848 + t533 * t849 + (t850 + t666 * t798));
    let t852 = t769 - t768;
    let t853 = t851 + t64 * (t843 + t533 * t763 + (t666 * t799 - t844)) + t100 * (t850 + t533 * t852 + (t848 + t666 * t800));
    let t854 = t682 * t659;
    let t855 = t778 - t777;
    let t856 = t629 * t662;
    let t857 = t643 * t662;
    let t858 = t629 * t663;
    let t859 = t53 * (t666 * t699 - t856 - (t856 + t540 * t695)) + t23 * (t857 + t666 * t714 - (t858 + t540 * t707));
    let t860 = t682 * t662;
    let t861 = t629 * t664;
    let t862 = t859 + t64 * (t860 + t666 * t729 - (t861 + t540 * t724)) + t23 * (t857 + t540 * t733 + (t666 * t736 - t858));
    let t863 = t643 * t663;
    let t864 = t643 * t664;
    let t865 = t682 * t663;
    let t866 = t862 + t85 * (t863 + t540 * t847 + (t863 + t666 * t745)) + t100 * (t864 + t540 * t849 + (t865 + t666 * t759));
    let t867 = t866 + t64 * (t860 + t540 * t763 + (t666 * t766 - t861)) + t100 * (t865 + t540 * t852 + (t864 + t666 * t772));
    let t868 = t682 * t664;
    let t869 = t528 * (t853 + t119 * (t854 + t533 * t855 + (t854 + t666 * t802))) + t539 * (t867 + t119 * (t868 + t540 * t855 + (t868 + t666 * t781)));
    let t870 = (u_hB * t643 - u_hA * t629 + u_hC * t682) * (u_hA * t673 + u_hB * t677 + u_hC * t681);
    let t871 = Ic2 * (t838 - t869 + (t870 - (t661 * t804 + t625 * t805))) + t522 * (t672 * t808);
    let t872 = t537 - t538;
    let dzC = t529 + t531;
    let t873 = 1.0_f32 / Real::sqrt(1.0_f32 - dzC * dzC);
    let t874 = t872 * t873;
    let t875 = t543 - t541;
    let t876 = t527 - t525;
    let t877 = t876 * t873;
    let t878 = t535 - t534;
    let t879 = t874 * t875 + t877 * t878;
    let t880 = t546 + t548;
    let t881 = t552 - t549;
    let t882 = t556 + t555;
    let t883 = t560 - t558;
    let t884 = t567 + t566;
    let t885 = t53 * t880 + t23 * t881 + t64 * t882 + t23 * t883 + t85 * t884;
    let t886 = t574 - t570;
    let t887 = t578 + t577;
    let t888 = t583 - t580;
    let t889 = t588 + t587;
    let t890 = t874 * (t885 + t100 * t886 + t64 * t887 + t100 * t888 + t119 * t889);
    let t891 = t594 - t593;
    let t892 = t592 + t591;
    let t893 = t596 + t597;
    let t894 = t600 - t599;
    let t895 = t602 + t603;
    let t896 = t23 * t891 - t53 * t892 - t64 * t893 + t23 * t894 - t85 * t895;
    let t897 = t607 - t606;
    let t898 = t609 + t610;
    let t899 = t613 - t612;
    let t900 = t615 + t616;
    let t901 = t877 * (t896 + t100 * t897 - t64 * t898 + t100 * t899 - t119 * t900);
    let t902 = t638 - t635;
    let t903 = t650 - t648;
    let t904 = u_hA * t875 + u_hB * t902 + u_hC * t903;
    let t905 = t534 - t535;
    let t906 = t626 - t628;
    let t907 = 2.0_f32 * (dzC * t906);
    let t908 = 0.5_f32 * t873;
    let t909 = t907 * t908;
    let t910 = t873 * (t873 * t909);
    let t911 = t873 * t905 + t872 * t910;
    let t912 = t619 - t620;
    let t913 = t642 - t640;
    let t914 = 2.0_f32 * (dzC * t913);
    let t915 = t908 * t914;
    let t916 = t873 * (t873 * t915);
    let t917 = t873 * t912 + t872 * t916;
    let t918 = t622 - t623;
    let t919 = t652 + t654;
    let t920 = 2.0_f32 * (dzC * t919);
    let t921 = t908 * t920;
    let t922 = t873 * (t873 * t921);
    let t923 = t873 * t918 + t872 * t922;
    let t924 = u_hA * t911 + u_hB * t917 + u_hC * t923;
    let t925 = t620 - t619;
    let t926 = t623 - t622;
    let t927 = u_hA * t878 + u_hB * t925 + u_hC * t926;
    let t928 = t873 * t875 + t876 * t910;
    let t929 = t873 * t902 + t876 * t916;
    let t930 = t873 * t903 + t876 * t922;
    let t931 = u_hA * t928 + u_hB * t929 + u_hC * t930;
    let t932 = dzC * t877;
    let t933 = dzC * t874;
    let t934 = t932 * t911 - t933 * t928;
    let t935 = t932 * t917 - t933 * t929;
    let t936 = t932 * t923 - t933 * t930;
    let t937 = u_hA * t934 + u_hB * t935 + u_hC * t936;
    let t938 = t877 * t906 + dzC * t928;
    let t939 = t538 - t537;
    let t940 = t874 * t906 + dzC * t911;
    let t941 = t877 * t875 + t876 * t928 - (t874 * t878 + t939 * t911);
    let t942 = t876 * t938 - t939 * t940 - dzC * t941;
    let t943 = t877 * t913 + dzC * t929;
    let t944 = t874 * t913 + dzC * t917;
    let t945 = t877 * t902 + t876 * t929 - (t874 * t925 + t939 * t917);
    let t946 = t876 * t943 - t939 * t944 - dzC * t945;
    let t947 = t877 * t919 + dzC * t930;
    let t948 = t874 * t919 + dzC * t923;
    let t949 = t877 * t903 + t876 * t930 - (t874 * t926 + t939 * t923);
    let t950 = t876 * t947 - t939 * t948 - dzC * t949;
    let t951 = u_hA * t942 + u_hB * t946 + u_hC * t950;
    let t952 = Ic3 * (t890 + t901 + (t904 * t924 + t927 * t931)) + t344 * (t937 * t951);
    let t953 = t905 * t910;
    let t954 = t909 * t910;
    let t955 = t694 + t693;
    let t956 = t873 * (t908 * t909);
    let t957 = t954 + t873 * (t908 * (2.0_f32 * (t906 * t906 - dzC * t955)) + t907 * t956);
    let t958 = t873 * (t954 + t957);
    let t959 = t953 + t873 * t892 + (t953 + t872 * t958);
    let t960 = t905 * t916;
    let t961 = t910 * t912;
    let t962 = t909 * t916;
    let t963 = t906 * t913;
    let t964 = t706 + t705;
    let t965 = t873 * (t908 * t915);
    let t966 = t910 * t915;
    let t967 = t962 + t873 * (t908 * (2.0_f32 * (t963 - dzC * t964)) + t907 * t965) + t966;
    let t968 = t873 * t967;
    let t969 = t960 + t873 * (t593 - t594) + (t961 + t872 * t968);
    let t970 = t905 * t922;
    let t971 = t910 * t918;
    let t972 = t909 * t922;
    let t973 = t906 * t919;
    let t974 = t723 + t722;
    let t975 = t873 * (t908 * t921);
    let t976 = t910 * t921;
    let t977 = t972 + t873 * (t908 * (2.0_f32 * (t973 - dzC * t974)) + t907 * t975) + t976;
    let t978 = t873 * t977;
    let t979 = t970 + t873 * t893 + (t971 + t872 * t978);
    let t980 = t732 - t730;
    let t981 = t962 + (t966 + t873 * (t914 * t956 + t908 * (2.0_f32 * (t963 + dzC * t980))));
    let t982 = t873 * t981;
    let t983 = t961 + t873 * (t599 - t600) + (t960 + t872 * t982);
    let t984 = t912 * t916;
    let t985 = t915 * t916;
    let t986 = t742 + t741;
    let t987 = t985 + t873 * (t914 * t965 + t908 * (2.0_f32 * (t913 * t913 - dzC * t986)));
    let t988 = t873 * (t985 + t987);
    let t989 = t984 + t873 * t895 + (t984 + t872 * t988);
    let t990 = t53 * t959 + t23 * t969 + t64 * t979 + t23 * t983 + t85 * t989;
    let t991 = t912 * t922;
    let t992 = t916 * t918;
    let t993 = t915 * t922;
    let t994 = t913 * t919;
    let t995 = t752 + t751;
    let t996 = t916 * t921;
    let t997 = t993 + t873 * (t914 * t975 + t908 * (2.0_f32 * (t994 - dzC * t995))) + t996;
    let t998 = t873 * t997;
    let t999 = t991 + t873 * (t606 - t607) + (t992 + t872 * t998);
    let t1000 = t760 + t762;
    let t1001 = t972 + (t976 + t873 * (t920 * t956 + t908 * (2.0_f32 * (t973 - dzC * t1000))));
    let t1002 = t873 * t1001;
    let t1003 = t971 + t873 * t898 + (t970 + t872 * t1002);
    let t1004 = t769 + t768;
    let t1005 = t993 + (t996 + t873 * (t920 * t965 + t908 * (2.0_f32 * (t994 - dzC * t1004))));
    let t1006 = t873 * t1005;
    let t1007 = t992 + t873 * (t612 - t613) + (t991 + t872 * t1006);
    let t1008 = t918 * t922;
    let t1009 = t921 * t922;
    let t1010 = t778 + t777;
    let t1011 = t1009 + t873 * (t920 * t975 + t908 * (2.0_f32 * (t919 * t919 - dzC * t1010)));
    let t1012 = t873 * (t1009 + t1011);
    let t1013 = t1008 + t873 * t900 + (t1008 + t872 * t1012);
    let t1014 = t932 * (t990 + t100 * t999 + t64 * t1003 + t100 * t1007 + t119 * t1013);
    let t1015 = t875 * t910;
    let t1016 = t1015 + t873 * t880 + (t1015 + t876 * t958);
    let t1017 = t875 * t916;
    let t1018 = t902 * t910;
    let t1019 = t1017 + t873 * t881 + (t1018 + t876 * t968);
    let t1020 = t875 * t922;
    let t1021 = t903 * t910;
    let t1022 = t1020 + t873 * t882 + (t1021 + t876 * t978);
    let t1023 = t1018 + t873 * t883 + (t1017 + t876 * t982);
    let t1024 = t902 * t916;
    let t1025 = t1024 + t873 * t884 + (t1024 + t876 * t988);
    let t1026 = t53 * t1016 + t23 * t1019 + t64 * t1022 + t23 * t1023 + t85 * t1025;
    let t1027 = t902 * t922;
    let t1028 = t903 * t916;
    let t1029 = t1027 + t873 * t886 + (t1028 + t876 * t998);
    let t1030 = t1021 + t873 * t887 + (t1020 + t876 * t1002);
    let t1031 = t1028 + t873 * t888 + (t1027 + t876 * t1006);
    let t1032 = t903 * t922;
    let t1033 = t1032 + t873 * t889 + (t1032 + t876 * t1012);
    let t1034 = t933 * (t1026 + t100 * t1029 + t64 * t1030 + t100 * t1031 + t119 * t1033);
    let t1035 = u_hA * t938 + u_hB * t943 + u_hC * t947;
    let t1036 = u_hA * t940 + u_hB * t944 + u_hC * t948;
    let t1037 = t874 * t902 + t877 * t925;
    let t1038 = t874 * t903 + t877 * t926;
    let t1039 = u_hA * t879 + u_hB * t1037 + u_hC * t1038;
    let t1040 = Ic1 * (t1014 - t1034 + (t924 * t1035 - t931 * t1036)) + t459 * (t951 * t1039);
    let t1041 = t906 * t928;
    let t1042 = t906 * t929;
    let t1043 = t913 * t928;
    let t1044 = t53 * (t1041 - t877 * t955 + (t1041 + dzC * t1016)) + t23 * (t1042 - t877 * t964 + (t1043 + dzC * t1019));
    let t1045 = t906 * t930;
    let t1046 = t919 * t928;
    let t1047 = t1044 + t64 * (t1045 - t877 * t974 + (t1046 + dzC * t1022)) + t23 * (t1043 + t877 * t980 + (t1042 + dzC * t1023));
    let t1048 = t913 * t929;
    let t1049 = t913 * t930;
    let t1050 = t919 * t929;
    let t1051 = t1047 + t85 * (t1048 - t877 * t986 + (t1048 + dzC * t1025)) + t100 * (t1049 - t877 * t995 + (t1050 + dzC * t1029));
    let t1052 = t1051 + t64 * (t1046 - t877 * t1000 + (t1045 + dzC * t1030)) + t100 * (t1050 - t877 * t1004 + (t1049 + dzC * t1031));
    let t1053 = t919 * t930;
    let t1054 = t906 * t911;
    let t1055 = t906 * t917;
    let t1056 = t913 * t911;
    let t1057 = t53 * (t1054 - t874 * t955 + (t1054 + dzC * t959)) + t23 * (t1055 - t874 * t964 + (t1056 + dzC * t969));
    let t1058 = t906 * t923;
    let t1059 = t919 * t911;
    let t1060 = t1057 + t64 * (t1058 - t874 * t974 + (t1059 + dzC * t979)) + t23 * (t1056 + t874 * t980 + (t1055 + dzC * t983));
    let t1061 = t913 * t917;
    let t1062 = t913 * t923;
    let t1063 = t919 * t917;
    let t1064 = t1060 + t85 * (t1061 - t874 * t986 + (t1061 + dzC * t989)) + t100 * (t1062 - t874 * t995 + (t1063 + dzC * t999));
    let t1065 = t1064 + t64 * (t1059 - t874 * t1000 + (t1058 + dzC * t1003)) + t100 * (t1063 - t874 * t1004 + (t1062 + dzC * t1007));
    let t1066 = t919 * t923;
    let t1067 = t876 * (t1052 + t119 * (t1053 - t877 * t1010 + (t1053 + dzC * t1033))) - t939 * (t1065 + t119 * (t1066 - t874 * t1010 + (t1066 + dzC * t1013)));
    let t1068 = t875 * t928;
    let t1069 = t878 * t911;
    let t1070 = t1068 + t877 * t880 + (t1068 + t876 * t1016) - (t1069 - t874 * t892 + (t1069 + t939 * t959));
    let t1071 = t875 * t929;
    let t1072 = t902 * t928;
    let t1073 = t878 * t917;
    let t1074 = t925 * t911;
    let t1075 = t1071 + t877 * t881 + (t1072 + t876 * t1019) - (t1073 + t874 * t891 + (t1074 + t939 * t969));
    let t1076 = t875 * t930;
    let t1077 = t903 * t928;
    let t1078 = t878 * t923;
    let t1079 = t926 * t911;
    let t1080 = t1076 + t877 * t882 + (t1077 + t876 * t1022) - (t1078 - t874 * t893 + (t1079 + t939 * t979));
    let t1081 = t1072 + t877 * t883 + (t1071 + t876 * t1023) - (t1074 + t874 * t894 + (t1073 + t939 * t983));
    let t1082 = t902 * t929;
    let t1083 = t925 * t917;
    let t1084 = t1082 + t877 * t884 + (t1082 + t876 * t1025) - (t1083 - t874 * t895 + (t1083 + t939 * t989));
    let t1085 = t53 * t1070 + t23 * t1075 + t64 * t1080 + t23 * t1081 + t85 * t1084;
    let t1086 = t902 * t930;
    let t1087 = t903 * t929;
    let t1088 = t925 * t923;
    let t1089 = t926 * t917;
    let t1090 = t1086 + t877 * t886 + (t1087 + t876 * t1029) - (t1088 + t874 * t897 + (t1089 + t939 * t999));
    let t1091 = t1077 + t877 * t887 + (t1076 + t876 * t1030) - (t1079 - t874 * t898 + (t1078 + t939 * t1003));
    let t1092 = t1087 + t877 * t888 + (t1086 + t876 * t1031) - (t1089 + t874 * t899 + (t1088 + t939 * t1007));
    let t1093 = t903 * t930;
    let t1094 = t926 * t923;
    let t1095 = t1093 + t877 * t889 + (t1093 + t876 * t1033) - (t1094 - t874 * t900 + (t1094 + t939 * t1013));
    let t1096 = dzC * (t1085 + t100 * t1090 + t64 * t1091 + t100 * t1092 + t119 * t1095);
    let t1097 = (u_hA * (t628 - t626) - u_hB * t913 - u_hC * t919) * (u_hA * t941 + u_hB * t945 + u_hC * t949);
    let t1098 = Ic2 * (t1067 - t1096 + (t1097 + (t904 * t1035 - t927 * t1036))) + t522 * (t937 * t1039);
    let t1099 = t524 + (t545 * t687 + (t669 * t809 + t676 * t871)) + (t879 * t952 + (t934 * t1040 + t942 * t1098));
    let t1100 = t526 - 1.0_f32;
    let t1101 = t530 * t317 + (t1100 * t240 - t242 * t246);
    let Iz = p.Iz;
    let t1102 = t53 * t369 + t23 * t380 + t64 * t392 + t23 * t398 + t85 * t404;
    let t1103 = t530 * (t1102 + t100 * t416 + t64 * t421 + t100 * t425 + t119 * t432);
    let t1104 = u_hB * t641 - u_hA * t627 + u_hC * t653;
    let t1105 = t637 - t636;
    let t1106 = t649 - t637;
    let t1107 = u_hB * t1105 - u_hA * t542 + u_hC * t1106;
    let t1108 = t1100 * t279 - t242 * t311 - t1103 + (t520 * t1104 + (t315 * t1107 - t315 * t339));
    let Iy = p.Iy;
    let Ix = p.Ix;
    let t1109 = t242 * t242 + t351 * t1100;
    let t1110 = t351 * t530 + t242 * t236;
    let t1111 = t236 * t1100 - t242 * t530;
    let t1112 = t1109 * t627 - (t1110 * t542 + t1111 * t240);
    let t1113 = t1110 * t1105 - t1111 * t313 - t1109 * t641;
    let t1114 = t1110 * t1106 - t1111 * t314 - t1109 * t653;
    let t1115 = u_hA * t1112 + u_hB * t1113 + u_hC * t1114;
    let t1116 = t530 * t246 - t351 * t627 + (t236 * t240 + t242 * t317);
    let t1117 = t1100 * t317 - t236 * t542 - (t530 * t240 - t242 * t627);
    let t1118 = 2.0_f32 * (t242 * t240) + (t1100 * t246 - t351 * t542);
    let t1119 = t242 * t1116 + t351 * t1117 - t236 * t1118;
    let t1120 = t530 * t324 + t351 * t641 + (t236 * t313 - t242 * t325);
    let t1121 = t236 * t1105 - t1100 * t325 - (t530 * t313 + t242 * t641);
    let t1122 = 2.0_f32 * (t242 * t313) + (t1100 * t324 + t351 * t1105);
    let t1123 = t242 * t1120 + t351 * t1121 - t236 * t1122;
    let t1124 = t530 * t338 + t351 * t653 + (t236 * t314 + t242 * t332);
    let t1125 = t1100 * t332 + t236 * t1106 - (t530 * t314 + t242 * t653);
    let t1126 = 2.0_f32 * (t242 * t314) + (t1100 * t338 + t351 * t1106);
    let t1127 = t242 * t1124 + t351 * t1125 - t236 * t1126;
    let t1128 = u_hA * t1119 + u_hB * t1123 + u_hC * t1127;
    let t1129 = Iz * t1108 + (Iy - Ix) * (t1115 * t1128);
    let t1130 = t565 - t563;
    let t1131 = t85 * t1130 - (t53 * t547 + t23 * t551 + t64 * t554 + t23 * t559);
    let t1132 = t573 - t571;
    let t1133 = t582 - t581;
    let t1134 = t586 - t585;
    let t1135 = t1110 * (t1131 + t100 * t1132 - t64 * t576 + t100 * t1133 + t119 * t1134);
    let t1136 = t266 + (t258 + (t255 + t23 * (t251 - t248)) + t23 * (t259 - t248)) - t271;
    let t1137 = t23 * t731 - (t53 * t692 + t23 * t704 + t64 * t721) - t85 * t740;
    let t1138 = t1109 * (t1137 - t100 * t750 - t64 * t761 - t100 * t767 - t119 * t776);
    let t1139 = u_hA * t1116 + u_hB * t1120 + u_hC * t1124;
    let t1140 = u_hA * t1117 + u_hB * t1121 + u_hC * t1125;
    let t1141 = u_hA * t1118 + u_hB * t1122 + u_hC * t1126;
    let t1142 = t1135 + t1111 * (t278 + (t273 + t1136 - t275)) - t1138 + (t1107 * t1139 - t315 * t1140 - t1104 * t1141);
    let t1143 = t1100 * t313 - t242 * t324 - t530 * t325;
    let t1144 = t530 * t332 + (t1100 * t314 - t242 * t338);
    let t1145 = u_hA * t1101 + u_hB * t1143 + u_hC * t1144;
    let t1146 = Ix * t1142 + (Iz - Iy) * (t1128 * t1145);
    let t1147 = t246 * t627;
    let t1148 = t240 * t317;
    let t1149 = t530 * t283 - t1147 - (t1147 + t351 * t692) + (t1148 - t236 * t254 + (t1148 - t242 * t369));
    let t1150 = t246 * t641;
    let t1151 = t324 * t627;
    let t1152 = t240 * t325;
    let t1153 = t313 * t317;
    let t1154 = t1150 + t530 * t287 - (t1151 + t351 * t704) + (t236 * t252 - t1152 + (t1153 - t242 * t380));
    let t1155 = t246 * t653;
    let t1156 = t338 * t627;
    let t1157 = t240 * t332;
    let t1158 = t314 * t317;
    let t1159 = t1155 + t530 * t291 - (t1156 + t351 * t721) + (t1157 - t236 * t257 + (t1158 - t242 * t392));
    let t1160 = t530 * t294 - t1151 + (t1150 + t351 * t731) + (t1153 + t236 * t260 - (t1152 + t242 * t398));
    let t1161 = t324 * t641;
    let t1162 = t313 * t325;
    let t1163 = t1161 + t530 * t299 + (t1161 - t351 * t740) - (t1162 + t236 * t265 + (t1162 + t242 * t404));
    let t1164 = t53 * t1149 + t23 * t1154 + t64 * t1159 + t23 * t1160 + t85 * t1163;
    let t1165 = t324 * t653;
    let t1166 = t338 * t641;
    let t1167 = t313 * t332;
    let t1168 = t314 * t325;
    let t1169 = t1165 + t530 * t304 + (t1166 - t351 * t750) + (t1167 + t236 * t270 - (t1168 + t242 * t416));
    let t1170 = t530 * t306 - t1156 + (t1155 - t351 * t761) + (t1158 - t236 * t272 + (t1157 - t242 * t421));
    let t1171 = t1166 + t530 * t308 + (t1165 - t351 * t767) + (t236 * t274 - t1168 + (t1167 - t242 * t425));
    let t1172 = t338 * t653;
    let t1173 = t314 * t332;
    let t1174 = t1172 + t530 * t310 + (t1172 - t351 * t776) + (t1173 - t236 * t277 + (t1173 - t242 * t432));
    let t1175 = t242 * (t1164 + t100 * t1169 + t64 * t1170 + t100 * t1171 + t119 * t1174);
    let t1176 = t240 * t627;
    let t1177 = t317 * t542;
    let t1178 = t1176 + t530 * t254 + (t1176 + t242 * t692) - (t1177 + t1100 * t369 + (t1177 + t236 * t547));
    let t1179 = t317 * t1105;
    let t1180 = t325 * t542;
    let t1181 = t240 * t641;
    let t1182 = t313 * t627;
    let t1183 = t1179 - t1100 * t380 - (t236 * t551 - t1180) - (t1181 + t530 * t252 - (t1182 + t242 * t704));
    let t1184 = t317 * t1106;
    let t1185 = t332 * t542;
    let t1186 = t240 * t653;
    let t1187 = t314 * t627;
    let t1188 = t1184 - t1100 * t392 - (t1185 + t236 * t554) - (t1186 - t530 * t257 - (t1187 + t242 * t721));
    let t1189 = t1179 - t236 * t559 - (t1100 * t398 - t1180) - (t530 * t260 - t1182 + (t1181 + t242 * t731));
    let t1190 = t325 * t1105;
    let t1191 = t313 * t641;
    let t1192 = t236 * t1130 - t1190 - (t1190 + t1100 * t404) - (t1191 - t530 * t265 + (t1191 - t242 * t740));
    let t1193 = t53 * t1178 + t23 * t1183 + t64 * t1188 + t23 * t1189 + t85 * t1192;
    let t1194 = t332 * t1105;
    let t1195 = t325 * t1106;
    let t1196 = t313 * t653;
    let t1197 = t314 * t641;
    let t1198 = t1194 + t236 * t1132 - (t1195 + t1100 * t416) - (t1196 + t530 * t270 + (t1197 - t242 * t750));
    let t1199 = t1184 - t236 * t576 - (t1185 + t1100 * t421) - (t1186 - t242 * t761 - (t1187 + t530 * t272));
    let t1200 = t1194 - t1100 * t425 + (t236 * t1133 - t1195) - (t1197 + t530 * t274 + (t1196 - t242 * t767));
    let t1201 = t332 * t1106;
    let t1202 = t314 * t653;
    let t1203 = t1201 - t1100 * t432 + (t1201 + t236 * t1134) - (t1202 - t530 * t277 + (t1202 - t242 * t776));
    let t1204 = t351 * (t1193 + t100 * t1198 + t64 * t1199 + t100 * t1200 + t119 * t1203);
    let t1205 = t246 * t542;
    let t1206 = 2.0_f32 * (t240 * t240 - t242 * t254) + (t1100 * t283 - t1205 - (t1205 + t351 * t547));
    let t1207 = t240 * t313;
    let t1208 = t246 * t1105;
    let t1209 = t324 * t542;
    let t1210 = 2.0_f32 * (t1207 + t242 * t252) + (t1208 + t1100 * t287 - (t1209 + t351 * t551));
    let t1211 = t240 * t314;
    let t1212 = t246 * t1106;
    let t1213 = t338 * t542;
    let t1214 = 2.0_f32 * (t1211 - t242 * t257) + (t1212 + t1100 * t291 - (t1213 + t351 * t554));
    let t1215 = 2.0_f32 * (t1207 + t242 * t260) + (t1100 * t294 - t1209 + (t1208 - t351 * t559));
    let t1216 = t324 * t1105;
    let t1217 = 2.0_f32 * (t313 * t313 - t242 * t265) + (t1216 + t1100 * t299 + (t1216 + t351 * t1130));
    let t1218 = t53 * t1206 + t23 * t1210 + t64 * t1214 + t23 * t1215 + t85 * t1217;
    let t1219 = t313 * t314;
    let t1220 = t324 * t1106;
    let t1221 = t338 * t1105;
    let t1222 = 2.0_f32 * (t1219 + t242 * t270) + (t1220 + t1100 * t304 + (t1221 + t351 * t1132));
    let t1223 = 2.0_f32 * (t1211 - t242 * t272) + (t1100 * t306 - t1213 + (t1212 - t351 * t576));
    let t1224 = 2.0_f32 * (t1219 + t242 * t274) + (t1221 + t1100 * t308 + (t1220 + t351 * t1133));
    let t1225 = t338 * t1106;
    let t1226 = 2.0_f32 * (t314 * t314 - t242 * t277) + (t1225 + t1100 * t310 + (t1225 + t351 * t1134));
    let t1227 = t236 * (t1218 + t100 * t1222 + t64 * t1223 + t100 * t1224 + t119 * t1226);
    let t1228 = Iy * (t1175 + t1204 - t1227 + (t315 * t1139 + t339 * t1140 - t520 * t1141));
    let t1229 = t1228 + (Ix - Iz) * (t1115 * t1145);
    let forcing_u_hA = FA - u_hA * c - (t1099 + (t1101 * t1129 + (t1112 * t1146 + t1119 * t1229)));
    let mr = p.mr;
    let t1230 = mr + t1;
    let t1231 = Ic3 * t247;
    let t1232 = Ic1 * t347;
    let t1233 = Ic2 * t355;
    let t1234 = t1230 + M * (t22 * t22 + (t204 * t204 + t134 * t134)) + (t247 * t1231 + (t347 * t1232 + t355 * t1233));
    let t1235 = Ic3 * t545;
    let t1236 = Ic1 * t669;
    let t1237 = Ic2 * t676;
    let t1238 = Ic3 * t879;
    let t1239 = Ic1 * t934;
    let t1240 = Ic2 * t942;
    let t1241 = t1234 + (t545 * t1235 + (t669 * t1236 + t676 * t1237)) + (t879 * t1238 + (t934 * t1239 + t942 * t1240));
    let t1242 = Iz * t1101;
    let t1243 = Ix * t1112;
    let t1244 = Iy * t1119;
    let mass_u_hA_u_hA = t1241 + (t1101 * t1242 + (t1112 * t1243 + t1119 * t1244));
    let t1245 = 1.0_f32 / mass_u_hA_u_hA;
    let t1246 = 0.33333334_f32 + (k * t44 - t16 * t37);
    let t1247 = t3 * shift;
    let t1248 = t9 * (t4 * t149 - t1247 - t210);
    let t1249 = shift * t30;
    let t1250 = t9 * (t143 - (t1249 + t6 * t149));
    let t1251 = M * (t22 * t1246 + (t204 * t1248 + t134 * t1250)) + (t460 * t1231 + (t348 * t1232 + t359 * t1233));
    let t1252 = t1251 + (t806 * t1235 + (t670 * t1236 + t680 * t1237)) + (t1037 * t1238 + (t935 * t1239 + t946 * t1240));
    let mass_u_hA_u_hB = t1252 + (t1143 * t1242 + (t1113 * t1243 + t1123 * t1244));
    let t1253 = mass_u_hA_u_hB * t1245;
    let t1254 = Ic3 * t460;
    let t1255 = Ic1 * t348;
    let t1256 = Ic2 * t359;
    let t1257 = t1230 + M * (t1246 * t1246 + (t1248 * t1248 + t1250 * t1250)) + (t460 * t1254 + (t348 * t1255 + t359 * t1256));
    let t1258 = Ic3 * t806;
    let t1259 = Ic1 * t670;
    let t1260 = Ic2 * t680;
    let t1261 = Ic3 * t1037;
    let t1262 = Ic1 * t935;
    let t1263 = Ic2 * t946;
    let t1264 = t1257 + (t806 * t1258 + (t670 * t1259 + t680 * t1260)) + (t1037 * t1261 + (t935 * t1262 + t946 * t1263));
    let t1265 = Iz * t1143;
    let t1266 = Ix * t1113;
    let t1267 = Iy * t1123;
    let mass_u_hB_u_hB = t1264 + (t1143 * t1265 + (t1113 * t1266 + t1123 * t1267));
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t1253;
    let t1268 = 1.0_f32 / pivot_1;
    let FB = inputs[1];
    let t1269 = t2 + (t1246 * t127 + (t1250 * t201 + t1248 * t233)) + (t460 * t365 + (t348 * t463 + t359 * t523));
    let t1270 = t1269 + (t806 * t687 + (t670 * t809 + t680 * t871)) + (t1037 * t952 + (t935 * t1040 + t946 * t1098));
    let forcing_u_hB = FB - u_hB * c - (t1270 + (t1143 * t1129 + (t1113 * t1146 + t1123 * t1229)));
    let t1271 = forcing_u_hB - forcing_u_hA * t1253;
    let t1272 = 0.33333334_f32 + (t16 * t68 + k * t72);
    let t1273 = t9 * (t4 * t161 - t1247 + t216);
    let t1274 = t9 * (t157 - (t6 * t161 - t1249));
    let t1275 = M * (t1246 * t1272 + (t1248 * t1273 + t1250 * t1274)) + (t461 * t1254 + (t349 * t1255 + t363 * t1256));
    let t1276 = t1275 + (t807 * t1258 + (t671 * t1259 + t685 * t1260)) + (t1038 * t1261 + (t936 * t1262 + t950 * t1263));
    let mass_u_hB_u_hC = t1276 + (t1144 * t1265 + (t1114 * t1266 + t1127 * t1267));
    let t1277 = M * (t22 * t1272 + (t204 * t1273 + t134 * t1274)) + (t461 * t1231 + (t349 * t1232 + t363 * t1233));
    let t1278 = t1277 + (t807 * t1235 + (t671 * t1236 + t685 * t1237)) + (t1038 * t1238 + (t936 * t1239 + t950 * t1240));
    let mass_u_hA_u_hC = t1278 + (t1144 * t1242 + (t1114 * t1243 + t1127 * t1244));
    let t1279 = mass_u_hB_u_hC - mass_u_hA_u_hC * t1253;
    let t1280 = t1279 * t1268;
    let FC = inputs[2];
    let t1281 = t2 + (t1272 * t127 + (t1274 * t201 + t1273 * t233)) + (t461 * t365 + (t349 * t463 + t363 * t523));
    let t1282 = t1281 + (t807 * t687 + (t671 * t809 + t685 * t871)) + (t1038 * t952 + (t936 * t1040 + t950 * t1098));
    let forcing_u_hC = FC - u_hC * c - (t1282 + (t1144 * t1129 + (t1114 * t1146 + t1127 * t1229)));
    let t1283 = mass_u_hA_u_hC * t1245;
    let t1284 = t1230 + M * (t1272 * t1272 + (t1273 * t1273 + t1274 * t1274)) + (t461 * (Ic3 * t461) + (t349 * (Ic1 * t349) + t363 * (Ic2 * t363)));
    let t1285 = t1284 + (t807 * (Ic3 * t807) + (t671 * (Ic1 * t671) + t685 * (Ic2 * t685)));
    let t1286 = t1285 + (t1038 * (Ic3 * t1038) + (t936 * (Ic1 * t936) + t950 * (Ic2 * t950)));
    let mass_u_hC_u_hC = t1286 + (t1144 * (Iz * t1144) + (t1114 * (Ix * t1114) + t1127 * (Iy * t1127)));
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t1283 - t1279 * t1280;
    let t1287 = (forcing_u_hC - forcing_u_hA * t1283 - t1280 * t1271) / pivot_2;
    let t1288 = t1268 * t1271 - t1280 * t1287;
    let t1289 = forcing_u_hA * t1245 - t1253 * t1288 - t1283 * t1287;
    let t1290 = Real::min(Real::min(0.21652833_f32 * Real::abs(mass_u_hA_u_hA), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t1289, t1288, t1287], t1290)
}
///Kinetic and potential energy (J).
///
///996 operations.
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
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t1 = mr + (ms + mc);
    let M = p.M;
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let R = p.R;
    let t2 = 1.0_f32 / (3.0_f32 * R);
    let t3 = 2.0_f32 * (hA - 0.5_f32 * hB - 0.5_f32 * hC) * t2;
    let t4 = t3 * t3;
    let t5 = 2.0_f32 * (0.8660254_f32 * hB - 0.8660254_f32 * hC) * t2;
    let t6 = t5 * t5;
    let root = Real::sqrt(1.0_f32 + t4 + t6);
    let t7 = 1.0_f32 + root;
    let k = 1.0_f32 / (root * t7);
    let t8 = 0.5_f32 * R;
    let t9 = 2.0_f32 * t2;
    let t10 = 2.0_f32 * (t3 * t9);
    let t11 = t6 * (6.0_f32 * t2) - (t4 * t9 + t3 * t10);
    let t12 = 3.0_f32 * t3;
    let cos3 = t6 * t12 - t3 * t4;
    let t13 = t8 * cos3;
    let t14 = 1.0_f32 / root;
    let t15 = 0.5_f32 * t14;
    let t16 = t10 * t15;
    let t17 = k * (k * (t7 * t16 + root * t16));
    let t18 = 0.33333334_f32 + (k * (t8 * t11) - t13 * t17);
    let t19 = 1.0_f32 / t7;
    let shift = k * cos3 * t19;
    let t20 = t19 * (k * t11 - cos3 * t17 - shift * t16);
    let cos2 = t4 - t6;
    let t21 = t19 * cos2;
    let t22 = t8 * (shift * t9 + t3 * t20 + t19 * (t10 - t21 * t16));
    let t23 = 2.0_f32 * t3;
    let sin2 = t5 * t23;
    let t24 = t19 * sin2;
    let t25 = t8 * (t19 * (t5 * (4.0_f32 * t2) - t24 * t16) - t5 * t20);
    let t26 = t4 * k;
    let t27 = t26 - 1.0_f32;
    let t28 = t3 * t14;
    let t29 = 1.0_f32 / Real::sqrt(1.0_f32 - t28 * t28);
    let t30 = t27 * t29;
    let t31 = t5 * (k * t9 - t3 * t17);
    let t32 = t3 * k;
    let t33 = t5 * t32;
    let t34 = t33 * t29;
    let t35 = t4 * t17;
    let t36 = k * t10;
    let t37 = t35 - t36;
    let t38 = t30 * t31 + t34 * t37;
    let Ic3 = p.Ic3;
    let t39 = Ic3 * t38;
    let t40 = t28 * t30;
    let t41 = t14 * (t9 - t28 * t16);
    let t42 = 0.5_f32 * t29;
    let t43 = t29 * (t29 * (2.0_f32 * (t28 * t41) * t42));
    let t44 = t29 * t31 + t33 * t43;
    let t45 = t28 * t34;
    let t46 = t29 * (t36 - t35) + t27 * t43;
    let t47 = t40 * t44 - t45 * t46;
    let Ic1 = p.Ic1;
    let t48 = Ic1 * t47;
    let t49 = 1.0_f32 - t26;
    let t50 = t49 * (t30 * t41 + t28 * t46) - t33 * (t34 * t41 + t28 * t44);
    let t51 = t28 * (t34 * t31 + t33 * t44 - (t30 * t37 + t49 * t46)) + t50;
    let Ic2 = p.Ic2;
    let t52 = Ic2 * t51;
    let t53 = t1 + M * (t18 * t18 + (t22 * t22 + t25 * t25)) + (t38 * t39 + (t47 * t48 + t51 * t52));
    let t54 = 0.5_f32 * t33;
    let t55 = t6 * k;
    let t56 = 0.8660254_f32 * (1.0_f32 - t55);
    let t57 = t54 + t56;
    let t58 = 0.5_f32 * t28;
    let t59 = t5 * t14;
    let t60 = 0.8660254_f32 * t59;
    let dzB = t58 - t60;
    let t61 = 1.0_f32 / Real::sqrt(1.0_f32 - dzB * dzB);
    let t62 = t57 * t61;
    let t63 = 0.5_f32 * t37;
    let t64 = 0.8660254_f32 * t31;
    let t65 = t63 + t64;
    let t66 = 0.5_f32 * t49;
    let t67 = 0.8660254_f32 * t33;
    let t68 = t66 + t67;
    let t69 = t68 * t61;
    let t70 = 0.5_f32 * t31;
    let t71 = t6 * t17;
    let t72 = 0.8660254_f32 * t71;
    let t73 = t70 + t72;
    let t74 = t62 * t65 - t69 * t73;
    let t75 = Ic3 * t74;
    let t76 = t60 - t58;
    let t77 = t76 * t62;
    let t78 = 0.5_f32 * t41;
    let t79 = t14 * (t59 * t16);
    let t80 = 0.8660254_f32 * t79;
    let t81 = t78 + t80;
    let t82 = 0.5_f32 * t61;
    let t83 = t61 * (t61 * (2.0_f32 * (dzB * t81) * t82));
    let t84 = t61 * t65 + t68 * t83;
    let t85 = t76 * t69;
    let t86 = t61 * t73 + t57 * t83;
    let t87 = t77 * t84 - t85 * t86;
    let t88 = Ic1 * t87;
    let t89 = t57 * (t76 * t86 - t62 * t81) + t68 * (t76 * t84 - t69 * t81);
    let t90 = t76 * (t62 * t73 + t57 * t86 + (t69 * t65 + t68 * t84)) - t89;
    let t91 = Ic2 * t90;
    let t92 = t66 - t67;
    let dzC = t58 + t60;
    let t93 = 1.0_f32 / Real::sqrt(1.0_f32 - dzC * dzC);
    let t94 = t92 * t93;
    let t95 = t72 - t70;
    let t96 = t56 - t54;
    let t97 = t96 * t93;
    let t98 = t64 - t63;
    let t99 = t94 * t95 + t97 * t98;
    let t100 = Ic3 * t99;
    let t101 = dzC * t97;
    let t102 = t78 - t80;
    let t103 = 0.5_f32 * t93;
    let t104 = t93 * (t93 * (2.0_f32 * (dzC * t102) * t103));
    let t105 = t93 * (t63 - t64) + t92 * t104;
    let t106 = dzC * t94;
    let t107 = t93 * t95 + t96 * t104;
    let t108 = t101 * t105 - t106 * t107;
    let t109 = Ic1 * t108;
    let t110 = t67 - t66;
    let t111 = t96 * (t97 * t102 + dzC * t107) - t110 * (t94 * t102 + dzC * t105);
    let t112 = t111 - dzC * (t97 * t95 + t96 * t107 - (t94 * t98 + t110 * t105));
    let t113 = Ic2 * t112;
    let t114 = t53 + (t74 * t75 + (t87 * t88 + t90 * t91)) + (t99 * t100 + (t108 * t109 + t112 * t113));
    let t115 = t55 - 1.0_f32;
    let t116 = t59 * t41 + (t115 * t31 - t33 * t37);
    let Iz = p.Iz;
    let t117 = Iz * t116;
    let t118 = t33 * t33 + t49 * t115;
    let t119 = t49 * t59 + t33 * t28;
    let t120 = t28 * t115 - t33 * t59;
    let t121 = t118 * t79 - (t119 * t71 + t120 * t31);
    let Ix = p.Ix;
    let t122 = Ix * t121;
    let t123 = t33 * (t59 * t37 - t49 * t79 + (t28 * t31 + t33 * t41)) + t49 * (t115 * t41 - t28 * t71 - (t59 * t31 - t33 * t79));
    let t124 = t123 - t28 * (2.0_f32 * (t33 * t31) + (t115 * t37 - t49 * t71));
    let Iy = p.Iy;
    let t125 = Iy * t124;
    let mass_u_hA_u_hA = t114 + (t116 * t117 + (t121 * t122 + t124 * t125));
    let u_hB = u[1];
    let t126 = 2.0_f32 * (t2 * t3);
    let t127 = t2 * t4 + t3 * t126;
    let t128 = 1.7320508_f32 * t2;
    let t129 = 2.0_f32 * (t5 * t128);
    let t130 = t12 * t129;
    let t131 = t6 * (3.0_f32 * t2);
    let t132 = t127 + (t130 - t131);
    let t133 = t129 - t126;
    let t134 = t15 * t133;
    let t135 = k * (k * (t7 * t134 + root * t134));
    let t136 = 0.33333334_f32 + (k * (t8 * t132) - t13 * t135);
    let t137 = t19 * (k * t132 - cos3 * t135 - shift * t134);
    let t138 = t2 * shift;
    let t139 = t126 + t129;
    let t140 = t8 * (t3 * t137 - t138 - t19 * (t139 + t21 * t134));
    let t141 = t23 * t128;
    let t142 = t5 * t9;
    let t143 = shift * t128;
    let t144 = t8 * (t19 * (t141 - t142 - t24 * t134) - (t143 + t5 * t137));
    let t145 = t32 * t128;
    let t146 = t2 * k;
    let t147 = t145 - t5 * (t146 + t3 * t135);
    let t148 = k * t126;
    let t149 = t148 + t4 * t135;
    let t150 = t30 * t147 + t34 * t149;
    let t151 = t14 * (t2 + t28 * t134);
    let t152 = t29 * (t29 * (t42 * (2.0_f32 * (t28 * t151))));
    let t153 = t29 * t149 + t27 * t152;
    let t154 = t29 * t147 - t33 * t152;
    let t155 = t45 * t153 + t40 * t154;
    let t156 = t33 * (t28 * t154 - t34 * t151) + t49 * (t30 * t151 + t28 * t153);
    let t157 = t28 * (t34 * t147 + t33 * t154 - (t30 * t149 - t49 * t153)) - t156;
    let t158 = M * (t18 * t136 + (t22 * t140 + t25 * t144)) + (t150 * t39 + (t155 * t48 + t157 * t52));
    let t159 = 0.5_f32 * t149;
    let t160 = 0.8660254_f32 * t147;
    let t161 = t159 + t160;
    let t162 = 0.5_f32 * t147;
    let t163 = t6 * t135;
    let t164 = k * t129;
    let t165 = 0.8660254_f32 * (t163 - t164);
    let t166 = t162 + t165;
    let t167 = t62 * t161 - t69 * t166;
    let t168 = 0.5_f32 * t151;
    let t169 = t14 * (t128 - t59 * t134);
    let t170 = 0.8660254_f32 * t169;
    let t171 = t168 + t170;
    let t172 = t61 * (t61 * (t82 * (2.0_f32 * (dzB * t171))));
    let t173 = t61 * t161 - t68 * t172;
    let t174 = t61 * t166 - t57 * t172;
    let t175 = t77 * t173 - t85 * t174;
    let t176 = t57 * (t62 * t171 + t76 * t174) + t68 * (t69 * t171 + t76 * t173);
    let t177 = t76 * (t62 * t166 + t57 * t174 + (t69 * t161 + t68 * t173)) - t176;
    let t178 = t165 - t162;
    let t179 = t160 - t159;
    let t180 = t94 * t178 + t97 * t179;
    let t181 = t170 - t168;
    let t182 = t93 * (t93 * (t103 * (2.0_f32 * (dzC * t181))));
    let t183 = t93 * (t159 - t160) + t92 * t182;
    let t184 = t93 * t178 + t96 * t182;
    let t185 = t101 * t183 - t106 * t184;
    let t186 = t96 * (t97 * t181 + dzC * t184) - t110 * (t94 * t181 + dzC * t183);
    let t187 = t186 - dzC * (t97 * t178 + t96 * t184 - (t94 * t179 + t110 * t183));
    let t188 = t158 + (t167 * t75 + (t175 * t88 + t177 * t91)) + (t180 * t100 + (t185 * t109 + t187 * t113));
    let t189 = t115 * t147 - t33 * t149 - t59 * t151;
    let t190 = t164 - t163;
    let t191 = t119 * t190 - t120 * t147 - t118 * t169;
    let t192 = t33 * (t59 * t149 + t49 * t169 + (t28 * t147 - t33 * t151)) + t49 * (t28 * t190 - t115 * t151 - (t59 * t147 + t33 * t169));
    let t193 = t192 - t28 * (2.0_f32 * (t33 * t147) + (t115 * t149 + t49 * t190));
    let mass_u_hA_u_hB = t188 + (t189 * t117 + (t191 * t122 + t193 * t125));
    let u_hC = u[2];
    let t194 = t15 * t139;
    let t195 = k * (k * (t7 * t194 + root * t194));
    let t196 = t127 - (t130 + t131);
    let t197 = 0.33333334_f32 + (t13 * t195 + k * (t8 * t196));
    let t198 = t19 * (cos3 * t195 + k * t196 + shift * t194);
    let t199 = t8 * (t3 * t198 - t138 + t19 * (t133 + t21 * t194));
    let t200 = t8 * (t19 * (t24 * t194 - (t141 + t142)) - (t5 * t198 - t143));
    let t201 = t5 * (t3 * t195 - t146) - t145;
    let t202 = t4 * t195;
    let t203 = t148 - t202;
    let t204 = t30 * t201 + t34 * t203;
    let t205 = t14 * (t28 * t194 - t2);
    let t206 = t29 * (t29 * (t42 * (2.0_f32 * (t28 * t205))));
    let t207 = t29 * t201 + t33 * t206;
    let t208 = t29 * (t202 - t148) + t27 * t206;
    let t209 = t40 * t207 - t45 * t208;
    let t210 = t49 * (t30 * t205 + t28 * t208) - t33 * (t34 * t205 + t28 * t207);
    let t211 = t28 * (t34 * t201 + t33 * t207 - (t30 * t203 + t49 * t208)) + t210;
    let t212 = M * (t18 * t197 + (t22 * t199 + t25 * t200)) + (t204 * t39 + (t209 * t48 + t211 * t52));
    let t213 = 0.5_f32 * t203;
    let t214 = 0.8660254_f32 * t201;
    let t215 = t213 + t214;
    let t216 = 0.5_f32 * t201;
    let t217 = t6 * t195;
    let t218 = 0.8660254_f32 * (t164 - t217);
    let t219 = t216 + t218;
    let t220 = t62 * t215 - t69 * t219;
    let t221 = 0.5_f32 * t205;
    let t222 = t14 * (t59 * t194 - t128);
    let t223 = 0.8660254_f32 * t222;
    let t224 = t61 * (t61 * (t82 * (2.0_f32 * (dzB * (t221 - t223)))));
    let t225 = t61 * t215 + t68 * t224;
    let t226 = t61 * t219 + t57 * t224;
    let t227 = t77 * t225 - t85 * t226;
    let t228 = t223 - t221;
    let t229 = t57 * (t62 * t228 + t76 * t226) + t68 * (t69 * t228 + t76 * t225);
    let t230 = t76 * (t62 * t219 + t57 * t226 + (t69 * t215 + t68 * t225)) - t229;
    let t231 = t218 - t216;
    let t232 = t214 - t213;
    let t233 = t94 * t231 + t97 * t232;
    let t234 = t221 + t223;
    let t235 = t93 * (t93 * (t103 * (2.0_f32 * (dzC * t234))));
    let t236 = t93 * (t213 - t214) + t92 * t235;
    let t237 = t93 * t231 + t96 * t235;
    let t238 = t101 * t236 - t106 * t237;
    let t239 = t96 * (t97 * t234 + dzC * t237) - t110 * (t94 * t234 + dzC * t236);
    let t240 = t239 - dzC * (t97 * t231 + t96 * t237 - (t94 * t232 + t110 * t236));
    let t241 = t212 + (t220 * t75 + (t227 * t88 + t230 * t91)) + (t233 * t100 + (t238 * t109 + t240 * t113));
    let t242 = t59 * t205 + (t115 * t201 - t33 * t203);
    let t243 = t217 - t164;
    let t244 = t119 * t243 - t120 * t201 - t118 * t222;
    let t245 = t33 * (t59 * t203 + t49 * t222 + (t28 * t201 + t33 * t205)) + t49 * (t115 * t205 + t28 * t243 - (t59 * t201 + t33 * t222));
    let t246 = t245 - t28 * (2.0_f32 * (t33 * t201) + (t115 * t203 + t49 * t243));
    let mass_u_hA_u_hC = t241 + (t242 * t117 + (t244 * t122 + t246 * t125));
    let t247 = 0.5_f32 * (u_hA * u_hA * mass_u_hA_u_hA) + u_hA * u_hB * mass_u_hA_u_hB + u_hA * u_hC * mass_u_hA_u_hC;
    let t248 = Ic3 * t150;
    let t249 = Ic1 * t155;
    let t250 = Ic2 * t157;
    let t251 = t1 + M * (t136 * t136 + (t140 * t140 + t144 * t144)) + (t150 * t248 + (t155 * t249 + t157 * t250));
    let t252 = Ic3 * t167;
    let t253 = Ic1 * t175;
    let t254 = Ic2 * t177;
    let t255 = Ic3 * t180;
    let t256 = Ic1 * t185;
    let t257 = Ic2 * t187;
    let t258 = t251 + (t167 * t252 + (t175 * t253 + t177 * t254)) + (t180 * t255 + (t185 * t256 + t187 * t257));
    let t259 = Iz * t189;
    let t260 = Ix * t191;
    let t261 = Iy * t193;
    let mass_u_hB_u_hB = t258 + (t189 * t259 + (t191 * t260 + t193 * t261));
    let t262 = M * (t136 * t197 + (t140 * t199 + t144 * t200)) + (t204 * t248 + (t209 * t249 + t211 * t250));
    let t263 = t262 + (t220 * t252 + (t227 * t253 + t230 * t254)) + (t233 * t255 + (t238 * t256 + t240 * t257));
    let mass_u_hB_u_hC = t263 + (t242 * t259 + (t244 * t260 + t246 * t261));
    let t264 = t1 + M * (t197 * t197 + (t199 * t199 + t200 * t200)) + (t204 * (Ic3 * t204) + (t209 * (Ic1 * t209) + t211 * (Ic2 * t211)));
    let t265 = t264 + (t220 * (Ic3 * t220) + (t227 * (Ic1 * t227) + t230 * (Ic2 * t230)));
    let t266 = t265 + (t233 * (Ic3 * t233) + (t238 * (Ic1 * t238) + t240 * (Ic2 * t240)));
    let mass_u_hC_u_hC = t266 + (t242 * (Iz * t242) + (t244 * (Ix * t244) + t246 * (Iy * t246)));
    let t267 = t247 + 0.5_f32 * (u_hB * u_hB * mass_u_hB_u_hB) + u_hB * u_hC * mass_u_hB_u_hC + 0.5_f32 * (u_hC * u_hC * mass_u_hC_u_hC);
    let g = p.g;
    let t268 = hA * g;
    let t269 = hB * g;
    let t270 = hC * g;
    let t271 = ms * t268 + mc * t268 + ms * t269 + mc * t269 + ms * t270;
    let heave = 0.33333334_f32 * (hC + (hA + hB));
    let rise = k * t13;
    let t272 = t271 + mc * t270 + M * (g * (heave + rise));
    (t267, t272)
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
