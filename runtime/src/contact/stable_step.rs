//! Largest stable step of an explicit method: h_max = (sqrt(C^2 + K m) - C)/K of the square grid, for any graph.
//!
//! With tension T and length l of a spring, its ends apart by z = x_j - x_i,
//! x.Kx = sum k (d.z)^2 + T/l (z.z - (d.z)^2) <= 2 sum_i x_i.A_i x_i with A_i = sum k d d^T + T/l (1 - d d^T) over the
//! springs of point i, so no mode is stiffer than 2 lambda_max(A_i)/m_i, and a stable h is at most 2 over its square
//! root. Compression softens: without its T the sums stay a bound. A point of the square grid has A = 2 K 1, so K
//! stands for lambda_max/2 here; C likewise for the dampers. A soft ground counts as one more spring along its normal,
//! fixed at its other end, at every point, because each may touch.

use super::force::ForceLaw;
use super::ground::{ContactLaw, Ground};
use super::repertoire::Repertoire;
use super::soft;
use super::system::System;
use crate::flexible::element::{Bond, Element};
use crate::flexible::energy::eval_energies;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// The formula of [`largest_stable_step`], for messages.
pub const FORMULA: &str = "h_max = min over points of (sqrt(C^2 + K m) - C)/K, m/(2 C) where K is 0, with 2 K and 2 C the largest eigenvalues of the sums \
     of k d d^T + max(T, 0)/l (1 - d d^T) and of c d d^T + air_drag/2 over the springs of a point, with tension T and length l, and the ground";

/// Steps that differ by this many rounding units are alike.
const ALIKE: f64 = 64.0;

/// Squarings of A/trace(A) before its largest eigenvalue is read off: the 64th power.
const SQUARINGS: usize = 6;

/// Sums over the springs of one point, in memory that the caller lends.
#[derive(Clone, Copy, Debug)]
pub struct Sums<S> {
    /// Sum of k d d^T + max(T, 0)/l (1 - d d^T) (N/m).
    pub stiffness: [Vec3<S>; 3],
    /// Sum of c d d^T (N s/m).
    pub damping: [Vec3<S>; 3],
}

impl<S: Scalar> Sums<S> {
    /// No spring.
    #[must_use]
    pub fn none() -> Sums<S> {
        Sums { stiffness: [vec3::zero(); 3], damping: [vec3::zero(); 3] }
    }

    /// Adds a spring along d, or along every direction where d is None, with a stiffness across d.
    fn add(&mut self, d: Option<Vec3<S>>, share: S, (stiffness, across): (S, S), damping: S) {
        let parts =
            [(&mut self.stiffness, stiffness - across, across), (&mut self.damping, damping, S::ZERO)];
        for (sum, along, all) in parts {
            for (r, row) in sum.iter_mut().enumerate() {
                for (c, entry) in row.iter_mut().enumerate() {
                    let one = S::from_f64(f64::from(u8::from(r == c)));
                    let dyad = d.map_or(one, |d| component(d, r) * component(d, c));
                    *entry = *entry + share * (along * dyad + all * one);
                }
            }
        }
    }
}

/// Largest step (s) for which velocity Verlet and similar methods are stable; None where nothing bounds it. Dampers or
/// drag alone do, by m/(2 C).
///
/// `sums` is memory, one entry per point.
#[must_use]
pub fn largest_stable_step<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    pos: &[Vec3<S>],
    vel: &[Vec3<S>],
    sums: &mut [Sums<S>],
) -> Option<S> {
    let half = S::from_f64(0.5);
    sums.iter_mut().for_each(|sum| *sum = Sums::none());
    add_bonds(system, pos, sums);
    if let Some(ground) = &system.ground {
        let (stiffness, damping) = slopes(system, ground, pos, vel);
        sums.iter_mut().for_each(|sum| sum.add(Some(ground.normal), half, (stiffness, S::ZERO), damping));
    }
    largest_step_beside(system, sums, |_| [S::ZERO; 2])
}

/// The same by the sums that [`largest_stable_step`] has left, where springs also hold something that moves.
///
/// `beside` gives, by point, a quarter of the largest eigenvalues of M^-1 K (1/s^2) and M^-1 C (1/s) of what its springs
/// hold, with all points at rest; 0 where they hold nothing. A positive semidefinite matrix has no larger eigenvalue
/// than those of its two diagonal blocks together.
#[must_use]
pub fn largest_step_beside<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    sums: &[Sums<S>],
    beside: impl Fn(usize) -> [S; 2],
) -> Option<S> {
    let half = S::from_f64(0.5);
    let mut smallest: Option<S> = None;
    for (i, (mass, sum)) in system.body.mass.iter().zip(sums.iter()).enumerate() {
        if system.body.inverse_mass(i) == S::ZERO {
            continue;
        }
        let [stiffer, damper] = beside(i);
        let step_by = |largest: fn([Vec3<S>; 3]) -> S| {
            let stiffness = half * largest(sum.stiffness) + stiffer * *mass;
            let damping = half * (largest(sum.damping) + half * system.body.air_drag) + damper * *mass;
            stable_step(*mass, [stiffness, damping])
        };
        // Most points of a sheet are alike: a bound that costs little says that they have no smaller step.
        let enough = smallest.is_some_and(|least| {
            step_by(largest_row).is_none_or(|step| step >= least * (S::ONE - S::from_f64(ALIKE) * S::EPSILON))
        });
        if !enough && let Some(step) = step_by(largest_eigenvalue) {
            smallest = Some(smallest.map_or(step, |s| if step < s { step } else { s }));
        }
    }
    smallest
}

