// Generated from models/pendulum3.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// pendulum3: 3 coordinates, 3 independent speeds, 0 inputs, 7 tunable parameters; scalar f64.
// Pivots: 3; the worst over 65 sampled configurations is 1.000 of its nominal size.
// Cost of rates: 132 operations (3 abs, 24 add, 3 cos, 3 div, 2 min, 83 mul, 3 sin, 11 sub).
// Cost of energy: 79 operations (19 add, 3 cos, 54 mul, 3 sin).
// Cost of speeds: 0 operations ().
// Cost of outputs: 0 operations ().
// Cost of projection: 0 operations ().

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
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///132 operations.
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
    p: &Parameters,
) -> ([S; 3usize], [S; 3usize], S) {
    let u0 = u[0];
    let u1 = u[1];
    let u2 = u[2];
    let l0 = p.l0;
    let q0 = q[0];
    let (sin_q0, cos_q0) = Real::sin_cos(q0);
    let t1 = l0 * sin_q0;
    let q2 = q[2];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let m2 = p.m2;
    let l2 = p.l2;
    let t2 = m2 * l2;
    let t3 = sin_q2 * t2;
    let t4 = l0 * cos_q0;
    let t5 = cos_q2 * t2;
    let mass_u0_u2 = t1 * t3 + t4 * t5;
    let m0 = p.m0;
    let t6 = m0 * l0;
    let m1 = p.m1;
    let mass_u0_u0 = t4 * (m2 * t4) + t1 * (m2 * t1) + (l0 * t6 + m1 * (l0 * l0));
    let t7 = 1.0_f64 / mass_u0_u0;
    let t8 = mass_u0_u2 * t7;
    let l1 = p.l1;
    let q1 = q[1];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let t9 = l1 * cos_q1;
    let t10 = m2 * t9;
    let t11 = l1 * sin_q1;
    let t12 = m2 * t11;
    let mass_u1_u1 = m1 * (l1 * l1) + (t9 * t10 + t11 * t12);
    let mass_u0_u1 = m1 * (l1 * (cos_q1 * t4 + sin_q1 * t1)) + (t4 * t10 + t1 * t12);
    let t13 = mass_u0_u1 * t7;
    let pivot_1 = mass_u1_u1 - mass_u0_u1 * t13;
    let t14 = 1.0_f64 / pivot_1;
    let mass_u1_u2 = t11 * t3 + t9 * t5;
    let t15 = mass_u0_u2 * t13 - mass_u1_u2;
    let t16 = t14 * t15;
    let t17 = l0 * (u0 * u0);
    let t18 = l1 * (u1 * u1);
    let t19 = sin_q0 * t17 + sin_q1 * t18;
    let t20 = u2 * u2 * t2;
    let t21 = m2 * t19 + sin_q2 * t20;
    let g = p.g;
    let t22 = g + cos_q0 * t17 + cos_q1 * t18;
    let t23 = m2 * t22 + cos_q2 * t20;
    let forcing_u1 = t9 * t21 - t11 * t23 - m1 * (g * t11 + t17 * (cos_q0 * t11 - sin_q0 * t9));
    let t24 = t6 * (g * sin_q0) + m1 * (g * t1 + t18 * (cos_q1 * t1 - sin_q1 * t4));
    let t25 = t1 * t23 - t4 * t21 + t24;
    let t26 = forcing_u1 + t13 * t25;
    let mass_u2_u2 = l2 * t2;
    let t27 = t15 * t16 + (mass_u0_u2 * t8 - mass_u2_u2);
    let t28 = (t16 * t26 + (t8 * t25 + t2 * (cos_q2 * t19 - sin_q2 * t22))) / t27;
    let t29 = t14 * t26 - t16 * t28;
    let t30 = t8 * t28 - (t13 * t29 + t7 * t25);
    let t31 = Real::min(Real::min(0.3333333333333333_f64 * Real::abs(mass_u0_u0), 1.4999999999999998_f64 * Real::abs(pivot_1)), 2.0_f64 * Real::abs(t27));
    ([u0, u1, u2], [t30, t29, -t28], t31)
}
///Kinetic and potential energy (J).
///
///79 operations.
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
    p: &Parameters,
) -> (S, S) {
    let u2 = u[2];
    let l2 = p.l2;
    let m2 = p.m2;
    let t1 = m2 * l2;
    let mass_u2_u2 = l2 * t1;
    let u0 = u[0];
    let l0 = p.l0;
    let q0 = q[0];
    let (sin_q0, cos_q0) = Real::sin_cos(q0);
    let t2 = l0 * cos_q0;
    let t3 = l0 * sin_q0;
    let m0 = p.m0;
    let m1 = p.m1;
    let mass_u0_u0 = t2 * (m2 * t2) + t3 * (m2 * t3) + (l0 * (m0 * l0) + m1 * (l0 * l0));
    let u1 = u[1];
    let l1 = p.l1;
    let q1 = q[1];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let t4 = l1 * cos_q1;
    let t5 = m2 * t4;
    let t6 = l1 * sin_q1;
    let t7 = m2 * t6;
    let mass_u1_u1 = m1 * (l1 * l1) + (t4 * t5 + t6 * t7);
    let t8 = 0.5_f64 * (u2 * u2 * mass_u2_u2 + (u0 * u0 * mass_u0_u0 + u1 * u1 * mass_u1_u1));
    let q2 = q[2];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t9 = sin_q2 * t1;
    let t10 = cos_q2 * t1;
    let mass_u1_u2 = t6 * t9 + t4 * t10;
    let mass_u0_u1 = m1 * (l1 * (cos_q1 * t2 + sin_q1 * t3)) + (t2 * t5 + t3 * t7);
    let mass_u0_u2 = t3 * t9 + t2 * t10;
    let t11 = t8 + (mass_u1_u2 * (u1 * u2) + (mass_u0_u1 * (u0 * u1) + mass_u0_u2 * (u0 * u2)));
    let g = p.g;
    let t12 = l0 * (g * cos_q0);
    let t13 = t12 + l1 * (g * cos_q1);
    (t11, -(m0 * t12 + m1 * t13 + m2 * (t13 + l2 * (g * cos_q2))))
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
    _p: &Parameters,
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
    _p: &Parameters,
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
    _p: &Parameters,
) -> ([S; 0usize], S) {
    ([], 0.0_f64)
}
///Triple pendulum: point masses on massless rods, absolute angles from the downward vertical.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pendulum3 {
    /// Tunable parameters.
    pub parameters: Parameters,
}
impl Pendulum3 {
    /// The parameter at a position of `PARAMETER_NAMES`, to read or set.
    pub fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
        Some(
            match index {
                0usize => &mut self.parameters.m0,
                1usize => &mut self.parameters.m1,
                2usize => &mut self.parameters.m2,
                3usize => &mut self.parameters.l0,
                4usize => &mut self.parameters.l1,
                5usize => &mut self.parameters.l2,
                6usize => &mut self.parameters.g,
                _ => return None,
            },
        )
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
