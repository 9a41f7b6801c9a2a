//! The light program, which `cargo smartbed` builds first: starts, runs and shows mechanisms, and hands all other
//! commands to the whole program.

use clap::{Parser, Subcommand};
use smartbed::failure::Failure;
use smartbed::{light, new, output, program, run, view};
use std::env;
use std::path::Path;
use std::process::{Command as Process, ExitCode};

#[cfg(target_os = "linux")]
#[path = "../closed_stdout.rs"]
mod closed_stdout;

/// Derive, run, plot and measure mechanisms; build and emulate the firmware.
#[derive(Parser)]
#[command(name = "smartbed", bin_name = "cargo smartbed", version, max_term_width = 100)]
struct CommandLine {
    /// When to colour messages.
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value_t)]
    color: output::Colour,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write a commented starting file.
    New(new::Arguments),
    /// Simulate a mechanism or a scene; write rows, plots or an animation.
    Run(Box<run::Arguments>),
    /// Show the motion in a browser; the page is updated whenever the file changes.
    View(view::Arguments),
}

fn main() -> ExitCode {
    program::begin();
    // Help and errors of its own commands are printed at once; those of other commands by the program that has them.
    let is_known = env::args().nth(1).is_some_and(|word| ["new", "run", "view"].contains(&word.as_str()));
    let command_line = match CommandLine::try_parse() {
        Ok(command_line) => command_line,
        Err(message) if is_known => return program::refuse(&message),
        Err(_) => return whole(),
    };
    output::choose_colour(command_line.color);
    match command_line.command {
        Command::New(arguments) => program::end(new::run(&arguments)),
        Command::Run(arguments) if light::runs(&arguments) => program::end(run::run(&arguments)),
        Command::View(arguments) if light::shows(&arguments) => program::end(view::run(&arguments)),
        Command::Run(_) | Command::View(_) => whole(),
    }
}

/// Builds the whole program, if necessary, and runs the command in it.
fn whole() -> ExitCode {
    let name = format!("smartbed{}", env::consts::EXE_SUFFIX);
    let is_built = env::current_exe().is_ok_and(|light| light.with_file_name(name).is_file());
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let folder = env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    let mut process = Process::new(cargo);
    process.args(["run", "--release", "--bin", "smartbed", "--manifest-path"]);
    process.arg(Path::new(&folder).join("Cargo.toml"));
    if is_built {
        process.arg("--quiet");
    } else {
        output::say("note: this needs the whole program, which is built now, once; it takes a few minutes");
    }
    process.arg("--").args(env::args_os().skip(1));
    match become_it(&mut process) {
        Ok(status) => ExitCode::from(status),
        Err(e) => {
            program::end(Err(Failure::Lacking(format!("the whole program could not be built: cargo: {e}"))))
        }
    }
}

/// On Unix replaces this process by the other one, so that signals reach it; returns only if that fails.
#[cfg(unix)]
fn become_it(process: &mut Process) -> std::io::Result<u8> {
    use std::os::unix::process::CommandExt;
    Err(process.exec())
}

#[cfg(not(unix))]
fn become_it(process: &mut Process) -> std::io::Result<u8> {
    let code = process.status()?.code();
    Ok(code.and_then(|code| u8::try_from(code).ok()).unwrap_or(1))
}
