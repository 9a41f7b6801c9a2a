//! Picks method and step for a given error or computing time, from curves measured at once.
//!
//! The subject's own motion is run with every method and a ladder of steps, as in a report, within some seconds. The
//! cost of an error depends on the motion, so that curves of another scene or machine would be a guess.

use super::markdown::duration;
use super::measure::{Measured, measure};
use super::plan::Plan;
use super::point::{Control, Point};
use super::reference::{self, Truth};
use super::subject::{Kind, Subject};
use super::whole::{self, Whole};
use crate::engine::{EngineKind, ScalarKind};
use crate::failure::Failure;
use smartbed_codegen::words::count;
use std::time::Duration;

/// The aim of the choice.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Aim {
    /// Largest error of a coordinate (m or rad).
    Error(f64),
    /// Most computing time per simulated second (ns).
    Budget(f64),
}

/// What was picked.
#[derive(Clone, PartialEq, Debug)]
pub struct Pick {
    /// Method.
    pub method: String,
    /// Its step or tolerance.
    pub control: Control,
    /// The choice and its reason, with numbers.
    pub text: String,
    /// What was not examined.
    pub warning: Option<String>,
}

/// Time limits of the calibration: for one run, for all runs.
const RUN: Duration = Duration::from_millis(80);
const ALL: Duration = Duration::from_millis(3000);
/// Time limit for the runs over the whole time, where the reference covers only its start.
const WHOLE: Duration = Duration::from_millis(2000);
/// Factor of these limits for a world, a step of which costs as much as many steps of one body.
const WORLD: u32 = 10;
/// Time limit for the reference.
const REFERENCE: Duration = Duration::from_secs(6);
/// Most work of a calibration, in springs times simulated seconds.
const WORK: f64 = 50.0;

/// The plan of the calibration runs.
fn plan(kind: Kind, rows: f64, (method, scalar, engine): (Option<&str>, ScalarKind, EngineKind)) -> Plan {
    let times = if kind == Kind::World { WORLD } else { 1 };
    Plan {
        run: times * RUN,
        subject: times * ALL,
        whole: times * WHOLE,
        reference: REFERENCE,
        work: WORK,
        method: method.map(str::to_owned),
        scalar: Some(scalar),
        engine,
        rows: Some(rows),
        ..Plan::full()
    }
}

/// Picks among all methods, or the steps of one, for a run with so much time between rows (s).
///
/// # Errors
/// [`Failure::Wrong`] if no measured point meets the aim; it names the nearest one.
pub fn pick(
    subject: &dyn Subject,
    aim: Aim,
    rows: f64,
    how: (Option<&str>, ScalarKind, EngineKind),
) -> Result<Pick, Failure> {
    let mut plan = plan(subject.kind(), rows, how);
    if let Aim::Error(e) = aim {
        plan.enough = e;
    }
    let wrong = |e: String| Failure::Wrong(format!("calibration of {}: {e}", subject.name()));
    let truth = reference::make(subject, plan.seconds(subject), true, plan.reference).map_err(wrong)?;
    let Measured { points, notes, .. } = measure(subject, &truth, &plan);
    let (fits, goal): (Vec<&Point>, String) = match aim {
        Aim::Error(e) => (points.iter().filter(|p| p.error <= e).collect(), format!("--error {e:e}")),
        Aim::Budget(t) => {
            (points.iter().filter(|p| p.nanoseconds <= t).collect(), format!("--budget {}", duration(t)))
        }
    };
    let better = |a: &&Point, b: &&Point| match aim {
        Aim::Error(_) => a.nanoseconds.total_cmp(&b.nanoseconds),
        Aim::Budget(_) => a.error.total_cmp(&b.error),
    };
    let Some(best) = fits.iter().copied().min_by(better) else {
        return Err(Failure::Wrong(format!("{goal}: {}", nearest(&points, &notes, (aim, subject.kind())))));
    };
    let other = fits.iter().copied().filter(|p| p.method != best.method).min_by(better);
    let (method, control) = (best.method.clone(), taken(subject, best, truth.seconds));
    let Some(whole) = over_all(subject, &truth, best, how.1, &plan, aim) else {
        let text = explain(subject, &truth, &goal, (best, other), &points);
        return Ok(Pick { method, control, text, warning: reference::unexamined(&truth, subject.seconds()) });
    };
    let text = explain_whole(subject, &truth, &goal, (best, &whole), points.len());
    let warning = unkept(&whole, aim, (subject.seconds(), &plan));
    Ok(Pick { method, control: whole.control, text, warning })
}

