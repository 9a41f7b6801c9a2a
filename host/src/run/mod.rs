//! `smartbed run`: a mechanism or a scene in motion; rows as CSV, plots, an animation, a summary.

#[cfg(feature = "whole")]
mod body;
#[cfg(feature = "whole")]
mod choose;
pub mod events;
pub mod health;
pub mod ledger;
mod plant;
pub mod settings;
pub mod simulate;
#[cfg(feature = "whole")]
pub(crate) mod world;

use self::events::Events;
use crate::configuration::Configurations;
use crate::engine::{self, EngineKind, EngineScalar, ScalarKind};
use crate::failure::Failure;
use crate::interrupt;
use crate::number::{digits, json_number, json_object, short};
use crate::observers::Observers;
use crate::output::{self, Output};
use crate::plot::Recording;
use crate::plot::motion::{self, Motion};
use crate::plot::panels;
use crate::progress::{Progress, Waiting};
use crate::view::film::Series;
use crate::view::{Film, Stage};
#[cfg(feature = "whole")]
use crate::world::Assembly;
use crate::{model_argument, plot, speeds, view};
use settings::Settings;
use simulate::{Row, Setup, Summary, columns};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::kinematics::Unreachable;
use smartbed_codegen::model::{Model, StartRef};
use smartbed_codegen::program::Quantity;
use smartbed_codegen::words::count;
use smartbed_codegen::{Program, program};
use std::fmt::Write as _;

/// A dependent start value counts as replaced where the solution differs by more than this, relative to it.
const REPLACED: f64 = 1e-6;
/// Last values below this share of the largest of their unit are rounding.
const ROUNDING: f64 = 1e-12;

/// Simulate a mechanism or a scene.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Examples:
  cargo smartbed run pendulum3 --plot motion.svg
  cargo smartbed run tile --seconds 2 --step 1e-3 --method rk4 --set M=8 --set hA=0.02 --csv -
  cargo smartbed run fourbar --error 1e-9 --view fourbar.html
  cargo smartbed run single_spring --budget 200us
  cargo smartbed run single_spring --csv - --set C=10

Left-out settings are those of the model's [run]; the start is the model's [start], left-out
coordinates are nominal, dependent ones are solved for. SI units.")]
pub struct Arguments {
    /// The model or scene: a path, or a name under models/.
    pub model: String,
    /// Simulated time (s).
    #[arg(long, value_name = "T")]
    pub seconds: Option<f64>,
    /// Step (s); the first one of an adaptive method.
    #[arg(long, value_name = "H")]
    pub step: Option<f64>,
    /// Integration method: euler, semi-implicit, rk4 or dormand-prince; a scene has its own.
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Error allowed per step, of a method of adaptive step [default: 1e-9].
    #[arg(long, value_name = "E")]
    pub tolerance: Option<f64>,
    /// Picks the fastest method and step that keep every coordinate this exact (m or rad).
    #[arg(long, value_name = "E", conflicts_with_all = ["step", "tolerance", "budget"])]
    pub error: Option<f64>,
    /// Picks the most exact method and step with this computing time per simulated second.
    #[arg(long, value_name = "TIME", conflicts_with_all = ["step", "tolerance"])]
    pub budget: Option<String>,
    /// What is computed with.
    #[arg(long, value_enum, default_value_t)]
    pub scalar: ScalarKind,
    /// A row every N steps.
    #[arg(long, value_name = "N")]
    pub every: Option<usize>,
    /// Write the rows to this file; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,
    /// Plot coordinates and energies over time.
    #[arg(long, value_name = "FILE.svg|.png")]
    pub plot: Option<String>,
    /// What --plot shows beside energies: names of coordinates, speeds, outputs, inputs, with * and ?.
    #[arg(long, value_name = "h*,u_*", requires = "plot")]
    pub show: Option<String>,
    /// Write an animation that any browser shows; FILE.html#t=0.5 opens it at 0.5 s.
    #[arg(long, value_name = "FILE.html")]
    pub view: Option<String>,
    /// Changes a parameter or a start value; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Write where the run has come to, to go on from; scenes of format 2.
    #[arg(long, value_name = "FILE")]
    pub save: Option<String>,
    /// Go on from what --save wrote; --seconds counts from the first start.
    #[arg(long, value_name = "FILE")]
    pub resume: Option<String>,
    /// What evaluates.
    #[arg(long, value_enum, default_value_t)]
    pub engine: EngineKind,
    /// What went wrong in the motion (energy that no account explains, ranges left, a nearly singular
    /// configuration) is a failure, not a warning.
    #[arg(long)]
    pub strict: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Does what the command line asks for.
///
/// # Errors
/// Status 1 for a wrong model or setting and for a motion that cannot go on; status 2 without a
/// compiler for `--engine compiled`.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Outcome { text, film, findings } = carry_out(arguments)?;
    if let (Some(file), Some(film)) = (&arguments.view, film) {
        output::write(file, view::page(&film).as_bytes())?;
    }
    tell(arguments, &text, &findings)
}

