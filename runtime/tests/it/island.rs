//! A flexible body on a carrier: momenta and energy of a floating pair, a platform against its own equations written
//! by hand, a commanded frame against a closed form and with its account of work.

use smartbed_runtime::flexible::{self, Body, Inflation, Massless, PressureForm, Spring};
use smartbed_runtime::gas::{Chamber, Gas, GasState};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Method, Ode, State};
use smartbed_runtime::rigid::RigidBody;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{
    Attachment, Carrier, Cell, Commanded, Content, Floating, Group, InverseInertia, Island, Memory, Wrench,
};

/// Data that a body borrows.
pub(crate) struct Lists {
    pub(crate) mass: Vec<f64>,
    fixed: Vec<bool>,
    springs: Vec<Spring<f64>>,
    pub(crate) facets: Vec<[usize; 4]>,
    pub(crate) inflation: Option<Inflation<f64>>,
    gravity: Vec3<f64>,
    pub(crate) attachments: Vec<Attachment<f64>>,
    pos: Vec<Vec3<f64>>,
    vel: Vec<Vec3<f64>>,
}

/// Memory of an island.
pub(crate) struct Rows([Vec<Vec3<f64>>; 2], [Frame<f64>; 1], [Wrench<f64>; 1]);

impl Lists {
    pub(crate) fn rows(&self) -> Rows {
        let zero = vec![[0.0; 3]; self.mass.len()];
        Rows([zero.clone(), zero], [Frame::inertial()], [Wrench::zero()])
    }

    pub(crate) fn island<'a, C: Carrier<f64>>(
        &'a mut self,
        carrier: C,
        Rows([elastic, viscous], frames, wrenches): &'a mut Rows,
    ) -> Island<'a, f64, C> {
        let body = Body::new(Body {
            mass: &self.mass,
            fixed: &self.fixed,
            inverse_mass: &[],
            springs: &self.springs,
            gravity: self.gravity,
            air_drag: 0.0,
            facets: &self.facets,
            inflation: self.inflation,
            massless: Massless::default(),
            grids: &[],
            patches: None,
        });
        let memory = Memory { pos: &mut self.pos, vel: &mut self.vel, elastic, viscous, frames, wrenches };
        Island::new(carrier, body.expect("a body"), &self.attachments, memory).expect("an island")
    }
}

fn spring(tail: usize, head: usize, stiffness: f64, damping: f64, rest_length: f64) -> Spring<f64> {
    Spring { tail, head, stiffness, damping, rest_length }
}

fn held(node: usize, place: Vec3<f64>) -> Attachment<f64> {
    Attachment { node, port: 0, place, push: [0.0; 3] }
}

/// Steps of Kutta's method.
pub(crate) fn run(system: &mut impl Ode<f64>, x: &mut [f64], h: f64, steps: u32) {
    run_by(Method::Rk4, system, x, h, steps);
}

fn run_by(method: Method, system: &mut impl Ode<f64>, x: &mut [f64], h: f64, steps: u32) {
    let (mut low, mut scratch) = (vec![0.0; x.len()], vec![0.0; method.scratch(x.len())]);
    let mut state = State::new(x, &mut low).expect("a state");
    for step in 0..steps {
        method.step(system, f64::from(step) * h, h, &mut state, &mut scratch).expect("a step");
    }
}

