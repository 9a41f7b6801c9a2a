//! Quantities observed beside the motion: laws, energies, powers of loads, coordinates in closed form, what functions
//! of time switch by, positions of points and attitudes of bodies.
//!
//! In: a model. Out: the same model with these as its outputs, written in the model's own language and derived like any
//! other output. The program that computes the motion is a different one and does not depend on them. Signs: `actuator`
//! and `external` are power into the mechanism, `damping` is power out of it. A load's power is split: the part that
//! vanishes with the inputs is the actuator's; of the rest, what depends on speeds is damping, everything else
//! external.

use crate::columns::told_apart;
use crate::jumps;
use crate::reads::{is_speed, is_vector, mentions, visit};
use smartbed_codegen::id::Id;
use smartbed_codegen::model::expression::{Expr, ExprKind};
use smartbed_codegen::model::unit::Unit;
use smartbed_codegen::model::{Axis, FrameId, Load, LoadKind, Model, Output, SpeedMeaning};
use smartbed_codegen::source::Span;
use smartbed_codegen::{Diagnostics, ParameterChoice, Program, program};

/// Entries of the ledger in order: two stored energies (J), three powers (W).
pub const LEDGER: [&str; 5] = ["gravity", "spring", "actuator", "damping", "external"];

/// Derived observers.
#[derive(Clone, Debug)]
pub struct Observers {
    program: Program,
    /// The inputs that have laws, in the order of the laws.
    pub law_inputs: Vec<usize>,
    /// Name and unit of each coordinate in closed form, which is not part of the state.
    pub closed: Vec<(String, String)>,
    /// Columns of the outputs, `None` where there is one already, and of the inputs.
    pub outputs: Vec<Option<String>>,
    /// See `outputs`.
    pub inputs: Vec<String>,
    /// Number of arguments by which functions of time alone switch: in commands, and in laws and loads.
    pub switches: [usize; 2],
    /// The commands that may switch, in the order of their arguments.
    pub commands: Vec<Command>,
    /// Springs between points whose force has no direction where these coincide: name, and the points by number, the
    /// origin being 0.
    pub springs: Vec<(String, [usize; 2])>,
    /// The loads and laws that jump where a speed changes sign, one for each `sign` of a speed.
    pub jumps: Vec<String>,
}

/// Where time moves the mechanism through functions that switch: a coordinate in closed form, a position, an
/// orientation, a speed or a constraint that reads the time.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Command {
    /// What it is, in words before its name.
    pub what: &'static str,
    /// The name in the model.
    pub name: String,
    /// The coordinate in closed form, by its number among these.
    pub closed: Option<usize>,
    /// Number of arguments by which it switches.
    pub switches: usize,
    /// Number of its values, which may not jump; those of motions may, and are left out.
    pub values: usize,
}

impl Command {
    /// In words with its name, as one of a part of that name if there is one.
    #[must_use]
    pub fn words(&self, part: Option<&str>) -> String {
        let Self { what, name, .. } = self;
        part.map_or_else(|| format!("{what} `{name}`"), |part| format!("{what} `{part}.{name}`"))
    }
}

impl Observers {
    /// Derives them.
    ///
    /// # Errors
    /// As the derivation of the model.
    pub fn derive(model: &Model, choice: &ParameterChoice) -> Result<Self, Diagnostics> {
        let mut watched = model.clone();
        let law_inputs = model.laws.iter().map(|(input, _)| input.index()).collect();
        let laws = model.laws.iter().map(|(_, law)| law.clone());
        let (commands, others) = switches(model);
        let switched: Vec<Expr> =
            commands.iter().flat_map(|(_, own, _)| own).chain(&others).cloned().collect();
        let values: Vec<Expr> = commands.iter().flat_map(|(_, _, values)| values).cloned().collect();
        let (jumps, signed): (Vec<_>, Vec<_>) =
            jumps::of_speeds(model).into_iter().map(|jump| (jump.owner, jump.argument)).unzip();
        let seen = laws.chain(ledger(model)).chain(closed_forms(model));
        watched.outputs = seen
            .chain(switched.iter().cloned())
            .chain(values)
            .chain(signed)
            .chain(places(model))
            .map(output)
            .collect();
        let closed = model.coordinates.iter().filter(|c| c.closed_form.is_some());
        let closed = closed.map(|c| (c.name.clone(), c.unit.clone())).collect();
        let (outputs, inputs) = told_apart(model);
        let program = program::derive(&watched, choice)?;
        Ok(Self {
            program,
            law_inputs,
            closed,
            outputs,
            inputs,
            switches: [switched.len() - others.len(), others.len()],
            springs: springs(model),
            commands: commands.into_iter().map(|(command, ..)| command).collect(),
            jumps,
        })
    }

