//! The data of a world: the contents of a scene of format 2, with names resolved and numbers in SI units.
//!
//! Parts are in the author's order; attachments and contacts refer to them by index.

pub use super::observing::{Controlling, Sensing, Transducer};
use super::places::Places;
use crate::failure::Failure;
use crate::hash::hash;
use crate::scene::Lists;
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_codegen::model::{Model, StartRef};
use smartbed_runtime::contact::ForceLaw;
use smartbed_runtime::gas::Line;
use smartbed_runtime::rigid::law;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::Shape;
use smartbed_runtime::world::Content;

/// Acceleration of gravity in N where a scene gives none (m/s^2).
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// The contents of a scene.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// One line about it.
    pub title: String,
    /// Acceleration of gravity in N (m/s^2).
    pub gravity: [f64; 3],
    /// The parts.
    pub parts: Vec<Part>,
    /// Nodes of flexible parts that are attached to other parts.
    pub attachments: Vec<Attachment>,
    /// Pairs of parts that touch, with their laws.
    pub contacts: Vec<Contact>,
    /// The sensors.
    pub sensors: Vec<Sensing>,
    /// The controllers.
    pub controllers: Vec<Controlling>,
    /// Length, step and method of the run.
    pub run: Run,
    /// Options of pictures.
    pub view: View,
    /// Where all this stands in the scene's text.
    pub places: Places,
}

impl Assembly {
    /// Is a gravity given that acts on no part? Mechanisms keep that of their models.
    #[must_use]
    pub fn has_idle_gravity(&self) -> bool {
        self.gravity != GRAVITY && self.parts.iter().all(|part| matches!(part.kind, Kind::Mechanism(_)))
    }

    /// Fingerprint of everything that decides the motion but for the length and step of the run: a checkpoint carries
    /// it, so that a run that goes on with other masses, laws or gravity is told. Folders and titles do not enter.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let parts = self.parts.iter().map(|part| match &part.kind {
            Kind::Mechanism(mechanism) => {
                let model = &mechanism.model;
                let texts: Vec<&str> = model.source.files.iter().map(|file| file.text.as_str()).collect();
                format!("{} {texts:?} {:?} {:?}", part.name, model.parameters, mechanism.place)
            }
            other => format!("{} {other:?}", part.name),
        });
        let parts: Vec<String> = parts.collect();
        let between = (&self.attachments, &self.contacts, &self.sensors, &self.controllers);
        hash(format!("{:?} {parts:?} {between:?}", self.gravity).as_bytes())
    }
}

/// What pictures of a world leave out, and their colours.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct View {
    /// Parts left out.
    pub hidden: Vec<usize>,
    /// Are the forces of contacts left out?
    pub hides_forces: bool,
    /// Colours (red, green, blue) by part.
    pub colours: Vec<(usize, [u8; 3])>,
    /// Are facets coloured by the pressure inside, not by stretch?
    pub by_pressure: bool,
}

impl View {
    /// The colour of a part, if one is chosen.
    #[must_use]
    pub fn colour(&self, part: usize) -> Option<[u8; 3]> {
        self.colours.iter().find(|(of, _)| *of == part).map(|(_, rgb)| *rgb)
    }
}

/// A part with its name.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its kind and data.
    pub kind: Kind,
}

impl Part {
    /// Can it move, or is it fixed in space?
    #[must_use]
    pub fn can_move(&self) -> bool {
        !matches!(&self.kind, Kind::Rigid(Rigid { body: None, on: None, .. }))
    }
}

impl Part {
    /// Does its text, or the start of its model, give it a velocity?
    #[must_use]
    pub fn starts_in_motion(&self) -> bool {
        let moves = |v: &[f64; 3]| v.iter().any(|v| *v != 0.0);
        match &self.kind {
            Kind::Rigid(rigid) => moves(&rigid.start.velocity) || moves(&rigid.start.angular_momentum),
            Kind::Flexible(body) => body.lists.velocities.iter().any(moves),
            Kind::Mechanism(mechanism) => mechanism
                .model
                .start
                .iter()
                .any(|(of, value)| matches!(of, StartRef::Speed(_)) && *value != 0.0),
        }
    }
}

