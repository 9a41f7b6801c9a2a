//! `--view`: a mechanism in motion as one HTML page without any outside resource.
//!
//! In: places of all points over time. Out: a page that draws, on a canvas, the points and the lines
//! between them: from each point to those that its position is counted from, and along springs.

use crate::number::json_string;
use smartbed_codegen::id::Id;
use smartbed_codegen::model::expression::ExprKind;
use smartbed_codegen::model::{LoadKind, Model, PointId};
use std::fmt::Write as _;

/// Frames kept; beyond twice as many every second one is dropped.
const KEPT: usize = 600;
/// The page; `DATA` and `TITLE` are put in.
const PAGE: &str = include_str!("page.html");

/// Frames of an animation, thinned out as they become many.
#[derive(Clone, Debug)]
pub struct Film {
    names: Vec<String>,
    bodies: Vec<bool>,
    links: Vec<[usize; 2]>,
    springs: Vec<[usize; 2]>,
    frames: Vec<(f64, Vec<f64>)>,
    stride: usize,
    seen: usize,
}

impl Film {
    /// For a model; places come in the order of its points without the origin.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        let centres: Vec<PointId> = model.bodies.iter().map(|b| b.centre).collect();
        let springs = model.loads.iter().filter_map(|load| match &load.kind {
            LoadKind::Spring { ends: [a, b], .. } => Some([a.index(), b.index()]),
            _ => None,
        });
        Self {
            names: model.points.iter().map(|p| p.name.clone()).collect(),
            bodies: model.points.ids().map(|id| centres.contains(&id)).collect(),
            links: links(model),
            springs: springs.collect(),
            frames: Vec::new(),
            stride: 1,
            seen: 0,
        }
    }

    /// For a body of `n` points and its springs, drawn as lines; places come in the points' order.
    #[must_use]
    pub fn of_points(n: usize, springs: Vec<[usize; 2]>) -> Self {
        // Point 0 of a film is the origin.
        let links = springs.into_iter().map(|[a, b]| [a + 1, b + 1]).collect();
        let names = std::iter::once("O".to_owned()).chain((0..n).map(|i| i.to_string())).collect();
        let bodies = vec![false; n + 1];
        Self { names, bodies, links, springs: Vec::new(), frames: Vec::new(), stride: 1, seen: 0 }
    }

    /// Adds a frame: time, and x, y, z of every point but the origin.
    pub fn push(&mut self, t: f64, places: &[f64]) {
        if self.seen.is_multiple_of(self.stride) {
            self.frames.push((t, places.to_vec()));
        }
        self.seen += 1;
        if self.frames.len() > 2 * KEPT {
            self.stride *= 2;
            let mut n = 0;
            self.frames.retain(|_| {
                n += 1;
                n % 2 == 1
            });
        }
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

/// The page's text.
#[must_use]
pub fn page(title: &str, film: &Film) -> String {
    let list = |items: Vec<String>| format!("[{}]", items.join(","));
    let pairs = |links: &[[usize; 2]]| list(links.iter().map(|[a, b]| format!("[{a},{b}]")).collect());
    let mut frames = String::from("[");
    for (n, (t, places)) in film.frames.iter().enumerate() {
        let separator = if n == 0 { "" } else { ",\n" };
        // Six digits are finer than any screen; what is not finite is drawn at the origin.
        let numbers = places.iter().map(|x| if x.is_finite() { format!("{x:.5e}") } else { "0".to_owned() });
        let _ = write!(frames, "{separator}[{t:.6e},{}]", list(numbers.collect()));
    }
    frames.push(']');
    let data = format!(
        "{{\"names\":{},\"bodies\":{},\"links\":{},\"springs\":{},\"frames\":{frames}}}",
        list(film.names.iter().map(|n| json_string(n)).collect()),
        list(film.bodies.iter().map(bool::to_string).collect()),
        pairs(&film.links),
        pairs(&film.springs),
    );
    // `</` would end the script that the data stand in.
    PAGE.replace("TITLE", &title.replace('&', "&amp;").replace('<', "&lt;"))
        .replace("DATA", &data.replace("</", "<\\/"))
}