/// The world that the arguments name, changed by their settings.
///
/// # Errors
/// [`Failure::Found`] with all that is wrong in it; [`Failure::Wrong`] if the file is none.
#[cfg(feature = "whole")]
pub fn world(arguments: &Arguments) -> Result<Assembly, Failure> {
    let path = model_argument::find(&arguments.model)?;
    match model_argument::is_world(&path) {
        true => world::open(arguments, &path),
        false => Err(Failure::Wrong(format!(
            "{}: expected a scene of format 2, with [parts.NAME]",
            path.display()
        ))),
    }
}

/// What a run leaves behind beside its files.
struct Outcome {
    /// The summary.
    text: String,
    /// The data of the page.
    film: Option<String>,
    /// What went wrong.
    findings: Vec<String>,
}

/// Runs, and gives what the page of the motion reads; `--view` is not written.
///
/// # Errors
/// As [`run`].
pub fn film(arguments: &Arguments) -> Result<String, Failure> {
    let arguments = Arguments { view: Some(String::new()), ..arguments.clone() };
    Ok(carry_out(&arguments)?.film.unwrap_or_default())
}

/// Runs and writes what is asked for but the page; gives the summary, and the page's data if `--view` is given.
fn carry_out(arguments: &Arguments) -> Result<Outcome, Failure> {
    if let Some(file) = &arguments.plot {
        plot::format_of(file)?;
    }
    #[cfg(feature = "whole")]
    return any(arguments);
    #[cfg(not(feature = "whole"))]
    mechanism(arguments)
}

/// A world, a scene or a mechanism, each as it is run.
#[cfg(feature = "whole")]
fn any(arguments: &Arguments) -> Result<Outcome, Failure> {
    let path = model_argument::find(&arguments.model)?;
    let is_world = model_argument::is_world(&path);
    if !is_world && (arguments.save.is_some() || arguments.resume.is_some()) {
        return Err(Failure::Wrong("--save and --resume: expected a scene of format 2".to_owned()));
    }
    let arguments = &choose::resolve(arguments, &path)?;
    if is_world {
        return world::simulate(arguments, &path);
    }
    match body::is_scene(&path) {
        true => body::simulate(arguments, &path),
        false => mechanism(arguments),
    }
}

fn mechanism(arguments: &Arguments) -> Result<Outcome, Failure> {
    let clock = Progress::new("run");
    let model = model_argument::read(&arguments.model)?;
    let settings = Settings::new(&model, arguments)?;
    let wrong = |e| model_argument::wrong(&e);
    let waiting = Waiting::deriving();
    let program = program::derive(&model, &settings.choice).map_err(wrong)?;
    drop(waiting);
    model_argument::print_warnings(&program);
    let observers = Observers::derive(&model, &settings.choice).map_err(wrong)?;
    let start = start(&model, &program, &settings)?;
    let setup = Setup { program: &program, observers: &observers, settings: &settings, start: &start };
    let (summary, film) = match arguments.scalar {
        ScalarKind::F32 => record::<f32>(arguments, &model, setup)?,
        ScalarKind::F64 => record::<f64>(arguments, &model, setup)?,
    };
    let text = report(arguments, &model, setup, &summary, clock.seconds());
    Ok(Outcome { text, film, findings: summary.health.findings() })
}

