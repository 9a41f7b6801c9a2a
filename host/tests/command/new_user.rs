//! README's first mechanism, word for word as a new user would: written, checked, run, plotted, edited.

use crate::support::{command, file, finish, least_time, timed};
use std::path::{Path, PathBuf};

fn readme() -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md")).expect("README")
}

/// The part of README under a heading.
fn section<'a>(text: &'a str, heading: &str) -> &'a str {
    let from = text.find(heading).expect("the section") + heading.len();
    let rest = &text[from..];
    &rest[..rest.find("\n## ").unwrap_or(rest.len())]
}

/// The model of the section, in a folder of its own.
fn written(section: &str, folder: &str) -> PathBuf {
    let from = section.find("```toml\n").expect("a model") + "```toml\n".len();
    let model = &section[from..from + section[from..].find("```").expect("its end")];
    let folder = file(folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("press.toml"), model).expect("written");
    folder
}

/// Standard output of the program, run in `folder`.
fn smartbed(folder: &Path, arguments: &[&str]) -> String {
    let mut smartbed = command(arguments);
    smartbed.current_dir(folder);
    let done = finish(smartbed);
    assert_eq!(done.status, 0, "{arguments:?}: {done:?}");
    assert_eq!(done.err, "", "{arguments:?}");
    done.out
}

#[test]
fn the_first_mechanism_is_checked_run_and_plotted() {
    let readme = readme();
    let section = section(&readme, "## A first mechanism");
    let folder = written(section, "first");
    let lines: Vec<&str> = section.lines().filter_map(|l| l.strip_prefix("    cargo smartbed ")).collect();
    assert_eq!(lines.len(), 3, "{lines:?}");
    let printed: Vec<String> =
        lines.iter().map(|line| smartbed(&folder, &line.split_whitespace().collect::<Vec<_>>())).collect();
    for part in ["degrees of freedom: 1 found, 1 stated", "nearest to singular", "no warnings"] {
        assert!(printed[0].contains(part), "{part}: {}", printed[0]);
    }
    let plot = std::fs::read_to_string(folder.join("press.svg")).expect("a plot");
    for part in ["time [s]", "angle [deg]", "length [m]", "energy [J]", ">length<", ">actuator<", ">q3<"] {
        assert!(plot.contains(part), "{part}");
    }
    assert!(std::fs::read_to_string(folder.join("press.html")).expect("a page").contains("<canvas"));
    assert!(printed[1].contains("deg/s") && printed[2].contains("press: 1 s"), "{printed:?}");
    // What moves is a four-bar linkage: the loop closes by its plain equation, and the energy that the motor
    // has put in is there.
    let table = std::fs::read_to_string(folder.join("press.csv")).expect("rows");
    let names: Vec<&str> = table.lines().next().expect("a header").split(',').collect();
    let at = |name: &str| names.iter().position(|n| *n == name).expect("a column");
    let (mut turned, mut first_total) = (0.0_f64, None);
    for row in table.lines().skip(1) {
        let row: Vec<f64> = row.split(',').map(|x| x.parse().expect("a number")).collect();
        let (q1, q2, q3) = (row[at("q1")], row[at("q2")], row[at("q3")]);
        let x = 0.1 * q1.cos() + 0.3 * q2.cos() - 0.25 * q3.cos() - 0.3;
        let y = 0.1 * q1.sin() + 0.3 * q2.sin() - 0.25 * q3.sin();
        assert!(x.hypot(y) < 1e-12, "open by {:.1e} m", x.hypot(y));
        let length = (0.3 + 0.25 * q3.cos() - 0.5).hypot(0.25 * q3.sin());
        assert!((row[at("length")] - length).abs() < 1e-12);
        let stored = row[at("total")] - row[at("actuator")];
        let first = *first_total.get_or_insert(stored);
        // Quadrature of the motor's work by steps of 1 ms, of 6 J.
        assert!((stored - first).abs() < 1e-5, "{stored} J is not {first} J");
        turned = turned.max(q1);
    }
    assert!(turned > 4.0 * std::f64::consts::TAU, "the crank turns: {turned}");
}

#[test]
fn edited_geometry_is_motion_on_screen_within_a_second() {
    let folder = written(section(&readme(), "## A first mechanism"), "edited");
    let path = folder.join("press.toml");
    let model = std::fs::read_to_string(&path).expect("the model");
    let mut pages = Vec::new();
    let mut save = |crank: &str| {
        let edited = model.replace("a = { value = 100,", &format!("a = {{ value = {crank},"));
        assert!(edited != model, "the crank's length stands in the model");
        std::fs::write(&path, edited).expect("written");
        let mut run = command(&["run", "press.toml", "--view", "press.html"]);
        let (done, seconds) = timed(run.current_dir(&folder));
        assert_eq!(done.status, 0, "{done:?}");
        pages.push(std::fs::read_to_string(folder.join("press.html")).expect("a page"));
        seconds
    };
    let cranks = ["60", "70", "80", "90", "110"];
    let mut edits = cranks.iter().cycle();
    cranks.iter().for_each(|crank| _ = save(crank));
    let fastest = least_time(1.0, 5, || save(edits.next().expect("a crank")));
    println!("saved to page: {fastest} s");
    assert!(fastest < 1.0, "{fastest} s");
    pages.truncate(cranks.len());
    pages.dedup();
    assert_eq!(pages.len(), cranks.len(), "every edit moves differently");
}

#[test]
fn slips_of_a_new_user_are_explained() {
    let folder = written(section(&readme(), "## A first mechanism"), "slips");
    let path = folder.join("press.toml");
    let model = std::fs::read_to_string(&path).expect("the model");
    let slips = [
        (
            "centre = \"crank_centre\"",
            "centre = \"A/2\"",
            "expected the name of a point, found an expression",
        ),
        ("[\"C\", \"hook\"]", "[C, hook]", "names and expressions stand in quotes"),
        ("\"B - C\"", "\"B - C", "close the text with a second quote"),
        ("u_q1/idle", "q1_dot/idle", "its speed: here `u_q1`"),
        ("a.powi(3)", "a**3", "powers are written x.powi(2)"),
        ("\"T*N.z\"", "\"T\"", "multiply it by a unit vector such as N.z"),
        ("independent = true, ", "", "independent: none"),
        ("rotations = [[\"z\", \"q1\"]]", "rotation = [[\"z\", \"q1\"]]", "did you mean `rotations`?"),
        (
            "300, unit = \"mm\", doc = \"coupler\"",
            "3, unit = \"mm\", doc = \"coupler\"",
            "give nominal values nearer",
        ),
        ("[springs]", "[spring]", "did you mean `springs`?"),
    ];
    for (right, wrong, explained) in slips {
        assert!(model.contains(right), "{right}");
        std::fs::write(&path, model.replacen(right, wrong, 1)).expect("written");
        let mut check = command(&["check", "press.toml"]);
        check.current_dir(&folder);
        let done = finish(check);
        assert!(done.message().contains("press.toml:") && done.err.contains(explained), "{wrong}: {done:?}");
    }
}
