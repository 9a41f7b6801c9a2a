//! A contact that takes part in an impact, and how an impact ended: what the laws at several points (`several`,
//! `plastic`) have in common.

use super::contact::{Contact, Inertia};
use super::impact::InverseMass;
use crate::real::Scalar;
use crate::vec3;

/// An impulse (N s) along three axes that another contact feels if it feels any: in no special direction.
#[inline(always)]
pub(crate) fn asking<S: Scalar>() -> vec3::Vec3<S> {
    [S::ONE, S::from_f64(0.618_034), S::from_f64(0.414_214)]
}

/// A contact during an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Struck<S> {
    /// The contact; its impulse is the result.
    pub contact: Contact<S>,
    /// The contact's inverse mass matrix K.
    pub(super) inverse_mass: InverseMass<S>,
    /// E (J), stored.
    pub(super) stored: S,
    /// Of the piece on trial: E after it, its impulse, the relative velocity before it.
    pub(super) trial: S,
    /// How much the contact still lasts at the end of the piece: 1 at most, 0 where it ends, negative beyond.
    pub(super) lasts: S,
    pub(super) piece: vec3::Vec3<S>,
    pub(super) before: vec3::Vec3<S>,
    /// Whether it has ended at the end of the piece.
    pub(super) ended: bool,
    /// Friction per normal impulse in the last piece, from which the next one starts.
    pub(super) ratio: [S; 2],
    /// Which group it belongs to: that which has its turn, one before, or one after it.
    pub(super) group: Group,
}

/// Contacts of an impact that may feel one another's impulses are resolved together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    /// Its group has its turn later.
    Later,
    /// It belongs to the group that has its turn; which others feel its impulse is not known yet.
    Asks,
    /// It belongs to the group that has its turn.
    Now,
    /// Its group is resolved.
    Done,
}

/// Result of an impact at several points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Number of pieces.
    pub pieces: usize,
    /// Whether the pieces sufficed; if not, the rest ended as with e = 0.
    pub complete: bool,
}

impl<S: Scalar> Struck<S> {
    /// A contact that takes part, with its inverse mass.
    #[must_use]
    pub fn new(contact: Contact<S>, inertia: &(impl Inertia<S> + ?Sized)) -> Struck<S> {
        let inverse_mass = contact.inverse_mass(inertia);
        let zero = vec3::zero();
        let (piece, before, ratio) = (zero, zero, [S::ZERO; 2]);
        Struck {
            contact,
            inverse_mass,
            stored: S::ZERO,
            trial: S::ZERO,
            lasts: S::ZERO,
            piece,
            before,
            ended: false,
            ratio,
            group: Group::Later,
        }
    }

    /// The speed that its normal impulse alone would stop (m/s).
    pub(crate) fn stopped(&self) -> S {
        self.contact.impulse[0] * self.inverse_mass[0][0]
    }
}
