//! What a derivation finds by numbers, and the parameters on which that rests.
//!
//! In: a model. Out: nothing, or the errors with which a derivation refuses it ([`check`]); the parameters at other
//! values of which these checks may end otherwise ([`conditions`]). A program keeps parameters tunable, but was checked
//! at one set of their values: constraints that follow from others are dropped, axes are taken as orthonormal, closed
//! forms as consequences of the constraints. Who changes one of these parameters checks again.

use super::assemble::constraints;
use crate::diagnostic::Diagnostics;
use crate::expr::cost::Optimise;
use crate::expr::tape::SampleTable;
use crate::kinematics::{self, Algebra, Kinematics, ParameterChoice, sampling};
use crate::model::{Model, ParameterId};

/// Runs the stages up to the solution of the constraints, which find every fault of frames and constraints.
///
/// # Errors
/// As for [`super::derive()`]: frames that are not orthonormal, constraints that are singular or contradict one another
/// or the closed forms.
pub fn check(model: &Model, choice: &ParameterChoice) -> Result<(), Diagnostics> {
    let model = &*choice.applied(model)?;
    let (alg, k, table) = checked(model, choice)?;
    constraints(alg, model, k, table).map(|_| ())
}

fn checked(
    model: &Model,
    choice: &ParameterChoice,
) -> Result<(Algebra, Kinematics, SampleTable), Diagnostics> {
    let (mut alg, k) = kinematics::derive(model, choice, Optimise::default())?;
    let mut table = sampling::sample_table(&alg, model, &k);
    let (k, _) = kinematics::diagnose::check(&mut alg, model, k, &mut table)?;
    Ok((alg, k, table))
}

/// The tunable parameters on which the checks of a derivation rest, by name, in the model's order.
///
/// # Errors
/// As for [`check`].
pub fn conditions(model: &Model, choice: &ParameterChoice) -> Result<Vec<String>, Diagnostics> {
    let model = &*choice.applied(model)?;
    let (alg, k, _) = checked(model, choice)?;
    let mut found = kinematics::diagnose::axes_by_numbers(&alg, model, &k);
    found.extend(k.fixed_vectors.iter().flat_map(|(_, difference)| difference));
    let closed = model.coordinates.iter().any(|c| c.closed_form.is_some());
    if closed || !k.implied.is_empty() || !k.implied_motions.is_empty() {
        found.extend(k.residuals.iter().chain(&k.implied).chain(k.q.iter()));
        found.extend(k.closed_forms.iter().map(|(_, form)| form));
        for row in k.rows.iter().chain(&k.spare_rows) {
            found.extend(row.coefficients.values().chain([&row.bias, &row.residual]));
        }
    }
    let symbols = alg.dag.symbols_of_all(&found);
    let rests = |id: &ParameterId| alg.dag.as_symbol(k.parameters[*id]).is_some_and(|s| symbols.contains(&s));
    Ok(model.parameters.ids().filter(rests).map(|id| model.parameters[id].name.clone()).collect())
}
