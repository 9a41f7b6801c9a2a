//! `smartbed derive`: the equations of motion as Rust, one file or a self-contained crate.

mod costs;

use crate::engine::crate_text;
use crate::failure::Failure;
use crate::progress::Waiting;
use crate::{answers, crate_folder, limits, model_argument, output};
use clap::ValueEnum;
use smartbed_codegen::model::Model;
use smartbed_codegen::program::answer::{About, CATALOGUE, Needs, find};
use smartbed_codegen::words::count;
use smartbed_codegen::{
    Asked, Core, Effort, EmitOptions, Function, Optimise, ParameterChoice, Program, Request, ScalarType,
    Settings, program, rust,
};
use std::collections::BTreeMap;
use std::path::Path;

/// Derive a model's equations of motion and write them as `no_std` Rust.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = examples())]
pub struct Arguments {
    /// The model: a path, or a name under models/.
    pub model: String,
    /// File for the Rust code; - is standard output.
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub output: String,
    /// Write a crate into this folder instead of one file. The crate does not depend on this project. Files in the
    /// folder that this command did not write, or that were changed since, are never overwritten. Not together with
    /// --output.
    #[arg(long = "crate", value_name = "DIR", conflicts_with = "output")]
    pub folder: Option<String>,
    /// Add the integration methods to the crate, so that it can step the mechanism in time. Only with --crate and
    /// --form reduced, and not with --answers.
    #[arg(long, requires = "folder", conflicts_with = "answers")]
    pub integrator: bool,
    /// Number type of the code.
    #[arg(long, value_enum, default_value_t)]
    pub scalar: EmittedScalar,
    /// Form of the equations.
    #[arg(long, value_enum, default_value_t)]
    pub form: Form,
    /// How much work goes into reducing the number of operations; `all` takes about ten times as long as
    /// `default`.
    #[arg(long, value_enum, default_value_t)]
    pub effort: EffortChoice,
    /// What to minimise when several forms of the equations give the same accelerations.
    #[arg(long, value_enum, default_value_t)]
    pub optimise: OptimiseFor,
    /// Processor that the order of statements is chosen for [default: `host` for f64, else the order for
    /// microcontrollers]. The results are the same to the bit.
    #[arg(long, value_enum)]
    pub core: Option<CoreChoice>,
    /// Write only these answers (listed below), without the struct that connects them to the runtime. The answers
    /// of one option become one function, which computes common parts once: [NAME=]ANSWER,ANSWER... May be
    /// repeated; each option gives one more function.
    #[arg(long, value_parser = crate::answers::entry, value_name = "LIST")]
    pub answers: Vec<String>,
    /// Keep these `fixed` parameters changeable in the code, as fields of its `Parameters`; by default their values
    /// are inserted into the equations.
    #[arg(long, value_delimiter = ',', value_name = "NAME")]
    pub keep: Vec<String>,
    /// Change the value of a parameter: the default of a tunable one, the inserted value of a fixed one. May be
    /// repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Also write the functions `begin_step` and `rates_near`, with which the evaluations of one Runge-Kutta step
    /// share sines, cosines and an elimination (`ode::rk4_shared` of the runtime). Only with --form reduced; not
    /// together with --answers, --crate or --costs.
    #[arg(long, conflicts_with_all = ["answers", "folder", "costs"])]
    pub shared_work: bool,
    /// Print the cost that each answer adds, instead of code: operations and values alive at once, in f32 and in
    /// the order for a Cortex-M4 unless --core is given; also bytes of code and stack, and instructions, on a
    /// Cortex-M4F, if its toolchain is installed. Not together with --output, --crate or --scalar.
    #[arg(long, conflicts_with_all = ["output", "folder", "scalar"])]
    pub costs: bool,
    /// Print one JSON object: file and operations, or with --costs the table.
    #[arg(long)]
    pub json: bool,
}

/// Examples, and the answers of the generator's own list.
fn examples() -> String {
    let named = |wanted: fn(About) -> bool, behind: &str| -> String {
        let kinds = CATALOGUE.iter().filter(|kind| wanted(kind.about) && kind.name != "augmented");
        kinds.map(|kind| format!("{}{behind}", kind.name)).collect::<Vec<_>>().join(", ")
    };
    format!(
        "Example:
  cargo smartbed derive tile --scalar f32 -o tile.rs
  cargo smartbed derive fourbar --crate ../fourbar
  cargo smartbed derive arm6 --answers inverse_dynamics,pose:tool --answers rates
  cargo smartbed derive tile --answers rates,energy,linearisation --costs

Answers of the mechanism: {}.
Answers of a port, a point or a frame: {}.
Answer of a joint: reaction:FRAME@POINT, the force and moment that it transmits.
{} gives all answers of a port, and adds the wrench on it as six inputs.",
        named(|about| about == About::Mechanism, ""),
        named(|about| about == About::Place, ":NAME"),
        named(|about| about == About::Port, ":NAME"),
    )
}

