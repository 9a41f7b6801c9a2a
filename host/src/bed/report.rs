//! The rows of a run's report.
//!
//! In: the plan as it was read, and its history. Out: how far the run is from what it must keep, metrics of sensels and
//! of the skin, states of the tiles.

use crate::plan::{Read, sensing};
use smartbed_bed::metrics::Thresholds;
use smartbed_bed::metrics::report::{Report, Row};
use smartbed_bed::plan::history::History;
use smartbed_bed::plan::states;

/// All metrics: of sensels, and of the skin.
pub(crate) fn metrics(read: &Read, history: &History) -> [(&'static str, Vec<Row>); 2] {
    let thresholds = Thresholds { cycle: read.plan.cycle, ..Thresholds::default() };
    let friction = read.plan.layout.friction;
    let of = |recording, grid| Report { recording, grid, thresholds, friction }.rows();
    [("sensels", of(&history.sensels, Some(&history.grid))), ("skin", of(&history.skin, None))]
}

/// What the plan's sensors read in the end, if it has some.
pub(crate) fn sensed(read: &Read, history: &History) -> Option<sensing::Read> {
    read.sensors.as_ref()?.of(history)
}

/// The gate of the run: what of it is how far from what it must keep.
pub(crate) fn gate(read: &Read, history: &History) -> Vec<Row> {
    states::gate(history, sensed(read, history).map(|sensed| sensed.error))
}

/// What is no map: the gate, and what neighbours do to each other.
pub(crate) fn of_run(read: &Read, history: &History) -> Vec<Row> {
    gate(read, history).into_iter().chain([states::drag(&read.plan, history)]).collect()
}

/// All rows of a report: of the run, of sensels, of the skin and of each tile.
pub(super) fn all_rows(read: &Read, history: &History) -> [(&'static str, Vec<Row>); 4] {
    let [sensels, skin] = metrics(read, history);
    [("run", of_run(read, history)), sensels, skin, ("tiles", states::tiles(&read.plan, history))]
}
