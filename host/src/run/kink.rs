//! A kink of a command in the run of a mechanism: the drive's impulse.
//!
//! In: the times just before and behind it, the state before. Out: the state behind it, whose speeds have the momenta
//! of those before ([`switches::pass`]); the work of the impulse is booked. A command whose value jumps is refused: no
//! motion follows it. So is a constraint whose factors of speeds jump: which impulse it gives is not known.

use super::ledger::Ledger;
use super::plant::Plant;
use crate::engine::{Engine, EngineScalar, explain};
use crate::failure::Failure;
use crate::switches;
use smartbed_codegen::Program;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Ode, State};

/// Passes a kink: sets the speeds behind it and books the work of the drive's impulse.
///
/// # Errors
/// [`Failure::Wrong`] with the time, if a value jumps.
pub(super) fn pass<E, S>(
    program: &Program,
    plant: &mut Plant<E, S>,
    [before, after]: [f64; 2],
    state: &mut State<'_, S>,
    ledger: &mut Ledger,
) -> Result<(), Failure>
where
    E: std::ops::DerefMut<Target = dyn Engine<S>>,
    S: EngineScalar,
{
    let failed = |fault: Fault| Failure::Wrong(format!("t = {after:.6} s: {}", explain(fault)));
    if plant.switches.may_leap {
        let [early, late] = [before, after].map(S::from_f64);
        let (q, u) = state.x().split_at(program.q.len());
        let wrong = |why: String| Err(Failure::Wrong(why));
        if let Some(command) = plant.switches.jumped([before, after], q, u).map_err(failed)? {
            return wrong(switches::jumped(&command.words(None), after));
        }
        if program.is_redundant()
            && let Some(command) = plant.leaps([before, after], state.x()).map_err(failed)?
        {
            return wrong(format!(
                "t = {after:.6} s: {} changes its speed at once, which a mechanism that passes dead points of its \
                 independent speeds does not follow; write a smooth command, for example with smooth_step",
                command.words(None)
            ));
        }
        let speeds = |t, u: &[S]| {
            plant.set_time(t);
            plant.engine.speeds(q, u)
        };
        if switches::ties_change(speeds, [early, late], u).map_err(failed)? {
            let changed = plant.switches.changed([before, after]).map_err(failed)?;
            let command = changed.iter().find(|command| command.values == 0).or(changed.first());
            return wrong(switches::tied(&command.map_or_else(String::new, |own| own.words(None)), after));
        }
        let kinetic = |t, u: &[S]| {
            plant.set_time(t);
            Ok(plant.engine.energy(q, u)?.0)
        };
        let (u, _) = switches::pass(kinetic, [early, late], u).map_err(failed)?;
        let x = [q, &u].concat();
        state.set(&x).map_err(failed)?;
    }
    let x: Vec<f64> = state.x().iter().map(|x| x.to_f64()).collect();
    ledger.leap(after, &x).map_err(failed)
}
