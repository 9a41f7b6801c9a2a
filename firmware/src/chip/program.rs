//! The image in flash: code and constants, as the linker has laid them out.

unsafe extern "C" {
    static __stext: u8;
    static __erodata: u8;
}

/// All of it.
pub fn bytes() -> &'static [u8] {
    // SAFETY: the linker's names for the begin of the code and the end of the constants behind it; nobody writes there.
    unsafe {
        let (begin, end) = (core::ptr::from_ref(&__stext), core::ptr::from_ref(&__erodata));
        core::slice::from_raw_parts(begin, end.addr().saturating_sub(begin.addr()))
    }
}
