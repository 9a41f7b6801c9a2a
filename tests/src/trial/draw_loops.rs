//! Loops: two links are joined at the nominal positions of their points, so that the nominal configuration closes.

use super::description::Frame;
use super::draw::{Draw, Link};
use super::expression::{Scalar, Value, Vector};
use super::nominal::at_nominal;
use nalgebra::Vector3;

/// N and O as a link.
const GROUND: Link = Link { frame: 0, origin: 0, centre: 0 };

impl Draw {
    /// One or two loops, as long as something still moves.
    pub(super) fn loops(&mut self) {
        self.links_up_to(if self.planar { 4 } else { 5 });
        let mut freedom = self.d.state().len();
        for _ in 0..1 + self.below(2) {
            let (a, b) = self.two_links();
            let needs = if self.planar { 2 } else { 3 };
            match self.below(6) {
                0..=2 if needs < freedom => {
                    self.join(a, b);
                    freedom -= needs;
                }
                3 if 1 < freedom => {
                    self.rod(a, b);
                    freedom -= 1;
                }
                4 if 1 < freedom => {
                    self.guide(a, b);
                    freedom -= 1;
                }
                _ if 1 < freedom => {
                    self.gear();
                    freedom -= 1;
                }
                _ => {}
            }
        }
    }

    /// Adds links, each on the previous one, until the mechanism has this many coordinates.
    pub(super) fn links_up_to(&mut self, coordinates: usize) {
        while self.d.coordinates.len() < coordinates {
            let last = self.links.len() - 1;
            self.link(Some(last));
        }
    }

    fn two_links(&mut self) -> (Link, Link) {
        let last = self.links.len() - 1;
        let other = self.below(self.links.len());
        (self.links[last], if other == last { GROUND } else { self.links[other] })
    }

    /// The vector, fixed in a link, from its origin to a position given at the nominal configuration.
    fn arm_to(&mut self, link: Link, place: Vector3<f64>) -> Vector {
        let parts: Vec<f64> = at_nominal(&self.d, |p| {
            let from = place - p.points[link.origin].value;
            p.frames[link.frame].iter().map(|axis| axis.value.dot(&from)).collect()
        });
        let mut arm = Vector::Point(link.origin);
        for (axis, part) in parts.into_iter().enumerate().take(if self.planar { 2 } else { 3 }) {
            arm = arm + Vector::Axis(link.frame, axis).scaled(self.number(part, "m", true));
        }
        arm
    }

    fn place_of(&mut self, point: usize) -> Vector3<f64> {
        at_nominal(&self.d, |p| p.points[point].value)
    }

    /// A point of one link is a point of the other: as a vector, as components, or as a closure.
    fn join(&mut self, a: Link, b: Link) {
        let arm = self.arm(a.frame, 0.3);
        let first = self.d.point(Vector::Point(a.origin) + arm);
        let place = self.place_of(first);
        let second = self.arm_to(b, place);
        match self.below(3) {
            0 => self.d.points[first].closures.push(second),
            1 => {
                let second = self.d.point(second);
                self.d.configuration.push(Value::Vector(Vector::Point(first) - Vector::Point(second)));
            }
            _ => {
                let second = self.d.point(second);
                for axis in 0..if self.planar { 2 } else { 3 } {
                    let gap = Vector::Point(first) - Vector::Point(second);
                    self.d.configuration.push(Value::Scalar(gap.dot(Vector::Axis(0, axis))));
                }
            }
        }
    }

    /// A rod without mass keeps two points apart.
    fn rod(&mut self, a: Link, b: Link) {
        let (arm_a, arm_b) = (self.arm(a.frame, 0.3), self.arm(b.frame, 0.6));
        let first = self.d.point(Vector::Point(a.origin) + arm_a);
        let second = self.d.point(Vector::Point(b.origin) + arm_b);
        let length = (self.place_of(first) - self.place_of(second)).norm();
        let length = self.number(length, "m", true);
        let gap = Vector::Point(first) - Vector::Point(second);
        let row = if self.chance(0.5) {
            gap.clone().norm() - length.clone()
        } else {
            gap.clone().dot(gap.clone()) - Scalar::Power(Box::new(length.clone()), 2)
        };
        self.d.configuration.push(Value::Scalar(row));
        if self.states_fixed && self.planar && !self.tilted {
            self.massive_rod(gap, length, first);
        }
    }

