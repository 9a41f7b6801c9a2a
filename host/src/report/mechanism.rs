//! A mechanism as a subject of the report.

use super::clock;
use super::clock::{Deadline, Stop};
use super::point::Control;
use super::sheet::Sheet;
use super::sheet_mechanism::{self, Plant64};
use super::subject::{Kind, Method, Subject, Time, Trace, parts};
use crate::engine::{self, EngineKind, EngineScalar, ScalarKind, explain};
use crate::failure::Failure;
use crate::model_argument;
use crate::observers::Observers;
use crate::plot::motion::{self, Motion};
use crate::plot::{Recording, svg};
use crate::run::arguments::Arguments;
use crate::run::settings::{self, Settings};
use crate::run::simulate::{Plant, Row, Setup, columns, simulate};
use crate::run::start::start;
use crate::scene::dop853::Dop853;
use clap::ValueEnum;
use smartbed_codegen::model::Model;
use smartbed_codegen::words::count;
use smartbed_codegen::{Interpreted, Program, program};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::ode::State;
use smartbed_runtime::ode::step_size::Tolerance;
use smartbed_runtime::ode::{DormandPrince, dormand_prince};
use std::time::Duration;

/// A ladder begins at this multiple of the model's own step.
const COARSE: f64 = 32.0;
/// Steps between two checks of the clock: a check costs as much as a short step.
const LOOK: usize = 1024;
/// Rows of a graph.
const ROWS: f64 = 500.0;

/// A mechanism with its equations.
pub struct Mechanism {
    name: String,
    model: Model,
    settings: Settings,
    program: Program,
    observers: Observers,
    start: Vec<f64>,
    engine: EngineKind,
}

impl Mechanism {
    /// Reads and derives it, at the model's own settings.
    ///
    /// # Errors
    /// [`Failure::Wrong`] with what is wrong in it.
    pub fn open(name: &str, engine: EngineKind) -> Result<Self, Failure> {
        Self::with(&Arguments { model: name.to_owned(), engine, ..Arguments::default() })
    }

    /// Reads and derives it, with the settings of a run.
    ///
    /// # Errors
    /// [`Failure::Wrong`] with what is wrong in it or in the settings.
    pub fn with(arguments: &Arguments) -> Result<Self, Failure> {
        let (name, engine) = (&arguments.model, arguments.engine);
        let model = model_argument::read(name)?;
        let (model, settings) = Settings::new(&model, arguments)?;
        let model = model.into_owned();
        let wrong = |e| model_argument::wrong(&e);
        let program = program::derive(&model, &settings.choice).map_err(wrong)?;
        let observers = Observers::derive(&model, &settings.choice).map_err(wrong)?;
        let start = start(&model, &program, &settings)?;
        let mut plant: Plant64 = Plant::new(Box::new(Interpreted::new(&program)), &program, &observers);
        let leap = plant
            .leap(&start, settings.seconds, settings.row_interval())
            .map_err(|f| Failure::Wrong(explain(f).to_owned()))?;
        if let Some((command, t)) = leap {
            return Err(Failure::Wrong(format!(
                "{} changes its speed at once at t = {t:.6} s, an impact at which the methods compared \
                 cut no step; write a smooth command, for example with smooth_step, or `run` it",
                command.words(None)
            )));
        }
        Ok(Self { name: name.to_owned(), model, settings, program, observers, start, engine })
    }

    /// Time between two rows of output (s).
    #[must_use]
    pub fn row_interval(&self) -> f64 {
        self.settings.row_interval()
    }

    /// A plant with other equations of the same mechanism, under its laws.
    fn plant_of(&self, program: &Program) -> Result<Plant64, String> {
        let engine = engine::new::<f64>(self.engine, program).map_err(|e| e.to_string())?;
        Ok(Plant::new(engine, program, &self.observers))
    }

    fn plant<S: EngineScalar>(
        &self,
        kind: EngineKind,
    ) -> Result<Plant<Box<dyn engine::Engine<S>>, S>, String> {
        let engine = engine::new::<S>(kind, &self.program).map_err(|e| e.to_string())?;
        Ok(Plant::new(engine, &self.program, &self.observers))
    }

