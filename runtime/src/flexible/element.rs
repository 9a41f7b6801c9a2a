//! Elements put forces between nodes: their common interface, and loops over all elements of a body.
//!
//! Springs with their dampers, and the gas inside facets, are elements; (A, B) and `Option` make one of several. A new
//! kind is one more implementation. Weight and air drag act on each node by itself and start the sums.

use super::block::{Pulls, Pushes};
use super::body::Body;
use super::fault::BodyError;
use super::grid::{DampingForces, ElasticForces, Grid, MeanForces, beside};
use super::mean;
use super::patch::{self, Patches};
use super::pressure::{self, Filled};
use super::spring::Spring;
use crate::kernel;
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A stiffness between two nodes, for bounds on the stable step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond<S> {
    /// Its ends.
    pub ends: [usize; 2],
    /// The direction in which it acts; None if it may act in any.
    pub direction: Option<Vec3<S>>,
    /// Stiffness (N/m).
    pub stiffness: S,
    /// Stiffness across the direction, by which tension turns it back (N/m); 0 under compression.
    pub across: S,
    /// Damping (N s/m).
    pub damping: S,
}

/// Forces between nodes.
pub trait Element<S: Scalar> {
    /// Adds the speed-dependent forces (N).
    fn add_viscous(&self, pos: &[Vec3<S>], vel: &[Vec3<S>], force: &mut [Vec3<S>]);
    /// Adds mean forces over a step: those whose work is the change of [`Element::energy`], and those of dampers (N).
    ///
    /// # Errors
    /// If a force is not defined at these positions.
    fn add_mean(&self, way: &MeanStep<S>, force: &mut [Vec3<S>]) -> Result<(), BodyError<S>>;
    /// Stored energy (J).
    fn energy(&self, pos: &[Vec3<S>]) -> S;
    /// Power that the speed-dependent forces dissipate (W), given positions and velocities by node.
    fn power(&self, pos: &impl Fn(usize) -> Vec3<S>, vel: &impl Fn(usize) -> Vec3<S>) -> S;
    /// Whether some force depends on speeds.
    fn is_damped(&self) -> bool;
    /// Visits all stiffnesses between pairs of nodes.
    fn each_bond(&self, pos: &[Vec3<S>], visit: &mut impl FnMut(Bond<S>));
    /// Visits all pairs of nodes along whose line an impulse can be passed on.
    fn each_link(&self, visit: &mut impl FnMut([usize; 2]));
}

impl<S: Scalar> Element<S> for [Spring<S>] {
    fn add_viscous(&self, pos: &[Vec3<S>], vel: &[Vec3<S>], force: &mut [Vec3<S>]) {
        for spring in self.iter().filter(|spring| spring.damping > S::ZERO) {
            let stretch = spring.stretch(pos, vel);
            spring.pull(vec3::scale(stretch.direction, spring.damping * stretch.rate), force);
        }
    }

    fn add_mean(&self, way: &MeanStep<S>, force: &mut [Vec3<S>]) -> Result<(), BodyError<S>> {
        self.iter().for_each(|spring| mean::add_spring(spring, way, force));
        Ok(())
    }

    fn energy(&self, pos: &[Vec3<S>]) -> S {
        self.iter().fold(S::ZERO, |sum, spring| sum + spring.energy(pos))
    }

    fn power(&self, pos: &impl Fn(usize) -> Vec3<S>, vel: &impl Fn(usize) -> Vec3<S>) -> S {
        self.iter().filter(|spring| spring.damping > S::ZERO).fold(S::ZERO, |sum, spring| {
            let (d, _) = vec3::direction(vec3::sub(pos(spring.head), pos(spring.tail)));
            let rate = vec3::dot(vec3::sub(vel(spring.head), vel(spring.tail)), d);
            sum + spring.damping * rate * rate
        })
    }

    fn is_damped(&self) -> bool {
        self.iter().any(|spring| spring.damping > S::ZERO)
    }

    fn each_bond(&self, pos: &[Vec3<S>], visit: &mut impl FnMut(Bond<S>)) {
        for spring in self {
            let (d, length) = spring.direction(pos);
            let is_long = length > S::ZERO;
            let across = if is_long { (spring.tension(length) / length).max(S::ZERO) } else { S::ZERO };
            let direction = is_long.then_some(d);
            let (stiffness, damping) = (spring.stiffness, spring.damping);
            visit(Bond { ends: [spring.tail, spring.head], direction, stiffness, across, damping });
        }
    }

