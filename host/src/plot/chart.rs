//! Panels one above the other with a common horizontal axis: ticks, grid, curves with marks, events, legend.
//!
//! In: a [`Chart`]. Out: a [`Drawing`] in which no two texts overlap: titles and legends are wrapped by the font's own
//! widths, a panel is as high as its legend, ticks keep their distance. Curves that cannot be distinguished share one
//! entry of the legend.

use super::axis::{Axis, NARROWEST};
use super::drawing::{Anchor, Color, Drawing, INK, Item, PALE};
use super::font;

/// Colours that most people can distinguish (Okabe & Ito 2008), without the yellow.
pub const COLORS: [Color; 7] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [230, 159, 0], [0, 0, 0]];
/// Colour of events.
const EVENT: Color = [150, 150, 150];
const WIDTH: usize = 1000;
const PANEL: f64 = 220.0;
/// Height of a panel whose curves are constant.
const FLAT: f64 = 96.0;
const GAP: f64 = 30.0;
const LEFT: f64 = 96.0;
/// Width of the legend.
const RIGHT: f64 = 190.0;
const TOP: f64 = 18.0;
const BOTTOM: f64 = 56.0;
/// Letter size of ticks and legends.
pub const SMALL: f64 = 13.0;
/// Letter size of labels and titles.
pub const LARGE: f64 = 15.0;
/// Distance between lines of text.
const LEADING: f64 = 18.0;
/// Marks on a curve.
const MARKS: usize = 9;
/// Half of a mark's width.
const MARK: f64 = 3.6;
/// Curves closer than this fraction of a panel's height cannot be distinguished.
const ALIKE: f64 = 0.004;
/// Of up to this many coinciding curves all are named, of more only the first and the last.
const NAMED: usize = 6;
/// Most events drawn over the whole height; more are ticks at the upper edge.
const MOST_EVENTS: usize = 40;

/// A line over time.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// One value per time.
    pub values: Vec<f64>,
    /// Its colour; `None` for the one of its index.
    pub color: Option<Color>,
    /// Its own abscissae; `None` for the common ones.
    pub across: Option<Vec<f64>>,
}

impl Curve {
    /// Least and largest finite value.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        let finite = self.values.iter().copied().filter(|x| x.is_finite());
        finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)))
    }

    /// Largest absolute value.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.values.iter().filter(|x| x.is_finite()).fold(0.0, |most, x| most.max(x.abs()))
    }

    /// Difference of its largest and least value; 0 if no axis would show it.
    #[must_use]
    pub fn motion(&self) -> f64 {
        let (low, high) = self.range();
        if high - low > NARROWEST * self.size() { high - low } else { 0.0 }
    }

    /// Do the two curves coincide to within a distance?
    #[must_use]
    pub fn is_alike(&self, other: &Self, distance: f64) -> bool {
        let close = |(x, y): (&f64, &f64)| (x - y).abs() <= distance || (x.is_nan() && y.is_nan());
        self.across.is_none() && other.across.is_none() && self.values.iter().zip(&other.values).all(close)
    }

    fn is_zero(&self) -> bool {
        self.values.iter().all(|x| *x == 0.0)
    }
}

/// Curves of one unit.
#[derive(Clone, PartialEq, Debug)]
pub struct Panel {
    /// Quantity and unit.
    pub label: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

impl Panel {
    fn range(&self) -> (f64, f64) {
        let ranges = self.curves.iter().map(Curve::range);
        ranges.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), (a, b)| (l.min(a), h.max(b)))
    }
}

/// Contents of a chart.
#[derive(Clone, Copy, Debug)]
pub struct Chart<'a> {
    /// Title.
    pub title: &'a str,
    /// How it was made; may be empty.
    pub note: &'a str,
    /// Quantity and unit of the horizontal axis.
    pub across: &'a str,
    /// Common abscissae.
    pub time: &'a [f64],
    /// Panels from top to bottom.
    pub panels: &'a [Panel],
    /// Times of events.
    pub events: &'a [f64],
}

/// Draws it.
#[must_use]
pub fn draw(chart: &Chart<'_>) -> Drawing {
    let mut items = Vec::new();
    let mut top = head(chart, &mut items);
    let x = Axis::around(chart.time.iter(), (LEFT, WIDTH as f64 - RIGHT), 8.0, 0.0);
    for (number, panel) in chart.panels.iter().enumerate() {
        let is_last = number + 1 == chart.panels.len();
        top = draw_panel(panel, chart, &x, top, is_last, &mut items) + if is_last { BOTTOM } else { GAP };
    }
    Drawing { width: WIDTH, height: top as usize, items }
}

