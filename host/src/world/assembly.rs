//! A world as plain data: what a scene of format 2 says, names resolved, numbers in SI units.
//!
//! Parts stand in the author's order; attachments and contacts name them by number.

use crate::scene::Lists;
use smartbed_codegen::model::Model;
use smartbed_runtime::gas::Line;
use smartbed_runtime::rigid::law;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::Shape;
use smartbed_runtime::world::Content;

/// Everything that a scene says.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// One line about it.
    pub title: String,
    /// Acceleration of free fall in N (m/s^2).
    pub gravity: [f64; 3],
    /// The parts.
    pub parts: Vec<Part>,
    /// Nodes of flexible parts that are held by others.
    pub attachments: Vec<Attachment>,
    /// Pairs of parts that touch, with their laws.
    pub contacts: Vec<Contact>,
    /// What is observed.
    pub sensors: Vec<Sensing>,
    /// What is controlled.
    pub controllers: Vec<Controlling>,
    /// How it is run.
    pub run: Run,
    /// What pictures show.
    pub view: View,
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
    /// What it is.
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
    /// Does its text give it a velocity? That of a mechanism is its model's.
    #[must_use]
    pub fn starts_in_motion(&self) -> bool {
        let moves = |v: &[f64; 3]| v.iter().any(|v| *v != 0.0);
        match &self.kind {
            Kind::Rigid(rigid) => moves(&rigid.start.velocity) || moves(&rigid.start.angular_momentum),
            Kind::Flexible(body) => body.lists.velocities.iter().any(moves),
            Kind::Mechanism(_) => false,
        }
    }
}

/// What a part is.
#[derive(Clone, Debug)]
pub enum Kind {
    /// Derived equations.
    Mechanism(Box<Mechanism>),
    /// Nodes, springs, facets.
    Flexible(Box<Flexible>),
    /// One rigid body, or a shape fixed in space.
    Rigid(Rigid),
}

/// A mechanism.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Its model, with what the scene commands.
    pub model: Model,
    /// Where its origin stands in N (m).
    pub place: [f64; 3],
}

/// A flexible body.
#[derive(Clone, Debug)]
pub struct Flexible {
    /// Nodes where they start, springs, facets. Attached nodes are fixed and without mass.
    pub lists: Lists,
    /// Viscous force of the air per node and speed (N s/m).
    pub air_drag: f64,
    /// Gas inside.
    pub gas: Option<Content<f64>>,
    /// Supply and vent of gas that keeps its mass else.
    pub lines: [Option<Line<f64>>; 2],
}

/// A rigid body.
#[derive(Clone, Debug)]
pub struct Rigid {
    /// Its shape about its centre of mass.
    pub shape: Shape<f64>,
    /// Its inertia; none if it is fixed in space or on a port.
    pub body: Option<RigidBody<f64>>,
    /// The mechanism and port that carry it, a surface without mass.
    pub on: Option<(usize, String)>,
    /// Where it starts; of a shape on a port its place there.
    pub start: RigidState<f64>,
}

/// Nodes held in a frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Attachment {
    /// The flexible part.
    pub part: usize,
    /// Its nodes.
    pub nodes: Vec<usize>,
    /// The part that holds them.
    pub to: usize,
    /// The port of a mechanism; none for a rigid body, whose own axes hold.
    pub port: Option<String>,
}

/// Two parts that may touch.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Contact {
    /// Their numbers.
    pub between: [usize; 2],
    /// The law between them.
    pub law: Law,
}

/// A law of contact.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Law {
    /// Impacts at located times, held contacts between: rigid parts alone.
    Located(law::Law<f64>),
    /// Without locating: Moreau's time stepping, for parts of every kind.
    Moreau {
        /// Newton's e at each point; energy is never created.
        restitution: f64,
        /// Coulomb's mu.
        friction: f64,
    },
}

/// A sensor: what it reads of the rows, and how wrong it is (numbers in the unit of what it reads).
#[derive(Clone, PartialEq, Debug)]
pub struct Sensing {
    /// Its name.
    pub name: String,
    /// The number of the rows that it reads.
    pub of: String,
    /// What the quantity becomes first.
    pub transducer: Transducer,
    /// From sample to sample (s); a step if left out.
    pub period: Option<f64>,
    /// From a sample to its reading (s).
    pub delay: f64,
    /// Standard deviation of the noise of a sample.
    pub noise: f64,
    /// Standard deviation of the bias.
    pub bias: f64,
    /// Change of the reading in a period.
    pub drift: f64,
    /// Step of the reading.
    pub resolution: f64,
    /// Least and largest reading.
    pub range: [f64; 2],
    /// The same seed makes the same readings.
    pub seed: u64,
}

/// A controller: PI with limits, held between its samples.
#[derive(Clone, PartialEq, Debug)]
pub struct Controlling {
    /// Its name.
    pub name: String,
    /// The number of the rows, or `sensors.NAME`, that it reads.
    pub reads: String,
    /// The input that it gives.
    pub drives: String,
    /// From sample to sample (s).
    pub period: f64,
    /// Targets from times on (s), first time first; in the unit of what it reads.
    pub target: Vec<[f64; 2]>,
    /// Output by error.
    pub gain: f64,
    /// Output by error and second.
    pub integral: f64,
    /// Output without error.
    pub bias: f64,
    /// Least and largest output.
    pub limits: [f64; 2],
}

impl Controlling {
    /// The target at a time.
    #[must_use]
    pub fn target_at(&self, t: f64) -> f64 {
        // A sample stands for the time of its step, whatever rounding says.
        let now = t + 1e-9 * self.period;
        self.target.iter().take_while(|[from, _]| *from <= now).last().map_or(0.0, |[_, value]| *value)
    }
}

/// What a quantity becomes before it is sampled.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Transducer {
    /// Itself.
    Plain,
    /// A place with a bend of its characteristic.
    Lvdt {
        /// Half its range.
        reach: f64,
        /// Largest deviation as a share of the reach.
        linearity: f64,
    },
    /// A membrane that lags (s).
    Pressure {
        /// Time constant (s).
        lag: f64,
    },
    /// 1 beyond a threshold, else 0.
    Switch {
        /// Where it closes, coming from below.
        closes: f64,
        /// How far below that it opens.
        hysteresis: f64,
        /// How long its contact chatters (s).
        chatter: f64,
    },
}

/// How a world is run.
#[derive(Clone, PartialEq, Debug)]
pub struct Run {
    /// Length (s).
    pub seconds: f64,
    /// Step (s).
    pub step: f64,
    /// Steps between two rows.
    pub every: usize,
    /// The method's name, if the scene chooses one.
    pub method: Option<String>,
    /// Does it begin in static equilibrium?
    pub settled: bool,
    /// Parts that are slower than this (m/s, rad/s) for 0.1 s stand still until something comes near them.
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

    /// Has gas of some part a supply or a vent?
    #[must_use]
    pub fn has_lines(&self) -> bool {
        self.parts.iter().any(|part| match &part.kind {
            Kind::Flexible(body) => body.lines.iter().any(Option::is_some),
            _ => false,
        })
    }

    /// Is it rigid bodies alone, with impacts at located times?
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        let rigid = self.parts.iter().all(|part| matches!(part.kind, Kind::Rigid(_)));
        rigid && !self.contacts.iter().any(|contact| matches!(contact.law, Law::Moreau { .. }))
    }
}

impl Run {
    /// Steps in the run, the last one perhaps shorter; a rest below a thousandth of a step is rounding.
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
