//! A program: what a mechanism's equations compute, as named answers over one expression DAG.
//!
//! In: kinematics and dynamics. Out: for each answer a list of named results; inputs in a fixed
//! order (t, q, u, inputs, parameters). Both the interpreter and the emitter run exactly these nodes.

pub mod answer;
pub mod arguments;
mod assemble;
mod derived;
pub mod interpreter;
mod kinematic;
pub mod limits;
mod prepared;
mod reciprocal;
mod relative;
mod reorder;
mod roots;
mod shorten;
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
pub use derived::{Origin, Program, Quantity, Rates, Settings};
pub use kinematic::derive_kinematic;
use stage::Stage;
pub use start::Start;

/// Derives the program of `model`.
///
/// # Errors
/// What only numbers show: see the stages.
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

/// [`derive()`] with answers on request.
///
/// # Errors
/// As for [`derive()`]; a request for what is not there.
pub fn derive_asked(
    model: &Model,
    choice: &ParameterChoice,
    settings: impl Into<Settings>,
    asked: &Asked,
) -> Result<Program, Diagnostics> {
    let settings = settings.into();
    let Settings { effort, optimise } = settings;
    let requests = answer::resolve(model, asked)?;
    if asked.only && requests.iter().all(|request| request.kind.needs == answer::Needs::Motion) {
        return kinematic::derive(model, choice, effort, asked);
    }
    let own_inputs = model.inputs.len();
    let model = &*answer::with_wrenches(model, &requests)?;
    stage::begin(Stage::Kinematics);
    let (mut alg, mut k) = kinematics::derive(model, choice, optimise)?;
    let mut warnings = implausible(model, &k)?;
    stage::begin(Stage::Constraints);
    let mut table = sampling::sample_table(&alg, model, &k);
    warnings.items.extend(kinematics::diagnose::check(&mut alg, model, &mut k, &mut table)?.items);
    let solution = constraints(&mut alg, model, &mut k, &mut table)?;
    // The values of the rows have served: their memory is used again.
    table.clear();
    stage::begin(Stage::Dynamics);
    let with_augmented = requests.iter().any(|request| request.kind.name == "augmented");
    let dynamics = dynamics::derive(&mut alg, model, &k, &solution, &mut table, (optimise, with_augmented))?;
    stage::begin(Stage::Answers);
    let given = (own_inputs, answer::holds_u_dot(&requests), effort);
    let mut stages = Stages::new(&mut alg, (model, choice), &k, (&solution, &dynamics), &mut table, given);
    let answered = answer::derive(&mut stages, &requests, asked)?;
    let assembly = Assembly::new(&mut alg, model, &k);
    let sizes = Sizes::new(&alg, model, &k);
    let origin = Origin::new(model, choice, settings);
    let mut program =
        assemble(model, (alg, k), (&solution, &mut table), dynamics, (assembly, answered, origin));
    program.warnings = warnings;
    program.keep_only(asked);
    stage::begin(Stage::Values);
    shorten::answers(&mut program, &mut table, effort);
    stage::begin(Stage::Sums);
    if effort != Effort::None {
        reorder::sums(&mut program, &mut table);
    }
    relative::to_parameters(&mut program, &sizes);
    mark_angles(&mut program);
    Ok(program)
}

/// Warnings of what no mechanism has, and of bodies that nothing moves.
///
/// # Errors
/// Numbers that make the equations meaningless.
fn implausible(model: &Model, k: &Kinematics) -> Result<Diagnostics, Diagnostics> {
    let mut found = Diagnostics::new(model.source.clone());
    model.implausible(&k.parameter_values).into_iter().for_each(|item| found.push(item));
    for body in model.bodies.iter() {
        let turns = body.frame.is_some_and(|frame| !k.angular[k.frame_triad[frame]].partials.is_empty());
        let moves = !k.velocities[body.centre].partials.is_empty();
        if !moves && !turns {
            found.push(
                Diagnostic::warning(format!("`{}` is tied to nothing that moves", body.name))
                    .label(body.span, "its centre and its frame stay where they are")
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
