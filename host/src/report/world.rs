//! A scene of format 2 as a subject of the report.
//!
//! In: an assembly. Out: its runs by every method that it has. Without contacts its equations are smooth and DOP853 is
//! the reference. With contacts, flow through lines or controllers no method converges faster than the world's own
//! step; the reference is then that step, halved as long as time allows, and its uncertainty is the change made by the
//! last halving. Controllers act at fixed times, whatever the step, which is a whole fraction of the scene's own.

use super::clock::{self, Deadline, Stop};
use super::exchange;
use super::point::Control;
use super::sheet::Sheet;
use super::subject::{AGREEMENT, Exchanged, Kind, Method, Subject, Time, Trace, even_step, parts};
use crate::engine::ScalarKind;
use crate::failure::Failure;
use crate::model_argument;
use crate::plot::{Recording, svg};
use crate::run::rows as drawn;
use crate::world::Assembly;
use crate::world::assembly::{Controlling, Sensing, Transducer};
use crate::world::carried::CarriedWorld;
use crate::world::carried::methods::Contacts;
use crate::world::engine::Engine;
use crate::world::feedback::Feedback;
use crate::world::rigid::RigidWorld;
use crate::world::run::run;
use smartbed_codegen::words::count;
use std::cell::Cell;
use std::path::Path;
use std::time::Duration;

/// A ladder begins at this multiple of the scene's own step.
const COARSE: f64 = 8.0;
/// Fraction of the largest stable step with which it begins, if there is one.
const STABLE: f64 = 0.9;
/// A world with contacts has a reference if two halvings differ by at most this (m or rad).
const TOUCHING: f64 = 1e-4;
/// Steps between two checks of the clock.
pub(super) const LOOK: usize = 16;
/// Rows of a graph.
const ROWS: usize = 500;

/// A world with its engine at the start.
#[derive(Clone)]
enum Start {
    Rigid(Box<RigidWorld>),
    Carried(Box<CarriedWorld>),
}

impl Start {
    fn new(assembly: &Assembly) -> Result<Self, Failure> {
        let mut start = match assembly.is_rigid() {
            true => Self::Rigid(Box::new(RigidWorld::new(assembly)?)),
            false => Self::Carried(Box::new(CarriedWorld::new(assembly)?)),
        };
        if assembly.run.settled {
            start.engine().settle()?;
        }
        Ok(start)
    }

    fn engine(&mut self) -> &mut dyn Engine {
        match self {
            Self::Rigid(world) => world.as_mut(),
            Self::Carried(world) => world.as_mut(),
        }
    }
}

/// Sensors that controllers use.
fn read(assembly: &Assembly) -> impl Iterator<Item = &Sensing> {
    let reads = |sensor: &Sensing| {
        let read = |own: &Controlling| own.reads.strip_prefix("sensors.") == Some(&sensor.name);
        assembly.controllers.iter().any(read)
    };
    assembly.sensors.iter().filter(move |sensor| reads(sensor))
}

/// A sensor used by a controller whose readings depend on the number of the step, not on time.
fn read_by_step(assembly: &Assembly) -> Option<&str> {
    let chatters =
        |own: &Sensing| matches!(own.transducer, Transducer::Switch { chatter, .. } if chatter > 0.0);
    let found = read(assembly).find(|own| own.period.is_none() || chatters(own));
    found.map(|own| own.name.as_str())
}

/// Does a controller read a pressure gauge with a lag, whose reading is updated once per step?
fn lags(assembly: &Assembly) -> bool {
    read(assembly).any(|own| matches!(own.transducer, Transducer::Pressure { lag } if lag > 0.0))
}

/// A world with its engine at the start.
pub struct World {
    name: String,
    pub(super) assembly: Assembly,
    start: Start,
    /// Indices of the rows' values that are coordinates.
    coordinates: Vec<usize>,
    /// Step of the reference, if there is one (s).
    pub(super) finest: Cell<f64>,
}

impl World {
    /// Reads and assembles it; `settings` are changes `path = value`.
    ///
    /// # Errors
    /// [`Failure::Found`] or [`Failure::Wrong`] with what is wrong in it.
    pub fn open(name: &str, path: &Path, settings: &[String]) -> Result<Self, Failure> {
        Self::of(name, model_argument::open_world(path, settings)?)
    }

