//! A CAN controller of the bxCAN type (RM0090, 32) behind its registers: 500 kbit/s from 42 MHz, polled once per
//! millisecond.
//!
//! In: registers, the tile's number. Out: a [`Controller`] of frames. Its filters accept frames for this tile only:
//! commands go to one receive queue, stop frames to the other, so that no stop is lost behind commands. Own code,
//! because the usual driver's can panic; registers are a trait, so that it is tested on a model of them.

use super::can::{Classic, Controller, STOP, frame};
use super::talk::COMMANDS;
use embedded_can::nb::Can;
use embedded_can::{ErrorKind, Frame, Id};

/// Registers of the controller, by byte offset from the first.
pub trait Registers {
    /// Reads a register.
    fn read(&self, register: usize) -> u32;
    /// Writes a register.
    fn write(&mut self, register: usize, bits: u32);
}

/// Master control and status; transmit status.
const MCR: usize = 0x000;
const MSR: usize = 0x004;
const TSR: usize = 0x008;
/// The first receive queue; the second one follows.
const RFR: usize = 0x00C;
/// Error status; bit timing.
const ESR: usize = 0x018;
const BTR: usize = 0x01C;
/// The first of three transmit mailboxes (identifier, length, data low and high), the first of two that show the
/// head of a receive queue, and the size of a mailbox.
const TX: usize = 0x180;
const RX: usize = 0x1B0;
const MAILBOX: usize = 0x10;
/// Filters: master, list or mask mode, scale, queue assignment, activation, the first bank of two registers.
const FMR: usize = 0x200;
const FM1R: usize = 0x204;
const FS1R: usize = 0x20C;
const FFA1R: usize = 0x214;
const FA1R: usize = 0x21C;
const FILTERS: usize = 0x240;

/// Bits of the master control register: request initialisation; transmit in the order of requests.
const INITIALISE: u32 = 1;
const IN_ORDER: u32 = 1 << 2;
/// 42 MHz / 6 / (1 + 11 + 2) = 500 kbit/s, sampled at 86 %; two quanta to synchronise.
const TIMING: u32 = 1 << 24 | 1 << 20 | 10 << 16 | 5;
/// Polls of a bit that the controller sets within some cycles.
const LOOKS: u32 = 10_000;
/// Bits of a receive queue's register: number of frames; overrun; release the first frame.
const WAITING: u32 = 3;
const OVERRUN: u32 = 1 << 4;
const RELEASE: u32 = 1 << 5;
/// Bits of an identifier register: extended, remote; bit of a mailbox: transmit request.
const EXTENDED: u32 = 1 << 2;
const REMOTE: u32 = 1 << 1;
const SEND: u32 = 1;
/// Number of the bit that shows the first mailbox empty; the next two bits show the others.
const EMPTY: u32 = 26;
/// Abort requests of the three mailboxes.
const ABORT: u32 = 1 << 7 | 1 << 15 | 1 << 23;
/// Bit of the error status: bus off.
const BUS_OFF: u32 = 1 << 2;

/// A queue was full and a frame was lost.
#[derive(Clone, Copy, Debug)]
pub struct Overrun;

impl embedded_can::Error for Overrun {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Overrun
    }
}

/// The controller.
#[derive(Clone, Debug)]
pub struct Bxcan<R>(R);

impl<R: Registers> Bxcan<R> {
    /// The controller of a tile, from reset; it joins the bus after 11 recessive bits.
    pub fn of_tile(registers: R, number: u8) -> Self {
        let mut controller = Self(registers);
        controller.enter();
        controller.0.write(BTR, TIMING);
        controller.filter(COMMANDS + u16::from(number));
        controller.leave();
        controller
    }

    /// Enters initialisation; a controller that does not respond stays off the bus.
    fn enter(&mut self) {
        self.0.write(MCR, IN_ORDER | INITIALISE);
        for _ in 0..LOOKS {
            if self.0.read(MSR) & INITIALISE != 0 {
                break;
            }
        }
    }

    /// Leaves initialisation towards the bus, without waiting.
    fn leave(&mut self) {
        self.0.write(MCR, IN_ORDER);
    }

    /// Sets lists of identifiers of data frames: commands go to the first queue, stops to the second.
    fn filter(&mut self, commands: u16) {
        // Two 16-bit identifiers per word, four per bank; all four are equal.
        let both = |id: u16| u32::from(id) << 5 | u32::from(id) << 21;
        // Bit 0 of the first register: filter initialisation.
        let master = self.0.read(FMR);
        self.0.write(FMR, master | 1);
        self.0.write(FS1R, 0);
        self.0.write(FM1R, 0b11);
        self.0.write(FFA1R, 0b10);
        for (word, id) in [commands, commands, STOP, STOP].into_iter().enumerate() {
            self.0.write(FILTERS + 4 * word, both(id));
        }
        self.0.write(FA1R, 0b11);
        self.0.write(FMR, master & !1);
    }
}

impl<R: Registers> Can for Bxcan<R> {
    type Frame = Classic;
    type Error = Overrun;

    fn transmit(&mut self, frame: &Classic) -> nb::Result<Option<Classic>, Overrun> {
        let empty = self.0.read(TSR) >> EMPTY;
        let mailbox = match empty & 7 {
            0 => return Err(nb::Error::WouldBlock),
            free if free & 1 != 0 => TX,
            free if free & 2 != 0 => TX + MAILBOX,
            _ => TX + 2 * MAILBOX,
        };
        let Id::Standard(id) = frame.id() else { return Err(nb::Error::Other(Overrun)) };
        let mut data = [0; 8];
        data.iter_mut().zip(frame.data()).for_each(|(to, byte)| *to = *byte);
        let data = u64::from_le_bytes(data);
        self.0.write(mailbox + 4, frame.dlc() as u32);
        self.0.write(mailbox + 8, data as u32);
        self.0.write(mailbox + 12, (data >> 32) as u32);
        self.0.write(mailbox, u32::from(id.as_raw()) << 21 | SEND);
        Ok(None)
    }

    /// Stop frames first.
    fn receive(&mut self) -> nb::Result<Classic, Overrun> {
        for (queue, mailbox) in [(RFR + 4, RX + MAILBOX), (RFR, RX)] {
            let state = self.0.read(queue);
            if state & OVERRUN != 0 {
                // Writing the flag clears it; likewise below.
                self.0.write(queue, OVERRUN);
                return Err(nb::Error::Other(Overrun));
            }
            if state & WAITING == 0 {
                continue;
            }
            let (id, length) = (self.0.read(mailbox), self.0.read(mailbox + 4) & 15);
            let (low, high) = (self.0.read(mailbox + 8), self.0.read(mailbox + 12));
            self.0.write(queue, RELEASE);
            let data = (u64::from(high) << 32 | u64::from(low)).to_le_bytes();
            let data = data.get(..length as usize).filter(|_| id & (EXTENDED | REMOTE) == 0);
            // The filters let nothing else through.
            let Some(frame) = data.and_then(|data| frame((id >> 21) as u16, data)) else { continue };
            return Ok(frame);
        }
        Err(nb::Error::WouldBlock)
    }
}

impl<R: Registers> Controller for Bxcan<R> {
    fn is_off(&self) -> bool {
        self.0.read(ESR) & BUS_OFF != 0
    }

    /// Returns to the bus through initialisation (32.7.6); pending transmissions are dropped.
    fn restart(&mut self) {
        self.0.write(TSR, ABORT);
        self.enter();
        self.leave();
    }
}
