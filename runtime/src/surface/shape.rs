//! Convex shapes: the nearest point of each in closed form (Ericson 2005, chapter 5).
//!
//! Each shape is the set of points within a radius of a core: a point, a segment, or a box. The curvature of the
//! distance depends on the core's nearest feature: H = (P - n n')/rho, P projecting out the directions along the
//! feature, rho the distance to it.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A surface for contact. Positions are in the axes of the surface's frame.
pub trait Surface<S: Scalar> {
    /// The surface's point nearest to a place.
    fn nearest(&self, place: Vec3<S>) -> Nearest<S>;
}

/// All points with z <= 0; its surface is the plane z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace;

/// A ball about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S> {
    /// Radius (m), > 0.
    pub radius: S,
}

/// All points within a radius of a segment along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule<S> {
    /// Radius (m), > 0.
    pub radius: S,
    /// Half the segment's length (m), >= 0.
    pub half_length: S,
}

/// A box about the origin, its edges along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid<S> {
    /// Half the edges (m), > 0.
    pub half: Vec3<S>,
}

/// Any of these shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<S> {
    /// z <= 0.
    HalfSpace,
    /// A ball.
    Sphere(Sphere<S>),
    /// A rod with round ends.
    Capsule(Capsule<S>),
    /// A box.
    Cuboid(Cuboid<S>),
}

/// The nearest feature of the core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feature<S> {
    /// A point: the distance is curved in every direction across n.
    Vertex,
    /// A line along this unit vector: curved across the line.
    Edge(Vec3<S>),
    /// A plane: not curved.
    Face,
}

/// The nearest point of a shape, in the shape's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<S> {
    /// Distance to the surface (m), < 0 inside.
    pub gap: S,
    /// Outward unit normal, the gradient of the gap.
    pub normal: Vec3<S>,
    /// Nearest point of the surface.
    pub foot: Vec3<S>,
    /// The nearest feature of the core.
    pub feature: Feature<S>,
    /// rho (m), distance to the core.
    pub distance: S,
}

impl<S: Scalar> Nearest<S> {
    /// H w: rate of change of the normal (1/s) while a point passes with velocity w.
    #[must_use]
    pub fn bend_vector(&self, w: Vec3<S>) -> Vec3<S> {
        let across = vec3::tangential(w, self.normal);
        let part = match self.feature {
            Feature::Face => return vec3::zero(),
            Feature::Edge(direction) => vec3::tangential(across, direction),
            Feature::Vertex => across,
        };
        if self.distance > S::ZERO { vec3::scale(part, S::ONE / self.distance) } else { vec3::zero() }
    }

    /// w' H w (m/s^2): the contribution of curvature to g'' while a point passes with velocity w.
    #[must_use]
    pub fn bend(&self, w: Vec3<S>) -> S {
        vec3::dot(w, self.bend_vector(w))
    }

    /// Nearest point given the core's nearest point; `fallback` is the normal where the point is on the core.
    fn from_core(
        place: Vec3<S>,
        core: Vec3<S>,
        radius: S,
        feature: Feature<S>,
        fallback: Vec3<S>,
    ) -> Nearest<S> {
        let (direction, distance) = vec3::direction(vec3::sub(place, core));
        let normal = if distance > S::ZERO { direction } else { fallback };
        Nearest { gap: distance - radius, normal, foot: vec3::axpy(core, radius, normal), feature, distance }
    }
}

/// The unit vector along an axis, 0 to 2.
fn axis<S: Scalar>(number: usize) -> Vec3<S> {
    core::array::from_fn(|i| if i == number { S::ONE } else { S::ZERO })
}

impl<S: Scalar> Surface<S> for HalfSpace {
    fn nearest(&self, place: Vec3<S>) -> Nearest<S> {
        let [x, y, gap] = place;
        Nearest { gap, normal: axis(2), foot: [x, y, S::ZERO], feature: Feature::Face, distance: gap.abs() }
    }
}

impl<S: Scalar> Surface<S> for Sphere<S> {
    fn nearest(&self, place: Vec3<S>) -> Nearest<S> {
        Nearest::from_core(place, vec3::zero(), self.radius, Feature::Vertex, axis(2))
    }
}

