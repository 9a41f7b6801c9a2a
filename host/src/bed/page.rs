//! The self-contained page of a run: the bed in space, maps of pressure and shear, tiles, a slider of time, words and
//! metrics.
//!
//! In: plan, history, metrics. Out: HTML. Texts of the plan are escaped in HTML and, in JSON, `<` is written as an
//! escape, so that none of them can end or begin a script.

use super::report::RunReport;
use super::{film, words};
use crate::number::json_string;
use crate::origin::Origin;
use crate::plan::Read;
use crate::plot::svg::escaped;
use crate::template::filled;
use crate::view::THREE;
use smartbed_bed::body::{Shape, Surface};
use smartbed_bed::metrics::DISCLAIMER;
use smartbed_bed::metrics::report::Row;
use smartbed_bed::plan::Plan;
use smartbed_bed::plan::history::History;
use std::fmt::Write as _;

const PAGE: &str = include_str!("page.html");
const SCRIPT: &str = include_str!("page.js");
/// Most triangles of a mesh that a page shows.
const MOST_TRIANGLES: usize = 4000;

/// The page's text.
pub fn text(origin: &Origin, read: &Read, history: &History, report: &RunReport) -> String {
    let plan = &read.plan;
    let parts = [
        ("TITLE", escaped(&plan.title)),
        ("GATE", escaped(&words::gate(&report.gate))),
        ("PREVIEW", list(&words::preview(plan, history))),
        ("REPORT", list(&words::report(read, history))),
        ("METRICS", tables(&report.lists)),
        ("ORIGIN", escaped(&origin.line(read))),
        ("DATA", data(plan, history)),
        ("THREE", THREE.to_owned()),
        ("SCRIPT", SCRIPT.to_owned()),
    ];
    filled(PAGE, &parts)
}

fn list(lines: &[String]) -> String {
    let lines: String = lines.iter().map(|line| format!("<li>{}</li>", escaped(line))).collect();
    format!("<ul>{lines}</ul>")
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

/// A segment's shape: half its sides and the radius of its edges, or a mesh's corners and triangles.
fn shape(surface: &Surface) -> String {
    match surface {
        Surface::Round(Shape { half: [a, b, c], radius }) => format!("[{a:.4},{b:.4},{c:.4},{radius:.4}]"),
        Surface::Mesh(solid) => {
            let mesh = solid.coarse(MOST_TRIANGLES);
            let corners: Vec<String> = mesh.corners.iter().flatten().map(|x| format!("{x:.4}")).collect();
            let triangles: Vec<String> = mesh.triangles.iter().flatten().map(usize::to_string).collect();
            format!("{{\"corners\":[{}],\"triangles\":[{}]}}", corners.join(","), triangles.join(","))
        }
    }
}

/// The fixed data as JSON, and frames as [`film::bytes`].
fn data(plan: &Plan, history: &History) -> String {
    let joined = |values: &mut dyn Iterator<Item = String>| values.collect::<Vec<_>>().join(",");
    let layout = &plan.layout;
    let [across, along] = layout.shown();
    let share =
        |nodes: &[usize], n: usize| joined(&mut nodes.iter().map(|k| format!("{:.4}", *k as f64 / n as f64)));
    let middles = joined(&mut (0..layout.count()).map(|tile| {
        let [x, y] = layout.middle(tile);
        format!("[{x:.4},{y:.4}]")
    }));
    let segments = joined(&mut plan.load.body.segments.iter().map(|segment| shape(&segment.shape)));
    let times = joined(&mut history.sensels.frames().iter().map(|frame| format!("{:.3}", frame.time)));
    let text = format!(
        "{{\"title\":{},\"note\":{},\"tiles\":[{},{}],\"size\":[{},{}],\"middles\":[{middles}],\"across\":[{}],\"along\":[{}],\
         \"segments\":[{segments}],\"times\":[{times}],\"frames\":\"{}\"}}",
        json_string(&plan.title),
        json_string(DISCLAIMER),
        layout.rows,
        layout.columns,
        layout.size()[0],
        layout.size()[1],
        share(&across, layout.intervals[0]),
        share(&along, layout.intervals[1]),
        film::bytes(plan, history)
    );
    text.replace('<', "\\u003c")
}
