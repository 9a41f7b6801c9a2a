//! The equilibrium found and its modes, as text and as JSON.

use super::modes::{Fate, Mode};
use super::search::{Found, Search};
use crate::number::{json_number, json_object, json_string, short};
use smartbed_codegen::Program;
use smartbed_codegen::model::Model;
use smartbed_codegen::words::count;
use std::fmt::Write as _;

/// Values below this fraction of the largest of their list, and of 1, are shown as 0.
const NOISE: f64 = 1e-12;
/// Most entries of a shape shown on a line.
const SHOWN: usize = 4;

/// An equilibrium with its modes.
pub(super) struct Answer<'a> {
    pub model: &'a Model,
    pub program: &'a Program,
    pub search: &'a Search<'a>,
    pub found: &'a Found,
    pub modes: &'a [Mode],
    /// Do the modes hold all around, not on one side of a kink alone?
    pub is_smooth: bool,
}

impl Fate {
    fn word(self) -> &'static str {
        match self {
            Self::Decays => "decays",
            Self::Persists => "persists",
            Self::Grows => "grows",
        }
    }
}

impl Answer<'_> {
    /// Names, values and units of coordinates, speeds, inputs and outputs.
    fn values(&self) -> [Vec<(&str, f64, &str)>; 4] {
        let found = self.found;
        [
            self.program
                .q
                .iter()
                .zip(&found.q)
                .map(|(q, x)| (q.name.as_str(), *x, q.unit.as_str()))
                .collect(),
            (self.program.speeds.iter().zip(&found.speeds))
                .map(|((name, _), x)| (name.as_str(), *x, self.unit_of_speed(name)))
                .collect(),
            (self.program.inputs.iter().zip(&found.inputs))
                .map(|(i, x)| (i.name.as_str(), *x, i.unit.as_str()))
                .collect(),
            (self.program.outputs.iter().zip(&found.outputs).zip(&self.model.outputs))
                .map(|(((name, _), x), output)| (name.as_str(), *x, output.unit.as_str()))
                .collect(),
        ]
    }

    fn unit_of_speed(&self, name: &str) -> &str {
        self.model.speeds.iter().find(|s| s.name == name).map_or("", |s| s.unit.as_str())
    }

    /// For people.
    pub fn text(&self) -> String {
        let what = if self.found.is_motion { "steady motion" } else { "equilibrium" };
        let mut text = format!("{}: {what}\n", self.program.name);
        let [q, speeds, inputs, outputs] = self.values();
        // At an equilibrium all speeds are 0.
        let speeds = if self.found.is_motion { speeds } else { Vec::new() };
        let lists = [q, speeds, inputs, outputs];
        let width = lists.iter().flatten().map(|(name, ..)| name.len()).max().unwrap_or(0);
        for list in &lists {
            let largest = list.iter().fold(1.0_f64, |most, (_, value, _)| most.max(value.abs()));
            for (name, value, unit) in list {
                let value = if value.abs() <= NOISE * largest { 0.0 } else { *value };
                let unit = if *unit == "1" { "" } else { unit };
                let line = format!("  {name:width$} {:>16} {unit}", short(value));
                let _ = writeln!(text, "{}", line.trim_end());
            }
        }
        let (name, left) = &self.found.left;
        let _ = writeln!(text, "largest rate left: {left:.1e}, of {name}");
        let _ = writeln!(text, "{}", self.verdict());
        if !self.modes.is_empty() {
            let _ = writeln!(
                text,
                "  {:>30}  {:>12} {:>9}  {:9} shape (size, phase in deg)",
                "eigenvalue (1/s)", "frequency Hz", "damping", ""
            );
        }
        for mode in self.modes.iter().filter(|mode| !mode.is_neutral()) {
            let _ = writeln!(text, "  {}", line(mode));
        }
        let neutral = self.modes.iter().filter(|mode| mode.is_neutral()).count();
        if neutral > 0 {
            let what = "directions without restoring or driving force";
            let _ =
                writeln!(text, "  {:>30}  {:>22}  {} of 0: {what}", "0", "", count(neutral, "eigenvalue"));
        }
        text
    }

    /// Whether it is stable.
    fn verdict(&self) -> String {
        if !self.is_smooth {
            return "stable or not, these modes do not tell: they do not hold on both sides of a kink"
                .to_owned();
        }
        let has = |fate| self.modes.iter().any(|mode| mode.fate == fate);
        let words = match (has(Fate::Grows), has(Fate::Persists)) {
            (true, _) => "unstable: a small push grows",
            (false, true) => "neither grows nor dies out: some small motions persist",
            (false, false) => "stable: every small push dies out",
        };
        format!("{words} (to first order)")
    }

    /// For programs, with what was warned of.
    pub fn json(&self, warnings: &[String]) -> String {
        let values = self.values();
        let [q, speeds, inputs, outputs] = values.map(|list| {
            let list: Vec<(String, f64)> =
                list.into_iter().map(|(name, x, _)| (name.to_owned(), x)).collect();
            json_object(list.iter().map(|(name, x)| (name.as_str(), *x)))
        });
        let modes: Vec<String> = self.modes.iter().map(json).collect();
        let matrix = |m: &nalgebra::DMatrix<f64>| {
            let row = |i: usize| m.row(i).iter().map(|x| json_number(*x)).collect::<Vec<_>>().join(", ");
            let rows: Vec<String> = (0..m.nrows()).map(|i| format!("[{}]", row(i))).collect();
            format!("[{}]", rows.join(", "))
        };
        let state: Vec<String> = self.search.state_names().iter().map(|name| json_string(name)).collect();
        let warnings: Vec<String> = warnings.iter().map(|warning| json_string(warning)).collect();
        format!(
            "{{\"model\": {}, \"steady_motion\": {}, \"q\": {q}, \"speeds\": {speeds}, \"inputs\": {inputs}, \
             \"outputs\": {outputs}, \"largest_rate_left\": {}, \"state\": [{}], \"a\": {}, \"b\": {}, \"modes\": [{}], \
             \"warnings\": [{}]}}\n",
            json_string(&self.program.name),
            self.found.is_motion,
            json_number(self.found.left.1),
            state.join(", "),
            matrix(&self.found.slopes.a),
            matrix(&self.found.slopes.b),
            modes.join(", "),
            warnings.join(", ")
        )
    }
}