    /// From an assembly that is already read.
    ///
    /// # Errors
    /// [`Failure::Found`] or [`Failure::Wrong`] if it cannot be assembled.
    pub fn of(name: &str, assembly: Assembly) -> Result<Self, Failure> {
        if let Some(sensor) = read_by_step(&assembly) {
            return Err(Failure::Wrong(format!(
                "{name}: no method is measured on it: a controller reads sensors.{sensor}, which samples or chatters by steps, so that \
                 another step computes something else; give it a period, and no chatter"
            )));
        }
        let mut start = Start::new(&assembly)?;
        if !assembly.controllers.is_empty() {
            // Refused here, where its place is shown, and not by the first run.
            Feedback::new(&assembly, start.engine())?;
        }
        let columns = start.engine().columns();
        // Lengths, angles and Euler parameters; not speeds, volumes or pressures.
        let is_coordinate = |unit: &str| ["m", "rad", "1", ""].contains(&unit);
        let coordinates = (0..columns.len()).filter(|n| is_coordinate(&columns[*n].unit)).collect();
        Ok(Self { name: name.to_owned(), assembly, start, coordinates, finest: Cell::new(0.0) })
    }

    /// The assembly.
    #[must_use]
    pub fn assembly(&self) -> &Assembly {
        &self.assembly
    }

    /// Does `run.method` choose a method? Otherwise there is only its own step.
    #[must_use]
    pub fn takes_method(&self) -> bool {
        matches!(&self.start, Start::Carried(_))
    }

    /// Are there controllers, which act at whole numbers of the scene's steps?
    fn is_controlled(&self) -> bool {
        !self.assembly.controllers.is_empty()
    }

    /// A step of at most `longest` (s), and the number of steps after which each sample is taken.
    fn steps(&self, longest: f64, Time { seconds, samples, .. }: Time) -> Result<(f64, Vec<usize>), Stop> {
        if !self.is_controlled() {
            let interval = seconds / samples as f64;
            let steps = parts(interval, longest);
            return Ok((interval / steps as f64, (1..=samples).map(|i| i * steps).collect()));
        }
        let own = self.assembly.run.step;
        let (count, each) = ((seconds / own + 1e-9).floor() as usize, parts(own, longest));
        if count == 0 {
            return Err(format!("a run of {seconds} s is shorter than the scene's step, {own} s").into());
        }
        Ok((own / each as f64, (1..=samples).map(|i| each * (i * count).div_ceil(samples)).collect()))
    }

    pub(super) fn sample(&self, engine: &mut dyn Engine) -> Result<Vec<f64>, Stop> {
        let state = engine.state()?;
        Ok(self.coordinates.iter().map(|n| state[*n]).collect())
    }

    pub(super) fn trace(&self, method: Option<&str>, longest: f64, time: Time) -> Result<Trace, Stop> {
        let deadline = Deadline::within(time.limit);
        let mut start = self.start.clone();
        if let (Start::Carried(world), Some(method)) = (&mut start, method) {
            world.choose(method)?;
        }
        let engine = start.engine();
        let (h, ends) = self.steps(longest, time)?;
        let mut feedback = match self.is_controlled() {
            true => {
                let mut assembly = self.assembly.clone();
                assembly.run.step = h;
                Some(Feedback::new(&assembly, engine)?)
            }
            false => None,
        };
        let (mut samples, mut events) = (Vec::with_capacity(time.samples), Vec::new());
        let begin = clock::now();
        for i in 0..=ends.last().copied().unwrap_or(0) {
            if i % LOOK == 0 {
                deadline.check(i as f64 * h)?;
            }
            if i > 0 {
                engine.step(h, &mut events)?;
            }
            if let Some(feedback) = &mut feedback {
                feedback.look(i as u64, engine)?;
            }
            while ends.get(samples.len()) == Some(&i) {
                samples.push(self.sample(engine)?);
            }
        }
        Ok(Trace { samples, evaluations: None, elapsed: clock::now() - begin })
    }

    /// The world, if its equations are smooth and it has state to integrate.
    fn smooth(&self) -> Option<&CarriedWorld> {
        match &self.start {
            Start::Carried(world) if world.is_smooth() && !world.numbers().is_empty() => {
                (!self.is_controlled() && !self.assembly.has_lines()).then_some(world)
            }
            _ => None,
        }
    }
}

impl Subject for World {
    fn name(&self) -> &str {
        &self.name
    }

    fn title(&self) -> String {
        format!("{}: {}", self.assembly.title, count(self.assembly.parts.len(), "part"))
    }

    fn seconds(&self) -> f64 {
        self.assembly.run.seconds
    }

    fn coarsest_step(&self, _: &str) -> f64 {
        let coarse = if self.is_controlled() { 1.0 } else { COARSE } * self.assembly.run.step;
        match &self.start {
            Start::Carried(world) => world.largest_stable_step().map_or(coarse, |h| (STABLE * h).min(coarse)),
            Start::Rigid(_) => coarse,
        }
    }

