//! Worlds of flexible parts on mechanisms, rigid bodies and fixed frames, as one set of equations.
//!
//! In: an assembly. Out: an [`Engine`] over the runtime's [`Island`], which borrows the lists kept here: all flexible
//! parts as one body, all carriers as one group. Where something can touch, the runtime's `World` steps it and keeps the
//! accounts; elsewhere works (drives, damping) are integrals of powers by Simpson's rule over each step.

use super::assembly::{Assembly, Kind, Rigid};
use super::carriers::HostCarrier;
use super::engine::{Column, Energies, Engine, Event, Settled};
use super::picture::Picture;
use super::ported::Ported;
use super::settle::{Relaxing, relax};
use super::touching::{Touchable, Touching};
use crate::scene::{Lists, Simulation, Surroundings};
use smartbed_runtime::flexible::{Body, Massless, PressureForm, Spring};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Method, Ode, State};
use smartbed_runtime::surface::{Frame, Shape};
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{
    Accounts, Attachment, Carrier, Cell, Floating, Group, Inertias, Island, Memory, World, Wrench,
};
use std::ops::Range;

/// Methods by name.
const METHODS: [(&str, Method); 3] =
    [("euler", Method::ExplicitEuler), ("semi-implicit", Method::SemiImplicitEuler), ("rk4", Method::Rk4)];

/// What never changes.
#[derive(Clone, Debug, Default)]
struct Fixed {
    mass: Vec<f64>,
    held: Vec<bool>,
    springs: Vec<Spring<f64>>,
    facets: Vec<[usize; 4]>,
    cells: Vec<Cell<f64>>,
    attachments: Vec<Attachment<f64>>,
    gravity: Vec3<f64>,
    air_drag: f64,
}

/// Memory that an island borrows.
#[derive(Clone, Debug, Default)]
struct Room {
    pos: Vec<Vec3<f64>>,
    vel: Vec<Vec3<f64>>,
    elastic: Vec<Vec3<f64>>,
    viscous: Vec<Vec3<f64>>,
    frames: Vec<Frame<f64>>,
    wrenches: Vec<Wrench<f64>>,
}

/// A part of the assembly within the lists.
#[derive(Clone, Debug)]
enum Place {
    /// Number of its carrier.
    Carrier(usize, Option<Shape<f64>>),
    /// A shape on a port, its place there.
    Shape(usize, Frame<f64>, Shape<f64>),
    /// Nodes, facets, and its gas.
    Nodes(Range<usize>, Range<usize>, Option<usize>),
}

/// Powers (W) at a state.
#[derive(Clone, Copy, Default, Debug)]
struct Powers {
    driven: f64,
    damped: f64,
}

/// Flexible parts on carriers.
#[derive(Clone, Debug)]
pub struct CarriedWorld {
    names: Vec<String>,
    places: Vec<Place>,
    carriers: Vec<HostCarrier>,
    fixed: Fixed,
    room: Room,
    x: Vec<f64>,
    low: Vec<f64>,
    scratch: Vec<f64>,
    method: (&'static str, Method),
    h: f64,
    /// Commanded frames at the start, with their motion.
    starts: Vec<Frame<f64>>,
    t: f64,
    drive: f64,
    damping: f64,
    impact: f64,
    friction: f64,
    touching: Option<Touching>,
    unsettled: usize,
}

fn words(fault: Fault) -> String {
    format!("{}; take a smaller step, or look at the load", fault.reason())
}

impl CarriedWorld {
    /// At its start.
    ///
    /// # Errors
    /// What cannot be derived, assembled or stepped, in words.
    pub fn new(assembly: &Assembly) -> Result<Self, String> {
        let name = assembly.run.method.as_deref().unwrap_or("rk4");
        let method = METHODS.iter().find(|(known, _)| *known == name).copied();
        let method = method.ok_or_else(|| {
            let known = METHODS.map(|(known, _)| known);
            format!("run.method = \"{name}\": no method of worlds{}", crate::suggest::help(name, known))
        })?;
        let mut world = CarriedWorld {
            names: assembly.parts.iter().map(|part| part.name.clone()).collect(),
            places: Vec::new(),
            carriers: Vec::new(),
            fixed: Fixed { gravity: assembly.gravity, ..Fixed::default() },
            room: Room::default(),
            x: Vec::new(),
            low: Vec::new(),
            scratch: Vec::new(),
            method,
            h: assembly.run.step,
            starts: Vec::new(),
            t: 0.0,
            drive: 0.0,
            damping: 0.0,
            impact: 0.0,
            friction: 0.0,
            touching: None,
            unsettled: 0,
        };
        let starts = world.carriers(assembly)?;
        world.flexible(assembly)?;
        world.join(assembly, &starts)?;
        check_step(assembly, &world.fixed)?;
        world.touch(assembly)?;
        Ok(world)
    }

