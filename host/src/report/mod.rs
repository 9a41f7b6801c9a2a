//! `smartbed report`: speed against error, for every scene and mechanism, method, step and scalar.
//!
//! Subjects ([`subject`]: [`body`], [`mechanism`], [`world`]) get a [`mod@reference`], are run over a ladder of steps
//! ([`plan`], [`measure`]) and become points ([`point`]), of which the [`front`] is marked; [`order`]s are observed,
//! costs are measured on the [`chip`] and listed in a [`sheet`], other simulators are compared ([`peers`]). The
//! renderings use only points: [`markdown`], [`csv`], [`json`], [`work_precision`] plots, one [`page`].

pub mod body;
pub mod chip;
pub mod clock;
pub mod closed_form;
pub mod csv;
pub mod front;
pub mod json;
pub mod laws;
pub mod markdown;
pub mod measure;
pub mod mechanism;
pub mod open;
pub mod order;
pub mod page;
pub mod peers;
pub mod pick;
pub mod plan;
pub mod point;
pub mod reference;
pub mod sheet;
mod sheet_body;
mod sheet_mechanism;
mod sheet_table;
pub mod subject;
pub mod work_precision;
pub mod world;

use crate::engine::{EngineKind, ScalarKind};
use crate::failure::Failure;
use crate::input;
use crate::model_argument;
use crate::output;
use crate::plot::svg;
use crate::progress::Progress;
use crate::suggest;
use chip::Chip;
use plan::Plan;
use point::{Control, Extras, Report, Section, Table};
use smartbed_codegen::words::count;
use std::path::Path;
use std::time::Duration;
use subject::{Kind, Method, Subject};

/// Images for the chip are built until so much time has passed since the report's begin.
const CHIP_TIME: Duration = Duration::from_secs(1080);

/// Measure computing time against error of all methods: tables, plots, one HTML page.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Examples:
  cargo smartbed report --quick
  cargo smartbed report single_spring tile --out target/report
  cargo smartbed report single_spring --seconds 3 --method verlet --step 1e-4 --scalar f64

The last example measures one row of a table again. The command writes report.md, report.csv,
report.json, report.html and one plot for each scene or mechanism (SVG). docs/report.md explains
the numbers.")]
pub struct Arguments {
    /// Scenes and mechanisms: paths, or names under models/ [default: all that are shipped].
    pub subjects: Vec<String>,
    /// Take about a minute instead of some ten: fewer steps, shorter runs, mechanisms interpreted, no costs on the
    /// chip.
    #[arg(long)]
    pub quick: bool,
    /// Folder for the files; it is made if it does not exist.
    #[arg(long, value_name = "DIR", default_value = "target/report")]
    pub out: String,
    /// Simulated time in s [default: the file's, shortened to the time over which two reference solutions agree].
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    pub seconds: Option<f64>,
    /// Measure only this method.
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Measure only this step in s, with methods of fixed step. Not with --tolerance.
    #[arg(long, allow_negative_numbers = true, value_name = "H", conflicts_with = "tolerance")]
    pub step: Option<f64>,
    /// Measure only this error allowed per step, with adaptive methods. Not with --step.
    #[arg(long, allow_negative_numbers = true, value_name = "E")]
    pub tolerance: Option<f64>,
    /// Measure only this number type [default: both].
    #[arg(long, value_enum)]
    pub scalar: Option<ScalarKind>,
    /// How the equations of mechanisms are evaluated [default: compiled; interpreter with --quick, --step or
    /// --tolerance].
    #[arg(long, value_enum)]
    pub engine: Option<EngineKind>,
    /// Do not measure costs on the microcontroller.
    #[arg(long)]
    pub no_chip: bool,
    /// Add points and tables of other simulators from this file, as `tests/peers/motions.py` writes them; may be
    /// repeated.
    #[arg(long, value_name = "FILE.json")]
    pub points: Vec<String>,
    /// Also write the summary as DIR/PROCESSOR.md, and the points that no other point beats in both time and error as
    /// DIR/PROCESSOR.json.
    #[arg(long, value_name = "DIR")]
    pub results: Option<String>,
    /// Print the report as JSON.
    #[arg(long)]
    pub json: bool,
}

