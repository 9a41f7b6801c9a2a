//! Pictures of a body from the side: at the start, at the first touch, at the largest compression of a spring, at the
//! end.
//!
//! In: rows, one after the other. Out: four pictures side by side at one scale, in metres on both axes. Projection: to
//! the right x + 0.35 y, so that a body's depth shows; upwards z plus the multiple of y for which the ground appears as
//! a line, so that every point is above it by its distance along z. A plane body stays plane. Springs are grey at rest
//! length, vermilion if stretched, blue if compressed.

use super::read::Scene;
use super::run::Row;
use crate::plot::Axis;
use crate::plot::chart::{SMALL, line, text};
use crate::plot::drawing::{Anchor, Color, Drawing, INK, Item, PALE};
use smartbed_runtime::contact::Ground;

/// Displacement to the right per metre of depth.
const DEPTH: f64 = 0.35;
/// Strain shown in full colour.
const FULL_STRAIN: f64 = 0.1;
const WIDTH: f64 = 1000.0;
const LEFT: f64 = 110.0;
const BETWEEN: f64 = 24.0;
/// Least distance of a tick's label from the edge.
const EDGE: f64 = 6.0;
const TOP: f64 = 60.0;
const BOTTOM: f64 = 60.0;
/// Least and largest height of a picture.
const HEIGHT: [f64; 2] = [160.0, 420.0];

/// The projection: displacement to the right and upwards per metre of depth.
#[derive(Clone, Copy, Debug)]
struct Projection {
    depth: [f64; 2],
}

impl Projection {
    /// The one for which the ground appears as a line: up = -(nx right + ny)/nz.
    fn along(ground: Option<&Ground<f64>>) -> Self {
        let rise = ground.map_or(0.0, |g| {
            let [nx, ny, nz] = g.normal;
            (ny + DEPTH * -nx) / nz
        });
        Self { depth: [DEPTH, rise] }
    }

    fn place(&self, p: &[f64; 3]) -> (f64, f64) {
        (p[0] + self.depth[0] * p[1], p[2] + self.depth[1] * p[1])
    }
}

/// A body at one time.
#[derive(Clone, Debug)]
struct Frame {
    time: f64,
    pos: Vec<[f64; 3]>,
}

/// The four pictures, as far as the run has reached them.
#[derive(Clone, Debug)]
pub struct Pictures {
    springs: Vec<[usize; 2]>,
    rest_lengths: Vec<f64>,
    least: f64,
    start: Option<Frame>,
    touch: Option<Frame>,
    compressed: Option<Frame>,
    end: Option<Frame>,
}

impl Pictures {
    /// Without pictures.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let (springs, rest_lengths) = (scene.lists.springs.clone(), scene.lists.rest_lengths.clone());
        let least = f64::INFINITY;
        Self { springs, rest_lengths, least, start: None, touch: None, compressed: None, end: None }
    }

    /// Records a row if it is the first, the first after a touch, the most compressed, or the last.
    pub fn push(&mut self, row: &Row) {
        let frame = || Some(Frame { time: row.t, pos: row.pos.clone() });
        if self.start.is_none() {
            self.start = frame();
        }
        if self.touch.is_none() && row.touches > 0 {
            self.touch = frame();
        }
        let strains = (0..self.springs.len()).map(|s| self.strain(&row.pos, s));
        let least = strains.fold(f64::INFINITY, f64::min);
        if least < self.least {
            self.least = least;
            self.compressed = frame();
        }
        self.end = frame();
    }

    /// Change of a spring's length relative to its rest length.
    fn strain(&self, pos: &[[f64; 3]], spring: usize) -> f64 {
        let [a, b] = self.springs[spring];
        let length = (0..3).map(|c| (pos[b][c] - pos[a][c]).powi(2)).sum::<f64>().sqrt();
        let rest = self.rest_lengths[spring];
        if rest > 0.0 { length / rest - 1.0 } else { 0.0 }
    }

    /// Draws all pictures.
    #[must_use]
    pub fn draw(&self, scene: &Scene) -> Drawing {
        let frames = self.frames();
        let ground = scene.around.ground.filter(|g| g.normal[2] > 0.0);
        let seen = Projection::along(ground.as_ref());
        let places = frames.iter().flat_map(|(_, f)| f.pos.iter().map(|p| seen.place(p)));
        let (mut across, mut up): (Vec<f64>, Vec<f64>) = places.unzip();
        if let Some(ground) = &ground {
            up.push(ground.offset / ground.normal[2]);
        }
        across.sort_by(f64::total_cmp);
        up.sort_by(f64::total_cmp);
        let range = |v: &[f64]| v.last().unwrap_or(&1.0) - v.first().unwrap_or(&0.0);
        let n = frames.len().max(1) as f64;
        let column = (WIDTH - LEFT - 30.0) / n - BETWEEN;
        // One scale for both axes, set by the tighter direction.
        let (wide, tall) = (1.1 * range(&across).max(1e-9), 1.1 * range(&up).max(1e-9));
        let scale = (column / wide).min(HEIGHT[1] / tall);
        let height = (scale * tall).max(HEIGHT[0]);
        let mut items = vec![text((LEFT, 20.0), "The body from the side", 16.0, Anchor::Start)];
        for (number, (name, frame)) in frames.iter().enumerate() {
            let left = LEFT + number as f64 * (column + BETWEEN);
            let x = Axis::scaled(&across, (left, left + column), scale);
            let z = Axis::scaled(&up, (TOP + height, TOP), scale);
            frame_items(&mut items, &x, &z, number == 0);
            let title = format!("{name}, {:.3} s", frame.time);
            items.push(text((left, TOP - 12.0), &title, SMALL, Anchor::Start));
            if let Some(ground) = &ground {
                items.push(line(ground_line(ground, &x, &z), INK, 2.5));
            }
            self.draw_springs(frame, seen, &x, &z, &mut items);
        }
        let at = (18.0, TOP + 0.5 * height);
        let (size, anchor) = (16.0, Anchor::Middle);
        items.push(Item::Text { at, text: "z [m]".to_owned(), size, anchor, upwards: true });
        let middle = 0.5 * (LEFT + WIDTH);
        items.push(text((middle, TOP + height + 42.0), "x [m]", 16.0, Anchor::Middle));
        Drawing { width: WIDTH as usize, height: (TOP + height + BOTTOM) as usize, items }
    }

    /// Pictures at different times, each with its title.
    fn frames(&self) -> Vec<(&str, &Frame)> {
        // If a touch, the start or the end is at the time of the largest compression, only that picture is shown.
        let others = [&self.start, &self.touch, &self.end].map(|frame| frame.as_ref().map(|f| f.time));
        let compressed = self.compressed.as_ref().filter(|f| !others.contains(&Some(f.time)));
        let named = [
            ("start", self.start.as_ref()),
            ("first touch", self.touch.as_ref()),
            ("compressed", compressed),
            ("end", self.end.as_ref()),
        ];
        named.into_iter().filter_map(|(name, frame)| Some((name, frame?))).collect()
    }

    fn draw_springs(&self, frame: &Frame, seen: Projection, x: &Axis, z: &Axis, items: &mut Vec<Item>) {
        let place = |p: &[f64; 3]| {
            let (right, up) = seen.place(p);
            (x.place(right), z.place(up))
        };
        for (number, [a, b]) in self.springs.iter().enumerate() {
            let color = strain_color(self.strain(&frame.pos, number));
            items.push(line(vec![place(&frame.pos[*a]), place(&frame.pos[*b])], color, 1.6));
        }
        for point in &frame.pos {
            let (x, z) = place(point);
            items.push(line(vec![(x - 1.5, z), (x + 1.5, z)], INK, 3.0));
        }
    }
}

