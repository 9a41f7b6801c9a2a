//! Emits the body of one function: `let` statements.
//!
//! Written as text, one statement per line: passing a thousand straight-line statements through a token parser and a
//! general formatter took twenty times as long as the derivation's last stage. A node gets a `let` if it is used more
//! than once, has a name from the model, or would make its user's statement too long. Other nodes are written inside
//! their only user, provided that every operation keeps the place that [`schedule`] gives it for the
//! [`Core`](super::options::Core). Arguments are read before their first use.

mod expressions;
mod groups;
mod results;
mod steps;

use super::name::{ARGUMENTS, Idents, NEAR, Scope};
use super::options::{Core, EmitOptions};
use super::prepared::Prepared;
use super::schedule::{self, Order, Results, Step};
use super::sections::Sections;
use super::sines::Sines;
use crate::escape;
use crate::expr::print::unary_name;
use crate::expr::{Dag, ExprId, Node, NodeSet, SymbolId, Unary};
use crate::id::Id;
use crate::program::{Effort, Program};
use rustc_hash::FxHashMap as HashMap;
use std::fmt::Write;

/// Most operations in one statement.
const LONGEST_STATEMENT: usize = 8;
/// Most `let` statements of a function. The compiler nests a scope in its debugging information for each, by recursion:
/// some 2800 overflow its stack.
const MOST_LETS: usize = 1000;

/// Where a function finds the values of parameters.
#[derive(Clone, Copy)]
pub(super) enum Parameters<'p> {
    /// In an answer: in `p: &Prepared`.
    Prepared {
        /// Its fields.
        prepared: &'p Prepared,
        /// Are derivatives of the speeds an argument as well?
        takes_u_dot: bool,
    },
    /// In `prepare`: in `p: &Parameters`, whose fields have these names.
    Given(&'p [String]),
}

/// Statements and results of a function.
pub(super) struct Body<'p> {
    program: &'p Program,
    options: &'p EmitOptions,
    parameters: Parameters<'p>,
    sines: Sines<'p>,
    /// By angle whose sine and cosine are returned: the text of the angle, its sine and its cosine.
    handed_on: Vec<String>,
    /// Statements in order, one per line.
    pub statements: String,
    n_statements: usize,
    /// The text of each result that is returned.
    pub results: Vec<String>,
    /// The places of the results that are written to memory, which are the first of all; `None` if all are returned.
    places: Option<&'p [String]>,
    /// By value: the results that it is, and that are not written yet.
    unwritten: HashMap<ExprId, Vec<usize>>,
    /// Results whose values have been computed since the last were written.
    ready: Vec<usize>,
    /// By node: number of uses, as far as it counts.
    uses: Vec<u8>,
    /// Nodes that get a statement of their own.
    own_statement: NodeSet,
    /// By angle: the angle whose sine and cosine are computed in the same call.
    pairs: HashMap<ExprId, ExprId>,
    /// By node: index of its name in `idents` plus 1; 0 if it has none.
    named: Vec<u32>,
    idents: Idents,
    /// Working memory of [`Body::statement`].
    ident: String,
    scope: Scope,
    read: [bool; 6],
    /// Working memory of [`Body::read_arguments`].
    stack: Vec<ExprId>,
}

