//! Finds numbers that no mechanism has: negative masses, moments of inertia that violate the triangle inequality,
//! nominal values outside their ranges.
//!
//! In: a model and the values of its parameters. Out: errors where the equations would be meaningless, warnings for
//! probable slips. Only constants are judged, nothing that depends on the state.

use super::evaluate::Constants;
use crate::diagnostic::Diagnostic;
use crate::id::IdVec;
use crate::model::data::*;
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
            let moments: [Option<f64>; 3] =
                std::array::from_fn(|i| body.inertia[i].as_ref().map(|e| constants.value(e)));
            found.extend(wrong_moments(body, moments));
        }
        found
    }
}

fn outside(coordinate: &Coordinate) -> Option<Diagnostic> {
    let (low, high) = coordinate.range;
    let (unit, size) = &coordinate.written_unit;
    let written = |x: f64| x / size;
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
