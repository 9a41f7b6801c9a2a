//! Translational inertia of a tree of segments (see `segment`) by sums over what lies beyond a segment.
//!
//! A centre's velocity is the sum over the segments that lead to it. Hence, instead of a sum over all bodies,
//! M_kl = sum over pairs of segments of m v_k . v_l, with m the mass at and beyond the outer one of the two if
//! the inner one leads to it, else 0; and h_k = sum_s v_k . H_s, with H_s = sum m (a_bias - g) over the centres at
//! and beyond segment s.

use super::segment::Segment;
use super::unprojected::Unprojected;
use crate::expr::ExprId;
use crate::kinematics::{Kinematics, UnknownId};
use crate::vector::{TriadId, Vector};

/// Adds the inertia of all centres.
pub(super) fn accumulate(k: &mut Kinematics, segments: &[Segment], parts: &mut Unprojected) {
    let masses = masses_beyond(k, segments);
    for (t, &mass) in masses.iter().enumerate() {
        let outer = partials(&segments[t]);
        let mut at = Some(t);
        while let Some(s) = at {
            let inner = partials(&segments[s]);
            for (i, (a, v)) in inner.iter().enumerate() {
                // Of a segment with itself each pair once, of two segments all.
                for (b, w) in &outer[if s == t { i } else { 0 }..] {
                    let product = k.triads.dot(&mut k.dag, v, w);
                    let term = k.dag.mul(mass, product);
                    // On the diagonal two segments count in both orders.
                    for _ in 0..if a == b && s != t { 2 } else { 1 } {
                        add_mass(k, parts, (*a, *b), term);
                    }
                }
            }
            at = segments[s].inner;
        }
    }
    for (segment, force) in segments.iter().zip(bias_forces_beyond(k, segments)) {
        for (a, v) in partials(segment) {
            let term = k.triads.dot(&mut k.dag, &v, &force);
            let term = k.dag.negate(term);
            parts.add_force(&mut k.dag, a, term);
        }
    }
}

fn add_mass(k: &mut Kinematics, parts: &mut Unprojected, (a, b): (UnknownId, UnknownId), term: ExprId) {
    if !k.dag.is_zero(term) {
        parts.add_mass(&mut k.dag, a, b, term);
    }
}

fn partials(segment: &Segment) -> Vec<(UnknownId, Vector)> {
    segment.motion.partials.iter().map(|(&unknown, v)| (unknown, v.clone())).collect()
}

/// Mass at and beyond the outer end of every segment.
fn masses_beyond(k: &mut Kinematics, segments: &[Segment]) -> Vec<ExprId> {
    let mut masses: Vec<ExprId> = segments.iter().map(|s| s.mass).collect();
    for (s, segment) in segments.iter().enumerate().rev() {
        if let Some(inner) = segment.inner {
            masses[inner] = k.dag.add(masses[inner], masses[s]);
        }
    }
    masses
}

/// sum m (a_bias - g) at and beyond the outer end of every segment, resolved in the inertial triad: one set of
/// components serves the sum outwards and the sum inwards.
fn bias_forces_beyond(k: &mut Kinematics, segments: &[Segment]) -> Vec<Vector> {
    let inertial = TriadId::INERTIAL;
    let mut bias: Vec<Vector> = Vec::with_capacity(segments.len());
    for segment in segments {
        let own = k.triads.express(&mut k.dag, &segment.motion.bias, inertial);
        let own = Vector::new(&k.dag, inertial, own);
        bias.push(match segment.inner {
            Some(inner) => bias[inner].plus(&mut k.dag, &own),
            None => own,
        });
    }
    let mut forces: Vec<Vector> = Vec::with_capacity(segments.len());
    for (segment, bias) in segments.iter().zip(&bias) {
        let falling = bias.minus(&mut k.dag, &segment.gravity);
        forces.push(falling.scaled(&mut k.dag, segment.mass));
    }
    for (s, segment) in segments.iter().enumerate().rev() {
        if let Some(inner) = segment.inner {
            forces[inner] = forces[inner].plus(&mut k.dag, &forces[s].clone());
        }
    }
    forces
}
