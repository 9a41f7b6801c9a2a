//! Panels one above the other with one time axis: axes, ticks, grid, curves, legend.

use super::drawing::{Anchor, Color, Drawing, INK, Item, PALE};

/// Colours told apart by most eyes (Okabe & Ito 2008), the yellow left out.
const COLORS: [Color; 8] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [204, 121, 167],
    [86, 180, 233],
    [230, 159, 0],
    [110, 110, 110],
    [120, 60, 20],
];
const WIDTH: usize = 1000;
const PANEL: f64 = 230.0;
const GAP: f64 = 34.0;
const LEFT: f64 = 110.0;
const RIGHT: f64 = 150.0;
const TOP: f64 = 50.0;
const BOTTOM: f64 = 60.0;
const SMALL: f64 = 14.0;
const LARGE: f64 = 16.0;

/// A line over time.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// One value per time.
    pub values: Vec<f64>,
    /// Its colour; else one by its place.
    pub color: Option<Color>,
    /// Its own abscissae; else the common ones.
    pub across: Option<Vec<f64>>,
}

/// Curves of one unit.
#[derive(Clone, PartialEq, Debug)]
pub struct Panel {
    /// Quantity and unit.
    pub label: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// An axis: values from `low` to `high` on pixels from `from` to `to`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Axis {
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) from: f64,
    pub(crate) to: f64,
    tick: f64,
}

impl Axis {
    /// Around all finite values, with round numbers for ticks, about `ticks` of them.
    fn around<'a>(
        values: impl Iterator<Item = &'a f64>,
        (from, to): (f64, f64),
        ticks: f64,
        pad: f64,
    ) -> Self {
        let finite = values.copied().filter(|x| x.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        // A constant still needs a range, wide enough for its ticks to differ in print.
        let least = 1e-6 * low.abs().max(high.abs()).max(1e-9);
        let spread = (high - low).max(least);
        let middle = 0.5 * (low + high);
        let half = 0.5 * spread * (1.0 + pad);
        Self { low: middle - half, high: middle + half, from, to, tick: round_step(spread / ticks) }
    }

    /// Around sorted values in the middle, at a given number of pixels per unit.
    pub(crate) fn scaled(sorted: &[f64], (from, to): (f64, f64), pixels_per_unit: f64) -> Self {
        let middle = 0.5 * (sorted.first().unwrap_or(&0.0) + sorted.last().unwrap_or(&0.0));
        let half = 0.5 * (to - from).abs() / pixels_per_unit;
        let ticks = ((to - from).abs() / 60.0).max(2.0);
        Self { low: middle - half, high: middle + half, from, to, tick: round_step(2.0 * half / ticks) }
    }

    pub(crate) fn place(&self, value: f64) -> f64 {
        self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    pub(crate) fn ticks(&self) -> impl Iterator<Item = f64> + '_ {
        let first = (self.low / self.tick - 1e-9).ceil();
        let count = ((self.high / self.tick + 1e-9).floor() - first).clamp(0.0, 40.0) as usize;
        (0..=count).map(move |n| (first + n as f64) * self.tick)
    }

    /// As many digits as the tick needs.
    pub(crate) fn label(&self, value: f64) -> String {
        let value = if value.abs() < 1e-9 * self.tick { 0.0 } else { value };
        let largest = self.low.abs().max(self.high.abs());
        if !(1e-3..1e5).contains(&largest) {
            let digits = (largest.log10().floor() - self.tick.log10().floor()).clamp(0.0, 9.0) as usize;
            return format!("{value:.digits$e}");
        }
        let digits = (-self.tick.log10().floor()).clamp(0.0, 9.0) as usize;
        format!("{value:.digits$}")
    }
}

/// 1, 2 or 5 times a power of ten, not below `least`.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|f| f * power >= least * 0.999).unwrap_or(10.0);
    factor * power
}

