//! A world from the side: at the start, at the first touch, at the end.
//!
//! In: the stage, and rows' places as it expects them. Out: lines in space for [`crate::plot::side`]. Springs between
//! masses have the colour of their strain; mechanisms are their links, rigid parts their outlines.

use super::stage::Stage;
use crate::plot::drawing::{Color, Drawing, INK};
use crate::plot::side::{self, Ground, Moment, Stroke, strain_color};
use serde_json::Value;
use smartbed_runtime::vec3::{axpy, cross, norm, sub};
use std::f64::consts::TAU;

/// Straight lines of a circle.
const SIDES: usize = 48;
/// Links of mechanisms; rigid parts.
const LINK: Color = [90, 90, 90];
const SOLID: Color = [0, 90, 130];

/// A moment's places.
#[derive(Clone, Debug)]
struct Frame {
    time: f64,
    places: Vec<f64>,
}

/// The moments, as far as a run has come.
#[derive(Clone, Debug)]
pub struct Sides {
    stage: Stage,
    start: Option<Frame>,
    touch: Option<Frame>,
    end: Option<Frame>,
}

impl Sides {
    /// None yet.
    #[must_use]
    pub fn new(stage: Stage) -> Self {
        Self { stage, start: None, touch: None, end: None }
    }

    /// Is a row drawn, and are its places needed? `touches`: parts have touched so far.
    #[must_use]
    pub fn wants(&self, touches: bool, is_last: bool) -> bool {
        is_last || self.start.is_none() || touches && self.touch.is_none()
    }

    /// Takes a row that it wants: its time, places, and whether parts have touched so far.
    pub fn push(&mut self, time: f64, places: Vec<f64>, touches: bool) {
        let frame = Frame { time, places };
        if self.start.is_none() {
            self.start = Some(frame.clone());
        }
        if self.touch.is_none() && touches {
            self.touch = Some(frame.clone());
        }
        self.end = Some(frame);
    }

    /// All of them; none where nothing is to be seen.
    #[must_use]
    pub fn draw(&self) -> Option<Drawing> {
        // A start or an end at the same time says more than that something touches then.
        let others = [&self.start, &self.end].map(|frame| frame.as_ref().map(|f| f.time));
        let touch = self.touch.as_ref().filter(|f| !others.contains(&Some(f.time)));
        let named = [("start", self.start.as_ref()), ("first touch", touch), ("end", self.end.as_ref())];
        let moments: Vec<Moment> = named
            .into_iter()
            .filter_map(|(name, frame)| {
                let frame = frame?;
                Some(Moment { name, time: frame.time, strokes: strokes(&self.stage, &frame.places) })
            })
            .collect();
        let grounds = grounds(&self.stage.fixed["grounds"]);
        let is_empty = moments.iter().all(|moment| moment.strokes.is_empty());
        (!is_empty).then(|| side::draw("From the side", &grounds, &moments))
    }
}

/// The planes that are not hidden.
fn grounds(told: &Value) -> Vec<Ground> {
    let shown = told.as_array().into_iter().flatten().filter(|plane| plane["shown"] != false);
    shown
        .filter_map(|plane| {
            let normal: Vec<f64> = plane["normal"].as_array()?.iter().filter_map(Value::as_f64).collect();
            Some(Ground { normal: normal.try_into().ok()?, offset: plane["offset"].as_f64()? })
        })
        .collect()
}

/// Lines of a row.
fn strokes(stage: &Stage, places: &[f64]) -> Vec<Stroke> {
    // The origin is a point that no row tells.
    let point = |number: usize| -> Option<[f64; 3]> {
        if number == 0 {
            return Some([0.0; 3]);
        }
        places.get(3 * (number - 1)..3 * number)?.try_into().ok()
    };
    let entries = |key: &str| stage.fixed[key].as_array().cloned().unwrap_or_default();
    let ends = |entry: &Value| {
        let end = |n: usize| point(usize::try_from(entry[n].as_u64()?).ok()?);
        Some([end(0)?, end(1)?])
    };
    let mut strokes = Vec::new();
    for edge in entries("edges") {
        if let (Some([a, b]), Some(rest)) = (ends(&edge), edge[2].as_f64()) {
            let strain = if rest > 0.0 { norm(sub(b, a)) / rest - 1.0 } else { 0.0 };
            strokes.push(Stroke { points: vec![a, b], color: strain_color(strain), width: 1.0 });
        }
    }
    for (key, color) in [("links", LINK), ("springs", INK)] {
        let links = entries(key);
        let links = links.iter().filter_map(ends);
        strokes.extend(links.map(|ends| Stroke { points: ends.to_vec(), color, width: 1.6 }));
    }
    for (number, shape) in solids(stage, places) {
        let solid = &stage.bodies[number];
        let Some(centre) = point(shape.at).filter(|_| !solid.is_hidden) else { continue };
        let color = solid.colour.unwrap_or(SOLID);
        strokes.extend(outline(&shape, centre).into_iter().map(|points| Stroke {
            points,
            color,
            width: 1.6,
        }));
    }
    strokes
}

/// A shape with its lengths and axes.
struct Outlined<'a> {
    kind: &'a str,
    /// Number of the point in its middle.
    at: usize,
    axes: [[f64; 3]; 3],
    sizes: &'a [f64],
}

