//! Gas in a closed volume: pressure from volume and mass, flow through valves, energy accounts.
//!
//! In: the volume V that encloses the gas (a bladder, a cylinder), its rate, and the lines that lead in and out.
//! Out: the pressure on the walls and the rates of the gas' own state.
//!
//! Ideal gas with one polytropic exponent n, from 1 (slow, isothermal) to gamma (fast, adiabatic):
//! ```text
//! V p' = n (R T_in m_in' - R T m_out' - p V')          p V = m R T
//! U = p V/(gamma - 1),  U' = c_p (T_in m_in' - T m_out') + Q' - p V'
//! ```
//! n other than gamma means heat through the walls: Q' = (n - gamma)/(gamma - 1) (R T_in m_in' - R T m_out' - p V').
//! The state is s = p (V/V_r)^n, the pressure at a reference volume V_r, instead of p: V' then drops out,
//! s' = n (V/V_r)^n (R T_in m_in' - R T m_out')/V, and for a sealed gas s is constant, so p V^n is conserved exactly.
//! (Richer and Hurmuzlu 2000; flow by ISO 6358-1:2013.)

mod chamber;
mod ideal;
mod nozzle;

pub use chamber::{Account, Chamber, GasFault, GasState, Line, Rates, Regulated};
pub use ideal::Gas;
pub(crate) use ideal::work;
pub use nozzle::{LINEAR_RANGE, Nozzle, REFERENCE_DENSITY, REFERENCE_TEMPERATURE, Source};
