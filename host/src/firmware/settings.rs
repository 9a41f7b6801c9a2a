//! What an image is built from: a model, a scene or a world with its changes, or a program of the controller.
//!
//! In: the command line. Out: [`Settings`], which the firmware's build script gets through environment variables; what
//! a file of this kind cannot be built with is refused here, before anything is compiled.

use super::arguments::{Arguments, Bus};
use super::fit::{Fitted, nanoseconds};
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::limits::check_numbers;
use crate::scene::read::Scene;
use crate::scene::rest::Found;
use crate::scene::{self, Simulation, tables, walk};
use crate::timed;
use smartbed_runtime::ode::nodes::Step;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The image's function for one evaluation of the rates.
pub const RATES: &str = "tile_rates";
/// The image's function for a sine and cosine, not inlined.
pub const SIN_COS: &str = "tile_sin_cos";

/// A scene with fewer nodes loses less than 3 % of its speed if it is optimised for size.
const FEW_NODES: usize = 16;
/// Default number of steps.
const STEPS: u32 = 10_000;
/// Step of the demonstration (ns).
const STEP: u64 = 1_000_000;

/// Settings of a build.
#[derive(Clone, PartialEq, Debug)]
pub struct Settings {
    /// Path of the model.
    pub model: PathBuf,
    /// Number of steps.
    pub steps: u32,
    /// Length of each (ns).
    pub step: u64,
    /// Changed parameters, `name=value`.
    pub set: Vec<String>,
    /// A defect that the checks have to find.
    pub inject: Option<String>,
    /// Every parameter of a mechanism tunable, every answer in every step.
    pub everything: bool,
    /// Optimised for size.
    pub small: bool,
    /// The firmware's program to build.
    pub subject: Subject,
}

/// The programs of the firmware.
#[derive(Clone, PartialEq, Debug)]
pub enum Subject {
    /// A mechanism with its demonstration.
    Mechanism,
    /// A scene, as constant tables in Rust.
    Scene(String),
    /// A scene that is a sheet, stepped row by row, as constant tables in Rust.
    Sheet(String),
    /// A scene that is a sheet, in its equilibrium at each pressure, as constant tables in Rust.
    Rest(Box<Found>, String),
    /// A world, as tables and equations in Rust.
    World(Box<Fitted>),
    /// The controller with a simulated tile.
    Loop,
    /// The controller on the pins of a real chip, with this bus.
    Board(Bus),
    /// The controller without a board, to be measured.
    Bare,
}

impl Settings {
    /// Checks the command line.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if there is no such model or a change is not `name=number`.
    pub fn new(workspace: &Path, arguments: &Arguments) -> Result<Self, Failure> {
        let model = find_model(workspace, arguments.model.as_deref().unwrap_or("tile"))?;
        let kind = FileKind::of(&model);
        if (arguments.by_rows || arguments.at_rest) && kind != FileKind::Body {
            let why = "--by-rows, --at-rest: they are for a sheet of a scene of format 1; leave them out";
            return Err(Failure::Wrong(why.to_owned()));
        }
        let mut has_few_nodes = false;
        let (subject, steps, step) = if kind == FileKind::World {
            let world = Fitted::new(&model, &arguments.set, arguments.steps)?;
            let (steps, step) = (world.steps, world.step);
            (Subject::World(Box::new(world)), steps, step)
        } else if kind == FileKind::Body {
            let scene = open_scene(&model, &arguments.set)?;
            has_few_nodes = scene.lists.points.len() < FEW_NODES;
            print_scene(&model, &scene, arguments)?
        } else {
            check_changes(&arguments.set)?;
            kind.among(&[FileKind::Model], &model)?;
            check_names(&model, &arguments.set)?;
            check_commands(&model)?;
            (Subject::Mechanism, STEPS, STEP)
        };
        let steps = arguments.steps.unwrap_or(steps);
        if arguments.everything && subject != Subject::Mechanism {
            let why = "--everything: it is for mechanisms; the image of a scene leaves no parameters or answers out";
            return Err(Failure::Wrong(format!("{why}; leave it out")));
        }
        let (set, inject) = (arguments.set.clone(), arguments.inject.clone());
        let small = arguments.small || (has_few_nodes && !arguments.fast);
        let everything = arguments.everything;
        Ok(Self { model, steps, step, set, inject, everything, small, subject })
    }

    /// Settings for a program of the controller.
    #[must_use]
    pub fn controller(subject: Subject) -> Self {
        Self {
            model: PathBuf::new(),
            steps: STEPS,
            step: STEP,
            set: Vec::new(),
            inject: None,
            everything: false,
            small: false,
            subject,
        }
    }

