//! Runs a world: rows of its state and energies, and events.
//!
//! In: an [`Assembly`]. Out: rows handed to the caller, step by step. Works for every [`Engine`].

use super::assembly::{Assembly, Law};
use super::carried::{CarriedWorld, apart, rounded};
use super::engine::{Energies, Engine, Event};
use super::feedback::Feedback;
use super::passing::Passing;
use super::rigid::RigidWorld;
use crate::engine::ScalarKind;
use crate::failure::Failure;
use smartbed_codegen::diagnostic::Diagnostic;

/// The engine for a world.
///
/// # Errors
/// The reason why no engine can move it, with its place where it has one.
pub fn engine(assembly: &Assembly) -> Result<Box<dyn Engine>, Failure> {
    if assembly.is_rigid() {
        if assembly.run.sleep.is_some() {
            let help = match assembly.contacts.is_empty() {
                true => "leave the key out",
                false => "leave the key out, or take impact = \"moreau\" for all contacts",
            };
            let error = Diagnostic::error(
                "run.sleep: rigid parts alone whose touches are located are never put to sleep",
            );
            let error = error.label(assembly.places.key(&["run", "sleep"]), "not read here");
            return Err(assembly.places.failure(error.help(help)));
        }
        return Ok(Box::new(RigidWorld::new(assembly)?));
    }
    Ok(apart::engine(CarriedWorld::new(assembly)?, assembly.run.sleep))
}

