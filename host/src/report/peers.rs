//! Comparison with other simulators (peers): how much longer they take for the same error, and whether one of their
//! points dominates ours.
//!
//! A point dominates another if it is no worse in error and time, and better in one. All errors below the reference's
//! certainty ([`super::point::Reference::certainty()`]) are first raised to it, since smaller ones are not known.

use super::front;
use super::markdown::duration;
use super::point::{Point, Report, Section, Table};

/// Messages about peers' points that dominate one on our own front.
#[must_use]
pub fn dominating(report: &Report) -> Vec<String> {
    let of_section = |section: &Section| {
        let Sides { ours, peers } = Sides::of(section);
        peers.into_iter().filter(|p| beats(p, &ours)).map(|p| words(p, section)).collect::<Vec<_>>()
    };
    report.sections.iter().flat_map(of_section).collect()
}

/// For each method of a peer, how much longer its points take than our fastest with no larger error; `None` without
/// peers.
#[must_use]
pub fn table(report: &Report) -> Option<Table> {
    let columns = [
        "subject",
        "peer",
        "points",
        "its time over ours at its error",
        "where that is least",
        "points that dominate",
    ];
    let rows: Vec<Vec<String>> = report.sections.iter().flat_map(rows).collect();
    (!rows.is_empty()).then(|| Table {
        title: "Beside the peers".to_owned(),
        columns: columns.map(str::to_owned).to_vec(),
        rows,
        command: report.command.clone(),
    })
}

/// Our points of a section, and those of peers.
struct Sides<'a> {
    ours: Vec<&'a Point>,
    peers: Vec<&'a Point>,
}

impl<'a> Sides<'a> {
    fn of(section: &'a Section) -> Self {
        let (peers, ours) = section.points.iter().partition(|p| p.is_peer);
        Self { ours, peers }
    }
}

/// One row per method of a peer.
fn rows(section: &Section) -> Vec<Vec<String>> {
    let Sides { ours, peers } = Sides::of(section);
    let mut methods: Vec<&str> = peers.iter().map(|p| p.method.as_str()).collect();
    methods.sort_unstable();
    methods.dedup();
    let row = |method: &str| {
        let points: Vec<&Point> = peers.iter().copied().filter(|p| p.method == method).collect();
        let mut ratios: Vec<(f64, &Point, &Point)> = points
            .iter()
            .filter_map(|p| fastest(&ours, p.error).map(|own| (p.nanoseconds / own.nanoseconds, *p, own)))
            .collect();
        ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (range, least) = match (ratios.first(), ratios.last()) {
            (Some((low, p, own)), Some((high, ..))) => (format!("{low:.2} .. {high:.2}"), pair(p, own)),
            _ => ("-".to_owned(), "none of ours is as exact".to_owned()),
        };
        let dominate = points.iter().filter(|p| beats(p, &ours)).count();
        [
            section.name.clone(),
            method.to_owned(),
            points.len().to_string(),
            range,
            least,
            dominate.to_string(),
        ]
        .to_vec()
    };
    methods.into_iter().map(row).collect()
}

/// Our fastest point of at most this error.
fn fastest<'a>(ours: &[&'a Point], error: f64) -> Option<&'a Point> {
    let exact = ours.iter().copied().filter(|own| own.error <= error);
    exact.min_by(|a, b| a.nanoseconds.total_cmp(&b.nanoseconds))
}

/// Does it dominate one of the points on our own front?
fn beats(peer: &Point, ours: &[&Point]) -> bool {
    let on_front = |own: &&&Point| !ours.iter().any(|other| front::dominates(other, own));
    ours.iter().filter(on_front).any(|own| front::dominates(peer, own))
}

fn pair(peer: &Point, own: &Point) -> String {
    format!(
        "{} with {:.1e} against {} {}: {} with {:.1e}",
        duration(peer.nanoseconds),
        peer.error,
        own.method,
        own.scalar,
        duration(own.nanoseconds),
        own.error
    )
}

fn words(point: &Point, section: &Section) -> String {
    let control = point.control.map_or(String::new(), |c| format!(" {}", c.text()));
    let time = duration(point.nanoseconds);
    format!("{}: {}{control}, error {:.1e} in {time}", section.name, point.method, point.error)
}