fn line(mode: &Mode) -> String {
    let value = mode.eigenvalue;
    let real = if mode.fate == Fate::Persists { 0.0 } else { value.re };
    let number = match value.im {
        0.0 => format!("{real:.6e}"),
        im => format!("{real:.6e} +- {im:.6e}i"),
    };
    let (frequency, damping) = match value.im {
        0.0 => (String::new(), String::new()),
        _ => (format!("{:.6}", mode.frequency()), format!("{:.6}", mode.damping_ratio())),
    };
    let mut largest: Vec<&(String, f64, f64)> = mode.shape.iter().collect();
    largest.sort_by(|x, y| y.1.total_cmp(&x.1));
    let parts = largest.iter().take(SHOWN).map(|(name, size, phase)| match phase.to_degrees().round() {
        0.0 => format!("{name} {size:.3}"),
        degrees => format!("{name} {size:.3} at {degrees}"),
    });
    let mut shape = parts.collect::<Vec<_>>().join(", ");
    if shape.is_empty() {
        "a shape of this eigenvalue, times t".clone_into(&mut shape);
    }
    format!("{number:>30}  {frequency:>12} {damping:>9}  {:9} {shape}", mode.fate.word())
}

fn json(mode: &Mode) -> String {
    let part = |(name, size, phase): &(String, f64, f64)| {
        format!(
            "{{\"name\": {}, \"size\": {}, \"phase\": {}}}",
            json_string(name),
            json_number(*size),
            json_number(*phase)
        )
    };
    format!(
        "{{\"real\": {}, \"imaginary\": {}, \"frequency\": {}, \"damping_ratio\": {}, \"fate\": \"{}\", \"shape\": [{}]}}",
        json_number(mode.eigenvalue.re),
        json_number(mode.eigenvalue.im),
        json_number(mode.frequency()),
        json_number(mode.damping_ratio()),
        mode.fate.word(),
        mode.shape.iter().map(part).collect::<Vec<_>>().join(", ")
    )
}
