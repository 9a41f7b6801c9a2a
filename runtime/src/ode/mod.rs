//! Ordinary differential equations q_dot = N(q) u, u_dot = f(t, q, u), and one step of them, refused or taken as a whole.
//!
//! An [`Ode`] writes both rates of x = [q, u]; the state is a compensated sum ([`state`]). Methods of any ode:
//! [`runge_kutta`], [`shared_work`] and [`splitting`] (fixed steps), [`dormand_prince`] (steps by the error, [`step_size`]). All coefficients stand in
//! [`tableau`]; an event within a step is found by [`root`]. [`Driven`] makes an ode of a mechanism and a law.
//!
//! One step: stages, trial state, a fixed number of projections onto the constraints, the check, and only
//! then the commit. Whatever is refused leaves the state as it was, bit for bit: a pivot below
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
