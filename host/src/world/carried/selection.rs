//! Picks parts of a world: their entries of its lists, renumbered, as a world of their own.
//!
//! In: a world, parts in ascending order, so that nodes and ports keep their order. Out: the lists of these parts, the
//! index in the whole of each entry, and a world of them.

use super::{CarriedWorld, Fixed, Place, Room};
use crate::world::books::Shares;
use crate::world::carriers::HostCarrier;
use smartbed_runtime::flexible::Spring;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{
    Accounts as Works, Attachment, Carrier, Cell, Group, Inertias, Thing, Wall, Wrench,
};
use std::ops::Range;

/// What has no entry among the parts.
const NOWHERE: usize = usize::MAX;

/// The parts' entries, in the order in which they are added.
pub(super) struct Selection<'a> {
    whole: &'a CarriedWorld,
    pub(super) parts: Vec<usize>,
    /// By part: its nodes.
    pub(super) part_nodes: Vec<Range<usize>>,
    pub(super) carriers: Vec<usize>,
    pub(super) cells: Vec<usize>,
    pub(super) airs: Vec<usize>,
    fixed: Fixed,
    /// New indices of all nodes and ports, or [`NOWHERE`].
    nodes: Vec<usize>,
    ports: Vec<usize>,
    n_ports: usize,
    /// Old and new first facet of each flexible part, by its old facets.
    facets: Vec<(Range<usize>, usize)>,
    /// Places in the whole's state: coordinates and speeds of carriers, positions and velocities of free nodes.
    q: Vec<usize>,
    pos: Vec<usize>,
    u: Vec<usize>,
    vel: Vec<usize>,
}

impl<'a> Selection<'a> {
    /// The entries of these parts.
    pub(super) fn of(whole: &'a CarriedWorld, parts: Vec<usize>) -> Self {
        let airs = (0..whole.airs.len()).filter(|n| parts.contains(&whole.airs[*n].part)).collect();
        let mut own = Self {
            whole,
            part_nodes: vec![0..0; parts.len()],
            carriers: Vec::new(),
            cells: Vec::new(),
            airs,
            fixed: Fixed::empty(whole.fixed.gravity, whole.fixed.air_drag),
            nodes: vec![NOWHERE; whole.room.pos.len()],
            ports: vec![NOWHERE; whole.room.frames.len()],
            n_ports: 0,
            facets: Vec::new(),
            q: Vec::new(),
            pos: Vec::new(),
            u: Vec::new(),
            vel: Vec::new(),
            parts,
        };
        let (starts, first_places) = (whole.carrier_starts(), whole.node_places());
        for n in 0..own.parts.len() {
            match &whole.places[own.parts[n]] {
                Place::Carrier(number, _) => own.add_carrier(*number, starts[*number]),
                Place::Shape(..) => {}
                Place::Nodes(nodes, facets, cell) => {
                    own.part_nodes[n] = own.add_nodes(nodes, &first_places);
                    own.add_elements(nodes, facets, *cell);
                }
            }
        }
        own.add_holds();
        own
    }

    /// Adds a mechanism or rigid body, whose first coordinate, speed and port are given.
    fn add_carrier(&mut self, number: usize, [first_q, first_u, first_port]: [usize; 3]) {
        let carrier = &self.whole.carriers[number];
        self.q.extend(first_q..first_q + carrier.n_q());
        self.u.extend(self.whole.split() + first_u..self.whole.split() + first_u + carrier.n_u());
        for port in first_port..first_port + carrier.n_ports() {
            self.ports[port] = self.n_ports;
            self.n_ports += 1;
        }
        self.carriers.push(number);
    }

    /// Adds a flexible part's nodes; returns their new range.
    fn add_nodes(&mut self, nodes: &Range<usize>, first_places: &[[usize; 2]]) -> Range<usize> {
        let (from, first) = (&self.whole.fixed, self.fixed.mass.len());
        for (number, node) in nodes.clone().enumerate() {
            self.nodes[node] = first + number;
            if !from.held[node] {
                let [pos, vel] = first_places[node];
                self.pos.extend(pos..pos + 3);
                self.vel.extend(vel..vel + 3);
            }
        }
        self.fixed.mass.extend(&from.mass[nodes.clone()]);
        self.fixed.inverse_mass.extend(&from.inverse_mass[nodes.clone()]);
        self.fixed.held.extend(&from.held[nodes.clone()]);
        first..first + nodes.len()
    }

