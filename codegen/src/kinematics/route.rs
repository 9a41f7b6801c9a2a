//! Chooses the route to a point: in a loop of the mechanism it can be reached either way round.
//!
//! If a constraint states L = 0 for a vector L, then P, P - L and P + L are the same position. The rocker of a four-bar
//! is reached along crank and coupler, or from its own bearing, where its motion depends on its own speed alone.

use super::lower;
use super::quantities::{Kinematics, Value};
use crate::expr::{ExprId, SymbolId};
use crate::model::Model;
use crate::vector::{Algebra, TriadId, Turn, Vector};

/// Vectors that the constraints keep zero: sums around loops.
pub(super) fn loops(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Vec<Vector> {
    let constraints = model.configuration_constraints.iter();
    let values: Vec<Value> = constraints.map(|c| lower::value(alg, k, &c.expression)).collect();
    values.into_iter().filter_map(|value| if let Value::Vector(v) = value { Some(v) } else { None }).collect()
}

/// The position by the route with the fewest moving vectors. Its velocity is the same wherever the constraints hold.
pub(super) fn shortest(alg: &mut Algebra, k: &Kinematics, place: Vector, loops: &[Vector]) -> Vector {
    let mut shortest = (moving_terms(alg, k, &place), place);
    loop {
        let mut shorter = None;
        for loop_ in loops {
            for route in [shortest.1.minus(&mut alg.dag, loop_), shortest.1.plus(&mut alg.dag, loop_)] {
                let terms = moving_terms(alg, k, &route);
                if terms < shorter.as_ref().map_or(shortest.0, |(least, _)| *least) {
                    shorter = Some((terms, route));
                }
            }
        }
        match shorter {
            Some(route) => shortest = route,
            None => return shortest.1,
        }
    }
}

/// Number of terms that are not constant in N.
fn moving_terms(alg: &Algebra, k: &Kinematics, vector: &Vector) -> usize {
    let fixed = |(triad, components): (&TriadId, &[ExprId; 3])| {
        matches!(alg.triads.turn(*triad), Turn::Inertial)
            && components.iter().all(|&c| alg.dag.symbols_of(c).iter().all(|s| is_parameter(alg, k, *s)))
    };
    vector.points.len() + vector.terms.iter().filter(|&(t, c)| !fixed((t, c))).count()
}

fn is_parameter(alg: &Algebra, k: &Kinematics, symbol: SymbolId) -> bool {
    k.parameters.iter().any(|&p| alg.dag.as_symbol(p) == Some(symbol))
}
