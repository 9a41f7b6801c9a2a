//! The output of a run of a plan: one JSON object, or lines and tables of text.
//!
//! In: the plan as it was read, and its history. Out: text.

use super::readings;
use super::report::RunReport;
use super::rows::{self, table};
use super::words;
use crate::number::{json_number, json_string, six_digits};
use crate::origin::{Origin, seeds_json};
use crate::plan::{Read, sensing};
use smartbed_bed::metrics::DISCLAIMER;
use smartbed_bed::metrics::braden::{Braden, SUBSCALES};
use smartbed_bed::metrics::report::Row;
use smartbed_bed::plan::history::{History, Watched};
use smartbed_bed::plan::states;
use std::fmt::Write as _;

/// One JSON object; with the file of the page, if there is one.
pub(super) fn json(
    origin: &Origin,
    page: Option<&str>,
    read: &Read,
    history: &History,
    report: &RunReport,
) -> String {
    let page = page.map_or_else(String::new, |file| format!("\"page\": {}, ", json_string(file)));
    let null = |x: Option<f64>| x.map_or_else(|| "null".to_owned(), json_number);
    let RunReport { sensed, gate, lists } = report;
    let lists = rows::json(lists);
    let [imbalance, felt] = worst(gate);
    let sensors = sensed.as_ref().map_or_else(|| "null".to_owned(), |sensed| {
        format!(
            "{{\"rows\": {}, \"columns\": {}, \"map_error\": {}, \"moisture\": {}, \"ph\": {}, \"mass\": {}}}",
            sensed.grid[0],
            sensed.grid[1],
            json_number(sensed.error),
            json_number(sensed.skin[0]),
            json_number(sensed.skin[1]),
            json_number(sensed.mass)
        )
    });
    let instruments = read.instruments.map(|own| readings::json(&own.of(&read.plan, history)));
    let instruments = instruments.unwrap_or_else(|| "null".to_owned());
    let policy = read.policy.map_or_else(|| "null".to_owned(), |policy| json_string(policy.name));
    let asked = history.lay.filter(|_| read.policy.is_some());
    format!(
        "{{{page}{}\"seeds\": {}, \"bed\": {}, \"moments\": {}, \"imbalance\": {}, \"sensed_error\": {}, \"valid\": {}, \
         \"sensors\": {sensors}, \"instruments\": {instruments}, \"policy\": {policy}, \"policy_from\": {}, \
         \"supervised\": {}, \"parts\": {}, \"over_pressure\": {}, \"moves\": {}, \"motion\": {}, \"braden\": {}, {}, \"note\": {}}}\n",
        origin.json(),
        seeds_json(read),
        json_string(&read.plan.title),
        history.moments.len(),
        json_number(imbalance),
        json_number(felt),
        states::is_valid(gate),
        null(asked),
        read.is_supervised,
        history.parts.map_or_else(|| "null".to_owned(), |parts| parts.to_string()),
        states::over(&read.plan, history).map_or_else(|| "null".to_owned(), over_json),
        history.moves.len(),
        history.watched.as_ref().map_or_else(|| "null".to_owned(), motion_json),
        read.braden.map_or_else(|| "null".to_owned(), braden_json),
        lists.join(", "),
        json_string(DISCLAIMER)
    )
}

/// The highest pressure, beyond the limit of the bladders.
fn over_json(over: states::Over) -> String {
    let [time, gauge] = [over.time, over.gauge].map(json_number);
    format!("{{\"tile\": {}, \"time\": {time}, \"gauge\": {gauge}}}", over.tile + 1)
}

/// The nurse's scores, their sum and its band.
fn braden_json(braden: Braden) -> String {
    let marks: String = SUBSCALES
        .iter()
        .zip(braden.marks())
        .map(|((name, _), mark)| format!("\"{name}\": {mark}, "))
        .collect();
    format!("{{{marks}\"sum\": {}, \"band\": {}}}", braden.sum(), json_string(braden.band()))
}

/// Largest relative difference from the weight over all moments: of the contact forces, and of the sensed load.
fn worst(gate: &[Row]) -> [f64; 2] {
    let value = |k: usize| gate.get(k).and_then(|row| row.value).unwrap_or(f64::NAN);
    [value(0), 0.01 * value(1)]
}

