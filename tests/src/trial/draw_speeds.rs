//! Speeds: which rates are independent, and combinations of rates that replace them.

use super::description::Speed;
use super::draw::Draw;
use super::expression::{Function, Scalar};
use super::nominal;

impl Draw {
    /// Every coordinate has its rate as speed; the speeds that the constraints determine best are dependent.
    pub(super) fn choose_independent(&mut self) {
        for i in 0..self.d.coordinates.len() {
            let closed = self.d.coordinates[i].closed_form.is_some();
            let angle = self.d.coordinates[i].angle;
            self.d.speeds.push(Speed { of: Some(i), value: Scalar::Rate(i), angle, independent: !closed });
        }
        let [of_configuration, of_motion] = nominal::dependent(&self.d);
        for i in of_configuration {
            self.d.coordinates[i].independent = false;
            self.d.speeds[i].independent = false;
        }
        of_motion.into_iter().for_each(|i| self.d.speeds[i].independent = false);
    }

    /// Replaces some independent rates by sums with other rates; the matrix is triangular with ones, so they stay
    /// independent.
    pub(super) fn combine_speeds(&mut self) {
        let free: Vec<usize> = self.d.independent_speeds();
        let mut combined = Vec::new();
        for (place, &i) in free.iter().enumerate() {
            if place == 0 || self.chance(0.3) {
                continue;
            }
            let angle = self.d.coordinates[i].angle;
            let others = &free[..place];
            let j = others[self.below(others.len())];
            let factor = self.between(0.3, 1.2);
            let unit = match (angle, self.d.coordinates[j].angle) {
                (true, false) => "1/m",
                (false, true) => "m",
                _ => "",
            };
            let factor = self.number(factor, unit, false);
            let any: Vec<usize> =
                self.d.state().into_iter().filter(|&k| self.d.coordinates[k].angle).collect();
            let changing = match any.len() {
                0 => factor,
                n => factor * Scalar::Coordinate(any[self.below(n)]).call(Function::Cos),
            };
            let own = Scalar::number(self.between(0.5, 2.0)) * Scalar::Rate(i);
            combined.push((
                i,
                Speed { of: None, value: own + changing * Scalar::Rate(j), angle, independent: true },
            ));
        }
        self.d.speeds.retain(|s| !combined.iter().any(|(i, _)| s.of == Some(*i)));
        self.d.speeds.extend(combined.into_iter().map(|(_, speed)| speed));
    }
}
