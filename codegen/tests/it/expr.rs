//! The expression DAG: identities, derivatives and the tape against plain f64 arithmetic.

use proptest::prelude::*;
use smartbed_codegen::expr::number::Number;
use smartbed_codegen::expr::tape::Tape;
use smartbed_codegen::expr::{Binary, Dag, ExprId, SymbolId, Unary};
use std::collections::HashMap;

/// An expression over x, y, z as the test itself evaluates it.
#[derive(Clone, Debug)]
enum Tree {
    Number(i32),
    Symbol(usize),
    Negate(Box<Tree>),
    Unary(Unary, Box<Tree>),
    Binary(Binary, Box<Tree>, Box<Tree>),
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![(-3..4).prop_map(Tree::Number), (0..3_usize).prop_map(Tree::Symbol)];
    leaf.prop_recursive(6, 60, 2, |inner| {
        let unary = prop_oneof![
            Just(Unary::Sin),
            Just(Unary::Cos),
            Just(Unary::Tanh),
            Just(Unary::Abs),
            Just(Unary::Sqrt),
        ];
        let binary = prop_oneof![Just(Binary::Add), Just(Binary::Sub), Just(Binary::Mul), Just(Binary::Div)];
        prop_oneof![
            inner.clone().prop_map(|a| Tree::Negate(Box::new(a))),
            (unary, inner.clone()).prop_map(|(f, a)| Tree::Unary(f, Box::new(a))),
            (binary, inner.clone(), inner).prop_map(|(f, a, b)| Tree::Binary(f, Box::new(a), Box::new(b))),
        ]
    })
}

/// Builds the tree; square roots and divisors are kept away from zero so that values are finite.
fn build(dag: &mut Dag, symbols: &[ExprId], tree: &Tree) -> ExprId {
    match tree {
        Tree::Number(n) => dag.number(Number::integer(i64::from(*n))),
        Tree::Symbol(i) => symbols[*i],
        Tree::Negate(a) => {
            let a = build(dag, symbols, a);
            dag.negate(a)
        }
        Tree::Unary(Unary::Sqrt, a) => {
            let a = build(dag, symbols, a);
            let positive = above_one(dag, a);
            dag.sqrt(positive)
        }
        Tree::Unary(function, a) => {
            let a = build(dag, symbols, a);
            dag.unary(*function, a)
        }
        Tree::Binary(operator, a, b) => {
            let (a, b) = (build(dag, symbols, a), build(dag, symbols, b));
            let b = if *operator == Binary::Div { above_one(dag, b) } else { b };
            dag.binary(*operator, a, b)
        }
    }
}

fn above_one(dag: &mut Dag, a: ExprId) -> ExprId {
    let (one, square) = (dag.one(), dag.mul(a, a));
    dag.add(one, square)
}

/// The same in plain arithmetic: value, and the sum of the sizes of all intermediate results.
fn plain(tree: &Tree, at: &[f64; 3], size: &mut f64) -> f64 {
    let value = match tree {
        Tree::Number(n) => f64::from(*n),
        Tree::Symbol(i) => at[*i],
        Tree::Negate(a) => -plain(a, at, size),
        Tree::Unary(function, a) => {
            let a = plain(a, at, size);
            match function {
                Unary::Sin => a.sin(),
                Unary::Cos => a.cos(),
                Unary::Tanh => a.tanh(),
                Unary::Abs => a.abs(),
                _ => (1.0 + a * a).sqrt(),
            }
        }
        Tree::Binary(operator, a, b) => {
            let (a, b) = (plain(a, at, size), plain(b, at, size));
            match operator {
                Binary::Add => a + b,
                Binary::Sub => a - b,
                Binary::Mul => a * b,
                _ => a / (1.0 + b * b),
            }
        }
    };
    *size += value.abs();
    value
}

fn three(dag: &mut Dag) -> (Vec<ExprId>, Vec<SymbolId>) {
    let expressions: Vec<_> = ["x", "y", "z"].iter().map(|name| dag.symbol(name)).collect();
    let symbols = expressions.iter().map(|&e| dag.as_symbol(e).expect("a symbol")).collect();
    (expressions, symbols)
}

/// Rounding of at most 60 operations, amplified by at most the steepest functions above.
const ROUNDING: f64 = 1e-11;

