//! Completes speeds: if all speeds are state, those left out follow from the constraints.
//!
//! In: a configuration and some speeds. Out: all speeds of the state. Independent speeds are taken as given, 0 if left
//! out. Redundant ones (the motion passes dead points of the independent speeds) must satisfy the constraints J u = -j:
//! those given are met as closely as possible, the others are as small as possible.

use super::derived::Program;
use super::interpreter::Interpreted;
use crate::kinematics::linear;
use smartbed_runtime::mechanism::{Fault, Mechanism};

/// A relative residual below this means that the equations are consistent.
const CONSISTENT: f64 = 1e-9;

/// Completes the speeds of the state; `given[i]` is the value of the i-th one.
///
/// # Errors
/// [`Fault::Shape`] if a list has not the length of the state.
pub fn complete(
    program: &Program,
    (t, q, parameters): (f64, &[f64], &[f64]),
    given: &[Option<f64>],
) -> Result<Vec<f64>, Fault> {
    let zeros = given.iter().map(|speed| speed.unwrap_or(0.0)).collect();
    if !program.is_redundant() {
        return Ok(zeros);
    }
    let is_independent = |i: usize| program.is_independent[i];
    // If a dependent speed is given, it determines the motion: left-out independent ones are then not 0.
    let by_others = given.iter().enumerate().any(|(i, speed)| speed.is_some() && !is_independent(i));
    let given = given.iter().enumerate();
    let wanted = given
        .filter_map(|(i, &speed)| Some((i, speed.or((!by_others && is_independent(i)).then_some(0.0))?)));
    let wanted: Vec<(usize, f64)> = wanted.collect();
    let mut engine = Interpreted::<f64>::new(program);
    engine.set_parameters(parameters);
    engine.set_time(t);
    let n = zeros.len();
    let mut met = |mut u: Vec<f64>| engine.project_speeds(q, &mut u).map(|()| u);
    // The constraints are satisfied by u = P w + still, for any w.
    let still = met(vec![0.0; n])?;
    let mut columns = Vec::new();
    for i in 0..n {
        let mut unit = vec![0.0; n];
        unit[i] = 1.0;
        columns.push(met(unit)?.iter().zip(&still).map(|(x, y)| x - y).collect::<Vec<f64>>());
    }
    // The w of least norm for which (P w)_i has the given values: w = P_i' y.
    let m = wanted.len();
    let product = |a: usize, b: usize| columns.iter().map(|column| column[a] * column[b]).sum::<f64>();
    let gram: Vec<f64> = wanted
        .iter()
        .flat_map(|&(a, _)| wanted.iter().map(move |&(b, _)| (a, b)))
        .map(|(a, b)| product(a, b))
        .collect();
    let right: Vec<f64> = wanted.iter().map(|&(i, speed)| speed - still[i]).collect();
    let y = least_squares(&gram, &right, m);
    let mut u = still;
    for column in &columns {
        let w: f64 = wanted.iter().zip(&y).map(|(&(i, _), y)| column[i] * y).sum();
        u.iter_mut().zip(column).for_each(|(u, x)| *u += w * x);
    }
    // Projects once more, to remove rounding errors.
    met(u)
}

/// Solves G y = r for a symmetric G; if that has no solution, G G y = G r.
fn least_squares(gram: &[f64], right: &[f64], n: usize) -> Vec<f64> {
    let times = |y: &[f64]| -> Vec<f64> {
        gram.chunks_exact(n.max(1)).map(|row| row.iter().zip(y).map(|(a, y)| a * y).sum()).collect()
    };
    let (y, _) = linear::solve(gram, &mut right.to_vec(), n);
    let size = right.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
    if times(&y).iter().zip(right).all(|(a, b)| (a - b).abs() <= CONSISTENT * size) {
        return y;
    }
    let columns: Vec<Vec<f64>> = gram.chunks_exact(n.max(1)).map(times).collect();
    linear::solve(&columns.concat(), &mut times(right), n).0
}
