//! USART 1 of an STM32F4 without interrupts or DMA, by polling.

use core::ptr::{read_volatile, write_volatile};
use smartbed_firmware::lockstep::Host;

/// Status, data and control registers.
const STATUS: *mut u32 = 0x4001_1000 as *mut u32;
const DATA: *mut u32 = 0x4001_1004 as *mut u32;
const CONTROL: *mut u32 = 0x4001_100C as *mut u32;
/// Status bits: a byte has been received; the transmit register is empty.
const RECEIVED: u32 = 1 << 5;
const ROOM: u32 = 1 << 7;
/// Receiver, transmitter and the USART enabled.
const ON: u32 = 1 << 2 | 1 << 3 | 1 << 13;

/// The line.
pub struct Usart(());

impl Usart {
    /// Switched on.
    pub fn start() -> Self {
        // SAFETY: a register of a USART that nothing else uses; likewise below.
        unsafe { write_volatile(CONTROL, ON) };
        Self(())
    }
}

impl Host for Usart {
    fn read(&mut self) -> Option<u8> {
        // SAFETY: as above.
        unsafe {
            while read_volatile(STATUS) & RECEIVED == 0 {}
            Some(read_volatile(DATA) as u8)
        }
    }
    fn write(&mut self, byte: u8) {
        // SAFETY: as above.
        unsafe {
            while read_volatile(STATUS) & ROOM == 0 {}
            write_volatile(DATA, byte.into());
        }
    }
}