    /// Adds a flexible part's springs, facets, grids and gas; its nodes have been added.
    fn add_elements(&mut self, nodes: &Range<usize>, facets: &Range<usize>, cell: Option<usize>) {
        let (from, new) = (&self.whole.fixed, &self.nodes);
        let first = [new[nodes.start], self.fixed.springs.len(), self.fixed.facets.len()];
        let own = from.springs.iter().filter(|spring| nodes.contains(&spring.tail));
        let springs = own.map(|spring| {
            let [tail, head] = [spring.tail, spring.head].map(|node| new[node]);
            Spring { tail, head, ..*spring }
        });
        self.fixed.springs.extend(springs);
        let own = from.facets[facets.clone()].iter();
        self.fixed.facets.extend(own.map(|corners| corners.map(|node| new[node])));
        self.facets.push((facets.clone(), first[2]));
        let own = from.grids.iter().filter(|grid| nodes.contains(&grid.first_node()));
        let grids = own.map(|grid| grid.from([nodes.start, first[0]], first[1], first[2]));
        self.fixed.grids.extend(grids);
        if let Some(cell) = cell {
            let own = &from.cells[cell];
            let wall = own.wall.map(|wall| Wall { first: wall.first - own.facets[0] + first[2], ..wall });
            let facets = [first[2], self.fixed.facets.len()];
            self.fixed.cells.push(Cell { facets, wall, ..*own });
            self.cells.push(cell);
        }
    }

    /// Adds what holds the nodes.
    fn add_holds(&mut self) {
        let (from, nodes, ports) = (&self.whole.fixed, &self.nodes, &self.ports);
        let own = from.attachments.iter().filter(|held| nodes[held.node] != NOWHERE);
        let attachments =
            own.map(|held| Attachment { node: nodes[held.node], port: ports[held.port], ..*held });
        self.fixed.attachments = attachments.collect();
        for wall in self.fixed.cells.iter_mut().filter_map(|cell| cell.wall.as_mut()) {
            let [first, end] = wall.attachments;
            let before = from.attachments[..first].iter().filter(|held| nodes[held.node] != NOWHERE).count();
            *wall = Wall { port: ports[wall.port], attachments: [before, before + end - first], ..*wall };
        }
        let own = from.restrained.iter().filter(|[first, _]| nodes[*first] != NOWHERE);
        let restrained = own.map(|[first, end]| [nodes[*first], nodes[*first] + end - first]);
        self.fixed.restrained = restrained.collect();
    }

    /// The place in the whole's state of each entry of the parts' state.
    pub(super) fn x(&self) -> Vec<usize> {
        [&*self.q, &self.pos, &self.u, &self.vel].concat()
    }

    /// Where the books of the parts, whose pairs of contacts are given, belong in those of the whole.
    pub(super) fn shares(&self, pairs: &[usize]) -> Shares {
        let attachments = &self.whole.fixed.attachments;
        let held = |number: &usize| self.nodes[attachments[*number].node] != NOWHERE;
        Shares {
            held: (0..attachments.len()).filter(held).collect(),
            pairs: pairs.to_vec(),
            ports: kept(&self.ports),
            nodes: kept(&self.nodes),
            carriers: self.carriers.clone(),
            flows: self.airs.clone(),
        }
    }

    /// What stands for a part in contacts, with new indices.
    fn thing(&self, thing: &Thing<f64>) -> Thing<f64> {
        match thing {
            Thing::Rigid { shape, port, place } => {
                Thing::Rigid { shape: *shape, port: port.map(|port| self.ports[port]), place: *place }
            }
            Thing::Mesh { nodes: [first, end], facets, depth } => Thing::Mesh {
                nodes: [self.nodes[*first], self.nodes[*first] + end - first],
                facets: facets.map(|facet| self.facet(facet)),
                depth: *depth,
            },
        }
    }

