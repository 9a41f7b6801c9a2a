//! Decides which sines and cosines are computed two at a time.
//!
//! A host computes sine and cosine of two f64 angles in little more than the time of one (`Real::sin_cos_of_two`),
//! provided neither has to wait for the other: both angles must be sums and products of the function's arguments. The
//! microcontroller has no such instructions, and there a value that is needed late should be computed late.

use crate::expr::{Binary, Dag, ExprId, Node, NodeSet, Unary};
use crate::id::Id;
use rustc_hash::FxHashMap as HashMap;

/// By angle: the other angle of its pair. `order` holds the nodes that are computed or used, operands first; `is_read`
/// tells those that are used.
pub(super) fn pair_angles(
    dag: &Dag,
    order: &[ExprId],
    is_read: impl Fn(ExprId) -> bool,
) -> HashMap<ExprId, ExprId> {
    let mut slow = NodeSet::below(order.last().map_or(0, |id| id.index() + 1));
    let mut angles: Vec<ExprId> = Vec::new();
    for &id in order.iter().filter(|&&id| !is_read(id) && !dag.is_constant(id)) {
        let node = dag.node(id);
        if matches!(node, Node::Unary(..) | Node::Binary(Binary::Div, ..))
            || dag.operands(id).into_iter().flatten().any(|operand| slow.contains(operand))
        {
            slow.insert(id);
        }
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = node
            && !slow.contains(angle)
            && !angles.contains(&angle)
        {
            angles.push(angle);
        }
    }
    // Pairs only like with like, because a difference takes two arguments.
    let (differences, plain): (Vec<_>, Vec<_>) =
        angles.into_iter().partition(|&angle| dag.as_difference(angle).is_some() && !is_read(angle));
    let pairs = plain.chunks_exact(2).chain(differences.chunks_exact(2));
    pairs.flat_map(|pair| [(pair[0], pair[1]), (pair[1], pair[0])]).collect()
}
