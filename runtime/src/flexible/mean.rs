//! Mean forces over a step whose work is the change of the stored energy (energy-momentum method).
//!
//! Each spring pulls with its mean tension along its mean direction: f = [K ((l + l')/2 - L) + C (l' - l)/h]
//! (d + d')/(l + l'). Its work over the step is then exactly -K [(l'-L)^2 - (l-L)^2]/2 - C (l'-l)^2/h.
//! Source: Simo & Tarnow 1992, Gonzalez 1996.

use super::pressure::{self, Gas};
use super::{Body, BodyError};
use crate::ode::nodes::Way;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Sets the forces to weight and air.
pub fn add_weight_and_air<S: Scalar>(body: &Body<S>, way: &Way<S>, force: &mut [Vec3<S>]) {
    for ((f, m), v) in force.iter_mut().zip(body.mass).zip(way.vel) {
        *f = vec3::axpy(vec3::scale(body.gravity, *m), -body.air_drag, *v);
    }
}

/// Adds springs and dampers.
pub fn add_springs<S: Scalar>(body: &Body<S>, way: &Way<S>, force: &mut [Vec3<S>]) {
    let half = S::from_f64(0.5);
    let [start, _, end] = way.pos;
    for spring in body.springs {
        let between = |pos: &[Vec3<S>]| vec3::sub(vec3::at(pos, spring.head), vec3::at(pos, spring.tail));
        let (before, after) = (between(start), between(end));
        let (l0, l1) = (vec3::norm(before), vec3::norm(after));
        let sum = l0 + l1;
        if sum > S::ZERO {
            // l1 - l0 without its cancellation: (after + before).(after - before)/(l0 + l1), the change
            // taken from the steps themselves: in a tiny step the positions hold nothing but rounding.
            let change = vec3::sub(vec3::at(way.dx, spring.head), vec3::at(way.dx, spring.tail));
            let growth = vec3::dot(vec3::add(after, before), change) / sum;
            let tension = spring.tension(half * sum) + spring.damping * growth / way.h;
            let pull = vec3::scale(vec3::add(before, after), tension / sum);
            vec3::add_at(force, spring.tail, pull);
            vec3::add_at(force, spring.head, vec3::scale(pull, -S::ONE));
        }
    }
}

/// Adds pressure times the mean gradient of the volume (Simpson's rule is exact: the gradient is quadratic).
///
/// # Errors
/// [`BodyError::Collapsed`] where a gas law has no volume left.
pub fn add_pressure<S: Scalar>(
    body: &Body<S>,
    way: &Way<S>,
    force: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    let Some(inflation) = body.inflation else { return Ok(()) };
    let [before, _, after] = way.pos;
    let pressure = mean_gauge_pressure(body, &inflation.gas, before, after)?;
    let weights = [S::from_f64(1.0 / 6.0), S::from_f64(4.0 / 6.0), S::from_f64(1.0 / 6.0)];
    for facet in body.facets {
        for (pos, weight) in way.pos.into_iter().zip(weights) {
            let shares = pressure::corner_shares(inflation.form, pressure::corners(pos, facet));
            for (point, share) in facet.iter().zip(shares) {
                vec3::add_at(force, *point, vec3::scale(share, weight * pressure));
            }
        }
    }
    Ok(())
}

/// Mean pressure over the change of volume: Simpson's rule on the gas law.
fn mean_gauge_pressure<S: Scalar>(
    body: &Body<S>,
    gas: &Gas<S>,
    before: &[Vec3<S>],
    after: &[Vec3<S>],
) -> Result<S, BodyError<S>> {
    let (v0, v1) = match gas {
        Gas::Constant(_) => (S::ZERO, S::ZERO),
        Gas::Polytropic { .. } => {
            (pressure::enclosed_volume(body, before), pressure::enclosed_volume(body, after))
        }
    };
    let middle = pressure::gauge_pressure(gas, S::from_f64(0.5) * (v0 + v1))?;
    let ends = pressure::gauge_pressure(gas, v0)? + pressure::gauge_pressure(gas, v1)?;
    Ok((ends + S::from_f64(4.0) * middle) * S::from_f64(1.0 / 6.0))
}
