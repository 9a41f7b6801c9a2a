//! The board's program: set-up, then one tick per millisecond; on any fault the drives go off.
//!
//! One interrupt counts milliseconds; DMA moves bytes and conversions, CAN frames wait in their controller. So handlers
//! never nest, except for a fault, and the order of a tick is that of the source text.

mod inputs;
mod outputs;
pub mod pins;
mod power;
mod program;
mod sectors;
mod watchdog;

use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m_rt::{ExceptionFrame, entry, exception};
use pins::Board;
use smartbed_firmware::node::Node;
use smartbed_firmware::station::Station;
use smartbed_firmware::tile::board::{Actuators, Sensors};
use smartbed_firmware::tile::store::Store;

/// Milliseconds since the start.
static TICKS: AtomicU32 = AtomicU32::new(0);

#[entry]
fn main() -> ! {
    match pins::take() {
        Some(board) => run(board),
        None => stop(),
    }
}

/// Ticks for ever.
fn run(board: Board) -> ! {
    let Board { mut sensors, mut actuators, bus, flash, mut watchdog, mut alive, number, reason, mut clock } =
        board;
    let store = Store::new(flash, sectors::PAGES, sectors::PAGE);
    // The boot is counted in flash, which may have to be erased, so the watchdogs start afterwards.
    let mut station =
        Station::new(Node::new(number, store, reason), bus, program::all(), program::checksum());
    clock.enable_interrupt();
    clock.enable_counter();
    watchdog.start();
    let mut last = TICKS.load(Ordering::Relaxed);
    loop {
        let now = TICKS.load(Ordering::Relaxed);
        if now == last {
            cortex_m::asm::wfi();
            continue;
        }
        let mut readings = sensors.read();
        // Milliseconds lost while storing, with drives off, are no fault.
        readings.overrun = now.wrapping_sub(last) > 1 && !sectors::has_stalled();
        last = now;
        let outputs = station.tick(&readings, program::all());
        if actuators.set(&outputs) {
            watchdog.feed();
            alive.toggle();
        }
    }
}

#[exception]
fn SysTick() {
    TICKS.store(TICKS.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
}

/// Without set-up: keeps the drives off for ever.
fn stop() -> ! {
    power::off();
    loop {
        cortex_m::asm::wfi();
    }
}

/// Switches the drives off first; the watchdog then restarts the tile.
#[exception]
unsafe fn HardFault(_frame: &ExceptionFrame) -> ! {
    stop()
}

/// An unexpected interrupt.
#[exception]
unsafe fn DefaultHandler(_number: i16) {
    power::off();
}

/// Never linked in: the image's checks refuse any code that could call it.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    stop()
}
