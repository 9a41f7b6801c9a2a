//! The energy ledger of a run, an observer in f64: stored energies, work put in and taken out, and the imbalance.
//!
//! imbalance = total - total at the start + damping - actuator - external - drive, with total = kinetic + gravity +
//! spring; it is 0 in exact arithmetic. Works are integrals of powers over each step by Simpson's rule; states inside a
//! step come from a cubic Hermite polynomial or from the method's own dense output.

use crate::columns::{ACCOUNTS, DRIVE};
use crate::observers::{LEDGER, Observers};
use crate::switches::Switches;
use smartbed_codegen::{Interpreted, Program};
use smartbed_runtime::mechanism::{Fault, Mechanism};

/// [`ACCOUNTS`], with `drive` after `external` if the mechanism is driven.
#[must_use]
pub fn columns(program: &Program) -> Vec<&'static str> {
    let mut names = ACCOUNTS.to_vec();
    if program.drive.is_some() {
        names.insert(DRIVE_AT, DRIVE);
    }
    names
}

/// Index of `drive`.
const DRIVE_AT: usize = 10;

/// Stored energies and accounts (J).
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Accounts {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Gravitational energy, zero at the origin.
    pub gravity: f64,
    /// Elastic energy of springs.
    pub spring: f64,
    /// Work taken out by loads that depend on speeds.
    pub damping: f64,
    /// Work put in by the inputs.
    pub actuator: f64,
    /// Work put in by other loads.
    pub external: f64,
    /// Work put in by the drive; `None` if the mechanism is not driven.
    pub drive: Option<f64>,
    /// kinetic + gravity + spring at the start.
    pub start: f64,
}

impl Accounts {
    /// Kinetic and stored energies.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.gravity + self.spring
    }

    /// Change of the total that no account explains.
    #[must_use]
    pub fn imbalance(&self) -> f64 {
        self.total() - self.start + self.damping - self.actuator - self.external - self.drive.unwrap_or(0.0)
    }

    /// The values of [`columns`].
    #[must_use]
    pub fn columns(&self) -> Vec<f64> {
        let (total, imbalance) = (self.total(), self.imbalance());
        let Self { kinetic, gravity, spring, damping, actuator, external, .. } = *self;
        let stored = [kinetic, gravity, spring, 0.0];
        let works = [damping, 0.0, 0.0, 0.0, actuator, external];
        stored.into_iter().chain(works).chain(self.drive).chain([total, imbalance]).collect()
    }
}

/// A state with the powers that the ledger integrates.
#[derive(Clone, Debug, Default)]
struct Moment {
    t: f64,
    x: Vec<f64>,
    x_dot: Vec<f64>,
    kinetic: f64,
    /// In the order of [`LEDGER`], then the power of the drive.
    entries: [f64; 6],
}

/// The ledger.
#[derive(Debug)]
pub struct Ledger {
    mechanism: Interpreted<f64>,
    observer: Interpreted<f64>,
    law: Interpreted<f64>,
    law_inputs: Vec<usize>,
    switches: Switches<f64>,
    /// Rounding of times of the run, relative: as far from where f64 has it a kink may be found.
    rounding: f64,
    inputs: Vec<f64>,
    last: Moment,
    accounts: Accounts,
}

impl Ledger {
    /// Opens the ledger at a state x = [q, u]; `rounding` of times of the run, relative.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the state does not have the program's length.
    pub fn open(
        program: &Program,
        observers: &Observers,
        (t, x): (f64, &[f64]),
        rounding: f64,
    ) -> Result<Self, Fault> {
        let mut ledger = Self {
            mechanism: Interpreted::new(program),
            observer: Interpreted::new(&observers.ledger()),
            law: Interpreted::new(&observers.laws()),
            law_inputs: observers.law_inputs.clone(),
            switches: Switches::new(observers),
            rounding,
            inputs: vec![0.0; program.inputs.len()],
            last: Moment::default(),
            accounts: Accounts::default(),
        };
        ledger.accounts.drive = program.drive.map(|_| 0.0);
        ledger.last = ledger.moment(t, x, 1.0)?;
        ledger.store();
        ledger.accounts.start = ledger.accounts.total();
        Ok(ledger)
    }

    /// The accounts at the last state.
    #[must_use]
    pub fn accounts(&self) -> Accounts {
        self.accounts
    }

    /// Books the step from the last state to (t, x), with a cubic in between.
    ///
    /// # Errors
    /// As [`Ledger::open`].
    pub fn step(&mut self, t: f64, x: &[f64]) -> Result<(), Fault> {
        let new = self.moment(t, x, -1.0)?;
        let h = t - self.last.t;
        let ends = self.last.x.iter().zip(&new.x).zip(self.last.x_dot.iter().zip(&new.x_dot));
        let middle: Vec<f64> =
            ends.map(|((a, b), (a_dot, b_dot))| 0.5 * (a + b) + 0.125 * h * (a_dot - b_dot)).collect();
        self.book(&[middle], new)
    }

