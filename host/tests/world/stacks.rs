//! Redundant contacts that contradict one another, because what sticks moves by the error of a step: stacks of boxes
//! that a ball hits, with friction, and a flexible cube flat on a flat mesh. Located touches find their forces, and
//! accounts close.

use super::support::{ELSEWHERE, json, number, scene};
use std::fmt::Write as _;

/// A box of this size and mass that stands at a height, turned about the vertical.
fn block(name: &str, size: [f64; 3], mass: f64, ([x, y], height, angle): ([f64; 2], f64, f64)) -> String {
    format!(
        "[parts.{name}]\nrigid = \"box\"\nsize = {size:?}\nmass = {mass}\n\
         start = {{ position = [{x}, {y}, 0], height = {height}, axis = [0, 0, 1], angle = {angle} }}\n"
    )
}

/// Every pair of these parts, and of each with the ground, with this law.
fn touching(names: &[&str], law: &str) -> String {
    let mut text = String::new();
    for (k, one) in names.iter().enumerate() {
        for other in ["ground"].iter().chain(&names[..k]) {
            let _ = writeln!(text, "[[contacts]]\nbetween = [\"{one}\", \"{other}\"]\n{law}");
        }
    }
    text
}

/// Runs a stack that a ball hits; the largest imbalance (J).
fn hit(name: &str, parts: [String; 2], names: &[&str], law: &str, [seconds, step]: [f64; 2]) -> f64 {
    let text = format!(
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\n{}{}{}[run]\nseconds = {seconds}\nstep = {step}\n",
        parts[0],
        parts[1],
        touching(names, law)
    );
    let done = json(&[&scene(name, &text)]);
    for name in names {
        let height = number(&done["last"][format!("{name}.z")]);
        assert!(height > 0.0, "{name} at {height} m");
    }
    number(&done["imbalance"]).abs()
}

/// The corners of the box that sticks on the sliding one move against one another by the error of a step.
#[test]
fn a_ball_hits_two_boxes_that_stand_on_one_another() {
    let boxes = block("lower", [0.3, 0.3, 0.1], 2.0, ([0.0; 2], 0.001, 0.0))
        + &block("upper", [0.2, 0.2, 0.1], 1.0, ([0.0; 2], 0.103, 0.0));
    let ball = "[parts.ball]\nrigid = \"sphere\"\nradius = 0.05\nmass = 0.5\n\
                start = { position = [1.5, 0.02, 0], height = 0, velocity = [-2, 0, 0], spin = [0, -40, 0] }\n";
    for (more, name) in [("", "stack_alone"), (ELSEWHERE, "stack_beside")] {
        let law = "impact = \"stronge\"\nfriction = 0.3\nrestitution = 0.2";
        let parts = [boxes.clone() + ball, more.to_owned()];
        let lost = hit(name, parts, &["lower", "upper", "ball"], law, [0.75, 2.5e-4]);
        assert!(lost < 1e-5, "{name}: {lost:e} J of 4 J are in no account");
    }
}

/// Two corners of the faces' overlap come together, where two contacts say almost the same: forces that may pull did so
/// by 1e5 N against one another, and their friction brought 16 J.
#[test]
fn a_ball_hits_the_uppermost_of_three_boxes() {
    let boxes = [
        block("lowest", [0.285, 0.206, 0.125], 1.309, ([0.0122, -0.0025], 0.001, 1.016)),
        block("middle", [0.302, 0.251, 0.089], 1.514, ([-0.0078, -0.004], 0.127, 1.175)),
        block("upper", [0.287, 0.234, 0.104], 1.804, ([0.0198, 0.0054], 0.216, 1.083)),
    ];
    let ball = "[parts.ball]\nrigid = \"sphere\"\nradius = 0.05\nmass = 0.56\nstart = { position = [0.795, -0.0038, 0], \
                height = 0.2654, velocity = [-4.338, 0, 0.409], spin = [0, -40, 40] }\n";
    let law = "impact = \"stronge\"\nfriction = 0.1";
    let names = ["lowest", "middle", "upper", "ball"];
    let parts = [boxes.concat() + ball, ELSEWHERE.to_owned()];
    let lost = hit("stack_of_three", parts, &names, law, [0.139, 2.5e-4]);
    assert!(lost < 1e-4, "{lost:e} J of 16 J are in no account");
}

