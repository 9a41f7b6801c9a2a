//! `smartbed run` of a scene: a flexible body instead of a mechanism, with the same arguments.

use super::arguments::Arguments;
use super::health::{Energies, Health};
use super::outcome::{Outcome, ended_early, noted};
use super::simulate::interrupted;
use crate::engine::{EngineKind, ScalarKind};
use crate::failure::Failure;
use crate::interrupt;
use crate::limits::check_numbers;
use crate::number::{json_number, json_string, worst};
use crate::output::{self, Output};
use crate::plot;
use crate::progress::Progress;
use crate::scene::graph::Drawings;
use crate::scene::read::{self, Scene};
use crate::scene::run::{EventRecord, Row, csv_header, csv_line, run_until};
use crate::view::film::{Film, Series};
use crate::view::scene::stage;
use smartbed_codegen::words::count;
use smartbed_runtime::contact::ContactLaw;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::scene::{MAX_EVENTS, MAX_SUBSTEPS};
use std::collections::BTreeMap;
use std::path::Path;

/// Points whose heights the page plots.
const HEIGHTS: usize = 7;

/// Runs it; returns the summary, and the data of `--view`. What was found before joins the findings.
///
/// # Errors
/// Status 1 for a wrong scene or setting and for a motion that cannot go on.
pub(super) fn simulate(arguments: &Arguments, path: &Path, before: &[String]) -> Result<Outcome, Failure> {
    if arguments.engine == EngineKind::Compiled {
        return Err(Failure::Wrong(
            "--engine compiled: it is for mechanisms; leave it out for a scene".to_owned(),
        ));
    }
    let scene = read::open(&path.display().to_string(), &settings(arguments)).map_err(Failure::Wrong)?;
    scene.warnings.iter().for_each(|warning| output::say(&format!("warning: {warning}")));
    let clock = Progress::new("running");
    let done = match arguments.scalar {
        ScalarKind::F32 => {
            check_numbers::<f32>(scene.lists.numbers()).map_err(Failure::Wrong)?;
            record::<f32>(arguments, &scene)?
        }
        ScalarKind::F64 => record::<f64>(arguments, &scene)?,
    };
    let findings = [&done.health.findings(), before].concat();
    let text = done.report(arguments, &scene, &findings, clock.seconds());
    Ok(Outcome { text, film: done.film, findings })
}

/// Translates the command line to settings of the scene's own keys.
pub(super) fn settings(arguments: &Arguments) -> Vec<String> {
    let mut settings = Vec::new();
    let mut set = |key: &str, value: Option<String>| settings.extend(value.map(|v| format!("--{key}={v}")));
    set("seconds", arguments.seconds.map(|x| x.to_string()));
    set("step", arguments.step.map(|x| x.to_string()));
    set("method", arguments.method.clone());
    set("tolerance", arguments.tolerance.map(|x| x.to_string()));
    set("every", arguments.every.map(|n| n.to_string()));
    settings.extend(arguments.set.iter().cloned());
    settings
}

/// Results of a run of a scene.
struct Done {
    events: Vec<EventRecord>,
    film: Option<String>,
    rows: u64,
    imbalance: f64,
    total: [f64; 2],
    cut_short: usize,
    health: Health,
}

impl Done {
    fn report(&self, arguments: &Arguments, scene: &Scene, findings: &[String], elapsed: f64) -> String {
        let touches = self.events.iter().filter(|e| !e.touches.is_empty()).count();
        if arguments.json {
            return format!(
                "{{\"scene\": {}, \"points\": {}, \"springs\": {}, \"seconds\": {}, \"rows\": {}, \"events\": {}, \
                 \"touches\": {touches}, \"method\": {}, \"steps_cut_short\": {}, \"total_at_start\": {}, \"total\": {}, \"imbalance\": {}, \"elapsed\": {}, \
                 \"warnings\": {}}}\n",
                json_string(&scene.title),
                scene.lists.points.len(),
                scene.lists.springs.len(),
                json_number(scene.seconds),
                self.rows,
                self.events.len(),
                json_string(scene.chosen.name),
                self.cut_short,
                json_number(self.total[0]),
                json_number(self.total[1]),
                json_number(self.imbalance),
                json_number(elapsed),
                serde_json::Value::from(findings),
            );
        }
        format!(
            "{}: {}, {}, {} s, {elapsed:.2} s\n{}\n{}, {}\n\
             energy: {:.6e} J at the start, {:.6e} J at the end, largest imbalance {:.1e} J\n",
            scene.title,
            count(scene.lists.points.len(), "point"),
            count(scene.lists.springs.len(), "spring"),
            scene.seconds,
            method(scene),
            count(touches, "touch"),
            count(self.events.len(), "event"),
            self.total[0],
            self.total[1],
            self.imbalance
        ) + &self.cut_short(scene)
    }

