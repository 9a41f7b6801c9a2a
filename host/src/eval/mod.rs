//! `smartbed eval`: the equations at given states, for scripts and for comparison with other tools.
//!
//! In: a model and a JSON file of states ([`states`]). Out: JSON in the same order ([`write`]).
//! The model is derived once, with every parameter that any state names kept tunable.

mod conditions;
pub mod states;
mod write;

use crate::configuration::Configurations;
use crate::engine::{self, Engine, EngineKind, EngineScalar, ScalarKind, explain};
use crate::failure::Failure;
use crate::limits::{Angles, check_numbers, less_turns};
use crate::number::fewest_digits;
use crate::observers::Observers;
use crate::progress::{Progress, Waiting};
use crate::{answers, model_argument, output};
use conditions::{Conditions, FOLLOWS};
use smartbed_codegen::diagnostic::{Diagnostics, Severity};
use smartbed_codegen::model::Model;
use smartbed_codegen::program::{answer, speeds};
use smartbed_codegen::{Asked, Function, Interpreted, ParameterChoice, Program, Request, Settings, program};
use states::State;
use std::collections::BTreeSet;
use write::Evaluated;

/// A residual above this share of a constraint's terms, or another quantity off by this share, is more than rounding in
/// any scalar.
const VIOLATED: f64 = 1e-4;
/// A residual above this share is more than the rounding of numbers given to six decimals.
const ROUGH: f64 = 1e-6;
/// Where more than this share of the accelerations may be wrong, not one digit is certain.
const NO_DIGIT: f64 = 0.1;
const NEARLY: &str = "the configuration is singular or nearly so";