/// A closed cell: a 3 x 3 sheet whose rim and base (node 9) are attached, its middle (node 4) free, and a tail of two
/// free nodes; gas inside.
pub(crate) fn cell(damping: f64) -> Lists {
    let place = |i: usize| [0.1 * (i % 3) as f64 - 0.1, 0.1 * (i / 3) as f64 - 0.1, 0.05];
    let mut lists = Lists {
        mass: vec![0.0; 12],
        fixed: vec![true; 12],
        springs: Vec::new(),
        facets: Vec::new(),
        inflation: None,
        gravity: [0.0; 3],
        attachments: Vec::new(),
        pos: vec![[0.0; 3]; 12],
        vel: vec![[0.0; 3]; 12],
    };
    for node in (0..9).filter(|node| *node != 4) {
        lists.attachments.push(held(node, place(node)));
    }
    lists.attachments.push(held(9, [0.0, 0.0, 0.05]));
    for (node, x, v) in [
        (4, [0.31, -0.2, 0.62], [0.4, 0.1, -0.3]),
        (10, [0.3, -0.2, 0.72], [0.2, 0.3, 0.1]),
        (11, [0.32, -0.1, 0.8], [0.0, -0.2, 0.5]),
    ] {
        (lists.mass[node], lists.fixed[node], lists.pos[node], lists.vel[node]) = (0.05, false, x, v);
    }
    for rim in [1, 3, 5, 7] {
        lists.springs.push(spring(rim, 4, 400.0, damping, 0.1));
    }
    lists.springs.extend([spring(4, 10, 300.0, damping, 0.1), spring(10, 11, 300.0, damping, 0.1)]);
    for corner in [0, 1, 3, 4] {
        let quad = [corner, corner + 1, corner + 4, corner + 3];
        lists.facets.push(quad);
        lists.facets.push([quad[0], quad[3], quad[2], quad[1]].map(|node| if node == 4 { 9 } else { node }));
    }
    let gas = flexible::Gas::Polytropic {
        pressure: 2000.0,
        ambient: 101_325.0,
        volume: 2e-3,
        exponent: 1.4,
        dead_volume: 1.5e-3,
    };
    lists.inflation = Some(Inflation { gas, form: PressureForm::Exact });
    lists
}

pub(crate) const FLOATING: Floating<f64> =
    Floating { body: RigidBody { mass: 2.0, inertia: [0.02, 0.03, 0.04] }, gravity: [0.0; 3] };
const POSE: [f64; 7] = [0.3, -0.2, 0.5, 1.0, 0.0, 0.0, 0.0];
const MOMENTA: [f64; 6] = [0.2, -0.1, 0.3, 0.01, 0.05, -0.02];

/// A floating pair after a second.
struct Pair {
    linear: Vec3<f64>,
    angular: Vec3<f64>,
    /// Sum of all |m v|.
    size: f64,
    /// Sum of all |x x m v|.
    turning: f64,
    energy: f64,
    x: Vec<f64>,
}

impl Pair {
    /// How far its momenta are from those of another, relative to the sums of sizes.
    fn moved(&self, from: &Pair) -> [f64; 2] {
        let moved = vec3::norm(vec3::sub(self.linear, from.linear)) / from.size;
        [moved, vec3::norm(vec3::sub(self.angular, from.angular)) / from.turning]
    }
}

/// A floating pair after a second in so many steps.
fn floating_pair(method: Method, damping: f64, steps: u32) -> Pair {
    let mut lists = cell(damping);
    let (mass, mut rows) = (lists.mass.clone(), lists.rows());
    let mut island = lists.island(FLOATING, &mut rows);
    let mut x = vec![0.0; island.n_x()];
    island.load(&POSE, &MOMENTA, &mut x).expect("lengths");
    if steps > 0 {
        run_by(method, &mut island, &mut x, 1.0 / f64::from(steps), steps);
    }
    let energy = island.energy(0.0, &x).expect("energy").total();
    let (q, u) = (&x[..7], &x[island.n_q()..island.n_q() + 6]);
    let state = island.carrier.state(q, u).expect("a state");
    let (pos, vel) = island.nodes();
    let mut linear = vec3::scale(state.velocity, 2.0);
    let mut angular = vec3::add(state.angular_momentum, vec3::cross(state.position, linear));
    let (mut size, mut turning) = (vec3::norm(linear), vec3::norm(angular));
    for ((m, x), v) in mass.iter().zip(pos).zip(vel) {
        let p = vec3::scale(*v, *m);
        let l = vec3::cross(*x, p);
        (linear, angular) = (vec3::add(linear, p), vec3::add(angular, l));
        (size, turning) = (size + vec3::norm(p), turning + vec3::norm(l));
    }
    Pair { linear, angular, size, turning, energy, x }
}

