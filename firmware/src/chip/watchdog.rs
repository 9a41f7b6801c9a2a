//! The chip's independent watchdog, clocked by its own oscillator of 32 kHz (17 to 47 kHz).

use stm32f4xx_hal::pac::IWDG;
use stm32f4xx_hal::pac::iwdg::RegisterBlock;

/// Keys (RM0090, 21.4.1): enable register writes, reload the counter, start.
const WRITE: u16 = 0x5555;
const RELOAD: u16 = 0xAAAA;
const START: u16 = 0xCCCC;

/// Control of the watchdog.
pub struct Watchdog(IWDG);

impl Watchdog {
    /// Not started.
    pub fn new(watchdog: IWDG) -> Self {
        Self(watchdog)
    }

    /// Starts it: 50 ms.
    pub fn start(&mut self) {
        key(&self.0, START);
        // 400 counts of 32 kHz / 4.
        set(0, 400);
    }

    /// Resets the counter, after a complete tick.
    pub fn feed(&mut self) {
        key(&self.0, RELOAD);
    }
}

/// Extends the period to 4 s for an erasure; without effect before [`Watchdog::start`], which alone starts it.
pub fn widen() {
    set(6, 500);
}

/// Restores the period of 50 ms.
pub fn narrow() {
    set(0, 400);
}

fn key(registers: &RegisterBlock, key: u16) {
    // SAFETY: one of the three keys.
    registers.kr().write(|w| unsafe { w.bits(key) });
}

/// Divides the clock by 4 * 2^`power` and counts down from `counts`.
fn set(power: u16, counts: u16) {
    // SAFETY: only these functions write these two registers, and only one caller runs at a time.
    let registers = unsafe { &*IWDG::ptr() };
    key(registers, WRITE);
    // The last change takes up to five cycles of the slow clock; bounded, in case that clock does not run.
    for _ in 0..100_000 {
        if registers.sr().read().bits() == 0 {
            break;
        }
    }
    // SAFETY: values of the reference manual.
    unsafe {
        registers.pr().write(|w| w.bits(power));
        registers.rlr().write(|w| w.bits(counts));
    }
    for _ in 0..100_000 {
        if registers.sr().read().bits() == 0 {
            break;
        }
    }
    key(registers, RELOAD);
}
