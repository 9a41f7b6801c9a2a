//! Attitudes from Euler parameters of any length.

use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::motion::{TooFast, advance};
use smartbed_runtime::rigid::{RigidBody, RigidState};

#[test]
fn euler_parameters_of_any_length_are_scaled_to_1() {
    fn check<S: Scalar + PartialEq + std::fmt::Debug>(sizes: &[f64]) {
        for size in sizes {
            let turned = [0.0, *size, 0.0, 0.0].map(S::from_f64);
            assert_eq!(Attitude::new(turned).parameters(), [0.0, 1.0, 0.0, 0.0].map(S::from_f64), "{size:e}");
            let found = Attitude::new([-0.5, 0.5, 0.5, -0.5].map(|e| S::from_f64(e * size))).parameters();
            assert_eq!(found, [-0.5, 0.5, 0.5, -0.5].map(S::from_f64), "{size:e}");
        }
        assert_eq!(Attitude::new([S::ZERO; 4]), Attitude::identity());
    }
    check::<f32>(&[1e-44, 1e-30, 1e-18, 1.0, 1e18, 1e20, 3e38]);
    check::<f64>(&[1e-323, 1e-170, 1e-153, 1.0, 1e153, 1e170, 1e308]);
}

#[test]
fn what_is_not_a_number_stays_so() {
    for wrong in [f32::NAN, f32::INFINITY] {
        for place in 0..4 {
            let mut parameters = [0.0; 4];
            parameters[place] = wrong;
            let found = Attitude::new(parameters).parameters();
            assert!(found.iter().all(|e| e.is_nan()), "{wrong} at {place}: {found:?}");
        }
    }
}

/// A body that tumbles for a second, all inertia and momentum times a number.
fn tumbled<S: Scalar>(times: f64) -> Result<[f64; 4], TooFast> {
    let vector = |v: [f64; 3]| v.map(|x| S::from_f64(x) * S::from_f64(times));
    let body = RigidBody { mass: S::ONE, inertia: vector([0.5, 1.0, 1.25]) };
    let mut state =
        RigidState { angular_momentum: vector([1.0, 1.5, -0.5]), ..RigidState::at_rest([S::ZERO; 3]) };
    for _ in 0..10 {
        advance(&body, &mut state, [S::ZERO; 3], [S::ZERO; 3], S::from_f64(0.1))?;
    }
    Ok(state.attitude.parameters().map(S::to_f64))
}

#[test]
fn small_and_large_bodies_turn_as_those_between() {
    for k in [0, -20, -44, -80, -118, 20, 44, 80, 110] {
        assert_eq!(tumbled::<f32>(f64::from(k).exp2()), tumbled::<f32>(1.0), "2^{k}");
    }
    for k in [0, -44, -400, -1000, 44, 400, 1000] {
        assert_eq!(tumbled::<f64>(f64::from(k).exp2()), tumbled::<f64>(1.0), "2^{k}");
    }
    // A ball of water of 1 mm.
    assert!(tumbled::<f32>(5.2e-14).unwrap().iter().all(|e| e.is_finite()));
}

#[test]
fn a_state_that_would_not_be_finite_is_refused() {
    let body = RigidBody { mass: 2.0, inertia: [1.0; 3] };
    let rest = RigidState::at_rest([0.0; 3]);
    let gravity = [0.0, 0.0, -19.62];
    for (body, state, force, h) in [
        (RigidBody { mass: 0.0, ..body }, rest, gravity, 0.1),
        (RigidBody { mass: 1e-320, ..body }, rest, gravity, 0.1),
        (RigidBody { mass: f64::NAN, ..body }, rest, gravity, 0.1),
        (RigidBody { inertia: [f64::INFINITY; 3], ..body }, rest, gravity, 0.1),
        (body, rest, [f64::NAN; 3], 0.1),
        (body, RigidState::at_rest([f64::INFINITY, 0.0, 0.0]), gravity, 0.1),
        (body, RigidState { velocity: [1e308, 0.0, 0.0], ..rest }, gravity, 10.0),
    ] {
        let mut end = state;
        assert_eq!(advance(&body, &mut end, force, [0.0; 3], h), Err(TooFast), "{body:?} {state:?}");
        assert_eq!(end, state);
    }
}
