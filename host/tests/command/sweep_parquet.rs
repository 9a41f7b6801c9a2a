//! The Parquet file of a sweep, read back: columns and values of the CSV, and their provenance.

use crate::support::{file, smartbed};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use sha2::{Digest, Sha256};

#[test]
fn a_sweep_is_the_same_as_parquet_and_as_csv() {
    let folder = file("parquet_sweep").display().to_string();
    let output = file("parquet_sweep.parquet").display().to_string();
    let sweep = || {
        let set = ["--set", "run.seconds=0", "--set", "sensors.seed=7"];
        let done =
            smartbed(&[&["sweep", "ball_on_four", "-o", &folder, "--parquet", &output], &set[..]].concat());
        assert_eq!(done.status, 0, "{done:?}");
        std::fs::read(&output).expect("a file")
    };
    // Nothing is computed again: the same cases give the same bytes.
    assert_eq!(sweep(), sweep());
    let read = std::fs::File::open(&output).expect("a file");
    let read = SerializedFileReader::new(read).expect("parquet");
    let text = std::fs::read_to_string(format!("{folder}/sweep.csv")).expect("a table");
    let mut lines = text.lines();
    // Names hold commas, and stand in quotes.
    let head: Vec<&str> =
        lines.next().expect("a head").trim_start_matches("case,").trim_matches('"').split("\",\"").collect();
    let rows: Vec<_> = read.get_row_iter(None).expect("rows").map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), 4);
    let mut missing = 0;
    for (row, line) in rows.iter().zip(lines) {
        let cells: Vec<&str> = line.split(',').collect();
        let names: Vec<&String> = row.get_column_iter().map(|(name, _)| name).collect();
        assert_eq!(names[0], "case");
        assert_eq!(names[1..].iter().map(|name| name.as_str()).collect::<Vec<_>>(), head);
        for ((_, value), cell) in row.get_column_iter().zip(&cells) {
            match value {
                Field::Long(x) => assert_eq!(x.to_string(), *cell),
                Field::Str(text) => assert_eq!(format!("\"{text}\""), *cell),
                Field::Double(x) => assert_eq!(x.to_bits(), cell.parse::<f64>().expect("a number").to_bits()),
                Field::Null => {
                    assert_eq!(*cell, "");
                    missing += 1;
                }
                other => panic!("{other:?}"),
            }
        }
    }
    assert!(missing > 0, "a metric over hours has no value in a moment");
    let told = read.metadata().file_metadata().key_value_metadata().expect("pairs");
    let told = |key: &str| told.iter().find(|pair| pair.key == key).and_then(|pair| pair.value.clone());
    let plan = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/plans/ball_on_four.toml");
    let hash: String = Sha256::digest(std::fs::read(plan).expect("a plan"))
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    assert_eq!(told("plan_sha256"), Some(hash));
    assert_eq!(told("version").as_deref(), Some(env!("CARGO_PKG_VERSION")));
    assert_eq!(told("command").as_deref(), Some("smartbed sweep ball_on_four"));
    assert_eq!(told("settings").as_deref(), Some("[\"run.seconds=0\", \"sensors.seed=7\"]"));
    assert_eq!(told("sensors.seed").as_deref(), Some("7"));
}
