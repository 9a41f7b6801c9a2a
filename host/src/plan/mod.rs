//! Plan text -> [`Plan`] of the bed: layout, load, moves, run; all errors with their places.
//!
//! In: TOML of format 1 with numbers and units as in scenes, and settings of the command line, which override it. Out:
//! a plan within its limits, or what is wrong. One file per table: `layout` (tiles), `load` (and `mesh`, its file if it
//! has one), `timing` and `dynamics` (clocks), `moves` (orders to tiles; `moments`: whether a run shows them),
//! `sensing` and `instruments` (sensors), `policy` (who gives orders; `supervised`: who checks them), `estimates`
//! (parameters of metrics).

mod dynamics;
mod estimates;
mod gmsh;
pub mod instruments;
mod layout;
mod load;
pub mod mesh;
mod moments;
mod moves;
pub mod policy;
pub mod sensing;
pub mod supervised;
mod timing;

use crate::world::read::settings;
pub use moves::Axes;
use smartbed_bed::metrics::Thresholds;
use smartbed_bed::metrics::braden::Braden;
use smartbed_bed::plan::check::{Refusal, check};
use smartbed_bed::plan::history::{History, RunError};
use smartbed_bed::plan::run;
use smartbed_bed::plan::{Move, Plan};
use smartbed_bed::policy::Supervisor;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics, Severity};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{self, Table, Value, wrong_kind};
use smartbed_codegen::source::{Source, Span};
use std::path::PathBuf;
use supervised::Controller;
use timing::Timing;

/// The contents of a plan's text.
#[derive(Clone, Debug)]
pub struct Read {
    /// The plan.
    pub plan: Plan,
    /// Keys and values of its `[sweep]`.
    pub axes: Axes,
    /// The sensors of the bed's surface.
    pub sensors: Option<sensing::Sensing>,
    /// The tiles' own instruments.
    pub instruments: Option<instruments::Instrumented>,
    /// The policy that gives orders during the run.
    pub policy: Option<policy::Chosen>,
    /// Are orders checked by the tiles' controller and its supervisor?
    pub is_supervised: bool,
    /// The nurse's scores of the patient.
    pub braden: Option<Braden>,
    /// Parameters of the metrics.
    pub thresholds: Thresholds,
    /// What can be run, but is probably not what its author meant.
    pub warnings: Diagnostics,
}

impl Read {
    /// Runs the plan, under its policy if it has one; `at` receives the fraction done and returns whether to go on.
    ///
    /// # Errors
    /// [`RunError`].
    pub fn run(&self, at: impl FnMut(f64) -> bool) -> Result<History, RunError> {
        let Some(chosen) = &self.policy else { return run::run(&self.plan, at) };
        let reader = self.sensors.as_ref().map(|sensors| &sensors.reader);
        let mut policy = chosen.policy(&self.plan);
        smartbed_bed::policy::run::run(
            &self.plan,
            policy.as_mut(),
            &chosen.bounds,
            self.supervisor(),
            reader,
            at,
        )
    }

    /// Checks the plan with additional moves against its limits, and against those of the tiles' controller and its
    /// supervisor.
    ///
    /// # Errors
    /// The first limit that it exceeds.
    pub fn allows(&self, moves: &[Move]) -> Result<(), Refusal> {
        let plan = self.plan.with(moves);
        check(&plan)?;
        self.supervisor().map_or(Ok(()), |own| own.check(&plan, 0.0))
    }

    /// The supervisor that checks orders, if there is one.
    fn supervisor(&self) -> Option<&dyn Supervisor> {
        self.is_supervised.then_some(&Controller)
    }
}

/// Reads a plan; `settings` are `--set`'s.
///
/// # Errors
/// All errors in its text.
pub fn parse(path: &str, text: &str, settings: &[String]) -> Result<Read, Diagnostics> {
    let source = Source::new(path, text);
    let mut found = Diagnostics::new(source.clone());
    let table = match document::parse(text, 0) {
        Ok(table) => table,
        Err(items) => return Err(Diagnostics { source, items }),
    };
    let table = settings::apply(table, settings, &mut found);
    match read(path, &table, &mut found) {
        Some(read) if !found.has_errors() => Ok(Read { warnings: found, ..read }),
        _ => {
            // A warning may come from a key that is wrong: errors first.
            found.items.retain(|item| item.severity == Severity::Error);
            Err(found)
        }
    }
}

