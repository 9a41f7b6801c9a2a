//! `check`, `derive` and the command line itself.

use crate::support::{
    builds, children_seconds, command, file, finish, least_time, lock, model, smartbed, written,
};
use std::path::Path;
use std::process::Command;

#[test]
fn check_counts_the_tile() {
    let done = smartbed(&["check", "tile", "--json"]);
    let facts = done.json();
    assert_eq!(facts["dof"], serde_json::json!({"stated": 3, "found": 3}));
    assert_eq!(facts["counts"]["coordinates"], 12);
    assert_eq!(facts["counts"]["independent_speeds"], 3);
    assert_eq!(facts["independent_speeds"][0]["meaning"], "d(hA)/dt");
    assert_eq!(facts["cost"][0]["answer"], "rates");
    assert!(facts["cost"][0]["operations"].as_u64().expect("a number") > 100);
    assert_eq!(facts["constraints"]["rank"], facts["constraints"]["largest_rank"]);
    let unit = |name: &str| {
        let rows = facts["units"].as_array().expect("rows");
        rows.iter().find(|r| r["name"] == name).expect("a row")["unit"].clone()
    };
    assert_eq!((unit("Ix"), unit("u_hA")), ("kg m^2".into(), "m/s".into()));
    let text = smartbed(&["check", "tile"]).out;
    for part in ["degrees of freedom: 3 found, 3 stated", "independent: u_hA = d(hA)/dt", "answer", "units"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

/// Some ten roundings of 6e-8 in every output; rates that are speeds themselves are not rounded at all.
#[test]
fn check_says_what_single_precision_costs() {
    for model in ["tile", "fourbar", "bicycle", "pendulum3"] {
        let facts = smartbed(&["check", model, "--rounding", "--json"]).json();
        let rows = facts["rounding"].as_array().expect("rows");
        for row in rows {
            let [error, moves] = ["error", "moves"].map(|key| row[key].as_f64().expect("a number"));
            assert!(error <= 2e-6, "{model}: {row}");
            assert_eq!(row["operation"].is_null(), error == 0.0, "{model}: {row}");
            assert!(moves <= 4e-7, "{model}: {row}");
        }
        let accelerations = rows.iter().filter(|r| r["output"].as_str().is_some_and(|o| o.starts_with('u')));
        assert!(accelerations.clone().count() > 0, "{model}");
        assert!(accelerations.clone().all(|r| r["moves"].as_f64() > Some(1e-9)), "{model}: {rows:?}");
    }
    assert!(!smartbed(&["check", "tile"]).out.contains("rounding in f32"));
    assert!(smartbed(&["check", "tile", "--rounding"]).out.contains("rounding in f32"));
}

#[test]
fn speeds_in_closed_form_are_no_freedom() {
    for (model, dof) in [("slider_crank_closed", 1), ("tile_minimal", 3)] {
        let facts = smartbed(&["check", model, "--json"]).json();
        assert_eq!(facts["dof"]["found"], dof, "{model}");
    }
}

#[test]
fn check_warns_of_what_is_never_used() {
    let model = model("pendulum3")
        .replace("[repeat.link]\n", "spare = { value = 1, unit = \"kg\" }\n\n[repeat.link]\n");
    let path = written("spare.toml", &model);
    let text = smartbed(&["check", &path]).out;
    assert!(text.contains("parameter `spare` is never used") && text.contains("spare.toml:"), "{text}");
    let facts = smartbed(&["check", &path, "--json"]).json();
    assert_eq!(facts["warnings"][0], "parameter `spare` is never used");
}

#[test]
fn check_finds_what_the_samples_miss() {
    // Crank almost as long as the rod: cos(b) is sqrt(1 - (r/l)^2) where the crank stands upright, in a
    // valley a few degrees wide that 64 samples over 355 degrees step over.
    let model = model("slider_crank").replace(
        "q = { unit = \"rad\", independent = true, nominal = \"60*deg\", range = [-3.1, 3.1]",
        "q = { unit = \"deg\", independent = true, nominal = 20, range = [-60, 95]",
    );
    let model = model
        .replace("value = 0.3, unit = \"m\"", "value = 0.1000001, unit = \"m\"")
        .replace("nominal = -0.29, range = [-0.4, 0.4]", "nominal = -0.349, range = [-1.6, 1.6]")
        .replace("nominal = 0.337, range = [0.2, 0.4]", "nominal = 0.188, range = [-0.1, 0.3]");
    let path = written("nearly_singular.toml", &model);
    let facts = smartbed(&["check", &path, "--json"]).json();
    let nearest = &facts["nearest_to_singular"];
    let q = nearest["at"][0].as_str().expect("a place").to_owned();
    assert_eq!(q, "q = 90.0000 deg");
    let sampled = facts["pivots"][0]["worst"].as_f64().expect("a number");
    let found = nearest["pivot"].as_f64().expect("a number");
    let nominal = (1.0 - (20.0_f64.to_radians().sin() / 1.000_001).powi(2)).sqrt();
    let exact = (1.0 - 1.000_001_f64.powi(-2)).sqrt() / nominal;
    assert!((found / exact - 1.0).abs() < 1e-3, "{found} is not {exact}");
    assert!(2.0 * found < sampled, "{found} against {sampled} at the samples");
    let text = smartbed(&["check", &path]).out;
    assert!(text.contains("warning: within the ranges a configuration is nearly singular"), "{text}");
}

/// The same linkage with the piston's place independent, up to a hair of where it turns round: the constraints are as
/// regular there as anywhere, but the piston's speed no longer says how the crank turns.
#[test]
fn check_tells_a_dead_point_from_a_singularity() {
    let model = model("slider_crank");
    let of_crank = smartbed(&["check", &written("of_crank.toml", &model)]);
    assert!(of_crank.out.contains("no warnings"), "{of_crank:?}");
    let model =
        model.replace("q = { unit = \"rad\", independent = true, ", "q = { unit = \"rad\", ").replace(
            "x = { unit = \"m\", nominal = 0.337, range = [0.2, 0.4]",
            "x = { unit = \"m\", independent = true, nominal = 0.337, range = [0.25, 0.3999999]",
        );
    let model = model.replace("u_q = 20", "u_x = 1");
    let facts = smartbed(&["check", &written("of_piston.toml", &model), "--json"]).json();
    let warnings: Vec<&str> =
        facts["warnings"].as_array().expect("a list").iter().filter_map(|w| w.as_str()).collect();
    assert!(matches!(warnings[..], [one] if one.contains("dead point")), "{warnings:?}");
    // Of the Jacobian [r sin q, l sin b, 1; r cos q, l cos b, 0] nothing is lost there.
    assert!(facts["constraints"]["conditioning"].as_f64().expect("a number") > 0.1, "{facts}");
}

/// Precession and spin turn about one axis where the top stands upright: no constraint is there to be singular, but the
/// masses do not say which of the two turns.
#[test]
fn check_warns_where_the_masses_do_not_determine_the_motion() {
    let model = model("gyroscope");
    let tilted = smartbed(&["check", &written("tilted.toml", &model)]);
    assert!(tilted.out.contains("no warnings"), "{tilted:?}");
    let model = model.replace("range = [\"20*deg\", \"160*deg\"]", "range = [\"-20*deg\", \"160*deg\"]");
    let text = smartbed(&["check", &written("upright.toml", &model)]).out;
    let warning = "warning: within the ranges the equations of motion are nearly singular";
    assert!(text.contains(warning) && text.contains("theta = 0.0000 rad"), "{text}");
}

#[test]
fn dropped_constraints_are_named_by_every_command_that_derives() {
    let model = model("fourbar").replace(
        "[constraints.configuration]\n",
        "[constraints.configuration]\nagain = \"dot(D - C, N.x)*2\"\n",
    );
    let path = written("redundant.toml", &model);
    let message = "follows from the other constraints and is dropped";
    let done = smartbed(&["check", &path]);
    assert!(done.out.contains(message) && done.out.contains("redundant.toml:"), "{done:?}");
    let out = file("redundant.rs").display().to_string();
    let states = written("redundant.json", "{\"states\": [{\"q\": {\"q1\": 1}}]}");
    for arguments in [
        &["derive", &path, "-o", &out][..],
        &["run", &path, "--seconds", "0.01"],
        &["eval", &path, "--states", &states],
    ] {
        let done = smartbed(arguments);
        assert_eq!(done.status, 0, "{done:?}");
        assert!(done.err.contains(message), "{arguments:?}: {done:?}");
    }
}

#[test]
fn check_shows_the_errors_of_a_model() {
    let done =
        smartbed(&["check", &written("broken.toml", "format = 1\nname = \"broken\"\n[bodies]\nb = 3\n")]);
    assert!(done.message().contains("broken.toml:4:"), "{done:?}");
}

#[test]
fn derive_writes_rust_and_the_same_bytes_each_time() {
    let path = file("tile.rs").display().to_string();
    let done = smartbed(&["derive", "tile", "--scalar", "f32", "-o", &path, "--json"]);
    assert!(done.json()["operations"]["rates"].as_u64().expect("a number") > 100);
    let text = std::fs::read_to_string(path).expect("written");
    assert!(text.contains("pub type S = f32;") && !text.contains("f64"), "f32 only");
    assert_eq!(text, smartbed(&["derive", "tile", "--scalar", "f32"]).out);
    let lanes = smartbed(&["derive", "fourbar", "--scalar", "f32x8"]).out;
    assert!(lanes.contains("pub type S = wide::f32x8;"));
}

#[test]
fn forms_give_what_they_say_or_explain_why_not() {
    let functions = |arguments: &[&str]| -> Vec<String> {
        let text = smartbed(arguments).out;
        // What depends on parameters alone is in every form.
        let names = text.lines().filter_map(|l| l.strip_prefix("pub fn ")?.split('(').next());
        let names = names.filter(|name| *name != "prepare");
        names.map(str::to_owned).collect()
    };
    assert_eq!(functions(&["derive", "fourbar", "--form", "kinematic"]), ["speeds", "outputs", "projection"]);
    assert_eq!(functions(&["derive", "fourbar", "--answers", "energy"]), ["energy"]);
    assert_eq!(functions(&["derive", "tile_minimal", "--form", "minimal"]).len(), 6);
    let done = smartbed(&["derive", "fourbar", "--form", "minimal"]);
    assert!(done.message().contains("dependent coordinates as state (q2, q3)"), "{done:?}");
    let done = smartbed(&["derive", "fourbar", "--form", "kinematic", "--answers", "rates"]);
    assert!(done.message().contains("needs masses"), "{done:?}");
}

#[test]
fn functions_named_like_other_items_are_renamed_and_named_as_emitted() {
    let file = written("renamed.rs", "");
    for (asked, emitted) in [
        ("START_Q", "START_Q_2"),
        ("Q_NAMES", "Q_NAMES_2"),
        ("fn", "fn_"),
        ("Some", "Some_2"),
        ("prepare", "prepare_2"),
    ] {
        let done =
            smartbed(&["derive", "pendulum", "--answers", &format!("{asked}=rates,bias"), "-o", &file]);
        assert!(done.out.contains(&format!(" of {emitted}, in ")), "{done:?}");
        let note = format!("note: the function `{asked}` is emitted as `{emitted}`");
        assert!(done.err.contains(&note), "{done:?}");
        let text = std::fs::read_to_string(&file).expect("written");
        assert!(text.contains(&format!("pub fn {emitted}(")), "{asked}");
        let done = smartbed(&[
            "derive",
            "pendulum",
            "--answers",
            &format!("{asked}=rates,bias"),
            "-o",
            &file,
            "--json",
        ]);
        assert!(done.json()["operations"][emitted].is_number(), "{done:?}");
    }
    // Characters that no name has are no other name.
    let done = smartbed(&["derive", "tile", "--answers", "pose:platform", "-o", &file]);
    assert!(!done.err.contains("is emitted as"), "{done:?}");
}

#[test]
fn the_kinematic_form_needs_no_masses() {
    let model = model("fourbar");
    let section = |name: &str| {
        let from = model.find(name).expect("the section");
        from..from + model[from..].find("\n[").map_or(model.len() - from, |n| n + 1)
    };
    let mut bare = model.clone();
    let mut sections = [section("[bodies]"), section("[torques]")];
    sections.sort_by_key(|range| std::cmp::Reverse(range.start));
    sections.into_iter().for_each(|range| bare.replace_range(range, ""));
    let path = written("bare.toml", &bare.replace("name = \"fourbar\"", "name = \"bare\""));
    // Without the lines of the model that comments name: the sections before them are gone.
    let functions = |text: &str| {
        let lines = text[text.find("pub fn speeds").expect("speeds")..].lines();
        lines.filter_map(|line| line.split(" // ").next().map(str::to_owned)).collect::<Vec<_>>()
    };
    let done = smartbed(&["derive", &path, "--form", "kinematic"]);
    assert_eq!(done.status, 0, "{done:?}");
    // Masses do not enter: the functions are those of the complete model but for the unused fields.
    let whole = smartbed(&["derive", "fourbar", "--form", "kinematic"]).out;
    assert_eq!(functions(&done.out), functions(&whole));
    let out = file("bare.rs").display().to_string();
    let facts = smartbed(&["derive", &path, "--form", "kinematic", "-o", &out, "--json"]).json();
    assert_eq!(facts["operations"].as_object().map(serde_json::Map::len), Some(3));
    let checked = smartbed(&["check", &path, "--json"]).json();
    assert_eq!(checked["dof"]["found"], 1);
    assert_eq!(checked["cost"].as_array().map(Vec::len), Some(3));
    let done = smartbed(&["derive", &path]);
    assert!(
        done.message().contains("the model has no bodies") && done.err.contains("--form kinematic"),
        "{done:?}"
    );
}

#[test]
fn costs_tell_what_each_answer_adds() {
    let answers = ["--answers", "both=rates,energy", "--answers", "energy"];
    let sheet = smartbed(&[&["derive", "fourbar", "--costs", "--json"][..], &answers].concat()).json();
    let rows = sheet["costs"].as_array().expect("rows");
    let names: Vec<_> = rows.iter().map(|row| [row["function"].as_str(), row["answer"].as_str()]).collect();
    assert_eq!(names, [["both", "rates"], ["both", "energy"], ["energy", "energy"]].map(|row| row.map(Some)));
    let number = |row: usize, name: &str| rows[row][name].as_u64().expect("a number");
    // What the emitted file says of the same functions.
    let out = file("costs.rs").display().to_string();
    let written = smartbed(&[&["derive", "fourbar", "-o", &out, "--json"][..], &answers].concat()).json();
    assert_eq!(number(1, "operations"), written["operations"]["both"]);
    assert_eq!(number(2, "operations"), written["operations"]["energy"]);
    assert_eq!(number(0, "added") + number(1, "added"), number(1, "operations"));
    assert!(number(1, "added") < number(2, "operations"), "energy shares what rates have: {sheet}");
    assert!((2..number(0, "operations")).contains(&number(0, "values_alive")), "{sheet}");
    // Straight lines: an instruction or more an operation, two or four bytes each.
    let has_toolchain = smartbed::firmware::functions::toolchain().is_some();
    for row in rows {
        let chip = &row["chip"];
        assert_eq!(chip.is_object(), has_toolchain, "{sheet}");
        if has_toolchain {
            let cost = ["bytes", "stack", "instructions"].map(|name| chip[name].as_u64().expect("a number"));
            assert!(row["operations"].as_u64() < Some(cost[2]) && chip["has_loops"] == false, "{sheet}");
            assert!(
                (2 * cost[2]..8 * cost[2]).contains(&cost[0]) && 0 < cost[1] && cost[1] < 4096,
                "{sheet}"
            );
        }
    }
    let done = smartbed(&[&["derive", "fourbar", "--costs"][..], &answers].concat());
    assert!(done.out.contains(&format!("+{} = {}", number(1, "added"), number(1, "operations"))), "{done:?}");
    // The four-bar asks for no outputs: nothing to count.
    assert!(!smartbed(&["derive", "fourbar", "--costs"]).out.contains("outputs"));
}

#[test]
fn answers_without_operations_have_costs_too() {
    let model = file("free_point.toml");
    let text = "format = 1\nname = \"free_point\"\ndof = 1\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
         [bodies]\nb = { centre = \"P\", mass = \"2_kg\" }\n";
    std::fs::write(&model, text).expect("written");
    let model = model.display().to_string();
    // The answers of one function after another, two functions of equal code, and a constant.
    for answers in [&["rates,mass_matrix"][..], &["a=bias", "b=bias"], &["mass_matrix"]] {
        let options: Vec<_> = answers.iter().flat_map(|list| ["--answers", list]).collect();
        let sheet = smartbed(&[&["derive", &model, "--costs", "--json"][..], &options].concat()).json();
        for row in sheet["costs"].as_array().expect("rows") {
            let chip = &row["chip"];
            assert_eq!(row["operations"], 0, "{sheet}");
            assert!(
                chip.is_null() || (1..20).contains(&chip["instructions"].as_u64().expect("a number")),
                "{sheet}"
            );
        }
    }
}

#[test]
fn a_derived_crate_compiles_on_its_own() {
    let forms = [("f32", "operations"), ("f64", "accuracy"), ("f64x4", "operations"), ("f64x4", "accuracy")];
    for (scalar, optimise) in forms {
        let folder = file(&format!("fourbar_{scalar}_{optimise}"));
        let path = folder.display().to_string();
        let done =
            smartbed(&["derive", "fourbar", "--scalar", scalar, "--optimise", optimise, "--crate", &path]);
        assert_eq!(done.status, 0, "{done:?}");
        let text = std::fs::read_to_string(folder.join("src/equations.rs")).expect("equations");
        assert_eq!(text.contains("sin_cos_of_difference"), optimise == "accuracy");
        let mut cargo = Command::new(env!("CARGO"));
        // Its dependencies are those of the workspace. That of lanes may be fetched: nothing else here is built with
        // it.
        lock(&folder);
        cargo.args(["check", "--quiet", "--target-dir"]).arg(builds("derived")).current_dir(&folder);
        let done = finish(cargo);
        assert_eq!((done.status, done.err.as_str()), (0, ""), "{scalar}, {optimise}");
    }
}

/// A program that steps a closed loop with projection; the energy comes from the derived equations.
const STEPPED: &str = "
use fourbar::mechanism::Mechanism;
use fourbar::ode::{Driven, Ode, State, rk4, runge_kutta};
use fourbar::{Model, N_INPUTS, NOMINAL, NQ, NU, Parameters};
#[test]
fn a_second() {
    let mut inputs = [0.0; N_INPUTS];
    let law = |_t: f64, _q: &[f64], _u: &[f64], inputs: &mut [f64]| inputs.fill(0.0);
    let mut plant = Driven::new(Model::new(Parameters::default()), law, &mut inputs).unwrap();
    let (mut x, mut low) = ([0.0; NQ + NU], [0.0; NQ + NU]);
    x[..NQ].copy_from_slice(&NOMINAL);
    x[NQ] = 1.0;
    let energy = |x: &[f64]| Model::new(Parameters::default()).energy(&x[..NQ], &x[NQ..]).unwrap();
    let before = energy(&x);
    let mut scratch = [0.0; runge_kutta::rk4_scratch(NQ + NU)];
    let mut state = State::new(&mut x, &mut low).unwrap();
    for n in 0..1000_u16 {
        rk4(&mut plant, 1e-3 * f64::from(n), 1e-3, &mut state, &mut scratch).unwrap();
    }
    let mut end = [0.0; NQ + NU];
    end.copy_from_slice(state.x());
    let after = energy(&end);
    let drift = (after.0 + after.1) - (before.0 + before.1);
    assert!(drift.abs() < 1e-9 * before.0, \"{drift}\");
    assert!((0..NQ).any(|i| 0.1 < (end[i] - NOMINAL[i]).abs()), \"{end:?} has moved\");
    assert!(plant.project(&mut end).unwrap() < 1e-12);
}
";

/// Runs a test, of this name and text, in a derived crate.
fn passes(folder: &Path, name: &str, text: &str) {
    std::fs::create_dir_all(folder.join("tests")).expect("a folder");
    std::fs::write(folder.join(format!("tests/{name}.rs")), text).expect("written");
    lock(folder);
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["test", "--quiet", "--test", name, "--target-dir"]).arg(builds("derived"));
    cargo.current_dir(folder);
    let done = finish(cargo);
    assert_eq!(done.status, 0, "{done:?}");
}

#[test]
fn a_derived_crate_with_an_integrator_steps_its_mechanism() {
    let folder = file("fourbar_steps");
    let path = folder.display().to_string();
    let done = smartbed(&["derive", "fourbar", "--crate", &path, "--integrator"]);
    assert_eq!(done.status, 0, "{done:?}");
    passes(&folder, "stepped", STEPPED);
    // Without a folder there is no crate, and what is not u' cannot be stepped.
    let done = smartbed(&["derive", "fourbar", "--integrator"]);
    assert!(done.status == 1 && done.err.contains("--crate"), "{done:?}");
    let done = smartbed(&["derive", "fourbar", "--crate", &path, "--integrator", "--form", "kinematic"]);
    assert!(done.status == 1 && done.err.contains("only the form that gives u'"), "{done:?}");
}

/// A program that starts on the constraints of a slider-crank, by the constants of its crate.
const STARTED: &str = "
use slide::{START_Q, START_U, q, u};
#[test]
fn the_start_is_a_motion() {
    let [speed_q, speed_b, speed_x] = [START_U[u::u_q], START_U[u::u_b], START_U[u::u_x]];
    assert!((speed_q - 3.0).abs() < 1e-12, \"{START_U:?}\");
    let across = 0.1 * START_Q[q::q].cos() * speed_q + 0.3 * START_Q[q::b].cos() * speed_b;
    let along = 0.1 * START_Q[q::q].sin() * speed_q + 0.3 * START_Q[q::b].sin() * speed_b + speed_x;
    assert!(across.abs() < 1e-14 && along.abs() < 1e-14, \"{across} {along}\");
}
";

/// Also where all speeds are state and one of them is stated.
#[test]
fn a_derived_crate_has_the_start_of_its_model() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/slider_crank.toml"));
    let text = text.expect("it is shipped");
    let model = text
        .replace("independent = true, nominal = \"60*deg\"", "nominal = \"60*deg\"")
        .replace("x = { unit = \"m\", nominal", "x = { unit = \"m\", independent = true, nominal")
        .replace("u_q = 20", "u_q = 3")
        .replace("\"slider_crank\"", "\"slide\"");
    let (model, folder) = (written("slide.toml", &model), file("slide"));
    let done = smartbed(&["derive", &model, "--crate", &folder.display().to_string()]);
    assert_eq!(done.status, 0, "{done:?}");
    passes(&folder, "started", STARTED);
}

/// Bars for compiling a derived crate: processor time (s), and share of that of the one library it depends on, libm, in
/// the same minutes. This takes 2 s on a quiet core; on a busy one a time alone tells more of what else it does.
const COMPILED: [f64; 2] = [0.5, 0.25];

#[test]
fn a_derived_crate_compiles_in_half_a_second_of_processor_time() {
    // The numbers of the runtime, which stand beside the equations, are compiled with them.
    for model in ["tile", "arm6", "bicycle", "pendulum10"] {
        let folder = file(&format!("{model}_timed"));
        let done = smartbed(&["derive", model, "--crate", &folder.display().to_string()]);
        assert_eq!(done.status, 0, "{done:?}");
        lock(&folder);
        let compile = |build: &str| {
            let mut shell = Command::new("sh");
            shell.args(["-c", build]).current_dir(&folder).env("CARGO", env!("CARGO"));
            shell.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "2").env("CARGO_TARGET_DIR", builds("timed"));
            let done = finish(shell);
            assert_eq!((done.status, done.err.as_str()), (0, ""), "{model}");
            children_seconds(&done.out)
        };
        let own = || compile("touch src/lib.rs && \"$CARGO\" build --quiet --release && times");
        let library = || {
            // The shell that cleans is not the one that counts.
            compile(
                "\"$CARGO\" clean --quiet --release -p libm && sh -c '\"$CARGO\" build --quiet --release -p libm && times'",
            )
        };
        // The first compiles libm too.
        own();
        let mut fastest = least_time(COMPILED[0], 15, own);
        println!("{model}: {fastest:.2} s");
        if fastest > COMPILED[0] {
            let mut of_library = f64::INFINITY;
            let share = least_time(COMPILED[1], 4, || {
                (fastest, of_library) = (fastest.min(own()), of_library.min(library()));
                fastest / of_library
            });
            println!("{model}: {share:.2} of libm's {of_library:.2} s");
            assert!(share <= COMPILED[1], "{model}: {fastest} s, libm {of_library} s");
        }
    }
}

/// A mechanism of numbers alone has no parameters that could be changed.
#[test]
fn a_derived_crate_without_parameters_compiles_without_a_warning() {
    let model = "format = 1\nname = \"plain\"\n[inputs]\nF = { unit = \"N\" }\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
        [bodies]\nb = { centre = \"P\", mass = 2 }\n[forces]\nf = { point = \"P\", force = \"F*N.x\" }\n\
        [outputs]\na = \"atan2(-0.7_m, x)\"\nb = \"min(-0.5_m, x)\"\nc = \"max(x, -0.5_m)\"\n";
    let model = written("plain.toml", model);
    for more in [&[][..], &["--scalar", "f32", "--integrator"]] {
        let folder = file(&format!("plain_{}", more.len()));
        let done = smartbed(&[&["derive", &model, "--crate", &folder.display().to_string()], more].concat());
        assert_eq!(done.status, 0, "{done:?}");
        lock(&folder);
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["check", "--quiet", "--target-dir"]).arg(builds("derived")).current_dir(&folder);
        let done = finish(cargo);
        assert_eq!((done.status, done.err.as_str()), (0, ""), "{more:?}");
    }
}

#[test]
fn a_derived_crate_with_thousands_of_values_builds_with_debugging_information() {
    let folder = file("arm6_linearised");
    let path = folder.display().to_string();
    let done = smartbed(&["derive", "arm6", "--answers", "linearisation", "--crate", &path]);
    assert_eq!(done.status, 0, "{done:?}");
    lock(&folder);
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--target-dir"]).arg(builds("derived")).current_dir(&folder);
    // As for a user, whatever this build was told.
    cargo.env("CARGO_PROFILE_DEV_DEBUG", "2");
    let done = finish(cargo);
    assert_eq!((done.status, done.err.as_str()), (0, ""));
}

/// A crate of equations in f32, with the workspace's lock file: its versions are at hand without a network.
fn derived_crate(model: &str) -> std::path::PathBuf {
    let folder = file(&format!("{model}_chip"));
    let done = smartbed(&["derive", model, "--scalar", "f32", "--crate", &folder.display().to_string()]);
    assert_eq!(done.status, 0, "{done:?}");
    lock(&folder);
    folder
}

/// Builds a crate for a core without an operating system; `core` itself from source where the tool-chain lacks it.
fn build_for(target: &str, folder: &std::path::Path) {
    let toolchain = smartbed::firmware::toolchain::toolchain(target).expect("a toolchain");
    let mut cargo = toolchain.cargo();
    cargo.args(["build", "--quiet", "--release", "--target", target, "--target-dir"]).arg(builds("chip"));
    if toolchain.core_from_source {
        cargo.arg("-Zbuild-std=core");
    }
    cargo.env_remove("RUSTFLAGS").current_dir(folder);
    let done = finish(cargo);
    assert_eq!((done.status, done.err.as_str()), (0, ""), "{target}, {}", toolchain.describe());
}

#[test]
fn a_derived_crate_compiles_for_microcontrollers() {
    let folder = derived_crate("tile");
    for target in ["thumbv7em-none-eabihf", "thumbv8m.main-none-eabihf", "riscv32imafc-unknown-none-elf"] {
        build_for(target, &folder);
        let library = builds("chip").join(target).join("release/libtile.rlib");
        assert!(std::fs::metadata(library).expect("a library").len() > 10_000, "{target}");
    }
}

/// Each carries the numbers of the runtime, one symbol of assembly among them: under fat LTO all of it is one module.
#[test]
fn two_derived_crates_link_together() {
    let crates = ["cart_pole", "fourbar"].map(derived_crate);
    let folder = file("both_chip");
    std::fs::create_dir_all(folder.join("src")).expect("a folder");
    let manifest = format!(
        "[package]\nname = \"both\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[lib]\ncrate-type = [\"staticlib\"]\n\
         [dependencies]\ncart_pole = {{ path = {:?} }}\nfourbar = {{ path = {:?} }}\n\
         [profile.release]\npanic = \"abort\"\nlto = \"fat\"\n[workspace]\n",
        crates[0], crates[1]
    );
    std::fs::write(folder.join("Cargo.toml"), manifest).expect("written");
    let root = "#![no_std]\nuse cart_pole::real::Real as A;\nuse fourbar::real::Real as B;\n#[panic_handler]\n\
        fn stop(_: &core::panic::PanicInfo) -> ! {\n    loop {}\n}\n#[unsafe(no_mangle)]\n\
        pub extern \"C\" fn both(x: f32) -> f32 {\n    A::sqrt(x) + B::sqrt(x + 1.0)\n}\n";
    std::fs::write(folder.join("src/lib.rs"), root).expect("written");
    lock(&folder);
    build_for("thumbv7em-none-eabihf", &folder);
}

#[test]
fn every_command_has_help_with_an_example() {
    for name in ["check", "derive", "eval", "run", "firmware"] {
        let done = smartbed(&[name, "--help"]);
        assert_eq!(done.status, 0);
        assert!(done.out.contains("Example") && done.out.contains("--json"), "{name}: {}", done.out);
    }
    assert_eq!(smartbed(&["--version"]).status, 0);
}

#[test]
fn models_are_found_by_name_from_any_folder_below() {
    let mut below = command(&["check", "pendulum"]);
    below.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/check"));
    assert_eq!(finish(below).status, 0);
    let done = smartbed(&["check", "pendulum33"]);
    assert!(done.message().contains("did you mean `pendulum3`?"), "{done:?}");
}

#[test]
fn a_wrong_command_line_is_a_wrong_input() {
    for arguments in [&["frob"][..], &["run"], &["run", "tile", "--method", "magic"], &["eval", "tile"], &[]]
    {
        let done = smartbed(arguments);
        assert_eq!(done.status, 1, "{arguments:?} {done:?}");
        assert!(!done.err.is_empty());
    }
}
