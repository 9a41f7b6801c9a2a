//! What a joint of a word transmits, against Newton's and Euler's equations of the link that hangs on it: also where it
//! rolls, slides under a drive, has Euler parameters, or hangs on what time drives. Constraints that are written out.
//! Particles, loads and loops at the link's own point count for the link.

use crate::answers::{Asking, close};
use crate::models::shipped;
use crate::reactions::{Balance, add, balanced, rate_of_momentum, scaled, vector};
use smartbed_codegen::model::{self, Model};
use std::path::Path;

const G: f64 = 9.81;
const MASS: f64 = 0.7;
/// A particle at the link's own point.
const PARTICLE: f64 = 0.2;
const INERTIA: [f64; 6] = [0.02, 0.03, 0.025, 0.002, -0.001, 0.0015];

/// Each word with its fields, and the force along and torque about the link's axes of its drive of 1.
const WORDS: [(&str, &str, [f64; 6]); 10] = [
    ("revolute", "axis = \"y\", drive = \"D\"", [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]),
    ("prismatic", "axis = \"x\", drive = \"D/1_m\"", [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
    ("cylindrical", "axis = \"z\", drive = [\"D/1_m\", \"2*D\"]", [0.0, 0.0, 1.0, 0.0, 0.0, 2.0]),
    ("universal", "axes = [\"x\", \"y\"], drive = [0, \"D\"]", [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]),
    ("spherical", "", [0.0; 6]),
    ("planar", "axis = \"y\"", [0.0; 6]),
    ("free", "", [0.0; 6]),
    ("knife_edge", "", [0.0; 6]),
    ("rolling_disc", "radius = \"0.2_m\"", [0.0; 6]),
    ("rolling_ball", "radius = \"0.2_m\"", [0.0; 6]),
];

/// A plate on a universal joint, or one that turns and rises as time says.
const CARRIERS: [&str; 2] = [
    r#"base = { kind = "universal", axes = ["z", "x"], child = "plate" }
[points]
"#,
    r#"
[coordinates]
turn = { unit = "rad", closed_form = "0.7_Hz*t + 0.3*sin(2_Hz*t)" }
rise = { unit = "m", closed_form = "0.1_m*sin(turn)" }
[frames]
plate = { rotations = [["z", "turn"], ["x", 0.4]] }
[points]
plate = "rise*N.z"
"#,
];

fn read(text: &str) -> Model {
    model::parse("model.toml", text).unwrap_or_else(|found| panic!("{found}"))
}

fn link_on(carrier: &str, word: &str, fields: &str) -> Model {
    let comma = if fields.is_empty() { "" } else { ", " };
    read(&format!(
        r#"format = 1
name = "m"
gravity = "-9.81_N/1_kg*N.z"
[inputs]
D = {{ unit = "N m" }}
[joints]
j = {{ kind = "{word}", parent = "plate", child = "link", at = "plate + 0.3_m*plate.x", turned = [["y", 0.3]], independent = true{comma}{fields} }}
{carrier}
[bodies]
plate = {{ centre = "plate", frame = "plate", mass = 3, inertia = {{ Ixx = 0.4, Iyy = 0.5, Izz = 0.6 }} }}
link = {{ centre = "link", frame = "link", mass = {MASS}, inertia = {{ Ixx = 0.02, Iyy = 0.03, Izz = 0.025, Ixy = 0.002, Ixz = -0.001, Iyz = 0.0015 }} }}
particle = {{ centre = "link", mass = {PARTICLE} }}
[forces]
tug = {{ point = "link", force = "D/1_m*(N.x - 2*N.y)" }}
"#
    ))
}

#[test]
fn a_joint_transmits_what_its_link_takes_besides_weight_and_drive() {
    for (n, carrier) in CARRIERS.into_iter().enumerate() {
        for (word, fields, drive) in WORDS {
            let carrier = if n == 0 {
                carrier.replace("child", "independent = true, child")
            } else {
                carrier.to_owned()
            };
            let mut balance = Balance::of(&link_on(&carrier, word, fields), &["link@link"], &["link@link"]);
            assert_eq!(balance.labels("link@link").len(), 6, "{word}: nothing else holds the link");
            let link = balance.moving("link@link");
            let reaction = balance.reaction("link@link");
            let drive = drive.map(|part| part * balance.input("D"));
            let both =
                |first: usize| link.turn.outward(add(vector(&reaction[first..]), vector(&drive[first..])));
            let weight = [0.0, 0.0, -(MASS + PARTICLE) * G];
            let tug = [balance.input("D"), -2.0 * balance.input("D"), 0.0];
            balanced(
                &[both(0), scaled(link.acceleration, -MASS - PARTICLE), weight, tug],
                &format!("force, {word} on carrier {n}"),
            );
            // A free link takes no moment: the weight on an arm of 1 m says what counts as none.
            let turning = scaled(rate_of_momentum(&link, INERTIA), -1.0);
            let whole = [both(3), turning, weight, scaled(weight, -1.0)];
            balanced(&whole, &format!("moment, {word} on carrier {n}"));
        }
    }
}

/// What is joined to the carrier at the link's place hangs on the carrier, not on the link.
#[test]
fn a_neighbour_at_the_same_place_is_no_part_of_the_link() {
    let beside = |at: &str| {
        let carrier = format!(
            "{}[joints.n]\nkind = \"prismatic\"\naxis = \"z\"\nparent = \"plate\"\nchild = \"other\"\n\
             at = \"{at}\"\nindependent = true\n[bodies.other]\ncentre = \"other\"\nmass = 2\n",
            CARRIERS[1]
        );
        let mut asking = Asking::of(
            &link_on(&carrier, "revolute", "axis = \"y\", drive = \"D\""),
            &["reaction:link@link"],
        );
        asking.part(&asking.state.clone(), "reaction:link@link", "reaction")
    };
    close(&beside("link"), &beside("plate + 0.3_m*plate.x"), 1e-12, "reaction");
}

/// A slider-crank of words, closed at the piston's own point: its rail gives no force along itself, and with the pin of
/// the crank all that the three masses take.
#[test]
fn a_loop_closed_at_the_links_own_point_holds_the_link() {
    let text = r#"format = 1
name = "m"
gravity = "-9.81_N/1_kg*N.y"
dof = 1
[parameters]
g = { value = 9.81, unit = "m/s^2" }
[joints]
turn = { kind = "revolute", axis = "z", child = "crank", independent = true, nominal = 1.0 }
pin = { kind = "revolute", axis = "z", parent = "crank", child = "rod", at = "crank + 0.1_m*crank.x", nominal = -1.3 }
rail = { kind = "prismatic", axis = "x", child = "piston", nominal = 0.34 }
[points]
E = "rod + 0.3_m*rod.x"
middle = "(rod + E)/2"
[constraints.configuration]
loop = "E - piston"
[bodies]
crank = { centre = "crank", frame = "crank", mass = 1, inertia = { Izz = 0.01 } }
rod = { centre = "middle", frame = "rod", mass = 0.4, inertia = { Izz = 0.003 } }
piston = { centre = "piston", mass = 0.6 }
"#;
    let places = ["rod@middle", "piston@piston", "crank@crank"];
    let mut engine = Balance::of(&read(text), &places, &["piston@piston", "crank@crank", "rod@rod"]);
    let [rod, piston, crank] = places.map(|place| engine.moving(place));
    let rail = engine.reaction("piston@piston");
    let bearing = crank.turn.outward(vector(&engine.reaction("crank@crank")));
    assert!(rail[0].abs() < 1e-12 * rail[1].abs(), "{rail:?}");
    let inert = add(scaled(rod.acceleration, -0.4), scaled(piston.acceleration, -0.6));
    balanced(&[vector(&rail), bearing, inert, [0.0, -2.0 * G, 0.0]], "force on the three");
    let pin = rod.turn.outward(vector(&engine.reaction("rod@rod")));
    balanced(&[scaled(pin, -1.0), bearing, [0.0, -G, 0.0]], "force on the crank");
}

/// A rod's other end is held alike whether the constraint names it or writes out how it is reached.
#[test]
fn constraints_written_out_hold_the_outer_side() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/slider_crank.toml");
    let text = std::fs::read_to_string(path).expect("a model");
    let cut = ["reaction:rod@A", "reaction:crank@O"];
    let mut named = Asking::of(&shipped("slider_crank"), &cut);
    let written_out = text.replace("dot(B - S,", "dot(A + l*rod.x - S,");
    let defined = text
        .replace("dot(B - S,", "dot(tip - S,")
        .replace("[bodies]", "[definitions]\ntip = \"A + reach\"\nreach = \"l*rod.x\"\n[bodies]");
    assert!(written_out != text && defined != text);
    for other in [written_out, defined] {
        let mut other = Asking::of(&read(&other), &cut);
        for cut in cut {
            let expected = named.part(&named.state.clone(), cut, "reaction");
            close(&other.part(&named.state.clone(), cut, "reaction"), &expected, 1e-12, cut);
        }
    }
}

/// A place along what turns with the outer side, but not from the joint on: nobody knows what holds it.
#[test]
fn constraints_that_do_not_hang_on_the_joint_are_refused() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/slider_crank.toml");
    let text = std::fs::read_to_string(path).expect("a model");
    let text = text.replace("dot(B - S,", "dot(r*crank.x + l*rod.x - S,");
    let request = "reaction:rod@A".parse().expect("a request");
    let asked = smartbed_codegen::Asked::only(vec![smartbed_codegen::Function::single(request)]);
    let found = smartbed_codegen::program::derive_asked(
        &read(&text),
        &smartbed_codegen::ParameterChoice::default(),
        smartbed_codegen::program::Settings::default(),
        &asked,
    );
    let found = found.map(|program| program.name).expect_err("refused").to_string();
    assert!(
        found.contains("the constraint `along` turns with `rod`, but its position does not start from `A`"),
        "{found}"
    );
}
