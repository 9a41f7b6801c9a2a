//! Numbers of no particular value, the same on every machine: random ones, and ones that are evenly spread.

/// A small deterministic generator (SplitMix64): the same samples on every machine.
pub(crate) struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in a range.
    pub(crate) fn between(&mut self, (low, high): (f64, f64)) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// A number between 1/2 and 3/2 for every n, unlike those of the others.
pub(super) fn spread(n: usize) -> f64 {
    /// Fractional parts of its multiples cover the unit interval evenly (golden section).
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    0.5 + (GOLDEN * (1.0 + n as f64)).fract()
}
