//! The catalogue of answers that a program can be asked for, and how each is derived.
//!
//! In: requests such as `mass_matrix` or `pose:platform`. Out: [`Answer`]s, named parts of expressions over the
//! program's DAG. Interpreter, emitted files, `eval`, `check` and the command line know answers only through this list:
//! a new one is a function that returns its parts, and an entry of [`CATALOGUE`]. An answer that is not asked for is
//! not derived.

mod accelerations;
mod inertia;
mod law;
mod linear;
mod momentum;
mod motion;
pub(super) mod part;
mod reaction;
pub(super) mod request;
mod stages;
mod standing;

use super::derived::Program;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::ExprId;
use crate::kinematics::Marker;
use crate::model::{Model, Port};
pub use part::{Answer, Part, Shape};
pub use request::{Asked, Function, Request};
pub use stages::{Stages, Target};
use std::borrow::Cow;

/// An entry of the catalogue.
#[derive(Debug)]
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// What it returns, in a sentence.
    pub doc: &'static str,
    /// What must be named after the colon.
    pub about: About,
    /// The last stage that it needs.
    pub needs: Needs,
    derive: Derive,
}

/// The subject of an answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum About {
    /// The mechanism as a whole.
    Mechanism,
    /// A port, a point, a frame, or `frame@point`.
    Place,
    /// A port, whose wrench becomes six further inputs.
    Port,
}

/// The last stage that an answer needs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Needs {
    /// Positions, velocities, constraints: no masses.
    Motion,
    /// Mass matrix and forces.
    Masses,
    /// u'.
    Accelerations,
}

/// The function that derives an answer, and its kind.
#[derive(Clone, Copy, Debug)]
enum Derive {
    /// From the data of every program; emitted as a tuple.
    Standing(fn(&Program) -> Vec<Part>),
    /// On request; emitted as a struct.
    Asked(fn(&mut Stages, &Target) -> Result<Vec<Part>, Diagnostic>),
    /// On request, with symbols for u' during the derivation; u' is no argument of the emitted function.
    Held(fn(&mut Stages, &Target) -> Result<Vec<Part>, Diagnostic>),
    /// On request, with u' as an argument of the emitted function.
    Given(fn(&mut Stages, &Target) -> Result<Vec<Part>, Diagnostic>),
}

use About::{Mechanism, Place as OfPlace, Port as OfPort};
use Needs::{Accelerations, Masses, Motion};

const fn kind(name: &'static str, about: About, needs: Needs, derive: Derive, doc: &'static str) -> Kind {
    Kind { name, doc, about, needs, derive }
}

