//! `smartbed completions` and `smartbed man`: what the command line says of itself, for shells and for `man`.

use crate::failure::Failure;
use crate::output;
use clap::Command;
use clap_complete::Shell;

/// Print a script that completes this command line in a shell.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:
  smartbed completions bash > ~/.local/share/bash-completion/completions/smartbed
  smartbed completions fish > ~/.config/fish/completions/smartbed.fish")]
pub struct Completions {
    /// Shell that the script is for.
    #[arg(value_enum)]
    pub shell: Shell,
}

/// Write a man page for the command and each of its sub-commands.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Example:
  smartbed man ~/.local/share/man/man1 && man smartbed-run")]
pub struct Man {
    /// Folder for the pages; it is made if it does not exist.
    pub folder: String,
}

/// The program as it is called once installed.
fn named(command: Command) -> Command {
    command.name("smartbed").bin_name("smartbed")
}

/// Prints the completions.
///
/// # Errors
/// None.
pub fn completions(arguments: &Completions, command: Command) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut named(command), "smartbed", &mut text);
    output::write("-", &text)
}

/// Writes the pages.
///
/// # Errors
/// [`Failure::Wrong`] if the folder cannot be written.
pub fn man(arguments: &Man, command: Command) -> Result<(), Failure> {
    let wrong = |e: std::io::Error| Failure::Wrong(format!("cannot write to {}: {e}", arguments.folder));
    std::fs::create_dir_all(&arguments.folder).map_err(wrong)?;
    clap_mangen::generate_to(named(command), &arguments.folder).map_err(wrong)
}
