//! A program: what a mechanism's equations compute, as named answers over one expression DAG.
//!
//! In: a model and requests. Out: for each answer a list of named results; arguments in a fixed order (t, q, u, inputs,
//! parameters). [`derive()`] runs all stages in order. Interpreter and emitter both execute exactly the nodes of this
//! DAG.

pub mod answer;
pub mod arguments;
mod assemble;
mod conditions;
mod derived;
pub mod interpreter;
pub mod limits;
mod prepared;
mod reciprocal;
mod relative;
mod reorder;
mod roots;
mod shorten;
pub mod speeds;
pub mod stage;
mod start;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::dynamics;
pub use crate::expr::cost::Optimise;
use crate::kinematics::sizes::Sizes;
use crate::kinematics::{self, Assembly, Kinematics, ParameterChoice, sampling};
use crate::model::Model;
pub use crate::value::Effort;

use answer::Stages;
pub use answer::{Answer, Asked, Function, Request};
use assemble::{assemble, constraints, mark_angles};
pub use conditions::{check, conditions};
pub use derived::{Origin, Program, Quantity, Rates, Settings};
use stage::Stage;
pub use start::Start;

/// Derives the program of `model`.
///
/// # Errors
/// Faults that only numbers show; see the stages.
pub fn derive(model: &Model, choice: &ParameterChoice) -> Result<Program, Diagnostics> {
    derive_with(model, choice, Settings::default())
}

/// [`derive()`] with other settings.
///
/// # Errors
/// As for [`derive()`].
pub fn derive_with(
    model: &Model,
    choice: &ParameterChoice,
    settings: impl Into<Settings>,
) -> Result<Program, Diagnostics> {
    derive_asked(model, choice, settings, &Asked::default())
}

/// [`derive()`] with requests for further answers.
///
/// # Errors
/// As for [`derive()`]; also a request for something that does not exist.
pub fn derive_asked(
    model: &Model,
    choice: &ParameterChoice,
    settings: impl Into<Settings>,
    asked: &Asked,
) -> Result<Program, Diagnostics> {
    let requests = answer::resolve(model, asked)?;
    let needs_no_mass = requests.iter().all(|request| request.kind.needs == answer::Needs::Motion);
    let masses = if asked.only && needs_no_mass { Masses::Unread } else { Masses::Read };
    derive_stages(model, (choice, settings.into()), (asked, &requests), masses)
}

/// Derives the answers that need no mass (speeds, outputs, projection), for a model whose masses are unknown or
/// missing.
///
/// # Errors
/// Faults that only numbers show: frames that are not orthonormal, constraints that are singular or inconsistent.
pub fn derive_kinematic(
    model: &Model,
    choice: &ParameterChoice,
    effort: Effort,
) -> Result<Program, Diagnostics> {
    derive_stages(model, (choice, effort.into()), (&Asked::default(), &[]), Masses::Unread)
}

/// Does anything that is asked for depend on masses?
#[derive(Clone, Copy, PartialEq, Eq)]
enum Masses {
    Read,
    /// No: masses may be unknown or missing.
    Unread,
}

/// Runs all stages in order.
fn derive_stages(
    model: &Model,
    (choice, settings): (&ParameterChoice, Settings),
    (asked, requests): (&Asked, &[answer::Resolved]),
    masses: Masses,
) -> Result<Program, Diagnostics> {
    let optimise = if masses == Masses::Read { settings.optimise } else { Optimise::default() };
    let settings = Settings { optimise, ..settings };
    let effort = settings.effort;
    let own_inputs = model.inputs.len();
    let model = &*choice.applied(model)?;
    let model = &*answer::with_wrenches(model, requests)?;
    stage::begin(Stage::Kinematics);
    let with = |answer: &str| requests.iter().any(|request| request.kind.name == answer);
    // Multipliers are those of the equations before elimination: mass and forces stay where the model has them.
    let as_written = with("augmented") || with("multipliers");
    let (mut alg, k) = kinematics::derive_along(model, choice, optimise, as_written)?;
    let mut warnings = match masses {
        Masses::Read => implausible(model, &k)?,
        Masses::Unread => Diagnostics::new(model.source.clone()),
    };
    stage::begin(Stage::Constraints);
    let mut table = sampling::sample_table(&alg, model, &k);
    let (k, found) = kinematics::diagnose::check(&mut alg, model, k, &mut table)?;
    warnings.items.extend(found.items);
    let (mut alg, k, mut table, solution) = constraints(alg, model, k, table)?;
    // The values of the rows are not needed any more; their memory is reused.
    table.clear();
    stage::begin(Stage::Dynamics);
    let dynamics = match masses {
        Masses::Read => {
            dynamics::derive(&mut alg, model, &k, &solution, &mut table, (optimise, with("augmented")))?
        }
        Masses::Unread => dynamics::without_mass(&mut alg, model, &k, &solution, &mut table),
    };
    stage::begin(Stage::Answers);
    let given = (own_inputs, answer::holds_u_dot(requests), effort);
    let mut stages = Stages::new(&mut alg, (model, choice), &k, (&solution, &dynamics), &mut table, given);
    let answered = answer::derive(&mut stages, requests, asked)?;
    let assembly = Assembly::new(&mut alg, model, &k);
    let sizes = Sizes::new(&alg, model, &k);
    let origin = Origin::new(model, choice, settings);
    let mut program =
        assemble(model, (alg, k), (&solution, &mut table), dynamics, (assembly, answered, origin));
    warnings.items.extend(program.warn_of_start());
    program.warnings = warnings;
    program.keep_only(asked);
    stage::begin(Stage::Values);
    shorten::answers(&mut program, &mut table, effort);
    stage::begin(Stage::Sums);
    if effort != Effort::None && masses == Masses::Read {
        reorder::sums(&mut program, &mut table);
    }
    relative::to_parameters(&mut program, &sizes);
    mark_angles(&mut program);
    Ok(program)
}

/// Warns of implausible numbers and of bodies that do not move.
///
/// # Errors
/// Numbers for which the equations are meaningless.
fn implausible(model: &Model, k: &Kinematics) -> Result<Diagnostics, Diagnostics> {
    let mut found = Diagnostics::new(model.source.clone());
    model.implausible(&k.parameter_values).into_iter().for_each(|item| found.push(item));
    for body in model.bodies.iter() {
        let turns = body.frame.is_some_and(|frame| !k.angular[k.frame_triad[frame]].partials.is_empty());
        let moves = !k.velocities[body.centre].partials.is_empty();
        if !moves && !turns {
            found.push(
                Diagnostic::warning(format!("`{}` does not move", body.name))
                    .label(body.span, "neither its centre nor its frame depends on a coordinate")
                    .help("let its centre or frame depend on coordinates, or leave it out: it changes no equation"),
            );
        }
        if moves && body.mass.is_none() {
            found.push(
                Diagnostic::warning(format!("`{}` has inertia but no mass, and its centre moves", body.name))
                    .label(body.span, "no mass is given")
                    .help("give its mass; for a body of pure inertia say so: mass = 0"),
            );
        }
    }
    if found.has_errors() { Err(found) } else { Ok(found) }
}
