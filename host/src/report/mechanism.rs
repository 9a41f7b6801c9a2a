//! A mechanism as a subject of the report.

use super::clock::{Deadline, Stop};
use super::point::Control;
use super::sheet::Sheet;
use super::sheet_mechanism::{self, Plant64};
use super::subject::{Kind, Method, Subject, Time, Trace};
use crate::engine::{self, EngineKind, EngineScalar, ScalarKind};
use crate::failure::Failure;
use crate::model_argument;
use crate::observers::Observers;
use crate::plot::motion::{self, Motion};
use crate::plot::{Recording, svg};
use crate::run::arguments::Arguments;
use crate::run::settings::{self, Settings};
use crate::run::simulate::{Plant, Row, Setup, columns, simulate};
use crate::run::start::start;
use crate::switches::Switches;
use crate::switches::between::Between;
use clap::ValueEnum;
use smartbed_codegen::model::Model;
use smartbed_codegen::words::count;
use smartbed_codegen::{Interpreted, Program, program};
use std::sync::OnceLock;
use std::time::Duration;

/// A ladder begins at this multiple of the model's own step.
const COARSE: f64 = 32.0;
/// Rows of a graph.
const ROWS: f64 = 500.0;

/// A mechanism with its equations.
pub struct Mechanism {
    name: String,
    pub(super) model: Model,
    pub(super) settings: Settings,
    pub(super) program: Program,
    pub(super) observers: Observers,
    /// What depends on time alone, once it was asked for.
    between: OnceLock<Option<Between>>,
    pub(super) start: Vec<f64>,
    pub(super) engine: EngineKind,
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
        let between = OnceLock::new();
        Ok(Self { name: name.to_owned(), model, settings, program, observers, between, start, engine })
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

    pub(super) fn plant<S: EngineScalar>(
        &self,
        kind: EngineKind,
    ) -> Result<Plant<Box<dyn engine::Engine<S>>, S>, String> {
        let engine = engine::new::<S>(kind, &self.program).map_err(|e| e.to_string())?;
        Ok(Plant::new(engine, &self.program, &self.observers))
    }
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

    fn passes_over(&self, step: f64) -> bool {
        let Settings { seconds, step: own, .. } = self.settings;
        let table = || Between::new(&self.observers, seconds, own).ok().flatten();
        let Some(between) = self.between.get_or_init(table) else { return false };
        let mut switches = Switches::<f64>::new(&self.observers);
        between.passed([seconds, step], &mut switches).is_ok_and(|passed| passed.is_some())
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

    fn reference(&self, time: Time) -> Result<Trace, Stop> {
        self.by_dop853(time)
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
