//! The same messages on a CAN bus: bodies with checksum by ISO 15765-2 (ISO-TP), normal addressing.
//!
//! In: a body, or frames as they come. Out: frames of up to eight bytes, or bodies whose checksum is right.
//! Up to 7 bytes go in one frame; more begin with a first frame, wait for the receiver's flow control, and go on
//! in consecutive frames numbered modulo 16. Identifiers: commands 0x100 + tile, reports 0x200 + tile, and a
//! frame of its own that stops: 0x010 without data for every tile, or with tile numbers.

use super::frame::{Body, CHECKSUM, MAX_CHECKED, checked, checksum};
use embedded_can::{Frame, Id, StandardId};
use heapless::Vec;

/// Identifier of the frame that stops; lower than all others, so it goes first.
pub const STOP: u16 = 0x010;
/// Identifier of commands to tile 0.
pub const COMMANDS: u16 = 0x100;
/// Identifier of reports of tile 0.
pub const REPORTS: u16 = 0x200;
/// A receiver gives up after this time without the next frame (ms; `N_Cr` of the standard).
pub const PATIENCE: u32 = 1000;

/// Data of a frame.
pub type Data = Vec<u8, 8>;

/// Flow control: go on, without a pause and to the end.
const GO_ON: [u8; 3] = [0x30, 0, 0];

/// The frame of this identifier and data.
#[must_use]
pub fn frame<F: Frame>(id: u16, data: &[u8]) -> Option<F> {
    F::new(StandardId::new(id)?, data)
}

/// Does this frame stop the tile?
#[must_use]
pub fn stops(frame: &impl Frame, tile: u8) -> bool {
    let is_stop = matches!(frame.id(), Id::Standard(id) if id.as_raw() == STOP);
    is_stop && (frame.data().is_empty() || frame.data().contains(&tile))
}

/// Cuts one body into frames.
#[derive(Clone, Debug)]
pub struct Sender {
    bytes: Vec<u8, MAX_CHECKED>,
    sent: usize,
    number: u8,
    /// May consecutive frames go?
    may_go: bool,
}

impl Sender {
    /// Sends this body.
    #[must_use]
    pub fn new(body: &Body) -> Self {
        let mut bytes = Vec::new();
        // It fits: MAX_CHECKED is MAX_BODY and the checksum.
        let _ = bytes.extend_from_slice(body);
        let _ = bytes.extend_from_slice(&checksum(body));
        Self { bytes, sent: 0, number: 1, may_go: false }
    }

    /// The next frame's data; none while the receiver has not answered, and at the end.
    pub fn send(&mut self) -> Option<Data> {
        let length = self.bytes.len();
        let mut data = Data::new();
        if self.sent == 0 && length <= 7 {
            data.push(length as u8).ok()?;
        } else if self.sent == 0 {
            data.extend_from_slice(&[0x10 | (length >> 8) as u8, length as u8]).ok()?;
        } else if self.sent < length && self.may_go {
            data.push(0x20 | self.number).ok()?;
            self.number = (self.number + 1) & 15;
        } else {
            return None;
        }
        let rest = self.bytes.get(self.sent..).unwrap_or_default();
        let taken = rest.len().min(8 - data.len());
        data.extend_from_slice(rest.get(..taken).unwrap_or_default()).ok()?;
        self.sent += taken;
        Some(data)
    }

    /// Takes the receiver's flow control. Of its three kinds only "go on" lets go; "wait" waits, "overflow" ends.
    pub fn flow(&mut self, data: &[u8]) {
        match data.first() {
            Some(0x30) => self.may_go = true,
            Some(0x31) => self.may_go = false,
            _ => self.sent = self.bytes.len(),
        }
    }

    /// Has all been sent?
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.sent >= self.bytes.len()
    }
}

/// What a receiver makes of a frame.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Step {
    /// Nothing yet.
    Nothing,
    /// Flow control to send back.
    Answer(Data),
    /// A body.
    Body(Body),
}

/// Puts frames of one sender together.
#[derive(Clone, Debug, Default)]
pub struct Receiver {
    bytes: Vec<u8, MAX_CHECKED>,
    /// Length announced by the first frame; 0 if none is under way.
    length: usize,
    number: u8,
    heard: u32,
    lost: u32,
}

impl Receiver {
    /// Takes a frame's data at this time (ms). What does not fit ends what was under way; a first or single
    /// frame always begins anew.
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

    /// Forgets what was under way, and counts it.
    fn give_up(&mut self) {
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
    use super::{COMMANDS, Data, PATIENCE, Receiver, STOP, Sender, Step, frame, stops};
    use crate::link::frame::{Body, MAX_BODY};
    use embedded_can::{ExtendedId, Frame, Id};
    use proptest::collection::vec;
    use proptest::prelude::{any, proptest};

    /// A frame as a driver might hold it.
    #[derive(Debug)]
    struct Wire(Id, std::vec::Vec<u8>);

    impl Frame for Wire {
        fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
            (data.len() <= 8).then(|| Self(id.into(), data.to_vec()))
        }
        fn new_remote(_: impl Into<Id>, _: usize) -> Option<Self> {
            None
        }
        fn is_extended(&self) -> bool {
            matches!(self.0, Id::Extended(_))
        }
        fn is_remote_frame(&self) -> bool {
            false
        }
        fn id(&self) -> Id {
            self.0
        }
        fn dlc(&self) -> usize {
            self.1.len()
        }
        fn data(&self) -> &[u8] {
            &self.1
        }
    }

    /// All data of a body, the receiver answering at once.
    fn transfer(body: &Body, receiver: &mut Receiver, now: u32) -> (std::vec::Vec<Data>, Option<Body>) {
        let (mut sender, mut sent, mut got) = (Sender::new(body), std::vec::Vec::new(), None);
        while let Some(data) = sender.send() {
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
        let mut sender = Sender::new(&Body::from_slice(&[1; 10]).expect("it fits"));
        assert!(sender.send().is_some() && sender.send().is_none() && !sender.is_done());
        sender.flow(&[0x31, 0, 0]);
        assert!(sender.send().is_none());
        sender.flow(&[0x32, 0, 0]);
        assert!(sender.send().is_none() && sender.is_done());
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

    #[test]
    fn a_stop_is_one_frame() {
        let stop = |data: &[u8]| frame::<Wire>(STOP, data).expect("a frame");
        assert!(stops(&stop(&[]), 3) && stops(&stop(&[1, 3]), 3) && !stops(&stop(&[1]), 3));
        assert!(!stops(&frame::<Wire>(COMMANDS, &[]).expect("a frame"), 3));
        let extended = Wire(Id::Extended(ExtendedId::new(STOP.into()).expect("an identifier")), std::vec![]);
        assert!(!stops(&extended, 3));
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
