//! XSENSOR-style CSV: each frame is a block of lines `Key,value`, then `SENSELS` and its rows, then an empty line.
//!
//! Keys: `FRAME`, `Time (s)`, `Duration (s)` (default: until the next frame; the last one as long as the one before; a
//! single frame has duration 0), `Rows`, `Columns`, `Row Pitch`, `Column Pitch` (with unit), `Units`. Other keys are
//! ignored, and later frames may omit what the first one states. All frames have the same sensels, but units of their
//! own, and no frame lasts beyond the start of the next.

use super::text::{FileError, Mapped, count, mapped, metres, number, pascal, row, row_text, seconds};
use crate::map::{Frame, Grid};
use std::fmt::Write as _;

/// Pitches that differ relatively by less count as equal: they may be stated in other units.
const ALIKE: f64 = 1e-9;
/// Times may be rounded to a millisecond, but by no more than a tenth of the time between two frames.
const ROUNDING: (f64, f64) = (1e-3, 0.1);

/// The values of keys read so far.
#[derive(Default)]
struct Head {
    rows: Option<usize>,
    columns: Option<usize>,
    row_pitch: Option<f64>,
    column_pitch: Option<f64>,
    unit: Option<f64>,
    /// Time, and the line that states it.
    time: Option<(f64, usize)>,
    /// Duration, and the line that states it.
    seconds: Option<(f64, usize)>,
}

/// A frame as it is read.
struct Block {
    /// Time, and the line that states it.
    time: Option<(f64, usize)>,
    /// Duration, and the line that states it.
    seconds: Option<(f64, usize)>,
    pressure: Vec<f64>,
}

impl Head {
    /// Takes a key; `first` are the sensels of the first frame.
    fn take(&mut self, text: &str, line: usize, first: Option<&Grid>) -> Result<(), FileError> {
        let (key, value) = text.split_once(',').unwrap_or((text, ""));
        let value = unquoted(value.trim().trim_end_matches(','));
        let value = value.as_str();
        match key.trim().trim_matches('"').to_ascii_lowercase().as_str() {
            "rows" => self.rows = Some(count(value, line)?),
            "columns" => self.columns = Some(count(value, line)?),
            "row pitch" => self.row_pitch = Some(metres(value, line)?),
            "column pitch" => self.column_pitch = Some(metres(value, line)?),
            "units" => self.unit = Some(pascal(value, line)?),
            "time (s)" => self.time = Some((number(value, line)?, line)),
            "duration (s)" => self.seconds = Some((seconds(value, line)?, line)),
            _ => {}
        }
        let Some(first) = first else { return Ok(()) };
        let refused = |what: &str| {
            Err(FileError::at(
                line,
                format!("{what} changes between frames, expected the same sensels in all; split the file"),
            ))
        };
        if self.rows != Some(first.rows) || self.columns != Some(first.columns) {
            return refused("the number of sensels");
        }
        let is_alike =
            |found: Option<f64>, pitch: f64| found.is_some_and(|x| (x / pitch - 1.0).abs() < ALIKE);
        if !is_alike(self.row_pitch, first.row_pitch) || !is_alike(self.column_pitch, first.column_pitch) {
            return refused("the pitch of sensels");
        }
        Ok(())
    }

    fn grid(&self, line: usize) -> Result<(Grid, f64), FileError> {
        let lacks = |key: &str| FileError::at(line, format!("`{key}` is missing before the sensels"));
        let grid = Grid {
            rows: self.rows.ok_or_else(|| lacks("Rows"))?,
            columns: self.columns.ok_or_else(|| lacks("Columns"))?,
            row_pitch: self.row_pitch.ok_or_else(|| lacks("Row Pitch"))?,
            column_pitch: self.column_pitch.ok_or_else(|| lacks("Column Pitch"))?,
        };
        Ok((grid, self.unit.ok_or_else(|| lacks("Units"))?))
    }
}

