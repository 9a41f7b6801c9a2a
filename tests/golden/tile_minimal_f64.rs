// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 754 operations (12 abs, 145 add, 15 div, 11 min, 442 mul, 4 sqrt, 125 sub).
// Cost of energy: 247 operations (50 add, 12 div, 150 mul, 4 sqrt, 31 sub).
// Cost of speeds: 180 operations (24 add, 12 div, 108 mul, 4 sqrt, 32 sub).
// Cost of outputs: 80 operations (12 add, 3 asin, 3 atan2, 1 cos, 4 div, 42 mul, 1 sin, 2 sqrt, 12 sub).
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
///754 operations.
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
    let t3 = t1 * (2.0_f64 * (0.5_f64 * (hB + hC) - hA));
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
    let Ic3 = p.Ic3;
    let Ic1 = p.Ic1;
    let Ic2 = p.Ic2;
    let t29 = 0.5_f64 * (Ic1 + Ic2 - Ic3);
    let t30 = 0.5_f64 * (Ic1 - (Ic2 + Ic3));
    let t31 = t29 + t30;
    let t32 = Ic3 + t19 * (t19 * t31);
    let t33 = 1.0_f64 - t22 * t22;
    let t34 = 1.0_f64 / t33;
    let t35 = t26 - t24;
    let t36 = t34 * (0.8660254037844386_f64 * t35);
    let t37 = Ic3 + t22 * (t31 * t22);
    let t38 = 1.0_f64 - t20;
    let t39 = Real::sqrt(t38);
    let t40 = 1.0_f64 / t39;
    let t41 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let u_thC_per_w_platform_x = t40 * t41;
    let Ix = p.Ix;
    let t42 = Real::sqrt(t33);
    let t43 = 1.0_f64 / t42;
    let t44 = t41 * t43;
    let t45 = t36 * (t37 * t36) + (u_thC_per_w_platform_x * (Ic2 * u_thC_per_w_platform_x) + (Ix + t44 * (Ic2 * t44)));
    let t46 = t28 * (t32 * t28) + t45;
    let t47 = w_platform_x_per_w_platform_y * t46;
    let t48 = t34 * (0.5_f64 * t35);
    let t49 = t37 * t48;
    let t50 = 0.5_f64 * v_G_z_per_u_hA;
    let t51 = t43 * t50;
    let t52 = Ic2 * t51;
    let t53 = t40 * t50;
    let t54 = Ic2 * t53;
    let t55 = t21 * (0.5_f64 * t27);
    let t56 = t32 * t55;
    let t57 = t36 * t49 + (t44 * t52 - u_thC_per_w_platform_x * t54) - t28 * t56;
    let t58 = (t47 + t57) * t14;
    let M = p.M;
    let t59 = M * sA;
    let t60 = 2.0_f64 * (t8 - sB - sA);
    let t61 = 1.0_f64 / t60;
    let t62 = t61 * (1.1547005383792515_f64 * t23);
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t34;
    let t63 = t37 * u_psiB_per_w_platform_z;
    let u_thC_per_w_platform_z = t27 * t40;
    let t64 = Ic2 * u_thC_per_w_platform_z;
    let t65 = t35 * t43;
    let t66 = Ic2 * t65;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t23;
    let t67 = t25 * t25;
    let t68 = 1.0_f64 - t67;
    let t69 = Real::sqrt(t68);
    let t70 = 1.0_f64 / t69;
    let t71 = v_G_y_per_u_hA * t70;
    let t72 = Ic2 * t71;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t70;
    let t73 = Ic3 + t25 * (t31 * t25);
    let t74 = 1.0_f64 / (t67 - 1.0_f64);
    let t75 = v_G_z_per_u_hA * t74;
    let t76 = t73 * t75;
    let t77 = v_G_y_per_u_hA * t74;
    let t78 = t63 * t48 + (t64 * t53 - (t66 * t51 - t72 * u_thA_per_w_platform_y) - t76 * t77);
    let t79 = v_G_z_per_u_hA * t21;
    let t80 = t32 * t79;
    let t81 = t78 - t80 * t55;
    let t82 = t80 * t28 + (t63 * t36 - (t64 * u_thC_per_w_platform_x + t66 * t44));
    let t83 = t82 * t62;
    let t84 = t58 - (v_G_z_per_u_hA * t59 + t62 * t81) - t83 * w_platform_x_per_w_platform_y;
    let Iy = p.Iy;
    let t85 = t77 * (t73 * t77) + (t53 * t54 + (t51 * t52 + (Iy + u_thA_per_w_platform_y * (Ic2 * u_thA_per_w_platform_y))));
    let t86 = w_platform_x_per_w_platform_y * (t47 + 2.0_f64 * t57) + (sA * t59 + (t55 * t56 + (t48 * t49 + t85)));
    let t87 = t46 * t14;
    let t88 = 1.3333333333333333_f64 * M;
    let t89 = t88 * sA;
    let t90 = 0.5773502691896257_f64 * M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let t91 = t90 * v_G_x_per_w_platform_z;
    let t92 = v_G_y_per_u_hA * (t89 + t91);
    let t93 = M * v_G_x_per_w_platform_z;
    let Iz = p.Iz;
    let t94 = u_psiB_per_w_platform_z * t63 + (t75 * t76 + (u_thC_per_w_platform_z * t64 + (t65 * t66 + (Iz + t71 * t72))));
    let t95 = sA * (t89 + 2.0_f64 * t91) + (v_G_x_per_w_platform_z * t93 + (t79 * t80 + t94));
    let mr = p.mr;
    let ms = p.ms;
    let mc = p.mc;
    let t96 = ms + mc;
    let t97 = mr + t96;
    let t98 = t62 * (2.0_f64 * t92 + t62 * t95) + (t97 + v_G_y_per_u_hA * (t88 * v_G_y_per_u_hA)) + v_G_z_per_u_hA * (M * v_G_z_per_u_hA);
    let t99 = t16 * (2.0_f64 * t84 - t86 * t16) + (t14 * (2.0_f64 * t83 - t87) - t98);
    let t100 = 1.0_f64 / t99;
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t13;
    let t101 = t86 * w_platform_y_per_u_hB;
    let t102 = 1.7320508075688772_f64 * t25;
    let t103 = v_G_y_per_u_hA - t102;
    let t104 = t61 * t103;
    let t105 = t82 * t104;
    let t106 = w_platform_x_per_w_platform_y * t105 + t81 * t104;
    let t107 = t95 * t104;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * t103;
    let t108 = t90 * v_G_x_per_u_hB;
    let t109 = sA * t108 + t93 * v_G_x_per_u_hB;
    let t110 = t14 * t105;
    let t111 = t16 * (t101 - t106) - (t92 * t104 + (t62 * (t107 + t109) + v_G_y_per_u_hA * t108) - t110);
    let mass_u_hA_u_hB = t111 - t84 * w_platform_y_per_u_hB;
    let t112 = t100 * mass_u_hA_u_hB;
    let mass_u_hB_u_hB = w_platform_y_per_u_hB * (t101 - 2.0_f64 * t106) + (t104 * (t107 + 2.0_f64 * t109) + (t97 + v_G_x_per_u_hB * (M * v_G_x_per_u_hB)));
    let pivot_1 = mass_u_hA_u_hB * t112 + mass_u_hB_u_hB;
    let t113 = 1.0_f64 / pivot_1;
    let t114 = t13 * t15;
    let t115 = t86 * t114;
    let t116 = t61 * (v_G_y_per_u_hA + t102);
    let t117 = t82 * t116;
    let t118 = t58 - t81 * t116 - w_platform_x_per_w_platform_y * t117;
    let t119 = t115 - t118;
    let t120 = t95 * t116;
    let mass_u_hA_u_hC = t84 * t114 - (t16 * t119 + (t92 * t116 + t62 * t120)) - t14 * (t87 - t117 - t83);
    let mass_u_hB_u_hC = t106 * t114 - (w_platform_y_per_u_hB * t119 + (t110 - (t109 * t116 + t104 * t120)));
    let t121 = t112 * mass_u_hA_u_hC + mass_u_hB_u_hC;
    let t122 = t113 * t121;
    let w_platform_z = u_hC * t116 - (u_hA * t62 - u_hB * t104);
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * t16 - u_hC * t114;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t14 * (u_hA - u_hC);
    let t123 = w_platform_z * w_platform_x;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.5773502691896257_f64 * v_G_y;
    let t124 = u_hA * t25 + v_G_x;
    let t125 = sA * t123 + 2.0_f64 * (w_platform_y * t124);
    let t126 = 0.8660254037844386_f64 * w_platform_z;
    let t127 = w_platform_y * t126;
    let t128 = 0.5_f64 * w_platform_z;
    let t129 = w_platform_x * t128;
    let t130 = t127 - t129;
    let t131 = 0.5_f64 * w_platform_y;
    let t132 = 0.8660254037844386_f64 * w_platform_x;
    let t133 = t131 + t132;
    let t134 = 2.0_f64 * v_G_x;
    let t135 = 2.0_f64 * t25;
    let u_sB = t134 + (u_hB * t135 - w_platform_z * (1.7320508075688772_f64 * sB));
    let t136 = t127 + t129;
    let t137 = t131 - t132;
    let u_sC = t134 - (w_platform_z * (1.7320508075688772_f64 * t8) - u_hC * t135);
    let t138 = t10 * (t125 - (t8 * t136 + 2.0_f64 * (t137 * u_sC)));
    let w_platform_y_dot_bias = t13 * (t125 - (sB * t130 + 2.0_f64 * (t133 * u_sB)) - t11 * t138);
    let t139 = w_platform_z * t126;
    let t140 = w_platform_x * t137 - t139;
    let t141 = w_platform_z * t128;
    let t142 = t141 + w_platform_y * t133;
    let t143 = w_platform_x * t133 + t139;
    let t144 = 1.7320508075688772_f64 * (2.0_f64 * (t126 * u_sB) - sB * t142) + (sB * t143 + 2.0_f64 * (t128 * u_sB));
    let t145 = t141 + w_platform_y * t137;
    let t146 = w_platform_y * w_platform_x;
    let t147 = 2.0_f64 * (w_platform_z * t124) - sA * t146;
    let t148 = t8 * t140 - t144 + 1.7320508075688772_f64 * (t8 * t145 - 2.0_f64 * (t126 * u_sC)) + 2.0_f64 * (t147 - t128 * u_sC);
    let t149 = t61 * t148;
    let v_G_x_dot_bias = 0.5773502691896257_f64 * t144;
    let g = p.g;
    let t150 = M * (v_G_x_dot_bias - g * t25);
    let t151 = 0.5773502691896257_f64 * t150 - M * (g * v_G_y_per_u_hA) - t88 * t147;
    let u_psiC = t28 * w_platform_x - t55 * w_platform_y - t79 * w_platform_z;
    let t152 = t19 * u_psiC;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t53 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let t153 = 2.0_f64 * (t152 * u_thC);
    let u_psiC_dot_bias = t21 * (t27 * t136 - (t50 * t140 + t41 * t145) - t39 * t153);
    let t154 = t39 * u_psiC;
    let t155 = t32 * u_psiC_dot_bias + (t19 * (t29 * (2.0_f64 * (u_thC * t154))) + t39 * (t30 * t153));
    let t156 = t51 * w_platform_y + t44 * w_platform_x + t65 * w_platform_z;
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t48 * w_platform_y + t36 * w_platform_x);
    let t157 = 2.0_f64 * (t156 * u_psiB);
    let t158 = t22 * t157;
    let t159 = t37 * (t34 * (t50 * t143 - t41 * t142 - t35 * t130 + t42 * t158));
    let t160 = t159 + (t22 * (t29 * (t42 * t157)) + t42 * (t30 * t158));
    let u_thA = u_thA_per_w_platform_y * w_platform_y - t71 * w_platform_z;
    let t161 = t75 * w_platform_z + t77 * w_platform_y;
    let t162 = t135 * (u_thA * t161);
    let t163 = t69 * t161;
    let t164 = t73 * (t74 * (v_G_z_per_u_hA * t146 - v_G_y_per_u_hA * t123 - t69 * t162)) + (t25 * (t29 * (2.0_f64 * (u_thA * t163))) + t69 * (t30 * t162));
    let t165 = t152 * t154;
    let t166 = v_G_y_per_u_hA * t140 + t25 * t145 + v_G_z_per_u_hA * t136 + (t19 * (t154 * t154 + u_thC * u_thC) - t39 * t165);
    let t167 = Ic2 * (t40 * t166) - t31 * t165;
    let t168 = t163 * (t25 * t161);
    let t169 = v_G_z_per_u_hA * t123 + t69 * t168 + v_G_y_per_u_hA * t146 + t25 * (w_platform_z * w_platform_z + w_platform_y * w_platform_y - (t163 * t163 + u_thA * u_thA));
    let t170 = Ic2 * (t70 * t169) + t31 * t168;
    let t171 = t42 * u_psiB;
    let t172 = t22 * u_psiB * t171;
    let t173 = v_G_y_per_u_hA * t143 + t25 * t142 - v_G_z_per_u_hA * t130 + (t42 * t172 - t22 * (t171 * t171 + t156 * t156));
    let t174 = Ic2 * (t43 * t173) + t31 * t172;
    let t175 = t75 * t164 + (u_thC_per_w_platform_z * t167 + (t71 * t170 + (Iy - Ix) * t146 - t65 * t174));
    let t176 = sA * t151 - (t91 * t147 - (v_G_x_per_w_platform_z * t150 - (t79 * t155 - (u_psiB_per_w_platform_z * t160 + t175))));
    let t177 = t95 * t149 - t176;
    let FB = inputs[1];
    let c = p.c;
    let t178 = g * t96;
    let t179 = t109 * t149 - (v_G_x_per_u_hB * t150 - (FB - u_hB * c - t178) - t108 * t147);
    let t180 = u_thC_per_w_platform_x * t167 - (t44 * t174 + w_platform_z * w_platform_y * (Iy - Iz)) - t36 * t160;
    let t181 = t46 * t138 + (t82 * t149 + (t28 * t155 + t180));
    let t182 = M * (g * v_G_z_per_u_hA - t125);
    let t183 = t77 * t164 - (t53 * t167 + (t51 * t174 + (u_thA_per_w_platform_y * t170 - (Ix - Iz) * t123)));
    let t184 = t57 * t138 + (sA * t182 + (t81 * t149 - (t55 * t155 + (t48 * t160 - t183))));
    let t185 = t86 * w_platform_y_dot_bias + (w_platform_x_per_w_platform_y * t181 + t184);
    let forcing_u_hB = t106 * w_platform_y_dot_bias + (t105 * t138 + (t104 * t177 + t179)) - w_platform_y_per_u_hB * t185;
    let FA = inputs[0];
    let t186 = t62 * t177 + (t92 * t149 + (t178 + (u_hA * c - FA) - v_G_y_per_u_hA * t151));
    let t187 = t14 * t181;
    let t188 = t16 * t185 + (t83 * t138 + (v_G_z_per_u_hA * t182 + t186) - t187 - t84 * w_platform_y_dot_bias);
    let t189 = forcing_u_hB - t112 * t188;
    let FC = inputs[2];
    let t190 = t118 * w_platform_y_dot_bias - (t117 * t138 + (t116 * t177 - (t178 + (u_hC * c - FC))) - t187);
    let forcing_u_hC = t114 * t185 - t190;
    let t191 = t100 * mass_u_hA_u_hC;
    let mass_u_hC_u_hC = t97 + t116 * t120 - t14 * (2.0_f64 * t117 - t87) - t114 * (2.0_f64 * t118 - t115);
    let pivot_2 = mass_u_hA_u_hC * t191 + mass_u_hC_u_hC - t121 * t122;
    let t192 = (t122 * t189 - (forcing_u_hC - t191 * t188)) / pivot_2;
    let t193 = t122 * t192 + t113 * t189;
    let t194 = t112 * t193 + t100 * t188 - t191 * t192;
    let t195 = Real::min(Real::min(Real::min(Real::min(Real::abs(t69), Real::abs(t42)), Real::abs(t39)), Real::abs(t68)), Real::abs(t33));
    let t196 = Real::min(Real::min(Real::min(Real::min(t195, Real::abs(t38)), 0.8333333333333333_f64 * Real::abs(t60)), 5.773502691896257_f64 * Real::abs(t9)), 1.6666666666666665_f64 * Real::abs(t12));
    let t197 = Real::min(Real::min(Real::min(t196, 0.2165283291230603_f64 * Real::abs(t99)), 0.216807871823593_f64 * Real::abs(pivot_1)), 0.21706868422196893_f64 * Real::abs(pivot_2));
    ([u_hA, u_hB, u_hC], [t194, t193, -t192], t197)
}
///Kinetic and potential energy (J).
///
///247 operations.
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
    let u_hA = u[0];
    let u_hB = u[1];
    let u_hC = u[2];
    let Ic3 = p.Ic3;
    let R = p.R;
    let t3 = 1.0_f64 / (3.0_f64 * R);
    let hB = q[1];
    let hC = q[2];
    let hA = q[0];
    let t4 = t3 * (2.0_f64 * (0.5_f64 * (hB + hC) - hA));
    let t5 = t3 * (1.7320508075688772_f64 * (hB - hC));
    let t6 = t5 * t5;
    let t7 = t4 * t4;
    let root = Real::sqrt(t6 + (1.0_f64 + t7));
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t8 = t4 * v_G_z_per_u_hA;
    let Ic1 = p.Ic1;
    let Ic2 = p.Ic2;
    let t9 = 0.5_f64 * (Ic1 + Ic2 - Ic3) + 0.5_f64 * (Ic1 - (Ic2 + Ic3));
    let t10 = t8 * t8;
    let t11 = 1.0_f64 / (t10 - 1.0_f64);
    let t12 = 0.8660254037844386_f64 * (t5 * (2.0_f64 * t4));
    let t13 = 1.0_f64 / (1.0_f64 + root);
    let t14 = R * ((t12 - t6) * t13 - 1.0_f64);
    let sB = R * (1.0_f64 + t13 * (t6 + t12));
    let cos2 = t7 - t6;
    let sA = R * (1.0_f64 + t13 * (0.5_f64 * (t6 + t7) + cos2));
    let t15 = 1.0_f64 / (2.0_f64 * (t14 - sB - sA));
    let t16 = 0.8660254037844386_f64 * t5;
    let t17 = 0.5_f64 * t4;
    let alongC = t16 - t17;
    let t18 = alongC * v_G_z_per_u_hA;
    let t19 = v_G_z_per_u_hA * (t16 + t17);
    let t20 = t18 + t19;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t20;
    let t21 = 1.7320508075688772_f64 * t8;
    let t22 = v_G_y_per_u_hA - t21;
    let w_platform_z = u_hC * (t15 * (v_G_y_per_u_hA + t21)) - (u_hA * (t15 * (1.1547005383792515_f64 * t20)) - u_hB * (t15 * t22));
    let t23 = 1.0_f64 / (0.8660254037844386_f64 * t14);
    let w_platform_x_per_w_platform_y = t23 * (0.5_f64 * t14 - sA);
    let t24 = 0.8660254037844386_f64 * sB;
    let t25 = 1.0_f64 / (w_platform_x_per_w_platform_y * t24 + (sA + 0.5_f64 * sB));
    let w_platform_y_per_u_hB = v_G_z_per_u_hA * t25;
    let t26 = v_G_z_per_u_hA * t23;
    let t27 = t26 * t24;
    let w_platform_y = u_hB * w_platform_y_per_u_hB + u_hA * (t25 * (t27 - v_G_z_per_u_hA)) - u_hC * (t25 * t27);
    let t28 = v_G_z_per_u_hA * t11 * w_platform_z + v_G_y_per_u_hA * t11 * w_platform_y;
    let t29 = t2 * (u_hA * u_hA) + (t2 * (u_hB * u_hB) + t2 * (u_hC * u_hC)) + (Ic3 + t8 * (t9 * t8)) * (t28 * t28);
    let t30 = 1.0_f64 / Real::sqrt(1.0_f64 - t10);
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t30;
    let u_thA = u_thA_per_w_platform_y * w_platform_y - v_G_y_per_u_hA * t30 * w_platform_z;
    let t31 = 1.0_f64 - t19 * t19;
    let t32 = 1.0_f64 / t31;
    let u_psiB_per_w_platform_z = v_G_z_per_u_hA * t32;
    let t33 = 0.8660254037844386_f64 * t8;
    let t34 = 0.28867513459481287_f64 * t20;
    let t35 = t33 - t34;
    let w_platform_x = w_platform_x_per_w_platform_y * w_platform_y - t26 * (u_hA - u_hC);
    let u_psiB = u_psiB_per_w_platform_z * w_platform_z - (t32 * (0.5_f64 * t35) * w_platform_y + t32 * (0.8660254037844386_f64 * t35) * w_platform_x);
    let t36 = t29 + Ic2 * (u_thA * u_thA) + (Ic3 + t19 * (t9 * t19)) * (u_psiB * u_psiB);
    let t37 = 1.0_f64 / Real::sqrt(t31);
    let t38 = 0.5_f64 * v_G_z_per_u_hA;
    let t39 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t40 = t37 * t38 * w_platform_y + t39 * t37 * w_platform_x + t35 * t37 * w_platform_z;
    let t41 = t18 * t18;
    let t42 = 1.0_f64 / (t41 - 1.0_f64);
    let t43 = t34 + t33;
    let u_psiC = t42 * (0.8660254037844386_f64 * t43) * w_platform_x - t42 * (0.5_f64 * t43) * w_platform_y - v_G_z_per_u_hA * t42 * w_platform_z;
    let t44 = t36 + Ic2 * (t40 * t40) + (Ic3 + t18 * (t18 * t9)) * (u_psiC * u_psiC);
    let t45 = 1.0_f64 / Real::sqrt(1.0_f64 - t41);
    let u_thC_per_w_platform_x = t45 * t39;
    let u_thC_per_w_platform_z = t43 * t45;
    let u_thC = u_thC_per_w_platform_x * w_platform_x - t45 * t38 * w_platform_y + u_thC_per_w_platform_z * w_platform_z;
    let Ix = p.Ix;
    let Iy = p.Iy;
    let t46 = t44 + Ic2 * (u_thC * u_thC) + Ix * (w_platform_x * w_platform_x) + Iy * (w_platform_y * w_platform_y);
    let Iz = p.Iz;
    let M = p.M;
    let v_G_x_per_w_platform_z = 1.1547005383792515_f64 * sB;
    let v_G_x_per_u_hB = 0.5773502691896257_f64 * t22;
    let v_G_y = u_hA * v_G_y_per_u_hA - sA * w_platform_z;
    let v_G_x = v_G_x_per_w_platform_z * w_platform_z + u_hB * v_G_x_per_u_hB - 0.5773502691896257_f64 * v_G_y;
    let t47 = t46 + Iz * (w_platform_z * w_platform_z) + M * (v_G_x * v_G_x) + M * (v_G_y * v_G_y);
    let v_G_z = sA * w_platform_y + u_hA * v_G_z_per_u_hA;
    let t48 = 0.5_f64 * (t47 + M * (v_G_z * v_G_z));
    let g = p.g;
    let t49 = hA * g;
    let t50 = hB * g;
    let t51 = M * (t49 + sA * (g * t8)) + (t1 * (hC * g) + (mc * t50 + (ms * t50 + t1 * t49)));
    (t48, t51)
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
    let t4 = t1 * (2.0_f64 * (0.5_f64 * (hB + hC) - hA));
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
///80 operations.
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
    let t4 = t1 * (2.0_f64 * (0.5_f64 * (hB + hC) - hA));
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
