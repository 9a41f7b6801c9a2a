//! Cost of the equations: operations of one evaluation, and instructions to derive them.

use crate::instructions::of_a_fresh_process;
use smartbed_codegen::{Effort, Optimise, ScalarType, Settings};
use smartbed_runtime::real::Real;
use smartbed_runtime::real::counting::{Counting, Operations, count};
use smartbed_tests::interpreted::{emitted, emitted_with, program_with};
use smartbed_tests::subject::Subject;
use smartbed_tests::{cases, generated, subject};

/// Operations executed by one evaluation of q_dot, u_dot and the worst pivot of a model.
fn executed(model: &str) -> Operations {
    executed_of(generated::counting(model), model)
}

/// The same of a form of the model.
fn executed_of(mut mechanism: Box<dyn Subject<Counting>>, model: &str) -> Operations {
    let case = &cases::reference_cases(model)[0];
    let names = mechanism.names();
    let q: Vec<Counting> = subject::arrange(&names.q, &case.state.q);
    let u: Vec<Counting> = subject::arrange(&names.u, &case.state.u);
    let inputs: Vec<Counting> = subject::arrange(&names.inputs, &case.state.inputs);
    let (mut q_dot, mut u_dot) = (vec![Counting::ZERO; q.len()], vec![Counting::ZERO; u.len()]);
    let (pivot, cost) = count(|| mechanism.rates(Counting::ZERO, &q, &u, &inputs, &mut q_dot, &mut u_dot));
    assert!(pivot.is_ok(), "{model}");
    cost
}

/// Most operations that closed loops may take, scaling of the pivots included.
const CLOSED_LOOPS: [(&str, usize); 3] = [("fourbar", 95), ("tile", 670), ("tile_minimal", 695)];

#[test]
fn closed_loops_take_few_operations() {
    for model in cases::MECHANISMS {
        println!("{model}: {} operations, {:?}", executed(model).total(), executed(model));
    }
    for (model, most) in CLOSED_LOOPS {
        let total = executed(model).total();
        assert!(total <= most, "{model}: {total}");
    }
}

/// Operations of q_dot and u_dot, without `prepare()`: the goal with all effort, and the present limit.
const REACH: [(&str, usize, usize); 6] = [
    ("tile", 640, 479),
    ("tile_minimal", 450, 450),
    ("arm6", 1100, 1100),
    ("bicycle", 1050, 1050),
    ("fourbar", 100, 100),
    ("pendulum10", 340, 340),
];

#[test]
fn all_effort_reaches_its_operations() {
    for (model, goal, holds) in REACH {
        let operations = program_with(model, &[], Effort::All).operations();
        println!("{model}: {operations} operations with all effort, goal {goal}");
        assert!(operations <= holds, "{model}: {operations}");
    }
}

/// The same by default: what is asked of the tile, and what the others hold.
const BY_DEFAULT: [(&str, usize); 6] = [
    ("tile", 500),
    ("tile_minimal", 480),
    ("arm6", 1110),
    ("bicycle", 1055),
    ("fourbar", 83),
    ("pendulum10", 185),
];

#[test]
fn default_effort_reaches_its_operations() {
    for (model, most) in BY_DEFAULT {
        let operations = program_with(model, &[], Effort::Default).operations();
        println!("{model}: {operations} operations by default, at most {most}");
        assert!(operations <= most, "{model}: {operations}");
    }
}

#[test]
fn header_states_the_operations_that_are_executed() {
    for model in cases::MECHANISMS {
        let text = emitted(model, ScalarType::F64);
        let line = text.lines().find(|line| line.starts_with("// Cost of rates:")).expect("a header");
        let stated: usize =
            line["// Cost of rates: ".len()..].split(' ').next().unwrap_or("").parse().expect(line);
        // Sine and cosine are computed together: if a program uses one of an angle, the other is executed too.
        let rates = &text[text.find("pub fn rates").expect("rates")..];
        let rates = &rates[..rates.find("\n}").expect("its end")];
        let idle = rates.matches(", _)").count() + rates.matches("(_, ").count();
        let executed = executed(model);
        assert_eq!(stated + idle, executed.total() + executed.other, "{model}: {line}");
    }
}

#[test]
fn differences_of_angles_take_fewer_operations_and_are_counted() {
    let operations = |optimise| {
        let settings = Settings { optimise, ..Settings::default() };
        program_with("fourbar", &[], settings).operations()
    };
    let [accurate, short] = [Optimise::Accuracy, Optimise::Operations].map(operations);
    assert!(accurate < short, "{accurate} {short}");
    // Six functions: three differences, and the cosines of the three angles in the weights.
    let executed = executed_of(generated::counting("fourbar accurate"), "fourbar");
    assert_eq!((executed.sin, executed.cos), (6, 6), "{executed:?}");
}

#[test]
fn every_angle_has_one_sincos() {
    // Six angles of three connectors; three absolute angles; none in the closed forms' rates.
    for (model, angles) in [("tile", 6), ("fourbar", 3), ("tile_minimal", 0)] {
        let executed = executed(model);
        assert!(executed.sin <= angles && executed.cos <= angles, "{model}: {executed:?}");
    }
}

/// Instructions (millions) from text to formatted Rust in a fresh process, by effort, with a few hundredths of room.
///
/// Instructions are the same whatever else the machine does; `tests/peers/run.py` measures the time on a quiet one.
const DERIVATION: [(&str, Effort, f64); 6] = [
    ("tile", Effort::Default, 52.2),
    ("arm6", Effort::Default, 68.0),
    ("bicycle", Effort::Default, 60.5),
    ("pendulum10", Effort::Default, 28.0),
    ("fourbar", Effort::All, 60.0),
    ("tile", Effort::All, 630.0),
];
/// Environment variable with model and effort for the new process that derives once.
const CHILD: &str = "SMARTBED_TESTS_DERIVE";

/// Millions of instructions of a fresh process that derives a model, or nothing.
fn instructions_of_a_fresh_process(asked: &str) -> f64 {
    let test = "cost::models_are_derived_with_few_instructions_in_a_fresh_process";
    of_a_fresh_process(test, CHILD, asked) / 1e6
}

#[test]
fn models_are_derived_with_few_instructions_in_a_fresh_process() {
    if let Ok(asked) = std::env::var(CHILD) {
        if let Some((model, effort)) = asked.split_once(' ') {
            let effort = if effort == "All" { Effort::All } else { Effort::Default };
            assert!(emitted_with(model, ScalarType::F32, effort).contains("fn rates"));
        }
        return;
    }
    let idle = instructions_of_a_fresh_process("nothing");
    for (model, effort, most) in DERIVATION {
        let count = instructions_of_a_fresh_process(&format!("{model} {effort:?}")) - idle;
        println!("{model}, {effort:?}: {count:.1} million instructions, at most {most}");
        assert!(count <= most, "{model}, {effort:?}: {count} million instructions");
    }
}
