//! What sensors decide: a policy sees a map now and then and tells tiles what to do.
//!
//! In: a plan, a [`Policy`], its [`bounds`], the surface that it sees through. Out: the run, and every move that was told. What a
//! policy tells is held against the plan's limits, the bounds and the tiles' [`Supervisor`] before any tile hears of it; what
//! exceeds them ends the run by name. [`scheduled`] plays moves known beforehand, alternating pressure among them, [`planner`] looks for relief.

pub mod bounds;
pub mod planner;
pub mod run;
pub mod scheduled;

use crate::map::{Frame, Grid, Site};
use crate::plan::check::Refusal;
use crate::plan::{Layout, Move, Order, Plan};

/// What a policy sees at a time.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// s.
    pub time: f64,
    /// Tiles.
    pub layout: &'a Layout,
    /// Where sensels lie.
    pub grid: &'a Grid,
    /// Their areas.
    pub sites: &'a [Site],
    /// What they read.
    pub frame: &'a Frame,
    /// What tiles are told at this time.
    pub orders: &'a [Order],
    /// Area of each tile that a body reaches (m^2), and its weight (N).
    pub reach: &'a [f64],
    /// N.
    pub weight: f64,
    /// Would these moves keep to the plan's limits and the bounds, beside all that is told already?
    pub allows: &'a dyn Fn(&[Move]) -> bool,
}

/// Who decides.
pub trait Policy {
    /// Moves that begin now or later.
    fn decide(&mut self, view: &View<'_>) -> Vec<Move>;
}

/// Who lets orders through to the tiles, beyond the plan's own limits.
pub trait Supervisor {
    /// Holds all that is told from a time (s) on against what it lets through.
    ///
    /// # Errors
    /// [`Refusal`], the first.
    fn check(&self, plan: &Plan, from: f64) -> Result<(), Refusal>;
}