/// The moments of a run, counted.
fn moments(history: &History) -> String {
    match (history.moments.len(), history.watched.is_some()) {
        (1, true) => "1 moment".to_owned(),
        (1, false) => "1 equilibrium".to_owned(),
        (count, true) => format!("{count} moments"),
        (count, false) => format!("{count} equilibria"),
    }
}

/// The JSON object's additional part for a run with motion.
fn motion_json(watched: &Watched) -> String {
    format!(
        "{{\"step\": {}, \"steps\": {}, \"peak_force\": {}, \"peak_time\": {}, \"peak_window\": {}, \"still\": {}, \"touches\": {}, \
         \"energy_handed_on\": {}, \"energy_lost\": {}, \"energy_turned\": {}, \"energy_left_over\": {}}}",
        json_number(watched.step),
        watched.steps,
        json_number(watched.peak),
        json_number(watched.peak_time),
        json_number(watched.peak_window),
        watched.still.map_or_else(|| "null".to_owned(), json_number),
        watched.blows.touches,
        json_number(watched.blows.handed_on),
        json_number(watched.lost),
        json_number(watched.turned),
        json_number(watched.left_over)
    )
}

/// The text's additional part for a run with motion.
fn motion_text(watched: &Watched) -> String {
    if watched.steps == 0 {
        return "motion: no step, since run.seconds is 0: forces and maps are those of the start\n"
            .to_owned();
    }
    let rest = watched.still.map_or_else(
        || "it is not at rest at the end".to_owned(),
        |time| format!("slower than 1 mm/s from {time:.2} s on"),
    );
    format!(
        "motion: {} steps of {:.4} ms; the largest force over {} ms is {:.0} N at {:.3} s; {rest}; {} impacts pass \
         on {:.3} J; {:.3} J are dissipated, {:.1e} J are in no account\n",
        watched.steps,
        1e3 * watched.step,
        six_digits(1e3 * watched.peak_window),
        watched.peak,
        watched.peak_time,
        watched.blows.touches,
        watched.blows.handed_on,
        watched.lost,
        watched.left_over
    )
}

/// The output as text.
pub(super) fn text(read: &Read, history: &History, report: &RunReport) -> String {
    let RunReport { sensed, gate, .. } = report;
    let [imbalance, felt] = worst(gate);
    let mut text = format!(
        "{}: {} over {} s; contact forces balance the weight within {imbalance:.0e}, sensels measure it within \
         {:.2} %\n",
        read.plan.title,
        moments(history),
        read.plan.seconds,
        100.0 * felt
    );
    if let Some(parts) = history.parts {
        let _ = writeln!(
            text,
            "laid on in {parts} parts, as by run.parts = {parts}: put down at once, a part of the load would pass through \
             a sheet, or no equilibrium was found"
        );
    }
    if let Some(watched) = &history.watched {
        text += &motion_text(watched);
    }
    if let Some(policy) = read.policy {
        let through =
            if read.is_supervised { ", accepted by the tiles' controller and its supervisor" } else { "" };
        let asked = match history.lay {
            Some(0.0) => String::new(),
            Some(time) => format!(", which began at {time} s, when the load had come to rest"),
            None => ", which never began: the load did not come to rest".to_owned(),
        };
        let _ = writeln!(text, "policy {}: {} moves{through}{asked}", policy.name, history.moves.len());
    }
    if let Some(sensing::Read { grid: [rows, columns], error, skin, mass }) = sensed {
        let _ = writeln!(
            text,
            "{rows} x {columns} sensors of {mass:.3} kg in all read the last map to {:.2} %, moisture {:.1} %, pH {:.2}",
            100.0 * error,
            skin[0],
            skin[1]
        );
    }
    if let Some(own) = read.instruments {
        text += &readings::text(&own.of(&read.plan, history));
    }
    if let Some(braden) = read.braden {
        let _ = writeln!(text, "{}", words::braden(&braden));
    }
    for row in gate.iter().filter(|row| row.value > row.threshold) {
        let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:.1e}"));
        let (found, most, unit) = (number(row.value), number(row.threshold), row.unit);
        let help = if unit == "J" { ": NOT CLOSED, take shorter steps, `dynamics.step`" } else { "" };
        let _ = writeln!(text, "NOT VALID: {} {found} {unit}, expected at most {most}{help}", row.metric);
    }
    text += &table(report.metrics());
    let _ = writeln!(text, "\n{DISCLAIMER}");
    text
}
