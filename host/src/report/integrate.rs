//! Motions of a mechanism that the report compares: with each method, and its two references.
//!
//! In: a mechanism, a method with its step or tolerance, a span of time. Out: its coordinates at samples, and what they
//! cost. Steps are cut where commands, laws and loads switch, and a drive that changes its speed at once gives its
//! impulse there, as in a run.

use super::clock::{self, Deadline, Stop};
use super::cuts::Cuts;
use super::mechanism::Mechanism;
use super::point::Control;
use super::sheet_mechanism::Plant64;
use super::subject::{Time, Trace, parts};
use crate::engine::{self, EngineKind, EngineScalar, explain};
use crate::run::settings;
use crate::run::simulate::Plant;
use crate::scene::dop853::Dop853;
use crate::switches::rounding;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{DormandPrince, Ode, State, dormand_prince, step_size::Tolerance};

/// Steps between two checks of the clock: a check costs as much as a short step.
const LOOK: usize = 1024;

impl Mechanism {
    /// Where the motion is cut.
    fn cuts<S: EngineScalar>(
        &self,
        plant: &mut Plant<Box<dyn engine::Engine<S>>, S>,
        seconds: f64,
    ) -> Result<Cuts, Stop> {
        let found = Cuts::of(&mut plant.switches, seconds, self.settings.look);
        found.map_err(|fault| explain(fault).to_owned().into())
    }

    /// From now on adaptive steps hide no pulse, as those of a run do not.
    fn watch<S: EngineScalar>(&self, plant: &mut Plant<Box<dyn engine::Engine<S>>, S>) -> Result<(), Stop> {
        let watched = plant.watch(&self.observers, self.settings.seconds, self.settings.step);
        watched.map_err(|fault| explain(fault).to_owned().into())
    }

    /// The motion in steps that end at samples.
    pub(super) fn to_samples(
        &self,
        e: f64,
        Time { seconds, samples: count, limit }: Time,
    ) -> Result<Trace, Stop> {
        let deadline = Deadline::within(limit);
        let mut plant: Plant64 = self.plant(self.engine)?;
        self.watch(&mut plant)?;
        let cuts = self.cuts(&mut plant, seconds)?;
        let mut x = self.start.clone();
        let (n, n_q) = (x.len(), self.program.q.len());
        let (mut low, mut memory) = (vec![0.0; n], vec![0.0; dormand_prince::scratch(n)]);
        let refused = |fault| explain(fault).to_owned();
        let mut state = State::new(&mut x, &mut low).map_err(refused)?;
        let interval = seconds / count as f64;
        let (first, tolerance) = (self.settings.step.min(interval), Tolerance { absolute: e, relative: e });
        let begin = clock::now();
        let mut method = DormandPrince::new(n, tolerance, first, &mut memory).map_err(refused)?;
        let (mut t, mut samples) = (0.0, Vec::with_capacity(count));
        for i in 1..=count {
            for [start, end] in cuts.parts((i - 1) as f64 * interval, i as f64 * interval) {
                if start > t {
                    plant.pass([t, start], &mut state)?;
                    method.restart();
                    t = start;
                }
                loop {
                    let before = t;
                    match method.advance_to(&mut plant, &mut t, end, LOOK as u32, &mut state) {
                        Ok(_) => break,
                        // The limit of steps was reached, but time advanced.
                        Err(Fault::StepSize) if t > before => deadline.check(t)?,
                        Err(fault) => return Err(refused(fault).into()),
                    }
                }
            }
            samples.push(state.x()[..n_q].to_vec());
        }
        Ok(Trace { samples, evaluations: Some(plant.evaluations()), elapsed: clock::now() - begin })
    }

    /// The motion with a method, as a run takes it.
    pub(super) fn trace<S: EngineScalar>(
        &self,
        method: settings::Method,
        control: Control,
        time: Time,
    ) -> Result<Trace, Stop> {
        let deadline = Deadline::within(time.limit);
        let mut plant = self.plant::<S>(self.engine)?;
        if method.fixed().is_none() {
            self.watch(&mut plant)?;
        }
        let cuts = self.cuts(&mut plant, time.seconds)?;
        let mut x: Vec<S> = self.start.iter().map(|x| S::from_f64(*x)).collect();
        let (n, n_q) = (x.len(), self.program.q.len());
        let mut low = vec![S::ZERO; n];
        let mut state = State::new(&mut x, &mut low).map_err(|f| explain(f).to_owned())?;
        let mut samples = Vec::with_capacity(time.samples);
        let mut keep = |x: &[S]| samples.push(x[..n_q].iter().map(|x| x.to_f64()).collect());
        let interval = time.seconds / time.samples as f64;
        let refused = |fault| explain(fault).to_owned();
        let begin = clock::now();
        match (method.fixed(), control) {
            (Some(fixed), Control::Step(longest)) => {
                let steps = parts(interval, longest);
                let mut scratch = vec![S::ZERO; fixed.scratch(n)];
                let h = interval / steps as f64;
                let mut last = 0.0;
                for i in 0..time.samples * steps {
                    let [t, next] = [i, i + 1].map(|i| i as f64 * h);
                    for [start, end] in cuts.parts(t, next) {
                        if start > last {
                            plant.pass([last, start], &mut state)?;
                        }
                        last = start;
                        let part = if [start, end] == [t, next] { h } else { end - start };
                        if part > rounding::<S>(end) {
                            last = end;
                            let [start, part] = [start, part].map(S::from_f64);
                            fixed.step(&mut plant, start, part, &mut state, &mut scratch).map_err(refused)?;
                        }
                    }
                    if i % LOOK == 0 {
                        deadline.check(t)?;
                    }
                    if (i + 1) % steps == 0 {
                        keep(state.x());
                    }
                }
            }
            (None, Control::Tolerance(e)) => {
                let tolerance = Tolerance { absolute: S::from_f64(e), relative: S::from_f64(e) };
                let mut memory = vec![S::ZERO; dormand_prince::scratch(n)];
                let first = S::from_f64(self.settings.step);
                let mut method = DormandPrince::new(n, tolerance, first, &mut memory).map_err(refused)?;
                free((&mut method, &cuts), &mut plant, (time, &deadline), &mut state, keep)?;
            }
            _ => return Err("a fixed method needs a step, an adaptive one a tolerance".to_owned().into()),
        }
        Ok(Trace { samples, evaluations: Some(plant.evaluations()), elapsed: clock::now() - begin })
    }

