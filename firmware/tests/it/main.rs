//! The controller as a whole, on the simulated tile.

mod bench;
mod campaign;
mod can;
mod fuzz;
mod link;
mod motion;
mod safety;
mod unpowered;
mod wire;
