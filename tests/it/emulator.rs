//! The image on the emulated chip: results bitwise equal to the host's, exact counts, and refused defects.
//!
//! If the toolchain or the emulator is missing these tests fail, they are not skipped; the message
//! names the command that installs it.

use smartbed::engine::crate_text;
use smartbed::firmware::fit::RAM;
use smartbed::firmware::functions::{self, Measured};
use smartbed::firmware::image::rules::Rule;
use smartbed::firmware::report::{Outcome, Report};
use smartbed::firmware::settings::Subject;
use smartbed::firmware::{Arguments, chip, measure, toolchain};
use smartbed::world::carried::CarriedWorld;
use smartbed::world::engine::Engine as _;
use smartbed_codegen::model::StartRef;
use smartbed_codegen::{
    Asked, Effort, EmitOptions, Function, Interpreted, ParameterChoice, ScalarType, Settings, program,
};
use smartbed_firmware::simulation::Simulation;
use smartbed_runtime::mechanism::Mechanism;
use std::process::{Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// There is one image file: one test at a time builds and uses it.
static IMAGE: Mutex<()> = Mutex::new(());

pub(crate) fn one_at_a_time() -> MutexGuard<'static, ()> {
    IMAGE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn report(arguments: &Arguments) -> Report {
    measure(arguments).unwrap_or_else(|failure| panic!("{failure}"))
}

pub(crate) fn outcome(arguments: &Arguments) -> Outcome {
    let report = report(arguments);
    report.run.unwrap_or_else(|| panic!("the image is refused: {:?}", report.findings))
}

#[test]
fn host_and_chip_agree_to_the_bit_for_10_000_steps() {
    let _image = one_at_a_time();
    let chip = outcome(&Arguments::default());
    let here = Simulation::new().expect("a start").run(10_000).expect("no step is refused");
    assert_eq!(chip.digest.as_bytes(), here.hex(), "this test's own compiler");
    assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "the image's compiler");
    assert_eq!(chip.step.calls, 10_000);
    assert_eq!(
        chip.rates.expect("a mechanism has rates").calls,
        1,
        "steps share the work of their evaluations"
    );
}

#[test]
fn other_mechanisms_run_on_the_chip_too() {
    let _image = one_at_a_time();
    for model in ["pendulum", "fourbar", "arm6"] {
        let steps = 100;
        let arguments =
            Arguments { model: Some(model.to_owned()), steps: Some(steps), ..Arguments::default() };
        let chip = outcome(&arguments);
        assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "{model}");
        assert_eq!(chip.step.calls, u64::from(steps), "{model}");
    }
}

/// The last state of a model from its `[start]` under its `[law]`, by a Runge-Kutta of this test's own in f64.
fn by_hand(name: &str, steps: u32) -> Vec<f64> {
    let model = smartbed_codegen::model::read(&smartbed_tests::interpreted::path(name)).expect("a model");
    let asked = Asked::besides(Function::each(&["law"]));
    let program = program::derive_asked(&model, &ParameterChoice::default(), Settings::default(), &asked);
    let program = program.unwrap_or_else(|found| panic!("{found}"));
    let mut engine = Interpreted::<f64>::new(&program);
    let mut x: Vec<f64> = program.nominal.iter().copied().chain(program.u.iter().map(|_| 0.0)).collect();
    for (owner, value) in &model.start {
        let name = match owner {
            StartRef::Coordinate(id) => &model.coordinates[*id].name,
            StartRef::Speed(id) => &model.speeds[*id].name,
        };
        let place = program.q.iter().chain(&program.u).position(|quantity| quantity.name == *name);
        let place = place.expect("state");
        x[place] = *value;
    }
    let n_q = program.q.len();
    let zeros = vec![0.0; program.inputs.len()];
    let mut slope = |t: f64, x: &[f64]| -> Vec<f64> {
        let (q, u) = x.split_at(n_q);
        let inputs = engine.function(0, (t, q, u, &zeros, &[])).expect("lengths fit");
        let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
        engine.rates(t, q, u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
        [q_dot, u_dot].concat()
    };
    const STEP: f64 = 1e-3;
    for n in 0..steps {
        let t = f64::from(n) * STEP;
        let moved = |k: &[f64], h: f64| -> Vec<f64> { x.iter().zip(k).map(|(x, k)| x + h * k).collect() };
        let a = slope(t, &x);
        let b = slope(t + STEP / 2.0, &moved(&a, STEP / 2.0));
        let c = slope(t + STEP / 2.0, &moved(&b, STEP / 2.0));
        let d = slope(t + STEP, &moved(&c, STEP));
        x = (0..x.len()).map(|i| x[i] + STEP / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])).collect();
    }
    x
}

