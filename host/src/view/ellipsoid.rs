//! The homogeneous ellipsoid of a body's mass and inertia.
//!
//! In: mass and inertia matrix about the mass centre. Out: semi-axes and the directions of the principal axes.
//! A point inside has x^2/a^2 + y^2/b^2 + z^2/c^2 <= 1 and I_xx = m (b^2 + c^2)/5, cyclic, so
//! a^2 = 5 (I_yy + I_zz - I_xx)/(2 m).

/// Sweeps of Jacobi's method, which converges quadratically.
const SWEEPS: usize = 12;

/// Semi-axes, and the principal directions as rows.
pub type Ellipsoid = ([f64; 3], [[f64; 3]; 3]);

/// The ellipsoid; `None` for a mass or moments that no rigid body has (a plane model gives only one moment).
#[must_use]
pub fn of(mass: f64, [xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Option<Ellipsoid> {
    let (moments, axes) = principal([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]);
    let sum: f64 = moments.iter().sum();
    let squares = moments.map(|moment| 2.5 * (sum - 2.0 * moment) / mass);
    // A flat body has one axis of length 0, up to rounding.
    let least = -1e-9 * squares.iter().fold(0.0_f64, |m, x| m.max(*x));
    let is_body = mass > 0.0 && moments.iter().all(|m| *m > 0.0) && squares.iter().all(|s| *s >= least);
    is_body.then(|| (squares.map(|s| s.max(0.0).sqrt()), axes))
}

/// Eigenvalues and eigenvectors (rows) of a symmetric matrix by Jacobi's rotations (Golub & Van Loan, 8.5).
fn principal(mut a: [[f64; 3]; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for (p, q) in [(0, 1), (0, 2), (1, 2)].into_iter().cycle().take(3 * SWEEPS) {
        if a[p][q] == 0.0 {
            continue;
        }
        let theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
        let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
        let c = 1.0 / t.hypot(1.0);
        let s = t * c;
        for row in &mut a {
            (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
        }
        for column in 0..3 {
            (a[p][column], a[q][column]) =
                (c * a[p][column] - s * a[q][column], s * a[p][column] + c * a[q][column]);
            (axes[p][column], axes[q][column]) =
                (c * axes[p][column] - s * axes[q][column], s * axes[p][column] + c * axes[q][column]);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], axes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ellipsoid_turned_is_found_again() {
        // Semi-axes 1, 2, 3, mass 5: moments 13, 10, 5, turned by 0.4 rad about z.
        let (c, s) = (0.4_f64.cos(), 0.4_f64.sin());
        let inertia = [13.0 * c * c + 10.0 * s * s, 13.0 * s * s + 10.0 * c * c, 5.0, 3.0 * s * c, 0.0, 0.0];
        let (sizes, axes) = of(5.0, inertia).expect("a body");
        for (size, expected) in sizes.iter().zip([1.0, 2.0, 3.0]) {
            assert!((size - expected).abs() < 1e-12, "{sizes:?}");
        }
        assert!((axes[0][0].abs() - c).abs() < 1e-12 && (axes[0][1].abs() - s).abs() < 1e-12, "{axes:?}");
    }

    #[test]
    fn what_no_body_has_is_none() {
        assert_eq!(of(1.0, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]), None, "one moment alone");
        assert_eq!(of(1.0, [1.0, 1.0, 3.0, 0.0, 0.0, 0.0]), None, "more than the other two together");
        assert_eq!(of(0.0, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]), None, "no mass");
        // A disk: its thickness is 0.
        assert!(of(1.0, [1.0, 1.0, 2.0, 0.0, 0.0, 0.0]).is_some_and(|(sizes, _)| sizes[2] == 0.0));
    }
}
