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

/// Nodes passed over together: on a microcontroller none, all are one block.
pub(crate) const PASSED_OVER: usize = if cfg!(target_os = "none") { usize::MAX } else { BLOCK };

/// The nodes in blocks, with the index of the first.
pub(super) fn blocks(modes: &[ContactState]) -> impl Iterator<Item = (usize, &[ContactState])> {
    modes.chunks(BLOCK).enumerate().map(|(i, modes)| (i * BLOCK, modes))
}

/// Whether these nodes are all free and enough to be examined together: a few cost less one by one.
pub(crate) fn are_free(modes: &[ContactState]) -> bool {
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
/// rounding. A rate n.v is at most the sum of |n| over its components times the largest component of any velocity of
/// the block, which is found number by number, without taking the vectors apart.
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
        let [x0, v0, x1, v1] = [&*start.pos, start.vel, end.pos, end.vel].map(|row| rows(row, first, count));
        let (mut least, mut fastest) = ([S::ONE / S::EPSILON; LANES], [S::ZERO; LANES]);
        let [(x0, rest0), (x1, rest1)] = [x0, x1].map(|x| x.as_chunks::<LANES>());
        x0.iter().zip(x1).for_each(|(x0, x1)| lower(&mut least, ground, [x0, x1]));
        lower(&mut least, ground, [rest0, rest1]);
        for v in [v0, v1] {
            let (numbers, rest) = v.as_flattened().as_chunks::<LANES>();
            numbers.iter().for_each(|numbers| raise(&mut fastest, numbers));
            raise(&mut fastest, rest);
        }
        let fastest = fastest.into_iter().fold(S::ZERO, |fastest, speed| fastest.max(speed));
        let steepness = ground.normal.iter().fold(S::ZERO, |sum, n| sum + n.abs());
        let way = h * (steepness * fastest);
        least.into_iter().fold(S::ONE / S::EPSILON, |least, low| least.min(low)) - way
    }
}

/// Lowers each lane to the smaller gap of a node at the start and the end of a step, less a small share of both.
#[inline(always)]
fn lower<S: Scalar>(least: &mut [S; LANES], ground: &Ground<S>, [x0, x1]: [&[Vec3<S>]; 2]) {
    let slack = S::from_f64(64.0) * S::EPSILON;
    for (least, (x0, x1)) in least.iter_mut().zip(x0.iter().zip(x1)) {
        let (g0, g1) = (ground.gap(*x0), ground.gap(*x1));
        let low = if g0 < g1 { g0 } else { g1 } - slack * (g0.abs() + g1.abs());
        *least = if low < *least { low } else { *least };
    }
}

/// Raises each lane to the size of a number.
#[inline(always)]
fn raise<S: Scalar>(largest: &mut [S; LANES], numbers: &[S]) {
    for (largest, number) in largest.iter_mut().zip(numbers) {
        let size = number.abs();
        *largest = if size > *largest { size } else { *largest };
    }
}
