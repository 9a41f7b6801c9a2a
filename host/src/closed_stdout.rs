//! Checks whether standard output is closed (`>&-`), before the standard library opens the null device in its place.

use std::os::fd::BorrowedFd;

#[used]
#[expect(unsafe_code, reason = "only the loader's list of functions comes before the standard library")]
#[unsafe(link_section = ".init_array")]
static LOOK: extern "C" fn() = look;

#[expect(
    unsafe_code,
    reason = "the number of a stream that may be closed: the call that asks takes no other"
)]
extern "C" fn look() {
    let stdout = unsafe { BorrowedFd::borrow_raw(1) };
    if rustix::io::fcntl_getfd(stdout).is_err() {
        smartbed::output::stdout_is_closed();
    }
}
