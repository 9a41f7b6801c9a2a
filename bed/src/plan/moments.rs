//! Finds moves that no moment of a run shows, and pressures that are ordered anew before they are reached.
//!
//! In: a plan. Out: indices of moves, with tile and times. A sequence of equilibria knows orders at its moments only: a
//! move that is taken back between two of them changes no result.

use super::{Move, Order, Plan};

/// Times that differ by less than this share of the time between two moments count as equal.
const SAME: f64 = 1e-9;

/// A move that is taken back between two moments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unseen {
    /// Index of the move.
    pub index: usize,
    /// Index of the tile.
    pub tile: usize,
    /// Time (s) at which the move begins.
    pub from: f64,
    /// Time (s) at which the move ends that takes it back.
    pub to: f64,
}

/// The first move that the next one on the same tile takes back before a moment has come.
#[must_use]
pub fn unseen(plan: &Plan) -> Option<Unseen> {
    let all = (0..plan.layout.count()).flat_map(|tile| (0..4).map(move |quantity| (tile, quantity)));
    all.filter_map(|(tile, quantity)| unseen_of(plan, tile, quantity)).min_by_key(|found| found.index)
}

/// The same of one quantity of a tile: pressure, heave or a slope.
fn unseen_of(plan: &Plan, tile: usize, quantity: usize) -> Option<Unseen> {
    let Order { pressure, command } = plan.order(tile, f64::NEG_INFINITY);
    let mut value = [pressure, command.heave, command.slope[0], command.slope[1]][quantity];
    let mut last: Option<(usize, f64)> = None;
    for (index, change) in plan.moves.iter().enumerate() {
        if change.at >= plan.seconds || !change.tiles.contains(&tile) {
            continue;
        }
        let slope = |k: usize| change.slope.map(|slope| slope[k]);
        let Some(goal) = [change.pressure, change.heave, slope(0), slope(1)][quantity] else { continue };
        if goal == value {
            continue;
        }
        if let Some((index, before)) = last
            && (value - before) * (goal - value) < 0.0
            && !is_seen(plan, &plan.moves[index], change)
        {
            return Some(Unseen { index, tile, from: plan.moves[index].at, to: change.at + change.over });
        }
        last = Some((index, value));
        value = goal;
    }
    None
}

/// Does a moment lie between the begin of a move and the end of the one that takes it back?
fn is_seen(plan: &Plan, change: &Move, back: &Move) -> bool {
    let begin = change.at / plan.every;
    // A jump is complete at a moment at which it is ordered.
    let next = if change.over > 0.0 { (begin + SAME).floor() + 1.0 } else { (begin - SAME).ceil() };
    next + SAME < (back.at + back.over) / plan.every
}

/// Pressures that are ordered anew, on a tile, while an earlier move of them lasts: indices of the earlier and the
/// later move, and of the tile; each later move once.
#[must_use]
pub fn overridden(plan: &Plan) -> Vec<[usize; 3]> {
    let mut found: Vec<[usize; 3]> = Vec::new();
    for tile in 0..plan.layout.count() {
        let mut last: Option<usize> = None;
        for (index, change) in plan.moves.iter().enumerate() {
            if change.pressure.is_none() || !change.tiles.contains(&tile) {
                continue;
            }
            let end = |earlier: usize| plan.moves[earlier].at + plan.moves[earlier].over;
            if let Some(earlier) = last.filter(|earlier| change.at < end(*earlier) - SAME * plan.every)
                && found.iter().all(|own| own[1] != index)
            {
                found.push([earlier, index, tile]);
            }
            last = Some(index);
        }
    }
    found
}
