//! Pressure on the facets of a body (thesis 3.7, Eq. 3.10), its enclosed volume and its energy.
//!
//! A facet with corners a, b, c, d is the bilinear patch x(u, v). Three ways to share its force:
//! - `Fan`: Eq. 3.10 as printed, P (b-a) x (d-a) at each corner: around an inner point of a grid the four sum to
//!   P (E-W) x (N-S), four times the facet's area;
//! - `Facet`: P times the vector area (c-a) x (d-b) / 2, a quarter to each corner; on a closed surface the sum is 0;
//! - `Exact`: P times the gradient of the volume, integral of N_a(u, v) x_u x x_v: work is p dV to the last digit.
//!
//! Gas: constant gauge pressure, or p_abs V^n constant. Sign: normals and forces point outwards.

use super::fault::BodyError;
use super::spring::{Spring, is_runaway};
use crate::gas::work;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

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

/// How the gas responds to a change of volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gas<S> {
    /// Gauge pressure (Pa) held constant.
    Constant(S),
    /// p_abs V^n = constant.
    Polytropic {
        /// Gauge pressure at `volume` (Pa).
        pressure: S,
        /// Absolute ambient pressure (Pa).
        ambient: S,
        /// Volume at which `pressure` holds (m^3), > 0.
        volume: S,
        /// n: 1 for slow (isothermal) changes, 1.4 for fast (adiabatic) ones.
        exponent: S,
        /// Volume (m^3) that the facets do not enclose (between an open sheet and its base).
        dead_volume: S,
    },
}

/// Gas and how it acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inflation<S> {
    /// Law of the gas.
    pub gas: Gas<S>,
    /// How a facet's force is shared by its corners.
    pub form: PressureForm,
}

/// Facets and the gas inside. The gas is left out of the bound on the stable step; where its stiffness matters, choose
/// the step yourself.
#[derive(Clone, Copy, Debug)]
pub struct Filled<'a, S> {
    /// Corners of each facet.
    pub facets: &'a [[usize; 4]],
    /// The gas.
    pub inflation: Inflation<S>,
}

/// Weights of the cross products at each corner, see [`corner_shares`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Weights<S> {
    /// Of p x q, at corners a, b, c.
    area: S,
    /// Of p x q, at corner d.
    last: S,
    /// Of q x g and p x g.
    warp: S,
}

impl<S: Scalar> Weights<S> {
    /// Weights that give forces instead of vectors, for a facet with four corners under a pressure.
    #[inline(always)]
    pub fn times(self, pressure: S) -> Self {
        let Weights { area, last, warp } = self;
        Weights { area: area * pressure, last: last * pressure, warp: warp * pressure }
    }

    /// Weights for a facet with four corners, or for a triangle (c = d), which is flat and whose three corners take
    /// equal shares.
    pub fn of(form: PressureForm, is_triangle: bool) -> Self {
        if is_triangle {
            return Weights { area: S::from_f64(1.0 / 6.0), last: S::ZERO, warp: S::ZERO };
        }
        let (area, warp) = (S::from_f64(1.0 / 8.0), S::from_f64(1.0 / 24.0));
        Weights { area, last: area, warp: if form == PressureForm::Exact { warp } else { S::ZERO } }
    }
}

/// Outward vectors (m^2) at the corners a, b, c, d of one facet; times the pressure they are forces.
///
/// With the diagonals p = c - a, q = d - b and the warp g = (a + c) - (b + d), the gradient of the volume
/// (integral of N_a x_u x x_v over u, v in 0..1) is p x q/8 at every corner, + q x g/24 at a, - at c, + p x g/24 at
/// b, - at d.
//   x_u = U + (2v - 1) g/2, x_v = V + (2u - 1) g/2 with U = (p - q)/2, V = (p + q)/2, so
//   x_u x x_v = p x q/2 + ((2v - 1) g x V + (2u - 1) U x g)/2;  int N_a = 1/4, int N_a (2u - 1) = int N_a (2v - 1) = -1/12
#[inline(always)]
#[must_use]
pub fn corner_shares<S: Scalar>(form: PressureForm, corners: [Vec3<S>; 4]) -> [Vec3<S>; 4] {
    let [_, _, c, d] = corners;
    match form {
        PressureForm::Fan => fan_shares(corners),
        _ if c == d => shares(Weights::of(form, true), corners),
        _ => shares(Weights::of(form, false), corners),
    }
}

/// [`corner_shares`] of [`PressureForm::Fan`].
#[inline(always)]
pub(super) fn fan_shares<S: Scalar>([a, b, c, d]: [Vec3<S>; 4]) -> [Vec3<S>; 4] {
    [fan(a, b, d), fan(b, c, a), fan(c, d, b), fan(d, a, c)]
}

/// [`shares`] of a facet with four corners, with fewer operations in another order.
#[inline(always)]
pub(super) fn quad_shares<S: Scalar>(weights: Weights<S>, [a, b, c, d]: [Vec3<S>; 4]) -> [Vec3<S>; 4] {
    let (p, q) = (vec3::sub(c, a), vec3::sub(d, b));
    let g = vec3::sub(vec3::sub(c, b), vec3::sub(d, a));
    let share = vec3::scale(vec3::cross(p, q), weights.area);
    let g = vec3::scale(g, weights.warp);
    let (side, lengthways) = (vec3::cross(q, g), vec3::cross(p, g));
    [
        vec3::add(share, side),
        vec3::add(share, lengthways),
        vec3::sub(share, side),
        vec3::sub(share, lengthways),
    ]
}

