//! `smartbed run` of a scene of format 2: arguments, rows, plots, page and summary as for a mechanism.

use super::accounts::Closed;
use super::arguments::Arguments;
use super::outcome::{Outcome, noted};
use super::records::{Kept, Records};
use super::rows::told;
use super::simulate::interrupted;
use crate::engine::{EngineKind, ScalarKind};
use crate::failure::Failure;
use crate::number::{json_number, json_object, json_string, six_digits};
use crate::output;
use crate::progress::{Progress, Waiting};
use crate::world::Assembly;
use crate::world::assembly::Law;
use crate::world::engine::{Column, Event};
use crate::world::read::settings::refuse_twice;
use crate::world::run::{Checkpoint, Ran, engine, run, single_engine};
use crate::{input, model_argument};
use smartbed_codegen::words::count;
use std::fmt::Write as _;
use std::path::Path;

/// Most events named in the summary; more are counted.
const TOLD: usize = 12;
/// Above so many contacts that press at once, a law that splits no step is usually faster.
const MANY: f64 = 64.0;

/// Reads the world, with the command line's settings.
///
/// # Errors
/// What is wrong in it, or an option that worlds do not have.
pub(super) fn open(arguments: &Arguments, path: &Path) -> Result<Assembly, Failure> {
    let refused = [
        ("--engine compiled", arguments.engine == EngineKind::Compiled),
        ("--tolerance", arguments.tolerance.is_some()),
    ];
    if let Some((option, _)) = refused.iter().find(|(_, given)| *given) {
        return Err(Failure::Wrong(format!(
            "{option}: a scene of format 2 is interpreted and takes fixed steps; leave the option out"
        )));
    }
    let mut settings = Vec::new();
    let mut set = |key: &str, value: Option<String>| settings.extend(value.map(|v| format!("{key} = {v}")));
    set("run.seconds", arguments.seconds.map(|x| format!("{x:?}")));
    set("run.step", arguments.step.map(|x| format!("{x:?}")));
    set("run.method", arguments.method.as_ref().map(|m| format!("{m:?}")));
    set("run.every", arguments.every.map(|n| n.to_string()));
    settings.extend(arguments.set.iter().cloned());
    refuse_twice(&settings).map_err(Failure::Wrong)?;
    model_argument::open_world(path, &settings)
}

/// Runs it; returns the summary, and the data of `--view`. What was found before joins the findings.
///
/// # Errors
/// Status 1 for a wrong scene or setting and for a motion that cannot go on.
pub(super) fn simulate(arguments: &Arguments, path: &Path, before: &[String]) -> Result<Outcome, Failure> {
    let assembly = open(arguments, path)?;
    let clock = Progress::new("running");
    let done = record(arguments, &assembly)?;
    let mut findings = done.kept.health.findings();
    findings.extend(done.warnings.iter().chain(before).cloned());
    let text = done.report(arguments, &assembly, &findings, clock.seconds());
    Ok(Outcome { text, film: done.film, findings })
}

/// Results of a run.
struct Done {
    method: String,
    events: Vec<Event>,
    film: Option<String>,
    warnings: Vec<String>,
    kept: Kept,
}

