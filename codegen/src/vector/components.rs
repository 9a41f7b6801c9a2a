//! Arithmetic of the three components of vectors in one triad.

use super::triads::Components;
use crate::expr::{Dag, ExprId};
use crate::model::Axis;

/// Components after a simple rotation: child to parent, or (`inverse`) parent to child.
pub fn turn_components(dag: &mut Dag, axis: Axis, angle: ExprId, v: Components, inverse: bool) -> Components {
    let k = axis as usize;
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let (sin, cos) = (dag.sin(angle), dag.cos(angle));
    if dag.is_zero(v[i]) && dag.is_zero(v[j]) {
        return v; // along the axis
    }
    let sin = if inverse { dag.negate(sin) } else { sin };
    // v_i' = cos v_i - sin v_j ; v_j' = sin v_i + cos v_j
    let (ci, sj) = (dag.mul(cos, v[i]), dag.mul(sin, v[j]));
    let (si, cj) = (dag.mul(sin, v[i]), dag.mul(cos, v[j]));
    let mut turned = v;
    turned[i] = dag.sub(ci, sj);
    turned[j] = dag.add(si, cj);
    turned
}

/// Index and value of the only non-zero component, if there is exactly one.
pub fn along_axis(dag: &Dag, components: &Components) -> Option<(usize, ExprId)> {
    let mut found = (0..3).filter(|&i| !dag.is_zero(components[i]));
    match (found.next(), found.next()) {
        (Some(i), None) => Some((i, components[i])),
        _ => None,
    }
}

/// a . b of components in one triad.
pub fn dot_components(dag: &mut Dag, a: &Components, b: &Components) -> ExprId {
    let terms: [ExprId; 3] = std::array::from_fn(|k| dag.mul(a[k], b[k]));
    dag.sum(&terms)
}

/// a x b of components in one triad.
pub fn cross_components(dag: &mut Dag, a: &Components, b: &Components) -> Components {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (left, right) = (dag.mul(a[i], b[j]), dag.mul(a[j], b[i]));
        dag.sub(left, right)
    })
}
