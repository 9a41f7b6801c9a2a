// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 724 operations (12 abs, 133 add, 5 cos, 12 div, 11 min, 427 mul, 5 sin, 119 sub).
// Cost of energy: 218 operations (48 add, 5 cos, 9 div, 136 mul, 5 sin, 15 sub).
// Cost of speeds: 151 operations (21 add, 5 cos, 9 div, 94 mul, 5 sin, 17 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 393 operations (9 abs, 79 add, 6 cos, 10 div, 8 max, 212 mul, 6 sin, 1 sqrt, 62 sub).

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f32;
/// Number of coordinates q.
pub const NQ: usize = 12usize;
/// Number of independent speeds u.
pub const NU: usize = 3usize;
/// Number of inputs.
pub const N_INPUTS: usize = 3usize;
///Coordinates in order.
pub const Q_NAMES: [&str; 12usize] = [
    "hA",
    "psiA",
    "thA",
    "sA",
    "hB",
    "psiB",
    "thB",
    "sB",
    "hC",
    "psiC",
    "thC",
    "sC",
];
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
pub const SPEED_NAMES: [&str; 12usize] = [
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
];
///Outputs in order.
pub const OUTPUT_NAMES: [&str; 3usize] = ["Gx", "Gy", "Gz"];
/// Indices of the coordinates that the projection corrects.
pub const CORRECTED: [usize; 9usize] = [
    1usize, 2usize, 3usize, 5usize, 6usize, 7usize, 9usize, 10usize, 11usize,
];
/// Coordinates read only by sines and cosines: they may be wrapped by whole turns.
pub const IS_ANGLE: [bool; 12usize] = [
    false, true, true, false, false, true, true, false, false, true, true, false,
];
/// The nominal configuration.
pub const NOMINAL: [f32; 12usize] = [
    0f32,
    0f32,
    0f32,
    0.2f32,
    0f32,
    0f32,
    0f32,
    0.2f32,
    0f32,
    0f32,
    0f32,
    0.2f32,
];
/// Tunable parameters, SI units.
#[derive(Clone, Copy, Debug)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Parameters {
    ///Radius of the circle of screws (m), models/tile.toml:11.
    pub R: S,
    ///Mass that moves with a screw (kg), models/tile.toml:12.
    pub ms: S,
    ///Inertia of motor, worm and screw reflected on the height; has no weight (kg), models/tile.toml:13.
    pub mr: S,
    ///Mass of a connector (kg), models/tile.toml:14.
    pub mc: S,
    ///Connector about its rod (kg m^2), models/tile.toml:15.
    pub Ic1: S,
    ///Connector about its horizontal axis (kg m^2), models/tile.toml:16.
    pub Ic2: S,
    ///Connector about its third axis (kg m^2), models/tile.toml:17.
    pub Ic3: S,
    ///Mass of the platform (kg), models/tile.toml:18.
    pub M: S,
    ///Platform about rod A (kg m^2), models/tile.toml:19.
    pub Ix: S,
    ///Platform across rod A (kg m^2), models/tile.toml:20.
    pub Iy: S,
    ///Platform about its normal (kg m^2), models/tile.toml:21.
    pub Iz: S,
    ///Viscous friction of a screw (N s/m), models/tile.toml:22.
    pub c: S,
    ///Gravity (m/s^2), models/tile.toml:23.
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
///724 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn rates(
    _t: S,
    q: &[S; 12usize],
    u: &[S; 3usize],
    inputs: &[S; 3usize],
    p: &Parameters,
) -> ([S; 12usize], [S; 3usize], S) {
    let u_hA = u[0];
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t1 = 2.0_f32 * (sA + (sB + sC));
    let t2 = 1.0_f32 / t1;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t3 = sin_thB - sin_thC;
    let t4 = t2 * (1.1547005_f32 * t3);
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t5 = 1.7320508_f32 * sin_thA;
    let t6 = 0.57735026_f32 * t3;
    let t7 = t5 + t6;
    let t8 = t2 * t7;
    let u_hC = u[2];
    let t9 = t2 * (t5 - t6);
    let t10 = u_hA * t4 - u_hB * t8 + u_hC * t9;
    let t11 = cos_thA * cos_thA;
    let t12 = 1.0_f32 / t11;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t13 = cos_thA * sin_psiA;
    let t14 = cos_thA * cos_psiA;
    let t15 = cos_psiB * (0.5_f32 * t13 + 0.8660254_f32 * t14) + sin_psiB * (0.8660254_f32 * t13 - 0.5_f32 * t14);
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t15);
    let u_psiA_per_w_platform_z = t12 * v_G_z_per_u_hA;
    let t16 = 0.8660254_f32 * sC;
    let t17 = 0.8660254_f32 * sB;
    let t18 = 1.0_f32 / t17;
    let t19 = (sA + 0.5_f32 * sB) * t18;
    let t20 = sA + 0.5_f32 * sC + t16 * t19;
    let t21 = 1.0_f32 / t20;
    let w_platform_x_per_u_hB = t18 * v_G_z_per_u_hA;
    let t22 = t16 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t21 * t22;
    let t23 = t21 * (v_G_z_per_u_hA + t22);
    let w_platform_y_per_u_hC = t21 * v_G_z_per_u_hA;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * t23 + u_hC * w_platform_y_per_u_hC;
    let t24 = t12 * t6;
    let t25 = t10 * u_psiA_per_w_platform_z + w_platform_y * t24;
    let t26 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t26 * v_G_z_per_u_hA;
    let t27 = t26 * t6;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t10 * t27;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t28 = 0.57735026_f32 * t7;
    let v_G_y = sA * t10 - u_hA * t6;
    let t29 = v_G_x_per_w_platform_z * t10 + u_hB * t28 + 0.57735026_f32 * v_G_y;
    let u_sA = t29 - u_hA * sin_thA;
    let t30 = w_platform_x_per_u_hB * (u_hA - u_hB) + t19 * w_platform_y;
    let t31 = cos_thB * cos_thB;
    let t32 = 1.0_f32 / t31;
    let t33 = 0.8660254_f32 * sin_thA;
    let t34 = 0.28867513_f32 * t3;
    let t35 = t33 + t34;
    let t36 = t32 * (0.8660254_f32 * t35);
    let t37 = t32 * (0.5_f32 * t35);
    let u_psiB_per_w_platform_z = t32 * v_G_z_per_u_hA;
    let u_psiB = t30 * t36 - w_platform_y * t37 - t10 * u_psiB_per_w_platform_z;
    let t38 = 1.0_f32 / cos_thB;
    let t39 = 0.5_f32 * v_G_z_per_u_hA;
    let t40 = t38 * t39;
    let t41 = t38 * t35;
    let u_thB = t15 * t30 - w_platform_y * t40 + t10 * t41;
    let u_sB_per_u_hB = 2.0_f32 * sin_thA;
    let t42 = 2.0_f32 * t29;
    let u_sB = u_hB * u_sB_per_u_hB + 1.7320508_f32 * sB * t10 - t42;
    let t43 = cos_thC * cos_thC;
    let t44 = 1.0_f32 / t43;
    let t45 = t33 - t34;
    let u_psiC_per_w_platform_y = t44 * (0.5_f32 * t45);
    let t46 = t44 * (0.8660254_f32 * t45);
    let u_psiC_per_w_platform_z = t44 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t30 * t46 - t10 * u_psiC_per_w_platform_z;
    let t47 = 1.0_f32 / cos_thC;
    let t48 = t47 * t39;
    let t49 = 0.8660254_f32 * v_G_z_per_u_hA;
    let u_thC_per_w_platform_x = t47 * t49;
    let u_thC_per_w_platform_z = t47 * t45;
    let t50 = w_platform_y * t48 + t30 * u_thC_per_w_platform_x + t10 * u_thC_per_w_platform_z;
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let u_sC = u_hC * u_sB_per_u_hB - u_sC_per_w_platform_z * t10 - t42;
    let Ic3 = p.Ic3;
    let Ic1 = p.Ic1;
    let Ic2 = p.Ic2;
    let t51 = 0.5_f32 * (Ic1 + Ic2 - Ic3);
    let t52 = 0.5_f32 * (Ic1 - (Ic2 + Ic3));
    let t53 = t51 + t52;
    let t54 = Ic3 + sin_thC * (sin_thC * t53);
    let t55 = u_psiC_per_w_platform_z * t54;
    let t56 = Ic3 + sin_thB * (sin_thB * t53);
    let t57 = u_psiB_per_w_platform_z * t56;
    let t58 = Ic2 * u_thC_per_w_platform_z;
    let t59 = Ic2 * t41;
    let t60 = t46 * t55 + (t36 * t57 - (u_thC_per_w_platform_x * t58 + t15 * t59));
    let t61 = t4 * t60;
    let M = p.M;
    let t62 = sA * M;
    let t63 = Ic3 + sin_thA * (sin_thA * t53);
    let t64 = u_psiA_per_w_platform_z * t63;
    let t65 = Ic2 * t27;
    let t66 = t37 * t57 + (t24 * t64 - (t40 * t59 + u_thA_per_w_platform_y * t65 - t48 * t58));
    let t67 = u_psiC_per_w_platform_y * t55 - t66;
    let t68 = t37 * t56;
    let t69 = Ic2 * t40;
    let t70 = Ic2 * t48;
    let t71 = u_psiC_per_w_platform_y * t54;
    let t72 = t36 * t68 + (t15 * t69 - u_thC_per_w_platform_x * t70) - t46 * t71;
    let Ix = p.Ix;
    let t73 = t36 * (t36 * t56) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t15 * (Ic2 * t15)));
    let t74 = t46 * (t46 * t54) + t73;
    let t75 = t19 * t74;
    let t76 = w_platform_x_per_u_hB * (t72 - t75);
    let t77 = t19 * t61 - (t62 * v_G_z_per_u_hA - t4 * t67 - t76);
    let Iy = p.Iy;
    let t78 = t24 * (t24 * t63) + (t48 * t70 + (t40 * t69 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t79 = t19 * (2.0_f32 * t72 - t75) - (sA * t62 + (u_psiC_per_w_platform_y * t71 + (t37 * t68 + t78)));
    let t80 = w_platform_x_per_u_hB * t74;
    let t81 = 1.3333334_f32 * M;
    let t82 = sA * t81;
    let t83 = 0.57735026_f32 * M;
    let t84 = v_G_x_per_w_platform_z * t83;
    let t85 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t86 = u_psiB_per_w_platform_z * t57 + (u_psiA_per_w_platform_z * t64 + (u_thC_per_w_platform_z * t58 + (t41 * t59 + (Iz + t27 * t65))));
    let t87 = sA * (t82 + 2.0_f32 * t84) + (v_G_x_per_w_platform_z * t85 + (u_psiC_per_w_platform_z * t55 + t86));
    let t88 = (t84 + t82) * t6;
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t89 = ms + mc;
    let t90 = mr + t89;
    let t91 = t4 * (t4 * t87 - 2.0_f32 * t88) + (t90 + t6 * (t81 * t6)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t23 * (2.0_f32 * t77 - t23 * t79) + (w_platform_x_per_u_hB * (t80 - 2.0_f32 * t61) + t91);
    let t92 = 1.0_f32 / mass_u_hA_u_hA;
    let t93 = t10 * t30;
    let v_G_z_dot_bias = 2.0_f32 * (w_platform_y * u_sA) - sA * t93;
    let t94 = 0.8660254_f32 * t10;
    let t95 = w_platform_y * t94;
    let t96 = 0.5_f32 * t10;
    let t97 = t30 * t96;
    let t98 = t95 + t97;
    let t99 = 0.5_f32 * w_platform_y;
    let t100 = 0.8660254_f32 * t30;
    let t101 = t99 - t100;
    let t102 = t18 * (v_G_z_dot_bias - (sB * t98 - 2.0_f32 * (u_sB * t101)));
    let t103 = t95 - t97;
    let t104 = t99 + t100;
    let t105 = t21 * (t16 * t102 + (v_G_z_dot_bias + (sC * t103 + 2.0_f32 * (u_sC * t104))));
    let t106 = t10 * t96;
    let t107 = t106 + w_platform_y * t101;
    let t108 = t10 * t94;
    let t109 = t108 - t30 * t101;
    let t110 = 1.7320508_f32 * (sB * t107 + 2.0_f32 * (u_sB * t94)) + (2.0_f32 * (u_sB * t96) - sB * t109);
    let t111 = t108 + t30 * t104;
    let t112 = t106 + w_platform_y * t104;
    let t113 = w_platform_y * t30;
    let t114 = sA * t113 + 2.0_f32 * (t10 * u_sA);
    let t115 = t110 + sC * t111 + 1.7320508_f32 * (2.0_f32 * (u_sC * t94) - sC * t112) + 2.0_f32 * (u_sC * t96 + t114);
    let t116 = t2 * t115;
    let t117 = 2.0_f32 * (u_psiC * t50);
    let t118 = sin_thC * t117;
    let u_psiC_dot_bias = t44 * (t45 * t103 - (t39 * t111 - t49 * t112) - cos_thC * t118);
    let t119 = t54 * u_psiC_dot_bias - (sin_thC * (t51 * (cos_thC * t117)) + cos_thC * (t52 * t118));
    let t120 = 2.0_f32 * u_thB;
    let t121 = sin_thB * u_psiB;
    let t122 = t120 * t121;
    let t123 = t56 * (t32 * (t39 * t109 - t49 * t107 + t35 * t98 + cos_thB * t122));
    let t124 = cos_thB * u_psiB;
    let t125 = t123 + (sin_thB * (t51 * (t120 * t124)) + cos_thB * (t52 * t122));
    let t126 = cos_thC * u_psiC;
    let t127 = sin_thC * u_psiC * t126;
    let t128 = v_G_z_per_u_hA * t103 - (t6 * t111 + sin_thA * t112) - (sin_thC * (t126 * t126 + t50 * t50) - cos_thC * t127);
    let t129 = Ic2 * (t47 * t128) + t53 * t127;
    let t130 = t121 * t124;
    let t131 = sin_thB * (t124 * t124 + u_thB * u_thB) - cos_thB * t130 - (t6 * t109 - sin_thA * t107 - v_G_z_per_u_hA * t98);
    let t132 = t53 * t130 - Ic2 * (t38 * t131);
    let t133 = t36 * t125 + (u_thC_per_w_platform_x * t129 + ((Iz - Iy) * (t10 * w_platform_y) - t15 * t132));
    let t134 = t74 * t102 + (t60 * t116 + (t46 * t119 + t133));
    let g = p.g;
    let t135 = M * (v_G_z_dot_bias + g * v_G_z_per_u_hA);
    let t136 = t25 * u_thA;
    let t137 = u_sB_per_u_hB * t136;
    let t138 = t63 * (t12 * (v_G_z_per_u_hA * t113 - t6 * t93 + cos_thA * t137)) + (sin_thA * (t51 * (cos_thA * (2.0_f32 * t136))) + cos_thA * (t52 * t137));
    let t139 = cos_thA * t25;
    let t140 = sin_thA * t25 * t139;
    let t141 = v_G_z_per_u_hA * t93 + cos_thA * t140 + t6 * t113 + sin_thA * (t10 * t10 + w_platform_y * w_platform_y - (t139 * t139 + u_thA * u_thA));
    let t142 = Ic2 * (t26 * t141) + t53 * t140;
    let t143 = t24 * t138 + (t48 * t129 + (t40 * t132 + ((Ix - Iz) * t93 - u_thA_per_w_platform_y * t142)));
    let t144 = t72 * t102 - (sA * t135 + (t67 * t116 + (u_psiC_per_w_platform_y * t119 - (t37 * t125 - t143))));
    let t145 = t79 * t105 + (t19 * t134 - t144);
    let t146 = M * (g * sin_thA + 0.57735026_f32 * t110);
    let t147 = t81 * t114 + (0.57735026_f32 * t146 - M * (g * t6));
    let t148 = u_psiA_per_w_platform_z * t138 - (t41 * t132 - (t27 * t142 + (Iy - Ix) * t113) - u_thC_per_w_platform_z * t129);
    let t149 = sA * t147 + (t84 * t114 - (u_psiC_per_w_platform_z * t119 + (u_psiB_per_w_platform_z * t125 - t148) - v_G_x_per_w_platform_z * t146));
    let t150 = t149 - t87 * t116;
    let t151 = g * t89;
    let c = p.c;
    let FA = inputs[0];
    let t152 = t4 * t150 + (t88 * t116 + (t151 + (u_hA * c - FA) - t6 * t147));
    let t153 = w_platform_x_per_u_hB * t134;
    let forcing_u_hA = t23 * t145 - (t77 * t105 - (t61 * t102 - (v_G_z_per_u_hA * t135 + t152) - t153));
    let t154 = w_platform_y_per_u_hB * t79;
    let t155 = t8 * t60;
    let t156 = t19 * t155 + (t76 + t8 * t67);
    let t157 = t83 * t28;
    let t158 = sA * t157 + t85 * t28;
    let t159 = t8 * t87;
    let t160 = t23 * (t154 - t156) + (t8 * t88 - (t6 * t157 - t4 * (t158 - t159)));
    let t161 = w_platform_y_per_u_hB * t77 - t160 + w_platform_x_per_u_hB * (t80 - t155 - t61);
    let t162 = t92 * t161;
    let t163 = w_platform_x_per_u_hB * (2.0_f32 * t155 - t80) - (t90 + t28 * (M * t28) - t8 * (2.0_f32 * t158 - t159));
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (2.0_f32 * t156 - t154) - t163;
    let pivot_1 = mass_u_hB_u_hB - t161 * t162;
    let t164 = 1.0_f32 / pivot_1;
    let t165 = w_platform_y_per_u_hC * t79;
    let t166 = t9 * t60;
    let t167 = t19 * t166 + t9 * t67;
    let t168 = t165 + t167;
    let t169 = w_platform_x_per_u_hB * t166;
    let t170 = t9 * t87;
    let mass_u_hA_u_hC = t23 * t168 - (t169 - (t4 * t170 - t9 * t88)) - w_platform_y_per_u_hC * t77;
    let mass_u_hB_u_hC = w_platform_y_per_u_hC * t156 + (t169 + (t9 * t158 - t8 * t170) - w_platform_y_per_u_hB * t168);
    let t171 = t162 * mass_u_hA_u_hC + mass_u_hB_u_hC;
    let t172 = t164 * t171;
    let FB = inputs[1];
    let t173 = t157 * t114 + (t28 * t146 + (t151 + (u_hB * c - FB))) - t158 * t116;
    let t174 = w_platform_y_per_u_hB * t145 + (t155 * t102 + (t173 - t8 * t150) - t153 - t156 * t105);
    let t175 = t174 - t162 * forcing_u_hA;
    let t176 = t92 * mass_u_hA_u_hC;
    let FC = inputs[2];
    let t177 = t166 * t102 - (t9 * t150 - (FC - u_hC * c - t151)) - t167 * t105;
    let forcing_u_hC = t177 - w_platform_y_per_u_hC * t145;
    let mass_u_hC_u_hC = t90 + t9 * t170 - w_platform_y_per_u_hC * (t165 + 2.0_f32 * t167);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t176 - t171 * t172;
    let t178 = (t172 * t175 - (t176 * forcing_u_hA - forcing_u_hC)) / pivot_2;
    let t179 = t172 * t178 + t164 * t175;
    let t180 = t92 * forcing_u_hA - t162 * t179 - t176 * t178;
    let t181 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t11)), Real::abs(t31));
    let t182 = Real::min(Real::min(Real::min(Real::min(t181, Real::abs(t43)), 0.8333333_f32 * Real::abs(t1)), 5.773503_f32 * Real::abs(t17)), 1.6666666_f32 * Real::abs(t20));
    let t183 = Real::min(Real::min(Real::min(t182, 0.21652833_f32 * Real::abs(mass_u_hA_u_hA)), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, -t25, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, -t50, u_sC], [t180, -t179, t178], t183)
}
///Kinetic and potential energy (J).
///
///218 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn energy(
    _t: S,
    q: &[S; 12usize],
    u: &[S; 3usize],
    _inputs: &[S; 3usize],
    p: &Parameters,
) -> (S, S) {
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t1 = ms + mc;
    let t2 = mr + t1;
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let Ic3 = p.Ic3;
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let Ic1 = p.Ic1;
    let Ic2 = p.Ic2;
    let t3 = 0.5_f32 * (Ic1 + Ic2 - Ic3) + 0.5_f32 * (Ic1 - (Ic2 + Ic3));
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t4 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC)));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t5 = sin_thB - sin_thC;
    let t6 = 1.7320508_f32 * sin_thA;
    let t7 = 0.57735026_f32 * t5;
    let t8 = t6 + t7;
    let t9 = u_hA * (t4 * (1.1547005_f32 * t5)) - u_hB * (t4 * t8) + u_hC * (t4 * (t6 - t7));
    let t10 = 1.0_f32 / (cos_thA * cos_thA);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t11 = cos_thA * sin_psiA;
    let t12 = cos_thA * cos_psiA;
    let t13 = cos_psiB * (0.5_f32 * t11 + 0.8660254_f32 * t12) + sin_psiB * (0.8660254_f32 * t11 - 0.5_f32 * t12);
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t13);
    let u_psiA_per_w_platform_z = t10 * v_G_z_per_u_hA;
    let t14 = 0.8660254_f32 * sC;
    let t15 = 1.0_f32 / (0.8660254_f32 * sB);
    let t16 = (sA + 0.5_f32 * sB) * t15;
    let t17 = 1.0_f32 / (sA + 0.5_f32 * sC + t14 * t16);
    let w_platform_x_per_u_hB = t15 * v_G_z_per_u_hA;
    let t18 = t14 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t17 * t18;
    let w_platform_y_per_u_hC = t17 * v_G_z_per_u_hA;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * (t17 * (v_G_z_per_u_hA + t18)) + u_hC * w_platform_y_per_u_hC;
    let t19 = t9 * u_psiA_per_w_platform_z + w_platform_y * (t10 * t7);
    let t20 = t2 * (u_hA * u_hA) + (t2 * (u_hB * u_hB) + t2 * (u_hC * u_hC)) + (Ic3 + sin_thA * (sin_thA * t3)) * (t19 * t19);
    let t21 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t21 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t9 * (t21 * t7);
    let t22 = w_platform_x_per_u_hB * (u_hA - u_hB) + t16 * w_platform_y;
    let t23 = 1.0_f32 / (cos_thB * cos_thB);
    let t24 = 0.8660254_f32 * sin_thA;
    let t25 = 0.28867513_f32 * t5;
    let t26 = t24 + t25;
    let u_psiB_per_w_platform_z = t23 * v_G_z_per_u_hA;
    let u_psiB = t22 * (t23 * (0.8660254_f32 * t26)) - w_platform_y * (t23 * (0.5_f32 * t26)) - t9 * u_psiB_per_w_platform_z;
    let t27 = t20 + Ic2 * (u_thA * u_thA) + (Ic3 + sin_thB * (sin_thB * t3)) * (u_psiB * u_psiB);
    let t28 = 1.0_f32 / cos_thB;
    let t29 = 0.5_f32 * v_G_z_per_u_hA;
    let u_thB = t13 * t22 - w_platform_y * (t28 * t29) + t9 * (t28 * t26);
    let t30 = 1.0_f32 / (cos_thC * cos_thC);
    let t31 = t24 - t25;
    let u_psiC_per_w_platform_y = t30 * (0.5_f32 * t31);
    let u_psiC_per_w_platform_z = t30 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t22 * (t30 * (0.8660254_f32 * t31)) - t9 * u_psiC_per_w_platform_z;
    let t32 = t27 + Ic2 * (u_thB * u_thB) + (Ic3 + sin_thC * (sin_thC * t3)) * (u_psiC * u_psiC);
    let t33 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_x = t33 * (0.8660254_f32 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t33 * t31;
    let t34 = w_platform_y * (t33 * t29) + t22 * u_thC_per_w_platform_x + t9 * u_thC_per_w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t35 = t32 + Ic2 * (t34 * t34) + Ix * (t22 * t22) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_y = sA * t9 - u_hA * t7;
    let t36 = v_G_x_per_w_platform_z * t9 + u_hB * (0.57735026_f32 * t8) + 0.57735026_f32 * v_G_y;
    let t37 = t35 + Iz * (t9 * t9) + M * (t36 * t36) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t38 = 0.5_f32 * (t37 + M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t39 = hA * g;
    let hB = q[4];
    let t40 = hB * g;
    let t41 = M * (t39 + sA * (g * sin_thA)) + (mc * t40 + (ms * t40 + t1 * t39));
    let hC = q[8];
    let t42 = t41 + t1 * (hC * g);
    (t38, t42)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///151 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn speeds(
    _t: S,
    q: &[S; 12usize],
    u: &[S; 3usize],
    _inputs: &[S; 3usize],
    _p: &Parameters,
) -> [S; 12usize] {
    let u_hA = u[0];
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t1 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC)));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t3 = 1.7320508_f32 * sin_thA;
    let t4 = 0.57735026_f32 * t2;
    let t5 = t3 + t4;
    let u_hC = u[2];
    let t6 = u_hA * (t1 * (1.1547005_f32 * t2)) - u_hB * (t1 * t5) + u_hC * (t1 * (t3 - t4));
    let t7 = 1.0_f32 / (cos_thA * cos_thA);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t8 = cos_thA * sin_psiA;
    let t9 = cos_thA * cos_psiA;
    let t10 = cos_psiB * (0.5_f32 * t8 + 0.8660254_f32 * t9) + sin_psiB * (0.8660254_f32 * t8 - 0.5_f32 * t9);
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t10);
    let u_psiA_per_w_platform_z = t7 * v_G_z_per_u_hA;
    let t11 = 0.8660254_f32 * sC;
    let t12 = 1.0_f32 / (0.8660254_f32 * sB);
    let t13 = (sA + 0.5_f32 * sB) * t12;
    let t14 = 1.0_f32 / (sA + 0.5_f32 * sC + t11 * t13);
    let w_platform_x_per_u_hB = t12 * v_G_z_per_u_hA;
    let t15 = t11 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t14 * t15;
    let w_platform_y_per_u_hC = t14 * v_G_z_per_u_hA;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * (t14 * (v_G_z_per_u_hA + t15)) + u_hC * w_platform_y_per_u_hC;
    let t16 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t16 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t6 * (t16 * t4);
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_y = sA * t6 - u_hA * t4;
    let t17 = v_G_x_per_w_platform_z * t6 + u_hB * (0.57735026_f32 * t5) + 0.57735026_f32 * v_G_y;
    let u_sA = t17 - u_hA * sin_thA;
    let t18 = w_platform_x_per_u_hB * (u_hA - u_hB) + t13 * w_platform_y;
    let t19 = 1.0_f32 / (cos_thB * cos_thB);
    let t20 = 0.8660254_f32 * sin_thA;
    let t21 = 0.28867513_f32 * t2;
    let t22 = t20 + t21;
    let u_psiB_per_w_platform_z = t19 * v_G_z_per_u_hA;
    let u_psiB = t18 * (t19 * (0.8660254_f32 * t22)) - w_platform_y * (t19 * (0.5_f32 * t22)) - t6 * u_psiB_per_w_platform_z;
    let t23 = 1.0_f32 / cos_thB;
    let t24 = 0.5_f32 * v_G_z_per_u_hA;
    let u_thB = t10 * t18 - w_platform_y * (t23 * t24) + t6 * (t23 * t22);
    let u_sB_per_u_hB = 2.0_f32 * sin_thA;
    let t25 = 2.0_f32 * t17;
    let u_sB = u_hB * u_sB_per_u_hB + 1.7320508_f32 * sB * t6 - t25;
    let t26 = 1.0_f32 / (cos_thC * cos_thC);
    let t27 = t20 - t21;
    let u_psiC_per_w_platform_y = t26 * (0.5_f32 * t27);
    let u_psiC_per_w_platform_z = t26 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t18 * (t26 * (0.8660254_f32 * t27)) - t6 * u_psiC_per_w_platform_z;
    let t28 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_x = t28 * (0.8660254_f32 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t28 * t27;
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let u_sC = u_hC * u_sB_per_u_hB - u_sC_per_w_platform_z * t6 - t25;
    [u_hA, -(t6 * u_psiA_per_w_platform_z + w_platform_y * (t7 * t4)), u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, -(w_platform_y * (t28 * t24) + t18 * u_thC_per_w_platform_x + t6 * u_thC_per_w_platform_z), u_sC]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///10 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn outputs(
    _t: S,
    q: &[S; 12usize],
    _u: &[S; 3usize],
    _inputs: &[S; 3usize],
    p: &Parameters,
) -> [S; 3usize] {
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let sA = q[3];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t1 = sA * cos_thA;
    let t2 = sin_psiA * t1;
    let R = p.R;
    let t3 = R - cos_psiA * t1;
    let hA = q[0];
    let t4 = hA + sA * sin_thA;
    [t2, t3, t4]
}
///Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them.
///
///393 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn projection(
    _t: S,
    q: &[S; 12usize],
    _u: &[S; 3usize],
    _inputs: &[S; 3usize],
    p: &Parameters,
) -> ([S; 9usize], S) {
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t1 = 1.0_f32 / (cos_thA * cos_thA);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 0.57735026_f32 * t2;
    let sA = q[3];
    let sC = q[11];
    let t4 = 0.5_f32 * sC;
    let t5 = 0.8660254_f32 * sC;
    let sB = q[7];
    let t6 = 0.5_f32 * sB;
    let t7 = 0.8660254_f32 * sB;
    let t8 = 1.0_f32 / t7;
    let t9 = (sA + t6) * t8;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = 0.5_f32 * t10;
    let t12 = cos_thA * cos_psiA;
    let t13 = t11 + 0.8660254_f32 * t12;
    let t14 = 0.8660254_f32 * t10;
    let t15 = 0.5_f32 * t12;
    let t16 = t14 - t15;
    let t17 = cos_psiB * t13 + sin_psiB * t16;
    let t18 = 1.1547005_f32 * t17;
    let v_G_z_per_u_hA = cos_thB * t18;
    let hA = q[0];
    let t19 = 0.57735026_f32 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t20 = t19 * sin_psiC;
    let t21 = cos_thC * cos_psiC;
    let t22 = 0.57735026_f32 * cos_thB;
    let t23 = cos_thB * cos_psiB - t22 * sin_psiB;
    let t24 = t20 + (t21 + t23);
    let t25 = 0.5_f32 * t24;
    let t26 = t10 * t3 - sin_thA * t25;
    let t27 = cos_thC * sin_psiC;
    let t28 = t22 * cos_psiB + cos_thB * sin_psiB;
    let t29 = t19 * cos_psiC;
    let t30 = t27 + (t28 - t29);
    let t31 = 0.5_f32 * t30;
    let t32 = sin_thA * t31 + t12 * t3;
    let t33 = t12 * t25 + t10 * t31;
    let t34 = 1.0_f32 / Real::sqrt(t26 * t26 + t32 * t32 + t33 * t33);
    let t35 = t26 * t34;
    let t36 = t32 * t34;
    let t37 = t10 * t35 + t12 * t36;
    let hB = q[4];
    let t38 = hA + (sin_thA * t6 - t7 * t37 - hB);
    let R = p.R;
    let t39 = 1.1547005_f32 * (sin_thB * (cos_psiB * t16 - sin_psiB * t13) - sin_thA * cos_thB);
    let t40 = sin_thB * t18;
    let t41 = sin_psiB * t39 - cos_psiB * t40;
    let t42 = t33 * t34;
    let t43 = sin_thA * t35 - t12 * t42;
    let t44 = t7 * t43 + t10 * t6;
    let t45 = cos_psiB * t39 + sin_psiB * t40;
    let t46 = 0.5_f32 * t45 + 0.8660254_f32 * t41;
    let t47 = sin_thA * t36 + t10 * t42;
    let t48 = R - (t7 * t47 + t12 * t6);
    let t49 = 0.8660254_f32 * t45 - 0.5_f32 * t41;
    let t50 = t8 * (v_G_z_per_u_hA * t38 + R * t41 + t44 * t46 - t48 * t49);
    let hC = q[8];
    let t51 = hC - (t5 * t37 + sin_thA * t4) - hA;
    let t52 = t5 * t43 - t10 * t4;
    let t53 = R - (t12 * t4 - t5 * t47);
    let t54 = v_G_z_per_u_hA * t51 + R * (0.5_f32 * t49 + 0.8660254_f32 * t46) + t52 * t46 + t53 * t49;
    let t55 = 1.0_f32 / (sA + t4 + t5 * t9) * (t5 * t50 - t54);
    let u_psiA_per_w_platform_z = t1 * v_G_z_per_u_hA;
    let t56 = R * (t14 + t15) - sA + sin_thA * t51 + t10 * t52 + t12 * t53;
    let t57 = 0.4330127_f32 * t24;
    let t58 = 0.25_f32 * t30;
    let t59 = sA * (cos_thA * (sin_psiA * t25 - cos_psiA * t31) + sin_thA * t3);
    let t60 = sA + R * t16 + sin_thA * t38 + t10 * t44 - t12 * t48;
    let t61 = R * (t58 + t57) + t59 + t3 * t38 + t25 * t44 + 1.7320508_f32 * t60;
    let t62 = t61 + t31 * t48;
    let t63 = 1.7320508_f32 * t56 - (R * (t57 - t58) - t62 - t59 + t3 * t51 + t25 * t52);
    let t64 = sA * sin_thA;
    let t65 = sA * t12;
    let t66 = sA * t10;
    let t67 = t64 * t3 - (t65 * t31 - t66 * t25) - t59;
    let t68 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC))) * (t63 + 2.0_f32 * t67 + t31 * t53);
    let t69 = t1 * t3 * t55 - u_psiA_per_w_platform_z * t68;
    let t70 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t70 * v_G_z_per_u_hA;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t71 = v_G_x_per_w_platform_z * t68 - 0.57735026_f32 * (t62 - (sA * t68 - t67));
    let t72 = t71 + (sA - (t12 * t65 + t10 * t66 + sin_thA * t64));
    let t73 = 1.0_f32 / (cos_thB * cos_thB);
    let t74 = 0.8660254_f32 * sin_thA;
    let t75 = 0.28867513_f32 * t2;
    let t76 = t74 + t75;
    let t77 = t50 - t9 * t55;
    let t78 = 0.8660254_f32 * t47;
    let t79 = 0.8660254_f32 * t23;
    let t80 = 0.8660254_f32 * t43;
    let t81 = 0.8660254_f32 * t28;
    let t82 = t73 * (0.8660254_f32 * t76) * t77 + t73 * ((t15 + t78) * t79 + (t11 + t80) * t81);
    let u_psiB_per_w_platform_z = t73 * v_G_z_per_u_hA;
    let t83 = t73 * (0.5_f32 * t76) * t55 + t82 - u_psiB_per_w_platform_z * t68;
    let t84 = 1.0_f32 / cos_thB;
    let t85 = 0.5_f32 * v_G_z_per_u_hA;
    let t86 = 0.5_f32 * sin_thA;
    let t87 = 0.8660254_f32 * t37;
    let t88 = t84 * t76 * t68 + (t84 * t85 * t55 - (t84 * (sin_thB + (t86 - t87)) - t17 * t77));
    let t89 = 1.7320508_f32 * sB * t68 - 2.0_f32 * (t60 + t71);
    let t90 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = t90 * v_G_z_per_u_hA;
    let t91 = t74 - t75;
    let u_psiC_per_w_platform_y = t90 * (0.5_f32 * t91);
    let t92 = 0.8660254_f32 * (t29 - t27);
    let t93 = 0.8660254_f32 * (t20 + t21);
    let t94 = t90 * ((t80 - t11) * t92 - (t78 - t15) * t93) - t90 * (0.8660254_f32 * t91) * t77;
    let t95 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t95 * t91;
    let u_thC_per_w_platform_x = t95 * (0.8660254_f32 * v_G_z_per_u_hA);
    let t96 = u_thC_per_w_platform_z * t68 + (u_thC_per_w_platform_x * t77 + t95 * (sin_thC + (t86 + t87)) - t95 * t85 * t55);
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let t97 = 2.0_f32 * (t56 - t71) - u_sC_per_w_platform_z * t68;
    let t98 = sA * cos_thA;
    let t99 = sin_psiA * t98;
    let t100 = sB * cos_thB;
    let t101 = sin_psiB * t100;
    let t102 = cos_psiB * t100;
    let t103 = R - cos_psiA * t98 + 0.5_f32 * R;
    let t104 = Real::max(Real::abs(t99 + 0.5_f32 * t101 + 0.8660254_f32 * (R - t102)), Real::abs(t103 - (0.5_f32 * t102 + 0.8660254_f32 * t101)));
    let t105 = sC * cos_thC;
    let t106 = sin_psiC * t105;
    let t107 = cos_psiC * t105;
    let t108 = Real::max(Real::max(t104, Real::abs(hA - hB + t64 - sB * sin_thB)), Real::abs(t99 + 0.5_f32 * t106 + 0.8660254_f32 * (t107 - R)));
    let t109 = Real::max(Real::max(t108, Real::abs(t103 + (0.8660254_f32 * t106 - 0.5_f32 * t107))), Real::abs(sC * sin_thC + (hC - hA - t64)));
    let t110 = Real::max(Real::max(Real::max(t109, Real::abs(t10 + t79 - t93)), Real::abs(t92 - (t12 - t81))), Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t69, -(t70 * t3 * t68 + u_thA_per_w_platform_y * t55), t72, t83, t88, t89, -(u_psiC_per_w_platform_z * t68 + (u_psiC_per_w_platform_y * t55 + t94)), -t96, t97], t110)
}
///Three-legged tile: screws A, B, C lift connectors; rods at 120 degrees carry the platform.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tile {
    /// Tunable parameters.
    pub parameters: Parameters,
}
impl Tile {
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
impl smartbed_runtime::mechanism::Mechanism<S> for Tile {
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
