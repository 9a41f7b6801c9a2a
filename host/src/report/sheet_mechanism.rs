//! The cost sheet of a mechanism: a step of rk4, its equations counted by the derivation.

use super::clock;
use super::sheet::{Cost, Sheet, Variant};
use crate::engine::{self, explain};
use crate::run::simulate::Plant;
use smartbed_codegen::model::Model;
use smartbed_codegen::words::count;
use smartbed_codegen::{ParameterChoice, Program, program};
use smartbed_runtime::ode::Method;
use smartbed_runtime::ode::State;

/// Number of steps timed in a run, and number of runs, of which the fastest counts.
const STEPS: usize = 200;
const REPEATS: usize = 5;
/// Evaluations in a step of rk4.
const STAGES: f64 = 4.0;

/// A mechanism in f64 under its laws.
pub(super) type Plant64 = Plant<Box<dyn engine::Engine<f64>>, f64>;

/// Makes the sheet from a model and its equations. `plant_of` joins equations with the mechanism's laws, to start at
/// `start` with a step (s).
///
/// # Errors
/// Why the mechanism could not be derived or run, in words.
pub fn make(
    (model, lean): (&Model, &Program),
    start: (&[f64], f64),
    plant_of: impl Fn(&Program) -> Result<Plant64, String>,
) -> Result<Sheet, String> {
    let keep = model.parameters.iter().map(|p| p.name.clone()).collect();
    let choice = ParameterChoice { keep, ..ParameterChoice::default() };
    let full = program::derive(model, &choice).map_err(|e| e.to_string())?;
    let costs = [
        Cost { operations: lean_operations(lean), nanoseconds: time(|| plant_of(lean), start, false)? },
        Cost { operations: full_operations(&full), nanoseconds: time(|| plant_of(&full), start, true)? },
    ];
    let projection = if lean.correction.is_empty() { "" } else { ", projection" };
    let folded = model.parameters.len() - lean.parameters.len();
    let asked = format!(
        "rates{projection}; {} of {} parameters tunable; rk4",
        lean.parameters.len(),
        model.parameters.len()
    );
    let left_out = format!(
        "energies, {}, {}; {} folded",
        count(lean.speeds.len(), "speed"),
        count(lean.outputs.len(), "output"),
        count(folded, "parameter")
    );
    let everything = Variant { set: Vec::new(), everything: true };
    Ok(Sheet { asked, left_out, costs, everything })
}

fn lean_operations(program: &Program) -> f64 {
    let projection = program.dag.cone_cost(&program.roots_of("projection"));
    let projection = if program.correction.is_empty() { 0 } else { projection };
    STAGES * program.dag.cone_cost(&program.roots_of("rates")) as f64 + projection as f64
}

fn full_operations(program: &Program) -> f64 {
    let after = ["energy", "speeds", "outputs"].map(|name| program.dag.cone_cost(&program.roots_of(name)));
    lean_operations(program) + after.iter().sum::<usize>() as f64
}

/// Time of a step (ns), with all answers after it if `full`.
fn time(
    plant: impl Fn() -> Result<Plant64, String>,
    (start, h): (&[f64], f64),
    full: bool,
) -> Result<f64, String> {
    let mut best = f64::INFINITY;
    for _ in 0..REPEATS {
        let mut plant = plant()?;
        let mut x = start.to_vec();
        let mut low = vec![0.0; x.len()];
        let mut scratch = vec![0.0; Method::Rk4.scratch(x.len())];
        let mut state = State::new(&mut x, &mut low).map_err(|f| explain(f).to_owned())?;
        let begin = clock::now();
        for n in 0..STEPS {
            let t = n as f64 * h;
            Method::Rk4
                .step(&mut plant, t, h, &mut state, &mut scratch)
                .map_err(|f| explain(f).to_owned())?;
            if full {
                plant.answers(t, state.x()).map_err(|f| explain(f).to_owned())?;
            }
        }
        best = best.min((clock::now() - begin).as_nanos() as f64 / STEPS as f64);
    }
    Ok(best)
}
