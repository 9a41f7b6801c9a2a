//! Massless contact points (mass redistribution, Khenous, Laborde & Renard 2008): their position follows from statics.
//!
//! A point of mass 0 is where its springs balance, on or above the ground: it minimises sum K (|x - x_k| - L)^2/2 with
//! gap >= 0. Without inertia there is no impact and no event: the contact force is continuous. Dampers of its springs
//! must be 0, because its speed is not a state. Newton's method where the stiffness is positive definite, else
//! Gauss-Newton; a small ridge selects the least motion where a chain leaves directions undetermined. First without the
//! ground, then along the surface if the point ended below it. Several such points are swept in turn. With friction
//! (Coulomb, quasi-static) a point stays where it was, or where it came down, as long as its springs pull it sideways
//! by |T| <= mu N; beyond that it follows them until T = mu N d, d the direction in which it has moved.

use super::ground::Ground;
use crate::flexible::{Body, Spring};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Most Newton corrections of one point in one sweep.
const CORRECTIONS: usize = 30;
/// The same with friction, where the normal force is that of the correction before.
const SLIDES: usize = 60;
/// Most sweeps over all massless points; one suffices where no spring joins two of them.
const SWEEPS: usize = 30;
/// Ridge relative to the stiffness, in square roots of the rounding unit: it determines a chain's free directions; its
/// square must exceed rounding in the determinant of a single spring.
const RIDGE: f64 = 32.0;

/// Moves every massless point to equilibrium, starting from its position; `origins` is memory, one entry per point.
pub fn settle<S: Scalar>(body: &Body<S>, ground: &Ground<S>, pos: &mut [Vec3<S>], origins: &mut [Vec3<S>]) {
    for (i, _) in body.massless.iter() {
        if let Some(origin) = origins.get_mut(i) {
            *origin = vec3::at(pos, i);
        }
    }
    for _ in 0..SWEEPS {
        let mut largest_move = S::ZERO;
        for (i, springs) in body.massless.iter() {
            let before = vec3::at(pos, i);
            let at = Point { body, ground, springs, i };
            at.settle(pos, vec3::at(origins, i));
            largest_move = largest_move.max(vec3::norm(vec3::sub(vec3::at(pos, i), before)));
        }
        if largest_move <= ground.tolerance {
            return;
        }
    }
}

/// A massless point with its springs.
#[derive(Clone, Copy)]
struct Point<'a, 'b, S> {
    body: &'a Body<'b, S>,
    ground: &'a Ground<S>,
    springs: &'a [usize],
    i: usize,
}

impl<S: Scalar> Point<'_, '_, S> {
    fn settle(&self, pos: &mut [Vec3<S>], origin: Vec3<S>) {
        self.balance_by(pos, false);
        let free = vec3::at(pos, self.i);
        let gap = self.ground.gap(free);
        if gap >= S::ZERO {
            return;
        }
        let below = vec3::axpy(free, -gap, self.ground.normal);
        if self.ground.friction > S::ZERO {
            self.slide(pos, self.foot(origin, free, below));
            return;
        }
        vec3::set_at(pos, self.i, below);
        self.balance_by(pos, true);
        let gap = self.ground.gap(vec3::at(pos, self.i));
        if gap < S::ZERO {
            vec3::add_at(pos, self.i, vec3::scale(self.ground.normal, -gap));
        }
    }

    /// Newton corrections until the springs balance, freely or along the surface.
    fn balance_by(&self, pos: &mut [Vec3<S>], sliding: bool) {
        for _ in 0..CORRECTIONS {
            let (force, stiffness) = self.balance(pos, sliding);
            let correction = solve(stiffness, force);
            let correction =
                if sliding { vec3::tangential(correction, self.ground.normal) } else { correction };
            vec3::add_at(pos, self.i, correction);
            if self.is_small(pos, correction) {
                break;
            }
        }
    }

    fn balance(&self, pos: &[Vec3<S>], sliding: bool) -> (Vec3<S>, [Vec3<S>; 3]) {
        let springs = self.springs.iter().filter_map(|s| self.body.springs.get(*s));
        balance(springs, self.ground, pos, self.i, sliding)
    }

