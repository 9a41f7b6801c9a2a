//! The fixed part of a page's data: names, lines, solids, surfaces, grounds and gravity.

use super::ellipsoid;
use serde_json::{Value, json};
use smartbed_codegen::id::Id;
use smartbed_codegen::model::expression::ExprKind;
use smartbed_codegen::model::{Axis, LoadKind, Model, Shape, ShapeKind, Shown};

/// Count of numbers for a body's mass and inertia in a row.
pub(super) const INERTIA: usize = 7;

/// A body as the page receives it.
#[derive(Clone, Debug)]
pub(super) struct Solid {
    pub(super) name: String,
    /// Index of the point at its centre.
    pub(super) centre: usize,
    pub(super) has_frame: bool,
    pub(super) colour: Option<[u8; 3]>,
    pub(super) is_hidden: bool,
}

/// The stage of a model, a scene or a world.
#[derive(Clone, Debug)]
pub struct Stage {
    /// The page's data without solids.
    pub(super) fixed: Value,
    pub(super) bodies: Vec<Solid>,
    /// Bodies with a shape of their own: index, shape, count of lengths in the first row.
    pub(super) shapes: Vec<(usize, Value, usize)>,
    /// If `None`, gravity is part of the first row.
    pub(super) gravity: Option<[f64; 3]>,
    /// Count of the numbers in a row that move: positions of points, then the x and y axes of every body's frame.
    pub moving: usize,
    /// Are forces of contacts shown?
    pub(super) forces: bool,
}

impl Stage {
    /// For a model; positions in a row are those of [`crate::observers::Observers::places`].
    #[must_use]
    pub fn of_model(model: &Model) -> Self {
        let view = &model.view;
        let colour = |of: Shown| view.colours.iter().find(|(shown, _)| *shown == of).map(|(_, rgb)| *rgb);
        let hidden = |of: Shown| view.hidden.contains(&of);
        let springs = model.loads.iter().enumerate().filter_map(|(n, load)| match &load.kind {
            LoadKind::Spring { ends: [a, b], .. } if !hidden(Shown::Spring(n)) => {
                Some(json!([a.index(), b.index(), colour(Shown::Spring(n))]))
            }
            _ => None,
        });
        let solids = model.bodies.enumerate().map(|(id, body)| Solid {
            name: body.name.clone(),
            centre: body.centre.index(),
            has_frame: body.frame.is_some(),
            colour: colour(Shown::Body(id)),
            is_hidden: hidden(Shown::Body(id)),
        });
        let bodies: Vec<Solid> = solids.collect();
        let hidden_points: Vec<usize> = model
            .points
            .enumerate()
            .filter(|(id, _)| hidden(Shown::Point(*id)))
            .map(|(id, _)| id.index())
            .collect();
        let links = match &view.links {
            Some(links) => links.iter().map(|ends| ends.map(Id::index)).collect(),
            None => links(model)
                .into_iter()
                .filter(|ends| !ends.iter().any(|p| hidden_points.contains(p)))
                .collect(),
        };
        let links: Vec<[usize; 2]> = links;
        let shapes =
            view.shapes.iter().map(|(body, shape)| (body.index(), shape_json(shape), shape.sizes.len()));
        let frames = bodies.iter().filter(|b| b.has_frame).count();
        Self {
            fixed: json!({
                "points": model.points.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(),
                "hidden": hidden_points,
                "links": links,
                "springs": springs.collect::<Vec<_>>(),
                "edges": [], "facets": [], "held": [], "surfaces": [], "bones": "all", "grounds": [], "colours": {},
            }),
            bodies,
            shapes: shapes.collect(),
            gravity: None,
            moving: 3 * (model.points.len() - 1) + 6 * frames,
            forces: false,
        }
    }

    /// Are forces of contacts shown?
    #[must_use]
    pub fn has_forces(&self) -> bool {
        self.forces
    }

    /// The page's data; `first` is the first row.
    #[must_use]
    pub fn data(&self, first: &[f64]) -> Value {
        let (mut turns, mut bodies) = (0, Vec::new());
        for (n, Solid { name, centre, has_frame, colour, is_hidden }) in self.bodies.iter().enumerate() {
            let turn = has_frame.then(|| turns);
            turns += usize::from(*has_frame);
            let at = self.moving + INERTIA * n;
            let numbers: Option<[f64; INERTIA]> = first.get(at..at + INERTIA).and_then(|s| s.try_into().ok());
            let solid = numbers.and_then(|[mass, xx, yy, zz, xy, xz, yz]| {
                ellipsoid::of(mass, [xx, yy, zz, xy, xz, yz]).filter(|_| *has_frame)
            });
            let (sizes, axes) = solid.map_or((Value::Null, Value::Null), |(s, a)| (json!(s), json!(a)));
            bodies.push(json!({
                "name": name, "centre": centre, "turn": turn, "sizes": sizes, "axes": axes, "shape": null,
                "colour": colour, "hidden": is_hidden,
            }));
        }
        let tail = first.get(self.moving + INERTIA * self.bodies.len()..).unwrap_or_default();
        let gravity = self.gravity.or_else(|| tail.get(..3)?.try_into().ok());
        let mut lengths = tail.get(3..).unwrap_or_default();
        for (body, shape, count) in &self.shapes {
            let (own, rest) = lengths.split_at_checked(*count).unwrap_or_default();
            lengths = rest;
            let mut shape = shape.clone();
            shape["sizes"] = json!(own);
            bodies[*body]["shape"] = shape;
        }
        let mut data = self.fixed.clone();
        data["bodies"] = Value::Array(bodies);
        data["gravity"] = json!(gravity);
        data
    }
}

/// A shape without its lengths, as JSON.
fn shape_json(shape: &Shape) -> Value {
    let kind = match shape.kind {
        ShapeKind::Box => "box",
        ShapeKind::Cylinder => "cylinder",
        ShapeKind::Ball => "ball",
    };
    let axis = match shape.axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    };
    json!({"kind": kind, "axis": axis, "at": shape.at.map(Id::index)})
}

/// Pairs of points: each point with those that its position's expression names, or with the origin if it names none.
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