/// Scalars of emitted code.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub enum EmittedScalar {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    #[default]
    F64,
    /// Eight mechanisms at once in f32, one in each lane of a vector register.
    F32x8,
    /// Four mechanisms at once in f64, one in each lane of a vector register.
    F64x4,
}

impl EmittedScalar {
    fn scalar_type(self) -> ScalarType {
        match self {
            Self::F32 => ScalarType::F32,
            Self::F64 => ScalarType::F64,
            Self::F32x8 => ScalarType::Path("wide::f32x8".to_owned()),
            Self::F64x4 => ScalarType::Path("wide::f64x4".to_owned()),
        }
    }
}

/// How hard to look for fewer operations.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub enum EffortChoice {
    /// Leave the equations as derived.
    None,
    /// Merge equal values, take out common factors, share subexpressions.
    #[default]
    Default,
    /// All rules, and a search over all pairs of values, in several rounds.
    All,
}

impl EffortChoice {
    fn effort(self) -> Effort {
        match self {
            Self::None => Effort::None,
            Self::Default => Effort::Default,
            Self::All => Effort::All,
        }
    }
}

/// What runs the emitted code.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum CoreChoice {
    /// A microcontroller: as few values as possible are held at once.
    CortexM4,
    /// A desktop processor: the longest chain of dependent operations comes first, sines are computed in pairs.
    Host,
}

impl CoreChoice {
    fn core(self) -> Core {
        match self {
            Self::CortexM4 => Core::CortexM4,
            Self::Host => Core::Host,
        }
    }
}

/// Forms of the equations.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub enum Form {
    /// State: all coordinates and the independent speeds. Dependent speeds are eliminated.
    #[default]
    Reduced,
    /// As `reduced`, with independent coordinates only. Refused unless every dependent coordinate has a closed form.
    Minimal,
    /// Before the elimination: mass matrix, constraint Jacobian, forcing and bias over all speeds and the twists of
    /// bodies that close loops, for a solver with Lagrange multipliers.
    Augmented,
    /// Only answers that need no mass: speeds, outputs, projection. Also for models without bodies.
    Kinematic,
}

/// What the choice between equal forms goes by.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub enum OptimiseFor {
    /// The number of operations.
    #[default]
    Operations,
    /// The estimated time on a desktop processor.
    Time,
    /// Rounding errors near singular configurations.
    Accuracy,
}

impl OptimiseFor {
    fn optimise(self) -> Optimise {
        match self {
            Self::Operations => Optimise::Operations,
            Self::Time => Optimise::Time,
            Self::Accuracy => Optimise::Accuracy,
        }
    }
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong model or a form that it does not have.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    output::replace_none(&[("--output", Some(&arguments.output))], &[&arguments.model])?;
    let prints_code = arguments.output == "-" && arguments.folder.is_none() && !arguments.costs;
    if arguments.json && prints_code {
        let message = "--json: the code goes to standard output; name a file for it with --output, or a folder with --crate";
        return Err(Failure::Wrong(message.to_owned()));
    }
    let model = model_argument::read(&arguments.model)?;
    let choice = choice(arguments, &model)?;
    let settings = Settings { effort: arguments.effort.effort(), optimise: arguments.optimise.optimise() };
    let functions = functions(arguments, &model)?;
    let waiting = Waiting::deriving();
    let program = match (arguments.form, arguments.answers.is_empty()) {
        (Form::Kinematic, true) => program::derive_kinematic(&model, &choice, settings.effort),
        (_, true) if functions.is_empty() => {
            program::derive_asked(&model, &choice, settings, &Asked::complete(&model, Vec::new()))
        }
        _ => program::derive_asked(&model, &choice, settings, &Asked::only(functions.clone())),
    };
    drop(waiting);
    let program = program.map_err(|e| model_argument::wrong(&e))?;
    model_argument::print_warnings(&program);
    let functions = match (arguments.form, functions.is_empty()) {
        (Form::Kinematic, true) => Function::each(&program.kinematic()),
        _ => functions,
    };
    let asks = |name: &str| functions.iter().flat_map(|f| &f.requests).any(|r| r.answer == name);
    if asks("drive") && program.drive.is_none() {
        return Err(Failure::Wrong(format!(
            "--answers drive: `{}` has no prescribed motion; expected a model whose positions or constraints depend \
             on time, or with a motion constraint that has a part without speeds",
            model.name
        )));
    }
    if arguments.integrator && arguments.form != Form::Reduced {
        return Err(Failure::Wrong(
            "--integrator: only the form that gives u' can be stepped; leave out --form".to_owned(),
        ));
    }
    if arguments.shared_work && arguments.form != Form::Reduced {
        return Err(Failure::Wrong(
            "--shared-work: only the form that gives u' can be stepped; leave out --form".to_owned(),
        ));
    }
    let core = arguments.core.map(CoreChoice::core);
    if arguments.costs {
        limits::check_program(&program, &ScalarType::F32)?;
        return costs::print(&program, &all(&program, &functions), core, arguments.json);
    }
    let scalar = arguments.scalar.scalar_type();
    limits::check_program(&program, &scalar)?;
    let options =
        EmitOptions { scalar, functions, core, shared_work: arguments.shared_work, ..Default::default() };
    let written = match &arguments.folder {
        None => {
            output::write(&arguments.output, rust::emit(&program, &options).as_bytes())?;
            arguments.output.clone()
        }
        Some(folder) => {
            let text = if arguments.integrator { crate_text::with_integrators } else { crate_text::library };
            let files = text(&program, &options.scalar, &options);
            crate_folder::write(Path::new(folder), &files)?;
            folder.clone()
        }
    };
    report(arguments, &program, &options, &written)
}

