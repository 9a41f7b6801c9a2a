//! The loop on the chip: its serial line, its stack painted, its faults.

use core::ptr::{read_volatile, write_volatile};
use cortex_m_rt::{ExceptionFrame, entry, exception, heap_start};
use cortex_m_semihosting::debug;
use smartbed_firmware::lockstep::{Host, Last, serve};

/// USART1: status, data, control.
const STATUS: *mut u32 = 0x4001_1000 as *mut u32;
const DATA: *mut u32 = 0x4001_1004 as *mut u32;
const CONTROL: *mut u32 = 0x4001_100C as *mut u32;
/// A byte has come; there is room for one.
const RECEIVED: u32 = 1 << 5;
const ROOM: u32 = 1 << 7;
/// Receiver, transmitter and the whole on.
const ON: u32 = 1 << 2 | 1 << 3 | 1 << 13;
/// Set and reset register of port B, whose pin 5 is ENABLE; the high half clears.
const PORT: *mut u32 = 0x4002_0418 as *mut u32;
const ENABLE_OFF: u32 = 1 << (16 + 5);
/// What unused stack holds.
const PAINT: u32 = 0xC5C5_C5C5;
/// Stack below this function's frame that is left alone when the rest is painted (bytes).
const MARGIN: usize = 256;

struct Usart;

impl Host for Usart {
    fn read(&mut self) -> Option<u8> {
        // SAFETY: the registers of a USART that nobody else uses.
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

#[entry]
fn main() -> ! {
    let bottom = heap_start();
    let here = core::ptr::from_ref(&bottom).addr();
    paint(bottom, here.saturating_sub(MARGIN));
    // SAFETY: as above.
    unsafe { write_volatile(CONTROL, ON) };
    let last = serve(&mut Usart);
    if last == Last::Fault {
        cortex_m::asm::udf();
    }
    let used = depth(bottom, here).to_le_bytes();
    used.into_iter().for_each(|byte| Usart.write(byte));
    end(last == Last::End)
}

/// Fills what lies between static data and stack.
fn paint(bottom: *mut u32, top: usize) {
    let mut word = bottom;
    while word.addr() < top {
        // SAFETY: RAM above all static data and below the stack in use.
        unsafe { write_volatile(word, PAINT) };
        word = word.wrapping_add(1);
    }
}

/// Bytes of stack that were used below `top`, and what of it stood above.
fn depth(bottom: *mut u32, top: usize) -> u32 {
    let mut word = bottom;
    // SAFETY: as in `paint`.
    while word.addr() < top && unsafe { read_volatile(word) } == PAINT {
        word = word.wrapping_add(1);
    }
    /// End of RAM, where the stack begins.
    const TOP: usize = 0x2002_0000;
    TOP.saturating_sub(word.addr()) as u32
}

/// Tells the emulator how it went.
fn end(done: bool) -> ! {
    debug::exit(if done { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}

/// Outputs off before anything else.
#[exception]
unsafe fn HardFault(_frame: &ExceptionFrame) -> ! {
    // SAFETY: a write that only clears a pin.
    unsafe { write_volatile(PORT, ENABLE_OFF) };
    end(false)
}

/// Never linked in: the image's checks refuse whatever could call it.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: as above.
    unsafe { write_volatile(PORT, ENABLE_OFF) };
    end(false)
}
