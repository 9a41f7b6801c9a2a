//! Scenes of flexible bodies: text -> lists -> a simulation -> rows of numbers.

pub mod describe;
pub mod dop853;
pub mod fields;
pub mod grid;
pub mod keys;
pub mod lists;
pub mod many;
mod march;
mod marcher;
pub mod method;
pub mod patches;
pub mod read;
pub mod rest;
pub mod run;
pub mod shape;
pub mod simulation;
pub mod surface;

pub mod graph;
pub mod pictures;
pub mod tables;
pub mod walk;

pub use lists::Lists;
pub use read::{Scene, open, parse};
pub use simulation::{Simulation, Surroundings};
