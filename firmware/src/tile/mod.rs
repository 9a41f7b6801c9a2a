//! The tile's controller, independent of link and chip.
//!
//! In: readings of a [`board`], commands. Out: outputs for the board. [`design`] holds lengths and limits; [`store`],
//! [`guarded`] and [`integrity`] protect data and program against loss and bit flips; [`sense`] estimates the state of
//! the legs; [`plausible`] and [`effort`] detect faults, [`fault`] lists them with their responses; [`profile`],
//! [`motion`] and [`home`] give the wanted motion of the legs, `dynamics` and [`drive`] the forces and duties for it,
//! `servo` controls them; [`bladder`] controls the pressure; [`mode`] says which commands are allowed when, and
//! `controller` joins all this into one tick.

pub mod bladder;
pub mod board;
#[cfg(all(feature = "controller", not(feature = "scene")))]
pub mod controller;
pub mod design;
pub mod drive;
#[cfg(all(feature = "controller", not(feature = "scene")))]
pub mod dynamics;
pub mod effort;
pub mod fault;
pub mod guarded;
pub mod home;
pub mod integrity;
pub mod mode;
pub mod motion;
pub mod plausible;
pub mod profile;
pub mod sense;
#[cfg(all(feature = "controller", not(feature = "scene")))]
pub mod servo;
pub mod store;
