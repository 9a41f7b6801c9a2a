//! What the `smartbed` command does, one module per subcommand.
//!
//! Each module has `Arguments` (what stands on its command line) and `run`, which prints the
//! answer to standard output, progress to standard error, and returns a [`failure::Failure`] with
//! the exit status.

// A closed standard error or a full standard output is no panic: everything goes through `output`.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod diagnostics;
pub mod failure;
pub mod grouped;

pub mod input;
pub mod install;
pub mod interrupt;
pub mod json;
pub mod number;
pub mod output;
pub mod progress;
pub mod suggest;
pub mod unpack;

pub mod answers;
pub mod configuration;
pub mod crate_folder;
pub mod engine;
pub mod limits;
pub mod model_argument;
pub mod observers;
pub mod speeds;

pub mod plot;
pub mod view;

pub mod check;
pub mod derive;
pub mod equilibrium;
pub mod eval;
pub mod figure;
pub mod firmware;
pub mod manual;
pub mod new;
pub mod report;
pub mod run;
pub mod scene;
pub mod settle;
pub mod tile;
pub mod world;
