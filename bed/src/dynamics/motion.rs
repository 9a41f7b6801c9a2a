//! One stage after the other.
//!
//! In: a state at rest, and the bed as it stands at the end of each stage. Out: the state there. Nodes and six points of each
//! segment are followed in the bed's frame, so that a tile that moves takes its sheet along.

use super::ledger::Ledger;
use crate::body::Body;
use crate::equilibrium::alone::{self, Kept};
use crate::equilibrium::increment::{Increment, points};
use crate::equilibrium::scene::Scene;
use crate::equilibrium::swing::{Damper, Swing};
use crate::equilibrium::{Anchor, Bed, Contact, Fault, GRAVITY, Rub, Solution, State, Tile, find, read};
use crate::method::{Formula, Method, Track};
use crate::pose::Pose;
use crate::sheet::{Lattice, membrane};
use crate::tissue::{Layers, Memory, Tissue};
use smartbed_runtime::vec3::{Vec3, add, cross, dot, scale, sub, tangential};
use std::borrow::Cow;

/// A body is in equilibrium where contacts miss its weight by less than this share.
const CARRIED: f64 = 1e-3;

/// What matters in motion alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matter {
    /// Mass of a sheet per area (kg/m^2).
    pub density: f64,
    /// Retardation of the sheets (s).
    pub sheet_loss: f64,
    /// Retardation of what turns joints back (s).
    pub joint_loss: f64,
    /// Tissue.
    pub tissue: Tissue,
}

impl Default for Matter {
    fn default() -> Matter {
        // A loss factor of 0.13 at 1 Hz, at which loads swing; films have 0.1 to 0.3.
        Matter { density: 0.625, sheet_loss: 0.02, joint_loss: 0.05, tissue: Tissue::DEFAULT }
    }
}

/// A bed and a body in motion.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Tiles as they stand.
    pub bed: Bed,
    /// What lies on them.
    pub body: Body,
    /// Where everything is, and what presses where.
    pub now: Solution,
    /// All energy.
    pub ledger: Ledger,
    matter: Matter,
    method: Method,
    step: f64,
    stages: usize,
    nodes: Vec<Vec<Track>>,
    segments: Vec<[Track; 6]>,
    layers: Vec<Layers>,
    before: State,
    /// Stiffnesses of sheets that nothing touches.
    kept: Kept<f64>,
    /// The same in f32, and the lattice, where sheets are brought to their ends in it.
    single: Option<(Lattice<f32>, Kept<f32>)>,
    /// Lost power of sheets, tissue and joints, and that of the drives (W).
    powers: [f64; 4],
}

