//! Noise by number: seed and sample number determine the noise, whatever was drawn before.
//!
//! The bits are those of a mixing function of the number (SplitMix64: Steele, Lea & Flood 2014); two of its values give
//! a normal one (Box & Muller 1958). Uniform numbers have 24 bits in every scalar, so f32 and f64 see the same noise.

use crate::real::Scalar;

/// A source of noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Noise {
    seed: u64,
}

/// Increment of the generator: 2^64 over the golden ratio.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// Mixes bits.
fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A whole number below 2^24 as a scalar; larger ones give 2^24 - 1.
#[must_use]
pub(super) fn whole<S: Scalar>(number: u64) -> S {
    let number = number.min((1 << 24) - 1);
    let mut value = S::ZERO;
    for bit in (0..24).rev() {
        value = value + value;
        if number & (1 << bit) != 0 {
            value = value + S::ONE;
        }
    }
    value
}

impl Noise {
    /// A source for this seed.
    #[must_use]
    pub fn new(seed: u64) -> Noise {
        Noise { seed: mixed(seed.wrapping_add(STEP)) }
    }

    /// 64 pseudo-random bits for a number.
    #[must_use]
    pub fn bits(&self, number: u64) -> u64 {
        mixed(self.seed.wrapping_add(number.wrapping_mul(STEP)))
    }

    /// A normal deviate of mean 0 and standard deviation 1 for a number.
    #[must_use]
    pub fn normal<S: Scalar>(&self, number: u64) -> S {
        let bits = self.bits(number);
        let unit = S::from_f64(1.0 / 16_777_216.0);
        // In (0, 1): the logarithm is finite.
        let radius = (whole::<S>(bits >> 40) + S::from_f64(0.5)) * unit;
        let angle = whole::<S>((bits >> 8) & 0xff_ffff) * unit * S::from_f64(2.0 * core::f64::consts::PI);
        let (_, cos) = angle.sin_cos();
        (S::from_f64(-2.0) * radius.ln()).sqrt() * cos
    }
}
