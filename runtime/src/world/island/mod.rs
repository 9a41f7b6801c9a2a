//! Flexible bodies attached to carriers, as one ordinary differential equation.
//!
//! Several bodies form one list of nodes, springs and facets, with a [`Cell`] for each closed surface that holds gas;
//! several carriers form a [`Group`](super::Group). x = [q of the carrier, positions of the free nodes; u of the
//! carrier, their velocities]. Fixed nodes stay where they were placed; attached ones have no mass of their own: it
//! belongs to the carrier.

mod impulses;
mod loads;

use core::ops::Range;

use super::attachment::Attachment;
use super::carrier::{Carrier, Wrench};
use super::cell::{Cell, Holds};
use crate::flexible::Body;
use crate::flexible::element::Element;
use crate::flexible::energy::{Energies, eval_energies};
use crate::flexible::grid::Grid;
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::surface::Frame;
use crate::vec3::{self, Vec3};

/// Memory of an island, lent by the caller: one entry per node, and one per port.
#[derive(Debug)]
pub struct Memory<'a, S> {
    /// Positions; those of fixed nodes are read, the others are written.
    pub pos: &'a mut [Vec3<S>],
    /// Velocities.
    pub vel: &'a mut [Vec3<S>],
    /// Forces that depend on positions.
    pub elastic: &'a mut [Vec3<S>],
    /// Forces that depend on speeds.
    pub viscous: &'a mut [Vec3<S>],
    /// Frames of the ports.
    pub frames: &'a mut [Frame<S>],
    /// Wrenches at the ports.
    pub wrenches: &'a mut [Wrench<S>],
}

impl<'a, S> Memory<'a, S> {
    /// Memory of a world without flexible parts.
    #[must_use]
    pub fn without_nodes(frames: &'a mut [Frame<S>], wrenches: &'a mut [Wrench<S>]) -> Self {
        Memory { pos: &mut [], vel: &mut [], elastic: &mut [], viscous: &mut [], frames, wrenches }
    }
}

/// Energies of the carrier (kinetic, potential) and of the flexible bodies (J).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IslandEnergy<S> {
    /// Of the carrier: kinetic, potential.
    pub carrier: (S, S),
    /// Of the body.
    pub body: Energies<S>,
}

impl<S: Scalar> IslandEnergy<S> {
    /// Total energy.
    #[must_use]
    pub fn total(&self) -> S {
        self.carrier.0 + self.carrier.1 + self.body.total()
    }
}

/// Velocity (m/s) and acceleration (m/s^2) of a node.
pub(super) struct NodeRate<S> {
    pub(super) node: usize,
    pub(super) velocity: Vec3<S>,
    /// Force that depends on speeds (N).
    pub(super) viscous: Vec3<S>,
    pub(super) rate: Vec3<S>,
}

impl<S: Scalar> NodeRate<S> {
    /// Velocity after h.
    pub(super) fn after(&self, h: S) -> Vec3<S> {
        vec3::axpy(self.velocity, h, self.rate)
    }
}

/// A carrier and the flexible bodies on it.
#[derive(Debug)]
pub struct Island<'a, S, C> {
    /// The carrier.
    pub carrier: C,
    pub(super) body: Body<'a, S>,
    pub(super) attachments: &'a [Attachment<S>],
    pub(super) memory: Memory<'a, S>,
    pub(super) cells: &'a [Cell<S>],
    pub(super) restrained: &'a [[usize; 2]],
    /// Number of nodes that forces can move: neither fixed nor attached.
    free: usize,
}

/// Nodes of a body that forces can move: neither fixed nor attached.
pub(super) fn free_nodes<'b, S>(body: &Body<'b, S>) -> impl Iterator<Item = usize> + use<'b, S> {
    body.fixed.iter().enumerate().filter(|(_, fixed)| !**fixed).map(|(node, _)| node)
}