#[test]
fn a_floating_pair_keeps_momentum_and_its_energy_to_the_order_of_the_method() {
    let start = floating_pair(Method::Rk4, 0.0, 0);
    let after = [8000, 16_000].map(|steps| floating_pair(Method::Rk4, 0.0, steps));
    for [moved, turned] in after.each_ref().map(|after| after.moved(&start)) {
        println!("linear momentum moves by {moved:e}");
        assert!(moved < 1e-12 && turned < 1e-6);
    }
    let errors = after.each_ref().map(|after| (after.energy - start.energy).abs());
    let turned = after.each_ref().map(|after| after.moved(&start)[1]);
    let orders = [(errors[0] / errors[1]).log2(), (turned[0] / turned[1]).log2()];
    println!("energy {errors:?}, angular momentum {turned:?}: orders {orders:?}");
    // One-sided: at particular times a coefficient of the error passes zero.
    assert!(orders.iter().all(|order| *order > 3.7), "{orders:?}");
    assert!(errors[1] < 1e-6 * start.energy.abs().max(1.0));
    // With dampers the energy falls, the momentum stays.
    let damped = floating_pair(Method::Rk4, 0.5, 8000);
    assert!(damped.energy < start.energy - 1e-3 && damped.moved(&start)[0] < 1e-12);
}

#[test]
fn splittings_keep_both_momenta_of_a_floating_pair() {
    let start = floating_pair(Method::Rk4, 0.0, 0);
    let exact = floating_pair(Method::Rk4, 0.0, 64_000).x;
    for method in [Method::Verlet, Method::ImplicitMidpoint, Method::BlanesMoan4] {
        let after = [8000, 16_000].map(|steps| floating_pair(method, 0.0, steps));
        let damped = floating_pair(method, 0.5, 4000);
        for [moved, turned] in after.iter().chain([&damped]).map(|after| after.moved(&start)) {
            println!("{method:?}: linear {moved:.1e}, angular {turned:.1e}");
            assert!(moved < 1e-12 && turned < 1e-12, "{method:?}: {moved:e} {turned:e}");
        }
        let errors = after
            .each_ref()
            .map(|after| after.x.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max));
        let order = (errors[0] / errors[1]).log2();
        println!("{method:?}: {errors:?}, order {order:.2}");
        // A turning body's coordinates do not follow its speeds by constant factors: order 2 for all.
        assert!(order > 1.8, "{method:?}: {errors:?}");
        assert!(damped.energy < start.energy - 1e-3, "{method:?}");
    }
}

/// A platform that a spring holds above the ground and that moves along n3 alone.
pub struct Platform {
    pub mass: f64,
    pub stiffness: f64,
    pub gravity: f64,
    pub damping: f64,
}

impl Carrier<f64> for Platform {
    fn n_q(&self) -> usize {
        1
    }
    fn n_u(&self) -> usize {
        1
    }
    fn n_ports(&self) -> usize {
        1
    }
    fn inverse_inertia(
        &mut self,
        _: f64,
        _: &[f64],
        _: &[f64],
        _: [usize; 2],
    ) -> Result<InverseInertia<f64>, Fault> {
        let mut inverse = [[0.0; 6]; 6];
        inverse[2][2] = 1.0 / self.mass;
        Ok(inverse)
    }
    fn frames(&mut self, _: f64, q: &[f64], u: &[f64], frames: &mut [Frame<f64>]) -> Result<(), Fault> {
        frames[0] = Frame { origin: [0.0, 0.0, q[0]], velocity: [0.0, 0.0, u[0]], ..Frame::inertial() };
        Ok(())
    }
    fn rates(
        &mut self,
        _: f64,
        q: &[f64],
        u: &[f64],
        wrenches: &[Wrench<f64>],
        q_dot: &mut [f64],
        u_dot: &mut [f64],
    ) -> Result<f64, Fault> {
        q_dot[0] = u[0];
        u_dot[0] =
            (wrenches[0].force[2] - self.stiffness * q[0] - self.damping * u[0]) / self.mass - self.gravity;
        Ok(1.0)
    }
    fn energy(&mut self, _: f64, q: &[f64], u: &[f64]) -> Result<(f64, f64), Fault> {
        let potential = 0.5 * self.stiffness * q[0] * q[0] + self.mass * self.gravity * q[0];
        Ok((0.5 * self.mass * u[0] * u[0], potential))
    }
}

const ARM: f64 = 0.3;
const MASS: f64 = 0.4;
const K: f64 = 900.0;
const C: f64 = 2.0;
const REST: f64 = 0.35;
const GRAVITY: f64 = 9.81;

