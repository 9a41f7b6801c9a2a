//! A program: what a mechanism's equations compute, as named answers over one expression DAG.
//!
//! In: kinematics and dynamics. Out: for each answer a list of named results; inputs in a fixed
//! order (t, q, u, inputs, parameters). Both the interpreter and the emitter run exactly these nodes.

pub mod answer;
pub mod arguments;
pub mod interpreter;
mod kinematic;
pub mod limits;
mod prepared;
mod reciprocal;
mod relative;
mod reorder;
mod roots;
mod shorten;
pub mod stage;
mod start;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::dynamics::{self, Augmented, Dynamics};
pub use crate::expr::cost::Optimise;
use crate::expr::tape::SampleTable;
use crate::expr::{Binary, Dag, ExprId, Node, SymbolId, Unary};
use crate::id::Id;
use crate::kinematics::eliminate::{self, Pivot, Solution};
use crate::kinematics::sizes::Sizes;
use crate::kinematics::{self, Assembly, Kinematics, ParameterChoice, projection, redundant};
use crate::model::{CoordinateId, Model, Speed, SpeedMeaning};
pub use crate::value::Effort;

pub use answer::{Answer, Asked, Function, Request};
use answer::{Answered, Stages};
pub use kinematic::derive_kinematic;
use stage::Stage;
pub use start::Start;

impl Program {
    /// Are all speeds state, tied by the constraints, because the motion passes dead points of the independent ones?
    #[must_use]
    pub fn is_redundant(&self) -> bool {
        !self.speed_correction.is_empty()
    }
}

/// Everything derived from a model.
#[derive(Clone, Debug)]
pub struct Program {
    /// The model's name.
    pub name: String,
    /// The model's description.
    pub doc: String,
    /// Path of the model text as given.
    pub path: String,
    /// From which text it was derived, and how.
    pub origin: Origin,
    /// The expressions of all answers.
    pub dag: Dag,
    /// Time.
    pub time: SymbolId,
    /// Coordinates that are state.
    pub q: Vec<Quantity>,
    /// Independent speeds.
    pub u: Vec<Quantity>,
    /// Inputs.
    pub inputs: Vec<Quantity>,
    /// Tunable parameters; `value` is the default.
    pub parameters: Vec<Quantity>,
    /// q' and u' and the worst pivot.
    pub rates: Rates,
    /// Kinetic and potential energy (J).
    pub energy: [ExprId; 2],
    /// Power (W) that the drive puts in, where the mechanism follows time or stated velocities.
    pub drive: Option<ExprId>,
    /// All speeds of the model by name, dependent ones in terms of the independent.
    pub speeds: Vec<(String, ExprId)>,
    /// Requested outputs.
    pub outputs: Vec<(String, ExprId)>,
    /// Unit and declaration of each of them.
    pub output_facts: Vec<[String; 2]>,
    /// Newton's correction of the dependent coordinates: (index into q, correction).
    pub correction: Vec<(usize, ExprId)>,
    /// Correction of the speeds where they are redundant: all of them are state, tied by the constraints. Else empty.
    pub speed_correction: Vec<ExprId>,
    /// Largest constraint residual before the correction, implied constraints included.
    pub residual: ExprId,
    /// Are there constraints that follow from the others at the default parameters, but perhaps not at others?
    pub has_implied: bool,
    /// The equations before the elimination, with multipliers; empty unless they are asked for.
    pub augmented: Augmented,
    /// Given derivatives of the speeds; empty unless an answer takes them.
    pub u_dot: Vec<Quantity>,
    /// Answers on request.
    pub answers: Vec<Answer>,
    /// Functions that give them, besides those that every program has.
    pub functions: Vec<Function>,
    /// Pivots of all eliminations.
    pub pivots: Vec<Pivot>,
    /// Number of configurations at which they were screened.
    pub n_samples: usize,
    /// Solver of dependent coordinates at the start.
    pub assembly: Assembly,
    /// The nominal configuration.
    pub nominal: Vec<f64>,
    /// Names and values of `[start]`; [`Program::start`] makes a state of them.
    pub stated_start: Vec<(String, f64)>,
    /// What only numbers show and is no error: redundant constraints that were dropped.
    pub warnings: Diagnostics,
}

