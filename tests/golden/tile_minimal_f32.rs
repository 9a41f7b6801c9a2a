// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f32.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 550 operations (6 abs, 92 add, 13 div, 8 min, 334 mul, 4 sqrt, 93 sub).
// Cost of energy: 185 operations (40 add, 7 div, 118 mul, 1 sqrt, 19 sub).
// Cost of speeds: 180 operations (31 add, 10 div, 112 mul, 4 sqrt, 23 sub).
// Cost of outputs: 78 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 42 mul, 1 sin, 2 sqrt, 11 sub).
// Cost of projection: 0 operations ().
// Cost of prepare: 282 operations (17 abs, 78 add, 18 div, 9 max, 154 mul, 1 sqrt, 5 sub).

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
    ///Of parameters alone.
    pub k27: S,
    ///Of parameters alone.
    pub k28: S,
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///282 operations.
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
    let t6 = 0.8660254_f32 * t4 + 0.5_f32 * t5;
    let t7 = t4 * t4;
    let t8 = t7 + t5 * t5;
    let t9 = t7 + 0.8660254_f32 * (t4 * (2.0_f32 * t5));
    let t10 = Real::sqrt(1.0_f32 + t8);
    let t11 = 1.5_f32 * t8;
    let t12 = 1.0_f32 + t10;
    let t13 = 1.0_f32 / t12;
    let t14 = 1.0_f32 + t11 * t13;
    let t15 = t1 * (1.0_f32 + t9 * t13);
    let t16 = 0.8660254_f32 * t15;
    let t17 = 0.5_f32 * t15;
    let t18 = t1 * t14;
    let t19 = t18 + t17;
    let t20 = 1.0_f32 / t16;
    let t21 = t20 * t19;
    let t22 = t19 + t16 * t21;
    let t23 = 1.0_f32 / t10;
    let t24 = t4 * t13;
    let t25 = t5 * t13;
    let t26 = t5 * t23;
    let t27 = t6 * t23;
    let t28 = 0.57735026_f32 * t27 + 0.8660254_f32 * t26;
    let ms = p.ms;
    let mc = p.mc;
    let t29 = Real::abs(ms) + Real::abs(mc);
    let mr = p.mr;
    let t30 = Real::abs(mr) + t29;
    let M = p.M;
    let t31 = Real::abs(M);
    let t32 = t1 * t31 * t14;
    let t33 = 1.3333334_f32 * (0.4330127_f32 * t18 + t16);
    let t34 = 1.1547005_f32 * t27;
    let t35 = 0.6666667_f32 * t27;
    let t36 = t31 * t33;
    let t37 = t36 * t35 + t34 * t32;
    let t38 = t37 * t25;
    let t39 = t37 * t24;
    let t40 = t38 * t21 + t39;
    let t41 = t35 * (t31 * t35) + t34 * (t31 * t34);
    let t42 = 1.0_f32 + t26 * t26;
    let t43 = 1.0_f32 + t27 * t27;
    let t44 = t23 * t20;
    let t45 = 1.0_f32 / t42;
    let t46 = t34 * t45;
    let t47 = t23 * t45;
    let t48 = 1.0_f32 / t43;
    let t49 = t48 * (0.5_f32 * t28);
    let t50 = t48 * (0.8660254_f32 * t28);
    let t51 = t23 * t48;
    let t52 = 1.0_f32 / t22;
    let t53 = t16 * t44;
    let t54 = t52 * (t23 + t53);
    let t55 = t52 * t53;
    let t56 = t23 * t52;
    let t57 = t18 * t32;
    let t58 = t23 * t32;
    let t59 = t23 * (t31 * t23);
    let t60 = 1.1547005_f32 * t28;
    let t61 = t33 * t36;
    let t62 = t36 * t60;
    let t63 = t31 * t60;
    let t64 = t35 * t63;
    let t65 = t60 * t63;
    let t66 = t25 * t62;
    let t67 = t24 * t62;
    let t68 = t21 * t66 + t67;
    let Iz = p.Iz;
    let Ic2 = p.Ic2;
    let t69 = Iz + 3.0_f32 * Ic2;
    let t70 = Real::abs(Iz);
    let t71 = Real::abs(Ic2);
    let t72 = t70 + 3.0_f32 * t71;
    let Ic3 = p.Ic3;
    let t73 = t71 + Real::abs(Ic3);
    let Ic1 = p.Ic1;
    let t74 = Real::abs(Ic1) + t73;
    let t75 = t26 * (t74 * t26);
    let t76 = t27 * (t74 * t27);
    let t77 = t73 + t75;
    let t78 = t73 + t76;
    let t79 = t77 * t47;
    let t80 = t47 * t79;
    let t81 = t79 * t46;
    let t82 = t46 * (t77 * t46);
    let t83 = t78 * t51;
    let t84 = t61 + (t57 + (t72 + (t80 + 2.0_f32 * (t51 * t83))));
    let t85 = t81 + 2.0_f32 * (t83 * t49);
    let t86 = t84 * t24;
    let t87 = t86 + t85;
    let t88 = t86 + 2.0_f32 * t85;
    let t89 = t83 * t50;
    let t90 = t24 * t88;
    let t91 = 2.0_f32 * t89 * t24;
    let t92 = t25 * t84;
    let t93 = 4.0_f32 * t89 + t92;
    let t94 = t25 * t87;
    let t95 = t25 * t93;
    let t96 = t78 * t49;
    let t97 = t50 * (t78 * t50);
    let t98 = t50 * t96;
    let t99 = t49 * t96;
    let t100 = t94 + (t91 + 2.0_f32 * t98);
    let t101 = t95 + 2.0_f32 * t97;
    let t102 = t90 + (t82 + 2.0_f32 * t99);
    let t103 = 1.5_f32 * t71;
    let Ix = p.Ix;
    let t104 = Real::abs(Ix) + t103 + t101;
    let t105 = Ic3 - Ic2;
    let t106 = 1.5_f32 * Ic2;
    let t107 = Ix + t106;
    let Iy = p.Iy;
    let t108 = Iy + t106;
    let t109 = t57 + (Real::abs(Iy) + t103 + t102);
    let t110 = 2.0_f32 * t100;
    let t111 = t21 * t104;
    let t112 = t111 + t100;
    let t113 = t21 * (t111 + t110) + t109;
    let t114 = t112 * t44;
    let t115 = t58 + (t114 + t40);
    let t116 = t114 + t68;
    let t117 = t30 + t41;
    let t118 = t104 * t44;
    let t119 = t59 + (t44 * (2.0_f32 * t38 + t118) + t117);
    let t120 = t38 + t66;
    let t121 = 2.0_f32 * t66;
    let t122 = t118 + t120;
    let t123 = t118 + t121;
    let t124 = t44 * t122;
    let t125 = t44 * t123 + t65;
    let t126 = t54 * (2.0_f32 * t115 + t113 * t54) + t119;
    let t127 = t113 * t55;
    let t128 = t54 * (t127 + t116) + t64 + t115 * t55 + t124;
    let t129 = t113 * t56;
    let t130 = t54 * t129;
    let t131 = t115 * t56 + t130;
    let t132 = 1.0_f32 / t126;
    let t133 = t132 * t128;
    let t134 = t128 * t133;
    let t135 = t133 * t131;
    let t136 = t131 * (t132 * t131);
    let t137 = t127 + 2.0_f32 * t116;
    let t138 = t30 + t125;
    let t139 = t134 + (t55 * t137 + t138);
    let t140 = t135 + (t116 * t56 + t55 * t129);
    let t141 = t136 + (t30 + t56 * t129);
    let t142 = t140 * (1.0_f32 / t139 * t140) + t141;
    let t143 = 1.0_f32 / (3.0_f32 * R);
    let t144 = 1.0_f32 / Real::max(0.6393147_f32 * t42, 1e-24_f32);
    let t145 = 1.0_f32 / Real::max(0.53148425_f32 * t43, 1e-24_f32);
    let t146 = 0.5_f32 / Real::max(0.1012588_f32 * Real::abs(t12), 1e-24_f32);
    let t147 = 5.773503_f32 / Real::max(0.5189255_f32 * Real::abs(t16), 1e-24_f32);
    let t148 = 1.6666666_f32 / Real::max(0.13604356_f32 * Real::abs(t22), 1e-24_f32);
    let g = p.g;
    let t149 = ms * g;
    let t150 = ms + mc;
    let t151 = mc * g;
    let t152 = mr + t150;
    let t153 = g * t150;
    let t154 = t105 - Ic1;
    let t155 = 0.21652833_f32 / Real::max(0.049893588_f32 * Real::abs(t126), 1e-24_f32);
    let t156 = 0.21680787_f32 / Real::max(0.03818978_f32 * Real::abs(t139), 1e-24_f32);
    let t157 = 0.21706869_f32 / Real::max(0.30141106_f32 * Real::abs(t142), 1e-24_f32);
    let t158 = R * g;
    let t159 = M * g;
    let t160 = R * M;
    let t161 = 0.5_f32 * t154;
    let t162 = t107 - t108;
    let t163 = t108 - t69;
    let t164 = t69 - t107;
    let c = p.c;
    Prepared { R, M, c, g, k4: t105, k5: t154, k6: t161, k7: t149, k8: t151, k9: t153, k10: t159, k11: t152, k12: t158, k13: t160, k14: t143, k15: t69, k16: t107, k17: t108, k18: t162, k19: t163, k20: t164, k21: t144, k22: t145, k23: t146, k24: t147, k25: t148, k26: t155, k27: t156, k28: t157 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///550 operations.
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
    let k23 = p.k23;
    let t12 = Real::abs(t11) * k23;
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
    let k25 = p.k25;
    let t28 = Real::abs(t27) * k25;
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
    let t42 = 1.0_f32 - t36 * t36;
    let t43 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t44 = 1.0_f32 - t43;
    let k22 = p.k22;
    let t45 = Real::min(t44, t42) * k22;
    let t46 = 0.4330127_f32 * sA + t22;
    let k24 = p.k24;
    let t47 = Real::abs(t22) * k24;
    let t48 = 1.0_f32 / t27;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t23;
    let t49 = w_platform_x_per_u_hB * t26;
    let w_platform_y_per_u_hB = t48 * t49;
    let t50 = t48 * (v_G_z_per_u_hA + t49);
    let u_hA = u[0];
    let t51 = u_hA * t50;
    let u_hB = u[1];
    let t52 = u_hB * w_platform_y_per_u_hB - t51;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t48;
    let u_hC = u[2];
    let w_platform_y = t52 + u_hC * w_platform_y_per_u_hC;
    let t53 = (u_hA - u_hB) * w_platform_x_per_u_hB + t24 * w_platform_y;
    let t54 = 1.0_f32 / (t43 - 1.0_f32);
    let t55 = t54 * (0.5_f32 * t40);
    let t56 = t54 * (0.8660254_f32 * t40);
    let t57 = t55 * w_platform_y - t56 * t53;
    let t58 = t33 * w_platform_y + t34 * t53;
    let t59 = u_hA * (0.5_f32 * t37);
    let u_sB_per_w_platform_z = 0.8660254_f32 * sA;
    let t60 = t59 + t58 * u_sB_per_w_platform_z;
    let t61 = v_G_z_per_u_hA * t54;
    let u_psiB = t57 + t61 * t58;
    let t62 = Real::sqrt(t44);
    let t63 = 1.0_f32 / t62;
    let t64 = 0.5_f32 * v_G_z_per_u_hA;
    let t65 = t64 * t63;
    let t66 = 0.8660254_f32 * v_G_z_per_u_hA;
    let t67 = t66 * t63;
    let t68 = w_platform_y * t65 - t53 * t67;
    let t69 = t40 * t63;
    let u_thB = t58 * t69 - t68;
    let t70 = u_sB_per_u_hB * u_psiB;
    let t71 = t70 * (u_psiB * t62);
    let t72 = t70 * u_thB;
    let t73 = 0.8660254_f32 * w_platform_y;
    let t74 = 0.5_f32 * t53;
    let t75 = t73 + t74;
    let t76 = t73 - t74;
    let t77 = 2.0_f32 * t72;
    let t78 = t62 * t77;
    let t79 = t75 * t58;
    let t80 = t78 - t40 * t79;
    let t81 = 0.8660254_f32 * t53;
    let t82 = 0.5_f32 * w_platform_y;
    let t83 = t81 - t82;
    let t84 = t82 + t81;
    let t85 = sB * t79;
    let t86 = t75 * t83;
    let t87 = sB * t86;
    let t88 = t54 * (t80 - v_G_z_per_u_hA * t86);
    let k6 = p.k6;
    let t89 = t62 * (2.0_f32 * (k6 * t77));
    let t90 = 0.5_f32 * t41;
    let t91 = 1.0_f32 / t42;
    let u_psiC_per_w_platform_y = t91 * t90;
    let t92 = t91 * (0.8660254_f32 * t41);
    let t93 = u_psiC_per_w_platform_y * w_platform_y + t92 * t53;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t91;
    let u_psiC = t93 - u_psiC_per_w_platform_z * t58;
    let k5 = p.k5;
    let t94 = k5 * t71;
    let t95 = t65 * t94;
    let t96 = t69 * t94;
    let t97 = t67 * t94;
    let k4 = p.k4;
    let t98 = u_sB_per_u_hB * (k5 * u_sB_per_u_hB) - k4;
    let t99 = t98 * t88 - t89;
    let t100 = Real::sqrt(t42);
    let t101 = 1.0_f32 / t100;
    let t102 = t101 * t64;
    let t103 = t36 * u_psiC;
    let t104 = k5 * (t103 * (u_psiC * t100));
    let t105 = t102 * t104 + t95;
    let t106 = 1.0_f32 - t35 * t35;
    let t107 = 1.0_f32 / t106;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t107;
    let v_G_y_per_u_hA = 0.57735026_f32 * t37;
    let t108 = v_G_y_per_u_hA * t107;
    let t109 = u_psiA_per_w_platform_z * t58;
    let u_psiA = t108 * w_platform_y - t109;
    let k21 = p.k21;
    let t110 = t106 * k21;
    let t111 = Real::sqrt(t106);
    let t112 = t35 * u_psiA;
    let t113 = k5 * (t112 * (u_psiA * t111));
    let t114 = 1.0_f32 / t111;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t114;
    let t115 = u_thA_per_w_platform_y * t113 + t105;
    let t116 = t55 * t99 - t115;
    let t117 = v_G_y_per_u_hA * t114;
    let t118 = w_platform_y * u_thA_per_w_platform_y;
    let t119 = t117 * t113;
    let u_thA = t58 * t117 + t118;
    let t120 = 2.0_f32 * t112 * u_thA;
    let u_thC_per_w_platform_x = t101 * t66;
    let u_thC_per_w_platform_z = t41 * t101;
    let t121 = t58 * t76;
    let t122 = t41 * t121;
    let t123 = sC * t121;
    let t124 = w_platform_y * t102 + t58 * u_thC_per_w_platform_z;
    let t125 = u_thC_per_w_platform_z * t104;
    let t126 = t97 - u_thC_per_w_platform_x * t104;
    let t127 = 2.0_f32 * (t103 * (t53 * u_thC_per_w_platform_x + t124));
    let t128 = t122 + t100 * t127;
    let u_psiC_dot_bias = t91 * (v_G_z_per_u_hA * (t76 * t84) + t128);
    let t129 = t100 * (k6 * t127);
    let t130 = t111 * (k6 * t120);
    let t131 = t111 * t120;
    let t132 = 2.0_f32 * t129;
    let t133 = t36 * (k5 * t36) - k4;
    let t134 = t133 * u_psiC_dot_bias + t132;
    let t135 = t35 * (k5 * t35) - k4;
    let t136 = u_psiC_per_w_platform_y * t134 + t116;
    let t137 = t53 * t58;
    let t138 = v_G_y_per_u_hA * t137 - t131;
    let t139 = w_platform_y * t53;
    let t140 = t107 * (v_G_z_per_u_hA * t139 + t138);
    let t141 = 2.0_f32 * t130;
    let t142 = t141 - t135 * t140;
    let t143 = t108 * t142 + t136;
    let k20 = p.k20;
    let t144 = k20 * t137 + t143;
    let v_G_x_per_w_platform_z = 1.3333334_f32 * t46;
    let t145 = 0.33333334_f32 * t37;
    let t146 = u_hA * t145 + v_G_x_per_w_platform_z * t58;
    let t147 = 1.1547005_f32 * t40;
    let t148 = u_hB * t147 + t146;
    let t149 = u_hB * u_sB_per_u_hB;
    let u_sA = t148 - u_hA * t35;
    let t150 = 0.5_f32 * t148;
    let t151 = t150 + t60 - t149;
    let t152 = u_hC * t36 - t150;
    let t153 = t85 - 2.0_f32 * (t83 * t151);
    let t154 = t87 + 2.0_f32 * (t58 * t151);
    let t155 = sA * t137;
    let t156 = 2.0_f32 * (w_platform_y * u_sA) - t155;
    let t157 = t23 * (t156 - t153);
    let k19 = p.k19;
    let t158 = k19 * (w_platform_y * t58);
    let t159 = t58 * u_sA;
    let v_G_y = sA * t58 + u_hA * v_G_y_per_u_hA;
    let u_sC = t152 + 0.8660254_f32 * v_G_y;
    let t160 = t123 + 2.0_f32 * (t84 * u_sC);
    let t161 = t26 * t157;
    let t162 = t48 * (t161 + (t156 + t160));
    let t163 = t133 * u_psiC_per_w_platform_z;
    let t164 = u_psiC_per_w_platform_z * t163;
    let t165 = t98 * t61;
    let t166 = t164 + t61 * t165;
    let t167 = t61 * t99;
    let t168 = t126 - t56 * t99;
    let t169 = u_psiC_per_w_platform_z * t134;
    let t170 = t158 + (t92 * t134 + t168);
    let t171 = u_psiA_per_w_platform_z * t142;
    let t172 = t135 * u_psiA_per_w_platform_z;
    let k15 = p.k15;
    let t173 = k15 - (u_psiA_per_w_platform_z * t172 + t166);
    let t174 = t172 * t108;
    let t175 = t108 * (t135 * t108);
    let t176 = t165 * t55 - t163 * u_psiC_per_w_platform_y - t174;
    let t177 = t165 * t56;
    let t178 = t163 * t92 + t177;
    let t179 = t98 * t55;
    let t180 = t56 * (t98 * t56);
    let t181 = t56 * t179;
    let t182 = t55 * t179;
    let t183 = t92 * (t133 * t92) + t180;
    let t184 = t133 * u_psiC_per_w_platform_y;
    let t185 = t181 - t92 * t184;
    let t186 = t178 * t33 + t185;
    let t187 = t175 + (u_psiC_per_w_platform_y * t184 + t182);
    let k18 = p.k18;
    let t188 = t169 - (t167 - (t171 + (t125 - (t96 + (k18 * t139 - t119)))));
    let t189 = 2.0_f32 * t159;
    let t190 = sA * t139 + t189;
    let t191 = 0.8660254_f32 * t154;
    let t192 = 0.4330127_f32 * t190 - t191;
    let t193 = sA * t20;
    let t194 = t193 + t173;
    let M = p.M;
    let t195 = M * v_G_x_per_w_platform_z;
    let t196 = v_G_x_per_w_platform_z * t195 + t194;
    let k16 = p.k16;
    let t197 = t183 - t34 * (2.0_f32 * t178 + t34 * t196) - k16;
    let t198 = t196 * t33;
    let t199 = t34 * (t198 - t176) + t186;
    let k17 = p.k17;
    let t200 = t193 + (k17 - (t33 * (2.0_f32 * t176 - t198) + t187));
    let t201 = t144 - t199 * t157;
    let k10 = p.k10;
    let t202 = M * (1.3333334_f32 * t192) + k10 * t35;
    let t203 = M * t190 + k10 * v_G_y_per_u_hA;
    let t204 = M * t156 + k10 * v_G_z_per_u_hA;
    let t205 = sA * t203 + t188;
    let t206 = v_G_x_per_w_platform_z * t202 + t205;
    let t207 = t201 - t33 * t206;
    let t208 = t197 * t157 + t170 - t34 * t206;
    let t209 = 2.0_f32 * t199;
    let t210 = t24 * t197;
    let t211 = t209 - t210;
    let t212 = t199 - t210;
    let t213 = t24 * t211 + t200;
    let t214 = t24 * t208;
    let t215 = t207 + (t213 * t162 + t214) - sA * t204;
    let t216 = v_G_y_per_u_hA * t20;
    let t217 = t195 * t145 + t216;
    let t218 = t195 * t147;
    let t219 = t34 * t218;
    let t220 = t33 * t218;
    let t221 = t217 * t34;
    let t222 = t217 * t33;
    let t223 = t24 * t219 + t220;
    let t224 = t221 * t24 + t222;
    let t225 = t212 * w_platform_x_per_u_hB;
    let t226 = t223 - t225;
    let t227 = t225 + t224;
    let t228 = v_G_z_per_u_hA * t20 + t227;
    let t229 = w_platform_x_per_u_hB * t208;
    let t230 = t229 + t147 * t202;
    let t231 = t228 * t162 + t229;
    let FB = inputs[1];
    let t232 = FB - t219 * t157;
    let t233 = t226 * t162 + t232 - t230;
    let FA = inputs[0];
    let t234 = FA - t221 * t157 - t145 * t202 - v_G_y_per_u_hA * t203 + t231;
    let k9 = p.k9;
    let FC = inputs[2];
    let t235 = k9 - FC;
    let t236 = t233 - k9;
    let t237 = t234 - k9;
    let t238 = t213 * t50 - 2.0_f32 * t228;
    let t239 = t197 * w_platform_x_per_u_hB;
    let t240 = t239 - 2.0_f32 * t221;
    let t241 = t221 - t219 - t239;
    let t242 = t239 + 2.0_f32 * t219;
    let t243 = w_platform_x_per_u_hB * t240;
    let t244 = w_platform_x_per_u_hB * t241;
    let t245 = w_platform_x_per_u_hB * t242;
    let t246 = v_G_y_per_u_hA * (M * v_G_y_per_u_hA);
    let k11 = p.k11;
    let t247 = t243 - (k11 + (t145 * (M * t145) + t246));
    let t248 = v_G_z_per_u_hA * t204;
    let t249 = t247 - v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t50 * t238 - t249;
    let t250 = M * t147;
    let t251 = t145 * t250;
    let t252 = t245 - t147 * t250;
    let k26 = p.k26;
    let t253 = Real::abs(mass_u_hA_u_hA) * k26;
    let t254 = t213 * w_platform_y_per_u_hB;
    let t255 = t50 * (t254 + t226) - t251;
    let mass_u_hA_u_hB = t228 * w_platform_y_per_u_hB - t255 - t244;
    let t256 = t213 * w_platform_y_per_u_hC;
    let mass_u_hA_u_hC = t228 * w_platform_y_per_u_hC - t50 * t256;
    let t257 = t254 + 2.0_f32 * t226;
    let t258 = t252 - k11;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * t257 - t258;
    let t259 = 1.0_f32 / mass_u_hA_u_hA;
    let t260 = t259 * mass_u_hA_u_hB;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t260;
    let mass_u_hB_u_hC = t226 * w_platform_y_per_u_hC + w_platform_y_per_u_hB * t256;
    let t261 = w_platform_y_per_u_hB * t215;
    let t262 = t50 * t215;
    let t263 = w_platform_y_per_u_hC * t215;
    let mass_u_hC_u_hC = k11 + w_platform_y_per_u_hC * t256;
    let k27 = p.k27;
    let t264 = Real::abs(pivot_1) * k27;
    let t265 = mass_u_hB_u_hC - t260 * mass_u_hA_u_hC;
    let t266 = t259 * mass_u_hA_u_hC;
    let t267 = mass_u_hC_u_hC - mass_u_hA_u_hC * t266;
    let t268 = 1.0_f32 / pivot_1;
    let t269 = t268 * t265;
    let pivot_2 = t267 - t265 * t269;
    let k28 = p.k28;
    let t270 = Real::min(Real::min(Real::min(Real::min(Real::min(Real::min(Real::min(Real::abs(pivot_2) * k28, t264), t253), t28), t47), t12), t45), t110);
    let c = p.c;
    let forcing_u_hB = t261 + (t236 - u_hB * c);
    let forcing_u_hA = t237 - u_hA * c - t248 - t262;
    let forcing_u_hC = t263 - (u_hC * c + t235);
    let t271 = forcing_u_hB - t260 * forcing_u_hA;
    let t272 = t259 * forcing_u_hA;
    let t273 = t268 * t271;
    let t274 = (forcing_u_hC - (t269 * t271 + t266 * forcing_u_hA)) / pivot_2;
    let t275 = t273 - t269 * t274;
    let t276 = t260 * t275;
    let t277 = t272 - (t266 * t274 + t276);
    ([u_hA, u_hB, u_hC], [t277, t275, t274], t270)
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
