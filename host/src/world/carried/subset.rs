//! Some parts of a world as a world of their own, so that they can be stepped separately.
//!
//! In: a world, parts that no attachment joins to others. Out: the lists restricted to these parts, with the indices of
//! their entries in the whole. Before a step it copies its state from the whole, afterwards back.

use super::reach::Reach;
use super::{CarriedWorld, Fixed, Place, Room};
use crate::world::books::{Books, Shares};
use crate::world::carriers::HostCarrier;
use crate::world::engine::Engine;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{Attachment, Carrier, Cell, Group, Inertias, Thing, Wrench};
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

/// Maps of indices from the whole to the subset.
struct Renumbered {
    nodes: Vec<usize>,
    ports: Vec<usize>,
    /// Old and new first facet of each flexible part, by its old facets.
    facets: Vec<(Range<usize>, usize)>,
}

impl Renumbered {
    fn facet(&self, old: usize) -> usize {
        let own = self.facets.iter().find(|(range, _)| range.contains(&old) || range.end == old);
        own.map_or(old, |(range, new)| new + old - range.start)
    }
}

impl CarriedWorld {
    /// The subset of these parts, in ascending order, and of parts fixed in space that hold their nodes.
    pub(super) fn subset(&self, parts: &[usize]) -> Subset {
        let parts = &self.with_holders(parts);
        let (n_q, n_free) = (self.carriers.iter().map(Carrier::n_q).sum::<usize>(), self.free());
        let split = self.split();
        let free_before = before(&self.fixed.held);
        let mut fixed = Fixed::empty(self.fixed.gravity, self.fixed.air_drag);
        let mut new = Renumbered {
            nodes: vec![usize::MAX; self.room.pos.len()],
            ports: vec![usize::MAX; self.room.frames.len()],
            facets: Vec::new(),
        };
        let [mut q, mut pos, mut u, mut vel] = [const { Vec::new() }; 4];
        let (mut carriers, mut cells, mut n_ports) = (Vec::new(), Vec::new(), 0);
        let starts = self.carrier_starts();
        let mut nodes_of = vec![0..0; parts.len()];
        for (own_nodes, part) in nodes_of.iter_mut().zip(parts) {
            match &self.places[*part] {
                Place::Carrier(number, _) => {
                    let [first_q, first_u, first_port] = starts[*number];
                    let carrier = &self.carriers[*number];
                    q.extend(first_q..first_q + carrier.n_q());
                    u.extend(split + first_u..split + first_u + carrier.n_u());
                    for port in first_port..first_port + carrier.n_ports() {
                        new.ports[port] = n_ports;
                        n_ports += 1;
                    }
                    carriers.push(*number);
                }
                Place::Shape(..) => {}
                Place::Nodes(nodes, facets, cell) => {
                    let first = [fixed.mass.len(), fixed.springs.len(), fixed.facets.len()];
                    for (number, node) in nodes.clone().enumerate() {
                        new.nodes[node] = first[0] + number;
                        if !self.fixed.held[node] {
                            let at = free_before[node];
                            pos.extend(n_q + 3 * at..n_q + 3 * at + 3);
                            let first_vel = self.x.len() - 3 * n_free;
                            vel.extend(first_vel + 3 * at..first_vel + 3 * at + 3);
                        }
                    }
                    *own_nodes = first[0]..first[0] + nodes.len();
                    new.facets.push((facets.clone(), first[2]));
                    fixed.mass.extend(&self.fixed.mass[nodes.clone()]);
                    fixed.inverse_mass.extend(&self.fixed.inverse_mass[nodes.clone()]);
                    fixed.held.extend(&self.fixed.held[nodes.clone()]);
                    let own = self.fixed.springs.iter().filter(|spring| nodes.contains(&spring.tail));
                    fixed.springs.extend(own.map(|spring| {
                        let [tail, head] = [spring.tail, spring.head].map(|node| new.nodes[node]);
                        smartbed_runtime::flexible::Spring { tail, head, ..*spring }
                    }));
                    let own = self.fixed.facets[facets.clone()].iter();
                    fixed.facets.extend(own.map(|corners| corners.map(|node| new.nodes[node])));
                    let grids = self.fixed.grids.iter().filter(|grid| nodes.contains(&grid.first_node()));
                    fixed
                        .grids
                        .extend(grids.map(|grid| grid.from([nodes.start, first[0]], first[1], first[2])));
                    if let Some(cell) = cell {
                        let old = self.fixed.cells[*cell];
                        fixed.cells.push(Cell { facets: [first[2], fixed.facets.len()], ..old });
                        cells.push(*cell);
                    }
                }
            }
        }
        let own = self.fixed.attachments.iter().filter(|held| new.nodes[held.node] != usize::MAX);
        fixed.attachments = own
            .map(|held| Attachment { node: new.nodes[held.node], port: new.ports[held.port], ..*held })
            .collect();
        let own = self.fixed.restrained.iter().filter(|[first, _]| new.nodes[*first] != usize::MAX);
        fixed.restrained =
            own.map(|[first, end]| [new.nodes[*first], new.nodes[*first] + end - first]).collect();
        let x: Vec<usize> = [q, pos, u, vel].concat();
        let airs: Vec<usize> = (0..self.airs.len()).filter(|n| parts.contains(&self.airs[*n].part)).collect();
        let (mut world, pairs, things) =
            self.renumbered(&new, (fixed, &carriers, &cells, &airs), parts, x.len());
        let shares = self.books.as_ref().map(|_| {
            world.open_books();
            let held = |number: &usize| new.nodes[self.fixed.attachments[*number].node] != usize::MAX;
            Shares {
                held: (0..self.fixed.attachments.len()).filter(held).collect(),
                pairs: pairs.clone(),
                ports: kept(&new.ports),
                nodes: kept(&new.nodes),
                carriers: carriers.clone(),
                flows: airs.clone(),
            }
        });
        Subset {
            parts: parts.to_vec(),
            world,
            x,
            carriers,
            cells,
            airs,
            pairs,
            nodes: nodes_of,
            things,
            shares,
        }
    }

