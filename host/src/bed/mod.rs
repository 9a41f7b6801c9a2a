//! `smartbed bed`: runs a plan of the bed, and makes a page of it; reads maps that were recorded elsewhere.
//!
//! In: a plan, or a file of maps. Out: metrics as a table, as CSV or as one JSON object; maps as files of sensor makers; a page.

mod film;
mod map;
mod page;
mod readings;
mod rows;
mod words;

use crate::failure::Failure;
use crate::interrupt;
use crate::number::{json_number, json_string};
use crate::output;
use crate::plan::{Read, sensing};
use crate::plan_file::PlanFile;
use crate::progress::Progress;
use rows::{csv, table, write};
use smartbed_bed::files::Mapped;
use smartbed_bed::metrics::report::{Report, Row};
use smartbed_bed::metrics::{DISCLAIMER, Thresholds};
use smartbed_bed::plan::history::Watched;
use smartbed_bed::plan::history::{GATE, History, RunError};
use smartbed_bed::plan::readings::Reading;
use std::fmt::Write as _;

/// Run a plan of the bed, make a page of it, or read recorded maps.
#[derive(clap::Args, Clone, Debug)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand, Clone, Debug)]
enum Command {
    /// Run a plan: equilibria over time, then all metrics.
    #[command(after_help = "Examples:
  cargo smartbed bed run alternating
  cargo smartbed bed run ball_on_four --set load.mass=8_kg --csv metrics.csv --map map.csv")]
    Run(Run),
    /// Run a plan and write a page: pressure map, tiles, time slider, metrics.
    #[command(after_help = "Example:
  cargo smartbed bed report alternating -o alternating.html")]
    Report(Page),
    /// All metrics of maps that were recorded elsewhere: Tekscan's ASCII or XSENSOR's CSV.
    #[command(after_help = "Examples:
  cargo smartbed bed map session.asf
  cargo smartbed bed map session.asf --against simulated.csv -o session.csv")]
    Map(map::Map),
}

/// What `bed run` takes.
#[derive(clap::Args, Clone, Debug)]
pub struct Run {
    /// The plan: a path, or a name under models/plans.
    pub plan: String,
    /// Changes a key of the plan; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Metrics as CSV; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,
    /// Pressure maps over time: .csv as XSENSOR's, .asf as Tekscan's.
    #[arg(long, value_name = "FILE")]
    pub map: Option<String>,
    /// What the tiles' instruments read, as CSV; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub readings: Option<String>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// What `bed report` takes.
#[derive(clap::Args, Clone, Debug)]
pub struct Page {
    /// The plan: a path, or a name under models/plans.
    pub plan: String,
    /// Changes a key of the plan; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// The page.
    #[arg(short, long, value_name = "FILE", default_value = "bed.html")]
    pub output: String,
}

/// Does what the command line asks for.
///
/// # Errors
/// Status 1 for a wrong plan, and for one that comes to no equilibrium.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.command {
        Command::Run(asked) => {
            let read = PlanFile::open(&asked.plan)?.read(&asked.set)?;
            let history = history(&read)?;
            if let Some(file) = &asked.csv {
                write(file, &csv(&metrics(&read, &history)))?;
            }
            if let Some(file) = &asked.map {
                write(file, &maps(file, &read, &history)?)?;
            }
            if let Some(file) = &asked.readings {
                write(file, &readings::csv(&read_off(&read, &history, file)?))?;
            }
            if [&asked.csv, &asked.readings].iter().any(|file| file.as_deref() == Some("-")) {
                return Ok(());
            }
            output::print(&if asked.json { json(&read, &history) } else { text(&read, &history) })
        }
        Command::Report(asked) => {
            let read = PlanFile::open(&asked.plan)?.read(&asked.set)?;
            let history = history(&read)?;
            write(&asked.output, &page::text(&read.plan, &history, &metrics(&read, &history)))?;
            output::print(&format!("{}: {}\n", asked.output, read.plan.title))
        }
        Command::Map(asked) => map::run(asked),
    }
}

