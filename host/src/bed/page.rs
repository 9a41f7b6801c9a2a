//! The page of a run: pressure and shear maps, tiles, a slider of time, metrics, without anything from outside.
//!
//! In: plan, history, metrics. Out: HTML. What a plan says stands in it as text only: escaped in HTML, and as JSON in which
//! `<` is written as an escape, so that none of it can end a script or begin one.

use crate::number::json_string;
use crate::plot::svg::escaped;
use crate::template::filled;
use smartbed_bed::map::MMHG;
use smartbed_bed::metrics::DISCLAIMER;
use smartbed_bed::metrics::report::Row;
use smartbed_bed::plan::Plan;
use smartbed_bed::plan::run::History;
use std::fmt::Write as _;

const PAGE: &str = include_str!("page.html");

/// The page's text.
pub fn text(plan: &Plan, history: &History, metrics: &[(&'static str, Vec<Row>)]) -> String {
    let parts = [
        ("TITLE", escaped(&plan.title)),
        ("WORDS", words(plan, history, metrics)),
        ("METRICS", tables(metrics)),
        ("NOTE", DISCLAIMER.to_owned()),
        ("DATA", data(plan, history)),
    ];
    filled(PAGE, &parts)
}

/// What happened, in plain words.
fn words(plan: &Plan, history: &History, metrics: &[(&'static str, Vec<Row>)]) -> String {
    let skin = metrics.iter().find(|(sites, _)| *sites == "skin").map_or(&[][..], |(_, rows)| rows);
    let value = |place: &str, metric: &str| {
        skin.iter().find(|r| r.place == place && r.metric == metric).and_then(|r| r.value)
    };
    let mut text = String::from("<ul>");
    for place in ["occiput", "scapulae", "elbows", "sacrum", "ischia", "trochanters", "heels"] {
        let (Some(peak), Some(always)) = (value(place, "peak pressure"), value(place, "always at risk"))
        else {
            continue;
        };
        let relief = value(place, "time below 30 mmHg").unwrap_or(0.0);
        let _ = write!(
            text,
            "<li>{place}: {peak:.0} mmHg at the end; {relief:.0} % of the time below 30 mmHg on average; {always:.1} cm² of \
             skin never relieved</li>"
        );
    }
    let bottomed = history.moments.iter().filter(|m| m.bottomed.iter().any(|n| *n > 0)).count();
    if bottomed > 0 {
        let _ = write!(
            text,
            "<li>in {bottomed} of {} maps a bladder touches its plate</li>",
            history.moments.len()
        );
    }
    let moved = plan.moves.iter().flat_map(|m| &m.tiles).collect::<std::collections::BTreeSet<_>>().len();
    let _ = write!(text, "<li>{moved} of {} tiles were told to change</li></ul>", plan.layout.count());
    text
}

fn tables(metrics: &[(&'static str, Vec<Row>)]) -> String {
    let mut text = String::new();
    for (sites, rows) in metrics {
        let _ = write!(
            text,
            "<h3>{sites}</h3><table><tr><th>place<th>metric<th>value<th>unit<th>compared with</tr>"
        );
        for row in rows {
            let value = row.value.map_or_else(|| "–".to_owned(), |x| format!("{x:.3}"));
            let limit = row.threshold.map_or_else(String::new, |x| format!("{x:.1}"));
            let (place, metric, unit) = (row.place, row.metric, row.unit);
            let _ = write!(text, "<tr><td>{place}<td>{metric}<td>{value}<td>{unit}<td>{limit}</tr>");
        }
        text += "</table>";
    }
    text
}

/// Maps in whole mmHg and tenths of kPa, tiles in kPa, mm and degrees.
fn data(plan: &Plan, history: &History) -> String {
    let list =
        |values: &mut dyn Iterator<Item = String>| format!("[{}]", values.collect::<Vec<_>>().join(","));
    let frames = list(&mut history.sensels.frames().iter().zip(&history.moments).map(|(frame, moment)| {
        let pressure = list(&mut frame.pressure.iter().map(|p| format!("{:.0}", p / MMHG)));
        let shear = list(&mut frame.shear.iter().map(|s| format!("{:.0}", s[0].hypot(s[1]) / 100.0)));
        let tiles = list(&mut moment.orders.iter().zip(&moment.gauges).map(|(order, gauge)| {
            let tilt = order.command.tilt().to_degrees();
            format!("[{:.2},{:.1},{tilt:.1}]", gauge / 1e3, 1e3 * order.command.heave)
        }));
        format!("{{\"t\":{},\"p\":{pressure},\"s\":{shear},\"k\":{tiles}}}", frame.time)
    }));
    let grid = &history.grid;
    let (rows, columns) = (plan.layout.rows, plan.layout.columns);
    let text = format!(
        "{{\"title\":{},\"rows\":{},\"columns\":{},\"tiles\":[{rows},{columns}],\"pitch\":[{},{}],\"frames\":{frames}}}",
        json_string(&plan.title),
        grid.rows,
        grid.columns,
        grid.column_pitch,
        grid.row_pitch
    );
    text.replace('<', "\\u003c")
}
