//! A pendulum swings for one second, by Heun's rule; the energy is printed at both ends.

use smartbed_runtime::mechanism::{Fault, Mechanism};

/// The generated module: `Pendulum`, `Parameters`, names, sizes.
mod pendulum {
    include!(concat!(env!("OUT_DIR"), "/pendulum.rs"));
}

fn main() -> Result<(), Fault> {
    // Any parameter of the model is a field.
    let parameters = pendulum::Parameters { c: 0.0, ..Default::default() };
    let mut mechanism = pendulum::Pendulum::new(parameters);
    let (mut q, mut u) = ([0.5], [0.0]);
    let before = total(&mut mechanism, &q, &u)?;
    const STEPS: u32 = 10_000;
    let step = 1.0 / f64::from(STEPS);
    for _ in 0..STEPS {
        let (mut q_dot, mut u_dot) = ([0.0], [0.0]);
        mechanism.rates(0.0, &q, &u, &[], &mut q_dot, &mut u_dot)?;
        let (mut q_next, mut u_next) = ([0.0], [0.0]);
        let (q_end, u_end) = ([q[0] + step * q_dot[0]], [u[0] + step * u_dot[0]]);
        mechanism.rates(0.0, &q_end, &u_end, &[], &mut q_next, &mut u_next)?;
        q[0] += step / 2.0 * (q_dot[0] + q_next[0]);
        u[0] += step / 2.0 * (u_dot[0] + u_next[0]);
    }
    let after = total(&mut mechanism, &q, &u)?;
    println!("q = {:.6} rad, energy {before:.9} J -> {after:.9} J", q[0]);
    Ok(())
}

/// Kinetic and potential energy (J).
fn total(mechanism: &mut pendulum::Pendulum, q: &[f64], u: &[f64]) -> Result<f64, Fault> {
    let (kinetic, potential) = mechanism.energy(q, u)?;
    Ok(kinetic + potential)
}
