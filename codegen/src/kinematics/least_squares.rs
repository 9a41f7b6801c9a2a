//! Normal equations A' A y = A' b (Gauss), for more equations than unknowns.
//!
//! In: consistent rows A y = b. Out: a symmetric positive definite system for the same unknowns. Its diagonal pivots
//! vanish only where A itself loses rank, so one elimination serves every regular configuration. They are squared
//! lengths, which squares the condition number: used only if no choice of rows is regular.

use super::linear_form::LinearForm;
use super::sparse::Equation;
use super::unknowns::UnknownId;
use crate::expr::Dag;
use std::collections::BTreeMap;

/// The normal equations, by the unknown on whose diagonal entry each is pivoted.
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