/// The summary, where rows do not go; then what went wrong, which `--strict` makes a failure.
fn tell(arguments: &Arguments, text: &str, findings: &[String]) -> Result<(), Failure> {
    if arguments.csv.as_deref() == Some("-") {
        output::say(text.trim_end());
    } else {
        output::print(text)?;
    }
    match findings {
        [] => Ok(()),
        _ if arguments.strict => {
            Err(Failure::Wrong(format!("--strict: {}", findings.join("\nerror: --strict: "))))
        }
        _ => {
            findings.iter().for_each(|finding| output::say(&format!("warning: {finding}")));
            Ok(())
        }
    }
}

/// What there is of a run that ended early: whole rows.
fn ended_early(failure: Failure, csv: Option<Output>, rows: u64, file: &str) -> Failure {
    let (Some(csv), Failure::Wrong(why)) = (csv, &failure) else { return failure };
    match csv.finish() {
        Ok(()) if file != "-" => {
            Failure::Wrong(format!("{why}; {} up to there in {file}", count(rows, "row")))
        }
        Ok(()) => failure,
        Err(full) => full,
    }
}

/// Coordinates and independent speeds at the start.
pub(crate) fn start(model: &Model, program: &Program, settings: &Settings) -> Result<Vec<f64>, Failure> {
    let mut configurations = Configurations::new(model, program);
    let parameters: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let given: Vec<Option<f64>> = program.q.iter().map(|q| settings.start.get(&q.name).copied()).collect();
    let mut x = configurations
        .solve(&parameters, &given)
        .map_err(|unreachable| start_unreachable(model, settings, &unreachable))?;
    let why = "it is dependent and follows from the independent coordinates";
    note_replaced(&program.q, &given, &x, why);
    let speeds = start_speeds(model, program, settings, (&x, &parameters))?;
    x.extend(speeds);
    Ok(x)
}

/// Says which of the start values that were given are others now, and why.
fn note_replaced(quantities: &[Quantity], given: &[Option<f64>], found: &[f64], why: &str) {
    for ((quantity, given), found) in quantities.iter().zip(given).zip(found) {
        let replaced = given.filter(|given| (given - found).abs() > REPLACED * given.abs().max(1.0));
        if let Some(given) = replaced {
            output::say(&format!(
                "note: the start value {} = {given} is replaced by {found:.6}: {why}",
                quantity.name
            ));
        }
    }
}

/// Speeds at the start: as given, made to meet the constraints where all of them are state.
fn start_speeds(
    model: &Model,
    program: &Program,
    settings: &Settings,
    (q, parameters): (&[f64], &[f64]),
) -> Result<Vec<f64>, Failure> {
    let is_state = |name: &str| program.u.iter().any(|u| u.name == name);
    let followed = model.speeds.iter().find(|s| settings.start.contains_key(&s.name) && !is_state(&s.name));
    if let Some(speed) = followed {
        return Err(Failure::Wrong(format!(
            "the speed `{}` is dependent: it follows from the independent ones and cannot be set",
            speed.name
        )));
    }
    let given: Vec<Option<f64>> = program.u.iter().map(|u| settings.start.get(&u.name).copied()).collect();
    let independent = |i: usize| model.speeds.iter().any(|s| s.independent && s.name == program.u[i].name);
    let speeds = speeds::complete(program, (0.0, q, parameters), &given, &independent)
        .map_err(|fault| Failure::Wrong(format!("the start: {fault}")))?;
    let why = "the constraints and the other start values do not allow it";
    note_replaced(&program.u, &given, &speeds, why);
    Ok(speeds)
}

