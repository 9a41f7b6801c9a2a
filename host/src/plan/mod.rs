//! Plan text -> [`Plan`] of the bed: layout, load, moves, run; all errors with their places.
//!
//! In: TOML of format 1, numbers with units as in scenes, settings of a command line on top. Out: a plan within its
//! limits, or what is wrong. `load` reads what lies on the bed (`mesh` its
//! file, if it has one), `sensing` and `instruments` what it is read by, `policy` who decides, `supervised` who lets that through.

mod dynamics;
mod gmsh;
pub mod instruments;
mod load;
pub mod mesh;
pub mod policy;
pub mod sensing;
pub mod supervised;

use crate::world::read::settings;
use crate::world::read::value::{Bound, count, list, number, scalar};
use smartbed_bed::plan::check::{MOST_TILES, Refusal, check};
use smartbed_bed::plan::history::{History, RunError};
use smartbed_bed::plan::run;
use smartbed_bed::plan::{Clock, Laying, Layout, Move, Plan, Start};
use smartbed_bed::policy::Supervisor;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{self, Table, Value, wrong_kind};
use smartbed_codegen::source::{Source, Span};
use std::path::PathBuf;
use supervised::Controller;

/// Most equilibria of a run.
const MOST_EQUILIBRIA: f64 = 100_000.0;
/// Most moves times equilibria: every equilibrium asks every move.
const MOST_ORDERS: f64 = 1e7;
/// Most parts in which a weight is laid on.
const MOST_PARTS: usize = 100;
/// Most nodes of all sheets.
const MOST_NODES: usize = 100_000;

/// What a sweep changes: keys with the texts of their values, in the author's order.
pub type Axes = Vec<(String, Vec<String>)>;

/// A plan's text, read.
#[derive(Clone, Debug)]
pub struct Read {
    /// The plan.
    pub plan: Plan,
    /// What its `[sweep]` changes.
    pub axes: Axes,
    /// The surface that it is read by.
    pub sensors: Option<sensing::Sensing>,
    /// What is read of the tiles.
    pub instruments: Option<instruments::Instrumented>,
    /// Who decides on the way.
    pub policy: Option<policy::Chosen>,
    /// Orders go through the tiles' controller and its supervisor.
    pub is_supervised: bool,
}

impl Read {
    /// Runs the plan, under its policy if it has one; `at` hears the share that is done and says whether to go on.
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

    /// Holds the plan with more moves against its limits, and against those of the tiles' controller and its supervisor.
    ///
    /// # Errors
    /// The first limit that it exceeds.
    pub fn allows(&self, moves: &[Move]) -> Result<(), Refusal> {
        let plan = self.plan.with(moves);
        check(&plan)?;
        self.supervisor().map_or(Ok(()), |own| own.check(&plan, 0.0))
    }

    /// Who lets orders through, if somebody does.
    fn supervisor(&self) -> Option<&dyn Supervisor> {
        self.is_supervised.then_some(&Controller)
    }
}

/// Reads a plan; `settings` are `--set`'s.
///
/// # Errors
/// Everything that is wrong in its text.
pub fn parse(path: &str, text: &str, settings: &[String]) -> Result<Read, Diagnostics> {
    let source = Source::new(path, text);
    let mut found = Diagnostics::new(source.clone());
    let table = match document::parse(text, 0) {
        Ok(table) => table,
        Err(items) => return Err(Diagnostics { source, items }),
    };
    let table = settings::apply(table, settings, &mut found);
    match read(path, &table, &mut found) {
        Some(read) => found.finish(read),
        None => Err(found),
    }
}

/// The mesh that a plan names, if it names one: what its results depend on beside its text.
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

