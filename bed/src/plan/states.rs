//! Rows of a report that are no maps: validity of the run, interaction between neighbours, final state of each tile.
//!
//! In: a plan and its history. Out: [`Row`]s like those of maps, for the whole run and for each tile.

use super::check::MOST_TILES;
use super::history::{GATE, History, Moment};
use super::{Move, Plan};
use crate::metrics::report::Row;
use crate::metrics::shear::differential_drag;
use std::fmt;

/// Largest error of sensed maps (%).
pub const FELT: f64 = 1.0;
/// Largest share of the kinetic or dissipated energy that the method may add or remove; beyond it the steps are too
/// long.
pub const OPEN: f64 = 0.05;
/// Energy (J) below which the energy balance is not judged.
const LITTLE: f64 = 1e-3;

const NAMES: [&str; MOST_TILES] = [
    "tile 1", "tile 2", "tile 3", "tile 4", "tile 5", "tile 6", "tile 7", "tile 8", "tile 9", "tile 10",
    "tile 11", "tile 12", "tile 13", "tile 14", "tile 15", "tile 16", "tile 17", "tile 18", "tile 19",
    "tile 20", "tile 21", "tile 22", "tile 23", "tile 24", "tile 25", "tile 26", "tile 27", "tile 28",
];

fn row(place: &'static str, metric: &'static str, value: f64, unit: &'static str, most: Option<f64>) -> Row {
    Row { place, metric, value: Some(value), unit, threshold: most }
}

/// Validity checks: contact forces against the weight, sensed load, the map that sensors `read` (its relative error),
/// and the energy that the method has added or removed.
#[must_use]
pub fn gate(history: &History, read: Option<f64>) -> Vec<Row> {
    let worst = |of: fn(&Moment) -> f64| history.moments.iter().map(of).fold(0.0, f64::max);
    let mut rows = vec![
        row("bed", "contact forces against the weight", worst(|m| m.imbalance), "1", Some(GATE)),
        row("bed", "sensed load against the weight", 100.0 * worst(|m| m.sensed), "%", Some(FELT)),
    ];
    rows.extend(read.map(|off| row("bed", "map that sensors read, off by", 100.0 * off, "%", Some(FELT))));
    rows.extend(history.watched.as_ref().map(|w| {
        let most = LITTLE.max(OPEN * w.lost.max(w.kinetic));
        row("bed", "energy left over", w.left_over, "J", Some(most))
    }));
    rows
}

/// Does every row of the validity checks keep its limit?
#[must_use]
pub fn is_valid(gate: &[Row]) -> bool {
    gate.iter().all(|row| row.value <= row.threshold)
}

/// A bladder under more pressure than it bears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Over {
    /// Index of the tile.
    pub tile: usize,
    /// When (s).
    pub time: f64,
    /// Gauge pressure (Pa).
    pub gauge: f64,
}

impl fmt::Display for Over {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Over { tile, time, gauge } = self;
        write!(f, "the sealed bladder of tile {} is at {:.2} kPa at {time:.4} s", tile + 1, 1e-3 * gauge)
    }
}

/// The highest pressure of a run, if it is above the limit of the bladders. Orders keep to that limit; a load raises
/// the pressure of sealed air beyond its order.
#[must_use]
pub fn over(plan: &Plan, history: &History) -> Option<Over> {
    let watched =
        history.watched.iter().map(|w| Over { tile: w.pressed_tile, time: w.pressed_time, gauge: w.pressed });
    let of = |moment: &Moment| {
        let time = moment.time;
        moment
            .gauges
            .iter()
            .enumerate()
            .map(move |(tile, gauge)| Over { tile, time, gauge: *gauge })
            .collect()
    };
    let all = history.moments.iter().flat_map(|moment| -> Vec<Over> { of(moment) }).chain(watched);
    // The first of several that are equal.
    let highest = all.reduce(|most, other| if other.gauge > most.gauge { other } else { most })?;
    (highest.gauge > plan.layout.most_pressure * (1.0 + 1e-9)).then_some(highest)
}

/// Largest stretch of skin between two neighbours at any moment: relative displacement of their rims divided by the
/// gap.
#[must_use]
pub fn drag(plan: &Plan, history: &History) -> Row {
    let layout = &plan.layout;
    let shift = |moment: &Moment, tile: usize| {
        let ([x, y], place) = (layout.middle(tile), layout.rim(tile, &moment.orders[tile].command).place);
        [place[0] - x, place[1] - y]
    };
    let of = |moment: &Moment| {
        let apart = |(a, b, _): (usize, usize, bool)| {
            differential_drag(shift(moment, a), shift(moment, b), layout.gap)
        };
        layout.neighbours().map(apart).fold(0.0, f64::max)
    };
    let most = history.moments.iter().map(of).fold(0.0, f64::max);
    row("bed", "differential drag of neighbours", most, "1", None)
}

/// For each tile its final state, the running time of its screws, and the work of lifting.
#[must_use]
pub fn tiles(plan: &Plan, history: &History) -> Vec<Row> {
    let Some(last) = history.moments.last() else { return Vec::new() };
    let whole = Plan { moves: history.moves.clone(), ..plan.clone() };
    let of = |tile: usize| {
        let (place, command) = (NAMES[tile], &last.orders[tile].command);
        [
            row(place, "heave", 1e3 * command.heave, "mm", Some(500.0 * plan.layout.stroke)),
            row(place, "tilt", command.tilt().to_degrees(), "deg", None),
            row(place, "pressure", 1e-3 * last.gauges[tile], "kPa", Some(1e-3 * plan.layout.most_pressure)),
            row(place, "load", last.borne[tile], "N", None),
            row(place, "motor duty", 100.0 * duty(&whole, tile), "%", None),
            row(place, "work of lifting", lifted(history, tile), "J", None),
        ]
    };
    (0..plan.layout.count().min(MOST_TILES)).flat_map(of).collect()
}

/// Share of the run during which a tile's screws turn. `plan` has all moves of the run.
fn duty(plan: &Plan, tile: usize) -> f64 {
    let command = |t: f64| plan.order(tile, t).command;
    let turns = |m: &&Move| m.tiles.contains(&tile) && (m.heave.is_some() || m.slope.is_some());
    // Between the times at which moves begin or end, be it before a later order ends them, a screw turns or stands.
    let moves = plan.moves.iter().filter(turns);
    let mut times: Vec<f64> =
        moves.flat_map(|m| [m.at, m.at + m.over].map(|t| t.min(plan.seconds))).collect();
    times.sort_by(f64::total_cmp);
    let turned: f64 = times
        .windows(2)
        .filter(|span| command(span[0]) != command(0.5 * (span[0] + span[1])))
        .map(|span| span[1] - span[0])
        .sum();
    if plan.seconds > 0.0 { turned / plan.seconds } else { 0.0 }
}

/// Work (J) of lifting what a tile carries: mean force of two moments times the height between them.
fn lifted(history: &History, tile: usize) -> f64 {
    let of = |pair: &[Moment]| {
        let way = pair[1].orders[tile].command.heave - pair[0].orders[tile].command.heave;
        0.5 * (pair[0].borne[tile] + pair[1].borne[tile]) * way.max(0.0)
    };
    history.moments.windows(2).map(of).fold(0.0, |sum, work| sum + work)
}
