//! Small systems with known solutions.

use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::real::{Real, Scalar};

/// A system given by a function: (t, x, x_dot) -> pivot.
pub struct Flow<F> {
    pub n: usize,
    pub n_q: usize,
    pub f: F,
}

impl<S: Scalar, F: FnMut(S, &[S], &mut [S]) -> Result<S, Fault>> Ode<S> for Flow<F> {
    fn n_x(&self) -> usize {
        self.n
    }
    fn n_q(&self) -> usize {
        self.n_q
    }
    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        if x.len() != self.n || x_dot.len() != self.n {
            return Err(Fault::Shape);
        }
        (self.f)(t, x, x_dot)
    }
}

/// q'' = -sin q.
pub fn pendulum() -> impl Ode<f64> {
    let f = |_, x: &[f64], x_dot: &mut [f64]| {
        x_dot.copy_from_slice(&[x[1], -Real::sin_cos(x[0]).0]);
        Ok(1.0)
    };
    Flow { n: 2, n_q: 1, f }
}

/// Period of [`pendulum`] released at rest from `angle`: 2 pi / agm(1, cos(angle / 2)) (Gauss).
pub fn pendulum_period(angle: f64) -> f64 {
    let (mut a, mut g) = (1.0, (0.5 * angle).cos());
    for _ in 0..8 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    core::f64::consts::TAU / a
}

/// q'' = -q.
pub fn oscillator() -> impl Ode<f64> {
    let f = |_, x: &[f64], x_dot: &mut [f64]| {
        x_dot.copy_from_slice(&[x[1], -x[0]]);
        Ok(1.0)
    };
    Flow { n: 2, n_q: 1, f }
}

/// The two-body problem, gravitational parameter 1: x = [position, velocity].
pub fn kepler() -> impl Ode<f64> {
    let f = |_, x: &[f64], x_dot: &mut [f64]| {
        let r2 = x[0] * x[0] + x[1] * x[1];
        let r3 = r2 * r2.sqrt();
        x_dot.copy_from_slice(&[x[2], x[3], -x[0] / r3, -x[1] / r3]);
        Ok(1.0)
    };
    Flow { n: 4, n_q: 2, f }
}

/// Position and velocity on the ellipse of semi-axis 1 and eccentricity `e`, `t` after its pericentre.
pub fn kepler_exact(e: f64, t: f64) -> [f64; 4] {
    let mut anomaly = t;
    for _ in 0..50 {
        anomaly -= (anomaly - e * anomaly.sin() - t) / (1.0 - e * anomaly.cos());
    }
    let (s, c) = anomaly.sin_cos();
    let (b, rate) = ((1.0 - e * e).sqrt(), 1.0 / (1.0 - e * c));
    [c - e, b * s, -s * rate, b * c * rate]
}

/// A bead on the unit circle in Cartesian coordinates, driven by gravity: x = [position, spin].
pub struct Bead {
    pub projections: u8,
}

impl<S: Scalar> Ode<S> for Bead {
    fn n_x(&self) -> usize {
        3
    }
    fn n_q(&self) -> usize {
        2
    }
    fn rates(&mut self, _t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        let ([x, y, w], [x_dot, y_dot, w_dot]) = (x, x_dot) else { return Err(Fault::Shape) };
        (*x_dot, *y_dot, *w_dot) = (-(*w * *y), *w * *x, -*x);
        Ok(S::ONE)
    }
    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let [x, y, _] = x else { return Err(Fault::Shape) };
        let residual = *x * *x + *y * *y - S::ONE;
        let correction = residual * S::from_f64(0.5);
        (*x, *y) = (*x - *x * correction, *y - *y * correction);
        Ok(residual.abs())
    }
    fn projections(&self) -> u8 {
        self.projections
    }
}
