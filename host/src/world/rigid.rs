//! Worlds of rigid parts alone, moved by the runtime's rigid scene: impacts are located in time, lasting contacts are
//! held by forces.

use super::accounts::{self, Accounts};
use super::assembly::{Assembly, Contact, Kind, Law};
use super::books::Books;
use super::engine::{Column, Energies, Engine, Event};
use super::picture::Picture;
use super::pushed::Pushed;
use crate::contact_force::ContactForce;
use crate::failure::Failure;
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_runtime::rigid::RigidState;
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::contact::{Mobility, Twist};
use smartbed_runtime::rigid::scene::{Fault, Memory, Pair, Part, Piece, RigidScene, Strike, Touching};
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::Push;
use std::cell::RefCell;

/// Numbers of one part in a row.
pub(super) const NUMBERS: [(&str, &str); 13] = [
    ("x", "m"),
    ("y", "m"),
    ("z", "m"),
    ("e0", ""),
    ("e1", ""),
    ("e2", ""),
    ("e3", ""),
    ("vx", "m/s"),
    ("vy", "m/s"),
    ("vz", "m/s"),
    ("wx", "rad/s"),
    ("wy", "rad/s"),
    ("wz", "rad/s"),
];
/// Most contacts of one pair.
const CONTACTS: usize = smartbed_runtime::rigid::narrow::CAPACITY;

/// A world of rigid bodies.
#[derive(Clone, Debug)]
pub struct RigidWorld {
    names: Vec<String>,
    parts: Vec<Part<f64>>,
    pairs: Vec<Pair<f64>>,
    gravity: [f64; 3],
    states: Vec<RigidState<f64>>,
    scratch: [Vec<RigidState<f64>>; 3],
    twists: [Vec<Twist<f64>>; 2],
    mobilities: Vec<Mobility<f64>>,
    touching: [Vec<Touching<f64>>; 2],
    struck: Vec<Struck<f64>>,
    impact: f64,
    friction: f64,
    forced: usize,
    impulsive: usize,
    /// Number of contacts that carry force after the last step, and their forces by pair.
    held: usize,
    pushed: Pushed,
    /// Kept if they are asked for.
    books: Option<Books>,
}

impl RigidWorld {
    /// Builds the world at its start.
    ///
    /// # Errors
    /// If a part is not rigid, or a method is named: these worlds have only their own.
    pub fn new(assembly: &Assembly) -> Result<Self, Failure> {
        if let Some(method) = &assembly.run.method {
            let error = Diagnostic::error(format!(
                "run.method = \"{method}\": rigid bodies have a step of their own, of order 2 between events"
            ));
            let error = error.label(assembly.places.key(&["run", "method"]), "not read here");
            return Err(assembly.places.failure(error.help("leave the key out")));
        }
        let (mut names, mut parts, mut states) = (Vec::new(), Vec::new(), Vec::new());
        for part in &assembly.parts {
            let Kind::Rigid(rigid) = &part.kind else {
                return Err(format!("`{}` is not rigid", part.name).into());
            };
            names.push(part.name.clone());
            parts.push(Part { shape: rigid.shape, body: rigid.body });
            states.push(rigid.start);
        }
        assembly.refuse_immovable_pairs(|part| parts[part].body.is_none())?;
        let located = |c: &Contact| match c.law {
            Law::Located(law) => Some(Pair { parts: c.between, law }),
            Law::Force(_) | Law::Moreau { .. } => None,
        };
        let pairs: Vec<Pair<f64>> = assembly.contacts.iter().filter_map(located).collect();
        let (n, room) = (parts.len(), CONTACTS * pairs.len());
        let empty = Touching::empty();
        Ok(RigidWorld {
            names,
            gravity: assembly.gravity,
            scratch: [states.clone(), states.clone(), states.clone()],
            twists: [vec![Twist::zero(); n], vec![Twist::zero(); n]],
            mobilities: vec![Mobility::fixed(); n],
            touching: [vec![empty; room], vec![empty; room]],
            struck: vec![Struck::new(empty.held.contact, &[] as &[Mobility<f64>]); room],
            pushed: Pushed::new(pairs.len()),
            parts,
            pairs,
            states,
            impact: 0.0,
            friction: 0.0,
            forced: 0,
            impulsive: 0,
            held: 0,
            books: None,
        })
    }

    /// Contacts that carry force after the last step: the first `held` of its last stretch that have an impulse.
    fn pressing(&self) -> impl Iterator<Item = &Touching<f64>> {
        self.touching[1].iter().filter(|along| along.held.contact.impulse[0] > 0.0).take(self.held)
    }

