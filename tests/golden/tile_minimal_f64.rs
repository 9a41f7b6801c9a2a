// Generated from models/tile_minimal.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// tile_minimal: 3 coordinates, 3 independent speeds, 3 inputs, 13 tunable parameters; scalar f64.
// Pivots: 12; the worst over 73 sampled configurations is 0.610 of its nominal size.
// Cost of rates: 550 operations (6 abs, 92 add, 13 div, 8 min, 334 mul, 4 sqrt, 93 sub).
// Cost of energy: 185 operations (40 add, 7 div, 118 mul, 1 sqrt, 19 sub).
// Cost of speeds: 180 operations (31 add, 10 div, 112 mul, 4 sqrt, 23 sub).
// Cost of outputs: 78 operations (12 add, 3 asin, 3 atan2, 1 cos, 3 div, 42 mul, 1 sin, 2 sqrt, 11 sub).
// Cost of projection: 0 operations ().
// Cost of prepare: 282 operations (17 abs, 78 add, 18 div, 9 max, 154 mul, 1 sqrt, 5 sub).

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
pub const NOMINAL: [f64; 3usize] = [0f64, 0f64, 0f64];
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
    let t2 = 1.0_f64 / (3.0_f64 * t1);
    let t3 = Real::max(5.0_f64 * t1, 1e-24_f64);
    let t4 = 3.4641016151377544_f64 * t3;
    let t5 = 4.0_f64 * t3;
    let t6 = t2 * t4;
    let t7 = t2 * t5;
    let t8 = t6 * t6;
    let t9 = t8 + t7 * t7;
    let t10 = Real::sqrt(1.0_f64 + t9);
    let t11 = 1.0_f64 / t10;
    let Ic2 = p.Ic2;
    let t12 = Real::abs(Ic2);
    let Ic3 = p.Ic3;
    let t13 = Real::abs(Ic3);
    let t14 = 0.8660254037844386_f64 * t6;
    let t15 = 0.5_f64 * t7;
    let Ic1 = p.Ic1;
    let t16 = Real::abs(Ic1);
    let t17 = (t14 + t15) * t11;
    let t18 = t7 * t11;
    let t19 = t17 * t17;
    let t20 = 1.0_f64 + t10;
    let t21 = 2.0_f64 * t7;
    let t22 = t18 * t18;
    let t23 = 1.0_f64 + t19;
    let t24 = 1.0_f64 / t20;
    let t25 = t6 * t21;
    let t26 = t12 + t13;
    let t27 = 1.0_f64 + t22;
    let t28 = 1.0_f64 / t23;
    let t29 = 0.8660254037844386_f64 * t25;
    let t30 = t16 + t26;
    let t31 = 1.0_f64 / t27;
    let t32 = t8 + t29;
    let t33 = 1.5_f64 * t9;
    let t34 = t30 * t17;
    let M = p.M;
    let t35 = Real::abs(M);
    let t36 = t32 * t24;
    let t37 = t33 * t24;
    let t38 = t30 * t18;
    let t39 = t17 * t34;
    let Iz = p.Iz;
    let t40 = Real::abs(Iz);
    let t41 = 1.0_f64 + t36;
    let t42 = 1.0_f64 + t37;
    let t43 = t18 * t38;
    let t44 = t26 + t39;
    let t45 = t11 * t28;
    let t46 = t1 * t41;
    let t47 = t1 * t42;
    let t48 = t26 + t43;
    let t49 = t11 * t31;
    let t50 = t44 * t45;
    let t51 = 0.8660254037844386_f64 * t46;
    let t52 = 0.4330127018922193_f64 * t47;
    let t53 = t48 * t49;
    let t54 = t45 * t50;
    let t55 = t52 + t51;
    let t56 = t49 * t53;
    let t57 = 2.0_f64 * t54;
    let t58 = 3.0_f64 * t12;
    let t59 = t1 * t35;
    let t60 = 0.5773502691896257_f64 * t17;
    let t61 = 0.8660254037844386_f64 * t18;
    let t62 = 1.3333333333333333_f64 * t55;
    let t63 = t56 + t57;
    let t64 = t40 + t58;
    let t65 = t59 * t42;
    let t66 = t60 + t61;
    let t67 = t35 * t62;
    let t68 = t64 + t63;
    let t69 = t47 * t65;
    let t70 = 0.8660254037844386_f64 * t66;
    let t71 = t62 * t67;
    let t72 = t69 + t68;
    let t73 = 0.5_f64 * t66;
    let t74 = t28 * t70;
    let Ix = p.Ix;
    let t75 = Real::abs(Ix);
    let t76 = t71 + t72;
    let t77 = t28 * t73;
    let t78 = 1.1547005383792515_f64 * t17;
    let t79 = t7 * t24;
    let t80 = t50 * t74;
    let t81 = 1.0_f64 / t51;
    let t82 = t50 * t77;
    let t83 = t78 * t31;
    let t84 = t79 * t76;
    let t85 = 4.0_f64 * t80;
    let t86 = t44 * t74;
    let t87 = 0.5_f64 * t46;
    let t88 = t6 * t24;
    let t89 = 2.0_f64 * t82;
    let t90 = t53 * t83;
    let t91 = t44 * t77;
    let t92 = t85 + t84;
    let t93 = t74 * t86;
    let Iy = p.Iy;
    let t94 = Real::abs(Iy);
    let t95 = t47 + t87;
    let t96 = t76 * t88;
    let t97 = t90 + t89;
    let t98 = 2.0_f64 * t80;
    let t99 = t74 * t91;
    let t100 = t79 * t92;
    let t101 = 2.0_f64 * t93;
    let t102 = 1.5_f64 * t12;
    let t103 = 0.6666666666666666_f64 * t17;
    let t104 = t81 * t95;
    let t105 = t96 + t97;
    let t106 = t98 * t88;
    let t107 = 2.0_f64 * t99;
    let t108 = t100 + t101;
    let t109 = t75 + t102;
    let t110 = t67 * t103;
    let t111 = t78 * t65;
    let t112 = 2.0_f64 * t97;
    let t113 = t77 * t91;
    let t114 = t48 * t83;
    let ms = p.ms;
    let t115 = Real::abs(ms);
    let mc = p.mc;
    let t116 = Real::abs(mc);
    let t117 = t51 * t104;
    let t118 = t79 * t105;
    let t119 = t106 + t107;
    let t120 = t109 + t108;
    let t121 = t110 + t111;
    let t122 = t96 + t112;
    let t123 = 2.0_f64 * t113;
    let t124 = t83 * t114;
    let mr = p.mr;
    let t125 = Real::abs(mr);
    let t126 = t95 + t117;
    let t127 = t118 + t119;
    let t128 = t104 * t120;
    let t129 = t121 * t79;
    let t130 = t88 * t122;
    let t131 = t124 + t123;
    let t132 = 1.0_f64 / t126;
    let t133 = t128 + t127;
    let t134 = t11 * t81;
    let t135 = t129 * t104;
    let t136 = t121 * t88;
    let t137 = 2.0_f64 * t127;
    let t138 = t130 + t131;
    let t139 = t94 + t102;
    let t140 = 1.1547005383792515_f64 * t66;
    let t141 = t133 * t134;
    let t142 = t135 + t136;
    let t143 = t128 + t137;
    let t144 = t139 + t138;
    let t145 = t51 * t134;
    let t146 = t35 * t103;
    let t147 = t35 * t78;
    let t148 = t67 * t140;
    let t149 = t141 + t142;
    let t150 = t11 * t65;
    let t151 = t104 * t143;
    let t152 = t69 + t144;
    let t153 = t11 + t145;
    let t154 = t120 * t134;
    let t155 = 2.0_f64 * t129;
    let t156 = t103 * t146;
    let t157 = t78 * t147;
    let t158 = t115 + t116;
    let t159 = t79 * t148;
    let t160 = t150 + t149;
    let t161 = t151 + t152;
    let t162 = t132 * t153;
    let t163 = t155 + t154;
    let t164 = t156 + t157;
    let t165 = t125 + t158;
    let t166 = t104 * t159;
    let t167 = t88 * t148;
    let t168 = 2.0_f64 * t160;
    let t169 = t161 * t162;
    let t170 = t134 * t163;
    let t171 = t165 + t164;
    let t172 = t35 * t11;
    let t173 = t132 * t145;
    let t174 = t166 + t167;
    let t175 = t168 + t169;
    let t176 = t170 + t171;
    let t177 = t11 * t172;
    let t178 = t161 * t173;
    let t179 = t141 + t174;
    let t180 = t162 * t175;
    let t181 = t177 + t176;
    let t182 = t178 + t179;
    let t183 = t35 * t140;
    let t184 = t180 + t181;
    let t185 = t162 * t182;
    let t186 = t103 * t183;
    let t187 = t129 + t159;
    let t188 = 2.0_f64 * t159;
    let t189 = 1.0_f64 / t184;
    let t190 = t185 + t186;
    let t191 = t160 * t173;
    let t192 = t154 + t187;
    let t193 = t154 + t188;
    let t194 = t190 + t191;
    let t195 = t134 * t192;
    let t196 = 2.0_f64 * t179;
    let t197 = t134 * t193;
    let t198 = t140 * t183;
    let t199 = t194 + t195;
    let t200 = t178 + t196;
    let t201 = t197 + t198;
    let t202 = t189 * t199;
    let t203 = t173 * t200;
    let t204 = t165 + t201;
    let t205 = t11 * t132;
    let t206 = t199 * t202;
    let t207 = t203 + t204;
    let t208 = t161 * t205;
    let t209 = t206 + t207;
    let t210 = t160 * t205;
    let t211 = t162 * t208;
    let t212 = 1.0_f64 / t209;
    let t213 = t210 + t211;
    let t214 = t179 * t205;
    let t215 = t173 * t208;
    let t216 = t202 * t213;
    let t217 = t216 + (t214 + t215);
    let t218 = t189 * t213;
    let t219 = t205 * t208;
    let t220 = t212 * t217;
    let t221 = t213 * t218;
    let t222 = t165 + t219;
    let t223 = t217 * t220;
    let t224 = t223 + (t221 + t222);
    let t225 = Real::abs(t20);
    let t226 = Real::abs(t51);
    let t227 = Real::abs(t126);
    let t228 = Real::abs(t184);
    let t229 = Real::abs(t209);
    let t230 = Real::abs(t224);
    let t231 = 0.6393146979260594_f64 * t27;
    let t232 = 0.5314842578710645_f64 * t23;
    let t233 = 0.10125880247738014_f64 * t225;
    let t234 = 0.5189254749591666_f64 * t226;
    let t235 = 0.13604355990604278_f64 * t227;
    let t236 = 0.049893587767728925_f64 * t228;
    let t237 = 0.03818977876120638_f64 * t229;
    let t238 = 0.3014110632051291_f64 * t230;
    let t239 = 3.0_f64 * R;
    let t240 = Real::max(t231, 1e-24_f64);
    let t241 = Real::max(t232, 1e-24_f64);
    let t242 = Real::max(t233, 1e-24_f64);
    let t243 = Real::max(t234, 1e-24_f64);
    let t244 = Real::max(t235, 1e-24_f64);
    let t245 = Real::max(t236, 1e-24_f64);
    let t246 = Real::max(t237, 1e-24_f64);
    let t247 = Real::max(t238, 1e-24_f64);
    let t248 = 1.0_f64 / t239;
    let t249 = 1.0_f64 / t240;
    let t250 = 1.0_f64 / t241;
    let t251 = 0.5_f64 / t242;
    let t252 = 5.773502691896257_f64 / t243;
    let t253 = 1.6666666666666665_f64 / t244;
    let t254 = 0.2165283291230603_f64 / t245;
    let t255 = 0.21680787182359307_f64 / t246;
    let t256 = 0.21706868422196887_f64 / t247;
    let t257 = Ic3 - Ic2;
    let t258 = 3.0_f64 * Ic2;
    let t259 = 1.5_f64 * Ic2;
    let t260 = t257 - Ic1;
    let t261 = ms + mc;
    let t262 = Iz + t258;
    let t263 = Ix + t259;
    let t264 = Iy + t259;
    let t265 = 0.5_f64 * t260;
    let g = p.g;
    let t266 = ms * g;
    let t267 = mc * g;
    let t268 = g * t261;
    let t269 = M * g;
    let t270 = mr + t261;
    let t271 = R * g;
    let t272 = R * M;
    let t273 = t263 - t264;
    let t274 = t264 - t262;
    let t275 = t262 - t263;
    let c = p.c;
    Prepared { R, M, c, g, k4: t257, k5: t260, k6: t265, k7: t266, k8: t267, k9: t268, k10: t269, k11: t270, k12: t271, k13: t272, k14: t248, k15: t262, k16: t263, k17: t264, k18: t273, k19: t274, k20: t275, k21: t249, k22: t250, k23: t251, k24: t252, k25: t253, k26: t254, k27: t255, k28: t256 }
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
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = 0.8660254037844386_f64 * t6;
    let t27 = 0.5_f64 * t7;
    let t28 = sA + t24;
    let sC = R * t25;
    let t29 = t26 + t27;
    let t30 = t27 - t26;
    let t31 = t21 * t28;
    let t32 = 0.8660254037844386_f64 * sC;
    let t33 = 0.5_f64 * sC;
    let u_sB_per_u_hB = t29 * v_G_z_per_u_hA;
    let t34 = t30 * v_G_z_per_u_hA;
    let t35 = t31 * t32;
    let t36 = sA + t33;
    let t37 = t7 * v_G_z_per_u_hA;
    let t38 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t39 = t34 * t34;
    let t40 = t35 + t36;
    let t41 = t38 - 1.0_f64;
    let t42 = 1.0_f64 - t39;
    let t43 = t37 * t37;
    let t44 = 1.0_f64 / t40;
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t45 = 1.0_f64 / t41;
    let t46 = 1.0_f64 / t42;
    let t47 = 1.0_f64 - t43;
    let t48 = w_platform_x_per_u_hB * t32;
    let t49 = 1.0_f64 / t47;
    let k5 = p.k5;
    let t50 = k5 * u_sB_per_u_hB;
    let t51 = k5 * t34;
    let t52 = v_G_z_per_u_hA + t48;
    let t53 = 1.0_f64 - t38;
    let t54 = u_sB_per_u_hB * t50;
    let t55 = t34 * t51;
    let t56 = k5 * t37;
    let w_platform_y_per_u_hB = t44 * t48;
    let t57 = t44 * t52;
    let t58 = v_G_z_per_u_hA * t45;
    let t59 = Real::sqrt(t53);
    let k4 = p.k4;
    let t60 = t54 - k4;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t46;
    let t61 = t55 - k4;
    let t62 = t37 * t56;
    let u_hB = u[1];
    let t63 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t64 = u_hA * t57;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t44;
    let t65 = u_sB_per_u_hB - t34;
    let t66 = Real::sqrt(t42);
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t49;
    let t67 = Real::sqrt(t47);
    let t68 = t62 - k4;
    let t69 = t61 * u_psiC_per_w_platform_z;
    let t70 = t60 * t58;
    let t71 = t63 - t64;
    let u_hC = u[2];
    let t72 = u_hC * w_platform_y_per_u_hC;
    let t73 = 0.28867513459481287_f64 * t65;
    let t74 = 0.8660254037844386_f64 * t37;
    let t75 = 0.4330127018922193_f64 * sA;
    let t76 = u_psiC_per_w_platform_z * t69;
    let t77 = t58 * t70;
    let t78 = t68 * u_psiA_per_w_platform_z;
    let w_platform_y = t71 + t72;
    let t79 = u_hA - u_hB;
    let t80 = t74 - t73;
    let t81 = t73 + t74;
    let t82 = t75 + t18;
    let t83 = t76 + t77;
    let t84 = u_psiA_per_w_platform_z * t78;
    let t85 = t31 * w_platform_y;
    let t86 = t79 * w_platform_x_per_u_hB;
    let t87 = 0.8660254037844386_f64 * t80;
    let t88 = 0.8660254037844386_f64 * t81;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t82;
    let t89 = t84 + t83;
    let k13 = p.k13;
    let t90 = k13 * t22;
    let t91 = 1.0_f64 / t59;
    let t92 = t86 + t85;
    let t93 = t6 * t13;
    let t94 = t7 * t13;
    let t95 = t45 * t87;
    let t96 = t46 * t88;
    let M = p.M;
    let t97 = M * v_G_x_per_w_platform_z;
    let k15 = p.k15;
    let t98 = k15 - t89;
    let t99 = sA * t90;
    let t100 = 1.0_f64 / t66;
    let t101 = 1.0_f64 / t67;
    let t102 = 0.5_f64 * t80;
    let t103 = t93 * w_platform_y;
    let t104 = t94 * t92;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t65;
    let t105 = 0.5_f64 * t81;
    let t106 = v_G_x_per_w_platform_z * t97;
    let t107 = t99 + t98;
    let t108 = t69 * t96;
    let t109 = t70 * t95;
    let t110 = t45 * t102;
    let t111 = t103 + t104;
    let t112 = 0.5_f64 * v_G_z_per_u_hA;
    let t113 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let t114 = v_G_y_per_u_hA * t49;
    let u_psiC_per_w_platform_y = t46 * t105;
    let t115 = t106 + t107;
    let t116 = t108 + t109;
    let t117 = t110 * w_platform_y;
    let t118 = t95 * t92;
    let t119 = t112 * t91;
    let t120 = t113 * t91;
    let t121 = u_psiA_per_w_platform_z * t111;
    let t122 = t114 * w_platform_y;
    let t123 = 0.3333333333333333_f64 * t65;
    let t124 = t70 * t110;
    let t125 = t69 * u_psiC_per_w_platform_y;
    let t126 = 2.0_f64 * t116;
    let t127 = t94 * t115;
    let t128 = t61 * t96;
    let t129 = t60 * t95;
    let t130 = t117 - t118;
    let t131 = t58 * t111;
    let t132 = t80 * t91;
    let t133 = w_platform_y * t119;
    let t134 = t92 * t120;
    let t135 = u_psiC_per_w_platform_y * w_platform_y;
    let t136 = t96 * t92;
    let t137 = t100 * t112;
    let u_psiA = t122 - t121;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t101;
    let u_thC_per_w_platform_z = t81 * t100;
    let t138 = v_G_y_per_u_hA * t101;
    let t139 = v_G_x_per_w_platform_z * t111;
    let t140 = u_hA * t123;
    let t141 = 1.1547005383792515_f64 * t80;
    let t142 = t124 - t125;
    let t143 = t78 * t114;
    let t144 = t60 * t110;
    let t145 = t61 * u_psiC_per_w_platform_y;
    let t146 = t126 + t127;
    let t147 = t96 * t128;
    let t148 = t95 * t129;
    let u_psiB = t130 + t131;
    let t149 = t111 * t132;
    let t150 = t133 - t134;
    let t151 = t135 + t136;
    let t152 = u_psiC_per_w_platform_z * t111;
    let t153 = t37 * u_psiA;
    let t154 = t111 * u_thC_per_w_platform_z;
    let t155 = w_platform_y * t137;
    let u_thC_per_w_platform_x = t100 * t113;
    let t156 = t111 * t138;
    let t157 = w_platform_y * u_thA_per_w_platform_y;
    let t158 = t140 + t139;
    let t159 = u_hB * t141;
    let u_sB_per_w_platform_z = 0.8660254037844386_f64 * sA;
    let t160 = 0.5_f64 * t65;
    let t161 = t115 * t93;
    let t162 = t142 - t143;
    let t163 = t95 * t144;
    let t164 = t96 * t145;
    let t165 = t94 * t146;
    let t166 = t147 + t148;
    let t167 = u_sB_per_u_hB * u_psiB;
    let u_thB = t149 - t150;
    let t168 = 0.8660254037844386_f64 * w_platform_y;
    let t169 = 0.5_f64 * t92;
    let u_psiC = t151 - t152;
    let t170 = t155 + t154;
    let t171 = t92 * u_thC_per_w_platform_x;
    let t172 = 2.0_f64 * t153;
    let u_thA = t156 + t157;
    let t173 = t159 + t158;
    let t174 = t111 * u_sB_per_w_platform_z;
    let t175 = u_hA * t160;
    let t176 = t161 - t162;
    let t177 = t116 * t93;
    let t178 = t163 - t164;
    let t179 = t166 - t165;
    let t180 = 2.0_f64 * t162;
    let t181 = u_psiC_per_w_platform_y * t145;
    let t182 = t110 * t144;
    let t183 = t68 * t114;
    let t184 = t97 * t123;
    let t185 = v_G_y_per_u_hA * t90;
    let t186 = t167 * u_thB;
    let t187 = t168 + t169;
    let t188 = 0.8660254037844386_f64 * t92;
    let t189 = 0.5_f64 * w_platform_y;
    let t190 = t34 * u_psiC;
    let t191 = t171 + t170;
    let t192 = t172 * u_thA;
    let t193 = t92 * t111;
    let t194 = 0.5_f64 * t173;
    let t195 = t175 + t174;
    let t196 = t94 * t176;
    let t197 = t177 + t178;
    let k16 = p.k16;
    let t198 = t179 - k16;
    let t199 = t180 - t161;
    let t200 = t181 + t182;
    let t201 = t114 * t183;
    let t202 = t184 + t185;
    let t203 = 2.0_f64 * t186;
    let t204 = t187 * t111;
    let t205 = t188 - t189;
    let t206 = u_psiA * t67;
    let t207 = t168 - t169;
    let t208 = t190 * t191;
    let t209 = t67 * t192;
    let t210 = v_G_y_per_u_hA * t193;
    let t211 = w_platform_y * t92;
    let t212 = t194 + t195;
    let t213 = u_hB * u_sB_per_u_hB;
    let t214 = u_hA * t37;
    let t215 = t196 + t197;
    let t216 = t31 * t198;
    let t217 = t93 * t199;
    let t218 = t201 + t200;
    let t219 = t202 * t94;
    let t220 = t59 * t203;
    let t221 = t80 * t204;
    let t222 = t187 * t205;
    let t223 = u_psiB * t59;
    let t224 = t153 * t206;
    let t225 = t111 * t207;
    let t226 = 2.0_f64 * t208;
    let t227 = t189 + t188;
    let t228 = t210 - t209;
    let t229 = v_G_z_per_u_hA * t211;
    let t230 = t212 - t213;
    let u_sA = t173 - t214;
    let t231 = 2.0_f64 * t215;
    let t232 = t217 + t218;
    let t233 = t215 - t216;
    let t234 = t219 * t31;
    let t235 = t202 * t93;
    let t236 = t220 - t221;
    let t237 = v_G_z_per_u_hA * t222;
    let t238 = u_psiC * t66;
    let t239 = t167 * t223;
    let t240 = k5 * t224;
    let t241 = t81 * t225;
    let t242 = t66 * t226;
    let t243 = t207 * t227;
    let k6 = p.k6;
    let t244 = k6 * t192;
    let t245 = t229 + t228;
    let t246 = t111 * u_sA;
    let t247 = t111 * t230;
    let t248 = t231 - t216;
    let k17 = p.k17;
    let t249 = k17 - t232;
    let t250 = t233 * w_platform_x_per_u_hB;
    let t251 = t234 + t235;
    let t252 = M * t123;
    let t253 = M * v_G_y_per_u_hA;
    let t254 = t97 * t141;
    let t255 = t236 - t237;
    let t256 = k6 * t203;
    let t257 = t190 * t238;
    let t258 = k5 * t239;
    let t259 = t241 + t242;
    let t260 = v_G_z_per_u_hA * t243;
    let t261 = t67 * t244;
    let t262 = t49 * t245;
    let t263 = t138 * t240;
    let k18 = p.k18;
    let t264 = k18 * t211;
    let t265 = 2.0_f64 * t246;
    let t266 = sA * t211;
    let t267 = sB * t222;
    let t268 = 2.0_f64 * t247;
    let t269 = t31 * t248;
    let t270 = t99 + t249;
    let t271 = t250 + t251;
    let t272 = v_G_z_per_u_hA * t90;
    let t273 = t198 * w_platform_x_per_u_hB;
    let t274 = 2.0_f64 * t219;
    let t275 = t123 * t252;
    let t276 = v_G_y_per_u_hA * t253;
    let t277 = t94 * t254;
    let t278 = t45 * t255;
    let t279 = 2.0_f64 * t256;
    let t280 = k5 * t257;
    let t281 = t260 + t259;
    let t282 = k6 * t226;
    let t283 = 2.0_f64 * t261;
    let t284 = t68 * t262;
    let t285 = t132 * t258;
    let t286 = t264 - t263;
    let t287 = t266 + t265;
    let t288 = t267 + t268;
    let t289 = sA * t111;
    let t290 = u_hA * v_G_y_per_u_hA;
    let t291 = t269 + t270;
    let t292 = t272 + t271;
    let t293 = t273 - t274;
    let t294 = t275 + t276;
    let t295 = t31 * t277;
    let t296 = t93 * t254;
    let t297 = t60 * t278;
    let t298 = t59 * t279;
    let u_psiC_dot_bias = t46 * t281;
    let t299 = t66 * t282;
    let t300 = t283 - t284;
    let t301 = u_thC_per_w_platform_z * t280;
    let t302 = t285 + t286;
    let t303 = 0.8660254037844386_f64 * t288;
    let t304 = 0.4330127018922193_f64 * t287;
    let t305 = u_hC * t34;
    let v_G_y = t289 + t290;
    let t306 = t291 * t57;
    let t307 = 2.0_f64 * t292;
    let t308 = w_platform_x_per_u_hB * t293;
    let k11 = p.k11;
    let t309 = k11 + t294;
    let t310 = M * v_G_z_per_u_hA;
    let t311 = t295 + t296;
    let t312 = t297 - t298;
    let t313 = t61 * u_psiC_dot_bias;
    let t314 = 2.0_f64 * t299;
    let t315 = t205 * t230;
    let t316 = w_platform_y * u_sA;
    let t317 = t301 - t302;
    let t318 = u_psiA_per_w_platform_z * t300;
    let t319 = t304 - t303;
    let t320 = t305 - t194;
    let t321 = 0.8660254037844386_f64 * v_G_y;
    let t322 = t306 - t307;
    let t323 = t308 - t309;
    let t324 = v_G_z_per_u_hA * t310;
    let t325 = t311 - t250;
    let t326 = t291 * w_platform_y_per_u_hB;
    let t327 = t313 + t314;
    let t328 = sB * t204;
    let t329 = 2.0_f64 * t315;
    let t330 = 2.0_f64 * t316;
    let t331 = sA * t193;
    let t332 = t58 * t312;
    let t333 = t318 + t317;
    let t334 = M * t287;
    let k10 = p.k10;
    let t335 = k10 * v_G_y_per_u_hA;
    let t336 = 1.3333333333333333_f64 * t319;
    let t337 = t120 * t258;
    let t338 = u_thC_per_w_platform_x * t280;
    let u_sC = t320 + t321;
    let t339 = t57 * t322;
    let t340 = t323 - t324;
    let t341 = t326 + t325;
    let t342 = M * t141;
    let t343 = t137 * t280;
    let t344 = t119 * t258;
    let t345 = t328 - t329;
    let t346 = t330 - t331;
    let t347 = t332 - t333;
    let t348 = u_psiC_per_w_platform_z * t327;
    let t349 = t334 + t335;
    let t350 = M * t336;
    let t351 = k10 * t37;
    let t352 = t337 - t338;
    let t353 = t95 * t312;
    let t354 = t227 * u_sC;
    let mass_u_hA_u_hA = t339 - t340;
    let t355 = t57 * t341;
    let t356 = t123 * t342;
    let t357 = t219 - t277;
    let t358 = 2.0_f64 * t277;
    let t359 = t343 + t344;
    let t360 = u_thA_per_w_platform_y * t240;
    let t361 = t346 - t345;
    let t362 = t348 - t347;
    let t363 = sA * t349;
    let t364 = t350 + t351;
    let t365 = t352 - t353;
    let t366 = t96 * t327;
    let t367 = w_platform_y * t111;
    let t368 = sC * t225;
    let t369 = 2.0_f64 * t354;
    let t370 = 1.0_f64 / mass_u_hA_u_hA;
    let t371 = t355 - t356;
    let t372 = t292 * w_platform_y_per_u_hB;
    let t373 = t357 - t273;
    let t374 = t273 + t358;
    let t375 = t110 * t312;
    let t376 = t360 + t359;
    let t377 = t21 * t361;
    let t378 = t363 + t362;
    let t379 = v_G_x_per_w_platform_z * t364;
    let t380 = t366 + t365;
    let k19 = p.k19;
    let t381 = k19 * t367;
    let t382 = t368 + t369;
    let t383 = t372 - t371;
    let t384 = w_platform_x_per_u_hB * t373;
    let t385 = 2.0_f64 * t325;
    let t386 = w_platform_x_per_u_hB * t374;
    let t387 = t141 * t342;
    let t388 = t375 - t376;
    let t389 = u_psiC_per_w_platform_y * t327;
    let t390 = t379 + t378;
    let t391 = t381 + t380;
    let t392 = t198 * t377;
    let t393 = t32 * t377;
    let t394 = t346 + t382;
    let mass_u_hA_u_hB = t383 - t384;
    let t395 = t326 + t385;
    let t396 = t386 - t387;
    let t397 = t389 + t388;
    let t398 = t114 * t300;
    let t399 = t392 + t391;
    let t400 = t94 * t390;
    let t401 = t393 + t394;
    let t402 = t219 * t377;
    let t403 = t370 * mass_u_hA_u_hB;
    let t404 = w_platform_y_per_u_hB * t395;
    let t405 = t396 - k11;
    let t406 = t398 + t397;
    let k20 = p.k20;
    let t407 = k20 * t193;
    let t408 = t399 - t400;
    let t409 = t44 * t401;
    let FA = inputs[0];
    let t410 = FA - t402;
    let t411 = t123 * t364;
    let t412 = mass_u_hA_u_hB * t403;
    let mass_u_hB_u_hB = t404 - t405;
    let t413 = t291 * w_platform_y_per_u_hC;
    let t414 = t407 + t406;
    let t415 = t215 * t377;
    let t416 = w_platform_x_per_u_hB * t408;
    let t417 = t292 * t409;
    let t418 = t410 - t411;
    let t419 = v_G_y_per_u_hA * t349;
    let pivot_1 = mass_u_hB_u_hB - t412;
    let t420 = t292 * w_platform_y_per_u_hC;
    let t421 = t57 * t413;
    let t422 = t414 - t415;
    let t423 = t93 * t390;
    let t424 = t31 * t408;
    let t425 = t291 * t409;
    let t426 = M * t346;
    let t427 = k10 * v_G_z_per_u_hA;
    let t428 = t277 * t377;
    let t429 = t417 + t416;
    let t430 = t418 - t419;
    let t431 = 1.0_f64 / pivot_1;
    let mass_u_hA_u_hC = t420 - t421;
    let t432 = t325 * w_platform_y_per_u_hC;
    let t433 = w_platform_y_per_u_hB * t413;
    let t434 = t422 - t423;
    let t435 = t425 + t424;
    let t436 = t426 + t427;
    let t437 = t141 * t364;
    let t438 = t325 * t409;
    let FB = inputs[1];
    let t439 = FB - t428;
    let t440 = t430 + t429;
    let t441 = t403 * mass_u_hA_u_hC;
    let mass_u_hB_u_hC = t432 + t433;
    let t442 = t434 + t435;
    let t443 = sA * t436;
    let t444 = t416 + t437;
    let t445 = t438 + t439;
    let k9 = p.k9;
    let t446 = t440 - k9;
    let c = p.c;
    let t447 = u_hA * c;
    let t448 = mass_u_hB_u_hC - t441;
    let t449 = t370 * mass_u_hA_u_hC;
    let t450 = w_platform_y_per_u_hC * t413;
    let t451 = t442 - t443;
    let t452 = t445 - t444;
    let t453 = t446 - t447;
    let t454 = v_G_z_per_u_hA * t436;
    let t455 = t431 * t448;
    let t456 = mass_u_hA_u_hC * t449;
    let mass_u_hC_u_hC = k11 + t450;
    let t457 = t452 - k9;
    let t458 = u_hB * c;
    let t459 = t57 * t451;
    let t460 = t453 - t454;
    let t461 = t448 * t455;
    let t462 = mass_u_hC_u_hC - t456;
    let t463 = w_platform_y_per_u_hB * t451;
    let t464 = t457 - t458;
    let forcing_u_hA = t460 - t459;
    let pivot_2 = t462 - t461;
    let forcing_u_hB = t463 + t464;
    let t465 = t403 * forcing_u_hA;
    let t466 = Real::abs(pivot_2);
    let t467 = Real::abs(pivot_1);
    let t468 = forcing_u_hB - t465;
    let t469 = u_hC * c;
    let FC = inputs[2];
    let t470 = k9 - FC;
    let t471 = Real::abs(mass_u_hA_u_hA);
    let t472 = t455 * t468;
    let t473 = t449 * forcing_u_hA;
    let t474 = w_platform_y_per_u_hC * t451;
    let t475 = t469 + t470;
    let t476 = Real::abs(t40);
    let t477 = t472 + t473;
    let forcing_u_hC = t474 - t475;
    let t478 = Real::abs(t18);
    let t479 = forcing_u_hC - t477;
    let t480 = Real::abs(t11);
    let t481 = t479 / pivot_2;
    let k28 = p.k28;
    let k27 = p.k27;
    let k26 = p.k26;
    let t482 = Real::min(Real::min(t466 * k28, t467 * k27), t471 * k26);
    let k25 = p.k25;
    let t483 = t476 * k25;
    let t484 = t431 * t468;
    let t485 = t455 * t481;
    let t486 = Real::min(t482, t483);
    let k24 = p.k24;
    let t487 = t478 * k24;
    let t488 = t484 - t485;
    let t489 = Real::min(t486, t487);
    let k23 = p.k23;
    let t490 = t480 * k23;
    let t491 = Real::min(t53, t42);
    let t492 = t403 * t488;
    let t493 = t449 * t481;
    let t494 = Real::min(t489, t490);
    let k22 = p.k22;
    let t495 = t491 * k22;
    let t496 = t493 + t492;
    let t497 = t370 * forcing_u_hA;
    let t498 = Real::min(t494, t495);
    let k21 = p.k21;
    let t499 = t47 * k21;
    let t500 = t497 - t496;
    let t501 = Real::min(t498, t499);
    ([u_hA, u_hB, u_hC], [t500, t488, t481], t501)
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
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = t21 * t26;
    let t28 = 0.8660254037844386_f64 * sC;
    let t29 = 0.5_f64 * sC;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t30 = 1.0_f64 / (t27 * t28 + (sA + t29));
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t31 = 0.8660254037844386_f64 * t6;
    let t32 = 0.5_f64 * t7;
    let t33 = w_platform_x_per_u_hB * t28;
    let t34 = t31 + t32;
    let t35 = t32 - t31;
    let t36 = v_G_z_per_u_hA + t33;
    let u_sB_per_u_hB = t34 * v_G_z_per_u_hA;
    let t37 = t35 * v_G_z_per_u_hA;
    let w_platform_y_per_u_hB = t30 * t33;
    let t38 = t30 * t36;
    let t39 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t40 = t37 * t37;
    let u_hB = u[1];
    let t41 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t42 = u_hA * t38;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t30;
    let t43 = t7 * v_G_z_per_u_hA;
    let t44 = t39 - 1.0_f64;
    let t45 = 1.0_f64 - t40;
    let t46 = t41 - t42;
    let u_hC = u[2];
    let t47 = u_hC * w_platform_y_per_u_hC;
    let t48 = u_sB_per_u_hB - t37;
    let t49 = 1.0_f64 / t44;
    let t50 = 1.0_f64 / t45;
    let t51 = t43 * t43;
    let w_platform_y = t46 + t47;
    let t52 = 0.28867513459481287_f64 * t48;
    let t53 = 0.8660254037844386_f64 * t43;
    let t54 = u_hA - u_hB;
    let t55 = 1.0_f64 - t51;
    let t56 = t53 - t52;
    let t57 = t27 * w_platform_y;
    let t58 = t54 * w_platform_x_per_u_hB;
    let t59 = t52 + t53;
    let t60 = 1.0_f64 / t55;
    let t61 = 0.5_f64 * t56;
    let t62 = t58 + t57;
    let t63 = 0.8660254037844386_f64 * t56;
    let t64 = t6 * t13;
    let t65 = t7 * t13;
    let t66 = 0.5_f64 * t59;
    let t67 = 0.8660254037844386_f64 * t59;
    let t68 = t49 * t61;
    let t69 = t49 * t63;
    let t70 = t64 * w_platform_y;
    let t71 = t65 * t62;
    let u_psiC_per_w_platform_y = t50 * t66;
    let t72 = t50 * t67;
    let t73 = t68 * w_platform_y;
    let t74 = t69 * t62;
    let t75 = t70 + t71;
    let t76 = v_G_z_per_u_hA * t49;
    let t77 = u_psiC_per_w_platform_y * w_platform_y;
    let t78 = t72 * t62;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t50;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t48;
    let t79 = t73 - t74;
    let t80 = t76 * t75;
    let k5 = p.k5;
    let t81 = k5 * u_sB_per_u_hB;
    let t82 = t77 + t78;
    let t83 = u_psiC_per_w_platform_z * t75;
    let t84 = k5 * t37;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t60;
    let t85 = v_G_y_per_u_hA * t60;
    let t86 = 0.4330127018922193_f64 * sA;
    let u_psiB = t79 + t80;
    let t87 = u_sB_per_u_hB * t81;
    let u_psiC = t82 - t83;
    let t88 = t37 * t84;
    let t89 = u_psiA_per_w_platform_z * t75;
    let t90 = t85 * w_platform_y;
    let t91 = k5 * t43;
    let t92 = t86 + t18;
    let t93 = u_psiB * u_psiB;
    let k4 = p.k4;
    let t94 = t87 - k4;
    let t95 = u_psiC * u_psiC;
    let t96 = t88 - k4;
    let u_psiA = t90 - t89;
    let t97 = t43 * t91;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t92;
    let t98 = 0.3333333333333333_f64 * t48;
    let t99 = t94 * t93;
    let t100 = t96 * t95;
    let t101 = u_psiA * u_psiA;
    let t102 = t97 - k4;
    let t103 = sA * t75;
    let t104 = u_hA * v_G_y_per_u_hA;
    let t105 = v_G_x_per_w_platform_z * t75;
    let t106 = u_hA * t98;
    let t107 = 1.1547005383792515_f64 * t56;
    let t108 = t99 + t100;
    let t109 = t102 * t101;
    let t110 = t75 * t75;
    let v_G_y = t103 + t104;
    let t111 = t106 + t105;
    let t112 = u_hB * t107;
    let t113 = t109 + t108;
    let k15 = p.k15;
    let t114 = k15 * t110;
    let t115 = v_G_y * v_G_y;
    let t116 = t112 + t111;
    let t117 = t114 - t113;
    let M = p.M;
    let t118 = M * t115;
    let t119 = t116 * t116;
    let t120 = sA * w_platform_y;
    let t121 = u_hA * v_G_z_per_u_hA;
    let t122 = t118 + t117;
    let t123 = M * t119;
    let t124 = t62 * t62;
    let v_G_z = t120 + t121;
    let t125 = t123 + t122;
    let k16 = p.k16;
    let t126 = k16 * t124;
    let t127 = w_platform_y * w_platform_y;
    let t128 = v_G_z * v_G_z;
    let t129 = u_hB * u_hB;
    let t130 = t126 + t125;
    let k17 = p.k17;
    let t131 = k17 * t127;
    let t132 = M * t128;
    let k11 = p.k11;
    let t133 = k11 * t129;
    let t134 = u_hA * u_hA;
    let t135 = u_hC * u_hC;
    let k12 = p.k12;
    let t136 = k12 * t22;
    let t137 = t131 + t130;
    let t138 = t133 + t132;
    let t139 = k11 * t134;
    let t140 = k11 * t135;
    let t141 = t43 * t136;
    let g = p.g;
    let t142 = hA * g;
    let k7 = p.k7;
    let t143 = hB * k7;
    let k9 = p.k9;
    let t144 = hA * k9;
    let k8 = p.k8;
    let t145 = hB * k8;
    let t146 = hC * k9;
    let t147 = t137 + t138;
    let t148 = t139 + t140;
    let t149 = t142 + t141;
    let t150 = t143 + t144;
    let t151 = t145 + t146;
    let t152 = t148 + t147;
    let t153 = M * t149;
    let t154 = t150 + t151;
    let t155 = 0.5_f64 * t152;
    let t156 = t153 + t154;
    (t155, t156)
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
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let t12 = 2.0_f64 * t7;
    let t13 = 1.0_f64 / t11;
    let t14 = 0.8660254037844386_f64 * (t6 * t12);
    let t15 = 1.0_f64 + (t8 + t14) * t13;
    let t16 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let R = p.R;
    let sB = R * t15;
    let t17 = t16 + cos2;
    let t18 = 0.8660254037844386_f64 * sB;
    let t19 = t17 * t13;
    let t20 = t8 - t14;
    let t21 = 1.0_f64 / t18;
    let t22 = 1.0_f64 + t19;
    let t23 = t20 * t13;
    let sA = R * t22;
    let t24 = 0.5_f64 * sB;
    let t25 = 1.0_f64 + t23;
    let t26 = sA + t24;
    let sC = R * t25;
    let t27 = t21 * t26;
    let t28 = 0.8660254037844386_f64 * sC;
    let t29 = 0.5_f64 * sC;
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t30 = 1.0_f64 / (t27 * t28 + (sA + t29));
    let w_platform_x_per_u_hB = v_G_z_per_u_hA * t21;
    let t31 = 0.8660254037844386_f64 * t6;
    let t32 = 0.5_f64 * t7;
    let t33 = w_platform_x_per_u_hB * t28;
    let t34 = t31 + t32;
    let t35 = t32 - t31;
    let t36 = v_G_z_per_u_hA + t33;
    let u_sB_per_u_hB = t34 * v_G_z_per_u_hA;
    let t37 = t35 * v_G_z_per_u_hA;
    let w_platform_y_per_u_hB = t30 * t33;
    let t38 = t30 * t36;
    let t39 = t7 * v_G_z_per_u_hA;
    let t40 = u_sB_per_u_hB * u_sB_per_u_hB;
    let t41 = t37 * t37;
    let u_hB = u[1];
    let t42 = u_hB * w_platform_y_per_u_hB;
    let u_hA = u[0];
    let t43 = u_hA * t38;
    let w_platform_y_per_u_hC = v_G_z_per_u_hA * t30;
    let t44 = t39 * t39;
    let t45 = 1.0_f64 - t40;
    let t46 = 1.0_f64 - t41;
    let t47 = t42 - t43;
    let u_hC = u[2];
    let t48 = u_hC * w_platform_y_per_u_hC;
    let t49 = 1.0_f64 - t44;
    let t50 = Real::sqrt(t45);
    let t51 = Real::sqrt(t46);
    let w_platform_y = t47 + t48;
    let t52 = u_hA - u_hB;
    let t53 = Real::sqrt(t49);
    let t54 = t27 * w_platform_y;
    let t55 = t52 * w_platform_x_per_u_hB;
    let t56 = t6 * t13;
    let t57 = t55 + t54;
    let t58 = t7 * t13;
    let t59 = u_sB_per_u_hB - t37;
    let t60 = 0.4330127018922193_f64 * sA;
    let t61 = t40 - 1.0_f64;
    let t62 = t56 * w_platform_y;
    let t63 = t58 * t57;
    let t64 = t60 + t18;
    let t65 = 0.28867513459481287_f64 * t59;
    let t66 = 0.8660254037844386_f64 * t39;
    let t67 = 1.0_f64 / t61;
    let t68 = 1.0_f64 / t50;
    let t69 = 1.0_f64 / t46;
    let t70 = 1.0_f64 / t51;
    let t71 = t62 + t63;
    let v_G_x_per_w_platform_z = 1.3333333333333333_f64 * t64;
    let t72 = 0.3333333333333333_f64 * t59;
    let t73 = t66 - t65;
    let t74 = 1.0_f64 / t49;
    let t75 = 1.0_f64 / t53;
    let t76 = v_G_x_per_w_platform_z * t71;
    let t77 = u_hA * t72;
    let t78 = 1.1547005383792515_f64 * t73;
    let t79 = t65 + t66;
    let v_G_y_per_u_hA = 0.5773502691896257_f64 * t59;
    let t80 = t77 + t76;
    let t81 = u_hB * t78;
    let t82 = 0.5_f64 * t73;
    let t83 = 0.8660254037844386_f64 * t73;
    let t84 = 0.5_f64 * v_G_z_per_u_hA;
    let t85 = 0.8660254037844386_f64 * v_G_z_per_u_hA;
    let u_sB_per_w_platform_z = 0.8660254037844386_f64 * sA;
    let t86 = 0.5_f64 * t59;
    let t87 = 0.5_f64 * t79;
    let t88 = 0.8660254037844386_f64 * t79;
    let t89 = t7 * root;
    let t90 = t6 * root;
    let t91 = t81 + t80;
    let t92 = t67 * t82;
    let t93 = t67 * t83;
    let t94 = t84 * t68;
    let t95 = t85 * t68;
    let t96 = t71 * u_sB_per_w_platform_z;
    let t97 = u_hA * t86;
    let u_psiC_per_w_platform_y = t69 * t87;
    let t98 = t69 * t88;
    let u_thC_per_w_platform_z = t79 * t70;
    let t99 = t70 * t84;
    let t100 = sA * t71;
    let t101 = u_hA * v_G_y_per_u_hA;
    let t102 = w_platform_y * t89;
    let t103 = t57 * t90;
    let u_psiA_per_w_platform_z = v_G_z_per_u_hA * t74;
    let t104 = v_G_y_per_u_hA * t74;
    let t105 = v_G_y_per_u_hA * t75;
    let u_thA_per_w_platform_y = v_G_z_per_u_hA * t75;
    let t106 = t92 * w_platform_y;
    let t107 = t93 * t57;
    let t108 = v_G_z_per_u_hA * t67;
    let t109 = t73 * t68;
    let t110 = w_platform_y * t94;
    let t111 = t57 * t95;
    let t112 = 0.5_f64 * t91;
    let t113 = t97 + t96;
    let t114 = u_psiC_per_w_platform_y * w_platform_y;
    let t115 = t98 * t57;
    let u_psiC_per_w_platform_z = v_G_z_per_u_hA * t69;
    let t116 = t71 * u_thC_per_w_platform_z;
    let t117 = w_platform_y * t99;
    let u_thC_per_w_platform_x = t70 * t85;
    let t118 = u_hC * t37;
    let v_G_y = t100 + t101;
    let u_root = t102 - t103;
    let t119 = u_psiA_per_w_platform_z * t71;
    let t120 = t104 * w_platform_y;
    let t121 = t71 * t105;
    let t122 = w_platform_y * u_thA_per_w_platform_y;
    let t123 = u_hA * t39;
    let t124 = t106 - t107;
    let t125 = t108 * t71;
    let t126 = t71 * t109;
    let t127 = t110 - t111;
    let t128 = t112 + t113;
    let t129 = u_hB * u_sB_per_u_hB;
    let t130 = t114 + t115;
    let t131 = u_psiC_per_w_platform_z * t71;
    let t132 = t117 + t116;
    let t133 = t57 * u_thC_per_w_platform_x;
    let t134 = t118 - t112;
    let t135 = 0.8660254037844386_f64 * v_G_y;
    let t136 = t58 * u_root;
    let t137 = root * w_platform_y;
    let t138 = t56 * u_root;
    let t139 = root * t57;
    let u_psiA = t120 - t119;
    let u_thA = t121 + t122;
    let u_sA = t91 - t123;
    let u_psiB = t124 + t125;
    let u_thB = t126 - t127;
    let t140 = t129 - t128;
    let u_psiC = t130 - t131;
    let t141 = t133 + t132;
    let u_sC = t134 + t135;
    let u_slope_x = t137 + t136;
    let u_slope_y = t139 - t138;
    [u_hA, u_psiA, u_thA, u_sA, u_hB, u_psiB, u_thB, t140, u_hC, u_psiC, -t141, u_sC, u_slope_x, u_slope_y, u_root]
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
    let hB = q[1];
    let hC = q[2];
    let t1 = 0.5_f64 * (hB + hC);
    let t2 = hB - hC;
    let hA = q[0];
    let t3 = t1 - hA;
    let t4 = 1.7320508075688772_f64 * t2;
    let t5 = 2.0_f64 * t3;
    let k14 = p.k14;
    let t6 = k14 * t4;
    let t7 = k14 * t5;
    let t8 = t6 * t6;
    let t9 = t7 * t7;
    let t10 = t8 + t9;
    let root = Real::sqrt(1.0_f64 + t10);
    let t11 = 1.0_f64 + root;
    let k = 1.0_f64 / (root * t11);
    let t12 = t7 * k;
    let t13 = t9 * k;
    let psiA = Real::atan2(t6 * t12, 1.0_f64 - t13);
    let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);
    let v_G_z_per_u_hA = 1.0_f64 / root;
    let t14 = t7 * v_G_z_per_u_hA;
    let t15 = 1.0_f64 - t14 * t14;
    let t16 = 1.0_f64 / t11;
    let t17 = Real::sqrt(t15);
    let t18 = 0.8660254037844386_f64 * t6;
    let t19 = 0.5_f64 * t7;
    let t20 = 0.5_f64 * t10;
    let cos2 = t9 - t8;
    let t21 = 2.0_f64 * t7;
    let t22 = t18 + t19;
    let t23 = t19 - t18;
    let t24 = t20 + cos2;
    let t25 = t6 * t21;
    let u_sB_per_u_hB = t22 * v_G_z_per_u_hA;
    let t26 = t23 * v_G_z_per_u_hA;
    let t27 = t24 * t16;
    let t28 = 0.8660254037844386_f64 * t25;
    let thA = Real::asin(t14);
    let t29 = Real::asin(u_sB_per_u_hB);
    let t30 = Real::asin(t26);
    let t31 = 1.0_f64 + t27;
    let t32 = 0.8660254037844386_f64 * t7;
    let t33 = 0.5_f64 * t6;
    let t34 = t22 * t22;
    let t35 = t8 + t28;
    let t36 = t23 * t23;
    let t37 = t8 - t28;
    let R = p.R;
    let sA = R * t31;
    let t38 = t17 * cos_psiA;
    let t39 = t22 * k;
    let t40 = t32 - t33;
    let t41 = t34 * k;
    let t42 = t35 * t16;
    let t43 = t23 * k;
    let acrossC = t32 + t33;
    let t44 = t36 * k;
    let t45 = t37 * t16;
    let t46 = t17 * sin_psiA;
    let t47 = sA * t38;
    let t48 = sA * t14;
    let t49 = t40 * t39;
    let t50 = 1.0_f64 - t41;
    let t51 = 1.0_f64 + t42;
    let t52 = acrossC * t43;
    let t53 = 1.0_f64 - t44;
    let t54 = 1.0_f64 + t45;
    let t55 = sA * t46;
    let t56 = R - t47;
    let t57 = hA + t48;
    let psiB = Real::atan2(-t49, t50);
    let sB = R * t51;
    let psiC = Real::atan2(t52, t53);
    let sC = R * t54;
    [t55, t56, t57, psiA, thA, sA, psiB, -t29, sB, psiC, -t30, sC]
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
    ([], 0.0_f64)
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
