//! A flexible body: point masses joined by spring-dampers (thesis chapter 3), as a view over the caller's slices.
//!
//! In: numbers of points and springs. Out: forces and energies. Invariant: after [`Body::new`] every
//! spring and facet names points that exist, so kernels need no checks. Nothing here allocates.

pub mod block;
pub mod element;
pub mod energy;
pub mod force;
pub mod grid;
pub mod mean;
pub mod patch;
pub mod pressure;
pub mod spring;

use crate::ode::nodes::NodeFault;
use crate::real::Scalar;
use crate::vec3::Vec3;
use element::Element;
use grid::Grid;
use patch::Patches;
pub use pressure::{Gas, Inflation, PressureForm};
pub use spring::Spring;

/// What never changes in a run.
#[derive(Clone, Copy, Debug)]
pub struct Body<'a, S> {
    /// Mass of each point (kg), > 0; 0 only for a massless contact point.
    pub mass: &'a [S],
    /// True where a point is held in space.
    pub fixed: &'a [bool],
    /// [`Body::inverse_mass`] of each point (1/kg), once for each component, or nothing where memory is dearer than time:
    /// it is then divided anew in every step.
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
    /// Springs and facets that form grids once more, in the order of the lists: their forces then take a fraction of the time.
    pub grids: &'a [Grid<'a, S>],
    /// All springs once more, cut into patches, of a body without grids.
    pub patches: Option<Patches<'a, S>>,
}

/// The massless points with the springs of each, so that none has to look through all springs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Massless<'a> {
    /// The points.
    pub points: &'a [usize],
    /// Where the springs of each begin in `springs`, and at last the length of that.
    pub first: &'a [usize],
    /// Numbers of springs, point after point.
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

/// Why a body or its motion is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BodyError<S> {
    /// The body has no points.
    Empty,
    /// Slices that must agree differ in length.
    Length {
        /// Number of points.
        expected: usize,
        /// Length found.
        found: usize,
    },
    /// A spring or facet names a point that does not exist.
    UnknownPoint {
        /// The point.
        point: usize,
        /// Number of points.
        points: usize,
    },
    /// A mass, stiffness, damping or rest length is negative or not a number.
    Negative {
        /// Index of the point or spring.
        index: usize,
    },
    /// The scratch memory is too small.
    Scratch {
        /// Vectors needed.
        needed: usize,
        /// Vectors given.
        given: usize,
    },
    /// A position or speed, or its square, left the numbers; the last good state stands.
    NotFinite {
        /// The point.
        point: usize,
    },
    /// A point starts below a ground that does not give way.
    BelowGround {
        /// The point.
        point: usize,
        /// How deep (m).
        depth: S,
    },
    /// A point with mass went through a ground that carries massless points alone; the last good state stands.
    ThroughGround {
        /// The point.
        point: usize,
    },
    /// The body grows without end under its pressure; the last good state stands.
    PressureTooHigh {
        /// Gauge pressure (Pa) that no equilibrium carries.
        pressure: S,
        /// The spring stretched beyond [`pressure::STRETCH_LIMIT`].
        spring: usize,
    },
    /// The enclosed volume is not positive, so a gas law has no pressure; the last good state stands.
    Collapsed {
        /// Enclosed volume (m^3).
        volume: S,
    },
    /// An implicit step did not settle: the step is too large.
    NotConverged {
        /// Length of the step (s).
        step: S,
    },
}

impl<'a, S: Scalar> Body<'a, S> {
    /// Checks lengths, point numbers and signs.
    ///
    /// # Errors
    /// The first thing wrong.
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
        Ok(candidate)
    }

    /// No body: what a world without flexible parts has.
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

    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.mass.len()
    }

    /// 1/mass [1/kg]; 0 for a fixed or massless point, which no force moves.
    #[must_use]
    pub fn inverse_mass(&self, i: usize) -> S {
        match (self.mass.get(i), self.fixed.get(i)) {
            (Some(m), Some(false)) if *m > S::ZERO => S::ONE / *m,
            _ => S::ZERO,
        }
    }

    /// [`Body::inverse_mass`] of points from `first` on, as many as there is memory for, once for each component; 0 where
    /// there is no point.
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

    /// True where some force depends on speeds.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        self.air_drag > S::ZERO || self.elements().is_damped()
    }
}

impl<S> From<NodeFault<S>> for BodyError<S> {
    fn from(fault: NodeFault<S>) -> Self {
        match fault {
            NodeFault::Memory { needed, given } => BodyError::Scratch { needed, given },
            NodeFault::NotFinite { node } => BodyError::NotFinite { point: node },
            NodeFault::NotConverged { step } => BodyError::NotConverged { step },
        }
    }
}
