// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 733 operations (12 abs, 131 add, 5 cos, 12 div, 11 min, 431 mul, 5 sin, 126 sub).
// Cost of energy: 226 operations (47 add, 5 cos, 9 div, 138 mul, 5 sin, 22 sub).
// Cost of speeds: 151 operations (21 add, 5 cos, 9 div, 94 mul, 5 sin, 17 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 401 operations (9 abs, 74 add, 6 cos, 10 div, 8 max, 218 mul, 6 sin, 1 sqrt, 69 sub).

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
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///733 operations.
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
    p: &Parameters,
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
    let Ic1 = p.Ic1;
    let Ic2 = p.Ic2;
    let Ic3 = p.Ic3;
    let t51 = 0.5_f64 * (Ic1 + Ic2 - Ic3);
    let t52 = 0.5_f64 * (Ic1 - (Ic2 + Ic3));
    let t53 = t51 + t52;
    let t54 = 0.5_f64 * (Ic2 - (Ic1 + Ic3));
    let t55 = sin_thC * (sin_thC * t53) - t52 - t54;
    let t56 = u_psiC_per_w_platform_z * t55;
    let t57 = sin_thB * (sin_thB * t53) - t52 - t54;
    let t58 = u_psiB_per_w_platform_z * t57;
    let t59 = Ic2 * u_thC_per_w_platform_z;
    let t60 = Ic2 * t41;
    let t61 = t46 * t56 + (t36 * t58 - (u_thC_per_w_platform_x * t59 + t15 * t60));
    let t62 = t4 * t61;
    let M = p.M;
    let t63 = sA * M;
    let t64 = sin_thA * (sin_thA * t53) - t52 - t54;
    let t65 = u_psiA_per_w_platform_z * t64;
    let t66 = Ic2 * t27;
    let t67 = t37 * t58 + (t24 * t65 - (t40 * t60 + u_thA_per_w_platform_y * t66 - t48 * t59));
    let t68 = u_psiC_per_w_platform_y * t56 - t67;
    let t69 = t37 * t57;
    let t70 = Ic2 * t40;
    let t71 = Ic2 * t48;
    let t72 = u_psiC_per_w_platform_y * t55;
    let t73 = t36 * t69 + (t15 * t70 - u_thC_per_w_platform_x * t71) - t46 * t72;
    let Ix = p.Ix;
    let t74 = t36 * (t36 * t57) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t15 * (Ic2 * t15)));
    let t75 = t46 * (t46 * t55) + t74;
    let t76 = t19 * t75;
    let t77 = w_platform_x_per_u_hB * (t73 - t76);
    let t78 = t19 * t62 - (t63 * v_G_z_per_u_hA - t4 * t68 - t77);
    let Iy = p.Iy;
    let t79 = t24 * (t24 * t64) + (t48 * t71 + (t40 * t70 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t80 = t19 * (2.0_f64 * t73 - t76) - (sA * t63 + (u_psiC_per_w_platform_y * t72 + (t37 * t69 + t79)));
    let t81 = w_platform_x_per_u_hB * t75;
    let t82 = 1.3333333333333333_f64 * M;
    let t83 = sA * t82;
    let t84 = 0.5773502691896257_f64 * M;
    let t85 = v_G_x_per_w_platform_z * t84;
    let t86 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t87 = u_psiB_per_w_platform_z * t58 + (u_psiA_per_w_platform_z * t65 + (u_thC_per_w_platform_z * t59 + (t41 * t60 + (Iz + t27 * t66))));
    let t88 = sA * (t83 + 2.0_f64 * t85) + (v_G_x_per_w_platform_z * t86 + (u_psiC_per_w_platform_z * t56 + t87));
    let t89 = (t85 + t83) * t6;
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t90 = ms + mc;
    let t91 = mr + t90;
    let t92 = t4 * (t4 * t88 - 2.0_f64 * t89) + (t91 + t6 * (t82 * t6)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let mass_u_hA_u_hA = t23 * (2.0_f64 * t78 - t23 * t80) + (w_platform_x_per_u_hB * (t81 - 2.0_f64 * t62) + t92);
    let t93 = 1.0_f64 / mass_u_hA_u_hA;
    let t94 = w_platform_y_per_u_hB * t80;
    let t95 = t8 * t61;
    let t96 = t19 * t95 + (t77 + t8 * t68);
    let t97 = t84 * t28;
    let t98 = sA * t97 + t86 * t28;
    let t99 = t8 * t88;
    let t100 = w_platform_x_per_u_hB * (t81 - t95) - (t8 * t89 - (t6 * t97 - t4 * (t98 - t99)));
    let mass_u_hA_u_hB = t23 * (t94 - t96) + (w_platform_x_per_u_hB * t62 - t100) - w_platform_y_per_u_hB * t78;
    let t101 = t93 * mass_u_hA_u_hB;
    let t102 = w_platform_x_per_u_hB * (2.0_f64 * t95 - t81) - (t91 + t28 * (M * t28) - t8 * (2.0_f64 * t98 - t99));
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (2.0_f64 * t96 - t94) - t102;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t101;
    let t103 = 1.0_f64 / pivot_1;
    let t104 = t9 * t61;
    let t105 = w_platform_x_per_u_hB * t104;
    let t106 = t9 * t88;
    let t107 = w_platform_y_per_u_hC * t80;
    let t108 = t19 * t104 + t9 * t68;
    let t109 = t107 + t108;
    let mass_u_hB_u_hC = w_platform_y_per_u_hC * t96 + (t105 + (t9 * t98 - t8 * t106) - w_platform_y_per_u_hB * t109);
    let mass_u_hA_u_hC = t23 * t109 - (t105 - (t4 * t106 - t9 * t89)) - w_platform_y_per_u_hC * t78;
    let t110 = mass_u_hB_u_hC - t101 * mass_u_hA_u_hC;
    let t111 = t103 * t110;
    let t112 = t10 * t30;
    let v_G_z_dot_bias = 2.0_f64 * (w_platform_y * u_sA) - sA * t112;
    let t113 = 0.8660254037844386_f64 * t10;
    let t114 = w_platform_y * t113;
    let t115 = 0.5_f64 * t10;
    let t116 = t30 * t115;
    let t117 = t114 + t116;
    let t118 = 0.5_f64 * w_platform_y;
    let t119 = 0.8660254037844386_f64 * t30;
    let t120 = t118 - t119;
    let t121 = t18 * (v_G_z_dot_bias - (sB * t117 - 2.0_f64 * (u_sB * t120)));
    let t122 = t114 - t116;
    let t123 = t118 + t119;
    let t124 = t21 * (t16 * t121 + (v_G_z_dot_bias + (sC * t122 + 2.0_f64 * (u_sC * t123))));
    let t125 = w_platform_y * t30;
    let t126 = sA * t125 + 2.0_f64 * (t10 * u_sA);
    let t127 = t10 * t115;
    let t128 = w_platform_y * t123 + t127;
    let t129 = t10 * t113;
    let t130 = t30 * t123 + t129;
    let t131 = 1.7320508075688772_f64 * (2.0_f64 * (u_sC * t113) - sC * t128) + (sC * t130 + 2.0_f64 * (u_sC * t115));
    let t132 = t127 + w_platform_y * t120;
    let t133 = t129 - t30 * t120;
    let t134 = 1.7320508075688772_f64 * (sB * t132 + 2.0_f64 * (u_sB * t113)) + (2.0_f64 * (u_sB * t115) - sB * t133);
    let t135 = t2 * (2.0_f64 * t126 + (t131 + t134));
    let t136 = 2.0_f64 * (u_psiC * t50);
    let t137 = sin_thC * t136;
    let u_psiC_dot_bias = t44 * (t45 * t122 - (t39 * t130 - t49 * t128) - cos_thC * t137);
    let t138 = t55 * u_psiC_dot_bias - (sin_thC * (t51 * (cos_thC * t136)) + cos_thC * (t52 * t137));
    let t139 = 2.0_f64 * (u_psiB * u_thB);
    let t140 = sin_thB * t139;
    let t141 = t57 * (t32 * (t39 * t133 - t49 * t132 + t35 * t117 + cos_thB * t140));
    let t142 = t141 + (sin_thB * (t51 * (cos_thB * t139)) + cos_thB * (t52 * t140));
    let t143 = cos_thC * u_psiC;
    let t144 = sin_thC * u_psiC * t143;
    let t145 = v_G_z_per_u_hA * t122 - (t6 * t130 + sin_thA * t128) - (sin_thC * (t143 * t143 + t50 * t50) - cos_thC * t144);
    let t146 = Ic2 * (t47 * t145) + t53 * t144;
    let t147 = cos_thB * u_psiB;
    let t148 = sin_thB * u_psiB * t147;
    let t149 = sin_thB * (t147 * t147 + u_thB * u_thB) - cos_thB * t148 - (t6 * t133 - sin_thA * t132 - v_G_z_per_u_hA * t117);
    let t150 = t53 * t148 - Ic2 * (t38 * t149);
    let t151 = t36 * t142 + (u_thC_per_w_platform_x * t146 + ((Iz - Iy) * (t10 * w_platform_y) - t15 * t150));
    let t152 = t75 * t121 + (t61 * t135 + (t46 * t138 + t151));
    let g = p.g;
    let t153 = M * (v_G_z_dot_bias + g * v_G_z_per_u_hA);
    let t154 = 2.0_f64 * u_thA;
    let t155 = sin_thA * t25;
    let t156 = t154 * t155;
    let t157 = cos_thA * t25;
    let t158 = t64 * (t12 * (v_G_z_per_u_hA * t125 - t6 * t112 + cos_thA * t156)) + (sin_thA * (t51 * (t154 * t157)) + cos_thA * (t52 * t156));
    let t159 = t155 * t157;
    let t160 = t6 * t125 + sin_thA * (t10 * t10 + w_platform_y * w_platform_y) + v_G_z_per_u_hA * t112 + (cos_thA * t159 - sin_thA * (t157 * t157 + u_thA * u_thA));
    let t161 = Ic2 * (t26 * t160) + t53 * t159;
    let t162 = t24 * t158 + (t48 * t146 + (t40 * t150 + ((Ix - Iz) * t112 - u_thA_per_w_platform_y * t161)));
    let t163 = t73 * t121 - (sA * t153 + (t68 * t135 + (u_psiC_per_w_platform_y * t138 - (t37 * t142 - t162))));
    let t164 = t80 * t124 + (t19 * t152 - t163);
    let t165 = M * (g * sin_thA + 0.5773502691896257_f64 * t134);
    let t166 = t82 * t126 + (0.5773502691896257_f64 * t165 - M * (g * t6));
    let t167 = u_psiA_per_w_platform_z * t158 - (t41 * t150 - (t27 * t161 + (Iy - Ix) * t125) - u_thC_per_w_platform_z * t146);
    let t168 = sA * t166 + (t85 * t126 - (u_psiC_per_w_platform_z * t138 + (u_psiB_per_w_platform_z * t142 - t167) - v_G_x_per_w_platform_z * t165));
    let t169 = t168 - t88 * t135;
    let t170 = g * t90;
    let c = p.c;
    let FA = inputs[0];
    let t171 = t4 * t169 + (t89 * t135 + (t170 + (u_hA * c - FA) - t6 * t166));
    let t172 = w_platform_x_per_u_hB * t152;
    let forcing_u_hA = t23 * t164 - (t78 * t124 - (t62 * t121 - (v_G_z_per_u_hA * t153 + t171) - t172));
    let FB = inputs[1];
    let t173 = t97 * t126 + (t28 * t165 + (t170 + (u_hB * c - FB))) - t98 * t135;
    let t174 = w_platform_y_per_u_hB * t164 + (t95 * t121 + (t173 - t8 * t169) - t172 - t96 * t124);
    let t175 = t101 * forcing_u_hA + t174;
    let t176 = t93 * mass_u_hA_u_hC;
    let FC = inputs[2];
    let t177 = t104 * t121 - (t9 * t169 - (FC - u_hC * c - t170)) - t108 * t124;
    let forcing_u_hC = t177 - w_platform_y_per_u_hC * t164;
    let mass_u_hC_u_hC = t91 + t9 * t106 - w_platform_y_per_u_hC * (t107 + 2.0_f64 * t108);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t176 - t110 * t111;
    let t178 = (t111 * t175 - (t176 * forcing_u_hA - forcing_u_hC)) / pivot_2;
    let t179 = t111 * t178 + t103 * t175;
    let t180 = t101 * t179 + t93 * forcing_u_hA - t176 * t178;
    let t181 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t11)), Real::abs(t31));
    let t182 = Real::min(Real::min(Real::min(Real::min(t181, Real::abs(t43)), 0.8333333333333333_f64 * Real::abs(t1)), 5.773502691896257_f64 * Real::abs(t17)), 1.6666666666666665_f64 * Real::abs(t20));
    let t183 = Real::min(Real::min(Real::min(t182, 0.2165283291230602_f64 * Real::abs(mass_u_hA_u_hA)), 0.216807871823593_f64 * Real::abs(pivot_1)), 0.21706868422196887_f64 * Real::abs(pivot_2));
    ([u_hA, -t25, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, -t50, u_sC], [t180, -t179, t178], t183)
}
///Kinetic and potential energy (J).
///
///226 operations.
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
    p: &Parameters,
) -> (S, S) {
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t1 = ms + mc;
    let t2 = mr + t1;
    let u_hC = u[2];
    let u_hB = u[1];
    let u_hA = u[0];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let Ic1 = p.Ic1;
    let Ic2 = p.Ic2;
    let Ic3 = p.Ic3;
    let t3 = 0.5_f64 * (Ic1 - (Ic2 + Ic3));
    let t4 = 0.5_f64 * (Ic1 + Ic2 - Ic3) + t3;
    let t5 = 0.5_f64 * (Ic2 - (Ic1 + Ic3));
    let sA = q[3];
    let sB = q[7];
    let sC = q[11];
    let t6 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC)));
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t7 = sin_thB - sin_thC;
    let t8 = 1.7320508075688772_f64 * sin_thA;
    let t9 = 0.5773502691896257_f64 * t7;
    let t10 = t8 + t9;
    let t11 = u_hA * (t6 * (1.1547005383792515_f64 * t7)) - u_hB * (t6 * t10) + u_hC * (t6 * (t8 - t9));
    let t12 = 1.0_f64 / (cos_thA * cos_thA);
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
    let t17 = 1.0_f64 / (0.8660254037844386_f64 * sB);
    let t18 = (sA + 0.5_f64 * sB) * t17;
    let t19 = 1.0_f64 / (sA + 0.5_f64 * sC + t16 * t18);
    let w_platform_x_per_u_hB = t17 * v_G_z_per_u_hA;
    let t20 = t16 * w_platform_x_per_u_hB;
    let w_platform_y_per_u_hB = t19 * t20;
    let w_platform_y_per_u_hC = t19 * v_G_z_per_u_hA;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * (t19 * (v_G_z_per_u_hA + t20)) + u_hC * w_platform_y_per_u_hC;
    let t21 = t11 * u_psiA_per_w_platform_z + w_platform_y * (t12 * t9);
    let t22 = t2 * (u_hA * u_hA) + (sin_thA * (sin_thA * t4) - t3 - t5) * (t21 * t21);
    let t23 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t23 * v_G_z_per_u_hA;
    let u_thA = w_platform_y * u_thA_per_w_platform_y - t11 * (t23 * t9);
    let t24 = w_platform_x_per_u_hB * (u_hA - u_hB) + t18 * w_platform_y;
    let t25 = 1.0_f64 / (cos_thB * cos_thB);
    let t26 = 0.8660254037844386_f64 * sin_thA;
    let t27 = 0.28867513459481287_f64 * t7;
    let t28 = t26 + t27;
    let u_psiB_per_w_platform_z = t25 * v_G_z_per_u_hA;
    let u_psiB = t24 * (t25 * (0.8660254037844386_f64 * t28)) - w_platform_y * (t25 * (0.5_f64 * t28)) - t11 * u_psiB_per_w_platform_z;
    let t29 = t2 * (u_hB * u_hB) + (t22 + Ic2 * (u_thA * u_thA)) + (sin_thB * (sin_thB * t4) - t3 - t5) * (u_psiB * u_psiB);
    let t30 = 1.0_f64 / cos_thB;
    let t31 = 0.5_f64 * v_G_z_per_u_hA;
    let u_thB = t15 * t24 - w_platform_y * (t30 * t31) + t11 * (t30 * t28);
    let t32 = 1.0_f64 / (cos_thC * cos_thC);
    let t33 = t26 - t27;
    let u_psiC_per_w_platform_y = t32 * (0.5_f64 * t33);
    let u_psiC_per_w_platform_z = t32 * v_G_z_per_u_hA;
    let u_psiC = w_platform_y * u_psiC_per_w_platform_y + t24 * (t32 * (0.8660254037844386_f64 * t33)) - t11 * u_psiC_per_w_platform_z;
    let t34 = t2 * (u_hC * u_hC) + (t29 + Ic2 * (u_thB * u_thB)) + (sin_thC * (sin_thC * t4) - t3 - t5) * (u_psiC * u_psiC);
    let t35 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_x = t35 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let u_thC_per_w_platform_z = t35 * t33;
    let t36 = w_platform_y * (t35 * t31) + t24 * u_thC_per_w_platform_x + t11 * u_thC_per_w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t37 = t34 + Ic2 * (t36 * t36) + Ix * (t24 * t24) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_y = sA * t11 - u_hA * t9;
    let t38 = v_G_x_per_w_platform_z * t11 + u_hB * (0.5773502691896257_f64 * t10) + 0.5773502691896257_f64 * v_G_y;
    let t39 = t37 + Iz * (t11 * t11) + M * (t38 * t38) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t40 = 0.5_f64 * (t39 + M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t41 = hA * g;
    let hC = q[8];
    let t42 = hC * g;
    let hB = q[4];
    let t43 = hB * g;
    let t44 = mc * t42 + (ms * t42 + (mc * t43 + (ms * t43 + t1 * t41)));
    let t45 = M * (t41 + sA * (g * sin_thA)) + t44;
    (t40, t45)
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
    _p: &Parameters,
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
    p: &Parameters,
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
///401 operations.
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
    p: &Parameters,
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
    let R = p.R;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = 0.8660254037844386_f64 * t10;
    let t12 = cos_thA * cos_psiA;
    let t13 = 0.5_f64 * t12;
    let t14 = t11 - t13;
    let t15 = 0.5_f64 * t10;
    let t16 = t15 + 0.8660254037844386_f64 * t12;
    let t17 = 1.1547005383792515_f64 * (sin_thB * (cos_psiB * t14 - sin_psiB * t16) - sin_thA * cos_thB);
    let t18 = cos_psiB * t16 + sin_psiB * t14;
    let t19 = 1.1547005383792515_f64 * t18;
    let t20 = sin_thB * t19;
    let t21 = sin_psiB * t17 - cos_psiB * t20;
    let t22 = cos_psiB * t17 + sin_psiB * t20;
    let t23 = 0.8660254037844386_f64 * t22 - 0.5_f64 * t21;
    let t24 = R * t23;
    let t25 = 0.5773502691896257_f64 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t26 = t25 * cos_psiC - cos_thC * sin_psiC;
    let t27 = 0.5773502691896257_f64 * cos_thB;
    let t28 = t27 * cos_psiB + cos_thB * sin_psiB;
    let t29 = t26 - t28;
    let t30 = 0.5_f64 * t29;
    let t31 = sin_thA * t30 - t12 * t3;
    let t32 = cos_thB * cos_psiB - t27 * sin_psiB;
    let t33 = t25 * sin_psiC + cos_thC * cos_psiC;
    let t34 = t32 + t33;
    let t35 = 0.5_f64 * t34;
    let t36 = t10 * t3 - sin_thA * t35;
    let t37 = t10 * t30 - t12 * t35;
    let t38 = 1.0_f64 / Real::sqrt(t36 * t36 + t31 * t31 + t37 * t37);
    let t39 = t31 * t38;
    let t40 = t37 * t38;
    let t41 = sin_thA * t39 + t10 * t40;
    let t42 = t12 * t6 - t7 * t41;
    let t43 = t36 * t38;
    let t44 = t12 * t40 + sin_thA * t43;
    let t45 = t7 * t44 + t10 * t6;
    let t46 = 0.5_f64 * t22 + 0.8660254037844386_f64 * t21;
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
    let t53 = t50 * t23 - t51 * t46 - v_G_z_per_u_hA * t52 - t24 - R * (0.5_f64 * t23 + 0.8660254037844386_f64 * t46);
    let t54 = 1.0_f64 / (sA + t4 + t5 * t9) * (t5 * t49 + t53);
    let u_psiA_per_w_platform_z = t1 * v_G_z_per_u_hA;
    let t55 = sA * t12;
    let t56 = sA * t10;
    let t57 = sA * sin_thA;
    let t58 = sA * (cos_thA * (sin_psiA * t35 + cos_psiA * t30) + sin_thA * t3);
    let t59 = t55 * t30 + t56 * t35 + t57 * t3 - t58;
    let t60 = R * t12;
    let t61 = R * t14 - (t60 - (t12 * t42 + t10 * t45 + sin_thA * t48) - sA);
    let t62 = 0.4330127018922193_f64 * t34;
    let t63 = 0.25_f64 * t29;
    let t64 = R * t30;
    let t65 = R * (t62 - t63) - (t64 - (t30 * t42 + t35 * t45 + t3 * t48) - t58);
    let t66 = 1.7320508075688772_f64 * t61 + t65;
    let t67 = sA - (t60 + (t10 * t51 - t12 * t50 + sin_thA * t52)) - R * (t11 + t13);
    let t68 = t64 - (t30 * t50 - t35 * t51 - t3 * t52) - t58 + R * (t63 + t62);
    let t69 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC))) * (2.0_f64 * t59 + (t66 - (1.7320508075688772_f64 * t67 + t68)));
    let t70 = t1 * t3 * t54 - u_psiA_per_w_platform_z * t69;
    let t71 = 1.0_f64 / cos_thA;
    let u_thA_per_w_platform_y = t71 * v_G_z_per_u_hA;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t72 = 0.5773502691896257_f64 * (sA * t69 - t59) + (v_G_x_per_w_platform_z * t69 - 0.5773502691896257_f64 * t66);
    let t73 = t72 + (sA - (t12 * t55 + t10 * t56 + sin_thA * t57));
    let t74 = 1.0_f64 / (cos_thB * cos_thB);
    let t75 = 0.8660254037844386_f64 * sin_thA;
    let t76 = 0.28867513459481287_f64 * t2;
    let t77 = t75 + t76;
    let t78 = t49 - t9 * t54;
    let t79 = 0.8660254037844386_f64 * t41;
    let t80 = 0.8660254037844386_f64 * t32;
    let t81 = 0.8660254037844386_f64 * t44;
    let t82 = 0.8660254037844386_f64 * t28;
    let t83 = t74 * (0.8660254037844386_f64 * t77) * t78 + t74 * ((t13 - t79) * t80 + (t15 + t81) * t82);
    let u_psiB_per_w_platform_z = t74 * v_G_z_per_u_hA;
    let t84 = t74 * (0.5_f64 * t77) * t54 + t83 - u_psiB_per_w_platform_z * t69;
    let t85 = 1.0_f64 / cos_thB;
    let t86 = 0.5_f64 * v_G_z_per_u_hA;
    let t87 = 0.5_f64 * sin_thA;
    let t88 = 0.8660254037844386_f64 * t47;
    let t89 = t85 * t77 * t69 + (t85 * t86 * t54 - (t85 * (sin_thB + (t87 + t88)) - t18 * t78));
    let t90 = 2.0_f64 * t72;
    let t91 = 1.7320508075688772_f64 * sB * t69 - 2.0_f64 * t61 - t90;
    let t92 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_w_platform_z = t92 * v_G_z_per_u_hA;
    let t93 = t75 - t76;
    let u_psiC_per_w_platform_y = t92 * (0.5_f64 * t93);
    let t94 = 0.8660254037844386_f64 * t33;
    let t95 = 0.8660254037844386_f64 * t26;
    let t96 = t92 * ((t13 + t79) * t94 + (t81 - t15) * t95) - t92 * (0.8660254037844386_f64 * t93) * t78;
    let t97 = 1.0_f64 / cos_thC;
    let u_thC_per_w_platform_z = t97 * t93;
    let u_thC_per_w_platform_x = t97 * (0.8660254037844386_f64 * v_G_z_per_u_hA);
    let t98 = u_thC_per_w_platform_z * t69 + (u_thC_per_w_platform_x * t78 + t97 * (sin_thC + (t87 - t88)) - t97 * t86 * t54);
    let u_sC_per_w_platform_z = 1.7320508075688772_f64 * sC;
    let t99 = sA * cos_thA;
    let t100 = sin_psiA * t99;
    let t101 = 0.8660254037844386_f64 * R;
    let t102 = sB * cos_thB;
    let t103 = sin_psiB * t102;
    let t104 = cos_psiB * t102;
    let t105 = R - cos_psiA * t99 + 0.5_f64 * R;
    let t106 = Real::max(Real::abs(t100 + t101 + (0.5_f64 * t103 - 0.8660254037844386_f64 * t104)), Real::abs(t105 - (0.5_f64 * t104 + 0.8660254037844386_f64 * t103)));
    let t107 = sC * cos_thC;
    let t108 = cos_psiC * t107;
    let t109 = sin_psiC * t107;
    let t110 = Real::max(Real::max(t106, Real::abs(hA - hB + t57 - sB * sin_thB)), Real::abs(0.8660254037844386_f64 * t108 + 0.5_f64 * t109 - (t101 - t100)));
    let t111 = Real::max(Real::max(t110, Real::abs(t105 + (0.8660254037844386_f64 * t109 - 0.5_f64 * t108))), Real::abs(sC * sin_thC + (hC - hA - t57)));
    let t112 = Real::max(Real::max(Real::max(t111, Real::abs(t10 + t80 - t94)), Real::abs(t95 - (t12 - t82))), Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t70, -(t71 * t3 * t69 + u_thA_per_w_platform_y * t54), t73, t84, t89, t91, -(u_psiC_per_w_platform_z * t69 + (u_psiC_per_w_platform_y * t54 + t96)), -t98, -(t90 + (u_sC_per_w_platform_z * t69 + 2.0_f64 * t67))], t112)
}
///Three-legged tile: screws A, B, C lift connectors; rods at 120 degrees carry the platform.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tile {
    /// Tunable parameters.
    pub parameters: Parameters,
}
impl Tile {
    /// The parameter at a position of `PARAMETER_NAMES`, to read or set.
    pub fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
        Some(
            match index {
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
                _ => return None,
            },
        )
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
        (*q_out, *u_out, pivot) = rates(t, q, u, inputs, &self.parameters);
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
            &self.parameters,
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
                &self.parameters,
            ),
        )
    }
}
