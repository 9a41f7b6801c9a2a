//! `smartbed equilibrium` where something is stiff, light, singular, repeated or jumps, against closed forms.

use crate::support::{Done, smartbed, written};
use serde_json::Value;

const HEAD: &str = "format = 1\nname = \"case\"\n";
const WEIGHT: &str = "gravity = \"-9.81_m/1_s/1_s*N.z\"\n";

fn model(name: &str, text: &str) -> String {
    written(&format!("{name}.toml"), &format!("{HEAD}{text}"))
}

fn asked(arguments: &[&str]) -> Done {
    smartbed(&[&["equilibrium"], arguments].concat())
}

fn found(model: &str) -> Value {
    let done = asked(&[model, "--json"]);
    assert_eq!(done.status, 0, "{done:?}");
    done.json()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number: {value}"))
}

fn close(x: f64, y: f64, relative: f64, what: &str) {
    assert!((x - y).abs() <= relative * y.abs(), "{what}: {x:e} against {y:e}");
}

/// Real and imaginary part and fate of each mode.
fn modes(answer: &Value) -> Vec<(f64, f64, String)> {
    let part = |mode: &Value| {
        (
            number(&mode["real"]),
            number(&mode["imaginary"]),
            mode["fate"].as_str().unwrap_or_default().to_owned(),
        )
    };
    answer["modes"].as_array().expect("modes").iter().map(part).collect()
}

#[test]
fn masses_on_a_stiff_link_hang_where_their_soft_spring_carries_them() {
    let text = format!(
        "{WEIGHT}[coordinates]\na = {{ unit = \"m\", nominal = 0.1, range = [-5, 5] }}\n\
         b = {{ unit = \"m\", range = [-5, 5] }}\n[points]\nP = \"a*N.z\"\nQ = \"b*N.z\"\n\
         [bodies]\np = {{ centre = \"P\", mass = 0.01 }}\nq = {{ centre = \"Q\", mass = 0.01 }}\n\
         [springs]\nlink = {{ between = [\"P\", \"Q\"], stiffness = 2e8, rest_length = 0.1 }}\n\
         hang = {{ coordinate = \"b\", stiffness = 0.2, rest = 0 }}\n"
    );
    let answer = found(&model("soft", &text));
    let b = -2.0 * 0.01 * 9.81 / 0.2;
    close(number(&answer["q"]["b"]), b, 2e-6, "b");
    close(number(&answer["q"]["a"]), b + 0.1 - 0.01 * 9.81 / 2e8, 2e-6, "a");
    let modes = modes(&answer);
    close(modes[0].1, (2.0 * 2e8 / 0.01_f64).sqrt(), 1e-6, "the link");
    close(modes[1].1, (0.2 / 0.02_f64).sqrt(), 1e-4, "both masses");
}

#[test]
fn equilibria_far_from_the_start_are_found() {
    let hoist = format!(
        "{WEIGHT}[inputs]\nF = {{ unit = \"N\" }}\n[coordinates]\nz = {{ unit = \"m\" }}\n\
         [points]\nP = \"z*N.z\"\n[bodies]\nload = {{ centre = \"P\", mass = \"2e6_kg\" }}\n\
         [forces]\nrope = {{ point = \"P\", force = \"F*N.z\" }}\n"
    );
    let held = asked(&[&model("hoist", &hoist), "--trim", "--json"]).json();
    close(number(&held["inputs"]["F"]), 2e6 * 9.81, 1e-14, "force");
    let tile = asked(&["tile", "--trim", "--set", "M=31", "--json"]).json();
    for thrust in ["FA", "FB", "FC"] {
        close(number(&tile["inputs"][thrust]), 110.6895, 1e-12, thrust);
    }
    let spring = "[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n[bodies]\n\
                  p = { centre = \"P\", mass = 1 }\n[springs]\n\
                  s = { coordinate = \"x\", stiffness = 100, rest = \"150_m\" }\n";
    close(number(&found(&model("far_spring", spring))["q"]["x"]), 150.0, 1e-14, "x");
    let coupled = "[joints]\na = { kind = \"revolute\", axis = \"z\", child = \"A\" }\n\
                   b = { kind = \"revolute\", axis = \"z\", child = \"B\" }\n[bodies]\n\
                   a = { centre = \"A\", frame = \"A\", mass = 1, box = [0.1, 0.1, 0.1] }\n\
                   b = { centre = \"B\", frame = \"B\", mass = 1, box = [0.1, 0.1, 0.1] }\n[torques]\n\
                   oil = { frame = \"B\", torque = \"0.2_N*1_m*1_s*(u_a - u_b)*N.z\" }\n";
    let turning = asked(&[&model("coupled", coupled), "--hold", "u_a=150", "--json"]).json();
    close(number(&turning["speeds"]["u_b"]), 150.0, 1e-14, "u_b");
}

