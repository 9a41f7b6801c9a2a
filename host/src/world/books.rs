//! Books of a world of flexible parts: what each node, attachment, pair, port, carrier and gas has given and taken.
//!
//! In: what the runtime shows an observer. Out: sums in joules since the start, from which `carried/balance` forms the
//! accounts of parts and seams. Nothing reads them while the world moves.

use super::accounts::Passed;
use super::engine::Event;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::contact::{Contact, Twist};
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{Ends, Forces, Observer, Push, Strike};
use std::ops::Range;

/// A node that is held in a port.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    pub(super) node: usize,
    pub(super) port: usize,
    /// Work on the port (J).
    pub(super) work: f64,
}

/// Sums since the start (J).
#[derive(Clone, Debug)]
pub(super) struct Books {
    /// By attachment.
    pub(super) held: Vec<Held>,
    /// By pair of contacts.
    pub(super) pairs: Vec<Passed>,
    /// By port: work on it.
    pub(super) ports: Vec<f64>,
    /// By node: mass if it is free; taken by dampers, by air; given by an impact's impulses along springs.
    mass: Vec<f64>,
    pub(super) damped: Vec<f64>,
    pub(super) dragged: Vec<f64>,
    pub(super) restored: Vec<f64>,
    /// By carrier: work of its drives, taken by its dampers.
    pub(super) driven: Vec<f64>,
    pub(super) carrier_damped: Vec<f64>,
    /// By gas: change of its potential by flow.
    pub(super) flows: Vec<f64>,
    /// Drag of the air at each node (N s/m).
    air_drag: f64,
}

/// Indices, in the books of a whole, of the entries of books of some of its parts.
#[derive(Clone, Debug)]
pub(super) struct Shares {
    pub(super) held: Vec<usize>,
    pub(super) pairs: Vec<usize>,
    pub(super) ports: Vec<usize>,
    pub(super) nodes: Vec<usize>,
    pub(super) carriers: Vec<usize>,
    pub(super) flows: Vec<usize>,
}

/// An observer of a step: events of located touches, and the books if they are kept.
pub(super) struct Watch<'a> {
    /// By pair: its parts, and the bodies that each of them is (ports, then nodes).
    pub(super) parts: &'a [[usize; 2]],
    pub(super) bodies: &'a [[Range<usize>; 2]],
    pub(super) found: &'a mut Vec<Event>,
    pub(super) books: Option<&'a mut Books>,
}

impl Books {
    /// Empty books for attachments (node, port), masses of the nodes (0: held) and their drag in air (N s/m), and
    /// numbers of pairs, ports, carriers and gases.
    pub(super) fn new(
        held: impl Iterator<Item = [usize; 2]>,
        (mass, air_drag): (Vec<f64>, f64),
        [pairs, ports, carriers, gases]: [usize; 4],
    ) -> Books {
        Books {
            held: held.map(|[node, port]| Held { node, port, work: 0.0 }).collect(),
            pairs: vec![Passed::default(); pairs],
            ports: vec![0.0; ports],
            damped: vec![0.0; mass.len()],
            dragged: vec![0.0; mass.len()],
            air_drag,
            restored: vec![0.0; mass.len()],
            mass,
            driven: vec![0.0; carriers],
            carrier_damped: vec![0.0; carriers],
            flows: vec![0.0; gases],
        }
    }

    /// All sums.
    fn sums(&mut self) -> impl Iterator<Item = &mut f64> {
        let pairs = self.pairs.iter_mut().flat_map(|pair| {
            let Passed { to: [one, other], impact, friction, .. } = pair;
            [one, other, impact, friction]
        });
        let lists = [
            &mut self.ports,
            &mut self.damped,
            &mut self.dragged,
            &mut self.restored,
            &mut self.driven,
            &mut self.carrier_damped,
            &mut self.flows,
        ];
        self.held.iter_mut().map(|held| &mut held.work).chain(pairs).chain(lists.into_iter().flatten())
    }

    /// Sets all sums to 0.
    pub(super) fn clear(&mut self) {
        self.sums().for_each(|sum| *sum = 0.0);
    }