impl Arguments {
    /// Is only one row asked for?
    fn is_row(&self) -> bool {
        self.step.is_some() || self.tolerance.is_some()
    }

    /// Source of the costs on the chip, if `elapsed` seconds of the report have passed.
    fn chip(&self, elapsed: f64) -> Chip {
        match (self.quick, self.no_chip, self.is_row()) {
            (true, ..) => Chip::none("left out by --quick"),
            (_, true, _) => Chip::none("left out by --no-chip"),
            (.., true) => Chip::none("not of a single row"),
            _ => Chip::new(CHIP_TIME.saturating_sub(Duration::from_secs_f64(elapsed))),
        }
    }

    /// The report as a command line.
    fn command(&self) -> String {
        let mut words = vec!["cargo smartbed report".to_owned()];
        words.extend(self.subjects.iter().cloned());
        let mut option = |name: &str, value: Option<String>| {
            words.extend(value.map(|v| format!("--{name} {v}")));
        };
        option("seconds", self.seconds.map(|x| x.to_string()));
        option("method", self.method.clone());
        option("step", self.step.map(|x| format!("{x:e}")));
        option("tolerance", self.tolerance.map(|x| format!("{x:e}")));
        option("scalar", self.scalar.map(|s| measure::name_of(s).to_owned()));
        self.points.iter().for_each(|p| option("points", Some(p.clone())));
        words.extend(self.results.as_ref().map(|f| format!("--results {f}")));
        let flags = [("--quick", self.quick), ("--no-chip", self.no_chip)];
        words.extend(flags.into_iter().filter(|f| f.1).map(|f| f.0.to_owned()));
        words.join(" ")
    }

    fn plan(&self) -> Result<Plan, Failure> {
        let positive = |name: &str, value: Option<f64>| match value {
            Some(x) if !(x > 0.0 && x.is_finite()) => {
                Err(Failure::Wrong(format!("--{name} {x}: expected a number above 0")))
            }
            _ => Ok(value),
        };
        positive("seconds", self.seconds)?;
        let step = positive("step", self.step)?.map(Control::Step);
        let control = step.or(positive("tolerance", self.tolerance)?.map(Control::Tolerance));
        let plan = if self.quick { Plan::quick() } else { Plan::full() };
        let single = if control.is_some() { EngineKind::Interpreter } else { plan.engine };
        let engine = self.engine.unwrap_or(single);
        Ok(Plan { method: self.method.clone(), control, scalar: self.scalar, engine, ..plan })
    }
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong scene, model or setting; status 2 without a compiler for `--engine compiled`.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let report = make(arguments)?;
    write(&report, Path::new(&arguments.out))?;
    if let Some(folder) = &arguments.results {
        write_results(&report, Path::new(folder))?;
    }
    let text = if arguments.json {
        json::text(&report)
    } else if arguments.is_row() {
        markdown::text(&report)
    } else {
        let points: usize = report.sections.iter().map(|s| s.points.len()).sum();
        let (out, subjects) = (&arguments.out, report.sections.len());
        format!(
            "{}, {}, {:.0} s\nwritten to {out}: report.html, report.md, report.csv, report.json, {}\n",
            count(subjects, "subject"),
            count(points, "point"),
            report.elapsed,
            count(subjects, "plot")
        )
    };
    output::print(&text)
}

