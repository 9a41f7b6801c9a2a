//! Homing: the legs find their lower end switches and take their heights from them.
//!
//! In: heights by displacement sensor, switches. Out: what is wanted of each leg, and which leg has found its switch.
//! Level, just above the switches; then each leg goes down slowly until its switch opens, which is at a height known to
//! 0.05 mm; then level again, as low as may be commanded.

use super::design::{SEEK_SPEED, SEEK_START, STROKE, SWITCH, UNHOMED_FACTOR};
use super::motion::{Heights, Motion};
use super::profile::{Along, TICK};

/// Longest way down to a switch (m): the errors of two sensors, and the way to it.
const LONGEST_SEEK: f32 = 3e-3;

/// How far it is.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Phase {
    Approach(Motion),
    /// Heights that the legs are to have; whose switch has been found.
    Seek {
        wanted: Heights,
        is_found: [bool; 3],
    },
    Leave(Motion),
}

/// Homing under way.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Homing(Phase);

/// What a tick of homing comes to.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Step {
    /// It goes on; these legs have found their switch in this tick.
    Found([bool; 3]),
    /// A switch is not where it must be.
    Lost,
    /// All legs are referred to and at rest, as far as the profile goes: so many ticks ago.
    Done(u32),
}

impl Homing {
    /// From these heights.
    #[must_use]
    pub fn new(heights: Heights) -> Self {
        Self(Phase::Approach(Motion::new(heights, [-SEEK_START; 3], UNHOMED_FACTOR)))
    }

    /// What is wanted of each leg, and how far it goes (m): to its switch at most so far as is sought.
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

    /// May a lower switch be pressed now?
    #[must_use]
    pub fn seeks(&self) -> bool {
        !matches!(self.0, Phase::Approach(_))
    }

    /// Goes on by a tick.
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
