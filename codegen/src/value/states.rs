//! Values of all symbols at sampled states of the mechanism.

use crate::expr::SymbolId;
use rustc_hash::FxHashMap as HashMap;

/// States at which round-off is watched: values by symbol.
#[derive(Clone, Debug, Default)]
pub struct States {
    /// Number of states.
    pub points: usize,
    /// By symbol: one value per state. A symbol without values counts as 1.
    pub symbols: HashMap<SymbolId, Vec<f64>>,
}

impl States {
    pub(super) fn value(&self, symbol: SymbolId, point: usize) -> f64 {
        self.symbols.get(&symbol).map_or(1.0, |values| values[point])
    }
}