/// A mass over the platform, on two slanted spring-dampers attached to it.
fn slanted(height: f64, damping: f64) -> Lists {
    Lists {
        mass: vec![0.0, 0.0, MASS],
        fixed: vec![true, true, false],
        springs: vec![spring(0, 2, K, damping, REST), spring(1, 2, K, damping, REST)],
        facets: Vec::new(),
        inflation: None,
        gravity: [0.0, 0.0, -GRAVITY],
        attachments: vec![held(0, [-ARM, 0.0, 0.0]), held(1, [ARM, 0.0, 0.0])],
        pos: vec![[0.0; 3], [0.0; 3], [0.0, 0.0, height]],
        vel: vec![[0.0; 3]; 3],
    }
}

/// The same two heights as one system written by hand.
struct ByHand;

impl Ode<f64> for ByHand {
    fn n_x(&self) -> usize {
        4
    }
    fn n_q(&self) -> usize {
        2
    }
    fn rates(&mut self, _: f64, x: &[f64], x_dot: &mut [f64]) -> Result<f64, Fault> {
        let [platform, mass, u, v] = [x[0], x[1], x[2], x[3]];
        let rise = mass - platform;
        let length = (ARM * ARM + rise * rise).sqrt();
        let pull = 2.0 * (K * (length - REST) + C * (v - u) * rise / length) * rise / length;
        x_dot.copy_from_slice(&[u, v, (pull - 2e4 * platform) / 3.0 - GRAVITY, -pull / MASS - GRAVITY]);
        Ok(1.0)
    }
}

#[test]
fn a_mass_on_a_platform_moves_as_the_single_system_does() {
    const STEPS: u32 = 2000;
    let mut lists = slanted(0.25, C);
    let mut rows = lists.rows();
    let platform = Platform { mass: 3.0, stiffness: 2e4, gravity: GRAVITY, damping: 0.0 };
    let mut island = lists.island(platform, &mut rows);
    let mut x = vec![0.0; island.n_x()];
    island.load(&[0.01], &[0.2], &mut x).expect("lengths");
    run(&mut island, &mut x, 1e-3, STEPS);
    let mut other = [0.01, 0.25, 0.2, 0.0];
    run(&mut ByHand, &mut other, 1e-3, STEPS);
    let [platform, mass] = [x[0] - other[0], x[3] - other[1]];
    println!("platform off by {platform:e} m, mass by {mass:e} m after {STEPS} steps");
    assert!(platform.abs() < 1e-12 && mass.abs() < 1e-12, "{platform:e} {mass:e}");
    assert!(x[0].abs() > 1e-4 && (x[1], x[2]) == (0.0, 0.0), "{x:?}");
}

const LIFT: f64 = 0.02;
const TURN: f64 = 11.0;

/// The frame is lifted by a cosine and carries a mass on one upright spring. Returns the error against the closed form,
/// and the energy minus the drive's work.
fn commanded(steps: u32) -> (f64, f64) {
    let seconds = 1.5;
    let law = |t: f64, _: usize| Frame {
        origin: [0.0, 0.0, LIFT * (1.0 - (TURN * t).cos())],
        velocity: [0.0, 0.0, LIFT * TURN * (TURN * t).sin()],
        ..Frame::inertial()
    };
    let mut lists = Lists {
        mass: vec![0.0, MASS],
        fixed: vec![true, false],
        springs: vec![spring(0, 1, K, 0.0, REST)],
        attachments: vec![held(0, [0.0; 3])],
        pos: vec![[0.0; 3], [0.0, 0.0, REST]],
        vel: vec![[0.0; 3]; 2],
        gravity: [0.0; 3],
        ..slanted(0.0, 0.0)
    };
    let mut rows = lists.rows();
    let mut island = lists.island(Commanded { law, ports: 1 }, &mut rows);
    let mut x = vec![0.0; island.n_x()];
    island.load(&[], &[], &mut x).expect("lengths");
    let start = island.energy(0.0, &x).expect("energy").total();
    let (mut low, mut scratch) = (vec![0.0; 6], vec![0.0; Method::Rk4.scratch(6)]);
    let mut rates = [0.0; 6];
    let (h, mut work) = (seconds / f64::from(steps), 0.0);
    let mut state = State::new(&mut x, &mut low).expect("a state");
    for step in 0..steps {
        // Simpson's rule over pairs of steps.
        let weight = if step == 0 { 1.0 } else { [2.0, 4.0][(step % 2) as usize] };
        island.rates(f64::from(step) * h, state.x(), &mut rates).expect("rates");
        work -= weight * h / 3.0 * island.seam_power();
        Method::Rk4.step(&mut island, f64::from(step) * h, h, &mut state, &mut scratch).expect("a step");
    }
    island.rates(seconds, state.x(), &mut rates).expect("rates");
    work -= h / 3.0 * island.seam_power();
    let end = island.energy(seconds, state.x()).expect("energy").total();
    // m z'' = K (y - z) with y the lift, z(0) = z'(0) = 0.
    let own = (K / MASS).sqrt();
    let gain = own * own / (own * own - TURN * TURN);
    let exact = LIFT * (1.0 - gain * (TURN * seconds).cos() + (gain - 1.0) * (own * seconds).cos());
    (state.x()[2] - REST - exact, end - start - work)
}

