//! Gas in a closed volume: pressure from volume and mass, flow through valves, accounts of energy.
//!
//! In: the volume V of whatever encloses the gas (a bladder, a cylinder), its rate, and the lines that lead in and out.
//! Out: the pressure on the walls and the rates of the gas' own state.
//!
//! Ideal gas of one exponent n, 1 (slow, isothermal) to gamma (fast, adiabatic):
//! ```text
//! V p' = n (R T_in m_in' - R T m_out' - p V')          p V = m R T
//! U = p V/(gamma - 1),  U' = c_p (T_in m_in' - T m_out') + Q' - p V'
//! ```
//! n other than gamma means heat through the walls: Q' = (n - gamma)/(gamma - 1) (R T_in m_in' - R T m_out' - p V').
//! State is s = p (V/V_r)^n, the pressure at a reference volume V_r, instead of p: then V' drops out,
//! s' = n (V/V_r)^n (R T_in m_in' - R T m_out')/V, and a sealed gas keeps p V^n by being left alone.
//! (Richer and Hurmuzlu 2000; flow by ISO 6358-1:2013.)

mod chamber;
mod nozzle;

pub use chamber::{Account, Chamber, GasFault, GasState, Line, Rates, Regulated};
pub use nozzle::{LINEAR_RANGE, Nozzle, REFERENCE_DENSITY, REFERENCE_TEMPERATURE, Source};

use crate::real::Scalar;

/// What kind of gas.
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
