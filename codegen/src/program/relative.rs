//! The worst pivot relative to the parameters that the mechanism has, not to those it was derived with.
//!
//! In: the smallest of several pivots, each over its size at the nominal parameters. Out: the same over the sizes that
//! follow the parameters (`kinematics/sizes.rs`). They are prepared: an evaluation takes no operation more.

use super::derived::Program;
use crate::expr::number::Number;
use crate::expr::{Binary, Dag, ExprId, Node, Unary};
use crate::kinematics::sizes::Sizes;

/// Takes the worst pivot of a program relative to its parameters.
pub(super) fn to_parameters(program: &mut Program, sizes: &Sizes) {
    let (dag, worst) = (&mut program.dag, program.rates.worst_pivot);
    let (numbers, pivots): (Vec<Number>, Vec<ExprId>) = pivots(dag, worst).into_iter().unzip();
    let growths = sizes.growth(dag, &pivots);
    let mut groups: Vec<(Number, ExprId, ExprId)> = Vec::new();
    for ((number, pivot), growth) in numbers.into_iter().zip(pivots).zip(growths) {
        match groups.iter_mut().find(|(n, g, _)| (*n, *g) == (number, growth)) {
            Some((.., smallest)) => *smallest = dag.binary(Binary::Min, *smallest, pivot),
            None => groups.push((number, growth, pivot)),
        }
    }
    let mut relative = |(number, growth, smallest): (Number, ExprId, ExprId)| {
        let number = dag.number(number);
        let scale = dag.div(number, growth);
        match dag.node(smallest) {
            // The size last: what compares sizes needs none formed.
            Node::Unary(Unary::Abs, pivot) => {
                let scaled = dag.mul(scale, pivot);
                dag.unary(Unary::Abs, scaled)
            }
            _ => dag.mul(scale, smallest),
        }
    };
    let scaled: Vec<ExprId> = groups.into_iter().map(&mut relative).collect();
    // The last pivots innermost: ten instructions fewer of the tile's 962 on a Cortex-M4.
    let smallest = scaled.into_iter().rev().reduce(|a, b| dag.binary(Binary::Min, a, b));
    program.rates.worst_pivot = smallest.unwrap_or(worst);
}

/// The pivots that an expression is the smallest of, each with the number that it is multiplied with.
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