    /// Says what of a mechanism the image does otherwise than a run: laws that switch at a time, inputs that nothing
    /// commands.
    pub fn note_what_differs(&self) {
        let model =
            smartbed_codegen::model::read(&self.model).ok().filter(|_| self.subject == Subject::Mechanism);
        let Some(model) = model else { return };
        if timed::may_switch(&model) {
            crate::output::say(
                "warning: a law or load has abs, sign, min or max of the time: `run` ends a step where it switches, the chip                  cuts none: what is shorter than a step may be missed, and errors are of order 1 there",
            );
        }
        // The controller's demonstration commands a tile whose model has no law.
        let is_tile = model.laws.is_empty()
            && ["FA", "FB", "FC"].iter().all(|leg| model.inputs.iter().any(|input| input.name == *leg));
        let has_law = |id| model.laws.iter().any(|(input, _)| *input == id);
        let idle: Vec<&str> = (model.inputs.enumerate())
            .filter(|(id, _)| !has_law(*id) && !is_tile)
            .map(|(_, input)| input.name.as_str())
            .collect();
        if !idle.is_empty() {
            crate::output::say(&format!(
                "note: nothing commands {} of `{}`: they stay 0; a [law] in the model would command them",
                idle.join(", "),
                model.name
            ));
        }
    }

    /// Fits a world again, to the RAM that its image was found to take, stack and static data (bytes); true if the
    /// world changed.
    ///
    /// # Errors
    /// As [`Fitted::new`].
    pub fn refit(&mut self, taken: u64) -> Result<bool, Failure> {
        let Subject::World(world) = &self.subject else { return Ok(false) };
        let better = world.again(&self.model, &self.set, usize::try_from(taken).unwrap_or(usize::MAX))?;
        let is_better = better.is_some();
        if let Some(better) = better {
            self.subject = Subject::World(Box::new(better));
        }
        Ok(is_better)
    }

    /// Name of the program to build.
    pub(super) fn program(&self) -> &'static str {
        match self.subject {
            Subject::Mechanism => "tile",
            Subject::Scene(_) => "scene",
            Subject::Sheet(_) => "sheet",
            Subject::Rest(..) => "rest",
            Subject::World(_) => "world",
            Subject::Loop => "loop",
            Subject::Board(Bus::Serial) => "board",
            Subject::Board(Bus::Can) => "board-can",
            Subject::Bare => "bare",
        }
    }

    /// Feature of the firmware that the program needs.
    fn feature(&self) -> &'static str {
        match self.subject {
            Subject::Mechanism if self.everything => "everything",
            Subject::Mechanism => "model",
            Subject::Scene(_) | Subject::Sheet(_) | Subject::Rest(..) => "scene",
            Subject::World(_) => "world",
            Subject::Loop => "plant",
            Subject::Board(_) => "board",
            Subject::Bare => "controller",
        }
    }

    /// The scene of the image, in Rust.
    fn tables(&self) -> Option<&str> {
        match &self.subject {
            Subject::Scene(tables) | Subject::Sheet(tables) | Subject::Rest(_, tables) => Some(tables),
            Subject::World(world) => Some(&world.tables),
            _ => None,
        }
    }

    /// Functions of the image whose calls are counted: the step; for a mechanism also its rates, and a sine and cosine
    /// if the controller calls one.
    #[must_use]
    pub fn counted(&self) -> (&'static str, &'static [&'static str]) {
        match self.subject {
            Subject::Scene(_) => ("scene_step", &[]),
            Subject::Sheet(_) => ("sheet_step", &[]),
            Subject::Rest(..) => ("rest_step", &[]),
            Subject::World(_) => ("world_step", &[]),
            _ => ("tile_step", &[RATES, SIN_COS]),
        }
    }

    /// Passes the settings to the firmware's build script; tables through a file in `folder`.
    pub(super) fn export(&self, command: &mut Command, folder: &Path) -> Result<(), Failure> {
        command.env("SMARTBED_STEPS", self.steps.to_string());
        command.env("SMARTBED_INJECT", self.inject.as_deref().unwrap_or(""));
        command.args(["--features", self.feature()]);
        if self.subject == Subject::Mechanism {
            command.env("SMARTBED_MODEL", &self.model).env("SMARTBED_SET", self.set.join(";"));
            return Ok(());
        }
        command.env_remove("SMARTBED_MODEL").env_remove("SMARTBED_SET");
        if let Some(tables) = self.tables() {
            let file = folder.join("scene.rs");
            std::fs::write(&file, tables).map_err(|e| Failure::Wrong(format!("{}: {e}", file.display())))?;
            command.env("SMARTBED_SCENE", file);
        }
        Ok(())
    }
}

/// Refuses changes that are not `name=number`.
fn check_changes(set: &[String]) -> Result<(), Failure> {
    for change in set {
        let number = change.split_once('=').map(|(name, value)| (name, value.parse::<f64>()));
        if !matches!(number, Some((name, Ok(value))) if !name.is_empty() && value.is_finite()) {
            return Err(Failure::Wrong(format!(
                "--set {change}: expected NAME=NUMBER, for example --set M=8"
            )));
        }
    }
    Ok(())
}

fn open_scene(path: &Path, set: &[String]) -> Result<Scene, Failure> {
    let scene = scene::open(&path.display().to_string(), set).map_err(Failure::Wrong)?;
    scene.warnings.iter().for_each(|warning| crate::output::say(&format!("warning: {warning}")));
    Ok(scene)
}

