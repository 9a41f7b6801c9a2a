//! Contacts of a world with parts that are not rigid: the parts that can touch, the pairs, and the memory of a step.
//!
//! In: an assembly, and the numbers of its ports and nodes. Out: things and pairs that the runtime's `World` steps,
//! either without splitting steps (Moreau 1988; impacts and lasting contacts are treated alike), or with touches
//! located in time and impact laws.

mod among;
mod made;
mod room;
mod rounded;

use super::books::{Books, Watch};
use super::engine::Event;
use super::pushed::Pushed;
use crate::contact_force::ContactForce;
use room::Room;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Method, State};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::contact::Mobility;
use smartbed_runtime::rigid::law::Kind as Impact;
use smartbed_runtime::rigid::narrow::CAPACITY;
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{
    Accounts, Carrier, Island, LocatedMemory, MeanMemory, Pair, Pressing, Thing, Touch, World, Yield,
};
use std::ops::Range;

/// An overlap below this share of the smaller part's size is attributed to rounding of the text's numbers.
const ROUNDING: f64 = 1e-6;

/// A place where two parts overlap.
pub(super) struct Overlap {
    /// Their numbers.
    pub(super) parts: [usize; 2],
    /// Depth (m).
    pub(super) depth: f64,
    /// Contact point in N (m).
    pub(super) point: Vec3<f64>,
}

/// Things, pairs and memory.
#[derive(Clone, Debug)]
pub(super) struct Touching<S = f64> {
    pub(super) things: Vec<Thing<S>>,
    pub(super) pairs: Vec<Pair<S>>,
    /// Parts of each pair.
    pub(super) parts: Vec<[usize; 2]>,
    /// By part: the thing that represents it in contacts.
    of_parts: Vec<Option<usize>>,
    /// By pair: the bodies of each of its parts in a contact: ports, then nodes.
    bodies: Vec<[Range<usize>; 2]>,
    /// By pair: whether each of its parts can move.
    moves: Vec<[bool; 2]>,
    /// By pair: was it in contact after the last step?
    active: Vec<bool>,
    /// Mean forces of the last step; those of located contacts at the present state, once a row or a picture asks.
    pub(super) forces: Vec<ContactForce>,
    /// The same by pair.
    pub(super) pushed: Pushed,
    room: Room<S>,
    located: Option<Located<S>>,
    /// Made when a step first asks for it.
    means: Option<Means<S>>,
}

/// The role of a part in contacts.
#[derive(Clone, Debug)]
pub(super) enum Touchable {
    /// A shape on a port, or fixed in space.
    Shape(Option<usize>, Frame<f64>),
    /// Nodes and facets.
    Mesh(Range<usize>, Range<usize>),
    /// It cannot be touched.
    Nothing,
}

/// Pairs with the parts of each, and which of them can move.
struct Pairs<S = f64> {
    pairs: Vec<Pair<S>>,
    parts: Vec<[usize; 2]>,
    moves: Vec<[bool; 2]>,
}

/// The kind of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum How {
    /// Ordinary: touches are located if the contacts' laws do so.
    Freely,
    /// With forces averaged over the step.
    Conserving,
    /// A relaxation: touches are not located, and overlapping parts are pushed apart.
    Relaxing,
}

/// Memory for steps with averaged forces.
#[derive(Clone, Debug)]
struct Means<S> {
    scratch: Vec<S>,
    nodes: [Vec<Vec3<S>>; 4],
    frames: [Vec<Frame<S>>; 2],
}

impl<S: Scalar> Means<S> {
    /// For so many numbers of the state, nodes and ports.
    fn new([n, points, ports]: [usize; 3]) -> Self {
        Means {
            scratch: vec![S::ZERO; MeanMemory::<S>::scratch(n)],
            nodes: [0; 4].map(|_| vec![[S::ZERO; 3]; points]),
            frames: [0; 2].map(|_| vec![Frame::inertial(); ports]),
        }
    }
}