/// From which text a program was derived, and how.
#[derive(Clone, Debug)]
pub struct Origin {
    /// Name of the model's file, without its folder.
    pub file: String,
    /// Fingerprint of the model's text, with the files that it extends.
    pub fingerprint: u64,
    /// Parameters kept and changed.
    pub choice: ParameterChoice,
    /// How the equations were derived.
    pub settings: Settings,
}

impl Origin {
    fn new(model: &Model, choice: &ParameterChoice, settings: Settings) -> Self {
        let source = &model.source;
        let file = source.files.first().map_or_else(String::new, |file| file.name().to_owned());
        Self { file, fingerprint: source.fingerprint(), choice: choice.clone(), settings }
    }
}

/// The forward dynamics answer.
#[derive(Clone, Debug)]
pub struct Rates {
    /// One per coordinate.
    pub q_dot: Vec<ExprId>,
    /// One per independent speed.
    pub u_dot: Vec<ExprId>,
    /// Smallest pivot relative to nominal; 1 where nothing is divided by.
    pub worst_pivot: ExprId,
}

/// A named number of the state, the inputs or the parameters.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Name in the model.
    pub name: String,
    /// Its symbol.
    pub symbol: SymbolId,
    /// Unit as written in the model.
    pub unit: String,
    /// What it is.
    pub doc: String,
    /// Default (parameters), nominal value (coordinates), else 0.
    pub value: f64,
    /// Lowest and highest value, of parameters and of coordinates for which the model states them; else every number.
    pub range: (f64, f64),
    /// File and line of the declaration.
    pub place: String,
    /// Appears only inside sine and cosine: may be wrapped by whole turns.
    pub is_angle: bool,
}

/// Derives the program of `model`.
///
/// # Errors
/// What only numbers show: see the stages.
pub fn derive(model: &Model, choice: &ParameterChoice) -> Result<Program, Diagnostics> {
    derive_with(model, choice, Settings::default())
}

/// How a program is derived; the equations are the same whatever is set.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Settings {
    /// How hard to look for fewer operations.
    pub effort: Effort,
    /// What the choice between forms of the equations goes by.
    pub optimise: Optimise,
}

impl From<Effort> for Settings {
    fn from(effort: Effort) -> Self {
        Self { effort, ..Self::default() }
    }
}

/// [`derive()`] with other settings.
///
/// # Errors
/// As for [`derive()`].
pub fn derive_with(
    model: &Model,
    choice: &ParameterChoice,
    settings: impl Into<Settings>,
) -> Result<Program, Diagnostics> {
    derive_asked(model, choice, settings, &Asked::default())
}

/// [`derive()`] with answers on request.
///
/// # Errors
/// As for [`derive()`]; a request for what is not there.
pub fn derive_asked(
    model: &Model,
    choice: &ParameterChoice,
    settings: impl Into<Settings>,
    asked: &Asked,
) -> Result<Program, Diagnostics> {
    let settings = settings.into();
    let Settings { effort, optimise } = settings;
    let requests = answer::resolve(model, asked)?;
    if asked.only && requests.iter().all(|request| request.kind.needs == answer::Needs::Motion) {
        return kinematic::derive(model, choice, effort, asked);
    }
    let own_inputs = model.inputs.len();
    let model = &*answer::with_wrenches(model, &requests)?;
    stage::begin(Stage::Kinematics);
    let mut k = kinematics::derive(model, choice, optimise)?;
    let mut warnings = implausible(model, &k)?;
    stage::begin(Stage::Constraints);
    let mut table = eliminate::sample_table(model, &k);
    warnings.items.extend(kinematics::diagnose::check(model, &mut k, &mut table)?.items);
    let solution = constraints(model, &mut k, &mut table)?;
    // The values of the rows have served: their memory is used again.
    table.clear();
    stage::begin(Stage::Dynamics);
    let with_augmented = requests.iter().any(|request| request.kind.name == "augmented");
    let dynamics = dynamics::derive(model, &mut k, &solution, &mut table, (optimise, with_augmented))?;
    stage::begin(Stage::Answers);
    let given = (own_inputs, answer::holds_u_dot(&requests));
    let mut stages = Stages::new((model, choice), &mut k, (&solution, &dynamics), &mut table, given);
    let answered = answer::derive(&mut stages, &requests, asked)?;
    let assembly = Assembly::new(model, &mut k);
    let sizes = Sizes::new(model, &k);
    let origin = Origin::new(model, choice, settings);
    let mut program = assemble(model, k, (&solution, &mut table), dynamics, (assembly, answered, origin));
    program.warnings = warnings;
    program.keep_only(asked);
    stage::begin(Stage::Values);
    shorten::answers(&mut program, &mut table, effort);
    stage::begin(Stage::Sums);
    if effort != Effort::None {
        reorder::sums(&mut program, &mut table);
    }
    relative::to_parameters(&mut program, &sizes);
    mark_angles(&mut program);
    Ok(program)
}

