//! `smartbed report`: its files, its rows made again by their commands, its page in a browser.

use super::browser::{self, Picture};
use super::support::{Done, file, smartbed, written};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::sync::OnceLock;

/// Amber of the front and blue of the first method, as the plots draw them.
const FRONT: [u8; 3] = [255, 196, 0];
const FIRST: [u8; 3] = [0, 114, 178];

const PEERS: &str = r#"{
    "points": [{ "subject": "single_spring", "method": "another simulator", "error": 1e-3,
                 "nanoseconds": 5e12, "command": "python3 another.py" },
               { "subject": "single_spring", "method": "too short", "seconds": 1, "error": 1e-3,
                 "nanoseconds": 5e4, "command": "python3 another.py" },
               { "subject": "single_spring", "method": "from the future", "error": 1e-9,
                 "nanoseconds": 1, "command": "python3 another.py" },
               { "subject": "sleigh", "method": "exact by luck", "error": 1e-300,
                 "nanoseconds": 5e12, "command": "python3 another.py" },
               { "subject": "sleigh", "method": "one of ours, read back", "peer": false, "error": 1e-9,
                 "nanoseconds": 1, "command": "x" },
               { "subject": "somewhere else", "method": "x", "error": 1, "nanoseconds": 1, "command": "x" }],
    "tables": [{ "title": "Another table", "columns": ["a", "b"], "rows": [["1", "2"]], "command": "make it" }]
}"#;

/// A quick report of a scene and a mechanism with a point from elsewhere, made once.
fn report() -> &'static PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let (folder, peers) = (file("report"), written("peers.json", PEERS));
        let out = folder.display().to_string();
        let done =
            smartbed(&["report", "single_spring", "sleigh", "--quick", "--points", &peers, "--out", &out]);
        assert_eq!(done.status, 0, "{}", done.err);
        assert!(done.err.contains("report: sleigh (2 of 2"), "progress: {}", done.err);
        let warned: Vec<&str> = done.err.lines().filter(|l| l.starts_with("a peer dominates: ")).collect();
        assert_eq!(warned.len(), 1, "{}", done.err);
        assert!(warned[0].contains("single_spring: from the future"), "{}", warned[0]);
        folder
    })
}

fn text(name: &str) -> String {
    fs::read_to_string(report().join(name)).expect("the report has written it")
}

fn points() -> Vec<Value> {
    let report: Value = serde_json::from_str(&text("report.json")).expect("JSON");
    super::schema::holds("report", &report);
    report["points"].as_array().expect("points").clone()
}

#[test]
fn every_method_and_scalar_has_points() {
    let points = points();
    let has = |subject: &str, method: &str, scalar: &str| {
        points.iter().any(|p| p["subject"] == subject && p["method"] == method && p["scalar"] == scalar)
    };
    let body = "symplectic_euler verlet damped_verlet nystrom4 blanes_moan4 rk4 implicit_midpoint energy_momentum dormand_prince dop853";
    for scalar in ["f64", "f32"] {
        body.split(' ').for_each(|m| assert!(has("single_spring", m, scalar), "{m} {scalar}"));
        "euler rk4 dormand-prince".split(' ').for_each(|m| assert!(has("sleigh", m, scalar), "{m} {scalar}"));
    }
    assert!(has("single_spring", "another simulator", "f64"), "points from elsewhere");
    assert!(
        points.iter().all(|p| p["command"].as_str().is_some_and(|c| c.len() > 3)),
        "every row has its command"
    );
}

#[test]
fn no_point_beats_one_of_the_front() {
    for subject in ["single_spring", "sleigh"] {
        let points: Vec<(f64, f64, bool)> = points()
            .iter()
            .filter(|p| p["subject"] == subject)
            .map(|p| {
                let number = |key: &str| p[key].as_f64().expect("a number");
                (number("error"), number("nanoseconds"), p["front"] == true)
            })
            .collect();
        for (e, t, front) in &points {
            let beaten = points.iter().any(|(error, time, _)| error < e && time < t);
            assert!(!(*front && beaten), "{subject}: {e:e} {t:e}");
        }
        assert!(points.iter().filter(|p| p.2).count() >= 3, "{subject}: a front of three or more");
    }
}