/// The file of the mesh that a plan names, if any: results depend on it as on the plan's text.
#[must_use]
pub fn mesh_file(path: &str, text: &str, settings: &[String]) -> Option<PathBuf> {
    let mut found = Diagnostics::new(Source::new(path, text));
    let table = settings::apply(document::parse(text, 0).ok()?, settings, &mut found);
    let load = Fields::of("plan", table.span, &table).table("load", &mut found)?;
    match Fields::of("load", load.span, load).get("file")? {
        Value::Text(file) => Some(mesh::path(path, &file.text)),
        _ => None,
    }
}

/// Checks a plan against its limits.
///
/// # Errors
/// The first limit that it exceeds, with file, tile and time.
pub fn checked(path: &str, read: Read) -> Result<Read, String> {
    match read.allows(&[]) {
        Ok(()) => Ok(read),
        Err(refusal) => Err(format!("{path}: {refusal}")),
    }
}

fn read(path: &str, table: &Table, found: &mut Diagnostics) -> Option<Read> {
    let fields = Fields::of("plan", table.span, table);
    match fields.get("format") {
        Some(Value::Number(1.0, _)) => {}
        Some(other) => found.push(wrong_kind("format", "1, that of plans", other).help("format = 1")),
        None => found
            .push(Diagnostic::error("the plan has no `format`").label(table.span, "").help("add format = 1")),
    }
    let title = fields.text("title", found).map_or_else(|| path.to_owned(), |text| text.text.clone());
    let empty = Table::default();
    let (mut layout, pressure) = layout::read(fields.table("bed", found).unwrap_or(&empty), found)?;
    let (load, braden) = load::read(&fields, path, found)?;
    let Timing { seconds, every, cycle, clock, laying, is_supervised } =
        timing::read(&fields, load.body.segments.is_empty(), found)?;
    let moves = moves::read(&fields, &layout, pressure, [seconds, every], found)?;
    let (moves, places): (Vec<Move>, Vec<Span>) = moves.into_iter().unzip();
    let area = layout.count() as f64 * layout.pitch[0] * layout.pitch[1];
    let sensors = match fields.table("sensors", found) {
        Some(table) => Some(sensing::read(table, area, found)?),
        None => None,
    };
    if let Some(sensors) = &sensors {
        let ([nx, ny], [a, b]) = (layout.intervals, layout.size());
        layout.cover = sensors.cover(a * b / (nx * ny) as f64);
    }
    let instruments = match fields.table("instruments", found) {
        Some(table) => Some(instruments::read(table, found)?),
        None => None,
    };
    let thresholds = estimates::read(&fields, cycle, found);
    let governed = fields.table("policy", found);
    let policy = match governed {
        Some(table) => Some(policy::read(table, [seconds, every], pressure, found)?),
        None => None,
    };
    // The controller supports tiles of one size: a plan with others that asks for supervision is refused.
    let misfit = supervised::misfit(&layout);
    let is_supervised = is_supervised.unwrap_or(misfit.is_none() || policy.is_some());
    if let Some(misfit) = misfit.filter(|_| is_supervised) {
        let error = Diagnostic::error(misfit).label(table.span, "of this plan");
        found.push(error.help("tiles of that size, or run.supervised = false"));
        return None;
    }
    let axes = fields.table("sweep", found).map_or_else(Vec::new, |table| moves::axes(table, found));
    fields.finish(found);
    let plan = Plan { title, layout, pressure, load, moves, seconds, every, cycle, clock, laying };
    moments::check(&plan, &places, policy.as_ref().zip(governed.map(|table| table.span)), found);
    let warnings = Diagnostics::default();
    Some(Read { plan, axes, sensors, instruments, policy, is_supervised, braden, thresholds, warnings })
}
