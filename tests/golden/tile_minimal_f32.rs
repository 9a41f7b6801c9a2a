// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 706 operations (12 abs, 141 add, 14 div, 11 min, 414 mul, 4 sqrt, 110 sub).
// Cost of energy: 231 operations (45 add, 11 div, 144 mul, 4 sqrt, 27 sub).
// Cost of speeds: 169 operations (24 add, 11 div, 100 mul, 4 sqrt, 30 sub).
// Cost of outputs: 79 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 42 mul, 1 sin, 2 sqrt, 12 sub).
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
///706 operations.
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
    let u_sB_per_u_hB = v_G_z_per_u_hA * (t16 + t17);
    let t21 = t18 + u_sB_per_u_hB;
    let t22 = 0.28867513_f32 * t21;
    let t23 = t2 * v_G_z_per_u_hA;
    let t24 = 0.8660254_f32 * t23;
    let t25 = t22 + t24;
    let t26 = t20 * (0.8660254_f32 * t25);
    let Ic3 = p.Ic3;
    let k21 = p.k21;
    let t27 = Ic3 + t18 * (t18 * k21);
    let t28 = 1.0_f32 - u_sB_per_u_hB * u_sB_per_u_hB;
    let t29 = 1.0_f32 / t28;
    let t30 = t24 - t22;
    let t31 = t29 * (0.8660254_f32 * t30);
    let t32 = Ic3 + u_sB_per_u_hB * (k21 * u_sB_per_u_hB);
    let t33 = 1.0_f32 - t19;
    let t34 = Real::sqrt(t33);
    let t35 = 1.0_f32 / t34;
    let t36 = 0.8660254_f32 * v_G_z_per_u_hA;
    let u_thC_per_w_platform_x = t35 * t36;
    let Ic2 = p.Ic2;
    let Ix = p.Ix;
    let t37 = Real::sqrt(t28);
    let t38 = 1.0_f32 / t37;
    let t39 = t36 * t38;
    let t40 = t31 * (t32 * t31) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t39 * (Ic2 * t39)));
    let t41 = t26 * (t27 * t26) + t40;
    let t42 = w_platform_x_per_w_platform_y * t41;
    let t43 = t29 * (0.5_f32 * t30);
    let t44 = t32 * t43;
    let t45 = 0.5_f32 * v_G_z_per_u_hA;
    let t46 = t38 * t45;
    let t47 = Ic2 * t46;
    let t48 = t35 * t45;
    let t49 = Ic2 * t48;
    let t50 = t20 * (0.5_f32 * t25);
    let t51 = t27 * t50;
    let t52 = t31 * t44 + (t39 * t47 - u_thC_per_w_platform_x * t49) - t26 * t51;
    let t53 = (t42 + t52) * t13;
    let M = p.M;
    let t54 = M * sA;
    let v_G_y_per_u_hA = 0.57735026_f32 * t21;
    let t55 = t7 - sB;
    let t56 = 1.0_f32 / (t55 - sA);
    let t57 = v_G_y_per_u_hA * t56;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t29;
    let t58 = t32 * u_psiB_per_w_platform_z;
    let u_thC_per_w_platform_z = t25 * t35;
    let t59 = Ic2 * u_thC_per_w_platform_z;
    let t60 = t30 * t38;
    let t61 = Ic2 * t60;
    let t62 = t23 * t23;
    let t63 = 1.0_f32 - t62;
    let t64 = Real::sqrt(t63);
    let t65 = 1.0_f32 / t64;
    let t66 = v_G_y_per_u_hA * t65;
    let t67 = Ic2 * t66;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t65;
    let t68 = Ic3 + t23 * (k21 * t23);
    let t69 = 1.0_f32 / (t62 - 1.0_f32);
    let t70 = v_G_z_per_u_hA * t69;
    let t71 = t68 * t70;
    let t72 = v_G_y_per_u_hA * t69;
    let t73 = t58 * t43 + (t59 * t48 - (t61 * t46 - t67 * u_thA_per_w_platform_y) - t71 * t72);
    let t74 = v_G_z_per_u_hA * t20;
    let t75 = t27 * t74;
    let t76 = t73 - t75 * t50;
    let t77 = t75 * t26 + (t58 * t31 - (t59 * u_thC_per_w_platform_x + t61 * t39));
    let t78 = t77 * t57;
    let t79 = t53 - (v_G_z_per_u_hA * t54 + t57 * t76) - t78 * w_platform_x_per_w_platform_y;
    let Iy = p.Iy;
    let t80 = t72 * (t68 * t72) + (t48 * t49 + (t46 * t47 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t81 = w_platform_x_per_w_platform_y * (t42 + 2.0_f32 * t52) + (sA * t54 + (t50 * t51 + (t43 * t44 + t80)));
    let t82 = t41 * t13;
    let k18 = p.k18;
    let t83 = k18 * sA;
    let k17 = p.k17;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let t84 = k17 * v_G_x_per_w_platform_z;
    let t85 = v_G_y_per_u_hA * (t83 + t84);
    let t86 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t87 = u_psiB_per_w_platform_z * t58 + (t70 * t71 + (u_thC_per_w_platform_z * t59 + (t60 * t61 + (Iz + t66 * t67))));
    let t88 = sA * (t83 + 2.0_f32 * t84) + (v_G_x_per_w_platform_z * t86 + (t74 * t75 + t87));
    let k16 = p.k16;
    let t89 = t57 * (2.0_f32 * t85 + t57 * t88) + (k16 + v_G_y_per_u_hA * (k18 * v_G_y_per_u_hA)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let t90 = t15 * (2.0_f32 * t79 - t81 * t15) + (t13 * (2.0_f32 * t78 - t82) - t89);
    let t91 = 1.0_f32 / t90;
    let t92 = t12 * t14;
    let t93 = t81 * t92;
    let t94 = t25 * t56;
    let t95 = t77 * t94;
    let t96 = t53 - t76 * t94 - w_platform_x_per_w_platform_y * t95;
    let t97 = t93 - t96;
    let t98 = t88 * t94;
    let mass_u_hA_u_hC = t79 * t92 - (t15 * t97 + (t85 * t94 + t57 * t98)) - t13 * (t82 - t95 - t78);
    let t99 = t91 * mass_u_hA_u_hC;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t12;
    let t100 = t81 * w_platform_y_per_u_hB;
    let t101 = t30 * t56;
    let t102 = t77 * t101;
    let t103 = w_platform_x_per_w_platform_y * t102 + t76 * t101;
    let t104 = t13 * t102;
    let t105 = t88 * t101;
    let t106 = 1.1547005_f32 * t30;
    let t107 = k17 * t106;
    let t108 = sA * t107 + t86 * t106;
    let t109 = t15 * (t100 + t103) - (t104 - (t85 * t101 + (t57 * (t105 + t108) + v_G_y_per_u_hA * t107)));
    let mass_u_hA_u_hB = t109 - t79 * w_platform_y_per_u_hB;
    let t110 = t91 * mass_u_hA_u_hB;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (t100 + 2.0_f32 * t103) + (t101 * (t105 + 2.0_f32 * t108) + (k16 + t106 * (M * t106)));
    let pivot_1 = mass_u_hA_u_hB * t110 + mass_u_hB_u_hB;
    let t111 = 1.0_f32 / pivot_1;
    let t112 = t103 * t92 + (w_platform_y_per_u_hB * t97 + (t108 * t94 + t101 * t98 - t104)) - t110 * mass_u_hA_u_hC;
    let t113 = t111 * t112;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * t15 - u_hC * t92;
    let w_platform_z = u_hC * t94 - (u_hB * t101 + u_hA * t57);
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t114 = u_hB * t106 - v_G_x_per_w_platform_z * w_platform_z + 0.57735026_f32 * v_G_y;
    let u_sA = t114 - u_hA * t23;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t13 * (u_hA - u_hC);
    let t115 = w_platform_z * w_platform_x;
    let v_G_z_dot_bias = 2.0_f32 * (w_platform_y * u_sA) - sA * t115;
    let t116 = 0.8660254_f32 * w_platform_y;
    let t117 = 0.5_f32 * w_platform_x;
    let t118 = t116 + t117;
    let t119 = w_platform_z * t118;
    let t120 = 0.5_f32 * w_platform_y;
    let t121 = 0.8660254_f32 * w_platform_x;
    let t122 = t120 - t121;
    let t123 = 0.8660254_f32 * v_G_y;
    let t124 = 0.5_f32 * t114;
    let u_sC = t123 - (t124 + u_hC * t18);
    let t125 = t9 * (v_G_z_dot_bias + (t7 * t119 + 2.0_f32 * (t122 * u_sC)));
    let t126 = t117 - t116;
    let t127 = t120 + t121;
    let t128 = t126 * t127;
    let t129 = t123 + (t124 - u_hB * u_sB_per_u_hB);
    let t130 = sB * t128 - 2.0_f32 * (w_platform_z * t129);
    let t131 = t118 * t122;
    let t132 = w_platform_y * w_platform_x;
    let t133 = sA * t132 + 2.0_f32 * (w_platform_z * u_sA);
    let w_platform_z_dot_bias = t56 * (t130 - (t7 * t131 - 2.0_f32 * (w_platform_z * u_sC)) + t133);
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t48 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let u_psiC = t26 * w_platform_x - t50 * w_platform_y - t74 * w_platform_z;
    let t134 = 2.0_f32 * (u_thC * u_psiC);
    let t135 = t18 * t134;
    let u_psiC_dot_bias = t20 * (t25 * t119 - v_G_z_per_u_hA * t131 - t34 * t135);
    let k11 = p.k11;
    let k20 = p.k20;
    let t136 = t27 * u_psiC_dot_bias + (t18 * (k11 * (t34 * t134)) + t34 * (k20 * t135));
    let t137 = w_platform_z * t126;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t43 * w_platform_y + t31 * w_platform_x);
    let t138 = u_sB_per_u_hB * u_psiB;
    let t139 = t37 * u_psiB;
    let t140 = t138 * t139;
    let t141 = t46 * w_platform_y + t39 * w_platform_x + t60 * w_platform_z;
    let t142 = w_platform_z * w_platform_z;
    let t143 = t30 * t128 - (v_G_z_per_u_hA * t137 + t37 * t140) + u_sB_per_u_hB * (t139 * t139 + t141 * t141 - (t142 + t127 * t127));
    let t144 = Ic2 * (t38 * t143) - k21 * t140;
    let k22 = p.k22;
    let t145 = t34 * u_psiC;
    let t146 = t18 * u_psiC * t145;
    let t147 = t18 * (t122 * t122 + t142 - (t145 * t145 + u_thC * u_thC)) - (v_G_z_per_u_hA * t119 - t34 * t146 + t25 * t131);
    let t148 = Ic2 * (t35 * t147) + k21 * t146;
    let t149 = 2.0_f32 * t138 * t141;
    let t150 = t32 * (t29 * (t30 * t137 + v_G_z_per_u_hA * t128 + t37 * t149)) + (u_sB_per_u_hB * (k11 * (t141 * (2.0_f32 * t139))) + t37 * (k20 * t149));
    let t151 = t26 * t136 + (t39 * t144 - w_platform_z * w_platform_y * k22 - u_thC_per_w_platform_x * t148 - t31 * t150);
    let t152 = t41 * t125 + (t77 * w_platform_z_dot_bias - t151);
    let u_thA = u_thA_per_w_platform_y * w_platform_y - t66 * w_platform_z;
    let t153 = t70 * w_platform_z + t72 * w_platform_y;
    let t154 = 2.0_f32 * (u_thA * t153);
    let t155 = t23 * t154;
    let t156 = t68 * (t69 * (v_G_z_per_u_hA * t132 - v_G_y_per_u_hA * t115 - t64 * t155)) + (t23 * (k11 * (t64 * t154)) + t64 * (k20 * t155));
    let t157 = t64 * t153;
    let t158 = t23 * t153 * t157;
    let t159 = v_G_z_per_u_hA * t115 + t64 * t158 + v_G_y_per_u_hA * t132 + t23 * (t142 + w_platform_y * w_platform_y - (t157 * t157 + u_thA * u_thA));
    let t160 = Ic2 * (t65 * t159) + k21 * t158;
    let k14 = p.k14;
    let t161 = t72 * t156 + (t48 * t148 - (u_thA_per_w_platform_y * t160 - k14 * t115 - t46 * t144));
    let g = p.g;
    let t162 = M * (v_G_z_dot_bias + g * v_G_z_per_u_hA);
    let t163 = t52 * t125 + (t76 * w_platform_z_dot_bias + (t50 * t136 + (t43 * t150 - t161)) - sA * t162);
    let w_platform_y_dot_bias = t12 * (t10 * t125 + (sB * t137 + 2.0_f32 * (t127 * t129) - v_G_z_dot_bias));
    let t164 = w_platform_x_per_w_platform_y * t152 + t163 - t81 * w_platform_y_dot_bias;
    let t165 = t13 * t152;
    let t166 = M * (1.1547005_f32 * t130 - g * t23);
    let t167 = k18 * t133 + (0.57735026_f32 * t166 - M * (g * v_G_y_per_u_hA));
    let k15 = p.k15;
    let t168 = t70 * t156 + (t60 * t144 + (t66 * t160 + k15 * t132) - u_thC_per_w_platform_z * t148);
    let t169 = sA * t167 + (t84 * t133 + (v_G_x_per_w_platform_z * t166 - (t74 * t136 - (u_psiB_per_w_platform_z * t150 + t168))));
    let t170 = t88 * w_platform_z_dot_bias + t169;
    let k13 = p.k13;
    let c = p.c;
    let FA = inputs[0];
    let t171 = t57 * t170 + (t85 * w_platform_z_dot_bias - (k13 + (u_hA * c - FA) - v_G_y_per_u_hA * t167));
    let forcing_u_hA = t15 * t164 - (t165 - (t78 * t125 - (v_G_z_per_u_hA * t162 - t171)) - t79 * w_platform_y_dot_bias);
    let FB = inputs[1];
    let t172 = t108 * w_platform_z_dot_bias + (t107 * t133 + (FB - u_hB * c - k13 + t106 * t166));
    let forcing_u_hB = w_platform_y_per_u_hB * t164 + (t102 * t125 + (t101 * t170 + t172) - t103 * w_platform_y_dot_bias);
    let t173 = t110 * forcing_u_hA + forcing_u_hB;
    let FC = inputs[2];
    let t174 = t96 * w_platform_y_dot_bias - (t165 - (t95 * t125 + (t94 * t170 + (k13 + (u_hC * c - FC)))));
    let mass_u_hC_u_hC = k16 + t94 * t98 - t13 * (2.0_f32 * t95 - t82) - t92 * (2.0_f32 * t96 - t93);
    let pivot_2 = mass_u_hA_u_hC * t99 + mass_u_hC_u_hC - t112 * t113;
    let t175 = (t113 * t173 + (t99 * forcing_u_hA - (t92 * t164 + t174))) / pivot_2;
    let t176 = t113 * t175 + t111 * t173;
    let t177 = t99 * t175 - (t91 * forcing_u_hA - t110 * t176);
    let t178 = Real::min(Real::min(Real::min(Real::min(Real::abs(t64), Real::abs(t37)), Real::abs(t34)), Real::abs(t63)), Real::abs(t28));
    let t179 = Real::min(Real::min(Real::min(t178, Real::abs(t33)), 1.6666666_f32 * Real::min(Real::abs(sA - t55), Real::abs(t11))), 5.773503_f32 * Real::abs(t8));
    let t180 = Real::min(Real::min(Real::min(t179, 0.21652833_f32 * Real::abs(t90)), 0.21680787_f32 * Real::abs(pivot_1)), 0.21706869_f32 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t177, t176, t175], t180)
}
///Kinetic and potential energy (J).
///
///231 operations.
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
    let t8 = 0.8660254_f32 * t2;
    let t9 = 0.5_f32 * t1;
    let alongC = t8 - t9;
    let t10 = alongC * v_G_z_per_u_hA;
    let u_sB_per_u_hB = v_G_z_per_u_hA * (t8 + t9);
    let t11 = t10 + u_sB_per_u_hB;
    let t12 = 0.28867513_f32 * t11;
    let t13 = 0.8660254_f32 * t5;
    let t14 = t12 + t13;
    let R = p.R;
    let t15 = 0.8660254_f32 * (t2 * (2.0_f32 * t1));
    let t16 = 1.0_f32 / (1.0_f32 + root);
    let t17 = R * ((t15 - t3) * t16 - 1.0_f32);
    let sB = R * (1.0_f32 + t16 * (t3 + t15));
    let cos2 = t4 - t3;
    let sA = R * (1.0_f32 + t16 * (0.5_f32 * (t3 + t4) + cos2));
    let t18 = 1.0_f32 / (t17 - sB - sA);
    let t19 = t13 - t12;
    let v_G_y_per_u_hA = 0.57735026_f32 * t11;
    let w_platform_z = u_hC * (t14 * t18) - (u_hB * (t19 * t18) + u_hA * (v_G_y_per_u_hA * t18));
    let t20 = 1.0_f32 / (0.8660254_f32 * t17);
    let w_platform_x_per_w_platform_y = t20 * (0.5_f32 * t17 - sA);
    let t21 = 0.8660254_f32 * sB;
    let t22 = 1.0_f32 / (w_platform_x_per_w_platform_y * t21 + (sA + 0.5_f32 * sB));
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t22;
    let t23 = v_G_z_per_u_hA * t20;
    let t24 = t23 * t21;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * (t22 * (t24 - v_G_z_per_u_hA)) - u_hC * (t22 * t24);
    let t25 = v_G_z_per_u_hA * t7 * w_platform_z + v_G_y_per_u_hA * t7 * w_platform_y;
    let t26 = k16 * (u_hA * u_hA) + (k16 * (u_hB * u_hB) + k16 * (u_hC * u_hC)) + (Ic3 + t5 * (k21 * t5)) * (t25 * t25);
    let Ic2 = p.Ic2;
    let t27 = 1.0_f32 / Real::sqrt(1.0_f32 - t6);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t27;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t27 * w_platform_z;
    let t28 = 1.0_f32 - u_sB_per_u_hB * u_sB_per_u_hB;
    let t29 = 1.0_f32 / t28;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t29;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t23 * (u_hA - u_hC);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t29 * (0.5_f32 * t19) * w_platform_y + t29 * (0.8660254_f32 * t19) * w_platform_x);
    let t30 = t26 + Ic2 * (u_thA * u_thA) + (Ic3 + u_sB_per_u_hB * (k21 * u_sB_per_u_hB)) * (u_psiB * u_psiB);
    let t31 = 1.0_f32 / Real::sqrt(t28);
    let t32 = 0.5_f32 * v_G_z_per_u_hA;
    let t33 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t34 = t31 * t32 * w_platform_y + t33 * t31 * w_platform_x + t19 * t31 * w_platform_z;
    let t35 = t10 * t10;
    let t36 = 1.0_f32 / (t35 - 1.0_f32);
    let u_psiC = t36 * (0.8660254_f32 * t14) * w_platform_x - t36 * (0.5_f32 * t14) * w_platform_y - v_G_z_per_u_hA * t36 * w_platform_z;
    let t37 = t30 + Ic2 * (t34 * t34) + (Ic3 + t10 * (t10 * k21)) * (u_psiC * u_psiC);
    let t38 = 1.0_f32 / Real::sqrt(1.0_f32 - t35);
    let u_thC_per_w_platform_x = t38 * t33;
    let u_thC_per_w_platform_z = t14 * t38;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t38 * t32 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t39 = t37 + Ic2 * (u_thC * u_thC) + Ix * (w_platform_x * w_platform_x) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t40 = u_hB * (1.1547005_f32 * t19) - v_G_x_per_w_platform_z * w_platform_z + 0.57735026_f32 * v_G_y;
    let t41 = t39 + Iz * (w_platform_z * w_platform_z) + M * (t40 * t40) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t42 = 0.5_f32 * (t41 + M * (v_G_z * v_G_z));
    let g = p.g;
    let t43 = hA * g;
    let k12 = p.k12;
    let mc = p.mc;
    let t44 = hB * g;
    let ms = p.ms;
    let t45 = M * (t43 + t5 * (g * sA)) + (k12 * (hC * g) + (mc * t44 + (ms * t44 + k12 * t43)));
    (t42, t45)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///169 operations.
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
    let t8 = 0.8660254_f32 * t1;
    let t9 = 0.5_f32 * t3;
    let alongC = t8 - t9;
    let t10 = alongC * v_G_z_per_u_hA;
    let u_sB_per_u_hB = v_G_z_per_u_hA * (t8 + t9);
    let t11 = t10 + u_sB_per_u_hB;
    let t12 = 0.28867513_f32 * t11;
    let t13 = 0.8660254_f32 * t5;
    let t14 = t12 + t13;
    let R = p.R;
    let t15 = 0.8660254_f32 * (t1 * (2.0_f32 * t3));
    let t16 = 1.0_f32 / (1.0_f32 + root);
    let t17 = R * ((t15 - t2) * t16 - 1.0_f32);
    let sB = R * (1.0_f32 + t16 * (t2 + t15));
    let cos2 = t4 - t2;
    let sA = R * (1.0_f32 + t16 * (0.5_f32 * (t2 + t4) + cos2));
    let t18 = 1.0_f32 / (t17 - sB - sA);
    let u_hB = u[1];
    let t19 = t13 - t12;
    let v_G_y_per_u_hA = 0.57735026_f32 * t11;
    let w_platform_z = u_hC * (t14 * t18) - (u_hB * (t19 * t18) + u_hA * (v_G_y_per_u_hA * t18));
    let t20 = 1.0_f32 / (0.8660254_f32 * t17);
    let w_platform_x_per_w_platform_y = t20 * (0.5_f32 * t17 - sA);
    let t21 = 0.8660254_f32 * sB;
    let t22 = 1.0_f32 / (w_platform_x_per_w_platform_y * t21 + (sA + 0.5_f32 * sB));
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t22;
    let t23 = v_G_z_per_u_hA * t20;
    let t24 = t23 * t21;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * (t22 * (t24 - v_G_z_per_u_hA)) - u_hC * (t22 * t24);
    let t25 = 1.0_f32 / Real::sqrt(1.0_f32 - t6);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t25;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t25 * w_platform_z;
    let v_G_x_per_w_platform_z = 1.1547005_f32 * sB;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t26 = u_hB * (1.1547005_f32 * t19) - v_G_x_per_w_platform_z * w_platform_z + 0.57735026_f32 * v_G_y;
    let u_sA = t26 - u_hA * t5;
    let t27 = 1.0_f32 - u_sB_per_u_hB * u_sB_per_u_hB;
    let t28 = 1.0_f32 / t27;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t28;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t23 * (u_hA - u_hC);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t28 * (0.5_f32 * t19) * w_platform_y + t28 * (0.8660254_f32 * t19) * w_platform_x);
    let t29 = 1.0_f32 / Real::sqrt(t27);
    let t30 = 0.5_f32 * v_G_z_per_u_hA;
    let t31 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t32 = 0.8660254_f32 * v_G_y;
    let t33 = 0.5_f32 * t26;
    let t34 = t10 * t10;
    let t35 = 1.0_f32 / (t34 - 1.0_f32);
    let u_psiC = t35 * (0.8660254_f32 * t14) * w_platform_x - t35 * (0.5_f32 * t14) * w_platform_y - v_G_z_per_u_hA * t35 * w_platform_z;
    let t36 = 1.0_f32 / Real::sqrt(1.0_f32 - t34);
    let u_thC_per_w_platform_x = t36 * t31;
    let u_thC_per_w_platform_z = t14 * t36;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t36 * t30 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let u_sC = t32 - (t33 + u_hC * t10);
    [u_hA, -(v_G_z_per_u_hA * t7 * w_platform_z + v_G_y_per_u_hA * t7 * w_platform_y), u_thA, u_sA, u_hB, u_psiB, -(t29 * t30 * w_platform_y + t31 * t29 * w_platform_x + t19 * t29 * w_platform_z), -(t32 + (t33 - u_hB * u_sB_per_u_hB)), u_hC, u_psiC, u_thC, u_sC]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///79 operations.
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
    let t8 = Real::sqrt(1.0_f32 - t7 * t7);
    let k = 1.0_f32 / (root * t5);
    let psiA = Real::atan2(t1 * (t3 * k), 1.0_f32 - t4 * k);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t9 = sA * (t8 * sin_psiA);
    let t10 = R - sA * (t8 * cos_psiA);
    let t11 = hA + t7 * sA;
    let thA = Real::asin(t7);
    let t12 = 0.8660254_f32 * t1;
    let t13 = 0.5_f32 * t3;
    let t14 = t12 + t13;
    let t15 = 0.5_f32 * t1;
    let t16 = 0.8660254_f32 * t3;
    let acrossB = t15 - t16;
    let psiB = Real::atan2(t14 * k * acrossB, 1.0_f32 - k * (t14 * t14));
    let u_sB_per_u_hB = v_G_z_per_u_hA * t14;
    let t17 = 0.8660254_f32 * (t1 * (2.0_f32 * t3));
    let sB = R * (1.0_f32 + t6 * (t2 + t17));
    let alongC = t12 - t13;
    let acrossC = t16 + t15;
    let psiC = Real::atan2(-alongC * k * acrossC, 1.0_f32 - k * (alongC * alongC));
    let thC = Real::asin(alongC * v_G_z_per_u_hA);
    [t9, t10, t11, psiA, thA, sA, psiB, -Real::asin(u_sB_per_u_hB), sB, psiC, thC, -R * ((t17 - t2) * t6 - 1.0_f32)]
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
