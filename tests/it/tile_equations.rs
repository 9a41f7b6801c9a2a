//! The tile with twelve coordinates against the minimal tile, and mechanical laws that both must satisfy.

use nalgebra::{Matrix3, Vector3};
use smartbed_codegen::Effort;
use smartbed_tests::cases;
use smartbed_tests::closed_form::tile;
use smartbed_tests::interpreted::{InterpretedSubject, program_with};
use smartbed_tests::random::Random;
use smartbed_tests::reference::data;
use smartbed_tests::subject::{self, Built, ENGINES, Engine, Rates, State, Subject};
use smartbed_tests::tolerance::{largest, relative_error};

/// Radius of the reference's tile (m).
const R: f64 = 0.2;
/// Middle of the stroke (m).
const NOMINAL: f64 = 0.0;
/// Number of random states at which the two tiles are compared.
const STATES: usize = 10_000;
/// Tolerance between two derivations of one mechanism at random states.
const DERIVATIONS: f64 = 1e-11;
/// The same where only roundings differ, at a thousand of them.
const ROUNDINGS: f64 = 1e-14;
/// The same at states that hide no cancellation.
const SPECIAL: f64 = 1e-13;

/// A tile with the reference's parameters.
fn subject(model: &str, engine: Engine) -> Box<dyn Subject<f64>> {
    let mut subject = f64::subject(engine, model);
    for (name, value) in data::minimal().parameters {
        subject.set_parameter(&name, value);
    }
    subject
}

/// The state of either tile.
fn state(model: &str, h: [f64; 3], h_dot: [f64; 3], thrust: [f64; 3]) -> State {
    match model {
        "tile" => cases::tile_state(R, h, h_dot, thrust),
        _ => cases::heights_state(h, h_dot, thrust),
    }
}

/// Accelerations of the heights.
fn accelerations(tile: &mut dyn Subject<f64>, model: &str, motion: [[f64; 3]; 3]) -> [f64; 3] {
    let rates: Rates = subject::evaluate(tile, &state(model, motion[0], motion[1], motion[2]));
    rates.u_dot.try_into().expect("three heights")
}

/// Random motions within reach: heights, their rates, thrusts.
fn random_motions(n: usize) -> Vec<[[f64; 3]; 3]> {
    let mut random = Random::new(5);
    let mut motion = || {
        let (h, h_dot) = tile::random_heights(&mut random, R, NOMINAL);
        [h, h_dot, [(); 3].map(|()| random.between(-30.0, 80.0))]
    };
    (0..n).map(|_| motion()).collect()
}

/// Largest relative difference of the two tiles' accelerations over given motions.
fn difference(engine: Engine, motions: &[[[f64; 3]; 3]]) -> f64 {
    let mut full = subject("tile", engine);
    let mut minimal = subject("tile_minimal", engine);
    let mut worst: f64 = 0.0;
    for &motion in motions {
        let a = accelerations(full.as_mut(), "tile", motion);
        let b = accelerations(minimal.as_mut(), "tile_minimal", motion);
        worst = worst.max(relative_error(&a, &b));
    }
    worst
}

#[test]
fn tile_and_minimal_tile_agree_at_random_states() {
    let worst = difference(Engine::Compiled, &random_motions(STATES));
    println!("tile against tile_minimal at {STATES} states: {worst:.1e}");
    assert!(worst <= DERIVATIONS, "{worst:e}");
}

/// Neither the shorter equations nor the search for fewer operations may cost accuracy.
#[test]
fn minimal_tile_of_every_effort_is_the_tile_as_derived() {
    let interpreted = |model: &str, effort| {
        let mut subject = InterpretedSubject::<f64>::of(&program_with(model, &[], effort));
        data::minimal().parameters.into_iter().for_each(|(name, value)| subject.set_parameter(&name, value));
        subject
    };
    let mut full = interpreted("tile", Effort::None);
    for effort in [Effort::None, Effort::Default, Effort::All] {
        let mut minimal = interpreted("tile_minimal", effort);
        let errors = random_motions(1000).into_iter().map(|motion| {
            let expected = accelerations(&mut full, "tile", motion);
            relative_error(&accelerations(&mut minimal, "tile_minimal", motion), &expected)
        });
        let worst = errors.fold(0.0, f64::max);
        println!("tile_minimal, {effort:?}, against the tile: {worst:.1e}");
        assert!(worst <= ROUNDINGS, "{effort:?}: {worst:e}");
    }
}

#[test]
fn tile_and_minimal_tile_agree_where_symmetry_could_divide_by_zero() {
    let thrust = [31.0, 27.0, 44.0];
    let still = [0.0; 3];
    let moving = [0.3, -0.2, 0.1];
    let postures = [
        [0.0; 3],             // level
        [0.12; 3],            // raised level
        [-0.1; 3],            // lowered level
        [0.05, -0.01, -0.01], // two legs equal
        [-0.01, 0.05, 0.05],  // the same, tilted the other way
        [0.12, -0.12, -0.12], // steep
        [-0.12, 0.12, 0.12],  // steep, the other way
        [0.12, 0.0, -0.12],   // steep about an oblique axis
        [1e-9, 0.0, 0.0],     // almost level
        [0.0, 1e-6, 0.0],     // the same, another leg
    ];
    for engine in ENGINES {
        let motions: Vec<_> =
            postures.iter().flat_map(|&h| [[h, still, thrust], [h, moving, thrust]]).collect();
        let worst = difference(engine, &motions);
        println!("special postures, {engine:?}: {worst:.1e}");
        assert!(worst <= SPECIAL, "{engine:?}: {worst:e}");
    }
}