/// (sqrt(C^2 + K m) - C)/K (s) for a mass, K and C; None where both are 0. It is m/(sqrt(C^2 + K m) + C): no difference of
/// equal numbers where dampers prevail, and no squares, which overflow.
#[must_use]
pub fn stable_step<S: Scalar>(mass: S, [stiffness, damping]: [S; 2]) -> Option<S> {
    let elastic = stiffness.sqrt() * mass.sqrt();
    let (more, less) = (damping.max(elastic), damping.min(elastic));
    let share = if more > S::ZERO { less / more } else { S::ZERO };
    let both = more * (S::ONE + share * share).sqrt() + damping;
    (both > S::ZERO).then(|| mass / both)
}

fn add_bonds<S: Scalar, R: Repertoire<S>>(system: &System<S, R>, pos: &[Vec3<S>], sums: &mut [Sums<S>]) {
    system.elements().each_bond(pos, &mut |bond| {
        let Bond { ends: [tail, head], direction, stiffness, across, damping } = bond;
        for (i, other) in [(tail, head), (head, tail)] {
            // The factor 2 of the bound is shared by two moving ends; a single moving end counts half.
            let share = S::from_f64(if system.body.inverse_mass(other) == S::ZERO { 0.5 } else { 1.0 });
            if let Some(sum) = sums.get_mut(i) {
                sum.add(direction, share, (stiffness, across), damping);
            }
        }
    });
}

/// Stiffness (N/m) and damping (N s/m) of the ground at its deepest indentation: by the whole body as one point, with
/// all the energy that it can spend on the way to the surface.
fn slopes<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    pos: &[Vec3<S>],
    vel: &[Vec3<S>],
) -> (S, S) {
    match ground.law {
        ContactLaw::Force(ForceLaw::Penalty { stiffness }) => (stiffness, S::ZERO),
        ContactLaw::Force(ForceLaw::HuntCrossley { stiffness, dissipation }) if stiffness > S::ZERO => {
            let start = eval_energies(&system.body, pos, vel);
            let (mut energy, mut total) = (start.kinetic + start.spring, S::ZERO);
            for (mass, x) in system.body.mass.iter().zip(pos) {
                let weight = -(*mass * vec3::dot(system.body.gravity, ground.normal));
                energy = energy + (weight * ground.gap(*x)).max(S::ZERO) + soft::energy(ground, *x);
                total = total + *mass;
            }
            // m v dv = -k d^1.5 (1 + a v) dd: 2/5 k d^2.5 = m (v/a - ln(1 + a v)/a^2), m v^2/2 without a.
            let braked = dissipation * (S::from_f64(2.0) * energy / total).sqrt();
            let spent = if braked > S::from_f64(1e-3) {
                total * (braked - (S::ONE + braked).ln()) / (dissipation * dissipation)
            } else {
                energy
            };
            // N' = 3/2 k d^0.5 and the damping a k d^1.5 there.
            let power = S::from_f64(2.5) * spent / stiffness;
            let root = if power > S::ZERO { (S::from_f64(0.2) * power.ln()).exp() } else { S::ZERO };
            (S::from_f64(1.5) * stiffness * root, dissipation * stiffness * root * root * root)
        }
        _ => (S::ZERO, S::ZERO),
    }
}

/// Upper bound of the largest eigenvalue: the largest sum of absolute values of a row (Gershgorin).
fn largest_row<S: Scalar>(a: [Vec3<S>; 3]) -> S {
    a.iter().fold(S::ZERO, |most, [x, y, z]| most.max(x.abs() + y.abs() + z.abs()))
}

/// Largest eigenvalue of a symmetric positive semidefinite matrix, by repeated squaring.
fn largest_eigenvalue<S: Scalar>(a: [Vec3<S>; 3]) -> S {
    let trace = |m: &[Vec3<S>; 3]| m[0][0] + m[1][1] + m[2][2];
    if trace(&a) <= S::ZERO {
        return S::ZERO;
    }
    let mut power = over_trace(a);
    for _ in 0..SQUARINGS {
        power = over_trace(square(power));
    }
    let [x, y, z] = power;
    vec3::dot(a[0], x) + vec3::dot(a[1], y) + vec3::dot(a[2], z)
}

#[inline(always)]
fn over_trace<S: Scalar>([x, y, z]: [Vec3<S>; 3]) -> [Vec3<S>; 3] {
    let scale = S::ONE / (x[0] + y[1] + z[2]);
    [vec3::scale(x, scale), vec3::scale(y, scale), vec3::scale(z, scale)]
}

/// Square of a symmetric matrix.
#[inline(always)]
fn square<S: Scalar>([x, y, z]: [Vec3<S>; 3]) -> [Vec3<S>; 3] {
    let [xy, yz, zx] = [vec3::dot(x, y), vec3::dot(y, z), vec3::dot(z, x)];
    [[vec3::dot(x, x), xy, zx], [xy, vec3::dot(y, y), yz], [zx, yz, vec3::dot(z, z)]]
}

fn component<S: Scalar>(a: Vec3<S>, i: usize) -> S {
    a.get(i).copied().unwrap_or(S::ZERO)
}
