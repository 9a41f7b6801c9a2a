//! A node on a CAN bus: bodies by ISO-TP (`isotp.rs`) under two identifiers, and a frame of its own that stops.
//!
//! In: frames of any controller behind embedded-can's traits. Out: frames; bodies for the node, and what stops it.
//! Commands to tile n have the identifier 0x100 + n, its reports 0x200 + n, flow control for the one goes under the other.
//! A controller that has left the bus after too many errors comes back after a pause, never sooner.

use super::bus::{Arrival, Bus};
use super::frame::Body;
use super::isotp::{Data, Receiver, Sender, Step};
use embedded_can::{Frame, Id, StandardId, nb::Can};

/// Identifier of the frame that stops; lower than all others, so it goes first: every tile without data, else the tiles
/// whose numbers are its bytes.
pub const STOP: u16 = 0x010;
/// Identifier of commands to tile 0.
pub const COMMANDS: u16 = 0x100;
/// Identifier of reports of tile 0.
pub const REPORTS: u16 = 0x200;
/// Most frames read, and sent, in a tick: 500 kbit/s bring five.
pub const FRAMES: usize = 8;
/// A controller stays off the bus for so long (ms): the standard asks for 128 times 11 bits, 2.8 ms.
pub const REST: u32 = 100;

/// A CAN controller.
pub trait Controller: Can {
    /// Has it left the bus after too many errors?
    fn is_off(&self) -> bool;
    /// Lets it come back.
    fn restart(&mut self);
}

/// A classical data frame, for controllers that have none of their own.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Classic {
    id: Id,
    data: Data,
}

impl Frame for Classic {
    fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
        Some(Self { id: id.into(), data: Data::from_slice(data).ok()? })
    }
    /// The protocol has none.
    fn new_remote(_: impl Into<Id>, _: usize) -> Option<Self> {
        None
    }
    fn is_extended(&self) -> bool {
        matches!(self.id, Id::Extended(_))
    }
    fn is_remote_frame(&self) -> bool {
        false
    }
    fn id(&self) -> Id {
        self.id
    }
    fn dlc(&self) -> usize {
        self.data.len()
    }
    fn data(&self) -> &[u8] {
        &self.data
    }
}

/// The frame of this identifier and data.
#[must_use]
pub fn frame<F: Frame>(id: u16, data: &[u8]) -> Option<F> {
    F::new(StandardId::new(id)?, data)
}

/// Is it a data frame of this identifier?
fn is_of(frame: &impl Frame, id: u16) -> bool {
    frame.is_data_frame() && matches!(frame.id(), Id::Standard(standard) if standard.as_raw() == id)
}

/// Does this frame stop the tile?
#[must_use]
pub fn stops(frame: &impl Frame, tile: u8) -> bool {
    is_of(frame, STOP) && (frame.data().is_empty() || frame.data().contains(&tile))
}

/// One end of the talk between a supervisor and a tile.
#[derive(Clone, Debug)]
pub struct End<C> {
    /// The controller.
    pub controller: C,
    /// The tile that a frame may stop: this end, if it is one.
    tile: Option<u8>,
    hears: u16,
    says: u16,
    receiver: Receiver,
    sender: Option<Sender>,
    /// Flow control that is to be sent.
    answer: Option<Data>,
    /// A frame of the sender's for which there was no room.
    kept: Option<Data>,
    /// When the controller was last seen to be off the bus, or let come back.
    off: Option<u32>,
    lost: u32,
}

impl<C: Controller> End<C> {
    /// The end of tile `number`.
    pub fn of_tile(controller: C, number: u8) -> Self {
        let [commands, reports] = [COMMANDS, REPORTS].map(|id| id + u16::from(number));
        Self::new(controller, Some(number), commands, reports)
    }

    /// The supervisor's end towards tile `number`.
    pub fn of_supervisor(controller: C, number: u8) -> Self {
        let [commands, reports] = [COMMANDS, REPORTS].map(|id| id + u16::from(number));
        Self::new(controller, None, reports, commands)
    }

