//! Sectors 1 and 2 of the flash, 16 KB each, as the store's two pages.
//!
//! Erasing or writing stalls the whole flash and thereby the program. So drives are cut before, the watchdog period is
//! extended meanwhile, and the late tick is no fault.

use super::{power, watchdog};
use core::ptr::{read_volatile, write_volatile};
use core::sync::atomic::{AtomicBool, Ordering};
use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash};
use stm32f4xx_hal::pac::FLASH;

/// Offsets of the sectors from 0x0800_0000, and their length (bytes); `chips/m4.x` leaves them free.
pub const PAGES: [u32; 2] = [0x4000, 0x8000];
/// See [`PAGES`].
pub const PAGE: u32 = 0x4000;
const BASE: u32 = 0x0800_0000;
/// Keys that unlock the control register (RM0090, 3.6.2).
const KEYS: [u32; 2] = [0x4567_0123, 0xCDEF_89AB];
/// Bits of the control register: program, erase a sector, words of 32 bits, start, lock.
const PROGRAM: u32 = 1;
const ERASE: u32 = 1 << 1;
const WORDS: u32 = 2 << 8;
const START: u32 = 1 << 16;
const LOCK: u32 = 1 << 31;
/// Bits of the status register: busy; errors.
const BUSY: u32 = 1 << 16;
const WRONG: u32 = 0xF2;
/// Polls of the status within which every erasure ends: it takes at most 2 s, and each poll takes some cycles.
const LOOKS: u32 = 168_000_000;

static STALLED: AtomicBool = AtomicBool::new(false);

/// Whether the flash has stalled since the last call.
pub fn has_stalled() -> bool {
    let stalled = STALLED.load(Ordering::Relaxed);
    STALLED.store(false, Ordering::Relaxed);
    stalled
}

/// Erasing or writing failed, or the address is out of range.
#[derive(Clone, Copy, Debug)]
pub struct Refused;

impl NorFlashError for Refused {
    fn kind(&self) -> NorFlashErrorKind {
        NorFlashErrorKind::Other
    }
}

/// The two sectors.
pub struct Sectors(FLASH);

impl Sectors {
    /// The two sectors, locked.
    pub fn new(flash: FLASH) -> Self {
        Self(flash)
    }

    /// The address of this range, if it belongs to the store.
    fn address(from: u32, length: usize) -> Result<u32, Refused> {
        let end = u32::try_from(length).ok().and_then(|length| from.checked_add(length)).ok_or(Refused)?;
        let [first, second] = PAGES;
        if from < first || end > second + PAGE { Err(Refused) } else { Ok(BASE + from) }
    }

    /// Runs `work` with the registers unlocked, drives off and the watchdog period extended.
    fn unlocked(&mut self, work: impl FnOnce(&FLASH) -> Result<(), Refused>) -> Result<(), Refused> {
        power::off();
        watchdog::widen();
        STALLED.store(true, Ordering::Relaxed);
        let flash = &self.0;
        // SAFETY: values of the reference manual; the data cache is flushed, because it may hold the old content.
        let done = unsafe {
            KEYS.iter().for_each(|key| {
                flash.keyr().write(|w| w.bits(*key));
            });
            flash.sr().write(|w| w.bits(WRONG));
            let done = work(flash);
            flash.cr().write(|w| w.bits(LOCK));
            flash.acr().modify(|_, w| w.dcen().clear_bit());
            flash.acr().modify(|_, w| w.dcrst().set_bit());
            flash.acr().modify(|_, w| w.dcrst().clear_bit());
            flash.acr().modify(|_, w| w.dcen().set_bit());
            done
        };
        watchdog::narrow();
        done
    }
}

/// Waits until the flash is no longer busy; returns whether the operation succeeded.
fn settled(flash: &FLASH) -> Result<(), Refused> {
    for _ in 0..LOOKS {
        let status = flash.sr().read().bits();
        if status & BUSY == 0 {
            return if status & WRONG == 0 { Ok(()) } else { Err(Refused) };
        }
    }
    Err(Refused)
}

impl ErrorType for Sectors {
    type Error = Refused;
}

impl ReadNorFlash for Sectors {
    const READ_SIZE: usize = 1;
    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Refused> {
        let address = Self::address(offset, bytes.len())?;
        for (byte, place) in bytes.iter_mut().zip(address..) {
            // SAFETY: an address in the two sectors.
            *byte = unsafe { read_volatile(place as *const u8) };
        }
        Ok(())
    }
    fn capacity(&self) -> usize {
        let [_, second] = PAGES;
        (second + PAGE) as usize
    }
}

impl NorFlash for Sectors {
    const WRITE_SIZE: usize = 4;
    const ERASE_SIZE: usize = PAGE as usize;
    fn erase(&mut self, from: u32, to: u32) -> Result<(), Refused> {
        let is_whole = from.is_multiple_of(PAGE) && to.is_multiple_of(PAGE);
        Self::address(from, to.checked_sub(from).filter(|_| is_whole).ok_or(Refused)? as usize)?;
        self.unlocked(|flash| {
            for sector in from / PAGE..to / PAGE {
                // SAFETY: values of the reference manual.
                unsafe { flash.cr().write(|w| w.bits(WORDS | ERASE | sector << 3 | START)) };
                settled(flash)?;
            }
            Ok(())
        })
    }
    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Refused> {
        let address = Self::address(offset, bytes.len())?;
        let (words, rest) = bytes.as_chunks::<4>();
        if !address.is_multiple_of(4) || !rest.is_empty() {
            return Err(Refused);
        }
        self.unlocked(|flash| {
            for (word, place) in words.iter().zip((address..).step_by(4)) {
                // SAFETY: an aligned address in the two sectors, with programming enabled.
                unsafe {
                    flash.cr().write(|w| w.bits(WORDS | PROGRAM));
                    write_volatile(place as *mut u32, u32::from_le_bytes(*word));
                }
                settled(flash)?;
            }
            Ok(())
        })
    }
}
