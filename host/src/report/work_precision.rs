//! Work-precision diagram: error against cost, both logarithmic: a line per method with marks of its own, filled in
//! f64, open in f32, arms for other simulators, the Pareto front in amber.

use super::point::{Point, Section};
use crate::plot::chart::{line, text};
use crate::plot::drawing::{Anchor, Color, Drawing, INK, Item, PALE};

/// Colour behind the points of the front.
pub const FRONT: Color = [255, 196, 0];
/// Colours that most people can distinguish (Okabe & Ito 2008, then Tol), without the yellow.
const COLORS: [Color; 14] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [204, 121, 167],
    [86, 180, 233],
    [120, 60, 20],
    [110, 110, 110],
    [51, 34, 136],
    [170, 68, 85],
    [17, 119, 51],
    [136, 34, 85],
    [68, 170, 153],
    [153, 153, 51],
    [0, 0, 0],
];
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 470.0;
const LEFT: f64 = 92.0;
const RIGHT: f64 = 190.0;
const TOP: f64 = 48.0;
const BOTTOM: f64 = 64.0;
const SMALL: f64 = 14.0;
const LARGE: f64 = 16.0;
/// Half of a marker's width.
const MARK: f64 = 3.5;

/// A cost: the label of its axis and its value for a point.
type Cost = (&'static str, fn(&Point) -> Option<f64>);

/// Costs that a point may have.
pub const COSTS: [Cost; 2] = [
    ("computing time per simulated second [ns]", |p| Some(p.nanoseconds)),
    ("force evaluations per simulated second", |p| p.evaluations),
];

/// A logarithmic axis.
struct LogAxis {
    low: i32,
    high: i32,
    from: f64,
    to: f64,
}

impl LogAxis {
    fn around(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let logs = values.filter(|x| *x > 0.0 && x.is_finite()).map(f64::log10);
        let (low, high) = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        let (low, high) = if low <= high { (low.floor() as i32, high.ceil() as i32) } else { (0, 1) };
        Self { low, high: high.max(low + 1), from, to }
    }

    fn place(&self, value: f64) -> f64 {
        let share = (value.log10() - f64::from(self.low)) / f64::from(self.high - self.low);
        self.from + share * (self.to - self.from)
    }

    /// Powers of ten with a label, at least `apart` pixels apart.
    fn labelled(&self, apart: f64) -> Vec<i32> {
        let pixels = (self.to - self.from).abs() / f64::from(self.high - self.low);
        let every = (apart / pixels).ceil().max(1.0) as usize;
        (self.low..=self.high).step_by(every).collect()
    }
}

/// A plot whose points can be shown and hidden: the fixed part, and the points by method and scalar.
#[derive(Clone, Debug)]
pub struct Plot<'p> {
    /// Title, axes, front, legend.
    pub base: Drawing,
    /// Lines with their points.
    pub layers: Vec<Layer<'p>>,
}

/// The points of a method in one scalar.
#[derive(Clone, Debug)]
pub struct Layer<'p> {
    /// The method.
    pub method: &'p str,
    /// The scalar.
    pub scalar: &'p str,
    /// Lines and marks.
    pub items: Vec<Item>,
    /// Position of each point.
    pub places: Vec<((f64, f64), &'p Point)>,
}

/// The plot of a section over a cost as one drawing; `None` if no point has this cost.
#[must_use]
pub fn draw(section: &Section, cost: Cost) -> Option<Drawing> {
    let Plot { mut base, layers } = plot(section, cost)?;
    base.items.extend(layers.into_iter().flat_map(|layer| layer.items));
    Some(base)
}

/// The plot of a section over a cost; `None` if no point has this cost.
#[must_use]
pub fn plot(section: &Section, (label, cost): Cost) -> Option<Plot<'_>> {
    let points: Vec<(&Point, f64)> = section.points.iter().filter_map(|p| Some((p, cost(p)?))).collect();
    if points.is_empty() {
        return None;
    }
    let x = LogAxis::around(points.iter().map(|p| p.1), LEFT, WIDTH - RIGHT);
    let y = LogAxis::around(points.iter().map(|p| p.0.error), HEIGHT - BOTTOM, TOP);
    let title = format!("{}, {} s simulated", section.name, super::markdown::short(section.seconds));
    let mut items = vec![text((LEFT, TOP / 2.0), &title, LARGE, Anchor::Start)];
    grid(&x, &y, label, &mut items);
    front(&points, &x, &y, &mut items);
    let (mut methods, mut layers): (Vec<&str>, Vec<Layer<'_>>) = (Vec::new(), Vec::new());
    for (point, _) in &points {
        if !methods.contains(&point.method.as_str()) {
            methods.push(&point.method);
        }
    }
    for (n, method) in methods.iter().copied().enumerate() {
        let color = COLORS[n % COLORS.len()];
        for scalar in ["f64", "f32"] {
            let of_line = |p: &&(&Point, f64)| p.0.method == method && p.0.scalar == scalar;
            let places: Vec<((f64, f64), &Point)> =
                points.iter().filter(of_line).map(|(p, c)| ((x.place(*c), y.place(p.error)), *p)).collect();
            if places.is_empty() {
                continue;
            }
            let way = places.iter().map(|(at, _)| *at).collect();
            let mut items = vec![line(way, color, if scalar == "f64" { 1.6 } else { 0.8 })];
            let mark = Mark::of(n, scalar, is_peer(&points, method));
            places.iter().for_each(|(at, _)| items.extend(marker(*at, color, mark)));
            layers.push(Layer { method, scalar, items, places });
        }
        let at = (WIDTH - RIGHT + 18.0, TOP + 10.0 + 20.0 * n as f64);
        items.extend(marker(at, color, Mark::of(n, "f64", is_peer(&points, method))));
        items.push(text((at.0 + 12.0, at.1), method, SMALL, Anchor::Start));
    }
    legend(methods.len(), points.iter().any(|p| p.0.is_peer), &mut items);
    Some(Plot { base: Drawing { width: WIDTH as usize, height: HEIGHT as usize, items }, layers })
}

