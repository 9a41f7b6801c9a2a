//! A world in motion: rows of its state and energies, events as they happen.
//!
//! In: an [`Assembly`]. Out: rows to a caller, step by step. What moves is an [`Engine`]; this file is the same for
//! all.

use super::assembly::{Assembly, Law};
use super::carried::{CarriedWorld, apart, rounded};
use super::engine::{Energies, Engine, Event};
use super::feedback::Feedback;
use super::rigid::RigidWorld;

/// The engine of a world.
///
/// # Errors
/// Why none moves it, in words.
pub fn engine(assembly: &Assembly) -> Result<Box<dyn Engine>, String> {
    if assembly.is_rigid() {
        if assembly.run.sleep.is_some() {
            return Err("run.sleep: rigid parts alone whose touches are located are never put to sleep; leave the key out, or take \
                        impact = \"moreau\" for all contacts"
                .to_owned());
        }
        return Ok(Box::new(RigidWorld::new(assembly)?));
    }
    Ok(apart::engine(CarriedWorld::new(assembly)?, assembly.run.sleep))
}

/// The engine of a world in f32, as the chip moves it.
///
/// # Errors
/// Why none moves it so, in words.
pub fn single_engine(assembly: &Assembly) -> Result<Box<dyn Engine>, String> {
    // A ball that struck a bladder stood 3e-3 elsewhere after 0.1 s than in f64 (1e-6 with moreau): not understood.
    if assembly.is_rigid() || assembly.contacts.iter().any(|contact| matches!(contact.law, Law::Located(_))) {
        return Err("--scalar f32: touches are located in f64 alone; leave it out, or take impact = \"moreau\" for all contacts"
            .to_owned());
    }
    if assembly.run.sleep.is_some() {
        return Err("--scalar f32: run.sleep lets parts go and stand by themselves, in f64 alone; leave one of the two out"
            .to_owned());
    }
    rounded::engine(assembly)
}

/// A row.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Row<'a> {
    /// Time (s).
    pub t: f64,
    /// The state, as [`Engine::columns`] says.
    pub state: &'a [f64],
    /// Energies.
    pub energies: &'a Energies,
    /// What the sensors show, in the scene's order.
    pub readings: &'a [f64],
    /// Energy at the start (J).
    pub start: f64,
}

/// What a run goes on from: the world behind a whole number of steps.
#[derive(Clone, PartialEq, Debug)]
pub struct Checkpoint {
    /// Steps behind it.
    pub steps: usize,
    /// Their length (s).
    pub step: f64,
    /// Energy at the start of all (J).
    pub start: f64,
    /// The engine's numbers.
    pub state: Vec<f64>,
    /// What sensors and controllers remember.
    pub seen: Vec<f64>,
}

/// What a run was.
#[derive(Clone, PartialEq, Debug)]
pub struct Ran {
    /// What happened.
    pub events: Vec<Event>,
    /// What sensors and controllers remember at its end.
    pub seen: Vec<f64>,
}

impl Checkpoint {
    /// As text; every number comes back bit for bit.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { steps, step, start, state, seen } = self;
        let text =
            serde_json::json!({"steps": steps, "step": step, "start": start, "state": state, "seen": seen});
        text.to_string() + "\n"
    }

    /// From [`Checkpoint::text`]; none for any other text.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let value: serde_json::Value = serde_json::from_str(text).ok()?;
        let numbers = |list: &serde_json::Value| -> Option<Vec<f64>> {
            list.as_array()?.iter().map(serde_json::Value::as_f64).collect()
        };
        Some(Self {
            steps: usize::try_from(value["steps"].as_u64()?).ok()?,
            step: value["step"].as_f64()?,
            start: value["start"].as_f64()?,
            state: numbers(&value["state"])?,
            // Files of runs that nothing observed may lack it.
            seen: if value["seen"].is_null() { Vec::new() } else { numbers(&value["seen"])? },
        })
    }
}

/// Runs to the end, handing each row to `emit` with the engine, for pictures. From a checkpoint it
/// goes on with the step behind it, bit for bit as the run that made it would have.
///
/// # Errors
/// Why it could not go on, with the time; or the caller's own.
pub fn run<E: From<String>>(
    assembly: &Assembly,
    engine: &mut dyn Engine,
    from: Option<&Checkpoint>,
    mut emit: impl FnMut(&Row<'_>, &mut dyn Engine) -> Result<(), E>,
    mut stepped: impl FnMut(f64) -> Result<(), E>,
) -> Result<Ran, E> {
    let at = |t: f64, why: String| format!("t = {t:.6} s: {why}");
    let (first, start) = match from {
        Some(checkpoint) => {
            if checkpoint.steps > assembly.run.steps() {
                return Err(E::from(format!(
                    "the checkpoint stands behind {} steps, the run ends with {}; give more seconds",
                    checkpoint.steps,
                    assembly.run.steps()
                )));
            }
            engine.load(&checkpoint.state)?;
            if checkpoint.step != assembly.run.step {
                return Err(E::from(format!(
                    "the checkpoint was reached by steps of {} s, the run takes {} s; give --step {}",
                    checkpoint.step, assembly.run.step, checkpoint.step
                )));
            }
            (checkpoint.steps, checkpoint.start)
        }
        None => {
            if assembly.run.settled {
                engine.settle()?;
            }
            (0, engine.energies().map_err(|why| at(0.0, why))?.total())
        }
    };
    let mut feedback = Feedback::new(assembly, engine)?;
    if let Some(checkpoint) = from {
        feedback.load(&checkpoint.seen, engine)?;
    }
    let (mut t, mut events) = (first as f64 * assembly.run.step, Vec::new());
    for n in first..=assembly.run.steps() {
        if n > first {
            let before = events.len();
            let h = assembly.run.length(n);
            engine.step(h, &mut events).map_err(|why| at(t, why))?;
            events[before..].iter_mut().for_each(|event| event.time += t);
            // Not a sum, whose rounding would grow.
            t = if n == assembly.run.steps() { assembly.run.seconds } else { n as f64 * assembly.run.step };
        }
        // Behind the step of a checkpoint they have looked already.
        if n > first || from.is_none() {
            feedback.look(n as u64, engine).map_err(|why| at(t, why))?;
        }
        if n % assembly.run.every == 0 || n == assembly.run.steps() {
            let (state, energies) = (engine.state(), engine.energies());
            let (state, energies) = (state.map_err(|why| at(t, why))?, energies.map_err(|why| at(t, why))?);
            let readings = feedback.readings(n as u64);
            emit(&Row { t, state: &state, energies: &energies, readings: &readings, start }, engine)?;
        }
        stepped(t)?;
    }
    Ok(Ran { events, seen: feedback.save() })
}
