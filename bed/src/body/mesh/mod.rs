//! A rigid body as a mesh: a closed surface of triangles, its mass properties, and how far points are from it.
//!
//! In: corners and triangles in a file's axes. Out: a [`Solid`] in its principal axes about its mass centre, and the pose of
//! these in the file's. Contact asks a smooth field of the distance ([`field`]), which an exact one ([`distance`]) fills:
//! that of triangles has kinks inside, where a state of least energy would roll from face to face.

mod check;
pub mod distance;
pub mod field;
mod mass;
mod skin;

pub use check::{MOST_TRIANGLES, MeshFault};
pub use skin::Patch;

use crate::pose::Pose;
use check::checked;
use distance::Distance;
use field::Field;
use mass::{Moments, principal};
use smartbed_runtime::vec3::{Vec3, dot, norm, sub};
use std::sync::OnceLock;

/// Corners, and triangles by their numbers, counterclockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// m.
    pub corners: Vec<Vec3<f64>>,
    /// Triangles.
    pub triangles: Vec<[usize; 3]>,
}

/// A closed surface with what it encloses, in principal axes about its mass centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    mesh: Mesh,
    volume: f64,
    reach: f64,
    /// <x^2>, <y^2>, <z^2> (m^2).
    squares: Vec3<f64>,
    distance: Distance,
    /// Filled when it is first asked for: a plan that is only read has no use for it.
    field: OnceLock<Field>,
}

impl Mesh {
    /// Triangles whose corners stand in the list one by one: equal places become one corner.
    #[must_use]
    pub fn welded(places: impl Iterator<Item = Vec3<f64>>) -> Mesh {
        let (mut mesh, mut known) = (Mesh::default(), std::collections::BTreeMap::new());
        let mut numbers = Vec::new();
        for place in places {
            // -0 and 0 are one place.
            let key = place.map(|x| (x + 0.0).to_bits());
            numbers.push(*known.entry(key).or_insert_with(|| {
                mesh.corners.push(place);
                mesh.corners.len() - 1
            }));
        }
        mesh.triangles = numbers.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
        mesh
    }

    /// Corners of a triangle.
    #[must_use]
    pub fn places(&self, triangle: usize) -> [Vec3<f64>; 3] {
        self.triangles[triangle].map(|corner| self.corners[corner])
    }

    /// Smallest and largest coordinates.
    #[must_use]
    pub fn bounds(&self) -> [Vec3<f64>; 2] {
        let all = |start: f64, of: fn(f64, f64) -> f64| {
            self.corners.iter().fold([start; 3], |most, c| [0, 1, 2].map(|k| of(most[k], c[k])))
        };
        [all(f64::INFINITY, f64::min), all(f64::NEG_INFINITY, f64::max)]
    }
}

impl Solid {
    /// What a mesh encloses, and the pose of its axes in the mesh's.
    ///
    /// # Errors
    /// [`MeshFault`] for a surface that encloses nothing, or not clearly.
    pub fn new(mesh: Mesh) -> Result<(Solid, Pose), MeshFault> {
        let mut mesh = checked(mesh)?;
        let Moments { volume, centre, second } = Moments::of(&mesh);
        let (squares, attitude) = principal(second);
        let pose = Pose { place: centre, attitude };
        mesh.corners.iter_mut().for_each(|corner| *corner = pose.inwards(*corner));
        let distance = Distance::new(&mesh);
        // The field's surface may stand out by a part of a cell where faces meet.
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

    /// As [`Shape::gyration`](super::Shape::gyration).
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

    /// Exact distance of a point from the triangles (m), below 0 inside.
    #[must_use]
    pub fn distance(&self, point: Vec3<f64>) -> f64 {
        self.distance.within(&self.mesh, point, f64::INFINITY)
    }

    /// No point is further from the mass centre than this (m).
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

    /// Patches of its skin, each about as wide as this (m).
    #[must_use]
    pub fn skin(&self, width: f64) -> Vec<Patch> {
        skin::patches(&self.mesh, width)
    }

    /// The surface with no more triangles than this, for pictures.
    #[must_use]
    pub fn coarse(&self, most: usize) -> Mesh {
        skin::coarse(&self.mesh, most)
    }
}

/// Normal of a triangle, as long as twice its area.
fn doubled_area([a, b, c]: [Vec3<f64>; 3]) -> Vec3<f64> {
    smartbed_runtime::vec3::cross(sub(b, a), sub(c, a))
}