/// Evaluate a model's equations of motion at given states.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Example:
  cargo smartbed eval tile --states in.json -o out.json
  with in.json: {\"states\": [{\"q\": {\"hA\": 0.01, \"hB\": 0, \"hC\": 0}, \"u\": {\"u_hA\": 0.1},
                              \"inputs\": {\"FA\": 30}, \"parameters\": {\"M\": 8}}]}

All numbers are in SI units. Of each state:
  t           time; 0 if left out
  q           independent coordinates must be given; if dependent ones are left out, all of them are
              solved for, from those that are given; those with a closed form are computed, and if
              given must agree with it
  u           independent speeds; 0 if left out
  inputs      0 if left out
  parameters  the model's values if left out
  u_dot       accelerations by the names of the speeds, for answers that need them")]
pub struct Arguments {
    /// The model: a path, or a name under models/.
    pub model: String,
    /// JSON file with the states; - is standard input.
    #[arg(long, value_name = "IN.json")]
    pub states: String,
    /// File for the answers; - is standard output.
    #[arg(short, long, value_name = "OUT.json", default_value = "-")]
    pub output: String,
    /// How the equations are evaluated.
    #[arg(long, value_enum, default_value_t)]
    pub engine: EngineKind,
    /// Number type of the computation.
    #[arg(long, value_enum, default_value_t)]
    pub scalar: ScalarKind,
    /// Compute only these answers, separated by commas; `derive --help` lists all [default: rates, energy, outputs,
    /// projection, drive].
    #[arg(long, value_parser = answers::entry, value_name = "LIST")]
    pub answers: Vec<String>,
    /// With --output FILE: print one JSON object with model, number of states and file. The answers are JSON in any
    /// case.
    #[arg(long)]
    pub json: bool,
}

/// A function with those of its answers that not every program has, if there are any.
fn on_request(asked: &Function) -> Vec<Function> {
    let is_asked = |r: &&Request| answer::find(&r.answer).is_some_and(|kind| !kind.is_standing());
    let requests: Vec<Request> = asked.requests.iter().filter(is_asked).cloned().collect();
    if requests.is_empty() { Vec::new() } else { vec![Function { name: asked.name.clone(), requests }] }
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong model or state, status 2 without a compiler for `--engine compiled`.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    output::replace_none(&[("--output", Some(&arguments.output))], &[&arguments.model, &arguments.states])?;
    let model = model_argument::read(&arguments.model)?;
    let states = states::read(&arguments.states)?;
    let choice = ParameterChoice { keep: states::parameters(&states, &model)?, ..Default::default() };
    let requests = answers::functions(&arguments.answers)?.into_iter().flat_map(|f| f.requests).collect();
    let asked = Function { name: "answers".to_owned(), requests };
    asked
        .distinct()
        .map_err(|twice| model_argument::wrong(&Diagnostics::one(model.source.clone(), twice)))?;
    let besides = Asked::besides(on_request(&asked));
    let waiting = Waiting::deriving();
    let program = program::derive_asked(&model, &choice, Settings::default(), &besides);
    drop(waiting);
    let program = program.map_err(|e| model_argument::wrong(&e))?;
    model_argument::print_warnings(&program);
    let closed = match model.coordinates.iter().any(|c| c.closed_form.is_some()) {
        true => Some(Observers::derive(&model, &choice).map_err(|e| model_argument::wrong(&e))?),
        false => None,
    };
    let (given, wanted) = ((&model, &choice), (&states[..], &asked.requests[..]));
    let text = match arguments.scalar {
        ScalarKind::F32 => evaluate::<f32>(arguments, given, &program, closed.as_ref(), wanted)?,
        ScalarKind::F64 => evaluate::<f64>(arguments, given, &program, closed.as_ref(), wanted)?,
    };
    output::write(&arguments.output, text.as_bytes())?;
    if arguments.json && arguments.output != "-" {
        let done = serde_json::json!({
            "model": program.name, "states": states.len(), "output": arguments.output,
        });
        return output::print(&format!("{done}\n"));
    }
    Ok(())
}

fn evaluate<S: EngineScalar>(
    arguments: &Arguments,
    (model, choice): (&Model, &ParameterChoice),
    program: &Program,
    observers: Option<&Observers>,
    (states, requests): (&[State], &[Request]),
) -> Result<String, Failure> {
    let answers: Vec<String> = match requests {
        [] => program.standing().into_iter().filter(|&name| name != "speeds").map(str::to_owned).collect(),
        given => given.iter().map(ToString::to_string).collect(),
    };
    let mut engine = engine::new::<S>(arguments.engine, program)?;
    let mut angles = Angles::new::<S>(program);
    let mut configurations = Configurations::new(model, program);
    let mut conditions = Conditions::new(model, choice, program)?;
    let mut masses = Masses::new(model, program);
    let names = observers.map_or(&[][..], |o| o.closed.as_slice());
    let mut closed_forms = observers.map(|o| Interpreted::<S>::new(&o.closed_forms()));
    let mut progress = Progress::new("evaluating");
    let mut text = String::from("{\"states\": [");
    for (number, state) in states.iter().enumerate() {
        progress.at(number as f64 / states.len() as f64);
        let place = format!("{}: states[{number}]", arguments.states);
        let at = |message: String| Failure::Wrong(format!("{place}: {message}"));
        let given = state.resolve(model, program, (names, &configurations)).map_err(at)?;
        conditions.check(&place, (state, &given.parameters), program, &mut configurations)?;
        let q = configurations.complete_at(state.t, &given.parameters, &given.q).map_err(|unreachable| {
            if unreachable.locked {
                return at(format!("parameters: {unreachable}; {FOLLOWS}"));
            }
            at(format!(
                "the dependent coordinates cannot be found: {unreachable}; expected independent coordinates \
                 within reach of the nominal configuration (its branch is followed), or start values of the \
                 dependent ones nearer to a solution"
            ))
        })?;
        solved_for(number, &given.q, &q, program);
        let u = complete_speeds(program, (state.t, &q, &given.parameters), &given.u)
            .map_err(|fault| at(explain(fault).to_owned()))?;
        masses.check(number, &given.parameters).map_err(at)?;
        let parameters = rounded::<S>(&given.parameters);
        engine.set_parameters(&parameters);
        // Shown as given, but computed with whole turns subtracted.
        let near = less_turns::<S>(program, &q);
        for (list, values) in [
            (&program.q, &near),
            (&program.u, &u),
            (&program.inputs, &given.inputs),
            (&program.u_dot, &given.u_dot),
            (&program.parameters, &given.parameters),
        ] {
            let named = list.iter().zip(values).map(|(quantity, x)| (quantity.name.as_str(), *x));
            check_numbers::<S>(named).map_err(at)?;
        }
        angles.set_parameters(&given.parameters);
        angles.check(state.t, &near, &u, &given.inputs).map_err(at)?;
        let mut evaluated = one(engine.as_mut(), state.t, &near, &u, &given.inputs)
            .map_err(|fault| at(explain(fault).to_owned()))?;
        evaluated.q.clone_from(&q);
        if !program.functions.is_empty() {
            let [q, u, inputs, u_dot] = [&near, &u, &given.inputs, &given.u_dot].map(|x| rounded::<S>(x));
            let values = engine.function(0, (S::from_f64(state.t), &q, &u, &inputs, &u_dot));
            let values = values.map_err(|fault| at(explain(fault).to_owned()))?;
            evaluated.asked = values.into_iter().map(S::to_f64).collect();
        }
        if let Some(closed_forms) = &mut closed_forms {
            closed_forms.set_parameters(&parameters);
            // Leaves out the wrenches at ports, which answers add as inputs behind the model's own.
            let inputs = &given.inputs[..model.inputs.len()];
            let values = closed_forms
                .outputs(S::from_f64(state.t), &rounded(&near), &rounded(&u), &rounded(inputs))
                .map_err(|fault| at(explain(fault).to_owned()))?;
            evaluated.closed = values.into_iter().map(S::to_f64).collect();
            agree(names, &given.closed, &evaluated.closed).map_err(at)?;
        }
        if let Some(what) = evaluated.not_finite(program) {
            return Err(at(what));
        }
        let violation = configurations.violation(state.t, &given.parameters, &q);
        let share = violation.as_ref().map_or(0.0, |(.., share)| *share);
        let solved = given.q.iter().any(Option::is_none).then_some(share);
        let lost = lost::<S>(evaluated.pivot.abs(), solved);
        if lost > NO_DIGIT && answers.iter().any(|name| gives_accelerations(name)) {
            return Err(at(format!(
                "{NEARLY}: the smallest pivot is {:.1e} of its nominal size, and not one digit of the accelerations is \
                 certain; expected a configuration away from it, or other independent coordinates",
                evaluated.pivot.abs()
            )));
        }
        warn::<S>(number, &evaluated, (program, &configurations), (violation, lost));
        text.push_str(if number == 0 { "\n" } else { ",\n" });
        evaluated.write(program, names, &answers, &mut text);
    }
    text.push_str("\n]}\n");
    Ok(text)
}

/// Says which of the given coordinates were start values of the search for those left out.
fn solved_for(number: usize, given: &[Option<f64>], q: &[f64], program: &Program) {
    let names = program.q.iter().map(|own| own.name.as_str());
    for ((given, q), name) in given.iter().zip(q).zip(names) {
        let Some(given) = given.filter(|given| (given - q).abs() > VIOLATED * q.abs().max(1.0)) else {
            continue;
        };
        output::say(&format!(
            "note: states[{number}]: `{name}` = {given} is where the search began, and was solved for: {q:.6}. Others are \
             left out; give all to take them as they are"
        ));
    }
}

/// Masses and moments of inertia at the parameters of states.
struct Masses<'m> {
    model: &'m Model,
    program: &'m Program,
    /// What was warned of before.
    told: BTreeSet<String>,
}

