//! Tests in blocks whether any free node can reach the ground within a step, by bounds.
//!
//! In: a block of nodes, their motion at the start and the end of a step. Out: the least gap, and a lower bound on all
//! gaps in between; only blocks near the ground are then examined node by node. Neither events nor bits depend on the
//! blocks.

use crate::contact::{ContactState, Ground};
use crate::flexible::Body;
use crate::kernel::{self, Kernel};
use crate::ode::nodes::Motion;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Nodes examined together: on a microcontroller each by itself.
const BLOCK: usize = if cfg!(target_os = "none") { 1 } else { 128 };
/// Numbers compared side by side.
const LANES: usize = 16;

/// The nodes in blocks, with the index of the first.
pub(super) fn blocks(modes: &[ContactState]) -> impl Iterator<Item = (usize, &[ContactState])> {
    modes.chunks(BLOCK).enumerate().map(|(i, modes)| (i * BLOCK, modes))
}

/// Whether these nodes are all free and enough to be examined together: a few cost less one by one.
pub(super) fn are_free(modes: &[ContactState]) -> bool {
    // Without an early exit, so that it vectorises.
    BLOCK > 1
        && modes.len() >= LANES
        && modes.iter().fold(true, |free, mode| free & (*mode == ContactState::Free))
}

/// The `count` rows from `first` on.
#[inline(always)]
fn rows<S>(rows: &[Vec3<S>], first: usize, count: usize) -> &[Vec3<S>] {
    let rest = rows.get(first..).unwrap_or_default();
    rest.get(..count).unwrap_or(rest)
}

/// Smallest gap (m) of the movable nodes of a block at the positions `pos` of all; 1/EPSILON if there is none.
pub(super) struct Nearest<'a, S> {
    pub body: &'a Body<'a, S>,
    pub ground: &'a Ground<S>,
    pub first: usize,
    pub count: usize,
    pub pos: &'a [Vec3<S>],
}

impl<S: Scalar> Kernel for Nearest<'_, S> {
    type Output = S;

    #[inline(always)]
    fn run(self) -> S {
        let Nearest { body, ground, first, count, pos } = self;
        let (asleep, mut memory) = (S::ONE / S::EPSILON, [[S::ZERO; 3]; BLOCK]);
        let inverse = body.inverse_masses(first, memory.get_mut(..count).unwrap_or_default());
        let mut least = [asleep; LANES];
        let (pos, inverse) = (rows(pos, first, count).as_chunks::<LANES>(), inverse.as_chunks::<LANES>());
        pos.0.iter().zip(inverse.0).for_each(|(pos, inverse)| nearer(&mut least, ground, pos, inverse));
        nearer(&mut least, ground, pos.1, inverse.1);
        least.into_iter().fold(asleep, |least, gap| least.min(gap))
    }
}

/// Lowers each lane to the gap of a movable node.
#[inline(always)]
fn nearer<S: Scalar>(least: &mut [S; LANES], ground: &Ground<S>, pos: &[Vec3<S>], inverse: &[Vec3<S>]) {
    let asleep = S::ONE / S::EPSILON;
    for (least, (x, [inverse, ..])) in least.iter_mut().zip(pos.iter().zip(inverse)) {
        let gap = ground.gap(*x);
        *least = least.min(if *inverse > S::ZERO { gap } else { asleep });
    }
}

/// Whether no node of a block can reach the ground between the start and the end of a step.
pub(super) fn is_clear<S: Scalar>(
    ground: &Ground<S>,
    (first, modes): (usize, &[ContactState]),
    ends: [&Motion<S>; 2],
    h: S,
) -> bool {
    are_free(modes) && kernel::run(Lowest { ground, first, count: modes.len(), ends, h }) > S::ZERO
}

/// Lower bound (m) on the gaps of the nodes of a block between the start and the end of a step.
///
/// A cubic through values g0, g1 and rates r0, r1 stays above min(g0, g1) - 4/27 (|r0| + |r1|): the weights of the
/// values sum to 1, those of the rates are at most 4/27. Using 1/2 instead, and a small share of the values, covers
/// rounding.
struct Lowest<'a, 'm, S> {
    ground: &'a Ground<S>,
    first: usize,
    count: usize,
    ends: [&'a Motion<'m, S>; 2],
    h: S,
}

impl<S: Scalar> Kernel for Lowest<'_, '_, S> {
    type Output = S;

    #[inline(always)]
    fn run(self) -> S {
        let Lowest { ground, first, count, ends: [start, end], h } = self;
        let [x0, v0, x1, v1] = [&*start.pos, start.vel, end.pos, end.vel]
            .map(|row| rows(row, first, count).as_chunks::<LANES>());
        let mut least = [S::ONE / S::EPSILON; LANES];
        for ((x0, v0), (x1, v1)) in x0.0.iter().zip(v0.0).zip(x1.0.iter().zip(v1.0)) {
            lower(&mut least, ground, h, [x0, v0, x1, v1]);
        }
        lower(&mut least, ground, h, [x0.1, v0.1, x1.1, v1.1]);
        least.into_iter().fold(S::ONE / S::EPSILON, |least, low| least.min(low))
    }
}

/// Lowers each lane to the bound of a node, given positions and velocities at the start and the end of the step.
#[inline(always)]
fn lower<S: Scalar>(least: &mut [S; LANES], ground: &Ground<S>, h: S, [x0, v0, x1, v1]: [&[Vec3<S>]; 4]) {
    let (half, slack) = (S::from_f64(0.5) * h, S::from_f64(64.0) * S::EPSILON);
    for (least, ((x0, v0), (x1, v1))) in least.iter_mut().zip(x0.iter().zip(v0).zip(x1.iter().zip(v1))) {
        let (g0, g1) = (ground.gap(*x0), ground.gap(*x1));
        let rates = ground.gap_rate(*v0).abs() + ground.gap_rate(*v1).abs();
        *least = least.min(g0.min(g1) - half * rates - slack * (g0.abs() + g1.abs()));
    }
}
