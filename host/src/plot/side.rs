//! Pictures from the side: moments of a motion in one row at one scale, metres on both axes alike.
//!
//! In: lines in space with colours, moment by moment. Out: a [`Drawing`].
//! Projection: x + 0.35 y across, so that depth shows, and z upwards, changed by as much depth as makes the first plane
//! one line; the axes say by how much. Further planes are drawn where they meet y = 0. A plane body stays plane.

use super::Axis;
use super::chart::{SMALL, line, text};
use super::drawing::{Anchor, Color, Drawing, INK, Item, PALE};
use super::font;

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

/// A plane that faces the viewer so squarely that this length or less of its normal is left across and upwards is not
/// drawn: none of its lines is the one that bodies touch.
const SQUARELY: f64 = 0.5;

/// The plane n.x = offset.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ground {
    /// Outward normal of length 1.
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

impl Ground {
    /// Is it seen so much from the side that a line shows it?
    fn has_line(&self) -> bool {
        let [nx, _, nz] = self.normal;
        nx.hypot(nz) > SQUARELY
    }

    /// The point next to another one on the line where it meets y = 0; both (right, up) in m.
    fn foot(&self, (right, up): (f64, f64)) -> (f64, f64) {
        let [nx, _, nz] = self.normal;
        let away = (nx * right + nz * up - self.offset) / (nx * nx + nz * nz);
        (right - away * nx, up - away * nz)
    }
}

/// The picture plane: right and up per metre of depth.
#[derive(Clone, Copy, Debug)]
struct Projection {
    depth: [f64; 2],
}

impl Projection {
    /// The depth nearest to (0.35, 0) that lies in the ground's plane, n_x right + n_z up = n_y, so that the plane is
    /// seen as a line.
    fn along(ground: Option<&Ground>) -> Self {
        let [right, up] = ground.map_or([0.0; 2], |g| {
            let [nx, ny, nz] = g.normal;
            let turn = (ny - DEPTH * nx) / (nx * nx + nz * nz);
            [turn * nx, turn * nz]
        });
        Self { depth: [DEPTH + right, up] }
    }

    fn place(&self, p: &[f64; 3]) -> (f64, f64) {
        (p[0] + self.depth[0] * p[1], p[2] + self.depth[1] * p[1])
    }

    /// What the axes show, "x + 0.35 y [m]"; a plane body has no depth to add.
    fn labels(&self, is_plane: bool) -> [String; 2] {
        let label = |axis: &str, depth: f64| {
            let sign = if depth < 0.0 { '-' } else { '+' };
            match format!("{:.2}", depth.abs()).as_str() {
                "0.00" => format!("{axis} [m]"),
                _ if is_plane => format!("{axis} [m]"),
                size => format!("{axis} {sign} {size} y [m]"),
            }
        };
        [label("x", self.depth[0]), label("z", self.depth[1])]
    }
}

/// Draws the moments side by side.
#[must_use]
pub fn draw(title: &str, grounds: &[Ground], moments: &[Moment]) -> Drawing {
    let grounds: Vec<&Ground> = grounds.iter().filter(|ground| ground.has_line()).collect();
    let seen = Projection::along(grounds.first().copied());
    let points = || moments.iter().flat_map(|m| &m.strokes).flat_map(|stroke| &stroke.points);
    let labels = seen.labels(points().all(|p| p[1] == 0.0));
    let (mut across, mut up): (Vec<f64>, Vec<f64>) = points().map(|p| seen.place(p)).unzip();
    across.sort_by(f64::total_cmp);
    up.sort_by(f64::total_cmp);
    // The first plane is in the picture, however far below.
    if let Some(ground) = grounds.first() {
        let foot = ground.foot((middle(&across), middle(&up)));
        across.push(foot.0);
        up.push(foot.1);
        across.sort_by(f64::total_cmp);
        up.sort_by(f64::total_cmp);
    }
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
        let lines = grounds.iter().filter_map(|ground| ground_line(ground, &x, &z));
        items.extend(lines.map(|ends| line(ends, INK, 2.5)));
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
    let [right, upwards] = labels;
    items.push(Item::Text { at, text: upwards, size, anchor, upwards: true });
    let at = (0.5 * (LEFT + WIDTH), TOP + height + 42.0);
    items.push(text(at, &right, size, Anchor::Middle));
    Drawing { width: WIDTH as usize, height: (TOP + height + BOTTOM) as usize, items }
}

/// The middle between the first and the last of sorted values.
fn middle(sorted: &[f64]) -> f64 {
    0.5 * (sorted.first().unwrap_or(&0.0) + sorted.last().unwrap_or(&0.0))
}

