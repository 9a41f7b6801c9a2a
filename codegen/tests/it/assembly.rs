//! How configurations are corrected and followed in time, against the closed form of a slider-crank.

use crate::models::shipped;
use smartbed_codegen::{ParameterChoice, model, program};

/// A crank that turns with time, a rod hardly longer, and a mass apart that is free.
const DRIVEN: &str = r#"
format = 1
name = "driven_slider_crank"
dof = 1

[parameters]
r = { value = 0.1, unit = "m" }
l = { value = 0.105, unit = "m" }
m = { value = 1, unit = "kg" }

[coordinates]
q = { unit = "rad", closed_form = "1_rad/1_s*t" }
b = { unit = "rad", nominal = 0, range = [-1.5, 1.5] }
x = { unit = "m", nominal = 0.205, range = [0, 0.21] }
y = { unit = "m", independent = true }

[frames]
crank = { parent = "N", rotations = [["z", "q"]] }
rod = { parent = "N", rotations = [["z", "b"]] }

[points]
B = "r*crank.x + l*rod.x"
S = "x*N.x"
D = "y*N.y"

[constraints.configuration]
along = "dot(B - S, N.x)"
across = "dot(B - S, N.y)"

[bodies]
piston = { centre = "S", mass = "m" }
apart = { centre = "D", mass = "m" }
"#;

#[test]
fn a_configuration_follows_time_on_its_branch() {
    let model = model::parse("test.toml", DRIVEN).unwrap_or_else(|e| panic!("{e}"));
    let program = program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
    let names: Vec<&str> = program.q.iter().map(|q| q.name.as_str()).collect();
    assert_eq!(names, ["b", "x", "y"]);
    // Up to 2 s in one call: Newton's first correction alone would be too large.
    for t in [0.3_f64, 0.9, 1.5, 2.0, -1.5] {
        let mut assembly = program.assembly.clone();
        assembly.set_time(0.0);
        let found = assembly.continue_in_time(&[0.0, 0.205, 0.7], t).unwrap_or_else(|e| panic!("{t}: {e}"));
        let b = (-0.1 * t.sin() / 0.105).asin();
        let expected = [b, 0.1 * t.cos() + 0.105 * b.cos(), 0.7];
        let off = found.iter().zip(&expected).fold(0.0_f64, |m, (x, y)| m.max((x - y).abs()));
        assert!(off < 1e-12, "{t}: {found:?} {expected:?}");
    }
}

#[test]
fn corrections_far_away_are_none() {
    let program = program::derive(&shipped("slider_crank"), &ParameterChoice::default())
        .unwrap_or_else(|e| panic!("{e}"));
    // The rod nearly across its line: the first correction is many turns.
    let mut q = [1.2, 1.57, 0.3];
    assert!(program.assembly.clone().correct(&mut q).is_err(), "{q:?}");
    let mut q = [1.2, -0.2, 0.3];
    program.assembly.clone().correct(&mut q).unwrap_or_else(|e| panic!("{e}"));
    assert!((q[1] - (-0.1 * 1.2_f64.sin() / 0.3).asin()).abs() < 1e-12, "{q:?}");
}
