//! Precomputed rest shapes of a body at each pressure, for pressures that change slower than the body vibrates.
//!
//! In: coefficients of Chebyshev polynomials for every node and for the volume, a pressure. Out: positions, volume.
//! x(p) = sum c_k T_k(s), s = -1 to 1 over the range of pressures; T_k+1 = 2 s T_k - T_k-1.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// The precomputed coefficients.
#[derive(Clone, Copy, Debug)]
pub struct Rest<'a, S> {
    /// Lowest and highest pressure (Pa); beyond them the shape stays that at the bound.
    pub range: [S; 2],
    /// Coefficients of the positions (m): those of all nodes for the first polynomial, then for the next.
    pub places: &'a [Vec3<S>],
    /// Coefficients of the volume (m^3).
    pub volume: &'a [S],
}

impl<S: Scalar> Rest<'_, S> {
    /// Writes the positions at rest at a pressure (Pa); returns the volume (m^3).
    #[inline(always)]
    pub fn place(&self, pressure: S, pos: &mut [Vec3<S>]) -> S {
        let [low, high] = self.range;
        let s = (pressure - low + pressure - high) / (high - low);
        let s = s.max(-S::ONE).min(S::ONE);
        let (mut now, mut next, mut volume) = (S::ONE, s, S::ZERO);
        pos.as_flattened_mut().fill(S::ZERO);
        for (places, share) in self.places.chunks_exact(pos.len().max(1)).zip(self.volume) {
            for (x, place) in pos.iter_mut().zip(places) {
                *x = vec3::axpy(*x, now, *place);
            }
            volume = volume + now * *share;
            (now, next) = (next, (s + s) * next - now);
        }
        volume
    }
}
