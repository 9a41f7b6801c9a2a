//! Numbers of all symbols at sampled configurations.
//!
//! In: configurations that satisfy the constraints. Out: a table in which expressions are evaluated at all of them.

use super::quantities::{Kinematics, Sample};
use super::random::Random;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::id::IdVec;
use crate::model::{Model, ParameterId};
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;

/// Table of all symbols at the sampled configurations: speeds and inputs random, parameters default.
#[must_use]
pub fn sample_table(alg: &Algebra, model: &Model, k: &Kinematics) -> SampleTable {
    table_at(alg, model, k, &k.sampled())
}

/// [`sample_table`] at other configurations.
pub(super) fn table_at(alg: &Algebra, model: &Model, k: &Kinematics, samples: &[Sample]) -> SampleTable {
    table_with(alg, model, k, samples, &k.parameter_values)
}

/// [`table_at`] other values of the parameters.
pub(super) fn table_with(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    samples: &[Sample],
    parameters: &IdVec<ParameterId, f64>,
) -> SampleTable {
    let points = samples.len();
    let mut random = Random(0x00C0_FFEE);
    let mut symbols: HashMap<SymbolId, Vec<f64>> = HashMap::default();
    let mut set = |dag: &Dag, expr: ExprId, values: Vec<f64>| {
        if let Some(symbol) = dag.as_symbol(expr) {
            symbols.insert(symbol, values);
        }
    };
    let state: Vec<_> =
        model.coordinates.ids().filter(|&c| k.coordinate_symbol(&alg.dag, c).is_some()).collect();
    let sizes = state.iter().filter_map(|&c| {
        let (low, high) = model.coordinates[c].range;
        Some((k.coordinate_symbol(&alg.dag, c)?, low.abs().max(high.abs())))
    });
    let sizes = sizes.collect();
    for (i, &c) in state.iter().enumerate() {
        set(&alg.dag, k.q[c], samples.iter().map(|sample| sample.q[i]).collect());
    }
    for (id, &expr) in k.parameters.enumerate() {
        set(&alg.dag, expr, vec![parameters[id]; points]);
    }
    set(&alg.dag, k.time, samples.iter().map(|sample| sample.t).collect());
    for &input in k.inputs.iter() {
        set(&alg.dag, input, (0..points).map(|_| random.between((-1.0, 1.0))).collect());
    }
    for unknown in k.unknowns.iter() {
        set(&alg.dag, unknown.value, (0..points).map(|_| random.between((-1.0, 1.0))).collect());
    }
    for &(coordinate, form) in &k.closed_forms {
        let values = SampleTable::new(symbols.clone(), points).values(&alg.dag, form).to_vec();
        symbols.extend(alg.dag.as_symbol(k.q[coordinate]).map(|symbol| (symbol, values)));
    }
    SampleTable::new(symbols, points).with_sizes(sizes)
}