/// Every dependent unknown from the independent speeds; or, where the motion passes dead points of these and some mass
/// moves with it there, all speeds as state.
fn constraints(model: &Model, k: &mut Kinematics, table: &mut SampleTable) -> Result<Solution, Diagnostics> {
    let minimal = eliminate::solve(model, k, table);
    if let Some((mut all, solution, mut samples)) = redundant::solve(model, k, table, minimal.as_ref().ok()) {
        let moved = model.bodies.is_empty() || dynamics::is_inert(model, &mut all, &solution, &mut samples);
        if moved || minimal.is_err() {
            (*k, *table) = (all, samples);
            return Ok(solution);
        }
    }
    let mut solution = minimal?;
    projection::correct(model, k, table, &mut solution);
    Ok(solution)
}

/// Warnings of what no mechanism has, and of bodies that nothing moves.
///
/// # Errors
/// Numbers that make the equations meaningless.
fn implausible(model: &Model, k: &Kinematics) -> Result<Diagnostics, Diagnostics> {
    let mut found = Diagnostics::new(model.source.clone());
    model.implausible(&k.parameter_values).into_iter().for_each(|item| found.push(item));
    for body in model.bodies.iter() {
        let turns = body.frame.is_some_and(|frame| !k.angular[k.frame_triad[frame]].partials.is_empty());
        let moves = !k.velocities[body.centre].partials.is_empty();
        if !moves && !turns {
            found.push(
                Diagnostic::warning(format!("`{}` is tied to nothing that moves", body.name))
                    .label(body.span, "its centre and its frame stay where they are")
                    .help("let its centre or frame depend on coordinates, or leave it out: it changes no equation"),
            );
        }
        if moves && body.mass.is_none() {
            found.push(
                Diagnostic::warning(format!("`{}` has inertia but no mass, and its centre moves", body.name))
                    .label(body.span, "no mass is given")
                    .help("give its mass; for a body of pure inertia say so: mass = 0"),
            );
        }
    }
    if found.has_errors() { Err(found) } else { Ok(found) }
}