#[test]
fn what_falls_is_at_no_equilibrium_however_stiff_or_light_it_is() {
    let linked = "[coordinates]\na = { unit = \"m\", nominal = 0.1, range = [-1000, 1000] }\n\
                  b = { unit = \"m\", range = [-1000, 1000] }\n[points]\nP = \"a*N.z\"\nQ = \"b*N.z\"\n\
                  [bodies]\np = { centre = \"P\", mass = 0.1 }\nq = { centre = \"Q\", mass = 0.1 }\n\
                  [springs]\ns = { between = [\"P\", \"Q\"], stiffness = 1e6, rest_length = 0.1 }\n";
    let damped = "[coordinates]\na = { unit = \"m\" }\n[points]\nP = \"a*N.z\"\n\
                  [bodies]\np = { centre = \"P\", mass = 0.001 }\n\
                  [forces]\nf = { point = \"P\", force = \"-1e8_N*1_s/1_m*velocity(P)\" }\n";
    let light = "[inputs]\nF = { unit = \"N\" }\n[coordinates]\na = { unit = \"m\" }\n[points]\nP = \"a*N.z\"\n\
                 [bodies]\np = { centre = \"P\", mass = 1e-10 }\n\
                 [forces]\nf = { point = \"P\", force = \"F*N.z\" }\n";
    for (name, text) in [("linked", linked), ("damped", damped), ("light", light)] {
        let done = asked(&[&model(name, &format!("{WEIGHT}{text}"))]);
        assert_eq!(done.status, 1, "{name}: {done:?}");
        assert!(done.message().contains("the rate of `u_a` stays -9.810e0"), "{name}: {done:?}");
    }
}

/// A pendulum described by its azimuth and its angle from the vertical: hanging, it has no azimuth.
const POLAR: &str = r#"
[coordinates]
psi = { unit = "rad" }
th = { unit = "rad", nominal = 0.5, range = [-3, 3] }
[frames]
A = { rotations = [["z", "psi"]] }
B = { parent = "A", rotations = [["y", "-th"]] }
[points]
P = "-1_m*B.z"
[bodies]
p = { centre = "P", mass = 1 }
"#;

#[test]
fn singular_configurations_are_refused_by_name() {
    let path = model("polar", &format!("{WEIGHT}{POLAR}"));
    let done = asked(&[&path]);
    assert_eq!(done.status, 1, "{done:?}");
    let message = done.message();
    assert!(message.contains("the configuration is singular") && message.contains("`th` = "), "{done:?}");
    assert!(asked(&["gyroscope"]).message().contains("the configuration is singular"));
    // A conical pendulum is regular: W^2 = g/(l cos th).
    let th = 0.5_f64;
    let whirl = format!("u_psi={}", (9.81 / th.cos()).sqrt());
    let done = asked(&[&path, "--hold", &whirl, "--json"]);
    assert_eq!(done.status, 0, "{done:?}");
    close(number(&done.json()["q"]["th"]), th, 1e-12, "th");
}

#[test]
fn equilibria_outside_of_stated_ranges_are_told() {
    let spring = |rest: f64| {
        let text = format!(
            "[coordinates]\nx = {{ unit = \"m\", range = [-1, 1] }}\n[points]\nP = \"x*N.x\"\n\
             [bodies]\np = {{ centre = \"P\", mass = 1 }}\n\
             [springs]\ns = {{ coordinate = \"x\", stiffness = 100, rest = {rest} }}\n"
        );
        asked(&[&model(&format!("rest_{rest}"), &text)])
    };
    let outside = spring(3.0);
    assert!(outside.out.contains("x         3.000000 m"), "{outside:?}");
    assert!(outside.err.contains("`x` = 3.0000 (range -1.0000 to 1.0000 m)"), "{outside:?}");
    assert_eq!(spring(0.5).err, "");
}