/// Holds a plan against its limits.
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
    let (mut layout, pressure) = layout(fields.table("bed", found).unwrap_or(&empty), found)?;
    let load = load::read(&fields, path, found)?;
    let run = fields.table("run", found).unwrap_or(&empty);
    let Timing { seconds, every, cycle, is_motion, parts, fall, is_supervised } = timing(run, found)?;
    let in_motion = fall.unwrap_or(0.0) + if is_motion { seconds } else { 0.0 };
    let dynamics = fields.table("dynamics", found).unwrap_or(&empty);
    let told = dynamics::read(dynamics, in_motion, fall.is_some(), found)?;
    let clock = if is_motion { Clock::Dynamics(told.dynamics) } else { Clock::QuasiStatic };
    if fall.is_some() && is_motion && told.dynamics.start != Start::AtRest {
        let error =
            Diagnostic::error("`fall` beside a motion that begins with one").label(run.span, "of this run");
        found.push(error.help("leave `fall` out, or dynamics.start = \"at_rest\" after it"));
        return None;
    }
    if told.dynamics.is_f32 && !load.body.segments.is_empty() {
        let error = Diagnostic::error("a bed moves in f32 only where nothing lies on it");
        found.push(
            error
                .label(dynamics.span, "of this motion")
                .help("scalar = \"f64\", or neither [patient] nor [load]"),
        );
        return None;
    }
    let laying = match fall {
        Some(seconds) => Laying::Fallen(told.fall, seconds),
        None if parts > 1 => Laying::InParts(parts),
        None => Laying::AtOnce,
    };
    let mut moves = Vec::new();
    for item in fields.array("move", found).map_or(&[][..], |(items, _)| items) {
        match item {
            Value::Table(table) => moves.extend(change(table, &layout, found)),
            other => found.push(wrong_kind("move", "tables, each under [[move]]", other)),
        }
    }
    if let Some(table) = fields.table("alternating", found) {
        moves.extend(alternating(table, &layout, pressure, seconds, found)?);
    }
    let asked = moves.len() as f64 * (seconds / every + 2.0 * moves.len() as f64);
    if asked > MOST_ORDERS {
        let error = Diagnostic::error(format!(
            "moves times equilibria are {asked:.1e}, expected at most {MOST_ORDERS:.0e}"
        ));
        found.push(error.label(table.span, "of this plan").help("fewer cycles, or a longer `every`"));
        return None;
    }
    moves.sort_by(|a: &Move, b| a.at.total_cmp(&b.at));
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
    let policy = match fields.table("policy", found) {
        Some(table) => Some(policy::read(table, found)?),
        None => None,
    };
    // A bed of other tiles has no such controller; what asks for one is told.
    let misfit = supervised::misfit(&layout);
    let is_supervised = is_supervised.unwrap_or(misfit.is_none() || policy.is_some());
    if let Some(misfit) = misfit.filter(|_| is_supervised) {
        let error = Diagnostic::error(misfit).label(table.span, "of this plan");
        found.push(error.help("tiles of that size, or run.supervised = false"));
        return None;
    }
    let axes = fields.table("sweep", found).map_or_else(Vec::new, |table| axes(table, found));
    fields.finish(found);
    let plan = Plan { title, layout, pressure, load, moves, seconds, every, cycle, clock, laying };
    Some(Read { plan, axes, sensors, instruments, policy, is_supervised })
}