fn assemble(
    model: &Model,
    mut k: Kinematics,
    (solution, table): (&Solution, &mut SampleTable),
    dynamics: Dynamics,
    (assembly, answered, origin): (Assembly, Answered, Origin),
) -> Program {
    let state: Vec<CoordinateId> =
        model.coordinates.ids().filter(|&c| k.coordinate_symbol(c).is_some()).collect();
    let speeds: Vec<(String, ExprId)> = model
        .speeds
        .enumerate()
        .map(|(id, speed)| (speed.name.clone(), k.unknowns[k.unknown_of(id)].value))
        .collect();
    let q_dot: Vec<ExprId> = state
        .iter()
        .map(|&c| {
            let rate = k.rates[c].clone();
            kinematics::rate_of(&mut k, &rate)
        })
        .collect();
    let outputs: Vec<ExprId> =
        model.outputs.iter().map(|o| kinematics::lower_scalar(&mut k, &o.value)).collect();
    // Velocity symbols become their values in terms of the independent speeds.
    let speed_values: Vec<ExprId> = speeds.iter().map(|(_, e)| *e).collect();
    let q_dot = k.dag.substitute(&q_dot, &dynamics.values);
    let outputs = k.dag.substitute(&outputs, &dynamics.values);
    let speed_values = k.dag.substitute(&speed_values, &dynamics.values);
    let pivots: Vec<Pivot> = solution.pivots.iter().chain(&dynamics.pivots).copied().collect();
    let worst_pivot = worst_pivot(&mut k.dag, &pivots);
    let watched = [&k.residuals[..], &k.implied].concat();
    let residual = largest(&mut k.dag, &watched);
    let correction = correction(&mut k, table, &state, solution);
    let [q, u, inputs, parameters] = quantities(model, &k, &state);
    let closed_forms = k.closed_form_values();
    let u_dot = given_accelerations(model, &k, &answered.u_dot);
    let mut program = Program {
        name: model.name.clone(),
        doc: model.doc.clone(),
        path: model.source.files.first().map_or(String::new(), |f| f.path.clone()),
        origin,
        time: k.dag.as_symbol(k.time).expect("time is a symbol"),
        q,
        u,
        inputs,
        parameters,
        rates: Rates { q_dot, u_dot: dynamics.u_dot, worst_pivot },
        energy: [dynamics.kinetic, dynamics.potential],
        drive: dynamics.drive,
        speeds: speeds.into_iter().map(|(name, _)| name).zip(speed_values).collect(),
        outputs: model.outputs.iter().map(|o| o.name.clone()).zip(outputs).collect(),
        output_facts: model.outputs.iter().map(|o| [o.unit.clone(), model.source.place(o.span)]).collect(),
        correction,
        speed_correction: dynamics.speed_correction,
        residual,
        has_implied: !k.implied.is_empty(),
        augmented: dynamics.augmented,
        u_dot,
        answers: answered.answers,
        functions: answered.functions,
        pivots,
        n_samples: k.samples.len(),
        assembly,
        nominal: k.samples[0].clone(),
        stated_start: start::stated(model),
        warnings: Diagnostics::default(),
        dag: k.dag,
    };
    program.substitute(&closed_forms);
    reciprocal::share(&mut program);
    program
}

/// min over the pivots of |pivot| / nominal; pivots of one nominal size share the scaling.
///
/// A sine or cosine is left out where its square is a pivot of the same nominal size: the square is never larger.
fn worst_pivot(dag: &mut Dag, pivots: &[Pivot]) -> ExprId {
    let smaller_square = |pivot: &Pivot| {
        let square = Node::Binary(Binary::Mul, pivot.value, pivot.value);
        matches!(dag.node(pivot.value), Node::Unary(Unary::Sin | Unary::Cos, _))
            && pivots.iter().any(|p| p.nominal == pivot.nominal && dag.node(p.value) == square)
    };
    let weakest: Vec<Pivot> = pivots.iter().filter(|pivot| !smaller_square(pivot)).copied().collect();
    let mut groups: Vec<(f64, ExprId)> = Vec::new();
    for pivot in &weakest {
        let size = dag.unary(Unary::Abs, pivot.value);
        match groups.iter_mut().find(|(nominal, _)| *nominal == pivot.nominal) {
            Some((_, smallest)) => *smallest = dag.binary(Binary::Min, *smallest, size),
            None => groups.push((pivot.nominal, size)),
        }
    }
    let mut worst = dag.one();
    for (nominal, smallest) in groups {
        let scale = dag.constant(1.0 / nominal);
        let relative = dag.mul(scale, smallest);
        worst = if dag.is_one(worst) { relative } else { dag.binary(Binary::Min, worst, relative) };
    }
    worst
}

fn largest(dag: &mut Dag, residuals: &[ExprId]) -> ExprId {
    let zero = dag.zero();
    residuals.iter().fold(zero, |largest, &r| {
        let size = dag.unary(Unary::Abs, r);
        if dag.is_zero(largest) { size } else { dag.binary(Binary::Max, largest, size) }
    })
}

/// Corrections of the coordinates: those of the unknowns, which are 0 for independent speeds, through q_dot = N u.
///
/// Coordinates that share a dependent speed move together (Euler parameters along their own direction).
fn correction(
    k: &mut Kinematics,
    table: &mut SampleTable,
    state: &[CoordinateId],
    solution: &Solution,
) -> Vec<(usize, ExprId)> {
    let mut corrections = Vec::new();
    if !solution.ties.is_empty() {
        corrections = redundant::correction(k, table, state).into_iter().enumerate().collect();
        corrections.retain(|(_, e)| !k.dag.is_zero(*e));
        return corrections;
    }
    for (index, &c) in state.iter().enumerate() {
        let rate = k.rates[c].partials.clone();
        let terms: Vec<ExprId> =
            rate.into_iter().map(|(unknown, n)| k.dag.mul(n, solution.correction[&unknown])).collect();
        corrections.push((index, k.dag.sum(&terms)));
    }
    corrections.retain(|(_, e)| !k.dag.is_zero(*e));
    corrections
}

