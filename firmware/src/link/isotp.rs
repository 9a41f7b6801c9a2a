//! Bodies split into frames of up to eight bytes and reassembled: ISO 15765-2 (ISO-TP), normal addressing.
//!
//! In: a body, or data of received frames. Out: data of frames, or bodies whose checksum is right. Up to 7 bytes fit in
//! a single frame. A longer body starts with a first frame, waits for the receiver's flow control, and continues with
//! consecutive frames numbered modulo 16, as many and as often as the receiver allows.

use super::checksum::{CHECKSUM, checked, checksum};
use super::frame::{Body, MAX_CHECKED};
use heapless::Vec;

/// Timeout of either side (ms): `N_Cr` and `N_Bs`, for which the standard allows a second; a tile
/// holds after half a second.
pub const PATIENCE: u32 = 100;

/// Data of a frame.
pub type Data = Vec<u8, 8>;

/// Flow control: continue to the end, one frame per millisecond. A controller polled once per millisecond has room for
/// three.
const GO_ON: [u8; 3] = [0x30, 0, 1];

/// Permission of the receiver to continue.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Grant {
    /// No permission yet.
    Waits,
    /// This many frames; None: to the end.
    Frames(Option<u8>),
}

/// Splits one body into frames.
#[derive(Clone, Debug)]
pub struct Sender {
    bytes: Vec<u8, MAX_CHECKED>,
    sent: usize,
    number: u8,
    grant: Grant,
    /// Least time between consecutive frames (ms).
    pause: u32,
    /// Time of the last progress.
    last: u32,
}

impl Sender {
    /// Starts sending this body now (ms).
    #[must_use]
    pub fn new(body: &Body, now: u32) -> Self {
        let mut bytes = Vec::new();
        // It fits: MAX_CHECKED is MAX_BODY and the checksum.
        let _ = bytes.extend_from_slice(body);
        let _ = bytes.extend_from_slice(&checksum(body));
        Self { bytes, sent: 0, number: 1, grant: Grant::Waits, pause: 0, last: now }
    }

    /// The next frame's data; None while the receiver has not answered or requires a pause, and at the end.
    pub fn send(&mut self, now: u32) -> Option<Data> {
        let length = self.bytes.len();
        let mut data = Data::new();
        if self.sent == 0 && length <= 7 {
            data.push(length as u8).ok()?;
        } else if self.sent == 0 {
            data.extend_from_slice(&[0x10 | (length >> 8) as u8, length as u8]).ok()?;
        } else if self.sent < length && now.wrapping_sub(self.last) >= self.pause {
            self.use_grant()?;
            data.push(0x20 | self.number).ok()?;
            self.number = (self.number + 1) & 15;
        } else {
            return None;
        }
        let rest = self.bytes.get(self.sent..).unwrap_or_default();
        let taken = rest.len().min(8 - data.len());
        data.extend_from_slice(rest.get(..taken).unwrap_or_default()).ok()?;
        self.sent += taken;
        self.last = now;
        Some(data)
    }

    fn use_grant(&mut self) -> Option<()> {
        self.grant = match self.grant {
            Grant::Waits => return None,
            Grant::Frames(None) => Grant::Frames(None),
            Grant::Frames(Some(0 | 1)) => Grant::Waits,
            Grant::Frames(Some(left)) => Grant::Frames(Some(left - 1)),
        };
        Some(())
    }

    /// Takes the receiver's flow control: "continue" with the number of frames in a block and the pause between them;
    /// "wait" waits; anything else aborts.
    pub fn flow(&mut self, data: &[u8]) {
        match *data {
            [0x30, block, pause, ..] => {
                self.grant = Grant::Frames((block > 0).then_some(block));
                self.pause = match pause {
                    0..=0x7F => pause.into(),
                    // Tenths of a millisecond.
                    0xF1..=0xF9 => 1,
                    _ => 0x7F,
                };
            }
            [0x31, ..] => self.grant = Grant::Waits,
            _ => self.sent = self.bytes.len(),
        }
    }

