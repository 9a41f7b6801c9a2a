//! The data of a report: subjects with their points, extra tables, and the machine on which all was measured.
//!
//! A point is one run: its error against the subject's reference and its cost. Points and tables may also come from
//! elsewhere, for example from other simulators: [`Extras`] are read from JSON.

use crate::failure::Failure;
use serde_json::Value;
use std::collections::BTreeSet;

/// The parameter that sets the accuracy of a run.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Control {
    /// Fixed step (s).
    Step(f64),
    /// Error allowed per step of an adaptive method.
    Tolerance(f64),
}

impl Control {
    /// As options of the command line.
    #[must_use]
    pub fn options(self) -> String {
        match self {
            Self::Step(h) => format!("--step {h:e}"),
            Self::Tolerance(e) => format!("--tolerance {e:e}"),
        }
    }

    /// For a table.
    #[must_use]
    pub fn text(self) -> String {
        match self {
            Self::Step(h) => format!("{h:.3e} s"),
            Self::Tolerance(e) => format!("tol {e:.0e}"),
        }
    }
}

/// One run.
#[derive(Clone, PartialEq, Debug)]
pub struct Point {
    /// Method, or the name of another simulator.
    pub method: String,
    /// Scalar: f64 or f32.
    pub scalar: String,
    /// Step or tolerance; `None` if another simulator does not state it.
    pub control: Option<Control>,
    /// Largest error of a coordinate at any sample (m or rad).
    pub error: f64,
    /// Evaluations of all forces per simulated second, if counted.
    pub evaluations: Option<f64>,
    /// Computing time per simulated second (ns).
    pub nanoseconds: f64,
    /// On the Pareto front: no other point of the subject dominates it.
    pub front: bool,
    /// Does it belong to another simulator?
    pub is_peer: bool,
    /// The command that reproduces these numbers.
    pub command: String,
}

/// The reference solution for errors.
#[derive(Clone, PartialEq, Debug)]
pub struct Reference {
    /// How it was made.
    pub text: String,
    /// Largest difference to a second, independent reference (m or rad): smaller errors are meaningless.
    pub agreement: f64,
}

impl Reference {
    /// The smallest meaningful error (m or rad): below it points cannot be ranked.
    #[must_use]
    pub fn certainty(&self) -> f64 {
        self.agreement.max(f64::EPSILON)
    }
}

/// A method's cost on the chip.
#[derive(Clone, PartialEq, Debug)]
pub struct ChipCost {
    /// Method.
    pub method: String,
    /// Instructions of the median step.
    pub instructions: u64,
    /// Cycles of the median step, as an interval of the model.
    pub cycles: [u64; 2],
    /// Flash (bytes).
    pub flash: u64,
    /// Static RAM (bytes).
    pub ram: u64,
    /// Upper bound of the stack (bytes).
    pub stack: u64,
    /// The command that reproduces these numbers.
    pub command: String,
}

/// A scene, a mechanism or a world with its points.
#[derive(Clone, PartialEq, Debug)]
pub struct Section {
    /// Its name under models/ or models/scenes/.
    pub name: String,
    /// One line about it.
    pub title: String,
    /// Simulated time (s).
    pub seconds: f64,
    /// Simulated time stated in its file (s).
    pub asked: f64,
    /// The reference solution.
    pub reference: Reference,
    /// Size of the motion: the largest change of a coordinate (m or rad).
    pub extent: f64,
    /// All runs.
    pub points: Vec<Point>,
    /// What could not be measured, and why.
    pub notes: Vec<String>,
    /// Costs on the chip.
    pub chip: Vec<ChipCost>,
    /// Motion and energies at its own settings, as SVG.
    pub graph: String,
}

/// A table of text.
#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    /// What it shows.
    pub title: String,
    /// Heads of the columns.
    pub columns: Vec<String>,
    /// Rows of as many cells.
    pub rows: Vec<Vec<String>>,
    /// The command that makes it.
    pub command: String,
}

/// All data of a report.
#[derive(Clone, PartialEq, Debug)]
pub struct Report {
    /// Name of the processor.
    pub machine: String,
    /// The command that makes the report.
    pub command: String,
    /// The engine that evaluates mechanisms.
    pub engine: String,
    /// Source of the costs on the chip, or why there are none.
    pub chip: String,
    /// Computing time of the report itself (s).
    pub elapsed: f64,
    /// Scenes and mechanisms.
    pub sections: Vec<Section>,
    /// Further tables.
    pub tables: Vec<Table>,
}

/// Points and tables from elsewhere.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Extras {
    /// Subject, its simulated time (s) if stated, and point.
    pub points: Vec<(String, Option<f64>, Point)>,
    /// Tables.
    pub tables: Vec<Table>,
}

