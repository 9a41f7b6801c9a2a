//! Detects self-intersections of a surface.
//!
//! In: a closed mesh. Out: a place where two of its triangles meet other than at corners that they share: an edge of
//! one pierces the other, a corner stands in it, or both lie in one plane and overlap. Candidate pairs come from the
//! tree of boxes. An intersection shallower than a millionth of the mesh is attributed to the rounding of a file's
//! numbers.

use super::tree::Tree;
use super::triangles::{Mesh, doubled_area};
use smartbed_runtime::vec3::{Vec3, axpy, cross, dot, norm, scale, sub};

/// Depth below which an intersection is ignored, as a share of the longest side.
const SHALLOW: f64 = 1e-6;
/// An edge that passes within this distance (share of the longest side) outside a triangle's side counts as piercing
/// it, so that one of the two triangles at that side detects it.
const BESIDE: f64 = 1e-12;

/// A place where the surface intersects itself, if there is one.
pub(super) fn crossing(mesh: &Mesh, longest: f64) -> Option<Vec3<f64>> {
    let tree = Tree::new(mesh);
    let faces: Vec<Face> = (0..mesh.triangles.len()).map(|triangle| Face::new(mesh, triangle)).collect();
    let meet = |one: &Face, other: &Face| {
        let heights = [one.heights(other), other.heights(one)];
        if heights.iter().flatten().all(|h| h.abs() <= SHALLOW * longest) {
            return one.overlap(other, SHALLOW * longest);
        }
        other.pierced(one, heights[0], longest).or_else(|| one.pierced(other, heights[1], longest))
    };
    (0..faces.len()).find_map(|one| {
        let mut others = tree.overlapping(faces[one].bounds()).filter(|other| *other > one);
        others.find_map(|other| meet(&faces[one], &faces[other]))
    })
}

/// A triangle with its plane.
struct Face {
    /// Indices of its corners.
    corners: [usize; 3],
    places: [Vec3<f64>; 3],
    normal: Vec3<f64>,
    /// For each side the unit normal in the plane that points inwards.
    inwards: [Vec3<f64>; 3],
}

impl Face {
    fn new(mesh: &Mesh, triangle: usize) -> Face {
        let places = mesh.places(triangle);
        let unit = |v: Vec3<f64>| scale(v, 1.0 / norm(v));
        let normal = unit(doubled_area(places));
        let inwards = [0, 1, 2].map(|k| unit(cross(normal, sub(places[(k + 1) % 3], places[k]))));
        Face { corners: mesh.triangles[triangle], places, normal, inwards }
    }

    fn bounds(&self) -> [Vec3<f64>; 2] {
        let [a, b, c] = self.places;
        [f64::min, f64::max].map(|pick| [0, 1, 2].map(|k| pick(pick(a[k], b[k]), c[k])))
    }

    /// Heights of its corners above another triangle's plane.
    fn heights(&self, other: &Face) -> Vec3<f64> {
        self.places.map(|place| dot(other.normal, sub(place, other.places[0])))
    }

    /// Distance by which a point of its plane is inside all sides; negative if it is outside.
    fn inside(&self, x: Vec3<f64>) -> f64 {
        let sides = self.inwards.iter().zip(self.places);
        sides.map(|(inwards, place)| dot(*inwards, sub(x, place))).fold(f64::INFINITY, f64::min)
    }

    /// A place where another triangle, whose corners have these heights, pierces it or stands in it.
    fn pierced(&self, other: &Face, heights: Vec3<f64>, longest: f64) -> Option<Vec3<f64>> {
        // A degenerate triangle has no plane; an edge that pierces it pierces its neighbours.
        let width = dot(self.inwards[0], sub(self.places[2], self.places[0]));
        let least = SHALLOW * longest;
        if width <= least {
            return None;
        }
        let is_apart = |k: usize| !self.corners.contains(&other.corners[k]);
        (0..3).filter(|k| is_apart(*k)).find_map(|k| {
            let (next, x) = ((k + 1) % 3, other.places[k]);
            if heights[k].abs() <= least {
                return (self.inside(x) > least).then_some(x);
            }
            let is_through =
                is_apart(next) && heights[next].abs() > least && heights[k] * heights[next] < 0.0;
            let share = heights[k] / (heights[k] - heights[next]);
            let place = axpy(x, share, sub(other.places[next], x));
            (is_through && self.inside(place) >= -BESIDE * longest).then_some(place)
        })
    }

    /// A place of another triangle in the same plane if the two overlap, that is, if no side of either separates them.
    fn overlap(&self, other: &Face, least: f64) -> Option<Vec3<f64>> {
        let parts = |one: &Face, other: &Face| {
            one.inwards
                .iter()
                .zip(one.places)
                .any(|(inwards, place)| other.places.iter().all(|x| dot(*inwards, sub(*x, place)) <= least))
        };
        let middle = |face: &Face| face.places.iter().fold([0.0; 3], |sum, x| axpy(sum, 1.0 / 3.0, *x));
        (!parts(self, other) && !parts(other, self)).then(|| middle(other))
    }
}