    /// Adds the sums of some of the parts.
    pub(super) fn add(&mut self, own: &Books, of: &Shares) {
        for (held, number) in own.held.iter().zip(&of.held) {
            self.held[*number].work += held.work;
        }
        for (pair, number) in own.pairs.iter().zip(&of.pairs) {
            let to = &mut self.pairs[*number];
            (to.to[0], to.to[1]) = (to.to[0] + pair.to[0], to.to[1] + pair.to[1]);
            (to.impact, to.friction) = (to.impact + pair.impact, to.friction + pair.friction);
        }
        let lists = [
            (&mut self.ports, &own.ports, &of.ports),
            (&mut self.damped, &own.damped, &of.nodes),
            (&mut self.dragged, &own.dragged, &of.nodes),
            (&mut self.restored, &own.restored, &of.nodes),
            (&mut self.driven, &own.driven, &of.carriers),
            (&mut self.carrier_damped, &own.carrier_damped, &of.carriers),
            (&mut self.flows, &own.flows, &of.flows),
        ];
        for (to, from, numbers) in lists {
            for (value, number) in from.iter().zip(numbers) {
                to[*number] += value;
            }
        }
    }

    /// Books motion that was stopped as damping: kinetic energies before and after.
    pub(super) fn stop(&mut self, before: &[Vec<f64>; 2], after: &[Vec<f64>; 2]) {
        for (to, (before, after)) in
            [&mut self.damped, &mut self.carrier_damped].into_iter().zip(before.iter().zip(after))
        {
            for (to, (before, after)) in to.iter_mut().zip(before.iter().zip(after)) {
                *to += before - after;
            }
        }
    }

    /// Forces on nodes over a span: works through attachments, and of dampers.
    pub(super) fn forces<S: Scalar>(&mut self, forces: &Forces<'_, S>) {
        let (ports, duration) = (self.ports.len(), forces.duration.to_f64());
        let velocity = |node: usize| mean(forces.ends, ports + node, vec3::zero());
        for Held { node, port, work } in &mut self.held {
            let force = vec3::add(vec3::at(forces.elastic, *node), vec3::at(forces.viscous, *node));
            let given = duration * vec3::dot(force, velocity(*node)).to_f64();
            *work += given;
            self.ports[*port] += given;
        }
        let taken = self.damped.iter_mut().zip(&mut self.dragged).zip(forces.viscous);
        for (node, ((damped, dragged), force)) in taken.enumerate() {
            let velocity = velocity(node);
            // The air's part of the viscous force is -drag v.
            let drag = duration * self.air_drag * vec3::dot(velocity, velocity).to_f64();
            *damped -= duration * vec3::dot(*force, velocity).to_f64() + drag;
            *dragged += drag;
        }
    }

    /// Which of the pair's parts is the first side of a contact? Meshes touch each other both ways, so sides may be
    /// swapped; a side may consist of corners that are attached, which are points of ports.
    fn part_of_first<S: Scalar>(&self, contact: &Contact<S>, bodies: &[Range<usize>; 2]) -> usize {
        let ports = self.ports.len();
        let part = |side: usize, is_node: bool| {
            let points = contact.sides[side].points().filter(|point| (point.body >= ports) == is_node);
            let mut parts =
                points.filter_map(|point| bodies.iter().position(|own| own.contains(&point.body)));
            parts.next().map(|part| if side == 0 { part } else { 1 - part })
        };
        part(0, true).or(part(1, true)).or(part(0, false)).or(part(1, false)).unwrap_or(0)
    }

    /// Works of a contact's force or impulse on both sides; `bodies` are those of the pair's parts.
    fn work<S: Scalar>(
        &mut self,
        (pair, duration): (usize, S),
        contact: &Contact<S>,
        ends: Ends<'_, S>,
        bodies: &[Range<usize>; 2],
        mut on_node: impl FnMut(&mut Books, usize, f64),
    ) -> f64 {
        let (ports, impulse, mut sum) = (self.ports.len(), contact.to_inertial(contact.impulse), 0.0);
        let first = self.part_of_first(contact, bodies);
        for (side, part) in [(0, first), (1, 1 - first)] {
            for (point, impulse) in contact.on_side(side, impulse) {
                let velocity = mean(ends, point.body, point.arm);
                let work = (duration * vec3::dot(impulse, velocity)).to_f64();
                self.pairs[pair].to[part] += work;
                sum += work;
                if point.body >= ports {
                    on_node(self, point.body - ports, work);
                    continue;
                }
                self.ports[point.body] += work;
                // A corner that is attached: the force on it passes on to what holds it.
                if !bodies[part].contains(&point.body) {
                    let own = |held: &&mut Held| {
                        held.port == point.body && bodies[part].contains(&(ports + held.node))
                    };
                    if let Some(held) = self.held.iter_mut().find(own) {
                        held.work += work;
                    }
                }
            }
        }
        sum
    }

