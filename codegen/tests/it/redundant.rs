//! Redundant and singular constraints: the decision does not depend on how an equation is written or scaled.
//!
//! Redundant constraints are dropped with a warning that names them; the result equals the mechanism without them.

use crate::models::{derive, derived_from, text_of};
use smartbed_codegen::{Interpreted, Program};
use smartbed_runtime::mechanism::Mechanism;

/// Accelerations of order 10, a few hundred rounded operations.
const ROUNDING: f64 = 1e-9;

/// The four-bar linkage with its closing equation written otherwise.
fn fourbar(closing: &str) -> String {
    let text = text_of("fourbar");
    assert!(text.contains("loop = \"C - D\""));
    text.replace("loop = \"C - D\"", closing)
}

/// The same accelerations where the loop closes.
fn moves_alike(a: &Program, b: &Program) {
    for start in [0.4, 1.0, 1.9] {
        let (mut q, torque) = ([start, 0.406, -1.888], [3.0]);
        let mut mechanism = Interpreted::<f64>::new(a);
        for _ in 0..30 {
            mechanism.project(&mut q).expect("lengths fit");
            q[0] = start;
        }
        let mut found = [[0.0; 4]; 2];
        for (program, row) in [a, b].into_iter().zip(&mut found) {
            let (q_dot, u_dot) = row.split_at_mut(3);
            let mut mechanism = Interpreted::<f64>::new(program);
            mechanism.rates(0.0, &q, &[0.7], &torque, q_dot, u_dot).expect("lengths fit");
        }
        for (x, y) in found[0].iter().zip(&found[1]) {
            assert!((x - y).abs() < ROUNDING * (1.0 + x.abs()), "{found:?}");
        }
    }
}

fn warnings(program: &Program) -> Vec<&str> {
    program.warnings.items.iter().map(|w| w.message.as_str()).collect()
}

#[test]
fn a_constraint_multiplied_by_a_number_is_the_same_constraint() {
    let plain = derived_from(&text_of("fourbar"));
    for scale in ["1e-12", "1e-9", "1e9", "1e12"] {
        let all = derived_from(&fourbar(&format!("loop = \"{scale}*(C - D)\"")));
        assert!(all.warnings.items.is_empty(), "{scale}: {}", all.warnings);
        moves_alike(&plain, &all);
        let one = derived_from(&fourbar(&format!(
            "along = \"dot(C - D, N.x)\"\nacross = \"{scale}*dot(C - D, N.y)\""
        )));
        assert!(one.warnings.items.is_empty(), "{scale}: {}", one.warnings);
        moves_alike(&plain, &one);
    }
}

#[test]
fn a_constraint_stated_twice_is_dropped_whatever_its_scale_and_place() {
    let plain = derived_from(&text_of("fourbar"));
    for scale in ["1e-12", "1e-9", "1e-6", "2", "1e6", "1e9", "1e12"] {
        let again = format!("again = \"{scale}*dot(C - D, N.x + 0.3*N.y)\"");
        let after = derived_from(&fourbar(&format!("loop = \"C - D\"\n{again}")));
        assert_eq!(
            warnings(&after),
            ["`again` follows from the other constraints and is dropped"],
            "{scale}"
        );
        moves_alike(&plain, &after);
        // Stated first, it is kept, and what it says of the other is dropped.
        let before = derived_from(&fourbar(&format!("{again}\nloop = \"C - D\"")));
        assert_eq!(
            warnings(&before),
            ["a component of `loop` follows from the other constraints and is dropped"],
            "{scale}"
        );
        moves_alike(&plain, &before);
    }
}

/// A row that consists of rounding errors at every configuration does not count as an equation, at any scale.
#[test]
fn a_row_of_rounding_errors_is_no_row() {
    let plain = derived_from(&text_of("fourbar"));
    for scale in ["1e-6", "1", "1e9"] {
        let nothing = format!("(sin(q1 + k).powi(2) + cos(q1 + k).powi(2) - {scale}/{scale})");
        let text = fourbar(&format!("loop = \"C - D\"\nzero = \"{scale}*q3*{nothing}\""))
            .replace("[inputs]", "k = { value = 0.3 }\n[inputs]");
        let program = derived_from(&text);
        moves_alike(&plain, &program);
    }
}

/// The linkage in a plane that is not the ground's: three components, two of them independent.
#[test]
fn a_planar_loop_in_space_loses_one_component() {
    let text = text_of("fourbar")
        .replace("[frames]", "[frames]\nbase = { parent = \"N\", rotations = [[\"x\", 0.3], [\"y\", 0.7]] }")
        .replace("parent = \"N\", rotations = [[\"z\"", "parent = \"base\", rotations = [[\"z\"")
        .replace("l4*N.x", "l4*base.x")
        .replace("T*N.z", "T*base.z")
        .replace("-g*N.y", "-g*base.y");
    let program = derived_from(&text);
    assert_eq!(
        warnings(&program),
        ["a component of `loop` follows from the other constraints and is dropped"]
    );
    moves_alike(&derived_from(&text_of("fourbar")), &program);
}

/// Three parallel cranks carry one bar: the third says nothing new, at the size of a machine or of a chip.
#[test]
fn the_third_crank_of_a_parallelogram_is_redundant() {
    for size in ["1e-5", "1e-3", "1", "1e4"] {
        let program = derived_from(&parallelogram(size, "1/2"));
        assert_eq!(
            warnings(&program),
            ["a component of `third` follows from the other constraints and is dropped"],
            "{size}"
        );
        assert_eq!(program.u.len(), 1);
    }
}

/// Joined to the bar at another point, the third crank locks the motion of the other two: singular, not redundant.
#[test]
fn a_third_crank_out_of_place_is_refused() {
    let message = derive(&parallelogram("1", "0.6")).expect_err("it cannot move");
    assert!(message.contains("third"), "{message}");
}

/// Cranks of one length on the ground at 0, `place` and 1 times the bar's length.
fn parallelogram(size: &str, place: &str) -> String {
    format!(
        r#"
format = 1
name = "parallelogram"
[parameters]
size = {size}
m = {{ value = 1, unit = "kg" }}
[coordinates]
q1 = {{ unit = "rad", independent = true, nominal = 1.0, range = [0.3, 2.8] }}
q2 = {{ unit = "rad", nominal = 1.0 }}
q3 = {{ unit = "rad", nominal = 1.0 }}
b = {{ unit = "rad", nominal = 0.0 }}
[frames]
f1 = {{ parent = "N", rotations = [["z", "q1"]] }}
f2 = {{ parent = "N", rotations = [["z", "q2"]] }}
f3 = {{ parent = "N", rotations = [["z", "q3"]] }}
bar = {{ parent = "N", rotations = [["z", "b"]] }}
[points]
A = "size*0.2_m*f1.x"
C = "A + size*0.25_m*bar.x"
B2 = "size*0.5_m*N.x + size*0.2_m*f2.x"
B3 = "size*{place}*0.5_m*N.x + size*0.2_m*f3.x"
[constraints.configuration]
second = "A + size*0.5_m*bar.x - B2"
third = "A + size*0.25_m*bar.x - B3"
[bodies]
bar = {{ centre = "C", mass = "m" }}
"#
    )
}
