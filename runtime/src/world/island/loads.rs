//! Places of an island's nodes, the forces on them and the wrenches on its ports.
//!
//! In: a state placed by [`Island::place`]. Out, in the island's memory: positions and velocities of all nodes, elastic
//! and viscous forces, wrenches. The passes of a step each change a part of these and compute what depends on it.

use super::super::attachment::Attachment;
use super::super::carrier::{Carrier, Wrench};
use super::super::cell::Holds;
use super::{Cut, Island, free_of, rate};
use crate::flexible::force;
use crate::flexible::grid::Grid;
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::vec3;

impl<S: Scalar, C: Carrier<S>> Island<'_, S, C> {
    /// Places nodes that ports hold.
    pub(super) fn place_attached(&mut self) {
        for attachment in self.attachments {
            let Some(frame) = self.memory.frames.get(attachment.port) else { continue };
            let point = frame.point(attachment.place);
            let velocity = frame.velocity_at(point);
            if let (Some(own_x), Some(own_v)) =
                (self.memory.pos.get_mut(attachment.node), self.memory.vel.get_mut(attachment.node))
            {
                (*own_x, *own_v) = (point, velocity);
            }
        }
    }

    /// Changes the velocities of the nodes placed last to those after h under the forces in memory, and at these speeds
    /// of the carrier.
    pub(in super::super) fn predict_speeds(&mut self, t: S, h: S, (q, u): (&[S], &[S])) -> Result<(), Fault> {
        self.carrier.frames(t, q, u, self.memory.frames)?;
        let (own, body) = (&mut self.memory, &self.body);
        let forces = own.elastic.iter().zip(own.viscous.iter());
        for (node, (velocity, (elastic, viscous))) in own.vel.iter_mut().zip(forces).enumerate() {
            // The rate of a fixed node is 0.
            *velocity = vec3::axpy(*velocity, h, rate(body, node, [*elastic, *viscous]));
        }
        self.place_attached();
        Ok(())
    }

    /// Takes the elastic force in memory from a node.
    pub(in super::super) fn unload(&mut self, node: usize) {
        if let Some(force) = self.memory.elastic.get_mut(node) {
            *force = vec3::zero();
        }
    }

    /// Moves the nodes of restrained bodies by `squared` (s^2) times their rates under the elastic forces in memory.
    pub(in super::super) fn displace(&mut self, squared: S) {
        let (own, body) = (&mut self.memory, &self.body);
        for [first, end] in self.restrained {
            let rows = (own.pos.get_mut(*first..*end), own.elastic.get(*first..*end));
            let (Some(places), Some(forces)) = rows else { continue };
            for (node, (place, elastic)) in (*first..).zip(places.iter_mut().zip(forces)) {
                // The rate of a fixed node is 0.
                *place = vec3::axpy(*place, squared, rate(body, node, [*elastic, vec3::zero()]));
            }
        }
    }

    /// Places the free nodes of a state, and gives them its velocities.
    pub(in super::super) fn place_nodes(&mut self, x: &[S]) -> Result<(), Fault> {
        let Cut { pos, vel, .. } = self.parts(x)?;
        let own = self.memory.pos.iter_mut().zip(self.memory.vel.iter_mut());
        let rows = pos.as_chunks().0.iter().zip(vel.as_chunks().0);
        for ((own_x, own_v), (x, v)) in free_of(own, &self.body).zip(rows) {
            (*own_x, *own_v) = (*x, *v);
        }
        Ok(())
    }

    /// Computes the forces on the nodes placed last, and the wrenches on the ports.
    pub(in super::super) fn load_seams(&mut self) -> Result<(), Fault> {
        let (elements, memory) = (self.body.elements(), &mut self.memory);
        // A grid overwrites its sums, with the gas of its cell: so before anything is added to them.
        let weights = (self.body.mass, self.body.gravity);
        let alone = |grid: &Grid<S>| !self.cells.iter().any(|cell| cell.holds(grid));
        let forces = elements.eval_elastic(weights, alone, memory.pos, memory.elastic);
        forces.map_err(|_| Fault::NonFinite)?;
        let holds = Holds { attachments: self.attachments, frames: memory.frames };
        for cell in self.cells {
            cell.add_force(&self.body, elements.grids(), holds, memory.pos, memory.elastic)?;
        }
        self.load_speeds();
        Ok(())
    }

    /// The same where only the speeds have changed since.
    pub(in super::super) fn load_speeds(&mut self) {
        let (elements, memory) = (self.body.elements(), &mut self.memory);
        force::eval_viscous(&self.body, &elements, memory.pos, memory.vel, memory.viscous);
        memory.wrenches.iter_mut().for_each(|wrench| *wrench = Wrench::zero());
        for Attachment { node, port, .. } in self.attachments {
            let force = vec3::add(vec3::at(memory.elastic, *node), vec3::at(memory.viscous, *node));
            if let (Some(frame), Some(wrench)) = (memory.frames.get(*port), memory.wrenches.get_mut(*port)) {
                wrench.add_force(frame, vec3::at(memory.pos, *node), force);
            }
        }
    }
}
