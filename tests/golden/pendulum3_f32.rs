// Generated from models/pendulum3.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// pendulum3: 3 coordinates, 3 independent speeds, 0 inputs, 7 tunable parameters; scalar f32.
// Pivots: 3; the worst over 65 sampled configurations is 1.000 of its nominal size.
// Cost of rates: 123 operations (3 abs, 23 add, 3 cos, 3 div, 2 min, 75 mul, 3 sin, 11 sub).
// Cost of energy: 70 operations (18 add, 3 cos, 46 mul, 3 sin).
// Cost of speeds: 0 operations ().
// Cost of outputs: 0 operations ().
// Cost of projection: 0 operations ().
// Cost of prepare: 9 operations (1 add, 8 mul).

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
    ///The parameter `l2`.
    pub l2: S,
    ///The parameter `g`.
    pub g: S,
    ///Of parameters alone.
    pub k7: S,
    ///Of parameters alone.
    pub k8: S,
    ///Of parameters alone.
    pub prepared_mass_u2_u2: S,
    ///Of parameters alone.
    pub k10: S,
    ///Of parameters alone.
    pub k11: S,
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///9 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let m0 = p.m0;
    let m1 = p.m1;
    let m2 = p.m2;
    let l0 = p.l0;
    let l1 = p.l1;
    let l2 = p.l2;
    let g = p.g;
    let t1 = m0 * l0;
    let t2 = m2 * l2;
    let mass_u2_u2 = l2 * t2;
    let t3 = m1 * (l1 * l1);
    let t4 = l0 * t1 + m1 * (l0 * l0);
    Prepared { m0, m1, m2, l0, l1, l2, g, k7: t1, k8: t2, prepared_mass_u2_u2: mass_u2_u2, k10: t3, k11: t4 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///123 operations.
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
    let u0 = u[0];
    let u1 = u[1];
    let u2 = u[2];
    let l0 = p.l0;
    let q0 = q[0];
    let (sin_q0, cos_q0) = Real::sin_cos(q0);
    let t1 = l0 * sin_q0;
    let q2 = q[2];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let k8 = p.k8;
    let t2 = sin_q2 * k8;
    let t3 = l0 * cos_q0;
    let t4 = cos_q2 * k8;
    let mass_u0_u2 = t1 * t2 + t3 * t4;
    let m2 = p.m2;
    let k11 = p.k11;
    let mass_u0_u0 = t3 * (m2 * t3) + t1 * (m2 * t1) + k11;
    let t5 = 1.0_f32 / mass_u0_u0;
    let t6 = mass_u0_u2 * t5;
    let k10 = p.k10;
    let l1 = p.l1;
    let q1 = q[1];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let t7 = l1 * cos_q1;
    let t8 = m2 * t7;
    let t9 = l1 * sin_q1;
    let t10 = m2 * t9;
    let mass_u1_u1 = k10 + (t7 * t8 + t9 * t10);
    let m1 = p.m1;
    let mass_u0_u1 = m1 * (l1 * (cos_q1 * t3 + sin_q1 * t1)) + (t3 * t8 + t1 * t10);
    let t11 = mass_u0_u1 * t5;
    let pivot_1 = mass_u1_u1 - mass_u0_u1 * t11;
    let t12 = 1.0_f32 / pivot_1;
    let mass_u1_u2 = t9 * t2 + t7 * t4;
    let t13 = mass_u0_u2 * t11 - mass_u1_u2;
    let t14 = t12 * t13;
    let t15 = l0 * (u0 * u0);
    let t16 = l1 * (u1 * u1);
    let t17 = sin_q0 * t15 + sin_q1 * t16;
    let t18 = u2 * u2 * k8;
    let t19 = m2 * t17 + sin_q2 * t18;
    let g = p.g;
    let t20 = g + cos_q0 * t15 + cos_q1 * t16;
    let t21 = m2 * t20 + cos_q2 * t18;
    let forcing_u1 = t7 * t19 - t9 * t21 - m1 * (g * t9 + t15 * (cos_q0 * t9 - sin_q0 * t7));
    let k7 = p.k7;
    let t22 = k7 * (g * sin_q0) + m1 * (g * t1 + t16 * (cos_q1 * t1 - sin_q1 * t3));
    let t23 = t1 * t21 - t3 * t19 + t22;
    let t24 = forcing_u1 + t11 * t23;
    let prepared_mass_u2_u2 = p.prepared_mass_u2_u2;
    let t25 = t13 * t14 + (mass_u0_u2 * t6 - prepared_mass_u2_u2);
    let t26 = (t14 * t24 + (t6 * t23 + k8 * (cos_q2 * t17 - sin_q2 * t20))) / t25;
    let t27 = t12 * t24 - t14 * t26;
    let t28 = t6 * t26 - (t11 * t27 + t5 * t23);
    let t29 = Real::min(Real::min(0.33333334_f32 * Real::abs(mass_u0_u0), 1.5_f32 * Real::abs(pivot_1)), 2.0_f32 * Real::abs(t25));
    ([u0, u1, u2], [t28, t27, -t26], t29)
}
///Kinetic and potential energy (J).
///
///70 operations.
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
    let u2 = u[2];
    let prepared_mass_u2_u2 = p.prepared_mass_u2_u2;
    let u0 = u[0];
    let l0 = p.l0;
    let q0 = q[0];
    let (sin_q0, cos_q0) = Real::sin_cos(q0);
    let t1 = l0 * cos_q0;
    let m2 = p.m2;
    let t2 = l0 * sin_q0;
    let k11 = p.k11;
    let mass_u0_u0 = t1 * (m2 * t1) + t2 * (m2 * t2) + k11;
    let u1 = u[1];
    let k10 = p.k10;
    let l1 = p.l1;
    let q1 = q[1];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let t3 = l1 * cos_q1;
    let t4 = m2 * t3;
    let t5 = l1 * sin_q1;
    let t6 = m2 * t5;
    let mass_u1_u1 = k10 + (t3 * t4 + t5 * t6);
    let t7 = 0.5_f32 * (u2 * u2 * prepared_mass_u2_u2 + (u0 * u0 * mass_u0_u0 + u1 * u1 * mass_u1_u1));
    let q2 = q[2];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let k8 = p.k8;
    let t8 = sin_q2 * k8;
    let t9 = cos_q2 * k8;
    let mass_u1_u2 = t5 * t8 + t3 * t9;
    let m1 = p.m1;
    let mass_u0_u1 = m1 * (l1 * (cos_q1 * t1 + sin_q1 * t2)) + (t1 * t4 + t2 * t6);
    let mass_u0_u2 = t2 * t8 + t1 * t9;
    let t10 = t7 + (mass_u1_u2 * (u1 * u2) + (mass_u0_u1 * (u0 * u1) + mass_u0_u2 * (u0 * u2)));
    let m0 = p.m0;
    let g = p.g;
    let t11 = l0 * (g * cos_q0);
    let t12 = t11 + l1 * (g * cos_q1);
    let l2 = p.l2;
    (t10, -(m0 * t11 + m1 * t12 + m2 * (t12 + l2 * (g * cos_q2))))
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
