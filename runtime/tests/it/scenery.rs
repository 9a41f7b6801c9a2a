//! Worlds for tests: parts, nodes and touchable surfaces, assembled one by one and run step by step.

use crate::island::Platform;
use smartbed_runtime::flexible::{Body, Massless, PressureForm, Spring};
use smartbed_runtime::gas::{Gas, Regulated};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Method, Ode, State};
use smartbed_runtime::rigid::RigidBody;
use smartbed_runtime::rigid::contact::{Mobility, Twist};
use smartbed_runtime::rigid::law::Kind;
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::surface::{Cuboid, Frame, Shape, Sphere};
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{
    Accounts, Attachment, Carrier, Cell, Commanded, Content, Coupling, Extent, Floating, Group, Inertias,
    InverseInertia, Island, LocatedMemory, LocatedReport, MeanMemory, Memory, Pair, Place, Pressing,
    StepMemory, StepReport, Thing, Touch, World, Wrench,
};
use std::ops::Range;

pub const GRAVITY: Vec3<f64> = [0.0, 0.0, -9.81];

pub type Law = fn(f64, usize) -> Frame<f64>;

/// Carriers of the tests' worlds.
pub enum Part {
    Free(Floating<f64>),
    Driven(Commanded<Law>),
    Sprung(Platform),
}

macro_rules! each {
    ($own:expr, $part:ident => $call:expr) => {
        match $own {
            Part::Free($part) => $call,
            Part::Driven($part) => $call,
            Part::Sprung($part) => $call,
        }
    };
}

impl Carrier<f64> for Part {
    fn n_q(&self) -> usize {
        each!(self, part => part.n_q())
    }
    fn n_u(&self) -> usize {
        each!(self, part => part.n_u())
    }
    fn n_ports(&self) -> usize {
        each!(self, part => Carrier::<f64>::n_ports(part))
    }
    fn coupled(&self, port: usize) -> Range<usize> {
        each!(self, part => Carrier::<f64>::coupled(part, port))
    }
    fn inverse_inertia(
        &mut self,
        t: f64,
        q: &[f64],
        u: &[f64],
        ports: [usize; 2],
    ) -> Result<InverseInertia<f64>, Fault> {
        each!(self, part => part.inverse_inertia(t, q, u, ports))
    }
    fn powers(
        &mut self,
        t: f64,
        state: [&[f64]; 2],
        seams: (&[Frame<f64>], &[Wrench<f64>]),
        tell: &mut impl FnMut(usize, [f64; 2]),
    ) -> Result<(), Fault> {
        each!(self, part => part.powers(t, state, seams, tell))
    }
    fn drive_powers(
        &mut self,
        frames: &[Frame<f64>],
        wrenches: &[Wrench<f64>],
        tell: &mut impl FnMut(usize, f64),
    ) {
        each!(self, part => part.drive_powers(frames, wrenches, tell))
    }
    fn frames(&mut self, t: f64, q: &[f64], u: &[f64], frames: &mut [Frame<f64>]) -> Result<(), Fault> {
        each!(self, part => part.frames(t, q, u, frames))
    }
    fn rates(
        &mut self,
        t: f64,
        q: &[f64],
        u: &[f64],
        wrenches: &[Wrench<f64>],
        q_dot: &mut [f64],
        u_dot: &mut [f64],
    ) -> Result<f64, Fault> {
        each!(self, part => part.rates(t, q, u, wrenches, q_dot, u_dot))
    }
    fn mean_rates(
        &mut self,
        times: [f64; 2],
        q: [&[f64]; 3],
        u: [&[f64]; 3],
        wrenches: &[Wrench<f64>],
        q_dot: &mut [f64],
        u_dot: &mut [f64],
    ) -> Result<f64, Fault> {
        each!(self, part => part.mean_rates(times, q, u, wrenches, q_dot, u_dot))
    }
    fn energy(&mut self, t: f64, q: &[f64], u: &[f64]) -> Result<(f64, f64), Fault> {
        each!(self, part => part.energy(t, q, u))
    }
}

/// Parts of a world.
#[derive(Default)]
pub struct Scene {
    pub parts: Vec<Part>,
    pub q: Vec<f64>,
    pub u: Vec<f64>,
    pub mass: Vec<f64>,
    pub fixed: Vec<bool>,
    pub pos: Vec<Vec3<f64>>,
    pub vel: Vec<Vec3<f64>>,
    pub springs: Vec<Spring<f64>>,
    pub facets: Vec<[usize; 4]>,
    pub cells: Vec<Cell<f64>>,
    pub attachments: Vec<Attachment<f64>>,
    pub restrained: Vec<[usize; 2]>,
    pub things: Vec<Thing<f64>>,
    pub pairs: Vec<Pair<f64>>,
    pub gravity: Vec3<f64>,
    pub air_drag: f64,
    pub room: usize,
}