/// The control of a run over so many seconds, with the step that it took: controllers ask for parts of the scene's own.
fn taken(subject: &dyn Subject, point: &Point, seconds: f64) -> Control {
    match point.control.unwrap_or(Control::Step(subject.coarsest_step(&point.method))) {
        Control::Step(h) => Control::Step(subject.step(h, seconds)),
        tolerance @ Control::Tolerance(_) => tolerance,
    }
}

/// What the whole run shows of a pick, where the reference covers only its start: for an error a step that keeps it,
/// for a budget the error of the step that was picked.
fn over_all(
    subject: &dyn Subject,
    truth: &Truth,
    best: &Point,
    scalar: ScalarKind,
    plan: &Plan,
    aim: Aim,
) -> Option<Whole> {
    let enough = match aim {
        Aim::Error(e) => e,
        Aim::Budget(_) => f64::INFINITY,
    };
    let method = subject.methods().into_iter().find(|method| method.name == best.method)?;
    let is_cut = truth.seconds < subject.seconds();
    let plan = Plan { enough, ..plan.clone() };
    let first = taken(subject, best, subject.seconds());
    is_cut.then(|| whole::judge(subject, truth.coordinates(), (&method, first, scalar), &plan)).flatten()
}

/// The warning about an error that is not kept over the whole run, of so many seconds.
fn unkept(whole: &Whole, aim: Aim, (seconds, plan): (f64, &Plan)) -> Option<String> {
    let Aim::Error(asked) = aim else { return None };
    (whole.error > asked || whole.error.is_nan()).then(|| {
        format!(
            "--error {asked:e} is not known to be kept over all {seconds} s: finer steps differ so that the error may be {:.1e}, and more than \
             asked for from {:.2e} s on; it is the least found in {} s of computing, as where motion is chaotic or friction decides",
            whole.error,
            whole.kept,
            plan.whole.as_secs()
        )
    })
}

/// A point as text.
fn words(point: &Point) -> String {
    let control = point.control.map_or(String::new(), Control::options);
    format!(
        "--method {} {control}: error {:.1e}, {} per simulated second",
        point.method,
        point.error,
        duration(point.nanoseconds)
    )
}

fn explain(
    subject: &dyn Subject,
    truth: &Truth,
    goal: &str,
    (best, other): (&Point, Option<&Point>),
    points: &[Point],
) -> String {
    let over = match truth.seconds < subject.seconds() {
        true => format!("the first {} s of {} s", truth.seconds, subject.seconds()),
        false => format!("all {} s", truth.seconds),
    };
    let next = other.map_or(String::new(), |p| format!("; next best {}", words(p)));
    format!(
        "{goal}: picked {} (m or rad, against {} and, at all ends of steps, against finer ones; {} over {over}; time without rows and \
         ledger){next}",
        words(best),
        truth.reference.text,
        count(points.len(), "run")
    )
}

/// The choice where the reference covers only the start, and the error is that over the whole run.
fn explain_whole(
    subject: &dyn Subject,
    truth: &Truth,
    goal: &str,
    (best, whole): (&Point, &Whole),
    runs: usize,
) -> String {
    let &Whole { control, error, nanoseconds, .. } = whole;
    let known = Point { control: Some(control), error, nanoseconds, ..best.clone() };
    format!(
        "{goal}: picked {} (m or rad, against finer runs at all ends of steps over all {} s; method by {} over the first {} s against {}; \
         time without rows and ledger)",
        words(&known),
        subject.seconds(),
        count(runs, "run"),
        truth.seconds,
        truth.reference.text
    )
}

/// The message if no point meets the aim.
fn nearest(points: &[Point], notes: &[String], (aim, kind): (Aim, Kind)) -> String {
    let least = |key: fn(&Point) -> f64| points.iter().min_by(|a, b| key(a).total_cmp(&key(b)));
    let (point, help) = match aim {
        Aim::Error(_) => (least(|p| p.error), "allow more, or choose --method and --step yourself"),
        Aim::Budget(_) if kind == Kind::Mechanism => {
            (least(|p| p.nanoseconds), "allow more time, or take --engine compiled")
        }
        Aim::Budget(_) => (least(|p| p.nanoseconds), "allow more time"),
    };
    point.map_or(format!("no method gave an answer: {}", notes.join("; ")), |p| {
        format!("not met by any of {} runs; nearest is {}; {help}", points.len(), words(p))
    })
}
