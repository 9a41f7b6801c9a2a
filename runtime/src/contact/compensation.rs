//! Impact with energy compensation along the springs (thesis Eqs. 4.10 to 4.13, for any masses, neighbours, contacts).
//!
//! In: positions, velocities before, the set B of points that touch. Out: velocities after, ground impulses, energy
//! lost. n is the ground's outward normal, v_b = -v_i.n > 0.
//! ```text
//! Q = eta sum_B m_i v_b^2 / 2 + anchor;   v_i.n := 0 on B
//! receivers: springs from i in B to a free point k, d = unit vector i -> k, w = d.n > 1e-6
//!   D_k += w d/m_k;  D_i -= w d/m_i;  u_i += w (d.n);  then D_i.n := 0 on B
//! A = sum m |D|^2/2;  b = sum m v.D;  A lambda^2 + b lambda = Q;  v += lambda D
//! J_i = m_i v_b + lambda u_i                                   ground impulse, >= 0
//! ```
//! The smaller root (neighbours are pushed towards the ground, Eq. 4.12) is taken if b <= 0 and every J_i >= 0, else
//! the larger one, for which J_i > 0 always. Impulses act along springs only, so only the ground impulses J_i change
//! linear and angular momentum. Two stacked unit masses give v_a' = -sqrt(v_a^2 + v_b^2), Eq. 4.13.

use super::repertoire::Repertoire;
use super::system::System;
use crate::flexible::element::Element;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Springs whose cosine with the normal is smaller than this carry no impulse.
pub const FLATTEST_RECEIVER: f64 = 1e-6;

/// The root of the energy balance that was taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Root {
    /// lambda < 0: receivers are pushed towards the ground.
    Minus,
    /// lambda > 0: receivers are lifted.
    Plus,
    /// No receiver: the points rebound or lose their energy.
    Alone,
}

/// Working memory and result of one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointImpact<S> {
    /// Whether the point is in the set B.
    pub touching: bool,
    /// D: change of velocity per lambda [1/kg].
    pub field: Vec3<S>,
    /// u: ground impulse per lambda.
    pub lift: S,
    /// Speed of approach v_b before the impact (m/s).
    pub approach: S,
    /// Normal impulse of the ground (N s), >= 0.
    pub impulse: S,
}

impl<S: Scalar> PointImpact<S> {
    /// A point that takes no part.
    #[must_use]
    pub fn none() -> PointImpact<S> {
        PointImpact {
            touching: false,
            field: vec3::zero(),
            lift: S::ZERO,
            approach: S::ZERO,
            impulse: S::ZERO,
        }
    }
}

/// Result of one impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact<S> {
    /// The root taken.
    pub root: Root,
    /// lambda (N s): impulse in a spring is lambda w.
    pub lambda: S,
    /// Kinetic energy lost by the law (J): (1 - eta) of the touching points' energy of approach.
    pub lost: S,
    /// Energy lost to friction (J).
    pub friction: S,
}

/// Applies the impact to `vel`; B is marked in `points`, which returns the impulses.
///
/// `receiver(k)` tells whether point k may take energy (not fixed, not touching, not resting).
/// `anchor` (J) is added to the compensated energy as long as Q >= 0; with 0 the law is unchanged.
pub fn apply<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    law: Compensation<S>,
    pos: &[Vec3<S>],
    vel: &mut [Vec3<S>],
    points: &mut [PointImpact<S>],
    receiver: impl Fn(usize) -> bool,
) -> Impact<S> {
    let taken = stop_touching(system, vel, points);
    let compensated = law.eta * taken;
    let energy = (compensated + law.anchor).max(S::ZERO);
    build_field(system, pos, points, receiver);
    let (a, b) = quadratic(system, vel, points);
    let nothing = S::ZERO;
    if a <= nothing {
        let restored = rebound(system, law, vel, points);
        return Impact { root: Root::Alone, lambda: nothing, lost: taken - restored, friction: nothing };
    }
    let (root, lambda) = choose_root(system, points, a, b, energy);
    for (i, (v, point)) in vel.iter_mut().zip(points.iter_mut()).enumerate() {
        *v = vec3::axpy(*v, lambda, point.field);
        if point.touching {
            point.impulse = (mass(system, i) * point.approach + lambda * point.lift).max(nothing);
        }
    }
    Impact { root, lambda, lost: taken - compensated, friction: nothing }
}

/// Parameters of the law for one impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensation<S> {
    /// Share of the energy that is given back.
    pub eta: S,
    /// Energy added to correct drift (J).
    pub anchor: S,
    /// Whether a point without a receiver loses its energy.
    pub plastic_alone: bool,
    /// First point that may take energy.
    pub first_receiver: usize,
}

