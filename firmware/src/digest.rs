//! A digest of a trajectory: FNV-1a, 64 bits, over the bytes of every number's bits.
//!
//! Trajectories with the same digest count as equal to the bit. -0 and 0 differ.

/// A digest in progress.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// Adds the bits of these numbers, lowest byte first.
    pub fn add(&mut self, numbers: &[f32]) {
        for byte in numbers.iter().flat_map(|x| x.to_bits().to_le_bytes()) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// The digest as 16 hexadecimal digits.
    #[must_use]
    pub fn hex(self) -> [u8; 16] {
        let mut text = [b'0'; 16];
        for (digit, shift) in text.iter_mut().zip((0..16).rev()) {
            let nibble = (self.0 >> (4 * shift) & 15) as u8;
            *digit = if nibble < 10 { b'0' + nibble } else { b'a' + (nibble - 10) };
        }
        text
    }
}

/// Writes how a simulation ended: its digest, or that a step was refused. Returns whether there is a digest.
pub fn report(digest: Option<Digest>, mut write: impl FnMut(&[u8])) -> bool {
    match digest {
        Some(digest) => {
            write(b"digest ");
            write(&digest.hex());
            write(b"\n");
        }
        None => write(b"a step was refused\n"),
    }
    digest.is_some()
}

#[cfg(test)]
mod tests {
    use super::Digest;

    #[test]
    fn agrees_with_the_published_vector() {
        // FNV-1a 64 of the bytes "foobar": four through a number, two by hand.
        let mut digest = Digest::default();
        digest.add(&[f32::from_bits(u32::from_le_bytes(*b"foob"))]);
        for byte in *b"ar" {
            digest.0 = (digest.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        assert_eq!(&digest.hex(), b"85944171f73967e8");
    }

    #[test]
    fn one_bit_matters() {
        let digest = |x: f32| {
            let mut digest = Digest::default();
            digest.add(&[1.0, x]);
            digest
        };
        assert_ne!(digest(0.0), digest(-0.0));
        assert_ne!(digest(1.0), digest(1.0 + f32::EPSILON));
    }
}
