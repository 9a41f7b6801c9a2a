//! `smartbed new`: writes a commented example file that runs.

use crate::failure::Failure;
use crate::number::json_string;
use crate::output;
use smartbed_codegen::model::{RESERVED, is_keyword};
use std::path::Path;

const MECHANISM: &str = include_str!("mechanism.toml");
const SCENE: &str = include_str!("scene.toml");

/// Kinds of starting files.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Kind {
    /// A mechanism: rigid bodies, coordinates, loads.
    Mechanism,
    /// A scene: an elastic body that falls on the ground.
    Scene,
}

/// Write a commented starting file.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:
  cargo smartbed new mechanism press
  cargo smartbed new scene drop

Writes NAME.toml into the current folder. A file of that name is never overwritten.")]
pub struct Arguments {
    /// What the file describes.
    #[arg(value_enum)]
    pub kind: Kind,
    /// Name of the model: letters, digits and _, a letter first.
    pub name: String,
    /// Print the name of the file as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
///
/// # Errors
/// Status 1 for an invalid name and for a file that exists.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { kind, name, json } = arguments;
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) || !name.chars().all(is_letter) {
        let message = format!("`{name}`: expected a name of letters, digits and _, a letter first");
        return Err(Failure::Wrong(message));
    }
    if *kind == Kind::Mechanism && (RESERVED.contains(&name.as_str()) || is_keyword(name)) {
        return Err(Failure::Wrong(format!("`{name}` is a word of models or of Rust; take another name")));
    }
    let file = format!("{name}.toml");
    if Path::new(&file).exists() {
        return Err(Failure::Wrong(format!("{file} exists; take another name, or move it away")));
    }
    let text = match kind {
        Kind::Mechanism => MECHANISM,
        Kind::Scene => SCENE,
    };
    output::write(&file, text.replace("NAME", name).as_bytes())?;
    output::print(&if *json {
        format!("{{\"file\": {}}}\n", json_string(&file))
    } else {
        format!("{file}; look at it with `cargo smartbed view {file}`\n")
    })
}