    fn is_small(&self, pos: &[Vec3<S>], correction: Vec3<S>) -> bool {
        vec3::norm(correction) <= S::EPSILON * (S::ONE + vec3::norm(vec3::at(pos, self.i)))
    }

    /// Where friction would keep the point: where it was on the surface, or where it came down to it on its way.
    fn foot(&self, origin: Vec3<S>, free: Vec3<S>, below: Vec3<S>) -> Vec3<S> {
        let (above, under) = (self.ground.gap(origin), self.ground.gap(free));
        let part = if above > self.ground.tolerance { above / (above - under) } else { S::ZERO };
        let way = vec3::tangential(vec3::sub(below, origin), self.ground.normal);
        vec3::axpy(vec3::axpy(origin, -above, self.ground.normal), part, way)
    }

    /// Slides from the foot along the surface as far as the springs overcome friction: Newton's method for T = mu N d,
    /// in which the normal force and the direction d of the displacement follow the position; a correction that
    /// increased the residual is halved.
    fn slide(&self, pos: &mut [Vec3<S>], foot: Vec3<S>) {
        let (ground, n) = (self.ground, self.ground.normal);
        vec3::set_at(pos, self.i, foot);
        let (mut direction, mut way) = (vec3::zero(), S::ZERO);
        let (mut least, mut step) = (None, vec3::zero());
        for correction in 0..SLIDES {
            let (force, whole) = self.balance(pos, false);
            let largest = ground.friction * (-vec3::dot(force, n)).max(S::ZERO);
            let side = vec3::tangential(force, n);
            if correction == 0 {
                let (along, pull) = vec3::direction(side);
                if pull <= largest {
                    return;
                }
                direction = along;
            }
            let (_, mut stiffness) = self.balance(pos, true);
            let turn = if way > S::ZERO { largest / way } else { S::ZERO };
            let normal = if largest > S::ZERO { ground.friction } else { S::ZERO };
            let grown = vec3::scale(vec3::tangential(vec3::apply(&whole, n), n), normal);
            let axes = [[S::ONE, S::ZERO, S::ZERO], [S::ZERO, S::ONE, S::ZERO], [S::ZERO, S::ZERO, S::ONE]];
            for ((row, axis), along) in stiffness.iter_mut().zip(axes).zip(direction) {
                let across = vec3::axpy(vec3::tangential(axis, n), -along, direction);
                *row = vec3::axpy(vec3::axpy(*row, turn, across), along, grown);
            }
            let excess = vec3::axpy(side, -largest, direction);
            let left = vec3::norm(excess);
            let change = if least.is_some_and(|least| left > least) {
                step = vec3::scale(step, S::from_f64(0.5));
                vec3::scale(step, -S::ONE)
            } else {
                // At the foot friction may have any direction, so the residual there cannot be compared.
                least = (way > S::ZERO).then_some(left);
                step = vec3::tangential(solve(stiffness, excess), n);
                step
            };
            vec3::add_at(pos, self.i, change);
            let moved = vec3::tangential(vec3::sub(vec3::at(pos, self.i), foot), n);
            (direction, way) = match vec3::direction(moved) {
                (along, way) if way > S::ZERO => (along, way),
                _ => (direction, S::ZERO),
            };
            if self.is_small(pos, change) {
                return;
            }
        }
    }
}

/// Energy that friction dissipates at the massless points between two states (J): for those on the ground at both, by
/// the mean of the spring forces that slid them.
pub fn friction_loss<S: Scalar>(
    body: &Body<S>,
    ground: &Ground<S>,
    [x0, x1]: [&[Vec3<S>]; 2],
    [f0, f1]: [&[Vec3<S>]; 2],
) -> S {
    let mut lost = S::ZERO;
    for (i, _) in body.massless.iter() {
        let on_ground = |x: &[Vec3<S>]| ground.gap(vec3::at(x, i)) <= ground.tolerance;
        if on_ground(x0) && on_ground(x1) {
            let way = vec3::tangential(vec3::sub(vec3::at(x1, i), vec3::at(x0, i)), ground.normal);
            let force = vec3::add(vec3::at(f0, i), vec3::at(f1, i));
            lost = lost + (S::from_f64(0.5) * vec3::dot(force, way)).max(S::ZERO);
        }
    }
    lost
}

