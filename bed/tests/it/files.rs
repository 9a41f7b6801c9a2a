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
        ("10.16 mm", "0.4", "line 4: `0.4` has no unit of length: expected mm, cm, m or in, as in `10 mm`"),
        ("FRAME 0.1", "FRAME -1", "line 6: expected seconds >= 0, found `-1`"),
        (
            "UNITS mmHg\n",
            "UNITS mmHg\nEND_FRAME 5\n",
            "line 8: 1 frames follow, expected 5, from frame 1 to frame 5; export it again",
        ),
        (
            "UNITS mmHg\n",
            "END_FRAME 7\nSTART_FRAME 6\nUNITS mmHg\n",
            "line 7: 1 frames follow, expected 2, from frame 6 to frame 7; export it again",
        ),
        ("UNITS mmHg", "END_FRAME last", "line 7: expected a number, found `last`"),
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
fn a_part_of_a_movie_has_as_many_frames_as_it_says() {
    let part = MOVIE.replace("UNITS mmHg\n", "UNITS mmHg\nSTART_FRAME 5\nEND_FRAME 5\n");
    assert_eq!(read(&part).expect("a movie"), read(MOVIE).expect("a movie"));
}

const BLOCKS: &str = "FRAME,1
Time (s),0
Duration (s),1
Rows,2
Columns,2
Row Pitch,10 mm
Column Pitch,10 mm
Units,kPa
SENSELS
1,2
3,4

FRAME,2
Time (s),1
Duration (s),3
Rows,2
Columns,2
Row Pitch,1 cm
Column Pitch,10 mm
Units,mmHg
SENSELS
1,2
3,4
";

#[test]
fn blocks_have_the_same_sensels_but_units_of_their_own() {
    let frames = read(BLOCKS).expect("blocks").recording.frames().to_vec();
    assert_eq!(frames.iter().map(|f| (f.time, f.seconds)).collect::<Vec<_>>(), [(0.0, 1.0), (1.0, 3.0)]);
    assert_eq!(frames[0].pressure, [1e3, 2e3, 3e3, 4e3]);
    assert_eq!(frames[1].pressure, [1.0, 2.0, 3.0, 4.0].map(|p| p * 133.322));
    // A key may follow without an empty line.
    assert_eq!(read(&BLOCKS.replace("3,4\n\n", "3,4\n")).expect("blocks").recording.frames(), frames);
}

#[test]
fn refusals_of_blocks_name_the_line() {
    let changed = |what: &str| {
        format!("{what} changes between frames, expected the same sensels in all; split the file")
    };
    for (from, to, message) in [
        ("3,4\n\n", "3,4\n5,6\n\n", "line 12: more than 2 rows in this frame".to_owned()),
        ("3,4\n\n", "3,4\n\n5,6\n\n", "line 13: more than 2 rows in this frame".to_owned()),
        (
            "Rows,2\nColumns,2\nRow Pitch,1 cm",
            "Rows,3",
            format!("line 16: {}", changed("the number of sensels")),
        ),
        ("Row Pitch,1 cm", "Row Pitch,11 mm", format!("line 18: {}", changed("the pitch of sensels"))),
        ("10 mm\nUnits,mmHg", "9 mm\nUnits,mmHg", format!("line 19: {}", changed("the pitch of sensels"))),
        (
            "Duration (s),1",
            "Duration (s),1000",
            "line 3: a duration of 1000 s, expected at most 1 s, when the next frame begins".to_owned(),
        ),
        ("Duration (s),1", "Duration (s),-1", "line 3: expected seconds >= 0, found `-1`".to_owned()),
        (
            "Time (s),1",
            "Time (s),-1",
            "line 14: a time of -1 s, expected later than 0 s, that of the frame before".to_owned(),
        ),
        (
            "Row Pitch,10 mm",
            "Row Pitch,0.5",
            "line 6: `0.5` has no unit of length: expected mm, cm, m or in, as in `10 mm`".to_owned(),
        ),
    ] {
        let text = BLOCKS.replacen(from, to, 1);
        assert_ne!(text, BLOCKS, "{from}");
        assert_eq!(read(&text).expect_err(to).to_string(), message);
    }
    // The last frame's rows, and one more.
    let text = format!("{BLOCKS}5,6\n");
    assert_eq!(read(&text).expect_err("long").to_string(), "line 24: more than 2 rows in this frame");
}