/// Nodes of the cube's face and nodes of the mesh under it carry one load: the latter are combinations of the former.
#[test]
fn a_cube_of_springs_slides_flat_over_a_flat_mesh() {
    let at = |i: i32, j: i32| {
        let inside = |k: i32| f64::from(i32::from(k > 0 && k < 6));
        let shift = 0.02 * inside(i) * inside(j);
        let turn = |k: i32| f64::from((7 * i + 5 * j + k) % 5) - 2.0;
        format!(
            "[{:?}, {:?}, 0]",
            f64::from(i - 3) / 3.0 + shift * turn(0),
            f64::from(j - 3) / 3.0 + shift * turn(2)
        )
    };
    let (mut points, mut facets) = (Vec::new(), Vec::new());
    for j in 0..7 {
        for i in 0..7 {
            points.push(at(i, j));
            if i < 6 && j < 6 {
                let k = 7 * j + i;
                facets.push(format!("[{k}, {0}, {1}, {1}], [{0}, {2}, {1}, {1}]", k + 1, k + 7, k + 8));
            }
        }
    }
    let fixed: Vec<_> = (0..49).collect();
    let text = format!(
        "format = 2\n[parts.mesh]\npoints = [{}]\nfacets = [{}]\nfixed = {fixed:?}\nmass = 1\n\
         [parts.cube]\nshape = \"cube\"\nside = 0.2\nmass = 0.05\nK = 1000\nC = 0.5\n\
         start = {{ position = [-0.5, -0.4, 0], height = 0, velocity = [1, 0.4, 0] }}\n\
         [[contacts]]\nbetween = [\"cube\", \"mesh\"]\nimpact = \"plastic\"\nfriction = 0.2\n\
         [run]\nseconds = 0.3\nstep = 1.25e-4\n",
        points.join(", "),
        facets.join(", ")
    );
    let done = json(&[&scene("cube_on_mesh", &text)]);
    let imbalance = number(&done["imbalance"]).abs();
    assert!(imbalance < 1e-9, "{imbalance:e} J of 0.03 J are in no account");
    // It slides as a block does, on the average.
    let (speed, slowing) = (1.16_f64.sqrt(), 0.2 * super::rigid::G);
    let expected = speed * 0.3 - 0.5 * slowing * 0.3 * 0.3;
    let mean =
        |axis: &str| (0..8).map(|k| number(&done["last"][format!("cube.{axis}{k}")])).sum::<f64>() / 8.0;
    let gone = (mean("x") + 0.4).hypot(mean("y") + 0.3);
    println!("gone {gone} m, a block {expected} m, imbalance {imbalance:e} J");
    assert!((gone - expected).abs() < 0.02 * expected, "{gone} m, a block {expected} m");
}

/// Two boxes and what is between them.
fn flush(name: &str, [one, other]: [&str; 2], between: &str, law: &str, more: &str) -> String {
    let part = |name: &str, text: &str| format!("[parts.{name}]\nrigid = \"box\"\n{text}\n");
    let (one, other) = (part("a", one), part("b", other));
    let pair = format!("[[contacts]]\nbetween = {between}\nimpact = \"{law}\"\nfriction = 0.5\n");
    scene(
        &format!("flush_{name}"),
        &format!("format = 2\n{one}{other}{more}{pair}[run]\nseconds = 0.3\nstep = 1e-3\n"),
    )
}

