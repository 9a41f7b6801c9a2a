//! Sections of the equations, in the order in which they are derived.
//!
//! The derivation labels values with the section that they belong to; emitted functions say where a section begins.

/// A section.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Section {
    /// Sines, cosines, places.
    Orientations,
    /// Dependent speeds by independent ones.
    Constraints,
    /// Speeds, and what of accelerations they leave where they stay as they are.
    Velocities,
    /// The mass matrix.
    Inertia,
    /// Forces of loads and of inertia.
    Forces,
    /// What is solved for, and all other results.
    Results,
}

impl Section {
    /// What a comment says of it.
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
