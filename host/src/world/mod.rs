//! Worlds: mechanisms, flexible and rigid bodies in one scene (format 2).
//!
//! In: a scene text. Out: an [`Assembly`], plain data in SI units, then rows, energies and events of its motion.
//! `read` turns text into the assembly, `run` steps it by an `engine`: `rigid` moves worlds of rigid bodies, `carried`
//! flexible parts on mechanisms (`ported`) and other `carriers`, `touching` what of all that meets, `settle` finds
//! their equilibrium; `sensors` observe it, `controllers` drive its inputs, both as `feedback`; `picture` is what pages show, `pushed` the forces
//! between parts as rows show them.

pub mod assembly;
pub mod carried;
pub mod carriers;
pub mod controllers;
pub mod engine;
pub mod feedback;
pub mod picture;
pub mod ported;
mod pushed;
pub mod read;
pub mod rigid;
mod rounding;
pub mod run;
pub mod sensors;
mod settle;
mod touching;

pub use assembly::Assembly;