/// Title and note; returns where panels begin.
fn head(chart: &Chart<'_>, items: &mut Vec<Item>) -> f64 {
    let most = WIDTH as f64 - LEFT - 20.0;
    let mut y = TOP;
    for (words, size) in [(chart.title, LARGE), (chart.note, SMALL)] {
        for line in font::wrapped(words, size, most).iter().filter(|l| !l.is_empty()) {
            items.push(text((LEFT, y), line, size, Anchor::Start));
            y += LEADING + 2.0;
        }
    }
    y + 8.0
}

/// Draws a panel; returns where it ends.
fn draw_panel(
    panel: &Panel,
    chart: &Chart<'_>,
    x: &Axis,
    top: f64,
    is_last: bool,
    items: &mut Vec<Item>,
) -> f64 {
    let (low, high) = panel.range();
    let groups = groups(panel, ALIKE * (high - low));
    let legend: Vec<Vec<String>> = groups.iter().map(|g| legend_lines(panel, g)).collect();
    let lines: usize = legend.iter().map(Vec::len).sum();
    let is_flat = groups.len() <= 1 && panel.curves.iter().all(|c| c.motion() == 0.0);
    let least = if is_flat { FLAT } else { PANEL };
    let bottom = top + least.max(LEADING * lines as f64 + 12.0).max(font::width(&panel.label, LARGE));
    let mut y = Axis::around([low, high].iter(), (bottom, top), (bottom - top) / 32.0, 0.08);
    // Labels wider than the margin would overlap the panel's label: such a small variation is drawn as constant.
    while widest_label(&y) > LEFT - 8.0 - 18.0 - LARGE && y.high - y.low < 0.01 * low.abs().max(high.abs()) {
        y = y.widened();
    }
    grid(x, &y, is_last, items);
    events(chart.events, x, &y, items);
    if is_last {
        items.push(text((0.5 * (x.from + x.to), bottom + 40.0), chart.across, LARGE, Anchor::Middle));
    }
    let (at, size, anchor) = ((18.0, 0.5 * (top + bottom)), LARGE, Anchor::Middle);
    items.push(Item::Text { at, text: panel.label.clone(), size, anchor, upwards: true });
    let mut line_at = top + 12.0;
    for (number, (group, lines)) in groups.iter().zip(&legend).enumerate() {
        let curve = &panel.curves[group[0]];
        let color = curve.color.unwrap_or(COLORS[number % COLORS.len()]);
        draw_curve(curve, chart.time, x, &y, (number, color), items);
        items.push(line(vec![(x.to + 12.0, line_at), (x.to + 36.0, line_at)], color, 2.2));
        items.push(mark(number, (x.to + 24.0, line_at), color));
        for words in lines {
            items.push(text((x.to + 42.0, line_at), words, SMALL, Anchor::Start));
            line_at += LEADING;
        }
    }
    bottom
}

fn widest_label(y: &Axis) -> f64 {
    y.ticks().map(|tick| font::width(&y.label(tick), SMALL)).fold(0.0, f64::max)
}

/// Groups of coinciding curves, each in order; the first of a group is drawn.
fn groups(panel: &Panel, distance: f64) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (number, curve) in panel.curves.iter().enumerate() {
        match groups.iter_mut().find(|g| panel.curves[g[0]].is_alike(curve, distance)) {
            Some(group) => group.push(number),
            None => groups.push(vec![number]),
        }
    }
    groups
}

/// Names of coinciding curves, as lines that fit.
fn legend_lines(panel: &Panel, group: &[usize]) -> Vec<String> {
    let names: Vec<&str> = group.iter().map(|&n| panel.curves[n].name.as_str()).collect();
    let names = match names.as_slice() {
        [first, .., last] if names.len() > NAMED => format!("{first} to {last} ({} alike)", names.len()),
        _ => names.join(", "),
    };
    let zero = if panel.curves[group[0]].is_zero() { " = 0" } else { "" };
    font::wrapped(&format!("{names}{zero}"), SMALL, RIGHT - 50.0)
}

