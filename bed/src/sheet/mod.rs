//! A bladder's sheet: a grid of springs over a rectangle, its rim held, with air below.
//!
//! In: sizes, modulus and air. Out: energy, its gradient and its Hessian at places of the nodes. The frame is the
//! tile's: origin in the middle of the rim, z away from the base.

pub mod air;
mod lattice;
pub mod membrane;

pub use lattice::{Lattice, LatticeError, Spring};
