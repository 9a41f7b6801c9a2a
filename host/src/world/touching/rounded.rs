//! What can be touched in another scalar: every number rounded once.

use super::{Pairs, Touching};
use crate::world::rounding::{shape, vector};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::world::{Pair, Place, Thing};

impl Touching {
    /// The same, nothing touched yet.
    pub(in crate::world) fn rounded<S: Scalar>(&self) -> Touching<S> {
        let real = S::from_f64;
        let thing = |own: &Thing<f64>| match own {
            Thing::Rigid { shape: of, port, place } => Thing::Rigid {
                shape: shape(of),
                port: *port,
                place: Place { origin: vector(place.origin), axes: place.axes.map(vector) },
            },
            Thing::Mesh { nodes, facets, depth } => {
                Thing::Mesh { nodes: *nodes, facets: *facets, depth: real(*depth) }
            }
        };
        let pair = |own: &Pair<f64>| Pair {
            things: own.things,
            friction: real(own.friction),
            restitution: real(own.restitution),
            force: own.force.map(|law| law.rounded()),
        };
        let located = self.located.as_ref().map(|own| (own.kinds.clone(), own.method));
        let things = (self.things.iter().map(thing).collect(), self.of_parts.clone());
        let pairs = Pairs {
            pairs: self.pairs.iter().map(pair).collect(),
            parts: self.parts.clone(),
            moves: self.moves.clone(),
        };
        Touching::with(things, pairs, located, self.room.sizes())
    }
}
