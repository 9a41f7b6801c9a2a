//! Inverse dynamics of the tile: forces of the screws along a motion, derived from `models/tile_minimal.toml`.
//!
//! In: wanted motion of each leg, the patient's mass. Out: the force of each screw on its load. The patient is a point
//! mass above the middle: its position is not known, and the servo's integral corrects the difference. A drive's own
//! inertia is not included: it needs no force of the screw, see `servo`.

use super::profile::Along;

#[allow(clippy::all, reason = "generated, for scalars that may lack assignment operators")]
pub mod equations {
    //! The tile's equations in three heights, derived by the build script.
    include!(concat!(env!("OUT_DIR"), "/feedforward.rs"));
}

use equations::{Parameters, inverse_dynamics, prepare};

/// Forces of the screws (N) for this motion of the legs under a patient of this mass (kg).
#[must_use]
#[inline(never)]
pub fn loads(wanted: &[Along; 3], patient: f32) -> [f32; 3] {
    let prepared = prepare(&Parameters { m_payload: patient, ..Parameters::default() });
    let heights = wanted.map(|leg| leg.position);
    let (speeds, accelerations) = (wanted.map(|leg| leg.speed), wanted.map(|leg| leg.acceleration));
    inverse_dynamics(0.0, &heights, &speeds, &[0.0; 3], &accelerations, &prepared).inputs
}

#[cfg(all(test, feature = "plant"))]
mod tests {
    use super::loads;
    use crate::plant::double;
    use crate::tile::design::{GRAVITY, OWN_WEIGHT};
    use crate::tile::profile::Along;
    use smartbed_runtime::mechanism::Mechanism;

    #[test]
    fn a_level_tile_is_carried_by_thirds() {
        for patient in [0.0, 25.0] {
            let expected = (OWN_WEIGHT + patient * GRAVITY) / 3.0;
            for load in loads(&[Along::default(); 3], patient) {
                assert!((load - expected).abs() < 1e-3, "{load} {expected}");
            }
        }
    }

    /// The plant's equations, derived from the model in twelve coordinates, accelerate under these forces as was asked.
    #[test]
    fn the_plant_accelerates_as_asked_under_these_forces() {
        let cases = [
            ([0.02, -0.01, 0.005], [1e-3, -2e-3, 3e-3], [0.1, 0.0, -0.2]),
            ([-0.024, 0.012, 0.012], [0.0; 3], [0.0; 3]),
            ([0.0, 0.02, -0.02], [0.02, 0.05, -0.03], [1.0, -2.0, 0.5]),
        ];
        for (position, speed, acceleration) in cases {
            let leg = |leg: usize| Along {
                position: position[leg],
                speed: speed[leg],
                acceleration: acceleration[leg],
            };
            let forces = loads(&core::array::from_fn(leg), 25.0);
            let parameters = double::Parameters { mr: 0.0, m_payload: 25.0, ..double::Parameters::default() };
            let mut tile = double::Tile::new(parameters);
            let mut q = double::NOMINAL;
            for share in 1..=20 {
                for (name, height) in ["hA", "hB", "hC"].into_iter().zip(position) {
                    let place = double::Q_NAMES.iter().position(|n| *n == name).expect("a height");
                    q[place] = f64::from(height) * f64::from(share) / 20.0;
                }
                for _ in 0..4 {
                    tile.project(&mut q).expect("a pose");
                }
            }
            let (mut q_dot, mut u_dot) = ([0.0; double::NQ], [0.0; double::NU]);
            let u = speed.map(f64::from);
            tile.rates(0.0, &q, &u, &forces.map(f64::from), &mut q_dot, &mut u_dot).expect("regular");
            for (found, asked) in u_dot.iter().zip(acceleration) {
                // Single precision of forces of 100 N on some kilograms.
                assert!((found - f64::from(asked)).abs() < 2e-4, "{u_dot:?} {acceleration:?}");
            }
        }
    }
}
