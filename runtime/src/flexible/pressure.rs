//! Pressure on the facets of a body (thesis 3.7, Eq. 3.10), its enclosed volume and its energy.
//!
//! A facet with corners a, b, c, d is the bilinear patch x(u, v). Three ways to share its force:
//! - `Fan`: Eq. 3.10 as printed, P (b-a) x (d-a) at each corner: around an inner point of a grid the four sum to
//!   P (E-W) x (N-S), four times the facet's area;
//! - `Facet`: P times the vector area (c-a) x (d-b) / 2, a quarter to each corner; on a closed surface the sum is 0;
//! - `Exact`: P times the gradient of the volume, integral of N_a(u, v) x_u x x_v: work is p dV to the last digit.
//!
//! Gas: constant gauge pressure, or p_abs V^n constant. Sign: normals and forces point outwards.

use super::element::Filled;
use super::{Body, BodyError};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A spring stretched to more than this many rest lengths counts as a runaway.
///
/// Membranes of linear springs lose their last equilibrium below twice the rest length; the factor 4
/// lies beyond every overshoot of a body that still has one.
pub const STRETCH_LIMIT: f64 = 4.0;

/// How a facet's force is shared by its corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PressureForm {
    /// Eq. 3.10 as printed.
    Fan,
    /// Vector area, equal shares.
    Facet,
    /// Gradient of the enclosed volume.
    Exact,
}

/// What the gas does when the volume changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gas<S> {
    /// Gauge pressure (Pa) held constant.
    Constant(S),
    /// p_abs V^n = constant.
    Polytropic {
        /// Gauge pressure at `volume` (Pa).
        pressure: S,
        /// Pressure outside (Pa), absolute.
        ambient: S,
        /// Volume at which `pressure` holds (m^3), > 0.
        volume: S,
        /// n: 1 slow, 1.4 fast.
        exponent: S,
        /// Volume (m^3) that the facets do not see (between an open sheet and its base).
        dead_volume: S,
    },
}

/// Gas and how it acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inflation<S> {
    /// Law of the gas.
    pub gas: Gas<S>,
    /// Sharing of the force.
    pub form: PressureForm,
}

/// Outward vectors (m^2) at the corners a, b, c, d of one facet; times the pressure they are forces.
#[must_use]
pub fn corner_shares<S: Scalar>(form: PressureForm, corners: [Vec3<S>; 4]) -> [Vec3<S>; 4] {
    let [a, b, c, d] = corners;
    let half = S::from_f64(0.5);
    if c == d && form != PressureForm::Fan {
        let share = vec3::scale(vec3::cross(vec3::sub(b, a), vec3::sub(c, a)), S::from_f64(1.0 / 6.0));
        return [share, share, share, vec3::zero()];
    }
    match form {
        PressureForm::Fan => [fan(a, b, d), fan(b, c, a), fan(c, d, b), fan(d, a, c)],
        PressureForm::Facet => {
            let area = vec3::scale(vec3::cross(vec3::sub(c, a), vec3::sub(d, b)), half);
            [vec3::scale(area, S::from_f64(0.25)); 4]
        }
        PressureForm::Exact => {
            [bilinear(a, b, c, d), bilinear(b, c, d, a), bilinear(c, d, a, b), bilinear(d, a, b, c)]
        }
    }
}

/// (next - at) x (previous - at): one of the cross products of Eq. 3.10.
fn fan<S: Scalar>(at: Vec3<S>, next: Vec3<S>, previous: Vec3<S>) -> Vec3<S> {
    vec3::cross(vec3::sub(next, at), vec3::sub(previous, at))
}

/// Integral over the patch of (1-u)(1-v) x_u x x_v, for the corner a.
//   x_u = (b-a)(1-v) + (c-d) v,  x_v = (d-a)(1-u) + (c-b) u;  int (1-u)^2 = 1/3, int u(1-u) = 1/6
fn bilinear<S: Scalar>(a: Vec3<S>, b: Vec3<S>, c: Vec3<S>, d: Vec3<S>) -> Vec3<S> {
    let (ab, dc) = (vec3::sub(b, a), vec3::sub(c, d));
    let (ad, bc) = (vec3::sub(d, a), vec3::sub(c, b));
    let mut sum = vec3::scale(vec3::cross(ab, ad), S::from_f64(1.0 / 9.0));
    sum = vec3::axpy(sum, S::from_f64(1.0 / 18.0), vec3::cross(ab, bc));
    sum = vec3::axpy(sum, S::from_f64(1.0 / 18.0), vec3::cross(dc, ad));
    vec3::axpy(sum, S::from_f64(1.0 / 36.0), vec3::cross(dc, bc))
}

