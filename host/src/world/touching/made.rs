//! Things and pairs of a world, made of its text.
//!
//! In: the assembly's contacts, and the role of each part in them. Out: [`Touching`] before the first step.

use super::{Pairs, Touchable, Touching};
use crate::world::assembly::{Assembly, Kind, Law, mixed};
use smartbed_runtime::ode::Method;
use smartbed_runtime::rigid::law::Kind as Impact;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{Pair, Place, Thing};

/// Largest depth below a facet at which contact is detected, as a fraction of a body's thickness, or of the size of two
/// facets.
const DEPTH: f64 = 0.25;

impl Touching {
    /// For the assembly's contacts, whose text has been checked; `of` gives the role of each part, `size` the numbers of
    /// ports, nodes, answers and state values.
    pub(in crate::world) fn new(
        assembly: &Assembly,
        of: &[Touchable],
        size: [usize; 4],
        method: Method,
    ) -> Result<Self, String> {
        let (mut things, mut numbers) = (Vec::new(), vec![usize::MAX; of.len()]);
        for (number, (part, touchable)) in assembly.parts.iter().zip(of).enumerate() {
            let thing = match (touchable, &part.kind) {
                (Touchable::Shape(port, frame), Kind::Rigid(rigid)) => Thing::Rigid {
                    shape: rigid.shape,
                    port: *port,
                    place: Place { origin: frame.origin, axes: frame.axes },
                },
                (Touchable::Mesh(nodes, facets), Kind::Flexible(body)) => Thing::Mesh {
                    nodes: [nodes.start, nodes.end],
                    facets: [facets.start, facets.end],
                    depth: depth(&body.lists.points, &body.lists.facets),
                },
                _ => continue,
            };
            numbers[number] = things.len();
            things.push(thing);
        }
        let (mut pairs, mut kinds) = (Vec::new(), Vec::new());
        for contact in &assembly.contacts {
            let things_of = contact.between.map(|part| numbers[part]);
            if let Some(k) = (0..2).find(|k| things_of[*k] == usize::MAX) {
                let name = &assembly.parts[contact.between[k]].name;
                return Err(format!("`{name}` is a mechanism, which has no surface"));
            }
            pairs.push(match contact.law {
                Law::Moreau { restitution, friction } => Pair::striking(things_of, restitution, friction),
                Law::Located(law) => {
                    kinds.push(law.kind());
                    Pair::striking(things_of, law.restitution(), law.friction())
                }
                Law::Force(law) => {
                    // Nothing strikes there: no one asks for a law of impact.
                    kinds.push(Impact::Stronge);
                    Pair::yielding(things_of, law)
                }
            });
        }
        if mixed(&assembly.contacts).is_some() {
            return Err("some contacts have impact = \"moreau\", others another law".to_owned());
        }
        let parts = assembly.contacts.iter().map(|contact| contact.between).collect();
        let moves =
            assembly.contacts.iter().map(|c| c.between.map(|n| assembly.parts[n].can_move())).collect();
        let of_parts = numbers.into_iter().map(|n| (n != usize::MAX).then_some(n)).collect();
        let located = (!kinds.is_empty()).then_some((kinds, method));
        Ok(Self::with((things, of_parts), Pairs { pairs, parts, moves }, located, size))
    }
}

/// Largest depth below a facet of a body at which contact is detected.
fn depth(points: &[Vec3<f64>], facets: &[[usize; 4]]) -> f64 {
    let (mut low, mut high, mut edges) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3], (0.0, 0));
    for facet in facets {
        let [a, b, ..] = facet.map(|node| points[node]);
        edges = (edges.0 + (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt(), edges.1 + 1);
        for point in facet.map(|node| points[node]) {
            (0..3).for_each(|i| (low[i], high[i]) = (low[i].min(point[i]), high[i].max(point[i])));
        }
    }
    let mean = edges.0 / f64::from(edges.1.max(1));
    let thick = (0..3).map(|i| high[i] - low[i]).filter(|x| *x > 1e-9 * mean).fold(f64::INFINITY, f64::min);
    DEPTH * thick.min(2.0 * mean)
}
