//! Boxes around things, by which pairs that are too far apart to touch are skipped.
//!
//! In: points of a thing. Out: the axis-aligned box around them, and whether two boxes come near each other.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Axis-aligned box around a thing, in N (m); infinite for a thing without bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent<S> {
    pub(super) low: Vec3<S>,
    pub(super) high: Vec3<S>,
}

impl<S: Scalar> Extent<S> {
    /// The infinite box.
    #[must_use]
    pub fn everywhere() -> Extent<S> {
        let far = S::from_f64(f64::INFINITY);
        Extent { low: [-far; 3], high: [far; 3] }
    }

    /// The box around points; None if there are none.
    pub(super) fn around(points: &[Vec3<S>]) -> Option<Extent<S>> {
        let first = *points.first()?;
        // Four points side by side: twelve numbers fill registers.
        let (mut low, mut high) = ([first; 4], [first; 4]);
        let (blocks, rest) = points.as_chunks::<4>();
        for block in blocks {
            let lanes = low.as_flattened_mut().iter_mut().zip(high.as_flattened_mut());
            for ((low, high), x) in lanes.zip(block.as_flattened()) {
                // Comparisons, unlike `min`, do not ask whether a number is one.
                *low = if *x < *low { *x } else { *low };
                *high = if *x > *high { *x } else { *high };
            }
        }
        let corners = low.into_iter().chain(high).chain(rest.iter().copied());
        Some(corners.fold(Extent { low: first, high: first }, Extent::with))
    }

    /// Whether it has bounds.
    pub(super) fn is_bounded(&self) -> bool {
        self.low.iter().chain(&self.high).all(|x| x.is_finite())
    }

    /// The box that holds a point, too.
    pub(super) fn with(self, point: Vec3<S>) -> Extent<S> {
        let Extent { low: [a, b, c], high: [d, e, f] } = self;
        let [x, y, z] = point;
        Extent { low: [a.min(x), b.min(y), c.min(z)], high: [d.max(x), e.max(y), f.max(z)] }
    }

    /// Length of the box's diagonal (m); infinite without bounds.
    #[must_use]
    pub fn diagonal(&self) -> S {
        vec3::norm(vec3::sub(self.high, self.low))
    }

    /// Whether points of the two boxes may be within `margin` (m) of each other.
    pub(super) fn is_near(&self, other: &Extent<S>, margin: S) -> bool {
        (0..3).all(|i| self.low[i] - margin <= other.high[i] && other.low[i] - margin <= self.high[i])
    }
}
