//! Checks a plan against its limits: stroke and speed of the screws, steps and gaps between neighbours, pressures,
//! support.
//!
//! In: a plan. Out: the first limit that it exceeds, with tile and time. Orders change linearly in time, so that their
//! ends and the times of all equilibria are checked.

use super::{Layout, Order, Plan};
use crate::equilibrium::GRAVITY;
use crate::tile;
use std::fmt;

/// Support that the bladders must be able to give, relative to the weight.
const SUPPORT: f64 = 1.2;
/// Largest number of tiles of a bed.
pub const MOST_TILES: usize = 28;

/// A limit that a plan exceeds.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// When (s).
    pub time: f64,
    /// The tile, counted from 1; `None` for the bed as a whole.
    pub tile: Option<usize>,
    /// What is wrong.
    pub what: String,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.tile {
            Some(tile) => write!(f, "tile {tile} at {:.4} s: {}", self.time, self.what),
            None => write!(f, "at {:.4} s: {}", self.time, self.what),
        }
    }
}

impl std::error::Error for Refusal {}

/// Checks a plan.
///
/// # Errors
/// [`Refusal`], the first.
pub fn check(plan: &Plan) -> Result<(), Refusal> {
    check_from(plan, 0.0)
}

/// Checks a plan's orders from a time (s) to the end of its last move, after which nothing changes.
///
/// # Errors
/// [`Refusal`], the first.
pub fn check_from(plan: &Plan, from: f64) -> Result<(), Refusal> {
    let layout = &plan.layout;
    let ends = || plan.moves.iter().flat_map(|m| [m.at, m.at + m.over]);
    let last = ends().fold(from, f64::max).min(plan.seconds);
    let mut times: Vec<f64> = plan.times().into_iter().chain(ends()).collect();
    times.retain(|t| (from..=last).contains(t));
    times.push(from);
    times.sort_by(f64::total_cmp);
    times.dedup();
    let mut before: Option<(f64, Vec<Order>)> = None;
    for time in times {
        let orders: Vec<Order> = (0..layout.count()).map(|tile| plan.order(tile, time)).collect();
        for (tile, order) in orders.iter().enumerate() {
            let refuse = |what: String| Refusal { time, tile: Some(tile + 1), what };
            of_tile(layout, order).map_err(refuse)?;
            let arrived = plan.order_before(tile, time);
            if let Some((then, old)) = &before {
                of_speed(layout, &old[tile], &arrived, time - then).map_err(refuse)?;
            }
            // A plan may begin with any order; later a jump has no time, and so an infinite speed.
            if time > 0.0 {
                of_speed(layout, &arrived, order, 0.0).map_err(refuse)?;
            }
        }
        for (one, other, is_beside) in layout.neighbours() {
            between(layout, [(one, &orders[one]), (other, &orders[other])], is_beside)
                .map_err(|what| Refusal { time, tile: Some(one + 1), what })?;
        }
        capacity(plan, &orders).map_err(|what| Refusal { time, tile: None, what })?;
        before = Some((time, orders));
    }
    Ok(())
}

fn of_tile(layout: &Layout, order: &Order) -> Result<(), String> {
    let limit = 0.5 * layout.stroke;
    for (screw, height) in tile::heights(&order.command, layout.circle).into_iter().enumerate() {
        if height.abs() > limit * (1.0 + 1e-9) {
            let (screw, mm, most) = (screw + 1, 1e3 * height, 1e3 * limit);
            return Err(format!(
                "screw {screw} at {mm:.1} mm, expected at most {most:.1} mm up or down, its stroke"
            ));
        }
    }
    if !(0.0..=layout.most_pressure).contains(&order.pressure) {
        let (found, most) = (order.pressure / 1e3, layout.most_pressure / 1e3);
        return Err(format!("pressure of {found:.2} kPa, expected 0 to {most:.2} kPa"));
    }
    Ok(())
}

fn of_speed(layout: &Layout, old: &Order, new: &Order, seconds: f64) -> Result<(), String> {
    let [from, to] = [old, new].map(|order| tile::heights(&order.command, layout.circle));
    for (screw, (a, b)) in from.into_iter().zip(to).enumerate() {
        let speed = (b - a).abs() / seconds;
        if speed > layout.speed * (1.0 + 1e-6) {
            let (screw, found, most) = (screw + 1, 1e3 * speed, 1e3 * layout.speed);
            return Err(format!(
                "screw {screw} at {found:.2} mm/s, expected at most {most:.2} mm/s; give the move more time (`over`)"
            ));
        }
    }
    Ok(())
}

/// Checks step and gap along the edges between two neighbours.
fn between(layout: &Layout, tiles: [(usize, &Order); 2], is_beside: bool) -> Result<(), String> {
    let [a, b] = layout.size().map(|s| 0.5 * s);
    let [one, other] = tiles.map(|(tile, order)| layout.rim(tile, &order.command));
    for end in [-1.0, 1.0] {
        // The first tile is to the left of the other, or nearer to the head, which is at +y.
        let (p, q) = if is_beside {
            (one.outwards([a, end * b, 0.0]), other.outwards([-a, end * b, 0.0]))
        } else {
            (other.outwards([end * a, b, 0.0]), one.outwards([end * a, -b, 0.0]))
        };
        let (step, gap) = ((p[2] - q[2]).abs(), if is_beside { q[0] - p[0] } else { q[1] - p[1] });
        if step > layout.step * (1.0 + 1e-9) {
            let (found, most) = (1e3 * step, 1e3 * layout.step);
            let next = tiles[1].0 + 1;
            return Err(format!("step of {found:.1} mm to tile {next}, expected {most:.1} mm at most"));
        }
        if gap < 0.0 {
            return Err(format!(
                "its rim would overlap by {:.1} mm with that of tile {}",
                -1e3 * gap,
                tiles[1].0 + 1
            ));
        }
    }
    Ok(())
}

fn capacity(plan: &Plan, orders: &[Order]) -> Result<(), String> {
    let [a, b] = plan.layout.size();
    let lift: f64 = orders.iter().map(|o| o.pressure * a * b).sum();
    let weight = plan.load.body.mass() * GRAVITY;
    if lift < SUPPORT * weight {
        return Err(format!(
            "all bladders can carry {lift:.0} N, expected at least {SUPPORT} times the weight of {weight:.0} N"
        ));
    }
    Ok(())
}
