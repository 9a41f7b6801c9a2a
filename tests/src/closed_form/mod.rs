//! Closed forms that need no generator: assembled configurations and energies.

pub mod fourbar;
pub mod pendulum;
pub mod tile;
