//! The value graph: values are kept, operations never grow, round-off is guarded.

use proptest::prelude::*;
use smartbed_codegen::Effort;
use smartbed_codegen::expr::number::Number;
use smartbed_codegen::expr::{Binary, Dag, ExprId, SymbolId, Unary};
use smartbed_codegen::value::{States, shorten};

/// Symbols of a random program.
const SYMBOLS: usize = 4;

/// Operation of a random program on two earlier values.
#[derive(Clone, Copy, Debug)]
enum Step {
    Add,
    Subtract,
    Multiply,
    Divide,
    Sine,
    Cosine,
    Root,
    Constant(i64),
}

fn step() -> impl Strategy<Value = (Step, usize, usize)> {
    let kind = prop_oneof![
        4 => Just(Step::Add),
        3 => Just(Step::Subtract),
        6 => Just(Step::Multiply),
        1 => Just(Step::Divide),
        1 => Just(Step::Sine),
        1 => Just(Step::Cosine),
        1 => Just(Step::Root),
        1 => (-3..4_i64).prop_map(Step::Constant),
    ];
    (kind, any::<usize>(), any::<usize>())
}

struct Sample {
    dag: Dag,
    symbols: Vec<SymbolId>,
    groups: Vec<Vec<ExprId>>,
    nodes: Vec<ExprId>,
}

/// Builds the program; the last values are the first group, some others the second.
fn build(steps: &[(Step, usize, usize)]) -> Sample {
    let mut dag = Dag::default();
    let symbols: Vec<ExprId> = ["a", "b", "c", "d"].iter().map(|name| dag.symbol(name)).collect();
    let mut nodes = symbols.clone();
    for &(kind, i, j) in steps {
        // Near the end of the list: long chains rather than many short expressions.
        let pick = |k: usize| nodes[nodes.len() - 1 - k % nodes.len().min(7)];
        let (a, b) = (pick(i), pick(j));
        let one = dag.one();
        let node = match kind {
            Step::Add => dag.add(a, b),
            Step::Subtract => dag.sub(a, b),
            Step::Multiply => dag.mul(a, b),
            Step::Divide => {
                let square = dag.mul(b, b);
                let positive = dag.add(one, square);
                dag.div(a, positive)
            }
            Step::Sine => dag.sin(a),
            Step::Cosine => dag.cos(a),
            Step::Root => {
                let square = dag.mul(a, a);
                let positive = dag.add(one, square);
                dag.sqrt(positive)
            }
            Step::Constant(n) => {
                let half = dag.number(Number::rational(n, 2));
                dag.mul(half, a)
            }
        };
        nodes.push(node);
    }
    let n = nodes.len();
    let groups = vec![nodes[n - 3..].to_vec(), nodes[n / 2..n / 2 + 2].to_vec()];
    let symbols = symbols.iter().filter_map(|&s| dag.as_symbol(s)).collect();
    Sample { dag, symbols, groups, nodes }
}

/// Values between -1 and 1 from a small fixed sequence.
fn states(symbols: &[SymbolId], points: usize) -> States {
    let mut states = States { points, ..States::default() };
    for (k, &symbol) in symbols.iter().enumerate() {
        let value = |point: usize| ((point * SYMBOLS + k) as f64 * 0.754_877_666 + 0.31).fract() * 2.0 - 1.0;
        states.symbols.insert(symbol, (0..points).map(value).collect());
    }
    states
}