/// What a part is.
#[derive(Clone, Debug)]
pub enum Kind {
    /// A mechanism, with derived equations.
    Mechanism(Box<Mechanism>),
    /// Nodes, springs, facets.
    Flexible(Box<Flexible>),
    /// One rigid body, or a shape fixed in space.
    Rigid(Rigid),
}

/// A mechanism.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Its model, extended by the motions that the scene commands.
    pub model: Model,
    /// Position of its origin in N (m).
    pub place: [f64; 3],
}

impl Mechanism {
    /// Do functions of the time give all its motion, so that no force changes it?
    #[must_use]
    pub fn is_given(&self) -> bool {
        !self.model.speeds.iter().any(|speed| speed.independent)
    }
}

/// A flexible body.
#[derive(Clone, Debug)]
pub struct Flexible {
    /// Nodes in their initial positions, springs, facets. Attached nodes are fixed and have no mass.
    pub lists: Lists,
    /// Viscous drag of the air per node (N s/m).
    pub air_drag: f64,
    /// Gas inside.
    pub gas: Option<Content<f64>>,
    /// Supply and vent of the gas, whose mass is otherwise constant.
    pub lines: [Option<Line<f64>>; 2],
}

/// A rigid body.
#[derive(Clone, Debug)]
pub struct Rigid {
    /// Its shape about its centre of mass.
    pub shape: Shape<f64>,
    /// Its mass and inertia; `None` if it is fixed in space or to a port.
    pub body: Option<RigidBody<f64>>,
    /// The mechanism and port to which it is fixed as a surface without mass.
    pub on: Option<(usize, String)>,
    /// Its initial state; for a shape on a port its pose there.
    pub start: RigidState<f64>,
}

/// Nodes attached to a frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Attachment {
    /// The flexible part.
    pub part: usize,
    /// Its nodes.
    pub nodes: Vec<usize>,
    /// The part to which they are attached.
    pub to: usize,
    /// The port, if that is a mechanism; `None` for a rigid body, whose own frame holds them.
    pub port: Option<String>,
}

/// Two parts that may touch.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Contact {
    /// Their indices.
    pub between: [usize; 2],
    /// The law between them.
    pub law: Law,
}

/// A law of contact.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Law {
    /// Impacts located in time, and contact constraints between them.
    Located(law::Law<f64>),
    /// A force that depends on the depth of an overlap.
    Force(ForceLaw<f64>),
    /// Moreau's time stepping, without locating touches, for parts of every kind.
    Moreau {
        /// Newton's coefficient of restitution e at each point; energy is never created.
        restitution: f64,
        /// Coulomb's coefficient of friction mu.
        friction: f64,
    },
}

/// The first contact whose law is of another kind than that of the contacts before it: a world either locates all
/// touches in time or none.
#[must_use]
pub fn mixed(contacts: &[Contact]) -> Option<usize> {
    let is_located = |contact: &Contact| !matches!(contact.law, Law::Moreau { .. });
    contacts.iter().position(|contact| is_located(contact) != is_located(&contacts[0]))
}

/// Settings of the run.
#[derive(Clone, PartialEq, Debug)]
pub struct Run {
    /// Length (s).
    pub seconds: f64,
    /// Step (s).
    pub step: f64,
    /// Steps per row.
    pub every: usize,
    /// The method's name, if the scene chooses one.
    pub method: Option<String>,
    /// Does it begin in static equilibrium?
    pub settled: bool,
    /// Parts slower than this (m/s, rad/s) for 0.1 s are frozen until something comes near them; `None` freezes
    /// nothing.
    pub sleep: Option<f64>,
}

