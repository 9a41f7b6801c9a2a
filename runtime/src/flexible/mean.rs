//! Mean forces over a step whose work is the change of the stored energy (energy-momentum method).
//!
//! Each spring pulls with its mean tension along its mean direction: f = [K ((l + l')/2 - L) + C (l' - l)/h]
//! (d + d')/(l + l'). Its work over the step is then exactly -K [(l'-L)^2 - (l-L)^2]/2 - C (l'-l)^2/h.
//! Source: Simo & Tarnow 1992, Gonzalez 1996.

use super::element::Filled;
use super::pressure::{self, Gas};
use super::{BodyError, Spring};
use crate::ode::nodes::Way;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Adds a spring and its damper.
pub fn add_spring<S: Scalar>(spring: &Spring<S>, way: &Way<S>, force: &mut [Vec3<S>]) {
    let half = S::from_f64(0.5);
    let [start, _, end] = way.pos;
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
        spring.pull(vec3::scale(vec3::add(before, after), tension / sum), force);
    }
}

/// Adds pressure times the mean gradient of the volume (Simpson's rule is exact: the gradient is quadratic).
///
/// # Errors
/// [`BodyError::Collapsed`] where a gas law has no volume left.
pub fn add_pressure<S: Scalar>(
    filled: &Filled<S>,
    way: &Way<S>,
    force: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    let Filled { facets, inflation } = filled;
    let [before, _, after] = way.pos;
    let pressure = mean_gauge_pressure(facets, &inflation.gas, before, after)?;
    let weights = [S::from_f64(1.0 / 6.0), S::from_f64(4.0 / 6.0), S::from_f64(1.0 / 6.0)];
    for facet in *facets {
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
    facets: &[[usize; 4]],
    gas: &Gas<S>,
    before: &[Vec3<S>],
    after: &[Vec3<S>],
) -> Result<S, BodyError<S>> {
    let (v0, v1) = match gas {
        Gas::Constant(_) => (S::ZERO, S::ZERO),
        Gas::Polytropic { .. } => {
            (pressure::enclosed_volume(facets, before), pressure::enclosed_volume(facets, after))
        }
    };
    let middle = pressure::gauge_pressure(gas, S::from_f64(0.5) * (v0 + v1))?;
    let ends = pressure::gauge_pressure(gas, v0)? + pressure::gauge_pressure(gas, v1)?;
    Ok((ends + S::from_f64(4.0) * middle) * S::from_f64(1.0 / 6.0))
}
