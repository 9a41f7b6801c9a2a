//! Gas of flexible parts that keeps its mass: what flows through its lines, what it takes on the way.
//!
//! In: sealed cells with their lines and openings, volumes. Out: their states around a step, accounts. Flow stands beside
//! motion: half a step of flow at the volume that is there, a step with the lines shut, half a step of flow (Strang 1968,
//! order 2). What flow changes of the gas' potential is given by whoever opens the line: work of the drives.

use super::{CarriedWorld, Place, words};
use smartbed_runtime::gas::{Account, GasFault, Line};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::world::{Cell, Content};

/// Gas that is told of at a part's name.
#[derive(Clone, Debug)]
pub(super) struct Air {
    /// The part that encloses it.
    pub(super) part: usize,
    cell: usize,
    /// Volume behind the last step (m^3).
    volume: f64,
    /// Supply and vent, as far as there are.
    pub(super) lines: [Option<Line<f64>>; 2],
    /// Enthalpy, heat and work since the start (J).
    pub(super) account: Account<f64>,
}

/// Numbers of an [`Air`] that a run goes on from.
pub(super) const SAVED: usize = 6;

impl Air {
    pub(super) fn new(part: usize, cell: usize, lines: [Option<Line<f64>>; 2]) -> Self {
        Self { part, cell, volume: f64::NAN, lines, account: Account::empty() }
    }

    /// State and accounts as numbers.
    pub(super) fn save(&self, cells: &[Cell<f64>]) -> [f64; SAVED] {
        let state = match cells[self.cell].content {
            Content::Sealed { state, .. } => [state.reference_pressure, state.mass],
            Content::Regulated(_) => [f64::NAN; 2],
        };
        let Account { enthalpy_in, enthalpy_out, heat, work } = self.account;
        [state[0], state[1], enthalpy_in, enthalpy_out, heat, work]
    }

    /// From [`Air::save`].
    pub(super) fn load(&mut self, numbers: &[f64], cells: &mut [Cell<f64>]) {
        if let (Content::Sealed { state, .. }, &[pressure, mass, enthalpy_in, enthalpy_out, heat, work]) =
            (&mut cells[self.cell].content, numbers)
        {
            (state.reference_pressure, state.mass) = (pressure, mass);
            self.account = Account { enthalpy_in, enthalpy_out, heat, work };
        }
    }

    /// Temperature (K), mass (kg) and heat taken up (J).
    pub(super) fn told(&self, cells: &[Cell<f64>], volume: f64) -> [f64; 3] {
        let Content::Sealed { chamber, state } = cells[self.cell].content else { return [f64::NAN; 3] };
        let temperature = chamber.inside(&state, volume).map_or(f64::NAN, |inside| inside.temperature);
        [temperature, state.mass, self.account.heat]
    }
}

impl CarriedWorld {
    /// A step with flow before and behind it; an error leaves everything as it was.
    pub(super) fn breathing(
        &mut self,
        h: f64,
        step: impl FnOnce(&mut Self) -> Result<(), String>,
    ) -> Result<(), String> {
        if self.airs.is_empty() {
            return step(self);
        }
        let before = (self.airs.clone(), self.fixed.cells.clone(), self.drive);
        let done = self.look().map_err(words).and_then(|()| {
            self.flow(0.5 * h)?;
            step(self)?;
            self.push().map_err(words)?;
            self.flow(0.5 * h)
        });
        if done.is_err() {
            (self.airs, self.fixed.cells, self.drive) = before;
        }
        done
    }

    /// Volumes that are not known yet.
    fn look(&mut self) -> Result<(), Fault> {
        if self.airs.iter().any(|air| air.volume.is_nan()) {
            let (t, x) = (self.t, self.x.clone());
            self.with(|mut island| island.place(t, &x))?;
            for air in &mut self.airs {
                air.volume = self.fixed.cells[air.cell].volume(&self.fixed.facets, &self.room.pos);
            }
        }
        Ok(())
    }

    /// Flow for h seconds, volumes at rest.
    fn flow(&mut self, h: f64) -> Result<(), String> {
        for air in &mut self.airs {
            let open: Vec<Line<f64>> =
                air.lines.iter().flatten().filter(|line| line.opening > 0.0).copied().collect();
            let Content::Sealed { chamber, state } = &mut self.fixed.cells[air.cell].content else {
                continue;
            };
            if open.is_empty() {
                continue;
            }
            let fault = |fault| format!("`{}`: {}", self.names[air.part], gas_words(fault));
            let stored = chamber.potential(state, air.volume).map_err(fault)?;
            let (new, taken) = chamber.flow(state, air.volume, &open, h).map_err(fault)?;
            self.drive += chamber.potential(&new, air.volume).map_err(fault)? - stored;
            air.account = air.account.plus(1.0, &taken);
            *state = new;
        }
        Ok(())
    }

    /// What gas took while its walls moved.
    fn push(&mut self) -> Result<(), Fault> {
        let (t, x) = (self.t, self.x.clone());
        self.with(|mut island| island.place(t, &x))?;
        for air in &mut self.airs {
            let cell = &self.fixed.cells[air.cell];
            let volume = cell.volume(&self.fixed.facets, &self.room.pos);
            if let Content::Sealed { chamber, state } = &cell.content {
                air.account = air.account.plus(1.0, &chamber.pushed(state, air.volume, volume));
            }
            air.volume = volume;
        }
        Ok(())
    }

    /// Volumes are looked for anew: the state is another.
    pub(super) fn forget_volumes(&mut self) {
        self.airs.iter_mut().for_each(|air| air.volume = f64::NAN);
    }

    /// The gas that a part encloses.
    pub(super) fn air_of(&self, part: usize) -> Option<&Air> {
        matches!(self.places[part], Place::Nodes(..))
            .then(|| self.airs.iter().find(|air| air.part == part))?
    }
}

/// What a gas cannot do, and what to do about it.
fn gas_words(fault: GasFault<f64>) -> String {
    match fault {
        GasFault::Collapsed(volume) => {
            format!("its gas has no volume ({volume:.2e} m^3); take a smaller step")
        }
        GasFault::Empty(mass) => {
            format!(
                "more gas flowed out in a step than was there ({mass:.2e} kg is left); take a smaller step"
            )
        }
        GasFault::TooFast(times) => format!(
            "its pressure meets that of a line {times:.0} times within a step; take a smaller step, or less conductance"
        ),
    }
}
