//! Values kept twice, the second time inverted, so that a flipped bit of memory is detected before the value is used.
//!
//! In: words. Out: the same words, or None if the two copies disagree.

/// Words and their inverse.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Guarded<const N: usize> {
    words: [u32; N],
    inverse: [u32; N],
}

impl<const N: usize> Guarded<N> {
    /// Stores these words.
    #[must_use]
    pub fn new(words: [u32; N]) -> Self {
        Self { words, inverse: words.map(|w| !w) }
    }

    /// Stores the bits of these numbers.
    #[must_use]
    pub fn numbers(numbers: [f32; N]) -> Self {
        Self::new(numbers.map(f32::to_bits))
    }

    /// The words, if both copies agree.
    #[must_use]
    pub fn get(&self) -> Option<[u32; N]> {
        let agree = self.words.iter().zip(&self.inverse).all(|(word, inverse)| *word == !*inverse);
        agree.then_some(self.words)
    }

    /// The numbers, if both copies agree.
    #[must_use]
    pub fn get_numbers(&self) -> Option<[f32; N]> {
        self.get().map(|words| words.map(f32::from_bits))
    }

    /// Flips a bit of either copy, as radiation might; for fault injection.
    pub fn flip(&mut self, bit: usize) {
        let words = self.words.iter_mut().chain(&mut self.inverse);
        if let Some(word) = words.into_iter().nth(bit / 32) {
            *word ^= 1 << (bit % 32);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Guarded;

    #[test]
    fn every_flipped_bit_is_seen() {
        let numbers = [1.5, -0.0, 3e-9];
        for bit in 0..2 * 3 * 32 {
            let mut guarded = Guarded::numbers(numbers);
            assert_eq!(guarded.get_numbers(), Some(numbers));
            guarded.flip(bit);
            assert_eq!(guarded.get(), None, "bit {bit}");
        }
    }
}
