//! Expression text -> tree: Rust's notation read with syn, names resolved, every node with its place.
//!
//! In: a [`Text`] and the model's [`Scope`]. Out: [`Expr`]. All faults of an expression that can
//! be told apart are reported; the tree is then incomplete and never used.

extern crate proc_macro;

use crate::model::ids::FrameId;
use proc_macro2::Span as RustSpan;
use syn::spanned::Spanned;

use super::document::Text;
use super::lexing;
use super::scope::{Binding, RESERVED, Scope, suggestion, usage};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::expression::{Axis, Expr, ExprKind, Function};
use crate::model::unit::{self, Unit};
use crate::source::Span;

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

/// Functions that are no [`Function`]: of vectors, of names, and powers.
const OTHER_FUNCTIONS: [&str; 9] =
    ["dot", "cross", "norm", "velocity", "angular_velocity", "q_dot", "powi", "pow", "radians"];

/// Reads one expression. None: at least one fault has been reported.
pub fn parse(text: &Text, scope: &Scope, found: &mut Diagnostics) -> Option<Expr> {
    if let Err((message, range, help)) = lexing::check(&text.text) {
        found.push(Diagnostic::error(message).label(text.place(range), "here").help(help));
        return None;
    }
    let mut reader = Reader { text, scope, found };
    // Most texts are one word: no parser is needed to read it.
    if let Some(kind) = reader.known(text.text.trim()) {
        let start = text.text.len() - text.text.trim_start().len();
        let place = text.place(start..start + text.text.trim().len());
        return Some(Expr { kind, span: place, unit: Unit::NONE });
    }
    let result = match syn::parse_str::<syn::Expr>(&text.text) {
        Ok(syntax) => reader.expression(&syntax),
        // A keyword of Rust that the parser is built without.
        Err(error) if error.to_string().starts_with("unsupported expression") => {
            found.push(foreign_notation(text.place(error.span().byte_range())));
            None
        }
        Err(error) => {
            found.push(
                Diagnostic::error(format!("not an expression: {error}"))
                    .label(text.place(error.span().byte_range()), "the notation breaks here")
                    .help("expressions follow Rust's notation: 2*(a + b)*sin(q) - x.powi(2), with * in every product and units as in 20_deg"),
            );
            None
        }
    };
    forget_spans();
    result
}

/// Rust that no expression of a model has.
fn foreign_notation(place: Span) -> Diagnostic {
    Diagnostic::error("this notation is not part of the expression language")
        .label(place, "not understood")
        .help("expressions consist of names, numbers, + - * / ( ) , and calls such as sin(q)")
}

/// Stack of the thread that reads expressions (bytes): nesting is bounded by [`lexing::DEEPEST`].
const STACK: usize = 8 << 20;

/// Reads expressions on a thread of its own: the text that proc-macro2 keeps for the places of its words belongs to
/// a thread, and a caller who uses proc-macro2 too keeps its own. A procedural macro's places belong to the
/// compiler, which knows them on the caller's thread alone.
pub fn on_own_thread<T: Send>(read: impl FnOnce() -> T + Send) -> T {
    if proc_macro::is_available() {
        return read();
    }
    let mut read = Some(read);
    let ended = std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK);
        thread.spawn_scoped(scope, || read.take().map(|read| read())).map(std::thread::ScopedJoinHandle::join)
    });
    match ended {
        Ok(Ok(Some(value))) => value,
        Ok(Err(panic)) => std::panic::resume_unwind(panic),
        // A system without threads.
        _ => read.take().expect("read once")(),
    }
}

/// Frees the text of the expression that has just been read, on [`on_own_thread`].
fn forget_spans() {
    if !proc_macro::is_available() {
        proc_macro2::extra::invalidate_current_thread_spans();
    }
}

struct Reader<'a> {
    text: &'a Text,
    scope: &'a Scope,
    found: &'a mut Diagnostics,
}

