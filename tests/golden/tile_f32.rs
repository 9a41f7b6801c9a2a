// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 731 operations (12 abs, 140 add, 5 cos, 12 div, 11 min, 431 mul, 5 sin, 115 sub).
// Cost of energy: 234 operations (43 add, 5 cos, 9 div, 156 mul, 5 sin, 16 sub).
// Cost of speeds: 151 operations (20 add, 5 cos, 9 div, 92 mul, 5 sin, 20 sub).
// Cost of outputs: 11 operations (1 add, 2 cos, 5 mul, 2 sin, 1 sub).
// Cost of projection: 512 operations (9 abs, 94 add, 6 cos, 11 div, 8 max, 280 mul, 6 sin, 2 sqrt, 96 sub).

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
///731 operations.
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
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t8 = sA + (sB + sC);
    let t9 = 1.0_f32 / t8;
    let w_platform_z_per_u_hA = v_G_y_per_u_hA * t9;
    let u_hB = u[1];
    let t10 = 0.8660254_f32 * sin_thA;
    let t11 = 0.5_f32 * v_G_y_per_u_hA;
    let t12 = t10 - t11;
    let w_platform_z_per_u_hB = t12 * t9;
    let u_hC = u[2];
    let t13 = t10 + t11;
    let t14 = t13 * t9;
    let w_platform_z = u_hA * w_platform_z_per_u_hA + u_hB * w_platform_z_per_u_hB - u_hC * t14;
    let t15 = (t7 - t6) * t5;
    let t16 = 0.8660254_f32 * sB;
    let t17 = 0.8660254_f32 * sC;
    let t18 = 1.0_f32 / t17;
    let w_platform_x_per_u_hA = v_G_z_per_u_hA * t18;
    let t19 = t16 * w_platform_x_per_u_hA;
    let w_platform_x_per_w_platform_y = (sA + 0.5_f32 * sC) * t18;
    let t20 = sA + 0.5_f32 * sB + t16 * w_platform_x_per_w_platform_y;
    let t21 = 1.0_f32 / t20;
    let w_platform_y_per_u_hC = t19 * t21;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t21;
    let t22 = (v_G_z_per_u_hA + t19) * t21;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * t22);
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - t15 * w_platform_y;
    let t23 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t23;
    let t24 = v_G_y_per_u_hA * t23;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - t24 * w_platform_z;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t25 = 0.57735026_f32 * v_G_y;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t26 = 1.1547005_f32 * t12;
    let t27 = v_G_x_per_w_platform_z * w_platform_z - u_hB * t26;
    let u_sA = t25 - t27 - u_hA * sin_thA;
    let t28 = cos_thB * cos_thB;
    let t29 = 1.0_f32 / t28;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t29;
    let t30 = 0.8660254_f32 * t12 * t29;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y + (u_hA * w_platform_x_per_u_hA - u_hC * w_platform_x_per_u_hA);
    let t31 = 0.5_f32 * t12 * t29;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t30 * w_platform_x + t31 * w_platform_y);
    let t32 = 1.0_f32 / cos_thB;
    let t33 = t12 * t32;
    let t34 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t35 = t34 * t32;
    let t36 = 0.5_f32 * v_G_z_per_u_hA;
    let t37 = t36 * t32;
    let t38 = t33 * w_platform_z + (t35 * w_platform_x + t37 * w_platform_y);
    let u_thB = -t38;
    let t39 = 0.5_f32 * sin_thA;
    let t40 = 0.8660254_f32 * v_G_y_per_u_hA;
    let u_sB_per_u_hB = t39 + t40;
    let v_G_x = t27 - t25;
    let t41 = 0.5_f32 * v_G_x;
    let t42 = 0.8660254_f32 * v_G_y;
    let u_sB = u_hB * u_sB_per_u_hB + t41 - t42;
    let t43 = cos_thC * cos_thC;
    let t44 = 1.0_f32 / t43;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t44;
    let u_psiC_per_w_platform_y = 0.5_f32 * t13 * t44;
    let t45 = 0.8660254_f32 * t13 * t44;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - t45 * w_platform_x);
    let t46 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t13 * t46;
    let u_thC_per_w_platform_x = t34 * t46;
    let t47 = t36 * t46;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t47 * w_platform_y);
    let u_sC_per_u_hC = t39 - t40;
    let u_sC = t42 + (u_hC * u_sC_per_u_hC + t41);
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
    let t52 = 0.8660254_f32 * w_platform_y;
    let t53 = 0.5_f32 * w_platform_x;
    let t54 = t52 - t53;
    let t55 = 0.8660254_f32 * w_platform_x;
    let t56 = 0.5_f32 * w_platform_y;
    let t57 = t55 + t56;
    let t58 = t54 * t57;
    let t59 = sB * t58;
    let t60 = 2.0_f32 * (w_platform_z * u_sB);
    let t61 = M * (g * sin_thA) + M * (1.1547005_f32 * (t59 - t60));
    let t62 = t49 * t51 - (M * (g * v_G_y_per_u_hA) + 0.57735026_f32 * t61);
    let t63 = 0.57735026_f32 * M;
    let t64 = v_G_x_per_w_platform_z * t63;
    let t65 = sA * t49;
    let t66 = v_G_y_per_u_hA * (t64 + t65);
    let t67 = t53 + t52;
    let t68 = t55 - t56;
    let t69 = t67 * t68;
    let w_platform_z_dot_bias = t9 * (sC * t69 - 2.0_f32 * (w_platform_z * u_sC) - (t60 - t59) - t51);
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t70 = Ic1 - Ic3;
    let t71 = cos_thC * u_psiC;
    let t72 = sin_thC * u_psiC;
    let t73 = t71 * t72;
    let Ic2 = p.Ic2;
    let t74 = w_platform_z * w_platform_z;
    let t75 = w_platform_z * t67;
    let t76 = cos_thC * t73 - sin_thC * (u_thC * u_thC + t71 * t71) + (t13 * t69 - u_sC_per_u_hC * (t74 + t68 * t68) - v_G_z_per_u_hA * t75);
    let t77 = t70 * t73 + Ic2 * (t46 * t76);
    let Iy = p.Iy;
    let Ix = p.Ix;
    let t78 = cos_thA * u_psiA;
    let t79 = sin_thA * u_psiA;
    let t80 = t78 * t79;
    let t81 = w_platform_x * w_platform_z;
    let t82 = cos_thA * t80 - sin_thA * (u_thA * u_thA + t78 * t78) + (v_G_z_per_u_hA * t81 + (sin_thA * (w_platform_y * w_platform_y + t74) + v_G_y_per_u_hA * t50));
    let t83 = t70 * t80 + Ic2 * (t23 * t82);
    let t84 = cos_thB * u_psiB;
    let t85 = sin_thB * u_psiB;
    let t86 = t84 * t85;
    let t87 = w_platform_z * t54;
    let t88 = cos_thB * t86 - sin_thB * (t38 * t38 + t84 * t84) + (v_G_z_per_u_hA * t87 - (u_sB_per_u_hB * (t74 + t57 * t57) + t12 * t58));
    let t89 = t70 * t86 + Ic2 * (t32 * t88);
    let t90 = Ic3 - Ic2;
    let t91 = u_psiA * u_thA;
    let t92 = sin_thA * t91;
    let t93 = Ic2 - Ic1;
    let t94 = u_thA * t79;
    let t95 = sin_thA * (t90 * (u_thA * t78) - Ic1 * (cos_thA * t91)) + cos_thA * (Ic3 * t92 + t93 * t94);
    let t96 = sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA);
    let u_psiA_dot_bias = t5 * (cos_thA * (t94 + t92) - (v_G_y_per_u_hA * t81 - v_G_z_per_u_hA * t50));
    let t97 = t95 - t96 * u_psiA_dot_bias;
    let t98 = u_thC_per_w_platform_z * t77 - ((Iy - Ix) * t50 + t24 * t83 + t33 * t89) + u_psiA_per_w_platform_z * t97;
    let t99 = u_psiB * t38;
    let t100 = sin_thB * t99;
    let t101 = t38 * t85;
    let t102 = sin_thB * (Ic1 * (cos_thB * t99) - t90 * (t38 * t84)) - cos_thB * (Ic3 * t100 + t93 * t101);
    let t103 = sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB);
    let t104 = t102 + t103 * (t29 * (cos_thB * (t101 + t100) + (v_G_z_per_u_hA * t58 + t12 * t87)));
    let t105 = u_psiC * u_thC;
    let t106 = sin_thC * t105;
    let t107 = u_thC * t72;
    let t108 = sin_thC * (t90 * (u_thC * t71) - Ic1 * (cos_thC * t105)) + cos_thC * (Ic3 * t106 + t93 * t107);
    let t109 = sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC);
    let u_psiC_dot_bias = t44 * (cos_thC * (t107 + t106) - (v_G_z_per_u_hA * t69 + t13 * t75));
    let t110 = t108 - t109 * u_psiC_dot_bias;
    let t111 = t98 + u_psiB_per_w_platform_z * t104 + u_psiC_per_w_platform_z * t110 + v_G_x_per_w_platform_z * t61 - t64 * t51 - sA * t62;
    let t112 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t113 = Ic2 * t24;
    let t114 = Ic2 * t33;
    let t115 = Ic2 * u_thC_per_w_platform_z;
    let t116 = t96 * u_psiA_per_w_platform_z;
    let t117 = t103 * u_psiB_per_w_platform_z;
    let t118 = Iz + t24 * t113 + t33 * t114 + u_thC_per_w_platform_z * t115 + u_psiA_per_w_platform_z * t116 + u_psiB_per_w_platform_z * t117;
    let t119 = t109 * u_psiC_per_w_platform_z;
    let t120 = sA * (t65 + 2.0_f32 * t64) + (v_G_x_per_w_platform_z * t112 + (t118 + u_psiC_per_w_platform_z * t119));
    let t121 = t111 - t120 * w_platform_z_dot_bias;
    let t122 = FA - u_hA * c - t48 + v_G_y_per_u_hA * t62 + t66 * w_platform_z_dot_bias + w_platform_z_per_u_hA * t121;
    let v_G_z_dot_bias = 2.0_f32 * (w_platform_y * u_sA) - sA * t81;
    let t123 = M * (g * v_G_z_per_u_hA) + M * v_G_z_dot_bias;
    let t124 = t35 * t114 + u_thC_per_w_platform_x * t115 - t30 * t117 - t45 * t119;
    let t125 = w_platform_z_per_u_hA * t124;
    let t126 = t18 * (2.0_f32 * (u_sC * t68) + sC * t75 - v_G_z_dot_bias);
    let t127 = u_thC_per_w_platform_x * t77 - ((Iz - Iy) * (w_platform_y * w_platform_z) + t35 * t89) - t30 * t104;
    let t128 = Ix + t35 * (Ic2 * t35) + u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + t30 * (t103 * t30);
    let t129 = t128 + t45 * (t109 * t45);
    let t130 = t127 - t45 * t110 - t124 * w_platform_z_dot_bias + t129 * t126;
    let t131 = w_platform_x_per_u_hA * t130;
    let t132 = sA * M;
    let t133 = t37 * t114 - u_thA_per_w_platform_y * t113 - t47 * t115 - t15 * t116 - t31 * t117;
    let t134 = t133 + u_psiC_per_w_platform_y * t119;
    let t135 = Ic2 * t37;
    let t136 = Ic2 * t47;
    let t137 = t103 * t31;
    let t138 = t109 * u_psiC_per_w_platform_y;
    let t139 = t35 * t135 - u_thC_per_w_platform_x * t136 + t30 * t137 - t45 * t138;
    let t140 = w_platform_x_per_w_platform_y * t129;
    let t141 = w_platform_x_per_u_hA * (t139 + t140);
    let t142 = v_G_z_per_u_hA * t132 + w_platform_z_per_u_hA * t134 + t141 + w_platform_x_per_w_platform_y * t125;
    let w_platform_y_dot_bias = t21 * (t16 * t126 - (2.0_f32 * (u_sB * t57) + sB * t87 + v_G_z_dot_bias));
    let t143 = u_thA_per_w_platform_y * t83 - (Ix - Iz) * t81 - t37 * t89 - t47 * t77 - t15 * t97;
    let t144 = t143 - t31 * t104 + u_psiC_per_w_platform_y * t110 - t134 * w_platform_z_dot_bias - sA * t123 + t139 * t126;
    let t145 = Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y) + t37 * t135 + t47 * t136 + t15 * (t96 * t15);
    let t146 = sA * t132 + (t145 + t31 * t137 + u_psiC_per_w_platform_y * t138) + w_platform_x_per_w_platform_y * (t140 + 2.0_f32 * t139);
    let t147 = t144 + w_platform_x_per_w_platform_y * t130 - t146 * w_platform_y_dot_bias;
    let forcing_u_hA = t122 - v_G_z_per_u_hA * t123 + t125 * t126 + t131 - t142 * w_platform_y_dot_bias - t22 * t147;
    let mr = p.mr;
    let t148 = mc + (ms + mr);
    let t149 = v_G_z_per_u_hA * (M * v_G_z_per_u_hA) + (t148 + v_G_y_per_u_hA * (v_G_y_per_u_hA * t49) + w_platform_z_per_u_hA * (w_platform_z_per_u_hA * t120 - 2.0_f32 * t66));
    let t150 = w_platform_x_per_u_hA * t129;
    let mass_u_hA_u_hA = t149 + w_platform_x_per_u_hA * (t150 + 2.0_f32 * t125) - t22 * (2.0_f32 * t142 - t22 * t146);
    let t151 = 1.0_f32 / mass_u_hA_u_hA;
    let t152 = t26 * t63;
    let t153 = w_platform_z_per_u_hB * t120;
    let t154 = t26 * t112 + sA * t152;
    let t155 = w_platform_z_per_u_hB * t124;
    let t156 = w_platform_x_per_u_hA * t155;
    let t157 = w_platform_z_per_u_hB * t134 + w_platform_x_per_w_platform_y * t155;
    let t158 = w_platform_y_per_u_hB * t146;
    let t159 = v_G_y_per_u_hA * t152 + w_platform_z_per_u_hA * (t153 - t154) - t66 * w_platform_z_per_u_hB + t156 - t22 * (t157 + t158);
    let mass_u_hA_u_hB = t159 + w_platform_y_per_u_hB * t142;
    let t160 = mass_u_hA_u_hB * t151;
    let mass_u_hB_u_hB = t148 + t26 * (M * t26) + w_platform_z_per_u_hB * (t153 - 2.0_f32 * t154) + w_platform_y_per_u_hB * (t158 + 2.0_f32 * t157);
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t160;
    let t161 = 1.0_f32 / pivot_1;
    let FB = inputs[1];
    let t162 = FB - u_hB * c - t48 - t26 * t61 + t152 * t51 + t154 * w_platform_z_dot_bias;
    let forcing_u_hB = t162 + w_platform_z_per_u_hB * t121 + t155 * t126 - t157 * w_platform_y_dot_bias + w_platform_y_per_u_hB * t147;
    let t163 = forcing_u_hB - forcing_u_hA * t160;
    let t164 = t14 * t120;
    let t165 = w_platform_y_per_u_hC * t146;
    let t166 = t14 * t124;
    let t167 = t14 * t134 + t141 + w_platform_x_per_w_platform_y * t166;
    let t168 = t165 - t167;
    let mass_u_hB_u_hC = t154 * t14 - w_platform_z_per_u_hB * t164 - t156 + w_platform_y_per_u_hB * t168 + w_platform_y_per_u_hC * t157;
    let t169 = t66 * t14 - w_platform_z_per_u_hA * t164 - w_platform_x_per_u_hA * (t166 + t150) - w_platform_x_per_u_hA * t125 - t22 * t168;
    let mass_u_hA_u_hC = t169 + w_platform_y_per_u_hC * t142;
    let t170 = mass_u_hB_u_hC - mass_u_hA_u_hC * t160;
    let t171 = t170 * t161;
    let FC = inputs[2];
    let t172 = FC - u_hC * c - t48 - t14 * t121 - t166 * t126 - t131 + t167 * w_platform_y_dot_bias;
    let forcing_u_hC = t172 + w_platform_y_per_u_hC * t147;
    let t173 = mass_u_hA_u_hC * t151;
    let mass_u_hC_u_hC = t148 + t14 * t164 + w_platform_x_per_u_hA * (t150 + 2.0_f32 * t166) + w_platform_y_per_u_hC * (t165 - 2.0_f32 * t167);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t173 - t170 * t171;
    let t174 = (forcing_u_hC - forcing_u_hA * t173 - t171 * t163) / pivot_2;
    let t175 = t161 * t163 - t171 * t174;
    let t176 = forcing_u_hA * t151 - t160 * t175 - t173 * t174;
    let t177 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t4)), Real::abs(t28));
    let t178 = Real::min(Real::min(Real::min(t177, Real::abs(t43)), 1.6666666_f32 * Real::min(Real::abs(t8), Real::abs(t20))), 5.773503_f32 * Real::abs(t17));
    let t179 = Real::min(Real::min(Real::min(t178, 0.21652833_f32 * Real::abs(mass_u_hA_u_hA)), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC], [t176, t175, t174], t179)
}
///Kinetic and potential energy (J).
///
///234 operations.
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
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t8 = 1.0_f32 / (sA + (sB + sC));
    let w_platform_z_per_u_hA = v_G_y_per_u_hA * t8;
    let t9 = 0.8660254_f32 * sin_thA;
    let t10 = 0.5_f32 * v_G_y_per_u_hA;
    let t11 = t9 - t10;
    let w_platform_z_per_u_hB = t11 * t8;
    let t12 = t9 + t10;
    let w_platform_z = u_hA * w_platform_z_per_u_hA + u_hB * w_platform_z_per_u_hB - u_hC * (t12 * t8);
    let t13 = 0.8660254_f32 * sB;
    let t14 = 1.0_f32 / (0.8660254_f32 * sC);
    let w_platform_x_per_u_hA = v_G_z_per_u_hA * t14;
    let t15 = t13 * w_platform_x_per_u_hA;
    let w_platform_x_per_w_platform_y = (sA + 0.5_f32 * sC) * t14;
    let t16 = 1.0_f32 / (sA + 0.5_f32 * sB + t13 * w_platform_x_per_w_platform_y);
    let w_platform_y_per_u_hC = t15 * t16;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t16;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * ((v_G_z_per_u_hA + t15) * t16));
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - (t7 - t6) * t5 * w_platform_y;
    let t17 = 0.5_f32 * (t1 * (u_hA * u_hA)) + 0.5_f32 * ((sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA)) * (u_psiA * u_psiA));
    let Ic2 = p.Ic2;
    let t18 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t18;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t18 * w_platform_z;
    let t19 = 1.0_f32 / (cos_thB * cos_thB);
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t19;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y + (u_hA * w_platform_x_per_u_hA - u_hC * w_platform_x_per_u_hA);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (0.8660254_f32 * t11 * t19 * w_platform_x + 0.5_f32 * t11 * t19 * w_platform_y);
    let t20 = 0.5_f32 * (t1 * (u_hB * u_hB)) + (t17 + 0.5_f32 * (Ic2 * (u_thA * u_thA))) + 0.5_f32 * ((sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB)) * (u_psiB * u_psiB));
    let t21 = 1.0_f32 / cos_thB;
    let t22 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t23 = 0.5_f32 * v_G_z_per_u_hA;
    let t24 = t11 * t21 * w_platform_z + (t22 * t21 * w_platform_x + t23 * t21 * w_platform_y);
    let t25 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t25;
    let u_psiC_per_w_platform_y = 0.5_f32 * t12 * t25;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - 0.8660254_f32 * t12 * t25 * w_platform_x);
    let t26 = 0.5_f32 * (t1 * (u_hC * u_hC)) + (t20 + 0.5_f32 * (Ic2 * (t24 * t24))) + 0.5_f32 * ((sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC)) * (u_psiC * u_psiC));
    let t27 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t12 * t27;
    let u_thC_per_w_platform_x = t22 * t27;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t23 * t27 * w_platform_y);
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t28 = t26 + 0.5_f32 * (Ic2 * (u_thC * u_thC)) + 0.5_f32 * (Ix * (w_platform_x * w_platform_x)) + 0.5_f32 * (Iy * (w_platform_y * w_platform_y));
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z - u_hB * (1.1547005_f32 * t11) - 0.57735026_f32 * v_G_y;
    let t29 = t28 + 0.5_f32 * (Iz * (w_platform_z * w_platform_z)) + 0.5_f32 * (M * (v_G_x * v_G_x)) + 0.5_f32 * (M * (v_G_y * v_G_y));
    let v_G_z = u_hA * v_G_z_per_u_hA + sA * w_platform_y;
    let t30 = t29 + 0.5_f32 * (M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t31 = hA * g;
    let hB = q[4];
    let t32 = hB * g;
    let hC = q[8];
    let t33 = hC * g;
    let t34 = ms * t31 + mc * t31 + ms * t32 + mc * t32 + ms * t33;
    let t35 = t34 + mc * t33 + M * (t31 + sin_thA * (sA * g));
    (t30, t35)
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
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t7 = 1.0_f32 / (sA + (sB + sC));
    let w_platform_z_per_u_hA = v_G_y_per_u_hA * t7;
    let u_hB = u[1];
    let t8 = 0.8660254_f32 * sin_thA;
    let t9 = 0.5_f32 * v_G_y_per_u_hA;
    let t10 = t8 - t9;
    let w_platform_z_per_u_hB = t10 * t7;
    let u_hC = u[2];
    let t11 = t8 + t9;
    let w_platform_z = u_hA * w_platform_z_per_u_hA + u_hB * w_platform_z_per_u_hB - u_hC * (t11 * t7);
    let t12 = 0.8660254_f32 * sB;
    let t13 = 1.0_f32 / (0.8660254_f32 * sC);
    let w_platform_x_per_u_hA = v_G_z_per_u_hA * t13;
    let t14 = t12 * w_platform_x_per_u_hA;
    let w_platform_x_per_w_platform_y = (sA + 0.5_f32 * sC) * t13;
    let t15 = 1.0_f32 / (sA + 0.5_f32 * sB + t12 * w_platform_x_per_w_platform_y);
    let w_platform_y_per_u_hC = t14 * t15;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t15;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * ((v_G_z_per_u_hA + t14) * t15));
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - (t6 - t5) * t4 * w_platform_y;
    let t16 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t16;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t16 * w_platform_z;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t17 = 0.57735026_f32 * v_G_y;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t18 = v_G_x_per_w_platform_z * w_platform_z - u_hB * (1.1547005_f32 * t10);
    let u_sA = t17 - t18 - u_hA * sin_thA;
    let t19 = 1.0_f32 / (cos_thB * cos_thB);
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t19;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y + (u_hA * w_platform_x_per_u_hA - u_hC * w_platform_x_per_u_hA);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (0.8660254_f32 * t10 * t19 * w_platform_x + 0.5_f32 * t10 * t19 * w_platform_y);
    let t20 = 1.0_f32 / cos_thB;
    let t21 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t22 = 0.5_f32 * v_G_z_per_u_hA;
    let u_thB = -(t10 * t20 * w_platform_z + (t21 * t20 * w_platform_x + t22 * t20 * w_platform_y));
    let t23 = 0.5_f32 * sin_thA;
    let t24 = 0.8660254_f32 * v_G_y_per_u_hA;
    let u_sB_per_u_hB = t23 + t24;
    let v_G_x = t18 - t17;
    let t25 = 0.5_f32 * v_G_x;
    let t26 = 0.8660254_f32 * v_G_y;
    let u_sB = u_hB * u_sB_per_u_hB + t25 - t26;
    let t27 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t27;
    let u_psiC_per_w_platform_y = 0.5_f32 * t11 * t27;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - 0.8660254_f32 * t11 * t27 * w_platform_x);
    let t28 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t11 * t28;
    let u_thC_per_w_platform_x = t21 * t28;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t22 * t28 * w_platform_y);
    let u_sC_per_u_hC = t23 - t24;
    let u_sC = t26 + (u_hC * u_sC_per_u_hC + t25);
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///11 operations.
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
    let sA = q[3];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t1 = sA * (cos_thA * sin_psiA);
    let R = p.R;
    let t2 = R - sA * (cos_thA * cos_psiA);
    let hA = q[0];
    let t3 = hA + sA * sin_thA;
    [t1, t2, t3]
}
///Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them.
///
///512 operations.
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
    let t10 = 0.5_f32 * t2;
    let t11 = 0.8660254_f32 * t1;
    let t12 = t10 + t11;
    let t13 = 0.5_f32 * t1;
    let t14 = 0.8660254_f32 * t2;
    let t15 = t13 - t14;
    let t16 = 1.1547005_f32 * (cos_psiB * t12 - sin_psiB * t15);
    let t17 = sin_thB * t16;
    let t18 = 1.1547005_f32 * (sin_thA * cos_thB + sin_thB * (cos_psiB * t15 + sin_psiB * t12));
    let t19 = cos_psiB * t17 + sin_psiB * t18;
    let t20 = sin_psiB * t17 - cos_psiB * t18;
    let t21 = 0.5_f32 * t19 + 0.8660254_f32 * t20;
    let t22 = 0.5_f32 * t21;
    let t23 = 0.5_f32 * t20;
    let t24 = 0.8660254_f32 * t19;
    let t25 = t23 - t24;
    let t26 = 0.8660254_f32 * t25;
    let v_G_z_per_u_hA = cos_thB * t16;
    let hA = q[0];
    let sB = q[7];
    let t27 = 0.5_f32 * sB;
    let t28 = sin_thA * t4;
    let t29 = 0.8660254_f32 * sB;
    let v_G_y_per_u_hA = t9 - t8;
    let t30 = 0.57735026_f32 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t31 = t30 * cos_psiC;
    let t32 = t30 * sin_psiC;
    let t33 = 0.57735026_f32 * cos_thB;
    let t34 = t33 * cos_psiB;
    let t35 = t33 * sin_psiB;
    let t36 = 0.5_f32 * t31 - 0.8660254_f32 * t32 - (0.5_f32 * t34 + 0.8660254_f32 * t35);
    let t37 = v_G_y_per_u_hA * t6 + t36 * t28;
    let t38 = 0.5_f32 * t35 - 0.8660254_f32 * t34;
    let t39 = 0.8660254_f32 * t31 + 0.5_f32 * t32;
    let t40 = t38 - t39;
    let t41 = t36 * t5 + t40 * t6;
    let t42 = v_G_y_per_u_hA * t5 - t40 * t28;
    let t43 = 1.0_f32 / Real::sqrt(t41 * t41 + (t37 * t37 + t42 * t42));
    let t44 = t37 * t43;
    let t45 = t42 * t43;
    let t46 = t6 * t44 + t5 * t45;
    let hB = q[4];
    let t47 = hA + (t27 * t28 + t29 * t46 - hB);
    let t48 = t41 * t43;
    let t49 = t6 * t48 - t28 * t45;
    let t50 = t27 * t5 + t29 * t49;
    let t51 = t5 * t48 + t28 * t44;
    let t52 = t29 * t51 - t27 * t6;
    let t53 = R * t21;
    let sA = q[3];
    let t54 = sA * (cos_thA * (sin_psiA * (t24 - t23) - cos_psiA * t21) - sin_thA * v_G_z_per_u_hA);
    let t55 = R * (t22 - t26) - (v_G_z_per_u_hA * t47 + (t25 * t50 - t21 * t52) - t53 - t54);
    let t56 = sA * t28;
    let t57 = sA * t5;
    let t58 = sA * t6;
    let t59 = t54 + (v_G_z_per_u_hA * t56 + (t25 * t57 + t21 * t58));
    let hC = q[8];
    let sC = q[11];
    let t60 = 0.8660254_f32 * sC;
    let t61 = 0.5_f32 * sC;
    let t62 = hA - (hC + (t60 * t46 - t61 * t28));
    let t63 = t61 * t5 - t60 * t49;
    let t64 = t61 * t6 + t60 * t51;
    let t65 = R * (t26 + t22) - (v_G_z_per_u_hA * t62 + (t25 * t63 + t21 * t64) - t53 - t54);
    let t66 = 1.0_f32 / t60;
    let t67 = (t65 - t59) * t66;
    let w_platform_x_per_w_platform_y = (sA + t61) * t66;
    let t68 = (t55 - t59 + t29 * t67) * (1.0_f32 / (sA + t27 + t29 * w_platform_x_per_w_platform_y));
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t7;
    let t69 = t36 * t58 - t40 * t57 - v_G_y_per_u_hA * t56;
    let t70 = sA * (cos_thA * (cos_psiA * t36 + sin_psiA * (t39 - t38)) - sin_thA * v_G_y_per_u_hA);
    let t71 = 0.8660254_f32 * sin_thA;
    let t72 = 0.5_f32 * v_G_y_per_u_hA;
    let t73 = t71 - t72;
    let t74 = 0.5_f32 * t40;
    let t75 = t14 - t74;
    let t76 = 0.5_f32 * t36;
    let t77 = t11 + t76;
    let t78 = t73 * t47 + (t75 * t50 - t77 * t52) - R * t77 - sA * (cos_thA * (sin_psiA * (t74 - t14) - cos_psiA * t77) - sin_thA * t73);
    let t79 = R * (0.5_f32 * t77 - 0.8660254_f32 * t75);
    let t80 = t14 + t74;
    let t81 = t11 - t76;
    let t82 = t71 + t72;
    let t83 = R * t81 - (t82 * t62 + (t80 * t63 + t81 * t64)) - sA * (sin_thA * t82 + cos_thA * (cos_psiA * t81 + sin_psiA * t80));
    let t84 = t69 - t70 + (t78 - t79 + (R * (0.8660254_f32 * t80 + 0.5_f32 * t81) + t83));
    let t85 = t84 * (1.0_f32 / (sA + (sB + sC)));
    let t86 = (t1 * t5 - t2 * t6) * t7 - (t8 - t9) * t7 * t68 - u_psiA_per_w_platform_z * t85;
    let t87 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t87;
    let t88 = (t28 - sin_thA) * t87 + u_thA_per_w_platform_y * t68 + v_G_y_per_u_hA * t87 * t85;
    let t89 = sA * (t3 + cos_thA * (cos_psiA * t1 + sin_psiA * t2)) - (sin_thA * t56 + (t2 * t57 + t1 * t58));
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t90 = t70 - t69 + sA * t85;
    let t91 = 1.1547005_f32 * (t79 - t78) + v_G_x_per_w_platform_z * t85 + 0.57735026_f32 * t90;
    let t92 = t89 + t91;
    let t93 = cos_thB * cos_psiB;
    let t94 = cos_thB * sin_psiB;
    let t95 = 0.5_f32 * t93 + 0.8660254_f32 * t94;
    let t96 = 0.5_f32 * t5;
    let t97 = 0.8660254_f32 * t49;
    let t98 = 0.8660254_f32 * t93 - 0.5_f32 * t94;
    let t99 = 0.8660254_f32 * t51;
    let t100 = 0.5_f32 * t6;
    let t101 = 1.0_f32 / (cos_thB * cos_thB);
    let t102 = w_platform_x_per_w_platform_y * t68 - t67;
    let t103 = (t95 * (t96 + t97) - t98 * (t99 - t100)) * t101 - 0.8660254_f32 * t73 * t101 * t102;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t101;
    let t104 = t103 - 0.5_f32 * t73 * t101 * t68 - u_psiB_per_w_platform_z * t85;
    let t105 = 1.0_f32 / cos_thB;
    let t106 = 0.5_f32 * t28;
    let t107 = 0.8660254_f32 * t46;
    let t108 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t109 = 0.5_f32 * v_G_z_per_u_hA;
    let t110 = (sin_thB + (t106 + t107)) * t105 + t108 * t105 * t102 + t109 * t105 * t68;
    let t111 = t73 * t105 * t85 - t110;
    let t112 = 0.8660254_f32 * t90;
    let t113 = 0.8660254_f32 * t40;
    let t114 = t10 + t113;
    let t115 = 0.8660254_f32 * t36;
    let t116 = t115 - t13;
    let t117 = 0.5_f32 * sin_thA;
    let t118 = 0.8660254_f32 * v_G_y_per_u_hA;
    let u_sB_per_u_hB = t117 + t118;
    let t119 = R * t116 + (u_sB_per_u_hB * t47 + (t114 * t50 + t116 * t52)) - sA * (cos_thA * (cos_psiA * t116 - sin_psiA * t114) - sin_thA * u_sB_per_u_hB);
    let t120 = 0.5_f32 * t91;
    let t121 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_y = 0.5_f32 * t82 * t121;
    let t122 = cos_thC * sin_psiC;
    let t123 = 0.8660254_f32 * t122;
    let t124 = cos_thC * cos_psiC;
    let t125 = 0.5_f32 * t124;
    let t126 = 0.8660254_f32 * t124 + 0.5_f32 * t122;
    let t127 = ((t123 - t125) * (t96 - t97) + t126 * (t100 + t99)) * t121 + 0.8660254_f32 * t82 * t121 * t102;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t121;
    let t128 = u_psiC_per_w_platform_y * t68 - t127 - u_psiC_per_w_platform_z * t85;
    let t129 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_x = t108 * t129;
    let u_thC_per_w_platform_z = t82 * t129;
    let t130 = u_thC_per_w_platform_x * t102 - (sin_thC + (t106 - t107)) * t129 - t109 * t129 * t68 - u_thC_per_w_platform_z * t85;
    let t131 = t10 - t113;
    let t132 = t13 + t115;
    let u_sC_per_u_hC = t117 - t118;
    let t133 = u_sC_per_u_hC * t62 + (t131 * t63 + t132 * t64) - R * t132 - sA * (cos_thA * (sin_psiA * (t113 - t10) - cos_psiA * t132) - sin_thA * u_sC_per_u_hC);
    let t134 = R * (0.8660254_f32 * t131 + 0.5_f32 * t132) - t133 - t120 + t112;
    let t135 = sA * cos_thA;
    let t136 = sin_psiA * t135;
    let t137 = 0.8660254_f32 * R;
    let t138 = sB * cos_thB;
    let t139 = sin_psiB * t138;
    let t140 = cos_psiB * t138;
    let t141 = R - cos_psiA * t135 + 0.5_f32 * R;
    let t142 = Real::max(Real::abs(t136 + t137 + (0.5_f32 * t139 - 0.8660254_f32 * t140)), Real::abs(t141 - (0.5_f32 * t140 + 0.8660254_f32 * t139)));
    let t143 = sA * sin_thA;
    let t144 = sC * cos_thC;
    let t145 = cos_psiC * t144;
    let t146 = sin_psiC * t144;
    let t147 = Real::max(Real::max(t142, Real::abs(hA - hB + t143 - sB * sin_thB)), Real::abs(t136 - t137 + (0.8660254_f32 * t145 + 0.5_f32 * t146)));
    let t148 = Real::max(Real::max(t147, Real::abs(t141 + (0.8660254_f32 * t146 - 0.5_f32 * t145))), Real::abs(t143 + (hA - hC) - sC * sin_thC));
    let t149 = Real::max(Real::max(t148, Real::abs(t2 + t98 - t126)), Real::abs(t125 - t123 + (t95 - t1)));
    let t150 = Real::max(t149, Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t86, t88, t92, t104, t111, -(t112 + (R * (0.8660254_f32 * t114 + 0.5_f32 * t116) + t119 + t120)), t128, t130, t134], t150)
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
