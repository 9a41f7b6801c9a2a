//! Contacts of a step: velocities without them, which of them are near, and their impulses.
//!
//! In: the coordinates of the middle of a step, and the rates there. Out: the list of contacts in the step's memory,
//! each with its impulse, and the velocities that they leave.

use super::carrier::{Carrier, Wrench};
use super::detect::{Touch, keep_only};
use super::extent::Extent;
use super::island::{Cut, Memory};
use super::scenery::Scenery;
use super::sweep::{self, sweep};
use super::thing::Thing;
use super::whole::{StepMemory, World};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Twist};
use crate::surface::Frame;
use crate::surface::facet::vertex_normals;
use crate::vec3::{self, Vec3};

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Velocities of the ports at the positions of the middle: with the speeds at the start, and with those that the
    /// forces without contacts give at the end, which `new` gets for the carriers.
    pub(super) fn carry_twists(
        &mut self,
        times: [S; 2],
        h: S,
        middle: &[S],
        dot: &[S],
        new: &mut [S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<(), Fault> {
        let ports = self.island.memory.frames.len();
        let expected = ports + self.island.body.points();
        let StepMemory { frames: [first, last], twists, .. } = &*memory;
        if twists.iter().any(|twists| twists.len() != expected) || first.len() != ports || last.len() != ports
        {
            return Err(Fault::Shape);
        }
        let StepMemory { frames: [first, _], twists: [start, ..], .. } = memory;
        self.read_ports(times[0], middle, first, start)?;
        self.carry_ends((times[1], h), [middle, dot], new, memory)
    }

    /// Velocities of the ports at the positions of the middle with the speeds that these rates give at the end, which
    /// `new` gets for the carriers.
    pub(super) fn carry_ends(
        &mut self,
        (t_end, h): (S, S),
        [middle, dot]: [&[S]; 2],
        new: &mut [S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<(), Fault> {
        let n_q = self.island.n_q();
        let (turning, n_u) = (self.island.carrier.n_q(), self.island.carrier.n_u());
        new.iter_mut().zip(middle).take(turning).for_each(|(to, from)| *to = *from);
        for (to, (from, rate)) in new.iter_mut().zip(middle.iter().zip(dot)).skip(n_q).take(n_u) {
            *to = *from + h * *rate;
        }
        let StepMemory { frames: [_, last], twists: [_, free, _], .. } = memory;
        self.read_ports(t_end, new, last, free)
    }

    /// Frames and velocities of the ports at a state.
    fn read_ports(
        &mut self,
        t: S,
        x: &[S],
        frames: &mut [Frame<S>],
        twists: &mut [Twist<S>],
    ) -> Result<(), Fault> {
        let Cut { q, u, .. } = self.island.parts(x)?;
        self.island.carrier.frames(t, q, u, frames)?;
        for (twist, frame) in twists.iter_mut().zip(frames.iter()) {
            *twist = Twist { velocity: frame.velocity, angular: frame.angular_velocity };
        }
        Ok(())
    }

    /// Detects contacts at the positions placed last (the middle, at t), their inverse masses, and the velocities of
    /// their nodes at the start and, under the forces in memory, at the end; returns how near (m) they are listed.
    /// Impulses of the last step are not taken as a start, which would save a tenth of the sweeps: a step depends on
    /// the state alone, so that a run that is resumed, and parts that step apart, give the same bits.
    pub(super) fn find_contacts(
        &mut self,
        (t, h): (S, S),
        middle: &[S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<S, Fault> {
        memory.counts[0] = 0;
        if self.pairs.is_empty() {
            return Ok(S::ZERO);
        }
        self.scenery(&[], S::ZERO, false).measure(memory.extents);
        let margin = self.margin(h, memory);
        let StepMemory { normals, inertias, extents, touches: [now, _], counts, .. } = memory;
        let count = self.detect_within(extents, (margin, false), normals, now)?;
        let island = &mut self.island;
        counts[0] = count;
        if count == 0 {
            return Ok(margin);
        }
        let Cut { q, u, .. } = island.parts(middle)?;
        let touched = |port: usize| now.iter().take(count).any(|touch| touch.contact.touches_body(port));
        inertias.ask(&mut island.carrier, t, (q, u), touched)?;
        let ports = inertias.couplings.len();
        for touch in now.iter_mut().take(count) {
            for node in touch.nodes(ports) {
                if let Some(yields) = inertias.nodes.get_mut(node) {
                    *yields = island.body.inverse_mass(node);
                }
            }
            touch.inverse_mass = touch.contact.inverse_mass(inertias);
        }
        self.read_touched(h, memory);
        Ok(margin)
    }

    /// Leaves out the contacts of points that are outside for all their depth, given how far (m) a step of h
    /// (s) can bring them.
    pub(super) fn leave_out_behind(&self, (h, way): (S, S), memory: &mut StepMemory<'_, S>) {
        let StepMemory { normals, touches: [now, _], counts, .. } = memory;
        let scenery = self.scenery(normals, way, false);
        let now = now.get_mut(..counts[0]).unwrap_or_default();
        counts[0] = keep_only(now, 0, |_, touch, _| !scenery.is_outside(self.pairs, touch, (h, way)));
    }

    /// Velocities of the nodes that touch, at the start and, under the forces in memory, at the end.
    pub(super) fn read_touched(&self, h: S, memory: &mut StepMemory<'_, S>) {
        let StepMemory { twists: [start, free, _], touches: [now, _], counts, .. } = memory;
        let ports = self.island.memory.frames.len();
        for touch in now.iter_mut().take(counts[0]) {
            for node in touch.nodes(ports) {
                let (own, angular) = (self.island.node_rate(node), vec3::zero());
                if let (Some(start), Some(free)) = (start.get_mut(ports + node), free.get_mut(ports + node)) {
                    *start = Twist { velocity: own.velocity, angular };
                    *free = Twist { velocity: own.after(h), angular };
                }
            }
            touch.start = touch.contact.relative(start);
        }
    }

    /// Lists the contacts at the positions placed last with gaps up to a margin (m), and with what rides on facets if
    /// asked; returns their number.
    pub(super) fn detect(
        &self,
        (margin, rides): (S, bool),
        normals: &mut [Vec3<S>],
        extents: &mut [Extent<S>],
        touches: &mut [Touch<S>],
    ) -> Result<usize, Fault> {
        self.scenery(&[], margin, rides).measure(extents);
        self.detect_within(extents, (margin, rides), normals, touches)
    }

    /// The same with boxes that are measured.
    fn detect_within(
        &self,
        extents: &[Extent<S>],
        (margin, rides): (S, bool),
        normals: &mut [Vec3<S>],
        touches: &mut [Touch<S>],
    ) -> Result<usize, Fault> {
        let nears = |thing: usize| {
            self.pairs.iter().any(|pair| pair.things.contains(&thing) && pair.may_meet(extents, margin))
        };
        self.turn_normals(normals, nears);
        self.scenery(normals, margin, rides).find(self.pairs, touches, extents)
    }

    /// Normals at the nodes of the `wanted` things as placed last; skipped where no facet can be touched.
    pub(super) fn turn_normals(&self, normals: &mut [Vec3<S>], wanted: impl Fn(usize) -> bool) {
        for (number, thing) in self.things.iter().enumerate() {
            if let Thing::Mesh { nodes: [first, end], facets: [first_facet, end_facet], .. } = thing
                && wanted(number)
            {
                let facets = self.island.body.facets.get(*first_facet..*end_facet).unwrap_or_default();
                vertex_normals(facets, self.island.memory.pos, *first..*end, normals);
            }
        }
    }

    /// The geometry of everything as placed last.
    pub(super) fn scenery<'s>(&'s self, normals: &'s [Vec3<S>], margin: S, rides: bool) -> Scenery<'s, S> {
        let island = &self.island;
        Scenery {
            things: self.things,
            body: &island.body,
            attachments: island.attachments,
            frames: island.memory.frames,
            pos: island.memory.pos,
            normals,
            margin,
            rides,
        }
    }

    /// Upper bound on how much a step may close a gap (m).
    fn margin(&self, h: S, memory: &StepMemory<'_, S>) -> S {
        let Memory { frames, pos, .. } = &self.island.memory;
        // Where there are boxes around the things, everything that can touch is in one of them.
        let boxes = memory.extents.iter().filter(|extent| extent.is_bounded());
        let corners = boxes.flat_map(|Extent { low, high }| [*low, *high]);
        let around = if memory.extents.is_empty() { Extent::around(pos) } else { None };
        let points = corners.chain(frames.iter().map(|frame| frame.origin));
        let bounds = points.fold(around, |bounds, point| {
            Some(bounds.unwrap_or(Extent { low: point, high: point }).with(point))
        });
        let size = self.reach_of_ports(bounds.map_or(S::ZERO, |bounds| bounds.diagonal()));
        let mut fastest = S::ZERO;
        for twists in memory.twists.iter().take(2) {
            for Twist { velocity, angular } in twists.iter().take(frames.len()) {
                fastest = fastest.max(vec3::norm(*velocity) + size * vec3::norm(*angular));
            }
        }
        // Comparisons: `max` also looks for what is no number, and every node would wait for the one before.
        let larger = |a: S, b: S| if b > a { b } else { a };
        let square = self.island.node_rates().fold(S::ZERO, |most, node| {
            let [start, end] = [node.velocity, node.after(h)].map(|v| vec3::dot(v, v));
            larger(most, larger(start, end))
        });
        S::from_f64(2.0) * h * fastest.max(square.sqrt())
    }

    /// How far from a port what moves with it can touch (m): the surfaces of its shapes, and held nodes; those of a
    /// half-space within so much of everything.
    pub(super) fn reach_of_ports(&self, everything: S) -> S {
        let held = self.island.attachments.iter().map(|own| vec3::norm(own.place));
        let shapes = self.things.iter().filter_map(|thing| match thing {
            Thing::Rigid { shape, port: Some(_), place } => {
                Some(shape.reach().unwrap_or(everything) + vec3::norm(place.origin))
            }
            _ => None,
        });
        shapes.chain(held).fold(S::ZERO, S::max)
    }

    /// Largest distance of a shape's surface from its port, or from the origin (m).
    pub(super) fn largest(&self) -> S {
        self.things.iter().fold(S::ZERO, |most, thing| {
            let Thing::Rigid { shape, place, .. } = thing else { return most };
            most.max(shape.reach().unwrap_or(S::ZERO) + vec3::norm(place.origin))
        })
    }
}

/// The impulses of the detected contacts, given the velocities without them at the end; the last list of twists gets
/// those with them: of the ports, and of the nodes that touch.
pub(super) fn press<S: Scalar>(h: S, memory: &mut StepMemory<'_, S>) -> sweep::Sweeps<S> {
    let StepMemory { twists: [_, free, end], inertias, touches: [now, _], counts, .. } = memory;
    let now = now.get_mut(..counts[0]).unwrap_or_default();
    let ports = inertias.couplings.len();
    restore(now, ports, free, end);
    if now.is_empty() {
        return sweep::Sweeps { number: 0, settled: true, left: S::ZERO };
    }
    let sweeps = sweep(now, h, ports, inertias, end);
    // Sweeps accumulate rounding errors in the velocities that they change: recompute them from the impulses.
    restore(now, ports, free, end);
    now.iter().for_each(|touch| touch.contact.push(inertias, end, touch.contact.impulse));
    sweep::take_no_more(now, ports, free, inertias, end);
    sweeps
}

/// Velocities without contacts of the ports and of the nodes that touch.
fn restore<S: Scalar>(now: &[Touch<S>], ports: usize, free: &[Twist<S>], end: &mut [Twist<S>]) {
    end.iter_mut().zip(free).take(ports).for_each(|(to, from)| *to = *from);
    for (_, point) in now.iter().flat_map(|touch| touch.contact.points()) {
        if let (Some(to), Some(from)) = (end.get_mut(point.body), free.get(point.body)) {
            *to = *from;
        }
    }
}

/// Adds the contacts' mean forces to those on nodes and ports; returns the number of contacts that push.
pub(super) fn load_contacts<S: Scalar>(
    h: S,
    contacts: impl Iterator<Item = Contact<S>>,
    (nodes, wrenches): (&mut [Vec3<S>], &mut [Wrench<S>]),
) -> usize {
    let mut active = 0;
    for contact in contacts.filter(|contact| contact.impulse[0] > S::ZERO) {
        active += 1;
        load(&contact, |impulse| vec3::scale(impulse, S::ONE / h), (nodes, wrenches));
    }
    active
}

/// Adds a contact's force to those on nodes and ports: what a function makes of the impulse, or force, on each.
pub(super) fn load<S: Scalar>(
    contact: &Contact<S>,
    force: impl Fn(Vec3<S>) -> Vec3<S>,
    (nodes, wrenches): (&mut [Vec3<S>], &mut [Wrench<S>]),
) {
    let ports = wrenches.len();
    contact.deal(contact.impulse, |body, arm, impulse| {
        let force = force(impulse);
        if body >= ports {
            vec3::add_at(nodes, body - ports, force);
        } else if let Some(wrench) = wrenches.get_mut(body) {
            wrench.force = vec3::add(wrench.force, force);
            wrench.moment = vec3::add(wrench.moment, vec3::cross(arm, force));
        }
    });
}