#[test]
fn the_law_and_the_start_of_a_model_act_on_the_chip() {
    let _image = one_at_a_time();
    for name in ["cart_pole", "pendulum"] {
        let steps = 1000;
        let arguments =
            Arguments { model: Some(name.to_owned()), steps: Some(steps), ..Arguments::default() };
        let chip = outcome(&arguments);
        assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "{name}");
        let expected = by_hand(name, steps);
        assert_eq!(chip.state.len(), expected.len(), "{name}");
        assert!(expected.iter().any(|x| x.abs() > 1e-3), "{name} moves: {expected:?}");
        for (found, expected) in chip.state.iter().zip(&expected) {
            assert!((f64::from(*found) - expected).abs() < 1e-4, "{name}: {found} against {expected}");
        }
    }
}

/// The last state [q, x; u, v] of a world after so many of its steps, by the host in f64.
fn world_by_host(name: &str, set: &[String], steps: usize) -> Vec<f64> {
    let asked = smartbed::run::Arguments {
        model: name.to_owned(),
        set: set.to_vec(),
        ..smartbed::run::Arguments::default()
    };
    let assembly = smartbed::run::world(&asked).unwrap_or_else(|failure| panic!("{failure}"));
    let mut world = CarriedWorld::new(&assembly).expect("a world");
    for _ in 0..steps {
        world.step(assembly.run.step, &mut Vec::new()).expect("a step");
    }
    world.numbers().to_vec()
}

#[test]
fn a_world_as_fine_as_ram_carries_runs_on_the_chip_bit_for_bit() {
    let _image = one_at_a_time();
    let steps = 100;
    let arguments =
        Arguments { model: Some("tile_with_bladder".to_owned()), steps: Some(steps), ..Arguments::default() };
    let report = report(&arguments);
    let Subject::World(world) = &report.settings.subject else { panic!("a world") };
    let rows = world.rows.expect("its sheet is as fine as RAM carries");
    // Stack and static data fit the RAM; with one more row they would not.
    let taken = usize::try_from(report.size.ram).expect("bytes") + report.stack.bytes as usize;
    let finer = world.demand.with([2 * rows + 9, 2 * rows + 1]);
    assert!(taken <= RAM, "{taken}");
    assert!(taken - world.demand.bytes() + finer.bytes() > RAM, "{rows} rows, {taken} bytes");
    assert!(world.demand.nodes >= 500, "{} nodes", world.demand.nodes);
    let set = ["rows", "columns"].map(|key| format!("parts.bladder.{key}={rows}"));
    let chip = report.run.expect("the image keeps its rules and runs");
    assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "bits");
    assert_eq!(chip.step.calls, u64::from(steps));
    let expected = world_by_host("tile_with_bladder", &set, steps as usize);
    assert_eq!(chip.state.len(), expected.len());
    let places = 3 * rows * rows;
    let off = chip.state.iter().zip(&expected).take(places).map(|(a, b)| (f64::from(*a) - b).abs());
    let off = off.fold(0.0, f64::max);
    println!("{rows} x {rows}: {} nodes, {taken} bytes, {off:.1e} m from the host's f64", world.demand.nodes);
    assert!(off < 2e-6, "single precision is {off:e} m off");
}

