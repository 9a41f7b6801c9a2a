//! Energies of a chain of point masses on massless rods: absolute angles from the downward vertical.

/// Kinetic and potential energy (J); the pin is the height zero.
#[must_use]
pub fn energy(masses: &[f64], lengths: &[f64], g: f64, q: &[f64], u: &[f64]) -> (f64, f64) {
    let (mut kinetic, mut potential) = (0.0, 0.0);
    let (mut height, mut vx, mut vy) = (0.0, 0.0, 0.0);
    for i in 0..masses.len() {
        height -= lengths[i] * q[i].cos();
        vx += lengths[i] * q[i].cos() * u[i];
        vy += lengths[i] * q[i].sin() * u[i];
        kinetic += 0.5 * masses[i] * (vx * vx + vy * vy);
        potential += masses[i] * g * height;
    }
    (kinetic, potential)
}
