//! Integrators of q_dot = N(q) u, u_dot = f(t, q, u): one step, refused or taken as a whole.
//!
//! An [`Ode`] writes the rates of x = [q, u]; the [`state`] is kept as compensated sums. Methods for any ode:
//! [`runge_kutta`], [`shared_work`] and [`splitting`] (fixed steps), [`dormand_prince`] (steps controlled by the error,
//! [`step_size`]). All coefficients stand in [`tableau`]; [`root`] locates an event within a step. [`Driven`] makes an
//! ode of a mechanism and a control law; flexible bodies have methods of their own in a folder beside.
//!
//! One step: stages, trial state, a fixed number of projections onto the constraints, the check, and only
//! then the commit. A refused step leaves the state as it was, bit for bit. Reasons to refuse: a pivot below
//! [`pivot_limit`], a value that is not finite, slices of wrong length, a fault of the system.
//! Memory is the caller's: `scratch` holds as many numbers as the method's `scratch` function says.

pub mod dormand_prince;
pub mod driven;
pub mod method;
pub mod nodes;
pub mod root;
pub mod runge_kutta;
pub mod shared_work;
pub mod splitting;
pub mod state;
pub mod step_size;
pub mod system;
pub mod tableau;
pub mod trial;

pub use dormand_prince::DormandPrince;
pub use driven::Driven;
pub use method::Method;
pub use runge_kutta::{explicit_euler, rk4, semi_implicit_euler};
pub use shared_work::{SharedWork, rk4_shared};
pub use splitting::{blanes_moan4, implicit_midpoint, verlet};
pub use state::State;
pub use system::Ode;
pub use trial::{Report, pivot_limit};
