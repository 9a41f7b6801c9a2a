//! The chip's CAN controller, bxCAN 1, asked once a millisecond; 500 kbit/s (RM0090, 32).
//!
//! Its filters let through what is for this tile: its commands into one queue, frames that stop into the other, so that
//! none of these is lost behind commands. The usual driver's code can panic, so this is one of its own.

use crate::chip::pins::Wires;
use embedded_can::nb::Can;
use embedded_can::{ErrorKind, Frame, Id};
use smartbed_firmware::link::can::{Classic, Controller, End, STOP, frame};
use smartbed_firmware::link::talk::COMMANDS;
use stm32f4xx_hal::pac::CAN1;
use stm32f4xx_hal::rcc::{Enable, Rcc, Reset};

/// The node's bus.
pub type Bus = End<Bxcan>;

/// Bits of the master control register: ask for initialisation; frames are sent in the order in which they were asked for.
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
pub struct Bxcan(CAN1);

/// The bus of a tile; it can always be set up.
pub fn start(wires: Wires, rcc: &mut Rcc) -> Option<Bus> {
    let Wires { can, pair: (receive, send), number, .. } = wires;
    (receive.into_alternate::<9>(), send.into_alternate::<9>());
    CAN1::enable(rcc);
    CAN1::reset(rcc);
    let controller = Bxcan(can);
    controller.enter();
    // SAFETY: numbers of the reference manual.
    unsafe { controller.0.btr().write(|w| w.bits(TIMING)) };
    controller.filter(COMMANDS + u16::from(number));
    controller.leave();
    Some(End::of_tile(controller, number))
}

impl Bxcan {
    /// Into initialisation; a controller that does not follow stays off the bus.
    fn enter(&self) {
        // SAFETY: numbers of the reference manual; so below.
        unsafe { self.0.mcr().write(|w| w.bits(IN_ORDER | INITIALISE)) };
        for _ in 0..LOOKS {
            if self.0.msr().read().bits() & INITIALISE != 0 {
                break;
            }
        }
    }

    /// Onto the bus, once 11 bits of silence have been seen there; nobody waits for that.
    fn leave(&self) {
        // SAFETY: as above.
        unsafe { self.0.mcr().write(|w| w.bits(IN_ORDER)) };
    }

    /// Lists of identifiers of data frames: commands go to the first queue, stops to the second.
    fn filter(&self, commands: u16) {
        // Two of 16 bits stand in a word, four in a bank; all are the same.
        let both = |id: u16| u32::from(id) << 5 | u32::from(id) << 21;
        // SAFETY: as above. Bit 0 of the first register: filters are being set.
        unsafe {
            self.0.fmr().modify(|r, w| w.bits(r.bits() | 1));
            self.0.fs1r().write(|w| w.bits(0));
            self.0.fm1r().write(|w| w.bits(0b11));
            self.0.ffa1r().write(|w| w.bits(0b10));
            for (bank, id) in [(self.0.fb(0), commands), (self.0.fb(1), STOP)] {
                bank.fr1().write(|w| w.bits(both(id)));
                bank.fr2().write(|w| w.bits(both(id)));
            }
            self.0.fa1r().write(|w| w.bits(0b11));
            self.0.fmr().modify(|r, w| w.bits(r.bits() & !1));
        }
    }
}

impl Can for Bxcan {
    type Frame = Classic;
    type Error = Overrun;

    fn transmit(&mut self, frame: &Classic) -> nb::Result<Option<Classic>, Overrun> {
        let empty = self.0.tsr().read().bits() >> EMPTY;
        let mailbox = match empty & 7 {
            0 => return Err(nb::Error::WouldBlock),
            free if free & 1 != 0 => self.0.tx(0),
            free if free & 2 != 0 => self.0.tx(1),
            _ => self.0.tx(2),
        };
        let Id::Standard(id) = frame.id() else { return Err(nb::Error::Other(Overrun)) };
        let mut data = [0; 8];
        data.iter_mut().zip(frame.data()).for_each(|(to, byte)| *to = *byte);
        let data = u64::from_le_bytes(data);
        // SAFETY: as above; the mailbox is empty.
        unsafe {
            mailbox.tdtr().write(|w| w.bits(frame.dlc() as u32));
            mailbox.tdlr().write(|w| w.bits(data as u32));
            mailbox.tdhr().write(|w| w.bits((data >> 32) as u32));
            mailbox.tir().write(|w| w.bits(u32::from(id.as_raw()) << 21 | SEND));
        }
        Ok(None)
    }

    /// Frames that stop go first.
    fn receive(&mut self) -> nb::Result<Classic, Overrun> {
        for (queue, mailbox) in [(self.0.rfr(1), self.0.rx(1)), (self.0.rfr(0), self.0.rx(0))] {
            let state = queue.read().bits();
            if state & OVERRUN != 0 {
                // SAFETY: as above; writing the flag clears it, so below.
                unsafe { queue.write(|w| w.bits(OVERRUN)) };
                return Err(nb::Error::Other(Overrun));
            }
            if state & WAITING == 0 {
                continue;
            }
            let (id, length) = (mailbox.rir().read().bits(), mailbox.rdtr().read().bits() & 15);
            let (low, high) = (mailbox.rdlr().read().bits(), mailbox.rdhr().read().bits());
            // SAFETY: as above.
            unsafe { queue.write(|w| w.bits(RELEASE)) };
            let data = (u64::from(high) << 32 | u64::from(low)).to_le_bytes();
            let data = data.get(..length as usize).filter(|_| id & (EXTENDED | REMOTE) == 0);
            // The filters let nothing else through.
            let Some(frame) = data.and_then(|data| frame((id >> 21) as u16, data)) else { continue };
            return Ok(frame);
        }
        Err(nb::Error::WouldBlock)
    }
}

impl Controller for Bxcan {
    fn is_off(&self) -> bool {
        self.0.esr().read().bits() & BUS_OFF != 0
    }

    /// Back by way of initialisation (32.7.6); what waited to be sent is dropped.
    fn restart(&mut self) {
        // SAFETY: as above. Abort all three mailboxes.
        unsafe { self.0.tsr().write(|w| w.bits(1 << 7 | 1 << 15 | 1 << 23)) };
        self.enter();
        self.leave();
    }
}
