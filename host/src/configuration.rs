//! Completes configurations: solves for dependent coordinates that were left out.
//!
//! In: parameters and some coordinates. Out: all coordinates in the program's order, on the branch connected to the
//! nominal configuration. If only some dependent coordinates are given, their values are starting guesses. A complete
//! configuration is returned unchanged.

use smartbed_codegen::Program;
use smartbed_codegen::kinematics::{Assembly, Unreachable};
use smartbed_codegen::model::Model;

/// Most steps from the default parameters to others.
const MAX_STEPS: usize = 64;

/// Solves for configurations of one program.
#[derive(Clone, Debug)]
pub struct Configurations {
    assembly: Assembly,
    independent: Vec<bool>,
    nominal: Vec<f64>,
    defaults: Vec<f64>,
    /// Time (s) at which the constraints must hold.
    time: f64,
}

impl Configurations {
    /// For a program derived from `model`.
    #[must_use]
    pub fn new(model: &Model, program: &Program) -> Self {
        let declared = |name: &str| model.coordinates.iter().find(|c| c.name == name);
        Self {
            assembly: program.assembly.clone(),
            independent: program.q.iter().map(|q| declared(&q.name).is_some_and(|c| c.independent)).collect(),
            nominal: program.nominal.clone(),
            defaults: program.parameters.iter().map(|p| p.value).collect(),
            time: 0.0,
        }
    }

    /// Is the coordinate with this index independent?
    #[must_use]
    pub fn is_independent(&self, index: usize) -> bool {
        self.independent.get(index).copied().unwrap_or(false)
    }

    /// Independent coordinates of unit length, such as Euler parameters: the places of each vector.
    #[must_use]
    pub fn unit_vectors(&self) -> &[Vec<usize>] {
        self.assembly.unit_vectors()
    }

    /// Continues from a configuration that satisfies the constraints at time `t` (s) to the independent coordinates of
    /// another, Euler parameters among them scaled to unit length.
    ///
    /// # Errors
    /// If it cannot be assembled there.
    pub fn follow(&mut self, t: f64, from: &[f64], target: &[f64]) -> Result<Vec<f64>, Unreachable> {
        self.assembly.set_time(t);
        let mut target = target.to_vec();
        self.assembly.to_unit_length(&mut target, |_| false);
        self.assembly.continue_to(from, &target)
    }

    /// The nominal configuration at these parameters and time 0, continued from the one at the default parameters.
    ///
    /// # Errors
    /// If it cannot be assembled there.
    pub fn nominal_at(&mut self, parameters: &[f64]) -> Result<Vec<f64>, Unreachable> {
        self.assembly.set_time(0.0);
        if parameters == self.defaults {
            self.assembly.set_parameters(parameters);
            return Ok(self.nominal.clone());
        }
        let mut last = Unreachable::default();
        let mut steps = 1;
        while steps <= MAX_STEPS {
            match self.walk(parameters, steps) {
                Ok(q) => return Ok(q),
                Err(unreachable) => last = unreachable,
            }
            steps *= 4;
        }
        self.assembly.set_parameters(parameters);
        Err(self.assembly.no_longer_implied(&self.nominal).unwrap_or(last))
    }

    /// The constraint that a configuration violates most: its name, its residual, and the share of its terms that this
    /// is.
    pub fn violation(&mut self, t: f64, parameters: &[f64], q: &[f64]) -> Option<(String, f64, f64)> {
        self.assembly.set_parameters(parameters);
        self.assembly.set_time(t);
        self.assembly.violation(q)
    }

    fn walk(&mut self, parameters: &[f64], steps: usize) -> Result<Vec<f64>, Unreachable> {
        let mut q = self.nominal.clone();
        for step in 1..=steps {
            let part = step as f64 / steps as f64;
            let on_the_way = self
                .defaults
                .iter()
                .zip(parameters)
                .map(|(from, to)| if step == steps { *to } else { from + part * (to - from) });
            let on_the_way: Vec<f64> = on_the_way.collect();
            self.assembly.set_parameters(&on_the_way);
            self.assembly.correct(&mut q)?;
        }
        Ok(q)
    }

    /// [`Configurations::complete`] at time `t` (s).
    ///
    /// # Errors
    /// As [`Configurations::solve`].
    pub fn complete_at(
        &mut self,
        t: f64,
        parameters: &[f64],
        given: &[Option<f64>],
    ) -> Result<Vec<f64>, Unreachable> {
        self.time = t;
        self.complete(parameters, given)
    }

    /// All coordinates; `given[i]` is the value of the i-th one. A complete list is returned unchanged.
    ///
    /// # Errors
    /// As [`Configurations::solve`].
    pub fn complete(&mut self, parameters: &[f64], given: &[Option<f64>]) -> Result<Vec<f64>, Unreachable> {
        match given.iter().copied().collect::<Option<Vec<f64>>>() {
            Some(q) => self.unlocked(parameters, q),
            None => self.solve(parameters, given),
        }
    }

    /// Checks that at parameters other than the default ones the mechanism is not locked in this configuration.
    fn unlocked(&mut self, parameters: &[f64], q: Vec<f64>) -> Result<Vec<f64>, Unreachable> {
        self.assembly.set_parameters(parameters);
        let locked = if parameters == self.defaults { None } else { self.assembly.locked(&q) };
        locked.map_or(Ok(q), Err)
    }

    /// Coordinates that satisfy the constraints: independent ones as given (left-out ones nominal, Euler parameters
    /// among them scaled to unit length), dependent ones solved for, with given values as starting guesses.
    ///
    /// # Errors
    /// If no dependent coordinates were found, or the mechanism is locked there.
    pub fn solve(&mut self, parameters: &[f64], given: &[Option<f64>]) -> Result<Vec<f64>, Unreachable> {
        match self.assembled(parameters, given) {
            Ok(q) => self.unlocked(parameters, q),
            Err(locked) if locked.locked => Err(locked),
            Err(on_the_way) => {
                Err(self.least(parameters, given).unwrap_or(Unreachable { on_the_way: true, ..on_the_way }))
            }
        }
    }

    /// The least residual at what is given, rather than at a place on the way there; `None` if it vanishes.
    fn least(&mut self, parameters: &[f64], given: &[Option<f64>]) -> Option<Unreachable> {
        self.assembly.set_parameters(parameters);
        self.assembly.set_time(self.time);
        let values = self.nominal.iter().zip(given);
        let mut q: Vec<f64> = values.map(|(nominal, given)| given.unwrap_or(*nominal)).collect();
        self.assembly.to_unit_length(&mut q, |i| given[i].is_some());
        self.assembly.least_residual(&q)
    }

    fn assembled(&mut self, parameters: &[f64], given: &[Option<f64>]) -> Result<Vec<f64>, Unreachable> {
        let mut nominal = self.nominal_at(parameters)?;
        if self.time != 0.0 {
            nominal = self.assembly.continue_in_time(&nominal, self.time)?;
        }
        self.assembly.complete(&nominal, given)
    }
}
