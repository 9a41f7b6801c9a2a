//! `smartbed equilibrium`: static equilibria and steady motions of a mechanism, and its small motions about them.
//!
//! In: a model, what is held, where the search starts. Out: coordinates and speeds at which all accelerations vanish
//! (`search`, from several starts if need be: `restart`), and eigenvalues and mode shapes of the linearised motion
//! (`modes`), as text or JSON. Control laws are substituted into the equations
//! ([`smartbed_codegen::model::Model::closed_loop`]) before these are derived.

mod balance;
mod jumps;
mod modes;
mod rates;
mod reasons;
mod restart;
mod search;
mod shapes;
mod spectrum;
mod text;

use crate::engine::{self, EngineKind};
use crate::failure::Failure;
use crate::progress::Waiting;
use crate::run::settings::Settings;
use crate::{model_argument, output, run, suggest};
use search::{Search, Unknown};
use smartbed_codegen::diagnostic::Diagnostics;
use smartbed_codegen::{Asked, Function, Program, Request, program};

/// Find a static equilibrium or a steady motion of a mechanism, and the modes of small motions about it.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Examples:
  cargo smartbed equilibrium pendulum3
  cargo smartbed equilibrium cart_pole                    # with the model's law: the closed loop
  cargo smartbed equilibrium bicycle --hold u_thR=-16.67  # steady motion, rear wheel at this speed
  cargo smartbed equilibrium tile --trim                  # the inputs that hold it where it starts

The search starts at the model's [start], changed by --set. Without --hold and --trim all speeds are 0.
Inputs with a law in the model follow it; others are 0, or as --input says. SI units.
In a steady motion every coordinate that the equations depend on is constant; others, such as the
heading of a bicycle, may change.")]
pub struct Arguments {
    /// The model: a path, or a name under models/.
    pub model: String,
    /// Change a parameter, or the value of a coordinate or speed at which the search starts; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Keep an independent coordinate or speed at this value. With a speed other than 0 a steady motion is searched
    /// for. May be repeated. Not with --trim.
    #[arg(long, value_name = "NAME=VALUE")]
    pub hold: Vec<String>,
    /// Keep an input at this value; inputs with a law in the model are refused. May be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub input: Vec<String>,
    /// Keep coordinates and speeds as they start, and search for the inputs with which nothing accelerates; with speeds
    /// other than 0 a steady motion. Not with --hold.
    #[arg(long, conflicts_with = "hold")]
    pub trim: bool,
    /// Print the result as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong model, for a driven one, and if no equilibrium is found.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let written = model_argument::read(&arguments.model)?;
    let model = &written.closed_loop();
    let asked = run::Arguments {
        model: arguments.model.clone(),
        set: arguments.set.clone(),
        ..run::Arguments::default()
    };
    let (model, settings) = Settings::new(model, &asked)?;
    let model = &*model;
    let (watched, [jumps, kinks]) = jumps::watched(model);
    let waiting = Waiting::deriving();
    let mut requests = vec![Request::new("linearisation")];
    if !model.laws.is_empty() {
        requests.push(Request::new("law"));
    }
    let function = Function { name: "near".to_owned(), requests };
    let requests = ["mass_matrix", "forcing"].map(Request::new).to_vec();
    let forces = Function { name: "forces".to_owned(), requests };
    let asked = Asked::besides(vec![function, forces]);
    let program = program::derive_asked(&watched, &settings.choice, program::Settings::default(), &asked)
        .map_err(|e| model_argument::wrong(&e))?;
    drop(waiting);
    let mut told = Told::default();
    told.findings(&program.warnings);
    if model.is_moved_by_time() {
        return Err(Failure::Wrong(format!(
            "{}: a mechanism with prescribed motion has no equilibrium; give the prescribed coordinates constant \
             values",
            arguments.model
        )));
    }
    if let Some(load) = model.load_of_time() {
        let what = "changes with time: what balances at t = 0 does not stay in balance";
        told.warning(format!("`{}` {what}", load.name));
    }
    let start = run::start::start(model, &program, &settings)?;
    let mut search = Search::new(model, &program, engine::new(EngineKind::Interpreter, &program)?, &start);
    hold(arguments, &program, &mut search)?;
    let found = search.find().map_err(|why| Failure::Wrong(format!("{}: {why}", arguments.model)))?;
    told.findings(&jumps::warnings(model, &jumps, &mut search));
    let kinks = jumps::kinks(model, &kinks, &mut search);
    told.findings(&kinks);
    if let Some(outside) = search.outside() {
        told.warning(outside);
    }
    let modes = modes::of(&found.slopes, &found.errors, &search.state_names())
        .ok_or_else(|| Failure::Wrong("the eigenvalues were not found in 10,000 sweeps".to_owned()))?;
    let is_smooth = kinks.items.is_empty();
    let answer =
        text::Answer { model, program: &program, search: &search, found: &found, modes: &modes, is_smooth };
    output::print(&if arguments.json { answer.json(&told.warnings) } else { answer.text() })
}

/// Warnings as they are told: on standard error at once, and in the result for programs.
#[derive(Default)]
struct Told {
    warnings: Vec<String>,
}

impl Told {
    fn findings(&mut self, found: &Diagnostics) {
        model_argument::print_findings(found);
        self.warnings.extend(found.items.iter().map(|w| w.message.clone()));
    }

    fn warning(&mut self, message: String) {
        output::say(&format!("warning: {message}"));
        self.warnings.push(message);
    }
}

/// Applies what the command line holds, and chooses the unknowns.
fn hold(arguments: &Arguments, program: &Program, search: &mut Search) -> Result<(), Failure> {
    refuse_twice("--input", &arguments.input)?;
    refuse_twice("--hold", &arguments.hold)?;
    for given in &arguments.input {
        let (name, value) = model_argument::assignment("--input", given)?;
        let names = program.inputs.iter().map(|i| i.name.as_str());
        let Some(place) = program.inputs.iter().position(|i| i.name == name) else {
            return Err(unknown("--input", given, "an input of the model", &name, names));
        };
        if !search.is_free_input(place) {
            return Err(Failure::Wrong(format!(
                "--input {given}: `{name}` follows its law; leave one of them out"
            )));
        }
        search.hold_input(place, value);
    }
    for given in &arguments.hold {
        let (name, value) = model_argument::assignment("--hold", given)?;
        if !search.hold(&name, value) {
            let names = search.state_names();
            let names = names.iter().map(String::as_str);
            return Err(unknown("--hold", given, "an independent coordinate or speed", &name, names));
        }
    }
    search.look_for(if arguments.trim { Unknown::Inputs } else { Unknown::State });
    Ok(())
}

/// Refuses an option that names the same thing twice: the first would have no effect.
fn refuse_twice(option: &str, all: &[String]) -> Result<(), Failure> {
    let mut names: Vec<String> = Vec::new();
    for given in all {
        let (name, _) = model_argument::assignment(option, given)?;
        if names.contains(&name) {
            let what = format!("{option} {given}: `{name}` is given twice; leave one of them out");
            return Err(Failure::Wrong(what));
        }
        names.push(name);
    }
    Ok(())
}

fn unknown<'a>(
    option: &str,
    given: &str,
    expected: &str,
    name: &str,
    known: impl Iterator<Item = &'a str>,
) -> Failure {
    Failure::Wrong(format!("{option} {given}: `{name}` is not {expected}{}", suggest::help(name, known)))
}
