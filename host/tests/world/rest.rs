//! Lasting contacts: forces at rest, ten seconds from equilibrium, flat faces that slide.

use super::rigid::G;
use super::support::{fails, find, json, number, rows, scene, settled, smartbed};

/// The last row of a scene with changes, settled.
fn at_rest(scene: &str, changes: &[String]) -> serde_json::Value {
    let set = changes.iter().flat_map(|change| ["--set", change]);
    settled(&[scene].into_iter().chain(set).collect::<Vec<_>>())["last"].clone()
}

#[test]
fn forces_of_settled_contacts_are_the_weights() {
    // Which pair, and the mass (kg) that rests on it.
    let cases: [(&str, &[(&str, f64)]); 3] = [
        ("plate_on_bladder", &[("plate-bladder", 1.0)]),
        ("ball_on_bladder", &[("ball-bladder", 1.0)]),
        ("stack_cubes", &[("upper-middle", 0.4), ("middle-lower", 0.8), ("lower-ground", 1.2)]),
    ];
    for (scene, pairs) in cases {
        let rest = at_rest(scene, &[]);
        for (pair, mass) in pairs {
            let [x, y, z] = ["x", "y", "z"].map(|axis| number(&rest[format!("{pair}.{axis}")]));
            let load = mass * G;
            println!("{scene}: {pair} {x:e} {y:e} {z}, off by {:e}", z / load - 1.0);
            assert!((z / load - 1.0).abs() < 1e-9 && x.abs().max(y.abs()) < 1e-9 * load, "{scene}: {rest}");
        }
    }
}

#[test]
fn a_law_that_rebounds_comes_to_the_same_rest() {
    let law = |law: &str| {
        vec![format!("contacts=[{{ between = [\"plate\", \"bladder\"], impact = {law}, friction = 0.4 }}]")]
    };
    let heights =
        |rest: &serde_json::Value| ["plate.z", "bladder.z0", "bladder.z24"].map(|name| number(&rest[name]));
    let expected = heights(&at_rest("plate_on_bladder", &law("\"moreau\"")));
    for own in ["\"moreau\", restitution = 0.9", "\"compensation\"", "\"stronge\", restitution = 1"] {
        let rest = at_rest("plate_on_bladder", &law(own));
        let off = heights(&rest).iter().zip(expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        println!("{own}: {off:e} m from where e = 0 rests, force {}", rest["plate-bladder.z"]);
        assert!(off < 1e-12 && (number(&rest["plate-bladder.z"]) / G - 1.0).abs() < 1e-9, "{own}: {off:e}");
    }
}

#[test]
fn what_falls_away_is_named_instead_of_settled() {
    for (scene, set, part) in
        [("two_cubes", "gravity=[0, 0, -9.81]", "`"), ("ball_on_tilted_bladder", "run.every=1", "`ball`")]
    {
        let said = fails(&["settle", scene, "--set", set]);
        assert!(said.contains("does not come to rest") && said.contains(part), "{scene}: {said}");
    }
}

/// The bed's ball lies on the middles of two stiff rims, or on eight nodes of four: it sticks to all of them. What
/// pushes it out of one is not held back by the others, and tiles whose laws begin to rise do not lift it.
#[test]
fn a_ball_between_stiff_rims_comes_to_rest() {
    let bed = std::fs::read_to_string(find("scenes/bed").expect("the bed")).expect("text");
    let (count, middle) = ("count = [7, 4]", "[\"0.9_m\", \"0.45_m\", 0]");
    assert!(bed.matches(count).count() == 2 && bed.contains(middle), "the bed is not what it was");
    // Tiles, where the ball lies, and how far from its middle line the nodes are that bear it (m).
    let cases = [("[1, 2]", "[0, 0.15, 0]", 0.01), ("[2, 2]", "[0.15, 0.15, 0]", 0.08_f64.hypot(0.01))];
    for (name, (tiles, place, off)) in ["two_rims", "four_rims"].into_iter().zip(cases) {
        let text = bed.replace(count, &format!("count = {tiles}")).replace(middle, place);
        let done = settled(&[&scene(name, &text)]);
        let (steps, z) = (number(&done["steps"]), number(&done["last"]["ball.z"]));
        let expected = 0.05 + (0.2_f64.powi(2) - off * off).sqrt();
        println!("{name}: {steps} steps, off by {:e} m", z - expected);
        assert!(steps < 5e3 && (z - expected).abs() < 1e-12, "{name}: {z} m, not {expected}");
    }
}

/// A bladder of gauge pressure p under a plate that stands level with its rim.
const PRESSED: &str = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.bladder]\nshape = \"sheet\"\n\
    rows = 5\ncolumns = 5\nwidth = \"0.28_m\"\ndepth = \"0.28_m\"\nbase = \"40_mm\"\nmass = 1e-3\nK = \"2 kN/m\"\nC = 0.01\n\
    start = { position = [0, 0, \"40_mm\"] }\ngas = { gauge = \"1_kPa\" }\n\
    attach = [{ nodes = \"rim\", to = \"ground\" }, { facets = \"base\", to = \"ground\" }]\n\
    [parts.plate]\nrigid = \"box\"\nsize = [\"0.4_m\", \"0.4_m\", \"10_mm\"]\nfixed = true\n\
    start = { position = [\"0.14_m\", \"0.14_m\", 0], height = \"40_mm\" }\n\
    [[contacts]]\nbetween = [\"plate\", \"bladder\"]\nimpact = \"moreau\"\n[run]\nstep = 1e-4\n";