    /// A program whose outputs are the laws.
    #[must_use]
    pub fn laws(&self) -> Program {
        self.part(0, self.law_inputs.len())
    }

    /// A program whose outputs are the entries of [`LEDGER`].
    #[must_use]
    pub fn ledger(&self) -> Program {
        self.part(self.law_inputs.len(), LEDGER.len())
    }

    /// A program whose outputs are value and rate of every coordinate in closed form, one after the other.
    #[must_use]
    pub fn closed_forms(&self) -> Program {
        self.part(self.law_inputs.len() + LEDGER.len(), 2 * self.closed.len())
    }

    /// A program whose outputs change sign where a function of time alone may have a kink or a jump
    /// (`jumps::switch`, `jumps::pole`).
    #[must_use]
    pub fn switches(&self) -> Program {
        self.part(self.before_switches(), self.switches.iter().sum())
    }

    /// A program whose outputs are the values of all [`Observers::commands`].
    #[must_use]
    pub fn commanded(&self) -> Program {
        self.part(self.before_values(), self.commands.iter().map(|command| command.values).sum())
    }

    /// A program whose outputs are the arguments of each `sign` of a speed.
    #[must_use]
    pub fn jumps(&self) -> Program {
        self.part(self.before_jumps(), self.jumps.len())
    }

    fn before_switches(&self) -> usize {
        self.law_inputs.len() + LEDGER.len() + 2 * self.closed.len()
    }

    fn before_values(&self) -> usize {
        self.before_switches() + self.switches.iter().sum::<usize>()
    }

    fn before_jumps(&self) -> usize {
        self.before_values() + self.commands.iter().map(|command| command.values).sum::<usize>()
    }

    /// A program whose outputs are the data of a picture of the mechanism: x, y, z of every point; for every body with
    /// a frame the frame's x and y axes; mass, Ixx, Iyy, Izz, Ixy, Ixz, Iyz of every body; gravity; the lengths of the
    /// shapes in `[view]`.
    #[must_use]
    pub fn places(&self) -> Program {
        let first = self.before_jumps() + self.jumps.len();
        self.part(first, self.program.outputs.len() - first)
    }

    fn part(&self, first: usize, n: usize) -> Program {
        let mut part = self.program.clone();
        part.outputs = self.program.outputs[first..first + n].to_vec();
        part
    }
}

/// The springs whose force does not vanish where their ends coincide.
fn springs(model: &Model) -> Vec<(String, [usize; 2])> {
    let is_zero = |e: &Expr| matches!(e.kind, ExprKind::Number(0.0));
    let found = model.loads.iter().filter_map(|load| match &load.kind {
        LoadKind::Spring { ends, rest_length, damping, .. } if !is_zero(rest_length) || damping.is_some() => {
            Some((load.name.clone(), ends.map(Id::index)))
        }
        _ => None,
    });
    found.collect()
}

fn output(value: Expr) -> Output {
    Output { name: String::new(), value, unit: String::new(), span: Span::default() }
}

