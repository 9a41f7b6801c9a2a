//! The link between a supervisor and a tile: see `docs/protocol.md`.
//!
//! In: bytes of a serial line, or frames of a CAN bus. Out: commands that may be executed, and reports.
//! From the wire inwards: [`cobs`], [`checksum`] and [`frame`] extract bodies, [`message`] decodes them, [`tag`]
//! and [`session`] authenticate them; [`clock`] compares clocks, [`log`] records events; [`serial`] carries
//! bodies over a line, [`can`], [`talk`] and [`isotp`] in frames of eight bytes, [`bxcan`] drives a CAN controller;
//! the node sees either as a [`bus`]; [`hub`] is the supervisor's side of a CAN bus.

pub mod bus;
pub mod bxcan;
pub mod can;
pub mod checksum;
pub mod clock;
pub mod cobs;
pub mod frame;
pub mod hub;
pub mod isotp;
pub mod log;
pub mod message;
pub mod serial;
pub mod session;
pub mod tag;
pub mod talk;

/// How much earlier than those of tile 0 periodic messages of or for this tile are sent (ms), more for each next tile,
/// so that they never pile up on one bus.
#[must_use]
pub fn stagger(tile: u8) -> u32 {
    7 * u32::from(tile)
}