/// A side of the upper face lies in a side of the lower one to rounding: a beam on a block of its width, a box on one
/// of its size that is shifted, a square over the corners of another.
#[test]
fn a_box_rests_on_one_whose_sides_are_flush_with_its_own() {
    let below = |size: &str| format!("size = {size}\nfixed = true\nstart = {{ position = [0, 0, 0] }}");
    let above = |size: &str, x: &str, turn: &str| {
        format!(
            "size = {size}\nmass = 2\nstart = {{ position = [\"{x}\", 0, 0.11], axis = [0, 0, 1], angle = \"{turn}\" }}"
        )
    };
    let cases = [
        ("beam", "[0.3, 0.2, 0.1]", above("[0.5, 0.2, 0.1]", "0_m", "0_deg")),
        ("shifted", "[0.3, 0.2, 0.1]", above("[0.3, 0.2, 0.1]", "50_mm", "0_deg")),
        (
            "diagonal",
            "[0.2, 0.2, 0.1]",
            above("[0.282842712474619, 0.282842712474619, 0.1]", "0_m", "45_deg"),
        ),
    ];
    for (name, size, upper) in cases {
        for law in ["plastic", "stronge", "moreau"] {
            for between in ["[\"a\", \"b\"]", "[\"b\", \"a\"]"] {
                let done = json(&[&flush(name, [&below(size), &upper], between, law, "")]);
                let z = number(&done["last"]["b.z"]);
                assert!((z - 0.1).abs() < 1e-4, "{name} {law} {between}: {z}");
            }
        }
    }
}

/// In a plane motion the width of a box across the plane does not matter, nor the order of two names.
#[test]
fn a_box_strikes_one_of_equal_height_whatever_their_widths() {
    let grounds = "[parts.ground]\nrigid = \"half_space\"\n[[contacts]]\nbetween = [\"a\", \"ground\"]\nimpact = \"plastic\"\nfriction = 0.5\n\
                   [[contacts]]\nbetween = [\"b\", \"ground\"]\nimpact = \"plastic\"\nfriction = 0.5\n";
    let one =
        "size = [0.1, 0.1, 0.1]\nmass = 2\nstart = { position = [-0.1, 0, 0.05], velocity = [2, 0, 0] }";
    let run = |height: f64, width: f64, between: &str| {
        let other = format!(
            "size = [0.1, {width}, {height}]\nmass = 2\nstart = {{ position = [0.1, 0, {}] }}",
            0.5 * height
        );
        let done = json(&[&flush("row", [one, &other], between, "plastic", grounds)]);
        ["a.x", "b.x", "b.z"].map(|name| number(&done["last"][name]))
    };
    for height in [0.1, 0.3] {
        let narrow = run(height, 0.09, "[\"a\", \"b\"]");
        assert!(narrow[0] < narrow[1] - 0.0999, "{narrow:?}");
        for (width, between) in [(0.1, "[\"a\", \"b\"]"), (0.2, "[\"a\", \"b\"]"), (0.1, "[\"b\", \"a\"]")] {
            let other = run(height, width, between);
            let same = narrow.iter().zip(other).all(|(x, y)| (x - y).abs() < 1e-6);
            assert!(same, "{height} {width} {between}: {narrow:?} {other:?}");
        }
    }
}

/// Nodes in the plane of a box's side are over its face or beside it by rounding: a run says so.
#[test]
fn nodes_over_the_rim_of_a_box_are_told_of() {
    let text = |size: &str, law: &str| {
        format!(
            "format = 2\n[parts.b]\nrigid = \"box\"\nsize = {size}\nfixed = true\nstart = {{ position = [0.1, 0.1, -0.05] }}\n\
             [parts.a]\nshape = \"cube\"\nside = 0.2\nmass = 0.5\nK = 20000\nC = 20\nstart = {{ position = [0, 0, 0.0001] }}\n\
             [[contacts]]\nbetween = [\"a\", \"b\"]\nimpact = \"{law}\"\nfriction = 0.5\n[run]\nseconds = 0.02\nstep = 1e-3\n"
        )
    };
    for (size, law, told) in [
        ("[0.2, 0.2, 0.1]", "plastic", true),
        ("[0.24, 0.2, 0.1]", "stronge", true),
        ("[0.2, 0.2, 0.1]", "moreau", false),
        ("[0.24, 0.24, 0.1]", "plastic", false),
    ] {
        let said = json(&[&scene("rim", &text(size, law))])["warnings"].to_string();
        assert_eq!(
            said.contains("nodes of `a` lie in the plane of a side of `b`"),
            told,
            "{size} {law}: {said}"
        );
    }
}