    /// Carriers in the order of the parts; their starts.
    fn carriers(&mut self, assembly: &Assembly) -> Result<[Vec<f64>; 2], String> {
        let [mut q, mut u] = [Vec::new(), Vec::new()];
        for (number, part) in assembly.parts.iter().enumerate() {
            let carrier = match &part.kind {
                Kind::Mechanism(mechanism) => {
                    let ports = ports(assembly, number);
                    let (ported, start) =
                        Ported::new(mechanism, &ports).map_err(|why| format!("`{}`: {why}", part.name))?;
                    q.extend(start.q);
                    u.extend(start.u);
                    HostCarrier::Mechanism(Box::new(ported))
                }
                Kind::Rigid(rigid) if rigid.on.is_some() => {
                    // Its port has a number when all carriers are there.
                    self.places.push(Place::Shape(usize::MAX, standing(rigid), rigid.shape));
                    continue;
                }
                Kind::Rigid(rigid) => match rigid.body {
                    Some(body) => {
                        q.extend(rigid.start.position);
                        q.extend(rigid.start.attitude.parameters());
                        u.extend(rigid.start.velocity);
                        u.extend(rigid.start.angular_momentum);
                        HostCarrier::Floating(Floating { body, gravity: assembly.gravity })
                    }
                    None => HostCarrier::Still(standing(rigid)),
                },
                Kind::Flexible(_) => {
                    self.places.push(Place::Nodes(0..0, 0..0, None));
                    continue;
                }
            };
            let shape = if let Kind::Rigid(rigid) = &part.kind { Some(rigid.shape) } else { None };
            self.places.push(Place::Carrier(self.carriers.len(), shape));
            self.carriers.push(carrier);
        }
        for (number, part) in assembly.parts.iter().enumerate() {
            let Kind::Rigid(Rigid { on: Some((mechanism, name)), .. }) = &part.kind else { continue };
            let port = self.port(assembly, *mechanism, Some(name));
            if let Place::Shape(own, ..) = &mut self.places[number] {
                *own = port;
            }
        }
        let n: usize = self.carriers.iter().map(Carrier::n_ports).sum();
        self.room.frames = vec![Frame::inertial(); n];
        self.room.wrenches = vec![Wrench::zero(); n];
        Ok([q, u])
    }

    /// All flexible parts as one body.
    fn flexible(&mut self, assembly: &Assembly) -> Result<(), String> {
        let mut drag = None;
        for (part, place) in assembly.parts.iter().zip(&mut self.places) {
            let Kind::Flexible(body) = &part.kind else { continue };
            if drag.is_some_and(|drag| drag != body.air_drag) {
                return Err(format!("`{}`: flexible parts of one scene have one air_drag", part.name));
            }
            drag = Some(body.air_drag);
            let (first, first_facet, fixed) =
                (self.fixed.mass.len(), self.fixed.facets.len(), &mut self.fixed);
            let lists = &body.lists;
            fixed.mass.extend(&lists.masses);
            fixed.held.extend(&lists.fixed);
            fixed.springs.extend(springs(lists, first));
            fixed.facets.extend(lists.facets.iter().map(|corners| corners.map(|node| node + first)));
            let cell = body.gas.map(|content| {
                let facets = [first_facet, fixed.facets.len()];
                fixed.cells.push(Cell { facets, content, form: PressureForm::Exact });
                fixed.cells.len() - 1
            });
            self.room.pos.extend(&lists.points);
            self.room.vel.extend(&lists.velocities);
            *place = Place::Nodes(first..fixed.mass.len(), first_facet..fixed.facets.len(), cell);
        }
        self.fixed.air_drag = drag.unwrap_or(0.0);
        let n = self.room.pos.len();
        [self.room.elastic, self.room.viscous] = [vec![[0.0; 3]; n], vec![[0.0; 3]; n]];
        Ok(())
    }

