//! The image in flash: vectors, code and constants, at the linker's addresses, followed by their checksum.

use core::ptr::{from_ref, read_volatile};
use smartbed_firmware::tile::integrity::Program;

unsafe extern "C" {
    static __svectors: u8;
    static __evectors: u8;
    static __stext: u8;
    static __erodata: u8;
}

/// The checksum of [`all`]; `smartbed` writes it into the image after the build. An image without it does not move.
#[unsafe(link_section = ".checksum")]
#[used]
static CHECKSUM: u32 = u32::MAX;

/// The whole program.
pub fn all() -> Program<'static> {
    // SAFETY: the linker's symbols for begin and end of vectors, and of code and constants; nothing writes there.
    unsafe {
        Program {
            vectors: between(from_ref(&__svectors), from_ref(&__evectors)),
            code: between(from_ref(&__stext), from_ref(&__erodata)),
        }
    }
}

/// # Safety
/// Memory between the two addresses must be readable, and nothing may write it.
unsafe fn between(begin: *const u8, end: *const u8) -> &'static [u8] {
    // SAFETY: guaranteed by the caller.
    unsafe { core::slice::from_raw_parts(begin, end.addr().saturating_sub(begin.addr())) }
}

/// The checksum that was written into the image.
pub fn checksum() -> u32 {
    // SAFETY: a static. Volatile, because it is changed after the compiler has run.
    unsafe { read_volatile(&CHECKSUM) }
}
