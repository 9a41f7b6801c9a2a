//! The stage of a scene of format 1: a body of points, springs and facets over its ground.

use super::stage::Stage;
use crate::scene::read::Scene;
use serde_json::{Value, json};

/// The stage; positions in a row are those of the scene's points.
#[must_use]
pub fn stage(scene: &Scene) -> Stage {
    let n = scene.lists.points.len();
    // Point 0 of a film is the origin.
    let shown = |part: &str| !scene.view.hidden.contains(&part);
    let springs = scene.lists.springs.iter().zip(&scene.lists.rest_lengths);
    let edges: Vec<Value> = springs.map(|([a, b], rest)| json!([a + 1, b + 1, rest])).collect();
    let facets = scene.lists.facets.iter().filter(|_| shown("surface"));
    let facets: Vec<[usize; 4]> = facets.map(|f| f.map(|p| p + 1)).collect();
    let held: Vec<usize> =
        (0..n).filter(|i| scene.lists.fixed.get(*i).is_some_and(|f| *f)).map(|i| i + 1).collect();
    let ground = scene
        .around
        .ground
        .map(|g| json!({"normal": g.normal, "offset": g.offset, "shown": shown("ground")}));
    let grounds: Vec<Value> = ground.into_iter().collect();
    let hidden: Vec<usize> = (0..=n).filter(|i| *i == 0 || !shown("points")).collect();
    let colours: serde_json::Map<String, Value> =
        scene.view.colours.iter().map(|(part, rgb)| ((*part).to_owned(), json!(rgb))).collect();
    let names = std::iter::once("O".to_owned()).chain((0..n).map(|i| i.to_string()));
    Stage {
        fixed: json!({
            "points": names.collect::<Vec<_>>(),
            "links": [], "springs": [], "edges": edges, "facets": facets, "grounds": grounds,
            "hidden": hidden, "colours": colours, "held": held, "surfaces": [],
            "bones": if shown("springs") { "all" } else { "none" },
        }),
        bodies: Vec::new(),
        shapes: Vec::new(),
        gravity: Some(scene.around.gravity),
        moving: 3 * n,
        forces: shown("forces"),
    }
}