    /// Whether everything has been sent.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.sent >= self.bytes.len()
    }

    /// Whether the receiver has exceeded the timeout.
    #[must_use]
    pub fn is_late(&self, now: u32) -> bool {
        now.wrapping_sub(self.last) > PATIENCE
    }
}

/// Result of a received frame.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Step {
    /// Nothing yet.
    Nothing,
    /// Flow control to send back.
    Answer(Data),
    /// A body.
    Body(Body),
}

/// Reassembles the frames of one sender.
#[derive(Clone, Debug, Default)]
pub struct Receiver {
    bytes: Vec<u8, MAX_CHECKED>,
    /// Length announced by the first frame; 0 if no message is in progress.
    length: usize,
    number: u8,
    heard: u32,
    lost: u32,
}

impl Receiver {
    /// Takes a frame's data at this time (ms). An unexpected frame aborts the message in progress; a first or single
    /// frame always starts a new one.
    pub fn take(&mut self, data: &[u8], now: u32) -> Step {
        let Some((first, rest)) = data.split_first() else { return self.lose() };
        match first >> 4 {
            0 => {
                self.give_up();
                let length = usize::from(first & 15);
                match rest.get(..length).and_then(checked).and_then(|body| Body::from_slice(body).ok()) {
                    Some(body) => Step::Body(body),
                    None => self.lose(),
                }
            }
            1 => self.begin(usize::from(first & 15) << 8, rest, now),
            2 if self.length > 0 => self.go_on(first & 15, rest, now),
            _ => self.lose(),
        }
    }

    /// Messages lost so far.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.lost
    }

    fn begin(&mut self, high: usize, rest: &[u8], now: u32) -> Step {
        self.give_up();
        let Some((low, bytes)) = rest.split_first() else { return self.lose() };
        let length = high | usize::from(*low);
        if !(8..=MAX_CHECKED).contains(&length) || bytes.len() != 6 {
            return self.lose();
        }
        self.length = length;
        self.number = 1;
        self.heard = now;
        // Six bytes fit into an empty buffer of MAX_CHECKED.
        let _ = self.bytes.extend_from_slice(bytes);
        Step::Answer(Data::from_slice(&GO_ON).unwrap_or_default())
    }

    fn go_on(&mut self, number: u8, rest: &[u8], now: u32) -> Step {
        let missing = self.length.saturating_sub(self.bytes.len());
        let Some(bytes) = rest.get(..missing.min(7)) else { return self.lose() };
        let is_late = now.wrapping_sub(self.heard) > PATIENCE;
        if number != self.number || is_late || self.bytes.extend_from_slice(bytes).is_err() {
            return self.lose();
        }
        self.number = (number + 1) & 15;
        self.heard = now;
        if self.bytes.len() < self.length {
            return Step::Nothing;
        }
        let body = checked(&self.bytes).and_then(|body| Body::from_slice(body).ok());
        self.length = 0;
        self.bytes.clear();
        body.map_or_else(|| self.lose(), Step::Body)
    }

    /// Aborts the message in progress, and counts it as lost.
    pub fn give_up(&mut self) {
        if self.length > 0 {
            self.lose();
        }
    }

    fn lose(&mut self) -> Step {
        self.lost = self.lost.saturating_add(1);
        self.length = 0;
        self.bytes.clear();
        Step::Nothing
    }
}

const _: () = assert!(MAX_CHECKED < 4096 && CHECKSUM < 8, "ISO-TP's first frame has twelve bits of length");

#[cfg(test)]
mod tests {
    use super::{Data, PATIENCE, Receiver, Sender, Step};
    use crate::link::frame::{Body, MAX_BODY};
    use proptest::collection::vec;
    use proptest::prelude::{any, proptest};