/// Spring force on point i and its stiffness, both along the surface only if `sliding`: the sum of
/// K d d^T + K (1 - L/l) (1 - d d^T) + ridge, without the second term where the sum would be indefinite.
fn balance<'s, S: Scalar>(
    springs: impl Iterator<Item = &'s Spring<S>>,
    ground: &Ground<S>,
    pos: &[Vec3<S>],
    i: usize,
    sliding: bool,
) -> (Vec3<S>, [Vec3<S>; 3]) {
    let mut force = vec3::zero();
    let mut stiffness = [vec3::zero(); 3];
    let mut exact = [vec3::zero(); 3];
    let mut ridge = S::ZERO;
    for spring in springs {
        let other = if spring.tail == i { spring.head } else { spring.tail };
        let (d, length) = vec3::direction(vec3::sub(vec3::at(pos, other), vec3::at(pos, i)));
        let d = if sliding { vec3::tangential(d, ground.normal) } else { d };
        force = vec3::axpy(force, spring.tension(length), d);
        let across = if length > S::ZERO { spring.tension(length) / length } else { S::ZERO };
        let axes = [[S::ONE, S::ZERO, S::ZERO], [S::ZERO, S::ONE, S::ZERO], [S::ZERO, S::ZERO, S::ONE]];
        let rows = stiffness.iter_mut().zip(exact.iter_mut()).zip(axes.iter().zip(d));
        for ((row, exact), (axis, component)) in rows {
            *row = vec3::axpy(*row, spring.stiffness * component, d);
            let axis = if sliding { vec3::tangential(*axis, ground.normal) } else { *axis };
            *exact = vec3::axpy(*exact, (spring.stiffness - across) * component, d);
            *exact = vec3::axpy(*exact, across, axis);
        }
        ridge = ridge + S::from_f64(RIDGE) * S::EPSILON.sqrt() * spring.stiffness;
    }
    let ridged = |mut a: [Vec3<S>; 3]| {
        a[0][0] = a[0][0] + ridge;
        a[1][1] = a[1][1] + ridge;
        a[2][2] = a[2][2] + ridge;
        a
    };
    if sliding {
        // Along the normal nothing may move: any stiffness there keeps the system well conditioned.
        let across = ridge / (S::from_f64(RIDGE) * S::EPSILON.sqrt());
        let rows = stiffness.iter_mut().zip(exact.iter_mut()).zip(ground.normal);
        for ((row, exact), component) in rows {
            *row = vec3::axpy(*row, across * component, ground.normal);
            *exact = vec3::axpy(*exact, across * component, ground.normal);
        }
    }
    let exact = ridged(exact);
    (force, if is_positive_definite(&exact) { exact } else { ridged(stiffness) })
}

/// Sylvester's criterion.
fn is_positive_definite<S: Scalar>(a: &[Vec3<S>; 3]) -> bool {
    let minors = vec3::cross(a[1], a[2]);
    a[0][0] > S::ZERO && a[0][0] * a[1][1] - a[0][1] * a[1][0] > S::ZERO && vec3::dot(a[0], minors) > S::ZERO
}

/// Solves the symmetric 3 x 3 system by Cramer's rule; 0 if it is singular.
fn solve<S: Scalar>(a: [Vec3<S>; 3], b: Vec3<S>) -> Vec3<S> {
    let minors = [vec3::cross(a[1], a[2]), vec3::cross(a[2], a[0]), vec3::cross(a[0], a[1])];
    let determinant = vec3::dot(a[0], minors[0]);
    if determinant == S::ZERO {
        return vec3::zero();
    }
    let sum = vec3::axpy(vec3::axpy(vec3::scale(minors[0], b[0]), b[1], minors[1]), b[2], minors[2]);
    vec3::scale(sum, S::ONE / determinant)
}