/// The plate keeps the sheet flat: gas presses it on with p A, of which the rim bears half a facet on each side, less
/// the sheet's weight (2 kg).
#[test]
fn the_force_on_a_flat_plate_tends_to_pressure_times_area_with_order_one() {
    let scene = scene("pressed", PRESSED);
    let missing = [27_usize, 53, 105].map(|nodes| {
        // The rim counts as nodes of a side.
        let free = nodes - 2;
        let mut changes: Vec<String> =
            ["rows", "columns"].map(|key| format!("parts.bladder.{key}={free}")).to_vec();
        changes.push(format!("parts.bladder.mass={:e}", 2.0 / (free * free) as f64));
        let rest = at_rest(&scene, &changes);
        assert_eq!(number(&rest["plate-bladder.points"]), (free * free) as f64);
        let share = (number(&rest["plate-bladder.z"]) + 2.0 * G) / (1000.0 * 0.28 * 0.28);
        println!("{nodes} nodes a side: N/(p A) = {share}");
        1.0 - share
    });
    for pair in missing.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((0.9..1.1).contains(&order), "{missing:?}: order {order}");
    }
    assert!(missing[2] < 0.02, "{missing:?}");
    // Without weight nothing but the rounding of places says what counts as rest.
    let weightless = at_rest(&scene, &["gravity=[0, 0, 0]".to_owned()]);
    // Five of six intervals a side; a facet at a corner of the frame is a triangle.
    let area = 0.28_f64.powi(2) * (25.0 - 4.0 / 12.0) / 36.0;
    let force = number(&weightless["plate-bladder.z"]);
    assert!((force / (1000.0 * area) - 1.0).abs() < 1e-9, "{force} {area}");
}

#[test]
fn nothing_happens_in_ten_seconds_from_equilibrium() {
    for scene in ["plate_on_bladder", "ball_on_bladder"] {
        let done = json(&[scene, "--set", "run.start=settled", "--seconds", "10"]);
        assert_eq!(done["events"].as_array().map(Vec::len), Some(0), "{scene}: {}", done["events"]);
        let kinetic = number(&done["last"]["kinetic"]);
        assert!(kinetic < 1e-16, "{scene}: {kinetic:e} J");
    }
}

/// A turning box on a slab that may slide too.
const SLIDES: &str = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.slab]\nrigid = \"box\"\nmass = \"5_kg\"\n\
    size = [\"4_m\", \"1_m\", \"0.1_m\"]\nstart = { position = [0, 0, \"0.05_m\"] }\n\
    [parts.box]\nrigid = \"box\"\nsize = [\"0.3_m\", \"0.2_m\", \"0.1_m\"]\nmass = \"2_kg\"\n\
    start = { position = [\"-1_m\", 0, \"0.15_m\"], axis = [0, 0, 1], angle = \"20_deg\", velocity = [\"2 m/s\", 0, 0], \
    spin = [0, 0, \"1 rad/s\"] }\n[run]\nseconds = 0.8\nstep = \"1_ms\"\n";

