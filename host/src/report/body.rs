//! A scene of a flexible body as a subject of the report.

use super::clock::{Deadline, Stop};
use super::point::Control;
use super::sheet::Sheet;
use super::subject::{Kind, Method, Subject, Time, Trace, parts};
use super::{clock, closed_form, sheet_body};
use crate::engine::ScalarKind;
use crate::failure::Failure;
use crate::plot::svg;
use crate::scene::describe::describe;
use crate::scene::graph::Drawings;
use crate::scene::method::{METHODS, Situation};
use crate::scene::run::{Row, run_until};
use crate::scene::{Scene, Simulation, read};
use smartbed_codegen::words::count;
use smartbed_runtime::real::Scalar;
use std::time::Duration;

/// Fraction of the largest stable step with which a ladder begins.
const STABLE: f64 = 0.9;
/// In free fall, adaptive methods use at most this step (s): their error estimate does not see the stable step there,
/// and beyond it rounding errors grow.
const OUTER_STEP: f64 = 1e-2;
/// Largest step of the references (s), so that rounding is amplified less.
const REFERENCE_STEP: f64 = 1e-3;
/// Springs stepped between two checks of the clock.
const LOOK: usize = 20_000;
/// Rows of a graph.
const ROWS: usize = 500;

/// A scene, read again for every method and step because its checks depend on them.
#[derive(Clone, Debug)]
pub struct Body {
    name: String,
    path: String,
    settings: Vec<String>,
    scene: Scene,
    in_steps_of_rows: bool,
}

impl Body {
    /// Reads it; `settings` are changes `key=value`.
    ///
    /// # Errors
    /// [`Failure::Wrong`] with what is wrong in it.
    pub fn open(name: &str, path: &str, settings: &[String]) -> Result<Self, Failure> {
        let scene = read::open(path, settings).map_err(Failure::Wrong)?;
        Ok(Self {
            name: name.to_owned(),
            path: path.to_owned(),
            settings: settings.to_vec(),
            scene,
            in_steps_of_rows: false,
        })
    }

    /// Adaptive methods take the outer steps that `run` takes, which are the scene's own.
    #[must_use]
    pub fn in_steps_of_rows(self) -> Self {
        Self { in_steps_of_rows: true, ..self }
    }

    /// The scene as read.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    fn with(&self, method: &str, tolerance: f64, step: f64) -> Result<Scene, String> {
        let is_moreau = self.scene.chosen.name == "moreau";
        if is_moreau && method != "moreau" {
            return Err("law = \"moreau\" takes steps of its own, for which no method gives a reference: it is not measured; give \
                        --step instead, or take another law"
                .to_owned());
        }
        let mut variation = vec![format!("step={step:e}")];
        // Moreau's law is a time-stepping scheme of its own: there is no method to be named.
        if method != "moreau" {
            variation.push(format!("method={method}"));
        }
        if METHODS.iter().any(|(name, _, adaptive)| *name == method && *adaptive) {
            variation.push(format!("tolerance={tolerance:e}"));
        }
        read::open_varied(&self.path, &self.settings, &variation)
    }

    fn trace(
        &self,
        (method, control, scalar): (&str, Control, ScalarKind),
        time: Time,
        outer: f64,
    ) -> Result<Trace, Stop> {
        let (tolerance, longest) = match control {
            Control::Step(h) => (1e-9, h),
            Control::Tolerance(e) => (e, outer),
        };
        let steps = parts(time.seconds / time.samples as f64, longest);
        let scene = self.with(method, tolerance, time.seconds / (time.samples * steps) as f64)?;
        match scalar {
            ScalarKind::F32 => trace::<f32>(&scene, steps, time),
            ScalarKind::F64 => trace::<f64>(&scene, steps, time),
        }
    }
}

