//! Some parts of a world as a world of their own, so that they can be stepped separately.
//!
//! In: a world, parts that no attachment joins to others. Out: the lists restricted to these parts, with the indices of
//! their entries in the whole. Before a step it copies its state from the whole, afterwards back.

use super::reach::Reach;
use super::selection::Selection;
use super::{CarriedWorld, Place};
use crate::world::books::{Books, Shares};
use crate::world::carriers::HostCarrier;
use crate::world::engine::Engine;
use smartbed_runtime::vec3;
use smartbed_runtime::world::{Accounts as Works, Carrier, Thing};
use std::ops::Range;

/// A restricted world, with the indices of its entries in the whole.
#[derive(Clone, Debug)]
pub(super) struct Subset {
    /// The parts.
    pub(super) parts: Vec<usize>,
    pub(super) world: CarriedWorld,
    x: Vec<usize>,
    carriers: Vec<usize>,
    cells: Vec<usize>,
    airs: Vec<usize>,
    pairs: Vec<usize>,
    /// By part: its nodes and its shape here, and the reach of the shape from its port (m).
    nodes: Vec<Range<usize>>,
    things: Vec<Option<Thing<f64>>>,
    /// If the whole keeps books: where those of this world belong in them.
    shares: Option<Shares>,
}

impl CarriedWorld {
    /// The subset of these parts, in ascending order, and of parts fixed in space that hold their nodes.
    pub(super) fn subset(&self, parts: &[usize]) -> Subset {
        let own = Selection::of(self, self.with_holders(parts));
        let (mut world, pairs) = own.world();
        let shares = self.books.as_ref().map(|_| {
            world.open_books();
            own.shares(&pairs)
        });
        let (x, things) = (own.x(), own.things());
        let Selection { parts, part_nodes: nodes, carriers, cells, airs, .. } = own;
        Subset { parts, world, x, carriers, cells, airs, pairs, nodes, things, shares }
    }

    /// These parts and those fixed in space that hold nodes of theirs.
    fn with_holders(&self, parts: &[usize]) -> Vec<usize> {
        let is_own = |node: usize| {
            parts
                .iter()
                .any(|part| matches!(&self.places[*part], Place::Nodes(own, ..) if own.contains(&node)))
        };
        let held = self.fixed.attachments.iter().filter(|held| is_own(held.node));
        let ports: Vec<usize> = held.map(|held| held.port).collect();
        let starts = self.carrier_starts();
        let holds = |part: &usize| {
            let Place::Carrier(number, _) = self.places[*part] else { return false };
            self.is_still(*part) && ports.contains(&starts[number][2])
        };
        (0..self.places.len()).filter(|part| parts.contains(part) || holds(part)).collect()
    }

    /// Is the part fixed in space?
    pub(super) fn is_still(&self, part: usize) -> bool {
        matches!(self.places[part], Place::Carrier(number, _) if matches!(self.carriers[number], HostCarrier::Still(_)))
    }
}

impl Subset {
    /// Copies the state from the whole.
    pub(super) fn take(&mut self, whole: &CarriedWorld) {
        let own = &mut self.world;
        for (n, place) in self.x.iter().enumerate() {
            (own.x[n], own.low[n]) = (whole.x[*place], whole.low[*place]);
        }
        for (cell, number) in own.fixed.cells.iter_mut().zip(&self.cells) {
            cell.content = whole.fixed.cells[*number].content;
        }
        for (air, number) in own.airs.iter_mut().zip(&self.airs) {
            let of = &whole.airs[*number];
            (air.volume, air.lines, air.account) = (of.volume, of.lines, of.account);
        }
        for (carrier, number) in own.carriers.iter_mut().zip(&self.carriers) {
            if let (HostCarrier::Mechanism(own), HostCarrier::Mechanism(of)) =
                (carrier, &whole.carriers[*number])
            {
                own.hold_as(of);
            }
        }
        own.t = whole.t;
        own.works = Works::empty();
        (own.unsettled, own.forced) = (0, 0);
        own.books.iter_mut().for_each(Books::clear);
    }

