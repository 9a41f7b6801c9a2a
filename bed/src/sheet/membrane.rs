//! Energy of the springs of a sheet, and the volume under it, with their derivatives.
//!
//! In: positions of the nodes in the tile's frame. Out: terms added to a gradient and to a band. A spring with tension
//! T = k (l - L) along d has the Hessian k d d' + T/l (I - d d'); a search omits the second term under compression, so
//! that the matrix stays positive (the gradient is exact). The volume below a facet is the mean over its two
//! triangulations, as in the runtime; the tetrahedron of triangle a b c and the origin has a . (b x c)/6.

use super::Lattice;
use crate::band::Band;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::{Vec3, add_at, cross, dot, norm, scale, sub};

/// Energy of all springs (J).
#[must_use]
pub fn energy<T: Scalar>(lattice: &Lattice<T>, places: &[Vec3<T>]) -> T {
    let one = |s: &super::Spring<T>| {
        let stretch = norm(sub(places[s.ends[1]], places[s.ends[0]])) - s.rest_length;
        T::from_f64(0.5) * s.stiffness * stretch * stretch
    };
    lattice.springs.iter().map(one).fold(T::ZERO, |sum, x| sum + x)
}

/// Adds the gradient of the springs' energy.
pub fn add_gradient<T: Scalar>(lattice: &Lattice<T>, places: &[Vec3<T>], gradient: &mut [Vec3<T>]) {
    for spring in &lattice.springs {
        let [tail, head] = spring.ends;
        let along = sub(places[head], places[tail]);
        let length = norm(along);
        let pull = scale(along, spring.stiffness * (length - spring.rest_length) / length);
        add_at(gradient, head, pull);
        add_at(gradient, tail, scale(pull, -T::ONE));
    }
}

/// Adds the springs' Hessian: exact, or under compression only its positive part.
pub fn add_hessian<T: Scalar>(lattice: &Lattice<T>, places: &[Vec3<T>], is_exact: bool, band: &mut Band<T>) {
    for spring in &lattice.springs {
        let [tail, head] = spring.ends.map(|end| lattice.free(end));
        let along = sub(places[spring.ends[1]], places[spring.ends[0]]);
        let length = norm(along);
        let d = scale(along, T::ONE / length);
        let across = spring.stiffness * (length - spring.rest_length) / length;
        let across = if is_exact || across > T::ZERO { across } else { T::ZERO };
        let block = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let same = if i == j { across } else { T::ZERO };
                same + (spring.stiffness - across) * d[i] * d[j]
            })
        });
        for end in [tail, head].into_iter().flatten() {
            band.add_block(end, end, &block);
        }
        if let (Some(tail), Some(head)) = (tail, head) {
            band.add_block(tail, head, &block.map(|row: [T; 3]| row.map(|x| -x)));
        }
    }
}

/// The four triangles of the two triangulations of a facet.
fn triangles([a, b, c, d]: [usize; 4]) -> [[usize; 3]; 4] {
    [[a, b, c], [a, c, d], [a, b, d], [b, c, d]]
}

/// Volume between the sheet and the plane of its rim (m^3).
#[must_use]
pub fn volume<T: Scalar>(lattice: &Lattice<T>, places: &[Vec3<T>]) -> T {
    let one = |t: [usize; 3]| {
        let [a, b, c] = t.map(|node| places[node]);
        dot(a, cross(b, c)) / T::from_f64(12.0)
    };
    lattice.facets().flat_map(triangles).map(one).fold(T::ZERO, |sum, x| sum + x)
}

/// Adds `factor` times the gradient of the volume.
pub fn add_volume_gradient<T: Scalar>(
    lattice: &Lattice<T>,
    places: &[Vec3<T>],
    factor: T,
    gradient: &mut [Vec3<T>],
) {
    let factor = factor / T::from_f64(12.0);
    for [i, j, k] in lattice.facets().flat_map(triangles) {
        let (a, b, c) = (places[i], places[j], places[k]);
        add_at(gradient, i, scale(cross(b, c), factor));
        add_at(gradient, j, scale(cross(c, a), factor));
        add_at(gradient, k, scale(cross(a, b), factor));
    }
}

/// The area vector of each node, pointing outwards (m^2): the derivative of the volume with respect to its position.
#[must_use]
pub fn areas<T: Scalar>(lattice: &Lattice<T>, places: &[Vec3<T>]) -> Vec<Vec3<T>> {
    let mut areas = vec![[T::ZERO; 3]; places.len()];
    add_volume_gradient(lattice, places, T::ONE, &mut areas);
    areas
}

/// Adds `factor` times the Hessian of the volume: the derivative of b x c with respect to b is v -> v x c.
pub fn add_volume_hessian<T: Scalar>(
    lattice: &Lattice<T>,
    places: &[Vec3<T>],
    factor: T,
    band: &mut Band<T>,
) {
    let s = factor / T::from_f64(12.0);
    for [i, j, k] in lattice.facets().flat_map(triangles) {
        for (row, column, third) in [(i, j, k), (j, k, i), (k, i, j)] {
            let (Some(row), Some(column)) = (lattice.free(row), lattice.free(column)) else { continue };
            let [x, y, z] = scale(places[third], s);
            let block = [[T::ZERO, z, -y], [-z, T::ZERO, x], [y, -x, T::ZERO]];
            band.add_block(row, column, &block);
        }
    }
}
