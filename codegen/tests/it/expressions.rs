//! The expression parser: what is printed is read back as the same tree; no text makes it panic.

use proptest::prelude::*;
use smartbed_codegen::expr::{Dag, Unary};
use smartbed_codegen::model::expression::{ExprKind, Function};
use smartbed_codegen::model::{self, Expr, Model};
use smartbed_runtime::real::Real;

/// A tree to be printed: leaves are the numbers and the names `a`, `q` of the model below.
#[derive(Clone, Debug)]
enum Tree {
    Number(u32),
    Name(&'static str),
    Negate(Box<Tree>),
    Binary(char, Box<Tree>, Box<Tree>),
    Power(Box<Tree>, i32),
    Call(&'static str, Vec<Tree>),
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        (1_u32..1000).prop_map(Tree::Number),
        prop_oneof![Just("a"), Just("q"), Just("pi"), Just("deg")].prop_map(Tree::Name),
    ];
    leaf.prop_recursive(8, 64, 3, |inner| {
        let boxed = inner.clone().prop_map(Box::new);
        let operator = prop_oneof![Just('+'), Just('-'), Just('*'), Just('/')];
        prop_oneof![
            boxed.clone().prop_map(Tree::Negate),
            (operator, boxed.clone(), boxed.clone()).prop_map(|(o, a, b)| Tree::Binary(o, a, b)),
            (boxed, -3_i32..4).prop_map(|(a, n)| Tree::Power(a, n)),
            inner.clone().prop_map(|a| Tree::Call("sin", vec![a])),
            (inner.clone(), inner).prop_map(|(a, b)| Tree::Call("atan2", vec![a, b])),
        ]
    })
}

/// Binding strength of the outermost operator: sums 1, products 2, negation 3, everything else 4.
fn strength(tree: &Tree) -> u8 {
    match tree {
        Tree::Binary('+' | '-', ..) => 1,
        Tree::Binary(..) => 2,
        Tree::Negate(_) => 3,
        _ => 4,
    }
}

/// As few parentheses as the grammar allows: precedence and associativity are tested, not hidden.
fn print(tree: &Tree, at_least: u8) -> String {
    let text = match tree {
        Tree::Number(n) => format!("{}.{}", n / 10, n % 10),
        Tree::Name(name) => (*name).to_owned(),
        Tree::Negate(a) => format!("-{}", print(a, 3)),
        Tree::Binary(o, a, b) => {
            let own = strength(tree);
            format!("{} {o} {}", print(a, own), print(b, own + 1))
        }
        Tree::Power(a, n) => format!("{}.powi({n})", print(a, 4)),
        Tree::Call(name, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(|a| print(a, 0)).collect();
            format!("{name}({})", arguments.join(", "))
        }
    };
    if strength(tree) < at_least { format!("({text})") } else { text }
}

fn same(tree: &Tree, expr: &Expr) -> bool {
    match (tree, &expr.kind) {
        (Tree::Number(n), ExprKind::Number(x)) => f64::from(*n) == (x * 10.0).round(),
        (Tree::Name("a"), ExprKind::Parameter(_))
        | (Tree::Name("q"), ExprKind::Coordinate(_))
        | (Tree::Name("pi"), ExprKind::Pi)
        | (Tree::Name("deg"), ExprKind::Degree) => true,
        (Tree::Negate(a), ExprKind::Negate(x)) => same(a, x),
        (Tree::Binary('+', a, b), ExprKind::Add(x, y))
        | (Tree::Binary('-', a, b), ExprKind::Subtract(x, y))
        | (Tree::Binary('*', a, b), ExprKind::Multiply(x, y))
        | (Tree::Binary('/', a, b), ExprKind::Divide(x, y)) => same(a, x) && same(b, y),
        (Tree::Power(a, n), ExprKind::Power(x, m)) => n == m && same(a, x),
        (Tree::Call("sin", a), ExprKind::Call(Function::Sin, x)) => same(&a[0], &x[0]),
        (Tree::Call("atan2", a), ExprKind::Call(Function::Atan2, x)) => {
            same(&a[0], &x[0]) && same(&a[1], &x[1])
        }
        _ => false,
    }
}

/// A model with one definition.
fn define(expression: &str) -> String {
    format!(
        "format = 1\nname = \"one\"\n[parameters]\na = 2.0\n[coordinates]\nq = {{ unit = \"rad\" }}\n[definitions]\nx = '''{expression}'''\n"
    )
}

fn read(expression: &str) -> Result<Model, String> {
    model::parse("one.toml", &define(expression)).map_err(|found| found.to_string())
}

proptest! {
    #[test]
    fn printed_trees_are_read_back(tree in tree()) {
        let text = print(&tree, 0);
        let model = read(&text).map_err(TestCaseError::fail)?;
        let (_, definition) = model.definitions.enumerate().next().expect("one definition");
        prop_assert!(same(&tree, &definition.value), "{text} was read as {:?}", definition.value);
    }

    #[test]
    fn places_cover_exactly_the_subexpression(tree in tree()) {
        let text = print(&tree, 0);
        let file = define(&text);
        let model = model::parse("one.toml", &file).map_err(|found| TestCaseError::fail(found.to_string()))?;
        let (_, definition) = model.definitions.enumerate().next().expect("one definition");
        let mut wrong = None;
        definition.value.visit(&mut |e| {
            if let ExprKind::Parameter(_) = e.kind && &file[e.span.start..e.span.end] != "a" {
                wrong = Some(e.span);
            }
        });
        prop_assert_eq!(wrong, None);
    }

    #[test]
    fn no_text_makes_the_parser_panic(text in "[ -~\\n\u{b5}]{0,80}") {
        let _ = read(&text);
    }

    #[test]
    fn no_soup_of_words_makes_the_parser_panic(
        words in prop::collection::vec(
            prop_oneof![
                Just("a"), Just("q"), Just("("), Just(")"), Just("-"), Just("*"), Just("/"), Just("."), Just(","),
                Just("sin"), Just("powi"), Just("2"), Just("1e999"), Just("0.5_m"), Just("N"), Just("x"), Just("if"),
                Just("return"), Just("r"), Just("b"), Just("_"), Just("0x1F"), Just("dot"), Just("velocity"),
            ],
            0..40,
        ),
        blanks in any::<bool>(),
    ) {
        let _ = read(&words.join(if blanks { " " } else { "" }));
    }

    #[test]
    fn no_damage_to_a_model_makes_the_reader_panic(at in 0.0..1.0_f64, length in 0_usize..40, by in "[ -~\\n]{0,12}") {
        let tile = include_str!("../../../models/tile.toml");
        let start = (at * tile.len() as f64) as usize;
        let end = (start + length).min(tile.len());
        let damaged = format!("{}{by}{}", &tile[..start], &tile[end..]);
        if let Err(found) = model::parse("damaged.toml", &damaged) {
            let text = found.to_string();
            prop_assert!(text.contains("error: ") && text.contains("damaged.toml:"), "no place in {text}");
        }
    }
}

#[test]
fn operators_bind_as_in_rust() {
    for (a, b) in [
        ("-a*q", "(-a)*q"),
        ("a - q - a", "(a - q) - a"),
        ("a/q/a", "(a/q)/a"),
        ("-a.powi(2)", "-(a.powi(2))"),
    ] {
        let kinds = |text: &str| {
            let model = read(text).expect(text);
            let mut kinds = Vec::new();
            model
                .definitions
                .iter()
                .for_each(|d| d.value.visit(&mut |e| kinds.push(std::mem::discriminant(&e.kind))));
            kinds
        };
        assert_eq!(kinds(a), kinds(b), "{a}");
    }
}

#[track_caller]
fn refused(expression: &str, message: &str) {
    let text = read(expression).map(|_| ()).expect_err(expression);
    assert!(text.contains(message), "{expression}: {text}");
}

#[test]
fn limits_have_messages() {
    refused(&format!("{}a{}", "(".repeat(129), ")".repeat(129)), "nested more than 128 deep");
    refused(&format!("{}a", "-".repeat(129)), "nested more than 128 deep");
    refused(&"a + ".repeat(2000), "more than 2000 names, numbers and operators");
    refused("a.powi(65)", "an exponent is an integer between -64 and 64");
    refused("a.powi(a)", "an exponent is an integer between -64 and 64");
    refused("1e400", "the number is too large");
    refused("", "the expression is empty");
    refused("(a", "`(` is never closed");
    refused("a // b", "comments do not belong into an expression");
    refused("|a| a", "unexpected `|`");
    refused("if", "not an expression");
    refused("a..q", "this notation is not part of the expression language");
    let nested = format!("{}a{}", "sin(".repeat(128), ")".repeat(128));
    assert!(read(&nested).is_ok(), "128 are allowed");
}

#[test]
fn places_of_the_callers_own_tokens_outlive_a_model() {
    // A build script that reads Rust with proc-macro2 and derives a model in between.
    let tokens: proc_macro2::TokenStream = "first + second".parse().expect("tokens");
    model::parse("pendulum.toml", include_str!("../../../models/pendulum.toml"))
        .unwrap_or_else(|e| panic!("{e}"));
    let texts: Vec<Option<String>> = tokens.into_iter().map(|token| token.span().source_text()).collect();
    assert_eq!(texts, ["first", "+", "second"].map(|word| Some(word.to_owned())));
}

#[test]
fn constants_are_computed_by_the_runtimes_own_functions() {
    // Of many arguments some, for which the system's functions round otherwise than ours.
    type Named = (&'static str, fn(f64) -> f64);
    let functions: [Named; 8] = [
        ("sin", |x| Real::sin_cos(x).0),
        ("cos", |x| Real::sin_cos(x).1),
        ("tan", Real::tan),
        ("asin", Real::asin),
        ("acos", Real::acos),
        ("exp", Real::exp),
        ("ln", Real::ln),
        ("tanh", Real::tanh),
    ];
    let argument = |n: usize| (n as f64 + 0.5) / 300.0;
    let mut text = "format = 1\nname = \"constants\"\n[parameters]\n".to_owned();
    for (name, _) in functions {
        (0..300).for_each(|n| text += &format!("{name}_{n} = \"{name}({:?})\"\n", argument(n)));
    }
    let model = model::parse("constants.toml", &text).unwrap_or_else(|found| panic!("{found}"));
    let values = model.parameter_defaults();
    let mut dag = Dag::default();
    for (at, value) in values.iter().enumerate() {
        let (name, function) = functions[at / 300];
        let x = argument(at % 300);
        assert_eq!(value.to_bits(), function(x).to_bits(), "the parameter {name}({x})");
        let unary = [
            Unary::Sin,
            Unary::Cos,
            Unary::Tan,
            Unary::Asin,
            Unary::Acos,
            Unary::Exp,
            Unary::Ln,
            Unary::Tanh,
        ][at / 300];
        let constant = dag.constant(x);
        let folded = dag.unary(unary, constant);
        assert_eq!(
            dag.evaluate_constant(folded).to_bits(),
            function(x).to_bits(),
            "the constant {name}({x})"
        );
    }
}
