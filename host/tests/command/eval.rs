//! `eval`: solved coordinates, engines with equal bits, messages with places.

use crate::support::{command, eval, finish, numbers, smartbed, written};
use serde_json::Value;

/// A configuration of the four-bar linkage away from nominal, only the crank given.
const CRANK: &str = r#"{"states": [{"q": {"q1": 1.2}, "u": {"u1": 0.7}, "inputs": {"T": 3},
    "parameters": {"m2": 2.5}}]}"#;

fn state(done: &crate::support::Done) -> Value {
    done.json()["states"][0].clone()
}

#[test]
fn left_out_coordinates_close_the_loop() {
    let state = state(&eval("crank.json", "fourbar", CRANK, &[]));
    // The loop in plain words: three links from the origin end at the ground pin (2, 0).
    let q = |name: &str| state["q"][name].as_f64().expect("a number");
    let (lengths, angles) = ([1.0, 2.2, 1.8], [q("q1"), q("q2"), q("q3")]);
    let x: f64 = lengths.iter().zip(angles).map(|(l, a)| l * a.cos()).sum();
    let y: f64 = lengths.iter().zip(angles).map(|(l, a)| l * a.sin()).sum();
    // Sums of three numbers of order one, each rounded.
    assert!((x - 2.0).abs() < 2e-15 && y.abs() < 2e-15, "{x} {y}");
    assert_eq!(q("q1"), 1.2);
    assert!(state["constraint_residual"].as_f64().expect("a number") < 2e-15);
    for key in ["q", "q_dot"] {
        assert_eq!(state[key].as_object().map(serde_json::Map::len), Some(3), "{key}");
    }
    for key in ["u", "u_dot"] {
        assert_eq!(state[key].as_object().map(serde_json::Map::len), Some(1), "{key}");
    }
    assert!(state["energy"]["kinetic"].as_f64().expect("a number") > 0.0);
    assert!(state["energy"]["potential"].is_f64() && state["outputs"].is_object());
}