fn history(read: &Read) -> Result<History, Failure> {
    interrupt::watch();
    let mut progress = Progress::new(&read.plan.title);
    let on = |done: f64| {
        progress.at(done);
        !interrupt::is_asked()
    };
    read.run(on).map_err(|error| match error {
        RunError::Stopped => Failure::Wrong("interrupted: nothing is written".to_owned()),
        other => Failure::Wrong(format!("{}: {other}", read.plan.title)),
    })
}

/// What the tiles' instruments read.
fn read_off(read: &Read, history: &History, file: &str) -> Result<Vec<Reading>, Failure> {
    let missing = || format!("--readings {file}: the plan has no [instruments]");
    Ok(read.instruments.ok_or_else(missing)?.of(&read.plan, history))
}

/// All metrics: of sensels, and of the skin.
pub(crate) fn metrics(read: &Read, history: &History) -> [(&'static str, Vec<Row>); 2] {
    let thresholds = Thresholds { cycle: read.plan.cycle, ..Thresholds::default() };
    let friction = read.plan.layout.friction;
    let of = |recording, grid| Report { recording, grid, thresholds, friction }.rows();
    [("sensels", of(&history.sensels, Some(&history.grid))), ("skin", of(&history.skin, None))]
}

/// What the plan's sensors read in the end, if it has some.
pub(crate) fn sensed(read: &Read, history: &History) -> Option<sensing::Read> {
    read.sensors.as_ref()?.of(history)
}

/// Are these figures of a bed at rest that was felt? Contact forces carry the weight to [`GATE`], sensels feel it to 1 %, and
/// sensors read the map to 1 %.
pub(crate) fn is_valid([imbalance, felt]: [f64; 2], sensed: Option<&sensing::Read>) -> bool {
    imbalance <= GATE && felt < 0.01 && sensed.is_none_or(|read| read.error < 0.01)
}

/// How well the worst equilibrium carries the weight: by contact forces, and as sensed.
pub(crate) fn validity(history: &History) -> [f64; 2] {
    let worst = |of: fn(&smartbed_bed::plan::history::Moment) -> f64| {
        history.moments.iter().map(of).fold(0.0, f64::max)
    };
    [worst(|m| m.imbalance), worst(|m| m.sensed)]
}

/// Maps over time, as the plan's sensors read them if it has some, in the format of the file's ending.
fn maps(file: &str, read: &Read, history: &History) -> Result<String, Failure> {
    let recording = match &read.sensors {
        Some(sensors) => sensors.reader.recording(&history.sensels).map_err(|e| format!("{file}: {e}"))?,
        None => history.sensels.clone(),
    };
    map::encoded(file, &Mapped { grid: history.grid, recording })
}

/// One JSON object.
fn json(read: &Read, history: &History) -> String {
    let null = |x: Option<f64>| x.map_or_else(|| "null".to_owned(), json_number);
    let row = |row: &Row| {
        format!(
            "{{\"place\": {}, \"metric\": {}, \"value\": {}, \"unit\": {}, \"threshold\": {}}}",
            json_string(row.place),
            json_string(row.metric),
            null(row.value),
            json_string(row.unit),
            null(row.threshold)
        )
    };
    let lists = metrics(read, history).map(|(sites, rows)| {
        let rows: Vec<String> = rows.iter().map(row).collect();
        format!("\"{sites}\": [{}]", rows.join(", "))
    });
    let [imbalance, felt] = validity(history);
    let sensed = sensed(read, history);
    let sensors = sensed.as_ref().map_or_else(|| "null".to_owned(), |sensed| {
        format!(
            "{{\"rows\": {}, \"columns\": {}, \"map_error\": {}, \"moisture\": {}, \"ph\": {}, \"mass\": {}}}",
            sensed.grid[0],
            sensed.grid[1],
            json_number(sensed.error),
            json_number(sensed.skin[0]),
            json_number(sensed.skin[1]),
            json_number(sensed.mass)
        )
    });
    let instruments = read.instruments.map(|own| readings::json(&own.of(&read.plan, history)));
    let instruments = instruments.unwrap_or_else(|| "null".to_owned());
    format!(
        "{{\"bed\": {}, \"{}\": {}, \"imbalance\": {}, \"sensed_error\": {}, \"valid\": {}, \"sensors\": {sensors}, \"instruments\": {instruments}, \
         \"policy\": {}, \"supervised\": {}, \"moves\": {}, {}{}, \"note\": {}}}\n",
        json_string(&read.plan.title),
        moments(history),
        history.moments.len(),
        json_number(imbalance),
        json_number(felt),
        is_valid([imbalance, felt], sensed.as_ref()),
        read.policy.map_or_else(|| "null".to_owned(), |policy| json_string(policy.name)),
        read.is_supervised,
        history.moves.len(),
        history.watched.as_ref().map_or_else(String::new, motion_json),
        lists.join(", "),
        json_string(DISCLAIMER)
    )
}

/// What the moments of a run are.
fn moments(history: &History) -> &'static str {
    if history.watched.is_some() { "moments" } else { "equilibria" }
}