    /// Puts attached parts into the frames that hold them, and writes the first state.
    fn join(&mut self, assembly: &Assembly, [q, u]: &[Vec<f64>; 2]) -> Result<(), String> {
        let mut frames = std::mem::take(&mut self.room.frames);
        Group { members: &mut self.carriers }.frames(0.0, q, u, &mut frames).map_err(words)?;
        self.room.frames = frames;
        self.starts = self.commanded();
        let mut placed = vec![false; assembly.parts.len()];
        for attachment in &assembly.attachments {
            let Place::Nodes(nodes, ..) = self.places[attachment.part].clone() else { continue };
            let port = self.port(assembly, attachment.to, attachment.port.as_deref());
            let frame = self.room.frames[port];
            // The part's own places are those in the frame of its first attachment.
            if !std::mem::replace(&mut placed[attachment.part], true) {
                for node in nodes.clone() {
                    let point = frame.point(self.room.pos[node]);
                    let own = frame.to_inertial(self.room.vel[node]);
                    self.room.pos[node] = point;
                    self.room.vel[node] = vec3::add(frame.velocity_at(point), own);
                }
            }
            for node in &attachment.nodes {
                let node = nodes.start + node;
                let place = frame.place(self.room.pos[node]);
                self.fixed.attachments.push(Attachment { node, port, place });
            }
        }
        let mut x = Vec::new();
        self.with(|mut island| {
            x = vec![0.0; island.n_x()];
            island.load(q, u, &mut x)?;
            island.place(0.0, &x)
        })
        .map_err(words)?;
        self.low = vec![0.0; x.len()];
        self.scratch = vec![0.0; self.method.1.scratch(x.len())];
        self.x = x;
        Ok(())
    }

    /// Contacts, where the assembly has some.
    fn touch(&mut self, assembly: &Assembly) -> Result<(), String> {
        if assembly.contacts.is_empty() {
            return Ok(());
        }
        if let Some(method) = &assembly.run.method {
            return Err(format!(
                "run.method = \"{method}\": a world with contacts has a step of its own (Moreau, order 2 where nothing touches); \
                 leave the key out"
            ));
        }
        let mut port = 0;
        let mut touchable = Vec::new();
        for (place, part) in self.places.iter().zip(&assembly.parts) {
            touchable.push(match (place, &part.kind) {
                (Place::Carrier(..), Kind::Rigid(rigid)) if rigid.body.is_some() => {
                    Touchable::Shape(Some(port), Frame::inertial())
                }
                (Place::Carrier(..), Kind::Rigid(rigid)) => Touchable::Shape(None, standing(rigid)),
                (Place::Shape(port, frame, _), _) => Touchable::Shape(Some(*port), *frame),
                (Place::Nodes(nodes, facets, _), _) => Touchable::Mesh(nodes.clone(), facets.clone()),
                _ => Touchable::Nothing,
            });
            if let Place::Carrier(number, _) = place {
                port += self.carriers[*number].n_ports();
            }
        }
        let answers = Inertias::answers(&Group { members: &mut self.carriers });
        let size = [self.room.frames.len(), self.room.pos.len(), answers, self.x.len()];
        self.touching = Some(Touching::new(assembly, &touchable, size)?);
        self.method.0 =
            "moreau, touches not located: of order 2 where nothing touches, 1 where something does";
        Ok(())
    }

    /// A step of a world with contacts; pairs that come into touch are events.
    fn step_touching(
        &mut self,
        h: f64,
        (x, low): (&mut [f64], &mut [f64]),
        found: &mut Vec<Event>,
    ) -> Result<Accounts<f64>, Fault> {
        let (t, old) = (self.t, x.to_vec());
        let mut touching = self.touching.take().ok_or(Fault::Shape)?;
        let (things, pairs, mut memory) = touching.memory();
        let done = self.with(|island| {
            let mut state = State::resume(x, low)?;
            let report = World { island, things, pairs }.step(t, h, &mut state, &mut memory)?;
            Ok(report)
        });
        let contacts: Vec<(usize, f64)> =
            memory.contacts().iter().map(|touch| (touch.pair, touch.contact.impulse[0])).collect();
        let counts = memory.counts;
        touching.after(h, counts, &contacts, found);
        self.touching = Some(touching);
        let report = done?;
        self.unsettled += usize::from(!report.settled);
        // What the step's own accounts do not see of mechanisms: powers in the middle, but those of the wrenches.
        let middle: Vec<f64> = old.iter().zip(x.iter()).map(|(a, b)| 0.5 * (a + b)).collect();
        let mut accounts = report.accounts;
        self.each_mechanism(&middle, |ported, q, u, wrenches| {
            let none = vec![Wrench::zero(); wrenches.len()];
            let account = ported.account(t + 0.5 * h, q, u, &none)?;
            accounts.drive += h * account.driven;
            accounts.damping += h * account.damped;
            Ok(())
        })?;
        Ok(accounts)
    }