#[test]
fn a_commanded_frame_drives_the_mass_as_the_closed_form_says_and_pays_for_it() {
    let [(coarse, _), (fine, imbalance)] = [600, 1200].map(commanded);
    let order = (coarse / fine).abs().log2();
    println!("error {fine:e} m, order {order:.2}; energy less the drive's work {imbalance:e} J");
    assert!((order - 4.0).abs() < 0.3, "{order}");
    assert!(fine.abs() < 1e-7 && imbalance.abs() < 1e-7, "{fine:e} {imbalance:e}");
}

/// The cell's gas as a part of an island.
pub(crate) fn content(facets: [usize; 2]) -> Cell<f64> {
    let chamber = Chamber { gas: Gas::air(), exponent: 1.4, reference_volume: 2e-3, ambient: 101_325.0 };
    let state = GasState { reference_pressure: 103_325.0, mass: 2.4e-3 };
    Cell { facets, content: Content::Sealed { chamber, state }, form: PressureForm::Exact, wall: None }
}

#[test]
fn two_cells_on_two_bodies_in_one_island_move_as_each_by_itself() {
    const STEPS: u32 = 500;
    let single = |pose: &[f64; 7], momenta: &[f64; 6], shift: f64| {
        let mut lists = cell(0.3);
        lists.pos.iter_mut().for_each(|x| x[0] += shift);
        // The other gas law, of the body's own inflation: the same gas.
        lists.inflation = Some(Inflation {
            gas: flexible::Gas::Polytropic {
                pressure: 2000.0,
                ambient: 101_325.0,
                volume: 2e-3,
                exponent: 1.4,
                dead_volume: 0.0,
            },
            form: PressureForm::Exact,
        });
        let mut rows = lists.rows();
        let mut island = lists.island(FLOATING, &mut rows);
        let mut x = vec![0.0; island.n_x()];
        island.load(pose, momenta, &mut x).expect("lengths");
        run(&mut island, &mut x, 1e-4, STEPS);
        let energy = island.energy(0.0, &x).expect("energy").total();
        (x, energy)
    };
    let (shift, mut other_pose) = (2.0, POSE);
    other_pose[0] += shift;
    let other_momenta = MOMENTA.map(|u| -0.5 * u);
    let (first, first_energy) = single(&POSE, &MOMENTA, 0.0);
    let (second, second_energy) = single(&other_pose, &other_momenta, shift);

    let (mut lists, more) = (cell(0.3), cell(0.3));
    let (nodes, facets) = (lists.mass.len(), lists.facets.len());
    lists.inflation = None;
    lists.mass.extend(more.mass);
    lists.fixed.extend(more.fixed);
    lists.vel.extend(more.vel);
    lists.pos.extend(more.pos.iter().map(|x| [x[0] + shift, x[1], x[2]]));
    lists.facets.extend(more.facets.iter().map(|facet| facet.map(|node| node + nodes)));
    lists.springs.extend(more.springs.iter().map(|s| Spring {
        tail: s.tail + nodes,
        head: s.head + nodes,
        ..*s
    }));
    let moved = |a: &Attachment<f64>| Attachment { node: a.node + nodes, port: 1, ..*a };
    lists.attachments.extend(more.attachments.iter().map(moved));
    let mut bodies = [FLOATING; 2];
    let cells = [content([0, facets]), content([facets, 2 * facets])];
    let (mut elastic, mut viscous) = (lists.pos.clone(), lists.pos.clone());
    let (mut frames, mut wrenches) = ([Frame::inertial(); 2], [Wrench::zero(); 2]);
    let body = Body {
        mass: &lists.mass,
        fixed: &lists.fixed,
        inverse_mass: &[],
        springs: &lists.springs,
        gravity: lists.gravity,
        air_drag: 0.0,
        facets: &lists.facets,
        inflation: None,
        massless: Massless::default(),
        grids: &[],
        patches: None,
    };
    let memory = Memory {
        pos: &mut lists.pos,
        vel: &mut lists.vel,
        elastic: &mut elastic,
        viscous: &mut viscous,
        frames: &mut frames,
        wrenches: &mut wrenches,
    };
    let island = Island::new(Group { members: &mut bodies }, body, &lists.attachments, memory);
    let mut island = island.and_then(|island| island.with_cells(&cells)).expect("an island");
    let mut x = vec![0.0; island.n_x()];
    let (q, u) = ([POSE, other_pose].concat(), [MOMENTA, other_momenta].concat());
    island.load(&q, &u, &mut x).expect("lengths");
    run(&mut island, &mut x, 1e-4, STEPS);
    let energy = island.energy(0.0, &x).expect("energy").total();

    // Both states: pose and nodes, momenta and velocities.
    let halves = |x: &[f64], n: usize| (x[..n].to_vec(), x[n..].to_vec());
    let ((q1, u1), (q2, u2)) = (halves(&first, 7 + 9), halves(&second, 7 + 9));
    let joined = [&q1[..7], &q2[..7], &q1[7..], &q2[7..], &u1[..6], &u2[..6], &u1[6..], &u2[6..]].concat();
    let largest = x.iter().zip(&joined).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    println!("two in one island differ from each by itself by {largest:e}");
    assert!(largest < 1e-11, "{largest:e}");
    // Each body's own account, and the carriers' beside them.
    let springs = lists.springs.len() / 2;
    let mut parts = island.energy(0.0, &x).expect("energy").carrier;
    for k in 0..2 {
        let of = |n: usize| k * n..(k + 1) * n;
        parts.0 += island.energy_of(of(nodes), of(springs), of(1)).expect("ranges").total();
    }
    assert!((parts.0 + parts.1 - energy).abs() < 1e-12 * energy.abs().max(1.0));
    assert_eq!(island.energy_of(0..nodes, 0..2 * springs + 1, 0..1), Err(Fault::Shape));
    // The two laws count the gas' energy from volumes of their own.
    assert!((energy - first_energy - second_energy).abs() < 1e-9 * energy.abs().max(1.0), "{energy}");
    assert!((first[0] - POSE[0]).abs() > 1e-3);
    let restrained = [[0, nodes], [nodes, 2 * nodes]];
    let island = island.with_restrained(&restrained).expect("both bodies");
    let island = island.with_restrained(&[[2, 2]]).expect("a body of no nodes");
    assert_eq!(island.with_restrained(&[[nodes, 2 * nodes + 1]]).err(), Some(Fault::Shape));
}

