//! A simulated CAN bus: arbitration by identifier, frames that are lost; the supervisor's controller, which holds a few
//! frames. Tiles have a model of the chip's (`bxcan.rs`).

use embedded_can::ErrorKind;
use embedded_can::nb::Can;
use smartbed_firmware::link::can::{Classic, Controller, raw};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// Frames that a controller holds each way, as bxCAN does.
const DEPTH: usize = 3;
/// Frames that 500 kbit/s carry in a millisecond.
pub const RATE: usize = 4;

/// Frames in a controller.
#[derive(Default)]
pub struct Chip {
    pub waiting: VecDeque<Classic>,
    come: VecDeque<Classic>,
    has_overrun: bool,
    pub is_off: bool,
    pub restarts: u32,
}

/// A controller on the bus.
#[derive(Clone, Default)]
pub struct Pin(pub Rc<RefCell<Chip>>);

#[derive(Debug)]
pub struct Overrun;

impl embedded_can::Error for Overrun {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Overrun
    }
}

impl Can for Pin {
    type Frame = Classic;
    type Error = Overrun;
    fn transmit(&mut self, frame: &Classic) -> nb::Result<Option<Classic>, Overrun> {
        let mut chip = self.0.borrow_mut();
        if chip.waiting.len() == DEPTH || chip.is_off {
            return Err(nb::Error::WouldBlock);
        }
        chip.waiting.push_back(frame.clone());
        Ok(None)
    }
    fn receive(&mut self) -> nb::Result<Classic, Overrun> {
        let mut chip = self.0.borrow_mut();
        if std::mem::take(&mut chip.has_overrun) {
            return Err(nb::Error::Other(Overrun));
        }
        chip.come.pop_front().ok_or(nb::Error::WouldBlock)
    }
}

impl Controller for Pin {
    fn is_off(&self) -> bool {
        self.0.borrow().is_off
    }
    fn restart(&mut self) {
        let mut chip = self.0.borrow_mut();
        chip.restarts += 1;
        chip.waiting.clear();
        chip.is_off = false;
    }
}

/// A controller, seen from the bus.
pub trait OnBus {
    /// Identifier of the frame that it would send.
    fn first(&self) -> Option<u16>;
    /// That frame: it has been sent.
    fn take(&self) -> Option<Classic>;
    /// A frame of another one.
    fn hear(&self, frame: &Classic);
    /// A millisecond has passed.
    fn pass(&self) {}
}

impl OnBus for Pin {
    fn first(&self) -> Option<u16> {
        self.0.borrow().waiting.front().map(|f| raw(f).unwrap_or(u16::MAX))
    }

    fn take(&self) -> Option<Classic> {
        self.0.borrow_mut().waiting.pop_front()
    }

    fn hear(&self, frame: &Classic) {
        let mut chip = self.0.borrow_mut();
        match () {
            () if chip.is_off => (),
            () if chip.come.len() < 2 * DEPTH => chip.come.push_back(frame.clone()),
            () => chip.has_overrun = true,
        }
    }
}

/// Frames on the bus.
#[derive(Default)]
pub struct Carrier {
    /// Every so many frames one is lost; 0: none.
    pub lossy: u32,
    pub carried: u32,
    /// Most frames of a tick, of all ticks.
    pub busiest: usize,
}

impl Carrier {
    /// A millisecond: the lowest identifier goes first; every other controller hears it, as far as it has room.
    pub fn carry(&mut self, pins: &[&dyn OnBus]) {
        pins.iter().for_each(|pin| pin.pass());
        for count in 0..RATE {
            let waiting = (0..pins.len()).filter(|i| pins[*i].first().is_some());
            let Some(from) = waiting.min_by_key(|i| pins[*i].first()) else { return };
            let Some(frame) = pins[from].take() else { return };
            self.carried += 1;
            self.busiest = self.busiest.max(count + 1);
            if self.lossy > 0 && self.carried.is_multiple_of(self.lossy) {
                continue;
            }
            pins.iter().enumerate().filter(|(i, _)| *i != from).for_each(|(_, pin)| pin.hear(&frame));
        }
    }
}