/// Expressions for stored energies and powers, in the order of [`LEDGER`].
fn ledger(model: &Model) -> [Expr; 5] {
    let mut sums: [Expr; 5] = std::array::from_fn(|_| number(0.0));
    let mut book = |entry: usize, term: Expr| {
        let sum = std::mem::replace(&mut sums[entry], number(0.0));
        sums[entry] = add(sum, term);
    };
    for body in model.bodies.iter().filter(|b| b.weight) {
        if let (Some(gravity), Some(mass)) = (&model.gravity, &body.mass) {
            let height = dot(gravity.clone(), node(ExprKind::Point(body.centre)));
            book(0, negate(times(mass.clone(), height)));
        }
    }
    for Load { kind, .. } in &model.loads {
        match kind {
            LoadKind::Force { point, force, reaction } => {
                let velocity = relative(*point, *reaction, ExprKind::Velocity);
                split(model, force, &velocity).into_iter().for_each(|(entry, power)| book(entry, power));
            }
            LoadKind::Torque { frame, torque, reaction } => {
                let velocity = relative(*frame, *reaction, ExprKind::AngularVelocity);
                split(model, torque, &velocity).into_iter().for_each(|(entry, power)| book(entry, power));
            }
            LoadKind::Spring { ends: [a, b], stiffness, rest_length, damping } => {
                let line = relative(*b, Some(*a), ExprKind::Point);
                let length = node(ExprKind::Norm(Box::new(line.clone())));
                book(1, spring_energy(stiffness, length.clone(), rest_length));
                if let Some(damping) = damping {
                    let along = dot(relative(*b, Some(*a), ExprKind::Velocity), line);
                    let rate = node(ExprKind::Divide(Box::new(along), Box::new(length)));
                    book(3, times(damping.clone(), square(rate)));
                }
            }
            LoadKind::CoordinateSpring { coordinate, stiffness, rest, damping } => {
                book(1, spring_energy(stiffness, node(ExprKind::Coordinate(*coordinate)), rest));
                if let Some(damping) = damping {
                    book(3, times(damping.clone(), square(node(ExprKind::Rate(*coordinate)))));
                }
            }
        }
    }
    sums
}

/// Value and rate of every coordinate in closed form.
fn closed_forms(model: &Model) -> impl Iterator<Item = Expr> + '_ {
    let closed = model.coordinates.enumerate().filter(|(_, c)| c.closed_form.is_some());
    closed.flat_map(|(id, _)| [node(ExprKind::Coordinate(id)), node(ExprKind::Rate(id))])
}

/// Whether a commanded speed may change at once: what commands it has abs, sign, min or max of the time, or the like.
#[must_use]
pub fn may_leap(model: &Model) -> bool {
    commands(model).into_iter().any(|(_, read, _)| !kinks_of(model, read).is_empty())
}

/// A command, the functions of time at whose zeros it may switch, and its values.
type Switching = (Command, Vec<Expr>, Vec<Expr>);

/// The commands that may have a kink or a jump in time, and the functions at whose zeros a law or a load may.
fn switches(model: &Model) -> (Vec<Switching>, Vec<Expr>) {
    let commands = commands(model).into_iter().filter_map(|(mut command, read, values)| {
        let own = switches_of(model, read);
        (command.switches, command.values) = (own.len(), values.len());
        (!own.is_empty()).then_some((command, own, values))
    });
    let laws = model.laws.iter().map(|(_, law)| law);
    let loads = model.loads.iter().flat_map(|load| load.kind.expressions()).map(|(_, e)| e);
    // Those of coordinates that are commanded, such as end stops, are found while a load acts.
    let others = laws.chain(loads).flat_map(|e| switches_of(model, e));
    (commands.collect(), others.filter(|e| mentions(model, e, &is_time)).collect())
}

