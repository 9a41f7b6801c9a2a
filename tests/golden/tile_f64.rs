// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 684 operations (12 abs, 136 add, 5 cos, 12 div, 11 min, 405 mul, 5 sin, 98 sub).
// Cost of energy: 204 operations (42 add, 5 cos, 9 div, 131 mul, 5 sin, 12 sub).
// Cost of speeds: 146 operations (21 add, 5 cos, 9 div, 89 mul, 5 sin, 17 sub).
// Cost of outputs: 11 operations (1 add, 2 cos, 5 mul, 2 sin, 1 sub).
// Cost of projection: 430 operations (9 abs, 80 add, 6 cos, 10 div, 8 max, 232 mul, 6 sin, 1 sqrt, 78 sub).
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
///684 operations.
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
    let t1 = sA + (sB + sC);
    let t2 = 1.0_f64 / t1;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t3 = sin_thB - sin_thC;
    let t4 = 0.5773502691896257_f64 * t3;
    let t5 = t2 * t4;
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t6 = 0.8660254037844386_f64 * sin_thA;
    let t7 = 0.28867513459481287_f64 * t3;
    let t8 = t6 + t7;
    let w_platform_z_per_u_hB = t2 * t8;
    let u_hC = u[2];
    let t9 = t6 - t7;
    let t10 = t2 * t9;
    let t11 = u_hA * t5 - u_hB * w_platform_z_per_u_hB + u_hC * t10;
    let t12 = cos_thA * cos_thA;
    let t13 = 1.0_f64 / t12;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t14 = cos_thA * sin_psiA;
    let t15 = cos_thA * cos_psiA;
    let t16 = cos_psiB * (0.5_f64 * t14 + 0.8660254037844386_f64 * t15) + sin_psiB * (0.8660254037844386_f64 * t14 - 0.5_f64 * t15);
    let v_G_z_per_u_hA = cos_thB * (1.1547005383792515_f64 * t16);
    let u_psiA_per_w_platform_z = t13 * v_G_z_per_u_hA;
    let t17 = 0.8660254037844386_f64 * sB;
    let t18 = 0.8660254037844386_f64 * sC;
    let t19 = 1.0_f64 / t18;
    let w_platform_x_per_w_platform_y = (sA + 0.5_f64 * sC) * t19;
    let t20 = sA + 0.5_f64 * sB + t17 * w_platform_x_per_w_platform_y;
    let t21 = 1.0_f64 / t20;
    let w_platform_y_per_u_hB = t21 * v_G_z_per_u_hA;
    let w_platform_x_per_u_hA = t19 * v_G_z_per_u_hA;
    let t22 = t17 * w_platform_x_per_u_hA;
    let t23 = t21 * (v_G_z_per_u_hA + t22);
    let w_platform_y_per_u_hC = t21 * t22;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * t23 + u_hC * w_platform_y_per_u_hC;
    let t24 = t13 * t4;
    let t25 = t11 * u_psiA_per_w_platform_z + w_platform_y * t24;
    let t26 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t26 * v_G_z_per_u_hA;
    let t27 = t26 * t4;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t11 * t27;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t28 = 1.1547005383792515_f64 * t8;
    let v_G_y = sA * t11 - u_hA * t4;
    let t29 = v_G_x_per_w_platform_z * t11 + u_hB * t28 + 0.5773502691896257_f64 * v_G_y;
    let u_sA = t29 - u_hA * sin_thA;
    let t30 = cos_thB * cos_thB;
    let t31 = 1.0_f64 / t30;
    let t32 = t31 * (0.5_f64 * t8);
    let w_platform_x = w_platform_x_per_u_hA * (u_hA - u_hC) + w_platform_x_per_w_platform_y * w_platform_y;
    let t33 = t31 * (0.8660254037844386_f64 * t8);
    let u_psiB_per_w_platform_z = t31 * v_G_z_per_u_hA;
    let t34 = w_platform_y * t32 + w_platform_x * t33 + t11 * u_psiB_per_w_platform_z;
    let t35 = 1.0_f64 / cos_thB;
    let t36 = t35 * t8;
    let t37 = 0.5_f64 * v_G_z_per_u_hA;
    let t38 = t35 * t37;
    let u_thB = t11 * t36 - (w_platform_y * t38 + t16 * w_platform_x);
    let t39 = 0.5_f64 * sin_thA;
    let t40 = 0.5_f64 * t3;
    let u_sB_per_u_hB = t39 - t40;
    let t41 = 0.5_f64 * t29;
    let t42 = 0.8660254037844386_f64 * v_G_y;
    let u_sB = u_hB * u_sB_per_u_hB - t41 - t42;
    let t43 = cos_thC * cos_thC;
    let t44 = 1.0_f64 / t43;
    let u_psiC_per_w_platform_y = t44 * (0.5_f64 * t9);
    let t45 = t44 * (0.8660254037844386_f64 * t9);
    let u_psiC_per_w_platform_z = t44 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y - w_platform_x * t45 - t11 * u_psiC_per_w_platform_z;
    let t46 = 1.0_f64 / cos_thC;
    let t47 = t46 * t37;
    let u_thC_per_w_platform_x = t46 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t46 * t9;
    let t48 = w_platform_y * t47 - w_platform_x * u_thC_per_w_platform_x + t11 * u_thC_per_w_platform_z;
    let u_sC_per_u_hC = t39 + t40;
    let u_sC = t42 + (u_hC * u_sC_per_u_hC - t41);
    let Ic3 = p.Ic3;
    let k22 = p.k22;
    let t49 = Ic3 + sin_thC * (sin_thC * k22);
    let t50 = Ic3 + sin_thB * (sin_thB * k22);
    let Ic2 = p.Ic2;
    let Ix = p.Ix;
    let t51 = t33 * (t33 * t50) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t16 * (Ic2 * t16)));
    let t52 = t45 * (t45 * t49) + t51;
    let t53 = w_platform_x_per_w_platform_y * t52;
    let t54 = t32 * t50;
    let t55 = Ic2 * t38;
    let t56 = Ic2 * t47;
    let t57 = u_psiC_per_w_platform_y * t49;
    let t58 = t33 * t54 + (t16 * t55 - u_thC_per_w_platform_x * t56) - t45 * t57;
    let M = p.M;
    let t59 = sA * M;
    let t60 = Ic3 + sin_thA * (sin_thA * k22);
    let Iy = p.Iy;
    let t61 = t24 * (t24 * t60) + (t47 * t56 + (t38 * t55 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t62 = w_platform_x_per_w_platform_y * (t53 + 2.0_f64 * t58) + (sA * t59 + (u_psiC_per_w_platform_y * t57 + (t32 * t54 + t61)));
    let t63 = u_psiC_per_w_platform_z * t49;
    let t64 = u_psiB_per_w_platform_z * t50;
    let t65 = Ic2 * u_thC_per_w_platform_z;
    let t66 = Ic2 * t36;
    let t67 = t45 * t63 + (t33 * t64 - (u_thC_per_w_platform_x * t65 + t16 * t66));
    let t68 = t5 * t67;
    let t69 = w_platform_x_per_u_hA * (t53 + t58);
    let t70 = u_psiA_per_w_platform_z * t60;
    let t71 = Ic2 * t27;
    let t72 = t32 * t64 + (t24 * t70 - (t38 * t66 + u_thA_per_w_platform_y * t71 - t47 * t65));
    let t73 = u_psiC_per_w_platform_y * t63 - t72;
    let t74 = w_platform_x_per_w_platform_y * t68 + (t69 + (t59 * v_G_z_per_u_hA - t5 * t73));
    let t75 = w_platform_x_per_u_hA * t52;
    let k20 = p.k20;
    let t76 = sA * k20;
    let k19 = p.k19;
    let t77 = v_G_x_per_w_platform_z * k19;
    let t78 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t79 = u_psiB_per_w_platform_z * t64 + (u_psiA_per_w_platform_z * t70 + (u_thC_per_w_platform_z * t65 + (t36 * t66 + (Iz + t27 * t71))));
    let t80 = sA * (t76 + 2.0_f64 * t77) + (v_G_x_per_w_platform_z * t78 + (u_psiC_per_w_platform_z * t63 + t79));
    let t81 = (t77 + t76) * t4;
    let k18 = p.k18;
    let t82 = t5 * (t5 * t80 - 2.0_f64 * t81) + (k18 + t4 * (k20 * t4)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t23 * (t23 * t62 - 2.0_f64 * t74) + (w_platform_x_per_u_hA * (2.0_f64 * t68 + t75) + t82);
    let t83 = 1.0_f64 / mass_u_hA_u_hA;
    let t84 = w_platform_y_per_u_hB * t62;
    let t85 = w_platform_z_per_u_hB * t67;
    let t86 = w_platform_z_per_u_hB * t73 - w_platform_x_per_w_platform_y * t85;
    let t87 = w_platform_x_per_u_hA * t85;
    let t88 = k19 * t28;
    let t89 = sA * t88 + t78 * t28;
    let t90 = w_platform_z_per_u_hB * t80;
    let t91 = t23 * (t84 + t86) + (t87 - (w_platform_z_per_u_hB * t81 - (t4 * t88 - t5 * (t89 - t90))));
    let mass_u_hA_u_hB = w_platform_y_per_u_hB * t74 - t91;
    let t92 = t83 * mass_u_hA_u_hB;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (t84 + 2.0_f64 * t86) + (k18 + t28 * (M * t28) - w_platform_z_per_u_hB * (2.0_f64 * t89 - t90));
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t92;
    let t93 = 1.0_f64 / pivot_1;
    let t94 = t10 * t67;
    let t95 = t69 + t10 * t73 - w_platform_x_per_w_platform_y * t94;
    let t96 = w_platform_y_per_u_hC * t62;
    let t97 = t95 - t96;
    let t98 = t10 * t80;
    let mass_u_hB_u_hC = w_platform_y_per_u_hC * t86 - (w_platform_y_per_u_hB * t97 - (t87 + (t10 * t89 - w_platform_z_per_u_hB * t98)));
    let mass_u_hA_u_hC = t23 * t97 + (t5 * t98 - t10 * t81) + w_platform_y_per_u_hC * t74 - w_platform_x_per_u_hA * (t68 + (t75 - t94));
    let t99 = mass_u_hB_u_hC - t92 * mass_u_hA_u_hC;
    let t100 = t93 * t99;
    let t101 = t11 * w_platform_x;
    let v_G_z_dot_bias = sA * t101 + 2.0_f64 * (w_platform_y * u_sA);
    let t102 = 0.8660254037844386_f64 * w_platform_y;
    let t103 = 0.5_f64 * w_platform_x;
    let t104 = t102 + t103;
    let t105 = t11 * t104;
    let t106 = 0.5_f64 * w_platform_y;
    let t107 = 0.8660254037844386_f64 * w_platform_x;
    let t108 = t106 - t107;
    let t109 = t19 * (v_G_z_dot_bias + (sC * t105 + 2.0_f64 * (u_sC * t108)));
    let g = p.g;
    let t110 = M * (v_G_z_dot_bias + g * v_G_z_per_u_hA);
    let t111 = t104 * t108;
    let t112 = t103 - t102;
    let t113 = t106 + t107;
    let t114 = t112 * t113;
    let t115 = 2.0_f64 * (t11 * u_sB) - sB * t114;
    let t116 = w_platform_y * w_platform_x;
    let t117 = sA * t116 - 2.0_f64 * (t11 * u_sA);
    let w_platform_z_dot_bias = t2 * (2.0_f64 * (t11 * u_sC) - sC * t111 + t115 - t117);
    let t118 = 2.0_f64 * (u_psiC * t48);
    let t119 = sin_thC * t118;
    let u_psiC_dot_bias = t44 * (t9 * t105 + v_G_z_per_u_hA * t111 - cos_thC * t119);
    let k12 = p.k12;
    let k21 = p.k21;
    let t120 = t49 * u_psiC_dot_bias - (sin_thC * (k12 * (cos_thC * t118)) + cos_thC * (k21 * t119));
    let t121 = t11 * t112;
    let t122 = 2.0_f64 * (t34 * u_thB);
    let t123 = sin_thB * t122;
    let t124 = t50 * (t31 * (t8 * t121 - v_G_z_per_u_hA * t114 + cos_thB * t123)) + (sin_thB * (k12 * (cos_thB * t122)) + cos_thB * (k21 * t123));
    let t125 = 2.0_f64 * (t25 * u_thA);
    let t126 = sin_thA * t125;
    let t127 = t60 * (t13 * (t4 * t101 - v_G_z_per_u_hA * t116 + cos_thA * t126)) + (sin_thA * (k12 * (cos_thA * t125)) + cos_thA * (k21 * t126));
    let t128 = t11 * t11;
    let t129 = cos_thC * u_psiC;
    let t130 = sin_thC * u_psiC * t129;
    let t131 = v_G_z_per_u_hA * t105 - (t9 * t111 + u_sC_per_u_hC * (t108 * t108 + t128)) - (sin_thC * (t129 * t129 + t48 * t48) - cos_thC * t130);
    let t132 = Ic2 * (t46 * t131) + k22 * t130;
    let t133 = cos_thB * t34;
    let t134 = sin_thB * t34 * t133;
    let t135 = sin_thB * (t133 * t133 + u_thB * u_thB) - cos_thB * t134 - (t8 * t114 - u_sB_per_u_hB * (t128 + t113 * t113) + v_G_z_per_u_hA * t121);
    let t136 = k22 * t134 - Ic2 * (t35 * t135);
    let t137 = cos_thA * t25;
    let t138 = sin_thA * t25 * t137;
    let t139 = sin_thA * (t128 + w_platform_y * w_platform_y - (t137 * t137 + u_thA * u_thA)) - (v_G_z_per_u_hA * t101 - cos_thA * t138 + t4 * t116);
    let t140 = Ic2 * (t26 * t139) + k22 * t138;
    let k16 = p.k16;
    let t141 = t24 * t127 + (t47 * t132 + (t38 * t136 - (u_thA_per_w_platform_y * t140 + k16 * t101)));
    let t142 = t58 * t109 + (sA * t110 + (t73 * w_platform_z_dot_bias + (u_psiC_per_w_platform_y * t120 + (t32 * t124 + t141))));
    let k15 = p.k15;
    let t143 = t45 * t120 + (u_thC_per_w_platform_x * t132 + (k15 * (t11 * w_platform_y) - t16 * t136) - t33 * t124);
    let t144 = t67 * w_platform_z_dot_bias + t143 - t52 * t109;
    let t145 = t21 * (t17 * t109 + (v_G_z_dot_bias + (sB * t121 + 2.0_f64 * (u_sB * t113))));
    let t146 = t142 - w_platform_x_per_w_platform_y * t144 - t62 * t145;
    let t147 = w_platform_x_per_u_hA * t144;
    let t148 = M * (g * sin_thA + 1.1547005383792515_f64 * t115);
    let t149 = k20 * t117 - (0.5773502691896257_f64 * t148 - M * (g * t4));
    let k14 = p.k14;
    let c = p.c;
    let FA = inputs[0];
    let k17 = p.k17;
    let t150 = u_psiA_per_w_platform_z * t127 - (t36 * t136 - (t27 * t140 - k17 * t116) - u_thC_per_w_platform_z * t132);
    let t151 = sA * t149 + (t77 * t117 + (u_psiC_per_w_platform_z * t120 - (u_psiB_per_w_platform_z * t124 + t150) - v_G_x_per_w_platform_z * t148));
    let t152 = t80 * w_platform_z_dot_bias + t151;
    let t153 = t81 * w_platform_z_dot_bias + (t4 * t149 + (k14 + (u_hA * c - FA))) - t5 * t152;
    let forcing_u_hA = t23 * t146 + (t74 * t145 + (t147 - (t68 * t109 + (v_G_z_per_u_hA * t110 + t153))));
    let FB = inputs[1];
    let t154 = t89 * w_platform_z_dot_bias + (t88 * t117 - (t28 * t148 + (k14 + (u_hB * c - FB))));
    let forcing_u_hB = t86 * t145 + (t85 * t109 - (w_platform_z_per_u_hB * t152 - t154)) - w_platform_y_per_u_hB * t146;
    let t155 = t92 * forcing_u_hA - forcing_u_hB;
    let t156 = t83 * mass_u_hA_u_hC;
    let FC = inputs[2];
    let t157 = t95 * t145 + (t147 - (FC - u_hC * c - k14 + t10 * t152 - t94 * t109));
    let mass_u_hC_u_hC = w_platform_x_per_u_hA * (t75 - 2.0_f64 * t94) + (k18 + t10 * t98) - w_platform_y_per_u_hC * (2.0_f64 * t95 - t96);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t156 - t99 * t100;
    let t158 = (t100 * t155 - (t156 * forcing_u_hA + (w_platform_y_per_u_hC * t146 + t157))) / pivot_2;
    let t159 = t100 * t158 + t93 * t155;
    let t160 = t92 * t159 + t83 * forcing_u_hA - t156 * t158;
    let t161 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t12)), Real::abs(t30));
    let t162 = Real::min(Real::min(Real::min(t161, Real::abs(t43)), 1.6666666666666665_f64 * Real::min(Real::abs(t1), Real::abs(t20))), 5.773502691896257_f64 * Real::abs(t18));
    let t163 = Real::min(Real::min(Real::min(t162, 0.2165283291230602_f64 * Real::abs(mass_u_hA_u_hA)), 0.216807871823593_f64 * Real::abs(pivot_1)), 0.21706868422196887_f64 * Real::abs(pivot_2));
    ([u_hA, -t25, u_thA, u_sA, u_hB, -t34, u_thB, u_sB, u_hC, u_psiC, -t48, u_sC], [t160, -t159, t158], t163)
}
///Kinetic and potential energy (J).
///
///204 operations.
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
    let t1 = 1.0_f64 / (sA + (sB + sC));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 0.5773502691896257_f64 * t2;
    let t4 = 0.8660254037844386_f64 * sin_thA;
    let t5 = 0.28867513459481287_f64 * t2;
    let t6 = t4 + t5;
    let w_platform_z_per_u_hB = t1 * t6;
    let t7 = t4 - t5;
    let t8 = u_hA * (t1 * t3) - u_hB * w_platform_z_per_u_hB + u_hC * (t1 * t7);
    let t9 = 1.0_f64 / (cos_thA * cos_thA);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = cos_thA * cos_psiA;
    let t12 = cos_psiB * (0.5_f64 * t10 + 0.8660254037844386_f64 * t11) + sin_psiB * (0.8660254037844386_f64 * t10 - 0.5_f64 * t11);
    let v_G_z_per_u_hA = cos_thB * (1.1547005383792515_f64 * t12);
    let u_psiA_per_w_platform_z = t9 * v_G_z_per_u_hA;
    let t13 = 0.8660254037844386_f64 * sB;
    let t14 = 1.0_f64 / (0.8660254037844386_f64 * sC);
    let w_platform_x_per_w_platform_y = (sA + 0.5_f64 * sC) * t14;
    let t15 = 1.0_f64 / (sA + 0.5_f64 * sB + t13 * w_platform_x_per_w_platform_y);
    let w_platform_y_per_u_hB = t15 * v_G_z_per_u_hA;
    let w_platform_x_per_u_hA = t14 * v_G_z_per_u_hA;
    let t16 = t13 * w_platform_x_per_u_hA;
    let w_platform_y_per_u_hC = t15 * t16;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * (t15 * (v_G_z_per_u_hA + t16)) + u_hC * w_platform_y_per_u_hC;
    let t17 = t8 * u_psiA_per_w_platform_z + w_platform_y * (t9 * t3);
    let t18 = k18 * (u_hA * u_hA) + (k18 * (u_hB * u_hB) + k18 * (u_hC * u_hC)) + (Ic3 + sin_thA * (sin_thA * k22)) * (t17 * t17);
    let Ic2 = p.Ic2;
    let t19 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t19 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t8 * (t19 * t3);
    let t20 = 1.0_f64 / (cos_thB * cos_thB);
    let w_platform_x = w_platform_x_per_u_hA * (u_hA - u_hC) + w_platform_x_per_w_platform_y * w_platform_y;
    let u_psiB_per_w_platform_z = t20 * v_G_z_per_u_hA;
    let t21 = w_platform_y * (t20 * (0.5_f64 * t6)) + w_platform_x * (t20 * (0.8660254037844386_f64 * t6)) + t8 * u_psiB_per_w_platform_z;
    let t22 = t18 + Ic2 * (u_thA * u_thA) + (Ic3 + sin_thB * (sin_thB * k22)) * (t21 * t21);
    let t23 = 1.0_f64 / cos_thB;
    let t24 = 0.5_f64 * v_G_z_per_u_hA;
    let u_thB = t8 * (t23 * t6) - (w_platform_y * (t23 * t24) + t12 * w_platform_x);
    let t25 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_y = t25 * (0.5_f64 * t7);
    let u_psiC_per_w_platform_z = t25 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y - w_platform_x * (t25 * (0.8660254037844386_f64 * t7)) - t8 * u_psiC_per_w_platform_z;
    let t26 = t22 + Ic2 * (u_thB * u_thB) + (Ic3 + sin_thC * (sin_thC * k22)) * (u_psiC * u_psiC);
    let t27 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_x = t27 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t27 * t7;
    let t28 = w_platform_y * (t27 * t24) - w_platform_x * u_thC_per_w_platform_x + t8 * u_thC_per_w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t29 = t26 + Ic2 * (t28 * t28) + Ix * (w_platform_x * w_platform_x) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_y = sA * t8 - u_hA * t3;
    let t30 = v_G_x_per_w_platform_z * t8 + u_hB * (1.1547005383792515_f64 * t6) + 0.5773502691896257_f64 * v_G_y;
    let t31 = t29 + Iz * (t8 * t8) + M * (t30 * t30) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t32 = 0.5_f64 * (t31 + M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t33 = hA * g;
    let mc = p.mc;
    let hB = q[4];
    let t34 = hB * g;
    let ms = p.ms;
    let k13 = p.k13;
    let t35 = M * (t33 + sin_thA * (sA * g)) + (mc * t34 + (ms * t34 + k13 * t33));
    let hC = q[8];
    let t36 = t35 + k13 * (hC * g);
    (t32, t36)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///146 operations.
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
    let t1 = 1.0_f64 / (sA + (sB + sC));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 0.5773502691896257_f64 * t2;
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t4 = 0.8660254037844386_f64 * sin_thA;
    let t5 = 0.28867513459481287_f64 * t2;
    let t6 = t4 + t5;
    let w_platform_z_per_u_hB = t1 * t6;
    let u_hC = u[2];
    let t7 = t4 - t5;
    let t8 = u_hA * (t1 * t3) - u_hB * w_platform_z_per_u_hB + u_hC * (t1 * t7);
    let t9 = 1.0_f64 / (cos_thA * cos_thA);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = cos_thA * cos_psiA;
    let t12 = cos_psiB * (0.5_f64 * t10 + 0.8660254037844386_f64 * t11) + sin_psiB * (0.8660254037844386_f64 * t10 - 0.5_f64 * t11);
    let v_G_z_per_u_hA = cos_thB * (1.1547005383792515_f64 * t12);
    let u_psiA_per_w_platform_z = t9 * v_G_z_per_u_hA;
    let t13 = 0.8660254037844386_f64 * sB;
    let t14 = 1.0_f64 / (0.8660254037844386_f64 * sC);
    let w_platform_x_per_w_platform_y = (sA + 0.5_f64 * sC) * t14;
    let t15 = 1.0_f64 / (sA + 0.5_f64 * sB + t13 * w_platform_x_per_w_platform_y);
    let w_platform_y_per_u_hB = t15 * v_G_z_per_u_hA;
    let w_platform_x_per_u_hA = t14 * v_G_z_per_u_hA;
    let t16 = t13 * w_platform_x_per_u_hA;
    let w_platform_y_per_u_hC = t15 * t16;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * (t15 * (v_G_z_per_u_hA + t16)) + u_hC * w_platform_y_per_u_hC;
    let t17 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t17 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t8 * (t17 * t3);
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_y = sA * t8 - u_hA * t3;
    let t18 = v_G_x_per_w_platform_z * t8 + u_hB * (1.1547005383792515_f64 * t6) + 0.5773502691896257_f64 * v_G_y;
    let u_sA = t18 - u_hA * sin_thA;
    let t19 = 1.0_f64 / (cos_thB * cos_thB);
    let w_platform_x = w_platform_x_per_u_hA * (u_hA - u_hC) + w_platform_x_per_w_platform_y * w_platform_y;
    let u_psiB_per_w_platform_z = t19 * v_G_z_per_u_hA;
    let t20 = w_platform_y * (t19 * (0.5_f64 * t6)) + w_platform_x * (t19 * (0.8660254037844386_f64 * t6)) + t8 * u_psiB_per_w_platform_z;
    let t21 = 1.0_f64 / cos_thB;
    let t22 = 0.5_f64 * v_G_z_per_u_hA;
    let u_thB = t8 * (t21 * t6) - (w_platform_y * (t21 * t22) + t12 * w_platform_x);
    let t23 = 0.5_f64 * sin_thA;
    let t24 = 0.5_f64 * t2;
    let u_sB_per_u_hB = t23 - t24;
    let t25 = 0.5_f64 * t18;
    let t26 = 0.8660254037844386_f64 * v_G_y;
    let u_sB = u_hB * u_sB_per_u_hB - t25 - t26;
    let t27 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_y = t27 * (0.5_f64 * t7);
    let u_psiC_per_w_platform_z = t27 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y - w_platform_x * (t27 * (0.8660254037844386_f64 * t7)) - t8 * u_psiC_per_w_platform_z;
    let t28 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_x = t28 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t28 * t7;
    let u_sC_per_u_hC = t23 + t24;
    let u_sC = t26 + (u_hC * u_sC_per_u_hC - t25);
    [u_hA, -(t8 * u_psiA_per_w_platform_z + w_platform_y * (t9 * t3)), u_thA, u_sA, u_hB, -t20, u_thB, u_sB, u_hC, u_psiC, -(w_platform_y * (t28 * t22) - w_platform_x * u_thC_per_w_platform_x + t8 * u_thC_per_w_platform_z), u_sC]
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
    p: &Prepared,
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
///430 operations.
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
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t2 = cos_thA * sin_psiA;
    let t3 = 0.5_f64 * t2;
    let t4 = cos_thA * cos_psiA;
    let t5 = 0.8660254037844386_f64 * t4;
    let t6 = t3 + t5;
    let t7 = 0.8660254037844386_f64 * t2;
    let t8 = 0.5_f64 * t4;
    let t9 = t7 - t8;
    let t10 = cos_psiB * t6 + sin_psiB * t9;
    let t11 = 1.1547005383792515_f64 * t10;
    let v_G_z_per_u_hA = cos_thB * t11;
    let u_psiA_per_w_platform_z = t1 * v_G_z_per_u_hA;
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t12 = cos_thC * sin_psiC;
    let t13 = 0.5773502691896257_f64 * cos_thB;
    let t14 = t13 * cos_psiB + cos_thB * sin_psiB;
    let t15 = 0.5773502691896257_f64 * cos_thC;
    let t16 = t15 * cos_psiC;
    let t17 = t12 + (t14 - t16);
    let t18 = 0.25_f64 * t17;
    let t19 = t5 - t18;
    let R = p.R;
    let t20 = 0.8660254037844386_f64 * sB;
    let t21 = 0.5_f64 * t17;
    let t22 = sin_thB - sin_thC;
    let t23 = 0.5773502691896257_f64 * t22;
    let t24 = sin_thA * t21 + t4 * t23;
    let t25 = t15 * sin_psiC;
    let t26 = cos_thC * cos_psiC;
    let t27 = cos_thB * cos_psiB - t13 * sin_psiB;
    let t28 = t25 + (t26 + t27);
    let t29 = 0.5_f64 * t28;
    let t30 = t2 * t23 - sin_thA * t29;
    let t31 = t4 * t29 + t2 * t21;
    let t32 = 1.0_f64 / Real::sqrt(t30 * t30 + t24 * t24 + t31 * t31);
    let t33 = t24 * t32;
    let t34 = t31 * t32;
    let t35 = sin_thA * t33 + t2 * t34;
    let t36 = 0.5_f64 * sB;
    let t37 = R - (t20 * t35 + t4 * t36);
    let t38 = 0.25_f64 * t28;
    let t39 = t7 + t38;
    let t40 = 0.8660254037844386_f64 * sin_thA;
    let t41 = 0.28867513459481287_f64 * t22;
    let t42 = t40 + t41;
    let t43 = R * (0.8660254037844386_f64 * t39 - 0.5_f64 * t19) + sA * (cos_thA * (sin_psiA * t39 + cos_psiA * t19) + sin_thA * t42);
    let hA = q[0];
    let t44 = t30 * t32;
    let t45 = t2 * t44 + t4 * t33;
    let hB = q[4];
    let t46 = hA + (sin_thA * t36 - t20 * t45 - hB);
    let t47 = sin_thA * t44 - t4 * t34;
    let t48 = t20 * t47 + t2 * t36;
    let t49 = t19 * t37 - (t43 + t42 * t46 + t39 * t48);
    let t50 = sA * sin_thA;
    let t51 = sA * t4;
    let t52 = sA * t2;
    let t53 = t50 * t23 - (t51 * t21 - t52 * t29) - sA * (cos_thA * (sin_psiA * t29 - cos_psiA * t21) + sin_thA * t23);
    let t54 = t5 + t18;
    let t55 = t38 - t7;
    let t56 = t40 - t41;
    let t57 = t49 - t53 - R * (0.5_f64 * t54 - 0.8660254037844386_f64 * t55) + sA * (cos_thA * (cos_psiA * t54 - sin_psiA * t55) + sin_thA * t56);
    let hC = q[8];
    let t58 = 0.8660254037844386_f64 * sC;
    let t59 = 0.5_f64 * sC;
    let t60 = hC - (t58 * t45 + sin_thA * t59) - hA;
    let t61 = t58 * t47 - t2 * t59;
    let t62 = R - (t4 * t59 - t58 * t35);
    let t63 = 1.0_f64 / (sA + (sB + sC)) * (t57 - t56 * t60 + t55 * t61 - t54 * t62);
    let t64 = 1.0_f64 / t58;
    let w_platform_x_per_w_platform_y = (sA + t59) * t64;
    let t65 = 1.1547005383792515_f64 * (sin_thB * (cos_psiB * t9 - sin_psiB * t6) - sin_thA * cos_thB);
    let t66 = sin_thB * t11;
    let t67 = cos_psiB * t65 + sin_psiB * t66;
    let t68 = sin_psiB * t65 - cos_psiB * t66;
    let t69 = 0.8660254037844386_f64 * t67 - 0.5_f64 * t68;
    let t70 = 0.5_f64 * t67 + 0.8660254037844386_f64 * t68;
    let t71 = v_G_z_per_u_hA * t60 + R * (0.5_f64 * t69 + 0.8660254037844386_f64 * t70) + t61 * t70 + t62 * t69;
    let t72 = t64 * t71;
    let t73 = t20 * t72 - (R * t68 - (t37 * t69 - (v_G_z_per_u_hA * t46 + t48 * t70)));
    let t74 = 1.0_f64 / (sA + t36 + t20 * w_platform_x_per_w_platform_y) * t73;
    let t75 = u_psiA_per_w_platform_z * t63 - t1 * t23 * t74;
    let t76 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t76 * v_G_z_per_u_hA;
    let t77 = t76 * t23 * t63 + u_thA_per_w_platform_y * t74;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t78 = t53 + sA * t63;
    let t79 = 1.1547005383792515_f64 * t49 - v_G_x_per_w_platform_z * t63 - 0.5773502691896257_f64 * t78;
    let t80 = t79 + (sA - (t4 * t51 + t2 * t52 + sin_thA * t50));
    let t81 = 1.0_f64 / (cos_thB * cos_thB);
    let u_psiB_per_w_platform_z = t81 * v_G_z_per_u_hA;
    let t82 = t72 - w_platform_x_per_w_platform_y * t74;
    let t83 = 0.8660254037844386_f64 * t35;
    let t84 = 0.8660254037844386_f64 * t27;
    let t85 = 0.8660254037844386_f64 * t47;
    let t86 = 0.8660254037844386_f64 * t14;
    let t87 = t81 * (0.8660254037844386_f64 * t42) * t82 + t81 * ((t8 + t83) * t84 + (t3 + t85) * t86);
    let t88 = u_psiB_per_w_platform_z * t63 - (t81 * (0.5_f64 * t42) * t74 - t87);
    let t89 = 1.0_f64 / cos_thB;
    let t90 = 0.5_f64 * v_G_z_per_u_hA;
    let t91 = 0.5_f64 * sin_thA;
    let t92 = 0.8660254037844386_f64 * t45;
    let t93 = t89 * t42 * t63 + (t89 * t90 * t74 + (t89 * (sin_thB + (t91 - t92)) - t10 * t82));
    let t94 = 0.8660254037844386_f64 * t78;
    let t95 = 0.5_f64 * t79;
    let t96 = 0.5_f64 * t22;
    let u_sB_per_u_hB = t91 - t96;
    let t97 = 0.4330127018922193_f64 * t28;
    let t98 = t3 - t97;
    let t99 = 0.4330127018922193_f64 * t17;
    let t100 = t8 + t99;
    let t101 = u_sB_per_u_hB * t46 + sA * (cos_thA * (sin_psiA * t98 + cos_psiA * t100) + sin_thA * u_sB_per_u_hB);
    let t102 = t101 + t48 * t98 - t37 * t100 - R * (0.5_f64 * t100 - 0.8660254037844386_f64 * t98);
    let t103 = t94 - (t95 + t102);
    let t104 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = t104 * v_G_z_per_u_hA;
    let u_psiC_per_w_platform_y = t104 * (0.5_f64 * t56);
    let t105 = 0.8660254037844386_f64 * (t16 - t12);
    let t106 = 0.8660254037844386_f64 * (t25 + t26);
    let t107 = t104 * ((t85 - t3) * t105 - (t83 - t8) * t106) - t104 * (0.8660254037844386_f64 * t56) * t82;
    let t108 = u_psiC_per_w_platform_z * t63 + (u_psiC_per_w_platform_y * t74 - t107);
    let t109 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_z = t109 * t56;
    let u_thC_per_w_platform_x = t109 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let t110 = u_thC_per_w_platform_z * t63 - (t109 * t90 * t74 + (u_thC_per_w_platform_x * t82 + t109 * (sin_thC + (t91 + t92))));
    let u_sC_per_u_hC = t91 + t96;
    let t111 = t3 + t97;
    let t112 = t99 - t8;
    let t113 = sA * (cos_thA * (sin_psiA * t111 - cos_psiA * t112) + sin_thA * u_sC_per_u_hC) - R * (0.8660254037844386_f64 * t111 - 0.5_f64 * t112);
    let t114 = u_sC_per_u_hC * t60 - t113 + t61 * t111 - t95 - t94 - t62 * t112;
    let t115 = sB * cos_thB;
    let t116 = sin_psiB * t115;
    let t117 = cos_psiB * t115;
    let k11 = p.k11;
    let t118 = k11 + (R - t51);
    let t119 = Real::max(Real::abs(0.5_f64 * t116 + t52 + 0.8660254037844386_f64 * (R - t117)), Real::abs(t118 - (0.5_f64 * t117 + 0.8660254037844386_f64 * t116)));
    let t120 = sC * cos_thC;
    let t121 = sin_psiC * t120;
    let t122 = cos_psiC * t120;
    let t123 = Real::max(Real::max(t119, Real::abs(hA - hB + t50 - sB * sin_thB)), Real::abs(0.5_f64 * t121 + t52 + 0.8660254037844386_f64 * (t122 - R)));
    let t124 = Real::max(Real::max(t123, Real::abs(0.8660254037844386_f64 * t121 - 0.5_f64 * t122 + t118)), Real::abs(sC * sin_thC + (hC - hA - t50)));
    let t125 = Real::max(Real::max(Real::max(t124, Real::abs(t2 + t84 - t106)), Real::abs(t105 - (t4 - t86))), Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t75, t77, t80, t88, -t93, t103, t108, t110, t114], t125)
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
