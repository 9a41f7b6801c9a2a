//! Many steps of a sheet that nobody looks at in between.
//!
//! In: a simulation, how many steps. Out: the same so many steps further; the runtime keeps the numbers of a sheet that
//! nothing meets in rows over all of them, with the bits that they have one by one; one step at a time too by the
//! energy-momentum method.

use smartbed_runtime::flexible::BodyError;
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::scene::march;

use super::simulation::Simulation;

/// Steps of Verlet's method at once at least: fewer are faster one by one (`docs/performance.md`).
const FEWEST: usize = 6;
/// Steps at once at most: one that is refused is found after as many.
const AT_ONCE: usize = 256;

impl<S: Scalar> Simulation<S> {
    /// Whether [`Simulation::advance`] gains from more than one step: nobody then has anything to see between them.
    #[must_use]
    pub fn can_march(&self) -> bool {
        self.marcher.is_some()
    }

    /// Takes so many steps of length h.
    ///
    /// # Errors
    /// The step that is refused, from 0, and why; the state is then the last good one.
    pub fn advance(&mut self, h: S, steps: usize) -> Result<(), (usize, BodyError<S>)> {
        let mut taken = 0;
        while taken < steps {
            let count = (steps - taken).min(AT_ONCE);
            if count < self.fewest() || self.march(h, count).is_none() {
                for step in taken..taken + count {
                    self.step(h, &mut ()).map_err(|why| (step, why))?;
                }
            }
            taken += count;
        }
        Ok(())
    }

    /// Steps at once at least, so that they are not taken one by one.
    fn fewest(&self) -> usize {
        if self.method() == Method::EnergyMomentum { 1 } else { FEWEST }
    }

    /// Takes so many steps at once, or none; returns the evaluations of all forces.
    pub(super) fn march(&mut self, h: S, steps: usize) -> Option<usize> {
        let mut marcher = self.marcher.take()?;
        let taken = self.with(|system, state, work| {
            Ok(march(system, state, (h, steps), marcher.view(), work).then_some(work.evaluations))
        });
        self.marcher = Some(marcher);
        taken.ok().flatten()
    }
}
