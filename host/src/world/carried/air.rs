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
    /// Volume up to which work and heat are booked (m^3): that behind the last step or, if it has no lines, that at the
    /// start, because both depend on no other volume then; not a number where it is not known yet.
    pub(super) volume: S,
    /// Supply and vent, as far as there are.
    pub(super) lines: [Option<Line<S>>; 2],
    /// Enthalpy, heat and work since the start (J).
    pub(super) account: Account<S>,
}

/// Number of values of an [`Air`] in a checkpoint.
pub(super) const SAVED: usize = 7;

impl<S: Scalar> Air<S> {
    pub(super) fn new(part: usize, cell: usize, lines: [Option<Line<S>>; 2]) -> Self {
        Self { part, cell, volume: S::from_f64(f64::NAN), lines, account: Account::empty() }
    }

    /// Without supply and vent.
    pub(super) fn is_closed(&self) -> bool {
        self.lines.iter().all(Option::is_none)
    }

    /// State, accounts and volume as numbers; 0 for a volume that is not known.
    pub(super) fn save(&self, cells: &[Cell<S>]) -> [f64; SAVED] {
        let state = match cells[self.cell].content {
            Content::Sealed { state, .. } => [state.reference_pressure, state.mass],
            Content::Regulated(_) => [S::from_f64(f64::NAN); 2],
        };
        let Account { enthalpy_in, enthalpy_out, heat, work } = self.account;
        let volume = if self.volume.is_finite() { self.volume } else { S::ZERO };
        [state[0], state[1], enthalpy_in, enthalpy_out, heat, work, volume].map(S::to_f64)
    }

    /// From [`Air::save`].
    pub(super) fn load(&mut self, numbers: &[f64], cells: &mut [Cell<S>]) {
        let numbers: Vec<S> = numbers.iter().map(|number| S::from_f64(*number)).collect();
        if let (
            Content::Sealed { state, .. },
            &[pressure, mass, enthalpy_in, enthalpy_out, heat, work, volume],
        ) = (&mut cells[self.cell].content, numbers.as_slice())
        {
            (state.reference_pressure, state.mass) = (pressure, mass);
            self.account = Account { enthalpy_in, enthalpy_out, heat, work };
            self.volume = if volume > S::ZERO { volume } else { S::from_f64(f64::NAN) };
        }
    }

    /// Temperature (K), mass (kg) and heat taken up (J) at the present volume (m^3).
    pub(super) fn told(&self, cells: &[Cell<S>], volume: S) -> [f64; 3] {
        let Content::Sealed { chamber, state } = cells[self.cell].content else { return [f64::NAN; 3] };
        let temperature =
            chamber.inside(&state, volume).map_or(f64::NAN, |inside| inside.temperature.to_f64());
        // Nothing has been booked before the first step.
        let from = if self.volume.is_finite() { self.volume } else { volume };
        let heat = self.account.heat + chamber.pushed(&state, from, volume).heat;
        [temperature, state.mass.to_f64(), heat.to_f64()]
    }
}