/// The line in which the ground intersects y = 0.
fn ground_line(ground: &Ground<f64>, x: &Axis, z: &Axis) -> Vec<(f64, f64)> {
    let [nx, _, nz] = ground.normal;
    [x.low, x.high].map(|at| (x.place(at), z.place((ground.offset - nx * at) / nz))).to_vec()
}

/// Frame, grid and ticks.
fn frame_items(items: &mut Vec<Item>, x: &Axis, z: &Axis, is_first: bool) {
    for tick in z.ticks() {
        let at = z.place(tick);
        items.push(line(vec![(x.from, at), (x.to, at)], PALE, 1.0));
        if is_first {
            items.push(text((x.from - 8.0, at), &z.label(tick), SMALL, Anchor::End));
        }
    }
    for tick in x.ticks() {
        let at = x.place(tick);
        items.push(line(vec![(at, z.from), (at, z.to)], PALE, 1.0));
        // A label too near the edge would overlap the neighbouring picture's.
        if at - x.from > EDGE && x.to - at > EDGE {
            items.push(text((at, z.from + 16.0), &x.label(tick), SMALL, Anchor::Middle));
        }
    }
    let corners = [(x.from, z.from), (x.to, z.from), (x.to, z.to), (x.from, z.to), (x.from, z.from)];
    items.push(line(corners.to_vec(), INK, 1.0));
}

/// Grey at rest, vermilion stretched, blue compressed.
fn strain_color(strain: f64) -> Color {
    const REST: Color = [130, 130, 130];
    let share = (strain.abs() / FULL_STRAIN).min(1.0);
    let full = if strain > 0.0 { [213, 94, 0] } else { [0, 114, 178] };
    let mut color = REST;
    for (c, f) in color.iter_mut().zip(full) {
        *c = (f64::from(*c) + share * (f64::from(f) - f64::from(*c))).round() as u8;
    }
    color
}

#[cfg(test)]
mod tests {
    use super::*;
    use smartbed_runtime::contact::ContactLaw;

    #[test]
    fn a_point_on_the_ground_is_drawn_on_its_line() {
        for normal in [[0.0, 0.0, 1.0], [0.3, 0.0, 0.954], [0.2, -0.4, 0.894]] {
            let law = ContactLaw::MasslessPoint;
            let ground = Ground { normal, offset: 0.1, law, friction: 0.0, tolerance: 1e-11 };
            let seen = Projection::along(Some(&ground));
            for (x, y) in [(0.0, 0.0), (1.0, -2.0), (-0.5, 3.0)] {
                let z = (ground.offset - normal[0] * x - normal[1] * y) / normal[2];
                let (right, up) = seen.place(&[x, y, z]);
                let line = (ground.offset - normal[0] * right) / normal[2];
                assert!((up - line).abs() < 1e-12, "{normal:?} at {x}, {y}: {up}, the line is at {line}");
                assert!(seen.place(&[x, y, z + 0.1]).1 > line);
            }
        }
    }
}
