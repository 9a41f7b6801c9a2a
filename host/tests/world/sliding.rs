//! Parts that slide over facets which bend, with touches located: forces along interpolated normals against gaps measured
//! to facets.

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
