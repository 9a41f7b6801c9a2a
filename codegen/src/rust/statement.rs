//! The body of one emitted function: `let` statements in the order the results need them.
//!
//! Written as text, one statement a line: a thousand straight-line statements through a token
//! parser and a general formatter took twenty times as long as the derivation's last stage.
//! A node gets a `let` if it is used more than once, has a name from the model, or would make its
//! statement too long; other nodes are written inside their only user. Depth-first order from the
//! results keeps live ranges short.

use super::ScalarType;
use super::name::Scope;
use super::prepared::Prepared;
use crate::expr::print::{binary_name, infix, unary_name};
use crate::expr::{Binary, Dag, ExprId, Node, SymbolId, Unary};
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};

/// Operations in one statement before it is broken up.
const LONGEST_STATEMENT: usize = 8;

/// Statements and results of a function.
pub(super) struct Body<'p> {
    program: &'p Program,
    scalar: &'p ScalarType,
    /// Where values of parameters are read; none in the function that computes them.
    prepared: Option<&'p Prepared>,
    /// Statements in order.
    pub statements: Vec<String>,
    /// Expressions of the results.
    pub results: Vec<String>,
    uses: HashMap<ExprId, usize>,
    own_statement: HashSet<ExprId>,
    ident: HashMap<ExprId, String>,
    scope: Scope,
    read: [bool; 5],
}

/// Groups of arguments, in the order of the signature.
const GROUPS: [&str; 5] = ["t", "q", "u", "inputs", "p"];

impl<'p> Body<'p> {
    /// Of an answer: it reads `p: &Prepared`.
    pub fn new(
        program: &'p Program,
        roots: &[ExprId],
        scalar: &'p ScalarType,
        prepared: &'p Prepared,
    ) -> Self {
        Self::of(program, roots, scalar, Some(prepared))
    }

    /// Of `prepare`: it reads `p: &Parameters`.
    pub fn of_parameters(program: &'p Program, roots: &[ExprId], scalar: &'p ScalarType) -> Self {
        Self::of(program, roots, scalar, None)
    }

    fn of(
        program: &'p Program,
        roots: &[ExprId],
        scalar: &'p ScalarType,
        prepared: Option<&'p Prepared>,
    ) -> Self {
        let mut body = Self {
            program,
            scalar,
            prepared,
            statements: Vec::new(),
            results: Vec::new(),
            uses: HashMap::default(),
            own_statement: HashSet::default(),
            ident: HashMap::default(),
            scope: Scope::default(),
            read: [false; 5],
        };
        for name in GROUPS {
            body.scope.reserve(name);
        }
        body.count_uses(roots);
        body.break_up(roots);
        for &root in roots {
            body.define(root);
        }
        body.results = roots.iter().map(|&r| body.operand(r)).collect();
        body
    }

