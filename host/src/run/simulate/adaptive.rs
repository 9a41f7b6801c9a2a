//! A run with steps that the method chooses: rows between their ends come from its own interpolation.
//!
//! In: a plant and its state at t = 0. Out: its rows. Steps are cut where something switches; times up to the next step
//! are looked at before it is taken, so that rows do not decide what is seen.

use super::recorder::{Recorder, Row, Setup, interrupted, refused, widened};
use crate::engine::{Engine, EngineScalar};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::run::ledger::Ledger;
use crate::run::plant::Plant;
use crate::run::settings::Settings;
use crate::switches::rounding;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::step_size::Tolerance;
use smartbed_runtime::ode::{DormandPrince, Ode as _, State, dormand_prince};
use smartbed_runtime::real::Scalar;

/// Most steps.
const MOST_STEPS: u64 = 100_000_000;
/// Intervals of Simpson's rule in a step: an even number.
const PARTS: usize = 8;

/// The whole run.
pub(super) fn adaptive<E, S, F>(
    setup: Setup<'_>,
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
    let Settings { seconds, step, look, tolerance, .. } = *setup.settings;
    plant.watch(setup.observers, seconds, step).map_err(|fault| refused(0.0, fault))?;
    let n = state.x().len();
    let mut memory = vec![S::ZERO; dormand_prince::scratch(n)];
    let tolerance = Tolerance { absolute: S::from_f64(tolerance), relative: S::from_f64(tolerance) };
    let mut method = DormandPrince::new(n, tolerance, S::from_f64(step), &mut memory)
        .map_err(|fault| refused(0.0, fault))?;
    let interval = setup.settings.row_interval();
    let rows = setup.settings.intervals(interval);
    let mut progress = Progress::new("running");
    let (mut t, mut next_row) = (0.0_f64, 1_u64);
    let mut inside = vec![S::ZERO; n];
    let mut dense = |method: &DormandPrince<'_, S>, plant: &mut Plant<E, S>, t: f64, theta: f64| {
        method.dense(S::from_f64(theta), &mut inside)?;
        plant.set_time(S::from_f64(t));
        // The interpolant between two states on the constraints does not satisfy them exactly.
        plant.project(&mut inside)?;
        Ok::<Vec<S>, Fault>(inside.clone())
    };
    // The first kink ahead, and the time up to which there is none.
    let (mut next_kink, mut looked) = (None, t);
    for _ in 0..MOST_STEPS {
        if next_row > rows {
            return Ok(());
        }
        let ahead = (t + method.next.to_f64()).min(seconds);
        if next_kink.is_none() && looked < ahead {
            next_kink = plant.switches.next(looked, ahead, look).map_err(|f| refused(t, f))?;
            looked = ahead;
        }
        let kink = next_kink;
        let to = kink.map_or(seconds, |[before, _]| before);
        let left = to - t;
        if let Some(kink) = kink.filter(|_| left <= rounding::<S>(to)) {
            plant.pass([t, kink[1]], state)?;
            method.restart();
            t = kink[1];
            ledger.leap(t, &widened(state.x())).map_err(|fault| refused(t, fault))?;
            (next_kink, looked) = (None, t);
            if seconds - t <= rounding::<S>(seconds) {
                return recorder.row(plant, seconds, state.x(), &ledger);
            }
            continue;
        }
        let taken = method.step(plant, S::from_f64(t), S::from_f64(left), state);
        let taken = taken.map_err(|fault| recorder.refused(plant, t, state.x(), fault))?;
        let h = taken.h.to_f64();
        let end = if h >= left * (1.0 - f64::from(f32::EPSILON)) { to } else { t + h };
        recorder.took(taken.report, end, state.x());
        recorder.chatter.observe(end, state.x(), &plant.inputs).map_err(|fault| refused(end, fault))?;
        // Rows that lie between a kink's moments belong to the side on which time is for what it commands.
        let behind = kink.filter(|_| end == to).map_or(end, |[_, behind]| behind);
        // A step is booked in parts if rows lie inside it.
        let mut from = 0.0;
        while next_row <= rows {
            let at = if next_row == rows { seconds } else { next_row as f64 * interval };
            if at > behind
                || at > end && plant.switches.differ([end, at]).map_err(|fault| refused(at, fault))?
            {
                break;
            }
            let theta = ((at - t) / h).clamp(0.0, 1.0);
            let x = if theta < 1.0 {
                dense(&method, plant, at, theta).map_err(|f| refused(at, f))?
            } else {
                state.x().to_vec()
            };
            // One between a kink's moments may lie before the start of a step.
            if theta > from {
                book(&mut ledger, (from, theta), at, &x, |th| dense(&method, plant, t + th * h, th))
                    .map_err(|f| refused(at, f))?;
            }
            recorder.row(plant, at, &x, &ledger)?;
            (from, next_row) = (theta, next_row + 1);
        }
        if from < 1.0 {
            let x = state.x().to_vec();
            book(&mut ledger, (from, 1.0), end, &x, |th| dense(&method, plant, t + th * h, th))
                .map_err(|f| refused(end, f))?;
        }
        t = end;
        progress.at(t / seconds);
        interrupted(t)?;
    }
    Err(Failure::Wrong(format!(
        "t = {t:.6} s: {MOST_STEPS} steps were not enough; allow a larger --tolerance"
    )))
}

/// Books the part `from..to` (fractions) of a step, which ends at time `t` with `x`.
fn book<S: Scalar>(
    ledger: &mut Ledger,
    (from, to): (f64, f64),
    t: f64,
    x: &[S],
    mut dense: impl FnMut(f64) -> Result<Vec<S>, Fault>,
) -> Result<(), Fault> {
    let mut between = Vec::with_capacity(PARTS - 1);
    for part in 1..PARTS {
        let theta = from + (to - from) * part as f64 / PARTS as f64;
        between.push(widened(&dense(theta)?));
    }
    ledger.step_through(&between, t, &widened(x))
}
