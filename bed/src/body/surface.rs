//! The outer surface of a segment: a box with round edges, or a mesh.
//!
//! In: a point in the segment's axes. Out: its depth and the direction out; moments and extents of the whole.

use super::mesh::Solid;
use super::shape::Shape;
use smartbed_runtime::vec3::{Vec3, dot, norm, scale};
use std::sync::Arc;

/// A segment's surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// A box with round edges.
    Round(Shape),
    /// A mesh in its principal axes about its mass centre.
    Mesh(Arc<Solid>),
}

/// A point inside a surface, or inside a cover around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// Depth (m), > 0.
    pub depth: f64,
    /// Unit vector that points out.
    pub normal: Vec3<f64>,
    /// Decrease of the depth per distance along the normal: 1, less near the edges of a mesh.
    pub slope: f64,
}

impl From<Shape> for Surface {
    fn from(shape: Shape) -> Surface {
        Surface::Round(shape)
    }
}

impl Surface {
    /// The depth of a point inside a cover of this thickness (m) around the surface; `None` outside.
    #[must_use]
    pub fn within(&self, point: Vec3<f64>, cover: f64) -> Option<Inside> {
        match self {
            Surface::Round(shape) => {
                let (gap, normal) = shape.gap(point);
                (gap < cover).then_some(Inside { depth: cover - gap, normal, slope: 1.0 })
            }
            Surface::Mesh(solid) => {
                let near = solid.field().near(point)?;
                let slope = norm(near.gradient);
                let normal = scale(near.gradient, 1.0 / slope.max(f64::MIN_POSITIVE));
                (near.distance < cover).then_some(Inside { depth: cover - near.distance, normal, slope })
            }
        }
    }

    /// Second derivatives of the distance (1/m).
    #[must_use]
    pub fn curvature(&self, point: Vec3<f64>) -> [Vec3<f64>; 3] {
        match self {
            Surface::Round(shape) => shape.curvature(point),
            Surface::Mesh(solid) => solid.field().near(point).map_or([[0.0; 3]; 3], |near| near.hessian),
        }
    }

    /// Distance of a point (m), negative inside.
    #[must_use]
    pub fn distance(&self, point: Vec3<f64>) -> f64 {
        match self {
            Surface::Round(shape) => shape.gap(point).0,
            Surface::Mesh(solid) => {
                solid.field().near(point).map_or_else(|| solid.distance(point), |near| near.distance)
            }
        }
    }

    /// Some points well inside: of a round shape those of [`Shape::core`], of a mesh its centre and those halfway to
    /// its farthest corners along its axes, as far as they lie inside.
    #[must_use]
    pub fn core(&self) -> Vec<Vec3<f64>> {
        match self {
            Surface::Round(shape) => shape.core(),
            Surface::Mesh(solid) => {
                let half = [0, 1, 2].map(|k| {
                    let mut axis = [0.0; 3];
                    axis[k] = 1.0;
                    let out = self.extent(axis);
                    axis[k] = -1.0;
                    0.25 * (out + self.extent(axis))
                });
                let points = Shape { half, radius: 0.0 }.core();
                points.into_iter().filter(|point| solid.distance(*point) < 0.0).collect()
            }
        }
    }

    /// Upper bound of the distance of its points from the origin (m).
    #[must_use]
    pub fn reach(&self) -> f64 {
        match self {
            Surface::Round(shape) => shape.reach(),
            Surface::Mesh(solid) => solid.reach(),
        }
    }

    /// The farthest corner (m) in the direction of a unit vector.
    #[must_use]
    pub fn farthest(&self, direction: Vec3<f64>) -> Vec3<f64> {
        match self {
            Surface::Round(shape) => {
                // Along a side perpendicular to the direction take the middle.
                let sign = |x: f64| if x.abs() < 1e-9 { 0.0 } else { x.signum() };
                [0, 1, 2].map(|k| sign(direction[k]) * shape.half[k] + shape.radius * direction[k])
            }
            Surface::Mesh(solid) => solid.farthest(direction),
        }
    }

    /// Extent in the direction of a unit vector (m).
    #[must_use]
    pub fn extent(&self, direction: Vec3<f64>) -> f64 {
        dot(self.farthest(direction), direction)
    }

    /// As [`Shape::gyration`].
    #[must_use]
    pub fn gyration(&self) -> Vec3<f64> {
        match self {
            Surface::Round(shape) => shape.gyration(),
            Surface::Mesh(solid) => solid.gyration(),
        }
    }

    /// The box with round edges, if it is one.
    #[must_use]
    pub fn round(&self) -> Option<&Shape> {
        match self {
            Surface::Round(shape) => Some(shape),
            Surface::Mesh(_) => None,
        }
    }
}