/// The functions asked for; if none are, those that every program has.
fn all(program: &Program, asked: &[Function]) -> Vec<Function> {
    if asked.is_empty() { Function::each(&program.standing()) } else { asked.to_vec() }
}

/// Reports what was written, unless the text itself goes to standard output.
fn report(
    arguments: &Arguments,
    program: &Program,
    options: &EmitOptions,
    written: &str,
) -> Result<(), Failure> {
    let emitted = rust::function_names(program, options);
    tell_renamed(&emitted);
    if written == "-" {
        return Ok(());
    }
    let functions = all(program, &options.functions);
    let name = |function: &Function| emitted.get(&function.name).unwrap_or(&function.name).clone();
    let operations = |function: &Function| program.dag.state_cost(&program.function_roots(function));
    let text = if arguments.json {
        let costs = functions.iter().map(|f| (name(f), serde_json::Value::from(operations(f))));
        let costs = serde_json::Map::from_iter(costs);
        let done = serde_json::json!({"model": program.name, "output": written, "operations": costs});
        format!("{done}\n")
    } else {
        let first = &functions[0];
        let what = if first.name == "rates" { String::new() } else { format!(" of {}", name(first)) };
        let operations = count(operations(first), "operation");
        format!("{}: {operations} per evaluation{what}, in {written}\n", program.name)
    };
    output::print(&text)
}

/// Says which functions are emitted under other names, because these are in use; that characters which no name in Rust
/// has become underscores goes without saying.
fn tell_renamed(emitted: &BTreeMap<String, String>) {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    for (asked, name) in emitted.iter().filter(|(asked, name)| !asked.chars().map(plain).eq(name.chars())) {
        output::say(&format!(
            "note: the function `{asked}` is emitted as `{name}`: the file has something else of that name, or Rust reserves it"
        ));
    }
}

/// Parameters kept and changed, by names that exist.
fn choice(arguments: &Arguments, model: &Model) -> Result<ParameterChoice, Failure> {
    let mut choice = ParameterChoice { keep: arguments.keep.clone(), ..Default::default() };
    for change in &arguments.set {
        let (name, value) = model_argument::assignment("--set", change)?;
        choice.values.insert(name, value);
    }
    let known = || model.parameters.iter().map(|p| p.name.as_str());
    for name in choice.keep.iter().chain(choice.values.keys()) {
        if !known().any(|k| k == name) {
            let help = crate::suggest::help(name, known());
            return Err(Failure::Wrong(format!("`{}` has no parameter `{name}`{help}", model.name)));
        }
    }
    for (name, value) in &choice.values {
        if let Some(message) = model.refuses(name, *value) {
            return Err(Failure::Wrong(format!("--set {name}={value}: {message}")));
        }
    }
    Ok(choice)
}

/// The functions of the form; empty for all.
fn functions(arguments: &Arguments, model: &Model) -> Result<Vec<Function>, Failure> {
    let asked = answers::functions(&arguments.answers)?;
    match arguments.form {
        Form::Reduced => Ok(asked),
        Form::Augmented => Ok([Function::each(&["augmented"]), asked].concat()),
        Form::Minimal => {
            let dependent: Vec<&str> = model
                .coordinates
                .iter()
                .filter(|c| !c.independent && c.closed_form.is_none())
                .map(|c| c.name.as_str())
                .collect();
            if dependent.is_empty() {
                return Ok(asked);
            }
            Err(Failure::Wrong(format!(
                "--form minimal: `{}` has dependent coordinates as state ({}); expected a closed form for each of \
                 them in the model (closed_form = \"...\"), or use --form reduced",
                model.name,
                dependent.join(", ")
            )))
        }
        Form::Kinematic => {
            let needs_masses = |r: &&Request| find(&r.answer).is_none_or(|kind| kind.needs != Needs::Motion);
            match asked.iter().flat_map(|f| &f.requests).find(needs_masses) {
                Some(dynamic) => {
                    let free = CATALOGUE.iter().filter(|kind| kind.needs == Needs::Motion);
                    let names: Vec<&str> = free.map(|kind| kind.name).collect();
                    Err(Failure::Wrong(format!(
                        "--form kinematic: the answer `{dynamic}` needs masses; expected some of {}",
                        names.join(", ")
                    )))
                }
                None => Ok(asked),
            }
        }
    }
}
