//! Spring and facet forces in blocks: gather the ends, compute the forces of a block side by side, add them one by one.
//!
//! In: positions. Out: sums of forces, bit for bit those of one spring or facet after the other: each lane does
//! the operations of `spring` and `pressure` in their order, and forces are added in the order of the lists. A
//! microcontroller handles springs and facets one by one.

use super::pressure::{self, PressureForm};
use super::spring::{Spring, is_runaway};
use crate::kernel::{BLOCK, Kernel};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Vectors side by side: components x, y, z.
type Lanes<S> = [[S; BLOCK]; 3];

/// With fewer facets than this they are handled one by one: a block would be mostly empty.
const FEW_FACETS: usize = if cfg!(target_os = "none") { usize::MAX } else { 8 };
/// The same for springs: a block takes as long as this many one by one, and more instructions.
const FEW_SPRINGS: usize = if cfg!(target_os = "none") { usize::MAX } else { 2 * BLOCK };

/// Adds the elastic forces of springs (N); returns whether any of them is a runaway, see
/// [`super::spring::STRETCH_LIMIT`].
#[derive(Debug)]
pub struct Pulls<'a, S> {
    /// The springs.
    pub springs: &'a [Spring<S>],
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

impl<S: Scalar> Kernel for Pulls<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let mut runaway = false;
        if self.springs.len() < FEW_SPRINGS {
            for spring in self.springs {
                runaway |= spring.add_elastic(self.pos, self.force);
            }
            return runaway;
        }
        let mut way: Lanes<S> = [[S::ZERO; BLOCK]; 3];
        let [mut stiffness, mut rest_length] = [[S::ZERO; BLOCK]; 2];
        for block in self.springs.chunks(BLOCK) {
            let [x, y, z] = &mut way;
            let lanes = x.iter_mut().zip(y).zip(z).zip(&mut stiffness).zip(&mut rest_length);
            for (spring, ((((x, y), z), k), l)) in block.iter().zip(lanes) {
                [*x, *y, *z] = vec3::sub(vec3::at(self.pos, spring.head), vec3::at(self.pos, spring.tail));
                (*k, *l) = (spring.stiffness, spring.rest_length);
            }
            // Lanes beyond the last spring hold forces of the block before.
            let ways = way.each_mut().map(|lanes| lanes.get_mut(..block.len()).unwrap_or_default());
            runaway |= pull(ways, &stiffness, &rest_length);
            let [x, y, z] = &way;
            for (spring, ((x, y), z)) in block.iter().zip(x.iter().zip(y).zip(z)) {
                spring.pull([*x, *y, *z], self.force);
            }
        }
        runaway
    }
}

/// Replaces vectors tail -> head (m) by the elastic forces on the tails (N).
#[inline(always)]
pub(super) fn pull<S: Scalar>(way: [&mut [S]; 3], stiffness: &[S], rest_length: &[S]) -> bool {
    // An integer as wide as a lane: a bool would be moved out of its vector register.
    let mut runaway = 0_u32;
    let [x, y, z] = way;
    for ((((x, y), z), k), l) in x.iter_mut().zip(y).zip(z).zip(stiffness).zip(rest_length) {
        let (direction, length) = vec3::direction([*x, *y, *z]);
        [*x, *y, *z] = vec3::scale(direction, *k * (length - *l));
        runaway |= u32::from(is_runaway(*l, length));
    }
    runaway > 0
}

/// Adds the pressure forces on facets (N).
#[derive(Debug)]
pub struct Pushes<'a, S> {
    /// Corners of each facet.
    pub facets: &'a [[usize; 4]],
    /// How a facet's force is shared by its corners.
    pub form: PressureForm,
    /// Gauge pressure (Pa).
    pub pressure: S,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

impl<S: Scalar> Kernel for Pushes<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Pushes { facets, form, pressure, pos, force } = self;
        if facets.len() < FEW_FACETS {
            for facet in facets {
                let shares = pressure::corner_shares(form, pressure::corners(pos, facet));
                for (point, share) in facet.iter().zip(shares) {
                    vec3::add_at(force, *point, vec3::scale(share, pressure));
                }
            }
            return;
        }
        let mut corners: [Lanes<S>; 4] = [[[S::ZERO; BLOCK]; 3]; 4];
        for block in facets.chunks(BLOCK) {
            for (lane, facet) in block.iter().enumerate() {
                for (corner, point) in corners.iter_mut().zip(facet) {
                    set(corner, lane, vec3::at(pos, *point));
                }
            }
            push(&mut corners, form, pressure);
            for (lane, facet) in block.iter().enumerate() {
                for (corner, point) in corners.iter().zip(facet) {
                    vec3::add_at(force, *point, get(corner, lane));
                }
            }
        }
    }
}

/// Replaces corners (m) by the forces on them (N).
#[inline(always)]
fn push<S: Scalar>(corners: &mut [Lanes<S>; 4], form: PressureForm, pressure: S) {
    for lane in 0..BLOCK {
        let places = corners.each_ref().map(|corner| get(corner, lane));
        let shares = pressure::corner_shares(form, places);
        for (corner, share) in corners.iter_mut().zip(shares) {
            set(corner, lane, vec3::scale(share, pressure));
        }
    }
}

#[inline(always)]
pub(super) fn get<S: Scalar>(lanes: &Lanes<S>, lane: usize) -> Vec3<S> {
    let [x, y, z] = lanes;
    [x[lane % BLOCK], y[lane % BLOCK], z[lane % BLOCK]]
}

#[inline(always)]
pub(super) fn set<S: Scalar>(lanes: &mut Lanes<S>, lane: usize, value: Vec3<S>) {
    let [x, y, z] = lanes;
    [x[lane % BLOCK], y[lane % BLOCK], z[lane % BLOCK]] = value;
}
