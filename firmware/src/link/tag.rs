//! Tags that authenticate commands.
//!
//! In: a key shared by supervisor and tile, and the bytes of header and command. Out: eight bytes that nobody can
//! make without the key, by SipHash-2-4 (Aumasson & Bernstein 2012), a keyed function for short messages.
//! Tile, boot counter, sequence number and tick are among the bytes, so a tag is valid once, for one tile and one time.
//! With one attempt per tick a forger needs some 10^8 years.

use core::hash::Hasher;
use siphasher::sip::SipHasher24;

/// Bytes of a tag.
pub const TAG: usize = 8;
/// A tag.
pub type Tag = [u8; TAG];

/// The key. Its bytes are never printed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Key([u8; 16]);

impl core::fmt::Debug for Key {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Key(..)")
    }
}

impl Key {
    /// The key of these bytes.
    #[must_use]
    pub const fn new(bytes: [u8; 16]) -> Self {
        Self(bytes)
    }

    /// The tag of these bytes.
    #[must_use]
    pub fn tag(&self, bytes: &[u8]) -> Tag {
        let mut hasher = SipHasher24::new_with_key(&self.0);
        hasher.write(bytes);
        hasher.finish().to_le_bytes()
    }

    /// Whether this is the tag of these bytes, in constant time. Not inlined, because the image's checks limit its cost
    /// separately.
    #[must_use]
    #[inline(never)]
    pub fn vouches(&self, bytes: &[u8], tag: Tag) -> bool {
        u64::from_le_bytes(self.tag(bytes)) ^ u64::from_le_bytes(tag) == 0
    }
}

#[cfg(test)]
mod tests {
    use super::Key;

    #[test]
    fn agrees_with_the_published_vectors() {
        // Aumasson and Bernstein, appendix A, and the first three of the reference implementation.
        let bytes: [u8; 16] = core::array::from_fn(|i| i as u8);
        let key = Key::new(bytes);
        assert_eq!(u64::from_le_bytes(key.tag(&bytes[..15])), 0xa129_ca61_49be_45e5);
        assert_eq!(key.tag(&[]), [0x31, 0x0e, 0x0e, 0xdd, 0x47, 0xdb, 0x6f, 0x72]);
        assert_eq!(key.tag(&[0]), [0xfd, 0x67, 0xdc, 0x93, 0xc5, 0x39, 0xf8, 0x74]);
        assert_eq!(key.tag(&[0, 1]), [0x5a, 0x4f, 0xa9, 0xd9, 0x09, 0x80, 0x6c, 0x0d]);
    }

    #[test]
    fn every_bit_matters() {
        let key = Key::new([7; 16]);
        let bytes = [1, 2, 3, 4, 5];
        let tag = key.tag(&bytes);
        assert!(key.vouches(&bytes, tag));
        for bit in 0..64 {
            let mut other = tag;
            other[bit / 8] ^= 1 << (bit % 8);
            assert!(!key.vouches(&bytes, other));
        }
        for bit in 0..40 {
            let mut other = bytes;
            other[bit / 8] ^= 1 << (bit % 8);
            assert!(!key.vouches(&other, tag));
        }
    }
}