/// All answers. Those that every program has come first, in the order of the emitted file.
#[rustfmt::skip]
pub const CATALOGUE: &[Kind] = &[
    kind("rates", Mechanism, Accelerations, Derive::Standing(standing::rates),
        "Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal."),
    kind("energy", Mechanism, Masses, Derive::Standing(standing::energy),
        "Kinetic and potential energy (J)."),
    kind("speeds", Mechanism, Motion, Derive::Standing(standing::speeds),
        "All speeds in the order of `SPEED_NAMES`, dependent ones included."),
    kind("outputs", Mechanism, Motion, Derive::Standing(standing::outputs),
        "Requested outputs in the order of `OUTPUT_NAMES`."),
    kind("projection", Mechanism, Motion, Derive::Standing(standing::projection),
        "Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them."),
    kind("speed_projection", Mechanism, Motion, Derive::Standing(standing::speed_projection),
        "Corrections of the speeds, all of which are state where the motion passes dead points of the independent ones."),
    kind("drive", Mechanism, Accelerations, Derive::Standing(standing::drive),
        "Power that what drives the mechanism puts in (W)."),
    kind("augmented", Mechanism, Masses, Derive::Standing(standing::augmented),
        "Mass matrix M, Jacobian J (row-major), forcing f and bias b of M y' - J' lambda = f, J y' = -b, y as in `UNKNOWN_NAMES`."),
    kind("mass_matrix", Mechanism, Masses, Derive::Asked(inertia::mass_matrix),
        "Mass matrix of the independent speeds: M u' + bias = forces of the inputs."),
    kind("bias", Mechanism, Masses, Derive::Asked(inertia::bias),
        "Bias of M u' + bias = forces of the inputs, of which it holds none."),
    kind("forcing", Mechanism, Masses, Derive::Asked(inertia::forcing),
        "Forcing f of M u' = f, with the forces of the inputs."),
    kind("inverse_dynamics", Mechanism, Masses, Derive::Given(inertia::inverse_dynamics),
        "Forces that give the independent speeds the accelerations `u_dot`, against the given wrench of a port too, and the inputs that supply them where there are as many and their map is regular."),
    kind("power", Mechanism, Motion, Derive::Asked(inertia::power),
        "Power of every load and of the weight."),
    kind("momentum", Mechanism, Motion, Derive::Asked(momentum::momentum),
        "Mass, mass centre, momentum, and moment of momentum about O."),
    kind("law", Mechanism, Motion, Derive::Asked(law::law),
        "Inputs as the model's law commands them."),
    kind("multipliers", Mechanism, Accelerations, Derive::Asked(inertia::multipliers),
        "Lagrange's multipliers of the constraint rows (thesis Eq. 2.4); they depend on how the rows are written and are no joint reactions."),
    kind("linearisation", Mechanism, Accelerations, Derive::Held(linear::linearisation),
        "A, B, C and D at the state: x' = A dx + B dinputs, outputs = C dx + D dinputs, dependent coordinates following the constraints."),
    kind("parameter_derivatives", Mechanism, Accelerations, Derive::Held(linear::parameter_derivatives),
        "Derivatives of the accelerations by the tunable parameters."),
    kind("pose", OfPlace, Motion, Derive::Asked(motion::pose),
        "Position of the point from O, and the frame's axes, along N's axes."),
    kind("twist", OfPlace, Motion, Derive::Asked(motion::twist),
        "Velocity of the point and angular velocity of the frame in N, along N's axes."),
    kind("bias_acceleration", OfPlace, Motion, Derive::Asked(motion::bias_acceleration),
        "Acceleration of the point and angular acceleration of the frame where the independent speeds stay as they are."),
    kind("jacobian", OfPlace, Motion, Derive::Asked(motion::jacobian),
        "Partial velocities of the point and the frame: twist = J u, and what time alone moves."),
    kind("inverse_inertia", OfPlace, Masses, Derive::Asked(motion::inverse_inertia),
        "Inverse of the inertia felt at the place: change of twist = (J M^-1 J') impulse."),
    kind("reaction", OfPlace, Accelerations, Derive::Asked(reaction::reaction),
        "What a joint that is cut there transmits: force and moment on the outer side, without what loads at the joint state."),
    kind("port", OfPort, Masses, Derive::Asked(motion::port),
        "Pose, twist, bias acceleration, Jacobian and inverse inertia of a port; its wrench is six more inputs."),
];

/// The entry with this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Kind> {
    CATALOGUE.iter().find(|kind| kind.name == name)
}

impl Kind {
    /// Does every program have it?
    #[must_use]
    pub fn is_standing(&self) -> bool {
        matches!(self.derive, Derive::Standing(_))
    }

    /// Is the answer meaningful for independent speeds only?
    fn takes_independent(&self) -> bool {
        !self.is_standing() && self.needs != Needs::Motion
    }
}

fn redundant(request: &Request) -> Diagnostic {
    Diagnostic::error(format!(
        "`{request}`: the motion passes dead points of the independent speeds, so that all speeds are state"
    ))
    .help(
        "this answer needs independent speeds: choose such as pass no dead point, or keep it out of `range`; \
         `derive --form augmented` gives masses and constraints of all speeds",
    )
}

/// The requested answers as a program holds them.
#[derive(Default)]
pub(super) struct Answered {
    pub answers: Vec<Answer>,
    pub functions: Vec<Function>,
    pub u_dot: Vec<ExprId>,
}

/// A request with its catalogue entry and its subject.
pub(super) struct Resolved<'m> {
    request: Request,
    pub kind: &'static Kind,
    marker: Option<Marker>,
    /// The port whose wrench becomes six inputs.
    pub wrench: Option<&'m Port>,
}

/// Errors for function names that have two meanings, and for functions that ask for an answer twice.
fn ambiguous(functions: &[Function]) -> impl Iterator<Item = Diagnostic> {
    functions.iter().enumerate().filter_map(|(place, function)| {
        let Function { name, requests } = function;
        let is_own = matches!(&requests[..], [request] if request.to_string() == *name);
        if functions[..place].iter().any(|other| other.name == *name) {
            let error = Diagnostic::error(format!("two functions are named `{name}`"));
            return Some(error.help("ask once, or give one another name: `other = ...`"));
        }
        if find(name).is_some_and(|kind| kind.about == About::Mechanism) && !is_own {
            let error = Diagnostic::error(format!("the function `{name}` would not be the answer `{name}`"));
            return Some(error.help("that is the name of another answer: choose one of your own"));
        }
        function.distinct().err()
    })
}

