//! What the equations cost: operations of one evaluation, and the time to derive them.

use smartbed::report::clock;
use smartbed_codegen::{Effort, Optimise, ScalarType, Settings};
use smartbed_runtime::real::Real;
use smartbed_runtime::real::counting::{Counting, Operations, count};
use smartbed_tests::interpreted::{emitted, emitted_with, program_with};
use smartbed_tests::subject::Subject;
use smartbed_tests::{cases, generated, subject};
use std::process::Command;

/// Executed by one evaluation of q_dot, u_dot and the worst pivot of a model.
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

/// Operations of q_dot and u_dot that all effort is to reach, `prepare()` apart, and what holds today.
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

#[test]
fn header_states_the_operations_that_are_executed() {
    for model in cases::MECHANISMS {
        let text = emitted(model, ScalarType::F64);
        let line = text.lines().find(|line| line.starts_with("// Cost of rates:")).expect("a header");
        let stated: usize =
            line["// Cost of rates: ".len()..].split(' ').next().unwrap_or("").parse().expect(line);
        // Sine and cosine come together: where a program reads one of an angle, the other is executed too.
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

/// From text to formatted Rust in a fresh process (ms): effort, goal, and what holds.
///
/// Processor time: other tests on the same cores do not count. What holds leaves room for the checks of this profile.
const DERIVATION: [(Effort, f64, f64); 2] = [(Effort::Default, 5.0, 15.0), (Effort::All, 200.0, 200.0)];
/// Models whose derivation is timed.
const DERIVED: [&str; 7] = ["tile", "tile_minimal", "arm6", "bicycle", "fourbar", "pendulum10", "pendulum3"];
/// Runs of which the fastest counts: the others found their caches used by somebody else.
const RUNS: usize = 100;
/// Set to model and effort in the fresh process that derives once and prints the time.
const CHILD: &str = "SMARTBED_TESTS_DERIVE";

/// Derives a model in this process and returns the time (ms).
fn derivation_time(model: &str, effort: Effort) -> f64 {
    let start = clock::now();
    let text = emitted_with(model, ScalarType::F32, effort);
    let time = (clock::now() - start).as_secs_f64() * 1e3;
    assert!(text.contains("fn rates"));
    time
}

/// The same in a process of its own.
fn derivation_time_of_a_fresh_process(model: &str, effort: Effort) -> f64 {
    let this = std::env::current_exe().expect("the test binary");
    let test = "cost::models_are_derived_in_time_in_a_fresh_process";
    let mut command = Command::new(this);
    command.args(["--exact", test, "--nocapture"]).env(CHILD, format!("{model} {effort:?}"));
    let output = command.output().expect("the child runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let line = text.lines().find_map(|line| line.strip_prefix("milliseconds "));
    line.and_then(|time| time.parse().ok()).unwrap_or_else(|| panic!("no time in {text}"))
}

#[test]
fn models_are_derived_in_time_in_a_fresh_process() {
    if let Ok(asked) = std::env::var(CHILD) {
        let (model, effort) = asked.split_once(' ').expect("model and effort");
        let effort = if effort == "All" { Effort::All } else { Effort::Default };
        println!("\nmilliseconds {}", derivation_time(model, effort));
        return;
    }
    for (effort, goal, holds) in DERIVATION {
        for model in DERIVED {
            let mut fastest = f64::INFINITY;
            for _ in 0..RUNS {
                fastest = fastest.min(derivation_time_of_a_fresh_process(model, effort));
                if fastest <= holds {
                    break;
                }
            }
            println!("{model}, {effort:?}: {fastest:.1} ms from text to formatted Rust, goal {goal}");
            assert!(fastest <= holds, "{model}, {effort:?}: {fastest} ms");
        }
    }
}
