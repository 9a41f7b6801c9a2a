//! The link between a supervisor and a tile: see `docs/protocol.md`.
//!
//! In: bytes of a serial line, or frames of a CAN bus. Out: commands that may be done, and reports.
//! From the wire inwards: [`cobs`], [`checksum`] and [`frame`] find bodies, [`message`] says what they mean, [`tag`]
//! and [`session`] decide whose they are; [`clock`] compares clocks, [`log`] keeps what happened; [`serial`] carries
//! bodies over a line, [`can`], [`talk`] and [`isotp`] in frames of eight bytes, [`bxcan`] is a controller of such
//! frames; to the node both are a [`bus`]; [`hub`] is the supervisor's side of a CAN bus.

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

/// What comes again and again from or for this tile comes so much later than for the tile before it (ms): on one bus
/// beats and reports never come in a heap.
#[must_use]
pub fn stagger(tile: u8) -> u32 {
    7 * u32::from(tile)
}