#[test]
fn flat_faces_slide_without_jitter() {
    let scene = scene("slides", SLIDES);
    for law in ["plastic", "moreau", "compensation", "stronge"] {
        let contacts = format!(
            "contacts=[{{ between = [\"box\", \"slab\"], impact = \"{law}\", friction = 0.2 }}, \
             {{ between = [\"slab\", \"ground\"], impact = \"{law}\", friction = 0.01 }}]"
        );
        let (names, rows) = rows(&[&scene, "--set", &contacts]);
        let column = |name: &str| names.iter().position(|n| n == name).expect(name);
        for (pair, mass) in [("box-slab", 2.0), ("slab-ground", 7.0)] {
            let [normal, points] = ["normal", "points"].map(|number| column(&format!("{pair}.{number}")));
            let forces = rows.iter().skip(1).map(|row| row[normal] / (mass * G) - 1.0);
            let off = forces.fold(0.0_f64, |most, x| most.max(x.abs()));
            println!("{law}, {pair}: normal force within {off:e} of the weight");
            assert!(rows.iter().skip(1).all(|row| row[points] == 4.0), "{law}, {pair}");
            assert!(off < 1e-9, "{law}, {pair}: {off:e}");
        }
        let (first, last) = (&rows[0], rows.last().expect("rows"));
        let slid = last[column("box.x")] - first[column("box.x")];
        assert!(slid > 0.5, "{law}: {slid}");
    }
}

/// Two free balls that overlap are moved apart along the line of their centres, each by half the overlap.
#[test]
fn free_parts_that_overlap_are_moved_apart() {
    let ball = |name: &str, x: f64| {
        format!(
            "[parts.{name}]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = {{ height = 0, position = [{x}, 0, 0] }}\n"
        )
    };
    let touch = |pair: &str| format!("[[contacts]]\nbetween = {pair}\nimpact = \"moreau\"\n");
    let contacts = ["[\"a\", \"g\"]", "[\"b\", \"g\"]", "[\"a\", \"b\"]"].map(touch).concat();
    let text = format!(
        "format = 2\n[parts.g]\nrigid = \"half_space\"\n{}{}{contacts}",
        ball("a", 0.0),
        ball("b", 0.15)
    );
    let run = "[run]\nseconds = 0.01\n";
    let file = scene("overlapping", &(text.clone() + run));
    let said = fails(&["run", &file]);
    assert!(
        said.contains("overlap by 5.000e-2 m") && said.contains("start = \"settled\" under [run]"),
        "{said}"
    );
    let begun = scene("moved_apart", &(text + run + "start = \"settled\"\n"));
    for done in [settled(&[&file]), json(&[&begun])] {
        for (name, x) in [("a.x", -0.025), ("b.x", 0.175), ("a.z", 0.1)] {
            let found = number(&done["last"][name]);
            assert!((found - x).abs() < 1e-6, "{name}: {found}");
        }
    }
}

/// Balanced forces leave rounding noise of the speeds, which no iteration makes smaller.
#[test]
fn a_mechanism_at_rest_stands_with_methods_that_iterate() {
    let text = "format = 2\n[parts.tile]\nmechanism = \"tile_reactions\"\n[run]\nseconds = 0.05\n";
    let file = scene("rest_iterated", text);
    for method in ["verlet", "blanes_moan4", "implicit_midpoint"] {
        for step in ["1e-3", "1e-5"] {
            let done = json(&[&file, "--method", method, "--step", step]);
            assert!(
                number(&done["imbalance"]).abs() < 1e-13 && number(&done["last"]["kinetic"]) < 1e-25,
                "{method}: {done}"
            );
        }
    }
    for method in ["verlet", "blanes_moan4"] {
        let arguments = [
            "tile_bladder_coupled",
            "--method",
            method,
            "--set",
            "run.start=\"settled\"",
            "--seconds",
            "0.6",
        ];
        let done = json(&arguments);
        assert!(number(&done["last"]["kinetic"]) < 1e-15, "{method}: {done}");
    }
}