/// The part within the frame of the line where a plane meets y = 0 (pixels); none where it passes the frame by.
fn ground_line(ground: &Ground, x: &Axis, z: &Axis) -> Option<Vec<(f64, f64)>> {
    let [nx, _, nz] = ground.normal;
    let foot = ground.foot((0.5 * (x.low + x.high), 0.5 * (z.low + z.high)));
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for (at, along, axis) in [(foot.0, nz, x), (foot.1, -nx, z)] {
        let ends = [(axis.low - at) / along, (axis.high - at) / along];
        // A line along the frame's side meets its two neighbours alone; if it is outside, no part of it is within.
        if ends.iter().all(|end| end.is_finite()) {
            from = from.max(ends[0].min(ends[1]));
            to = to.min(ends[0].max(ends[1]));
        } else if !(axis.low..=axis.high).contains(&at) {
            return None;
        }
    }
    (from < to).then(|| [from, to].map(|s| (x.place(foot.0 + s * nz), z.place(foot.1 - s * nx))).to_vec())
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
    let mut free = f64::NEG_INFINITY;
    for tick in x.ticks() {
        let (at, words) = (x.place(tick), x.label(tick));
        items.push(line(vec![(at, z.from), (at, z.to)], PALE, 1.0));
        // Words far over the edge would meet the next picture's, long ones their neighbours.
        let half = 0.5 * font::width(&words, SMALL);
        let inside = EDGE.max(half - 0.5 * BETWEEN);
        if at - x.from > inside && x.to - at > inside && at - half > free {
            items.push(text((at, z.from + 16.0), &words, SMALL, Anchor::Middle));
            free = at + half + EDGE;
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
    fn a_point_on_the_first_plane_is_drawn_on_its_line() {
        let upright = [1.0, 0.0, 6e-17];
        for normal in [[0.0, 0.0, 1.0], [0.3, 0.0, 0.954], [0.2, -0.4, 0.894], upright, [0.6, 0.0, -0.8]] {
            let ground = Ground { normal, offset: 0.1 };
            let seen = Projection::along(Some(&ground));
            let above = |p: [f64; 3]| {
                let (right, up) = seen.place(&p);
                normal[0] * right + normal[2] * up - ground.offset
            };
            let square: f64 = normal.iter().map(|n| n * n).sum();
            for (x, y, z) in [(0.0, 0.0, 0.3), (1.0, -2.0, 0.0), (-0.5, 3.0, -1.0)] {
                let height = normal[0] * x + normal[1] * y + normal[2] * z - ground.offset;
                let [nx, ny, nz] = normal.map(|n| height / square * n);
                let foot = [x - nx, y - ny, z - nz];
                assert!(above(foot).abs() < 1e-12, "{normal:?} at {foot:?}: {}", above(foot));
                assert!((above([x, y, z]) - height).abs() < 1e-12, "{normal:?}");
            }
        }
    }

    #[test]
    fn lines_of_planes_end_at_the_frame() {
        let sorted = [-0.5, 1.0];
        let (x, z) =
            (Axis::scaled(&sorted, (100.0, 400.0), 150.0), Axis::scaled(&sorted, (360.0, 60.0), 150.0));
        let cosine = 40_f64.to_radians().cos();
        let sine = 40_f64.to_radians().sin();
        for normal in
            [[0.0, 0.0, 1.0], [1.0, 0.0, 6e-17], [-1.0, 0.0, 0.0], [sine, 0.0, cosine], [0.0, 0.6, -0.8]]
        {
            let ends = ground_line(&Ground { normal, offset: 0.1 }, &x, &z).expect("it crosses the frame");
            for (right, up) in ends {
                assert!((99.999..400.001).contains(&right) && (59.999..360.001).contains(&up), "{normal:?}");
            }
        }
        assert_eq!(ground_line(&Ground { normal: [1.0, 0.0, 0.0], offset: -2.0 }, &x, &z), None);
        assert_eq!(ground_line(&Ground { normal: [sine, 0.0, cosine], offset: -9.0 }, &x, &z), None);
    }

    #[test]
    fn axes_say_how_much_depth_they_show() {
        let seen = |normal| Projection::along(Some(&Ground { normal, offset: 0.0 }));
        assert_eq!(seen([0.0, 0.0, 1.0]).labels(false), ["x + 0.35 y [m]", "z [m]"]);
        assert_eq!(seen([0.0, 0.0, 1.0]).labels(true), ["x [m]", "z [m]"]);
        assert_eq!(seen([0.0, -0.6, 0.8]).labels(false), ["x + 0.35 y [m]", "z - 0.75 y [m]"]);
        assert_eq!(seen([1.0, 0.0, 6e-17]).labels(false), ["x [m]", "z [m]"]);
    }

    #[test]
    fn a_wall_is_drawn_beside_what_it_stops() {
        let stroke = Stroke { points: vec![[0.5, 0.2, 0.0], [0.1, 0.2, 0.3]], color: INK, width: 1.6 };
        let moments = [Moment { name: "start", time: 0.0, strokes: vec![stroke] }];
        for normal in [[1.0, 0.0, 6e-17], [0.0, 1.0, 0.0], [0.9999, 0.0, 0.01]] {
            let drawing = draw("", &[Ground { normal, offset: 0.0 }], &moments);
            for item in &drawing.items {
                let Item::Line { points, .. } = item else { continue };
                let is_inside = |(x, y): &(f64, f64)| {
                    (0.0..=WIDTH).contains(x) && (0.0..=drawing.height as f64).contains(y)
                };
                assert!(points.iter().all(is_inside), "{normal:?}: {points:?}");
            }
            assert!(drawing.height < 600, "{normal:?}: {}", drawing.height);
        }
    }
}