impl Scene {
    pub fn falling() -> Scene {
        Scene { gravity: GRAVITY, room: 64, ..Scene::default() }
    }

    /// Adds a thing; its number.
    pub fn thing(&mut self, thing: Thing<f64>) -> usize {
        self.things.push(thing);
        self.things.len() - 1
    }

    pub fn pair(&mut self, one: usize, other: usize, friction: f64, restitution: f64) {
        self.pairs.push(Pair::striking([one, other], restitution, friction));
    }

    /// The plane z = 0.
    pub fn floor(&mut self) -> usize {
        self.thing(Thing::Rigid { shape: Shape::HalfSpace, port: None, place: Place::same() })
    }

    /// A rigid body at rest or moving; its number as a thing.
    pub fn rigid(
        &mut self,
        shape: Shape<f64>,
        body: RigidBody<f64>,
        position: Vec3<f64>,
        velocity: Vec3<f64>,
    ) -> usize {
        let port = self.parts.len();
        self.parts.push(Part::Free(Floating { body, gravity: self.gravity }));
        self.q.extend(position);
        self.q.extend([1.0, 0.0, 0.0, 0.0]);
        self.u.extend(velocity);
        self.u.extend([0.0; 3]);
        self.thing(Thing::Rigid { shape, port: Some(port), place: Place::same() })
    }

    pub fn ball(&mut self, mass: f64, radius: f64, position: Vec3<f64>, velocity: Vec3<f64>) -> usize {
        let body = RigidBody { mass, inertia: [0.4 * mass * radius * radius; 3] };
        self.rigid(Shape::Sphere(Sphere { radius }), body, position, velocity)
    }

    pub fn cuboid(&mut self, mass: f64, half: Vec3<f64>, position: Vec3<f64>, velocity: Vec3<f64>) -> usize {
        let [x, y, z] = half.map(|h| h * h * mass / 3.0);
        let body = RigidBody { mass, inertia: [y + z, x + z, x + y] };
        self.rigid(Shape::Cuboid(Cuboid { half }), body, position, velocity)
    }

    pub fn node(&mut self, mass: f64, fixed: bool, pos: Vec3<f64>, vel: Vec3<f64>) -> usize {
        self.mass.push(mass);
        self.fixed.push(fixed);
        self.pos.push(pos);
        self.vel.push(vel);
        self.pos.len() - 1
    }

    /// A cube of eight nodes and all springs between them, faces outwards; its number as a thing.
    pub fn cube(
        &mut self,
        edge: f64,
        corner: Vec3<f64>,
        velocity: Vec3<f64>,
        stiffness: f64,
        damping: f64,
    ) -> usize {
        let (first, facet) = (self.pos.len(), self.facets.len());
        for k in 0..8 {
            let at: Vec3<f64> = std::array::from_fn(|i| corner[i] + if k >> i & 1 == 1 { edge } else { 0.0 });
            self.node(0.125, false, at, velocity);
        }
        for tail in 0..8 {
            for head in tail + 1..8 {
                let rest_length = vec3::norm(vec3::sub(self.pos[first + head], self.pos[first + tail]));
                self.springs.push(Spring {
                    tail: first + tail,
                    head: first + head,
                    stiffness,
                    damping,
                    rest_length,
                });
            }
        }
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        self.facets.extend(faces.map(|face| face.map(|k| first + k)));
        let (nodes, facets) = ([first, first + 8], [facet, facet + 6]);
        self.thing(Thing::Mesh { nodes, facets, depth: 0.3 * edge })
    }

