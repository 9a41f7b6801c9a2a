// Generated from models/pendulum3.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// pendulum3: 3 coordinates, 3 independent speeds, 0 inputs, 7 tunable parameters; scalar f32.
// Pivots: 3; the worst over 65 sampled configurations is 1.000 of its nominal size.
// Cost of rates: 121 operations (3 abs, 23 add, 3 cos, 3 div, 2 min, 74 mul, 3 sin, 10 sub).
// Cost of energy: 69 operations (18 add, 3 cos, 45 mul, 3 sin).
// Cost of speeds: 0 operations ().
// Cost of outputs: 0 operations ().
// Cost of projection: 0 operations ().
// Cost of prepare: 11 operations (1 add, 10 mul).

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
    ///The parameter `g`.
    pub g: S,
    ///Of parameters alone.
    pub k6: S,
    ///Of parameters alone.
    pub prepared_mass_u2_u2: S,
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
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///11 operations.
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
    let g = p.g;
    let l2 = p.l2;
    let t1 = m2 * l2;
    let mass_u2_u2 = l2 * t1;
    let t2 = l0 * g;
    let t3 = l0 * l1;
    let t4 = l1 * g;
    let t5 = m1 * (l1 * l1);
    let t6 = l2 * g;
    let t7 = l0 * l0 * (m0 + m1);
    Prepared { m0, m1, m2, l0, l1, g, k6: t1, prepared_mass_u2_u2: mass_u2_u2, k8: t2, k9: t3, k10: t4, k11: t5, k12: t6, k13: t7 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///121 operations.
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
    let k6 = p.k6;
    let t2 = sin_q2 * k6;
    let t3 = l0 * cos_q0;
    let t4 = cos_q2 * k6;
    let mass_u0_u2 = t1 * t2 + t3 * t4;
    let m2 = p.m2;
    let k13 = p.k13;
    let mass_u0_u0 = t3 * (m2 * t3) + t1 * (m2 * t1) + k13;
    let t5 = 1.0_f32 / mass_u0_u0;
    let t6 = mass_u0_u2 * t5;
    let k11 = p.k11;
    let l1 = p.l1;
    let q1 = q[1];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let t7 = l1 * cos_q1;
    let t8 = m2 * t7;
    let t9 = l1 * sin_q1;
    let t10 = m2 * t9;
    let mass_u1_u1 = k11 + (t7 * t8 + t9 * t10);
    let m1 = p.m1;
    let k9 = p.k9;
    let mass_u0_u1 = m1 * ((cos_q0 * cos_q1 + sin_q0 * sin_q1) * k9) + (t3 * t8 + t1 * t10);
    let t11 = mass_u0_u1 * t5;
    let pivot_1 = mass_u1_u1 - mass_u0_u1 * t11;
    let t12 = 1.0_f32 / pivot_1;
    let mass_u1_u2 = t9 * t2 + t7 * t4;
    let t13 = mass_u0_u2 * t11 - mass_u1_u2;
    let t14 = t12 * t13;
    let g = p.g;
    let t15 = l0 * (u0 * u0);
    let t16 = l1 * (u1 * u1);
    let t17 = g + cos_q0 * t15 + cos_q1 * t16;
    let t18 = u2 * u2 * k6;
    let t19 = m2 * t17 + cos_q2 * t18;
    let t20 = sin_q0 * t15 + sin_q1 * t16;
    let t21 = m2 * t20 + sin_q2 * t18;
    let m0 = p.m0;
    let k8 = p.k8;
    let t22 = sin_q0 * k8;
    let t23 = sin_q0 * cos_q1 - cos_q0 * sin_q1;
    let t24 = t1 * t19 - t3 * t21 + (m0 * t22 + m1 * (t22 + t23 * (l0 * t16)));
    let k10 = p.k10;
    let forcing_u1 = t7 * t21 - t9 * t19 + m1 * (t23 * (l1 * t15) - sin_q1 * k10);
    let t25 = t11 * t24 + forcing_u1;
    let prepared_mass_u2_u2 = p.prepared_mass_u2_u2;
    let t26 = t13 * t14 + (mass_u0_u2 * t6 - prepared_mass_u2_u2);
    let t27 = (t14 * t25 + (t6 * t24 + k6 * (cos_q2 * t20 - sin_q2 * t17))) / t26;
    let t28 = t12 * t25 - t14 * t27;
    let t29 = t6 * t27 - (t11 * t28 + t5 * t24);
    let t30 = Real::min(Real::min(0.33333334_f32 * Real::abs(mass_u0_u0), 1.5_f32 * Real::abs(pivot_1)), 2.0_f32 * Real::abs(t26));
    ([u0, u1, u2], [t29, t28, -t27], t30)
}
///Kinetic and potential energy (J).
///
///69 operations.
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
    let l1 = p.l1;
    let q1 = q[1];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let t1 = l1 * sin_q1;
    let q2 = q[2];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let k6 = p.k6;
    let t2 = sin_q2 * k6;
    let t3 = l1 * cos_q1;
    let t4 = cos_q2 * k6;
    let mass_u1_u2 = t1 * t2 + t3 * t4;
    let u1 = u[1];
    let k11 = p.k11;
    let m2 = p.m2;
    let t5 = m2 * t3;
    let t6 = m2 * t1;
    let mass_u1_u1 = k11 + (t3 * t5 + t1 * t6);
    let l0 = p.l0;
    let q0 = q[0];
    let (sin_q0, cos_q0) = Real::sin_cos(q0);
    let t7 = l0 * sin_q0;
    let t8 = l0 * cos_q0;
    let mass_u0_u2 = t7 * t2 + t8 * t4;
    let u0 = u[0];
    let m1 = p.m1;
    let k9 = p.k9;
    let mass_u0_u1 = m1 * ((cos_q0 * cos_q1 + sin_q0 * sin_q1) * k9) + (t8 * t5 + t7 * t6);
    let k13 = p.k13;
    let mass_u0_u0 = t8 * (m2 * t8) + t7 * (m2 * t7) + k13;
    let t9 = mass_u0_u2 * (u0 * u2) + (mass_u0_u1 * (u0 * u1) + 0.5_f32 * (u0 * u0 * mass_u0_u0));
    let t10 = 0.5_f32 * (u2 * u2 * prepared_mass_u2_u2) + (mass_u1_u2 * (u1 * u2) + (0.5_f32 * (u1 * u1 * mass_u1_u1) + t9));
    let m0 = p.m0;
    let k8 = p.k8;
    let t11 = cos_q0 * k8;
    let k10 = p.k10;
    let t12 = t11 + cos_q1 * k10;
    let k12 = p.k12;
    (t10, -(m0 * t11 + m1 * t12 + m2 * (t12 + cos_q2 * k12)))
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
