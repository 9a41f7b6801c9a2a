//! `smartbed sweep`: runs a plan for every combination of the values in its `[sweep]`.
//!
//! In: a plan. Out: a folder with one file per case and, once all exist, a table of all. Cases are distributed over all
//! processors and computed independently, so that a file does not depend on the number of processors. Files appear only
//! when complete, and a case whose file exists is not computed again. A shard takes every n-th case.

mod case;
mod page;
#[cfg(feature = "parquet")]
mod parquet;

use crate::failure::Failure;
use crate::plan_file::PlanFile;
use crate::progress::Progress;
use crate::{diagnostics, interrupt, output};
use case::{Case, Table, cases, refuse_unknown};
use smartbed_bed::equilibrium::side_by_side;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Most cases that a warning names.
const NAMED: usize = 6;

/// Run a plan of the bed for every combination of the values in its `[sweep]`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:
  cargo smartbed sweep ball_on_four -o sweep
  cargo smartbed sweep ball_on_four -o sweep --shard 2/4
  cargo smartbed sweep ball_on_four -o sweep --merge --page sweep.html
  cargo smartbed sweep ball_on_four -o sweep --json")]
pub struct Arguments {
    /// The plan: a path, or a name under models/plans.
    pub plan: String,
    /// Folder for the results, one file per case. A case whose file exists is not computed again.
    #[arg(short, long, value_name = "FOLDER", default_value = "sweep")]
    pub output: String,
    /// Compute only shard I of N (1 <= I <= N), which is every N-th case, to spread a sweep over several machines
    /// [default: all cases].
    #[arg(long, value_name = "I/N")]
    pub shard: Option<String>,
    /// Compute nothing; write the table from the results in the folder. Refused while cases are missing.
    #[arg(long)]
    pub merge: bool,
    /// Write a page for the browser that compares all cases, once all are computed.
    #[arg(long, value_name = "FILE.html")]
    pub page: Option<String>,
    /// Also write the table as Parquet, once all cases are computed. Only in a program built with the feature
    /// `parquet`.
    #[arg(long, value_name = "FILE.parquet")]
    pub parquet: Option<String>,
    /// Number of processors to use [default: all].
    #[arg(long, value_name = "COUNT")]
    pub cores: Option<usize>,
    /// Change a key of the plan; may be repeated. Keys that `[sweep]` varies are refused.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Print the file of the table and the numbers of cases as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong plan or shard, a key that no case has, a folder that cannot be written, and if every case is
/// refused, whose table is written.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.parquet.is_some() && !cfg!(feature = "parquet") {
        let what = "--parquet: this program was built without it; build it with --features parquet";
        return Err(Failure::Wrong(what.to_owned()));
    }
    if arguments.cores == Some(0) {
        return Err(Failure::Wrong("--cores 0: expected at least 1".to_owned()));
    }
    let plan = PlanFile::open(&arguments.plan)?;
    let read = plan.read(&arguments.set)?;
    diagnostics::warn(&read.warnings);
    let axes = read.axes;
    let all = cases(&arguments.plan, &plan, &arguments.set, &axes)?;
    refuse_unknown(&arguments.plan, &all, &axes)?;
    let folder = Path::new(&arguments.output);
    std::fs::create_dir_all(folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    let table = folder.join("sweep.csv");
    let files = all.iter().map(|case| case.file(folder)).chain([table.clone()]);
    output::clear(folder, &files.filter_map(|file| Some(file.file_stem()?.to_owned())).collect());
    if !arguments.merge {
        let (index, count) = shard(arguments.shard.as_deref())?;
        let own: Vec<&Case> = all.iter().filter(|case| case.number % count == index).collect();
        compute(&own, folder, arguments.cores)?;
    }
    let missing = all.iter().filter(|case| !case.is_done(folder)).count();
    if missing > 0 {
        let words = smartbed_codegen::words::count(missing, "case");
        return match arguments.merge {
            true => Err(Failure::Wrong(format!("{}: {words} of {} missing", arguments.output, all.len()))),
            false if arguments.json => output::print(&summary(None, [all.len(), missing, 0])),
            false => output::print(&format!(
                "{}: {words} of {} left to other shards\n",
                arguments.output,
                all.len()
            )),
        };
    }
    let found = Table::read(&all, folder)?;
    output::replace(&table, &found.csv())?;
    if let Some(page) = &arguments.page {
        output::replace(Path::new(page), &page::text(&arguments.plan, &found))?;
    }
    if let Some(file) = &arguments.parquet {
        write_parquet(file, &found, &all)?;
    }
    let why = [
        "NOT VALID: work and energy do not agree; a smaller dynamics.step, or see `bed run` of the case",
        "with a bladder above `bed.most_pressure`; a lower order, or regulated air",
    ];
    for (cases, why) in found.doubtful.iter().zip(why).filter(|(cases, _)| !cases.is_empty()) {
        let names: Vec<String> = cases.iter().map(usize::to_string).collect();
        let names = smartbed_codegen::words::first_of(&names, NAMED);
        output::say(&format!("warning: {}: case {names}: {why}", table.display()));
    }
    if found.refused == all.len() {
        let words = smartbed_codegen::words::count(all.len(), "case");
        let first = found.rows.first().and_then(|[values, _]| values.last()).map_or("", String::as_str);
        return Err(Failure::Wrong(format!(
            "{}: {words}, all of them refused: the column `{}` says why; the first: {first}",
            table.display(),
            case::REFUSED
        )));
    }
    if arguments.json {
        return output::print(&summary(Some(&table), [all.len(), 0, found.refused]));
    }
    let refused = match found.refused {
        0 => String::new(),
        count => format!(", {count} of them refused: the column `{}` says why", case::REFUSED),
    };
    let words = smartbed_codegen::words::count(all.len(), "case");
    output::print(&format!("{}: {words}{refused}\n", table.display()))
}

