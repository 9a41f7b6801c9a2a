//! The factors of the constraint Jacobian J_d, for right-hand sides that become known later.
//!
//! In: J_d, as many rows as dependent unknowns. Out: y of J_d y = right, and lambda of J_d' lambda = force. The
//! elimination is the one that gave the dependent speeds, with the same expressions for pivots and coefficients.

use super::eliminate::{Solution, Step};
use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Row};
use super::sparse::{self, Elimination, Equation};
use super::unknowns::UnknownId;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use crate::vector::Algebra;

/// J_d after elimination.
#[derive(Clone)]
pub(crate) struct Factored {
    done: Vec<Elimination>,
}

impl Factored {
    /// `None` if the elimination of these rows is not the one of the solution, as when there are more rows than
    /// unknowns.
    pub fn new(
        alg: &mut Algebra,
        k: &Kinematics,
        table: &mut SampleTable,
        solution: &Solution,
    ) -> Option<Self> {
        let dependent = k.unknowns.dependent();
        let of_dependent = |row: &Row| {
            let mut coefficients = row.coefficients.clone();
            coefficients.retain(|unknown, _| dependent.contains(unknown));
            Equation { coefficients, right: Vec::new() }
        };
        let equations = solution.rows.iter().map(of_dependent).collect();
        let done = sparse::eliminate(&mut alg.dag, table, equations);
        let is_same = |(mine, step): (&Elimination, &Step)| {
            let holds = |(z, c): (&UnknownId, &ExprId)| step.coefficients.get(z) == Some(c);
            mine.unknown == step.unknown && mine.coefficients.iter().all(holds)
        };
        let is_whole = solution.rows.len() == dependent.len() && done.len() == solution.steps.len();
        (is_whole && done.iter().zip(&solution.steps).all(is_same)).then_some(Self { done })
    }

    /// The same factors with every pivot and coefficient replaced by its image.
    pub fn map(&self, mut image: impl FnMut(ExprId) -> ExprId) -> Self {
        let mut this = self.clone();
        for step in &mut this.done {
            step.pivot = image(step.pivot);
            step.coefficients.values_mut().for_each(|c| *c = image(*c));
            step.others.iter_mut().for_each(|(_, entry)| *entry = image(*entry));
        }
        this
    }

    /// Solves J_d y = right.
    pub fn solve(&self, dag: &mut Dag, mut right: Vec<ExprId>) -> LinearForm {
        let mut quotients = Vec::new();
        for step in &self.done {
            let quotient = dag.div(right[step.row], step.pivot);
            for &(other, entry) in &step.others {
                let product = dag.mul(entry, quotient);
                right[other] = dag.sub(right[other], product);
            }
            quotients.push(quotient);
        }
        let mut known = LinearForm::default();
        for (step, quotient) in self.done.iter().zip(quotients).rev() {
            let mut value = quotient;
            for (z, &c) in &step.coefficients {
                let product = dag.mul(c, known[z]);
                value = dag.add(value, product);
            }
            known.insert(step.unknown, value);
        }
        known
    }

    /// Solves J_d' lambda = force, one lambda per row: the transposed steps in reverse order.
    pub fn solve_transposed(&self, dag: &mut Dag, mut force: LinearForm) -> Vec<ExprId> {
        let zero = dag.zero();
        let mut carried = Vec::new();
        for step in &self.done {
            carried.push(force.substitute(dag, step.unknown, &step.coefficients).unwrap_or(zero));
        }
        let mut lambda = vec![zero; self.done.len()];
        for (step, own) in self.done.iter().zip(carried).rev() {
            let mut rest = own;
            for &(other, entry) in &step.others {
                let product = dag.mul(entry, lambda[other]);
                rest = dag.sub(rest, product);
            }
            lambda[step.row] = dag.div(rest, step.pivot);
        }
        lambda
    }
}
