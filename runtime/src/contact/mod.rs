//! Contact of a body's points with a plane ground of any orientation (thesis chapter 4).
//!
//! gap = n.x - offset, > 0 apart; gap rate = n.v, < 0 closing; n is the outward normal of the ground.
//! A point is free, departing (just released: its guard is not armed until the gap is clearly open), held
//! (gap rate 0, the ground pushes) or stuck (held, and friction keeps it from sliding). In a soft ground it is
//! free or stuck, where stuck means that only friction holds it.

pub mod compensation;
pub mod force;
pub mod friction;
pub mod frozen;
pub mod ground;
pub mod massless;
pub mod pair;
pub mod repertoire;
pub mod restitution;
pub mod soft;
pub mod stable_step;
pub mod system;

pub use force::ForceLaw;
pub use frozen::{Frozen, Start, advance};
pub use ground::{ContactLaw, ContactState, Ground};
pub use repertoire::{Full, Repertoire};
pub use system::System;
