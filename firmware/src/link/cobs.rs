//! Consistent overhead byte stuffing: bytes without zeros, so that a zero always ends a frame.
//!
//! In: bytes. Out: the same bytes as blocks, each a code c in 1..=255 followed by c - 1 bytes that are not 0;
//! every block, except one of 255 and the last, also encodes a zero after it (Cheshire & Baker 1999).

use heapless::Vec;

/// Appends `bytes`, stuffed, to `out`; false if it is full.
pub fn encode<const N: usize>(bytes: impl IntoIterator<Item = u8>, out: &mut Vec<u8, N>) -> bool {
    let mut code_at = out.len();
    let mut code = 1_u8;
    let mut fits = out.push(code).is_ok();
    for byte in bytes {
        if byte != 0 {
            fits &= out.push(byte).is_ok();
            code += 1;
        }
        if byte == 0 || code == u8::MAX {
            set(out, code_at, code);
            code_at = out.len();
            code = 1;
            fits &= out.push(code).is_ok();
        }
    }
    set(out, code_at, code);
    fits
}

fn set(bytes: &mut [u8], place: usize, value: u8) {
    if let Some(byte) = bytes.get_mut(place) {
        *byte = value;
    }
}

/// Decodes stuffed bytes one at a time.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Unstuffer {
    /// Bytes left in the block.
    left: u8,
    /// Whether a zero precedes the next block.
    zero_due: bool,
}

/// Result of decoding a stuffed byte, which is never 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unstuffed {
    /// No byte yet.
    Nothing,
    /// A byte.
    Byte(u8),
}

impl Unstuffer {
    /// Decodes the next byte, not 0.
    pub fn take(&mut self, byte: u8) -> Unstuffed {
        if let Some(left) = self.left.checked_sub(1) {
            self.left = left;
            return Unstuffed::Byte(byte);
        }
        let zero = self.zero_due;
        self.left = byte.saturating_sub(1);
        self.zero_due = byte != u8::MAX;
        if zero { Unstuffed::Byte(0) } else { Unstuffed::Nothing }
    }

    /// Whether the frame may end here.
    #[must_use]
    pub fn is_whole(self) -> bool {
        self.left == 0
    }
}

#[cfg(test)]
mod tests {
    use super::{Unstuffed, Unstuffer, encode};
    use heapless::Vec;
    use proptest::collection::vec;
    use proptest::prelude::{Just, any, prop_oneof, proptest};

    proptest! {
        /// The oracle is the crate `cobs`, which shares nothing with this file.
        #[test]
        fn agrees_with_another_coder(bytes in vec(prop_oneof![Just(0_u8), any::<u8>(), 1..=255_u8], 0..600)) {
            let mut out = Vec::<u8, 700>::new();
            assert!(encode(bytes.iter().copied(), &mut out));
            assert_eq!(cobs::decode_vec(&out).as_ref(), Ok(&bytes));
            // A block of 255 at the very end may be followed by an empty one: both forms mean the same.
            let other = cobs::encode_vec(&bytes);
            assert!(out[..] == other[..] || out[..out.len() - 1] == other[..], "{out:?} {other:?}");
            for stuffed in [&out[..], &other] {
                let mut unstuffer = Unstuffer::default();
                let mut back = std::vec::Vec::new();
                for byte in stuffed {
                    if let Unstuffed::Byte(byte) = unstuffer.take(*byte) {
                        back.push(byte);
                    }
                }
                assert!(unstuffer.is_whole());
                assert_eq!(back, bytes);
            }
        }
    }

    #[test]
    fn a_full_buffer_is_told() {
        assert!(!encode([1, 2, 3], &mut Vec::<u8, 3>::new()));
        assert!(encode([1, 2, 3], &mut Vec::<u8, 4>::new()));
    }
}
