//! The program checks itself: all of it at its start, then all the time, a slice a tick.
//!
//! In: the program's bytes, and the checksum that it was built with. Out: does the one belong to the other? CRC-32 as in
//! `link::frame`, four bits at a time: every flipped bit changes it.

use super::guarded::Guarded;

/// Bytes of a tick: 40 KB take 1.3 s.
pub const SLICE: usize = 32;
/// Remainders of four bits by the reflected polynomial 0xEDB88320 (Rocksoft's CRC-32/ISO-HDLC).
const REMAINDERS: [u32; 16] = remainders();

/// A round of checking under way.
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
    pub fn new(program: &[u8], expected: u32) -> Self {
        let is_sound = !checksum(u32::MAX, program.iter()) == expected;
        Self { place: 0, sum: u32::MAX, expected: Guarded::new([expected]), is_sound }
    }

    /// Goes on by a slice; is the program what it was built as? What was once wrong stays so.
    pub fn take(&mut self, program: &[u8]) -> bool {
        self.sum = checksum(self.sum, program.iter().skip(self.place).take(SLICE));
        self.place = self.place.saturating_add(SLICE);
        if self.place >= program.len() {
            self.is_sound &= self.expected.get() == Some([!self.sum]);
            (self.place, self.sum) = (0, u32::MAX);
        }
        self.is_sound
    }
}

/// Goes on with a checksum over these bytes.
fn checksum<'a>(sum: u32, bytes: impl Iterator<Item = &'a u8>) -> u32 {
    bytes.fold(sum, |sum, byte| {
        [*byte, *byte >> 4].into_iter().fold(sum, |sum, part| {
            let remainder = REMAINDERS.get(usize::from((sum as u8 ^ part) & 15));
            sum >> 4 ^ remainder.copied().unwrap_or(0)
        })
    })
}

const fn remainders() -> [u32; 16] {
    let mut table = [0; 16];
    let mut n = 0;
    while n < 16 {
        let (mut sum, mut bit) = (n as u32, 0);
        while bit < 4 {
            sum = if sum & 1 == 1 { sum >> 1 ^ 0xEDB8_8320 } else { sum >> 1 };
            bit += 1;
        }
        table[n] = sum;
        n += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::{Integrity, SLICE};
    use crate::link::frame::checksum;

    const PROGRAM: [u8; 100] = [0x5A; 100];

    fn built(program: &[u8]) -> u32 {
        u32::from_le_bytes(checksum(program))
    }

    /// Rounds of this program.
    fn rounds(integrity: &mut Integrity, program: &[u8], count: usize) -> bool {
        (0..count * program.len().div_ceil(SLICE)).fold(true, |_, _| integrity.take(program))
    }

    #[test]
    fn the_checksum_is_that_of_frames() {
        let program: [u8; 77] = core::array::from_fn(|n| (n * n) as u8);
        assert!(rounds(&mut Integrity::new(&program, built(&program)), &program, 3));
        assert!(!Integrity::new(&program, built(&program) ^ 1).take(&program));
    }

    #[test]
    fn every_flipped_bit_is_found_within_two_rounds_and_at_a_start_at_once() {
        for bit in 0..8 * PROGRAM.len() {
            let (mut integrity, mut program) = (Integrity::new(&PROGRAM, built(&PROGRAM)), PROGRAM);
            assert!(rounds(&mut integrity, &program, 3));
            program[bit / 8] ^= 1 << (bit % 8);
            assert!(!rounds(&mut integrity, &program, 2), "bit {bit}");
            // A second flip does not mend it.
            assert!(!rounds(&mut integrity, &PROGRAM, 2), "bit {bit}");
            assert!(!Integrity::new(&program, built(&PROGRAM)).take(&program), "bit {bit}");
        }
    }

    #[test]
    fn no_program_is_sound() {
        assert!((0..5).all(|_| Integrity::new(&[], 0).take(&[])));
    }
}
