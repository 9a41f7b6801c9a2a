//! The image in flash: code and constants, as the linker has laid them out, and their checksum behind them.

use core::ptr::{from_ref, read_volatile};

unsafe extern "C" {
    static __stext: u8;
    static __erodata: u8;
}

/// The checksum of [`bytes`]; `smartbed` writes it into an image that it has built. One without it moves nothing.
#[unsafe(link_section = ".checksum")]
#[used]
static CHECKSUM: u32 = u32::MAX;

/// All of it.
pub fn bytes() -> &'static [u8] {
    // SAFETY: the linker's names for the begin of the code and the end of the constants behind it; nobody writes there.
    unsafe {
        let (begin, end) = (from_ref(&__stext), from_ref(&__erodata));
        core::slice::from_raw_parts(begin, end.addr().saturating_sub(begin.addr()))
    }
}

/// The checksum that it was built with.
pub fn checksum() -> u32 {
    // SAFETY: a static. Volatile, because it is written behind the compiler's back.
    unsafe { read_volatile(&CHECKSUM) }
}