    /// The forces of these contacts.
    fn forces(&self) -> Vec<ContactForce> {
        let force = |along: &Touching<f64>| {
            let contact = &along.held.contact;
            let at = contact.sides.iter().flat_map(|side| side.points()).next()?;
            let point = vec3::add(self.states[at.body].position, at.arm);
            let moves = self.pairs[along.pair].parts.map(|part| self.parts[part].body.is_some());
            ContactForce::between(moves, point, contact.axes, contact.impulse)
        };
        self.pressing().filter_map(force).collect()
    }
}

/// Converts an impact to events, pair by pair.
fn events(strike: &Strike<'_, f64>, pairs: &[Pair<f64>], found: &mut Vec<Event>) {
    for (number, pair) in pairs.iter().enumerate() {
        let own = strike.touching.iter().zip(strike.struck).filter(|(t, _)| t.pair == number);
        let mut event =
            Event { time: strike.time, parts: pair.parts, points: 0, approach: 0.0, impulse: 0.0 };
        for (touching, struck) in own {
            let impulse = struck.contact.impulse[0];
            event.points += usize::from(impulse > 0.0);
            event.impulse += impulse;
            event.approach = event.approach.max(-touching.velocity[0]);
        }
        if event.points > 0 {
            found.push(event);
        }
    }
}

impl Engine for RigidWorld {
    fn columns(&self) -> Vec<Column> {
        let moving = self.names.iter().zip(&self.parts).filter(|(_, part)| part.body.is_some());
        let of = |name: &String| {
            NUMBERS.map(|(number, unit)| Column {
                name: format!("{name}.{number}"),
                unit: unit.to_owned(),
                by_default: ["x", "y", "z"].contains(&number),
            })
        };
        let pairs = self.pairs.iter().map(|pair| pair.parts.map(|part| self.names[part].as_str()));
        moving.flat_map(|(name, _)| of(name)).chain(Pushed::columns(pairs)).collect()
    }

    fn state(&mut self) -> Result<Vec<f64>, String> {
        let mut values = Vec::new();
        for (part, state) in self.parts.iter().zip(&self.states) {
            let Some(body) = &part.body else { continue };
            values.extend(state.position);
            values.extend(state.attitude.parameters());
            values.extend(state.velocity);
            values.extend(body.angular_velocity(state));
        }
        values.extend(self.pushed.values());
        Ok(values)
    }

    fn energies(&mut self) -> Result<Energies, String> {
        let mut energies = Energies { impact: self.impact, friction: self.friction, ..Energies::default() };
        for (part, state) in self.parts.iter().zip(&self.states) {
            let Some(body) = &part.body else { continue };
            energies.kinetic += body.kinetic(state);
            energies.gravity -= body.mass * vec3::dot(self.gravity, state.position);
        }
        Ok(energies)
    }

    fn picture(&mut self) -> Result<Picture, String> {
        let mut picture = Picture::default();
        for (part, state) in self.parts.iter().zip(&self.states) {
            picture.solid(&part.shape, state.position, state.attitude.axes());
        }
        picture.forces = self.forces();
        Ok(picture)
    }

