//! Start, end and faults of the image.

use cortex_m_rt::{ExceptionFrame, entry, exception};
use cortex_m_semihosting::hio;
use emulator::end;

mod emulator;
#[cfg(inject)]
mod inject;

#[entry]
fn main() -> ! {
    #[cfg(inject)]
    inject::defect();
    let done = super::demonstrate(|bytes| {
        if let Ok(mut out) = hio::hstdout() {
            // A host that does not listen is no reason to stop.
            let _ = out.write_all(bytes);
        }
    });
    end(done)
}

#[exception]
unsafe fn HardFault(_frame: &ExceptionFrame) -> ! {
    end(false)
}

/// Never linked in: the image's checks refuse any code that could call it.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    end(false)
}
