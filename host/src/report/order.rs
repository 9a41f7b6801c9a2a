//! Observed order of a method on a subject: the slope of its line in a double logarithmic plot, over the part that is
//! straight.
//!
//! Fixed steps: error over step. Adaptive: error over force evaluations, falling. Only errors are used that are below a
//! thousandth of the motion (coarser runs are not yet asymptotic) and above 100 times the rounding or the reference's
//! own uncertainty, whichever is larger.

use super::front::slope;
use super::point::{Control, Point, Section, Table};
use super::subject::Method;

/// Errors above this fraction of the motion are not asymptotic.
const COARSE: f64 = 1e-3;
/// Errors below this multiple of the rounding say nothing about the order.
const ROUNDINGS: f64 = 100.0;
/// An adaptive run is left out if the next finer one takes hardly more evaluations (less than this factor), or has
/// hardly less error: it was limited by something other than its tolerance, for example by the stable step.
const MORE: f64 = 1.05;
const LESS: f64 = 3.0;

/// A method's order on a subject.
#[derive(Clone, PartialEq, Debug)]
pub struct Order {
    /// Its name.
    pub method: String,
    /// Its theoretical order on this subject.
    pub nominal: u32,
    /// The observed slope.
    pub observed: f64,
    /// Number of points used.
    pub points: usize,
}

/// Orders of all methods with two points or more on their line, in f64.
#[must_use]
pub fn observe(section: &Section, methods: &[Method]) -> Vec<Order> {
    let order = |method: &Method| {
        let line = line(section, method);
        let observed = slope(&line)?;
        Some(Order { method: method.name.clone(), nominal: method.order, observed, points: line.len() })
    };
    methods.iter().filter_map(order).collect()
}

/// (step or its equivalent, error) of the points used.
fn line(section: &Section, method: &Method) -> Vec<(f64, f64)> {
    let least = ROUNDINGS * section.reference.agreement.max(f64::EPSILON * section.extent);
    let of_method = |p: &&Point| p.method == method.name && p.scalar == "f64";
    let mut line: Vec<(f64, f64)> = Vec::new();
    for point in section.points.iter().filter(of_method) {
        let x = match (point.control, point.evaluations) {
            (Some(Control::Step(h)), _) => h,
            (Some(Control::Tolerance(_)), Some(evaluations)) => 1.0 / evaluations,
            _ => continue,
        };
        let limited = |(last_x, last_error): (f64, f64)| MORE * x > last_x || LESS * point.error > last_error;
        if method.adaptive && line.last().copied().is_some_and(limited) {
            line.pop();
        }
        if point.error >= least && point.error <= COARSE * section.extent {
            line.push((x, point.error));
        }
    }
    line
}

/// Slopes of fewer points are not shown.
const SHOWN: usize = 3;

/// Observed orders of all subjects: a row per subject, a column per method.
#[must_use]
pub fn table(title: &str, rows: &[(String, Vec<Order>)], command: &str) -> Table {
    let mut names: Vec<(&str, u32)> = Vec::new();
    for order in rows.iter().flat_map(|(_, orders)| orders).filter(|o| o.points >= SHOWN) {
        match names.iter_mut().find(|(name, _)| *name == order.method) {
            // The theoretical order may be lower on a subject whose forces depend on speeds: the largest is shown.
            Some((_, nominal)) => *nominal = order.nominal.max(*nominal),
            None => names.push((&order.method, order.nominal)),
        }
    }
    let mut columns = vec!["subject".to_owned()];
    columns.extend(names.iter().map(|(name, nominal)| format!("{name} ({nominal})")));
    let row = |(subject, orders): &(String, Vec<Order>)| {
        let mut row = vec![subject.clone()];
        row.extend(names.iter().map(|(name, _)| {
            let found = orders.iter().find(|o| o.method == *name && o.points >= SHOWN);
            found.map_or("-".to_owned(), |o| format!("{:.2}", o.observed))
        }));
        row
    };
    let rows = rows.iter().map(row).collect();
    Table { title: title.to_owned(), columns, rows, command: command.to_owned() }
}
