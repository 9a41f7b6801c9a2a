//! What stands on the stage: names, lines, solids, surfaces, ground and gravity. Numbers that do not move.

use super::ellipsoid;
use crate::scene::read::Scene;
use serde_json::{Value, json};
use smartbed_codegen::id::Id;
use smartbed_codegen::model::expression::ExprKind;
use smartbed_codegen::model::{LoadKind, Model};

/// Numbers of a body's mass and inertia among the places of a row.
const INERTIA: usize = 7;

/// The stage of a model or scene.
#[derive(Clone, Debug)]
pub struct Stage {
    /// What the page reads, but for solids.
    fixed: Value,
    /// Bodies: name, number of the centre's point, has it a frame?
    bodies: Vec<(String, usize, bool)>,
    /// Gravity stands in the first row, too.
    gravity: Option<[f64; 3]>,
    /// Numbers of a row that move: places of points, then x and y of every body's frame.
    pub moving: usize,
}

impl Stage {
    /// For a model; a row's places are those of [`crate::run::observers::Observers::places`].
    #[must_use]
    pub fn of_model(model: &Model) -> Self {
        let springs = model.loads.iter().filter_map(|load| match &load.kind {
            LoadKind::Spring { ends: [a, b], .. } => Some([a.index(), b.index()]),
            _ => None,
        });
        let body = |b: &smartbed_codegen::model::Body| (b.name.clone(), b.centre.index(), b.frame.is_some());
        let bodies: Vec<_> = model.bodies.iter().map(body).collect();
        let frames = bodies.iter().filter(|b| b.2).count();
        Self {
            fixed: json!({
                "points": model.points.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(),
                "links": links(model),
                "springs": springs.collect::<Vec<_>>(),
                "edges": [], "facets": [], "ground": null,
            }),
            bodies,
            gravity: None,
            moving: 3 * (model.points.len() - 1) + 6 * frames,
        }
    }

    /// For a scene; a row's places are those of its points.
    #[must_use]
    pub fn of_scene(scene: &Scene) -> Self {
        let n = scene.lists.points.len();
        // Point 0 of a film is the origin.
        let springs = scene.lists.springs.iter().zip(&scene.lists.rest_lengths);
        let edges: Vec<Value> = springs.map(|([a, b], rest)| json!([a + 1, b + 1, rest])).collect();
        let facets: Vec<[usize; 4]> = scene.lists.facets.iter().map(|f| f.map(|p| p + 1)).collect();
        let ground = scene.around.ground.map(|g| json!({"normal": g.normal, "offset": g.offset}));
        let names = std::iter::once("O".to_owned()).chain((0..n).map(|i| i.to_string()));
        Self {
            fixed: json!({
                "points": names.collect::<Vec<_>>(),
                "links": [], "springs": [], "edges": edges, "facets": facets, "ground": ground,
            }),
            bodies: Vec::new(),
            gravity: Some(scene.around.gravity),
            moving: 3 * n,
        }
    }

    /// As the page reads it; `first` is the first row's places.
    #[must_use]
    pub fn data(&self, first: &[f64]) -> Value {
        let (mut turns, mut bodies) = (0, Vec::new());
        for (n, (name, centre, has_frame)) in self.bodies.iter().enumerate() {
            let turn = has_frame.then(|| turns);
            turns += usize::from(*has_frame);
            let at = self.moving + INERTIA * n;
            let numbers: Option<[f64; INERTIA]> = first.get(at..at + INERTIA).and_then(|s| s.try_into().ok());
            let solid = numbers.and_then(|[mass, xx, yy, zz, xy, xz, yz]| {
                ellipsoid::of(mass, [xx, yy, zz, xy, xz, yz]).filter(|_| *has_frame)
            });
            let (sizes, axes) = solid.map_or((Value::Null, Value::Null), |(s, a)| (json!(s), json!(a)));
            bodies.push(json!({"name": name, "centre": centre, "turn": turn, "sizes": sizes, "axes": axes}));
        }
        let tail = first.get(self.moving + INERTIA * self.bodies.len()..);
        let gravity = self.gravity.or_else(|| tail.and_then(|t| t.try_into().ok()));
        let mut data = self.fixed.clone();
        data["bodies"] = Value::Array(bodies);
        data["gravity"] = json!(gravity);
        data
    }
}

/// Pairs of points: each with those that its expressions name, the origin where they name none.
fn links(model: &Model) -> Vec<[usize; 2]> {
    let mut links = Vec::new();
    for (id, point) in model.points.enumerate().skip(1) {
        for expression in std::iter::once(&point.position).chain(&point.closures) {
            let mut from = Vec::new();
            expression.visit(&mut |e| {
                if let ExprKind::Point(other) = e.kind {
                    from.push(other.index());
                }
            });
            if from.is_empty() {
                from.push(0);
            }
            for other in from {
                let link = [other, id.index()];
                if !links.contains(&link) {
                    links.push(link);
                }
            }
        }
    }
    links
}
