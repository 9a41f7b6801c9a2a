//! The loop on the chip: serial line, measurement of the stack by painting, fault handlers.

use core::ptr::{read_volatile, write_volatile};
use cortex_m_rt::{ExceptionFrame, entry, exception, heap_start};
use emulator::end;
use smartbed_firmware::lockstep::{Host, Last, serve};
use usart::Usart;

mod emulator;
mod power;
mod program;
#[cfg_attr(chip = "m4", path = "usart.rs")]
#[cfg_attr(not(chip = "m4"), path = "cmsdk.rs")]
mod usart;

/// Pattern of unused stack.
const PAINT: u32 = 0xC5C5_C5C5;
/// Stack below this function's frame that is not painted (bytes).
const MARGIN: usize = 256;

unsafe extern "C" {
    /// Start of the stack.
    static _stack_start: u32;
}

#[entry]
fn main() -> ! {
    let bottom = heap_start();
    let here = core::ptr::from_ref(&bottom).addr();
    paint(bottom, here.saturating_sub(MARGIN));
    let mut usart = Usart::start();
    let last = serve(&mut usart, program::all(), program::checksum());
    if last == Last::Fault {
        cortex_m::asm::udf();
    }
    let used = depth(bottom, here).to_le_bytes();
    used.into_iter().for_each(|byte| usart.write(byte));
    end(last == Last::End)
}

/// Fills the memory between static data and the stack with the pattern.
fn paint(bottom: *mut u32, top: usize) {
    let mut word = bottom;
    while word.addr() < top {
        // SAFETY: RAM above all static data and below the stack in use.
        unsafe { write_volatile(word, PAINT) };
        word = word.wrapping_add(1);
    }
}

/// Peak use of the stack in bytes.
fn depth(bottom: *mut u32, top: usize) -> u32 {
    let mut word = bottom;
    // SAFETY: as in `paint`.
    while word.addr() < top && unsafe { read_volatile(word) } == PAINT {
        word = word.wrapping_add(1);
    }
    // SAFETY: the linker's symbol for the end of RAM; only its address is used.
    let top = unsafe { core::ptr::from_ref(&_stack_start) };
    top.addr().saturating_sub(word.addr()) as u32
}

/// Switches the drives off first.
#[exception]
unsafe fn HardFault(_frame: &ExceptionFrame) -> ! {
    power::off();
    end(false)
}

/// Never linked in: the image's checks refuse any code that could call it.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    power::off();
    end(false)
}