impl<'p> Body<'p> {
    /// The statements that compute `roots`; the first of these are written to `places`, the others are returned.
    pub fn new(
        program: &'p Program,
        (roots, places): (&[ExprId], Option<&'p [String]>),
        options: &'p EmitOptions,
        (parameters, sines): (Parameters<'p>, Sines<'p>),
    ) -> Self {
        let mut body = Self::empty(program, roots, options, (parameters, sines));
        body.places = places;
        let steps = body.steps(roots);
        let values: Vec<ExprId> = roots.iter().map(|&root| body.value(root)).collect();
        let results = Results { all: &values, written: places.map_or(0, <[String]>::len) };
        let order = schedule::order(&steps, results, order_for(program, options));
        body.write(roots, (&steps, &values), &order);
        body
    }

    /// Largest number of values alive at once while `roots` are computed, of which the first are `written` to memory.
    pub fn most_waiting(
        program: &'p Program,
        (roots, written): (&[ExprId], usize),
        options: &'p EmitOptions,
        parameters: Parameters<'p>,
    ) -> usize {
        let mut body = Self::empty(program, roots, options, (parameters, Sines::Own));
        let steps = body.steps(roots);
        let values: Vec<ExprId> = roots.iter().map(|&root| body.value(root)).collect();
        schedule::most_waiting(&steps, Results { all: &values, written }, order_for(program, options))
    }

    fn empty(
        program: &'p Program,
        roots: &[ExprId],
        options: &'p EmitOptions,
        (parameters, sines): (Parameters<'p>, Sines<'p>),
    ) -> Self {
        let n = roots.iter().map(|root| root.index() + 1).max().unwrap_or(0);
        Self {
            program,
            options,
            parameters,
            sines,
            handed_on: vec![String::new(); sines.handed_on().len()],
            statements: String::new(),
            n_statements: 0,
            results: Vec::new(),
            places: None,
            unwritten: HashMap::default(),
            ready: Vec::new(),
            uses: vec![0; n],
            own_statement: NodeSet::below(n),
            pairs: HashMap::default(),
            named: vec![0; n],
            idents: Idents::default(),
            ident: String::new(),
            scope: Scope::of_function(),
            read: [false; 6],
            stack: Vec::new(),
        }
    }

    /// Writes the steps as statements, in this order.
    fn write(&mut self, roots: &[ExprId], (steps, results): (&[Step], &[ExprId]), order: &[usize]) {
        self.count_uses(steps, results);
        self.break_up(order.iter().map(|&step| &steps[step]));
        self.await_results(results);
        let mut sections = matches!(self.parameters, Parameters::Prepared { .. })
            .then(|| Sections::new(&self.program.dag, roots));
        for &step in order {
            let id = steps[step].makes[0];
            if self.own_statement.contains(id) {
                if let Some(heading) = sections.as_mut().and_then(|sections| sections.begin(id)) {
                    let _ = writeln!(self.statements, "    // {heading}.");
                }
                steps[step].makes.iter().for_each(|&id| self.read_arguments(id));
                self.statement(id);
                self.write_results(roots);
            }
        }
        for &root in roots {
            self.read_arguments(root);
        }
        self.write_other_results(roots);
        if self.n_statements > MOST_LETS {
            self.statements = groups::declared_in_groups(&self.statements);
        }
        self.results = roots[self.places().len()..].iter().map(|&root| self.operand(root)).collect();
    }

    fn dag(&self) -> &'p Dag {
        &self.program.dag
    }

