//! The controller as a whole, on the simulated tile.

mod bench;
mod bxcan;
mod campaign;
mod can;
mod can_bus;
mod feedforward;
mod fuzz;
mod link;
mod motion;
mod obstacle;
mod orders;
mod reset;
mod safety;
mod unpowered;
mod wire;
