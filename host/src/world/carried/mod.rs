//! Worlds of flexible parts on mechanisms, rigid bodies and fixed frames, as one system of equations.
//!
//! In: an assembly (`build`). Out: an [`Engine`](super::engine::Engine) over the runtime's [`Island`], which borrows
//! the lists stored here: all flexible parts as one body, all carriers as one group. If there are contacts, the
//! runtime's `World` steps it and keeps the accounts; otherwise works (drives, damping) are integrals of powers by
//! Simpson's rule over each step.

mod air;
pub mod apart;
mod balance;
mod between;
mod breathing;
mod build;
mod choice;
mod crossing;
mod islands;
mod jumps;
pub mod methods;
mod overlap;
mod reach;
mod rest;
pub mod rounded;
mod rows;
mod selection;
mod stable;
mod stepping;
mod stiff;
mod subset;
pub mod tables;
mod walls;

use super::books::Books;
use super::carriers::HostCarrier;
use super::engine::Event;
use super::ported::Ported;
use super::touching::{How, Stepped, Touching};
use crate::scene::grid::Woven;
use methods::{Contacts, Stepping};
use smartbed_runtime::flexible::grid::Grid;
use smartbed_runtime::flexible::{Body, Massless, Spring};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Method, Ode, State};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::{Frame, Shape};
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{Accounts as Works, Attachment, Carrier, Cell, Group, Island, Memory, Wrench};
use std::ops::Range;

/// What never changes.
#[derive(Clone, Debug)]
struct Fixed<S = f64> {
    mass: Vec<S>,
    /// See [`Fixed::weigh`].
    inverse_mass: Vec<Vec3<S>>,
    held: Vec<bool>,
    springs: Vec<Spring<S>>,
    facets: Vec<[usize; 4]>,
    grids: Vec<Woven<S>>,
    cells: Vec<Cell<S>>,
    attachments: Vec<Attachment<S>>,
    /// Nodes of each part that space or a commanded port holds.
    restrained: Vec<[usize; 2]>,
    gravity: Vec3<S>,
    air_drag: S,
}

/// Working memory that an island borrows.
#[derive(Clone, Debug, Default)]
struct Room<S = f64> {
    pos: Vec<Vec3<S>>,
    vel: Vec<Vec3<S>>,
    elastic: Vec<Vec3<S>>,
    viscous: Vec<Vec3<S>>,
    frames: Vec<Frame<S>>,
    wrenches: Vec<Wrench<S>>,
}

/// Where a part of the assembly is found in the lists.
#[derive(Clone, Debug)]
enum Place<S = f64> {
    /// Number of its carrier.
    Carrier(usize, Option<Shape<S>>),
    /// A shape on a port, its place there.
    Shape(usize, Frame<S>, Shape<S>),
    /// Nodes, facets, and its gas.
    Nodes(Range<usize>, Range<usize>, Option<usize>),
}

/// A world of flexible parts on carriers.
#[derive(Clone, Debug)]
pub struct CarriedWorld<S: Scalar = f64> {
    names: Vec<String>,
    places: Vec<Place<S>>,
    carriers: Vec<HostCarrier<S>>,
    fixed: Fixed<S>,
    room: Room<S>,
    x: Vec<S>,
    low: Vec<S>,
    scratch: Vec<S>,
    contacts: Contacts,
    method: (&'static str, Stepping),
    h: f64,
    /// Commanded frames at the start, with their motion.
    starts: Vec<Frame<S>>,
    t: f64,
    /// Work since the start; that of the drives with inputs and flow of gas.
    works: Works<f64>,
    airs: Vec<air::Air<S>>,
    touching: Option<Touching<S>>,
    /// Warnings of nodes over rims of boxes at the start.
    rims: Vec<String>,
    unsettled: usize,
    forced: usize,
    /// Kept if they are asked for.
    books: Option<Books>,
    /// Stability limit of the step (s): the largest that resolves the fastest motion of the flexible parts and
    /// of what holds their nodes.
    stable: Option<f64>,
}

fn words(fault: Fault) -> String {
    match fault {
        Fault::Unsettled => format!(
            "{}; take a smaller step, or in contact, where that may not help, method = \"moreau\" or laws of contact that \
             locate touches",
            fault.reason()
        ),
        _ => format!("{}; take a smaller step or a smaller load", fault.reason()),
    }
}

impl<S: Scalar> CarriedWorld<S> {
    /// The state: coordinates of the carriers, places of the free nodes; speeds of the carriers, velocities of the
    /// nodes.
    #[must_use]
    pub fn numbers(&self) -> &[S] {
        &self.x
    }

