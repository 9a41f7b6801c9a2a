//! The tile's loop and rod equations (the thesis, Eq. 2.1 to 2.3), recomputed from the coordinates.
//!
//! G_A - G_B = 0, G_B - G_C = 0 (m) and d_A + d_B + d_C = 0: nine numbers, zero on the mechanism.
//! Written out in components with the standard library's sine and cosine, apart from both the
//! generator and the Newton-Euler oracle.

use crate::closed_form::tile::AZIMUTHS;

/// The residuals of the nine equations for h, psi, theta, s of legs A, B, C and screw radius `r`.
///
/// # Panics
/// If `q` has not 12 entries.
#[must_use]
pub fn residuals(r: f64, q: &[f64]) -> [f64; 9] {
    assert_eq!(q.len(), 12, "h, psi, theta, s of three legs");
    let mut centres = [[0.0; 3]; 3];
    let mut rods = [[0.0; 3]; 3];
    for (leg, [cos_azimuth, sin_azimuth]) in AZIMUTHS.into_iter().enumerate() {
        let [h, psi, theta, s] = [q[4 * leg], q[4 * leg + 1], q[4 * leg + 2], q[4 * leg + 3]];
        let cos_yaw = cos_azimuth * psi.cos() - sin_azimuth * psi.sin();
        let sin_yaw = sin_azimuth * psi.cos() + cos_azimuth * psi.sin();
        let rod = [-theta.cos() * cos_yaw, -theta.cos() * sin_yaw, theta.sin()];
        let connector = [r * cos_azimuth, r * sin_azimuth, h];
        rods[leg] = rod;
        centres[leg] = [0, 1, 2].map(|axis| connector[axis] + s * rod[axis]);
    }
    let mut residuals = [0.0; 9];
    for axis in 0..3 {
        residuals[axis] = centres[0][axis] - centres[1][axis];
        residuals[3 + axis] = centres[1][axis] - centres[2][axis];
        residuals[6 + axis] = rods[0][axis] + rods[1][axis] + rods[2][axis];
    }
    residuals
}

/// The largest residual; infinite if a coordinate is not a number.
#[must_use]
pub fn largest_residual(r: f64, q: &[f64]) -> f64 {
    let largest = |worst: f64, x: f64| if x.is_nan() { f64::INFINITY } else { worst.max(x.abs()) };
    residuals(r, q).into_iter().fold(0.0, largest)
}
