//! The program checks itself: its checksum is taken anew all the time, a slice a tick.
//!
//! In: the program's bytes. Out: are they still those of the first round? CRC-32 as in `link::frame`, four bits at a
//! time: every flipped bit changes it.

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
    /// The checksum of the first round.
    first: Option<Guarded<1>>,
    is_sound: bool,
}

impl Default for Integrity {
    fn default() -> Self {
        Self { place: 0, sum: u32::MAX, first: None, is_sound: true }
    }
}

impl Integrity {
    /// Goes on by a slice; is the program still what it was? What was once wrong stays so.
    pub fn take(&mut self, program: &[u8]) -> bool {
        for byte in program.iter().skip(self.place).take(SLICE) {
            for part in [*byte, *byte >> 4] {
                let remainder = REMAINDERS.get(usize::from((self.sum as u8 ^ part) & 15));
                self.sum = self.sum >> 4 ^ remainder.copied().unwrap_or(0);
            }
        }
        self.place = self.place.saturating_add(SLICE);
        if self.place >= program.len() {
            match &self.first {
                None => self.first = Some(Guarded::new([self.sum])),
                Some(first) => self.is_sound &= first.get() == Some([self.sum]),
            }
            (self.place, self.sum) = (0, u32::MAX);
        }
        self.is_sound
    }

    /// The checksum of the first round, once it is over.
    #[must_use]
    pub fn checksum(&self) -> Option<u32> {
        self.first.as_ref()?.get().map(|[sum]| !sum)
    }
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

    /// Rounds of this program.
    fn rounds(integrity: &mut Integrity, program: &[u8], count: usize) -> bool {
        (0..count * program.len().div_ceil(SLICE)).fold(true, |_, _| integrity.take(program))
    }

    #[test]
    fn the_checksum_is_that_of_frames() {
        let mut integrity = Integrity::default();
        let program: [u8; 77] = core::array::from_fn(|n| (n * n) as u8);
        assert!(rounds(&mut integrity, &program, 1));
        assert_eq!(integrity.checksum().map(u32::to_le_bytes), Some(checksum(&program)));
    }

    #[test]
    fn every_flipped_bit_is_found_within_two_rounds() {
        for bit in 0..8 * PROGRAM.len() {
            let (mut integrity, mut program) = (Integrity::default(), PROGRAM);
            assert!(rounds(&mut integrity, &program, 3));
            program[bit / 8] ^= 1 << (bit % 8);
            assert!(!rounds(&mut integrity, &program, 2), "bit {bit}");
            // A second flip does not mend it.
            assert!(!rounds(&mut integrity, &PROGRAM, 2), "bit {bit}");
        }
    }

    #[test]
    fn no_program_is_sound() {
        assert!(rounds(&mut Integrity::default(), &[0], 5));
        assert!((0..5).all(|_| Integrity::default().take(&[])));
    }
}
