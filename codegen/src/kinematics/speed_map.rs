//! Kinematic differential equations: q_dot = N(q) u.
//!
//! In: every speed as the rate of a coordinate or as a linear combination u = Y(q) q_dot. Out: the rates as linear
//! forms in the speeds, N = Y^-1 by sparse elimination with pivots screened at random configurations; if these vanish
//! where Y is regular, N = Y' (Y Y')^-1. A coordinate in closed form is not part of the state. If it has a speed of its
//! own, its rate is that speed, a dependent one, which constraint rows determine where they are shorter than the
//! derivative of the form. Otherwise its rate follows by the chain rule.

use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Rate};
use super::random::Random;
use super::sparse::{self, Equation, Values};
use super::unknowns::{Unknown, UnknownId, UnknownKind, Unknowns};
use super::{lower, rate};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::id::Id;
use crate::model::expression::{Expr, ExprKind};
use crate::model::{CoordinateId, Entity, Model, Speed, SpeedMeaning};
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;
use std::collections::BTreeMap;

/// Random configurations, besides the nominal one, at which pivots are screened.
const SCREENED: usize = 16;
/// If a pivot is not larger than this at the nominal configuration, the rates do not follow from the speeds.
const SINGULAR: f64 = 1e-9;

/// Expressions that differ by less than this share of their terms at all points are taken as equal.
const IDENTICAL: f64 = 1e-12;

/// Adds the rates of all coordinates.
pub(super) fn derive(alg: &mut Algebra, model: &Model, mut k: Kinematics) -> Result<Kinematics, Diagnostics> {
    let (zero, one) = (alg.dag.zero(), alg.dag.one());
    k.rates =
        model.coordinates.iter().map(|_| Rate { partials: LinearForm::default(), bias: zero }).collect();
    if has_combinations(model) {
        k = invert(alg, model, k)?;
    } else {
        for (speed, declared) in model.speeds.enumerate() {
            if let SpeedMeaning::RateOf(coordinate) = declared.meaning
                && k.variable(&alg.dag, coordinate).is_some()
            {
                k.rates[coordinate].partials.insert(UnknownId::from_index(speed.index()), one);
            }
        }
    }
    Ok(closed_forms(alg, model, k))
}

fn has_combinations(model: &Model) -> bool {
    model.speeds.iter().any(|s| matches!(s.meaning, SpeedMeaning::Combination(_)))
}

/// Is the rate of this coordinate, if it is in closed form, an unknown of its own?
pub(super) fn is_variable(model: &Model, coordinate: CoordinateId) -> bool {
    let own = |s: &Speed| matches!(s.meaning, SpeedMeaning::RateOf(of) if of == coordinate);
    model.speeds.iter().any(own) && !has_combinations(model)
}

/// Adds the rates of coordinates in closed form, by the chain rule.
fn closed_forms(alg: &mut Algebra, model: &Model, mut k: Kinematics) -> Kinematics {
    for id in model.coordinates.ids() {
        if k.variable(&alg.dag, id).is_none() {
            k.rates[id] = rate::scalar_rate(alg, &k, k.q[id]);
        }
    }
    k
}

