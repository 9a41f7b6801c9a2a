//! Finds numbers that no mechanism has: negative masses and lengths, moments of inertia that violate the triangle
//! inequality, nominal values outside their ranges.
//!
//! In: a model and the values of its parameters. Out: errors where the equations would be meaningless, warnings for
//! probable slips. Only constants are judged, nothing that depends on the state.

use super::evaluate::Constants;
use crate::diagnostic::Diagnostic;
use crate::id::IdVec;
use crate::model::data::*;
use crate::model::expression::{Expr, ExprKind, Function};
use crate::model::ids::*;

/// Tolerance of the triangle inequality of principal moments for rounding, relative to the sum of two.
const ROUNDING: f64 = 1e-9;

impl Model {
    /// What is implausible at these values of the parameters.
    #[must_use]
    pub fn implausible(&self, parameters: &IdVec<ParameterId, f64>) -> Vec<Diagnostic> {
        let constants = Constants::with(self, parameters);
        let mut found: Vec<Diagnostic> = self.coordinates.iter().filter_map(outside).collect();
        for body in self.bodies.iter() {
            let mass = body.mass.as_ref().map(|mass| (constants.value(mass), mass.span));
            if let Some((mass, span)) = mass.filter(|(mass, _)| *mass < 0.0) {
                found.push(
                    Diagnostic::error(format!("the mass of `{}` is negative", body.name))
                        .label(span, format!("{mass} kg"))
                        .help("a mass is 0 or more: correct the expression or its parameters"),
                );
            }
            let mut lengths = body.lengths.iter().map(|length| (constants.value(length), length.span));
            if let Some((length, span)) = lengths.find(|(length, _)| *length < 0.0) {
                found.push(
                    Diagnostic::error(format!("a length of the shape of `{}` is negative", body.name))
                        .label(span, format!("{} m", (1e12 * length).round() / 1e12))
                        .help("lengths of a shape are 0 or more, and the outer radius of a hollow one comes first: correct the \
                               expression or its parameters"),
                );
            }
            let entries: [Option<f64>; 6] =
                std::array::from_fn(|i| body.inertia[i].as_ref().map(|e| constants.value(e)));
            let [x, y, z, ..] = entries;
            found.extend(wrong_moments(body, [x, y, z]).or_else(|| wrong_products(body, entries)));
        }
        found.extend(self.wrong_widths(&constants));
        found
    }
}

impl Model {
    /// Errors for the widths of smooth steps that are constant and not above 0: a negative one would mirror the step.
    fn wrong_widths(&self, constants: &Constants) -> Vec<Diagnostic> {
        let mut found = Vec::new();
        let mut look = |e: &Expr| {
            if let ExprKind::Call(Function::SmoothStep, arguments) = &e.kind
                && let Some(width) = arguments.get(1)
                && constants.value(width) <= 0.0
            {
                found.push(
                    Diagnostic::error("the width of a `smooth_step` is not positive")
                        .label(width.span, format!("evaluates to {}", constants.value(width)))
                        .help(
                            "smooth_step(x, width) rises from -width to width: give a width above 0, and write \
                             1 - smooth_step(x, width) for a step down",
                        ),
                );
            }
        };
        self.expressions().into_iter().for_each(|(_, expr)| expr.visit(&mut |e| look(e)));
        found
    }
}

fn outside(coordinate: &Coordinate) -> Option<Diagnostic> {
    let (low, high) = coordinate.range;
    let (unit, size) = &coordinate.written_unit;
    let written = |x: f64| x / size;
    if low > high {
        return Some(
            Diagnostic::error(format!("the range of `{}` ends before it begins", coordinate.name))
                .label(coordinate.span, format!("[{}, {}] {unit}", written(low), written(high)))
                .help("give the lower end first: range = [-1, 1]"),
        );
    }
    let is_outside = coordinate.nominal < low || high < coordinate.nominal;
    is_outside.then(|| {
        Diagnostic::warning(format!("the nominal value of `{}` lies outside its range", coordinate.name))
            .label(
                coordinate.span,
                format!("{} of [{}, {}] {unit}", written(coordinate.nominal), written(low), written(high)),
            )
            .help("give a nominal value within `range`: configurations are sampled there")
    })
}

/// Finds products of inertia with which the moment about some axis is below 0: a principal minor of the matrix is.
fn wrong_products(body: &Body, entries: [Option<f64>; 6]) -> Option<Diagnostic> {
    const NAMES: [&str; 3] = ["Iyz", "Ixz", "Ixy"];
    let moment = |i: usize| entries[i].unwrap_or(f64::NAN);
    let product = |i: usize| entries[3 + i].unwrap_or(0.0);
    // The minor without row i. Moments that are left out have no effect, nor has what stands beside them.
    let others = |i: usize| moment((i + 1) % 3) * moment((i + 2) % 3);
    let worst = (0..3).find(|&i| product(i).powi(2) > others(i) * (1.0 + ROUNDING));
    let (i, what) = match worst {
        Some(i) => {
            (i, format!("{} = {} kg m^2 is too large for the two moments beside it", NAMES[i], product(i)))
        }
        None => {
            let taken: f64 = (0..3).map(|i| moment(i) * product(i).powi(2)).sum();
            let whole = moment(0) * others(0) + 2.0 * product(0) * product(1) * product(2);
            let size = moment(0) * others(0);
            let is_negative = whole - taken < -ROUNDING * size;
            if !is_negative {
                return None;
            }
            let i = (0..3).max_by(|&i, &j| product(i).abs().total_cmp(&product(j).abs()))?;
            (i, "the products are too large for the moments".to_owned())
        }
    };
    let span = body.inertia[3 + i].as_ref().map_or(body.span, |e| e.span);
    Some(
        Diagnostic::error(format!("the moment of inertia of `{}` about some axis is negative", body.name))
            .label(span, what)
            .help("a matrix of inertia is positive, such as Ixy^2 <= Ixx Iyy: correct the products, or their moments"),
    )
}

/// Finds moments below 0, or larger than the sum of the two others.
fn wrong_moments(body: &Body, moments: [Option<f64>; 3]) -> Option<Diagnostic> {
    const NAMES: [&str; 3] = ["Ixx", "Iyy", "Izz"];
    let span = |i: usize| body.inertia[i].as_ref().map_or(body.span, |e| e.span);
    let value = |i: usize| moments[i].unwrap_or(f64::NAN);
    if let Some(i) = (0..3).find(|&i| value(i) < 0.0) {
        return Some(
            Diagnostic::error(format!("the moment of inertia {} of `{}` is negative", NAMES[i], body.name))
                .label(span(i), format!("{} kg m^2", value(i)))
                .help("a moment of inertia is 0 or more: correct the expression or its parameters"),
        );
    }
    let others = |i: usize| value((i + 1) % 3) + value((i + 2) % 3);
    let i = (0..3).find(|&i| value(i) > others(i) * (1.0 + ROUNDING))?;
    Some(
        Diagnostic::warning(format!("the moments of inertia of `{}` cannot be those of a body", body.name))
            .label(
                span(i),
                format!("{} = {} kg m^2 is more than the sum of the other two", NAMES[i], value(i)),
            )
            .help("each moment is at most the sum of the other two, such as Izz <= Ixx + Iyy: correct the moments, \
                   or leave out those that have no effect"),
    )
}
