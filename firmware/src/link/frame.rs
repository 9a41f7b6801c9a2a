//! Frames on the wire: 0, then body and checksum stuffed, then 0.
//!
//! In: a body, or bytes as they arrive. Out: bytes, or bodies whose checksum is right.
//! A frame begins and ends with 0, so whatever came before it (noise, half a frame, a wrong length) ends
//! where it begins: no good frame is lost after a corrupt one.

use super::checksum::{CHECKSUM, checked, checksum};
use super::cobs::{self, Unstuffed, Unstuffer};
use heapless::Vec;

/// Most bytes of a body.
pub const MAX_BODY: usize = 96;
/// Most bytes of body and checksum.
pub const MAX_CHECKED: usize = MAX_BODY + CHECKSUM;
/// Most bytes of a frame: two zeros, and one code for each 254 bytes begun and one at the end.
pub const MAX_FRAME: usize = MAX_CHECKED + 4;

/// A body.
pub type Body = Vec<u8, MAX_BODY>;
/// A frame.
pub type Frame = Vec<u8, MAX_FRAME>;

/// The frame of a body.
#[must_use]
pub fn encode(body: &Body) -> Frame {
    let mut frame = Frame::new();
    // None of this can fail: the lengths above bound one another.
    let _ = frame.push(0);
    cobs::encode(body.iter().copied().chain(checksum(body)), &mut frame);
    let _ = frame.push(0);
    frame
}

/// Counts of defective frames.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Losses {
    /// Ended inside a block.
    pub cut: u32,
    /// Longer than any frame of ours.
    pub long: u32,
    /// Wrong checksum, or too short to hold one.
    pub corrupt: u32,
}

/// Finds frames in a stream of bytes.
#[derive(Clone, Debug, Default)]
pub struct Decoder {
    unstuffer: Unstuffer,
    bytes: Vec<u8, MAX_CHECKED>,
    is_long: bool,
    /// Whether any byte has come since the last zero.
    is_begun: bool,
    losses: Losses,
}

impl Decoder {
    /// Takes one byte; returns a body if it completes a good frame.
    pub fn take(&mut self, byte: u8) -> Option<Body> {
        if byte == 0 {
            return self.end();
        }
        self.is_begun = true;
        if let Unstuffed::Byte(byte) = self.unstuffer.take(byte) {
            self.is_long |= self.bytes.push(byte).is_err();
        }
        None
    }

    /// Frames lost so far.
    #[must_use]
    pub fn losses(&self) -> Losses {
        self.losses
    }

    fn end(&mut self) -> Option<Body> {
        let mut body = None;
        if self.is_begun {
            body = checked(&self.bytes).and_then(|body| Body::from_slice(body).ok());
            let lost = match (self.is_long, self.unstuffer.is_whole(), &body) {
                (true, ..) => Some(&mut self.losses.long),
                (_, false, _) => Some(&mut self.losses.cut),
                (.., None) => Some(&mut self.losses.corrupt),
                (false, true, Some(_)) => None,
            };
            if let Some(count) = lost {
                *count = count.saturating_add(1);
                body = None;
            }
        }
        self.unstuffer = Unstuffer::default();
        self.bytes.clear();
        self.is_long = false;
        self.is_begun = false;
        body
    }
}

#[cfg(test)]
mod tests {
    use super::{Body, Decoder, Losses, MAX_BODY, MAX_FRAME, encode};
    use proptest::collection::vec;
    use proptest::prelude::{Just, any, prop_oneof, proptest};

    #[test]
    fn the_longest_body_fits() {
        for byte in [0, 1, 255] {
            let body = Body::from_slice(&[byte; MAX_BODY]).expect("it fits");
            let frame = encode(&body);
            assert!(frame.len() <= MAX_FRAME && frame.ends_with(&[0]) && frame[0] == 0);
            assert!(frame[1..frame.len() - 1].iter().all(|b| *b != 0));
            let mut decoder = Decoder::default();
            let bodies: std::vec::Vec<Body> = frame.iter().filter_map(|b| decoder.take(*b)).collect();
            assert_eq!(bodies, [body]);
            assert_eq!(decoder.losses(), Losses::default());
        }
    }

    proptest! {
        #[test]
        fn no_good_frame_is_lost_after_noise(
            noise in vec(prop_oneof![Just(0_u8), any::<u8>()], 0..300),
            body in vec(any::<u8>(), 1..MAX_BODY),
        ) {
            let body = Body::from_slice(&body).expect("it fits");
            let mut decoder = Decoder::default();
            for byte in noise {
                decoder.take(byte);
            }
            let frame = encode(&body);
            let found: std::vec::Vec<Body> = frame.iter().filter_map(|b| decoder.take(*b)).collect();
            assert_eq!(found, [body]);
        }

        #[test]
        fn a_changed_byte_is_seen(body in vec(any::<u8>(), 1..MAX_BODY), place in any::<usize>(), change in 1..=255_u8) {
            let body = Body::from_slice(&body).expect("it fits");
            let mut frame = encode(&body);
            let place = 1 + place % (frame.len() - 2);
            frame[place] ^= change;
            let mut decoder = Decoder::default();
            assert!(frame.iter().all(|b| decoder.take(*b).is_none()));
            assert_ne!(decoder.losses(), Losses::default());
        }
    }
}
