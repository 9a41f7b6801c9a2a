//! Springs of a body that forms no grid, in patches of neighbours, so that nodes are read from the first-level cache.
//!
//! In: positions. Out: sums of forces, each node's added in the order of the springs. The nodes of a patch are copied
//! in and out once, four numbers each: a spring then reads and writes each end at once, and refers to it by one byte.

use super::mean;
use super::spring::is_runaway;
use crate::kernel::{BLOCK, Kernel};
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Most nodes of a patch: as many as a byte has values.
pub const NODES: usize = 256;
/// Patches of at most this many nodes use smaller memory, and shorter blocks of springs, which are cleared faster.
const FEW: usize = 48;
/// Springs of such a block.
const SHORT: usize = if BLOCK < 16 { BLOCK } else { 16 };

/// Springs of a body as a sequence of patches.
#[derive(Clone, Copy, Debug)]
pub struct Patches<'a, S> {
    /// Ends of the nodes and of the springs of each patch in the lists.
    pub ends: &'a [[usize; 2]],
    /// Nodes, patch after patch; no node twice in one patch.
    pub nodes: &'a [usize],
    /// Tail and head of each spring among the nodes of its patch.
    pub springs: &'a [[u8; 2]],
    /// K (N/m).
    pub stiffness: &'a [S],
    /// L (m).
    pub rest_length: &'a [S],
    /// C (N s/m).
    pub damping: &'a [S],
    /// Whether any spring has a damper.
    pub is_damped: bool,
}

/// Adds the elastic forces of springs (N); returns whether any of them is a runaway, see
/// [`super::spring::STRETCH_LIMIT`].
#[derive(Debug)]
pub struct Pulls<'a, S> {
    /// The springs.
    pub patches: Patches<'a, S>,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

impl<S: Scalar> Kernel for Pulls<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        walk(self.patches, [self.pos], self.force, |[way], [stiffness, rest_length, _]| {
            let (direction, length) = vec3::direction(way);
            let tension = stiffness * (length - rest_length);
            (vec3::scale(direction, tension), is_runaway(rest_length, length))
        })
    }
}

/// Adds the forces of dampers (N).
#[derive(Debug)]
pub struct Damps<'a, S> {
    /// The springs of the dampers.
    pub patches: Patches<'a, S>,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// Velocities (m/s).
    pub vel: &'a [Vec3<S>],
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

impl<S: Scalar> Kernel for Damps<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        walk(self.patches, [self.pos, self.vel], self.force, |[way, speed], [_, _, damping]| {
            let (direction, _) = vec3::direction(way);
            (vec3::scale(direction, damping * vec3::dot(speed, direction)), false)
        });
    }
}

/// Adds the mean forces of springs and dampers over a step (N).
#[derive(Debug)]
pub struct Means<'a, 'w, S> {
    /// The springs.
    pub patches: Patches<'a, S>,
    /// The step.
    pub way: &'w MeanStep<'a, S>,
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

impl<S: Scalar> Kernel for Means<'_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Means { patches, way, force } = self;
        let rows = [way.pos[1], way.dx];
        walk(patches, rows, force, |ways, numbers| (mean::pull(ways, numbers, way.h), false));
    }
}

/// Vectors padded to four numbers; the fourth is 0.
type Fours<S, const N: usize> = [[S; 4]; N];

/// Copies of a patch's nodes, and results for a block of springs.
struct Room<S, const N: usize, const MOST: usize, const SPRINGS: usize> {
    /// Nodes of the patch, for each of the rows.
    places: [Fours<S, MOST>; N],
    /// Forces on them.
    sums: Fours<S, MOST>,
    /// Vectors of springs from tail to head, for each of the rows.
    ways: [Fours<S, SPRINGS>; N],
    /// Forces on their tails.
    pulls: Fours<S, SPRINGS>,
}

/// Adds forces to both ends of each spring. `law` gives the force on its tail, and a flag, from the vector from tail to
/// head in each of the `rows` and from K, L and C. Returns whether any flag was set.
#[inline(always)]
fn walk<S: Scalar, const N: usize>(
    patches: Patches<S>,
    rows: [&[Vec3<S>]; N],
    force: &mut [Vec3<S>],
    law: impl Fn([Vec3<S>; N], [S; 3]) -> (Vec3<S>, bool),
) -> bool {
    // Clearing memory for 256 nodes takes as long as about a hundred springs.
    match patches.nodes.len() {
        0..=FEW => walk_within::<S, N, FEW, SHORT>(patches, rows, force, law),
        _ => walk_within::<S, N, NODES, BLOCK>(patches, rows, force, law),
    }
}

