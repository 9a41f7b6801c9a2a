//! Protocol by which a host and the loop of controller and simulated tile take turns, byte by byte.
//!
//! The loop begins with [`HELLO`]; the host sends the tile's number; the loop answers with its self-locking margin in
//! thousandths, two bytes, lowest first. Then the host's turns: 0 to 127: this many bytes follow for the tile's line,
//! then one tick; 128 to 127 + [`MOST_TICKS`]: a tick for each above 127; [`BREAK`] and the number of a defect in
//! [`NAMED`](crate::defect::NAMED); [`FAULT`] and [`END`]. For each tick the loop answers with the number of bytes that
//! the tile sent, and these bytes.

/// The loop is ready.
pub const HELLO: u8 = 0x55;
/// A byte 127 + n requests n ticks.
pub const TICKS: u8 = 0x7F;
/// Most ticks of one turn.
pub const MOST_TICKS: u8 = 0x7D;
/// Sets the defect whose number follows; 0 repairs all.
pub const BREAK: u8 = 0xFD;
/// Executes an undefined instruction, to test the fault handler.
pub const FAULT: u8 = 0xFE;
/// Ends the session; the loop answers with the peak use of the stack in bytes, four bytes, lowest first.
pub const END: u8 = 0xFF;

/// The key of every simulated tile; a real one gets its own in production.
pub const KEY: [u8; 16] = *b"an example's key";
