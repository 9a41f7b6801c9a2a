//! Program -> Rust: straight-line functions, one per answer, and the glue to the runtime's trait.
//!
//! In: a [`Program`]. Out: formatted source text, the same bytes for the same input. Knows names and
//! tokens, no mechanics. Every node with more than one use is one `let`; sine and cosine of an
//! angle are one call; constants are rounded once, from f64, to the file's scalar.

mod glue;
mod header;
mod name;
mod prepared;
mod statement;

use crate::expr::ExprId;
use crate::program::{Program, Quantity};
use prepared::Prepared;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use statement::Body;

/// The scalar of an emitted file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum ScalarType {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    #[default]
    F64,
    /// Any type that implements the runtime's `Real`, by its path: lanes, a counting scalar.
    Path(String),
}

/// What is emitted and how.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EmitOptions {
    /// The scalar.
    pub scalar: ScalarType,
    /// Path of the runtime crate or of the module that carries its numbers.
    pub runtime: String,
    /// Only these answers, and no glue; all with glue if empty.
    pub answers: Vec<Answer>,
}

impl Default for EmitOptions {
    fn default() -> Self {
        Self { scalar: ScalarType::F64, runtime: "smartbed_runtime".to_owned(), answers: Vec::new() }
    }
}

/// A function of the emitted file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Answer {
    /// q', u' and the worst pivot.
    Rates,
    /// Kinetic and potential energy.
    Energy,
    /// All speeds, dependent ones included.
    Speeds,
    /// Requested outputs.
    Outputs,
    /// Newton's correction of the dependent coordinates.
    Projection,
    /// The equations before the elimination; emitted only on request.
    Augmented,
}

impl Answer {
    /// Answers that need no mass.
    pub const KINEMATIC: [Self; 3] = [Self::Speeds, Self::Outputs, Self::Projection];

    /// Every answer of a complete file, in its order; [`Answer::Augmented`] is a form of its own.
    pub const ALL: [Self; 5] = [Self::Rates, Self::Energy, Self::Speeds, Self::Outputs, Self::Projection];

    /// Name of the emitted function and of the answer on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rates => "rates",
            Self::Energy => "energy",
            Self::Speeds => "speeds",
            Self::Outputs => "outputs",
            Self::Projection => "projection",
            Self::Augmented => "augmented",
        }
    }

    /// The results of the answer in the emitted function's order.
    #[must_use]
    pub fn roots(self, program: &Program) -> Vec<ExprId> {
        let second = |list: &[(String, ExprId)]| list.iter().map(|(_, e)| *e).collect();
        match self {
            Self::Rates => {
                let mut roots = program.forward_dynamics();
                roots.push(program.rates.worst_pivot);
                roots
            }
            Self::Energy => program.energy.to_vec(),
            Self::Speeds => second(&program.speeds),
            Self::Outputs => second(&program.outputs),
            Self::Projection => {
                let mut roots: Vec<_> = program.correction.iter().map(|(_, e)| *e).collect();
                roots.push(program.residual);
                roots
            }
            Self::Augmented => program.augmented_roots(),
        }
    }

    fn doc(self) -> &'static str {
        match self {
            Self::Rates => {
                "Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal."
            }
            Self::Energy => "Kinetic and potential energy (J).",
            Self::Speeds => "All speeds in the order of `SPEED_NAMES`, dependent ones included.",
            Self::Outputs => "Requested outputs in the order of `OUTPUT_NAMES`.",
            Self::Projection => {
                "Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them."
            }
            Self::Augmented => {
                "Mass matrix M, Jacobian J (row-major), forcing f and bias b of M y' - J' lambda = f, J y' = -b, y as in `UNKNOWN_NAMES`."
            }
        }
    }
}