    /// Copies the state back, and adds the accounts and events of the step.
    pub(super) fn give(&self, whole: &mut CarriedWorld) {
        let own = &self.world;
        for (n, place) in self.x.iter().enumerate() {
            (whole.x[*place], whole.low[*place]) = (own.x[n], own.low[n]);
        }
        for (cell, number) in own.fixed.cells.iter().zip(&self.cells) {
            whole.fixed.cells[*number].content = cell.content;
        }
        for (air, number) in own.airs.iter().zip(&self.airs) {
            let to = &mut whole.airs[*number];
            (to.volume, to.account) = (air.volume, air.account);
        }
        for (carrier, number) in own.carriers.iter().zip(&self.carriers) {
            if let (HostCarrier::Mechanism(own), HostCarrier::Mechanism(to)) =
                (carrier, &mut whole.carriers[*number])
            {
                to.pivot = to.pivot.min(own.pivot);
            }
        }
        whole.works = whole.works.plus(&own.works);
        whole.unsettled += own.unsettled;
        whole.forced += own.forced;
        if let (Some(to), Some(books), Some(shares)) = (&mut whole.books, &own.books, &self.shares) {
            to.add(books, shares);
        }
    }

    /// Reports the contact forces to the whole.
    pub(super) fn tell(&self, whole: &mut CarriedWorld) {
        if let (Some(to), Some(from)) = (&mut whole.touching, &self.world.touching) {
            to.hear(from, &self.pairs);
        }
    }

    /// Number of nodes.
    pub(super) fn points(&self) -> usize {
        self.world.room.pos.len()
    }

    /// Bounding boxes of the parts at their last positions.
    pub(super) fn reaches(&self) -> impl Iterator<Item = (usize, Reach)> {
        self.parts.iter().enumerate().map(|(n, part)| {
            let room = &self.world.room;
            let mut reach = Reach::NOTHING;
            for node in self.nodes[n].clone() {
                reach.add(room.pos[node], 0.0, vec3::norm(room.vel[node]));
            }
            if let Some(Thing::Rigid { shape, port: Some(port), place }) = &self.things[n] {
                let (frame, own) = (&room.frames[*port], shape.reach());
                let Some(own) = own else { return (*part, Reach::EVERYWHERE) };
                let far = own + vec3::norm(place.origin);
                let speed = vec3::norm(frame.velocity) + far * vec3::norm(frame.angular_velocity);
                reach.add(frame.point(place.origin), own, speed);
            }
            (*part, reach)
        })
    }

    /// Largest speed of all nodes (m/s), mechanisms and bodies (m/s, rad/s).
    pub(super) fn fastest(&self) -> f64 {
        let own = &self.world;
        let (mut next, mut most) = (own.split(), 0.0_f64);
        for carrier in &own.carriers {
            let u = &own.x[next..next + carrier.n_u()];
            next += carrier.n_u();
            let mut add = |speed: f64| most = most.max(speed.abs());
            match carrier {
                HostCarrier::Floating(floating) => {
                    u[..3].iter().for_each(|x| add(*x));
                    // For a given angular momentum the largest angular velocity is about the axis of least inertia.
                    let [x, y, z] = floating.body.inertia;
                    add(vec3::norm([u[3], u[4], u[5]]) / x.min(y).min(z));
                }
                _ => u.iter().for_each(|x| add(*x)),
            }
        }
        own.x[next..].iter().fold(most, |most, x| most.max(x.abs()))
    }

    /// Stops all motion; its kinetic energy is booked as damping.
    pub(super) fn stop(&mut self, whole: &mut CarriedWorld) -> Result<(), String> {
        let before = self.world.energies()?.kinetic;
        let motion = self.shares.is_some().then(|| self.world.motion()).transpose()?;
        let split = self.world.split();
        self.world.x[split..].fill(0.0);
        self.world.low[split..].fill(0.0);
        for place in &self.x[split..] {
            (whole.x[*place], whole.low[*place]) = (0.0, 0.0);
        }
        whole.works.damping += before - self.world.energies()?.kinetic;
        if let (Some(before), Some(shares)) = (motion, &self.shares) {
            let after = self.world.motion()?;
            if let (Some(own), Some(to)) = (&mut self.world.books, &mut whole.books) {
                own.clear();
                own.stop(&before, &after);
                to.add(own, shares);
            }
        }
        Ok(())
    }

    /// Can it change although nothing moves, because time drives a mechanism or gas flows?
    pub(super) fn is_driven(&self) -> bool {
        let flows = self.world.airs.iter().flat_map(|air| air.lines.iter().flatten());
        let reads_time =
            |carrier: &HostCarrier| matches!(carrier, HostCarrier::Mechanism(ported) if ported.reads_time());
        self.world.carriers.iter().any(reads_time) || flows.into_iter().any(|line| line.opening > 0.0)
    }
}
