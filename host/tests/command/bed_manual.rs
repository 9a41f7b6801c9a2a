//! docs/bed.md against the program: its commands run, every key of a plan stands in it and every key in it is read;
//! every refusal of a plan has its row in docs/guide/every-error.md.

use crate::guide::{messages, run_page, same};
use smartbed::plan::{checked, parse};
use smartbed_bed::equilibrium::Fault;
use smartbed_bed::plan::check::Refusal;
use smartbed_bed::plan::history::RunError;
use smartbed_bed::policy::bounds::Bounds;
use std::collections::BTreeSet;

const MANUAL: &str = include_str!("../../../docs/bed.md");

#[test]
fn the_manuals_commands_run() {
    assert!(run_page("bed", MANUAL) >= 4);
}

/// Keys of the manual's table as `table.key`; several of one row share its table.
fn told() -> BTreeSet<String> {
    let part = MANUAL.split("\n## Every key").nth(1).and_then(|rest| rest.split("\n## ").next());
    let rows = part.expect("keys").lines().filter(|line| line.starts_with("| `"));
    let mut keys = BTreeSet::new();
    for row in rows {
        let cell = row.trim_matches('|').split(" | ").next().expect("a cell");
        let mut table = String::new();
        for word in cell.split('`').skip(1).step_by(2) {
            let word = word.trim_matches(['[', ']']);
            match word.rsplit_once('.') {
                Some(("", key)) => drop(keys.insert(format!("{table}.{key}"))),
                Some((name, _)) => {
                    table = name.to_owned();
                    keys.insert(word.to_owned());
                }
                None if ["move", "sweep"].contains(&word) => table = word.to_owned(),
                None if table.is_empty() => drop(keys.insert(word.to_owned())),
                None => drop(keys.insert(format!("{table}.{word}"))),
            }
        }
    }
    keys
}

/// Keys that the program reads in a table, as its refusal of an unknown one lists them.
fn read(table: &str, text: &str) -> Vec<String> {
    let found =
        parse("plan.toml", &format!("format = 1\n{text}"), &[]).expect_err("an unknown key").to_string();
    let list = found.split("fields here are ").nth(1).unwrap_or_else(|| panic!("no list in {found}"));
    list.lines().next().expect("a line").split(", ").map(|key| format!("{table}.{key}")).collect()
}

#[test]
fn every_key_of_a_plan_is_in_the_manual() {
    let tables = [
        ("bed", "[bed]\nzzzzzzzzzzzz = 1"),
        ("patient", "[patient]\nzzzzzzzzzzzz = 1"),
        ("load", "[load]\nshape = \"cylinder\"\nradius = 1\nmass = 1\nlength = 1\nzzzzzzzzzzzz = 1"),
        ("load", "[load]\nshape = \"plate\"\nradius = 1\nmass = 1\nsize = [1, 1, 1]\nzzzzzzzzzzzz = 1"),
        ("load", "[load]\nshape = \"mesh\"\nfile = \"a.stl\"\nunit = 1\nmass = 1\nzzzzzzzzzzzz = 1"),
        ("move", "[[move]]\ntiles = \"all\"\nheave = 0\nzzzzzzzzzzzz = 1"),
        ("alternating", "[alternating]\nlow = 1\nzzzzzzzzzzzz = 1"),
        ("sensors", "[sensors]\nzzzzzzzzzzzz = 1"),
        ("instruments", "[instruments]\nzzzzzzzzzzzz = 1"),
        ("policy", "[policy]\nkind = \"planner\"\nzzzzzzzzzzzz = 1"),
        ("dynamics", "[dynamics]\nzzzzzzzzzzzz = 1"),
        ("run", "[run]\nzzzzzzzzzzzz = 1"),
        ("metrics", "[metrics]\nzzzzzzzzzzzz = 1"),
        ("patient.braden", "[patient.braden]\nzzzzzzzzzzzz = 1"),
        ("", "zzzzzzzzzzzz = 1"),
    ];
    let mut all: BTreeSet<String> = tables.iter().flat_map(|(table, text)| read(table, text)).collect();
    // Tables stand there by their keys.
    let names: Vec<String> = tables.iter().map(|(table, _)| format!(".{table}")).collect();
    all.retain(|key| !names.contains(key) && key != ".sweep" && key != "patient.braden");
    let all: BTreeSet<String> = all.into_iter().map(|key| key.trim_start_matches('.').to_owned()).collect();
    assert_eq!(told(), all);
}

/// Output for a plan of one tile with these lines.
fn refusal(text: &str) -> String {
    let text = format!("format = 1\n{text}");
    match parse("plan.toml", &text, &[]) {
        Ok(read) => checked("plan.toml", read).expect_err(&text),
        Err(found) => {
            let said = found.to_string();
            said.lines().next().and_then(|line| line.strip_prefix("error: ")).expect("an error").to_owned()
        }
    }
}