/// The start cannot be assembled: with the lines of `[start]` that say where it should be.
fn start_unreachable(model: &Model, settings: &Settings, unreachable: &Unreachable) -> Failure {
    let mut error = Diagnostic::error(format!("the start cannot be assembled: {unreachable}"))
        .help("expected independent coordinates within reach of the nominal configuration");
    for ((owner, value), (_, written)) in model.start.iter().zip(&model.start_written) {
        if let StartRef::Coordinate(id) = owner
            && settings.start.get(&model.coordinates[*id].name) == Some(value)
        {
            error = error.label(written.span, "this start value, among others");
        }
    }
    model_argument::wrong(&Diagnostics::one(model.source.clone(), error))
}

/// Simulates and writes what is asked for; gives the data of `--view`.
fn record<S: EngineScalar>(
    arguments: &Arguments,
    model: &Model,
    setup: Setup<'_>,
) -> Result<(Summary, Option<String>), Failure> {
    let engine = engine::new::<S>(arguments.engine, setup.program)?;
    let names = columns(setup.program, setup.observers);
    let mut csv = arguments.csv.as_deref().map(Output::open).transpose()?;
    if let Some(csv) = &mut csv {
        csv.write(&(names.join(",") + "\n"))?;
    }
    let mut recording = arguments.plot.as_ref().map(|_| Recording::new(names.len()));
    let (series, shown) = series(model, &names);
    let mut film = arguments.view.as_ref().map(|_| Film::new(Stage::of_model(model), series));
    let mut events = Events::new(model, &names, &simulate::ranges(setup));
    let drawn = film.is_some() || recording.is_some();
    if csv.is_some() {
        interrupt::watch();
    }
    let mut rows = 0;
    let done = simulate::simulate(setup, engine, |row: &Row| {
        if let Some(csv) = &mut csv {
            csv.write(&line(&row.values))?;
        }
        if let Some(recording) = &mut recording {
            recording.push(&row.values);
        }
        if drawn {
            events.row(&row.values);
        }
        if let Some(film) = &mut film {
            film.push(row.values[0], &row.places, &[], shown.iter().map(|n| row.values[*n]));
        }
        rows += 1;
        Ok(())
    });
    let file = arguments.csv.as_deref().unwrap_or_default();
    let summary = match done {
        Ok(summary) => summary,
        Err(failure) => return Err(ended_early(failure, csv, rows, file)),
    };
    if let Some(csv) = csv {
        csv.finish()?;
    }
    if let (Some(file), Some(recording)) = (&arguments.plot, &recording) {
        let motion = Motion {
            model,
            names: &names,
            recording,
            note: &noted(setup.settings.note(), arguments),
            crossings: &events.crossings(),
            show: arguments.show.as_deref(),
            noise: arguments.scalar.noise(),
        };
        plot::write(file, &motion::draw(&motion)?)?;
    }
    let title = if model.doc.is_empty() { &model.name } else { &model.doc };
    let note = noted(setup.settings.note(), arguments);
    Ok((summary, film.map(|film| film.data(title, &note, &events.finish()))))
}

/// Curves beside the motion, and their places in a row.
fn series(model: &Model, names: &[String]) -> (Vec<Series>, Vec<usize>) {
    let columns = motion::columns(model, 1.0).into_iter();
    let curves = columns.map(|c| (c.name.to_owned(), panels::label(&c.unit), c.factor));
    let energies = motion::ENERGIES.into_iter().map(|name| (name.to_owned(), panels::label("J"), 1.0));
    let accounts = ["imbalance", "damping", "actuator", "external", "drive"];
    let accounts = accounts.map(|name| (name.to_owned(), "ledger".to_owned(), 1.0));
    let all = curves.chain(energies).chain(accounts);
    let shown = all.filter_map(|(name, group, factor)| {
        let index = names.iter().position(|n| *n == name)?;
        Some((Series { name, group, factor }, index))
    });
    shown.unzip()
}

