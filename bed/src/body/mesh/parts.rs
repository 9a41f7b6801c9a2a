//! Connected parts of a surface: each must face outwards, or inwards if it is a cavity.
//!
//! In: a closed mesh that does not intersect itself. Out: whether all of it faces inwards, or a part with the wrong
//! orientation. A part inside an odd number of others is a cavity; how often a point is enclosed is the sum of the
//! solid angles of triangles divided by 4 pi (van Oosterom and Strackee 1983).

use super::triangles::{Mesh, doubled_area};
use smartbed_runtime::vec3::{Vec3, cross, dot, norm, sub};
use std::f64::consts::TAU;

/// Does the whole surface face inwards?
///
/// # Errors
/// A place on a part that is oriented otherwise than the first one.
pub(super) fn is_inside_out(mesh: &Mesh) -> Result<bool, Vec3<f64>> {
    let parts = parts(mesh);
    let is_turned = |part: &Vec<usize>| {
        let start = mesh.places(part[0])[0];
        let around = parts.iter().filter(|other| other[0] != part[0] && encloses(mesh, other, start));
        (volume(mesh, part) < 0.0) != (around.count() % 2 == 1)
    };
    let first = is_turned(&parts[0]);
    let odd = parts.iter().find(|part| is_turned(part) != first);
    odd.map_or(Ok(first), |part| Err(mesh.places(part[0])[0]))
}

/// Triangles of each connected part, in order.
fn parts(mesh: &Mesh) -> Vec<Vec<usize>> {
    // Union-find: each corner leads to another one of its part, the representative to itself.
    let mut leads: Vec<usize> = (0..mesh.corners.len()).collect();
    let end = |leads: &mut Vec<usize>, mut corner: usize| {
        while leads[corner] != corner {
            leads[corner] = leads[leads[corner]];
            corner = leads[corner];
        }
        corner
    };
    for [a, b, c] in &mesh.triangles {
        for corner in [*b, *c] {
            let [one, other] = [*a, corner].map(|own| end(&mut leads, own));
            leads[one.max(other)] = one.min(other);
        }
    }
    let mut numbers = vec![None; mesh.corners.len()];
    let mut parts: Vec<Vec<usize>> = Vec::new();
    for (triangle, [a, ..]) in mesh.triangles.iter().enumerate() {
        let number = numbers[end(&mut leads, *a)].get_or_insert_with(|| {
            parts.push(Vec::new());
            parts.len() - 1
        });
        parts[*number].push(triangle);
    }
    parts
}

/// Signed volume of a part.
fn volume(mesh: &Mesh, part: &[usize]) -> f64 {
    let base = mesh.places(part[0])[0];
    let one = |triangle: &usize| {
        let places = mesh.places(*triangle).map(|place| sub(place, base));
        dot(places[0], doubled_area(places)) / 6.0
    };
    part.iter().map(one).sum()
}

/// Does a part enclose a point?
fn encloses(mesh: &Mesh, part: &[usize], point: Vec3<f64>) -> bool {
    let corners = || part.iter().flat_map(|triangle| mesh.places(*triangle));
    let is_beyond = |k: usize| corners().all(|x| x[k] < point[k]) || corners().all(|x| x[k] > point[k]);
    if (0..3).any(is_beyond) {
        return false;
    }
    let angle = |triangle: &usize| {
        let [a, b, c] = mesh.places(*triangle).map(|place| sub(place, point));
        let [la, lb, lc] = [norm(a), norm(b), norm(c)];
        let whole = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        2.0 * dot(a, cross(b, c)).atan2(whole)
    };
    part.iter().map(angle).sum::<f64>().abs() > TAU
}