    /// A sheet of `n` x `n` nodes at height 0 about the origin, its rim fixed or held by a port, with a base below that
    /// closes it; gas of constant pressure inside. Its number as a thing.
    pub fn bladder(&mut self, n: usize, width: f64, gauge: f64, port: Option<usize>) -> usize {
        let (first, facet, cell) = (self.pos.len(), self.facets.len(), width / (n - 1) as f64);
        let rim = |i: usize, j: usize| i == 0 || j == 0 || i == n - 1 || j == n - 1;
        for (j, i) in (0..n).flat_map(|j| (0..n).map(move |i| (j, i))) {
            let place = [cell * i as f64 - 0.5 * width, cell * j as f64 - 0.5 * width, 0.0];
            let held = rim(i, j);
            let mass = if held && port.is_some() { 0.0 } else { 2.5 * cell * cell };
            let node = self.node(mass, held, place, [0.0; 3]);
            if let Some(port) = port.filter(|_| held) {
                self.attachments.push(Attachment { node, port, place, push: [0.0; 3] });
            }
        }
        let at = |i: usize, j: usize| first + j * n + i;
        for (j, i) in (0..n).flat_map(|j| (0..n).map(move |i| (j, i))) {
            for (di, dj) in [(1, 0), (0, 1)] {
                if i + di < n && j + dj < n && !(rim(i, j) && rim(i + di, j + dj)) {
                    let (tail, head) = (at(i, j), at(i + di, j + dj));
                    let spring = Spring { tail, head, stiffness: 5000.0, damping: 1.0, rest_length: cell };
                    self.springs.push(spring);
                }
            }
            if i + 1 < n && j + 1 < n {
                self.facets.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
        let sheet = self.facets.len();
        // The base: from every edge of the rim to a node below the middle.
        let below = self.node(if port.is_some() { 0.0 } else { 1.0 }, true, [0.0, 0.0, -0.05], [0.0; 3]);
        if let Some(port) = port {
            self.attachments.push(Attachment { node: below, port, place: [0.0, 0.0, -0.05], push: [0.0; 3] });
        }
        for k in 0..n - 1 {
            for [a, b] in [
                [at(k, 0), at(k + 1, 0)],
                [at(n - 1, k), at(n - 1, k + 1)],
                [at(k + 1, n - 1), at(k, n - 1)],
                [at(0, k + 1), at(0, k)],
            ] {
                self.facets.push([b, a, below, below]);
            }
        }
        let content = Content::Regulated(Regulated { gas: Gas::air(), gauge, ambient: 101_325.0 });
        let facets = [facet, self.facets.len()];
        self.cells.push(Cell { facets, content, form: PressureForm::Exact, wall: None });
        self.thing(Thing::Mesh { nodes: [first, first + n * n], facets: [facet, sheet], depth: 0.05 })
    }

    /// A bladder of 7 x 7 nodes on a floating body that turns and moves, and a ball that flies into it.
    pub fn floating_bladder() -> Scene {
        let mut scene = Scene { room: 200, ..Scene::default() };
        scene.body([0.1, 0.0, 0.2, 0.01, 0.0, 0.02]);
        let sheet = scene.bladder(7, 0.4, 500.0, Some(0));
        for k in 0..scene.attachments.len() {
            let attachment = scene.attachments[k];
            scene.pos[attachment.node] = attachment.place;
        }
        // Towards an edge, so that attached nodes are met as well as free ones.
        let ball = scene.ball(1.5, 0.1, [0.12, 0.03, 0.15], [0.2, 0.0, -1.5]);
        scene.pair(sheet, ball, 0.4, 0.0);
        scene
    }

    /// A body without a shape and without weight at the origin: velocity, then angular momentum.
    pub fn body(&mut self, u: [f64; 6]) {
        let body = RigidBody { mass: 3.0, inertia: [0.04, 0.05, 0.07] };
        self.parts.push(Part::Free(Floating { body, gravity: [0.0; 3] }));
        self.q.extend([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
        self.u.extend(u);
    }

    /// By how much momentum and angular momentum move, of the sums of sizes; all parts float.
    pub fn drift(&self) -> Drift {
        let mass = |part: &Part| match part {
            Part::Free(floating) => floating.body.mass,
            _ => panic!("a part that does not float"),
        };
        let free = self.mass.iter().zip(&self.fixed).filter(|(_, held)| !**held).map(|(mass, _)| *mass);
        Drift {
            rigid: self.parts.iter().map(mass).collect(),
            free: free.collect(),
            first: None,
            moved: [0.0; 2],
        }
    }

    /// Puts the world together; its state after `act`.
    pub fn with<T>(
        &mut self,
        act: impl FnOnce(&mut World<'_, f64, Group<'_, Part>>, &mut State<'_, f64>, StepMemory<'_, f64>) -> T,
    ) -> (Vec<f64>, T) {
        let n = self.pos.len();
        let candidate = Body {
            mass: &self.mass,
            fixed: &self.fixed,
            inverse_mass: &[],
            springs: &self.springs,
            gravity: self.gravity,
            air_drag: self.air_drag,
            facets: &self.facets,
            inflation: None,
            massless: Massless::default(),
            grids: &[],
            patches: None,
        };
        let body = if n == 0 { Ok(Body::none()) } else { Body::new(candidate) };
        let group = Group { members: &mut self.parts };
        let ports = Carrier::<f64>::n_ports(&group);
        let answers_needed = Inertias::answers(&group);
        let (mut elastic, mut viscous) = (vec![[0.0; 3]; n], vec![[0.0; 3]; n]);
        let (mut frames, mut wrenches) = (vec![Frame::inertial(); ports], vec![Wrench::zero(); ports]);
        let (mut pos, mut vel) = (self.pos.clone(), self.vel.clone());
        let memory = Memory {
            pos: &mut pos,
            vel: &mut vel,
            elastic: &mut elastic,
            viscous: &mut viscous,
            frames: &mut frames,
            wrenches: &mut wrenches,
        };
        let island = Island::new(group, body.expect("a body"), &self.attachments, memory).expect("an island");
        let island =
            island.with_cells(&self.cells).expect("cells").with_restrained(&self.restrained).expect("ranges");
        let mut x = vec![0.0; island.n_x()];
        island.load(&self.q, &self.u, &mut x).expect("lengths");
        let mut world = World { island, things: &self.things, pairs: &self.pairs };
        let mut scratch = vec![0.0; StepMemory::<f64>::scratch(x.len())];
        let mut rows = [vec![Frame::inertial(); ports], vec![Frame::inertial(); ports]];
        let mut twists = [0; 3].map(|_| vec![Twist::zero(); ports + n]);
        let mut normals = vec![[0.0; 3]; n];
        let mut couplings = vec![Coupling::default(); ports];
        let mut answers = vec![[[0.0; 6]; 6]; answers_needed];
        let mut nodes = vec![0.0; n];
        let mut touches = [0; 2].map(|_| vec![Touch::empty(); self.room]);
        let mut extents = vec![Extent::everywhere(); self.things.len()];
        let [first, last] = &mut rows;
        let [a, b, c] = &mut twists;
        let [now, before] = &mut touches;
        let inertias = Inertias { couplings: &mut couplings, answers: &mut answers, nodes: &mut nodes };
        let memory = StepMemory {
            scratch: &mut scratch,
            frames: [first, last],
            twists: [a, b, c],
            normals: &mut normals,
            inertias,
            extents: &mut extents,
            touches: [now, before],
            counts: [0; 2],
        };
        let mut low = vec![0.0; x.len()];
        let mut state = State::new(&mut x, &mut low).expect("a state");
        let done = act(&mut world, &mut state, memory);
        (x, done)
    }

    /// Runs; `see(report, contacts, state)` after each step.
    pub fn run(
        &mut self,
        h: f64,
        steps: u32,
        mut see: impl FnMut(&StepReport<f64>, &[Touch<f64>], &[f64]),
    ) -> (Vec<f64>, f64, Accounts<f64>) {
        let (x, (imbalance, accounts)) = self.with(|world, state, mut memory| {
            let start = world.island.energy(0.0, state.x()).expect("energy").total();
            let (mut accounts, mut energy) = (Accounts::empty(), start);
            for step in 0..steps {
                let report = world.step(f64::from(step) * h, h, state, &mut memory).expect("a step");
                accounts = accounts.plus(&report.accounts);
                assert!(
                    report.accounts.impact + report.accounts.friction >= -1e-13 * (1.0 + start.abs()),
                    "{step}"
                );
                energy = world.island.energy(f64::from(step + 1) * h, state.x()).expect("energy").total();
                see(&report, memory.contacts(), state.x());
            }
            (energy - start + accounts.lost(), accounts)
        });
        (x, imbalance, accounts)
    }

    /// Runs with mean forces (energy-momentum); `see(report, contacts, state)` after each step.
    pub fn run_conserving(
        &mut self,
        (h, steps): (f64, u32),
        mut see: impl FnMut(&StepReport<f64>, &[Touch<f64>], &[f64]),
    ) -> (Vec<f64>, f64, Accounts<f64>) {
        let (points, ports) = (self.pos.len(), self.parts.iter().map(Carrier::n_ports).sum());
        let (x, (imbalance, accounts)) = self.with(|world, state, mut memory| {
            let mut scratch = vec![0.0; MeanMemory::<f64>::scratch(state.x().len())];
            let mut rows = [0; 4].map(|_| vec![[0.0; 3]; points]);
            let mut frames = [0; 2].map(|_| vec![Frame::inertial(); ports]);
            let ([a, b, c, d], [first, seen]) = (&mut rows, &mut frames);
            let mut means = MeanMemory { scratch: &mut scratch, nodes: [a, b, c, d], frames: [first, seen] };
            let start = world.island.energy(0.0, state.x()).expect("energy").total();
            let (mut accounts, mut energy) = (Accounts::empty(), start);
            for step in 0..steps {
                let t = f64::from(step) * h;
                let report = world.step_conserving(t, h, state, &mut memory, &mut means).expect("a step");
                accounts = accounts.plus(&report.accounts);
                energy = world.island.energy(t + h, state.x()).expect("energy").total();
                see(&report, memory.contacts(), state.x());
            }
            (energy - start + accounts.lost(), accounts)
        });
        (x, imbalance, accounts)
    }

    /// Runs with touches located, one law for all pairs; `see(report, contacts that press, state)` after each step.
    pub fn run_located(
        &mut self,
        kind: Kind,
        (h, steps): (f64, u32),
        mut see: impl FnMut(&LocatedReport<f64>, &[Pressing<f64>], &[f64]),
    ) -> (Vec<f64>, f64, Accounts<f64>) {
        let (room, kinds) = (self.room, vec![kind; self.pairs.len()]);
        let (x, (imbalance, accounts)) = self.with(|world, state, step| {
            let mut scratch = vec![0.0; LocatedMemory::<f64>::scratch(Method::Rk4, state.x().len())];
            let mut pressing = vec![Pressing::empty(); room];
            let none: &[Mobility<f64>] = &[];
            let mut struck = [0; 2].map(|_| vec![Struck::new(Touch::empty().contact, none); room]);
            let [one, other] = &mut struck;
            let mut memory = LocatedMemory {
                step,
                scratch: &mut scratch,
                pressing: &mut pressing,
                struck: [one, other],
                overlaps: &mut vec![false; kinds.len()],
                pressed: &mut vec![false; kinds.len()],
            };
            let start = world.island.energy(0.0, state.x()).expect("energy").total();
            let (mut accounts, mut energy) = (Accounts::empty(), start);
            for step in 0..steps {
                let t = f64::from(step) * h;
                let report = world
                    .step_located(&kinds, Method::Rk4, (t, h), state, &mut memory, &mut ())
                    .expect("a step");
                accounts = accounts.plus(&report.accounts);
                energy = world.island.energy(t + h, state.x()).expect("energy").total();
                see(&report, &memory.pressing[..report.pressing], state.x());
            }
            (energy - start + accounts.lost(), accounts)
        });
        (x, imbalance, accounts)
    }
}

/// Observes linear and angular momentum of the floating parts.
pub struct Drift {
    rigid: Vec<f64>,
    free: Vec<f64>,
    first: Option<[Vec3<f64>; 2]>,
    /// The most that they moved, of the sums of sizes.
    pub moved: [f64; 2],
}

impl Drift {
    /// Looks at a state.
    pub fn see(&mut self, x: &[f64]) {
        let row = |k: usize| [x[k], x[k + 1], x[k + 2]];
        let (mut sums, mut sizes) = ([[0.0; 3]; 2], [0.0; 2]);
        let mut count = |mass: f64, place: usize, speed: usize, spin: Vec3<f64>| {
            let p = vec3::scale(row(speed), mass);
            let turn = vec3::cross(row(place), p);
            sums = [vec3::add(sums[0], p), vec3::add(sums[1], vec3::add(turn, spin))];
            sizes = [sizes[0] + vec3::norm(p), sizes[1] + vec3::norm(turn) + vec3::norm(spin)];
        };
        let bodies = self.rigid.len();
        let speeds = 7 * bodies + 3 * self.free.len();
        for (number, mass) in self.rigid.iter().enumerate() {
            count(*mass, 7 * number, speeds + 6 * number, row(speeds + 6 * number + 3));
        }
        for (node, mass) in self.free.iter().enumerate() {
            count(*mass, 7 * bodies + 3 * node, speeds + 6 * bodies + 3 * node, [0.0; 3]);
        }
        let first = *self.first.get_or_insert(sums);
        for k in 0..2 {
            self.moved[k] = self.moved[k].max(vec3::norm(vec3::sub(sums[k], first[k])) / sizes[k]);
        }
    }
}