/// Bodies with a shape of their own.
fn solids<'a>(stage: &'a Stage, places: &'a [f64]) -> Vec<(usize, Outlined<'a>)> {
    let frames = stage.bodies.iter().filter(|body| body.has_frame).count();
    let first = stage.moving - 6 * frames;
    let mut lengths =
        places.get(stage.moving + super::stage::INERTIA * stage.bodies.len() + 3..).unwrap_or_default();
    let mut found = Vec::new();
    for (body, shape, count) in &stage.shapes {
        let (sizes, rest) = lengths.split_at_checked(*count).unwrap_or_default();
        lengths = rest;
        let turn = stage.bodies[..*body].iter().filter(|body| body.has_frame).count();
        let numbers = places.get(first + 6 * turn..first + 6 * turn + 6).unwrap_or_default();
        let ([x0, x1, x2, y0, y1, y2], Some(kind)) = (numbers, shape["kind"].as_str()) else { continue };
        let (x, y) = ([*x0, *x1, *x2], [*y0, *y1, *y2]);
        let mut axes = [x, y, cross(x, y)];
        // The shape's own axis comes last.
        let along = shape["axis"].as_u64().and_then(|axis| usize::try_from(axis).ok()).unwrap_or(2);
        if kind == "cylinder" {
            axes.rotate_left((along + 1) % 3);
        }
        let at = shape["at"].as_u64().and_then(|at| usize::try_from(at).ok());
        let at = at.unwrap_or(stage.bodies[*body].centre);
        found.push((*body, Outlined { kind, at, axes, sizes }));
    }
    found
}

/// Lines of a shape about its centre.
fn outline(shape: &Outlined<'_>, centre: [f64; 3]) -> Vec<Vec<[f64; 3]>> {
    let at = |x: f64, y: f64, z: f64| {
        let [e1, e2, e3] = shape.axes;
        axpy(axpy(axpy(centre, x, e1), y, e2), z, e3)
    };
    let circle = |radius: f64, place: &dyn Fn(f64, f64) -> [f64; 3]| -> Vec<[f64; 3]> {
        let angle = |n: usize| TAU * n as f64 / SIDES as f64;
        (0..=SIDES).map(|n| place(radius * angle(n).cos(), radius * angle(n).sin())).collect()
    };
    match (shape.kind, shape.sizes) {
        // What is round from all sides is drawn as it is seen along y.
        ("ball", [radius, ..]) => {
            vec![circle(*radius, &|u, v| axpy(axpy(centre, u, [1.0, 0.0, 0.0]), v, [0.0, 0.0, 1.0]))]
        }
        ("cylinder", [radius, length, ..]) => {
            let half = 0.5 * length;
            let rims = [-half, half].map(|z| circle(*radius, &|u, v| at(u, v, z)));
            let sides = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)];
            let sides =
                sides.map(|(u, v)| vec![at(radius * u, radius * v, -half), at(radius * u, radius * v, half)]);
            rims.into_iter().chain(sides).collect()
        }
        ("box", [x, y, z, ..]) => {
            let (x, y, z) = (0.5 * x, 0.5 * y, 0.5 * z);
            let ring =
                |z: f64| [(-x, -y), (x, -y), (x, y), (-x, y), (-x, -y)].map(|(x, y)| at(x, y, z)).to_vec();
            let uprights = [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| vec![at(x, y, -z), at(x, y, z)]);
            [ring(-z), ring(z)].into_iter().chain(uprights).collect()
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn only_rows_that_are_drawn_are_wanted() {
        let fixed = json!({ "grounds": [] });
        let stage =
            Stage { fixed, bodies: Vec::new(), shapes: Vec::new(), gravity: None, moving: 3, forces: false };
        let mut sides = Sides::new(stage);
        let mut wanted = Vec::new();
        for row in 0..=100 {
            let touches = row >= 40;
            if sides.wants(touches, row == 100) {
                sides.push(f64::from(row), vec![0.0; 3], touches);
                wanted.push(row);
            }
        }
        assert_eq!(wanted, [0, 40, 100]);
        let times = [&sides.start, &sides.touch, &sides.end].map(|frame| frame.as_ref().map(|f| f.time));
        assert_eq!(times, [Some(0.0), Some(40.0), Some(100.0)]);
    }

    #[test]
    fn outlines_lie_on_their_shapes() {
        let axes = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
        let centre = [1.0, 2.0, 3.0];
        let points =
            |kind: &str, sizes: &[f64]| outline(&Outlined { kind, at: 0, axes, sizes }, centre).concat();
        assert!(points("ball", &[0.5]).iter().all(|p| (norm(sub(*p, centre)) - 0.5).abs() < 1e-12));
        // The axis is x: two rims at 1 -+ 0.4, all at a radius of 0.1 about it.
        for p in points("cylinder", &[0.1, 0.8]) {
            let [along, y, z] = sub(p, centre);
            assert!((along.abs() - 0.4).abs() < 1e-12 && (y.hypot(z) - 0.1).abs() < 1e-12, "{p:?}");
        }
        // Half lengths along the box's own axes, which are y, z, x of space.
        let corners = points("box", &[0.2, 0.4, 0.6]);
        assert_eq!(corners.len(), 10 + 8);
        for p in corners {
            let [z, x, y] = sub(p, centre).map(f64::abs);
            assert!((x - 0.1).abs() < 1e-12 && (y - 0.2).abs() < 1e-12 && (z - 0.3).abs() < 1e-12, "{p:?}");
        }
    }
}