/// Steps to the end, with `steps` per sample.
fn trace<S: Scalar>(scene: &Scene, steps: usize, time: Time) -> Result<Trace, Stop> {
    // A check of the clock costs as much as a hundred springs.
    let looks = (LOOK / scene.lists.springs.len().max(1)).max(1);
    let deadline = Deadline::within(time.limit);
    let mut simulation =
        Simulation::<S>::new(&scene.lists, &scene.around, scene.method).map_err(|e| describe(&e))?;
    let h = S::from_f64(scene.step);
    let (mut samples, mut evaluations) = (Vec::with_capacity(time.samples), 0);
    let begin = clock::now();
    simulation.begin(h, &mut ()).map_err(|e| describe(&e))?;
    for sample in 0..time.samples {
        for step in 0..steps {
            let report = simulation.step(h, &mut ()).map_err(|e| describe(&e))?;
            if report.cut_short {
                return Err("too many events or substeps in a step, its end was not located"
                    .to_owned()
                    .into());
            }
            evaluations += report.evaluations as u64;
            if (sample * steps + step).is_multiple_of(looks) {
                deadline.check(simulation.t().to_f64())?;
            }
        }
        samples.push(simulation.pos().as_flattened().iter().map(|x| x.to_f64()).collect());
    }
    Ok(Trace { samples, evaluations: Some(evaluations), elapsed: clock::now() - begin })
}

impl Subject for Body {
    fn name(&self) -> &str {
        &self.name
    }

    fn title(&self) -> String {
        let lists = &self.scene.lists;
        let (points, springs) = (count(lists.points.len(), "point"), count(lists.springs.len(), "spring"));
        format!("{}: {points}, {springs}", self.scene.title)
    }

    fn seconds(&self) -> f64 {
        self.scene.seconds
    }

    fn coarsest_step(&self, method: &str) -> f64 {
        let Scene { lists, around, .. } = &self.scene;
        let largest = read::largest_step(lists, around, method).ok().flatten();
        largest.map_or(OUTER_STEP, |h| STABLE * h)
    }

    fn is_smooth(&self) -> bool {
        self.scene.around.ground.is_none()
    }

    fn weight(&self) -> f64 {
        self.scene.lists.springs.len() as f64
    }

    fn methods(&self) -> Vec<Method> {
        let situation = Situation::new(&self.scene.around, &self.scene.lists.damping, 0.0);
        let method =
            |(name, order, adaptive): (&str, u32, bool)| Method { name: name.to_owned(), order, adaptive };
        situation.methods().into_iter().map(method).collect()
    }

    fn run(&self, how: (&str, Control, ScalarKind), time: Time) -> Result<Trace, Stop> {
        let outer = match (self.in_steps_of_rows, self.is_smooth()) {
            (true, _) => self.scene.step,
            (_, true) => time.seconds,
            (_, false) => OUTER_STEP.min(self.coarsest_step(how.0)),
        };
        self.trace(how, time, outer)
    }

    fn reference(&self, time: Time) -> Result<Trace, Stop> {
        let how = ("dop853", Control::Tolerance(1e-13), ScalarKind::F64);
        self.trace(how, time, REFERENCE_STEP.min(self.coarsest_step(how.0)))
    }

    fn second_reference(&self, time: Time) -> Result<(&'static str, Trace), Stop> {
        let how = ("dormand_prince", Control::Tolerance(1e-12), ScalarKind::F64);
        let trace = self.trace(how, time, REFERENCE_STEP.min(self.coarsest_step(how.0)))?;
        Ok(("Dormand-Prince 5(4) at 1e-12", trace))
    }

    fn closed_form(&self, seconds: f64) -> Option<(&'static str, Trace)> {
        closed_form::of(&self.name, &self.scene, seconds)
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn sheet(&self) -> Result<Option<Sheet>, String> {
        sheet_body::make(&self.scene, &self.path, &self.settings).map(Some)
    }

    fn graph(&self, limit: Duration) -> Result<String, String> {
        let deadline = Deadline::within(limit);
        let mut scene = self.scene.clone();
        scene.every = scene.every.max(scene.steps() / ROWS).max(1);
        let mut drawings = Drawings::new(&scene, None, &scene.note()).map_err(|e| e.to_string())?;
        let push = |row: &Row| {
            drawings.push(row);
            Ok(())
        };
        let events = match run_until::<f64, Stop>(&scene, push, |t| deadline.check(t)) {
            Ok(events) => events,
            Err(Stop::Late { .. }) => Vec::new(),
            Err(Stop::Refused(why)) => return Err(why),
        };
        Ok(svg::text(&drawings.draw(&scene, &events)))
    }
}
