//! Commands of coordinates that joints of a model declare, beside the same mechanisms written by hand.

use super::support::{fails, json, rows, scene};

/// A deck that slides along z carries a pendulum; neither joint says that it is independent.
const JOINED: &str = r#"
format = 1
name = "joined"
gravity = "-9.81_m/1_s/1_s*N.z"
[joints]
z = { kind = "prismatic", axis = "z", child = "deck", unit = "mm", range = [-10, 50] }
q = { kind = "revolute", axis = "y", parent = "deck", child = "rod", at = "deck", damping = "0.1_N*1_m*1_s" }
[points]
B = "deck - 0.3_m*rod.z"
[bodies]
deck = { centre = "deck", mass = 3 }
bob = { centre = "B", mass = 2 }
"#;

/// The same by hand, with the motion of the deck in closed form.
const BY_HAND: &str = r#"
format = 1
name = "by_hand"
gravity = "-9.81_m/1_s/1_s*N.z"
[coordinates]
z = { unit = "mm", closed_form = "LAW", independent = false }
q = { unit = "rad", independent = true }
[frames]
rod = { rotations = [["y", "q"]] }
[points]
deck = "z*N.z"
B = "deck - 0.3_m*rod.z"
[bodies]
deck = { centre = "deck", mass = 3 }
bob = { centre = "B", mass = 2 }
[springs]
q = { coordinate = "q", stiffness = 0, damping = "0.1_N*1_m*1_s" }
"#;

const LAW: &str = "0.02_m*(1 - cos(2*pi*5_Hz*t))";

/// A scene of one mechanism of this model, with these lines.
fn part(name: &str, model: &str, lines: &str) -> String {
    let own = format!("joined_{name}");
    scene(&format!("{own}_model"), model);
    scene(
        &own,
        &format!("format = 2\n[parts.m]\nmechanism = \"{own}_model\"\n{lines}\n[run]\nseconds = 0.3\n"),
    )
}

/// The numbers of a column, row by row.
fn column(file: &str, name: &str) -> Vec<f64> {
    let (names, rows) = rows(&[file]);
    let at = names.iter().position(|own| own == name).unwrap_or_else(|| panic!("no {name} in {names:?}"));
    rows.iter().map(|row| row[at]).collect()
}

#[test]
fn a_commanded_joint_moves_as_a_closed_form_by_hand() {
    let start = "start = { q = \"50_deg\" }";
    let joined = part("words", JOINED, &format!("command = {{ z = \"{LAW}\" }}\n{start}"));
    let hand = part("hand", &BY_HAND.replace("LAW", LAW), start);
    for name in ["m.z", "m.q", "m.u_q", "actuator", "kinetic"] {
        let [found, expected] = [&joined, &hand].map(|file| column(file, name));
        let apart = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let size = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(
            found.len() == 301 && size > 0.01 && apart < 1e-12 * (1.0 + size),
            "{name}: {apart:e} of {size}"
        );
    }
    // Its unit and range stay: a plain number is refused, and a way beyond the range is told of.
    let plain = part("plain", JOINED, "command = { z = \"3\" }");
    let told = fails(&["run", &plain]);
    assert!(told.contains("`z` needs a unit") && told.contains("for example"), "{told}");
    let far = json(&[&part("far", JOINED, "command = { z = \"0.06_m*sin(t/0.1_s)\" }")]);
    assert!(far["warnings"].to_string().contains("left the ranges"), "{}", far["warnings"]);
}

#[test]
fn what_a_joint_leaves_free_beside_a_command_stays_so() {
    let body = "[bodies]\nb = { centre = \"b\", frame = \"b\", mass = 2, inertia = { Ixx = 1, Iyy = 1, Izz = 1 } }\n";
    let model = |joint: &str| {
        format!(
            "format = 1\nname = \"one\"\ngravity = \"-9.81_m/1_s/1_s*N.y\"\n[joints]\nj = {{ child = \"b\", {joint} }}\n{body}"
        )
    };
    let planar = part(
        "planar",
        &model("kind = \"planar\", axis = \"z\""),
        "command = { j_x = \"0.1_m*sin(t/0.1_s)\" }\nstart = { u_j_turn = 2 }",
    );
    let free = part(
        "free",
        &model("kind = \"free\""),
        "command = { j_x = \"0.1_m*sin(t/0.1_s)\" }\nstart = { j_wy = 2 }",
    );
    let universal = part(
        "universal",
        &model("kind = \"universal\", axes = [\"x\", \"y\"]"),
        "command = { j_first = \"0.4*sin(t/0.1_s)\" }",
    );
    let edge = part(
        "edge",
        &model("kind = \"knife_edge\""),
        "command = { j_yaw = \"0*t/1_s\" }\nstart = { j_ahead = 3 }",
    );
    let last = |file: &str, name: &str| *column(file, name).last().expect("a row");
    for (file, spin) in [(&planar, "m.u_j_turn"), (&free, "m.j_wy")] {
        assert!((last(file, "m.j_x") - 0.1 * 3.0_f64.sin()).abs() < 1e-15);
        assert!((last(file, "m.j_y") + 0.5 * 9.81 * 0.09).abs() < 1e-9, "{file}");
        assert!((last(file, spin) - 2.0).abs() < 1e-9, "{file}");
    }
    assert!((last(&universal, "m.j_first") - 0.4 * 3.0_f64.sin()).abs() < 1e-15);
    assert!((last(&edge, "m.j_x") - 0.9).abs() < 1e-9);
    for (name, joint, coordinate, why) in [
        ("euler", "kind = \"spherical\"", "j_e0", "it has no speed of its own"),
        ("ahead", "kind = \"knife_edge\"", "j_x", "it has no speed of its own"),
        (
            "roll",
            "kind = \"rolling_disc\", radius = 0.2",
            "j_x",
            "motion constraints, such as rolling, state its rate",
        ),
    ] {
        let unit = if coordinate == "j_x" { "0.1_m" } else { "0.1" };
        let file = part(name, &model(joint), &format!("command = {{ {coordinate} = \"{unit}*t/1_s\" }}"));
        let said = fails(&["run", &file]);
        assert!(
            said.contains(&format!("`{coordinate}` of `m` cannot be commanded: {why}")),
            "{name}: {said}"
        );
    }
    // The heading of a knife edge has a speed of its own.
    assert!(
        fails(&[
            "run",
            &part("ahead", &model("kind = \"knife_edge\""), "command = { j_x = \"0*t/1_s*1_m\" }")
        ])
        .contains("those that can are j_yaw")
    );
}

/// Names of models follow Rust, those of parts do not.
#[test]
fn a_part_may_have_any_name_but_sensors() {
    for name in ["t", "pi", "deg", "loop", "type", "1a", "_", "a-b"] {
        let text = format!(
            "format = 2\n[parts.{name}]\nmechanism = \"tile_minimal\"\ncommand = {{ hA = \"0.01_m\" }}\n[run]\nseconds = 0.002\n"
        );
        let place = *column(&scene("joined_named", &text), &format!("{name}.hA")).last().expect("a row");
        assert_eq!(place, 0.01, "{name}");
    }
}
