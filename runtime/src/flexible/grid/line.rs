//! A row of a grid in motion, component by component, as [`super::March`] keeps it over many steps.

use super::layout::{Family, Grid, Run, WIDTH, pitch};
use super::strip::{FIRST, Row, Strip};
use crate::flexible::pressure::{self, PressureForm};
use crate::flexible::spring::STRETCH_LIMIT;
use crate::ode::nodes::Motion;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Lanes before the first column, or behind the last, for neighbours: a register's worth, so that columns begin with
/// one.
pub(super) const LEAD: usize = 16;

/// A number for each node of a row.
pub(super) type Lanes<S> = [S; WIDTH];
/// Vectors of a row, component by component.
pub(super) type Vectors<S> = [Lanes<S>; 3];
/// The same with room for neighbours.
pub(super) type Wide<S> = [[S; LEAD + WIDTH]; 3];

#[inline(always)]
pub(super) fn get<S: Copy, const N: usize>([x, y, z]: &[[S; N]; 3], lane: usize) -> Vec3<S> {
    [x[lane], y[lane], z[lane]]
}

#[inline(always)]
pub(super) fn set<S: Copy, const N: usize>([x, y, z]: &mut [[S; N]; 3], lane: usize, value: Vec3<S>) {
    [x[lane], y[lane], z[lane]] = value;
}

/// The larger of two numbers, in one instruction: of one that is no number it may take the other.
#[inline(always)]
pub(super) fn larger<S: Scalar>(a: S, b: S) -> S {
    if a > b { a } else { b }
}

/// Adds sizes lane by lane.
#[inline(always)]
pub(super) fn add_sizes<S: Scalar, const N: usize>(vectors: &[[S; N]; 3], sums: &mut Lanes<S>) {
    for numbers in vectors {
        for (sum, number) in sums.iter_mut().zip(numbers) {
            *sum = *sum + number.abs();
        }
    }
}

/// The sum of all lanes.
pub(super) fn sum<S: Scalar>(numbers: &Lanes<S>) -> S {
    numbers.iter().fold(S::ZERO, |sum, x| sum + *x)
}

/// Springs of a row in one direction, each at its tail.
#[derive(Clone, Debug)]
pub(super) struct Springs<S> {
    /// K (N/m); 0 where there is no spring.
    pub(super) stiffness: Lanes<S>,
    /// L (m).
    pub(super) rest_length: Lanes<S>,
    /// 1/m: times its length more than 1 where a spring has run away, see [`STRETCH_LIMIT`].
    pub(super) shortness: Lanes<S>,
}

/// A row of nodes in motion, with what the grid says about it.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Line<S> {
    /// Positions (m).
    pub(super) pos: Wide<S>,
    /// What rounding dropped from them.
    pub(super) pos_rest: Vectors<S>,
    /// Velocities (m/s).
    pub(super) vel: Vectors<S>,
    /// What rounding dropped from them.
    pub(super) vel_rest: Vectors<S>,
    /// Velocities half-way through a step (m/s); forces (N) at the start and at the end of all steps.
    pub(super) half: Vectors<S>,
    /// 1/mass (1/kg); 0 where no force moves a node, or there is none.
    pub(super) inverse_mass: Lanes<S>,
    /// Masses (kg).
    pub(super) mass: Lanes<S>,
    /// Springs to the right.
    pub(super) right: Springs<S>,
    /// Springs upwards.
    pub(super) up: Springs<S>,
    /// 1 at the first corner of a cell, 0 where there is none.
    pub(super) cells: Lanes<S>,
    /// Forces of facets that are no cells (N), two for a node at most; -0, which changes no sum, elsewhere.
    pub(super) beside: [Vectors<S>; 2],
    /// Whether no force moves any of the nodes.
    pub(super) is_still: bool,
    /// Whether one is a corner of a facet that is no cell.
    pub(super) has_beside: bool,
}

impl<S: Scalar> Line<S> {
    /// A row of a grid, nodes without a place; of `beside` those that touch it. Beyond the last row there is nothing.
    #[must_use]
    pub fn new(grid: &Grid<S>, row: usize, inverse_mass: &[Vec3<S>], beside: &[[Corner; 4]]) -> Self {
        let lanes = [S::ZERO; WIDTH];
        let part = |list: &[S]| {
            list.get(row * pitch(grid.columns)..).and_then(<[S]>::first_chunk).copied().unwrap_or(lanes)
        };
        let springs = |family: Family<S>| {
            let rest_length = part(family.rest_length);
            // By more than rounding, so that none is missed.
            let limit = S::from_f64(0.999 * STRETCH_LIMIT);
            let shortness =
                rest_length.map(|length| if length > S::ZERO { S::ONE / (limit * length) } else { S::ZERO });
            Springs { stiffness: part(family.stiffness), rest_length, shortness }
        };
        let mut line = Line {
            pos: [[S::ZERO; LEAD + WIDTH]; 3],
            pos_rest: [lanes; 3],
            vel: [lanes; 3],
            vel_rest: [lanes; 3],
            half: [lanes; 3],
            inverse_mass: lanes,
            mass: part(grid.mass),
            right: springs(grid.right),
            up: springs(grid.up),
            cells: part(grid.cells),
            beside: [[[-S::ZERO; WIDTH]; 3]; 2],
            is_still: true,
            has_beside: beside.iter().flatten().any(|corner| corner.row == row),
        };
        for Run { column, node, length } in runs(grid, row) {
            for i in 0..*length {
                let [inverse_mass, _, _] = vec3::at(inverse_mass, node + i);
                line.inverse_mass[(column + i) % WIDTH] = inverse_mass;
                line.is_still &= inverse_mass == S::ZERO;
            }
        }
        line
    }