    fn places(&self) -> &'p [String] {
        self.places.unwrap_or_default()
    }

    /// Name of the field of `Prepared` that holds the node.
    fn field(&self, id: ExprId) -> Option<&'p str> {
        match self.parameters {
            Parameters::Prepared { prepared, .. } => prepared.field(id),
            Parameters::Given(_) => None,
        }
    }

    /// Operands that the body computes; none for values that it reads. Sine and cosine of a difference have its two
    /// angles as operands.
    fn operands(&self, id: ExprId) -> [Option<ExprId>; 2] {
        match self.dag().node(id) {
            _ if self.field(id).is_some() => [None, None],
            Node::Unary(Unary::Sin | Unary::Cos, angle) => self.angles(angle),
            _ => self.dag().operands(id),
        }
    }

    /// The operands of the sine and cosine of an angle: its value, or the two angles of which it is the difference.
    fn angles(&self, angle: ExprId) -> [Option<ExprId>; 2] {
        match self.dag().as_difference(angle) {
            Some(of) if self.field(angle).is_none() => of.map(Some),
            _ => [Some(angle), None],
        }
    }

    fn name(&mut self, id: ExprId, ident: &str) {
        self.idents.push(ident);
        self.named[id.index()] = self.idents.len() as u32;
        if let Some(results) = self.unwritten.remove(&id) {
            self.ready.extend(results);
        }
    }

    /// `let left = right;`
    fn push(&mut self, left: &str, right: std::fmt::Arguments) {
        let _ = writeln!(self.statements, "    let {left} = {right};");
        self.n_statements += 1;
    }

    /// Appends to the last statement the place where the model declares its value.
    fn note(&mut self, place: &str) {
        self.statements.truncate(self.statements.trim_end().len());
        let _ = writeln!(self.statements, " // {}", escape::line(place));
    }

    /// Writes statements that read those arguments of `id` that have not been read yet.
    fn read_arguments(&mut self, id: ExprId) {
        let dag = self.dag();
        let mut stack = std::mem::take(&mut self.stack);
        stack.push(id);
        while let Some(id) = stack.pop() {
            if self.has_ident(id) || dag.is_constant(id) {
                continue;
            }
            if let Some(field) = self.field(id) {
                self.read_parameter(id, field, field);
            } else if let Node::Symbol(symbol) = dag.node(id) {
                self.load(id, symbol);
            }
            stack.extend(self.operands(id).into_iter().rev().flatten().filter(|&a| !self.has_ident(a)));
        }
        self.stack = stack;
    }

    /// `let hA = q[0];`
    fn load(&mut self, id: ExprId, symbol: SymbolId) {
        let program = self.program;
        let lists = [&program.q, &program.u, &program.inputs, &program.u_dot];
        if symbol == program.time {
            self.read[0] = true;
            self.name(id, "t");
            return;
        }
        for (group, list) in lists.iter().enumerate() {
            if let Some(index) = list.iter().position(|x| x.symbol == symbol) {
                self.read[group + 1] = true;
                let ident = self.scope.unique(&list[index].name);
                let array = ARGUMENTS[group + 1];
                self.push(&ident, format_args!("{array}[{index}]"));
                self.note(&list[index].place);
                self.name(id, &ident);
                return;
            }
        }
        let parameter = program.parameters.iter().position(|p| p.symbol == symbol);
        if let (Parameters::Given(fields), Some(index)) = (self.parameters, parameter) {
            self.read_parameter(id, &fields[index], &fields[index]);
        }
    }

    /// `let m = p.m;`
    fn read_parameter(&mut self, id: ExprId, wished: &str, field: &str) {
        self.read[5] = true;
        let ident = self.scope.unique(wished);
        self.push(&ident, format_args!("p.{field}"));
        self.name(id, &ident);
    }

    fn statement(&mut self, id: ExprId) {
        let dag = self.dag();
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = dag.node(id) {
            self.sin_cos(angle);
            return;
        }
        let mut ident = std::mem::take(&mut self.ident);
        match dag.name_of(id) {
            Some(name) => ident = self.scope.unique(name),
            None => self.scope.temporary(&mut ident),
        }
        let mut text = std::mem::take(&mut self.statements);
        for part in ["    let ", &ident, " = "] {
            text.push_str(part);
        }
        self.write_expression(&mut text, id);
        text.push_str(";\n");
        self.statements = text;
        self.n_statements += 1;
        if let Some(place) = dag.label_of(id).and_then(|label| label.place.as_deref()) {
            self.note(place);
        }
        self.name(id, &ident);
        self.ident = ident;
    }

    /// `let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);`, or the call for two angles at once, for a difference of
    /// angles, or for an angle close to one whose sine and cosine are given.
    fn sin_cos(&mut self, angle: ExprId) {
        if let Some(place) = self.sines.given().iter().position(|&given| given == angle) {
            let (argument, names) = (self.operand(angle), self.name_sin_cos(angle));
            self.push(&names, format_args!("Real::sin_cos_near({argument}, &{NEAR}[{place}])"));
            return;
        }
        let angles: Vec<ExprId> = [angle].into_iter().chain(self.pairs.get(&angle).copied()).collect();
        let of = angles.iter().flat_map(|&angle| self.angles(angle)).flatten();
        let arguments: Vec<String> = of.map(|angle| self.operand(angle)).collect();
        let names: Vec<String> = angles.iter().map(|&angle| self.name_sin_cos(angle)).collect();
        let function = match (angles.len(), arguments.len()) {
            (1, 1) => "sin_cos",
            (1, _) => "sin_cos_of_difference",
            (_, 2) => "sin_cos_of_two",
            _ => "sin_cos_of_two_differences",
        };
        let (names, arguments) = (names.join(", "), arguments.join(", "));
        let names = if angles.len() == 1 { names } else { format!("[{names}]") };
        self.push(&names, format_args!("Real::{function}({arguments})"));
    }

    /// `(sin_psiA, cos_psiA)`; a value that is not used is written `_`.
    fn name_sin_cos(&mut self, angle: ExprId) -> String {
        let of = match self.ident(angle) {
            Some(name) => name.to_owned(),
            None => format!("angle{}", self.n_statements),
        };
        let place = self.sines.handed_on().iter().position(|&handed_on| handed_on == angle);
        let names = [Unary::Sin, Unary::Cos].map(|function| {
            let is_read = |id: &ExprId| self.uses.get(id.index()).is_some_and(|&n| n > 0);
            let id = self.dag().find(Node::Unary(function, angle)).filter(is_read);
            if id.is_none() && place.is_none() {
                return "_".to_owned();
            }
            let name = self.scope.unique(&format!("{}_{of}", unary_name(function)));
            id.into_iter().for_each(|id| self.name(id, &name));
            name
        });
        if let Some(place) = place {
            let ([sin, cos], angle) = (&names, self.operand(angle));
            let turn = format!(
                "{}::real::Turn {{ angle: {angle}, sin: {sin}, cos: {cos} }}",
                self.options.runtime.trim()
            );
            self.handed_on[place] = turn;
        }
        format!("({})", names.join(", "))
    }

    /// `near: [Turn { .. }, ..]`, if the function returns its sines and cosines.
    pub fn handed_on(&self) -> Option<String> {
        matches!(self.sines, Sines::HandedOn(_)).then(|| format!("{NEAR}: [{}]", self.handed_on.join(", ")))
    }

    /// The arguments of the signature; names of unused ones begin with an underscore.
    pub fn arguments(&self) -> Vec<String> {
        let program = self.program;
        let underscore = |read: bool| if read { "" } else { "_" };
        let takes_u_dot = match self.parameters {
            Parameters::Given(_) => return vec![format!("{}p: &Parameters", underscore(self.read[5]))],
            Parameters::Prepared { takes_u_dot, .. } => takes_u_dot,
        };
        let array = |n: usize| format!("&[S; {n}usize]");
        let (q, u, inputs) = (&program.q, &program.u, &program.inputs);
        let [q, u, inputs] = [q, u, inputs].map(|list| array(list.len()));
        let types = ["S".to_owned(), q, u.clone(), inputs, u, "&Prepared".to_owned()];
        let named = ARGUMENTS.iter().zip(types).zip(self.read);
        let named = named.filter(|((name, _), _)| takes_u_dot || **name != "u_dot");
        let near = matches!(self.sines, Sines::Near(_)).then(|| {
            let (runtime, read) = (self.options.runtime.trim(), !self.sines.given().is_empty());
            format!("{}{NEAR}: &[{runtime}::real::Turn<S>; N_NEAR]", underscore(read))
        });
        let written = self.places.map(|_| self.written()).into_iter().flatten();
        let named = named.map(|((name, ty), read)| format!("{}{name}: {ty}", underscore(read)));
        named.chain(near).chain(written).collect()
    }
}

/// The kind of order for a program: refined by a search if the microcontroller is named and all effort is asked for.
fn order_for(program: &Program, options: &EmitOptions) -> Order {
    let is_refined = options.core == Some(Core::CortexM4) && program.origin.settings.effort == Effort::All;
    Order { core: options.core(), is_refined }
}
