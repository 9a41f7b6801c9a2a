//! Reactions in a planar loop whose plane is turned any way in N: as in the same loop in N's own plane, and against
//! Newton's and Euler's equations.

use crate::reactions::{Balance, add, balanced, cross, rate_of_momentum, scaled};
use smartbed_codegen::model::{self, Model};

/// A four-bar of three hinges and a constraint in the plane across `base.z`, with bodies off that plane.
fn four_bar(base: &str, gravity: &str) -> Model {
    let text = format!(
        r#"format = 1
name = "four_bar"
dof = 1
gravity = "{gravity}"
[parameters]
g = {{ value = 9.81, unit = "m/s^2" }}
[frames]
base = {{ rotations = [{base}] }}
[joints]
ja = {{ kind = "revolute", axis = "z", parent = "base", child = "crank", independent = true, nominal = 1.0, at = "0.1_m*base.z" }}
jb = {{ kind = "revolute", axis = "z", parent = "crank", child = "coupler", at = "crank + 0.2_m*crank.x", nominal = -0.6 }}
jc = {{ kind = "revolute", axis = "z", parent = "base", child = "rocker", at = "0.1_m*base.z + 0.5_m*base.x", nominal = 1.5 }}
[points]
Pc = "coupler + 0.5_m*coupler.x"
Pr = "rocker + 0.4_m*rocker.x"
Mc = "crank + 0.1_m*crank.x + 0.03_m*crank.z"
Mp = "coupler + 0.25_m*coupler.x + 0.05_m*coupler.y"
Mr = "rocker + 0.2_m*rocker.x"
[constraints.configuration]
loop = "Pc - Pr"
[bodies]
crank = {{ centre = "Mc", frame = "crank", mass = 1, inertia = {{ Ixx = 0.01, Iyy = 0.02, Izz = 0.02, Ixz = 0.003 }} }}
coupler = {{ centre = "Mp", frame = "coupler", mass = 2, inertia = {{ Ixx = 0.01, Iyy = 0.05, Izz = 0.05, Iyz = 0.004 }} }}
rocker = {{ centre = "Mr", frame = "rocker", mass = 1.5, inertia = {{ Izz = 0.03 }} }}
"#
    );
    model::parse("four_bar.toml", &text).unwrap_or_else(|e| panic!("{e}"))
}

const CUTS: [&str; 3] = ["crank@crank", "coupler@coupler", "rocker@rocker"];
const BASES: [&str; 5] = [
    r#"["x", "0.4"]"#,
    r#"["x", "0.4"], ["z", "0.3"]"#,
    r#"["y", "0.2"]"#,
    r#"["z", "0.7"], ["y", "-1.1"], ["x", "2.3"]"#,
    r#"["x", "90*deg"]"#,
];

#[test]
fn reactions_in_a_plane_do_not_depend_on_where_it_lies() {
    // Gravity has a part out of the plane, and is turned with it.
    let gravity = "-g*(0.6*base.y + 0.8*base.z)";
    let mut flat = Balance::of(&four_bar(r#"["z", "0.3"]"#, gravity), &[], &CUTS);
    for base in BASES {
        let mut tilted = Balance::of(&four_bar(base, gravity), &[], &CUTS);
        for cut in CUTS {
            assert_eq!(tilted.labels(cut), flat.labels(cut), "{base} {cut}");
            let (found, expected) = (tilted.reaction(cut), flat.reaction(cut));
            let size = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            for (a, b) in found.iter().zip(expected) {
                assert!((a - b).abs() <= 1e-11 * size, "{base} {cut}: {found:?} against {expected:?}");
            }
        }
    }
}

/// What the plane's own hinges hold: forces along it, moments across it.
#[test]
fn reactions_balance_the_links_of_a_tilted_loop() {
    for base in BASES {
        let centres = ["crank@Mc", "coupler@Mp", "rocker@Mr"];
        let places: Vec<&str> = centres.into_iter().chain(CUTS).chain(["base@O"]).collect();
        let mut bar = Balance::of(&four_bar(base, "-g*N.y"), &places, &CUTS);
        for cut in CUTS {
            assert_eq!(bar.labels(cut)[..2], ["F_x", "F_y"], "{base} {cut}");
            assert!(bar.labels(cut).contains(&"M_z".to_owned()), "{base} {cut}");
        }
        let plane = bar.moving("base@O").turn;
        let joints = CUTS.map(|cut| {
            let at = bar.moving(cut);
            let [x, y, _, _, _, m] = bar.reaction(cut);
            let force = at.turn.outward([x, y, 0.0]);
            (at.position, force, at.turn.outward([0.0, 0.0, m]))
        });
        let inertias = [
            (1.0, [0.01, 0.02, 0.02, 0.0, 0.003, 0.0]),
            (2.0, [0.01, 0.05, 0.05, 0.0, 0.0, 0.004]),
            (1.5, [0.0, 0.0, 0.03, 0.0, 0.0, 0.0]),
        ];
        // Weight and inertia of a body: force and moment about O.
        let own = [0, 1, 2].map(|i| {
            let (mass, inertia) = inertias[i];
            let body = bar.moving(centres[i]);
            let force = add([0.0, -9.81 * mass, 0.0], scaled(body.acceleration, -mass));
            (body.position, force, scaled(rate_of_momentum(&body, inertia), -1.0))
        });
        let turned = |(at, force, moment), sign| {
            let about = add(moment, cross(at, force));
            (scaled(force, sign), scaled(about, sign))
        };
        let sums = [
            ("the crank", vec![(joints[0], 1.0), (joints[1], -1.0), (own[0], 1.0)]),
            ("coupler and rocker", vec![(joints[1], 1.0), (joints[2], 1.0), (own[1], 1.0), (own[2], 1.0)]),
        ];
        for (what, terms) in sums {
            let terms = terms.into_iter().map(|(wrench, sign)| turned(wrench, sign));
            let (forces, moments): (Vec<_>, Vec<_>) = terms
                .map(|(force, moment)| {
                    let [x, y, _] = plane.inward(force);
                    ([x, y, 0.0], [0.0, 0.0, plane.inward(moment)[2]])
                })
                .unzip();
            balanced(&forces, &format!("{base}: force on {what}"));
            balanced(&moments, &format!("{base}: moment on {what}"));
        }
    }
}