    /// The motion in steps that end at samples.
    fn to_samples(&self, e: f64, Time { seconds, samples: count, limit }: Time) -> Result<Trace, Stop> {
        let deadline = Deadline::within(limit);
        let mut plant: Plant64 = self.plant(self.engine)?;
        let mut x = self.start.clone();
        let (n, n_q) = (x.len(), self.program.q.len());
        let (mut low, mut memory) = (vec![0.0; n], vec![0.0; dormand_prince::scratch(n)]);
        let refused = |fault| explain(fault).to_owned();
        let mut state = State::new(&mut x, &mut low).map_err(refused)?;
        let interval = seconds / count as f64;
        let (first, tolerance) = (self.settings.step.min(interval), Tolerance { absolute: e, relative: e });
        let begin = clock::now();
        let mut method = DormandPrince::new(n, tolerance, first, &mut memory).map_err(refused)?;
        let (mut t, mut samples) = (0.0, Vec::with_capacity(count));
        for i in 1..=count {
            let end = i as f64 * interval;
            loop {
                let before = t;
                match method.advance_to(&mut plant, &mut t, end, LOOK as u32, &mut state) {
                    Ok(_) => break,
                    // The limit of steps was reached, but time advanced.
                    Err(Fault::StepSize) if t > before => deadline.check(t)?,
                    Err(fault) => return Err(refused(fault).into()),
                }
            }
            samples.push(state.x()[..n_q].to_vec());
        }
        Ok(Trace { samples, evaluations: Some(plant.evaluations()), elapsed: clock::now() - begin })
    }

    fn trace<S: EngineScalar>(
        &self,
        method: settings::Method,
        control: Control,
        time: Time,
    ) -> Result<Trace, Stop> {
        let deadline = Deadline::within(time.limit);
        let mut plant = self.plant::<S>(self.engine)?;
        let mut x: Vec<S> = self.start.iter().map(|x| S::from_f64(*x)).collect();
        let (n, n_q) = (x.len(), self.program.q.len());
        let mut low = vec![S::ZERO; n];
        let mut state = State::new(&mut x, &mut low).map_err(|f| explain(f).to_owned())?;
        let mut samples = Vec::with_capacity(time.samples);
        let mut keep = |x: &[S]| samples.push(x[..n_q].iter().map(|x| x.to_f64()).collect());
        let interval = time.seconds / time.samples as f64;
        let refused = |fault| explain(fault).to_owned();
        let begin = clock::now();
        match (method.fixed(), control) {
            (Some(fixed), Control::Step(longest)) => {
                let steps = parts(interval, longest);
                let mut scratch = vec![S::ZERO; fixed.scratch(n)];
                let h = interval / steps as f64;
                for i in 0..time.samples * steps {
                    let t = S::from_f64(i as f64 * h);
                    fixed.step(&mut plant, t, S::from_f64(h), &mut state, &mut scratch).map_err(refused)?;
                    if i % LOOK == 0 {
                        deadline.check(t.to_f64())?;
                    }
                    if (i + 1) % steps == 0 {
                        keep(state.x());
                    }
                }
            }
            (None, Control::Tolerance(e)) => {
                let tolerance = Tolerance { absolute: S::from_f64(e), relative: S::from_f64(e) };
                let mut memory = vec![S::ZERO; dormand_prince::scratch(n)];
                let first = S::from_f64(self.settings.step);
                let mut method = DormandPrince::new(n, tolerance, first, &mut memory).map_err(refused)?;
                free(&mut method, &mut plant, (time, &deadline), &mut state, keep)?;
            }
            _ => return Err("a fixed method needs a step, an adaptive one a tolerance".to_owned().into()),
        }
        Ok(Trace { samples, evaluations: Some(plant.evaluations()), elapsed: clock::now() - begin })
    }
}

/// Takes the steps that `run` takes, which passes over samples and interpolates there: at a kink of a force the error
/// depends on where steps end, and would be another one if they ended at samples.
fn free<S: EngineScalar>(
    method: &mut DormandPrince<'_, S>,
    plant: &mut Plant<Box<dyn engine::Engine<S>>, S>,
    (Time { seconds, samples, .. }, deadline): (Time, &Deadline),
    state: &mut State<'_, S>,
    mut keep: impl FnMut(&[S]),
) -> Result<(), Stop> {
    let refused = |fault| explain(fault).to_owned();
    let mut inside = vec![S::ZERO; state.x().len()];
    let (mut t, mut next) = (0.0, 1);
    for n in 0.. {
        if next > samples {
            break;
        }
        let left = seconds - t;
        let taken = method.step(plant, S::from_f64(t), S::from_f64(left), state).map_err(refused)?;
        let h = taken.h.to_f64();
        let end = if h >= left * (1.0 - f64::from(f32::EPSILON)) { seconds } else { t + h };
        while next <= samples {
            let at = if next == samples { seconds } else { seconds * next as f64 / samples as f64 };
            if at > end {
                break;
            }
            if at < end {
                method.dense(S::from_f64((at - t) / h), &mut inside).map_err(refused)?;
                plant.set_time(S::from_f64(at));
                plant.project(&mut inside).map_err(refused)?;
                keep(&inside);
            } else {
                keep(state.x());
            }
            next += 1;
        }
        t = end;
        if n % LOOK == 0 {
            deadline.check(t)?;
        }
    }
    Ok(())
}

