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
    /// Convert a robot from URDF to a model file.
    Import(import::Arguments),
    /// Analyse a model without running it: counts, degrees of freedom, rank, pivots, units, cost, warnings.
    Check(check::Arguments),
    /// Derive a model's equations of motion and write them as Rust source code.
    Derive(derive::Arguments),
    /// Evaluate a model's equations of motion at given states.
    Eval(eval::Arguments),
    /// Find a static equilibrium or a steady motion of a mechanism, and the modes of small motions about it.
    Equilibrium(equilibrium::Arguments),
    /// Simulate a mechanism or a scene; write rows, plots or an animation.
    Run(run::Arguments),
    /// Find the static equilibrium of a scene of format 2.
    Settle(settle::Arguments),
    /// Show the motion in a browser; the page is updated whenever the file changes.
    View(view::Arguments),
    /// Measure computing time against error of all methods: tables, plots, one HTML page.
    Report(report::Arguments),
    /// Draw a figure of the thesis anew.
    Figure(figure::Arguments),
    /// Build the program of a model or scene for the microcontroller, check it, and run it in the emulator.
    Firmware(firmware::Arguments),
    /// Send orders to tile controllers that run in the emulator or on this machine.
    Tile(tile::Arguments),
    /// Run a plan of the bed, write a page of it, or evaluate recorded pressure maps.
    Bed(bed::Arguments),
    /// Run a plan of the bed for every combination of the values in its `[sweep]`.
    Sweep(sweep::Arguments),
    /// Print a script that completes this command line in a shell.
    Completions(manual::Completions),
    /// Write man pages of all commands into a folder.
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