    /// A rod in N's plane, with a frame in which it is fixed, and a body. Off the constraint its direction is no unit
    /// vector.
    fn massive_rod(&mut self, gap: Vector, length: Scalar, end: usize) {
        let one = Box::new(Scalar::number(1.0));
        let x = gap.clone().scaled(Scalar::Quotient(one, Box::new(length.clone())));
        let x = self.d.define_vector(x);
        let frame = self.d.frame(Frame::Directions(x.clone(), Vector::Axis(0, 2).cross(x)));
        let [zero, one] = [0.0, 1.0].map(Scalar::number);
        self.d.fixed.push((frame, gap, [length, zero.clone(), zero.clone()]));
        self.d.fixed.push((frame, Vector::Axis(0, 2), [zero.clone(), zero, one]));
        self.finish(frame, end);
    }

    /// A point stays on a plane of another link.
    fn guide(&mut self, a: Link, b: Link) {
        let arm = self.arm(a.frame, 0.3);
        let first = self.d.point(Vector::Point(a.origin) + arm);
        let place = self.place_of(first);
        let on_plane = self.arm_to(b, place);
        let normal = self.axis(b.frame);
        self.d.configuration.push(Value::Scalar((Vector::Point(first) - on_plane).dot(normal)));
    }

    /// One coordinate follows another.
    pub(super) fn gear(&mut self) {
        let n = self.d.coordinates.len();
        let (i, j) = (self.below(n), self.below(n));
        let (a, b) = (&self.d.coordinates[i], &self.d.coordinates[j]);
        if i == j || !a.angle || !b.angle {
            return;
        }
        let (at_a, at_b) = (a.nominal, b.nominal);
        let ratio = self.between(0.5, 2.0);
        let ratio = self.number(ratio, "", true);
        let follower = Scalar::Coordinate(j) - Scalar::number(at_b);
        self.d
            .configuration
            .push(Value::Scalar(Scalar::Coordinate(i) - Scalar::number(at_a) - ratio * follower));
    }

    /// Redundant equations: a parallelogram with three cranks, a plane that is not a coordinate plane of N, or repeated
    /// equations.
    pub(super) fn redundant(&mut self) {
        if self.chance(0.5) {
            self.tilted = true;
            let tilt = (0..2).map(|axis| (axis, Scalar::number(self.between(-1.0, 1.0)))).collect();
            let frame = self.d.frame(Frame::Rotations(0, tilt));
            let origin =
                self.d.point(Vector::Point(0) + Vector::Axis(0, 0).scaled(Scalar::Literal(0.1, "m")));
            self.links.push(Link { frame, origin, centre: origin });
        }
        if self.chance(0.4) {
            return self.parallelogram();
        }
        for _ in 0..4 {
            let last = self.links.len().checked_sub(1);
            self.link(last);
        }
        let (a, b) = (self.links[self.links.len() - 1], self.links.first().copied().unwrap_or(GROUND));
        self.join(a, b);
        if self.chance(0.5) && !self.d.configuration.is_empty() {
            let again = self.below(self.d.configuration.len());
            let factor = Scalar::number(self.between(0.5, 3.0));
            let row = match self.d.configuration[again].clone() {
                Value::Scalar(row) => Value::Scalar(factor * row),
                Value::Vector(row) => Value::Scalar(row.dot(self.axis(b.frame)) * factor),
            };
            self.d.configuration.push(row);
        }
    }

    /// Three equal cranks carry one coupler.
    fn parallelogram(&mut self) {
        let base = self.links.last().copied().unwrap_or(GROUND);
        let angle = self.between(0.5, 1.2);
        let (radius, spacing) = (self.length(0.1, 0.3), [self.length(0.3, 0.5), self.length(0.7, 0.9)]);
        let cranks: Vec<usize> = (0..3)
            .map(|_| {
                let q = self.coordinate(true);
                (self.d.coordinates[q].nominal, self.d.coordinates[q].reach) = (angle, 0.4);
                q
            })
            .collect();
        let turn = self.coordinate(true);
        (self.d.coordinates[turn].nominal, self.d.coordinates[turn].reach) = (0.0, 0.4);
        let coupler = self.d.frame(Frame::Rotations(base.frame, vec![(2, Scalar::Coordinate(turn))]));
        let mut ends = Vec::new();
        for (n, q) in cranks.into_iter().enumerate() {
            let frame = self.d.frame(Frame::Rotations(base.frame, vec![(2, Scalar::Coordinate(q))]));
            let mut foot = Vector::Point(base.origin);
            if 0 < n {
                foot = foot + Vector::Axis(base.frame, 0).scaled(spacing[n - 1].clone());
            }
            let foot = self.d.point(foot);
            self.finish(frame, foot);
            ends.push(self.d.point(Vector::Point(foot) + Vector::Axis(frame, 0).scaled(radius.clone())));
        }
        self.finish(coupler, ends[0]);
        for n in 1..3 {
            let along = Vector::Axis(coupler, 0).scaled(spacing[n - 1].clone());
            let row = Vector::Point(ends[0]) + along - Vector::Point(ends[n]);
            self.d.configuration.push(Value::Vector(row));
        }
    }
}