    fn each_link(&self, visit: &mut impl FnMut([usize; 2])) {
        self.iter().for_each(|spring| visit([spring.tail, spring.head]));
    }
}

impl<S: Scalar> Element<S> for Filled<'_, S> {
    fn add_viscous(&self, _: &[Vec3<S>], _: &[Vec3<S>], _: &mut [Vec3<S>]) {}

    fn add_mean(&self, way: &MeanStep<S>, force: &mut [Vec3<S>]) -> Result<(), BodyError<S>> {
        let pressure = mean::pressure(self, way)?;
        mean::add_pressure(self.facets, self.inflation.form, pressure, way, force);
        Ok(())
    }

    fn energy(&self, pos: &[Vec3<S>]) -> S {
        pressure::energy(self, pos)
    }

    fn power(&self, _: &impl Fn(usize) -> Vec3<S>, _: &impl Fn(usize) -> Vec3<S>) -> S {
        S::ZERO
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn each_bond(&self, _: &[Vec3<S>], _: &mut impl FnMut(Bond<S>)) {}

    fn each_link(&self, _: &mut impl FnMut([usize; 2])) {}
}

/// All elements of a body, in the order in which their forces are summed.
#[derive(Clone, Copy, Debug)]
pub struct Elements<'a, S> {
    /// Springs and dampers.
    pub springs: &'a [Spring<S>],
    /// Gas.
    pub filled: Option<Filled<'a, S>>,
    /// Springs and facets as grids, on machines with vector registers.
    pub grids: &'a [Grid<'a, S>],
    /// Springs in patches, on such machines.
    pub patches: Option<Patches<'a, S>>,
}

impl<'a, S: Scalar> Body<'a, S> {
    /// The body's elements.
    #[must_use]
    pub fn elements(&self) -> Elements<'a, S> {
        let facets = self.facets;
        Elements {
            springs: self.springs,
            filled: self.inflation.map(|inflation| Filled { facets, inflation }),
            grids: self.grids,
            patches: self.patches,
        }
    }

    /// True where some force depends on speeds.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        self.air_drag > S::ZERO || self.elements().is_damped()
    }
}

