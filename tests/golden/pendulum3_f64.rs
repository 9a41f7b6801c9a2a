// Generated from models/pendulum3.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// pendulum3: 3 coordinates, 3 independent speeds, 0 inputs, 7 tunable parameters; scalar f64.
// Pivots: 8; the worst over 65 sampled configurations is 1.000 of its nominal size.
// Cost of rates: 54 operations (1 abs, 6 add, 3 cos, 1 div, 7 min, 28 mul, 3 sin, 5 sub).
// Cost of energy: 46 operations (12 add, 3 cos, 28 mul, 3 sin).
// Cost of speeds: 0 operations ().
// Cost of outputs: 0 operations ().
// Cost of projection: 0 operations ().
// Cost of prepare: 74 operations (15 abs, 6 add, 18 div, 8 max, 27 mul).

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f64;
/// Number of coordinates q.
pub const NQ: usize = 3usize;
/// Number of independent speeds u.
pub const NU: usize = 3usize;
/// Number of inputs.
pub const N_INPUTS: usize = 0usize;
///Coordinates in order.
pub const Q_NAMES: [&str; 3usize] = ["q0", "q1", "q2"];
///Independent speeds in order.
pub const U_NAMES: [&str; 3usize] = ["u0", "u1", "u2"];
///Inputs in order.
pub const INPUT_NAMES: [&str; 0usize] = [];
///Tunable parameters in order.
pub const PARAMETER_NAMES: [&str; 7usize] = ["m0", "m1", "m2", "l0", "l1", "l2", "g"];
///All speeds in order.
pub const SPEED_NAMES: [&str; 3usize] = ["u0", "u1", "u2"];
///Outputs in order.
pub const OUTPUT_NAMES: [&str; 0usize] = [];
/// Indices of the coordinates that the projection corrects.
pub const CORRECTED: [usize; 0usize] = [];
/// Coordinates read only by sines and cosines: they may be wrapped by whole turns.
pub const IS_ANGLE: [bool; 3usize] = [true, true, true];
/// The nominal configuration.
pub const NOMINAL: [f64; 3usize] = [0f64, 0f64, 0f64];
/// Tunable parameters, SI units.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(non_snake_case, reason = "names are the model's")]
pub struct Parameters {
    ///Upper mass (kg), models/pendulum3.toml:10.
    pub m0: S,
    ///Middle mass (kg), models/pendulum3.toml:11.
    pub m1: S,
    ///Lower mass (kg), models/pendulum3.toml:12.
    pub m2: S,
    ///Length of the upper rod (m), models/pendulum3.toml:13.
    pub l0: S,
    ///Length of the middle rod (m), models/pendulum3.toml:14.
    pub l1: S,
    ///Length of the lower rod (m), models/pendulum3.toml:15.
    pub l2: S,
    ///Gravity (m/s^2), models/pendulum3.toml:16.
    pub g: S,
}
impl Default for Parameters {
    fn default() -> Self {
        Self {
            m0: 1.0_f64,
            m1: 1.0_f64,
            m2: 1.0_f64,
            l0: 1.0_f64,
            l1: 1.0_f64,
            l2: 1.0_f64,
            g: 9.81_f64,
        }
    }
}
/// Lowest and highest value of every tunable parameter, SI units.
pub const PARAMETER_RANGES: [[S; 2]; 7usize] = [
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
            self.m0,
            self.m1,
            self.m2,
            self.l0,
            self.l1,
            self.l2,
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
    ///The parameter `m0`.
    pub m0: S,
    ///The parameter `m1`.
    pub m1: S,
    ///The parameter `m2`.
    pub m2: S,
    ///The parameter `l0`.
    pub l0: S,
    ///The parameter `l1`.
    pub l1: S,
    ///The parameter `g`.
    pub g: S,
    ///Of parameters alone.
    pub prepared_mass_u0_u0: S,
    ///Of parameters alone.
    pub prepared_mass_u1_u1: S,
    ///Of parameters alone.
    pub k8: S,
    ///Of parameters alone.
    pub prepared_mass_u2_u2: S,
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
    ///Of parameters alone.
    pub k29: S,
    ///Of parameters alone.
    pub k30: S,
    ///Of parameters alone.
    pub k31: S,
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///74 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let m1 = p.m1;
    let t1 = Real::abs(m1);
    let m2 = p.m2;
    let t2 = Real::abs(m2);
    let m0 = p.m0;
    let t3 = Real::abs(m0);
    let t4 = 1.0_f64 / t1;
    let t5 = 1.0_f64 / t2;
    let l0 = p.l0;
    let t6 = Real::abs(l0);
    let l1 = p.l1;
    let t7 = Real::abs(l1);
    let l2 = p.l2;
    let t8 = Real::abs(l2);
    let t9 = 1.0_f64 / t3;
    let t10 = Real::abs(t4 + t5);
    let t11 = t9 + t4;
    let t12 = 1.0_f64 / m1;
    let t13 = 1.0_f64 / m2;
    let t14 = Real::abs(t3);
    let t15 = Real::abs(t1);
    let t16 = Real::abs(t2);
    let t17 = Real::abs(t6);
    let t18 = Real::abs(t7);
    let t19 = Real::abs(t8);
    let t20 = Real::abs(t11);
    let t21 = t12 + t13;
    let t22 = 0.5_f64 * t10;
    let t23 = Real::abs(t21);
    let t24 = Real::max(t14, 1e-24_f64);
    let t25 = Real::max(t15, 1e-24_f64);
    let t26 = Real::max(t16, 1e-24_f64);
    let t27 = Real::max(t17, 1e-24_f64);
    let t28 = Real::max(t18, 1e-24_f64);
    let t29 = Real::max(t19, 1e-24_f64);
    let t30 = Real::max(t22, 1e-24_f64);
    let t31 = 0.5_f64 * t20;
    let t32 = 1.0_f64 / m0;
    let t33 = 1.0_f64 / t21;
    let t34 = 1.0_f64 / t24;
    let t35 = 1.0_f64 / t25;
    let t36 = 1.0_f64 / t26;
    let t37 = 1.0_f64 / t27;
    let t38 = 1.0_f64 / t28;
    let t39 = 1.0_f64 / t29;
    let t40 = 0.5_f64 / t30;
    let t41 = Real::max(t31, 1e-24_f64);
    let t42 = 1.0_f64 / l2;
    let t43 = 1.0_f64 / l1;
    let t44 = 1.0_f64 / l0;
    let t45 = 2.0_f64 / t41;
    let t46 = m1 + m2;
    let t47 = m0 + t46;
    let t48 = l0 * l0;
    let t49 = l1 * l1;
    let t50 = l0 * l1;
    let t51 = l2 * l2;
    let t52 = l1 * l2;
    let t53 = l0 * l2;
    let g = p.g;
    let t54 = l0 * g;
    let mass_u0_u0 = t47 * t48;
    let mass_u1_u1 = t46 * t49;
    let t55 = t46 * t50;
    let mass_u2_u2 = m2 * t51;
    let t56 = m2 * t52;
    let t57 = m2 * t53;
    let t58 = m0 * t54;
    let t59 = l1 * g;
    let t60 = l2 * g;
    let t61 = t32 + t12;
    let t62 = t12 * t33;
    let t63 = l2 * t33;
    let t64 = t3 * t34;
    let t65 = t1 * t35;
    let t66 = t2 * t36;
    let t67 = t6 * t37;
    let t68 = t7 * t38;
    let t69 = t8 * t39;
    let t70 = t23 * t40;
    Prepared { m0, m1, m2, l0, l1, g, prepared_mass_u0_u0: mass_u0_u0, prepared_mass_u1_u1: mass_u1_u1, k8: t55, prepared_mass_u2_u2: mass_u2_u2, k10: t56, k11: t57, k12: t54, k13: t58, k14: t59, k15: t60, k16: t32, k17: t12, k18: t61, k19: t62, k20: t63, k21: t42, k22: t43, k23: t44, k24: t64, k25: t65, k26: t66, k27: t67, k28: t68, k29: t69, k30: t70, k31: t45 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///54 operations.
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
    _inputs: &[S; 0usize],
    p: &Prepared,
) -> ([S; 3usize], [S; 3usize], S) {
    let q1 = q[1];
    let q0 = q[0];
    let t1 = q1 - q0;
    let q2 = q[2];
    let t2 = q2 - q1;
    let [(sin_q0, cos_q0), (sin_t1, cos_t1)] = Real::sin_cos_of_two(q0, t1);
    let (sin_t2, cos_t2) = Real::sin_cos(t2);
    let k16 = p.k16;
    let t3 = k16 * cos_t1;
    let k17 = p.k17;
    let t4 = k17 * cos_t2;
    let k19 = p.k19;
    let t5 = cos_t2 * k19;
    let t6 = cos_t1 * t3 + t4 * t5;
    let u0 = u[0];
    let t7 = u0 * u0;
    let k18 = p.k18;
    let t8 = k18 - t6;
    let l0 = p.l0;
    let t9 = l0 * t7;
    let g = p.g;
    let t10 = g * cos_q0;
    let u2 = u[2];
    let t11 = u2 * u2;
    let t12 = Real::abs(t8);
    let t13 = t9 + t10;
    let k20 = p.k20;
    let t14 = t11 * k20;
    let u1 = u[1];
    let t15 = u1 * u1;
    let m0 = p.m0;
    let t16 = m0 * t13;
    let t17 = t4 * t14;
    let l1 = p.l1;
    let t18 = l1 * t15;
    let t19 = t3 * t16;
    let force_mass1_y = (t19 + (t18 + t17)) / t8;
    let k31 = p.k31;
    let k30 = p.k30;
    let k29 = p.k29;
    let t20 = Real::min(Real::min(t12 * k31, k30), k29);
    let t21 = cos_t1 * force_mass1_y;
    let t22 = t5 * force_mass1_y;
    let k28 = p.k28;
    let t23 = Real::min(t20, k28);
    let t24 = k16 * sin_t1;
    let force_mass0_y = t16 + t21;
    let force_mass2_y = t14 + t22;
    let t25 = k17 * sin_t2;
    let k27 = p.k27;
    let t26 = Real::min(t23, k27);
    let t27 = t24 * force_mass1_y;
    let t28 = g * sin_q0;
    let t29 = t24 * force_mass0_y;
    let t30 = t25 * force_mass2_y;
    let k26 = p.k26;
    let t31 = Real::min(t26, k26);
    let t32 = t27 - t28;
    let t33 = t29 - t30;
    let t34 = t25 * force_mass1_y;
    let k25 = p.k25;
    let t35 = Real::min(t31, k25);
    let k23 = p.k23;
    let t36 = k23 * t32;
    let k22 = p.k22;
    let t37 = k22 * t33;
    let k21 = p.k21;
    let t38 = k21 * t34;
    let k24 = p.k24;
    let t39 = Real::min(t35, k24);
    ([u0, u1, u2], [t36, -t37, -t38], t39)
}
///Kinetic and potential energy (J).
///
///46 operations.
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
    _inputs: &[S; 0usize],
    p: &Prepared,
) -> (S, S) {
    let q0 = q[0];
    let q1 = q[1];
    let [(sin_q0, cos_q0), (sin_q1, cos_q1)] = Real::sin_cos_of_two(q0, q1);
    let q2 = q[2];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = cos_q0 * cos_q2;
    let t2 = sin_q0 * sin_q2;
    let t3 = cos_q1 * cos_q2;
    let t4 = sin_q1 * sin_q2;
    let t5 = cos_q0 * cos_q1;
    let t6 = sin_q0 * sin_q1;
    let t7 = t1 + t2;
    let t8 = t3 + t4;
    let u1 = u[1];
    let t9 = u1 * u1;
    let u2 = u[2];
    let t10 = u2 * u2;
    let t11 = t5 + t6;
    let k11 = p.k11;
    let mass_u0_u2 = t7 * k11;
    let u0 = u[0];
    let t12 = u0 * u2;
    let k10 = p.k10;
    let mass_u1_u2 = t8 * k10;
    let t13 = u1 * u2;
    let prepared_mass_u1_u1 = p.prepared_mass_u1_u1;
    let t14 = t9 * prepared_mass_u1_u1;
    let prepared_mass_u2_u2 = p.prepared_mass_u2_u2;
    let t15 = t10 * prepared_mass_u2_u2;
    let t16 = u0 * u0;
    let k12 = p.k12;
    let t17 = cos_q0 * k12;
    let k14 = p.k14;
    let t18 = cos_q1 * k14;
    let k8 = p.k8;
    let mass_u0_u1 = t11 * k8;
    let t19 = u0 * u1;
    let t20 = mass_u0_u2 * t12;
    let t21 = mass_u1_u2 * t13;
    let t22 = t14 + t15;
    let prepared_mass_u0_u0 = p.prepared_mass_u0_u0;
    let t23 = t16 * prepared_mass_u0_u0;
    let t24 = t17 + t18;
    let k15 = p.k15;
    let t25 = cos_q2 * k15;
    let t26 = mass_u0_u1 * t19;
    let t27 = t20 + t21;
    let t28 = t23 + t22;
    let m1 = p.m1;
    let t29 = m1 * t24;
    let k13 = p.k13;
    let t30 = cos_q0 * k13;
    let t31 = t24 + t25;
    let t32 = t26 + t27;
    let t33 = 0.5_f64 * t28;
    let t34 = t30 + t29;
    let m2 = p.m2;
    let t35 = m2 * t31;
    let t36 = t33 + t32;
    let t37 = t34 + t35;
    (t36, -t37)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///0 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn speeds(
    _t: S,
    _q: &[S; 3usize],
    u: &[S; 3usize],
    _inputs: &[S; 0usize],
    _p: &Prepared,
) -> [S; 3usize] {
    let u0 = u[0];
    let u1 = u[1];
    let u2 = u[2];
    [u0, u1, u2]
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
    _u: &[S; 3usize],
    _inputs: &[S; 0usize],
    _p: &Prepared,
) -> [S; 0usize] {
    []
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
    _inputs: &[S; 0usize],
    _p: &Prepared,
) -> ([S; 0usize], S) {
    ([], 0.0_f64)
}
///Triple pendulum: point masses on massless rods, absolute angles from the downward vertical.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum3 {
    parameters: Parameters,
    prepared: Prepared,
}
impl Default for Pendulum3 {
    fn default() -> Self {
        Self::new(Parameters::default())
    }
}
impl Pendulum3 {
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
                0usize => self.parameters.m0,
                1usize => self.parameters.m1,
                2usize => self.parameters.m2,
                3usize => self.parameters.l0,
                4usize => self.parameters.l1,
                5usize => self.parameters.l2,
                6usize => self.parameters.g,
                _ => return None,
            },
        )
    }
    /// Changes the parameter at a position of `PARAMETER_NAMES` and prepares anew; false beyond the last.
    pub fn set_parameter(&mut self, index: usize, value: S) -> bool {
        let place = match index {
            0usize => &mut self.parameters.m0,
            1usize => &mut self.parameters.m1,
            2usize => &mut self.parameters.m2,
            3usize => &mut self.parameters.l0,
            4usize => &mut self.parameters.l1,
            5usize => &mut self.parameters.l2,
            6usize => &mut self.parameters.g,
            _ => return false,
        };
        *place = value;
        self.prepared = prepare(&self.parameters);
        true
    }
}
impl smartbed_runtime::mechanism::Mechanism<S> for Pendulum3 {
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
