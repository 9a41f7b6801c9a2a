//! What sensors decide: a policy sees a map now and then and tells tiles what to do.
//!
//! In: a plan, a [`Policy`], [`Bounds`], the surface that it sees through. Out: the run, and every move that was told. What a
//! policy tells is held against the plan's limits and the bounds before any tile hears of it; what exceeds them ends the run
//! by name. [`scheduled`] plays moves known beforehand, alternating pressure among them, [`planner`] looks for relief.

pub mod bounds;
pub mod planner;
pub mod scheduled;

pub use bounds::Bounds;

use crate::map::{Frame, Grid, Site};
use crate::plan::check::check_from;
use crate::plan::run::{self, History, RunError, Seen};
use crate::plan::{Layout, Move, Order, Plan};
use crate::sensor::reader::Reader;
use bounds::Reach;

/// What a policy sees at a time.
#[derive(Clone, Copy, Debug)]
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
}

/// Who decides.
pub trait Policy {
    /// Moves that begin now or later.
    fn decide(&mut self, view: &View<'_>) -> Vec<Move>;
}

/// Runs a plan under a policy; `reader` is what it sees through, nothing for the truth. `at` hears the share that is done and
/// says whether to go on.
///
/// # Errors
/// [`RunError`]; [`RunError::Refused`] for a policy that exceeds a limit.
pub fn run(
    plan: &Plan,
    policy: &mut dyn Policy,
    bounds: &Bounds,
    reader: Option<&Reader>,
    at: impl FnMut(f64) -> bool,
) -> Result<History, RunError> {
    let (mut reach, mut number) = (Reach::default(), 0);
    let mut decide = |seen: &Seen<'_>| {
        let frame = reader.map_or_else(|| seen.frame.clone(), |reader| reader.frame(number, seen.frame));
        number += 1;
        reach.widen(&seen.plan.layout, seen.grid, &frame.pressure);
        let areas = reach.areas(&seen.plan.layout, seen.grid, seen.sites);
        let weight = plan.load.body.mass() * crate::equilibrium::GRAVITY;
        let orders: Vec<Order> =
            (0..plan.layout.count()).map(|tile| seen.plan.order(tile, seen.frame.time)).collect();
        let view = View {
            time: seen.frame.time,
            layout: &seen.plan.layout,
            grid: seen.grid,
            sites: seen.sites,
            frame: &frame,
            orders: &orders,
            reach: &areas,
            weight,
        };
        let moves = policy.decide(&view);
        let told = seen.plan.with(&moves);
        if !moves.is_empty() {
            check_from(&told, view.time)?;
        }
        bounds.check(&told, view.time, &areas, weight)?;
        Ok(moves)
    };
    run::run_by(plan, &mut decide, at)
}
