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

/// n this close to 1 is near it: beyond, (1 - y)/(n - 1) loses no more than four bits.
const NEAR: f64 = 1.0 / 16.0;

/// Work (J) of a gas from a volume V_r, where p V_r is `reference` (J), to another one, by ln(V/V_r) and n:
/// p V_r (1 - y)/(n - 1) with y = (V/V_r)^(1 - n); ln(V/V_r) in place of the quotient where n = 1.
pub(crate) fn work<S: Scalar>(reference: S, exponent: S, log: S) -> S {
    let power = exponent - S::ONE;
    if power == S::ZERO {
        return reference * log;
    }
    let y = (-(power * log)).exp();
    if power.abs() > S::from_f64(NEAR) {
        return reference * (S::ONE - y) / power;
    }
    // y's rounding, which 1 - y inherits, is in ln y as well: their quotient keeps its digits (Kahan).
    let rounded = -y.ln();
    if rounded == S::ZERO { reference * log } else { reference * log * ((S::ONE - y) / rounded) }
}
