//! How a host and the loop of controller and simulated tile take turns, byte by byte.
//!
//! The loop begins with [`HELLO`]; the host sends the tile's number; the loop answers with its margin of self-locking in thousandths, two
//! bytes, lowest first. Then the host's turns: 0 to 127, so many bytes, which come to the tile's line, and a tick; 128 to
//! [`MOST_TICKS`] more: a tick for each above 127; [`BREAK`] and the number of a defect in [`NAMED`](crate::defect::NAMED); [`FAULT`] and [`END`]. For each tick the loop answers
//! how many bytes the tile sent, and these.

/// The loop is there.
pub const HELLO: u8 = 0x55;
/// A byte of 127 + n asks for n ticks.
pub const TICKS: u8 = 0x7F;
/// Most ticks of a turn.
pub const MOST_TICKS: u8 = 0x7D;
/// The defect of the number that follows strikes; 0 mends all.
pub const BREAK: u8 = 0xFD;
/// Executes an undefined instruction: for the test of the handler.
pub const FAULT: u8 = 0xFE;
/// Ends; the loop answers with the most bytes of stack that were used, four bytes, lowest first.
pub const END: u8 = 0xFF;

/// The key of every simulated tile; a real one gets its own from its maker.
pub const KEY: [u8; 16] = *b"an example's key";
