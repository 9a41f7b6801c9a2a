//! Inverse problems: forces of given accelerations, inputs of given forces, and the inertia felt at a place.
//!
//! In: M u' = forcing. Out: expressions. Featherstone 2008, chapters 5 (inverse dynamics) and 6.

use super::solve::Factors;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::id::Id;
use crate::kinematics::sparse::{self, Equation};
use crate::kinematics::{Kinematics, UnknownId, linear};

/// M u' - forcing.
pub(crate) fn forces_for(
    dag: &mut Dag,
    mass: &[Vec<ExprId>],
    forcing: &[ExprId],
    u_dot: &[ExprId],
) -> Vec<ExprId> {
    let mut forces = Vec::new();
    for (row, &force) in mass.iter().zip(forcing) {
        let terms: Vec<ExprId> = row.iter().zip(u_dot).map(|(&m, &u)| dag.mul(m, u)).collect();
        let sum = dag.sum(&terms);
        forces.push(dag.sub(sum, force));
    }
    forces
}

/// Inputs that supply the generalised forces: B inputs = force, with B how the forcing depends on them. None where B is
/// not square, depends on the inputs, or is singular at a sample.
pub(crate) fn inputs_for(
    k: &mut Kinematics,
    table: &mut SampleTable,
    forcing: &[ExprId],
    inputs: &[SymbolId],
    force: &[ExprId],
) -> Option<Vec<ExprId>> {
    let n = force.len();
    if inputs.len() != n {
        return None;
    }
    let mut map = vec![vec![k.dag.zero(); n]; n];
    for (row, &f) in map.iter_mut().zip(forcing) {
        for (entry, &input) in row.iter_mut().zip(inputs) {
            *entry = k.dag.derivative(f, input);
            if k.dag.symbols_of(*entry).iter().any(|symbol| inputs.contains(symbol)) {
                return None;
            }
        }
    }
    for sample in 0..table.points() {
        let numbers: Vec<f64> =
            map.iter().flatten().map(|&entry| table.values(&k.dag, entry)[sample]).collect();
        if linear::solve(&numbers, &mut vec![0.0; n], n).1 < n {
            return None;
        }
    }
    let mut equations = Vec::new();
    for (row, &force) in map.into_iter().zip(force) {
        let entries = row.into_iter().enumerate().filter(|(_, e)| !k.dag.is_zero(*e));
        let coefficients = entries.map(|(j, e)| (UnknownId::from_index(j), e)).collect();
        equations.push(Equation { coefficients, right: vec![force] });
    }
    let (values, _) = sparse::solve(&mut k.dag, table, equations)?;
    (0..n).map(|j| values.get(&UnknownId::from_index(j)).map(|value| value[0])).collect()
}

/// J M^-1 J' for the rows of J: with M = L D L' and X = L^-1 J', it is X' D^-1 X.
pub(crate) fn inverse_inertia(
    dag: &mut Dag,
    mass: &[Vec<ExprId>],
    jacobian: &[Vec<ExprId>],
) -> Vec<Vec<ExprId>> {
    let factors = Factors::new(dag, mass);
    let halves: Vec<Vec<ExprId>> = jacobian.iter().map(|row| factors.forward(dag, row)).collect();
    let divided: Vec<Vec<ExprId>> = halves.iter().map(|x| factors.divide(dag, x)).collect();
    let zero = dag.zero();
    let mut inverse = vec![vec![zero; jacobian.len()]; jacobian.len()];
    for a in 0..jacobian.len() {
        for b in 0..=a {
            let terms: Vec<ExprId> =
                halves[a].iter().zip(&divided[b]).map(|(&x, &y)| dag.mul(x, y)).collect();
            inverse[a][b] = dag.sum(&terms);
            inverse[b][a] = inverse[a][b];
        }
    }
    inverse
}
