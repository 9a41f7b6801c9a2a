//! The two material constants of an ideal gas.

use crate::real::Scalar;

/// Material constants of an ideal gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gas<S> {
    /// R (J/(kg K)).
    pub gas_constant: S,
    /// gamma = c_p/c_v, > 1.
    pub heat_capacity_ratio: S,
}

impl<S: Scalar> Gas<S> {
    /// Dry air.
    #[must_use]
    pub fn air() -> Gas<S> {
        Gas { gas_constant: S::from_f64(287.05), heat_capacity_ratio: S::from_f64(1.4) }
    }

    /// c_p (J/(kg K)).
    #[must_use]
    pub fn heat_capacity(&self) -> S {
        let ratio = self.heat_capacity_ratio;
        ratio * self.gas_constant / (ratio - S::ONE)
    }
}
