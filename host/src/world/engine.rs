//! What moves a world, whatever it is made of: columns, state, energies, pictures, steps.
//!
//! One engine moves rigid parts alone (`rigid`), one everything else (`carried`).

use super::picture::Picture;

/// A number of a row.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Column {
    /// `load.z`, `tile.hA`.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Is it shown where nobody chooses?
    pub by_default: bool,
}

/// Energies stored and accounts of what went (J).
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Energies {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Of weight.
    pub gravity: f64,
    /// Of springs, of mechanisms and of flexible bodies.
    pub spring: f64,
    /// Of gas.
    pub gas: f64,
    /// Taken by damping and drag.
    pub damping: f64,
    /// Taken by impacts.
    pub impact: f64,
    /// Taken by friction between impacts.
    pub friction: f64,
    /// Given by drives and actuators.
    pub drive: f64,
}

/// Names of the accounts in a row's order, behind those of the state.
pub const ACCOUNTS: [&str; 10] =
    ["kinetic", "gravity", "spring", "gas", "damping", "impact", "friction", "drive", "total", "imbalance"];

impl Energies {
    /// All that is stored.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.gravity + self.spring + self.gas
    }

    /// What no account explains, of a run that began with `start`.
    #[must_use]
    pub fn imbalance(&self, start: f64) -> f64 {
        self.total() - start - self.drive + self.damping + self.impact + self.friction
    }

    /// In the order of [`ACCOUNTS`].
    #[must_use]
    pub fn numbers(&self, start: f64) -> [f64; 10] {
        let stored = [self.kinetic, self.gravity, self.spring, self.gas];
        let [kinetic, gravity, spring, gas] = stored;
        let (damping, impact) = (self.damping, self.impact);
        [
            kinetic,
            gravity,
            spring,
            gas,
            damping,
            impact,
            self.friction,
            self.drive,
            self.total(),
            self.imbalance(start),
        ]
    }
}

/// What happened at a time.
#[derive(Clone, PartialEq, Debug)]
pub struct Event {
    /// When (s).
    pub time: f64,
    /// The two parts, by number.
    pub parts: [usize; 2],
    /// Places that touched.
    pub points: usize,
    /// Largest speed of approach (m/s).
    pub approach: f64,
    /// Sum of the normal impulses (N s).
    pub impulse: f64,
}

/// How a world came to rest.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Settled {
    /// Steps of relaxation.
    pub steps: usize,
    /// Largest acceleration left (m/s^2).
    pub acceleration: f64,
}

/// The message for a checkpoint that does not fit.
#[must_use]
pub fn other_world() -> String {
    "the checkpoint is of another world: it has other parts than the scene".to_owned()
}

/// What moves a world.
pub trait Engine {
    /// The numbers of a row's state.
    fn columns(&self) -> Vec<Column>;
    /// Them now.
    ///
    /// # Errors
    /// What cannot be computed, in words.
    fn state(&mut self) -> Result<Vec<f64>, String>;
    /// Energies and accounts now.
    ///
    /// # Errors
    /// As [`Engine::state`].
    fn energies(&mut self) -> Result<Energies, String>;
    /// Where everything stands now, part by part.
    ///
    /// # Errors
    /// As [`Engine::state`].
    fn picture(&mut self) -> Result<Picture, String>;
    /// Goes a step of h (s); events have times of their own.
    ///
    /// # Errors
    /// Why it cannot go on, and what to do; the state is that before the step.
    fn step(&mut self, h: f64, events: &mut Vec<Event>) -> Result<(), String>;
    /// What controllers may drive: valves `PART.supply`, `PART.vent`, `PART.valves`, inputs of mechanisms `PART.INPUT`.
    fn inputs(&self) -> Vec<String> {
        Vec::new()
    }
    /// Holds an input, by its number among them, at a value until the next one.
    fn set_input(&mut self, _input: usize, _value: f64) {}
    /// Goes to static equilibrium from the start.
    ///
    /// # Errors
    /// Why there is none, in words.
    fn settle(&mut self) -> Result<Settled, String> {
        Err("settle: rigid parts alone come to rest by running: impact = \"plastic\" lets no bounce remain"
            .to_owned())
    }
    /// Everything that a run goes on from.
    fn save(&self) -> Vec<f64>;
    /// Goes on from what [`Engine::save`] gave.
    ///
    /// # Errors
    /// Numbers of another world.
    fn load(&mut self, numbers: &[f64]) -> Result<(), String>;
    /// What happened that should be known at the end.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }
    /// The method in words.
    fn method(&self) -> String;
}
