//! The common interface of a serial line and a CAN bus: bodies in and out, once per tick.

use super::frame::Body;

/// A message that has arrived.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Arrival {
    /// A body whose checksum is right.
    Body(Body),
    /// A stop without a body.
    Stop,
}

/// A line or bus that never blocks.
pub trait Bus {
    /// Hands over everything that has arrived by now (ms).
    fn receive(&mut self, now: u32, take: impl FnMut(Arrival));
    /// Sends as much of what `collect` returns as is possible now (ms).
    fn transmit(&mut self, now: u32, collect: impl FnMut() -> Option<Body>);
    /// Messages lost so far.
    fn lost(&self) -> u32;
}