/// The engine of a world in f32, as the chip moves it.
///
/// # Errors
/// Why none moves it so, in words.
pub fn single_engine(assembly: &Assembly) -> Result<Box<dyn Engine>, Failure> {
    // A ball that struck a bladder stood 3e-3 elsewhere after 0.1 s than in f64 (1e-6 with moreau): not understood.
    // Rigid parts alone without contacts take the step of any other world: theirs is written for f64.
    if assembly.contacts.iter().any(|contact| !matches!(contact.law, Law::Moreau { .. })) {
        return Err(
            "--scalar f32: touches are located in f64 only, where force laws act, too; leave it out, or take \
             impact = \"moreau\" for all contacts"
                .to_owned()
                .into(),
        );
    }
    if assembly.run.sleep.is_some() {
        return Err("--scalar f32: run.sleep is available in f64 only; leave one of the two out"
            .to_owned()
            .into());
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
    /// Readings of the sensors, in the scene's order.
    pub readings: &'a [f64],
    /// Energy at the start (J).
    pub start: f64,
    /// Number of events so far.
    pub events: usize,
    /// Does the run end with it?
    pub is_last: bool,
}

/// A checkpoint: the world after a whole number of steps, from which a run can be continued.
#[derive(Clone, PartialEq, Debug)]
pub struct Checkpoint {
    /// Number of steps before it.
    pub steps: usize,
    /// Their length (s).
    pub step: f64,
    /// Scalar of the run.
    pub scalar: ScalarKind,
    /// The name of its method; empty if the file has none.
    pub method: String,
    /// Fingerprint of the scene ([`Assembly::fingerprint`]); empty if the file has none.
    pub scene: String,
    /// Energy at the very start (J).
    pub start: f64,
    /// Values of the engine.
    pub state: Vec<f64>,
    /// Number of values of the engine, the last ones, that say how long parts have been slow ([`Engine::sleepers`]);
    /// `None` if the file does not say.
    pub sleepers: Option<usize>,
    /// Values of sensors and controllers.
    pub seen: Vec<f64>,
    /// Their names ([`Assembly::observers`]); `None` if the file has none.
    pub observers: Option<Vec<String>>,
    /// The parts whose state it is ([`Assembly::kinds`]); `None` if the file has none.
    pub parts: Option<Vec<String>>,
}

/// The result of a run.
#[derive(Clone, PartialEq, Debug)]
pub struct Ran {
    /// Events in the order of time.
    pub events: Vec<Event>,
    /// Values of sensors and controllers at its end.
    pub seen: Vec<f64>,
    /// Warnings of what a run of steps shows.
    pub warnings: Vec<String>,
    /// What is said of the equilibrium that it began in.
    pub note: Option<String>,
}

impl Checkpoint {
    /// Text that preserves every bit of the numbers.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { steps, step, scalar, method, scene, start, state, sleepers, seen, observers, parts } =
            self;
        let text = serde_json::json!({
            "steps": steps, "step": step, "scalar": scalar.name(), "method": method, "scene": scene, "start": start,
            "state": state, "sleepers": sleepers, "seen": seen, "observers": observers,
            "parts": parts,
        });
        text.to_string() + "\n"
    }

    /// From [`Checkpoint::text`]; `None` for any other text.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let value: serde_json::Value = serde_json::from_str(text).ok()?;
        let numbers = |list: &serde_json::Value| -> Option<Vec<f64>> {
            list.as_array()?.iter().map(serde_json::Value::as_f64).collect()
        };
        let words = |list: &serde_json::Value| -> Option<Vec<String>> {
            list.as_array()?.iter().map(|word| Some(word.as_str()?.to_owned())).collect()
        };
        Some(Self {
            steps: usize::try_from(value["steps"].as_u64()?).ok()?,
            step: value["step"].as_f64()?,
            // Absent in files of versions that did not say it.
            scalar: match value["scalar"].as_str().unwrap_or("f64") {
                "f32" => ScalarKind::F32,
                "f64" => ScalarKind::F64,
                _ => return None,
            },
            method: value["method"].as_str().unwrap_or_default().to_owned(),
            scene: value["scene"].as_str().unwrap_or_default().to_owned(),
            start: value["start"].as_f64()?,
            state: numbers(&value["state"])?,
            sleepers: value["sleepers"].as_u64().and_then(|n| usize::try_from(n).ok()),
            // Optional: absent in files of runs without sensors and controllers.
            seen: if value["seen"].is_null() { Vec::new() } else { numbers(&value["seen"])? },
            observers: words(&value["observers"]),
            parts: words(&value["parts"]),
        })
    }

    /// The values that an engine loads: without the memory of slow parts if it keeps none or that of others, so that
    /// all begin awake.
    fn state_for(&self, engine: &dyn Engine) -> &[f64] {
        let gone = self.sleepers.filter(|own| *own != engine.sleepers()).unwrap_or(0);
        &self.state[..self.state.len().saturating_sub(gone)]
    }

    /// Refuses parts, sensors and controllers other than those whose values it holds.
    fn refuse_others(&self, assembly: &Assembly) -> Result<(), String> {
        refuse_other("parts, whose states", self.parts.as_deref(), &assembly.kinds())?;
        refuse_other(
            "sensors or controllers, whose memories",
            self.observers.as_deref(),
            &assembly.observers(),
        )
    }
}

/// Refuses names other than those that a checkpoint has `saved`; `what` they are and what it holds of them, in words.
fn refuse_other(what: &str, saved: Option<&[String]>, own: &[String]) -> Result<(), String> {
    let Some(saved) = saved.filter(|saved| *saved != own) else { return Ok(()) };
    let lacks = |all: &[String], these: &[String]| -> Vec<String> {
        these.iter().filter(|name| !all.contains(name)).cloned().collect()
    };
    let (gone, new) = (lacks(own, saved), lacks(saved, own));
    let told = |names: &[String], what: &str| match names {
        [] => None,
        names => Some(format!("{what} {}", names.join(", "))),
    };
    let all = [told(&gone, "without"), told(&new, "with")].into_iter().flatten().collect::<Vec<_>>();
    let differs = if all.is_empty() { "with them in another order".to_owned() } else { all.join(" and ") };
    Err(format!(
        "the checkpoint belongs to another scene, with other {what} it holds: this one is {differs}; expected the same names in \
             the same order"
    ))
}

