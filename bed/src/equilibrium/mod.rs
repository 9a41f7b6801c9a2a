//! The quasi-static bed: where air, sheets and bodies rest after each command, contact with friction kept.
//!
//! In: a [`Bed`] with its tiles' poses and air, a [`Body`](crate::body::Body), a [`State`] to start from. Out: the state of least energy:
//! springs, air, weight, joints, tissue pressed by sheets, and what friction takes up since the state before. Newton's
//! method with a search along each step (`newton`); each tile's sheet is a band, bodies are what is left when all sheets
//! are eliminated (`tile`), so that tiles are solved side by side and the result does not depend on how many at a time.

pub(crate) mod alone;
mod bed;
mod beside;
mod bridge;
pub(crate) mod increment;
mod link;
mod lone;
mod newton;
mod rub;
pub(crate) mod scene;
pub mod side_by_side;
mod solution;
mod state;
mod step;
mod stiffness;
pub(crate) mod swing;
pub(crate) mod tile;
mod touch;

pub use bed::{Bed, Cover, GRAVITY, Tile};
pub use beside::Meeting;
pub(crate) use newton::find;
pub use newton::{Fault, lay_on, put_down, solve, stiffness};
pub use rub::Rub;
pub(crate) use solution::read;
pub use solution::{Contact, Solution};
pub use state::State;
pub use touch::{Anchor, Touch};
