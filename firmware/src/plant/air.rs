//! The bladder as a gas-filled piston: sealed, or filled and vented through orifices.
//!
//! In: which valves are open. Out: the pressure over ambient. Gas and orifices are the runtime's
//! (`smartbed_runtime::gas`), isothermal, because changes are slow and the walls large. The piston is in equilibrium:
//! (p - p_a) A = W + k (z - z_0), with k the stiffness of the sheet and V = A z.

use crate::tile::design::{AREA, GRAVITY};
use smartbed_runtime::gas::{Chamber, Gas, GasState, Line, Nozzle, Source};
use smartbed_runtime::real::{Real, Scalar};

/// Ambient pressure (Pa).
pub const AMBIENT: f64 = 101_325.0;
/// Temperature of all air (K).
const TEMPERATURE: f64 = 293.15;
/// Pressure of the pump over ambient (Pa).
const PUMP: f64 = 16e3;
/// Stiffness of the sheet (N/m), and its slack height (m).
const SHEET: (f64, f64) = (5e3, 0.1);
/// Diameters of the holes of supply and vent (m), and their discharge coefficient.
const HOLES: (f64, f64) = (2e-3, 4e-3);
const DISCHARGE: f64 = 0.65;
/// Least height (m), where the sheet lies on the plate.
const BOTTOM: f64 = 2e-3;
const TICK: f64 = 1e-3;

/// A bladder.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Air<S> {
    /// Its reference volume is 1 m^3, so that its state is p V (J).
    chamber: Chamber<S>,
    /// Supply and vent.
    lines: [Line<S>; 2],
    state: GasState<S>,
    /// Rounding error of the sum p V.
    low: S,
    /// Weight on it (N).
    weight: S,
    pressure: S,
}

impl<S: Scalar + From<f32>> Default for Air<S> {
    fn default() -> Self {
        Self::with_weight(S::ZERO)
    }
}

impl<S: Scalar + From<f32>> Air<S> {
    /// At the slack height, under a weight (N).
    #[must_use]
    pub fn with_weight(weight: S) -> Self {
        let (gas, ambient) = (Gas::air(), S::from_f64(AMBIENT));
        let line = |hole: S, over: S| Line {
            nozzle: Nozzle::orifice(&gas, hole, S::from_f64(DISCHARGE)),
            opening: S::ZERO,
            reservoir: Source { pressure: ambient + over, temperature: S::from_f64(TEMPERATURE) },
        };
        let lines = [line(S::from_f64(HOLES.0), S::from_f64(PUMP)), line(S::from_f64(HOLES.1), S::ZERO)];
        let height = Real::max(S::from_f64(SHEET.1) - weight / S::from_f64(SHEET.0), S::from_f64(BOTTOM));
        let mut air = Self {
            chamber: Chamber { gas, exponent: S::ONE, reference_volume: S::ONE, ambient },
            lines,
            state: GasState { reference_pressure: S::ZERO, mass: S::ZERO },
            low: S::ZERO,
            weight,
            pressure: S::ZERO,
        };
        air.hold(ambient * S::from(AREA) * height);
        air
    }

    /// At the slack height, under a mass (kg).
    #[must_use]
    pub fn under(mass: S) -> Self {
        Self::with_weight(mass * S::from(GRAVITY))
    }

    /// Pressure over ambient (Pa).
    #[must_use]
    pub fn pressure(&self) -> S {
        self.pressure
    }

    /// Fills or empties it instantly to this pressure (Pa over ambient).
    pub fn fill(&mut self, pressure: S) {
        let height = S::from_f64(SHEET.1) + (pressure * S::from(AREA) - self.weight) / S::from_f64(SHEET.0);
        self.low = S::ZERO;
        self.hold((S::from_f64(AMBIENT) + pressure) * S::from(AREA) * height);
    }

    /// Advances by a millisecond.
    pub fn advance(&mut self, supply: bool, vent: bool) {
        for (line, is_open) in self.lines.iter_mut().zip([supply, vent]) {
            line.opening = if is_open { S::ONE } else { S::ZERO };
        }
        let volume = S::from(AREA) * self.height();
        // Volume and mass are never 0, see `hold`, so the rates exist.
        let Ok(rates) = self.chamber.rates(&self.state, volume, S::ZERO, &self.lines) else { return };
        let before = self.state.reference_pressure;
        let change = self.low + S::from_f64(TICK) * rates.reference_pressure;
        let after = before + change;
        self.low = change - (after - before);
        self.hold(after);
    }

    /// Sets the state to p V (J), at the temperature of the walls, with the piston in equilibrium.
    fn hold(&mut self, content: S) {
        let mass = content / (self.chamber.gas.gas_constant * S::from_f64(TEMPERATURE));
        self.state = GasState { reference_pressure: content, mass };
        let (stiffness, slack) = (S::from_f64(SHEET.0), S::from_f64(SHEET.1));
        let carried = self.weight + stiffness * (self.height() - slack);
        self.pressure = Real::max(carried / S::from(AREA), S::ZERO);
    }

    /// Height of the piston in equilibrium: k z^2 + (p_a A + W - k z_0) z - p V = 0.
    fn height(&self) -> S {
        let (stiffness, slack) = (S::from_f64(SHEET.0), S::from_f64(SHEET.1));
        let content = self.state.reference_pressure;
        let half =
            S::from_f64(0.5) * (S::from_f64(AMBIENT) * S::from(AREA) + self.weight - stiffness * slack);
        // The form of the root without cancellation.
        let height = content / (half + Real::sqrt(half * half + stiffness * content));
        Real::max(height, S::from_f64(BOTTOM))
    }
}

#[cfg(test)]
mod tests {
    use super::{AMBIENT, Air};

    #[test]
    fn gas_and_sheet_are_in_balance() {
        let mut air = Air::<f64>::under(20.0);
        air.fill(4000.0);
        assert!((air.pressure() - 4000.0).abs() < 1e-6);
        let height = 0.1 + (4000.0 * 0.0643 - 20.0 * 9.81) / 5e3;
        assert!((air.state.reference_pressure - (AMBIENT + 4000.0) * 0.0643 * height).abs() < 1e-4);
        let before = air;
        (0..1000).for_each(|_| air.advance(false, false));
        assert_eq!(air, before, "sealed");
    }

    #[test]
    fn it_fills_and_empties() {
        let mut air = Air::<f32>::under(25.0);
        let mut ticks = 0;
        while air.pressure() < 10e3 {
            air.advance(true, false);
            ticks += 1;
        }
        assert!((10_000..60_000).contains(&ticks), "{ticks}");
        let mut ticks = 0;
        while air.pressure() > 100.0 {
            air.advance(false, true);
            ticks += 1;
        }
        assert!((5000..25_000).contains(&ticks), "{ticks}");
        (0..10_000).for_each(|_| air.advance(false, true));
        // Absolute pressures near 1e5 have steps of 0.0078 in single precision, and the flow ends where they meet.
        assert!(air.pressure() < 0.05, "{}", air.pressure());
    }
}
