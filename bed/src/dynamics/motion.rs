//! Integrates the motion, one stage after the other.
//!
//! In: a state at rest, and the tiles at the end of each stage. Out: the state there. Nodes, and six points of each
//! segment, are tracked in the bed's frame, so that a moving tile carries its sheet along.

use super::impact::Blow;
use super::ledger::Ledger;
use crate::body::Body;
use crate::equilibrium::alone::{self, Kept};
use crate::equilibrium::increment::{Increment, points};
use crate::equilibrium::scene::Scene;
use crate::equilibrium::swing::{Damper, Swing};
use crate::equilibrium::{Bed, Contact, Fault, GRAVITY, Rub, Solution, State, find, read};
use crate::method::{Formula, Method, Track};
use crate::pose::Pose;
use crate::sheet::Lattice;
use crate::tissue::{Layers, Memory, Tissue};
use smartbed_runtime::vec3::{Vec3, add, cross, dot, scale, sub};
use std::borrow::Cow;

/// A body counts as in equilibrium if the contacts miss its weight by less than this share.
const CARRIED: f64 = 1e-3;

/// Parameters that matter only in motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matter {
    /// Mass per area of a sheet (kg/m^2).
    pub density: f64,
    /// Retardation time of the sheets (s).
    pub sheet_loss: f64,
    /// Retardation time of the joints' rotational springs (s).
    pub joint_loss: f64,
    /// Viscoelasticity of the tissue.
    pub tissue: Tissue,
}

impl Default for Matter {
    fn default() -> Matter {
        // A loss factor of 0.13 at 1 Hz, the frequency at which loads swing; films have 0.1 to 0.3.
        Matter { density: 0.625, sheet_loss: 0.02, joint_loss: 0.05, tissue: Tissue::DEFAULT }
    }
}

/// What happens when a node of a sheet touches tissue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Impact {
    /// No impact: the tissue force at the end of the stage alone acts.
    Implicit,
    /// The approach ends at once, and its energy goes on along the sheet's springs: energy compensation.
    #[default]
    Compensation,
}

/// A bed and a body in motion.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Tiles at present.
    pub bed: Bed,
    /// What lies on them.
    pub body: Body,
    /// Positions and contact forces at present.
    pub now: Solution,
    /// Energy ledger.
    pub ledger: Ledger,
    /// Effects of impacts so far.
    pub blows: Blow,
    pub(super) matter: Matter,
    impact: Impact,
    method: Method,
    step: f64,
    stages: usize,
    /// Time (s) at which steps of this length began, number of stages since, and the length of the last stage (s).
    since: (f64, usize),
    pub(super) last: f64,
    /// A command of the drives begins or ends now, so that velocities or forces jump.
    jumps: bool,
    pub(super) nodes: Vec<Vec<Track>>,
    pub(super) segments: Vec<[Track; 6]>,
    pub(super) layers: Vec<Layers>,
    before: State,
    /// Factors of the stiffness of untouched sheets, kept for reuse.
    kept: Kept<f64>,
    /// The same in f32, with the lattice, if sheets are solved in f32.
    single: Option<(Lattice<f32>, Kept<f32>)>,
    /// For each spring: length (m), its rate (m/s), and the damper's force (N).
    pub(super) pulls: Vec<[f64; 3]>,
    /// Dissipated power of tissue and joints (W).
    powers: [f64; 2],
}

impl Motion {
    /// Starts at rest: in equilibrium with relaxed tissue, or released if nothing carries the body.
    #[must_use]
    pub fn new(bed: Bed, body: Body, state: State, matter: Matter, method: Method, step: f64) -> Motion {
        let of_tile = |(tile, sheet): (&crate::equilibrium::Tile, &Vec<Vec3<f64>>)| {
            sheet.iter().map(|x| Track::at_rest(tile.pose.outwards(*x), [0.0; 3])).collect()
        };
        let nodes = bed.tiles.iter().zip(&state.sheets).map(of_tile).collect();
        let now = read(&Scene::at_rest(&bed, &body), state.clone());
        let is_carried = now.imbalance < CARRIED;
        let falls = [0.0, 0.0, if is_carried { 0.0 } else { -GRAVITY }];
        let of_segment = |(segment, pose): (&crate::body::Segment, &Pose)| {
            points(segment, pose).map(|p| Track::at_rest(p, if segment.is_held() { [0.0; 3] } else { falls }))
        };
        let segments = body.segments.iter().zip(&state.segments).map(of_segment).collect();
        let rested = |c: &Contact| ((c.touch.node, c.touch.segment), matter.tissue.rested(c.touch.depth));
        let layers = now.contacts.iter().map(|own| own.iter().map(rested).collect()).collect();
        let mut motion = Motion {
            bed,
            body,
            now,
            ledger: Ledger::default(),
            blows: Blow::default(),
            matter,
            impact: Impact::default(),
            method,
            step,
            stages: 0,
            since: (0.0, 0),
            last: 0.0,
            jumps: false,
            nodes,
            segments,
            layers,
            before: state,
            kept: Kept::new(),
            single: None,
            pulls: Vec::new(),
            powers: [0.0; 2],
        };
        (motion.now.carried, motion.now.imbalance) = motion.balance();
        motion.pulls = motion.pulls();
        motion.weigh();
        motion.ledger.start = motion.ledger.energy();
        motion
    }

