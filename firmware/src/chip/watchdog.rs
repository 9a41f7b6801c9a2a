//! The chip's own watchdog, on a clock of its own of 32 kHz (17 to 47 kHz).

use stm32f4xx_hal::pac::IWDG;
use stm32f4xx_hal::pac::iwdg::RegisterBlock;

/// Keys (RM0090, 21.4.1): registers may be written, counter reloaded, started.
const WRITE: u16 = 0x5555;
const RELOAD: u16 = 0xAAAA;
const START: u16 = 0xCCCC;

/// Feeding and widening it.
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

    /// It has been a whole tick.
    pub fn feed(&mut self) {
        key(&self.0, RELOAD);
    }
}

/// For an erasure: 4 s; it is started by [`Watchdog::start`] alone, so that this does nothing before.
pub fn widen() {
    set(6, 500);
}

/// 50 ms again.
pub fn narrow() {
    set(0, 400);
}

fn key(registers: &RegisterBlock, key: u16) {
    // SAFETY: one of the three keys.
    registers.kr().write(|w| unsafe { w.bits(key) });
}

/// Divides the clock by 4 * 2^`power` and counts down from `counts`.
fn set(power: u16, counts: u16) {
    // SAFETY: only these functions write these two registers, and one caller runs at a time.
    let registers = unsafe { &*IWDG::ptr() };
    key(registers, WRITE);
    // The last change takes up to five cycles of the slow clock; a bound for a clock that stands still.
    for _ in 0..100_000 {
        if registers.sr().read().bits() == 0 {
            break;
        }
    }
    // SAFETY: numbers of the reference manual.
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
