//! Energy of springs and the volume under a sheet, with their derivatives.
//!
//! In: places of the nodes in the tile's frame. Out: sums added to a gradient and to a band. A spring of tension
//! T = k (l - L) along d has the Hessian k d d' + T/l (I - d d'); where it is pushed a search leaves the second term out, so
//! that the matrix stays positive (the gradient is exact). The volume of a facet is the mean over its two triangulations, as the
//! runtime's; triangle a b c under the origin holds a . (b x c)/6.

use super::Lattice;
use crate::band::Band;
use smartbed_runtime::vec3::{Vec3, add_at, cross, dot, norm, scale, sub};

/// Energy of all springs (J).
#[must_use]
pub fn energy(lattice: &Lattice, places: &[Vec3<f64>]) -> f64 {
    let one = |s: &super::Spring| {
        let stretch = norm(sub(places[s.ends[1]], places[s.ends[0]])) - s.rest_length;
        0.5 * s.stiffness * stretch * stretch
    };
    lattice.springs.iter().map(one).sum()
}

/// Adds the gradient of the springs' energy.
pub fn add_gradient(lattice: &Lattice, places: &[Vec3<f64>], gradient: &mut [Vec3<f64>]) {
    for spring in &lattice.springs {
        let [tail, head] = spring.ends;
        let along = sub(places[head], places[tail]);
        let length = norm(along);
        let pull = scale(along, spring.stiffness * (length - spring.rest_length) / length);
        add_at(gradient, head, pull);
        add_at(gradient, tail, scale(pull, -1.0));
    }
}

/// Adds the springs' Hessian: all of it, or where pushed its positive part.
pub fn add_hessian(lattice: &Lattice, places: &[Vec3<f64>], is_exact: bool, band: &mut Band) {
    for spring in &lattice.springs {
        let [tail, head] = spring.ends.map(|end| lattice.free(end));
        let along = sub(places[spring.ends[1]], places[spring.ends[0]]);
        let length = norm(along);
        let d = scale(along, 1.0 / length);
        let across = spring.stiffness * (length - spring.rest_length) / length;
        let across = if is_exact { across } else { across.max(0.0) };
        let block = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let same = if i == j { across } else { 0.0 };
                same + (spring.stiffness - across) * d[i] * d[j]
            })
        });
        for end in [tail, head].into_iter().flatten() {
            band.add_block(end, end, &block);
        }
        if let (Some(tail), Some(head)) = (tail, head) {
            band.add_block(tail, head, &block.map(|row: [f64; 3]| row.map(|x| -x)));
        }
    }
}

/// The four triangles of both triangulations of a facet.
fn triangles([a, b, c, d]: [usize; 4]) -> [[usize; 3]; 4] {
    [[a, b, c], [a, c, d], [a, b, d], [b, c, d]]
}

/// Volume between the sheet and the plane of its rim (m^3).
#[must_use]
pub fn volume(lattice: &Lattice, places: &[Vec3<f64>]) -> f64 {
    let one = |t: [usize; 3]| {
        let [a, b, c] = t.map(|node| places[node]);
        dot(a, cross(b, c)) / 12.0
    };
    lattice.facets().flat_map(triangles).map(one).sum()
}

/// Adds a factor times the gradient of the volume.
pub fn add_volume_gradient(lattice: &Lattice, places: &[Vec3<f64>], factor: f64, gradient: &mut [Vec3<f64>]) {
    for [i, j, k] in lattice.facets().flat_map(triangles) {
        let (a, b, c) = (places[i], places[j], places[k]);
        add_at(gradient, i, scale(cross(b, c), factor / 12.0));
        add_at(gradient, j, scale(cross(c, a), factor / 12.0));
        add_at(gradient, k, scale(cross(a, b), factor / 12.0));
    }
}

/// The area that belongs to each node, towards the outside (m^2): the volume's derivative by its place.
#[must_use]
pub fn areas(lattice: &Lattice, places: &[Vec3<f64>]) -> Vec<Vec3<f64>> {
    let mut areas = vec![[0.0; 3]; places.len()];
    add_volume_gradient(lattice, places, 1.0, &mut areas);
    areas
}

/// Adds a factor times the Hessian of the volume: the derivative of b x c by b is v -> v x c.
pub fn add_volume_hessian(lattice: &Lattice, places: &[Vec3<f64>], factor: f64, band: &mut Band) {
    let s = factor / 12.0;
    for [i, j, k] in lattice.facets().flat_map(triangles) {
        for (row, column, third) in [(i, j, k), (j, k, i), (k, i, j)] {
            let (Some(row), Some(column)) = (lattice.free(row), lattice.free(column)) else { continue };
            let [x, y, z] = scale(places[third], s);
            let block = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]];
            band.add_block(row, column, &block);
        }
    }
}
