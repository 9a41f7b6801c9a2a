//! Runs of a subject: the test's own fixed-step RK4 with one projection after every step, and the servo law.

use crate::subject::{Subject, arrange};
use smartbed_runtime::real::{Real, Scalar};

/// A run in progress.
pub struct Run<'a, S: Scalar> {
    /// The mechanism.
    pub subject: &'a mut dyn Subject<S>,
    /// Time [s].
    pub t: S,
    /// Coordinates.
    pub q: Vec<S>,
    /// Independent speeds.
    pub u: Vec<S>,
    /// Largest residual that a projection found (its own measure, before correcting).
    pub before_projection: f64,
}

/// Inputs at a time and state.
pub type Law<'a, S> = &'a dyn Fn(S, &[S], &[S]) -> Vec<S>;

impl<'a, S: Scalar> Run<'a, S> {
    /// Starts from a state given by names.
    pub fn new(subject: &'a mut dyn Subject<S>, state: &crate::subject::State) -> Self {
        let names = subject.names();
        let (q, u) = (arrange(&names.q, &state.q), arrange(&names.u, &state.u));
        Self { subject, t: S::ZERO, q, u, before_projection: 0.0 }
    }

    /// Slopes of q and u.
    fn slopes(&mut self, t: S, q: &[S], u: &[S], law: Law<S>) -> (Vec<S>, Vec<S>) {
        let (mut q_dot, mut u_dot) = (vec![S::ZERO; q.len()], vec![S::ZERO; u.len()]);
        let inputs = law(t, q, u);
        self.subject.rates(t, q, u, &inputs, &mut q_dot, &mut u_dot).expect("slices fit");
        (q_dot, u_dot)
    }

    /// One classical Runge-Kutta step and one projection.
    pub fn rk4(&mut self, h: S, law: Law<S>) {
        let half = S::from_f64(0.5) * h;
        let (t, q, u) = (self.t, self.q.clone(), self.u.clone());
        let k1 = self.slopes(t, &q, &u, law);
        let k2 = self.slopes(t + half, &moved(&q, half, &k1.0), &moved(&u, half, &k1.1), law);
        let k3 = self.slopes(t + half, &moved(&q, half, &k2.0), &moved(&u, half, &k2.1), law);
        let k4 = self.slopes(t + h, &moved(&q, h, &k3.0), &moved(&u, h, &k3.1), law);
        let sixth = h / S::from_f64(6.0);
        let two = S::from_f64(2.0);
        let combine = |x: &[S], k: [&[S]; 4]| -> Vec<S> {
            (0..x.len()).map(|i| x[i] + sixth * (k[0][i] + two * (k[1][i] + k[2][i]) + k[3][i])).collect()
        };
        self.q = combine(&q, [&k1.0, &k2.0, &k3.0, &k4.0]);
        self.u = combine(&u, [&k1.1, &k2.1, &k3.1, &k4.1]);
        self.t = t + h;
        let residual = self.subject.project(&mut self.q).expect("slices fit").to_f64();
        self.before_projection = self.before_projection.max(residual.abs());
    }

    /// Kinetic plus potential energy [J].
    pub fn energy(&mut self) -> f64 {
        let (kinetic, potential) = self.subject.energy(&self.q, &self.u).expect("slices fit");
        kinetic.to_f64() + potential.to_f64()
    }

    /// Coordinates in f64.
    #[must_use]
    pub fn coordinates(&self) -> Vec<f64> {
        self.q.iter().map(|x| x.to_f64()).collect()
    }
}

/// x + h k.
fn moved<S: Real>(x: &[S], h: S, k: &[S]) -> Vec<S> {
    x.iter().zip(k).map(|(&x, &k)| x + h * k).collect()
}

/// The servo law of the reference trajectory: a third of the weight, 900 N/m to a moving height, 20 N s/m.
pub fn servo(weight: f64, t: f64, h: [f64; 3], h_dot: [f64; 3]) -> [f64; 3] {
    let wave = |amplitude: f64, frequency: f64, phase: f64| {
        0.12 + amplitude * (std::f64::consts::TAU * frequency * t + phase).sin()
    };
    let command = [wave(0.05, 0.8, 0.0), wave(0.05, 0.8, 2.1), wave(0.03, 1.3, 4.2)];
    [0, 1, 2].map(|i| weight / 3.0 + 900.0 * (command[i] - h[i]) - 20.0 * h_dot[i])
}
