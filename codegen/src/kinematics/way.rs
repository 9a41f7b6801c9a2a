//! Which way round a loop leads to a point.
//!
//! For a constraint L = 0 between vectors the places P, P - L and P + L are one: the rocker of a four-bar is
//! reached along crank and coupler, or from its own bearing, where it turns by its own speed alone.

use super::lower;
use super::quantities::{Kinematics, Value};
use crate::expr::{ExprId, SymbolId};
use crate::model::Model;
use crate::vector::{TriadId, Turn, Vector};

/// Vectors that the constraints keep zero: sums around loops.
pub(super) fn loops(model: &Model, k: &mut Kinematics) -> Vec<Vector> {
    let constraints = model.configuration_constraints.iter();
    let values: Vec<Value> = constraints.map(|c| lower::value(k, &c.expression)).collect();
    values.into_iter().filter_map(|value| if let Value::Vector(v) = value { Some(v) } else { None }).collect()
}

/// A place reached the other way round loops, where fewer moving vectors lead to it.
///
/// The velocity is the same on the constraints.
pub(super) fn shortest(k: &mut Kinematics, place: Vector, loops: &[Vector]) -> Vector {
    let mut shortest = (moving_terms(k, &place), place);
    loop {
        let mut shorter = None;
        for loop_ in loops {
            for way in [shortest.1.minus(&mut k.dag, loop_), shortest.1.plus(&mut k.dag, loop_)] {
                let terms = moving_terms(k, &way);
                if terms < shorter.as_ref().map_or(shortest.0, |(least, _)| *least) {
                    shorter = Some((terms, way));
                }
            }
        }
        match shorter {
            Some(way) => shortest = way,
            None => return shortest.1,
        }
    }
}

/// Number of terms that are not constant in N.
fn moving_terms(k: &Kinematics, vector: &Vector) -> usize {
    let fixed = |(triad, components): (&TriadId, &[ExprId; 3])| {
        matches!(k.triads.turn(*triad), Turn::Inertial)
            && components.iter().all(|&c| k.dag.symbols_of(c).iter().all(|s| is_parameter(k, *s)))
    };
    vector.points.len() + vector.terms.iter().filter(|&(t, c)| !fixed((t, c))).count()
}

fn is_parameter(k: &Kinematics, symbol: SymbolId) -> bool {
    k.parameters.iter().any(|&p| k.dag.as_symbol(p) == Some(symbol))
}