    /// Frames of the ports of mechanisms that time alone moves.
    fn commanded(&self) -> Vec<Frame<f64>> {
        let (mut port, mut frames) = (0, Vec::new());
        for carrier in &self.carriers {
            let next = port + carrier.n_ports();
            if carrier.n_u() == 0 {
                frames.extend(&self.room.frames[port..next]);
            }
            port = next;
        }
        frames
    }

    /// Number of a port among all.
    fn port(&self, assembly: &Assembly, part: usize, name: Option<&str>) -> usize {
        let Place::Carrier(number, _) = self.places[part] else { return usize::MAX };
        let first: usize = self.carriers[..number].iter().map(Carrier::n_ports).sum();
        let own = name.and_then(|name| ports(assembly, part).iter().position(|port| port == name));
        first + own.unwrap_or(0)
    }

    /// Does something with the island that the lists are.
    fn with<T>(
        &mut self,
        act: impl FnOnce(Island<'_, f64, Group<'_, HostCarrier>>) -> Result<T, Fault>,
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
        act(Island::new(group, fixed.body(), &fixed.attachments, memory)?.with_cells(&fixed.cells)?)
    }

    /// Rates of a state; forces and wrenches of it are in memory then.
    fn rates(&mut self, t: f64, x: &[f64]) -> Result<Vec<f64>, Fault> {
        let mut dot = vec![0.0; x.len()];
        self.with(|mut island| island.rates(t, x, &mut dot))?;
        Ok(dot)
    }

    /// Powers at the state whose rates were asked for last.
    fn powers(&mut self, t: f64, x: &[f64]) -> Result<Powers, Fault> {
        let mut powers = Powers::default();
        let forces = self.room.viscous.iter().zip(&self.room.vel);
        powers.damped = -forces.map(|(force, velocity)| vec3::dot(*force, *velocity)).sum::<f64>();
        self.each_mechanism(x, |ported, q, u, wrenches| {
            let account = ported.account(t, q, u, wrenches)?;
            powers.driven += account.driven;
            powers.damped += account.damped;
            Ok(())
        })?;
        Ok(powers)
    }

    /// Shows each mechanism with its part of the state and the wrenches at its ports.
    fn each_mechanism(
        &mut self,
        x: &[f64],
        mut show: impl FnMut(&mut Ported, &[f64], &[f64], &[Wrench<f64>]) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let n_q = self.split();
        let (mut q, mut u, mut port) = (0, n_q, 0);
        for carrier in &mut self.carriers {
            let (next_q, next_u, next) = (q + carrier.n_q(), u + carrier.n_u(), port + carrier.n_ports());
            if let HostCarrier::Mechanism(ported) = carrier {
                show(ported, &x[q..next_q], &x[u..next_u], &self.room.wrenches[port..next])?;
            }
            (q, u, port) = (next_q, next_u, next);
        }
        Ok(())
    }

    /// Where speeds begin in the state.
    fn split(&self) -> usize {
        self.carriers.iter().map(Carrier::n_q).sum::<usize>() + 3 * self.free()
    }

    fn free(&self) -> usize {
        self.fixed.held.iter().filter(|held| !**held).count()
    }
}

impl Fixed {
    fn body(&self) -> Body<'_, f64> {
        Body {
            mass: &self.mass,
            fixed: &self.held,
            springs: &self.springs,
            gravity: self.gravity,
            air_drag: self.air_drag,
            facets: &self.facets,
            inflation: None,
            massless: Massless::default(),
        }
    }
}

/// The frame of a rigid part that does not move.
fn standing(rigid: &Rigid) -> Frame<f64> {
    let (origin, axes) = (rigid.start.position, rigid.start.attitude.axes());
    Frame { origin, axes, velocity: [0.0; 3], angular_velocity: [0.0; 3] }
}