/// Everything by which time may move the mechanism: what it is, its expression, its values (none of what gives speeds).
fn commands(model: &Model) -> Vec<(Command, &Expr, Vec<Expr>)> {
    let named =
        |what, name: &str| Command { what, name: name.to_owned(), closed: None, switches: 0, values: 0 };
    let all = |e: &Expr| match is_vector(model, e) {
        true => components(e.clone()).to_vec(),
        false => vec![e.clone()],
    };
    let mut found = Vec::new();
    let closed = model.coordinates.enumerate().filter_map(|(id, c)| Some((id, c, c.closed_form.as_ref()?)));
    for (number, (id, coordinate, form)) in closed.enumerate() {
        let command = Command { closed: Some(number), ..named("the command of", &coordinate.name) };
        found.push((command, form, vec![node(ExprKind::Coordinate(id))]));
    }
    for frame in model.frames.iter() {
        let parts = frame.orientation.expressions().into_iter();
        found.extend(parts.map(|(_, e)| (named("the orientation of", &frame.name), e, all(e))));
        let fixed = frame.fixed_vectors.iter().map(|fixed| &fixed.vector);
        found.extend(fixed.map(|e| (named("a fixed vector of", &frame.name), e, all(e))));
    }
    for point in model.points.iter() {
        let places = std::iter::once(&point.position).chain(&point.closures);
        found.extend(places.map(|e| (named("the position of", &point.name), e, all(e))));
        found.extend(point.velocity.iter().map(|e| (named("the velocity of", &point.name), e, Vec::new())));
    }
    // A state of such a speed says what the rates are: these must not jump.
    for speed in model.speeds.iter() {
        if let SpeedMeaning::Combination(e) = &speed.meaning {
            found.push((named("the speed", &speed.name), e, rates_in(e)));
        }
    }
    for constraint in &model.configuration_constraints {
        let e = &constraint.expression;
        found.push((named("the constraint", &constraint.name), e, all(e)));
    }
    for constraint in &model.motion_constraints {
        found.push((named("the constraint", &constraint.name), &constraint.expression, Vec::new()));
    }
    found
}

/// The rates of coordinates in a combination.
fn rates_in(combination: &Expr) -> Vec<Expr> {
    let mut rates: Vec<Expr> = Vec::new();
    combination.visit(&mut |e| {
        if let ExprKind::Rate(id) = e.kind {
            rates.push(node(ExprKind::Rate(id)));
        }
    });
    rates
}

/// The functions of time alone at whose zeros an expression, or a definition that it reads, may switch. Poles count where
/// the time itself stands: the geometry that follows commanded coordinates is regular where it can be assembled.
fn switches_of(model: &Model, expr: &Expr) -> Vec<Expr> {
    let mut found = kinks_of(model, expr);
    found.extend(
        of_time(model, expr, &|e| jumps::pole(e).into_iter().collect())
            .into_iter()
            .filter(|e| mentions(model, e, &is_time)),
    );
    found
}

fn is_time(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::Time)
}

/// Those of kinks.
fn kinks_of(model: &Model, expr: &Expr) -> Vec<Expr> {
    // A coordinate is one that is commanded: others are state.
    let moves = |e: &Expr| is_time(e) || matches!(e.kind, ExprKind::Coordinate(_));
    let mut found = of_time(model, expr, &|e| jumps::switch(model, e));
    found.retain(|e| mentions(model, e, &moves));
    found
}

/// Arguments in an expression, and in the definitions that it reads, that are no functions of the state: each factor of
/// them, since two that change sign at once, or shortly one after the other, leave no trace in their product.
fn of_time(model: &Model, expr: &Expr, arguments: &dyn Fn(&Expr) -> Vec<Expr>) -> Vec<Expr> {
    let mut found = Vec::new();
    visit(model, expr, &mut |e| {
        found.extend(arguments(e).iter().flat_map(|argument| jumps::factors(model, argument)));
    });
    found.retain(|e| !mentions(model, e, &|e| is_state(model, e)));
    found
}

/// Does it depend on more than time?
fn is_state(model: &Model, e: &Expr) -> bool {
    use ExprKind::{AngularVelocity, Axis, Coordinate, Input, Point, Rate, Speed, Velocity};
    match &e.kind {
        Coordinate(id) => match &model.coordinates[*id].closed_form {
            Some(form) => mentions(model, form, &|e| is_state(model, e)),
            None => true,
        },
        Rate(_) | Speed(_) | Input(_) | Point(_) | Velocity(_) | AngularVelocity(_) | Axis(..) => true,
        _ => false,
    }
}