/// Measures everything asked for; shows progress on standard error.
///
/// # Errors
/// As [`run`].
pub fn make(arguments: &Arguments) -> Result<Report, Failure> {
    let plan = arguments.plan()?;
    let names =
        if arguments.subjects.is_empty() { model_argument::all() } else { arguments.subjects.clone() };
    // All subjects are read first, so that errors are reported before anything is measured.
    let mut subjects = Vec::with_capacity(names.len());
    for name in &names {
        let subject = open::open(name, plan.engine)?;
        check_method(subject.as_ref(), &plan)?;
        subjects.push(subject);
    }
    let mut others = Vec::new();
    for file in &arguments.points {
        let text = input::text(file).map_err(|e| Failure::Wrong(format!("--points {file}: {e}")))?;
        others.push(Extras::read(file, &text)?);
    }
    let mut progress = Progress::new("report");
    let begin = clock::now();
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
    let mut failed = Vec::new();
    for (n, subject) in subjects.iter().enumerate() {
        output::say(&format!(
            "report: {} ({} of {}, {:.0} s)",
            subject.name(),
            n + 1,
            names.len(),
            progress.seconds()
        ));
        let plan = plan.hurried(progress.seconds(), clock::now() - begin, names.len() - n);
        // Over the same time as other simulators' points, if they state it, except in the quick report.
        let told = others.iter().find_map(|extras: &Extras| extras.seconds(subject.name()));
        let seconds = arguments.seconds.or(told.filter(|_| !arguments.quick));
        match section(subject.as_ref(), &plan, seconds) {
            Ok(section) => report.sections.push(section),
            // If there are several subjects, one that cannot be measured is reported and skipped.
            Err(why) if names.len() > 1 => {
                output::say(&format!("warning: not measured: {why}"));
                failed.push(vec![subject.name().to_owned(), why.to_string()]);
            }
            Err(why) => return Err(why),
        }
        progress.at((n + 1) as f64 / names.len() as f64);
    }
    // Subjects that could not be measured are left out from here on.
    subjects.retain(|s| report.sections.iter().any(|section| section.name == s.name()));
    if subjects.is_empty() {
        let why: Vec<String> = failed.iter().map(|row| row.join(": ")).collect();
        return Err(Failure::Wrong(format!("nothing could be measured: {}", why.join("; "))));
    }
    if !failed.is_empty() {
        let (title, columns) = ("Not measured".to_owned(), ["subject", "why"].map(str::to_owned).to_vec());
        report.tables.push(Table { title, columns, rows: failed, command: report.command.clone() });
    }
    let kinds = [
        ("mechanisms", Kind::Mechanism, true),
        ("smooth scenes", Kind::Body, true),
        ("scenes with touches", Kind::Body, false),
        ("smooth worlds", Kind::World, true),
        ("worlds with contacts", Kind::World, false),
    ];
    for (title, kind, smooth) in kinds {
        let orders = |s: &dyn Subject| {
            let section = report.sections.iter().find(|section| section.name == s.name())?;
            Some((section.name.clone(), order::observe(section, &s.methods())))
        };
        let of_kind = subjects.iter().filter(|s| (s.kind(), s.is_smooth()) == (kind, smooth));
        let rows: Vec<_> = of_kind.filter_map(|s| orders(s.as_ref())).collect();
        if !rows.is_empty() {
            let title = format!("Observed orders, {title} (nominal in brackets)");
            report.tables.push(order::table(&title, &rows, &report.command));
        }
    }
    if !arguments.is_row() && subjects.iter().any(|s| s.kind() == Kind::Body) {
        let observed = laws::observe().map_err(Failure::Wrong)?;
        report.tables.push(laws::table(&observed, &report.command));
    }
    let mut chip = arguments.chip(progress.seconds());
    if !arguments.is_row() {
        let sheets = sheet_table::table(&subjects, &mut chip, &report.command).map_err(Failure::Wrong)?;
        if !sheets.rows.is_empty() {
            report.tables.push(sheets);
        }
        chip.add(&subjects, &mut report.sections);
    }
    report.chip = match chip.lacking() {
        None => "instructions counted in the emulator, cycles by model".to_owned(),
        Some(why) if report.sections.iter().any(|s| !s.chip.is_empty()) => format!("not all ({why})"),
        Some(why) => format!("none ({why})"),
    };
    others.into_iter().for_each(|extras| report.add(extras));
    report.sections.iter_mut().for_each(|s| front::mark(&mut s.points));
    if let Some(table) = peers::table(&report) {
        report.tables.insert(0, table);
    }
    peers::dominating(&report).iter().for_each(|line| output::say(&format!("a peer dominates: {line}")));
    report.elapsed = progress.seconds();
    Ok(report)
}