/// Springs with their ends counted from `first`.
fn springs(lists: &Lists, first: usize) -> impl Iterator<Item = Spring<f64>> + '_ {
    (0..lists.springs.len()).map(move |n| Spring {
        tail: lists.springs[n][0] + first,
        head: lists.springs[n][1] + first,
        stiffness: lists.stiffness[n],
        damping: lists.damping[n],
        rest_length: lists.rest_lengths[n],
    })
}

/// Ports of a mechanism that attachments and surfaces use, each once.
fn ports(assembly: &Assembly, part: usize) -> Vec<String> {
    let mut ports: Vec<String> = Vec::new();
    let attached = assembly.attachments.iter().filter(|a| a.to == part).filter_map(|a| a.port.as_ref());
    let shapes = assembly.parts.iter().filter_map(|p| match &p.kind {
        Kind::Rigid(rigid) => rigid.on.as_ref().filter(|(to, _)| *to == part).map(|(_, name)| name),
        _ => None,
    });
    for name in attached.chain(shapes) {
        if !ports.contains(name) {
            ports.push(name.clone());
        }
    }
    ports
}

/// Refuses a step that a flexible part's fastest motion is too fast for.
fn check_step(assembly: &Assembly, fixed: &Fixed) -> Result<(), String> {
    for part in &assembly.parts {
        let Kind::Flexible(body) = &part.kind else { continue };
        let around =
            Surroundings { gravity: fixed.gravity, air_drag: fixed.air_drag, ground: None, inflation: None };
        let method = smartbed_runtime::ode::nodes::Method::Verlet;
        // Attached nodes have no mass and do not move: any will do.
        let mut lists = body.lists.clone();
        lists
            .masses
            .iter_mut()
            .zip(&lists.fixed)
            .filter(|(_, fixed)| **fixed)
            .for_each(|(mass, _)| *mass = 1.0);
        let probe = Simulation::<f64>::new(&lists, &around, method)
            .map_err(|e| format!("`{}`: {}", part.name, crate::scene::run::describe(&e)))?;
        if let Some(largest) = probe.largest_stable_step().filter(|largest| assembly.run.step > *largest) {
            return Err(format!(
                "run.step = {} s is larger than the largest stable step of `{}`, {largest:.3e} s; take a smaller one",
                assembly.run.step, part.name
            ));
        }
    }
    Ok(())
}

/// The method of free motion while a world without contacts is relaxed.
const RELAXED: Method = Method::SemiImplicitEuler;

impl Relaxing for CarriedWorld {
    fn vector(&self) -> Vec<f64> {
        self.x.clone()
    }

    fn split(&self) -> usize {
        self.split()
    }

    fn masses(&self) -> Vec<f64> {
        // The speeds of carriers are of many kinds: they count as 1 kg moves.
        let carriers = self.carriers.iter().map(Carrier::n_u).sum::<usize>();
        let free = self.fixed.mass.iter().zip(&self.fixed.held).filter(|(_, held)| !**held);
        std::iter::repeat_n(1.0, carriers).chain(free.flat_map(|(mass, _)| [*mass; 3])).collect()
    }

    fn fastest_frame(&self) -> f64 {
        let speeds =
            self.starts.iter().flat_map(|f| [vec3::norm(f.velocity), vec3::norm(f.angular_velocity)]);
        speeds.fold(0.0, f64::max)
    }

    fn gravity(&self) -> f64 {
        vec3::norm(self.fixed.gravity)
    }

    fn advance(&mut self, x: &mut [f64], low: &mut [f64]) -> Result<f64, Fault> {
        let h = self.h;
        if self.touching.is_some() {
            self.step_touching(h, (x, low), &mut Vec::new())?;
            return Ok(h);
        }
        let mut scratch = vec![0.0; RELAXED.scratch(x.len())];
        self.with(|mut island| {
            let mut state = State::resume(x, low)?;
            RELAXED.step(&mut island, 0.0, h, &mut state, &mut scratch).map(|_| h)
        })
    }

    fn restart(&mut self, x: Vec<f64>) {
        self.low = vec![0.0; x.len()];
        (self.x, self.t) = (x, 0.0);
        [self.drive, self.damping, self.impact, self.friction] = [0.0; 4];
    }
}

