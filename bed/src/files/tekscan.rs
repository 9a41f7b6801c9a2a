//! Tekscan's ASCII movie: lines `KEY value`, then `ASCII_DATA @@`, then `Frame n` with its rows, finally `@@`.
//!
//! Required: `ROWS`, `COLS`, `ROW_SPACING`, `COL_SPACING` (with unit), `SECONDS_PER_FRAME`, `UNITS`; other keys are
//! ignored. `END_FRAME` and `START_FRAME` (default 1), if stated, give the number of frames: a movie with another one
//! was cut short. Uncalibrated files (`UNITS RAW`) are refused, because their numbers are not pressures.

use super::text::{FileError, Mapped, count, mapped, metres, number, pascal, row, row_text, seconds};
use crate::map::{Frame, Grid};
use std::fmt::Write as _;

/// The values in the head of a file, each with the line where it was read.
#[derive(Default)]
struct Head {
    rows: Option<usize>,
    columns: Option<usize>,
    row_pitch: Option<f64>,
    column_pitch: Option<f64>,
    seconds: Option<f64>,
    unit: Option<f64>,
    first_frame: Option<f64>,
    /// The number of the last frame, and the line that states it.
    last_frame: Option<(f64, usize)>,
}

impl Head {
    fn take(&mut self, text: &str, line: usize) -> Result<(), FileError> {
        let (key, value) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
        match key {
            "ROWS" => self.rows = Some(count(value, line)?),
            "COLS" => self.columns = Some(count(value, line)?),
            "ROW_SPACING" => self.row_pitch = Some(metres(value, line)?),
            "COL_SPACING" => self.column_pitch = Some(metres(value, line)?),
            "SECONDS_PER_FRAME" => self.seconds = Some(seconds(value, line)?),
            "UNITS" => self.unit = Some(pascal(value, line)?),
            "START_FRAME" => self.first_frame = Some(number(value, line)?),
            "END_FRAME" => self.last_frame = Some((number(value, line)?, line)),
            _ => {}
        }
        Ok(())
    }

    /// The grid, seconds per frame, and Pascal per unit.
    fn whole(&self, line: usize) -> Result<(Grid, f64, f64), FileError> {
        let lacks = |key: &str| FileError::at(line, format!("`{key}` is missing before the data"));
        let grid = Grid {
            rows: self.rows.ok_or_else(|| lacks("ROWS"))?,
            columns: self.columns.ok_or_else(|| lacks("COLS"))?,
            row_pitch: self.row_pitch.ok_or_else(|| lacks("ROW_SPACING"))?,
            column_pitch: self.column_pitch.ok_or_else(|| lacks("COL_SPACING"))?,
        };
        let seconds = self.seconds.ok_or_else(|| lacks("SECONDS_PER_FRAME"))?;
        Ok((grid, seconds, self.unit.ok_or_else(|| lacks("UNITS"))?))
    }

    /// Checks the number of frames that were read.
    fn counted(&self, frames: usize) -> Result<(), FileError> {
        let Some((last, line)) = self.last_frame else { return Ok(()) };
        let first = self.first_frame.unwrap_or(1.0);
        let expected = last - first + 1.0;
        if frames as f64 == expected {
            return Ok(());
        }
        Err(FileError::at(
            line,
            format!(
                "{frames} frames follow, expected {expected}, from frame {first} to frame {last}; export it again"
            ),
        ))
    }
}