#[test]
fn a_row_is_made_again_by_its_command() {
    let points = points();
    let row = |subject: &str, method: &str| {
        let found = points.iter().find(|p| p["subject"] == subject && p["method"] == method);
        found.unwrap_or_else(|| panic!("{subject} {method}"))
    };
    for row in [row("single_spring", "verlet"), row("single_spring", "dop853"), row("sleigh", "rk4")] {
        let command =
            row["command"].as_str().expect("a command").strip_prefix("cargo smartbed ").expect("ours");
        let out = file("report-row").display().to_string();
        let mut arguments: Vec<&str> = command.split(' ').collect();
        arguments.extend(["--json", "--out", &out]);
        let again = smartbed(&arguments).json();
        assert_eq!(again["points"].as_array().map(Vec::len), Some(1), "{command}");
        assert_eq!(again["points"][0]["error"], row["error"], "{command}");
        assert_eq!(again["points"][0]["evaluations"], row["evaluations"], "{command}");
    }
}

#[test]
fn other_simulators_stand_beside_ours() {
    let points = points();
    let peers: Vec<&str> =
        points.iter().filter(|p| p["peer"] == true).filter_map(|p| p["method"].as_str()).collect();
    assert_eq!(
        peers,
        ["another simulator", "from the future", "exact by luck"],
        "what ran shorter is left out"
    );
    // Nobody is more exact than the reference is sure: ours at rounding and theirs stand at the same error.
    let least = |peer: bool| {
        let errors = points
            .iter()
            .filter(|p| p["subject"] == "sleigh" && p["peer"] == peer)
            .filter_map(|p| p["error"].as_f64());
        errors.fold(f64::INFINITY, f64::min)
    };
    assert!(least(true) > 1e-17 && least(true) <= least(false), "{:e} {:e}", least(true), least(false));
    let markdown = text("report.md");
    for part in [
        "## Beside the peers",
        "| single_spring | from the future | 1 |",
        "too short: left out, over 1 s and not 3 s",
        "front, peer",
    ] {
        assert!(markdown.contains(part), "{part}");
    }
    let page = text("report.html");
    for part in ["<tr class=\"peer\">", "<tr class=\"front peer\">", ">other simulator</text>"] {
        assert!(page.contains(part), "{part}");
    }
    let report: Value = serde_json::from_str(&text("report.json")).expect("JSON");
    assert_eq!(report["dominating"].as_array().map(Vec::len), Some(1));
}

#[test]
fn tables_are_written() {
    let markdown = text("report.md");
    for part in
        ["## single_spring", "closed form (harmonic between events)", "## Another table", "| verlet | f64 |"]
    {
        assert!(markdown.contains(part), "{part}");
    }
    let csv = text("report.csv");
    let columns = csv.lines().next().expect("a header").split(',').count();
    assert!(csv.lines().all(|l| l.split(',').count() == columns), "{columns} columns");
    assert_eq!(csv.lines().count(), 1 + points().len());
    assert!(text("plots/sleigh.svg").contains("computing time per simulated second [ns]"));
}

#[test]
fn the_page_is_opened_and_exercised_in_a_browser() {
    let dom = browser::open(&report().join("report.html"), "self-test");
    // Summary and two subjects; two plots and a graph each; every point by its time, and those that tell evaluations.
    let points = points();
    let told = points.len() + points.iter().filter(|p| !p["evaluations"].is_null()).count();
    assert_eq!(dom.text("self-test"), format!("passed: 3 links, 6 plots, {told} points"));
    // The one address is the name of SVG, which nothing is fetched from.
    let outside = dom.html.replace("http://www.w3.org/2000/svg", "");
    assert!(!outside.contains("http://") && !outside.contains("https://"), "nothing comes from outside");
}