/// N = Y^-1, row by row; then the bias of q'', quadratic in the speeds.
fn invert(alg: &mut Algebra, model: &Model, mut k: Kinematics) -> Result<Kinematics, Diagnostics> {
    let equations = equations(alg, model, &k)?;
    let states: Vec<CoordinateId> = model.coordinates.ids().filter(|&c| k.is_state[c]).collect();
    let mut table = screening_table(alg, model, &k);
    let mut usable = |dag: &Dag, (values, pivots): &(Values, Vec<ExprId>)| {
        let mut nominal = |p: &ExprId| table.values(dag, *p)[0].abs();
        values.len() >= states.len() && pivots.iter().all(|p| SINGULAR < nominal(p))
    };
    let mut screened = screening_table(alg, model, &k);
    let solved = sparse::solve(&mut alg.dag, &mut screened, equations.clone());
    let solved = match solved.filter(|solved| usable(&alg.dag, solved)) {
        Some(solved) if is_regular(alg, model, &k, &solved.1) => Some(solved),
        solved => least_norm(alg, model, &k, &equations).filter(|solved| usable(&alg.dag, solved)).or(solved),
    };
    let Some((values, pivots)) = solved else { return Err(not_invertible(model)) };
    k.rate_pivots = pivots;
    for (&coordinate, row) in states.iter().zip(values.values()) {
        let entries = row.iter().enumerate().filter(|(_, e)| !alg.dag.is_zero(**e));
        k.rates[coordinate].partials = entries.map(|(u, &e)| (UnknownId::from_index(u), e)).collect();
    }
    let speeds = equations.into_iter().zip(model.speeds.enumerate().filter(|(_, speed)| has_row(&k, speed)));
    k.combinations = speeds
        .filter(|(_, (_, speed))| matches!(speed.meaning, SpeedMeaning::Combination(_)))
        .map(|(row, (speed, _))| (k.unknowns.of(speed), row.coefficients))
        .collect();
    for &coordinate in &states {
        k.rates[coordinate].bias = rate::bias_of(alg, &k, &k.rates[coordinate].partials);
    }
    Ok(k)
}

/// Do the pivots vanish only where Y is singular? If a pivot changes its sign but the product of all pivots (det Y up
/// to its sign) does not, that pivot vanishes in between where Y is regular.
fn is_regular(alg: &Algebra, model: &Model, k: &Kinematics, pivots: &[ExprId]) -> bool {
    let mut table = screening_table(alg, model, k);
    let mut signs = |p: &ExprId| -> Vec<bool> {
        table.values(&alg.dag, *p).iter().map(|x| x.is_sign_positive()).collect()
    };
    let signs: Vec<Vec<bool>> = pivots.iter().map(&mut signs).collect();
    let one_sign = |signs: &[bool]| signs.windows(2).all(|pair| pair[0] == pair[1]);
    let points = signs.first().map_or(0, Vec::len);
    let product: Vec<bool> =
        (0..points).map(|s| signs.iter().fold(true, |product, signs| product == signs[s])).collect();
    signs.iter().all(|signs| one_sign(signs)) || !one_sign(&product)
}

/// N = Y' (Y Y')^-1: the pivots of the symmetric Y Y' vanish only where Y is singular. If the rows of Y are orthogonal,
/// as for Euler parameters, Y Y' is diagonal.
fn least_norm(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    equations: &[Equation],
) -> Option<(Values, Vec<ExprId>)> {
    let mut identities = identity_table(alg, model, k);
    let mut gram: BTreeMap<UnknownId, Equation> = BTreeMap::new();
    let mut diagonals: Vec<(ExprId, Vec<f64>)> = Vec::new();
    for (i, row) in equations.iter().enumerate() {
        let mut coefficients = LinearForm::default();
        for (j, other) in equations.iter().enumerate() {
            let shared = row.coefficients.iter().filter_map(|(c, &x)| Some((x, *other.coefficients.get(c)?)));
            let terms: Vec<ExprId> = shared.map(|(x, y)| alg.dag.mul(x, y)).collect();
            let sum = alg.dag.sum(&terms);
            let mut size = vec![0.0_f64; identities.points()];
            for &term in &terms {
                let values = identities.values(&alg.dag, term);
                size.iter_mut().zip(values).for_each(|(size, x)| *size += x.abs());
            }
            let values = identities.values(&alg.dag, sum).to_vec();
            let same = |a: &[f64], b: &[f64]| {
                a.iter().zip(b).zip(&size).all(|((a, b), size)| (a - b).abs() <= IDENTICAL * size)
            };
            if same(&values, &vec![0.0; size.len()]) {
                continue;
            }
            let known = diagonals.iter().find(|(_, known)| i == j && same(known, &values)).map(|(d, _)| *d);
            if i == j && known.is_none() {
                diagonals.push((sum, values));
            }
            coefficients.insert(UnknownId::from_index(j), known.unwrap_or(sum));
        }
        gram.insert(UnknownId::from_index(i), Equation { coefficients, right: row.right.clone() });
    }
    let mut table = screening_table(alg, model, k);
    let done = sparse::eliminate_definite(&mut alg.dag, &mut table, gram);
    let by_row = sparse::back_substitute(&mut alg.dag, &done)?;
    let mut values = Values::new();
    for (row, solved) in equations.iter().zip(by_row.values()) {
        for (&coordinate, &y) in &row.coefficients {
            let n = solved.len();
            let zero = alg.dag.zero();
            let mine = values.entry(coordinate).or_insert_with(|| vec![zero; n]);
            for (sum, &x) in mine.iter_mut().zip(solved) {
                let product = alg.dag.mul(y, x);
                *sum = alg.dag.add(*sum, product);
            }
        }
    }
    Some((values, done.into_iter().map(|step| step.pivot).collect()))
}

