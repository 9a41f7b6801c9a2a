//! Volume, mass centre, second moments and principal axes of a closed surface.
//!
//! In: triangles. Out: sums of signed integrals over the tetrahedra that each triangle spans with one corner of the
//! surface: V = a . (b x c)/6, int x = V/4 (a + b + c), int x x' = V/20 (a a' + b b' + c c' + s s') with s = a + b + c
//! (Mirtich 1996; Eberly 2002).

use super::triangles::{Mesh, doubled_area};
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::vec3::{Vec3, add, axpy, dot, scale, sub};

/// Number of sweeps of the eigenvalue iteration, which converges quadratically.
const SWEEPS: usize = 12;

/// Integrals over a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moments {
    /// Volume (m^3); negative if normals point inwards.
    pub volume: f64,
    /// Mass centre (m).
    pub centre: Vec3<f64>,
    /// <x x'> about the centre (m^2).
    pub second: [Vec3<f64>; 3],
}

impl Moments {
    /// Integrals over the solid that a mesh encloses.
    pub fn of(mesh: &Mesh) -> Moments {
        // Relative to a corner of the surface, so that a body far from the origin loses no digits.
        let base = mesh.corners.first().copied().unwrap_or_default();
        let (mut volume, mut first, mut second) = (0.0, [0.0; 3], [[0.0; 3]; 3]);
        for triangle in 0..mesh.triangles.len() {
            let places = mesh.places(triangle).map(|place| sub(place, base));
            let own = dot(places[0], doubled_area(places)) / 6.0;
            let sum = places.into_iter().fold([0.0; 3], add);
            volume += own;
            first = axpy(first, own / 4.0, sum);
            for x in places.into_iter().chain([sum]) {
                (0..3).for_each(|i| second[i] = axpy(second[i], own / 20.0 * x[i], x));
            }
        }
        if volume == 0.0 {
            return Moments { volume, centre: base, second };
        }
        let centre = scale(first, 1.0 / volume);
        let about = |i: usize| axpy(scale(second[i], 1.0 / volume), -centre[i], centre);
        Moments { volume, centre: add(base, centre), second: [about(0), about(1), about(2)] }
    }
}

/// Eigenvalues and eigenvectors of a symmetric matrix, the latter as axes of a right-handed frame, by Jacobi's
/// rotations (Golub and Van Loan, Matrix Computations, 8.5).
pub(super) fn principal(mut a: [Vec3<f64>; 3]) -> (Vec3<f64>, Attitude<f64>) {
    // Rows are the axes found so far.
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let size = a[0][0] + a[1][1] + a[2][2];
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            // Entries within rounding error cause no rotation, so that a box keeps its axes.
            if a[p][q].abs() <= 1e-14 * size {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = 1.0_f64.copysign(theta) / (theta.abs() + theta.hypot(1.0));
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            for rows in [&mut a, &mut axes] {
                let [x, y] = [rows[p], rows[q]];
                rows[p] = axpy(scale(x, c), -s, y);
                rows[q] = axpy(scale(x, s), c, y);
            }
        }
    }
    ([a[0][0], a[1][1], a[2][2]], attitude(axes))
}

/// The attitude of a frame by its axes (Shepperd 1978: the largest parameter first).
fn attitude([x, y, z]: [Vec3<f64>; 3]) -> Attitude<f64> {
    let squares = [
        1.0 + x[0] + y[1] + z[2],
        1.0 + x[0] - y[1] - z[2],
        1.0 - x[0] + y[1] - z[2],
        1.0 - x[0] - y[1] + z[2],
    ];
    let largest = (1..4).fold(0, |best, k| if squares[k] > squares[best] { k } else { best });
    let [wx, wy, wz] = [y[2] - z[1], z[0] - x[2], x[1] - y[0]];
    let [xy, xz, yz] = [x[1] + y[0], x[2] + z[0], y[2] + z[1]];
    let parameters = match largest {
        0 => [squares[0], wx, wy, wz],
        1 => [wx, squares[1], xy, xz],
        2 => [wy, xy, squares[2], yz],
        _ => [wz, xz, yz, squares[3]],
    };
    let root = squares[largest].sqrt();
    Attitude::restored(parameters.map(|e| 0.5 * e / root))
}