fn cost(dag: &Dag, groups: &[Vec<ExprId>]) -> Vec<usize> {
    groups.iter().map(|group| dag.cone_cost(group)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn values_stay_and_operations_do_not_grow(steps in prop::collection::vec(step(), 4..40)) {
        for effort in [Effort::None, Effort::Default, Effort::All] {
            let Sample { mut dag, symbols, groups, nodes } = build(&steps);
            let guard = states(&symbols, 4);
            let shorter = shorten(&mut dag, &groups, &guard, &guard, effort);
            for (new, old) in cost(&dag, &shorter).iter().zip(cost(&dag, &groups)) {
                prop_assert!(*new <= old, "{effort:?}: {new} instead of {old}");
            }
            // At states that the guard has not seen.
            let fresh = states(&symbols, 12);
            for point in 4..12 {
                let at = |symbol: SymbolId| fresh.symbols[&symbol][point];
                let sizes = dag.evaluate::<f64>(&nodes, &at);
                let size = sizes.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
                let old = dag.evaluate::<f64>(&groups.concat(), &at);
                let new = dag.evaluate::<f64>(&shorter.concat(), &at);
                if !size.is_finite() || size > 1e100 {
                    continue;
                }
                for (x, y) in old.iter().zip(&new) {
                    prop_assert!((x - y).abs() <= 1e-11 * size * size, "{effort:?}: {x} became {y}, sizes {size}");
                }
            }
        }
    }
}

/// Symbols a, b, ... with one list of values each.
fn symbols<const N: usize>(values: [&[f64]; N]) -> (Dag, [ExprId; N], States) {
    let mut dag = Dag::default();
    let exprs = [(); N].map(|()| dag.symbol("x"));
    let mut states = States { points: values[0].len(), ..States::default() };
    for (&expr, values) in exprs.iter().zip(values) {
        states.symbols.insert(dag.as_symbol(expr).expect("a symbol"), values.to_vec());
    }
    (dag, exprs, states)
}

/// a^2, b^2 and (a + b)(a - b): the difference of the squares would save two operations.
fn squares(a: &[f64], b: &[f64]) -> usize {
    let (mut dag, [a, b], states) = symbols([a, b]);
    let (aa, bb, sum, difference) = (dag.mul(a, a), dag.mul(b, b), dag.add(a, b), dag.sub(a, b));
    let product = dag.mul(sum, difference);
    let groups = [vec![aa, bb, product]];
    let shorter = shorten(&mut dag, &groups, &states, &states, Effort::All);
    dag.cone_cost(&shorter[0])
}

#[test]
fn a_planted_identity_is_used_where_it_is_harmless() {
    assert_eq!(squares(&[1.0, 0.3], &[0.2, 2.0]), 3);
}

#[test]
fn the_guard_refuses_a_planted_identity_that_cancels() {
    // Sides nearly equal at the second state, as at the change point of a linkage.
    assert_eq!(squares(&[1.0, 0.3], &[0.2, 0.3 + 1e-7]), 5);
}

#[test]
fn of_two_equal_forms_that_stays_which_rounds_off_less() {
    // a^2 - b^2 comes first; (a + b)(a - b) does not cancel where the sides are nearly equal.
    let (mut dag, [a, b], states) = symbols([&[1.0, 0.3], &[0.2, 0.3 + 1e-7]]);
    let (aa, bb, sum, difference) = (dag.mul(a, a), dag.mul(b, b), dag.add(a, b), dag.sub(a, b));
    let (squares, product) = (dag.sub(aa, bb), dag.mul(sum, difference));
    let shorter = shorten(&mut dag, &[vec![squares, product]], &states, &states, Effort::Default);
    assert_eq!(shorter[0], [product, product]);
}

/// f(shortened), operations.
fn operations(build: impl Fn(&mut Dag, [ExprId; 4]) -> Vec<ExprId>, effort: Effort) -> usize {
    let (mut dag, exprs, states) = symbols([&[1.3, -0.4], &[0.7, 2.1], &[-1.9, 0.6], &[0.2, 1.1]]);
    let groups = [build(&mut dag, exprs)];
    let shorter = shorten(&mut dag, &groups, &states, &states, effort);
    dag.cone_cost(&shorter[0])
}

#[test]
fn equal_values_merge_across_forms() {
    // (a + b)(a - b) and a^2 - b^2 are one value, a zero and a one drop out.
    let build = |dag: &mut Dag, [a, b, c, _]: [ExprId; 4]| {
        let (sum, difference) = (dag.add(a, b), dag.sub(a, b));
        let (product, aa, bb) = (dag.mul(sum, difference), dag.mul(a, a), dag.mul(b, b));
        let squares = dag.sub(aa, bb);
        let zero = dag.sub(product, squares);
        let scaled = dag.mul(zero, c);
        let (sin, cos) = (dag.unary(Unary::Sin, c), dag.unary(Unary::Cos, c));
        let (ss, cc) = (dag.mul(sin, sin), dag.mul(cos, cos));
        let sa = dag.mul(ss, a);
        let ca = dag.mul(cc, a);
        let whole = dag.add(sa, ca);
        vec![scaled, whole]
    };
    assert_eq!(operations(build, Effort::Default), 0);
}

#[test]
fn common_factors_of_long_sums_are_taken_out() {
    // a b + c + a d + a = a (b + d + 1) + c
    let build = |dag: &mut Dag, [a, b, c, d]: [ExprId; 4]| {
        let (ab, ad) = (dag.mul(a, b), dag.mul(a, d));
        vec![dag.sum(&[ab, c, ad, a])]
    };
    assert_eq!(operations(build, Effort::Default), 4);
}

#[test]
fn sums_and_products_are_regrouped_to_share() {
    let sums = |dag: &mut Dag, [a, b, c, d]: [ExprId; 4]| vec![dag.sum(&[a, b, c]), dag.sum(&[a, c, d])];
    assert_eq!(operations(sums, Effort::All), 3);
    let products = |dag: &mut Dag, [a, b, c, d]: [ExprId; 4]| {
        let (ab, bd) = (dag.mul(a, b), dag.mul(b, d));
        vec![dag.mul(ab, c), dag.mul(bd, c)]
    };
    assert_eq!(operations(products, Effort::All), 3);
}

#[test]
fn functions_that_are_not_rational_are_left_alone() {
    let build = |dag: &mut Dag, [a, b, c, _]: [ExprId; 4]| {
        let (min, max) = (dag.binary(Binary::Min, a, b), dag.binary(Binary::Max, a, b));
        let (root, angle) = (dag.sqrt(c), dag.binary(Binary::Atan2, a, b));
        vec![min, max, root, angle, dag.unary(Unary::Abs, a)]
    };
    for effort in [Effort::Default, Effort::All] {
        assert_eq!(operations(build, effort), 5);
    }
}

#[test]
fn the_same_bytes_every_time() {
    let print = || {
        let steps: Vec<(Step, usize, usize)> = (0..60)
            .map(|k: usize| {
                let kind = [Step::Add, Step::Multiply, Step::Subtract, Step::Multiply][k % 4];
                (kind, k.wrapping_mul(7919) >> 3, k.wrapping_mul(104_729) >> 5)
            })
            .collect();
        let Sample { mut dag, symbols, groups, .. } = build(&steps);
        let guard = states(&symbols, 4);
        let shorter = shorten(&mut dag, &groups, &guard, &guard, Effort::All);
        format!("{shorter:?} {:?}", cost(&dag, &shorter))
    };
    assert_eq!(print(), print());
}