/// Runs a world with contacts on the chip; the largest difference of its places from the host's f64 (m or rad), and its
/// events there.
fn touched_on_the_chip(model: &str, steps: u32) -> (f64, usize) {
    let arguments = Arguments { model: Some(model.to_owned()), steps: Some(steps), ..Arguments::default() };
    let report = report(&arguments);
    let Subject::World(world) = &report.settings.subject else { panic!("a world") };
    assert!(world.demand.contacts() > 0, "room for contacts");
    let chip = report.run.expect("the image keeps its rules and runs");
    assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "bits");
    assert_eq!(chip.step.calls, u64::from(steps));
    let asked = smartbed::run::Arguments { model: model.to_owned(), ..smartbed::run::Arguments::default() };
    let assembly = smartbed::run::world(&asked).unwrap_or_else(|failure| panic!("{failure}"));
    let (mut host, mut events) = (CarriedWorld::new(&assembly).expect("a world"), Vec::new());
    (0..steps).for_each(|_| host.step(assembly.run.step, &mut events).expect("a step"));
    assert_eq!(chip.state.len(), host.numbers().len());
    let half = chip.state.iter().zip(host.numbers()).take(chip.state.len() / 2);
    let off = half.map(|(a, b)| (f64::from(*a) - b).abs()).fold(0.0, f64::max);
    println!("{model}: {} events, {off:.1e} off, {} instructions", events.len(), chip.step.instructions[1]);
    (off, events.len())
}

#[test]
fn a_ball_meets_a_bladder_on_the_chip_as_on_the_host() {
    let _image = one_at_a_time();
    let (off, events) = touched_on_the_chip("ball_on_bladder", 250);
    assert!(events > 0 && off < 1e-4, "{off:e} after {events} events");
}

#[test]
fn both_rods_of_a_pendulum_meet_a_wall_on_the_chip_as_on_the_host() {
    let _image = one_at_a_time();
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let ports = "[ports]\nupper = { frame = \"upper\", point = \"A\" }\nlower = { frame = \"lower\", point = \"B\" }\n\n[outputs]";
    let rods =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/double_pendulum.toml"));
    let rods = rods
        .expect("a model")
        .replace("[outputs]", ports)
        .replace("name = \"double_pendulum\"", "name = \"two_rods\"");
    let model = folder.join("two_rods.toml");
    std::fs::write(&model, rods).expect("a file");
    let part = |name: &str, port: &str| {
        format!(
            "[parts.{name}]\nrigid = \"sphere\"\nradius = \"50_mm\"\non = \"pendulum.{port}\"\n\
             [[contacts]]\nbetween = [\"{name}\", \"wall\"]\nimpact = \"moreau\"\nfriction = 0.3\n"
        )
    };
    let text = format!(
        "format = 2\n[parts.pendulum]\nmechanism = {:?}\nlaw = {{ T = 0 }}\nstart = {{ q1 = \"30*deg\", q2 = \"-20*deg\" }}\n\
         [parts.wall]\nrigid = \"box\"\nsize = [1, 0.04, 2]\nfixed = true\nstart = {{ position = [0, -0.08, -0.5] }}\n{}{}\
         [run]\nseconds = 0.5\nstep = \"0.5_ms\"\n",
        model.display().to_string(),
        part("knee", "upper"),
        part("foot", "lower"),
    );
    let scene = folder.join("rods_on_wall.toml");
    std::fs::write(&scene, text).expect("a file");
    let (off, events) = touched_on_the_chip(&scene.display().to_string(), 1000);
    assert!(events >= 2 && off < 1e-4, "{off:e} after {events} events");
}

#[test]
fn an_image_of_one_spring_keeps_to_its_flash_and_its_bits() {
    let _image = one_at_a_time();
    let spring =
        Arguments { model: Some("single_spring".to_owned()), steps: Some(1000), ..Arguments::default() };
    let report = report(&spring);
    let flash = report.size.flash;
    let chip = report.run.expect("the image keeps its rules and runs");
    println!("{flash} bytes of flash, {} instructions a step", chip.step.instructions[1]);
    assert!(flash <= 20 * 1024, "{flash} bytes");
    assert_eq!(Some(&chip.digest), chip.host_digest.as_ref());
}

