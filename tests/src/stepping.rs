//! Runs of a subject under a law, stepped by the product's integrators.

use crate::subject::{State, Subject, arrange};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::ode::dormand_prince::{self, DormandPrince};
use smartbed_runtime::ode::state;
use smartbed_runtime::ode::step_size::Tolerance;
use smartbed_runtime::ode::{rk4, runge_kutta};
use smartbed_runtime::real::Scalar;

/// A control law: `law(t, q, u, inputs)` writes all inputs.
pub type Law<'a, S> = &'a dyn Fn(S, &[S], &[S], &mut [S]);

/// A subject under its law.
struct Steered<'a, S> {
    subject: &'a mut dyn Subject<S>,
    law: Law<'a, S>,
    inputs: Vec<S>,
    n_q: usize,
    n_u: usize,
}

impl<S: Scalar> Ode<S> for Steered<'_, S> {
    fn n_x(&self) -> usize {
        self.n_q + self.n_u
    }
    fn n_q(&self) -> usize {
        self.n_q
    }
    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        let (q, u) = x.split_at(self.n_q);
        let (q_dot, u_dot) = x_dot.split_at_mut(self.n_q);
        (self.law)(t, q, u, &mut self.inputs);
        self.subject.rates(t, q, u, &self.inputs, q_dot, u_dot)
    }
    fn set_time(&mut self, t: S) {
        self.subject.set_time(t);
    }
    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let (q, u) = x.split_at_mut(self.n_q);
        let residual = self.subject.project(q)?;
        self.subject.project_speeds(q, u)?;
        Ok(residual)
    }
    fn projections(&self) -> u8 {
        1
    }
}

/// A run in progress.
pub struct Run<'a, S> {
    system: Steered<'a, S>,
    x: Vec<S>,
    low: Vec<S>,
    scratch: Vec<S>,
    steps: u64,
    /// Largest residual that a projection found, as the mechanism measures it.
    pub before_projection: f64,
}

impl<'a, S: Scalar> Run<'a, S> {
    /// Starts at t = 0 from a state given by names.
    pub fn new(subject: &'a mut dyn Subject<S>, start: &State, law: Law<'a, S>) -> Self {
        let names = subject.names();
        let mut x = arrange(&names.q, &start.q);
        x.extend(arrange::<S>(&names.u, &start.u));
        let (n_q, n_u) = (names.q.len(), names.u.len());
        let inputs = vec![S::ZERO; names.inputs.len()];
        let n_x = x.len();
        let longest = runge_kutta::rk4_scratch(n_x).max(dormand_prince::scratch(n_x));
        let system = Steered { subject, law, inputs, n_q, n_u };
        let (low, scratch) = (vec![S::ZERO; n_x], vec![S::ZERO; longest]);
        Self { system, x, low, scratch, steps: 0, before_projection: 0.0 }
    }

    /// One classical Runge-Kutta step of length `h`; the time is a multiple of `h`.
    ///
    /// # Panics
    /// If the step is refused.
    pub fn rk4(&mut self, h: f64) {
        let taken = self.try_rk4(h);
        taken.unwrap_or_else(|fault| panic!("step {}: {fault:?}", self.steps));
    }

    /// As `rk4`, but returns a refusal instead of panicking.
    ///
    /// # Errors
    /// The fault of the refused step.
    pub fn try_rk4(&mut self, h: f64) -> Result<(), Fault> {
        let mut state = state::State::resume(&mut self.x, &mut self.low)?;
        let t = S::from_f64(self.steps as f64 * h);
        let report = rk4(&mut self.system, t, S::from_f64(h), &mut state, &mut self.scratch)?;
        self.before_projection = self.before_projection.max(report.residual.to_f64());
        self.steps += 1;
        Ok(())
    }

    /// Coordinates and speeds, and their rounding errors: everything that a step may change.
    #[must_use]
    pub fn state(&self) -> [&[S]; 2] {
        [&self.x, &self.low]
    }

    /// Visits the states at given times with Dormand and Prince's method of fifth order.
    ///
    /// # Panics
    /// If the method gives up.
    pub fn dormand_prince(&mut self, tolerance: f64, times: &[f64], mut visit: impl FnMut(&[S])) {
        let tolerance = Tolerance { absolute: S::from_f64(tolerance), relative: S::from_f64(tolerance) };
        let first = S::from_f64(1e-3);
        let mut method = DormandPrince::new(self.x.len(), tolerance, first, &mut self.scratch)
            .expect("scratch is long enough");
        let mut state = state::State::resume(&mut self.x, &mut self.low).expect("same length");
        let mut t = S::ZERO;
        for &end in times {
            let end = S::from_f64(end);
            method
                .advance_to(&mut self.system, &mut t, end, 1_000_000, &mut state)
                .expect("the steps are taken");
            visit(state.x());
        }
    }

    /// Kinetic and potential energy (J).
    ///
    /// # Panics
    /// If the mechanism refuses its own state.
    pub fn energy(&mut self) -> [f64; 2] {
        let (q, u) = self.x.split_at(self.system.n_q);
        let (kinetic, potential) = self.system.subject.energy(q, u).expect("slices fit");
        [kinetic.to_f64(), potential.to_f64()]
    }

    /// Coordinates in f64, in the model's order.
    #[must_use]
    pub fn coordinates(&self) -> Vec<f64> {
        self.x[..self.system.n_q].iter().map(|x| x.to_f64()).collect()
    }
}

/// The servo law of the reference trajectory: a third of the weight, 900 N/m to a moving height, 20 N s/m.
#[must_use]
pub fn servo(weight: f64, t: f64, h: [f64; 3], h_dot: [f64; 3]) -> [f64; 3] {
    let wave = |amplitude: f64, frequency: f64, phase: f64| {
        0.12 + amplitude * (std::f64::consts::TAU * frequency * t + phase).sin()
    };
    follow(weight, [wave(0.05, 0.8, 0.0), wave(0.05, 0.8, 2.1), wave(0.03, 1.3, 4.2)], h, h_dot)
}

/// Stiffness of the servo (N/m).
pub const SERVO_STIFFNESS: f64 = 900.0;
/// Damping of the servo (N s/m).
pub const SERVO_DAMPING: f64 = 20.0;

/// Thrusts that pull the heights to commanded ones and carry the weight.
#[must_use]
pub fn follow(weight: f64, command: [f64; 3], h: [f64; 3], h_dot: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| weight / 3.0 + SERVO_STIFFNESS * (command[i] - h[i]) - SERVO_DAMPING * h_dot[i])
}