#[test]
fn slow_motions_beside_fast_ones_are_told() {
    // An inverted pendulum of 30 m beside 1 g on 1000 N s/m: s^2 = g/l; s^2 + 1e6 s + 1e6 = 0.
    let falling = format!(
        "{WEIGHT}[coordinates]\nq = {{ unit = \"rad\", range = [-0.5, 0.5] }}\n\
         x = {{ unit = \"m\", range = [-0.1, 0.1] }}\n[frames]\nA = {{ rotations = [[\"y\", \"q\"]] }}\n\
         [points]\nP = \"30_m*A.z\"\nX = \"x*N.x + 1_m*N.y\"\n\
         [bodies]\na = {{ centre = \"P\", mass = 1 }}\nb = {{ centre = \"X\", mass = 1e-3 }}\n\
         [springs]\nd = {{ coordinate = \"x\", stiffness = 1000, damping = 1000 }}\n"
    );
    let rate = (9.81_f64 / 30.0).sqrt();
    let answer = found(&model("falling", &falling));
    let expected =
        [(-999_998.999_999, "decays"), (-1.000_001_000_002, "decays"), (rate, "grows"), (-rate, "decays")];
    let all = modes(&answer);
    assert_eq!(all.len(), 4, "{answer}");
    for ((real, imaginary, fate), (value, word)) in all.iter().zip(expected) {
        close(*real, value, 1e-12, "rate");
        assert_eq!((*imaginary, fate.as_str()), (0.0, word));
    }
    // A negative damper of 1e-4 N s/m beside a spring of 1e8 N/m, 1 kg.
    let growing = "[coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\n[points]\nP = \"x*N.x + y*N.y\"\n\
                   [bodies]\np = { centre = \"P\", mass = 1 }\n\
                   [springs]\na = { coordinate = \"x\", stiffness = 1e8, damping = 1 }\nb = { coordinate = \"y\", stiffness = 9 }\n\
                   [forces]\nn = { point = \"P\", force = \"1e-4_N*1_s/1_m*dot(velocity(P), N.y)*N.y\" }\n";
    let growing = modes(&found(&model("growing", growing)));
    close(growing[1].0, 5e-5, 1e-9, "growth");
    close(growing[1].1, (9.0_f64 - 2.5e-9).sqrt(), 1e-12, "circular frequency");
    assert_eq!((growing[0].2.as_str(), growing[1].2.as_str()), ("decays", "grows"));
}

#[test]
fn a_damped_spring_of_length_0_has_its_damping() {
    // 2 s^2 + 0.5 s + 30 = 0; the search ends some 1e-16 m from O.
    let text = "[coordinates]\nx = { unit = \"m\" }\n[points]\nA = \"x*N.x\"\n[bodies]\nb = { centre = \"A\", mass = 2 }\n\
                [springs]\nf = { between = [\"O\", \"A\"], stiffness = 30, rest_length = 0, damping = 0.5 }\n[start]\nx = 1\n";
    let all = modes(&found(&model("length_0", text)));
    close(all[0].0, -0.125, 1e-12, "decay");
    close(all[0].1, (15.0_f64 - 0.125 * 0.125).sqrt(), 1e-12, "circular frequency");
}

#[test]
fn repeated_eigenvalues_have_shapes_of_their_own() {
    let text = "[coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\n[points]\nP = \"x*N.x + y*N.y\"\n\
                [bodies]\nb = { centre = \"P\", mass = 2 }\n\
                [springs]\nf = { between = [\"O\", \"P\"], stiffness = 10, rest_length = 0 }\n";
    let names = |mode: &Value| -> Vec<String> {
        let parts = mode["shape"].as_array().expect("shape");
        parts.iter().map(|part| part["name"].as_str().unwrap_or_default().to_owned()).collect()
    };
    let answer = found(&model("plane", text));
    assert_eq!(names(&answer["modes"][0]), ["x", "u_x"]);
    assert_eq!(names(&answer["modes"][1]), ["y", "u_y"]);
    // The upright top falls to either side: one shape for each, for what grows and for what decays.
    let top = found("spinning_top");
    let all: Vec<Vec<String>> = (0..4).map(|i| names(&top["modes"][i])).collect();
    let [x, y] = [["tip_e1", "tip_wx"], ["tip_e2", "tip_wy"]];
    assert_eq!(all, [x, y, x, y]);
}

