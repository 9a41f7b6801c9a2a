//! The tile's configuration from its three heights, in closed form and by a second construction.
//!
//! Heave and slopes are linear in the heights; the platform turns without torsion about a
//! horizontal axis; its centre is the Fermat point of the triangle of connector points (the three
//! rods meet there at 120 degrees). The slope form has no division by the tilt and is smooth at
//! level. Axes of the bed: screws at azimuths 90, 210, 330 degrees.

use crate::random::Random;
use nalgebra::{Matrix3, Vector3};

/// sin 60 degrees.
const SIN_60: f64 = 0.866_025_403_784_438_6;
/// Cosine and sine of the azimuths of screws A, B, C.
pub const AZIMUTHS: [[f64; 2]; 3] = [[0.0, 1.0], [-SIN_60, -0.5], [SIN_60, -0.5]];

/// Where everything is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Posture {
    /// Mean height (m).
    pub heave: f64,
    /// Slopes of the plane through the connector points: h_i = heave - r (slope . azimuth_i).
    pub slope: [f64; 2],
    /// Platform centre (m).
    pub centre: Vector3<f64>,
    /// Platform frame: columns e1 (outwards along rod A), e2, e3 (normal).
    pub rotation: Matrix3<f64>,
    /// Slides along the rods (m).
    pub s: [f64; 3],
}

impl Posture {
    /// Angle between platform and horizontal (rad).
    #[must_use]
    pub fn tilt(&self) -> f64 {
        self.slope[0].hypot(self.slope[1]).atan()
    }

    /// h, psi, theta, s of legs A, B, C on a circle of radius `r`.
    #[must_use]
    pub fn coordinates(&self, r: f64, h: [f64; 3]) -> [f64; 12] {
        let mut q = [0.0; 12];
        for (leg, [c, s]) in AZIMUTHS.into_iter().enumerate() {
            let connector = Vector3::new(r * c, r * s, h[leg]);
            let outward = (connector - self.centre) / self.s[leg];
            let radial = outward.x * c + outward.y * s;
            let tangential = outward.y * c - outward.x * s;
            q[4 * leg] = h[leg];
            q[4 * leg + 1] = tangential.atan2(radial);
            q[4 * leg + 2] = (-outward.z).atan2(radial.hypot(tangential));
            q[4 * leg + 3] = self.s[leg];
        }
        q
    }
}

/// The slope form. Worked out in axes turned by -90 degrees, where screw A stands on x.
#[must_use]
pub fn posture(r: f64, h: [f64; 3]) -> Posture {
    let turned = [[1.0, 0.0], [-0.5, SIN_60], [-0.5, -SIN_60]];
    let heave = (h[0] + h[1] + h[2]) / 3.0;
    let slope = |axis: usize| -2.0 / (3.0 * r) * (0..3).map(|i| h[i] * turned[i][axis]).sum::<f64>();
    let (tx, ty) = (slope(0), slope(1));
    let squares = tx * tx + ty * ty;
    let q = (1.0 + squares).sqrt();
    let cubic = tx * tx * tx - 3.0 * tx * ty * ty;
    let k = 1.0 / (q * (q + 1.0));
    let x = 0.5 * r * (-(tx * tx - ty * ty) / (q + 1.0) + cubic * tx * k / (q + 1.0));
    let y = 0.5 * r * (2.0 * tx * ty / (q + 1.0) + cubic * ty * k / (q + 1.0));
    let z = heave + 0.5 * r * cubic * k;
    let slide = |[c, s]: [f64; 2]| {
        r * (1.0 + (0.5 * squares + (tx * tx - ty * ty) * c - 2.0 * tx * ty * s) / (q + 1.0))
    };
    let (xx, xy, yy) = (1.0 - k * tx * tx, -k * tx * ty, 1.0 - k * ty * ty);
    let rotation = Matrix3::new(xx, xy, tx / q, xy, yy, ty / q, -tx / q, -ty / q, 1.0 / q);
    Posture {
        heave,
        slope: [-ty, tx],
        centre: Vector3::new(-y, x, z),
        rotation: Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0) * rotation,
        s: turned.map(slide),
    }
}

/// Fermat point of a triangle with all angles below 120 degrees, and the distances of the corners
/// from it.
#[must_use]
pub fn fermat_point(corners: [Vector3<f64>; 3]) -> (Vector3<f64>, [f64; 3]) {
    let [a, b, c] = corners;
    let squares = [(b - c).norm_squared(), (c - a).norm_squared(), (a - b).norm_squared()];
    let area = 0.5 * (b - a).cross(&(c - a)).norm();
    let sum: f64 = squares.iter().sum();
    let total = (0.5 * sum + 2.0 * 3.0f64.sqrt() * area).sqrt();
    let s = squares.map(|square| total / 3.0 + (sum - 3.0 * square) / (3.0 * total));
    let weight = s.map(f64::recip);
    let point = (a * weight[0] + b * weight[1] + c * weight[2]) / weight.iter().sum::<f64>();
    (point, s)
}

/// The connector points.
#[must_use]
pub fn connectors(r: f64, h: [f64; 3]) -> [Vector3<f64>; 3] {
    [0, 1, 2].map(|leg| Vector3::new(r * AZIMUTHS[leg][0], r * AZIMUTHS[leg][1], h[leg]))
}

/// Heights and their rates of a random state: heights within 0.12 m of `nominal`, tilt below 45
/// degrees, rates below 0.5 m/s.
pub fn random_heights(random: &mut Random, r: f64, nominal: f64) -> ([f64; 3], [f64; 3]) {
    loop {
        let h = [(); 3].map(|()| random.between(nominal - 0.12, nominal + 0.12));
        let h_dot = [(); 3].map(|()| random.between(-0.5, 0.5));
        if posture(r, h).tilt() < std::f64::consts::FRAC_PI_4 {
            return (h, h_dot);
        }
    }
}