impl<'m> Masses<'m> {
    fn new(model: &'m Model, program: &'m Program) -> Self {
        let told = program.warnings.items.iter().map(|item| item.message.clone()).collect();
        Self { model, program, told }
    }

    /// Refuses parameters at which a mass or a length is negative; warns once of moments of inertia that no body has.
    fn check(&mut self, number: usize, parameters: &[f64]) -> Result<(), String> {
        let values = self.program.parameters.iter().zip(parameters);
        let values = values.map(|(own, value)| (own.name.clone(), *value)).collect();
        for item in self.model.implausible(&self.model.parameter_values(&values)) {
            let labels: Vec<&str> = item.labels.iter().map(|label| label.text.as_str()).collect();
            let help = item.help.unwrap_or_default();
            let text = format!("parameters: {} ({}); {help}", item.message, labels.join(", "));
            if item.severity == Severity::Error {
                return Err(text);
            }
            if self.told.insert(item.message) {
                output::say(&format!("warning: states[{number}]: {text}"));
            }
        }
        Ok(())
    }
}

/// Warns of states whose answers are finite but doubtful.
fn warn<S: EngineScalar>(
    number: usize,
    evaluated: &Evaluated,
    (program, configurations): (&Program, &Configurations),
    (violation, lost): (Option<(String, f64, f64)>, f64),
) {
    let long = configurations.unit_vectors().iter().find_map(|places| {
        let length = places.iter().map(|&i| evaluated.q[i]).fold(0.0, f64::hypot);
        let names: Vec<&str> = places.iter().map(|&i| program.q[i].name.as_str()).collect();
        ((length - 1.0).abs() > VIOLATED).then(|| (names.join(", "), length))
    });
    if let Some((names, length)) = long {
        output::say(&format!(
            "warning: states[{number}]: {names} are the components of a unit vector, but its length is {length:.6}; \
             expected 1. Its accelerations have no meaning: give the components with length 1"
        ));
    } else if let Some((name, residual, share)) = violation.filter(|(.., share)| *share > ROUGH) {
        let accelerations = match share > VIOLATED {
            true => "its accelerations have no meaning",
            false => "its accelerations are those of the violated configuration",
        };
        output::say(&format!(
            "warning: states[{number}]: the configuration does not satisfy the constraints: a residual of {residual:.1e} \
             is left in `{name}`, {share:.0e} of its terms, and {accelerations}; dependent coordinates that are left \
             out are solved for"
        ));
    }
    let fastest = evaluated.u.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    let wrong =
        evaluated.speed_correction.iter().zip(&program.u).find(|(off, _)| off.abs() > VIOLATED * fastest);
    if let Some((off, speed)) = wrong {
        output::say(&format!(
            "warning: states[{number}]: the speeds do not satisfy the constraints: `{}` is off by {off:.1e}, and the \
             accelerations have no meaning; `run` corrects such speeds, and a list of independent ones is completed",
            speed.name
        ));
    }
    if lost > S::ROOT_EPSILON.to_f64() {
        let certain = match lost > NO_DIGIT {
            true => "not one digit is".to_owned(),
            false => format!("some {} digits are", (-lost.log10()).floor()),
        };
        output::say(&format!(
            "warning: states[{number}]: {NEARLY}: the smallest pivot is {:.1e} of its nominal size, and of the accelerations \
             {certain} certain; `run` refuses to step from where half of them are lost by the pivot alone",
            evaluated.pivot.abs()
        ));
    }
}

