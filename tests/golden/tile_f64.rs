// Generated from models/tile.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile: 12 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 868 operations (12 abs, 164 add, 5 cos, 12 div, 11 min, 510 mul, 5 sin, 149 sub).
// Cost of energy: 340 operations (67 add, 5 cos, 9 div, 218 mul, 5 sin, 36 sub).
// Cost of speeds: 247 operations (40 add, 5 cos, 9 div, 149 mul, 5 sin, 39 sub).
// Cost of outputs: 10 operations (1 add, 2 cos, 4 mul, 2 sin, 1 sub).
// Cost of projection: 445 operations (9 abs, 79 add, 6 cos, 11 div, 8 max, 232 mul, 6 sin, 2 sqrt, 92 sub).

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
///868 operations.
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
    let t13 = 0.8660254037844386_f64 * sC;
    let t14 = 0.8660254037844386_f64 * sB;
    let t15 = 1.0_f64 / t14;
    let t16 = t13 * t15;
    let t17 = t4 * t16;
    let t18 = sA + 0.5_f64 * sB;
    let t19 = sA + 0.5_f64 * sC + t18 * t16;
    let t20 = 1.0_f64 / t19;
    let t21 = (t4 + t17) * t20;
    let t22 = cos_thA * cos_thA;
    let t23 = 1.0_f64 / t22;
    let u_psiA_per_u_hA = (t11 + t12 * t21) * t23;
    let u_hB = u[1];
    let t24 = 1.7320508075688772_f64 * sin_thA;
    let t25 = t7 - t24;
    let t26 = t25 * t10;
    let t27 = t4 * t26;
    let w_platform_y_per_u_hB = t17 * t20;
    let t28 = (t27 + t12 * w_platform_y_per_u_hB) * t23;
    let u_hC = u[2];
    let t29 = (t7 + t24) * t10;
    let t30 = t4 * t29;
    let w_platform_y_per_u_hC = t4 * t20;
    let t31 = (t30 + t12 * w_platform_y_per_u_hC) * t23;
    let u_psiA = u_hA * u_psiA_per_u_hA - u_hB * t28 - u_hC * t31;
    let t32 = 1.0_f64 / cos_thA;
    let u_thA_per_u_hC = (t4 * w_platform_y_per_u_hC + t7 * t29) * t32;
    let u_thA_per_u_hB = (t4 * w_platform_y_per_u_hB + t7 * t26) * t32;
    let t33 = (t4 * t21 + t7 * w_platform_z_per_u_hA) * t32;
    let u_thA = u_hC * u_thA_per_u_hC + (u_hB * u_thA_per_u_hB - u_hA * t33);
    let v_G_y_per_u_hC = sA * t29;
    let u_sA_per_u_hC = 0.5773502691896257_f64 * (v_G_y_per_u_hC + t8 * t29);
    let v_G_y_per_u_hA = t7 - sA * w_platform_z_per_u_hA;
    let v_G_x_per_u_hA = 0.5773502691896257_f64 * (t8 * w_platform_z_per_u_hA - v_G_y_per_u_hA);
    let v_G_y_per_u_hB = sA * t26;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * (t25 - t8 * t26 - v_G_y_per_u_hB);
    let u_sA = u_hC * u_sA_per_u_hC - (u_hA * (sin_thA + v_G_x_per_u_hA) + u_hB * v_G_x_per_u_hB);
    let t34 = 0.8660254037844386_f64 * sin_thA;
    let t35 = 0.5_f64 * t7;
    let t36 = t34 - t35;
    let t37 = 0.8660254037844386_f64 * t36;
    let t38 = t15 * (t18 * w_platform_y_per_u_hC);
    let t39 = 0.5_f64 * t36;
    let t40 = cos_thB * cos_thB;
    let t41 = 1.0_f64 / t40;
    let u_psiB_per_u_hC = (t37 * t38 - t39 * w_platform_y_per_u_hC - t30) * t41;
    let w_platform_x_per_u_hA = t15 * (t18 * t21 - t4);
    let u_psiB_per_u_hA = (t11 + (t39 * t21 - t37 * w_platform_x_per_u_hA)) * t41;
    let w_platform_x_per_u_hB = t15 * (t4 - t18 * w_platform_y_per_u_hB);
    let t42 = (t27 + (t37 * w_platform_x_per_u_hB + t39 * w_platform_y_per_u_hB)) * t41;
    let u_psiB = u_hC * u_psiB_per_u_hC + (u_hA * u_psiB_per_u_hA - u_hB * t42);
    let t43 = 0.8660254037844386_f64 * t4;
    let t44 = t43 * t38;
    let t45 = 0.5_f64 * t4;
    let t46 = t45 * w_platform_y_per_u_hC;
    let t47 = 1.0_f64 / cos_thB;
    let u_thB_per_u_hC = (t44 - t46 + t36 * t29) * t47;
    let t48 = t45 * t21;
    let t49 = t43 * w_platform_x_per_u_hA;
    let u_thB_per_u_hA = (t48 - t49 - t36 * w_platform_z_per_u_hA) * t47;
    let t50 = t43 * w_platform_x_per_u_hB;
    let t51 = t45 * w_platform_y_per_u_hB;
    let u_thB_per_u_hB = (t36 * t26 - (t50 + t51)) * t47;
    let u_thB = u_hC * u_thB_per_u_hC + (u_hA * u_thB_per_u_hA + u_hB * u_thB_per_u_hB);
    let u_sB_per_u_hB = 2.0_f64 * (v_G_x_per_u_hB + (sin_thA + t14 * t26));
    let u_sB = u_hB * u_sB_per_u_hB - u_hA * (2.0_f64 * (t14 * w_platform_z_per_u_hA - v_G_x_per_u_hA)) - u_hC * (2.0_f64 * (u_sA_per_u_hC - t14 * t29));
    let t52 = t34 + t35;
    let t53 = 0.8660254037844386_f64 * t52;
    let t54 = 0.5_f64 * t52;
    let t55 = cos_thC * cos_thC;
    let t56 = 1.0_f64 / t55;
    let u_psiC_per_u_hC = (t53 * t38 + t54 * w_platform_y_per_u_hC - t30) * t56;
    let u_psiC_per_u_hA = (t11 - (t53 * w_platform_x_per_u_hA + t54 * t21)) * t56;
    let u_psiC_per_u_hB = (t54 * w_platform_y_per_u_hB - t53 * w_platform_x_per_u_hB - t27) * t56;
    let u_psiC = u_hC * u_psiC_per_u_hC + (u_hA * u_psiC_per_u_hA + u_hB * u_psiC_per_u_hB);
    let t57 = 1.0_f64 / cos_thC;
    let u_thC_per_u_hA = (t49 + t48 + t52 * w_platform_z_per_u_hA) * t57;
    let u_thC_per_u_hB = (t50 - t51 - t52 * t26) * t57;
    let t58 = (t44 + t46 + t52 * t29) * t57;
    let u_thC = u_hA * u_thC_per_u_hA + u_hB * u_thC_per_u_hB - u_hC * t58;
    let u_sC_per_u_hA = 2.0_f64 * (v_G_x_per_u_hA + t13 * w_platform_z_per_u_hA);
    let u_sC = u_hA * u_sC_per_u_hA - u_hB * (2.0_f64 * (t13 * t26 - v_G_x_per_u_hB)) - u_hC * (2.0_f64 * (u_sA_per_u_hC + (t13 * t29 - sin_thA)));
    let FA = inputs[0];
    let c = p.c;
    let ms = p.ms;
    let g = p.g;
    let mc = p.mc;
    let t59 = ms * g + mc * g;
    let Ic3 = p.Ic3;
    let Ic2 = p.Ic2;
    let t60 = Ic3 - Ic2;
    let t61 = cos_thA * u_psiA;
    let Ic1 = p.Ic1;
    let t62 = u_psiA * u_thA;
    let t63 = sin_thA * t62;
    let t64 = Ic2 - Ic1;
    let t65 = sin_thA * u_psiA;
    let t66 = u_thA * t65;
    let t67 = sin_thA * (t60 * (u_thA * t61) - Ic1 * (cos_thA * t62)) + cos_thA * (Ic3 * t63 + t64 * t66);
    let t68 = sin_thA * (Ic1 * sin_thA) + cos_thA * (Ic3 * cos_thA);
    let w_platform_x = u_hA * w_platform_x_per_u_hA + u_hB * w_platform_x_per_u_hB - u_hC * t38;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * t26 - u_hC * t29;
    let t69 = w_platform_x * w_platform_z;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * t21);
    let t70 = w_platform_x * w_platform_y;
    let t71 = 0.8660254037844386_f64 * w_platform_x;
    let t72 = 0.5_f64 * w_platform_y;
    let t73 = t71 - t72;
    let t74 = 0.5_f64 * w_platform_z;
    let t75 = w_platform_x * t74;
    let t76 = 0.8660254037844386_f64 * w_platform_z;
    let t77 = w_platform_y * t76;
    let t78 = t75 + t77;
    let t79 = 2.0_f64 * (u_sA * w_platform_y) - sA * t69;
    let t80 = t71 + t72;
    let t81 = sB * (t75 - t77) - 2.0_f64 * (u_sB * t80) - t79;
    let w_platform_y_dot_bias = t20 * (2.0_f64 * (u_sC * t73) + sC * t78 - t79 + t16 * t81);
    let t82 = w_platform_z * t76;
    let t83 = t82 + w_platform_x * t80;
    let t84 = w_platform_z * t74;
    let t85 = w_platform_y * t80 + t84;
    let t86 = 2.0_f64 * (u_sB * t74) + sB * t83 + 1.7320508075688772_f64 * (2.0_f64 * (u_sB * t76) - sB * t85);
    let t87 = t82 + w_platform_x * t73;
    let t88 = w_platform_y * t73;
    let t89 = 2.0_f64 * (u_sC * t74) - sC * t87 - 1.7320508075688772_f64 * (sC * (t88 - t84) - 2.0_f64 * (u_sC * t76));
    let t90 = 2.0_f64 * (u_sA * w_platform_z) + sA * t70;
    let t91 = t10 * (t86 + t89 + 2.0_f64 * t90);
    let t92 = t4 * t91;
    let t93 = cos_thA * (t66 + t63) - (t7 * t69 - t4 * t70) - t12 * w_platform_y_dot_bias - t92;
    let u_psiA_dot_bias = t23 * t93;
    let t94 = t67 - t68 * u_psiA_dot_bias;
    let t95 = Ic1 - Ic3;
    let t96 = t61 * t65;
    let t97 = cos_thA * t96 - sin_thA * (u_thA * u_thA + t61 * t61) + (t4 * t69 + (sin_thA * (w_platform_y * w_platform_y + w_platform_z * w_platform_z) + t7 * t70));
    let u_thA_dot_bias = t32 * (t4 * w_platform_y_dot_bias - t97 + t7 * t91);
    let t98 = t95 * t96 - Ic2 * u_thA_dot_bias;
    let t99 = cos_thB * u_psiB;
    let t100 = u_psiB * u_thB;
    let t101 = sin_thB * t100;
    let t102 = sin_thB * u_psiB;
    let t103 = u_thB * t102;
    let t104 = sin_thB * (t60 * (u_thB * t99) - Ic1 * (cos_thB * t100)) + cos_thB * (Ic3 * t101 + t64 * t103);
    let t105 = sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB);
    let t106 = t77 - t75;
    let w_platform_x_dot_bias = t15 * (t81 - t18 * w_platform_y_dot_bias);
    let t107 = cos_thB * (t103 + t101) - (t36 * t106 + (t43 * t85 - t45 * t83)) - t37 * w_platform_x_dot_bias;
    let u_psiB_dot_bias = t41 * (t107 - t39 * w_platform_y_dot_bias - t92);
    let t108 = t104 - t105 * u_psiB_dot_bias;
    let t109 = FA - u_hA * c - t59 + u_psiA_per_u_hA * t94 - t33 * t98 + u_psiB_per_u_hA * t108;
    let t110 = t99 * t102;
    let t111 = t45 * w_platform_y_dot_bias;
    let t112 = cos_thB * t110 - sin_thB * (u_thB * u_thB + t99 * t99) + (t4 * t106 - (sin_thA * t85 + t7 * t83));
    let t113 = t43 * w_platform_x_dot_bias;
    let u_thB_dot_bias = t47 * (t36 * t91 - (t111 + (t112 + t113)));
    let t114 = t95 * t110 - Ic2 * u_thB_dot_bias;
    let t115 = cos_thC * u_psiC;
    let t116 = u_psiC * u_thC;
    let t117 = sin_thC * t116;
    let t118 = sin_thC * u_psiC;
    let t119 = u_thC * t118;
    let t120 = sin_thC * (t60 * (u_thC * t115) - Ic1 * (cos_thC * t116)) + cos_thC * (Ic3 * t117 + t64 * t119);
    let t121 = sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC);
    let t122 = t84 - t88;
    let t123 = cos_thC * (t119 + t117) - (t52 * t78 + (t45 * t87 - t43 * t122)) - t53 * w_platform_x_dot_bias;
    let u_psiC_dot_bias = t56 * (t123 + t54 * w_platform_y_dot_bias - t92);
    let t124 = t120 - t121 * u_psiC_dot_bias;
    let t125 = t115 * t118;
    let t126 = cos_thC * t125 - sin_thC * (u_thC * u_thC + t115 * t115) + (t7 * t87 - sin_thA * t122 - t4 * t78);
    let u_thC_dot_bias = t57 * (t113 - t126 - t111 - t52 * t91);
    let t127 = t95 * t125 - Ic2 * u_thC_dot_bias;
    let Iz = p.Iz;
    let Iy = p.Iy;
    let Ix = p.Ix;
    let t128 = (Iz - Iy) * (w_platform_y * w_platform_z) + Ix * w_platform_x_dot_bias;
    let t129 = (Ix - Iz) * t69 + Iy * w_platform_y_dot_bias;
    let t130 = t109 + u_thB_per_u_hA * t114 + u_psiC_per_u_hA * t124 + u_thC_per_u_hA * t127 - w_platform_x_per_u_hA * t128 + t21 * t129;
    let t131 = Iz * t91 - (Iy - Ix) * t70;
    let M = p.M;
    let t132 = M * g;
    let v_G_y_dot_bias = sA * t91 - t90;
    let v_G_x_dot_bias = 0.5773502691896257_f64 * (t86 - t8 * t91 - v_G_y_dot_bias);
    let t133 = sin_thA * t132 - M * v_G_x_dot_bias;
    let t134 = t7 * t132 + M * v_G_y_dot_bias;
    let v_G_z_per_u_hA = t4 - sA * t21;
    let v_G_z_dot_bias = t79 + sA * w_platform_y_dot_bias;
    let t135 = t4 * t132 + M * v_G_z_dot_bias;
    let forcing_u_hA = t130 + w_platform_z_per_u_hA * t131 + v_G_x_per_u_hA * t133 - v_G_y_per_u_hA * t134 - v_G_z_per_u_hA * t135;
    let mr = p.mr;
    let t136 = mc + (ms + mr);
    let t137 = t136 + u_psiA_per_u_hA * (t68 * u_psiA_per_u_hA) + t33 * (Ic2 * t33) + u_psiB_per_u_hA * (t105 * u_psiB_per_u_hA);
    let t138 = t137 + u_thB_per_u_hA * (Ic2 * u_thB_per_u_hA) + u_psiC_per_u_hA * (t121 * u_psiC_per_u_hA) + u_thC_per_u_hA * (Ic2 * u_thC_per_u_hA);
    let t139 = t138 + w_platform_x_per_u_hA * (Ix * w_platform_x_per_u_hA) + t21 * (Iy * t21) + w_platform_z_per_u_hA * (Iz * w_platform_z_per_u_hA);
    let mass_u_hA_u_hA = t139 + v_G_x_per_u_hA * (M * v_G_x_per_u_hA) + v_G_y_per_u_hA * (M * v_G_y_per_u_hA) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let t140 = 1.0_f64 / mass_u_hA_u_hA;
    let t141 = Ic2 * u_thB_per_u_hB;
    let t142 = t68 * t28;
    let t143 = Ic2 * u_thA_per_u_hB;
    let t144 = t105 * t42;
    let t145 = t121 * u_psiC_per_u_hB;
    let t146 = u_thB_per_u_hA * t141 - (u_psiA_per_u_hA * t142 + t33 * t143 + u_psiB_per_u_hA * t144) + u_psiC_per_u_hA * t145;
    let t147 = Ic2 * u_thC_per_u_hB;
    let t148 = Ix * w_platform_x_per_u_hB;
    let t149 = Iy * w_platform_y_per_u_hB;
    let t150 = Iz * t26;
    let t151 = M * v_G_x_per_u_hB;
    let t152 = t146 + u_thC_per_u_hA * t147 + w_platform_x_per_u_hA * t148 - t21 * t149 - w_platform_z_per_u_hA * t150 + v_G_x_per_u_hA * t151;
    let t153 = M * v_G_y_per_u_hB;
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let t154 = M * v_G_z_per_u_hB;
    let mass_u_hA_u_hB = t152 + v_G_y_per_u_hA * t153 + v_G_z_per_u_hA * t154;
    let t155 = mass_u_hA_u_hB * t140;
    let t156 = t136 + (t28 * t142 + u_thA_per_u_hB * t143) + t42 * t144 + u_thB_per_u_hB * t141 + u_psiC_per_u_hB * t145;
    let t157 = t156 + u_thC_per_u_hB * t147 + w_platform_x_per_u_hB * t148 + w_platform_y_per_u_hB * t149 + t26 * t150 + v_G_x_per_u_hB * t151;
    let mass_u_hB_u_hB = t157 + v_G_y_per_u_hB * t153 + v_G_z_per_u_hB * t154;
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t155;
    let t158 = 1.0_f64 / pivot_1;
    let FB = inputs[1];
    let t159 = FB - u_hB * c - t59 + (u_thA_per_u_hB * t98 - t28 * t94) - t42 * t108;
    let t160 = t159 + u_thB_per_u_hB * t114 + u_psiC_per_u_hB * t124 + u_thC_per_u_hB * t127 - w_platform_x_per_u_hB * t128 - w_platform_y_per_u_hB * t129;
    let forcing_u_hB = t160 - t26 * t131 + v_G_x_per_u_hB * t133 - v_G_y_per_u_hB * t134 - v_G_z_per_u_hB * t135;
    let t161 = forcing_u_hB - forcing_u_hA * t155;
    let t162 = t68 * t31;
    let t163 = Ic2 * u_thA_per_u_hC;
    let t164 = t105 * u_psiB_per_u_hC;
    let t165 = Ic2 * u_thB_per_u_hC;
    let t166 = t121 * u_psiC_per_u_hC;
    let t167 = t28 * t162 + u_thA_per_u_hB * t163 - t42 * t164 + u_thB_per_u_hB * t165 + u_psiC_per_u_hB * t166;
    let t168 = Ic2 * t58;
    let t169 = Ix * t38;
    let t170 = Iy * w_platform_y_per_u_hC;
    let t171 = Iz * t29;
    let t172 = M * u_sA_per_u_hC;
    let t173 = t167 - u_thC_per_u_hB * t168 - w_platform_x_per_u_hB * t169 + w_platform_y_per_u_hB * t170 + t26 * t171 - v_G_x_per_u_hB * t172;
    let t174 = M * v_G_y_per_u_hC;
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let t175 = M * v_G_z_per_u_hC;
    let mass_u_hB_u_hC = t173 + v_G_y_per_u_hB * t174 + v_G_z_per_u_hB * t175;
    let t176 = u_psiB_per_u_hA * t164 - (u_psiA_per_u_hA * t162 + t33 * t163) + u_thB_per_u_hA * t165 + u_psiC_per_u_hA * t166;
    let t177 = t176 - u_thC_per_u_hA * t168 - w_platform_x_per_u_hA * t169 - t21 * t170 - w_platform_z_per_u_hA * t171 - v_G_x_per_u_hA * t172;
    let mass_u_hA_u_hC = t177 + v_G_y_per_u_hA * t174 + v_G_z_per_u_hA * t175;
    let t178 = mass_u_hB_u_hC - mass_u_hA_u_hC * t155;
    let t179 = t178 * t158;
    let FC = inputs[2];
    let t180 = FC - u_hC * c - t59 + (u_thA_per_u_hC * t98 - t31 * t94 + u_psiB_per_u_hC * t108 + u_thB_per_u_hC * t114);
    let t181 = t180 + u_psiC_per_u_hC * t124 - t58 * t127 + t38 * t128 - w_platform_y_per_u_hC * t129 - t29 * t131;
    let forcing_u_hC = t181 - u_sA_per_u_hC * t133 - v_G_y_per_u_hC * t134 - v_G_z_per_u_hC * t135;
    let t182 = mass_u_hA_u_hC * t140;
    let t183 = t136 + (t31 * t162 + u_thA_per_u_hC * t163 + u_psiB_per_u_hC * t164 + u_thB_per_u_hC * t165) + u_psiC_per_u_hC * t166;
    let t184 = t183 + t58 * t168 + t38 * t169 + w_platform_y_per_u_hC * t170 + t29 * t171 + u_sA_per_u_hC * t172;
    let mass_u_hC_u_hC = t184 + v_G_y_per_u_hC * t174 + v_G_z_per_u_hC * t175;
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t182 - t178 * t179;
    let t185 = (forcing_u_hC - forcing_u_hA * t182 - t179 * t161) / pivot_2;
    let t186 = t158 * t161 - t179 * t185;
    let t187 = forcing_u_hA * t140 - t155 * t186 - t182 * t185;
    let t188 = Real::min(Real::min(Real::min(Real::min(Real::abs(cos_thA), Real::abs(cos_thB)), Real::abs(cos_thC)), Real::abs(t22)), Real::abs(t40));
    let t189 = Real::min(Real::min(Real::min(Real::min(t188, Real::abs(t55)), 0.8333333333333333_f64 * Real::abs(t9)), 5.773502691896257_f64 * Real::abs(t14)), 1.6666666666666665_f64 * Real::abs(t19));
    let t190 = Real::min(Real::min(Real::min(t189, 0.21652832912306028_f64 * Real::abs(mass_u_hA_u_hA)), 0.21680787182359307_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC], [t187, t186, t185], t190)
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
    let t13 = 1.0_f64 / (0.8660254037844386_f64 * sB);
    let t14 = 0.8660254037844386_f64 * sC * t13;
    let t15 = t5 * t14;
    let t16 = sA + 0.5_f64 * sB;
    let t17 = 1.0_f64 / (sA + 0.5_f64 * sC + t16 * t14);
    let t18 = (t5 + t15) * t17;
    let t19 = 1.0_f64 / (cos_thA * cos_thA);
    let u_psiA_per_u_hA = (t11 + t12 * t18) * t19;
    let t20 = 1.7320508075688772_f64 * sin_thA;
    let t21 = t8 - t20;
    let t22 = t21 * t10;
    let t23 = t5 * t22;
    let w_platform_y_per_u_hB = t15 * t17;
    let t24 = (t8 + t20) * t10;
    let t25 = t5 * t24;
    let w_platform_y_per_u_hC = t5 * t17;
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
    let t32 = t13 * (t16 * w_platform_y_per_u_hC);
    let t33 = 0.5_f64 * t30;
    let t34 = 1.0_f64 / (cos_thB * cos_thB);
    let u_psiB_per_u_hC = (t31 * t32 - t33 * w_platform_y_per_u_hC - t25) * t34;
    let w_platform_x_per_u_hA = t13 * (t16 * t18 - t5);
    let u_psiB_per_u_hA = (t11 + (t33 * t18 - t31 * w_platform_x_per_u_hA)) * t34;
    let w_platform_x_per_u_hB = t13 * (t5 - t16 * w_platform_y_per_u_hB);
    let u_psiB = u_hC * u_psiB_per_u_hC + (u_hA * u_psiB_per_u_hA - u_hB * ((t23 + (t31 * w_platform_x_per_u_hB + t33 * w_platform_y_per_u_hB)) * t34));
    let t35 = 0.5_f64 * (t1 * (u_hB * u_hB)) + (t26 + 0.5_f64 * (Ic2 * (u_thA * u_thA))) + 0.5_f64 * ((sin_thB * (Ic1 * sin_thB) + cos_thB * (Ic3 * cos_thB)) * (u_psiB * u_psiB));
    let t36 = 0.8660254037844386_f64 * t5;
    let t37 = t36 * t32;
    let t38 = 0.5_f64 * t5;
    let t39 = t38 * w_platform_y_per_u_hC;
    let t40 = 1.0_f64 / cos_thB;
    let u_thB_per_u_hC = (t37 - t39 + t30 * t24) * t40;
    let t41 = t38 * t18;
    let t42 = t36 * w_platform_x_per_u_hA;
    let u_thB_per_u_hA = (t41 - t42 - t30 * w_platform_z_per_u_hA) * t40;
    let t43 = t36 * w_platform_x_per_u_hB;
    let t44 = t38 * w_platform_y_per_u_hB;
    let u_thB_per_u_hB = (t30 * t22 - (t43 + t44)) * t40;
    let u_thB = u_hC * u_thB_per_u_hC + (u_hA * u_thB_per_u_hA + u_hB * u_thB_per_u_hB);
    let t45 = t28 + t29;
    let t46 = 0.8660254037844386_f64 * t45;
    let t47 = 0.5_f64 * t45;
    let t48 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_u_hC = (t46 * t32 + t47 * w_platform_y_per_u_hC - t25) * t48;
    let u_psiC_per_u_hA = (t11 - (t46 * w_platform_x_per_u_hA + t47 * t18)) * t48;
    let u_psiC_per_u_hB = (t47 * w_platform_y_per_u_hB - t46 * w_platform_x_per_u_hB - t23) * t48;
    let u_psiC = u_hC * u_psiC_per_u_hC + (u_hA * u_psiC_per_u_hA + u_hB * u_psiC_per_u_hB);
    let t49 = 0.5_f64 * (t1 * (u_hC * u_hC)) + (t35 + 0.5_f64 * (Ic2 * (u_thB * u_thB))) + 0.5_f64 * ((sin_thC * (Ic1 * sin_thC) + cos_thC * (Ic3 * cos_thC)) * (u_psiC * u_psiC));
    let t50 = 1.0_f64 / cos_thC;
    let u_thC_per_u_hA = (t42 + t41 + t45 * w_platform_z_per_u_hA) * t50;
    let u_thC_per_u_hB = (t43 - t44 - t45 * t22) * t50;
    let u_thC = u_hA * u_thC_per_u_hA + u_hB * u_thC_per_u_hB - u_hC * ((t37 + t39 + t45 * t24) * t50);
    let Ix = p.Ix;
    let w_platform_x = u_hA * w_platform_x_per_u_hA + u_hB * w_platform_x_per_u_hB - u_hC * t32;
    let Iy = p.Iy;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * t18);
    let t51 = t49 + 0.5_f64 * (Ic2 * (u_thC * u_thC)) + 0.5_f64 * (Ix * (w_platform_x * w_platform_x)) + 0.5_f64 * (Iy * (w_platform_y * w_platform_y));
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
    let t52 = t51 + 0.5_f64 * (Iz * (w_platform_z * w_platform_z)) + 0.5_f64 * (M * (v_G_x * v_G_x)) + 0.5_f64 * (M * (v_G_y * v_G_y));
    let v_G_z_per_u_hC = sA * w_platform_y_per_u_hC;
    let v_G_z_per_u_hA = t5 - sA * t18;
    let v_G_z_per_u_hB = sA * w_platform_y_per_u_hB;
    let v_G_z = u_hC * v_G_z_per_u_hC + (u_hA * v_G_z_per_u_hA + u_hB * v_G_z_per_u_hB);
    let t53 = t52 + 0.5_f64 * (M * (v_G_z * v_G_z));
    let hA = q[0];
    let g = p.g;
    let t54 = hA * g;
    let hB = q[4];
    let t55 = hB * g;
    let hC = q[8];
    let t56 = hC * g;
    let t57 = ms * t54 + mc * t54 + ms * t55 + mc * t55 + ms * t56;
    let t58 = t57 + mc * t56 + M * (t54 + sA * (g * sin_thA));
    (t53, t58)
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
    let t12 = 0.8660254037844386_f64 * sC;
    let t13 = 0.8660254037844386_f64 * sB;
    let t14 = 1.0_f64 / t13;
    let t15 = t12 * t14;
    let t16 = t4 * t15;
    let t17 = sA + 0.5_f64 * sB;
    let t18 = 1.0_f64 / (sA + 0.5_f64 * sC + t17 * t15);
    let t19 = (t4 + t16) * t18;
    let t20 = 1.0_f64 / (cos_thA * cos_thA);
    let u_psiA_per_u_hA = (t10 + t11 * t19) * t20;
    let u_hB = u[1];
    let t21 = 1.7320508075688772_f64 * sin_thA;
    let t22 = t7 - t21;
    let t23 = t22 * t9;
    let t24 = t4 * t23;
    let w_platform_y_per_u_hB = t16 * t18;
    let u_hC = u[2];
    let t25 = (t7 + t21) * t9;
    let t26 = t4 * t25;
    let w_platform_y_per_u_hC = t4 * t18;
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
    let t32 = t14 * (t17 * w_platform_y_per_u_hC);
    let t33 = 0.5_f64 * t30;
    let t34 = 1.0_f64 / (cos_thB * cos_thB);
    let u_psiB_per_u_hC = (t31 * t32 - t33 * w_platform_y_per_u_hC - t26) * t34;
    let w_platform_x_per_u_hA = t14 * (t17 * t19 - t4);
    let u_psiB_per_u_hA = (t10 + (t33 * t19 - t31 * w_platform_x_per_u_hA)) * t34;
    let w_platform_x_per_u_hB = t14 * (t4 - t17 * w_platform_y_per_u_hB);
    let u_psiB = u_hC * u_psiB_per_u_hC + (u_hA * u_psiB_per_u_hA - u_hB * ((t24 + (t31 * w_platform_x_per_u_hB + t33 * w_platform_y_per_u_hB)) * t34));
    let t35 = 0.8660254037844386_f64 * t4;
    let t36 = t35 * t32;
    let t37 = 0.5_f64 * t4;
    let t38 = t37 * w_platform_y_per_u_hC;
    let t39 = 1.0_f64 / cos_thB;
    let u_thB_per_u_hC = (t36 - t38 + t30 * t25) * t39;
    let t40 = t37 * t19;
    let t41 = t35 * w_platform_x_per_u_hA;
    let u_thB_per_u_hA = (t40 - t41 - t30 * w_platform_z_per_u_hA) * t39;
    let t42 = t35 * w_platform_x_per_u_hB;
    let t43 = t37 * w_platform_y_per_u_hB;
    let u_thB_per_u_hB = (t30 * t23 - (t42 + t43)) * t39;
    let u_thB = u_hC * u_thB_per_u_hC + (u_hA * u_thB_per_u_hA + u_hB * u_thB_per_u_hB);
    let u_sB_per_u_hB = 2.0_f64 * (v_G_x_per_u_hB + (sin_thA + t13 * t23));
    let u_sB = u_hB * u_sB_per_u_hB - u_hA * (2.0_f64 * (t13 * w_platform_z_per_u_hA - v_G_x_per_u_hA)) - u_hC * (2.0_f64 * (u_sA_per_u_hC - t13 * t25));
    let t44 = t28 + t29;
    let t45 = 0.8660254037844386_f64 * t44;
    let t46 = 0.5_f64 * t44;
    let t47 = 1.0_f64 / (cos_thC * cos_thC);
    let u_psiC_per_u_hC = (t45 * t32 + t46 * w_platform_y_per_u_hC - t26) * t47;
    let u_psiC_per_u_hA = (t10 - (t45 * w_platform_x_per_u_hA + t46 * t19)) * t47;
    let u_psiC_per_u_hB = (t46 * w_platform_y_per_u_hB - t45 * w_platform_x_per_u_hB - t24) * t47;
    let u_psiC = u_hC * u_psiC_per_u_hC + (u_hA * u_psiC_per_u_hA + u_hB * u_psiC_per_u_hB);
    let t48 = 1.0_f64 / cos_thC;
    let u_thC_per_u_hA = (t41 + t40 + t44 * w_platform_z_per_u_hA) * t48;
    let u_thC_per_u_hB = (t42 - t43 - t44 * t23) * t48;
    let u_thC = u_hA * u_thC_per_u_hA + u_hB * u_thC_per_u_hB - u_hC * ((t36 + t38 + t44 * t25) * t48);
    let u_sC_per_u_hA = 2.0_f64 * (v_G_x_per_u_hA + t12 * w_platform_z_per_u_hA);
    let u_sC = u_hA * u_sC_per_u_hA - u_hB * (2.0_f64 * (t12 * t23 - v_G_x_per_u_hB)) - u_hC * (2.0_f64 * (u_sA_per_u_hC + (t12 * t25 - sin_thA)));
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
    let t16 = sin_psiB * t14 - cos_psiB * t15;
    let t17 = 0.5_f64 * t16;
    let t18 = cos_psiB * t14 + sin_psiB * t15;
    let t19 = 0.8660254037844386_f64 * t18;
    let t20 = t17 - t19;
    let t21 = 0.8660254037844386_f64 * t20;
    let t22 = 0.5_f64 * t18 + 0.8660254037844386_f64 * t16;
    let t23 = 0.5_f64 * t22;
    let t24 = cos_thB * t13;
    let hA = q[0];
    let hC = q[8];
    let sC = q[11];
    let t25 = 0.8660254037844386_f64 * sC;
    let t26 = t8 - t7;
    let t27 = 0.5773502691896257_f64 * cos_thC;
    let psiC = q[9];
    let (sin_psiC, cos_psiC) = Real::sin_cos(psiC);
    let t28 = t27 * cos_psiC;
    let t29 = t27 * sin_psiC;
    let t30 = 0.5773502691896257_f64 * cos_thB;
    let t31 = t30 * cos_psiB;
    let t32 = t30 * sin_psiB;
    let t33 = 0.5_f64 * t28 - 0.8660254037844386_f64 * t29 - (0.5_f64 * t31 + 0.8660254037844386_f64 * t32);
    let t34 = sin_thA * t4;
    let t35 = t26 * t6 + t33 * t34;
    let t36 = 0.5_f64 * t32 - 0.8660254037844386_f64 * t31;
    let t37 = 0.8660254037844386_f64 * t28 + 0.5_f64 * t29;
    let t38 = t36 - t37;
    let t39 = t33 * t5 + t38 * t6;
    let t40 = t26 * t5 - t38 * t34;
    let t41 = 1.0_f64 / Real::sqrt(t39 * t39 + (t35 * t35 + t40 * t40));
    let t42 = t35 * t41;
    let t43 = t40 * t41;
    let t44 = t6 * t42 + t5 * t43;
    let t45 = 0.5_f64 * sC;
    let t46 = hA - (hC + (t25 * t44 - t45 * t34));
    let t47 = t39 * t41;
    let t48 = t6 * t47 - t34 * t43;
    let t49 = t45 * t5 - t25 * t48;
    let t50 = t5 * t47 + t34 * t42;
    let t51 = t45 * t6 + t25 * t50;
    let t52 = R * t22;
    let sA = q[3];
    let t53 = sA * (cos_thA * (sin_psiA * (t19 - t17) - cos_psiA * t22) - sin_thA * t24);
    let t54 = R * (t21 + t23) - (t24 * t46 + (t20 * t49 + t22 * t51) - t52 - t53);
    let t55 = sA * t34;
    let t56 = sA * t5;
    let t57 = sA * t6;
    let t58 = t53 + (t24 * t55 + (t20 * t56 + t22 * t57));
    let sB = q[7];
    let t59 = 0.5_f64 * sB;
    let t60 = 0.8660254037844386_f64 * sB;
    let hB = q[4];
    let t61 = hA + (t59 * t34 + t60 * t44 - hB);
    let t62 = t59 * t5 + t60 * t48;
    let t63 = t60 * t50 - t59 * t6;
    let t64 = R * (t23 - t21) - (t24 * t61 + (t20 * t62 - t22 * t63) - t52 - t53);
    let t65 = t64 - t58;
    let t66 = 1.0_f64 / t60;
    let t67 = t25 * t66;
    let t68 = sA + t59;
    let t69 = (t54 - t58 + t65 * t67) * (1.0_f64 / (sA + t45 + t68 * t67));
    let t70 = 0.8660254037844386_f64 * t38;
    let t71 = 0.5_f64 * t33;
    let t72 = R * t33;
    let t73 = sA * (cos_thA * (cos_psiA * t33 + sin_psiA * (t37 - t36)) - sin_thA * t26);
    let t74 = R * (t70 - t71) - (t72 + (t26 * t46 + (t38 * t49 - t33 * t51)) - t73);
    let t75 = R * t1;
    let t76 = sA * (t3 + cos_thA * (cos_psiA * t1 + sin_psiA * t2));
    let t77 = R * (t11 + t10) + (t75 - (sin_thA * t46 + (t2 * t49 + t1 * t51)) - t76);
    let t78 = R * (t70 + t71) + (t72 + (t26 * t61 + (t38 * t62 + t33 * t63)) - t73);
    let t79 = R * (t11 - t10) - (t75 + (t1 * t63 - t2 * t62 - sin_thA * t61) - t76);
    let t80 = 1.7320508075688772_f64 * t79;
    let t81 = t73 - (t33 * t57 - t38 * t56 - t26 * t55);
    let t82 = 2.0_f64 * sB;
    let t83 = (t74 + 1.7320508075688772_f64 * t77 - (t78 - t80) - 2.0_f64 * t81) * (1.0_f64 / (t82 + 2.0_f64 * sC + 2.0_f64 * sA));
    let t84 = t24 * t83;
    let t85 = (t1 * t5 - t2 * t6 - (t7 - t8) * t69 - t84) * (1.0_f64 / (cos_thA * cos_thA));
    let t86 = (t34 - sin_thA + t24 * t69 + t26 * t83) * (1.0_f64 / cos_thA);
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
    let t98 = 0.5_f64 * t26;
    let t99 = t97 - t98;
    let t100 = t66 * (t65 - t68 * t69);
    let t101 = t91 * (t92 + t93) - t94 * (t95 - t96) - 0.8660254037844386_f64 * t99 * t100 - 0.5_f64 * t99 * t69;
    let t102 = (t101 - t84) * (1.0_f64 / (cos_thB * cos_thB));
    let t103 = 0.5_f64 * t24 * t69;
    let t104 = 0.5_f64 * t34;
    let t105 = 0.8660254037844386_f64 * t44;
    let t106 = 0.8660254037844386_f64 * t24 * t100;
    let t107 = (t99 * t83 - (t103 + (sin_thB + (t104 + t105) + t106))) * (1.0_f64 / cos_thB);
    let t108 = t97 + t98;
    let t109 = cos_thC * sin_psiC;
    let t110 = 0.8660254037844386_f64 * t109;
    let t111 = cos_thC * cos_psiC;
    let t112 = 0.5_f64 * t111;
    let t113 = 0.8660254037844386_f64 * t111 + 0.5_f64 * t109;
    let t114 = (t110 - t112) * (t92 - t93) + t113 * (t96 + t95) + 0.8660254037844386_f64 * t108 * t100;
    let t115 = (0.5_f64 * t108 * t69 - t114 - t84) * (1.0_f64 / (cos_thC * cos_thC));
    let t116 = (t106 - (sin_thC + (t104 - t105)) - t103 - t108 * t83) * (1.0_f64 / cos_thC);
    let t117 = sA * cos_thA;
    let t118 = sin_psiA * t117;
    let t119 = 0.8660254037844386_f64 * R;
    let t120 = sB * cos_thB;
    let t121 = sin_psiB * t120;
    let t122 = cos_psiB * t120;
    let t123 = R - cos_psiA * t117 + 0.5_f64 * R;
    let t124 = Real::max(Real::abs(t118 + t119 + (0.5_f64 * t121 - 0.8660254037844386_f64 * t122)), Real::abs(t123 - (0.5_f64 * t122 + 0.8660254037844386_f64 * t121)));
    let t125 = sA * sin_thA;
    let t126 = sC * cos_thC;
    let t127 = cos_psiC * t126;
    let t128 = sin_psiC * t126;
    let t129 = Real::max(Real::max(t124, Real::abs(hA - hB + t125 - sB * sin_thB)), Real::abs(t118 - t119 + (0.8660254037844386_f64 * t127 + 0.5_f64 * t128)));
    let t130 = Real::max(Real::max(t129, Real::abs(t123 + (0.8660254037844386_f64 * t128 - 0.5_f64 * t127))), Real::abs(t125 + (hA - hC) - sC * sin_thC));
    let t131 = Real::max(Real::max(t130, Real::abs(t2 + t94 - t113)), Real::abs(t112 - t110 + (t91 - t1)));
    let t132 = Real::max(t131, Real::abs(sin_thC + (sin_thA + sin_thB)));
    ([t85, t86, t88, t102, t107, -2.0_f64 * (t79 - t60 * t83 - t87), t115, t116, -2.0_f64 * (t25 * t83 - t77 - t87)], t132)
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
