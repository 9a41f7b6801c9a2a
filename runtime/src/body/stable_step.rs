//! Largest stable step of an explicit method: h_max = (sqrt(C^2 + K m) - C)/K of the square grid, for any graph.
//!
//! x.Kx = sum k (d.(x_j - x_i))^2 <= 2 sum_i x_i.A_i x_i with A_i = sum k d d^T over the springs of
//! point i, so no mode is stiffer than 2 lambda_max(A_i)/m_i, and a stable h is at most 2 over its root.
//! A point of the square grid has A = 2 K 1: K stands for lambda_max/2 here, C likewise for the dampers.

use super::Body;
use super::vec3::{self, Vec3};
use crate::real::Scalar;

/// The formula of [`largest_stable_step`], for messages.
pub const FORMULA: &str = "h_max = min over points of (sqrt(C^2 + K m) - C)/K, with 2 K and 2 C the largest eigenvalues of the sums \
     of k d d^T and c d d^T over the springs of a point";

/// Squarings of A/trace(A) before its dominant eigenvalue is read off: the 64th power.
const SQUARINGS: usize = 6;

/// Largest step (s) for which velocity Verlet and its kin stay stable; None where no spring bounds it.
#[must_use]
pub fn largest_stable_step<S: Scalar>(body: &Body<S>, pos: &[Vec3<S>]) -> Option<S> {
    let half = S::from_f64(0.5);
    let mut smallest: Option<S> = None;
    for (i, mass) in body.mass.iter().enumerate() {
        if body.inverse_mass(i) == S::ZERO {
            continue;
        }
        let stiffness = half * dominant_sum(body, pos, i, |s| s.stiffness);
        let damping = half * (dominant_sum(body, pos, i, |s| s.damping) + half * body.air_drag);
        if stiffness > S::ZERO {
            let step = ((damping * damping + stiffness * *mass).sqrt() - damping) / stiffness;
            smallest = Some(smallest.map_or(step, |s| if step < s { step } else { s }));
        }
    }
    smallest
}

/// Largest eigenvalue of the sum of w d d^T over the springs of point i.
fn dominant_sum<S: Scalar>(
    body: &Body<S>,
    pos: &[Vec3<S>],
    i: usize,
    weight: impl Fn(&super::Spring<S>) -> S,
) -> S {
    let mut sum = [[S::ZERO; 3]; 3];
    for spring in body.springs.iter().filter(|s| s.head == i || s.tail == i) {
        let other = if spring.head == i { spring.tail } else { spring.head };
        // The bound's factor 2 is shared between two ends that move; one end alone takes half of it.
        let share = S::from_f64(if body.inverse_mass(other) == S::ZERO { 0.5 } else { 1.0 });
        let (d, length) = spring.direction(pos);
        for (r, row) in sum.iter_mut().enumerate() {
            for (c, entry) in row.iter_mut().enumerate() {
                // Without a direction the spring may act along any.
                let dyad = if length > S::ZERO {
                    component(d, r) * component(d, c)
                } else {
                    S::from_f64(f64::from(u8::from(r == c)))
                };
                *entry = *entry + share * weight(spring) * dyad;
            }
        }
    }
    largest_eigenvalue(sum)
}

/// Of a symmetric positive semidefinite matrix, by repeated squaring.
fn largest_eigenvalue<S: Scalar>(a: [Vec3<S>; 3]) -> S {
    let trace = |m: &[Vec3<S>; 3]| m[0][0] + m[1][1] + m[2][2];
    if trace(&a) <= S::ZERO {
        return S::ZERO;
    }
    let product = |x: &[Vec3<S>; 3], y: &[Vec3<S>; 3]| x.map(|row| y.map(|column| vec3::dot(row, column)));
    let mut power = a.map(|row| vec3::scale(row, S::ONE / trace(&a)));
    for _ in 0..SQUARINGS {
        let square = product(&power, &power);
        power = square.map(|row| vec3::scale(row, S::ONE / trace(&square)));
    }
    trace(&product(&a, &power))
}

fn component<S: Scalar>(a: Vec3<S>, i: usize) -> S {
    a.get(i).copied().unwrap_or(S::ZERO)
}