    /// Without projections: at this tolerance the constraints remain satisfied up to rounding.
    pub(super) fn by_dop853(&self, Time { seconds, samples: count, limit }: Time) -> Result<Trace, Stop> {
        let deadline = Deadline::within(limit);
        // The solver holds the one whose rates it asks for; the other one passes kinks.
        let mut plant: Plant64 = self.plant(EngineKind::Interpreter)?;
        let mut passing: Plant64 = self.plant(EngineKind::Interpreter)?;
        let cuts = self.cuts(&mut passing, seconds)?;
        let begin = clock::now();
        let rates = |t: f64, x: &[f64], x_dot: &mut [f64]| {
            if plant.rates(t, x, x_dot).is_err() {
                x_dot.fill(f64::NAN);
            }
        };
        let mut solver = Dop853::new(rates, 0.0, self.start.clone(), 1e-13, self.settings.step);
        if self.model.is_driven() || self.model.reads_time() {
            solver.longest = self.settings.step;
        }
        let (mut samples, mut last) = (Vec::new(), 0.0);
        for i in 1..=count {
            let sample = seconds * i as f64 / count as f64;
            for [start, end] in cuts.parts(last, sample) {
                if start > solver.t {
                    let (mut x, mut low) = (solver.y.clone(), vec![0.0; solver.y.len()]);
                    let mut state = State::new(&mut x, &mut low).map_err(|f| explain(f).to_owned())?;
                    passing.pass([solver.t, start], &mut state)?;
                    solver.restart(start, x, self.settings.step);
                }
                while solver.t < end {
                    solver
                        .advance(end)
                        .map_err(|t| format!("t = {t} s: no step of DOP853 was small enough"))?;
                    deadline.check(solver.t)?;
                }
            }
            samples.push(solver.y[..self.program.q.len()].to_vec());
            last = sample;
        }
        let evaluations = Some(solver.evaluations as u64);
        Ok(Trace { samples, evaluations, elapsed: clock::now() - begin })
    }
}

/// Takes the steps that `run` takes, which passes over samples and interpolates there: at a kink of a force the error
/// depends on where steps end, and would be another one if they ended at samples.
fn free<S: EngineScalar>(
    (method, cuts): (&mut DormandPrince<'_, S>, &Cuts),
    plant: &mut Plant<Box<dyn engine::Engine<S>>, S>,
    (Time { seconds, samples, .. }, deadline): (Time, &Deadline),
    state: &mut State<'_, S>,
    mut keep: impl FnMut(&[S]),
) -> Result<(), Stop> {
    let refused = |fault| explain(fault).to_owned();
    let mut inside = vec![S::ZERO; state.x().len()];
    let (mut t, mut next, mut taken) = (0.0, 1, 0);
    let sample = |next: usize| if next == samples { seconds } else { seconds * next as f64 / samples as f64 };
    for [start, to] in cuts.parts(0.0, seconds) {
        if start > t {
            plant.pass([t, start], state)?;
            method.restart();
            t = start;
        }
        while to - t > rounding::<S>(to) {
            let left = to - t;
            let step = method.step(plant, S::from_f64(t), S::from_f64(left), state).map_err(refused)?;
            let h = step.h.to_f64();
            let end = if h >= left * (1.0 - f64::from(f32::EPSILON)) { to } else { t + h };
            while next <= samples && sample(next) < end {
                let at = sample(next).max(t);
                method.dense(S::from_f64((at - t) / h), &mut inside).map_err(refused)?;
                plant.set_time(S::from_f64(at));
                plant.project(&mut inside).map_err(refused)?;
                keep(&inside);
                next += 1;
            }
            if next <= samples && sample(next) == end {
                keep(state.x());
                next += 1;
            }
            t = end;
            if taken % LOOK == 0 {
                deadline.check(t)?;
            }
            taken += 1;
        }
    }
    // Samples in the rounding of the end.
    (next..=samples).for_each(|_| keep(state.x()));
    Ok(())
}
