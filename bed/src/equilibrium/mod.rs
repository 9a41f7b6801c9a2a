//! The quasi-static bed: equilibrium of air, sheets and bodies after each command, with frictional contact.
//!
//! In: a [`Bed`] with its tiles' poses and air, a [`Body`](crate::body::Body), a [`State`] to start from. Out: the
//! state that minimises the energy of springs, air, weight, joints and tissue, and of friction as an increment from the
//! state before. Newton's method with a line search (`newton`). Each tile's sheet is a band matrix that is eliminated,
//! which leaves the bodies (`tile`): tiles are solved in parallel, and the result does not depend on the number of
//! threads.

pub(crate) mod alone;
mod bed;
mod beside;
mod bridge;
pub(crate) mod increment;
mod link;
mod lone;
mod newton;
pub mod passed;
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
