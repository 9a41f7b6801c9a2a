//! Worlds: mechanisms, flexible and rigid bodies in one scene (format 2).
//!
//! In: a scene text. Out: an [`Assembly`], plain data in SI units; then rows, energies and events of its motion. `read`
//! parses the text; `run` steps the assembly by an `engine`: `rigid` for worlds of rigid bodies, `carried` for flexible
//! parts on mechanisms (`ported`, once `derived`) and other `carriers`; `touching` handles contacts, `settle` finds the
//! equilibrium (`relaxing` is its step, `stability` disturbs it). `sensors` observe, `controllers` drive inputs, both
//! through `feedback`; `picture` is what pages show, `pushed` the forces between parts in rows; `books` observe what
//! works on what, `accounts` of parts and seams follow from them; `places` give errors of building their place in the text.

pub mod accounts;
pub mod assembly;
mod books;
pub mod carried;
pub mod carriers;
pub mod controllers;
pub mod derived;
pub mod engine;
pub mod feedback;
pub mod observing;
mod passing;
pub mod picture;
pub mod places;
pub mod ported;
mod pushed;
pub mod read;
mod relaxing;
pub mod rigid;
mod rounding;
pub mod run;
pub mod sensors;
mod settle;
mod stability;
mod touching;

pub use assembly::Assembly;
