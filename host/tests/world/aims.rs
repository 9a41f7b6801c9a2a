//! `--error`, `--budget` and `report` of worlds: the chosen method and step meet the request.

use super::support::{fails, json, number, run, smartbed};
use std::path::Path;

/// Largest difference of two runs' coordinates at their ends (m, rad, or of an Euler parameter).
fn apart(one: &serde_json::Value, other: &serde_json::Value) -> f64 {
    let (one, other) = (one["last"].as_object().expect("a row"), other["last"].as_object().expect("a row"));
    let is_place = |name: &str| {
        let own = name.rsplit('.').next().unwrap_or_default();
        name.contains('.') && ["x", "y", "z", "e"].iter().any(|axis| own.starts_with(axis))
    };
    let names = one.keys().filter(|name| is_place(name));
    names.map(|name| (number(&one[name]) - number(&other[name])).abs()).fold(0.0, f64::max)
}

#[test]
fn a_smooth_world_is_as_exact_as_asked() {
    for scene in ["tile_with_bladder", "damper_mass_fixed_end"] {
        let fine = json(&[scene, "--seconds", "0.2", "--method", "rk4", "--step", "2e-5"]);
        for error in [1e-4, 1e-8] {
            let picked = json(&[scene, "--seconds", "0.2", "--error", &error.to_string()]);
            let apart = apart(&picked, &fine);
            assert!(apart <= error, "{scene} {error}: {apart:e} by {}", picked["method"]);
            assert!(number(&picked["steps"]) < 1e4, "{scene}");
        }
    }
}

#[test]
fn a_world_with_contacts_is_as_exact_as_its_reference_can_say() {
    let scene = ["box_bounce", "--seconds", "0.5"];
    let fine = json(&[&scene[..], &["--step", "2e-5"]].concat());
    let picked = json(&[&scene[..], &["--error", "1e-4"]].concat());
    assert!(apart(&picked, &fine) <= 1e-4, "{:e}", apart(&picked, &fine));
    let output = smartbed(&["run", "ball_on_bladder", "--seconds", "0.1", "--error", "1e-3"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && said.contains("picked --method moreau"), "{said}");
    assert!(said.contains("its own step at"), "{said}");
    let said = fails(&["run", "ball_on_bladder", "--seconds", "0.1", "--error", "1e-13"]);
    assert!(said.contains("not met by any of") && said.contains("nearest is"), "{said}");
}

#[test]
fn a_budget_is_kept_and_a_method_that_a_world_has_not_is_refused() {
    let output = smartbed(&["run", "closed_loop_hung", "--seconds", "0.1", "--budget", "1s"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && said.contains("--budget 1.000 s: picked --method"), "{said}");
    let said = fails(&["run", "box_bounce", "--method", "rk4", "--error", "1e-3"]);
    assert!(said.contains("`box_bounce` has no such method"), "{said}");
    let said = fails(&["run", "box_bounce", "--error=-1"]);
    assert!(said.contains("expected a number above 0"), "{said}");
}

#[test]
fn worlds_are_reported_beside_mechanisms() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("worlds").display().to_string();
    let told =
        run(&["report", "closed_loop_hung", "rigid_ball_rests", "pendulum3", "--quick", "--out", &folder]);
    assert!(told.contains("3 subjects"), "{told}");
    let text = std::fs::read_to_string(Path::new(&folder).join("report.json")).expect("a report");
    let report: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let points = report["points"].as_array().expect("points");
    let has = |subject: &str, method: &str| {
        points
            .iter()
            .filter(|p| p["subject"] == subject && p["method"] == method && p["scalar"] == "f64")
            .count()
    };
    assert!(has("closed_loop_hung", "rk4") >= 2 && has("closed_loop_hung", "euler") >= 1, "{text}");
    assert!(has("rigid_ball_rests", "rigid") + has("rigid_ball_rests", "moreau") >= 1, "{text}");
    assert!(points.iter().all(|p| p["scalar"] == "f64" || p["subject"] == "pendulum3"), "worlds are f64");
}
