//! Steps a mechanism from start to end and hands out its rows.
//!
//! In: a program, its observers, settings, the start. Out: rows at equal intervals, each a list of numbers named by
//! [`columns`], and a [`Summary`]. Observers only read states; without them the motion is the same bit for bit. Steps of
//! fixed size are here, `adaptive.rs` has those that the method chooses, `recorder.rs` makes the rows.

mod adaptive;
mod recorder;

use super::health::{Health, Range};
use super::ledger::Ledger;
pub use super::plant::Plant;
use super::settings::Settings;
use crate::chatter::Chatter;
use crate::engine::{Engine, EngineScalar, explain};
use crate::failure::Failure;
use crate::limits::{Angles, check_numbers};
use crate::progress::Progress;
use crate::switches::between::passed;
use crate::switches::{MOST, rounding, too_many};
use adaptive::adaptive;
pub(super) use recorder::interrupted;
use recorder::{Recorder, refused, widened};
pub use recorder::{Row, Setup, Summary, columns};
use smartbed_codegen::Interpreted;
use smartbed_runtime::ode::{Method, Report, State};
use std::collections::BTreeMap;

/// A remainder of the time below this fraction of a step is rounding.
const ROUNDING: f64 = 1e-3;

/// Runs from start to end.
///
/// # Errors
/// [`Failure::Wrong`] with the time, if a step is refused; the sink's own failures.
pub fn simulate<S: EngineScalar>(
    setup: Setup<'_>,
    engine: Box<dyn Engine<S>>,
    sink: impl FnMut(&Row) -> Result<(), Failure>,
) -> Result<Summary, Failure> {
    let mut plant = Plant::new(engine, setup.program, setup.observers);
    let state = setup.program.q.iter().chain(&setup.program.u).map(|quantity| quantity.name.as_str());
    check_numbers::<S>(state.zip(setup.start.iter().copied())).map_err(Failure::Wrong)?;
    let mut x: Vec<S> = setup.start.iter().map(|&x| S::from_f64(x)).collect();
    let mut low = vec![S::ZERO; x.len()];
    let mut recorder = Recorder {
        program: setup.program,
        observers: setup.observers,
        places: Interpreted::new(&setup.observers.places()),
        angles: [setup.program, &setup.observers.laws()].map(Angles::new::<S>),
        sink,
        summary: Summary {
            steps: 0,
            evaluations: 0,
            rows: 0,
            pivot: 1.0,
            residual: 0.0,
            imbalance: 0.0,
            health: Health::new(ranges(setup), S::EPSILON.to_f64()),
            last: Vec::new(),
        },
        columns: columns(setup.program, setup.observers),
        chatter: Chatter::new(setup.observers),
    };
    let ledger = Ledger::open(setup.program, setup.observers, (0.0, &widened(&x)), rounding::<S>(1.0))
        .map_err(|fault| Failure::Wrong(format!("t = 0 s: {}", explain(fault))))?;
    let mut state = State::new(&mut x, &mut low).map_err(|f| Failure::Wrong(explain(f).to_owned()))?;
    recorder.row(&mut plant, 0.0, state.x(), &ledger)?;
    // If time determines every coordinate there is nothing to integrate: any method only makes rows.
    let stateless = state.x().is_empty().then_some(Method::Rk4);
    match setup.settings.method.fixed().or(stateless) {
        Some(method) => fixed(setup, method, &mut plant, &mut state, ledger, &mut recorder)?,
        None => adaptive(setup, &mut plant, &mut state, ledger, &mut recorder)?,
    }
    recorder.summary.evaluations = plant.evaluations();
    recorder.summary.health.chatter(recorder.chatter.warning(None));
    Ok(recorder.summary)
}

/// The declared ranges; those of angles that appear only inside sines and cosines count modulo whole turns.
pub(super) fn ranges(setup: Setup<'_>) -> BTreeMap<String, Range> {
    let mut ranges = setup.settings.ranges.clone();
    for angle in setup.program.q.iter().filter(|q| q.is_angle) {
        ranges.entry(angle.name.clone()).and_modify(|range| range.is_angle = true);
    }
    ranges
}

fn fixed<E, S, F>(
    setup: Setup<'_>,
    method: Method,
    plant: &mut Plant<E, S>,
    state: &mut State<'_, S>,
    mut ledger: Ledger,
    recorder: &mut Recorder<'_, F>,
) -> Result<(), Failure>
where
    E: std::ops::DerefMut<Target = dyn Engine<S>>,
    S: EngineScalar,
    F: FnMut(&Row) -> Result<(), Failure>,
{
    let Settings { seconds, step, look, every, .. } = *setup.settings;
    let steps = setup.settings.intervals(step);
    if let Some(t) = passed(setup.observers, [seconds, step]).map_err(|fault| refused(0.0, fault))? {
        recorder.summary.health.passed_over(None, t);
    }
    let mut scratch = vec![S::ZERO; method.scratch(state.x().len())];
    let mut progress = Progress::new("running");
    for n in 1..=steps {
        let t = (n - 1) as f64 * step;
        let is_short = seconds - t < (1.0 - ROUNDING) * step;
        let (h, end) = if is_short { (seconds - t, seconds) } else { (step, n as f64 * step) };
        let mut from = t;
        for cut in 0.. {
            let kink = plant.switches.within([from, end], look).map_err(|fault| refused(from, fault))?;
            let to = kink.map_or(end, |[before, _]| before);
            let part = if from == t && to == end { h } else { to - from };
            let is_step = part > rounding::<S>(to);
            if is_step {
                let report = match state.x().is_empty() {
                    true => Report { pivot: S::ONE, residual: S::ZERO },
                    false => method
                        .step(plant, S::from_f64(from), S::from_f64(part), state, &mut scratch)
                        .map_err(|fault| recorder.refused(plant, from, state.x(), fault))?,
                };
                recorder.took(report, to, state.x());
                ledger.step(to, &widened(state.x())).map_err(|fault| refused(to, fault))?;
                recorder.chatter.observe(to, state.x(), &plant.inputs).map_err(|fault| refused(to, fault))?;
            }
            let Some(kink) = kink else {
                if !is_step {
                    plant.drift(from, part, state).map_err(|fault| refused(to, fault))?;
                }
                break;
            };
            if cut == MOST {
                return Err(Failure::Wrong(format!("t = {from:.6} s: {}", too_many())));
            }
            plant.pass([if is_step { to } else { from }, kink[1]], state)?;
            ledger.leap(kink[1], &widened(state.x())).map_err(|fault| refused(kink[1], fault))?;
            from = kink[1];
        }
        if n % every as u64 == 0 || n == steps {
            recorder.row(plant, end, state.x(), &ledger)?;
        }
        progress.at(n as f64 / steps as f64);
        interrupted(end)?;
    }
    Ok(())
}