impl Assembly {
    /// The rigid parts with their names.
    pub fn rigid(&self) -> impl Iterator<Item = (&str, &Rigid)> {
        self.parts.iter().filter_map(|part| match &part.kind {
            Kind::Rigid(rigid) => Some((part.name.as_str(), rigid)),
            _ => None,
        })
    }

    /// Names of the sensors and controllers, in the order of their values in a checkpoint.
    #[must_use]
    pub fn observers(&self) -> Vec<String> {
        let sensors = self.sensors.iter().map(|own| format!("sensors.{}", own.name));
        sensors.chain(self.controllers.iter().map(|own| format!("controllers.{}", own.name))).collect()
    }

    /// Name and kind of each part.
    #[must_use]
    pub fn kinds(&self) -> Vec<String> {
        let kind = |part: &Part| match part.kind {
            Kind::Mechanism(_) => "mechanism",
            Kind::Flexible(_) => "flexible",
            Kind::Rigid(_) => "rigid",
        };
        self.parts.iter().map(|part| format!("{} ({})", part.name, kind(part))).collect()
    }

    /// Does the gas of any part have a supply or a vent?
    #[must_use]
    pub fn has_lines(&self) -> bool {
        self.parts.iter().any(|part| match &part.kind {
            Kind::Flexible(body) => body.lines.iter().any(Option::is_some),
            _ => false,
        })
    }

    /// The part and the gas line, `supply` or `vent`, that this input of a controller sets although the scene opens it.
    #[must_use]
    pub fn opened(&self, input: &str) -> Option<(&str, &'static str)> {
        self.parts.iter().find_map(|part| {
            let Kind::Flexible(body) = &part.kind else { return None };
            let driven = input.strip_prefix(part.name.as_str())?.strip_prefix('.')?;
            let lines = ["supply", "vent"].into_iter().zip(&body.lines);
            let opened = lines.filter(|(_, line)| line.as_ref().is_some_and(|own| own.opening > 0.0));
            opened
                .map(|(name, _)| name)
                .find(|name| [name, "valves"].contains(&driven))
                .map(|name| (&*part.name, name))
        })
    }

    /// Refuses contacts between parts that no force moves.
    ///
    /// # Errors
    /// The names of the first two, and their place.
    pub fn refuse_immovable_pairs(&self, is_immovable: impl Fn(usize) -> bool) -> Result<(), Failure> {
        let fixed = |contact: &Contact| contact.between.iter().all(|part| is_immovable(*part));
        let Some(number) = self.contacts.iter().position(fixed) else { return Ok(()) };
        let [one, other] = self.contacts[number].between.map(|part| &self.parts[part].name);
        let error = Diagnostic::error(format!(
            "contacts: `{one}` and `{other}` are both fixed or follow commands, so that no force keeps them apart"
        ));
        let error = error.label(self.places.contact(number), "neither can give way");
        Err(self.places.failure(error.help("leave the pair out, or let one of them move")))
    }

    /// Does the world consist of rigid bodies alone, with impacts located in time?
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        let rigid = self.parts.iter().all(|part| matches!(part.kind, Kind::Rigid(_)));
        rigid && self.contacts.iter().all(|contact| matches!(contact.law, Law::Located(_)))
    }
}

impl Run {
    /// Number of steps in the run, the last one perhaps shorter; a remainder below a thousandth of a step is rounding.
    #[must_use]
    pub fn steps(&self) -> usize {
        let whole = (self.seconds / self.step - 1e-3).ceil().max(0.0) as usize;
        if self.seconds > 0.0 { whole.max(1) } else { 0 }
    }

    /// Length of step `n`, counted from 1 (s).
    #[must_use]
    pub fn length(&self, n: usize) -> f64 {
        let left = self.seconds - (n - 1) as f64 * self.step;
        if n == self.steps() && left < (1.0 - 1e-3) * self.step { left } else { self.step }
    }
}
