//! A planner that relieves, a few at a time, the tiles on which skin has been occluded during the whole cycle, and no
//! others.
//!
//! In: sensor readings, step by step. Out: moves. A sensel is occluded as long as every frame of the cycle so far
//! exceeds the pressure that capillaries withstand. In each slot of a cycle the tiles with the most occluded area are
//! relieved, as many as limits and bounds allow, held, and brought back. The smallest motion is tried first: the
//! bladder is deflated; if that was in vain the tile is lowered too, and finally also tilted, with the occluded side
//! down, as far as limits allow. The area of a tile that was relieved in vain counts half the next time.

use super::bounds::tile_of;
use super::{Policy, View};
use crate::map::MMHG;
use crate::plan::Move;

/// Largest number of additional motions: lowering, and tilting too.
const MOST: u32 = 2;

/// Parameters of a planner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Length of a cycle (s).
    pub cycle: f64,
    /// Number of slots in a cycle.
    pub slots: usize,
    /// Time to deflate, and to inflate (s).
    pub ramp: f64,
    /// Time held low (s).
    pub hold: f64,
    /// Low pressure (Pa).
    pub low: f64,
    /// Occluded area (m^2) below which a tile is left alone.
    pub least: f64,
    /// Distance by which a tile is lowered (m); 0 for none.
    pub lower: f64,
    /// Slope of a tile that tilts; 0 for none.
    pub tilt: f64,
}

impl Default for Goal {
    fn default() -> Goal {
        Goal {
            cycle: 600.0,
            slots: 10,
            ramp: 10.0,
            hold: 40.0,
            low: 1.6e3,
            least: 2e-4,
            lower: 0.015,
            tilt: 0.035,
        }
    }
}

/// The state of a planner.
#[derive(Clone, Debug)]
pub struct Planner {
    goal: Goal,
    /// Smallest reading of each sensel in this cycle (Pa).
    lowest: Vec<f64>,
    /// How often each tile was relieved in this cycle.
    tried: Vec<u32>,
    /// Times at which the next slot and the next cycle begin (s), counted from when the planner last acted, so that the
    /// moves of one slot are finished in the next.
    next: [f64; 2],
}

/// The occluded area of a tile.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Shut {
    /// Area (m^2).
    area: f64,
    /// Its first moments about the tile's centre, in halves of the tile's sides.
    moments: [f64; 2],
}

impl Planner {
    /// A planner.
    #[must_use]
    pub fn new(goal: Goal) -> Planner {
        Planner { goal, lowest: Vec::new(), tried: Vec::new(), next: [0.0; 2] }
    }

    /// The occluded area of each tile.
    fn shut(&self, view: &View<'_>) -> Vec<Shut> {
        let mut found = vec![Shut::default(); view.layout.count()];
        for (site, _) in self.lowest.iter().enumerate().filter(|(_, p)| **p > 32.0 * MMHG) {
            let own = &mut found[tile_of(view.layout, view.grid, site)];
            let area = view.sites[site].area;
            own.area += area;
            let at = [site % view.grid.columns, site / view.grid.columns];
            for ((moment, at), count) in own.moments.iter_mut().zip(at).zip(view.layout.intervals) {
                *moment += area * (2.0 * (at % count) as f64 / count as f64 - 1.0);
            }
        }
        found
    }

    /// The moves that relieve a tile now, with `much` additional motions, and bring it back after the hold.
    fn relief(&self, view: &View<'_>, tile: usize, shut: &Shut, much: u32) -> [Move; 2] {
        let Goal { ramp, hold, low, lower, tilt, .. } = self.goal;
        let order = &view.orders[tile];
        let told =
            |at: f64| Move { at, over: ramp, tiles: vec![tile], pressure: None, heave: None, slope: None };
        let (mut down, mut back) = (told(view.time), told(view.time + ramp + hold));
        (down.pressure, back.pressure) = (Some(low), Some(order.pressure));
        if lower > 0.0 && much >= 1 {
            (down.heave, back.heave) = (Some(order.command.heave - lower), Some(order.command.heave));
        }
        if tilt > 0.0 && much >= 2 {
            // The slope raises the side towards which it points, so it points away from the occluded skin.
            let size = shut.moments[0].hypot(shut.moments[1]).max(f64::MIN_POSITIVE);
            let slope = order.command.slope;
            down.slope = Some([0, 1].map(|k| slope[k] - tilt * shut.moments[k] / size));
            back.slope = Some(slope);
        }
        [down, back]
    }

    /// Moves of a slot: tiles by occluded area, each only if limits and bounds still hold with it.
    fn chosen(&self, view: &View<'_>) -> Vec<Move> {
        let shut = self.shut(view);
        let hope = |tile: &usize| shut[*tile].area * 0.5_f64.powi(self.tried[*tile] as i32);
        let mut order: Vec<usize> = (0..shut.len()).filter(|t| shut[*t].area > self.goal.least).collect();
        order.sort_by(|a, b| hope(b).total_cmp(&hope(a)).then(a.cmp(b)));
        let mut chosen: Vec<Move> = Vec::new();
        for tile in order {
            // Neighbours must take over what a relieved tile no longer carries: they are not relieved themselves.
            let is_chosen = |other: usize| chosen.iter().any(|told| told.tiles.contains(&other));
            if view
                .layout
                .neighbours()
                .any(|(a, b, _)| (a == tile && is_chosen(b)) || (b == tile && is_chosen(a)))
            {
                continue;
            }
            // Tries the amount of motion that the tile needs by now, then less if a limit forbids it.
            for much in (0..=self.tried[tile].min(MOST)).rev() {
                let before = chosen.len();
                chosen.extend(self.relief(view, tile, &shut[tile], much));
                if (view.allows)(&chosen) {
                    break;
                }
                chosen.truncate(before);
            }
        }
        chosen
    }
}

impl Policy for Planner {
    fn decide(&mut self, view: &View<'_>) -> Vec<Move> {
        // Tolerance, because times are sums of steps.
        let is_due = |at: f64| view.time >= at - 1e-6;
        if is_due(self.next[1]) {
            self.lowest = vec![f64::INFINITY; view.frame.pressure.len()];
            self.tried = vec![0; view.layout.count()];
            self.next[1] = view.time + self.goal.cycle;
        }
        for (least, p) in self.lowest.iter_mut().zip(&view.frame.pressure) {
            *least = least.min(*p);
        }
        if !is_due(self.next[0]) {
            return Vec::new();
        }
        self.next[0] = view.time + self.goal.cycle / self.goal.slots as f64;
        let moves = self.chosen(view);
        // Each tile has two moves: there and back.
        for tile in moves.iter().step_by(2).flat_map(|told| &told.tiles) {
            self.tried[*tile] += 1;
        }
        moves
    }
}
