//! Expression text -> tree: Rust's notation, names resolved, every node with its place.
//!
//! In: a [`Text`] and the model's [`Scope`]. Out: [`Expr`]. All faults of an expression that can
//! be told apart are reported; the tree is then incomplete and never used.

use super::document::Text;
use super::lexing;
use super::scope::{Binding, RESERVED, Scope, suggestion, usage};
use super::syntax::{self, Fault, Kind, Number, Syntax, Word};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::expression::{Axis, Expr, ExprKind, Function};
use crate::model::ids::FrameId;
use crate::model::unit::{self, Unit};
use crate::model::unit_hint;
use crate::source::Span;
use std::ops::Range;

/// Largest integer exponent.
pub const LARGEST_EXPONENT: i32 = 64;

/// Functions of scalars by name, with the number of their arguments.
pub const FUNCTIONS: [(&str, Function, usize); 15] = [
    ("sin", Function::Sin, 1),
    ("cos", Function::Cos, 1),
    ("tan", Function::Tan, 1),
    ("asin", Function::Asin, 1),
    ("acos", Function::Acos, 1),
    ("atan2", Function::Atan2, 2),
    ("sqrt", Function::Sqrt, 1),
    ("exp", Function::Exp, 1),
    ("ln", Function::Ln, 1),
    ("tanh", Function::Tanh, 1),
    ("abs", Function::Abs, 1),
    ("sign", Function::Sign, 1),
    ("min", Function::Min, 2),
    ("max", Function::Max, 2),
    ("smooth_step", Function::SmoothStep, 2),
];

/// Functions that are not a [`Function`]: of vectors, of names, and powers.
const OTHER_FUNCTIONS: [&str; 9] =
    ["dot", "cross", "norm", "velocity", "angular_velocity", "q_dot", "powi", "pow", "radians"];

/// Reads one expression; `None` if at least one error has been reported.
pub fn parse(text: &Text, scope: &Scope, found: &mut Diagnostics) -> Option<Expr> {
    if let Err((message, range, help)) = lexing::check(&text.text) {
        found.push(Diagnostic::error(message).label(text.place(range), "here").help(help));
        return None;
    }
    let mut reader = Reader { text, scope, found };
    // Most texts are a single word, which needs no parser.
    if let Some(kind) = reader.known(text.text.trim()) {
        let start = text.text.len() - text.text.trim_start().len();
        let place = text.place(start..start + text.text.trim().len());
        return Some(Expr { kind, span: place, unit: Unit::NONE });
    }
    match syntax::read(&text.text) {
        Ok(syntax) => reader.expression(&syntax),
        Err(Fault::Foreign(range)) => {
            found.push(foreign_notation(text.place(range)));
            None
        }
        Err(Fault::Broken(why, range)) => {
            found.push(
                Diagnostic::error(format!("not an expression: {why}"))
                    .label(text.place(range), "this is not understood")
                    .help("expressions follow Rust's notation: 2*(a + b)*sin(q) - x.powi(2), with * in every product and units as in 20_deg"),
            );
            None
        }
    }
}

/// The error for Rust notation that the language does not have.
fn foreign_notation(place: Span) -> Diagnostic {
    Diagnostic::error("this notation is not part of the expression language")
        .label(place, "not understood")
        .help("expressions consist of names, numbers, + - * / ( ) , and calls such as sin(q)")
}

struct Reader<'a> {
    text: &'a Text,
    scope: &'a Scope,
    found: &'a mut Diagnostics,
}

