//! A mesh: corners and triangles.

use smartbed_runtime::vec3::{Vec3, cross, sub};
use std::collections::BTreeMap;

/// Corners, and triangles by the indices of their corners, counterclockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions (m).
    pub corners: Vec<Vec3<f64>>,
    /// Indices of the corners of each triangle.
    pub triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// A mesh from triangles given corner by corner; equal positions become one corner.
    #[must_use]
    pub fn welded(places: impl Iterator<Item = Vec3<f64>>) -> Mesh {
        let (mut mesh, mut known) = (Mesh::default(), BTreeMap::new());
        let mut numbers = Vec::new();
        for place in places {
            // -0 and 0 are the same position.
            let key = place.map(|x| (x + 0.0).to_bits());
            numbers.push(*known.entry(key).or_insert_with(|| {
                mesh.corners.push(place);
                mesh.corners.len() - 1
            }));
        }
        mesh.triangles = numbers.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
        mesh
    }

    /// Positions of the corners of a triangle.
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

/// Normal of a triangle, with the length of twice its area.
pub(super) fn doubled_area([a, b, c]: [Vec3<f64>; 3]) -> Vec3<f64> {
    cross(sub(b, a), sub(c, a))
}
