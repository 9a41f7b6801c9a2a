//! Runs a subject with every method and a ladder of steps, in f64 and f32.
//!
//! In: a subject, its reference, a plan. Out: points. A ladder is a sequence of ever finer steps or tolerances. It ends
//! where rounding dominates, where a run would take longer than the plan allows, or where its share of the time is used
//! up.

use super::clock::{self, Stop};
use super::plan::{Plan, taken};
use super::point::{Control, Point};
use super::reference::Truth;
use super::subject::{Method, SAMPLES, Subject, Time, Trace, larger, parts};
use crate::engine::ScalarKind;
use std::time::Duration;

/// Runs shorter than this are repeated, and the fastest of three counts.
const SHORT: Duration = Duration::from_millis(5);
const REPEATS: usize = 3;
/// A run is ended if it takes this many times the plan's limit for a run.
const LONGEST: u32 = 8;
/// A run whose error is above this fraction of the motion's size is discarded.
const NONSENSE: f64 = 0.3;
/// What stands still is off by rounding alone, up to this many units in the last place of its largest coordinate.
const STILL: f64 = 1e4;
/// Times between two samples at which the size of a motion is looked up; a prime, which no period divides by habit.
const BETWEEN: usize = 101;
/// Most numbers of a run's rows that are compared with those of a finer run.
const MOST: usize = 8_000_000;
/// Rounding dominates if two finer steps in a row do not reduce the least error to this fraction.
const GAIN: f64 = 0.7;

/// Results of all ladders.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Measured {
    /// Points, in order of method and step.
    pub points: Vec<Point>,
    /// What was left out, and why.
    pub notes: Vec<String>,
    /// Size of the motion: the largest change of a coordinate (m or rad).
    pub extent: f64,
    is_extent_checked: bool,
}

impl Measured {
    /// The size of the motion, looked up at many times if the error of a run seems to be as large as the motion: one
    /// whose period divides the time between samples seems to stand still.
    fn extent_beyond(&mut self, error: f64, subject: &dyn Subject, truth: &Truth, plan: &Plan) -> f64 {
        if error > NONSENSE * self.extent && !self.is_extent_checked {
            self.is_extent_checked = true;
            let time = Time { samples: SAMPLES * BETWEEN, ..Time::new(truth.seconds, LONGEST * plan.run) };
            // A reference that was computed in time at ten samples may not be at more; then the size stays.
            if let Ok((_, trace)) = subject.second_reference(time) {
                self.extent = self.extent.max(trace.extent());
            }
        }
        self.extent
    }
}

/// Measures a subject. The remaining time is shared evenly by the remaining ladders: if one takes longer than its
/// share, all later ones lose a little instead of the next one everything.
#[must_use]
pub fn measure(subject: &dyn Subject, truth: &Truth, plan: &Plan) -> Measured {
    let mut measured = Measured { extent: truth.trace.extent(), ..Measured::default() };
    if let Some(Control::Step(asked)) = plan.control {
        let taken = taken(subject, asked, truth.seconds);
        if taken != asked {
            measured.notes.push(format!(
                "--step {asked}: measured at {taken:.6e} s: steps end at each tenth of the time, where errors are measured"
            ));
        }
    }
    let methods = subject.methods();
    let ladders = subject.scalars().iter().flat_map(|s| methods.iter().map(move |m| (m, *s)));
    let ladders: Vec<_> = ladders.filter(|(method, scalar)| plan.has(method, *scalar)).collect();
    let end = clock::now() + plan.subject;
    for (n, ladder_of) in ladders.iter().enumerate() {
        let now = clock::now();
        let share = end.saturating_sub(now) / (ladders.len() - n) as u32;
        ladder(subject, truth, plan, *ladder_of, now + share, &mut measured);
    }
    measured
}

/// A point of a calibration whose error at all step ends is known once the next rung is: its number, and its rows.
struct Open {
    point: usize,
    rows: Trace,
    evaluations: Option<u64>,
}