/// How a run was made: method and step, the scalar if it is not the usual one, what was changed.
fn noted(method: String, arguments: &Arguments) -> String {
    let scalar = (arguments.scalar != ScalarKind::default()).then(|| "f32".to_owned());
    let changed = arguments.set.iter().map(|change| change.replacen('=', " = ", 1));
    std::iter::once(method).chain(scalar).chain(changed).collect::<Vec<_>>().join(", ")
}

fn line(values: &[f64]) -> String {
    let mut text = String::with_capacity(24 * values.len());
    for (n, &value) in values.iter().enumerate() {
        let separator = if n == 0 { "" } else { "," };
        let _ = write!(text, "{separator}{}", digits(value));
    }
    text + "\n"
}

/// What was done, for people or for machines.
fn report(arguments: &Arguments, model: &Model, setup: Setup<'_>, summary: &Summary, elapsed: f64) -> String {
    let names = columns(setup.program, setup.observers);
    let (settings, method) = (setup.settings, setup.settings.method.name());
    if arguments.json {
        let last = json_object(names.iter().map(String::as_str).zip(summary.last.iter().copied()));
        return format!(
            "{{\"model\": {}, \"method\": \"{method}\", \"seconds\": {}, \"steps\": {}, \"evaluations\": {}, \
             \"rows\": {}, \"worst_pivot\": {}, \"residual_before_projection\": {}, \"imbalance\": {}, \
             \"elapsed\": {}, \"warnings\": {}, \"last\": {last}}}\n",
            crate::number::json_string(&setup.program.name),
            json_number(settings.seconds),
            summary.steps,
            summary.evaluations,
            summary.rows,
            json_number(summary.pivot),
            json_number(summary.residual),
            json_number(summary.imbalance),
            json_number(elapsed),
            serde_json::Value::from(summary.health.findings()),
        );
    }
    let mut text = format!(
        "{}: {} s in {} ({method}), {}, {elapsed:.2} s\n",
        setup.program.name,
        settings.seconds,
        count(summary.steps, "step"),
        count(summary.evaluations, "evaluation")
    );
    if !setup.program.correction.is_empty() {
        let _ = writeln!(
            text,
            "constraints: worst pivot {:.3e} of nominal, largest residual before projection {:.1e}",
            summary.pivot, summary.residual
        );
    }
    let _ = writeln!(text, "energy: largest imbalance of the ledger {:.1e} J", summary.imbalance);
    let shown = 1 + setup.program.q.len() + setup.observers.closed.len() + setup.program.speeds.len();
    text + &last_row(model, settings.seconds, &names[..shown.min(names.len())], &summary.last)
}

/// Time, coordinates and speeds at the end, in the model's units; what is rounding beside others of its unit is 0.
fn last_row(model: &Model, seconds: f64, names: &[String], last: &[f64]) -> String {
    let columns = motion::columns(model, seconds);
    let of = |name: &String, value: &f64| match columns.iter().find(|column| column.name == name) {
        Some(column) => (value / column.factor, column.unit.as_str(), column.natural / column.factor),
        None if name == "t" => (*value, "s", 0.0),
        None => (*value, "", 0.0),
    };
    let rows: Vec<(f64, &str, f64)> = names.iter().zip(last).map(|(name, value)| of(name, value)).collect();
    let size = |unit: &str| {
        let alike = rows.iter().filter(|(_, other, _)| *other == unit);
        alike.map(|(value, _, natural)| value.abs().max(*natural)).fold(0.0, f64::max)
    };
    let width = names.iter().map(String::len).max().unwrap_or(0);
    let mut text = String::new();
    for (name, (value, unit, _)) in names.iter().zip(&rows) {
        let told = if value.abs() <= ROUNDING * size(unit) { 0.0 } else { *value };
        let unit = if *unit == "1" { "" } else { unit };
        let line = format!("  {name:width$} {:>16} {unit}", short(told));
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}
