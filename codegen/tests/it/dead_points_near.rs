//! Dead points that lie near the ends of the ranges, or beyond: whether the motion passes one is known from geometry.

use crate::models::derived_from;
use smartbed_codegen::Program;
use std::f64::consts::PI;

/// Lengths of crank and rod.
const LENGTHS: [[f64; 2]; 6] = [[0.2, 0.4], [0.1, 0.3], [0.25, 0.35], [0.15, 0.6], [0.3, 0.5], [0.12, 0.2]];

/// A slider-crank whose piston's place is independent, with a range of the crank's angle. Its dead points are at 0 and
/// at half a turn. `more` are further coordinates, points and bodies.
fn slider_crank([r, l]: [f64; 2], nominal: f64, [from, to]: [f64; 2], more: [&str; 3]) -> String {
    let rod = |q: f64| (-r * q.sin() / l).asin();
    let (b, reach) = (rod(nominal), (r / l).asin() + 0.1);
    let (x, shortest, longest) = (r * nominal.cos() + l * b.cos(), 0.9 * (l - r), 1.1 * (l + r));
    let [coordinates, points, bodies] = more;
    format!(
        r#"
format = 1
name = "slider_crank"
[parameters]
r = {{ value = {r}, unit = "m" }}
l = {{ value = {l}, unit = "m" }}
m = {{ value = 1.5, unit = "kg" }}
[coordinates]
x = {{ unit = "m", independent = true, nominal = {x}, range = [{shortest}, {longest}] }}
q = {{ unit = "rad", nominal = {nominal}, range = [{from}, {to}] }}
b = {{ unit = "rad", nominal = {b}, range = [{}, {reach}] }}
{coordinates}
[frames]
crank = {{ rotations = [["z", "q"]] }}
rod = {{ rotations = [["z", "b"]] }}
[points]
A = "r*crank.x"
B = "A + l*rod.x"
S = "x*N.x"
M = "A + l/2*rod.x"
{points}
[constraints.configuration]
loop = "B - S"
[bodies]
pin = {{ centre = "A", mass = "m" }}
rod = {{ centre = "M", frame = "rod", mass = "2*m", rod = "l", axis = "x" }}
piston = {{ centre = "S", mass = "0.5*m" }}
{bodies}
"#,
        -reach
    )
}

/// Two coordinates more, which have nothing to do with dead points: the walk has three directions.
const CARRIED: [&str; 3] = [
    "e = { unit = \"m\", independent = true, nominal = 0, range = [-1, 1] }\n\
     p = { unit = \"rad\", independent = true, nominal = 0.3, range = [-3, 3] }",
    "P = \"S + e*N.y\"\nQ = \"P + 0.3_m*(cos(p)*N.x + sin(p)*N.y)\"",
    "slide = { centre = \"P\", mass = \"m\" }\nbob = { centre = \"Q\", mass = \"0.2*m\" }",
];

/// What the derivation says where the crank's range ends this far (rad) behind its dead point at `end`, or before it if
/// negative.
fn derived(lengths: [f64; 2], end: f64, behind: f64, more: [&str; 3]) -> Program {
    let range = if end == 0.0 { [-behind, 2.4] } else { [0.7, end + behind] };
    derived_from(&slider_crank(lengths, if end == 0.0 { 1.3 } else { 1.8 }, range, more))
}

/// Dead points to which the random walk comes near, some of them a fiftieth of a radian within the range.
#[test]
fn dead_points_near_the_walk_are_found() {
    for lengths in LENGTHS {
        for behind in [0.3, 1.0, 3.0, 7.0] {
            let program = derived(lengths, 0.0, behind, [""; 3]);
            assert_eq!(program.u.len(), 3, "{lengths:?}, {behind} behind 0");
        }
        for behind in [0.02, 0.1, 0.3, 4.0] {
            let program = derived(lengths, PI, behind, CARRIED);
            assert_eq!(program.u.len(), 5, "{lengths:?}, {behind} behind half a turn");
        }
    }
}

/// No step of the random walk passes a dead point of this one, the weakest pivot that it meets keeps a fifth of its
/// nominal value.
#[test]
fn a_dead_point_between_the_steps_of_the_walk_is_found() {
    let text = slider_crank([0.2, 0.4], 1.0, [-7.0, 7.0], [""; 3]);
    let text: Vec<&str> = text
        .lines()
        .map(|line| match line.split(' ').next() {
            Some("x") => "x = { unit = \"m\", independent = true, nominal = 0.45, range = [0.15, 0.65] }",
            Some("q") => "q = { unit = \"rad\", nominal = 0.8, range = [-7, 7] }",
            Some("b") => "b = { unit = \"rad\", nominal = -0.3, range = [-1, 1] }",
            _ => line,
        })
        .collect();
    assert_eq!(derived_from(&text.join("\n")).u.len(), 3);
}

/// The weakest pivot within the ranges has a tenth to a third of its nominal value, or less: that is no dead point.
#[test]
fn weak_pivots_within_the_ranges_are_no_dead_points() {
    for lengths in LENGTHS {
        for (end, behind) in [(0.0, -0.3), (PI, -0.2), (0.0, -0.1), (PI, -0.05), (0.0, -0.02)] {
            for (more, free) in [([""; 3], 0), (CARRIED, 2)] {
                let program = derived(lengths, end, behind, more);
                assert_eq!(program.u.len(), 1 + free, "{lengths:?}, {behind} behind {end}");
            }
        }
    }
}
