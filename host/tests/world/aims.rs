//! `--error`, `--budget` and `report` of worlds: the chosen method and step meet the request.

use super::support::{fails, json, number, run, scene, smartbed};
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

/// Rows of a run at whole milliseconds: time, then the columns of these names.
fn rows(arguments: &[&str], columns: &[&str]) -> Vec<Vec<f64>> {
    let output = smartbed(&[&["run"], arguments, &["--csv", "-"]].concat());
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && !told.contains("warning: --error"), "{told}");
    let text = String::from_utf8(output.stdout).expect("text");
    let mut lines = text.lines().map(|line| line.split(','));
    let names: Vec<&str> = lines.next().expect("names").collect();
    let is_shown = |n: &usize| *n == 0 || columns.contains(&names[*n]);
    let shown: Vec<usize> = (0..names.len()).filter(is_shown).collect();
    let numbers = lines.map(|line| line.map(|x| x.parse().unwrap_or(f64::NAN)).collect::<Vec<f64>>());
    let rows = numbers.map(|row| shown.iter().map(|n| row[*n]).collect::<Vec<f64>>());
    rows.filter(|row| (1e3 * row[0] - (1e3 * row[0]).round()).abs() < 1e-6).collect()
}

/// Asserts that a run keeps an error over all of its time, by an independent run at a much smaller step.
fn assert_kept(scene: &[&str], asked: f64, fine: &[&str], columns: &[&str]) {
    let found = rows(&[scene, &["--error", &asked.to_string()]].concat(), columns);
    let exact = rows(&[scene, fine].concat(), columns);
    assert!(
        found.len() == exact.len() && found[0].len() == 1 + columns.len(),
        "{} and {} rows",
        found.len(),
        exact.len()
    );
    let differences = found.iter().flatten().zip(exact.iter().flatten()).map(|(a, b)| (a - b).abs());
    let error = differences.fold(0.0, f64::max);
    assert!(error <= asked, "{scene:?}: {error:e} of {asked:e}");
}

/// The sheet's oscillation drifts from the exact one long after the start that has a reference.
#[test]
fn an_error_is_kept_over_the_whole_run() {
    let scene = ["tile_with_bladder", "--method", "rk4"];
    let columns = ["bladder.x24", "bladder.y24", "bladder.z24", "bladder.z16", "bladder.z32", "tile.hA"];
    assert_kept(&scene, 1e-4, &["--step", "1e-4", "--set", "run.every=10"], &columns);
}

/// Box, ball and capsule strike the ground, and one another, after the start that has a reference.
#[test]
fn an_error_is_kept_beyond_the_first_contact() {
    let part = |(name, shape, start): (&str, &str, &str)| {
        format!("[parts.{name}]\nrigid = {shape}\nstart = {{ position = {start} }}\n")
    };
    let parts = [
        (
            "box",
            "\"box\"\nsize = [0.3, 0.2, 0.1]\nmass = 2",
            "[0.1, 0.05, 0.35], axis = [1.0, 2.0, 0.5], angle = 0.4, velocity = [0.5, 0.3, 0.0], spin = [1.0, -2.0, 3.0]",
        ),
        (
            "ball",
            "\"sphere\"\nradius = 0.1\nmass = 1",
            "[-0.5, 0.1, 0.4], velocity = [1.5, 0.2, 0.0], spin = [3.0, 4.0, -5.0]",
        ),
        (
            "cap",
            "\"capsule\"\nradius = 0.05\nlength = 0.2\nmass = 0.5",
            "[0.6, -0.4, 0.3], axis = [0.3, 1.0, 0.0], angle = 1.2, velocity = [-0.5, 0.6, 0.0]",
        ),
    ];
    let pairs = [
        ("box", "ground"),
        ("ball", "ground"),
        ("cap", "ground"),
        ("ball", "box"),
        ("cap", "box"),
        ("ball", "cap"),
    ];
    let contact = |(one, other): (&str, &str)| {
        let law = "impact = \"moreau\"\nfriction = 0.3\nrestitution = 0.2";
        format!("[[contacts]]\nbetween = [\"{one}\", \"{other}\"]\n{law}\n")
    };
    let text: String = parts.into_iter().map(part).chain(pairs.into_iter().map(contact)).collect();
    let ground = "format = 2\ngravity = [0.0, 0.0, -9.81]\n[parts.ground]\nrigid = \"half_space\"\n";
    let scene = scene("strikes", &format!("{ground}{text}[run]\nseconds = 0.4\nstep = \"1_ms\"\n"));
    let columns = ["box.x", "box.y", "box.z", "ball.x", "ball.y", "ball.z", "cap.x", "cap.y", "cap.z"];
    assert_kept(&[&scene], 1e-3, &["--step", "2e-6", "--set", "run.every=500"], &columns);
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

/// A world with contacts is measured with laws of both kinds, whose methods have different names, over the same time.
#[test]
fn laws_of_the_other_kind_are_measured_beside_the_own() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n\
                start = { height = 0.1, velocity = [1, 0, 0] }\n[[contacts]]\nbetween = [\"ball\", \"ground\"]\nimpact = \"LAW\"\n\
                restitution = 0.5\nfriction = 0.3\n[run]\nseconds = 0.3\n";
    let places = [("stronge", "rigid", "moreau"), ("moreau", "moreau", "rigid")];
    for (law, own, other) in places {
        let file = scene(law, &text.replace("LAW", law));
        let folder = format!("{file}.report");
        let report = |more: &[&str]| -> serde_json::Value {
            run(&[&["report", &file, "--quick", "--seconds", "0.3", "--out", &folder], more].concat());
            let text = std::fs::read_to_string(Path::new(&folder).join("report.json")).expect("a report");
            serde_json::from_str(&text).expect("JSON")
        };
        let points = |report: &serde_json::Value, method: &str| {
            let all = report["points"].as_array().expect("points").iter();
            all.filter(|point| point["method"] == method).count()
        };
        let both = report(&[]);
        assert!(points(&both, own) >= 1 && points(&both, other) >= 1, "{law}: {both:#}");
        let notes = both["subjects"][0]["notes"].to_string();
        assert!(
            notes.contains("in place of") && notes.contains("the two references differ by up to"),
            "{notes}"
        );
        // The command of one of its points measures only that.
        let again = report(&["--method", other, "--step", "1e-3"]);
        assert!(points(&again, own) == 0 && points(&again, other) == 1, "{law}: {again:#}");
    }
    let said = fails(&["report", "rigid_ball_rests", "--method", "rk5"]);
    assert!(said.contains("`rigid_ball_rests` has no such method"), "{said}");
}
