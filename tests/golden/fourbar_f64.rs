// Generated from models/fourbar.toml by smartbed-codegen 0.1.0; do not edit, change the model instead.
// fourbar: 3 coordinates, 1 independent speeds, 1 inputs, 11 tunable parameters; scalar f64.
// Pivots: 3; the worst over 66 sampled configurations is 0.463 of its nominal size.
// Cost of rates: 176 operations (3 abs, 32 add, 3 cos, 3 div, 2 min, 113 mul, 3 sin, 17 sub).
// Cost of energy: 107 operations (21 add, 3 cos, 2 div, 73 mul, 3 sin, 5 sub).
// Cost of speeds: 26 operations (3 cos, 2 div, 15 mul, 3 sin, 3 sub).
// Cost of outputs: 0 operations ().
// Cost of projection: 50 operations (2 abs, 10 add, 3 cos, 2 div, 1 max, 24 mul, 3 sin, 5 sub).

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
///Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal.
///
///176 operations.
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
    p: &Parameters,
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
    let m3 = p.m3;
    let t14 = 0.5_f64 * l3;
    let t15 = m3 * t14;
    let t16 = cos_q3 * t15;
    let t17 = l2 * sin_q2;
    let t18 = sin_q3 * t15;
    let t19 = t13 * t16 + t17 * t18;
    let t20 = t19 * t4 - (t6 * t16 + t7 * t18);
    let t21 = cos_q2 * cos_q3 + sin_q2 * sin_q3;
    let t22 = t12 * t12;
    let t23 = l3 * t22;
    let t24 = l1 * (u1 * u1);
    let t25 = cos_q1 * cos_q2 + sin_q1 * sin_q2;
    let t26 = l2 * (t5 * t5);
    let u3_dot_bias = t10 * (t21 * t23 + (t24 * t25 + t26));
    let m2 = p.m2;
    let g = p.g;
    let t27 = 0.5_f64 * l2;
    let t28 = t27 * cos_q2;
    let t29 = t15 * t22;
    let t30 = cos_q1 * t24 + cos_q2 * t26;
    let t31 = cos_q3 * t29 + m3 * t30;
    let t32 = sin_q2 * t26 + (sin_q1 * t24 - g);
    let t33 = sin_q3 * t29 + m3 * t32;
    let t34 = m2 * (g * t28 - t24 * (sin_q1 * t28 - cos_q1 * (t27 * sin_q2))) + (t17 * t31 - t13 * t33);
    let t35 = m3 * t17;
    let t36 = m3 * t13;
    let I2 = p.I2;
    let t37 = t17 * t35 + t13 * t36 + (I2 + m2 * (t27 * t27));
    let t38 = t3 * (t23 + (t24 * (cos_q1 * cos_q3 + sin_q1 * sin_q3) + t21 * t26));
    let t39 = t7 * t35 + t6 * t36 + m2 * (t27 * (l1 * t25));
    let T = inputs[0];
    let m1 = p.m1;
    let t40 = 0.5_f64 * l1;
    let t41 = m1 * t40;
    let t42 = t41 * (g * cos_q1) - m2 * (t8 * (l2 * (t5 * (0.5_f64 * t5))) - g * t6);
    let t43 = t4 * (t34 - t37 * t38) + (t39 * t38 + (T - (t42 + (t7 * t31 - t6 * t33))));
    let I3 = p.I3;
    let t44 = I3 + t14 * t15;
    let t45 = t11 * (t19 * t38 + t15 * (cos_q3 * t32 - sin_q3 * t30) - t44 * u3_dot_bias);
    let forcing_u1 = t20 * u3_dot_bias + t43 - t45;
    let I1 = p.I1;
    let t46 = m2 * (l1 * l1) + (t40 * t41 + (t7 * (m3 * t7) + t6 * (m3 * t6)));
    let t47 = t46 + t4 * (t37 * t4 - 2.0_f64 * t39) + t11 * (2.0_f64 * t20 + t11 * t44);
    let mass_u1_u1 = I1 + t47;
    let t48 = forcing_u1 / mass_u1_u1;
    let t49 = Real::min(Real::min(0.6062967032112268_f64 * Real::abs(t2), 0.7410293039248327_f64 * Real::abs(t9)), 0.41205789559162753_f64 * Real::abs(mass_u1_u1));
    ([u1, -t5, -t12], [t48], t49)
}
///Kinetic and potential energy (J).
///
///107 operations.
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
    p: &Parameters,
) -> (S, S) {
    let l2 = p.l2;
    let q2 = q[1];
    let (sin_q2, cos_q2) = Real::sin_cos(q2);
    let t1 = l2 * sin_q2;
    let m3 = p.m3;
    let t2 = m3 * t1;
    let t3 = l2 * cos_q2;
    let t4 = m3 * t3;
    let I2 = p.I2;
    let m2 = p.m2;
    let t5 = 0.5_f64 * l2;
    let u1 = u[0];
    let l1 = p.l1;
    let q1 = q[0];
    let (sin_q1, cos_q1) = Real::sin_cos(q1);
    let q3 = q[2];
    let (sin_q3, cos_q3) = Real::sin_cos(q3);
    let t6 = sin_q2 * cos_q3 - cos_q2 * sin_q3;
    let t7 = u1 * (l1 * (sin_q1 * cos_q3 - cos_q1 * sin_q3) * (1.0_f64 / (l2 * t6)));
    let t8 = (t1 * t2 + t3 * t4 + (I2 + m2 * (t5 * t5))) * (t7 * t7);
    let I1 = p.I1;
    let t9 = 0.5_f64 * l1;
    let m1 = p.m1;
    let t10 = l1 * sin_q1;
    let t11 = l1 * cos_q1;
    let t12 = m2 * (l1 * l1) + (t9 * (m1 * t9) + (t10 * (m3 * t10) + t11 * (m3 * t11)));
    let I3 = p.I3;
    let l3 = p.l3;
    let t13 = 0.5_f64 * l3;
    let t14 = m3 * t13;
    let t15 = u1 * ((sin_q2 * t11 - cos_q2 * t10) * (1.0_f64 / (l3 * t6)));
    let t16 = t8 + u1 * u1 * (I1 + t12) + (I3 + t13 * t14) * (t15 * t15);
    let t17 = cos_q3 * t14;
    let t18 = sin_q3 * t14;
    let t19 = t10 * t2 + t11 * t4 + m2 * (t5 * (l1 * (cos_q1 * cos_q2 + sin_q1 * sin_q2)));
    let t20 = (t11 * t17 + t10 * t18) * (u1 * t15) + t19 * (u1 * t7) - (t3 * t17 + t1 * t18) * (t7 * t15);
    let t21 = 0.5_f64 * t16 - t20;
    let g = p.g;
    let t22 = g * sin_q1;
    let t23 = l1 * t22;
    let t24 = g * sin_q2;
    let t25 = m1 * (t9 * t22) + m2 * (t23 + t5 * t24) + m3 * (t23 + l2 * t24 + t13 * (g * sin_q3));
    (t21, t25)
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
    p: &Parameters,
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
    _p: &Parameters,
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
    p: &Parameters,
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
#[derive(Clone, Copy, Debug, Default)]
pub struct Fourbar {
    /// Tunable parameters.
    pub parameters: Parameters,
}
impl Fourbar {
    /// The parameter at a position of `PARAMETER_NAMES`, to read or set.
    pub fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
        Some(
            match index {
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
                _ => return None,
            },
        )
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
