//! The stage of a world: rigid parts as solids, flexible ones as springs and surfaces, half-spaces as grounds.
//!
//! Numbers of a row: positions of all points, part by part, then the x and y axes of all frames; the first row ends
//! with inertias, gravity and sizes. All as in [`Picture`].

use super::stage::{Solid, Stage};
use crate::world::Assembly;
use crate::world::assembly::{Kind, Mechanism, Rigid};
use crate::world::picture::Picture;
use serde_json::{Value, json};
use smartbed_runtime::surface::Shape;

/// The solids and surfaces collected so far.
#[derive(Default)]
struct Draft {
    names: Vec<String>,
    hidden: Vec<usize>,
    bodies: Vec<Solid>,
    shapes: Vec<(usize, Value, usize)>,
    links: Vec<Value>,
    springs: Vec<Value>,
    edges: Vec<Value>,
    facets: Vec<[usize; 4]>,
    /// Nodes that are attached to other parts.
    held: Vec<usize>,
    /// Parts with facets: name, first and last facet, the curve of the enclosed gas.
    surfaces: Vec<Value>,
    /// Half-spaces: normal, offset, and whether they are shown.
    grounds: Vec<Value>,
}

/// Options of `[view]` for a part.
#[derive(Clone, Copy)]
struct Look {
    is_hidden: bool,
    colour: Option<[u8; 3]>,
}

/// The stage.
#[must_use]
pub fn stage(assembly: &Assembly) -> Stage {
    let mut draft = Draft { names: vec!["O".to_owned()], hidden: vec![0], ..Draft::default() };
    let view = &assembly.view;
    for (number, part) in assembly.parts.iter().enumerate() {
        let look = Look { is_hidden: view.hidden.contains(&number), colour: view.colour(number) };
        match &part.kind {
            Kind::Rigid(rigid) => solid(&part.name, rigid, look, &mut draft),
            Kind::Flexible(body) => {
                let first = draft.names.len();
                let n = body.lists.points.len();
                draft.names.extend((0..n).map(|i| format!("{}.{i}", part.name)));
                draft.hidden.extend(first..first + n);
                if look.is_hidden {
                    continue;
                }
                let springs = body.lists.springs.iter().zip(&body.lists.rest_lengths);
                draft.edges.extend(springs.map(|([a, b], rest)| json!([a + first, b + first, rest])));
                let facets = draft.facets.len();
                draft.facets.extend(body.lists.facets.iter().map(|f| f.map(|p| p + first)));
                draft.held.extend(
                    (0..n).filter(|i| body.lists.fixed.get(*i).is_some_and(|f| *f)).map(|i| i + first),
                );
                let gauge = body.gas.map(|_| format!("{}.gauge", part.name));
                let to = draft.facets.len();
                draft.surfaces.push(json!({"name": part.name, "from": facets, "to": to, "gauge": gauge, "colour": look.colour}));
            }
            Kind::Mechanism(own) => mechanism(&part.name, own, look, &mut draft),
        }
    }
    let frames = draft.bodies.iter().filter(|body| body.has_frame).count();
    let moving = 3 * (draft.names.len() - 1) + 6 * frames;
    let fixed = json!({
        "points": draft.names, "hidden": draft.hidden, "links": draft.links, "springs": draft.springs, "edges": draft.edges,
        "facets": draft.facets, "held": draft.held, "surfaces": draft.surfaces, "grounds": draft.grounds, "colours": {},
        // The springs of a surface are not drawn: its colours show their strain.
        "bones": "bare",
        "paint": if view.by_pressure { "pressure" } else { "stretch" },
    });
    Stage {
        fixed,
        bodies: draft.bodies,
        shapes: draft.shapes,
        gravity: Some(assembly.gravity),
        moving,
        forces: !view.hides_forces,
    }
}

/// Adds the stage of a mechanism, with its indices shifted by those of the parts before it.
fn mechanism(name: &str, mechanism: &Mechanism, look: Look, draft: &mut Draft) {
    let own = Stage::of_model(&mechanism.model);
    let (first, solids) = (draft.names.len(), draft.bodies.len());
    let moved = |value: &Value| value.as_u64().map_or(Value::Null, |n| json!(n as usize + first));
    let list = |key: &str| own.fixed[key].as_array().cloned().unwrap_or_default();
    draft
        .names
        .extend(list("points").iter().map(|point| format!("{name}.{}", point.as_str().unwrap_or_default())));
    draft.hidden.push(first);
    draft.hidden.extend(list("hidden").iter().filter_map(|n| Some(n.as_u64()? as usize + first)));
    if look.is_hidden {
        draft.hidden.extend(first..draft.names.len());
    }
    let drawn = |key: &str| if look.is_hidden { Vec::new() } else { list(key) };
    draft.links.extend(drawn("links").iter().map(|ends| json!([moved(&ends[0]), moved(&ends[1])])));
    draft.springs.extend(drawn("springs").iter().map(|s| json!([moved(&s[0]), moved(&s[1]), s[2]])));
    draft.bodies.extend(own.bodies.iter().map(|body| {
        let (own, body) = (format!("{name}.{}", body.name), body.clone());
        Solid { name: own, centre: body.centre + first, is_hidden: look.is_hidden || body.is_hidden, ..body }
    }));
    draft.shapes.extend(own.shapes.iter().map(|(body, shape, count)| {
        let mut shape = shape.clone();
        shape["at"] = moved(&shape["at"]);
        (body + solids, shape, *count)
    }));
}

fn solid(name: &str, rigid: &Rigid, look: Look, draft: &mut Draft) {
    let mut add = |name: String, kind: &str, lengths: usize| {
        let centre = draft.names.len();
        draft.shapes.push((draft.bodies.len(), json!({"kind": kind, "axis": 2, "at": null}), lengths));
        draft.bodies.push(Solid {
            name: name.clone(),
            centre,
            has_frame: true,
            colour: look.colour,
            is_hidden: look.is_hidden,
        });
        draft.hidden.push(centre);
        draft.names.push(name);
    };
    match rigid.shape {
        Shape::HalfSpace => {
            let normal: [f64; 3] = rigid.start.attitude.axes()[2];
            let offset: f64 = (0..3).map(|i| normal[i] * rigid.start.position[i]).sum();
            draft.grounds.push(json!({"normal": normal, "offset": offset, "shown": !look.is_hidden}));
        }
        Shape::Sphere(_) => add(name.to_owned(), "ball", 1),
        Shape::Cuboid(_) => add(name.to_owned(), "box", 3),
        Shape::Capsule(_) => {
            add(name.to_owned(), "cylinder", 2);
            add(format!("{name} above"), "ball", 1);
            add(format!("{name} below"), "ball", 1);
        }
    }
}

/// The numbers of a row as the stage expects them.
#[must_use]
pub fn places(picture: &Picture, assembly: &Assembly) -> Vec<f64> {
    let mut places: Vec<f64> = picture.points.as_flattened().to_vec();
    places.extend(picture.axes.as_flattened().as_flattened());
    places.extend(picture.inertias.as_flattened());
    places.extend(assembly.gravity);
    places.extend(&picture.sizes);
    places
}
