//! Boxes that pass a flexible cube closely, and what a checkpoint knows of overlaps.

use super::support::{json, scene};
use std::fmt::Write as _;

/// A cube of 0.2 m and 0.1 kg, every two corners tied; its keys, for corners given.
fn cube(corners: &[[f64; 3]; 8]) -> String {
    let (mut springs, mut lengths) = (String::new(), String::new());
    for i in 0..8_usize {
        for j in 0..i {
            write!(springs, "[{i}, {j}], ").expect("a text");
            let axes = (i ^ (i >> 1 & 1)) ^ (j ^ (j >> 1 & 1));
            write!(lengths, "{}, ", 0.2 * f64::from(axes.count_ones()).sqrt()).expect("a text");
        }
    }
    format!(
        "points = {corners:?}\nsprings = [{springs}]\nrest_lengths = [{lengths}]\nmass = 0.1\nK = 1000\n\
         facets = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]\n"
    )
}

const UPRIGHT: [[f64; 3]; 8] = [
    [-0.1, -0.1, -0.1],
    [0.1, -0.1, -0.1],
    [0.1, 0.1, -0.1],
    [-0.1, 0.1, -0.1],
    [-0.1, -0.1, 0.1],
    [0.1, -0.1, 0.1],
    [0.1, 0.1, 0.1],
    [-0.1, 0.1, 0.1],
];

/// Gaps to the plane of a box's face were taken for gaps to the box, however far beside the face a node was, and what a
/// step may close was bounded by the distance of fixed parts from the origin: a box 4 to 8 cm from a cube struck it,
/// most of all where the ground was far below.
#[test]
fn a_box_that_passes_a_cube_does_not_strike_it() {
    let turned =
        "axis = [0.5773502691896258, 0.5773502691896258, -0.5773502691896258], angle = 2.0943951023931957";
    let passes = [
        // 8 mm off at 7 m/s; 4 and 8 cm off, turning slowly.
        (
            "[0.19, 0.22, 0.12]",
            "position = [0.25, -0.16, 0.21], axis = [-0.816496580927726, -0.408248290463863, -0.408248290463863], \
             angle = 2.792526803190927, velocity = [-7, -1, 0]"
                .to_owned(),
        ),
        (
            "[0.2, 0.2, 0.1]",
            "position = [-0.17, -0.22, 0.2], axis = [0.5773502691896257, -0.5773502691896257, -0.5773502691896257], \
             angle = 1.7453292519943298, velocity = [0.4, 0.2, -0.4], spin = [3, 0, 3]"
                .to_owned(),
        ),
        (
            "[0.2, 0.2, 0.1]",
            format!("position = [-0.02, -0.23, -0.2], {turned}, velocity = [0.3, -0.2, -0.1], spin = [3, 1, 2]"),
        ),
    ];
    for (number, (size, start)) in passes.into_iter().enumerate() {
        for below in [3.0, 10.0, 30.0] {
            let text = format!(
                "format = 2\ngravity = [0, 0, 0]\n[parts.ground]\nrigid = \"half_space\"\n\
                 start = {{ position = [0, 0, {}] }}\n[parts.cube]\n{}[parts.box]\nrigid = \"box\"\nsize = {size}\nmass = 1\n\
                 start = {{ {start} }}\n[[contacts]]\nbetween = [\"cube\", \"box\"]\nimpact = \"moreau\"\n\
                 [[contacts]]\nbetween = [\"cube\", \"ground\"]\nimpact = \"moreau\"\n[run]\nseconds = 0.1\nstep = 0.001\n",
                -below,
                cube(&UPRIGHT)
            );
            for method in ["moreau", "energy_momentum"] {
                let ran = json(&[&scene(&format!("passes_{number}"), &text), "--method", method]);
                assert_eq!(ran["events"].as_array().map(Vec::len), Some(0), "{number}, {below} m: {ran}");
                assert_eq!(ran["last"]["cube-box.points"], 0.0, "{number}, {below} m");
            }
        }
    }
}

/// Steps that used up their splits leave overlaps, of which the next steps know, also when a run is resumed there.
#[test]
fn overlaps_are_part_of_a_checkpoint() {
    let corners = [
        [-0.04031971975950848, -0.13633981275006837, 0.1510769204998601],
        [0.10863954831893843, -0.1304368298773933, 0.2844046792252594],
        [0.16244933611425164, 0.04975034968851449, 0.21630851885254337],
        [0.013490068035804721, 0.043847366815839416, 0.08298076012714406],
        [-0.16244933611425164, -0.04975034968851449, 0.2836914811474566],
        [-0.013490068035804721, -0.043847366815839416, 0.41701923987285594],
        [0.04031971975950848, 0.13633981275006837, 0.3489230795001399],
        [-0.10863954831893843, 0.1304368298773933, 0.21559532077474058],
    ];
    let mut text = format!(
        "format = 2\ngravity = [0, 0, -9.81]\n[parts.ground]\nrigid = \"half_space\"\n[parts.a]\n{}\
         start = {{ velocity = [0.5680232662448214, 0.054853199660904094, -0.2763236602681162] }}\n\
         [parts.b]\nrigid = \"sphere\"\nradius = 0.08\nmass = 0.3\nstart = {{ position = [0.02, 0.03, 0.5], \
         velocity = [0.14974915414691822, 0.3269566085917155, -0.9454462448310557], \
         spin = [-2.4666573280615434, -1.9165304108721775, 3.200038177998223] }}\n\
         [parts.c]\nrigid = \"box\"\nsize = [0.1, 0.2, 0.1]\nmass = 0.3\nstart = {{ position = [-0.05, 0.03, 0.75], \
         axis = [0.11619953541335264, -0.9920684286929228, -0.04793642415195672], angle = 1.4790690561952278, \
         velocity = [-0.31464404703077725, -0.24400291163842872, -2.3566566858161218], \
         spin = [1.106756940706579, -0.1261719438505783, -1.1788625160652095] }}\n[run]\nseconds = 0.16\nstep = 0.001\n",
        cube(&corners)
    );
    for pair in ["a ground", "b ground", "a b", "a c", "b c", "c ground"] {
        let (one, other) = pair.split_once(' ').expect("two parts");
        write!(
            text,
            "[[contacts]]\nbetween = [\"{one}\", \"{other}\"]\nimpact = \"stronge\"\nrestitution = 0.4\nfriction = 0.5\n"
        )
        .expect("a text");
    }
    let file = scene("overlapping", &text);
    let saved =
        std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("overlapping.state").display().to_string();
    let whole = json(&[&file]);
    assert!(whole["warnings"].to_string().contains("more events than a step may be split at"), "{whole}");
    for seconds in ["0.111", "0.125", "0.14"] {
        json(&[&file, "--seconds", seconds, "--save", &saved]);
        let resumed = json(&[&file, "--resume", &saved]);
        assert_eq!(whole["last"], resumed["last"], "from {seconds} s");
    }
}