    /// Books the step through the given intermediate states, equally spaced in time, an odd number of them.
    ///
    /// # Errors
    /// As [`Ledger::open`].
    pub fn step_through(&mut self, between: &[Vec<f64>], t: f64, x: &[f64]) -> Result<(), Fault> {
        let new = self.moment(t, x, -1.0)?;
        self.book(between, new)
    }

    /// Books a state behind a switch, up to which powers are those before and behind, half the time each: what else
    /// changes the energies is the work of a drive's impulse.
    ///
    /// # Errors
    /// As [`Ledger::open`].
    pub fn leap(&mut self, t: f64, x: &[f64]) -> Result<(), Fault> {
        let before = self.accounts.imbalance();
        let new = self.moment(t, x, 1.0)?;
        let half = 0.5 * (t - self.last.t);
        self.add(std::array::from_fn(|i| half * (self.last.entries[2 + i] + new.entries[2 + i])));
        self.last = new;
        self.store();
        let change = self.accounts.imbalance() - before;
        self.accounts.drive = self.accounts.drive.map(|work| work + change);
        Ok(())
    }

    /// Adds works (J) of actuators, dampers, external forces and drives.
    fn add(&mut self, [actuator, damping, external, drive]: [f64; 4]) {
        self.accounts.actuator += actuator;
        self.accounts.damping += damping;
        self.accounts.external += external;
        self.accounts.drive = self.accounts.drive.map(|work| work + drive);
    }

    /// Simpson's rule over the last state, the intermediate ones, and the new one.
    fn book(&mut self, between: &[Vec<f64>], new: Moment) -> Result<(), Fault> {
        let h = (new.t - self.last.t) / (between.len() + 1) as f64;
        let mut sums: [f64; 4] = std::array::from_fn(|i| self.last.entries[2 + i] + new.entries[2 + i]);
        for (n, x) in between.iter().enumerate() {
            let weight = if n % 2 == 0 { 4.0 } else { 2.0 };
            let t = self.switches.moment(self.last.t + (n + 1) as f64 * h)?;
            let entries = self.entries(t, x)?;
            sums.iter_mut().zip(&entries[2..]).for_each(|(sum, power)| *sum += weight * power);
        }
        self.add(sums.map(|sum| sum * h / 3.0));
        self.last = new;
        self.store();
        Ok(())
    }

    fn store(&mut self) {
        self.accounts.kinetic = self.last.kinetic;
        [self.accounts.gravity, self.accounts.spring] = [self.last.entries[0], self.last.entries[1]];
    }

    /// A state at the start (`way` = 1) or the end (-1) of a part in which nothing switches. Where f64 has a kink
    /// beyond what the run took for one, the side of that part counts.
    fn moment(&mut self, time: f64, x: &[f64], way: f64) -> Result<Moment, Fault> {
        let inside = time + way * 2.0 * self.rounding * time.abs();
        let beyond = self.switches.first(inside, time)?;
        let t = self.switches.moment(beyond.map_or(time, |[side, _]| side))?;
        let entries = self.entries(t, x)?;
        let (q, u) = x.split_at_checked(self.mechanism.n_q()).ok_or(Fault::Shape)?;
        let mut x_dot = vec![0.0; x.len()];
        let (q_dot, u_dot) = x_dot.split_at_mut(q.len());
        self.mechanism.rates(t, q, u, &self.inputs, q_dot, u_dot)?;
        let (kinetic, _) = self.mechanism.energy(q, u)?;
        Ok(Moment { t: time, x: x.to_vec(), x_dot, kinetic, entries })
    }

    /// The observer's outputs and the power of the drive; leaves the inputs commanded at (t, x) in `inputs`.
    fn entries(&mut self, t: f64, x: &[f64]) -> Result<[f64; 6], Fault> {
        let (q, u) = x.split_at_checked(self.mechanism.n_q()).ok_or(Fault::Shape)?;
        let commanded = self.law.outputs(t, q, u, &vec![0.0; self.inputs.len()])?;
        for (&input, value) in self.law_inputs.iter().zip(commanded) {
            self.inputs[input] = value;
        }
        let mut found = self.observer.outputs(t, q, u, &self.inputs)?;
        debug_assert_eq!(found.len(), LEDGER.len());
        found.push(self.mechanism.drive(t, q, u, &self.inputs)?);
        found.try_into().map_err(|_| Fault::Shape)
    }
}
