// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 764 operations (12 abs, 144 add, 15 div, 11 min, 447 mul, 4 sqrt, 131 sub).
// Cost of energy: 256 operations (51 add, 12 div, 153 mul, 4 sqrt, 36 sub).
// Cost of speeds: 181 operations (23 add, 12 div, 109 mul, 4 sqrt, 33 sub).
// Cost of outputs: 81 operations (11 add, 3 asin, 3 atan2, 1 cos, 4 div, 43 mul, 1 sin, 2 sqrt, 13 sub).
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
///764 operations.
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
    let R = p.R;
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let t2 = t1 * (1.7320508075688772_f64 * (hB - hC));
    let hA = q[0];
    let t3 = t1 * (2.0_f64 * (0.5_f64 * hC - (hA - 0.5_f64 * hB)));
    let t4 = 0.8660254037844386_f64 * (t2 * (2.0_f64 * t3));
    let t5 = t2 * t2;
    let t6 = t3 * t3;
    let root = Real::sqrt(t5 + (1.0_f64 + t6));
    let t7 = 1.0_f64 / (1.0_f64 + root);
    let t8 = R * ((t4 - t5) * t7 - 1.0_f64);
    let t9 = 0.8660254037844386_f64 * t8;
    let t10 = 1.0_f64 / t9;
    let cos2 = t6 - t5;
    let sA = R * (1.0_f64 + t7 * (0.5_f64 * (t5 + t6) + cos2));
    let w_platform_x_per_w_platform_y = t10 * (0.5_f64 * t8 - sA);
    let sB = R * (1.0_f64 + t7 * (t5 + t4));
    let t11 = 0.8660254037844386_f64 * sB;
    let t12 = w_platform_x_per_w_platform_y * t11 + (sA + 0.5_f64 * sB);
    let t13 = 1.0_f64 / t12;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t14 = v_G_z_per_u_hA * t10;
    let t15 = t14 * t11;
    let t16 = t13 * (t15 - v_G_z_per_u_hA);
    let t17 = 0.8660254037844386_f64 * t2;
    let t18 = 0.5_f64 * t3;
    let alongC = t17 - t18;
    let t19 = alongC * v_G_z_per_u_hA;
    let t20 = t19 * t19;
    let t21 = 1.0_f64 / (t20 - 1.0_f64);
    let t22 = v_G_z_per_u_hA * (t17 + t18);
    let t23 = t19 + t22;
    let t24 = 0.28867513459481287_f64 * t23;
    let t25 = t3 * v_G_z_per_u_hA;
    let t26 = 0.8660254037844386_f64 * t25;
    let t27 = t24 + t26;
    let t28 = t21 * (0.8660254037844386_f64 * t27);
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let Ic2 = p.Ic2;
    let t29 = 0.5_f64 * (Ic1 + Ic3 - Ic2);
    let t30 = 0.5_f64 * (Ic1 + Ic2 - Ic3);
    let t31 = 0.5_f64 * (Ic1 - (Ic2 + Ic3));
    let t32 = t30 + t31;
    let t33 = t29 + (t19 * (t19 * t32) - t31);
    let t34 = 1.0_f64 - t22 * t22;
    let t35 = 1.0_f64 / t34;
    let t36 = t26 - t24;
    let t37 = t35 * (0.8660254037844386_f64 * t36);
    let t38 = t29 + (t22 * (t32 * t22) - t31);
    let t39 = 1.0_f64 - t20;
    let t40 = Real::sqrt(t39);
    let t41 = 1.0_f64 / t40;
    let t42 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let u_thC_per_w_platform_x = t41 * t42;
    let Ix = p.Ix;
    let t43 = Real::sqrt(t34);
    let t44 = 1.0_f64 / t43;
    let t45 = t42 * t44;
    let t46 = t37 * (t38 * t37) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t45 * (Ic2 * t45)));
    let t47 = t28 * (t33 * t28) + t46;
    let t48 = w_platform_x_per_w_platform_y * t47;
    let t49 = t35 * (0.5_f64 * t36);
    let t50 = t38 * t49;
    let t51 = 0.5_f64 * v_G_z_per_u_hA;
    let t52 = t44 * t51;
    let t53 = Ic2 * t52;
    let t54 = t41 * t51;
    let t55 = Ic2 * t54;
    let t56 = t21 * (0.5_f64 * t27);
    let t57 = t33 * t56;
    let t58 = t37 * t50 + (t45 * t53 - u_thC_per_w_platform_x * t55) - t28 * t57;
    let t59 = (t48 + t58) * t14;
    let M = p.M;
    let t60 = M * sA;
    let t61 = 2.0_f64 * (t8 - sB - sA);
    let t62 = 1.0_f64 / t61;
    let t63 = t62 * (1.1547005383792515_f64 * t23);
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t35;
    let t64 = t38 * u_psiB_per_w_platform_z;
    let u_thC_per_w_platform_z = t27 * t41;
    let t65 = Ic2 * u_thC_per_w_platform_z;
    let t66 = t36 * t44;
    let t67 = Ic2 * t66;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t23;
    let t68 = t25 * t25;
    let t69 = 1.0_f64 - t68;
    let t70 = Real::sqrt(t69);
    let t71 = 1.0_f64 / t70;
    let t72 = v_G_y_per_u_hA * t71;
    let t73 = Ic2 * t72;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t71;
    let t74 = t29 + (t25 * (t32 * t25) - t31);
    let t75 = 1.0_f64 / (t68 - 1.0_f64);
    let t76 = v_G_z_per_u_hA * t75;
    let t77 = t74 * t76;
    let t78 = v_G_y_per_u_hA * t75;
    let t79 = t64 * t49 + (t65 * t54 - (t67 * t52 - t73 * u_thA_per_w_platform_y) - t77 * t78);
    let t80 = v_G_z_per_u_hA * t21;
    let t81 = t33 * t80;
    let t82 = t79 - t81 * t56;
    let t83 = t81 * t28 + (t64 * t37 - (t65 * u_thC_per_w_platform_x + t67 * t45));
    let t84 = t83 * t63;
    let t85 = t59 - (v_G_z_per_u_hA * t60 + t63 * t82) - t84 * w_platform_x_per_w_platform_y;
    let Iy = p.Iy;
    let t86 = t78 * (t74 * t78) + (t54 * t55 + (t52 * t53 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t87 = w_platform_x_per_w_platform_y * (t48 + 2.0_f64 * t58) + (sA * t60 + (t56 * t57 + (t49 * t50 + t86)));
    let t88 = t47 * t14;
    let t89 = 1.3333333333333333_f64 * M;
    let t90 = t89 * sA;
    let t91 = 0.5773502691896257_f64 * M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t92 = t91 * v_G_x_per_w_platform_z;
    let t93 = v_G_y_per_u_hA * (t90 + t92);
    let t94 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t95 = u_psiB_per_w_platform_z * t64 + (t76 * t77 + (u_thC_per_w_platform_z * t65 + (t66 * t67 + (Iz + t72 * t73))));
    let t96 = sA * (t90 + 2.0_f64 * t92) + (v_G_x_per_w_platform_z * t94 + (t80 * t81 + t95));
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t97 = ms + mc;
    let t98 = mr + t97;
    let t99 = t63 * (2.0_f64 * t93 + t63 * t96) + (t98 + v_G_y_per_u_hA * (t89 * v_G_y_per_u_hA)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let t100 = t16 * (2.0_f64 * t85 - t87 * t16) + (t14 * (2.0_f64 * t84 - t88) - t99);
    let t101 = 1.0_f64 / t100;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t13;
    let t102 = t87 * w_platform_y_per_u_hB;
    let t103 = 1.7320508075688772_f64 * t25;
    let t104 = v_G_y_per_u_hA - t103;
    let t105 = t62 * t104;
    let t106 = t83 * t105;
    let t107 = w_platform_x_per_w_platform_y * t106 + t82 * t105;
    let t108 = t96 * t105;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * t104;
    let t109 = t91 * v_G_x_per_u_hB;
    let t110 = sA * t109 + t94 * v_G_x_per_u_hB;
    let t111 = t14 * t106;
    let t112 = t16 * (t102 - t107) - (t93 * t105 + (t63 * (t108 + t110) + v_G_y_per_u_hA * t109) - t111);
    let mass_u_hA_u_hB = t112 - t85 * w_platform_y_per_u_hB;
    let t113 = t101 * mass_u_hA_u_hB;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (t102 - 2.0_f64 * t107) + (t105 * (t108 + 2.0_f64 * t110) + (t98 + v_G_x_per_u_hB * (M * v_G_x_per_u_hB)));
    let pivot_1 = mass_u_hA_u_hB * t113 + mass_u_hB_u_hB;
    let t114 = 1.0_f64 / pivot_1;
    let t115 = t13 * t15;
    let t116 = t87 * t115;
    let t117 = t62 * (v_G_y_per_u_hA + t103);
    let t118 = t83 * t117;
    let t119 = t59 - t82 * t117 - w_platform_x_per_w_platform_y * t118;
    let t120 = t116 - t119;
    let t121 = t96 * t117;
    let t122 = t16 * t120 - (t84 * t14 - (t14 * (t88 - t118) + (t93 * t117 + t63 * t121)));
    let mass_u_hA_u_hC = t85 * t115 - t122;
    let mass_u_hB_u_hC = t107 * t115 - (w_platform_y_per_u_hB * t120 + (t111 - (t110 * t117 + t105 * t121)));
    let t123 = t113 * mass_u_hA_u_hC + mass_u_hB_u_hC;
    let t124 = t114 * t123;
    let w_platform_z = u_hC * t117 - (u_hA * t63 - u_hB * t105);
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * t16 - u_hC * t115;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t14 * (u_hA - u_hC);
    let t125 = w_platform_z * w_platform_x;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.5773502691896257_f64 * v_G_y;
    let t126 = u_hA * t25 + v_G_x;
    let t127 = sA * t125 + 2.0_f64 * (w_platform_y * t126);
    let t128 = 0.8660254037844386_f64 * w_platform_z;
    let t129 = w_platform_y * t128;
    let t130 = 0.5_f64 * w_platform_z;
    let t131 = w_platform_x * t130;
    let t132 = t129 - t131;
    let t133 = 0.5_f64 * w_platform_y;
    let t134 = 0.8660254037844386_f64 * w_platform_x;
    let t135 = t133 + t134;
    let t136 = 2.0_f64 * v_G_x;
    let t137 = 2.0_f64 * t25;
    let u_sB = t136 + (u_hB * t137 - w_platform_z * (1.7320508075688772_f64 * sB));
    let t138 = t129 + t131;
    let t139 = t133 - t134;
    let u_sC = t136 - (w_platform_z * (1.7320508075688772_f64 * t8) - u_hC * t137);
    let t140 = t10 * (t127 - (t8 * t138 + 2.0_f64 * (t139 * u_sC)));
    let w_platform_y_dot_bias = t13 * (t127 - (sB * t132 + 2.0_f64 * (t135 * u_sB)) - t11 * t140);
    let t141 = w_platform_y * w_platform_x;
    let t142 = 2.0_f64 * (w_platform_z * t126) - sA * t141;
    let t143 = w_platform_z * t130;
    let t144 = t143 + w_platform_y * t135;
    let t145 = w_platform_z * t128;
    let t146 = t145 + w_platform_x * t135;
    let t147 = 1.7320508075688772_f64 * (2.0_f64 * (t128 * u_sB) - sB * t144) + (sB * t146 + 2.0_f64 * (t130 * u_sB));
    let t148 = w_platform_y * t139 + t143;
    let t149 = w_platform_x * t139 - t145;
    let t150 = 1.7320508075688772_f64 * (t8 * t148 - 2.0_f64 * (t128 * u_sC)) + (t8 * t149 - 2.0_f64 * (t130 * u_sC));
    let t151 = t62 * (2.0_f64 * t142 - (t147 - t150));
    let v_G_x_dot_bias = 0.5773502691896257_f64 * t147;
    let g = p.g;
    let t152 = M * (v_G_x_dot_bias - g * t25);
    let t153 = 0.5773502691896257_f64 * t152 - M * (g * v_G_y_per_u_hA) - t89 * t142;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t54 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let u_psiC = t28 * w_platform_x - t56 * w_platform_y - t80 * w_platform_z;
    let t154 = 2.0_f64 * (u_thC * u_psiC);
    let t155 = t19 * t154;
    let u_psiC_dot_bias = t21 * (t27 * t138 - (t51 * t149 + t42 * t148) - t40 * t155);
    let t156 = t33 * u_psiC_dot_bias + (t19 * (t30 * (t40 * t154)) + t40 * (t31 * t155));
    let t157 = t52 * w_platform_y + t45 * w_platform_x + t66 * w_platform_z;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t49 * w_platform_y + t37 * w_platform_x);
    let t158 = 2.0_f64 * (t157 * u_psiB);
    let t159 = t22 * t158;
    let t160 = t38 * (t35 * (t51 * t146 - t42 * t144 - t36 * t132 + t43 * t159));
    let t161 = t160 + (t22 * (t30 * (t43 * t158)) + t43 * (t31 * t159));
    let u_thA = u_thA_per_w_platform_y * w_platform_y - t72 * w_platform_z;
    let t162 = t76 * w_platform_z + t78 * w_platform_y;
    let t163 = u_thA * t162;
    let t164 = t137 * t163;
    let t165 = t74 * (t75 * (v_G_z_per_u_hA * t141 - v_G_y_per_u_hA * t125 - t70 * t164)) + (t25 * (t30 * (t70 * (2.0_f64 * t163))) + t70 * (t31 * t164));
    let t166 = t40 * u_psiC;
    let t167 = t19 * u_psiC * t166;
    let t168 = v_G_y_per_u_hA * t149 + t25 * t148 + v_G_z_per_u_hA * t138 + (t19 * (t166 * t166 + u_thC * u_thC) - t40 * t167);
    let t169 = Ic2 * (t41 * t168) - t32 * t167;
    let t170 = t70 * t162;
    let t171 = t25 * t162 * t170;
    let t172 = v_G_y_per_u_hA * t141 + t25 * (w_platform_z * w_platform_z + w_platform_y * w_platform_y) + v_G_z_per_u_hA * t125 + (t70 * t171 - t25 * (t170 * t170 + u_thA * u_thA));
    let t173 = Ic2 * (t71 * t172) + t32 * t171;
    let t174 = t43 * u_psiB;
    let t175 = t22 * u_psiB * t174;
    let t176 = v_G_y_per_u_hA * t146 + t25 * t144 - v_G_z_per_u_hA * t132 + (t43 * t175 - t22 * (t174 * t174 + t157 * t157));
    let t177 = Ic2 * (t44 * t176) + t32 * t175;
    let t178 = t76 * t165 + (u_thC_per_w_platform_z * t169 + (t72 * t173 + (Iy - Ix) * t141 - t66 * t177));
    let t179 = sA * t153 - (t92 * t142 - (v_G_x_per_w_platform_z * t152 - (t80 * t156 - (u_psiB_per_w_platform_z * t161 + t178))));
    let t180 = t96 * t151 - t179;
    let FB = inputs[1];
    let c = p.c;
    let t181 = g * t97;
    let t182 = t110 * t151 - (v_G_x_per_u_hB * t152 - (FB - u_hB * c - t181) - t109 * t142);
    let t183 = u_thC_per_w_platform_x * t169 - (t45 * t177 + w_platform_z * w_platform_y * (Iy - Iz)) - t37 * t161;
    let t184 = t47 * t140 + (t83 * t151 + (t28 * t156 + t183));
    let t185 = M * (g * v_G_z_per_u_hA - t127);
    let t186 = t78 * t165 - (t54 * t169 + (t52 * t177 + (u_thA_per_w_platform_y * t173 - (Ix - Iz) * t125)));
    let t187 = t58 * t140 + (sA * t185 + (t82 * t151 - (t56 * t156 + (t49 * t161 - t186))));
    let t188 = t87 * w_platform_y_dot_bias + (w_platform_x_per_w_platform_y * t184 + t187);
    let forcing_u_hB = t107 * w_platform_y_dot_bias + (t106 * t140 + (t105 * t180 + t182)) - w_platform_y_per_u_hB * t188;
    let FA = inputs[0];
    let t189 = t63 * t180 + (t93 * t151 + (t181 + (u_hA * c - FA) - v_G_y_per_u_hA * t153));
    let t190 = t14 * t184;
    let t191 = t16 * t188 + (t84 * t140 + (v_G_z_per_u_hA * t185 + t189) - t190 - t85 * w_platform_y_dot_bias);
    let t192 = forcing_u_hB - t113 * t191;
    let FC = inputs[2];
    let t193 = t119 * w_platform_y_dot_bias - (t118 * t140 + (t117 * t180 - (t181 + (u_hC * c - FC))) - t190);
    let forcing_u_hC = t115 * t188 - t193;
    let t194 = t101 * mass_u_hA_u_hC;
    let mass_u_hC_u_hC = t98 + t117 * t121 - t14 * (2.0_f64 * t118 - t88) - t115 * (2.0_f64 * t119 - t116);
    let pivot_2 = mass_u_hA_u_hC * t194 + mass_u_hC_u_hC - t123 * t124;
    let t195 = (t124 * t192 - (forcing_u_hC - t194 * t191)) / pivot_2;
    let t196 = t124 * t195 + t114 * t192;
    let t197 = t113 * t196 + t101 * t191 - t194 * t195;
    let t198 = Real::min(Real::min(Real::min(Real::min(Real::abs(t70), Real::abs(t43)), Real::abs(t40)), Real::abs(t69)), Real::abs(t34));
    let t199 = Real::min(Real::min(Real::min(Real::min(t198, Real::abs(t39)), 0.8333333333333333_f64 * Real::abs(t61)), 5.773502691896257_f64 * Real::abs(t9)), 1.6666666666666665_f64 * Real::abs(t12));
    let t200 = Real::min(Real::min(Real::min(t199, 0.2165283291230603_f64 * Real::abs(t100)), 0.216807871823593_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t197, t196, -t195], t200)
}
///Kinetic and potential energy (J).
///
///256 operations.
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
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t1 = ms + mc;
    let t2 = mr + t1;
    let u_hC = u[2];
    let u_hB = u[1];
    let u_hA = u[0];
    let Ic1 = p.Ic1;
    let Ic3 = p.Ic3;
    let Ic2 = p.Ic2;
    let t3 = 0.5_f64 * (Ic1 + Ic3 - Ic2);
    let R = p.R;
    let t4 = 1.0_f64 / (3.0_f64 * R);
    let hC = q[2];
    let hA = q[0];
    let hB = q[1];
    let t5 = t4 * (2.0_f64 * (0.5_f64 * hC - (hA - 0.5_f64 * hB)));
    let t6 = t4 * (1.7320508075688772_f64 * (hB - hC));
    let t7 = t6 * t6;
    let t8 = t5 * t5;
    let root = Real::sqrt(t7 + (1.0_f64 + t8));
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t9 = t5 * v_G_z_per_u_hA;
    let t10 = 0.5_f64 * (Ic1 - (Ic2 + Ic3));
    let t11 = 0.5_f64 * (Ic1 + Ic2 - Ic3) + t10;
    let t12 = t9 * t9;
    let t13 = 1.0_f64 / (t12 - 1.0_f64);
    let t14 = 0.8660254037844386_f64 * (t6 * (2.0_f64 * t5));
    let t15 = 1.0_f64 / (1.0_f64 + root);
    let t16 = R * ((t14 - t7) * t15 - 1.0_f64);
    let sB = R * (1.0_f64 + t15 * (t7 + t14));
    let cos2 = t8 - t7;
    let sA = R * (1.0_f64 + t15 * (0.5_f64 * (t7 + t8) + cos2));
    let t17 = 1.0_f64 / (2.0_f64 * (t16 - sB - sA));
    let t18 = 0.8660254037844386_f64 * t6;
    let t19 = 0.5_f64 * t5;
    let alongC = t18 - t19;
    let t20 = alongC * v_G_z_per_u_hA;
    let t21 = v_G_z_per_u_hA * (t18 + t19);
    let t22 = t20 + t21;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t22;
    let t23 = 1.7320508075688772_f64 * t9;
    let t24 = v_G_y_per_u_hA - t23;
    let w_platform_z = u_hC * (t17 * (v_G_y_per_u_hA + t23)) - (u_hA * (t17 * (1.1547005383792515_f64 * t22)) - u_hB * (t17 * t24));
    let t25 = 1.0_f64 / (0.8660254037844386_f64 * t16);
    let w_platform_x_per_w_platform_y = t25 * (0.5_f64 * t16 - sA);
    let t26 = 0.8660254037844386_f64 * sB;
    let t27 = 1.0_f64 / (w_platform_x_per_w_platform_y * t26 + (sA + 0.5_f64 * sB));
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t27;
    let t28 = v_G_z_per_u_hA * t25;
    let t29 = t28 * t26;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * (t27 * (t29 - v_G_z_per_u_hA)) - u_hC * (t27 * t29);
    let t30 = v_G_z_per_u_hA * t13 * w_platform_z + v_G_y_per_u_hA * t13 * w_platform_y;
    let t31 = t2 * (u_hA * u_hA) + (t3 + (t9 * (t11 * t9) - t10)) * (t30 * t30);
    let t32 = 1.0_f64 / Real::sqrt(1.0_f64 - t12);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t32;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t32 * w_platform_z;
    let t33 = 1.0_f64 - t21 * t21;
    let t34 = 1.0_f64 / t33;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t34;
    let t35 = 0.8660254037844386_f64 * t9;
    let t36 = 0.28867513459481287_f64 * t22;
    let t37 = t35 - t36;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t28 * (u_hA - u_hC);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t34 * (0.5_f64 * t37) * w_platform_y + t34 * (0.8660254037844386_f64 * t37) * w_platform_x);
    let t38 = t2 * (u_hB * u_hB) + (t31 + Ic2 * (u_thA * u_thA)) + (t3 + (t21 * (t11 * t21) - t10)) * (u_psiB * u_psiB);
    let t39 = 1.0_f64 / Real::sqrt(t33);
    let t40 = 0.5_f64 * v_G_z_per_u_hA;
    let t41 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t42 = t39 * t40 * w_platform_y + t41 * t39 * w_platform_x + t37 * t39 * w_platform_z;
    let t43 = t20 * t20;
    let t44 = 1.0_f64 / (t43 - 1.0_f64);
    let t45 = t36 + t35;
    let u_psiC = t44 * (0.8660254037844386_f64 * t45) * w_platform_x - t44 * (0.5_f64 * t45) * w_platform_y - v_G_z_per_u_hA * t44 * w_platform_z;
    let t46 = t2 * (u_hC * u_hC) + (t38 + Ic2 * (t42 * t42)) + (t3 + (t20 * (t20 * t11) - t10)) * (u_psiC * u_psiC);
    let t47 = 1.0_f64 / Real::sqrt(1.0_f64 - t43);
    let u_thC_per_w_platform_x = t47 * t41;
    let u_thC_per_w_platform_z = t45 * t47;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t47 * t40 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t48 = t46 + Ic2 * (u_thC * u_thC) + Ix * (w_platform_x * w_platform_x) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * t24;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.5773502691896257_f64 * v_G_y;
    let t49 = t48 + Iz * (w_platform_z * w_platform_z) + M * (v_G_x * v_G_x) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t50 = 0.5_f64 * (t49 + M * (v_G_z * v_G_z));
    let g = p.g;
    let t51 = hA * g;
    let t52 = hC * g;
    let t53 = hB * g;
    let t54 = mc * t52 + (ms * t52 + (mc * t53 + (ms * t53 + t1 * t51)));
    let t55 = M * (t51 + sA * (g * t9)) + t54;
    (t50, t55)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///181 operations.
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
    let R = p.R;
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let t2 = t1 * (1.7320508075688772_f64 * (hB - hC));
    let t3 = t2 * t2;
    let hA = q[0];
    let t4 = t1 * (2.0_f64 * (0.5_f64 * hC - (hA - 0.5_f64 * hB)));
    let t5 = t4 * t4;
    let root = Real::sqrt(t3 + (1.0_f64 + t5));
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t6 = t4 * v_G_z_per_u_hA;
    let t7 = t6 * t6;
    let t8 = 1.0_f64 / (t7 - 1.0_f64);
    let u_hC = u[2];
    let t9 = 0.8660254037844386_f64 * (t2 * (2.0_f64 * t4));
    let t10 = 1.0_f64 / (1.0_f64 + root);
    let t11 = R * ((t9 - t3) * t10 - 1.0_f64);
    let sB = R * (1.0_f64 + t10 * (t3 + t9));
    let cos2 = t5 - t3;
    let sA = R * (1.0_f64 + t10 * (0.5_f64 * (t3 + t5) + cos2));
    let t12 = 1.0_f64 / (2.0_f64 * (t11 - sB - sA));
    let t13 = 0.8660254037844386_f64 * t2;
    let t14 = 0.5_f64 * t4;
    let alongC = t13 - t14;
    let t15 = alongC * v_G_z_per_u_hA;
    let t16 = v_G_z_per_u_hA * (t13 + t14);
    let t17 = t15 + t16;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t17;
    let t18 = 1.7320508075688772_f64 * t6;
    let u_hB = u[1];
    let t19 = v_G_y_per_u_hA - t18;
    let w_platform_z = u_hC * (t12 * (v_G_y_per_u_hA + t18)) - (u_hA * (t12 * (1.1547005383792515_f64 * t17)) - u_hB * (t12 * t19));
    let t20 = 1.0_f64 / (0.8660254037844386_f64 * t11);
    let w_platform_x_per_w_platform_y = t20 * (0.5_f64 * t11 - sA);
    let t21 = 0.8660254037844386_f64 * sB;
    let t22 = 1.0_f64 / (w_platform_x_per_w_platform_y * t21 + (sA + 0.5_f64 * sB));
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t22;
    let t23 = v_G_z_per_u_hA * t20;
    let t24 = t23 * t21;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * (t22 * (t24 - v_G_z_per_u_hA)) - u_hC * (t22 * t24);
    let t25 = 1.0_f64 / Real::sqrt(1.0_f64 - t7);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t25;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t25 * w_platform_z;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * t19;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.5773502691896257_f64 * v_G_y;
    let t26 = 1.0_f64 - t16 * t16;
    let t27 = 1.0_f64 / t26;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t27;
    let t28 = 0.8660254037844386_f64 * t6;
    let t29 = 0.28867513459481287_f64 * t17;
    let t30 = t28 - t29;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t23 * (u_hA - u_hC);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t27 * (0.5_f64 * t30) * w_platform_y + t27 * (0.8660254037844386_f64 * t30) * w_platform_x);
    let t31 = 1.0_f64 / Real::sqrt(t26);
    let t32 = 0.5_f64 * v_G_z_per_u_hA;
    let t33 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t34 = 2.0_f64 * v_G_x;
    let t35 = 2.0_f64 * t6;
    let u_sB = t34 + (u_hB * t35 - w_platform_z * (1.7320508075688772_f64 * sB));
    let t36 = t15 * t15;
    let t37 = 1.0_f64 / (t36 - 1.0_f64);
    let t38 = t29 + t28;
    let u_psiC = t37 * (0.8660254037844386_f64 * t38) * w_platform_x - t37 * (0.5_f64 * t38) * w_platform_y - v_G_z_per_u_hA * t37 * w_platform_z;
    let t39 = 1.0_f64 / Real::sqrt(1.0_f64 - t36);
    let u_thC_per_w_platform_x = t39 * t33;
    let u_thC_per_w_platform_z = t38 * t39;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t39 * t32 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let u_sC = t34 - (w_platform_z * (1.7320508075688772_f64 * t11) - u_hC * t35);
    [u_hA, -(v_G_z_per_u_hA * t8 * w_platform_z + v_G_y_per_u_hA * t8 * w_platform_y), u_thA, -(u_hA * t6 + v_G_x), u_hB, u_psiB, -(t31 * t32 * w_platform_y + t33 * t31 * w_platform_x + t30 * t31 * w_platform_z), u_sB, u_hC, u_psiC, u_thC, u_sC]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///81 operations.
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
    let t1 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let t2 = t1 * (1.7320508075688772_f64 * (hB - hC));
    let t3 = t2 * t2;
    let hA = q[0];
    let t4 = t1 * (2.0_f64 * (0.5_f64 * hC - (hA - 0.5_f64 * hB)));
    let t5 = t4 * t4;
    let root = Real::sqrt(t3 + (1.0_f64 + t5));
    let t6 = 1.0_f64 + root;
    let t7 = 1.0_f64 / t6;
    let cos2 = t5 - t3;
    let sA = R * (1.0_f64 + t7 * (0.5_f64 * (t3 + t5) + cos2));
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t8 = t4 * v_G_z_per_u_hA;
    let t9 = sA * Real::sqrt(1.0_f64 - t8 * t8);
    let k = 1.0_f64 / (root * t6);
    let psiA = Real::atan2(t2 * (t4 * k), 1.0_f64 - t5 * k);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let t10 = t9 * sin_psiA;
    let t11 = R - t9 * cos_psiA;
    let t12 = hA + t8 * sA;
    let thA = Real::asin(t8);
    let t13 = 0.8660254037844386_f64 * t2;
    let t14 = 0.5_f64 * t4;
    let t15 = t13 + t14;
    let t16 = 0.5_f64 * t2;
    let t17 = 0.8660254037844386_f64 * t4;
    let acrossB = t16 - t17;
    let psiB = Real::atan2(t15 * k * acrossB, 1.0_f64 - k * (t15 * t15));
    let t18 = 0.8660254037844386_f64 * (t2 * (2.0_f64 * t4));
    let sB = R * (1.0_f64 + t7 * (t3 + t18));
    let alongC = t13 - t14;
    let acrossC = t17 + t16;
    let psiC = Real::atan2(-alongC * k * acrossC, 1.0_f64 - k * (alongC * alongC));
    let thC = Real::asin(alongC * v_G_z_per_u_hA);
    [t10, t11, t12, psiA, thA, sA, psiB, -Real::asin(v_G_z_per_u_hA * t15), sB, psiC, thC, -R * ((t18 - t3) * t7 - 1.0_f64)]
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
