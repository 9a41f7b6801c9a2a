//! Closed forms, constraints of motion, and bodies that roll.

use super::description::{Coordinate, Entity, Frame, Point};
use super::draw::Draw;
use super::expression::{Function, Scalar, Value, Vector};

impl Draw {
    /// Further links whose joints follow the coordinates by a formula.
    pub(super) fn closed_forms(&mut self) {
        for _ in 0..1 + self.below(2) {
            let angle = self.chance(0.6);
            let form = self.form(angle);
            self.joint_in_closed_form(angle, form);
        }
    }

    /// A link whose joint is a function of coordinates.
    pub(super) fn joint_in_closed_form(&mut self, angle: bool, form: Scalar) {
        let unit = if angle { "rad" } else { "m" };
        let coordinate =
            Coordinate { angle, unit, nominal: 0.0, reach: 1.0, independent: false, closed_form: Some(form) };
        self.d.coordinates.push(coordinate);
        let q = self.d.coordinates.len() - 1;
        self.d.order.push(Entity::Coordinate(q));
        let base = self.any_link();
        let mut origin = Vector::Point(base.origin) + self.arm(base.frame, 0.3);
        let mut frame = base.frame;
        if angle {
            let axis = if self.planar { 2 } else { self.below(3) };
            frame = self.d.frame(Frame::Rotations(base.frame, vec![(axis, Scalar::Coordinate(q))]));
        } else {
            origin = origin + self.axis(base.frame).scaled(Scalar::Coordinate(q));
        }
        let origin = self.d.point(origin);
        self.finish(frame, origin);
    }

    /// Whether all coordinates in closed forms are independent.
    pub(super) fn forms_are_free(&self) -> bool {
        self.read_by_forms.iter().all(|&i| self.d.coordinates[i].independent)
    }

    /// A smooth function of coordinates that are independent.
    fn form(&mut self, angle: bool) -> Scalar {
        let free: Vec<usize> = self.d.state();
        let angles: Vec<usize> = free.into_iter().filter(|&i| self.d.coordinates[i].angle).collect();
        let read = [0, 0].map(|_| angles[self.below(angles.len())]);
        self.read_by_forms.extend(read);
        let [a, b] = read.map(Scalar::Coordinate);
        let factor = self.between(0.2, 0.8);
        let smooth = match self.below(5) {
            0 => a.call(Function::Sin) * b.call(Function::Cos),
            1 => (Scalar::number(0.5) * a).call(Function::Sin).call(Function::Asin),
            2 => (Scalar::number(1.5) + b.call(Function::Sin)).call(Function::Sqrt),
            3 => a.call(Function::Tanh) + Scalar::Power(Box::new(b), 2),
            _ => (a + b).call(Function::Sin).call(Function::Exp),
        };
        if angle {
            self.number(factor, "", false) * smooth
        } else {
            self.number(0.3 * factor, "m", false) * smooth
        }
    }

    /// Edges that do not slip sideways, couplings of speeds.
    pub(super) fn motion_constraints(&mut self) {
        let n = 1 + usize::from(4 < self.d.state().len() && self.chance(0.4));
        for _ in 0..n {
            let row = if self.chance(0.5) { self.edge() } else { self.coupling() };
            self.d.motion.push(Value::Scalar(row));
        }
    }

    /// A point does not move along an axis of its link.
    pub(super) fn edge(&mut self) -> Scalar {
        let link = self.any_link();
        let arm = self.arm(link.frame, 0.3);
        let point = self.d.point(Vector::Point(link.origin) + arm);
        let axis = self.axis(link.frame);
        Vector::Velocity(point).dot(axis)
    }

    /// A rate depends on others, with a ratio that depends on the configuration.
    pub(super) fn coupling(&mut self) -> Scalar {
        let angles: Vec<usize> =
            self.d.state().into_iter().filter(|&i| self.d.coordinates[i].angle).collect();
        let pick = |draw: &mut Self| angles[draw.below(angles.len())];
        let (a, b, c) = (pick(self), pick(self), pick(self));
        let ratio = self.between(0.3, 1.5);
        let ratio = self.number(ratio, "", false);
        let changing = ratio * Scalar::Coordinate(c).call(Function::Cos);
        let link = self.any_link().frame;
        if self.chance(0.5) || a == b {
            // The plane's normal, or any axis in space, of an angular velocity.
            let spin = Vector::AngularVelocity(link).dot(Vector::Axis(0, 2));
            return Scalar::Rate(a) - changing * spin;
        }
        Scalar::Rate(a) - changing * Scalar::Rate(b)
    }

    /// A disc or a ball on the plane z = 0, and further links on it.
    pub(super) fn rolling(&mut self) {
        if self.chance(0.5) {
            self.ball()
        } else {
            self.disc()
        }
        for _ in 0..self.below(3) {
            let on = self.below(self.links.len());
            self.link(Some(on));
        }
    }

    /// No coordinates describe the ball's position; the velocity of its centre is given instead.
    fn ball(&mut self) {
        let radius = self.length(0.1, 0.3);
        let axes = [2, 0, 1].map(|axis| (axis, Scalar::Coordinate(self.coordinate(true))));
        let frame = self.d.frame(Frame::Rotations(0, axes.to_vec()));
        let spoke = Vector::Axis(0, 2).scaled(radius);
        let velocity = Vector::AngularVelocity(frame).cross(spoke.clone());
        self.d.points.push(Point { position: spoke, closures: Vec::new(), velocity: Some(velocity) });
        let centre = self.d.points.len() - 1;
        self.d.order.push(Entity::Point(centre));
        self.finish(frame, centre);
    }

    /// Yaw, lean and spin about the axle; the place in the plane has coordinates.
    pub(super) fn disc(&mut self) {
        let radius = self.length(0.1, 0.3);
        let [yaw, lean, spin] = [0; 3].map(|_| self.coordinate(true));
        self.d.coordinates[lean].nominal *= 0.5;
        let steps = vec![(2, Scalar::Coordinate(yaw)), (0, Scalar::Coordinate(lean))];
        let leaned = self.d.frame(Frame::Rotations(0, steps));
        let frame = self.d.frame(Frame::Rotations(leaned, vec![(1, Scalar::Coordinate(spin))]));
        let [x, y] = [0, 1].map(|axis| {
            let place = Scalar::Coordinate(self.coordinate(false));
            Vector::Axis(0, axis).scaled(place)
        });
        let spoke = Vector::Axis(leaned, 2).scaled(radius);
        let centre = self.d.point(x + y + spoke.clone());
        let slip = Vector::Velocity(centre) - Vector::AngularVelocity(frame).cross(spoke);
        if self.chance(0.5) {
            self.d.motion.push(Value::Vector(slip));
        } else {
            for axis in 0..2 {
                self.d.motion.push(Value::Scalar(slip.clone().dot(Vector::Axis(0, axis))));
            }
        }
        self.finish(frame, centre);
    }
}
