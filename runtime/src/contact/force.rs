//! Force laws of contact: how hard an overlap pushes, what it stores and what it takes.
//!
//! In: depth of the overlap (m, > 0) and its rate. Out: force (N), stored energy (J), slope (N/m).
//! ```text
//! penalty         N = k depth,                              E = k depth^2 / 2
//! Hunt-Crossley   N = k depth^1.5 (1 + a depth_rate) >= 0,  E = 2/5 k depth^2.5      Hunt & Crossley (1975)
//! ```

use crate::real::Scalar;

/// A force that depends on depth, and perhaps on its rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ForceLaw<S> {
    /// A linear spring on the depth.
    Penalty {
        /// k (N/m).
        stiffness: S,
    },
    /// N = k depth^1.5 (1 + a depth_rate), never pulling.
    HuntCrossley {
        /// k [N/m^1.5].
        stiffness: S,
        /// a (s/m).
        dissipation: S,
    },
}

impl<S: Scalar> ForceLaw<S> {
    /// The force (N), and the part of it that dissipates (N), at a depth (m) that grows at a rate (m/s).
    #[must_use]
    pub fn force(&self, depth: S, rate: S) -> (S, S) {
        if depth <= S::ZERO {
            return (S::ZERO, S::ZERO);
        }
        match *self {
            ForceLaw::Penalty { stiffness } => (stiffness * depth, S::ZERO),
            ForceLaw::HuntCrossley { stiffness, dissipation } => {
                let elastic = stiffness * depth * depth.sqrt();
                // Computed directly: as a difference of forces it would be lost in their rounding near rest.
                let viscous = (elastic * dissipation * rate).max(-elastic);
                (elastic + viscous, viscous)
            }
        }
    }

    /// Stored energy at a depth (J).
    #[must_use]
    pub fn energy(&self, depth: S) -> S {
        let depth = depth.max(S::ZERO);
        match *self {
            ForceLaw::Penalty { stiffness } => S::from_f64(0.5) * stiffness * depth * depth,
            ForceLaw::HuntCrossley { stiffness, .. } => {
                S::from_f64(0.4) * stiffness * depth * depth * depth.sqrt()
            }
        }
    }

    /// Slope dN/d depth of the part that stores energy (N/m).
    #[must_use]
    pub fn slope(&self, depth: S) -> S {
        match *self {
            ForceLaw::Penalty { stiffness } => stiffness,
            ForceLaw::HuntCrossley { stiffness, .. } => {
                S::from_f64(1.5) * stiffness * depth.max(S::ZERO).sqrt()
            }
        }
    }

    /// a (s/m): 0 where nothing dissipates.
    #[must_use]
    pub fn dissipation(&self) -> S {
        match *self {
            ForceLaw::Penalty { .. } => S::ZERO,
            ForceLaw::HuntCrossley { dissipation, .. } => dissipation,
        }
    }

    /// Whether its numbers are finite and not negative.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let (ForceLaw::Penalty { stiffness } | ForceLaw::HuntCrossley { stiffness, .. }) = *self;
        [stiffness, self.dissipation()].into_iter().all(|x| x >= S::ZERO && x.is_finite())
    }

    /// The same law in another scalar: every number rounded once.
    #[must_use]
    pub fn rounded<T: Scalar>(&self) -> ForceLaw<T> {
        let real = |x: S| T::from_f64(x.to_f64());
        match *self {
            ForceLaw::Penalty { stiffness } => ForceLaw::Penalty { stiffness: real(stiffness) },
            ForceLaw::HuntCrossley { stiffness, dissipation } => {
                ForceLaw::HuntCrossley { stiffness: real(stiffness), dissipation: real(dissipation) }
            }
        }
    }
}
