//! Runs a mechanism: derives, starts and simulates it; rows, plot, film and summary.

use super::arguments::Arguments;
use super::events::Events;
use super::outcome::{Outcome, ended_early, line, noted};
use super::settings::Settings;
use super::simulate::{self, Row, Setup, Summary, columns};
use super::start::start;
use crate::engine::{self, EngineScalar, ScalarKind};
use crate::failure::Failure;
use crate::number::{json_number, json_object, short};
use crate::observers::Observers;
use crate::output::Output;
use crate::plot::Recording;
use crate::plot::motion::{self, Motion};
use crate::plot::panels;
use crate::progress::{Progress, Waiting};
use crate::view::film::{Film, Series};
use crate::view::stage::Stage;
use crate::{csv, interrupt, model_argument, plot};
use smartbed_codegen::model::Model;
use smartbed_codegen::program;
use smartbed_codegen::words::count;
use std::fmt::Write as _;

/// Last values below this fraction of the largest of their unit are rounding.
const ROUNDING: f64 = 1e-12;

/// What was found before joins the findings.
pub(super) fn run(arguments: &Arguments, before: &[String]) -> Result<Outcome, Failure> {
    let clock = Progress::new("run");
    let model = model_argument::read(&arguments.model)?;
    let (model, settings) = Settings::new(&model, arguments)?;
    let model = &*model;
    let wrong = |e| model_argument::wrong(&e);
    let waiting = Waiting::deriving();
    let program = program::derive(model, &settings.choice).map_err(wrong)?;
    drop(waiting);
    model_argument::print_warnings(&program);
    let observers = Observers::derive(model, &settings.choice).map_err(wrong)?;
    let start = start(model, &program, &settings)?;
    let setup = Setup { program: &program, observers: &observers, settings: &settings, start: &start };
    let (summary, film) = match arguments.scalar {
        ScalarKind::F32 => record::<f32>(arguments, model, setup)?,
        ScalarKind::F64 => record::<f64>(arguments, model, setup)?,
    };
    let findings = [&summary.health.findings(), before].concat();
    let text = report(arguments, model, setup, (&summary, &findings), clock.seconds());
    Ok(Outcome { text, film, findings })
}

/// Simulates and writes what is asked for; returns the data of `--view`.
fn record<S: EngineScalar>(
    arguments: &Arguments,
    model: &Model,
    setup: Setup<'_>,
) -> Result<(Summary, Option<String>), Failure> {
    let engine = engine::new::<S>(arguments.engine, setup.program)?;
    let names = columns(setup.program, setup.observers);
    let mut csv = arguments.csv.as_deref().map(Output::open).transpose()?;
    if let Some(csv) = &mut csv {
        csv.write(&csv::header(&names))?;
    }
    let mut recording = arguments.plot.as_ref().map(|_| Recording::new(names.len()));
    let (series, shown) = series(model, &names);
    let mut film = arguments.view.as_ref().map(|_| Film::new(Stage::of_model(model), series));
    let mut events = Events::new(model, &names, &simulate::ranges(setup));
    let drawn = film.is_some() || recording.is_some();
    if csv.is_some() {
        interrupt::watch();
    }
    let mut rows = 0;
    let done = simulate::simulate(setup, engine, |row: &Row| {
        if let Some(csv) = &mut csv {
            csv.write(&line(&row.values))?;
        }
        if let Some(recording) = &mut recording {
            recording.push(&row.values);
        }
        if drawn {
            events.row(&row.values);
        }
        if let Some(film) = &mut film {
            film.push(row.values[0], &row.places, &[], shown.iter().map(|n| row.values[*n]));
        }
        rows += 1;
        Ok(())
    });
    let file = arguments.csv.as_deref().unwrap_or_default();
    let summary = match done {
        Ok(summary) => summary,
        Err(failure) => return Err(ended_early(failure, csv, rows, file)),
    };
    if let Some(csv) = csv {
        csv.finish()?;
    }
    if let (Some(file), Some(recording)) = (&arguments.plot, &recording) {
        let motion = Motion {
            model,
            names: &names,
            recording,
            note: &noted(setup.settings.note(), arguments),
            crossings: &events.crossings(),
            show: arguments.show.as_deref(),
            noise: arguments.scalar.noise(),
        };
        plot::write(file, &motion::draw(&motion)?)?;
    }
    let title = if model.doc.is_empty() { &model.name } else { &model.doc };
    let note = noted(setup.settings.note(), arguments);
    Ok((summary, film.map(|film| film.data(title, &note, &events.finish()))))
}

