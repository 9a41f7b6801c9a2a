//! CRC-32 of frames, records and the program: CRC-32/ISO-HDLC of the catalogue, also zlib's.
//!
//! In: bytes, in one piece or several. Out: the checksum. Four bits at a time: a table of 64 bytes instead of a
//! kilobyte, twelve cycles per byte instead of six. Detects every error burst of up to 32 bits.

/// Bytes of the checksum, lowest first.
pub const CHECKSUM: usize = 4;
/// Remainders of four bits by the reflected polynomial 0xEDB88320 (Rocksoft's model, CRC-32/ISO-HDLC).
const REMAINDERS: [u32; 16] = remainders();
/// Initial value of a sum.
pub const BEGIN: u32 = u32::MAX;

/// Continues a sum over these bytes; its complement is the checksum.
// Not inlined: it has many callers, and flash is short.
#[inline(never)]
#[must_use]
pub fn go_on(sum: u32, bytes: &[u8]) -> u32 {
    bytes.iter().fold(sum, |sum, byte| {
        [*byte, *byte >> 4].into_iter().fold(sum, |sum, part| {
            let remainder = REMAINDERS.get(usize::from((sum as u8 ^ part) & 15));
            sum >> 4 ^ remainder.copied().unwrap_or(0)
        })
    })
}

/// The checksum of these bytes, as sent.
#[must_use]
pub fn checksum(bytes: &[u8]) -> [u8; CHECKSUM] {
    (!go_on(BEGIN, bytes)).to_le_bytes()
}

/// The bytes before a checksum at the end, if it is right.
#[must_use]
pub fn checked(bytes: &[u8]) -> Option<&[u8]> {
    let (body, sum) = bytes.split_last_chunk::<CHECKSUM>()?;
    (*sum == checksum(body)).then_some(body)
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
    use super::{BEGIN, checked, checksum, go_on};
    use crc::{CRC_32_ISO_HDLC, Crc};
    use proptest::collection::vec;
    use proptest::prelude::{any, proptest};

    #[test]
    fn the_checksum_is_the_published_one() {
        assert_eq!(u32::from_le_bytes(checksum(b"123456789")), 0xCBF4_3926);
        assert_eq!((checked(b"123"), checked(&[0; 4])), (None, Some(&[][..])));
    }

    proptest! {
        #[test]
        fn it_is_that_of_another_program(bytes in vec(any::<u8>(), 0..300), cut in any::<usize>()) {
            let expected = Crc::<u32>::new(&CRC_32_ISO_HDLC).checksum(&bytes);
            assert_eq!(u32::from_le_bytes(checksum(&bytes)), expected);
            let (first, second) = bytes.split_at(cut % (bytes.len() + 1));
            assert_eq!(!go_on(go_on(BEGIN, first), second), expected);
        }
    }
}
