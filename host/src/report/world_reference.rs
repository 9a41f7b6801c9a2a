//! References of a world: DOP853 and, as a second opinion, DormandPrince, where its equations are smooth; else its own
//! step, halved.
//!
//! In: a world at its start, times of samples and a limit of time. Out: samples of its coordinates.

use super::clock::{self, Deadline, Stop};
use super::subject::{Time, Trace};
use super::world::{LOOK, World};
use crate::scene::dop853::Dop853;
use crate::world::carried::CarriedWorld;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::step_size::Tolerance;
use smartbed_runtime::ode::{DormandPrince, State, dormand_prince};

/// Most halvings of the reference's step.
const HALVINGS: u32 = 8;
impl World {
    /// Runs with the world's own step, halved as long as the next run fits into the time.
    pub(super) fn halved(&self, time: Time) -> Result<Trace, Stop> {
        let deadline = clock::now() + time.limit;
        let mut step = self.assembly.run.step.min(time.seconds / time.samples as f64);
        let mut best = self.trace(None, step, time)?;
        for _ in 0..HALVINGS {
            let left = deadline.saturating_sub(clock::now());
            // The next run takes twice as many steps, each with at most as many sweeps.
            if left < best.elapsed.mul_f64(2.5) {
                break;
            }
            match self.trace(None, 0.5 * step, Time { limit: left, ..time }) {
                Ok(finer) => (step, best) = (0.5 * step, finer),
                Err(Stop::Late { .. }) => break,
                Err(refused) => return Err(refused),
            }
        }
        self.finest.set(step);
        Ok(best)
    }

    pub(super) fn dop853(
        &self,
        world: &CarriedWorld,
        Time { seconds, samples: count, limit }: Time,
    ) -> Result<Trace, Stop> {
        let deadline = Deadline::within(limit);
        let (mut world, mut shown) = (world.clone(), world.clone());
        let mut fault = None;
        let begin = clock::now();
        let start = world.numbers().to_vec();
        let rates = |t: f64, x: &[f64], x_dot: &mut [f64]| match world.rates(t, x) {
            Ok(found) => x_dot.copy_from_slice(&found),
            Err(why) => {
                fault = Some(why);
                x_dot.fill(f64::NAN);
            }
        };
        let mut solver = Dop853::new(rates, 0.0, start, 1e-13, self.assembly.run.step);
        solver.longest = self.longest(&shown);
        let mut samples = Vec::new();
        for i in 1..=count {
            let end = seconds * i as f64 / count as f64;
            while solver.t < end {
                solver.advance(end).map_err(|t| format!("t = {t} s: no step of DOP853 was small enough"))?;
                deadline.check(solver.t)?;
            }
            shown.put(end, &solver.y)?;
            samples.push(self.sample(&mut shown)?);
        }
        let evaluations = Some(solver.evaluations as u64);
        Ok(Trace { samples, evaluations, elapsed: clock::now() - begin })
    }

    pub(super) fn dormand_prince(
        &self,
        world: &CarriedWorld,
        Time { seconds, samples: count, limit }: Time,
    ) -> Result<Trace, Stop> {
        let deadline = Deadline::within(limit);
        let mut world = world.clone();
        let mut x = world.numbers().to_vec();
        let mut low = vec![0.0; x.len()];
        let mut memory = vec![0.0; dormand_prince::scratch(x.len())];
        let tolerance = Tolerance { absolute: 1e-12, relative: 1e-12 };
        let words = |fault: Fault| fault.reason().to_owned();
        let mut adaptive =
            DormandPrince::new(x.len(), tolerance, self.assembly.run.step, &mut memory).map_err(words)?;
        let (mut t, mut samples, begin) = (0.0, Vec::new(), clock::now());
        let longest = self.longest(&world);
        for i in 1..=count {
            let end = seconds * i as f64 / count as f64;
            loop {
                let (before, to) = (t, end.min(t + longest));
                let done = world.with(|mut island| {
                    let mut state = State::resume(&mut x, &mut low)?;
                    adaptive.advance_to(&mut island, &mut t, to, LOOK as u32, &mut state)
                });
                match done {
                    Ok(_) if to < end => deadline.check(t)?,
                    Ok(_) => break,
                    // The limit of steps was reached, but time advanced.
                    Err(Fault::StepSize) if t > before => deadline.check(t)?,
                    Err(fault) => return Err(words(fault).into()),
                }
            }
            world.put(end, &x)?;
            samples.push(self.sample(&mut world)?);
        }
        Ok(Trace { samples, evaluations: None, elapsed: clock::now() - begin })
    }

    /// The longest step of a reference (s): where loads or commands depend on time, the scene's, so that it misses none.
    fn longest(&self, world: &CarriedWorld) -> f64 {
        if world.reads_time() { self.assembly.run.step } else { f64::INFINITY }
    }
}