    /// A step of a world with contacts; pairs that come into contact are events. `at_rest` is true in a relaxation.
    fn step_touching(
        &mut self,
        h: f64,
        (x, low): (&mut [S], &mut [S]),
        at_rest: bool,
        found: &mut Vec<Event>,
    ) -> Result<Stepped<S>, Fault> {
        let t = self.t;
        let old = self.of_carriers(x).map(<[S]>::to_vec);
        let real = S::from_f64;
        let how = match self.method.1 {
            _ if at_rest => How::Relaxing,
            Stepping::Conserving => How::Conserving,
            _ => How::Freely,
        };
        let mut touching = self.touching.take().ok_or(Fault::Shape)?;
        let mut books = self.books.take();
        let done = self.with(|island| {
            let mut state = State::resume(x, low)?;
            touching.step(island, (real(t), real(h)), &mut state, how, (found, books.as_mut()))
        });
        (self.touching, self.books) = (Some(touching), books);
        let mut report = done?;
        self.unsettled += usize::from(!report.settled);
        self.forced += usize::from(report.forced);
        // Located steps count all powers of mechanisms, piece by piece; the others only those of the wrenches: add the
        // rest at the state in the middle.
        if how == How::Freely && self.touching.as_ref().is_some_and(Touching::locates) {
            return Ok(report);
        }
        let mut middle = old;
        for (old, new) in middle.iter_mut().zip(self.of_carriers(x)) {
            old.iter_mut().zip(new).for_each(|(old, new)| *old = real(0.5) * (*old + *new));
        }
        let (accounts, mut books) = (&mut report.accounts, self.books.take());
        // Simpson's rule for a mechanism that time alone moves.
        let done =
            self.each_mechanism(middle.each_ref().map(Vec::as_slice), |number, ported, q, u, wrenches| {
                let none = vec![Wrench::zero(); wrenches.len()];
                let ends: &[(f64, f64)] =
                    if u.is_empty() { &[(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] } else { &[(0.5, 6.0)] };
                for (part, weight) in ends {
                    let account = ported.account(real(t + part * h), q, u, &none)?;
                    accounts.drive = accounts.drive + real(weight / 6.0 * h) * account.driven;
                    accounts.damping = accounts.damping + real(weight / 6.0 * h) * account.damped;
                    if let Some(books) = &mut books {
                        books.driven[number] += weight / 6.0 * h * account.driven.to_f64();
                        books.carrier_damped[number] += weight / 6.0 * h * account.damped.to_f64();
                    }
                }
                Ok(())
            });
        self.books = books;
        done.map(|()| report)
    }

    /// The method between touches; for kinds of steps without one, that of a relaxation.
    fn ode_method(&self) -> Method {
        if let Stepping::Ode(method) = self.method.1 { method } else { methods::RELAXED }
    }

    /// Is it stepped by the runtime's `World`, because of contacts or because its forces are averaged over the step?
    fn steps_as_world(&self) -> bool {
        self.contacts != Contacts::None || self.method.1 == Stepping::Conserving
    }

    /// Calls a function with the island that the lists form.
    pub(crate) fn with<T>(
        &mut self,
        act: impl FnOnce(Island<'_, S, Group<'_, HostCarrier<S>>>) -> Result<T, Fault>,
    ) -> Result<T, Fault> {
        let (fixed, room) = (&self.fixed, &mut self.room);
        let memory = Memory {
            pos: &mut room.pos,
            vel: &mut room.vel,
            elastic: &mut room.elastic,
            viscous: &mut room.viscous,
            frames: &mut room.frames,
            wrenches: &mut room.wrenches,
        };
        let group = Group { members: &mut self.carriers };
        let grids: Vec<Grid<'_, S>> = fixed.grids.iter().map(Woven::view).collect();
        let island = Island::new(group, fixed.body(&grids), &fixed.attachments, memory)?;
        act(island.with_cells(&fixed.cells)?.with_restrained(&fixed.restrained)?)
    }

    /// Rates of a state; forces and wrenches of it are in memory then.
    pub(crate) fn rates(&mut self, t: f64, x: &[S]) -> Result<Vec<S>, Fault> {
        let mut dot = vec![S::ZERO; x.len()];
        self.with(|mut island| island.rates(S::from_f64(t), x, &mut dot))?;
        Ok(dot)
    }

    /// Powers at the state whose rates were asked for last; the books count them for a duration (s).
    fn powers(&mut self, t: f64, x: &[S], duration: f64) -> Result<Works<f64>, Fault> {
        self.book_forces(duration);
        let (mut powers, mut books) = (Works::empty(), self.books.take());
        let forces = self.room.viscous.iter().zip(&self.room.vel);
        let viscous: f64 = forces.map(|(force, velocity)| vec3::dot(*force, *velocity).to_f64()).sum();
        let squares: f64 = self.room.vel.iter().map(|v| vec3::dot(*v, *v).to_f64()).sum();
        powers.drag = self.fixed.air_drag.to_f64() * squares;
        powers.damping = -viscous - powers.drag;
        let done = self.each_mechanism(self.of_carriers(x), |number, ported, q, u, wrenches| {
            let account = ported.account(S::from_f64(t), q, u, wrenches)?;
            powers.drive += account.driven.to_f64();
            powers.damping += account.damped.to_f64();
            if let Some(books) = &mut books {
                books.driven[number] += duration * account.driven.to_f64();
                books.carrier_damped[number] += duration * account.damped.to_f64();
            }
            Ok(())
        });
        self.books = books;
        done.map(|()| powers)
    }

    /// The coordinates and the speeds of the carriers in a state.
    fn of_carriers<'x>(&self, x: &'x [S]) -> [&'x [S]; 2] {
        let count = |size: fn(&HostCarrier<S>) -> usize| self.carriers.iter().map(size).sum::<usize>();
        let (n_q, n_u, split) = (count(Carrier::n_q), count(Carrier::n_u), self.split());
        [&x[..n_q], &x[split..split + n_u]]
    }

