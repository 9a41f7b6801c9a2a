//! Newton's method for a state, or for inputs, at which all accelerations vanish.
//!
//! In: rates of the state x = (independent q, independent u) and their Jacobians A, B at a state, from the derived
//! equations. Out: the state at which these rates vanish:
//! ```text
//! r = (u', q' of every coordinate that the rates depend on),   J dz = -r,   dz the solution of least norm
//! ```
//! in units of each unknown's own range. If the solutions form a line, steps of least norm lead to one near the start.
//! A step is cut to half a range, and to twice as much after every cut one that reduced r as a whole: inputs, speeds
//! and many coordinates have no range, and may end far from the start. It is halved as long as it does not reduce r or
//! cannot be assembled. `balance` says whether the end is a solution. Where it is none, or outside a range, the search
//! starts again elsewhere (`restart`).

use crate::configuration::Configurations;
use crate::engine::Engine;
use nalgebra::{DMatrix, DVector};
use smartbed_codegen::expr::rounding::Rounded;
use smartbed_codegen::id::Id;
use smartbed_codegen::model::Model;
use smartbed_codegen::{Interpreted, Program};

/// Most Newton steps.
const STEPS: usize = 100;
/// How far the first step may reach, in units of half the ranges.
const HALF_RANGE: f64 = 1.0;
/// Most halvings of one step.
const HALVINGS: usize = 40;
/// The search ends if every rate is below this fraction of its change over the ranges of the state.
const ROUNDING: f64 = f64::EPSILON;
/// Speeds (SI) below this are 0.
const STILL: f64 = 1e-9;

/// The unknowns of the search.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Unknown {
    /// Coordinates, and speeds if any is held.
    State,
    /// Inputs without a law.
    Inputs,
}

/// A coordinate or speed of the state.
pub(super) struct Entry {
    pub(super) name: String,
    /// Index in q or u.
    pub place: usize,
    pub(super) is_speed: bool,
    pub(super) is_held: bool,
    /// Half of its range; 1 for a speed.
    pub scale: f64,
    /// The range of a coordinate, and whether the model states it.
    pub range: (f64, f64),
    pub states_range: bool,
}

impl Entry {
    /// Is it a coordinate that is searched for?
    pub(super) fn is_free_coordinate(&self) -> bool {
        !self.is_speed && !self.is_held
    }
}

/// Coordinates, speeds and inputs.
pub(super) type Place = (Vec<f64>, Vec<f64>, Vec<f64>);

/// The largest rate, relative to its change over the ranges, with its name.
pub(super) type Rest = (String, f64);

/// In which directions of the unknowns nothing changes, so that a step has no part along them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Flat {
    /// Where slopes over the ranges are below 1e-9 of the largest. Steps along lines of equilibria stay small.
    Ranges,
    /// Where slopes are rounding, with rows and columns scaled: a soft spring behind a stiff one is not flat.
    Scaled,
}

/// Why a state is no equilibrium.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Fault {
    /// Something accelerates.
    Unbalanced,
    /// Rates vanish but forces do not: the speeds are not independent there. The worst pivot, relative to nominal.
    Dependent(f64),
    /// The equations are singular there: the worst pivot, relative to nominal.
    Singular(f64),
}

/// The end of a search.
pub(super) struct End {
    pub(super) rates: Rates,
    pub(super) rest: Rest,
    /// Why it is no equilibrium.
    pub(super) fault: Option<Fault>,
}

/// The search and its current state.
pub(super) struct Search<'p> {
    pub(super) program: &'p Program,
    pub(super) engine: Box<dyn Engine<f64>>,
    /// The same equations with bounds of their rounding.
    pub(super) rounded: Interpreted<Rounded>,
    pub(super) configurations: Configurations,
    pub(super) state: Vec<Entry>,
    /// The range of each of the q, and whether the model states it.
    pub(super) ranges: Vec<((f64, f64), bool)>,
    pub(super) q: Vec<f64>,
    pub(super) u: Vec<f64>,
    /// Speeds at the start: those of a steady motion are searched for from there, or kept.
    start_u: Vec<f64>,
    pub(super) inputs: Vec<f64>,
    pub(super) free_inputs: Vec<usize>,
    pub(super) has_laws: bool,
    pub(super) unknown: Unknown,
}

/// The linearised equations: x' = A dx + B dinputs.
#[derive(Clone, Debug)]
pub(super) struct Slopes {
    pub a: DMatrix<f64>,
    pub b: DMatrix<f64>,
    /// Directions in which the state can change, orthonormal columns: all of them but along Euler parameters.
    pub directions: DMatrix<f64>,
}