impl Engine for CarriedWorld {
    fn columns(&self) -> Vec<Column> {
        let mut columns = Vec::new();
        let mut add = |name: String, unit: &str, by_default: bool| {
            columns.push(Column { name, unit: unit.to_owned(), by_default });
        };
        for (name, place) in self.names.iter().zip(&self.places) {
            match place {
                Place::Carrier(number, _) => match &self.carriers[*number] {
                    HostCarrier::Mechanism(ported) => {
                        let n_q = ported.n_q();
                        for (n, (own, unit)) in ported.names.iter().enumerate() {
                            add(format!("{name}.{own}"), unit, n < n_q);
                        }
                    }
                    HostCarrier::Floating(_) => super::rigid::NUMBERS.iter().for_each(|(own, unit)| {
                        add(format!("{name}.{own}"), unit, ["x", "y", "z"].contains(own))
                    }),
                    HostCarrier::Still(_) => {}
                },
                Place::Shape(..) => {}
                Place::Nodes(nodes, _, cell) => {
                    add(format!("{name}.top"), "m", true);
                    if cell.is_some() {
                        add(format!("{name}.volume"), "m^3", true);
                        add(format!("{name}.gauge"), "Pa", true);
                    }
                    for node in 0..nodes.len() {
                        ["x", "y", "z"]
                            .iter()
                            .for_each(|axis| add(format!("{name}.{axis}{node}"), "m", false));
                    }
                }
            }
        }
        columns
    }

    fn state(&mut self) -> Result<Vec<f64>, String> {
        let (t, x) = (self.t, self.x.clone());
        self.with(|mut island| island.place(t, &x)).map_err(words)?;
        let n_q = self.split();
        let (mut q, mut u, mut values) = (0, n_q, Vec::new());
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for carrier in &self.carriers {
            let (own_q, own_u) = (&x[q..q + carrier.n_q()], &x[u..u + carrier.n_u()]);
            rows.push(match carrier {
                HostCarrier::Floating(floating) => {
                    let state = floating.state(own_q, own_u).map_err(words)?;
                    let spin = floating.body.angular_velocity(&state);
                    [own_q, &own_u[..3], &spin[..]].concat()
                }
                _ => [own_q, own_u].concat(),
            });
            (q, u) = (q + carrier.n_q(), u + carrier.n_u());
        }
        for place in &self.places {
            match place {
                Place::Carrier(number, _) => values.extend(&rows[*number]),
                Place::Shape(..) => {}
                Place::Nodes(nodes, _, cell) => {
                    let pos = &self.room.pos[nodes.clone()];
                    values.push(pos.iter().map(|p| p[2]).fold(f64::NEG_INFINITY, f64::max));
                    if let Some(cell) = cell.map(|cell| self.fixed.cells[cell]) {
                        let volume = cell.volume(&self.fixed.facets, &self.room.pos);
                        values.push(volume);
                        values.push(cell.content.gauge_pressure(volume).unwrap_or(f64::NAN));
                    }
                    values.extend(pos.as_flattened());
                }
            }
        }
        Ok(values)
    }

    fn energies(&mut self) -> Result<Energies, String> {
        let (t, x) = (self.t, self.x.clone());
        let island = self.with(|mut island| island.energy(t, &x)).map_err(words)?;
        let mut energies = Energies {
            kinetic: island.body.kinetic,
            gravity: island.body.gravity,
            spring: island.body.spring,
            gas: island.body.pressure,
            drive: self.drive,
            damping: self.damping,
            impact: self.impact,
            friction: self.friction,
        };
        self.each_mechanism(&x, |ported, q, u, wrenches| {
            let [kinetic, gravity, spring] = ported.account(t, q, u, wrenches)?.stored;
            energies.kinetic += kinetic;
            energies.gravity += gravity;
            energies.spring += spring;
            Ok(())
        })
        .map_err(words)?;
        let n_q = self.split();
        let (mut q, mut u) = (0, n_q);
        for carrier in &mut self.carriers {
            let (next_q, next_u) = (q + carrier.n_q(), u + carrier.n_u());
            if let HostCarrier::Floating(own) = carrier {
                let (kinetic, gravity) = own.energy(t, &x[q..next_q], &x[u..next_u]).map_err(words)?;
                energies.kinetic += kinetic;
                energies.gravity += gravity;
            }
            (q, u) = (next_q, next_u);
        }
        Ok(energies)
    }