/// Does an answer rest on the accelerations?
fn gives_accelerations(name: &str) -> bool {
    let kind = name.split(':').next().unwrap_or(name);
    let mut needing = answer::CATALOGUE.iter().filter(|own| own.needs == answer::Needs::Accelerations);
    needing.any(|own| own.name == kind)
}

/// The share of the accelerations that may be wrong: rounding is divided by the pivot, and what is left of the
/// constraints, as a share of their terms, twice where coordinates were solved for: in these, then in the
/// accelerations.
fn lost<S: EngineScalar>(pivot: f64, solved: Option<f64>) -> f64 {
    let by_coordinates = solved.map_or(0.0, |share| share.max(f64::EPSILON) / (pivot * pivot));
    by_coordinates.max(S::EPSILON.to_f64() / pivot)
}

/// Checks that given values of coordinates in closed form agree with the form.
fn agree(names: &[(String, String)], given: &[Option<f64>], values: &[f64]) -> Result<(), String> {
    /// Tolerance: single precision, and numbers written with few digits.
    const ROUNDING: f64 = 1e-6;
    for ((name, _), (given, value)) in names.iter().zip(given.iter().zip(values.iter().step_by(2))) {
        if let Some(given) = given
            && (given - value).abs() > ROUNDING * value.abs().max(1.0)
        {
            return Err(format!(
                "q: `{name}` is {} by its closed form, but {} is given; leave it out or correct it",
                fewest_digits(*value),
                fewest_digits(*given)
            ));
        }
    }
    Ok(())
}

/// Completes the speeds of a state; a complete list is taken as it is.
fn complete_speeds(
    program: &Program,
    at: (f64, &[f64], &[f64]),
    given: &[Option<f64>],
) -> Result<Vec<f64>, smartbed_runtime::mechanism::Fault> {
    match given.iter().copied().collect::<Option<Vec<f64>>>() {
        Some(u) => Ok(u),
        None => speeds::complete(program, at, given),
    }
}

fn rounded<S: EngineScalar>(values: &[f64]) -> Vec<S> {
    values.iter().map(|&x| S::from_f64(x)).collect()
}

fn one<S: EngineScalar>(
    engine: &mut dyn Engine<S>,
    t: f64,
    q: &[f64],
    u: &[f64],
    inputs: &[f64],
) -> Result<Evaluated, smartbed_runtime::mechanism::Fault> {
    let (state_q, state_u, state_inputs) = (rounded::<S>(q), rounded::<S>(u), rounded::<S>(inputs));
    let (mut q_dot, mut u_dot) = (vec![S::ZERO; q.len()], vec![S::ZERO; u.len()]);
    let time = S::from_f64(t);
    engine.set_time(time);
    let pivot = engine.rates(time, &state_q, &state_u, &state_inputs, &mut q_dot, &mut u_dot)?;
    let energy = engine.energy(&state_q, &state_u)?;
    let mut corrected = state_u.clone();
    engine.project_speeds(&state_q, &mut corrected)?;
    let widened = |values: Vec<S>| values.into_iter().map(S::to_f64).collect::<Vec<f64>>();
    Ok(Evaluated {
        t,
        q: q.to_vec(),
        closed: Vec::new(),
        u: u.to_vec(),
        q_dot: widened(q_dot),
        u_dot: widened(u_dot),
        pivot: pivot.to_f64(),
        energy: [energy.0.to_f64(), energy.1.to_f64()],
        speed_correction: corrected.iter().zip(&state_u).map(|(x, u)| x.to_f64() - u.to_f64()).collect(),
        speeds: widened(engine.speeds(&state_q, &state_u)?),
        outputs: widened(engine.outputs(time, &state_q, &state_u, &state_inputs)?),
        asked: Vec::new(),
        drive: engine.drive(time, &state_q, &state_u, &state_inputs)?.to_f64(),
        residual: engine.residual(&state_q)?.to_f64(),
    })
}
