//! Classical Runge-Kutta step: a local stand-in for the runtime's integrator, to be deleted.

use crate::mechanism::{N_INPUTS, NQ, NU};
use smartbed_runtime::mechanism::{Fault, Mechanism};

/// Advances (q, u) by the step h with the inputs held, then projects once.
///
/// # Errors
/// What the mechanism refuses; the state is then as it was.
pub fn step(
    model: &mut impl Mechanism<f32>,
    (t, h): (f32, f32),
    q: &mut [f32; NQ],
    u: &mut [f32; NU],
    inputs: &[f32; N_INPUTS],
) -> Result<(), Fault> {
    const NODES: [(f32, f32, f32); 4] = [(0.0, 0.0, 1.0), (0.5, 0.5, 2.0), (0.5, 0.5, 2.0), (1.0, 1.0, 1.0)];
    let (mut q_sum, mut u_sum) = ([0.0; NQ], [0.0; NU]);
    let (mut q_dot, mut u_dot) = ([0.0; NQ], [0.0; NU]);
    for (c, a, b) in NODES {
        let (mut qs, mut us) = (*q, *u);
        advance(&mut qs, &q_dot, a * h);
        advance(&mut us, &u_dot, a * h);
        model.rates(t + c * h, &qs, &us, inputs, &mut q_dot, &mut u_dot)?;
        advance(&mut q_sum, &q_dot, b);
        advance(&mut u_sum, &u_dot, b);
    }
    let (mut q_new, mut u_new) = (*q, *u);
    advance(&mut q_new, &q_sum, h / 6.0);
    advance(&mut u_new, &u_sum, h / 6.0);
    model.project(&mut q_new)?;
    if q_new.iter().chain(&u_new).any(|x| !x.is_finite()) {
        return Err(Fault::NonFinite);
    }
    (*q, *u) = (q_new, u_new);
    Ok(())
}

fn advance(x: &mut [f32], x_dot: &[f32], h: f32) {
    for (x, x_dot) in x.iter_mut().zip(x_dot) {
        *x += h * *x_dot;
    }
}