impl Reader<'_> {
    fn node(&self, kind: ExprKind, range: &Range<usize>) -> Option<Expr> {
        Some(Expr { kind, span: self.text.place(range.clone()), unit: Unit::NONE })
    }

    fn refuse<T>(&mut self, range: &Range<usize>, message: String, label: &str, help: &str) -> Option<T> {
        self.found.push(Diagnostic::error(message).label(self.text.place(range.clone()), label).help(help));
        None
    }

    fn expression(&mut self, syntax: &Syntax) -> Option<Expr> {
        let range = &syntax.range;
        match &syntax.kind {
            Kind::Group(inner) => self.expression(inner),
            Kind::Number(number) => self.number(number, range),
            Kind::Word(name) => self.name(name, range),
            Kind::Negate(inner) => {
                let inner = self.expression(inner)?;
                self.node(ExprKind::Negate(Box::new(inner)), range)
            }
            Kind::Binary(sign, left, right) => self.binary(*sign, left, right),
            Kind::Part(base, part) => self.axis(base, part, range),
            Kind::Call(function, arguments) => {
                let name = self.word(function)?;
                self.call(&name, &function.range, &arguments.iter().collect::<Vec<_>>(), range)
            }
            Kind::Method(method, arguments) => {
                self.call(&method.text, &method.range, &arguments.iter().collect::<Vec<_>>(), range)
            }
            Kind::Star => {
                self.refuse(range, "unexpected `*`".to_owned(), "here", "powers are written x.powi(2)")
            }
        }
    }

    /// A single word.
    fn word(&mut self, syntax: &Syntax) -> Option<String> {
        match &syntax.kind {
            Kind::Word(name) => Some(name.clone()),
            _ => self.refuse(
                &syntax.range,
                "a name is expected here".to_owned(),
                "not a name",
                "names are single words",
            ),
        }
    }

    fn number(&mut self, number: &Number, range: &Range<usize>) -> Option<Expr> {
        let Number { digits, suffix, .. } = number;
        let value: f64 = digits.parse().unwrap_or(f64::INFINITY);
        if !value.is_finite() {
            return self.refuse(
                range,
                "the number is too large".to_owned(),
                "beyond 1.8e308",
                "write a finite number",
            );
        }
        let whole = &self.text.text[range.clone()];
        let suffix = suffix.trim_start_matches('_');
        // `2m` would be two metres to one reader and twice m to another.
        if !suffix.is_empty() && !whole.contains('_') {
            let help = match unit::named(suffix) {
                Some(_) => format!(
                    "write {digits}*{suffix} for the product, {digits}_{suffix} for a number in the unit {suffix}"
                ),
                None => format!("write {digits}*{suffix}"),
            };
            return self.refuse(
                range,
                format!("`{whole}` is neither a product nor a number with a unit"),
                "a number and a name side by side",
                &help,
            );
        }
        let scale = match unit::named(suffix) {
            Some(scale) => scale,
            None if suffix.is_empty() => unit::Scale { unit: Unit::NONE, factor: 1.0 },
            None => {
                let help = unit_hint::single(suffix)
                    .unwrap_or_else(|| "a number may carry one unit: 0.12_m, 0.8_Hz, 90_deg".to_owned());
                return self.refuse(range, format!("unknown unit `{suffix}`"), "on this number", &help);
            }
        };
        let node = self.node(ExprKind::Number(value * scale.factor), range)?;
        Some(Expr { unit: scale.unit, ..node })
    }

    fn name(&mut self, name: &str, span: &Range<usize>) -> Option<Expr> {
        match self.known(name) {
            Some(kind) => self.node(kind, span),
            None => self.unknown(name, span),
        }
    }

    /// What a name stands for.
    fn known(&self, name: &str) -> Option<ExprKind> {
        Some(match (name, self.scope.values.get(name)) {
            ("t", _) => ExprKind::Time,
            ("pi", _) => ExprKind::Pi,
            ("deg", _) => ExprKind::Degree,
            (_, Some((binding, _))) => match *binding {
                Binding::Parameter(id) => ExprKind::Parameter(id),
                Binding::Coordinate(id) => ExprKind::Coordinate(id),
                Binding::Speed(id) => ExprKind::Speed(id),
                Binding::Input(id) => ExprKind::Input(id),
                Binding::Definition(id) => ExprKind::Definition(id),
                Binding::Point(id) => ExprKind::Point(id),
            },
            (_, None) => return None,
        })
    }

    fn unknown<T>(&mut self, name: &str, span: &Range<usize>) -> Option<T> {
        let help = if self.scope.frames.contains_key(name) {
            format!("`{name}` is a frame: its unit vectors are {name}.x, {name}.y, {name}.z")
        } else if let Some(speed) = self.rate_meant(name) {
            format!("the rate of a coordinate is its speed: here `{speed}`")
        } else if FUNCTIONS.iter().any(|(known, ..)| *known == name) || OTHER_FUNCTIONS.contains(&name) {
            format!("`{name}` is a function: write {name}(...)")
        } else {
            let known = self.scope.values.keys().map(String::as_str).chain(RESERVED);
            suggestion(name, known)
                .unwrap_or_else(|| "declare it as a parameter, coordinate, input or definition".to_owned())
        };
        self.refuse(span, format!("unknown name `{name}`"), "not declared in this model", &help)
    }

    /// The speed meant by `q_dot`, `qd`, `q_d` or `qdot`, common names for the rate of a coordinate q.
    fn rate_meant(&self, name: &str) -> Option<String> {
        let rate = |c: &&str| matches!(self.scope.values.get(*c), Some((Binding::Coordinate(_), _)));
        let coordinate =
            ["_dot", "dot", "_d", "d"].iter().filter_map(|end| name.strip_suffix(end)).find(rate)?;
        let speed = format!("u_{coordinate}");
        self.scope.values.contains_key(&speed).then_some(speed)
    }

    fn binary(&mut self, sign: char, left: &Syntax, right: &Syntax) -> Option<Expr> {
        let left = self.expression(left);
        let right = self.expression(right);
        let (left, right) = (Box::new(left?), Box::new(right?));
        let span =
            Span { start: left.span.start, end: right.span.end.max(left.span.end), file: left.span.file };
        let kind = match sign {
            '+' => ExprKind::Add(left, right),
            '-' => ExprKind::Subtract(left, right),
            '*' => ExprKind::Multiply(left, right),
            _ => ExprKind::Divide(left, right),
        };
        Some(Expr { kind, span, unit: Unit::NONE })
    }

    /// `F.x`
    fn axis(&mut self, base: &Syntax, part: &Word, range: &Range<usize>) -> Option<Expr> {
        let name = self.word(base)?;
        let axis = match part.text.as_str() {
            "x" => Axis::X,
            "y" => Axis::Y,
            "z" => Axis::Z,
            _ => {
                let help = match self.scope.values.get(&name) {
                    Some((binding, _)) => format!(
                        "`{name}` is {}: its name alone is its value; a component of a vector is dot(vector, N.x)",
                        binding.kind()
                    ),
                    None => "write .x, .y or .z".to_owned(),
                };
                return self.refuse(
                    &part.range,
                    "only a frame has parts: the unit vectors x, y and z".to_owned(),
                    "not one of them",
                    &help,
                );
            }
        };
        let id = self.frame(&name, &base.range)?;
        self.node(ExprKind::Axis(id, axis), range)
    }

    fn frame(&mut self, name: &str, span: &Range<usize>) -> Option<FrameId> {
        if let Some((id, _)) = self.scope.frames.get(name) {
            return Some(*id);
        }
        let help = match self.scope.values.get(name) {
            Some((binding, _)) => {
                format!("`{name}` is {}; a component of a vector is dot(vector, N.x)", binding.kind())
            }
            None => suggestion(name, self.scope.frames.keys().map(String::as_str))
                .unwrap_or_else(|| "frames are declared in [frames]; N is the inertial one".to_owned()),
        };
        self.refuse(span, format!("unknown frame `{name}`"), "not a frame of this model", &help)
    }

    fn call(
        &mut self,
        name: &str,
        place: &Range<usize>,
        arguments: &[&Syntax],
        span: &Range<usize>,
    ) -> Option<Expr> {
        let wanted = FUNCTIONS.iter().find(|(known, ..)| *known == name).map(|(_, f, n)| (Some(*f), *n));
        let wanted = wanted.or(match name {
            "dot" | "cross" | "powi" | "pow" => Some((None, 2)),
            "norm" | "velocity" | "angular_velocity" | "q_dot" => Some((None, 1)),
            _ => None,
        });
        let Some((function, count)) = wanted else {
            let known = FUNCTIONS.iter().map(|(known, ..)| *known).chain(OTHER_FUNCTIONS);
            let help = suggestion(name, known)
                .unwrap_or_else(|| "functions are sin cos tan asin acos atan2 sqrt exp ln tanh abs sign min max smooth_step dot cross norm powi velocity angular_velocity q_dot".to_owned());
            return self.refuse(place, format!("unknown function `{name}`"), "not a function", &help);
        };
        if arguments.len() != count {
            let message = format!("`{name}` takes {}", crate::words::count(count, "argument"));
            return self.refuse(span, message, &format!("{} given", arguments.len()), &usage(name, count));
        }
        match name {
            "powi" | "pow" => return self.power(arguments, span),
            "velocity" | "angular_velocity" | "q_dot" => return self.of_name(name, arguments[0], span),
            _ => {}
        }
        let read: Vec<Option<Expr>> = arguments.iter().map(|a| self.expression(a)).collect();
        let mut read = read.into_iter().collect::<Option<Vec<Expr>>>()?;
        let kind = match function {
            Some(function) => ExprKind::Call(function, read),
            None => {
                let last = Box::new(read.pop()?);
                match (name, read.pop()) {
                    ("dot", Some(first)) => ExprKind::Dot(Box::new(first), last),
                    ("cross", Some(first)) => ExprKind::Cross(Box::new(first), last),
                    _ => ExprKind::Norm(last),
                }
            }
        };
        self.node(kind, span)
    }

    fn power(&mut self, arguments: &[&Syntax], span: &Range<usize>) -> Option<Expr> {
        let base = self.expression(arguments[0]);
        let (sign, literal) = match &arguments[1].kind {
            Kind::Negate(inner) => (-1, &inner.kind),
            other => (1, other),
        };
        let exponent = match literal {
            Kind::Number(number) if number.is_integer => {
                number.digits.parse::<i32>().ok().filter(|n| *n <= LARGEST_EXPONENT)
            }
            _ => None,
        };
        match exponent {
            Some(n) => self.node(ExprKind::Power(Box::new(base?), sign * n), span),
            None => self.refuse(
                &arguments[1].range,
                format!("an exponent is an integer between -{LARGEST_EXPONENT} and {LARGEST_EXPONENT}"),
                "not such a literal",
                "for a root write sqrt(x), for any other power exp(n*ln(x))",
            ),
        }
    }

    /// `velocity(P)`, `angular_velocity(F)`, `q_dot(q)`
    fn of_name(&mut self, function: &str, argument: &Syntax, span: &Range<usize>) -> Option<Expr> {
        let name = self.word(argument)?;
        if function == "angular_velocity" {
            let id = self.frame(&name, &argument.range)?;
            return self.node(ExprKind::AngularVelocity(id), span);
        }
        match (function, self.scope.values.get(&name)) {
            ("velocity", Some((Binding::Point(id), _))) => self.node(ExprKind::Velocity(*id), span),
            ("q_dot", Some((Binding::Coordinate(id), _))) => self.node(ExprKind::Rate(*id), span),
            (_, None) => self.unknown(&name, &argument.range),
            (_, Some((binding, _))) => {
                let expected = if function == "velocity" { "a point" } else { "a coordinate" };
                self.refuse(
                    &argument.range,
                    format!("`{function}` wants {expected}"),
                    &format!("this is {}", binding.kind()),
                    "give the name itself",
                )
            }
        }
    }
}
