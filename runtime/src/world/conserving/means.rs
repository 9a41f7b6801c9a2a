//! Contacts at the mean positions of a step, where their impulses leave no moment.
//!
//! In: frames of the ports at the start, at the end and where contacts were detected; mean positions of the nodes. Out:
//! a contact with arms from the mean origins to the mean contact points.

use super::MeanMemory;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Point, Side, Twist};
use crate::surface::Frame;
use crate::vec3::{self, Vec3};

impl<S: Scalar> MeanMemory<'_, S> {
    /// Mean positions over a step that ends with these frames.
    pub(super) fn at<'m>(&'m self, frames: &'m [Frame<S>]) -> Mean<'m, S> {
        Mean { frames: [&*self.frames[0], frames, &*self.frames[1]], nodes: &*self.nodes[1] }
    }

    /// Mean velocities of the ports over a step of h (s) that ends with these frames.
    pub(super) fn read_ports(&self, h: S, frames: &[Frame<S>], twists: &mut [Twist<S>]) {
        for ((from, to), twist) in self.frames[0].iter().zip(frames).zip(twists) {
            let (velocity, angular) = from.way_to(to, h);
            *twist = Twist { velocity, angular };
        }
    }
}

/// Mean positions over a step.
pub(super) struct Mean<'m, S> {
    /// Frames of the ports at the start, at the end, and where contacts were detected.
    pub(super) frames: [&'m [Frame<S>]; 3],
    /// Mean positions of the nodes.
    pub(super) nodes: &'m [Vec3<S>],
}

impl<S: Scalar> Mean<'_, S> {
    /// The contact with arms from the mean origins of the frames to the mean contact points. A point of a rigid body
    /// slips along the other side during the step; it is moved to where the other side is, so that the two opposite
    /// forces leave no moment.
    pub(super) fn contact(&self, contact: &Contact<S>) -> Contact<S> {
        let mut new = *contact;
        new.sides = contact.sides.map(|side| side.with_arms(|point| self.arm(point)));
        let [one, other] = new.sides.map(|side| self.place(&side));
        let Some(apart) = one.zip(other).map(|(one, other)| vec3::sub(other, one)) else { return new };
        let is_rigid = |side: &Side<S>| {
            let mut points = side.points();
            points.next().is_some_and(|point| point.body < self.frames[0].len()) && points.next().is_none()
        };
        let [one, other] = new.sides;
        // Between two rigid points each goes half of the way, so that neither is the first.
        let [first, second] = match [&one, &other].map(is_rigid) {
            [true, true] => [0.5, -0.5],
            [true, false] => [1.0, 0.0],
            [false, true] => [0.0, -1.0],
            _ => return new,
        }
        .map(S::from_f64);
        new.sides = [(one, first), (other, second)]
            .map(|(side, part)| side.with_arms(|point| vec3::axpy(point.arm, part, apart)));
        new
    }

    /// The frames of a port; None for a node.
    fn port(&self, body: usize) -> Option<[&Frame<S>; 3]> {
        let [from, to, seen] = self.frames.map(|frames| frames.get(body));
        Some([from?, to?, seen?])
    }

    fn arm(&self, point: &Point<S>) -> Vec3<S> {
        let Some([from, to, seen]) = self.port(point.body) else { return point.arm };
        let own = seen.to_local(point.arm);
        vec3::scale(vec3::add(from.to_inertial(own), to.to_inertial(own)), S::from_f64(0.5))
    }

    /// The mean position of a side; None where it is fixed in space.
    fn place(&self, side: &Side<S>) -> Option<Vec3<S>> {
        let ports = self.frames[0].len();
        let of = |point: &Point<S>| match self.port(point.body) {
            Some([from, to, _]) => vec3::axpy(point.arm, S::from_f64(0.5), vec3::add(from.origin, to.origin)),
            None => vec3::at(self.nodes, point.body - ports),
        };
        let sum = |sum, point: &Point<S>| Some(vec3::axpy(sum?, point.weight, of(point)));
        side.points().next()?;
        // A side that is partly fixed in space has no such position: the weights of its points do not add up to 1.
        let whole = side.points().fold(S::ZERO, |sum, point| sum + point.weight);
        ((whole - S::ONE).abs() < S::from_f64(1e-3)).then(|| side.points().fold(Some(vec3::zero()), sum))?
    }
}
