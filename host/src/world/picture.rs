//! Positions of everything in a world for pages: points, axes of bodies, sizes of solids.

use crate::contact_force::ContactForce;
use smartbed_runtime::surface::Shape;
use smartbed_runtime::vec3;

/// Number of values for a body's mass and inertia.
pub const INERTIA: usize = 7;

/// Positions, part by part.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Picture {
    /// Points (m).
    pub points: Vec<[f64; 3]>,
    /// First two axes of each body that has a frame.
    pub axes: Vec<[[f64; 3]; 2]>,
    /// Mass and moments of each body; 0 if its shape is known.
    pub inertias: Vec<[f64; INERTIA]>,
    /// Lengths of the shapes.
    pub sizes: Vec<f64>,
    /// Contact forces.
    pub forces: Vec<ContactForce>,
}

impl Picture {
    /// Adds a rigid part as one solid, a capsule as three.
    pub fn solid(&mut self, shape: &Shape<f64>, origin: [f64; 3], axes: [[f64; 3]; 3]) {
        let mut add = |at: [f64; 3], sizes: &[f64]| {
            self.points.push(at);
            self.axes.push([axes[0], axes[1]]);
            self.inertias.push([0.0; INERTIA]);
            self.sizes.extend(sizes);
        };
        match shape {
            Shape::HalfSpace => {}
            Shape::Sphere(sphere) => add(origin, &[sphere.radius]),
            Shape::Cuboid(cuboid) => add(origin, &cuboid.half.map(|half| 2.0 * half)),
            Shape::Capsule(capsule) => {
                add(origin, &[capsule.radius, 2.0 * capsule.half_length]);
                for side in [capsule.half_length, -capsule.half_length] {
                    add(vec3::axpy(origin, side, axes[2]), &[capsule.radius]);
                }
            }
        }
    }

    /// Appends another picture.
    pub fn append(&mut self, other: &Picture) {
        self.points.extend(&other.points);
        self.axes.extend(&other.axes);
        self.inertias.extend(&other.inertias);
        self.sizes.extend(&other.sizes);
    }
}