#[test]
fn a_coordinate_where_the_search_began_is_told() {
    let done = eval("began.json", "fourbar", r#"{"states": [{"q": {"q1": 1, "q2": -1.6}}]}"#, &[]);
    assert!(done.err.contains("note: states[0]: `q2` = -1.6 is where the search began"), "{done:?}");
    let done = eval("begins.json", "fourbar", r#"{"states": [{"q": {"q1": 1}}]}"#, &[]);
    assert!(!done.err.contains("note:"), "{done:?}");
}

#[test]
fn dependent_coordinates_beside_left_out_ones_choose_the_branch() {
    // The rocker folded to the other side: the mirror image about the line from crank pin to ground.
    let nominal = state(&eval("near.json", "fourbar", r#"{"states": [{"q": {"q1": 1}}]}"#, &[]));
    let other = state(&eval("far.json", "fourbar", r#"{"states": [{"q": {"q1": 1, "q2": -1.6}}]}"#, &[]));
    let q2 = |s: &Value| s["q"]["q2"].as_f64().expect("a number");
    assert!((q2(&nominal) - q2(&other)).abs() > 1.0, "{nominal} {other}");
    assert!(other["constraint_residual"].as_f64().expect("a number") < 2e-15);
}

#[test]
fn a_complete_configuration_is_never_altered() {
    let given = r#"{"states": [{"q": {"q1": 1.0, "q2": 0.4, "q3": -1.9}}]}"#;
    let state = state(&eval("complete.json", "fourbar", given, &[]));
    assert_eq!(numbers(&state["q"]), [1.0, 0.4, -1.9]);
    // It does not close, and the answer says so.
    assert!(state["constraint_residual"].as_f64().expect("a number") > 1e-3);
}

#[test]
fn euler_parameters_of_another_length_are_told_of_by_name() {
    let of = |e0: &str| {
        let text =
            format!(r#"{{"states": [{{"q": {{"tip_e0": {e0}, "tip_e1": 0, "tip_e2": 0, "tip_e3": 0}}}}]}}"#);
        eval("euler_parameters.json", "spinning_top", &text, &[])
    };
    let said = "tip_e0, tip_e1, tip_e2, tip_e3 are the components of a unit vector, but its length is 2.000000; expected 1";
    let long = of("2");
    assert!(long.status == 0 && long.err.contains(said), "{long:?}");
    assert_eq!(of("1").err, "");
}

#[test]
fn a_singular_place_is_told_of_whatever_is_asked() {
    // A disc that lies on its side: yaw and spin are one turn there, and cos(pi/2) is 6e-17.
    let lying =
        r#"{"states": [{"q": {"x": 0, "y": 0, "yaw": 0.3, "lean": LEAN, "spin": 0}, "u": {"u3": 0.4}}]}"#;
    for (lean, singular) in [("1.5707963267948966", true), ("1.5", false)] {
        for answers in ["mass_matrix", "rates"] {
            let states = lying.replace("LEAN", lean);
            let done = eval("lying.json", "rolling_disc", &states, &["--answers", answers]);
            // Not one digit of the accelerations would be certain; the mass matrix needs none.
            let refused = singular && answers == "rates";
            assert_eq!(done.status, i32::from(refused), "{done:?}");
            assert_eq!(
                done.err.contains("smallest pivot is 6.1e-17 of its nominal size"),
                singular,
                "{done:?}"
            );
        }
    }
}

#[test]
fn both_engines_give_the_same_bytes() {
    for scalar in ["f32", "f64"] {
        let name = format!("bits_{scalar}.json");
        let run = |engine| eval(&name, "fourbar", CRANK, &["--scalar", scalar, "--engine", engine]);
        let (interpreted, compiled) = (run("interpreter"), run("compiled"));
        assert_eq!((interpreted.status, compiled.status), (0, 0), "{compiled:?}");
        assert_eq!(interpreted.out, compiled.out, "{scalar}");
    }
}

#[test]
fn without_a_compiler_the_message_names_one() {
    // A model with a name of its own for this process: its library cannot be in the cache.
    let models = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let text = std::fs::read_to_string(models.join("pendulum3.toml")).expect("a model");
    let model = written("unique.toml", &text.replace("pendulum3", &format!("unique_{}", std::process::id())));
    let states = written("rest.json", r#"{"states": [{"q": {"q0": 0, "q1": 0, "q2": 0}}]}"#);
    let mut command = command(&["eval", &model, "--states", &states, "--engine", "compiled"]);
    command.env("PATH", "/nonexistent");
    let done = finish(command);
    assert_eq!(done.status, 2, "{done:?}");
    assert!(done.err.contains("apt-get install") && done.err.contains("--engine interpreter"), "{done:?}");
}

#[test]
fn fixed_parameters_may_be_named() {
    // A payload on the tile, folded away by default, makes it heavier: more force for the same rest.
    let at = |mass: &str| {
        let states = format!(
            r#"{{"states": [{{"q": {{"hA": 0, "hB": 0, "hC": 0}}, "parameters": {{"m_payload": {mass}}}}}]}}"#
        );
        state(&eval(&format!("payload{mass}.json"), "tile", &states, &[]))["u_dot"]["u_hA"]
            .as_f64()
            .expect("a number")
    };
    // Weight over inertia; the reflected inertia of the drives has none: falling faster with payload.
    let fall = |payload: f64| {
        let weight = 3.0 * (0.8 + 0.15) + 6.0 + payload;
        -9.81 * weight / (weight + 3.0 * 2.0)
    };
    for (mass, payload) in [("0", 0.0), ("2.5", 2.5)] {
        let found = at(mass);
        assert!((found - fall(payload)).abs() < 1e-13 * fall(payload).abs(), "{found} {}", fall(payload));
    }
}

#[test]
fn mistakes_are_explained_where_they_were_made() {
    let cases = [
        (
            r#"{"states": [{"q": {"q1": 1}}, {"q": {"q9": 1}}]}"#,
            "states[1]: q: the model has no coordinate `q9`",
        ),
        (r#"{"states": [{"q": {}}]}"#, "the independent coordinate `q1` is left out"),
        (
            r#"{"states": [{"q": {"q1": 1}, "u": {"u2": 1}}]}"#,
            "the speed `u2` is dependent: it follows from u1",
        ),
        (r#"{"states": [{"q": {"q1": 1}, "inputs": {"t": 1}}]}"#, "did you mean `T`?"),
        (r#"{"states": [{"q": {"q1": 1}, "parameters": {"mm": 1}}]}"#, "no parameter `mm`"),
        (
            r#"{"states": [{"q": {"q1": 1}, "parameters": {"l2": 0.01}}]}"#,
            "states[0]: the dependent coordinates",
        ),
        (r#"{"states": [{"q": {"q1": "1"}}]}"#, "states[0].q.q1: expected a number"),
        (r#"{"states": ["#, "not JSON"),
    ];
    for (number, (states, message)) in cases.into_iter().enumerate() {
        let done = eval(&format!("mistake{number}.json"), "fourbar", states, &[]);
        assert!(done.message().contains(message), "{states}: {done:?}");
    }
    let unreachable =
        eval("far_away.json", "fourbar", r#"{"states": [{"q": {"q1": 1}, "parameters": {"l4": 9}}]}"#, &[]);
    assert!(unreachable.message().contains("residual of"), "{unreachable:?}");
}

#[test]
fn what_cannot_be_reached_is_told_with_its_least_residual() {
    // A rod of 1 m between (b, 0) and (0, 2 - 2 cos a): at a = 1.5 it is 0.858526 m too short, wherever b is.
    let model = written(
        "rod.toml",
        "format = 1\nname = \"rod\"\n[coordinates]\na = { unit = \"rad\", independent = true, nominal = 0.5 }\n\
         b = { unit = \"m\", nominal = 0.97 }\n[points]\nP = \"b*N.x\"\nQ = \"2_m*(1 - cos(a))*N.y\"\n\
         [bodies]\np = { centre = \"P\", mass = 1 }\nq = { centre = \"Q\", mass = 1 }\n\
         [constraints.configuration]\nrod = \"norm(P - Q) - 1_m\"\n",
    );
    let states = written("rod.json", r#"{"states": [{"q": {"a": 1.5}}]}"#);
    let done = smartbed(&["eval", &model, "--states", &states]);
    assert!(
        done.message().contains("a constraint residual of 8.6e-1 is left, the largest in `rod`"),
        "{done:?}"
    );
    // The rod of the four-bar linkage reaches nowhere near its end.
    let states = written("long.json", r#"{"states": [{"parameters": {"l4": 9}, "q": {"q1": 1}}]}"#);
    let done = smartbed(&["eval", "fourbar", "--states", &states]);
    let residual = done.message().split("residual of ").nth(1).and_then(|rest| rest.split(' ').next());
    let residual: f64 = residual.and_then(|text| text.parse().ok()).unwrap_or(0.0);
    assert!((3.0..6.0).contains(&residual), "{done:?}");
}

#[test]
fn singular_states_are_named() {
    // A rod without length turns as it likes. (One without mass at its tip does not: there the mass cancels.)
    let states = r#"{"states": [{"q": {"q0": 0.1, "q1": 0.2, "q2": 0.3}, "parameters": {"l2": 0}}]}"#;
    let done = eval("no_length.json", "pendulum3", states, &[]);
    assert!(done.message().contains("states[0]: ") && done.err.contains("not finite"), "{done:?}");
}

#[test]
fn answers_may_be_chosen() {
    let done = eval("chosen.json", "fourbar", CRANK, &["--answers", "energy,speeds"]);
    let keys: Vec<String> = state(&done).as_object().expect("an object").keys().cloned().collect();
    assert_eq!(keys, ["energy", "q", "speeds", "u"]);
    let done = eval("chosen.json", "fourbar", CRANK, &["--answers", "energie"]);
    assert!(done.message().contains("did you mean `energy`?"), "{done:?}");
    // Two members of one name are no JSON.
    for twice in [&["--answers", "rates,energy,rates"][..], &["--answers", "rates", "--answers", "rates"]] {
        let done = eval("chosen.json", "fourbar", CRANK, twice);
        assert!(done.message().contains("`answers` asks for `rates` twice"), "{done:?}");
    }
}

#[test]
fn answers_that_messages_advise_exist() {
    let done =
        eval("rolling.json", "rolling_disc", r#"{"states": [{"q": {}}]}"#, &["--answers", "multipliers"]);
    assert!(done.message().contains("`derive --form augmented`"), "{done:?}");
    let out = crate::support::file("rolling.rs").display().to_string();
    let derived = smartbed(&["derive", "rolling_disc", "--form", "augmented", "-o", &out]);
    assert_eq!(derived.status, 0, "{derived:?}");
}

#[test]
fn answers_on_request_are_those_of_both_engines() {
    let states = "{\"states\": [{\"q\": {\"hA\": 0.01, \"hB\": 0, \"hC\": 0.02}, \"u\": {\"u_hA\": 0.1},\
                  \"inputs\": {\"FA\": 30, \"platform_force_z\": -20}, \"u_dot\": {\"u_hB\": 0.5}}]}";
    let path = written("on_request.json", states);
    let ask = |engine: &str, scalar: &str| {
        let answers =
            ["--answers", "inverse_dynamics,port:platform,energy", "--engine", engine, "--scalar", scalar];
        smartbed(&[&["eval", "tile", "--states", &path], &answers[..]].concat())
    };
    for scalar in ["f32", "f64"] {
        let (interpreted, compiled) = (ask("interpreter", scalar), ask("compiled", scalar));
        assert_eq!((interpreted.status, compiled.status), (0, 0), "{compiled:?}");
        assert_eq!(interpreted.out, compiled.out, "{scalar}");
    }
    let state = state(&ask("interpreter", "f64"));
    let port = &state["port:platform"];
    assert_eq!(port["inverse_inertia"][5].as_array().expect("a row").len(), 6);
    assert!((port["position"]["z"].as_f64().expect("a number") - 0.01).abs() < 1e-3, "{state}");
    // The wrench is given: the motors carry it too.
    let lift: f64 = ["u_hA", "u_hB", "u_hC"]
        .map(|u| state["inverse_dynamics"]["generalised_force"][u].as_f64().expect("a number"))
        .iter()
        .sum();
    // By virtual work of all screws moving as one: weight, wrench, inertia of one screw at 0.5 m/s^2 with its share of
    // the platform, friction of another at 0.1 m/s. The tilt of 0.1 rad leaves it so but for the turning of the
    // platform.
    let expected = 9.81 * (6.0 + 3.0 * 0.95) + 20.0 + 0.5 * (2.95 + 6.0 / 3.0) + 40.0 * 0.1;
    assert!((lift - expected).abs() < 0.05, "{lift} {expected}");
    let without = written("without.json", &states.replace(", \"u_dot\": {\"u_hB\": 0.5}", ""));
    let refused = smartbed(&["eval", "tile", "--states", &without]);
    assert!(refused.message().contains("platform_force_z"), "{refused:?}");
}

#[test]
fn files_and_standard_output_hold_the_same() {
    let path = crate::support::file("out.json").display().to_string();
    let states = written("same.json", CRANK);
    let done = smartbed(&["eval", "fourbar", "--states", &states, "-o", &path, "--json"]);
    assert_eq!(done.json()["states"], 1);
    let to_file = std::fs::read_to_string(&path).expect("written");
    assert_eq!(to_file, smartbed(&["eval", "fourbar", "--states", &states]).out);
}

#[test]
fn coordinates_in_closed_form_are_answered_and_may_be_given() {
    let text = r#"{"states": [{"q": {"q": 0.9}, "u": {"u_q": 2}}]}"#;
    for scalar in ["f64", "f32"] {
        let done = eval("closed.json", "slider_crank_closed", text, &["--scalar", scalar]);
        let closed = state(&done);
        // The same mechanism with its loop solved by Newton.
        let solved = state(&eval("closed.json", "slider_crank", text, &[]));
        for group in ["q", "q_dot"] {
            for name in ["q", "b", "x"] {
                let number = |state: &Value| state[group][name].as_f64().expect("a number");
                let tolerance = if scalar == "f64" { 1e-14 } else { 1e-6 };
                assert!((number(&closed) - number(&solved)).abs() < tolerance, "{group} {name}: {done:?}");
            }
        }
        // An answer is a question again.
        let again = format!("{{\"states\": [{{\"q\": {}, \"u\": {}}}]}}", closed["q"], closed["u"]);
        let again = eval("closed_again.json", "slider_crank_closed", &again, &["--scalar", scalar]);
        assert_eq!(state(&again), closed);
    }
    let wrong = r#"{"states": [{"q": {"q": 0.9, "b": 0.3}}]}"#;
    let done = eval("closed_wrong.json", "slider_crank_closed", wrong, &[]);
    assert!(done.message().contains("`b` is -0.26") && done.message().contains("leave it out"), "{done:?}");
}

#[test]
fn ports_are_answered_beside_coordinates_in_closed_form() {
    // The same tile, with its legs in closed form and with loops solved by Newton.
    let text =
        r#"{"states": [{"q": {"hA": 0.01, "hB": 0, "hC": 0.02}, "inputs": {"platform_force_z": -20}}]}"#;
    let port = |model: &str| {
        let done = eval(&format!("port_{model}.json"), model, text, &["--answers", "port:platform"]);
        state(&done)["port:platform"].clone()
    };
    let numbers = |port: &Value| {
        let place = ["x", "y", "z"].map(|axis| port["position"][axis].clone());
        let row = port["inverse_inertia"][2].as_array().expect("a row");
        let number = |value: &Value| value.as_f64().expect("a number");
        place.iter().chain(row).map(number).collect::<Vec<f64>>()
    };
    let [closed, solved] = ["tile_minimal", "tile"].map(|model| numbers(&port(model)));
    assert_eq!(closed.len(), 9);
    for (closed, solved) in closed.iter().zip(&solved) {
        assert!((closed - solved).abs() < 1e-14, "{closed:e} {solved:e}");
    }
}

#[test]
fn parameters_at_which_a_mass_is_negative_are_refused() {
    let text = "format = 1\nname = \"less\"\n[parameters]\nm = { value = 1, unit = \"kg\" }\ndm = { value = 0.2, unit = \"kg\" }\n\
        [inputs]\nF = { unit = \"N\" }\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
        [bodies]\nb = { centre = \"P\", mass = \"m - dm\" }\n[forces]\nf = { point = \"P\", force = \"F*N.x\" }\n";
    let model = written("less.toml", text);
    let at = |m: &str| {
        let states = format!(
            "{{\"states\": [{{\"q\": {{\"x\": 0}}, \"inputs\": {{\"F\": 1}}, \"parameters\": {{\"m\": {m}}}}}]}}"
        );
        eval("less.json", &model, &states, &[])
    };
    let rate = state(&at("0.7"))["u_dot"]["u_x"].as_f64().expect("a number");
    assert!((rate - 2.0).abs() < 1e-15, "{rate}");
    let done = at("0.1");
    assert_eq!(done.status, 1, "{done:?}");
    assert!(
        done.err.contains("states[0]: parameters: the mass of `b` is negative (-0.1 kg)"),
        "{}",
        done.err
    );
}

#[test]
fn speeds_that_violate_the_constraints_are_told_of() {
    // A slider crank whose crank passes dead points: all speeds are in the state.
    let text = "format = 1\nname = \"dead\"\n[coordinates]\nq = { unit = \"rad\", nominal = 1, range = [-1, 3.2] }\n\
        x = { unit = \"m\", independent = true, nominal = 1.0, range = [0.7, 1.3] }\nb = { unit = \"rad\", nominal = -0.3, range = [-1, 1] }\n\
        [frames]\ncr = { rotations = [[\"z\", \"q\"]] }\nro = { rotations = [[\"z\", \"b\"]] }\n\
        [points]\nA = \"0.3_m*cr.x\"\nB = \"A + 1_m*ro.x\"\n\
        [bodies]\nc = { centre = \"A\", frame = \"cr\", mass = 1, inertia = { Izz = 0.1 } }\np = { centre = \"B\", mass = 2 }\n\
        [constraints.configuration]\nl = \"B - x*N.x\"\n";
    let model = written("dead_points.toml", text);
    let at = |u: &str| {
        eval("dead.json", &model, &format!("{{\"states\": [{{\"q\": {{\"x\": 1.1}}, \"u\": {u}}}]}}"), &[])
    };
    let done = at("{\"u_q\": 1, \"u_x\": 5, \"u_b\": 3}");
    assert!(
        done.status == 0 && done.err.contains("the speeds do not satisfy the constraints: `u_"),
        "{done:?}"
    );
    assert!(!at("{\"u_x\": 0.2}").err.contains("the speeds do not satisfy"));
}

/// What `run --set` says of a parameter, `eval` says of a state with it, and both say nothing of its default.
#[test]
fn what_a_run_refuses_at_other_parameters_a_state_refuses() {
    let head = "format = 1\nname = \"p\"\n[parameters]\nk = 2\nl = { value = 0.5, unit = \"m\" }\n";
    let tail = "[bodies]\nb = { centre = \"P\", mass = 1 }\n";
    let q = "[coordinates]\nq = { unit = \"rad\", independent = true }\n";
    let x = "x = { unit = \"rad\", speed = { independent = false } }\n";
    let turned = "[frames]\nf = { rotations = [[\"z\", \"x\"]] }\n[points]\nP = \"l*f.x\"\n";
    let driven = turned.replace("l*f.x", "l*f.x + 1_m*q*N.z");
    let cases = [
        // A motion constraint that follows from another, or from the configuration.
        (
            format!("{q}{x}{turned}[constraints.motion]\na = \"u_x - 2*u_q\"\nb = \"u_x - k*u_q\"\n"),
            "`b` makes them",
        ),
        (
            format!(
                "{q}x = {{ unit = \"rad\" }}\n{turned}[constraints.configuration]\na = \"x - 2*q\"\n[constraints.motion]\n\
                 b = \"u_x - k*u_q\"\n"
            ),
            "`b` makes them dependent",
        ),
        // Two drives.
        (
            format!(
                "{q}x = {{ unit = \"rad\" }}\n{driven}[constraints.configuration]\na = \"x - 2/1_s*t\"\n\
                 b = \"x - k/1_s*t\"\n"
            ),
            "`b` prescribes a motion that the other constraints do not allow",
        ),
        // Axes.
        (
            format!(
                "{q}[frames.f]\nx = \"cos(q)*N.x + k/2*sin(q)*N.y\"\ny = \"-k/2*sin(q)*N.x + cos(q)*N.y\"\n[points]\n\
                 P = \"l*f.x\"\n"
            ),
            "the axes of frame `f` are not orthonormal",
        ),
        // A closed form.
        (
            format!(
                "{q}x = {{ unit = \"rad\", closed_form = \"2*q\" }}\n{turned}[constraints.configuration]\na = \"x - k*q\"\n"
            ),
            "the closed forms contradict `a`",
        ),
    ];
    for (n, (body, refusal)) in cases.iter().enumerate() {
        let model = written(&format!("at_other_{n}.toml"), &format!("{head}{body}{tail}"));
        let given = if n == 0 { "\"q\": 0.3, \"x\": 0.6" } else { "\"q\": 0.3" };
        let at = |k: f64| {
            let states = format!(
                "{{\"states\": [{{\"q\": {{{given}}}, \"parameters\": {{\"k\": {k}, \"l\": 0.4}}}}]}}"
            );
            eval(&format!("at_other_{n}.json"), &model, &states, &[])
        };
        let run = smartbed(&["run", &model, "--set", "k=3", "--seconds", "0"]);
        let words =
            run.message().lines().next().and_then(|line| line.strip_prefix("error: ")).expect("a line");
        assert!(words.contains(refusal), "{n}: {run:?}");
        let done = at(3.0);
        assert_eq!(done.status, 1, "{n}: {done:?}");
        assert!(done.err.contains(&format!("states[0]: parameters: {words}")), "{n}: {done:?}");
        let done = at(2.0);
        assert_eq!(done.status, 0, "{n}: {done:?}");
    }
}

#[test]
fn a_constraint_that_no_longer_follows_is_named() {
    for given in ["\"q1\": 1", "\"q1\": 1, \"q2\": 0, \"q3\": 1, \"q4\": 1"] {
        let at = |a: f64| {
            let states = format!(
                "{{\"states\": [{{\"q\": {{{given}}}, \"parameters\": {{\"a\": {a}, \"a3\": 0.31}}}}]}}"
            );
            eval("third_crank.json", "parallelogram", &states, &[])
        };
        let done = at(0.3);
        assert_eq!(done.status, 1, "{done:?}");
        assert!(
            done.err.contains("states[0]: parameters: `two` no longer follows from the other constraints"),
            "{done:?}"
        );
        assert_eq!(at(0.31).status, 0);
    }
}

#[test]
fn each_constraint_is_judged_by_its_own_terms() {
    for (length, off, said) in [
        ("1", 1.0, ""),
        // Six decimals.
        ("1", 1.000_000_4, ""),
        (
            "1",
            1.000_01,
            "is left in `rod`, 2e-5 of its terms, and its accelerations are those of the violated",
        ),
        (
            "1",
            1.01,
            "a residual of 1.0e-2 is left in `rod`, 2e-2 of its terms, and its accelerations have no meaning",
        ),
        ("0.01", 1.01, "a residual of 1.0e-4 is left in `rod`, 2e-2 of its terms"),
        ("1e-5", 1.01, "a residual of 1.0e-7 is left in `rod`, 2e-2 of its terms"),
    ] {
        let text = format!(
            "format = 1\nname = \"rod\"\n[parameters]\nl = {{ value = {length}, unit = \"m\" }}\n[coordinates]\n\
             x = {{ unit = \"m\", independent = true, nominal = \"0.6*l\", range = [\"-0.9*l\", \"0.9*l\"] }}\n\
             y = {{ unit = \"m\", nominal = \"-0.8*l\", range = [\"-1.2*l\", 0] }}\n[points]\nP = \"x*N.x + y*N.y\"\n\
             [bodies]\nb = {{ centre = \"P\", mass = 1 }}\n[constraints.configuration]\nrod = \"norm(P) - l\"\n"
        );
        let model = written("own_terms.toml", &text);
        let size: f64 = length.parse().expect("a number");
        let states = format!(
            "{{\"states\": [{{\"q\": {{\"x\": {:e}, \"y\": {:e}}}}}]}}",
            0.6 * size * off,
            -0.8 * size * off
        );
        let done = eval("own_terms.json", &model, &states, &[]);
        assert_eq!(done.status, 0, "{done:?}");
        assert!(
            done.err.contains(said) && done.err.is_empty() == said.is_empty(),
            "{length}, {off}: {done:?}"
        );
    }
}

/// Where all cranks lie along the bar, another branch crosses: u' = -g cos(q1)/a as everywhere, but the coordinates
/// that are solved for are good to half of their digits there.
#[test]
fn coordinates_solved_for_at_a_change_point_are_told_of() {
    let text = crate::support::model("parallelogram").replace("[0.3, 2.5]", "[-0.5, 4]");
    let model = written("change_point.toml", &text);
    for (q1, singular) in [
        ("0", true),
        ("1e-8", true),
        ("1e-6", true),
        ("1e-5", true),
        ("3.141592653589793", true),
        ("0.01", false),
    ] {
        let done =
            eval("change.json", &model, &format!("{{\"states\": [{{\"q\": {{\"q1\": {q1}}}}}]}}"), &[]);
        assert_eq!(
            done.err.contains("states[0]: the configuration is singular or nearly so"),
            singular,
            "{q1}: {done:?}"
        );
        // Where not one digit is certain there is no number; near by some are, and their number is told.
        let none = done.err.contains("not one digit of the accelerations is certain");
        assert_eq!(
            (done.status != 0, none),
            (singular && q1 != "1e-5", singular && q1 != "1e-5"),
            "{q1}: {done:?}"
        );
        assert_eq!(done.err.contains("some 3 digits are certain"), q1 == "1e-5", "{q1}: {done:?}");
        if !singular {
            let rate = state(&done)["u_dot"]["u_q1"].as_f64().expect("a number");
            let right = -9.81 * 0.01_f64.cos() / 0.3;
            assert!((rate / right - 1.0).abs() < 1e-9, "{rate} instead of {right}");
        }
    }
}

#[test]
fn outputs_that_are_not_finite_are_named() {
    let text = "format = 1\nname = \"p\"\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
        [bodies]\nb = { centre = \"P\", mass = 1 }\n[outputs]\nangle = \"asin(x/1_m)\"\nplace = \"x\"\n";
    let model = written("arc.toml", text);
    let done = eval("arc.json", &model, r#"{"states": [{"q": {"x": 0.5}}, {"q": {"x": 2}}]}"#, &[]);
    assert!(done.message().contains("states[1]: outputs are not finite: `angle` = NaN; "), "{done:?}");
}

#[test]
fn moments_that_no_body_has_are_told_of_once() {
    let state =
        |z: f64| format!("{{\"q\": {{\"hA\": 0, \"hB\": 0, \"hC\": 0}}, \"parameters\": {{\"Iz\": {z}}}}}");
    let states = format!("{{\"states\": [{}, {}, {}]}}", state(0.17), state(10.0), state(11.0));
    let done = eval("moments.json", "tile", &states, &[]);
    assert_eq!(done.status, 0, "{done:?}");
    let told = "warning: states[1]: parameters: the moments of inertia of `platform` cannot be those of a body (Izz = 10 kg m^2";
    assert!(done.err.starts_with(told) && done.err.matches("warning").count() == 1, "{done:?}");
}
