//! Power balance of every mechanism: power of the inputs = rate of the energy + power of friction.

use smartbed_tests::cases::{self, Case, MECHANISMS};
use smartbed_tests::subject::{self, Built, ENGINES, Subject};

/// Central difference of the energy along the motion: rounding 1e-16/1e-5 and truncation 1e-10,
/// times energies of up to 100 J and rates of up to 1000 W.
const DIFFERENCING: f64 = 1e-8;
/// Time step of the difference (s).
const DELTA: f64 = 1e-5;

/// Energy at a time `dt` along the tangent of the motion.
fn energy_after(subject: &mut dyn Subject<f64>, case: &Case, rates: &subject::Rates, dt: f64) -> f64 {
    let mut state = case.state.clone();
    for ((_, q), rate) in state.q.iter_mut().zip(&rates.q_dot) {
        *q += dt * rate;
    }
    for ((_, u), rate) in state.u.iter_mut().zip(&rates.u_dot) {
        *u += dt * rate;
    }
    let [kinetic, potential] = subject::evaluate(subject, &state).energy;
    kinetic + potential
}

/// Power of the inputs minus friction (W). Every input acts on the speed of the same index.
fn power(model: &str, case: &Case) -> f64 {
    let u: Vec<f64> = case.state.u.iter().map(|(_, u)| *u).collect();
    let inputs: f64 = case.state.inputs.iter().zip(&u).map(|((_, f), u)| f * u).sum();
    let viscous = case.parameters.iter().find(|(name, _)| name == "c").map_or(0.0, |(_, c)| *c);
    match model {
        "tile" | "tile_minimal" => inputs - viscous * u.iter().map(|u| u * u).sum::<f64>(),
        _ => inputs,
    }
}

#[test]
fn power_of_the_inputs_changes_the_energy() {
    for model in MECHANISMS {
        for engine in ENGINES {
            let mut subject = f64::subject(engine, model);
            for case in cases::random_cases(model, 50, 9) {
                for (name, value) in &case.parameters {
                    subject.set_parameter(name, *value);
                }
                let rates = subject::evaluate(subject.as_mut(), &case.state);
                let after = energy_after(subject.as_mut(), &case, &rates, DELTA);
                let before = energy_after(subject.as_mut(), &case, &rates, -DELTA);
                let gain = (after - before) / (2.0 * DELTA);
                let power = power(model, &case);
                let scale = rates.energy[0].abs() + rates.energy[1].abs() + power.abs() + 1.0;
                assert!((gain - power).abs() < DIFFERENCING * scale, "{model}: {gain} W for {power} W");
            }
        }
    }
}
