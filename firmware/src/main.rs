//! Runs the demonstration and prints its digest: on the chip through semihosting, on the host to
//! standard output. The same library, so the same digest.
#![cfg_attr(target_os = "none", no_std, no_main)]

use smartbed_firmware::{STEPS, simulation::Simulation};

/// Runs all steps and hands the report to `write`; false if a step was refused.
fn demonstrate(mut write: impl FnMut(&[u8])) -> bool {
    match Simulation::new().map_err(|fault| (0, fault)).and_then(|mut tile| tile.run(STEPS)) {
        Ok(digest) => {
            write(b"digest ");
            write(&digest.hex());
            write(b"\n");
            true
        }
        Err(_) => {
            write(b"a step was refused\n");
            false
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    use std::io::Write;
    let mut text = Vec::new();
    let done = demonstrate(|bytes| text.extend_from_slice(bytes));
    let written = std::io::stdout().write_all(&text).is_ok();
    if done && written { std::process::ExitCode::SUCCESS } else { std::process::ExitCode::FAILURE }
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "cortex-m-rt asks for an unsafe handler: a hard fault may come anywhere")]
mod chip;