#[test]
fn moves_that_no_equilibrium_sees_are_refused_where_they_stand() {
    let told = |lines: &str| {
        let text = format!("format = 1\n[patient]\n{lines}");
        parse("plan.toml", &text, &[])
            .map(|read| read.warnings.to_string())
            .map_err(|found| found.to_string())
    };
    let dip = |every: u32, clock: &str| {
        told(&format!(
            "[[move]]\nat = 1\nover = 2\ntiles = [2]\npressure = 1600\n[[move]]\nat = 6\nover = 2\ntiles = \"all\"\n\
             pressure = 4000\n[run]\nseconds = 20\nevery = {every}\n{clock}"
        ))
    };
    for every in [1, 2, 5] {
        assert_eq!(dip(every, ""), Ok(String::new()), "{every}");
    }
    let said = dip(10, "").expect_err("unseen");
    for words in [
        "a move of tile 2 is taken back between two equilibria\n --> plan.toml:3:1",
        "from 1 s to 8 s, equilibria stand every 10 s",
        "run.every below 7 s, or a longer move",
    ] {
        assert!(said.contains(words), "{said}");
    }
    assert_eq!(dip(10, "clock = \"dynamics\""), Ok(String::new()));
    // The policies: an alternation asks for its cycle alone, a planner for time to relieve a tile within a slot.
    let policy =
        |words: &str, every: u32| told(&format!("[policy]\n{words}\n[run]\nseconds = 600\nevery = {every}"));
    assert_eq!(policy("kind = \"alternating\"\ncycle = 300", 10), Ok(String::new()));
    let said = policy("kind = \"alternating\"\ncycle = 2", 10).expect_err("unseen");
    assert!(said.contains("taken back between two equilibria\n --> plan.toml:3:1"), "{said}");
    for cycle in ["1e-6", "0.1", "1e-300"] {
        let said = policy(&format!("kind = \"alternating\"\ncycle = {cycle}"), 10).expect_err("too many");
        let is_told = said.contains("more than 10000 cycles") || said.contains("moves times the number");
        assert!(is_told, "{cycle}: {said}");
    }
    let said = policy("kind = \"planner\"\ncycle = 300", 10).expect_err("no time");
    assert!(
        said.contains(
            "`cycle` / `slots` = 300 s / 10 = 30 s, `ramp` + `hold` + `ramp` = 10 + 40 + 10 = 60 s"
        ),
        "{said}"
    );
    assert!(policy("kind = \"planner\"", 60).expect_err("unseen").contains("within 60 s"));
}

#[test]
fn a_pressure_ordered_anew_too_early_is_warned_of() {
    let told = |at: f64| {
        let text = format!(
            "format = 1\n[patient]\n[[move]]\nover = 20\ntiles = [3]\npressure = 3000\n[[move]]\nat = {at}\nover = 20\n\
             tiles = [2, 3]\npressure = 5000\n[run]\nseconds = 60"
        );
        let read = parse("plan.toml", &text, &[]).expect("a plan");
        let warnings = read.warnings.to_string();
        // What the code of the tiles' controller says to the same orders: it takes them.
        checked("plan.toml", read).map(|_| warnings)
    };
    let said = told(10.0).expect("taken");
    let words =
        "warning: the pressure of tile 3 is ordered anew at 10 s, while an order for it lasts until 20 s";
    assert!(said.starts_with(words) && said.contains("plan.toml:7:1"), "{said}");
    assert_eq!(told(20.0), Ok(String::new()));
}

