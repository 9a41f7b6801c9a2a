//! Generated equations against the stored references and the Newton-Euler oracle; engine against engine.

use smartbed_codegen::{Optimise, Settings};
use smartbed_tests::cases::{self, Case, MECHANISMS};
use smartbed_tests::generated;
use smartbed_tests::interpreted::{InterpretedSubject, program_with};
use smartbed_tests::reference::data;
use smartbed_tests::subject::{self, Built, ENGINES, Rates, Subject};
use smartbed_tests::tolerance::{largest, relative_error};

/// States that satisfy their loops to 1e-16 let formulations differ by 1e-13.
const REFERENCE_F64: f64 = 1e-12;
/// Coordinates rounded to f32 (6e-8) and some hundred operations.
const REFERENCE_F32: f64 = 2e-6;
/// The oracle's dense solve of 81 unknowns, at random states.
const ORACLE: f64 = 1e-12;
/// Outputs are angles below 1 rad and lengths below 1 m.
const OUTPUT: f64 = 1e-14;
/// States drawn for each mechanism.
const RANDOM_STATES: usize = 300;

/// Sets a case's parameters and evaluates it.
fn answer<S: Built>(subject: &mut dyn Subject<S>, case: &Case) -> Rates {
    for (name, value) in &case.parameters {
        subject.set_parameter(name, *value);
    }
    subject::evaluate(subject, &case.state)
}

/// The largest relative error of rates, accelerations and energies over all cases.
fn worst_error<S: Built>(subject: &mut dyn Subject<S>, cases: &[Case]) -> f64 {
    let mut worst: f64 = 0.0;
    for case in cases {
        let rates = answer(subject, case);
        worst = worst.max(relative_error(&rates.q_dot, &case.q_dot));
        worst = worst.max(relative_error(&rates.u_dot, &case.u_dot));
        if let Some(energy) = case.energy {
            let scale = largest(&energy);
            worst = worst.max((rates.energy[0] - energy[0]).abs() / scale);
            worst = worst.max((rates.energy[1] - energy[1]).abs() / scale);
        }
    }
    worst
}

/// Both engines at one scalar.
fn check<S: Built>(model: &str, cases: &[Case], tolerance: f64) {
    for engine in ENGINES {
        let worst = worst_error::<S>(S::subject(engine, model).as_mut(), cases);
        println!("{model}, {engine:?}: {worst:.1e}");
        assert!(worst <= tolerance, "{model}, {engine:?}: {worst:e}");
    }
}

#[test]
fn references_are_met_in_f64() {
    for model in MECHANISMS {
        check::<f64>(model, &cases::reference_cases(model), REFERENCE_F64);
    }
}

#[test]
fn references_are_met_in_f32() {
    for model in MECHANISMS {
        check::<f32>(model, &cases::reference_cases(model), REFERENCE_F32);
    }
}

#[test]
fn newton_euler_agrees_at_random_states_and_parameters() {
    for model in MECHANISMS {
        check::<f64>(model, &cases::random_cases(model, RANDOM_STATES, 3), ORACLE);
    }
}

#[test]
fn loaded_tiles_agree_with_newton_euler() {
    for model in ["tile", "tile_minimal"] {
        let cases = cases::loaded_tile_cases(model, RANDOM_STATES, 10);
        for engine in ENGINES {
            let worst = worst_error(f64::loaded(engine, model).as_mut(), &cases);
            println!("loaded {model}, {engine:?}: {worst:.1e}");
            assert!(worst <= ORACLE, "{model}, {engine:?}: {worst:e}");
        }
    }
}

#[test]
fn outputs_of_the_minimal_tile_are_the_closed_forms() {
    let minimal = data::minimal();
    for engine in ENGINES {
        let mut tile = f64::subject(engine, "tile_minimal");
        for (name, value) in &minimal.parameters {
            tile.set_parameter(name, *value);
        }
        for state in &minimal.states {
            let found =
                subject::outputs(tile.as_mut(), &cases::heights_state(state.h, state.h_dot, state.thrust));
            for (name, value) in &state.outputs {
                let (_, output) = found.iter().find(|(found, _)| found == name).expect("an output");
                assert!((output - value).abs() <= OUTPUT, "{name}: {output} for {value}");
            }
        }
    }
}

/// Every number of an answer as bits.
fn bits(rates: &Rates) -> Vec<u64> {
    let rest = [rates.pivot, rates.energy[0], rates.energy[1]];
    rates.q_dot.iter().chain(&rates.u_dot).chain(&rest).map(|x| x.to_bits()).collect()
}

/// Both engines at the same states, bit for bit.
fn check_bits<S: Built>(mut engines: [Box<dyn Subject<S>>; 2], cases: &[Case]) {
    let [interpreted, compiled] = &mut engines;
    let wide = |q: &[S]| -> Vec<u64> { q.iter().map(|x| x.to_f64().to_bits()).collect() };
    for case in cases {
        let [a, b] = [answer(interpreted.as_mut(), case), answer(compiled.as_mut(), case)];
        assert_eq!(bits(&a), bits(&b), "{a:?} against {b:?}");
        let slots = compiled.names().q;
        let mut q = [subject::arrange::<S>(&slots, &case.state.q), subject::arrange(&slots, &case.state.q)];
        let residuals = [interpreted.project(&mut q[0]), compiled.project(&mut q[1])];
        let residuals = residuals.map(|residual| residual.expect("slices fit"));
        assert_eq!(wide(&residuals[..1]), wide(&residuals[1..]), "projection's residual");
        assert_eq!(wide(&q[0]), wide(&q[1]), "projection");
        let outputs =
            [&mut *interpreted, &mut *compiled].map(|engine| subject::outputs(engine.as_mut(), &case.state));
        assert_eq!(outputs[0], outputs[1], "outputs");
    }
}

#[test]
fn interpreted_and_compiled_agree_bit_for_bit() {
    for model in MECHANISMS {
        let cases = cases::random_cases(model, RANDOM_STATES, 4);
        check_bits(ENGINES.map(|engine| f64::subject(engine, model)), &cases);
        check_bits(ENGINES.map(|engine| f32::subject(engine, model)), &cases);
    }
}

#[test]
fn the_form_for_accuracy_agrees_too() {
    fn engines<S: Built>(compiled: Box<dyn Subject<S>>) -> [Box<dyn Subject<S>>; 2]
    where
        InterpretedSubject<S>: Subject<S>,
    {
        let accurate = Settings { optimise: Optimise::Accuracy, ..Settings::default() };
        [Box::new(InterpretedSubject::<S>::of(&program_with("fourbar", &[], accurate))), compiled]
    }
    let cases = cases::random_cases("fourbar", RANDOM_STATES, 6);
    check_bits(engines(generated::double("fourbar accurate")), &cases);
    check_bits(engines(generated::single("fourbar accurate")), &cases);
    let worst = worst_error(generated::double("fourbar accurate").as_mut(), &cases);
    println!("fourbar for accuracy: {worst:.1e}");
    assert!(worst <= ORACLE, "{worst:e}");
}

#[test]
fn interpreted_and_compiled_agree_bit_for_bit_under_load() {
    for model in ["tile", "tile_minimal"] {
        let cases = cases::loaded_tile_cases(model, RANDOM_STATES, 11);
        check_bits(ENGINES.map(|engine| f64::loaded(engine, model)), &cases);
        check_bits(ENGINES.map(|engine| f32::loaded(engine, model)), &cases);
    }
}
