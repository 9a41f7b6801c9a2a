// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 548 operations (6 abs, 92 add, 13 div, 8 min, 332 mul, 4 sqrt, 93 sub).
// Cost of energy: 185 operations (40 add, 7 div, 118 mul, 1 sqrt, 19 sub).
// Cost of speeds: 180 operations (31 add, 10 div, 112 mul, 4 sqrt, 23 sub).
// Cost of outputs: 78 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 42 mul, 1 sin, 2 sqrt, 11 sub).
// Cost of projection: 0 operations ().
// Cost of prepare: 21 operations (5 add, 1 div, 10 mul, 5 sub).

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
pub const NOMINAL: [f32; 3usize] = [0f32, 0f32, 0f32];
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
    let Ic3 = p.Ic3;
    let Ic2 = p.Ic2;
    let t1 = Ic3 - Ic2;
    let Ic1 = p.Ic1;
    let t2 = t1 - Ic1;
    let t3 = 0.5_f32 * t2;
    let ms = p.ms;
    let g = p.g;
    let t4 = ms * g;
    let mc = p.mc;
    let t5 = mc * g;
    let t6 = ms + mc;
    let t7 = g * t6;
    let M = p.M;
    let t8 = M * g;
    let mr = p.mr;
    let t9 = mr + t6;
    let R = p.R;
    let t10 = R * g;
    let t11 = R * M;
    let t12 = 1.0_f32 / (3.0_f32 * R);
    let Iz = p.Iz;
    let t13 = Iz + 3.0_f32 * Ic2;
    let t14 = 1.5_f32 * Ic2;
    let Ix = p.Ix;
    let t15 = Ix + t14;
    let Iy = p.Iy;
    let t16 = Iy + t14;
    let t17 = t15 - t16;
    let t18 = t16 - t13;
    let t19 = t13 - t15;
    let c = p.c;
    Prepared { R, M, c, g, k4: t1, k5: t2, k6: t3, k7: t4, k8: t5, k9: t7, k10: t8, k11: t9, k12: t10, k13: t11, k14: t12, k15: t13, k16: t15, k17: t16, k18: t17, k19: t18, k20: t19 }
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
    let t1 = hB - hC;
    let hA = q[0];
    let t2 = 0.5_f32 * (hB + hC) - hA;
    let t3 = 1.7320508_f32 * t1;
    let t4 = 2.0_f32 * t2;
    let k14 = p.k14;
    let t5 = k14 * t3;
    let t6 = k14 * t4;
    let t7 = t5 * t5;
    let t8 = t6 * t6;
    let t9 = t7 + t8;
    let cos2 = t8 - t7;
    let t10 = 0.5_f32 * t9 + cos2;
    let t11 = 0.8660254_f32 * (t5 * (2.0_f32 * t6));
    let t12 = t7 + t11;
    let t13 = t7 - t11;
    let root = Real::sqrt(1.0_f32 + t9);
    let t14 = 1.0_f32 + root;
    let t15 = 1.0_f32 / t14;
    let t16 = 1.0_f32 + t10 * t15;
    let t17 = 1.0_f32 + t12 * t15;
    let t18 = 1.0_f32 + t13 * t15;
    let R = p.R;
    let sB = R * t17;
    let sC = R * t18;
    let sA = R * t16;
    let k13 = p.k13;
    let t19 = k13 * t16;
    let t20 = sA + 0.5_f32 * sB;
    let t21 = 0.8660254_f32 * sB;
    let t22 = 1.0_f32 / t21;
    let t23 = t22 * t20;
    let t24 = sA + 0.5_f32 * sC;
    let t25 = 0.8660254_f32 * sC;
    let t26 = t23 * t25 + t24;
    let t27 = 0.8660254_f32 * t5;
    let t28 = 0.5_f32 * t6;
    let t29 = t27 + t28;
    let t30 = t28 - t27;
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let t31 = t5 * t15;
    let t32 = t6 * t15;
    let t33 = t6 * v_G_z_per_u_hA;
    let u_sB_per_u_hB = t29 * v_G_z_per_u_hA;
    let t34 = t30 * v_G_z_per_u_hA;
    let t35 = u_sB_per_u_hB - t34;
    let t36 = 0.28867513_f32 * t35;
    let t37 = 0.8660254_f32 * t33;
    let t38 = t37 - t36;
    let t39 = t36 + t37;
    let t40 = 0.5_f32 * Real::abs(t14);
    let t41 = 1.0_f32 - t34 * t34;
    let t42 = 1.0_f32 - t33 * t33;
    let t43 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t44 = 1.0_f32 - t43;
    let t45 = Real::min(Real::min(Real::min(t42, t44), t41), t40);
    let t46 = 0.4330127_f32 * sA + t21;
    let t47 = Real::min(Real::min(t45, 5.773503_f32 * Real::abs(t21)), 1.6666666_f32 * Real::abs(t26));
    let t48 = 1.0_f32 / t26;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t22;
    let t49 = w_platform_x_per_u_hB * t25;
    let w_platform_y_per_u_hB = t48 * t49;
    let t50 = t48 * (v_G_z_per_u_hA + t49);
    let u_hA = u[0];
    let t51 = u_hA * t50;
    let u_hB = u[1];
    let t52 = u_hB * w_platform_y_per_u_hB - t51;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t48;
    let u_hC = u[2];
    let w_platform_y = t52 + u_hC * w_platform_y_per_u_hC;
    let t53 = (u_hA - u_hB) * w_platform_x_per_u_hB + t23 * w_platform_y;
    let t54 = 1.0_f32 / (t43 - 1.0_f32);
    let t55 = t54 * (0.5_f32 * t38);
    let t56 = t54 * (0.8660254_f32 * t38);
    let t57 = t55 * w_platform_y - t56 * t53;
    let t58 = t31 * w_platform_y + t32 * t53;
    let t59 = u_hA * (0.5_f32 * t35);
    let u_sB_per_w_platform_z = 0.8660254_f32 * sA;
    let t60 = t59 + t58 * u_sB_per_w_platform_z;
    let t61 = v_G_z_per_u_hA * t54;
    let u_psiB = t57 + t61 * t58;
    let t62 = Real::sqrt(t44);
    let t63 = 1.0_f32 / t62;
    let t64 = 0.5_f32 * v_G_z_per_u_hA;
    let t65 = t64 * t63;
    let t66 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t67 = t66 * t63;
    let t68 = w_platform_y * t65 - t53 * t67;
    let t69 = t38 * t63;
    let u_thB = t58 * t69 - t68;
    let t70 = u_sB_per_u_hB * u_psiB;
    let t71 = t70 * (u_psiB * t62);
    let t72 = t70 * u_thB;
    let t73 = 0.8660254_f32 * w_platform_y;
    let t74 = 0.5_f32 * t53;
    let t75 = t73 + t74;
    let t76 = t73 - t74;
    let t77 = 2.0_f32 * t72;
    let t78 = t62 * t77;
    let t79 = t75 * t58;
    let t80 = t78 - t38 * t79;
    let t81 = 0.8660254_f32 * t53;
    let t82 = 0.5_f32 * w_platform_y;
    let t83 = t81 - t82;
    let t84 = t82 + t81;
    let t85 = sB * t79;
    let t86 = t75 * t83;
    let t87 = sB * t86;
    let t88 = t54 * (t80 - v_G_z_per_u_hA * t86);
    let k6 = p.k6;
    let t89 = t62 * (2.0_f32 * (k6 * t77));
    let t90 = 0.5_f32 * t39;
    let t91 = 1.0_f32 / t41;
    let u_psiC_per_w_platform_y = t91 * t90;
    let t92 = t91 * (0.8660254_f32 * t39);
    let t93 = u_psiC_per_w_platform_y * w_platform_y + t92 * t53;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t91;
    let u_psiC = t93 - u_psiC_per_w_platform_z * t58;
    let k5 = p.k5;
    let t94 = k5 * t71;
    let t95 = t65 * t94;
    let t96 = t69 * t94;
    let t97 = t67 * t94;
    let k4 = p.k4;
    let t98 = u_sB_per_u_hB * (k5 * u_sB_per_u_hB) - k4;
    let t99 = t98 * t88 - t89;
    let t100 = Real::sqrt(t41);
    let t101 = 1.0_f32 / t100;
    let t102 = t101 * t64;
    let t103 = t34 * u_psiC;
    let t104 = k5 * (t103 * (u_psiC * t100));
    let t105 = t102 * t104 + t95;
    let t106 = 1.0_f32 / t42;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t106;
    let v_G_y_per_u_hA = 0.57735026_f32 * t35;
    let t107 = v_G_y_per_u_hA * t106;
    let t108 = u_psiA_per_w_platform_z * t58;
    let u_psiA = t107 * w_platform_y - t108;
    let t109 = Real::sqrt(t42);
    let t110 = t33 * u_psiA;
    let t111 = k5 * (t110 * (u_psiA * t109));
    let t112 = 1.0_f32 / t109;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t112;
    let t113 = u_thA_per_w_platform_y * t111 + t105;
    let t114 = t55 * t99 - t113;
    let t115 = v_G_y_per_u_hA * t112;
    let t116 = w_platform_y * u_thA_per_w_platform_y;
    let t117 = t115 * t111;
    let u_thA = t58 * t115 + t116;
    let t118 = 2.0_f32 * t110 * u_thA;
    let u_thC_per_w_platform_x = t101 * t66;
    let u_thC_per_w_platform_z = t39 * t101;
    let t119 = t58 * t76;
    let t120 = t39 * t119;
    let t121 = sC * t119;
    let t122 = w_platform_y * t102 + t58 * u_thC_per_w_platform_z;
    let t123 = u_thC_per_w_platform_z * t104;
    let t124 = t97 - u_thC_per_w_platform_x * t104;
    let t125 = 2.0_f32 * (t103 * (t53 * u_thC_per_w_platform_x + t122));
    let t126 = t120 + t100 * t125;
    let u_psiC_dot_bias = t91 * (v_G_z_per_u_hA * (t76 * t84) + t126);
    let t127 = t100 * (k6 * t125);
    let t128 = t109 * (k6 * t118);
    let t129 = t109 * t118;
    let t130 = 2.0_f32 * t127;
    let t131 = t34 * (k5 * t34) - k4;
    let t132 = t131 * u_psiC_dot_bias + t130;
    let t133 = t33 * (k5 * t33) - k4;
    let t134 = u_psiC_per_w_platform_y * t132 + t114;
    let t135 = t53 * t58;
    let t136 = v_G_y_per_u_hA * t135 - t129;
    let t137 = w_platform_y * t53;
    let t138 = t106 * (v_G_z_per_u_hA * t137 + t136);
    let t139 = 2.0_f32 * t128;
    let t140 = t139 - t133 * t138;
    let t141 = t107 * t140 + t134;
    let k20 = p.k20;
    let t142 = k20 * t135 + t141;
    let v_G_x_per_w_platform_z = 1.3333334_f32 * t46;
    let t143 = 0.33333334_f32 * t35;
    let t144 = u_hA * t143 + v_G_x_per_w_platform_z * t58;
    let t145 = 1.1547005_f32 * t38;
    let t146 = u_hB * t145 + t144;
    let t147 = u_hB * u_sB_per_u_hB;
    let u_sA = t146 - u_hA * t33;
    let t148 = 0.5_f32 * t146;
    let t149 = t148 + t60 - t147;
    let t150 = u_hC * t34 - t148;
    let t151 = t85 - 2.0_f32 * (t83 * t149);
    let t152 = t87 + 2.0_f32 * (t58 * t149);
    let t153 = sA * t135;
    let t154 = 2.0_f32 * (w_platform_y * u_sA) - t153;
    let t155 = t22 * (t154 - t151);
    let k19 = p.k19;
    let t156 = k19 * (w_platform_y * t58);
    let t157 = t58 * u_sA;
    let v_G_y = sA * t58 + u_hA * v_G_y_per_u_hA;
    let u_sC = t150 + 0.8660254_f32 * v_G_y;
    let t158 = t121 + 2.0_f32 * (t84 * u_sC);
    let t159 = t25 * t155;
    let t160 = t48 * (t159 + (t154 + t158));
    let t161 = t131 * u_psiC_per_w_platform_z;
    let t162 = u_psiC_per_w_platform_z * t161;
    let t163 = t98 * t61;
    let t164 = t162 + t61 * t163;
    let t165 = t61 * t99;
    let t166 = t124 - t56 * t99;
    let t167 = u_psiC_per_w_platform_z * t132;
    let t168 = t156 + (t92 * t132 + t166);
    let t169 = u_psiA_per_w_platform_z * t140;
    let t170 = t133 * u_psiA_per_w_platform_z;
    let k15 = p.k15;
    let t171 = k15 - (u_psiA_per_w_platform_z * t170 + t164);
    let t172 = t170 * t107;
    let t173 = t107 * (t133 * t107);
    let t174 = t163 * t55 - t161 * u_psiC_per_w_platform_y - t172;
    let t175 = t163 * t56;
    let t176 = t161 * t92 + t175;
    let t177 = t98 * t55;
    let t178 = t56 * (t98 * t56);
    let t179 = t56 * t177;
    let t180 = t55 * t177;
    let t181 = t92 * (t131 * t92) + t178;
    let t182 = t131 * u_psiC_per_w_platform_y;
    let t183 = t179 - t92 * t182;
    let t184 = t176 * t31 + t183;
    let t185 = t173 + (u_psiC_per_w_platform_y * t182 + t180);
    let k18 = p.k18;
    let t186 = t167 - (t165 - (t169 + (t123 - (t96 + (k18 * t137 - t117)))));
    let t187 = 2.0_f32 * t157;
    let t188 = sA * t137 + t187;
    let t189 = 0.8660254_f32 * t152;
    let t190 = 0.4330127_f32 * t188 - t189;
    let t191 = sA * t19;
    let t192 = t191 + t171;
    let M = p.M;
    let t193 = M * v_G_x_per_w_platform_z;
    let t194 = v_G_x_per_w_platform_z * t193 + t192;
    let k16 = p.k16;
    let t195 = t181 - t32 * (2.0_f32 * t176 + t32 * t194) - k16;
    let t196 = t194 * t31;
    let t197 = t32 * (t196 - t174) + t184;
    let k17 = p.k17;
    let t198 = t191 + (k17 - (t31 * (2.0_f32 * t174 - t196) + t185));
    let t199 = t142 - t197 * t155;
    let k10 = p.k10;
    let t200 = M * (1.3333334_f32 * t190) + k10 * t33;
    let t201 = M * t188 + k10 * v_G_y_per_u_hA;
    let t202 = M * t154 + k10 * v_G_z_per_u_hA;
    let t203 = sA * t201 + t186;
    let t204 = v_G_x_per_w_platform_z * t200 + t203;
    let t205 = t199 - t31 * t204;
    let t206 = t195 * t155 + t168 - t32 * t204;
    let t207 = 2.0_f32 * t197;
    let t208 = t23 * t195;
    let t209 = t207 - t208;
    let t210 = t197 - t208;
    let t211 = t23 * t209 + t198;
    let t212 = t23 * t206;
    let t213 = t205 + (t211 * t160 + t212) - sA * t202;
    let t214 = v_G_y_per_u_hA * t19;
    let t215 = t193 * t143 + t214;
    let t216 = t193 * t145;
    let t217 = t32 * t216;
    let t218 = t31 * t216;
    let t219 = t215 * t32;
    let t220 = t215 * t31;
    let t221 = t23 * t217 + t218;
    let t222 = t219 * t23 + t220;
    let t223 = t210 * w_platform_x_per_u_hB;
    let t224 = t221 - t223;
    let t225 = t223 + t222;
    let t226 = v_G_z_per_u_hA * t19 + t225;
    let t227 = w_platform_x_per_u_hB * t206;
    let t228 = t227 + t145 * t200;
    let t229 = t226 * t160 + t227;
    let FB = inputs[1];
    let t230 = FB - t217 * t155;
    let t231 = t224 * t160 + t230 - t228;
    let FA = inputs[0];
    let t232 = FA - t219 * t155 - t143 * t200 - v_G_y_per_u_hA * t201 + t229;
    let k9 = p.k9;
    let FC = inputs[2];
    let t233 = k9 - FC;
    let t234 = t231 - k9;
    let t235 = t232 - k9;
    let t236 = t211 * t50 - 2.0_f32 * t226;
    let t237 = t195 * w_platform_x_per_u_hB;
    let t238 = t237 - 2.0_f32 * t219;
    let t239 = t219 - t217 - t237;
    let t240 = t237 + 2.0_f32 * t217;
    let t241 = w_platform_x_per_u_hB * t238;
    let t242 = w_platform_x_per_u_hB * t239;
    let t243 = w_platform_x_per_u_hB * t240;
    let t244 = v_G_y_per_u_hA * (M * v_G_y_per_u_hA);
    let k11 = p.k11;
    let t245 = t241 - (k11 + (t143 * (M * t143) + t244));
    let t246 = v_G_z_per_u_hA * t202;
    let t247 = t245 - v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t50 * t236 - t247;
    let t248 = M * t145;
    let t249 = t143 * t248;
    let t250 = t243 - t145 * t248;
    let t251 = Real::min(t47, 0.21652833_f32 * Real::abs(mass_u_hA_u_hA));
    let t252 = t211 * w_platform_y_per_u_hB;
    let t253 = t50 * (t252 + t224) - t249;
    let mass_u_hA_u_hB = t226 * w_platform_y_per_u_hB - t253 - t242;
    let t254 = t211 * w_platform_y_per_u_hC;
    let mass_u_hA_u_hC = t226 * w_platform_y_per_u_hC - t50 * t254;
    let t255 = t252 + 2.0_f32 * t224;
    let t256 = t250 - k11;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * t255 - t256;
    let t257 = 1.0_f32 / mass_u_hA_u_hA;
    let t258 = t257 * mass_u_hA_u_hB;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t258;
    let mass_u_hB_u_hC = t224 * w_platform_y_per_u_hC + w_platform_y_per_u_hB * t254;
    let t259 = w_platform_y_per_u_hB * t213;
    let t260 = t50 * t213;
    let t261 = w_platform_y_per_u_hC * t213;
    let mass_u_hC_u_hC = k11 + w_platform_y_per_u_hC * t254;
    let t262 = Real::min(t251, 0.21680787_f32 * Real::abs(pivot_1));
    let t263 = mass_u_hB_u_hC - t258 * mass_u_hA_u_hC;
    let t264 = t257 * mass_u_hA_u_hC;
    let t265 = mass_u_hC_u_hC - mass_u_hA_u_hC * t264;
    let t266 = 1.0_f32 / pivot_1;
    let t267 = t266 * t263;
    let pivot_2 = t265 - t263 * t267;
    let t268 = Real::min(t262, 0.21706869_f32 * Real::abs(pivot_2));
    let c = p.c;
    let forcing_u_hB = t259 + (t234 - u_hB * c);
    let forcing_u_hA = t235 - u_hA * c - t246 - t260;
    let forcing_u_hC = t261 - (u_hC * c + t233);
    let t269 = forcing_u_hB - t258 * forcing_u_hA;
    let t270 = t257 * forcing_u_hA;
    let t271 = t266 * t269;
    let t272 = (forcing_u_hC - (t267 * t269 + t264 * forcing_u_hA)) / pivot_2;
    let t273 = t271 - t267 * t272;
    let t274 = t258 * t273;
    let t275 = t270 - (t264 * t272 + t274);
    ([u_hA, u_hB, u_hC], [t275, t273, t272], t268)
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
    let k14 = p.k14;
    let hB = q[1];
    let hC = q[2];
    let t1 = k14 * (1.7320508_f32 * (hB - hC));
    let t2 = t1 * t1;
    let hA = q[0];
    let t3 = k14 * (2.0_f32 * (0.5_f32 * (hB + hC) - hA));
    let t4 = t3 * t3;
    let t5 = t2 + t4;
    let t6 = 0.5_f32 * t5;
    let cos2 = t4 - t2;
    let t7 = t6 + cos2;
    let root = Real::sqrt(1.0_f32 + t5);
    let t8 = 1.0_f32 / (1.0_f32 + root);
    let t9 = 1.0_f32 + t7 * t8;
    let R = p.R;
    let sA = R * t9;
    let t10 = 0.8660254_f32 * (t1 * (2.0_f32 * t3));
    let sB = R * (1.0_f32 + (t2 + t10) * t8);
    let t11 = sA + 0.5_f32 * sB;
    let t12 = 0.8660254_f32 * sB;
    let t13 = 1.0_f32 / t12;
    let t14 = t13 * t11;
    let sC = R * (1.0_f32 + (t2 - t10) * t8);
    let t15 = 0.8660254_f32 * sC;
    let t16 = 1.0_f32 / (t14 * t15 + (sA + 0.5_f32 * sC));
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t13;
    let t17 = w_platform_x_per_u_hB * t15;
    let w_platform_y_per_u_hB = t16 * t17;
    let u_hB = u[1];
    let u_hA = u[0];
    let t18 = u_hB * w_platform_y_per_u_hB - u_hA * (t16 * (v_G_z_per_u_hA + t17));
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t16;
    let u_hC = u[2];
    let w_platform_y = t18 + u_hC * w_platform_y_per_u_hC;
    let t19 = 0.8660254_f32 * t1;
    let t20 = 0.5_f32 * t3;
    let u_sB_per_u_hB = (t19 + t20) * v_G_z_per_u_hA;
    let t21 = (t20 - t19) * v_G_z_per_u_hA;
    let t22 = u_sB_per_u_hB - t21;
    let t23 = 0.28867513_f32 * t22;
    let t24 = t3 * v_G_z_per_u_hA;
    let t25 = 0.8660254_f32 * t24;
    let t26 = t25 - t23;
    let t27 = 0.5_f32 * t26;
    let t28 = 1.0_f32 / (u_sB_per_u_hB * u_sB_per_u_hB - 1.0_f32);
    let t29 = t28 * t27 * w_platform_y;
    let t30 = t14 * w_platform_y;
    let t31 = (u_hA - u_hB) * w_platform_x_per_u_hB + t30;
    let t32 = t29 - t28 * (0.8660254_f32 * t26) * t31;
    let t33 = t1 * t8 * w_platform_y + t3 * t8 * t31;
    let u_psiB = t32 + v_G_z_per_u_hA * t28 * t33;
    let t34 = u_psiB * u_psiB;
    let k5 = p.k5;
    let k4 = p.k4;
    let t35 = (u_sB_per_u_hB * (k5 * u_sB_per_u_hB) - k4) * t34;
    let t36 = t23 + t25;
    let t37 = 0.5_f32 * t36;
    let t38 = 1.0_f32 / (1.0_f32 - t21 * t21);
    let u_psiC_per_w_platform_y = t38 * t37;
    let t39 = u_psiC_per_w_platform_y * w_platform_y + t38 * (0.8660254_f32 * t36) * t31;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t38;
    let u_psiC = t39 - u_psiC_per_w_platform_z * t33;
    let t40 = u_psiC * u_psiC;
    let t41 = t35 + (t21 * (k5 * t21) - k4) * t40;
    let t42 = 1.0_f32 / (1.0_f32 - t24 * t24);
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t42;
    let t43 = u_psiA_per_w_platform_z * t33;
    let v_G_y_per_u_hA = 0.57735026_f32 * t22;
    let u_psiA = v_G_y_per_u_hA * t42 * w_platform_y - t43;
    let t44 = u_psiA * u_psiA;
    let t45 = (t24 * (k5 * t24) - k4) * t44 + t41;
    let k15 = p.k15;
    let t46 = k15 * (t33 * t33) - t45;
    let v_G_y = sA * t33 + u_hA * v_G_y_per_u_hA;
    let M = p.M;
    let t47 = M * (v_G_y * v_G_y) + t46;
    let v_G_x_per_w_platform_z = 1.3333334_f32 * (0.4330127_f32 * sA + t12);
    let t48 = v_G_x_per_w_platform_z * t33;
    let t49 = u_hA * (0.33333334_f32 * t22) + t48;
    let t50 = u_hB * (1.1547005_f32 * t26) + t49;
    let t51 = M * (t50 * t50) + t47;
    let k16 = p.k16;
    let t52 = k16 * (t31 * t31) + t51;
    let k17 = p.k17;
    let t53 = k17 * (w_platform_y * w_platform_y) + t52;
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t54 = M * (v_G_z * v_G_z);
    let k11 = p.k11;
    let t55 = t53 + (k11 * (u_hB * u_hB) + t54);
    let t56 = 0.5_f32 * (k11 * (u_hA * u_hA) + k11 * (u_hC * u_hC) + t55);
    let k12 = p.k12;
    let t57 = t24 * (k12 * t9);
    let g = p.g;
    let k7 = p.k7;
    let k9 = p.k9;
    let k8 = p.k8;
    let t58 = M * (hA * g + t57) + (hB * k7 + hA * k9 + (hB * k8 + hC * k9));
    (t56, t58)
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
    let k14 = p.k14;
    let hB = q[1];
    let hC = q[2];
    let t1 = k14 * (1.7320508_f32 * (hB - hC));
    let t2 = t1 * t1;
    let hA = q[0];
    let t3 = k14 * (2.0_f32 * (0.5_f32 * (hB + hC) - hA));
    let t4 = t3 * t3;
    let t5 = t2 + t4;
    let t6 = 0.5_f32 * t5;
    let cos2 = t4 - t2;
    let t7 = t6 + cos2;
    let root = Real::sqrt(1.0_f32 + t5);
    let t8 = 1.0_f32 / (1.0_f32 + root);
    let R = p.R;
    let sA = R * (1.0_f32 + t7 * t8);
    let t9 = 0.8660254_f32 * (t1 * (2.0_f32 * t3));
    let sB = R * (1.0_f32 + (t2 + t9) * t8);
    let t10 = sA + 0.5_f32 * sB;
    let t11 = 0.8660254_f32 * sB;
    let t12 = 1.0_f32 / t11;
    let t13 = t12 * t10;
    let sC = R * (1.0_f32 + (t2 - t9) * t8);
    let t14 = 0.8660254_f32 * sC;
    let t15 = 1.0_f32 / (t13 * t14 + (sA + 0.5_f32 * sC));
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t12;
    let t16 = w_platform_x_per_u_hB * t14;
    let w_platform_y_per_u_hB = t15 * t16;
    let u_hB = u[1];
    let u_hA = u[0];
    let t17 = u_hB * w_platform_y_per_u_hB - u_hA * (t15 * (v_G_z_per_u_hA + t16));
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t15;
    let u_hC = u[2];
    let w_platform_y = t17 + u_hC * w_platform_y_per_u_hC;
    let t18 = t1 * t8;
    let t19 = t18 * w_platform_y;
    let t20 = t13 * w_platform_y;
    let t21 = (u_hA - u_hB) * w_platform_x_per_u_hB + t20;
    let t22 = t3 * t8;
    let t23 = t19 + t22 * t21;
    let t24 = t3 * v_G_z_per_u_hA;
    let t25 = 1.0_f32 - t24 * t24;
    let t26 = 1.0_f32 / t25;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t26;
    let t27 = u_psiA_per_w_platform_z * t23;
    let t28 = 0.8660254_f32 * t1;
    let t29 = 0.5_f32 * t3;
    let u_sB_per_u_hB = (t28 + t29) * v_G_z_per_u_hA;
    let t30 = (t29 - t28) * v_G_z_per_u_hA;
    let t31 = u_sB_per_u_hB - t30;
    let v_G_y_per_u_hA = 0.57735026_f32 * t31;
    let u_psiA = v_G_y_per_u_hA * t26 * w_platform_y - t27;
    let t32 = 1.0_f32 / Real::sqrt(t25);
    let t33 = t23 * (v_G_y_per_u_hA * t32);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t32;
    let u_thA = t33 + w_platform_y * u_thA_per_w_platform_y;
    let v_G_x_per_w_platform_z = 1.3333334_f32 * (0.4330127_f32 * sA + t11);
    let t34 = v_G_x_per_w_platform_z * t23;
    let t35 = u_hA * (0.33333334_f32 * t31) + t34;
    let t36 = 0.28867513_f32 * t31;
    let t37 = 0.8660254_f32 * t24;
    let t38 = t37 - t36;
    let t39 = u_hB * (1.1547005_f32 * t38) + t35;
    let u_sA = t39 - u_hA * t24;
    let t40 = 0.5_f32 * t38;
    let t41 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t42 = 1.0_f32 / (t41 - 1.0_f32);
    let u_psiB = t42 * t40 * w_platform_y - t42 * (0.8660254_f32 * t38) * t21 + v_G_z_per_u_hA * t42 * t23;
    let t43 = 1.0_f32 / Real::sqrt(1.0_f32 - t41);
    let t44 = t23 * (t38 * t43);
    let t45 = 0.5_f32 * v_G_z_per_u_hA;
    let t46 = w_platform_y * (t45 * t43);
    let t47 = 0.8660254_f32 * v_G_z_per_u_hA;
    let u_thB = t44 - (t46 - t21 * (t47 * t43));
    let t48 = 0.5_f32 * t39;
    let u_sB_per_w_platform_z = 0.8660254_f32 * sA;
    let t49 = t23 * u_sB_per_w_platform_z;
    let t50 = t48 + (u_hA * (0.5_f32 * t31) + t49);
    let t51 = u_hB * u_sB_per_u_hB - t50;
    let t52 = t36 + t37;
    let t53 = 0.5_f32 * t52;
    let t54 = 1.0_f32 - t30 * t30;
    let t55 = 1.0_f32 / t54;
    let u_psiC_per_w_platform_y = t55 * t53;
    let t56 = u_psiC_per_w_platform_y * w_platform_y + t55 * (0.8660254_f32 * t52) * t21;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t55;
    let u_psiC = t56 - u_psiC_per_w_platform_z * t23;
    let t57 = 1.0_f32 / Real::sqrt(t54);
    let u_thC_per_w_platform_z = t52 * t57;
    let t58 = t23 * u_thC_per_w_platform_z;
    let t59 = w_platform_y * (t57 * t45) + t58;
    let u_thC_per_w_platform_x = t57 * t47;
    let t60 = t21 * u_thC_per_w_platform_x + t59;
    let t61 = u_hC * t30 - t48;
    let v_G_y = sA * t23 + u_hA * v_G_y_per_u_hA;
    let u_sC = t61 + 0.8660254_f32 * v_G_y;
    let u_root = w_platform_y * (t3 * root) - t21 * (t1 * root);
    let t62 = t22 * u_root;
    let u_slope_x = root * w_platform_y + t62;
    let t63 = t18 * u_root;
    let u_slope_y = root * t21 - t63;
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, t51, u_hC, u_psiC, -t60, u_sC, u_slope_x, u_slope_y, u_root]
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
    let k14 = p.k14;
    let hB = q[1];
    let hC = q[2];
    let t1 = k14 * (1.7320508_f32 * (hB - hC));
    let t2 = t1 * t1;
    let hA = q[0];
    let t3 = k14 * (2.0_f32 * (0.5_f32 * (hB + hC) - hA));
    let t4 = t3 * t3;
    let t5 = t2 + t4;
    let root = Real::sqrt(1.0_f32 + t5);
    let t6 = 1.0_f32 + root;
    let k = 1.0_f32 / (root * t6);
    let psiA = Real::atan2(t1 * (t3 * k), 1.0_f32 - t4 * k);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let t7 = t3 * v_G_z_per_u_hA;
    let t8 = Real::sqrt(1.0_f32 - t7 * t7);
    let t9 = t8 * sin_psiA;
    let t10 = 0.5_f32 * t5;
    let cos2 = t4 - t2;
    let t11 = t10 + cos2;
    let t12 = 1.0_f32 / t6;
    let R = p.R;
    let sA = R * (1.0_f32 + t11 * t12);
    let t13 = sA * t9;
    let t14 = R - sA * (t8 * cos_psiA);
    let t15 = hA + sA * t7;
    let thA = Real::asin(t7);
    let t16 = 0.8660254_f32 * t1;
    let t17 = 0.5_f32 * t3;
    let t18 = t16 + t17;
    let t19 = t18 * k;
    let t20 = 0.8660254_f32 * t3;
    let t21 = 0.5_f32 * t1;
    let psiB = Real::atan2(-(t20 - t21) * t19, 1.0_f32 - t18 * t18 * k);
    let u_sB_per_u_hB = t18 * v_G_z_per_u_hA;
    let t22 = Real::asin(u_sB_per_u_hB);
    let t23 = 0.8660254_f32 * (t1 * (2.0_f32 * t3));
    let sB = R * (1.0_f32 + (t2 + t23) * t12);
    let t24 = t17 - t16;
    let t25 = t24 * k;
    let acrossC = t20 + t21;
    let psiC = Real::atan2(acrossC * t25, 1.0_f32 - t24 * t24 * k);
    let t26 = Real::asin(t24 * v_G_z_per_u_hA);
    let sC = R * (1.0_f32 + (t2 - t23) * t12);
    [t13, t14, t15, psiA, thA, sA, psiB, -t22, sB, psiC, -t26, sC]
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
    ([], 0.0_f32)
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