/// A scene's constant tables, its number of steps and the step.
fn print_scene(path: &Path, scene: &Scene, arguments: &Arguments) -> Result<(Subject, u32, u64), Failure> {
    let named = |why: String| Failure::Wrong(format!("{}: {why}", path.display()));
    if scene.method.control_order() > 0 {
        let why =
            "the chip takes steps of fixed length: choose another method, for example --set method=verlet";
        return Err(named(why.to_owned()));
    }
    if arguments.at_rest {
        let found = Found::new(scene).map_err(|why| named(format!("--at-rest: {why}")))?;
        let (step, ticks) = (STEP as f64 * 1e-9, scene.seconds * 1e9 / STEP as f64);
        let tables = found.rust(step, scene.seconds);
        return Ok((Subject::Rest(Box::new(found), tables), ticks.round() as u32, STEP));
    }
    let subject = if arguments.by_rows {
        let tables = walk::rust(&scene.lists, &scene.around, scene.method, scene.step);
        Subject::Sheet(tables.map_err(|why| named(format!("--by-rows: {why}")))?)
    } else {
        if walk::read::<f32>(&scene.lists, &scene.around, scene.method).is_ok() {
            crate::output::say(
                "note: --by-rows steps this sheet with a tenth of the instructions, dampers explicitly",
            );
        }
        let simulation = Simulation::<f32>::new(&scene.lists, &scene.around, scene.method)
            .map_err(|e| named(scene::describe::describe(&e)))?;
        Subject::Scene(tables::rust(&simulation, scene.step as f32))
    };
    // The chip's steps have one length: a last one that is shorter is left out, as with worlds.
    let steps = scene.steps() - usize::from(scene.seconds > 0.0 && scene.last_step() != scene.step);
    Ok((subject, u32::try_from(steps).unwrap_or(u32::MAX), nanoseconds(scene.step)))
}

/// Refuses commands at whose kinks a step would have to be cut, as those of worlds on the chip are.
fn check_commands(model: &Path) -> Result<(), Failure> {
    let leaps = smartbed_codegen::model::read(model).is_ok_and(|model| timed::may_leap(&model));
    if !leaps {
        return Ok(());
    }
    Err(Failure::Wrong(
        "a command (a closed_form, a position, a constraint) with abs, sign, min or max of the time may change its speed at \
         once, where the chip cuts no step; write a smooth one, for example with smooth_step"
            .to_owned(),
    ))
}

/// Reads the model first, so that its errors are reported first, and looks up the names of the changes.
fn check_names(path: &Path, set: &[String]) -> Result<(), Failure> {
    let model =
        smartbed_codegen::model::read(path).map_err(|errors| crate::model_argument::wrong(&errors))?;
    let names: Vec<&str> = model.parameters.iter().map(|p| p.name.as_str()).collect();
    let values = set.iter().filter_map(|change| change.split_once('='));
    let values = values.filter_map(|(name, value)| Some((name, value.parse().ok()?)));
    check_numbers::<f32>(values.clone()).map_err(|why| Failure::Wrong(format!("--set: {why}")))?;
    if let Some(message) = values.clone().find_map(|(name, value)| model.refuses(name, value)) {
        return Err(Failure::Wrong(format!("--set: {message}")));
    }
    match set.iter().find(|change| !names.contains(&change.split('=').next().unwrap_or_default())) {
        Some(change) => Err(Failure::Wrong(format!(
            "--set {change}: {} has no such parameter; expected one of {}",
            model.name,
            names.join(", ")
        ))),
        None => Ok(()),
    }
}

/// A path, or a name under models/.
fn find_model(workspace: &Path, model: &str) -> Result<PathBuf, Failure> {
    let named = ["models", "models/scenes", "models/chip"]
        .map(|f| workspace.join(f).join(model).with_extension("toml"));
    let given = Path::new(model);
    if given.is_file() {
        fs::canonicalize(given).map_err(|e| Failure::Wrong(format!("{model}: {e}")))
    } else {
        let why = format!("no model `{model}`: expected a file, or the name of one under models/");
        named.into_iter().find(|path| path.is_file()).ok_or(Failure::Wrong(why))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(set: &str) -> Result<Settings, Failure> {
        let arguments =
            Arguments { set: vec![set.to_owned()], model: Some("/dev/null/x".into()), ..Default::default() };
        Settings::new(Path::new("."), &arguments)
    }

    #[test]
    fn a_change_must_be_a_number() {
        for wrong in ["M", "M=", "=3", "M=heavy", "M=nan"] {
            let failure = check_changes(&[wrong.to_owned()]).unwrap_err();
            assert!(failure.to_string().contains("NAME=NUMBER"), "{wrong}");
        }
    }

    #[test]
    fn a_model_must_exist() {
        let failure = settings("M=3").unwrap_err();
        assert_eq!(failure.status(), 1);
        assert!(failure.to_string().contains("no model `/dev/null/x`"));
    }
}