fn grid(x: &LogAxis, y: &LogAxis, label: &str, items: &mut Vec<Item>) {
    for power in y.labelled(24.0) {
        let at = y.place(10.0_f64.powi(power));
        items.push(line(vec![(x.from, at), (x.to, at)], PALE, 1.0));
        items.push(text((x.from - 8.0, at), &format!("1e{power}"), SMALL, Anchor::End));
    }
    for power in x.labelled(48.0) {
        let at = x.place(10.0_f64.powi(power));
        items.push(line(vec![(at, y.from), (at, y.to)], PALE, 1.0));
        items.push(text((at, y.from + 16.0), &format!("1e{power}"), SMALL, Anchor::Middle));
    }
    let corners = [(x.from, y.from), (x.to, y.from), (x.to, y.to), (x.from, y.to), (x.from, y.from)];
    items.push(line(corners.to_vec(), INK, 1.0));
    items.push(text((0.5 * (x.from + x.to), y.from + 44.0), label, LARGE, Anchor::Middle));
    let (at, size, anchor) = ((18.0, 0.5 * (y.from + y.to)), LARGE, Anchor::Middle);
    items.push(Item::Text { at, text: "largest error [m or rad]".to_owned(), size, anchor, upwards: true });
}

/// A band along the points of the front, behind everything.
fn front(points: &[(&Point, f64)], x: &LogAxis, y: &LogAxis, items: &mut Vec<Item>) {
    let mut places: Vec<(f64, f64)> =
        points.iter().filter(|p| p.0.front).map(|(p, c)| (x.place(*c), y.place(p.error))).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    for at in &places {
        items.push(line(vec![(at.0 - 7.0, at.1), (at.0 + 7.0, at.1)], FRONT, 14.0));
    }
    items.push(line(places, FRONT, 3.0));
}

fn legend(methods: usize, has_peers: bool, items: &mut Vec<Item>) {
    let (left, top) = (WIDTH - RIGHT + 18.0, TOP + 10.0 + 20.0 * methods as f64 + 14.0);
    let band = |y: f64| vec![line(vec![(left - 6.0, y), (left + 6.0, y)], FRONT, 12.0)];
    let mut rows = vec![
        (marker((left, top), INK, Mark::Full(1)), "f64"),
        (marker((left, top + 20.0), INK, Mark::Open(1)), "f32"),
        (band(top + 40.0), "front, by time"),
    ];
    if has_peers {
        rows.push((marker((left, top + 60.0), INK, Mark::Arms(0)), "other simulator"));
    }
    for (n, (mark, words)) in rows.into_iter().enumerate() {
        items.extend(mark);
        items.push(text((left + 14.0, top + 20.0 * n as f64), words, SMALL, Anchor::Start));
    }
}

/// Corners of the marks of our methods (degrees): shapes distinguish methods of similar colours.
const SHAPES: [&[f64]; 9] = [
    &[0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0, 210.0, 240.0, 270.0, 300.0, 330.0],
    &[45.0, 135.0, 225.0, 315.0],
    &[90.0, 210.0, 330.0],
    &[30.0, 150.0, 270.0],
    &[0.0, 90.0, 180.0, 270.0],
    &[0.0, 120.0, 240.0],
    &[60.0, 180.0, 300.0],
    &[18.0, 90.0, 162.0, 234.0, 306.0],
    &[20.0, 160.0, 200.0, 340.0],
];
/// Directions of the arms of marks for other simulators.
const ARMS: [&[f64]; 4] = [
    &[45.0, 135.0, 225.0, 315.0],
    &[0.0, 90.0, 180.0, 270.0],
    &[30.0, 90.0, 150.0, 210.0, 270.0, 330.0],
    &[90.0, 210.0, 330.0],
];

/// The mark of a point; the number is the method's.
#[derive(Clone, Copy)]
enum Mark {
    /// Filled: f64.
    Full(usize),
    /// Open: f32.
    Open(usize),
    /// Another simulator.
    Arms(usize),
}

impl Mark {
    fn of(number: usize, scalar: &str, is_peer: bool) -> Self {
        match scalar {
            _ if is_peer => Self::Arms(number),
            "f64" => Self::Full(number),
            _ => Self::Open(number),
        }
    }
}

fn is_peer(points: &[(&Point, f64)], method: &str) -> bool {
    points.iter().any(|p| p.0.is_peer && p.0.method == method)
}

fn marker((x, y): (f64, f64), color: Color, mark: Mark) -> Vec<Item> {
    let at = |angle: &f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        (x + 1.35 * MARK * cos, y - 1.35 * MARK * sin)
    };
    match mark {
        Mark::Full(n) => {
            vec![Item::Area { points: SHAPES[n % SHAPES.len()].iter().map(at).collect(), color }]
        }
        Mark::Open(n) => {
            let corners = SHAPES[n % SHAPES.len()];
            vec![line(corners.iter().chain(&corners[..2]).map(at).collect(), color, 1.4)]
        }
        Mark::Arms(n) => {
            let arms = ARMS[n % ARMS.len()].iter();
            arms.map(|angle| line(vec![(x, y), at(angle)], color, 2.0)).collect()
        }
    }
}
