//! Worlds in f32, as the chip moves them: every number is one of f32, near f64's, and what f32 cannot do is refused.

use super::support::{fails, json, rows, scene};
use std::path::Path;

/// Largest |a - b| over 1 + |b| of the places that a scene's rows show by default, in f32 against f64.
fn apart(name: &str, seconds: &str) -> f64 {
    let (names, wide) = rows(&[name, "--seconds", seconds]);
    let (_, single) = rows(&[name, "--seconds", seconds, "--scalar", "f32"]);
    assert_eq!(wide.len(), single.len(), "{name}");
    let state = 1..names.iter().position(|name| name == "kinetic").expect("energies behind the state");
    let is_place = |column: &usize| !names[*column].contains('-') && !names[*column].ends_with(".gauge");
    let places: Vec<usize> = state.filter(is_place).collect();
    let (mut most, mut moved) = (0.0_f64, false);
    for (wide, single) in wide.iter().zip(&single) {
        for column in &places {
            let (b, a) = (wide[*column], single[*column]);
            assert_eq!(f64::from(a as f32), a, "{name}: {} = {a:e} is no number of f32", names[*column]);
            most = most.max((a - b).abs() / (1.0 + b.abs()));
            moved |= a != b;
        }
    }
    assert!(moved, "{name}: f32 that rounds nothing is f64");
    most
}

#[test]
fn single_precision_is_near_double() {
    // A tile driven by forces under a bladder; a ball that falls on one.
    for (name, seconds, most) in [("tile_bladder_coupled", "0.1", 1e-6), ("ball_on_bladder", "0.1", 1e-5)] {
        let apart = apart(name, seconds);
        println!("{name}: f32 is {apart:.1e} off");
        assert!(apart < most, "{name}: {apart:e}");
    }
}

#[test]
fn a_rigid_body_without_contacts_flies_in_single_precision() {
    let text = "format = 2\n[parts.b]\nrigid = \"box\"\nsize = [0.1, 0.2, 0.3]\nmass = 1\n\
                start = { velocity = [1, 0, 0.3], spin = [3, 1, 2] }\n[run]\nseconds = 0.2\n";
    let file = scene("single_flight", text);
    let last = |scalar: &str| json(&[&file, "--scalar", scalar])["last"].clone();
    let [wide, single] = ["f64", "f32"].map(last);
    for name in ["b.x", "b.z", "b.e1", "b.wx"] {
        let [wide, single] = [&wide, &single].map(|last| last[name].as_f64().expect("a number"));
        assert!((wide - single).abs() < 3e-6 && wide != single, "{name}: {wide} {single}");
        assert_eq!(f64::from(single as f32), single, "{name}");
    }
    // No contacts that could have another law.
    let said = fails(&["run", &file, "--set", "run.sleep=0.1"]);
    assert!(said.contains("leave the key out") && !said.contains("moreau"), "{said}");
}

#[test]
fn a_start_at_rest_is_found_in_double_and_rounded() {
    let start = ["plate_on_bladder", "--set", "run.start=\"settled\"", "--seconds", "0.002"];
    let (names, wide) = rows(&start);
    let (_, single) = rows(&[&start[..], &["--scalar", "f32"]].concat());
    // Whatever stands in the state itself: the node in the middle is held by nothing.
    let state = ["plate.x", "plate.y", "plate.z", "bladder.x24", "bladder.y24", "bladder.z24"];
    for own in state {
        let column = names.iter().position(|name| name == own).expect("a column");
        assert_eq!(single[0][column], f64::from(wide[0][column] as f32), "{own}");
    }
}