impl Motion {
    /// From rest: in equilibrium, tissue relaxed, or let go where nothing carries the body.
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
            matter,
            method,
            step,
            stages: 0,
            nodes,
            segments,
            layers,
            before: state,
            kept: Kept::new(),
            single: None,
            powers: [0.0; 4],
        };
        (motion.now.carried, motion.now.imbalance) = motion.balance();
        motion.weigh();
        motion.ledger.start = motion.ledger.energy();
        motion
    }

    /// The same for an empty bed, whose sheets are brought to the ends of their stages in f32. What steps sum up stays f64.
    #[must_use]
    pub fn in_f32(self) -> Motion {
        let lattice = self.bed.lattice.rounded();
        Motion { single: Some((lattice, Kept::new())), ..self }
    }

    /// Seconds since the start.
    #[must_use]
    pub fn time(&self) -> f64 {
        (self.stages as f64 * self.step) / self.method.stages() as f64
    }

    /// A step; `bed` says how tiles stand at a time.
    ///
    /// # Errors
    /// [`Fault`].
    pub fn step(&mut self, bed: impl Fn(f64) -> Bed) -> Result<(), Fault> {
        for _ in 0..self.method.stages() {
            let formula = self.method.formula(self.step, self.stages);
            self.stage(&formula, bed(self.time() + formula.seconds))?;
        }
        Ok(())
    }

    /// Fastest of all points (m/s).
    #[must_use]
    pub fn fastest(&self) -> f64 {
        let all = self.nodes.iter().flatten().chain(self.segments.iter().flatten());
        all.map(|t| dot(t.velocity, t.velocity)).fold(0.0, f64::max).sqrt()
    }

    /// One stage.
    fn stage(&mut self, formula: &Formula, bed: Bed) -> Result<(), Fault> {
        let mut guess = self.guess(&bed);
        let mut single = self.single.take();
        let mut kept = std::mem::take(&mut self.kept);
        let increment = self.increment(formula, &bed);
        let scene = Scene::in_motion(&bed, &self.body, &increment);
        let next = if let Some((lattice, kept)) = &mut single {
            let (own, all) = alone::settle(&scene, lattice, &mut guess, kept, |s| Cow::Owned(s.rounded()));
            *kept = own;
            // What f32 does not bring to rest f64 does.
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

    /// What the stage adds to the energy.
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

    fn node_mass(&self) -> f64 {
        (self.matter.density + self.bed.cover.density) * self.bed.lattice.cell()
    }

    /// The state if all went on as in the stage before.
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

    /// Takes the end of a stage as the state of now.
    fn follow(&mut self, formula: &Formula, bed: Bed, next: Solution) {
        self.ledger.lost_by_friction += slipped(&self.now.state, &next, &bed);
        let given = regulated(&self.bed, &bed, &self.now.state, &next.state);
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
        let moved = (0..bed.tiles.len()).map(|tile| self.moved(tile, &bed, &next)).sum::<f64>();
        self.before = std::mem::replace(&mut self.now, next).state;
        self.bed = bed;
        self.stages += 1;
        (self.now.carried, self.now.imbalance) = self.balance();
        let powers =
            [self.power_of_sheets(), self.power_of_tissue(), self.power_of_joints(), moved / formula.seconds];
        let [sheets, tissue, joints, drives] =
            [0, 1, 2, 3].map(|k| 0.5 * formula.seconds * (powers[k] + self.powers[k]));
        self.powers = powers;
        self.ledger.lost_in_sheets += sheets;
        self.ledger.lost_in_tissue += tissue;
        self.ledger.lost_in_joints += joints;
        self.ledger.driven += drives + given;
        self.weigh();
    }

    /// Tissue's layers at the end of a stage; those that have come back are forgotten.
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

    /// What contacts must carry, sum m (a - g) of the segments that are free (N), and how far they are from it, of the weight.
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

    /// Energies of now.
    fn weigh(&mut self) {
        let (lattice, state) = (&self.bed.lattice, &self.now.state);
        let of_node = 0.5 * self.node_mass();
        let mut ledger = Ledger { kinetic: 0.0, sheets: 0.0, air: 0.0, tissue: 0.0, ..self.ledger };
        for (tile, sheet) in state.sheets.iter().enumerate() {
            let free = self.nodes[tile].iter().enumerate().filter(|(node, _)| lattice.free(*node).is_some());
            ledger.kinetic += free.map(|(_, t)| of_node * dot(t.velocity, t.velocity)).sum::<f64>();
            ledger.sheets += membrane::energy(lattice, sheet) + self.bed.plate_energy(sheet);
            ledger.sheets += self.bed.cover_energy(&self.bed.tiles[tile], sheet);
            // A bladder without air has ended the step before.
            ledger.air += self.bed.tiles[tile].air.energy(self.bed.volume(sheet)).unwrap_or(f64::NAN);
            ledger.tissue += state.anchors[tile].iter().flatten().map(Anchor::held).sum::<f64>();
            let pressed = self.layers[tile].iter();
            ledger.tissue +=
                pressed.map(|((_, s), layer)| self.layer(*s) * self.matter.tissue.energy(layer)).sum::<f64>();
        }
        ledger.sheets += state.rubs.iter().map(Rub::held).sum::<f64>();
        ledger.sheets += self.now.met.iter().map(|m| m.energy(&self.bed, &state.sheets)).sum::<f64>();
        for (segment, tracks) in self.body.segments.iter().zip(&self.segments) {
            ledger.kinetic +=
                tracks.iter().map(|t| segment.mass / 12.0 * dot(t.velocity, t.velocity)).sum::<f64>();
        }
        ledger.body = self.body.energy(&state.segments, GRAVITY);
        self.ledger = ledger;
    }

    /// Stiffness of a node's layer in a segment (N/m).
    fn layer(&self, segment: usize) -> f64 {
        self.body.segments[segment].foundation * self.bed.lattice.cell()
    }

    fn power_of_sheets(&self) -> f64 {
        let one = |(tracks, spring): (&Vec<Track>, &crate::sheet::Spring)| {
            let [a, b] = spring.ends.map(|end| &tracks[end]);
            let along = sub(b.place, a.place);
            let speed = dot(along, sub(b.velocity, a.velocity));
            self.matter.sheet_loss * spring.stiffness * speed * speed / dot(along, along)
        };
        let all =
            self.nodes.iter().flat_map(|tracks| self.bed.lattice.springs.iter().map(move |s| (tracks, s)));
        all.map(one).sum()
    }

    fn power_of_tissue(&self) -> f64 {
        let layers = self.layers.iter().flatten();
        layers.map(|((_, segment), layer)| self.layer(*segment) * self.matter.tissue.power(layer)).sum()
    }

    fn power_of_joints(&self) -> f64 {
        let spin = |s: usize| spin(&self.segments[s]);
        let one = |joint: &crate::body::Joint| {
            let [a, b] = joint.segments.map(spin);
            let relative = sub(b, a);
            self.matter.joint_loss * joint.turning * dot(relative, relative)
        };
        self.body.joints.iter().map(one).sum()
    }

    /// Work (J) of what moves a tile: its rim carries what contacts leave of the nodes' inertia.
    fn moved(&self, tile: usize, bed: &Bed, next: &Solution) -> f64 {
        let [old, new] = [&self.bed, bed].map(|bed| &bed.tiles[tile].pose);
        if old == new {
            return 0.0;
        }
        let way = |x: Vec3<f64>| sub(new.outwards(x), old.outwards(x));
        let inertia = self.nodes[tile].iter().zip(&next.state.sheets[tile]).enumerate();
        let inertia = inertia.filter(|(node, _)| bed.lattice.free(*node).is_some());
        let inertia: f64 = inertia.map(|(_, (t, x))| self.node_mass() * dot(t.acceleration, way(*x))).sum();
        let pressed = next.contacts[tile].iter();
        let sheet = &next.state.sheets[tile];
        let sheets = &next.state.sheets;
        let pushed = next.met.iter().map(|m| (&m.ends, scale(m.normal, m.force(bed, sheets))));
        let rubbed = self.now.state.rubs.iter().map(|rub| (&rub.ends, rub.drag(bed, sheets)));
        let met = pushed.chain(rubbed).map(|(ends, force)| {
            let own = ends.iter().filter(|end| end.0 == tile);
            own.map(|(_, node, share)| share * dot(force, way(sheet[*node]))).sum::<f64>()
        });
        let lifted = |tile: &Tile| bed.cover_energy(tile, sheet);
        let borne = lifted(&bed.tiles[tile]) - lifted(&self.bed.tiles[tile]);
        borne
            + inertia
            + met.sum::<f64>()
            + pressed.map(|c| dot(c.force(), way(sheet[c.touch.node]))).sum::<f64>()
    }
}

/// Rotation vector (rad, to first order) that takes six points to others: sum e_i x (t x e_i) = 2 t.
fn turn(from: &[Vec3<f64>; 6], to: &[Vec3<f64>; 6]) -> Vec3<f64> {
    let one = |axis: usize| {
        let [old, new] = [from, to].map(|p| sub(p[2 * axis], p[2 * axis + 1]));
        scale(cross(old, sub(new, old)), 0.5 / dot(old, old))
    };
    add(add(one(0), one(1)), one(2))
}

/// Angular velocity (rad/s) of six points.
fn spin(tracks: &[Track; 6]) -> Vec3<f64> {
    let one = |axis: usize| {
        let [a, b] = [&tracks[2 * axis], &tracks[2 * axis + 1]];
        let arm = sub(a.place, b.place);
        scale(cross(arm, sub(a.velocity, b.velocity)), 0.5 / dot(arm, arm))
    };
    add(add(one(0), one(1)), one(2))
}

/// Energy (J) that slip has taken: work of friction by the trapezoid rule, less what its springs hold more.
fn slipped(before: &State, next: &Solution, bed: &Bed) -> f64 {
    let mut lost: f64 = before.rubs.iter().map(|rub| rub.taken(bed, &next.state.sheets)).sum();
    lost -= next.state.rubs.iter().map(Rub::held).sum::<f64>();
    for (tile, old) in before.anchors.iter().enumerate() {
        for (node, anchor) in old.iter().enumerate() {
            let Some(anchor) = anchor else { continue };
            let pose = &next.state.segments[anchor.segment];
            let own = next.contacts[tile]
                .iter()
                .find(|c| c.touch.node == node && c.touch.segment == anchor.segment);
            lost += anchor.held();
            if let Some(contact) = own {
                let normal = pose.attitude.to_body(contact.touch.normal);
                let slid = tangential(sub(pose.inwards(contact.place), anchor.place), normal);
                let drag = pose.attitude.to_body(contact.drag);
                lost += 0.5 * dot(add(anchor.force, drag), slid);
            }
        }
        lost -= next.state.anchors[tile].iter().flatten().map(Anchor::held).sum::<f64>();
    }
    lost
}

/// Energy (J) that regulators give by changing pressures, at the mean of both volumes.
fn regulated(old: &Bed, new: &Bed, before: &State, after: &State) -> f64 {
    let mut given = 0.0;
    for (tile, (a, b)) in old.tiles.iter().zip(&new.tiles).enumerate() {
        if a.air != b.air {
            for state in [before, after] {
                let volume = old.volume(&state.sheets[tile]);
                let energy = |air: &crate::sheet::air::Air| air.energy(volume).unwrap_or(f64::NAN);
                given += 0.5 * (energy(&b.air) - energy(&a.air));
            }
        }
    }
    given
}
