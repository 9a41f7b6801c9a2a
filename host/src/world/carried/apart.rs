//! An engine that steps groups of parts separately while they are apart.
//!
//! In: a world of flexible parts. Out: an engine that steps it group by group (`islands`), or the world itself if it is
//! one group; state, rows, energies and pictures are the world's own.

use super::CarriedWorld;
use super::islands::Islands;
use crate::world::accounts::Accounts;
use crate::world::engine::{self, Column, Energies, Engine, Event, Settled};
use crate::world::picture::Picture;
use smartbed_runtime::vec3::Vec3;

/// A world and the grouping of its parts.
#[derive(Clone, Debug)]
struct Apart {
    world: CarriedWorld,
    islands: Islands,
}

/// The engine of a world in which everything slower than `sleep` (m/s, rad/s) is frozen.
#[must_use]
pub fn engine(world: CarriedWorld, sleep: Option<f64>) -> Box<dyn Engine> {
    match Islands::new(&world, sleep) {
        Some(islands) => Box::new(Apart { world, islands }),
        None => Box::new(world),
    }
}

impl Engine for Apart {
    fn columns(&self) -> Vec<Column> {
        self.world.columns()
    }

    fn state(&mut self) -> Result<Vec<f64>, String> {
        self.world.state()
    }

    fn energies(&mut self) -> Result<Energies, String> {
        self.world.energies()
    }

    fn picture(&mut self) -> Result<Picture, String> {
        self.world.picture()
    }

    fn step(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        self.islands.step(&mut self.world, h, found)?;
        self.world.watch_chatter()
    }

    fn inputs(&self) -> Vec<String> {
        self.world.inputs()
    }

    fn set_input(&mut self, input: usize, value: f64) {
        if let Some(part) = self.world.drive_input(input, value) {
            self.islands.wake(part);
        }
    }

    fn settle(&mut self) -> Result<Settled, String> {
        self.islands.forget();
        self.world.settle()
    }

    fn keep_accounts(&mut self) {
        self.islands.forget();
        self.world.keep_accounts();
    }

    fn accounts(&mut self) -> Result<Accounts, String> {
        self.world.accounts()
    }

    fn save(&self) -> Vec<f64> {
        [&self.world.save(), self.islands.save()].concat()
    }

    fn load(&mut self, numbers: &[f64]) -> Result<(), String> {
        let awake = vec![0.0; self.sleepers()];
        let (world, slow) = match numbers.len().checked_sub(self.world.save().len()) {
            Some(0) => (numbers, awake.as_slice()),
            Some(left) if left == awake.len() => numbers.split_at(numbers.len() - left),
            _ => return Err(engine::other_world()),
        };
        self.world.load(world)?;
        self.islands.load(slow);
        Ok(())
    }

    fn sleepers(&self) -> usize {
        self.islands.save().len()
    }

    fn pivots(&self) -> Vec<(&str, f64)> {
        self.world.pivots()
    }

    fn passed(&self, run: [f64; 2]) -> Option<(&str, f64)> {
        self.world.passed(run)
    }

    fn warnings(&self) -> Vec<String> {
        self.world.warnings()
    }

    fn middles(&self) -> Vec<Vec3<f64>> {
        self.world.middles()
    }

    fn largest_term(&self) -> f64 {
        self.world.largest_term()
    }

    fn method(&self) -> String {
        self.world.method()
    }
}