#[test]
fn jumps_are_told_by_name() {
    let text = |argument: &str| {
        format!(
            "[coordinates]\nx = {{ unit = \"m\", range = [-1, 1] }}\n[definitions]\nway = \"sign({argument})\"\n\
             [points]\nP = \"x*N.x\"\n[bodies]\np = {{ centre = \"P\", mass = 1 }}\n\
             [springs]\ns = {{ coordinate = \"x\", stiffness = 100, rest = 0.2 }}\n\
             [forces]\nrub = {{ point = \"P\", force = \"-2_N*way*N.x\" }}\n"
        )
    };
    let jump = asked(&[&model("rubbing", &text("u_x"))]);
    assert_eq!(jump.status, 0, "{jump:?}");
    assert!(
        jump.err.contains("warning: `rub` jumps at this state") && jump.err.contains("sign(u_x)"),
        "{jump:?}"
    );
    // With the sign of a place 2 N push one way: 0.18 m.
    let pushed = asked(&[&model("pushed_one_way", &text("x + 3_m"))]);
    assert_eq!(pushed.err, "", "{pushed:?}");
    assert!(pushed.out.contains("x         0.180000 m"), "{pushed:?}");
}

#[test]
fn no_stability_is_claimed_at_a_kink() {
    let pulled = |name: &str, force: &str, options: &[&str]| {
        let text = format!(
            "{WEIGHT}[coordinates]\nx = {{ unit = \"m\" }}\n[definitions]\npull = \"{force}\"\n\
             [points]\nP = \"x*N.x\"\n[bodies]\nb = {{ centre = \"P\", mass = 2 }}\n[forces]\n\
             f = {{ point = \"P\", force = \"-(pull + 2_N/1_m*1_s*u_x)*N.x\" }}\n[start]\nx = 0.5\n"
        );
        asked(&[&[&*model(name, &text)], options].concat())
    };
    // A push to the left goes on to the left; slopes of the right side alone would draw it back.
    for (name, force) in [
        ("abs", "40_N/1_m*abs(x)"),
        ("max", "max(40_N/1_m*x, -10_N/1_m*x)"),
        ("sqrt", "40_N/1_m*sqrt(x*x)"),
        ("norm", "40_N/1_m*norm(x*N.x)"),
    ] {
        let done = pulled(name, force, &[]);
        assert_eq!(done.status, 0, "{done:?}");
        let said = done.err.replace("\n", " ");
        assert!(said.contains("warning: `f` has a kink at this state") && said.contains(name), "{done:?}");
        assert!(done.out.contains("these modes do not tell") && !done.out.contains("stable:"), "{done:?}");
        let warnings = pulled(name, force, &["--json"]).json()["warnings"].clone();
        assert!(
            warnings[0].as_str().is_some_and(|told| told.contains("has a kink at this state")),
            "{warnings}"
        );
    }
    // Slopes without a jump: drag at rest, and kinks away from the state.
    let drag = "40_N/1_m*x + 3_N/1_m/1_m*1_s*1_s*abs(u_x)*u_x + 5_N/1_m/1_m*abs(x)*x";
    for (name, force) in [("drag", drag), ("away", "40_N/1_m*abs(x + 2_m) - 81_N")] {
        let done = pulled(name, force, &[]);
        assert!(done.err.is_empty() && done.out.contains("stable: every small push dies out"), "{done:?}");
    }
}

#[test]
fn messages_name_the_cause() {
    let turning = asked(&["pendulum", "--hold", "u_q=1"]);
    assert!(turning.message().contains("`q`, which cannot stay constant at these speeds"), "{turning:?}");
    let guess = asked(&["slider_crank", "--set", "b=0.3"]);
    assert!(guess.message().contains("near `b` = 0.300000, the guess of what depends"), "{guess:?}");
}

