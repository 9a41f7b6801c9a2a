//! `energy_momentum` in worlds: the imbalance of the ledger is rounding.

use super::support::{self, fails, json, number};

const SCENES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes");

/// The largest imbalance of a run, and its last accounts: impact, friction, damping, actuator (J).
fn books(arguments: &[&str]) -> (f64, [f64; 4]) {
    let done = json(&[arguments, &["--method", "energy_momentum"]].concat());
    let accounts = ["impact", "friction", "damping", "actuator"].map(|name| number(&done["last"][name]));
    println!("{arguments:?}: imbalance {:e}, {accounts:?}", number(&done["imbalance"]));
    (number(&done["imbalance"]).abs(), accounts)
}

const UNDAMPED: [&str; 4] = ["--set", "parts.bladder.C=0", "--set", "parts.bladder.air_drag=0"];

#[test]
fn five_kilograms_dropped_by_20_mm_without_dampers_close_the_account_at_the_scene_s_step() {
    let drop = [
        "ball_on_bladder",
        "--seconds",
        "0.3",
        "--set",
        "parts.ball.mass=5_kg",
        "--set",
        "parts.ball.start.height=60_mm",
    ];
    let fell = 5.0 * 9.81 * 0.02;
    let (imbalance, [impact, ..]) = books(&[&drop[..], &UNDAMPED[..]].concat());
    assert!(imbalance < 1e-6 * fell && impact > 1e-3, "{imbalance:e}");
    // It is the method of a world that nothing damps.
    let chosen = json(&[&drop[..], &UNDAMPED[..]].concat());
    let method = chosen["method"].as_str().expect("a text");
    assert!(method.starts_with("energy_momentum"), "{method}");
    assert!(number(&chosen["imbalance"]).abs() < 1e-6 * fell);
    // With dampers and air as well.
    let (imbalance, [_, _, damping, _]) = books(&drop);
    assert!(imbalance < 1e-6 * fell && damping > 1e-2, "{imbalance:e}");
}

#[test]
fn a_commanded_tile_pays_for_its_bladder_to_rounding() {
    let (imbalance, [.., drive]) = books(&["tile_with_bladder", "--seconds", "0.5"]);
    assert!(imbalance < 1e-9 * drive.abs(), "{imbalance:e} of {drive:e}");
}

/// A disc that turns to and fro.
const DISC: &str = "format = 1\nname = \"disc\"\ndof = 1\n[parameters]\nI = { value = 0.05, unit = \"kg m^2\" }\n\
                    [coordinates]\nq = { unit = \"rad\", independent = true }\n[frames]\ndisc = { rotations = [[\"z\", \"q\"]] }\n\
                    [points]\ntop = \"0.1_m*N.z\"\n[bodies]\ndisc = { centre = \"top\", frame = \"disc\", inertia = { Izz = \"I\" } }\n\
                    [ports]\ntop = { point = \"top\", frame = \"disc\" }\n";
/// A bladder beside its axis.
const ON_DISC: &str = "format = 2\ntitle = \"a bladder on a disc\"\n[parts.turn]\nmechanism = \"conserving_disc\"\ncommand = { q = \"1_rad*sin(2*pi*t/0.5_s)\" }\n\
                       [parts.bladder]\nshape = \"sheet\"\nrows = 5\ncolumns = 5\nwidth = \"0.28_m\"\ndepth = \"0.28_m\"\n\
                       base = \"40_mm\"\nmass = \"50_g\"\nK = \"2 kN/m\"\nC = \"2 N s/m\"\n\
                       start = { position = [\"0.1_m\", \"-0.14_m\", \"40_mm\"] }\ngas = { gauge = \"1_kPa\" }\n\
                       attach = [{ nodes = \"rim\", to = \"turn.top\" }, { facets = \"base\", to = \"turn.top\" }]\n\
                       [run]\nseconds = 0.5\n";

#[test]
fn a_turntable_pays_for_its_bladder_to_rounding_and_for_itself_to_order_4() {
    support::scene("conserving_disc", DISC);
    let scene = support::scene("conserving_on_disc", ON_DISC);
    let run = |more: &[&str]| books(&[&[&scene as &str], more].concat()).0;
    let [coarse, fine] = ["2e-3", "1e-3"].map(|step| run(&["--step", step]));
    assert!((12.0..20.0).contains(&(coarse / fine)) && coarse < 2e-8, "{coarse:e} {fine:e}");
    let light = run(&["--step", "2e-3", "--set", "parts.turn.set={ I = 1e-9 }"]);
    assert!(light < 1e-12, "{light:e}");
}

#[test]
fn a_mechanism_under_a_bladder_keeps_the_order_of_the_middle() {
    let run = |step: &str| books(&["tile_bladder_coupled", "--seconds", "0.2", "--step", step]).0;
    let [coarse, fine] = ["2e-4", "1e-4"].map(run);
    assert!((3.0..5.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
}

#[test]
fn a_method_that_the_contacts_cannot_have_is_refused_by_name() {
    let says = |arguments: &[&str], words: &str| {
        let said = fails(&[&["run"], arguments].concat());
        assert!(said.contains(words), "{arguments:?}: {said}");
    };
    says(&["ball_on_bladder", "--method", "rk4"], "need a method of whole steps");
    says(&["ball_on_bladder", "--method", "rk4"], "help: leave the key out, or take energy_momentum");
    says(&["tile_with_bladder", "--method", "moreau"], "this world has no contacts");
    let changed = |name: &str, old: &str, new: &str| {
        let text = std::fs::read_to_string(format!("{SCENES}/{name}.toml")).expect("a scene");
        support::scene(&format!("conserving_{name}"), &text.replace(old, new))
    };
    let located = changed("ball_on_bladder", "\"moreau\"", "\"compensation\"");
    says(&[&located, "--method", "energy_momentum"], "steps are split at located touches");
    let file = changed("tile_with_bladder", "[run]", "[run]\nmethod = \"energy_momentum\"");
    let chip = fails(&["firmware", &file]);
    assert!(chip.contains("the chip has verlet, rk4"), "{chip}");
}
