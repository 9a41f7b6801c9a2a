//! `smartbed figure`: documentation and command list the same figures of the thesis, and the command makes them.

use crate::support::{file, smartbed};

fn list() -> String {
    let done = smartbed(&["figure", "--list"]);
    assert_eq!(done.status, 0, "{done:?}");
    done.out
}

#[test]
fn the_list_and_the_documentation_say_the_same() {
    let root =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("host/ lies in the workspace");
    let documented = std::fs::read_to_string(root.join("docs/figures.md")).expect("docs/figures.md");
    let rows: Vec<Vec<&str>> = (documented.lines().filter(|l| l.starts_with("| ")))
        .map(|l| l.trim_matches('|').split('|').map(str::trim).collect())
        .filter(|cells: &Vec<&str>| cells[0].contains('.'))
        .collect();
    let listed = list();
    assert_eq!(rows.len(), listed.lines().count());
    for (row, line) in rows.iter().zip(listed.lines()) {
        assert!(line.starts_with(&format!("{:<5} {}", row[0], row[1])), "{line}");
        assert!(row[2].contains(&format!("figure {}", row[0])), "{line}");
        assert_eq!(
            row[3].starts_with("a scheme"),
            line.contains("a schematic drawing, not a result"),
            "{line}"
        );
    }
}

#[test]
fn figures_are_made_or_refused_by_name() {
    for (number, told) in [
        ("2.1", "refuted"),
        ("2.2", "Scheme"),
        ("2.3", "Fermat"),
        ("2.4", "loops"),
        ("2.6", "75 kg in 16 segments"),
        ("3.8", "blind slots"),
        ("3.9", "four sites"),
        ("2.5", "28 alike"),
        ("3.2", "damping"),
        ("4.1", "weight"),
        ("4.2", "pre-collision"),
        ("4.2", "restitution"),
        ("4.3", "kinetic"),
        ("5.8", "damping"),
    ] {
        let path = file(&format!("figure_{number}.svg"));
        let done = smartbed(&["figure", number, "-o", &path.display().to_string()]);
        assert_eq!(done.status, 0, "{done:?}");
        let text = std::fs::read_to_string(&path).expect("a picture");
        assert!(text.starts_with("<svg") && text.contains(told), "{number} tells of {told}");
    }
    for (arguments, expected) in [
        (vec!["figure", "2.2", "--set", "x=1"], "a schematic drawing without settings"),
        (vec!["figure", "2.6", "--set", "patient.mass=5"], "expected 20 to 350 kg"),
        (vec!["figure", "7.1"], "no figure of this number"),
        (vec!["figure", "4.2", "--set", "e=2"], "e from 0 to 1"),
        (vec!["figure", "4.1", "--set", "height=-1"], "height from 0 to 1"),
        (vec!["figure", "4.2", "-o", "x.gif"], ".svg or .png"),
    ] {
        assert!(smartbed(&arguments).message().contains(expected), "{arguments:?}");
    }
}
