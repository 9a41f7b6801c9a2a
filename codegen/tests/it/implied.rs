//! Implied constraints remain in the residual; configurations are assembled from far guesses, at any size,
//! and failures name the constraint that is not met.

use crate::draw::Draw;
use crate::models::{derive, derived_from, shipped, text_of};
use smartbed_codegen::kinematics::Unreachable;
use smartbed_codegen::{EmitOptions, Interpreted, ParameterChoice, ScalarType, model, program, rust};

/// The four-bar linkage of the README with another nominal angle of its crank.
fn press(crank: f64) -> String {
    let manual = include_str!("../../../README.md");
    let text = manual.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).expect("the press");
    assert!(text.contains("nominal = 60"));
    text.replace("nominal = 60", &format!("nominal = {crank}"))
}

/// Where the pin between coupler and rocker can be: the two points at 300 mm from A and 250 mm from D.
fn pins(crank: f64) -> [[f64; 2]; 2] {
    let (a, d) = ([0.1 * crank.cos(), 0.1 * crank.sin()], [0.3, 0.0]);
    let way = [d[0] - a[0], d[1] - a[1]];
    let length = way[0].hypot(way[1]);
    let along = (0.09 - 0.0625 + length * length) / (2.0 * length);
    let across = (0.09 - along * along).sqrt();
    [1.0, -1.0].map(|side| {
        let e = way.map(|x| x / length);
        [a[0] + along * e[0] - side * across * e[1], a[1] + along * e[1] + side * across * e[0]]
    })
}

/// Of two ways to close, the one nearer to the guesses (rad).
fn closes_the_nearer_way(crank: f64, guess: [f64; 2]) {
    let text = press(crank).replace("nominal = 35", &format!("nominal = {}", guess[0]));
    let program = derived_from(&text.replace("nominal = 90", &format!("nominal = {}", guess[1])));
    let guess = guess.map(f64::to_radians);
    let [q1, q2, q3] = program.nominal[..] else { panic!("three coordinates") };
    let turns = |x: f64| (x / std::f64::consts::TAU).round() * std::f64::consts::TAU;
    let ways = pins(q1).map(|pin| {
        let a = [0.1 * q1.cos(), 0.1 * q1.sin()];
        let angles = [(pin[1] - a[1]).atan2(pin[0] - a[0]), pin[1].atan2(pin[0] - 0.3)];
        let near = [0, 1].map(|i| angles[i] - turns(angles[i] - guess[i]));
        ((near[0] - guess[0]).hypot(near[1] - guess[1]), near)
    });
    let nearer = if ways[0].0 < ways[1].0 { ways[0].1 } else { ways[1].1 };
    let off = (q2 - nearer[0]).abs().max((q3 - nearer[1]).abs());
    assert!(off < 1e-9, "{crank} deg, {guess:?}: {q2}, {q3} instead of {nearer:?}");
}

/// All the way round the crank, with the guesses of the README.
#[test]
fn the_press_assembles_at_every_angle_of_its_crank() {
    for degrees in (0..360).step_by(10) {
        closes_the_nearer_way(f64::from(degrees), [35.0, 90.0]);
    }
}

#[test]
fn the_press_closes_the_nearer_way_from_any_guess() {
    for coupler in (-180..180).step_by(37) {
        for rocker in (-180..180).step_by(41) {
            closes_the_nearer_way(60.0, [f64::from(coupler), f64::from(rocker)]);
        }
    }
}