impl<S: Scalar> Surface<S> for Capsule<S> {
    fn nearest(&self, place: Vec3<S>) -> Nearest<S> {
        let along = place[2].max(-self.half_length).min(self.half_length);
        let inside = along == place[2];
        let feature = if inside { Feature::Edge(axis(2)) } else { Feature::Vertex };
        Nearest::from_core(place, [S::ZERO, S::ZERO, along], self.radius, feature, axis(0))
    }
}

impl<S: Scalar> Surface<S> for Cuboid<S> {
    fn nearest(&self, place: Vec3<S>) -> Nearest<S> {
        let core: Vec3<S> = core::array::from_fn(|i| place[i].max(-self.half[i]).min(self.half[i]));
        let out: [bool; 3] = core::array::from_fn(|i| core[i] != place[i]);
        match out {
            [false, false, false] => self.nearest_face(place),
            [true, true, true] => Nearest::from_core(place, core, S::ZERO, Feature::Vertex, axis(2)),
            _ => {
                // One coordinate outside: nearest to a face; two: to the edge along the third.
                let outside = out.iter().filter(|o| **o).count();
                let along = out.iter().position(|o| !*o).unwrap_or_default();
                let feature = if outside == 1 { Feature::Face } else { Feature::Edge(axis(along)) };
                Nearest::from_core(place, core, S::ZERO, feature, axis(2))
            }
        }
    }
}

impl<S: Scalar> Cuboid<S> {
    /// The face by which a line from a place along a unit vector enters the box: distance of the place from its plane
    /// (m), < 0 behind it, and its outward normal. None where the line misses the box, or has left it before the place
    /// (slabs, Kay and Kajiya 1986).
    #[must_use]
    pub fn entered(&self, place: Vec3<S>, way: Vec3<S>) -> Option<(S, Vec3<S>)> {
        let far = S::from_f64(f64::INFINITY);
        let (mut enter, mut leave, mut face) = (-far, far, None);
        for (i, (half, (x, rate))) in self.half.iter().zip(place.iter().zip(way)).enumerate() {
            if rate.abs() <= S::EPSILON {
                if x.abs() > *half {
                    return None;
                }
                continue;
            }
            let side = if rate > S::ZERO { -S::ONE } else { S::ONE };
            let (first, last) = ((side * *half - *x) / rate, (-(side * *half) - *x) / rate);
            if first > enter {
                (enter, face) = (first, Some((side * *x - *half, vec3::scale(axis(i), side))));
            }
            leave = leave.min(last);
        }
        face.filter(|_| enter <= leave && leave >= S::ZERO)
    }

    /// For a point inside: the nearest face; of equally near ones the first in the order of the axes.
    fn nearest_face(&self, place: Vec3<S>) -> Nearest<S> {
        let depth = |i: usize| vec3::pick(&self.half, i) - vec3::pick(&place, i).abs();
        let mut best = 0;
        for i in 1..3 {
            if depth(i) < depth(best) {
                best = i;
            }
        }
        let side = if vec3::pick(&place, best) < S::ZERO { -S::ONE } else { S::ONE };
        let (normal, gap) = (vec3::scale(axis(best), side), -depth(best));
        let foot = vec3::axpy(place, -gap, normal);
        Nearest { gap, normal, foot, feature: Feature::Face, distance: S::ZERO }
    }
}

impl<S: Scalar> Shape<S> {
    /// Radius of the bounding sphere about the origin of its axes (m); None for the half-space.
    #[must_use]
    pub fn reach(&self) -> Option<S> {
        match self {
            Shape::HalfSpace => None,
            Shape::Sphere(sphere) => Some(sphere.radius),
            Shape::Capsule(capsule) => Some(capsule.radius + capsule.half_length),
            Shape::Cuboid(cuboid) => Some(vec3::norm(cuboid.half)),
        }
    }
}

impl<S: Scalar> Surface<S> for Shape<S> {
    fn nearest(&self, place: Vec3<S>) -> Nearest<S> {
        match self {
            Shape::HalfSpace => HalfSpace.nearest(place),
            Shape::Sphere(sphere) => sphere.nearest(place),
            Shape::Capsule(capsule) => capsule.nearest(place),
            Shape::Cuboid(cuboid) => cuboid.nearest(place),
        }
    }
}
