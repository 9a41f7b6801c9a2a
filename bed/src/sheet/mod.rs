//! A bladder's sheet: a grid of springs over a rectangle, fixed at its rim, with air below.
//!
//! In: sizes, modulus and air. Out: energy, gradient and Hessian at given positions of the nodes. The frame is the
//! tile's: origin at the centre of the rim, z pointing away from the base.

pub mod air;
mod lattice;
pub mod membrane;

pub use lattice::{Lattice, LatticeError, Spring};
