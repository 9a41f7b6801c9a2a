//! Kutta's method whose first evaluation corrects the state and passes intermediate results to the other evaluations.

use crate::systems::pendulum_period;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::shared_work::{Begun, SharedWork, rk4_shared, rk4_shared_scratch};
use smartbed_runtime::ode::{Ode, State};
use smartbed_runtime::real::{Real, Turn};

/// A pendulum of length 1 by its angle and the place of its end, x = [angle, sin angle, -cos angle, speed]: the place
/// is determined by the angle. The speed at which it counts as singular is the caller's.
struct Rod {
    singular_beyond: f64,
}

impl Ode<f64> for Rod {
    fn n_x(&self) -> usize {
        4
    }
    fn n_q(&self) -> usize {
        3
    }
    fn rates(&mut self, _: f64, x: &[f64], x_dot: &mut [f64]) -> Result<f64, Fault> {
        x_dot.copy_from_slice(&[x[3], -x[2] * x[3], x[1] * x[3], -x[1]]);
        Ok(if x[3].abs() > self.singular_beyond { 0.0 } else { 1.0 })
    }
}

impl SharedWork<f64> for Rod {
    type Near = Turn<f64>;
    fn begin(&mut self, t: f64, x: &mut [f64], x_dot: &mut [f64]) -> Result<Begun<f64, Turn<f64>>, Fault> {
        let pivot = self.rates(t, x, x_dot)?;
        let (sin, cos) = Real::sin_cos(x[0]);
        let residual = (x[1] - sin).abs().max((x[2] + cos).abs());
        (x[1], x[2]) = (sin, -cos);
        Ok(Begun { pivot, residual, near: Turn { angle: x[0], sin, cos } })
    }
    fn rates_near(&mut self, t: f64, x: &[f64], x_dot: &mut [f64], near: &Turn<f64>) -> Result<f64, Fault> {
        let (sin, cos) = Real::sin_cos_near(x[0], near);
        self.rates(t, &[x[0], sin, -cos, x[3]], x_dot)
    }
    fn is_corrected(&self, index: usize) -> bool {
        index == 1 || index == 2
    }
}

/// Error of the angle after a period from rest at 1 rad, and the largest residual that a step begins with.
fn after_a_period(steps: u32) -> (f64, f64) {
    let h = pendulum_period(1.0) / f64::from(steps);
    let mut x = [1.0, 1.0_f64.sin(), -1.0_f64.cos(), 0.0];
    let (mut low, mut scratch) = ([0.0; 4], [0.0; rk4_shared_scratch(4)]);
    let mut state = State::new(&mut x, &mut low).unwrap();
    let mut rod = Rod { singular_beyond: f64::INFINITY };
    let mut largest = 0.0_f64;
    for step in 0..steps {
        let report = rk4_shared(&mut rod, f64::from(step) * h, h, &mut state, &mut scratch).unwrap();
        largest = largest.max(report.residual);
    }
    // At the turning point the angle tells nothing of the phase: the speed does, by u = -sin(1) times the delay.
    ((state.x()[3] / 1.0_f64.sin()).abs() + (state.x()[0] - 1.0).abs(), largest)
}

#[test]
fn the_method_is_of_order_4_and_stays_on_the_constraints() {
    let [(coarse, _), (fine, residual)] = [100, 200].map(after_a_period);
    let order = (coarse / fine).log2();
    println!("errors {coarse:.2e} {fine:.2e}, order {order:.2}, residual {residual:.2e}");
    assert!((order - 4.0).abs() < 0.4, "{order}");
    // One step's own error, of order 5, and no more: h is 0.034.
    assert!(residual < 1e-8, "{residual}");
    assert!(after_a_period(400).1 < residual / 20.0);
}

#[test]
fn a_step_that_is_refused_leaves_the_state_as_it_was() {
    let before = ([0.5, 0.4, -0.9, 0.3], [1e-18, 0.0, 0.0, -1e-18]);
    for (singular_beyond, h) in [(0.1, 0.01), (0.305, -0.1), (f64::INFINITY, f64::NAN)] {
        let (mut x, mut low) = before;
        let mut scratch = [0.0; rk4_shared_scratch(4)];
        let mut state = State::resume(&mut x, &mut low).unwrap();
        let refused = rk4_shared(&mut Rod { singular_beyond }, 0.0, h, &mut state, &mut scratch);
        assert!(refused.is_err(), "{singular_beyond} {h}");
        assert_eq!((x, low), before);
    }
}
