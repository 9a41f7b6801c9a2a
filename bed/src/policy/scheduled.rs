//! Moves known beforehand, such as alternating pressure, with times counted from the first decision.

use super::{Policy, View};
use crate::plan::{Layout, Move, Plan};

/// Moves, with their beginnings counted from the first decision.
#[derive(Clone, Debug)]
pub struct Scheduled {
    moves: Vec<Move>,
}

impl Scheduled {
    /// A policy that makes these moves.
    #[must_use]
    pub fn new(mut moves: Vec<Move>) -> Scheduled {
        // Sorted in reverse, so that the next move is last.
        moves.sort_by(|a, b| b.at.total_cmp(&a.at));
        Scheduled { moves }
    }

    /// Alternating pressure, [`Plan::alternating`].
    #[must_use]
    pub fn alternating(layout: &Layout, low: f64, high: f64, cycle: f64, seconds: f64) -> Scheduled {
        Scheduled::new(Plan::alternating(layout, low, high, cycle, seconds))
    }
}

impl Policy for Scheduled {
    fn decide(&mut self, view: &View<'_>) -> Vec<Move> {
        // All moves are known, so all are ordered at once: one that begins before the next decision would come too
        // late.
        let told = std::mem::take(&mut self.moves).into_iter().rev();
        told.map(|change| Move { at: view.time + change.at, ..change }).collect()
    }
}