    fn step(&self, longest: f64, seconds: f64) -> f64 {
        match self.is_controlled() {
            true => self.assembly.run.step / parts(self.assembly.run.step, longest) as f64,
            false => even_step(longest, seconds),
        }
    }

    fn is_smooth(&self) -> bool {
        self.assembly.contacts.is_empty()
    }

    fn weight(&self) -> f64 {
        self.coordinates.len() as f64
    }

    fn methods(&self) -> Vec<Method> {
        let method = |name: &str, order| Method { name: name.to_owned(), order, adaptive: false };
        match &self.start {
            Start::Rigid(_) => vec![method("rigid", 2)],
            Start::Carried(world) => {
                // Events are located only to the order of a step's chord; flow and motion are split; gauges with a lag
                // are updated once per step.
                let order = |nominal: u32| match (world.contacts(), self.assembly.has_lines()) {
                    (Contacts::None, _) if lags(&self.assembly) => 1,
                    (Contacts::None, true) => nominal.min(2),
                    (Contacts::None, false) => nominal,
                    _ => 1,
                };
                world.contacts().methods().map(|(name, _, nominal)| method(name, order(nominal))).collect()
            }
        }
    }

    fn scalars(&self) -> &'static [ScalarKind] {
        &[ScalarKind::F64]
    }

    fn agreement(&self) -> f64 {
        if self.smooth().is_some() { AGREEMENT } else { TOUCHING }
    }

    fn run(&self, (method, control, scalar): (&str, Control, ScalarKind), time: Time) -> Result<Trace, Stop> {
        match (control, scalar) {
            (Control::Step(h), ScalarKind::F64) => self.trace(self.takes_method().then_some(method), h, time),
            (_, ScalarKind::F32) => Err("worlds are computed in f64".to_owned().into()),
            (Control::Tolerance(_), _) => Err("worlds take fixed steps, no tolerance".to_owned().into()),
        }
    }

    fn reference(&self, time: Time) -> Result<Trace, Stop> {
        match self.smooth() {
            Some(world) => self.dop853(world, time),
            None => self.halved(time),
        }
    }

    fn second_reference(&self, time: Time) -> Result<(&'static str, Trace), Stop> {
        match self.smooth() {
            Some(world) => Ok(("Dormand-Prince 5(4) at 1e-12", self.dormand_prince(world, time)?)),
            None => Ok(("the same at twice the step", self.trace(None, 2.0 * self.finest.get(), time)?)),
        }
    }

    fn reference_name(&self) -> String {
        match self.smooth() {
            Some(_) => "DOP853 at 1e-13".to_owned(),
            None => format!("its own step at {:.1e} s", self.finest.get()),
        }
    }

    fn closed_form(&self, _: f64) -> Option<(&'static str, Trace)> {
        None
    }

    fn kind(&self) -> Kind {
        Kind::World
    }

    fn sheet(&self) -> Result<Option<Sheet>, String> {
        // A world has only the parts that its scene names: there is no variant with everything.
        Ok(None)
    }

    fn exchanged(&self) -> Option<Exchanged> {
        let (words, other) = exchange::laws(&self.assembly)?;
        let subject = Self::of(&self.name, other).map(|own| Box::new(own) as Box<dyn Subject>);
        Some(Exchanged { words, subject: subject.map_err(|why| why.to_string()) })
    }

    fn graph(&self, limit: Duration) -> Result<String, String> {
        let deadline = Deadline::within(limit);
        let mut assembly = self.assembly.clone();
        // The start has been settled already.
        assembly.run.settled = false;
        assembly.run.every = assembly.run.every.max(assembly.run.steps() / ROWS).max(1);
        let mut start = self.start.clone();
        let engine = start.engine();
        let columns = engine.columns();
        let mut recording = Recording::new(drawn::names(&assembly, &columns).len());
        let note = format!("{}, step {} s", engine.method(), assembly.run.step);
        let emit = |row: &crate::world::run::Row<'_>, _: &mut dyn Engine| {
            recording.push(&drawn::values(row));
            Ok(())
        };
        let events = match run::<Stop>(&assembly, engine, None, emit, |t| deadline.check(t)) {
            Ok(ran) => ran.events,
            Err(Stop::Late { .. }) => Vec::new(),
            Err(Stop::Refused(why)) => return Err(why),
        };
        let shown = drawn::shown(&columns, None).map_err(|e| e.to_string())?;
        Ok(svg::text(&drawn::drawing(&assembly, &columns, &shown, &recording, &note, &events)))
    }
}