#[test]
fn the_page_is_seen() {
    let picture = Picture::read(&browser::screenshot(&report().join("report.html"), "single_spring"));
    let (front, first) = (picture.count(FRONT, 6), picture.count(FIRST, 6));
    assert!(front > 400 && first > 200, "{front} pixels of the front, {first} of the first method");
    let white = picture.count([255, 255, 255], 0);
    assert!(2 * white > picture.pixels.len(), "the page is mostly empty paper");
}

#[test]
fn what_is_wrong_is_said() {
    let said = |arguments: &[&str], part: &str| {
        let done: Done = smartbed(arguments);
        assert!(done.message().contains(part), "{arguments:?}: {}", done.err);
    };
    said(&["report", "single_sprong"], "did you mean `single_spring`");
    said(&["report", "single_spring", "--method", "varlet", "--step", "1e-3"], "did you mean `verlet`");
    said(&["report", "single_spring", "--method", "verlet", "--tolerance", "1e-3"], "expected --step");
    said(&["report", "single_spring", "--method", "dop853", "--step", "1e-3"], "expected --tolerance");
    said(&["report", "single_spring", "--step", "0"], "--step 0: expected a number above 0");
    said(&["report", "sleigh", "--quick", "--points", "nowhere.json"], "nowhere.json");
    let wrong = written("wrong-points.json", r#"{"points": [{"subject": "sleigh"}]}"#);
    said(&["report", "sleigh", "--quick", "--points", &wrong], "points[0]: expected subject, method");
}

/// Largest distance of the places in the last row of a CSV from those of another.
fn last_row(csv: &str) -> Vec<f64> {
    let row = csv.lines().last().expect("rows");
    row.split(',').skip(1).take(6).map(|x| x.parse().expect("a number")).collect()
}

#[test]
fn an_error_asked_for_is_kept() {
    let run = |more: &[&str]| {
        let mut arguments = vec!["run", "single_spring", "--csv", "-"];
        arguments.extend(more);
        let done = smartbed(&arguments);
        assert_eq!(done.status, 0, "{}", done.err);
        done
    };
    let exact = last_row(&run(&["--method", "dop853", "--tolerance", "1e-13"]).out);
    for (asked, bound) in [("1e-3", 1e-3), ("1e-7", 1e-7)] {
        let done = run(&["--error", asked]);
        assert!(done.err.contains(&format!("--error {asked}: picked --method ")), "{}", done.err);
        assert!(done.err.contains("closed form (harmonic between events)"), "why: {}", done.err);
        let error = last_row(&done.out).iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error <= bound, "{error:e} for {asked}: {}", done.err);
    }
}

/// A pendulum whose friction has kinks at +-w.
const KINKS: &str = r#"format = 1
name = "kinks"
gravity = "-g*N.z"
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 1, unit = "m" }
c = { value = 1, unit = "N m" }
w = { value = 0.05, unit = "rad/s" }
g = { value = 9.81, unit = "m/s^2" }
[coordinates]
q = { unit = "rad" }
[frames]
rod = { rotations = [["x", "q"]] }
[points]
P = "-l*rod.z"
[bodies]
bob = { centre = "P", mass = "m" }
[torques]
friction = { frame = "rod", torque = "-c*max(-1, min(1, u_q/w))*N.x" }
[start]
q = 1.5
[run]
seconds = 4
step = 1e-3
every = 400
"#;

