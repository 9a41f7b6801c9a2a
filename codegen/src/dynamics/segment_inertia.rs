//! Translational inertia of a tree of segments (see `segment`) by sums over everything beyond a segment.
//!
//! A centre's velocity is the sum over the segments that lead to it. Hence, instead of a sum over all bodies, M_kl =
//! sum over pairs of segments of m v_k . v_l, where m is the mass at and beyond the outer segment of the pair if the
//! inner one leads to it, else 0; and h_k = sum_s v_k . H_s, with H_s = sum m (a_bias - g) over the centres at and
//! beyond segment s.

use super::mass_and_force::MassAndForce;
use super::segment::Segment;
use crate::expr::ExprId;
use crate::kinematics::UnknownId;
use crate::vector::{Algebra, TriadId, Vector};

/// Adds the inertia of all centres.
pub(super) fn accumulate(alg: &mut Algebra, segments: &[Segment], parts: &mut MassAndForce) {
    let masses = masses_beyond(alg, segments);
    for (t, &mass) in masses.iter().enumerate() {
        let outer = partials(&segments[t]);
        let mut at = Some(t);
        while let Some(s) = at {
            let inner = partials(&segments[s]);
            for (i, (a, v)) in inner.iter().enumerate() {
                // For a segment with itself each pair once, for two segments all pairs.
                for (b, w) in &outer[if s == t { i } else { 0 }..] {
                    let product = alg.dot(v, w);
                    let term = alg.dag.mul(mass, product);
                    // Two different segments contribute to the diagonal in both orders.
                    for _ in 0..if a == b && s != t { 2 } else { 1 } {
                        add_mass(alg, parts, (*a, *b), term);
                    }
                }
            }
            at = segments[s].inner;
        }
    }
    for (segment, force) in segments.iter().zip(bias_forces_beyond(alg, segments)) {
        for (a, v) in partials(segment) {
            let term = alg.dot(&v, &force);
            let term = alg.dag.negate(term);
            parts.add_force(&mut alg.dag, a, term);
        }
    }
}

fn add_mass(alg: &mut Algebra, parts: &mut MassAndForce, (a, b): (UnknownId, UnknownId), term: ExprId) {
    if !alg.dag.is_zero(term) {
        parts.add_mass(&mut alg.dag, a, b, term);
    }
}

fn partials(segment: &Segment) -> Vec<(UnknownId, Vector)> {
    segment.motion.partials.iter().map(|(&unknown, v)| (unknown, v.clone())).collect()
}

/// Mass at and beyond the outer end of every segment.
fn masses_beyond(alg: &mut Algebra, segments: &[Segment]) -> Vec<ExprId> {
    let mut masses: Vec<ExprId> = segments.iter().map(|s| s.mass).collect();
    for (s, segment) in segments.iter().enumerate().rev() {
        if let Some(inner) = segment.inner {
            masses[inner] = alg.dag.add(masses[inner], masses[s]);
        }
    }
    masses
}

/// sum m (a_bias - g) at and beyond the outer end of every segment. Resolved in the inertial triad, where the sums
/// outwards and inwards use the same components.
fn bias_forces_beyond(alg: &mut Algebra, segments: &[Segment]) -> Vec<Vector> {
    let inertial = TriadId::INERTIAL;
    let mut bias: Vec<Vector> = Vec::with_capacity(segments.len());
    for segment in segments {
        let own = alg.express(&segment.motion.bias, inertial);
        let own = Vector::new(&alg.dag, inertial, own);
        bias.push(match segment.inner {
            Some(inner) => bias[inner].plus(&mut alg.dag, &own),
            None => own,
        });
    }
    let mut forces: Vec<Vector> = Vec::with_capacity(segments.len());
    for (segment, bias) in segments.iter().zip(&bias) {
        let falling = bias.minus(&mut alg.dag, &segment.gravity);
        forces.push(falling.scaled(&mut alg.dag, segment.mass));
    }
    for (s, segment) in segments.iter().enumerate().rev() {
        if let Some(inner) = segment.inner {
            forces[inner] = forces[inner].plus(&mut alg.dag, &forces[s].clone());
        }
    }
    forces
}
