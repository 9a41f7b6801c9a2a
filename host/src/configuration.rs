//! Complete configurations: left-out dependent coordinates are solved for.
//!
//! In: parameters and some coordinates. Out: all coordinates in the program's order. The branch is
//! the one connected to the nominal configuration; dependent coordinates given beside left-out ones
//! are start values. A complete configuration is returned as it is.

use smartbed_codegen::Program;
use smartbed_codegen::kinematics::{Assembly, Unreachable};
use smartbed_codegen::model::Model;

/// Most steps from the default parameters to others.
const MAX_STEPS: usize = 64;

/// Solver of configurations of one program.
#[derive(Clone, Debug)]
pub struct Configurations {
    assembly: Assembly,
    independent: Vec<bool>,
    nominal: Vec<f64>,
    defaults: Vec<f64>,
}

impl Configurations {
    /// For a program derived from `model`.
    #[must_use]
    pub fn new(model: &Model, program: &Program) -> Self {
        let is_independent = |name: &str| model.coordinates.iter().any(|c| c.name == name && c.independent);
        Self {
            assembly: program.assembly.clone(),
            independent: program.q.iter().map(|q| is_independent(&q.name)).collect(),
            nominal: program.nominal.clone(),
            defaults: program.parameters.iter().map(|p| p.value).collect(),
        }
    }

    /// Is the coordinate at this place independent?
    #[must_use]
    pub fn is_independent(&self, index: usize) -> bool {
        self.independent.get(index).copied().unwrap_or(false)
    }

    /// The nominal configuration at these parameters, reached from that at the default ones.
    ///
    /// # Errors
    /// If it cannot be assembled there.
    pub fn nominal_at(&mut self, parameters: &[f64]) -> Result<Vec<f64>, Unreachable> {
        if parameters == self.defaults {
            self.assembly.set_parameters(parameters);
            return Ok(self.nominal.clone());
        }
        let mut last = Unreachable { residual: f64::INFINITY };
        let mut steps = 1;
        while steps <= MAX_STEPS {
            match self.walk(parameters, steps) {
                Ok(q) => return Ok(q),
                Err(unreachable) => last = unreachable,
            }
            steps *= 4;
        }
        Err(last)
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

    /// All coordinates; `given[i]` is the value of the i-th one. A complete list comes back as it is.
    ///
    /// # Errors
    /// As [`Configurations::solve`].
    pub fn complete(&mut self, parameters: &[f64], given: &[Option<f64>]) -> Result<Vec<f64>, Unreachable> {
        match given.iter().copied().collect() {
            Some(q) => Ok(q),
            None => self.solve(parameters, given),
        }
    }

    /// Coordinates that meet the constraints: independent ones as given (left-out ones nominal),
    /// dependent ones solved for, from start values where given.
    ///
    /// # Errors
    /// If no dependent coordinates were found.
    pub fn solve(&mut self, parameters: &[f64], given: &[Option<f64>]) -> Result<Vec<f64>, Unreachable> {
        let nominal = self.nominal_at(parameters)?;
        let mut target = nominal.clone();
        for (i, value) in given.iter().enumerate() {
            if let (true, Some(value)) = (self.is_independent(i), value) {
                target[i] = *value;
            }
        }
        let reached = self.assembly.continue_to(&nominal, &target);
        let guessed = given.iter().enumerate().any(|(i, v)| v.is_some() && !self.is_independent(i));
        if !guessed {
            return reached;
        }
        let mut q = reached.unwrap_or(target);
        for (mine, value) in q.iter_mut().zip(given) {
            *mine = value.unwrap_or(*mine);
        }
        self.assembly.correct(&mut q)?;
        Ok(q)
    }
}