    /// All data of a body, the receiver answering at once.
    fn transfer(body: &Body, receiver: &mut Receiver, now: u32) -> (std::vec::Vec<Data>, Option<Body>) {
        let (mut sender, mut sent, mut got) = (Sender::new(body, now), std::vec::Vec::new(), None);
        for tick in now..now + 40 {
            let Some(data) = sender.send(tick) else { break };
            match receiver.take(&data, now) {
                Step::Answer(flow) => sender.flow(&flow),
                Step::Body(body) => got = Some(body),
                Step::Nothing => (),
            }
            sent.push(data);
        }
        assert!(sender.is_done());
        (sent, got)
    }

    #[test]
    fn frames_are_those_of_the_standard() {
        let body = Body::from_slice(&[1; 10]).expect("it fits");
        let (sent, got) = transfer(&body, &mut Receiver::default(), 0);
        assert_eq!(got, Some(body));
        // 14 bytes: first frame 0x1 00E with six, consecutive frame 0x21 with seven, 0x22 with the last one.
        assert_eq!(sent[0][..], [0x10, 14, 1, 1, 1, 1, 1, 1]);
        assert_eq!(sent[1][..5], [0x21, 1, 1, 1, 1]);
        assert_eq!((sent[2][0], sent[2].len()), (0x22, 2));
        let short = Body::from_slice(&[9, 8, 7]).expect("it fits");
        let (sent, got) = transfer(&short, &mut Receiver::default(), 0);
        assert_eq!((sent[0][..4].to_vec(), got), (std::vec![7, 9, 8, 7], Some(short)));
    }

    #[test]
    fn nothing_follows_the_first_frame_before_the_receiver_agrees() {
        let mut sender = Sender::new(&Body::from_slice(&[1; 10]).expect("it fits"), 0);
        assert!(sender.send(0).is_some() && sender.send(0).is_none() && !sender.is_done());
        sender.flow(&[0x31, 0, 0]);
        assert!(sender.send(1).is_none() && !sender.is_late(PATIENCE) && sender.is_late(PATIENCE + 1));
        sender.flow(&[0x32, 0, 0]);
        assert!(sender.send(2).is_none() && sender.is_done());
    }

    #[test]
    fn blocks_and_pauses_are_the_receivers() {
        let mut sender = Sender::new(&Body::from_slice(&[1; 60]).expect("it fits"), 0);
        assert!(sender.send(0).is_some());
        let mut sent_until = |flow: [u8; 3], ticks: std::ops::Range<u32>| {
            sender.flow(&flow);
            ticks.filter(|tick| sender.send(*tick).is_some()).collect::<std::vec::Vec<_>>()
        };
        assert_eq!(sent_until([0x30, 2, 5], 1..30), [5, 10], "two frames, 5 ms apart");
        assert_eq!(sent_until([0x30, 2, 0xF3], 30..40), [30, 31], "tenths of a millisecond are one");
        assert_eq!(sent_until([0x30, 0, 0], 40..50), [40, 41, 42, 43, 44], "to the end");
    }

    #[test]
    fn a_pause_too_long_or_a_frame_lost_ends_a_message() {
        let body = Body::from_slice(&[1; 30]).expect("it fits");
        let (sent, _) = transfer(&body, &mut Receiver::default(), 0);
        for (skipped, pause) in [(Some(2), 0), (None, PATIENCE + 1)] {
            let mut receiver = Receiver::default();
            for (i, data) in sent.iter().enumerate().filter(|(i, _)| Some(*i) != skipped) {
                let now = if i > 1 { pause } else { 0 };
                assert!(!matches!(receiver.take(data, now), Step::Body(_)));
            }
            assert!(receiver.lost() > 0);
        }
    }

    proptest! {
        #[test]
        fn no_message_is_lost_after_noise(
            noise in vec(vec(any::<u8>(), 0..9), 0..50),
            body in vec(any::<u8>(), 1..MAX_BODY),
        ) {
            let mut receiver = Receiver::default();
            for data in noise {
                receiver.take(&data, 0);
            }
            let body = Body::from_slice(&body).expect("it fits");
            assert_eq!(transfer(&body, &mut receiver, 0).1, Some(body));
        }
    }
}