/// A part on the ground, with friction.
fn on_ground(part: &str, friction: f64) -> String {
    format!(
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.load]\n{part}\nmass = 2\n[[contacts]]\n\
         between = [\"load\", \"ground\"]\nimpact = \"moreau\"\nfriction = {friction}\n[run]\nseconds = 0.01\n"
    )
}

/// A pendulum that begins at an angle (degrees).
fn pendulum(angle: f64) -> String {
    format!(
        "format = 2\n[parts.load]\nmechanism = \"pendulum\"\nstart = {{ q = \"{angle}_deg\" }}\n[run]\nseconds = 0.01\n"
    )
}

const BOX: &str = "rigid = \"box\"\nsize = [0.1, 0.1, 0.1]\n";

#[test]
fn unstable_equilibria_are_named() {
    let edge = format!("{BOX}start = {{ axis = [0, 1, 0], angle = \"45_deg\", height = 0 }}");
    let cases = [("up", pendulum(180.0)), ("edge", on_ground(&edge, 0.5))];
    for (name, text) in cases {
        for step in ["1e-2", "1e-3", "1e-4"] {
            let (file, step) = (scene(name, &text), format!("run.step={step}"));
            let done = settled(&[&file, "--set", &step]);
            assert_eq!(done["unstable"], "load", "{name}, {step}: {done}");
            let begun = smartbed(&[
                "run",
                &file,
                "--set",
                &step,
                "--set",
                "run.start=settled",
                "--set",
                "run.seconds=0.1",
            ]);
            let said = String::from_utf8_lossy(&begun.stderr);
            assert!(said.contains("`load` is balanced in an unstable equilibrium"), "{name}, {step}: {said}");
        }
    }
    assert_eq!(settled(&["ball_on_bladder"])["unstable"], "ball");
}

/// What keeps a disturbance or comes back is not called unstable.
#[test]
fn neutral_and_stable_equilibria_are_not_called_unstable() {
    let ball = "rigid = \"sphere\"\nradius = 0.1\nstart = { height = 0 }";
    let flat = format!("{BOX}start = {{ height = 0 }}");
    let thin = "rigid = \"box\"\nsize = [0.02, 0.02, 1]\nstart = { height = 0 }";
    let steep = "gravity = [4, 0, -9]\n";
    let slope = on_ground(&flat, 0.5).replacen("[parts.ground]", &format!("{steep}[parts.ground]"), 1);
    let cases = [
        ("rolls", on_ground(ball, 0.5)),
        ("slips", on_ground(ball, 0.0)),
        ("flat", on_ground(&flat, 0.5)),
        ("smooth", on_ground(&flat, 0.0)),
        ("thin", on_ground(thin, 0.5)),
        ("slope", slope),
        ("hangs", pendulum(0.0)),
        ("swings", pendulum(170.0)),
    ];
    for (name, text) in cases {
        let done = settled(&[&scene(name, &text)]);
        assert!(done["unstable"].is_null(), "{name}: {done}");
    }
    for scene in
        ["plate_on_bladder", "stack_cubes", "tile_with_bladder", "tile_bladder_coupled", "closed_loop_hung"]
    {
        assert!(settled(&[scene])["unstable"].is_null(), "{scene}");
    }
}

/// A mass of 1e6 kg between soft springs: a quarter of its period takes 3e5 steps of 1 ms.
#[test]
fn a_heavy_part_is_settled_by_larger_steps() {
    let text = "format = 2\ngravity = [0, 0, 0]\n[parts.s]\npoints = [[0, 0, 0], [1, 0, 0], [3, 0, 0], [3, 1, 0]]\n\
                springs = [[0, 1], [1, 2], [1, 3]]\nrest_lengths = [0.5, 0.7, 0.8]\nmass = [1, 1e6, 1, 1]\n\
                K = [10, 20, 30]\nfixed = [0, 2, 3]\n[run]\nseconds = 1\n";
    let file = scene("heavy", text);
    let said = fails(&["settle", &file]);
    assert!(said.contains("a larger step brings it further") && !said.contains("smaller"), "{said}");
    settled(&[&file, "--set", "run.step=1"]);
}
