//! A pendulum swings for one second from where its model starts, by Kutta's method; the energy is printed at both ends.

use pendulum::{START_Q, START_U, q, u};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::ode::{Driven, State, rk4, runge_kutta};

/// The generated module: `Pendulum`, also called `Model`, its parameters, names, places and start.
mod pendulum {
    include!(concat!(env!("OUT_DIR"), "/pendulum.rs"));
}

const STEPS: u32 = 1_000;

fn main() -> Result<(), Fault> {
    // Any parameter of the model is a field.
    let parameters = pendulum::Parameters { c: 0.0, ..Default::default() };
    // A law would write the inputs at (t, q, u); this pendulum has none.
    let law = |_t: f64, _q: &[f64], _u: &[f64], _inputs: &mut [f64]| {};
    let mut driven = Driven::new(pendulum::Model::new(parameters), law, &mut [])?;

    let (mut x, mut low) = ([START_Q[q::q], START_U[u::u_q]], [0.0; 2]);
    let before = total(&mut driven.mechanism, &x)?;
    let mut scratch = [0.0; runge_kutta::rk4_scratch(2)];
    let mut state = State::new(&mut x, &mut low)?;
    let h = 1.0 / f64::from(STEPS);
    for step in 0..STEPS {
        rk4(&mut driven, h * f64::from(step), h, &mut state, &mut scratch)?;
    }
    let after = total(&mut driven.mechanism, &x)?;
    println!("q = {:.6} rad, energy {before:.9} J -> {after:.9} J", x[0]);
    Ok(())
}

/// Kinetic and potential energy (J).
fn total(mechanism: &mut pendulum::Model, x: &[f64]) -> Result<f64, Fault> {
    let (q, u) = x.split_at(pendulum::NQ);
    let (kinetic, potential) = mechanism.energy(q, u)?;
    Ok(kinetic + potential)
}
