// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 587 operations (6 abs, 108 add, 3 cos, 12 div, 8 min, 352 mul, 4 sin, 94 sub).
// Cost of energy: 165 operations (32 add, 3 cos, 6 div, 103 mul, 4 sin, 17 sub).
// Cost of speeds: 142 operations (22 add, 3 cos, 9 div, 87 mul, 4 sin, 17 sub).
// Cost of outputs: 11 operations (1 add, 2 cos, 5 mul, 2 sin, 1 sub).
// Cost of projection: 420 operations (9 abs, 80 add, 7 cos, 10 div, 8 max, 223 mul, 7 sin, 1 sqrt, 75 sub).
// Cost of prepare: 159 operations (17 abs, 45 add, 9 div, 7 max, 77 mul, 4 sub).

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
/// Lowest and highest value of every tunable parameter, SI units.
pub const PARAMETER_RANGES: [[S; 2]; 13usize] = [
    [S::NEG_INFINITY, S::INFINITY],
    [0.0_f64, S::INFINITY],
    [0.0_f64, S::INFINITY],
    [0.0_f64, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [0.0_f64, S::INFINITY],
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
    let t1 = Real::abs(R);
    let Ic2 = p.Ic2;
    let t2 = Real::abs(Ic2);
    let Ic3 = p.Ic3;
    let t3 = Real::abs(Ic3);
    let Ic1 = p.Ic1;
    let t4 = Real::abs(Ic1);
    let M = p.M;
    let t5 = Real::abs(M);
    let t6 = Real::max(5.0_f64 * t1, 1e-24_f64);
    let Iz = p.Iz;
    let t7 = Real::abs(Iz);
    let t8 = 0.17320508075688773_f64 * t6;
    let Ix = p.Ix;
    let t9 = Real::abs(Ix);
    let t10 = t2 + t3;
    let t11 = 1.0_f64 / t8;
    let t12 = t4 + t10;
    let t13 = 0.2309401076758503_f64 * t6;
    let t14 = 0.5773502691896257_f64 * t5;
    let t15 = 1.0392304845413265_f64 * t6;
    let t16 = t10 + t12;
    let t17 = 0.2_f64 * t6;
    let t18 = 1.3333333333333333_f64 * t5;
    let t19 = t13 * t14;
    let t20 = 3.0_f64 * t2;
    let Iy = p.Iy;
    let t21 = Real::abs(Iy);
    let t22 = 0.30000000000000004_f64 * t6;
    let t23 = 1.0_f64 / t15;
    let t24 = 1.5_f64 * t2;
    let t25 = t17 * t18;
    let t26 = 2.0_f64 * t19;
    let t27 = 2.6666666666666665_f64 * t16;
    let t28 = t7 + t20;
    let t29 = t5 * t13;
    let t30 = t22 * t11;
    let t31 = 3.124999999999999_f64 * t16;
    let t32 = t9 + t24;
    let t33 = t25 + t26;
    let t34 = t28 + t27;
    let t35 = t13 * t29;
    let t36 = t8 * t30;
    let t37 = t32 + t31;
    let t38 = t17 * t33;
    let t39 = t35 + t34;
    let ms = p.ms;
    let t40 = Real::abs(ms);
    let mc = p.mc;
    let t41 = Real::abs(mc);
    let t42 = t22 + t36;
    let t43 = 0.90210979560879_f64 * t16;
    let t44 = t30 * t37;
    let t45 = 2.886751345948128_f64 * t16;
    let t46 = 2.0_f64 * t23;
    let t47 = t38 + t39;
    let t48 = t19 + t25;
    let t49 = 1.3471506281091266_f64 * t5;
    let mr = p.mr;
    let t50 = Real::abs(mr);
    let t51 = 1.0_f64 / t42;
    let t52 = t43 + t44;
    let t53 = 1.1547005383792515_f64 * t11;
    let t54 = t46 * t45;
    let t55 = t17 * t5;
    let t56 = 1.80421959121758_f64 * t16;
    let t57 = 1.0416666666666665_f64 * t16;
    let t58 = t21 + t24;
    let t59 = t46 * t47;
    let t60 = 2.309401076758503_f64 * t48;
    let t61 = t17 * t49;
    let t62 = 2.333333333333333_f64 * t29;
    let t63 = t53 * t52;
    let t64 = t30 * t54;
    let t65 = t56 + t44;
    let t66 = t58 + t57;
    let t67 = t17 * t55;
    let t68 = t8 * t53;
    let t69 = 2.0_f64 * t54;
    let t70 = t53 * t37;
    let t71 = t60 + t59;
    let t72 = 3.5_f64 * t23;
    let t73 = 2.1666666666666665_f64 * t16;
    let t74 = t61 + t62;
    let t75 = t64 + t63;
    let t76 = 1.1547005383792515_f64 * t55;
    let t77 = t30 * t65;
    let t78 = t67 + t66;
    let t79 = 1.1547005383792515_f64 + t68;
    let t80 = t69 + t70;
    let t81 = t46 * t71;
    let t82 = 1.7777777777777775_f64 * t5;
    let t83 = t72 * t47;
    let t84 = t72 * t73;
    let t85 = 2.0_f64 * t74;
    let t86 = t76 + t75;
    let t87 = t77 + t78;
    let t88 = t51 * t79;
    let t89 = t53 * t80;
    let t90 = t82 + t81;
    let t91 = t40 + t41;
    let t92 = t51 * t68;
    let t93 = t63 + t84;
    let t94 = t85 + t83;
    let t95 = 2.0_f64 * t86;
    let t96 = t88 * t87;
    let t97 = t89 + t90;
    let t98 = t50 + t91;
    let t99 = t92 * t87;
    let t100 = 2.0_f64 * t93;
    let t101 = t72 * t94;
    let t102 = 5.444444444444443_f64 * t5;
    let t103 = t95 + t96;
    let t104 = t98 + t97;
    let t105 = t99 + t100;
    let t106 = t102 + t101;
    let t107 = t88 * t103;
    let t108 = t18 + t104;
    let t109 = t72 * t83;
    let t110 = t92 * t105;
    let t111 = t98 + t106;
    let t112 = t107 + t108;
    let t113 = t98 + t109;
    let t114 = t110 + t111;
    let t115 = Real::abs(t15);
    let t116 = Real::abs(t8);
    let t117 = Real::abs(t42);
    let t118 = Real::abs(t112);
    let t119 = Real::abs(t113);
    let t120 = Real::abs(t114);
    let t121 = 0.9622504486493761_f64 * t115;
    let t122 = 5.773502691896257_f64 * t116;
    let t123 = 1.6666666666666665_f64 * t117;
    let t124 = 0.01457105774186382_f64 * t118;
    let t125 = 0.06332438355227317_f64 * t119;
    let t126 = 0.011425392670734027_f64 * t120;
    let t127 = Real::max(t121, 1e-24_f64);
    let t128 = Real::max(t122, 1e-24_f64);
    let t129 = Real::max(t123, 1e-24_f64);
    let t130 = Real::max(t124, 1e-24_f64);
    let t131 = Real::max(t125, 1e-24_f64);
    let t132 = Real::max(t126, 1e-24_f64);
    let t133 = 0.9622504486493761_f64 / t127;
    let t134 = 5.773502691896257_f64 / t128;
    let t135 = 1.6666666666666665_f64 / t129;
    let t136 = 0.2165283291230603_f64 / t130;
    let t137 = 0.216807871823593_f64 / t131;
    let t138 = 0.21706868422196893_f64 / t132;
    let t139 = Ic2 - Ic3;
    let t140 = 1.5_f64 * Ic2;
    let t141 = 3.0_f64 * Ic2;
    let t142 = ms + mc;
    let t143 = Ic1 + t139;
    let t144 = Ix + t140;
    let t145 = Iy + t140;
    let t146 = Iz + t141;
    let t147 = 0.5_f64 * R;
    let g = p.g;
    let t148 = ms * g;
    let t149 = mc * g;
    let t150 = g * t142;
    let t151 = M * g;
    let t152 = mr + t142;
    let t153 = 0.5773502691896257_f64 * M;
    let t154 = 1.3333333333333333_f64 * M;
    let t155 = 0.5_f64 * t143;
    let t156 = t146 - t145;
    let t157 = t144 - t146;
    let t158 = t145 - t144;
    let c = p.c;
    Prepared { R, M, c, g, k4: t147, k5: t139, k6: t148, k7: t149, k8: t150, k9: t151, k10: t152, k11: t153, k12: t154, k13: t143, k14: t144, k15: t145, k16: t146, k17: t155, k18: t156, k19: t157, k20: t158, k21: t133, k22: t134, k23: t135, k24: t136, k25: t137, k26: t138 }
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
    let t1 = 2.0943951023931953_f64 - (psiA - psiB);
    let thA = q[2];
    let thB = q[6];
    let [(sin_thA, cos_thA), (sin_thB, cos_thB)] = Real::sin_cos_of_two(thA, thB);
    let thC = q[10];
    let [(sin_thC, cos_thC), (sin_t1, _)] = Real::sin_cos_of_two(thC, t1);
    let sC = q[11];
    let t2 = 0.8660254037844386_f64 * sC;
    let t3 = 1.0_f64 / t2;
    let sA = q[3];
    let t4 = sA + 0.5_f64 * sC;
    let sB = q[7];
    let t5 = sB + sC;
    let t6 = 0.5_f64 * sB;
    let w_platform_x_per_w_platform_y = t4 * t3;
    let t7 = 0.8660254037844386_f64 * sB;
    let t8 = sA + t5;
    let t9 = cos_thA * sin_t1;
    let t10 = sA + t6;
    let t11 = t7 * w_platform_x_per_w_platform_y;
    let t12 = 1.7320508075688772_f64 * t8;
    let t13 = 1.1547005383792515_f64 * t9;
    let t14 = sin_thB - sin_thC;
    let t15 = t10 + t11;
    let t16 = 1.0_f64 / t12;
    let v_G_z_per_u_hA = cos_thB * t13;
    let t17 = 0.5_f64 * t14;
    let t18 = 0.5_f64 * sin_thA;
    let t19 = 1.0_f64 / t15;
    let w_platform_x_per_u_hA = t3 * v_G_z_per_u_hA;
    let t20 = t18 - t17;
    let u_sB_per_u_hB = 2.0_f64 * sin_thA;
    let t21 = t7 * w_platform_x_per_u_hA;
    let t22 = t20 - u_sB_per_u_hB;
    let t23 = t18 + t17;
    let t24 = v_G_z_per_u_hA + t21;
    let t25 = t16 * t22;
    let t26 = t16 * t14;
    let t27 = u_sB_per_u_hB - t23;
    let w_platform_y_per_u_hB = t19 * v_G_z_per_u_hA;
    let t28 = t19 * t24;
    let u_hB = u[1];
    let t29 = u_hB * t25;
    let u_hA = u[0];
    let t30 = u_hA * t26;
    let t31 = t16 * t27;
    let t32 = cos_thB * cos_thB;
    let t33 = u_hB * w_platform_y_per_u_hB;
    let t34 = u_hA * t28;
    let w_platform_y_per_u_hC = t19 * t21;
    let t35 = t29 + t30;
    let u_hC = u[2];
    let t36 = u_hC * t31;
    let t37 = cos_thA * cos_thA;
    let t38 = 1.0_f64 / t32;
    let t39 = cos_thC * cos_thC;
    let t40 = t33 - t34;
    let t41 = u_hC * w_platform_y_per_u_hC;
    let t42 = 0.5773502691896257_f64 * t14;
    let t43 = t35 + t36;
    let t44 = 0.28867513459481287_f64 * t14;
    let t45 = 0.8660254037844386_f64 * sin_thA;
    let t46 = 1.0_f64 / t37;
    let t47 = 1.0_f64 / cos_thA;
    let t48 = 1.0_f64 / t39;
    let w_platform_y = t40 + t41;
    let t49 = sA * t43;
    let t50 = u_hA * t42;
    let t51 = 1.1547005383792515_f64 * sC;
    let t52 = 0.6666666666666666_f64 * t27;
    let t53 = t45 + t44;
    let t54 = u_hA - u_hC;
    let t55 = 1.0_f64 / cos_thB;
    let v_G_y = t49 - t50;
    let t56 = t51 * t43;
    let t57 = u_hC * t52;
    let t58 = w_platform_x_per_w_platform_y * w_platform_y;
    let t59 = w_platform_x_per_u_hA * t54;
    let t60 = 0.8660254037844386_f64 * t53;
    let t61 = t45 - t44;
    let t62 = 1.0_f64 / cos_thC;
    let t63 = 0.5773502691896257_f64 * v_G_y;
    let t64 = t57 - t56;
    let t65 = 0.5_f64 * t53;
    let w_platform_x = t59 + t58;
    let t66 = t38 * t60;
    let u_psiB_per_w_platform_z = t38 * v_G_z_per_u_hA;
    let t67 = 0.5_f64 * t61;
    let u_sC_per_w_platform_z = 1.7320508075688772_f64 * sC;
    let t68 = t46 * t42;
    let u_psiA_per_w_platform_z = t46 * v_G_z_per_u_hA;
    let u_thA_per_w_platform_y = t47 * v_G_z_per_u_hA;
    let t69 = t47 * t42;
    let v_G_x = t63 - t64;
    let t70 = t38 * t65;
    let t71 = w_platform_x * t66;
    let t72 = t43 * u_psiB_per_w_platform_z;
    let t73 = 0.5_f64 * v_G_z_per_u_hA;
    let t74 = 0.8660254037844386_f64 * t61;
    let u_psiC_per_w_platform_y = t48 * t67;
    let u_psiC_per_w_platform_z = t48 * v_G_z_per_u_hA;
    let t75 = u_sC_per_w_platform_z * t43;
    let t76 = u_hC * u_sB_per_u_hB;
    let t77 = w_platform_y * t68;
    let t78 = t43 * u_psiA_per_w_platform_z;
    let t79 = w_platform_y * u_thA_per_w_platform_y;
    let t80 = t43 * t69;
    let t81 = w_platform_y * t70;
    let t82 = t71 + t72;
    let t83 = t55 * t73;
    let t84 = 2.0_f64 * v_G_x;
    let t85 = 1.7320508075688772_f64 * sB;
    let t86 = t48 * t74;
    let t87 = w_platform_y * u_psiC_per_w_platform_y;
    let t88 = t43 * u_psiC_per_w_platform_z;
    let t89 = t76 - t75;
    let t90 = 0.8660254037844386_f64 * w_platform_y;
    let t91 = 0.5_f64 * w_platform_x;
    let t92 = 0.8660254037844386_f64 * w_platform_x;
    let t93 = 0.5_f64 * w_platform_y;
    let t94 = t78 + t77;
    let u_thA = t79 - t80;
    let t95 = t81 + t82;
    let t96 = w_platform_y * t83;
    let t97 = t9 * w_platform_x;
    let t98 = t55 * t53;
    let t99 = t85 * t43;
    let t100 = u_hB * u_sB_per_u_hB;
    let t101 = w_platform_x * t86;
    let t102 = t88 - t87;
    let t103 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t104 = t62 * t73;
    let u_thC_per_w_platform_z = t62 * t61;
    let u_sC = t84 + t89;
    let t105 = t90 + t91;
    let t106 = t92 - t93;
    let t107 = t96 + t97;
    let t108 = t43 * t98;
    let t109 = t100 + t99;
    let t110 = t101 + t102;
    let u_thC_per_w_platform_x = t62 * t103;
    let t111 = w_platform_y * t104;
    let t112 = t43 * u_thC_per_w_platform_z;
    let t113 = t105 * t106;
    let t114 = t43 * u_sC;
    let t115 = t106 * t106;
    let t116 = t43 * t43;
    let t117 = sin_thB * t95;
    let t118 = t94 * u_thA;
    let t119 = u_hA * sin_thA;
    let u_thB = t108 - t107;
    let u_sB = t109 + t84;
    let t120 = w_platform_x * u_thC_per_w_platform_x;
    let t121 = t111 + t112;
    let t122 = sC * t113;
    let t123 = 2.0_f64 * t114;
    let t124 = t115 + t116;
    let t125 = t90 - t91;
    let t126 = t93 + t92;
    let k13 = p.k13;
    let t127 = sin_thC * k13;
    let t128 = sin_thB * k13;
    let t129 = sin_thC * t110;
    let t130 = 2.0_f64 * t117;
    let t131 = t43 * w_platform_x;
    let t132 = u_sB_per_u_hB * t118;
    let t133 = t119 + v_G_x;
    let t134 = t122 + t123;
    let t135 = sC * t124;
    let t136 = w_platform_y * w_platform_x;
    let t137 = t125 * t126;
    let t138 = t43 * u_sB;
    let t139 = t126 * t126;
    let t140 = sin_thC * t127;
    let t141 = sin_thB * t128;
    let t142 = cos_thB * t95;
    let t143 = u_thB * t130;
    let t144 = t43 * t125;
    let t145 = t121 - t120;
    let t146 = 2.0_f64 * t129;
    let t147 = sin_thA * k13;
    let t148 = cos_thA * t132;
    let t149 = t42 * t131;
    let t150 = 0.8660254037844386_f64 * t134;
    let t151 = 0.5_f64 * t135;
    let t152 = t43 * t133;
    let t153 = sB * t137;
    let t154 = 2.0_f64 * t138;
    let t155 = t116 + t139;
    let k5 = p.k5;
    let t156 = t140 - k5;
    let t157 = t141 - k5;
    let t158 = t117 * t142;
    let t159 = cos_thB * t143;
    let t160 = t53 * t144;
    let t161 = t145 * t146;
    let t162 = t43 * t105;
    let t163 = sin_thA * t94;
    let t164 = cos_thA * t94;
    let t165 = sin_thA * t147;
    let t166 = t149 + t148;
    let t167 = v_G_z_per_u_hA * t136;
    let t168 = t151 - t150;
    let t169 = sA * t136;
    let t170 = 2.0_f64 * t152;
    let t171 = t153 + t154;
    let t172 = sB * t155;
    let t173 = u_psiC_per_w_platform_z * t156;
    let t174 = u_psiB_per_w_platform_z * t157;
    let t175 = k13 * t158;
    let t176 = cos_thC * t110;
    let t177 = t160 - t159;
    let t178 = v_G_z_per_u_hA * t137;
    let t179 = cos_thC * t161;
    let t180 = t61 * t162;
    let t181 = t163 * t164;
    let t182 = k5 - t165;
    let t183 = t166 - t167;
    let u_sC_dot_bias = 2.0_f64 * t168;
    let t184 = t169 + t170;
    let t185 = 0.8660254037844386_f64 * t171;
    let t186 = 0.5_f64 * t172;
    let t187 = t129 * t176;
    let t188 = t177 - t178;
    let k17 = p.k17;
    let t189 = k17 * t143;
    let t190 = t180 + t179;
    let t191 = v_G_z_per_u_hA * t113;
    let t192 = k13 * t181;
    let t193 = u_psiA_per_w_platform_z * t182;
    let t194 = t46 * t183;
    let t195 = k17 * t132;
    let t196 = 2.0_f64 * cos_thA;
    let t197 = t98 * t175;
    let k20 = p.k20;
    let t198 = t136 * k20;
    let t199 = u_psiC_per_w_platform_z * t173;
    let t200 = u_psiB_per_w_platform_z * t174;
    let t201 = t135 - u_sC_dot_bias;
    let t202 = 1.7320508075688772_f64 * t184;
    let t203 = t185 + t186;
    let t204 = k13 * t187;
    let t205 = t38 * t188;
    let t206 = 2.0_f64 * t189;
    let t207 = t190 - t191;
    let t208 = k17 * t161;
    let t209 = t182 * t194;
    let t210 = t196 * t195;
    let t211 = t198 + t197;
    let t212 = t69 * t192;
    let t213 = t199 + t200;
    let t214 = u_psiA_per_w_platform_z * t193;
    let k11 = p.k11;
    let t215 = t51 * k11;
    let t216 = t202 - t201;
    let t217 = 2.0_f64 * t203;
    let t218 = t157 * t205;
    let t219 = cos_thB * t206;
    let u_psiC_dot_bias = t48 * t207;
    let t220 = 2.0_f64 * t208;
    let t221 = t210 - t209;
    let t222 = t211 - t212;
    let t223 = u_thC_per_w_platform_z * t204;
    let t224 = t213 - t214;
    let M = p.M;
    let t225 = M * t51;
    let k12 = p.k12;
    let t226 = sA * k12;
    let t227 = 2.0_f64 * t215;
    let v_G_x_dot_bias = 0.6666666666666666_f64 * t201;
    let t228 = t86 * t156;
    let t229 = t66 * t157;
    let t230 = t216 - t217;
    let t231 = t219 - t218;
    let t232 = t156 * u_psiC_dot_bias;
    let t233 = cos_thC * t220;
    let t234 = t222 - t223;
    let t235 = u_psiA_per_w_platform_z * t221;
    let k16 = p.k16;
    let t236 = k16 + t224;
    let t237 = t51 * t225;
    let t238 = t226 + t227;
    let t239 = M * v_G_x_dot_bias;
    let k9 = p.k9;
    let t240 = sin_thA * k9;
    let t241 = t86 * t228;
    let t242 = t66 * t229;
    let t243 = t172 + t230;
    let t244 = t232 + t233;
    let t245 = u_sC * t106;
    let t246 = w_platform_y * t133;
    let t247 = t234 - t235;
    let t248 = u_psiB_per_w_platform_z * t231;
    let t249 = t237 + t236;
    let t250 = sA * t238;
    let t251 = t240 - t239;
    let t252 = t86 * t173;
    let t253 = t66 * t174;
    let t254 = t241 + t242;
    let t255 = u_psiC_per_w_platform_y * t173;
    let t256 = t70 * t174;
    let t257 = t70 * t157;
    let t258 = u_psiC_per_w_platform_y * t156;
    let t259 = t16 * t243;
    let t260 = 2.0_f64 * t245;
    let t261 = sC * t162;
    let t262 = 2.0_f64 * t246;
    let t263 = sA * t131;
    let t264 = t247 - t248;
    let t265 = u_psiC_per_w_platform_z * t244;
    let t266 = t250 + t249;
    let t267 = 0.5773502691896257_f64 * t251;
    let t268 = k12 * t184;
    let t269 = t252 + t253;
    let k14 = p.k14;
    let t270 = k14 + t254;
    let t271 = t255 - t256;
    let t272 = t68 * t193;
    let t273 = t66 * t257;
    let t274 = t86 * t258;
    let t275 = u_psiC_per_w_platform_y * t258;
    let t276 = t70 * t257;
    let t277 = t68 * t182;
    let t278 = t215 + t226;
    let t279 = t9 * t175;
    let t280 = u_thC_per_w_platform_x * t204;
    let t281 = t260 - t261;
    let t282 = t263 - t262;
    let t283 = t104 * t204;
    let t284 = t83 * t175;
    let t285 = t265 + t264;
    let t286 = t266 * t259;
    let t287 = t268 + t267;
    let t288 = k9 * t42;
    let t289 = t272 + t271;
    let t290 = t273 - t274;
    let t291 = w_platform_x_per_w_platform_y * t270;
    let t292 = t275 + t276;
    let t293 = t68 * t277;
    let t294 = t278 * t42;
    let t295 = t26 * t269;
    let t296 = t269 * t259;
    let t297 = t279 - t280;
    let t298 = t282 - t281;
    let t299 = t283 + t284;
    let t300 = u_thA_per_w_platform_y * t192;
    let t301 = t285 - t286;
    let t302 = t215 * t184;
    let t303 = t288 + t287;
    let t304 = 2.0_f64 * t290;
    let t305 = t292 - t293;
    let t306 = sA * M;
    let t307 = t290 + t291;
    let t308 = w_platform_x_per_w_platform_y * t295;
    let t309 = t26 * t289;
    let t310 = t26 * t266;
    let t311 = 2.0_f64 * t294;
    let t312 = t296 + t297;
    let t313 = t66 * t231;
    let t314 = t3 * t298;
    let t315 = t299 - t300;
    let t316 = t289 * t259;
    let t317 = u_sB * t126;
    let t318 = t302 + t301;
    let t319 = sA * t303;
    let t320 = t304 + t291;
    let k15 = p.k15;
    let t321 = k15 + t305;
    let t322 = sA * t306;
    let t323 = w_platform_x_per_u_hA * t307;
    let t324 = t308 - t309;
    let t325 = 2.0_f64 * t295;
    let t326 = w_platform_x_per_u_hA * t270;
    let t327 = t310 - t311;
    let t328 = k12 * t42;
    let t329 = t313 + t312;
    let t330 = t86 * t244;
    let t331 = t43 * w_platform_y;
    let t332 = t315 - t316;
    let t333 = t290 * t314;
    let t334 = 2.0_f64 * t317;
    let t335 = sB * t144;
    let t336 = t319 + t318;
    let t337 = t51 * t251;
    let t338 = t294 * t259;
    let t339 = t295 * t314;
    let t340 = w_platform_x_per_w_platform_y * t320;
    let t341 = t322 + t321;
    let t342 = t323 + t324;
    let t343 = t306 * v_G_z_per_u_hA;
    let t344 = t325 + t326;
    let t345 = t26 * t327;
    let t346 = t42 * t328;
    let t347 = t329 - t330;
    let k18 = p.k18;
    let t348 = t331 * k18;
    let t349 = t333 + t332;
    let t350 = t70 * t231;
    let t351 = t334 - t335;
    let t352 = t337 + t336;
    let t353 = t339 - t338;
    let t354 = t340 + t341;
    let t355 = t343 + t342;
    let t356 = w_platform_x_per_u_hA * t344;
    let t357 = t346 + t345;
    let t358 = t347 - t348;
    let t359 = t314 * t270;
    let t360 = t350 + t349;
    let t361 = u_psiC_per_w_platform_y * t244;
    let t362 = t7 * t314;
    let t363 = t282 + t351;
    let t364 = t26 * t352;
    let FA = inputs[0];
    let t365 = t353 - FA;
    let t366 = 2.0_f64 * t355;
    let t367 = t28 * t354;
    let t368 = t356 + t357;
    let t369 = M * v_G_z_per_u_hA;
    let t370 = t25 * t269;
    let t371 = t359 + t358;
    let t372 = t361 + t360;
    let t373 = t68 * t221;
    let t374 = t362 + t363;
    let t375 = t365 - t364;
    let t376 = t42 * t303;
    let t377 = t367 - t366;
    let k10 = p.k10;
    let t378 = k10 + t368;
    let t379 = v_G_z_per_u_hA * t369;
    let t380 = t25 * t289;
    let t381 = w_platform_x_per_w_platform_y * t370;
    let t382 = t25 * t266;
    let t383 = t373 + t372;
    let k19 = p.k19;
    let t384 = t131 * k19;
    let t385 = t19 * t374;
    let t386 = w_platform_x_per_u_hA * t371;
    let t387 = t376 + t375;
    let t388 = t28 * t377;
    let t389 = t379 + t378;
    let t390 = t380 - t381;
    let t391 = w_platform_y_per_u_hB * t354;
    let t392 = t26 * t382;
    let t393 = t25 * t294;
    let t394 = w_platform_x_per_w_platform_y * t371;
    let t395 = t383 - t384;
    let t396 = M * t282;
    let t397 = k9 * v_G_z_per_u_hA;
    let t398 = t386 + t387;
    let t399 = t385 * t355;
    let t400 = t31 * t269;
    let t401 = k11 * t52;
    let mass_u_hA_u_hA = t388 + t389;
    let t402 = t390 - t391;
    let t403 = t393 - t392;
    let t404 = w_platform_x_per_u_hA * t370;
    let t405 = t394 + t395;
    let t406 = t385 * t354;
    let t407 = t396 + t397;
    let t408 = t398 - t399;
    let t409 = t31 * t289;
    let t410 = w_platform_x_per_w_platform_y * t400;
    let t411 = sA * t401;
    let t412 = t225 * t52;
    let t413 = 1.0_f64 / mass_u_hA_u_hA;
    let t414 = t28 * t402;
    let t415 = t403 - t404;
    let t416 = t405 - t406;
    let t417 = sA * t407;
    let k8 = p.k8;
    let t418 = k8 + t408;
    let c = p.c;
    let t419 = u_hA * c;
    let t420 = t409 - t410;
    let t421 = t31 * t266;
    let t422 = t411 + t412;
    let t423 = w_platform_y_per_u_hB * t355;
    let t424 = t415 - t414;
    let t425 = 2.0_f64 * t390;
    let t426 = t417 + t416;
    let t427 = t419 + t418;
    let t428 = v_G_z_per_u_hA * t407;
    let t429 = t323 + t420;
    let t430 = w_platform_y_per_u_hC * t354;
    let t431 = t421 - t422;
    let t432 = t42 * t401;
    let t433 = t31 * t294;
    let mass_u_hA_u_hB = t423 - t424;
    let t434 = t425 - t391;
    let t435 = t25 * t382;
    let t436 = t28 * t426;
    let t437 = t428 + t427;
    let t438 = t385 * t390;
    let t439 = t370 * t314;
    let t440 = t430 - t429;
    let t441 = t26 * t431;
    let t442 = t432 - t433;
    let t443 = t413 * mass_u_hA_u_hB;
    let t444 = w_platform_y_per_u_hB * t434;
    let t445 = k10 + t435;
    let forcing_u_hA = t436 - t437;
    let t446 = t439 + t438;
    let t447 = t28 * t440;
    let t448 = t441 + t442;
    let t449 = t295 - t400;
    let t450 = mass_u_hA_u_hB * t443;
    let mass_u_hB_u_hB = t445 - t444;
    let t451 = t443 * forcing_u_hA;
    let FB = inputs[1];
    let t452 = t446 - FB;
    let t453 = w_platform_y_per_u_hC * t355;
    let t454 = t448 - t447;
    let t455 = t326 + t449;
    let t456 = t25 * t431;
    let pivot_1 = mass_u_hB_u_hB - t450;
    let t457 = 2.0_f64 * t422;
    let t458 = t451 + t452;
    let t459 = t25 * t352;
    let t460 = t453 + t454;
    let t461 = w_platform_x_per_u_hA * t455;
    let t462 = w_platform_y_per_u_hB * t440;
    let t463 = t404 - t456;
    let t464 = 1.0_f64 / pivot_1;
    let t465 = 2.0_f64 * t400;
    let t466 = t421 - t457;
    let t467 = M * t52;
    let t468 = t458 - t459;
    let mass_u_hA_u_hC = t460 - t461;
    let t469 = t462 - t463;
    let t470 = w_platform_y_per_u_hC * t390;
    let t471 = t465 - t326;
    let t472 = t31 * t466;
    let t473 = t52 * t467;
    let t474 = k8 + t468;
    let t475 = u_hB * c;
    let t476 = t443 * mass_u_hA_u_hC;
    let mass_u_hB_u_hC = t469 - t470;
    let t477 = t422 * t259;
    let t478 = t400 * t314;
    let t479 = 2.0_f64 * t429;
    let t480 = w_platform_x_per_u_hA * t471;
    let t481 = t473 + t472;
    let t482 = t475 + t474;
    let t483 = w_platform_y_per_u_hB * t426;
    let t484 = t476 - mass_u_hB_u_hC;
    let t485 = t478 - t477;
    let t486 = t430 - t479;
    let t487 = t481 - t480;
    let t488 = t483 + t482;
    let t489 = t464 * t484;
    let FC = inputs[2];
    let t490 = t485 - FC;
    let t491 = t401 * t184;
    let t492 = t413 * mass_u_hA_u_hC;
    let t493 = t385 * t429;
    let t494 = w_platform_y_per_u_hC * t486;
    let t495 = k10 + t487;
    let t496 = t489 * t488;
    let t497 = t491 + t490;
    let t498 = t492 * forcing_u_hA;
    let t499 = t493 - t386;
    let t500 = mass_u_hA_u_hC * t492;
    let mass_u_hC_u_hC = t494 + t495;
    let t501 = t496 + t497;
    let t502 = t498 + t499;
    let t503 = t31 * t352;
    let t504 = t52 * t251;
    let t505 = t484 * t489;
    let t506 = mass_u_hC_u_hC - t500;
    let t507 = t501 + t502;
    let t508 = t504 - t503;
    let pivot_2 = t506 - t505;
    let t509 = t507 + t508;
    let t510 = Real::abs(pivot_2);
    let t511 = Real::abs(pivot_1);
    let t512 = k8 + t509;
    let t513 = u_hC * c;
    let t514 = Real::abs(mass_u_hA_u_hA);
    let t515 = t513 + t512;
    let t516 = w_platform_y_per_u_hC * t426;
    let t517 = Real::abs(t15);
    let t518 = t516 + t515;
    let t519 = Real::abs(t2);
    let t520 = t518 / pivot_2;
    let t521 = Real::abs(t12);
    let k26 = p.k26;
    let k25 = p.k25;
    let t522 = Real::min(t510 * k26, t511 * k25);
    let k24 = p.k24;
    let t523 = t514 * k24;
    let t524 = t489 * t520;
    let t525 = t464 * t488;
    let t526 = Real::min(t522, t523);
    let k23 = p.k23;
    let t527 = t517 * k23;
    let t528 = t524 + t525;
    let t529 = Real::min(t526, t527);
    let k22 = p.k22;
    let t530 = t519 * k22;
    let t531 = t492 * t520;
    let t532 = t443 * t528;
    let t533 = Real::min(t529, t530);
    let k21 = p.k21;
    let t534 = t521 * k21;
    let t535 = Real::min(t37, t32);
    let t536 = t531 + t532;
    let t537 = t413 * forcing_u_hA;
    let t538 = Real::min(t533, t534);
    let t539 = Real::min(t535, t39);
    let t540 = t120 - t121;
    let t541 = t537 + t536;
    let t542 = Real::min(t538, t539);
    ([u_hA, -t94, u_thA, -t133, u_hB, -t95, u_thB, u_sB, u_hC, -t110, t540, u_sC], [t541, -t528, -t520], t542)
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
    let psiA = q[1];
    let psiB = q[5];
    let t1 = 2.0943951023931953_f64 - (psiA - psiB);
    let thA = q[2];
    let thB = q[6];
    let [(sin_thA, cos_thA), (sin_thB, cos_thB)] = Real::sin_cos_of_two(thA, thB);
    let thC = q[10];
    let [(sin_thC, cos_thC), (sin_t1, _)] = Real::sin_cos_of_two(thC, t1);
    let sC = q[11];
    let t2 = 1.0_f64 / (0.8660254037844386_f64 * sC);
    let sA = q[3];
    let t3 = sA + 0.5_f64 * sC;
    let sB = q[7];
    let t4 = 0.5_f64 * sB;
    let w_platform_x_per_w_platform_y = t3 * t2;
    let t5 = 0.8660254037844386_f64 * sB;
    let t6 = cos_thA * sin_t1;
    let t7 = sA + t4;
    let t8 = t5 * w_platform_x_per_w_platform_y;
    let t9 = 1.1547005383792515_f64 * t6;
    let t10 = t7 + t8;
    let t11 = sB + sC;
    let v_G_z_per_u_hA = cos_thB * t9;
    let t12 = 1.0_f64 / t10;
    let t13 = sA + t11;
    let w_platform_x_per_u_hA = t2 * v_G_z_per_u_hA;
    let t14 = 1.7320508075688772_f64 * t13;
    let t15 = t5 * w_platform_x_per_u_hA;
    let t16 = sin_thB - sin_thC;
    let t17 = 1.0_f64 / t14;
    let t18 = v_G_z_per_u_hA + t15;
    let t19 = 0.5_f64 * t16;
    let t20 = 0.5_f64 * sin_thA;
    let w_platform_y_per_u_hB = t12 * v_G_z_per_u_hA;
    let t21 = t12 * t18;
    let t22 = t20 - t19;
    let u_sB_per_u_hB = 2.0_f64 * sin_thA;
    let t23 = cos_thB * cos_thB;
    let t24 = cos_thC * cos_thC;
    let u_hB = u[1];
    let t25 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t26 = u_hA * t21;
    let w_platform_y_per_u_hC = t12 * t15;
    let t27 = t22 - u_sB_per_u_hB;
    let t28 = t20 + t19;
    let t29 = 1.0_f64 / t23;
    let t30 = 1.0_f64 / t24;
    let t31 = t25 - t26;
    let u_hC = u[2];
    let t32 = u_hC * w_platform_y_per_u_hC;
    let t33 = 0.28867513459481287_f64 * t16;
    let t34 = 0.8660254037844386_f64 * sin_thA;
    let t35 = t17 * t27;
    let t36 = t17 * t16;
    let t37 = u_sB_per_u_hB - t28;
    let t38 = cos_thA * cos_thA;
    let w_platform_y = t31 + t32;
    let t39 = t34 + t33;
    let t40 = u_hA - u_hC;
    let t41 = u_hB * t35;
    let t42 = u_hA * t36;
    let t43 = t17 * t37;
    let t44 = t34 - t33;
    let t45 = 1.0_f64 / t38;
    let t46 = w_platform_x_per_w_platform_y * w_platform_y;
    let t47 = w_platform_x_per_u_hA * t40;
    let t48 = 0.8660254037844386_f64 * t39;
    let t49 = t41 + t42;
    let t50 = u_hC * t43;
    let t51 = 0.5_f64 * t44;
    let t52 = 0.5_f64 * t39;
    let w_platform_x = t47 + t46;
    let t53 = t29 * t48;
    let t54 = t49 + t50;
    let u_psiB_per_w_platform_z = t29 * v_G_z_per_u_hA;
    let t55 = 0.8660254037844386_f64 * t44;
    let u_psiC_per_w_platform_y = t30 * t51;
    let u_psiC_per_w_platform_z = t30 * v_G_z_per_u_hA;
    let t56 = t29 * t52;
    let t57 = w_platform_x * t53;
    let t58 = t54 * u_psiB_per_w_platform_z;
    let t59 = t30 * t55;
    let t60 = w_platform_y * u_psiC_per_w_platform_y;
    let t61 = t54 * u_psiC_per_w_platform_z;
    let t62 = 0.5773502691896257_f64 * t16;
    let t63 = w_platform_y * t56;
    let t64 = t57 + t58;
    let k13 = p.k13;
    let t65 = sin_thB * k13;
    let t66 = w_platform_x * t59;
    let t67 = t61 - t60;
    let t68 = sin_thC * k13;
    let t69 = t45 * t62;
    let u_psiA_per_w_platform_z = t45 * v_G_z_per_u_hA;
    let t70 = t63 + t64;
    let t71 = sin_thB * t65;
    let t72 = t66 + t67;
    let t73 = sin_thC * t68;
    let t74 = w_platform_y * t69;
    let t75 = t54 * u_psiA_per_w_platform_z;
    let t76 = sin_thA * k13;
    let t77 = t70 * t70;
    let k5 = p.k5;
    let t78 = t71 - k5;
    let t79 = t72 * t72;
    let t80 = t73 - k5;
    let t81 = t75 + t74;
    let t82 = sin_thA * t76;
    let t83 = sA * t54;
    let t84 = u_hA * t62;
    let t85 = 1.1547005383792515_f64 * sC;
    let t86 = 0.6666666666666666_f64 * t37;
    let t87 = t78 * t77;
    let t88 = t80 * t79;
    let t89 = t81 * t81;
    let t90 = k5 - t82;
    let v_G_y = t83 - t84;
    let t91 = t85 * t54;
    let t92 = u_hC * t86;
    let t93 = t87 + t88;
    let t94 = t90 * t89;
    let t95 = t54 * t54;
    let t96 = 0.5773502691896257_f64 * v_G_y;
    let t97 = t92 - t91;
    let t98 = t93 - t94;
    let k16 = p.k16;
    let t99 = k16 * t95;
    let t100 = v_G_y * v_G_y;
    let v_G_x = t96 - t97;
    let t101 = t99 + t98;
    let M = p.M;
    let t102 = M * t100;
    let t103 = v_G_x * v_G_x;
    let t104 = sA * w_platform_y;
    let t105 = u_hA * v_G_z_per_u_hA;
    let t106 = t102 + t101;
    let t107 = M * t103;
    let t108 = w_platform_x * w_platform_x;
    let v_G_z = t104 + t105;
    let t109 = t107 + t106;
    let k14 = p.k14;
    let t110 = k14 * t108;
    let t111 = w_platform_y * w_platform_y;
    let t112 = v_G_z * v_G_z;
    let t113 = u_hB * u_hB;
    let t114 = t110 + t109;
    let k15 = p.k15;
    let t115 = k15 * t111;
    let t116 = M * t112;
    let k10 = p.k10;
    let t117 = k10 * t113;
    let t118 = u_hA * u_hA;
    let t119 = u_hC * u_hC;
    let g = p.g;
    let t120 = sA * g;
    let t121 = t115 + t114;
    let t122 = t117 + t116;
    let t123 = k10 * t118;
    let t124 = k10 * t119;
    let hB = q[4];
    let k6 = p.k6;
    let t125 = hB * k6;
    let hA = q[0];
    let k8 = p.k8;
    let t126 = hA * k8;
    let k7 = p.k7;
    let t127 = hB * k7;
    let hC = q[8];
    let t128 = hC * k8;
    let t129 = sin_thA * t120;
    let t130 = hA * g;
    let t131 = t121 + t122;
    let t132 = t123 + t124;
    let t133 = t125 + t126;
    let t134 = t127 + t128;
    let t135 = t130 + t129;
    let t136 = t132 + t131;
    let t137 = t133 + t134;
    let t138 = M * t135;
    let t139 = 0.5_f64 * t136;
    let t140 = t138 + t137;
    (t139, t140)
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
    let psiA = q[1];
    let psiB = q[5];
    let t1 = 2.0943951023931953_f64 - (psiA - psiB);
    let thA = q[2];
    let thB = q[6];
    let [(sin_thA, cos_thA), (sin_thB, cos_thB)] = Real::sin_cos_of_two(thA, thB);
    let thC = q[10];
    let [(sin_thC, cos_thC), (sin_t1, _)] = Real::sin_cos_of_two(thC, t1);
    let sC = q[11];
    let t2 = 1.0_f64 / (0.8660254037844386_f64 * sC);
    let sA = q[3];
    let t3 = sA + 0.5_f64 * sC;
    let sB = q[7];
    let t4 = sB + sC;
    let t5 = 0.5_f64 * sB;
    let w_platform_x_per_w_platform_y = t3 * t2;
    let t6 = 0.8660254037844386_f64 * sB;
    let t7 = sA + t4;
    let t8 = cos_thA * sin_t1;
    let t9 = sA + t5;
    let t10 = t6 * w_platform_x_per_w_platform_y;
    let t11 = 1.7320508075688772_f64 * t7;
    let t12 = 1.1547005383792515_f64 * t8;
    let t13 = sin_thB - sin_thC;
    let t14 = t9 + t10;
    let t15 = 1.0_f64 / t11;
    let v_G_z_per_u_hA = cos_thB * t12;
    let t16 = 0.5_f64 * t13;
    let t17 = 0.5_f64 * sin_thA;
    let t18 = 1.0_f64 / t14;
    let w_platform_x_per_u_hA = t2 * v_G_z_per_u_hA;
    let t19 = t17 - t16;
    let u_sB_per_u_hB = 2.0_f64 * sin_thA;
    let t20 = t6 * w_platform_x_per_u_hA;
    let t21 = t19 - u_sB_per_u_hB;
    let t22 = t17 + t16;
    let t23 = v_G_z_per_u_hA + t20;
    let t24 = t15 * t21;
    let t25 = t15 * t13;
    let t26 = u_sB_per_u_hB - t22;
    let w_platform_y_per_u_hB = t18 * v_G_z_per_u_hA;
    let t27 = t18 * t23;
    let u_hB = u[1];
    let t28 = u_hB * t24;
    let u_hA = u[0];
    let t29 = u_hA * t25;
    let t30 = t15 * t26;
    let t31 = cos_thB * cos_thB;
    let t32 = cos_thC * cos_thC;
    let t33 = u_hB * w_platform_y_per_u_hB;
    let t34 = u_hA * t27;
    let w_platform_y_per_u_hC = t18 * t20;
    let t35 = t28 + t29;
    let u_hC = u[2];
    let t36 = u_hC * t30;
    let t37 = cos_thA * cos_thA;
    let t38 = 1.0_f64 / t31;
    let t39 = 1.0_f64 / cos_thB;
    let t40 = 1.0_f64 / t32;
    let t41 = 1.0_f64 / cos_thC;
    let t42 = t33 - t34;
    let t43 = u_hC * w_platform_y_per_u_hC;
    let t44 = 0.5773502691896257_f64 * t13;
    let t45 = t35 + t36;
    let t46 = 0.28867513459481287_f64 * t13;
    let t47 = 0.8660254037844386_f64 * sin_thA;
    let t48 = 1.0_f64 / t37;
    let t49 = 1.0_f64 / cos_thA;
    let w_platform_y = t42 + t43;
    let t50 = sA * t45;
    let t51 = u_hA * t44;
    let t52 = 1.1547005383792515_f64 * sC;
    let t53 = 0.6666666666666666_f64 * t26;
    let t54 = t47 + t46;
    let t55 = u_hA - u_hC;
    let t56 = t47 - t46;
    let v_G_y = t50 - t51;
    let t57 = t52 * t45;
    let t58 = u_hC * t53;
    let t59 = w_platform_x_per_w_platform_y * w_platform_y;
    let t60 = w_platform_x_per_u_hA * t55;
    let t61 = 0.8660254037844386_f64 * t54;
    let t62 = 0.5_f64 * v_G_z_per_u_hA;
    let t63 = 0.5_f64 * t56;
    let t64 = 0.5773502691896257_f64 * v_G_y;
    let t65 = t58 - t57;
    let t66 = 0.5_f64 * t54;
    let w_platform_x = t60 + t59;
    let t67 = t38 * t61;
    let u_psiB_per_w_platform_z = t38 * v_G_z_per_u_hA;
    let t68 = t39 * t62;
    let t69 = 1.7320508075688772_f64 * sB;
    let t70 = 0.8660254037844386_f64 * t56;
    let u_psiC_per_w_platform_y = t40 * t63;
    let u_psiC_per_w_platform_z = t40 * v_G_z_per_u_hA;
    let t71 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t72 = t41 * t62;
    let u_thC_per_w_platform_z = t41 * t56;
    let u_sC_per_w_platform_z = 1.7320508075688772_f64 * sC;
    let t73 = t48 * t44;
    let u_psiA_per_w_platform_z = t48 * v_G_z_per_u_hA;
    let u_thA_per_w_platform_y = t49 * v_G_z_per_u_hA;
    let t74 = t49 * t44;
    let v_G_x = t64 - t65;
    let t75 = t38 * t66;
    let t76 = w_platform_x * t67;
    let t77 = t45 * u_psiB_per_w_platform_z;
    let t78 = w_platform_y * t68;
    let t79 = t8 * w_platform_x;
    let t80 = t39 * t54;
    let t81 = t69 * t45;
    let t82 = u_hB * u_sB_per_u_hB;
    let t83 = t40 * t70;
    let t84 = w_platform_y * u_psiC_per_w_platform_y;
    let t85 = t45 * u_psiC_per_w_platform_z;
    let u_thC_per_w_platform_x = t41 * t71;
    let t86 = w_platform_y * t72;
    let t87 = t45 * u_thC_per_w_platform_z;
    let t88 = u_sC_per_w_platform_z * t45;
    let t89 = u_hC * u_sB_per_u_hB;
    let t90 = w_platform_y * t73;
    let t91 = t45 * u_psiA_per_w_platform_z;
    let t92 = w_platform_y * u_thA_per_w_platform_y;
    let t93 = t45 * t74;
    let t94 = u_hA * sin_thA;
    let t95 = w_platform_y * t75;
    let t96 = t76 + t77;
    let t97 = t78 + t79;
    let t98 = t45 * t80;
    let t99 = 2.0_f64 * v_G_x;
    let t100 = t82 + t81;
    let t101 = w_platform_x * t83;
    let t102 = t85 - t84;
    let t103 = w_platform_x * u_thC_per_w_platform_x;
    let t104 = t86 + t87;
    let t105 = t89 - t88;
    let t106 = t91 + t90;
    let u_thA = t92 - t93;
    let t107 = t94 + v_G_x;
    let t108 = t95 + t96;
    let u_thB = t98 - t97;
    let u_sB = t100 + t99;
    let t109 = t101 + t102;
    let t110 = t103 - t104;
    let u_sC = t99 + t105;
    [u_hA, -t106, u_thA, -t107, u_hB, -t108, u_thB, u_sB, u_hC, -t109, t110, u_sC]
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
    let psiA = q[1];
    let [(sin_thA, cos_thA), (sin_psiA, cos_psiA)] = Real::sin_cos_of_two(thA, psiA);
    let t1 = cos_thA * cos_psiA;
    let t2 = cos_thA * sin_psiA;
    let sA = q[3];
    let t3 = sA * t1;
    let t4 = sA * sin_thA;
    let t5 = sA * t2;
    let R = p.R;
    let t6 = R - t3;
    let hA = q[0];
    let t7 = hA + t4;
    [t5, t6, t7]
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
    let thB = q[6];
    let psiB = q[5];
    let [(sin_thB, cos_thB), (sin_psiB, cos_psiB)] = Real::sin_cos_of_two(thB, psiB);
    let thC = q[10];
    let psiC = q[9];
    let [(sin_thC, cos_thC), (sin_psiC, cos_psiC)] = Real::sin_cos_of_two(thC, psiC);
    let thA = q[2];
    let psiA = q[1];
    let [(sin_thA, cos_thA), (sin_psiA, cos_psiA)] = Real::sin_cos_of_two(thA, psiA);
    let t1 = 0.5773502691896257_f64 * cos_thB;
    let t2 = t1 * cos_psiB;
    let t3 = cos_thB * sin_psiB;
    let t4 = 0.5773502691896257_f64 * cos_thC;
    let t5 = cos_thB * cos_psiB;
    let t6 = t1 * sin_psiB;
    let t7 = t2 + t3;
    let t8 = t4 * cos_psiC;
    let t9 = t5 - t6;
    let t10 = t4 * sin_psiC;
    let t11 = t7 - t8;
    let t12 = cos_thC * sin_psiC;
    let t13 = t10 + t9;
    let t14 = cos_thC * cos_psiC;
    let t15 = psiA - psiB;
    let t16 = t12 + t11;
    let t17 = sin_thB - sin_thC;
    let t18 = t14 + t13;
    let t19 = 2.0943951023931953_f64 - t15;
    let t20 = 0.5_f64 * t16;
    let t21 = cos_thA * cos_psiA;
    let t22 = 0.5773502691896257_f64 * t17;
    let t23 = cos_thA * sin_psiA;
    let t24 = 0.5_f64 * t18;
    let (sin_t19, cos_t19) = Real::sin_cos(t19);
    let t25 = sin_thA * t20;
    let t26 = t21 * t22;
    let t27 = t23 * t22;
    let t28 = sin_thA * t24;
    let t29 = t25 + t26;
    let t30 = t27 - t28;
    let t31 = t23 * t20;
    let t32 = t21 * t24;
    let t33 = t29 * t29;
    let t34 = t30 * t30;
    let t35 = t31 + t32;
    let t36 = 1.0_f64 / Real::sqrt(t33 + t34 + t35 * t35);
    let t37 = t30 * t36;
    let t38 = t29 * t36;
    let t39 = t35 * t36;
    let t40 = t23 * t37;
    let t41 = t21 * t38;
    let t42 = sin_thA * t38;
    let t43 = t23 * t39;
    let t44 = t40 + t41;
    let t45 = t42 + t43;
    let sC = q[11];
    let t46 = 0.8660254037844386_f64 * sC;
    let t47 = 0.5_f64 * sC;
    let t48 = cos_thA * cos_t19;
    let t49 = sin_thA * t37;
    let t50 = t21 * t39;
    let t51 = t46 * t44;
    let t52 = sin_thA * t47;
    let t53 = t46 * t45;
    let t54 = t21 * t47;
    let t55 = cos_thA * sin_t19;
    let t56 = sin_thB * t48;
    let t57 = sin_thA * cos_thB;
    let t58 = t49 - t50;
    let t59 = t52 + t51;
    let t60 = t54 - t53;
    let t61 = 1.1547005383792515_f64 * t55;
    let t62 = t56 - t57;
    let t63 = 0.8660254037844386_f64 * t23;
    let t64 = 0.5_f64 * t21;
    let hC = q[8];
    let t65 = hC - t59;
    let t66 = t46 * t58;
    let t67 = t23 * t47;
    let R = p.R;
    let t68 = R - t60;
    let t69 = 1.1547005383792515_f64 * t62;
    let t70 = sin_thB * t61;
    let hA = q[0];
    let t71 = t65 - hA;
    let t72 = t66 - t67;
    let t73 = t21 * t68;
    let t74 = t63 + t64;
    let t75 = 0.4330127018922193_f64 * t18;
    let t76 = 0.5_f64 * t23;
    let t77 = 0.4330127018922193_f64 * t16;
    let t78 = cos_psiB * t69;
    let t79 = sin_psiB * t70;
    let t80 = sin_psiB * t69;
    let t81 = cos_psiB * t70;
    let sB = q[7];
    let t82 = 0.8660254037844386_f64 * sB;
    let t83 = 0.5_f64 * sB;
    let t84 = sin_thA * t71;
    let t85 = t23 * t72;
    let sA = q[3];
    let t86 = t73 - sA;
    let t87 = R * t74;
    let t88 = t76 + t75;
    let t89 = t77 - t64;
    let t90 = t78 + t79;
    let t91 = t81 - t80;
    let t92 = t82 * t44;
    let t93 = sin_thA * t83;
    let t94 = t82 * t45;
    let t95 = t21 * t83;
    let t96 = t84 + t85;
    let t97 = t87 + t86;
    let t98 = 0.5_f64 * t17;
    let t99 = 0.5_f64 * sin_thA;
    let t100 = 0.8660254037844386_f64 * t88;
    let t101 = 0.5_f64 * t89;
    let t102 = sin_psiA * t88;
    let t103 = cos_psiA * t89;
    let t104 = sin_psiA * t24;
    let t105 = cos_psiA * t20;
    let t106 = 0.5_f64 * t90;
    let t107 = 0.8660254037844386_f64 * t91;
    let t108 = 0.8660254037844386_f64 * t90;
    let t109 = 0.5_f64 * t91;
    let t110 = t93 - t92;
    let t111 = t95 + t94;
    let t112 = t96 + t97;
    let t113 = t99 + t98;
    let t114 = t100 - t101;
    let t115 = t102 - t103;
    let t116 = sA * t21;
    let t117 = sA * t23;
    let t118 = t104 - t105;
    let t119 = t106 - t107;
    let t120 = t108 + t109;
    let hB = q[4];
    let t121 = t110 - hB;
    let t122 = t82 * t58;
    let t123 = t23 * t83;
    let t124 = R - t111;
    let t125 = 2.0_f64 * t112;
    let t126 = t113 * t71;
    let t127 = t88 * t72;
    let t128 = R * t114;
    let t129 = cos_thA * t115;
    let t130 = sin_thA * t113;
    let t131 = t116 * t20;
    let t132 = t117 * t24;
    let t133 = sA * sin_thA;
    let t134 = cos_thA * t118;
    let t135 = sin_thA * t22;
    let t136 = 0.5_f64 * t120;
    let t137 = 0.8660254037844386_f64 * t119;
    let t138 = hA + t121;
    let t139 = t123 + t122;
    let t140 = t21 * t124;
    let t141 = t63 - t64;
    let t142 = t125 - t126;
    let t143 = t128 + t127;
    let t144 = t130 + t129;
    let t145 = t131 - t132;
    let t146 = t133 * t22;
    let t147 = t135 + t134;
    let v_G_z_per_u_hA = cos_thB * t61;
    let t148 = t136 + t137;
    let t149 = sB * cos_thB;
    let t150 = sin_thA * t138;
    let t151 = t23 * t139;
    let t152 = sA - t140;
    let t153 = R * t141;
    let t154 = t142 - t143;
    let t155 = sA * t144;
    let t156 = t146 - t145;
    let t157 = sA * t147;
    let t158 = t120 + t148;
    let t159 = t116 * t120;
    let t160 = t133 * v_G_z_per_u_hA;
    let t161 = cos_psiB * t149;
    let t162 = t150 + t151;
    let t163 = t153 + t152;
    let t164 = t155 + t154;
    let t165 = t89 * t68;
    let t166 = t156 - t157;
    let t167 = t76 - t75;
    let t168 = t64 + t77;
    let t169 = v_G_z_per_u_hA * t71;
    let t170 = R * t158;
    let t171 = t117 * t119;
    let t172 = t159 + t160;
    let t173 = 1.0_f64 / t46;
    let t174 = R - t161;
    let t175 = R - t116;
    let t176 = sC * cos_thC;
    let t177 = t162 + t163;
    let t178 = t165 + t164;
    let t179 = 1.7320508075688772_f64 * t166;
    let t180 = 0.5_f64 * t168;
    let t181 = 0.8660254037844386_f64 * t167;
    let t182 = cos_psiA * t168;
    let t183 = sin_psiA * t167;
    let t184 = t119 * t72;
    let t185 = t170 + t169;
    let t186 = t120 * t60;
    let t187 = t171 + t172;
    let t188 = 0.8660254037844386_f64 * t174;
    let t189 = sin_psiB * t149;
    let k4 = p.k4;
    let t190 = k4 + t175;
    let t191 = 0.5_f64 * t161;
    let t192 = cos_psiC * t176;
    let t193 = sB + sC;
    let t194 = 2.0_f64 * t177;
    let t195 = t178 + t179;
    let t196 = t99 - t98;
    let t197 = t180 - t181;
    let t198 = t182 + t183;
    let t199 = t184 + t185;
    let t200 = t187 + t186;
    let t201 = t117 + t188;
    let t202 = 0.5_f64 * t189;
    let t203 = t190 - t191;
    let t204 = 0.8660254037844386_f64 * t189;
    let t205 = sB * sin_thB;
    let t206 = t192 - R;
    let t207 = sA + t193;
    let t208 = sA + t47;
    let t209 = t194 + t195;
    let t210 = t196 * t138;
    let t211 = t167 * t139;
    let t212 = R * t197;
    let t213 = cos_thA * t198;
    let t214 = sin_thA * t196;
    let t215 = t199 - t200;
    let t216 = t202 + t201;
    let t217 = t203 - t204;
    let t218 = hA + t133;
    let t219 = hB + t205;
    let t220 = 0.8660254037844386_f64 * t206;
    let t221 = sin_psiC * t176;
    let t222 = 1.7320508075688772_f64 * t207;
    let w_platform_x_per_w_platform_y = t208 * t173;
    let t223 = t209 - t210;
    let t224 = t212 - t211;
    let t225 = t214 + t213;
    let t226 = t173 * t215;
    let t227 = Real::abs(t216);
    let t228 = Real::abs(t217);
    let t229 = t218 - t219;
    let t230 = t117 + t220;
    let t231 = 0.5_f64 * t221;
    let t232 = 0.5_f64 * t192;
    let t233 = 1.0_f64 / t222;
    let t234 = sA + t83;
    let t235 = t82 * w_platform_x_per_w_platform_y;
    let t236 = t223 + t224;
    let t237 = sA * t225;
    let t238 = t82 * t226;
    let t239 = t10 + t14;
    let t240 = Real::abs(t229);
    let t241 = t231 + t230;
    let t242 = t190 - t232;
    let t243 = 0.8660254037844386_f64 * t221;
    let t244 = sC * sin_thC;
    let t245 = t234 + t235;
    let t246 = t236 - t237;
    let t247 = t168 * t124;
    let t248 = t238 - t187;
    let t249 = t120 * t111;
    let t250 = t91 + t120;
    let t251 = 0.8660254037844386_f64 * t9;
    let t252 = 0.8660254037844386_f64 * t239;
    let t253 = Real::abs(t241);
    let t254 = t243 + t242;
    let t255 = hC + t244;
    let t256 = 1.0_f64 / t245;
    let t257 = t247 + t246;
    let t258 = t248 - t249;
    let t259 = t119 * t139;
    let t260 = v_G_z_per_u_hA * t138;
    let t261 = R * t250;
    let t262 = 0.8660254037844386_f64 * t7;
    let t263 = t8 - t12;
    let t264 = Real::abs(t254);
    let t265 = t255 - t218;
    let t266 = t251 - t252;
    let t267 = cos_thB * cos_thB;
    let t268 = cos_thC * cos_thC;
    let t269 = t233 * t257;
    let t270 = t258 - t259;
    let t271 = t261 - t260;
    let t272 = 0.8660254037844386_f64 * t263;
    let t273 = Real::abs(t265);
    let t274 = t23 + t266;
    let t275 = t21 - t262;
    let t276 = 1.0_f64 / t267;
    let t277 = 1.0_f64 / cos_thB;
    let t278 = 1.0_f64 / t268;
    let t279 = 1.0_f64 / cos_thC;
    let t280 = t270 + t271;
    let t281 = sA * t269;
    let t282 = 0.28867513459481287_f64 * t17;
    let t283 = 0.8660254037844386_f64 * sin_thA;
    let t284 = Real::max(t227, t228);
    let t285 = Real::abs(t274);
    let t286 = t272 - t275;
    let t287 = sin_thA + sin_thB;
    let t288 = cos_thA * cos_thA;
    let t289 = t256 * t280;
    let t290 = t281 - t166;
    let t291 = 1.1547005383792515_f64 * sC;
    let t292 = t283 + t282;
    let t293 = t283 - t282;
    let t294 = Real::max(t284, t240);
    let t295 = Real::abs(t286);
    let t296 = sin_thC + t287;
    let t297 = 1.0_f64 / t288;
    let t298 = 1.0_f64 / cos_thA;
    let t299 = 0.5773502691896257_f64 * t290;
    let t300 = t291 * t269;
    let t301 = w_platform_x_per_w_platform_y * t289;
    let t302 = 0.8660254037844386_f64 * t292;
    let t303 = 0.5_f64 * t292;
    let t304 = 0.8660254037844386_f64 * t45;
    let t305 = 0.8660254037844386_f64 * t58;
    let t306 = 0.5_f64 * v_G_z_per_u_hA;
    let t307 = 0.8660254037844386_f64 * t44;
    let t308 = 0.8660254037844386_f64 * t293;
    let t309 = 0.5_f64 * t293;
    let t310 = Real::max(t294, t253);
    let t311 = Real::abs(t296);
    let t312 = t299 + t300;
    let t313 = 0.6666666666666666_f64 * t178;
    let t314 = t226 - t301;
    let t315 = t276 * t302;
    let t316 = t276 * t303;
    let t317 = t64 + t304;
    let t318 = t76 + t305;
    let t319 = t277 * t292;
    let t320 = t277 * t306;
    let t321 = sin_thB - t307;
    let t322 = t278 * t308;
    let u_psiC_per_w_platform_y = t278 * t309;
    let t323 = t305 - t76;
    let t324 = t304 - t64;
    let u_thC_per_w_platform_z = t279 * t293;
    let t325 = t279 * t306;
    let t326 = sin_thC + t307;
    let t327 = Real::max(t310, t264);
    let t328 = t313 - t312;
    let t329 = t23 * t117;
    let t330 = t315 * t314;
    let t331 = t316 * t289;
    let u_psiB_per_w_platform_z = t276 * v_G_z_per_u_hA;
    let t332 = t251 * t317;
    let t333 = t262 * t318;
    let t334 = t319 * t269;
    let t335 = t320 * t289;
    let t336 = t99 + t321;
    let t337 = 1.7320508075688772_f64 * sB;
    let t338 = t322 * t314;
    let t339 = u_psiC_per_w_platform_y * t289;
    let u_psiC_per_w_platform_z = t278 * v_G_z_per_u_hA;
    let t340 = t272 * t323;
    let t341 = t252 * t324;
    let t342 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t343 = u_thC_per_w_platform_z * t269;
    let t344 = t325 * t289;
    let t345 = t99 + t326;
    let u_sC_per_w_platform_z = 1.7320508075688772_f64 * sC;
    let t346 = Real::max(t327, t273);
    let u_psiA_per_w_platform_z = t297 * v_G_z_per_u_hA;
    let t347 = t297 * t22;
    let t348 = t298 * t22;
    let u_thA_per_w_platform_y = t298 * v_G_z_per_u_hA;
    let t349 = t328 - t329;
    let t350 = sin_thA * t133;
    let t351 = t21 * t116;
    let t352 = t330 - t331;
    let t353 = u_psiB_per_w_platform_z * t269;
    let t354 = t332 + t333;
    let t355 = t334 - t335;
    let t356 = t277 * t336;
    let t357 = t337 * t269;
    let t358 = t339 + t338;
    let t359 = u_psiC_per_w_platform_z * t269;
    let t360 = t340 - t341;
    let u_thC_per_w_platform_x = t279 * t342;
    let t361 = t343 + t344;
    let t362 = t279 * t345;
    let t363 = u_sC_per_w_platform_z * t269;
    let t364 = Real::max(t346, t285);
    let t365 = u_psiA_per_w_platform_z * t269;
    let t366 = t347 * t289;
    let t367 = t348 * t269;
    let t368 = u_thA_per_w_platform_y * t289;
    let t369 = t349 - t350;
    let t370 = sA - t351;
    let t371 = t352 - t353;
    let t372 = t276 * t354;
    let t373 = t55 * t314;
    let t374 = t355 - t356;
    let t375 = 2.0_f64 * t328;
    let t376 = t357 - t194;
    let t377 = t358 - t359;
    let t378 = t278 * t360;
    let t379 = u_thC_per_w_platform_x * t314;
    let t380 = t362 + t361;
    let t381 = t125 - t363;
    let t382 = Real::max(t364, t295);
    let t383 = t365 + t366;
    let t384 = t368 - t367;
    let t385 = t369 + t370;
    let t386 = t372 + t371;
    let t387 = t373 + t374;
    let t388 = t376 - t375;
    let t389 = t377 - t378;
    let t390 = t379 + t380;
    let t391 = t381 - t375;
    let t392 = Real::max(t382, t311);
    ([-t383, t384, t385, t386, t387, t388, t389, -t390, t391], t392)
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