/// Runs the world; each row goes to what the arguments ask for.
fn record(arguments: &Arguments, assembly: &Assembly) -> Result<Done, Failure> {
    let engine = match arguments.scalar {
        ScalarKind::F64 => engine(assembly),
        ScalarKind::F32 => single_engine(assembly),
    };
    let mut engine = engine?;
    if let Some(file) = &arguments.save {
        ends_with_a_step(assembly, file)?;
    }
    let from = arguments.resume.as_deref().map(checkpoint).transpose()?;
    let mut records = Records::open(arguments, assembly, engine.columns())?;
    let mut progress = Progress::new("running");
    let method = engine.method();
    let points = pressing_points(assembly, &engine.columns());
    let mut most = 0.0_f64;
    // The first row comes when all is at rest.
    let mut settling = (assembly.run.settled && from.is_none()).then(Waiting::settling);
    let done = run::<Failure>(
        assembly,
        engine.as_mut(),
        from.as_ref(),
        |row, engine| {
            drop(settling.take());
            most = most.max(points.iter().map(|column| row.state[*column]).sum());
            records.push(row, engine)
        },
        |t| {
            progress.at(t / assembly.run.seconds);
            interrupted(t)
        },
    );
    let Ran { events, seen, warnings: mut passed, note: of_start } = match done {
        Ok(ran) => ran,
        Err(failure) => return Err(records.ended_early(failure, arguments.csv.as_deref())),
    };
    of_start.iter().for_each(|note| output::say(note));
    if most > MANY {
        output::say(&format!(
            "note: up to {most} contacts press at once, and their laws locate each touch in time; above {MANY} impact = \"moreau\", which \
             splits no steps, is usually faster: `smartbed report` measures both"
        ));
    }
    if let Some(file) = &arguments.save {
        let checkpoint = Checkpoint {
            steps: assembly.run.steps(),
            step: assembly.run.step,
            scalar: engine.scalar(),
            method: name(&method).to_owned(),
            scene: assembly.fingerprint(),
            start: records.start(),
            state: engine.save(),
            sleepers: Some(engine.sleepers()),
            seen,
            observers: Some(assembly.observers()),
            parts: Some(assembly.kinds()),
        };
        output::write(file, checkpoint.text().as_bytes())?;
    }
    let note = noted(format!("{method}, step {} s", six_digits(assembly.run.step)), arguments);
    let mut warnings = engine.warnings();
    warnings.append(&mut passed);
    if assembly.has_idle_gravity() {
        warnings.push(
            "`gravity` acts on no part: a mechanism keeps that of its model, whose parameters `set` changes"
                .to_owned(),
        );
    }
    warnings.extend(from.iter().flat_map(|from| changed(from, assembly, &method)));
    let sleepers = from.as_ref().and_then(|from| from.sleepers);
    if let Some(saved) = sleepers.filter(|saved| *saved != engine.sleepers()) {
        let with = if saved == 0 { "without" } else { "with" };
        warnings.push(format!(
            "the checkpoint was saved {with} run.sleep, unlike this run: all parts were awake when it went on"
        ));
    }
    let method = if arguments.scalar == ScalarKind::F32 { method + ", in f32" } else { method };
    let (mut kept, film) = records.finish(arguments, &note, &events)?;
    engine.pivots().into_iter().for_each(|(part, pivot)| kept.health.pivot(Some(part), pivot));
    if let Some((part, t)) = engine.passed([assembly.run.seconds, assembly.run.step]) {
        kept.health.passed_over(Some(part), t);
    }
    Ok(Done { method, events, film, warnings, kept })
}

/// The columns that count what presses, where laws locate touches.
fn pressing_points(assembly: &Assembly, columns: &[Column]) -> Vec<usize> {
    let is_located = assembly.contacts.iter().any(|contact| matches!(contact.law, Law::Located(_)));
    (0..columns.len()).filter(|n| is_located && columns[*n].unit == "points").collect()
}

/// Warnings of what is not as it was when a checkpoint was saved.
fn changed(from: &Checkpoint, assembly: &Assembly, method: &str) -> Vec<String> {
    let mut warnings = Vec::new();
    if !from.scene.is_empty() && from.scene != assembly.fingerprint() {
        warnings.push(
            "the checkpoint was saved from another text of the scene or with other settings: the motion before it is not \
             that of this scene"
                .to_owned(),
        );
    }
    if !from.method.is_empty() && from.method != name(method) {
        warnings.push(format!(
            "the checkpoint was reached by the method {}, the run goes on with {}: it is no run of either alone",
            from.method,
            name(method)
        ));
    }
    warnings
}