/// Inverse mass matrix and the accelerations without thrust: u_dot is affine in the thrusts.
fn inverse_mass(tile: &mut dyn Subject<f64>, model: &str, h: [f64; 3]) -> (Matrix3<f64>, Vector3<f64>) {
    let still = [0.0; 3];
    let free = Vector3::from(accelerations(tile, model, [h, still, still]));
    let columns = [0, 1, 2].map(|leg| {
        let mut thrust = [0.0; 3];
        thrust[leg] = 1.0;
        Vector3::from(accelerations(tile, model, [h, still, thrust])) - free
    });
    (Matrix3::from_columns(&columns), free)
}

/// Rounding of differences of accelerations up to about 10 m/s^2.
const DIFFERENCES: f64 = 1e-12;

#[test]
fn mass_matrix_is_symmetric_and_positive_definite() {
    let mut random = Random::new(6);
    for model in ["tile", "tile_minimal"] {
        let mut tile = subject(model, Engine::Compiled);
        for _ in 0..100 {
            let (h, _) = tile::random_heights(&mut random, R, NOMINAL);
            let (inverse, _) = inverse_mass(tile.as_mut(), model, h);
            let skew = (inverse - inverse.transpose()).abs().max();
            assert!(skew < DIFFERENCES, "{model} {h:?}: {skew:e}");
            assert!(inverse.cholesky().is_some(), "{model} {h:?}: {inverse}");
        }
    }
}

#[test]
fn accelerations_are_affine_in_the_thrusts() {
    let h = [0.1, 0.15, 0.13];
    for model in ["tile", "tile_minimal"] {
        let mut tile = subject(model, Engine::Compiled);
        let (inverse, free) = inverse_mass(tile.as_mut(), model, h);
        let thrust = [55.0, -20.0, 13.0];
        let found = Vector3::from(accelerations(tile.as_mut(), model, [h, [0.0; 3], thrust]));
        let expected = free + inverse * Vector3::from(thrust);
        assert!((found - expected).norm() < 1e3 * DIFFERENCES * 0.1, "{model}: {found} against {expected}");
    }
}

#[test]
fn static_thrusts_sum_to_the_weight() {
    let mut random = Random::new(7);
    let parameters: Vec<f64> = data::minimal().parameters.iter().map(|(_, value)| *value).collect();
    let weight = smartbed_tests::newton_euler::tile::Parameters::new(&parameters).weight();
    for model in ["tile", "tile_minimal"] {
        let mut tile = subject(model, Engine::Compiled);
        for _ in 0..20 {
            let (h, _) = tile::random_heights(&mut random, R, NOMINAL);
            let (inverse, free) = inverse_mass(tile.as_mut(), model, h);
            let thrust = -(inverse.try_inverse().expect("a regular mass matrix") * free);
            let moved = accelerations(tile.as_mut(), model, [h, [0.0; 3], thrust.into()]);
            assert!(largest(&moved) < 10.0 * DIFFERENCES, "{model}: {moved:?}");
            assert!((thrust.sum() - weight).abs() < 1e-10, "{model}: {} N of {weight} N", thrust.sum());
        }
    }
}

#[test]
fn level_tile_has_the_mass_matrix_of_a_slab() {
    // M_ij = m/9 + 4 I/(9 R^2) cos(azimuth_i - azimuth_j) + d_ij (ms + mr + mc), connectors without inertia.
    let (m, i, lumped) = (6.0, 0.09, 0.8 + 2.0 + 0.15);
    for model in ["tile", "tile_minimal"] {
        let mut tile = subject(model, Engine::Compiled);
        for name in ["Ic1", "Ic2", "Ic3"] {
            tile.set_parameter(name, 0.0);
        }
        let (inverse, _) = inverse_mass(tile.as_mut(), model, [NOMINAL; 3]);
        let turning = 4.0 * i / (9.0 * R * R);
        let expected =
            Matrix3::from_fn(|a, b| m / 9.0 + if a == b { turning + lumped } else { -0.5 * turning });
        let unit = inverse * expected;
        assert!((unit - Matrix3::identity()).abs().max() < 10.0 * DIFFERENCES, "{model}: {unit}");
    }
}

#[test]
fn relabelling_the_legs_relabels_the_motion() {
    let mut random = Random::new(8);
    let shift = |x: [f64; 3]| [x[2], x[0], x[1]];
    for model in ["tile", "tile_minimal"] {
        let mut tile = subject(model, Engine::Compiled);
        for _ in 0..100 {
            let (h, h_dot) = tile::random_heights(&mut random, R, NOMINAL);
            let thrust = [(); 3].map(|()| random.between(-30.0, 80.0));
            let here = accelerations(tile.as_mut(), model, [h, h_dot, thrust]);
            let there = accelerations(tile.as_mut(), model, [shift(h), shift(h_dot), shift(thrust)]);
            let error = relative_error(&there, &shift(here));
            assert!(error < DIFFERENCES, "{model}: {error:e}");
        }
    }
}
