//! A monotone table with linear interpolation, in both directions.
//!
//! In: pairs whose two columns both rise or fall throughout. Out: either column from the other; beyond the ends the
//! last value.

/// A monotone table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    pairs: Vec<[f64; 2]>,
}

/// The reason why pairs are not a table: fewer than two, or the pair with this index breaks the direction of those
/// before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotMonotone(pub usize);

impl std::fmt::Display for NotMonotone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "pair {} of a table: expected two pairs or more, and each column either rising or falling throughout",
            self.0 + 1
        )
    }
}

impl std::error::Error for NotMonotone {}

impl Table {
    /// Checks pairs.
    ///
    /// # Errors
    /// [`NotMonotone`].
    pub fn new(mut pairs: Vec<[f64; 2]>) -> Result<Table, NotMonotone> {
        let &[first, second, ..] = pairs.as_slice() else { return Err(NotMonotone(pairs.len())) };
        let signs = [0, 1].map(|k| (second[k] - first[k]).signum());
        let goes_on = |w: &[[f64; 2]]| (0..2).all(|k| (w[1][k] - w[0][k]) * signs[k] > 0.0);
        if let Some(at) = pairs.windows(2).position(|w| !goes_on(w)) {
            return Err(NotMonotone(at + 1));
        }
        if signs[0] < 0.0 {
            pairs.reverse();
        }
        Ok(Table { pairs })
    }

    /// A quantity sampled at `count` points from `low` to `high`.
    ///
    /// # Errors
    /// [`NotMonotone`].
    pub fn sampled(
        [low, high]: [f64; 2],
        count: usize,
        of: impl Fn(f64) -> f64,
    ) -> Result<Table, NotMonotone> {
        let at = |n: usize| low + (high - low) * n as f64 / (count.max(2) - 1) as f64;
        Table::new((0..count).map(|n| [at(n), of(at(n))]).collect())
    }

    /// The second column at a value of the first.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        self.between(0, x)
    }

    /// The first column at a value of the second.
    #[must_use]
    pub fn back(&self, y: f64) -> f64 {
        self.between(1, y)
    }

    fn between(&self, key: usize, x: f64) -> f64 {
        let (first, last) = (self.pairs[0], self.pairs[self.pairs.len() - 1]);
        let sign = (last[key] - first[key]).signum();
        let upper =
            self.pairs.partition_point(|pair| sign * pair[key] < sign * x).clamp(1, self.pairs.len() - 1);
        let (a, b) = (self.pairs[upper - 1], self.pairs[upper]);
        let share = ((x - a[key]) / (b[key] - a[key])).clamp(0.0, 1.0);
        a[1 - key] + share * (b[1 - key] - a[1 - key])
    }
}