fn layout(table: &Table, found: &mut Diagnostics) -> Option<(Layout, f64)> {
    let fields = Fields::of("bed", table.span, table);
    let usual = Layout::default();
    let mut positive = |key: &'static str, of: &str, usual: f64| {
        number(&fields, key, of, Bound::Positive, found).unwrap_or(usual)
    };
    let mut layout = Layout {
        depth: positive("depth", "m", usual.depth),
        modulus: positive("modulus", "N/m", usual.modulus),
        circle: positive("circle", "m", usual.circle),
        stroke: positive("stroke", "m", usual.stroke),
        speed: positive("speed", "m/s", usual.speed),
        step: positive("step", "m", usual.step),
        most_pressure: positive("most_pressure", "Pa", usual.most_pressure),
        above: positive("above", "m", usual.above),
        gap: positive("gap", "m", usual.gap),
        ..usual
    };
    let pressure = positive("pressure", "Pa", 4000.0);
    layout.friction = number(&fields, "friction", "", Bound::NotNegative, found).unwrap_or(usual.friction);
    layout.rubbing =
        number(&fields, "sheet_friction", "", Bound::NotNegative, found).unwrap_or(usual.rubbing);
    layout.exponent = number(&fields, "exponent", "", Bound::Positive, found).unwrap_or(usual.exponent);
    layout.rows = count(&fields, "rows", 1, found).unwrap_or(usual.rows);
    layout.columns = count(&fields, "columns", 1, found).unwrap_or(usual.columns);
    layout.is_sealed = fields.boolean("sealed", found).unwrap_or(false);
    if let Some(value) = fields.get("pitch") {
        layout.pitch = list::<2>(value, "pitch", "m", found)?;
    }
    if let Some(value) = fields.get("intervals") {
        let told = list::<2>(value, "intervals", "", found)?;
        if told.iter().any(|n| n.fract() != 0.0 || *n < 0.0) {
            let [x, y] = told;
            let error = Diagnostic::error(format!("`intervals` are {x} and {y}, expected whole numbers"));
            found.push(error.label(value.span(), "along x and y").help("intervals = [8, 10]"));
            return None;
        }
        layout.intervals = told.map(|n| n as usize);
    }
    fields.finish(found);
    let mut refuse = |what: String, help: &str| {
        found.push(Diagnostic::error(what).label(table.span, "of this bed").help(help));
        None
    };
    let tiles = layout.rows.saturating_mul(layout.columns);
    if tiles > MOST_TILES {
        return refuse(format!("{tiles} tiles, expected 1 to {MOST_TILES}"), "fewer `rows` or `columns`");
    }
    if layout.size().iter().any(|s| *s <= 0.0) {
        return refuse(
            "a gap as wide as the pitch leaves no tile".to_owned(),
            "pitch = [\"225_mm\", \"285.7_mm\"]",
        );
    }
    let [nx, ny] = layout.intervals;
    if tiles.saturating_mul((nx + 1).saturating_mul(ny + 1)) > MOST_NODES {
        return refuse(format!("the sheets have more than {MOST_NODES} nodes"), "fewer `intervals`");
    }
    if let Err(error) = smartbed_bed::sheet::Lattice::new(layout.intervals, layout.size(), layout.modulus) {
        return refuse(error.to_string(), "intervals = [8, 10]");
    }
    Some((layout, pressure))
}

/// `[run]`.
struct Timing {
    seconds: f64,
    every: f64,
    cycle: f64,
    is_motion: bool,
    parts: usize,
    /// How long (s) the load falls and settles before the first equilibrium.
    fall: Option<f64>,
    is_supervised: Option<bool>,
}

fn timing(table: &Table, found: &mut Diagnostics) -> Option<Timing> {
    let fields = Fields::of("run", table.span, table);
    let seconds = number(&fields, "seconds", "s", Bound::NotNegative, found).unwrap_or(0.0);
    let every = number(&fields, "every", "s", Bound::Positive, found).unwrap_or(10.0);
    let cycle = number(&fields, "cycle", "s", Bound::Positive, found).unwrap_or(600.0);
    let parts = count(&fields, "parts", 1, found).unwrap_or(1);
    let fall = number(&fields, "fall", "s", Bound::Positive, found);
    let clock = load::named(&fields, "clock", &dynamics::CLOCKS, found);
    let is_supervised = fields.boolean("supervised", found);
    fields.finish(found);
    if parts > MOST_PARTS {
        let error =
            Diagnostic::error(format!("a weight laid on in {parts} parts, expected 1 to {MOST_PARTS}"));
        found.push(error.label(table.span, "of this run").help("parts = 8"));
        return None;
    }
    if fall.is_some() && parts > 1 {
        let error =
            Diagnostic::error("a load that falls is not laid on in `parts`").label(table.span, "of this run");
        found.push(error.help("leave one of the two out"));
        return None;
    }
    if seconds / every > MOST_EQUILIBRIA {
        let error = Diagnostic::error(format!("more than {MOST_EQUILIBRIA} equilibria"));
        found.push(error.label(table.span, "of this run").help("a longer `every`"));
        return None;
    }
    let count = (seconds / every).round();
    if (seconds - count * every).abs() > 1e-6 * every {
        let error = Diagnostic::error(format!("`seconds` is {seconds} s, no multiple of `every`, {every} s"));
        let help = format!("every = {}, or seconds = {}", seconds / count.max(1.0), count.max(1.0) * every);
        found.push(error.label(table.span, "of this run: its end would not be looked at").help(help));
        return None;
    }
    Some(Timing { seconds, every, cycle, is_motion: clock?, parts, fall, is_supervised })
}

