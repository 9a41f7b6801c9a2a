// Generated from models/fourbar.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// fourbar: 3 coordinates, 1 independent speed, 1 input, 11 tunable parameters; scalar f64.
// Pivots: 3; the worst over 66 sampled configurations is 0.463 of its nominal size.
// Cost of rates: 93 operations (3 abs, 12 add, 3 cos, 2 div, 2 min, 58 mul, 3 sin, 10 sub).
// Cost of energy: 50 operations (8 add, 3 cos, 1 div, 31 mul, 3 sin, 4 sub).
// Cost of speeds: 22 operations (3 cos, 1 div, 12 mul, 3 sin, 3 sub).
// Cost of outputs: 0 operations ().
// Cost of projection: 49 operations (2 abs, 11 add, 3 cos, 1 div, 1 max, 24 mul, 3 sin, 4 sub).
// Cost of prepare: 66 operations (11 abs, 8 add, 6 div, 3 max, 38 mul).

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f64;
/// Number of coordinates q.
pub const NQ: usize = 3usize;
/// Number of independent speeds u.
pub const NU: usize = 1usize;
/// Number of inputs.
pub const N_INPUTS: usize = 1usize;
///Coordinates in order.
pub const Q_NAMES: [&str; 3usize] = ["q1", "q2", "q3"];
///Independent speeds in order.
pub const U_NAMES: [&str; 1usize] = ["u1"];
///Inputs in order.
pub const INPUT_NAMES: [&str; 1usize] = ["T"];
///Tunable parameters in order.
pub const PARAMETER_NAMES: [&str; 11usize] = [
    "l1",
    "l2",
    "l3",
    "l4",
    "m1",
    "m2",
    "m3",
    "I1",
    "I2",
    "I3",
    "g",
];
///All speeds in order.
pub const SPEED_NAMES: [&str; 3usize] = ["u1", "u2", "u3"];
///Outputs in order.
pub const OUTPUT_NAMES: [&str; 0usize] = [];
/// Indices of the coordinates that the projection corrects.
pub const CORRECTED: [usize; 2usize] = [1usize, 2usize];
/// Coordinates read only by sines and cosines: they may be wrapped by whole turns.
pub const IS_ANGLE: [bool; 3usize] = [true, true, true];
/// The nominal configuration.
pub const NOMINAL: [f64; 3usize] = [1f64, 0.4059193479414579f64, -1.888052664051308f64];
/// Tunable parameters, SI units.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Parameters {
    ///Crank (m), models/fourbar.toml:9.
    pub l1: S,
    ///Coupler (m), models/fourbar.toml:10.
    pub l2: S,
    ///Rocker (m), models/fourbar.toml:11.
    pub l3: S,
    ///Ground (m), models/fourbar.toml:12.
    pub l4: S,
    ///M1 (kg), models/fourbar.toml:13.
    pub m1: S,
    ///M2 (kg), models/fourbar.toml:14.
    pub m2: S,
    ///M3 (kg), models/fourbar.toml:15.
    pub m3: S,
    ///About the mass centre (kg m^2), models/fourbar.toml:16.
    pub I1: S,
    ///I2 (kg m^2), models/fourbar.toml:17.
    pub I2: S,
    ///I3 (kg m^2), models/fourbar.toml:18.
    pub I3: S,
    ///G (m/s^2), models/fourbar.toml:19.
    pub g: S,
}
impl Default for Parameters {
    fn default() -> Self {
        Self {
            l1: 1.0_f64,
            l2: 2.2_f64,
            l3: 1.8_f64,
            l4: 2.0_f64,
            m1: 1.1_f64,
            m2: 2.3_f64,
            m3: 1.7_f64,
            I1: 0.09_f64,
            I2: 0.9_f64,
            I3: 0.45_f64,
            g: 9.81_f64,
        }
    }
}
/// Lowest and highest value of every tunable parameter, SI units.
pub const PARAMETER_RANGES: [[S; 2]; 11usize] = [
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [0.0_f64, S::INFINITY],
    [0.0_f64, S::INFINITY],
    [0.0_f64, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
];
impl Parameters {
    /// Is every parameter a finite number within its range?
    ///
    /// # Errors
    /// The first that is not, with its value and range.
    pub fn check(&self) -> Result<(), smartbed_runtime::mechanism::OutOfRange<S>> {
        let values = [
            self.l1,
            self.l2,
            self.l3,
            self.l4,
            self.m1,
            self.m2,
            self.m3,
            self.I1,
            self.I2,
            self.I3,
            self.g,
        ];
        smartbed_runtime::mechanism::check_parameters(&PARAMETER_NAMES, &values, &PARAMETER_RANGES)
    }
}
/// What the functions below need of the parameters, from [`prepare`].
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Prepared {
    ///The parameter `l1`.
    pub l1: S,
    ///The parameter `l2`.
    pub l2: S,
    ///The parameter `l3`.
    pub l3: S,
    ///The parameter `l4`.
    pub l4: S,
    ///The parameter `m2`.
    pub m2: S,
    ///The parameter `m3`.
    pub m3: S,
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
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///66 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let l3 = p.l3;
    let t1 = Real::abs(l3);
    let l1 = p.l1;
    let t2 = Real::abs(l1);
    let m3 = p.m3;
    let t3 = Real::abs(m3);
    let m1 = p.m1;
    let t4 = Real::abs(m1);
    let I3 = p.I3;
    let t5 = Real::abs(I3);
    let m2 = p.m2;
    let t6 = Real::abs(m2);
    let I1 = p.I1;
    let t7 = Real::abs(I1);
    let t8 = 1.0_f64 / t1;
    let t9 = 0.5_f64 * t1;
    let t10 = 0.5_f64 * t2;
    let t11 = t9 * t9;
    let l2 = p.l2;
    let t12 = Real::abs(l2);
    let t13 = t10 * t10;
    let t14 = t3 * t11;
    let t15 = t2 * t2;
    let t16 = t4 * t13;
    let t17 = t5 + t14;
    let t18 = t2 * t8;
    let t19 = t6 * t15;
    let t20 = t7 + t16;
    let t21 = t17 * t18;
    let t22 = t19 + t20;
    let t23 = t18 * t21;
    let t24 = 2.0_f64 * t12;
    let t25 = 2.0_f64 * t1;
    let t26 = t22 + t23;
    let t27 = Real::abs(t24);
    let t28 = Real::abs(t25);
    let t29 = Real::abs(t26);
    let t30 = 0.22727272727272727_f64 * t27;
    let t31 = 0.2777777777777778_f64 * t28;
    let t32 = 0.30970406056434957_f64 * t29;
    let t33 = 0.5_f64 * l1;
    let t34 = 1.0_f64 / l2;
    let t35 = 1.0_f64 / l3;
    let t36 = Real::max(t30, 1e-24_f64);
    let t37 = Real::max(t31, 1e-24_f64);
    let t38 = Real::max(t32, 1e-24_f64);
    let t39 = 0.5_f64 * l2;
    let t40 = 0.5_f64 * l3;
    let t41 = t33 * t33;
    let t42 = 0.6062967032112268_f64 / t36;
    let t43 = 0.7410293039248327_f64 / t37;
    let t44 = 0.41205789559162753_f64 / t38;
    let t45 = l1 * l1;
    let t46 = m1 * t41;
    let t47 = t39 * t39;
    let t48 = t40 * t40;
    let g = p.g;
    let t49 = g * t33;
    let t50 = l1 * t39;
    let t51 = g * t40;
    let t52 = m2 * t45;
    let t53 = I1 + t46;
    let t54 = m2 * t47;
    let t55 = m3 * t48;
    let t56 = m1 * t49;
    let t57 = l1 * g;
    let t58 = g * t39;
    let t59 = m2 * t50;
    let t60 = m3 * t51;
    let t61 = t52 + t53;
    let I2 = p.I2;
    let t62 = I2 + t54;
    let t63 = I3 + t55;
    let t64 = l2 * g;
    let t65 = l1 * t34;
    let t66 = l1 * t35;
    let l4 = p.l4;
    Prepared { l1, l2, l3, l4, m2, m3, k6: t34, k7: t35, k8: t56, k9: t50, k10: t57, k11: t58, k12: t59, k13: t51, k14: t60, k15: t61, k16: t62, k17: t63, k18: t64, k19: t65, k20: t66, k21: t42, k22: t43, k23: t44 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///93 operations.
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
    u: &[S; 1usize],
    inputs: &[S; 1usize],
    p: &Prepared,
) -> ([S; 3usize], [S; 1usize], S) {
    let q1 = q[0];
    let q3 = q[2];
    let [(sin_q1, cos_q1), (sin_q3, cos_q3)] = Real::sin_cos_of_two(q1, q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = cos_q3 * sin_q2 - sin_q3 * cos_q2;
    let t2 = 1.0_f64 / t1;
    let t3 = sin_q1 * cos_q3 - cos_q1 * sin_q3;
    let t4 = sin_q1 * cos_q2;
    let t5 = cos_q1 * sin_q2;
    let k19 = p.k19;
    let t6 = t3 * k19;
    let t7 = t4 - t5;
    let t8 = t2 * t6;
    let k20 = p.k20;
    let t9 = t7 * k20;
    let u1 = u[0];
    let t10 = u1 * t8;
    let t11 = t2 * t9;
    let u3 = u1 * t11;
    let t12 = t10 * t10;
    let t13 = cos_q3 * cos_q2;
    let t14 = sin_q3 * sin_q2;
    let t15 = u3 * u3;
    let l2 = p.l2;
    let t16 = l2 * t12;
    let t17 = t13 + t14;
    let t18 = cos_q1 * cos_q3;
    let t19 = sin_q1 * sin_q3;
    let t20 = u1 * u1;
    let t21 = cos_q1 * cos_q2;
    let t22 = sin_q1 * sin_q2;
    let l3 = p.l3;
    let t23 = l3 * t15;
    let t24 = t17 * t16;
    let t25 = t18 + t19;
    let l1 = p.l1;
    let t26 = l1 * t20;
    let t27 = t21 + t22;
    let t28 = t23 + t24;
    let t29 = t26 * t25;
    let k12 = p.k12;
    let t30 = t27 * k12;
    let t31 = t29 + t28;
    let k9 = p.k9;
    let t32 = t20 * k9;
    let k16 = p.k16;
    let t33 = k16 * t8;
    let t34 = 2.0_f64 * t30;
    let k6 = p.k6;
    let t35 = k6 * t31;
    let t36 = t7 * t32;
    let k11 = p.k11;
    let t37 = cos_q2 * k11;
    let t38 = t17 * t23;
    let t39 = t34 - t33;
    let t40 = t2 * t35;
    let t41 = t37 - t36;
    let t42 = t38 + t16;
    let t43 = t26 * t27;
    let k17 = p.k17;
    let t44 = k17 * t11;
    let t45 = t8 * t39;
    let t46 = k16 * t40;
    let m2 = p.m2;
    let t47 = m2 * t41;
    let t48 = t43 + t42;
    let t49 = t11 * t44;
    let k15 = p.k15;
    let t50 = k15 - t45;
    let t51 = t46 - t47;
    let t52 = k9 * t12;
    let k7 = p.k7;
    let t53 = k7 * t48;
    let mass_u1_u1 = t49 + t50;
    let t54 = l3 * t1;
    let t55 = t8 * t51;
    let k8 = p.k8;
    let t56 = cos_q1 * k8;
    let t57 = t30 * t40;
    let t58 = t7 * t52;
    let k10 = p.k10;
    let t59 = cos_q1 * k10;
    let u3_dot_bias = t2 * t53;
    let t60 = Real::abs(mass_u1_u1);
    let t61 = Real::abs(t54);
    let t62 = l2 * t1;
    let t63 = t56 + t55;
    let T = inputs[0];
    let t64 = T + t57;
    let t65 = t59 + t58;
    let t66 = k17 * u3_dot_bias;
    let k14 = p.k14;
    let t67 = cos_q3 * k14;
    let t68 = Real::abs(t62);
    let t69 = t63 - t64;
    let t70 = m2 * t65;
    let t71 = t67 - t66;
    let t72 = t70 + t69;
    let forcing_u1 = t11 * t71 - t72;
    let t73 = forcing_u1 / mass_u1_u1;
    let k23 = p.k23;
    let k22 = p.k22;
    let k21 = p.k21;
    let t74 = Real::min(Real::min(t60 * k23, t61 * k22), t68 * k21);
    ([u1, -t10, u3], [t73], t74)
}
///Kinetic and potential energy (J).
///
///50 operations.
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
    u: &[S; 1usize],
    _inputs: &[S; 1usize],
    p: &Prepared,
) -> (S, S) {
    let q1 = q[0];
    let q3 = q[2];
    let [(sin_q1, cos_q1), (sin_q3, cos_q3)] = Real::sin_cos_of_two(q1, q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = 1.0_f64 / (cos_q3 * sin_q2 - sin_q3 * cos_q2);
    let t2 = sin_q1 * cos_q3;
    let t3 = cos_q1 * sin_q3;
    let t4 = sin_q1 * cos_q2;
    let t5 = cos_q1 * sin_q2;
    let t6 = t2 - t3;
    let t7 = t4 - t5;
    let k19 = p.k19;
    let t8 = t6 * k19;
    let k20 = p.k20;
    let t9 = t7 * k20;
    let t10 = t1 * t8;
    let t11 = t1 * t9;
    let u1 = u[0];
    let t12 = u1 * t10;
    let u3 = u1 * t11;
    let t13 = t12 * t12;
    let t14 = u3 * u3;
    let k10 = p.k10;
    let t15 = sin_q1 * k10;
    let k13 = p.k13;
    let t16 = sin_q3 * k13;
    let k16 = p.k16;
    let t17 = k16 * t13;
    let k17 = p.k17;
    let t18 = k17 * t14;
    let t19 = u1 * u1;
    let t20 = cos_q1 * cos_q2;
    let t21 = sin_q1 * sin_q2;
    let t22 = t15 + t16;
    let k18 = p.k18;
    let t23 = sin_q2 * k18;
    let t24 = t17 + t18;
    let k15 = p.k15;
    let t25 = t19 * k15;
    let t26 = t20 + t21;
    let k11 = p.k11;
    let t27 = sin_q2 * k11;
    let t28 = t23 + t22;
    let t29 = t25 + t24;
    let t30 = u1 * t12;
    let k12 = p.k12;
    let t31 = t26 * k12;
    let t32 = t15 + t27;
    let m3 = p.m3;
    let t33 = m3 * t28;
    let k8 = p.k8;
    let t34 = sin_q1 * k8;
    let t35 = 0.5_f64 * t29;
    let t36 = t31 * t30;
    let m2 = p.m2;
    let t37 = m2 * t32;
    let t38 = t34 + t33;
    let t39 = t35 - t36;
    let t40 = t37 + t38;
    (t39, t40)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///22 operations.
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
    u: &[S; 1usize],
    _inputs: &[S; 1usize],
    p: &Prepared,
) -> [S; 3usize] {
    let q1 = q[0];
    let q3 = q[2];
    let [(sin_q1, cos_q1), (sin_q3, cos_q3)] = Real::sin_cos_of_two(q1, q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = 1.0_f64 / (cos_q3 * sin_q2 - sin_q3 * cos_q2);
    let t2 = sin_q1 * cos_q3;
    let t3 = cos_q1 * sin_q3;
    let t4 = sin_q1 * cos_q2;
    let t5 = cos_q1 * sin_q2;
    let t6 = t2 - t3;
    let t7 = t4 - t5;
    let k19 = p.k19;
    let t8 = t6 * k19;
    let k20 = p.k20;
    let t9 = t7 * k20;
    let t10 = t1 * t8;
    let t11 = t1 * t9;
    let u1 = u[0];
    let t12 = u1 * t10;
    let u3 = u1 * t11;
    [u1, -t12, u3]
}
///Requested outputs in the order of `OUTPUT_NAMES`.
///
///0 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn outputs(
    _t: S,
    _q: &[S; 3usize],
    _u: &[S; 1usize],
    _inputs: &[S; 1usize],
    _p: &Prepared,
) -> [S; 0usize] {
    []
}
///Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them.
///
///49 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn projection(
    _t: S,
    q: &[S; 3usize],
    _u: &[S; 1usize],
    _inputs: &[S; 1usize],
    p: &Prepared,
) -> ([S; 2usize], S) {
    let q1 = q[0];
    let q3 = q[2];
    let [(sin_q1, cos_q1), (sin_q3, cos_q3)] = Real::sin_cos_of_two(q1, q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let l1 = p.l1;
    let t1 = l1 * cos_q1;
    let l3 = p.l3;
    let t2 = l3 * cos_q3;
    let l2 = p.l2;
    let t3 = l2 * cos_q2;
    let t4 = l2 * sin_q2;
    let t5 = l3 * sin_q3;
    let t6 = cos_q1 * cos_q3;
    let t7 = sin_q1 * sin_q3;
    let t8 = t1 + t2;
    let l4 = p.l4;
    let t9 = t3 - l4;
    let t10 = t4 + t5;
    let t11 = l1 * sin_q1;
    let t12 = t6 + t7;
    let t13 = cos_q3 * cos_q2;
    let t14 = sin_q3 * sin_q2;
    let t15 = t8 + t9;
    let t16 = t11 + t10;
    let t17 = cos_q3 * sin_q2;
    let t18 = sin_q3 * cos_q2;
    let t19 = l1 * t12;
    let t20 = l4 * cos_q3;
    let t21 = t13 + t14;
    let t22 = cos_q1 * cos_q2;
    let t23 = sin_q1 * sin_q2;
    let t24 = l4 * cos_q2;
    let t25 = Real::abs(t15);
    let t26 = Real::abs(t16);
    let t27 = t17 - t18;
    let t28 = t19 - t20;
    let t29 = t22 + t23;
    let t30 = l3 * t21;
    let t31 = l2 - t24;
    let t32 = 1.0_f64 / t27;
    let t33 = l3 + t28;
    let t34 = l2 * t21;
    let t35 = l1 * t29;
    let t36 = t30 + t31;
    let t37 = t34 + t33;
    let t38 = t35 + t36;
    let k6 = p.k6;
    let t39 = k6 * t37;
    let k7 = p.k7;
    let t40 = k7 * t38;
    let t41 = t32 * t39;
    let t42 = t32 * t40;
    let t43 = Real::max(t25, t26);
    ([t41, -t42], t43)
}
///Four-bar linkage driven by a torque on the crank.
#[derive(Clone, Copy, Debug)]
pub struct Fourbar {
    parameters: Parameters,
    prepared: Prepared,
}
impl Default for Fourbar {
    fn default() -> Self {
        Self::new(Parameters::default())
    }
}
impl Fourbar {
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
                0usize => self.parameters.l1,
                1usize => self.parameters.l2,
                2usize => self.parameters.l3,
                3usize => self.parameters.l4,
                4usize => self.parameters.m1,
                5usize => self.parameters.m2,
                6usize => self.parameters.m3,
                7usize => self.parameters.I1,
                8usize => self.parameters.I2,
                9usize => self.parameters.I3,
                10usize => self.parameters.g,
                _ => return None,
            },
        )
    }
    /// Changes the parameter at a position of `PARAMETER_NAMES` and prepares anew; false beyond the last.
    pub fn set_parameter(&mut self, index: usize, value: S) -> bool {
        let place = match index {
            0usize => &mut self.parameters.l1,
            1usize => &mut self.parameters.l2,
            2usize => &mut self.parameters.l3,
            3usize => &mut self.parameters.l4,
            4usize => &mut self.parameters.m1,
            5usize => &mut self.parameters.m2,
            6usize => &mut self.parameters.m3,
            7usize => &mut self.parameters.I1,
            8usize => &mut self.parameters.I2,
            9usize => &mut self.parameters.I3,
            10usize => &mut self.parameters.g,
            _ => return false,
        };
        *place = value;
        self.prepared = prepare(&self.parameters);
        true
    }
}
impl smartbed_runtime::mechanism::Mechanism<S> for Fourbar {
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
