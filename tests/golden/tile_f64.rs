// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 709 operations (12 abs, 128 add, 5 cos, 12 div, 11 min, 422 mul, 5 sin, 114 sub).
// Cost of energy: 209 operations (43 add, 5 cos, 9 div, 134 mul, 5 sin, 13 sub).
// Cost of speeds: 151 operations (21 add, 5 cos, 9 div, 94 mul, 5 sin, 17 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 392 operations (9 abs, 79 add, 6 cos, 10 div, 8 max, 211 mul, 6 sin, 1 sqrt, 62 sub).
// Cost of prepare: 16 operations (5 add, 6 mul, 5 sub).

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f64;
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
pub const NOMINAL: [f64; 12usize] = [
    0f64,
    0f64,
    0f64,
    0.2f64,
    0f64,
    0f64,
    0f64,
    0.2f64,
    0f64,
    0f64,
    0f64,
    0.2f64,
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
    ///The parameter `ms`.
    pub ms: S,
    ///The parameter `mc`.
    pub mc: S,
    ///The parameter `Ic2`.
    pub Ic2: S,
    ///The parameter `Ic3`.
    pub Ic3: S,
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
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///16 operations.
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
    let Ic3 = p.Ic3;
    let M = p.M;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let Iz = p.Iz;
    let c = p.c;
    let g = p.g;
    let t1 = 0.5_f64 * R;
    let Ic1 = p.Ic1;
    let t2 = 0.5_f64 * (Ic1 + Ic2 - Ic3);
    let t3 = ms + mc;
    let t4 = g * t3;
    let t5 = Iz - Iy;
    let t6 = Ix - Iz;
    let t7 = Iy - Ix;
    let mr = p.mr;
    let t8 = mr + t3;
    let t9 = 0.5773502691896257_f64 * M;
    let t10 = 1.3333333333333333_f64 * M;
    let t11 = 0.5_f64 * (Ic1 - (Ic2 + Ic3));
    let t12 = t2 + t11;
    Prepared { R, ms, mc, Ic2, Ic3, M, Ix, Iy, Iz, c, g, k11: t1, k12: t2, k13: t3, k14: t4, k15: t5, k16: t6, k17: t7, k18: t8, k19: t9, k20: t10, k21: t11, k22: t12 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///709 operations.
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
    let t1 = 2.0_f64 * (sA + (sB + sC));
    let t2 = 1.0_f64 / t1;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t3 = sin_thB - sin_thC;
    let t4 = t2 * (1.1547005383792515_f64 * t3);
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t5 = 1.7320508075688772_f64 * sin_thA;
    let t6 = 0.5773502691896257_f64 * t3;
    let t7 = t5 + t6;
    let t8 = t2 * t7;
    let u_hC = u[2];
    let t9 = t2 * (t5 - t6);
    let t10 = u_hA * t4 - u_hB * t8 + u_hC * t9;
    let t11 = cos_thA * cos_thA;
    let t12 = 1.0_f64 / t11;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t13 = cos_thA * sin_psiA;
    let t14 = cos_thA * cos_psiA;
    let t15 = cos_psiB * (0.5_f64 * t13 + 0.8660254037844386_f64 * t14) + sin_psiB * (0.8660254037844386_f64 * t13 - 0.5_f64 * t14);
    let v_G_z_per_u_hA = cos_thB * (1.1547005383792515_f64 * t15);
    let u_psiA_per_w_platform_z = t12 * v_G_z_per_u_hA;
    let t16 = 0.8660254037844386_f64 * sC;
    let t17 = 0.8660254037844386_f64 * sB;
    let t18 = 1.0_f64 / t17;
    let t19 = (sA + 0.5_f64 * sB) * t18;
    let t20 = sA + 0.5_f64 * sC + t16 * t19;
    let t21 = 1.0_f64 / t20;
    let w_platform_x_per_u_hB = t18 * v_G_z_per_u_hA;
    let t22 = t16 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t21 * t22;
    let t23 = t21 * (v_G_z_per_u_hA + t22);
    let w_platform_y_per_u_hC = t21 * v_G_z_per_u_hA;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * t23 + u_hC * w_platform_y_per_u_hC;
    let t24 = t12 * t6;
    let t25 = t10 * u_psiA_per_w_platform_z + w_platform_y * t24;
    let t26 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t26 * v_G_z_per_u_hA;
    let t27 = t26 * t6;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t10 * t27;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t28 = 0.5773502691896257_f64 * t7;
    let v_G_y = sA * t10 - u_hA * t6;
    let t29 = v_G_x_per_w_platform_z * t10 + u_hB * t28 + 0.5773502691896257_f64 * v_G_y;
    let u_sA = t29 - u_hA * sin_thA;
    let t30 = w_platform_x_per_u_hB * (u_hA - u_hB) + t19 * w_platform_y;
    let t31 = cos_thB * cos_thB;
    let t32 = 1.0_f64 / t31;
    let t33 = 0.8660254037844386_f64 * sin_thA;
    let t34 = 0.28867513459481287_f64 * t3;
    let t35 = t33 + t34;
    let t36 = t32 * (0.8660254037844386_f64 * t35);
    let t37 = t32 * (0.5_f64 * t35);
    let u_psiB_per_w_platform_z = t32 * v_G_z_per_u_hA;
    let u_psiB = t30 * t36 - w_platform_y * t37 - t10 * u_psiB_per_w_platform_z;
    let t38 = 1.0_f64 / cos_thB;
    let t39 = 0.5_f64 * v_G_z_per_u_hA;
    let t40 = t38 * t39;
    let t41 = t38 * t35;
    let u_thB = t15 * t30 - w_platform_y * t40 + t10 * t41;
    let u_sB_per_u_hB = 2.0_f64 * sin_thA;
    let t42 = 2.0_f64 * t29;
    let u_sB = u_hB * u_sB_per_u_hB + 1.7320508075688772_f64 * sB * t10 - t42;
    let t43 = cos_thC * cos_thC;
    let t44 = 1.0_f64 / t43;
    let t45 = t33 - t34;
    let u_psiC_per_w_platform_y = t44 * (0.5_f64 * t45);
    let t46 = t44 * (0.8660254037844386_f64 * t45);
    let u_psiC_per_w_platform_z = t44 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t30 * t46 - t10 * u_psiC_per_w_platform_z;
    let t47 = 1.0_f64 / cos_thC;
    let t48 = t47 * t39;
    let t49 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let u_thC_per_w_platform_x = t47 * t49;
    let u_thC_per_w_platform_z = t47 * t45;
    let t50 = w_platform_y * t48 + t30 * u_thC_per_w_platform_x + t10 * u_thC_per_w_platform_z;
    let u_sC_per_w_platform_z = 1.7320508075688772_f64 * sC;
    let u_sC = u_hC * u_sB_per_u_hB - u_sC_per_w_platform_z * t10 - t42;
    let Ic3 = p.Ic3;
    let k22 = p.k22;
    let t51 = Ic3 + sin_thC * (sin_thC * k22);
    let t52 = u_psiC_per_w_platform_z * t51;
    let t53 = Ic3 + sin_thB * (sin_thB * k22);
    let t54 = u_psiB_per_w_platform_z * t53;
    let Ic2 = p.Ic2;
    let t55 = Ic2 * u_thC_per_w_platform_z;
    let t56 = Ic2 * t41;
    let t57 = t46 * t52 + (t36 * t54 - (u_thC_per_w_platform_x * t55 + t15 * t56));
    let t58 = t4 * t57;
    let M = p.M;
    let t59 = sA * M;
    let t60 = Ic3 + sin_thA * (sin_thA * k22);
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
    let t76 = t19 * (2.0_f64 * t69 - t72) - (sA * t59 + (u_psiC_per_w_platform_y * t68 + (t37 * t65 + t75)));
    let t77 = w_platform_x_per_u_hB * t71;
    let k20 = p.k20;
    let t78 = sA * k20;
    let k19 = p.k19;
    let t79 = v_G_x_per_w_platform_z * k19;
    let t80 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t81 = u_psiB_per_w_platform_z * t54 + (u_psiA_per_w_platform_z * t61 + (u_thC_per_w_platform_z * t55 + (t41 * t56 + (Iz + t27 * t62))));
    let t82 = sA * (t78 + 2.0_f64 * t79) + (v_G_x_per_w_platform_z * t80 + (u_psiC_per_w_platform_z * t52 + t81));
    let t83 = (t79 + t78) * t6;
    let k18 = p.k18;
    let t84 = t4 * (t4 * t82 - 2.0_f64 * t83) + (k18 + t6 * (k20 * t6)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t23 * (2.0_f64 * t74 - t23 * t76) + (w_platform_x_per_u_hB * (t77 - 2.0_f64 * t58) + t84);
    let t85 = 1.0_f64 / mass_u_hA_u_hA;
    let t86 = t10 * t30;
    let v_G_z_dot_bias = 2.0_f64 * (w_platform_y * u_sA) - sA * t86;
    let t87 = 0.8660254037844386_f64 * t10;
    let t88 = w_platform_y * t87;
    let t89 = 0.5_f64 * t10;
    let t90 = t30 * t89;
    let t91 = t88 + t90;
    let t92 = 0.5_f64 * w_platform_y;
    let t93 = 0.8660254037844386_f64 * t30;
    let t94 = t92 - t93;
    let t95 = t18 * (v_G_z_dot_bias - (sB * t91 - 2.0_f64 * (u_sB * t94)));
    let t96 = t88 - t90;
    let t97 = t92 + t93;
    let t98 = t21 * (t16 * t95 + (v_G_z_dot_bias + (sC * t96 + 2.0_f64 * (u_sC * t97))));
    let t99 = t10 * t89;
    let t100 = t99 + w_platform_y * t94;
    let t101 = t10 * t87;
    let t102 = t101 - t30 * t94;
    let t103 = 1.7320508075688772_f64 * (sB * t100 + 2.0_f64 * (u_sB * t87)) + (2.0_f64 * (u_sB * t89) - sB * t102);
    let t104 = t101 + t30 * t97;
    let t105 = t99 + w_platform_y * t97;
    let t106 = w_platform_y * t30;
    let t107 = sA * t106 + 2.0_f64 * (t10 * u_sA);
    let t108 = t103 + sC * t104 + 1.7320508075688772_f64 * (2.0_f64 * (u_sC * t87) - sC * t105) + 2.0_f64 * (u_sC * t89 + t107);
    let t109 = t2 * t108;
    let t110 = 2.0_f64 * (u_psiC * t50);
    let t111 = sin_thC * t110;
    let u_psiC_dot_bias = t44 * (t45 * t96 - (t39 * t104 - t49 * t105) - cos_thC * t111);
    let k12 = p.k12;
    let k21 = p.k21;
    let t112 = t51 * u_psiC_dot_bias - (sin_thC * (k12 * (cos_thC * t110)) + cos_thC * (k21 * t111));
    let t113 = 2.0_f64 * u_thB;
    let t114 = sin_thB * u_psiB;
    let t115 = t113 * t114;
    let t116 = t53 * (t32 * (t39 * t102 - t49 * t100 + t35 * t91 + cos_thB * t115));
    let t117 = cos_thB * u_psiB;
    let t118 = t116 + (sin_thB * (k12 * (t113 * t117)) + cos_thB * (k21 * t115));
    let t119 = cos_thC * u_psiC;
    let t120 = sin_thC * u_psiC * t119;
    let t121 = v_G_z_per_u_hA * t96 - (t6 * t104 + sin_thA * t105) - (sin_thC * (t119 * t119 + t50 * t50) - cos_thC * t120);
    let t122 = Ic2 * (t47 * t121) + k22 * t120;
    let k15 = p.k15;
    let t123 = t114 * t117;
    let t124 = sin_thB * (t117 * t117 + u_thB * u_thB) - cos_thB * t123 - (t6 * t102 - sin_thA * t100 - v_G_z_per_u_hA * t91);
    let t125 = k22 * t123 - Ic2 * (t38 * t124);
    let t126 = t46 * t112 + (t36 * t118 + (u_thC_per_w_platform_x * t122 + (k15 * (t10 * w_platform_y) - t15 * t125)));
    let t127 = t71 * t95 + (t57 * t109 + t126);
    let g = p.g;
    let t128 = M * (v_G_z_dot_bias + g * v_G_z_per_u_hA);
    let t129 = t25 * u_thA;
    let t130 = u_sB_per_u_hB * t129;
    let t131 = t60 * (t12 * (v_G_z_per_u_hA * t106 - t6 * t86 + cos_thA * t130)) + (sin_thA * (k12 * (cos_thA * (2.0_f64 * t129))) + cos_thA * (k21 * t130));
    let k16 = p.k16;
    let t132 = cos_thA * t25;
    let t133 = sin_thA * t25 * t132;
    let t134 = v_G_z_per_u_hA * t86 + cos_thA * t133 + t6 * t106 + sin_thA * (t10 * t10 + w_platform_y * w_platform_y - (t132 * t132 + u_thA * u_thA));
    let t135 = Ic2 * (t26 * t134) + k22 * t133;
    let t136 = t24 * t131 + (t48 * t122 + (t40 * t125 + (k16 * t86 - u_thA_per_w_platform_y * t135)));
    let t137 = t69 * t95 - (sA * t128 + (t64 * t109 + (u_psiC_per_w_platform_y * t112 - (t37 * t118 - t136))));
    let t138 = t76 * t98 + (t19 * t127 - t137);
    let t139 = M * (g * sin_thA + 0.5773502691896257_f64 * t103);
    let t140 = k20 * t107 + (0.5773502691896257_f64 * t139 - M * (g * t6));
    let k17 = p.k17;
    let t141 = u_psiA_per_w_platform_z * t131 - (t41 * t125 - (t27 * t135 + k17 * t106) - u_thC_per_w_platform_z * t122);
    let t142 = sA * t140 + (t79 * t107 - (u_psiC_per_w_platform_z * t112 + (u_psiB_per_w_platform_z * t118 - t141) - v_G_x_per_w_platform_z * t139));
    let t143 = t142 - t82 * t109;
    let k14 = p.k14;
    let c = p.c;
    let FA = inputs[0];
    let t144 = t4 * t143 + (t83 * t109 + (k14 + (u_hA * c - FA) - t6 * t140));
    let t145 = w_platform_x_per_u_hB * t127;
    let forcing_u_hA = t23 * t138 - (t74 * t98 - (t58 * t95 - (v_G_z_per_u_hA * t128 + t144) - t145));
    let t146 = w_platform_y_per_u_hB * t76;
    let t147 = t8 * t57;
    let t148 = t19 * t147 + (t73 + t8 * t64);
    let t149 = k19 * t28;
    let t150 = sA * t149 + t80 * t28;
    let t151 = t8 * t82;
    let t152 = t23 * (t146 - t148) + (t8 * t83 - (t6 * t149 - t4 * (t150 - t151)));
    let t153 = w_platform_y_per_u_hB * t74 - t152 + w_platform_x_per_u_hB * (t77 - t147 - t58);
    let t154 = t85 * t153;
    let t155 = w_platform_x_per_u_hB * (2.0_f64 * t147 - t77) - (k18 + t28 * (M * t28) - t8 * (2.0_f64 * t150 - t151));
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (2.0_f64 * t148 - t146) - t155;
    let pivot_1 = mass_u_hB_u_hB - t153 * t154;
    let t156 = 1.0_f64 / pivot_1;
    let t157 = w_platform_y_per_u_hC * t76;
    let t158 = t9 * t57;
    let t159 = t19 * t158 + t9 * t64;
    let t160 = t157 + t159;
    let t161 = w_platform_x_per_u_hB * t158;
    let t162 = t9 * t82;
    let mass_u_hA_u_hC = t23 * t160 - (t161 - (t4 * t162 - t9 * t83)) - w_platform_y_per_u_hC * t74;
    let mass_u_hB_u_hC = w_platform_y_per_u_hC * t148 + (t161 + (t9 * t150 - t8 * t162) - w_platform_y_per_u_hB * t160);
    let t163 = t154 * mass_u_hA_u_hC + mass_u_hB_u_hC;
    let t164 = t156 * t163;
    let FB = inputs[1];
    let t165 = t149 * t107 + (t28 * t139 + (k14 + (u_hB * c - FB))) - t150 * t109;
    let t166 = w_platform_y_per_u_hB * t138 + (t147 * t95 + (t165 - t8 * t143) - t145 - t148 * t98);
    let t167 = t166 - t154 * forcing_u_hA;
    let t168 = t85 * mass_u_hA_u_hC;
    let FC = inputs[2];
    let t169 = t158 * t95 - (t9 * t143 - (FC - u_hC * c - k14)) - t159 * t98;
    let forcing_u_hC = t169 - w_platform_y_per_u_hC * t138;
    let mass_u_hC_u_hC = k18 + t9 * t162 - w_platform_y_per_u_hC * (t157 + 2.0_f64 * t159);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t168 - t163 * t164;
    let t170 = (t164 * t167 - (t168 * forcing_u_hA - forcing_u_hC)) / pivot_2;
    let t171 = t164 * t170 + t156 * t167;
    let t172 = t85 * forcing_u_hA - t154 * t171 - t168 * t170;
    let t173 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t11)), Real::abs(t31));
    let t174 = Real::min(Real::min(Real::min(Real::min(t173, Real::abs(t43)), 0.8333333333333333_f64 * Real::abs(t1)), 5.773502691896257_f64 * Real::abs(t17)), 1.6666666666666665_f64 * Real::abs(t20));
    let t175 = Real::min(Real::min(Real::min(t174, 0.2165283291230602_f64 * Real::abs(mass_u_hA_u_hA)), 0.216807871823593_f64 * Real::abs(pivot_1)), 0.21706868422196887_f64 * Real::abs(pivot_2));
    ([u_hA, -t25, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, -t50, u_sC], [t172, -t171, t170], t175)
}
///Kinetic and potential energy (J).
///
///209 operations.
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
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let Ic3 = p.Ic3;
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let k22 = p.k22;
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t1 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC)));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 1.7320508075688772_f64 * sin_thA;
    let t4 = 0.5773502691896257_f64 * t2;
    let t5 = t3 + t4;
    let t6 = u_hA * (t1 * (1.1547005383792515_f64 * t2)) - u_hB * (t1 * t5) + u_hC * (t1 * (t3 - t4));
    let t7 = 1.0_f64 / (cos_thA * cos_thA);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t8 = cos_thA * sin_psiA;
    let t9 = cos_thA * cos_psiA;
    let t10 = cos_psiB * (0.5_f64 * t8 + 0.8660254037844386_f64 * t9) + sin_psiB * (0.8660254037844386_f64 * t8 - 0.5_f64 * t9);
    let v_G_z_per_u_hA = cos_thB * (1.1547005383792515_f64 * t10);
    let u_psiA_per_w_platform_z = t7 * v_G_z_per_u_hA;
    let t11 = 0.8660254037844386_f64 * sC;
    let t12 = 1.0_f64 / (0.8660254037844386_f64 * sB);
    let t13 = (sA + 0.5_f64 * sB) * t12;
    let t14 = 1.0_f64 / (sA + 0.5_f64 * sC + t11 * t13);
    let w_platform_x_per_u_hB = t12 * v_G_z_per_u_hA;
    let t15 = t11 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t14 * t15;
    let w_platform_y_per_u_hC = t14 * v_G_z_per_u_hA;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * (t14 * (v_G_z_per_u_hA + t15)) + u_hC * w_platform_y_per_u_hC;
    let t16 = t6 * u_psiA_per_w_platform_z + w_platform_y * (t7 * t4);
    let t17 = k18 * (u_hA * u_hA) + (k18 * (u_hB * u_hB) + k18 * (u_hC * u_hC)) + (Ic3 + sin_thA * (sin_thA * k22)) * (t16 * t16);
    let Ic2 = p.Ic2;
    let t18 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t18 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t6 * (t18 * t4);
    let t19 = w_platform_x_per_u_hB * (u_hA - u_hB) + t13 * w_platform_y;
    let t20 = 1.0_f64 / (cos_thB * cos_thB);
    let t21 = 0.8660254037844386_f64 * sin_thA;
    let t22 = 0.28867513459481287_f64 * t2;
    let t23 = t21 + t22;
    let u_psiB_per_w_platform_z = t20 * v_G_z_per_u_hA;
    let u_psiB = t19 * (t20 * (0.8660254037844386_f64 * t23)) - w_platform_y * (t20 * (0.5_f64 * t23)) - t6 * u_psiB_per_w_platform_z;
    let t24 = t17 + Ic2 * (u_thA * u_thA) + (Ic3 + sin_thB * (sin_thB * k22)) * (u_psiB * u_psiB);
    let t25 = 1.0_f64 / cos_thB;
    let t26 = 0.5_f64 * v_G_z_per_u_hA;
    let u_thB = t10 * t19 - w_platform_y * (t25 * t26) + t6 * (t25 * t23);
    let t27 = 1.0_f64 / (cos_thC * cos_thC);
    let t28 = t21 - t22;
    let u_psiC_per_w_platform_y = t27 * (0.5_f64 * t28);
    let u_psiC_per_w_platform_z = t27 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t19 * (t27 * (0.8660254037844386_f64 * t28)) - t6 * u_psiC_per_w_platform_z;
    let t29 = t24 + Ic2 * (u_thB * u_thB) + (Ic3 + sin_thC * (sin_thC * k22)) * (u_psiC * u_psiC);
    let t30 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_x = t30 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t30 * t28;
    let t31 = w_platform_y * (t30 * t26) + t19 * u_thC_per_w_platform_x + t6 * u_thC_per_w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t32 = t29 + Ic2 * (t31 * t31) + Ix * (t19 * t19) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_y = sA * t6 - u_hA * t4;
    let t33 = v_G_x_per_w_platform_z * t6 + u_hB * (0.5773502691896257_f64 * t5) + 0.5773502691896257_f64 * v_G_y;
    let t34 = t32 + Iz * (t6 * t6) + M * (t33 * t33) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t35 = 0.5_f64 * (t34 + M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t36 = hA * g;
    let mc = p.mc;
    let hB = q[4];
    let t37 = hB * g;
    let ms = p.ms;
    let k13 = p.k13;
    let t38 = M * (t36 + sA * (g * sin_thA)) + (mc * t37 + (ms * t37 + k13 * t36));
    let hC = q[8];
    let t39 = t38 + k13 * (hC * g);
    (t35, t39)
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
    let t1 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC)));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t3 = 1.7320508075688772_f64 * sin_thA;
    let t4 = 0.5773502691896257_f64 * t2;
    let t5 = t3 + t4;
    let u_hC = u[2];
    let t6 = u_hA * (t1 * (1.1547005383792515_f64 * t2)) - u_hB * (t1 * t5) + u_hC * (t1 * (t3 - t4));
    let t7 = 1.0_f64 / (cos_thA * cos_thA);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t8 = cos_thA * sin_psiA;
    let t9 = cos_thA * cos_psiA;
    let t10 = cos_psiB * (0.5_f64 * t8 + 0.8660254037844386_f64 * t9) + sin_psiB * (0.8660254037844386_f64 * t8 - 0.5_f64 * t9);
    let v_G_z_per_u_hA = cos_thB * (1.1547005383792515_f64 * t10);
    let u_psiA_per_w_platform_z = t7 * v_G_z_per_u_hA;
    let t11 = 0.8660254037844386_f64 * sC;
    let t12 = 1.0_f64 / (0.8660254037844386_f64 * sB);
    let t13 = (sA + 0.5_f64 * sB) * t12;
    let t14 = 1.0_f64 / (sA + 0.5_f64 * sC + t11 * t13);
    let w_platform_x_per_u_hB = t12 * v_G_z_per_u_hA;
    let t15 = t11 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t14 * t15;
    let w_platform_y_per_u_hC = t14 * v_G_z_per_u_hA;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * (t14 * (v_G_z_per_u_hA + t15)) + u_hC * w_platform_y_per_u_hC;
    let t16 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t16 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t6 * (t16 * t4);
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_y = sA * t6 - u_hA * t4;
    let t17 = v_G_x_per_w_platform_z * t6 + u_hB * (0.5773502691896257_f64 * t5) + 0.5773502691896257_f64 * v_G_y;
    let u_sA = t17 - u_hA * sin_thA;
    let t18 = w_platform_x_per_u_hB * (u_hA - u_hB) + t13 * w_platform_y;
    let t19 = 1.0_f64 / (cos_thB * cos_thB);
    let t20 = 0.8660254037844386_f64 * sin_thA;
    let t21 = 0.28867513459481287_f64 * t2;
    let t22 = t20 + t21;
    let u_psiB_per_w_platform_z = t19 * v_G_z_per_u_hA;
    let u_psiB = t18 * (t19 * (0.8660254037844386_f64 * t22)) - w_platform_y * (t19 * (0.5_f64 * t22)) - t6 * u_psiB_per_w_platform_z;
    let t23 = 1.0_f64 / cos_thB;
    let t24 = 0.5_f64 * v_G_z_per_u_hA;
    let u_thB = t10 * t18 - w_platform_y * (t23 * t24) + t6 * (t23 * t22);
    let u_sB_per_u_hB = 2.0_f64 * sin_thA;
    let t25 = 2.0_f64 * t17;
    let u_sB = u_hB * u_sB_per_u_hB + 1.7320508075688772_f64 * sB * t6 - t25;
    let t26 = 1.0_f64 / (cos_thC * cos_thC);
    let t27 = t20 - t21;
    let u_psiC_per_w_platform_y = t26 * (0.5_f64 * t27);
    let u_psiC_per_w_platform_z = t26 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t18 * (t26 * (0.8660254037844386_f64 * t27)) - t6 * u_psiC_per_w_platform_z;
    let t28 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_x = t28 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t28 * t27;
    let u_sC_per_w_platform_z = 1.7320508075688772_f64 * sC;
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
///392 operations.
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
    let t1 = 1.0_f64 / (cos_thA * cos_thA);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 0.5773502691896257_f64 * t2;
    let sA = q[3];
    let sC = q[11];
    let t4 = 0.5_f64 * sC;
    let t5 = 0.8660254037844386_f64 * sC;
    let sB = q[7];
    let t6 = 0.5_f64 * sB;
    let t7 = 0.8660254037844386_f64 * sB;
    let t8 = 1.0_f64 / t7;
    let t9 = (sA + t6) * t8;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = 0.5_f64 * t10;
    let t12 = cos_thA * cos_psiA;
    let t13 = t11 + 0.8660254037844386_f64 * t12;
    let t14 = 0.8660254037844386_f64 * t10;
    let t15 = 0.5_f64 * t12;
    let t16 = t14 - t15;
    let t17 = cos_psiB * t13 + sin_psiB * t16;
    let t18 = 1.1547005383792515_f64 * t17;
    let v_G_z_per_u_hA = cos_thB * t18;
    let hA = q[0];
    let t19 = 0.5773502691896257_f64 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t20 = t19 * sin_psiC;
    let t21 = cos_thC * cos_psiC;
    let t22 = 0.5773502691896257_f64 * cos_thB;
    let t23 = cos_thB * cos_psiB - t22 * sin_psiB;
    let t24 = t20 + (t21 + t23);
    let t25 = 0.5_f64 * t24;
    let t26 = t10 * t3 - sin_thA * t25;
    let t27 = cos_thC * sin_psiC;
    let t28 = t22 * cos_psiB + cos_thB * sin_psiB;
    let t29 = t19 * cos_psiC;
    let t30 = t27 + (t28 - t29);
    let t31 = 0.5_f64 * t30;
    let t32 = sin_thA * t31 + t12 * t3;
    let t33 = t12 * t25 + t10 * t31;
    let t34 = 1.0_f64 / Real::sqrt(t26 * t26 + t32 * t32 + t33 * t33);
    let t35 = t26 * t34;
    let t36 = t32 * t34;
    let t37 = t10 * t35 + t12 * t36;
    let hB = q[4];
    let t38 = hA + (sin_thA * t6 - t7 * t37 - hB);
    let R = p.R;
    let t39 = 1.1547005383792515_f64 * (sin_thB * (cos_psiB * t16 - sin_psiB * t13) - sin_thA * cos_thB);
    let t40 = sin_thB * t18;
    let t41 = sin_psiB * t39 - cos_psiB * t40;
    let t42 = t33 * t34;
    let t43 = sin_thA * t35 - t12 * t42;
    let t44 = t7 * t43 + t10 * t6;
    let t45 = cos_psiB * t39 + sin_psiB * t40;
    let t46 = 0.5_f64 * t45 + 0.8660254037844386_f64 * t41;
    let t47 = sin_thA * t36 + t10 * t42;
    let t48 = R - (t7 * t47 + t12 * t6);
    let t49 = 0.8660254037844386_f64 * t45 - 0.5_f64 * t41;
    let t50 = t8 * (v_G_z_per_u_hA * t38 + R * t41 + t44 * t46 - t48 * t49);
    let hC = q[8];
    let t51 = hC - (t5 * t37 + sin_thA * t4) - hA;
    let t52 = t5 * t43 - t10 * t4;
    let t53 = R - (t12 * t4 - t5 * t47);
    let t54 = v_G_z_per_u_hA * t51 + R * (0.5_f64 * t49 + 0.8660254037844386_f64 * t46) + t52 * t46 + t53 * t49;
    let t55 = 1.0_f64 / (sA + t4 + t5 * t9) * (t5 * t50 - t54);
    let u_psiA_per_w_platform_z = t1 * v_G_z_per_u_hA;
    let t56 = R * (t14 + t15) - sA + sin_thA * t51 + t10 * t52 + t12 * t53;
    let t57 = 0.4330127018922193_f64 * t24;
    let t58 = 0.25_f64 * t30;
    let t59 = sA * (cos_thA * (sin_psiA * t25 - cos_psiA * t31) + sin_thA * t3);
    let t60 = sA + R * t16 + sin_thA * t38 + t10 * t44 - t12 * t48;
    let t61 = R * (t58 + t57) + t59 + t3 * t38 + t25 * t44 + 1.7320508075688772_f64 * t60;
    let t62 = t61 + t31 * t48;
    let t63 = 1.7320508075688772_f64 * t56 - (R * (t57 - t58) - t62 - t59 + t3 * t51 + t25 * t52);
    let t64 = sA * sin_thA;
    let t65 = sA * t12;
    let t66 = sA * t10;
    let t67 = t64 * t3 - (t65 * t31 - t66 * t25) - t59;
    let t68 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC))) * (t63 + 2.0_f64 * t67 + t31 * t53);
    let t69 = t1 * t3 * t55 - u_psiA_per_w_platform_z * t68;
    let t70 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t70 * v_G_z_per_u_hA;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t71 = v_G_x_per_w_platform_z * t68 - 0.5773502691896257_f64 * (t62 - (sA * t68 - t67));
    let t72 = t71 + (sA - (t12 * t65 + t10 * t66 + sin_thA * t64));
    let t73 = 1.0_f64 / (cos_thB * cos_thB);
    let t74 = 0.8660254037844386_f64 * sin_thA;
    let t75 = 0.28867513459481287_f64 * t2;
    let t76 = t74 + t75;
    let t77 = t50 - t9 * t55;
    let t78 = 0.8660254037844386_f64 * t47;
    let t79 = 0.8660254037844386_f64 * t23;
    let t80 = 0.8660254037844386_f64 * t43;
    let t81 = 0.8660254037844386_f64 * t28;
    let t82 = t73 * (0.8660254037844386_f64 * t76) * t77 + t73 * ((t15 + t78) * t79 + (t11 + t80) * t81);
    let u_psiB_per_w_platform_z = t73 * v_G_z_per_u_hA;
    let t83 = t73 * (0.5_f64 * t76) * t55 + t82 - u_psiB_per_w_platform_z * t68;
    let t84 = 1.0_f64 / cos_thB;
    let t85 = 0.5_f64 * v_G_z_per_u_hA;
    let t86 = 0.5_f64 * sin_thA;
    let t87 = 0.8660254037844386_f64 * t37;
    let t88 = t84 * t76 * t68 + (t84 * t85 * t55 - (t84 * (sin_thB + (t86 - t87)) - t17 * t77));
    let t89 = 1.7320508075688772_f64 * sB * t68 - 2.0_f64 * (t60 + t71);
    let t90 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = t90 * v_G_z_per_u_hA;
    let t91 = t74 - t75;
    let u_psiC_per_w_platform_y = t90 * (0.5_f64 * t91);
    let t92 = 0.8660254037844386_f64 * (t29 - t27);
    let t93 = 0.8660254037844386_f64 * (t20 + t21);
    let t94 = t90 * ((t80 - t11) * t92 - (t78 - t15) * t93) - t90 * (0.8660254037844386_f64 * t91) * t77;
    let t95 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_z = t95 * t91;
    let u_thC_per_w_platform_x = t95 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let t96 = u_thC_per_w_platform_z * t68 + (u_thC_per_w_platform_x * t77 + t95 * (sin_thC + (t86 + t87)) - t95 * t85 * t55);
    let u_sC_per_w_platform_z = 1.7320508075688772_f64 * sC;
    let t97 = 2.0_f64 * (t56 - t71) - u_sC_per_w_platform_z * t68;
    let t98 = sA * cos_thA;
    let t99 = sin_psiA * t98;
    let t100 = sB * cos_thB;
    let t101 = sin_psiB * t100;
    let t102 = cos_psiB * t100;
    let k11 = p.k11;
    let t103 = R - cos_psiA * t98 + k11;
    let t104 = Real::max(Real::abs(t99 + 0.5_f64 * t101 + 0.8660254037844386_f64 * (R - t102)), Real::abs(t103 - (0.5_f64 * t102 + 0.8660254037844386_f64 * t101)));
    let t105 = sC * cos_thC;
    let t106 = sin_psiC * t105;
    let t107 = cos_psiC * t105;
    let t108 = Real::max(Real::max(t104, Real::abs(hA - hB + t64 - sB * sin_thB)), Real::abs(t99 + 0.5_f64 * t106 + 0.8660254037844386_f64 * (t107 - R)));
    let t109 = Real::max(Real::max(t108, Real::abs(t103 + (0.8660254037844386_f64 * t106 - 0.5_f64 * t107))), Real::abs(sC * sin_thC + (hC - hA - t64)));
    let t110 = Real::max(Real::max(Real::max(t109, Real::abs(t10 + t79 - t93)), Real::abs(t92 - (t12 - t81))), Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t69, -(t70 * t3 * t68 + u_thA_per_w_platform_y * t55), t72, t83, t88, t89, -(u_psiC_per_w_platform_z * t68 + (u_psiC_per_w_platform_y * t55 + t94)), -t96, t97], t110)
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
