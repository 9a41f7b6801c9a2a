//! UART 0 of Arm's prototyping boards (CMSDK, technical reference manual 4.3), by polling.

use core::ptr::{read_volatile, write_volatile};
use smartbed_firmware::lockstep::Host;

/// Base address of its registers; a secure program on an M33 uses their secure alias.
const BASE: usize = if cfg!(chip = "m33") { 0x5020_0000 } else { 0x4000_4000 };
const DATA: *mut u32 = BASE as *mut u32;
const STATE: *mut u32 = (BASE + 4) as *mut u32;
const CONTROL: *mut u32 = (BASE + 8) as *mut u32;
const DIVIDER: *mut u32 = (BASE + 16) as *mut u32;
/// Status bits: a byte has been received; the transmit buffer is full.
const RECEIVED: u32 = 1 << 1;
const FULL: u32 = 1;
/// Transmitter and receiver enabled; the smallest divider.
const ON: u32 = 3;
const FASTEST: u32 = 16;

/// The line.
pub struct Usart(());

impl Usart {
    /// Switched on.
    pub fn start() -> Self {
        // SAFETY: registers of a UART that nothing else uses; likewise below.
        unsafe {
            write_volatile(DIVIDER, FASTEST);
            write_volatile(CONTROL, ON);
        }
        Self(())
    }
}

impl Host for Usart {
    fn read(&mut self) -> Option<u8> {
        // SAFETY: as above.
        unsafe {
            while read_volatile(STATE) & RECEIVED == 0 {}
            Some(read_volatile(DATA) as u8)
        }
    }
    fn write(&mut self, byte: u8) {
        // SAFETY: as above.
        unsafe {
            while read_volatile(STATE) & FULL != 0 {}
            write_volatile(DATA, byte.into());
        }
    }
}
