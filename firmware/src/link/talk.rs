//! Transport between a supervisor and one tile on a CAN bus: bodies by ISO-TP (`isotp.rs`) in both directions.
//!
//! In: data of received frames, bodies to send. Out: bodies, data of frames to send. It knows no controller: a tile has
//! one talk (`can.rs`), a supervisor one for each tile (`hub.rs`).

use super::frame::Body;
use super::isotp::{Data, Receiver, Sender, Step};

/// Identifier of commands to tile 0.
pub const COMMANDS: u16 = 0x100;
/// Identifier of reports of tile 0.
pub const REPORTS: u16 = 0x200;

/// One side of the transport.
#[derive(Clone, Debug)]
pub struct Talk {
    tile: u8,
    receives: u16,
    sends: u16,
    receiver: Receiver,
    sender: Option<Sender>,
    /// Flow control to be sent.
    answer: Option<Data>,
    /// A frame that found no room.
    kept: Option<Data>,
    lost: u32,
}

impl Talk {
    /// The side of tile `number`.
    #[must_use]
    pub fn of_tile(number: u8) -> Self {
        Self::new(number, COMMANDS, REPORTS)
    }

    /// The supervisor's side towards tile `number`.
    #[must_use]
    pub fn of_supervisor(number: u8) -> Self {
        Self::new(number, REPORTS, COMMANDS)
    }

    /// The talk with tile `number`, given the identifiers for tile 0.
    fn new(number: u8, receives: u16, sends: u16) -> Self {
        let [receives, sends] = [receives, sends].map(|id| id + u16::from(number));
        Self {
            tile: number,
            receives,
            sends,
            receiver: Receiver::default(),
            sender: None,
            answer: None,
            kept: None,
            lost: 0,
        }
    }

    /// Number of the tile.
    #[must_use]
    pub fn tile(&self) -> u8 {
        self.tile
    }

    /// Identifier of received frames.
    #[must_use]
    pub fn receives(&self) -> u16 {
        self.receives
    }

    /// Identifier of sent frames.
    #[must_use]
    pub fn sends(&self) -> u16 {
        self.sends
    }

    /// Takes a frame's data; returns a body if it completes one.
    pub fn take(&mut self, data: &[u8], now: u32) -> Option<Body> {
        if let Some(0x30..=0x3F) = data.first() {
            if let Some(sender) = &mut self.sender {
                sender.flow(data);
            }
            return None;
        }
        match self.receiver.take(data, now) {
            Step::Body(body) => return Some(body),
            Step::Answer(flow) => self.answer = Some(flow),
            Step::Nothing => (),
        }
        None
    }

    /// Data of the next frame; a new body starts when the last one has been sent.
    pub fn next(&mut self, now: u32, mut collect: impl FnMut() -> Option<Body>) -> Option<Data> {
        // A frame that found no room goes first: its place is free if this one finds none either.
        if let Some(data) = self.kept.take().or_else(|| self.answer.take()) {
            return Some(data);
        }
        if self.sender.as_ref().is_some_and(|sender| !sender.is_done() && sender.is_late(now)) {
            self.sender = None;
            self.lost = self.lost.saturating_add(1);
        }
        if self.sender.as_ref().is_none_or(Sender::is_done) {
            self.sender = Some(Sender::new(&collect()?, now));
        }
        self.sender.as_mut()?.send(now)
    }

    /// Keeps a frame that found no room: it will be the next one.
    pub fn keep(&mut self, data: Data) {
        self.kept = Some(data);
    }

    /// Aborts the messages in progress, and counts them as lost.
    pub fn break_off(&mut self) {
        let is_under_way = self.sender.take().is_some_and(|sender| !sender.is_done());
        let is_kept = self.kept.take().is_some();
        self.lost = self.lost.saturating_add(u32::from(is_under_way || is_kept));
        self.answer = None;
    }

    /// Drops the message being received, which began before a stop.
    pub fn drop_received(&mut self) {
        self.receiver.give_up();
        self.answer = None;
    }

    /// Messages lost so far, both ways.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.lost.saturating_add(self.receiver.lost())
    }
}

#[cfg(test)]
mod tests {
    use super::{Data, Talk};
    use crate::link::frame::Body;

    /// A frame waits for room when a message of the other side begins: it goes first, and both messages arrive.
    #[test]
    fn flow_control_displaces_no_frame() {
        let body = Body::from_slice(&[7; 30]).expect("it fits");
        let (mut tile, mut supervisor) = (Talk::of_tile(3), Talk::of_supervisor(3));
        let (mut of_tile, mut of_supervisor) = (Some(body.clone()), Some(body.clone()));
        let (mut at_tile, mut at_supervisor) = (None, None);
        let mut sent_late = 0;
        for now in 0..60 {
            let data = tile.next(now, || of_tile.take());
            match data {
                // No room at every third time.
                Some(data) if now % 3 > 0 => {
                    tile.keep(data);
                    sent_late += 1;
                }
                Some(data) => at_supervisor = at_supervisor.or(supervisor.take(&data, now)),
                None => (),
            }
            let data: Option<Data> = supervisor.next(now, || of_supervisor.take().filter(|_| now > 3));
            at_tile = at_tile.or(data.and_then(|data| tile.take(&data, now)));
            of_supervisor = of_supervisor.or(Some(body.clone()).filter(|_| now <= 3));
        }
        assert!(sent_late > 5);
        assert_eq!((at_tile, at_supervisor), (Some(body.clone()), Some(body)));
        assert_eq!((tile.lost(), supervisor.lost()), (0, 0));
    }
}
