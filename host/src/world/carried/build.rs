//! Builds a world of flexible parts at its start: carriers, one body of all flexible parts, attachments, contacts.
//!
//! In: an assembly. Out: a [`CarriedWorld`], or the reason why it cannot be derived, assembled or stepped.

use super::air::Air;
use super::methods::Contacts;
use super::{CarriedWorld, Fixed, Place, Room, words};
use crate::failure::Failure;
use crate::scene::grid::Woven;
use crate::world::assembly::{Assembly, Kind, Law, Part, Rigid};
use crate::world::carriers::HostCarrier;
use crate::world::derived::Derivations;
use crate::world::ported::Ported;
use crate::world::touching::{Touchable, Touching};
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_runtime::flexible::PressureForm;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3;
use smartbed_runtime::world::{
    Accounts as Works, Attachment, Carrier, Cell, Content, Floating, Group, Inertias, Still, Wrench,
};

impl CarriedWorld {
    /// Builds the world at its start.
    ///
    /// # Errors
    /// Why it cannot be derived, assembled or stepped, with the place where it has one.
    pub fn new(assembly: &Assembly) -> Result<Self, Failure> {
        let contacts = contacts(assembly);
        let default = contacts.default_method(assembly.parts.iter().any(is_undamped));
        let method = contacts.method(assembly.run.method.as_deref().unwrap_or(default)).map_err(|error| {
            let place = assembly.places.key(&["run", "method"]);
            assembly.places.failure(error.label(place, "not for this world"))
        })?;
        let mut world = CarriedWorld {
            names: assembly.parts.iter().map(|part| part.name.clone()).collect(),
            places: Vec::new(),
            carriers: Vec::new(),
            fixed: Fixed::empty(assembly.gravity, 0.0),
            room: Room::default(),
            x: Vec::new(),
            low: Vec::new(),
            scratch: Vec::new(),
            contacts,
            method,
            h: assembly.run.step,
            starts: Vec::new(),
            t: 0.0,
            works: Works::empty(),
            airs: Vec::new(),
            touching: None,
            unsettled: 0,
            rims: Vec::new(),
            forced: 0,
            books: None,
            stable: None,
        };
        let starts = world.carriers(assembly)?;
        world.flexible(assembly)?;
        world.join(assembly, &starts)?;
        world.stable = world.stable_step(assembly)?;
        world.touch(assembly)?;
        world.refuse_stiff_pairs(assembly)?;
        let x = world.x.clone();
        world.with(|mut island| island.place(0.0, &x)).map_err(words)?;
        world.rims = world.nodes_over_rims();
        if !assembly.run.settled {
            world.refuse_overlaps(assembly)?;
        }
        Ok(world)
    }