/// The equilibrium found.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub q: Vec<f64>,
    /// All speeds, dependent ones included.
    pub speeds: Vec<f64>,
    pub inputs: Vec<f64>,
    pub outputs: Vec<f64>,
    /// The largest remaining rate, with its name.
    pub left: (String, f64),
    pub slopes: Slopes,
    /// Bounds of the rounding errors of A.
    pub errors: DMatrix<f64>,
    pub is_motion: bool,
}

/// Rates and their Jacobians at a state.
pub(super) struct Rates {
    pub(super) x_dot: DVector<f64>,
    pub slopes: Slopes,
    /// The worst pivot, relative to nominal.
    pub pivot: f64,
    /// By rate and by entry of the state: does the rate depend on it, where the state moves?
    pub depends: DMatrix<bool>,
}

/// Half of a range; 1 if it has no width.
fn half((low, high): (f64, f64)) -> f64 {
    let half = 0.5 * (high - low);
    if half > 0.0 && half.is_finite() { half } else { 1.0 }
}

impl<'p> Search<'p> {
    pub fn new(model: &Model, program: &'p Program, engine: Box<dyn Engine<f64>>, start: &[f64]) -> Self {
        let configurations = Configurations::new(model, program);
        let n_q = program.q.len();
        let declared = |name: &str| model.coordinates.iter().find(|c| c.name == name);
        let range = |name: &str| declared(name).map_or((0.0, 0.0), |c| c.range);
        let states_range = |name: &str| declared(name).is_some_and(|c| c.states_range());
        let ranges = program.q.iter().map(|q| (range(&q.name), states_range(&q.name))).collect();
        let coordinates =
            program.q.iter().enumerate().filter(|(place, _)| configurations.is_independent(*place));
        let coordinates = coordinates.map(|(place, q)| Entry {
            name: q.name.clone(),
            place,
            is_speed: false,
            is_held: false,
            scale: half(range(&q.name)),
            range: range(&q.name),
            states_range: states_range(&q.name),
        });
        let speeds = program.u.iter().enumerate().map(|(place, u)| Entry {
            name: u.name.clone(),
            place,
            is_speed: true,
            is_held: true,
            scale: 1.0,
            range: (0.0, 0.0),
            states_range: false,
        });
        let state = coordinates.chain(speeds).collect();
        let lawful: Vec<usize> = model.laws.iter().map(|(input, _)| input.index()).collect();
        let free_inputs = (0..program.inputs.len()).filter(|i| !lawful.contains(i)).collect();
        let (q, u) = start.split_at(n_q);
        Self {
            program,
            engine,
            rounded: Interpreted::new(program),
            state,
            ranges,
            q: q.to_vec(),
            u: vec![0.0; u.len()],
            start_u: u.to_vec(),
            inputs: vec![0.0; program.inputs.len()],
            configurations,
            free_inputs,
            has_laws: !lawful.is_empty(),
            unknown: Unknown::State,
        }
    }

    /// Names of the state.
    pub fn state_names(&self) -> Vec<String> {
        self.state.iter().map(|entry| entry.name.clone()).collect()
    }

    pub fn is_free_input(&self, place: usize) -> bool {
        self.free_inputs.contains(&place)
    }

    /// Keeps an input at a value.
    pub fn hold_input(&mut self, place: usize, value: f64) {
        self.inputs[place] = value;
        self.free_inputs.retain(|free| *free != place);
    }

    /// Holds an entry of the state. Holding the first speed frees the speeds that are not held. False if there is no
    /// entry of that name.
    pub fn hold(&mut self, name: &str, value: f64) -> bool {
        let Some(found) = self.state.iter().position(|entry| entry.name == name) else { return false };
        if self.state[found].is_speed && !self.is_motion() {
            self.state.iter_mut().filter(|entry| entry.is_speed).for_each(|entry| entry.is_held = false);
            self.u.clone_from(&self.start_u);
        }
        let entry = &mut self.state[found];
        entry.is_held = true;
        let list = if entry.is_speed { &mut self.u } else { &mut self.q };
        list[entry.place] = value;
        true
    }

    /// Chooses the unknowns; a search for inputs keeps the speeds of the start.
    pub fn look_for(&mut self, unknown: Unknown) {
        self.unknown = unknown;
        if unknown == Unknown::Inputs {
            self.u.clone_from(&self.start_u);
        }
    }

    /// Can coordinates change although the independent speeds are 0 or balanced? If a constraint has a part without
    /// speeds, as a motor or the memory of a controller has, they can even at rest.
    pub(super) fn moves(&self) -> bool {
        self.is_motion() || self.program.drive.is_some()
    }

    /// Is a steady motion searched for? Then some speeds are free, or kept at other values than 0.
    pub(super) fn is_motion(&self) -> bool {
        self.state.iter().any(|entry| entry.is_speed && !entry.is_held) || self.u.iter().any(|u| *u != 0.0)
    }

    /// Half of the range of a coordinate, by its index in q.
    pub(super) fn half_range(&self, place: usize) -> f64 {
        half(self.ranges[place].0)
    }

