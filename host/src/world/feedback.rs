//! Sensors, and controllers that hold inputs: they observe a world between steps and act on it.
//!
//! In: an engine after whole steps, counted from the start. Out: readings; inputs held until the next step; values for
//! a checkpoint.

use super::assembly::Assembly;
use super::controllers::Controllers;
use super::engine::Engine;
use super::sensors::Probes;
use crate::failure::Failure;

/// Sensors and controllers of a world.
#[derive(Clone, Debug)]
pub struct Feedback {
    probes: Probes,
    controllers: Controllers,
}

impl Feedback {
    /// For an assembly moved by this engine in steps of the assembly's length.
    ///
    /// # Errors
    /// [`Failure::Found`] with the place if one of them reads or drives something that does not exist, or its times are
    /// not whole numbers of steps.
    pub fn new(assembly: &Assembly, engine: &dyn Engine) -> Result<Self, Failure> {
        // The columns of a row are many if there are nodes; they are needed only for sensors and controllers.
        let blind = assembly.sensors.is_empty() && assembly.controllers.is_empty();
        let columns = if blind { Vec::new() } else { engine.columns() };
        Ok(Self {
            probes: Probes::new(assembly, &columns)?,
            controllers: Controllers::new(assembly, &columns, &engine.inputs())?,
        })
    }

    /// Observes the world after step `n` (0: at the start) and sets the inputs.
    ///
    /// # Errors
    /// The engine's, or a reading that is not finite.
    pub fn look(&mut self, n: u64, engine: &mut dyn Engine) -> Result<(), String> {
        if self.probes.is_empty() && self.controllers.is_empty() {
            return Ok(());
        }
        let state = engine.state()?;
        self.probes.observe(n, &state);
        let readings = self.probes.readings(n);
        self.controllers.act(n, &state, &readings, engine)
    }

    /// Readings of the sensors after step `n`, in the scene's order.
    pub fn readings(&mut self, n: u64) -> Vec<f64> {
        self.probes.readings(n)
    }

    /// All values that a checkpoint needs.
    #[must_use]
    pub fn save(&self) -> Vec<f64> {
        let mut numbers = self.probes.save();
        numbers.extend(self.controllers.save());
        numbers
    }

    /// Restores the state of [`Feedback::save`]; the engine holds the inputs of that time.
    ///
    /// # Errors
    /// If the numbers are those of other sensors or controllers.
    pub fn load(&mut self, numbers: &[f64], engine: &mut dyn Engine) -> Result<(), String> {
        let mut numbers = numbers.iter().copied();
        let done = self.probes.load(&mut numbers).and_then(|()| self.controllers.load(&mut numbers, engine));
        done.filter(|()| numbers.next().is_none()).ok_or_else(|| {
            "the checkpoint belongs to another scene, with other sensors or controllers, whose memories it holds"
                .to_owned()
        })
    }
}
