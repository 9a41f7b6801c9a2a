//! XSENSOR-style CSV: each frame is a block of lines `Key,value`, then `SENSELS` and its rows, then an empty line.
//!
//! Keys: `FRAME`, `Time (s)`, `Duration (s)` (default: until the next frame; the last one as long as the one before; a
//! single frame has duration 0), `Rows`, `Columns`, `Row Pitch`, `Column Pitch` (with unit), `Units`. Other keys are
//! ignored, and later frames may omit what the first one states.

use super::text::{FileError, Mapped, count, mapped, metres, number, pascal, row, row_text};
use crate::map::{Frame, Grid};
use std::fmt::Write as _;

/// The values of keys read so far.
#[derive(Default)]
struct Head {
    rows: Option<usize>,
    columns: Option<usize>,
    row_pitch: Option<f64>,
    column_pitch: Option<f64>,
    unit: Option<f64>,
    time: Option<f64>,
    seconds: Option<f64>,
}

impl Head {
    fn take(&mut self, text: &str, line: usize, is_first: bool) -> Result<(), FileError> {
        let (key, value) = text.split_once(',').unwrap_or((text, ""));
        let value = value.trim().trim_end_matches(',').trim_matches('"');
        let was = (self.rows, self.columns);
        match key.trim().trim_matches('"').to_ascii_lowercase().as_str() {
            "rows" => self.rows = Some(count(value, line)?),
            "columns" => self.columns = Some(count(value, line)?),
            "row pitch" => self.row_pitch = Some(metres(value, line)?),
            "column pitch" => self.column_pitch = Some(metres(value, line)?),
            "units" => self.unit = Some(pascal(value, line)?),
            "time (s)" => self.time = Some(number(value, line)?),
            "duration (s)" => self.seconds = Some(number(value, line)?),
            _ => {}
        }
        if !is_first && was != (self.rows, self.columns) {
            return Err(FileError::at(line, "the number of sensels changes between frames"));
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
    let mut grid = None;
    let mut frames: Vec<(Option<f64>, Option<f64>, Vec<f64>)> = Vec::new();
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    while let Some((line, text)) = lines.next() {
        if !text.to_ascii_lowercase().starts_with("sensels") {
            head.take(text, line, frames.is_empty())?;
            continue;
        }
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
        frames.push((head.time.take(), head.seconds.take(), pressure));
        grid = Some(sensels);
    }
    let Some(grid) = grid else {
        return Err(FileError::at(0, "no line `SENSELS`: not an XSENSOR-style file"));
    };
    mapped(grid, timed(frames)?)
}

/// Frames with their times and durations.
fn timed(read: Vec<(Option<f64>, Option<f64>, Vec<f64>)>) -> Result<Vec<Frame>, FileError> {
    let mut times = Vec::new();
    for (index, (time, _, _)) in read.iter().enumerate() {
        if time.is_none() && read.len() > 1 {
            return Err(FileError::at(0, format!("frame {index}: `Time (s)` is missing")));
        }
        times.push(time.unwrap_or(0.0));
    }
    let mut before = 0.0;
    let frames = read.into_iter().enumerate().map(|(index, (_, seconds, pressure))| {
        let till_next = times.get(index + 1).map(|next| next - times[index]);
        before = seconds.or(till_next).unwrap_or(before);
        Frame { time: times[index], seconds: before, pressure, shear: Vec::new() }
    });
    Ok(frames.collect())
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
