//! The extent of the measurements: the full report, the quick one, or one point.

use super::point::Control;
use super::subject::{Method, ROUNDING, SAMPLES, Subject, parts, step_of};
use crate::engine::{EngineKind, ScalarKind};
use std::time::Duration;

/// One run of a ladder.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rung {
    /// Its step or tolerance.
    pub control: Control,
    /// Expected work relative to the rung before.
    pub work: f64,
}

/// Limits of the measurements.
#[derive(Clone, PartialEq, Debug)]
pub struct Plan {
    /// Each step is the previous one divided by this.
    pub factor: usize,
    /// Most steps of a ladder.
    pub rungs: usize,
    /// Each tolerance is the previous one times this.
    pub tolerance_factor: f64,
    /// A run expected to take longer is not started.
    pub run: Duration,
    /// Computing time for all runs of a subject, without its reference.
    pub subject: Duration,
    /// Computing time for the reference of a subject, and the same for its graph.
    pub reference: Duration,
    /// Of a calibration: computing time for runs over the whole time, where the reference covers only its start.
    pub whole: Duration,
    /// Wall-clock time for all subjects, if it is limited.
    pub wall: Option<Duration>,
    /// Most spring-seconds (or seconds of a mechanism) simulated; longer runs are cut.
    pub work: f64,
    /// Only this method.
    pub method: Option<String>,
    /// Only this step or tolerance.
    pub control: Option<Control>,
    /// Only this scalar.
    pub scalar: Option<ScalarKind>,
    /// What evaluates mechanisms.
    pub engine: EngineKind,
    /// Of a calibration: the time between two rows of the run that it is made for (s). No step is longer, and errors
    /// are measured at all step ends.
    pub rows: Option<f64>,
    /// A ladder ends with the first error of at most this (m or rad).
    pub enough: f64,
}

impl Plan {
    /// All methods and steps, in ten minutes; with the costs on the chip it stays below twenty.
    #[must_use]
    pub fn full() -> Self {
        Self {
            factor: 2,
            rungs: 12,
            tolerance_factor: 1e-1,
            run: Duration::from_secs(1),
            subject: Duration::from_secs(25),
            reference: Duration::from_secs(120),
            whole: Duration::ZERO,
            wall: Some(Duration::from_secs(600)),
            work: f64::INFINITY,
            method: None,
            control: None,
            scalar: None,
            engine: EngineKind::Compiled,
            rows: None,
            enough: 0.0,
        }
    }

    /// Fewer steps and shorter runs, in a minute.
    #[must_use]
    pub fn quick() -> Self {
        Self {
            factor: 4,
            rungs: 5,
            tolerance_factor: 1e-2,
            run: Duration::from_millis(40),
            subject: Duration::from_millis(700),
            reference: Duration::from_secs(12),
            wall: Some(Duration::from_secs(35)),
            work: 100.0,
            engine: EngineKind::Interpreter,
            ..Self::full()
        }
    }

    /// The plan for the next subject, if `left` remain. On a busy machine, on which `computed` took `wall` seconds of
    /// wall-clock time, ladders become shorter so that the report ends in time.
    #[must_use]
    pub fn hurried(&self, wall: f64, computed: Duration, left: usize) -> Self {
        let Some(limit) = self.wall else { return self.clone() };
        let slowdown = (wall / computed.as_secs_f64().max(1e-3)).max(1.0);
        // A third of the time goes to the references.
        let share = 0.67 * (limit.as_secs_f64() - wall).max(0.0) / (left as f64 * slowdown);
        Self { subject: self.subject.min(Duration::from_secs_f64(share)), ..self.clone() }
    }

    /// Simulated time of a subject (s), to two digits.
    #[must_use]
    pub fn seconds(&self, subject: &dyn Subject) -> f64 {
        let most = self.work / subject.weight();
        let asked = subject.seconds();
        if most >= asked { asked } else { format!("{most:.1e}").parse().unwrap_or(most) }
    }

    /// Does the plan include this method with this scalar?
    #[must_use]
    pub fn has(&self, method: &Method, scalar: ScalarKind) -> bool {
        let fits = |control| matches!(control, Control::Tolerance(_)) == method.adaptive;
        self.method.as_ref().is_none_or(|m| *m == method.name)
            && self.scalar.is_none_or(|s| s == scalar)
            && self.control.is_none_or(fits)
    }

    /// The ladder of a method.
    #[must_use]
    pub fn rungs(
        &self,
        subject: &dyn Subject,
        method: &Method,
        scalar: ScalarKind,
        seconds: f64,
    ) -> Vec<Rung> {
        if let Some(control) = self.control {
            let control = match control {
                Control::Step(asked) => Control::Step(taken(subject, asked, seconds)),
                other => other,
            };
            return vec![Rung { control, work: 1.0 }];
        }
        if method.adaptive {
            return self.tolerances(method, scalar);
        }
        let coarsest = self.coarsest(subject.coarsest_step(&method.name), seconds / SAMPLES as f64);
        let steps = (0..self.rungs).map(|n| coarsest * self.factor.pow(n as u32));
        steps
            .map(|n| Rung { control: Control::Step(step_of(seconds, n)), work: self.factor as f64 })
            .collect()
    }

    /// Steps from one sample to the next with which a ladder begins. If rows are asked for whose interval divides the
    /// time between samples, all steps of the ladder divide the interval between rows.
    fn coarsest(&self, longest: f64, interval: f64) -> usize {
        match self.rows {
            None => (interval / longest).ceil().max(1.0) as usize,
            Some(rows) if (interval / rows).round() >= 1.0 && divides(rows, interval) => {
                (interval / rows).round() as usize * parts(rows, longest)
            }
            Some(rows) => parts(interval, longest.min(rows)),
        }
    }

    /// Tolerances from 1e-2 to the finest that is not yet rounding; DOP853's at 1e-13 would be the reference itself.
    fn tolerances(&self, method: &Method, scalar: ScalarKind) -> Vec<Rung> {
        let finest: i32 = match scalar {
            ScalarKind::F32 => -6,
            _ if method.name == "dop853" => -12,
            _ => -13,
        };
        let work = self.tolerance_factor.powf(-1.0 / f64::from(method.order));
        let count = 1 + (f64::from(-2 - finest) / -self.tolerance_factor.log10() + ROUNDING) as i32;
        // As decimals that can be typed on the command line.
        let tolerance = |n: i32| format!("{:e}", 1e-2 * self.tolerance_factor.powi(n));
        let rounded = |n: i32| tolerance(n).parse::<f64>().ok().and_then(|x| format!("{x:.0e}").parse().ok());
        (0..count).filter_map(rounded).map(|e| Rung { control: Control::Tolerance(e), work }).collect()
    }

    /// The engine as an option of the command line.
    #[must_use]
    pub fn engine_option(&self) -> &'static str {
        match self.engine {
            EngineKind::Interpreter => "",
            EngineKind::Compiled => " --engine compiled",
        }
    }
}

/// The step (s) that a run takes for the one asked for: steps end where errors are measured.
pub fn taken(subject: &dyn Subject, asked: f64, seconds: f64) -> f64 {
    let step = subject.step(asked, seconds);
    if (step - asked).abs() <= ROUNDING * asked { asked } else { step }
}

/// Is one time a multiple of the other?
fn divides(part: f64, whole: f64) -> bool {
    let times = whole / part;
    (times - times.round()).abs() <= ROUNDING * times
}