impl<'a, S: Scalar> Elements<'a, S> {
    /// None on a microcontroller, so that its image has no code for them.
    pub(crate) fn grids(&self) -> &'a [Grid<'a, S>] {
        if cfg!(target_os = "none") { &[] } else { self.grids }
    }

    /// The same for patches.
    fn patches(&self) -> Option<Patches<'a, S>> {
        if cfg!(target_os = "none") { None } else { self.patches }
    }

    /// Writes the position-dependent forces (N): the weight of masses (kg) under gravity (m/s^2), then springs and gas.
    /// Only grids for which `ours` holds are computed; nodes of the others are left alone.
    ///
    /// # Errors
    /// If a gas law has no volume left, or the gas has stretched a spring beyond [`super::spring::STRETCH_LIMIT`].
    pub fn eval_elastic(
        &self,
        (mass, gravity): (&[S], Vec3<S>),
        ours: impl Fn(&Grid<S>) -> bool,
        pos: &[Vec3<S>],
        force: &mut [Vec3<S>],
    ) -> Result<(), BodyError<S>> {
        let pressure = self.filled.map_or(Ok(S::ZERO), |filled| pressure::of(&filled, pos))?;
        let gas = self.filled.map(|filled| (filled.inflation.form, pressure));
        let mut runaway = self.eval_beside_grids((mass, gravity), pos, force);
        for grid in self.grids().iter().filter(|grid| ours(grid)) {
            runaway |= kernel::run(ElasticForces { grid, pressure: gas, pos, gravity, force });
        }
        let Some(filled) = self.filled else { return Ok(()) };
        for facets in beside(self.grids(), |grid| grid.facets, filled.facets.len()) {
            let facets = filled.facets.get(facets).unwrap_or_default();
            kernel::run(Pushes { facets, form: filled.inflation.form, pressure, pos, force });
        }
        if runaway { pressure::runaway(&filled, self.springs, pos) } else { Ok(()) }
    }

    /// Writes weight and spring forces on the nodes of no grid; returns whether a spring is a runaway.
    fn eval_beside_grids(
        &self,
        (mass, gravity): (&[S], Vec3<S>),
        pos: &[Vec3<S>],
        force: &mut [Vec3<S>],
    ) -> bool {
        for nodes in beside(self.grids(), |grid| grid.nodes, mass.len()) {
            let force = force.get_mut(nodes.clone()).unwrap_or_default();
            for (f, m) in force.iter_mut().zip(mass.get(nodes).unwrap_or_default()) {
                *f = vec3::scale(gravity, *m);
            }
        }
        if let Some(patches) = self.patches() {
            return kernel::run(patch::Pulls { patches, pos, force });
        }
        let pull = |runaway, springs| runaway | kernel::run(Pulls { springs, pos, force });
        self.springs_beside_grids().fold(false, pull)
    }

    /// The springs of no grid, range by range.
    fn springs_beside_grids(&self) -> impl Iterator<Item = &[Spring<S>]> {
        let parts = beside(self.grids(), |grid| grid.springs, self.springs.len());
        parts.map(|springs| self.springs.get(springs).unwrap_or_default())
    }

    /// Writes the speed-dependent forces (N): air drag, then dampers.
    pub fn eval_viscous(&self, air_drag: S, pos: &[Vec3<S>], vel: &[Vec3<S>], force: &mut [Vec3<S>]) {
        for (f, v) in force.iter_mut().zip(vel) {
            *f = vec3::scale(*v, -air_drag);
        }
        match self.patches() {
            Some(patches) if !patches.is_damped => {}
            Some(patches) => kernel::run(patch::Damps { patches, pos, vel, force }),
            None => self.springs_beside_grids().for_each(|springs| springs.add_viscous(pos, vel, force)),
        }
        for grid in self.grids().iter().filter(|grid| grid.is_damped()) {
            kernel::run(DampingForces { grid, pos, vel, air_drag, force });
        }
    }
}

impl<S: Scalar> Element<S> for Elements<'_, S> {
    fn add_viscous(&self, pos: &[Vec3<S>], vel: &[Vec3<S>], force: &mut [Vec3<S>]) {
        self.springs.add_viscous(pos, vel, force);
    }

    fn add_mean(&self, way: &MeanStep<S>, force: &mut [Vec3<S>]) -> Result<(), BodyError<S>> {
        match self.patches() {
            Some(patches) => kernel::run(patch::Means { patches, way, force }),
            None => self.springs_beside_grids().try_for_each(|springs| springs.add_mean(way, force))?,
        }
        let pressure = self.filled.map_or(Ok(S::ZERO), |filled| mean::pressure(&filled, way))?;
        let gas = self.filled.map(|filled| (filled.inflation.form, pressure));
        for grid in self.grids() {
            kernel::run(MeanForces { grid, pressure: gas, h: way.h, nodes: [way.pos[1], way.dx], force });
        }
        let Some(filled) = self.filled else { return Ok(()) };
        for facets in beside(self.grids(), |grid| grid.facets, filled.facets.len()) {
            let facets = filled.facets.get(facets).unwrap_or_default();
            mean::add_pressure(facets, filled.inflation.form, pressure, way, force);
        }
        Ok(())
    }

    fn energy(&self, pos: &[Vec3<S>]) -> S {
        self.springs.energy(pos) + self.filled.map_or(S::ZERO, |filled| filled.energy(pos))
    }

    fn power(&self, pos: &impl Fn(usize) -> Vec3<S>, vel: &impl Fn(usize) -> Vec3<S>) -> S {
        self.springs.power(pos, vel)
    }

    fn is_damped(&self) -> bool {
        if let Some(patches) = self.patches() {
            return patches.is_damped;
        }
        let mut beside = self.springs_beside_grids();
        self.grids().iter().any(Grid::is_damped) || beside.any(|springs| springs.is_damped())
    }

    fn each_bond(&self, pos: &[Vec3<S>], visit: &mut impl FnMut(Bond<S>)) {
        self.springs.each_bond(pos, visit);
    }

    fn each_link(&self, visit: &mut impl FnMut([usize; 2])) {
        self.springs.each_link(visit);
    }
}
