//! The interface to whatever moves a world: columns, state, energies, pictures, steps.
//!
//! One engine moves worlds of rigid parts alone (`rigid`), the other one everything else (`carried`).

use super::accounts::Accounts;
use super::picture::Picture;
use crate::engine::ScalarKind;
use smartbed_runtime::vec3::Vec3;

/// A value in each row.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Column {
    /// `load.z`, `tile.hA`.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Is it shown unless columns are chosen?
    pub by_default: bool,
}

/// Stored energies, and accounts of dissipation and work (J).
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Energies {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy of weight.
    pub gravity: f64,
    /// Potential energy of springs, in mechanisms and flexible bodies.
    pub spring: f64,
    /// Potential energy of gas.
    pub pressure: f64,
    /// Dissipated by dampers.
    pub damping: f64,
    /// Dissipated by air drag.
    pub drag: f64,
    /// Dissipated by impacts.
    pub impact: f64,
    /// Dissipated by friction between impacts.
    pub friction: f64,
    /// Work of drives and actuators, and of gas that flows in.
    pub actuator: f64,
}

/// Names of the accounts, in the order in which they follow the state in a row.
pub const ACCOUNTS: [&str; 11] = [
    "kinetic",
    "gravity",
    "spring",
    "pressure",
    "damping",
    "drag",
    "impact",
    "friction",
    "actuator",
    "total",
    "imbalance",
];

impl Energies {
    /// Total stored energy.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.gravity + self.spring + self.pressure
    }

    /// The energy imbalance: what no account explains since the start, when the energy was `start`.
    #[must_use]
    pub fn imbalance(&self, start: f64) -> f64 {
        self.total() - start - self.actuator + self.damping + self.drag + self.impact + self.friction
    }

    /// In the order of [`ACCOUNTS`].
    #[must_use]
    pub fn numbers(&self, start: f64) -> [f64; 11] {
        [
            self.kinetic,
            self.gravity,
            self.spring,
            self.pressure,
            self.damping,
            self.drag,
            self.impact,
            self.friction,
            self.actuator,
            self.total(),
            self.imbalance(start),
        ]
    }
}

/// A pair of parts that came into contact.
#[derive(Clone, PartialEq, Debug)]
pub struct Event {
    /// Time (s).
    pub time: f64,
    /// The two parts, by index.
    pub parts: [usize; 2],
    /// Number of points in contact.
    pub points: usize,
    /// Largest speed of approach (m/s).
    pub approach: f64,
    /// Sum of the normal impulses (N s).
    pub impulse: f64,
}

/// Result of a relaxation to equilibrium.
#[derive(Clone, PartialEq, Debug)]
pub struct Settled {
    /// Steps of relaxation.
    pub steps: usize,
    /// Largest remaining acceleration (m/s^2).
    pub acceleration: f64,
    /// The part that a small disturbance moves away from there, if there is one.
    pub unstable: Option<String>,
}

impl Settled {
    /// Says that the equilibrium is unstable, if it is: no fault of the numbers, which warnings are of.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        let part = self.unstable.as_ref()?;
        Some(format!(
            "note: settle: `{part}` is balanced in an unstable equilibrium: a disturbance of 1e-6 m or less grew tenfold, so that \
             a real machine does not stay there; move its `start` to the side on which it should come to rest"
        ))
    }
}

/// The message for a checkpoint of another world.
#[must_use]
pub fn other_world() -> String {
    "the checkpoint belongs to another scene: its parts, or their nodes, chambers of gas or contacts, are others".to_owned()
}

/// The interface of an engine.
pub trait Engine {
    /// The columns of a row's state.
    fn columns(&self) -> Vec<Column>;
    /// Their present values.
    ///
    /// # Errors
    /// A message if a value cannot be computed.
    fn state(&mut self) -> Result<Vec<f64>, String>;
    /// Energies and accounts now.
    ///
    /// # Errors
    /// As [`Engine::state`].
    fn energies(&mut self) -> Result<Energies, String>;
    /// Present positions of everything, part by part.
    ///
    /// # Errors
    /// As [`Engine::state`].
    fn picture(&mut self) -> Result<Picture, String>;
    /// Takes a step of h (s); events have their own times.
    ///
    /// # Errors
    /// The reason why it cannot go on, and advice; the state is that before the step.
    fn step(&mut self, h: f64, events: &mut Vec<Event>) -> Result<(), String>;
    /// Inputs that controllers may drive: valves `PART.supply`, `PART.vent`, `PART.valves`, inputs of mechanisms
    /// `PART.INPUT`.
    fn inputs(&self) -> Vec<String> {
        Vec::new()
    }
    /// Holds an input, given by its index, at a value until it is set again.
    fn set_input(&mut self, _input: usize, _value: f64) {}
    /// Moves to static equilibrium, from the start.
    ///
    /// # Errors
    /// A message if there is none or it is not found.
    fn settle(&mut self) -> Result<Settled, String> {
        Err("settle: scenes of rigid parts alone are not supported; `run` it until it rests, with impact = \
             \"plastic\" against bouncing, or take impact = \"moreau\""
            .to_owned())
    }
    /// Keeps accounts of each part and each seam from here on.
    fn keep_accounts(&mut self);
    /// These accounts now.
    ///
    /// # Errors
    /// As [`Engine::state`]; without [`Engine::keep_accounts`].
    fn accounts(&mut self) -> Result<Accounts, String>;
    /// All values that a checkpoint needs.
    fn save(&self) -> Vec<f64>;
    /// Restores the values of [`Engine::save`].
    ///
    /// # Errors
    /// Values of another world.
    fn load(&mut self, numbers: &[f64]) -> Result<(), String>;
    /// The number of values at the end of [`Engine::save`] that say for how long parts have been slow; [`Engine::load`]
    /// takes a state without them, whose parts are all awake.
    fn sleepers(&self) -> usize {
        0
    }
    /// The scalar in which the world moves.
    fn scalar(&self) -> ScalarKind {
        ScalarKind::F64
    }
    /// The middle of each rigid part that is free or fixed in space (m); the origin for the others.
    fn middles(&self) -> Vec<Vec3<f64>>;
    /// The largest number (J) of which a stored energy is the small difference: p V of a sealed gas.
    fn largest_term(&self) -> f64 {
        0.0
    }
    /// Names of the mechanisms, and the smallest pivot of each so far, relative to nominal.
    fn pivots(&self) -> Vec<(&str, f64)> {
        Vec::new()
    }
    /// A mechanism of which steps of one length hide what a load, a law or a command does, in a run over so many seconds
    /// with a step (s); and the time (s) near which.
    fn passed(&self, _run: [f64; 2]) -> Option<(&str, f64)> {
        None
    }
    /// Warnings to be shown at the end.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }
    /// The method, as text.
    fn method(&self) -> String;
}