/// What motion adds to the JSON object.
fn motion_json(watched: &Watched) -> String {
    format!(
        "\"step\": {}, \"steps\": {}, \"peak_force\": {}, \"peak_time\": {}, \"still\": {}, \"touches\": {}, \
         \"energy_handed_on\": {}, \"energy_lost\": {}, \"energy_turned\": {}, \"energy_left_over\": {}, ",
        json_number(watched.step),
        watched.steps,
        json_number(watched.peak),
        json_number(watched.peak_time),
        watched.still.map_or_else(|| "null".to_owned(), json_number),
        watched.blows.touches,
        json_number(watched.blows.handed_on),
        json_number(watched.lost),
        json_number(watched.turned),
        json_number(watched.left_over)
    )
}

/// What motion adds for people.
fn motion_text(watched: &Watched) -> String {
    let rest = watched.still.map_or_else(
        || "it is not at rest at the end".to_owned(),
        |time| format!("slower than 1 mm/s from {time:.2} s on"),
    );
    format!(
        "motion: {} steps of {:.4} ms; the largest force over 10 ms is {:.0} N at {:.3} s; {rest}; {} touches \
         hand on {:.3} J; {:.3} J are lost, {:.1e} J left over\n",
        watched.steps,
        1e3 * watched.step,
        watched.peak,
        watched.peak_time,
        watched.blows.touches,
        watched.blows.handed_on,
        watched.lost,
        watched.left_over
    )
}

/// More of the energy that moved or was lost than this is left over: steps are too long.
const OPEN: f64 = 0.05;
/// Energy (J) that no run is blamed for.
const LITTLE: f64 = 1e-3;

/// For people.
fn text(read: &Read, history: &History) -> String {
    let [imbalance, felt] = validity(history);
    let mut text = format!(
        "{}: {} {} over {} s; contact forces carry the weight to {imbalance:.0e}, sensels feel it to {:.2} %\n",
        read.plan.title,
        history.moments.len(),
        moments(history),
        read.plan.seconds,
        100.0 * felt
    );
    if let Some(watched) = &history.watched {
        text += &motion_text(watched);
    }
    if let Some(policy) = read.policy {
        let through =
            if read.is_supervised { ", let through by the tiles' controller and its supervisor" } else { "" };
        let _ = writeln!(text, "policy {}: {} moves{through}", policy.name, history.moves.len());
    }
    let sensed = sensed(read, history);
    if let Some(sensing::Read { grid: [rows, columns], error, skin, mass }) = &sensed {
        let _ = writeln!(
            text,
            "{rows} x {columns} sensors of {mass:.3} kg in all read the last map to {:.2} %, moisture {:.1} %, pH {:.2}",
            100.0 * error,
            skin[0],
            skin[1]
        );
    }
    if let Some(own) = read.instruments {
        text += &readings::text(&own.of(&read.plan, history));
    }
    if history.watched.as_ref().is_some_and(|w| w.left_over > LITTLE.max(OPEN * w.lost.max(w.kinetic))) {
        let limit = 100.0 * OPEN;
        let _ = writeln!(
            text,
            "NOT CLOSED: more than {limit} % of the energy that moved is left over; shorter steps, `dynamics.step`"
        );
    }
    if !is_valid([imbalance, felt], sensed.as_ref()) {
        text += "NOT VALID: what is felt or read is more than 1 % off\n";
    }
    text += &table(&metrics(read, history));
    let _ = writeln!(text, "\n{DISCLAIMER}");
    text
}
