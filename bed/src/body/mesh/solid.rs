//! The solid that a closed surface encloses, in its principal axes about its mass centre.
//!
//! In: a mesh in a file's axes. Out: the solid, and the pose of its axes in the file's.

use super::check::{MeshFault, checked};
use super::distance::Distance;
use super::field::{self, Field};
use super::mass::{Moments, principal};
use super::skin::{self, Patch};
use super::triangles::Mesh;
use crate::pose::Pose;
use smartbed_runtime::vec3::{Vec3, dot, norm};
use std::sync::OnceLock;

/// A closed surface and its integrals, in principal axes about its mass centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    mesh: Mesh,
    volume: f64,
    reach: f64,
    /// <x^2>, <y^2>, <z^2> (m^2).
    squares: Vec3<f64>,
    distance: Distance,
    /// Computed on first use, because a plan that is only read does not need it.
    field: OnceLock<Field>,
}

impl Solid {
    /// The solid that a mesh encloses, and the pose of its axes in the mesh's.
    ///
    /// # Errors
    /// [`MeshFault`] for a surface that encloses no volume, or too little to be sure.
    pub fn new(mesh: Mesh) -> Result<(Solid, Pose), MeshFault> {
        let mut mesh = checked(mesh)?;
        let Moments { volume, centre, second } = Moments::of(&mesh);
        let (squares, attitude) = principal(second);
        let pose = Pose { place: centre, attitude };
        mesh.corners.iter_mut().for_each(|corner| *corner = pose.inwards(*corner));
        let distance = Distance::new(&mesh);
        // The surface of the field may be outside that of the mesh by a fraction of a cell near edges.
        let reach = mesh.corners.iter().map(|c| norm(*c)).fold(0.0, f64::max) + field::cell(&mesh.bounds());
        Ok((Solid { mesh, volume, reach, squares, distance, field: OnceLock::new() }, pose))
    }

    /// The surface, in principal axes about the mass centre.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Volume (m^3).
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// As [`Shape::gyration`](crate::body::Shape::gyration).
    #[must_use]
    pub fn gyration(&self) -> Vec3<f64> {
        self.squares.map(|square| (3.0 * square).sqrt())
    }

    /// The field of the distance.
    #[must_use]
    pub fn field(&self) -> &Field {
        let distance = |place, near| self.distance.within(&self.mesh, place, near);
        self.field.get_or_init(|| Field::new(self.mesh.bounds(), distance))
    }

    /// Exact distance of a point from the triangles (m), negative inside.
    #[must_use]
    pub fn distance(&self, point: Vec3<f64>) -> f64 {
        self.distance.within(&self.mesh, point, f64::INFINITY)
    }

    /// Upper bound of the distance of its points from the mass centre (m).
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The farthest corner (m) in a direction.
    #[must_use]
    pub fn farthest(&self, direction: Vec3<f64>) -> Vec3<f64> {
        let further =
            |a: Vec3<f64>, b: &Vec3<f64>| if dot(*b, direction) > dot(a, direction) { *b } else { a };
        self.mesh.corners.iter().fold(self.mesh.corners[0], further)
    }

    /// Patches of its skin, each about this wide (m).
    #[must_use]
    pub fn skin(&self, width: f64) -> Vec<Patch> {
        skin::patches(&self.mesh, width)
    }

    /// The surface with at most this number of triangles, for pictures.
    #[must_use]
    pub fn coarse(&self, most: usize) -> Mesh {
        skin::coarse(&self.mesh, most)
    }
}