#[test]
fn lengths_of_a_million_metres_assemble() {
    let text = text_of("slider_crank");
    let coordinate = text.lines().find(|line| line.starts_with("x = ")).expect("the slider");
    for size in [1e-6, 1e3, 1e6] {
        let large = text
            .lines()
            .map(|line| match line.split_once("value = ") {
                Some((head, rest)) if rest.contains("unit = \"m\"") => {
                    let (value, tail) = rest.split_once(',').expect("a unit");
                    let value: f64 = value.trim().parse().expect("a number");
                    format!("{head}value = {:e},{tail}\n", value * size)
                }
                _ => format!("{line}\n"),
            })
            .collect::<String>();
        let nominal = format!("x = {{ unit = \"m\", nominal = {:e} }}", 0.2 * size);
        let program = derived_from(&large.replace(coordinate, &nominal));
        let (q, b, x) = (program.nominal[0], program.nominal[1], program.nominal[2]);
        let expected = size * (0.1 * q.cos() + 0.3 * b.cos());
        assert!((x - expected).abs() < 1e-12 * size, "{x} instead of {expected}");
        assert!((0.1 * q.sin() + 0.3 * b.sin()).abs() < 1e-12, "{q}, {b}");
    }
}

#[test]
fn a_loop_that_cannot_close_names_its_constraint() {
    let text = text_of("slider_crank");
    let impossible = text.replace("[bodies]", "too_far = \"x - 9_m\"\n[bodies]");
    let message = derive(&impossible).expect_err("the slider is 0.4 m away at most");
    assert!(message.contains("the largest in `"), "{message}");
}

/// The third crank of the parallelogram is 10 mm too long: it prevents the motion that the other two allow.
#[test]
fn an_implied_constraint_stays_in_the_residual_and_in_the_assembly() {
    let mut program = program::derive(&shipped("parallelogram"), &ParameterChoice::default())
        .unwrap_or_else(|e| panic!("{e}"));
    let place = program.parameters.iter().position(|p| p.name == "a3").expect("tunable");
    let mut values: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let q = [1.0, 0.0, 1.0, 1.0];
    let mut mechanism = Interpreted::<f64>::new(&program);
    assert!(mechanism.residual(&q).expect("lengths fit") < 1e-15);
    assert!(program.assembly.correct(&mut q.clone()).is_ok());
    values[place] = 0.31;
    mechanism.set_parameters(&values);
    let residual = mechanism.residual(&q).expect("lengths fit");
    let expected = 0.01 * 1.0_f64.sin().max(1.0_f64.cos());
    assert!((residual - expected).abs() < 1e-15, "{residual} instead of {expected}");
    program.assembly.set_parameters(&values);
    let unreachable: Unreachable = program.assembly.correct(&mut q.clone()).expect_err("no such place");
    assert!(unreachable.residual > 1e-4 && unreachable.constraint.is_some(), "{unreachable}");
}

/// The first two cranks folded the other way, B mirrored in the line from A to D; the third just long enough to reach
/// the bar there. All equations hold, and any motion would break one of them.
#[test]
fn a_mechanism_that_other_parameters_lock_is_found_out() {
    let program = program::derive(&shipped("parallelogram"), &ParameterChoice::default())
        .unwrap_or_else(|e| panic!("{e}"));
    let (a, d, q1) = (0.3, 0.5, 1.0_f64);
    let [x, y] = [a * q1.cos(), a * q1.sin()];
    let length = (d - x).hypot(y);
    let [e, f] = [(d - x) / length, -y / length];
    // d along x, mirrored: d (2 e e - 1, 2 e f).
    let bar = [d * (2.0 * e * e - 1.0), d * (2.0 * e * f)];
    let [bx, by] = [x + bar[0], y + bar[1]];
    let [cx, cy] = [x + 2.0 * bar[0] - 2.0 * d, y + 2.0 * bar[1]];
    let q = [q1, bar[1].atan2(bar[0]), by.atan2(bx - d), cy.atan2(cx)];
    let mut values: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let place = program.parameters.iter().position(|p| p.name == "a3").expect("tunable");
    values[place] = cx.hypot(cy);
    let mut mechanism = Interpreted::<f64>::new(&program);
    mechanism.set_parameters(&values);
    assert!(mechanism.residual(&q).expect("lengths fit") < 1e-15);
    let mut assembly = program.assembly.clone();
    assembly.set_parameters(&values);
    let found = assembly.locked(&q).expect("four equations leave nothing free");
    assert!(found.locked && found.to_string().contains("`two`"), "{found}");
    let mut assembly = program.assembly.clone();
    assert_eq!(assembly.locked(&[1.0, 0.0, 1.0, 1.0]), None);
}

