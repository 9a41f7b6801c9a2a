//! Rigid bodies that fall, strike, rest, slide and roll: the whole step.
//!
//! In: parts (shape, body or fixed), pairs that may touch with their laws, gravity, states. Out: the states a step
//! later.
//! ```text
//! detect      features of every pair that touch
//! strike      if some close: impact of all that touch, by the pairs' laws
//! advance     forces of the contacts that last at the start and in the middle of the way: order 2; impulses over the way
//!             where forces are not found or do not exist: order 1
//! shorten     to the first new touch, to where a slip stops or a contact that presses passes to another face, edge or end
//! project     gaps and rates of the contacts that press back to 0
//! ```
//! A step is split at most [`SPLITS`] times; the rest is then stepped in 16 pieces by impulses with e = 0, and the
//! report says so. There are no stiffnesses and no tolerances to choose: lengths and speeds that count as zero follow
//! from the bodies and from gravity.

mod advance;
mod detect;
mod impulses;
mod memory;
mod parts;
mod step;
mod touching;

pub use memory::{Memory, Piece, Report, Strike};
pub(crate) use parts::NEAR;
pub use parts::{Fault, Pair, Part, RigidScene};
pub use step::SPLITS;
pub(crate) use step::{HIGHEST, OVERLAP, PIECES};
pub(crate) use touching::TURN;
pub use touching::Touching;