#[test]
fn a_time_that_goes_back_is_refused_at_its_own_frame() {
    let later = BLOCKS.split_once("\n\n").expect("two").1.replace("Time (s),1\n", "Time (s),0.5\n");
    let message = read(&format!("{BLOCKS}\n{later}")).expect_err("back").to_string();
    assert_eq!(message, "line 26: a time of 0.5 s, expected later than 1 s, that of the frame before");
}

#[test]
fn inches_are_written_out_or_as_a_quote() {
    for inches in ["0.5\"", "0.5 \"", "\"0.5\"\"\"", "0.5 in", "\"0.5 in\"", "0.5 inch", "0.5\","] {
        let text = BLOCKS.replacen("Row Pitch,10 mm", &format!("Row Pitch,{inches}"), 1);
        let text = text.replacen("Row Pitch,1 cm", "Row Pitch,12.7 mm", 1);
        let pitch = read(&text).unwrap_or_else(|why| panic!("{inches}: {why}")).grid.row_pitch;
        assert!((pitch - 0.0127).abs() < 1e-15, "{inches}: {pitch}");
    }
    let movie = read(&MOVIE.replacen("10.16 mm", "0.4\"", 1)).expect("a movie");
    assert!((movie.grid.row_pitch - 0.01016).abs() < 1e-15);
}

#[test]
fn durations_may_exceed_the_time_until_the_next_frame_by_rounding_alone() {
    let read_with = |next: &str, seconds: &str| {
        let text = BLOCKS.replacen("Time (s),1", &format!("Time (s),{next}"), 1);
        read(&text.replacen("Duration (s),1", &format!("Duration (s),{seconds}"), 1))
    };
    // Thirty frames a second, with times in milliseconds.
    assert!(read_with("0.033", "0.033333").is_ok());
    assert!(read_with("1", "1.0009").is_ok() && read_with("1", "1.0011").is_err());
    // A millisecond is no rounding where frames are as close.
    assert!(read_with("0.001", "0.002").is_err());
    // A shorter one leaves a gap.
    assert!(read_with("1", "0.5").is_ok());
}

#[test]
fn a_movie_gives_its_last_frame_the_duration_of_the_others() {
    let mut map = mapped(1, 1, &[vec![1.0], vec![2.0]]);
    assert_eq!(tekscan::added(&map), None);
    let mut frames = map.recording.frames().to_vec();
    frames[1].seconds = 0.0;
    map.recording = Recording::new(map.grid.all(), frames.clone()).expect("sound");
    assert_eq!(tekscan::added(&map), Some(0.25));
    let again = read(&tekscan::write(&map).expect("even")).expect("read back");
    assert_eq!((map.recording.seconds(), again.recording.seconds()), (0.25, 0.5));
    assert_same(&read(&xsensor::write(&map)).expect("read back"), &map);
    // A single frame of no duration keeps it.
    map.recording = Recording::new(map.grid.all(), frames.split_off(1)).expect("sound");
    assert_eq!(tekscan::added(&map), None);
    let again = read(&tekscan::write(&map).expect("even")).expect("read back");
    assert_eq!(again.recording.seconds(), 0.0);
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

#[test]
fn nothing_follows_the_end_of_a_movie() {
    let text = tekscan::write(&mapped(1, 1, &[vec![1.0], vec![2.0]])).expect("even");
    let message = read(&format!("{text}{text}")).expect_err("two movies").to_string();
    assert!(message.contains("ends with `@@`"), "{message}");
    assert!(read(&format!("{text}\n,,\n")).is_ok());
}

/// A cut after the last row, or within its last number, is seen by what is missing behind it.
#[test]
fn what_is_cut_short_is_refused() {
    let map = mapped(1, 2, &[vec![1.0, 2.5], vec![2.0, 3.25]]);
    let movie = tekscan::write(&map).expect("even");
    for cut in [movie.trim_end().trim_end_matches("@@"), movie.trim_end().trim_end_matches("@@").trim_end()] {
        let said = read(cut).expect_err("cut").to_string();
        assert!(said.contains("`@@`, which is missing"), "{said}");
    }
    let blocks = xsensor::write(&map);
    let last = blocks.rfind("SENSELS").expect("the second frame");
    let said = read(&blocks[..last]).expect_err("cut").to_string();
    assert!(said.contains("has no `SENSELS`"), "{said}");
    // The first frame lost its sensels: the second one begins.
    let [from, to] = [blocks.find("SENSELS").expect("one"), blocks.find("FRAME,2").expect("two")];
    let said = read(&(blocks[..from].to_owned() + &blocks[to..])).expect_err("lost").to_string();
    assert!(said.contains("has no `SENSELS`"), "{said}");
}
