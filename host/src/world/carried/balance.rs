//! Accounts of the parts and seams of a world of flexible parts, formed from its books.

use super::{CarriedWorld, Place, words};
use crate::world::accounts::{self, Accounts, Part, Passed, Seam};
use crate::world::books::Books;
use crate::world::carriers::HostCarrier;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::contact::Twist;
use smartbed_runtime::world::{Carrier, Forces, Wrench};

/// Kinetic energies of nodes and of carriers (J).
pub(super) type Motion = [Vec<f64>; 2];

impl<S: Scalar> CarriedWorld<S> {
    /// Opens the books.
    pub(super) fn open_books(&mut self) {
        let held = self.fixed.attachments.iter().map(|held| [held.node, held.port]);
        let free = self.fixed.mass.iter().zip(&self.fixed.held);
        let mass = free.map(|(mass, held)| if *held { 0.0 } else { mass.to_f64() }).collect();
        let pairs = self.touching.as_ref().map_or(0, |touching| touching.pairs.len());
        let counts = [pairs, self.room.frames.len(), self.carriers.len(), self.airs.len()];
        self.books = Some(Books::new(held, (mass, self.fixed.air_drag.to_f64()), counts));
    }

    /// Books the forces of the state evaluated last, which count for a duration (s).
    pub(super) fn book_forces(&mut self, duration: f64) {
        let (Some(books), room) = (&mut self.books, &self.room) else { return };
        let ports = room.frames.iter().map(|f| Twist { velocity: f.velocity, angular: f.angular_velocity });
        let nodes = room.vel.iter().map(|v| Twist { velocity: *v, angular: [S::ZERO; 3] });
        let twists: Vec<Twist<S>> = ports.chain(nodes).collect();
        books.forces(&Forces {
            duration: S::from_f64(duration),
            elastic: &room.elastic,
            viscous: &room.viscous,
            ends: [&twists; 2],
        });
    }

    /// Kinetic energies of nodes and carriers now.
    pub(super) fn motion(&mut self) -> Result<Motion, String> {
        let (t, x) = (S::from_f64(self.t), self.x.clone());
        self.with(|mut island| island.place(t, &x)).map_err(words)?;
        let nodes = self.fixed.mass.iter().zip(&self.room.vel);
        let nodes = nodes.map(|(m, v)| v.iter().map(|v| 0.5 * (*m * *v * *v).to_f64()).sum()).collect();
        let carriers = self.stored_by_carriers(t, &x).map_err(words)?;
        Ok([nodes, carriers.iter().map(|[kinetic, ..]| *kinetic).collect()])
    }

    /// Kinetic energy of each carrier, that of its weight, springs and gas (J).
    fn stored_by_carriers(&mut self, t: S, x: &[S]) -> Result<Vec<[f64; 4]>, Fault> {
        let (mut q, mut u, mut stored) = (0, self.split(), Vec::new());
        for carrier in &mut self.carriers {
            let (next_q, next_u) = (q + carrier.n_q(), u + carrier.n_u());
            let (own_q, own_u) = (&x[q..next_q], &x[u..next_u]);
            let [kinetic, gravity, spring] = if let HostCarrier::Mechanism(own) = carrier {
                let none = vec![Wrench::zero(); own.n_ports()];
                own.account(t, own_q, own_u, &none)?.stored
            } else {
                let (kinetic, gravity) = carrier.energy(t, own_q, own_u)?;
                [kinetic, gravity, S::ZERO]
            };
            stored.push([kinetic.to_f64(), gravity.to_f64(), spring.to_f64(), 0.0]);
            (q, u) = (next_q, next_u);
        }
        Ok(stored)
    }

    /// Energy that each pair stores in overlaps (J).
    pub(super) fn stored_by_pairs(&mut self, t: S, x: &[S]) -> Result<Vec<f64>, Fault> {
        let Some(touching) = self.touching.take() else { return Ok(Vec::new()) };
        let stored = self.with(|island| touching.stored(island, t, x));
        self.touching = Some(touching);
        stored
    }

