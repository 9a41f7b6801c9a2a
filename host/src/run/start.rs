//! Coordinates and speeds at the start: as given, with dependent ones solved for, or an error that names the lines.

use super::settings::Settings;
use crate::configuration::Configurations;
use crate::failure::Failure;
use crate::{model_argument, output};
use smartbed_codegen::Program;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::kinematics::Unreachable;
use smartbed_codegen::model::{Model, StartRef};
use smartbed_codegen::program::{Quantity, speeds};

/// A given dependent value counts as replaced if the solution differs by more than this, relative to it.
const REPLACED: f64 = 1e-6;

/// Coordinates and independent speeds at the start.
pub(crate) fn start(model: &Model, program: &Program, settings: &Settings) -> Result<Vec<f64>, Failure> {
    let mut configurations = Configurations::new(model, program);
    let parameters: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let given: Vec<Option<f64>> = program.q.iter().map(|q| settings.start.get(&q.name).copied()).collect();
    let solved = configurations.solve(&parameters, &given);
    let mut x = solved.map_err(|unreachable| {
        match bad_guess(program, &mut configurations, (&parameters, &given)) {
            Some(why) => Failure::Wrong(why),
            None => start_unreachable(model, settings, &unreachable),
        }
    })?;
    let why = "it is dependent and follows from the independent coordinates";
    note_replaced(&program.q, &given, &x, why);
    let speeds = start_speeds(model, program, settings, (&x, &parameters))?;
    x.extend(speeds);
    Ok(x)
}

/// What to say if the start can be assembled without the values given for dependent coordinates.
fn bad_guess(
    program: &Program,
    configurations: &mut Configurations,
    (parameters, given): (&[f64], &[Option<f64>]),
) -> Option<String> {
    let independent = |i: usize| configurations.is_independent(i);
    let guessed: Vec<usize> = (0..given.len()).filter(|&i| given[i].is_some() && !independent(i)).collect();
    let without: Vec<Option<f64>> =
        given.iter().enumerate().map(|(i, value)| value.filter(|_| independent(i))).collect();
    if guessed.is_empty() {
        return None;
    }
    let q = configurations.solve(parameters, &without).ok()?;
    let name = |i: &usize| program.q[*i].name.as_str();
    let list = |value: &dyn Fn(usize) -> f64| -> String {
        guessed.iter().map(|i| format!("`{}` = {:.6}", name(i), value(*i))).collect::<Vec<_>>().join(", ")
    };
    Some(format!(
        "the start cannot be assembled near {}, the guess of what depends on the independent coordinates; leave it out: \
         these give {}",
        list(&|i| given[i].unwrap_or(f64::NAN)),
        list(&|i| q[i])
    ))
}

/// Reports which of the given start values were replaced, and why.
fn note_replaced(quantities: &[Quantity], given: &[Option<f64>], found: &[f64], why: &str) {
    for ((quantity, given), found) in quantities.iter().zip(given).zip(found) {
        let replaced = given.filter(|given| (given - found).abs() > REPLACED * given.abs().max(1.0));
        if let Some(given) = replaced {
            output::say(&format!(
                "note: the start value {} = {given} is replaced by {found:.6}: {why}",
                quantity.name
            ));
        }
    }
}

/// Speeds at the start: as given; corrected to meet the constraints if all of them are state.
fn start_speeds(
    model: &Model,
    program: &Program,
    settings: &Settings,
    (q, parameters): (&[f64], &[f64]),
) -> Result<Vec<f64>, Failure> {
    let is_state = |name: &str| program.u.iter().any(|u| u.name == name);
    let followed = model.speeds.iter().find(|s| settings.start.contains_key(&s.name) && !is_state(&s.name));
    if let Some(speed) = followed {
        return Err(Failure::Wrong(format!(
            "the speed `{}` is dependent: it follows from the independent ones and cannot be set",
            speed.name
        )));
    }
    let given: Vec<Option<f64>> = program.u.iter().map(|u| settings.start.get(&u.name).copied()).collect();
    let speeds = speeds::complete(program, (0.0, q, parameters), &given)
        .map_err(|fault| Failure::Wrong(format!("the start: {fault}")))?;
    let why = "the constraints and the other start values do not allow it";
    note_replaced(&program.u, &given, &speeds, why);
    Ok(speeds)
}

/// The error for a start that cannot be assembled, with the lines of `[start]` concerned.
fn start_unreachable(model: &Model, settings: &Settings, unreachable: &Unreachable) -> Failure {
    let mut error = Diagnostic::error(format!("the start cannot be assembled: {unreachable}"))
        .help("expected independent coordinates within reach of the nominal configuration");
    for ((owner, value), (_, written)) in model.start.iter().zip(&model.start_written) {
        if let StartRef::Coordinate(id) = owner
            && settings.start.get(&model.coordinates[*id].name) == Some(value)
        {
            error = error.label(written.span, "this start value, among others");
        }
    }
    model_argument::wrong(&Diagnostics::one(model.source.clone(), error))
}
