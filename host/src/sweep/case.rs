//! One case of a sweep: its settings, its file, its row of the table.
//!
//! A result records what it was made from ([`Origin`]); a file of another plan, mesh, version or setting does not count
//! as done.

use crate::bed::report::RunReport;
use crate::csv;
use crate::failure::Failure;
use crate::input;
use crate::number::{json_number_or_word, json_string};
use crate::origin::{Meshes, Origin, seeds_json};
use crate::plan::Axes;
use crate::plan_file::PlanFile;
use crate::world::read::settings;
use smartbed_bed::plan::history::RunError;
use std::path::{Path, PathBuf};

/// Most cases of a sweep.
const MOST: usize = 1_000_000;

/// A case.
#[derive(Clone, Debug)]
pub struct Case {
    /// Index from 0; the last key of the sweep changes fastest.
    pub number: usize,
    plan: PlanFile,
    /// All settings: those of the command line, then the sweep's.
    origin: Origin,
    /// Values of the sweep's keys.
    values: Vec<(String, String)>,
}

/// All cases of a plan.
pub fn cases(name: &str, plan: &PlanFile, settings: &[String], axes: &Axes) -> Result<Vec<Case>, Failure> {
    if axes.is_empty() {
        return Err(Failure::Wrong(format!(
            "{name}: it has no [sweep]; add for example [sweep] with \"patient.mass\" = [\"60_kg\", \"75_kg\"]"
        )));
    }
    let count =
        axes.iter().try_fold(1_usize, |n, (_, values)| n.checked_mul(values.len())).unwrap_or(MOST + 1);
    if count > MOST {
        return Err(Failure::Wrong(format!("{name}: its [sweep] has more than {MOST} cases")));
    }
    refuse_overlaps(name, settings, axes)?;
    let mut meshes = Meshes::new();
    let one = |number: usize| {
        let (mut rest, mut values) = (number, Vec::new());
        for (key, known) in axes.iter().rev() {
            values.push((key.clone(), known[rest % known.len()].clone()));
            rest /= known.len();
        }
        values.reverse();
        let swept = values.iter().map(|(key, value)| format!("{key}={value}"));
        let settings = settings.iter().cloned().chain(swept).collect();
        let origin = Origin::new(format!("smartbed sweep {name}"), plan, settings, &mut meshes);
        Case { number, plan: plan.clone(), origin, values }
    };
    Ok((0..count).map(one).collect())
}

/// Refuses settings and keys of the sweep of which one replaces another.
fn refuse_overlaps(name: &str, settings: &[String], axes: &Axes) -> Result<(), Failure> {
    let paths: Vec<_> = axes.iter().map(|(key, _)| settings::path(&format!("{key}=0"))).collect();
    for (n, ((key, _), axis)) in axes.iter().zip(&paths).enumerate() {
        let is_replaced = |setting: &&String| {
            settings::path(setting).is_some_and(|own| settings::replaces(axis.as_ref(), &own))
        };
        if let Some(setting) = settings.iter().find(is_replaced) {
            return Err(Failure::Wrong(format!(
                "--set {setting}: the [sweep] gives this key its values in every case; leave the setting out, or change the list in the plan"
            )));
        }
        let first = (0..n)
            .find(|&first| paths[first].as_ref().is_some_and(|own| settings::replaces(axis.as_ref(), own)));
        if let Some(first) = first {
            return Err(Failure::Wrong(format!(
                "{name}: `{key}` in [sweep] replaces `{}`; leave one of them out, or give the whole table first",
                axes[first].0
            )));
        }
    }
    Ok(())
}

/// Refuses a key of the sweep that no case has, before any of them is computed. A key may belong to some cases only,
/// as the radius of a ball does where the shape of the load is swept, too.
pub fn refuse_unknown(name: &str, all: &[Case], axes: &Axes) -> Result<(), Failure> {
    for (key, _) in axes {
        let unknown: Option<Vec<String>> =
            all.iter().map(|case| case.plan.unknown(&case.origin.settings, key)).collect();
        if let Some(why) = unknown.as_ref().and_then(|all| all.first()) {
            return Err(Failure::Wrong(format!("{name}: `{key}` in [sweep]: {why}")));
        }
    }
    Ok(())
}

impl Case {
    /// Its file.
    pub fn file(&self, folder: &Path) -> PathBuf {
        file_of(folder, self.number)
    }

    /// Does its file exist, made from this plan and version?
    pub fn is_done(&self, folder: &Path) -> bool {
        std::fs::read_to_string(self.file(folder))
            .is_ok_and(|text| text.starts_with(&self.head()) && text.ends_with("}\n"))
    }

    /// The beginning of its file.
    fn head(&self) -> String {
        format!("{{{}", self.origin.json())
    }

    /// The origin of all cases, for their table: version, command, hashes, settings other than those of the sweep,
    /// seeds.
    #[cfg(feature = "parquet")]
    pub fn made_from(&self) -> Vec<(&'static str, String)> {
        let settings = &self.origin.settings;
        let own = &settings[..settings.len() - self.values.len()];
        let mut pairs = self.origin.pairs();
        pairs.push(("settings", crate::origin::list(own)));
        pairs.push(("note", smartbed_bed::metrics::DISCLAIMER.to_owned()));
        if let Ok(read) = self.plan.read(own) {
            pairs
                .extend(crate::origin::seeds(&read).into_iter().map(|(name, seed)| (name, seed.to_string())));
        }
        pairs
    }

