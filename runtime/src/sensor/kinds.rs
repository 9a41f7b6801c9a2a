//! Transducers: how a quantity is converted before it is sampled.
//!
//! Encoder: counts of a rotor behind gear and screw. LVDT: a position with a nonlinear characteristic. Switch: a
//! threshold with hysteresis, chattering when it changes. Pressure: a membrane that follows with a lag.

use super::noise::Noise;
use crate::real::Scalar;

/// Change of height (m) per count of an encoder on the rotor: lead / (4 lines gear).
#[must_use]
pub fn encoder_resolution<S: Scalar>(lines: S, gear: S, lead: S) -> S {
    lead / (S::from_f64(4.0) * lines * gear)
}

/// A linear variable differential transformer (LVDT).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lvdt<S> {
    /// Half its range (m).
    pub reach: S,
    /// Largest deviation from the straight line, relative to the reach.
    pub linearity: S,
}

impl<S: Scalar> Lvdt<S> {
    /// The position (m) reported for a position: x + c (x/r)(1 - (x/r)^2) r, exact in the middle and at both ends.
    #[must_use]
    pub fn report(&self, place: S) -> S {
        // x (1 - x^2) is at most 2/(3 sqrt 3).
        let scale = self.linearity * S::from_f64(2.598_076_211_353_316);
        let share = (place / self.reach).max(-S::ONE).min(S::ONE);
        place + self.reach * scale * share * (S::ONE - share * share)
    }
}

/// A limit switch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch<S> {
    /// Position at which it closes, coming from below.
    pub closes: S,
    /// Distance below that at which it opens again, >= 0.
    pub hysteresis: S,
    /// Ticks for which its contact chatters after a change.
    pub chatter: u32,
    source: Noise,
    /// Whether it is closed.
    pub closed: bool,
    /// Tick of its last change.
    pub changed: Option<u64>,
}

impl<S: Scalar> Switch<S> {
    /// An open switch.
    #[must_use]
    pub fn new(closes: S, hysteresis: S, chatter: u32, seed: u64) -> Switch<S> {
        Switch { closes, hysteresis, chatter, source: Noise::new(seed), closed: false, changed: None }
    }

    /// Updates it with the position at a tick; returns whether it reads closed. Before tick 0 all stood as it does
    /// then.
    pub fn observe(&mut self, tick: u64, place: S) -> bool {
        let threshold = if self.closed { self.closes - self.hysteresis } else { self.closes };
        let closed = place >= threshold;
        if closed != self.closed {
            (self.closed, self.changed) = (closed, (tick > 0).then_some(tick));
        }
        let chatters = self.changed.is_some_and(|at| tick.saturating_sub(at) < u64::from(self.chatter));
        if chatters { self.source.bits(tick) & 1 == 1 } else { self.closed }
    }
}

/// A pressure sensor's membrane: first order, from one call to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Membrane<S> {
    /// Time constant in ticks, >= 0.
    pub lag: S,
    /// Tick of the last update, the pressure then, and what was felt of it.
    pub follows: Option<(u64, [S; 2])>,
}

impl<S: Scalar> Membrane<S> {
    /// A membrane that starts at the first pressure it sees.
    #[must_use]
    pub fn new(lag: S) -> Membrane<S> {
        Membrane { lag, follows: None }
    }

    /// Updates it with the pressure (Pa) at a tick; returns the pressure felt: f' = (p - f)/lag, exact where p is linear
    /// between two ticks. It then runs r lag behind, r the rate of p, and forgets how far it was off:
    /// ```text
    /// f = p - r lag + (f0 - p0 + r lag) exp(-passed/lag)
    /// ```
    pub fn observe(&mut self, tick: u64, pressure: S) -> S {
        let felt = match self.follows {
            Some((before, [old, felt])) if self.lag > S::ZERO && tick > before => {
                let passed = super::noise::whole::<S>(tick.saturating_sub(before));
                let behind = (pressure - old) / passed * self.lag;
                pressure - behind + (felt - old + behind) * (-(passed / self.lag)).exp()
            }
            Some((_, [_, felt])) if self.lag > S::ZERO => felt,
            _ => pressure,
        };
        self.follows = Some((tick, [pressure, felt]));
        felt
    }
}