/// Memory for steps with located touches.
#[derive(Clone, Debug)]
struct Located<S> {
    method: Method,
    /// Law of each pair.
    kinds: Vec<Impact>,
    scratch: Vec<S>,
    pressing: Vec<Pressing<S>>,
    struck: [Vec<Struck<S>>; 2],
    /// By pair: does it overlap, because a step used up its splits?
    overlaps: Vec<bool>,
    /// Whether the forces shown are those of the present state.
    pressed: bool,
}

/// Results of a step that are counted or reported.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stepped<S> {
    pub(super) accounts: Accounts<S>,
    /// Were impulses found to rounding?
    pub(super) settled: bool,
    /// Was the maximum number of splits reached?
    pub(super) forced: bool,
    /// How fast parts leave one another on the way to rest (m/s, rad/s).
    pub(super) leaving: S,
}

impl<S: Scalar> Touching<S> {
    /// For these things and pairs; laws are told of pairs whose touches are located.
    fn with(
        (things, of_parts): (Vec<Thing<S>>, Vec<Option<usize>>),
        Pairs { pairs, parts, moves }: Pairs<S>,
        located: Option<(Vec<Impact>, Method)>,
        size: [usize; 4],
    ) -> Self {
        let [ports, _, _, n] = size;
        let none: &[Mobility<S>] = &[];
        let room: usize = pairs.iter().flat_map(|pair| pair.things).map(|thing| room(&things[thing])).sum();
        let located = located.map(|(kinds, method)| Located {
            method,
            kinds,
            scratch: vec![S::ZERO; LocatedMemory::<S>::scratch(method, n)],
            pressing: vec![Pressing::empty(); room],
            struck: [0; 2].map(|_| vec![Struck::new(Touch::empty().contact, none); room]),
            overlaps: vec![false; pairs.len()],
            pressed: false,
        });
        let bodies = |thing: usize| match &things[thing] {
            Thing::Rigid { port: Some(port), .. } => *port..port + 1,
            Thing::Rigid { port: None, .. } => 0..0,
            Thing::Mesh { nodes: [first, end], .. } => ports + first..ports + end,
        };
        Touching {
            bodies: pairs.iter().map(|pair| pair.things.map(bodies)).collect(),
            active: vec![false; pairs.len()],
            forces: Vec::new(),
            pushed: Pushed::new(pairs.len()),
            parts,
            of_parts,
            moves,
            room: Room::new(size, [things.len(), room]),
            things,
            pairs,
            located,
            means: None,
        }
    }

    /// Chooses another method between touches, for a state of n values.
    pub(super) fn choose(&mut self, method: Method, n: usize) {
        if let Some(located) = &mut self.located {
            located.method = method;
            located.scratch = vec![S::ZERO; LocatedMemory::<S>::scratch(method, n)];
        }
    }

    /// What the next step needs to know of the pairs, for a checkpoint: forces, and which overlap.
    pub(in crate::world) fn save(&self) -> Vec<f64> {
        let overlaps = self.located.iter().flat_map(|own| &own.overlaps);
        self.pushed.values().iter().copied().chain(overlaps.map(|own| f64::from(u8::from(*own)))).collect()
    }

    /// Takes as many numbers as [`Touching::save`] gave: pairs that pressed go on as they are.
    pub(in crate::world) fn load(&mut self, numbers: &[f64]) {
        let (pushed, overlaps) = numbers.split_at(self.pushed.values().len());
        self.pushed.load(pushed);
        self.moved();
        self.active = (0..self.pairs.len()).map(|pair| self.pushed.presses(pair)).collect();
        let own = self.located.iter_mut().flat_map(|own| &mut own.overlaps);
        own.zip(overlaps).for_each(|(own, number)| *own = *number > 0.0);
    }

    /// Answers about ports that impulses ask for.
    pub(super) fn answers(&self) -> usize {
        self.room.sizes()[2]
    }

