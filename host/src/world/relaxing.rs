//! Relaxation with kinetic damping, step by step.
//!
//! In: a world and a state. Out: the state after a step, without the velocities of parts whose kinetic energy fell.

use smartbed_runtime::mechanism::Fault;

/// A speed counts as an acceleration over this many steps.
const SLOW: f64 = 1e-3;

/// A world that can be relaxed. Its state x is coordinates, then speeds.
pub(super) trait Relaxing: Clone {
    /// The state.
    fn vector(&self) -> Vec<f64>;
    /// Index in the state at which speeds begin.
    fn split(&self) -> usize;
    /// Masses that belong to the speeds.
    fn masses(&self) -> Vec<f64>;
    /// By speed: the index of its part.
    fn owners(&self) -> Vec<usize>;
    /// Name of such a part.
    fn name(&self, owner: usize) -> String;
    /// Largest speed of a frame at the start (m/s or rad/s).
    fn fastest_frame(&self) -> f64;
    /// Length of gravity (m/s^2).
    fn gravity(&self) -> f64;
    /// Takes a step of free motion at the time of the start; `low` holds the rounding errors. Returns the step (s), and
    /// the speed with which overlapping parts leave one another, which is not part of their velocities (m/s, rad/s).
    fn advance(&mut self, x: &mut [f64], low: &mut [f64]) -> Result<(f64, f64), Fault>;
    /// Restarts at a state.
    fn restart(&mut self, x: Vec<f64>);
}

/// A motion on the way to rest.
#[derive(Clone, Debug)]
pub(super) struct Relaxation {
    /// Coordinates, then speeds.
    pub(super) x: Vec<f64>,
    low: Vec<f64>,
    n_q: usize,
    masses: Vec<f64>,
    owners: Vec<usize>,
    /// By part: power of its change of speed.
    power: Vec<f64>,
}

impl Relaxation {
    /// From a state, without its speeds.
    pub(super) fn from(world: &impl Relaxing, mut x: Vec<f64>) -> Self {
        let (n_q, masses, owners) = (world.split(), world.masses(), world.owners());
        x[n_q..].fill(0.0);
        let power = vec![0.0; owners.iter().max().map_or(0, |last| last + 1)];
        Self { low: vec![0.0; x.len()], x, n_q, masses, owners, power }
    }

    /// Coordinates.
    pub(super) fn places(&self) -> &[f64] {
        &self.x[..self.n_q]
    }

    /// Speeds.
    pub(super) fn speeds(&self) -> &[f64] {
        &self.x[self.n_q..]
    }

    /// Speeds, to be changed.
    pub(super) fn speeds_mut(&mut self) -> &mut [f64] {
        &mut self.x[self.n_q..]
    }

    /// The part with the largest speed.
    pub(super) fn fastest(&self) -> usize {
        let speeds = self.speeds().iter().zip(&self.owners);
        speeds.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).map_or(0, |(_, owner)| *owner)
    }

    /// Adds up by part the product of masses and squares of as many numbers as there are speeds.
    pub(super) fn weigh(&self, numbers: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.power.len()];
        for ((number, mass), owner) in numbers.iter().zip(&self.masses).zip(&self.owners) {
            sums[*owner] += mass * number * number;
        }
        sums
    }

    /// Largest acceleration at the present places, at rest, from the result of one step, and the step (s).
    pub(super) fn acceleration(&self, world: &mut impl Relaxing) -> Result<(f64, f64), Fault> {
        let mut tried = self.clone();
        tried.speeds_mut().fill(0.0);
        tried.low.fill(0.0);
        let (h, leaving) = world.advance(&mut tried.x, &mut tried.low)?;
        let speeds = tried.speeds().iter();
        Ok((speeds.fold(leaving / h * SLOW, |largest, speed| (speed / h).abs().max(largest)), h))
    }

    /// Takes a step; `watch` sees its length and the speeds after it. Returns the largest acceleration, for which
    /// speeds count as well.
    pub(super) fn step(
        &mut self,
        world: &mut impl Relaxing,
        mut watch: impl FnMut(f64, &[f64]),
    ) -> Result<f64, Fault> {
        let before = self.x[self.n_q..].to_vec();
        let (h, leaving) = world.advance(&mut self.x, &mut self.low)?;
        watch(h, &self.x[self.n_q..]);
        self.power.fill(0.0);
        let mut left = leaving / h * SLOW;
        for (n, (now, before)) in self.x[self.n_q..].iter().zip(&before).enumerate() {
            self.power[self.owners[n]] += self.masses[n] * now * (now - before);
            left = left.max(((now - before) / h).abs()).max((now / h).abs() * SLOW);
        }
        for (speed, owner) in self.x[self.n_q..].iter_mut().zip(&self.owners) {
            *speed = if self.power[*owner] < 0.0 { 0.0 } else { *speed };
        }
        Ok(left)
    }
}
