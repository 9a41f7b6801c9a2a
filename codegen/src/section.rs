//! Sections of the equations, in the order in which they are derived.
//!
//! The derivation labels each value with its section; comments of the emitted functions say where a section begins.

/// A section.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Section {
    /// Sines, cosines, places.
    Orientations,
    /// Dependent speeds by independent ones.
    Constraints,
    /// Dependent speeds, and the accelerations that remain at u' = 0.
    Velocities,
    /// The mass matrix.
    Inertia,
    /// Generalised active and inertia forces.
    Forces,
    /// The elimination of M, accelerations, and everything else that is returned.
    Results,
}

impl Section {
    /// The text of the section's comment in emitted code.
    #[must_use]
    pub fn heading(self) -> &'static str {
        match self {
            Self::Orientations => "Orientations: sines and cosines of angles, places",
            Self::Constraints => "Constraints: coefficients of the independent speeds in the others",
            Self::Velocities => "Velocities: dependent speeds, accelerations at constant independent speeds",
            Self::Inertia => "Inertia: the mass matrix M",
            Self::Forces => "Forces: generalised active and inertia forces",
            Self::Results => "Results: elimination of M, accelerations and what else is returned",
        }
    }
}