/// The formatted source text.
///
/// # Panics
/// If the emitted tokens are not Rust: a fault of this emitter, caught by every golden test.
#[must_use]
pub fn emit(program: &Program, options: &EmitOptions) -> String {
    let answers = if options.answers.is_empty() { Answer::ALL.to_vec() } else { options.answers.clone() };
    let scalar = scalar_tokens(&options.scalar);
    let runtime: TokenStream = options.runtime.parse().expect("a path");
    let mut items = quote! {
        use #runtime::real::Real;
        /// The scalar of this file.
        pub type S = #scalar;
    };
    items.extend(constants(program, options));
    items.extend(parameters(program, options));
    if answers.contains(&Answer::Augmented) {
        let doc = "Speeds and lifted twists of the augmented form, in order.";
        items.extend(names_constant("UNKNOWN_NAMES", doc, &program.augmented.unknowns));
    }
    let roots: Vec<ExprId> = answers.iter().flat_map(|answer| answer.roots(program)).collect();
    let prepared = Prepared::new(program, &roots);
    let (prepare, text) = prepared.items(program, &options.scalar);
    items.extend(prepare);
    let mut bodies = vec![(format_ident!("body_of_prepare"), text)];
    for &answer in &answers {
        let body = Body::new(program, &answer.roots(program), &options.scalar, &prepared);
        items.extend(function(program, answer, &body.arguments()));
        let mut text: String = body.statements.iter().map(|line| format!("    {line}\n")).collect();
        text.push_str(&format!("    {}\n", result(program, answer, &body.results)));
        bodies.push((placeholder(answer), text));
    }
    if options.answers.is_empty() {
        items.extend(glue::mechanism(program, &runtime));
    }
    let file: syn::File = syn::parse2(items).expect("emitted tokens are Rust items");
    let mut text =
        format!("{}\n{}", header::text(program, options, &answers, &prepared), prettyplease::unparse(&file));
    for (placeholder, body) in bodies {
        text = text.replacen(&format!("    {placeholder}!();\n"), &body, 1);
    }
    text
}

fn scalar_tokens(scalar: &ScalarType) -> TokenStream {
    match scalar {
        ScalarType::F32 => quote!(f32),
        ScalarType::F64 => quote!(f64),
        ScalarType::Path(path) => path.parse().expect("a type path"),
    }
}

/// A constant of the file's scalar: a literal, or a conversion for other scalars.
fn literal(value: f64, scalar: &ScalarType) -> String {
    let special = match value {
        v if v.is_nan() => Some("S::NAN"),
        v if v == f64::INFINITY => Some("S::INFINITY"),
        v if v == f64::NEG_INFINITY => Some("S::NEG_INFINITY"),
        _ => None,
    };
    let text = match (scalar, special) {
        (ScalarType::F32 | ScalarType::F64, Some(name)) => name.to_owned(),
        // Rounded once to f32; the shortest text that reads back as that number.
        (ScalarType::F32, None) => format!("{:?}_f32", value as f32),
        (ScalarType::F64, None) => format!("{value:?}_f64"),
        (ScalarType::Path(_), None) => format!("<S as Real>::from_f64({value:?}_f64)"),
        (ScalarType::Path(_), Some(name)) => {
            format!("<S as Real>::from_f64({})", name.replace("S::", "f64::"))
        }
    };
    if text.starts_with('-') { format!("({text})") } else { text }
}

/// [`literal`] as tokens.
fn number(value: f64, scalar: &ScalarType) -> TokenStream {
    literal(value, scalar).parse().expect("a number")
}

fn names_constant(name: &str, doc: &str, names: &[String]) -> TokenStream {
    let (name, n) = (format_ident!("{name}"), names.len());
    quote! {
        #[doc = #doc]
        pub const #name: [&str; #n] = [#(#names),*];
    }
}

