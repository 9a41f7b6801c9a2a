// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Cost of rates: 898 operations (12 abs, 174 add, 5 cos, 12 div, 11 min, 532 mul, 5 sin, 147 sub).
// Cost of energy: 340 operations (67 add, 5 cos, 9 div, 218 mul, 5 sin, 36 sub).
// Cost of speeds: 247 operations (41 add, 5 cos, 9 div, 149 mul, 5 sin, 38 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 445 operations (9 abs, 82 add, 6 cos, 11 div, 8 max, 232 mul, 6 sin, 2 sqrt, 89 sub).

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
///898 operations.
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
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t1 = cos_thA * sin_psiA;
    let t2 = cos_thA * cos_psiA;
    let t3 = cos_psiB * (0.5_f64 * t1 + 0.8660254037844386_f64 * t2) - sin_psiB * (0.5_f64 * t2 - 0.8660254037844386_f64 * t1);
    let t4 = cos_thB * (1.1547005383792515_f64 * t3);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t5 = 0.5773502691896257_f64 * sin_thC;
    let t6 = 0.5773502691896257_f64 * sin_thB;
    let t7 = t5 - t6;
    let sB = q[7];
    let t8 = 2.0_f64 * sB;
    let sC = q[11];
    let sA = q[3];
    let t9 = t8 + 2.0_f64 * sC + 2.0_f64 * sA;
    let t10 = 1.0_f64 / t9;
    let w_platform_z_per_u_hA = 2.0_f64 * t7 * t10;
    let t11 = t4 * w_platform_z_per_u_hA;
    let t12 = t6 - t5;
    let t13 = 0.8660254037844386_f64 * sB;
    let t14 = 0.8660254037844386_f64 * sC;
    let t15 = 1.0_f64 / t14;
    let t16 = t13 * t15;
    let t17 = t4 * t16;
    let t18 = 0.5_f64 * sB;
    let t19 = 0.5_f64 * sC;
    let t20 = sA + t19;
    let t21 = sA + t18 + t20 * t16;
    let t22 = 1.0_f64 / t21;
    let t23 = (t4 + t17) * t22;
    let t24 = cos_thA * cos_thA;
    let t25 = 1.0_f64 / t24;
    let u_psiA_per_u_hA = (t11 + t12 * t23) * t25;
    let u_hB = u[1];
    let t26 = 1.7320508075688772_f64 * sin_thA;
    let t27 = t7 - t26;
    let t28 = t27 * t10;
    let t29 = t4 * t28;
    let w_platform_y_per_u_hB = t4 * t22;
    let t30 = (t29 + t12 * w_platform_y_per_u_hB) * t25;
    let u_hC = u[2];
    let t31 = (t7 + t26) * t10;
    let t32 = t4 * t31;
    let w_platform_y_per_u_hC = t17 * t22;
    let t33 = (t32 + t12 * w_platform_y_per_u_hC) * t25;
    let u_psiA = u_hA * u_psiA_per_u_hA - u_hB * t30 - u_hC * t33;
    let t34 = 1.0_f64 / cos_thA;
    let u_thA_per_u_hC = (t4 * w_platform_y_per_u_hC + t7 * t31) * t34;
    let u_thA_per_u_hB = (t4 * w_platform_y_per_u_hB + t7 * t28) * t34;
    let t35 = (t4 * t23 + t7 * w_platform_z_per_u_hA) * t34;
    let u_thA = u_hC * u_thA_per_u_hC + (u_hB * u_thA_per_u_hB - u_hA * t35);
    let v_G_y_per_u_hC = sA * t31;
    let u_sA_per_u_hC = 0.5773502691896257_f64 * (v_G_y_per_u_hC + t8 * t31);
    let v_G_y_per_u_hA = t7 - sA * w_platform_z_per_u_hA;
    let v_G_x_per_u_hA = 0.5773502691896257_f64 * (t8 * w_platform_z_per_u_hA - v_G_y_per_u_hA);
    let v_G_y_per_u_hB = sA * t28;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * (t27 - t8 * t28 - v_G_y_per_u_hB);
    let u_sA = u_hC * u_sA_per_u_hC - (u_hA * (sin_thA + v_G_x_per_u_hA) + u_hB * v_G_x_per_u_hB);
    let t36 = 0.8660254037844386_f64 * sin_thA;
    let t37 = 0.5_f64 * t7;
    let t38 = t36 - t37;
    let t39 = 0.8660254037844386_f64 * t38;
    let t40 = t15 * (t4 - t20 * w_platform_y_per_u_hC);
    let t41 = 0.5_f64 * t38;
    let t42 = cos_thB * cos_thB;
    let t43 = 1.0_f64 / t42;
    let u_psiB_per_u_hC = (t39 * t40 - t41 * w_platform_y_per_u_hC - t32) * t43;
    let t44 = t15 * (t20 * t23 - t4);
    let u_psiB_per_u_hA = (t11 + (t39 * t44 + t41 * t23)) * t43;
    let w_platform_x_per_u_hB = t15 * (t20 * w_platform_y_per_u_hB);
    let t45 = (t29 + (t39 * w_platform_x_per_u_hB + t41 * w_platform_y_per_u_hB)) * t43;
    let u_psiB = u_hC * u_psiB_per_u_hC + (u_hA * u_psiB_per_u_hA - u_hB * t45);
    let t46 = 0.8660254037844386_f64 * t4;
    let t47 = t46 * t40;
    let t48 = 0.5_f64 * t4;
    let t49 = t48 * w_platform_y_per_u_hC;
    let t50 = 1.0_f64 / cos_thB;
    let u_thB_per_u_hC = (t47 - t49 + t38 * t31) * t50;
    let t51 = t46 * t44;
    let t52 = t48 * t23;
    let u_thB_per_u_hA = (t51 + t52 - t38 * w_platform_z_per_u_hA) * t50;
    let t53 = t46 * w_platform_x_per_u_hB;
    let t54 = t48 * w_platform_y_per_u_hB;
    let u_thB_per_u_hB = (t38 * t28 - (t53 + t54)) * t50;
    let u_thB = u_hC * u_thB_per_u_hC + (u_hA * u_thB_per_u_hA + u_hB * u_thB_per_u_hB);
    let u_sB_per_u_hB = 2.0_f64 * (v_G_x_per_u_hB + (sin_thA + t13 * t28));
    let u_sB = u_hB * u_sB_per_u_hB - u_hA * (2.0_f64 * (t13 * w_platform_z_per_u_hA - v_G_x_per_u_hA)) - u_hC * (2.0_f64 * (u_sA_per_u_hC - t13 * t31));
    let t55 = t36 + t37;
    let t56 = 0.8660254037844386_f64 * t55;
    let t57 = 0.5_f64 * t55;
    let t58 = cos_thC * cos_thC;
    let t59 = 1.0_f64 / t58;
    let u_psiC_per_u_hC = (t56 * t40 + t57 * w_platform_y_per_u_hC - t32) * t59;
    let u_psiC_per_u_hA = (t56 * t44 - t57 * t23 + t11) * t59;
    let u_psiC_per_u_hB = (t57 * w_platform_y_per_u_hB - t56 * w_platform_x_per_u_hB - t29) * t59;
    let u_psiC = u_hC * u_psiC_per_u_hC + (u_hA * u_psiC_per_u_hA + u_hB * u_psiC_per_u_hB);
    let t60 = 1.0_f64 / cos_thC;
    let u_thC_per_u_hA = (t52 - t51 + t55 * w_platform_z_per_u_hA) * t60;
    let u_thC_per_u_hB = (t53 - t54 - t55 * t28) * t60;
    let t61 = (t47 + t49 + t55 * t31) * t60;
    let u_thC = u_hA * u_thC_per_u_hA + u_hB * u_thC_per_u_hB - u_hC * t61;
    let u_sC_per_u_hA = 2.0_f64 * (v_G_x_per_u_hA + t14 * w_platform_z_per_u_hA);
    let u_sC = u_hA * u_sC_per_u_hA - u_hB * (2.0_f64 * (t14 * t28 - v_G_x_per_u_hB)) - u_hC * (2.0_f64 * (u_sA_per_u_hC + (t14 * t31 - sin_thA)));
    let FA = inputs[0];
    let c = p.c;
    let ms = p.ms;
    let g = p.g;
    let mc = p.mc;
    let t62 = ms * g + mc * g;
    let Ic3 = p.Ic3;
    let Ic2 = p.Ic2;
    let t63 = Ic3 - Ic2;
    let t64 = cos_thA * u_psiA;
    let Ic1 = p.Ic1;
    let t65 = u_psiA * u_thA;
    let t66 = sin_thA * t65;
    let t67 = Ic2 - Ic1;
    let t68 = sin_thA * u_psiA;
    let t69 = u_thA * t68;
    let t70 = sin_thA * (t63 * (u_thA * t64) - Ic1 * (cos_thA * t65)) + cos_thA * (Ic3 * t66 + t67 * t69);
    let t71 = sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA);
    let w_platform_x = u_hB * w_platform_x_per_u_hB - u_hA * t44 - u_hC * t40;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * t28 - u_hC * t31;
    let t72 = w_platform_x * w_platform_z;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * t23);
    let t73 = w_platform_x * w_platform_y;
    let t74 = t18 * w_platform_z;
    let t75 = t13 * w_platform_z;
    let t76 = 0.8660254037844386_f64 * u_sB;
    let t77 = 0.5_f64 * u_sB;
    let t78 = 2.0_f64 * (u_sA * w_platform_y) - w_platform_x * (sA * w_platform_z);
    let t79 = w_platform_x * t74 - w_platform_y * t75 - 2.0_f64 * (w_platform_x * t76 + w_platform_y * t77) - t78;
    let t80 = 0.8660254037844386_f64 * u_sC;
    let t81 = 0.5_f64 * u_sC;
    let t82 = t19 * w_platform_z;
    let t83 = t14 * w_platform_z;
    let t84 = 2.0_f64 * (w_platform_x * t80 - w_platform_y * t81) + (w_platform_x * t82 + w_platform_y * t83) - t78;
    let w_platform_y_dot_bias = t22 * (t79 + t16 * t84);
    let t85 = t13 * w_platform_x + t18 * w_platform_y;
    let t86 = 2.0_f64 * (w_platform_z * t77) + (w_platform_z * t75 + w_platform_x * t85) + 1.7320508075688772_f64 * (2.0_f64 * (w_platform_z * t76) - (w_platform_y * t85 + w_platform_z * t74));
    let t87 = t14 * w_platform_x - t19 * w_platform_y;
    let t88 = 2.0_f64 * (w_platform_z * t81) - (w_platform_z * t83 + w_platform_x * t87) - 1.7320508075688772_f64 * (w_platform_y * t87 - w_platform_z * t82 - 2.0_f64 * (w_platform_z * t80));
    let t89 = 2.0_f64 * (u_sA * w_platform_z) + w_platform_x * (sA * w_platform_y);
    let t90 = t10 * (t86 + t88 + 2.0_f64 * t89);
    let t91 = t4 * t90;
    let t92 = cos_thA * (t66 + t69) - (t7 * t72 - t4 * t73) - t12 * w_platform_y_dot_bias - t91;
    let u_psiA_dot_bias = t25 * t92;
    let t93 = t70 - t71 * u_psiA_dot_bias;
    let t94 = Ic1 - Ic3;
    let t95 = t64 * t68;
    let t96 = cos_thA * t95 - sin_thA * (u_thA * u_thA + t64 * t64) + (t4 * t72 + (sin_thA * (w_platform_y * w_platform_y + w_platform_z * w_platform_z) + t7 * t73));
    let u_thA_dot_bias = t34 * (t4 * w_platform_y_dot_bias - t96 + t7 * t90);
    let t97 = t94 * t95 - Ic2 * u_thA_dot_bias;
    let t98 = cos_thB * u_psiB;
    let t99 = u_psiB * u_thB;
    let t100 = sin_thB * t99;
    let t101 = sin_thB * u_psiB;
    let t102 = u_thB * t101;
    let t103 = sin_thB * (t63 * (u_thB * t98) - Ic1 * (cos_thB * t99)) + cos_thB * (Ic3 * t100 + t67 * t102);
    let t104 = sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB);
    let t105 = 0.8660254037844386_f64 * w_platform_z;
    let t106 = w_platform_y * t105;
    let t107 = 0.5_f64 * w_platform_z;
    let t108 = w_platform_x * t107;
    let t109 = t106 - t108;
    let t110 = 0.8660254037844386_f64 * w_platform_x;
    let t111 = 0.5_f64 * w_platform_y;
    let t112 = t110 + t111;
    let t113 = w_platform_z * t107;
    let t114 = w_platform_y * t112 + t113;
    let t115 = w_platform_z * t105;
    let t116 = t115 + w_platform_x * t112;
    let t117 = t15 * (t84 - t20 * w_platform_y_dot_bias);
    let t118 = cos_thB * (t100 + t102) - (t38 * t109 + (t46 * t114 - t48 * t116)) + t39 * t117;
    let u_psiB_dot_bias = t43 * (t118 - t41 * w_platform_y_dot_bias - t91);
    let t119 = t103 - t104 * u_psiB_dot_bias;
    let t120 = FA - u_hA * c - t62 + u_psiA_per_u_hA * t93 - t35 * t97 + u_psiB_per_u_hA * t119;
    let t121 = t98 * t101;
    let t122 = t46 * t117;
    let t123 = cos_thB * t121 - sin_thB * (u_thB * u_thB + t98 * t98) + (t4 * t109 - (sin_thA * t114 + t7 * t116));
    let t124 = t48 * w_platform_y_dot_bias;
    let u_thB_dot_bias = t50 * (t122 - t123 - t124 + t38 * t90);
    let t125 = t94 * t121 - Ic2 * u_thB_dot_bias;
    let t126 = cos_thC * u_psiC;
    let t127 = u_psiC * u_thC;
    let t128 = sin_thC * t127;
    let t129 = sin_thC * u_psiC;
    let t130 = u_thC * t129;
    let t131 = sin_thC * (t63 * (u_thC * t126) - Ic1 * (cos_thC * t127)) + cos_thC * (Ic3 * t128 + t67 * t130);
    let t132 = sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC);
    let t133 = t108 + t106;
    let t134 = t110 - t111;
    let t135 = t115 + w_platform_x * t134;
    let t136 = t113 - w_platform_y * t134;
    let t137 = cos_thC * (t128 + t130) - (t55 * t133 + (t48 * t135 - t46 * t136)) + t56 * t117;
    let u_psiC_dot_bias = t59 * (t137 + t57 * w_platform_y_dot_bias - t91);
    let t138 = t131 - t132 * u_psiC_dot_bias;
    let t139 = t126 * t129;
    let t140 = cos_thC * t139 - sin_thC * (u_thC * u_thC + t126 * t126) + (t7 * t135 - sin_thA * t136 - t4 * t133);
    let t141 = t94 * t139 + Ic2 * (t60 * (t140 + t122 + t124 + t55 * t90));
    let Ix = p.Ix;
    let Iz = p.Iz;
    let Iy = p.Iy;
    let t142 = Ix * t117 - (Iz - Iy) * (w_platform_y * w_platform_z);
    let t143 = (Ix - Iz) * t72 + Iy * w_platform_y_dot_bias;
    let t144 = t120 + u_thB_per_u_hA * t125 + u_psiC_per_u_hA * t138 + u_thC_per_u_hA * t141 - t44 * t142 + t23 * t143;
    let t145 = Iz * t90 - (Iy - Ix) * t73;
    let M = p.M;
    let t146 = M * g;
    let v_G_y_dot_bias = sA * t90 - t89;
    let v_G_x_dot_bias = 0.5773502691896257_f64 * (t86 - t8 * t90 - v_G_y_dot_bias);
    let t147 = sin_thA * t146 - M * v_G_x_dot_bias;
    let t148 = t7 * t146 + M * v_G_y_dot_bias;
    let v_G_z_per_u_hA = t4 - sA * t23;
    let v_G_z_dot_bias = t78 + sA * w_platform_y_dot_bias;
    let t149 = t4 * t146 + M * v_G_z_dot_bias;
    let forcing_u_hA = t144 + w_platform_z_per_u_hA * t145 + v_G_x_per_u_hA * t147 - v_G_y_per_u_hA * t148 - v_G_z_per_u_hA * t149;
    let mr = p.mr;
    let t150 = mc + (ms + mr);
    let t151 = t150 + u_psiA_per_u_hA * (t71 * u_psiA_per_u_hA) + t35 * (Ic2 * t35) + u_psiB_per_u_hA * (t104 * u_psiB_per_u_hA);
    let t152 = t151 + u_thB_per_u_hA * (Ic2 * u_thB_per_u_hA) + u_psiC_per_u_hA * (t132 * u_psiC_per_u_hA) + u_thC_per_u_hA * (Ic2 * u_thC_per_u_hA);
    let t153 = t152 + t44 * (Ix * t44) + t23 * (Iy * t23) + w_platform_z_per_u_hA * (Iz * w_platform_z_per_u_hA);
    let mass_u_hA_u_hA = t153 + v_G_x_per_u_hA * (M * v_G_x_per_u_hA) + v_G_y_per_u_hA * (M * v_G_y_per_u_hA) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let t154 = 1.0_f64 / mass_u_hA_u_hA;
    let t155 = Ic2 * u_thB_per_u_hB;
    let t156 = t71 * t30;
    let t157 = Ic2 * u_thA_per_u_hB;
    let t158 = t104 * t45;
    let t159 = t132 * u_psiC_per_u_hB;
    let t160 = u_thB_per_u_hA * t155 - (u_psiA_per_u_hA * t156 + t35 * t157 + u_psiB_per_u_hA * t158) + u_psiC_per_u_hA * t159;
    let t161 = Ic2 * u_thC_per_u_hB;
    let t162 = Ix * w_platform_x_per_u_hB;
    let t163 = Iy * w_platform_y_per_u_hB;
    let t164 = Iz * t28;
    let t165 = M * v_G_x_per_u_hB;
    let t166 = t160 + u_thC_per_u_hA * t161 - t44 * t162 - t23 * t163 - w_platform_z_per_u_hA * t164 + v_G_x_per_u_hA * t165;
    let t167 = M * v_G_y_per_u_hB;
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let t168 = M * v_G_z_per_u_hB;
    let mass_u_hA_u_hB = t166 + v_G_y_per_u_hA * t167 + v_G_z_per_u_hA * t168;
    let t169 = mass_u_hA_u_hB * t154;
    let t170 = t150 + (t30 * t156 + u_thA_per_u_hB * t157) + t45 * t158 + u_thB_per_u_hB * t155 + u_psiC_per_u_hB * t159;
    let t171 = t170 + u_thC_per_u_hB * t161 + w_platform_x_per_u_hB * t162 + w_platform_y_per_u_hB * t163 + t28 * t164 + v_G_x_per_u_hB * t165;
    let mass_u_hB_u_hB = t171 + v_G_y_per_u_hB * t167 + v_G_z_per_u_hB * t168;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t169;
    let t172 = 1.0_f64 / pivot_1;
    let FB = inputs[1];
    let t173 = FB - u_hB * c - t62 + (u_thA_per_u_hB * t97 - t30 * t93) - t45 * t119;
    let t174 = t173 + u_thB_per_u_hB * t125 + u_psiC_per_u_hB * t138 + u_thC_per_u_hB * t141 + w_platform_x_per_u_hB * t142 - w_platform_y_per_u_hB * t143;
    let forcing_u_hB = t174 - t28 * t145 + v_G_x_per_u_hB * t147 - v_G_y_per_u_hB * t148 - v_G_z_per_u_hB * t149;
    let t175 = forcing_u_hB - forcing_u_hA * t169;
    let t176 = t71 * t33;
    let t177 = Ic2 * u_thA_per_u_hC;
    let t178 = t104 * u_psiB_per_u_hC;
    let t179 = Ic2 * u_thB_per_u_hC;
    let t180 = t132 * u_psiC_per_u_hC;
    let t181 = t30 * t176 + u_thA_per_u_hB * t177 - t45 * t178 + u_thB_per_u_hB * t179 + u_psiC_per_u_hB * t180;
    let t182 = Ic2 * t61;
    let t183 = Ix * t40;
    let t184 = Iy * w_platform_y_per_u_hC;
    let t185 = Iz * t31;
    let t186 = M * u_sA_per_u_hC;
    let t187 = t181 - u_thC_per_u_hB * t182 - w_platform_x_per_u_hB * t183 + w_platform_y_per_u_hB * t184 + t28 * t185 - v_G_x_per_u_hB * t186;
    let t188 = M * v_G_y_per_u_hC;
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let t189 = M * v_G_z_per_u_hC;
    let mass_u_hB_u_hC = t187 + v_G_y_per_u_hB * t188 + v_G_z_per_u_hB * t189;
    let t190 = u_psiB_per_u_hA * t178 - (u_psiA_per_u_hA * t176 + t35 * t177) + u_thB_per_u_hA * t179 + u_psiC_per_u_hA * t180;
    let t191 = t190 - u_thC_per_u_hA * t182 + t44 * t183 - t23 * t184 - w_platform_z_per_u_hA * t185 - v_G_x_per_u_hA * t186;
    let mass_u_hA_u_hC = t191 + v_G_y_per_u_hA * t188 + v_G_z_per_u_hA * t189;
    let t192 = mass_u_hB_u_hC - mass_u_hA_u_hC * t169;
    let t193 = t192 * t172;
    let FC = inputs[2];
    let t194 = FC - u_hC * c - t62 + (u_thA_per_u_hC * t97 - t33 * t93 + u_psiB_per_u_hC * t119 + u_thB_per_u_hC * t125);
    let t195 = t194 + u_psiC_per_u_hC * t138 - t61 * t141 - t40 * t142 - w_platform_y_per_u_hC * t143 - t31 * t145;
    let forcing_u_hC = t195 - u_sA_per_u_hC * t147 - v_G_y_per_u_hC * t148 - v_G_z_per_u_hC * t149;
    let t196 = mass_u_hA_u_hC * t154;
    let t197 = t150 + (t33 * t176 + u_thA_per_u_hC * t177 + u_psiB_per_u_hC * t178 + u_thB_per_u_hC * t179) + u_psiC_per_u_hC * t180;
    let t198 = t197 + t61 * t182 + t40 * t183 + w_platform_y_per_u_hC * t184 + t31 * t185 + u_sA_per_u_hC * t186;
    let mass_u_hC_u_hC = t198 + v_G_y_per_u_hC * t188 + v_G_z_per_u_hC * t189;
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t196 - t192 * t193;
    let t199 = (forcing_u_hC - forcing_u_hA * t196 - t193 * t175) / pivot_2;
    let t200 = t172 * t175 - t193 * t199;
    let t201 = forcing_u_hA * t154 - t169 * t200 - t196 * t199;
    let t202 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t24)), Real::abs(t42));
    let t203 = Real::min(Real::min(Real::min(Real::min(t202, Real::abs(t58)), 0.8333333333333333_f64 * Real::abs(t9)), 5.773502691896257_f64 * Real::abs(t14)), 1.6666666666666665_f64 * Real::abs(t21));
    let t204 = Real::min(Real::min(Real::min(t203, 0.21652832912306028_f64 * Real::abs(mass_u_hA_u_hA)), 0.21680787182359307_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC], [t201, t200, t199], t204)
}
///Kinetic and potential energy (J).
///
///340 operations.
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
    let u_hC = u[2];
    let u_hB = u[1];
    let u_hA = u[0];
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t2 = cos_thA * sin_psiA;
    let t3 = cos_thA * cos_psiA;
    let t4 = cos_psiB * (0.5_f64 * t2 + 0.8660254037844386_f64 * t3) - sin_psiB * (0.5_f64 * t3 - 0.8660254037844386_f64 * t2);
    let t5 = cos_thB * (1.1547005383792515_f64 * t4);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t6 = 0.5773502691896257_f64 * sin_thC;
    let t7 = 0.5773502691896257_f64 * sin_thB;
    let t8 = t6 - t7;
    let sB = q[7];
    let t9 = 2.0_f64 * sB;
    let sC = q[11];
    let sA = q[3];
    let t10 = 1.0_f64 / (t9 + 2.0_f64 * sC + 2.0_f64 * sA);
    let w_platform_z_per_u_hA = 2.0_f64 * t8 * t10;
    let t11 = t5 * w_platform_z_per_u_hA;
    let t12 = t7 - t6;
    let t13 = 1.0_f64 / (0.8660254037844386_f64 * sC);
    let t14 = 0.8660254037844386_f64 * sB * t13;
    let t15 = t5 * t14;
    let t16 = sA + 0.5_f64 * sC;
    let t17 = 1.0_f64 / (sA + 0.5_f64 * sB + t16 * t14);
    let t18 = (t5 + t15) * t17;
    let t19 = 1.0_f64 / (cos_thA * cos_thA);
    let u_psiA_per_u_hA = (t11 + t12 * t18) * t19;
    let t20 = 1.7320508075688772_f64 * sin_thA;
    let t21 = t8 - t20;
    let t22 = t21 * t10;
    let t23 = t5 * t22;
    let w_platform_y_per_u_hB = t5 * t17;
    let t24 = (t8 + t20) * t10;
    let t25 = t5 * t24;
    let w_platform_y_per_u_hC = t15 * t17;
    let u_psiA = u_hA * u_psiA_per_u_hA - u_hB * ((t23 + t12 * w_platform_y_per_u_hB) * t19) - u_hC * ((t25 + t12 * w_platform_y_per_u_hC) * t19);
    let t26 = 0.5_f64 * (t1 * (u_hA * u_hA)) + 0.5_f64 * ((sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA)) * (u_psiA * u_psiA));
    let Ic2 = p.Ic2;
    let t27 = 1.0_f64 / cos_thA;
    let u_thA_per_u_hC = (t5 * w_platform_y_per_u_hC + t8 * t24) * t27;
    let u_thA_per_u_hB = (t5 * w_platform_y_per_u_hB + t8 * t22) * t27;
    let u_thA = u_hC * u_thA_per_u_hC + (u_hB * u_thA_per_u_hB - u_hA * ((t5 * t18 + t8 * w_platform_z_per_u_hA) * t27));
    let t28 = 0.8660254037844386_f64 * sin_thA;
    let t29 = 0.5_f64 * t8;
    let t30 = t28 - t29;
    let t31 = 0.8660254037844386_f64 * t30;
    let t32 = t13 * (t5 - t16 * w_platform_y_per_u_hC);
    let t33 = 0.5_f64 * t30;
    let t34 = 1.0_f64 / (cos_thB * cos_thB);
    let u_psiB_per_u_hC = (t31 * t32 - t33 * w_platform_y_per_u_hC - t25) * t34;
    let t35 = t13 * (t16 * t18 - t5);
    let u_psiB_per_u_hA = (t11 + (t31 * t35 + t33 * t18)) * t34;
    let w_platform_x_per_u_hB = t13 * (t16 * w_platform_y_per_u_hB);
    let u_psiB = u_hC * u_psiB_per_u_hC + (u_hA * u_psiB_per_u_hA - u_hB * ((t23 + (t31 * w_platform_x_per_u_hB + t33 * w_platform_y_per_u_hB)) * t34));
    let t36 = 0.5_f64 * (t1 * (u_hB * u_hB)) + (t26 + 0.5_f64 * (Ic2 * (u_thA * u_thA))) + 0.5_f64 * ((sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB)) * (u_psiB * u_psiB));
    let t37 = 0.8660254037844386_f64 * t5;
    let t38 = t37 * t32;
    let t39 = 0.5_f64 * t5;
    let t40 = t39 * w_platform_y_per_u_hC;
    let t41 = 1.0_f64 / cos_thB;
    let u_thB_per_u_hC = (t38 - t40 + t30 * t24) * t41;
    let t42 = t37 * t35;
    let t43 = t39 * t18;
    let u_thB_per_u_hA = (t42 + t43 - t30 * w_platform_z_per_u_hA) * t41;
    let t44 = t37 * w_platform_x_per_u_hB;
    let t45 = t39 * w_platform_y_per_u_hB;
    let u_thB_per_u_hB = (t30 * t22 - (t44 + t45)) * t41;
    let u_thB = u_hC * u_thB_per_u_hC + (u_hA * u_thB_per_u_hA + u_hB * u_thB_per_u_hB);
    let t46 = t28 + t29;
    let t47 = 0.8660254037844386_f64 * t46;
    let t48 = 0.5_f64 * t46;
    let t49 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_u_hC = (t47 * t32 + t48 * w_platform_y_per_u_hC - t25) * t49;
    let u_psiC_per_u_hA = (t47 * t35 - t48 * t18 + t11) * t49;
    let u_psiC_per_u_hB = (t48 * w_platform_y_per_u_hB - t47 * w_platform_x_per_u_hB - t23) * t49;
    let u_psiC = u_hC * u_psiC_per_u_hC + (u_hA * u_psiC_per_u_hA + u_hB * u_psiC_per_u_hB);
    let t50 = 0.5_f64 * (t1 * (u_hC * u_hC)) + (t36 + 0.5_f64 * (Ic2 * (u_thB * u_thB))) + 0.5_f64 * ((sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC)) * (u_psiC * u_psiC));
    let t51 = 1.0_f64 / cos_thC;
    let u_thC_per_u_hA = (t43 - t42 + t46 * w_platform_z_per_u_hA) * t51;
    let u_thC_per_u_hB = (t44 - t45 - t46 * t22) * t51;
    let u_thC = u_hA * u_thC_per_u_hA + u_hB * u_thC_per_u_hB - u_hC * ((t38 + t40 + t46 * t24) * t51);
    let Ix = p.Ix;
    let w_platform_x = u_hB * w_platform_x_per_u_hB - u_hA * t35 - u_hC * t32;
    let Iy = p.Iy;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * t18);
    let t52 = t50 + 0.5_f64 * (Ic2 * (u_thC * u_thC)) + 0.5_f64 * (Ix * (w_platform_x * w_platform_x)) + 0.5_f64 * (Iy * (w_platform_y * w_platform_y));
    let Iz = p.Iz;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * t22 - u_hC * t24;
    let M = p.M;
    let v_G_y_per_u_hB = sA * t22;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * (t21 - t9 * t22 - v_G_y_per_u_hB);
    let v_G_y_per_u_hA = t8 - sA * w_platform_z_per_u_hA;
    let v_G_x_per_u_hA = 0.5773502691896257_f64 * (t9 * w_platform_z_per_u_hA - v_G_y_per_u_hA);
    let v_G_y_per_u_hC = sA * t24;
    let u_sA_per_u_hC = 0.5773502691896257_f64 * (v_G_y_per_u_hC + t9 * t24);
    let v_G_x = u_hB * v_G_x_per_u_hB + u_hA * v_G_x_per_u_hA - u_hC * u_sA_per_u_hC;
    let v_G_y = u_hC * v_G_y_per_u_hC + (u_hA * v_G_y_per_u_hA + u_hB * v_G_y_per_u_hB);
    let t53 = t52 + 0.5_f64 * (Iz * (w_platform_z * w_platform_z)) + 0.5_f64 * (M * (v_G_x * v_G_x)) + 0.5_f64 * (M * (v_G_y * v_G_y));
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let v_G_z_per_u_hA = t5 - sA * t18;
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let v_G_z = u_hC * v_G_z_per_u_hC + (u_hA * v_G_z_per_u_hA + u_hB * v_G_z_per_u_hB);
    let t54 = t53 + 0.5_f64 * (M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t55 = hA * g;
    let hB = q[4];
    let t56 = hB * g;
    let hC = q[8];
    let t57 = hC * g;
    let t58 = ms * t55 + mc * t55 + ms * t56 + mc * t56 + ms * t57;
    let t59 = t58 + mc * t57 + M * (t55 + sA * (g * sin_thA));
    (t54, t59)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///247 operations.
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
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let thA = q[2];
    let (sin_thA, cos_thA) = Real::sin_cos(thA);
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t1 = cos_thA * sin_psiA;
    let t2 = cos_thA * cos_psiA;
    let t3 = cos_psiB * (0.5_f64 * t1 + 0.8660254037844386_f64 * t2) - sin_psiB * (0.5_f64 * t2 - 0.8660254037844386_f64 * t1);
    let t4 = cos_thB * (1.1547005383792515_f64 * t3);
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t5 = 0.5773502691896257_f64 * sin_thC;
    let t6 = 0.5773502691896257_f64 * sin_thB;
    let t7 = t5 - t6;
    let sB = q[7];
    let t8 = 2.0_f64 * sB;
    let sC = q[11];
    let sA = q[3];
    let t9 = 1.0_f64 / (t8 + 2.0_f64 * sC + 2.0_f64 * sA);
    let w_platform_z_per_u_hA = 2.0_f64 * t7 * t9;
    let t10 = t4 * w_platform_z_per_u_hA;
    let t11 = t6 - t5;
    let t12 = 0.8660254037844386_f64 * sB;
    let t13 = 0.8660254037844386_f64 * sC;
    let t14 = 1.0_f64 / t13;
    let t15 = t12 * t14;
    let t16 = t4 * t15;
    let t17 = sA + 0.5_f64 * sC;
    let t18 = 1.0_f64 / (sA + 0.5_f64 * sB + t17 * t15);
    let t19 = (t4 + t16) * t18;
    let t20 = 1.0_f64 / (cos_thA * cos_thA);
    let u_psiA_per_u_hA = (t10 + t11 * t19) * t20;
    let u_hB = u[1];
    let t21 = 1.7320508075688772_f64 * sin_thA;
    let t22 = t7 - t21;
    let t23 = t22 * t9;
    let t24 = t4 * t23;
    let w_platform_y_per_u_hB = t4 * t18;
    let u_hC = u[2];
    let t25 = (t7 + t21) * t9;
    let t26 = t4 * t25;
    let w_platform_y_per_u_hC = t16 * t18;
    let u_psiA = u_hA * u_psiA_per_u_hA - u_hB * ((t24 + t11 * w_platform_y_per_u_hB) * t20) - u_hC * ((t26 + t11 * w_platform_y_per_u_hC) * t20);
    let t27 = 1.0_f64 / cos_thA;
    let u_thA_per_u_hC = (t4 * w_platform_y_per_u_hC + t7 * t25) * t27;
    let u_thA_per_u_hB = (t4 * w_platform_y_per_u_hB + t7 * t23) * t27;
    let u_thA = u_hC * u_thA_per_u_hC + (u_hB * u_thA_per_u_hB - u_hA * ((t4 * t19 + t7 * w_platform_z_per_u_hA) * t27));
    let v_G_y_per_u_hC = sA * t25;
    let u_sA_per_u_hC = 0.5773502691896257_f64 * (v_G_y_per_u_hC + t8 * t25);
    let v_G_y_per_u_hA = t7 - sA * w_platform_z_per_u_hA;
    let v_G_x_per_u_hA = 0.5773502691896257_f64 * (t8 * w_platform_z_per_u_hA - v_G_y_per_u_hA);
    let v_G_y_per_u_hB = sA * t23;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * (t22 - t8 * t23 - v_G_y_per_u_hB);
    let u_sA = u_hC * u_sA_per_u_hC - (u_hA * (sin_thA + v_G_x_per_u_hA) + u_hB * v_G_x_per_u_hB);
    let t28 = 0.8660254037844386_f64 * sin_thA;
    let t29 = 0.5_f64 * t7;
    let t30 = t28 - t29;
    let t31 = 0.8660254037844386_f64 * t30;
    let t32 = t14 * (t4 - t17 * w_platform_y_per_u_hC);
    let t33 = 0.5_f64 * t30;
    let t34 = 1.0_f64 / (cos_thB * cos_thB);
    let u_psiB_per_u_hC = (t31 * t32 - t33 * w_platform_y_per_u_hC - t26) * t34;
    let t35 = t14 * (t17 * t19 - t4);
    let u_psiB_per_u_hA = (t10 + (t31 * t35 + t33 * t19)) * t34;
    let w_platform_x_per_u_hB = t14 * (t17 * w_platform_y_per_u_hB);
    let u_psiB = u_hC * u_psiB_per_u_hC + (u_hA * u_psiB_per_u_hA - u_hB * ((t24 + (t31 * w_platform_x_per_u_hB + t33 * w_platform_y_per_u_hB)) * t34));
    let t36 = 0.8660254037844386_f64 * t4;
    let t37 = t36 * t32;
    let t38 = 0.5_f64 * t4;
    let t39 = t38 * w_platform_y_per_u_hC;
    let t40 = 1.0_f64 / cos_thB;
    let u_thB_per_u_hC = (t37 - t39 + t30 * t25) * t40;
    let t41 = t36 * t35;
    let t42 = t38 * t19;
    let u_thB_per_u_hA = (t41 + t42 - t30 * w_platform_z_per_u_hA) * t40;
    let t43 = t36 * w_platform_x_per_u_hB;
    let t44 = t38 * w_platform_y_per_u_hB;
    let u_thB_per_u_hB = (t30 * t23 - (t43 + t44)) * t40;
    let u_thB = u_hC * u_thB_per_u_hC + (u_hA * u_thB_per_u_hA + u_hB * u_thB_per_u_hB);
    let u_sB_per_u_hB = 2.0_f64 * (v_G_x_per_u_hB + (sin_thA + t12 * t23));
    let u_sB = u_hB * u_sB_per_u_hB - u_hA * (2.0_f64 * (t12 * w_platform_z_per_u_hA - v_G_x_per_u_hA)) - u_hC * (2.0_f64 * (u_sA_per_u_hC - t12 * t25));
    let t45 = t28 + t29;
    let t46 = 0.8660254037844386_f64 * t45;
    let t47 = 0.5_f64 * t45;
    let t48 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_u_hC = (t46 * t32 + t47 * w_platform_y_per_u_hC - t26) * t48;
    let u_psiC_per_u_hA = (t46 * t35 - t47 * t19 + t10) * t48;
    let u_psiC_per_u_hB = (t47 * w_platform_y_per_u_hB - t46 * w_platform_x_per_u_hB - t24) * t48;
    let u_psiC = u_hC * u_psiC_per_u_hC + (u_hA * u_psiC_per_u_hA + u_hB * u_psiC_per_u_hB);
    let t49 = 1.0_f64 / cos_thC;
    let u_thC_per_u_hA = (t42 - t41 + t45 * w_platform_z_per_u_hA) * t49;
    let u_thC_per_u_hB = (t43 - t44 - t45 * t23) * t49;
    let u_thC = u_hA * u_thC_per_u_hA + u_hB * u_thC_per_u_hB - u_hC * ((t37 + t39 + t45 * t25) * t49);
    let u_sC_per_u_hA = 2.0_f64 * (v_G_x_per_u_hA + t13 * w_platform_z_per_u_hA);
    let u_sC = u_hA * u_sC_per_u_hA - u_hB * (2.0_f64 * (t13 * t23 - v_G_x_per_u_hB)) - u_hC * (2.0_f64 * (u_sA_per_u_hC + (t13 * t25 - sin_thA)));
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC]
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
///445 operations.
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
    let psiA = q[1];
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t1 = cos_thA * cos_psiA;
    let t2 = cos_thA * sin_psiA;
    let t3 = sin_thA * sin_thA;
    let t4 = 1.0_f64 / Real::sqrt(t3 + (t2 * t2 + t1 * t1));
    let t5 = t2 * t4;
    let t6 = t1 * t4;
    let thB = q[6];
    let (sin_thB, cos_thB) = Real::sin_cos(thB);
    let t7 = 0.5773502691896257_f64 * sin_thB;
    let thC = q[10];
    let (sin_thC, cos_thC) = Real::sin_cos(thC);
    let t8 = 0.5773502691896257_f64 * sin_thC;
    let R = p.R;
    let psiB = q[5];
    let (sin_psiB, cos_psiB) = Real::sin_cos(psiB);
    let t9 = 0.5_f64 * t2 + 0.8660254037844386_f64 * t1;
    let t10 = 0.5_f64 * t1;
    let t11 = 0.8660254037844386_f64 * t2;
    let t12 = t10 - t11;
    let t13 = 1.1547005383792515_f64 * (cos_psiB * t9 - sin_psiB * t12);
    let t14 = sin_thB * t13;
    let t15 = 1.1547005383792515_f64 * (sin_thA * cos_thB + sin_thB * (cos_psiB * t12 + sin_psiB * t9));
    let t16 = cos_psiB * t14 + sin_psiB * t15;
    let t17 = sin_psiB * t14 - cos_psiB * t15;
    let t18 = 0.5_f64 * t16 + 0.8660254037844386_f64 * t17;
    let t19 = 0.5_f64 * t18;
    let t20 = 0.5_f64 * t17;
    let t21 = 0.8660254037844386_f64 * t16;
    let t22 = t20 - t21;
    let t23 = 0.8660254037844386_f64 * t22;
    let t24 = cos_thB * t13;
    let hA = q[0];
    let sB = q[7];
    let t25 = 0.5_f64 * sB;
    let t26 = sin_thA * t4;
    let t27 = 0.8660254037844386_f64 * sB;
    let t28 = t8 - t7;
    let t29 = 0.5773502691896257_f64 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t30 = t29 * cos_psiC;
    let t31 = t29 * sin_psiC;
    let t32 = 0.5773502691896257_f64 * cos_thB;
    let t33 = t32 * cos_psiB;
    let t34 = t32 * sin_psiB;
    let t35 = 0.5_f64 * t30 - 0.8660254037844386_f64 * t31 - (0.5_f64 * t33 + 0.8660254037844386_f64 * t34);
    let t36 = t28 * t6 + t35 * t26;
    let t37 = 0.5_f64 * t34 - 0.8660254037844386_f64 * t33;
    let t38 = 0.8660254037844386_f64 * t30 + 0.5_f64 * t31;
    let t39 = t37 - t38;
    let t40 = t35 * t5 + t39 * t6;
    let t41 = t28 * t5 - t39 * t26;
    let t42 = 1.0_f64 / Real::sqrt(t40 * t40 + (t36 * t36 + t41 * t41));
    let t43 = t36 * t42;
    let t44 = t41 * t42;
    let t45 = t6 * t43 + t5 * t44;
    let hB = q[4];
    let t46 = hA + (t25 * t26 + t27 * t45 - hB);
    let t47 = t40 * t42;
    let t48 = t6 * t47 - t26 * t44;
    let t49 = t25 * t5 + t27 * t48;
    let t50 = t5 * t47 + t26 * t43;
    let t51 = t27 * t50 - t25 * t6;
    let t52 = R * t18;
    let sA = q[3];
    let t53 = sA * (cos_thA * (sin_psiA * (t21 - t20) - cos_psiA * t18) - sin_thA * t24);
    let t54 = R * (t19 - t23) - (t24 * t46 + (t22 * t49 - t18 * t51) - t52 - t53);
    let t55 = sA * t26;
    let t56 = sA * t5;
    let t57 = sA * t6;
    let t58 = t53 + (t24 * t55 + (t22 * t56 + t18 * t57));
    let hC = q[8];
    let sC = q[11];
    let t59 = 0.8660254037844386_f64 * sC;
    let t60 = 0.5_f64 * sC;
    let t61 = hA - (hC + (t59 * t45 - t60 * t26));
    let t62 = t60 * t5 - t59 * t48;
    let t63 = t60 * t6 + t59 * t50;
    let t64 = R * (t23 + t19) - (t24 * t61 + (t22 * t62 + t18 * t63) - t52 - t53);
    let t65 = t64 - t58;
    let t66 = 1.0_f64 / t59;
    let t67 = t27 * t66;
    let t68 = sA + t60;
    let t69 = (t54 - t58 + t65 * t67) * (1.0_f64 / (sA + t25 + t68 * t67));
    let t70 = 0.8660254037844386_f64 * t39;
    let t71 = 0.5_f64 * t35;
    let t72 = R * t35;
    let t73 = sA * (cos_thA * (cos_psiA * t35 + sin_psiA * (t38 - t37)) - sin_thA * t28);
    let t74 = R * (t70 - t71) - (t72 + (t28 * t61 + (t39 * t62 - t35 * t63)) - t73);
    let t75 = R * t1;
    let t76 = sA * (t3 + cos_thA * (cos_psiA * t1 + sin_psiA * t2));
    let t77 = R * (t11 + t10) + (t75 - (sin_thA * t61 + (t2 * t62 + t1 * t63)) - t76);
    let t78 = R * (t70 + t71) + (t72 + (t28 * t46 + (t39 * t49 + t35 * t51)) - t73);
    let t79 = R * (t11 - t10) - (t75 + (t1 * t51 - t2 * t49 - sin_thA * t46) - t76);
    let t80 = 1.7320508075688772_f64 * t79;
    let t81 = t73 - (t35 * t57 - t39 * t56 - t28 * t55);
    let t82 = 2.0_f64 * sB;
    let t83 = (t74 + 1.7320508075688772_f64 * t77 - (t78 - t80) - 2.0_f64 * t81) * (1.0_f64 / (t82 + 2.0_f64 * sC + 2.0_f64 * sA));
    let t84 = t24 * t83;
    let t85 = (t1 * t5 - t2 * t6 - (t7 - t8) * t69 - t84) * (1.0_f64 / (cos_thA * cos_thA));
    let t86 = (t26 - sin_thA + t24 * t69 + t28 * t83) * (1.0_f64 / cos_thA);
    let t87 = 0.5773502691896257_f64 * (t80 - t78 - t82 * t83 - (t81 + sA * t83));
    let t88 = t76 - (sin_thA * t55 + (t2 * t56 + t1 * t57)) - t87;
    let t89 = cos_thB * cos_psiB;
    let t90 = cos_thB * sin_psiB;
    let t91 = 0.5_f64 * t89 + 0.8660254037844386_f64 * t90;
    let t92 = 0.5_f64 * t5;
    let t93 = 0.8660254037844386_f64 * t48;
    let t94 = 0.8660254037844386_f64 * t89 - 0.5_f64 * t90;
    let t95 = 0.8660254037844386_f64 * t50;
    let t96 = 0.5_f64 * t6;
    let t97 = 0.8660254037844386_f64 * sin_thA;
    let t98 = 0.5_f64 * t28;
    let t99 = t97 - t98;
    let t100 = t66 * (t65 - t68 * t69);
    let t101 = t91 * (t92 + t93) - t94 * (t95 - t96) + 0.8660254037844386_f64 * t99 * t100 - 0.5_f64 * t99 * t69;
    let t102 = (t101 - t84) * (1.0_f64 / (cos_thB * cos_thB));
    let t103 = 0.8660254037844386_f64 * t24 * t100;
    let t104 = 0.5_f64 * t26;
    let t105 = 0.8660254037844386_f64 * t45;
    let t106 = 0.5_f64 * t24 * t69;
    let t107 = (t103 - (sin_thB + (t104 + t105)) - t106 + t99 * t83) * (1.0_f64 / cos_thB);
    let t108 = t97 + t98;
    let t109 = cos_thC * sin_psiC;
    let t110 = 0.8660254037844386_f64 * t109;
    let t111 = cos_thC * cos_psiC;
    let t112 = 0.5_f64 * t111;
    let t113 = 0.8660254037844386_f64 * t111 + 0.5_f64 * t109;
    let t114 = 0.8660254037844386_f64 * t108 * t100 - ((t110 - t112) * (t92 - t93) + t113 * (t96 + t95));
    let t115 = (t114 + 0.5_f64 * t108 * t69 - t84) * (1.0_f64 / (cos_thC * cos_thC));
    let t116 = sA * cos_thA;
    let t117 = sin_psiA * t116;
    let t118 = 0.8660254037844386_f64 * R;
    let t119 = sB * cos_thB;
    let t120 = sin_psiB * t119;
    let t121 = cos_psiB * t119;
    let t122 = R - cos_psiA * t116 + 0.5_f64 * R;
    let t123 = Real::max(Real::abs(t117 + t118 + (0.5_f64 * t120 - 0.8660254037844386_f64 * t121)), Real::abs(t122 - (0.5_f64 * t121 + 0.8660254037844386_f64 * t120)));
    let t124 = sA * sin_thA;
    let t125 = sC * cos_thC;
    let t126 = cos_psiC * t125;
    let t127 = sin_psiC * t125;
    let t128 = Real::max(Real::max(t123, Real::abs(t124 + (hA - hB) - sB * sin_thB)), Real::abs(0.8660254037844386_f64 * t126 + 0.5_f64 * t127 + (t117 - t118)));
    let t129 = Real::max(Real::max(t128, Real::abs(0.8660254037844386_f64 * t127 - 0.5_f64 * t126 + t122)), Real::abs(t124 + (hA - hC) - sC * sin_thC));
    let t130 = Real::max(Real::max(t129, Real::abs(t2 + t94 - t113)), Real::abs(t112 - t110 + (t91 - t1)));
    let t131 = Real::max(t130, Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t85, t86, t88, t102, t107, -2.0_f64 * (t79 - t27 * t83 - t87), t115, -(sin_thC + (t104 - t105) + t103 + t106 + t108 * t83) * (1.0_f64 / cos_thC), -2.0_f64 * (t59 * t83 - t77 - t87)], t131)
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