/// One JSON object: the table, once it is written, and the numbers of cases, of those left to other shards, and of
/// those refused.
fn summary(table: Option<&Path>, [cases, left, refused]: [usize; 3]) -> String {
    let table = table.map(|file| file.display().to_string());
    format!("{}\n", serde_json::json!({ "table": table, "cases": cases, "left": left, "refused": refused }))
}

/// The table as Parquet.
#[cfg(feature = "parquet")]
fn write_parquet(file: &str, table: &Table, all: &[Case]) -> Result<(), Failure> {
    let pairs = all.first().map_or_else(Vec::new, Case::made_from);
    let bytes = parquet::bytes(table, &pairs).map_err(|e| format!("{file}: {e}"))?;
    output::replace_bytes(Path::new(file), &bytes)
}

#[cfg(not(feature = "parquet"))]
fn write_parquet(_: &str, _: &Table, _: &[Case]) -> Result<(), Failure> {
    Ok(())
}

/// Parses `2/4`: the second of four shards, counted from 0.
fn shard(text: Option<&str>) -> Result<(usize, usize), Failure> {
    let Some(text) = text else { return Ok((0, 1)) };
    let parts =
        text.split_once('/').and_then(|(i, n)| Some((i.parse::<usize>().ok()?, n.parse::<usize>().ok()?)));
    match parts {
        Some((index, count)) if index >= 1 && index <= count => Ok((index - 1, count)),
        _ => Err(Failure::Wrong(format!("--shard {text}: expected I/N with I from 1 to N, for example 2/4"))),
    }
}

/// Computes the cases whose files do not exist.
fn compute(own: &[&Case], folder: &Path, cores: Option<usize>) -> Result<(), Failure> {
    interrupt::watch();
    let open: Vec<&&Case> = own.iter().filter(|case| !case.is_done(folder)).collect();
    let cores = cores.unwrap_or_else(side_by_side::cores);
    let (done, progress) = (AtomicUsize::new(0), Mutex::new(Progress::new("sweep")));
    let found = side_by_side::run_by(open.len(), cores, |index| {
        if interrupt::is_asked() {
            return Ok(());
        }
        let result = open[index].compute().and_then(|text| output::replace(&open[index].file(folder), &text));
        let done = 1 + done.fetch_add(1, Ordering::Relaxed);
        if let Ok(mut progress) = progress.lock() {
            progress.at(done as f64 / open.len() as f64);
        }
        result
    });
    // The failed case of lowest number, whichever failed first in time.
    let failed = open.iter().zip(found).find_map(|(case, result)| Some((case.number, result.err()?)));
    match failed {
        Some((number, failure)) => Err(Failure::Wrong(format!("case {}: {failure}", number + 1))),
        None if interrupt::is_asked() => {
            let left = open.iter().filter(|case| !case.is_done(folder)).count();
            Err(Failure::Wrong(format!(
                "interrupted; {left} cases are left, the same command goes on with them"
            )))
        }
        None => Ok(()),
    }
}
