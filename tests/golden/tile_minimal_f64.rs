// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 548 operations (6 abs, 92 add, 13 div, 8 min, 332 mul, 4 sqrt, 93 sub).
// Cost of energy: 185 operations (40 add, 7 div, 118 mul, 1 sqrt, 19 sub).
// Cost of speeds: 180 operations (31 add, 10 div, 112 mul, 4 sqrt, 23 sub).
// Cost of outputs: 78 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 42 mul, 1 sin, 2 sqrt, 11 sub).
// Cost of projection: 0 operations ().
// Cost of prepare: 207 operations (17 abs, 51 add, 13 div, 7 max, 113 mul, 1 sqrt, 5 sub).

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f64;
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
pub const NOMINAL: [f64; 3usize] = [0f64, 0f64, 0f64];
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
    let t2 = 1.0_f64 / (3.0_f64 * t1);
    let t3 = Real::max(5.0_f64 * t1, 1e-24_f64);
    let t4 = 3.4641016151377544_f64 * t3;
    let t5 = 4.0_f64 * t3;
    let t6 = t2 * t4;
    let t7 = t2 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let t11 = Real::sqrt(1.0_f64 + t10);
    let t12 = 1.0_f64 + t11;
    let t13 = 2.0_f64 * t7;
    let t14 = 1.0_f64 / t11;
    let t15 = 1.0_f64 / t12;
    let t16 = t6 * t13;
    let Ic2 = p.Ic2;
    let t17 = Real::abs(Ic2);
    let Ic3 = p.Ic3;
    let t18 = Real::abs(Ic3);
    let t19 = 0.8660254037844386_f64 * t6;
    let t20 = 0.5_f64 * t7;
    let t21 = 0.8660254037844386_f64 * t16;
    let t22 = 0.5_f64 * t10;
    let Ic1 = p.Ic1;
    let t23 = Real::abs(Ic1);
    let t24 = t19 + t20;
    let t25 = t8 + t21;
    let t26 = t9 + t22;
    let M = p.M;
    let t27 = Real::abs(M);
    let t28 = t24 * t14;
    let t29 = t25 * t15;
    let t30 = t26 * t15;
    let t31 = t28 * t28;
    let t32 = 1.0_f64 + t29;
    let t33 = 1.0_f64 + t30;
    let Iz = p.Iz;
    let t34 = Real::abs(Iz);
    let t35 = 1.0_f64 + t31;
    let t36 = t1 * t32;
    let t37 = t1 * t33;
    let t38 = t17 + t18;
    let t39 = 1.0_f64 / t35;
    let t40 = 0.8660254037844386_f64 * t36;
    let t41 = 0.4330127018922193_f64 * t37;
    let t42 = t23 + t38;
    let t43 = t7 * t14;
    let t44 = t20 * t14;
    let t45 = t41 + t40;
    let t46 = t1 * t27;
    let t47 = t42 * t28;
    let t48 = 0.28867513459481287_f64 * t28;
    let t49 = 0.8660254037844386_f64 * t43;
    let t50 = t42 * t44;
    let t51 = 1.3333333333333333_f64 * t45;
    let t52 = t46 * t33;
    let t53 = 3.0_f64 * t17;
    let t54 = t28 * t47;
    let t55 = t48 + t49;
    let t56 = t44 * t50;
    let t57 = 1.0_f64 / t40;
    let t58 = t8 * t15;
    let t59 = t27 * t51;
    let t60 = t37 * t52;
    let t61 = t34 + t53;
    let t62 = t38 + t54;
    let t63 = t14 * t39;
    let t64 = 0.8660254037844386_f64 * t55;
    let t65 = t38 + t56;
    let t66 = 0.5_f64 * t36;
    let t67 = 1.0_f64 + t58;
    let t68 = t51 * t59;
    let t69 = t61 + t60;
    let t70 = t62 * t63;
    let t71 = 0.5_f64 * t55;
    let t72 = t64 * t39;
    let t73 = t14 * t65;
    let Ix = p.Ix;
    let t74 = Real::abs(Ix);
    let t75 = t37 + t66;
    let t76 = t1 * t67;
    let t77 = t68 + t69;
    let t78 = t6 * t15;
    let t79 = t39 * t71;
    let t80 = t70 * t72;
    let t81 = t73 * t64;
    let Iy = p.Iy;
    let t82 = Real::abs(Iy);
    let t83 = t57 * t75;
    let t84 = 0.8660254037844386_f64 * t76;
    let t85 = 0.5_f64 * t76;
    let t86 = t77 * t78;
    let t87 = t70 * t79;
    let t88 = t81 + t80;
    let t89 = t62 * t79;
    let t90 = t83 * t84;
    let t91 = t37 + t85;
    let t92 = t86 + t87;
    let t93 = t7 * t15;
    let t94 = t88 * t78;
    let t95 = t72 * t89;
    let t96 = t62 * t72;
    let t97 = t65 * t64;
    let ms = p.ms;
    let t98 = Real::abs(ms);
    let mc = p.mc;
    let t99 = Real::abs(mc);
    let t100 = t90 + t91;
    let t101 = t93 * t92;
    let t102 = t94 + t95;
    let t103 = 1.5_f64 * t17;
    let t104 = t72 * t96;
    let t105 = t64 * t97;
    let t106 = 1.1547005383792515_f64 * t55;
    let mr = p.mr;
    let t107 = Real::abs(mr);
    let t108 = 1.0_f64 / t100;
    let t109 = t101 + t102;
    let t110 = t105 + t104;
    let t111 = t74 + t103;
    let t112 = t59 * t106;
    let t113 = 2.0_f64 * t109;
    let t114 = t82 + t103;
    let t115 = t14 * t57;
    let t116 = t111 + t110;
    let t117 = 0.3333333333333333_f64 * t28;
    let t118 = 0.5773502691896257_f64 * t28;
    let t119 = t93 * t112;
    let t120 = t83 * t113;
    let t121 = t114 + t60;
    let t122 = t115 * t84;
    let t123 = t116 * t115;
    let t124 = t27 * t117;
    let t125 = t27 * t118;
    let t126 = t83 * t119;
    let t127 = t78 * t112;
    let t128 = 2.0_f64 * t119;
    let t129 = t120 + t121;
    let t130 = t14 + t122;
    let t131 = t117 * t124;
    let t132 = t118 * t125;
    let t133 = t98 + t99;
    let t134 = t108 * t122;
    let t135 = t126 + t127;
    let t136 = t123 + t128;
    let t137 = t27 * t106;
    let t138 = t108 * t130;
    let t139 = t131 + t132;
    let t140 = t107 + t133;
    let t141 = t129 * t134;
    let t142 = 2.0_f64 * t135;
    let t143 = t115 * t136;
    let t144 = t106 * t137;
    let t145 = t14 * t108;
    let t146 = t129 * t138;
    let t147 = t115 * t123;
    let t148 = t140 + t139;
    let t149 = t141 + t142;
    let t150 = t143 + t144;
    let t151 = t129 * t145;
    let t152 = t138 * t146;
    let t153 = t147 + t148;
    let t154 = t134 * t149;
    let t155 = t140 + t150;
    let t156 = t145 * t151;
    let t157 = t152 + t153;
    let t158 = t154 + t155;
    let t159 = t140 + t156;
    let t160 = Real::abs(t12);
    let t161 = Real::abs(t40);
    let t162 = Real::abs(t100);
    let t163 = Real::abs(t157);
    let t164 = Real::abs(t158);
    let t165 = Real::abs(t159);
    let t166 = 0.10125880247738014_f64 * t160;
    let t167 = 0.5189254749591666_f64 * t161;
    let t168 = 0.2853043102145698_f64 * t162;
    let t169 = 0.17872345261993172_f64 * t163;
    let t170 = 0.0795067156593468_f64 * t164;
    let t171 = 0.3224185596213096_f64 * t165;
    let t172 = 3.0_f64 * R;
    let t173 = Real::max(t166, 1e-24_f64);
    let t174 = Real::max(t167, 1e-24_f64);
    let t175 = Real::max(t168, 1e-24_f64);
    let t176 = Real::max(t169, 1e-24_f64);
    let t177 = Real::max(t170, 1e-24_f64);
    let t178 = Real::max(t171, 1e-24_f64);
    let t179 = 1.0_f64 / t172;
    let t180 = 0.5_f64 / t173;
    let t181 = 5.773502691896257_f64 / t174;
    let t182 = 1.6666666666666665_f64 / t175;
    let t183 = 0.2165283291230603_f64 / t176;
    let t184 = 0.21680787182359307_f64 / t177;
    let t185 = 0.21706868422196887_f64 / t178;
    let t186 = Ic3 - Ic2;
    let t187 = 3.0_f64 * Ic2;
    let t188 = 1.5_f64 * Ic2;
    let t189 = t186 - Ic1;
    let t190 = ms + mc;
    let t191 = Iz + t187;
    let t192 = Ix + t188;
    let t193 = Iy + t188;
    let t194 = 0.5_f64 * t189;
    let g = p.g;
    let t195 = ms * g;
    let t196 = mc * g;
    let t197 = g * t190;
    let t198 = M * g;
    let t199 = mr + t190;
    let t200 = R * g;
    let t201 = R * M;
    let t202 = t192 - t193;
    let t203 = t193 - t191;
    let t204 = t191 - t192;
    let c = p.c;
    Prepared { R, M, c, g, k4: t186, k5: t189, k6: t194, k7: t195, k8: t196, k9: t197, k10: t198, k11: t199, k12: t200, k13: t201, k14: t179, k15: t191, k16: t192, k17: t193, k18: t202, k19: t203, k20: t204, k21: t180, k22: t181, k23: t182, k24: t183, k25: t184, k26: t185 }
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
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = 0.8660254037844386_f64 * t6;
    let t28 = 0.5_f64 * t7;
    let t29 = t21 * t26;
    let t30 = 0.8660254037844386_f64 * sC;
    let t31 = 0.5_f64 * sC;
    let t32 = t27 + t28;
    let t33 = t28 - t27;
    let t34 = t29 * t30;
    let t35 = sA + t31;
    let u_sB_per_u_hB = t32 * v_G_z_per_u_hA;
    let t36 = t33 * v_G_z_per_u_hA;
    let t37 = t34 + t35;
    let t38 = t7 * v_G_z_per_u_hA;
    let t39 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t40 = t36 * t36;
    let t41 = 1.0_f64 / t37;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t42 = t39 - 1.0_f64;
    let t43 = 1.0_f64 - t40;
    let t44 = t38 * t38;
    let t45 = w_platform_x_per_u_hB * t30;
    let t46 = 1.0_f64 / t42;
    let t47 = 1.0_f64 / t43;
    let t48 = 1.0_f64 - t44;
    let t49 = v_G_z_per_u_hA + t45;
    let t50 = 1.0_f64 / t48;
    let t51 = 1.0_f64 - t39;
    let k5 = p.k5;
    let t52 = k5 * u_sB_per_u_hB;
    let t53 = k5 * t36;
    let w_platform_y_per_u_hB = t41 * t45;
    let t54 = t41 * t49;
    let t55 = Real::sqrt(t51);
    let t56 = u_sB_per_u_hB * t52;
    let t57 = t36 * t53;
    let t58 = k5 * t38;
    let u_hB = u[1];
    let t59 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t60 = u_hA * t54;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t41;
    let t61 = v_G_z_per_u_hA * t46;
    let k4 = p.k4;
    let t62 = t56 - k4;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t47;
    let t63 = Real::sqrt(t43);
    let t64 = Real::sqrt(t48);
    let t65 = t57 - k4;
    let t66 = t38 * t58;
    let t67 = t59 - t60;
    let u_hC = u[2];
    let t68 = u_hC * w_platform_y_per_u_hC;
    let t69 = u_sB_per_u_hB - t36;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t50;
    let t70 = t66 - k4;
    let t71 = t65 * u_psiC_per_w_platform_z;
    let t72 = t62 * t61;
    let w_platform_y = t67 + t68;
    let t73 = u_hA - u_hB;
    let t74 = 0.28867513459481287_f64 * t69;
    let t75 = 0.8660254037844386_f64 * t38;
    let t76 = 0.4330127018922193_f64 * sA;
    let t77 = u_psiC_per_w_platform_z * t71;
    let t78 = t61 * t72;
    let t79 = t70 * u_psiA_per_w_platform_z;
    let t80 = t29 * w_platform_y;
    let t81 = t73 * w_platform_x_per_u_hB;
    let t82 = t75 - t74;
    let t83 = t74 + t75;
    let t84 = t76 + t18;
    let t85 = t77 + t78;
    let t86 = u_psiA_per_w_platform_z * t79;
    let t87 = 1.0_f64 / t55;
    let t88 = t81 + t80;
    let t89 = t6 * t13;
    let t90 = t7 * t13;
    let t91 = 0.8660254037844386_f64 * t82;
    let t92 = 0.8660254037844386_f64 * t83;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t84;
    let t93 = t86 + t85;
    let k13 = p.k13;
    let t94 = k13 * t22;
    let t95 = 1.0_f64 / t63;
    let t96 = 1.0_f64 / t64;
    let t97 = 0.5_f64 * t82;
    let t98 = t89 * w_platform_y;
    let t99 = t90 * t88;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t69;
    let t100 = t46 * t91;
    let t101 = t47 * t92;
    let M = p.M;
    let t102 = M * v_G_x_per_w_platform_z;
    let k15 = p.k15;
    let t103 = k15 - t93;
    let t104 = sA * t94;
    let t105 = t46 * t97;
    let t106 = t98 + t99;
    let t107 = 0.5_f64 * v_G_z_per_u_hA;
    let t108 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t109 = 0.5_f64 * t83;
    let t110 = v_G_y_per_u_hA * t50;
    let t111 = v_G_x_per_w_platform_z * t102;
    let t112 = t104 + t103;
    let t113 = t71 * t101;
    let t114 = t72 * t100;
    let t115 = t105 * w_platform_y;
    let t116 = t100 * t88;
    let t117 = t107 * t87;
    let t118 = t108 * t87;
    let u_psiC_per_w_platform_y = t47 * t109;
    let t119 = u_psiA_per_w_platform_z * t106;
    let t120 = t110 * w_platform_y;
    let t121 = 0.3333333333333333_f64 * t69;
    let t122 = t111 + t112;
    let t123 = t113 + t114;
    let t124 = t115 - t116;
    let t125 = t61 * t106;
    let t126 = t82 * t87;
    let t127 = w_platform_y * t117;
    let t128 = t88 * t118;
    let t129 = u_psiC_per_w_platform_y * w_platform_y;
    let t130 = t101 * t88;
    let t131 = t95 * t107;
    let u_psiA = t120 - t119;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t96;
    let u_thC_per_w_platform_z = t83 * t95;
    let t132 = v_G_y_per_u_hA * t96;
    let t133 = v_G_x_per_w_platform_z * t106;
    let t134 = u_hA * t121;
    let t135 = 1.1547005383792515_f64 * t82;
    let t136 = t72 * t105;
    let t137 = t71 * u_psiC_per_w_platform_y;
    let t138 = 2.0_f64 * t123;
    let t139 = t90 * t122;
    let t140 = t65 * t101;
    let t141 = t62 * t100;
    let u_psiB = t124 + t125;
    let t142 = t106 * t126;
    let t143 = t127 - t128;
    let t144 = t129 + t130;
    let t145 = u_psiC_per_w_platform_z * t106;
    let t146 = t38 * u_psiA;
    let t147 = t106 * u_thC_per_w_platform_z;
    let t148 = w_platform_y * t131;
    let u_thC_per_w_platform_x = t95 * t108;
    let t149 = t106 * t132;
    let t150 = w_platform_y * u_thA_per_w_platform_y;
    let t151 = t134 + t133;
    let t152 = u_hB * t135;
    let u_sB_per_w_platform_z = 0.8660254037844386_f64 * sA;
    let t153 = 0.5_f64 * t69;
    let t154 = t136 - t137;
    let t155 = t79 * t110;
    let t156 = t62 * t105;
    let t157 = t65 * u_psiC_per_w_platform_y;
    let t158 = t138 + t139;
    let t159 = t101 * t140;
    let t160 = t100 * t141;
    let t161 = u_sB_per_u_hB * u_psiB;
    let u_thB = t142 - t143;
    let t162 = 0.8660254037844386_f64 * w_platform_y;
    let t163 = 0.5_f64 * t88;
    let u_psiC = t144 - t145;
    let t164 = t148 + t147;
    let t165 = t88 * u_thC_per_w_platform_x;
    let t166 = 2.0_f64 * t146;
    let u_thA = t149 + t150;
    let t167 = t152 + t151;
    let t168 = t106 * u_sB_per_w_platform_z;
    let t169 = u_hA * t153;
    let t170 = t122 * t89;
    let t171 = t154 - t155;
    let t172 = t100 * t156;
    let t173 = t101 * t157;
    let t174 = t90 * t158;
    let t175 = t159 + t160;
    let t176 = t161 * u_thB;
    let t177 = t162 + t163;
    let t178 = 0.8660254037844386_f64 * t88;
    let t179 = 0.5_f64 * w_platform_y;
    let t180 = t36 * u_psiC;
    let t181 = t165 + t164;
    let t182 = t166 * u_thA;
    let t183 = t88 * t106;
    let t184 = 0.5_f64 * t167;
    let t185 = t169 + t168;
    let t186 = t170 - t171;
    let t187 = t123 * t89;
    let t188 = t172 - t173;
    let t189 = t175 - t174;
    let t190 = 2.0_f64 * t171;
    let t191 = u_psiC_per_w_platform_y * t157;
    let t192 = t105 * t156;
    let t193 = t70 * t110;
    let t194 = t102 * t121;
    let t195 = v_G_y_per_u_hA * t94;
    let t196 = 2.0_f64 * t176;
    let t197 = t177 * t106;
    let t198 = t178 - t179;
    let t199 = u_psiA * t64;
    let t200 = t162 - t163;
    let t201 = t180 * t181;
    let t202 = t64 * t182;
    let t203 = v_G_y_per_u_hA * t183;
    let t204 = w_platform_y * t88;
    let t205 = t184 + t185;
    let t206 = u_hB * u_sB_per_u_hB;
    let t207 = u_hA * t38;
    let t208 = t90 * t186;
    let t209 = t187 + t188;
    let k16 = p.k16;
    let t210 = t189 - k16;
    let t211 = t190 - t170;
    let t212 = t191 + t192;
    let t213 = t110 * t193;
    let t214 = t194 + t195;
    let t215 = t55 * t196;
    let t216 = t82 * t197;
    let t217 = t177 * t198;
    let t218 = u_psiB * t55;
    let t219 = t146 * t199;
    let t220 = t106 * t200;
    let t221 = 2.0_f64 * t201;
    let t222 = t179 + t178;
    let t223 = t203 - t202;
    let t224 = v_G_z_per_u_hA * t204;
    let t225 = t205 - t206;
    let u_sA = t167 - t207;
    let t226 = t208 + t209;
    let t227 = t29 * t210;
    let t228 = t89 * t211;
    let t229 = t213 + t212;
    let t230 = t214 * t90;
    let t231 = t215 - t216;
    let t232 = v_G_z_per_u_hA * t217;
    let t233 = u_psiC * t63;
    let t234 = t161 * t218;
    let t235 = k5 * t219;
    let t236 = t83 * t220;
    let t237 = t63 * t221;
    let t238 = t200 * t222;
    let k6 = p.k6;
    let t239 = k6 * t182;
    let t240 = t224 + t223;
    let t241 = t106 * u_sA;
    let t242 = t106 * t225;
    let t243 = 2.0_f64 * t226;
    let t244 = t228 + t229;
    let t245 = t226 - t227;
    let t246 = t230 * t29;
    let t247 = t214 * t89;
    let t248 = t231 - t232;
    let t249 = k6 * t196;
    let t250 = t180 * t233;
    let t251 = k5 * t234;
    let t252 = t236 + t237;
    let t253 = v_G_z_per_u_hA * t238;
    let t254 = t64 * t239;
    let t255 = t50 * t240;
    let t256 = t132 * t235;
    let k18 = p.k18;
    let t257 = k18 * t204;
    let t258 = 2.0_f64 * t241;
    let t259 = sA * t204;
    let t260 = sB * t217;
    let t261 = 2.0_f64 * t242;
    let t262 = t243 - t227;
    let k17 = p.k17;
    let t263 = k17 - t244;
    let t264 = t245 * w_platform_x_per_u_hB;
    let t265 = t246 + t247;
    let t266 = M * t121;
    let t267 = M * v_G_y_per_u_hA;
    let t268 = t102 * t135;
    let t269 = t46 * t248;
    let t270 = 2.0_f64 * t249;
    let t271 = k5 * t250;
    let t272 = t253 + t252;
    let t273 = k6 * t221;
    let t274 = 2.0_f64 * t254;
    let t275 = t70 * t255;
    let t276 = t126 * t251;
    let t277 = t257 - t256;
    let t278 = t259 + t258;
    let t279 = t260 + t261;
    let t280 = sA * t106;
    let t281 = u_hA * v_G_y_per_u_hA;
    let t282 = t29 * t262;
    let t283 = t104 + t263;
    let t284 = t264 + t265;
    let t285 = v_G_z_per_u_hA * t94;
    let t286 = t210 * w_platform_x_per_u_hB;
    let t287 = 2.0_f64 * t230;
    let t288 = t121 * t266;
    let t289 = v_G_y_per_u_hA * t267;
    let t290 = t90 * t268;
    let t291 = t62 * t269;
    let t292 = t55 * t270;
    let u_psiC_dot_bias = t47 * t272;
    let t293 = t63 * t273;
    let t294 = t274 - t275;
    let t295 = u_thC_per_w_platform_z * t271;
    let t296 = t276 + t277;
    let t297 = 0.8660254037844386_f64 * t279;
    let t298 = 0.4330127018922193_f64 * t278;
    let t299 = u_hC * t36;
    let v_G_y = t280 + t281;
    let t300 = t282 + t283;
    let t301 = t285 + t284;
    let t302 = t286 - t287;
    let t303 = t288 + t289;
    let t304 = t29 * t290;
    let t305 = t89 * t268;
    let t306 = t291 - t292;
    let t307 = t65 * u_psiC_dot_bias;
    let t308 = 2.0_f64 * t293;
    let t309 = t198 * t225;
    let t310 = w_platform_y * u_sA;
    let t311 = t295 - t296;
    let t312 = u_psiA_per_w_platform_z * t294;
    let t313 = t298 - t297;
    let t314 = t299 - t184;
    let t315 = 0.8660254037844386_f64 * v_G_y;
    let t316 = t300 * t54;
    let t317 = 2.0_f64 * t301;
    let t318 = w_platform_x_per_u_hB * t302;
    let k11 = p.k11;
    let t319 = k11 + t303;
    let t320 = M * v_G_z_per_u_hA;
    let t321 = t304 + t305;
    let t322 = t307 + t308;
    let t323 = sB * t197;
    let t324 = 2.0_f64 * t309;
    let t325 = 2.0_f64 * t310;
    let t326 = sA * t183;
    let t327 = t61 * t306;
    let t328 = t312 + t311;
    let t329 = M * t278;
    let k10 = p.k10;
    let t330 = k10 * v_G_y_per_u_hA;
    let t331 = 1.3333333333333333_f64 * t313;
    let t332 = t118 * t251;
    let t333 = u_thC_per_w_platform_x * t271;
    let u_sC = t314 + t315;
    let t334 = t316 - t317;
    let t335 = t318 - t319;
    let t336 = v_G_z_per_u_hA * t320;
    let t337 = t321 - t264;
    let t338 = t300 * w_platform_y_per_u_hB;
    let t339 = t131 * t271;
    let t340 = t117 * t251;
    let t341 = t323 - t324;
    let t342 = t325 - t326;
    let t343 = t327 - t328;
    let t344 = u_psiC_per_w_platform_z * t322;
    let t345 = t329 + t330;
    let t346 = M * t331;
    let t347 = k10 * t38;
    let t348 = t332 - t333;
    let t349 = t100 * t306;
    let t350 = t222 * u_sC;
    let t351 = t54 * t334;
    let t352 = t335 - t336;
    let t353 = t338 + t337;
    let t354 = M * t135;
    let t355 = t339 + t340;
    let t356 = u_thA_per_w_platform_y * t235;
    let t357 = t342 - t341;
    let t358 = t344 - t343;
    let t359 = sA * t345;
    let t360 = t346 + t347;
    let t361 = t348 - t349;
    let t362 = t101 * t322;
    let t363 = w_platform_y * t106;
    let t364 = sC * t220;
    let t365 = 2.0_f64 * t350;
    let mass_u_hA_u_hA = t351 - t352;
    let t366 = t54 * t353;
    let t367 = t121 * t354;
    let t368 = t230 - t290;
    let t369 = 2.0_f64 * t290;
    let t370 = t105 * t306;
    let t371 = t356 + t355;
    let t372 = t21 * t357;
    let t373 = t359 + t358;
    let t374 = v_G_x_per_w_platform_z * t360;
    let t375 = t362 + t361;
    let k19 = p.k19;
    let t376 = k19 * t363;
    let t377 = t364 + t365;
    let t378 = 1.0_f64 / mass_u_hA_u_hA;
    let t379 = t366 - t367;
    let t380 = t301 * w_platform_y_per_u_hB;
    let t381 = t368 - t286;
    let t382 = t286 + t369;
    let t383 = t370 - t371;
    let t384 = u_psiC_per_w_platform_y * t322;
    let t385 = t374 + t373;
    let t386 = t376 + t375;
    let t387 = t210 * t372;
    let t388 = t30 * t372;
    let t389 = t342 + t377;
    let t390 = t380 - t379;
    let t391 = w_platform_x_per_u_hB * t381;
    let t392 = 2.0_f64 * t337;
    let t393 = w_platform_x_per_u_hB * t382;
    let t394 = t135 * t354;
    let t395 = t384 + t383;
    let t396 = t110 * t294;
    let t397 = t387 + t386;
    let t398 = t90 * t385;
    let t399 = t388 + t389;
    let t400 = t230 * t372;
    let mass_u_hA_u_hB = t390 - t391;
    let t401 = t338 + t392;
    let t402 = t393 - t394;
    let t403 = t396 + t395;
    let k20 = p.k20;
    let t404 = k20 * t183;
    let t405 = t397 - t398;
    let t406 = t41 * t399;
    let FA = inputs[0];
    let t407 = FA - t400;
    let t408 = t121 * t360;
    let t409 = t378 * mass_u_hA_u_hB;
    let t410 = w_platform_y_per_u_hB * t401;
    let t411 = t402 - k11;
    let t412 = t404 + t403;
    let t413 = t226 * t372;
    let t414 = w_platform_x_per_u_hB * t405;
    let t415 = t301 * t406;
    let t416 = t407 - t408;
    let t417 = v_G_y_per_u_hA * t345;
    let t418 = mass_u_hA_u_hB * t409;
    let mass_u_hB_u_hB = t410 - t411;
    let t419 = t300 * w_platform_y_per_u_hC;
    let t420 = t412 - t413;
    let t421 = t89 * t385;
    let t422 = t29 * t405;
    let t423 = t300 * t406;
    let t424 = M * t342;
    let t425 = k10 * v_G_z_per_u_hA;
    let t426 = t290 * t372;
    let t427 = t415 + t414;
    let t428 = t416 - t417;
    let pivot_1 = mass_u_hB_u_hB - t418;
    let t429 = t301 * w_platform_y_per_u_hC;
    let t430 = t54 * t419;
    let t431 = t420 - t421;
    let t432 = t423 + t422;
    let t433 = t424 + t425;
    let t434 = t135 * t360;
    let t435 = t337 * t406;
    let FB = inputs[1];
    let t436 = FB - t426;
    let t437 = t428 + t427;
    let t438 = 1.0_f64 / pivot_1;
    let mass_u_hA_u_hC = t429 - t430;
    let t439 = t337 * w_platform_y_per_u_hC;
    let t440 = w_platform_y_per_u_hB * t419;
    let t441 = t431 + t432;
    let t442 = sA * t433;
    let t443 = t414 + t434;
    let t444 = t435 + t436;
    let k9 = p.k9;
    let t445 = t437 - k9;
    let c = p.c;
    let t446 = u_hA * c;
    let t447 = t409 * mass_u_hA_u_hC;
    let mass_u_hB_u_hC = t439 + t440;
    let t448 = t441 - t442;
    let t449 = t444 - t443;
    let t450 = t445 - t446;
    let t451 = v_G_z_per_u_hA * t433;
    let t452 = mass_u_hB_u_hC - t447;
    let t453 = t378 * mass_u_hA_u_hC;
    let t454 = w_platform_y_per_u_hC * t419;
    let t455 = t449 - k9;
    let t456 = u_hB * c;
    let t457 = t54 * t448;
    let t458 = t450 - t451;
    let t459 = t438 * t452;
    let t460 = mass_u_hA_u_hC * t453;
    let mass_u_hC_u_hC = k11 + t454;
    let t461 = w_platform_y_per_u_hB * t448;
    let t462 = t455 - t456;
    let forcing_u_hA = t458 - t457;
    let t463 = t452 * t459;
    let t464 = mass_u_hC_u_hC - t460;
    let forcing_u_hB = t461 + t462;
    let t465 = t409 * forcing_u_hA;
    let pivot_2 = t464 - t463;
    let t466 = forcing_u_hB - t465;
    let t467 = u_hC * c;
    let FC = inputs[2];
    let t468 = k9 - FC;
    let t469 = Real::abs(pivot_2);
    let t470 = Real::abs(pivot_1);
    let t471 = t459 * t466;
    let t472 = t453 * forcing_u_hA;
    let t473 = w_platform_y_per_u_hC * t448;
    let t474 = t467 + t468;
    let t475 = Real::abs(mass_u_hA_u_hA);
    let t476 = t471 + t472;
    let forcing_u_hC = t473 - t474;
    let t477 = Real::abs(t37);
    let t478 = forcing_u_hC - t476;
    let t479 = Real::abs(t18);
    let t480 = t478 / pivot_2;
    let t481 = Real::abs(t11);
    let k26 = p.k26;
    let k25 = p.k25;
    let t482 = Real::min(t469 * k26, t470 * k25);
    let k24 = p.k24;
    let t483 = t475 * k24;
    let t484 = t438 * t466;
    let t485 = t459 * t480;
    let t486 = Real::min(t482, t483);
    let k23 = p.k23;
    let t487 = t477 * k23;
    let t488 = t484 - t485;
    let t489 = Real::min(t486, t487);
    let k22 = p.k22;
    let t490 = t479 * k22;
    let t491 = t409 * t488;
    let t492 = t453 * t480;
    let t493 = Real::min(t489, t490);
    let k21 = p.k21;
    let t494 = t481 * k21;
    let t495 = Real::min(t48, t51);
    let t496 = t492 + t491;
    let t497 = t378 * forcing_u_hA;
    let t498 = Real::min(t493, t494);
    let t499 = Real::min(t495, t43);
    let t500 = t497 - t496;
    let t501 = Real::min(t498, t499);
    ([u_hA, u_hB, u_hC], [t500, t488, t480], t501)
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
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = t21 * t26;
    let t28 = 0.8660254037844386_f64 * sC;
    let t29 = 0.5_f64 * sC;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t30 = 1.0_f64 / (t27 * t28 + (sA + t29));
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t31 = 0.8660254037844386_f64 * t6;
    let t32 = 0.5_f64 * t7;
    let t33 = w_platform_x_per_u_hB * t28;
    let t34 = t31 + t32;
    let t35 = t32 - t31;
    let t36 = v_G_z_per_u_hA + t33;
    let u_sB_per_u_hB = t34 * v_G_z_per_u_hA;
    let t37 = t35 * v_G_z_per_u_hA;
    let w_platform_y_per_u_hB = t30 * t33;
    let t38 = t30 * t36;
    let t39 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t40 = t37 * t37;
    let u_hB = u[1];
    let t41 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t42 = u_hA * t38;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t30;
    let t43 = t7 * v_G_z_per_u_hA;
    let t44 = t39 - 1.0_f64;
    let t45 = 1.0_f64 - t40;
    let t46 = t41 - t42;
    let u_hC = u[2];
    let t47 = u_hC * w_platform_y_per_u_hC;
    let t48 = u_sB_per_u_hB - t37;
    let t49 = 1.0_f64 / t44;
    let t50 = 1.0_f64 / t45;
    let t51 = t43 * t43;
    let w_platform_y = t46 + t47;
    let t52 = 0.28867513459481287_f64 * t48;
    let t53 = 0.8660254037844386_f64 * t43;
    let t54 = u_hA - u_hB;
    let t55 = 1.0_f64 - t51;
    let t56 = t53 - t52;
    let t57 = t27 * w_platform_y;
    let t58 = t54 * w_platform_x_per_u_hB;
    let t59 = t52 + t53;
    let t60 = 1.0_f64 / t55;
    let t61 = 0.5_f64 * t56;
    let t62 = t58 + t57;
    let t63 = 0.8660254037844386_f64 * t56;
    let t64 = t6 * t13;
    let t65 = t7 * t13;
    let t66 = 0.5_f64 * t59;
    let t67 = 0.8660254037844386_f64 * t59;
    let t68 = t49 * t61;
    let t69 = t49 * t63;
    let t70 = t64 * w_platform_y;
    let t71 = t65 * t62;
    let u_psiC_per_w_platform_y = t50 * t66;
    let t72 = t50 * t67;
    let t73 = t68 * w_platform_y;
    let t74 = t69 * t62;
    let t75 = t70 + t71;
    let t76 = v_G_z_per_u_hA * t49;
    let t77 = u_psiC_per_w_platform_y * w_platform_y;
    let t78 = t72 * t62;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t50;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t48;
    let t79 = t73 - t74;
    let t80 = t76 * t75;
    let k5 = p.k5;
    let t81 = k5 * u_sB_per_u_hB;
    let t82 = t77 + t78;
    let t83 = u_psiC_per_w_platform_z * t75;
    let t84 = k5 * t37;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t60;
    let t85 = v_G_y_per_u_hA * t60;
    let t86 = 0.4330127018922193_f64 * sA;
    let u_psiB = t79 + t80;
    let t87 = u_sB_per_u_hB * t81;
    let u_psiC = t82 - t83;
    let t88 = t37 * t84;
    let t89 = u_psiA_per_w_platform_z * t75;
    let t90 = t85 * w_platform_y;
    let t91 = k5 * t43;
    let t92 = t86 + t18;
    let t93 = u_psiB * u_psiB;
    let k4 = p.k4;
    let t94 = t87 - k4;
    let t95 = u_psiC * u_psiC;
    let t96 = t88 - k4;
    let u_psiA = t90 - t89;
    let t97 = t43 * t91;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t92;
    let t98 = 0.3333333333333333_f64 * t48;
    let t99 = t94 * t93;
    let t100 = t96 * t95;
    let t101 = u_psiA * u_psiA;
    let t102 = t97 - k4;
    let t103 = sA * t75;
    let t104 = u_hA * v_G_y_per_u_hA;
    let t105 = v_G_x_per_w_platform_z * t75;
    let t106 = u_hA * t98;
    let t107 = 1.1547005383792515_f64 * t56;
    let t108 = t99 + t100;
    let t109 = t102 * t101;
    let t110 = t75 * t75;
    let v_G_y = t103 + t104;
    let t111 = t106 + t105;
    let t112 = u_hB * t107;
    let t113 = t109 + t108;
    let k15 = p.k15;
    let t114 = k15 * t110;
    let t115 = v_G_y * v_G_y;
    let t116 = t112 + t111;
    let t117 = t114 - t113;
    let M = p.M;
    let t118 = M * t115;
    let t119 = t116 * t116;
    let t120 = sA * w_platform_y;
    let t121 = u_hA * v_G_z_per_u_hA;
    let t122 = t118 + t117;
    let t123 = M * t119;
    let t124 = t62 * t62;
    let v_G_z = t120 + t121;
    let t125 = t123 + t122;
    let k16 = p.k16;
    let t126 = k16 * t124;
    let t127 = w_platform_y * w_platform_y;
    let t128 = v_G_z * v_G_z;
    let t129 = u_hB * u_hB;
    let t130 = t126 + t125;
    let k17 = p.k17;
    let t131 = k17 * t127;
    let t132 = M * t128;
    let k11 = p.k11;
    let t133 = k11 * t129;
    let t134 = u_hA * u_hA;
    let t135 = u_hC * u_hC;
    let k12 = p.k12;
    let t136 = k12 * t22;
    let t137 = t131 + t130;
    let t138 = t133 + t132;
    let t139 = k11 * t134;
    let t140 = k11 * t135;
    let t141 = t43 * t136;
    let g = p.g;
    let t142 = hA * g;
    let k7 = p.k7;
    let t143 = hB * k7;
    let k9 = p.k9;
    let t144 = hA * k9;
    let k8 = p.k8;
    let t145 = hB * k8;
    let t146 = hC * k9;
    let t147 = t137 + t138;
    let t148 = t139 + t140;
    let t149 = t142 + t141;
    let t150 = t143 + t144;
    let t151 = t145 + t146;
    let t152 = t148 + t147;
    let t153 = M * t149;
    let t154 = t150 + t151;
    let t155 = 0.5_f64 * t152;
    let t156 = t153 + t154;
    (t155, t156)
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
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = t21 * t26;
    let t28 = 0.8660254037844386_f64 * sC;
    let t29 = 0.5_f64 * sC;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t30 = 1.0_f64 / (t27 * t28 + (sA + t29));
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t31 = 0.8660254037844386_f64 * t6;
    let t32 = 0.5_f64 * t7;
    let t33 = w_platform_x_per_u_hB * t28;
    let t34 = t31 + t32;
    let t35 = t32 - t31;
    let t36 = v_G_z_per_u_hA + t33;
    let u_sB_per_u_hB = t34 * v_G_z_per_u_hA;
    let t37 = t35 * v_G_z_per_u_hA;
    let w_platform_y_per_u_hB = t30 * t33;
    let t38 = t30 * t36;
    let t39 = t7 * v_G_z_per_u_hA;
    let t40 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t41 = t37 * t37;
    let u_hB = u[1];
    let t42 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t43 = u_hA * t38;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t30;
    let t44 = t39 * t39;
    let t45 = 1.0_f64 - t40;
    let t46 = 1.0_f64 - t41;
    let t47 = t42 - t43;
    let u_hC = u[2];
    let t48 = u_hC * w_platform_y_per_u_hC;
    let t49 = 1.0_f64 - t44;
    let t50 = Real::sqrt(t45);
    let t51 = Real::sqrt(t46);
    let w_platform_y = t47 + t48;
    let t52 = u_hA - u_hB;
    let t53 = Real::sqrt(t49);
    let t54 = t27 * w_platform_y;
    let t55 = t52 * w_platform_x_per_u_hB;
    let t56 = t6 * t13;
    let t57 = t55 + t54;
    let t58 = t7 * t13;
    let t59 = u_sB_per_u_hB - t37;
    let t60 = 0.4330127018922193_f64 * sA;
    let t61 = t40 - 1.0_f64;
    let t62 = t56 * w_platform_y;
    let t63 = t58 * t57;
    let t64 = t60 + t18;
    let t65 = 0.28867513459481287_f64 * t59;
    let t66 = 0.8660254037844386_f64 * t39;
    let t67 = 1.0_f64 / t61;
    let t68 = 1.0_f64 / t50;
    let t69 = 1.0_f64 / t46;
    let t70 = 1.0_f64 / t51;
    let t71 = t62 + t63;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t64;
    let t72 = 0.3333333333333333_f64 * t59;
    let t73 = t66 - t65;
    let t74 = 1.0_f64 / t49;
    let t75 = 1.0_f64 / t53;
    let t76 = v_G_x_per_w_platform_z * t71;
    let t77 = u_hA * t72;
    let t78 = 1.1547005383792515_f64 * t73;
    let t79 = t65 + t66;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t59;
    let t80 = t77 + t76;
    let t81 = u_hB * t78;
    let t82 = 0.5_f64 * t73;
    let t83 = 0.8660254037844386_f64 * t73;
    let t84 = 0.5_f64 * v_G_z_per_u_hA;
    let t85 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let u_sB_per_w_platform_z = 0.8660254037844386_f64 * sA;
    let t86 = 0.5_f64 * t59;
    let t87 = 0.5_f64 * t79;
    let t88 = 0.8660254037844386_f64 * t79;
    let t89 = t7 * root;
    let t90 = t6 * root;
    let t91 = t81 + t80;
    let t92 = t67 * t82;
    let t93 = t67 * t83;
    let t94 = t84 * t68;
    let t95 = t85 * t68;
    let t96 = t71 * u_sB_per_w_platform_z;
    let t97 = u_hA * t86;
    let u_psiC_per_w_platform_y = t69 * t87;
    let t98 = t69 * t88;
    let u_thC_per_w_platform_z = t79 * t70;
    let t99 = t70 * t84;
    let t100 = sA * t71;
    let t101 = u_hA * v_G_y_per_u_hA;
    let t102 = w_platform_y * t89;
    let t103 = t57 * t90;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t74;
    let t104 = v_G_y_per_u_hA * t74;
    let t105 = v_G_y_per_u_hA * t75;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t75;
    let t106 = t92 * w_platform_y;
    let t107 = t93 * t57;
    let t108 = v_G_z_per_u_hA * t67;
    let t109 = t73 * t68;
    let t110 = w_platform_y * t94;
    let t111 = t57 * t95;
    let t112 = 0.5_f64 * t91;
    let t113 = t97 + t96;
    let t114 = u_psiC_per_w_platform_y * w_platform_y;
    let t115 = t98 * t57;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t69;
    let t116 = t71 * u_thC_per_w_platform_z;
    let t117 = w_platform_y * t99;
    let u_thC_per_w_platform_x = t70 * t85;
    let t118 = u_hC * t37;
    let v_G_y = t100 + t101;
    let u_root = t102 - t103;
    let t119 = u_psiA_per_w_platform_z * t71;
    let t120 = t104 * w_platform_y;
    let t121 = t71 * t105;
    let t122 = w_platform_y * u_thA_per_w_platform_y;
    let t123 = u_hA * t39;
    let t124 = t106 - t107;
    let t125 = t108 * t71;
    let t126 = t71 * t109;
    let t127 = t110 - t111;
    let t128 = t112 + t113;
    let t129 = u_hB * u_sB_per_u_hB;
    let t130 = t114 + t115;
    let t131 = u_psiC_per_w_platform_z * t71;
    let t132 = t117 + t116;
    let t133 = t57 * u_thC_per_w_platform_x;
    let t134 = t118 - t112;
    let t135 = 0.8660254037844386_f64 * v_G_y;
    let t136 = t58 * u_root;
    let t137 = root * w_platform_y;
    let t138 = t56 * u_root;
    let t139 = root * t57;
    let u_psiA = t120 - t119;
    let u_thA = t121 + t122;
    let u_sA = t91 - t123;
    let u_psiB = t124 + t125;
    let u_thB = t126 - t127;
    let t140 = t129 - t128;
    let u_psiC = t130 - t131;
    let t141 = t133 + t132;
    let u_sC = t134 + t135;
    let u_slope_x = t137 + t136;
    let u_slope_y = t139 - t138;
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, t140, u_hC, u_psiC, -t141, u_sC, u_slope_x, u_slope_y, u_root]
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
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let k = 1.0_f64 / (root * t11);
    let t12 = t7 * k;
    let t13 = t9 * k;
    let psiA = Real::atan2(t6 * t12, 1.0_f64 - t13);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t14 = t7 * v_G_z_per_u_hA;
    let t15 = 1.0_f64 - t14 * t14;
    let t16 = 1.0_f64 / t11;
    let t17 = Real::sqrt(t15);
    let t18 = 0.8660254037844386_f64 * t6;
    let t19 = 0.5_f64 * t7;
    let t20 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let t21 = 2.0_f64 * t7;
    let t22 = t18 + t19;
    let t23 = t19 - t18;
    let t24 = t20 + cos2;
    let t25 = t6 * t21;
    let u_sB_per_u_hB = t22 * v_G_z_per_u_hA;
    let t26 = t23 * v_G_z_per_u_hA;
    let t27 = t24 * t16;
    let t28 = 0.8660254037844386_f64 * t25;
    let thA = Real::asin(t14);
    let t29 = Real::asin(u_sB_per_u_hB);
    let t30 = Real::asin(t26);
    let t31 = 1.0_f64 + t27;
    let t32 = 0.8660254037844386_f64 * t7;
    let t33 = 0.5_f64 * t6;
    let t34 = t22 * t22;
    let t35 = t8 + t28;
    let t36 = t23 * t23;
    let t37 = t8 - t28;
    let R = p.R;
    let sA = R * t31;
    let t38 = t17 * cos_psiA;
    let t39 = t22 * k;
    let t40 = t32 - t33;
    let t41 = t34 * k;
    let t42 = t35 * t16;
    let t43 = t23 * k;
    let acrossC = t32 + t33;
    let t44 = t36 * k;
    let t45 = t37 * t16;
    let t46 = t17 * sin_psiA;
    let t47 = sA * t38;
    let t48 = sA * t14;
    let t49 = t40 * t39;
    let t50 = 1.0_f64 - t41;
    let t51 = 1.0_f64 + t42;
    let t52 = acrossC * t43;
    let t53 = 1.0_f64 - t44;
    let t54 = 1.0_f64 + t45;
    let t55 = sA * t46;
    let t56 = R - t47;
    let t57 = hA + t48;
    let psiB = Real::atan2(-t49, t50);
    let sB = R * t51;
    let psiC = Real::atan2(t52, t53);
    let sC = R * t54;
    [t55, t56, t57, psiA, thA, sA, psiB, -t29, sB, psiC, -t30, sC]
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
    ([], 0.0_f64)
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
