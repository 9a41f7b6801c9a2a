// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 548 operations (6 abs, 92 add, 13 div, 8 min, 332 mul, 4 sqrt, 93 sub).
// Cost of energy: 185 operations (40 add, 7 div, 118 mul, 1 sqrt, 19 sub).
// Cost of speeds: 180 operations (31 add, 10 div, 112 mul, 4 sqrt, 23 sub).
// Cost of outputs: 78 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 42 mul, 1 sin, 2 sqrt, 11 sub).
// Cost of projection: 0 operations ().
// Cost of prepare: 207 operations (17 abs, 51 add, 13 div, 7 max, 113 mul, 1 sqrt, 5 sub).

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
///207 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let R = p.R;
    let t1 = Real::abs(R);
    let t2 = 1.0_f32 / (3.0_f32 * t1);
    let t3 = Real::max(5.0_f32 * t1, 1e-24_f32);
    let t4 = t2 * (3.4641016_f32 * t3);
    let t5 = t2 * (4.0_f32 * t3);
    let t6 = t4 * t4;
    let t7 = t5 * t5;
    let t8 = t6 + t7;
    let t9 = t7 + 0.5_f32 * t8;
    let t10 = Real::sqrt(1.0_f32 + t8);
    let t11 = 1.0_f32 + t10;
    let t12 = 1.0_f32 / t11;
    let t13 = 1.0_f32 + t9 * t12;
    let t14 = t1 * (1.0_f32 + (t6 + 0.8660254_f32 * (t4 * (2.0_f32 * t5))) * t12);
    let t15 = t1 * (1.0_f32 + t6 * t12);
    let t16 = 0.8660254_f32 * t14;
    let t17 = 0.5_f32 * t14;
    let t18 = t1 * t13;
    let t19 = t18 + t17;
    let t20 = 1.0_f32 / t16;
    let t21 = t20 * t19;
    let t22 = 0.8660254_f32 * t15;
    let t23 = t18 + 0.5_f32 * t15;
    let t24 = t21 * t22 + t23;
    let t25 = 1.0_f32 / t10;
    let t26 = t4 * t12;
    let t27 = 0.8660254_f32 * t4;
    let t28 = t5 * t12;
    let t29 = 0.5_f32 * t5;
    let t30 = (t27 + t29) * t25;
    let t31 = 0.8660254_f32 * (t5 * t25);
    let t32 = 0.28867513_f32 * t30 + t31;
    let ms = p.ms;
    let mc = p.mc;
    let t33 = Real::abs(ms) + Real::abs(mc);
    let mr = p.mr;
    let t34 = Real::abs(mr) + t33;
    let M = p.M;
    let t35 = Real::abs(M);
    let t36 = t1 * t35 * t13;
    let t37 = 0.33333334_f32 * t30;
    let t38 = t37 * (t35 * t37);
    let t39 = 0.57735026_f32 * t30;
    let t40 = t38 + t39 * (t35 * t39);
    let t41 = t18 * t36;
    let t42 = 1.3333334_f32 * (0.4330127_f32 * t18 + t16);
    let t43 = t35 * t42;
    let t44 = t42 * t43;
    let t45 = 1.1547005_f32 * t32;
    let t46 = t43 * t45;
    let t47 = t45 * (t35 * t45);
    let t48 = t28 * t46;
    let t49 = t26 * t46;
    let t50 = t21 * t48 + t49;
    let Iz = p.Iz;
    let Ic2 = p.Ic2;
    let t51 = Iz + 3.0_f32 * Ic2;
    let t52 = Real::abs(Iz);
    let t53 = Real::abs(Ic2);
    let t54 = t44 + (t52 + 3.0_f32 * t53 + t41);
    let t55 = t29 * t25;
    let Ic3 = p.Ic3;
    let t56 = t53 + Real::abs(Ic3);
    let Ic1 = p.Ic1;
    let t57 = Real::abs(Ic1) + t56;
    let t58 = t55 * (t57 * t55);
    let t59 = t56 + t30 * (t57 * t30);
    let t60 = t56 + t58;
    let t61 = t25 * t20;
    let t62 = t61 * t22;
    let t63 = 1.0_f32 / (1.0_f32 + t30 * t30);
    let t64 = t63 * (0.5_f32 * t32);
    let t65 = 0.8660254_f32 * t32;
    let t66 = t25 * t63;
    let t67 = t65 * t63;
    let t68 = 1.0_f32 / t24;
    let t69 = t68 * (t25 + t62);
    let t70 = t68 * t62;
    let t71 = t25 * t68;
    let t72 = t25 * t60 * t65;
    let t73 = t65 * (t60 * t65);
    let t74 = t54 * t26;
    let t75 = t59 * t66;
    let t76 = t28 * (t74 + t75 * t64) + ((t72 + t75 * t67) * t26 + t67 * (t59 * t64));
    let t77 = t21 * (2.0_f32 * t76);
    let t78 = t73 + t67 * (t59 * t67);
    let t79 = 1.5_f32 * t53;
    let Ix = p.Ix;
    let t80 = Real::abs(Ix) + t79 + t78;
    let t81 = t34 + t40;
    let t82 = 2.0_f32 * t48;
    let t83 = t80 * t61;
    let t84 = t83 + t82;
    let t85 = t61 * t83 + t81;
    let t86 = t61 * t84 + t47;
    let t87 = Ic3 - Ic2;
    let t88 = 1.5_f32 * Ic2;
    let t89 = Ix + t88;
    let Iy = p.Iy;
    let t90 = Iy + t88;
    let t91 = t77 + (Real::abs(Iy) + t79 + t41);
    let t92 = t69 * (t91 * t69) + t85;
    let t93 = 2.0_f32 * t50;
    let t94 = t70 * (t91 * t70 + t93) + (t34 + t86);
    let t95 = t34 + t71 * (t91 * t71);
    let t96 = 1.0_f32 / (3.0_f32 * R);
    let t97 = 0.5_f32 / Real::max(0.1012588_f32 * Real::abs(t11), 1e-24_f32);
    let t98 = 5.773503_f32 / Real::max(0.5189255_f32 * Real::abs(t16), 1e-24_f32);
    let t99 = 1.6666666_f32 / Real::max(0.2853043_f32 * Real::abs(t24), 1e-24_f32);
    let g = p.g;
    let t100 = ms * g;
    let t101 = ms + mc;
    let t102 = mc * g;
    let t103 = mr + t101;
    let t104 = g * t101;
    let t105 = t87 - Ic1;
    let t106 = 0.21652833_f32 / Real::max(0.17872345_f32 * Real::abs(t92), 1e-24_f32);
    let t107 = 0.21680787_f32 / Real::max(0.07950672_f32 * Real::abs(t94), 1e-24_f32);
    let t108 = 0.21706869_f32 / Real::max(0.32241857_f32 * Real::abs(t95), 1e-24_f32);
    let t109 = R * g;
    let t110 = M * g;
    let t111 = R * M;
    let t112 = 0.5_f32 * t105;
    let t113 = t89 - t90;
    let t114 = t90 - t51;
    let t115 = t51 - t89;
    let c = p.c;
    Prepared { R, M, c, g, k4: t87, k5: t105, k6: t112, k7: t100, k8: t102, k9: t104, k10: t110, k11: t103, k12: t109, k13: t111, k14: t96, k15: t51, k16: t89, k17: t90, k18: t113, k19: t114, k20: t115, k21: t97, k22: t98, k23: t99, k24: t106, k25: t107, k26: t108 }
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
    let root = Real::sqrt(1.0_f32 + t9);
    let t11 = 1.0_f32 + root;
    let k21 = p.k21;
    let t12 = Real::abs(t11) * k21;
    let t13 = 0.8660254_f32 * (t5 * (2.0_f32 * t6));
    let t14 = t7 + t13;
    let t15 = t7 - t13;
    let t16 = 1.0_f32 / t11;
    let t17 = 1.0_f32 + t10 * t16;
    let t18 = 1.0_f32 + t14 * t16;
    let t19 = 1.0_f32 + t15 * t16;
    let R = p.R;
    let sB = R * t18;
    let sC = R * t19;
    let sA = R * t17;
    let k13 = p.k13;
    let t20 = k13 * t17;
    let t21 = sA + 0.5_f32 * sB;
    let t22 = 0.8660254_f32 * sB;
    let t23 = 1.0_f32 / t22;
    let t24 = t23 * t21;
    let t25 = sA + 0.5_f32 * sC;
    let t26 = 0.8660254_f32 * sC;
    let t27 = t24 * t26 + t25;
    let k23 = p.k23;
    let t28 = Real::abs(t27) * k23;
    let t29 = 0.8660254_f32 * t5;
    let t30 = 0.5_f32 * t6;
    let t31 = t29 + t30;
    let t32 = t30 - t29;
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let t33 = t5 * t16;
    let t34 = t6 * t16;
    let t35 = t6 * v_G_z_per_u_hA;
    let u_sB_per_u_hB = t31 * v_G_z_per_u_hA;
    let t36 = t32 * v_G_z_per_u_hA;
    let t37 = u_sB_per_u_hB - t36;
    let t38 = 0.28867513_f32 * t37;
    let t39 = 0.8660254_f32 * t35;
    let t40 = t39 - t38;
    let t41 = t38 + t39;
    let t42 = 0.4330127_f32 * sA + t22;
    let k22 = p.k22;
    let t43 = Real::abs(t22) * k22;
    let t44 = 1.0_f32 / t27;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t23;
    let t45 = w_platform_x_per_u_hB * t26;
    let w_platform_y_per_u_hB = t44 * t45;
    let t46 = t44 * (v_G_z_per_u_hA + t45);
    let u_hA = u[0];
    let t47 = u_hA * t46;
    let u_hB = u[1];
    let t48 = u_hB * w_platform_y_per_u_hB - t47;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t44;
    let u_hC = u[2];
    let w_platform_y = t48 + u_hC * w_platform_y_per_u_hC;
    let t49 = (u_hA - u_hB) * w_platform_x_per_u_hB + t24 * w_platform_y;
    let t50 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t51 = 1.0_f32 / (t50 - 1.0_f32);
    let t52 = t51 * (0.5_f32 * t40);
    let t53 = t51 * (0.8660254_f32 * t40);
    let t54 = t52 * w_platform_y - t53 * t49;
    let t55 = t33 * w_platform_y + t34 * t49;
    let t56 = u_hA * (0.5_f32 * t37);
    let u_sB_per_w_platform_z = 0.8660254_f32 * sA;
    let t57 = t56 + t55 * u_sB_per_w_platform_z;
    let t58 = v_G_z_per_u_hA * t51;
    let u_psiB = t54 + t58 * t55;
    let t59 = 1.0_f32 - t50;
    let t60 = Real::sqrt(t59);
    let t61 = 1.0_f32 / t60;
    let t62 = 0.5_f32 * v_G_z_per_u_hA;
    let t63 = t62 * t61;
    let t64 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t65 = t64 * t61;
    let t66 = w_platform_y * t63 - t49 * t65;
    let t67 = t40 * t61;
    let u_thB = t55 * t67 - t66;
    let t68 = u_sB_per_u_hB * u_psiB;
    let t69 = t68 * (u_psiB * t60);
    let t70 = t68 * u_thB;
    let t71 = 0.8660254_f32 * w_platform_y;
    let t72 = 0.5_f32 * t49;
    let t73 = t71 + t72;
    let t74 = t71 - t72;
    let t75 = 2.0_f32 * t70;
    let t76 = t60 * t75;
    let t77 = t73 * t55;
    let t78 = t76 - t40 * t77;
    let t79 = 0.8660254_f32 * t49;
    let t80 = 0.5_f32 * w_platform_y;
    let t81 = t79 - t80;
    let t82 = t80 + t79;
    let t83 = sB * t77;
    let t84 = t73 * t81;
    let t85 = sB * t84;
    let t86 = t51 * (t78 - v_G_z_per_u_hA * t84);
    let k6 = p.k6;
    let t87 = t60 * (2.0_f32 * (k6 * t75));
    let t88 = 1.0_f32 - t36 * t36;
    let t89 = 0.5_f32 * t41;
    let t90 = 1.0_f32 / t88;
    let u_psiC_per_w_platform_y = t90 * t89;
    let t91 = t90 * (0.8660254_f32 * t41);
    let t92 = u_psiC_per_w_platform_y * w_platform_y + t91 * t49;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t90;
    let u_psiC = t92 - u_psiC_per_w_platform_z * t55;
    let k5 = p.k5;
    let t93 = k5 * t69;
    let t94 = t63 * t93;
    let t95 = t67 * t93;
    let t96 = t65 * t93;
    let k4 = p.k4;
    let t97 = u_sB_per_u_hB * (k5 * u_sB_per_u_hB) - k4;
    let t98 = t97 * t86 - t87;
    let t99 = 1.0_f32 - t35 * t35;
    let t100 = Real::min(Real::min(t99, t59), t88);
    let t101 = Real::sqrt(t88);
    let t102 = 1.0_f32 / t101;
    let t103 = t102 * t62;
    let t104 = t36 * u_psiC;
    let t105 = k5 * (t104 * (u_psiC * t101));
    let t106 = t103 * t105 + t94;
    let t107 = 1.0_f32 / t99;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t107;
    let v_G_y_per_u_hA = 0.57735026_f32 * t37;
    let t108 = v_G_y_per_u_hA * t107;
    let t109 = u_psiA_per_w_platform_z * t55;
    let u_psiA = t108 * w_platform_y - t109;
    let t110 = Real::sqrt(t99);
    let t111 = t35 * u_psiA;
    let t112 = k5 * (t111 * (u_psiA * t110));
    let t113 = 1.0_f32 / t110;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t113;
    let t114 = u_thA_per_w_platform_y * t112 + t106;
    let t115 = t52 * t98 - t114;
    let t116 = v_G_y_per_u_hA * t113;
    let t117 = w_platform_y * u_thA_per_w_platform_y;
    let t118 = t116 * t112;
    let u_thA = t55 * t116 + t117;
    let t119 = 2.0_f32 * t111 * u_thA;
    let u_thC_per_w_platform_x = t102 * t64;
    let u_thC_per_w_platform_z = t41 * t102;
    let t120 = t55 * t74;
    let t121 = t41 * t120;
    let t122 = sC * t120;
    let t123 = w_platform_y * t103 + t55 * u_thC_per_w_platform_z;
    let t124 = u_thC_per_w_platform_z * t105;
    let t125 = t96 - u_thC_per_w_platform_x * t105;
    let t126 = 2.0_f32 * (t104 * (t49 * u_thC_per_w_platform_x + t123));
    let t127 = t121 + t101 * t126;
    let u_psiC_dot_bias = t90 * (v_G_z_per_u_hA * (t74 * t82) + t127);
    let t128 = t101 * (k6 * t126);
    let t129 = t110 * (k6 * t119);
    let t130 = t110 * t119;
    let t131 = 2.0_f32 * t128;
    let t132 = t36 * (k5 * t36) - k4;
    let t133 = t132 * u_psiC_dot_bias + t131;
    let t134 = t35 * (k5 * t35) - k4;
    let t135 = u_psiC_per_w_platform_y * t133 + t115;
    let t136 = t49 * t55;
    let t137 = v_G_y_per_u_hA * t136 - t130;
    let t138 = w_platform_y * t49;
    let t139 = t107 * (v_G_z_per_u_hA * t138 + t137);
    let t140 = 2.0_f32 * t129;
    let t141 = t140 - t134 * t139;
    let t142 = t108 * t141 + t135;
    let k20 = p.k20;
    let t143 = k20 * t136 + t142;
    let v_G_x_per_w_platform_z = 1.3333334_f32 * t42;
    let t144 = 0.33333334_f32 * t37;
    let t145 = u_hA * t144 + v_G_x_per_w_platform_z * t55;
    let t146 = 1.1547005_f32 * t40;
    let t147 = u_hB * t146 + t145;
    let t148 = u_hB * u_sB_per_u_hB;
    let u_sA = t147 - u_hA * t35;
    let t149 = 0.5_f32 * t147;
    let t150 = t149 + t57 - t148;
    let t151 = u_hC * t36 - t149;
    let t152 = t83 - 2.0_f32 * (t81 * t150);
    let t153 = t85 + 2.0_f32 * (t55 * t150);
    let t154 = sA * t136;
    let t155 = 2.0_f32 * (w_platform_y * u_sA) - t154;
    let t156 = t23 * (t155 - t152);
    let k19 = p.k19;
    let t157 = k19 * (w_platform_y * t55);
    let t158 = t55 * u_sA;
    let v_G_y = sA * t55 + u_hA * v_G_y_per_u_hA;
    let u_sC = t151 + 0.8660254_f32 * v_G_y;
    let t159 = t122 + 2.0_f32 * (t82 * u_sC);
    let t160 = t26 * t156;
    let t161 = t44 * (t160 + (t155 + t159));
    let t162 = t132 * u_psiC_per_w_platform_z;
    let t163 = u_psiC_per_w_platform_z * t162;
    let t164 = t97 * t58;
    let t165 = t163 + t58 * t164;
    let t166 = t58 * t98;
    let t167 = t125 - t53 * t98;
    let t168 = u_psiC_per_w_platform_z * t133;
    let t169 = t157 + (t91 * t133 + t167);
    let t170 = u_psiA_per_w_platform_z * t141;
    let t171 = t134 * u_psiA_per_w_platform_z;
    let k15 = p.k15;
    let t172 = k15 - (u_psiA_per_w_platform_z * t171 + t165);
    let t173 = t171 * t108;
    let t174 = t108 * (t134 * t108);
    let t175 = t164 * t52 - t162 * u_psiC_per_w_platform_y - t173;
    let t176 = t164 * t53;
    let t177 = t162 * t91 + t176;
    let t178 = t97 * t52;
    let t179 = t53 * (t97 * t53);
    let t180 = t53 * t178;
    let t181 = t52 * t178;
    let t182 = t91 * (t132 * t91) + t179;
    let t183 = t132 * u_psiC_per_w_platform_y;
    let t184 = t180 - t91 * t183;
    let t185 = t177 * t33 + t184;
    let t186 = t174 + (u_psiC_per_w_platform_y * t183 + t181);
    let k18 = p.k18;
    let t187 = t168 - (t166 - (t170 + (t124 - (t95 + (k18 * t138 - t118)))));
    let t188 = 2.0_f32 * t158;
    let t189 = sA * t138 + t188;
    let t190 = 0.8660254_f32 * t153;
    let t191 = 0.4330127_f32 * t189 - t190;
    let t192 = sA * t20;
    let t193 = t192 + t172;
    let M = p.M;
    let t194 = M * v_G_x_per_w_platform_z;
    let t195 = v_G_x_per_w_platform_z * t194 + t193;
    let k16 = p.k16;
    let t196 = t182 - t34 * (2.0_f32 * t177 + t34 * t195) - k16;
    let t197 = t195 * t33;
    let t198 = t34 * (t197 - t175) + t185;
    let k17 = p.k17;
    let t199 = t192 + (k17 - (t33 * (2.0_f32 * t175 - t197) + t186));
    let t200 = t143 - t198 * t156;
    let k10 = p.k10;
    let t201 = M * (1.3333334_f32 * t191) + k10 * t35;
    let t202 = M * t189 + k10 * v_G_y_per_u_hA;
    let t203 = M * t155 + k10 * v_G_z_per_u_hA;
    let t204 = sA * t202 + t187;
    let t205 = v_G_x_per_w_platform_z * t201 + t204;
    let t206 = t200 - t33 * t205;
    let t207 = t196 * t156 + t169 - t34 * t205;
    let t208 = 2.0_f32 * t198;
    let t209 = t24 * t196;
    let t210 = t208 - t209;
    let t211 = t198 - t209;
    let t212 = t24 * t210 + t199;
    let t213 = t24 * t207;
    let t214 = t206 + (t212 * t161 + t213) - sA * t203;
    let t215 = v_G_y_per_u_hA * t20;
    let t216 = t194 * t144 + t215;
    let t217 = t194 * t146;
    let t218 = t34 * t217;
    let t219 = t33 * t217;
    let t220 = t216 * t34;
    let t221 = t216 * t33;
    let t222 = t24 * t218 + t219;
    let t223 = t220 * t24 + t221;
    let t224 = t211 * w_platform_x_per_u_hB;
    let t225 = t222 - t224;
    let t226 = t224 + t223;
    let t227 = v_G_z_per_u_hA * t20 + t226;
    let t228 = w_platform_x_per_u_hB * t207;
    let t229 = t228 + t146 * t201;
    let t230 = t227 * t161 + t228;
    let FB = inputs[1];
    let t231 = FB - t218 * t156;
    let t232 = t225 * t161 + t231 - t229;
    let FA = inputs[0];
    let t233 = FA - t220 * t156 - t144 * t201 - v_G_y_per_u_hA * t202 + t230;
    let k9 = p.k9;
    let FC = inputs[2];
    let t234 = k9 - FC;
    let t235 = t232 - k9;
    let t236 = t233 - k9;
    let t237 = t212 * t46 - 2.0_f32 * t227;
    let t238 = t196 * w_platform_x_per_u_hB;
    let t239 = t238 - 2.0_f32 * t220;
    let t240 = t220 - t218 - t238;
    let t241 = t238 + 2.0_f32 * t218;
    let t242 = w_platform_x_per_u_hB * t239;
    let t243 = w_platform_x_per_u_hB * t240;
    let t244 = w_platform_x_per_u_hB * t241;
    let t245 = v_G_y_per_u_hA * (M * v_G_y_per_u_hA);
    let k11 = p.k11;
    let t246 = t242 - (k11 + (t144 * (M * t144) + t245));
    let t247 = v_G_z_per_u_hA * t203;
    let t248 = t246 - v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t46 * t237 - t248;
    let t249 = M * t146;
    let t250 = t144 * t249;
    let t251 = t244 - t146 * t249;
    let k24 = p.k24;
    let t252 = Real::abs(mass_u_hA_u_hA) * k24;
    let t253 = t212 * w_platform_y_per_u_hB;
    let t254 = t46 * (t253 + t225) - t250;
    let mass_u_hA_u_hB = t227 * w_platform_y_per_u_hB - t254 - t243;
    let t255 = t212 * w_platform_y_per_u_hC;
    let mass_u_hA_u_hC = t227 * w_platform_y_per_u_hC - t46 * t255;
    let t256 = t253 + 2.0_f32 * t225;
    let t257 = t251 - k11;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * t256 - t257;
    let t258 = 1.0_f32 / mass_u_hA_u_hA;
    let t259 = t258 * mass_u_hA_u_hB;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t259;
    let mass_u_hB_u_hC = t225 * w_platform_y_per_u_hC + w_platform_y_per_u_hB * t255;
    let t260 = w_platform_y_per_u_hB * t214;
    let t261 = t46 * t214;
    let t262 = w_platform_y_per_u_hC * t214;
    let mass_u_hC_u_hC = k11 + w_platform_y_per_u_hC * t255;
    let k25 = p.k25;
    let t263 = Real::abs(pivot_1) * k25;
    let t264 = mass_u_hB_u_hC - t259 * mass_u_hA_u_hC;
    let t265 = t258 * mass_u_hA_u_hC;
    let t266 = mass_u_hC_u_hC - mass_u_hA_u_hC * t265;
    let t267 = 1.0_f32 / pivot_1;
    let t268 = t267 * t264;
    let pivot_2 = t266 - t264 * t268;
    let k26 = p.k26;
    let t269 = Real::min(Real::min(Real::min(Real::min(Real::min(Real::min(Real::abs(pivot_2) * k26, t263), t252), t28), t43), t12), t100);
    let c = p.c;
    let forcing_u_hB = t260 + (t235 - u_hB * c);
    let forcing_u_hA = t236 - u_hA * c - t247 - t261;
    let forcing_u_hC = t262 - (u_hC * c + t234);
    let t270 = forcing_u_hB - t259 * forcing_u_hA;
    let t271 = t258 * forcing_u_hA;
    let t272 = t267 * t270;
    let t273 = (forcing_u_hC - (t268 * t270 + t265 * forcing_u_hA)) / pivot_2;
    let t274 = t272 - t268 * t273;
    let t275 = t259 * t274;
    let t276 = t271 - (t265 * t273 + t275);
    ([u_hA, u_hB, u_hC], [t276, t274, t273], t269)
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
