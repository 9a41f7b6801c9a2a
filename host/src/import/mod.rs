//! `smartbed import`: converts a robot in URDF to a model made of joints.
//!
//! In: the XML text. Out: the text of a model. `urdf` reads links and joints by `xml`, `tree` finds the kinematic tree and
//! merges links connected by fixed joints, `write` writes the model, `pose` has the arithmetic of rotations and
//! inertias.

mod name;
mod pose;
mod tree;
mod urdf;
mod write;
mod xml;

pub use write::{Base, Imported};

use crate::failure::Failure;
use crate::{input, output};

/// Convert a robot from URDF to a model file.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:
  cargo smartbed import robot.urdf -o robot.toml
  cargo smartbed import robot.urdf --base floating | less
  cargo smartbed import robot.urdf -o robot.toml --json

Links become bodies and joints entries of [joints]; a joint with one coordinate has an input
`tau_JOINT` as its drive. Links connected by fixed joints become one body; a mimic joint follows
its joint, and one whose limits coincide is fixed there. Notes list what is not converted (meshes,
transmissions, limits of speed and effort, friction), what is fixed and what is renamed.")]
pub struct Arguments {
    /// The robot: the path of a URDF file, or - for standard input.
    pub robot: String,
    /// File for the model [default: standard output].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<String>,
    /// How the root link may move.
    #[arg(long, value_enum, default_value_t)]
    pub base: Base,
    /// Print what was not converted, and the notes, as one JSON object; without --output the model stands in it.
    #[arg(long)]
    pub json: bool,
}

/// Converts a robot to a model.
///
/// # Errors
/// What is wrong with the text, and where.
pub fn import(path: &str, text: &str, base: Base) -> Result<Imported, Failure> {
    let wrong = |message: String| Failure::Wrong(format!("{path}: {message}"));
    let robot = urdf::read(text).map_err(wrong)?;
    let tree = tree::build(&robot).map_err(wrong)?;
    let imported = write::write(path, &robot, &tree, base);
    // The reader of models finds what a model cannot be, at its place in the text just written.
    smartbed_codegen::model::parse(&format!("the model made of {path}"), &imported.model)
        .map_err(|found| Failure::Found(Box::new(found)))?;
    Ok(imported)
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a robot that cannot be read or is invalid, and for a file that cannot be written.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { robot, output, base, json } = arguments;
    output::replace_none(&[("--output", output.as_deref())], &[robot])?;
    let text = input::text(robot).map_err(|e| Failure::Wrong(format!("cannot read {robot}: {e}")))?;
    let imported = import(robot, &text, *base)?;
    let file = output.as_deref().filter(|file| *file != "-");
    if *json {
        if let Some(file) = file {
            output::write(file, imported.model.as_bytes())?;
        }
        let model = file.is_none().then_some(&imported.model);
        let object = serde_json::json!({
            "file": file, "model": model, "not_converted": imported.left_out, "notes": imported.notes,
        });
        return output::print(&format!("{object}\n"));
    }
    for line in &imported.left_out {
        output::say(&format!("note: not converted: {line}"));
    }
    for line in &imported.notes {
        output::say(&format!("note: {line}"));
    }
    output::write(output.as_deref().unwrap_or("-"), imported.model.as_bytes())
}
