//! The line ENABLE, PB5: low cuts the power of all drives, whatever else is set.

use core::ptr::write_volatile;

/// Bit set/reset register of port B; the high half clears bits.
const PORT: *mut u32 = 0x4002_0418 as *mut u32;
const ENABLE_OFF: u32 = 1 << (16 + 5);

/// Drives off. Emulated boards of other chips have no such line.
pub fn off() {
    if !cfg!(chip = "m4") {
        return;
    }
    // SAFETY: a write that clears one pin and touches no other.
    unsafe { write_volatile(PORT, ENABLE_OFF) };
}
