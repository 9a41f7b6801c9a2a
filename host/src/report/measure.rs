//! Runs a subject with every method and a ladder of steps, in f64 and f32.
//!
//! In: a subject, its reference, a plan. Out: points. A ladder is a sequence of ever finer steps or tolerances. It ends
//! where rounding dominates, where a run would take longer than the plan allows, or where its share of the time is used
//! up.

use super::clock::{self, Stop};
use super::plan::Plan;
use super::point::{Control, Point};
use super::reference::Truth;
use super::subject::{Method, Subject, Time, Trace};
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
/// Rounding dominates if two finer steps in a row do not reduce the least error to this fraction.
const GAIN: f64 = 0.7;

/// Results of all ladders.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Measured {
    /// Points, in order of method and step.
    pub points: Vec<Point>,
    /// What was left out, and why.
    pub notes: Vec<String>,
}

/// Measures a subject. The remaining time is shared evenly by the remaining ladders: if one takes longer than its
/// share, all later ones lose a little instead of the next one everything.
#[must_use]
pub fn measure(subject: &dyn Subject, truth: &Truth, plan: &Plan) -> Measured {
    let mut measured = Measured::default();
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

/// One method's points, coarse to fine.
fn ladder(
    subject: &dyn Subject,
    truth: &Truth,
    plan: &Plan,
    (method, scalar): (&Method, ScalarKind),
    end: Duration,
    measured: &mut Measured,
) {
    let size = (NONSENSE * extent(truth)).max(STILL * epsilon(scalar) * largest(truth));
    let (mut least, mut last_time, mut last_work) = (f64::INFINITY, Duration::ZERO, None);
    let (mut taken, mut idle) = (0, 0);
    let mut refusal = None;
    for rung in plan.rungs(subject, method, scalar, truth.seconds) {
        let no_time = taken > 0 && clock::now() > end;
        if no_time || last_time.mul_f64(rung.work) > plan.run {
            break;
        }
        let (error, trace) = match run(subject, truth, method, rung.control, scalar, LONGEST * plan.run) {
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
        if error.is_nan() || error > size {
            refusal = Some(format!("the error of {error:.1e} is as large as the motion"));
            continue;
        }
        taken += 1;
        measured.points.push(point(subject, truth, plan, method, rung.control, scalar, error, &trace));
        // A tolerance that takes no more evaluations does not show whether rounding dominates.
        let worked = trace.evaluations.is_none_or(|e| last_work.is_none_or(|last| e > last));
        idle = if error <= GAIN * least { 0 } else { idle + usize::from(worked) };
        last_work = trace.evaluations;
        if error <= truth.reference.agreement || idle == 2 {
            break;
        }
        least = least.min(error);
    }
    if let (0, Some(why)) = (taken, refusal) {
        measured.notes.push(format!("{} {}: {why}", method.name, name_of(scalar)));
    }
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
    let (how, time) = ((method.name.as_str(), control, scalar), Time { seconds: truth.seconds, limit });
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

/// Size of the motion: the largest change of a coordinate between two samples.
#[must_use]
pub fn extent(truth: &Truth) -> f64 {
    let n = truth.trace.samples.first().map_or(0, Vec::len);
    let range = |i: usize| {
        let column = truth.trace.samples.iter().map(|s| s[i]);
        column.clone().fold(f64::NEG_INFINITY, f64::max) - column.fold(f64::INFINITY, f64::min)
    };
    (0..n).map(range).fold(0.0, f64::max)
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