impl<'a, S: Scalar, C: Carrier<S>> Island<'a, S, C> {
    /// Joins carrier and body.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the memory does not have one entry per node, an attachment names a node or port that does
    /// not exist, or an attached node has a mass of its own or is not marked as fixed.
    pub fn new(
        carrier: C,
        body: Body<'a, S>,
        attachments: &'a [Attachment<S>],
        memory: Memory<'a, S>,
    ) -> Result<Self, Fault> {
        let n = body.points();
        let rows = [&memory.pos, &memory.vel, &memory.elastic, &memory.viscous];
        let fits = rows.iter().all(|rows| rows.len() == n) && memory.frames.len() == memory.wrenches.len();
        let is_held = |a: &Attachment<S>| {
            body.fixed.get(a.node) == Some(&true) && body.mass.get(a.node) == Some(&S::ZERO)
        };
        let known = attachments.iter().all(|a| a.port < memory.frames.len() && is_held(a));
        let fits = fits && memory.frames.len() == carrier.n_ports();
        let free = free_nodes(&body).count();
        let island = Island { carrier, body, attachments, memory, cells: &[], restrained: &[], free };
        if fits && known { Ok(island) } else { Err(Fault::Shape) }
    }

    /// Adds gas in closed parts of the facets.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a cell names facets that do not exist, or facets of a grid that a gas of the body fills
    /// already, or if its wall names what does not exist.
    pub fn with_cells(mut self, cells: &'a [Cell<S>]) -> Result<Self, Fault> {
        self.cells = cells;
        let known = cells.iter().all(|cell| cell.fits(&self.body, self.holds()));
        let held = |grid: &Grid<S>| cells.iter().any(|cell| cell.holds(grid));
        let twice = self.body.inflation.is_some() && self.body.grids.iter().any(held);
        if known && !twice { Ok(self) } else { Err(Fault::Shape) }
    }

    /// Names the bodies that space or a commanded port holds: the first node of each and the one after the last.
    /// Nothing keeps their angular momentum, so that steps of order 2 may give them frequencies of order 4.
    ///
    /// # Errors
    /// [`Fault::Shape`] if one ends before it begins or beyond the last node.
    pub fn with_restrained(self, restrained: &'a [[usize; 2]]) -> Result<Self, Fault> {
        let known = restrained.iter().all(|[first, end]| first <= end && *end <= self.body.points());
        if known { Ok(Island { restrained, ..self }) } else { Err(Fault::Shape) }
    }

