//! A flexible body: everything that is constant in a run, as a view over the caller's slices.

use super::fault::{BodyError, Quantity};
use super::grid::Grid;
use super::patch::Patches;
use super::pressure::{Gas, Inflation};
use super::spring::Spring;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// A list of fewer springs is short.
const SHORT: usize = if cfg!(target_os = "none") { 0 } else { 64 };

/// A microcontroller's constants are printed by a host, which has checked them; its flash is small.
pub(crate) const ON_HOST: bool = !cfg!(target_os = "none");

/// What never changes in a run.
#[derive(Clone, Copy, Debug)]
pub struct Body<'a, S> {
    /// Mass of each point (kg), > 0; 0 only for a massless contact point.
    pub mass: &'a [S],
    /// True where a point is held in space.
    pub fixed: &'a [bool],
    /// [`Body::inverse_mass`] of each point (1/kg), once for each component. May be empty where memory is scarcer than
    /// time: the divisions are then repeated in every step.
    pub inverse_mass: &'a [Vec3<S>],
    /// Spring-dampers, in the order in which their forces are summed.
    pub springs: &'a [Spring<S>],
    /// Acceleration of gravity (m/s^2), downwards.
    pub gravity: Vec3<S>,
    /// Viscous force of the air per point and speed (N s/m), >= 0.
    pub air_drag: S,
    /// Corners of each facet, counter-clockwise seen from outside; a triangle repeats its third.
    pub facets: &'a [[usize; 4]],
    /// Gas inside the facets.
    pub inflation: Option<Inflation<S>>,
    /// The points of mass 0 that are not fixed.
    pub massless: Massless<'a>,
    /// Springs and facets that form grids, listed a second time in the order of the lists: their forces then take a
    /// fraction of the time.
    pub grids: &'a [Grid<'a, S>],
    /// All springs once more, cut into patches; for bodies without grids.
    pub patches: Option<Patches<'a, S>>,
}

/// The massless points with the springs of each, which saves a search through all springs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Massless<'a> {
    /// The points.
    pub points: &'a [usize],
    /// Index in `springs` at which the springs of each point begin, and finally the length of `springs`.
    pub first: &'a [usize],
    /// Indices of springs, point after point.
    pub springs: &'a [usize],
}

impl<'a> Massless<'a> {
    /// Each massless point with its springs.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &'a [usize])> {
        let springs = self.springs;
        let ranges = self.first.iter().zip(self.first.iter().skip(1));
        let list = move |(from, to): (&usize, &usize)| springs.get(*from..*to).unwrap_or_default();
        self.points.iter().copied().zip(ranges.map(list))
    }
}

