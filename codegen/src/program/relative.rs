//! Makes the worst pivot relative to its size at the parameters that are set, instead of those used in the derivation.
//!
//! In: the smallest of several pivots, each divided by its size at the nominal parameters. Out: the same divided by
//! sizes that follow the parameters (`kinematics/sizes.rs`). These are prepared, so that an evaluation takes no
//! additional operation.

use super::derived::Program;
use crate::expr::number::Number;
use crate::expr::{Binary, Dag, Dependence, ExprId, Node, Unary};
use crate::kinematics::sizes::Sizes;

/// Makes the worst pivot of a program relative to its parameters.
pub(super) fn to_parameters(program: &mut Program, sizes: &Sizes) {
    let (dag, worst) = (&mut program.dag, program.rates.worst_pivot);
    let (numbers, pivots): (Vec<Number>, Vec<ExprId>) = pivots(dag, worst).into_iter().unzip();
    let growths = sizes.growth(dag, &pivots);
    // Pivots of parameters alone are compared with one another when a parameter changes, all others at each evaluation.
    let [mut fixed, mut varying]: [Vec<(Number, ExprId, ExprId)>; 2] = Default::default();
    for ((number, pivot), growth) in numbers.into_iter().zip(pivots).zip(growths) {
        let groups = if dag.dependence(pivot) == Dependence::State { &mut varying } else { &mut fixed };
        match groups.iter_mut().find(|(n, g, _)| (*n, *g) == (number, growth)) {
            Some((.., smallest)) => *smallest = dag.binary(Binary::Min, *smallest, pivot),
            None => groups.push((number, growth, pivot)),
        }
    }
    let relative = |dag: &mut Dag, (number, growth, smallest): (Number, ExprId, ExprId)| {
        let number = dag.number(number);
        let scale = dag.div(number, growth);
        match dag.node(smallest) {
            // Takes the absolute value last: code that compares sizes then need not form it.
            Node::Unary(Unary::Abs, pivot) => {
                let scaled = dag.mul(scale, pivot);
                dag.unary(Unary::Abs, scaled)
            }
            _ => dag.mul(scale, smallest),
        }
    };
    let mut smallest = |groups: Vec<(Number, ExprId, ExprId)>| {
        let scaled: Vec<ExprId> = groups.into_iter().map(|group| relative(dag, group)).collect();
        // Innermost the last pivots: ten instructions fewer of the tile's 962 on a Cortex-M4.
        scaled.into_iter().rev().reduce(|a, b| dag.binary(Binary::Min, a, b))
    };
    let smallest = [smallest(varying), smallest(fixed)].into_iter().flatten();
    program.rates.worst_pivot = smallest.reduce(|a, b| dag.binary(Binary::Min, a, b)).unwrap_or(worst);
}

/// The pivots of which an expression is the minimum, each with its numeric factor.
fn pivots(dag: &mut Dag, worst: ExprId) -> Vec<(Number, ExprId)> {
    let (mut open, mut pivots) = (vec![(Number::ONE, worst)], Vec::new());
    while let Some((number, expr)) = open.pop() {
        let (own, pivot) = dag.split_coefficient(expr);
        let number = number.multiply(own);
        match dag.node(pivot) {
            Node::Binary(Binary::Min, a, b) => open.extend([(number, b), (number, a)]),
            _ => pivots.push((number, pivot)),
        }
    }
    pivots
}
