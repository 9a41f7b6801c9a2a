//! `smartbed bed map`: reads maps exported by a sensor maker's program, computes all metrics, compares them, and writes
//! them in the other format.
//!
//! In: a file of Tekscan's or XSENSOR's. Out: metrics as a table, as CSV or as one JSON object, differences to another
//! file of the same sensels, a file in the format given by its ending.

use super::rows::{self, csv, table, write};
use crate::failure::Failure;
use crate::number::{json_number, json_string};
use crate::{input, output};
use smartbed_bed::files::{self, Mapped, tekscan, xsensor};
use smartbed_bed::map::{Frame, MMHG};
use smartbed_bed::metrics::report::{Report, Row, WINDOW};
use smartbed_bed::metrics::{DISCLAIMER, Thresholds, spatial};
use smartbed_bed::plan::Layout;

/// Pitches of sensels that differ relatively by less count as equal.
const ALIKE: f64 = 1e-6;

/// What `bed map` takes.
#[derive(clap::Args, Clone, Debug)]
pub struct Map {
    /// Pressure maps over time: a Tekscan ASCII movie or an XSENSOR CSV file; - is standard input.
    pub file: String,
    /// Also print the differences from these maps, frame by frame; they must have the same sensels.
    #[arg(long, value_name = "FILE")]
    pub against: Option<String>,
    /// Length of a pressure cycle in s, for metrics over time.
    #[arg(long, value_name = "SECONDS", default_value_t = 600.0)]
    pub cycle: f64,
    /// Write the metrics as CSV to this file; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,
    /// Write the maps to this file: .csv in XSENSOR's format, .asf in Tekscan's.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<String>,
    /// Print the result as one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
pub(super) fn run(asked: &Map) -> Result<(), Failure> {
    if !(asked.cycle > 0.0 && asked.cycle.is_finite()) {
        return Err(Failure::Wrong(format!("--cycle {}: expected seconds > 0", asked.cycle)));
    }
    let csv_printed = asked.csv.as_deref() == Some("-");
    output::one_in_standard_output(&[("--csv -", csv_printed), ("--json", asked.json)])?;
    let results = [("--csv", asked.csv.as_deref()), ("--output", asked.output.as_deref())];
    output::replace_none(
        &results,
        &[Some(&asked.file), asked.against.as_ref()].map(|f| f.map_or("-", |f| f.as_str())),
    )?;
    let mapped = read(&asked.file)?;
    let rows = [("sensels", rows(&mapped, asked.cycle))];
    let compared = match &asked.against {
        Some(other) => Some(compared(&asked.file, &mapped, other, &read(other)?)?),
        None => None,
    };
    if let Some(file) = &asked.output {
        write(file, &encoded(file, &mapped)?)?;
    }
    if let Some(file) = &asked.csv {
        write(file, &csv(&rows))?;
    }
    if csv_printed {
        return Ok(());
    }
    if asked.json {
        return output::print(&json(asked, &mapped, compared.as_ref(), &rows));
    }
    let compared = compared.map_or_else(String::new, |difference| difference.text());
    let (grid, recording) = (&mapped.grid, &mapped.recording);
    let head = format!(
        "{}: {} x {} sensels of {:.2} by {:.2} mm, {} frames over {} s\n{compared}",
        asked.file,
        grid.rows,
        grid.columns,
        1e3 * grid.column_pitch,
        1e3 * grid.row_pitch,
        recording.frames().len(),
        recording.seconds()
    );
    output::print(&format!("{head}{}\n{DISCLAIMER}\n", table(&rows)))
}

fn read(file: &str) -> Result<Mapped, Failure> {
    let text = input::text(file).map_err(|e| format!("{file}: {e}"))?;
    Ok(files::read(&text).map_err(|e| format!("{file}: {e}"))?)
}

/// All metrics of the maps.
fn rows(mapped: &Mapped, cycle: f64) -> Vec<Row> {
    let thresholds = Thresholds { cycle, ..Thresholds::default() };
    let friction = Layout::default().friction;
    Report { recording: &mapped.recording, grid: Some(&mapped.grid), thresholds, friction }.rows()
}

/// Metrics and differences as one JSON object.
fn json(
    asked: &Map,
    mapped: &Mapped,
    compared: Option<&Difference>,
    metrics: &[(&'static str, Vec<Row>)],
) -> String {
    let (grid, recording) = (&mapped.grid, &mapped.recording);
    format!(
        "{{\"file\": {}, \"rows\": {}, \"columns\": {}, \"pitch\": [{}, {}], \"frames\": {}, \"seconds\": {}, \
         \"difference\": {}, {}, \"note\": {}}}\n",
        json_string(&asked.file),
        grid.rows,
        grid.columns,
        json_number(grid.column_pitch),
        json_number(grid.row_pitch),
        recording.frames().len(),
        json_number(recording.seconds()),
        compared.map_or_else(|| "null".to_owned(), Difference::json),
        rows::json(metrics).join(", "),
        json_string(DISCLAIMER)
    )
}

/// What tells two recordings of the same sensels apart.
struct Difference {
    against: String,
    /// Root mean square over all pressures (mmHg).
    rms: f64,
    /// Peak pressure index of the last map over that of the other one, less 1.
    index: Option<f64>,
}

impl Difference {
    fn text(&self) -> String {
        let index = self.index.map_or_else(|| "-".to_owned(), |share| format!("{:.2} %", 100.0 * share));
        let Self { against, rms, .. } = self;
        format!("against {against}: {rms:.3} mmHg root mean square, peak pressure index {index} of it\n")
    }

    fn json(&self) -> String {
        let index = self.index.map_or_else(|| "null".to_owned(), json_number);
        let (against, rms) = (json_string(&self.against), json_number(self.rms));
        format!("{{\"against\": {against}, \"rms\": {rms}, \"peak_pressure_index\": {index}}}")
    }
}

/// Compares two recordings.
fn compared(name: &str, one: &Mapped, other_name: &str, other: &Mapped) -> Result<Difference, Failure> {
    let (a, b) = (&one.grid, &other.grid);
    let is_alike = |x: f64, y: f64| (x / y - 1.0).abs() < ALIKE;
    let same = (a.rows, a.columns) == (b.rows, b.columns)
        && is_alike(a.row_pitch, b.row_pitch)
        && is_alike(a.column_pitch, b.column_pitch);
    let [frames, others] = [one, other].map(|mapped| mapped.recording.frames());
    if !same || frames.len() != others.len() {
        let shape = |mapped: &Mapped| {
            let (grid, frames) = (&mapped.grid, mapped.recording.frames().len());
            let [x, y] = [grid.column_pitch, grid.row_pitch].map(|pitch| 1e3 * pitch);
            format!("{frames} frames of {} x {} sensels of {x} by {y} mm", grid.rows, grid.columns)
        };
        let said = format!("{name} has {}, {other_name} {}", shape(one), shape(other));
        return Err(Failure::Wrong(format!("{said}; expected the same sensels and as many frames")));
    }
    let square = |(p, q): (&Frame, &Frame)| spatial::apart(&p.pressure, &q.pressure).powi(2);
    let mean = frames.iter().zip(others).map(square).sum::<f64>() / frames.len() as f64;
    let index = |mapped: &Mapped| {
        let last = mapped.recording.frames().last()?;
        spatial::peak_pressure_index(&mapped.grid, &last.pressure, WINDOW)
    };
    let index = match (index(one), index(other)) {
        (Some(own), Some(theirs)) if theirs > 0.0 => Some(own / theirs - 1.0),
        _ => None,
    };
    Ok(Difference { against: other_name.to_owned(), rms: mean.sqrt() / MMHG, index })
}

/// A format of maps.
#[derive(Clone, Copy)]
pub(super) enum Format {
    Xsensor,
    Tekscan,
}

/// The format by the ending of a file's name.
pub(super) fn ending(file: &str) -> Result<Format, Failure> {
    match file.rsplit('.').next().unwrap_or_default().to_ascii_lowercase().as_str() {
        "csv" => Ok(Format::Xsensor),
        "asf" => Ok(Format::Tekscan),
        _ => Err(Failure::Wrong(format!("{file}: expected a name that ends in .csv or .asf"))),
    }
}

/// Maps in the format given by the ending of a file's name; warns if the format says something else.
pub(super) fn encoded(file: &str, mapped: &Mapped) -> Result<String, Failure> {
    let text = match ending(file)? {
        Format::Xsensor => return Ok(xsensor::write(mapped)),
        Format::Tekscan => tekscan::write(mapped).map_err(|e| format!("{file}: {e}"))?,
    };
    if let Some(seconds) = tekscan::added(mapped) {
        output::say(&format!(
            "warning: {file}: the last moment, which stands for no time, lasts {seconds} s there, since all moments of \
             a Tekscan movie last as long: metrics over time differ; write .csv to keep it"
        ));
    }
    Ok(text)
}
