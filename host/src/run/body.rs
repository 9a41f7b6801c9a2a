//! `smartbed run` of a scene: a flexible body instead of a mechanism, with the same arguments.

use super::Arguments;
use crate::engine::{EngineKind, ScalarKind};
use crate::failure::Failure;
use crate::number::{json_number, json_string};
use crate::output::{self, Output};
use crate::plot::chart::{self, Curve, Panel};
use crate::plot::{self, Recording};
use crate::progress::Progress;
use crate::scene::read::{self, Scene};
use crate::scene::run::{EventRecord, Row, csv_header, csv_line, run};
use crate::view::{self, Film};
use smartbed_runtime::real::Scalar;
use std::path::Path;

/// Most points whose height is plotted.
const PLOTTED: usize = 8;

/// Is the text at this path a scene and not a mechanism?
#[must_use]
pub(super) fn is_scene(path: &Path) -> bool {
    if path.extension().is_some_and(|e| e == "json") {
        return true;
    }
    let text = std::fs::read_to_string(path).unwrap_or_default();
    // A text that cannot be read is a mechanism's: its reader explains best.
    let table = text.parse::<toml::Table>().unwrap_or_default();
    table.contains_key("shape") || table.get("points").is_some_and(toml::Value::is_array)
}

/// Runs it.
///
/// # Errors
/// Status 1 for a wrong scene or setting and for a motion that cannot go on.
pub(super) fn simulate(arguments: &Arguments, path: &Path) -> Result<(), Failure> {
    if arguments.engine == EngineKind::Compiled {
        return Err(Failure::Wrong("--engine compiled: a scene is stepped by the runtime itself".to_owned()));
    }
    let scene = read::open(&path.display().to_string(), &settings(arguments)).map_err(Failure::Wrong)?;
    let clock = Progress::new("running");
    let done = match arguments.scalar {
        ScalarKind::F32 => record::<f32>(arguments, &scene)?,
        ScalarKind::F64 => record::<f64>(arguments, &scene)?,
    };
    let text = done.report(arguments, &scene, clock.seconds());
    if arguments.csv.as_deref() == Some("-") {
        eprint!("{text}");
    } else {
        output::print(&text);
    }
    Ok(())
}

/// The command line as settings of the scene's own keys.
fn settings(arguments: &Arguments) -> Vec<String> {
    let mut settings = Vec::new();
    let mut set = |key: &str, value: Option<String>| settings.extend(value.map(|v| format!("{key}={v}")));
    set("T", arguments.seconds.map(|x| x.to_string()));
    set("step", arguments.step.map(|x| x.to_string()));
    set("method", arguments.method.clone());
    set("tolerance", arguments.error.map(|x| x.to_string()));
    set("every", arguments.every.map(|n| n.to_string()));
    settings.extend(arguments.set.iter().cloned());
    settings
}

/// What a run of a scene was.
struct Done {
    events: Vec<EventRecord>,
    rows: u64,
    imbalance: f64,
    total: [f64; 2],
}

impl Done {
    fn report(&self, arguments: &Arguments, scene: &Scene, elapsed: f64) -> String {
        let touches = self.events.iter().filter(|e| !e.touches.is_empty()).count();
        if arguments.json {
            return format!(
                "{{\"scene\": {}, \"points\": {}, \"springs\": {}, \"seconds\": {}, \"rows\": {}, \"events\": {}, \
                 \"touches\": {touches}, \"total_at_start\": {}, \"total\": {}, \"imbalance\": {}, \"elapsed\": {}}}\n",
                json_string(&scene.title),
                scene.lists.points.len(),
                scene.lists.springs.len(),
                json_number(scene.seconds),
                self.rows,
                self.events.len(),
                json_number(self.total[0]),
                json_number(self.total[1]),
                json_number(self.imbalance),
                json_number(elapsed),
            );
        }
        format!(
            "{}: {} points, {} springs, {} s, {elapsed:.2} s\n{touches} touches, {} events\n\
             energy: {:.6e} J at the start, {:.6e} J at the end, largest imbalance {:.1e} J\n",
            scene.title,
            scene.lists.points.len(),
            scene.lists.springs.len(),
            scene.seconds,
            self.events.len(),
            self.total[0],
            self.total[1],
            self.imbalance
        )
    }
}

/// Steps and writes what is asked for.
fn record<S: Scalar>(arguments: &Arguments, scene: &Scene) -> Result<Done, Failure> {
    let n = scene.lists.points.len();
    let mut csv = arguments.csv.as_deref().map(Output::open).transpose()?;
    if let Some(csv) = &mut csv {
        csv.write(&(csv_header(n) + "\n"))?;
    }
    let shown = n.min(PLOTTED);
    let mut recording = arguments.plot.as_ref().map(|_| Recording::new(1 + shown + ENERGIES.len()));
    let mut film = arguments.view.as_ref().map(|_| Film::of_points(n, scene.lists.springs.clone()));
    let mut progress = Progress::new("running");
    let (mut rows, mut imbalance, mut total) = (0, 0.0_f64, [f64::NAN; 2]);
    let mut failure = None;
    let events = run::<S>(scene, |row: &Row| {
        if let Some(csv) = &mut csv
            && failure.is_none()
        {
            failure = csv.write(&(csv_line(row) + "\n")).err();
        }
        if let Some(recording) = &mut recording {
            recording.push(&plotted(row, shown));
        }
        if let Some(film) = &mut film {
            film.push(row.t, row.pos.as_flattened());
        }
        total = [if rows == 0 { row.energy.total } else { total[0] }, row.energy.total];
        imbalance = imbalance.max(row.energy.imbalance.abs());
        rows += 1;
        progress.at(row.t / scene.seconds);
    })
    .map_err(Failure::Wrong)?;
    match failure {
        Some(failure) => return Err(failure),
        None => csv.map_or(Ok(()), Output::finish)?,
    }
    if let (Some(file), Some(recording)) = (&arguments.plot, &recording) {
        plot::write(file, &heights_and_energies(scene, shown, recording))?;
    }
    if let (Some(file), Some(film)) = (&arguments.view, &film) {
        output::write(file, view::page(&scene.title, film).as_bytes())?;
    }
    Ok(Done { events, rows, imbalance, total })
}

/// Energies and accounts of a plot.
const ENERGIES: [&str; 10] = [
    "kinetic", "gravity", "spring", "pressure", "damping", "drag", "impact", "friction", "actuator", "total",
];

/// Time, heights, energies.
fn plotted(row: &Row, shown: usize) -> Vec<f64> {
    let heights = row.pos.iter().take(shown).map(|x| x[2]);
    let energy = &row.energy;
    let energies = energy.stored.iter().chain(&energy.accounts).copied();
    std::iter::once(row.t).chain(heights).chain(energies).chain([energy.total]).collect()
}

fn heights_and_energies(scene: &Scene, shown: usize, recording: &Recording) -> plot::drawing::Drawing {
    let curve = |name: String, index: usize| Curve { name, values: recording.column(index) };
    let heights = (0..shown).map(|i| curve(format!("z{i}"), 1 + i)).collect();
    let energies = ENERGIES.iter().enumerate().map(|(i, name)| curve((*name).to_owned(), 1 + shown + i));
    let panels = [
        Panel { label: "height [m]".to_owned(), curves: heights },
        // An account that nothing was booked to tells nothing.
        Panel {
            label: "energy [J]".to_owned(),
            curves: energies.filter(|c| c.values.iter().any(|x| *x != 0.0)).collect(),
        },
    ];
    chart::draw(&scene.title, "time [s]", &recording.column(0), &panels)
}
