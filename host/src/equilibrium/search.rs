//! Newton's method for a state, or for inputs, at which all accelerations vanish.
//!
//! In: rates of the state x = (independent q, independent u) and their Jacobians A, B at a state, from the derived
//! equations. Out: the state at which these rates vanish:
//! ```text
//! r = (u', q' of every coordinate that the rates depend on),   J dz = -r,   dz the solution of least norm
//! ```
//! in units of each unknown's own range. If the solutions form a line, steps of least norm lead to one near the start.
//! A step is halved as long as it does not reduce r or cannot be assembled. Where that ends without a solution, or
//! outside a range, the search starts again elsewhere (`restart`).

use crate::configuration::Configurations;
use crate::engine::Engine;
use nalgebra::{DMatrix, DVector};
use smartbed_codegen::Program;
use smartbed_codegen::id::Id;
use smartbed_codegen::model::Model;

/// Most Newton steps.
const STEPS: usize = 100;
/// Most halvings of one step.
const HALVINGS: usize = 40;
/// The search ends if every rate is below this fraction of its change over the ranges of the state.
const ROUNDING: f64 = f64::EPSILON;
/// If a rate stays above this fraction, the end is no equilibrium.
pub(super) const BALANCED: f64 = 1e-9;
/// Derivatives by a coordinate below this fraction of the largest are rounding: nothing depends on it.
pub(super) const NO_SLOPE: f64 = 1e-12;
/// Singular values below this fraction of the largest are zero: nothing changes along their directions.
const FLAT: f64 = 1e-9;

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
    name: String,
    /// Index in q or u.
    pub place: usize,
    is_speed: bool,
    is_held: bool,
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

/// Rates at the end of a search, and the largest of them with its name, relative to its change over the ranges.
pub(super) type End = (Rates, (String, f64));

/// The search and its current state.
pub(super) struct Search<'p> {
    pub(super) program: &'p Program,
    engine: Box<dyn Engine<f64>>,
    pub(super) configurations: Configurations,
    pub(super) state: Vec<Entry>,
    pub(super) q: Vec<f64>,
    u: Vec<f64>,
    inputs: Vec<f64>,
    free_inputs: Vec<usize>,
    has_laws: bool,
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
    pub is_motion: bool,
}

/// Rates and their Jacobians at a state.
pub(super) struct Rates {
    x_dot: DVector<f64>,
    pub slopes: Slopes,
}

