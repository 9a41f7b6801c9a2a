//! Pictures of a body from the side: at the start, at the first touch, at the largest compression of a spring, at the
//! end.
//!
//! In: rows, one after the other. Out: four moments for [`crate::plot::side`]. Springs are grey at rest length,
//! vermilion if stretched, blue if compressed.

use super::read::Scene;
use super::run::Row;
use crate::plot::drawing::{Drawing, INK};
use crate::plot::side::{self, Ground, Moment, Stroke, strain_color};

/// A body at one time.
#[derive(Clone, Debug)]
struct Frame {
    time: f64,
    pos: Vec<[f64; 3]>,
}

/// The four pictures, as far as the run has come.
#[derive(Clone, Debug)]
pub struct Pictures {
    springs: Vec<[usize; 2]>,
    rest_lengths: Vec<f64>,
    least: f64,
    start: Option<Frame>,
    touch: Option<Frame>,
    compressed: Option<Frame>,
    end: Option<Frame>,
}

impl Pictures {
    /// None yet.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let (springs, rest_lengths) = (scene.lists.springs.clone(), scene.lists.rest_lengths.clone());
        let least = f64::INFINITY;
        Self { springs, rest_lengths, least, start: None, touch: None, compressed: None, end: None }
    }

    /// Looks at a row: keeps it if it is the first, the first after a touch, or the most compressed.
    pub fn push(&mut self, row: &Row) {
        let frame = || Some(Frame { time: row.t, pos: row.pos.clone() });
        if self.start.is_none() {
            self.start = frame();
        }
        if self.touch.is_none() && row.touches > 0 {
            self.touch = frame();
        }
        let strains = (0..self.springs.len()).map(|s| self.strain(&row.pos, s));
        let least = strains.fold(f64::INFINITY, f64::min);
        if least < self.least {
            self.least = least;
            self.compressed = frame();
        }
        self.end = frame();
    }

    /// Change of a spring's length over its rest length.
    fn strain(&self, pos: &[[f64; 3]], spring: usize) -> f64 {
        let [a, b] = self.springs[spring];
        let length = (0..3).map(|c| (pos[b][c] - pos[a][c]).powi(2)).sum::<f64>().sqrt();
        let rest = self.rest_lengths[spring];
        if rest > 0.0 { length / rest - 1.0 } else { 0.0 }
    }

    /// Draws all pictures.
    #[must_use]
    pub fn draw(&self, scene: &Scene) -> Drawing {
        let ground = scene.around.ground.map(|g| Ground { normal: g.normal, offset: g.offset });
        let moments = self.frames().into_iter().map(|(name, frame)| Moment {
            name,
            time: frame.time,
            strokes: self.strokes(&frame.pos),
        });
        side::draw("The body from the side", ground.as_slice(), &moments.collect::<Vec<_>>())
    }

    /// Pictures of different times, each with its name.
    fn frames(&self) -> Vec<(&'static str, &Frame)> {
        // A touch or an end at the same time says more than that a spring was shortest then.
        let others = [&self.start, &self.touch, &self.end].map(|frame| frame.as_ref().map(|f| f.time));
        let compressed = self.compressed.as_ref().filter(|f| !others.contains(&Some(f.time)));
        let named = [
            ("start", self.start.as_ref()),
            ("first touch", self.touch.as_ref()),
            ("compressed", compressed),
            ("end", self.end.as_ref()),
        ];
        named.into_iter().filter_map(|(name, frame)| Some((name, frame?))).collect()
    }

    /// Springs, then points.
    fn strokes(&self, pos: &[[f64; 3]]) -> Vec<Stroke> {
        let springs = self.springs.iter().enumerate().map(|(number, [a, b])| Stroke {
            points: vec![pos[*a], pos[*b]],
            color: strain_color(self.strain(pos, number)),
            width: 1.6,
        });
        springs.chain(pos.iter().map(|p| Stroke { points: vec![*p], color: INK, width: 3.0 })).collect()
    }
}
