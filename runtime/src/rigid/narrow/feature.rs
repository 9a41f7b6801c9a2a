//! Features: places where two shapes are near each other, and their list for a pair.

use crate::real::Scalar;
use crate::surface::{Cuboid, Frame, Shape};
use crate::vec3::{self, Vec3};

/// Most features of a pair; if there are more, the nearest are kept.
pub const CAPACITY: usize = 12;

/// A place where two shapes are near each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feature<S> {
    /// c (m), on the surface of one of the two.
    pub point: Vec3<S>,
    /// n, unit vector from the other shape to the one.
    pub normal: Vec3<S>,
    /// Distance (m), < 0 where they overlap.
    pub gap: S,
    /// c' (m/s).
    pub point_rate: Vec3<S>,
    /// n' (1/s).
    pub normal_rate: Vec3<S>,
    /// Number of the feature within its pair: the same from step to step.
    pub id: u32,
    /// In how many directions the surface below is curved (0 a face, 1 an edge or a side, 2 a corner or an end): where
    /// this changes, so do the forces, at once.
    pub curved: u8,
}

/// The features of a pair.
#[derive(Clone, Copy, Debug)]
pub struct Features<S> {
    list: [Option<Feature<S>>; CAPACITY],
}

impl<S: Scalar> Features<S> {
    pub(super) fn none() -> Features<S> {
        Features { list: [None; CAPACITY] }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = Feature<S>> + '_ {
        self.list.iter().filter_map(|f| *f)
    }

    /// Adds a feature; in a full list it replaces the farthest if it is nearer.
    pub(super) fn push(&mut self, feature: Feature<S>) {
        let gap_of = |f: &Option<Feature<S>>| f.map(|f| f.gap);
        if let Some(free) = self.list.iter_mut().find(|f| f.is_none()) {
            *free = Some(feature);
            return;
        }
        let mut farthest = 0;
        for (i, f) in self.list.iter().enumerate() {
            if gap_of(f) > self.list.get(farthest).and_then(gap_of) {
                farthest = i;
            }
        }
        if let Some(place) = self.list.get_mut(farthest)
            && gap_of(place) > Some(feature.gap)
        {
            *place = Some(feature);
        }
    }

    /// The same features with the roles of the shapes swapped.
    pub(super) fn swapped(mut self) -> Features<S> {
        for feature in self.list.iter_mut().flatten() {
            feature.normal = vec3::scale(feature.normal, -S::ONE);
            feature.normal_rate = vec3::scale(feature.normal_rate, -S::ONE);
        }
        self
    }
}

/// A shape and its frame.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a, S> {
    /// The shape.
    pub shape: &'a Shape<S>,
    /// Its frame.
    pub frame: &'a Frame<S>,
}

/// The corners of a box; bit k of a corner's number is the side along axis k.
pub(super) fn corners<S: Scalar>(cuboid: &Cuboid<S>) -> [Vec3<S>; 8] {
    core::array::from_fn(|number| {
        let [x, y, z] = cuboid.half;
        let side = |bit: usize, h: S| if number & (1 << bit) == 0 { -h } else { h };
        [side(0, x), side(1, y), side(2, z)]
    })
}
