//! `Parameters::check` of derived code reports the first parameter that is not a finite number within its range.

use smartbed_tests::generated::{pendulum3_f32, pendulum3_f64};

#[test]
fn parameters_outside_their_range_are_named() {
    let good = pendulum3_f64::Parameters::default();
    assert_eq!(good.check(), Ok(()));
    let cases = [
        (
            pendulum3_f64::Parameters { m1: -0.5, ..good },
            "parameter `m1` is -0.5; expected a finite number from 0 to inf",
        ),
        (
            pendulum3_f64::Parameters { l0: f64::NAN, ..good },
            "parameter `l0` is NaN; expected a finite number from -inf to inf",
        ),
        (
            pendulum3_f64::Parameters { g: f64::INFINITY, ..good },
            "parameter `g` is inf; expected a finite number from -inf to inf",
        ),
        (
            pendulum3_f64::Parameters { m0: f64::INFINITY, ..good },
            "parameter `m0` is inf; expected a finite number from 0 to inf",
        ),
    ];
    for (parameters, message) in cases {
        let refused: Box<dyn std::error::Error> = Box::new(parameters.check().expect_err(message));
        assert_eq!(refused.to_string(), message);
    }
    // A mass may be 0; f32 has the same ranges.
    assert_eq!(pendulum3_f64::Parameters { m1: 0.0, ..good }.check(), Ok(()));
    let refused = pendulum3_f32::Parameters { m2: -1.0, ..Default::default() }.check().expect_err("negative");
    assert_eq!((refused.name, refused.value, refused.range), ("m2", -1.0, [0.0, f32::INFINITY]));
}