/// One method's points, coarse to fine.
fn ladder(
    subject: &dyn Subject,
    truth: &Truth,
    plan: &Plan,
    (method, scalar): (&Method, ScalarKind),
    end: Duration,
    measured: &mut Measured,
) {
    let rounding = STILL * epsilon(scalar) * largest(truth);
    let (mut least, mut last_time, mut last_work) = (f64::INFINITY, Duration::ZERO, None);
    let (mut taken, mut idle) = (0, 0);
    let (mut refusal, mut open, mut is_done) = (None, None, false);
    for rung in plan.rungs(subject, method, scalar, truth.seconds) {
        let no_time = taken > 0 && clock::now() > end;
        if no_time || last_time.mul_f64(rung.work) > plan.run {
            break;
        }
        let done = run(subject, truth, method, rung.control, scalar, LONGEST * plan.run)
            .and_then(|found| Ok((found, rows(subject, truth, plan, (&method.name, rung.control, scalar))?)));
        let ((mut error, trace), rows) = match done {
            Ok(found) => found,
            Err(Stop::Refused(why)) => {
                refusal = Some(why);
                continue;
            }
            // A finer rung would take even longer.
            Err(late @ Stop::Late { .. }) => {
                refusal = Some(late.to_string());
                break;
            }
        };
        last_time = trace.elapsed;
        if error.is_nan()
            || error > rounding && error > NONSENSE * measured.extent_beyond(error, subject, truth, plan)
        {
            refusal = Some(format!("the error of {error:.1e} is as large as the motion"));
            continue;
        }
        taken += 1;
        measured.points.push(point(subject, truth, plan, method, rung.control, scalar, error, &trace));
        let mut evaluations = trace.evaluations;
        if let Some(rows) = rows {
            // The ladder goes on until the rung before, whose error is now known, was good enough.
            let next = Open { point: measured.points.len() - 1, rows, evaluations };
            let Some(last) = open.replace(next) else { continue };
            let finer = open.as_ref().map_or(0.0, |next| last.rows.difference_between(&next.rows));
            let point = &mut measured.points[last.point];
            point.error = larger(point.error, finer * share(method, plan));
            (error, evaluations) = (point.error, last.evaluations);
        }
        // A tolerance that takes no more evaluations does not show whether rounding dominates.
        let worked = evaluations.is_none_or(|e| last_work.is_none_or(|last| e > last));
        idle = if error <= GAIN * least { 0 } else { idle + usize::from(worked) };
        last_work = evaluations;
        if error <= truth.reference.agreement.max(plan.enough) || idle == 2 {
            is_done = true;
            break;
        }
        least = least.min(error);
    }
    // What no finer run has confirmed is not told.
    if let Some(last) = open {
        let confirmed =
            if is_done { Ok(None) } else { confirm(subject, truth, plan, (method, scalar), &last, measured) };
        if !matches!(confirmed, Ok(Some(()))) {
            measured.points.truncate(last.point);
            taken -= 1;
            refusal = confirmed.err().map(|stop| stop.to_string()).or(refusal);
        }
    }
    if let (0, Some(why)) = (taken, refusal) {
        measured.notes.push(format!("{} {}: {why}", method.name, name_of(scalar)));
    }
}

/// The error of a ladder's last point, where time ended the ladder, by a finer run for this alone; `None` if there is
/// nothing to be run.
fn confirm(
    subject: &dyn Subject,
    truth: &Truth,
    plan: &Plan,
    (method, scalar): (&Method, ScalarKind),
    last: &Open,
    measured: &mut Measured,
) -> Result<Option<()>, Stop> {
    let point = &mut measured.points[last.point];
    let Some(control) = point.control else { return Ok(None) };
    let finer = rows(subject, truth, plan, (&method.name, finer(control, plan), scalar))?;
    Ok(finer.map(|finer| {
        point.error = larger(point.error, last.rows.difference_between(&finer) * share(method, plan));
    }))
}

/// Of a calibration, a run with samples at the ends of steps.
fn rows(
    subject: &dyn Subject,
    truth: &Truth,
    plan: &Plan,
    how: (&str, Control, ScalarKind),
) -> Result<Option<Trace>, Stop> {
    let is_calibration = plan.rows.is_some();
    let time = Time::new(truth.seconds, LONGEST * plan.run);
    is_calibration.then(|| at_step_ends(subject, truth.coordinates(), plan, how, time)).transpose()
}