/// x, y, z in N of every point but the origin; axes of bodies; masses and moments; gravity.
fn places(model: &Model) -> impl Iterator<Item = Expr> + '_ {
    let points = model.points.ids().skip(1).flat_map(|point| components(node(ExprKind::Point(point))));
    let frames = model.bodies.iter().filter_map(|body| body.frame);
    let axes = frames.flat_map(|frame| {
        [Axis::X, Axis::Y].into_iter().flat_map(move |axis| components(node(ExprKind::Axis(frame, axis))))
    });
    let known = |e: &Option<Expr>| e.clone().unwrap_or_else(|| number(0.0));
    let inertia = model.bodies.iter().flat_map(move |body| {
        std::iter::once(&body.mass).chain(&body.inertia).map(known).collect::<Vec<_>>()
    });
    let gravity = model.gravity.clone().map_or_else(|| std::array::from_fn(|_| number(0.0)), components);
    let sizes = model.view.shapes.iter().flat_map(|(_, shape)| shape.sizes.iter().cloned());
    points.chain(axes).chain(inertia).chain(gravity).chain(sizes)
}

/// A vector's components in N.
fn components(vector: Expr) -> [Expr; 3] {
    let inertial = FrameId::from_index(0);
    [Axis::X, Axis::Y, Axis::Z].map(|axis| dot(vector.clone(), node(ExprKind::Axis(inertial, axis))))
}

/// 1/2 k (length - rest)^2.
fn spring_energy(stiffness: &Expr, length: Expr, rest: &Expr) -> Expr {
    let stretch = node(ExprKind::Subtract(Box::new(length), Box::new(rest.clone())));
    times(number(0.5), times(stiffness.clone(), square(stretch)))
}

/// The parts of a load's power, each with its ledger entry.
fn split(model: &Model, load: &Expr, velocity: &Expr) -> Vec<(usize, Expr)> {
    let is_input = |e: &Expr| matches!(e.kind, ExprKind::Input(_));
    let mut parts = Vec::new();
    let mut passive = load.clone();
    if mentions(model, load, &is_input) {
        passive = without_inputs(model, load);
        let active = node(ExprKind::Subtract(Box::new(load.clone()), Box::new(passive.clone())));
        parts.push((2, dot(active, velocity.clone())));
    }
    let power = dot(passive.clone(), velocity.clone());
    parts.push(if mentions(model, &passive, &is_speed) { (3, negate(power)) } else { (4, power) });
    parts
}

/// The expression with every input set to 0; definitions that depend on inputs are written out.
fn without_inputs(model: &Model, expr: &Expr) -> Expr {
    let is_input = |e: &Expr| matches!(e.kind, ExprKind::Input(_));
    expr.replaced(&|e| match &e.kind {
        ExprKind::Input(_) => Some(number(0.0)),
        ExprKind::Definition(id) if mentions(model, &model.definitions[*id].value, &is_input) => {
            Some(without_inputs(model, &model.definitions[*id].value))
        }
        _ => None,
    })
}

/// `of(a) - of(b)`, or `of(a)` if the other side is the ground.
fn relative<T>(a: T, b: Option<T>, of: impl Fn(T) -> ExprKind) -> Expr {
    let first = node(of(a));
    match b {
        Some(b) => node(ExprKind::Subtract(Box::new(first), Box::new(node(of(b))))),
        None => first,
    }
}

fn node(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::default(), unit: Unit::NONE }
}

fn number(x: f64) -> Expr {
    node(ExprKind::Number(x))
}

fn add(a: Expr, b: Expr) -> Expr {
    node(ExprKind::Add(Box::new(a), Box::new(b)))
}

fn times(a: Expr, b: Expr) -> Expr {
    node(ExprKind::Multiply(Box::new(a), Box::new(b)))
}

fn negate(a: Expr) -> Expr {
    node(ExprKind::Negate(Box::new(a)))
}

fn square(a: Expr) -> Expr {
    node(ExprKind::Power(Box::new(a), 2))
}

fn dot(a: Expr, b: Expr) -> Expr {
    node(ExprKind::Dot(Box::new(a), Box::new(b)))
}