    /// Where parts of pairs, of which one can move, overlap at a state by more than rounding. The next step does not
    /// know of this.
    pub(super) fn overlaps(
        &self,
        island: Island<'_, S, impl Carrier<S>>,
        t: S,
        x: &[S],
    ) -> Result<Vec<Overlap>, Fault> {
        let mut room = self.room.clone();
        let mut memory = room.memory();
        World { island, things: &self.things, pairs: &self.pairs }.look(t, x, &mut memory)?;
        let size = |thing: usize| memory.extents[thing].diagonal().to_f64();
        let overlap = |touch: &Touch<S>| {
            let [a, b] = self.pairs[touch.pair].things.map(size);
            let depth = -touch.gap.to_f64();
            (self.moves[touch.pair].contains(&true) && depth > ROUNDING * a.min(b)).then_some(Overlap {
                parts: self.parts[touch.pair],
                depth,
                point: touch.point.map(S::to_f64),
            })
        };
        Ok(memory.contacts().iter().filter_map(overlap).collect())
    }

    /// Energy that each pair stores in overlaps at a state (J).
    pub(super) fn stored(
        &self,
        mut island: Island<'_, S, impl Carrier<S>>,
        t: S,
        x: &[S],
    ) -> Result<Vec<f64>, Fault> {
        let mut stored = vec![0.0; self.pairs.len()];
        if self.yields() {
            island.place(t, x)?;
            World { island, things: &self.things, pairs: &self.pairs }
                .each_yield(|point| stored[point.pair] += point.energy.to_f64());
        }
        Ok(stored)
    }

    /// Does any pair have a force law?
    fn yields(&self) -> bool {
        self.pairs.iter().any(|pair| pair.force.is_some())
    }

    /// Do all pairs?
    pub(super) fn only_yields(&self) -> bool {
        self.pairs.iter().all(|pair| pair.force.is_some())
    }

    /// Are touches located within its steps?
    pub(super) fn locates(&self) -> bool {
        self.located.is_some()
    }

    /// Contacts that were near in the last step.
    pub(super) fn near(&self) -> usize {
        self.room.counts[0]
    }

    /// Finds the forces of located contacts that rest at a state, before its next step of h, unless they are known.
    ///
    /// # Errors
    /// The step's, which it will have too.
    pub(super) fn press(
        &mut self,
        island: Island<'_, S, impl Carrier<S>>,
        (t, h): (S, S),
        state: &State<'_, S>,
    ) -> Result<(), Fault> {
        let has_force_laws = self.yields();
        let Some(own) = self.located.as_mut().filter(|own| !own.pressed) else { return Ok(()) };
        own.pressed = true;
        let [struck, lifts] = &mut own.struck;
        let mut memory = LocatedMemory {
            step: self.room.memory(),
            scratch: &mut own.scratch,
            pressing: &mut own.pressing,
            struck: [struck, lifts],
            overlaps: &mut own.overlaps,
            pressed: &mut self.active,
        };
        let mut world = World { island, things: &self.things, pairs: &self.pairs };
        let pressing = world.press_located((t, h), state, &mut memory)?;
        let mut yields = Vec::new();
        if has_force_laws {
            world.island.place(t, state.x())?;
            world.each_yield(|point| yields.push(*point));
        }
        self.show_pressing(pressing);
        for Yield { pair, contact, point, .. } in yields {
            self.pushed.add(pair, self.bodies[pair].each_ref(), &contact, contact.impulse);
            self.forces.extend(between(self.moves[pair], point, contact.axes, contact.impulse));
        }
        Ok(())
    }

    /// The state is another one than that whose forces are known.
    fn moved(&mut self) {
        self.located.iter_mut().for_each(|own| own.pressed = false);
    }

    /// Keeps the forces of so many lasting contacts for rows and pictures.
    fn show_pressing(&mut self, count: usize) {
        let pressing = self.located.iter().flat_map(|own| own.pressing.iter().take(count));
        self.pushed = Pushed::new(self.pairs.len());
        for own in pressing.clone() {
            let contact = &own.held.contact;
            self.pushed.add(own.pair, self.bodies[own.pair].each_ref(), contact, contact.impulse);
        }
        let force = |own: &Pressing<S>| {
            let contact = &own.held.contact;
            between(self.moves[own.pair], own.place, contact.axes, contact.impulse)
        };
        self.forces = pressing.filter_map(force).collect();
    }

