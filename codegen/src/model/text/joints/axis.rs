//! Motions of joints and their axes: a letter, perhaps with a minus sign, or three numbers.
//!
//! In: the value of a field. Out: a [`Direction`], which can be written as a vector of a frame and as rotations. Simple
//! rotations are about letters only, so a rotation about another axis turns z onto that axis, then about z, then back.

use crate::model::text::document::{Text, Value};
use crate::source::Span;

/// The axis of a motion, in the frame that the motions before it have reached.
#[derive(Clone, Copy)]
pub enum Along {
    /// The joint's own axis: the first one given, the second one.
    Given(usize),
    /// A fixed letter.
    Letter(char),
    /// The first, second of the other axes than the one given, in the order x, y, z.
    Across(usize),
}

/// A motion of the link, by one or several coordinates of the joint.
#[derive(Clone, Copy)]
pub enum Motion {
    /// A translation by one coordinate, whose name ends in this word or, without a word, in the axis's letter.
    Slide(Along, Option<&'static str>),
    /// A rotation by one coordinate.
    Turn(Along, &'static str),
    /// Any rotation, by four Euler parameters; its speeds are the components of the angular velocity along the link's
    /// axes.
    Attitude,
}
const LETTERS: [char; 3] = ['x', 'y', 'z'];

/// The direction of an axis in a frame.
#[derive(Clone)]
pub enum Direction {
    /// An axis of the frame: its index, and whether the direction is opposite to it.
    Letter(usize, bool),
    /// A unit vector that is along no axis of the frame.
    Vector([f64; 3]),
}
use Direction::{Letter, Vector};

impl Direction {
    /// The axis x, y or z.
    pub fn letter(letter: char) -> Self {
        Letter(LETTERS.iter().position(|l| *l == letter).unwrap_or(2), false)
    }

    /// The axis in a field's value, if it is one.
    pub fn read(value: &Value) -> Option<Self> {
        match value {
            Value::Text(Text { text, .. }) => {
                let (letter, back) =
                    text.strip_prefix('-').map_or((text.as_str(), false), |rest| (rest, true));
                let n = LETTERS.iter().position(|l| letter.len() == 1 && letter.starts_with(*l))?;
                Some(Letter(n, back))
            }
            Value::Array(items, _) => {
                let numbers: Vec<f64> = items
                    .iter()
                    .filter_map(|i| if let Value::Number(x, _) = i { Some(*x) } else { None })
                    .collect();
                let v: [f64; 3] = numbers.try_into().ok().filter(|_| items.len() == 3)?;
                let length = v.iter().fold(0.0_f64, |sum, x| sum.hypot(*x));
                let unit = v.map(|x| x / length);
                // An axis along a letter is exact and needs no rotations of its own.
                match unit.iter().position(|x| x.abs() == 1.0) {
                    Some(n) => Some(Letter(n, unit[n] < 0.0)),
                    None => unit.iter().all(|x| x.is_finite()).then_some(Vector(unit)),
                }
            }
            _ => None,
        }
    }

    /// The n-th of the other axes, in the order x, y, z.
    pub fn across(&self, n: usize) -> Self {
        match self {
            Letter(letter, _) => Letter(n + usize::from(n >= *letter), false),
            other => other.clone(),
        }
    }

    /// Does it point along a positive axis of the frame?
    pub fn is_letter(&self) -> bool {
        matches!(self, Letter(_, false))
    }

    /// Cosine of the angle between two axes.
    pub fn cosine(&self, other: &Self) -> f64 {
        self.vector().into_iter().zip(other.vector()).map(|(a, b)| a * b).sum()
    }

    fn vector(&self) -> [f64; 3] {
        match *self {
            Letter(n, back) => {
                std::array::from_fn(|i| if i == n { if back { -1.0 } else { 1.0 } } else { 0.0 })
            }
            Vector(v) => v,
        }
    }

    /// The letter of the axis in names of coordinates.
    pub fn name(&self) -> String {
        match self {
            Letter(n, _) => LETTERS[*n].to_string(),
            Vector(_) => "slide".to_owned(),
        }
    }

    /// The unit vector as an expression.
    pub fn of(&self, frame: &str) -> String {
        match *self {
            Letter(n, false) => format!("{frame}.{}", LETTERS[n]),
            Letter(n, true) => format!("(-{frame}.{})", LETTERS[n]),
            Vector([x, y, z]) => format!("(({x:?})*{frame}.x + ({y:?})*{frame}.y + ({z:?})*{frame}.z)"),
        }
    }

    /// Simple rotations that amount to a rotation by `angle` about the axis.
    pub fn turn(&self, angle: &str, span: Span) -> Vec<Value> {
        let step = |letter: char, angle: &str| {
            let pair = [letter.to_string(), angle.to_owned()];
            Value::Array(pair.iter().map(|text| Value::Text(Text::made(text, span))).collect(), span)
        };
        match *self {
            Letter(n, false) => vec![step(LETTERS[n], angle)],
            Letter(n, true) => vec![step(LETTERS[n], &format!("-{angle}"))],
            // Rotations about y, then about z take z to the axis (sin b cos a, sin b sin a, cos b).
            Vector([x, y, z]) => {
                let (a, b) = (f64::atan2(y, x), f64::atan2(x.hypot(y), z));
                [('z', a), ('y', b)]
                    .into_iter()
                    .map(|(letter, by)| step(letter, &format!("{by:?}")))
                    .chain([step('z', angle)])
                    .chain(
                        [('y', -b), ('z', -a)]
                            .into_iter()
                            .map(|(letter, by)| step(letter, &format!("{by:?}"))),
                    )
                    .collect()
            }
        }
    }
}