impl Subject for Mechanism {
    fn name(&self) -> &str {
        &self.name
    }

    fn title(&self) -> String {
        let (q, u) =
            (count(self.program.q.len(), "coordinate"), count(self.program.u.len(), "independent speed"));
        format!("{} ({q}, {u})", self.model.doc)
    }

    fn seconds(&self) -> f64 {
        self.settings.seconds
    }

    fn coarsest_step(&self, _: &str) -> f64 {
        COARSE * self.settings.step
    }

    fn is_smooth(&self) -> bool {
        true
    }

    fn weight(&self) -> f64 {
        1.0
    }

    fn methods(&self) -> Vec<Method> {
        let order = |m: settings::Method| match m {
            settings::Method::Euler | settings::Method::SemiImplicit => 1,
            settings::Method::Rk4 => 4,
            settings::Method::DormandPrince => 5,
        };
        let all = settings::Method::value_variants().iter();
        all.map(|m| Method { name: m.name(), order: order(*m), adaptive: m.fixed().is_none() }).collect()
    }

    fn run(&self, (method, control, scalar): (&str, Control, ScalarKind), time: Time) -> Result<Trace, Stop> {
        let method = settings::Method::from_str(method, false)
            .map_err(|_| format!("there is no method `{method}`"))?;
        match scalar {
            ScalarKind::F32 => self.trace::<f32>(method, control, time),
            ScalarKind::F64 => self.trace::<f64>(method, control, time),
        }
    }

    /// Without projections: at this tolerance the constraints remain satisfied up to rounding.
    fn reference(&self, Time { seconds, samples: count, limit }: Time) -> Result<Trace, Stop> {
        let deadline = Deadline::within(limit);
        let mut plant: Plant64 = self.plant(EngineKind::Interpreter)?;
        let mut fault = None;
        let begin = clock::now();
        let rates = |t: f64, x: &[f64], x_dot: &mut [f64]| {
            if let Err(f) = plant.rates(t, x, x_dot) {
                fault = Some(f);
                x_dot.fill(f64::NAN);
            }
        };
        let mut solver = Dop853::new(rates, 0.0, self.start.clone(), 1e-13, self.settings.step);
        let mut samples = Vec::new();
        for i in 1..=count {
            let end = seconds * i as f64 / count as f64;
            while solver.t < end {
                solver.advance(end).map_err(|t| format!("t = {t} s: no step of DOP853 was small enough"))?;
                deadline.check(solver.t)?;
            }
            samples.push(solver.y[..self.program.q.len()].to_vec());
        }
        let evaluations = Some(solver.evaluations as u64);
        Ok(Trace { samples, evaluations, elapsed: clock::now() - begin })
    }

    fn second_reference(&self, time: Time) -> Result<(&'static str, Trace), Stop> {
        Ok(("Dormand-Prince 5(4) at 1e-12", self.to_samples(1e-12, time)?))
    }

    fn closed_form(&self, _: f64) -> Option<(&'static str, Trace)> {
        None
    }

    fn kind(&self) -> Kind {
        Kind::Mechanism
    }

    fn sheet(&self) -> Result<Option<Sheet>, String> {
        sheet_mechanism::make((&self.model, &self.program), (&self.start, self.settings.step), |program| {
            self.plant_of(program)
        })
        .map(Some)
    }

    fn graph(&self, limit: Duration) -> Result<String, String> {
        let (deadline, mut is_late) = (Deadline::within(limit), false);
        let mut settings = self.settings.clone();
        settings.every = ((settings.seconds / settings.step / ROWS) as usize).max(settings.every);
        let setup = Setup {
            program: &self.program,
            observers: &self.observers,
            settings: &settings,
            start: &self.start,
        };
        let names = columns(&self.program, &self.observers);
        let mut recording = Recording::new(names.len());
        let engine = Box::new(Interpreted::<f64>::new(&self.program));
        let done = simulate::<f64>(setup, engine, |row: &Row| {
            recording.push(&row.values);
            let looked = deadline.check(row.values[0]);
            is_late = looked.is_err();
            looked.map_err(|stop| Failure::Wrong(stop.to_string()))
        });
        if let (Err(why), false) = (done, is_late) {
            return Err(why.to_string());
        }
        let motion = Motion {
            model: &self.model,
            names: &names,
            recording: &recording,
            note: &settings.note(),
            crossings: &[],
            show: None,
            noise: ScalarKind::F64.noise(),
        };
        Ok(svg::text(&motion::draw(&motion).map_err(|e| e.to_string())?))
    }
}