#[test]
fn every_refusal_of_a_plan_has_its_cause_and_cure() {
    let moved = |words: &str| format!("[[move]]\ntiles = \"all\"\nat = 10\n{words}\n[run]\nseconds = 60");
    let texts = [
        "zzzzzzzzzz = 1".to_owned(),
        "[bed]\nrows = 0".to_owned(),
        "[bed]\npressure = -1".to_owned(),
        "[bed]\nrows = 9".to_owned(),
        "[bed]\ngap = 1".to_owned(),
        "[bed]\nexponent = 100".to_owned(),
        "[sweep]\n\"bed.gap\" = []".to_owned(),
        "[patient.braden]\nsensory = 5\nmoisture = 1\nactivity = 1\nmobility = 1\nnutrition = 1\nfriction_and_shear = 1"
            .to_owned(),
        "[bed]\nrows = 7\nintervals = [80, 100]".to_owned(),
        "[bed]\nintervals = [1, 1]".to_owned(),
        "[bed]\nintervals = [8, 30]".to_owned(),
        "[bed]\nintervals = [8.5, 10]".to_owned(),
        "[run]\nseconds = 1e9".to_owned(),
        "[run]\nseconds = 15".to_owned(),
        "[[move]]\ntiles = []\nheave = 0".to_owned(),
        "[policy]\nkind = \"alternating\"\nslots = 3".to_owned(),
        "[run]\nparts = 101".to_owned(),
        "[run]\nparts = 8\nfall = 4".to_owned(),
        "[patient]\n[dynamics]\nscalar = \"f32\"".to_owned(),
        "[run]\nclock = \"dynamics\"\nfall = 4".to_owned(),
        "[dynamics]\ntissue_at_once = 0.5".to_owned(),
        "[dynamics]\nstart = \"at_rest\"\ndrop = 0.02".to_owned(),
        "[run]\nclock = \"dynamics\"\nseconds = 1e5\n[dynamics]\nstep = 1e-4".to_owned(),
        "[alternating]\nlow = 1\ncycle = 1\n[run]\nseconds = 1e5".to_owned(),
        "[alternating]\nlow = 1\ncycle = 10\n[run]\nseconds = 9e4\nevery = 1".to_owned(),
        "[alternating]\nhigh = 1".to_owned(),
        "[load]\nshape = \"bowl\"".to_owned(),
        "[load]\nshape = \"plate\"\nradius = 0.1\nmass = 1\nsize = [-1, 1, 0]".to_owned(),
        "[patient]\n[load]\nshape = \"ball\"".to_owned(),
        "[patient]\nmass = 5".to_owned(),
        "[patient.joints]\n\"left knee\" = [\"30_deg\", 0, 0]".to_owned(),
        "[patient.joints]\n\"left knie\" = [0, 0, 0]".to_owned(),
        moved("over = 1"),
        moved("tilt = [\"60_deg\", 0]"),
        "[[move]]\ntiles = [29]\nheave = 0".to_owned(),
        "[[move]]\ntiles = [2, 3, 2]\nheave = 0".to_owned(),
        "[[move]]\ntiles = \"some\"\nheave = 0".to_owned(),
        moved("heave = \"40_mm\"\nover = 20"),
        moved("heave = \"20_mm\"\nover = 1"),
        moved("pressure = \"20_kPa\""),
        "[[move]]\ntiles = [1]\nover = 20\nheave = \"25_mm\"\n[run]\nseconds = 60".to_owned(),
        "[[move]]\ntiles = [1]\nover = 20\ntilt = [\"4_deg\", 0]\n[run]\nseconds = 60".to_owned(),
        "[bed]\ncircle = 0.1\n[run]\nsupervised = true".to_owned(),
        moved("heave = \"29.5_mm\"\nover = 20") + "\nsupervised = true",
        moved("heave = \"10_mm\"\nover = 2") + "\nsupervised = true",
        moved("heave = \"10_mm\"\nover = 20") + "\nsupervised = true",
        "[patient]\n[bed]\npressure = 100".to_owned(),
        "[sensors]\npitch = 1e-4".to_owned(),
        "[sensors]\nph = 12".to_owned(),
        "[sensors]\nmounted = true\npitch = 1e-3".to_owned(),
        "[sensors]\nmounted = true\nthickness = 0.03".to_owned(),
        "[sensors]\nthickness = \"1_mm\"".to_owned(),
        "[sensors]\nmodulus = 1e30".to_owned(),
        "[instruments]\ndelay = 1".to_owned(),
        "[instruments]\nlag = 4".to_owned(),
        "[alternating]\nlow = 5000".to_owned(),
        "[policy]\nkind = \"planner\"\nlow = 5000".to_owned(),
        "[run]\nseconds = 20\nevery = 4e7".to_owned(),
        "[policy]\nkind = \"planner\"\nslots = 60".to_owned(),
        "[policy]\nkind = \"planner\"\n[run]\nseconds = 120\nevery = 60".to_owned(),
        "[alternating]\nlow = 1600\ncycle = 1\n[run]\nseconds = 60\nevery = 5".to_owned(),
    ];
    let mut found: Vec<String> = texts.iter().map(|text| refusal(text)).collect();
    let faults = [
        Fault::Collapsed(3, -1e-3),
        Fault::Burst(3, 30.0),
        Fault::Lost,
        Fault::Rounded(1e9, [2e-8, 1e-8]),
        Fault::NotFound(1.0, 2.0),
    ];
    let runs = faults.map(|fault| RunError::Fault(10.0, fault)).into_iter();
    found.extend(
        runs.chain([RunError::Invalid(10.0, 1e-3), RunError::Passed(10.0, "left foot".to_owned(), 3, 0.1)])
            .map(|error| error.to_string()),
    );
    found.extend(crate::bed_mesh::refusals());
    let bounds =
        [(1, 1.2), (4, 9.0)].map(|(most_low, support)| Bounds { most_low, support, ..Bounds::default() });
    found.extend(bounds.map(|bounds| {
        let what = bounds.of(&[1e3, 1e3, 5e3], &[0.05; 3], 200.0).expect_err("beyond a bound");
        Refusal { time: 10.0, tile: None, what }.to_string()
    }));
    same(&found, &messages("## Plans of the bed", None));
}
