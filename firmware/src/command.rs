//! Commanded pose: heave and slopes in the bed's axes, and the three heights that reach it.
//!
//! In: time t (s). Out: [`Pose`], then heights h_i (m) of the connectors at the azimuths
//! alpha_i = 90, 210, 330 degrees on the circle of radius R.
//! The plane through the connectors is z = zc - tx x - ty y, so that the platform's normal is along
//! (tx, ty, 1), and h_i = zc - R (tx cos alpha_i + ty sin alpha_i): exact, not linearised.
//! Sign: a positive slope lowers the side on the positive axis.

use smartbed_runtime::real::Real;

/// Commanded pose of the platform.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pose {
    /// Heave: mean height of the connectors (m).
    pub zc: f32,
    /// Slope along x: n_x / n_z of the platform's normal (1).
    pub tx: f32,
    /// Slope along y: n_y / n_z (1).
    pub ty: f32,
}

/// (cos alpha, sin alpha) of the legs A, B, C; the second and third are sqrt(3)/2 and 1/2.
const AZIMUTHS: [(f32, f32); 3] = [(0.0, 1.0), (-0.866_025_4, -0.5), (0.866_025_4, -0.5)];

impl Pose {
    /// Heights of the connectors A, B, C (m) on a circle of this radius (m).
    #[must_use]
    pub fn heights(self, radius: f32) -> [f32; 3] {
        AZIMUTHS.map(|(cos, sin)| self.zc - radius * (self.tx * cos + self.ty * sin))
    }
}

/// A smooth demonstration: the tile rises while it tilts, then the direction of the tilt rotates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Profile {
    /// Initial heave, level (m).
    pub start: f32,
    /// Change of heave (m).
    pub rise: f32,
    /// Final slope (1).
    pub slope: f32,
    /// Time to reach both (s).
    pub ramp: f32,
    /// Angular velocity of the tilt's direction (rad/s).
    pub turn: f32,
}

impl Profile {
    /// Rises 30 mm in 2 s to a tilt of 5.7 degrees, whose direction rotates once in 5 s.
    #[must_use]
    pub const fn demonstration(start: f32) -> Self {
        Self { start, rise: 0.03, slope: 0.1, ramp: 2.0, turn: 1.256_637_1 }
    }

    /// The pose at time t (s).
    #[must_use]
    pub fn at(&self, t: f32) -> Pose {
        let s = smooth_step(t / self.ramp);
        let (sin, cos) = tile_sin_cos(self.turn * t);
        let slope = self.slope * s;
        Pose { zc: self.start + self.rise * s, tx: slope * cos, ty: slope * sin }
    }
}

/// Sine and cosine of an angle (rad), as a function that is not inlined.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
#[must_use]
pub fn tile_sin_cos(angle: f32) -> (f32, f32) {
    Real::sin_cos(angle)
}

/// 0 up to x = 0, 1 from x = 1 on, and between them x^3 (10 - 15 x + 6 x^2): velocity and
/// acceleration vanish at both ends.
fn smooth_step(x: f32) -> f32 {
    let x = Real::min(Real::max(x, 0.0), 1.0);
    x * x * x * (10.0 + x * (6.0 * x - 15.0))
}

#[cfg(test)]
mod tests {
    use super::{Pose, Profile, smooth_step};
    use smartbed_runtime::real::Real;

    /// A few roundings of numbers up to 1.
    const ROUNDING: f32 = 1e-6;

    #[test]
    fn heights_lie_in_the_commanded_plane() {
        let pose = Pose { zc: 0.12, tx: 0.1, ty: -0.2 };
        let [a, b, c] = pose.heights(0.2);
        assert!(((a + b + c) / 3.0 - pose.zc).abs() < ROUNDING);
        // The plane's gradient from its three points: slopes come back (in f64, independently).
        let (a, b, c) = (f64::from(a), f64::from(b), f64::from(c));
        let (half, r) = (Real::sqrt(3.0_f64) / 2.0, 0.2);
        let tx = -2.0 / (3.0 * r) * (c - b) * half;
        let ty = -2.0 / (3.0 * r) * (a - (b + c) / 2.0);
        assert!((tx - 0.1).abs() < 1e-6 && (ty + 0.2).abs() < 1e-6, "{tx} {ty}");
    }

    #[test]
    fn a_positive_slope_lowers_the_positive_side() {
        let [a, b, c] = Pose { zc: 0.0, tx: 0.1, ty: 0.0 }.heights(1.0);
        assert!(a == 0.0 && c < 0.0 && b > 0.0);
        let [a, ..] = Pose { zc: 0.0, tx: 0.0, ty: 0.1 }.heights(1.0);
        assert!(a < 0.0);
    }

    #[test]
    fn the_step_is_smooth() {
        assert_eq!([-1.0, 0.0, 0.5, 1.0, 7.0].map(smooth_step), [0.0, 0.0, 0.5, 1.0, 1.0]);
        let near = 1e-3;
        assert!(smooth_step(near) < 2e-8, "third order at the start");
        // Its terms are up to 15: so many roundings of 1 are lost.
        let rest = 1.0 - smooth_step(1.0 - near);
        assert!(rest < 2e-8 + 15.0 * f32::EPSILON, "third order at the end: {rest}");
    }

    #[test]
    fn the_demonstration_starts_level_and_ends_tilted() {
        let profile = Profile::demonstration(0.12);
        assert_eq!(profile.at(0.0), Pose { zc: 0.12, tx: 0.0, ty: 0.0 });
        let end = profile.at(10.0);
        assert!((end.zc - 0.15).abs() < ROUNDING);
        let slope = end.tx * end.tx + end.ty * end.ty;
        assert!((slope - 0.01).abs() < ROUNDING);
    }
}
