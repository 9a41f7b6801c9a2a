//! Contacts of a step: velocities without them, which of them are near, and their impulses.
//!
//! In: the coordinates of the middle of a step, and the rates there. Out: the list of contacts in the step's memory, each
//! with its impulse, and the velocities that they leave.

use super::carrier::{Carrier, Wrench};
use super::island::Cut;
use super::scenery::Scenery;
use super::sweep::{self, sweep};
use super::thing::Thing;
use super::whole::{StepMemory, World};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Twist};
use crate::surface::facet::vertex_normals;
use crate::vec3::{self, Vec3};

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Velocities of ports and nodes at the positions of the middle: with the speeds at the start, and with those that
    /// the forces without contacts give at the end. `new` is memory.
    pub(super) fn fill_twists(
        &mut self,
        times: [S; 2],
        h: S,
        middle: &[S],
        dot: &[S],
        new: &mut [S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<(), Fault> {
        let n_q = self.island.n_q();
        let ports = self.island.memory.frames.len();
        let expected = ports + self.island.body.points();
        let StepMemory { frames: [first, last], twists, .. } = memory;
        if twists.iter().any(|twists| twists.len() != expected) || first.len() != ports || last.len() != ports
        {
            return Err(Fault::Shape);
        }
        for (index, (to, (from, rate))) in new.iter_mut().zip(middle.iter().zip(dot)).enumerate() {
            *to = if index < n_q { *from } else { *from + h * *rate };
        }
        let [start, free, _] = twists;
        let lists = [(&mut **first, &mut **start, middle), (&mut **last, &mut **free, &*new)];
        for ((frames, twists, x), t) in lists.into_iter().zip(times) {
            let Cut { q, u, vel, .. } = self.island.parts(x)?;
            self.island.carrier.frames(t, q, u, frames)?;
            let (of_ports, of_nodes) = twists.split_at_mut_checked(ports).ok_or(Fault::Shape)?;
            for (twist, frame) in of_ports.iter_mut().zip(frames.iter()) {
                *twist = Twist { velocity: frame.velocity, angular: frame.angular_velocity };
            }
            of_nodes.fill(Twist::zero());
            for (node, velocity) in super::island::free_nodes(&self.island.body).zip(vel.chunks_exact(3)) {
                if let (Some(twist), [x, y, z]) = (of_nodes.get_mut(node), velocity) {
                    twist.velocity = [*x, *y, *z];
                }
            }
        }
        Ok(())
    }

    /// Detects contacts and computes their impulses; the last list of twists holds the resulting velocities.
    pub(super) fn contacts(
        &mut self,
        times: (S, S),
        middle: &[S],
        rebounds: bool,
        memory: &mut StepMemory<'_, S>,
    ) -> Result<sweep::Sweeps<S>, Fault> {
        self.find_contacts(times, middle, memory)?;
        if !rebounds {
            memory.touches[0].iter_mut().for_each(|touch| touch.contact.restitution = S::ZERO);
        }
        Ok(press(times.1, memory))
    }

    /// Detects contacts at the positions placed last (the middle, at t), and their inverse masses. Impulses of the last
    /// step are not taken as a start, which would save a tenth of the sweeps: a step depends on the state alone, so that
    /// a run that is resumed, and parts that step apart, give the same bits.
    pub(super) fn find_contacts(
        &mut self,
        (t, h): (S, S),
        middle: &[S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<(), Fault> {
        let margin = self.margin(h, memory);
        let StepMemory { twists: [start, ..], normals, inertias, extents, touches: [now, _], counts, .. } =
            memory;
        counts[0] = 0;
        if self.pairs.is_empty() {
            return Ok(());
        }
        self.turn_normals(normals);
        let count = self.scenery(normals, margin).find(self.pairs, now, extents)?;
        let island = &mut self.island;
        counts[0] = count;
        if count == 0 {
            return Ok(());
        }
        let Cut { q, u, .. } = island.parts(middle)?;
        let touched = |port: usize| {
            let sides = now.iter().take(count).flat_map(|touch| &touch.contact.sides);
            sides.flat_map(|side| side.points()).any(|point| point.body == port)
        };
        inertias.ask(&mut island.carrier, t, (q, u), touched)?;
        for (node, yields) in inertias.nodes.iter_mut().enumerate() {
            *yields = island.body.inverse_mass(node);
        }
        for touch in now.iter_mut().take(count) {
            touch.inverse_mass = touch.contact.inverse_mass(inertias);
            touch.start = touch.contact.relative(start);
        }
        Ok(())
    }

    /// Normals at the nodes as placed last; skipped where no facet can be touched.
    pub(super) fn turn_normals(&self, normals: &mut [Vec3<S>]) {
        if !normals.is_empty() {
            vertex_normals(self.island.body.facets, self.island.memory.pos, normals);
        }
    }

    /// The geometry of everything as placed last.
    pub(super) fn scenery<'s>(&'s self, normals: &'s [Vec3<S>], margin: S) -> Scenery<'s, S> {
        let island = &self.island;
        Scenery {
            things: self.things,
            body: &island.body,
            attachments: island.attachments,
            frames: island.memory.frames,
            pos: island.memory.pos,
            normals,
            margin,
            rides: false,
        }
    }

    /// Upper bound on how much a step may close a gap (m).
    fn margin(&self, h: S, memory: &StepMemory<'_, S>) -> S {
        let (mut low, mut high) = (vec3::zero::<S>(), vec3::zero::<S>());
        let origins = self.island.memory.frames.iter().map(|frame| frame.origin);
        for (number, place) in origins.chain(self.island.memory.pos.iter().copied()).enumerate() {
            for ((low, high), x) in low.iter_mut().zip(high.iter_mut()).zip(place) {
                (*low, *high) = if number == 0 { (x, x) } else { (low.min(x), high.max(x)) };
            }
        }
        let size = vec3::norm(vec3::sub(high, low)) + self.largest();
        let mut fastest = S::ZERO;
        for twist in memory.twists.iter().take(2).flat_map(|twists| twists.iter()) {
            fastest = fastest.max(vec3::norm(twist.velocity) + size * vec3::norm(twist.angular));
        }
        S::from_f64(2.0) * h * fastest
    }

    /// Largest distance of a shape's surface from its port (m).
    pub(super) fn largest(&self) -> S {
        self.things.iter().fold(S::ZERO, |most, thing| {
            let Thing::Rigid { shape, place, .. } = thing else { return most };
            most.max(shape.reach().unwrap_or(S::ZERO) + vec3::norm(place.origin))
        })
    }
}

/// The impulses of the detected contacts, given the velocities without them at the end; the last list of twists gets
/// the velocities with them.
pub(super) fn press<S: Scalar>(h: S, memory: &mut StepMemory<'_, S>) -> sweep::Sweeps<S> {
    let StepMemory { twists: [_, free, end], inertias, touches: [now, _], counts, .. } = memory;
    end.iter_mut().zip(free.iter()).for_each(|(to, from)| *to = *from);
    let now = now.get_mut(..counts[0]).unwrap_or_default();
    if now.is_empty() {
        return sweep::Sweeps { number: 0, settled: true, left: S::ZERO };
    }
    let sweeps = sweep(now, h, inertias, end);
    sweep::take_no_more(now, free, inertias, end);
    // Sweeps accumulate rounding errors in the velocities: recompute them from the impulses.
    end.iter_mut().zip(free.iter()).for_each(|(to, from)| *to = *from);
    now.iter().for_each(|touch| touch.contact.push(inertias, end, touch.contact.impulse));
    sweeps
}

/// Adds the contacts' mean forces to those on nodes and ports; returns the number of contacts that push.
pub(super) fn load_contacts<S: Scalar>(
    h: S,
    contacts: impl Iterator<Item = Contact<S>>,
    (nodes, wrenches): (&mut [Vec3<S>], &mut [Wrench<S>]),
) -> usize {
    let (ports, mut active) = (wrenches.len(), 0);
    for contact in contacts.filter(|contact| contact.impulse[0] > S::ZERO) {
        active += 1;
        contact.deal(contact.impulse, |body, arm, impulse| {
            let force = vec3::scale(impulse, S::ONE / h);
            if body >= ports {
                vec3::add_at(nodes, body - ports, force);
            } else if let Some(wrench) = wrenches.get_mut(body) {
                wrench.force = vec3::add(wrench.force, force);
                wrench.moment = vec3::add(wrench.moment, vec3::cross(arm, force));
            }
        });
    }
    active
}