proptest! {
    #[test]
    fn simplified_expressions_keep_their_value(tree in tree(), at in prop::array::uniform3(-2.0..2.0_f64)) {
        let mut dag = Dag::default();
        let (expressions, symbols) = three(&mut dag);
        let root = build(&mut dag, &expressions, &tree);
        let mut size = 1.0;
        let expected = plain(&tree, &at, &mut size);
        prop_assume!(size < 1e6);
        let values: HashMap<_, _> = symbols.iter().copied().zip(at).collect();
        let found = dag.evaluate::<f64>(&[root], &|s| values[&s])[0];
        prop_assert!((found - expected).abs() <= ROUNDING * size * size, "{found} {expected} {}", dag.print(root, 300));
    }

    #[test]
    fn the_tape_agrees_with_the_evaluator_bit_for_bit(tree in tree(), at in prop::array::uniform3(-2.0..2.0_f64)) {
        let mut dag = Dag::default();
        let (expressions, symbols) = three(&mut dag);
        let root = build(&mut dag, &expressions, &tree);
        let values: HashMap<_, _> = symbols.iter().copied().zip(at).collect();
        let direct = dag.evaluate::<f64>(&[root], &|s| values[&s])[0];
        let mut tape = Tape::<f64>::new(&dag, &[root], &symbols);
        let mut out = [0.0];
        tape.run(&at, &mut out);
        prop_assert_eq!(out[0].to_bits(), direct.to_bits());
    }

    #[test]
    fn derivatives_agree_with_central_differences(tree in tree(), at in prop::array::uniform3(-2.0..2.0_f64)) {
        let mut dag = Dag::default();
        let (expressions, symbols) = three(&mut dag);
        let root = build(&mut dag, &expressions, &tree);
        let slope = dag.derivative(root, symbols[0]);
        let value = |e: ExprId, x: f64| {
            let values: HashMap<_, _> = symbols.iter().copied().zip([x, at[1], at[2]]).collect();
            dag.evaluate::<f64>(&[e], &|s| values[&s])[0]
        };
        // Truncation of order h^2 is seen by halving h: where the two differ the function is rough there (|x| at 0).
        const H: f64 = 1e-4;
        let difference = |h: f64| (value(root, at[0] + h) - value(root, at[0] - h)) / (2.0 * h);
        let (coarse, fine) = (difference(H), difference(H / 2.0));
        let scale = 1.0 + fine.abs() + value(root, at[0]).abs();
        prop_assume!((coarse - fine).abs() < 1e-6 * scale);
        let found = value(slope, at[0]);
        prop_assert!((found - fine).abs() < 1e-5 * scale, "{found} {fine} {}", dag.print(root, 300));
    }
}

#[test]
fn equal_expressions_are_one_node() {
    let mut dag = Dag::default();
    let (e, _) = three(&mut dag);
    let (xy, yx) = (dag.mul(e[0], e[1]), dag.mul(e[1], e[0]));
    assert_eq!(xy, yx);
    let difference = dag.sub(xy, yx);
    assert!(dag.is_zero(difference));
}

#[test]
fn sines_of_the_screws_azimuths_are_exact() {
    let mut dag = Dag::default();
    let pi = dag.pi();
    for (degrees, sine) in [(90, "1"), (210, "-1/2"), (330, "-1/2"), (60, "1/2 sqrt(3)"), (180, "0")] {
        let factor = dag.number(Number::rational(degrees, 180));
        let angle = dag.mul(factor, pi);
        let sin = dag.sin(angle);
        assert_eq!(dag.print(sin, 40), sine, "{degrees} degrees");
    }
}

#[test]
fn every_identity_keeps_its_value_and_never_costs_more() {
    type Build = fn(&mut Dag, ExprId, ExprId) -> ExprId;
    // (name, expression, operations left)
    let cases: [(&str, Build, usize); 17] = [
        (
            "sin^2 + cos^2 = 1",
            |d, x, _| {
                let (s, c) = (d.sin(x), d.cos(x));
                let (a, b) = (d.mul(s, s), d.mul(c, c));
                d.add(a, b)
            },
            0,
        ),
        (
            "1 - sin^2 = cos^2",
            |d, x, _| {
                let s = d.sin(x);
                let (one, a) = (d.one(), d.mul(s, s));
                d.sub(one, a)
            },
            2,
        ),
        (
            "sin(asin x) = x",
            |d, x, _| {
                let angle = d.unary(Unary::Asin, x);
                d.sin(angle)
            },
            0,
        ),
        // One operation more than sine and arc cosine, which cost as much as twenty.
        (
            "sin(acos x) = sqrt(1 - x^2)",
            |d, x, _| {
                let angle = d.unary(Unary::Acos, x);
                d.sin(angle)
            },
            3,
        ),
        (
            "|x^2| = x^2",
            |d, x, _| {
                let square = d.mul(x, x);
                d.unary(Unary::Abs, square)
            },
            1,
        ),
        ("x - x = 0", |d, x, _| d.sub(x, x), 0),
        ("x + x = 2 x", |d, x, _| d.add(x, x), 1),
        ("x / x = 1", |d, x, _| d.div(x, x), 0),
        (
            "(x y) / y = x",
            |d, x, y| {
                let p = d.mul(x, y);
                d.div(p, y)
            },
            0,
        ),
        (
            "(x / y) y = x",
            |d, x, y| {
                let p = d.div(x, y);
                d.mul(p, y)
            },
            0,
        ),
        (
            "(x + y) - y = x",
            |d, x, y| {
                let p = d.add(x, y);
                d.sub(p, y)
            },
            0,
        ),
        (
            "x - (x - y) = y",
            |d, x, y| {
                let p = d.sub(x, y);
                d.sub(x, p)
            },
            0,
        ),
        (
            "(-x) (-y) = x y",
            |d, x, y| {
                let (a, b) = (d.negate(x), d.negate(y));
                d.mul(a, b)
            },
            1,
        ),
        (
            "-(x - y) = y - x",
            |d, x, y| {
                let p = d.sub(x, y);
                d.negate(p)
            },
            1,
        ),
        (
            "cos(-x) = cos x",
            |d, x, _| {
                let p = d.negate(x);
                d.cos(p)
            },
            1,
        ),
        (
            "x / sqrt(x) = sqrt(x)",
            |d, x, _| {
                let r = d.sqrt(x);
                d.div(x, r)
            },
            1,
        ),
        (
            "3 x - x = 2 x",
            |d, x, _| {
                let three = d.constant(3.0);
                let p = d.mul(three, x);
                d.sub(p, x)
            },
            1,
        ),
    ];
    for (name, make, operations) in cases {
        let mut dag = Dag::default();
        let (e, symbols) = three(&mut dag);
        let root = make(&mut dag, e[0], e[1]);
        assert_eq!(dag.cone_cost(&[root]), operations, "{name}");
        let (x, y) = (0.7_f64, 1.3);
        let found = dag.evaluate::<f64>(&[root], &|s| if s == symbols[0] { x } else { y })[0];
        let expected = match name {
            "sin^2 + cos^2 = 1" | "x / x = 1" => 1.0,
            "1 - sin^2 = cos^2" => x.cos() * x.cos(),
            "x - x = 0" => 0.0,
            "x + x = 2 x" | "3 x - x = 2 x" => 2.0 * x,
            "(x y) / y = x" | "(x / y) y = x" | "(x + y) - y = x" | "sin(asin x) = x" => x,
            "sin(acos x) = sqrt(1 - x^2)" => (1.0 - x * x).sqrt(),
            "x - (x - y) = y" => y,
            "(-x) (-y) = x y" => x * y,
            "-(x - y) = y - x" => y - x,
            "cos(-x) = cos x" => x.cos(),
            "|x^2| = x^2" => x * x,
            _ => x.sqrt(),
        };
        assert!((found - expected).abs() < 1e-15, "{name}: {found} {expected}");
    }
}

