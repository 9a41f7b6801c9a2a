//! A body with its contact states frozen over a step, as equations of motion of its nodes.
//!
//! Held nodes stay on the surface, stuck ones do not move, a soft ground pushes, massless nodes are put in equilibrium.

use super::ground::ContactState;
use super::repertoire::Repertoire;
use super::system::System;
use super::{massless, soft};
use crate::flexible::element::Elements;
use crate::flexible::{BodyError, force};
use crate::ode::nodes::{MeanStep, Motion, Newton, Step, Workspace};
use crate::real::Scalar;
use crate::vec3::Vec3;

/// A system and the contact states of its nodes over a step.
#[derive(Debug)]
pub struct Frozen<'a, 'b, S, R> {
    /// Body and ground.
    pub system: &'a System<'b, S, R>,
    /// Contact state of each node.
    pub modes: &'a [ContactState],
}

impl<S: Scalar, R: Repertoire<S>> Frozen<'_, '_, S, R> {
    fn mode(&self, node: usize) -> ContactState {
        self.modes.get(node).copied().unwrap_or_default()
    }
}

impl<S: Scalar, R: Repertoire<S>> Newton<S> for Frozen<'_, '_, S, R> {
    type Fault = BodyError<S>;

    fn nodes(&self) -> usize {
        self.system.body.points()
    }

    fn elastic(&self, pos: &mut [Vec3<S>], out: &mut [Vec3<S>]) -> Result<(), BodyError<S>> {
        self.system.elastic(pos, out)
    }

    fn viscous(&self, pos: &[Vec3<S>], vel: &[Vec3<S>], out: &mut [Vec3<S>]) {
        self.system.viscous(pos, vel, out);
    }

    fn mean_force(&self, way: &MeanStep<S>, force: &mut [Vec3<S>]) -> Result<(), BodyError<S>> {
        force::eval_mean(&self.system.body, &self.system.elements(), way, force)?;
        if let Some(ground) = self.system.soft_ground() {
            soft::add_mean(&ground, way, force);
        }
        Ok(())
    }

    fn is_damped(&self) -> bool {
        self.system.is_damped()
    }

    fn is_movable(&self, node: usize) -> bool {
        self.system.body.inverse_mass(node) > S::ZERO
    }

    fn acceleration(&self, node: usize, force: Vec3<S>) -> Vec3<S> {
        self.system.acceleration(node, self.mode(node), force)
    }

    #[inline(always)]
    fn inverse_masses<'a>(&'a self, first: usize, memory: &'a mut [Vec3<S>]) -> &'a [Vec3<S>] {
        self.system.body.inverse_masses(first, memory)
    }

    #[inline(always)]
    fn holds(&self, first: usize, count: usize) -> bool {
        let modes = self.modes.get(first..).unwrap_or_default();
        // Without an early exit, so that it vectorises; almost always no node is held.
        modes.get(..count).unwrap_or(modes).iter().fold(false, |held, mode| held | mode.is_held())
    }

    #[inline(always)]
    fn admit(&self, first: usize, rows: &mut [Vec3<S>]) {
        for (row, mode) in rows.iter_mut().zip(self.modes.get(first..).unwrap_or_default()) {
            *row = self.system.admissible(*mode, *row);
        }
    }

    fn acceleration_of_unit_strain(&self) -> S {
        let body = &self.system.body;
        body.springs.iter().fold(S::ZERO, |largest, s| {
            let inverse = body.inverse_mass(s.tail).max(body.inverse_mass(s.head));
            largest.max(s.stiffness * s.rest_length * inverse)
        })
    }
}

impl<'a, S: Scalar, R: Repertoire<S>> System<'a, S, R> {
    /// The body's elements, without gas if the repertoire has none.
    #[must_use]
    pub fn elements(&self) -> Elements<'a, S> {
        let elements = self.body.elements();
        Elements { filled: if R::GAS { elements.filled } else { None }, ..elements }
    }

    /// Position-dependent forces, after massless points are put in equilibrium, with a soft ground's push (N).
    ///
    /// # Errors
    /// From the gas law.
    pub fn elastic(&self, pos: &mut [Vec3<S>], out: &mut [Vec3<S>]) -> Result<(), BodyError<S>> {
        if let Some(springs) = self.body.short_list()
            && self.massless_ground().is_none()
            && self.soft_ground().is_none()
        {
            force::eval_short_list(&self.body, springs, pos, out);
            return Ok(());
        }
        self.elastic_of_all(pos, out)
    }

    /// The same, whatever body and ground have: apart, so that few springs have a call of their own size.
    #[cfg_attr(not(target_os = "none"), inline(never))]
    fn elastic_of_all(&self, pos: &mut [Vec3<S>], out: &mut [Vec3<S>]) -> Result<(), BodyError<S>> {
        if let Some(ground) = self.massless_ground() {
            // Their positions before stand in the rows that the forces overwrite afterwards.
            massless::settle(&self.body, &ground, pos, out);
        }
        force::eval_elastic(&self.body, &self.elements(), pos, out)?;
        if let Some(ground) = self.soft_ground() {
            soft::accumulate_elastic(&ground, pos, out);
        }
        Ok(())
    }

    /// Speed-dependent forces (N).
    pub fn viscous(&self, pos: &[Vec3<S>], vel: &[Vec3<S>], out: &mut [Vec3<S>]) {
        if R::DAMPING && self.body.is_damped() {
            force::eval_viscous(&self.body, &self.elements(), pos, vel, out);
        } else {
            out.as_flattened_mut().fill(S::ZERO);
        }
        if let Some(ground) = self.soft_ground() {
            soft::accumulate_viscous(&ground, pos, vel, out);
        }
    }
}

/// The state at which a step starts.
#[derive(Clone, Copy, Debug)]
pub struct Start<'a, 'm, S> {
    /// Positions and velocities.
    pub motion: &'a Motion<'m, S>,
    /// Contact state of each node, frozen over the step.
    pub modes: &'a [ContactState],
}

/// Advances by tau into `work.end`; returns the error estimate in units of the tolerance (0 for fixed steps).
///
/// # Errors
/// Values not finite, no convergence, or a fault of the gas law; the start is unchanged.
pub fn advance<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    start: Start<S>,
    tau: S,
    method: R::Method,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    let frozen = Frozen { system, modes: start.modes };
    method.step(&frozen, start.motion, tau, work)
}
