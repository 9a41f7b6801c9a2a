//! `smartbed check`: analyses a model without running it.
//!
//! In: a model. Out: counts, degrees of freedom, independent speeds and why they were chosen, rank and conditioning of
//! the constraints and worst pivots over samples, the configuration nearest to singular, units, warnings, operations of
//! each answer.

mod near_singular;
mod rank;
mod report;
mod rounding;
mod text;

use crate::failure::Failure;
use crate::progress::Waiting;
use crate::{jumps, model_argument, output};
use near_singular::Nearest;
use rank::Rank;
use report::Report;
use serde_json::{Value, json};
use smartbed_codegen::expr::Dependence;
use smartbed_codegen::model::{Model, SpeedMeaning};
use smartbed_codegen::{Effort, Optimise, ParameterChoice, Program, kinematics, program};

/// A warning is given if the conditioning of the constraints falls below this fraction of its nominal value
/// somewhere.
const LOST: f64 = 0.02;
/// A configuration is nearly singular if the smallest singular value is below this fraction of the largest.
const NEARLY_SINGULAR: f64 = 1e-4;

/// Analyse a model without running it: counts, degrees of freedom, rank, pivots, units, cost, warnings.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Example:
  cargo smartbed check tile
  cargo smartbed check tile --rounding")]
pub struct Arguments {
    /// The model: a path, or a name under models/.
    pub model: String,
    /// Also print the rounding error of each output in single precision (f32), relative to the output's largest
    /// value, and the operation that causes most of it.
    #[arg(long)]
    pub rounding: bool,
    /// Print every warning and every row. By default similar warnings are merged into one, and of a long list only
    /// the worst rows are printed.
    #[arg(long)]
    pub all: bool,
    /// Print the result as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong model.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let model = model_argument::read(&arguments.model)?;
    let choice = ParameterChoice::default();
    let waiting = Waiting::deriving();
    // Without bodies there are no forces: only the kinematics is checked.
    let program = match model.bodies.is_empty() {
        true => program::derive_kinematic(&model, &choice, Effort::default()),
        false => program::derive(&model, &choice),
    };
    let program = program.map_err(|e| model_argument::wrong(&e))?;
    let (mut alg, mut kinematics) =
        kinematics::derive(&model, &choice, Optimise::default()).map_err(|e| model_argument::wrong(&e))?;
    drop(waiting);
    let waiting = Waiting::new("searching for singular configurations");
    let nearest = near_singular::search(&model, &program, (&kinematics.samples, &kinematics.sample_times));
    let samples = kinematics.samples.len();
    // The configuration that the search has found counts as one more sample.
    if let Some(nearest) = &nearest {
        kinematics.samples.push(nearest.q.clone());
        kinematics.sample_times.push(nearest.t);
    }
    let rank = Rank { samples, ..Rank::over_samples(&mut alg, &model, &kinematics) };
    let mut report = report(&model, &program, &rank, nearest.as_ref());
    if arguments.rounding {
        report.facts["rounding"] =
            rounding::facts(&rounding::survey(&program, (&kinematics.samples, &kinematics.sample_times)));
    }
    drop(waiting);
    if arguments.json {
        output::print(&format!("{}\n", report.facts))
    } else {
        output::print(&text::render(&report, arguments.all))
    }
}

fn report(model: &Model, program: &Program, rank: &Rank, nearest: Option<&Nearest>) -> Report {
    let mut found = model_argument::warnings(model, program);
    found.items.extend(jumps::warnings(model));
    let mut warnings: Vec<String> = found.items.iter().map(|w| w.message.clone()).collect();
    let numeric = numeric_warnings(model, program, rank, nearest);
    warnings.extend(numeric.iter().cloned());
    let at = |q: &[f64]| json!(place(model, program, q));
    let facts = json!({
        "model": model.name,
        "doc": model.doc,
        "path": program.path,
        "counts": counts(model, program, rank),
        "dof": { "stated": model.dof.map(|(n, _)| n), "found": rank.freedom() },
        "independent_speeds": independent(model, program),
        "constraints": {
            "speeds": rank.unknowns, "rank": rank.smallest, "largest_rank": rank.largest,
            "samples": rank.samples, "conditioning": rank.conditioning.worst, "worst_at": at(&rank.conditioning.worst_at),
        },
        "nearest_to_singular": nearest.map(|n| json!({ "pivot": n.pivot, "at": at(&n.q) })),
        "pivots": pivots(program),
        "units": units(model, program),
        "cost": cost(model, program),
        "warnings": warnings,
    });
    Report { facts, found, numeric }
}

fn counts(model: &Model, program: &Program, rank: &Rank) -> Value {
    json!({
        "coordinates": model.coordinates.len(),
        "coordinates_in_state": program.q.len(),
        "speeds": model.speeds.len(),
        "independent_speeds": model.speeds.iter().filter(|s| s.independent).count(),
        "inputs": model.inputs.len(),
        "parameters": model.parameters.len(),
        "tunable_parameters": program.parameters.len(),
        "frames": model.frames.len() - 1,
        "points": model.points.len() - 1,
        "bodies": model.bodies.len(),
        "loads": model.loads.len(),
        "configuration_constraints": rank.residuals,
        "motion_constraints": model.motion_constraints.len(),
        "outputs": model.outputs.len(),
        "laws": model.laws.len(),
    })
}