fn constants(program: &Program, options: &EmitOptions) -> TokenStream {
    let names = |list: &[Quantity]| list.iter().map(|x| x.name.clone()).collect::<Vec<_>>();
    let firsts = |list: &[(String, ExprId)]| list.iter().map(|(n, _)| n.clone()).collect::<Vec<_>>();
    let (nq, nu, ni) = (program.q.len(), program.u.len(), program.inputs.len());
    let mut items = quote! {
        /// Number of coordinates q.
        pub const NQ: usize = #nq;
        /// Number of independent speeds u.
        pub const NU: usize = #nu;
        /// Number of inputs.
        pub const N_INPUTS: usize = #ni;
    };
    items.extend(names_constant("Q_NAMES", "Coordinates in order.", &names(&program.q)));
    items.extend(names_constant("U_NAMES", "Independent speeds in order.", &names(&program.u)));
    items.extend(names_constant("INPUT_NAMES", "Inputs in order.", &names(&program.inputs)));
    items.extend(names_constant(
        "PARAMETER_NAMES",
        "Tunable parameters in order.",
        &names(&program.parameters),
    ));
    items.extend(names_constant("SPEED_NAMES", "All speeds in order.", &firsts(&program.speeds)));
    items.extend(names_constant("OUTPUT_NAMES", "Outputs in order.", &firsts(&program.outputs)));
    let corrected: Vec<usize> = program.correction.iter().map(|(i, _)| *i).collect();
    let n = corrected.len();
    let angles: Vec<bool> = program.q.iter().map(|q| q.is_angle).collect();
    let nominal: Vec<f64> = program.q.iter().map(|q| q.value).collect();
    let nominal = match options.scalar {
        ScalarType::F32 => {
            let values = nominal.iter().map(|&x| Literal::f32_suffixed(x as f32));
            quote!([f32; #nq] = [#(#values),*])
        }
        _ => quote!([f64; #nq] = [#(#nominal),*]),
    };
    items.extend(quote! {
        /// Indices of the coordinates that the projection corrects.
        pub const CORRECTED: [usize; #n] = [#(#corrected),*];
        /// Coordinates read only by sines and cosines: they may be wrapped by whole turns.
        pub const IS_ANGLE: [bool; #nq] = [#(#angles),*];
        /// The nominal configuration.
        pub const NOMINAL: #nominal;
    });
    items
}

/// The struct of tunable parameters and its defaults.
fn parameters(program: &Program, options: &EmitOptions) -> TokenStream {
    let path = &program.path;
    let fields = program.parameters.iter().map(|p| {
        let ident = name::identifier(&p.name);
        let doc = format!("{} ({}), {path}:{}.", name::sentence(&p.doc, &p.name), p.unit, p.line);
        quote! { #[doc = #doc] pub #ident: S }
    });
    let defaults = program.parameters.iter().map(|p| {
        let (ident, value) = (name::identifier(&p.name), number(p.value, &options.scalar));
        quote! { #ident: #value }
    });
    quote! {
        /// Tunable parameters, SI units.
        #[derive(Clone, Copy, Debug)]
        #[repr(C)]
        #[allow(non_snake_case, reason = "names are the model's")]
        pub struct Parameters { #(#fields),* }
        impl Default for Parameters {
            fn default() -> Self {
                Self { #(#defaults),* }
            }
        }
    }
}

/// Stands for the body of an answer's function until the text is put in.
fn placeholder(answer: Answer) -> proc_macro2::Ident {
    format_ident!("body_of_{}", answer.name())
}

/// One answer as a function, its body a placeholder.
fn function(program: &Program, answer: Answer, arguments: &TokenStream) -> TokenStream {
    let n = answer.roots(program).len();
    let (nq, nu, corrections) = (program.q.len(), program.u.len(), n.wrapping_sub(1));
    let output = match answer {
        Answer::Rates => quote!(([S; #nq], [S; #nu], S)),
        Answer::Energy => quote!((S, S)),
        Answer::Speeds | Answer::Outputs => quote!([S; #n]),
        Answer::Projection => quote!(([S; #corrections], S)),
        Answer::Augmented => {
            let [a, b, c, d] = augmented_lengths(program);
            quote!(([S; #a], [S; #b], [S; #c], [S; #d]))
        }
    };
    let (ident, doc, body) = (format_ident!("{}", answer.name()), answer.doc(), placeholder(answer));
    let operations = format!("{} operations.", program.dag.state_cost(&answer.roots(program)));
    quote! {
        #[doc = #doc]
        ///
        #[doc = #operations]
        #[allow(non_snake_case, clippy::all, clippy::pedantic, reason = "generated straight-line arithmetic")]
        #[must_use]
        pub fn #ident(#arguments) -> #output {
            #body!();
        }
    }
}

/// The result expression of an answer's function.
fn result(program: &Program, answer: Answer, results: &[String]) -> String {
    let list = |items: &[String]| format!("[{}]", items.join(", "));
    match answer {
        Answer::Rates => {
            let (q_dot, rest) = results.split_at(program.q.len());
            let (u_dot, pivot) = rest.split_at(program.u.len());
            format!("({}, {}, {})", list(q_dot), list(u_dot), pivot.concat())
        }
        Answer::Energy => format!("({})", results.join(", ")),
        Answer::Speeds | Answer::Outputs => list(results),
        Answer::Projection => {
            let (corrections, residual) = results.split_at(results.len() - 1);
            format!("({}, {})", list(corrections), residual.concat())
        }
        Answer::Augmented => {
            let mut rest = results;
            let parts = augmented_lengths(program).map(|n| {
                let (part, after) = rest.split_at(n);
                rest = after;
                list(part)
            });
            format!("({})", parts.join(", "))
        }
    }
}

fn augmented_lengths(program: &Program) -> [usize; 4] {
    let parts = &program.augmented;
    [parts.mass.len(), parts.jacobian.len(), parts.forcing.len(), parts.bias.len()]
}