/// The range of what has none.
const ANY: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Given derivatives of the independent speeds, in their order.
fn given_accelerations(model: &Model, k: &Kinematics, symbols: &[ExprId]) -> Vec<Quantity> {
    let independent = model.speeds.enumerate().filter(|(id, _)| k.is_independent(*id));
    let speeds = independent.map(|(_, speed)| speed).zip(symbols);
    let quantity = |(speed, &expr): (&Speed, &ExprId)| {
        let symbol = k.dag.as_symbol(expr)?;
        Some(Quantity {
            name: k.dag.symbol_name(symbol).to_owned(),
            symbol,
            unit: format!("{}/s", speed.unit),
            doc: "derivative of the speed".to_owned(),
            value: 0.0,
            range: ANY,
            place: model.source.place(speed.span),
            is_angle: false,
        })
    };
    speeds.filter_map(quantity).collect()
}

fn quantities(model: &Model, k: &Kinematics, state: &[CoordinateId]) -> [Vec<Quantity>; 4] {
    let quantity = |name: &str, expr: ExprId, unit: &str, doc: &str, value: f64, span| {
        k.dag.as_symbol(expr).map(|symbol| Quantity {
            name: name.to_owned(),
            symbol,
            unit: unit.to_owned(),
            doc: doc.to_owned(),
            value,
            range: ANY,
            place: model.source.place(span),
            is_angle: false,
        })
    };
    let q = state
        .iter()
        .zip(&k.samples[0])
        .filter_map(|(&c, &nominal)| {
            let declared = &model.coordinates[c];
            let found =
                quantity(&declared.name, k.q[c], &declared.unit, &declared.doc, nominal, declared.span)?;
            let range = if declared.states_range() { declared.range } else { ANY };
            Some(Quantity { range, ..found })
        })
        .collect();
    let u = model
        .speeds
        .enumerate()
        .filter(|(id, _)| k.is_independent(*id))
        .filter_map(|(id, s)| {
            let doc = match s.meaning {
                SpeedMeaning::RateOf(c) => format!("rate of {}", model.coordinates[c].name),
                SpeedMeaning::Combination(_) => "speed".to_owned(),
            };
            quantity(&s.name, k.unknowns[k.unknown_of(id)].value, &s.unit, &doc, 0.0, s.span)
        })
        .collect();
    let inputs = model
        .inputs
        .enumerate()
        .filter_map(|(id, i)| quantity(&i.name, k.inputs[id], &i.unit, &i.doc, 0.0, i.span))
        .collect();
    let parameters = model
        .parameters
        .enumerate()
        .filter_map(|(id, p)| {
            let found = quantity(&p.name, k.parameters[id], &p.unit, &p.doc, k.parameter_values[id], p.span)?;
            Some(Quantity { range: p.range, ..found })
        })
        .collect();
    [q, u, inputs, parameters]
}

/// A coordinate that is read only by sines and cosines, as it is or in sums and differences that are read
/// only by them, may be wrapped by whole turns.
fn mark_angles(program: &mut Program) {
    let roots = program.all_roots();
    let dag = &program.dag;
    let mut periodic = vec![true; dag.len()];
    for &root in &roots {
        periodic[root.index()] = false;
    }
    for &id in dag.reachable(&roots).iter().rev() {
        let reads_turns = match dag.node(id) {
            Node::Unary(Unary::Sin | Unary::Cos, _) => true,
            Node::Negate(_) | Node::Binary(Binary::Add | Binary::Sub, ..) => periodic[id.index()],
            _ => false,
        };
        if !reads_turns {
            dag.operands(id).into_iter().flatten().for_each(|a| periodic[a.index()] = false);
        }
    }
    let coordinates = program.q.iter_mut().filter(|q| q.unit == "rad");
    for quantity in coordinates {
        let node = dag.find(Node::Symbol(quantity.symbol));
        quantity.is_angle = node.is_none_or(|id| periodic[id.index()]);
    }
}
