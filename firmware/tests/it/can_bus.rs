//! A simulated CAN bus: controllers that hold a few frames, arbitration by identifier, frames that are lost.

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

/// What a controller holds.
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

/// What the bus carries.
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
    pub fn carry(&mut self, pins: &[Pin]) {
        for count in 0..RATE {
            let first = |pin: &Pin| pin.0.borrow().waiting.front().map(|f| raw(f).unwrap_or(u16::MAX));
            let waiting = (0..pins.len()).filter(|i| first(&pins[*i]).is_some());
            let Some(from) = waiting.min_by_key(|i| first(&pins[*i])) else { return };
            let Some(frame) = pins[from].0.borrow_mut().waiting.pop_front() else { return };
            self.carried += 1;
            self.busiest = self.busiest.max(count + 1);
            if self.lossy > 0 && self.carried.is_multiple_of(self.lossy) {
                continue;
            }
            for (_, pin) in pins.iter().enumerate().filter(|(i, pin)| *i != from && !pin.0.borrow().is_off) {
                let mut chip = pin.0.borrow_mut();
                if chip.come.len() < 2 * DEPTH {
                    chip.come.push_back(frame.clone())
                } else {
                    chip.has_overrun = true
                }
            }
        }
    }
}