    /// The world with renumbered lists; its pairs by index, and the thing that represents each part.
    fn renumbered(
        &self,
        new: &Renumbered,
        (fixed, carriers, cells, airs): (Fixed, &[usize], &[usize], &[usize]),
        parts: &[usize],
        n: usize,
    ) -> (CarriedWorld, Vec<usize>, Vec<Option<Thing<f64>>>) {
        // Parts are in ascending order, so that nodes and ports keep their order.
        let order = kept(&new.nodes);
        let of_nodes = |list: &[Vec3<f64>]| order.iter().map(|node| list[*node]).collect::<Vec<_>>();
        let ports = new.ports.iter().filter(|port| **port != usize::MAX).count();
        let points = order.len();
        let mut members: Vec<HostCarrier> =
            carriers.iter().map(|number| self.carriers[*number].clone()).collect();
        let answers = Inertias::answers(&Group { members: &mut members });
        let airs = airs.iter().map(|number| {
            let mut air = self.airs[*number].clone();
            air.cell = cells.iter().position(|cell| *cell == air.cell).unwrap_or(0);
            air
        });
        let (mut pairs, mut things) = (Vec::new(), vec![None; parts.len()]);
        let touching = self.touching.as_ref().map(|whole| {
            let moved = |thing: &Thing<f64>| match thing {
                Thing::Rigid { shape, port, place } => {
                    Thing::Rigid { shape: *shape, port: port.map(|port| new.ports[port]), place: *place }
                }
                Thing::Mesh { nodes: [first, end], facets, depth } => Thing::Mesh {
                    nodes: [new.nodes[*first], new.nodes[*first] + end - first],
                    facets: facets.map(|facet| new.facet(facet)),
                    depth: *depth,
                },
            };
            let (mut own, numbers) = whole.among(parts, moved, [ports, points, answers, n]);
            for (thing, part) in things.iter_mut().zip(parts) {
                *thing = whole.thing_of(*part).map(|thing| moved(&thing));
            }
            own.choose(self.ode_method(), n);
            pairs = numbers;
            own
        });
        let world = CarriedWorld {
            names: self.names.clone(),
            places: Vec::new(),
            carriers: members,
            room: Room {
                pos: of_nodes(&self.room.pos),
                vel: of_nodes(&self.room.vel),
                elastic: vec![[0.0; 3]; points],
                viscous: vec![[0.0; 3]; points],
                frames: frames_of(&new.ports, &self.room.frames),
                wrenches: vec![Wrench::zero(); ports],
            },
            fixed,
            x: vec![0.0; n],
            low: vec![0.0; n],
            scratch: vec![0.0; self.ode_method().scratch(n)],
            contacts: self.contacts,
            method: self.method,
            h: self.h,
            starts: Vec::new(),
            t: self.t,
            drive: 0.0,
            damping: 0.0,
            impact: 0.0,
            friction: 0.0,
            airs: airs.collect(),
            touching,
            unsettled: 0,
            forced: 0,
            books: None,
            stable: self.stable,
        };
        (world, pairs, things)
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

    /// First coordinate, speed and port of each carrier.
    fn carrier_starts(&self) -> Vec<[usize; 3]> {
        let mut next = [0; 3];
        let starts = self.carriers.iter().map(|carrier| {
            let own = [carrier.n_q(), carrier.n_u(), carrier.n_ports()];
            let first = next;
            next.iter_mut().zip(own).for_each(|(next, own)| *next += own);
            first
        });
        starts.collect()
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
        [own.drive, own.damping, own.impact, own.friction] = [0.0; 4];
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
        whole.drive += own.drive;
        whole.damping += own.damping;
        whole.impact += own.impact;
        whole.friction += own.friction;
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
        whole.damping += before - self.world.energies()?.kinetic;
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

/// Indices of the whole that have one here.
fn kept(new: &[usize]) -> Vec<usize> {
    (0..new.len()).filter(|old| new[*old] != usize::MAX).collect()
}

/// Frames of the ports that are part of the subset.
fn frames_of(new: &[usize], frames: &[Frame<f64>]) -> Vec<Frame<f64>> {
    new.iter().zip(frames).filter(|(new, _)| **new != usize::MAX).map(|(_, frame)| *frame).collect()
}

/// Number of free nodes before each node.
fn before(held: &[bool]) -> Vec<usize> {
    let mut count = 0;
    let before = held.iter().map(|held| {
        let before = count;
        count += usize::from(!held);
        before
    });
    before.collect()
}
