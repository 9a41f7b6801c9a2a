//! Slides: the parts of positions that move within a triad, as the offsets of prismatic joints.
//!
//! In: the positions of all mass centres. Out: for any such position its part in a triad, divided into what is constant
//! there and one displacement for each joint that slides, the innermost first. A joint that moves more bodies than
//! another is inside it; coordinates that move the same number of bodies belong to one joint, as in a planar one.

use crate::expr::{Binary, Dag, Dependence, ExprId, Node, SymbolId};
use crate::vector::{Components, TriadId, Vector};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// The bodies that a coordinate moves within a triad.
struct Carried {
    /// How many.
    bodies: usize,
    /// The constant part of their positions in the triad, if it is the same for all.
    constant: Option<Components>,
}

/// By triad and coordinate: what slides with it.
pub(super) struct Slides {
    carried: BTreeMap<(TriadId, SymbolId), Carried>,
}

/// The components of a position in one triad.
struct Split {
    constant: Components,
    /// Displacements, each with the coordinates that change it.
    moving: Vec<(Vec<SymbolId>, Components)>,
}

impl Slides {
    /// Collects what slides at the given positions.
    pub(super) fn new<'p>(dag: &mut Dag, positions: impl Iterator<Item = &'p Vector>) -> Self {
        let mut carried: BTreeMap<(TriadId, SymbolId), Carried> = BTreeMap::new();
        for (&triad, components) in positions.flat_map(|position| &position.terms) {
            let Split { constant, moving } = split(dag, components);
            for symbol in moving.into_iter().flat_map(|(symbols, _)| symbols) {
                let first = Carried { bodies: 0, constant: Some(constant) };
                let known = carried.entry((triad, symbol)).or_insert(first);
                known.bodies += 1;
                known.constant = known.constant.filter(|c| *c == constant);
            }
        }
        Self { carried }
    }

    /// The part of the components that does not slide, and the displacements of the slides, the innermost first. What
    /// all bodies behind the last slide have in common belongs to its displacement.
    pub(super) fn split(
        &self,
        dag: &mut Dag,
        triad: TriadId,
        components: &Components,
    ) -> (Components, Vec<Components>) {
        let Split { constant, moving } = split(dag, components);
        let carried = |symbols: &[SymbolId]| {
            let known = symbols.iter().filter_map(|&s| self.carried.get(&(triad, s)));
            known.max_by_key(|c| c.bodies).map_or((0, None), |c| (c.bodies, c.constant))
        };
        let mut by_bodies: BTreeMap<Reverse<usize>, (Components, Option<Components>)> = BTreeMap::new();
        for (symbols, displacement) in moving {
            let (bodies, constant) = carried(&symbols);
            let joint = by_bodies.entry(Reverse(bodies)).or_insert(([dag.zero(); 3], constant));
            joint.0 = sum(dag, joint.0, displacement);
        }
        let mut rest = constant;
        if let Some(mut last) = by_bodies.last_entry()
            && last.get().1 == Some(constant)
        {
            let joint = last.get_mut();
            joint.0 = sum(dag, joint.0, constant);
            rest = [dag.zero(); 3];
        }
        (rest, by_bodies.into_values().map(|(displacement, _)| displacement).collect())
    }
}

/// Divides every component, a sum of terms, by the coordinates that its terms depend on.
fn split(dag: &mut Dag, components: &Components) -> Split {
    let zero = dag.zero();
    let mut found = Split { constant: [zero; 3], moving: Vec::new() };
    for (axis, &component) in components.iter().enumerate() {
        for term in terms(dag, component) {
            let mut symbols = dag.symbols_of(term);
            symbols.retain(|&s| {
                dag.find(Node::Symbol(s)).is_some_and(|id| dag.dependence(id) == Dependence::State)
            });
            if symbols.is_empty() {
                found.constant[axis] = dag.add(found.constant[axis], term);
                continue;
            }
            let mut part = [zero; 3];
            part[axis] = term;
            // Displacements that share a coordinate are one.
            let shares = |(others, _): &mut (Vec<SymbolId>, Components)| {
                others.iter().any(|symbol| symbols.contains(symbol))
            };
            let joined: Vec<_> = found.moving.extract_if(.., shares).collect();
            for (others, other) in joined {
                symbols.extend(others);
                part = sum(dag, part, other);
            }
            symbols.sort();
            symbols.dedup();
            found.moving.push((symbols, part));
        }
    }
    found
}

/// The terms of a sum, each with its sign.
fn terms(dag: &mut Dag, expr: ExprId) -> Vec<ExprId> {
    let (mut found, mut open) = (Vec::new(), vec![(expr, false)]);
    while let Some((expr, negative)) = open.pop() {
        match dag.node(expr) {
            Node::Binary(Binary::Add, a, b) => open.extend([(b, negative), (a, negative)]),
            Node::Binary(Binary::Sub, a, b) => open.extend([(b, !negative), (a, negative)]),
            Node::Negate(a) => open.push((a, !negative)),
            _ if dag.is_zero(expr) => {}
            _ => found.push(if negative { dag.negate(expr) } else { expr }),
        }
    }
    found
}

fn sum(dag: &mut Dag, a: Components, b: Components) -> Components {
    std::array::from_fn(|i| dag.add(a[i], b[i]))
}
