//! The oracle that shares nothing with the generator: Newton-Euler per body, joints solved numerically.
//!
//! In: parameters, coordinates and independent speeds in a reference's order. Out:
//! [`system::Motion`]. Each mechanism is written here from its description, in maximal
//! coordinates, not from its model text.

pub mod arm6;
pub mod bicycle;
pub mod body;
pub mod fourbar;
pub mod jet;
pub mod joint;
pub mod pendulum;
pub mod system;
pub mod tile;
