// Generated from models/pendulum3.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// pendulum3: 3 coordinates, 3 independent speeds, 0 inputs, 7 tunable parameters; scalar f32.
// Pivots: 8; the worst over 65 sampled configurations is 1.000 of its nominal size.
// Cost of rates: 54 operations (1 abs, 6 add, 3 cos, 1 div, 7 min, 28 mul, 3 sin, 5 sub).
// Cost of energy: 46 operations (12 add, 3 cos, 28 mul, 3 sin).
// Cost of speeds: 0 operations ().
// Cost of outputs: 0 operations ().
// Cost of projection: 0 operations ().
// Cost of prepare: 74 operations (15 abs, 6 add, 18 div, 8 max, 27 mul).

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f32;
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
pub const NOMINAL: [f32; 3usize] = [0f32, 0f32, 0f32];
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
            m0: 1.0_f32,
            m1: 1.0_f32,
            m2: 1.0_f32,
            l0: 1.0_f32,
            l1: 1.0_f32,
            l2: 1.0_f32,
            g: 9.81_f32,
        }
    }
}
/// Lowest and highest value of every tunable parameter, SI units.
pub const PARAMETER_RANGES: [[S; 2]; 7usize] = [
    [0.0_f32, S::INFINITY],
    [0.0_f32, S::INFINITY],
    [0.0_f32, S::INFINITY],
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
    let l0 = p.l0;
    let t1 = Real::abs(l0);
    let t2 = t1 * (1.0_f32 / Real::max(Real::abs(t1), 1e-24_f32));
    let l1 = p.l1;
    let t3 = Real::abs(l1);
    let t4 = t3 * (1.0_f32 / Real::max(Real::abs(t3), 1e-24_f32));
    let l2 = p.l2;
    let t5 = Real::abs(l2);
    let t6 = t5 * (1.0_f32 / Real::max(Real::abs(t5), 1e-24_f32));
    let t7 = l1 * l1;
    let m1 = p.m1;
    let m2 = p.m2;
    let t8 = m1 + m2;
    let mass_u1_u1 = t8 * t7;
    let t9 = t8 * (l0 * l1);
    let m0 = p.m0;
    let mass_u0_u0 = (m0 + t8) * (l0 * l0);
    let t10 = Real::abs(m2);
    let t11 = t10 * (1.0_f32 / Real::max(Real::abs(t10), 1e-24_f32));
    let t12 = 1.0_f32 / t10;
    let t13 = Real::abs(m0);
    let t14 = t13 * (1.0_f32 / Real::max(Real::abs(t13), 1e-24_f32));
    let t15 = 1.0_f32 / t13;
    let t16 = Real::abs(m1);
    let t17 = t16 * (1.0_f32 / Real::max(Real::abs(t16), 1e-24_f32));
    let t18 = 1.0_f32 / t16;
    let t19 = t18 + t12;
    let t20 = t15 + t18;
    let t21 = 1.0_f32 / m2;
    let t22 = 1.0_f32 / m1;
    let t23 = t22 + t21;
    let t24 = 0.5_f32 / Real::max(0.5_f32 * Real::abs(t19), 1e-24_f32);
    let t25 = Real::abs(t23) * t24;
    let mass_u2_u2 = m2 * (l2 * l2);
    let t26 = m2 * (l1 * l2);
    let t27 = m2 * (l0 * l2);
    let t28 = 1.0_f32 / t23;
    let t29 = t22 * t28;
    let t30 = l2 * t28;
    let t31 = 1.0_f32 / l2;
    let g = p.g;
    let t32 = l2 * g;
    let t33 = 2.0_f32 / Real::max(0.5_f32 * Real::abs(t20), 1e-24_f32);
    let t34 = 1.0_f32 / l0;
    let t35 = 1.0_f32 / l1;
    let t36 = 1.0_f32 / m0;
    let t37 = t36 + t22;
    let t38 = l0 * g;
    let t39 = m0 * t38;
    let t40 = l1 * g;
    Prepared { m0, m1, m2, l0, l1, g, prepared_mass_u0_u0: mass_u0_u0, prepared_mass_u1_u1: mass_u1_u1, k8: t9, prepared_mass_u2_u2: mass_u2_u2, k10: t26, k11: t27, k12: t38, k13: t39, k14: t40, k15: t32, k16: t36, k17: t22, k18: t37, k19: t29, k20: t30, k21: t31, k22: t35, k23: t34, k24: t14, k25: t17, k26: t11, k27: t2, k28: t4, k29: t6, k30: t25, k31: t33 }
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
    let l0 = p.l0;
    let u0 = u[0];
    let t1 = l0 * (u0 * u0);
    let q0 = q[0];
    let (sin_q0, cos_q0) = Real::sin_cos(q0);
    let m0 = p.m0;
    let g = p.g;
    let t2 = m0 * (t1 + g * cos_q0);
    let q1 = q[1];
    let (sin_angle9, cos_angle9) = Real::sin_cos(q1 - q0);
    let k16 = p.k16;
    let t3 = k16 * cos_angle9;
    let t4 = t3 * t2;
    let q2 = q[2];
    let (sin_angle14, cos_angle14) = Real::sin_cos(q2 - q1);
    let k17 = p.k17;
    let t5 = k17 * cos_angle14;
    let u2 = u[2];
    let k20 = p.k20;
    let t6 = u2 * u2 * k20;
    let t7 = t5 * t6;
    let l1 = p.l1;
    let u1 = u[1];
    let t8 = t4 + (l1 * (u1 * u1) + t7);
    let t9 = cos_angle9 * t3;
    let k19 = p.k19;
    let t10 = cos_angle14 * k19;
    let k18 = p.k18;
    let t11 = k18 - (t9 + t5 * t10);
    let force_mass1_y = t8 / t11;
    let t12 = k16 * sin_angle9;
    let k23 = p.k23;
    let t13 = k23 * (t12 * force_mass1_y - g * sin_q0);
    let force_mass0_y = t2 + cos_angle9 * force_mass1_y;
    let t14 = t12 * force_mass0_y;
    let force_mass2_y = t6 + t10 * force_mass1_y;
    let t15 = k17 * sin_angle14;
    let k22 = p.k22;
    let t16 = k22 * (t14 - t15 * force_mass2_y);
    let k21 = p.k21;
    let t17 = k21 * (t15 * force_mass1_y);
    let k31 = p.k31;
    let k30 = p.k30;
    let k29 = p.k29;
    let k28 = p.k28;
    let k27 = p.k27;
    let k26 = p.k26;
    let k25 = p.k25;
    let k24 = p.k24;
    let t18 = Real::min(Real::min(Real::min(Real::min(Real::min(Real::min(Real::min(Real::abs(t11) * k31, k30), k29), k28), k27), k26), k25), k24);
    ([u0, u1, u2], [t13, -t16, -t17], t18)
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
    let (sin_q0, cos_q0) = Real::sin_cos(q0);
    let q2 = q[2];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let k11 = p.k11;
    let mass_u0_u2 = (cos_q0 * cos_q2 + sin_q0 * sin_q2) * k11;
    let u0 = u[0];
    let u2 = u[2];
    let t1 = mass_u0_u2 * (u0 * u2);
    let q1 = q[1];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let k10 = p.k10;
    let mass_u1_u2 = (cos_q1 * cos_q2 + sin_q1 * sin_q2) * k10;
    let u1 = u[1];
    let t2 = t1 + mass_u1_u2 * (u1 * u2);
    let k8 = p.k8;
    let mass_u0_u1 = (cos_q0 * cos_q1 + sin_q0 * sin_q1) * k8;
    let t3 = mass_u0_u1 * (u0 * u1) + t2;
    let prepared_mass_u1_u1 = p.prepared_mass_u1_u1;
    let prepared_mass_u2_u2 = p.prepared_mass_u2_u2;
    let t4 = u1 * u1 * prepared_mass_u1_u1 + u2 * u2 * prepared_mass_u2_u2;
    let prepared_mass_u0_u0 = p.prepared_mass_u0_u0;
    let t5 = 0.5_f32 * (u0 * u0 * prepared_mass_u0_u0 + t4) + t3;
    let k12 = p.k12;
    let k14 = p.k14;
    let t6 = cos_q0 * k12 + cos_q1 * k14;
    let m1 = p.m1;
    let t7 = m1 * t6;
    let k13 = p.k13;
    let m2 = p.m2;
    let k15 = p.k15;
    let t8 = cos_q0 * k13 + t7 + m2 * (t6 + cos_q2 * k15);
    (t5, -t8)
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
    ([], 0.0_f32)
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