    /// Works of a contact that pushes, and what it takes.
    pub(super) fn push<S: Scalar>(&mut self, push: &Push<'_, S>, bodies: &[Range<usize>; 2]) {
        let Push { pair, contact, duration, ends, strikes, taken } = *push;
        self.work((pair, duration), contact, ends, bodies, |_, _, _| {});
        let half = S::from_f64(0.5);
        let [n, x, y] = vec3::scale(vec3::add(contact.relative(ends[0]), contact.relative(ends[1])), half);
        let [normal, along, across] = contact.impulse;
        let own = &mut self.pairs[pair];
        own.friction -= (duration * (along * x + across * y)).to_f64();
        own.impact += (duration * taken).to_f64();
        if strikes {
            own.impact -= (duration * normal * n).to_f64();
        }
    }

    /// Works of a contact in an impact; whatever the sides do not get is lost.
    pub(super) fn struck<S: Scalar>(
        &mut self,
        pair: usize,
        contact: &Contact<S>,
        ends: Ends<'_, S>,
        bodies: &[Range<usize>; 2],
    ) {
        let on_node = |books: &mut Books, node: usize, work: f64| books.restored[node] -= work;
        let sum = self.work((pair, S::ONE), contact, ends, bodies, on_node);
        self.pairs[pair].impact -= sum;
    }

    fn strike<S: Scalar>(&mut self, strike: &Strike<'_, S>, bodies: &[[Range<usize>; 2]]) {
        let ports = self.ports.len();
        for (touch, struck) in strike.touches.iter().zip(strike.struck) {
            self.struck(touch.pair, &struck.contact, strike.ends, &bodies[touch.pair]);
        }
        for (node, (mass, restored)) in self.mass.iter().zip(&mut self.restored).enumerate() {
            let [before, after] = strike.ends.map(|twists| {
                let velocity = twists.get(ports + node).map_or_else(vec3::zero, |twist| twist.velocity);
                vec3::dot(velocity, velocity).to_f64()
            });
            *restored += 0.5 * mass * (after - before);
        }
    }
}

impl<S: Scalar> Observer<S> for Watch<'_> {
    fn watches(&self) -> bool {
        self.books.is_some()
    }

    fn forces(&mut self, forces: &Forces<'_, S>) {
        if let Some(books) = &mut self.books {
            books.forces(forces);
        }
    }

    fn damped(&mut self, node: usize, energy: S) {
        if let Some(books) = &mut self.books {
            books.damped[node] += energy.to_f64();
        }
    }

    fn carried(&mut self, member: usize, [given, taken]: [S; 2]) {
        if let Some(books) = &mut self.books {
            books.driven[member] += given.to_f64();
            books.carrier_damped[member] += taken.to_f64();
        }
    }

    fn push(&mut self, push: &Push<'_, S>) {
        if let Some(books) = &mut self.books {
            books.push(push, &self.bodies[push.pair]);
        }
    }

    fn strike(&mut self, strike: &Strike<'_, S>) {
        if let Some(books) = &mut self.books {
            books.strike(strike, self.bodies);
        }
        for (pair, parts) in self.parts.iter().enumerate() {
            let own = strike.touches.iter().zip(strike.struck).filter(|(touch, _)| touch.pair == pair);
            let time = strike.time.to_f64();
            let mut event = Event { time, parts: *parts, points: 0, approach: 0.0, impulse: 0.0 };
            for (touch, struck) in own {
                let impulse = struck.contact.impulse[0];
                event.points += usize::from(impulse > S::ZERO);
                event.impulse += impulse.to_f64();
                event.approach = event.approach.max(-touch.velocity()[0].to_f64());
            }
            if event.points > 0 {
                self.found.push(event);
            }
        }
    }
}

/// Mean velocity of a point of a body.
fn mean<S: Scalar>(ends: Ends<'_, S>, body: usize, arm: Vec3<S>) -> Vec3<S> {
    let [before, after] =
        ends.map(|twists: &[Twist<S>]| twists.get(body).map_or_else(vec3::zero, |twist| twist.at(arm)));
    vec3::scale(vec3::add(before, after), S::from_f64(0.5))
}
