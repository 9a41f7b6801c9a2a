//! The smartbed command: reads the command line and hands over to one module per subcommand.

use clap::{Parser, Subcommand};
use smartbed::firmware;
use std::process::ExitCode;

/// Derive, run, plot and measure mechanisms; build and emulate the firmware.
#[derive(Parser)]
#[command(name = "smartbed", bin_name = "cargo smartbed", version)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Generate, build for the microcontroller, check, and run in the emulator.
    Firmware(firmware::Arguments),
}

fn main() -> ExitCode {
    let done = match CommandLine::parse().command {
        Command::Firmware(arguments) => firmware::run(&arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::from(failure.status())
        }
    }
}
