//! The smartbed command: parses the command line and calls one module per subcommand.

use clap::{CommandFactory, Parser, Subcommand};
use smartbed::{
    bed, check, derive, equilibrium, eval, figure, firmware, import, manual, new, output, program, report,
    run, settle, sweep, tile, view,
};
use std::process::ExitCode;

#[cfg(target_os = "linux")]
mod closed_stdout;

/// Derive, run, plot and measure mechanisms; build and emulate the firmware.
#[derive(Parser)]
#[command(name = "smartbed", bin_name = "cargo smartbed", version, max_term_width = 100)]
struct CommandLine {
    /// When text has colours.
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value_t)]
    color: output::Colour,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write a commented starting file.
    New(new::Arguments),
    /// Make a model of a robot in URDF.
    Import(import::Arguments),
    /// Say what a model is: counts, degrees of freedom, rank, pivots, units, cost, warnings.
    Check(check::Arguments),
    /// Derive the equations of motion and write them as Rust.
    Derive(derive::Arguments),
    /// Evaluate the equations at given states.
    Eval(eval::Arguments),
    /// Find where it rests or moves steadily, with its modes there.
    Equilibrium(equilibrium::Arguments),
    /// Simulate, and write rows, plots or an animation.
    Run(run::Arguments),
    /// Find where a world of several parts rests.
    Settle(settle::Arguments),
    /// Show the motion in a page that follows the file.
    View(view::Arguments),
    /// Speed against error: tables, plots, one HTML page.
    Report(report::Arguments),
    /// Make a figure of the thesis.
    Figure(figure::Arguments),
    /// Generate, build for the microcontroller, check, and run in the emulator.
    Firmware(firmware::Arguments),
    /// Talk to tile controllers, in the emulator or on this machine.
    Tile(tile::Arguments),
    /// Run a plan of the bed, or make a page of it.
    Bed(bed::Arguments),
    /// Run a plan over all values of its [sweep].
    Sweep(sweep::Arguments),
    /// Print the completions of a shell.
    Completions(manual::Completions),
    /// Write man pages.
    Man(manual::Man),
}

fn main() -> ExitCode {
    program::begin();
    let command_line = match CommandLine::try_parse() {
        Ok(command_line) => command_line,
        Err(message) => return program::refuse(&message),
    };
    output::choose_colour(command_line.color);
    program::end(match command_line.command {
        Command::New(arguments) => new::run(&arguments),
        Command::Import(arguments) => import::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Derive(arguments) => derive::run(&arguments),
        Command::Eval(arguments) => eval::run(&arguments),
        Command::Equilibrium(arguments) => equilibrium::run(&arguments),
        Command::Run(arguments) => run::run(&arguments),
        Command::Settle(arguments) => settle::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Figure(arguments) => figure::run(&arguments),
        Command::Firmware(arguments) => firmware::run(&arguments),
        Command::Tile(arguments) => tile::run(&arguments),
        Command::Bed(arguments) => bed::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Completions(arguments) => manual::completions(&arguments, CommandLine::command()),
        Command::Man(arguments) => manual::man(&arguments, CommandLine::command()),
    })
}
