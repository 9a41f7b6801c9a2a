//! Bounds of a policy beyond a plan's limits: how many bladders may be low at once, and the support of the others.
//!
//! In: a plan with the moves of a policy, and the area that a body reaches. Out: the first bound that is exceeded.
//! Pressures change linearly in time, so that only the ends of moves and the end of the run are checked.

use crate::map::{Grid, MMHG};
use crate::plan::check::Refusal;
use crate::plan::{Layout, Plan};

/// Bounds of a policy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Largest number of bladders that are low at once.
    pub most_low: usize,
    /// Below this pressure (Pa) a bladder counts as low.
    pub low: f64,
    /// Smallest value of sum p A, over the area that the body reaches, relative to its weight.
    pub support: f64,
}

impl Default for Bounds {
    fn default() -> Bounds {
        Bounds { most_low: 4, low: 2.5e3, support: 1.2 }
    }
}

impl Bounds {
    /// Checks all orders from a time on.
    ///
    /// # Errors
    /// [`Refusal`], the first.
    pub fn check(&self, plan: &Plan, from: f64, reach: &[f64], weight: f64) -> Result<(), Refusal> {
        let ends = plan.moves.iter().flat_map(|m| [m.at, m.at + m.over]);
        let mut times: Vec<f64> =
            ends.chain([from, plan.seconds]).filter(|t| (from..=plan.seconds).contains(t)).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        for time in times {
            let pressures: Vec<f64> =
                (0..plan.layout.count()).map(|tile| plan.order(tile, time).pressure).collect();
            self.of(&pressures, reach, weight).map_err(|what| Refusal { time, tile: None, what })?;
        }
        Ok(())
    }

    /// Checks the pressures (Pa) of all tiles at one time.
    ///
    /// # Errors
    /// The bound that they exceed.
    pub fn of(&self, pressures: &[f64], reach: &[f64], weight: f64) -> Result<(), String> {
        let low = pressures.iter().filter(|p| **p < self.low).count();
        if low > self.most_low {
            let (limit, most) = (self.low / 1e3, self.most_low);
            return Err(format!("{low} bladders are below {limit:.2} kPa, expected {most} at most"));
        }
        let carried: f64 = pressures.iter().zip(reach).map(|(p, a)| p * a).sum();
        if carried < self.support * weight {
            return Err(format!(
                "bladders in reach can carry {carried:.0} N, expected at least {} times the weight of {weight:.0} N",
                self.support
            ));
        }
        Ok(())
    }
}

/// The area that a body reaches: sensels that were ever in contact, and their neighbours.
#[derive(Clone, Debug, Default)]
pub struct Reach {
    touched: Vec<bool>,
}

impl Reach {
    /// Adds the sensels in contact in a map.
    pub fn widen(&mut self, layout: &Layout, grid: &Grid, pressure: &[f64]) {
        debug_assert_eq!(grid.columns, layout.columns * layout.intervals[0]);
        self.touched.resize(grid.sites(), false);
        for (site, _) in pressure.iter().enumerate().filter(|(_, p)| **p > 5.0 * MMHG) {
            let (row, column) = (site / grid.columns, site % grid.columns);
            for j in row.saturating_sub(1)..(row + 2).min(grid.rows) {
                for i in column.saturating_sub(1)..(column + 2).min(grid.columns) {
                    self.touched[j * grid.columns + i] = true;
                }
            }
        }
    }

    /// Projected area of each tile (m^2) that is reached. Bulging does not increase it, and it only grows while the
    /// body moves, so that sufficient support stays sufficient.
    #[must_use]
    pub fn areas(&self, layout: &Layout, grid: &Grid) -> Vec<f64> {
        let mut areas = vec![0.0; layout.count()];
        for (site, _) in self.touched.iter().enumerate().filter(|(_, touched)| **touched) {
            areas[tile_of(layout, grid, site)] += grid.cell();
        }
        areas
    }
}

/// The tile under a sensel.
#[must_use]
pub fn tile_of(layout: &Layout, grid: &Grid, site: usize) -> usize {
    let [across, along] = layout.intervals;
    let (line, column) = (site / grid.columns, site % grid.columns);
    (layout.rows - 1 - line / along) * layout.columns + column / across
}
