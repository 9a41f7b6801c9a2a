//! Collects a report: each subject's points, then the tables that compare subjects, methods and other simulators.
//!
//! In: the arguments. Out: the report. Whatever is read is read first, so that mistakes are told before anything is
//! measured; of several subjects, one that cannot be measured is named in a table and skipped.

use super::arguments::Arguments;
use super::chip::Chip;
use super::files::machine;
use super::plan::Plan;
use super::point::{Control, Extras, Report, Section, Table};
use super::subject::{Exchanged, Kind, Method, Subject};
use super::{clock, exchange, front, laws, measure, open, order, peers, reference, sheet_table};
use crate::engine::EngineKind;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::{input, model_argument, output, suggest};

/// Kinds of subjects whose observed orders share a table: its title, their kind, whether they are smooth.
const GROUPS: [(&str, Kind, bool); 5] = [
    ("mechanisms", Kind::Mechanism, true),
    ("smooth scenes", Kind::Body, true),
    ("scenes with touches", Kind::Body, false),
    ("smooth worlds", Kind::World, true),
    ("worlds with contacts", Kind::World, false),
];

/// Measures everything asked for; shows progress on standard error.
///
/// # Errors
/// As [`super::run`].
pub fn make(arguments: &Arguments) -> Result<Report, Failure> {
    let plan = arguments.plan()?;
    let mut subjects = subjects(arguments, &plan)?;
    let others = others(arguments)?;
    let mut progress = Progress::new("report");
    let mut report = Report {
        machine: machine(),
        command: arguments.command(),
        engine: match plan.engine {
            EngineKind::Interpreter => "interpreter".to_owned(),
            EngineKind::Compiled => "compiled Rust".to_owned(),
        },
        chip: String::new(),
        elapsed: 0.0,
        sections: Vec::new(),
        tables: Vec::new(),
    };
    let failed = sections(arguments, (&plan, &others), &subjects, &mut report, &mut progress)?;
    // Subjects that could not be measured are left out from here on.
    subjects.retain(|s| report.sections.iter().any(|section| section.name == s.name()));
    report.tables.extend(not_measured(&subjects, failed, &report.command)?);
    let orders: Vec<_> = GROUPS.iter().filter_map(|group| orders(&subjects, &report, *group)).collect();
    report.tables.extend(orders);
    if !arguments.is_row() && subjects.iter().any(|s| s.kind() == Kind::Body) {
        let observed = laws::observe().map_err(Failure::Wrong)?;
        report.tables.push(laws::table(&observed, &report.command));
    }
    let mut chip = arguments.chip(progress.seconds());
    if !arguments.is_row() {
        let sheets = sheet_table::table(&subjects, &mut chip, &report.command).map_err(Failure::Wrong)?;
        report.tables.extend(Some(sheets).filter(|sheets| !sheets.rows.is_empty()));
        chip.add(&subjects, &mut report.sections);
    }
    report.chip = costs_on_chip(&chip, &report);
    compare(&mut report, others);
    report.elapsed = progress.seconds();
    Ok(report)
}

/// Reads all subjects, and refuses a method that one of them does not have.
fn subjects(arguments: &Arguments, plan: &Plan) -> Result<Vec<Box<dyn Subject>>, Failure> {
    let names =
        if arguments.subjects.is_empty() { model_argument::all() } else { arguments.subjects.clone() };
    let read = names.iter().map(|name| {
        let subject = open::open(name, plan.engine)?;
        check_method(subject.as_ref(), plan)?;
        Ok(subject)
    });
    read.collect()
}

/// Reads the points of other simulators.
fn others(arguments: &Arguments) -> Result<Vec<Extras>, Failure> {
    let read = arguments.points.iter().map(|file| {
        let text = input::text(file).map_err(|e| Failure::Wrong(format!("--points {file}: {e}")))?;
        Extras::read(file, &text)
    });
    read.collect()
}

/// Measures the subjects one after the other; returns the rows of those that cannot be measured: name, reason.
fn sections(
    arguments: &Arguments,
    (plan, others): (&Plan, &[Extras]),
    subjects: &[Box<dyn Subject>],
    report: &mut Report,
    progress: &mut Progress,
) -> Result<Vec<Vec<String>>, Failure> {
    let (begin, count, mut failed) = (clock::now(), subjects.len(), Vec::new());
    for (n, subject) in subjects.iter().enumerate() {
        let elapsed = progress.seconds();
        output::say(&format!("report: {} ({} of {count}, {elapsed:.0} s)", subject.name(), n + 1));
        let plan = plan.hurried(elapsed, clock::now() - begin, count - n);
        // Over the same time as other simulators' points, if they state it, except in the quick report.
        let told = others.iter().find_map(|extras| extras.seconds(subject.name()));
        let seconds = arguments.seconds.or(told.filter(|_| !arguments.quick));
        match section(subject.as_ref(), &plan, seconds) {
            Ok(section) => report.sections.push(section),
            Err(why) if count > 1 => {
                output::say(&format!("warning: not measured: {why}"));
                failed.push(vec![subject.name().to_owned(), why.to_string()]);
            }
            Err(why) => return Err(why),
        }
        progress.at((n + 1) as f64 / count as f64);
    }
    Ok(failed)
}