    fn dag(&self) -> &'p Dag {
        &self.program.dag
    }

    /// Name of the field of `Prepared` that holds the node.
    fn field(&self, id: ExprId) -> Option<&'p str> {
        self.prepared?.field(id)
    }

    /// What the body computes or reads, operands first.
    fn order(&self, roots: &[ExprId]) -> Vec<ExprId> {
        self.dag().reachable_above(roots, |id| self.field(id).is_some())
    }

    /// Operands that the body computes: none of what it reads.
    fn operands(&self, id: ExprId) -> [Option<ExprId>; 2] {
        if self.field(id).is_some() { [None, None] } else { self.dag().operands(id) }
    }

    fn count_uses(&mut self, roots: &[ExprId]) {
        for id in self.order(roots) {
            for operand in self.operands(id).into_iter().flatten() {
                *self.uses.entry(operand).or_insert(0) += 1;
            }
        }
        for &root in roots {
            *self.uses.entry(root).or_insert(0) += 2;
        }
    }

    /// Decides which nodes get a statement of their own.
    fn break_up(&mut self, roots: &[ExprId]) {
        let dag = self.dag();
        let mut size: HashMap<ExprId, usize> = HashMap::default();
        for id in self.order(roots) {
            let read = matches!(dag.node(id), Node::Symbol(_)) || self.field(id).is_some();
            let trivial = dag.is_constant(id) || read;
            let inline: usize = self
                .operands(id)
                .into_iter()
                .flatten()
                .filter(|a| !self.own_statement.contains(a))
                .map(|a| size[&a])
                .sum();
            let total = inline + usize::from(dag.is_operation(id));
            let negation = matches!(dag.node(id), Node::Negate(_));
            let shared = self.uses.get(&id).is_some_and(|&n| n > 1) && !negation;
            let angle = matches!(dag.node(id), Node::Unary(Unary::Sin | Unary::Cos, _));
            if !trivial && (shared || angle || dag.name_of(id).is_some() || total > LONGEST_STATEMENT) {
                self.own_statement.insert(id);
            }
            size.insert(id, if trivial { 0 } else { total });
        }
    }

    /// Emits the statements that `root` needs, operands first.
    fn define(&mut self, root: ExprId) {
        let dag = self.dag();
        let mut stack = vec![(root, false)];
        let mut visited: HashSet<ExprId> = HashSet::default();
        while let Some((id, expanded)) = stack.pop() {
            if self.ident.contains_key(&id) || (!expanded && !visited.insert(id)) {
                continue;
            }
            if !expanded {
                stack.push((id, true));
                for operand in self.operands(id).into_iter().rev().flatten() {
                    stack.push((operand, false));
                }
                continue;
            }
            if let Some(field) = self.field(id) {
                self.read_parameter(id, field, field);
            } else if let Node::Symbol(symbol) = dag.node(id) {
                self.load(id, symbol);
            } else if self.own_statement.contains(&id) {
                self.statement(id);
            }
        }
    }

    /// `let hA = q[0];`
    fn load(&mut self, id: ExprId, symbol: SymbolId) {
        let program = self.program;
        let lists = [&program.q, &program.u, &program.inputs];
        if symbol == program.time {
            self.read[0] = true;
            self.ident.insert(id, "t".to_owned());
            return;
        }
        for (group, list) in lists.iter().enumerate() {
            if let Some(index) = list.iter().position(|x| x.symbol == symbol) {
                self.read[group + 1] = true;
                let ident = self.scope.unique(&list[index].name);
                let array = GROUPS[group + 1];
                self.statements.push(format!("let {ident} = {array}[{index}];"));
                self.ident.insert(id, ident);
                return;
            }
        }
        if let Some(parameter) = program.parameters.iter().find(|p| p.symbol == symbol) {
            let field = super::name::identifier(&parameter.name).to_string();
            self.read_parameter(id, &parameter.name, &field);
        }
    }

    /// `let m = p.m;`
    fn read_parameter(&mut self, id: ExprId, wished: &str, field: &str) {
        self.read[4] = true;
        let ident = self.scope.unique(wished);
        self.statements.push(format!("let {ident} = p.{field};"));
        self.ident.insert(id, ident);
    }

    fn statement(&mut self, id: ExprId) {
        let dag = self.dag();
        if let Node::Unary(function @ (Unary::Sin | Unary::Cos), angle) = dag.node(id) {
            self.sin_cos(id, function, angle);
            return;
        }
        let value = self.expression(id);
        let ident = match dag.name_of(id) {
            Some(name) => self.scope.unique(name),
            None => self.scope.temporary(),
        };
        self.statements.push(format!("let {ident} = {value};"));
        self.ident.insert(id, ident);
    }

    /// `let (sin_psiA, cos_psiA) = Real::sin_cos(psiA);`
    fn sin_cos(&mut self, id: ExprId, function: Unary, angle: ExprId) {
        let dag = self.dag();
        let (other, sine_first) = match function {
            Unary::Sin => (Unary::Cos, true),
            _ => (Unary::Sin, false),
        };
        let twin = dag.find(Node::Unary(other, angle)).filter(|t| self.uses.contains_key(t));
        let of = match self.ident.get(&angle) {
            Some(name) => name.clone(),
            None => format!("angle{}", self.statements.len()),
        };
        let argument = self.operand(angle);
        let mine = self.scope.unique(&format!("{}_{of}", unary_name(function)));
        let yours = match twin {
            Some(twin) => {
                let ident = self.scope.unique(&format!("{}_{of}", unary_name(other)));
                self.ident.insert(twin, ident.clone());
                ident
            }
            None => "_".to_owned(),
        };
        let (sin, cos) = if sine_first { (&mine, &yours) } else { (&yours, &mine) };
        self.statements.push(format!("let ({sin}, {cos}) = Real::sin_cos({argument});"));
        self.ident.insert(id, mine);
    }

    /// The node as an operand: its name, or its expression.
    fn operand(&self, id: ExprId) -> String {
        self.ident.get(&id).cloned().unwrap_or_else(|| self.expression(id))
    }

    fn expression(&self, id: ExprId) -> String {
        let dag = self.dag();
        if dag.is_constant(id) {
            return super::literal(dag.evaluate_constant(id), self.scalar);
        }
        match dag.node(id) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => self.ident[&id].clone(),
            Node::Negate(a) => format!("-{}", self.wrapped(a, is_sum)),
            Node::Unary(function, a) => format!("Real::{}({})", unary_name(function), self.operand(a)),
            Node::Binary(operator, a, b) => self.binary(operator, a, b),
        }
    }

    /// Parentheses keep the DAG's own order of operations: a + (b + c) is not (a + b) + c.
    fn binary(&self, operator: Binary, a: ExprId, b: ExprId) -> String {
        let sum_or_negation = |n: Node| is_sum(n) || matches!(n, Node::Negate(_));
        let any = |n: Node| sum_or_negation(n) || matches!(n, Node::Binary(Binary::Mul | Binary::Div, ..));
        let (name, symbol) = (binary_name(operator), infix(operator).unwrap_or_default());
        match operator {
            Binary::Add | Binary::Sub => {
                format!("{}{symbol}{}", self.operand(a), self.wrapped(b, sum_or_negation))
            }
            Binary::Mul | Binary::Div => {
                format!("{}{symbol}{}", self.wrapped(a, is_sum), self.wrapped(b, any))
            }
            Binary::Atan2 | Binary::Min | Binary::Max => {
                format!("Real::{name}({}, {})", self.operand(a), self.operand(b))
            }
        }
    }

    /// In parentheses if it is written out here and `needs` says so of its node.
    fn wrapped(&self, id: ExprId, needs: impl Fn(Node) -> bool) -> String {
        let text = self.operand(id);
        let inline = !self.ident.contains_key(&id) && !self.dag().is_constant(id);
        if inline && needs(self.dag().node(id)) { format!("({text})") } else { text }
    }

    /// The signature; what is not read gets an underscore.
    pub fn arguments(&self) -> TokenStream {
        let program = self.program;
        if self.prepared.is_none() {
            let p = if self.read[4] { format_ident!("p") } else { format_ident!("_p") };
            return quote!(#p: &Parameters);
        }
        let (nq, nu, ni) = (program.q.len(), program.u.len(), program.inputs.len());
        let types = [quote!(S), quote!(&[S; #nq]), quote!(&[S; #nu]), quote!(&[S; #ni]), quote!(&Prepared)];
        let arguments = GROUPS.iter().zip(types).zip(self.read).map(|((name, ty), read)| {
            let ident = if read { format_ident!("{name}") } else { format_ident!("_{name}") };
            quote!(#ident: #ty)
        });
        quote!(#(#arguments),*)
    }
}

fn is_sum(node: Node) -> bool {
    matches!(node, Node::Binary(Binary::Add | Binary::Sub, ..))
}