/// Coordinates that move and on which accelerations depend, though their slope is 0 where the search ends: on the crest
/// of a wave, where a blade hangs straight below the axis; or though a spring elsewhere is 1e10 times as stiff.
#[test]
fn what_moves_over_waves_is_no_steady_motion() {
    let road = model(
        "wavy_road",
        "[coordinates]\nx = { unit = \"m\" }\nz = { unit = \"m\", range = [-0.3, 0.3] }\n[points]\nP = \"x*N.x + z*N.z\"\n\
         [bodies]\nb = { centre = \"P\", mass = 400 }\n[forces]\n\
         f = { point = \"P\", force = \"(-3e4_N/1_m*(z - 0.05_m*cos(2*pi*x/3_m)) - 800_N/1_m*1_s*u_z)*N.z\" }\n",
    );
    let blade = model(
        "tilted_rotor",
        "gravity = \"-9.81_m/1_s/1_s*(cos(0.3)*N.z + sin(0.3)*N.x)\"\n[coordinates]\n\
         psi = { unit = \"rad\", speed = { independent = false } }\nth = { unit = \"rad\", range = [-3, 3], nominal = 0.3 }\n\
         [frames]\nhub = { rotations = [[\"z\", \"psi\"]] }\narm = { parent = \"hub\", rotations = [[\"y\", \"th\"]] }\n\
         [points]\nP = \"-0.5_m*arm.z\"\n[bodies]\nb = { centre = \"P\", mass = 2 }\n\
         [torques]\nd = { frame = \"arm\", torque = \"-0.1_J*1_s*u_th*hub.y\", reaction = \"hub\" }\n\
         [constraints.motion]\nmotor = \"u_psi - 6/1_s\"\n[start]\nth = 0.5\n",
    );
    let soft = model(
        "soft_beside_stiff",
        "[coordinates]\nx = { unit = \"m\", range = [-1, 1] }\ny = { unit = \"m\", range = [-1, 1] }\n\
         [points]\nP = \"x*N.x\"\nQ = \"(x + y)*N.x\"\n[bodies]\nb = { centre = \"P\", mass = 2 }\n\
         c = { centre = \"Q\", mass = 0.01 }\n[springs]\ns = { coordinate = \"x\", stiffness = 0.05, rest = 0 }\n\
         t = { coordinate = \"y\", stiffness = 1e9, rest = 0 }\n",
    );
    for (arguments, name) in [
        (&[&*road, "--hold", "u_x=10"][..], "x"),
        (&[&*road, "--hold", "u_x=10", "--set", "x=0.1"], "x"),
        (&[&*blade], "psi"),
        (&[&*soft, "--hold", "u_x=1"], "x"),
    ] {
        let done = asked(arguments);
        assert_eq!(done.status, 1, "{arguments:?}: {done:?}");
        let said = done.message();
        assert!(
            said.contains(&format!("`{name}`")) && said.contains("cannot stay constant"),
            "{arguments:?}: {said}"
        );
    }
    // A level road and a rotor about the vertical do move steadily.
    let level = std::fs::read_to_string(&road).expect("a model").replace("0.05_m", "0_m");
    let level = written("level_road.toml", &level);
    assert_eq!(asked(&[&level, "--hold", "u_x=10"]).status, 0);
    let upright = std::fs::read_to_string(&blade).expect("a model").replace("(0.3)", "(0)");
    assert_eq!(asked(&[&written("upright_rotor.toml", &upright)]).status, 0);
    // The first of two values would have no effect.
    let twice = asked(&[&level, "--hold", "u_x=10", "--hold", "u_x=1"]);
    assert!(twice.message().contains("`u_x` is given twice"), "{twice:?}");
}

#[test]
fn a_rotor_whose_thrust_goes_with_the_square_of_its_speed_is_trimmed() {
    let rotor = model(
        "squared_thrust",
        "gravity = \"-9.81_m/1_s/1_s*N.z\"\n[inputs]\nw = { unit = \"rad/s\" }\n[coordinates]\nz = { unit = \"m\", range = [-1, 1] }\n\
         [points]\nP = \"z*N.z\"\n[bodies]\nb = { centre = \"P\", mass = 2 }\n[forces]\n\
         f = { point = \"P\", force = \"1e-4_N*(w*1_s).powi(2)*N.z\" }\n",
    );
    let done = asked(&[&rotor, "--trim", "--json"]);
    assert_eq!(done.status, 0, "{done:?}");
    close(number(&done.json()["inputs"]["w"]).abs(), (2.0 * 9.81 / 1e-4_f64).sqrt(), 1e-9, "w");
}