/// A run with a sample at the end of each step, or at each row of an adaptive method; beyond `MOST` numbers, at as many
/// of them as divide the time evenly.
pub fn at_step_ends(
    subject: &dyn Subject,
    coordinates: usize,
    plan: &Plan,
    how: (&str, Control, ScalarKind),
    time: Time,
) -> Result<Trace, Stop> {
    let longest = match how.1 {
        Control::Step(h) => h,
        Control::Tolerance(_) => plan.rows.unwrap_or(time.seconds),
    };
    let each = parts(time.seconds / SAMPLES as f64, longest);
    let most = (MOST / SAMPLES / coordinates.max(1)).max(1);
    let every = (1..=each).find(|every| each.is_multiple_of(*every) && each / every <= most).unwrap_or(each);
    subject.run(how, Time { samples: SAMPLES * each / every, ..time })
}

/// The control of a ladder's next rung.
pub fn finer(control: Control, plan: &Plan) -> Control {
    match control {
        Control::Step(h) => Control::Step(h / plan.factor as f64),
        Control::Tolerance(e) => Control::Tolerance(e * plan.tolerance_factor),
    }
}

/// Error of a rung over its difference from the next one, whose own error is smaller by the ladder's factor.
pub fn share(method: &Method, plan: &Plan) -> f64 {
    let smaller = match method.adaptive {
        true => plan.tolerance_factor,
        false => (plan.factor as f64).powi(-(method.order as i32)),
    };
    1.0 / (1.0 - smaller)
}

/// Error and trace of a run; the fastest of several, if it is short.
///
/// # Errors
/// Why it stopped.
pub fn run(
    subject: &dyn Subject,
    truth: &Truth,
    method: &Method,
    control: Control,
    scalar: ScalarKind,
    limit: Duration,
) -> Result<(f64, Trace), Stop> {
    let (how, time) = ((method.name.as_str(), control, scalar), Time::new(truth.seconds, limit));
    let mut best = subject.run(how, time)?;
    if best.elapsed < SHORT {
        for _ in 1..REPEATS {
            let again = subject.run(how, time)?;
            best = if again.elapsed < best.elapsed { again } else { best };
        }
    }
    Ok((best.difference(&truth.trace), best))
}

#[expect(clippy::too_many_arguments, reason = "a point is all of this")]
fn point(
    subject: &dyn Subject,
    truth: &Truth,
    plan: &Plan,
    method: &Method,
    control: Control,
    scalar: ScalarKind,
    error: f64,
    trace: &Trace,
) -> Point {
    let scalar = name_of(scalar);
    Point {
        method: method.name.clone(),
        scalar: scalar.to_owned(),
        control: Some(control),
        error: error.max(truth.reference.certainty()),
        evaluations: trace.evaluations.map(|e| e as f64 / truth.seconds),
        nanoseconds: trace.elapsed.as_nanos() as f64 / truth.seconds,
        front: false,
        is_peer: false,
        command: format!(
            "cargo smartbed report {} --seconds {} --method {} {} --scalar {scalar}{}",
            subject.name(),
            truth.seconds,
            method.name,
            control.options(),
            plan.engine_option()
        ),
    }
}

/// The largest coordinate, by magnitude.
fn largest(truth: &Truth) -> f64 {
    truth.trace.samples.iter().flatten().fold(0.0, |most: f64, q| most.max(q.abs()))
}

/// A unit in the last place of 1.
fn epsilon(scalar: ScalarKind) -> f64 {
    match scalar {
        ScalarKind::F32 => f64::from(f32::EPSILON),
        ScalarKind::F64 => f64::EPSILON,
    }
}

/// Name of a scalar on the command line.
#[must_use]
pub fn name_of(scalar: ScalarKind) -> &'static str {
    match scalar {
        ScalarKind::F32 => "f32",
        ScalarKind::F64 => "f64",
    }
}
