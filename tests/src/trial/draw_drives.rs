//! Motions prescribed by time: joints in closed form, and gears and couplings with a term that depends on time alone.

use super::draw::Draw;
use super::expression::{Function, Scalar, Value};

impl Draw {
    /// One or two drives of any kind.
    pub(super) fn drives(&mut self) {
        for _ in 0..1 + self.below(2) {
            match self.below(4) {
                0 => self.driven_link(),
                1 => self.driven_gear(),
                2 => {
                    let row = self.coupling() - self.pace("rad/s");
                    self.d.motion.push(Value::Scalar(row));
                }
                _ => {
                    let row = self.edge() - self.pace("m/s");
                    self.d.motion.push(Value::Scalar(row));
                }
            }
        }
    }

    /// A gear with an additional prescribed oscillation.
    fn driven_gear(&mut self) {
        let place = self.d.configuration.len();
        self.gear();
        if let Some(Value::Scalar(row)) = self.d.configuration.get(place).cloned() {
            self.d.configuration[place] = Value::Scalar(row - self.swing("", 0.3));
        }
    }

    /// A frequency.
    fn frequency(&mut self) -> Scalar {
        Scalar::Literal(self.between(0.5, 2.0), "Hz")
    }

    /// A function of time that is 0 at first.
    fn swing(&mut self, unit: &'static str, size: f64) -> Scalar {
        let size = self.between(0.3 * size, size);
        let size = self.number(size, unit, false);
        size * (self.frequency() * Scalar::Time).call(Function::Sin)
    }

    /// A speed: constant, or a function of time.
    fn pace(&mut self, unit: &'static str) -> Scalar {
        let size = self.between(-1.0, 1.0);
        let size = self.number(size, unit, false);
        if self.chance(0.4) {
            return size;
        }
        size * (self.frequency() * Scalar::Time).call(Function::Cos)
    }

    /// A link whose joint is a function of time, or of time and an angle.
    fn driven_link(&mut self) {
        let angle = self.chance(0.6);
        let swing = if angle { self.swing("", 0.8) } else { self.swing("m", 0.2) };
        let free: Vec<usize> = self.d.state();
        let angles: Vec<usize> = free.into_iter().filter(|&i| self.d.coordinates[i].angle).collect();
        let form = if angle && self.chance(0.5) {
            let read = angles[self.below(angles.len())];
            self.read_by_forms.push(read);
            swing + Scalar::number(0.5) * Scalar::Coordinate(read).call(Function::Sin)
        } else {
            swing
        };
        self.joint_in_closed_form(angle, form);
    }
}
