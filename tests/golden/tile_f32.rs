// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 761 operations (12 abs, 130 add, 5 cos, 12 div, 11 min, 452 mul, 5 sin, 134 sub).
// Cost of energy: 241 operations (43 add, 5 cos, 9 div, 161 mul, 5 sin, 18 sub).
// Cost of speeds: 158 operations (19 add, 5 cos, 9 div, 99 mul, 5 sin, 21 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 471 operations (9 abs, 82 add, 6 cos, 11 div, 8 max, 257 mul, 6 sin, 2 sqrt, 90 sub).

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
///761 operations.
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
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t1 = cos_thA * sin_psiA;
    let t2 = cos_thA * cos_psiA;
    let t3 = cos_psiB * (0.5_f32 * t1 + 0.8660254_f32 * t2) - sin_psiB * (0.5_f32 * t2 - 0.8660254_f32 * t1);
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t3);
    let t4 = cos_thA * cos_thA;
    let t5 = 1.0_f32 / t4;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t5;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t6 = 0.57735026_f32 * sin_thC;
    let t7 = 0.57735026_f32 * sin_thB;
    let v_G_y_per_u_hA = t6 - t7;
    let sB = q[7];
    let sC = q[11];
    let sA = q[3];
    let t8 = 2.0_f32 * sB + 2.0_f32 * sC + 2.0_f32 * sA;
    let t9 = 1.0_f32 / t8;
    let w_platform_z_per_u_hA = 2.0_f32 * v_G_y_per_u_hA * t9;
    let u_hB = u[1];
    let t10 = 1.7320508_f32 * sin_thA;
    let t11 = v_G_y_per_u_hA - t10;
    let t12 = t11 * t9;
    let u_hC = u[2];
    let t13 = (v_G_y_per_u_hA + t10) * t9;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * t12 - u_hC * t13;
    let t14 = (t7 - t6) * t5;
    let t15 = 0.8660254_f32 * sC;
    let t16 = 0.8660254_f32 * sB;
    let t17 = 1.0_f32 / t16;
    let t18 = (sA + 0.5_f32 * sB) * t17;
    let t19 = sA + 0.5_f32 * sC + t15 * t18;
    let t20 = 1.0_f32 / t19;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t20;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t17;
    let t21 = t15 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t21 * t20;
    let t22 = (v_G_z_per_u_hA + t21) * t20;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * t22);
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - t14 * w_platform_y;
    let t23 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t23;
    let t24 = v_G_y_per_u_hA * t23;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - t24 * w_platform_z;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t25 = 0.57735026_f32 * v_G_y;
    let v_G_x_per_u_hB = 0.57735026_f32 * t11;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t26 = u_hB * v_G_x_per_u_hB + v_G_x_per_w_platform_z * w_platform_z;
    let u_sA = t25 - t26 - u_hA * sin_thA;
    let t27 = cos_thB * cos_thB;
    let t28 = 1.0_f32 / t27;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t28;
    let t29 = 0.8660254_f32 * sin_thA;
    let t30 = 0.5_f32 * v_G_y_per_u_hA;
    let t31 = t29 - t30;
    let t32 = 0.8660254_f32 * t31 * t28;
    let w_platform_x = u_hB * w_platform_x_per_u_hB - u_hA * w_platform_x_per_u_hB - t18 * w_platform_y;
    let t33 = 0.5_f32 * t31 * t28;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t32 * w_platform_x + t33 * w_platform_y);
    let t34 = 1.0_f32 / cos_thB;
    let t35 = t31 * t34;
    let t36 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t37 = t36 * t34;
    let t38 = 0.5_f32 * v_G_z_per_u_hA;
    let t39 = t38 * t34;
    let t40 = t35 * w_platform_z + (t37 * w_platform_x + t39 * w_platform_y);
    let u_thB = -t40;
    let v_G_x = t26 - t25;
    let t41 = 2.0_f32 * v_G_x;
    let u_sB_per_u_hB = 2.0_f32 * sin_thA;
    let u_sB = t41 + (u_hB * u_sB_per_u_hB - 1.7320508_f32 * sB * w_platform_z);
    let t42 = cos_thC * cos_thC;
    let t43 = 1.0_f32 / t42;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t43;
    let t44 = t29 + t30;
    let u_psiC_per_w_platform_y = 0.5_f32 * t44 * t43;
    let t45 = 0.8660254_f32 * t44 * t43;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - t45 * w_platform_x);
    let t46 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t44 * t46;
    let u_thC_per_w_platform_x = t36 * t46;
    let t47 = t38 * t46;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t47 * w_platform_y);
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let u_sC = t41 + (u_hC * u_sB_per_u_hB + u_sC_per_w_platform_z * w_platform_z);
    let FA = inputs[0];
    let c = p.c;
    let ms = p.ms;
    let g = p.g;
    let mc = p.mc;
    let t48 = ms * g + mc * g;
    let M = p.M;
    let t49 = 1.3333334_f32 * M;
    let t50 = w_platform_y * w_platform_x;
    let t51 = 2.0_f32 * (w_platform_z * u_sA) + sA * t50;
    let t52 = 0.5_f32 * w_platform_z;
    let t53 = 0.8660254_f32 * w_platform_z;
    let t54 = w_platform_z * t53;
    let t55 = 0.8660254_f32 * w_platform_x;
    let t56 = 0.5_f32 * w_platform_y;
    let t57 = t55 + t56;
    let t58 = t54 + w_platform_x * t57;
    let t59 = w_platform_z * t52;
    let t60 = w_platform_y * t57 + t59;
    let t61 = 2.0_f32 * (u_sB * t52) + sB * t58 + 1.7320508_f32 * (2.0_f32 * (u_sB * t53) - sB * t60);
    let v_G_x_dot_bias = 0.57735026_f32 * t61;
    let t62 = M * (g * sin_thA) - M * v_G_x_dot_bias;
    let t63 = t49 * t51 - (M * (g * v_G_y_per_u_hA) + 0.57735026_f32 * t62);
    let t64 = 0.57735026_f32 * M;
    let t65 = v_G_x_per_w_platform_z * t64;
    let t66 = sA * t49;
    let t67 = v_G_y_per_u_hA * (t65 + t66);
    let t68 = t55 - t56;
    let t69 = t54 + w_platform_x * t68;
    let t70 = w_platform_y * t68;
    let t71 = 2.0_f32 * (u_sC * t52) - sC * t69 - 1.7320508_f32 * (sC * (t70 - t59) - 2.0_f32 * (u_sC * t53));
    let t72 = t9 * (t61 + t71 + 2.0_f32 * t51);
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t73 = Ic1 - Ic3;
    let t74 = cos_thC * u_psiC;
    let t75 = sin_thC * u_psiC;
    let t76 = t74 * t75;
    let Ic2 = p.Ic2;
    let t77 = t59 - t70;
    let t78 = w_platform_x * t52;
    let t79 = w_platform_y * t53;
    let t80 = t78 + t79;
    let t81 = cos_thC * t76 - sin_thC * (u_thC * u_thC + t74 * t74) + (v_G_y_per_u_hA * t69 - sin_thA * t77 - v_G_z_per_u_hA * t80);
    let t82 = t73 * t76 + Ic2 * (t46 * t81);
    let Iy = p.Iy;
    let Ix = p.Ix;
    let t83 = cos_thA * u_psiA;
    let t84 = sin_thA * u_psiA;
    let t85 = t83 * t84;
    let t86 = w_platform_x * w_platform_z;
    let t87 = cos_thA * t85 - sin_thA * (u_thA * u_thA + t83 * t83) + (v_G_z_per_u_hA * t86 + (sin_thA * (w_platform_y * w_platform_y + w_platform_z * w_platform_z) + v_G_y_per_u_hA * t50));
    let t88 = t73 * t85 + Ic2 * (t23 * t87);
    let t89 = cos_thB * u_psiB;
    let t90 = sin_thB * u_psiB;
    let t91 = t89 * t90;
    let t92 = t79 - t78;
    let t93 = cos_thB * t91 - sin_thB * (t40 * t40 + t89 * t89) + (v_G_z_per_u_hA * t92 - (sin_thA * t60 + v_G_y_per_u_hA * t58));
    let t94 = t73 * t91 + Ic2 * (t34 * t93);
    let t95 = Ic3 - Ic2;
    let t96 = u_psiA * u_thA;
    let t97 = sin_thA * t96;
    let t98 = Ic2 - Ic1;
    let t99 = u_thA * t84;
    let t100 = sin_thA * (t95 * (u_thA * t83) - Ic1 * (cos_thA * t96)) + cos_thA * (Ic3 * t97 + t98 * t99);
    let t101 = sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA);
    let u_psiA_dot_bias = t5 * (cos_thA * (t99 + t97) - (v_G_y_per_u_hA * t86 - v_G_z_per_u_hA * t50));
    let t102 = t100 - t101 * u_psiA_dot_bias;
    let t103 = u_thC_per_w_platform_z * t82 - ((Iy - Ix) * t50 + t24 * t88 + t35 * t94) + u_psiA_per_w_platform_z * t102;
    let t104 = u_psiB * t40;
    let t105 = sin_thB * t104;
    let t106 = t40 * t90;
    let t107 = sin_thB * (Ic1 * (cos_thB * t104) - t95 * (t40 * t89)) - cos_thB * (Ic3 * t105 + t98 * t106);
    let t108 = sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB);
    let t109 = t28 * (cos_thB * (t106 + t105) + (t31 * t92 + (t36 * t60 - t38 * t58)));
    let t110 = t107 + t108 * t109;
    let t111 = u_psiC * u_thC;
    let t112 = sin_thC * t111;
    let t113 = u_thC * t75;
    let t114 = sin_thC * (t95 * (u_thC * t74) - Ic1 * (cos_thC * t111)) + cos_thC * (Ic3 * t112 + t98 * t113);
    let t115 = sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC);
    let u_psiC_dot_bias = t43 * (cos_thC * (t113 + t112) - (t44 * t80 + (t38 * t69 - t36 * t77)));
    let t116 = t114 - t115 * u_psiC_dot_bias;
    let t117 = t103 + u_psiB_per_w_platform_z * t110 + u_psiC_per_w_platform_z * t116 + v_G_x_per_w_platform_z * t62 - t65 * t51 - sA * t63;
    let t118 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t119 = Ic2 * t24;
    let t120 = Ic2 * t35;
    let t121 = Ic2 * u_thC_per_w_platform_z;
    let t122 = t101 * u_psiA_per_w_platform_z;
    let t123 = t108 * u_psiB_per_w_platform_z;
    let t124 = Iz + t24 * t119 + t35 * t120 + u_thC_per_w_platform_z * t121 + u_psiA_per_w_platform_z * t122 + u_psiB_per_w_platform_z * t123;
    let t125 = t115 * u_psiC_per_w_platform_z;
    let t126 = sA * (t66 + 2.0_f32 * t65) + (v_G_x_per_w_platform_z * t118 + (t124 + u_psiC_per_w_platform_z * t125));
    let t127 = t117 + t126 * t72;
    let t128 = FA - u_hA * c - t48 + v_G_y_per_u_hA * t63 - t67 * t72 + w_platform_z_per_u_hA * t127;
    let v_G_z_dot_bias = 2.0_f32 * (w_platform_y * u_sA) - sA * t86;
    let t129 = M * (g * v_G_z_per_u_hA) + M * v_G_z_dot_bias;
    let t130 = t37 * t120 + u_thC_per_w_platform_x * t121 - t32 * t123 - t45 * t125;
    let t131 = w_platform_z_per_u_hA * t130;
    let w_platform_x_dot_bias = t17 * (sB * (t78 - t79) - 2.0_f32 * (u_sB * t57) - v_G_z_dot_bias);
    let t132 = u_thC_per_w_platform_x * t82 - ((Iz - Iy) * (w_platform_y * w_platform_z) + t37 * t94) - t32 * t110;
    let t133 = Ix + t37 * (Ic2 * t37) + u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + t32 * (t108 * t32);
    let t134 = t133 + t45 * (t115 * t45);
    let t135 = t132 - t45 * t116 + t130 * t72 - t134 * w_platform_x_dot_bias;
    let t136 = w_platform_x_per_u_hB * t135;
    let t137 = sA * M;
    let t138 = t39 * t120 - u_thA_per_w_platform_y * t119 - t47 * t121 - t14 * t122 - t33 * t123;
    let t139 = t138 + u_psiC_per_w_platform_y * t125;
    let t140 = Ic2 * t39;
    let t141 = Ic2 * t47;
    let t142 = t108 * t33;
    let t143 = t115 * u_psiC_per_w_platform_y;
    let t144 = t37 * t140 - u_thC_per_w_platform_x * t141 + t32 * t142 - t45 * t143;
    let t145 = t18 * t134;
    let t146 = w_platform_x_per_u_hB * (t144 - t145);
    let t147 = v_G_z_per_u_hA * t137 + w_platform_z_per_u_hA * t139 - t146 - t18 * t131;
    let w_platform_y_dot_bias = t20 * (2.0_f32 * (u_sC * t68) + sC * t80 - v_G_z_dot_bias + t15 * w_platform_x_dot_bias);
    let t148 = u_thA_per_w_platform_y * t88 - (Ix - Iz) * t86 - t39 * t94 - t47 * t82 - t14 * t102;
    let t149 = t148 - t33 * t110 + u_psiC_per_w_platform_y * t116 + t139 * t72 - sA * t129 - t144 * w_platform_x_dot_bias;
    let t150 = Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y) + t39 * t140 + t47 * t141 + t14 * (t101 * t14);
    let t151 = sA * t137 + (t150 + t33 * t142 + u_psiC_per_w_platform_y * t143) - t18 * (2.0_f32 * t144 - t145);
    let t152 = t149 - t18 * t135 - t151 * w_platform_y_dot_bias;
    let forcing_u_hA = t128 - v_G_z_per_u_hA * t129 - t131 * w_platform_x_dot_bias - t136 - t147 * w_platform_y_dot_bias - t22 * t152;
    let mr = p.mr;
    let t153 = mc + (ms + mr);
    let t154 = v_G_z_per_u_hA * (M * v_G_z_per_u_hA) + (t153 + v_G_y_per_u_hA * (v_G_y_per_u_hA * t49) + w_platform_z_per_u_hA * (w_platform_z_per_u_hA * t126 - 2.0_f32 * t67));
    let t155 = w_platform_x_per_u_hB * t134;
    let mass_u_hA_u_hA = t154 - w_platform_x_per_u_hB * (2.0_f32 * t131 - t155) - t22 * (2.0_f32 * t147 - t22 * t151);
    let t156 = 1.0_f32 / mass_u_hA_u_hA;
    let t157 = v_G_x_per_u_hB * t64;
    let t158 = v_G_x_per_u_hB * t118 + sA * t157;
    let t159 = t12 * t126;
    let t160 = t12 * t130;
    let t161 = w_platform_z_per_u_hA * (t158 - t159) - v_G_y_per_u_hA * t157 + t67 * t12 - w_platform_x_per_u_hB * (t155 - t160);
    let t162 = t146 - t12 * t139 + t18 * t160;
    let t163 = w_platform_y_per_u_hB * t151;
    let mass_u_hA_u_hB = t161 + w_platform_x_per_u_hB * t131 - t22 * (t162 + t163) + w_platform_y_per_u_hB * t147;
    let t164 = mass_u_hA_u_hB * t156;
    let t165 = t153 + v_G_x_per_u_hB * (M * v_G_x_per_u_hB) - t12 * (2.0_f32 * t158 - t159) + w_platform_x_per_u_hB * (t155 - 2.0_f32 * t160);
    let mass_u_hB_u_hB = t165 + w_platform_y_per_u_hB * (t163 + 2.0_f32 * t162);
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t164;
    let t166 = 1.0_f32 / pivot_1;
    let FB = inputs[1];
    let t167 = FB - u_hB * c - t48 + v_G_x_per_u_hB * t62 - t157 * t51 + t158 * t72;
    let forcing_u_hB = t167 - t12 * t127 + t160 * w_platform_x_dot_bias + t136 - t162 * w_platform_y_dot_bias + w_platform_y_per_u_hB * t152;
    let t168 = forcing_u_hB - forcing_u_hA * t164;
    let t169 = t13 * t126;
    let t170 = t13 * t130;
    let t171 = w_platform_x_per_u_hB * t170;
    let t172 = t18 * t170 - t13 * t139;
    let t173 = w_platform_y_per_u_hC * t151;
    let t174 = t172 + t173;
    let mass_u_hB_u_hC = t12 * t169 - t158 * t13 - t171 + w_platform_y_per_u_hB * t174 + w_platform_y_per_u_hC * t162;
    let mass_u_hA_u_hC = t67 * t13 - w_platform_z_per_u_hA * t169 + t171 - t22 * t174 + w_platform_y_per_u_hC * t147;
    let t175 = mass_u_hB_u_hC - mass_u_hA_u_hC * t164;
    let t176 = t175 * t166;
    let FC = inputs[2];
    let t177 = FC - u_hC * c - t48 - t13 * t127 + t170 * w_platform_x_dot_bias - t172 * w_platform_y_dot_bias;
    let forcing_u_hC = t177 + w_platform_y_per_u_hC * t152;
    let t178 = mass_u_hA_u_hC * t156;
    let mass_u_hC_u_hC = t153 + t13 * t169 + w_platform_y_per_u_hC * (t173 + 2.0_f32 * t172);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t178 - t175 * t176;
    let t179 = (forcing_u_hC - forcing_u_hA * t178 - t176 * t168) / pivot_2;
    let t180 = t166 * t168 - t176 * t179;
    let t181 = forcing_u_hA * t156 - t164 * t180 - t178 * t179;
    let t182 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t4)), Real::abs(t27));
    let t183 = Real::min(Real::min(Real::min(Real::min(t182, Real::abs(t42)), 0.8333333_f32 * Real::abs(t8)), 5.773503_f32 * Real::abs(t16)), 1.6666666_f32 * Real::abs(t19));
    let t184 = Real::min(Real::min(Real::min(t183, 0.21652833_f32 * Real::abs(mass_u_hA_u_hA)), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC], [t181, t180, t179], t184)
}
///Kinetic and potential energy (J).
///
///241 operations.
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
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t2 = cos_thA * sin_psiA;
    let t3 = cos_thA * cos_psiA;
    let t4 = cos_psiB * (0.5_f32 * t2 + 0.8660254_f32 * t3) - sin_psiB * (0.5_f32 * t3 - 0.8660254_f32 * t2);
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t4);
    let t5 = 1.0_f32 / (cos_thA * cos_thA);
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t5;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t6 = 0.57735026_f32 * sin_thC;
    let t7 = 0.57735026_f32 * sin_thB;
    let v_G_y_per_u_hA = t6 - t7;
    let sB = q[7];
    let sC = q[11];
    let sA = q[3];
    let t8 = 1.0_f32 / (2.0_f32 * sB + 2.0_f32 * sC + 2.0_f32 * sA);
    let w_platform_z_per_u_hA = 2.0_f32 * v_G_y_per_u_hA * t8;
    let t9 = 1.7320508_f32 * sin_thA;
    let t10 = v_G_y_per_u_hA - t9;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * (t10 * t8) - u_hC * ((v_G_y_per_u_hA + t9) * t8);
    let t11 = 0.8660254_f32 * sC;
    let t12 = 1.0_f32 / (0.8660254_f32 * sB);
    let t13 = (sA + 0.5_f32 * sB) * t12;
    let t14 = 1.0_f32 / (sA + 0.5_f32 * sC + t11 * t13);
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t14;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t12;
    let t15 = t11 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t15 * t14;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * ((v_G_z_per_u_hA + t15) * t14));
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - (t7 - t6) * t5 * w_platform_y;
    let t16 = 0.5_f32 * (t1 * (u_hA * u_hA)) + 0.5_f32 * ((sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA)) * (u_psiA * u_psiA));
    let Ic2 = p.Ic2;
    let t17 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t17;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t17 * w_platform_z;
    let t18 = 1.0_f32 / (cos_thB * cos_thB);
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t18;
    let t19 = 0.8660254_f32 * sin_thA;
    let t20 = 0.5_f32 * v_G_y_per_u_hA;
    let t21 = t19 - t20;
    let w_platform_x = u_hB * w_platform_x_per_u_hB - u_hA * w_platform_x_per_u_hB - t13 * w_platform_y;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (0.8660254_f32 * t21 * t18 * w_platform_x + 0.5_f32 * t21 * t18 * w_platform_y);
    let t22 = 0.5_f32 * (t1 * (u_hB * u_hB)) + (t16 + 0.5_f32 * (Ic2 * (u_thA * u_thA))) + 0.5_f32 * ((sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB)) * (u_psiB * u_psiB));
    let t23 = 1.0_f32 / cos_thB;
    let t24 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t25 = 0.5_f32 * v_G_z_per_u_hA;
    let t26 = t21 * t23 * w_platform_z + (t24 * t23 * w_platform_x + t25 * t23 * w_platform_y);
    let t27 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t27;
    let t28 = t19 + t20;
    let u_psiC_per_w_platform_y = 0.5_f32 * t28 * t27;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - 0.8660254_f32 * t28 * t27 * w_platform_x);
    let t29 = 0.5_f32 * (t1 * (u_hC * u_hC)) + (t22 + 0.5_f32 * (Ic2 * (t26 * t26))) + 0.5_f32 * ((sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC)) * (u_psiC * u_psiC));
    let t30 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t28 * t30;
    let u_thC_per_w_platform_x = t24 * t30;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t25 * t30 * w_platform_y);
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t31 = t29 + 0.5_f32 * (Ic2 * (u_thC * u_thC)) + 0.5_f32 * (Ix * (w_platform_x * w_platform_x)) + 0.5_f32 * (Iy * (w_platform_y * w_platform_y));
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_u_hB = 0.57735026_f32 * t10;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = u_hB * v_G_x_per_u_hB + v_G_x_per_w_platform_z * w_platform_z - 0.57735026_f32 * v_G_y;
    let t32 = t31 + 0.5_f32 * (Iz * (w_platform_z * w_platform_z)) + 0.5_f32 * (M * (v_G_x * v_G_x)) + 0.5_f32 * (M * (v_G_y * v_G_y));
    let v_G_z = u_hA * v_G_z_per_u_hA + sA * w_platform_y;
    let t33 = t32 + 0.5_f32 * (M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t34 = hA * g;
    let hB = q[4];
    let t35 = hB * g;
    let hC = q[8];
    let t36 = hC * g;
    let t37 = ms * t34 + mc * t34 + ms * t35 + mc * t35 + ms * t36;
    let t38 = t37 + mc * t36 + M * (t34 + sA * (g * sin_thA));
    (t33, t38)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///158 operations.
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
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t1 = cos_thA * sin_psiA;
    let t2 = cos_thA * cos_psiA;
    let t3 = cos_psiB * (0.5_f32 * t1 + 0.8660254_f32 * t2) - sin_psiB * (0.5_f32 * t2 - 0.8660254_f32 * t1);
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t3);
    let t4 = 1.0_f32 / (cos_thA * cos_thA);
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t4;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t5 = 0.57735026_f32 * sin_thC;
    let t6 = 0.57735026_f32 * sin_thB;
    let v_G_y_per_u_hA = t5 - t6;
    let sB = q[7];
    let sC = q[11];
    let sA = q[3];
    let t7 = 1.0_f32 / (2.0_f32 * sB + 2.0_f32 * sC + 2.0_f32 * sA);
    let w_platform_z_per_u_hA = 2.0_f32 * v_G_y_per_u_hA * t7;
    let u_hB = u[1];
    let t8 = 1.7320508_f32 * sin_thA;
    let t9 = v_G_y_per_u_hA - t8;
    let u_hC = u[2];
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * (t9 * t7) - u_hC * ((v_G_y_per_u_hA + t8) * t7);
    let t10 = 0.8660254_f32 * sC;
    let t11 = 1.0_f32 / (0.8660254_f32 * sB);
    let t12 = (sA + 0.5_f32 * sB) * t11;
    let t13 = 1.0_f32 / (sA + 0.5_f32 * sC + t10 * t12);
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t13;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t11;
    let t14 = t10 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t14 * t13;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * ((v_G_z_per_u_hA + t14) * t13));
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - (t6 - t5) * t4 * w_platform_y;
    let t15 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t15;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t15 * w_platform_z;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t16 = 0.57735026_f32 * v_G_y;
    let v_G_x_per_u_hB = 0.57735026_f32 * t9;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t17 = u_hB * v_G_x_per_u_hB + v_G_x_per_w_platform_z * w_platform_z;
    let u_sA = t16 - t17 - u_hA * sin_thA;
    let t18 = 1.0_f32 / (cos_thB * cos_thB);
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t18;
    let t19 = 0.8660254_f32 * sin_thA;
    let t20 = 0.5_f32 * v_G_y_per_u_hA;
    let t21 = t19 - t20;
    let w_platform_x = u_hB * w_platform_x_per_u_hB - u_hA * w_platform_x_per_u_hB - t12 * w_platform_y;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (0.8660254_f32 * t21 * t18 * w_platform_x + 0.5_f32 * t21 * t18 * w_platform_y);
    let t22 = 1.0_f32 / cos_thB;
    let t23 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t24 = 0.5_f32 * v_G_z_per_u_hA;
    let u_thB = -(t21 * t22 * w_platform_z + (t23 * t22 * w_platform_x + t24 * t22 * w_platform_y));
    let v_G_x = t17 - t16;
    let t25 = 2.0_f32 * v_G_x;
    let u_sB_per_u_hB = 2.0_f32 * sin_thA;
    let u_sB = t25 + (u_hB * u_sB_per_u_hB - 1.7320508_f32 * sB * w_platform_z);
    let t26 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t26;
    let t27 = t19 + t20;
    let u_psiC_per_w_platform_y = 0.5_f32 * t27 * t26;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - 0.8660254_f32 * t27 * t26 * w_platform_x);
    let t28 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t27 * t28;
    let u_thC_per_w_platform_x = t23 * t28;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t24 * t28 * w_platform_y);
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let u_sC = t25 + (u_hC * u_sB_per_u_hB + u_sC_per_w_platform_z * w_platform_z);
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC]
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
///471 operations.
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
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t1 = cos_thA * cos_psiA;
    let t2 = cos_thA * sin_psiA;
    let t3 = sin_thA * sin_thA;
    let t4 = 1.0_f32 / Real::sqrt(t3 + (t2 * t2 + t1 * t1));
    let t5 = t2 * t4;
    let t6 = t1 * t4;
    let t7 = 1.0_f32 / (cos_thA * cos_thA);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let t8 = 0.57735026_f32 * sin_thB;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t9 = 0.57735026_f32 * sin_thC;
    let R = p.R;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let t10 = 0.5_f32 * t2 + 0.8660254_f32 * t1;
    let t11 = 0.5_f32 * t1;
    let t12 = 0.8660254_f32 * t2;
    let t13 = t11 - t12;
    let t14 = 1.1547005_f32 * (cos_psiB * t10 - sin_psiB * t13);
    let t15 = sin_thB * t14;
    let t16 = 1.1547005_f32 * (sin_thA * cos_thB + sin_thB * (cos_psiB * t13 + sin_psiB * t10));
    let t17 = sin_psiB * t15 - cos_psiB * t16;
    let t18 = 0.5_f32 * t17;
    let t19 = cos_psiB * t15 + sin_psiB * t16;
    let t20 = 0.8660254_f32 * t19;
    let t21 = t18 - t20;
    let t22 = 0.8660254_f32 * t21;
    let t23 = 0.5_f32 * t19 + 0.8660254_f32 * t17;
    let t24 = 0.5_f32 * t23;
    let v_G_z_per_u_hA = cos_thB * t14;
    let hA = q[0];
    let hC = q[8];
    let sC = q[11];
    let t25 = 0.8660254_f32 * sC;
    let v_G_y_per_u_hA = t9 - t8;
    let t26 = 0.57735026_f32 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t27 = t26 * cos_psiC;
    let t28 = t26 * sin_psiC;
    let t29 = 0.57735026_f32 * cos_thB;
    let t30 = t29 * cos_psiB;
    let t31 = t29 * sin_psiB;
    let t32 = 0.5_f32 * t27 - 0.8660254_f32 * t28 - (0.5_f32 * t30 + 0.8660254_f32 * t31);
    let t33 = sin_thA * t4;
    let t34 = v_G_y_per_u_hA * t6 + t32 * t33;
    let t35 = 0.5_f32 * t31 - 0.8660254_f32 * t30;
    let t36 = 0.8660254_f32 * t27 + 0.5_f32 * t28;
    let t37 = t35 - t36;
    let t38 = t32 * t5 + t37 * t6;
    let t39 = v_G_y_per_u_hA * t5 - t37 * t33;
    let t40 = 1.0_f32 / Real::sqrt(t38 * t38 + (t34 * t34 + t39 * t39));
    let t41 = t34 * t40;
    let t42 = t39 * t40;
    let t43 = t6 * t41 + t5 * t42;
    let t44 = 0.5_f32 * sC;
    let t45 = hA - (hC + (t25 * t43 - t44 * t33));
    let t46 = t38 * t40;
    let t47 = t6 * t46 - t33 * t42;
    let t48 = t44 * t5 - t25 * t47;
    let t49 = t5 * t46 + t33 * t41;
    let t50 = t44 * t6 + t25 * t49;
    let t51 = R * t23;
    let sA = q[3];
    let t52 = sA * (cos_thA * (sin_psiA * (t20 - t18) - cos_psiA * t23) - sin_thA * v_G_z_per_u_hA);
    let t53 = R * (t22 + t24) - (v_G_z_per_u_hA * t45 + (t21 * t48 + t23 * t50) - t51 - t52);
    let t54 = sA * t33;
    let t55 = sA * t5;
    let t56 = sA * t6;
    let t57 = t52 + (v_G_z_per_u_hA * t54 + (t21 * t55 + t23 * t56));
    let sB = q[7];
    let t58 = 0.5_f32 * sB;
    let t59 = 0.8660254_f32 * sB;
    let hB = q[4];
    let t60 = hA + (t58 * t33 + t59 * t43 - hB);
    let t61 = t58 * t5 + t59 * t47;
    let t62 = t59 * t49 - t58 * t6;
    let t63 = R * (t24 - t22) - (v_G_z_per_u_hA * t60 + (t21 * t61 - t23 * t62) - t51 - t52);
    let t64 = 1.0_f32 / t59;
    let t65 = (t63 - t57) * t64;
    let t66 = (sA + t58) * t64;
    let t67 = (t53 - t57 + t25 * t65) * (1.0_f32 / (sA + t44 + t25 * t66));
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t7;
    let t68 = 0.8660254_f32 * t37;
    let t69 = 0.5_f32 * t32;
    let t70 = R * t32;
    let t71 = sA * (cos_thA * (cos_psiA * t32 + sin_psiA * (t36 - t35)) - sin_thA * v_G_y_per_u_hA);
    let t72 = R * (t68 - t69) - (t70 + (v_G_y_per_u_hA * t45 + (t37 * t48 - t32 * t50)) - t71);
    let t73 = R * t1;
    let t74 = sA * (t3 + cos_thA * (cos_psiA * t1 + sin_psiA * t2));
    let t75 = R * (t12 + t11) + (t73 - (sin_thA * t45 + (t2 * t48 + t1 * t50)) - t74);
    let t76 = R * (t68 + t69) + (t70 + (v_G_y_per_u_hA * t60 + (t37 * t61 + t32 * t62)) - t71);
    let t77 = R * (t12 - t11) - (t73 + (t1 * t62 - t2 * t61 - sin_thA * t60) - t74);
    let t78 = 1.7320508_f32 * t77;
    let t79 = t71 - (t32 * t56 - t37 * t55 - v_G_y_per_u_hA * t54);
    let t80 = (t72 + 1.7320508_f32 * t75 - (t76 - t78) - 2.0_f32 * t79) * (1.0_f32 / (2.0_f32 * sB + 2.0_f32 * sC + 2.0_f32 * sA));
    let t81 = (t1 * t5 - t2 * t6) * t7 - (t8 - t9) * t7 * t67 - u_psiA_per_w_platform_z * t80;
    let t82 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t82;
    let t83 = (t33 - sin_thA) * t82 + u_thA_per_w_platform_y * t67 + v_G_y_per_u_hA * t82 * t80;
    let t84 = 0.57735026_f32 * (t79 + sA * t80);
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t85 = 0.57735026_f32 * (t78 - t76) - v_G_x_per_w_platform_z * t80;
    let t86 = t74 - (sin_thA * t54 + (t2 * t55 + t1 * t56)) + (t84 - t85);
    let t87 = cos_thB * cos_psiB;
    let t88 = cos_thB * sin_psiB;
    let t89 = 0.5_f32 * t87 + 0.8660254_f32 * t88;
    let t90 = 0.5_f32 * t5;
    let t91 = 0.8660254_f32 * t47;
    let t92 = 0.8660254_f32 * t87 - 0.5_f32 * t88;
    let t93 = 0.8660254_f32 * t49;
    let t94 = 0.5_f32 * t6;
    let t95 = 1.0_f32 / (cos_thB * cos_thB);
    let t96 = 0.8660254_f32 * sin_thA;
    let t97 = 0.5_f32 * v_G_y_per_u_hA;
    let t98 = t96 - t97;
    let t99 = t65 - t66 * t67;
    let t100 = (t89 * (t90 + t91) - t92 * (t93 - t94)) * t95 - 0.8660254_f32 * t98 * t95 * t99;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t95;
    let t101 = t100 - 0.5_f32 * t98 * t95 * t67 - u_psiB_per_w_platform_z * t80;
    let t102 = 1.0_f32 / cos_thB;
    let t103 = 0.5_f32 * t33;
    let t104 = 0.8660254_f32 * t43;
    let t105 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t106 = 0.5_f32 * v_G_z_per_u_hA;
    let t107 = (sin_thB + (t103 + t104)) * t102 + t105 * t102 * t99 + t106 * t102 * t67;
    let t108 = t98 * t102 * t80 - t107;
    let t109 = 2.0_f32 * (t85 - t84);
    let t110 = t109 + (1.7320508_f32 * sB * t80 - 2.0_f32 * t77);
    let t111 = t96 + t97;
    let t112 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_y = 0.5_f32 * t111 * t112;
    let t113 = cos_thC * sin_psiC;
    let t114 = 0.8660254_f32 * t113;
    let t115 = cos_thC * cos_psiC;
    let t116 = 0.5_f32 * t115;
    let t117 = 0.8660254_f32 * t115 + 0.5_f32 * t113;
    let t118 = ((t114 - t116) * (t90 - t91) + t117 * (t94 + t93)) * t112 + 0.8660254_f32 * t111 * t112 * t99;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t112;
    let t119 = u_psiC_per_w_platform_y * t67 - t118 - u_psiC_per_w_platform_z * t80;
    let t120 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_x = t105 * t120;
    let u_thC_per_w_platform_z = t111 * t120;
    let t121 = u_thC_per_w_platform_x * t99 - (sin_thC + (t103 - t104)) * t120 - t106 * t120 * t67 - u_thC_per_w_platform_z * t80;
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let t122 = 2.0_f32 * t75 - u_sC_per_w_platform_z * t80 + t109;
    let t123 = sA * cos_thA;
    let t124 = sin_psiA * t123;
    let t125 = 0.8660254_f32 * R;
    let t126 = sB * cos_thB;
    let t127 = sin_psiB * t126;
    let t128 = cos_psiB * t126;
    let t129 = R - cos_psiA * t123 + 0.5_f32 * R;
    let t130 = Real::max(Real::abs(t124 + t125 + (0.5_f32 * t127 - 0.8660254_f32 * t128)), Real::abs(t129 - (0.5_f32 * t128 + 0.8660254_f32 * t127)));
    let t131 = sA * sin_thA;
    let t132 = sC * cos_thC;
    let t133 = cos_psiC * t132;
    let t134 = sin_psiC * t132;
    let t135 = Real::max(Real::max(t130, Real::abs(hA - hB + t131 - sB * sin_thB)), Real::abs(t124 - t125 + (0.8660254_f32 * t133 + 0.5_f32 * t134)));
    let t136 = Real::max(Real::max(t135, Real::abs(t129 + (0.8660254_f32 * t134 - 0.5_f32 * t133))), Real::abs(t131 + (hA - hC) - sC * sin_thC));
    let t137 = Real::max(Real::max(t136, Real::abs(t2 + t92 - t117)), Real::abs(t116 - t114 + (t89 - t1)));
    let t138 = Real::max(t137, Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t81, t83, t86, t101, t108, t110, t119, t121, t122], t138)
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
