// Generated from models/fourbar.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// fourbar: 3 coordinates, 1 independent speed, 1 input, 11 tunable parameters; scalar f32.
// Pivots: 3; the worst over 66 sampled configurations is 0.463 of its nominal size.
// Cost of rates: 93 operations (3 abs, 12 add, 3 cos, 2 div, 2 min, 58 mul, 3 sin, 10 sub).
// Cost of energy: 50 operations (8 add, 3 cos, 1 div, 31 mul, 3 sin, 4 sub).
// Cost of speeds: 22 operations (3 cos, 1 div, 12 mul, 3 sin, 3 sub).
// Cost of outputs: 0 operations ().
// Cost of projection: 49 operations (2 abs, 11 add, 3 cos, 1 div, 1 max, 24 mul, 3 sin, 4 sub).
// Cost of prepare: 66 operations (11 abs, 8 add, 6 div, 3 max, 38 mul).

use smartbed_runtime::real::Real;
/// The scalar of this file.
pub type S = f32;
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
pub const NOMINAL: [f32; 3usize] = [1f32, 0.40591934f32, -1.8880527f32];
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
            l1: 1.0_f32,
            l2: 2.2_f32,
            l3: 1.8_f32,
            l4: 2.0_f32,
            m1: 1.1_f32,
            m2: 2.3_f32,
            m3: 1.7_f32,
            I1: 0.09_f32,
            I2: 0.9_f32,
            I3: 0.45_f32,
            g: 9.81_f32,
        }
    }
}
/// Lowest and highest value of every tunable parameter, SI units.
pub const PARAMETER_RANGES: [[S; 2]; 11usize] = [
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
    [S::NEG_INFINITY, S::INFINITY],
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
    let l2 = p.l2;
    let t1 = 1.0_f32 / l2;
    let l3 = p.l3;
    let t2 = 1.0_f32 / l3;
    let l1 = p.l1;
    let t3 = 0.5_f32 * l1;
    let m1 = p.m1;
    let g = p.g;
    let t4 = m1 * (g * t3);
    let t5 = 0.5_f32 * l2;
    let t6 = l1 * t5;
    let t7 = l1 * g;
    let t8 = g * t5;
    let m2 = p.m2;
    let t9 = m2 * t6;
    let t10 = 0.5_f32 * l3;
    let t11 = g * t10;
    let m3 = p.m3;
    let t12 = m3 * t11;
    let I1 = p.I1;
    let t13 = m2 * (l1 * l1) + (I1 + m1 * (t3 * t3));
    let I2 = p.I2;
    let t14 = I2 + m2 * (t5 * t5);
    let I3 = p.I3;
    let t15 = I3 + m3 * (t10 * t10);
    let t16 = l2 * g;
    let t17 = l1 * t1;
    let t18 = l1 * t2;
    let t19 = 0.6062967_f32 / Real::max(0.22727273_f32 * Real::abs(2.0_f32 * Real::abs(l2)), 1e-24_f32);
    let t20 = Real::abs(l3);
    let t21 = 0.7410293_f32 / Real::max(0.2777778_f32 * Real::abs(2.0_f32 * t20), 1e-24_f32);
    let t22 = Real::abs(m2);
    let t23 = Real::abs(l1);
    let t24 = t22 * (t23 * t23);
    let t25 = Real::abs(m1);
    let t26 = 0.5_f32 * t23;
    let t27 = t25 * (t26 * t26);
    let t28 = t24 + (Real::abs(I1) + t27);
    let t29 = Real::abs(m3);
    let t30 = 0.5_f32 * t20;
    let t31 = t29 * (t30 * t30);
    let t32 = Real::abs(I3) + t31;
    let t33 = t23 * (1.0_f32 / t20);
    let t34 = 0.4120579_f32 / Real::max(0.30970407_f32 * Real::abs(t28 + t33 * (t32 * t33)), 1e-24_f32);
    let l4 = p.l4;
    Prepared { l1, l2, l3, l4, m2, m3, k6: t1, k7: t2, k8: t4, k9: t6, k10: t7, k11: t8, k12: t9, k13: t11, k14: t12, k15: t13, k16: t14, k17: t15, k18: t16, k19: t17, k20: t18, k21: t19, k22: t21, k23: t34 }
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
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = cos_q3 * sin_q2 - sin_q3 * cos_q2;
    let t2 = 1.0_f32 / t1;
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let k19 = p.k19;
    let t3 = t2 * ((sin_q1 * cos_q3 - cos_q1 * sin_q3) * k19);
    let u1 = u[0];
    let t4 = u1 * t3;
    let t5 = sin_q1 * cos_q2 - cos_q1 * sin_q2;
    let k20 = p.k20;
    let t6 = t2 * (t5 * k20);
    let u3 = u1 * t6;
    let l3 = p.l3;
    let t7 = l3 * (u3 * u3);
    let t8 = t4 * t4;
    let l2 = p.l2;
    let t9 = l2 * t8;
    let t10 = cos_q3 * cos_q2 + sin_q3 * sin_q2;
    let t11 = t7 + t10 * t9;
    let t12 = cos_q1 * cos_q3 + sin_q1 * sin_q3;
    let t13 = u1 * u1;
    let l1 = p.l1;
    let t14 = l1 * t13;
    let k6 = p.k6;
    let t15 = t2 * (k6 * (t14 * t12 + t11));
    let k16 = p.k16;
    let t16 = k16 * t15;
    let k9 = p.k9;
    let t17 = t5 * (t13 * k9);
    let m2 = p.m2;
    let k11 = p.k11;
    let t18 = t3 * (t16 - m2 * (cos_q2 * k11 - t17));
    let k8 = p.k8;
    let t19 = cos_q1 * k8 + t18;
    let t20 = cos_q1 * cos_q2 + sin_q1 * sin_q2;
    let k12 = p.k12;
    let t21 = t20 * k12;
    let T = inputs[0];
    let t22 = t19 - (T + t21 * t15);
    let t23 = t5 * (k9 * t8);
    let k10 = p.k10;
    let t24 = m2 * (cos_q1 * k10 + t23) + t22;
    let t25 = t10 * t7 + t9;
    let k7 = p.k7;
    let u3_dot_bias = t2 * (k7 * (t14 * t20 + t25));
    let k17 = p.k17;
    let t26 = k17 * u3_dot_bias;
    let k14 = p.k14;
    let forcing_u1 = t6 * (cos_q3 * k14 - t26) - t24;
    let t27 = t6 * (k17 * t6);
    let t28 = k16 * t3;
    let k15 = p.k15;
    let mass_u1_u1 = t27 + (k15 - t3 * (2.0_f32 * t21 - t28));
    let t29 = forcing_u1 / mass_u1_u1;
    let k23 = p.k23;
    let k22 = p.k22;
    let k21 = p.k21;
    let t30 = Real::min(Real::min(Real::abs(mass_u1_u1) * k23, Real::abs(l3 * t1) * k22), Real::abs(l2 * t1) * k21);
    ([u1, -t4, u3], [t29], t30)
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
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = 1.0_f32 / (cos_q3 * sin_q2 - sin_q3 * cos_q2);
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let u1 = u[0];
    let k19 = p.k19;
    let t2 = u1 * (t1 * ((sin_q1 * cos_q3 - cos_q1 * sin_q3) * k19));
    let k16 = p.k16;
    let t3 = k16 * (t2 * t2);
    let k20 = p.k20;
    let u3 = u1 * (t1 * ((sin_q1 * cos_q2 - cos_q1 * sin_q2) * k20));
    let k17 = p.k17;
    let t4 = t3 + k17 * (u3 * u3);
    let k15 = p.k15;
    let t5 = 0.5_f32 * (u1 * u1 * k15 + t4);
    let t6 = u1 * t2;
    let k12 = p.k12;
    let t7 = t5 - (cos_q1 * cos_q2 + sin_q1 * sin_q2) * k12 * t6;
    let k10 = p.k10;
    let t8 = sin_q1 * k10;
    let m2 = p.m2;
    let k11 = p.k11;
    let t9 = m2 * (t8 + sin_q2 * k11);
    let k13 = p.k13;
    let t10 = t8 + sin_q3 * k13;
    let m3 = p.m3;
    let k18 = p.k18;
    let t11 = m3 * (sin_q2 * k18 + t10);
    let k8 = p.k8;
    let t12 = t9 + (sin_q1 * k8 + t11);
    (t7, t12)
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
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = 1.0_f32 / (cos_q3 * sin_q2 - sin_q3 * cos_q2);
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let u1 = u[0];
    let k19 = p.k19;
    let t2 = u1 * (t1 * ((sin_q1 * cos_q3 - cos_q1 * sin_q3) * k19));
    let k20 = p.k20;
    let u3 = u1 * (t1 * ((sin_q1 * cos_q2 - cos_q1 * sin_q2) * k20));
    [u1, -t2, u3]
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
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = cos_q3 * cos_q2 + sin_q3 * sin_q2;
    let l2 = p.l2;
    let t2 = l2 * t1;
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let k6 = p.k6;
    let l3 = p.l3;
    let l1 = p.l1;
    let l4 = p.l4;
    let t3 = k6 * (t2 + (l3 + (l1 * (cos_q1 * cos_q3 + sin_q1 * sin_q3) - l4 * cos_q3)));
    let t4 = 1.0_f32 / (cos_q3 * sin_q2 - sin_q3 * cos_q2);
    let t5 = t4 * t3;
    let t6 = l1 * (cos_q1 * cos_q2 + sin_q1 * sin_q2) + (l3 * t1 + (l2 - l4 * cos_q2));
    let k7 = p.k7;
    let t7 = t4 * (k7 * t6);
    let t8 = Real::abs(l1 * cos_q1 + l3 * cos_q3 + (l2 * cos_q2 - l4));
    let t9 = l2 * sin_q2 + l3 * sin_q3;
    let t10 = Real::max(t8, Real::abs(l1 * sin_q1 + t9));
    ([t5, -t7], t10)
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
