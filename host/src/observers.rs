//! Quantities observed beside the motion: laws, energies, powers of loads, coordinates in closed form, what functions
//! of time switch by, positions of points and attitudes of bodies.
//!
//! In: a model. Out: the same model with these as its outputs, written in the model's own language and derived like any
//! other output. The program that computes the motion is a different one and does not depend on them. Signs: `actuator`
//! and `external` are power into the mechanism, `damping` is power out of it. A load's power is split: the part that
//! vanishes with the inputs is the actuator's; of the rest, what depends on speeds is damping, everything else
//! external.

use crate::columns::told_apart;
use crate::reads::{is_speed, mentions};
use crate::terms::{add, components, dot, negate, node, number, square, times};
pub use crate::timed::Command;
use crate::{jumps, timed};
use smartbed_codegen::id::Id;
use smartbed_codegen::model::expression::{Expr, ExprKind};
use smartbed_codegen::model::{Axis, Load, LoadKind, Model, Output};
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
    /// Number of functions of time alone that commands read, and of those that laws and loads read.
    pub timed: [usize; 2],
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
        let (commands, others) = timed::switches(model);
        let switched: Vec<Expr> =
            commands.iter().flat_map(|(_, own, _)| own).chain(&others).cloned().collect();
        let values: Vec<Expr> = commands.iter().flat_map(|(_, _, values)| values).cloned().collect();
        let (jumps, signed): (Vec<_>, Vec<_>) =
            jumps::of_speeds(model).into_iter().map(|jump| (jump.owner, jump.argument)).unzip();
        let timed = timed::functions(model);
        let seen = laws.chain(ledger(model)).chain(closed_forms(model));
        watched.outputs = seen
            .chain(switched.iter().cloned())
            .chain(values)
            .chain(signed)
            .chain(timed.iter().flatten().cloned())
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
            timed: timed.map(|own| own.len()),
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

    /// A program whose outputs are the functions of time alone.
    #[must_use]
    pub fn of_time(&self) -> Program {
        self.part(self.before_timed(), self.timed.iter().sum())
    }

    fn before_timed(&self) -> usize {
        self.before_jumps() + self.jumps.len()
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
        let first = self.before_timed() + self.timed.iter().sum::<usize>();
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
