//! Closed-loop control: a policy sees a map at intervals and orders moves of the tiles.
//!
//! In: a plan, a [`Policy`], its [`bounds`], the sensing surface. Out: the run, and every move that was ordered. Orders
//! of a policy are checked against the plan's limits, the bounds and the tiles' [`Supervisor`] before any tile receives
//! them; a violation ends the run by name. [`scheduled`] plays moves known beforehand, such as alternating pressure;
//! [`planner`] seeks relief.

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
    /// Time (s).
    pub time: f64,
    /// Geometry and limits of the tiles.
    pub layout: &'a Layout,
    /// Positions of the sensels.
    pub grid: &'a Grid,
    /// Their areas.
    pub sites: &'a [Site],
    /// Readings of the sensels.
    pub frame: &'a Frame,
    /// Present orders of the tiles.
    pub orders: &'a [Order],
    /// Area of each tile that the body reaches (m^2).
    pub reach: &'a [f64],
    /// Weight of the body (N).
    pub weight: f64,
    /// Would these moves, added to all orders so far, keep the plan's limits and the bounds?
    pub allows: &'a dyn Fn(&[Move]) -> bool,
}

/// A policy.
pub trait Policy {
    /// Decides on moves that begin now or later.
    fn decide(&mut self, view: &View<'_>) -> Vec<Move>;
}

/// A check of orders beyond the plan's own limits, before they reach the tiles.
pub trait Supervisor {
    /// Checks all orders from a time (s) on.
    ///
    /// # Errors
    /// [`Refusal`], the first.
    fn check(&self, plan: &Plan, from: f64) -> Result<(), Refusal>;
}