/// Curves that the page shows beside the motion, and their indices in a row.
fn series(model: &Model, names: &[String]) -> (Vec<Series>, Vec<usize>) {
    let columns = motion::columns(model, 1.0).into_iter();
    let curves = columns.map(|c| (c.name, panels::label(&c.unit), c.factor));
    let energies = motion::ENERGIES.into_iter().map(|name| (name.to_owned(), panels::label("J"), 1.0));
    let accounts = ["imbalance", "damping", "actuator", "external", "drive"];
    let accounts = accounts.map(|name| (name.to_owned(), "ledger".to_owned(), 1.0));
    let all = curves.chain(energies).chain(accounts);
    let shown = all.filter_map(|(name, group, factor)| {
        let index = names.iter().position(|n| *n == name)?;
        Some((Series { name, group, factor }, index))
    });
    shown.unzip()
}

/// The summary, as text or JSON.
fn report(
    arguments: &Arguments,
    model: &Model,
    setup: Setup<'_>,
    (summary, findings): (&Summary, &[String]),
    elapsed: f64,
) -> String {
    let names = columns(setup.program, setup.observers);
    let (settings, method) = (setup.settings, setup.settings.method.name());
    if arguments.json {
        let last = json_object(names.iter().map(String::as_str).zip(summary.last.iter().copied()));
        return format!(
            "{{\"model\": {}, \"method\": \"{method}\", \"seconds\": {}, \"steps\": {}, \"evaluations\": {}, \
             \"rows\": {}, \"worst_pivot\": {}, \"residual_before_projection\": {}, \"imbalance\": {}, \
             \"elapsed\": {}, \"warnings\": {}, \"last\": {last}}}\n",
            crate::number::json_string(&setup.program.name),
            json_number(settings.seconds),
            summary.steps,
            summary.evaluations,
            summary.rows,
            json_number(summary.pivot),
            json_number(summary.residual),
            json_number(summary.imbalance),
            json_number(elapsed),
            serde_json::Value::from(findings),
        );
    }
    let mut text = format!(
        "{}: {} s in {} ({method}), {}, {elapsed:.2} s\n",
        setup.program.name,
        settings.seconds,
        count(summary.steps, "step"),
        count(summary.evaluations, "evaluation")
    );
    if !setup.program.correction.is_empty() {
        let _ = writeln!(
            text,
            "constraints: worst pivot {:.3e} of nominal, largest residual before projection {:.1e}",
            summary.pivot, summary.residual
        );
    }
    let _ = writeln!(text, "energy: largest imbalance of the ledger {:.1e} J", summary.imbalance);
    let shown = 1 + setup.program.q.len() + setup.observers.closed.len() + setup.program.speeds.len();
    text + &last_row(model, settings.seconds, &names[..shown.min(names.len())], &summary.last)
}

/// Time, coordinates and speeds at the end, in the model's units; values that are rounding are shown as 0.
fn last_row(model: &Model, seconds: f64, names: &[String], last: &[f64]) -> String {
    let columns = motion::columns(model, seconds);
    let of = |name: &String, value: &f64| match columns.iter().find(|column| column.name == *name) {
        Some(column) => (value / column.factor, column.unit.as_str(), column.natural / column.factor),
        None if name == "t" => (*value, "s", 0.0),
        None => (*value, "", 0.0),
    };
    let rows: Vec<(f64, &str, f64)> = names.iter().zip(last).map(|(name, value)| of(name, value)).collect();
    let size = |unit: &str| {
        let alike = rows.iter().filter(|(_, other, _)| *other == unit);
        alike.map(|(value, _, natural)| value.abs().max(*natural)).fold(0.0, f64::max)
    };
    let width = names.iter().map(String::len).max().unwrap_or(0);
    let mut text = String::new();
    for (name, (value, unit, _)) in names.iter().zip(&rows) {
        let told = if value.abs() <= ROUNDING * size(unit) { 0.0 } else { *value };
        let unit = if *unit == "1" { "" } else { unit };
        let line = format!("  {name:width$} {:>16} {unit}", short(told));
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}