    fn picture(&mut self) -> Result<Picture, String> {
        let (t, x) = (self.t, self.x.clone());
        self.with(|mut island| island.place(t, &x)).map_err(words)?;
        let mut mechanisms = Vec::new();
        self.each_mechanism(&x, |ported, q, u, _| {
            mechanisms.push(ported.picture(t, q, u)?);
            Ok(())
        })
        .map_err(words)?;
        let (mut picture, mut next, mut port) = (Picture::default(), mechanisms.into_iter(), 0);
        for place in &self.places {
            match place {
                Place::Shape(port, place, shape) => {
                    let frame = self.room.frames[*port];
                    picture.solid(
                        shape,
                        frame.point(place.origin),
                        place.axes.map(|axis| frame.to_inertial(axis)),
                    );
                }
                Place::Nodes(nodes, ..) => picture.points.extend(&self.room.pos[nodes.clone()]),
                Place::Carrier(number, shape) => {
                    let frame = self.room.frames.get(port);
                    port += self.carriers[*number].n_ports();
                    match (shape, frame) {
                        (Some(shape), Some(frame)) => picture.solid(shape, frame.origin, frame.axes),
                        (Some(_), None) => {}
                        (None, _) => {
                            if let Some(own) = next.next() {
                                picture.append(&own);
                            }
                        }
                    }
                }
            }
        }
        Ok(picture)
    }

    fn step(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        if self.touching.is_some() {
            let (mut x, mut low) = (std::mem::take(&mut self.x), std::mem::take(&mut self.low));
            let done = self.step_touching(h, (&mut x, &mut low), found);
            (self.x, self.low) = (x, low);
            let accounts = done.map_err(words)?;
            self.drive += accounts.drive;
            self.damping += accounts.damping + accounts.drag;
            self.impact += accounts.impact;
            self.friction += accounts.friction;
            self.t += h;
            return Ok(());
        }
        let (t, old) = (self.t, self.x.clone());
        let before = self.rates(t, &old).map_err(words)?;
        let first = self.powers(t, &old).map_err(words)?;
        let (mut x, mut low, mut scratch) =
            (std::mem::take(&mut self.x), std::mem::take(&mut self.low), std::mem::take(&mut self.scratch));
        let method = self.method.1;
        // Where time gives everything there is nothing to integrate.
        let done = if x.is_empty() {
            Ok(())
        } else {
            self.with(|mut island| {
                let mut state = State::resume(&mut x, &mut low)?;
                method.step(&mut island, t, h, &mut state, &mut scratch).map(|_| ())
            })
        };
        (self.x, self.low, self.scratch) = (x, low, scratch);
        done.map_err(words)?;
        let new = self.x.clone();
        let after = self.rates(t + h, &new).map_err(words)?;
        let last = self.powers(t + h, &new).map_err(words)?;
        let ends = old.iter().zip(&new).zip(before.iter().zip(&after));
        let middle: Vec<f64> = ends.map(|((a, b), (da, db))| 0.5 * (a + b) + 0.125 * h * (da - db)).collect();
        self.rates(t + 0.5 * h, &middle).map_err(words)?;
        let between = self.powers(t + 0.5 * h, &middle).map_err(words)?;
        self.drive += h / 6.0 * (first.driven + 4.0 * between.driven + last.driven);
        self.damping += h / 6.0 * (first.damped + 4.0 * between.damped + last.damped);
        self.t = t + h;
        Ok(())
    }

    fn settle(&mut self) -> Result<Settled, String> {
        relax(self)
    }

    fn save(&self) -> Vec<f64> {
        let accounts = [self.t, self.drive, self.damping, self.impact, self.friction];
        [&accounts[..], &self.x, &self.low].concat()
    }

    fn load(&mut self, numbers: &[f64]) -> Result<(), String> {
        let n = self.x.len();
        if numbers.len() != 5 + 2 * n {
            return Err(super::engine::other_world());
        }
        let (accounts, state) = numbers.split_at(5);
        [self.t, self.drive, self.damping] = [accounts[0], accounts[1], accounts[2]];
        [self.impact, self.friction] = [accounts[3], accounts[4]];
        self.x.copy_from_slice(&state[..n]);
        self.low.copy_from_slice(&state[n..]);
        Ok(())
    }

    fn warnings(&self) -> Vec<String> {
        if self.unsettled == 0 {
            return Vec::new();
        }
        vec![format!(
            "{}: the sweeps over the contacts were cut short; take a smaller step",
            smartbed_codegen::words::count(self.unsettled, "step")
        )]
    }

    fn method(&self) -> String {
        match self.touching {
            Some(_) => self.method.0.to_owned(),
            None => format!("{}, flexible parts and what carries them as one", self.method.0),
        }
    }
}
