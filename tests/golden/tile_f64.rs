// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 833 operations (12 abs, 170 add, 5 cos, 12 div, 11 min, 489 mul, 5 sin, 129 sub).
// Cost of energy: 314 operations (62 add, 5 cos, 9 div, 197 mul, 5 sin, 36 sub).
// Cost of speeds: 236 operations (39 add, 5 cos, 9 div, 142 mul, 5 sin, 36 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 373 operations (9 abs, 77 add, 6 cos, 10 div, 8 max, 192 mul, 6 sin, 1 sqrt, 64 sub).

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
///833 operations.
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
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t1 = cos_thA * cos_thA;
    let t2 = 1.0_f64 / t1;
    let sA = q[3];
    let sC = q[11];
    let sB = q[7];
    let t3 = sA + 0.5_f64 * sB;
    let t4 = 0.8660254037844386_f64 * sC;
    let t5 = 0.8660254037844386_f64 * sB;
    let t6 = 1.0_f64 / t5;
    let t7 = t4 * t6;
    let t8 = sA + 0.5_f64 * sC + t3 * t7;
    let t9 = 1.0_f64 / t8;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = cos_thA * sin_psiA;
    let t11 = cos_thA * cos_psiA;
    let t12 = cos_psiB * (0.5_f64 * t10 + 0.8660254037844386_f64 * t11) + sin_psiB * (0.8660254037844386_f64 * t10 - 0.5_f64 * t11);
    let t13 = cos_thB * (1.1547005383792515_f64 * t12);
    let t14 = t7 * t13;
    let w_platform_y_per_u_hB = t9 * t14;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t15 = sin_thB - sin_thC;
    let t16 = 0.5773502691896257_f64 * t15;
    let t17 = 2.0_f64 * (sA + (sB + sC));
    let t18 = 1.0_f64 / t17;
    let t19 = 1.7320508075688772_f64 * sin_thA;
    let t20 = t19 + t16;
    let t21 = t18 * t20;
    let t22 = t13 * t21;
    let t23 = t2 * (w_platform_y_per_u_hB * t16 - t22);
    let t24 = t9 * (t13 + t14);
    let t25 = t18 * (1.1547005383792515_f64 * t15);
    let t26 = t13 * t25;
    let u_psiA_per_u_hA = t2 * (t16 * t24 - t26);
    let u_hC = u[2];
    let w_platform_y_per_u_hC = t9 * t13;
    let t27 = t18 * (t19 - t16);
    let t28 = t13 * t27;
    let t29 = t2 * (t16 * w_platform_y_per_u_hC + t28);
    let t30 = u_hB * t23 - u_hA * u_psiA_per_u_hA + u_hC * t29;
    let t31 = 1.0_f64 / cos_thA;
    let t32 = t31 * (t16 * t25 + t13 * t24);
    let t33 = t16 * t21;
    let u_thA_per_u_hB = t31 * (t13 * w_platform_y_per_u_hB + t33);
    let t34 = 0.8660254037844386_f64 * sin_thA;
    let t35 = 0.28867513459481287_f64 * t15;
    let t36 = t34 - t35;
    let t37 = t25 * t36;
    let t38 = t31 * (t37 - t13 * w_platform_y_per_u_hC);
    let t39 = u_hA * t32 - u_hB * u_thA_per_u_hB + u_hC * t38;
    let t40 = 2.0_f64 * sB;
    let t41 = sA + t40;
    let u_sA_per_u_hC = 0.5773502691896257_f64 * (t27 * t41);
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * (t21 * t41 - t20);
    let v_G_y_per_u_hA = sA * t25 - t16;
    let t42 = 0.5773502691896257_f64 * (t40 * t25 + v_G_y_per_u_hA);
    let u_sA = u_hC * u_sA_per_u_hC - (u_hB * v_G_x_per_u_hB + u_hA * (sin_thA - t42));
    let t43 = cos_thB * cos_thB;
    let t44 = 1.0_f64 / t43;
    let t45 = t34 + t35;
    let t46 = 0.5_f64 * t45;
    let t47 = 0.8660254037844386_f64 * t45;
    let w_platform_x_per_u_hA = t6 * (t3 * t24 - t13);
    let u_psiB_per_u_hA = t44 * (t24 * t46 - t47 * w_platform_x_per_u_hA - t26);
    let w_platform_x_per_u_hB = t6 * (t13 - t3 * w_platform_y_per_u_hB);
    let t48 = t44 * (w_platform_y_per_u_hB * t46 + w_platform_x_per_u_hB * t47 - t22);
    let t49 = t6 * (t3 * w_platform_y_per_u_hC);
    let u_psiB_per_u_hC = t44 * (t47 * t49 - w_platform_y_per_u_hC * t46 - t28);
    let u_psiB = u_hA * u_psiB_per_u_hA - u_hB * t48 + u_hC * u_psiB_per_u_hC;
    let t50 = 1.0_f64 / cos_thB;
    let t51 = 0.5_f64 * t13;
    let t52 = 0.8660254037844386_f64 * t13;
    let t53 = t50 * (t21 * t45 + (w_platform_y_per_u_hB * t51 + w_platform_x_per_u_hB * t52));
    let t54 = t24 * t51;
    let t55 = w_platform_x_per_u_hA * t52;
    let u_thB_per_u_hA = t50 * (t33 + (t54 - t55));
    let t56 = w_platform_y_per_u_hC * t51;
    let t57 = t49 * t52;
    let t58 = t56 - t57 - t21 * t36;
    let t59 = t50 * t58;
    let t60 = u_hB * t53 - u_hA * u_thB_per_u_hA + u_hC * t59;
    let u_sB_per_u_hB = 2.0_f64 * (v_G_x_per_u_hB + (sin_thA - t5 * t21));
    let u_sB = u_hB * u_sB_per_u_hB + u_hA * (2.0_f64 * (t5 * t25 - t42)) + u_hC * (2.0_f64 * (t5 * t27 - u_sA_per_u_hC));
    let t61 = cos_thC * cos_thC;
    let t62 = 1.0_f64 / t61;
    let t63 = 0.5_f64 * t36;
    let t64 = 0.8660254037844386_f64 * t36;
    let u_psiC_per_u_hC = t62 * (w_platform_y_per_u_hC * t63 + t49 * t64 - t28);
    let t65 = t62 * (t26 + (t24 * t63 + w_platform_x_per_u_hA * t64));
    let u_psiC_per_u_hB = t62 * (t22 - (w_platform_x_per_u_hB * t64 - w_platform_y_per_u_hB * t63));
    let u_psiC = u_hC * u_psiC_per_u_hC - (u_hA * t65 - u_hB * u_psiC_per_u_hB);
    let t66 = 1.0_f64 / cos_thC;
    let t67 = t66 * t58;
    let t68 = t66 * (t37 - (t54 + t55));
    let t69 = t66 * (t27 * t36 + (t56 + t57));
    let t70 = u_hB * t67 + u_hA * t68 + u_hC * t69;
    let t71 = u_hA * (2.0_f64 * (t42 + t4 * t25)) - u_hB * (2.0_f64 * (v_G_x_per_u_hB + t4 * t21));
    let t72 = t71 + u_hC * (2.0_f64 * (u_sA_per_u_hC + (t4 * t27 - sin_thA)));
    let v_G_z_per_u_hA = t13 - sA * t24;
    let M = p.M;
    let Iz = p.Iz;
    let Iy = p.Iy;
    let Ix = p.Ix;
    let Ic2 = p.Ic2;
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t73 = sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC);
    let t74 = sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB);
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t75 = mc + (ms + mr);
    let t76 = sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA);
    let t77 = u_psiB_per_u_hA * (t74 * u_psiB_per_u_hA) + (t32 * (Ic2 * t32) + (t75 + u_psiA_per_u_hA * (t76 * u_psiA_per_u_hA)));
    let t78 = t68 * (Ic2 * t68) + (t65 * (t73 * t65) + (u_thB_per_u_hA * (Ic2 * u_thB_per_u_hA) + t77));
    let t79 = t25 * (Iz * t25) + (t24 * (Iy * t24) + (w_platform_x_per_u_hA * (Ix * w_platform_x_per_u_hA) + t78));
    let mass_u_hA_u_hA = v_G_z_per_u_hA * (M * v_G_z_per_u_hA) + (v_G_y_per_u_hA * (M * v_G_y_per_u_hA) + (t42 * (M * t42) + t79));
    let t80 = 1.0_f64 / mass_u_hA_u_hA;
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let t81 = M * v_G_z_per_u_hB;
    let t82 = sA * t21;
    let t83 = M * t82;
    let t84 = M * v_G_x_per_u_hB;
    let t85 = Iz * t21;
    let t86 = Iy * w_platform_y_per_u_hB;
    let t87 = Ix * w_platform_x_per_u_hB;
    let t88 = Ic2 * t67;
    let t89 = t73 * u_psiC_per_u_hB;
    let t90 = Ic2 * t53;
    let t91 = t74 * t48;
    let t92 = Ic2 * u_thA_per_u_hB;
    let t93 = t76 * t23;
    let t94 = t65 * t89 + (u_thB_per_u_hA * t90 + (u_psiB_per_u_hA * t91 + (t32 * t92 + u_psiA_per_u_hA * t93)));
    let t95 = t42 * t84 + (t25 * t85 + (t24 * t86 - (w_platform_x_per_u_hA * t87 + (t68 * t88 - t94))));
    let mass_u_hA_u_hB = v_G_z_per_u_hA * t81 - (v_G_y_per_u_hA * t83 + t95);
    let t96 = t80 * mass_u_hA_u_hB;
    let t97 = u_psiC_per_u_hB * t89 + (t53 * t90 + (t48 * t91 + (t75 + (u_thA_per_u_hB * t92 + t23 * t93))));
    let t98 = v_G_x_per_u_hB * t84 + (t21 * t85 + (w_platform_y_per_u_hB * t86 + (w_platform_x_per_u_hB * t87 + (t67 * t88 + t97))));
    let mass_u_hB_u_hB = v_G_z_per_u_hB * t81 + (t82 * t83 + t98);
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t96;
    let t99 = 1.0_f64 / pivot_1;
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let t100 = M * v_G_z_per_u_hC;
    let v_G_y_per_u_hC = sA * t27;
    let t101 = M * v_G_y_per_u_hC;
    let t102 = M * u_sA_per_u_hC;
    let t103 = Iy * w_platform_y_per_u_hC;
    let t104 = Ic2 * t69;
    let t105 = t73 * u_psiC_per_u_hC;
    let t106 = Ic2 * t59;
    let t107 = t74 * u_psiB_per_u_hC;
    let t108 = Ic2 * t38;
    let t109 = t76 * t29;
    let t110 = u_psiC_per_u_hB * t105 + (t53 * t106 - (t48 * t107 + (u_thA_per_u_hB * t108 - t23 * t109)));
    let t111 = Ix * t49;
    let t112 = Iz * t27;
    let t113 = v_G_x_per_u_hB * t102 - (w_platform_y_per_u_hB * t103 + (t67 * t104 + t110 - w_platform_x_per_u_hB * t111) - t21 * t112);
    let mass_u_hB_u_hC = v_G_z_per_u_hB * t100 - (t82 * t101 + t113);
    let t114 = t65 * t105 + (u_thB_per_u_hA * t106 - (u_psiB_per_u_hA * t107 + (t32 * t108 - u_psiA_per_u_hA * t109)));
    let t115 = t42 * t102 + (t25 * t112 - (t24 * t103 + (w_platform_x_per_u_hA * t111 + (t114 - t68 * t104))));
    let mass_u_hA_u_hC = v_G_z_per_u_hA * t100 + (v_G_y_per_u_hA * t101 + t115);
    let t116 = mass_u_hB_u_hC - t96 * mass_u_hA_u_hC;
    let t117 = t99 * t116;
    let t118 = u_hA * t25 - u_hB * t21 + u_hC * t27;
    let w_platform_x = u_hB * w_platform_x_per_u_hB + u_hA * w_platform_x_per_u_hA - u_hC * t49;
    let t119 = t118 * w_platform_x;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * t24 + u_hC * w_platform_y_per_u_hC;
    let t120 = sA * t119 + 2.0_f64 * (u_sA * w_platform_y);
    let t121 = 0.5_f64 * t118;
    let t122 = t121 * w_platform_x;
    let t123 = 0.8660254037844386_f64 * t118;
    let t124 = t123 * w_platform_y;
    let t125 = t122 - t124;
    let t126 = 0.5_f64 * w_platform_y;
    let t127 = 0.8660254037844386_f64 * w_platform_x;
    let t128 = t126 + t127;
    let t129 = sB * t125 + 2.0_f64 * (u_sB * t128) + t120;
    let t130 = t126 - t127;
    let t131 = t124 + t122;
    let t132 = t9 * (t7 * t129 + (t120 - (2.0_f64 * (t72 * t130) - sC * t131)));
    let v_G_z_dot_bias = t120 - sA * t132;
    let g = p.g;
    let t133 = M * (v_G_z_dot_bias + g * t13);
    let t134 = w_platform_y * w_platform_x;
    let t135 = sA * t134 - 2.0_f64 * (u_sA * t118);
    let t136 = t118 * t121;
    let t137 = t136 + w_platform_y * t128;
    let t138 = t118 * t123;
    let t139 = w_platform_x * t128 + t138;
    let t140 = 1.7320508075688772_f64 * (sB * t137 + 2.0_f64 * (u_sB * t123)) + (2.0_f64 * (u_sB * t121) - sB * t139);
    let t141 = t138 - w_platform_x * t130;
    let t142 = t136 + w_platform_y * t130;
    let t143 = t140 + sC * t141 - 1.7320508075688772_f64 * (sC * t142 + 2.0_f64 * (t72 * t123)) - 2.0_f64 * (t72 * t121 + t135);
    let t144 = t18 * t143;
    let t145 = t135 + sA * t144;
    let t146 = M * (t145 + g * t16);
    let v_G_x_dot_bias = 0.5773502691896257_f64 * (t145 - (t140 - t40 * t144));
    let t147 = M * (g * sin_thA - v_G_x_dot_bias);
    let t148 = Iy * t132 + (Ix - Iz) * t119;
    let t149 = t6 * (t129 - t3 * t132);
    let t150 = Ix * t149 + (Iz - Iy) * (t118 * w_platform_y);
    let t151 = t51 * t132;
    let t152 = t52 * t149;
    let t153 = cos_thC * u_psiC;
    let t154 = sin_thC * u_psiC * t153;
    let t155 = t13 * t131 - (t16 * t141 + sin_thA * t142) - (sin_thC * (t153 * t153 + t70 * t70) - cos_thC * t154);
    let u_thC_dot_bias = t66 * (t36 * t144 + (t151 - (t152 + t155)));
    let t156 = Ic1 - Ic3;
    let t157 = Ic2 * u_thC_dot_bias - t156 * t154;
    let t158 = sin_thB * u_psiB;
    let t159 = cos_thB * u_psiB;
    let t160 = t158 * t159;
    let t161 = sin_thB * (t159 * t159 + t60 * t60) - cos_thB * t160 - (t16 * t139 - sin_thA * t137 + t13 * t125);
    let u_thB_dot_bias = t50 * (t151 + (t152 + t161) - t45 * t144);
    let t162 = t156 * t160 - Ic2 * u_thB_dot_bias;
    let t163 = Ic1 - Ic2 - Ic3;
    let t164 = t60 * t158;
    let t165 = Ic1 + (Ic2 - Ic3);
    let t166 = t13 * t144;
    let t167 = t47 * t149 - (t45 * t125 - (t51 * t139 - t52 * t137) + cos_thB * (2.0_f64 * t164));
    let u_psiB_dot_bias = t44 * (t166 + (t46 * t132 + t167));
    let t168 = cos_thB * (t163 * t164) + sin_thB * (t165 * (t60 * t159)) - t74 * u_psiB_dot_bias;
    let t169 = g * (ms + mc);
    let c = p.c;
    let FB = inputs[1];
    let t170 = t132 - t119;
    let t171 = sin_thA * t30;
    let t172 = cos_thA * t30;
    let t173 = t171 * t172;
    let t174 = sin_thA * (t118 * t118 + w_platform_y * w_platform_y) + (cos_thA * t173 - sin_thA * (t172 * t172 + t39 * t39));
    let t175 = Ic2 * (t31 * (t13 * t170 - (t16 * t134 - t174 + t16 * t144))) + t156 * t173;
    let t176 = t39 * t171;
    let u_psiA_dot_bias = t2 * (t166 + cos_thA * (2.0_f64 * t176) + t13 * t134 + t16 * t170);
    let t177 = t76 * u_psiA_dot_bias + (cos_thA * (t163 * t176) + sin_thA * (t165 * (t39 * t172)));
    let t178 = t48 * t168 + (t169 + (u_hB * c - FB) - (u_thA_per_u_hB * t175 + t23 * t177));
    let t179 = u_psiC * t70;
    let t180 = sin_thC * t179;
    let t181 = t64 * t149 + (t36 * t131 - (t51 * t141 - t52 * t142) - cos_thC * (2.0_f64 * t180));
    let t182 = t73 * (t62 * (t63 * t132 - t181 - t166)) + (cos_thC * (t180 * t163) + sin_thC * (t165 * (cos_thC * t179)));
    let t183 = w_platform_y_per_u_hB * t148 + (w_platform_x_per_u_hB * t150 + (t67 * t157 - (t53 * t162 + t178 - u_psiC_per_u_hB * t182)));
    let t184 = Iz * t144 + (Iy - Ix) * t134;
    let FA = inputs[0];
    let t185 = t32 * t175 + (u_psiA_per_u_hA * t177 + (u_hA * c - FA + t169)) - u_psiB_per_u_hA * t168;
    let t186 = t24 * t148 + (t65 * t182 + (t185 - u_thB_per_u_hA * t162) - t68 * t157 - w_platform_x_per_u_hA * t150);
    let t187 = v_G_z_per_u_hA * t133 + (t42 * t147 - (t25 * t184 - t186) - v_G_y_per_u_hA * t146);
    let t188 = v_G_z_per_u_hB * t133 + (t82 * t146 - (v_G_x_per_u_hB * t147 + (t183 - t21 * t184))) - t96 * t187;
    let FC = inputs[2];
    let t189 = FC - u_hC * c - t169 - (t59 * t162 - (u_psiB_per_u_hC * t168 + (t29 * t177 - t38 * t175)));
    let t190 = t49 * t150 - (t69 * t157 + (u_psiC_per_u_hC * t182 + t189)) - w_platform_y_per_u_hC * t148 - t27 * t184;
    let t191 = t80 * mass_u_hA_u_hC;
    let t192 = t117 * t188 - (v_G_z_per_u_hC * t133 + (u_sA_per_u_hC * t147 + t190 - v_G_y_per_u_hC * t146) - t191 * t187);
    let t193 = u_psiC_per_u_hC * t105 + (t75 + (t59 * t106 + (u_psiB_per_u_hC * t107 + (t38 * t108 + t29 * t109))));
    let t194 = u_sA_per_u_hC * t102 + (t27 * t112 + (w_platform_y_per_u_hC * t103 + (t49 * t111 + (t69 * t104 + t193))));
    let mass_u_hC_u_hC = v_G_z_per_u_hC * t100 + (v_G_y_per_u_hC * t101 + t194);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t191 - t116 * t117;
    let t195 = t192 / pivot_2;
    let t196 = t117 * t195 + t99 * t188;
    let t197 = t96 * t196 - t80 * t187 - t191 * t195;
    let t198 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t1)), Real::abs(t43));
    let t199 = Real::min(Real::min(Real::min(Real::min(t198, Real::abs(t61)), 0.8333333333333333_f64 * Real::abs(t17)), 5.773502691896257_f64 * Real::abs(t5)), 1.6666666666666665_f64 * Real::abs(t8));
    let t200 = Real::min(Real::min(Real::min(t199, 0.21652832912306028_f64 * Real::abs(mass_u_hA_u_hA)), 0.21680787182359307_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, -t30, -t39, u_sA, u_hB, u_psiB, -t60, u_sB, u_hC, u_psiC, -t70, -t72], [t197, -t196, t195], t200)
}
///Kinetic and potential energy (J).
///
///314 operations.
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
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t1 = mc + (ms + mr);
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t2 = 1.0_f64 / (cos_thA * cos_thA);
    let sA = q[3];
    let sC = q[11];
    let sB = q[7];
    let t3 = sA + 0.5_f64 * sB;
    let t4 = 1.0_f64 / (0.8660254037844386_f64 * sB);
    let t5 = 0.8660254037844386_f64 * sC * t4;
    let t6 = 1.0_f64 / (sA + 0.5_f64 * sC + t3 * t5);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t7 = cos_thA * sin_psiA;
    let t8 = cos_thA * cos_psiA;
    let t9 = cos_psiB * (0.5_f64 * t7 + 0.8660254037844386_f64 * t8) + sin_psiB * (0.8660254037844386_f64 * t7 - 0.5_f64 * t8);
    let t10 = cos_thB * (1.1547005383792515_f64 * t9);
    let t11 = t5 * t10;
    let w_platform_y_per_u_hB = t6 * t11;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t12 = sin_thB - sin_thC;
    let t13 = 0.5773502691896257_f64 * t12;
    let t14 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC)));
    let t15 = 1.7320508075688772_f64 * sin_thA;
    let t16 = t15 + t13;
    let t17 = t14 * t16;
    let t18 = t10 * t17;
    let t19 = t6 * (t10 + t11);
    let t20 = t14 * (1.1547005383792515_f64 * t12);
    let t21 = t10 * t20;
    let u_psiA_per_u_hA = t2 * (t13 * t19 - t21);
    let w_platform_y_per_u_hC = t6 * t10;
    let t22 = t14 * (t15 - t13);
    let t23 = t10 * t22;
    let t24 = u_hB * (t2 * (w_platform_y_per_u_hB * t13 - t18)) - u_hA * u_psiA_per_u_hA + u_hC * (t2 * (t13 * w_platform_y_per_u_hC + t23));
    let t25 = t1 * (u_hA * u_hA) + (t1 * (u_hB * u_hB) + t1 * (u_hC * u_hC)) + (sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA)) * (t24 * t24);
    let Ic2 = p.Ic2;
    let t26 = 1.0_f64 / cos_thA;
    let t27 = t13 * t17;
    let u_thA_per_u_hB = t26 * (t10 * w_platform_y_per_u_hB + t27);
    let t28 = 0.8660254037844386_f64 * sin_thA;
    let t29 = 0.28867513459481287_f64 * t12;
    let t30 = t28 - t29;
    let t31 = t20 * t30;
    let t32 = u_hA * (t26 * (t13 * t20 + t10 * t19)) - u_hB * u_thA_per_u_hB + u_hC * (t26 * (t31 - t10 * w_platform_y_per_u_hC));
    let t33 = 1.0_f64 / (cos_thB * cos_thB);
    let t34 = t28 + t29;
    let t35 = 0.5_f64 * t34;
    let t36 = 0.8660254037844386_f64 * t34;
    let w_platform_x_per_u_hA = t4 * (t3 * t19 - t10);
    let u_psiB_per_u_hA = t33 * (t19 * t35 - t36 * w_platform_x_per_u_hA - t21);
    let w_platform_x_per_u_hB = t4 * (t10 - t3 * w_platform_y_per_u_hB);
    let t37 = t4 * (t3 * w_platform_y_per_u_hC);
    let u_psiB_per_u_hC = t33 * (t36 * t37 - w_platform_y_per_u_hC * t35 - t23);
    let u_psiB = u_hA * u_psiB_per_u_hA - u_hB * (t33 * (w_platform_y_per_u_hB * t35 + w_platform_x_per_u_hB * t36 - t18)) + u_hC * u_psiB_per_u_hC;
    let t38 = t25 + Ic2 * (t32 * t32) + (sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB)) * (u_psiB * u_psiB);
    let t39 = 1.0_f64 / cos_thB;
    let t40 = 0.5_f64 * t10;
    let t41 = 0.8660254037844386_f64 * t10;
    let t42 = t19 * t40;
    let t43 = w_platform_x_per_u_hA * t41;
    let u_thB_per_u_hA = t39 * (t27 + (t42 - t43));
    let t44 = u_hB * (t39 * (t17 * t34 + (w_platform_y_per_u_hB * t40 + w_platform_x_per_u_hB * t41))) - u_hA * u_thB_per_u_hA;
    let t45 = w_platform_y_per_u_hC * t40;
    let t46 = t37 * t41;
    let t47 = t45 - t46 - t17 * t30;
    let t48 = t44 + u_hC * (t39 * t47);
    let t49 = 1.0_f64 / (cos_thC * cos_thC);
    let t50 = 0.5_f64 * t30;
    let t51 = 0.8660254037844386_f64 * t30;
    let u_psiC_per_u_hC = t49 * (w_platform_y_per_u_hC * t50 + t37 * t51 - t23);
    let u_psiC_per_u_hB = t49 * (t18 - (w_platform_x_per_u_hB * t51 - w_platform_y_per_u_hB * t50));
    let u_psiC = u_hC * u_psiC_per_u_hC - (u_hA * (t49 * (t21 + (t19 * t50 + w_platform_x_per_u_hA * t51))) - u_hB * u_psiC_per_u_hB);
    let t52 = t38 + Ic2 * (t48 * t48) + (sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC)) * (u_psiC * u_psiC);
    let t53 = 1.0_f64 / cos_thC;
    let t54 = u_hB * (t53 * t47) + u_hA * (t53 * (t31 - (t42 + t43))) + u_hC * (t53 * (t22 * t30 + (t45 + t46)));
    let Ix = p.Ix;
    let w_platform_x = u_hB * w_platform_x_per_u_hB + u_hA * w_platform_x_per_u_hA - u_hC * t37;
    let Iy = p.Iy;
    let w_platform_y = u_hB * w_platform_y_per_u_hB - u_hA * t19 + u_hC * w_platform_y_per_u_hC;
    let t55 = t52 + Ic2 * (t54 * t54) + Ix * (w_platform_x * w_platform_x) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let t56 = u_hA * t20 - u_hB * t17 + u_hC * t22;
    let M = p.M;
    let t57 = 2.0_f64 * sB;
    let t58 = sA + t57;
    let u_sA_per_u_hC = 0.5773502691896257_f64 * (t22 * t58);
    let v_G_y_per_u_hA = sA * t20 - t13;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * (t17 * t58 - t16);
    let t59 = u_hC * u_sA_per_u_hC + (u_hA * (0.5773502691896257_f64 * (t57 * t20 + v_G_y_per_u_hA)) - u_hB * v_G_x_per_u_hB);
    let v_G_y_per_u_hC = sA * t22;
    let v_G_y = u_hC * v_G_y_per_u_hC - (u_hB * (sA * t17) - u_hA * v_G_y_per_u_hA);
    let t60 = t55 + Iz * (t56 * t56) + M * (t59 * t59) + M * (v_G_y * v_G_y);
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let v_G_z_per_u_hA = t10 - sA * t19;
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let v_G_z = u_hB * v_G_z_per_u_hB + u_hA * v_G_z_per_u_hA + u_hC * v_G_z_per_u_hC;
    let t61 = 0.5_f64 * (t60 + M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t62 = hA * g;
    let hC = q[8];
    let t63 = ms + mc;
    let hB = q[4];
    let t64 = hB * g;
    let t65 = M * (t62 + sA * (g * sin_thA)) + (hC * g * t63 + (mc * t64 + (ms * t64 + t62 * t63)));
    (t61, t65)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///236 operations.
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
    let u_hB = u[1];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let t1 = 1.0_f64 / (cos_thA * cos_thA);
    let sA = q[3];
    let sC = q[11];
    let sB = q[7];
    let t2 = sA + 0.5_f64 * sB;
    let t3 = 0.8660254037844386_f64 * sC;
    let t4 = 0.8660254037844386_f64 * sB;
    let t5 = 1.0_f64 / t4;
    let t6 = t3 * t5;
    let t7 = 1.0_f64 / (sA + 0.5_f64 * sC + t2 * t6);
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t8 = cos_thA * sin_psiA;
    let t9 = cos_thA * cos_psiA;
    let t10 = cos_psiB * (0.5_f64 * t8 + 0.8660254037844386_f64 * t9) + sin_psiB * (0.8660254037844386_f64 * t8 - 0.5_f64 * t9);
    let t11 = cos_thB * (1.1547005383792515_f64 * t10);
    let t12 = t6 * t11;
    let w_platform_y_per_u_hB = t7 * t12;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t13 = sin_thB - sin_thC;
    let t14 = 0.5773502691896257_f64 * t13;
    let t15 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC)));
    let t16 = 1.7320508075688772_f64 * sin_thA;
    let t17 = t16 + t14;
    let t18 = t15 * t17;
    let t19 = t11 * t18;
    let t20 = t7 * (t11 + t12);
    let t21 = t15 * (1.1547005383792515_f64 * t13);
    let t22 = t11 * t21;
    let u_psiA_per_u_hA = t1 * (t14 * t20 - t22);
    let u_hC = u[2];
    let w_platform_y_per_u_hC = t7 * t11;
    let t23 = t15 * (t16 - t14);
    let t24 = t11 * t23;
    let t25 = u_hB * (t1 * (w_platform_y_per_u_hB * t14 - t19)) - u_hA * u_psiA_per_u_hA + u_hC * (t1 * (t14 * w_platform_y_per_u_hC + t24));
    let t26 = 1.0_f64 / cos_thA;
    let t27 = t14 * t18;
    let u_thA_per_u_hB = t26 * (t11 * w_platform_y_per_u_hB + t27);
    let t28 = 0.8660254037844386_f64 * sin_thA;
    let t29 = 0.28867513459481287_f64 * t13;
    let t30 = t28 - t29;
    let t31 = t21 * t30;
    let t32 = u_hA * (t26 * (t14 * t21 + t11 * t20)) - u_hB * u_thA_per_u_hB + u_hC * (t26 * (t31 - t11 * w_platform_y_per_u_hC));
    let t33 = 2.0_f64 * sB;
    let t34 = sA + t33;
    let u_sA_per_u_hC = 0.5773502691896257_f64 * (t23 * t34);
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * (t18 * t34 - t17);
    let v_G_y_per_u_hA = sA * t21 - t14;
    let t35 = 0.5773502691896257_f64 * (t33 * t21 + v_G_y_per_u_hA);
    let u_sA = u_hC * u_sA_per_u_hC - (u_hB * v_G_x_per_u_hB + u_hA * (sin_thA - t35));
    let t36 = 1.0_f64 / (cos_thB * cos_thB);
    let t37 = t28 + t29;
    let t38 = 0.5_f64 * t37;
    let t39 = 0.8660254037844386_f64 * t37;
    let w_platform_x_per_u_hA = t5 * (t2 * t20 - t11);
    let u_psiB_per_u_hA = t36 * (t20 * t38 - t39 * w_platform_x_per_u_hA - t22);
    let w_platform_x_per_u_hB = t5 * (t11 - t2 * w_platform_y_per_u_hB);
    let t40 = t5 * (t2 * w_platform_y_per_u_hC);
    let u_psiB_per_u_hC = t36 * (t39 * t40 - w_platform_y_per_u_hC * t38 - t24);
    let u_psiB = u_hA * u_psiB_per_u_hA - u_hB * (t36 * (w_platform_y_per_u_hB * t38 + w_platform_x_per_u_hB * t39 - t19)) + u_hC * u_psiB_per_u_hC;
    let t41 = 1.0_f64 / cos_thB;
    let t42 = 0.5_f64 * t11;
    let t43 = 0.8660254037844386_f64 * t11;
    let t44 = t20 * t42;
    let t45 = w_platform_x_per_u_hA * t43;
    let u_thB_per_u_hA = t41 * (t27 + (t44 - t45));
    let t46 = u_hB * (t41 * (t18 * t37 + (w_platform_y_per_u_hB * t42 + w_platform_x_per_u_hB * t43))) - u_hA * u_thB_per_u_hA;
    let t47 = w_platform_y_per_u_hC * t42;
    let t48 = t40 * t43;
    let t49 = t47 - t48 - t18 * t30;
    let u_sB_per_u_hB = 2.0_f64 * (v_G_x_per_u_hB + (sin_thA - t4 * t18));
    let u_sB = u_hB * u_sB_per_u_hB + u_hA * (2.0_f64 * (t4 * t21 - t35)) + u_hC * (2.0_f64 * (t4 * t23 - u_sA_per_u_hC));
    let t50 = 1.0_f64 / (cos_thC * cos_thC);
    let t51 = 0.5_f64 * t30;
    let t52 = 0.8660254037844386_f64 * t30;
    let u_psiC_per_u_hC = t50 * (w_platform_y_per_u_hC * t51 + t40 * t52 - t24);
    let u_psiC_per_u_hB = t50 * (t19 - (w_platform_x_per_u_hB * t52 - w_platform_y_per_u_hB * t51));
    let u_psiC = u_hC * u_psiC_per_u_hC - (u_hA * (t50 * (t22 + (t20 * t51 + w_platform_x_per_u_hA * t52))) - u_hB * u_psiC_per_u_hB);
    let t53 = 1.0_f64 / cos_thC;
    let t54 = u_hB * (t53 * t49) + u_hA * (t53 * (t31 - (t44 + t45))) + u_hC * (t53 * (t23 * t30 + (t47 + t48)));
    let t55 = u_hA * (2.0_f64 * (t35 + t3 * t21)) - u_hB * (2.0_f64 * (v_G_x_per_u_hB + t3 * t18));
    [u_hA, -t25, -t32, u_sA, u_hB, u_psiB, -(t46 + u_hC * (t41 * t49)), u_sB, u_hC, u_psiC, -t54, -(t55 + u_hC * (2.0_f64 * (u_sA_per_u_hC + (t3 * t23 - sin_thA))))]
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
///373 operations.
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
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t1 = sin_thB - sin_thC;
    let t2 = 0.5773502691896257_f64 * t1;
    let sA = q[3];
    let sC = q[11];
    let t3 = 0.5_f64 * sC;
    let sB = q[7];
    let t4 = 0.5_f64 * sB;
    let t5 = sA + t4;
    let t6 = 0.8660254037844386_f64 * sC;
    let t7 = 0.8660254037844386_f64 * sB;
    let t8 = 1.0_f64 / t7;
    let t9 = t6 * t8;
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
    let t17 = 1.1547005383792515_f64 * (cos_psiB * t13 + sin_psiB * t16);
    let t18 = cos_thB * t17;
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
    let t26 = t10 * t2 - sin_thA * t25;
    let t27 = cos_thC * sin_psiC;
    let t28 = t22 * cos_psiB + cos_thB * sin_psiB;
    let t29 = t19 * cos_psiC;
    let t30 = t27 + (t28 - t29);
    let t31 = 0.5_f64 * t30;
    let t32 = sin_thA * t31 + t12 * t2;
    let t33 = t12 * t25 + t10 * t31;
    let t34 = 1.0_f64 / Real::sqrt(t26 * t26 + t32 * t32 + t33 * t33);
    let t35 = t26 * t34;
    let t36 = t32 * t34;
    let t37 = t10 * t35 + t12 * t36;
    let hB = q[4];
    let t38 = hA + (sin_thA * t4 - t7 * t37 - hB);
    let R = p.R;
    let t39 = 1.1547005383792515_f64 * (sin_thB * (cos_psiB * t16 - sin_psiB * t13) - sin_thA * cos_thB);
    let t40 = sin_thB * t17;
    let t41 = sin_psiB * t39 - cos_psiB * t40;
    let t42 = t33 * t34;
    let t43 = sin_thA * t35 - t12 * t42;
    let t44 = t7 * t43 + t10 * t4;
    let t45 = cos_psiB * t39 + sin_psiB * t40;
    let t46 = 0.5_f64 * t45 + 0.8660254037844386_f64 * t41;
    let t47 = sin_thA * t36 + t10 * t42;
    let t48 = R - (t7 * t47 + t12 * t4);
    let t49 = 0.8660254037844386_f64 * t45 - 0.5_f64 * t41;
    let t50 = t18 * t38 + R * t41 + t44 * t46 - t48 * t49;
    let hC = q[8];
    let t51 = hC - (t6 * t37 + sin_thA * t3) - hA;
    let t52 = t6 * t43 - t10 * t3;
    let t53 = R - (t12 * t3 - t6 * t47);
    let t54 = t18 * t51 + t46 * t52 + t49 * t53 + R * (0.5_f64 * t49 + 0.8660254037844386_f64 * t46);
    let t55 = 1.0_f64 / (sA + t3 + t5 * t9) * (t9 * t50 - t54);
    let t56 = R * (t14 + t15) - sA + sin_thA * t51 + t10 * t52 + t12 * t53;
    let t57 = 0.4330127018922193_f64 * t24;
    let t58 = 0.25_f64 * t30;
    let t59 = sA * (cos_thA * (sin_psiA * t25 - cos_psiA * t31) + sin_thA * t2);
    let t60 = R * t16 - (t12 * t48 - (sin_thA * t38 + t10 * t44) - sA);
    let t61 = R * (t58 + t57) + t59 + t2 * t38 + t25 * t44 + 1.7320508075688772_f64 * t60;
    let t62 = t61 + t31 * t48;
    let t63 = 1.7320508075688772_f64 * t56 - (R * (t57 - t58) - t62 - t59 + t2 * t51 + t25 * t52);
    let t64 = sA * sin_thA;
    let t65 = sA * t12;
    let t66 = sA * t10;
    let t67 = t64 * t2 - (t65 * t31 - t66 * t25) - t59;
    let t68 = 1.0_f64 / (2.0_f64 * (sA + (sB + sC))) * (t63 + 2.0_f64 * t67 + t31 * t53);
    let t69 = t18 * t68;
    let t70 = 1.0_f64 / (cos_thA * cos_thA) * (t2 * t55 - t69);
    let t71 = 0.5773502691896257_f64 * ((sA + 2.0_f64 * sB) * t68 - (t62 + t67));
    let t72 = t71 + (sA - (t12 * t65 + t10 * t66 + sin_thA * t64));
    let t73 = 0.8660254037844386_f64 * sin_thA;
    let t74 = 0.28867513459481287_f64 * t1;
    let t75 = t73 + t74;
    let t76 = 0.8660254037844386_f64 * t47;
    let t77 = 0.8660254037844386_f64 * t23;
    let t78 = 0.8660254037844386_f64 * t43;
    let t79 = 0.8660254037844386_f64 * t28;
    let t80 = t8 * (t5 * t55 - t50);
    let t81 = 0.5_f64 * t75 * t55 + ((t15 + t76) * t77 + (t11 + t78) * t79 - 0.8660254037844386_f64 * t75 * t80);
    let t82 = 0.5_f64 * t18 * t55;
    let t83 = 0.8660254037844386_f64 * t18 * t80;
    let t84 = 0.5_f64 * sin_thA;
    let t85 = 0.8660254037844386_f64 * t37;
    let t86 = 1.0_f64 / cos_thB * (t75 * t68 + (t82 - (t83 + (sin_thB + (t84 - t85)))));
    let t87 = t73 - t74;
    let t88 = 0.8660254037844386_f64 * (t29 - t27);
    let t89 = 0.8660254037844386_f64 * (t20 + t21);
    let t90 = 0.5_f64 * t87 * t55 + (0.8660254037844386_f64 * t87 * t80 + ((t78 - t11) * t88 - (t76 - t15) * t89));
    let t91 = sA * cos_thA;
    let t92 = sin_psiA * t91;
    let t93 = sB * cos_thB;
    let t94 = sin_psiB * t93;
    let t95 = cos_psiB * t93;
    let t96 = R - cos_psiA * t91 + 0.5_f64 * R;
    let t97 = Real::max(Real::abs(t92 + 0.5_f64 * t94 + 0.8660254037844386_f64 * (R - t95)), Real::abs(t96 - (0.5_f64 * t95 + 0.8660254037844386_f64 * t94)));
    let t98 = sC * cos_thC;
    let t99 = sin_psiC * t98;
    let t100 = cos_psiC * t98;
    let t101 = Real::max(Real::max(t97, Real::abs(hA - hB + t64 - sB * sin_thB)), Real::abs(t92 + 0.5_f64 * t99 + 0.8660254037844386_f64 * (t100 - R)));
    let t102 = Real::max(Real::max(t101, Real::abs(t96 + (0.8660254037844386_f64 * t99 - 0.5_f64 * t100))), Real::abs(sC * sin_thC + (hC - hA - t64)));
    let t103 = Real::max(Real::max(Real::max(t102, Real::abs(t10 + t77 - t89)), Real::abs(t88 - (t12 - t79))), Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t70, -1.0_f64 / cos_thA * (t2 * t68 + t18 * t55), t72, -1.0_f64 / (cos_thB * cos_thB) * (t69 - t81), t86, -2.0_f64 * (t71 - (t7 * t68 - t60)), -1.0_f64 / (cos_thC * cos_thC) * (t69 + t90), -1.0_f64 / cos_thC * (t87 * t68 - (t82 - (sin_thC + (t84 + t85) - t83))), -2.0_f64 * (t71 - (t56 - t6 * t68))], t103)
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
