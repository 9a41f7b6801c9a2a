//! The controller of a real tile on a CAN bus: an STM32F405 with the pins of `docs/controller.md`.
//!
//! Only its set-up is here and in `chip/board`; the work of each millisecond is the library's (`station.rs`), the same
//! code as in the emulator and on a host.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    eprintln!("this program is for the chip: build it with `cargo smartbed firmware --board=can`");
    std::process::ExitCode::FAILURE
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "registers are reached by address")]
#[path = "chip/bxcan.rs"]
mod bus;
#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "registers, and memory that is written by DMA, are reached by address")]
#[path = "chip/board.rs"]
mod chip;