/// The positions of a facet's corners.
#[must_use]
pub fn corners<S: Scalar>(pos: &[Vec3<S>], facet: &[usize; 4]) -> [Vec3<S>; 4] {
    facet.map(|p| vec3::at(pos, p))
}

/// Volume between the facets and the origin (m^3): the enclosed volume of a closed surface.
//   Euler's theorem for the cubic V: V = sum x . dV/dx / 3
#[must_use]
pub fn enclosed_volume<S: Scalar>(facets: &[[usize; 4]], pos: &[Vec3<S>]) -> S {
    let mut triple = S::ZERO;
    for facet in facets {
        let corners = corners(pos, facet);
        for (corner, share) in corners.iter().zip(corner_shares(PressureForm::Exact, corners)) {
            triple = triple + vec3::dot(*corner, share);
        }
    }
    triple * S::from_f64(1.0 / 3.0)
}

/// Gauge pressure (Pa) at a facet volume (m^3).
///
/// # Errors
/// [`BodyError::Collapsed`] where a gas law meets a volume that is not positive.
pub fn gauge_pressure<S: Scalar>(gas: &Gas<S>, facet_volume: S) -> Result<S, BodyError<S>> {
    match *gas {
        Gas::Constant(pressure) => Ok(pressure),
        Gas::Polytropic { pressure, ambient, volume, exponent, dead_volume } => {
            let now = facet_volume + dead_volume;
            if now > S::ZERO {
                Ok((pressure + ambient) * (exponent * (volume / now).ln()).exp() - ambient)
            } else {
                Err(BodyError::Collapsed { volume: now })
            }
        }
    }
}

/// Energy (J) that the gas can still give: -p V, or the work of the gas law against the air outside.
#[must_use]
pub fn energy<S: Scalar>(filled: &Filled<S>, pos: &[Vec3<S>]) -> S {
    let facet_volume = enclosed_volume(filled.facets, pos);
    match filled.inflation.gas {
        Gas::Constant(pressure) => -(pressure * facet_volume),
        Gas::Polytropic { pressure, ambient, volume, exponent, dead_volume } => {
            let now = facet_volume + dead_volume;
            let (absolute, log_ratio) = (pressure + ambient, (now / volume).ln());
            let power = exponent - S::ONE;
            // int p_abs dV from volume to now; n = 1 is the limit, taken where the quotient loses its digits.
            let work = if power.abs() > S::from_f64(1e-6) {
                absolute * volume * (S::ONE - (-(power * log_ratio)).exp()) / power
            } else {
                absolute * volume * log_ratio
            };
            ambient * (now - volume) - work
        }
    }
}

/// Adds the pressure's forces (N).
///
/// # Errors
/// [`BodyError::Collapsed`] where a gas law has no volume left.
pub fn add_force<S: Scalar>(
    filled: &Filled<S>,
    pos: &[Vec3<S>],
    force: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    let Filled { facets, inflation } = filled;
    let volume = match inflation.gas {
        Gas::Constant(_) => S::ZERO,
        Gas::Polytropic { .. } => enclosed_volume(facets, pos),
    };
    let pressure = gauge_pressure(&inflation.gas, volume)?;
    for facet in *facets {
        let shares = corner_shares(inflation.form, corners(pos, facet));
        for (point, share) in facet.iter().zip(shares) {
            vec3::add_at(force, *point, vec3::scale(share, pressure));
        }
    }
    Ok(())
}

/// Refuses a state in which the pressure stretched a spring beyond [`STRETCH_LIMIT`].
///
/// # Errors
/// [`BodyError::PressureTooHigh`] with the pressure at which it happened.
pub fn check_inflation<S: Scalar>(body: &Body<S>, pos: &[Vec3<S>]) -> Result<(), BodyError<S>> {
    let Some(inflation) = body.inflation else { return Ok(()) };
    let limit = S::from_f64(STRETCH_LIMIT);
    let runaway =
        |s: &super::Spring<S>| s.rest_length > S::ZERO && s.direction(pos).1 > limit * s.rest_length;
    match body.springs.iter().position(runaway) {
        None => Ok(()),
        Some(spring) => {
            let pressure = gauge_pressure(&inflation.gas, enclosed_volume(body.facets, pos))?;
            Err(BodyError::PressureTooHigh { pressure, spring })
        }
    }
}
