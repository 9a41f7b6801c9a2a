//! Every name in an expression counts as used, wherever in the model the expression is.

use smartbed_codegen::model;

/// A model with every place for an expression; each `@` is a factor without unit.
const MODEL: &str = r#"
format = 1
name = "places"
gravity = "-9.81_m/1_s/1_s*@*N.z"
[parameters]
k = 1.0
m = { value = "2_kg*@", unit = "kg" }
[coordinates]
q = { unit = "rad", independent = true, nominal = "0.1*@", range = ["-@", "1*@"] }
p = { unit = "rad", independent = true }
r = { unit = "rad", closed_form = "q*@" }
a = { unit = "m", independent = true, speed = false }
[speeds]
w = { value = "q_dot(a)*@", unit = "m/s", independent = true }
[inputs]
F = { unit = "N" }
[definitions]
d = "0.1_m*@"
[frames]
f = { rotations = [["z", "q*@"]], fixed = [{ vector = "N.z*@", components = ["@", 0, 0] }] }
g = { x = "f.x*@", y = "f.y" }
[points]
P = "d*g.x*@ + r*1_m*f.z"
R = { position = "P", velocity = "w*@*N.x" }
[bodies]
b = { centre = "P", mass = "m*@", frame = "f", inertia = { Izz = "1_kg*d*d*@" } }
c = { centre = "R", mass = "m" }
[forces]
push = { point = "P", force = "F*@*N.x" }
[torques]
turn = { frame = "f", torque = "F*1_m*@*N.z" }
[springs]
s = { between = ["O", "P"], stiffness = "1_N/1_m*@", rest_length = "0.1_m*@", damping = "1_N*1_s/1_m*@" }
v = { coordinate = "p", stiffness = "1_N*1_m*@", rest = "0.1*@", damping = "1_N*1_m*1_s*@" }
[constraints.motion]
roll = "u_p - u_q*@"
[outputs]
y = "q*@"
[[configurations]]
values = { q = "0.2*@" }
[start]
q = "0.3*@"
u_q = "0.4/1_s*@"
[law]
F = "1_N*@"
"#;

/// Warnings of the model in which only the n-th place mentions `k`.
fn warnings(place: Option<usize>) -> String {
    let mut pieces = MODEL.split('@').enumerate();
    let mut text = pieces.next().map_or_else(String::new, |(_, piece)| piece.to_owned());
    for (n, piece) in pieces {
        text += if place == Some(n - 1) { "(2 - k)" } else { "(2 - 1)" };
        text += piece;
    }
    let model = model::parse("places.toml", &text).unwrap_or_else(|found| panic!("{found}"));
    model.warnings().to_string()
}

#[test]
fn what_any_place_mentions_is_used() {
    let unused = "parameter `k` is never used";
    assert!(warnings(None).contains(unused), "a parameter that nothing mentions is not noticed");
    let places = MODEL.matches('@').count();
    assert!(30 <= places, "{places} places");
    for place in 0..places {
        let said = warnings(Some(place));
        assert!(!said.contains(unused), "place {place}: {said}");
    }
}
