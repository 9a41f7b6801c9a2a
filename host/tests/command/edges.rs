//! Numbers at their edges: far angles, numbers beyond single precision, a run of less than a step.

use crate::support::{eval, smartbed, written};

/// The pendulum's angle stands in nothing but sines: whole turns make no difference. Oracle: the system's own sine,
/// which reduces every angle exactly.
#[test]
fn far_angles_are_taken_less_whole_turns() {
    for (scalar, rounding) in [("f64", 1e-12), ("f32", 1e-6)] {
        for q in [1e17_f64, -3.7e22, 1e8, 2e6, 1.2345e300] {
            let states =
                format!("{{\"states\": [{{\"q\": {{\"q\": {q:e}}}, \"parameters\": {{\"c\": 0}}}}]}}");
            let done = eval(&format!("far_{scalar}.json"), "pendulum", &states, &["--scalar", scalar]);
            assert_eq!(done.status, 0, "{done:?}");
            let state = &done.json()["states"][0];
            let found = state["u_dot"]["u_q"].as_f64().expect("a number");
            let exact = -9.81 / 0.3 * q.sin();
            assert!((found - exact).abs() < rounding * 9.81 / 0.3, "{scalar} {q:e}: {found} against {exact}");
            assert_eq!(state["q"]["q"].as_f64(), Some(q), "shown as given");
        }
    }
}

const WOUND: &str = r#"
format = 1
name = "wound"
gravity = "-g*N.z"
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 1, unit = "m" }
k = { value = 2, unit = "N m" }
g = { value = 9.81, unit = "m/s^2" }
w = { value = 1, unit = "rad/s" }
[inputs]
T = { unit = "N m" }
[coordinates]
q = { unit = "rad" }
[frames]
rod = { rotations = [["x", "q"]] }
[points]
P = "-l*rod.z"
[bodies]
bob = { centre = "P", mass = "m" }
[springs]
spiral = { coordinate = "q", stiffness = "k", rest = 0 }
[torques]
motor = { frame = "rod", torque = "T*N.x" }
[law]
T = "1_N*l*sin(w*t)"
[start]
q = 0.1
"#;

#[test]
fn far_angles_that_count_turns_are_refused_by_name() {
    let path = written("wound.toml", WOUND);
    for (q, scalar, is_right) in
        [("1e6", "f64", true), ("1e17", "f64", false), ("9e4", "f32", true), ("1e8", "f32", false)]
    {
        let states = format!("{{\"states\": [{{\"q\": {{\"q\": {q}}}}}]}}");
        let done = eval("wound.json", &path, &states, &["--scalar", scalar]);
        assert_eq!(done.status, i32::from(!is_right), "{q} {scalar}: {done:?}");
        if !is_right {
            let words =
                ["states[0]: an angle of 1.000000e", "from `q`", "beyond the domain of sine and cosine"];
            assert!(words.iter().all(|w| done.message().contains(w)), "{done:?}");
        }
    }
    let done = smartbed(&["run", &path, "--seconds", "0.1", "--set", "q=1e17"]);
    assert!(done.message().contains("t = 0.000000 s: an angle of 1.000000e17 rad (from `q`)"), "{done:?}");
    // The law's sine of time has the same domain.
    let done = smartbed(&["run", &path, "--seconds", "0.1", "--set", "w=1e9"]);
    assert!(done.message().contains("(from `t`)"), "{done:?}");
}

#[test]
fn numbers_beyond_single_precision_are_refused_by_name() {
    let states = "{\"states\": [{\"q\": {\"q\": 0.1}, \"parameters\": {\"m\": 1e39}}]}";
    let lines: [&[&str]; 5] = [
        &["derive", "pendulum", "--scalar", "f32", "--set", "m=1e39"],
        &["derive", "pendulum", "--scalar", "f32x8", "--set", "m=1e39"],
        &["derive", "pendulum", "--scalar", "f32", "--set", "m=1e-60"],
        &["run", "pendulum", "--scalar", "f32", "--seconds", "0.01", "--set", "m=1e39"],
        &["firmware", "tile", "--set", "M=1e39"],
    ];
    for line in lines {
        let done = smartbed(line);
        assert!(done.message().contains("beyond single precision"), "{line:?}: {done:?}");
    }
    let done = eval("single.json", "pendulum", states, &["--scalar", "f32"]);
    assert!(done.message().contains("states[0]: `m` = 1e39 is beyond single precision"), "{done:?}");
    let done = smartbed(&["run", "cube", "--scalar", "f32", "--seconds", "0.01", "--set", "mass=1e39"]);
    assert!(done.message().contains("`mass` = 1e39 is beyond single precision"), "{done:?}");
    let done = smartbed(&["derive", "pendulum", "--set", "m=1e39"]);
    assert!(done.status == 0 && !done.out.contains("inf_f"), "{done:?}");
}

/// A mass below 0: whichever command would set it.
#[test]
fn a_parameter_outside_its_range_is_refused_by_every_command() {
    let states = "{\"states\": [{\"q\": {\"q\": 0.1}, \"parameters\": {\"m\": -1}}]}";
    let mut said = vec![eval("range.json", "pendulum", states, &[])];
    for command in ["derive", "run", "firmware"] {
        said.push(smartbed(&[command, "pendulum", "--set", "m=-1"]));
    }
    for done in said {
        assert!(
            done.message().contains("parameter `m` is -1; expected a number from 0 to inf kg"),
            "{done:?}"
        );
        assert_eq!(done.status, 1, "{done:?}");
    }
}

#[test]
fn a_run_shorter_than_a_step_takes_one() {
    for (model, more) in [
        ("pendulum", "--method=rk4"),
        ("pendulum", "--method=dormand-prince"),
        ("single_spring", "--every=5"),
    ] {
        let done = smartbed(&["run", model, "--seconds", "1e-6", "--csv", "-", more]);
        assert_eq!(done.status, 0, "{done:?}");
        let last = done.out.lines().last().and_then(|l| l.split(',').next()?.parse::<f64>().ok());
        assert_eq!((done.out.lines().count(), last), (3, Some(1e-6)), "{model} {more}: {done:?}");
    }
    // The last step of a scene ends where the run does.
    let done = smartbed(&["run", "single_spring", "--seconds", "0.0105", "--csv", "-"]);
    let last: f64 = done.out.lines().last().and_then(|l| l.split(',').next()?.parse().ok()).expect("a row");
    assert!((last - 0.0105).abs() < 1e-15, "{last}");
}
