//! Parts of the tile's controller: the loop that joins them is not written yet.
//!
//! In: readings of a [`board`]. Out: what it sets. [`design`] holds lengths and limits; [`store`] and [`guarded`] keep
//! what must not be lost or flipped; [`fault`] says what is wrong and what is done about it; [`profile`] and
//! [`motion`] say where the legs are to be, [`drive`] what that takes; [`bladder`] keeps the pressure.

pub mod bladder;
pub mod board;
pub mod design;
pub mod drive;
pub mod fault;
pub mod guarded;
pub mod motion;
pub mod profile;
pub mod store;
