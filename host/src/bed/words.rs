//! A run in plain words, for people at the bed: what it will do (preview), and what it has done (report of the day).
//!
//! In: plan, history, metrics. Out: lists of sentences, with numbers in a nurse's everyday units: minutes, mmHg, cm².
//! The patient's score is the nurse's own entry and is not computed.

use crate::plan::Read;
use smartbed_bed::map::{MMHG, Recording, Region};
use smartbed_bed::metrics::braden::{Braden, SUBSCALES};
use smartbed_bed::metrics::report::Row;
use smartbed_bed::metrics::time;
use smartbed_bed::plan::history::History;
use smartbed_bed::plan::{Move, Plan, states};

/// Pressure above which capillaries close (Pa).
const SHUT: f64 = 32.0 * MMHG;
/// Most moves that a preview lists one by one.
const MOST: usize = 12;

/// `1, 2 and 7`.
fn listed(tiles: &[usize]) -> String {
    let numbers: Vec<String> = tiles.iter().map(|tile| (tile + 1).to_string()).collect();
    match numbers.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("tiles {} and {last}", rest.join(", ")),
        Some((last, _)) => format!("tile {last}"),
        None => "no tile".to_owned(),
    }
}

/// `90 s`, `3 min`, `2 h 5 min`.
fn clock(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        0..=119 => format!("{whole} s"),
        120..=7199 if whole.is_multiple_of(60) => format!("{} min", whole / 60),
        120..=7199 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole % 3600 / 60),
    }
}

/// One move as a sentence.
fn sentence(change: &Move, count: usize) -> String {
    let tiles = if change.tiles.len() == count { "all tiles".to_owned() } else { listed(&change.tiles) };
    let mut does = Vec::new();
    if let Some(pressure) = change.pressure {
        does.push(format!("go to {:.0} mmHg", pressure / MMHG));
    }
    if let Some(heave) = change.heave {
        does.push(format!("move to {:.0} mm", 1e3 * heave));
    }
    if let Some([x, y]) = change.slope {
        does.push(format!("tilt to {:.1} degrees", x.hypot(y).atan().to_degrees()));
    }
    format!("After {}: {tiles} {}, within {}.", clock(change.at), does.join(" and "), clock(change.over))
}

/// Whether the figures are reliable, by the validity checks.
pub(super) fn gate(gate: &[Row]) -> String {
    let said = gate.iter().map(|row| {
        let number = |x: Option<f64>| x.map_or_else(|| "-".to_owned(), |x| format!("{x:.1e}"));
        let unit = if row.unit == "1" { String::new() } else { format!(" {}", row.unit) };
        format!("{} {}{unit} (at most {})", row.metric, number(row.value), number(row.threshold))
    });
    let verdict = if states::is_valid(gate) { "Valid" } else { "NOT VALID" };
    format!("{verdict}: {}.", said.collect::<Vec<_>>().join(", "))
}

/// The orders during the plan; under a policy those that it has given.
pub(super) fn preview(plan: &Plan, history: &History) -> Vec<String> {
    let count = plan.layout.count();
    let mut lines = vec![format!(
        "The bed works for {}; every bladder begins at {:.0} mmHg.",
        clock(plan.seconds),
        plan.pressure / MMHG
    )];
    lines.extend(history.moves.iter().take(MOST).map(|change| sentence(change, count)));
    if history.moves.len() > MOST {
        lines.push(format!("And {} more changes of this kind.", history.moves.len() - MOST));
    }
    let tilt = history.moments.iter().flat_map(|m| &m.orders).map(|o| o.command.tilt()).fold(0.0, f64::max);
    lines.push(if tilt > 0.0 {
        format!("Largest tilt: {:.1} degrees. Look at lines and drains before it begins.", tilt.to_degrees())
    } else {
        "No tile tilts.".to_owned()
    });
    lines.push(
        "Stroke, speed, steps between tiles, pressure and support were checked before it began.".to_owned(),
    );
    lines
}

/// The part of a recording in one region.
fn part(skin: &Recording, region: Region) -> Option<Recording> {
    let sites: Vec<usize> =
        (0..skin.sites().len()).filter(|i| skin.sites()[*i].region == Some(region)).collect();
    (!sites.is_empty()).then(|| skin.select(&sites))
}

/// What happened, as sentences.
pub(super) fn report(read: &Read, history: &History) -> Vec<String> {
    let plan = &read.plan;
    let mut lines = Vec::new();
    let mut never = Vec::new();
    for region in Region::ALL {
        let Some(skin) = part(&history.skin, region) else { continue };
        let above = time::relief(&skin, SHUT).into_iter().map(|below| 1.0 - below).fold(0.0, f64::max);
        if above <= 0.0 {
            never.push(region.name());
            continue;
        }
        let always = 1e4 * time::always_at_risk(&skin, SHUT);
        lines.push(format!(
            "{}: above 32 mmHg for {} at the spot that bore most; {always:.0} cm² had no relief.",
            region.name(),
            clock(above * skin.seconds())
        ));
    }
    if !never.is_empty() {
        lines.push(format!("Never above 32 mmHg: {}.", never.join(", ")));
    }
    let bottomed: Vec<usize> = (0..plan.layout.count())
        .filter(|tile| history.moments.iter().any(|m| m.bottomed.get(*tile).is_some_and(|n| *n > 0)))
        .collect();
    lines.push(if bottomed.is_empty() {
        "Alarms: none.".to_owned()
    } else {
        format!("Alarms: the bladder of {} touched its plate; it needs more air.", listed(&bottomed))
    });
    let changes: usize = history.moves.iter().filter(|m| m.pressure.is_some()).map(|m| m.tiles.len()).sum();
    let motions: usize = history
        .moves
        .iter()
        .filter(|m| m.heave.or(m.slope.map(|s| s[0])).is_some())
        .map(|m| m.tiles.len())
        .sum();
    lines.push(format!(
        "The bed changed a bladder's pressure {changes} times and moved a tile {motions} times."
    ));
    lines.push(
        read.braden.map_or_else(|| "Braden: to be entered by the nurse.".to_owned(), |own| braden(&own)),
    );
    lines
}

/// The nurse's entry, which is shown next to the results and does not enter any number.
pub(super) fn braden(braden: &Braden) -> String {
    let marks = SUBSCALES.iter().zip(braden.marks());
    let marks: Vec<String> =
        marks.map(|((name, _), mark)| format!("{} {mark}", name.replace('_', " "))).collect();
    format!(
        "Braden, as the nurse entered it: {} of 23, {} ({}).",
        braden.sum(),
        braden.band(),
        marks.join(", ")
    )
}