fn grid(x: &Axis, y: &Axis, is_last: bool, items: &mut Vec<Item>) {
    for tick in y.ticks() {
        let at = y.place(tick);
        items.push(line(vec![(x.from, at), (x.to, at)], PALE, 1.0));
        items.push(text((x.from - 8.0, at), &y.label(tick), SMALL, Anchor::End));
    }
    for tick in x.ticks() {
        let at = x.place(tick);
        items.push(line(vec![(at, y.to), (at, y.from)], PALE, 1.0));
        if is_last {
            items.push(text((at, y.from + 16.0), &x.label(tick), SMALL, Anchor::Middle));
        }
    }
    let (l, r, t, b) = (x.from, x.to, y.to, y.from);
    items.push(line(vec![(l, t), (r, t), (r, b), (l, b), (l, t), (r, t)], INK, 1.0));
}

/// A tick at the upper edge for every event, and a line through the panel if they are few.
fn events(times: &[f64], x: &Axis, y: &Axis, items: &mut Vec<Item>) {
    let inside: Vec<f64> = times.iter().copied().filter(|t| (x.low..=x.high).contains(t)).collect();
    for at in inside.iter().map(|t| x.place(*t)) {
        if inside.len() <= MOST_EVENTS {
            items.push(line(vec![(at, y.to), (at, y.from)], EVENT, 0.8));
        }
        let points = vec![(at - 4.0, y.to), (at + 4.0, y.to), (at, y.to + 7.0)];
        items.push(Item::Area { points, color: EVENT });
    }
}

fn draw_curve(
    curve: &Curve,
    time: &[f64],
    x: &Axis,
    y: &Axis,
    (number, color): (usize, Color),
    items: &mut Vec<Item>,
) {
    let across = curve.across.as_deref().unwrap_or(time);
    let finite = across.iter().zip(&curve.values).filter(|(t, v)| t.is_finite() && v.is_finite());
    let points: Vec<(f64, f64)> = finite.map(|(t, v)| (x.place(*t), y.place(*v))).collect();
    // Marks of different curves are at different abscissae.
    let step = (points.len() / MARKS).max(1);
    let first = step * (number % COLORS.len()) / COLORS.len() + step / 8;
    let marks: Vec<Item> =
        points.iter().skip(first).step_by(step).map(|at| mark(number, *at, color)).collect();
    items.push(line(points, color, 1.5));
    items.extend(marks);
}

/// The mark of a curve by its number: disk, square, two triangles, diamond, plus, cross.
#[must_use]
pub fn mark(number: usize, (x, y): (f64, f64), color: Color) -> Item {
    let r = MARK;
    let corners = |angles: &[f64], r: f64| -> Vec<(f64, f64)> {
        angles.iter().map(|a| (x + r * a.to_radians().cos(), y - r * a.to_radians().sin())).collect()
    };
    // The twelve corners of a plus.
    let (a, b) = (1.3 * r, 0.45 * r);
    let plus = [
        (a, b),
        (b, b),
        (b, a),
        (-b, a),
        (-b, b),
        (-a, b),
        (-a, -b),
        (-b, -b),
        (-b, -a),
        (b, -a),
        (b, -b),
        (a, -b),
    ];
    let points = match number % 7 {
        0 => corners(&std::array::from_fn::<f64, 12, _>(|n| 30.0 * n as f64), r),
        1 => corners(&[45.0, 135.0, 225.0, 315.0], 1.25 * r),
        2 => corners(&[90.0, 210.0, 330.0], 1.4 * r),
        3 => corners(&[30.0, 150.0, 270.0], 1.4 * r),
        4 => corners(&[0.0, 90.0, 180.0, 270.0], 1.4 * r),
        5 => plus.iter().map(|(u, v)| (x + u, y + v)).collect(),
        _ => plus.iter().map(|(u, v)| (x + 0.707 * (u - v), y + 0.707 * (u + v))).collect(),
    };
    Item::Area { points, color }
}

/// A line through points.
pub(crate) fn line(points: Vec<(f64, f64)>, color: Color, width: f64) -> Item {
    Item::Line { points, color, width }
}

/// Words on a line.
pub(crate) fn text(at: (f64, f64), text: &str, size: f64, anchor: Anchor) -> Item {
    Item::Text { at, text: text.to_owned(), size, anchor, upwards: false }
}

