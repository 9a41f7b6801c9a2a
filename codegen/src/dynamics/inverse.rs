//! Inverse dynamics: forces for given accelerations, inputs for given forces, and the effective inertia at a place.
//!
//! In: M u' = forcing, or bodies with given accelerations. Out: expressions. Featherstone 2008, chapter 5 (inverse
//! dynamics) and chapter 6.

use super::absolute::Absolute;
use super::given::Given;
use super::mass_and_force::MassAndForce;
use super::solve::Factors;
use super::{active_force, inertia_force};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::id::Id;
use crate::kinematics::eliminate::Solution;
use crate::kinematics::sparse::{self, Equation};
use crate::kinematics::{Kinematics, LinearForm, UnknownId, linear};
use crate::model::Model;
use crate::vector::Algebra;

/// By unknown: the generalised force that is missing for the given accelerations, inertia forces less active forces.
pub(crate) fn missing_forces(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
    u_dot: &[ExprId],
) -> LinearForm {
    let given = Given::new(alg, k, solution, u_dot);
    missing_at(alg, model, k, &given)
}

/// [`missing_forces`] at given derivatives of all unknowns.
pub(super) fn missing_at(alg: &mut Algebra, model: &Model, k: &Kinematics, given: &Given) -> LinearForm {
    let mut parts = MassAndForce::default();
    inertia_force::accumulate(alg, model, k, given, &mut parts);
    active_force::accumulate(alg, model, k, &mut parts);
    parts.force.into_iter().map(|(unknown, force)| (unknown, alg.dag.negate(force))).collect()
}

/// The missing forces on the independent speeds, T' f: those on the other unknowns enter by their partial velocities.
pub(crate) fn on_independent(
    alg: &mut Algebra,
    k: &Kinematics,
    solution: &Solution,
    mut forces: LinearForm,
) -> Vec<ExprId> {
    for step in &solution.steps {
        forces.substitute(&mut alg.dag, step.unknown, &step.coefficients);
    }
    let zero = alg.dag.zero();
    let independent = k.unknowns.independent();
    independent.into_iter().map(|unknown| forces.get(&unknown).copied().unwrap_or(zero)).collect()
}

/// Multipliers lambda of the rows in `J' lambda = M y' - f`, from the equations of the dependent unknowns; `None` if
/// there are more rows than dependent unknowns, so that single multipliers are not determined.
pub(crate) fn multipliers(
    alg: &mut Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    solution: &Solution,
    missing: &LinearForm,
) -> Option<Vec<ExprId>> {
    let dependent = k.unknowns.dependent();
    if dependent.len() != solution.rows.len() {
        return None;
    }
    let zero = alg.dag.zero();
    let mut equations = Vec::new();
    for unknown in dependent {
        let entries = solution.rows.iter().enumerate();
        let coefficients = entries
            .filter_map(|(r, row)| Some((UnknownId::from_index(r), *row.coefficients.get(&unknown)?)))
            .collect();
        equations
            .push(Equation { coefficients, right: vec![missing.get(&unknown).copied().unwrap_or(zero)] });
    }
    let (values, _) = sparse::solve(&mut alg.dag, table, equations)?;
    (0..solution.rows.len()).map(|r| values.get(&UnknownId::from_index(r)).map(|v| v[0])).collect()
}

/// -M^-1 columns: the change of u' due to a change of M u' - forcing at constant u'. Uses the factors of the forward
/// dynamics. Columns with a single entry are taken from the symmetric M^-1, of which half is formed.
pub(crate) fn response(dag: &mut Dag, mass: &[Vec<ExprId>], columns: &[Vec<ExprId>]) -> Vec<Vec<ExprId>> {
    let mut inverse = None;
    let mut solved = Vec::new();
    for column in columns {
        let absolute = Absolute::new(dag, mass, column);
        let factors = Factors::new(dag, &absolute.mass);
        let entries: Vec<usize> = (0..column.len()).filter(|&i| !dag.is_zero(column[i])).collect();
        let rates = match entries.len() {
            1 => {
                let inverse = inverse.get_or_insert_with(|| factors.inverse(dag));
                let product = |row: &Vec<ExprId>, dag: &mut Dag| {
                    let terms: Vec<ExprId> =
                        row.iter().zip(&absolute.forcing).map(|(&m, &f)| dag.mul(m, f)).collect();
                    dag.sum(&terms)
                };
                inverse.iter().map(|row| product(row, dag)).collect()
            }
            _ => factors.solve(dag, &absolute.forcing),
        };
        let speeds = absolute.relative(dag, &rates);
        solved.push(speeds.into_iter().map(|x| dag.negate(x)).collect());
    }
    solved
}

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

/// Inputs that supply the generalised forces: B inputs = force, with B the derivative of the forcing by the inputs.
/// `None` if B is not square, depends on the inputs, or is singular at a sample.
pub(crate) fn inputs_for(
    alg: &mut Algebra,
    table: &mut SampleTable,
    forcing: &[ExprId],
    inputs: &[SymbolId],
    force: &[ExprId],
) -> Option<Vec<ExprId>> {
    let n = force.len();
    if inputs.len() != n {
        return None;
    }
    let mut map = vec![vec![alg.dag.zero(); n]; n];
    for (row, &f) in map.iter_mut().zip(forcing) {
        for (entry, &input) in row.iter_mut().zip(inputs) {
            *entry = alg.dag.derivative(f, input);
            if alg.dag.symbols_of(*entry).iter().any(|symbol| inputs.contains(symbol)) {
                return None;
            }
        }
    }
    for sample in 0..table.points() {
        let numbers: Vec<f64> =
            map.iter().flatten().map(|&entry| table.values(&alg.dag, entry)[sample]).collect();
        if linear::solve(&numbers, &mut vec![0.0; n], n).1 < n {
            return None;
        }
    }
    let mut equations = Vec::new();
    for (row, &force) in map.into_iter().zip(force) {
        let entries = row.into_iter().enumerate().filter(|(_, e)| !alg.dag.is_zero(*e));
        let coefficients = entries.map(|(j, e)| (UnknownId::from_index(j), e)).collect();
        equations.push(Equation { coefficients, right: vec![force] });
    }
    let (values, _) = sparse::solve(&mut alg.dag, table, equations)?;
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
