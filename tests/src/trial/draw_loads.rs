//! Loads of every kind on points, frames and coordinates, and outputs of every function.

use super::description::Load;
use super::draw::{Draw, Link};
use super::expression::{Function, Pair, Scalar, Vector};

impl Draw {
    /// Gravity and some loads of each kind.
    pub(super) fn loads(&mut self) {
        if self.chance(0.85) {
            let g = self.number(9.81, "m/s^2", false);
            let down = Vector::Axis(0, if self.planar { 1 } else { 2 }).scaled(Scalar::number(-1.0) * g);
            let side = Scalar::Literal(0.4, "m") * Scalar::Power(Box::new(Scalar::Literal(1.0, "Hz")), 2);
            self.d.gravity =
                Some(if self.chance(0.3) { down + Vector::Axis(0, 0).scaled(side) } else { down });
        }
        for _ in 0..2 + self.below(3) {
            match self.below(4) {
                0 => self.force(),
                1 => self.torque(),
                2 => self.spring(),
                _ => self.coordinate_spring(),
            }
        }
    }

    /// Any link.
    pub(super) fn any_link(&mut self) -> Link {
        let i = self.below(self.links.len());
        self.links[i]
    }

    /// Some other link, or the ground.
    fn another(&mut self, link: Link) -> Link {
        let other = self.any_link();
        if other.frame == link.frame { Link { frame: 0, origin: 0, centre: 0 } } else { other }
    }

    fn input(&mut self, unit: &'static str) -> Scalar {
        self.d.inputs.push(unit);
        Scalar::Input(self.d.inputs.len() - 1)
    }

    /// A size in `unit`: constant, commanded, waving with time or with an angle.
    fn size(&mut self, unit: &'static str, low: f64, high: f64) -> Scalar {
        let value = self.between(low, high);
        let size = self.number(value, unit, false);
        let angles: Vec<usize> =
            self.d.state().into_iter().filter(|&i| self.d.coordinates[i].angle).collect();
        match self.below(5) {
            0 => size + self.input(unit),
            1 => size * (Scalar::Literal(1.7, "Hz") * Scalar::Time).call(Function::Sin),
            2 if !angles.is_empty() => {
                let q = Scalar::Coordinate(angles[self.below(angles.len())]);
                let wave = self.d.define(Scalar::number(1.0) + q.call(Function::Cos));
                size * wave
            }
            _ => size,
        }
    }

    fn force(&mut self) {
        let link = self.any_link();
        let on = self.another(link);
        let (frame, arm) = (self.any_link().frame, self.arm(link.frame, 0.2));
        let at = self.d.point(Vector::Point(link.origin) + arm);
        let size = self.size("N", -5.0, 5.0);
        let mut force = self.axis(frame).scaled(size);
        if self.chance(0.5) {
            let drag = self.number(-0.7, "N s/m", false);
            force = force + Vector::Velocity(at).scaled(drag);
        }
        let reaction = self.chance(0.6).then_some(on.centre);
        self.d.loads.push(Load::Force(at, force, reaction));
    }

    fn torque(&mut self) {
        let link = self.any_link();
        let on = self.another(link);
        let axis = if self.planar { 2 } else { self.below(3) };
        let size = self.size("N m", -2.0, 2.0);
        let mut torque = Vector::Axis(link.frame, axis).scaled(size);
        if self.chance(0.5) {
            let friction = self.number(-0.3, "N m s", false);
            torque = torque + Vector::AngularVelocity(link.frame).scaled(friction);
        }
        let reaction = self.chance(0.6).then_some(on.frame);
        self.d.loads.push(Load::Torque(link.frame, torque, reaction));
    }

    fn spring(&mut self) {
        let link = self.any_link();
        let other = self.another(link);
        let (near, far) = (self.arm(link.frame, 0.2), self.arm(other.frame, 0.9));
        let ends = [
            self.d.point(Vector::Point(link.origin) + near),
            self.d.point(Vector::Point(other.origin) + far),
        ];
        let stiffness = self.between(5.0, 60.0);
        let stiffness = self.number(stiffness, "N/m", false);
        let rest = self.between(0.1, 0.5);
        let rest = self.number(rest, "m", false);
        let damping = self.chance(0.6).then(|| self.number(0.9, "N s/m", false));
        self.d.loads.push(Load::Spring(ends, stiffness, rest, damping));
    }

    fn coordinate_spring(&mut self) {
        let i = self.below(self.d.coordinates.len());
        let angle = self.d.coordinates[i].angle;
        let units = if angle { ["N m", "", "N m s"] } else { ["N/m", "m", "N s/m"] };
        let stiffness = self.between(1.0, 20.0);
        let stiffness = self.number(stiffness, units[0], false);
        let rest = self.between(-0.3, 0.3);
        let rest = self.number(rest, units[1], false);
        let damping = self.chance(0.6).then(|| self.number(0.4, units[2], false));
        self.d.loads.push(Load::CoordinateSpring(i, stiffness, rest, damping));
    }

    /// Places, velocities, speeds, definitions, and some functions of them.
    pub(super) fn outputs(&mut self) {
        let link = self.any_link();
        let height = Vector::Point(link.centre).dot(Vector::Axis(0, 1));
        let rate = Vector::Velocity(link.centre).norm();
        let turning = Vector::AngularVelocity(link.frame).dot(Vector::Axis(0, 2));
        let speed = self.below(self.d.speeds.len());
        let ratio = Scalar::Quotient(Box::new(height.clone()), Box::new(Scalar::Literal(0.7, "m")));
        let swing = Vector::Axis(link.frame, 0).dot(Vector::Axis(0, 0));
        let local = self.d.define_vector(Vector::Point(link.centre) - Vector::Point(link.origin));
        let [near, far] = [0.3, 0.9].map(Scalar::number);
        let pair = |f, a: &Scalar, b: &Scalar| Scalar::CallTwo(f, Box::new(a.clone()), Box::new(b.clone()));
        let inside = near.clone() * swing.clone();
        self.d.outputs.extend([height, rate, turning, Scalar::Speed(speed), local.norm(), ratio.clone()]);
        let function = match self.below(11) {
            0 => pair(Pair::Atan2, &ratio, &far),
            1 => pair(Pair::Min, &ratio, &near),
            2 => pair(Pair::Max, &ratio, &near),
            3 => pair(Pair::SmoothStep, &ratio, &far),
            4 => inside.call(Function::Tan),
            5 => inside.call(Function::Acos),
            6 => (far + inside).call(Function::Ln),
            7 => inside.call(Function::Abs),
            8 => inside.call(Function::Sign),
            9 => inside.call(Function::Exp),
            _ => (far + inside).call(Function::Sqrt),
        };
        self.d.outputs.push(function);
    }
}
