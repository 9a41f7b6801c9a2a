//! What is derived of the mechanisms of a world, once for all parts that have the same model and use the same ports.
//!
//! In: mechanisms and the ports that the scene uses of them, one after the other; only these are derived. Out: the
//! programs of their motion, ports and observers, and their start. A bed has 28 tiles of one model.

use crate::configuration::Configurations;
use crate::observers::Observers;
use smartbed_codegen::model::{Model, StartRef};
use smartbed_codegen::{Asked, Function, ParameterChoice, Program, Request, program};
use std::sync::Arc;

/// The answers needed for each port.
const PARTS: [&str; 5] = ["position", "rotation", "twist", "inverse_inertia", "jacobian"];

/// Equations with ports.
#[derive(Debug)]
pub struct Derived {
    /// The model, and the ports in use.
    pub(super) model: Model,
    pub(super) ports: Vec<String>,
    /// Its motion and the answers of its ports.
    pub(super) program: Program,
    /// What is observed beside it.
    pub(super) observers: Observers,
    /// By port: index of the first input of its wrench.
    pub(super) wrenches: Vec<usize>,
    /// First numbers of each port's answers: position, rotation, twist, inverse inertia, Jacobian.
    pub(super) first: Vec<[usize; 5]>,
    /// Where it starts.
    pub(super) start: Start,
}

/// The start of a mechanism.
#[derive(Clone, PartialEq, Debug)]
pub struct Start {
    /// Coordinates.
    pub q: Vec<f64>,
    /// Independent speeds.
    pub u: Vec<f64>,
}

impl Derived {
    /// Derives equations with these ports, and what stands in the model beside them.
    ///
    /// # Errors
    /// If the model cannot be derived, or its start cannot be assembled.
    pub(super) fn new(model: &Model, ports: &[String]) -> Result<Self, String> {
        let choice = ParameterChoice::default();
        let request = |name: &String| format!("port:{name}").parse::<Request>().map_err(|e| e.to_string());
        let requests = ports.iter().map(request).collect::<Result<Vec<Request>, String>>()?;
        let functions = match requests.is_empty() {
            true => Vec::new(),
            false => vec![Function { name: "ports".to_owned(), requests }],
        };
        let asked = Asked::besides(functions);
        let program = program::derive_asked(model, &choice, program::Settings::default(), &asked)
            .map_err(|found| found.to_string())?;
        if program.is_redundant() {
            return Err(
                "its motion passes dead points of its independent speeds, so that it cannot be part of a \
                        world; `run` its model instead"
                    .to_owned(),
            );
        }
        let wrenches = ports.iter().map(|port| input(&program, &format!("{port}_force_x")));
        Ok(Self {
            model: model.clone(),
            ports: ports.to_vec(),
            observers: Observers::derive(model, &choice).map_err(|found| found.to_string())?,
            wrenches: wrenches.collect::<Result<_, _>>()?,
            first: answers(&program)?,
            start: start(model, &program)?,
            program,
        })
    }
}

/// What has been derived so far.
#[derive(Default)]
pub(super) struct Derivations(Vec<Arc<Derived>>);

impl Derivations {
    /// What is derived of a model with these ports, derived now if no part before had the same.
    ///
    /// # Errors
    /// As [`Derived::new`].
    pub(super) fn of(&mut self, model: &Model, ports: &[String]) -> Result<Arc<Derived>, String> {
        if let Some(known) = self.0.iter().find(|known| known.ports == ports && known.model == *model) {
            return Ok(Arc::clone(known));
        }
        let derived = Arc::new(Derived::new(model, ports)?);
        self.0.push(Arc::clone(&derived));
        Ok(derived)
    }
}

/// Indices at which the answers of each port begin.
fn answers(program: &Program) -> Result<Vec<[usize; 5]>, String> {
    let (mut first, mut place) = (Vec::new(), 0);
    let Some(function) = program.functions.first() else { return Ok(first) };
    for answer in program.answers_of(function) {
        let mut own = [usize::MAX; 5];
        for part in &answer.parts {
            if let Some(which) = PARTS.iter().position(|name| *name == part.name) {
                own[which] = place;
            }
            place += part.values.len();
        }
        if own.contains(&usize::MAX) {
            return Err("a port does not answer where it is and what it yields".to_owned());
        }
        first.push(own);
    }
    Ok(first)
}

fn input(program: &Program, name: &str) -> Result<usize, String> {
    let place = program.inputs.iter().position(|input| input.name == name);
    place.ok_or_else(|| format!("the derived equations have no input `{name}`"))
}

/// The model's own start: coordinates that are left out are nominal, dependent ones are solved for.
fn start(model: &Model, program: &Program) -> Result<Start, String> {
    let given = |name: &str| {
        model.start.iter().find_map(|(owner, value)| {
            let own = match owner {
                StartRef::Coordinate(id) => &model.coordinates[*id].name,
                StartRef::Speed(id) => &model.speeds[*id].name,
            };
            (own == name).then_some(*value)
        })
    };
    let parameters: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let wanted: Vec<Option<f64>> = program.q.iter().map(|q| given(&q.name)).collect();
    let q = Configurations::new(model, program)
        .solve(&parameters, &wanted)
        .map_err(|why| format!("the start cannot be assembled: {why}"))?;
    let u = program.u.iter().map(|u| given(&u.name).unwrap_or(0.0)).collect();
    Ok(Start { q, u })
}