impl Extras {
    /// Reads a JSON text: `{"points": [{"subject", "seconds", "method", "scalar", "step", "error", "nanoseconds",
    /// "evaluations", "command"}], "tables": [{"title", "columns", "rows", "command"}]}`; seconds, scalar, step and
    /// evaluations are optional, and points with `"peer": false` are ignored.
    ///
    /// # Errors
    /// [`Failure::Wrong`] with the place of the first entry that lacks something.
    pub fn read(file: &str, text: &str) -> Result<Self, Failure> {
        let wrong = |why: String| Failure::Wrong(format!("--points {file}: {why}"));
        let value: Value = serde_json::from_str(text).map_err(|e| wrong(format!("not JSON: {e}")))?;
        let list = |key: &str| value[key].as_array().cloned().unwrap_or_default();
        let mut extras = Self::default();
        // Our own points in a report are measured anew here, and are not those of a peer.
        let points = list("points").into_iter().filter(|entry| entry["peer"] != Value::Bool(false));
        for (n, entry) in points.collect::<Vec<Value>>().iter().enumerate() {
            let expected = "expected subject, method, command as text and error, nanoseconds, where given also seconds, step and \
                 tolerance, as numbers above 0";
            extras.points.push(read_point(entry).ok_or_else(|| wrong(format!("points[{n}]: {expected}")))?);
        }
        for (n, entry) in list("tables").iter().enumerate() {
            let expected = "expected title and command as text, columns and rows of as many texts";
            extras.tables.push(read_table(entry).ok_or_else(|| wrong(format!("tables[{n}]: {expected}")))?);
        }
        Ok(extras)
    }

    /// The simulated time (s) of the first point of a subject that states it.
    #[must_use]
    pub fn seconds(&self, subject: &str) -> Option<f64> {
        self.points.iter().find_map(|(name, seconds, _)| seconds.filter(|_| name == subject))
    }
}

impl Report {
    /// Adds them, with their errors raised to the reference's certainty like our own. Points of subjects that are not
    /// in the report are left out, and their subjects returned; so are those over another simulated time, with a note.
    pub fn add(&mut self, extras: Extras) -> BTreeSet<String> {
        let mut unknown = BTreeSet::new();
        for (subject, seconds, mut point) in extras.points {
            let Some(section) = self.sections.iter_mut().find(|s| s.name == subject) else {
                unknown.insert(subject);
                continue;
            };
            let other = seconds.filter(|s| (s / section.seconds - 1.0).abs() > SAME_TIME);
            match other
                .map(|s| format!("{}: left out, over {s} s and not {} s", point.method, section.seconds))
            {
                None => {
                    point.error = point.error.max(section.reference.certainty());
                    section.points.push(point);
                }
                Some(note) if !section.notes.contains(&note) => section.notes.push(note),
                Some(_) => {}
            }
        }
        self.tables.extend(extras.tables);
        unknown
    }
}

/// Relative difference up to which two simulated times count as equal.
const SAME_TIME: f64 = 1e-9;

fn read_point(entry: &Value) -> Option<(String, Option<f64>, Point)> {
    let word = |key: &str| Some(entry[key].as_str()?.to_owned());
    let number = |key: &str| entry[key].as_f64().filter(|x| *x > 0.0 && x.is_finite());
    if ["seconds", "step", "tolerance"].iter().any(|key| !entry[*key].is_null() && number(key).is_none()) {
        return None;
    }
    let point = Point {
        method: word("method")?,
        scalar: word("scalar").unwrap_or_else(|| "f64".to_owned()),
        control: number("step").map(Control::Step).or(number("tolerance").map(Control::Tolerance)),
        error: number("error")?,
        evaluations: number("evaluations"),
        nanoseconds: number("nanoseconds")?,
        front: false,
        is_peer: true,
        command: word("command")?,
    };
    Some((word("subject")?, number("seconds"), point))
}

fn read_table(entry: &Value) -> Option<Table> {
    let words = |v: &Value| -> Option<Vec<String>> {
        v.as_array()?.iter().map(|w| Some(w.as_str()?.to_owned())).collect()
    };
    let columns = words(&entry["columns"])?;
    let rows: Vec<Vec<String>> = entry["rows"].as_array()?.iter().map(words).collect::<Option<_>>()?;
    if rows.iter().any(|r| r.len() != columns.len()) {
        return None;
    }
    let word = |key: &str| Some(entry[key].as_str()?.to_owned());
    Some(Table { title: word("title")?, columns, rows, command: word("command")? })
}