#[test]
fn an_attachment_must_be_a_fixed_massless_node_at_a_port_that_exists() {
    let refused = |change: fn(&mut Lists)| {
        let mut lists = slanted(0.25, C);
        change(&mut lists);
        let Rows([mut elastic, mut viscous], mut frames, mut wrenches) = lists.rows();
        let body = Body {
            mass: &lists.mass,
            fixed: &lists.fixed,
            inverse_mass: &[],
            springs: &lists.springs,
            gravity: lists.gravity,
            air_drag: 0.0,
            facets: &[],
            inflation: None,
            massless: Massless::default(),
            grids: &[],
            patches: None,
        };
        let memory = Memory {
            pos: &mut lists.pos,
            vel: &mut lists.vel,
            elastic: &mut elastic,
            viscous: &mut viscous,
            frames: &mut frames,
            wrenches: &mut wrenches,
        };
        let platform = Platform { mass: 3.0, stiffness: 2e4, gravity: GRAVITY, damping: 0.0 };
        Island::new(platform, body, &lists.attachments, memory).is_err()
    };
    assert!(!refused(|_| {}));
    assert!(refused(|lists| lists.attachments[0].port = 1));
    assert!(refused(|lists| lists.attachments[0].node = 3));
    assert!(refused(|lists| lists.attachments[0].node = 2));
    assert!(refused(|lists| lists.mass[0] = 0.1));
    assert!(refused(|lists| lists.pos.truncate(2)));
}
