// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 737 operations (12 abs, 140 add, 14 div, 11 min, 436 mul, 4 sqrt, 120 sub).
// Cost of energy: 236 operations (45 add, 11 div, 147 mul, 4 sqrt, 29 sub).
// Cost of speeds: 178 operations (24 add, 11 div, 107 mul, 4 sqrt, 32 sub).
// Cost of outputs: 78 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 41 mul, 1 sin, 2 sqrt, 12 sub).
// Cost of projection: 0 operations ().
// Cost of prepare: 17 operations (5 add, 1 div, 6 mul, 5 sub).

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
///17 operations.
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
    let Ic1 = p.Ic1;
    let t1 = 0.5_f32 * (Ic1 + Ic2 - Ic3);
    let t2 = ms + mc;
    let t3 = g * t2;
    let t4 = Ix - Iz;
    let t5 = Iy - Ix;
    let mr = p.mr;
    let t6 = mr + t2;
    let t7 = 0.57735026_f32 * M;
    let t8 = 1.3333334_f32 * M;
    let t9 = 1.0_f32 / (3.0_f32 * R);
    let t10 = 0.5_f32 * (Ic1 - (Ic2 + Ic3));
    let t11 = t1 + t10;
    let t12 = Iy - Iz;
    Prepared { R, ms, mc, Ic2, Ic3, M, Ix, Iy, Iz, c, g, k11: t1, k12: t2, k13: t3, k14: t4, k15: t5, k16: t6, k17: t7, k18: t8, k19: t9, k20: t10, k21: t11, k22: t12 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///737 operations.
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
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let R = p.R;
    let k19 = p.k19;
    let hB = q[1];
    let hC = q[2];
    let t1 = k19 * (1.7320508_f32 * (hB - hC));
    let hA = q[0];
    let t2 = k19 * (2.0_f32 * (0.5_f32 * (hB + hC) - hA));
    let t3 = 0.8660254_f32 * (t1 * (2.0_f32 * t2));
    let t4 = t1 * t1;
    let t5 = t2 * t2;
    let root = Real::sqrt(t4 + (1.0_f32 + t5));
    let t6 = 1.0_f32 / (1.0_f32 + root);
    let t7 = R * ((t3 - t4) * t6 - 1.0_f32);
    let t8 = 0.8660254_f32 * t7;
    let t9 = 1.0_f32 / t8;
    let cos2 = t5 - t4;
    let sA = R * (1.0_f32 + t6 * (0.5_f32 * (t4 + t5) + cos2));
    let w_platform_x_per_w_platform_y = t9 * (0.5_f32 * t7 - sA);
    let sB = R * (1.0_f32 + t6 * (t4 + t3));
    let t10 = 0.8660254_f32 * sB;
    let t11 = w_platform_x_per_w_platform_y * t10 + (sA + 0.5_f32 * sB);
    let t12 = 1.0_f32 / t11;
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let t13 = v_G_z_per_u_hA * t9;
    let t14 = t13 * t10;
    let t15 = t12 * (t14 - v_G_z_per_u_hA);
    let t16 = 0.8660254_f32 * t1;
    let t17 = 0.5_f32 * t2;
    let alongC = t16 - t17;
    let t18 = alongC * v_G_z_per_u_hA;
    let t19 = t18 * t18;
    let t20 = 1.0_f32 / (t19 - 1.0_f32);
    let t21 = v_G_z_per_u_hA * (t16 + t17);
    let t22 = t18 + t21;
    let t23 = 0.28867513_f32 * t22;
    let t24 = t2 * v_G_z_per_u_hA;
    let t25 = 0.8660254_f32 * t24;
    let t26 = t23 + t25;
    let t27 = t20 * (0.8660254_f32 * t26);
    let Ic3 = p.Ic3;
    let k21 = p.k21;
    let t28 = Ic3 + t18 * (t18 * k21);
    let t29 = 1.0_f32 - t21 * t21;
    let t30 = 1.0_f32 / t29;
    let t31 = t25 - t23;
    let t32 = t30 * (0.8660254_f32 * t31);
    let t33 = Ic3 + t21 * (k21 * t21);
    let t34 = 1.0_f32 - t19;
    let t35 = Real::sqrt(t34);
    let t36 = 1.0_f32 / t35;
    let t37 = 0.8660254_f32 * v_G_z_per_u_hA;
    let u_thC_per_w_platform_x = t36 * t37;
    let Ic2 = p.Ic2;
    let Ix = p.Ix;
    let t38 = Real::sqrt(t29);
    let t39 = 1.0_f32 / t38;
    let t40 = t37 * t39;
    let t41 = t32 * (t33 * t32) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t40 * (Ic2 * t40)));
    let t42 = t27 * (t28 * t27) + t41;
    let t43 = w_platform_x_per_w_platform_y * t42;
    let t44 = t30 * (0.5_f32 * t31);
    let t45 = t33 * t44;
    let t46 = 0.5_f32 * v_G_z_per_u_hA;
    let t47 = t39 * t46;
    let t48 = Ic2 * t47;
    let t49 = t36 * t46;
    let t50 = Ic2 * t49;
    let t51 = t20 * (0.5_f32 * t26);
    let t52 = t28 * t51;
    let t53 = t32 * t45 + (t40 * t48 - u_thC_per_w_platform_x * t50) - t27 * t52;
    let t54 = (t43 + t53) * t13;
    let M = p.M;
    let t55 = M * sA;
    let t56 = 2.0_f32 * (t7 - sB - sA);
    let t57 = 1.0_f32 / t56;
    let t58 = t57 * (1.1547005_f32 * t22);
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t30;
    let t59 = t33 * u_psiB_per_w_platform_z;
    let u_thC_per_w_platform_z = t26 * t36;
    let t60 = Ic2 * u_thC_per_w_platform_z;
    let t61 = t31 * t39;
    let t62 = Ic2 * t61;
    let v_G_y_per_u_hA = 0.57735026_f32 * t22;
    let t63 = t24 * t24;
    let t64 = 1.0_f32 - t63;
    let t65 = Real::sqrt(t64);
    let t66 = 1.0_f32 / t65;
    let t67 = v_G_y_per_u_hA * t66;
    let t68 = Ic2 * t67;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t66;
    let t69 = Ic3 + t24 * (k21 * t24);
    let t70 = 1.0_f32 / (t63 - 1.0_f32);
    let t71 = v_G_z_per_u_hA * t70;
    let t72 = t69 * t71;
    let t73 = v_G_y_per_u_hA * t70;
    let t74 = t59 * t44 + (t60 * t49 - (t62 * t47 - t68 * u_thA_per_w_platform_y) - t72 * t73);
    let t75 = v_G_z_per_u_hA * t20;
    let t76 = t28 * t75;
    let t77 = t74 - t76 * t51;
    let t78 = t76 * t27 + (t59 * t32 - (t60 * u_thC_per_w_platform_x + t62 * t40));
    let t79 = t78 * t58;
    let t80 = t54 - (v_G_z_per_u_hA * t55 + t58 * t77) - t79 * w_platform_x_per_w_platform_y;
    let Iy = p.Iy;
    let t81 = t73 * (t69 * t73) + (t49 * t50 + (t47 * t48 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t82 = w_platform_x_per_w_platform_y * (t43 + 2.0_f32 * t53) + (sA * t55 + (t51 * t52 + (t44 * t45 + t81)));
    let t83 = t42 * t13;
    let k18 = p.k18;
    let t84 = k18 * sA;
    let k17 = p.k17;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t85 = k17 * v_G_x_per_w_platform_z;
    let t86 = v_G_y_per_u_hA * (t84 + t85);
    let t87 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t88 = u_psiB_per_w_platform_z * t59 + (t71 * t72 + (u_thC_per_w_platform_z * t60 + (t61 * t62 + (Iz + t67 * t68))));
    let t89 = sA * (t84 + 2.0_f32 * t85) + (v_G_x_per_w_platform_z * t87 + (t75 * t76 + t88));
    let k16 = p.k16;
    let t90 = t58 * (2.0_f32 * t86 + t58 * t89) + (k16 + v_G_y_per_u_hA * (k18 * v_G_y_per_u_hA)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let t91 = t15 * (2.0_f32 * t80 - t82 * t15) + (t13 * (2.0_f32 * t79 - t83) - t90);
    let t92 = 1.0_f32 / t91;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t12;
    let t93 = t82 * w_platform_y_per_u_hB;
    let t94 = 1.7320508_f32 * t24;
    let t95 = v_G_y_per_u_hA - t94;
    let t96 = t57 * t95;
    let t97 = t78 * t96;
    let t98 = w_platform_x_per_w_platform_y * t97 + t77 * t96;
    let t99 = t89 * t96;
    let v_G_x_per_u_hB = 0.57735026_f32 * t95;
    let t100 = k17 * v_G_x_per_u_hB;
    let t101 = sA * t100 + t87 * v_G_x_per_u_hB;
    let t102 = t13 * t97;
    let t103 = t15 * (t93 - t98) - (t86 * t96 + (t58 * (t99 + t101) + v_G_y_per_u_hA * t100) - t102);
    let mass_u_hA_u_hB = t103 - t80 * w_platform_y_per_u_hB;
    let t104 = t92 * mass_u_hA_u_hB;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (t93 - 2.0_f32 * t98) + (t96 * (t99 + 2.0_f32 * t101) + (k16 + v_G_x_per_u_hB * (M * v_G_x_per_u_hB)));
    let pivot_1 = mass_u_hA_u_hB * t104 + mass_u_hB_u_hB;
    let t105 = 1.0_f32 / pivot_1;
    let t106 = t12 * t14;
    let t107 = t82 * t106;
    let t108 = t57 * (v_G_y_per_u_hA + t94);
    let t109 = t78 * t108;
    let t110 = t54 - t77 * t108 - w_platform_x_per_w_platform_y * t109;
    let t111 = t107 - t110;
    let t112 = t89 * t108;
    let mass_u_hA_u_hC = t80 * t106 - (t15 * t111 + (t86 * t108 + t58 * t112)) - t13 * (t83 - t109 - t79);
    let mass_u_hB_u_hC = t98 * t106 - (w_platform_y_per_u_hB * t111 + (t102 - (t101 * t108 + t96 * t112)));
    let t113 = t104 * mass_u_hA_u_hC + mass_u_hB_u_hC;
    let t114 = t105 * t113;
    let w_platform_z = u_hC * t108 - (u_hA * t58 - u_hB * t96);
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * t15 - u_hC * t106;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t13 * (u_hA - u_hC);
    let t115 = w_platform_z * w_platform_x;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.57735026_f32 * v_G_y;
    let t116 = u_hA * t24 + v_G_x;
    let t117 = sA * t115 + 2.0_f32 * (w_platform_y * t116);
    let t118 = 0.8660254_f32 * w_platform_z;
    let t119 = w_platform_y * t118;
    let t120 = 0.5_f32 * w_platform_z;
    let t121 = w_platform_x * t120;
    let t122 = t119 - t121;
    let t123 = 0.5_f32 * w_platform_y;
    let t124 = 0.8660254_f32 * w_platform_x;
    let t125 = t123 + t124;
    let t126 = 2.0_f32 * v_G_x;
    let t127 = 2.0_f32 * t24;
    let u_sB = t126 + (u_hB * t127 - w_platform_z * (1.7320508_f32 * sB));
    let t128 = t119 + t121;
    let t129 = t123 - t124;
    let u_sC = t126 - (w_platform_z * (1.7320508_f32 * t7) - u_hC * t127);
    let t130 = t9 * (t117 - (t7 * t128 + 2.0_f32 * (t129 * u_sC)));
    let w_platform_y_dot_bias = t12 * (t117 - (sB * t122 + 2.0_f32 * (t125 * u_sB)) - t10 * t130);
    let t131 = w_platform_z * t118;
    let t132 = w_platform_x * t129 - t131;
    let t133 = w_platform_z * t120;
    let t134 = t133 + w_platform_y * t125;
    let t135 = w_platform_x * t125 + t131;
    let t136 = 1.7320508_f32 * (2.0_f32 * (t118 * u_sB) - sB * t134) + (sB * t135 + 2.0_f32 * (t120 * u_sB));
    let t137 = t133 + w_platform_y * t129;
    let t138 = w_platform_y * w_platform_x;
    let t139 = 2.0_f32 * (w_platform_z * t116) - sA * t138;
    let t140 = t7 * t132 - t136 + 1.7320508_f32 * (t7 * t137 - 2.0_f32 * (t118 * u_sC)) + 2.0_f32 * (t139 - t120 * u_sC);
    let t141 = t57 * t140;
    let v_G_x_dot_bias = 0.57735026_f32 * t136;
    let g = p.g;
    let t142 = M * (v_G_x_dot_bias - g * t24);
    let t143 = 0.57735026_f32 * t142 - M * (g * v_G_y_per_u_hA) - k18 * t139;
    let u_psiC = t27 * w_platform_x - t51 * w_platform_y - t75 * w_platform_z;
    let t144 = t18 * u_psiC;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t49 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let t145 = 2.0_f32 * (t144 * u_thC);
    let u_psiC_dot_bias = t20 * (t26 * t128 - (t46 * t132 + t37 * t137) - t35 * t145);
    let k11 = p.k11;
    let t146 = t35 * u_psiC;
    let k20 = p.k20;
    let t147 = t28 * u_psiC_dot_bias + (t18 * (k11 * (2.0_f32 * (u_thC * t146))) + t35 * (k20 * t145));
    let t148 = t47 * w_platform_y + t40 * w_platform_x + t61 * w_platform_z;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t44 * w_platform_y + t32 * w_platform_x);
    let t149 = 2.0_f32 * (t148 * u_psiB);
    let t150 = t21 * t149;
    let t151 = t33 * (t30 * (t46 * t135 - t37 * t134 - t31 * t122 + t38 * t150));
    let t152 = t151 + (t21 * (k11 * (t38 * t149)) + t38 * (k20 * t150));
    let u_thA = u_thA_per_w_platform_y * w_platform_y - t67 * w_platform_z;
    let t153 = t71 * w_platform_z + t73 * w_platform_y;
    let t154 = t127 * (u_thA * t153);
    let t155 = t65 * t153;
    let t156 = t69 * (t70 * (v_G_z_per_u_hA * t138 - v_G_y_per_u_hA * t115 - t65 * t154)) + (t24 * (k11 * (2.0_f32 * (u_thA * t155))) + t65 * (k20 * t154));
    let t157 = t144 * t146;
    let t158 = v_G_y_per_u_hA * t132 + t24 * t137 + v_G_z_per_u_hA * t128 + (t18 * (t146 * t146 + u_thC * u_thC) - t35 * t157);
    let t159 = Ic2 * (t36 * t158) - k21 * t157;
    let t160 = t155 * (t24 * t153);
    let t161 = v_G_z_per_u_hA * t115 + t65 * t160 + v_G_y_per_u_hA * t138 + t24 * (w_platform_z * w_platform_z + w_platform_y * w_platform_y - (t155 * t155 + u_thA * u_thA));
    let t162 = Ic2 * (t66 * t161) + k21 * t160;
    let k15 = p.k15;
    let t163 = t38 * u_psiB;
    let t164 = t21 * u_psiB * t163;
    let t165 = v_G_y_per_u_hA * t135 + t24 * t134 - v_G_z_per_u_hA * t122 + (t38 * t164 - t21 * (t163 * t163 + t148 * t148));
    let t166 = Ic2 * (t39 * t165) + k21 * t164;
    let t167 = t71 * t156 + (u_thC_per_w_platform_z * t159 + (t67 * t162 + k15 * t138 - t61 * t166));
    let t168 = sA * t143 - (t85 * t139 - (v_G_x_per_w_platform_z * t142 - (t75 * t147 - (u_psiB_per_w_platform_z * t152 + t167))));
    let t169 = t89 * t141 - t168;
    let FB = inputs[1];
    let c = p.c;
    let k13 = p.k13;
    let t170 = t101 * t141 - (v_G_x_per_u_hB * t142 - (FB - u_hB * c - k13) - t100 * t139);
    let k22 = p.k22;
    let t171 = t27 * t147 + (u_thC_per_w_platform_x * t159 - (t40 * t166 + w_platform_z * w_platform_y * k22) - t32 * t152);
    let t172 = t42 * t130 + (t78 * t141 + t171);
    let t173 = M * (g * v_G_z_per_u_hA - t117);
    let k14 = p.k14;
    let t174 = t73 * t156 - (t49 * t159 + (t47 * t166 + (u_thA_per_w_platform_y * t162 - k14 * t115)));
    let t175 = t53 * t130 + (sA * t173 + (t77 * t141 - (t51 * t147 + (t44 * t152 - t174))));
    let t176 = t82 * w_platform_y_dot_bias + (w_platform_x_per_w_platform_y * t172 + t175);
    let forcing_u_hB = t98 * w_platform_y_dot_bias + (t97 * t130 + (t96 * t169 + t170)) - w_platform_y_per_u_hB * t176;
    let FA = inputs[0];
    let t177 = t58 * t169 + (t86 * t141 + (k13 + (u_hA * c - FA) - v_G_y_per_u_hA * t143));
    let t178 = t13 * t172;
    let t179 = t15 * t176 + (t79 * t130 + (v_G_z_per_u_hA * t173 + t177) - t178 - t80 * w_platform_y_dot_bias);
    let t180 = forcing_u_hB - t104 * t179;
    let FC = inputs[2];
    let t181 = t110 * w_platform_y_dot_bias - (t109 * t130 + (t108 * t169 - (k13 + (u_hC * c - FC))) - t178);
    let forcing_u_hC = t106 * t176 - t181;
    let t182 = t92 * mass_u_hA_u_hC;
    let mass_u_hC_u_hC = k16 + t108 * t112 - t13 * (2.0_f32 * t109 - t83) - t106 * (2.0_f32 * t110 - t107);
    let pivot_2 = mass_u_hA_u_hC * t182 + mass_u_hC_u_hC - t113 * t114;
    let t183 = (t114 * t180 - (forcing_u_hC - t182 * t179)) / pivot_2;
    let t184 = t114 * t183 + t105 * t180;
    let t185 = t104 * t184 + t92 * t179 - t182 * t183;
    let t186 = Real::min(Real::min(Real::min(Real::min(Real::abs(t65), Real::abs(t38)), Real::abs(t35)), Real::abs(t64)), Real::abs(t29));
    let t187 = Real::min(Real::min(Real::min(Real::min(t186, Real::abs(t34)), 0.8333333_f32 * Real::abs(t56)), 5.773503_f32 * Real::abs(t8)), 1.6666666_f32 * Real::abs(t11));
    let t188 = Real::min(Real::min(Real::min(t187, 0.21652833_f32 * Real::abs(t91)), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t185, t184, -t183], t188)
}
///Kinetic and potential energy (J).
///
///236 operations.
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
    let k16 = p.k16;
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let Ic3 = p.Ic3;
    let k19 = p.k19;
    let hB = q[1];
    let hC = q[2];
    let hA = q[0];
    let t1 = k19 * (2.0_f32 * (0.5_f32 * (hB + hC) - hA));
    let t2 = k19 * (1.7320508_f32 * (hB - hC));
    let t3 = t2 * t2;
    let t4 = t1 * t1;
    let root = Real::sqrt(t3 + (1.0_f32 + t4));
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let t5 = t1 * v_G_z_per_u_hA;
    let k21 = p.k21;
    let t6 = t5 * t5;
    let t7 = 1.0_f32 / (t6 - 1.0_f32);
    let R = p.R;
    let t8 = 0.8660254_f32 * (t2 * (2.0_f32 * t1));
    let t9 = 1.0_f32 / (1.0_f32 + root);
    let t10 = R * ((t8 - t3) * t9 - 1.0_f32);
    let sB = R * (1.0_f32 + t9 * (t3 + t8));
    let cos2 = t4 - t3;
    let sA = R * (1.0_f32 + t9 * (0.5_f32 * (t3 + t4) + cos2));
    let t11 = 1.0_f32 / (2.0_f32 * (t10 - sB - sA));
    let t12 = 0.8660254_f32 * t2;
    let t13 = 0.5_f32 * t1;
    let alongC = t12 - t13;
    let t14 = alongC * v_G_z_per_u_hA;
    let t15 = v_G_z_per_u_hA * (t12 + t13);
    let t16 = t14 + t15;
    let v_G_y_per_u_hA = 0.57735026_f32 * t16;
    let t17 = 1.7320508_f32 * t5;
    let t18 = v_G_y_per_u_hA - t17;
    let w_platform_z = u_hC * (t11 * (v_G_y_per_u_hA + t17)) - (u_hA * (t11 * (1.1547005_f32 * t16)) - u_hB * (t11 * t18));
    let t19 = 1.0_f32 / (0.8660254_f32 * t10);
    let w_platform_x_per_w_platform_y = t19 * (0.5_f32 * t10 - sA);
    let t20 = 0.8660254_f32 * sB;
    let t21 = 1.0_f32 / (w_platform_x_per_w_platform_y * t20 + (sA + 0.5_f32 * sB));
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t21;
    let t22 = v_G_z_per_u_hA * t19;
    let t23 = t22 * t20;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * (t21 * (t23 - v_G_z_per_u_hA)) - u_hC * (t21 * t23);
    let t24 = v_G_z_per_u_hA * t7 * w_platform_z + v_G_y_per_u_hA * t7 * w_platform_y;
    let t25 = k16 * (u_hA * u_hA) + (k16 * (u_hB * u_hB) + k16 * (u_hC * u_hC)) + (Ic3 + t5 * (k21 * t5)) * (t24 * t24);
    let Ic2 = p.Ic2;
    let t26 = 1.0_f32 / Real::sqrt(1.0_f32 - t6);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t26;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t26 * w_platform_z;
    let t27 = 1.0_f32 - t15 * t15;
    let t28 = 1.0_f32 / t27;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t28;
    let t29 = 0.8660254_f32 * t5;
    let t30 = 0.28867513_f32 * t16;
    let t31 = t29 - t30;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t22 * (u_hA - u_hC);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t28 * (0.5_f32 * t31) * w_platform_y + t28 * (0.8660254_f32 * t31) * w_platform_x);
    let t32 = t25 + Ic2 * (u_thA * u_thA) + (Ic3 + t15 * (k21 * t15)) * (u_psiB * u_psiB);
    let t33 = 1.0_f32 / Real::sqrt(t27);
    let t34 = 0.5_f32 * v_G_z_per_u_hA;
    let t35 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t36 = t33 * t34 * w_platform_y + t35 * t33 * w_platform_x + t31 * t33 * w_platform_z;
    let t37 = t14 * t14;
    let t38 = 1.0_f32 / (t37 - 1.0_f32);
    let t39 = t30 + t29;
    let u_psiC = t38 * (0.8660254_f32 * t39) * w_platform_x - t38 * (0.5_f32 * t39) * w_platform_y - v_G_z_per_u_hA * t38 * w_platform_z;
    let t40 = t32 + Ic2 * (t36 * t36) + (Ic3 + t14 * (t14 * k21)) * (u_psiC * u_psiC);
    let t41 = 1.0_f32 / Real::sqrt(1.0_f32 - t37);
    let u_thC_per_w_platform_x = t41 * t35;
    let u_thC_per_w_platform_z = t39 * t41;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t41 * t34 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t42 = t40 + Ic2 * (u_thC * u_thC) + Ix * (w_platform_x * w_platform_x) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_x_per_u_hB = 0.57735026_f32 * t18;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.57735026_f32 * v_G_y;
    let t43 = t42 + Iz * (w_platform_z * w_platform_z) + M * (v_G_x * v_G_x) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t44 = 0.5_f32 * (t43 + M * (v_G_z * v_G_z));
    let g = p.g;
    let t45 = hA * g;
    let k12 = p.k12;
    let mc = p.mc;
    let t46 = hB * g;
    let ms = p.ms;
    let t47 = M * (t45 + sA * (g * t5)) + (k12 * (hC * g) + (mc * t46 + (ms * t46 + k12 * t45)));
    (t44, t47)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///178 operations.
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
) -> [S; 12usize] {
    let u_hA = u[0];
    let k19 = p.k19;
    let hB = q[1];
    let hC = q[2];
    let t1 = k19 * (1.7320508_f32 * (hB - hC));
    let t2 = t1 * t1;
    let hA = q[0];
    let t3 = k19 * (2.0_f32 * (0.5_f32 * (hB + hC) - hA));
    let t4 = t3 * t3;
    let root = Real::sqrt(t2 + (1.0_f32 + t4));
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let t5 = t3 * v_G_z_per_u_hA;
    let t6 = t5 * t5;
    let t7 = 1.0_f32 / (t6 - 1.0_f32);
    let u_hC = u[2];
    let R = p.R;
    let t8 = 0.8660254_f32 * (t1 * (2.0_f32 * t3));
    let t9 = 1.0_f32 / (1.0_f32 + root);
    let t10 = R * ((t8 - t2) * t9 - 1.0_f32);
    let sB = R * (1.0_f32 + t9 * (t2 + t8));
    let cos2 = t4 - t2;
    let sA = R * (1.0_f32 + t9 * (0.5_f32 * (t2 + t4) + cos2));
    let t11 = 1.0_f32 / (2.0_f32 * (t10 - sB - sA));
    let t12 = 0.8660254_f32 * t1;
    let t13 = 0.5_f32 * t3;
    let alongC = t12 - t13;
    let t14 = alongC * v_G_z_per_u_hA;
    let t15 = v_G_z_per_u_hA * (t12 + t13);
    let t16 = t14 + t15;
    let v_G_y_per_u_hA = 0.57735026_f32 * t16;
    let t17 = 1.7320508_f32 * t5;
    let u_hB = u[1];
    let t18 = v_G_y_per_u_hA - t17;
    let w_platform_z = u_hC * (t11 * (v_G_y_per_u_hA + t17)) - (u_hA * (t11 * (1.1547005_f32 * t16)) - u_hB * (t11 * t18));
    let t19 = 1.0_f32 / (0.8660254_f32 * t10);
    let w_platform_x_per_w_platform_y = t19 * (0.5_f32 * t10 - sA);
    let t20 = 0.8660254_f32 * sB;
    let t21 = 1.0_f32 / (w_platform_x_per_w_platform_y * t20 + (sA + 0.5_f32 * sB));
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t21;
    let t22 = v_G_z_per_u_hA * t19;
    let t23 = t22 * t20;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * (t21 * (t23 - v_G_z_per_u_hA)) - u_hC * (t21 * t23);
    let t24 = 1.0_f32 / Real::sqrt(1.0_f32 - t6);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t24;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t24 * w_platform_z;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_x_per_u_hB = 0.57735026_f32 * t18;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.57735026_f32 * v_G_y;
    let t25 = 1.0_f32 - t15 * t15;
    let t26 = 1.0_f32 / t25;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t26;
    let t27 = 0.8660254_f32 * t5;
    let t28 = 0.28867513_f32 * t16;
    let t29 = t27 - t28;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t22 * (u_hA - u_hC);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t26 * (0.5_f32 * t29) * w_platform_y + t26 * (0.8660254_f32 * t29) * w_platform_x);
    let t30 = 1.0_f32 / Real::sqrt(t25);
    let t31 = 0.5_f32 * v_G_z_per_u_hA;
    let t32 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t33 = 2.0_f32 * v_G_x;
    let t34 = 2.0_f32 * t5;
    let u_sB = t33 + (u_hB * t34 - w_platform_z * (1.7320508_f32 * sB));
    let t35 = t14 * t14;
    let t36 = 1.0_f32 / (t35 - 1.0_f32);
    let t37 = t28 + t27;
    let u_psiC = t36 * (0.8660254_f32 * t37) * w_platform_x - t36 * (0.5_f32 * t37) * w_platform_y - v_G_z_per_u_hA * t36 * w_platform_z;
    let t38 = 1.0_f32 / Real::sqrt(1.0_f32 - t35);
    let u_thC_per_w_platform_x = t38 * t32;
    let u_thC_per_w_platform_z = t37 * t38;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t38 * t31 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let u_sC = t33 - (w_platform_z * (1.7320508_f32 * t10) - u_hC * t34);
    [u_hA, -(v_G_z_per_u_hA * t7 * w_platform_z + v_G_y_per_u_hA * t7 * w_platform_y), u_thA, -(u_hA * t5 + v_G_x), u_hB, u_psiB, -(t30 * t31 * w_platform_y + t32 * t30 * w_platform_x + t29 * t30 * w_platform_z), u_sB, u_hC, u_psiC, u_thC, u_sC]
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
    let R = p.R;
    let k19 = p.k19;
    let hB = q[1];
    let hC = q[2];
    let t1 = k19 * (1.7320508_f32 * (hB - hC));
    let t2 = t1 * t1;
    let hA = q[0];
    let t3 = k19 * (2.0_f32 * (0.5_f32 * (hB + hC) - hA));
    let t4 = t3 * t3;
    let root = Real::sqrt(t2 + (1.0_f32 + t4));
    let t5 = 1.0_f32 + root;
    let t6 = 1.0_f32 / t5;
    let cos2 = t4 - t2;
    let sA = R * (1.0_f32 + t6 * (0.5_f32 * (t2 + t4) + cos2));
    let v_G_z_per_u_hA = 1.0_f32 / root;
    let t7 = t3 * v_G_z_per_u_hA;
    let t8 = sA * Real::sqrt(1.0_f32 - t7 * t7);
    let k = 1.0_f32 / (root * t5);
    let psiA = Real::atan2(t1 * (t3 * k), 1.0_f32 - t4 * k);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t9 = t8 * sin_psiA;
    let t10 = R - t8 * cos_psiA;
    let t11 = hA + t7 * sA;
    let thA = Real::asin(t7);
    let t12 = 0.8660254_f32 * t1;
    let t13 = 0.5_f32 * t3;
    let t14 = t12 + t13;
    let t15 = 0.5_f32 * t1;
    let t16 = 0.8660254_f32 * t3;
    let acrossB = t15 - t16;
    let psiB = Real::atan2(t14 * k * acrossB, 1.0_f32 - k * (t14 * t14));
    let t17 = 0.8660254_f32 * (t1 * (2.0_f32 * t3));
    let sB = R * (1.0_f32 + t6 * (t2 + t17));
    let alongC = t12 - t13;
    let acrossC = t16 + t15;
    let psiC = Real::atan2(-alongC * k * acrossC, 1.0_f32 - k * (alongC * alongC));
    let thC = Real::asin(alongC * v_G_z_per_u_hA);
    [t9, t10, t11, psiA, thA, sA, psiB, -Real::asin(v_G_z_per_u_hA * t14), sB, psiC, thC, -R * ((t17 - t2) * t6 - 1.0_f32)]
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
