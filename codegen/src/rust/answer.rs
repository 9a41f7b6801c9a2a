//! Functions of the emitted file and their return types.
//!
//! In: the requested functions. Out: their names, types and values in Rust. An answer that every program has is
//! returned as a tuple of its parts, a requested one as a struct with a field per part; a function with several answers
//! returns a struct with a field per answer.

use super::layout::{self, PLAIN_STRUCT, UNREAD};
use super::name::{self, NEAR, Scope};
use super::options::EmitOptions;
use crate::expr::ExprId;
use crate::program::Program;
use crate::program::answer::{Answer, Function, Part, Request, Shape};
use std::collections::BTreeMap;

/// The answer that is written to memory.
pub(super) const RATES: &str = "rates";

/// Number of operations by kind.
pub(super) type Cost = BTreeMap<&'static str, usize>;

/// A function to be emitted.
pub(super) struct Emitted {
    /// Its name.
    pub name: String,
    /// The name asked for; `name` differs from it where that is no identifier, or in use.
    asked: String,
    /// For rates alone: the name of the function that writes them to memory. The function itself then calls that one.
    pub into: Option<String>,
    /// What it returns, for its documentation.
    pub doc: String,
    answers: Vec<Field>,
    /// How it treats the sines and cosines that the functions of a step share.
    pub role: Role,
    /// The struct with a field per answer, if there are several.
    together: Option<String>,
}

/// The role of a function in a step with shared sines and cosines.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// It shares nothing.
    Alone,
    /// The first evaluation: it returns its sines and cosines.
    First,
    /// A later evaluation at angles close by: it starts from those sines and cosines.
    Close,
}

/// An answer and its name in Rust.
struct Field {
    answer: Answer,
    name: String,
    /// The name of its struct; `None` if it is a tuple.
    structure: Option<String>,
}

/// The functions of a file, in order; answers that the program does not have are omitted.
pub(super) fn functions(program: &Program, options: &EmitOptions) -> Vec<Emitted> {
    let mut asked: Vec<(Function, Role)> = Vec::new();
    if options.functions.is_empty() {
        asked.extend(Function::each(&program.standing()).into_iter().map(|function| (function, Role::Alone)));
        asked.extend(program.functions.iter().map(|function| (function.clone(), Role::Alone)));
        asked.extend(options.shared_work.then(functions_of_a_step).into_iter().flatten());
    } else {
        asked.extend(options.functions.iter().map(|function| (function.clone(), Role::Alone)));
    }
    let (mut names, mut types) = (Scope::of_functions(), Scope::of_types(program));
    let mut structures: BTreeMap<String, String> = BTreeMap::new();
    let mut emitted = Vec::new();
    for (function, role) in asked {
        let mut fields = Scope::default();
        let mut answers: Vec<Field> = Vec::new();
        for answer in program.answers_of(&function) {
            let structure = (!answer.is_tuple).then(|| {
                let new = || types.unique_type(&name::type_name(&answer.name));
                structures.entry(answer.name.clone()).or_insert_with(new).clone()
            });
            answers.push(Field { name: fields.unique(&answer.name), structure, answer });
        }
        if answers.is_empty() {
            continue;
        }
        let together = (function.requests.len() > 1 || role == Role::First)
            .then(|| types.unique_type(&name::type_name(&function.name)));
        let doc = match answers.as_slice() {
            [only] if role == Role::Close => {
                format!("{} Sines and cosines are turned on from those of a place close by.", only.answer.doc)
            }
            [only] => only.answer.doc.clone(),
            all => {
                let names: Vec<&str> = all.iter().map(|field| field.answer.name.as_str()).collect();
                format!("Together, what they share computed once: {}.", names.join(", "))
            }
        };
        let is_rates =
            matches!(answers.as_slice(), [only] if only.answer.name == RATES) && together.is_none();
        let name = names.unique(&function.name);
        let into = is_rates.then(|| names.unique(&format!("{name}_into")));
        emitted.push(Emitted { name, asked: function.name.clone(), into, doc, answers, role, together });
    }
    emitted
}

/// The names of the emitted functions, by the names asked for.
#[must_use]
pub fn function_names(program: &Program, options: &EmitOptions) -> BTreeMap<String, String> {
    functions(program, options).into_iter().map(|function| (function.asked, function.name)).collect()
}

/// The functions of a step: the first evaluation together with the correction, and the later evaluations.
fn functions_of_a_step() -> [(Function, Role); 2] {
    let requests = |names: &[&str]| names.iter().map(|name| Request::new(name)).collect();
    let first = requests(&["rates", "projection", "speed_projection"]);
    [
        (Function { name: "begin_step".to_owned(), requests: first }, Role::First),
        (Function { name: "rates_near".to_owned(), requests: requests(&["rates"]) }, Role::Close),
    ]
}

impl Emitted {
    /// All results in order.
    pub fn roots(&self) -> Vec<ExprId> {
        self.answers.iter().flat_map(|field| field.answer.roots()).collect()
    }

    /// Does it take derivatives of the speeds as an argument?
    pub fn takes_u_dot(&self) -> bool {
        self.answers.iter().any(|field| field.answer.takes_u_dot)
    }

