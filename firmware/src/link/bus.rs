//! How bodies come and go, a tick at a time: what a serial line and a CAN bus have in common.

use super::frame::Body;

/// What has come.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Arrival {
    /// A body whose checksum is right.
    Body(Body),
    /// A stop that needs no body.
    Stop,
}

/// A line or bus that never waits.
pub trait Bus {
    /// Hands over what has come until now (ms).
    fn receive(&mut self, now: u32, take: impl FnMut(Arrival));
    /// Sends what goes now (ms) of what `collect` brings.
    fn transmit(&mut self, now: u32, collect: impl FnMut() -> Option<Body>);
    /// Messages lost so far.
    fn lost(&self) -> u32;
}
