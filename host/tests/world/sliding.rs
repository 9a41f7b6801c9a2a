//! Parts that slide over facets which bend, and nodes that slide round edges of boxes, with touches located: forces
//! along interpolated normals against gaps measured to facets; faces that change under a lasting contact.

use super::support::{json, number, scene};

/// A ball on a sheet: keys of the ball, of the sheet, of the contact, and of the run.
fn ball_on_sheet(name: &str, [ball, sheet, contact, run]: [&str; 4]) -> String {
    let text = format!(
        "format = 2\ngravity = [0, 0, 0]\n[parts.ground]\nrigid = \"half_space\"\n[parts.ball]\nrigid = \"sphere\"\nradius = 0.05\n{ball}\n\
         [parts.sheet]\nshape = \"sheet\"\nwidth = 0.6\ndepth = 0.6\nK = 2000\n\
         start = {{ position = [-0.3, -0.3, 0] }}\n{sheet}\n\
         [[contacts]]\nbetween = [\"ball\", \"sheet\"]\n{contact}\n[run]\n{run}\nevery = 100\n"
    );
    scene(&format!("sliding_{name}"), &text)
}

/// Energy (J) in no account at the end of a run without a warning.
fn imbalance(name: &str, keys: [&str; 4]) -> f64 {
    let done = json(&[&ball_on_sheet(name, keys)]);
    println!("{name}: {} J, {} events", done["imbalance"], done["events"].as_array().expect("a list").len());
    assert!(done["warnings"].as_array().expect("a list").is_empty(), "{name}: {}", done["warnings"]);
    number(&done["imbalance"]).abs()
}

#[test]
fn a_ball_that_slides_over_coarse_facets_gains_nothing() {
    let held = "rows = 9\ncolumns = 9\nmass = 0.2\nattach = [{ nodes = \"rim\", to = \"ground\" }]\nC = 0.5";
    let skewed = "mass = 1\nstart = { position = [0.013, 0.007, 0.06], velocity = [0.5, 0.2, -2] }";
    for (law, friction) in [("plastic", 0.0), ("plastic", 0.3), ("stronge", 0.0), ("stronge", 0.3)] {
        let rebound = if law == "stronge" { "restitution = 0.5" } else { "" };
        let contact = format!("impact = \"{law}\"\nfriction = {friction}\n{rebound}");
        let left = imbalance(
            &format!("held_{law}_{friction}"),
            [skewed, held, &contact, "seconds = 0.3\nstep = 2e-4"],
        );
        assert!(left < 2e-5, "{law}, {friction}: {left:e}");
    }
}

#[test]
fn a_sheet_that_folds_round_a_fast_ball_gains_nothing() {
    // 12.5 J on five grams: the facets stand at more than 45 degrees to each other.
    let free = "rows = 7\ncolumns = 7\nmass = 0.005";
    let fast = "mass = 1\nstart = { position = [0.013, 0.007, 0.06], velocity = [0, 0, -5] }";
    let run = "seconds = 0.2\nstep = 1e-4";
    let left = imbalance("free", [fast, free, "impact = \"plastic\"", run]);
    assert!(left < 5e-5, "{left:e}");
}

/// A box thrown at a ball of springs: speed, angle (deg), height, gas, damper, friction; energy in no account over the
/// energy thrown.
fn thrown((speed, angle, across): (f64, f64, f64), gas: &str, damper: f64, friction: f64) -> f64 {
    let text = format!(
        "format = 2\ngravity = [0, 0, 0]\n[parts.ball]\nshape = \"ball\"\nradius = 0.1\nmass = 0.2\nK = 2000\nC = {damper}\n{gas}\n\
         [parts.box]\nrigid = \"box\"\nsize = [0.1, 0.1, 0.1]\nmass = 0.5\n\
         start = {{ position = [-0.35, {across}, {}], velocity = [{speed}, 0, 0], axis = [1, 2, 3], angle = {} }}\n\
         [[contacts]]\nbetween = [\"box\", \"ball\"]\nimpact = \"stronge\"\nrestitution = 0.5\nfriction = {friction}\n\
         [run]\nseconds = 0.2\nstep = 4e-4\nevery = 500\n",
        2.0 * across,
        angle * std::f64::consts::PI / 180.0
    );
    let done =
        json(&[&scene(&format!("thrown_{speed}_{angle}_{across}_{damper}_{friction}_{}", gas.len()), &text)]);
    let said = done["warnings"].as_array().expect("a list");
    assert!(
        !said.iter().any(|line| line.as_str().is_some_and(|line| line.contains("in no account"))),
        "{said:?}"
    );
    number(&done["imbalance"]).abs() / (0.25 * speed * speed)
}

/// Nodes slide round the box's edges and its corners over facets that fold: faces change within a step, and forces
/// along the old one lost up to 4 J, or created 3e4 J with friction.
#[test]
fn a_box_thrown_at_a_ball_of_springs_gains_nothing() {
    let (open, sealed) = ("gas = { gauge = 5000 }", "gas = { gauge = 5000, sealed = true }");
    for (throw, gas, damper, friction) in [
        ((3.0, 30.0, 0.0), "", 2.0, 0.0),
        ((10.0, 75.0, 0.01), sealed, 2.0, 0.0),
        ((20.0, 0.0, 0.0), sealed, 0.0, 0.0),
        ((20.0, 0.0, 0.01), "", 2.0, 0.0),
        ((20.0, 75.0, 0.0), open, 0.0, 0.0),
        ((3.0, 0.0, 0.01), open, 2.0, 0.4),
        ((10.0, 75.0, 0.01), open, 2.0, 0.4),
        ((10.0, 30.0, 0.01), "", 0.0, 0.4),
        ((20.0, 75.0, 0.01), "", 2.0, 0.4),
    ] {
        let missed = thrown(throw, gas, damper, friction);
        println!("{throw:?}, {gas}, damper {damper}, friction {friction}: {missed:.1e}");
        assert!(missed < 2e-4, "{throw:?}, {gas}, damper {damper}, friction {friction}: {missed:e}");
    }
}
