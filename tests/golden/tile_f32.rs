// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 587 operations (6 abs, 108 add, 3 cos, 12 div, 8 min, 352 mul, 4 sin, 94 sub).
// Cost of energy: 165 operations (32 add, 3 cos, 6 div, 103 mul, 4 sin, 17 sub).
// Cost of speeds: 142 operations (22 add, 3 cos, 9 div, 87 mul, 4 sin, 17 sub).
// Cost of outputs: 11 operations (1 add, 2 cos, 5 mul, 2 sin, 1 sub).
// Cost of projection: 420 operations (9 abs, 80 add, 7 cos, 10 div, 8 max, 223 mul, 7 sin, 1 sqrt, 75 sub).
// Cost of prepare: 159 operations (17 abs, 45 add, 9 div, 7 max, 77 mul, 4 sub).

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
/// Lowest and highest value of every tunable parameter, SI units.
pub const PARAMETER_RANGES: [[S; 2]; 13usize] = [
    [S::NEG_INFINITY, S::INFINITY],
    [0.0_f32, S::INFINITY],
    [0.0_f32, S::INFINITY],
    [0.0_f32, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [0.0_f32, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
];
impl Parameters {
    /// Is every parameter a finite number within its range?
    ///
    /// # Errors
    /// The first that is not, with its value and range.
    pub fn check(&self) -> Result<(), smartbed_runtime::mechanism::OutOfRange<S>> {
        let values = [
            self.R,
            self.ms,
            self.mr,
            self.mc,
            self.Ic1,
            self.Ic2,
            self.Ic3,
            self.M,
            self.Ix,
            self.Iy,
            self.Iz,
            self.c,
            self.g,
        ];
        smartbed_runtime::mechanism::check_parameters(&PARAMETER_NAMES, &values, &PARAMETER_RANGES)
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
    ///Of parameters alone.
    pub k21: S,
    ///Of parameters alone.
    pub k22: S,
    ///Of parameters alone.
    pub k23: S,
    ///Of parameters alone.
    pub k24: S,
    ///Of parameters alone.
    pub k25: S,
    ///Of parameters alone.
    pub k26: S,
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///159 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let R = p.R;
    let t1 = Real::max(5.0_f32 * Real::abs(R), 1e-24_f32);
    let t2 = 0.17320508_f32 * t1;
    let t3 = 0.3_f32 * t1;
    let t4 = 1.0_f32 / t2;
    let t5 = t3 * t4;
    let t6 = t3 + t2 * t5;
    let t7 = 1.1547005_f32 * t4;
    let t8 = t2 * t7;
    let t9 = 1.0_f32 / t6;
    let t10 = t9 * (1.1547005_f32 + t8);
    let t11 = t9 * t8;
    let t12 = 0.2309401_f32 * t1;
    let M = p.M;
    let t13 = Real::abs(M);
    let t14 = t12 * (0.57735026_f32 * t13);
    let t15 = 0.2_f32 * t1;
    let t16 = 1.3333334_f32 * t13;
    let t17 = t15 * t16;
    let t18 = t17 + 2.0_f32 * t14;
    let t19 = t14 + t17;
    let t20 = t13 * t12;
    let t21 = t12 * t20;
    let t22 = 2.3333333_f32 * t20;
    let t23 = t15 * (1.3471507_f32 * t13) + t22;
    let ms = p.ms;
    let mc = p.mc;
    let t24 = Real::abs(ms) + Real::abs(mc);
    let mr = p.mr;
    let t25 = Real::abs(mr) + t24;
    let Iz = p.Iz;
    let Ic2 = p.Ic2;
    let t26 = Iz + 3.0_f32 * Ic2;
    let t27 = Real::abs(Iz);
    let t28 = Real::abs(Ic2);
    let t29 = t27 + 3.0_f32 * t28;
    let Ic3 = p.Ic3;
    let t30 = t28 + Real::abs(Ic3);
    let Ic1 = p.Ic1;
    let t31 = t30 + (Real::abs(Ic1) + t30);
    let t32 = t21 + (t29 + 2.6666667_f32 * t31);
    let t33 = t15 * t18 + t32;
    let t34 = 1.0392305_f32 * t1;
    let t35 = 2.309401_f32 * t19;
    let t36 = 1.0_f32 / t34;
    let t37 = 2.0_f32 * t36;
    let t38 = t35 + t37 * t33;
    let t39 = t37 * (2.8867514_f32 * t31);
    let t40 = t37 * t38;
    let t41 = 1.7777778_f32 * t13 + t40;
    let t42 = 3.5_f32 * t36;
    let t43 = 2.0_f32 * t23;
    let t44 = t42 * (2.1666667_f32 * t31);
    let t45 = t42 * t33;
    let t46 = t43 + t45;
    let t47 = t42 * t45;
    let t48 = t42 * t46;
    let t49 = 5.4444447_f32 * t13 + t48;
    let t50 = 1.5_f32 * t28;
    let Ix = p.Ix;
    let t51 = Real::abs(Ix) + t50 + 3.125_f32 * t31;
    let t52 = Ic2 - Ic3;
    let t53 = 1.5_f32 * Ic2;
    let t54 = Ix + t53;
    let Iy = p.Iy;
    let t55 = Iy + t53;
    let t56 = Real::abs(Iy) + t50 + 1.0416666_f32 * t31;
    let t57 = t15 * t13;
    let t58 = t15 * t57 + t56;
    let t59 = 0.9021098_f32 * t31;
    let t60 = 1.8042196_f32 * t31;
    let t61 = t5 * t51;
    let t62 = t59 + t61;
    let t63 = t5 * (t60 + t61) + t58;
    let t64 = 1.1547005_f32 * t57;
    let t65 = t5 * t39;
    let t66 = t7 * t62;
    let t67 = t64 + (t65 + t66);
    let t68 = t66 + t44;
    let t69 = t7 * (2.0_f32 * t39 + t7 * t51) + t41;
    let t70 = t25 + t47;
    let t71 = t25 + t49;
    let t72 = t16 + (t25 + t69);
    let t73 = t10 * (2.0_f32 * t67 + t10 * t63) + t72;
    let t74 = 2.0_f32 * t68;
    let t75 = t11 * (t11 * t63 + t74) + t71;
    let t76 = 0.9622505_f32 / Real::max(0.9622505_f32 * Real::abs(t34), 1e-24_f32);
    let t77 = 5.773503_f32 / Real::max(5.773503_f32 * Real::abs(t2), 1e-24_f32);
    let t78 = 1.6666666_f32 / Real::max(1.6666666_f32 * Real::abs(t6), 1e-24_f32);
    let g = p.g;
    let t79 = ms * g;
    let t80 = ms + mc;
    let t81 = mc * g;
    let t82 = mr + t80;
    let t83 = g * t80;
    let t84 = Ic1 + t52;
    let t85 = 0.21680787_f32 / Real::max(0.063324384_f32 * Real::abs(t70), 1e-24_f32);
    let t86 = 0.21652833_f32 / Real::max(0.014571058_f32 * Real::abs(t73), 1e-24_f32);
    let t87 = 0.21706869_f32 / Real::max(0.011425393_f32 * Real::abs(t75), 1e-24_f32);
    let t88 = 0.5_f32 * R;
    let t89 = 0.57735026_f32 * M;
    let t90 = 1.3333334_f32 * M;
    let t91 = M * g;
    let t92 = 0.5_f32 * t84;
    let t93 = t26 - t55;
    let t94 = t54 - t26;
    let t95 = t55 - t54;
    let c = p.c;
    Prepared { R, M, c, g, k4: t88, k5: t52, k6: t79, k7: t81, k8: t83, k9: t91, k10: t82, k11: t89, k12: t90, k13: t84, k14: t54, k15: t55, k16: t26, k17: t92, k18: t93, k19: t94, k20: t95, k21: t76, k22: t77, k23: t78, k24: t86, k25: t85, k26: t87 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///587 operations.
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
    let psiA = q[1];
    let psiB = q[5];
    let t1 = psiA - psiB;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 0.5_f32 * t2;
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t4 = 0.5_f32 * sin_thA;
    let t5 = t4 - t3;
    let t6 = t4 + t3;
    let t7 = 0.28867513_f32 * t2;
    let t8 = 0.8660254_f32 * sin_thA;
    let t9 = t8 + t7;
    let t10 = t8 - t7;
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t11 = 1.7320508_f32 * (sA + (sB + sC));
    let k21 = p.k21;
    let t12 = Real::abs(t11) * k21;
    let t13 = 0.8660254_f32 * sC;
    let k22 = p.k22;
    let t14 = Real::abs(t13) * k22;
    let t15 = sA + 0.5_f32 * sB;
    let t16 = sA + 0.5_f32 * sC;
    let t17 = 1.0_f32 / t13;
    let w_platform_x_per_w_platform_y = t16 * t17;
    let t18 = 0.8660254_f32 * sB;
    let t19 = t15 + t18 * w_platform_x_per_w_platform_y;
    let k23 = p.k23;
    let t20 = Real::abs(t19) * k23;
    let u_sB_per_u_hB = 2.0_f32 * sin_thA;
    let t21 = t5 - u_sB_per_u_hB;
    let t22 = 1.0_f32 / t11;
    let t23 = t22 * t21;
    let t24 = t22 * t2;
    let u_hB = u[1];
    let u_hA = u[0];
    let t25 = u_hB * t23 + u_hA * t24;
    let (sin_angle43, _) = Real::sin_cos(2.0943952_f32 - t1);
    let t26 = cos_thA * sin_angle43;
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t26);
    let t27 = 1.0_f32 / t19;
    let w_platform_x_per_u_hA = t17 * v_G_z_per_u_hA;
    let t28 = t18 * w_platform_x_per_u_hA;
    let t29 = t27 * (v_G_z_per_u_hA + t28);
    let w_platform_y_per_u_hB = t27 * v_G_z_per_u_hA;
    let t30 = u_hB * w_platform_y_per_u_hB - u_hA * t29;
    let t31 = u_sB_per_u_hB - t6;
    let t32 = t22 * t31;
    let u_hC = u[2];
    let t33 = t25 + u_hC * t32;
    let t34 = 1.7320508_f32 * sB * t33;
    let t35 = u_hB * u_sB_per_u_hB + t34;
    let w_platform_y_per_u_hC = t27 * t28;
    let w_platform_y = t30 + u_hC * w_platform_y_per_u_hC;
    let t36 = 0.57735026_f32 * t2;
    let t37 = cos_thA * cos_thA;
    let t38 = 1.0_f32 / t37;
    let u_psiA_per_w_platform_z = t38 * v_G_z_per_u_hA;
    let t39 = t38 * t36;
    let t40 = t33 * u_psiA_per_w_platform_z + w_platform_y * t39;
    let t41 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t41 * v_G_z_per_u_hA;
    let t42 = t41 * t36;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t33 * t42;
    let t43 = u_hA * t36;
    let v_G_y = sA * t33 - t43;
    let t44 = 0.6666667_f32 * t31;
    let t45 = 1.1547005_f32 * sC;
    let t46 = t45 * t33;
    let t47 = u_hC * t44 - t46;
    let v_G_x = 0.57735026_f32 * v_G_y - t47;
    let w_platform_x = w_platform_x_per_u_hA * (u_hA - u_hC) + w_platform_x_per_w_platform_y * w_platform_y;
    let t48 = cos_thB * cos_thB;
    let t49 = Real::min(t37, t48);
    let t50 = 1.0_f32 / t48;
    let t51 = t50 * (0.8660254_f32 * t9);
    let u_psiB_per_w_platform_z = t50 * v_G_z_per_u_hA;
    let t52 = w_platform_x * t51 + t33 * u_psiB_per_w_platform_z;
    let t53 = t50 * (0.5_f32 * t9);
    let t54 = w_platform_y * t53 + t52;
    let t55 = 1.0_f32 / cos_thB;
    let t56 = 0.5_f32 * v_G_z_per_u_hA;
    let t57 = t55 * t56;
    let t58 = w_platform_y * t57 + t26 * w_platform_x;
    let t59 = t55 * t9;
    let u_thB = t33 * t59 - t58;
    let t60 = cos_thC * cos_thC;
    let t61 = Real::min(t49, t60);
    let t62 = 1.0_f32 / t60;
    let u_psiC_per_w_platform_y = t62 * (0.5_f32 * t10);
    let u_psiC_per_w_platform_z = t62 * v_G_z_per_u_hA;
    let t63 = t33 * u_psiC_per_w_platform_z - w_platform_y * u_psiC_per_w_platform_y;
    let t64 = t62 * (0.8660254_f32 * t10);
    let t65 = w_platform_x * t64 + t63;
    let t66 = 1.0_f32 / cos_thC;
    let t67 = t66 * t56;
    let u_thC_per_w_platform_x = t66 * (0.8660254_f32 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t66 * t10;
    let t68 = w_platform_y * t67 + t33 * u_thC_per_w_platform_z;
    let t69 = w_platform_x * u_thC_per_w_platform_x;
    let t70 = t69 - t68;
    let t71 = t68 - t69;
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let t72 = u_sC_per_w_platform_z * t33;
    let t73 = u_hC * u_sB_per_u_hB - t72;
    let t74 = u_hA * sin_thA + v_G_x;
    let t75 = 2.0_f32 * v_G_x;
    let u_sB = t35 + t75;
    let u_sC = t75 + t73;
    let t76 = 2.0_f32 * (t33 * t74);
    let t77 = w_platform_y * w_platform_x;
    let t78 = sA * t77 + t76;
    let t79 = 0.8660254_f32 * w_platform_y;
    let t80 = 0.5_f32 * w_platform_x;
    let t81 = t79 + t80;
    let t82 = t79 - t80;
    let t83 = 0.8660254_f32 * w_platform_x;
    let t84 = 0.5_f32 * w_platform_y;
    let t85 = t83 - t84;
    let t86 = t84 + t83;
    let t87 = 2.0_f32 * (t33 * u_sC);
    let t88 = t81 * t85;
    let t89 = sC * t88 + t87;
    let t90 = t33 * t81;
    let t91 = t10 * t90;
    let t92 = sC * t90;
    let t93 = 2.0_f32 * (u_sC * t85) - t92;
    let t94 = t85 * t85;
    let t95 = t33 * t33;
    let t96 = sC * (t94 + t95);
    let t97 = 0.8660254_f32 * t89;
    let u_sC_dot_bias = 2.0_f32 * (0.5_f32 * t96 - t97);
    let t98 = t96 - u_sC_dot_bias;
    let t99 = 2.0_f32 * (t33 * u_sB);
    let t100 = t82 * t86;
    let t101 = sB * t100 + t99;
    let t102 = t33 * w_platform_x;
    let t103 = t33 * t82;
    let k18 = p.k18;
    let t104 = t33 * w_platform_y * k18;
    let t105 = t95 + t86 * t86;
    let t106 = t9 * t103;
    let t107 = sB * t103;
    let t108 = sB * t105;
    let t109 = 2.0_f32 * (u_sB * t86) - t107;
    let t110 = 0.8660254_f32 * t101 + 0.5_f32 * t108;
    let t111 = 1.7320508_f32 * t78 - t98;
    let t112 = t22 * (t108 + (t111 - 2.0_f32 * t110));
    let t113 = sin_thB * t54;
    let k13 = p.k13;
    let t114 = k13 * (t113 * (cos_thB * t54));
    let t115 = t26 * t114;
    let t116 = t57 * t114;
    let t117 = t59 * t114;
    let t118 = sin_thB * (sin_thB * k13);
    let k5 = p.k5;
    let t119 = sin_thC * (sin_thC * k13) - k5;
    let t120 = t118 - k5;
    let t121 = u_psiC_per_w_platform_z * t119;
    let t122 = t64 * t121;
    let t123 = u_psiB_per_w_platform_z * t120;
    let t124 = t122 + t51 * t123;
    let t125 = sin_thC * t65;
    let t126 = k13 * (t125 * (cos_thC * t65));
    let t127 = t115 - u_thC_per_w_platform_x * t126;
    let t128 = t124 * t112 + t127;
    let t129 = t71 * (2.0_f32 * t125);
    let t130 = t67 * t126 + t116;
    let t131 = u_thC_per_w_platform_z * t126;
    let t132 = u_thB * (2.0_f32 * t113);
    let t133 = t50 * (t106 - cos_thB * t132 - v_G_z_per_u_hA * t100);
    let k17 = p.k17;
    let t134 = cos_thB * (2.0_f32 * (k17 * t132));
    let t135 = t134 - t120 * t133;
    let t136 = t51 * t135 + t128;
    let u_psiC_dot_bias = t62 * (t91 + cos_thC * t129 - v_G_z_per_u_hA * t88);
    let t137 = cos_thC * (2.0_f32 * (k17 * t129));
    let t138 = t119 * u_psiC_dot_bias + t137;
    let t139 = t136 - t64 * t138 - t104;
    let t140 = 2.0_f32 * (w_platform_y * t74);
    let t141 = sA * t102 - t140;
    let t142 = t17 * (t141 - t93);
    let t143 = t27 * (t18 * t142 + (t141 + t109));
    let k14 = p.k14;
    let t144 = k14 + (t64 * (t64 * t119) + t51 * (t51 * t120));
    let t145 = u_psiC_per_w_platform_y * t119;
    let t146 = t64 * t145;
    let t147 = t53 * t120;
    let t148 = t51 * t147 - t146;
    let t149 = u_psiC_per_w_platform_y * t145 + t53 * t147;
    let t150 = t142 * t144 + t139;
    let t151 = k13 * (sin_thA * t40 * (cos_thA * t40));
    let t152 = t130 - u_thA_per_w_platform_y * t151;
    let t153 = t42 * t151;
    let t154 = k5 - sin_thA * (sin_thA * k13);
    let t155 = u_psiC_per_w_platform_y * t121;
    let t156 = u_psiC_per_w_platform_y * t138;
    let t157 = u_psiC_per_w_platform_z * t138;
    let t158 = u_psiC_per_w_platform_z * t121;
    let t159 = t155 - t53 * t123;
    let t160 = t53 * t135;
    let t161 = u_psiB_per_w_platform_z * t135;
    let t162 = t158 + u_psiB_per_w_platform_z * t123;
    let t163 = u_psiA_per_w_platform_z * t154;
    let t164 = t39 * t163 + t159;
    let k16 = p.k16;
    let t165 = k16 + (t162 - u_psiA_per_w_platform_z * t163);
    let t166 = t152 - t164 * t112;
    let t167 = t156 + (t160 + (t148 * t142 + t166));
    let t168 = u_sB_per_u_hB * (t40 * u_thA);
    let t169 = k17 * t168;
    let t170 = 2.0_f32 * cos_thA * t169;
    let t171 = cos_thA * t168;
    let t172 = t36 * t102 + t171;
    let k19 = p.k19;
    let t173 = t102 * k19;
    let t174 = t170 - t154 * (t38 * (t172 - v_G_z_per_u_hA * t77));
    let t175 = t149 - t39 * (t39 * t154);
    let t176 = t39 * t174 + t167 - t173;
    let t177 = w_platform_x_per_w_platform_y * t150 + t176;
    let t178 = u_psiA_per_w_platform_z * t174;
    let k15 = p.k15;
    let t179 = k15 + t175;
    let k20 = p.k20;
    let t180 = t157 + (t77 * k20 + t117 - t153 - t131 - t178 - t161);
    let t181 = 2.0_f32 * t148;
    let t182 = w_platform_x_per_w_platform_y * t144;
    let t183 = t181 + t182;
    let t184 = t148 + t182;
    let M = p.M;
    let t185 = sA * M;
    let t186 = sA * t185 + t179;
    let t187 = w_platform_x_per_w_platform_y * t183 + t186;
    let t188 = t177 - t143 * t187;
    let t189 = M * t45;
    let t190 = t45 * t189 + t165;
    let v_G_x_dot_bias = 0.6666667_f32 * t98;
    let t191 = M * v_G_x_dot_bias;
    let k9 = p.k9;
    let t192 = sin_thA * k9 - t191;
    let t193 = M * t141 + k9 * v_G_z_per_u_hA;
    let t194 = sA * t193 + t188;
    let t195 = t24 * t124;
    let t196 = w_platform_x_per_w_platform_y * t195 - t24 * t164;
    let t197 = w_platform_x_per_u_hA * t184;
    let t198 = t185 * v_G_z_per_u_hA + (t197 + t196);
    let t199 = t23 * t164;
    let t200 = t23 * t124;
    let t201 = t199 - w_platform_x_per_w_platform_y * t200;
    let t202 = t32 * t164;
    let t203 = t32 * t124;
    let t204 = t197 + (t202 - w_platform_x_per_w_platform_y * t203);
    let t205 = 2.0_f32 * t198;
    let t206 = t29 * t187 - t205;
    let t207 = w_platform_x_per_u_hA * t144;
    let t208 = 2.0_f32 * t195 + t207;
    let t209 = t207 + (t195 - t203);
    let t210 = 2.0_f32 * t203 - t207;
    let t211 = w_platform_x_per_u_hA * t150;
    let t212 = t195 * t142;
    let t213 = t203 * t142;
    let t214 = t200 * t142;
    let t215 = w_platform_x_per_u_hA * t200;
    let t216 = w_platform_x_per_u_hA * t208;
    let t217 = w_platform_x_per_u_hA * t209;
    let t218 = w_platform_x_per_u_hA * t210;
    let t219 = v_G_z_per_u_hA * t193;
    let t220 = v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let FB = inputs[1];
    let t221 = t214 + t143 * t201 - FB;
    let t222 = w_platform_y_per_u_hC * t187;
    let t223 = t222 - 2.0_f32 * t204;
    let t224 = t222 - t204;
    let t225 = t143 * t204;
    let t226 = t143 * t198;
    let t227 = w_platform_y_per_u_hB * t187;
    let t228 = 2.0_f32 * t201 - t227;
    let t229 = t29 * (t201 - t227);
    let t230 = w_platform_y_per_u_hB * t198;
    let t231 = w_platform_y_per_u_hC * t198;
    let t232 = t29 * t206;
    let t233 = w_platform_y_per_u_hB * t228;
    let t234 = t29 * t194;
    let t235 = t29 * t224;
    let t236 = w_platform_y_per_u_hB * t224;
    let t237 = w_platform_y_per_u_hB * t194;
    let t238 = w_platform_y_per_u_hC * t194;
    let t239 = w_platform_y_per_u_hC * t201;
    let t240 = w_platform_y_per_u_hC * t223;
    let t241 = t189 * t44;
    let k11 = p.k11;
    let t242 = k11 * t44;
    let t243 = sA * t242 + t241;
    let t244 = t45 * k11;
    let t245 = t45 * t192;
    let t246 = t44 * (M * t44);
    let t247 = t44 * t192;
    let t248 = 0.57735026_f32 * t192;
    let k12 = p.k12;
    let t249 = k12 * t78 + t248;
    let t250 = k9 * t36 + t249;
    let t251 = 2.0_f32 * t244;
    let t252 = sA * k12;
    let t253 = sA * (t252 + t251) + t190;
    let t254 = t244 + t252;
    let t255 = t244 * t78;
    let t256 = t242 * t78;
    let t257 = t36 * t242;
    let t258 = t254 * t36;
    let t259 = sA * t250;
    let t260 = t36 * t250;
    let t261 = t36 * (k12 * t36);
    let FA = inputs[0];
    let t262 = t212 - t258 * t112 - FA;
    let t263 = t245 + (t259 + (t255 + (t180 - t253 * t112)));
    let FC = inputs[2];
    let t264 = t256 + (t213 - t243 * t112 - FC);
    let t265 = t260 + (t262 - t24 * t263);
    let t266 = t225 - t211;
    let t267 = t211 + t265 - t226;
    let t268 = t23 * t258;
    let t269 = t23 * t253;
    let mass_u_hA_u_hB = t230 - (t268 - t24 * t269 - t215 - t229);
    let t270 = t216 + (t261 + t24 * (t24 * t253 - 2.0_f32 * t258));
    let t271 = t257 - t32 * t258;
    let k10 = p.k10;
    let mass_u_hA_u_hA = t232 + (t220 + (k10 + t270));
    let mass_u_hB_u_hB = k10 + t23 * t269 - t233;
    let k24 = p.k24;
    let t272 = Real::abs(mass_u_hA_u_hA) * k24;
    let t273 = 1.0_f32 / mass_u_hA_u_hA;
    let t274 = t273 * mass_u_hA_u_hB;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t274;
    let t275 = t247 - t32 * t263;
    let k25 = p.k25;
    let t276 = Real::abs(pivot_1) * k25;
    let t277 = t32 * t253;
    let t278 = t277 - t243;
    let mass_u_hA_u_hC = t231 + (t24 * t278 + t271 - t235) - t217;
    let t279 = t23 * t263;
    let mass_u_hB_u_hC = t236 - (t215 - t23 * t278) - t239;
    let mass_u_hC_u_hC = t240 + (k10 + (t246 + t32 * (t277 - 2.0_f32 * t243) - t218));
    let t280 = t274 * mass_u_hA_u_hC - mass_u_hB_u_hC;
    let t281 = t273 * mass_u_hA_u_hC;
    let t282 = mass_u_hC_u_hC - mass_u_hA_u_hC * t281;
    let t283 = 1.0_f32 / pivot_1;
    let t284 = t283 * t280;
    let pivot_2 = t282 - t280 * t284;
    let k26 = p.k26;
    let t285 = Real::min(Real::min(Real::min(Real::min(Real::min(Real::min(Real::abs(pivot_2) * k26, t276), t272), t20), t14), t12), t61);
    let k8 = p.k8;
    let t286 = k8 + t267;
    let c = p.c;
    let forcing_u_hA = t234 - (t219 + (u_hA * c + t286));
    let t287 = t274 * forcing_u_hA + t221 - t279;
    let t288 = t273 * forcing_u_hA;
    let t289 = t281 * forcing_u_hA + t266;
    let t290 = k8 + t287;
    let t291 = t237 + (u_hB * c + t290);
    let t292 = t283 * t291;
    let t293 = k8 + (t284 * t291 + t264 + t289 + t275);
    let t294 = (t238 + (u_hC * c + t293)) / pivot_2;
    let t295 = t284 * t294 + t292;
    let t296 = t288 + (t281 * t294 + t274 * t295);
    ([u_hA, -t40, u_thA, -t74, u_hB, -t54, u_thB, u_sB, u_hC, -t65, t70, u_sC], [t296, -t295, -t294], t285)
}
///Kinetic and potential energy (J).
///
///165 operations.
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
    let sA = q[3];
    let sB = q[7];
    let t1 = sA + 0.5_f32 * sB;
    let sC = q[11];
    let t2 = sA + 0.5_f32 * sC;
    let t3 = 1.0_f32 / (0.8660254_f32 * sC);
    let w_platform_x_per_w_platform_y = t2 * t3;
    let t4 = 0.8660254_f32 * sB;
    let t5 = 1.0_f32 / (t1 + t4 * w_platform_x_per_w_platform_y);
    let psiA = q[1];
    let psiB = q[5];
    let (sin_angle11, _) = Real::sin_cos(2.0943952_f32 - (psiA - psiB));
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t6 = 1.1547005_f32 * (cos_thA * sin_angle11);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let v_G_z_per_u_hA = cos_thB * t6;
    let w_platform_x_per_u_hA = t3 * v_G_z_per_u_hA;
    let t7 = t4 * w_platform_x_per_u_hA;
    let u_hA = u[0];
    let t8 = u_hA * (t5 * (v_G_z_per_u_hA + t7));
    let w_platform_y_per_u_hB = t5 * v_G_z_per_u_hA;
    let u_hB = u[1];
    let t9 = u_hB * w_platform_y_per_u_hB - t8;
    let w_platform_y_per_u_hC = t5 * t7;
    let u_hC = u[2];
    let w_platform_y = t9 + u_hC * w_platform_y_per_u_hC;
    let t10 = w_platform_x_per_w_platform_y * w_platform_y;
    let w_platform_x = w_platform_x_per_u_hA * (u_hA - u_hC) + t10;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t11 = sin_thB - sin_thC;
    let t12 = 0.28867513_f32 * t11;
    let t13 = 0.8660254_f32 * sin_thA;
    let t14 = t13 + t12;
    let t15 = 0.8660254_f32 * t14;
    let t16 = 1.0_f32 / (cos_thB * cos_thB);
    let t17 = w_platform_x * (t16 * t15);
    let t18 = 1.0_f32 / (1.7320508_f32 * (sA + (sB + sC)));
    let t19 = 0.5_f32 * t11;
    let t20 = 0.5_f32 * sin_thA;
    let t21 = t20 - t19;
    let u_sB_per_u_hB = 2.0_f32 * sin_thA;
    let t22 = u_hB * (t18 * (t21 - u_sB_per_u_hB)) + u_hA * (t18 * t11);
    let t23 = u_sB_per_u_hB - (t20 + t19);
    let t24 = t22 + u_hC * (t18 * t23);
    let u_psiB_per_w_platform_z = t16 * v_G_z_per_u_hA;
    let t25 = t17 + t24 * u_psiB_per_w_platform_z;
    let t26 = w_platform_y * (t16 * (0.5_f32 * t14)) + t25;
    let t27 = t26 * t26;
    let k13 = p.k13;
    let k5 = p.k5;
    let t28 = (sin_thB * (sin_thB * k13) - k5) * t27;
    let t29 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = t29 * v_G_z_per_u_hA;
    let t30 = t24 * u_psiC_per_w_platform_z;
    let t31 = t13 - t12;
    let u_psiC_per_w_platform_y = t29 * (0.5_f32 * t31);
    let t32 = t30 - w_platform_y * u_psiC_per_w_platform_y;
    let t33 = w_platform_x * (t29 * (0.8660254_f32 * t31)) + t32;
    let t34 = t33 * t33;
    let t35 = t28 + (sin_thC * (sin_thC * k13) - k5) * t34;
    let t36 = 1.0_f32 / (cos_thA * cos_thA);
    let u_psiA_per_w_platform_z = t36 * v_G_z_per_u_hA;
    let t37 = t24 * u_psiA_per_w_platform_z;
    let t38 = 0.57735026_f32 * t11;
    let t39 = t37 + w_platform_y * (t36 * t38);
    let t40 = t39 * t39;
    let t41 = t35 - (k5 - sin_thA * (sin_thA * k13)) * t40;
    let k16 = p.k16;
    let t42 = k16 * (t24 * t24) + t41;
    let v_G_y = sA * t24 - u_hA * t38;
    let M = p.M;
    let t43 = M * (v_G_y * v_G_y) + t42;
    let t44 = 0.57735026_f32 * v_G_y;
    let t45 = 1.1547005_f32 * sC * t24;
    let v_G_x = t44 - (u_hC * (0.6666667_f32 * t23) - t45);
    let t46 = M * (v_G_x * v_G_x) + t43;
    let k14 = p.k14;
    let t47 = k14 * (w_platform_x * w_platform_x) + t46;
    let k15 = p.k15;
    let t48 = k15 * (w_platform_y * w_platform_y) + t47;
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t49 = M * (v_G_z * v_G_z);
    let k10 = p.k10;
    let t50 = t48 + (k10 * (u_hB * u_hB) + t49);
    let t51 = 0.5_f32 * (k10 * (u_hA * u_hA) + k10 * (u_hC * u_hC) + t50);
    let hB = q[4];
    let k6 = p.k6;
    let hA = q[0];
    let k8 = p.k8;
    let k7 = p.k7;
    let hC = q[8];
    let t52 = hB * k6 + hA * k8 + (hB * k7 + hC * k8);
    let g = p.g;
    let t53 = M * (hA * g + sin_thA * (sA * g)) + t52;
    (t51, t53)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///142 operations.
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
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t1 = 1.0_f32 / (1.7320508_f32 * (sA + (sB + sC)));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t2 = sin_thB - sin_thC;
    let t3 = 0.5_f32 * t2;
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t4 = 0.5_f32 * sin_thA;
    let t5 = t4 - t3;
    let u_sB_per_u_hB = 2.0_f32 * sin_thA;
    let u_hB = u[1];
    let u_hA = u[0];
    let t6 = u_hB * (t1 * (t5 - u_sB_per_u_hB)) + u_hA * (t1 * t2);
    let t7 = u_sB_per_u_hB - (t4 + t3);
    let u_hC = u[2];
    let t8 = t6 + u_hC * (t1 * t7);
    let psiA = q[1];
    let psiB = q[5];
    let (sin_angle23, _) = Real::sin_cos(2.0943952_f32 - (psiA - psiB));
    let t9 = cos_thA * sin_angle23;
    let v_G_z_per_u_hA = cos_thB * (1.1547005_f32 * t9);
    let t10 = 1.0_f32 / (cos_thA * cos_thA);
    let u_psiA_per_w_platform_z = t10 * v_G_z_per_u_hA;
    let t11 = t8 * u_psiA_per_w_platform_z;
    let t12 = sA + 0.5_f32 * sB;
    let t13 = sA + 0.5_f32 * sC;
    let t14 = 1.0_f32 / (0.8660254_f32 * sC);
    let w_platform_x_per_w_platform_y = t13 * t14;
    let t15 = 0.8660254_f32 * sB;
    let t16 = 1.0_f32 / (t12 + t15 * w_platform_x_per_w_platform_y);
    let w_platform_x_per_u_hA = t14 * v_G_z_per_u_hA;
    let t17 = t15 * w_platform_x_per_u_hA;
    let t18 = u_hA * (t16 * (v_G_z_per_u_hA + t17));
    let w_platform_y_per_u_hB = t16 * v_G_z_per_u_hA;
    let t19 = u_hB * w_platform_y_per_u_hB - t18;
    let w_platform_y_per_u_hC = t16 * t17;
    let w_platform_y = t19 + u_hC * w_platform_y_per_u_hC;
    let t20 = 0.57735026_f32 * t2;
    let t21 = t11 + w_platform_y * (t10 * t20);
    let t22 = 1.0_f32 / cos_thA;
    let u_thA_per_w_platform_y = t22 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t8 * (t22 * t20);
    let v_G_y = sA * t8 - u_hA * t20;
    let t23 = 0.57735026_f32 * v_G_y;
    let t24 = 1.1547005_f32 * sC * t8;
    let v_G_x = t23 - (u_hC * (0.6666667_f32 * t7) - t24);
    let t25 = u_hA * sin_thA + v_G_x;
    let t26 = w_platform_x_per_w_platform_y * w_platform_y;
    let w_platform_x = w_platform_x_per_u_hA * (u_hA - u_hC) + t26;
    let t27 = 0.28867513_f32 * t2;
    let t28 = 0.8660254_f32 * sin_thA;
    let t29 = t28 + t27;
    let t30 = 0.8660254_f32 * t29;
    let t31 = 1.0_f32 / (cos_thB * cos_thB);
    let t32 = w_platform_x * (t31 * t30);
    let u_psiB_per_w_platform_z = t31 * v_G_z_per_u_hA;
    let t33 = t32 + t8 * u_psiB_per_w_platform_z;
    let t34 = w_platform_y * (t31 * (0.5_f32 * t29)) + t33;
    let t35 = 0.5_f32 * v_G_z_per_u_hA;
    let t36 = 1.0_f32 / cos_thB;
    let t37 = w_platform_y * (t36 * t35) + t9 * w_platform_x;
    let u_thB = t8 * (t36 * t29) - t37;
    let t38 = 2.0_f32 * v_G_x;
    let t39 = 1.7320508_f32 * sB * t8;
    let u_sB = u_hB * u_sB_per_u_hB + t39 + t38;
    let t40 = 1.0_f32 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = t40 * v_G_z_per_u_hA;
    let t41 = t8 * u_psiC_per_w_platform_z;
    let t42 = t28 - t27;
    let u_psiC_per_w_platform_y = t40 * (0.5_f32 * t42);
    let t43 = t41 - w_platform_y * u_psiC_per_w_platform_y;
    let t44 = w_platform_x * (t40 * (0.8660254_f32 * t42)) + t43;
    let t45 = 1.0_f32 / cos_thC;
    let t46 = w_platform_y * (t45 * t35);
    let u_thC_per_w_platform_z = t45 * t42;
    let t47 = t46 + t8 * u_thC_per_w_platform_z;
    let u_thC_per_w_platform_x = t45 * (0.8660254_f32 * v_G_z_per_u_hA);
    let t48 = w_platform_x * u_thC_per_w_platform_x - t47;
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let t49 = u_sC_per_w_platform_z * t8;
    let u_sC = t38 + (u_hC * u_sB_per_u_hB - t49);
    [u_hA, -t21, u_thA, -t25, u_hB, -t34, u_thB, u_sB, u_hC, -t44, t48, u_sC]
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
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let sA = q[3];
    let t1 = sA * (cos_thA * sin_psiA);
    let R = p.R;
    let t2 = R - sA * (cos_thA * cos_psiA);
    let hA = q[0];
    let t3 = hA + sA * sin_thA;
    [t1, t2, t3]
}
///Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them.
///
///420 operations.
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
    let sC = q[11];
    let t1 = 0.8660254_f32 * sC;
    let t2 = 0.5_f32 * sC;
    let t3 = 1.0_f32 / t1;
    let sA = q[3];
    let w_platform_x_per_w_platform_y = (sA + t2) * t3;
    let sB = q[7];
    let t4 = 0.8660254_f32 * sB;
    let t5 = 0.5_f32 * sB;
    let t6 = sA + t5 + t4 * w_platform_x_per_w_platform_y;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t7 = sin_thB - sin_thC;
    let t8 = 0.28867513_f32 * t7;
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t9 = 0.8660254_f32 * sin_thA;
    let t10 = t9 + t8;
    let t11 = t9 - t8;
    let hB = q[4];
    let t12 = hB + sB * sin_thB;
    let hC = q[8];
    let t13 = hC + sC * sin_thC;
    let t14 = sA * sin_thA;
    let hA = q[0];
    let t15 = hA + t14;
    let t16 = t15 - t12;
    let t17 = t13 - t15;
    let t18 = 0.57735026_f32 * cos_thB;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let t19 = t18 * cos_psiB + cos_thB * sin_psiB;
    let t20 = 0.57735026_f32 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t21 = t20 * cos_psiC;
    let t22 = cos_thC * sin_psiC;
    let t23 = t21 - t22;
    let t24 = t22 + (t19 - t21);
    let t25 = t18 * sin_psiB;
    let t26 = cos_thB * cos_psiB - t25;
    let t27 = t20 * sin_psiC;
    let t28 = sC * cos_thC;
    let t29 = sin_psiC * t28;
    let t30 = cos_psiC * t28;
    let t31 = cos_thC * cos_psiC;
    let t32 = t27 + t31;
    let t33 = t31 + (t27 + t26);
    let psiA = q[1];
    let t34 = psiA - psiB;
    let t35 = 0.57735026_f32 * t7;
    let t36 = 0.5_f32 * t24;
    let t37 = sin_thA * t36;
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t38 = cos_thA * cos_psiA;
    let t39 = t37 + t38 * t35;
    let t40 = 0.5_f32 * t33;
    let t41 = sin_thA * t40;
    let t42 = cos_thA * sin_psiA;
    let t43 = t42 * t35 - t41;
    let t44 = t39 * t39 + t43 * t43;
    let t45 = t42 * t36 + t38 * t40;
    let t46 = 1.0_f32 / Real::sqrt(t44 + t45 * t45);
    let t47 = t43 * t46;
    let t48 = t39 * t46;
    let t49 = t45 * t46;
    let t50 = t42 * t47 + t38 * t48;
    let t51 = sin_thA * t5 - t4 * t50 - hB;
    let t52 = sin_thA * t47 - t38 * t49;
    let t53 = sin_thA * t48 + t42 * t49;
    let t54 = t4 * t52;
    let t55 = t42 * t5 + t54;
    let t56 = hA + t51;
    let t57 = sin_thA * t56 + t42 * t55;
    let t58 = t38 * t5 + t4 * t53;
    let R = p.R;
    let t59 = R - t58;
    let t60 = sA - t38 * t59;
    let t61 = 0.8660254_f32 * t42;
    let t62 = 0.5_f32 * t38;
    let t63 = t57 + (R * (t61 - t62) + t60);
    let t64 = hC - (sin_thA * t2 + t1 * t50) - hA;
    let t65 = 0.5_f32 * t7;
    let t66 = 0.5_f32 * sin_thA;
    let t67 = t66 + t65;
    let t68 = t66 - t65;
    let t69 = sin_thC + (sin_thA + sin_thB);
    let t70 = 0.8660254_f32 * t50;
    let t71 = sin_thC + t70;
    let t72 = t66 + (sin_thB - t70);
    let t73 = t66 + t71;
    let t74 = t1 * t52 - t42 * t2;
    let t75 = t1 * t53;
    let t76 = t38 * t2 - t75;
    let t77 = sin_thA * t64 + t42 * t74;
    let t78 = R * (t61 + t62);
    let t79 = R - t76;
    let t80 = t77 + (t78 + (t38 * t79 - sA));
    let t81 = 0.4330127_f32 * t24;
    let t82 = 0.4330127_f32 * t33;
    let t83 = 0.5_f32 * t42;
    let t84 = t83 + t82;
    let t85 = 0.8660254_f32 * t84;
    let t86 = t81 - t62;
    let t87 = R * (t85 - 0.5_f32 * t86) + t84 * t74;
    let t88 = 2.0_f32 * t80;
    let t89 = t88 - t67 * t64 - t87;
    let t90 = sin_psiA * t84;
    let t91 = t86 * t79;
    let t92 = t90 - cos_psiA * t86;
    let t93 = sin_thA * t67;
    let t94 = t91 + (sA * (t93 + cos_thA * t92) + t89);
    let t95 = 0.8660254_f32 * (t30 - R);
    let t96 = sA * t42;
    let t97 = t96 + t95;
    let t98 = 0.5_f32 * t29 + t97;
    let t99 = sA * t38;
    let t100 = t99 * t36 - t96 * t40;
    let t101 = t14 * t35 - t100;
    let t102 = cos_psiA * t36;
    let t103 = cos_thA * (sin_psiA * t40 - t102);
    let t104 = t101 - sA * (sin_thA * t35 + t103);
    let t105 = t83 - t82;
    let t106 = t62 + t81;
    let t107 = cos_thA * (cos_psiA * t106 + sin_psiA * t105);
    let t108 = sin_thA * t68 + t107;
    let t109 = t68 * t56;
    let t110 = 2.0_f32 * t63;
    let t111 = t110 + (t94 + 1.7320508_f32 * t104) - t109;
    let t112 = t106 * t59;
    let t113 = 0.5_f32 * t106 - 0.8660254_f32 * t105;
    let t114 = t105 * t55;
    let t115 = t112 + (t111 + (R * t113 - t114) - sA * t108);
    let t116 = 1.0_f32 / (1.7320508_f32 * (sA + (sB + sC))) * t115;
    let t117 = 1.7320508_f32 * sB * t116 - t110;
    let u_sC_per_w_platform_z = 1.7320508_f32 * sC;
    let t118 = t88 - u_sC_per_w_platform_z * t116;
    let (sin_angle139, cos_angle139) = Real::sin_cos(2.0943952_f32 - t34);
    let t119 = sin_thB * (cos_thA * cos_angle139) - sin_thA * cos_thB;
    let t120 = cos_thA * sin_angle139;
    let t121 = 1.1547005_f32 * t119;
    let t122 = 1.1547005_f32 * t120;
    let t123 = sin_thB * t122;
    let t124 = cos_psiB * t121 + sin_psiB * t123;
    let t125 = sin_psiB * t121;
    let t126 = cos_psiB * t123 - t125;
    let t127 = sB * cos_thB;
    let t128 = cos_psiB * t127;
    let t129 = sin_psiB * t127;
    let t130 = 0.5_f32 * t124 - 0.8660254_f32 * t126;
    let t131 = 0.8660254_f32 * t124 + 0.5_f32 * t126;
    let v_G_z_per_u_hA = cos_thB * t122;
    let t132 = v_G_z_per_u_hA * t56;
    let t133 = R * (t126 + t131) - t132;
    let t134 = 0.5_f32 * t131 + 0.8660254_f32 * t130;
    let t135 = v_G_z_per_u_hA * t64;
    let t136 = R * (t131 + t134) + t135;
    let t137 = t130 * t74 + t136;
    let t138 = sin_thA * t14;
    let t139 = t14 * v_G_z_per_u_hA;
    let t140 = t131 * t76;
    let t141 = t131 * t58;
    let t142 = t99 * t131 + t139;
    let t143 = t130 * t55;
    let t144 = t96 * t130 + t142;
    let t145 = t3 * (t137 - (t144 + t140));
    let t146 = t4 * t145 - t144 - t141 - t143 + t133;
    let t147 = 1.0_f32 / t6 * t146;
    let t148 = 1.0_f32 / (cos_thA * cos_thA);
    let t149 = t148 * t35;
    let u_psiA_per_w_platform_z = t148 * v_G_z_per_u_hA;
    let t150 = u_psiA_per_w_platform_z * t116 + t149 * t147;
    let t151 = 1.0_f32 / cos_thA;
    let t152 = t151 * t35 * t116;
    let u_thA_per_w_platform_y = t151 * v_G_z_per_u_hA;
    let t153 = u_thA_per_w_platform_y * t147 - t152;
    let t154 = t145 - w_platform_x_per_w_platform_y * t147;
    let t155 = 1.0_f32 / (cos_thB * cos_thB);
    let t156 = t155 * (0.8660254_f32 * t10);
    let t157 = t155 * (0.5_f32 * t10);
    let t158 = t156 * t154 - t157 * t147;
    let t159 = 1.0_f32 / (cos_thC * cos_thC);
    let t160 = t159 * (0.8660254_f32 * t11);
    let u_psiC_per_w_platform_y = t159 * (0.5_f32 * t11);
    let t161 = t160 * t154;
    let t162 = u_psiC_per_w_platform_y * t147 + t161;
    let t163 = sA * t116 - t104;
    let t164 = 1.1547005_f32 * sC * t116;
    let t165 = 0.57735026_f32 * t163 + t164;
    let t166 = 0.6666667_f32 * t94 - t165;
    let t167 = t166 - t42 * t96 - t138;
    let t168 = 2.0_f32 * t166;
    let t169 = t117 - t168;
    let t170 = t118 - t168;
    let t171 = t167 + (sA - t38 * t99);
    let t172 = R - t99;
    let t173 = t96 + 0.8660254_f32 * (R - t128);
    let k4 = p.k4;
    let t174 = k4 + t172;
    let t175 = 0.5_f32 * t30;
    let t176 = t174 - 0.5_f32 * t128;
    let t177 = t174 - t175;
    let t178 = 0.8660254_f32 * t29 + t177;
    let u_psiB_per_w_platform_z = t155 * v_G_z_per_u_hA;
    let t179 = t158 - u_psiB_per_w_platform_z * t116;
    let t180 = 0.8660254_f32 * t53;
    let t181 = t62 + t180;
    let t182 = t180 - t62;
    let t183 = 0.8660254_f32 * t32;
    let t184 = 0.8660254_f32 * t26;
    let t185 = t184 * t181;
    let t186 = t183 * t182;
    let t187 = t42 + (t184 - t183);
    let t188 = 0.8660254_f32 * t19;
    let t189 = 0.8660254_f32 * t52;
    let t190 = t38 - t188;
    let t191 = t155 * (t185 + t188 * (t83 + t189)) + t179;
    let t192 = t189 - t83;
    let t193 = 0.8660254_f32 * t23;
    let t194 = t193 - t190;
    let t195 = t193 * t192 - t186;
    let t196 = 1.0_f32 / cos_thB;
    let t197 = 1.0_f32 / cos_thC;
    let t198 = t196 * t10;
    let u_thC_per_w_platform_z = t197 * t11;
    let t199 = t198 * t116;
    let t200 = u_thC_per_w_platform_z * t116;
    let t201 = t159 * t195;
    let u_psiC_per_w_platform_z = t159 * v_G_z_per_u_hA;
    let t202 = t162 - u_psiC_per_w_platform_z * t116 - t201;
    let t203 = t196 * t72;
    let t204 = 0.5_f32 * v_G_z_per_u_hA;
    let t205 = t199 - t196 * t204 * t147 - t203;
    let t206 = t120 * t154 + t205;
    let u_thC_per_w_platform_x = t197 * (0.8660254_f32 * v_G_z_per_u_hA);
    let t207 = u_thC_per_w_platform_x * t154 + (t197 * t73 + (t200 + t197 * t204 * t147));
    let t208 = 0.5_f32 * t129 + t173;
    let t209 = t176 - 0.8660254_f32 * t129;
    let t210 = Real::max(Real::max(Real::max(Real::max(Real::abs(t208), Real::abs(t209)), Real::abs(t16)), Real::abs(t98)), Real::abs(t178));
    let t211 = Real::max(Real::max(Real::max(Real::max(t210, Real::abs(t17)), Real::abs(t187)), Real::abs(t194)), Real::abs(t69));
    ([-t150, t153, t171, t191, t206, t169, t202, -t207, t170], t211)
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
