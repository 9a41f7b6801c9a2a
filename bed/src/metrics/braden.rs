//! The Braden scale: six scores that a nurse enters; none of them is computed here.
//!
//! In: sensory perception, moisture, activity, mobility, nutrition (1 to 4), and friction and shear (1 to 3). Out: sum
//! and risk band.

use std::fmt;

/// Scores in the order of the scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Braden {
    marks: [u8; 6],
}

/// Name and best score of each subscale.
pub const SUBSCALES: [(&str, u8); 6] = [
    ("sensory", 4),
    ("moisture", 4),
    ("activity", 4),
    ("mobility", 4),
    ("nutrition", 4),
    ("friction_and_shear", 3),
];

/// A score outside its scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongMark {
    /// Index in [`SUBSCALES`].
    pub subscale: usize,
    /// The score given.
    pub found: u8,
}

impl fmt::Display for WrongMark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, best) = SUBSCALES[self.subscale];
        write!(f, "Braden mark `{name}` is {}, expected 1 to {best}", self.found)
    }
}

impl std::error::Error for WrongMark {}

impl Braden {
    /// Checks the scores.
    ///
    /// # Errors
    /// [`WrongMark`], for the first score outside its scale.
    pub fn new(marks: [u8; 6]) -> Result<Braden, WrongMark> {
        let wrong = marks.iter().zip(SUBSCALES).position(|(mark, (_, best))| *mark < 1 || *mark > best);
        match wrong {
            Some(subscale) => Err(WrongMark { subscale, found: marks[subscale] }),
            None => Ok(Braden { marks }),
        }
    }

    /// Marks in the order of [`SUBSCALES`].
    #[must_use]
    pub fn marks(&self) -> [u8; 6] {
        self.marks
    }

    /// Sum, 6 to 23.
    #[must_use]
    pub fn sum(&self) -> u8 {
        self.marks.iter().sum()
    }

    /// Name of the risk band of the sum.
    #[must_use]
    pub fn band(&self) -> &'static str {
        match self.sum() {
            0..=9 => "very high risk",
            10..=12 => "high risk",
            13..=14 => "moderate risk",
            15..=18 => "mild risk",
            _ => "no particular risk",
        }
    }
}
