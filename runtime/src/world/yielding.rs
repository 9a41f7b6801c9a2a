//! Pairs that push one another by a force law: a part of the equations, in every evaluation, with no event and no
//! impulse.
//!
//! In: everything as placed last, pairs with a [`ForceLaw`](crate::contact::ForceLaw). Out: forces on nodes, wrenches on
//! ports, the energy that overlaps store, the power that they take.
//! ```text
//! depth = -gap,   N = N(depth, depth') along the surface's normal, at every point that is inside
//! ```
//! Points are the nodes of a mesh over a shape, and those of one shape's core over another (`rigid::narrow`). Each is
//! pushed along the gradient of its depth, so that the force has a potential. Pairs of other things do not act.

use super::carrier::Carrier;
use super::contacts::load;
use super::scenery::{Scenery, Standing};
use super::thing::{Pair, Thing};
use super::whole::World;
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Point};
use crate::rigid::narrow::{Placed, features};
use crate::surface::Frame;
use crate::vec3::{self, Vec3};

/// A point that is inside another part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yield<S> {
    /// Number of its pair.
    pub pair: usize,
    /// Where it is, in N (m).
    pub point: Vec3<S>,
    /// Sides, axes, force (N) along n, t1, t2.
    pub contact: Contact<S>,
    /// Energy stored in it (J).
    pub energy: S,
    /// Power that it takes (W).
    pub taken: S,
}

/// Positions and velocities of nodes, and frames of ports, as placed last.
struct Placement<'a, S> {
    scenery: Scenery<'a, S>,
    vel: &'a [Vec3<S>],
}

impl<S: Scalar> Placement<'_, S> {
    /// Calls a function for each point that is inside another part of a pair with a force law.
    fn each(&self, pairs: &[Pair<S>], mut see: impl FnMut(&Yield<S>)) {
        for (number, pair) in pairs.iter().enumerate().filter(|(_, pair)| pair.force.is_some()) {
            let [Some(one), Some(other)] = pair.things.map(|thing| self.scenery.things.get(thing)) else {
                continue;
            };
            match (self.scenery.rigid(one), self.scenery.rigid(other)) {
                (Some(one), Some(other)) => self.shapes((number, pair), [one, other], &mut see),
                (Some(shape), None) => self.nodes((number, pair), other, &shape, &mut see),
                (None, Some(shape)) => self.nodes((number, pair), one, &shape, &mut see),
                (None, None) => {}
            }
        }
    }

    fn shapes(
        &self,
        pair: (usize, &Pair<S>),
        [(shape, port, frame), (other, other_port, other_frame)]: [Standing<S>; 2],
        see: &mut impl FnMut(&Yield<S>),
    ) {
        let one = Placed { shape: &shape, frame: &frame };
        let two = Placed { shape: &other, frame: &other_frame };
        for feature in features(one, two, S::ZERO).iter() {
            let sides = [port, other_port].map(|port| self.scenery.side_of_port(port, feature.point));
            self.point(pair, feature.point, (feature.gap, Contact::between(sides, feature.normal)), see);
        }
    }

    fn nodes(
        &self,
        pair: (usize, &Pair<S>),
        mesh: &Thing<S>,
        shape: &Standing<S>,
        see: &mut impl FnMut(&Yield<S>),
    ) {
        let Some(mesh) = self.scenery.mesh(mesh).filter(|mesh| self.scenery.may_meet(mesh, shape)) else {
            return;
        };
        let (_, port, frame) = shape;
        for node in mesh.nodes[0]..mesh.nodes[1] {
            let near = self.scenery.near_node(node, shape);
            if near.gap < S::ZERO {
                let x = vec3::at(self.scenery.pos, node);
                let sides = [self.scenery.side_of_node(node), self.scenery.side_of_port(*port, x)];
                let contact = Contact::between(sides, frame.to_inertial(near.normal));
                self.point(pair, x, (near.gap, contact), see);
            }
        }
    }

    /// A point with its gap (m): its force, unless it is outside.
    fn point(
        &self,
        (number, pair): (usize, &Pair<S>),
        point: Vec3<S>,
        (gap, mut contact): (S, Contact<S>),
        see: &mut impl FnMut(&Yield<S>),
    ) {
        let Some(law) = pair.force.filter(|_| gap < S::ZERO) else { return };
        let relative = contact
            .points()
            .fold(vec3::zero(), |sum, (weight, at)| vec3::axpy(sum, weight, self.velocity(at)));
        let rate = -vec3::dot(contact.axes[0], relative);
        let (force, viscous) = law.force(-gap, rate);
        contact.impulse = [force, S::ZERO, S::ZERO];
        see(&Yield { pair: number, point, contact, energy: law.energy(-gap), taken: viscous * rate });
    }

    /// Velocity of a point of a port or of a node.
    fn velocity(&self, at: &Point<S>) -> Vec3<S> {
        match at.body.checked_sub(self.scenery.frames.len()) {
            Some(node) => vec3::at(self.vel, node),
            None => self.scenery.frames.get(at.body).map_or_else(vec3::zero, |frame: &Frame<S>| {
                vec3::add(frame.velocity, vec3::cross(frame.angular_velocity, at.arm))
            }),
        }
    }
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Whether any pair has a force law.
    pub(super) fn yields(&self) -> bool {
        self.pairs.iter().any(|pair| pair.force.is_some())
    }

    /// Calls a function for each point that is inside another part of a pair with a force law, as placed last.
    pub fn each_yield(&self, see: impl FnMut(&Yield<S>)) {
        let scenery = self.scenery(&[], S::ZERO, false);
        Placement { scenery, vel: self.island.memory.vel }.each(self.pairs, see);
    }

    /// Whether the force of any pair depends on speeds.
    pub(super) fn yields_by_speed(&self) -> bool {
        self.pairs.iter().any(|pair| pair.force.is_some_and(|law| law.dissipation() > S::ZERO))
    }

    /// Power that force laws take at what was placed last (W).
    pub(super) fn power_taken(&self) -> S {
        let mut sum = S::ZERO;
        self.each_yield(|point| sum = sum + point.taken);
        sum
    }

    /// Computes the forces on the nodes placed last, and the wrenches on the ports: those of the island and those of
    /// force laws.
    pub(super) fn load_seams(&mut self) -> Result<(), Fault> {
        self.island.load_seams()?;
        if !self.yields() {
            return Ok(());
        }
        // Taken out while places and velocities are read.
        let own = &mut self.island.memory;
        let (elastic, wrenches) = (core::mem::take(&mut own.elastic), core::mem::take(&mut own.wrenches));
        self.each_yield(|point| load(&point.contact, |force| force, (elastic, wrenches)));
        (self.island.memory.elastic, self.island.memory.wrenches) = (elastic, wrenches);
        Ok(())
    }
}