/// The same for patches of at most `MOST` nodes, by blocks of `SPRINGS` springs.
#[inline(always)]
fn walk_within<S: Scalar, const N: usize, const MOST: usize, const SPRINGS: usize>(
    patches: Patches<S>,
    rows: [&[Vec3<S>]; N],
    force: &mut [Vec3<S>],
    law: impl Fn([Vec3<S>; N], [S; 3]) -> (Vec3<S>, bool),
) -> bool {
    let Patches { ends, nodes, springs, stiffness, rest_length, damping, .. } = patches;
    let none = [S::ZERO; 4];
    let mut room = Room {
        places: [[none; MOST]; N],
        sums: [none; MOST],
        ways: [[none; SPRINGS]; N],
        pulls: [none; SPRINGS],
    };
    let (mut found, mut from) = (false, [0; 2]);
    for to in ends {
        let nodes = nodes.get(from[0]..to[0]).unwrap_or_default();
        rows.iter().zip(&mut room.places).for_each(|(row, places)| read(row, nodes, places));
        read(force, nodes, &mut room.sums);
        let springs = springs.get(from[1]..to[1]).unwrap_or_default().chunks(SPRINGS);
        let [stiffness, rest_length, damping] = [stiffness, rest_length, damping]
            .map(|list| list.get(from[1]..to[1]).unwrap_or_default().chunks(SPRINGS));
        for (springs, (stiffness, (rest_length, damping))) in
            springs.zip(stiffness.zip(rest_length.zip(damping)))
        {
            room.span(springs, nodes.len());
            found |= room.pull([stiffness, rest_length, damping], &law);
            room.add(springs);
        }
        for (node, [x, y, z, _]) in nodes.iter().zip(&room.sums) {
            if let Some(force) = force.get_mut(*node) {
                *force = [*x, *y, *z];
            }
        }
        from = *to;
    }
    found
}

/// Copies the vectors of the nodes of a patch.
#[inline(always)]
fn read<S: Scalar>(rows: &[Vec3<S>], nodes: &[usize], to: &mut [[S; 4]]) {
    for (node, place) in nodes.iter().zip(to) {
        let [x, y, z] = vec3::at(rows, *node);
        *place = [x, y, z, S::ZERO];
    }
}

// The loop that reads nodes checks that they exist: the compiler then loads a node as one register, instead of
// gathering numbers of several springs one by one. The loop that adds forces needs no check: any byte is a valid index
// of the memory.
impl<S: Scalar, const N: usize, const MOST: usize, const SPRINGS: usize> Room<S, N, MOST, SPRINGS> {
    /// The vectors from tail to head of a block of springs.
    #[inline(always)]
    fn span(&mut self, springs: &[[u8; 2]], nodes: usize) {
        for (ways, places) in self.ways.iter_mut().zip(&self.places) {
            let places = places.get(..nodes).unwrap_or_default();
            for ([tail, head], way) in springs.iter().zip(ways) {
                if let (Some(tail), Some(head)) =
                    (places.get(usize::from(*tail)), places.get(usize::from(*head)))
                {
                    *way = core::array::from_fn(|i| head[i] - tail[i]);
                }
            }
        }
    }

    /// Their forces.
    #[inline(always)]
    fn pull(
        &mut self,
        [stiffness, rest_length, damping]: [&[S]; 3],
        law: impl Fn([Vec3<S>; N], [S; 3]) -> (Vec3<S>, bool),
    ) -> bool {
        // An integer as wide as a lane: a bool would be moved out of its vector register.
        let mut found = 0_u32;
        let numbers = stiffness.iter().zip(rest_length.iter().zip(damping));
        for (lane, (pull, (stiffness, (rest_length, damping)))) in
            self.pulls.iter_mut().zip(numbers).enumerate()
        {
            let ways = self.ways.each_ref().map(|ways| [ways[lane][0], ways[lane][1], ways[lane][2]]);
            let ([x, y, z], yes) = law(ways, [*stiffness, *rest_length, *damping]);
            // Read the fourth number, 0, of every row too: with three of four the compiler would compute the last ones
            // of a block one by one.
            let none =
                self.ways.each_ref().map(|ways| ways[lane][3]).into_iter().fold(S::ZERO, |sum, x| sum + x);
            *pull = [x, y, z, none];
            found |= u32::from(yes);
        }
        found > 0
    }

    /// Adds the forces to the nodes, with the operations of [`super::spring::Spring::pull`] in their order.
    #[inline(always)]
    fn add(&mut self, springs: &[[u8; 2]]) {
        for ([tail, head], pull) in springs.iter().zip(&self.pulls) {
            if let Some(sum) = self.sums.get_mut(usize::from(*tail)) {
                *sum = core::array::from_fn(|i| sum[i] + pull[i]);
            }
            if let Some(sum) = self.sums.get_mut(usize::from(*head)) {
                *sum = core::array::from_fn(|i| sum[i] - pull[i]);
            }
        }
    }
}
