//! The mass centres as a tree of segments: every centre is reached from O or from another centre.
//!
//! Any tree gives correct equations; in a good one few speeds move each segment. The motion of a segment is that of its
//! outer end minus that of its inner end.

use crate::expr::ExprId;
use crate::kinematics::{Kinematics, Motion, lower_scalar, lower_vector};
use crate::model::Model;
use crate::vector::{Algebra, TriadId, Vector};

/// A step from one centre to the next, outwards.
#[derive(Clone, Debug)]
pub(super) struct Segment {
    /// Name of the body at its outer end, for the generated code.
    pub name: String,
    /// Index of the segment before it, and so of the centre where it begins; `None` if it begins at O.
    pub inner: Option<usize>,
    /// Mass at its outer end (kg).
    pub mass: ExprId,
    /// Gravity at its outer end, 0 where no weight acts (m/s^2).
    pub gravity: Vector,
    /// Motion of the outer end relative to the inner one.
    pub motion: Motion,
}

/// A mass centre before it is placed in the tree.
struct Centre {
    name: String,
    position: Vector,
    motion: Motion,
    mass: ExprId,
    gravity: Vector,
}

/// With fewer segments nothing is gained by sharing.
const FEWEST_SEGMENTS: usize = 3;
/// Upper limit of the average number of segments that a speed moves. Above it nothing is gained: speeds relative from
/// body to body move every segment farther out.
const TOO_MANY_MOVED: usize = 2;

/// The segments of a tree in which every speed moves few of them; `None` for other mechanisms. Also `None` if some
/// speeds are dependent: measured on the four-bar and the tile, sharing there gains nothing and costs accuracy.
pub(super) fn sparse_tree(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Option<Vec<Segment>> {
    let independent = k.unknowns.are_independent();
    if !independent || model.bodies.len() < FEWEST_SEGMENTS {
        return None;
    }
    let segments = tree(alg, model, k);
    let moved: usize = segments.iter().map(|s| s.motion.partials.len()).sum();
    (segments.len() >= FEWEST_SEGMENTS && moved < TOO_MANY_MOVED * k.unknowns.len()).then_some(segments)
}

/// The segments, inner ones first. Bodies without mass have none; bodies with the same centre share one.
fn tree(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Vec<Segment> {
    let mut centres = centres(alg, model, k);
    // Centres that few speeds move are inner ones.
    centres.sort_by_key(|centre| centre.motion.partials.len());
    let mut segments = Vec::with_capacity(centres.len());
    for (s, centre) in centres.iter().enumerate() {
        let from_origin = difference(&centre.motion, &Motion::default());
        let nearest = (0..s).map(|i| (difference(&centre.motion, &centres[i].motion), i)).min();
        let inner = nearest.filter(|(size, _)| *size < from_origin).map(|(_, i)| i);
        let motion = match inner {
            Some(i) => minus(alg, &centre.motion, &centres[i].motion),
            None => centre.motion.clone(),
        };
        let (name, gravity) = (centre.name.clone(), centre.gravity.clone());
        segments.push(Segment { name, inner, mass: centre.mass, gravity, motion });
    }
    segments
}

fn centres(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Vec<Centre> {
    let mut centres: Vec<Centre> = Vec::new();
    for body in model.bodies.iter() {
        let Some(mass) = body.mass.as_ref().map(|m| lower_scalar(alg, k, m)) else { continue };
        if alg.dag.is_zero(mass) {
            continue;
        }
        let gravity = match &model.gravity {
            Some(gravity) if body.weight => lower_vector(alg, k, gravity),
            _ => Vector::zero(),
        };
        let position = k.positions[body.centre].clone();
        match centres.iter_mut().find(|c| c.position == position && c.gravity == gravity) {
            Some(same) => same.mass = alg.dag.add(same.mass, mass),
            None => {
                let (name, motion) = (body.name.clone(), k.velocities[body.centre].clone());
                centres.push(Centre { name, position, motion, mass, gravity });
            }
        }
    }
    centres
}

/// Number of partial velocities, and of their terms, in which two motions differ.
fn difference(a: &Motion, b: &Motion) -> (usize, usize) {
    let (mut partials, mut terms) = (0, 0);
    let none = Vector::zero();
    for unknown in a.partials.keys().chain(b.partials.keys().filter(|u| !a.partials.contains_key(u))) {
        let [v, w] = [a, b].map(|motion| motion.partials.get(unknown).unwrap_or(&none));
        let differing = v.terms.iter().filter(|(triad, c)| w.terms.get(triad) != Some(c)).count()
            + w.terms.keys().filter(|triad| !v.terms.contains_key(triad)).count();
        partials += usize::from(differing > 0);
        terms += differing;
    }
    (partials, terms)
}

fn minus(alg: &mut Algebra, a: &Motion, b: &Motion) -> Motion {
    let mut partials = a.partials.clone();
    for (&unknown, v) in &b.partials {
        let mine = a.partials.get(&unknown).cloned().unwrap_or_default();
        let rest = mine.minus(&mut alg.dag, v);
        if rest.is_zero() {
            partials.remove(&unknown);
        } else {
            partials.insert(unknown, rest);
        }
    }
    Motion { partials, bias: a.bias.minus(&mut alg.dag, &b.bias) }
}

impl Segment {
    /// The deepest triad in which its partial velocities have terms: the one that turns with it.
    pub fn own_triad(&self) -> TriadId {
        let triads = self.motion.partials.values().flat_map(|v| v.terms.keys());
        triads.max().copied().unwrap_or(TriadId::INERTIAL)
    }
}
