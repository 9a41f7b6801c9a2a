//! Bounding boxes of parts, and whether two parts may touch within the next steps.
//!
//! In: positions of a part's points and their largest speed. Out: a box, enlarged by the motion of a few steps.

use smartbed_runtime::vec3::{self, Vec3};

/// Box around a part, and its fastest point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Reach {
    low: Vec3<f64>,
    high: Vec3<f64>,
    /// (m/s).
    pub(super) speed: f64,
}

impl Reach {
    pub(super) const NOTHING: Reach =
        Reach { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3], speed: 0.0 };
    pub(super) const EVERYWHERE: Reach =
        Reach { low: [f64::NEG_INFINITY; 3], high: [f64::INFINITY; 3], speed: 0.0 };

    pub(super) fn add(&mut self, point: Vec3<f64>, around: f64, speed: f64) {
        for ((low, high), x) in self.low.iter_mut().zip(&mut self.high).zip(point) {
            (*low, *high) = (low.min(x - around), high.max(x + around));
        }
        self.speed = self.speed.max(speed);
    }

    /// A box around both.
    pub(super) fn join(&mut self, other: &Reach) {
        for i in 0..3 {
            (self.low[i], self.high[i]) = (self.low[i].min(other.low[i]), self.high[i].max(other.high[i]));
        }
        self.speed = self.speed.max(other.speed);
    }

    /// The box enlarged by the motion of a few steps of h (s).
    fn grown(&self, h: f64, gravity: f64) -> Reach {
        let size = vec3::norm(vec3::sub(self.high, self.low));
        let size = if size.is_finite() { size } else { 0.0 };
        let by = 4.0 * h * self.speed + 8.0 * h * h * gravity + 0.02 * size;
        Reach { low: self.low.map(|x| x - by), high: self.high.map(|x| x + by), speed: self.speed }
    }

    /// May the two touch within the next steps?
    pub(super) fn is_near(&self, other: &Reach, h: f64, gravity: f64) -> bool {
        let (own, other) = (self.grown(h, gravity), other.grown(h, gravity));
        (0..3).all(|i| own.low[i] <= other.high[i] && other.low[i] <= own.high[i])
    }
}
