//! Pictures from the side: moments of a motion in one row at one scale, metres on both axes alike.
//!
//! In: lines in space with colours, moment by moment. Out: a [`Drawing`].
//! Projection: across x + 0.35 y, so that depth shows; upwards so that the ground is one line and every point stands
//! above it by its distance along z. A plane body stays plane.

use super::Axis;
use super::chart::{SMALL, line, text};
use super::drawing::{Anchor, Color, Drawing, INK, Item, PALE};

/// Right per depth.
const DEPTH: f64 = 0.35;
const WIDTH: f64 = 1000.0;
const LEFT: f64 = 110.0;
const BETWEEN: f64 = 24.0;
/// Least distance of a tick's label from the edge.
const EDGE: f64 = 6.0;
const TOP: f64 = 60.0;
const BOTTOM: f64 = 60.0;
/// Height of a picture: at least and at most.
const HEIGHT: [f64; 2] = [160.0, 420.0];
/// Strain that gets the full colour.
const FULL_STRAIN: f64 = 0.1;

/// The plane n.x = offset, n_z > 0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ground {
    /// Upward normal of length 1.
    pub normal: [f64; 3],
    /// Distance from the origin along the normal (m).
    pub offset: f64,
}

/// A line in space.
#[derive(Clone, PartialEq, Debug)]
pub struct Stroke {
    /// Its points (m); one point alone is a dot.
    pub points: Vec<[f64; 3]>,
    /// Colour.
    pub color: Color,
    /// Width (pixels).
    pub width: f64,
}

/// What is seen at one time.
#[derive(Clone, PartialEq, Debug)]
pub struct Moment {
    /// Its name, "first touch".
    pub name: &'static str,
    /// Time (s).
    pub time: f64,
    /// Lines, back to front.
    pub strokes: Vec<Stroke>,
}

/// The picture plane: right and up per metre of depth.
#[derive(Clone, Copy, Debug)]
struct Projection {
    depth: [f64; 2],
}

impl Projection {
    /// The depth that lies in the ground's plane: up = -(nx right + ny)/nz, so that the plane is seen as a line.
    fn along(ground: Option<&Ground>) -> Self {
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

/// Draws the moments side by side.
#[must_use]
pub fn draw(title: &str, ground: Option<&Ground>, moments: &[Moment]) -> Drawing {
    let seen = Projection::along(ground);
    let points = moments.iter().flat_map(|m| &m.strokes).flat_map(|stroke| &stroke.points);
    let (mut across, mut up): (Vec<f64>, Vec<f64>) = points.map(|p| seen.place(p)).unzip();
    if let Some(ground) = ground {
        up.push(ground.offset / ground.normal[2]);
    }
    across.sort_by(f64::total_cmp);
    up.sort_by(f64::total_cmp);
    let range = |v: &[f64]| v.last().unwrap_or(&1.0) - v.first().unwrap_or(&0.0);
    let n = moments.len().max(1) as f64;
    let column = (WIDTH - LEFT - 30.0) / n - BETWEEN;
    // One scale for both axes: whichever direction is tighter decides.
    let (wide, tall) = (1.1 * range(&across).max(1e-9), 1.1 * range(&up).max(1e-9));
    let scale = (column / wide).min(HEIGHT[1] / tall);
    let height = (scale * tall).max(HEIGHT[0]);
    let mut items = vec![text((LEFT, 20.0), title, 16.0, Anchor::Start)];
    for (number, moment) in moments.iter().enumerate() {
        let left = LEFT + number as f64 * (column + BETWEEN);
        let x = Axis::scaled(&across, (left, left + column), scale);
        let z = Axis::scaled(&up, (TOP + height, TOP), scale);
        frame_items(&mut items, &x, &z, number == 0);
        let title = format!("{}, {:.3} s", moment.name, moment.time);
        items.push(text((left, TOP - 12.0), &title, SMALL, Anchor::Start));
        if let Some(ground) = ground {
            items.push(line(ground_line(ground, &x, &z), INK, 2.5));
        }
        items.extend(moment.strokes.iter().map(|stroke| {
            let place = |p: &[f64; 3]| {
                let (right, up) = seen.place(p);
                (x.place(right), z.place(up))
            };
            let points = match stroke.points.as_slice() {
                [dot] => {
                    let ((right, up), half) = (place(dot), 0.5 * stroke.width);
                    vec![(right - half, up), (right + half, up)]
                }
                points => points.iter().map(place).collect(),
            };
            line(points, stroke.color, stroke.width)
        }));
    }
    let at = (18.0, TOP + 0.5 * height);
    let (size, anchor) = (16.0, Anchor::Middle);
    items.push(Item::Text { at, text: "z [m]".to_owned(), size, anchor, upwards: true });
    let middle = 0.5 * (LEFT + WIDTH);
    items.push(text((middle, TOP + height + 42.0), "x [m]", 16.0, Anchor::Middle));
    Drawing { width: WIDTH as usize, height: (TOP + height + BOTTOM) as usize, items }
}

/// Where the plane of the ground meets y = 0.
fn ground_line(ground: &Ground, x: &Axis, z: &Axis) -> Vec<(f64, f64)> {
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
        // Half a word over the edge would meet the neighbour's.
        if at - x.from > EDGE && x.to - at > EDGE {
            items.push(text((at, z.from + 16.0), &x.label(tick), SMALL, Anchor::Middle));
        }
    }
    let corners = [(x.from, z.from), (x.to, z.from), (x.to, z.to), (x.from, z.to), (x.from, z.from)];
    items.push(line(corners.to_vec(), INK, 1.0));
}

/// Grey at rest, vermilion stretched, blue compressed, by the change of length over the rest length.
#[must_use]
pub fn strain_color(strain: f64) -> Color {
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

    #[test]
    fn a_point_on_the_ground_is_drawn_on_its_line() {
        for normal in [[0.0, 0.0, 1.0], [0.3, 0.0, 0.954], [0.2, -0.4, 0.894]] {
            let ground = Ground { normal, offset: 0.1 };
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