/// A rod on three equal cranks on a turning base: where two cranks would allow the other branch, the third prevents it.
/// Oracle: on the right branch all cranks are parallel.
#[test]
fn a_rod_on_three_cranks_never_folds_the_other_way() {
    let program = derived_from(THREE_CRANKS);
    let mut assembly = program.assembly.clone();
    let names: Vec<&str> = program.q.iter().map(|q| q.name.as_str()).collect();
    assert_eq!(names, ["base", "q1", "rod", "q3", "q4"]);
    let (mut draw, mut reached) = (Draw(1), 0);
    for _ in 0..1000 {
        let mut target = program.nominal.clone();
        (target[0], target[1]) = (3.0 * draw.next(), 3.1 * draw.next());
        let Ok(q) = assembly.continue_to(&program.nominal, &target) else { continue };
        reached += 1;
        let parallel = [q[2], q[3] - q[1], q[4] - q[1]];
        let off = parallel.iter().map(|x| (0.5 * x).sin().abs()).fold(0.0, f64::max);
        assert!(off < 1e-6, "{q:?}");
    }
    println!("{reached} of 1000 reached");
    assert!(reached > 950, "{reached} reached");
}

const THREE_CRANKS: &str = r#"
format = 1
name = "cranks"
dof = 2
gravity = "-g*N.z"
[parameters]
a = { value = 0.3, unit = "m" }
d = { value = 0.5, unit = "m" }
e = { value = 0.4, unit = "m" }
m = { value = 1, unit = "kg" }
I = { value = 0.02, unit = "kg m^2" }
g = { value = 9.81, unit = "m/s^2" }
[coordinates]
base = { unit = "rad", independent = true }
q1 = { unit = "rad", independent = true, nominal = 1.0 }
rod = { unit = "rad", nominal = 0 }
q3 = { unit = "rad", nominal = 1.0 }
q4 = { unit = "rad", nominal = 1.0 }
[frames]
B = { rotations = [["z", "base"], ["x", "0.5"]] }
c1 = { parent = "B", rotations = [["z", "q1"]] }
bar = { parent = "B", rotations = [["z", "rod"]] }
c3 = { parent = "B", rotations = [["z", "q3"]] }
c4 = { parent = "B", rotations = [["z", "q4"]] }
[points]
A = "a*c1.x"
P = "A + d*bar.x"
Q = "A + (d + e)*bar.x"
P2 = "d*B.x + a*c3.x"
Q2 = "(d + e)*B.x + a*c4.x"
M = "A + d*bar.x/2"
[constraints.configuration]
one = "P - P2"
two = "Q - Q2"
[bodies]
bar = { centre = "M", frame = "bar", mass = "m", inertia = { Ixx = "I", Iyy = "I", Izz = "I" } }
"#;

