//! A small seeded generator (SplitMix64), so that every run draws the same states.

/// Stream of uniform numbers.
pub struct Random(u64);

impl Random {
    /// A separate stream for every seed.
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    /// Uniform between two bounds (Steele, Lea and Flood 2014).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + (high - low) * (((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// Components between -size and size.
    pub fn vector(&mut self, size: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.between(-size, size))
    }
}