/// One [[move]].
fn change(table: &Table, layout: &Layout, found: &mut Diagnostics) -> Option<Move> {
    let fields = Fields::of("move", table.span, table);
    let at = number(&fields, "at", "s", Bound::NotNegative, found).unwrap_or(0.0);
    let over = number(&fields, "over", "s", Bound::NotNegative, found).unwrap_or(0.0);
    let tiles = tiles(fields.need("tiles", "\"all\"", found)?, layout, found)?;
    let pressure = number(&fields, "pressure", "Pa", Bound::Any, found);
    let heave = number(&fields, "heave", "m", Bound::Any, found);
    let tilt = fields.get("tilt").map(|value| list::<2>(value, "tilt", "", found));
    fields.finish(found);
    if pressure.is_none() && heave.is_none() && tilt.is_none() {
        let error = Diagnostic::error("a move changes nothing").label(table.span, "this one");
        found.push(error.help("give it pressure, heave or tilt"));
        return None;
    }
    let slope = match tilt {
        None => None,
        Some(angles) => {
            let angles = angles?;
            if angles.iter().any(|a| a.abs() >= 1.0) {
                let error =
                    Diagnostic::error("`tilt` must be below 57 deg").label(table.span, "in this move");
                found.push(error.help("tilt = [\"5_deg\", \"0_deg\"], towards +x and +y"));
                return None;
            }
            Some(angles.map(f64::tan))
        }
    };
    Some(Move { at, over, tiles, pressure, heave, slope })
}

/// `"all"`, or numbers from 1.
fn tiles(value: &Value, layout: &Layout, found: &mut Diagnostics) -> Option<Vec<usize>> {
    let most = layout.count();
    let mut refuse = |span: Span, what: String| {
        let error = Diagnostic::error(what).label(span, "here");
        found.push(
            error.help(format!("tiles = \"all\", or numbers from 1 to {most}, row by row from the head")),
        );
        None
    };
    match value {
        Value::Text(text) if text.text == "all" => Some((0..most).collect()),
        Value::Array(items, span) if items.is_empty() => refuse(*span, "no tile is told".to_owned()),
        Value::Array(items, _) => {
            let mut tiles = Vec::new();
            for item in items {
                match item {
                    Value::Number(n, _) if n.fract() == 0.0 && (1.0..=most as f64).contains(n) => {
                        tiles.push(*n as usize - 1);
                    }
                    other => return refuse(other.span(), "there is no such tile".to_owned()),
                }
            }
            Some(tiles)
        }
        other => refuse(other.span(), "expected tiles".to_owned()),
    }
}

fn alternating(
    table: &Table,
    layout: &Layout,
    pressure: f64,
    seconds: f64,
    found: &mut Diagnostics,
) -> Option<Vec<Move>> {
    let fields = Fields::of("alternating", table.span, table);
    let low = scalar(fields.need("low", "\"1.6_kPa\"", found)?, "low", "Pa", Bound::NotNegative, found)?;
    let high = number(&fields, "high", "Pa", Bound::NotNegative, found).unwrap_or(pressure);
    let cycle = number(&fields, "cycle", "s", Bound::Positive, found).unwrap_or(600.0);
    fields.finish(found);
    if seconds / cycle > 10_000.0 {
        let error = Diagnostic::error("more than 10000 cycles").label(table.span, "of this alternation");
        found.push(error.help("a longer `cycle`"));
        return None;
    }
    Some(Plan::alternating(layout, low, high, cycle, seconds))
}

/// Keys and values of a sweep.
fn axes(table: &Table, found: &mut Diagnostics) -> Axes {
    let mut axes = Axes::new();
    for (key, value) in &table.entries {
        let texts = match value {
            Value::Array(items, _) if !items.is_empty() => {
                items.iter().map(text_of).collect::<Option<Vec<_>>>()
            }
            _ => None,
        };
        match texts {
            Some(texts) => axes.push((key.name.clone(), texts)),
            None => found.push(
                wrong_kind(&key.name, "a list of numbers or texts", value)
                    .help("\"patient.mass\" = [\"60_kg\", \"75_kg\"]"),
            ),
        }
    }
    axes
}

/// A value as a setting has it.
fn text_of(value: &Value) -> Option<String> {
    match value {
        Value::Number(x, _) => Some(format!("{x}")),
        Value::Boolean(x, _) => Some(format!("{x}")),
        Value::Text(text) => Some(format!("{:?}", text.text)),
        _ => None,
    }
}
