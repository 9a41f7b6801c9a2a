//! The library of the `smartbed` command, one module per subcommand.
//!
//! Each of these modules has `Arguments` (its command line) and `run`, which prints results to standard output and
//! progress to standard error, and returns a [`failure::Failure`] with the exit status.
//!
//! Without the feature `whole` the library only runs and shows mechanisms, as far as [`light`] says; this smaller
//! program is what the first command builds.

// Printing macros would panic on a closed or full stream: all text goes through `output`.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod csv;
pub mod diagnostics;
pub mod failure;
pub mod file_kind;
pub mod grouped;

#[cfg(feature = "whole")]
mod hash;
pub mod input;
#[cfg(feature = "whole")]
pub mod install;
pub mod interrupt;
#[cfg(feature = "whole")]
pub mod json;
pub mod number;
pub mod output;
pub mod program;
pub mod progress;
pub mod suggest;
#[cfg(feature = "whole")]
pub mod unpack;

#[cfg(feature = "whole")]
pub mod answers;
pub mod chatter;
pub mod columns;
pub mod configuration;
pub mod contact_force;
#[cfg(feature = "whole")]
pub mod crate_folder;
pub mod engine;
pub mod jumps;
pub mod light;
pub mod limits;
pub mod model_argument;
pub mod observers;
pub mod switches;
mod terms;
pub mod timed;

pub mod plot;
pub mod view;

#[cfg(feature = "whole")]
pub mod bed;
#[cfg(feature = "whole")]
pub mod check;
#[cfg(feature = "whole")]
pub mod derive;
#[cfg(feature = "whole")]
pub mod equilibrium;
#[cfg(feature = "whole")]
pub mod eval;
#[cfg(feature = "whole")]
pub mod figure;
#[cfg(feature = "whole")]
pub mod firmware;
#[cfg(feature = "whole")]
pub mod import;
#[cfg(feature = "whole")]
pub mod manual;
pub mod new;
#[cfg(feature = "whole")]
pub mod origin;
#[cfg(feature = "whole")]
pub mod plan;
#[cfg(feature = "whole")]
pub mod plan_file;
mod reads;
#[cfg(feature = "whole")]
pub mod report;
pub mod run;
#[cfg(feature = "whole")]
pub mod scene;
#[cfg(feature = "whole")]
pub mod settle;
#[cfg(feature = "whole")]
pub mod sweep;
#[cfg(feature = "whole")]
pub mod template;
#[cfg(feature = "whole")]
pub mod tile;
#[cfg(feature = "whole")]
pub mod world;
