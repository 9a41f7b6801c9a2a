//! Derived code refuses a parameter with which its constraints can no longer be met.

use smartbed_runtime::mechanism::Mechanism;
use smartbed_tests::generated::{parallelogram_f32, parallelogram_f64};

macro_rules! refuses_a_crank_of_another_length {
    ($module:ident, $scalar:ty) => {{
        let place =
            |name: &str| $module::PARAMETER_NAMES.iter().position(|known| *known == name).expect(name);
        let mut bar = $module::Parallelogram::default();
        assert!(!bar.set_parameter(place("a3"), 0.31), "the third crank does not reach the bar");
        assert_eq!(bar.parameters().a3, 0.3 as $scalar, "all is as it was");
        assert!(bar.set_parameter(place("a3"), 0.3));
        // Mass and gravity have no part in the constraints.
        assert!(bar.set_parameter(place("m"), 7.0) && bar.set_parameter(place("g"), 1.6));
        assert!(!bar.set_parameter(usize::MAX, 1.0));
        // All three together are a parallelogram again.
        let mut parameters = *bar.parameters();
        (parameters.a, parameters.a3) = (0.25, 0.25);
        bar.set_parameters(parameters);
        assert!(bar.can_be_assembled());
        // If it is set nevertheless, the residual shows it at every step.
        parameters.a3 = 0.26;
        bar.set_parameters(parameters);
        assert!(!bar.can_be_assembled());
        let mut q = $module::NOMINAL;
        let residual = bar.project(&mut q).expect("lengths fit");
        assert!(residual > 5e-3, "{residual}");
    }};
}

#[test]
fn a_parameter_that_locks_the_mechanism_is_refused() {
    refuses_a_crank_of_another_length!(parallelogram_f64, f64);
    refuses_a_crank_of_another_length!(parallelogram_f32, f32);
}
