//! A node on a serial line: bytes to bodies and back, so many each tick and no more.
//!
//! In: bytes of a [`Line`]. Out: bodies for the node, and the frames of what it reports.

use super::frame::{Body, Decoder, Frame, Losses, encode};

/// Most bytes read, and written, in a tick: 115,200 baud bring 11.5.
pub const BYTES: usize = 16;

/// A serial line that never waits.
pub trait Line {
    /// A byte that has come.
    fn read(&mut self) -> Option<u8>;
    /// Sends a byte; false if there is no room, and then it is not sent.
    fn write(&mut self, byte: u8) -> bool;
}

/// What is under way on a line.
#[derive(Clone, Debug, Default)]
pub struct Serial {
    decoder: Decoder,
    frame: Frame,
    sent: usize,
}

impl Serial {
    /// Reads what has come in this tick and hands over every good body.
    pub fn receive(&mut self, line: &mut impl Line, mut deliver: impl FnMut(Body)) {
        for _ in 0..BYTES {
            let Some(byte) = line.read() else { return };
            if let Some(body) = self.decoder.take(byte) {
                deliver(body);
            }
        }
    }

    /// Sends as much as the line takes.
    pub fn transmit(&mut self, line: &mut impl Line, mut collect: impl FnMut() -> Option<Body>) {
        for _ in 0..BYTES {
            let byte = match self.frame.get(self.sent) {
                Some(byte) => *byte,
                None => {
                    let Some(body) = collect() else { return };
                    (self.frame, self.sent) = (encode(&body), 0);
                    0
                }
            };
            if !line.write(byte) {
                return;
            }
            self.sent += 1;
        }
    }

    /// Frames lost so far.
    #[must_use]
    pub fn losses(&self) -> Losses {
        self.decoder.losses()
    }
}
