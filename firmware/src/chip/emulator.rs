//! How an image ends in the emulator.

use cortex_m_semihosting::debug;

/// Reports success or failure to the emulator.
pub fn end(done: bool) -> ! {
    debug::exit(if done { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}
