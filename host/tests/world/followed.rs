//! Commands of quantities that coordinates follow: a tile by heave and slopes.

use super::commanded::column;
use super::support::{fails, find, rows, run, scene};

/// A tile of this model with these commands.
fn tile(name: &str, model: &str, command: &str) -> String {
    let text = format!(
        "format = 2\n[parts.tile]\nmechanism = \"{model}\"\ncommand = {{ {command} }}\n[run]\nseconds = 0.5\nstep = 0.005\n"
    );
    scene(name, &text)
}

/// The plane through the connectors is z = heave - slope_x x - slope_y y, and a rod of a platform without torsion rises
/// by the slope towards its screw over the normal's length.
#[test]
fn a_tile_takes_the_pose_of_its_heave_and_slopes() {
    let command = "heave = \"0.01_m*sin(4*t/1_s)\", slope_x = \"0.1*sin(3*t/1_s)\", slope_y = \"-0.3*t/1_s\"";
    for (model, radius) in [("tile", 0.2), ("tile_minimal", 0.2), ("tile_drive", 0.09)] {
        let found = rows(&[&tile(&format!("pose_{model}"), model, command)]);
        for (n, t) in column(&found, "t").into_iter().enumerate() {
            let (heave, x, y) = (0.01 * (4.0 * t).sin(), 0.1 * (3.0 * t).sin(), -0.3 * t);
            for (leg, azimuth) in [("A", 90_f64), ("B", 210.0), ("C", 330.0)] {
                let (sin, cos) = azimuth.to_radians().sin_cos();
                let along = x * cos + y * sin;
                let pitch = (along / (1.0 + x * x + y * y).sqrt()).asin();
                let [h, th] = ["h", "th"].map(|name| column(&found, &format!("tile.{name}{leg}"))[n]);
                assert!((h - (heave - radius * along)).abs() < 1e-15, "{model}, {t}: {h}");
                assert!((th - pitch).abs() < 1e-12, "{model}, {t}: {th} is not {pitch}");
            }
        }
    }
}

/// With a kink within a step, with a load in contact: the same numbers as the same heights commanded one by one.
#[test]
fn heave_equals_three_equal_heights() {
    let text = std::fs::read_to_string(find("scenes/tile_with_bladder").expect("a scene")).expect("its text");
    let own = "command = { heave = \"0.005_m*(1 - cos(2*pi*t/1_s))\" }";
    assert!(text.contains(own));
    let law = "\"0.1_m/1_s*abs(t - 0.0123_s)\"";
    let heave = text.replace(own, &format!("command = {{ heave = {law} }}"));
    let heights = text.replace(own, &format!("command = {{ hA = {law}, hB = {law}, hC = {law} }}"));
    let file = |name: &str, text: &str| scene(name, &text.replace("seconds = 1", "seconds = 0.03"));
    let csv = |file: &str| run(&["run", file, "--csv", "-"]);
    assert_eq!(csv(&file("heave", &heave)), csv(&file("heights", &heights)));
}

/// What is not commanded keeps the value of its definition; a model in mm takes the metres of its scene.
#[test]
fn a_model_of_ones_own_says_what_follows_what() {
    let model = "format = 1\nname = \"gantry\"\n\
                 coordinates = { a = { unit = \"mm\" }, b = { unit = \"mm\" } }\n\
                 definitions = { middle = { value = 20, unit = \"mm\" }, half = { value = 5, unit = \"mm\" } }\n\
                 commanded = { a = \"middle - half\", b = \"middle + half\" }\n\
                 points = { A = \"a*N.x\", B = \"b*N.x + 1_m*N.y\" }\n\
                 bodies = { A = { centre = \"A\", mass = \"1_kg\" }, B = { centre = \"B\", mass = \"1_kg\" } }\n";
    let model = scene("gantry_model", model);
    let text = |command: &str| {
        let text = format!("format = 2\n[parts.g]\nmechanism = \"{model}\"\ncommand = {{ {command} }}\n");
        scene("gantry", &(text + "[run]\nseconds = 0.1\nstep = 0.01\n"))
    };
    let found = rows(&[&text("half = \"0.1_m/1_s*t\"")]);
    for ((t, a), b) in column(&found, "t").iter().zip(column(&found, "g.a")).zip(column(&found, "g.b")) {
        assert!((a - (0.02 - 0.1 * t)).abs() < 1e-15 && (b - (0.02 + 0.1 * t)).abs() < 1e-15, "{t}: {a} {b}");
    }
    for (command, message) in [
        ("half = \"5\"", "`half` needs a unit"),
        ("half = \"5_s\"", "`half` must be"),
        ("half = 3", "`half` must be an expression of the time t in quotes"),
        ("a = \"0.1_m\", middle = \"0.1_m\"", "`a` of `g` is commanded twice"),
        ("midle = \"0.1_m\"", "did you mean `middle`"),
        ("middle = \"0.1_m*sign(t - 0.05_s)\"", "jumps"),
    ] {
        let said = fails(&["run", &text(command)]);
        assert!(said.contains(message), "{command}: {said}");
    }
}