/// Is the speed an equation for the rates? The rate of a coordinate in closed form is a dependent speed instead.
fn has_row(k: &Kinematics, speed: &Speed) -> bool {
    !matches!(speed.meaning, SpeedMeaning::RateOf(coordinate) if !k.is_state[coordinate])
}

/// Y q_dot = u: one equation per speed; unknown c is the rate of coordinate c, right-hand side s is u_s.
fn equations(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Result<Vec<Equation>, Diagnostics> {
    let (zero, one) = (alg.dag.zero(), alg.dag.one());
    let by_rates = with_rates_as_unknowns(alg, model, k);
    let mut equations = Vec::new();
    let mut found = Diagnostics::new(model.source.clone());
    for (speed, declared) in model.speeds.enumerate() {
        let coefficients = match &declared.meaning {
            SpeedMeaning::RateOf(coordinate) if k.is_state[*coordinate] => {
                LinearForm::from_iter([(UnknownId::from_index(coordinate.index()), one)])
            }
            // A dependent speed, not an equation for the rates.
            SpeedMeaning::RateOf(_) => continue,
            SpeedMeaning::Combination(expression) => {
                let value = lower::scalar(alg, &by_rates, expression);
                coefficients(alg, value, &by_rates.unknowns).unwrap_or_else(|| {
                    found.push(affine(declared, expression));
                    LinearForm::default()
                })
            }
        };
        let mut right = vec![zero; model.speeds.len()];
        right[speed.index()] = one;
        equations.push(Equation { coefficients, right });
    }
    found.finish(equations)
}

/// The same kinematics with the rates of the coordinates as unknowns, and with definitions that depend on nothing else.
fn with_rates_as_unknowns(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Kinematics {
    let one = alg.dag.one();
    let mut by_rates = Kinematics { unknowns: Unknowns::default(), ..k.clone() };
    for (id, coordinate) in model.coordinates.enumerate() {
        let name = format!("rate of {}", coordinate.name);
        let value = alg.dag.symbol(&name);
        let unknown = by_rates.unknowns.push(Unknown { name, value, kind: UnknownKind::Lifted });
        if k.is_state[id] {
            by_rates.rates[id].partials.insert(unknown, one);
        }
    }
    if let Some(clock) = k.unknowns.clock() {
        by_rates.unknowns.push(k.unknowns[clock].clone());
    }
    let mut by_rates = closed_forms(alg, model, by_rates);
    for entity in &model.order {
        let Entity::Definition(id) = *entity else { continue };
        let value = &model.definitions[id].value;
        if by_rates.definitions[id].is_none() && !needs_speeds(&by_rates, value) {
            by_rates.definitions[id] = Some(lower::value(alg, &by_rates, value));
        }
    }
    by_rates
}

fn needs_speeds(k: &Kinematics, expr: &Expr) -> bool {
    let mut found = false;
    expr.visit(&mut |e| {
        found |= match &e.kind {
            ExprKind::Velocity(_) | ExprKind::AngularVelocity(_) | ExprKind::Speed(_) => true,
            ExprKind::Definition(id) => k.definitions[*id].is_none(),
            _ => false,
        };
    });
    found
}

/// Coefficients of the rates; `None` if the expression does not vanish when all rates are 0.
fn coefficients(alg: &mut Algebra, value: ExprId, symbols: &Unknowns) -> Option<LinearForm> {
    let zero = alg.dag.zero();
    let mut result = LinearForm::default();
    let mut at_rest: HashMap<SymbolId, ExprId> = HashMap::default();
    for (id, unknown) in symbols.enumerate() {
        let Some(symbol) = alg.dag.as_symbol(unknown.value) else { continue };
        at_rest.insert(symbol, zero);
        let slope = alg.dag.derivative(value, symbol);
        if !alg.dag.is_zero(slope) {
            result.insert(id, slope);
        }
    }
    let remains = alg.dag.substitute(&[value], &at_rest)[0];
    alg.dag.is_zero(remains).then_some(result)
}

/// Values of the coordinates at nominal and at random points of their ranges, which need not satisfy the constraints.
pub(super) fn screening_table(alg: &Algebra, model: &Model, k: &Kinematics) -> SampleTable {
    let mut random = Random(0x5CA1_AB1E);
    let mut symbols: HashMap<SymbolId, Vec<f64>> = HashMap::default();
    for (id, coordinate) in model.coordinates.enumerate() {
        if let Some(symbol) = k.coordinate_symbol(&alg.dag, id) {
            let places = (0..SCREENED).map(|_| random.between(coordinate.range));
            symbols.insert(symbol, std::iter::once(coordinate.nominal).chain(places).collect());
        }
    }
    for (id, &expr) in k.parameters.enumerate() {
        if let Some(symbol) = alg.dag.as_symbol(expr) {
            symbols.insert(symbol, vec![k.parameter_values[id]; 1 + SCREENED]);
        }
    }
    symbols.extend(alg.dag.as_symbol(k.time).map(|time| (time, vec![0.0; 1 + SCREENED])));
    SampleTable::new(symbols, 1 + SCREENED)
}

/// [`screening_table`] with different parameters at every point: expressions equal there are equal for all parameters.
fn identity_table(alg: &Algebra, model: &Model, k: &Kinematics) -> SampleTable {
    let mut random = Random(0x1DE7_717E);
    let table = screening_table(alg, model, k);
    let parameters = k.parameters.enumerate().filter_map(|(id, &expr)| {
        let size = k.parameter_values[id].abs().max(1.0);
        let values = (0..table.points()).map(|_| random.between((0.5 * size, 1.5 * size))).collect();
        Some((alg.dag.as_symbol(expr)?, values))
    });
    let parameters: HashMap<SymbolId, Vec<f64>> = parameters.collect();
    table.with_symbols(parameters)
}

fn affine(speed: &Speed, expression: &Expr) -> Diagnostic {
    Diagnostic::error(format!("the speed `{}` does not vanish at rest", speed.name))
        .label(expression.span, "this has a part without a rate")
        .help("a speed is a sum of rates with coefficients that depend on coordinates: u = a(q)*q_dot(q1) + ...")
}

fn not_invertible(model: &Model) -> Diagnostics {
    let mut error = Diagnostic::error("the rates of the coordinates do not follow from the speeds").help(
        "at the nominal configuration the speeds, as combinations of rates, must be independent: as many as \
               there are coordinates, and none a combination of the others",
    );
    for speed in model.speeds.iter() {
        if let SpeedMeaning::Combination(expression) = &speed.meaning {
            error = error.label(expression.span, "one of the combinations");
        }
    }
    Diagnostics::one(model.source.clone(), error)
}
