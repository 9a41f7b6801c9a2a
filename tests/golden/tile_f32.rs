// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 837 operations (12 abs, 164 add, 5 cos, 12 div, 11 min, 491 mul, 5 sin, 137 sub).
// Cost of energy: 317 operations (63 add, 5 cos, 9 div, 198 mul, 5 sin, 37 sub).
// Cost of speeds: 239 operations (39 add, 5 cos, 9 div, 144 mul, 5 sin, 37 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 380 operations (9 abs, 72 add, 6 cos, 10 div, 8 max, 197 mul, 6 sin, 1 sqrt, 71 sub).

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
///837 operations.
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
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t1 = cos_thA * cos_thA;
    let t2 = 1.0_f32 / t1;
    let sA = q[3];
    let sC = q[11];
    let sB = q[7];
    let t3 = sA + 0.5_f32 * sB;
    let t4 = 0.8660254_f32 * sC;
    let t5 = 0.8660254_f32 * sB;
    let t6 = 1.0_f32 / t5;
    let t7 = t4 * t6;
    let t8 = sA + 0.5_f32 * sC + t3 * t7;
    let t9 = 1.0_f32 / t8;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = cos_thA * cos_psiA;
    let t12 = cos_psiB * (0.5_f32 * t10 + 0.8660254_f32 * t11) + sin_psiB * (0.8660254_f32 * t10 - 0.5_f32 * t11);
    let t13 = cos_thB * (1.1547005_f32 * t12);
    let t14 = t7 * t13;
    let w_platform_y_per_u_hB = t9 * t14;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t15 = sin_thB - sin_thC;
    let t16 = 0.57735026_f32 * t15;
    let t17 = 2.0_f32 * (sA + (sB + sC));
    let t18 = 1.0_f32 / t17;
    let t19 = 1.7320508_f32 * sin_thA;
    let t20 = t19 + t16;
    let t21 = t18 * t20;
    let t22 = t13 * t21;
    let t23 = t2 * (w_platform_y_per_u_hB * t16 - t22);
    let t24 = t9 * (t13 + t14);
    let t25 = t18 * (1.1547005_f32 * t15);
    let t26 = t13 * t25;
    let u_psiA_per_u_hA = t2 * (t16 * t24 - t26);
    let u_hC = u[2];
    let w_platform_y_per_u_hC = t9 * t13;
    let t27 = t18 * (t19 - t16);
    let t28 = t13 * t27;
    let t29 = t2 * (t16 * w_platform_y_per_u_hC + t28);
    let t30 = u_hB * t23 - u_hA * u_psiA_per_u_hA + u_hC * t29;
    let t31 = 1.0_f32 / cos_thA;
    let t32 = t31 * (t16 * t25 + t13 * t24);
    let t33 = 0.8660254_f32 * sin_thA;
    let t34 = 0.28867513_f32 * t15;
    let t35 = t33 + t34;
    let t36 = t25 * t35;
    let u_thA_per_u_hB = t31 * (t13 * w_platform_y_per_u_hB + t36);
    let t37 = t33 - t34;
    let t38 = t25 * t37;
    let t39 = t31 * (t38 - t13 * w_platform_y_per_u_hC);
    let t40 = u_hA * t32 - u_hB * u_thA_per_u_hB + u_hC * t39;
    let t41 = 2.0_f32 * sB;
    let v_G_y_per_u_hC = sA * t27;
    let u_sA_per_u_hC = 0.57735026_f32 * (t41 * t27 + v_G_y_per_u_hC);
    let t42 = sA * t21;
    let v_G_x_per_u_hB = 0.57735026_f32 * (t42 - (t20 - t41 * t21));
    let v_G_y_per_u_hA = sA * t25 - t16;
    let t43 = 0.57735026_f32 * (t41 * t25 + v_G_y_per_u_hA);
    let u_sA = u_hC * u_sA_per_u_hC - (u_hB * v_G_x_per_u_hB + u_hA * (sin_thA - t43));
    let t44 = cos_thB * cos_thB;
    let t45 = 1.0_f32 / t44;
    let t46 = 0.5_f32 * t35;
    let t47 = 0.8660254_f32 * t35;
    let w_platform_x_per_u_hA = t6 * (t3 * t24 - t13);
    let u_psiB_per_u_hA = t45 * (t24 * t46 - t47 * w_platform_x_per_u_hA - t26);
    let w_platform_x_per_u_hB = t6 * (t13 - t3 * w_platform_y_per_u_hB);
    let t48 = t45 * (w_platform_y_per_u_hB * t46 + w_platform_x_per_u_hB * t47 - t22);
    let t49 = t6 * (t3 * w_platform_y_per_u_hC);
    let u_psiB_per_u_hC = t45 * (t47 * t49 - w_platform_y_per_u_hC * t46 - t28);
    let u_psiB = u_hA * u_psiB_per_u_hA - u_hB * t48 + u_hC * u_psiB_per_u_hC;
    let t50 = 1.0_f32 / cos_thB;
    let t51 = 0.5_f32 * t13;
    let t52 = w_platform_y_per_u_hB * t51;
    let t53 = 0.8660254_f32 * t13;
    let t54 = w_platform_x_per_u_hB * t53;
    let t55 = t50 * (t21 * t35 + (t52 + t54));
    let t56 = t24 * t51;
    let t57 = w_platform_x_per_u_hA * t53;
    let u_thB_per_u_hA = t50 * (t36 + (t56 - t57));
    let t58 = t52 - t54 - t27 * t35;
    let t59 = t50 * t58;
    let t60 = u_hB * t55 - u_hA * u_thB_per_u_hA + u_hC * t59;
    let u_sB_per_u_hB = 2.0_f32 * (v_G_x_per_u_hB + (sin_thA - t5 * t21));
    let u_sB = u_hB * u_sB_per_u_hB + u_hA * (2.0_f32 * (t5 * t25 - t43)) + u_hC * (2.0_f32 * (t5 * t27 - u_sA_per_u_hC));
    let t61 = cos_thC * cos_thC;
    let t62 = 1.0_f32 / t61;
    let t63 = 0.5_f32 * t37;
    let t64 = 0.8660254_f32 * t37;
    let u_psiC_per_u_hC = t62 * (w_platform_y_per_u_hC * t63 + t49 * t64 - t28);
    let t65 = t62 * (t26 + (t24 * t63 + w_platform_x_per_u_hA * t64));
    let u_psiC_per_u_hB = t62 * (t22 - (w_platform_x_per_u_hB * t64 - w_platform_y_per_u_hB * t63));
    let u_psiC = u_hC * u_psiC_per_u_hC - (u_hA * t65 - u_hB * u_psiC_per_u_hB);
    let t66 = 1.0_f32 / cos_thC;
    let t67 = t66 * t58;
    let t68 = t66 * (t38 - (t56 + t57));
    let t69 = t66 * (t27 * t37 + (w_platform_y_per_u_hC * t51 + t49 * t53));
    let t70 = u_hB * t67 + u_hA * t68 + u_hC * t69;
    let t71 = u_hA * (2.0_f32 * (t43 + t4 * t25)) - u_hB * (2.0_f32 * (v_G_x_per_u_hB + t4 * t21));
    let t72 = t71 + u_hC * (2.0_f32 * (u_sA_per_u_hC + (t4 * t27 - sin_thA)));
    let v_G_z_per_u_hA = t13 - sA * t24;
    let M = p.M;
    let Iz = p.Iz;
    let Iy = p.Iy;
    let Ix = p.Ix;
    let Ic2 = p.Ic2;
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t73 = sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC);
    let t74 = sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB);
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t75 = mc + (ms + mr);
    let t76 = sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA);
    let t77 = u_psiB_per_u_hA * (t74 * u_psiB_per_u_hA) + (t32 * (Ic2 * t32) + (t75 + u_psiA_per_u_hA * (t76 * u_psiA_per_u_hA)));
    let t78 = t68 * (Ic2 * t68) + (t65 * (t73 * t65) + (u_thB_per_u_hA * (Ic2 * u_thB_per_u_hA) + t77));
    let t79 = t25 * (Iz * t25) + (t24 * (Iy * t24) + (w_platform_x_per_u_hA * (Ix * w_platform_x_per_u_hA) + t78));
    let mass_u_hA_u_hA = v_G_z_per_u_hA * (M * v_G_z_per_u_hA) + (v_G_y_per_u_hA * (M * v_G_y_per_u_hA) + (t43 * (M * t43) + t79));
    let t80 = 1.0_f32 / mass_u_hA_u_hA;
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let t81 = M * v_G_z_per_u_hB;
    let t82 = M * t42;
    let t83 = M * v_G_x_per_u_hB;
    let t84 = Iz * t21;
    let t85 = Iy * w_platform_y_per_u_hB;
    let t86 = Ix * w_platform_x_per_u_hB;
    let t87 = Ic2 * t67;
    let t88 = t73 * u_psiC_per_u_hB;
    let t89 = Ic2 * t55;
    let t90 = t74 * t48;
    let t91 = Ic2 * u_thA_per_u_hB;
    let t92 = t76 * t23;
    let t93 = t65 * t88 + (u_thB_per_u_hA * t89 + (u_psiB_per_u_hA * t90 + (t32 * t91 + u_psiA_per_u_hA * t92)));
    let t94 = t43 * t83 + (t25 * t84 + (t24 * t85 - (w_platform_x_per_u_hA * t86 + (t68 * t87 - t93))));
    let mass_u_hA_u_hB = v_G_z_per_u_hA * t81 - (v_G_y_per_u_hA * t82 + t94);
    let t95 = t80 * mass_u_hA_u_hB;
    let t96 = u_psiC_per_u_hB * t88 + (t55 * t89 + (t48 * t90 + (t75 + (u_thA_per_u_hB * t91 + t23 * t92))));
    let t97 = v_G_x_per_u_hB * t83 + (t21 * t84 + (w_platform_y_per_u_hB * t85 + (w_platform_x_per_u_hB * t86 + (t67 * t87 + t96))));
    let mass_u_hB_u_hB = v_G_z_per_u_hB * t81 + (t42 * t82 + t97);
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t95;
    let t98 = 1.0_f32 / pivot_1;
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let t99 = M * v_G_z_per_u_hC;
    let t100 = M * v_G_y_per_u_hC;
    let t101 = M * u_sA_per_u_hC;
    let t102 = Iy * w_platform_y_per_u_hC;
    let t103 = Ic2 * t69;
    let t104 = t73 * u_psiC_per_u_hC;
    let t105 = Ic2 * t59;
    let t106 = t74 * u_psiB_per_u_hC;
    let t107 = Ic2 * t39;
    let t108 = t76 * t29;
    let t109 = u_psiC_per_u_hB * t104 + (t55 * t105 - (t48 * t106 + (u_thA_per_u_hB * t107 - t23 * t108)));
    let t110 = Ix * t49;
    let t111 = Iz * t27;
    let t112 = v_G_x_per_u_hB * t101 - (w_platform_y_per_u_hB * t102 + (t67 * t103 + t109 - w_platform_x_per_u_hB * t110) - t21 * t111);
    let mass_u_hB_u_hC = v_G_z_per_u_hB * t99 - (t42 * t100 + t112);
    let t113 = t65 * t104 + (u_thB_per_u_hA * t105 - (u_psiB_per_u_hA * t106 + (t32 * t107 - u_psiA_per_u_hA * t108)));
    let t114 = t43 * t101 + (t25 * t111 - (t24 * t102 + (w_platform_x_per_u_hA * t110 + (t113 - t68 * t103))));
    let mass_u_hA_u_hC = v_G_z_per_u_hA * t99 + (v_G_y_per_u_hA * t100 + t114);
    let t115 = mass_u_hB_u_hC - t95 * mass_u_hA_u_hC;
    let t116 = t98 * t115;
    let t117 = u_hA * t25 - u_hB * t21 + u_hC * t27;
    let w_platform_x = u_hB * w_platform_x_per_u_hB + u_hA * w_platform_x_per_u_hA - u_hC * t49;
    let t118 = t117 * w_platform_x;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * t24 + u_hC * w_platform_y_per_u_hC;
    let t119 = sA * t118 + 2.0_f32 * (u_sA * w_platform_y);
    let t120 = 0.5_f32 * t117;
    let t121 = t120 * w_platform_x;
    let t122 = 0.8660254_f32 * t117;
    let t123 = t122 * w_platform_y;
    let t124 = t121 - t123;
    let t125 = 0.5_f32 * w_platform_y;
    let t126 = 0.8660254_f32 * w_platform_x;
    let t127 = t125 + t126;
    let t128 = sB * t124 + 2.0_f32 * (u_sB * t127) + t119;
    let t129 = t125 - t126;
    let t130 = t123 + t121;
    let t131 = t9 * (t7 * t128 + (t119 - (2.0_f32 * (t72 * t129) - sC * t130)));
    let v_G_z_dot_bias = t119 - sA * t131;
    let g = p.g;
    let t132 = M * (v_G_z_dot_bias + g * t13);
    let t133 = w_platform_y * w_platform_x;
    let t134 = sA * t133 - 2.0_f32 * (u_sA * t117);
    let t135 = t117 * t120;
    let t136 = t135 + w_platform_y * t127;
    let t137 = t117 * t122;
    let t138 = t137 + w_platform_x * t127;
    let t139 = 1.7320508_f32 * (sB * t136 + 2.0_f32 * (u_sB * t122)) + (2.0_f32 * (u_sB * t120) - sB * t138);
    let t140 = w_platform_y * t129 + t135;
    let t141 = t137 - w_platform_x * t129;
    let t142 = 1.7320508_f32 * (sC * t140 + 2.0_f32 * (t72 * t122)) + (2.0_f32 * (t72 * t120) - sC * t141);
    let t143 = t18 * (t139 - t142 - 2.0_f32 * t134);
    let t144 = t134 + sA * t143;
    let t145 = M * (t144 + g * t16);
    let v_G_x_dot_bias = 0.57735026_f32 * (t144 - (t139 - t41 * t143));
    let t146 = M * (g * sin_thA - v_G_x_dot_bias);
    let t147 = Iy * t131 + (Ix - Iz) * t118;
    let t148 = t6 * (t128 - t3 * t131);
    let t149 = Ix * t148 + (Iz - Iy) * (t117 * w_platform_y);
    let t150 = t51 * t131;
    let t151 = t53 * t148;
    let t152 = cos_thC * u_psiC;
    let t153 = sin_thC * u_psiC;
    let t154 = t153 * t152;
    let t155 = t13 * t130 - (t16 * t141 + sin_thA * t140) - (sin_thC * (t152 * t152 + t70 * t70) - cos_thC * t154);
    let u_thC_dot_bias = t66 * (t37 * t143 + (t150 - (t151 + t155)));
    let t156 = Ic1 - Ic3;
    let t157 = Ic2 * u_thC_dot_bias - t156 * t154;
    let t158 = sin_thB * u_psiB;
    let t159 = cos_thB * u_psiB;
    let t160 = t158 * t159;
    let t161 = sin_thB * (t159 * t159 + t60 * t60) - cos_thB * t160 - (t16 * t138 - sin_thA * t136 + t13 * t124);
    let u_thB_dot_bias = t50 * (t150 + (t151 + t161) - t35 * t143);
    let t162 = t156 * t160 - Ic2 * u_thB_dot_bias;
    let t163 = Ic1 - Ic2 - Ic3;
    let t164 = t60 * t158;
    let t165 = Ic1 + (Ic2 - Ic3);
    let t166 = t13 * t143;
    let t167 = t47 * t148 - (t35 * t124 - (t51 * t138 - t53 * t136) + cos_thB * (2.0_f32 * t164));
    let u_psiB_dot_bias = t45 * (t166 + (t46 * t131 + t167));
    let t168 = cos_thB * (t163 * t164) + sin_thB * (t165 * (t60 * t159)) - t74 * u_psiB_dot_bias;
    let t169 = g * (ms + mc);
    let c = p.c;
    let FB = inputs[1];
    let t170 = sin_thA * t30;
    let t171 = cos_thA * t30;
    let t172 = t170 * t171;
    let t173 = cos_thA * t172 - sin_thA * (t171 * t171 + t40 * t40) - (t13 * t118 - (sin_thA * (t117 * t117 + w_platform_y * w_platform_y) - t16 * t133));
    let t174 = Ic2 * (t31 * (t13 * t131 + t173 - t16 * t143)) + t156 * t172;
    let t175 = t40 * t170;
    let t176 = t16 * t118 - t13 * t133 - cos_thA * (2.0_f32 * t175) - t16 * t131 - t166;
    let t177 = cos_thA * (t163 * t175) + sin_thA * (t165 * (t40 * t171)) - t76 * (t2 * t176);
    let t178 = t48 * t168 + (t169 + (u_hB * c - FB) - (u_thA_per_u_hB * t174 + t23 * t177));
    let t179 = t70 * t153;
    let t180 = t64 * t148 + (t37 * t130 - (t51 * t141 - t53 * t140) - cos_thC * (2.0_f32 * t179));
    let t181 = t73 * (t62 * (t63 * t131 - t180 - t166)) + (cos_thC * (t179 * t163) + sin_thC * (t165 * (t70 * t152)));
    let t182 = w_platform_y_per_u_hB * t147 + (w_platform_x_per_u_hB * t149 + (t67 * t157 - (t55 * t162 + t178 - u_psiC_per_u_hB * t181)));
    let t183 = Iz * t143 + (Iy - Ix) * t133;
    let FA = inputs[0];
    let t184 = t32 * t174 + (u_psiA_per_u_hA * t177 + (u_hA * c - FA + t169)) - u_psiB_per_u_hA * t168;
    let t185 = t24 * t147 + (t65 * t181 + (t184 - u_thB_per_u_hA * t162) - t68 * t157 - w_platform_x_per_u_hA * t149);
    let t186 = v_G_z_per_u_hA * t132 + (t43 * t146 - (t25 * t183 - t185) - v_G_y_per_u_hA * t145);
    let t187 = v_G_z_per_u_hB * t132 + (t42 * t145 - (v_G_x_per_u_hB * t146 + (t182 - t21 * t183))) - t95 * t186;
    let FC = inputs[2];
    let t188 = FC - u_hC * c - t169 - (t59 * t162 - (u_psiB_per_u_hC * t168 + (t29 * t177 - t39 * t174)));
    let t189 = t49 * t149 - (t69 * t157 + (u_psiC_per_u_hC * t181 + t188)) - w_platform_y_per_u_hC * t147 - t27 * t183;
    let t190 = t80 * mass_u_hA_u_hC;
    let t191 = t116 * t187 - (v_G_z_per_u_hC * t132 + (u_sA_per_u_hC * t146 + t189 - v_G_y_per_u_hC * t145) - t190 * t186);
    let t192 = u_psiC_per_u_hC * t104 + (t75 + (t59 * t105 + (u_psiB_per_u_hC * t106 + (t39 * t107 + t29 * t108))));
    let t193 = u_sA_per_u_hC * t101 + (t27 * t111 + (w_platform_y_per_u_hC * t102 + (t49 * t110 + (t69 * t103 + t192))));
    let mass_u_hC_u_hC = v_G_z_per_u_hC * t99 + (v_G_y_per_u_hC * t100 + t193);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t190 - t115 * t116;
    let t194 = t191 / pivot_2;
    let t195 = t116 * t194 + t98 * t187;
    let t196 = t95 * t195 - t80 * t186 - t190 * t194;
    let t197 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t1)), Real::abs(t44));
    let t198 = Real::min(Real::min(Real::min(Real::min(t197, Real::abs(t61)), 0.8333333_f32 * Real::abs(t17)), 5.773503_f32 * Real::abs(t5)), 1.6666666_f32 * Real::abs(t8));
    let t199 = Real::min(Real::min(Real::min(t198, 0.21652833_f32 * Real::abs(mass_u_hA_u_hA)), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, -t30, -t40, u_sA, u_hB, u_psiB, -t60, u_sB, u_hC, u_psiC, -t70, -t72], [t196, -t195, t194], t199)
}
///Kinetic and potential energy (J).
///
///317 operations.
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
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t1 = mc + (ms + mr);
    let u_hC = u[2];
    let u_hB = u[1];
    let u_hA = u[0];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t2 = 1.0_f32 / (cos_thA * cos_thA);
    let sA = q[3];
    let sC = q[11];
    let sB = q[7];
    let t3 = sA + 0.5_f32 * sB;
    let t4 = 1.0_f32 / (0.8660254_f32 * sB);
    let t5 = 0.8660254_f32 * sC * t4;
    let t6 = 1.0_f32 / (sA + 0.5_f32 * sC + t3 * t5);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t7 = cos_thA * sin_psiA;
    let t8 = cos_thA * cos_psiA;
    let t9 = cos_psiB * (0.5_f32 * t7 + 0.8660254_f32 * t8) + sin_psiB * (0.8660254_f32 * t7 - 0.5_f32 * t8);
    let t10 = cos_thB * (1.1547005_f32 * t9);
    let t11 = t5 * t10;
    let w_platform_y_per_u_hB = t6 * t11;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t12 = sin_thB - sin_thC;
    let t13 = 0.57735026_f32 * t12;
    let t14 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC)));
    let t15 = 1.7320508_f32 * sin_thA;
    let t16 = t15 + t13;
    let t17 = t14 * t16;
    let t18 = t10 * t17;
    let t19 = t6 * (t10 + t11);
    let t20 = t14 * (1.1547005_f32 * t12);
    let t21 = t10 * t20;
    let u_psiA_per_u_hA = t2 * (t13 * t19 - t21);
    let w_platform_y_per_u_hC = t6 * t10;
    let t22 = t14 * (t15 - t13);
    let t23 = t10 * t22;
    let t24 = u_hB * (t2 * (w_platform_y_per_u_hB * t13 - t18)) - u_hA * u_psiA_per_u_hA + u_hC * (t2 * (t13 * w_platform_y_per_u_hC + t23));
    let t25 = t1 * (u_hA * u_hA) + (sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA)) * (t24 * t24);
    let Ic2 = p.Ic2;
    let t26 = 1.0_f32 / cos_thA;
    let t27 = 0.8660254_f32 * sin_thA;
    let t28 = 0.28867513_f32 * t12;
    let t29 = t27 + t28;
    let t30 = t20 * t29;
    let u_thA_per_u_hB = t26 * (t10 * w_platform_y_per_u_hB + t30);
    let t31 = t27 - t28;
    let t32 = t20 * t31;
    let t33 = u_hA * (t26 * (t13 * t20 + t10 * t19)) - u_hB * u_thA_per_u_hB + u_hC * (t26 * (t32 - t10 * w_platform_y_per_u_hC));
    let t34 = 1.0_f32 / (cos_thB * cos_thB);
    let t35 = 0.5_f32 * t29;
    let t36 = 0.8660254_f32 * t29;
    let w_platform_x_per_u_hA = t4 * (t3 * t19 - t10);
    let u_psiB_per_u_hA = t34 * (t19 * t35 - t36 * w_platform_x_per_u_hA - t21);
    let w_platform_x_per_u_hB = t4 * (t10 - t3 * w_platform_y_per_u_hB);
    let t37 = t4 * (t3 * w_platform_y_per_u_hC);
    let u_psiB_per_u_hC = t34 * (t36 * t37 - w_platform_y_per_u_hC * t35 - t23);
    let u_psiB = u_hA * u_psiB_per_u_hA - u_hB * (t34 * (w_platform_y_per_u_hB * t35 + w_platform_x_per_u_hB * t36 - t18)) + u_hC * u_psiB_per_u_hC;
    let t38 = t1 * (u_hB * u_hB) + (t25 + Ic2 * (t33 * t33)) + (sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB)) * (u_psiB * u_psiB);
    let t39 = 1.0_f32 / cos_thB;
    let t40 = 0.5_f32 * t10;
    let t41 = w_platform_y_per_u_hB * t40;
    let t42 = 0.8660254_f32 * t10;
    let t43 = w_platform_x_per_u_hB * t42;
    let t44 = t19 * t40;
    let t45 = w_platform_x_per_u_hA * t42;
    let u_thB_per_u_hA = t39 * (t30 + (t44 - t45));
    let t46 = t41 - t43 - t22 * t29;
    let t47 = u_hB * (t39 * (t17 * t29 + (t41 + t43))) - u_hA * u_thB_per_u_hA + u_hC * (t39 * t46);
    let t48 = 1.0_f32 / (cos_thC * cos_thC);
    let t49 = 0.5_f32 * t31;
    let t50 = 0.8660254_f32 * t31;
    let u_psiC_per_u_hC = t48 * (w_platform_y_per_u_hC * t49 + t37 * t50 - t23);
    let u_psiC_per_u_hB = t48 * (t18 - (w_platform_x_per_u_hB * t50 - w_platform_y_per_u_hB * t49));
    let u_psiC = u_hC * u_psiC_per_u_hC - (u_hA * (t48 * (t21 + (t19 * t49 + w_platform_x_per_u_hA * t50))) - u_hB * u_psiC_per_u_hB);
    let t51 = t1 * (u_hC * u_hC) + (t38 + Ic2 * (t47 * t47)) + (sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC)) * (u_psiC * u_psiC);
    let t52 = 1.0_f32 / cos_thC;
    let t53 = u_hB * (t52 * t46) + u_hA * (t52 * (t32 - (t44 + t45))) + u_hC * (t52 * (t22 * t31 + (w_platform_y_per_u_hC * t40 + t37 * t42)));
    let Ix = p.Ix;
    let w_platform_x = u_hB * w_platform_x_per_u_hB + u_hA * w_platform_x_per_u_hA - u_hC * t37;
    let Iy = p.Iy;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * t19 + u_hC * w_platform_y_per_u_hC;
    let t54 = t51 + Ic2 * (t53 * t53) + Ix * (w_platform_x * w_platform_x) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let t55 = u_hA * t20 - u_hB * t17 + u_hC * t22;
    let M = p.M;
    let t56 = 2.0_f32 * sB;
    let v_G_y_per_u_hC = sA * t22;
    let u_sA_per_u_hC = 0.57735026_f32 * (t56 * t22 + v_G_y_per_u_hC);
    let v_G_y_per_u_hA = sA * t20 - t13;
    let t57 = sA * t17;
    let v_G_x_per_u_hB = 0.57735026_f32 * (t57 - (t16 - t56 * t17));
    let t58 = u_hC * u_sA_per_u_hC + (u_hA * (0.57735026_f32 * (t56 * t20 + v_G_y_per_u_hA)) - u_hB * v_G_x_per_u_hB);
    let v_G_y = u_hC * v_G_y_per_u_hC - (u_hB * t57 - u_hA * v_G_y_per_u_hA);
    let t59 = t54 + Iz * (t55 * t55) + M * (t58 * t58) + M * (v_G_y * v_G_y);
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let v_G_z_per_u_hA = t10 - sA * t19;
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let v_G_z = u_hB * v_G_z_per_u_hB + u_hA * v_G_z_per_u_hA + u_hC * v_G_z_per_u_hC;
    let t60 = 0.5_f32 * (t59 + M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t61 = hA * g;
    let hC = q[8];
    let t62 = hC * g;
    let hB = q[4];
    let t63 = hB * g;
    let t64 = mc * t62 + (ms * t62 + (mc * t63 + (ms * t63 + t61 * (ms + mc))));
    let t65 = M * (t61 + sA * (g * sin_thA)) + t64;
    (t60, t65)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///239 operations.
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
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t1 = 1.0_f32 / (cos_thA * cos_thA);
    let sA = q[3];
    let sC = q[11];
    let sB = q[7];
    let t2 = sA + 0.5_f32 * sB;
    let t3 = 0.8660254_f32 * sC;
    let t4 = 0.8660254_f32 * sB;
    let t5 = 1.0_f32 / t4;
    let t6 = t3 * t5;
    let t7 = 1.0_f32 / (sA + 0.5_f32 * sC + t2 * t6);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t8 = cos_thA * sin_psiA;
    let t9 = cos_thA * cos_psiA;
    let t10 = cos_psiB * (0.5_f32 * t8 + 0.8660254_f32 * t9) + sin_psiB * (0.8660254_f32 * t8 - 0.5_f32 * t9);
    let t11 = cos_thB * (1.1547005_f32 * t10);
    let t12 = t6 * t11;
    let w_platform_y_per_u_hB = t7 * t12;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t13 = sin_thB - sin_thC;
    let t14 = 0.57735026_f32 * t13;
    let t15 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC)));
    let t16 = 1.7320508_f32 * sin_thA;
    let t17 = t16 + t14;
    let t18 = t15 * t17;
    let t19 = t11 * t18;
    let t20 = t7 * (t11 + t12);
    let t21 = t15 * (1.1547005_f32 * t13);
    let t22 = t11 * t21;
    let u_psiA_per_u_hA = t1 * (t14 * t20 - t22);
    let u_hC = u[2];
    let w_platform_y_per_u_hC = t7 * t11;
    let t23 = t15 * (t16 - t14);
    let t24 = t11 * t23;
    let t25 = u_hB * (t1 * (w_platform_y_per_u_hB * t14 - t19)) - u_hA * u_psiA_per_u_hA + u_hC * (t1 * (t14 * w_platform_y_per_u_hC + t24));
    let t26 = 1.0_f32 / cos_thA;
    let t27 = 0.8660254_f32 * sin_thA;
    let t28 = 0.28867513_f32 * t13;
    let t29 = t27 + t28;
    let t30 = t21 * t29;
    let u_thA_per_u_hB = t26 * (t11 * w_platform_y_per_u_hB + t30);
    let t31 = t27 - t28;
    let t32 = t21 * t31;
    let t33 = u_hA * (t26 * (t14 * t21 + t11 * t20)) - u_hB * u_thA_per_u_hB + u_hC * (t26 * (t32 - t11 * w_platform_y_per_u_hC));
    let t34 = 2.0_f32 * sB;
    let v_G_y_per_u_hC = sA * t23;
    let u_sA_per_u_hC = 0.57735026_f32 * (t34 * t23 + v_G_y_per_u_hC);
    let v_G_x_per_u_hB = 0.57735026_f32 * (sA * t18 - (t17 - t34 * t18));
    let v_G_y_per_u_hA = sA * t21 - t14;
    let t35 = 0.57735026_f32 * (t34 * t21 + v_G_y_per_u_hA);
    let u_sA = u_hC * u_sA_per_u_hC - (u_hB * v_G_x_per_u_hB + u_hA * (sin_thA - t35));
    let t36 = 1.0_f32 / (cos_thB * cos_thB);
    let t37 = 0.5_f32 * t29;
    let t38 = 0.8660254_f32 * t29;
    let w_platform_x_per_u_hA = t5 * (t2 * t20 - t11);
    let u_psiB_per_u_hA = t36 * (t20 * t37 - t38 * w_platform_x_per_u_hA - t22);
    let w_platform_x_per_u_hB = t5 * (t11 - t2 * w_platform_y_per_u_hB);
    let t39 = t5 * (t2 * w_platform_y_per_u_hC);
    let u_psiB_per_u_hC = t36 * (t38 * t39 - w_platform_y_per_u_hC * t37 - t24);
    let u_psiB = u_hA * u_psiB_per_u_hA - u_hB * (t36 * (w_platform_y_per_u_hB * t37 + w_platform_x_per_u_hB * t38 - t19)) + u_hC * u_psiB_per_u_hC;
    let t40 = 1.0_f32 / cos_thB;
    let t41 = 0.5_f32 * t11;
    let t42 = w_platform_y_per_u_hB * t41;
    let t43 = 0.8660254_f32 * t11;
    let t44 = w_platform_x_per_u_hB * t43;
    let t45 = t20 * t41;
    let t46 = w_platform_x_per_u_hA * t43;
    let u_thB_per_u_hA = t40 * (t30 + (t45 - t46));
    let t47 = t42 - t44 - t23 * t29;
    let t48 = u_hB * (t40 * (t18 * t29 + (t42 + t44))) - u_hA * u_thB_per_u_hA + u_hC * (t40 * t47);
    let u_sB_per_u_hB = 2.0_f32 * (v_G_x_per_u_hB + (sin_thA - t4 * t18));
    let u_sB = u_hB * u_sB_per_u_hB + u_hA * (2.0_f32 * (t4 * t21 - t35)) + u_hC * (2.0_f32 * (t4 * t23 - u_sA_per_u_hC));
    let t49 = 1.0_f32 / (cos_thC * cos_thC);
    let t50 = 0.5_f32 * t31;
    let t51 = 0.8660254_f32 * t31;
    let u_psiC_per_u_hC = t49 * (w_platform_y_per_u_hC * t50 + t39 * t51 - t24);
    let u_psiC_per_u_hB = t49 * (t19 - (w_platform_x_per_u_hB * t51 - w_platform_y_per_u_hB * t50));
    let u_psiC = u_hC * u_psiC_per_u_hC - (u_hA * (t49 * (t22 + (t20 * t50 + w_platform_x_per_u_hA * t51))) - u_hB * u_psiC_per_u_hB);
    let t52 = 1.0_f32 / cos_thC;
    let t53 = u_hB * (t52 * t47) + u_hA * (t52 * (t32 - (t45 + t46))) + u_hC * (t52 * (t23 * t31 + (w_platform_y_per_u_hC * t41 + t39 * t43)));
    let t54 = u_hA * (2.0_f32 * (t35 + t3 * t21)) - u_hB * (2.0_f32 * (v_G_x_per_u_hB + t3 * t18));
    [u_hA, -t25, -t33, u_sA, u_hB, u_psiB, -t48, u_sB, u_hC, u_psiC, -t53, -(t54 + u_hC * (2.0_f32 * (u_sA_per_u_hC + (t3 * t23 - sin_thA))))]
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
///380 operations.
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
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t1 = sin_thB - sin_thC;
    let t2 = 0.57735026_f32 * t1;
    let sA = q[3];
    let sC = q[11];
    let t3 = 0.5_f32 * sC;
    let sB = q[7];
    let t4 = 0.5_f32 * sB;
    let t5 = sA + t4;
    let t6 = 0.8660254_f32 * sC;
    let t7 = 0.8660254_f32 * sB;
    let t8 = 1.0_f32 / t7;
    let t9 = t6 * t8;
    let R = p.R;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = 0.8660254_f32 * t10;
    let t12 = cos_thA * cos_psiA;
    let t13 = 0.5_f32 * t12;
    let t14 = t11 - t13;
    let t15 = 0.5_f32 * t10;
    let t16 = t15 + 0.8660254_f32 * t12;
    let t17 = 1.1547005_f32 * (sin_thB * (cos_psiB * t14 - sin_psiB * t16) - sin_thA * cos_thB);
    let t18 = 1.1547005_f32 * (cos_psiB * t16 + sin_psiB * t14);
    let t19 = sin_thB * t18;
    let t20 = sin_psiB * t17 - cos_psiB * t19;
    let t21 = cos_psiB * t17 + sin_psiB * t19;
    let t22 = 0.8660254_f32 * t21 - 0.5_f32 * t20;
    let t23 = R * t22;
    let t24 = 0.57735026_f32 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t25 = t24 * cos_psiC - cos_thC * sin_psiC;
    let t26 = 0.57735026_f32 * cos_thB;
    let t27 = t26 * cos_psiB + cos_thB * sin_psiB;
    let t28 = t25 - t27;
    let t29 = 0.5_f32 * t28;
    let t30 = sin_thA * t29 - t12 * t2;
    let t31 = cos_thB * cos_psiB - t26 * sin_psiB;
    let t32 = t24 * sin_psiC + cos_thC * cos_psiC;
    let t33 = t31 + t32;
    let t34 = 0.5_f32 * t33;
    let t35 = t10 * t2 - sin_thA * t34;
    let t36 = t10 * t29 - t12 * t34;
    let t37 = 1.0_f32 / Real::sqrt(t35 * t35 + t30 * t30 + t36 * t36);
    let t38 = t30 * t37;
    let t39 = t36 * t37;
    let t40 = sin_thA * t38 + t10 * t39;
    let t41 = t12 * t4 - t7 * t40;
    let t42 = t35 * t37;
    let t43 = t12 * t39 + sin_thA * t42;
    let t44 = t7 * t43 + t10 * t4;
    let t45 = 0.5_f32 * t21 + 0.8660254_f32 * t20;
    let t46 = cos_thB * t18;
    let hA = q[0];
    let t47 = t12 * t38 - t10 * t42;
    let hB = q[4];
    let t48 = hA + (t7 * t47 + sin_thA * t4 - hB);
    let t49 = R * t20 - (t23 - (t41 * t22 + t44 * t45 + t46 * t48));
    let t50 = t6 * t40 + t12 * t3;
    let t51 = t6 * t43 - t10 * t3;
    let hC = q[8];
    let t52 = hC + (t6 * t47 - sin_thA * t3) - hA;
    let t53 = t22 * t50 - t45 * t51 - t46 * t52 - t23 - R * (0.5_f32 * t22 + 0.8660254_f32 * t45);
    let t54 = 1.0_f32 / (sA + t3 + t5 * t9) * (t9 * t49 + t53);
    let t55 = sA * t12;
    let t56 = sA * t10;
    let t57 = sA * sin_thA;
    let t58 = sA * (cos_thA * (sin_psiA * t34 + cos_psiA * t29) + sin_thA * t2);
    let t59 = t55 * t29 + t56 * t34 + t57 * t2 - t58;
    let t60 = R * t12;
    let t61 = R * t14 - (t60 - (t12 * t41 + t10 * t44 + sin_thA * t48) - sA);
    let t62 = 0.4330127_f32 * t33;
    let t63 = 0.25_f32 * t28;
    let t64 = R * t29;
    let t65 = R * (t62 - t63) - (t64 - (t29 * t41 + t34 * t44 + t2 * t48) - t58);
    let t66 = 1.7320508_f32 * t61 + t65;
    let t67 = sA - (t60 + (t10 * t51 - t12 * t50 + sin_thA * t52)) - R * (t11 + t13);
    let t68 = t64 - (t29 * t50 - t34 * t51 - t2 * t52) - t58 + R * (t63 + t62);
    let t69 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC))) * (2.0_f32 * t59 + (t66 - (1.7320508_f32 * t67 + t68)));
    let t70 = t46 * t69;
    let t71 = 1.0_f32 / (cos_thA * cos_thA) * (t2 * t54 - t70);
    let t72 = 0.57735026_f32 * (sA * t69 - t59 - (t66 - 2.0_f32 * sB * t69));
    let t73 = t72 + (sA - (t12 * t55 + t10 * t56 + sin_thA * t57));
    let t74 = 0.8660254_f32 * sin_thA;
    let t75 = 0.28867513_f32 * t1;
    let t76 = t74 + t75;
    let t77 = 0.8660254_f32 * t40;
    let t78 = 0.8660254_f32 * t31;
    let t79 = 0.8660254_f32 * t43;
    let t80 = 0.8660254_f32 * t27;
    let t81 = t8 * (t5 * t54 - t49);
    let t82 = 0.5_f32 * t76 * t54 + ((t13 - t77) * t78 + (t15 + t79) * t80 - 0.8660254_f32 * t76 * t81);
    let t83 = 0.5_f32 * t46 * t54;
    let t84 = 0.8660254_f32 * t46 * t81;
    let t85 = 0.5_f32 * sin_thA;
    let t86 = 0.8660254_f32 * t47;
    let t87 = 1.0_f32 / cos_thB * (t76 * t69 + (t83 - (t84 + (sin_thB + (t85 + t86)))));
    let t88 = t74 - t75;
    let t89 = 0.8660254_f32 * t32;
    let t90 = 0.8660254_f32 * t25;
    let t91 = 0.5_f32 * t88 * t54 + (0.8660254_f32 * t88 * t81 + ((t13 + t77) * t89 + (t79 - t15) * t90));
    let t92 = sA * cos_thA;
    let t93 = sin_psiA * t92;
    let t94 = 0.8660254_f32 * R;
    let t95 = sB * cos_thB;
    let t96 = sin_psiB * t95;
    let t97 = cos_psiB * t95;
    let t98 = R - cos_psiA * t92 + 0.5_f32 * R;
    let t99 = Real::max(Real::abs(t93 + t94 + (0.5_f32 * t96 - 0.8660254_f32 * t97)), Real::abs(t98 - (0.5_f32 * t97 + 0.8660254_f32 * t96)));
    let t100 = sC * cos_thC;
    let t101 = cos_psiC * t100;
    let t102 = sin_psiC * t100;
    let t103 = Real::max(Real::max(t99, Real::abs(hA - hB + t57 - sB * sin_thB)), Real::abs(0.8660254_f32 * t101 + 0.5_f32 * t102 - (t94 - t93)));
    let t104 = Real::max(Real::max(t103, Real::abs(t98 + (0.8660254_f32 * t102 - 0.5_f32 * t101))), Real::abs(sC * sin_thC + (hC - hA - t57)));
    let t105 = Real::max(Real::max(Real::max(t104, Real::abs(t10 + t78 - t89)), Real::abs(t90 - (t12 - t80))), Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t71, -1.0_f32 / cos_thA * (t2 * t69 + t46 * t54), t73, -1.0_f32 / (cos_thB * cos_thB) * (t70 - t82), t87, -2.0_f32 * (t72 - (t7 * t69 - t61)), -1.0_f32 / (cos_thC * cos_thC) * (t70 + t91), -1.0_f32 / cos_thC * (t88 * t69 - (t83 - (sin_thC + (t85 - t86) - t84))), -2.0_f32 * (t72 + (t67 + t6 * t69))], t105)
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