    /// Runs it; returns the text of its file. A case that is refused, or comes to no equilibrium, has the reason as
    /// its result.
    pub fn compute(&self) -> Result<String, Failure> {
        let read = match self.plan.read(&self.origin.settings) {
            Ok(read) => read,
            Err(Failure::Lacking(what)) => return Err(Failure::Lacking(what)),
            Err(failure) => return Ok(self.refused(&self.plan.refusal(&failure))),
        };
        let history = match read.run(|_| !crate::interrupt::is_asked()) {
            Ok(history) => history,
            Err(RunError::Stopped) => return Err(Failure::Wrong("interrupted".to_owned())),
            Err(error) => return Ok(self.refused(&error.to_string())),
        };
        let mut rows = Vec::new();
        let report = RunReport::new(&read, &history);
        // A sweep compares whole beds; rows of single tiles are left to the reports.
        for (sites, list) in &report.lists[..3] {
            for row in list {
                let name = json_string(&format!("{sites} {} {} ({})", row.place, row.metric, row.unit));
                rows.push(format!(
                    "{name}: {}",
                    row.value.map_or_else(|| "null".to_owned(), json_number_or_word)
                ));
            }
        }
        Ok(format!(
            "{}\"seeds\": {}, \"valid\": {}, \"over_pressure\": {}, \"metrics\": {{{}}}, \"note\": {}}}\n",
            self.head(),
            seeds_json(&read),
            smartbed_bed::plan::states::is_valid(&report.gate),
            smartbed_bed::plan::states::over(&read.plan, &history).is_some(),
            rows.join(", "),
            json_string(smartbed_bed::metrics::DISCLAIMER)
        ))
    }

    /// Its file if it is refused.
    fn refused(&self, why: &str) -> String {
        let (head, why) = (self.head(), json_string(why));
        let note = json_string(smartbed_bed::metrics::DISCLAIMER);
        format!("{head}\"valid\": false, \"refused\": {why}, \"metrics\": {{}}, \"note\": {note}}}\n")
    }
}

/// The column that says why a case is refused, empty for all others.
pub const REFUSED: &str = "refused";

/// The table of all cases: a column for each key of the sweep and each metric that occurs.
#[derive(Clone, Debug)]
pub struct Table {
    /// Keys of the sweep; if cases are refused, also [`REFUSED`].
    pub keys: Vec<String>,
    /// Metrics.
    pub metrics: Vec<String>,
    /// Values of the keys and of the metrics, case by case; empty where a case has no such metric.
    pub rows: Vec<[Vec<String>; 2]>,
    /// Number of cases that are refused.
    pub refused: usize,
    /// Numbers of the cases, from 1, whose energies do not close, and of those with more pressure than bladders may
    /// have.
    pub doubtful: [Vec<usize>; 2],
}

impl Table {
    /// Reads the files of all cases.
    pub fn read(all: &[Case], folder: &Path) -> Result<Table, Failure> {
        let (mut read, mut metrics, mut doubtful) = (Vec::new(), Vec::new(), [Vec::new(), Vec::new()]);
        for case in all {
            let file = case.file(folder);
            let text =
                input::text(&file.display().to_string()).map_err(|e| format!("{}: {e}", file.display()))?;
            let value: serde_json::Value =
                serde_json::from_str(&text).map_err(|e| format!("{}: {e}", file.display()))?;
            let is_refused = value[REFUSED].is_string();
            for (list, holds) in
                doubtful.iter_mut().zip([value["valid"] == false, value["over_pressure"] == true])
            {
                list.extend((holds && !is_refused).then_some(case.number + 1));
            }
            let own = value["metrics"].as_object().cloned().unwrap_or_default();
            for name in own.keys().filter(|name| !metrics.contains(*name)).cloned().collect::<Vec<String>>() {
                metrics.push(name);
            }
            read.push((own, value[REFUSED].as_str().map(str::to_owned)));
        }
        let refused = read.iter().filter(|(_, why)| why.is_some()).count();
        let row = |(case, (own, why)): (&Case, &(serde_json::Map<String, serde_json::Value>, _))| {
            let why: &Option<String> = why;
            let why = (refused > 0).then(|| why.clone().unwrap_or_default());
            let values = case.values.iter().map(|(_, value)| value.trim_matches('"').to_owned()).chain(why);
            let number = |name: &String| match own.get(name) {
                Some(serde_json::Value::Number(x)) => x.to_string(),
                Some(serde_json::Value::String(word)) => word.clone(),
                _ => String::new(),
            };
            [values.collect(), metrics.iter().map(number).collect()]
        };
        let rows = all.iter().zip(&read).map(row).collect();
        let keys = all.first().map_or(&[][..], |case| &case.values).iter().map(|(key, _)| key.clone());
        let keys = keys.chain((refused > 0).then(|| REFUSED.to_owned())).collect();
        Ok(Table { keys, metrics, rows, refused, doubtful })
    }

    /// As CSV.
    pub fn csv(&self) -> String {
        let quoted = |text: &String| csv::quoted(text);
        let head =
            std::iter::once("case".to_owned()).chain(self.keys.iter().chain(&self.metrics).map(quoted));
        let mut text = head.collect::<Vec<_>>().join(",") + "\n";
        for (number, [values, numbers]) in self.rows.iter().enumerate() {
            let values = values.iter().map(quoted).chain(numbers.iter().cloned());
            let cells = std::iter::once((number + 1).to_string()).chain(values);
            text += &(cells.collect::<Vec<_>>().join(",") + "\n");
        }
        text
    }
}

/// File of a case.
pub(super) fn file_of(folder: &Path, number: usize) -> PathBuf {
    folder.join(format!("case_{:05}.json", number + 1))
}