    /// The flexible body, all parts of it.
    #[must_use]
    pub fn body(&self) -> &Body<'a, S> {
        &self.body
    }

    /// The gas of each closed surface.
    #[must_use]
    pub fn cells(&self) -> &'a [Cell<S>] {
        self.cells
    }

    /// What holds the nodes, as placed last.
    fn holds(&self) -> Holds<'_, S> {
        Holds { attachments: self.attachments, frames: self.memory.frames }
    }

    /// Volumes of the gas at the state placed last (m^3), cell by cell.
    pub fn volumes(&self) -> impl Iterator<Item = S> {
        let (grids, frames) = (self.body.grids, &*self.memory.frames);
        self.cells.iter().map(move |cell| cell.volume_held(&self.body, grids, frames, self.memory.pos))
    }

    /// Positions and velocities of all nodes at the state placed last.
    #[must_use]
    pub fn nodes(&self) -> (&[Vec3<S>], &[Vec3<S>]) {
        (self.memory.pos, self.memory.vel)
    }

    /// Frames of the ports and the wrenches of the body on them, at the state evaluated last.
    #[must_use]
    pub fn seams(&self) -> (&[Frame<S>], &[Wrench<S>]) {
        (self.memory.frames, self.memory.wrenches)
    }

    /// Power that the body's wrenches deliver to the carrier at all ports, at the state evaluated last (W).
    #[must_use]
    pub fn seam_power(&self) -> S {
        let seams = self.memory.frames.iter().zip(self.memory.wrenches.iter());
        seams.fold(S::ZERO, |sum, (frame, wrench)| sum + wrench.power(frame))
    }

    /// Writes a state into x = [q, u]: q and u of the carrier, and the positions and velocities of free nodes in
    /// memory.
    ///
    /// # Errors
    /// [`Fault::Shape`] if x has another length.
    pub fn load(&self, q: &[S], u: &[S], x: &mut [S]) -> Result<(), Fault> {
        let parts = self.parts_mut(x)?;
        parts.q.iter_mut().zip(q).for_each(|(to, from)| *to = *from);
        parts.u.iter_mut().zip(u).for_each(|(to, from)| *to = *from);
        let rows = parts.pos.chunks_exact_mut(3).zip(parts.vel.chunks_exact_mut(3));
        for (node, (x, v)) in free_nodes(&self.body).zip(rows) {
            write(x, vec3::at(self.memory.pos, node));
            write(v, vec3::at(self.memory.vel, node));
        }
        Ok(())
    }

    /// Computes the positions and velocities of all nodes, and the frames, of a state.
    ///
    /// # Errors
    /// [`Fault::Shape`] if x has another length; the carrier's faults.
    pub fn place(&mut self, t: S, x: &[S]) -> Result<(), Fault> {
        let Cut { q, u, .. } = self.parts(x)?;
        self.carrier.frames(t, q, u, self.memory.frames)?;
        self.place_nodes(x)?;
        self.place_attached();
        Ok(())
    }

    /// Rates under the forces and wrenches in memory; returns the worst pivot.
    pub(super) fn accelerate(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        let pivot = self.carrier_rates(t, x, x_dot)?;
        let vel = self.parts(x)?.vel;
        self.parts_mut(x_dot)?.pos.iter_mut().zip(vel).for_each(|(to, from)| *to = *from);
        self.accelerate_nodes(x_dot, |_| ())?;
        Ok(pivot)
    }

    /// Rates of the velocities of free nodes under the forces in memory, each shown to a function.
    pub(super) fn accelerate_nodes(
        &self,
        x_dot: &mut [S],
        mut show: impl FnMut(&NodeRate<S>),
    ) -> Result<(), Fault> {
        let rates = self.parts_mut(x_dot)?.vel.as_chunks_mut().0;
        for (node, rate) in self.node_rates().zip(rates) {
            *rate = node.rate;
            show(&node);
        }
        Ok(())
    }

    /// Velocity at the state placed last and acceleration under the forces in memory of each free node.
    pub(super) fn node_rates(&self) -> impl Iterator<Item = NodeRate<S>> {
        let own = &self.memory;
        let forces = own.elastic.iter().zip(own.viscous.iter());
        let nodes = free_of(own.vel.iter().zip(forces).enumerate(), &self.body);
        nodes.map(|(node, (velocity, (elastic, viscous)))| {
            let rate = rate(&self.body, node, [*elastic, *viscous]);
            NodeRate { node, velocity: *velocity, viscous: *viscous, rate }
        })
    }

    /// The same of one node, which is free.
    pub(super) fn node_rate(&self, node: usize) -> NodeRate<S> {
        let [velocity, elastic, viscous] = [&*self.memory.vel, &*self.memory.elastic, &*self.memory.viscous]
            .map(|list| vec3::at(list, node));
        NodeRate { node, velocity, viscous, rate: rate(&self.body, node, [elastic, viscous]) }
    }

    /// Rates of the carrier alone, under the wrenches in memory.
    pub(super) fn carrier_rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        let Cut { q, u, .. } = self.parts(x)?;
        let dot = self.parts_mut(x_dot)?;
        self.carrier.rates(t, q, u, self.memory.wrenches, dot.q, dot.u)
    }

    /// Energies of a state.
    ///
    /// # Errors
    /// As [`Island::place`].
    pub fn energy(&mut self, t: S, x: &[S]) -> Result<IslandEnergy<S>, Fault> {
        self.place(t, x)?;
        let Cut { q, u, .. } = self.parts(x)?;
        let carrier = self.carrier.energy(t, q, u)?;
        let mut body = eval_energies(&self.body, self.memory.pos, self.memory.vel);
        for cell in self.cells {
            body.pressure = body.pressure + cell.potential(self.body.facets, self.memory.pos)?;
        }
        Ok(IslandEnergy { carrier, body })
    }

    /// Energies of some of the nodes, springs and cells at the positions placed last: those of one body among several.
    ///
    /// # Errors
    /// [`Fault::Shape`] for ranges beyond the lists; [`Fault::NonFinite`] for a gas whose volume has vanished.
    pub fn energy_of(
        &self,
        nodes: Range<usize>,
        springs: Range<usize>,
        cells: Range<usize>,
    ) -> Result<Energies<S>, Fault> {
        let (half, pos) = (S::from_f64(0.5), &*self.memory.pos);
        let zero = S::ZERO;
        let mut sum = Energies { kinetic: zero, gravity: zero, spring: zero, pressure: zero };
        for node in nodes {
            let mass = *self.body.mass.get(node).ok_or(Fault::Shape)?;
            let v = vec3::at(self.memory.vel, node);
            sum.kinetic = sum.kinetic + half * mass * vec3::dot(v, v);
            sum.gravity = sum.gravity - mass * vec3::dot(self.body.gravity, vec3::at(pos, node));
        }
        sum.spring = self.body.springs.get(springs).ok_or(Fault::Shape)?.energy(pos);
        for cell in self.cells.get(cells).ok_or(Fault::Shape)? {
            sum.pressure = sum.pressure + cell.potential(self.body.facets, pos)?;
        }
        Ok(sum)
    }

    /// Cuts a state into its parts.
    pub(super) fn parts<'x>(&self, x: &'x [S]) -> Result<Cut<&'x [S]>, Fault> {
        if x.len() != self.n_x() {
            return Err(Fault::Shape);
        }
        let (coordinates, speeds) = x.split_at_checked(self.n_q()).ok_or(Fault::Shape)?;
        let (q, pos) = coordinates.split_at_checked(self.carrier.n_q()).ok_or(Fault::Shape)?;
        let (u, vel) = speeds.split_at_checked(self.carrier.n_u()).ok_or(Fault::Shape)?;
        Ok(Cut { q, pos, u, vel })
    }

    pub(super) fn parts_mut<'x>(&self, x: &'x mut [S]) -> Result<Cut<&'x mut [S]>, Fault> {
        if x.len() != self.n_x() {
            return Err(Fault::Shape);
        }
        let (coordinates, speeds) = x.split_at_mut_checked(self.n_q()).ok_or(Fault::Shape)?;
        let (q, pos) = coordinates.split_at_mut_checked(self.carrier.n_q()).ok_or(Fault::Shape)?;
        let (u, vel) = speeds.split_at_mut_checked(self.carrier.n_u()).ok_or(Fault::Shape)?;
        Ok(Cut { q, pos, u, vel })
    }
}