    /// A step of an island; pairs that come into contact are events. Books, if there are some, observe it.
    pub(super) fn step(
        &mut self,
        island: Island<'_, S, impl Carrier<S>>,
        (t, h): (S, S),
        state: &mut State<'_, S>,
        how: How,
        (found, books): (&mut Vec<Event>, Option<&mut Books>),
    ) -> Result<Stepped<S>, Fault> {
        self.moved();
        let [ports, points, _, n] = self.room.sizes();
        let sizes = [n, points, ports];
        let mut memory = self.room.memory();
        let mut world = World { island, things: &self.things, pairs: &self.pairs };
        let mut watch = Watch { parts: &self.parts, bodies: &self.bodies, found: &mut *found, books };
        if let Some(own) = self.located.as_mut().filter(|_| how == How::Freely) {
            let [struck, lifts] = &mut own.struck;
            let mut memory = LocatedMemory {
                step: memory,
                scratch: &mut own.scratch,
                pressing: &mut own.pressing,
                struck: [struck, lifts],
                overlaps: &mut own.overlaps,
                pressed: &mut self.active,
            };
            let report =
                world.step_located(&own.kinds, own.method, (t, h), state, &mut memory, &mut watch)?;
            self.show_pressing(report.pressing);
            let (settled, forced) = (report.settled, report.forced);
            return Ok(Stepped { accounts: report.accounts, settled, forced, leaving: S::ZERO });
        }
        let done = match how {
            How::Relaxing => world.relax(t, h, state, &mut memory),
            How::Freely => {
                world.step_watched((t, h), state, &mut memory, &mut watch).map(|report| (report, S::ZERO))
            }
            How::Conserving => {
                let Means { scratch, nodes: [start, middle, change, velocity], frames: [from, seen] } =
                    self.means.get_or_insert_with(|| Means::new(sizes));
                let nodes = [&mut **start, middle, change, velocity];
                let mut means = MeanMemory { scratch, nodes, frames: [from, seen] };
                let done = world.step_conserving_watched((t, h), state, &mut memory, &mut means, &mut watch);
                done.map(|report| (report, S::ZERO))
            }
        };
        let (report, leaving) = done?;
        let counts = memory.counts;
        let contacts = memory.contacts();
        self.pushed = Pushed::new(self.pairs.len());
        let force = |touch: &Touch<S>| {
            let contact = &touch.contact;
            let force = contact.impulse.map(|impulse| impulse / h);
            self.pushed.add(touch.pair, self.bodies[touch.pair].each_ref(), contact, force);
            between(self.moves[touch.pair], touch.point, contact.axes, force)
        };
        self.forces = contacts.iter().filter_map(force).collect();
        for (pair, parts) in self.parts.iter().enumerate() {
            let impulses =
                contacts.iter().filter(|touch| touch.pair == pair).map(|t| t.contact.impulse[0].to_f64());
            let (points, impulse) =
                impulses.filter(|impulse| *impulse > 0.0).fold((0, 0.0), |(n, sum), own| (n + 1, sum + own));
            if points > 0 && !self.active[pair] {
                found.push(Event { time: h.to_f64(), parts: *parts, points, approach: f64::NAN, impulse });
            }
            self.active[pair] = points > 0;
        }
        self.room.counts = counts;
        Ok(Stepped { accounts: report.accounts, settled: report.settled, forced: false, leaving })
    }
}

/// A force as pictures show it.
fn between<S: Scalar>(
    moves: [bool; 2],
    point: Vec3<S>,
    axes: [Vec3<S>; 3],
    force: Vec3<S>,
) -> Option<ContactForce> {
    let wide = |x: Vec3<S>| x.map(S::to_f64);
    ContactForce::between(moves, wide(point), axes.map(wide), wide(force))
}

/// Contacts that a thing may have at once.
fn room<S>(thing: &Thing<S>) -> usize {
    match thing {
        Thing::Mesh { nodes, facets, .. } => nodes[1] - nodes[0] + facets[1] - facets[0] + CAPACITY,
        Thing::Rigid { .. } => CAPACITY,
    }
}
