//! `smartbed bed`: runs a plan of the bed, writes a page of it, and reads maps recorded elsewhere.
//!
//! In: a plan, or a file of maps. Out: metrics as a table, as CSV or as one JSON object; maps in formats of sensor
//! makers; a page.

mod film;
mod map;
mod page;
mod readings;
pub(crate) mod report;
mod rows;
mod said;
mod words;

use crate::diagnostics;
use crate::failure::Failure;
use crate::interrupt;
use crate::origin::{Meshes, Origin};
use crate::output;
use crate::plan::Read;
use crate::plan_file::PlanFile;
use crate::progress::Progress;
use report::RunReport;
use rows::{csv, write};
use smartbed_bed::files::Mapped;
use smartbed_bed::plan::history::{History, RunError};
use smartbed_bed::plan::readings::Reading;
use smartbed_bed::plan::states;

/// Run a plan of the bed, write a page of it, or evaluate recorded pressure maps.
#[derive(clap::Args, Clone, Debug)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand, Clone, Debug)]
enum Command {
    /// Run a plan: the bed's equilibria (or its motion) over time; print all metrics.
    #[command(after_help = "Examples:
  cargo smartbed bed run alternating
  cargo smartbed bed run ball_on_four --set load.mass=8_kg --csv metrics.csv --map map.csv")]
    Run(Run),
    /// Run a plan and write a page for the browser: pressure map, tiles, time slider, metrics.
    #[command(after_help = "Examples:
  cargo smartbed bed report alternating -o alternating.html
  cargo smartbed bed report alternating --json")]
    Report(Page),
    /// Compute all metrics of pressure maps that were recorded elsewhere: Tekscan's ASCII or XSENSOR's CSV.
    #[command(after_help = "Examples:
  cargo smartbed bed map session.asf
  cargo smartbed bed map session.asf --against simulated.csv -o session.csv
  cargo smartbed bed map session.asf --json")]
    Map(map::Map),
}

/// What `bed run` takes.
#[derive(clap::Args, Clone, Debug)]
pub struct Run {
    /// The plan: a path, or a name under models/plans.
    pub plan: String,
    /// Change a key of the plan; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Write the metrics as CSV to this file; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,
    /// Write the pressure maps over time to this file: .csv in XSENSOR's format, .asf in Tekscan's.
    #[arg(long, value_name = "FILE")]
    pub map: Option<String>,
    /// Write the readings of the plan's `[instruments]` as CSV to this file; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub readings: Option<String>,
    /// Print the result as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// What `bed report` takes.
#[derive(clap::Args, Clone, Debug)]
pub struct Page {
    /// The plan: a path, or a name under models/plans.
    pub plan: String,
    /// Change a key of the plan; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// File for the page.
    #[arg(short, long, value_name = "FILE", default_value = "bed.html")]
    pub output: String,
    /// Print the name of the page and the metrics, as `bed run` does, as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong plan, and for one that does not converge to equilibrium.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.command {
        Command::Run(asked) => {
            let (origin, read) = opened("run", &asked.plan, &asked.set)?;
            let to = |file: &Option<String>| file.as_deref() == Some("-");
            let results =
                [("--csv -", to(&asked.csv)), ("--readings -", to(&asked.readings)), ("--json", asked.json)];
            output::one_in_standard_output(&results)?;
            let files = [
                ("--csv", asked.csv.as_deref()),
                ("--map", asked.map.as_deref()),
                ("--readings", asked.readings.as_deref()),
            ];
            output::replace_none(&files, &[&asked.plan])?;
            writable(asked, &read)?;
            let history = history(&read)?;
            let report = RunReport::new(&read, &history);
            if let Some(file) = &asked.csv {
                write(file, &csv(&report.lists))?;
            }
            if let Some(file) = &asked.map {
                write(file, &maps(file, &read, &history)?)?;
            }
            if let Some(file) = &asked.readings {
                write(file, &readings::csv(&read_off(&read, &history)))?;
            }
            if [&asked.csv, &asked.readings].iter().any(|file| file.as_deref() == Some("-")) {
                return Ok(());
            }
            output::print(&match asked.json {
                true => said::json(&origin, None, &read, &history, &report),
                false => said::text(&read, &history, &report),
            })
        }
        Command::Report(asked) => {
            output::one_in_standard_output(&[("--output -", asked.output == "-"), ("--json", asked.json)])?;
            output::replace_none(&[("--output", Some(&asked.output))], &[&asked.plan])?;
            let (origin, read) = opened("report", &asked.plan, &asked.set)?;
            let history = history(&read)?;
            let report = RunReport::new(&read, &history);
            write(&asked.output, &page::text(&origin, &read, &history, &report))?;
            output::print(&match asked.json {
                true => said::json(&origin, Some(&asked.output), &read, &history, &report),
                false => format!("{}: {}\n", asked.output, read.plan.title),
            })
        }
        Command::Map(asked) => map::run(asked),
    }
}

/// Refuses before a run what could not be written after it.
fn writable(asked: &Run, read: &Read) -> Result<(), Failure> {
    if let Some(file) = &asked.map {
        map::ending(file)?;
    }
    match &asked.readings {
        Some(file) if read.instruments.is_none() => {
            Err(Failure::Wrong(format!("--readings {file}: the plan has no [instruments]")))
        }
        _ => Ok(()),
    }
}

/// The plan of a command, and the origin of its results.
fn opened(does: &str, plan: &str, settings: &[String]) -> Result<(Origin, Read), Failure> {
    let file = PlanFile::open(plan)?;
    let command = format!("smartbed bed {does} {plan}");
    let origin = Origin::new(command, &file, settings.to_vec(), &mut Meshes::new());
    let read = file.read(settings)?;
    diagnostics::warn(&read.warnings);
    Ok((origin, read))
}

fn history(read: &Read) -> Result<History, Failure> {
    interrupt::watch();
    let mut progress = Progress::new(&read.plan.title);
    let on = |done: f64| {
        progress.at(done);
        !interrupt::is_asked()
    };
    let history = read.run(on).map_err(|error| match error {
        RunError::Stopped => Failure::Wrong("interrupted: nothing is written".to_owned()),
        other => Failure::Wrong(format!("{}: {other}", read.plan.title)),
    })?;
    if let Some(over) = states::over(&read.plan, &history) {
        let most = 1e-3 * read.plan.layout.most_pressure;
        output::say(&format!(
            "warning: {}: {over}, expected at most {most:.2} kPa, `bed.most_pressure`; a lower order, or regulated air",
            read.plan.title
        ));
    }
    Ok(history)
}

/// Readings of the tiles' instruments.
fn read_off(read: &Read, history: &History) -> Vec<Reading> {
    read.instruments.map(|own| own.of(&read.plan, history)).unwrap_or_default()
}

/// Maps over time in the format given by the file's ending, as forces over nominal cells; if the plan has sensors, as
/// they read them.
fn maps(file: &str, read: &Read, history: &History) -> Result<String, Failure> {
    let recording = match &read.sensors {
        Some(sensors) => sensors.reader.recording(&history.sensels).map_err(|e| format!("{file}: {e}"))?,
        None => history.sensels.clone(),
    };
    let recording = history.over_cells(&recording).map_err(|e| format!("{file}: {e}"))?;
    map::encoded(file, &Mapped { grid: history.grid, recording })
}