/// Acceleration of a node (m/s^2) under these forces (N), by the list of 1/m if there is one.
#[inline(always)]
fn rate<S: Scalar>(body: &Body<S>, node: usize, [elastic, viscous]: [Vec3<S>; 2]) -> Vec3<S> {
    let listed = body.inverse_mass.get(node).map(|[inverse_mass, ..]| *inverse_mass);
    vec3::scale(vec3::add(elastic, viscous), listed.unwrap_or_else(|| body.inverse_mass(node)))
}

/// Of a list with one entry per node, those of free nodes.
fn free_of<T, S>(list: impl Iterator<Item = T>, body: &Body<S>) -> impl Iterator<Item = T> {
    list.zip(body.fixed).filter(|(_, fixed)| !**fixed).map(|(entry, _)| entry)
}

fn write<S: Scalar>(to: &mut [S], from: Vec3<S>) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = from);
}

/// A state or its rates, cut into parts.
pub(super) struct Cut<T> {
    /// Coordinates of the carrier.
    pub(super) q: T,
    /// Positions of the free nodes.
    pub(super) pos: T,
    /// Speeds of the carrier.
    pub(super) u: T,
    /// Velocities of the free nodes.
    pub(super) vel: T,
}

impl<S: Scalar, C: Carrier<S>> Ode<S> for Island<'_, S, C> {
    fn n_x(&self) -> usize {
        self.carrier.n_q() + self.carrier.n_u() + 6 * self.free
    }

    fn n_q(&self) -> usize {
        self.carrier.n_q() + 3 * self.free
    }

    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        self.place(t, x)?;
        self.load_seams()?;
        self.accelerate(t, x, x_dot)
    }

    fn coordinate_rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        // Wrenches change speeds only, so those in memory may be stale.
        let pivot = self.carrier_rates(t, x, x_dot)?;
        let vel = self.parts(x)?.vel;
        self.parts_mut(x_dot)?.pos.iter_mut().zip(vel).for_each(|(to, from)| *to = *from);
        Ok(pivot)
    }

    fn is_damped(&self) -> bool {
        self.body.is_damped() || self.carrier.is_damped()
    }

    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let Cut { q, u, .. } = self.parts_mut(x)?;
        let residual = self.carrier.project(q)?;
        self.carrier.project_speeds(q, u)?;
        Ok(residual)
    }

    fn set_time(&mut self, t: S) {
        self.carrier.set_time(t);
    }

    fn projections(&self) -> u8 {
        self.carrier.projections()
    }
}