/// Refuses a method that the subject does not have, or a step for a method that takes a tolerance.
fn check_method(subject: &dyn Subject, plan: &Plan) -> Result<(), Failure> {
    let Some(name) = &plan.method else { return Ok(()) };
    match (check_name(subject, name)?.adaptive, plan.control) {
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
    if measured.points.is_empty() {
        let why = measured.notes.join("; ");
        return Err(wrong(format!("nothing could be measured: {why}")));
    }
    if let Some(warning) = seconds.is_none().then(|| reference::unexamined(&truth, simulated)).flatten() {
        output::say(&format!("warning: {}: {warning}", subject.name()));
        measured.notes.insert(0, warning);
    }
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
        graph: subject.graph(plan.reference).map_err(wrong)?,
    })
}

/// Writes all files into a folder.
///
/// # Errors
/// [`Failure::Wrong`] if one cannot be written.
pub fn write(report: &Report, folder: &Path) -> Result<(), Failure> {
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder.join("plots")).map_err(wrong)?;
    let put =
        |name: &str, text: &str| output::write(&folder.join(name).display().to_string(), text.as_bytes());
    put("report.md", &markdown::text(report))?;
    put("report.csv", &csv::text(report))?;
    put("report.json", &json::text(report))?;
    put("report.html", &page::text(report))?;
    let plots = plot_names(report.sections.iter().map(|s| s.name.as_str()));
    for (n, section) in report.sections.iter().enumerate() {
        if let Some(drawing) = work_precision::draw(section, work_precision::COSTS[0]) {
            put(&format!("plots/{}.svg", plots[n]), &svg::text(&drawing))?;
        }
    }
    Ok(())
}

/// Names of the plots' files, made unique: subjects may be named by paths, two of which may end alike.
fn plot_names<'a>(subjects: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for subject in subjects {
        let stem = Path::new(subject).file_stem().map_or_else(|| "plot".into(), |s| s.to_string_lossy());
        let plain = |c: char| if c.is_alphanumeric() || c == '_' || c == '-' { c } else { '_' };
        let name: String = stem.chars().map(plain).collect();
        let mut numbered = name.clone();
        for n in 2.. {
            if !names.contains(&numbered) {
                break;
            }
            numbered = format!("{name}-{n}");
        }
        names.push(numbered);
    }
    names
}

/// Writes the summary, the points of our own fronts and all those of other simulators, to files named after the
/// processor.
///
/// # Errors
/// [`Failure::Wrong`] if one cannot be written.
pub fn write_results(report: &Report, folder: &Path) -> Result<(), Failure> {
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder).map_err(wrong)?;
    let mut fronts = report.clone();
    // Our points that only a peer dominates are kept, so that the file shows them.
    fronts.sections.iter_mut().for_each(|section| {
        let ours: Vec<_> = section.points.iter().filter(|p| !p.is_peer).cloned().collect();
        section.points.retain(|p| p.is_peer || !ours.iter().any(|own| front::dominates(own, p)));
    });
    let put = |ending: &str, text: &str| {
        let file = folder.join(file_name(&report.machine)).with_extension(ending);
        output::write(&file.display().to_string(), text.as_bytes())
    };
    put("md", &markdown::results(report))?;
    put("json", &json::text(&fronts))
}

/// The name in lower case, without parts in brackets, words joined by hyphens.
fn file_name(machine: &str) -> String {
    let mut depth = 0_usize;
    let plain = machine.chars().filter(|c| {
        depth = if *c == '(' { depth + 1 } else { depth };
        let outside = depth == 0;
        depth = if *c == ')' { depth.saturating_sub(1) } else { depth };
        outside
    });
    let text: String =
        plain.map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { ' ' }).collect();
    text.split_whitespace().collect::<Vec<_>>().join("-")
}

/// The processor's name.
#[must_use]
pub fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find_map(|l| l.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::{file_name, plot_names};

    #[test]
    fn plots_stay_in_their_folder() {
        let subjects = ["tile", "../../tile.toml", "/tmp/a b.toml", "..", "sub/tile"];
        assert_eq!(plot_names(subjects.into_iter()), ["tile", "tile-2", "a_b", "plot", "tile-3"]);
    }

    #[test]
    fn a_processor_is_a_file_name() {
        assert_eq!(file_name("Intel(R) Xeon(R) Processor @ 2.10GHz"), "intel-xeon-processor-2-10ghz");
    }
}
