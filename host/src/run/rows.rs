//! What a row of a running world shows: names and values, the columns and curves of a plot, and texts of events.

use crate::failure::Failure;
use crate::plot::chart::{self, Chart, Curve};
use crate::plot::drawing::Drawing;
use crate::plot::panels::{self, Shown};
use crate::plot::{Recording, energies, pattern};
use crate::world::Assembly;
use crate::world::engine::{ACCOUNTS, Column, Event};
use crate::world::run::Row;
use smartbed_codegen::words::count;

/// Rounding error of a number of size 1: a touch is located to eps^(2/3) of the parts' size, and a run has many
/// touches.
const NOISE: f64 = 1e-8;

/// Names of a row's values.
pub(crate) fn names(assembly: &Assembly, columns: &[Column]) -> Vec<String> {
    let accounts = ACCOUNTS.iter().map(|name| (*name).to_owned());
    let sensors = assembly.sensors.iter().map(|sensor| format!("sensors.{}", sensor.name));
    let own = columns.iter().map(|c| c.name.clone());
    std::iter::once("t".to_owned()).chain(own).chain(accounts).chain(sensors).collect()
}

/// A row's values, in the order of [`names`].
pub(crate) fn values(row: &Row<'_>) -> Vec<f64> {
    let mut values = vec![row.t];
    values.extend(row.state);
    values.extend(row.energies.numbers(row.start));
    values.extend(row.readings);
    values
}

/// Indices of the columns that a plot shows.
pub(crate) fn shown(columns: &[Column], show: Option<&str>) -> Result<Vec<usize>, Failure> {
    let Some(patterns) = show else {
        return Ok((0..columns.len()).filter(|n| columns[*n].by_default).collect());
    };
    let names: Vec<&str> = columns.iter().map(|c| c.name.as_str()).collect();
    let chosen = pattern::chosen(patterns, &names)?;
    Ok((0..columns.len()).filter(|n| chosen.contains(&names[*n])).collect())
}

/// Curves of a recording of [`values`]: those of the columns that are shown, and energies.
pub(crate) fn drawing(
    assembly: &Assembly,
    columns: &[Column],
    shown: &[usize],
    recording: &Recording,
    note: &str,
    events: &[Event],
) -> Drawing {
    let curve = |name: &str, index: usize, unit: &str| Shown {
        curve: Curve {
            name: name.to_owned(),
            values: recording.column(index),
            color: energies::color(name),
            across: None,
        },
        unit: unit.to_owned(),
        natural: 0.0,
    };
    let state = shown.iter().map(|n| curve(&columns[*n].name, n + 1, &columns[*n].unit));
    let energies = ACCOUNTS.iter().enumerate().filter(|(_, name)| **name != "imbalance");
    let energies = energies.map(|(n, name)| curve(name, columns.len() + 1 + n, "J"));
    let told = |shown: &Shown| shown.unit != "J" || shown.curve.values.iter().any(|x| *x != 0.0);
    let panels = panels::of(state.chain(energies).filter(told).collect(), NOISE);
    let times: Vec<f64> = events.iter().map(|event| event.time).collect();
    let note = if times.is_empty() { note.to_owned() } else { format!("{note}; grey: touches") };
    let chart = Chart {
        title: &assembly.title,
        note: &note,
        across: "time [s]",
        time: &recording.column(0),
        panels: &panels,
        events: &times,
    };
    chart::draw(&chart)
}

/// Texts of events.
pub(super) fn told(events: &[Event], assembly: &Assembly) -> Vec<(f64, String)> {
    let words = |event: &Event| {
        let [one, other] = event.parts.map(|n| assembly.parts[n].name.as_str());
        let points = count(event.points, "point");
        let (approach, impulse) = (event.approach, event.impulse);
        // If touches are not located, the speed of approach is unknown.
        let approach = if approach.is_nan() { String::new() } else { format!(" {approach:.4} m/s,") };
        format!("{one} strikes {other} at {points},{approach} impulse {impulse:.4} N s")
    };
    events.iter().map(|event| (event.time, words(event))).collect()
}
