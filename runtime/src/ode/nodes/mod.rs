//! Newton's equations of nodes, q_dot = u, M u_dot = f(q) + g(q, u) with a diagonal M, and one step of them.
//!
//! In: a [`Motion`], the equations ([`Newton`]), a method ([`method`]), the step. Out: the motion at the end, in the
//! [`Workspace`]; the start is unchanged, so a step can be tried, shortened and tried again. Positions and speeds are
//! compensated sums: without their rounding errors an f32 node at 10 m would not move at 1 mm/s.

mod anderson;
mod damped;
pub mod method;
mod midpoint;
pub mod motion;
pub mod newton;
mod nystrom;
mod rows;
mod verlet;
pub mod workspace;

pub use method::{Method, Step};
pub(crate) use motion::copy;
pub use motion::{MOTION_ROWS, Motion};
pub use newton::{MeanStep, Newton, NodeFault};
pub(crate) use rows::add_compensated;
pub use workspace::{Workspace, workspace_len};
