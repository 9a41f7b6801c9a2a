//! Jumps and kinks: states at which the argument of a `sign` is 0, or that of an `abs`, `min` or `max`, so that the
//! equations have no slopes there, or others on each side.
//!
//! In: a model. Out: the model with one more output for each such argument that its loads read, directly or through
//! definitions and laws; and, at a state, a warning for each `sign` whose argument is 0 up to its rounding, and for
//! each kink where the slopes at both sides differ and the state is known no better than to either side of it.

use super::balance::{BOUNDS, CLOSE};
use super::rates::NO_SLOPE;
use super::search::Search;
use crate::jumps::{self, Jump};
use nalgebra::{DMatrix, DVector};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::{Model, Output};

/// How far away the slopes at both sides of a kink are compared, in units of half the ranges: beyond how well the state
/// is known, and so far that slopes which bend without a jump differ less at the former.
const SIDES: [f64; 2] = [1e2 * CLOSE, 1e5 * CLOSE];
/// Slopes that differ by less than this fraction of the largest of their row are the same.
const SAME: f64 = 1e-6;

/// A function in a load that jumps or has a kink, and the index of its argument among the outputs.
pub(super) struct Watched {
    jump: Jump,
    output: usize,
}

/// The model that shows the arguments as its last outputs: those of jumps, then those of kinks.
pub(super) fn watched(model: &Model) -> (Model, [Vec<Watched>; 2]) {
    let mut watched = model.clone();
    let mut show = |jump: Jump| {
        let output = watched.outputs.len();
        let (name, value) = (format!("argument {output}"), jump.argument.clone());
        watched.outputs.push(Output { name, value, unit: "1".to_owned(), span: jump.span });
        Watched { jump, output }
    };
    let all = [jumps::of_loads(model), jumps::kinks_of_loads(model)];
    let all = all.map(|own| own.into_iter().map(&mut show).collect());
    (watched, all)
}

/// Warnings of the kinks at the state of the search.
pub(super) fn kinks(model: &Model, kinks: &[Watched], search: &mut Search<'_>) -> Diagnostics {
    let mut warnings = Diagnostics::new(model.source.clone());
    let outputs = search.rounded_outputs();
    for Watched { jump, output } in kinks {
        if outputs.get(*output).is_some_and(|&value| search.bends(*output, value)) {
            let message = format!(
                "`{}` has a kink at this state: the linearisation and its modes do not hold on both sides of it",
                jump.owner
            );
            let help =
                "they do not tell whether the equilibrium is stable; `run` from a state to each side of it";
            warnings.push(Diagnostic::warning(message).label(jump.span, "a kink").help(help));
        }
    }
    warnings
}

impl Search<'_> {
    /// Do the slopes of the rates jump where an output is 0, and is it 0 here as well as the state is known?
    fn bends(&mut self, output: usize, (value, error): (f64, f64)) -> bool {
        let Some(way) = self.slope_of_output(output) else { return false };
        let size = way.norm();
        if size == 0.0 || value.abs() > CLOSE * size + BOUNDS * error {
            return false;
        }
        let way = way / size;
        let [near, far] = SIDES.map(|distance| {
            let [one, other] = [distance, -distance].map(|distance| self.slopes_beside(&way, distance));
            Some((one.as_ref()? - other.as_ref()?, one? + other?))
        });
        let (Some((near, sum)), Some((far, _))) = (near, far) else { return false };
        let largest = sum.amax();
        let jumps = |row: usize| {
            let [near, far, sum] = [&near, &far, &sum].map(|slopes| slopes.row(row).amax());
            near > 0.5 * far && near > SAME * sum + NO_SLOPE * largest
        };
        (0..near.nrows()).any(jumps)
    }

    /// Derivatives of an output by the state, in units of its ranges.
    fn slope_of_output(&mut self, output: usize) -> Option<DVector<f64>> {
        let n = self.state.len();
        let near = self.near().ok()?;
        // Behind the slopes of the rates by the state and by the inputs.
        let slopes = near.get(n * (n + self.inputs.len() + output)..)?;
        Some(DVector::from_iterator(n, self.state.iter().zip(slopes).map(|(entry, c)| c * entry.scale)))
    }

    /// Slopes of the rates by the state at a distance from here.
    fn slopes_beside(&mut self, way: &DVector<f64>, distance: f64) -> Option<DMatrix<f64>> {
        let here = self.place();
        let (mut q, mut u) = (here.0.clone(), here.1.clone());
        for (entry, d) in self.state.iter().zip(way) {
            let list = if entry.is_speed { &mut u } else { &mut q };
            list[entry.place] += distance * entry.scale * d;
        }
        let assembled = self.configurations.follow(0.0, &here.0, &q).ok()?;
        self.return_to((assembled, u, here.2.clone()));
        let slopes = self.rates().ok().map(|rates| rates.slopes.a);
        self.return_to(here);
        slopes
    }
}

/// Warnings of the jumps at the state of the search.
pub(super) fn warnings(model: &Model, jumps: &[Watched], search: &mut Search<'_>) -> Diagnostics {
    let mut warnings = Diagnostics::new(model.source.clone());
    let outputs = search.rounded_outputs();
    for Watched { jump, output } in jumps {
        let is_zero = |x: &(f64, f64)| x.0.abs() <= BOUNDS * x.1;
        if outputs.get(*output).is_some_and(is_zero) {
            let message = format!(
                "`{}` jumps at this state: the linearisation and its modes leave the jump out",
                jump.owner
            );
            let help = "its slope counts as 0, so that dry friction damps nothing and holds nothing; to include it write \
                        tanh(u/w) with a width w for sign(u)";
            warnings.push(Diagnostic::warning(message).label(jump.span, "sign of 0").help(help));
        }
    }
    warnings
}
