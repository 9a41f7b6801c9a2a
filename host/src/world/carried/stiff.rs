//! The largest step that resolves the springs of penalty contacts.
//!
//! In: pairs whose force rises with the depth at once. Out: for each the bound 2/w of explicit methods, k that slope,
//! ```text
//! w^2 <= k sum over sides of (points that push it at once) (largest 1/m of its points),  1/m = n.W M^-1 W'n
//! ```
//! plus that of the springs of a flexible side. A Hunt-Crossley force has no such bound before its depth is known.

use super::stable::refuse_larger;
use super::{CarriedWorld, words};
use crate::failure::Failure;
use crate::world::assembly::Assembly;
use smartbed_runtime::surface::Shape;
use smartbed_runtime::vec3;
use smartbed_runtime::world::{Carrier, Group, InverseInertia, Thing};

impl CarriedWorld {
    /// Refuses a step that is too long for the contact of a pair.
    pub(super) fn refuse_stiff_pairs(&mut self, assembly: &Assembly) -> Result<(), Failure> {
        let Some(touching) = self.touching.take() else { return Ok(()) };
        let mut least: Option<(f64, usize)> = None;
        for (number, pair) in touching.pairs.iter().enumerate() {
            let stiffness = pair.force.map_or(0.0, |law| law.slope(0.0));
            if stiffness <= 0.0 {
                continue;
            }
            let things = pair.things.map(|thing| touching.things[thing]);
            let mut square = 0.0;
            for (own, other) in [(&things[0], &things[1]), (&things[1], &things[0])] {
                square += stiffness * self.lightest(own)? * points(own, other);
                if matches!(own, Thing::Mesh { .. }) {
                    square += self.stable.map_or(0.0, |step| (2.0 / step).powi(2));
                }
            }
            let step = 2.0 / square.sqrt();
            if least.is_none_or(|(least, _)| step < least) {
                least = Some((step, number));
            }
        }
        self.touching = Some(touching);
        let Some((largest, number)) = least else { return Ok(()) };
        let [one, other] = assembly.contacts[number].between.map(|part| &self.names[part]);
        let who = format!("the contact of `{one}` and `{other}`");
        refuse_larger(assembly, (largest, &who), assembly.places.contact(number))?;
        self.stable = Some(self.stable.map_or(largest, |stable| stable.min(largest)));
        Ok(())
    }

    /// The largest inverse mass of a point of a thing (1/kg); 0 for one that nothing moves.
    fn lightest(&mut self, thing: &Thing<f64>) -> Result<f64, String> {
        match thing {
            Thing::Mesh { nodes: [first, end], .. } => Ok(self.fixed.inverse_mass[*first..*end]
                .iter()
                .map(|[inverse, ..]| *inverse)
                .fold(0.0, f64::max)),
            Thing::Rigid { port: None, .. } => Ok(0.0),
            Thing::Rigid { shape, port: Some(port), place } => {
                // The normal of a ball leads through its centre.
                let own = if let Shape::Sphere(_) = shape { 0.0 } else { shape.reach().unwrap_or(0.0) };
                let arm = vec3::norm(place.origin) + own;
                let [q, u] = self.of_carriers(&self.x).map(<[f64]>::to_vec);
                let mut group = Group { members: &mut self.carriers };
                if !group.coupled(*port).contains(port) {
                    return Ok(0.0);
                }
                let inverse = group.inverse_inertia(0.0, &q, &u, [*port; 2]).map_err(words)?;
                Ok(block(&inverse, [0, 0])
                    + 2.0 * arm * block(&inverse, [0, 3])
                    + arm * arm * block(&inverse, [3, 3]))
            }
        }
    }
}

/// Points of the other thing that may push this one at once.
fn points(own: &Thing<f64>, other: &Thing<f64>) -> f64 {
    match (own, other) {
        (Thing::Mesh { .. }, _) => 1.0,
        (_, Thing::Mesh { nodes: [first, end], .. }) => (end - first) as f64,
        (Thing::Rigid { shape, .. }, Thing::Rigid { shape: other, .. }) => {
            let count = |shape: &Shape<f64>| match shape {
                Shape::Sphere(_) => 1.0,
                Shape::Capsule(_) => 2.0,
                Shape::Cuboid(_) | Shape::HalfSpace => 4.0,
            };
            f64::min(count(shape), count(other))
        }
    }
}

/// Largest row sum of a 3 x 3 block: no less than its largest eigenvalue.
fn block(inverse: &InverseInertia<f64>, [row, column]: [usize; 2]) -> f64 {
    let sums = (0..3).map(|i| (0..3).map(|j| inverse[row + i][column + j].abs()).sum());
    sums.fold(0.0, f64::max)
}