    /// The places of the results that are written to memory: all but the last, which is the worst pivot.
    pub fn places(&self) -> Option<Vec<String>> {
        self.into.as_ref()?;
        let parts = self.answers.iter().flat_map(|field| &field.answer.parts);
        let lists = parts.filter(|part| matches!(part.shape, Shape::List(_))).zip(name::RATES);
        Some(
            lists
                .flat_map(|(part, name)| (0..part.values.len()).map(move |index| format!("{name}[{index}]")))
                .collect(),
        )
    }

    /// Does it return this answer?
    pub fn gives(&self, answer: &str) -> bool {
        self.answers.iter().any(|field| field.answer.name == answer)
    }

    /// The structs of its answers that are not in `defined` yet, and its own.
    pub fn structures(&self, defined: &mut Vec<String>, handed_on: usize, runtime: &str) -> String {
        let mut text = String::new();
        for field in &self.answers {
            let Some(name) = field.structure.as_ref().filter(|name| !defined.contains(name)) else {
                continue;
            };
            defined.push(name.clone());
            let parts = field.answer.parts.iter();
            let members = parts.map(|p| format!("/// {}.\n    pub {}: {}", sentence(p), p.name, type_of(p)));
            text += &format!("/// {}\n{PLAIN_STRUCT}", field.answer.doc);
            text += &layout::block(&format!("pub struct {name}"), members, "");
        }
        if let Some(name) = &self.together {
            let members = self
                .answers
                .iter()
                .map(|field| format!("/// {}\n    pub {}: {}", field.answer.doc, field.name, field.output()));
            let near = (self.role == Role::First).then(|| {
                let angles = "/// Angles with their sines and cosines, for evaluations close by.";
                format!("{angles}\n    pub {NEAR}: [{runtime}::real::Turn<S>; N_NEAR]")
            });
            if near.is_some() {
                text += "/// Number of angles whose sines and cosines are handed on.\n";
                text += &format!("{UNREAD}pub const N_NEAR: usize = {handed_on}usize;\n");
            }
            text += &format!("/// {}\n{PLAIN_STRUCT}", self.doc);
            text += &layout::block(&format!("pub struct {name}"), members.chain(near), "");
        }
        text
    }

    /// The type that it returns.
    pub fn output(&self) -> String {
        match (&self.together, self.answers.as_slice()) {
            (None, [only]) => only.output(),
            (name, _) => name.clone().unwrap_or_default(),
        }
    }

    /// The expression of its return value, from the expressions of all results.
    pub fn result(&self, results: &[String], near: Option<String>) -> String {
        let mut rest = results;
        let mut values = self.answers.iter().map(|field| field.value(&mut rest)).collect::<Vec<_>>();
        match &self.together {
            None => values.pop().unwrap_or_default(),
            Some(name) => {
                let members = self.answers.iter().zip(values);
                let members = members.map(|(f, value)| format!("{}: {value}", f.name)).chain(near);
                let members: Vec<String> = members.collect();
                format!("{name} {{ {} }}", members.join(", "))
            }
        }
    }
}

impl Field {
    fn output(&self) -> String {
        match (&self.structure, self.answer.parts.as_slice()) {
            (Some(name), _) => name.clone(),
            (None, [only]) => type_of(only),
            (None, parts) => {
                let types: Vec<String> = parts.iter().map(type_of).collect();
                format!("({})", types.join(", "))
            }
        }
    }

    /// The expression of this answer, whose results are removed from the front of the list.
    fn value(&self, results: &mut &[String]) -> String {
        let mut values: Vec<String> = Vec::new();
        for part in &self.answer.parts {
            let (own, rest) = results.split_at(part.values.len());
            *results = rest;
            let list = |items: &[String]| format!("[{}]", items.join(", "));
            values.push(match part.shape {
                Shape::Number => own.concat(),
                Shape::List(_) => list(own),
                // A row may be empty, as in the Jacobian of a mechanism that moves with time alone.
                Shape::Matrix(rows, columns) => list(
                    &(0..rows).map(|row| list(&own[row * columns..(row + 1) * columns])).collect::<Vec<_>>(),
                ),
            });
        }
        match &self.structure {
            None if values.len() == 1 => values.concat(),
            None => format!("({})", values.join(", ")),
            Some(name) => {
                let parts = self.answer.parts.iter().zip(values);
                let members: Vec<String> = parts.map(|(p, value)| format!("{}: {value}", p.name)).collect();
                format!("{name} {{ {} }}", members.join(", "))
            }
        }
    }
}

fn type_of(part: &Part) -> String {
    match part.shape {
        Shape::Number => "S".to_owned(),
        Shape::List(n) => format!("[S; {n}usize]"),
        Shape::Matrix(rows, columns) => format!("[[S; {columns}usize]; {rows}usize]"),
    }
}

/// The documentation of a part, including the names of its entries.
fn sentence(part: &Part) -> String {
    match part.labels.is_empty() {
        true => name::sentence(&part.doc, part.name),
        false => format!("{}: {}", name::sentence(&part.doc, part.name), part.labels.join(", ")),
    }
}