    pub(super) fn place(&self) -> Place {
        (self.q.clone(), self.u.clone(), self.inputs.clone())
    }

    pub(super) fn return_to(&mut self, place: Place) {
        (self.q, self.u, self.inputs) = place;
    }

    /// Newton's method from here.
    pub(super) fn settle(&mut self, mut here: Rates) -> End {
        let mut rest = self.off_balance(&here);
        let mut reach = HALF_RANGE;
        for _ in 0..STEPS {
            if rest.1 <= ROUNDING && self.is_balanced(&here) {
                break;
            }
            let mut next = self.improved(&here, Flat::Ranges, (rest.1, &mut reach));
            if next.is_none() && !self.is_balanced(&here) {
                next = self.improved(&here, Flat::Scaled, (rest.1, &mut reach));
            }
            let Some(better) = next else { break };
            (here, rest) = better;
        }
        End { fault: self.fault(&here), rates: here, rest }
    }

    /// A step from here that reduces the rates below what they were before.
    fn improved(
        &mut self,
        here: &Rates,
        flat: Flat,
        (before, reach): (f64, &mut f64),
    ) -> Option<(Rates, Rest)> {
        let step = self.newton_step(here, flat)?;
        self.shortened(&step, before, reach)
    }

    /// The end of a search as the equilibrium here.
    pub(super) fn result(&mut self, end: End) -> Result<Found, String> {
        let End { rates: here, rest: (name, _), fault } = end;
        let value = self.rate_of(&here, &name);
        match fault {
            None => {}
            Some(Fault::Unbalanced) => return Err(self.not_found(&name, value)),
            Some(Fault::Dependent(pivot)) => return Err(self.dependent(pivot)),
            Some(Fault::Singular(pivot)) => return Err(self.singular(pivot)),
        }
        let speeds = self.engine.speeds(&self.q, &self.u).map_err(|fault| fault.reason().to_owned())?;
        let is_motion = self.is_motion() || speeds.iter().any(|u| u.abs() > STILL);
        Ok(Found {
            q: self.q.clone(),
            speeds,
            inputs: self.commanded()?,
            outputs: self
                .engine
                .outputs(0.0, &self.q, &self.u, &self.inputs)
                .map_err(|fault| fault.reason().to_owned())?,
            left: (name, value),
            errors: self.slope_errors(),
            slopes: here.slopes,
            is_motion,
        })
    }

    /// Solves for the dependent coordinates if coordinates are held at values other than their start.
    pub(super) fn assemble_held(&mut self) -> Result<(), String> {
        let held = self.state.iter().any(|entry| !entry.is_speed && entry.is_held);
        if !held {
            return Ok(());
        }
        let independent =
            self.q.iter().enumerate().map(|(i, q)| self.configurations.is_independent(i).then_some(*q));
        let parameters: Vec<f64> = self.program.parameters.iter().map(|p| p.value).collect();
        let solved = self.configurations.solve(&parameters, &independent.collect::<Vec<_>>());
        self.q =
            solved.map_err(|unreachable| format!("what --hold says cannot be assembled: {unreachable}"))?;
        Ok(())
    }

    /// Takes the step, or the part of it that reduces the rates, at most as long as the reach; says how far the next
    /// step may reach.
    fn shortened(&mut self, step: &DVector<f64>, before: f64, reach: &mut f64) -> Option<(Rates, Rest)> {
        let old = self.place();
        let mut part = (*reach / step.amax()).min(1.0);
        *reach *= if part < 1.0 { 2.0 } else { 1.0 };
        for _ in 0..HALVINGS {
            if self.go(&old, step, part)
                && let Ok(here) = self.rates()
            {
                let rest = self.off_balance(&here);
                if rest.1 < before {
                    return Some((here, rest));
                }
            }
            part *= 0.5;
            *reach = HALF_RANGE;
        }
        self.return_to(old);
        None
    }

    /// Takes a part of the step from the old state; false if it cannot be assembled.
    fn go(&mut self, old: &Place, step: &DVector<f64>, part: f64) -> bool {
        let (mut q, mut u, mut inputs) = old.clone();
        match self.unknown {
            Unknown::Inputs => {
                self.free_inputs.iter().zip(step).for_each(|(&place, d)| inputs[place] += part * d);
            }
            Unknown::State => {
                for (entry, d) in self.state.iter().filter(|entry| !entry.is_held).zip(step) {
                    let list = if entry.is_speed { &mut u } else { &mut q };
                    list[entry.place] += part * entry.scale * d;
                }
                match self.configurations.follow(0.0, &old.0, &q) {
                    Ok(assembled) => q = assembled,
                    Err(_) => return false,
                }
            }
        }
        (self.q, self.u, self.inputs) = (q, u, inputs);
        true
    }
}