/// At a kink the error depends on where steps end: what a calibration tells is that of the very steps of the run.
#[test]
fn the_error_told_is_that_of_the_run_where_forces_have_kinks() {
    let model = written("kinks.toml", KINKS);
    let places = |more: &[&str]| {
        let done = smartbed(&[&["run", &model, "--csv", "-"], more].concat());
        assert_eq!(done.status, 0, "{}", done.err);
        let place = |row: &str| row.split(',').nth(1).and_then(|q| q.parse::<f64>().ok()).expect("a number");
        (done.out.lines().skip(1).take(11).map(place).collect::<Vec<f64>>(), done.err)
    };
    // Steps of 1e-5 s meet each kink within 1e-5 s: some 1e-10 rad.
    let (exact, _) = places(&["--method", "rk4", "--step", "1e-5", "--every", "40000"]);
    for asked in ["1e-5", "1e-6", "1e-7"] {
        let (found, said) = places(&["--error", asked, "--method", "dormand-prince"]);
        let error = found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let told = said.split_once(": error ").and_then(|(_, rest)| rest.split(',').next());
        let told: f64 = told.and_then(|x| x.parse().ok()).unwrap_or_else(|| panic!("{said}"));
        assert!((told / error - 1.0).abs() < 0.05, "{told:e} told of {error:e}: {said}");
    }
}

/// What stands still has an answer, though its rounding is more than its motion.
#[test]
fn an_error_is_told_of_what_stands_still() {
    let done = smartbed(&["run", "tile_reactions", "--seconds", "0.6", "--error", "1e-8"]);
    assert_eq!(done.status, 0, "{}", done.err);
    assert!(done.err.contains("--error 1e-8: picked --method "), "{}", done.err);
}

#[test]
fn a_budget_picks_the_most_exact_that_fits() {
    let done = smartbed(&["run", "sleigh", "--budget", "10ms"]);
    assert_eq!(done.status, 0, "{}", done.err);
    assert!(done.err.contains("--budget 10.000 ms: picked --method "), "{}", done.err);
    let only = smartbed(&["run", "sleigh", "--budget", "10ms", "--method", "rk4"]);
    assert!(only.err.contains("picked --method rk4 --step "), "{}", only.err);
    let too_little = smartbed(&["run", "sleigh", "--budget", "1ns"]);
    assert!(too_little.message().contains("not met by any of"), "{}", too_little.err);
    let too_exact = smartbed(&["run", "sleigh", "--error", "1e-30"]);
    assert!(too_exact.message().contains("nearest is --method "), "{}", too_exact.err);
}

#[test]
fn a_folder_that_cannot_be_made_is_refused_before_anything_is_measured() {
    let file = written("report_in_the_way.txt", "a file");
    let start = std::time::Instant::now();
    let done = smartbed(&["report", "cam", "--out", &format!("{file}/report")]);
    assert_eq!(done.status, 1, "{done:?}");
    assert!(
        done.message().contains("report_in_the_way.txt is not a folder; name another folder"),
        "{done:?}"
    );
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}

/// A step that does not divide a tenth of the 10 s is not the one that is measured, and is not written beside the error.
#[test]
fn a_step_that_is_asked_for_is_the_one_that_is_told() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("report_steps");
    let out = folder.display().to_string();
    for (asked, taken, told) in
        [("0.06", 1.0 / 17.0, true), ("0.03", 1.0 / 34.0, true), ("0.05", 0.05, false)]
    {
        let options =
            ["--no-chip", "--method=rk4", "--step", asked, "--scalar=f64", "--quick", "--out", &out];
        let done = smartbed(&[&["report", "pendulum"][..], &options].concat());
        assert_eq!(done.status, 0, "{done:?}");
        let report: Value =
            serde_json::from_str(&std::fs::read_to_string(folder.join("report.json")).expect("a file"))
                .expect("JSON");
        let section = &report["subjects"][0];
        let step = report["points"][0]["step"].as_f64().expect("a step");
        assert!((step - taken).abs() < 1e-12, "{asked}: {step} {report}");
        let notes = section["notes"].to_string();
        assert_eq!(notes.contains(&format!("--step {asked}: measured at")), told, "{notes}");
    }
}
