//! Unknowns from more equations than unknowns: Gauss's normal equations A' A y = A' b.
//!
//! In: consistent rows A y = b. Out: the same unknowns from a symmetric positive definite system, whose pivots on the
//! diagonal vanish only where A itself loses rank: one elimination for every regular configuration. Its pivots are
//! squares of distances, so the conditioning of A counts twice: taken only where no choice of rows is regular.

use super::linear_form::LinearForm;
use super::sparse::Equation;
use super::unknowns::UnknownId;
use crate::expr::Dag;
use std::collections::BTreeMap;

/// The normal equations, by the unknown that each belongs to.
pub(super) fn normal_equations(dag: &mut Dag, equations: &[Equation]) -> BTreeMap<UnknownId, Equation> {
    let zero = dag.zero();
    let n = equations.first().map_or(0, |equation| equation.right.len());
    let mut normal: BTreeMap<UnknownId, Equation> = BTreeMap::new();
    for equation in equations {
        for (&i, &a) in &equation.coefficients {
            let mine = normal
                .entry(i)
                .or_insert_with(|| Equation { coefficients: LinearForm::default(), right: vec![zero; n] });
            mine.coefficients.add(dag, a, &equation.coefficients);
            for (sum, &b) in mine.right.iter_mut().zip(&equation.right) {
                let product = dag.mul(a, b);
                *sum = dag.add(*sum, product);
            }
        }
    }
    normal
}