/// p (r x) = (p r) x and (p x) / (r y) = ((p / r) x) / y: parameters meet where they are prepared.
#[test]
fn parameters_of_a_product_or_quotient_are_prepared() {
    let mut dag = Dag::default();
    let [x, y] = ["x", "y"].map(|name| dag.symbol(name));
    let [p, r] = ["p", "r"].map(|name| dag.parameter(name));
    let (px, rx, ry) = (dag.mul(p, x), dag.mul(r, x), dag.mul(r, y));
    let (one_way, other_way) = (dag.mul(p, rx), dag.mul(r, px));
    assert_eq!(one_way, other_way);
    let quotient = dag.div(px, ry);
    let inverse = dag.div(y, rx);
    for (root, operations, expected) in [
        (one_way, 1, 2.5 * 0.7 * 1.3),
        (quotient, 2, 1.3 * 0.7 / (2.5 * 1.1)),
        (inverse, 2, 1.1 / (2.5 * 0.7)),
    ] {
        assert_eq!(dag.state_cost(&[root]), operations);
        let symbols = [x, y, p, r].map(|e| dag.as_symbol(e).expect("a symbol"));
        let value =
            |s| [0.7, 1.1, 1.3, 2.5][symbols.iter().position(|&known| known == s).expect("one of four")];
        let found = dag.evaluate::<f64>(&[root], &value)[0];
        assert!((found - expected).abs() < 1e-15, "{found} {expected}");
    }
}

/// The estimate of time: a chain waits for every result, sine and cosine of an angle come together, and a
/// second quotient by the same divisor is a product.
#[test]
fn cycles_are_the_work_or_the_longest_chain() {
    let mut dag = Dag::default();
    let [x, y] = ["x", "y"].map(|name| dag.symbol(name));
    let chain = (0..5).fold(x, |sum, _| {
        let square = dag.mul(sum, sum);
        dag.add(square, y)
    });
    assert_eq!(dag.cycles(&[chain]), 10 * 4);
    let (sin, cos) = (dag.sin(x), dag.cos(x));
    assert_eq!(dag.cycles(&[sin]), dag.cycles(&[sin, cos]));
    let angles: Vec<_> = (0..10).map(|i| dag.symbol(&format!("a{i}"))).collect();
    let sines: Vec<_> = angles.iter().map(|&a| dag.sin(a)).collect();
    let both: Vec<_> = angles.iter().flat_map(|&a| [dag.sin(a), dag.cos(a)]).collect();
    assert!(dag.cycles(&sines) > 10 * dag.cycles(&[chain]) / 2);
    assert_eq!(dag.cycles(&sines), dag.cycles(&both));
    let other: Vec<_> = angles.iter().map(|&a| dag.div(a, x)).collect();
    let each: Vec<_> = angles.iter().map(|&a| dag.div(x, a)).collect();
    assert!(dag.cycles(&other) < dag.cycles(&each));
}
