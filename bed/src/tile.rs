//! Kinematics of a tile's platform: closed forms for its star on three screws.
//!
//! In: heave and slopes, or heights of the screws. Out: the pose of the platform, and the other of the two. The screws
//! stand at 120 deg on a circle of radius b; a connector on each slides along an arm of the star, so that the star's
//! centre is the Fermat point of the three. With slopes (tx, ty), T2 = tx^2 + ty^2, q = sqrt(1 + T2), C = tx^3 - 3 tx
//! ty^2: h_i = z - b (tx cos_i + ty sin_i), normal (tx, ty, 1)/q, no torsion (3-PSP; Di Gregorio and Parenti-Castelli
//! 1999).

use crate::pose::Pose;
use smartbed_runtime::rigid::attitude::Attitude;

/// A commanded pose of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Command {
    /// Mean height of the screws (m).
    pub heave: f64,
    /// Slopes: the normal leans towards +x and +y by tan(angle), in the bed's axes.
    pub slope: [f64; 2],
}

impl Command {
    /// Tilt (rad).
    #[must_use]
    pub fn tilt(&self) -> f64 {
        self.slope[0].hypot(self.slope[1]).atan()
    }
}

/// Converts to the star's axes: its first arm lies along the bed's y axis, so that x_star = y and y_star = -x.
fn to_star([x, y]: [f64; 2]) -> [f64; 2] {
    [y, -x]
}

fn to_bed([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

/// cos and sin of the screws' azimuths in the star's axes.
fn azimuths() -> [[f64; 2]; 3] {
    let half_root3 = 0.75_f64.sqrt();
    [[1.0, 0.0], [-0.5, half_root3], [-0.5, -half_root3]]
}

/// Heights of the screws (m) on a circle of radius b (m).
#[must_use]
pub fn heights(command: &Command, b: f64) -> [f64; 3] {
    let [tx, ty] = to_star(command.slope);
    azimuths().map(|[cos, sin]| command.heave - b * (tx * cos + ty * sin))
}

/// The command with these heights; the inverse of [`heights`].
#[must_use]
pub fn command(heights: [f64; 3], b: f64) -> Command {
    let mut slope = [0.0; 2];
    for (height, azimuth) in heights.into_iter().zip(azimuths()) {
        slope[0] -= 2.0 / (3.0 * b) * height * azimuth[0];
        slope[1] -= 2.0 / (3.0 * b) * height * azimuth[1];
    }
    Command { heave: heights.iter().sum::<f64>() / 3.0, slope: to_bed(slope) }
}

/// Pose of the star's centre, relative to the centre of the circle.
#[must_use]
pub fn pose(command: &Command, b: f64) -> Pose {
    let [tx, ty] = to_star(command.slope);
    let square = tx * tx + ty * ty;
    let q = (1.0 + square).sqrt();
    let cubic = tx * tx * tx - 3.0 * tx * ty * ty;
    let shared = cubic / (q * (q + 1.0) * (q + 1.0));
    let side = [
        0.5 * b * (-(tx * tx - ty * ty) / (q + 1.0) + tx * shared),
        0.5 * b * (2.0 * tx * ty / (q + 1.0) + ty * shared),
    ];
    let [x, y] = to_bed(side);
    Pose { place: [x, y, command.heave + 0.5 * b * cubic / (q * (q + 1.0))], attitude: lean(command.slope) }
}

/// The attitude without torsion whose normal is (tx, ty, 1)/q: a rotation about (-ty, tx).
fn lean([tx, ty]: [f64; 2]) -> Attitude<f64> {
    let q = (1.0 + tx * tx + ty * ty).sqrt();
    // Quaternion of the rotation, (1 + n_z, -n_y, n_x, 0), before normalisation.
    Attitude::new([1.0 + 1.0 / q, -ty / q, tx / q, 0.0])
}

/// Lateral displacement (m) of a point at a distance above the platform, which would drag the skin along.
#[must_use]
pub fn drag(command: &Command, b: f64, above: f64) -> [f64; 2] {
    let [x, y, _] = pose(command, b).outwards([0.0, 0.0, above]);
    [x, y]
}
