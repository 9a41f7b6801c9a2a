//! Sealed gas of flexible parts: its supply and vent, and its energy accounts.

use smartbed_runtime::gas::{Account, Line};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::world::{Cell, Content};

/// A sealed gas, reported under the name of its part.
#[derive(Clone, Debug)]
pub(super) struct Air<S = f64> {
    /// The part that encloses it.
    pub(super) part: usize,
    pub(super) cell: usize,
    /// Volume behind the last step (m^3).
    pub(super) volume: S,
    /// Supply and vent, as far as there are.
    pub(super) lines: [Option<Line<S>>; 2],
    /// Enthalpy, heat and work since the start (J).
    pub(super) account: Account<S>,
}

/// Number of values of an [`Air`] in a checkpoint.
pub(super) const SAVED: usize = 6;

impl<S: Scalar> Air<S> {
    pub(super) fn new(part: usize, cell: usize, lines: [Option<Line<S>>; 2]) -> Self {
        Self { part, cell, volume: S::from_f64(f64::NAN), lines, account: Account::empty() }
    }

    /// State and accounts as numbers.
    pub(super) fn save(&self, cells: &[Cell<S>]) -> [f64; SAVED] {
        let state = match cells[self.cell].content {
            Content::Sealed { state, .. } => [state.reference_pressure, state.mass],
            Content::Regulated(_) => [S::from_f64(f64::NAN); 2],
        };
        let Account { enthalpy_in, enthalpy_out, heat, work } = self.account;
        [state[0], state[1], enthalpy_in, enthalpy_out, heat, work].map(S::to_f64)
    }

    /// From [`Air::save`].
    pub(super) fn load(&mut self, numbers: &[f64], cells: &mut [Cell<S>]) {
        let numbers: Vec<S> = numbers.iter().map(|number| S::from_f64(*number)).collect();
        if let (Content::Sealed { state, .. }, &[pressure, mass, enthalpy_in, enthalpy_out, heat, work]) =
            (&mut cells[self.cell].content, numbers.as_slice())
        {
            (state.reference_pressure, state.mass) = (pressure, mass);
            self.account = Account { enthalpy_in, enthalpy_out, heat, work };
        }
    }

    /// Temperature (K), mass (kg) and heat taken up (J).
    pub(super) fn told(&self, cells: &[Cell<S>], volume: S) -> [f64; 3] {
        let Content::Sealed { chamber, state } = cells[self.cell].content else { return [f64::NAN; 3] };
        let temperature =
            chamber.inside(&state, volume).map_or(f64::NAN, |inside| inside.temperature.to_f64());
        [temperature, state.mass.to_f64(), self.account.heat.to_f64()]
    }
}
