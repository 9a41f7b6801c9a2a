//! A picture as lines, filled shapes and words, in pixels from the upper left corner.

/// Red, green, blue.
pub type Color = [u8; 3];

/// Where a text's given point lies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Anchor {
    /// At its left end.
    Start,
    /// In its middle.
    Middle,
    /// At its right end.
    End,
}

/// Something drawn.
#[derive(Clone, PartialEq, Debug)]
pub enum Item {
    /// Straight lines from point to point.
    Line {
        /// Points.
        points: Vec<(f64, f64)>,
        /// Colour.
        color: Color,
        /// Width.
        width: f64,
    },
    /// A filled polygon.
    Area {
        /// Corners.
        points: Vec<(f64, f64)>,
        /// Colour.
        color: Color,
    },
    /// Words; upright letters are `size` high.
    Text {
        /// Middle of the text's height.
        at: (f64, f64),
        /// The words.
        text: String,
        /// Height of the letters.
        size: f64,
        /// Which part is at `at`.
        anchor: Anchor,
        /// Turned to read from bottom to top.
        upwards: bool,
    },
}

impl Item {
    /// The same item, `down` pixels lower.
    #[must_use]
    pub fn lowered(self, down: f64) -> Self {
        let lower = |points: Vec<(f64, f64)>| points.into_iter().map(|(x, y)| (x, y + down)).collect();
        match self {
            Self::Line { points, color, width } => Self::Line { points: lower(points), color, width },
            Self::Area { points, color } => Self::Area { points: lower(points), color },
            Self::Text { at, text, size, anchor, upwards } => {
                Self::Text { at: (at.0, at.1 + down), text, size, anchor, upwards }
            }
        }
    }
}

/// A picture.
#[derive(Clone, PartialEq, Debug)]
pub struct Drawing {
    /// Width.
    pub width: usize,
    /// Height.
    pub height: usize,
    /// What is on it, back to front.
    pub items: Vec<Item>,
}

/// Text and axes.
pub const INK: Color = [40, 40, 40];
/// Grid lines.
pub const PALE: Color = [222, 222, 222];
