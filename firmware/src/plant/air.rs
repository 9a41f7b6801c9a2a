//! The bladder as a piston of gas: sealed, or filled and vented through orifices.
//!
//! In: which valves are open. Out: the pressure over ambient.
//! Slow changes of temperature at rest are left out: p V = C (isothermal), V = A z, and the piston is at rest:
//! (p - p_a) A = W + k (z - z_0), with k the stiffness of the sheet. Flow through an orifice, never choked here:
//! q = c_d a sqrt(2 dp / rho).

use crate::tile::design::{AREA, GRAVITY};
use smartbed_runtime::real::{Real, Scalar};

/// Ambient pressure (Pa).
pub const AMBIENT: f64 = 101_325.0;
/// Pressure of the pump over ambient (Pa).
const PUMP: f64 = 16e3;
/// Stiffness of the sheet (N/m) and the height at which it is slack (m).
const SHEET: (f64, f64) = (5e3, 0.1);
/// 0.65 a sqrt(2 / rho) of 2 mm and 4 mm holes, a volume per second and root of pressure.
const ORIFICES: (f64, f64) = (2.636e-6, 1.0545e-5);
/// Least height (m): the sheet lies on the plate.
const BOTTOM: f64 = 2e-3;
const TICK: f64 = 1e-3;

/// A bladder.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Air<S> {
    /// p V (J), and what its sum has lost by rounding.
    content: [S; 2],
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
    /// Just slack, under a weight (N).
    #[must_use]
    pub fn with_weight(weight: S) -> Self {
        let (stiffness, slack) = (S::from_f64(SHEET.0), S::from_f64(SHEET.1));
        let height = Real::max(slack - weight / stiffness, S::from_f64(BOTTOM));
        let content = S::from_f64(AMBIENT) * S::from(AREA) * height;
        let mut air = Self { content: [content, S::ZERO], weight, pressure: S::ZERO };
        air.pressure = air.balance();
        air
    }

    /// Just slack, under so many kilograms.
    #[must_use]
    pub fn under(mass: S) -> Self {
        Self::with_weight(mass * S::from(GRAVITY))
    }

    /// Pressure over ambient (Pa).
    #[must_use]
    pub fn pressure(&self) -> S {
        self.pressure
    }

    /// Fills or empties it at once to this pressure (Pa over ambient).
    pub fn fill(&mut self, pressure: S) {
        let height = S::from_f64(SHEET.1) + (pressure * S::from(AREA) - self.weight) / S::from_f64(SHEET.0);
        self.content = [(S::from_f64(AMBIENT) + pressure) * S::from(AREA) * height, S::ZERO];
        self.pressure = self.balance();
    }

    /// Goes on by a millisecond.
    pub fn advance(&mut self, supply: bool, vent: bool) {
        let flow = |hole: S, difference: S| hole * Real::sqrt(Real::max(difference, S::ZERO));
        let (fill, empty) =
            (S::from_f64(ORIFICES.0 * AMBIENT * TICK), S::from_f64(ORIFICES.1 * AMBIENT * TICK));
        let mut change = self.content[1];
        if supply {
            change = change + flow(fill, S::from_f64(PUMP) - self.pressure);
        }
        if vent {
            change = change - flow(empty, self.pressure);
        }
        let before = self.content[0];
        let after = before + change;
        self.content = [after, change - (after - before)];
        self.pressure = self.balance();
    }

    /// The pressure at which the piston rests: k z^2 + (p_a A + W - k z_0) z - C = 0.
    fn balance(&self) -> S {
        let (stiffness, slack) = (S::from_f64(SHEET.0), S::from_f64(SHEET.1));
        let area = S::from(AREA);
        let half = S::from_f64(0.5) * (S::from_f64(AMBIENT) * area + self.weight - stiffness * slack);
        // The root in the form without a difference of equal numbers.
        let height = self.content[0] / (half + Real::sqrt(half * half + stiffness * self.content[0]));
        let height = Real::max(height, S::from_f64(BOTTOM));
        Real::max((self.weight + stiffness * (height - slack)) / area, S::ZERO)
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
        assert!((air.content[0] - (AMBIENT + 4000.0) * 0.0643 * height).abs() < 1e-4);
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
        assert_eq!(air.pressure(), 0.0);
    }
}
