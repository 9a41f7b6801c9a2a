//! `bed` and `sweep`: plans run and refused, pages from which no text can run, sweeps whose bytes depend on nothing.

use crate::schema::holds;
use crate::support::{file, smartbed, written};
use std::collections::BTreeMap;
use std::path::Path;

#[test]
fn a_plan_is_run_and_prints_what_the_schema_says() {
    let maps = ["bed_map.csv", "bed_map.asf"].map(|name| file(name).display().to_string());
    for map in &maps {
        let done = smartbed(&["bed", "run", "ball_on_four", "--json", "--map", map]);
        assert_eq!(done.status, 0, "{done:?}");
        let json = done.json();
        holds("bed", &json);
        assert!(json["imbalance"].as_f64().expect("a number") < 1e-6);
        assert!(json["sensed_error"].as_f64().expect("a number") < 0.01);
        assert_eq!(json["note"], "engineering indices, not clinical evidence");
        let text = std::fs::read_to_string(map).expect("a map");
        let read = smartbed_bed::files::read(&text).expect("read back");
        assert_eq!((read.grid.rows, read.grid.columns, read.recording.frames().len()), (20, 16, 4));
    }
}

#[test]
fn plans_beyond_their_limits_are_refused_with_the_tile() {
    let say =
        |setting: &str| smartbed(&["bed", "run", "ball_on_four", "--set", setting]).message().to_owned();
    let pressure = say("bed.pressure=20_kPa");
    assert!(
        pressure.contains("tile 1 at 0.0000 s: pressure of 20.00 kPa, expected 0 to 12.00 kPa"),
        "{pressure}"
    );
    assert!(say("bed.rows=20").contains("40 tiles, expected 1 to 28"));
    assert!(say("bed.rwos=2").contains("`bed` has no field `rwos`"));
    assert!(say("load.mass=2000_kg").contains("all bladders can carry"));
    let knee =
        smartbed(&["bed", "run", "alternating", "--set", "patient.joints={\"left knee\"=[\"30_deg\",0,0]}"]);
    assert!(knee.message().contains("joint `left knee`: flexion of 30 deg, it allows -140 to 5"));
    assert!(smartbed(&["bed", "run", "no_such"]).message().contains("no plan `no_such`"));
    let map = smartbed(&["bed", "run", "ball_on_four", "--map", "map.txt"]);
    assert!(map.message().contains("expected a name that ends in .csv or .asf"));
}

#[test]
fn no_text_of_a_plan_can_run_in_its_page() {
    let plan = include_str!("../../../models/plans/ball_on_four.toml");
    let evil = "</script><script>alert(1)</script><img src=x onerror=alert(2)>@DATA@";
    let plan = plan.replace("A ball on four bladders\"", &format!("{evil}\""));
    let (plan, page) = (written("evil.toml", &plan), file("evil.html").display().to_string());
    let done = smartbed(&["bed", "report", &plan, "-o", &page]);
    assert_eq!(done.status, 0, "{done:?}");
    let text = std::fs::read_to_string(page).expect("a page");
    assert!(!text.contains("<script>alert") && !text.contains("<img"));
    assert_eq!(text.matches("<script").count(), 1);
    assert_eq!(text.matches("</script>").count(), 1);
    assert!(text.contains("engineering indices, not clinical evidence"));
}

/// Names and texts of a folder's files.
fn texts(folder: &Path) -> BTreeMap<String, String> {
    let files = std::fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path());
    let text = |p: &Path| std::fs::read_to_string(p).expect("text");
    files.map(|p| (p.file_name().expect("a name").to_string_lossy().into_owned(), text(&p))).collect()
}

#[test]
fn a_sweep_gives_the_same_bytes_in_shards_on_any_cores_and_after_a_break() {
    let folder = |name: &str| {
        let folder = file(name);
        let _ = std::fs::remove_dir_all(&folder);
        folder
    };
    let [whole, shards] = ["sweep_whole", "sweep_shards"].map(folder);
    let [one, two] = [&whole, &shards].map(|f| f.display().to_string());
    let run = |arguments: &[&str]| {
        let done = smartbed(&[&["sweep", "ball_on_four"], arguments].concat());
        assert_eq!(done.status, 0, "{done:?}");
        done.out
    };
    assert!(run(&["-o", &one, "--cores", "1"]).contains("4 cases"));
    assert!(run(&["-o", &two, "--shard", "2/2", "--cores", "3"]).contains("2 cases of 4 left"));
    let early = smartbed(&["sweep", "ball_on_four", "-o", &two, "--merge"]);
    assert!(early.message().contains("2 cases of 4 missing"), "{early:?}");
    // A case that was cut off does not count as done.
    std::fs::write(shards.join("case_00002.json"), "{\"version\"").expect("written");
    run(&["-o", &two, "--shard", "1/2"]);
    run(&["-o", &two]);
    assert_eq!(texts(&whole), texts(&shards));
    let table = &texts(&whole)["sweep.csv"];
    assert_eq!(table.lines().count(), 5);
    assert!(table.starts_with("case,\"load.mass\",\"bed.pressure\","), "{table}");
    let bad = smartbed(&["sweep", "ball_on_four", "-o", &one, "--shard", "3/2"]);
    assert!(bad.message().contains("expected I/N with I from 1 to N"));
    assert!(smartbed(&["sweep", "alternating", "-o", &one]).message().contains("it has no [sweep]"));
}
