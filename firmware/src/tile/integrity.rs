//! Self-test of the program: all of it at start, then continuously, one slice per tick.
//!
//! In: the program's bytes, and the checksum that was built in. Out: whether they match.
//! The exception vectors are included, because faults, reset and each tick start from them.

use super::guarded::Guarded;
use crate::link::checksum::{BEGIN, go_on};

/// Bytes checked per tick: 40 KB take 1.3 s.
pub const SLICE: usize = 32;

/// The program in flash: vectors first, then code and constants, which need not follow directly.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Program<'a> {
    /// Vectors of exceptions and interrupts.
    pub vectors: &'a [u8],
    /// Code and constants.
    pub code: &'a [u8],
}

/// A round of checking in progress.
#[derive(Clone, Debug)]
pub struct Integrity {
    place: usize,
    sum: u32,
    expected: Guarded<1>,
    is_sound: bool,
}

impl Integrity {
    /// Checks the whole program once.
    #[must_use]
    pub fn new(program: Program, expected: u32) -> Self {
        let is_sound = !go_on(go_on(BEGIN, program.vectors), program.code) == expected;
        Self { place: 0, sum: BEGIN, expected: Guarded::new([expected]), is_sound }
    }

    /// Checks the next slice; returns whether the program is sound. A mismatch once found is kept.
    pub fn take(&mut self, program: Program) -> bool {
        let Program { vectors, code } = program;
        let rest = match self.place.checked_sub(vectors.len()) {
            None => vectors.get(self.place..),
            Some(place) => code.get(place..),
        };
        let slice = rest.and_then(|rest| rest.get(..SLICE).or(Some(rest))).unwrap_or_default();
        self.sum = go_on(self.sum, slice);
        self.place = self.place.saturating_add(slice.len());
        if self.place >= vectors.len().saturating_add(code.len()) {
            self.is_sound &= self.expected.get() == Some([!self.sum]);
            (self.place, self.sum) = (0, BEGIN);
        }
        self.is_sound
    }
}

#[cfg(test)]
mod tests {
    use super::{Integrity, Program, SLICE};
    use crate::link::checksum::checksum;

    const BYTES: [u8; 100] = [0x5A; 100];

    /// Vectors that end within a slice.
    fn program(bytes: &[u8]) -> Program<'_> {
        let (vectors, code) = bytes.split_at(bytes.len() * 2 / 5);
        Program { vectors, code }
    }

    fn built(bytes: &[u8]) -> u32 {
        u32::from_le_bytes(checksum(bytes))
    }

    /// Rounds of this program.
    fn rounds(integrity: &mut Integrity, bytes: &[u8], count: usize) -> bool {
        (0..count * (bytes.len().div_ceil(SLICE) + 1)).fold(true, |_, _| integrity.take(program(bytes)))
    }

    #[test]
    fn the_checksum_is_that_of_frames() {
        let bytes: [u8; 77] = core::array::from_fn(|n| (n * n) as u8);
        assert!(rounds(&mut Integrity::new(program(&bytes), built(&bytes)), &bytes, 3));
        assert!(!Integrity::new(program(&bytes), built(&bytes) ^ 1).take(program(&bytes)));
    }

    #[test]
    fn every_flipped_bit_is_found_within_two_rounds_and_at_a_start_at_once() {
        for bit in 0..8 * BYTES.len() {
            let (mut integrity, mut bytes) = (Integrity::new(program(&BYTES), built(&BYTES)), BYTES);
            assert!(rounds(&mut integrity, &bytes, 3));
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(!rounds(&mut integrity, &bytes, 2), "bit {bit}");
            // A second flip does not mend it.
            assert!(!rounds(&mut integrity, &BYTES, 2), "bit {bit}");
            assert!(!Integrity::new(program(&bytes), built(&BYTES)).take(program(&bytes)), "bit {bit}");
        }
    }

    #[test]
    fn no_program_is_sound() {
        assert!((0..5).all(|_| Integrity::new(Program::default(), 0).take(Program::default())));
    }
}
