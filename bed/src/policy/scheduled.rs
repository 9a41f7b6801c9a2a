//! Moves known beforehand, told when their time comes: alternating pressure, or a plan's own.

use super::{Policy, View};
use crate::plan::{Layout, Move, Plan};

/// Moves by when they begin.
#[derive(Clone, Debug)]
pub struct Scheduled {
    moves: Vec<Move>,
}

impl Scheduled {
    /// These moves.
    #[must_use]
    pub fn new(mut moves: Vec<Move>) -> Scheduled {
        // The next one to be told stands last.
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
    fn decide(&mut self, _: &View<'_>) -> Vec<Move> {
        // What begins before one looks again must be told now; all is known, so all is told.
        std::mem::take(&mut self.moves).into_iter().rev().collect()
    }
}