/// Implausible numbers are reported with their place.
#[test]
fn implausible_numbers_are_named() {
    let text = text_of("pendulum");
    let line = text.lines().find(|line| line.contains("centre = ")).expect("a body").to_owned();
    let centre = line.split("centre = \"").nth(1).and_then(|rest| rest.split('"').next()).expect("a point");
    let frame = text.split("[frames]\n").nth(1).and_then(|rest| rest.split(' ').next()).expect("a frame");
    let with = |body: &str| text.replace(&line, &format!("{{name}} = {{ {body} }}").replace("{name}", "bob"));
    let at = format!("centre = \"{centre}\", frame = \"{frame}\"");
    for (body, error) in [
        ("mass = \"-2_kg\", inertia = { Izz = \"1_kg*1_m*1_m\" }", "the mass of `bob` is negative"),
        (
            "mass = \"2_kg\", inertia = { Izz = \"-1_kg*1_m*1_m\" }",
            "the moment of inertia Izz of `bob` is negative",
        ),
    ] {
        let message = derive(&with(&format!("{at}, {body}"))).expect_err(body);
        assert!(message.contains(error), "{message}");
    }
    let moments = "inertia = { Ixx = \"1_kg*1_m*1_m\", Iyy = \"1_kg*1_m*1_m\", Izz = \"3_kg*1_m*1_m\" }";
    for (body, warning) in [
        (format!("mass = \"2_kg\", {moments}"), "the moments of inertia of `bob` cannot be those of a body"),
        (moments.to_owned(), "`bob` has inertia but no mass, and its centre moves"),
    ] {
        let found = derived_from(&with(&format!("{at}, {body}"))).warnings.to_string();
        assert!(found.contains(warning), "{found}");
    }
    let idle = format!("{line}\nballast = {{ centre = \"O\", mass = \"1_kg\" }}");
    let found = derived_from(&text.replace(&line, &idle)).warnings.to_string();
    assert!(found.contains("`ballast` does not move"), "{found}");
    let far = derived_from(&press(60.0).replace("nominal = 60", "range = [70, 90], nominal = 60"));
    assert!(far.warnings.to_string().contains("the nominal value of `q1` lies outside its range"));
    let reversed = derive(&press(60.0).replace("nominal = 60", "range = [90, 30], nominal = 60"));
    assert!(reversed.expect_err("a range").contains("the range of `q1` ends before it begins"));
}

/// An axle whose two wheels roll: the second says what the first does, as long as it is not turned.
const AXLE: &str = r#"
format = 1
name = "axle"
[parameters]
a = { value = 0.5, unit = "m" }
toe = { value = 0, unit = "rad" }
m = { value = 10, unit = "kg" }
[coordinates]
x = { unit = "m", independent = true }
y = { unit = "m", speed = { independent = false } }
q = { unit = "rad", independent = true, range = [-1, 1] }
[frames]
car = { rotations = [["z", "q"]] }
wheel = { parent = "car", rotations = [["z", "toe"]] }
[points]
G = "x*N.x + y*N.y"
A = "G - a*car.y"
B = "G + a*car.y"
[constraints.motion]
left = "dot(velocity(A), car.y)"
right = "dot(velocity(B), wheel.y)"
[bodies]
car = { centre = "G", frame = "car", mass = "m", inertia = { Izz = 1 } }
"#;

#[test]
fn a_motion_constraint_that_follows_from_the_others_is_dropped_with_a_warning() {
    let program = derived_from(AXLE);
    let warnings = program.warnings.to_string();
    assert!(warnings.starts_with("warning: `right` follows from the other constraints"), "{warnings}");
    let turned = AXLE.replace("value = 0, unit = \"rad\"", "value = 0.1, unit = \"rad\"");
    let refused = derive(&turned).expect_err("one degree of freedom");
    assert!(refused.contains("`right` makes them dependent"), "{refused}");
    // Also of what a coordinate says, and of a drive.
    let drives = AXLE
        .replace("right = \"dot(velocity(B), wheel.y)\"", "one = \"u_q - 3/1_s\"\ntwo = \"2*u_q - 6/1_s\"")
        .replace("independent = true, range = [-1, 1]", "speed = { independent = false }, range = [-1, 1]");
    let warnings = derived_from(&drives).warnings.to_string();
    assert!(warnings.starts_with("warning: `two` follows"), "{warnings}");
}

/// The axle with a second wheel that also says how fast it spins: a vector, of which one component is needed.
fn rolling_axle() -> String {
    AXLE.replace(
        "[frames]",
        "s = { unit = \"rad\", speed = { independent = false }, doc = \"spin\" }\n[frames]",
    )
    .replace("\"dot(velocity(B), wheel.y)\"", "\"velocity(B) - a*u_s*wheel.x\"")
}

/// The axle with a coordinate in closed form beside it.
fn axle_with_closed_form() -> String {
    AXLE.replace("[frames]", "h = { unit = \"m\", closed_form = \"x*sin(q)\" }\n[frames]")
}