impl Reader<'_> {
    fn place(&self, span: RustSpan) -> Span {
        self.text.place(span.byte_range())
    }

    fn node(&self, kind: ExprKind, span: RustSpan) -> Option<Expr> {
        Some(Expr { kind, span: self.place(span), unit: Unit::NONE })
    }

    fn refuse<T>(&mut self, span: RustSpan, message: String, label: &str, help: &str) -> Option<T> {
        self.found.push(Diagnostic::error(message).label(self.place(span), label).help(help));
        None
    }

    fn expression(&mut self, syntax: &syn::Expr) -> Option<Expr> {
        match syntax {
            syn::Expr::Paren(inner) => self.expression(&inner.expr),
            syn::Expr::Lit(literal) => self.literal(&literal.lit),
            syn::Expr::Path(path) => {
                let name = self.word(syntax)?;
                self.name(&name, path.span())
            }
            syn::Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => {
                let inner = self.expression(expr)?;
                self.node(ExprKind::Negate(Box::new(inner)), syntax.span())
            }
            syn::Expr::Binary(binary) => self.binary(binary),
            syn::Expr::Field(field) => self.axis(field),
            syn::Expr::Call(call) => {
                let name = self.word(&call.func)?;
                let arguments: Vec<&syn::Expr> = call.args.iter().collect();
                self.call(&name, call.func.span(), &arguments, syntax.span())
            }
            syn::Expr::MethodCall(call) if call.turbofish.is_none() => {
                let arguments: Vec<&syn::Expr> = std::iter::once(&*call.receiver).chain(&call.args).collect();
                self.call(&call.method.to_string(), call.method.span(), &arguments, syntax.span())
            }
            // Python's a**2 reads as a*(*2).
            syn::Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Deref(_)) => {
                self.refuse(unary.span(), "unexpected `*`".to_owned(), "here", "powers are written x.powi(2)")
            }
            other => {
                self.found.push(foreign_notation(self.place(other.span())));
                None
            }
        }
    }

    /// A single identifier.
    fn word(&mut self, syntax: &syn::Expr) -> Option<String> {
        let name = match syntax {
            syn::Expr::Path(path) if path.qself.is_none() => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        match name {
            Some(name) => Some(name),
            None => self.refuse(
                syntax.span(),
                "a name is expected here".to_owned(),
                "not a name",
                "names are single words",
            ),
        }
    }

    fn literal(&mut self, literal: &syn::Lit) -> Option<Expr> {
        let (digits, suffix, whole) = match literal {
            syn::Lit::Int(int) => (int.base10_digits(), int.suffix(), int.to_string()),
            syn::Lit::Float(float) => (float.base10_digits(), float.suffix(), float.to_string()),
            other => {
                return self.refuse(
                    other.span(),
                    "this is not a number".to_owned(),
                    "here",
                    "write a number such as 0.25",
                );
            }
        };
        let value: f64 = digits.parse().unwrap_or(f64::INFINITY);
        if !value.is_finite() {
            return self.refuse(
                literal.span(),
                "the number is too large".to_owned(),
                "beyond 1.8e308",
                "write a finite number",
            );
        }
        let suffix = suffix.trim_start_matches('_');
        // 2m would be two metres to one reader and twice m to another.
        if !suffix.is_empty() && !whole.contains('_') {
            let help = match unit::named(suffix) {
                Some(_) => format!(
                    "write {digits}*{suffix} for the product, {digits}_{suffix} for a number in the unit {suffix}"
                ),
                None => format!("write {digits}*{suffix}"),
            };
            return self.refuse(
                literal.span(),
                format!("`{whole}` is neither a product nor a number with a unit"),
                "a number and a name side by side",
                &help,
            );
        }
        let scale = match unit::named(suffix) {
            Some(scale) => scale,
            None if suffix.is_empty() => unit::Scale { unit: Unit::NONE, factor: 1.0 },
            None => {
                let help = suggestion(suffix, unit::names())
                    .unwrap_or_else(|| "a number may carry one unit: 0.12_m, 0.8_Hz, 90_deg".to_owned());
                return self.refuse(
                    literal.span(),
                    format!("unknown unit `{suffix}`"),
                    "on this number",
                    &help,
                );
            }
        };
        let node = self.node(ExprKind::Number(value * scale.factor), literal.span())?;
        Some(Expr { unit: scale.unit, ..node })
    }

    fn name(&mut self, name: &str, span: RustSpan) -> Option<Expr> {
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

    fn unknown<T>(&mut self, name: &str, span: RustSpan) -> Option<T> {
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

    /// `q_dot`, `qd`, `q_d`, `qdot`: how others call the speed of a coordinate q.
    fn rate_meant(&self, name: &str) -> Option<String> {
        let rate = |c: &&str| matches!(self.scope.values.get(*c), Some((Binding::Coordinate(_), _)));
        let coordinate =
            ["_dot", "dot", "_d", "d"].iter().filter_map(|end| name.strip_suffix(end)).find(rate)?;
        let speed = format!("u_{coordinate}");
        self.scope.values.contains_key(&speed).then_some(speed)
    }

    fn binary(&mut self, binary: &syn::ExprBinary) -> Option<Expr> {
        let left = self.expression(&binary.left);
        let right = self.expression(&binary.right);
        let (left, right) = (Box::new(left?), Box::new(right?));
        let span =
            Span { start: left.span.start, end: right.span.end.max(left.span.end), file: left.span.file };
        let kind = match binary.op {
            syn::BinOp::Add(_) => ExprKind::Add(left, right),
            syn::BinOp::Sub(_) => ExprKind::Subtract(left, right),
            syn::BinOp::Mul(_) => ExprKind::Multiply(left, right),
            syn::BinOp::Div(_) => ExprKind::Divide(left, right),
            _ => {
                return self.refuse(
                    binary.op.span(),
                    "unknown operator".to_owned(),
                    "not in the language",
                    "operators are + - * /",
                );
            }
        };
        Some(Expr { kind, span, unit: Unit::NONE })
    }

    /// `F.x`
    fn axis(&mut self, field: &syn::ExprField) -> Option<Expr> {
        let name = self.word(&field.base)?;
        let axis = match &field.member {
            syn::Member::Named(member) if member == "x" => Axis::X,
            syn::Member::Named(member) if member == "y" => Axis::Y,
            syn::Member::Named(member) if member == "z" => Axis::Z,
            other => {
                let help = match self.scope.values.get(&name) {
                    Some((binding, _)) => format!(
                        "`{name}` is {}: its name alone is its value; a component of a vector is dot(vector, N.x)",
                        binding.kind()
                    ),
                    None => "write .x, .y or .z".to_owned(),
                };
                return self.refuse(
                    other.span(),
                    "only a frame has parts: the unit vectors x, y and z".to_owned(),
                    "not one of them",
                    &help,
                );
            }
        };
        let id = self.frame(&name, field.base.span())?;
        self.node(ExprKind::Axis(id, axis), field.span())
    }

    fn frame(&mut self, name: &str, span: RustSpan) -> Option<FrameId> {
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
        place: RustSpan,
        arguments: &[&syn::Expr],
        span: RustSpan,
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

    fn power(&mut self, arguments: &[&syn::Expr], span: RustSpan) -> Option<Expr> {
        let base = self.expression(arguments[0]);
        let (sign, literal) = match arguments[1] {
            syn::Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => (-1, &**expr),
            other => (1, other),
        };
        let exponent = match literal {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(int), .. }) if int.suffix().is_empty() => {
                int.base10_parse::<i32>().ok().filter(|n| *n <= LARGEST_EXPONENT)
            }
            _ => None,
        };
        match exponent {
            Some(n) => self.node(ExprKind::Power(Box::new(base?), sign * n), span),
            None => self.refuse(
                arguments[1].span(),
                format!("an exponent is an integer between -{LARGEST_EXPONENT} and {LARGEST_EXPONENT}"),
                "not such a literal",
                "for a root write sqrt(x), for any other power exp(n*ln(x))",
            ),
        }
    }

    /// `velocity(P)`, `angular_velocity(F)`, `q_dot(q)`
    fn of_name(&mut self, function: &str, argument: &syn::Expr, span: RustSpan) -> Option<Expr> {
        let name = self.word(argument)?;
        if function == "angular_velocity" {
            let id = self.frame(&name, argument.span())?;
            return self.node(ExprKind::AngularVelocity(id), span);
        }
        match (function, self.scope.values.get(&name)) {
            ("velocity", Some((Binding::Point(id), _))) => self.node(ExprKind::Velocity(*id), span),
            ("q_dot", Some((Binding::Coordinate(id), _))) => self.node(ExprKind::Rate(*id), span),
            (_, None) => self.unknown(&name, argument.span()),
            (_, Some((binding, _))) => {
                let expected = if function == "velocity" { "a point" } else { "a coordinate" };
                self.refuse(
                    argument.span(),
                    format!("`{function}` wants {expected}"),
                    &format!("this is {}", binding.kind()),
                    "give the name itself",
                )
            }
        }
    }
}
