//! Impact of rigid bodies: work and impulse against the change of kinetic energy, Eq. 4.4, the ball, the rod.

use smartbed_runtime::contact::rigid::{RigidBody, WorkImpulse};

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const INERTIA: [f64; 3] = [0.3, 0.5, 0.7];

fn box_body() -> RigidBody<f64> {
    RigidBody {
        mass: 2.0,
        inverse_inertia: [[1.0 / 0.3, 0.0, 0.0], [0.0, 1.0 / 0.5, 0.0], [0.0, 0.0, 1.0 / 0.7]],
        velocity: [0.4, -0.2, -3.0],
        spin: [1.0, -2.0, 0.5],
    }
}

fn kinetic(body: &RigidBody<f64>) -> f64 {
    let turning: f64 = (0..3).map(|c| INERTIA[c] * body.spin[c].powi(2)).sum();
    0.5 * body.mass * dot(body.velocity, body.velocity) + 0.5 * turning
}

/// Sums of a few terms of 10 J.
const ROUNDING: f64 = 1e-13;

#[test]
fn net_work_is_the_change_of_kinetic_energy_and_stronges_share_of_the_compression() {
    let r = [0.3, -0.2, -0.4];
    for e in [0.0, 0.3, 0.8, 1.0] {
        let mut body = box_body();
        let before = kinetic(&body);
        let impact = body.strike(r, UP, e);
        let net = kinetic(&body) - before;
        assert!(impact.approach < 0.0);
        // Eq. 4.2 against Eq. 4.25; Eq. 4.4.
        assert!((net - impact.work(impact.last)).abs() <= ROUNDING);
        assert!((net - (1.0 - e * e) * impact.work(impact.compression)).abs() <= ROUNDING);
        // Without friction the energetic coefficient is the kinematic one.
        let rate = dot(body.point_velocity(r), UP);
        assert!((rate + e * impact.approach).abs() <= ROUNDING);
        // Compression ends where the work has its minimum: v = 0.
        assert!(impact.rate(impact.compression).abs() <= ROUNDING);
    }
}

#[test]
fn work_is_the_integral_of_speed_over_impulse() {
    let impact = WorkImpulse::new(-2.0_f64, 1.5, 0.6);
    const PIECES: u32 = 1000;
    let dp = impact.last / f64::from(PIECES);
    // The middle rule is exact for a straight line v(P).
    let sum: f64 = (0..PIECES).map(|n| dp * impact.rate((f64::from(n) + 0.5) * dp)).sum();
    assert!((sum - impact.work(impact.last)).abs() <= ROUNDING);
    assert!((impact.last - 1.5 * (impact.rate(impact.last) + 2.0)).abs() <= ROUNDING, "P = M (v - v0)");
}

#[test]
fn a_rod_on_its_end_shows_a_quarter_of_its_mass_and_a_ball_all_of_it() {
    // Slender rod, J = m L^2/12 about the centre, struck at L/2: 1/M = 1/m + L^2/4 12/(m L^2) = 4/m.
    let inverse = 12.0 / 2.0;
    let rod = RigidBody {
        mass: 2.0,
        inverse_inertia: [[0.0; 3], [0.0, inverse, 0.0], [0.0, 0.0, inverse]],
        velocity: [0.0; 3],
        spin: [0.0; 3],
    };
    assert!((rod.effective_mass([0.5, 0.0, 0.0], UP) - 0.5).abs() <= ROUNDING);
    assert!((box_body().effective_mass([0.0, 0.0, -1.0], UP) - 2.0).abs() <= ROUNDING);
    let mut leaving = box_body();
    leaving.velocity = [0.0, 0.0, 3.0];
    leaving.spin = [0.0; 3];
    let before = leaving;
    assert_eq!(leaving.strike([0.0, 0.0, -1.0], UP, 1.0).last, 0.0);
    assert_eq!(leaving, before);
}
