//! Files of pressure maps: round trips, refusals with their line, and random text.

use proptest::prelude::*;
use smartbed_bed::files::{Mapped, read, tekscan, xsensor};
use smartbed_bed::map::{Frame, Grid, Recording};

fn mapped(rows: usize, columns: usize, frames: &[Vec<f64>]) -> Mapped {
    let grid = Grid { rows, columns, row_pitch: 0.01016, column_pitch: 0.0125 };
    let frame = |(k, pressure): (usize, &Vec<f64>)| Frame {
        time: k as f64 * 0.25,
        seconds: 0.25,
        pressure: pressure.clone(),
        shear: Vec::new(),
    };
    let frames = frames.iter().enumerate().map(frame).collect();
    Mapped { grid, recording: Recording::new(grid.all(), frames).expect("sound") }
}

/// Equal but for the rounding of units.
#[track_caller]
fn assert_same(found: &Mapped, expected: &Mapped) {
    assert_eq!((found.grid.rows, found.grid.columns), (expected.grid.rows, expected.grid.columns));
    assert!((found.grid.row_pitch / expected.grid.row_pitch - 1.0).abs() < 1e-15 * 4.0);
    assert!((found.grid.column_pitch / expected.grid.column_pitch - 1.0).abs() < 1e-15 * 4.0);
    let (found, expected) = (found.recording.frames(), expected.recording.frames());
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert_eq!((a.time, a.seconds), (b.time, b.seconds));
        for (p, q) in a.pressure.iter().zip(&b.pressure) {
            assert!((p - q).abs() <= 4.0 * f64::EPSILON * q, "{p} {q}");
        }
    }
}

proptest! {
    #[test]
    fn what_is_written_is_read_back(
        rows in 1..6_usize,
        columns in 1..6_usize,
        values in proptest::collection::vec(0.0..5e4_f64, 75..76),
    ) {
        let frames: Vec<Vec<f64>> = values.chunks(25).map(|c| c[..rows * columns].to_vec()).collect();
        let map = mapped(rows, columns, &frames);
        assert_same(&read(&tekscan::write(&map).expect("even")).expect("read back"), &map);
        assert_same(&read(&xsensor::write(&map)).expect("read back"), &map);
    }

    #[test]
    fn nonsense_is_refused_and_never_a_panic(
        kind in any::<bool>(),
        cuts in proptest::collection::vec((0..2000_usize, 0..40_usize, "[0-9A-Za-z,.@ \n-]{0,8}"), 1..6),
    ) {
        let map = mapped(2, 3, &[vec![1.0; 6], vec![2.0; 6]]);
        let mut text = if kind { tekscan::write(&map).expect("even") } else { xsensor::write(&map) };
        for (place, length, put) in cuts {
            let start = place % text.len().max(1);
            let end = (start + length).min(text.len());
            text.replace_range(start..end, &put);
        }
        // Whatever is read is sound: `Recording::new` has checked it.
        if let Ok(found) = read(&text) {
            prop_assert!(found.recording.sites().len() == found.grid.sites());
        }
    }
}

const MOVIE: &str = "DATA_TYPE MOVIE
ROWS 2
COLS 2
ROW_SPACING 10.16 mm
COL_SPACING 10.16 mm
SECONDS_PER_FRAME 0.1
UNITS mmHg
ASCII_DATA @@
Frame 1
1,2
3,4

@@
";

#[test]
fn a_movie_as_the_maker_writes_it() {
    let map = read(MOVIE).expect("a movie");
    assert_eq!((map.grid.rows, map.grid.columns), (2, 2));
    assert!((map.grid.row_pitch - 0.01016).abs() < 1e-17);
    assert!((map.recording.frames()[0].pressure[3] - 4.0 * 133.322).abs() < 1e-12);
}

#[test]
fn refusals_name_the_line() {
    for (from, to, message) in [
        ("UNITS mmHg", "UNITS RAW", "line 7: unit of pressure `RAW`: expected kPa, Pa, mmHg, PSI or N/cm2"),
        ("1,2\n", "1,2,3\n", "line 10: 3 values, expected 2, one for each column"),
        ("3,4\n", "", "line 10: the frame ends after 1 rows, expected 2"),
        ("3,4\n", "3,4\n5,6\n", "line 12: more than 2 rows in this frame"),
        ("1,2\n", "1,-2\n", "line 10: expected a pressure >= 0, found `-2`"),
        ("1,2\n", "1,B\n", "line 10: expected a number, found `B`"),
        ("ROWS 2", "ROWS 0", "line 2: expected a count from 1, found `0`"),
        ("COLS 2\n", "", "line 7: `COLS` is missing before the data"),
        ("Frame 1\n", "", "line 9: expected a line `Frame` before the first row"),
        ("10.16 mm", "10.16 ft", "line 4: unit of length `ft`: expected mm, cm, m or in"),
        ("FRAME 0.1", "FRAME -1", "line 6: expected seconds >= 0, found `-1`"),
    ] {
        let text = MOVIE.replacen(from, to, 1);
        assert_ne!(text, MOVIE, "{from}");
        assert_eq!(read(&text).expect_err(to).to_string(), message);
    }
    assert_eq!(read("").expect_err("empty").to_string(), "no line `SENSELS`: not an XSENSOR-style file");
    let block = "Rows,2\nColumns,1\nRow Pitch,1 cm\nColumn Pitch,1 cm\nUnits,kPa\nSENSELS\n1\n\n";
    assert_eq!(
        read(block).expect_err("short").to_string(),
        "line 6: the sensels end after 1 rows, expected 2"
    );
}

#[test]
fn uneven_frames_are_no_movie() {
    let mut map = mapped(1, 1, &[vec![1.0], vec![2.0]]);
    let mut frames = map.recording.frames().to_vec();
    frames[1].time = 0.4;
    map.recording = Recording::new(map.grid.all(), frames).expect("sound");
    let message = tekscan::write(&map).expect_err("uneven").to_string();
    assert_eq!(message, "frame 1: a Tekscan movie needs equal times between frames");
    assert_same(&read(&xsensor::write(&map)).expect("read back"), &map);
}