/// Runs to the end, handing each row to `emit`, with the engine for pictures. From a checkpoint it continues with the
/// next step, bit for bit like the run that made it.
///
/// # Errors
/// A message with the time if it could not go on; or the caller's own failure.
pub fn run<E: From<String> + From<Failure>>(
    assembly: &Assembly,
    engine: &mut dyn Engine,
    from: Option<&Checkpoint>,
    mut emit: impl FnMut(&Row<'_>, &mut dyn Engine) -> Result<(), E>,
    mut stepped: impl FnMut(f64) -> Result<(), E>,
) -> Result<Ran, E> {
    let at = |t: f64, why: String| format!("t = {t:.6} s: {why}");
    // Before a search for rest, which takes its time.
    let mut feedback = Feedback::new(assembly, engine)?;
    let mut note = None;
    let (first, start) = match from {
        Some(checkpoint) => {
            if checkpoint.steps > assembly.run.steps() {
                return Err(E::from(format!(
                    "the checkpoint was saved after {} steps, but the run ends after {}; give more --seconds",
                    checkpoint.steps,
                    assembly.run.steps()
                )));
            }
            engine.load(checkpoint.state_for(engine))?;
            checkpoint.refuse_others(assembly)?;
            if checkpoint.step != assembly.run.step {
                return Err(E::from(format!(
                    "the checkpoint was reached by steps of {} s, the run takes {} s, but counts steps from its start; give --step {}",
                    checkpoint.step, assembly.run.step, checkpoint.step
                )));
            }
            let (saved, own) = (checkpoint.scalar.name(), engine.scalar().name());
            if saved != own {
                return Err(E::from(format!(
                    "the checkpoint was reached in {saved}, the run computes in {own}; give --scalar {saved}"
                )));
            }
            (checkpoint.steps, checkpoint.start)
        }
        None => {
            if assembly.run.settled {
                note = engine.settle()?.note();
            }
            (0, engine.energies().map_err(|why| at(0.0, why))?.total())
        }
    };
    let mut passing = Passing::new(assembly);
    let mut middles = if passing.is_empty() { Vec::new() } else { engine.middles() };
    if let Some(checkpoint) = from {
        feedback.load(&checkpoint.seen, engine)?;
    }
    let (mut t, mut events, mut tick) = (first as f64 * assembly.run.step, Vec::new(), first as u64);
    for n in first..=assembly.run.steps() {
        if n > first {
            let before_step = events.len();
            let h = assembly.run.length(n);
            engine.step(h, &mut events).map_err(|why| at(t, why))?;
            if !passing.is_empty() {
                let before = std::mem::replace(&mut middles, engine.middles());
                passing.observe(h, [&before, &middles], &events[before_step..]);
            }
            events[before_step..].iter_mut().for_each(|event| event.time += t);
            // Computed as a product: a sum would accumulate rounding errors.
            t = if n == assembly.run.steps() { assembly.run.seconds } else { n as f64 * assembly.run.step };
        }
        // Sensors count whole steps, and have observed that of a checkpoint already.
        let is_whole = n > first && assembly.run.length(n) == assembly.run.step;
        if is_whole || n == 0 {
            tick = n as u64;
            feedback.look(tick, engine).map_err(|why| at(t, why))?;
        }
        if n % assembly.run.every == 0 || n == assembly.run.steps() {
            let (state, energies) = (engine.state(), engine.energies());
            let (state, energies) = (state.map_err(|why| at(t, why))?, energies.map_err(|why| at(t, why))?);
            let readings = feedback.readings(tick);
            let row = Row {
                t,
                state: &state,
                energies: &energies,
                readings: &readings,
                start,
                events: events.len(),
                is_last: n == assembly.run.steps(),
            };
            emit(&row, engine)?;
        }
        stepped(t)?;
    }
    Ok(Ran { events, seen: feedback.save(), warnings: passing.warnings(assembly), note })
}
