//! Mean forces over a step whose work is the change of the stored energy (energy-momentum method).
//!
//! Each spring pulls with its mean tension along its mean direction: f = [K ((l + l')/2 - L) + C (l' - l)/h]
//! (d + d')/(l + l'). Its work over the step is then exactly -K [(l'-L)^2 - (l-L)^2]/2 - C (l'-l)^2/h.
//! Source: Simo & Tarnow 1992, Gonzalez 1996. In: positions in the middle of the step, and their changes over it.

use super::fault::BodyError;
use super::pressure::{self, Filled, Gas, PressureForm, Weights};
use super::spring::Spring;
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Adds the mean forces of a spring and its damper.
pub fn add_spring<S: Scalar>(spring: &Spring<S>, way: &MeanStep<S>, force: &mut [Vec3<S>]) {
    let [_, middle, _] = way.pos;
    let between = |rows: &[Vec3<S>]| vec3::sub(vec3::at(rows, spring.head), vec3::at(rows, spring.tail));
    let numbers = [spring.stiffness, spring.rest_length, spring.damping];
    spring.pull(pull([between(middle), between(way.dx)], numbers, way.h), force);
}

/// The mean force (N) on the tail of a spring with K, L, C, given the vector from tail to head in the middle and its
/// change (m).
///
/// With m = (d + d')/2 and c = d' - d the lengths are |m - c/2| and |m + c/2|, and l' - l = 2 m.c/(l + l'), which
/// avoids cancellation: in a tiny step the difference of positions is mostly rounding.
#[inline(always)]
pub(super) fn pull<S: Scalar>(
    [middle, change]: [Vec3<S>; 2],
    [stiffness, rest_length, damping]: [S; 3],
    h: S,
) -> Vec3<S> {
    let half = S::from_f64(0.5);
    let aside = vec3::scale(change, half);
    let sum = vec3::norm(vec3::sub(middle, aside)) + vec3::norm(vec3::add(middle, aside));
    let inverse = if sum > S::ZERO { S::from_f64(2.0) / sum } else { S::ZERO };
    let direction = vec3::scale(middle, inverse);
    let growth = vec3::dot(direction, change);
    vec3::scale(direction, stiffness * (half * sum - rest_length) + damping * (growth / h))
}

/// Energy dissipated by dampers over a step (J): C (l' - l)^2/h, the work of their part of the mean forces.
#[must_use]
pub fn dissipated<S: Scalar>(springs: &[Spring<S>], way: &MeanStep<S>) -> S {
    let [_, middle, _] = way.pos;
    springs.iter().filter(|spring| spring.damping > S::ZERO).fold(S::ZERO, |sum, spring| {
        let between = |rows: &[Vec3<S>]| vec3::sub(vec3::at(rows, spring.head), vec3::at(rows, spring.tail));
        let change = between(way.dx);
        let force = pull([between(middle), change], [S::ZERO, S::ZERO, spring.damping], way.h);
        sum + vec3::dot(force, change)
    })
}

/// Adds the pressure times the mean gradient of the volume over the step.
pub fn add_pressure<S: Scalar>(
    facets: &[[usize; 4]],
    form: PressureForm,
    pressure: S,
    way: &MeanStep<S>,
    force: &mut [Vec3<S>],
) {
    for facet in facets {
        let [_, _, c, d] = facet;
        let [middle, change] = [way.pos[1], way.dx].map(|rows| pressure::corners(rows, facet));
        let weights = Weights::of(form, c == d);
        let shares = match form {
            PressureForm::Fan => simpson(pressure::fan_shares(middle), pressure::fan_shares(change)),
            _ => simpson(pressure::shares(weights, middle), pressure::shares(weights, change)),
        };
        for (point, share) in facet.iter().zip(shares) {
            vec3::add_at(force, *point, vec3::scale(share, pressure));
        }
    }
}

/// Mean over a step of a quadratic form of the corners x: Q(x) in the middle + Q(change)/12, exact like Simpson's rule.
#[inline(always)]
pub(super) fn simpson<S: Scalar>([a, b, c, d]: [Vec3<S>; 4], [p, q, r, s]: [Vec3<S>; 4]) -> [Vec3<S>; 4] {
    let w = S::from_f64(1.0 / 12.0);
    [vec3::axpy(a, w, p), vec3::axpy(b, w, q), vec3::axpy(c, w, r), vec3::axpy(d, w, s)]
}

/// Mean gauge pressure (Pa) over the change of volume: Simpson's rule on the gas law.
///
/// # Errors
/// [`BodyError::Collapsed`] if a gas law has no volume left.
pub fn pressure<S: Scalar>(filled: &Filled<S>, way: &MeanStep<S>) -> Result<S, BodyError<S>> {
    let gas = &filled.inflation.gas;
    let volume = |pos: &[Vec3<S>]| match gas {
        Gas::Constant(_) => S::ZERO,
        Gas::Polytropic { .. } => pressure::enclosed_volume(filled.facets, pos),
    };
    let [before, _, after] = way.pos;
    let (v0, v1) = (volume(before), volume(after));
    let middle = pressure::gauge_pressure(gas, S::from_f64(0.5) * (v0 + v1))?;
    let ends = pressure::gauge_pressure(gas, v0)? + pressure::gauge_pressure(gas, v1)?;
    Ok((ends + S::from_f64(4.0) * middle) * S::from_f64(1.0 / 6.0))
}
