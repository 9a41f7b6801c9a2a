//! Flow of gas, split from the motion of a world.
//!
//! In: sealed gas with supply or vent (`air`), and a function for a step of motion. Out: half a step of flow at
//! constant volume, a step of motion with the lines closed, half a step of flow (Strang splitting 1968, order 2). The
//! change of the gas's potential by flow counts as work of the drives.

use super::air::Air;
use super::{CarriedWorld, Place, words};
use smartbed_runtime::gas::{GasFault, Line};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::world::Content;

impl<S: Scalar> CarriedWorld<S> {
    /// A step with flow before and behind it; an error leaves everything as it was.
    pub(super) fn breathing(
        &mut self,
        h: f64,
        step: impl FnOnce(&mut Self) -> Result<(), String>,
    ) -> Result<(), String> {
        if self.airs.is_empty() {
            return step(self);
        }
        self.look().map_err(words)?;
        if self.airs.iter().all(Air::is_closed) {
            return step(self);
        }
        let before = (self.airs.clone(), self.fixed.cells.clone(), self.works.drive);
        let done = self.flow(0.5 * h).and_then(|()| {
            step(self)?;
            self.push().map_err(words)?;
            self.flow(0.5 * h)
        });
        if done.is_err() {
            (self.airs, self.fixed.cells, self.works.drive) = before;
        }
        done
    }

    /// Computes volumes that are not known yet.
    fn look(&mut self) -> Result<(), Fault> {
        if self.airs.iter().any(|air| !air.volume.is_finite()) {
            let volumes = self.volumes()?;
            for air in self.airs.iter_mut().filter(|air| !air.volume.is_finite()) {
                air.volume = volumes[air.cell];
            }
        }
        Ok(())
    }

    /// Volumes of all cells at the present state.
    fn volumes(&mut self) -> Result<Vec<S>, Fault> {
        let (t, x) = (S::from_f64(self.t), self.x.clone());
        self.with(|mut island| {
            island.place(t, &x)?;
            Ok(island.volumes().collect())
        })
    }

    /// Flow for h seconds at constant volumes.
    fn flow(&mut self, h: f64) -> Result<(), String> {
        for (number, air) in self.airs.iter_mut().enumerate() {
            let open: Vec<Line<S>> =
                air.lines.iter().flatten().filter(|line| line.opening > S::ZERO).copied().collect();
            let Content::Sealed { chamber, state } = &mut self.fixed.cells[air.cell].content else {
                continue;
            };
            if open.is_empty() {
                continue;
            }
            let fault = |fault: GasFault<S>| format!("`{}`: {}", self.names[air.part], gas_words(fault));
            let stored = chamber.potential(state, air.volume).map_err(fault)?;
            let (new, taken) = chamber.flow(state, air.volume, &open, S::from_f64(h)).map_err(fault)?;
            let gained = (chamber.potential(&new, air.volume).map_err(fault)? - stored).to_f64();
            self.works.drive += gained;
            if let Some(books) = &mut self.books {
                books.flows[number] += gained;
            }
            air.account = air.account.plus(S::ONE, &taken);
            *state = new;
        }
        Ok(())
    }

    /// Accounts for the work of moving walls on gas with lines, and updates its volumes.
    fn push(&mut self) -> Result<(), Fault> {
        let volumes = self.volumes()?;
        for air in self.airs.iter_mut().filter(|air| !air.is_closed()) {
            let (cell, volume) = (&self.fixed.cells[air.cell], volumes[air.cell]);
            if let Content::Sealed { chamber, state } = &cell.content {
                air.account = air.account.plus(S::ONE, &chamber.pushed(state, air.volume, volume));
            }
            air.volume = volume;
        }
        Ok(())
    }

    /// Marks the volumes as unknown, because the state was changed from outside.
    pub(super) fn forget_volumes(&mut self) {
        self.airs.iter_mut().for_each(|air| air.volume = S::from_f64(f64::NAN));
    }

    /// The gas that a part encloses.
    pub(super) fn air_of(&self, part: usize) -> Option<&Air<S>> {
        matches!(self.places[part], Place::Nodes(..))
            .then(|| self.airs.iter().find(|air| air.part == part))?
    }
}

/// What a gas cannot do, and what to do about it.
fn gas_words<S: Scalar>(fault: GasFault<S>) -> String {
    match fault {
        GasFault::Collapsed(volume) => {
            format!("its gas has no volume ({:.2e} m^3); take a smaller step", volume.to_f64())
        }
        GasFault::Empty(mass) => {
            format!(
                "more gas would flow out in a step than there is ({:.2e} kg is left); take a smaller step",
                mass.to_f64()
            )
        }
        GasFault::TooFast(times) => format!(
            "within a step its pressure could adapt to that of a line {:.0} times; take a smaller step, or less \
             conductance",
            times.to_f64()
        ),
    }
}