/// Independent speeds with their meaning and the reason.
fn independent(model: &Model, program: &Program) -> Value {
    let free = model.speeds.iter().all(|s| s.independent);
    let reason = match (free, program.is_redundant()) {
        (true, _) => "no constraint contains it",
        (_, true) => {
            "declared independent; the motion passes dead points of it, so that all speeds are state"
        }
        _ => "declared independent; the others follow from the constraints",
    };
    let speeds = model.speeds.iter().filter(|s| s.independent).map(|speed| {
        let meaning = match &speed.meaning {
            SpeedMeaning::RateOf(c) => format!("d({})/dt", model.coordinates[*c].name),
            SpeedMeaning::Combination(_) => "a combination of rates".to_owned(),
        };
        json!({ "name": speed.name, "meaning": meaning, "why": reason })
    });
    speeds.collect()
}

fn pivots(program: &Program) -> Value {
    /// Longest expression that is shown.
    const SHOWN: usize = 48;
    let pivots = program.pivots.iter().map(|p| {
        json!({ "expression": program.dag.print(p.value, SHOWN), "nominal": p.nominal, "worst": p.worst })
    });
    pivots.collect()
}

fn units(model: &Model, program: &Program) -> Value {
    let row = |kind: &str, name: &str, unit: &str, doc: &str| json!({ "kind": kind, "name": name, "unit": unit, "doc": doc });
    let mut rows = Vec::new();
    rows.extend(model.coordinates.iter().map(|c| row("coordinate", &c.name, &c.unit, &c.doc)));
    rows.extend(model.speeds.iter().map(|s| row("speed", &s.name, &s.unit, "")));
    rows.extend(model.inputs.iter().map(|i| row("input", &i.name, &i.unit, &i.doc)));
    rows.extend(model.parameters.iter().map(|p| {
        let kind = if program.parameters.iter().any(|t| t.name == p.name) { "parameter" } else { "fixed" };
        row(kind, &p.name, &p.unit, &p.doc)
    }));
    rows.extend(model.outputs.iter().map(|o| row("output", &o.name, &o.unit, "")));
    Value::Array(rows)
}

fn cost(model: &Model, program: &Program) -> Value {
    let answers = if model.bodies.is_empty() { program.kinematic() } else { program.standing() };
    let costs = answers.iter().map(|answer| {
        let roots = program.roots_of(answer);
        json!({
            "answer": answer, "operations": program.dag.state_cost(&roots),
            "by_kind": program.dag.operations_by_kind(&roots, Dependence::State),
        })
    });
    costs.collect()
}

/// A configuration in the units in which the model declares its coordinates.
fn place(model: &Model, program: &Program, q: &[f64]) -> Vec<String> {
    let mut parts = Vec::new();
    for (quantity, x) in program.q.iter().zip(q) {
        let declared = model.coordinates.iter().find(|c| c.name == quantity.name);
        let (unit, size) = declared.map_or(("", 1.0), |c| (c.written_unit.0.as_str(), c.written_unit.1));
        let unit = if unit == "1" { "" } else { unit };
        // Rounded first: a tiny negative number would print as -0.
        let shown = (x / size * 1e4).round() / 1e4 + 0.0;
        parts.push(format!("{} = {shown:.4} {unit}", quantity.name).trim_end().to_owned());
    }
    parts
}

fn numeric_warnings(model: &Model, program: &Program, rank: &Rank, nearest: Option<&Nearest>) -> Vec<String> {
    let mut warnings = Vec::new();
    if rank.smallest < rank.largest {
        warnings.push(format!(
            "the constraints lose rank: {} at some samples, {} at others; near the configurations of lower rank the \
             motion is not determined",
            rank.smallest, rank.largest
        ));
    } else if rank.conditioning.is_lost(LOST, NEARLY_SINGULAR) {
        let found = &rank.conditioning;
        warnings.push(format!(
            "within the ranges a configuration is nearly singular: the smallest singular value of the constraints falls \
             from {:.1e} of the largest to {:.1e}, at {}; narrow the `range` of the independent coordinates",
            found.nominal,
            found.worst,
            place(model, program, &found.worst_at).join(", ")
        ));
    } else if !program.is_redundant() && rank.of_dependent.is_lost(LOST, NEARLY_SINGULAR) {
        let found = &rank.of_dependent;
        warnings.push(format!(
            "within the ranges the independent coordinates come near a dead point, where they do not determine the \
             others: the smallest singular value of these falls from {:.1e} of the largest to {:.1e}, at {}; choose \
             other independent coordinates, or narrow their `range`; a dead point inside it, where masses move, is \
             passed, with all speeds as state",
            found.nominal,
            found.worst,
            place(model, program, &found.worst_at).join(", ")
        ));
    } else if let Some(found) = nearest.filter(|found| found.pivot < NEARLY_SINGULAR) {
        warnings.push(format!(
            "within the ranges the equations of motion are nearly singular, while the constraints are regular: the \
             worst pivot falls to {:.1e} of nominal, at {}; there two coordinates describe the same motion, or a \
             motion moves no mass; narrow their `range`, or choose coordinates that are regular there (the joints \
             \"spherical\" and \"free\" are so everywhere)",
            found.pivot,
            place(model, program, &found.q).join(", ")
        ));
    }
    warnings
}
