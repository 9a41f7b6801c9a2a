//! A time at which something switches, in the motion of a mechanism.
//!
//! In: the times just before and behind it, the state before. Out: the state behind it. Between them, where rounding
//! may put an evaluation on either side, it moves half the time with the rates before and half with those behind. In
//! the middle a drive that changes its speed at once gives its impulse: speeds keep their momenta
//! ([`impulse::pass`]). A command whose value jumps is refused: no motion follows it. So is a constraint whose factors
//! of speeds jump: which impulse it gives is not known.

use super::plant::Plant;
use crate::engine::{Engine, EngineScalar, explain};
use crate::switches::Switches;
use crate::switches::impulse::{self, Placed};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Ode as _, State};

impl<E, S> Plant<E, S>
where
    E: std::ops::DerefMut<Target = dyn Engine<S>>,
    S: EngineScalar,
{
    /// Sets a state behind a switch.
    ///
    /// # Errors
    /// In words with the time, if a value jumps.
    pub fn pass(&mut self, [before, after]: [f64; 2], state: &mut State<'_, S>) -> Result<(), String> {
        let failed = |fault: Fault| format!("t = {after:.6} s: {}", explain(fault));
        let half = 0.5 * (after - before);
        // One that lies behind the end of a step by rounding is passed in the next one: a row is before it.
        let leaps = self.switches.may_leap && self.switches.differ([before, after]).map_err(failed)?;
        if leaps {
            self.refuse_jumps([before, after], state.x())?;
        }
        self.drift(before, half, state).map_err(failed)?;
        if leaps {
            let (mut own, u) = self.here(state.x()).map_err(failed)?;
            let (u, _) = impulse::pass(&mut own, [before, after].map(S::from_f64), u).map_err(failed)?;
            let x = [own.q, &u].concat();
            state.set(&x).map_err(failed)?;
        }
        self.drift(after, half, state).map_err(failed)
    }

    /// Moves for a time that is rounding, with the rates at one.
    ///
    /// # Errors
    /// The engine's.
    pub(super) fn drift(&mut self, t: f64, h: f64, state: &mut State<'_, S>) -> Result<(), Fault> {
        let mut x_dot = vec![S::ZERO; state.x().len()];
        self.rates(S::from_f64(t), state.x(), &mut x_dot)?;
        let h = S::from_f64(h);
        let x: Vec<S> = state.x().iter().zip(&x_dot).map(|(x, x_dot)| *x + h * *x_dot).collect();
        state.set(&x)
    }

    /// Refuses a command whose value jumps, and a constraint whose factors do.
    fn refuse_jumps(&mut self, [before, after]: [f64; 2], x: &[S]) -> Result<(), String> {
        let failed = |fault: Fault| format!("t = {after:.6} s: {}", explain(fault));
        let (mut own, u) = self.here(x).map_err(failed)?;
        if let Some(command) = own.switches.jumped([before, after], own.q, u).map_err(failed)? {
            return Err(impulse::jumped(&command.words(None), after));
        }
        if impulse::ties_change(&mut own, [before, after].map(S::from_f64), u).map_err(failed)? {
            let changed = self.switches.changed([before, after]).map_err(failed)?;
            let command = changed.iter().find(|command| command.values == 0).or(changed.first());
            return Err(impulse::tied(&command.map_or_else(String::new, |own| own.words(None)), after));
        }
        Ok(())
    }

    /// The engine at the coordinates of a state, and its speeds.
    fn here<'a>(&'a mut self, x: &'a [S]) -> Result<(Here<'a, S>, &'a [S]), Fault> {
        let (q, u) = x.split_at_checked(self.engine.n_q()).ok_or(Fault::Shape)?;
        Ok((Here { engine: &mut *self.engine, switches: &mut self.switches, q }, u))
    }
}

/// The engine at a place.
struct Here<'a, S> {
    engine: &'a mut dyn Engine<S>,
    switches: &'a mut Switches<S>,
    q: &'a [S],
}

impl<S: EngineScalar> Here<'_, S> {
    fn at(&mut self, t: S) -> Result<&mut dyn Engine<S>, Fault> {
        self.engine.set_time(self.switches.moment(t)?);
        Ok(self.engine)
    }
}

impl<S: EngineScalar> Placed<S> for Here<'_, S> {
    fn kinetic(&mut self, t: S, u: &[S]) -> Result<S, Fault> {
        let q = self.q;
        Ok(self.at(t)?.energy(q, u)?.0)
    }
    fn speeds(&mut self, t: S, u: &[S]) -> Result<Vec<S>, Fault> {
        let q = self.q;
        self.at(t)?.speeds(q, u)
    }
    fn tied(&mut self, t: S, u: &[S]) -> Result<Vec<S>, Fault> {
        let (q, mut u) = (self.q, u.to_vec());
        self.at(t)?.project_speeds(q, &mut u)?;
        Ok(u)
    }
}
