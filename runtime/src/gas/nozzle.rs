//! Mass flow of gas through a restriction (ISO 6358-1:2013): choked, subsonic, and linear near equal pressures.
//!
//! In: conductance C, critical ratio b, pressures and upstream temperature. Out: kg/s. With r = p_2/p_1:
//! ```text
//! m' = C rho_0 p_1 sqrt(T_0/T_1) psi(r)
//! psi = 1                               r <= b                 choked
//!     = sqrt(1 - ((r - b)/(1 - b))^2)   b < r < 1 - 1e-3
//!     = psi(1 - 1e-3) (1 - r)/1e-3      r >= 1 - 1e-3          laminar: psi's own slope at r = 1 is infinite
//! ```

use super::ideal::Gas;
use crate::real::Scalar;

/// rho_0 (kg/m^3) of ISO 6358: air at 20 degrees, 100 kPa, 65 % humidity.
pub const REFERENCE_DENSITY: f64 = 1.185;
/// T_0 (K) of ISO 6358.
pub const REFERENCE_TEMPERATURE: f64 = 293.15;
/// The flow is linear for 1 - r below this.
pub const LINEAR_RANGE: f64 = 1e-3;

/// A restriction: valve, orifice or leak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nozzle<S> {
    /// Sonic conductance C (m^3/(s Pa)), >= 0.
    pub conductance: S,
    /// Critical ratio of pressures b, 0 to less than 1.
    pub critical_ratio: S,
}

/// Gas at rest on one side of a nozzle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source<S> {
    /// Absolute pressure (Pa).
    pub pressure: S,
    /// Temperature (K).
    pub temperature: S,
}

impl<S: Scalar> Nozzle<S> {
    /// A sharp orifice of this diameter (m): C from its choked flow, b that of isentropic flow.
    ///
    /// The ellipse of ISO 6358 then agrees with the orifice's subsonic flow within 1 %, and with Bernoulli's law near r
    /// = 1 within 0.4 %.
    #[must_use]
    pub fn orifice(gas: &Gas<S>, diameter: S, discharge: S) -> Nozzle<S> {
        let (one, two) = (S::ONE, S::from_f64(2.0));
        let ratio = gas.heat_capacity_ratio;
        let area = S::from_f64(core::f64::consts::FRAC_PI_4) * diameter * diameter;
        // Choked: m' = Cd A p_1 sqrt(gamma/(R T_1)) (2/(gamma + 1))^((gamma + 1)/(2 (gamma - 1))).
        let log = (two / (ratio + one)).ln();
        let choked = ((ratio + one) / (two * (ratio - one)) * log).exp();
        let flow = discharge * area * (ratio / gas.gas_constant).sqrt() * choked;
        let reference = S::from_f64(REFERENCE_DENSITY) * S::from_f64(REFERENCE_TEMPERATURE).sqrt();
        Nozzle { conductance: flow / reference, critical_ratio: (ratio / (ratio - one) * log).exp() }
    }

    /// Mass flow (kg/s) from upstream to a lower pressure (Pa, absolute); 0 if it is not lower.
    #[must_use]
    pub fn mass_flow(&self, upstream: Source<S>, downstream: S) -> S {
        let ratio = downstream / upstream.pressure;
        let flows = ratio < S::ONE && upstream.temperature > S::ZERO;
        if !flows {
            return S::ZERO;
        }
        let density = S::from_f64(REFERENCE_DENSITY);
        let cooling = (S::from_f64(REFERENCE_TEMPERATURE) / upstream.temperature).sqrt();
        self.conductance * density * upstream.pressure * cooling * self.share(ratio)
    }

    /// Largest change of the mass flow per change of the downstream pressure (kg/(s Pa)): that at equal pressures.
    #[must_use]
    pub fn steepest(&self, upstream: Source<S>) -> S {
        let range = S::from_f64(LINEAR_RANGE);
        let cooling = (S::from_f64(REFERENCE_TEMPERATURE) / upstream.temperature).sqrt();
        self.conductance * S::from_f64(REFERENCE_DENSITY) * cooling * self.ellipse(range) / range
    }

    /// psi(r), the flow relative to choked flow.
    fn share(&self, ratio: S) -> S {
        let range = S::from_f64(LINEAR_RANGE);
        let left = S::ONE - ratio;
        if left < range { self.ellipse(range) * (left / range) } else { self.ellipse(left) }
    }

    /// sqrt(1 - x^2) for r = 1 - left, with 1 - x = left/(1 - b): no cancellation near r = 1.
    fn ellipse(&self, left: S) -> S {
        let below = left / (S::ONE - self.critical_ratio);
        if below >= S::ONE { S::ONE } else { (below * (S::from_f64(2.0) - below)).sqrt() }
    }
}