    /// What the limit on work per step has changed.
    fn cut_short(&self, scene: &Scene) -> String {
        if self.cut_short == 0 {
            return String::new();
        }
        // A compliant ground has no touches to be located, only changes between sticking and slipping.
        let law = scene.around.ground.as_ref().map(|ground| ground.law);
        let (events, rest) = match law {
            Some(ContactLaw::Force(_)) => ("changes between sticking and slipping", "locating these"),
            _ => ("touches and releases", "locating touches, all of them plastic (Moreau, e = 0)"),
        };
        format!(
            "warning: {} held more than {MAX_EVENTS} {events} (or {MAX_SUBSTEPS} tries): the rest of each was computed without {rest}; take \
             a smaller step\n",
            count(self.cut_short, "step")
        )
    }
}

/// The method, and why it was chosen if the scene does not name one.
fn method(scene: &Scene) -> String {
    let chosen = &scene.chosen;
    let why = if chosen.why.is_empty() { String::new() } else { format!(" by default: {}", chosen.why) };
    format!("method {}, of order {} here{why}", chosen.name, chosen.order)
}

/// Steps and writes what is asked for.
fn record<S: Scalar>(arguments: &Arguments, scene: &Scene) -> Result<Done, Failure> {
    let n = scene.lists.points.len();
    let mut csv = arguments.csv.as_deref().map(Output::open).transpose()?;
    if let Some(csv) = &mut csv {
        csv.write(&(csv_header(n) + "\n"))?;
    }
    let note = noted(scene.note(), arguments);
    let drawings = |_| Drawings::new(scene, arguments.show.as_deref(), &note);
    let mut drawings = arguments.plot.as_ref().map(drawings).transpose()?;
    let mut film = arguments.view.as_ref().map(|_| Film::new(stage(scene), series(n)));
    let mut progress = Progress::new("running");
    let (mut rows, mut imbalance, mut total, mut cut_short) = (0, 0.0_f64, [f64::NAN; 2], 0);
    let mut health = Health::new(BTreeMap::new(), S::EPSILON.to_f64());
    if csv.is_some() {
        interrupt::watch();
    }
    let done = run_until::<S, Failure>(
        scene,
        |row: &Row| {
            if let Some(csv) = &mut csv {
                csv.write(&(csv_line(row) + "\n"))?;
            }
            if let Some(drawings) = &mut drawings {
                drawings.push(row);
            }
            if let Some(film) = &mut film {
                let [kinetic, gravity, spring, pressure] = row.energy.stored;
                let energies = [kinetic, gravity, spring, pressure, row.energy.total, row.energy.imbalance];
                let values = row.pos.iter().take(HEIGHTS).map(|x| x[2]).chain(energies);
                film.push(row.t, row.pos.as_flattened(), &row.ground, values.chain(row.energy.accounts));
            }
            total = [if rows == 0 { row.energy.total } else { total[0] }, row.energy.total];
            let energy = &row.energy;
            imbalance = worst(imbalance, energy.imbalance);
            let moved: Vec<f64> = energy.accounts.iter().copied().chain([energy.total - total[0]]).collect();
            health.energies(Energies { stored: &energy.stored, moved: &moved, imbalance: energy.imbalance });
            cut_short = row.cut_short;
            rows += 1;
            Ok(())
        },
        |t| {
            progress.at(t / scene.seconds);
            interrupted(t)
        },
    );
    let events = match done {
        Ok(events) => events,
        Err(failure) => {
            let file = arguments.csv.as_deref().unwrap_or_default();
            return Err(ended_early(failure, csv, rows, file));
        }
    };
    csv.map_or(Ok(()), Output::finish)?;
    if let (Some(file), Some(drawings)) = (&arguments.plot, &drawings) {
        plot::write(file, &drawings.draw(scene, &events))?;
    }
    let film = film.map(|film| film.data(&scene.title, &note, &event_texts(&events)));
    Ok(Done { events, film, rows, imbalance, total, cut_short, health })
}

/// Curves that the page shows beside the motion, in the order of [`record`]'s values.
fn series(n: usize) -> Vec<Series> {
    let series = |name: String, group: &str| Series { name, group: group.to_owned(), factor: 1.0 };
    let heights = (0..n.min(HEIGHTS)).map(|i| series(format!("z{i}"), "height [m]"));
    let stored = ["kinetic", "gravity", "spring", "pressure", "total"].map(|name| (name, "energy [J]"));
    let accounts =
        ["imbalance", "damping", "drag", "impact", "friction", "actuator"].map(|name| (name, "ledger"));
    heights
        .chain(stored.into_iter().chain(accounts).map(|(name, group)| series(name.to_owned(), group)))
        .collect()
}

/// Texts of events.
fn event_texts(events: &[EventRecord]) -> Vec<(f64, String)> {
    let words = |event: &EventRecord| match event.touches.as_slice() {
        [] => format!("{} let go", count(event.released, "point")),
        [(point, approach, impulse)] => {
            format!("point {point} touches at {approach:.3} m/s, impulse {impulse:.3} N s")
        }
        touches => {
            let impulse: f64 = touches.iter().map(|(_, _, impulse)| impulse).sum();
            format!("{} touch, impulse {impulse:.3} N s", count(touches.len(), "point"))
        }
    };
    events.iter().map(|event| (event.time, words(event))).collect()
}