/// It touches after 452 steps; the tables name a law of the ground as the runtime does.
#[test]
fn a_spring_meets_a_soft_ground_on_the_chip_bit_for_bit() {
    let _image = one_at_a_time();
    for law in ["penalty", "hunt_crossley"] {
        let (model, set) = (Some("single_spring".to_owned()), vec![format!("law={law}")]);
        let chip = outcome(&Arguments { model, steps: Some(600), set, ..Arguments::default() });
        assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "{law}");
    }
}

/// Code optimised for size contains other bounds checks than code optimised for speed.
#[test]
fn large_scenes_optimised_for_size_keep_the_rules_and_their_bits() {
    let _image = one_at_a_time();
    for (scene, steps) in [("two_cubes", 600), ("stiff_bladder", 20), ("tile_with_bladder", 10)] {
        let model = Some(scene.to_owned());
        let chip = outcome(&Arguments { model, steps: Some(steps), small: true, ..Arguments::default() });
        assert_eq!(Some(&chip.digest), chip.host_digest.as_ref(), "{scene}");
    }
}

/// The instructions per spring are the difference from the same sheet without springs.
#[test]
fn a_sheet_goes_row_by_row_on_the_chip() {
    let _image = one_at_a_time();
    let by_rows = |set: &[&str]| {
        let set = set.iter().map(|change| (*change).to_owned()).collect();
        let model = Some("stiff_bladder".to_owned());
        outcome(&Arguments { model, steps: Some(50), by_rows: true, set, ..Arguments::default() })
    };
    let (chip, without) = (by_rows(&[]), by_rows(&["K=0", "C=0"]));
    assert_eq!(Some(&chip.digest), chip.host_digest.as_ref());
    let [step, without] = [chip, without].map(|outcome| outcome.step.instructions[1]);
    let spring = (step - without) as f64 / 480.0;
    println!("{step} instructions a step, {spring:.1} a spring with its damper");
    assert!(spring <= 60.0, "{spring}");
    assert!(step <= 65_000, "{step}");
}

#[test]
fn a_sheet_at_rest_at_each_pressure_keeps_real_time_and_a_thousandth() {
    let _image = one_at_a_time();
    let report = report(&Arguments {
        model: Some("stiff_bladder".to_owned()),
        at_rest: true,
        set: vec!["T=0.5".to_owned()],
        ..Arguments::default()
    });
    let Subject::Rest(found, _) = &report.settings.subject else { panic!("a sheet at rest") };
    let [from_rest, from_motion] = found.errors;
    let chip = report.run.expect("the image keeps its rules and runs");
    println!("{from_rest:e} from rest, {from_motion:e} from the motion, {:?}", chip.step);
    assert_eq!(Some(&chip.digest), chip.host_digest.as_ref());
    assert!(from_rest <= 1e-4 && from_motion <= 1e-3, "{:?}", found.errors);
    assert!(chip.step.cycles[1] < 168_000, "{:?}", chip.step);
}

/// Bars of the tile's equations on the chip.
#[test]
fn the_equations_keep_to_their_instructions_and_bytes() {
    let _image = one_at_a_time();
    let chip = outcome(&Arguments { steps: Some(10), ..Arguments::default() });
    assert!(chip.step.instructions[1] <= 5_000, "{:?}", chip.step);
    let equations = chip.equations.expect("a mechanism has equations");
    println!("{:.4} per operation, {equations:?}, {:?}", equations.by_operation(), chip.step);
    assert!(equations.sin_cos <= 60, "{equations:?}");
    assert!(equations.by_operation() <= 1.45, "{equations:?}");
    // Stricter than the bar: the part that sines and cosines share counts as operations.
    assert!(equations.by_operation_with_constants() <= 1.60, "{equations:?}");
    assert!(equations.bytes <= 16 * 1024, "{equations:?}");
}