    fn facet(&self, old: usize) -> usize {
        let own = self.facets.iter().find(|(range, _)| range.contains(&old) || range.end == old);
        own.map_or(old, |(range, new)| new + old - range.start)
    }

    /// What stands for each part in contacts.
    pub(super) fn things(&self) -> Vec<Option<Thing<f64>>> {
        let of = |part: &usize| self.whole.touching.as_ref()?.thing_of(*part);
        self.parts.iter().map(|part| of(part).map(|thing| self.thing(&thing))).collect()
    }

    /// The world of the parts, and the index in the whole of each pair of contacts.
    pub(super) fn world(&self) -> (CarriedWorld, Vec<usize>) {
        let (whole, n) = (self.whole, self.x().len());
        let order = kept(&self.nodes);
        let of_nodes = |list: &[Vec3<f64>]| order.iter().map(|node| list[*node]).collect::<Vec<_>>();
        let mut members: Vec<HostCarrier> =
            self.carriers.iter().map(|number| whole.carriers[*number].clone()).collect();
        let answers = Inertias::answers(&Group { members: &mut members });
        let airs = self.airs.iter().map(|number| {
            let mut air = whole.airs[*number].clone();
            air.cell = self.cells.iter().position(|cell| *cell == air.cell).unwrap_or(0);
            air
        });
        let mut pairs = Vec::new();
        let touching = whole.touching.as_ref().map(|of_whole| {
            let sizes = [self.n_ports, order.len(), answers, n];
            let (mut own, numbers) = of_whole.among(&self.parts, |thing| self.thing(thing), sizes);
            own.choose(whole.ode_method(), n);
            pairs = numbers;
            own
        });
        let world = CarriedWorld {
            names: whole.names.clone(),
            places: Vec::new(),
            carriers: members,
            room: Room {
                pos: of_nodes(&whole.room.pos),
                vel: of_nodes(&whole.room.vel),
                elastic: vec![[0.0; 3]; order.len()],
                viscous: vec![[0.0; 3]; order.len()],
                frames: frames_of(&self.ports, &whole.room.frames),
                wrenches: vec![Wrench::zero(); self.n_ports],
            },
            airs: airs.collect(),
            touching,
            fixed: self.fixed.clone(),
            x: vec![0.0; n],
            low: vec![0.0; n],
            scratch: vec![0.0; whole.ode_method().scratch(n)],
            contacts: whole.contacts,
            method: whole.method,
            h: whole.h,
            starts: Vec::new(),
            t: whole.t,
            works: Works::empty(),
            unsettled: 0,
            rims: Vec::new(),
            forced: 0,
            books: None,
            stable: whole.stable,
        };
        (world, pairs)
    }
}

impl<S: Scalar> CarriedWorld<S> {
    /// First coordinate, speed and port of each carrier.
    pub(super) fn carrier_starts(&self) -> Vec<[usize; 3]> {
        let mut next = [0; 3];
        let starts = self.carriers.iter().map(|carrier| {
            let own = [carrier.n_q(), carrier.n_u(), carrier.n_ports()];
            let first = next;
            next.iter_mut().zip(own).for_each(|(next, own)| *next += own);
            first
        });
        starts.collect()
    }

    /// By node: the places of its position and velocity in the state, if it is free.
    fn node_places(&self) -> Vec<[usize; 2]> {
        let n_q = self.carriers.iter().map(Carrier::n_q).sum::<usize>();
        let mut next = [n_q, self.x.len() - 3 * self.free()];
        let places = self.fixed.held.iter().map(|held| {
            let own = next;
            next = next.map(|place| place + if *held { 0 } else { 3 });
            own
        });
        places.collect()
    }
}

/// Indices of the whole that have one here.
fn kept(new: &[usize]) -> Vec<usize> {
    (0..new.len()).filter(|old| new[*old] != NOWHERE).collect()
}

/// Frames of the ports that are part of the subset.
fn frames_of(new: &[usize], frames: &[Frame<f64>]) -> Vec<Frame<f64>> {
    new.iter().zip(frames).filter(|(new, _)| **new != NOWHERE).map(|(_, frame)| *frame).collect()
}