/// [`corner_shares`] of the other forms.
#[inline(always)]
pub(super) fn shares<S: Scalar>(weights: Weights<S>, [a, b, c, d]: [Vec3<S>; 4]) -> [Vec3<S>; 4] {
    let (p, q) = (vec3::sub(c, a), vec3::sub(d, b));
    let g = vec3::sub(vec3::add(a, c), vec3::add(b, d));
    let area = vec3::cross(p, q);
    let (side, lengthways) = (vec3::cross(q, g), vec3::cross(p, g));
    let share = vec3::scale(area, weights.area);
    [
        vec3::axpy(share, weights.warp, side),
        vec3::axpy(share, weights.warp, lengthways),
        vec3::axpy(share, -weights.warp, side),
        vec3::axpy(vec3::scale(area, weights.last), -weights.warp, lengthways),
    ]
}

/// (next - at) x (previous - at): one of the cross products of Eq. 3.10.
fn fan<S: Scalar>(at: Vec3<S>, next: Vec3<S>, previous: Vec3<S>) -> Vec3<S> {
    vec3::cross(vec3::sub(next, at), vec3::sub(previous, at))
}

/// The positions of a facet's corners.
#[must_use]
pub fn corners<S: Scalar>(pos: &[Vec3<S>], facet: &[usize; 4]) -> [Vec3<S>; 4] {
    facet.map(|p| vec3::at(pos, p))
}

/// Volume between facets and the origin (m^3), as it is summed up; its parts have factors of their own.
//   Euler's theorem for the cubic V: 3 V = sum x . dV/dx over the corners; what the warp gives cancels in it, so that a
//   facet has 3 V = p x q . (a + b + c + d)/8, a triangle p x q . (a + b + c)/6
#[derive(Clone, Copy, Debug)]
pub struct Volume<S> {
    /// 24 times that of facets with four corners.
    pub quads: S,
    /// 18 times that of triangles.
    pub triangles: S,
}

impl<S: Scalar> Volume<S> {
    /// No facet.
    #[must_use]
    pub fn zero() -> Self {
        Volume { quads: S::ZERO, triangles: S::ZERO }
    }

    /// Adds facets.
    pub fn add(&mut self, facets: &[[usize; 4]], pos: &[Vec3<S>]) {
        for facet in facets {
            let [a, b, c, d] = corners(pos, facet);
            if c == d {
                let area = vec3::cross(vec3::sub(c, a), vec3::sub(d, b));
                self.triangles = self.triangles + vec3::dot(area, vec3::add(vec3::add(a, b), c));
            } else {
                self.quads = self.quads + quad_volume([a, b, c, d]);
            }
        }
    }

    /// The sum (m^3).
    #[must_use]
    pub fn total(self) -> S {
        self.quads * S::from_f64(1.0 / 24.0) + self.triangles * S::from_f64(1.0 / 18.0)
    }
}

/// 24 times the volume between a facet with four corners and the origin (m^3).
#[inline(always)]
pub(super) fn quad_volume<S: Scalar>([a, b, c, d]: [Vec3<S>; 4]) -> S {
    let area = vec3::cross(vec3::sub(c, a), vec3::sub(d, b));
    vec3::dot(area, vec3::add(vec3::add(vec3::add(a, b), c), d))
}

/// Volume between the facets and the origin (m^3): the enclosed volume of a closed surface.
#[must_use]
pub fn enclosed_volume<S: Scalar>(facets: &[[usize; 4]], pos: &[Vec3<S>]) -> S {
    let mut volume = Volume::zero();
    volume.add(facets, pos);
    volume.total()
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

/// Energy (J) that the gas can still release: -p V, or the work of the gas law against the ambient pressure.
#[must_use]
pub fn energy<S: Scalar>(filled: &Filled<S>, pos: &[Vec3<S>]) -> S {
    let facet_volume = enclosed_volume(filled.facets, pos);
    match filled.inflation.gas {
        Gas::Constant(pressure) => -(pressure * facet_volume),
        Gas::Polytropic { pressure, ambient, volume, exponent, dead_volume } => {
            let now = facet_volume + dead_volume;
            let (absolute, log_ratio) = (pressure + ambient, (now / volume).ln());
            // int p_abs dV from `volume` to `now`.
            let work = work(absolute * volume, exponent, log_ratio);
            ambient * (now - volume) - work
        }
    }
}

/// Gauge pressure (Pa) at these positions.
///
/// # Errors
/// [`BodyError::Collapsed`] where a gas law has no volume left.
pub fn of<S: Scalar>(filled: &Filled<S>, pos: &[Vec3<S>]) -> Result<S, BodyError<S>> {
    let volume = match filled.inflation.gas {
        Gas::Constant(_) => S::ZERO,
        Gas::Polytropic { .. } => enclosed_volume(filled.facets, pos),
    };
    gauge_pressure(&filled.inflation.gas, volume)
}

/// Refuses a spring that the pressure has stretched beyond [`STRETCH_LIMIT`], naming spring and pressure.
pub(super) fn runaway<S: Scalar>(
    filled: &Filled<S>,
    springs: &[Spring<S>],
    pos: &[Vec3<S>],
) -> Result<(), BodyError<S>> {
    match springs.iter().position(|spring| is_runaway(spring.rest_length, spring.direction(pos).1)) {
        None => Ok(()),
        Some(spring) => {
            let pressure = gauge_pressure(&filled.inflation.gas, enclosed_volume(filled.facets, pos))?;
            Err(BodyError::PressureTooHigh { pressure, spring })
        }
    }
}
