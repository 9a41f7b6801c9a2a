//! The closed forms used by other tests, against published values and against each other.

use nalgebra::Vector3;
use smartbed_tests::closed_form::{fourbar, pendulum, tile};
use smartbed_tests::loop_equations;
use smartbed_tests::random::Random;

/// Golden numbers are printed with 12 digits.
const PRINTED: f64 = 1e-12;
/// A few dozen rounded operations on numbers below 1.
const ROUNDING: f64 = 1e-15;

/// Heights, tilt [deg], azimuth of the tilt [deg], centre and slides of one golden row.
type Golden = ([f64; 3], f64, f64, [f64; 3], [f64; 3]);

/// Postures on a circle of 0.1 m, found by two constructions; screw A on the x axis.
const GOLDEN: [Golden; 5] = [
    (
        [0.02, 0.0, 0.0],
        7.59464336859,
        180.0,
        [-4.38604965868e-4, 0.0, 6.60818600455e-3],
        [0.101327459504, 0.1, 0.1],
    ),
    (
        [0.03, 0.01, -0.01],
        13.0039119428,
        -150.0,
        [-6.58007197234e-4, 1.13970189736e-3, 0.01],
        [0.102632028789, 0.0986839856055, 0.102632028789],
    ),
    (
        [0.0, 0.02, -0.02],
        13.0039119428,
        -90.0,
        [1.31601439447e-3, 0.0, 0.0],
        [0.0986839856055, 0.102632028789, 0.102632028789],
    ),
    (
        [0.05, 0.02, 0.035],
        9.82642981583,
        150.0,
        [-3.72228912731e-4, -6.44719388895e-4, 0.035],
        [0.101488915651, 0.101488915651, 0.0992555421745],
    ),
    (
        [-0.04, 0.02, 0.02],
        21.8014094864,
        0.0,
        [-3.57616545574e-3, 0.0, 1.43046618229e-3],
        [0.111554944214, 0.1, 0.1],
    ),
];

#[test]
fn tile_postures_equal_the_golden_rows() {
    for (h, tilt, azimuth, centre, s) in GOLDEN {
        let posture = tile::posture(0.1, h);
        assert!((posture.tilt().to_degrees() - tilt).abs() < 1e-10, "{h:?}");
        // Golden axes to the bed's axes: x is -y, y is x.
        let expected = Vector3::new(-centre[1], centre[0], centre[2]);
        assert!((posture.centre - expected).norm() < PRINTED, "{h:?}: {}", posture.centre);
        let slides = posture.s.iter().zip(s).all(|(found, slide)| (found - slide).abs() < PRINTED);
        assert!(slides, "{h:?}: {:?}", posture.s);
        let found = posture.slope[1].atan2(posture.slope[0]).to_degrees() - 90.0;
        let turns = (found - azimuth) / 360.0;
        assert!((turns - turns.round()).abs() < 1e-12, "{h:?}: azimuth {found}");
    }
}

#[test]
fn platform_centre_is_the_fermat_point() {
    let mut random = Random::new(1);
    for _ in 0..1000 {
        let (h, _) = tile::random_heights(&mut random, 0.2, 0.12);
        let posture = tile::posture(0.2, h);
        let (centre, s) = tile::fermat_point(tile::connectors(0.2, h));
        assert!((posture.centre - centre).norm() < ROUNDING, "{h:?}");
        assert!((0..3).all(|leg| (posture.s[leg] - s[leg]).abs() < ROUNDING), "{h:?}");
    }
}

#[test]
fn closed_form_coordinates_satisfy_the_loop_equations() {
    let mut random = Random::new(2);
    for _ in 0..1000 {
        let (h, _) = tile::random_heights(&mut random, 0.2, 0.12);
        let q = tile::posture(0.2, h).coordinates(0.2, h);
        assert!(loop_equations::largest_residual(0.2, &q) < ROUNDING, "{h:?}");
    }
}

#[test]
fn loop_equations_notice_every_coordinate() {
    let h = [0.1, 0.13, 0.16];
    let q = tile::posture(0.2, h).coordinates(0.2, h);
    for k in 0..12 {
        let mut moved = q;
        moved[k] += 1e-3;
        assert!(loop_equations::largest_residual(0.2, &moved) > 1e-4, "coordinate {k}");
    }
    assert_eq!(loop_equations::largest_residual(0.2, &[f64::NAN; 12]), f64::INFINITY);
}

#[test]
fn heights_are_linear_in_heave_and_slopes() {
    let h = [0.07, 0.19, 0.11];
    let posture = tile::posture(0.2, h);
    for (leg, [c, s]) in tile::AZIMUTHS.into_iter().enumerate() {
        let back = posture.heave - 0.2 * (posture.slope[0] * c + posture.slope[1] * s);
        assert!((back - h[leg]).abs() < ROUNDING);
    }
    let normal = posture.rotation.column(2);
    let [a, b, c] = tile::connectors(0.2, h);
    assert!((b - a).dot(&normal).abs() < ROUNDING && (c - a).dot(&normal).abs() < ROUNDING);
}

#[test]
fn fourbar_assembles_on_both_sides() {
    let lengths = [1.0, 2.2, 1.8, 2.0];
    for q1 in [-2.0, -0.3, 0.4, 1.1, 2.9] {
        for side in [-1.0, 1.0] {
            let [q2, q3] = fourbar::assemble(lengths, q1, side).expect("a crank-rocker reaches everywhere");
            assert!(fourbar::residual(lengths, [q1, q2, q3]) < ROUNDING);
            assert!(0.0 < side * (q3 - q2).sin());
        }
    }
    assert_eq!(fourbar::assemble([1.0, 0.2, 0.3, 2.0], 0.5, 1.0), None);
}

#[test]
fn pendulum_energy_of_one_mass() {
    let (kinetic, potential) = pendulum::energy(&[2.0], &[0.5], 10.0, &[std::f64::consts::PI], &[3.0]);
    assert!((kinetic - 2.25).abs() < ROUNDING);
    assert!((potential - 10.0).abs() < 10.0 * ROUNDING);
}
