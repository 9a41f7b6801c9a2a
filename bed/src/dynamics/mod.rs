//! The bed in motion: bladders with inertia under a body that falls, settles and comes to rest.
//!
//! In: the bed of an [`equilibrium`](crate::equilibrium), a body, a method and a step. Out: the state after each step
//! with contact forces, and a [`Ledger`] of all energy. The end of a step minimises the energy of springs, air, weight,
//! tissue and friction, as in equilibrium, plus a kinetic term about the position to which inertia takes every point:
//! Newton's method with M b^2 and D b added (`equilibrium/increment.rs`). So statics and dynamics share one scene, and
//! an infinitely long step is an equilibrium.

mod books;
mod coming;
pub mod impact;
mod ledger;
mod motion;
mod start;

pub use crate::method::{Formula, Method, Track};
pub use ledger::Ledger;
pub use motion::{Impact, Matter, Motion};
pub use start::{dropped, lowered};
