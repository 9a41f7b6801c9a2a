//! The rows of a run's report.
//!
//! In: the plan as it was read, and its history. Out: validity checks of the run, metrics of sensels and of the skin,
//! states of the tiles.

use crate::plan::{Read, sensing};
use smartbed_bed::metrics::report::{Report, Row};
use smartbed_bed::plan::history::History;
use smartbed_bed::plan::states;

/// The contents of a report, each computed once.
pub(crate) struct RunReport {
    /// Readings of the plan's sensors at the end, if it has any.
    pub sensed: Option<sensing::Read>,
    /// Validity checks: residuals of the run with their limits.
    pub gate: Vec<Row>,
    /// Rows of the run (validity checks, stretch of skin between neighbours), of sensels, of the skin, of each tile.
    pub lists: [(&'static str, Vec<Row>); 4],
}

impl RunReport {
    pub fn new(read: &Read, history: &History) -> Self {
        let sensed = read.sensors.as_ref().and_then(|sensors| sensors.of(history));
        let gate = states::gate(history, sensed.as_ref().map(|sensed| sensed.error));
        let run = gate.iter().cloned().chain([states::drag(&read.plan, history)]).collect();
        let (thresholds, friction) = (read.thresholds, read.plan.layout.friction);
        let of = |recording, grid| Report { recording, grid, thresholds, friction }.rows();
        let lists = [
            ("run", run),
            ("sensels", of(&history.sensels, Some(&history.grid))),
            ("skin", of(&history.skin, None)),
            ("tiles", states::tiles(&read.plan, history)),
        ];
        Self { sensed, gate, lists }
    }

    /// Rows of the maps: of sensels, and of the skin.
    pub fn metrics(&self) -> &[(&'static str, Vec<Row>)] {
        &self.lists[1..3]
    }
}