/// Draws panels over a common time axis.
#[must_use]
pub fn draw(title: &str, time_label: &str, time: &[f64], panels: &[Panel]) -> Drawing {
    let n = panels.len().max(1) as f64;
    let height = TOP + n * PANEL + (n - 1.0) * GAP + BOTTOM;
    let mut items = vec![text((LEFT, TOP / 2.0), &shortened(title, 76), LARGE, Anchor::Start)];
    let across = (LEFT, WIDTH as f64 - RIGHT);
    let x = Axis::around(time.iter(), across, 8.0, 0.0);
    for (number, panel) in panels.iter().enumerate() {
        let top = TOP + number as f64 * (PANEL + GAP);
        let is_last = number + 1 == panels.len();
        draw_panel(panel, time, &x, top, is_last.then_some(time_label), &mut items);
    }
    Drawing { width: WIDTH, height: height as usize, items }
}

fn draw_panel(
    panel: &Panel,
    time: &[f64],
    x: &Axis,
    top: f64,
    time_label: Option<&str>,
    items: &mut Vec<Item>,
) {
    let bottom = top + PANEL;
    let values = panel.curves.iter().flat_map(|c| &c.values);
    let y = Axis::around(values, (bottom, top), 5.0, 0.08);
    for tick in y.ticks() {
        let at = y.place(tick);
        items.push(line(vec![(x.from, at), (x.to, at)], PALE, 1.0));
        items.push(text((x.from - 8.0, at), &y.label(tick), SMALL, Anchor::End));
    }
    for tick in x.ticks() {
        let at = x.place(tick);
        items.push(line(vec![(at, top), (at, bottom)], PALE, 1.0));
        if time_label.is_some() {
            items.push(text((at, bottom + 16.0), &x.label(tick), SMALL, Anchor::Middle));
        }
    }
    let frame = vec![(x.from, top), (x.to, top), (x.to, bottom), (x.from, bottom), (x.from, top)];
    items.push(line(frame, INK, 1.0));
    if let Some(label) = time_label {
        items.push(text((0.5 * (x.from + x.to), bottom + 42.0), label, LARGE, Anchor::Middle));
    }
    let at = (18.0, 0.5 * (top + bottom));
    let (size, anchor) = (LARGE, Anchor::Middle);
    items.push(Item::Text { at, text: panel.label.clone(), size, anchor, upwards: true });
    for (number, curve) in panel.curves.iter().enumerate() {
        let color = curve.color.unwrap_or(COLORS[number % COLORS.len()]);
        let points = curve
            .across
            .as_deref()
            .unwrap_or(time)
            .iter()
            .zip(&curve.values)
            .filter(|(t, v)| t.is_finite() && v.is_finite());
        items.push(line(points.map(|(t, v)| (x.place(*t), y.place(*v))).collect(), color, 1.6));
        let at = top + 12.0 + 20.0 * number as f64;
        items.push(line(vec![(x.to + 12.0, at), (x.to + 36.0, at)], color, 2.5));
        items.push(text((x.to + 42.0, at), &shortened(&curve.name, 12), SMALL, Anchor::Start));
    }
}

pub(crate) fn line(points: Vec<(f64, f64)>, color: Color, width: f64) -> Item {
    Item::Line { points, color, width }
}

pub(crate) fn text(at: (f64, f64), text: &str, size: f64, anchor: Anchor) -> Item {
    Item::Text { at, text: text.to_owned(), size, anchor, upwards: false }
}

fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    text.chars().take(most - 2).chain("..".chars()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round() {
        for (least, step) in [(0.9, 1.0), (1.1, 2.0), (0.03, 0.05), (600.0, 1000.0)] {
            assert!((round_step(least) - step).abs() < 1e-12 * step, "{least}");
        }
    }

    #[test]
    fn labels_of_neighbouring_ticks_differ() {
        for (low, high) in [(0.0, 1.0), (1e-7, 3e-7), (1e6, 1.2e6), (5.0, 5.0), (-0.2, 0.1), (9.81, 9.8101)] {
            let axis = Axis::around([low, high].iter(), (0.0, 100.0), 5.0, 0.08);
            let labels: Vec<String> = axis.ticks().map(|t| axis.label(t)).collect();
            assert!(labels.len() >= 2, "{low} {high}: {labels:?}");
            assert!(labels.windows(2).all(|w| w[0] != w[1]), "{low} {high}: {labels:?}");
        }
    }
}