    fn step(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        let scene = RigidScene { parts: &self.parts, pairs: &self.pairs, gravity: self.gravity };
        let [a, b, c] = &mut self.scratch;
        let [twists, spare] = &mut self.twists;
        let [touching, along] = &mut self.touching;
        let mut memory = Memory {
            states: [a, b, c],
            twists,
            spare,
            mobilities: &mut self.mobilities,
            touching,
            along,
            struck: &mut self.struck,
        };
        let (pairs, kept) = (&self.pairs, RefCell::new(&mut self.books));
        let bodies = |pair: usize| pairs[pair].parts.map(|part| part..part + 1);
        let strikes = |strike: Strike<'_, f64>| {
            events(&strike, pairs, found);
            if let Some(books) = &mut **kept.borrow_mut() {
                let struck = strike.touching.iter().zip(strike.struck);
                struck.for_each(|(t, s)| books.struck(t.pair, &s.contact, strike.ends, &bodies(t.pair)));
            }
        };
        let pieces = |piece: Piece<'_, f64>| {
            let Some(books) = &mut **kept.borrow_mut() else { return };
            for t in piece.along.iter().filter(|t| t.held.contact.impulse[0] > 0.0) {
                let (contact, ends) = (&t.held.contact, [piece.twists; 2]);
                let push = Push {
                    pair: t.pair,
                    contact,
                    duration: piece.length,
                    ends,
                    strikes: piece.strikes,
                    taken: 0.0,
                };
                books.push(&push, &bodies(t.pair));
            }
        };
        let done = scene.step_watched(&mut self.states, h, &mut memory, (strikes, pieces));
        let report = done.map_err(|fault| message(fault, &self.names))?;
        self.impact += report.impact_loss;
        self.friction += report.friction_loss;
        self.forced += usize::from(report.forced);
        self.impulsive += usize::from(report.impulsive);
        self.held = report.held;
        let mut pushed = Pushed::new(self.pairs.len());
        for along in self.pressing() {
            let bodies = self.pairs[along.pair].parts.map(|part| part..part + 1);
            let contact = &along.held.contact;
            pushed.add(along.pair, bodies.each_ref(), contact, contact.impulse);
        }
        self.pushed = pushed;
        Ok(())
    }

    fn middles(&self) -> Vec<Vec3<f64>> {
        self.states.iter().map(|state| state.position).collect()
    }

    fn keep_accounts(&mut self) {
        let counts = [self.pairs.len(), self.parts.len(), 0, 0];
        self.books = Some(Books::new(std::iter::empty(), (Vec::new(), 0.0), counts));
    }

    fn accounts(&mut self) -> Result<Accounts, String> {
        let Some(books) = &self.books else { return Err(accounts::not_kept()) };
        let part = |number: usize| {
            let (body, state) = (self.parts[number].body?, &self.states[number]);
            let gravity = -(body.mass * vec3::dot(self.gravity, state.position));
            Some(accounts::Part {
                name: self.names[number].clone(),
                stored: [body.kinetic(state), gravity, 0.0, 0.0],
                seams: books.ports[number],
                ..accounts::Part::default()
            })
        };
        let seam = |(pair, passed): (&Pair<f64>, &accounts::Passed)| {
            accounts::Seam::of_pair(pair.parts.map(|part| self.names[part].clone()), *passed)
        };
        Ok(Accounts {
            parts: (0..self.parts.len()).filter_map(part).collect(),
            seams: self.pairs.iter().zip(&books.pairs).map(seam).collect(),
        })
    }

    fn save(&self) -> Vec<f64> {
        let mut numbers = vec![self.impact, self.friction];
        numbers.extend(self.pushed.values());
        for state in &self.states {
            numbers.extend(state.position);
            numbers.extend(state.attitude.parameters());
            numbers.extend(state.velocity);
            numbers.extend(state.angular_momentum);
        }
        numbers
    }

    fn load(&mut self, numbers: &[f64]) -> Result<(), String> {
        let first = 2 + self.pushed.values().len();
        if numbers.len() != first + 13 * self.states.len() {
            return Err(super::engine::other_world());
        }
        [self.impact, self.friction] = [numbers[0], numbers[1]];
        self.pushed.load(&numbers[2..first]);
        for (state, n) in self.states.iter_mut().zip(numbers[first..].chunks_exact(13)) {
            state.position = [n[0], n[1], n[2]];
            state.attitude = Attitude::restored([n[3], n[4], n[5], n[6]]);
            state.velocity = [n[7], n[8], n[9]];
            state.angular_momentum = [n[10], n[11], n[12]];
        }
        Ok(())
    }

    fn warnings(&self) -> Vec<String> {
        let steps = |count: usize| smartbed_codegen::words::count(count, "step");
        let mut said = Vec::new();
        if self.forced > 0 {
            said.push(format!(
                "{} contained more events than a step may be split at: the rest of each was computed with e = 0; take a \
                 smaller step",
                steps(self.forced)
            ));
        }
        if self.impulsive > 0 {
            said.push(impulsive(&steps(self.impulsive)));
        }
        said
    }

    fn method(&self) -> String {
        "rigid bodies: events located, order 2 between them".to_owned()
    }
}

/// What a run says of steps in which contact forces were not found.
pub(super) fn impulsive(steps: &str) -> String {
    format!(
        "{steps} had no contact forces that were found, as where much friction jams: contacts acted by impulses there, of \
         order 1; a smaller step makes them more exact"
    )
}

fn message(fault: Fault, names: &[String]) -> String {
    match fault {
        Fault::TooManyContacts => "more contacts at once than the memory allows".to_owned(),
        Fault::WrongSizes => "the lists of the parts have different lengths".to_owned(),
        Fault::TooFast => {
            "a part turns too far in one step, or its state would not be finite; take a smaller step"
                .to_owned()
        }
        Fault::StepSize => "the step is not a finite time; expected one above 0 s".to_owned(),
        Fault::Gravity => "gravity is not finite".to_owned(),
        Fault::Part(part) => format!(
            "the mass, inertia or size of `{}` is not > 0 and finite, or too small to divide by, or its state is not finite",
            names.get(part).map_or("", String::as_str)
        ),
    }
}
