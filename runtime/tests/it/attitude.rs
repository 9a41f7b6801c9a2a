//! Attitudes from Euler parameters of any length.

use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::attitude::Attitude;

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