/// Reads frames.
///
/// # Errors
/// [`FileError`] at the first line that is wrong, or where the text ends too early.
pub fn read(text: &str) -> Result<Mapped, FileError> {
    let mut head = Head::default();
    let mut grid: Option<Grid> = None;
    let mut blocks: Vec<Block> = Vec::new();
    // The line of a frame whose sensels are to come.
    let mut begun: Option<usize> = None;
    let without =
        |line| FileError::at(line, "this frame has no `SENSELS`: the file was cut, or lost some lines");
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    while let Some((line, text)) = lines.next() {
        if !text.to_ascii_lowercase().starts_with("sensels") {
            if let Some(grid) = grid.as_ref().filter(|_| is_row(text)) {
                return Err(FileError::at(line, format!("more than {} rows in this frame", grid.rows)));
            }
            let key = text.split(',').next().unwrap_or_default().trim().trim_matches('"');
            if key.eq_ignore_ascii_case("frame")
                && let Some(line) = begun.replace(line)
            {
                return Err(without(line));
            }
            head.take(text, line, grid.as_ref())?;
            continue;
        }
        begun = None;
        let (sensels, unit) = head.grid(line)?;
        let mut pressure = Vec::new();
        for index in 0..sensels.rows {
            let Some((line, text)) = lines.next().filter(|(_, text)| !text.is_empty()) else {
                let rows = sensels.rows;
                return Err(FileError::at(
                    line,
                    format!("the sensels end after {index} rows, expected {rows}"),
                ));
            };
            row(text, sensels.columns, unit, line, &mut pressure)?;
        }
        blocks.push(Block { time: head.time.take(), seconds: head.seconds.take(), pressure });
        grid.get_or_insert(sensels);
    }
    if let Some(line) = begun.filter(|_| grid.is_some()) {
        return Err(without(line));
    }
    let Some(grid) = grid else {
        return Err(FileError::at(0, "no line `SENSELS`: not an XSENSOR-style file"));
    };
    mapped(grid, timed(blocks)?)
}

/// A value without the quotes around it; within them two stand for one. A single one at its end means inches.
fn unquoted(value: &str) -> String {
    let inner = value.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    inner.map_or_else(|| value.to_owned(), |inner| inner.replace("\"\"", "\""))
}

/// Whether a line is a row of pressures rather than a key.
fn is_row(text: &str) -> bool {
    text.split(',').next().is_some_and(|value| value.trim().parse::<f64>().is_ok())
}

/// Frames with their times and durations.
fn timed(blocks: Vec<Block>) -> Result<Vec<Frame>, FileError> {
    let mut times: Vec<f64> = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        if block.time.is_none() && blocks.len() > 1 {
            return Err(FileError::at(0, format!("frame {index}: `Time (s)` is missing")));
        }
        let (time, line) = block.time.unwrap_or_default();
        if let Some(before) = times.last().filter(|before| time <= **before) {
            let what =
                format!("a time of {time} s, expected later than {before} s, that of the frame before");
            return Err(FileError::at(line, what));
        }
        times.push(time);
    }
    let mut before = 0.0;
    let mut frames = Vec::new();
    for (index, Block { seconds, pressure, .. }) in blocks.into_iter().enumerate() {
        let till_next = times.get(index + 1).map(|next| next - times[index]);
        if let (Some((seconds, line)), Some(most)) = (seconds, till_next) {
            fits(seconds, most, line)?;
        }
        before = seconds.map(|(seconds, _)| seconds).or(till_next).unwrap_or(before);
        frames.push(Frame { time: times[index], seconds: before, pressure, shear: Vec::new() });
    }
    Ok(frames)
}

/// Checks that a frame ends before the next one begins.
fn fits(seconds: f64, till_next: f64, line: usize) -> Result<(), FileError> {
    let (most, share) = ROUNDING;
    if seconds <= till_next + most.min(share * till_next) {
        return Ok(());
    }
    Err(FileError::at(
        line,
        format!("a duration of {seconds} s, expected at most {till_next} s, when the next frame begins"),
    ))
}

/// Writes frames in mmHg; shear is not part of the format.
#[must_use]
pub fn write(mapped: &Mapped) -> String {
    let grid = &mapped.grid;
    let mut text = String::new();
    for (index, frame) in mapped.recording.frames().iter().enumerate() {
        let _ =
            writeln!(text, "FRAME,{}\nTime (s),{}\nDuration (s),{}", index + 1, frame.time, frame.seconds);
        let (rows, columns) = (grid.rows, grid.columns);
        let _ = writeln!(text, "Rows,{rows}\nColumns,{columns}\nRow Pitch,{} m", grid.row_pitch);
        let _ = writeln!(text, "Column Pitch,{} m\nUnits,mmHg\nSENSELS", grid.column_pitch);
        for row in frame.pressure.chunks(grid.columns) {
            text.push_str(&row_text(row, crate::map::MMHG));
            text.push('\n');
        }
        text.push('\n');
    }
    text
}