    /// Sets what happens at impacts.
    #[must_use]
    pub fn touching(self, impact: Impact) -> Motion {
        Motion { impact, ..self }
    }

    /// For an empty bed: sheets are solved in f32; sums over the steps stay in f64.
    #[must_use]
    pub fn in_f32(self) -> Motion {
        let lattice = self.bed.lattice.rounded();
        Motion { single: Some((lattice, Kept::new())), ..self }
    }

    /// Time since the start (s).
    #[must_use]
    pub fn time(&self) -> f64 {
        self.since.0 + (self.since.1 as f64 * self.step) / self.method.stages() as f64
    }

    /// Takes one step; `bed` gives the tiles at a time.
    ///
    /// # Errors
    /// [`Fault`].
    pub fn step(&mut self, bed: impl Fn(f64) -> Bed) -> Result<(), Fault> {
        if !std::mem::take(&mut self.jumps) {
            return self.stages_of(false, &bed);
        }
        // A stage of backward Euler dissipates m dv^2/2 of a body whose acceleration jumps; half a step dissipates a
        // quarter of it.
        let (whole, (begin, done)) = (self.step, self.since);
        for is_anew in [true, false] {
            (self.since, self.step) = ((self.time(), 0), 0.5 * whole);
            self.stages_of(is_anew, &bed)?;
        }
        (self.since, self.step) = ((begin, done + self.method.stages()), whole);
        Ok(())
    }

    /// All stages of a step; `is_anew` tells whether the first one starts without a past.
    fn stages_of(&mut self, is_anew: bool, bed: &impl Fn(f64) -> Bed) -> Result<(), Fault> {
        for stage in 0..self.method.stages() {
            let formula = self.method.formula(self.step, self.stages).behind(self.last);
            let formula = if is_anew && stage == 0 { formula.anew() } else { formula };
            self.stage(&formula, bed(self.time() + formula.seconds))?;
        }
        Ok(())
    }

    /// [`Self::step`] with another step length (s).
    ///
    /// # Errors
    /// [`Fault`].
    pub fn step_of(&mut self, seconds: f64, bed: impl Fn(f64) -> Bed) -> Result<(), Fault> {
        if seconds != self.step {
            (self.since, self.step) = ((self.time(), 0), seconds);
        }
        self.step(bed)
    }

    /// Announces that screws start or stop, or pressures jump, now: the next stage starts without a past.
    pub fn jump(&mut self) {
        self.jumps = true;
    }

    /// Largest speed of all points (m/s).
    #[must_use]
    pub fn fastest(&self) -> f64 {
        let all = self.nodes.iter().flatten().chain(self.segments.iter().flatten());
        all.map(|t| dot(t.velocity, t.velocity)).fold(0.0, f64::max).sqrt()
    }

    /// One stage.
    fn stage(&mut self, formula: &Formula, bed: Bed) -> Result<(), Fault> {
        if self.impact == Impact::Compensation && !self.body.segments.is_empty() {
            self.strike(formula, &bed);
        }
        let mut guess = self.guess(&bed);
        let mut single = self.single.take();
        let mut kept = std::mem::take(&mut self.kept);
        let increment = self.increment(formula, &bed);
        let scene = Scene::in_motion(&bed, &self.body, &increment);
        let next = if let Some((lattice, kept)) = &mut single {
            let (own, all) = alone::settle(&scene, lattice, &mut guess, kept, |s| Cow::Owned(s.rounded()));
            *kept = own;
            // A sheet that does not converge in f32 is solved in f64.
            if all { read(&scene, guess) } else { find(&scene, &guess)? }
        } else {
            (kept, _) = alone::settle(&scene, &bed.lattice, &mut guess, &kept, |s| Cow::Borrowed(s));
            find(&scene, &guess)?
        };
        drop(increment);
        (self.single, self.kept) = (single, kept);
        self.follow(formula, bed, next);
        Ok(())
    }