/// Looks up the names in all requests.
pub(super) fn resolve<'m>(model: &'m Model, asked: &Asked) -> Result<Vec<Resolved<'m>>, Diagnostics> {
    let mut found = Diagnostics::new(model.source.clone());
    ambiguous(&asked.functions).for_each(|error| found.push(error));
    let mut resolved = Vec::new();
    for request in asked.requests() {
        match resolve_one(model, request) {
            Ok(one) => resolved.push(one),
            Err(error) => found.push(error),
        }
    }
    if found.has_errors() { Err(found) } else { Ok(resolved) }
}

fn resolve_one(model: &Model, request: Request) -> Result<Resolved<'_>, Diagnostic> {
    let Some(kind) = find(&request.answer) else {
        let names: Vec<&str> = CATALOGUE.iter().map(|kind| kind.name).collect();
        return Err(Diagnostic::error(format!("no such answer: `{request}`"))
            .help(format!("expected one of {}", names.join(", "))));
    };
    let port = |name: &str| model.ports.iter().find(|port| port.name == name);
    let (marker, wrench) = match (kind.about, request.of.as_deref()) {
        (About::Mechanism, None) => (None, None),
        (About::Mechanism, Some(_)) => {
            return Err(Diagnostic::error(format!(
                "`{request}`: this answer is about the mechanism as a whole"
            ))
            .help(format!("ask for `{}`", kind.name)));
        }
        (_, None) => {
            return Err(Diagnostic::error(format!("`{request}`: of what?")).help(format!(
                "name it behind a colon: `{}:G`; {}",
                kind.name,
                known(model, kind.about)
            )));
        }
        (About::Port, Some(name)) => match port(name) {
            Some(port) => (Some(Marker { point: Some(port.point), frame: Some(port.frame) }), Some(port)),
            None => return Err(unknown(model, &request, kind.about)),
        },
        (About::Place, Some(name)) => match marker_of(model, name) {
            Some(marker) => (Some(marker), None),
            None => return Err(unknown(model, &request, kind.about)),
        },
    };
    Ok(Resolved { request, kind, marker, wrench })
}

/// Looks up a port, a point, a frame, or `frame@point`. A name of both a point and a frame refers to both.
fn marker_of(model: &Model, name: &str) -> Option<Marker> {
    let frame = |name: &str| model.frames.enumerate().find(|(_, f)| f.name == name).map(|(id, _)| id);
    let point = |name: &str| model.points.enumerate().find(|(_, p)| p.name == name).map(|(id, _)| id);
    if let Some(port) = model.ports.iter().find(|port| port.name == name) {
        return Some(Marker { point: Some(port.point), frame: Some(port.frame) });
    }
    if let Some((of, at)) = name.split_once('@') {
        return Some(Marker { frame: Some(frame(of)?), point: Some(point(at)?) });
    }
    let marker = Marker { point: point(name), frame: frame(name) };
    (marker.point.is_some() || marker.frame.is_some()).then_some(marker)
}

fn unknown(model: &Model, request: &Request, about: About) -> Diagnostic {
    let what = match about {
        About::Port => "port",
        _ => "port, point or frame",
    };
    Diagnostic::error(format!("`{request}`: the model has no such {what}")).help(known(model, about))
}

fn known(model: &Model, about: About) -> String {
    let list = |names: Vec<&str>| if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    let ports = list(model.ports.iter().map(|p| p.name.as_str()).collect());
    if about == About::Port {
        return format!(
            "ports of the model: {ports}; a port is declared as [ports] platform = {{ frame = \"F\", point = \"P\" }}"
        );
    }
    let points = list(model.points.iter().map(|p| p.name.as_str()).collect());
    let frames = list(model.frames.iter().map(|f| f.name.as_str()).collect());
    format!("ports: {ports}; points: {points}; frames: {frames}; a point of a frame: `frame@point`")
}

/// The model with the wrenches at the requested ports as further inputs.
pub(super) fn with_wrenches<'m>(
    model: &'m Model,
    resolved: &[Resolved],
) -> Result<Cow<'m, Model>, Diagnostics> {
    let mut pushed = Cow::Borrowed(model);
    let mut done: Vec<&str> = Vec::new();
    for port in resolved.iter().filter_map(|one| one.wrench) {
        if !done.contains(&port.name.as_str()) {
            let with = pushed.with_wrench(port).map_err(|e| Diagnostics::one(model.source.clone(), e))?;
            pushed = Cow::Owned(with);
            done.push(&port.name);
        }
    }
    Ok(pushed)
}

/// Does any answer need symbols for u'?
pub(super) fn holds_u_dot(resolved: &[Resolved]) -> bool {
    resolved.iter().any(|one| matches!(one.kind.derive, Derive::Given(_) | Derive::Held(_)))
}

