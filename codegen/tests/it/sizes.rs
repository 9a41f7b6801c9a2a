//! A mechanism whose lengths and masses are all scaled moves as before, in any scalar; with powers of two as factors
//! results are equal to the bit, since only exponents change.
//!
//! Oracle: similarity. Every quantity of the model in kg^a m^b is multiplied by mu^a lambda^b, time stays as it is.

use crate::models::shipped;
use smartbed_codegen::model::unit::{self, Unit};
use smartbed_codegen::program::Quantity;
use smartbed_codegen::{Interpreted, ParameterChoice, Program, model, program};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::ode::{Driven, Report, State, rk4};
use smartbed_runtime::real::Scalar;

/// Mechanisms whose lengths and masses are parameters.
const SHIPPED: [&str; 17] = [
    "arm6",
    "bicycle",
    "cart_pole",
    "double_pendulum",
    "driven_pendulum",
    "fourbar",
    "free_body",
    "gyroscope",
    "parallelogram",
    "pendulum10",
    "pendulum3",
    "rolling_disc",
    "sleigh",
    "slider_crank",
    "slider_crank_closed",
    "tile",
    "tile_minimal",
];
/// Powers of two: of masses, of lengths; a millionth to a million, a thousandth to a thousand.
const FACTORS: [[i32; 2]; 5] = [[-20, -10], [20, 10], [-20, 10], [13, 0], [0, -10]];
const STEPS: usize = 20;

/// Factor of a quantity.
fn factor(quantity: &Quantity, [mass, length]: [i32; 2]) -> f64 {
    let unit = unit::parse(quantity.unit.trim()).expect("a unit").unit;
    let powers = (-4..=4).flat_map(|a| (-4..=4).flat_map(move |b| (-4..=4).map(move |c| [a, b, c])));
    let product = |[a, b, c]: [i32; 3]| {
        Unit::MASS.power(a, 1)?.times(Unit::LENGTH.power(b, 1)?)?.times(Unit::TIME.power(c, 1)?)
    };
    let [a, b, _] = powers.into_iter().find(|&p| product(p) == Some(unit)).expect("whole powers");
    f64::from(mass * a + length * b).exp2()
}

fn scaled(quantities: &[Quantity], values: &[f64], by: [i32; 2]) -> Vec<f64> {
    quantities.iter().zip(values).map(|(quantity, x)| x * factor(quantity, by)).collect()
}

/// Twenty steps of Kutta's method from the nominal configuration, and the report of each.
fn moved<S: Scalar>(program: &Program, by: [i32; 2]) -> (Vec<f64>, Vec<Report<S>>) {
    let defaults: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let speeds: Vec<f64> = (0..program.u.len()).map(|i| 0.3 - 0.07 * i as f64).collect();
    let q = scaled(&program.q, &program.nominal, by);
    let u = scaled(&program.u, &speeds, by);
    let round = |values: &[f64]| -> Vec<S> { values.iter().map(|&x| S::from_f64(x)).collect() };
    let mut mechanism = Interpreted::<S>::new(program);
    mechanism.set_parameters(&round(&scaled(&program.parameters, &defaults, by)));
    let (q, mut u) = (round(&q), round(&u));
    mechanism.project_speeds(&q, &mut u).expect("lengths fit");
    let mut x = [q, u].concat();
    let (mut low, mut scratch) = (vec![S::ZERO; x.len()], vec![S::ZERO; 8 * x.len()]);
    let mut inputs = vec![S::ZERO; program.inputs.len()];
    let law = |_: S, _: &[S], _: &[S], inputs: &mut [S]| inputs.fill(S::ZERO);
    let mut driven = Driven::new(mechanism, law, &mut inputs).expect("inputs");
    let mut state = State::new(&mut x, &mut low).expect("one length");
    let h = S::from_f64(0.0009765625);
    let mut reports = Vec::new();
    for step in 0..STEPS {
        let t = S::from_f64(step as f64) * h;
        let report = rk4(&mut driven, t, h, &mut state, &mut scratch);
        reports
            .push(report.unwrap_or_else(|fault| panic!("{} by {by:?}, step {step}: {fault}", program.name)));
    }
    let back = by.map(|power| -power);
    let x: Vec<f64> = state.x().iter().map(|x| x.to_f64()).collect();
    let (q, u) = x.split_at(program.q.len());
    ([scaled(&program.q, q, back), scaled(&program.u, u, back)].concat(), reports)
}

/// Largest difference from the motion at the default parameters, and of worst pivots relative to theirs.
fn off<S: Scalar>(program: &Program) -> f64 {
    let (nominal, reports) = moved::<S>(program, [0, 0]);
    let mut worst = 0.0_f64;
    for by in FACTORS {
        let (found, scaled) = moved::<S>(program, by);
        let states = nominal.iter().zip(&found).map(|(x, y)| (x - y).abs());
        let pivots =
            reports.iter().zip(&scaled).map(|(a, b)| (b.pivot.to_f64() / a.pivot.to_f64() - 1.0).abs());
        worst = states.chain(pivots).fold(worst, |worst, x| if x.is_nan() { x } else { worst.max(x) });
    }
    worst
}

#[test]
fn mechanisms_of_any_size_move_alike_to_the_bit() {
    for name in SHIPPED {
        let program =
            program::derive(&shipped(name), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!([off::<f64>(&program), off::<f32>(&program)], [0.0; 2], "{name}");
    }
}

/// Equal only to rounding, because the correction of coordinates minimises a norm that mixes rad and m.
#[test]
fn mechanisms_with_dead_points_of_any_size_move_alike() {
    let text = crate::dead_points::slider_crank();
    let model = model::parse("test.toml", &text).unwrap_or_else(|e| panic!("{e}"));
    let program = program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
    assert!(program.is_redundant());
    let (double, single) = (off::<f64>(&program), off::<f32>(&program));
    assert!(double < 1e-11 && single < 1e-4, "{double:e} {single:e}");
}
