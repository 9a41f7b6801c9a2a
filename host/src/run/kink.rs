//! A kink of a command in the run of a mechanism: the drive's impulse.
//!
//! In: the times just before and behind it, the state before. Out: the state behind it, whose speeds have the momenta of
//! those before ([`switches::pass`]); the work of the impulse is booked. A command whose value jumps is refused: no motion
//! follows it.

use super::ledger::Ledger;
use super::plant::Plant;
use crate::engine::{Engine, EngineScalar, explain};
use crate::failure::Failure;
use crate::observers::Observers;
use crate::switches;
use smartbed_codegen::Program;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Ode, State};

/// Passes a kink: sets the speeds behind it and books the work of the drive's impulse.
///
/// # Errors
/// [`Failure::Wrong`] with the time, if a value jumps.
pub(super) fn pass<E, S>(
    (program, observers): (&Program, &Observers),
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
        let ends = [early, late].map(|t| plant.closed_forms(t, state.x()));
        let [old, new] = ends.map(|end| end.map_err(failed));
        let (old, new) = (old?, new?);
        let name = |form: usize| &observers.closed[form].0;
        if let Some(form) = switches::jumps([&old, &new], late - early) {
            return Err(Failure::Wrong(switches::jumped(name(form), after)));
        }
        if let Some(form) = switches::leaps([&old, &new]).filter(|_| program.is_redundant()) {
            return Err(Failure::Wrong(format!(
                "t = {after:.6} s: the command of `{}` changes its speed at once, which a mechanism that passes dead \
                 points of its independent speeds does not follow; write a smooth command, for example with smooth_step",
                name(form)
            )));
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