    /// The kinetic and dissipative terms that the stage adds to the energy.
    fn increment(&self, formula: &Formula, bed: &Bed) -> Increment<'_> {
        let lattice = &bed.lattice;
        let in_tile = |tile: usize, of: &dyn Fn(&Track) -> Vec3<f64>| -> Vec<Vec3<f64>> {
            let pose = &bed.tiles[tile].pose;
            self.nodes[tile].iter().map(|track| pose.inwards(of(track))).collect()
        };
        let dampers = |tile: usize| -> Vec<Damper> {
            let expected = in_tile(tile, &|t| t.onwards(formula));
            let resting = in_tile(tile, &|t| t.resting(formula));
            let ends = |ends: [usize; 2], places: &[Vec3<f64>]| ends.map(|end| places[end]);
            let one = |s: &crate::sheet::Spring| Damper::new(ends(s.ends, &expected), ends(s.ends, &resting));
            lattice.springs.iter().map(one).collect()
        };
        let sheet = |tile: usize| Swing {
            inertia: self.node_mass() * formula.rate * formula.rate,
            damping: self.matter.sheet_loss * formula.rate,
            nodes: in_tile(tile, &|t| t.expected(formula)),
            dampers: dampers(tile),
        };
        let resting = |(pose, tracks): (&Pose, &[Track; 6])| {
            pose.moved([0.0; 3], turn(&tracks.map(|t| t.place), &tracks.map(|t| t.resting(formula))))
        };
        let memory = |layers| Memory { tissue: self.matter.tissue, formula: *formula, layers };
        Increment {
            rate: formula.rate,
            joint_loss: self.matter.joint_loss,
            sheets: (0..bed.tiles.len()).map(sheet).collect(),
            segments: self.segments.iter().map(|s| s.map(|t| t.expected(formula))).collect(),
            resting: self.now.state.segments.iter().zip(&self.segments).map(resting).collect(),
            tissue: self.layers.iter().map(memory).collect(),
        }
    }

    pub(super) fn node_mass(&self) -> f64 {
        (self.matter.density + self.bed.cover.density) * self.bed.lattice.cell()
    }

    /// Extrapolation of the last stage, as a starting guess.
    fn guess(&self, bed: &Bed) -> State {
        let (now, before) = (&self.now.state, &self.before);
        let mut guess = now.clone();
        for (guess, before) in guess.sheets.iter_mut().zip(&before.sheets) {
            guess.iter_mut().zip(before).for_each(|(x, old)| *x = sub(scale(*x, 2.0), *old));
        }
        for (index, pose) in guess.segments.iter_mut().enumerate() {
            let tracks = &self.segments[index];
            let old = tracks.map(|t| sub(t.place, t.change[0]));
            let way = sub(pose.place, before.segments[index].place);
            *pose = pose.moved(way, turn(&old, &tracks.map(|t| t.place)));
        }
        debug_assert_eq!(guess.sheets.len(), bed.tiles.len());
        guess
    }

    /// Takes over the end of a stage as the present state, and updates the ledger.
    fn follow(&mut self, formula: &Formula, bed: Bed, next: Solution) {
        self.ledger.lost_by_friction += self.slipped(&next, &bed);
        self.ledger.turned += self.turned(&next, &bed);
        let given = self.regulated(&bed, &next.state);
        let tiles = 0..bed.tiles.len();
        let begun: f64 =
            tiles.clone().map(|t| self.moved(t, &bed, (&self.bed, &self.now), |rub| rub.force)).sum();
        self.layers = self.remembered(formula, &next);
        for (tile, tracks) in self.nodes.iter_mut().enumerate() {
            let pose = &bed.tiles[tile].pose;
            let places = &next.state.sheets[tile];
            tracks.iter_mut().zip(places).for_each(|(t, x)| *t = t.after(formula, pose.outwards(*x)));
        }
        let bodies = self.segments.iter_mut().zip(&self.body.segments).zip(&next.state.segments);
        for ((tracks, segment), pose) in bodies {
            let places = points(segment, pose);
            tracks.iter_mut().zip(places).for_each(|(t, x)| *t = t.after(formula, x));
        }
        let drag = |rub: &Rub| rub.drag(&bed, &next.state.sheets);
        let ended: f64 = tiles.map(|t| self.moved(t, &bed, (&bed, &next), drag)).sum();
        self.before = std::mem::replace(&mut self.now, next).state;
        self.bed = bed;
        self.stages += 1;
        self.since.1 += 1;
        self.last = formula.seconds;
        (self.now.carried, self.now.imbalance) = self.balance();
        let pulls = self.pulls();
        self.ledger.lost_in_sheets += self.damped(formula, &pulls) + self.snatched(formula);
        self.pulls = pulls;
        let powers = [self.power_of_tissue(), self.power_of_joints()];
        let [old, new] = formula.means();
        let [tissue, joints] = [0, 1].map(|k| formula.seconds * (new * powers[k] + old * self.powers[k]));
        self.powers = powers;
        self.ledger.lost_in_tissue += tissue;
        self.ledger.lost_in_joints += joints;
        self.ledger.driven += old * begun + new * ended + given;
        if formula.is_anew {
            // Dampers give a sheet the rim's new velocity almost at once, so it is counted as present from the start.
            let lasting = self.lasting(formula.seconds);
            for track in self.nodes.iter_mut().flatten() {
                track.change[1] = scale(track.change[1], lasting);
                track.acceleration = scale(track.acceleration, lasting);
            }
        }
        self.weigh();
    }

    /// Layers of tissue at the end of a stage; fully recovered ones are removed.
    fn remembered(&self, formula: &Formula, next: &Solution) -> Vec<Layers> {
        let tissue = &self.matter.tissue;
        let of_tile = |(old, contacts): (&Layers, &Vec<Contact>)| {
            let mut depths: std::collections::BTreeMap<(usize, usize), f64> =
                old.keys().map(|key| (*key, 0.0)).collect();
            depths.extend(contacts.iter().map(|c| ((c.touch.node, c.touch.segment), c.touch.depth)));
            let after = |(key, depth): ((usize, usize), f64)| {
                let layer = old.get(&key).copied().unwrap_or_default();
                (key, tissue.after(&layer, formula, depth))
            };
            let kept = |(_, layer): &(_, crate::tissue::Layer)| layer.depth.value > 1e-9;
            depths.into_iter().map(after).filter(kept).collect()
        };
        self.layers.iter().zip(&next.contacts).map(of_tile).collect()
    }

    /// The force that contacts must carry, sum m (a - g) of the free segments (N), and the relative error of the
    /// contacts, as a share of the weight.
    fn balance(&self) -> (f64, f64) {
        let weight = Bed::weight(&self.body);
        let is_free = |segment: usize| self.body.segments[segment].free[2];
        let contacts = self.now.contacts.iter().flatten().filter(|c| is_free(c.touch.segment));
        let up: f64 = contacts.map(|c| c.force()[2]).sum();
        let needed = |(index, tracks): (usize, &[Track; 6])| {
            let mass = if is_free(index) { self.body.segments[index].mass } else { 0.0 };
            mass * (GRAVITY + tracks.iter().map(|t| t.acceleration[2]).sum::<f64>() / 6.0)
        };
        let needed: f64 = self.segments.iter().enumerate().map(needed).sum();
        (needed, if weight > 0.0 { (up - needed).abs() / weight } else { 0.0 })
    }
}

/// Rotation vector (rad, to first order) that takes six points to six others: sum e_i x (t x e_i) = 2 t.
fn turn(from: &[Vec3<f64>; 6], to: &[Vec3<f64>; 6]) -> Vec3<f64> {
    let one = |axis: usize| {
        let [old, new] = [from, to].map(|p| sub(p[2 * axis], p[2 * axis + 1]));
        scale(cross(old, sub(new, old)), 0.5 / dot(old, old))
    };
    add(add(one(0), one(1)), one(2))
}

/// Angular velocity (rad/s) of a segment, from its six points.
pub(super) fn spin(tracks: &[Track; 6]) -> Vec3<f64> {
    let one = |axis: usize| {
        let [a, b] = [&tracks[2 * axis], &tracks[2 * axis + 1]];
        let arm = sub(a.place, b.place);
        scale(cross(arm, sub(a.velocity, b.velocity)), 0.5 / dot(arm, arm))
    };
    add(add(one(0), one(1)), one(2))
}