    /// Takes over the nodes of a row from a motion, through memory for each of its vectors; columns without a node get
    /// some other node's numbers, as in [`Strip::read`].
    #[inline(always)]
    pub(super) fn read(&mut self, grid: &Grid<S>, row: usize, motion: &Motion<S>, memory: &mut [Row<S>; 5]) {
        let strip = Strip { from: 0, width: grid.columns, own: [0, grid.columns] };
        // All before the first is copied: the processor would have to wait for what was just written.
        let [pos, pos_rest, vel, vel_rest, force] = memory;
        strip.read(grid, row, motion.pos, pos);
        strip.read(grid, row, motion.pos_rest, pos_rest);
        strip.read(grid, row, motion.vel, vel);
        strip.read(grid, row, motion.vel_rest, vel_rest);
        strip.read(grid, row, motion.elastic, force);
        copy(pos, &mut self.pos);
        copy(pos_rest, &mut self.pos_rest);
        copy(vel, &mut self.vel);
        copy(vel_rest, &mut self.vel_rest);
        copy(force, &mut self.half);
    }

    /// Puts the nodes into a motion.
    #[inline(always)]
    pub(super) fn write(&self, grid: &Grid<S>, row: usize, motion: &mut Motion<S>) {
        for run in runs(grid, row) {
            put_together(run, &self.pos, motion.pos);
            put_together(run, &self.pos_rest, motion.pos_rest);
            put_together(run, &self.vel, motion.vel);
            put_together(run, &self.vel_rest, motion.vel_rest);
            put_together(run, &self.half, motion.elastic);
        }
    }
}

/// Nodes that are put together at a time.
const AT_ONCE: usize = 16;

/// Vectors of a run from their components. The last nodes of a long run are put together with some before them, once
/// more.
#[inline(always)]
fn put_together<S: Scalar, const N: usize>(run: &Run, lanes: &[[S; N]; 3], to: &mut [Vec3<S>]) {
    let Run { column, node, length } = *run;
    // Known only here: a loop of a constant length would be unrolled into single numbers.
    let count = length.min(AT_ONCE);
    let mut at = 0;
    while at < length {
        let first = at.min(length - count);
        let nodes = to.get_mut(node + first..).and_then(|to| to.get_mut(..count)).unwrap_or_default();
        let [x, y, z] = lanes.each_ref().map(|lanes| {
            lanes.get(column + first..).and_then(|lanes| lanes.get(..count)).unwrap_or_default()
        });
        for (((node, x), y), z) in nodes.iter_mut().zip(x).zip(y).zip(z) {
            *node = [*x, *y, *z];
        }
        at += AT_ONCE;
    }
}

/// The columns of a row.
#[inline(always)]
fn copy<S: Scalar, const N: usize>(Row(from): &Row<S>, to: &mut [[S; N]; 3]) {
    for (to, from) in to.iter_mut().zip(from) {
        if let (Some(to), Some(from)) =
            (to.first_chunk_mut::<WIDTH>(), from.get(FIRST..).and_then(<[S]>::first_chunk))
        {
            *to = *from;
        }
    }
}

/// The runs of a row.
fn runs<'a, S>(grid: &Grid<'a, S>, row: usize) -> &'a [Run] {
    let range = grid.starts.get(row).copied().zip(grid.starts.get(row + 1).copied());
    range.and_then(|(from, to)| grid.runs.get(from..to)).unwrap_or_default()
}

/// A corner of a facet that is no cell of the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Row of the node.
    pub row: usize,
    /// Column of the node.
    pub column: usize,
    /// How many forces of such facets act on the node before this one: 0 or 1.
    pub rank: usize,
}

/// Puts the forces on the corners of facets that are no cells into their lines.
#[inline(always)]
pub(super) fn push_beside<S: Scalar>(
    beside: &[[Corner; 4]],
    form: PressureForm,
    pressure: S,
    lines: &mut [Line<S>],
) {
    for corners in beside {
        let place = |corner: &Corner| {
            lines.get(corner.row).map_or(vec3::zero(), |line| get(&line.pos, corner.column % WIDTH))
        };
        let shares = pressure::corner_shares(form, corners.each_ref().map(place));
        for (corner, share) in corners.iter().zip(shares) {
            if let Some(line) = lines.get_mut(corner.row) {
                set(&mut line.beside[corner.rank % 2], corner.column % WIDTH, vec3::scale(share, pressure));
            }
        }
    }
}
