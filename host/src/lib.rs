//! What the `smartbed` command does, one module per subcommand.
//!
//! Each module has `Arguments` (what stands on its command line) and `run`, which prints the
//! answer to standard output, progress to standard error, and returns a [`failure::Failure`] with
//! the exit status.

pub mod failure;
pub mod firmware;
pub mod scene;
