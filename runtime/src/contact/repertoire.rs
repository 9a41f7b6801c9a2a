//! Methods, elements and laws that a program is compiled with.
//!
//! A host reads any scene and so takes [`Full`]; a microcontroller's image names what its one scene has, and the
//! compiler leaves out the rest. What is left out must not occur: the constants are printed from the scene itself.

use crate::ode::nodes::{Method, Step};
use crate::real::Scalar;
use core::fmt::Debug;

/// The choice at compile time; by default everything.
pub trait Repertoire<S: Scalar>: Copy + Debug {
    /// Integration method between events.
    type Method: Step<S> + Debug;
    /// Dampers, air drag, or a dissipative ground.
    const DAMPING: bool = true;
    /// Gas inside facets.
    const GAS: bool = true;
    /// Impact with energy compensation.
    const COMPENSATION: bool = true;
    /// The correction of energy drift by compensation.
    const ANCHOR: bool = true;
    /// Newton's law of impact.
    const NEWTON: bool = true;
    /// Moreau's time stepping.
    const MOREAU: bool = true;
    /// Massless points.
    const MASSLESS: bool = true;
    /// A soft ground.
    const SOFT: bool = true;
    /// Coulomb's friction.
    const FRICTION: bool = true;
}

/// Everything, with the method chosen at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Full;

impl<S: Scalar> Repertoire<S> for Full {
    type Method = Method<S>;
}
