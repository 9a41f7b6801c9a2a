//! Homing: the legs find their lower end switches and take these as reference for their heights.
//!
//! In: heights by displacement sensor, switches. Out: wanted motion of each leg, and which leg has found its switch.
//! First level, just above the switches; then each leg goes down slowly until its switch opens, whose height is known
//! to 0.05 mm; then level again, at the lowest height that may be commanded.

use super::design::{RETREAT, SEEK_SPEED, SEEK_START, STROKE, SWITCH, UNHOMED_FACTOR};
use super::motion::{Heights, Motion};
use super::profile::{Along, TICK};

/// Longest displacement down to a switch (m): the errors of two sensors, and the distance to it.
const LONGEST_SEEK: f32 = 3e-3;

/// Phase of homing.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Phase {
    Approach(Motion),
    /// Wanted heights; and which legs have found their switch.
    Seek {
        wanted: Heights,
        is_found: [bool; 3],
    },
    Leave(Motion),
}

/// Homing in progress.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Homing(Phase);

/// Result of one tick of homing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Step {
    /// It continues; these legs have found their switch in this tick.
    Found([bool; 3]),
    /// A switch is not where it should be.
    Lost,
    /// All legs have a reference, and the last profile ended this many ticks ago.
    Done(u32),
}

impl Homing {
    /// Starts from these heights.
    #[must_use]
    pub fn new(heights: Heights) -> Self {
        Self(Phase::Approach(Motion::new(heights, [-SEEK_START; 3], UNHOMED_FACTOR)))
    }

    /// Wanted motion of each leg, and its displacement (m), at most that of the search.
    #[must_use]
    pub fn wanted(&self) -> ([Along; 3], [f32; 3]) {
        match &self.0 {
            Phase::Approach(motion) | Phase::Leave(motion) => (motion.wanted(), motion.ways()),
            Phase::Seek { wanted, is_found } => {
                let leg = |leg: usize| {
                    let speed = if is_found[leg] { 0.0 } else { -SEEK_SPEED };
                    Along { position: wanted[leg], speed, acceleration: 0.0 }
                };
                let ways = is_found.map(|found| if found { 0.0 } else { -LONGEST_SEEK });
                (core::array::from_fn(leg), ways)
            }
        }
    }

    /// Whether a lower switch may be pressed now.
    #[must_use]
    pub fn seeks(&self) -> bool {
        !matches!(self.0, Phase::Approach(_))
    }

    /// A slow motion back from here, against the present one; up from the switches.
    #[must_use]
    pub fn back(&self, here: Heights) -> Motion {
        match &self.0 {
            Phase::Approach(motion) | Phase::Leave(motion) => motion.back(here),
            Phase::Seek { .. } => Motion::new(here, here.map(|height| height + RETREAT), UNHOMED_FACTOR),
        }
    }

    /// Advances by a tick.
    pub fn advance(&mut self, heights: Heights, low_closed: [bool; 3]) -> Step {
        match &mut self.0 {
            Phase::Approach(motion) => {
                if motion.advance().is_some() {
                    self.0 = Phase::Seek { wanted: heights, is_found: [false; 3] };
                }
                Step::Found([false; 3])
            }
            Phase::Seek { wanted, is_found } => {
                let mut new = [false; 3];
                let legs = wanted.iter_mut().zip(is_found.iter_mut()).zip(&mut new).zip(low_closed);
                for (((wanted, is_found), new), closed) in legs {
                    if !*is_found && !closed {
                        (*is_found, *new, *wanted) = (true, true, -SWITCH);
                    } else if !*is_found {
                        *wanted -= SEEK_SPEED * TICK;
                    }
                }
                if wanted.iter().any(|h| *h < -SEEK_START - LONGEST_SEEK) {
                    return Step::Lost;
                }
                if *is_found == [true; 3] {
                    self.0 = Phase::Leave(Motion::new([-SWITCH; 3], [-STROKE; 3], UNHOMED_FACTOR));
                }
                Step::Found(new)
            }
            Phase::Leave(motion) => match motion.advance() {
                Some(ago) => Step::Done(ago),
                None => Step::Found([false; 3]),
            },
        }
    }
}
