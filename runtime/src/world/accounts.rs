//! Energy accounts of a world: they observe, no step reads them.

use crate::real::Scalar;

/// Energy lost to each cause (J), summed over steps.
///
/// ```text
/// E(t) - E(0) + damping + drag + impact + friction - drive = error of the method
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accounts<S> {
    /// Dissipated by dampers.
    pub damping: S,
    /// Dissipated by air drag.
    pub drag: S,
    /// Lost to normal impulses of contacts.
    pub impact: S,
    /// Dissipated by friction.
    pub friction: S,
    /// Supplied by commanded motion (work of the drives on the parts that they command).
    pub drive: S,
}

impl<S: Scalar> Accounts<S> {
    /// All zero.
    #[must_use]
    pub fn empty() -> Accounts<S> {
        let zero = S::ZERO;
        Accounts { damping: zero, drag: zero, impact: zero, friction: zero, drive: zero }
    }

    /// Sum of both, account by account.
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

    /// Every account times a factor.
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

    /// The same numbers in double precision.
    #[must_use]
    pub fn to_f64(&self) -> Accounts<f64> {
        Accounts {
            damping: self.damping.to_f64(),
            drag: self.drag.to_f64(),
            impact: self.impact.to_f64(),
            friction: self.friction.to_f64(),
            drive: self.drive.to_f64(),
        }
    }

    /// Energy that has left the world (J), net of what the drives supplied.
    #[must_use]
    pub fn lost(&self) -> S {
        self.damping + self.drag + self.impact + self.friction - self.drive
    }
}