    /// Calls a function for each mechanism with its number among the carriers, its own of all their coordinates and
    /// speeds, and the wrenches at its ports.
    fn each_mechanism(
        &mut self,
        [all_q, all_u]: [&[S]; 2],
        mut show: impl FnMut(usize, &mut Ported<S>, &[S], &[S], &[Wrench<S>]) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let (mut q, mut u, mut port) = (0, 0, 0);
        for (number, carrier) in self.carriers.iter_mut().enumerate() {
            let (next_q, next_u, next) = (q + carrier.n_q(), u + carrier.n_u(), port + carrier.n_ports());
            if let HostCarrier::Mechanism(ported) = carrier {
                show(number, ported, &all_q[q..next_q], &all_u[u..next_u], &self.room.wrenches[port..next])?;
            }
            (q, u, port) = (next_q, next_u, next);
        }
        Ok(())
    }

    /// Finds the forces of located contacts at the present state, for rows and pictures.
    fn press(&mut self) {
        // Forces at the end of a step are those before the kinks of commands behind it; if that fails, so does the next
        // step.
        let _ = self.next_kink(self.t, self.h);
        let Some(mut touching) = self.touching.take() else { return };
        let [t, h] = [self.t, self.h].map(S::from_f64);
        let (mut x, mut low) = (self.x.clone(), self.low.clone());
        // Where there are none, the next step says why.
        let _ = self.with(|island| touching.press(island, (t, h), &State::resume(&mut x, &mut low)?));
        self.touching = Some(touching);
    }

    /// Forces between parts, pair by pair.
    fn pushed(&self) -> &[f64] {
        self.touching.as_ref().map_or(&[], |touching| touching.pushed.values())
    }

    /// Index in the state at which speeds begin.
    fn split(&self) -> usize {
        self.carriers.iter().map(Carrier::n_q).sum::<usize>() + 3 * self.free()
    }

    /// By port and by node: is it fixed in space, or does it follow commands?
    fn immovable(&self) -> [Vec<bool>; 2] {
        let still = self.carriers.iter().flat_map(|own| std::iter::repeat_n(own.n_u() == 0, own.n_ports()));
        let (still, mut held): (Vec<bool>, _) = (still.collect(), self.fixed.held.clone());
        for attachment in &self.fixed.attachments {
            held[attachment.node] = still[attachment.port];
        }
        [still, held]
    }

    /// Finds the parts that space or a commanded port holds.
    fn find_restrained(&mut self) {
        let [_, held] = self.immovable();
        let parts = self.places.iter().filter_map(|place| match place {
            Place::Nodes(nodes, ..) if held[nodes.clone()].contains(&true) => Some([nodes.start, nodes.end]),
            _ => None,
        });
        self.fixed.restrained = parts.collect();
    }

    fn free(&self) -> usize {
        self.fixed.held.iter().filter(|held| !**held).count()
    }
}

impl<S: Scalar> Fixed<S> {
    /// Nothing, under a gravity (m/s^2) and in an air (N s/m).
    fn empty(gravity: Vec3<S>, air_drag: S) -> Self {
        Fixed {
            mass: Vec::new(),
            inverse_mass: Vec::new(),
            held: Vec::new(),
            springs: Vec::new(),
            facets: Vec::new(),
            grids: Vec::new(),
            cells: Vec::new(),
            attachments: Vec::new(),
            restrained: Vec::new(),
            gravity,
            air_drag,
        }
    }

    /// Computes 1/m (1/kg) of each node, which a step needs several times, once the masses are known.
    fn weigh(&mut self) {
        self.inverse_mass = Vec::new();
        let body = self.body(&[]);
        self.inverse_mass = (0..self.mass.len()).map(|node| [body.inverse_mass(node); 3]).collect();
    }

    fn body<'f>(&'f self, grids: &'f [Grid<'f, S>]) -> Body<'f, S> {
        Body {
            mass: &self.mass,
            fixed: &self.held,
            inverse_mass: &self.inverse_mass,
            springs: &self.springs,
            gravity: self.gravity,
            air_drag: self.air_drag,
            facets: &self.facets,
            inflation: None,
            massless: Massless::default(),
            grids,
            patches: None,
        }
    }
}
