//! A planner: lets down, a few at a time, those bladders on which skin has been pressed shut all cycle, and no others.
//!
//! In: what sensors read, step by step. Out: moves. A sensel is shut while it has read more than capillaries bear in every
//! frame of the cycle so far. In each slot of a cycle those tiles with most shut area are let down, as many as bounds allow,
//! held, and filled again; what is let down once in vain counts half the next time. Nothing shut: nothing moves.

use super::bounds::{Bounds, tile_of};
use super::{Policy, View};
use crate::map::MMHG;
use crate::plan::Move;

/// What a planner goes by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Length of a cycle (s).
    pub cycle: f64,
    /// Slots of a cycle.
    pub slots: usize,
    /// Time to let down, and to fill (s).
    pub ramp: f64,
    /// Time held low (s).
    pub hold: f64,
    /// Low pressure (Pa).
    pub low: f64,
    /// A tile with less shut area (m^2) than this is left alone.
    pub least: f64,
}

impl Default for Goal {
    fn default() -> Goal {
        Goal { cycle: 600.0, slots: 10, ramp: 10.0, hold: 40.0, low: 1.6e3, least: 2e-4 }
    }
}

/// A planner at work.
#[derive(Clone, Debug)]
pub struct Planner {
    goal: Goal,
    bounds: Bounds,
    /// Least that each sensel has read in this cycle (Pa).
    lowest: Vec<f64>,
    /// How often each tile was let down in this cycle.
    tried: Vec<u32>,
    /// When the next slot and the next cycle begin (s).
    next: [f64; 2],
}

impl Planner {
    /// A planner that keeps to bounds.
    #[must_use]
    pub fn new(goal: Goal, bounds: Bounds) -> Planner {
        Planner { goal, bounds, lowest: Vec::new(), tried: Vec::new(), next: [0.0; 2] }
    }

    /// Shut area of each tile (m^2).
    fn shut(&self, view: &View<'_>) -> Vec<f64> {
        let mut areas = vec![0.0; view.layout.count()];
        for (site, _) in self.lowest.iter().enumerate().filter(|(_, p)| **p > 32.0 * MMHG) {
            areas[tile_of(view.layout, view.grid, site)] += view.sites[site].area;
        }
        areas
    }

    /// Tiles of a slot: by shut area, each only if bounds still hold with it.
    fn chosen(&self, view: &View<'_>) -> Vec<usize> {
        let shut = self.shut(view);
        let hope = |tile: &usize| shut[*tile] * 0.5_f64.powi(self.tried[*tile] as i32);
        let mut order: Vec<usize> = (0..shut.len()).filter(|tile| shut[*tile] > self.goal.least).collect();
        order.sort_by(|a, b| hope(b).total_cmp(&hope(a)).then(a.cmp(b)));
        let mut chosen = Vec::new();
        for tile in order {
            chosen.push(tile);
            if !self.bounds.allow(view, &chosen, self.goal.low) {
                chosen.pop();
            }
        }
        chosen
    }
}

impl Policy for Planner {
    fn decide(&mut self, view: &View<'_>) -> Vec<Move> {
        let Goal { cycle, slots, ramp, hold, low, .. } = self.goal;
        // Times are sums of steps: a step is not missed by rounding.
        let is_due = |at: f64| view.time >= at - 1e-6;
        if is_due(self.next[1]) {
            self.lowest = vec![f64::INFINITY; view.frame.pressure.len()];
            self.tried = vec![0; view.layout.count()];
            self.next[1] += cycle;
        }
        for (least, p) in self.lowest.iter_mut().zip(&view.frame.pressure) {
            *least = least.min(*p);
        }
        if !is_due(self.next[0]) {
            return Vec::new();
        }
        self.next[0] += cycle / slots as f64;
        let tiles = self.chosen(view);
        for tile in &tiles {
            self.tried[*tile] += 1;
        }
        let told = |at: f64, tile: usize, pressure: f64| Move {
            at,
            over: ramp,
            tiles: vec![tile],
            pressure: Some(pressure),
            heave: None,
            slope: None,
        };
        // Each is filled to what it had.
        let both = |tile: &usize| {
            [told(view.time, *tile, low), told(view.time + ramp + hold, *tile, view.orders[*tile].pressure)]
        };
        tiles.iter().flat_map(both).collect()
    }
}