#[test]
fn a_run_in_single_precision_is_resumed_bit_for_bit() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("single.state").display().to_string();
    let single = ["--scalar", "f32"];
    let run = |more: &[&str]| json(&[&["ball_on_bladder"], more, &single[..]].concat());
    let whole = run(&["--seconds", "0.06"]);
    run(&["--seconds", "0.04", "--save", &file]);
    let resumed = run(&["--seconds", "0.06", "--resume", &file]);
    assert_eq!(whole["last"], resumed["last"]);
    // Neither is a state of f32 continued in f64, nor the reverse; a file that says no scalar is one of f64.
    let said = fails(&["run", "ball_on_bladder", "--resume", &file]);
    assert!(said.contains("reached in f32, the run computes in f64; give --scalar f32"), "{said}");
    let text = std::fs::read_to_string(&file).expect("a state");
    std::fs::write(&file, text.replace("\"scalar\":\"f32\",", "")).expect("written");
    let said = fails(&["run", "ball_on_bladder", "--resume", &file, "--scalar", "f32"]);
    assert!(said.contains("reached in f64, the run computes in f32; give --scalar f64"), "{said}");
    assert!(
        whole["method"].as_str().is_some_and(|method| method.ends_with(", in f32")),
        "{}",
        whole["method"]
    );
}

#[test]
fn what_single_precision_cannot_do_is_refused_by_name() {
    let ball = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/ball_on_bladder.toml");
    let ball = std::fs::read_to_string(ball).expect("a scene").replace("moreau", "compensation");
    for located in ["box_bounce", &scene("single_located", &ball)] {
        let said = fails(&["run", located, "--scalar", "f32"]);
        assert!(said.contains("--scalar f32: touches are located in f64 only"), "{said}");
    }
    let said = fails(&["run", "bed", "--scalar", "f32", "--set", "run.sleep=1e-3_m/s"]);
    assert!(said.contains("--scalar f32: run.sleep"), "{said}");
    let said = fails(&["run", "ball_on_bladder", "--scalar", "f32", "--error", "1e-3"]);
    assert!(said.contains("--scalar f32") && said.contains("give --step"), "{said}");
}

/// Positions of the bed's nodes with 27 x 27 of them a sheet, every 20 ms for 0.2 s: row by row.
fn positions(scalar: &str, step: f64) -> Vec<Vec<f64>> {
    let (step, every) = (step.to_string(), (0.02 / step).round().to_string());
    let asked = ["bed", "--scalar", scalar, "--seconds", "0.2", "--step", &step, "--every", &every];
    let grid = ["--set", "parts.bladder.rows=27", "--set", "parts.bladder.columns=27"];
    let (names, found) = rows(&[&asked[..], &grid].concat());
    let is_place = |name: &str| {
        let last = name.rsplit('.').next().unwrap_or_default().trim_end_matches(|c: char| c.is_ascii_digit());
        name.starts_with("bladder[") && ["x", "y", "z"].contains(&last)
    };
    let places: Vec<usize> = (0..names.len()).filter(|column| is_place(&names[*column])).collect();
    found.iter().map(|row| places.iter().map(|column| row[*column]).collect()).collect()
}

/// Mean distance of nodes at all moments.
fn mean_distance<'r>(pairs: impl Iterator<Item = (&'r Vec<f64>, &'r Vec<f64>)>) -> f64 {
    let (mut sum, mut count) = (0.0, 0);
    for (one, other) in pairs {
        for (a, b) in one.chunks_exact(3).zip(other.chunks_exact(3)) {
            sum += a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
            count += 1;
        }
    }
    sum / f64::from(count)
}

/// `python3 tests/bed_in_f32.py` asks for the processor time at such a step, and goes on to 0.4 s.
#[test]
fn on_the_thesis_grid_f32_is_within_a_thousandth_at_2_5_ms() {
    let [exact, found] = [("f64", 2.5e-4), ("f32", 2.5e-3)].map(|(scalar, step)| positions(scalar, step));
    // Base and rim are nodes, too.
    assert!(exact.len() == 11 && found.len() == 11 && exact[0].len() > 28 * 27 * 27 * 3);
    let moved = mean_distance(exact.iter().map(|row| (&exact[0], row)));
    let error = mean_distance(exact.iter().zip(&found)) / moved;
    println!("moved by {moved:e} m, error {error:e}");
    assert!(moved > 5e-4 && error < 1e-3, "{error}");
}