fn mass<S: Scalar, R: Repertoire<S>>(system: &System<S, R>, i: usize) -> S {
    system.body.mass.get(i).copied().unwrap_or(S::ZERO)
}

/// Sets v_i.n = 0 on B; returns the kinetic energy removed (J).
fn stop_touching<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    vel: &mut [Vec3<S>],
    points: &mut [PointImpact<S>],
) -> S {
    let Some(ground) = system.ground else { return S::ZERO };
    let mut taken = S::ZERO;
    for (i, (v, point)) in vel.iter_mut().zip(points.iter_mut()).enumerate() {
        point.field = vec3::zero();
        point.lift = S::ZERO;
        point.impulse = S::ZERO;
        if point.touching {
            point.approach = -ground.gap_rate(*v);
            *v = vec3::tangential(*v, ground.normal);
            taken = taken + S::from_f64(0.5) * mass(system, i) * point.approach * point.approach;
        }
    }
    taken
}

/// Builds D and u: the effect of unit impulses along the springs between B and the receivers.
fn build_field<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    pos: &[Vec3<S>],
    points: &mut [PointImpact<S>],
    receiver: impl Fn(usize) -> bool,
) {
    let Some(ground) = system.ground else { return };
    let touches = |points: &[PointImpact<S>], i: usize| points.get(i).is_some_and(|p| p.touching);
    system.elements().each_link(&mut |[tail, head]| {
        for (i, k) in [(tail, head), (head, tail)] {
            if !touches(points, i) || touches(points, k) || !receiver(k) {
                continue;
            }
            let (d, _) = vec3::direction(vec3::sub(vec3::at(pos, k), vec3::at(pos, i)));
            let w = vec3::dot(d, ground.normal);
            if w > S::from_f64(FLATTEST_RECEIVER) {
                if let Some(p) = points.get_mut(k) {
                    p.field = vec3::axpy(p.field, w * system.body.inverse_mass(k), d);
                }
                if let Some(p) = points.get_mut(i) {
                    // The ground takes the normal part of the reaction, the point the rest.
                    let along = vec3::tangential(d, ground.normal);
                    p.field = vec3::axpy(p.field, -(w * system.body.inverse_mass(i)), along);
                    p.lift = p.lift + w * w;
                }
            }
        }
    });
}

/// A = sum m |D|^2/2 and b = sum m v.D.
fn quadratic<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    vel: &[Vec3<S>],
    points: &[PointImpact<S>],
) -> (S, S) {
    let (mut a, mut b) = (S::ZERO, S::ZERO);
    for (i, (v, point)) in vel.iter().zip(points).enumerate() {
        a = a + S::from_f64(0.5) * mass(system, i) * vec3::dot(point.field, point.field);
        b = b + mass(system, i) * vec3::dot(*v, point.field);
    }
    (a, b)
}

/// The root of A lambda^2 + b lambda = Q for which the ground pushes.
fn choose_root<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    points: &[PointImpact<S>],
    a: S,
    b: S,
    energy: S,
) -> (Root, S) {
    let two = S::from_f64(2.0);
    let s = (b * b + S::from_f64(4.0) * a * energy).sqrt();
    if b <= S::ZERO {
        // 2 Q/(b - s) = (-b - s)/(2 A) without cancellation; b - s = 0 only if nothing moves.
        let minus = if b < s { two * energy / (b - s) } else { S::ZERO };
        let holds = |(i, p): (usize, &PointImpact<S>)| {
            !p.touching || mass(system, i) * p.approach + minus * p.lift >= S::ZERO
        };
        if points.iter().enumerate().all(holds) {
            return (Root::Minus, minus);
        }
        return (Root::Plus, (s - b) / (two * a));
    }
    (Root::Plus, two * energy / (b + s))
}

/// Without a receiver each point keeps eta of its own energy; returns the energy kept (J).
fn rebound<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    law: Compensation<S>,
    vel: &mut [Vec3<S>],
    points: &mut [PointImpact<S>],
) -> S {
    let Some(ground) = system.ground else { return S::ZERO };
    let ratio = if law.plastic_alone { S::ZERO } else { law.eta.sqrt() };
    let mut restored = S::ZERO;
    for (i, (v, point)) in vel.iter_mut().zip(points.iter_mut()).enumerate() {
        if point.touching {
            let speed = ratio * point.approach;
            *v = vec3::axpy(*v, speed, ground.normal);
            point.impulse = mass(system, i) * (point.approach + speed);
            restored = restored + S::from_f64(0.5) * mass(system, i) * speed * speed;
        }
    }
    restored
}
