// Generated from models/fourbar.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// fourbar: 3 coordinates, 1 independent speeds, 1 inputs, 11 tunable parameters; scalar f64.
// Pivots: 3; the worst over 66 sampled configurations is 0.463 of its nominal size.
// Cost of rates: 161 operations (3 abs, 28 add, 3 cos, 3 div, 2 min, 102 mul, 3 sin, 17 sub).
// Cost of energy: 92 operations (17 add, 3 cos, 2 div, 62 mul, 3 sin, 5 sub).
// Cost of speeds: 26 operations (3 cos, 2 div, 15 mul, 3 sin, 3 sub).
// Cost of outputs: 0 operations ().
// Cost of projection: 50 operations (2 abs, 10 add, 3 cos, 2 div, 1 max, 24 mul, 3 sin, 5 sub).
// Cost of prepare: 15 operations (4 add, 11 mul).

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
    ///The parameter `m1`.
    pub m1: S,
    ///The parameter `m2`.
    pub m2: S,
    ///The parameter `m3`.
    pub m3: S,
    ///The parameter `g`.
    pub g: S,
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
}
/// Computes what depends on parameters alone: once, and again when one of them changes.
///
///15 operations.
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = "generated straight-line arithmetic"
)]
#[must_use]
pub fn prepare(p: &Parameters) -> Prepared {
    let l1 = p.l1;
    let l2 = p.l2;
    let l3 = p.l3;
    let l4 = p.l4;
    let m1 = p.m1;
    let m2 = p.m2;
    let m3 = p.m3;
    let g = p.g;
    let t1 = 0.5_f64 * l1;
    let t2 = 0.5_f64 * l2;
    let t3 = 0.5_f64 * l3;
    let t4 = m1 * t1;
    let t5 = m3 * t3;
    let I2 = p.I2;
    let t6 = I2 + m2 * (t2 * t2);
    let I3 = p.I3;
    let t7 = I3 + t3 * t5;
    let I1 = p.I1;
    let t8 = m2 * (l1 * l1) + (I1 + t1 * t4);
    Prepared { l1, l2, l3, l4, m1, m2, m3, g, k8: t1, k9: t2, k10: t3, k11: t4, k12: t5, k13: t6, k14: t7, k15: t8 }
}
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///161 operations.
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
    let u1 = u[0];
    let l1 = p.l1;
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let l2 = p.l2;
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = sin_q2 * cos_q3 - cos_q2 * sin_q3;
    let t2 = l2 * t1;
    let t3 = 1.0_f64 / t2;
    let t4 = l1 * (sin_q1 * cos_q3 - cos_q1 * sin_q3) * t3;
    let t5 = u1 * t4;
    let t6 = l1 * cos_q1;
    let t7 = l1 * sin_q1;
    let t8 = sin_q2 * t6 - cos_q2 * t7;
    let l3 = p.l3;
    let t9 = l3 * t1;
    let t10 = 1.0_f64 / t9;
    let t11 = t8 * t10;
    let t12 = u1 * t11;
    let t13 = l2 * cos_q2;
    let k12 = p.k12;
    let t14 = cos_q3 * k12;
    let t15 = l2 * sin_q2;
    let t16 = sin_q3 * k12;
    let t17 = t13 * t14 + t15 * t16;
    let t18 = t17 * t4 - (t6 * t14 + t7 * t16);
    let t19 = cos_q2 * cos_q3 + sin_q2 * sin_q3;
    let t20 = t12 * t12;
    let t21 = l3 * t20;
    let t22 = l1 * (u1 * u1);
    let t23 = cos_q1 * cos_q2 + sin_q1 * sin_q2;
    let t24 = l2 * (t5 * t5);
    let u3_dot_bias = t10 * (t19 * t21 + (t22 * t23 + t24));
    let m2 = p.m2;
    let g = p.g;
    let k9 = p.k9;
    let t25 = k9 * cos_q2;
    let t26 = k12 * t20;
    let m3 = p.m3;
    let t27 = cos_q1 * t22 + cos_q2 * t24;
    let t28 = cos_q3 * t26 + m3 * t27;
    let t29 = sin_q2 * t24 + (sin_q1 * t22 - g);
    let t30 = sin_q3 * t26 + m3 * t29;
    let t31 = m2 * (g * t25 - t22 * (sin_q1 * t25 - cos_q1 * (k9 * sin_q2))) + (t15 * t28 - t13 * t30);
    let t32 = m3 * t15;
    let t33 = m3 * t13;
    let k13 = p.k13;
    let t34 = t15 * t32 + t13 * t33 + k13;
    let t35 = t3 * (t21 + (t22 * (cos_q1 * cos_q3 + sin_q1 * sin_q3) + t19 * t24));
    let t36 = t7 * t32 + t6 * t33 + m2 * (k9 * (l1 * t23));
    let T = inputs[0];
    let k11 = p.k11;
    let t37 = k11 * (g * cos_q1) - m2 * (t8 * (l2 * (t5 * (0.5_f64 * t5))) - g * t6);
    let t38 = t4 * (t31 - t34 * t35) + (t36 * t35 + (T - (t37 + (t7 * t28 - t6 * t30))));
    let k14 = p.k14;
    let t39 = t11 * (t17 * t35 + k12 * (cos_q3 * t29 - sin_q3 * t27) - k14 * u3_dot_bias);
    let forcing_u1 = t18 * u3_dot_bias + t38 - t39;
    let k15 = p.k15;
    let t40 = t4 * (t34 * t4 - 2.0_f64 * t36) + (t7 * (m3 * t7) + t6 * (m3 * t6) + k15);
    let mass_u1_u1 = t11 * (2.0_f64 * t18 + t11 * k14) + t40;
    let t41 = forcing_u1 / mass_u1_u1;
    let t42 = Real::min(Real::min(0.6062967032112268_f64 * Real::abs(t2), 0.7410293039248327_f64 * Real::abs(t9)), 0.41205789559162753_f64 * Real::abs(mass_u1_u1));
    ([u1, -t5, -t12], [t41], t42)
}
///Kinetic and potential energy (J).
///
///92 operations.
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
    let l2 = p.l2;
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = l2 * sin_q2;
    let m3 = p.m3;
    let t2 = m3 * t1;
    let t3 = l2 * cos_q2;
    let t4 = m3 * t3;
    let k13 = p.k13;
    let u1 = u[0];
    let l1 = p.l1;
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let t5 = sin_q2 * cos_q3 - cos_q2 * sin_q3;
    let t6 = u1 * (l1 * (sin_q1 * cos_q3 - cos_q1 * sin_q3) * (1.0_f64 / (l2 * t5)));
    let t7 = l1 * sin_q1;
    let t8 = l1 * cos_q1;
    let k15 = p.k15;
    let t9 = (t1 * t2 + t3 * t4 + k13) * (t6 * t6) + u1 * u1 * (t7 * (m3 * t7) + t8 * (m3 * t8) + k15);
    let k14 = p.k14;
    let l3 = p.l3;
    let t10 = u1 * ((sin_q2 * t8 - cos_q2 * t7) * (1.0_f64 / (l3 * t5)));
    let k12 = p.k12;
    let t11 = cos_q3 * k12;
    let t12 = sin_q3 * k12;
    let m2 = p.m2;
    let k9 = p.k9;
    let t13 = t7 * t2 + t8 * t4 + m2 * (k9 * (l1 * (cos_q1 * cos_q2 + sin_q1 * sin_q2)));
    let t14 = (t8 * t11 + t7 * t12) * (u1 * t10) + t13 * (u1 * t6) - (t3 * t11 + t1 * t12) * (t6 * t10);
    let t15 = 0.5_f64 * (t9 + k14 * (t10 * t10)) - t14;
    let m1 = p.m1;
    let k8 = p.k8;
    let g = p.g;
    let t16 = g * sin_q1;
    let t17 = l1 * t16;
    let t18 = g * sin_q2;
    let k10 = p.k10;
    let t19 = m1 * (k8 * t16) + m2 * (t17 + k9 * t18) + m3 * (t17 + l2 * t18 + k10 * (g * sin_q3));
    (t15, t19)
}
///All speeds in the order of `SPEED_NAMES`, dependent ones included.
///
///26 operations.
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
    let u1 = u[0];
    let l1 = p.l1;
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let l2 = p.l2;
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = sin_q2 * cos_q3 - cos_q2 * sin_q3;
    let l3 = p.l3;
    let t2 = u1 * ((sin_q2 * (l1 * cos_q1) - cos_q2 * (l1 * sin_q1)) * (1.0_f64 / (l3 * t1)));
    [u1, -u1 * (l1 * (sin_q1 * cos_q3 - cos_q1 * sin_q3) * (1.0_f64 / (l2 * t1))), -t2]
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
///50 operations.
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
    let l2 = p.l2;
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let t1 = sin_q2 * cos_q3 - cos_q2 * sin_q3;
    let l3 = p.l3;
    let t2 = cos_q2 * cos_q3 + sin_q2 * sin_q3;
    let l4 = p.l4;
    let l1 = p.l1;
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let t3 = l3 + (l2 * t2 - (l4 * cos_q3 - l1 * (cos_q1 * cos_q3 + sin_q1 * sin_q3)));
    let t4 = 1.0_f64 / (l2 * t1) * t3;
    let t5 = l2 + (l1 * (cos_q1 * cos_q2 + sin_q1 * sin_q2) - l4 * cos_q2) + l3 * t2;
    let t6 = Real::max(Real::abs(l1 * cos_q1 - l4 + l2 * cos_q2 + l3 * cos_q3), Real::abs(l1 * sin_q1 + l2 * sin_q2 + l3 * sin_q3));
    ([t4, -t5 * (1.0_f64 / (l3 * t1))], t6)
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
