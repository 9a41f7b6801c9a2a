//! Impact laws between two rigid bodies, and their parameters.

use crate::real::Scalar;

/// Kind of impact law.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Restitution of energy at each point (Stronge).
    Stronge,
    /// Restitution of velocity (Newton), without friction.
    Newton,
    /// Energy compensation: the energy lost with e = 0 is given back along the same impulses.
    Compensation,
}

/// A law with its parameters; with any of them it creates no energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law<S> {
    kind: Kind,
    restitution: S,
    friction: S,
}

/// Why a law is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LawFault {
    /// Restitution (or the share of compensation) must be from 0 to 1.
    Restitution,
    /// mu must be 0 or more.
    Friction,
    /// Newton's restitution with friction can create energy (Kane 1984): take Stronge's.
    NewtonWithFriction,
}

impl<S: Scalar> Law<S> {
    fn checked(kind: Kind, restitution: S, friction: S) -> Result<Law<S>, LawFault> {
        if !(S::ZERO <= restitution && restitution <= S::ONE) {
            return Err(LawFault::Restitution);
        }
        if !(friction >= S::ZERO && friction.is_finite()) {
            return Err(LawFault::Friction);
        }
        Ok(Law { kind, restitution, friction })
    }

    /// Stronge's e and Coulomb's mu.
    ///
    /// # Errors
    /// [`LawFault`] for numbers out of range.
    pub fn stronge(restitution: S, friction: S) -> Result<Law<S>, LawFault> {
        Law::checked(Kind::Stronge, restitution, friction)
    }

    /// Newton's e; friction is refused.
    ///
    /// # Errors
    /// [`LawFault`] for numbers out of range and for mu > 0.
    pub fn newton(restitution: S, friction: S) -> Result<Law<S>, LawFault> {
        if friction > S::ZERO {
            return Err(LawFault::NewtonWithFriction);
        }
        Law::checked(Kind::Newton, restitution, friction)
    }

    /// Compensation with the share eta of the energy that is given back, and mu.
    ///
    /// # Errors
    /// [`LawFault`] for numbers out of range.
    pub fn compensation(share: S, friction: S) -> Result<Law<S>, LawFault> {
        let law = Law::checked(Kind::Compensation, share, friction)?;
        // With one point and no friction eta = e^2.
        Ok(Law { restitution: share.sqrt(), ..law })
    }

    /// The kind of law.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// e; sqrt(eta) for compensation.
    #[must_use]
    pub fn restitution(&self) -> S {
        self.restitution
    }

    /// mu.
    #[must_use]
    pub fn friction(&self) -> S {
        self.friction
    }
}