    fn new(controller: C, tile: Option<u8>, hears: u16, says: u16) -> Self {
        let receiver = Receiver::default();
        let (sender, answer, kept, off) = (None, None, None, None);
        Self { controller, tile, hears, says, receiver, sender, answer, kept, off, lost: 0 }
    }

    /// What a frame brings.
    fn take(&mut self, frame: &C::Frame, now: u32) -> Option<Arrival> {
        if self.tile.is_some_and(|tile| stops(frame, tile)) {
            return Some(Arrival::Stop);
        }
        if !is_of(frame, self.hears) {
            return None;
        }
        if let Some(0x30..=0x3F) = frame.data().first() {
            if let Some(sender) = &mut self.sender {
                sender.flow(frame.data());
            }
            return None;
        }
        match self.receiver.take(frame.data(), now) {
            Step::Body(body) => Some(Arrival::Body(body)),
            Step::Answer(flow) => {
                self.answer = Some(flow);
                None
            }
            Step::Nothing => None,
        }
    }

    /// Is the controller on the bus? One that is not comes back after [`REST`]; what was under way is lost.
    fn is_on(&mut self, now: u32) -> bool {
        if !self.controller.is_off() {
            self.off = None;
            return true;
        }
        let is_under_way = self.sender.take().is_some() || self.kept.take().is_some();
        self.lost = self.lost.saturating_add(u32::from(is_under_way));
        self.answer = None;
        if now.wrapping_sub(*self.off.get_or_insert(now)) >= REST {
            self.controller.restart();
            self.off = Some(now);
        }
        false
    }

    /// The data of the next frame; a new body is begun when the last one is over.
    fn next(&mut self, now: u32, mut collect: impl FnMut() -> Option<Body>) -> Option<Data> {
        if let Some(data) = self.answer.take().or_else(|| self.kept.take()) {
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
}

impl<C: Controller> Bus for End<C> {
    fn receive(&mut self, now: u32, mut take: impl FnMut(Arrival)) {
        for _ in 0..FRAMES {
            match self.controller.receive() {
                Ok(frame) => self.take(&frame, now).map_or((), &mut take),
                Err(nb::Error::WouldBlock) => return,
                Err(nb::Error::Other(_)) => self.lost = self.lost.saturating_add(1),
            }
        }
    }

    fn transmit(&mut self, now: u32, mut collect: impl FnMut() -> Option<Body>) {
        if !self.is_on(now) {
            return;
        }
        for _ in 0..FRAMES {
            let Some(data) = self.next(now, &mut collect) else { return };
            let Some(frame) = frame::<C::Frame>(self.says, &data) else { return };
            match self.controller.transmit(&frame) {
                Ok(None) => (),
                Err(nb::Error::WouldBlock) => {
                    self.kept = Some(data);
                    return;
                }
                // A frame of another message was pushed aside, or this one is lost.
                Ok(Some(_)) | Err(nb::Error::Other(_)) => self.lost = self.lost.saturating_add(1),
            }
        }
    }

    fn lost(&self) -> u32 {
        self.lost.saturating_add(self.receiver.lost())
    }
}

#[cfg(test)]
mod tests {
    use super::{COMMANDS, Classic, STOP, frame, stops};
    use embedded_can::{ExtendedId, Frame};

    #[test]
    fn a_stop_is_one_frame() {
        let stop = |data: &[u8]| frame::<Classic>(STOP, data).expect("a frame");
        assert!(stops(&stop(&[]), 3) && stops(&stop(&[1, 3]), 3) && !stops(&stop(&[1]), 3));
        assert!(!stops(&frame::<Classic>(COMMANDS, &[]).expect("a frame"), 3));
        let extended = ExtendedId::new(STOP.into()).and_then(|id| Classic::new(id, &[])).expect("a frame");
        assert!(!stops(&extended, 3));
        assert_eq!(Classic::new_remote(ExtendedId::ZERO, 0), None);
    }
}
