//! `smartbed settle`: the static equilibrium of a scene of format 2.

use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::model_argument;
use crate::number::{json_number, json_object, json_string, short};
use crate::output;
use crate::progress::Waiting;
use crate::world::read::settings::refuse_twice;
use crate::world::run::engine;
use std::fmt::Write as _;

/// Find the static equilibrium of a scene of format 2.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Example:
  cargo smartbed settle tile_with_bladder
  cargo smartbed settle tile_with_bladder --set parts.bladder.gas.gauge=2_kPa --json

To begin a run in this equilibrium, write `start = \"settled\"` under [run] of the scene.
Numbers are in SI units.")]
pub struct Arguments {
    /// The scene: a path, or a name under models/scenes.
    pub scene: String,
    /// Change a key of the scene; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Print the result as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong scene, and for one that does not come to rest.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let path = model_argument::find(&arguments.scene)?;
    FileKind::expect(&path, &[FileKind::World])?;
    refuse_twice(&arguments.set).map_err(Failure::Wrong)?;
    let assembly = model_argument::open_world_to_settle(&path, &arguments.set)?;
    let mut engine = engine(&assembly)?;
    let waiting = Waiting::settling();
    let settled = engine.settle().map_err(Failure::Wrong)?;
    drop(waiting);
    let columns = engine.columns();
    let state = engine.state().map_err(Failure::Wrong)?;
    let energies = engine.energies().map_err(Failure::Wrong)?;
    settled.note().iter().for_each(|note| output::say(note));
    if arguments.json {
        let last = json_object(columns.iter().map(|c| c.name.as_str()).zip(state));
        return output::print(&format!(
            "{{\"settled\": {}, \"steps\": {}, \"acceleration\": {}, \"unstable\": {}, \"total\": {}, \"last\": {last}}}\n",
            json_string(&assembly.title),
            settled.steps,
            json_number(settled.acceleration),
            settled.unstable.as_deref().map_or_else(|| "null".to_owned(), json_string),
            json_number(energies.total()),
        ));
    }
    let mut text = format!(
        "{}: {} after {} of relaxation, largest acceleration left {:.1e} m/s^2, energy {:.6e} J\n",
        assembly.title,
        if settled.unstable.is_none() { "at rest" } else { "in unstable equilibrium" },
        smartbed_codegen::words::count(settled.steps, "step"),
        settled.acceleration,
        energies.total()
    );
    let width = columns.iter().filter(|c| c.by_default).map(|c| c.name.len()).max().unwrap_or(0);
    for (column, value) in columns.iter().zip(&state).filter(|(column, _)| column.by_default) {
        let _ = writeln!(text, "  {:width$} {:>16} {}", column.name, short(*value), column.unit);
    }
    output::print(&text)
}
