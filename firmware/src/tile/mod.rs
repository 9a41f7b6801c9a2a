//! The tile's controller, apart from the link and from the chip.
//!
//! In: readings of a [`board`]. Out: what it sets. [`design`] holds lengths and limits; [`store`] and [`guarded`] keep
//! what must not be lost or flipped; [`sense`] says where the legs are, [`fault`] and [`plausible`] what is wrong and
//! what is done about it; [`profile`], [`motion`] and [`home`] say where the legs are to be, [`drive`] what that takes,
//! [`servo`] how they get there; [`bladder`] keeps the pressure; [`mode`] says what is allowed when, and
//! [`controller`] joins all this into one tick.

pub mod bladder;
pub mod board;
pub mod controller;
pub mod design;
pub mod drive;
pub mod fault;
pub mod guarded;
pub mod home;
pub mod mode;
pub mod motion;
pub mod plausible;
pub mod profile;
pub mod sense;
pub mod servo;
pub mod store;