/// Derives the requested answers.
pub(super) fn derive(
    stages: &mut Stages,
    resolved: &[Resolved],
    asked: &Asked,
) -> Result<Answered, Diagnostics> {
    let mut found = Diagnostics::new(stages.model.source.clone());
    let mut answers = Vec::new();
    for Resolved { request, kind, marker, .. } in resolved {
        if kind.takes_independent() && !stages.solution.ties.is_empty() {
            found.push(redundant(request));
            continue;
        }
        let (derive, takes_u_dot) = match kind.derive {
            Derive::Standing(_) => continue,
            Derive::Asked(derive) | Derive::Held(derive) => (derive, false),
            Derive::Given(derive) => (derive, true),
        };
        let target = Target { request: request.to_string(), marker: *marker };
        match derive(stages, &target) {
            Ok(parts) => answers.push(Answer {
                name: target.request,
                doc: kind.doc.to_owned(),
                parts,
                is_tuple: false,
                takes_u_dot,
            }),
            Err(error) => found.push(error),
        }
    }
    if found.has_errors() {
        return Err(found);
    }
    // u' becomes an argument only if some function takes it.
    let is_argument = answers.iter().any(|answer| answer.takes_u_dot);
    let u_dot = if is_argument { stages.u_dot.clone() } else { Vec::new() };
    Ok(Answered { answers, functions: asked.functions.clone(), u_dot })
}

impl Program {
    /// If nothing but the requests is wanted, removes everything else.
    pub(super) fn keep_only(&mut self, asked: &Asked) {
        if !asked.only {
            return;
        }
        let is_wanted = |name: &str| asked.requests().iter().any(|r| r.answer == name);
        let nothing = self.dag.zero();
        if !is_wanted("rates") {
            self.rates.q_dot.iter_mut().chain(&mut self.rates.u_dot).for_each(|e| *e = nothing);
            self.rates.worst_pivot = self.dag.one();
        }
        if !is_wanted("energy") {
            self.energy = [nothing; 2];
        }
        for (name, list) in [("speeds", &mut self.speeds), ("outputs", &mut self.outputs)] {
            if !is_wanted(name) {
                list.iter_mut().for_each(|(_, e)| *e = nothing);
            }
        }
        if !is_wanted("projection") {
            self.correction.iter_mut().for_each(|(_, e)| *e = nothing);
            self.residual = nothing;
        }
        if !is_wanted("speed_projection") {
            self.speed_correction.clear();
        }
        if !is_wanted("drive") {
            self.drive = None;
        }
    }

    /// The answer to a request, whether every program has it or it was asked for.
    #[must_use]
    pub fn answer(&self, request: &Request) -> Option<Answer> {
        let name = request.to_string();
        if let Some(answer) = self.answers.iter().find(|answer| answer.name == name) {
            return Some(answer.clone());
        }
        let kind = find(&name)?;
        match kind.derive {
            Derive::Standing(parts) => {
                let parts = parts(self);
                (!parts.is_empty()).then(|| Answer {
                    name,
                    doc: kind.doc.to_owned(),
                    parts,
                    is_tuple: true,
                    takes_u_dot: false,
                })
            }
            Derive::Asked(_) | Derive::Held(_) | Derive::Given(_) => None,
        }
    }

    /// The answers of a function; those that the program does not have are omitted.
    #[must_use]
    pub fn answers_of(&self, function: &Function) -> Vec<Answer> {
        function.requests.iter().filter_map(|request| self.answer(request)).collect()
    }

    /// The results of a function, in the order of the interpreter.
    #[must_use]
    pub fn function_roots(&self, function: &Function) -> Vec<ExprId> {
        self.answers_of(function).iter().flat_map(Answer::roots).collect()
    }

    /// The results of an answer about the mechanism; empty if the program does not have it.
    #[must_use]
    pub fn roots_of(&self, name: &str) -> Vec<ExprId> {
        self.answer(&Request::new(name)).map(|answer| answer.roots()).unwrap_or_default()
    }

    /// Names of the answers of a complete file, in its order.
    #[must_use]
    pub fn standing(&self) -> Vec<&'static str> {
        let standing = CATALOGUE.iter().filter(|kind| kind.is_standing() && kind.name != "augmented");
        let is_there = |name: &&str| match *name {
            "drive" => self.drive.is_some(),
            "speed_projection" => !self.speed_correction.is_empty(),
            _ => true,
        };
        standing.map(|kind| kind.name).filter(is_there).collect()
    }

    /// Names of those answers of a complete file that need no mass.
    #[must_use]
    pub fn kinematic(&self) -> Vec<&'static str> {
        let needs_no_mass = |name: &&str| find(name).is_some_and(|kind| kind.needs == Needs::Motion);
        self.standing().into_iter().filter(needs_no_mass).collect()
    }
}