/// Appends a drawing below another.
pub fn below(drawing: &mut Drawing, lower: Drawing) {
    let down = drawing.height as f64;
    drawing.items.extend(lower.items.into_iter().map(|item| item.lowered(down)));
    drawing.width = drawing.width.max(lower.width);
    drawing.height += lower.height;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(name: &str, values: &[f64]) -> Curve {
        Curve { name: name.to_owned(), values: values.to_vec(), color: None, across: None }
    }

    /// Left, top, right and bottom of a text.
    fn extent(item: &Item) -> Option<(f64, f64, f64, f64)> {
        let Item::Text { at: (x, y), text, size, anchor, upwards } = item else { return None };
        let width = font::width(text, *size);
        let back = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * width,
            Anchor::End => width,
        };
        let (half, along) = (0.5 * size, (-back, width - back));
        Some(match upwards {
            false => (x + along.0, y - half, x + along.1, y + half),
            true => (x - half, y - along.1, x + half, y - along.0),
        })
    }

    #[test]
    fn no_words_overlap_or_leave_the_picture() {
        let wave = |n: usize| (0..50).map(|i| (0.1 * i as f64 + n as f64).sin()).collect::<Vec<f64>>();
        let time: Vec<f64> = (0..50).map(|i| 0.123_456 * i as f64).collect();
        let many = |n| (0..n).map(|i| curve(&format!("a rather long name {i}"), &wave(i))).collect();
        let panels = [
            Panel { label: "angle [rad]".to_owned(), curves: many(8) },
            Panel { label: "length [m]".to_owned(), curves: vec![curve("still", &[0.2; 50])] },
            Panel {
                label: "energy [J]".to_owned(),
                curves: vec![curve(
                    "total",
                    &wave(0).iter().map(|v| 1918.207 + 1e-5 * v).collect::<Vec<_>>(),
                )],
            },
            Panel {
                label: "length [m]".to_owned(),
                curves: vec![curve("x", &wave(0).iter().map(|v| 0.02 + 1e-9 * v).collect::<Vec<_>>())],
            },
            Panel {
                label: "tiny [m]".to_owned(),
                curves: vec![curve("x", &wave(0).iter().map(|v| 1e-7 * v).collect::<Vec<_>>())],
            },
        ];
        let title = "word ".repeat(60);
        let drawing = draw(&Chart {
            title: &title,
            note: "rk4, step 1e-3 s, k = 400",
            across: "time [s]",
            time: &time,
            panels: &panels,
            events: &[1.0, 2.0],
        });
        let words: Vec<(f64, f64, f64, f64)> = drawing.items.iter().filter_map(extent).collect();
        assert!(words.len() > 30);
        for (n, a) in words.iter().enumerate() {
            let inside =
                a.0 >= 0.0 && a.1 >= 0.0 && a.2 <= drawing.width as f64 && a.3 <= drawing.height as f64;
            assert!(inside, "{a:?}");
            for b in &words[n + 1..] {
                assert!(a.2 <= b.0 || b.2 <= a.0 || a.3 <= b.1 || b.3 <= a.1, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn curves_on_each_other_share_an_entry() {
        let curves = vec![
            curve("a", &[0.0, 1.0]),
            curve("b", &[0.0, 1.001]),
            curve("c", &[0.0, 0.0]),
            curve("d", &[0.0, 0.0]),
        ];
        let panel = Panel { label: "length [m]".to_owned(), curves };
        let groups = groups(&panel, ALIKE);
        assert_eq!(groups, [vec![0, 1], vec![2, 3]]);
        assert_eq!(legend_lines(&panel, &groups[1]), ["c, d = 0"]);
        let curves = (0..28).map(|n| curve(&format!("top{n}"), &[0.0, 1.0])).collect();
        let many = Panel { label: "length [m]".to_owned(), curves };
        let lines = legend_lines(&many, &(0..28).collect::<Vec<_>>());
        assert_eq!(lines.join(" "), "top0 to top27 (28 alike)");
    }

    #[test]
    fn marks_differ_in_shape() {
        let marks: Vec<Item> = (0..7).map(|n| mark(n, (0.0, 0.0), INK)).collect();
        for (n, a) in marks.iter().enumerate() {
            assert!(marks[n + 1..].iter().all(|b| a != b), "{n}");
        }
    }
}
