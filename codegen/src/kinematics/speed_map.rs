//! Kinematic differential equations: q_dot = N(q) u.

use super::{Kinematics, Rate};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::Id;
use crate::model::{Model, SpeedMeaning};
use std::collections::BTreeMap;

/// Fills the rates of all coordinates.
pub(super) fn derive(model: &Model, k: &mut Kinematics) -> Result<(), Diagnostics> {
    let zero = k.dag.zero();
    let one = k.dag.one();
    k.rates = model.coordinates.iter().map(|_| Rate { partials: BTreeMap::new(), bias: zero }).collect();
    for (speed, declared) in model.speeds.enumerate() {
        match &declared.meaning {
            SpeedMeaning::RateOf(coordinate) => {
                let unknown = super::UnknownId::from_index(speed.index());
                k.rates[*coordinate].partials.insert(unknown, one);
            }
            SpeedMeaning::Combination(expression) => {
                let error = Diagnostic::error("speeds as combinations of rates cannot be derived yet")
                    .label(expression.span, "not the rate of one coordinate")
                    .help("use the coordinates' own speeds, and state the rest as a motion constraint");
                return Err(Diagnostics::one(model.source.clone(), error));
            }
        }
    }
    Ok(())
}
