//! A tile on a CAN bus: its transport to the supervisor (`talk.rs`), and a separate frame that stops it.
//!
//! In: frames of any controller behind embedded-can's traits. Out: frames; bodies and stops for the node.
//! A controller that has gone bus-off after too many errors is restarted after a pause, never sooner.

use super::bus::{Arrival, Bus};
use super::frame::Body;
use super::isotp::Data;
use super::talk::Talk;
use embedded_can::{Frame, Id, StandardId, nb::Can};

/// Identifier of the stop frame, the lowest and so of highest priority: without data it stops every tile, else the
/// tiles whose numbers are its bytes.
pub const STOP: u16 = 0x010;
/// Most frames read, and sent, in a tick: 500 kbit/s bring five.
pub const FRAMES: usize = 8;
/// Time that a controller stays off the bus (ms); the standard requires 128 times 11 bits, 2.8 ms.
pub const REST: u32 = 100;

/// A CAN controller.
pub trait Controller: Can {
    /// Whether it is bus-off after too many errors.
    fn is_off(&self) -> bool;
    /// Restarts it.
    fn restart(&mut self);
}

/// A classical data frame, for controllers without a frame type of their own.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Classic {
    id: Id,
    data: Data,
}

impl Frame for Classic {
    fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
        Some(Self { id: id.into(), data: Data::from_slice(data).ok()? })
    }
    /// The protocol has no remote frames.
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

/// The frame's identifier, if it has eleven bits.
pub fn raw(frame: &impl Frame) -> Option<u16> {
    match frame.id() {
        Id::Standard(id) => Some(id.as_raw()),
        Id::Extended(_) => None,
    }
}

/// Whether it is a data frame with this identifier.
#[must_use]
pub fn is_data(frame: &impl Frame, identifier: u16) -> bool {
    frame.is_data_frame() && raw(frame) == Some(identifier)
}

/// Whether this frame stops the tile.
#[must_use]
pub fn stops(frame: &impl Frame, tile: u8) -> bool {
    is_data(frame, STOP) && names(frame.data(), tile)
}

/// Whether the data of a stop mean the tile.
#[must_use]
pub fn names(data: &[u8], tile: u8) -> bool {
    data.is_empty() || data.contains(&tile)
}

/// A controller with its bus-off handling.
#[derive(Clone, Debug)]
pub struct Port<C> {
    controller: C,
    /// Time at which the controller was first seen bus-off, or was restarted last.
    off: Option<u32>,
    lost: u32,
}

impl<C: Controller> Port<C> {
    /// This controller.
    pub fn new(controller: C) -> Self {
        Self { controller, off: None, lost: 0 }
    }

    /// Hands over the received frames.
    pub fn receive(&mut self, mut take: impl FnMut(&C::Frame)) {
        for _ in 0..FRAMES {
            match self.controller.receive() {
                Ok(frame) => take(&frame),
                Err(nb::Error::WouldBlock) => return,
                Err(nb::Error::Other(_)) => self.lost = self.lost.saturating_add(1),
            }
        }
    }

    /// Whether the controller is on the bus. One that is not is restarted after [`REST`]; messages in progress are
    /// lost.
    pub fn is_on(&mut self, now: u32) -> bool {
        if !self.controller.is_off() {
            self.off = None;
            return true;
        }
        if now.wrapping_sub(*self.off.get_or_insert(now)) >= REST {
            self.controller.restart();
            self.off = Some(now);
        }
        false
    }

    /// Sends a frame; false if there is no room now.
    pub fn send(&mut self, id: u16, data: &[u8]) -> bool {
        let Some(frame) = frame::<C::Frame>(id, data) else { return true };
        match self.controller.transmit(&frame) {
            Ok(None) => (),
            Err(nb::Error::WouldBlock) => return false,
            // A frame of another message was displaced, or this one was lost.
            Ok(Some(_)) | Err(nb::Error::Other(_)) => self.lost = self.lost.saturating_add(1),
        }
        true
    }

    /// Sends the next frame of a talk, if it has one: true if it was sent, false if there was no room and it was kept.
    pub fn send_next(
        &mut self,
        talk: &mut Talk,
        now: u32,
        collect: impl FnMut() -> Option<Body>,
    ) -> Option<bool> {
        let data = talk.next(now, collect)?;
        let is_sent = self.send(talk.sends(), &data);
        if !is_sent {
            talk.keep(data);
        }
        Some(is_sent)
    }

    /// Frames lost so far.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.lost
    }
}

/// A tile's end of the bus.
#[derive(Clone, Debug)]
pub struct End<C> {
    port: Port<C>,
    talk: Talk,
}

impl<C: Controller> End<C> {
    /// The end of tile `number`.
    pub fn of_tile(controller: C, number: u8) -> Self {
        Self { port: Port::new(controller), talk: Talk::of_tile(number) }
    }
}

impl<C: Controller> Bus for End<C> {
    fn receive(&mut self, now: u32, mut take: impl FnMut(Arrival)) {
        let Self { port, talk } = self;
        port.receive(|frame| {
            let arrival = match is_data(frame, talk.receives()) {
                true => talk.take(frame.data(), now).map(Arrival::Body),
                false => stops(frame, talk.tile()).then_some(Arrival::Stop),
            };
            if let Some(arrival) = arrival {
                if matches!(arrival, Arrival::Stop) {
                    talk.drop_received();
                }
                take(arrival);
            }
        });
    }

    fn transmit(&mut self, now: u32, mut collect: impl FnMut() -> Option<Body>) {
        let Self { port, talk, .. } = self;
        if !port.is_on(now) {
            talk.break_off();
            return;
        }
        for _ in 0..FRAMES {
            if port.send_next(talk, now, &mut collect) != Some(true) {
                return;
            }
        }
    }

    fn lost(&self) -> u32 {
        self.port.lost().saturating_add(self.talk.lost())
    }
}

#[cfg(test)]
mod tests {
    use super::{Classic, STOP, frame, stops};
    use crate::link::talk::COMMANDS;
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
