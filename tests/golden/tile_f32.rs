// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 715 operations (12 abs, 125 add, 5 cos, 12 div, 11 min, 425 mul, 5 sin, 120 sub).
// Cost of energy: 214 operations (41 add, 5 cos, 9 div, 135 mul, 5 sin, 19 sub).
// Cost of speeds: 151 operations (21 add, 5 cos, 9 div, 94 mul, 5 sin, 17 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 399 operations (9 abs, 74 add, 6 cos, 10 div, 8 max, 216 mul, 6 sin, 1 sqrt, 69 sub).
// Cost of prepare: 20 operations (6 add, 8 mul, 6 sub).

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
#[repr(C)]
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
/// What the functions below need of the parameters, from [`prepare`].
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Prepared {
    ///The parameter `R`.
    pub R: S,
    ///The parameter `ms`.
    pub ms: S,
    ///The parameter `mc`.
    pub mc: S,
    ///The parameter `Ic2`.
    pub Ic2: S,
    ///The parameter `M`.
    pub M: S,
    ///The parameter `Ix`.
    pub Ix: S,
    ///The parameter `Iy`.
    pub Iy: S,
    ///The parameter `Iz`.
    pub Iz: S,
    ///The parameter `c`.
    pub c: S,
    ///The parameter `g`.
    pub g: S,
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
    ///Of parameters alone.
    pub k21: S,
    ///Of parameters alone.
    pub k22: S,
    ///Of parameters alone.
    pub k23: S,
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///20 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let R = p.R;
    let ms = p.ms;
    let mc = p.mc;
    let Ic2 = p.Ic2;
    let M = p.M;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let Iz = p.Iz;
    let c = p.c;
    let g = p.g;
    let t1 = 0.8660254_f32 * R;
    let t2 = 0.5_f32 * R;
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t3 = 0.5_f32 * (Ic1 + Ic2 - Ic3);
    let t4 = ms + mc;
    let t5 = g * t4;
    let t6 = Iz - Iy;
    let t7 = Ix - Iz;
    let t8 = Iy - Ix;
    let mr = p.mr;
    let t9 = mr + t4;
    let t10 = 0.57735026_f32 * M;
    let t11 = 1.3333334_f32 * M;
    let t12 = 0.5_f32 * (Ic1 - (Ic2 + Ic3));
    let t13 = t3 + t12;
    let t14 = 0.5_f32 * (Ic2 - (Ic1 + Ic3));
    Prepared { R, ms, mc, Ic2, M, Ix, Iy, Iz, c, g, k10: t1, k11: t2, k12: t3, k13: t4, k14: t5, k15: t6, k16: t7, k17: t8, k18: t9, k19: t10, k20: t11, k21: t12, k22: t13, k23: t14 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///715 operations.
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
    p: &Prepared,
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
    let k22 = p.k22;
    let k21 = p.k21;
    let k23 = p.k23;
    let t51 = sin_thC * (sin_thC * k22) - k21 - k23;
    let t52 = u_psiC_per_w_platform_z * t51;
    let t53 = sin_thB * (sin_thB * k22) - k21 - k23;
    let t54 = u_psiB_per_w_platform_z * t53;
    let Ic2 = p.Ic2;
    let t55 = Ic2 * u_thC_per_w_platform_z;
    let t56 = Ic2 * t41;
    let t57 = t46 * t52 + (t36 * t54 - (u_thC_per_w_platform_x * t55 + t15 * t56));
    let t58 = t4 * t57;
    let M = p.M;
    let t59 = sA * M;
    let t60 = sin_thA * (sin_thA * k22) - k21 - k23;
    let t61 = u_psiA_per_w_platform_z * t60;
    let t62 = Ic2 * t27;
    let t63 = t37 * t54 + (t24 * t61 - (t40 * t56 + u_thA_per_w_platform_y * t62 - t48 * t55));
    let t64 = u_psiC_per_w_platform_y * t52 - t63;
    let t65 = t37 * t53;
    let t66 = Ic2 * t40;
    let t67 = Ic2 * t48;
    let t68 = u_psiC_per_w_platform_y * t51;
    let t69 = t36 * t65 + (t15 * t66 - u_thC_per_w_platform_x * t67) - t46 * t68;
    let Ix = p.Ix;
    let t70 = t36 * (t36 * t53) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t15 * (Ic2 * t15)));
    let t71 = t46 * (t46 * t51) + t70;
    let t72 = t19 * t71;
    let t73 = w_platform_x_per_u_hB * (t69 - t72);
    let t74 = t19 * t58 - (t59 * v_G_z_per_u_hA - t4 * t64 - t73);
    let Iy = p.Iy;
    let t75 = t24 * (t24 * t60) + (t48 * t67 + (t40 * t66 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t76 = t19 * (2.0_f32 * t69 - t72) - (sA * t59 + (u_psiC_per_w_platform_y * t68 + (t37 * t65 + t75)));
    let t77 = w_platform_x_per_u_hB * t71;
    let k20 = p.k20;
    let t78 = sA * k20;
    let k19 = p.k19;
    let t79 = v_G_x_per_w_platform_z * k19;
    let t80 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t81 = u_psiB_per_w_platform_z * t54 + (u_psiA_per_w_platform_z * t61 + (u_thC_per_w_platform_z * t55 + (t41 * t56 + (Iz + t27 * t62))));
    let t82 = sA * (t78 + 2.0_f32 * t79) + (v_G_x_per_w_platform_z * t80 + (u_psiC_per_w_platform_z * t52 + t81));
    let t83 = (t79 + t78) * t6;
    let k18 = p.k18;
    let t84 = t4 * (t4 * t82 - 2.0_f32 * t83) + (k18 + t6 * (k20 * t6)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t23 * (2.0_f32 * t74 - t23 * t76) + (w_platform_x_per_u_hB * (t77 - 2.0_f32 * t58) + t84);
    let t85 = 1.0_f32 / mass_u_hA_u_hA;
    let t86 = w_platform_y_per_u_hB * t76;
    let t87 = t8 * t57;
    let t88 = t19 * t87 + (t73 + t8 * t64);
    let t89 = k19 * t28;
    let t90 = sA * t89 + t80 * t28;
    let t91 = t8 * t82;
    let t92 = w_platform_x_per_u_hB * (t77 - t87) - (t8 * t83 - (t6 * t89 - t4 * (t90 - t91)));
    let mass_u_hA_u_hB = t23 * (t86 - t88) + (w_platform_x_per_u_hB * t58 - t92) - w_platform_y_per_u_hB * t74;
    let t93 = t85 * mass_u_hA_u_hB;
    let t94 = w_platform_x_per_u_hB * (2.0_f32 * t87 - t77) - (k18 + t28 * (M * t28) - t8 * (2.0_f32 * t90 - t91));
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (2.0_f32 * t88 - t86) - t94;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t93;
    let t95 = 1.0_f32 / pivot_1;
    let t96 = t9 * t57;
    let t97 = w_platform_x_per_u_hB * t96;
    let t98 = t9 * t82;
    let t99 = w_platform_y_per_u_hC * t76;
    let t100 = t19 * t96 + t9 * t64;
    let t101 = t99 + t100;
    let mass_u_hB_u_hC = w_platform_y_per_u_hC * t88 + (t97 + (t9 * t90 - t8 * t98) - w_platform_y_per_u_hB * t101);
    let mass_u_hA_u_hC = t23 * t101 - (t97 - (t4 * t98 - t9 * t83)) - w_platform_y_per_u_hC * t74;
    let t102 = mass_u_hB_u_hC - t93 * mass_u_hA_u_hC;
    let t103 = t95 * t102;
    let t104 = t10 * t30;
    let v_G_z_dot_bias = 2.0_f32 * (w_platform_y * u_sA) - sA * t104;
    let t105 = 0.8660254_f32 * t10;
    let t106 = w_platform_y * t105;
    let t107 = 0.5_f32 * t10;
    let t108 = t30 * t107;
    let t109 = t106 + t108;
    let t110 = 0.5_f32 * w_platform_y;
    let t111 = 0.8660254_f32 * t30;
    let t112 = t110 - t111;
    let t113 = t18 * (v_G_z_dot_bias - (sB * t109 - 2.0_f32 * (u_sB * t112)));
    let t114 = t106 - t108;
    let t115 = t110 + t111;
    let t116 = t21 * (t16 * t113 + (v_G_z_dot_bias + (sC * t114 + 2.0_f32 * (u_sC * t115))));
    let t117 = w_platform_y * t30;
    let t118 = sA * t117 + 2.0_f32 * (t10 * u_sA);
    let t119 = t10 * t107;
    let t120 = w_platform_y * t115 + t119;
    let t121 = t10 * t105;
    let t122 = t30 * t115 + t121;
    let t123 = 1.7320508_f32 * (2.0_f32 * (u_sC * t105) - sC * t120) + (sC * t122 + 2.0_f32 * (u_sC * t107));
    let t124 = t119 + w_platform_y * t112;
    let t125 = t121 - t30 * t112;
    let t126 = 1.7320508_f32 * (sB * t124 + 2.0_f32 * (u_sB * t105)) + (2.0_f32 * (u_sB * t107) - sB * t125);
    let t127 = t2 * (2.0_f32 * t118 + (t123 + t126));
    let t128 = 2.0_f32 * (u_psiC * t50);
    let t129 = sin_thC * t128;
    let u_psiC_dot_bias = t44 * (t45 * t114 - (t39 * t122 - t49 * t120) - cos_thC * t129);
    let k12 = p.k12;
    let t130 = t51 * u_psiC_dot_bias - (sin_thC * (k12 * (cos_thC * t128)) + cos_thC * (k21 * t129));
    let t131 = 2.0_f32 * (u_psiB * u_thB);
    let t132 = sin_thB * t131;
    let t133 = t53 * (t32 * (t39 * t125 - t49 * t124 + t35 * t109 + cos_thB * t132));
    let t134 = t133 + (sin_thB * (k12 * (cos_thB * t131)) + cos_thB * (k21 * t132));
    let t135 = cos_thC * u_psiC;
    let t136 = sin_thC * u_psiC * t135;
    let t137 = v_G_z_per_u_hA * t114 - (t6 * t122 + sin_thA * t120) - (sin_thC * (t135 * t135 + t50 * t50) - cos_thC * t136);
    let t138 = Ic2 * (t47 * t137) + k22 * t136;
    let k15 = p.k15;
    let t139 = cos_thB * u_psiB;
    let t140 = sin_thB * u_psiB * t139;
    let t141 = sin_thB * (t139 * t139 + u_thB * u_thB) - cos_thB * t140 - (t6 * t125 - sin_thA * t124 - v_G_z_per_u_hA * t109);
    let t142 = k22 * t140 - Ic2 * (t38 * t141);
    let t143 = t46 * t130 + (t36 * t134 + (u_thC_per_w_platform_x * t138 + (k15 * (t10 * w_platform_y) - t15 * t142)));
    let t144 = t71 * t113 + (t57 * t127 + t143);
    let g = p.g;
    let t145 = M * (v_G_z_dot_bias + g * v_G_z_per_u_hA);
    let t146 = 2.0_f32 * u_thA;
    let t147 = sin_thA * t25;
    let t148 = t146 * t147;
    let t149 = cos_thA * t25;
    let t150 = t60 * (t12 * (v_G_z_per_u_hA * t117 - t6 * t104 + cos_thA * t148)) + (sin_thA * (k12 * (t146 * t149)) + cos_thA * (k21 * t148));
    let k16 = p.k16;
    let t151 = t147 * t149;
    let t152 = t6 * t117 + sin_thA * (t10 * t10 + w_platform_y * w_platform_y) + v_G_z_per_u_hA * t104 + (cos_thA * t151 - sin_thA * (t149 * t149 + u_thA * u_thA));
    let t153 = Ic2 * (t26 * t152) + k22 * t151;
    let t154 = t24 * t150 + (t48 * t138 + (t40 * t142 + (k16 * t104 - u_thA_per_w_platform_y * t153)));
    let t155 = t69 * t113 - (sA * t145 + (t64 * t127 + (u_psiC_per_w_platform_y * t130 - (t37 * t134 - t154))));
    let t156 = t76 * t116 + (t19 * t144 - t155);
    let t157 = M * (g * sin_thA + 0.57735026_f32 * t126);
    let t158 = k20 * t118 + (0.57735026_f32 * t157 - M * (g * t6));
    let k17 = p.k17;
    let t159 = u_psiA_per_w_platform_z * t150 - (t41 * t142 - (t27 * t153 + k17 * t117) - u_thC_per_w_platform_z * t138);
    let t160 = sA * t158 + (t79 * t118 - (u_psiC_per_w_platform_z * t130 + (u_psiB_per_w_platform_z * t134 - t159) - v_G_x_per_w_platform_z * t157));
    let t161 = t160 - t82 * t127;
    let k14 = p.k14;
    let c = p.c;
    let FA = inputs[0];
    let t162 = t4 * t161 + (t83 * t127 + (k14 + (u_hA * c - FA) - t6 * t158));
    let t163 = w_platform_x_per_u_hB * t144;
    let forcing_u_hA = t23 * t156 - (t74 * t116 - (t58 * t113 - (v_G_z_per_u_hA * t145 + t162) - t163));
    let FB = inputs[1];
    let t164 = t89 * t118 + (t28 * t157 + (k14 + (u_hB * c - FB))) - t90 * t127;
    let t165 = w_platform_y_per_u_hB * t156 + (t87 * t113 + (t164 - t8 * t161) - t163 - t88 * t116);
    let t166 = t93 * forcing_u_hA + t165;
    let t167 = t85 * mass_u_hA_u_hC;
    let FC = inputs[2];
    let t168 = t96 * t113 - (t9 * t161 - (FC - u_hC * c - k14)) - t100 * t116;
    let forcing_u_hC = t168 - w_platform_y_per_u_hC * t156;
    let mass_u_hC_u_hC = k18 + t9 * t98 - w_platform_y_per_u_hC * (t99 + 2.0_f32 * t100);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t167 - t102 * t103;
    let t169 = (t103 * t166 - (t167 * forcing_u_hA - forcing_u_hC)) / pivot_2;
    let t170 = t103 * t169 + t95 * t166;
    let t171 = t93 * t170 + t85 * forcing_u_hA - t167 * t169;
    let t172 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t11)), Real::abs(t31));
    let t173 = Real::min(Real::min(Real::min(Real::min(t172, Real::abs(t43)), 0.8333333_f32 * Real::abs(t1)), 5.773503_f32 * Real::abs(t17)), 1.6666666_f32 * Real::abs(t20));
    let t174 = Real::min(Real::min(Real::min(t173, 0.21652833_f32 * Real::abs(mass_u_hA_u_hA)), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, -t25, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, -t50, u_sC], [t171, -t170, t169], t174)
}
///Kinetic and potential energy (J).
///
///214 operations.
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
    p: &Prepared,
) -> (S, S) {
    let k18 = p.k18;
    let u_hC = u[2];
    let u_hB = u[1];
    let u_hA = u[0];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let k22 = p.k22;
    let k21 = p.k21;
    let k23 = p.k23;
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t1 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC)));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 1.7320508_f32 * sin_thA;
    let t4 = 0.57735026_f32 * t2;
    let t5 = t3 + t4;
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
    let t16 = t6 * u_psiA_per_w_platform_z + w_platform_y * (t7 * t4);
    let t17 = k18 * (u_hA * u_hA) + (sin_thA * (sin_thA * k22) - k21 - k23) * (t16 * t16);
    let Ic2 = p.Ic2;
    let t18 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t18 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t6 * (t18 * t4);
    let t19 = w_platform_x_per_u_hB * (u_hA - u_hB) + t13 * w_platform_y;
    let t20 = 1.0_f32 / (cos_thB * cos_thB);
    let t21 = 0.8660254_f32 * sin_thA;
    let t22 = 0.28867513_f32 * t2;
    let t23 = t21 + t22;
    let u_psiB_per_w_platform_z = t20 * v_G_z_per_u_hA;
    let u_psiB = t19 * (t20 * (0.8660254_f32 * t23)) - w_platform_y * (t20 * (0.5_f32 * t23)) - t6 * u_psiB_per_w_platform_z;
    let t24 = k18 * (u_hB * u_hB) + (t17 + Ic2 * (u_thA * u_thA)) + (sin_thB * (sin_thB * k22) - k21 - k23) * (u_psiB * u_psiB);
    let t25 = 1.0_f32 / cos_thB;
    let t26 = 0.5_f32 * v_G_z_per_u_hA;
    let u_thB = t10 * t19 - w_platform_y * (t25 * t26) + t6 * (t25 * t23);
    let t27 = 1.0_f32 / (cos_thC * cos_thC);
    let t28 = t21 - t22;
    let u_psiC_per_w_platform_y = t27 * (0.5_f32 * t28);
    let u_psiC_per_w_platform_z = t27 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t19 * (t27 * (0.8660254_f32 * t28)) - t6 * u_psiC_per_w_platform_z;
    let t29 = k18 * (u_hC * u_hC) + (t24 + Ic2 * (u_thB * u_thB)) + (sin_thC * (sin_thC * k22) - k21 - k23) * (u_psiC * u_psiC);
    let t30 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_x = t30 * (0.8660254_f32 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t30 * t28;
    let t31 = w_platform_y * (t30 * t26) + t19 * u_thC_per_w_platform_x + t6 * u_thC_per_w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t32 = t29 + Ic2 * (t31 * t31) + Ix * (t19 * t19) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_y = sA * t6 - u_hA * t4;
    let t33 = v_G_x_per_w_platform_z * t6 + u_hB * (0.57735026_f32 * t5) + 0.57735026_f32 * v_G_y;
    let t34 = t32 + Iz * (t6 * t6) + M * (t33 * t33) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t35 = 0.5_f32 * (t34 + M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t36 = hA * g;
    let mc = p.mc;
    let hC = q[8];
    let t37 = hC * g;
    let ms = p.ms;
    let hB = q[4];
    let t38 = hB * g;
    let k13 = p.k13;
    let t39 = mc * t37 + (ms * t37 + (mc * t38 + (ms * t38 + k13 * t36)));
    let t40 = M * (t36 + sA * (g * sin_thA)) + t39;
    (t35, t40)
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
    _p: &Prepared,
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
    p: &Prepared,
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
///399 operations.
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
    p: &Prepared,
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
    let t18 = cos_psiB * t16 + sin_psiB * t14;
    let t19 = 1.1547005_f32 * t18;
    let t20 = sin_thB * t19;
    let t21 = sin_psiB * t17 - cos_psiB * t20;
    let t22 = cos_psiB * t17 + sin_psiB * t20;
    let t23 = 0.8660254_f32 * t22 - 0.5_f32 * t21;
    let t24 = R * t23;
    let t25 = 0.57735026_f32 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t26 = t25 * cos_psiC - cos_thC * sin_psiC;
    let t27 = 0.57735026_f32 * cos_thB;
    let t28 = t27 * cos_psiB + cos_thB * sin_psiB;
    let t29 = t26 - t28;
    let t30 = 0.5_f32 * t29;
    let t31 = sin_thA * t30 - t12 * t3;
    let t32 = cos_thB * cos_psiB - t27 * sin_psiB;
    let t33 = t25 * sin_psiC + cos_thC * cos_psiC;
    let t34 = t32 + t33;
    let t35 = 0.5_f32 * t34;
    let t36 = t10 * t3 - sin_thA * t35;
    let t37 = t10 * t30 - t12 * t35;
    let t38 = 1.0_f32 / Real::sqrt(t36 * t36 + t31 * t31 + t37 * t37);
    let t39 = t31 * t38;
    let t40 = t37 * t38;
    let t41 = sin_thA * t39 + t10 * t40;
    let t42 = t12 * t6 - t7 * t41;
    let t43 = t36 * t38;
    let t44 = t12 * t40 + sin_thA * t43;
    let t45 = t7 * t44 + t10 * t6;
    let t46 = 0.5_f32 * t22 + 0.8660254_f32 * t21;
    let v_G_z_per_u_hA = cos_thB * t19;
    let hA = q[0];
    let t47 = t12 * t39 - t10 * t43;
    let hB = q[4];
    let t48 = hA + (t7 * t47 + sin_thA * t6 - hB);
    let t49 = t8 * (R * t21 - (t24 - (t42 * t23 + t45 * t46 + v_G_z_per_u_hA * t48)));
    let t50 = t5 * t41 + t12 * t4;
    let t51 = t5 * t44 - t10 * t4;
    let hC = q[8];
    let t52 = hC + (t5 * t47 - sin_thA * t4) - hA;
    let t53 = t50 * t23 - t51 * t46 - v_G_z_per_u_hA * t52 - t24 - R * (0.5_f32 * t23 + 0.8660254_f32 * t46);
    let t54 = 1.0_f32 / (sA + t4 + t5 * t9) * (t5 * t49 + t53);
    let u_psiA_per_w_platform_z = t1 * v_G_z_per_u_hA;
    let t55 = sA * t12;
    let t56 = sA * t10;
    let t57 = sA * sin_thA;
    let t58 = sA * (cos_thA * (sin_psiA * t35 + cos_psiA * t30) + sin_thA * t3);
    let t59 = t55 * t30 + t56 * t35 + t57 * t3 - t58;
    let t60 = R * t12;
    let t61 = R * t14 - (t60 - (t12 * t42 + t10 * t45 + sin_thA * t48) - sA);
    let t62 = 0.4330127_f32 * t34;
    let t63 = 0.25_f32 * t29;
    let t64 = R * t30;
    let t65 = R * (t62 - t63) - (t64 - (t30 * t42 + t35 * t45 + t3 * t48) - t58);
    let t66 = 1.7320508_f32 * t61 + t65;
    let t67 = sA - (t60 + (t10 * t51 - t12 * t50 + sin_thA * t52)) - R * (t11 + t13);
    let t68 = t64 - (t30 * t50 - t35 * t51 - t3 * t52) - t58 + R * (t63 + t62);
    let t69 = 1.0_f32 / (2.0_f32 * (sA + (sB + sC))) * (2.0_f32 * t59 + (t66 - (1.7320508_f32 * t67 + t68)));
    let t70 = t1 * t3 * t54 - u_psiA_per_w_platform_z * t69;
    let t71 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t71 * v_G_z_per_u_hA;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t72 = 0.57735026_f32 * (sA * t69 - t59) + (v_G_x_per_w_platform_z * t69 - 0.57735026_f32 * t66);
    let t73 = t72 + (sA - (t12 * t55 + t10 * t56 + sin_thA * t57));
    let t74 = 1.0_f32 / (cos_thB * cos_thB);
    let t75 = 0.8660254_f32 * sin_thA;
    let t76 = 0.28867513_f32 * t2;
    let t77 = t75 + t76;
    let t78 = t49 - t9 * t54;
    let t79 = 0.8660254_f32 * t41;
    let t80 = 0.8660254_f32 * t32;
    let t81 = 0.8660254_f32 * t44;
    let t82 = 0.8660254_f32 * t28;
    let t83 = t74 * (0.8660254_f32 * t77) * t78 + t74 * ((t13 - t79) * t80 + (t15 + t81) * t82);
    let u_psiB_per_w_platform_z = t74 * v_G_z_per_u_hA;
    let t84 = t74 * (0.5_f32 * t77) * t54 + t83 - u_psiB_per_w_platform_z * t69;
    let t85 = 1.0_f32 / cos_thB;
    let t86 = 0.5_f32 * v_G_z_per_u_hA;
    let t87 = 0.5_f32 * sin_thA;
    let t88 = 0.8660254_f32 * t47;
    let t89 = t85 * t77 * t69 + (t85 * t86 * t54 - (t85 * (sin_thB + (t87 + t88)) - t18 * t78));
    let t90 = 2.0_f32 * t72;
    let t91 = 1.7320508_f32 * sB * t69 - 2.0_f32 * t61 - t90;
    let t92 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = t92 * v_G_z_per_u_hA;
    let t93 = t75 - t76;
    let u_psiC_per_w_platform_y = t92 * (0.5_f32 * t93);
    let t94 = 0.8660254_f32 * t33;
    let t95 = 0.8660254_f32 * t26;
    let t96 = t92 * ((t13 + t79) * t94 + (t81 - t15) * t95) - t92 * (0.8660254_f32 * t93) * t78;
    let t97 = 1.0_f32 / cos_thC;
    let u_thC_per_w_platform_z = t97 * t93;
    let u_thC_per_w_platform_x = t97 * (0.8660254_f32 * v_G_z_per_u_hA);
    let t98 = u_thC_per_w_platform_z * t69 + (u_thC_per_w_platform_x * t78 + t97 * (sin_thC + (t87 - t88)) - t97 * t86 * t54);
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let t99 = sA * cos_thA;
    let t100 = sin_psiA * t99;
    let k10 = p.k10;
    let t101 = sB * cos_thB;
    let t102 = sin_psiB * t101;
    let t103 = cos_psiB * t101;
    let k11 = p.k11;
    let t104 = R - cos_psiA * t99 + k11;
    let t105 = Real::max(Real::abs(t100 + k10 + (0.5_f32 * t102 - 0.8660254_f32 * t103)), Real::abs(t104 - (0.5_f32 * t103 + 0.8660254_f32 * t102)));
    let t106 = sC * cos_thC;
    let t107 = cos_psiC * t106;
    let t108 = sin_psiC * t106;
    let t109 = Real::max(Real::max(t105, Real::abs(hA - hB + t57 - sB * sin_thB)), Real::abs(0.8660254_f32 * t107 + 0.5_f32 * t108 - (k10 - t100)));
    let t110 = Real::max(Real::max(t109, Real::abs(t104 + (0.8660254_f32 * t108 - 0.5_f32 * t107))), Real::abs(sC * sin_thC + (hC - hA - t57)));
    let t111 = Real::max(Real::max(Real::max(t110, Real::abs(t10 + t80 - t94)), Real::abs(t95 - (t12 - t82))), Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t70, -(t71 * t3 * t69 + u_thA_per_w_platform_y * t54), t73, t84, t89, t91, -(u_psiC_per_w_platform_z * t69 + (u_psiC_per_w_platform_y * t54 + t96)), -t98, -(t90 + (u_sC_per_w_platform_z * t69 + 2.0_f32 * t67))], t111)
}
///Three-legged tile: screws A, B, C lift connectors; rods at 120 degrees carry the platform.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    parameters: Parameters,
    prepared: Prepared,
}
impl Default for Tile {
    fn default() -> Self {
        Self::new(Parameters::default())
    }
}
impl Tile {
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
