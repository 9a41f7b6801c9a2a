//! A CAN controller of the kind bxCAN (RM0090, 32), behind its registers: 500 kbit/s from 42 MHz, asked once a
//! millisecond.
//!
//! In: registers, the tile's number. Out: a [`Controller`] of frames. Its filters let through what is for this tile:
//! its commands into one queue, frames that stop into the other, so that none of these is lost behind commands. The
//! usual driver's code can panic, so this is one of its own; registers are a trait, so that it is tested on a model of
//! them.

use super::can::{Classic, Controller, STOP, frame};
use super::talk::COMMANDS;
use embedded_can::nb::Can;
use embedded_can::{ErrorKind, Frame, Id};

/// Registers of the controller, by their distance from the first one (bytes).
pub trait Registers {
    /// What a register holds.
    fn read(&self, register: usize) -> u32;
    /// Writes a register.
    fn write(&mut self, register: usize, bits: u32);
}

/// Master control and status; status of transmission.
const MCR: usize = 0x000;
const MSR: usize = 0x004;
const TSR: usize = 0x008;
/// The first receive queue; the other one is behind it.
const RFR: usize = 0x00C;
/// Status of errors; timing of bits.
const ESR: usize = 0x018;
const BTR: usize = 0x01C;
/// The first of three mailboxes to send from (identifier, length, data low and high), the first of two that show the
/// head of a receive queue, and the length of one.
const TX: usize = 0x180;
const RX: usize = 0x1B0;
const MAILBOX: usize = 0x10;
/// Filters: master, lists or masks, width, queue, which are active, the first bank of two registers.
const FMR: usize = 0x200;
const FM1R: usize = 0x204;
const FS1R: usize = 0x20C;
const FFA1R: usize = 0x214;
const FA1R: usize = 0x21C;
const FILTERS: usize = 0x240;

/// Bits of the master control register: ask for initialisation; frames are sent in the order in which they were asked
/// for.
const INITIALISE: u32 = 1;
const IN_ORDER: u32 = 1 << 2;
/// 42 MHz / 6 / (1 + 11 + 2) = 500 kbit/s, sampled at 86 %; two quanta to synchronise.
const TIMING: u32 = 1 << 24 | 1 << 20 | 10 << 16 | 5;
/// Looks at a bit that the controller sets within some cycles.
const LOOKS: u32 = 10_000;
/// Bits of a receive queue's register: how many frames; an overrun; let the first one go.
const WAITING: u32 = 3;
const OVERRUN: u32 = 1 << 4;
const RELEASE: u32 = 1 << 5;
/// Bits of an identifier's register: extended, remote; bit of a mailbox: send.
const EXTENDED: u32 = 1 << 2;
const REMOTE: u32 = 1 << 1;
const SEND: u32 = 1;
/// The first mailbox is empty, the next two bits are the others'.
const EMPTY: u32 = 26;
/// Give up what the three mailboxes hold.
const ABORT: u32 = 1 << 7 | 1 << 15 | 1 << 23;
/// Bit of the error status: off the bus.
const BUS_OFF: u32 = 1 << 2;

/// A queue was full, and a frame is lost.
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
    /// The controller of a tile, from reset: onto the bus, once 11 bits of silence have been seen there.
    pub fn of_tile(registers: R, number: u8) -> Self {
        let mut controller = Self(registers);
        controller.enter();
        controller.0.write(BTR, TIMING);
        controller.filter(COMMANDS + u16::from(number));
        controller.leave();
        controller
    }

    /// Into initialisation; a controller that does not follow stays off the bus.
    fn enter(&mut self) {
        self.0.write(MCR, IN_ORDER | INITIALISE);
        for _ in 0..LOOKS {
            if self.0.read(MSR) & INITIALISE != 0 {
                break;
            }
        }
    }

    /// Onto the bus; nobody waits for that.
    fn leave(&mut self) {
        self.0.write(MCR, IN_ORDER);
    }

    /// Lists of identifiers of data frames: commands go to the first queue, stops to the second.
    fn filter(&mut self, commands: u16) {
        // Two of 16 bits stand in a word, four in a bank; all are the same.
        let both = |id: u16| u32::from(id) << 5 | u32::from(id) << 21;
        // Bit 0 of the first register: filters are being set.
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

    /// Frames that stop go first.
    fn receive(&mut self) -> nb::Result<Classic, Overrun> {
        for (queue, mailbox) in [(RFR + 4, RX + MAILBOX), (RFR, RX)] {
            let state = self.0.read(queue);
            if state & OVERRUN != 0 {
                // Writing the flag clears it; so below.
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

    /// Back by way of initialisation (32.7.6); what waited to be sent is dropped.
    fn restart(&mut self) {
        self.0.write(TSR, ABORT);
        self.enter();
        self.leave();
    }
}
