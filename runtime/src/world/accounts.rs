//! Where the energy of a world goes: an observer, no step reads it.

use crate::real::Scalar;

/// Energy taken by its ways (J), summed over steps.
///
/// ```text
/// E(t) - E(0) + damping + drag + impact + friction - drive = error of the method
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accounts<S> {
    /// By dampers.
    pub damping: S,
    /// By the air.
    pub drag: S,
    /// By normal impulses of contacts.
    pub impact: S,
    /// By friction.
    pub friction: S,
    /// Given by commanded motion (work of the drives on what is commanded).
    pub drive: S,
}

impl<S: Scalar> Accounts<S> {
    /// Nothing yet.
    #[must_use]
    pub fn empty() -> Accounts<S> {
        let zero = S::ZERO;
        Accounts { damping: zero, drag: zero, impact: zero, friction: zero, drive: zero }
    }

    /// Both together.
    #[must_use]
    pub fn plus(&self, other: &Accounts<S>) -> Accounts<S> {
        Accounts {
            damping: self.damping + other.damping,
            drag: self.drag + other.drag,
            impact: self.impact + other.impact,
            friction: self.friction + other.friction,
            drive: self.drive + other.drive,
        }
    }

    /// A multiple of all.
    #[must_use]
    pub fn times(&self, factor: S) -> Accounts<S> {
        Accounts {
            damping: factor * self.damping,
            drag: factor * self.drag,
            impact: factor * self.impact,
            friction: factor * self.friction,
            drive: factor * self.drive,
        }
    }

    /// What has left the world (J).
    #[must_use]
    pub fn lost(&self) -> S {
        self.damping + self.drag + self.impact + self.friction - self.drive
    }
}
