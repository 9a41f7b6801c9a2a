//! An axis: maps values to pixels, with ticks at round numbers and as many digits as these need.

/// An axis shows no range narrower than this fraction of its values' size.
pub const NARROWEST: f64 = 1e-6;

/// Values from `low` to `high` on pixels from `from` to `to`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Axis {
    /// Least value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
    /// Position of the least value (pixels).
    pub from: f64,
    /// Position of the largest value (pixels).
    pub to: f64,
    tick: f64,
}

impl Axis {
    /// An axis that contains all finite values, with about `ticks` ticks at round numbers.
    pub fn around<'a>(
        values: impl Iterator<Item = &'a f64>,
        (from, to): (f64, f64),
        ticks: f64,
        pad: f64,
    ) -> Self {
        let finite = values.copied().filter(|x| x.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        // A constant still needs a range wide enough for its tick labels to differ.
        let size = low.abs().max(high.abs());
        let constant = if size > 0.0 { 0.2 * size } else { 1.0 };
        let spread = if high > low { (high - low).max(NARROWEST * size) } else { constant };
        let middle = 0.5 * (low + high);
        let half = 0.5 * spread * (1.0 + pad);
        Self { low: middle - half, high: middle + half, from, to, tick: round_step(spread / ticks) }
    }

    /// Ten times as wide about the same middle: labels have one digit less.
    pub fn widened(self) -> Self {
        let (middle, half) = (0.5 * (self.low + self.high), 5.0 * (self.high - self.low));
        Self { low: middle - half, high: middle + half, tick: round_step(10.0 * self.tick), ..self }
    }

    /// An axis centred on sorted values, at a given number of pixels per unit.
    pub fn scaled(sorted: &[f64], (from, to): (f64, f64), pixels_per_unit: f64) -> Self {
        let middle = 0.5 * (sorted.first().unwrap_or(&0.0) + sorted.last().unwrap_or(&0.0));
        let half = 0.5 * (to - from).abs() / pixels_per_unit;
        let ticks = ((to - from).abs() / 60.0).max(2.0);
        Self { low: middle - half, high: middle + half, from, to, tick: round_step(2.0 * half / ticks) }
    }

    /// Position of a value (pixels).
    #[must_use]
    pub fn place(&self, value: f64) -> f64 {
        self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// The values of the ticks.
    pub fn ticks(&self) -> impl Iterator<Item = f64> + '_ {
        let first = (self.low / self.tick - 1e-9).ceil();
        let count = ((self.high / self.tick + 1e-9).floor() - first).clamp(0.0, 40.0) as usize;
        (0..=count).map(move |n| (first + n as f64) * self.tick)
    }

    /// As many digits as the tick needs.
    pub fn label(&self, value: f64) -> String {
        let value = if value.abs() < 1e-9 * self.tick { 0.0 } else { value };
        let largest = self.low.abs().max(self.high.abs());
        if value == 0.0 && largest < 1e-3 {
            return "0".to_owned();
        }
        if !(1e-3..1e5).contains(&largest) {
            let digits = (largest.log10().floor() - self.tick.log10().floor()).clamp(0.0, 15.0) as usize;
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
        for (low, high) in
            [(0.0, 1.0), (1e-7, 3e-7), (1e6, 1.2e6), (5.0, 5.0), (0.0, 0.0), (-0.2, 0.1), (9.81, 9.8101)]
        {
            let axis = Axis::around([low, high].iter(), (0.0, 100.0), 5.0, 0.08);
            let labels: Vec<String> = axis.ticks().map(|t| axis.label(t)).collect();
            assert!(labels.len() >= 2, "{low} {high}: {labels:?}");
            assert!(labels.windows(2).all(|w| w[0] != w[1]), "{low} {high}: {labels:?}");
        }
        // Far from the origin, at a scale of its own.
        let axis = Axis::scaled(&[1e9, 1e9 + 1.5], (0.0, 300.0), 150.0);
        let labels: Vec<String> = axis.ticks().map(|t| axis.label(t)).collect();
        assert!(labels.len() > 2 && labels.windows(2).all(|w| w[0] != w[1]), "{labels:?}");
    }
}