/// Reads a movie.
///
/// # Errors
/// [`FileError`] at the first line that is wrong, or where the text ends too early.
pub fn read(text: &str) -> Result<Mapped, FileError> {
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line));
    let mut head = Head::default();
    let start = loop {
        let Some((line, text)) = lines.next() else {
            return Err(FileError::at(0, "no line `ASCII_DATA @@`: not an ASCII movie"));
        };
        if text.starts_with("ASCII_DATA") {
            break line;
        }
        head.take(text, line)?;
    };
    let (grid, seconds, unit) = head.whole(start)?;
    let mut frames: Vec<Frame> = Vec::new();
    let mut last = start;
    let mut ended = false;
    for (line, text) in lines {
        let text = text.trim();
        if text.trim_start_matches(',').is_empty() {
            continue;
        }
        if ended {
            return Err(FileError::at(line, "a movie ends with `@@`: expected nothing after it"));
        }
        if text.starts_with("@@") {
            ended = true;
            continue;
        }
        last = line;
        if text.starts_with("Frame") {
            full(&grid, frames.last(), line)?;
            let time = frames.len() as f64 * seconds;
            frames.push(Frame { time, seconds, pressure: Vec::new(), shear: Vec::new() });
            continue;
        }
        let Some(frame) = frames.last_mut() else {
            return Err(FileError::at(line, "expected a line `Frame` before the first row"));
        };
        if frame.pressure.len() >= grid.sites() {
            return Err(FileError::at(line, format!("more than {} rows in this frame", grid.rows)));
        }
        row(text, grid.columns, unit, line, &mut frame.pressure)?;
    }
    full(&grid, frames.last(), last)?;
    if !ended {
        return Err(FileError::at(last, "a movie ends with `@@`, which is missing: the file was cut short"));
    }
    if frames.is_empty() {
        return Err(FileError::at(0, "no frame after `ASCII_DATA`"));
    }
    head.counted(frames.len())?;
    mapped(grid, frames)
}

/// Checks that the frame before this line has all its rows.
fn full(grid: &Grid, frame: Option<&Frame>, line: usize) -> Result<(), FileError> {
    let found = frame.map_or(grid.sites(), |f| f.pressure.len());
    if found == grid.sites() {
        return Ok(());
    }
    let rows = found / grid.columns.max(1);
    Err(FileError::at(line, format!("the frame ends after {rows} rows, expected {}", grid.rows)))
}

/// The duration (s) that [`write()`] gives to the last frame, if that has none of its own: all frames of a movie have
/// the same.
#[must_use]
pub fn added(mapped: &Mapped) -> Option<f64> {
    let frames = mapped.recording.frames();
    let (first, last) = (frames.first()?, frames.last()?);
    (last.seconds == 0.0 && first.seconds > 0.0).then_some(first.seconds)
}

/// Writes a movie in kPa; shear is not part of the format.
///
/// # Errors
/// Frames with different durations, which the format cannot express; a final frame of duration 0 gets that of the
/// others: see [`added`].
pub fn write(mapped: &Mapped) -> Result<String, FileError> {
    let (grid, frames) = (&mapped.grid, mapped.recording.frames());
    let seconds = frames.first().map_or(1.0, |f| f.seconds);
    let start = frames.first().map_or(0.0, |f| f.time);
    let even = |(index, f): (usize, &Frame)| {
        let expected = start + index as f64 * seconds;
        let is_end = f.seconds == 0.0 && index + 1 == frames.len();
        (f.seconds == seconds || is_end) && (f.time - expected).abs() <= 1e-9 * (seconds + expected.abs())
    };
    if let Some(index) = (0..frames.len()).find(|i| !even((*i, &frames[*i]))) {
        return Err(FileError::at(
            0,
            format!("frame {index}: a Tekscan movie needs equal times between frames"),
        ));
    }
    let mut text = String::from("DATA_TYPE MOVIE\nVERSION 1.0\n");
    let _ = write!(
        text,
        "ROWS {}\nCOLS {}\nROW_SPACING {} mm\nCOL_SPACING {} mm\nSENSEL_AREA {} mm2\nSECONDS_PER_FRAME {seconds}\n",
        grid.rows,
        grid.columns,
        grid.row_pitch * 1e3,
        grid.column_pitch * 1e3,
        grid.cell() * 1e6
    );
    let _ = write!(text, "UNITS kPa\nSTART_FRAME 1\nEND_FRAME {}\nASCII_DATA @@\n", frames.len());
    for (index, frame) in frames.iter().enumerate() {
        let _ = writeln!(text, "Frame {}", index + 1);
        for row in frame.pressure.chunks(grid.columns) {
            text.push_str(&row_text(row, 1000.0));
            text.push('\n');
        }
        text.push('\n');
    }
    text.push_str("@@\n");
    Ok(text)
}