/// `derive --costs` counts the instructions in the code of a separate function; here they are executed in a call
/// through the trait, with lengths that the compiler knows.
#[test]
fn the_cost_sheet_counts_what_the_chip_executes() {
    let _image = one_at_a_time();
    let executed = outcome(&Arguments { steps: Some(10), ..Arguments::default() });
    let [_, executed, _] = executed.rates.expect("a mechanism has rates").instructions;
    let model = smartbed_codegen::model::read(&smartbed_tests::interpreted::path("tile")).expect("a model");
    let program = program::derive_with(&model, &ParameterChoice::default(), Effort::All);
    let program = program.unwrap_or_else(|found| panic!("{found}"));
    let options = EmitOptions {
        scalar: ScalarType::F32,
        functions: Function::each(&["rates"]),
        ..EmitOptions::default()
    };
    let files = crate_text::library(&program, &options.scalar, &options);
    let rates = Measured { name: "rates".to_owned(), takes_u_dot: false };
    let toolchain = functions::toolchain().expect("`cargo smartbed firmware` installs one");
    let costs = functions::costs(&toolchain, files, &[rates]).unwrap_or_else(|failure| panic!("{failure}"));
    let counted = costs[0].instructions;
    println!("rates of the tile: {} instructions counted, {executed} executed", counted.count);
    assert!(!counted.has_loops);
    let off = executed.abs_diff(counted.count);
    assert!(20 * off <= executed, "{} counted, {executed} executed", counted.count);
}

#[test]
fn a_changed_parameter_changes_chip_and_host_alike() {
    let _image = one_at_a_time();
    let before = outcome(&Arguments::default());
    let after = outcome(&Arguments { set: vec!["M=7.5".to_owned()], ..Arguments::default() });
    assert_ne!(before.digest, after.digest);
    assert_ne!(before.host_digest, after.host_digest);
    assert_eq!(Some(&after.digest), after.host_digest.as_ref());
}

/// The plug-in counts by translated block. Here the emulator executes one instruction at a time
/// and logs each: the numbers of log entries and of counted instructions must be equal.
#[test]
fn counts_are_those_of_single_stepping() {
    let _image = one_at_a_time();
    let report = report(&Arguments { steps: Some(3), ..Arguments::default() });
    let counted = report.run.expect("the image runs").instructions;
    let log = report.elf.with_extension("log");
    let emulator = toolchain::emulator().unwrap_or_else(|failure| panic!("{failure}"));
    let status = Command::new(emulator)
        .args(["-M", chip::STM32F405.machine, "-nographic", "-monitor", "none", "-serial", "none"])
        .args(["-semihosting-config", "enable=on,target=native", "-singlestep", "-d", "nochain,exec", "-D"])
        .arg(&log)
        .arg("-kernel")
        .arg(&report.elf)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .status()
        .expect("the emulator starts");
    assert!(status.success(), "{status}");
    let text = std::fs::read_to_string(&log).expect("the log is there");
    let logged = text.lines().filter(|line| line.starts_with("Trace")).count();
    assert_eq!(counted, logged as u64);
}

#[test]
fn defects_are_refused() {
    let _image = one_at_a_time();
    let defects = [
        ("panic", Rule::Panic),
        ("double", Rule::Double),
        ("recursion", Rule::Recursion),
        ("indirect", Rule::Indirect),
    ];
    for (defect, rule) in defects {
        let report = report(&Arguments { inject: Some(defect.to_owned()), ..Arguments::default() });
        let rules: Vec<Rule> = report.findings.iter().map(|f| f.rule).collect();
        assert!(rules.contains(&rule), "{defect}: found {rules:?}");
        assert!(report.run.is_none(), "{defect}: a refused image must not run");
        assert!(!report.failures().is_empty());
    }
}

#[test]
fn an_unknown_parameter_is_wrong_input() {
    let _image = one_at_a_time();
    let arguments = Arguments { set: vec!["no_such_parameter=1".to_owned()], ..Arguments::default() };
    assert_eq!(measure(&arguments).expect_err("there is no such parameter").status(), 1);
}
