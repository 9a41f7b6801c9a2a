// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 762 operations (12 abs, 144 add, 15 div, 11 min, 448 mul, 4 sqrt, 128 sub).
// Cost of energy: 265 operations (51 add, 12 div, 173 mul, 4 sqrt, 25 sub).
// Cost of speeds: 182 operations (29 add, 12 div, 109 mul, 4 sqrt, 28 sub).
// Cost of outputs: 86 operations (11 add, 3 asin, 3 atan2, 1 cos, 4 div, 47 mul, 1 sin, 2 sqrt, 14 sub).
// Cost of projection: 0 operations ().

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
pub const NOMINAL: [f64; 3usize] = [0f64, 0f64, 0f64];
/// Tunable parameters, SI units.
#[derive(Clone, Copy, Debug)]
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
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///762 operations.
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
    p: &Parameters,
) -> ([S; 3usize], [S; 3usize], S) {
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let FA = inputs[0];
    let c = p.c;
    let ms = p.ms;
    let g = p.g;
    let mc = p.mc;
    let t1 = ms * g + mc * g;
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let R = p.R;
    let t2 = 1.0_f64 / (3.0_f64 * R);
    let t3 = 2.0_f64 * (hA - 0.5_f64 * hB - 0.5_f64 * hC) * t2;
    let t4 = t3 * t3;
    let t5 = 2.0_f64 * (0.8660254037844386_f64 * hB - 0.8660254037844386_f64 * hC) * t2;
    let t6 = t5 * t5;
    let root = Real::sqrt(1.0_f64 + t4 + t6);
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t7 = 0.5_f64 * t3;
    let t8 = 0.8660254037844386_f64 * t5;
    let alongC = t7 + t8;
    let t9 = v_G_z_per_u_hA * alongC;
    let t10 = 0.5773502691896257_f64 * t9;
    let alongB = t7 - t8;
    let t11 = v_G_z_per_u_hA * alongB;
    let t12 = 0.5773502691896257_f64 * t11;
    let v_G_y_per_u_hA = t10 - t12;
    let M = p.M;
    let t13 = 1.3333333333333333_f64 * M;
    let cos2 = t4 - t6;
    let t14 = 0.5_f64 * (t4 + t6);
    let t15 = 1.0_f64 / (1.0_f64 + root);
    let sA = R * (1.0_f64 + (cos2 + t14) * t15);
    let t16 = t14 - 0.5_f64 * cos2;
    let sin2 = t5 * (2.0_f64 * t3);
    let t17 = 0.8660254037844386_f64 * sin2;
    let sB = R * (1.0_f64 + t15 * (t16 - t17));
    let sC = R * (1.0_f64 + t15 * (t16 + t17));
    let t18 = sA + (sB + sC);
    let t19 = 1.0_f64 / t18;
    let w_platform_z_per_u_hA = v_G_y_per_u_hA * t19;
    let t20 = t3 * v_G_z_per_u_hA;
    let t21 = 0.8660254037844386_f64 * t20;
    let t22 = 0.5_f64 * v_G_y_per_u_hA;
    let t23 = t21 + t22;
    let t24 = t23 * t19;
    let t25 = t22 - t21;
    let t26 = t25 * t19;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * t24 - u_hC * t26;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t27 = 0.5773502691896257_f64 * v_G_y;
    let t28 = 1.1547005383792515_f64 * t23;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t29 = u_hB * t28 + v_G_x_per_w_platform_z * w_platform_z;
    let u_sA = u_hA * t20 + (t27 - t29);
    let t30 = 0.8660254037844386_f64 * sB;
    let t31 = 0.8660254037844386_f64 * sC;
    let t32 = 1.0_f64 / t31;
    let w_platform_x_per_u_hA = v_G_z_per_u_hA * t32;
    let t33 = t30 * w_platform_x_per_u_hA;
    let w_platform_x_per_w_platform_y = (sA + 0.5_f64 * sC) * t32;
    let t34 = sA + 0.5_f64 * sB + t30 * w_platform_x_per_w_platform_y;
    let t35 = 1.0_f64 / t34;
    let w_platform_y_per_u_hC = t33 * t35;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t35;
    let t36 = (v_G_z_per_u_hA + t33) * t35;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * t36);
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y + (u_hA * w_platform_x_per_u_hA - u_hC * w_platform_x_per_u_hA);
    let t37 = w_platform_y * w_platform_x;
    let t38 = 2.0_f64 * (w_platform_z * u_sA) + sA * t37;
    let t39 = 0.8660254037844386_f64 * w_platform_y;
    let t40 = 0.5_f64 * w_platform_x;
    let t41 = t39 - t40;
    let t42 = 0.8660254037844386_f64 * w_platform_x;
    let t43 = 0.5_f64 * w_platform_y;
    let t44 = t42 + t43;
    let t45 = t41 * t44;
    let t46 = sB * t45;
    let v_G_x = t29 - t27;
    let t47 = 0.5_f64 * v_G_x;
    let t48 = 0.8660254037844386_f64 * v_G_y_per_u_hA;
    let t49 = 0.5_f64 * t20;
    let u_sB_per_u_hB = t48 - t49;
    let t50 = 0.8660254037844386_f64 * v_G_y;
    let u_sB = t47 + u_hB * u_sB_per_u_hB - t50;
    let t51 = 2.0_f64 * (w_platform_z * u_sB);
    let t52 = M * (1.1547005383792515_f64 * (t46 - t51)) - M * (g * t20);
    let t53 = t13 * t38 - (M * (g * v_G_y_per_u_hA) + 0.5773502691896257_f64 * t52);
    let t54 = 0.5773502691896257_f64 * M;
    let t55 = t54 * v_G_x_per_w_platform_z;
    let t56 = t13 * sA;
    let t57 = v_G_y_per_u_hA * (t55 + t56);
    let t58 = t40 + t39;
    let t59 = t42 - t43;
    let t60 = t58 * t59;
    let t61 = t49 + t48;
    let u_sC = t50 + (t47 - u_hC * t61);
    let w_platform_z_dot_bias = t19 * (sC * t60 - 2.0_f64 * (w_platform_z * u_sC) - (t51 - t46) - t38);
    let t62 = 1.0_f64 - t9 * t9;
    let t63 = Real::sqrt(t62);
    let t64 = 1.0_f64 / t63;
    let u_thC_per_w_platform_z = t25 * t64;
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let t65 = Ic1 - Ic3;
    let t66 = 1.0_f64 / t62;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t66;
    let u_psiC_per_w_platform_y = 0.5_f64 * t25 * t66;
    let t67 = 0.8660254037844386_f64 * t25 * t66;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - t67 * w_platform_x);
    let t68 = t63 * u_psiC;
    let t69 = t9 * u_psiC;
    let t70 = t68 * t69;
    let Ic2 = p.Ic2;
    let t71 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let u_thC_per_w_platform_x = t71 * t64;
    let t72 = 0.5_f64 * v_G_z_per_u_hA;
    let t73 = t72 * t64;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t73 * w_platform_y);
    let t74 = w_platform_z * w_platform_z;
    let t75 = w_platform_z * t58;
    let t76 = t63 * t70 - t9 * (u_thC * u_thC + t68 * t68) + (t61 * (t74 + t59 * t59) + t25 * t60 - v_G_z_per_u_hA * t75);
    let t77 = t65 * t70 + Ic2 * (t64 * t76);
    let Iy = p.Iy;
    let Ix = p.Ix;
    let t78 = 1.0_f64 - t20 * t20;
    let t79 = Real::sqrt(t78);
    let t80 = 1.0_f64 / t79;
    let t81 = v_G_y_per_u_hA * t80;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t80;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - t81 * w_platform_z;
    let t82 = 1.0_f64 / t78;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t82;
    let t83 = (t12 - t10) * t82;
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - t83 * w_platform_y;
    let t84 = t79 * u_psiA;
    let t85 = t20 * u_psiA;
    let t86 = t84 * t85;
    let t87 = w_platform_x * w_platform_z;
    let t88 = t20 * (u_thA * u_thA + t84 * t84) - t79 * t86 + (v_G_z_per_u_hA * t87 + (v_G_y_per_u_hA * t37 - t20 * (w_platform_y * w_platform_y + t74)));
    let t89 = Ic2 * (t80 * t88) - t65 * t86;
    let t90 = 1.0_f64 - t11 * t11;
    let t91 = Real::sqrt(t90);
    let t92 = 1.0_f64 / t91;
    let t93 = t23 * t92;
    let t94 = 1.0_f64 / t90;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t94;
    let t95 = 0.8660254037844386_f64 * t23 * t94;
    let t96 = 0.5_f64 * t23 * t94;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z + (t95 * w_platform_x + t96 * w_platform_y);
    let t97 = t91 * u_psiB;
    let t98 = t11 * u_psiB;
    let t99 = t97 * t98;
    let t100 = t71 * t92;
    let t101 = t72 * t92;
    let t102 = t100 * w_platform_x + t101 * w_platform_y - t93 * w_platform_z;
    let t103 = w_platform_z * t41;
    let t104 = t91 * t99 - t11 * (t102 * t102 + t97 * t97) + (v_G_z_per_u_hA * t103 - (u_sB_per_u_hB * (t74 + t44 * t44) - t23 * t45));
    let t105 = t65 * t99 + Ic2 * (t92 * t104);
    let t106 = t20 * (Ic1 * t20) + t79 * (Ic3 * t79);
    let t107 = u_thA * t85;
    let t108 = u_psiA * u_thA;
    let t109 = t20 * t108;
    let t110 = Ic3 - Ic2;
    let t111 = Ic2 - Ic1;
    let t112 = t20 * (t110 * (u_thA * t84) - Ic1 * (t79 * t108)) + t79 * (Ic3 * t109 + t111 * t107);
    let t113 = t106 * (t82 * (t79 * (t107 + t109) + (v_G_y_per_u_hA * t87 - v_G_z_per_u_hA * t37))) - t112;
    let t114 = u_thC_per_w_platform_z * t77 - ((Iy - Ix) * t37 + t81 * t89 - t93 * t105) + u_psiA_per_w_platform_z * t113;
    let t115 = u_psiB * t102;
    let t116 = t11 * t115;
    let t117 = t102 * t98;
    let t118 = t11 * (Ic1 * (t91 * t115) - t110 * (t102 * t97)) - t91 * (Ic3 * t116 + t111 * t117);
    let t119 = t11 * (Ic1 * t11) + t91 * (Ic3 * t91);
    let t120 = t118 + t119 * (t94 * (t91 * (t117 + t116) + (v_G_z_per_u_hA * t45 - t23 * t103)));
    let t121 = u_psiC * u_thC;
    let t122 = t9 * t121;
    let t123 = u_thC * t69;
    let t124 = t9 * (t110 * (u_thC * t68) - Ic1 * (t63 * t121)) + t63 * (Ic3 * t122 + t111 * t123);
    let t125 = t9 * (Ic1 * t9) + t63 * (Ic3 * t63);
    let u_psiC_dot_bias = t66 * (t63 * (t123 + t122) - (v_G_z_per_u_hA * t60 + t25 * t75));
    let t126 = t124 - t125 * u_psiC_dot_bias;
    let t127 = t114 + u_psiB_per_w_platform_z * t120 + u_psiC_per_w_platform_z * t126 + v_G_x_per_w_platform_z * t52 - t38 * t55 - sA * t53;
    let Iz = p.Iz;
    let t128 = Ic2 * t81;
    let t129 = Ic2 * t93;
    let t130 = Ic2 * u_thC_per_w_platform_z;
    let t131 = u_psiA_per_w_platform_z * t106;
    let t132 = u_psiB_per_w_platform_z * t119;
    let t133 = Iz + t81 * t128 + t93 * t129 + u_thC_per_w_platform_z * t130 + u_psiA_per_w_platform_z * t131 + u_psiB_per_w_platform_z * t132;
    let t134 = u_psiC_per_w_platform_z * t125;
    let t135 = M * v_G_x_per_w_platform_z;
    let t136 = t133 + u_psiC_per_w_platform_z * t134 + v_G_x_per_w_platform_z * t135 + sA * (t56 + 2.0_f64 * t55);
    let t137 = t127 - t136 * w_platform_z_dot_bias;
    let t138 = FA - u_hA * c - t1 + v_G_y_per_u_hA * t53 + t57 * w_platform_z_dot_bias + w_platform_z_per_u_hA * t137;
    let v_G_z_dot_bias = 2.0_f64 * (w_platform_y * u_sA) - sA * t87;
    let t139 = M * (g * v_G_z_per_u_hA) + M * v_G_z_dot_bias;
    let t140 = u_thC_per_w_platform_x * t130 - t100 * t129 + t95 * t132 - t67 * t134;
    let t141 = w_platform_z_per_u_hA * t140;
    let t142 = t32 * (2.0_f64 * (u_sC * t59) + sC * t75 - v_G_z_dot_bias);
    let t143 = u_thC_per_w_platform_x * t77 - ((Iz - Iy) * (w_platform_y * w_platform_z) + t100 * t105) + t95 * t120;
    let t144 = Ix + t100 * (Ic2 * t100) + u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + t95 * (t95 * t119);
    let t145 = t144 + t67 * (t67 * t125);
    let t146 = t143 - t67 * t126 - t140 * w_platform_z_dot_bias + t145 * t142;
    let t147 = w_platform_x_per_u_hA * t146;
    let t148 = t96 * t132 - (u_thA_per_w_platform_y * t128 + t101 * t129 + t73 * t130 + t83 * t131);
    let t149 = t148 + u_psiC_per_w_platform_y * t134;
    let t150 = M * sA;
    let t151 = Ic2 * t101;
    let t152 = Ic2 * t73;
    let t153 = t96 * t119;
    let t154 = u_psiC_per_w_platform_y * t125;
    let t155 = t100 * t151 - u_thC_per_w_platform_x * t152 + t95 * t153 - t67 * t154;
    let t156 = w_platform_x_per_w_platform_y * t145;
    let t157 = w_platform_x_per_u_hA * (t155 + t156);
    let t158 = w_platform_z_per_u_hA * t149 + v_G_z_per_u_hA * t150 + t157 + w_platform_x_per_w_platform_y * t141;
    let w_platform_y_dot_bias = t35 * (t30 * t142 - (2.0_f64 * (u_sB * t44) + sB * t103 + v_G_z_dot_bias));
    let t159 = u_thA_per_w_platform_y * t89 - (Ix - Iz) * t87 - t101 * t105 - t73 * t77 - t83 * t113;
    let t160 = t159 + t96 * t120 + u_psiC_per_w_platform_y * t126 - t149 * w_platform_z_dot_bias - sA * t139 + t155 * t142;
    let t161 = Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y) + t101 * t151 + t73 * t152 + t83 * (t83 * t106);
    let t162 = t161 + t96 * t153 + u_psiC_per_w_platform_y * t154 + sA * t150 + w_platform_x_per_w_platform_y * (t156 + 2.0_f64 * t155);
    let t163 = t160 + w_platform_x_per_w_platform_y * t146 - t162 * w_platform_y_dot_bias;
    let forcing_u_hA = t138 - v_G_z_per_u_hA * t139 + t141 * t142 + t147 - t158 * w_platform_y_dot_bias - t36 * t163;
    let mr = p.mr;
    let t164 = mc + (ms + mr);
    let t165 = v_G_z_per_u_hA * (M * v_G_z_per_u_hA) + (t164 + v_G_y_per_u_hA * (t13 * v_G_y_per_u_hA) + w_platform_z_per_u_hA * (w_platform_z_per_u_hA * t136 - 2.0_f64 * t57));
    let t166 = w_platform_x_per_u_hA * t145;
    let mass_u_hA_u_hA = t165 + w_platform_x_per_u_hA * (t166 + 2.0_f64 * t141) - t36 * (2.0_f64 * t158 - t36 * t162);
    let t167 = 1.0_f64 / mass_u_hA_u_hA;
    let t168 = t54 * t28;
    let t169 = t28 * t135 + sA * t168;
    let t170 = t24 * t136;
    let t171 = t24 * t140;
    let t172 = w_platform_x_per_u_hA * t171;
    let t173 = w_platform_y_per_u_hB * t162;
    let t174 = t24 * t149 + w_platform_x_per_w_platform_y * t171;
    let t175 = w_platform_z_per_u_hA * (t169 - t170) - v_G_y_per_u_hA * t168 + t24 * t57 - t172 - t36 * (t173 - t174);
    let mass_u_hA_u_hB = t175 + w_platform_y_per_u_hB * t158;
    let t176 = mass_u_hA_u_hB * t167;
    let mass_u_hB_u_hB = t164 + t28 * (M * t28) - t24 * (2.0_f64 * t169 - t170) + w_platform_y_per_u_hB * (t173 - 2.0_f64 * t174);
    let pivot_1 = mass_u_hB_u_hB - mass_u_hA_u_hB * t176;
    let t177 = 1.0_f64 / pivot_1;
    let FB = inputs[1];
    let t178 = FB - u_hB * c - t1 + t28 * t52 - t38 * t168 - t169 * w_platform_z_dot_bias;
    let forcing_u_hB = t178 - t24 * t137 - t171 * t142 + t174 * w_platform_y_dot_bias + w_platform_y_per_u_hB * t163;
    let t179 = forcing_u_hB - forcing_u_hA * t176;
    let t180 = t26 * t136;
    let t181 = w_platform_y_per_u_hC * t162;
    let t182 = t26 * t140;
    let t183 = t26 * t149 + t157 + w_platform_x_per_w_platform_y * t182;
    let t184 = t181 - t183;
    let mass_u_hB_u_hC = t24 * t180 - t26 * t169 + t172 + w_platform_y_per_u_hB * t184 - w_platform_y_per_u_hC * t174;
    let t185 = t26 * t57 - w_platform_z_per_u_hA * t180 - w_platform_x_per_u_hA * (t182 + t166) - w_platform_x_per_u_hA * t141 - t36 * t184;
    let mass_u_hA_u_hC = t185 + w_platform_y_per_u_hC * t158;
    let t186 = mass_u_hB_u_hC - mass_u_hA_u_hC * t176;
    let t187 = t186 * t177;
    let FC = inputs[2];
    let t188 = FC - u_hC * c - t1 - t26 * t137 - t182 * t142 - t147 + t183 * w_platform_y_dot_bias;
    let forcing_u_hC = t188 + w_platform_y_per_u_hC * t163;
    let t189 = mass_u_hA_u_hC * t167;
    let mass_u_hC_u_hC = t164 + t26 * t180 + w_platform_x_per_u_hA * (t166 + 2.0_f64 * t182) + w_platform_y_per_u_hC * (t181 - 2.0_f64 * t183);
    let pivot_2 = mass_u_hC_u_hC - mass_u_hA_u_hC * t189 - t186 * t187;
    let t190 = (forcing_u_hC - forcing_u_hA * t189 - t187 * t179) / pivot_2;
    let t191 = t177 * t179 - t187 * t190;
    let t192 = forcing_u_hA * t167 - t176 * t191 - t189 * t190;
    let t193 = Real::min(Real::min(Real::min(Real::min(Real::abs(t79), Real::abs(t91)), Real::abs(t63)), Real::abs(t78)), Real::abs(t90));
    let t194 = Real::min(Real::min(Real::min(t193, Real::abs(t62)), 1.6666666666666665_f64 * Real::min(Real::abs(t18), Real::abs(t34))), 5.773502691896257_f64 * Real::abs(t31));
    let t195 = Real::min(Real::min(Real::min(t194, 0.2165283291230603_f64 * Real::abs(mass_u_hA_u_hA)), 0.21680787182359307_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t192, t191, t190], t195)
}
///Kinetic and potential energy (J).
///
///265 operations.
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
    p: &Parameters,
) -> (S, S) {
    let mc = p.mc;
    let ms = p.ms;
    let mr = p.mr;
    let t1 = mc + (ms + mr);
    let u_hC = u[2];
    let u_hB = u[1];
    let u_hA = u[0];
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let R = p.R;
    let t2 = 1.0_f64 / (3.0_f64 * R);
    let t3 = 2.0_f64 * (hA - 0.5_f64 * hB - 0.5_f64 * hC) * t2;
    let t4 = t3 * t3;
    let t5 = 2.0_f64 * (0.8660254037844386_f64 * hB - 0.8660254037844386_f64 * hC) * t2;
    let t6 = t5 * t5;
    let root = Real::sqrt(1.0_f64 + t4 + t6);
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t7 = t3 * v_G_z_per_u_hA;
    let Ic1 = p.Ic1;
    let t8 = 1.0_f64 - t7 * t7;
    let t9 = Real::sqrt(t8);
    let Ic3 = p.Ic3;
    let t10 = 1.0_f64 / t8;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t10;
    let t11 = 0.5_f64 * t3;
    let t12 = 0.8660254037844386_f64 * t5;
    let alongC = t11 + t12;
    let t13 = v_G_z_per_u_hA * alongC;
    let t14 = 0.5773502691896257_f64 * t13;
    let alongB = t11 - t12;
    let t15 = v_G_z_per_u_hA * alongB;
    let t16 = 0.5773502691896257_f64 * t15;
    let v_G_y_per_u_hA = t14 - t16;
    let cos2 = t4 - t6;
    let t17 = 0.5_f64 * (t4 + t6);
    let t18 = 1.0_f64 / (1.0_f64 + root);
    let sA = R * (1.0_f64 + (cos2 + t17) * t18);
    let t19 = t17 - 0.5_f64 * cos2;
    let sin2 = t5 * (2.0_f64 * t3);
    let t20 = 0.8660254037844386_f64 * sin2;
    let sB = R * (1.0_f64 + t18 * (t19 - t20));
    let sC = R * (1.0_f64 + t18 * (t19 + t20));
    let t21 = 1.0_f64 / (sA + (sB + sC));
    let w_platform_z_per_u_hA = v_G_y_per_u_hA * t21;
    let t22 = 0.8660254037844386_f64 * t7;
    let t23 = 0.5_f64 * v_G_y_per_u_hA;
    let t24 = t22 + t23;
    let t25 = t23 - t22;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * (t24 * t21) - u_hC * (t25 * t21);
    let t26 = 0.8660254037844386_f64 * sB;
    let t27 = 1.0_f64 / (0.8660254037844386_f64 * sC);
    let w_platform_x_per_u_hA = v_G_z_per_u_hA * t27;
    let t28 = t26 * w_platform_x_per_u_hA;
    let w_platform_x_per_w_platform_y = (sA + 0.5_f64 * sC) * t27;
    let t29 = 1.0_f64 / (sA + 0.5_f64 * sB + t26 * w_platform_x_per_w_platform_y);
    let w_platform_y_per_u_hC = t28 * t29;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t29;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * ((v_G_z_per_u_hA + t28) * t29));
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - (t16 - t14) * t10 * w_platform_y;
    let t30 = 0.5_f64 * (t1 * (u_hA * u_hA)) + 0.5_f64 * ((t7 * (Ic1 * t7) + t9 * (Ic3 * t9)) * (u_psiA * u_psiA));
    let Ic2 = p.Ic2;
    let t31 = 1.0_f64 / t9;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t31;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t31 * w_platform_z;
    let t32 = 1.0_f64 - t15 * t15;
    let t33 = Real::sqrt(t32);
    let t34 = 1.0_f64 / t32;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t34;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y + (u_hA * w_platform_x_per_u_hA - u_hC * w_platform_x_per_u_hA);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z + (0.8660254037844386_f64 * t24 * t34 * w_platform_x + 0.5_f64 * t24 * t34 * w_platform_y);
    let t35 = 0.5_f64 * (t1 * (u_hB * u_hB)) + (t30 + 0.5_f64 * (Ic2 * (u_thA * u_thA))) + 0.5_f64 * ((t15 * (Ic1 * t15) + t33 * (Ic3 * t33)) * (u_psiB * u_psiB));
    let t36 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t37 = 1.0_f64 / t33;
    let t38 = 0.5_f64 * v_G_z_per_u_hA;
    let t39 = t36 * t37 * w_platform_x + t38 * t37 * w_platform_y - t24 * t37 * w_platform_z;
    let t40 = 1.0_f64 - t13 * t13;
    let t41 = Real::sqrt(t40);
    let t42 = 1.0_f64 / t40;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t42;
    let u_psiC_per_w_platform_y = 0.5_f64 * t25 * t42;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - 0.8660254037844386_f64 * t25 * t42 * w_platform_x);
    let t43 = 0.5_f64 * (t1 * (u_hC * u_hC)) + (t35 + 0.5_f64 * (Ic2 * (t39 * t39))) + 0.5_f64 * ((t13 * (Ic1 * t13) + t41 * (Ic3 * t41)) * (u_psiC * u_psiC));
    let t44 = 1.0_f64 / t41;
    let u_thC_per_w_platform_z = t25 * t44;
    let u_thC_per_w_platform_x = t36 * t44;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t38 * t44 * w_platform_y);
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t45 = t43 + 0.5_f64 * (Ic2 * (u_thC * u_thC)) + 0.5_f64 * (Ix * (w_platform_x * w_platform_x)) + 0.5_f64 * (Iy * (w_platform_y * w_platform_y));
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = u_hB * (1.1547005383792515_f64 * t24) + v_G_x_per_w_platform_z * w_platform_z - 0.5773502691896257_f64 * v_G_y;
    let t46 = t45 + 0.5_f64 * (Iz * (w_platform_z * w_platform_z)) + 0.5_f64 * (M * (v_G_x * v_G_x)) + 0.5_f64 * (M * (v_G_y * v_G_y));
    let v_G_z = u_hA * v_G_z_per_u_hA + sA * w_platform_y;
    let t47 = t46 + 0.5_f64 * (M * (v_G_z * v_G_z));
    let g = p.g;
    let t48 = hA * g;
    let t49 = hB * g;
    let t50 = hC * g;
    let t51 = ms * t48 + mc * t48 + ms * t49 + mc * t49 + ms * t50;
    let t52 = t51 + mc * t50 + M * (t48 - t7 * (g * sA));
    (t47, t52)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///182 operations.
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
    p: &Parameters,
) -> [S; 12usize] {
    let u_hA = u[0];
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let R = p.R;
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let t2 = 2.0_f64 * (hA - 0.5_f64 * hB - 0.5_f64 * hC) * t1;
    let t3 = t2 * t2;
    let t4 = 2.0_f64 * (0.8660254037844386_f64 * hB - 0.8660254037844386_f64 * hC) * t1;
    let t5 = t4 * t4;
    let root = Real::sqrt(1.0_f64 + t3 + t5);
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t6 = t2 * v_G_z_per_u_hA;
    let t7 = 1.0_f64 - t6 * t6;
    let t8 = 1.0_f64 / t7;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t8;
    let t9 = 0.5_f64 * t2;
    let t10 = 0.8660254037844386_f64 * t4;
    let alongC = t9 + t10;
    let t11 = v_G_z_per_u_hA * alongC;
    let t12 = 0.5773502691896257_f64 * t11;
    let alongB = t9 - t10;
    let t13 = v_G_z_per_u_hA * alongB;
    let t14 = 0.5773502691896257_f64 * t13;
    let v_G_y_per_u_hA = t12 - t14;
    let cos2 = t3 - t5;
    let t15 = 0.5_f64 * (t3 + t5);
    let t16 = 1.0_f64 / (1.0_f64 + root);
    let sA = R * (1.0_f64 + (cos2 + t15) * t16);
    let t17 = t15 - 0.5_f64 * cos2;
    let sin2 = t4 * (2.0_f64 * t2);
    let t18 = 0.8660254037844386_f64 * sin2;
    let sB = R * (1.0_f64 + t16 * (t17 - t18));
    let sC = R * (1.0_f64 + t16 * (t17 + t18));
    let t19 = 1.0_f64 / (sA + (sB + sC));
    let w_platform_z_per_u_hA = v_G_y_per_u_hA * t19;
    let u_hB = u[1];
    let t20 = 0.8660254037844386_f64 * t6;
    let t21 = 0.5_f64 * v_G_y_per_u_hA;
    let t22 = t20 + t21;
    let u_hC = u[2];
    let t23 = t21 - t20;
    let w_platform_z = u_hA * w_platform_z_per_u_hA - u_hB * (t22 * t19) - u_hC * (t23 * t19);
    let t24 = 0.8660254037844386_f64 * sB;
    let t25 = 1.0_f64 / (0.8660254037844386_f64 * sC);
    let w_platform_x_per_u_hA = v_G_z_per_u_hA * t25;
    let t26 = t24 * w_platform_x_per_u_hA;
    let w_platform_x_per_w_platform_y = (sA + 0.5_f64 * sC) * t25;
    let t27 = 1.0_f64 / (sA + 0.5_f64 * sB + t24 * w_platform_x_per_w_platform_y);
    let w_platform_y_per_u_hC = t26 * t27;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t27;
    let w_platform_y = u_hC * w_platform_y_per_u_hC + (u_hB * w_platform_y_per_u_hB - u_hA * ((v_G_z_per_u_hA + t26) * t27));
    let u_psiA = u_psiA_per_w_platform_z * w_platform_z - (t14 - t12) * t8 * w_platform_y;
    let t28 = 1.0_f64 / Real::sqrt(t7);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t28;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t28 * w_platform_z;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let t29 = 0.5773502691896257_f64 * v_G_y;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t30 = u_hB * (1.1547005383792515_f64 * t22) + v_G_x_per_w_platform_z * w_platform_z;
    let u_sA = u_hA * t6 + (t29 - t30);
    let t31 = 1.0_f64 - t13 * t13;
    let t32 = 1.0_f64 / t31;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t32;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y + (u_hA * w_platform_x_per_u_hA - u_hC * w_platform_x_per_u_hA);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z + (0.8660254037844386_f64 * t22 * t32 * w_platform_x + 0.5_f64 * t22 * t32 * w_platform_y);
    let t33 = 1.0_f64 / Real::sqrt(t31);
    let t34 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t35 = 0.5_f64 * v_G_z_per_u_hA;
    let u_thB = t22 * t33 * w_platform_z - (t34 * t33 * w_platform_x + t35 * t33 * w_platform_y);
    let v_G_x = t30 - t29;
    let t36 = 0.5_f64 * v_G_x;
    let t37 = 0.8660254037844386_f64 * v_G_y_per_u_hA;
    let t38 = 0.5_f64 * t6;
    let u_sB_per_u_hB = t37 - t38;
    let t39 = 0.8660254037844386_f64 * v_G_y;
    let u_sB = t36 + u_hB * u_sB_per_u_hB - t39;
    let t40 = 1.0_f64 - t11 * t11;
    let t41 = 1.0_f64 / t40;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t41;
    let u_psiC_per_w_platform_y = 0.5_f64 * t23 * t41;
    let u_psiC = u_psiC_per_w_platform_z * w_platform_z + (u_psiC_per_w_platform_y * w_platform_y - 0.8660254037844386_f64 * t23 * t41 * w_platform_x);
    let t42 = 1.0_f64 / Real::sqrt(t40);
    let u_thC_per_w_platform_z = t23 * t42;
    let u_thC_per_w_platform_x = t34 * t42;
    let u_thC = u_thC_per_w_platform_z * w_platform_z + (u_thC_per_w_platform_x * w_platform_x - t35 * t42 * w_platform_y);
    let u_sC = t39 + (t36 - u_hC * (t38 + t37));
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, u_sB, u_hC, u_psiC, u_thC, u_sC]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///86 operations.
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
    p: &Parameters,
) -> [S; 12usize] {
    let R = p.R;
    let hA = q[0];
    let hB = q[1];
    let hC = q[2];
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let t2 = 2.0_f64 * (hA - 0.5_f64 * hB - 0.5_f64 * hC) * t1;
    let t3 = t2 * t2;
    let t4 = 2.0_f64 * (0.8660254037844386_f64 * hB - 0.8660254037844386_f64 * hC) * t1;
    let t5 = t4 * t4;
    let cos2 = t3 - t5;
    let t6 = 0.5_f64 * (t3 + t5);
    let root = Real::sqrt(1.0_f64 + t3 + t5);
    let t7 = 1.0_f64 + root;
    let t8 = 1.0_f64 / t7;
    let sA = R * (1.0_f64 + (cos2 + t6) * t8);
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t9 = t2 * v_G_z_per_u_hA;
    let t10 = Real::sqrt(1.0_f64 - t9 * t9);
    let k = 1.0_f64 / (root * t7);
    let psiA = Real::atan2(-t4 * (t2 * k), 1.0_f64 - t3 * k);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t11 = sA * (t10 * sin_psiA);
    let t12 = R - sA * (t10 * cos_psiA);
    let t13 = hA - t9 * sA;
    let thA = -Real::asin(t9);
    let t14 = 0.5_f64 * t4;
    let t15 = 0.8660254037844386_f64 * t2;
    let acrossB = t14 + t15;
    let t16 = 0.5_f64 * t2;
    let t17 = 0.8660254037844386_f64 * t4;
    let alongB = t16 - t17;
    let psiB = Real::atan2(-acrossB * (k * alongB), 1.0_f64 - k * (alongB * alongB));
    let thB = Real::asin(v_G_z_per_u_hA * alongB);
    let t18 = t6 - 0.5_f64 * cos2;
    let sin2 = t4 * (2.0_f64 * t2);
    let t19 = 0.8660254037844386_f64 * sin2;
    let sB = R * (1.0_f64 + t8 * (t18 - t19));
    let acrossC = t14 - t15;
    let alongC = t16 + t17;
    let psiC = Real::atan2(-acrossC * (k * alongC), 1.0_f64 - k * (alongC * alongC));
    let thC = Real::asin(v_G_z_per_u_hA * alongC);
    let sC = R * (1.0_f64 + t8 * (t18 + t19));
    [t11, t12, t13, psiA, thA, sA, psiB, thB, sB, psiC, thC, sC]
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
    _p: &Parameters,
) -> ([S; 0usize], S) {
    ([], 0.0_f64)
}
///Three-legged tile in minimal coordinates: three heights, everything else in closed form.
#[derive(Clone, Copy, Debug, Default)]
pub struct TileMinimal {
    /// Tunable parameters.
    pub parameters: Parameters,
}
impl TileMinimal {
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
