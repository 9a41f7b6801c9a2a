//! The image in flash: vectors, code and constants, as the linker has laid them out, and their checksum behind them.

use core::ptr::{from_ref, read_volatile};
use smartbed_firmware::tile::integrity::Program;

unsafe extern "C" {
    static __svectors: u8;
    static __evectors: u8;
    static __stext: u8;
    static __erodata: u8;
}

/// The checksum of [`all`]; `smartbed` writes it into an image that it has built. One without it moves nothing.
#[unsafe(link_section = ".checksum")]
#[used]
static CHECKSUM: u32 = u32::MAX;

/// All of it.
pub fn all() -> Program<'static> {
    // SAFETY: the linker's names for begin and end of the vectors, and of code and constants; nobody writes there.
    unsafe {
        Program {
            vectors: between(from_ref(&__svectors), from_ref(&__evectors)),
            code: between(from_ref(&__stext), from_ref(&__erodata)),
        }
    }
}

/// # Safety
/// Between the two lies memory that can be read, and that nobody writes.
unsafe fn between(begin: *const u8, end: *const u8) -> &'static [u8] {
    // SAFETY: as promised.
    unsafe { core::slice::from_raw_parts(begin, end.addr().saturating_sub(begin.addr())) }
}

/// The checksum that it was built with.
pub fn checksum() -> u32 {
    // SAFETY: a static. Volatile, because it is written behind the compiler's back.
    unsafe { read_volatile(&CHECKSUM) }
}