    /// Accounts of all parts and seams now.
    pub(super) fn balance(&mut self) -> Result<Accounts, String> {
        let Some(books) = self.books.clone() else { return Err(accounts::not_kept()) };
        let (t, x) = (S::from_f64(self.t), self.x.clone());
        let stored = self.stored_by_carriers(t, &x).map_err(words)?;
        let overlaps = self.stored_by_pairs(t, &x).map_err(words)?;
        let owners = self.owners_of_ports();
        let mut numbers = vec![None; self.places.len()];
        let mut accounts = Accounts::default();
        for (part, place) in self.places.clone().iter().enumerate() {
            let mut own = Part { name: self.names[part].clone(), ..Part::default() };
            match place {
                Place::Carrier(number, _) if !matches!(self.carriers[*number], HostCarrier::Still(_)) => {
                    own.stored = stored[*number];
                    (own.damping, own.actuator) = (books.carrier_damped[*number], books.driven[*number]);
                }
                Place::Nodes(nodes, _, cell) => {
                    let springs = &self.fixed.springs;
                    let first = |node: usize| springs.partition_point(|spring| spring.tail < node);
                    let springs = first(nodes.start)..first(nodes.end);
                    let cells = cell.map_or(0..0, |cell| cell..cell + 1);
                    let of = self.with(|mut island| {
                        island.place(t, &x)?;
                        island.energy_of(nodes.clone(), springs, cells)
                    });
                    let of = of.map_err(words)?;
                    own.stored = [of.kinetic, of.gravity, of.spring, of.pressure].map(S::to_f64);
                    own.damping = books.damped[nodes.clone()].iter().sum();
                    own.drag = books.dragged[nodes.clone()].iter().sum();
                    own.impact = -books.restored[nodes.clone()].iter().sum::<f64>();
                    let airs = self.airs.iter().zip(&books.flows).filter(|(air, _)| air.part == part);
                    own.actuator = airs.map(|(_, flow)| flow).sum();
                }
                _ => continue,
            }
            numbers[part] = Some(accounts.parts.len());
            accounts.parts.push(own);
        }
        let mut book = |part: Option<usize>, work: f64| {
            if let Some(number) = part.and_then(|part| numbers[part]) {
                accounts.parts[number].seams += work;
            }
        };
        // Attachments of one part to one port form a seam.
        let mut seams: Vec<([usize; 2], Seam)> = Vec::new();
        for held in &books.held {
            let (Some(part), Some(owner)) = (self.part_of_node(held.node), owners[held.port]) else {
                continue;
            };
            book(Some(part), -held.work);
            book(Some(owner), held.work);
            let own = seams.iter().position(|(own, _)| *own == [part, held.port]).unwrap_or_else(|| {
                let parts = [part, owner].map(|part| self.names[part].clone());
                let name = format!("{}@{}", parts[0], self.name_of_port(held.port, owner));
                seams.push(([part, held.port], Seam { name, parts, ..Seam::default() }));
                seams.len() - 1
            });
            let to = &mut seams[own].1.passed.to;
            *to = [to[0] - held.work, to[1] + held.work];
        }
        let mut seams: Vec<Seam> = seams.into_iter().map(|(_, seam)| seam).collect();
        let parts = self.touching.as_ref().map_or(&[][..], |touching| &touching.parts);
        for ((parts, pair), spring) in parts.iter().zip(&books.pairs).zip(overlaps) {
            for (part, work) in parts.iter().zip(pair.to) {
                // What a shape on a port takes is its mechanism's.
                let owner =
                    if let Place::Shape(port, ..) = self.places[*part] { owners[port] } else { Some(*part) };
                book(owner, work);
            }
            let passed = Passed { spring, ..*pair };
            seams.push(Seam::of_pair(parts.map(|part| self.names[part].clone()), passed));
        }
        accounts.seams = seams;
        Ok(accounts)
    }

    /// By port: the part whose carrier has it.
    fn owners_of_ports(&self) -> Vec<Option<usize>> {
        let owner = |carrier: usize| {
            self.places.iter().position(|place| matches!(place, Place::Carrier(own, _) if *own == carrier))
        };
        let carriers = self.carriers.iter().enumerate();
        carriers.flat_map(|(number, carrier)| std::iter::repeat_n(owner(number), carrier.n_ports())).collect()
    }

    /// The flexible part of a node.
    fn part_of_node(&self, node: usize) -> Option<usize> {
        self.places.iter().position(|place| matches!(place, Place::Nodes(own, ..) if own.contains(&node)))
    }

    /// `tile.platform`, or the name of a rigid part.
    fn name_of_port(&self, port: usize, owner: usize) -> String {
        let name = &self.names[owner];
        let Place::Carrier(number, _) = self.places[owner] else { return name.clone() };
        let first: usize = self.carriers[..number].iter().map(Carrier::n_ports).sum();
        match &self.carriers[number] {
            HostCarrier::Mechanism(own) => format!("{name}.{}", own.ports()[port - first]),
            _ => name.clone(),
        }
    }
}
