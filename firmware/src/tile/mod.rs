//! The tile's controller, apart from the link and from the chip.
//!
//! In: readings of a [`board`]. Out: what it sets. [`design`] holds lengths and limits; [`store`], [`guarded`] and
//! [`integrity`] keep what must not be lost or flipped; [`sense`] says where the legs are, [`fault`], [`plausible`] and
//! [`effort`] what is wrong and what is done about it; [`profile`], [`motion`] and [`home`] say where the legs are to
//! be, `dynamics` and [`drive`] what that takes, `servo` how they get there; [`bladder`] keeps the pressure; [`mode`]
//! says what is allowed when, and `controller` joins all this into one tick.

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
