//! Moves known beforehand, counted from when somebody first asks: alternating pressure, or others.

use super::{Policy, View};
use crate::plan::{Layout, Move, Plan};

/// Moves by how long after the first question they begin.
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
    fn decide(&mut self, view: &View<'_>) -> Vec<Move> {
        // What begins before one looks again must be told now; all is known, so all is told.
        let told = std::mem::take(&mut self.moves).into_iter().rev();
        told.map(|change| Move { at: view.time + change.at, ..change }).collect()
    }
}