impl<'p> Search<'p> {
    pub fn new(model: &Model, program: &'p Program, engine: Box<dyn Engine<f64>>, start: &[f64]) -> Self {
        let configurations = Configurations::new(model, program);
        let n_q = program.q.len();
        let declared = |name: &str| model.coordinates.iter().find(|c| c.name == name);
        let range = |name: &str| declared(name).map_or((0.0, 0.0), |c| c.range);
        let half = |(low, high): (f64, f64)| {
            let half = 0.5 * (high - low);
            if half > 0.0 && half.is_finite() { half } else { 1.0 }
        };
        let coordinates =
            program.q.iter().enumerate().filter(|(place, _)| configurations.is_independent(*place));
        let coordinates = coordinates.map(|(place, q)| Entry {
            name: q.name.clone(),
            place,
            is_speed: false,
            is_held: false,
            scale: half(range(&q.name)),
            range: range(&q.name),
            states_range: declared(&q.name).is_some_and(|c| c.states_range()),
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
            state,
            q: q.to_vec(),
            u: vec![0.0; u.len()],
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

    pub fn set_input(&mut self, place: usize, value: f64) {
        self.inputs[place] = value;
    }

    /// Holds an entry of the state. Holding the first speed frees the speeds that are not held. False if there is no
    /// entry of that name.
    pub fn hold(&mut self, name: &str, value: f64) -> bool {
        let Some(found) = self.state.iter().position(|entry| entry.name == name) else { return false };
        if self.state[found].is_speed && !self.is_motion() {
            self.state.iter_mut().filter(|entry| entry.is_speed).for_each(|entry| entry.is_held = false);
        }
        let entry = &mut self.state[found];
        entry.is_held = true;
        let list = if entry.is_speed { &mut self.u } else { &mut self.q };
        list[entry.place] = value;
        true
    }

    pub fn look_for(&mut self, unknown: Unknown) {
        self.unknown = unknown;
    }

    /// Is a steady motion searched for? Then some speeds are free; if no speed is held, all are 0.
    fn is_motion(&self) -> bool {
        self.state.iter().any(|entry| entry.is_speed && !entry.is_held) || self.u.iter().any(|u| *u != 0.0)
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
        for _ in 0..STEPS {
            if rest.1 <= ROUNDING {
                break;
            }
            let Some(step) = self.newton_step(&here) else { break };
            let Some((next, less)) = self.shortened(&step, rest.1) else { break };
            (here, rest) = (next, less);
        }
        (here, rest)
    }

    /// The end of a search as the equilibrium here.
    pub(super) fn result(&mut self, (here, (name, share)): End) -> Result<Found, String> {
        let value = self.rate_of(&here, &name);
        if share > BALANCED {
            return Err(self.not_found(&name, value));
        }
        Ok(Found {
            q: self.q.clone(),
            speeds: self.engine.speeds(&self.q, &self.u).map_err(|fault| fault.reason().to_owned())?,
            inputs: self.commanded()?,
            outputs: self
                .engine
                .outputs(0.0, &self.q, &self.u, &self.inputs)
                .map_err(|fault| fault.reason().to_owned())?,
            left: (name, value),
            slopes: here.slopes,
            is_motion: self.is_motion(),
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

    fn not_found(&self, name: &str, value: f64) -> String {
        let advice = match self.unknown {
            Unknown::State => {
                "give a start nearer to it by --set, hold inputs by --input, or let them balance it by --trim"
            }
            Unknown::Inputs if self.free_inputs.is_empty() => "the model has no input without a law",
            Unknown::Inputs => "its inputs cannot balance this state; give another by --set",
        };
        format!("no equilibrium was found: the rate of `{name}` stays {value:.3e}; {advice}")
    }

    /// Rates and slopes here, or why there are none.
    pub(super) fn rates(&mut self) -> Result<Rates, &'static str> {
        let (n_q, n_u) = (self.q.len(), self.u.len());
        let (mut q_dot, mut u_dot) = (vec![0.0; n_q], vec![0.0; n_u]);
        self.engine.set_time(0.0);
        (self.engine.rates(0.0, &self.q, &self.u, &self.inputs, &mut q_dot, &mut u_dot))
            .map_err(|fault| fault.reason())?;
        let near = self.near()?;
        let n = self.state.len();
        let (a, rest) = near.split_at(n * n);
        let b = &rest[..n * self.inputs.len()];
        let x_dot = self.state.iter().map(|e| if e.is_speed { u_dot[e.place] } else { q_dot[e.place] });
        let x_dot = DVector::from_iterator(n, x_dot);
        let slopes = Slopes {
            a: DMatrix::from_row_slice(n, n, a),
            b: DMatrix::from_row_slice(n, self.inputs.len(), b),
            directions: self.directions(),
        };
        if !x_dot.iter().all(|x| x.is_finite()) {
            return Err("the accelerations are not finite: the configuration is singular");
        }
        if !slopes.a.iter().chain(&slopes.b).all(|x| x.is_finite()) {
            return Err(
                "the slopes of the accelerations are not finite: a root of 0, or two points that coincide",
            );
        }
        Ok(Rates { x_dot, slopes })
    }

    /// The identity, without one column for each vector of unit length e: its columns are Householder's reflection of
    /// the axis nearest to e, without the reflected axis, which is along e.
    fn directions(&self) -> DMatrix<f64> {
        let n = self.state.len();
        let mut all = DMatrix::identity(n, n);
        let mut along = Vec::new();
        for vector in self.unit_vectors() {
            let mut normal = self.along(&vector);
            let nearest = normal.iamax();
            normal[nearest] += normal[nearest].signum();
            all -= &normal * normal.transpose() * (2.0 / normal.norm_squared());
            along.push(nearest);
        }
        along.sort_unstable();
        all.remove_columns_at(&along)
    }

    /// The vectors of unit length among the coordinates, as places in the state.
    fn unit_vectors(&self) -> Vec<Vec<usize>> {
        let entry = |place: &usize| self.state.iter().position(|e| !e.is_speed && e.place == *place);
        let vectors = self.configurations.unit_vectors().iter();
        vectors.filter_map(|places| places.iter().map(entry).collect()).collect()
    }

    /// The state in which these entries are as they are and all others 0.
    fn along(&self, entries: &[usize]) -> DVector<f64> {
        let value = |i: usize, _| if entries.contains(&i) { self.q[self.state[i].place] } else { 0.0 };
        DVector::from_fn(self.state.len(), value)
    }

    /// What the derived function gives here: the linearisation, and the inputs as the laws command them.
    fn near(&mut self) -> Result<Vec<f64>, &'static str> {
        self.engine.function(0, (0.0, &self.q, &self.u, &self.inputs, &[])).map_err(|fault| fault.reason())
    }

    /// The inputs, those with a law as it commands them.
    fn commanded(&mut self) -> Result<Vec<f64>, &'static str> {
        if !self.has_laws {
            return Ok(self.inputs.clone());
        }
        let near = self.near()?;
        Ok(near[near.len() - self.inputs.len()..].to_vec())
    }

    /// Rates that have to vanish: accelerations, and rates of coordinates on which anything depends.
    fn rows(&self, here: &Rates) -> Vec<usize> {
        let largest = here.slopes.a.amax();
        let matters = |j: usize| here.slopes.a.column(j).amax() > NO_SLOPE * largest;
        (0..self.state.len())
            .filter(|&i| self.state[i].is_speed || (self.is_motion() && matters(i)))
            .collect()
    }

    /// The Jacobian J: rows of the rates that have to vanish, columns of the unknowns, scaled.
    fn slopes_of_unknowns(&self, here: &Rates, rows: &[usize]) -> DMatrix<f64> {
        match self.unknown {
            Unknown::State => {
                let free: Vec<usize> = (0..self.state.len()).filter(|&j| !self.state[j].is_held).collect();
                let scales = free.iter().map(|&j| self.state[j].scale).collect::<Vec<_>>();
                let mut a = here.slopes.a.clone();
                // Across vectors of unit length only: along them nothing can change.
                for vector in
                    self.unit_vectors().iter().filter(|vector| vector.iter().all(|j| free.contains(j)))
                {
                    let e = self.along(vector);
                    a -= &a * &e * e.transpose();
                }
                DMatrix::from_fn(rows.len(), free.len(), |i, j| a[(rows[i], free[j])] * scales[j])
            }
            Unknown::Inputs => {
                let free = &self.free_inputs;
                DMatrix::from_fn(rows.len(), free.len(), |i, j| here.slopes.b[(rows[i], free[j])])
            }
        }
    }

    /// The largest rate relative to its change over the ranges of the whole state, with its name.
    fn off_balance(&self, here: &Rates) -> (String, f64) {
        let mut worst = (String::new(), 0.0);
        for i in self.rows(here) {
            let over_ranges: f64 =
                self.state.iter().enumerate().map(|(j, e)| (here.slopes.a[(i, j)] * e.scale).abs()).sum();
            let by_inputs: f64 = here.slopes.b.row(i).iter().map(|b| b.abs()).sum();
            let own = here.x_dot[i].abs();
            let share = own / (over_ranges + by_inputs + own).max(f64::MIN_POSITIVE);
            if share > worst.1 || worst.0.is_empty() {
                worst = (self.state[i].name.clone(), share);
            }
        }
        worst
    }

    fn rate_of(&self, here: &Rates, name: &str) -> f64 {
        self.state.iter().position(|entry| entry.name == name).map_or(0.0, |i| here.x_dot[i])
    }

    /// The step of least norm that makes the rates vanish to first order, each row scaled by its largest entry.
    fn newton_step(&self, here: &Rates) -> Option<DVector<f64>> {
        let rows = self.rows(here);
        let mut slopes = self.slopes_of_unknowns(here, &rows);
        let mut rest = DVector::from_iterator(rows.len(), rows.iter().map(|&i| -here.x_dot[i]));
        for i in 0..rows.len() {
            let size = slopes.row(i).amax();
            if size > 0.0 {
                slopes.row_mut(i).scale_mut(1.0 / size);
                rest[i] /= size;
            }
        }
        if slopes.ncols() == 0 {
            return None;
        }
        let svd = slopes.svd(true, true);
        svd.solve(&rest, FLAT * svd.singular_values.max()).ok()
    }

    /// Takes the step, or the part of it that reduces the rates.
    fn shortened(&mut self, step: &DVector<f64>, before: f64) -> Option<End> {
        let old = self.place();
        // At most half a range in one step.
        let mut part = 1.0 / step.amax().max(1.0);
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
