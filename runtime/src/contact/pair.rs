//! Impact between two flexible bodies: a point of one strikes a facet of the other; both take energy along their
//! springs.
//!
//! Both bodies are one list of points. n points from the facet's body to the point's. The facet takes part
//! through the contact point, the sum of beta_j x_j, whose velocity is the sum of beta_j v_j; the effective mass M is
//! 1/M = 1/m_i + sum beta_j^2/m_j.
//! ```text
//! v_b = -(v_i - sum beta_j v_j).n > 0;   Q = eta M v_b^2/2
//! J_0 = M v_b on i along n, -beta_j J_0 on the corners: the gap's rate is 0
//! receivers: springs from i to k with w = d.n > 1e-6:                D_k += w d/m_k;  D_i -= w d/m_i
//!            springs from corner j to k with w = -beta_j d.n > 1e-6:  likewise
//! then u = -M (D_i - sum beta_j D_j).n >= 0 between the two:  D_i += u n/m_i;  D_j -= beta_j u n/m_j
//! A lambda^2 + b lambda = Q;  v += lambda D;  J = J_0 + lambda u
//! ```
//! The root is chosen as on the ground: the smaller one if b <= 0 and J >= 0. Every impulse has its opposite on
//! the same line, so linear and angular momentum of the whole are conserved (if the point lies on the facet).

use super::compensation::{FLATTEST_RECEIVER, Root};
use crate::flexible::Body;
use crate::flexible::element::Element;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// The contact of a point with a facet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch<S> {
    /// The point i, not among the corners.
    pub point: usize,
    /// The corners j; one that takes no part has beta = 0.
    pub corners: [usize; 4],
    /// beta_j, with sum 1.
    pub weights: [S; 4],
    /// n, from the facet's body to the point's.
    pub normal: Vec3<S>,
}

/// Result of the impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairImpact<S> {
    /// The root taken.
    pub root: Root,
    /// Speed of approach v_b (m/s).
    pub approach: S,
    /// lambda (N s).
    pub lambda: S,
    /// J (N s), >= 0.
    pub impulse: S,
    /// Energy lost, (1 - eta) M v_b^2/2 (J).
    pub lost: S,
}

/// Applies the impact to `vel`; `field` is working memory of one vector per point. None if the two are not closing.
pub fn apply<S: Scalar>(
    body: &Body<S>,
    touch: &Touch<S>,
    eta: S,
    pos: &[Vec3<S>],
    vel: &mut [Vec3<S>],
    field: &mut [Vec3<S>],
) -> Option<PairImpact<S>> {
    let approach = -touch.gap_rate(vel);
    if approach <= S::ZERO {
        return None;
    }
    let mass = S::ONE / touch.inverse_mass(body);
    touch.push(body, mass * approach, vel);
    let taken = S::from_f64(0.5) * mass * approach * approach;
    field.iter_mut().for_each(|d| *d = vec3::zero());
    build_field(body, touch, pos, field);
    let lift = -(mass * touch.gap_rate(field));
    touch.push(body, lift, field);
    let (mut a, mut b) = (S::ZERO, S::ZERO);
    for ((m, v), d) in body.mass.iter().zip(vel.iter()).zip(field.iter()) {
        a = a + S::from_f64(0.5) * *m * vec3::dot(*d, *d);
        b = b + *m * vec3::dot(*v, *d);
    }
    let first = mass * approach;
    if a <= S::ZERO {
        // No receiver for the energy: the two rebound from each other.
        let more = eta.sqrt() * first;
        touch.push(body, more, vel);
        let lost = (S::ONE - eta) * taken;
        return Some(PairImpact {
            root: Root::Alone,
            approach,
            lambda: S::ZERO,
            impulse: first + more,
            lost,
        });
    }
    let energy = eta * taken;
    let s = (b * b + S::from_f64(4.0) * a * energy).sqrt();
    let minus = if b < s { S::from_f64(2.0) * energy / (b - s) } else { S::ZERO };
    let plus =
        if b > S::ZERO { S::from_f64(2.0) * energy / (b + s) } else { (s - b) / (S::from_f64(2.0) * a) };
    let down = b <= S::ZERO && first + minus * lift >= S::ZERO;
    let (root, lambda) = if down { (Root::Minus, minus) } else { (Root::Plus, plus) };
    for (v, d) in vel.iter_mut().zip(field.iter()) {
        *v = vec3::axpy(*v, lambda, *d);
    }
    let impulse = (first + lambda * lift).max(S::ZERO);
    Some(PairImpact { root, approach, lambda, impulse, lost: taken - energy })
}

impl<S: Scalar> Touch<S> {
    fn parts(&self) -> impl Iterator<Item = (usize, S)> {
        self.corners.into_iter().zip(self.weights)
    }

    /// Gap rate, for velocities or for changes of velocity.
    fn gap_rate(&self, vel: &[Vec3<S>]) -> S {
        let mut between = vec3::at(vel, self.point);
        for (j, beta) in self.parts() {
            between = vec3::axpy(between, -beta, vec3::at(vel, j));
        }
        vec3::dot(between, self.normal)
    }

    /// 1/M; the weights of a corner listed twice add up.
    fn inverse_mass(&self, body: &Body<S>) -> S {
        let mut sum = body.inverse_mass(self.point);
        for (j, beta) in self.parts() {
            let whole = self.weight_of(j);
            sum = sum + beta * whole * body.inverse_mass(j);
        }
        sum
    }

    fn weight_of(&self, point: usize) -> S {
        let of_point = self.parts().filter(|(j, _)| *j == point);
        of_point.fold(S::ZERO, |sum, (_, beta)| sum + beta)
    }

    /// Applies the impulse J to the point and -beta_j J to the corners.
    fn push(&self, body: &Body<S>, impulse: S, vel: &mut [Vec3<S>]) {
        let mut give = |k: usize, j: S| {
            vec3::add_at(vel, k, vec3::scale(self.normal, j * body.inverse_mass(k)));
        };
        give(self.point, impulse);
        for (j, beta) in self.parts() {
            give(j, -(beta * impulse));
        }
    }
}

/// D: unit impulses along the springs from the contact's points into their own bodies.
fn build_field<S: Scalar>(body: &Body<S>, touch: &Touch<S>, pos: &[Vec3<S>], field: &mut [Vec3<S>]) {
    let takes_part = |k: usize| k == touch.point || touch.corners.contains(&k);
    body.elements().each_link(&mut |[tail, head]| {
        for (i, k) in [(tail, head), (head, tail)] {
            if !takes_part(i) || takes_part(k) || body.inverse_mass(k) == S::ZERO {
                continue;
            }
            let share = if i == touch.point { S::ONE } else { -touch.weight_of(i) };
            let (d, _) = vec3::direction(vec3::sub(vec3::at(pos, k), vec3::at(pos, i)));
            let w = share * vec3::dot(d, touch.normal);
            if w > S::from_f64(FLATTEST_RECEIVER) {
                vec3::add_at(field, k, vec3::scale(d, w * body.inverse_mass(k)));
                vec3::add_at(field, i, vec3::scale(d, -(w * body.inverse_mass(i))));
            }
        }
    });
}
