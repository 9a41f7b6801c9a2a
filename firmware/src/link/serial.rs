//! A node on a serial line: bytes to bodies and back, with a bounded number of bytes per tick.
//!
//! In: bytes of a [`Line`]. Out: bodies for the node, and frames of its reports.

use super::bus::{Arrival, Bus};
use super::frame::{Body, Decoder, Frame, encode};

/// Most bytes read, and written, in a tick: 115,200 baud bring 11.5.
pub const BYTES: usize = 16;

/// A serial line that never blocks.
pub trait Line {
    /// The next received byte.
    fn read(&mut self) -> Option<u8>;
    /// Sends a byte; returns false, without sending, if there is no room.
    fn write(&mut self, byte: u8) -> bool;
    /// Called after the bytes of a tick, for lines that send them together.
    fn flush(&mut self) {}
}

/// A line with its messages in progress.
#[derive(Clone, Debug, Default)]
pub struct Serial<L> {
    decoder: Decoder,
    frame: Frame,
    sent: usize,
    /// The line.
    pub line: L,
}

impl<L: Line> Serial<L> {
    /// A line without messages in progress.
    pub fn new(line: L) -> Self {
        Self { decoder: Decoder::default(), frame: Frame::default(), sent: 0, line }
    }

    fn fill(&mut self, mut collect: impl FnMut() -> Option<Body>) {
        for _ in 0..BYTES {
            let byte = match self.frame.get(self.sent) {
                Some(byte) => *byte,
                None => {
                    let Some(body) = collect() else { return };
                    (self.frame, self.sent) = (encode(&body), 0);
                    0
                }
            };
            if !self.line.write(byte) {
                return;
            }
            self.sent += 1;
        }
    }
}

impl<L: Line> Bus for Serial<L> {
    fn receive(&mut self, _now: u32, mut take: impl FnMut(Arrival)) {
        for _ in 0..BYTES {
            let Some(byte) = self.line.read() else { return };
            if let Some(body) = self.decoder.take(byte) {
                take(Arrival::Body(body));
            }
        }
    }

    fn transmit(&mut self, _now: u32, collect: impl FnMut() -> Option<Body>) {
        self.fill(collect);
        self.line.flush();
    }

    fn lost(&self) -> u32 {
        let losses = self.decoder.losses();
        losses.cut.saturating_add(losses.long).saturating_add(losses.corrupt)
    }
}