#[test]
fn so_is_a_component_of_a_vector_and_what_stands_beside_a_closed_form() {
    let vector = derived_from(&rolling_axle()).warnings.to_string();
    assert!(
        vector.starts_with("warning: a component of `right` follows from the other constraints"),
        "{vector}"
    );
    let closed = axle_with_closed_form();
    let beside = derived_from(&closed).warnings.to_string();
    assert!(beside.starts_with("warning: `right` follows from the other constraints"), "{beside}");
    // What restates a closed form takes the place of its derivative. What is 0 however the mechanism moves says
    // nothing.
    let rate = "\"u_h - u_x*sin(q) - x*cos(q)*u_q\"";
    let restated = closed.replace("\"dot(velocity(B), wheel.y)\"", rate);
    let once = rolling_axle().replace("left = \"dot(velocity(A), car.y)\"\n", "");
    for model in [restated, once] {
        let warnings = derived_from(&model).warnings;
        assert!(warnings.items.is_empty(), "{warnings}");
    }
    // Nor does the rate of a configuration constraint (the wheel of the bicycle that is kept on the ground).
    for name in ["rolling_disc", "turntable", "sleigh", "bicycle", "tile_minimal"] {
        let program = program::derive(&shipped(name), &ParameterChoice::default());
        let warnings = program.unwrap_or_else(|e| panic!("{e}")).warnings;
        assert!(warnings.items.is_empty(), "{name}: {warnings}");
    }
}

/// Rolling along x, the second wheel slips by the sine of the angle that it is turned by.
#[test]
fn a_motion_constraint_that_no_longer_follows_shows_in_the_residual() {
    for model in [AXLE.to_owned(), rolling_axle(), axle_with_closed_form()] {
        slips_by_the_sine(&model);
    }
    let plain = derived_from(&AXLE.replace("right = \"dot(velocity(B), wheel.y)\"\n", ""));
    assert!(plain.warnings.items.is_empty() && !plain.has_implied, "{}", plain.warnings);
}

fn slips_by_the_sine(model: &str) {
    let program = derived_from(model);
    let mut axle = Interpreted::<f64>::new(&program);
    let mut values: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let place = program.parameters.iter().position(|p| p.name == "toe").expect("tunable");
    for (toe, holds) in [(0.0, true), (0.1, false), (-1e-3, false)] {
        values[place] = toe;
        axle.set_parameters(&values);
        for q in [0.0, 0.3, -0.9] {
            let configuration: Vec<f64> = [0.2, 0.1, q, 0.4][..program.q.len()].to_vec();
            let residual = axle.residual(&configuration).expect("lengths fit");
            assert_eq!(residual < 1e-15, holds, "{toe}, {q}: {residual}");
            assert!(holds || residual > 0.5 * toe.abs(), "{toe}, {q}: {residual}");
        }
    }
    // So that derived code refuses the parameter.
    for scalar in [ScalarType::F32, ScalarType::F64] {
        let text = rust::emit(&program, &EmitOptions { scalar, ..EmitOptions::default() });
        assert!(text.contains("if !self.can_be_assembled()"), "{text}");
    }
}

#[test]
fn a_derivation_says_on_which_parameters_its_checks_rest() {
    let of = |model: &model::Model| {
        let keep = model.parameters.iter().map(|p| p.name.clone()).collect();
        let choice = ParameterChoice { keep, ..ParameterChoice::default() };
        program::conditions(model, &choice).unwrap_or_else(|e| panic!("{e}"))
    };
    let axle = model::parse("axle.toml", AXLE).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(of(&axle), ["a", "toe"]);
    assert_eq!(of(&shipped("parallelogram")), ["a", "a3", "d", "e"]);
    // Vectors of the tile are fixed in its platform because of where its legs stand.
    assert_eq!(of(&shipped("tile")), ["alphaA", "alphaB", "alphaC"]);
    for name in ["fourbar", "pendulum3"] {
        assert_eq!(of(&shipped(name)), [""; 0], "{name}");
    }
}
