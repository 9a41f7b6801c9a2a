//! The bed in motion: bladders with inertia under a body that falls, settles and comes to rest.
//!
//! In: the bed of an [`equilibrium`](crate::equilibrium), a body, a method and a step. Out: the state after each step with
//! contact forces, and a [`Ledger`] of all energy. The end of a step is the state of least energy of springs, air, weight,
//! tissue and friction, as in equilibrium, and of a kinetic term about where inertia takes every point: Newton's method with
//! M b^2 and D b added (`equilibrium/increment.rs`). So both clocks share one scene, and a step that does not end is
//! an equilibrium.

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