/// The name of a method, without what `Engine::method` says of it.
fn name(method: &str) -> &str {
    method.split([',', ':']).next().unwrap_or_default()
}

/// Refuses `--save` for a run that ends within a step: a resumed run would go on from elsewhere.
fn ends_with_a_step(assembly: &Assembly, file: &str) -> Result<(), Failure> {
    if assembly.run.length(assembly.run.steps().max(1)) == assembly.run.step {
        return Ok(());
    }
    let message = "the run ends within a step; expected --seconds to be a whole number of steps";
    Err(Failure::Wrong(format!("--save {file}: {message}")))
}

/// Reads what `--save` wrote.
fn checkpoint(file: &str) -> Result<Checkpoint, Failure> {
    let text = input::text(file).map_err(|e| Failure::Wrong(format!("--resume {file}: {e}")))?;
    Checkpoint::read(&text).ok_or_else(|| {
        Failure::Wrong(format!(
            "--resume {file}: expected what `run --save` wrote for the same scene and step"
        ))
    })
}

impl Done {
    fn report(
        &self,
        arguments: &Arguments,
        assembly: &Assembly,
        findings: &[String],
        elapsed: f64,
    ) -> String {
        if arguments.json {
            return self.json(assembly, findings, elapsed);
        }
        let mut text = format!(
            "{}: {}, {} s in {}, {elapsed:.2} s\nmethod {}\n",
            assembly.title,
            count(assembly.parts.len(), "part"),
            assembly.run.seconds,
            count(assembly.run.steps(), "step"),
            self.method,
        );
        let events = told(&self.events, assembly);
        for (time, words) in events.iter().take(TOLD) {
            let _ = writeln!(text, "{time:12.6} s  {words}");
        }
        if events.len() > TOLD {
            let _ = writeln!(text, "{}{} more; --json lists all", " ".repeat(16), events.len() - TOLD);
        }
        let _ = writeln!(
            text,
            "energy: {:.6e} J at the start, {:.6e} J at the end, largest imbalance {:.1e} J",
            self.kept.total[0], self.kept.total[1], self.kept.imbalance
        );
        text + &self.kept.accounts.as_ref().map(Closed::text).unwrap_or_default()
    }

    fn json(&self, assembly: &Assembly, findings: &[String], elapsed: f64) -> String {
        let event = |event: &Event| {
            format!(
                "{{\"time\": {}, \"parts\": [{}, {}], \"points\": {}, \"approach\": {}, \"impulse\": {}}}",
                json_number(event.time),
                json_string(&assembly.parts[event.parts[0]].name),
                json_string(&assembly.parts[event.parts[1]].name),
                event.points,
                json_number(event.approach),
                json_number(event.impulse)
            )
        };
        let events: Vec<String> = self.events.iter().map(event).collect();
        let last =
            json_object(self.kept.names.iter().map(String::as_str).zip(self.kept.last.iter().copied()));
        let accounts = self.kept.accounts.as_ref().map(|own| format!(", \"accounts\": {}", own.json()));
        let accounts = accounts.unwrap_or_default();
        format!(
            "{{\"world\": {}, \"parts\": {}, \"method\": {}, \"seconds\": {}, \"steps\": {}, \"rows\": {}, \
             \"events\": [{}], \"total_at_start\": {}, \"total\": {}, \"imbalance\": {}, \"elapsed\": {}, \
             \"warnings\": {}, \"last\": {last}{accounts}}}\n",
            json_string(&assembly.title),
            assembly.parts.len(),
            json_string(&self.method),
            json_number(assembly.run.seconds),
            assembly.run.steps(),
            self.kept.rows,
            events.join(", "),
            json_number(self.kept.total[0]),
            json_number(self.kept.total[1]),
            json_number(self.kept.imbalance),
            json_number(elapsed),
            serde_json::Value::from(findings.to_vec()),
        )
    }
}