/// The table of subjects that could not be measured, if there are any.
///
/// # Errors
/// [`Failure::Wrong`] if no subject is left.
fn not_measured(
    left: &[Box<dyn Subject>],
    rows: Vec<Vec<String>>,
    command: &str,
) -> Result<Option<Table>, Failure> {
    if left.is_empty() {
        let why: Vec<String> = rows.iter().map(|row| row.join(": ")).collect();
        return Err(Failure::Wrong(format!("nothing could be measured: {}", why.join("; "))));
    }
    let (title, columns) = ("Not measured".to_owned(), ["subject", "why"].map(str::to_owned).to_vec());
    let table = Table { title, columns, rows, command: command.to_owned() };
    Ok(Some(table).filter(|table| !table.rows.is_empty()))
}

/// The table of orders observed in a group of subjects, if there are any.
fn orders(
    subjects: &[Box<dyn Subject>],
    report: &Report,
    (title, kind, smooth): (&str, Kind, bool),
) -> Option<Table> {
    let group = subjects.iter().filter(|s| (s.kind(), s.is_smooth()) == (kind, smooth));
    let rows = group.filter_map(|subject| {
        let section = report.sections.iter().find(|section| section.name == subject.name())?;
        Some((section.name.clone(), order::observe(section, &subject.methods())))
    });
    let rows: Vec<_> = rows.collect();
    let title = format!("Observed orders, {title} (nominal in brackets)");
    (!rows.is_empty()).then(|| order::table(&title, &rows, &report.command))
}

/// How the costs on the chip were found, or why they are missing.
fn costs_on_chip(chip: &Chip, report: &Report) -> String {
    match chip.lacking() {
        None => "instructions counted in the emulator, cycles by model".to_owned(),
        Some(why) if report.sections.iter().any(|s| !s.chip.is_empty()) => format!("not all ({why})"),
        Some(why) => format!("none ({why})"),
    }
}

/// Adds other simulators' points, marks the fronts and says which of these points dominate ours.
fn compare(report: &mut Report, others: Vec<Extras>) {
    for unknown in others.into_iter().map(|extras| report.add(extras)).filter(|unknown| !unknown.is_empty()) {
        let names: Vec<String> = unknown.into_iter().map(|name| format!("`{name}`")).collect();
        output::say(&format!("note: --points: left out, since not in this report: {}", names.join(", ")));
    }
    report.sections.iter_mut().for_each(|s| front::mark(&mut s.points));
    if let Some(table) = peers::table(report) {
        report.tables.insert(0, table);
    }
    peers::dominating(report).iter().for_each(|line| output::say(&format!("a peer dominates: {line}")));
}

/// Refuses a method that the subject does not have, or a step for a method that takes a tolerance.
fn check_method(subject: &dyn Subject, plan: &Plan) -> Result<(), Failure> {
    let Some(name) = &plan.method else { return Ok(()) };
    let method = check_name(subject, name).or_else(|unknown| match subject.exchanged() {
        Some(Exchanged { subject: Ok(other), .. }) => check_name(other.as_ref(), name).map_err(|_| unknown),
        _ => Err(unknown),
    })?;
    match (method.adaptive, plan.control) {
        (true, Some(Control::Step(_))) => {
            Err(Failure::Wrong(format!("--step: {name} chooses its own steps; expected --tolerance")))
        }
        (false, Some(Control::Tolerance(_))) => {
            Err(Failure::Wrong(format!("--tolerance: {name} takes fixed steps; expected --step")))
        }
        _ => Ok(()),
    }
}

/// The subject's method of this name.
///
/// # Errors
/// [`Failure::Wrong`], with a suggestion, if it has none.
pub fn check_name(subject: &dyn Subject, name: &str) -> Result<Method, Failure> {
    let methods = subject.methods();
    let help = suggest::help(name, methods.iter().map(|m| m.name.as_str()));
    let found = methods.into_iter().find(|m| m.name == name);
    found.ok_or_else(|| {
        Failure::Wrong(format!("--method {name}: `{}` has no such method{help}", subject.name()))
    })
}

/// Measures one subject; if no time is given, for as long as its references agree.
///
/// # Errors
/// [`Failure::Wrong`] if it cannot be run.
pub fn section(subject: &dyn Subject, plan: &Plan, seconds: Option<f64>) -> Result<Section, Failure> {
    let wrong = |e: String| Failure::Wrong(format!("{}: {e}", subject.name()));
    let simulated = seconds.unwrap_or(plan.seconds(subject));
    let truth = reference::make(subject, simulated, seconds.is_none(), plan.reference).map_err(wrong)?;
    let mut measured = measure::measure(subject, &truth, plan);
    exchange::measure(subject, &truth, plan, &mut measured);
    if measured.points.is_empty() {
        let why = measured.notes.join("; ");
        return Err(wrong(format!("nothing could be measured: {why}")));
    }
    if let Some(warning) = seconds.is_none().then(|| reference::unexamined(&truth, simulated)).flatten() {
        output::say(&format!("warning: {}: {warning}", subject.name()));
        measured.notes.insert(0, warning);
    }
    // The subject's own step may be too long for its own method, though it has been measured with others.
    let graph = subject.graph(plan.reference).unwrap_or_else(|why| {
        measured.notes.push(format!("no graph of the motion: {why}"));
        String::new()
    });
    Ok(Section {
        name: subject.name().to_owned(),
        title: subject.title(),
        seconds: truth.seconds,
        asked: subject.seconds(),
        extent: measured.extent,
        reference: truth.reference,
        points: measured.points,
        notes: measured.notes,
        chip: Vec::new(),
        graph,
    })
}
