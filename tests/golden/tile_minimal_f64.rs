// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 548 operations (6 abs, 92 add, 13 div, 8 min, 332 mul, 4 sqrt, 93 sub).
// Cost of energy: 185 operations (40 add, 7 div, 118 mul, 1 sqrt, 19 sub).
// Cost of speeds: 180 operations (31 add, 10 div, 112 mul, 4 sqrt, 23 sub).
// Cost of outputs: 78 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 42 mul, 1 sin, 2 sqrt, 11 sub).
// Cost of projection: 0 operations ().
// Cost of prepare: 21 operations (5 add, 1 div, 10 mul, 5 sub).

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
pub const SPEED_NAMES: [&str; 15usize] = [
    "u_hA",
    "u_psiA",
    "u_thA",
    "u_sA",
    "u_hB",
    "u_psiB",
    "u_thB",
    "u_sB",
    "u_hC",
    "u_psiC",
    "u_thC",
    "u_sC",
    "u_slope_x",
    "u_slope_y",
    "u_root",
];
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
#[repr(C)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Parameters {
    ///Radius of the circle of screws (m), models/tile_minimal.toml:11.
    pub R: S,
    ///Mass that moves with a screw (kg), models/tile_minimal.toml:12.
    pub ms: S,
    ///Inertia of motor, worm and screw reflected on the height; has no weight (kg), models/tile_minimal.toml:13.
    pub mr: S,
    ///Mass of a connector (kg), models/tile_minimal.toml:14.
    pub mc: S,
    ///Connector about its rod (kg m^2), models/tile_minimal.toml:15.
    pub Ic1: S,
    ///Connector about its horizontal axis (kg m^2), models/tile_minimal.toml:16.
    pub Ic2: S,
    ///Connector about its third axis (kg m^2), models/tile_minimal.toml:17.
    pub Ic3: S,
    ///Mass of the platform (kg), models/tile_minimal.toml:18.
    pub M: S,
    ///Platform about rod A (kg m^2), models/tile_minimal.toml:19.
    pub Ix: S,
    ///Platform across rod A (kg m^2), models/tile_minimal.toml:20.
    pub Iy: S,
    ///Platform about its normal (kg m^2), models/tile_minimal.toml:21.
    pub Iz: S,
    ///Viscous friction of a screw (N s/m), models/tile_minimal.toml:22.
    pub c: S,
    ///Gravity (m/s^2), models/tile_minimal.toml:23.
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
/// What the functions below need of the parameters, from [`prepare`].
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Prepared {
    ///The parameter `R`.
    pub R: S,
    ///The parameter `M`.
    pub M: S,
    ///The parameter `c`.
    pub c: S,
    ///The parameter `g`.
    pub g: S,
    ///Of parameters alone.
    pub k4: S,
    ///Of parameters alone.
    pub k5: S,
    ///Of parameters alone.
    pub k6: S,
    ///Of parameters alone.
    pub k7: S,
    ///Of parameters alone.
    pub k8: S,
    ///Of parameters alone.
    pub k9: S,
    ///Of parameters alone.
    pub k10: S,
    ///Of parameters alone.
    pub k11: S,
    ///Of parameters alone.
    pub k12: S,
    ///Of parameters alone.
    pub k13: S,
    ///Of parameters alone.
    pub k14: S,
    ///Of parameters alone.
    pub k15: S,
    ///Of parameters alone.
    pub k16: S,
    ///Of parameters alone.
    pub k17: S,
    ///Of parameters alone.
    pub k18: S,
    ///Of parameters alone.
    pub k19: S,
    ///Of parameters alone.
    pub k20: S,
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///21 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let R = p.R;
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let Ic3 = p.Ic3;
    let Ic2 = p.Ic2;
    let t2 = Ic3 - Ic2;
    let t3 = 3.0_f64 * Ic2;
    let t4 = 1.5_f64 * Ic2;
    let Ic1 = p.Ic1;
    let t5 = t2 - Ic1;
    let ms = p.ms;
    let mc = p.mc;
    let t6 = ms + mc;
    let Iz = p.Iz;
    let t7 = Iz + t3;
    let Ix = p.Ix;
    let t8 = Ix + t4;
    let Iy = p.Iy;
    let t9 = Iy + t4;
    let t10 = 0.5_f64 * t5;
    let g = p.g;
    let t11 = ms * g;
    let t12 = mc * g;
    let t13 = g * t6;
    let M = p.M;
    let t14 = M * g;
    let mr = p.mr;
    let t15 = mr + t6;
    let t16 = R * g;
    let t17 = R * M;
    let t18 = t8 - t9;
    let t19 = t9 - t7;
    let t20 = t7 - t8;
    let c = p.c;
    Prepared { R, M, c, g, k4: t2, k5: t5, k6: t10, k7: t11, k8: t12, k9: t13, k10: t14, k11: t15, k12: t16, k13: t17, k14: t1, k15: t7, k16: t8, k17: t9, k18: t18, k19: t19, k20: t20 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///548 operations.
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
    p: &Prepared,
) -> ([S; 3usize], [S; 3usize], S) {
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = t21 * t26;
    let t28 = 0.8660254037844386_f64 * sC;
    let t29 = 0.5_f64 * sC;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t30 = t27 * t28;
    let t31 = sA + t29;
    let t32 = 0.8660254037844386_f64 * t6;
    let t33 = 0.5_f64 * t7;
    let t34 = t30 + t31;
    let t35 = t32 + t33;
    let t36 = t33 - t32;
    let t37 = 1.0_f64 / t34;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let u_sB_per_u_hB = t35 * v_G_z_per_u_hA;
    let t38 = t36 * v_G_z_per_u_hA;
    let t39 = w_platform_x_per_u_hB * t28;
    let t40 = t7 * v_G_z_per_u_hA;
    let t41 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t42 = t38 * t38;
    let t43 = v_G_z_per_u_hA + t39;
    let t44 = t41 - 1.0_f64;
    let t45 = 1.0_f64 - t41;
    let t46 = 1.0_f64 - t42;
    let t47 = t40 * t40;
    let w_platform_y_per_u_hB = t37 * t39;
    let t48 = t37 * t43;
    let t49 = 1.0_f64 / t44;
    let t50 = Real::sqrt(t45);
    let t51 = 1.0_f64 / t46;
    let t52 = 1.0_f64 - t47;
    let u_hB = u[1];
    let t53 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t54 = u_hA * t48;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t37;
    let t55 = Real::sqrt(t46);
    let t56 = 1.0_f64 / t52;
    let t57 = Real::sqrt(t52);
    let k5 = p.k5;
    let t58 = k5 * u_sB_per_u_hB;
    let t59 = k5 * t38;
    let t60 = t53 - t54;
    let u_hC = u[2];
    let t61 = u_hC * w_platform_y_per_u_hC;
    let t62 = u_sB_per_u_hB * t58;
    let t63 = t38 * t59;
    let t64 = k5 * t40;
    let w_platform_y = t60 + t61;
    let t65 = u_sB_per_u_hB - t38;
    let t66 = u_hA - u_hB;
    let t67 = v_G_z_per_u_hA * t49;
    let k4 = p.k4;
    let t68 = t62 - k4;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t51;
    let t69 = t63 - k4;
    let t70 = t40 * t64;
    let t71 = 0.28867513459481287_f64 * t65;
    let t72 = 0.8660254037844386_f64 * t40;
    let t73 = t27 * w_platform_y;
    let t74 = t66 * w_platform_x_per_u_hB;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t56;
    let t75 = t70 - k4;
    let t76 = t69 * u_psiC_per_w_platform_z;
    let t77 = t68 * t67;
    let t78 = 1.0_f64 / t50;
    let t79 = t72 - t71;
    let t80 = t74 + t73;
    let t81 = t6 * t13;
    let t82 = t7 * t13;
    let t83 = 0.4330127018922193_f64 * sA;
    let t84 = u_psiC_per_w_platform_z * t76;
    let t85 = t67 * t77;
    let t86 = t75 * u_psiA_per_w_platform_z;
    let t87 = 1.0_f64 / t55;
    let t88 = 1.0_f64 / t57;
    let t89 = 0.5_f64 * t79;
    let t90 = 0.8660254037844386_f64 * t79;
    let t91 = t81 * w_platform_y;
    let t92 = t82 * t80;
    let t93 = t71 + t72;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t65;
    let t94 = t83 + t18;
    let t95 = t84 + t85;
    let t96 = u_psiA_per_w_platform_z * t86;
    let t97 = t49 * t89;
    let t98 = t49 * t90;
    let t99 = t91 + t92;
    let t100 = 0.5_f64 * v_G_z_per_u_hA;
    let t101 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t102 = 0.5_f64 * t93;
    let t103 = 0.8660254037844386_f64 * t93;
    let t104 = v_G_y_per_u_hA * t56;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t94;
    let t105 = t96 + t95;
    let k13 = p.k13;
    let t106 = k13 * t22;
    let t107 = t97 * w_platform_y;
    let t108 = t98 * t80;
    let t109 = t100 * t78;
    let t110 = t101 * t78;
    let u_psiC_per_w_platform_y = t51 * t102;
    let t111 = t51 * t103;
    let t112 = u_psiA_per_w_platform_z * t99;
    let t113 = t104 * w_platform_y;
    let t114 = 0.3333333333333333_f64 * t65;
    let M = p.M;
    let t115 = M * v_G_x_per_w_platform_z;
    let k15 = p.k15;
    let t116 = k15 - t105;
    let t117 = sA * t106;
    let t118 = t107 - t108;
    let t119 = t67 * t99;
    let t120 = t79 * t78;
    let t121 = w_platform_y * t109;
    let t122 = t80 * t110;
    let t123 = u_psiC_per_w_platform_y * w_platform_y;
    let t124 = t111 * t80;
    let t125 = t87 * t100;
    let u_psiA = t113 - t112;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t88;
    let u_thC_per_w_platform_z = t93 * t87;
    let t126 = v_G_y_per_u_hA * t88;
    let t127 = v_G_x_per_w_platform_z * t99;
    let t128 = u_hA * t114;
    let t129 = 1.1547005383792515_f64 * t79;
    let t130 = v_G_x_per_w_platform_z * t115;
    let t131 = t117 + t116;
    let t132 = t76 * t111;
    let t133 = t77 * t98;
    let u_psiB = t118 + t119;
    let t134 = t99 * t120;
    let t135 = t121 - t122;
    let t136 = t123 + t124;
    let t137 = u_psiC_per_w_platform_z * t99;
    let t138 = t40 * u_psiA;
    let t139 = t99 * u_thC_per_w_platform_z;
    let t140 = w_platform_y * t125;
    let u_thC_per_w_platform_x = t87 * t101;
    let t141 = t99 * t126;
    let t142 = w_platform_y * u_thA_per_w_platform_y;
    let t143 = t128 + t127;
    let t144 = u_hB * t129;
    let u_sB_per_w_platform_z = 0.8660254037844386_f64 * sA;
    let t145 = 0.5_f64 * t65;
    let t146 = t130 + t131;
    let t147 = t132 + t133;
    let t148 = u_sB_per_u_hB * u_psiB;
    let u_thB = t134 - t135;
    let t149 = 0.8660254037844386_f64 * w_platform_y;
    let t150 = 0.5_f64 * t80;
    let u_psiC = t136 - t137;
    let t151 = t140 + t139;
    let t152 = t80 * u_thC_per_w_platform_x;
    let t153 = 2.0_f64 * t138;
    let u_thA = t141 + t142;
    let t154 = t144 + t143;
    let t155 = t99 * u_sB_per_w_platform_z;
    let t156 = u_hA * t145;
    let t157 = t77 * t97;
    let t158 = t76 * u_psiC_per_w_platform_y;
    let t159 = 2.0_f64 * t147;
    let t160 = t82 * t146;
    let t161 = t69 * t111;
    let t162 = t68 * t98;
    let t163 = t148 * u_thB;
    let t164 = t149 + t150;
    let t165 = 0.8660254037844386_f64 * t80;
    let t166 = 0.5_f64 * w_platform_y;
    let t167 = t38 * u_psiC;
    let t168 = t152 + t151;
    let t169 = t153 * u_thA;
    let t170 = t80 * t99;
    let t171 = 0.5_f64 * t154;
    let t172 = t156 + t155;
    let t173 = t157 - t158;
    let t174 = t86 * t104;
    let t175 = t68 * t97;
    let t176 = t69 * u_psiC_per_w_platform_y;
    let t177 = t159 + t160;
    let t178 = t111 * t161;
    let t179 = t98 * t162;
    let t180 = 2.0_f64 * t163;
    let t181 = t164 * t99;
    let t182 = t165 - t166;
    let t183 = u_psiA * t57;
    let t184 = t149 - t150;
    let t185 = t167 * t168;
    let t186 = t57 * t169;
    let t187 = v_G_y_per_u_hA * t170;
    let t188 = w_platform_y * t80;
    let t189 = t171 + t172;
    let t190 = u_hB * u_sB_per_u_hB;
    let t191 = u_hA * t40;
    let t192 = t146 * t81;
    let t193 = t173 - t174;
    let t194 = t98 * t175;
    let t195 = t111 * t176;
    let t196 = t82 * t177;
    let t197 = t178 + t179;
    let t198 = t50 * t180;
    let t199 = t79 * t181;
    let t200 = t164 * t182;
    let t201 = u_psiB * t50;
    let t202 = t138 * t183;
    let t203 = t99 * t184;
    let t204 = 2.0_f64 * t185;
    let t205 = t166 + t165;
    let t206 = t187 - t186;
    let t207 = v_G_z_per_u_hA * t188;
    let t208 = t189 - t190;
    let u_sA = t154 - t191;
    let t209 = t192 - t193;
    let t210 = t147 * t81;
    let t211 = t194 - t195;
    let t212 = t197 - t196;
    let t213 = 2.0_f64 * t193;
    let t214 = u_psiC_per_w_platform_y * t176;
    let t215 = t97 * t175;
    let t216 = t75 * t104;
    let t217 = t115 * t114;
    let t218 = v_G_y_per_u_hA * t106;
    let t219 = t198 - t199;
    let t220 = v_G_z_per_u_hA * t200;
    let t221 = u_psiC * t55;
    let t222 = t148 * t201;
    let t223 = k5 * t202;
    let t224 = t93 * t203;
    let t225 = t55 * t204;
    let t226 = t184 * t205;
    let k6 = p.k6;
    let t227 = k6 * t169;
    let t228 = t207 + t206;
    let t229 = t99 * u_sA;
    let t230 = t99 * t208;
    let t231 = t82 * t209;
    let t232 = t210 + t211;
    let k16 = p.k16;
    let t233 = t212 - k16;
    let t234 = t213 - t192;
    let t235 = t214 + t215;
    let t236 = t104 * t216;
    let t237 = t217 + t218;
    let t238 = t219 - t220;
    let t239 = k6 * t180;
    let t240 = t167 * t221;
    let t241 = k5 * t222;
    let t242 = t224 + t225;
    let t243 = v_G_z_per_u_hA * t226;
    let t244 = t57 * t227;
    let t245 = t56 * t228;
    let t246 = t126 * t223;
    let k18 = p.k18;
    let t247 = k18 * t188;
    let t248 = 2.0_f64 * t229;
    let t249 = sA * t188;
    let t250 = sB * t200;
    let t251 = 2.0_f64 * t230;
    let t252 = t231 + t232;
    let t253 = t27 * t233;
    let t254 = t81 * t234;
    let t255 = t236 + t235;
    let t256 = t237 * t82;
    let t257 = t49 * t238;
    let t258 = 2.0_f64 * t239;
    let t259 = k5 * t240;
    let t260 = t243 + t242;
    let t261 = k6 * t204;
    let t262 = 2.0_f64 * t244;
    let t263 = t75 * t245;
    let t264 = t120 * t241;
    let t265 = t247 - t246;
    let t266 = t249 + t248;
    let t267 = t250 + t251;
    let t268 = sA * t99;
    let t269 = u_hA * v_G_y_per_u_hA;
    let t270 = 2.0_f64 * t252;
    let t271 = t254 + t255;
    let t272 = t252 - t253;
    let t273 = t256 * t27;
    let t274 = t237 * t81;
    let t275 = t68 * t257;
    let t276 = t50 * t258;
    let u_psiC_dot_bias = t51 * t260;
    let t277 = t55 * t261;
    let t278 = t262 - t263;
    let t279 = u_thC_per_w_platform_z * t259;
    let t280 = t264 + t265;
    let t281 = 0.8660254037844386_f64 * t267;
    let t282 = 0.4330127018922193_f64 * t266;
    let t283 = u_hC * t38;
    let v_G_y = t268 + t269;
    let t284 = t270 - t253;
    let k17 = p.k17;
    let t285 = k17 - t271;
    let t286 = t272 * w_platform_x_per_u_hB;
    let t287 = t273 + t274;
    let t288 = M * t114;
    let t289 = M * v_G_y_per_u_hA;
    let t290 = t115 * t129;
    let t291 = t275 - t276;
    let t292 = t69 * u_psiC_dot_bias;
    let t293 = 2.0_f64 * t277;
    let t294 = t182 * t208;
    let t295 = w_platform_y * u_sA;
    let t296 = t279 - t280;
    let t297 = u_psiA_per_w_platform_z * t278;
    let t298 = t282 - t281;
    let t299 = t283 - t171;
    let t300 = 0.8660254037844386_f64 * v_G_y;
    let t301 = t27 * t284;
    let t302 = t117 + t285;
    let t303 = t286 + t287;
    let t304 = v_G_z_per_u_hA * t106;
    let t305 = t233 * w_platform_x_per_u_hB;
    let t306 = 2.0_f64 * t256;
    let t307 = t114 * t288;
    let t308 = v_G_y_per_u_hA * t289;
    let t309 = t82 * t290;
    let t310 = t292 + t293;
    let t311 = sB * t181;
    let t312 = 2.0_f64 * t294;
    let t313 = 2.0_f64 * t295;
    let t314 = sA * t170;
    let t315 = t67 * t291;
    let t316 = t297 + t296;
    let t317 = M * t266;
    let k10 = p.k10;
    let t318 = k10 * v_G_y_per_u_hA;
    let t319 = 1.3333333333333333_f64 * t298;
    let t320 = t110 * t241;
    let t321 = u_thC_per_w_platform_x * t259;
    let u_sC = t299 + t300;
    let t322 = t301 + t302;
    let t323 = t304 + t303;
    let t324 = t305 - t306;
    let t325 = t307 + t308;
    let t326 = t27 * t309;
    let t327 = t81 * t290;
    let t328 = t125 * t259;
    let t329 = t109 * t241;
    let t330 = t311 - t312;
    let t331 = t313 - t314;
    let t332 = t315 - t316;
    let t333 = u_psiC_per_w_platform_z * t310;
    let t334 = t317 + t318;
    let t335 = M * t319;
    let t336 = k10 * t40;
    let t337 = t320 - t321;
    let t338 = t98 * t291;
    let t339 = t205 * u_sC;
    let t340 = t322 * t48;
    let t341 = 2.0_f64 * t323;
    let t342 = w_platform_x_per_u_hB * t324;
    let k11 = p.k11;
    let t343 = k11 + t325;
    let t344 = M * v_G_z_per_u_hA;
    let t345 = t326 + t327;
    let t346 = t328 + t329;
    let t347 = u_thA_per_w_platform_y * t223;
    let t348 = t331 - t330;
    let t349 = t333 - t332;
    let t350 = sA * t334;
    let t351 = t335 + t336;
    let t352 = t337 - t338;
    let t353 = t111 * t310;
    let t354 = w_platform_y * t99;
    let t355 = sC * t203;
    let t356 = 2.0_f64 * t339;
    let t357 = t340 - t341;
    let t358 = t342 - t343;
    let t359 = v_G_z_per_u_hA * t344;
    let t360 = t345 - t286;
    let t361 = t322 * w_platform_y_per_u_hB;
    let t362 = t97 * t291;
    let t363 = t347 + t346;
    let t364 = t21 * t348;
    let t365 = t350 + t349;
    let t366 = v_G_x_per_w_platform_z * t351;
    let t367 = t353 + t352;
    let k19 = p.k19;
    let t368 = k19 * t354;
    let t369 = t355 + t356;
    let t370 = t48 * t357;
    let t371 = t358 - t359;
    let t372 = t361 + t360;
    let t373 = M * t129;
    let t374 = t362 - t363;
    let t375 = u_psiC_per_w_platform_y * t310;
    let t376 = t366 + t365;
    let t377 = t368 + t367;
    let t378 = t233 * t364;
    let t379 = t28 * t364;
    let t380 = t331 + t369;
    let mass_u_hA_u_hA = t370 - t371;
    let t381 = t48 * t372;
    let t382 = t114 * t373;
    let t383 = t256 - t309;
    let t384 = 2.0_f64 * t309;
    let t385 = t375 + t374;
    let t386 = t104 * t278;
    let t387 = t378 + t377;
    let t388 = t82 * t376;
    let t389 = t379 + t380;
    let t390 = t256 * t364;
    let t391 = 1.0_f64 / mass_u_hA_u_hA;
    let t392 = t381 - t382;
    let t393 = t323 * w_platform_y_per_u_hB;
    let t394 = t383 - t305;
    let t395 = t305 + t384;
    let t396 = t386 + t385;
    let k20 = p.k20;
    let t397 = k20 * t170;
    let t398 = t387 - t388;
    let t399 = t37 * t389;
    let FA = inputs[0];
    let t400 = FA - t390;
    let t401 = t114 * t351;
    let t402 = t393 - t392;
    let t403 = w_platform_x_per_u_hB * t394;
    let t404 = 2.0_f64 * t360;
    let t405 = w_platform_x_per_u_hB * t395;
    let t406 = t129 * t373;
    let t407 = t397 + t396;
    let t408 = t252 * t364;
    let t409 = w_platform_x_per_u_hB * t398;
    let t410 = t323 * t399;
    let t411 = t400 - t401;
    let t412 = v_G_y_per_u_hA * t334;
    let mass_u_hA_u_hB = t402 - t403;
    let t413 = t361 + t404;
    let t414 = t405 - t406;
    let t415 = t407 - t408;
    let t416 = t81 * t376;
    let t417 = t27 * t398;
    let t418 = t322 * t399;
    let t419 = M * t331;
    let t420 = k10 * v_G_z_per_u_hA;
    let t421 = t309 * t364;
    let t422 = t410 + t409;
    let t423 = t411 - t412;
    let t424 = t391 * mass_u_hA_u_hB;
    let t425 = w_platform_y_per_u_hB * t413;
    let t426 = t414 - k11;
    let t427 = t415 - t416;
    let t428 = t418 + t417;
    let t429 = t419 + t420;
    let t430 = t129 * t351;
    let t431 = t360 * t399;
    let FB = inputs[1];
    let t432 = FB - t421;
    let t433 = t423 + t422;
    let t434 = mass_u_hA_u_hB * t424;
    let mass_u_hB_u_hB = t425 - t426;
    let t435 = t427 + t428;
    let t436 = sA * t429;
    let t437 = t409 + t430;
    let t438 = t431 + t432;
    let k9 = p.k9;
    let t439 = t433 - k9;
    let c = p.c;
    let t440 = u_hA * c;
    let t441 = t322 * w_platform_y_per_u_hC;
    let pivot_1 = mass_u_hB_u_hB - t434;
    let t442 = t435 - t436;
    let t443 = t438 - t437;
    let t444 = t439 - t440;
    let t445 = v_G_z_per_u_hA * t429;
    let t446 = t323 * w_platform_y_per_u_hC;
    let t447 = t48 * t441;
    let t448 = 1.0_f64 / pivot_1;
    let t449 = t443 - k9;
    let t450 = u_hB * c;
    let t451 = t48 * t442;
    let t452 = t444 - t445;
    let mass_u_hA_u_hC = t446 - t447;
    let t453 = t360 * w_platform_y_per_u_hC;
    let t454 = w_platform_y_per_u_hB * t441;
    let t455 = w_platform_y_per_u_hB * t442;
    let t456 = t449 - t450;
    let forcing_u_hA = t452 - t451;
    let t457 = t424 * mass_u_hA_u_hC;
    let mass_u_hB_u_hC = t453 + t454;
    let forcing_u_hB = t455 + t456;
    let t458 = t424 * forcing_u_hA;
    let t459 = mass_u_hB_u_hC - t457;
    let t460 = forcing_u_hB - t458;
    let t461 = t448 * t459;
    let t462 = t391 * mass_u_hA_u_hC;
    let t463 = u_hC * c;
    let FC = inputs[2];
    let t464 = k9 - FC;
    let t465 = w_platform_y_per_u_hC * t441;
    let t466 = Real::abs(t11);
    let t467 = t461 * t460;
    let t468 = t462 * forcing_u_hA;
    let t469 = w_platform_y_per_u_hC * t442;
    let t470 = t463 + t464;
    let t471 = mass_u_hA_u_hC * t462;
    let mass_u_hC_u_hC = k11 + t465;
    let t472 = Real::abs(t18);
    let t473 = t467 + t468;
    let forcing_u_hC = t469 - t470;
    let t474 = t459 * t461;
    let t475 = mass_u_hC_u_hC - t471;
    let t476 = Real::abs(t34);
    let t477 = forcing_u_hC - t473;
    let pivot_2 = t475 - t474;
    let t478 = Real::abs(mass_u_hA_u_hA);
    let t479 = t477 / pivot_2;
    let t480 = Real::min(t52, t45);
    let t481 = Real::abs(pivot_1);
    let t482 = Real::min(t480, t46);
    let t483 = 0.5_f64 * t466;
    let t484 = Real::abs(pivot_2);
    let t485 = Real::min(t482, t483);
    let t486 = 5.773502691896257_f64 * t472;
    let t487 = t448 * t460;
    let t488 = t461 * t479;
    let t489 = 1.6666666666666665_f64 * t476;
    let t490 = Real::min(t485, t486);
    let t491 = t487 - t488;
    let t492 = 0.2165283291230603_f64 * t478;
    let t493 = Real::min(t490, t489);
    let t494 = t424 * t491;
    let t495 = t462 * t479;
    let t496 = 0.21680787182359307_f64 * t481;
    let t497 = Real::min(t493, t492);
    let t498 = t495 + t494;
    let t499 = t391 * forcing_u_hA;
    let t500 = 0.21706868422196887_f64 * t484;
    let t501 = Real::min(t497, t496);
    let t502 = t499 - t498;
    let t503 = Real::min(t501, t500);
    ([u_hA, u_hB, u_hC], [t502, t491, t479], t503)
}
///Kinetic and potential energy (J).
///
///185 operations.
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
    p: &Prepared,
) -> (S, S) {
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = t21 * t26;
    let t28 = 0.8660254037844386_f64 * sC;
    let t29 = 0.5_f64 * sC;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t30 = 1.0_f64 / (t27 * t28 + (sA + t29));
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t31 = 0.8660254037844386_f64 * t6;
    let t32 = 0.5_f64 * t7;
    let t33 = w_platform_x_per_u_hB * t28;
    let t34 = t31 + t32;
    let t35 = t32 - t31;
    let t36 = v_G_z_per_u_hA + t33;
    let u_sB_per_u_hB = t34 * v_G_z_per_u_hA;
    let t37 = t35 * v_G_z_per_u_hA;
    let w_platform_y_per_u_hB = t30 * t33;
    let t38 = t30 * t36;
    let t39 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t40 = t37 * t37;
    let u_hB = u[1];
    let t41 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t42 = u_hA * t38;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t30;
    let t43 = t7 * v_G_z_per_u_hA;
    let t44 = t39 - 1.0_f64;
    let t45 = 1.0_f64 - t40;
    let t46 = t41 - t42;
    let u_hC = u[2];
    let t47 = u_hC * w_platform_y_per_u_hC;
    let t48 = u_sB_per_u_hB - t37;
    let t49 = 1.0_f64 / t44;
    let t50 = 1.0_f64 / t45;
    let t51 = t43 * t43;
    let w_platform_y = t46 + t47;
    let t52 = 0.28867513459481287_f64 * t48;
    let t53 = 0.8660254037844386_f64 * t43;
    let t54 = u_hA - u_hB;
    let t55 = 1.0_f64 - t51;
    let t56 = t53 - t52;
    let t57 = t27 * w_platform_y;
    let t58 = t54 * w_platform_x_per_u_hB;
    let t59 = t52 + t53;
    let t60 = 1.0_f64 / t55;
    let t61 = 0.5_f64 * t56;
    let t62 = t58 + t57;
    let t63 = 0.8660254037844386_f64 * t56;
    let t64 = t6 * t13;
    let t65 = t7 * t13;
    let t66 = 0.5_f64 * t59;
    let t67 = 0.8660254037844386_f64 * t59;
    let t68 = t49 * t61;
    let t69 = t49 * t63;
    let t70 = t64 * w_platform_y;
    let t71 = t65 * t62;
    let u_psiC_per_w_platform_y = t50 * t66;
    let t72 = t50 * t67;
    let t73 = t68 * w_platform_y;
    let t74 = t69 * t62;
    let t75 = t70 + t71;
    let t76 = v_G_z_per_u_hA * t49;
    let t77 = u_psiC_per_w_platform_y * w_platform_y;
    let t78 = t72 * t62;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t50;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t48;
    let t79 = t73 - t74;
    let t80 = t76 * t75;
    let k5 = p.k5;
    let t81 = k5 * u_sB_per_u_hB;
    let t82 = t77 + t78;
    let t83 = u_psiC_per_w_platform_z * t75;
    let t84 = k5 * t37;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t60;
    let t85 = v_G_y_per_u_hA * t60;
    let t86 = 0.4330127018922193_f64 * sA;
    let u_psiB = t79 + t80;
    let t87 = u_sB_per_u_hB * t81;
    let u_psiC = t82 - t83;
    let t88 = t37 * t84;
    let t89 = u_psiA_per_w_platform_z * t75;
    let t90 = t85 * w_platform_y;
    let t91 = k5 * t43;
    let t92 = t86 + t18;
    let t93 = u_psiB * u_psiB;
    let k4 = p.k4;
    let t94 = t87 - k4;
    let t95 = u_psiC * u_psiC;
    let t96 = t88 - k4;
    let u_psiA = t90 - t89;
    let t97 = t43 * t91;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t92;
    let t98 = 0.3333333333333333_f64 * t48;
    let t99 = t94 * t93;
    let t100 = t96 * t95;
    let t101 = u_psiA * u_psiA;
    let t102 = t97 - k4;
    let t103 = sA * t75;
    let t104 = u_hA * v_G_y_per_u_hA;
    let t105 = v_G_x_per_w_platform_z * t75;
    let t106 = u_hA * t98;
    let t107 = 1.1547005383792515_f64 * t56;
    let t108 = t99 + t100;
    let t109 = t102 * t101;
    let t110 = t75 * t75;
    let v_G_y = t103 + t104;
    let t111 = t106 + t105;
    let t112 = u_hB * t107;
    let t113 = t109 + t108;
    let k15 = p.k15;
    let t114 = k15 * t110;
    let t115 = v_G_y * v_G_y;
    let t116 = t112 + t111;
    let t117 = t114 - t113;
    let M = p.M;
    let t118 = M * t115;
    let t119 = t116 * t116;
    let t120 = sA * w_platform_y;
    let t121 = u_hA * v_G_z_per_u_hA;
    let t122 = t118 + t117;
    let t123 = M * t119;
    let t124 = t62 * t62;
    let v_G_z = t120 + t121;
    let t125 = t123 + t122;
    let k16 = p.k16;
    let t126 = k16 * t124;
    let t127 = w_platform_y * w_platform_y;
    let t128 = v_G_z * v_G_z;
    let t129 = u_hB * u_hB;
    let t130 = t126 + t125;
    let k17 = p.k17;
    let t131 = k17 * t127;
    let t132 = M * t128;
    let k11 = p.k11;
    let t133 = k11 * t129;
    let t134 = u_hA * u_hA;
    let t135 = u_hC * u_hC;
    let k12 = p.k12;
    let t136 = k12 * t22;
    let t137 = t131 + t130;
    let t138 = t133 + t132;
    let t139 = k11 * t134;
    let t140 = k11 * t135;
    let t141 = t43 * t136;
    let g = p.g;
    let t142 = hA * g;
    let k7 = p.k7;
    let t143 = hB * k7;
    let k9 = p.k9;
    let t144 = hA * k9;
    let k8 = p.k8;
    let t145 = hB * k8;
    let t146 = hC * k9;
    let t147 = t137 + t138;
    let t148 = t139 + t140;
    let t149 = t142 + t141;
    let t150 = t143 + t144;
    let t151 = t145 + t146;
    let t152 = t148 + t147;
    let t153 = M * t149;
    let t154 = t150 + t151;
    let t155 = 0.5_f64 * t152;
    let t156 = t153 + t154;
    (t155, t156)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///180 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn speeds(
    _t: S,
    q: &[S; 3usize],
    u: &[S; 3usize],
    _inputs: &[S; 3usize],
    p: &Prepared,
) -> [S; 15usize] {
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = t21 * t26;
    let t28 = 0.8660254037844386_f64 * sC;
    let t29 = 0.5_f64 * sC;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t30 = 1.0_f64 / (t27 * t28 + (sA + t29));
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t31 = 0.8660254037844386_f64 * t6;
    let t32 = 0.5_f64 * t7;
    let t33 = w_platform_x_per_u_hB * t28;
    let t34 = t31 + t32;
    let t35 = t32 - t31;
    let t36 = v_G_z_per_u_hA + t33;
    let u_sB_per_u_hB = t34 * v_G_z_per_u_hA;
    let t37 = t35 * v_G_z_per_u_hA;
    let w_platform_y_per_u_hB = t30 * t33;
    let t38 = t30 * t36;
    let t39 = t7 * v_G_z_per_u_hA;
    let t40 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t41 = t37 * t37;
    let u_hB = u[1];
    let t42 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t43 = u_hA * t38;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t30;
    let t44 = t39 * t39;
    let t45 = 1.0_f64 - t40;
    let t46 = 1.0_f64 - t41;
    let t47 = t42 - t43;
    let u_hC = u[2];
    let t48 = u_hC * w_platform_y_per_u_hC;
    let t49 = 1.0_f64 - t44;
    let t50 = Real::sqrt(t45);
    let t51 = Real::sqrt(t46);
    let w_platform_y = t47 + t48;
    let t52 = u_hA - u_hB;
    let t53 = Real::sqrt(t49);
    let t54 = t27 * w_platform_y;
    let t55 = t52 * w_platform_x_per_u_hB;
    let t56 = t6 * t13;
    let t57 = t55 + t54;
    let t58 = t7 * t13;
    let t59 = u_sB_per_u_hB - t37;
    let t60 = 0.4330127018922193_f64 * sA;
    let t61 = t40 - 1.0_f64;
    let t62 = t56 * w_platform_y;
    let t63 = t58 * t57;
    let t64 = t60 + t18;
    let t65 = 0.28867513459481287_f64 * t59;
    let t66 = 0.8660254037844386_f64 * t39;
    let t67 = 1.0_f64 / t61;
    let t68 = 1.0_f64 / t50;
    let t69 = 1.0_f64 / t46;
    let t70 = 1.0_f64 / t51;
    let t71 = t62 + t63;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t64;
    let t72 = 0.3333333333333333_f64 * t59;
    let t73 = t66 - t65;
    let t74 = 1.0_f64 / t49;
    let t75 = 1.0_f64 / t53;
    let t76 = v_G_x_per_w_platform_z * t71;
    let t77 = u_hA * t72;
    let t78 = 1.1547005383792515_f64 * t73;
    let t79 = t65 + t66;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t59;
    let t80 = t77 + t76;
    let t81 = u_hB * t78;
    let t82 = 0.5_f64 * t73;
    let t83 = 0.8660254037844386_f64 * t73;
    let t84 = 0.5_f64 * v_G_z_per_u_hA;
    let t85 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let u_sB_per_w_platform_z = 0.8660254037844386_f64 * sA;
    let t86 = 0.5_f64 * t59;
    let t87 = 0.5_f64 * t79;
    let t88 = 0.8660254037844386_f64 * t79;
    let t89 = t7 * root;
    let t90 = t6 * root;
    let t91 = t81 + t80;
    let t92 = t67 * t82;
    let t93 = t67 * t83;
    let t94 = t84 * t68;
    let t95 = t85 * t68;
    let t96 = t71 * u_sB_per_w_platform_z;
    let t97 = u_hA * t86;
    let u_psiC_per_w_platform_y = t69 * t87;
    let t98 = t69 * t88;
    let u_thC_per_w_platform_z = t79 * t70;
    let t99 = t70 * t84;
    let t100 = sA * t71;
    let t101 = u_hA * v_G_y_per_u_hA;
    let t102 = w_platform_y * t89;
    let t103 = t57 * t90;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t74;
    let t104 = v_G_y_per_u_hA * t74;
    let t105 = v_G_y_per_u_hA * t75;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t75;
    let t106 = t92 * w_platform_y;
    let t107 = t93 * t57;
    let t108 = v_G_z_per_u_hA * t67;
    let t109 = t73 * t68;
    let t110 = w_platform_y * t94;
    let t111 = t57 * t95;
    let t112 = 0.5_f64 * t91;
    let t113 = t97 + t96;
    let t114 = u_psiC_per_w_platform_y * w_platform_y;
    let t115 = t98 * t57;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t69;
    let t116 = t71 * u_thC_per_w_platform_z;
    let t117 = w_platform_y * t99;
    let u_thC_per_w_platform_x = t70 * t85;
    let t118 = u_hC * t37;
    let v_G_y = t100 + t101;
    let u_root = t102 - t103;
    let t119 = u_psiA_per_w_platform_z * t71;
    let t120 = t104 * w_platform_y;
    let t121 = t71 * t105;
    let t122 = w_platform_y * u_thA_per_w_platform_y;
    let t123 = u_hA * t39;
    let t124 = t106 - t107;
    let t125 = t108 * t71;
    let t126 = t71 * t109;
    let t127 = t110 - t111;
    let t128 = t112 + t113;
    let t129 = u_hB * u_sB_per_u_hB;
    let t130 = t114 + t115;
    let t131 = u_psiC_per_w_platform_z * t71;
    let t132 = t117 + t116;
    let t133 = t57 * u_thC_per_w_platform_x;
    let t134 = t118 - t112;
    let t135 = 0.8660254037844386_f64 * v_G_y;
    let t136 = t58 * u_root;
    let t137 = root * w_platform_y;
    let t138 = t56 * u_root;
    let t139 = root * t57;
    let u_psiA = t120 - t119;
    let u_thA = t121 + t122;
    let u_sA = t91 - t123;
    let u_psiB = t124 + t125;
    let u_thB = t126 - t127;
    let t140 = t129 - t128;
    let u_psiC = t130 - t131;
    let t141 = t133 + t132;
    let u_sC = t134 + t135;
    let u_slope_x = t137 + t136;
    let u_slope_y = t139 - t138;
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, t140, u_hC, u_psiC, -t141, u_sC, u_slope_x, u_slope_y, u_root]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///78 operations.
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
    p: &Prepared,
) -> [S; 12usize] {
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let k = 1.0_f64 / (root * t11);
    let t12 = t7 * k;
    let t13 = t9 * k;
    let psiA = Real::atan2(t6 * t12, 1.0_f64 - t13);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t14 = t7 * v_G_z_per_u_hA;
    let t15 = 1.0_f64 - t14 * t14;
    let t16 = 1.0_f64 / t11;
    let t17 = Real::sqrt(t15);
    let t18 = 0.8660254037844386_f64 * t6;
    let t19 = 0.5_f64 * t7;
    let t20 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let t21 = 2.0_f64 * t7;
    let t22 = t18 + t19;
    let t23 = t19 - t18;
    let t24 = t20 + cos2;
    let t25 = t6 * t21;
    let u_sB_per_u_hB = t22 * v_G_z_per_u_hA;
    let t26 = t23 * v_G_z_per_u_hA;
    let t27 = t24 * t16;
    let t28 = 0.8660254037844386_f64 * t25;
    let thA = Real::asin(t14);
    let t29 = Real::asin(u_sB_per_u_hB);
    let t30 = Real::asin(t26);
    let t31 = 1.0_f64 + t27;
    let t32 = 0.8660254037844386_f64 * t7;
    let t33 = 0.5_f64 * t6;
    let t34 = t22 * t22;
    let t35 = t8 + t28;
    let t36 = t23 * t23;
    let t37 = t8 - t28;
    let R = p.R;
    let sA = R * t31;
    let t38 = t17 * cos_psiA;
    let t39 = t22 * k;
    let t40 = t32 - t33;
    let t41 = t34 * k;
    let t42 = t35 * t16;
    let t43 = t23 * k;
    let acrossC = t32 + t33;
    let t44 = t36 * k;
    let t45 = t37 * t16;
    let t46 = t17 * sin_psiA;
    let t47 = sA * t38;
    let t48 = sA * t14;
    let t49 = t40 * t39;
    let t50 = 1.0_f64 - t41;
    let t51 = 1.0_f64 + t42;
    let t52 = acrossC * t43;
    let t53 = 1.0_f64 - t44;
    let t54 = 1.0_f64 + t45;
    let t55 = sA * t46;
    let t56 = R - t47;
    let t57 = hA + t48;
    let psiB = Real::atan2(-t49, t50);
    let sB = R * t51;
    let psiC = Real::atan2(t52, t53);
    let sC = R * t54;
    [t55, t56, t57, psiA, thA, sA, psiB, -t29, sB, psiC, -t30, sC]
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
    _p: &Prepared,
) -> ([S; 0usize], S) {
    ([], 0.0_f64)
}
///Three-legged tile in minimal coordinates: three heights, everything else in closed form.
#[derive(Clone, Copy, Debug)]
pub struct TileMinimal {
    parameters: Parameters,
    prepared: Prepared,
}
impl Default for TileMinimal {
    fn default() -> Self {
        Self::new(Parameters::default())
    }
}
impl TileMinimal {
    /// The mechanism with these parameters.
    #[must_use]
    pub fn new(parameters: Parameters) -> Self {
        Self {
            parameters,
            prepared: prepare(&parameters),
        }
    }
    /// Its parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }
    /// What depends on them alone.
    #[must_use]
    pub fn prepared(&self) -> &Prepared {
        &self.prepared
    }
    /// Changes all parameters and prepares anew.
    pub fn set_parameters(&mut self, parameters: Parameters) {
        *self = Self::new(parameters);
    }
    /// The parameter at a position of `PARAMETER_NAMES`; none beyond the last.
    #[must_use]
    pub fn parameter(&self, index: usize) -> Option<S> {
        Some(
            match index {
                0usize => self.parameters.R,
                1usize => self.parameters.ms,
                2usize => self.parameters.mr,
                3usize => self.parameters.mc,
                4usize => self.parameters.Ic1,
                5usize => self.parameters.Ic2,
                6usize => self.parameters.Ic3,
                7usize => self.parameters.M,
                8usize => self.parameters.Ix,
                9usize => self.parameters.Iy,
                10usize => self.parameters.Iz,
                11usize => self.parameters.c,
                12usize => self.parameters.g,
                _ => return None,
            },
        )
    }
    /// Changes the parameter at a position of `PARAMETER_NAMES` and prepares anew; false beyond the last.
    pub fn set_parameter(&mut self, index: usize, value: S) -> bool {
        let place = match index {
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
            _ => return false,
        };
        *place = value;
        self.prepared = prepare(&self.parameters);
        true
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
        (*q_out, *u_out, pivot) = rates(t, q, u, inputs, &self.prepared);
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
            &self.prepared,
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
                &self.prepared,
            ),
        )
    }
}