    /// Adds the carriers in the order of the parts; returns their initial coordinates and speeds.
    fn carriers(&mut self, assembly: &Assembly) -> Result<[Vec<f64>; 2], String> {
        let [mut q, mut u] = [Vec::new(), Vec::new()];
        let mut derivations = Derivations::default();
        for (number, part) in assembly.parts.iter().enumerate() {
            let carrier = match &part.kind {
                Kind::Mechanism(mechanism) => {
                    let ports = ports(assembly, number);
                    let derived = derivations.of(&mechanism.model, &ports);
                    let derived = derived.map_err(|why| format!("`{}`: {why}", part.name))?;
                    q.extend(&derived.start.q);
                    u.extend(&derived.start.u);
                    HostCarrier::Mechanism(Box::new(Ported::new(&derived, mechanism.place)))
                }
                Kind::Rigid(rigid) if rigid.on.is_some() => {
                    // The index of its port is known only when all carriers have been added.
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
                    None => HostCarrier::Still(Still(standing(rigid))),
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

    /// Combines all flexible parts into one body.
    fn flexible(&mut self, assembly: &Assembly) -> Result<(), Failure> {
        let mut drag = None;
        for (number, (part, place)) in assembly.parts.iter().zip(&mut self.places).enumerate() {
            let Kind::Flexible(body) = &part.kind else { continue };
            if drag.is_some_and(|drag| drag != body.air_drag) {
                let error = Diagnostic::error(format!(
                    "`{}`: air_drag differs from that of another flexible part",
                    part.name
                ));
                let error = error.label(assembly.places.part(&part.name, "air_drag"), "another drag");
                return Err(assembly.places.failure(error.help("give all flexible parts the same, or none")));
            }
            drag = Some(body.air_drag);
            let (first, first_facet, fixed) =
                (self.fixed.mass.len(), self.fixed.facets.len(), &mut self.fixed);
            let lists = &body.lists;
            fixed.grids.extend(Woven::new(lists, [first, fixed.springs.len(), first_facet]));
            fixed.mass.extend(&lists.masses);
            fixed.held.extend(&lists.fixed);
            fixed.springs.extend(lists.elements::<f64>(first));
            fixed.facets.extend(lists.facets.iter().map(|corners| corners.map(|node| node + first)));
            let cell = body.gas.map(|content| {
                let facets = [first_facet, fixed.facets.len()];
                fixed.cells.push(Cell { facets, content, form: PressureForm::Exact, wall: None });
                let cell = fixed.cells.len() - 1;
                if matches!(content, Content::Sealed { .. }) {
                    self.airs.push(Air::new(number, cell, body.lines));
                }
                cell
            });
            self.room.pos.extend(&lists.points);
            self.room.vel.extend(&lists.velocities);
            *place = Place::Nodes(first..fixed.mass.len(), first_facet..fixed.facets.len(), cell);
        }
        self.fixed.air_drag = drag.unwrap_or(0.0);
        self.fixed.weigh();
        let n = self.room.pos.len();
        [self.room.elastic, self.room.viscous] = [vec![[0.0; 3]; n], vec![[0.0; 3]; n]];
        Ok(())
    }

    /// Moves attached parts into the frames that hold them, and writes the initial state.
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
            // The part's own positions are relative to the frame of its first attachment.
            if !std::mem::replace(&mut placed[attachment.part], true) {
                for node in nodes.clone() {
                    let point = frame.point(self.room.pos[node]);
                    let own = frame.to_inertial(self.room.vel[node]);
                    self.room.pos[node] = point;
                    // What is fixed stays where the frame was; what is attached gets its frame's velocity at each state.
                    self.room.vel[node] = match self.fixed.held[node] {
                        true => [0.0; 3],
                        false => vec3::add(frame.velocity_at(point), own),
                    };
                }
            }
            for node in &attachment.nodes {
                let node = nodes.start + node;
                let place = frame.place(self.room.pos[node]);
                self.fixed.attachments.push(Attachment { node, port, place, push: [0.0; 3] });
            }
        }
        self.find_restrained();
        self.find_walls();
        let mut x = Vec::new();
        self.with(|mut island| {
            x = vec![0.0; island.n_x()];
            island.load(q, u, &mut x)?;
            island.place(0.0, &x)
        })
        .map_err(words)?;
        self.low = vec![0.0; x.len()];
        self.scratch = vec![0.0; self.ode_method().scratch(x.len())];
        self.x = x;
        Ok(())
    }

    /// Adds the parts that can be touched, and the memory for steps with contacts.
    fn touch(&mut self, assembly: &Assembly) -> Result<(), Failure> {
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
        self.touching = Some(Touching::new(assembly, &touchable, size, self.ode_method())?);
        self.refuse_immovable_pairs(assembly)
    }

    /// Refuses contacts between parts that no force moves.
    fn refuse_immovable_pairs(&self, assembly: &Assembly) -> Result<(), Failure> {
        let [ports, held] = self.immovable();
        assembly.refuse_immovable_pairs(|part| match &self.places[part] {
            Place::Carrier(number, _) => self.carriers[*number].n_u() == 0,
            Place::Shape(port, ..) => ports[*port],
            Place::Nodes(nodes, ..) => held[nodes.clone()].iter().all(|held| *held),
        })
    }

    /// Frames of the ports of mechanisms whose motion is completely prescribed.
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

    /// Index of a port among all.
    fn port(&self, assembly: &Assembly, part: usize, name: Option<&str>) -> usize {
        let Place::Carrier(number, _) = self.places[part] else { return usize::MAX };
        let first: usize = self.carriers[..number].iter().map(Carrier::n_ports).sum();
        let own = name.and_then(|name| ports(assembly, part).iter().position(|port| port == name));
        first + own.unwrap_or(0)
    }
}

/// Is it flexible, with springs that have no damping?
fn is_undamped(part: &Part) -> bool {
    let Kind::Flexible(body) = &part.kind else { return false };
    let lists = &body.lists;
    !lists.springs.is_empty() && body.air_drag == 0.0 && lists.damping.iter().all(|c| *c == 0.0)
}

/// The requirements of the assembly's contacts on the method.
fn contacts(assembly: &Assembly) -> Contacts {
    let unlocated = assembly.contacts.iter().any(|contact| matches!(contact.law, Law::Moreau { .. }));
    match (assembly.contacts.is_empty(), unlocated) {
        (true, _) => Contacts::None,
        (_, true) => Contacts::Unlocated,
        _ => Contacts::Located,
    }
}

/// The frame of a fixed rigid part.
fn standing(rigid: &Rigid) -> Frame<f64> {
    let (origin, axes) = (rigid.start.position, rigid.start.attitude.axes());
    Frame { origin, axes, velocity: [0.0; 3], angular_velocity: [0.0; 3] }
}

/// Ports of a mechanism that attachments and surfaces use, without duplicates.
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