impl<'a, S: Scalar> Body<'a, S> {
    /// Checks lengths, point indices and signs; on a microcontroller, whose tables a host has printed from a checked
    /// body, those of masses, springs and facets only.
    ///
    /// # Errors
    /// The first defect.
    pub fn new(candidate: Body<'a, S>) -> Result<Body<'a, S>, BodyError<S>> {
        let points = candidate.mass.len();
        if points == 0 {
            return Err(BodyError::Empty);
        }
        if candidate.fixed.len() != points {
            return Err(BodyError::Length { expected: points, found: candidate.fixed.len() });
        }
        let listed = candidate.inverse_mass.len();
        if listed != 0 && listed != points {
            return Err(BodyError::Length { expected: points, found: listed });
        }
        let not_negative = |x: S| x >= S::ZERO && x.is_finite();
        if let Some(index) = candidate.mass.iter().position(|m| !not_negative(*m)) {
            return Err(BodyError::Negative { index });
        }
        for (index, spring) in candidate.springs.iter().enumerate() {
            if spring.head >= points || spring.tail >= points {
                return Err(BodyError::UnknownPoint { point: spring.head.max(spring.tail), points });
            }
            if !(not_negative(spring.stiffness)
                && not_negative(spring.damping)
                && not_negative(spring.rest_length))
            {
                return Err(BodyError::Negative { index });
            }
        }
        let listed = candidate.massless.points;
        if let Some(point) = candidate.facets.iter().flatten().chain(listed).find(|p| **p >= points) {
            return Err(BodyError::UnknownPoint { point: *point, points });
        }
        let points = candidate.mass.iter().zip(candidate.fixed);
        let expected = points.filter(|(m, fixed)| **m == S::ZERO && !**fixed).count();
        if candidate.massless.iter().count() < expected {
            return Err(BodyError::Length { expected, found: listed.len() });
        }
        if ON_HOST && let Some(quantity) = candidate.out_of_range() {
            return Err(BodyError::OutOfRange(quantity));
        }
        Ok(candidate)
    }

    /// The first of the other constants that is out of range.
    fn out_of_range(&self) -> Option<Quantity> {
        let positive = |x: S| x > S::ZERO && x.is_finite();
        let is_gas = self.inflation.is_none_or(|inflation| match inflation.gas {
            Gas::Constant(pressure) => pressure.is_finite(),
            Gas::Polytropic { pressure, ambient, volume, exponent, dead_volume } => {
                let finite = [pressure, ambient, dead_volume].iter().all(|x| x.is_finite());
                finite && positive(volume) && positive(exponent)
            }
        });
        let massless = |i: &usize| self.mass.get(*i) == Some(&S::ZERO) && self.fixed.get(*i) == Some(&false);
        let holds =
            |i: usize, spring: usize| self.springs.get(spring).is_some_and(|s| s.head == i || s.tail == i);
        let held = self.massless.iter().all(|(i, springs)| springs.iter().all(|spring| holds(i, *spring)));
        let within =
            |list: &[usize]| list.is_sorted() && list.iter().all(|n| *n <= self.massless.springs.len());
        // A division more or less.
        let near = |x: S, own: S| (x - own).abs() <= S::from_f64(4.0) * S::EPSILON * own;
        let mut inverse = self.inverse_mass.iter().enumerate();
        let checks = [
            (self.gravity.iter().all(|g| g.is_finite()), Quantity::Gravity),
            (self.air_drag >= S::ZERO && self.air_drag.is_finite(), Quantity::AirDrag),
            (is_gas, Quantity::Gas),
            (
                inverse.all(|(i, row)| row.iter().all(|x| near(*x, self.inverse_mass(i)))),
                Quantity::InverseMass,
            ),
            (self.massless.points.iter().all(massless), Quantity::MasslessPoints),
            (held && within(self.massless.first), Quantity::MasslessSprings),
        ];
        checks.iter().find(|(is_sound, _)| !is_sound).map(|(_, quantity)| *quantity)
    }

    /// A body without points, for a world without flexible parts.
    #[must_use]
    pub fn none() -> Body<'a, S> {
        Body {
            mass: &[],
            fixed: &[],
            inverse_mass: &[],
            springs: &[],
            gravity: [S::ZERO; 3],
            air_drag: S::ZERO,
            facets: &[],
            inflation: None,
            massless: Massless::default(),
            grids: &[],
            patches: None,
        }
    }

    /// Its springs, where they are few and all that it has: they are then taken one by one, without asking for each
    /// kind of element. A microcontroller has one loop for all bodies.
    #[must_use]
    pub fn short_list(&self) -> Option<&'a [Spring<S>]> {
        let is_alone = self.inflation.is_none() && self.grids.is_empty() && self.patches.is_none();
        (is_alone && self.springs.len() < SHORT).then_some(self.springs)
    }

    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.mass.len()
    }

    /// 1/mass [1/kg]; 0 for a fixed or massless point.
    #[must_use]
    pub fn inverse_mass(&self, i: usize) -> S {
        match (self.mass.get(i), self.fixed.get(i)) {
            (Some(m), Some(false)) if *m > S::ZERO => S::ONE / *m,
            _ => S::ZERO,
        }
    }

    /// [`Body::inverse_mass`] of points from `first` on, as many as there is memory for, once for each component; 0
    /// beyond the last point.
    #[inline(always)]
    #[must_use]
    pub fn inverse_masses<'b>(&'b self, first: usize, memory: &'b mut [Vec3<S>]) -> &'b [Vec3<S>] {
        if !self.inverse_mass.is_empty() {
            let rest = self.inverse_mass.get(first..).unwrap_or_default();
            return rest.get(..memory.len()).unwrap_or(rest);
        }
        for (i, weight) in memory.iter_mut().enumerate() {
            *weight = [self.inverse_mass(first + i); 3];
        }
        memory
    }
}
