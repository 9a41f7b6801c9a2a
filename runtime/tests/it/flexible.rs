//! Flexible bodies on the ground, of a few points each, against closed forms: friction, dampers, impacts, accounts.

use crate::random::Random;
use smartbed_runtime::contact::compensation::{Compensation, PointImpact, apply as compensate};
use smartbed_runtime::contact::pair::{self, Touch};
use smartbed_runtime::contact::stable_step::{Sums, largest_stable_step};
use smartbed_runtime::contact::{ContactLaw, ContactState, ForceLaw, Ground, System, friction};
use smartbed_runtime::flexible::{Body, BodyError, Massless, Spring};
use smartbed_runtime::ledger::{Ledger, eval_stored};
use smartbed_runtime::ode::nodes::{MOTION_ROWS, Method, Motion, Step, Workspace, workspace_len};
use smartbed_runtime::scene::{Event, Flow, Observer, State, step};
use std::f64::consts::PI;

const G: f64 = 9.81;
const METHODS: [Method<f64>; 6] = [
    Method::Verlet,
    Method::Nystrom4,
    Method::BlanesMoan4,
    Method::Rk4,
    Method::ImplicitMidpoint,
    Method::EnergyMomentum,
];

/// A body, its ground, its start.
pub(crate) struct Trial {
    pub pos: Vec<[f64; 3]>,
    pub vel: Vec<[f64; 3]>,
    pub mass: Vec<f64>,
    pub fixed: Vec<bool>,
    pub springs: Vec<Spring<f64>>,
    gravity: f64,
    law: Option<ContactLaw<f64>>,
    normal: [f64; 3],
    friction: f64,
}

/// Results of a step: time, positions, speeds, accounts, and their imbalance relative to the initial energy.
pub(crate) struct Row {
    pub t: f64,
    pub pos: Vec<[f64; 3]>,
    pub vel: Vec<[f64; 3]>,
    ledger: Ledger<f64>,
    pub imbalance: f64,
    touches: usize,
    pub evaluations: usize,
    cut_short: bool,
}

struct Watch(Ledger<f64>);

impl Observer<f64> for Watch {
    fn flow(&mut self, system: &System<f64>, flow: Flow<f64>) {
        self.0.flow(system, flow);
    }
    fn event(&mut self, system: &System<f64>, event: Event<f64>) {
        self.0.event(system, event);
    }
}

pub(crate) fn spring(ends: [usize; 2], stiffness: f64, damping: f64, rest_length: f64) -> Spring<f64> {
    Spring { tail: ends[0], head: ends[1], stiffness, damping, rest_length }
}

impl Trial {
    /// One point of 1 kg, in weightlessness over no ground.
    pub fn point(pos: [f64; 3], vel: [f64; 3]) -> Trial {
        Trial {
            pos: vec![pos],
            vel: vec![vel],
            mass: vec![1.0],
            fixed: vec![false],
            springs: Vec::new(),
            gravity: 0.0,
            law: None,
            normal: [0.0, 0.0, 1.0],
            friction: 0.0,
        }
    }

    /// One point more, fixed.
    pub fn anchored(mut self, pos: [f64; 3]) -> Trial {
        self.pos.push(pos);
        self.vel.push([0.0; 3]);
        self.mass.push(1.0);
        self.fixed.push(true);
        self
    }

    fn body(&self) -> Body<'_, f64> {
        Body {
            mass: &self.mass,
            fixed: &self.fixed,
            inverse_mass: &[],
            springs: &self.springs,
            gravity: [0.0, 0.0, -self.gravity],
            air_drag: 0.0,
            facets: &[],
            inflation: None,
            massless: Massless { points: &[], first: &[0], springs: &[] },
            grids: &[],
            patches: None,
        }
    }

    fn system(&self) -> System<'_, f64> {
        let ground = self.law.map(|law| Ground {
            normal: self.normal,
            offset: 0.0,
            law,
            friction: self.friction,
            tolerance: 1e-11,
        });
        System::new(self.body(), ground)
    }

    pub fn run(&self, method: Method<f64>, h: f64, seconds: f64) -> Vec<Row> {
        self.try_run(method, h, seconds).expect("steps")
    }

    /// The same of a run that may end with a refused step.
    pub fn try_run(&self, method: Method<f64>, h: f64, seconds: f64) -> Result<Vec<Row>, BodyError<f64>> {
        let n = self.pos.len();
        let system = self.system();
        let mut memory = vec![[0.0; 3]; MOTION_ROWS * n];
        let mut scratch = vec![[0.0; 3]; workspace_len(n, method.stages())];
        let (mut modes, mut impacts) = (vec![ContactState::Free; n], vec![PointImpact::none(); n]);
        let (motion, _) = Motion::cut(&mut memory, n).expect("room");
        motion.pos.copy_from_slice(&self.pos);
        motion.vel.copy_from_slice(&self.vel);
        let (time, next_step, anchor) = ([0.0; 2], 0.0, 0.0);
        let mut state = State { motion, modes: &mut modes, impacts: &mut impacts, time, next_step, anchor };
        let mut work = Workspace::new(&mut scratch, n, method.stages()).expect("room");
        let mut watch = Watch(Ledger::open(&system, &state));
        state.begin(&system, h, method, &mut work, &mut watch).expect("a start");
        let mut rows = Vec::new();
        for _ in 0..(seconds / h).round() as usize {
            let report = step(&system, &mut state, h, method, &mut work, &mut watch)?;
            let stored = eval_stored(&system, state.motion.pos, state.motion.vel);
            rows.push(Row {
                t: state.t(),
                pos: state.motion.pos.to_vec(),
                vel: state.motion.vel.to_vec(),
                ledger: watch.0,
                imbalance: watch.0.imbalance(&stored),
                touches: report.events,
                evaluations: report.evaluations,
                cut_short: report.cut_short,
            });
        }
        Ok(rows)
    }
}

fn close(found: f64, wanted: f64, within: f64, about: &str) {
    assert!((found - wanted).abs() <= within, "{about}: {found:e} is not {wanted:e}");
}

/// Random slips and impulses: friction is at most mu J, opposes the slip and never reverses it; it reports the energy
/// lost.
#[test]
fn friction_stops_slip_and_never_turns_it() {
    let mut random = Random::new(7);
    let normal = [0.6, 0.0, 0.8];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let slip_of = |v: [f64; 3]| [0, 1, 2].map(|c| v[c] - dot(v, normal) * normal[c]);
    let size = |v: [f64; 3]| dot(v, v).sqrt();
    for case in 0..20_000 {
        let (mass, mu) = (random.between(0.1, 10.0), random.between(0.05, 2.0));
        let before = random.vector(1.0);
        let first = random.vector(1.0);
        // From far too little to far too much to stop it.
        let impulse = mass * size(slip_of(before)) / mu * random.between(0.0, 3.0);
        let kinetic = |v: [f64; 3]| 0.5 * mass * dot(v, v);
        for over in [false, true] {
            let mut v = before;
            let loss = match over {
                false => friction::apply(&mut v, normal, mass, mu, impulse),
                true => friction::apply_over(&mut v, first, normal, mass, mu, impulse),
            };
            let (old, new) = (slip_of(before), slip_of(v));
            close(loss, kinetic(before) - kinetic(v), 1e-13 * (1.0 + kinetic(before)), "loss");
            assert!(loss >= 0.0, "{case}: {loss}");
            close(dot(v, normal), dot(before, normal), 1e-14, "along the normal");
            let taken = mass * size([0, 1, 2].map(|c| new[c] - old[c]));
            let most = mu * impulse;
            assert!(taken <= most + 1e-14, "{case}: {taken} of {most}");
            if most >= mass * size(old) {
                assert!(size(new) <= 1e-15, "{case}: it stops, {new:?}");
            } else {
                close(taken, most, 1e-14, "all of it");
            }
            if !over {
                assert!(dot(old, new) >= -1e-15, "{case}: turned round");
            }
        }
    }
}

/// A point between two fixed ones, one spring of two damped: x'' = -(2 k x + c x')/m.
#[test]
fn one_damper_among_springs_damps() {
    let (k, c, m, a) = (400.0, 3.0, 0.7, 0.1);
    let mut trial =
        Trial::point([a, 0.0, 0.0], [0.0; 3]).anchored([-1.0, 0.0, 0.0]).anchored([1.0, 0.0, 0.0]);
    trial.mass[0] = m;
    trial.springs = vec![spring([1, 0], k, 0.0, 1.0), spring([0, 2], k, c, 1.0)];
    let (decay, rate) = (0.5 * c / m, (2.0 * k / m - (0.5 * c / m).powi(2)).sqrt());
    for method in [Method::Verlet, Method::Rk4, Method::ImplicitMidpoint, Method::EnergyMomentum] {
        for row in trial.run(method, 2e-4, 1.0) {
            let (sin, cos) = (rate * row.t).sin_cos();
            let wanted = a * (-decay * row.t).exp() * (cos + decay / rate * sin);
            close(row.pos[0][0], wanted, 1e-5, "place");
            assert!(row.imbalance.abs() <= 1e-4, "{:e}", row.imbalance);
        }
    }
}

/// Points far above the ground, some on their way down, change no bit and no touch of one that bounces among them.
#[test]
fn what_cannot_reach_the_ground_changes_no_event() {
    for (method, friction) in [(Method::Verlet, 0.0), (Method::BlanesMoan4, 0.0), (Method::Verlet, 0.3)] {
        let mut alone = Trial::point([0.0, 0.0, 0.3], [0.4, 0.0, -1.0]);
        (alone.gravity, alone.friction) = (9.81, friction);
        alone.law = Some(ContactLaw::Newton { restitution: 0.8 });
        let bounces = alone.run(method, 1e-2, 2.0);
        assert!(bounces.iter().map(|row| row.touches).sum::<usize>() >= 4, "it bounces");
        let (mut many, place) =
            (Trial { pos: vec![], vel: vec![], mass: vec![], fixed: vec![], ..alone }, 300);
        for i in 0..500_u32 {
            let above = 60.0 + f64::from(i % 7);
            many.pos.push(if i == place { [0.0, 0.0, 0.3] } else { [f64::from(i), 0.0, above] });
            many.vel.push(if i == place { [0.4, 0.0, -1.0] } else { [0.0, 0.0, -f64::from(i % 11)] });
            many.mass.push(1.0);
            many.fixed.push(false);
        }
        for (row, wanted) in many.run(method, 1e-2, 2.0).iter().zip(&bounces) {
            let place = place as usize;
            assert_eq!((row.pos[place], row.vel[place]), (wanted.pos[0], wanted.vel[0]), "at {}", row.t);
            assert_eq!((row.touches, row.evaluations), (wanted.touches, wanted.evaluations), "at {}", row.t);
        }
    }
}

/// Points that swing through the floor, looked at together, against the same looked at one by one: a fixed point that
/// lies on the floor among them is never free, so that its block is not passed over.
#[test]
fn points_looked_at_together_touch_when_they_do_one_by_one() {
    let mut random = Random::new(3);
    for normal in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.48, -0.6, 0.64]] {
        for method in [Method::Verlet, Method::BlanesMoan4] {
            let mut trial = Trial::point([0.0, 0.0, 60.0], [0.0; 3]);
            (trial.law, trial.normal) = (Some(ContactLaw::Newton { restitution: 1.0 }), normal);
            for _ in 0..30 {
                // Some swing through the floor, some do not reach it.
                let ends = [trial.pos.len(), trial.pos.len() + 1];
                let (height, swing) = (random.between(0.1, 0.6), random.between(0.0, 0.5));
                trial.pos.push(normal.map(|n| n * (height + swing)));
                trial.vel.push(random.vector(0.3));
                trial.mass.push(1.0);
                trial.fixed.push(false);
                trial = trial.anchored(normal.map(|n| n * (1.0 + height)));
                trial.springs.push(spring(ends, random.between(50.0, 400.0), 0.0, 1.0));
            }
            let together = trial.run(method, 0.02, 2.0);
            let one_by_one = trial.anchored([0.0; 3]).run(method, 0.02, 2.0);
            let mut touches = 0;
            for (row, wanted) in together.iter().zip(&one_by_one) {
                let count = row.pos.len();
                let is_same = row.pos[..] == wanted.pos[..count] && row.vel[..] == wanted.vel[..count];
                assert!(is_same, "at {}", row.t);
                let [found, wanted] = [row, wanted].map(|row| (row.touches, row.evaluations));
                assert_eq!(found, wanted, "at {}", row.t);
                touches += row.touches;
            }
            assert!(touches > 10, "{touches}");
        }
    }
}

/// A point on a spring swings a thousandth below the floor and is thrown back each time: no dip within a step is
/// missed.
#[test]
fn dips_within_a_step_are_found() {
    let (rate, middle) = (10.0, 0.1);
    for part in [1e-4, 1e-3, 1e-2] {
        for phase in 0..20 {
            let swing = middle * (1.0 + part);
            let start = 0.1 * f64::from(phase);
            let (sin, cos) = start.sin_cos();
            let (pos, vel) = ([0.0, 0.0, middle + swing * cos], [0.0, 0.0, -rate * swing * sin]);
            let mut trial = Trial::point(pos, vel).anchored([0.0, 0.0, 1.0 + middle]);
            trial.springs = vec![spring([0, 1], rate * rate, 0.0, 1.0)];
            trial.law = Some(ContactLaw::Newton { restitution: 1.0 });
            // It touches at the phase `turn`, and goes on from 2 pi - turn.
            let turn = (-1.0 / (1.0 + part)).acos();
            let mut touched = 0;
            for row in trial.run(Method::BlanesMoan4, 0.02, 5.0) {
                let mut angle = start + rate * row.t;
                let mut skipped = 0;
                while angle > turn + 2.0 * PI * f64::from(skipped) {
                    angle += 2.0 * (PI - turn);
                    skipped += 1;
                }
                touched += row.touches;
                close(
                    row.pos[0][2],
                    middle + swing * angle.cos(),
                    2e-5,
                    &format!("{part} {phase} {}", row.t),
                );
                if skipped > 0 {
                    assert!(touched.abs_diff(skipped as usize) <= 1, "{touched} of {skipped}");
                }
            }
        }
    }
}

/// A block of 0.5 kg on a rough floor and a spring, let go with the spring drawn by a: place after t. Each half period
/// the spring's force swings about mu m g, away from the motion, until it cannot pull any more.
fn block(mu: f64, a: f64, t: f64) -> f64 {
    let (rate, dead) = ((200.0_f64 / 0.5).sqrt(), mu * 0.5 * G / 200.0);
    let (mut start, mut left) = (a, t);
    while start.abs() > dead {
        let middle = dead * start.signum();
        if left * rate < PI {
            return middle + (start - middle) * (left * rate).cos();
        }
        (start, left) = (2.0 * middle - start, left - PI / rate);
    }
    start
}

/// The block reverses, sticks and stays, on rigid and on compliant ground; friction takes the energy that the spring
/// gave.
#[test]
fn a_block_on_a_spring_turns_and_sticks() {
    let weight = 0.5 * G;
    let grounds = [
        (ContactLaw::Newton { restitution: 0.0 }, 0.0),
        (ContactLaw::Force(ForceLaw::Penalty { stiffness: 2e4 }), weight / 2e4),
        (
            ContactLaw::Force(ForceLaw::HuntCrossley { stiffness: 2e6, dissipation: 0.0 }),
            (weight / 2e6).powf(2.0 / 3.0),
        ),
    ];
    for (law, depth) in grounds {
        for method in METHODS {
            let a = 0.17;
            let mut trial = Trial::point([1.0 + a, 0.0, -depth], [0.0; 3]).anchored([0.0, 0.0, -depth]);
            (trial.mass[0], trial.gravity, trial.friction, trial.law) = (0.5, G, 0.3, Some(law));
            trial.springs = vec![spring([0, 1], 200.0, 0.0, 1.0)];
            let rows = trial.run(method, 1e-3, 2.2);
            for row in &rows {
                close(
                    row.pos[0][0] - 1.0,
                    block(0.3, a, row.t),
                    1e-4,
                    &format!("{law:?} {method:?} {}", row.t),
                );
            }
            let end = rows.last().expect("rows");
            assert_eq!(end.vel[0][0], 0.0, "{law:?} {method:?}: it sticks");
            // Each half swing takes 2 mu m g/K; nothing ends a step but its turns.
            let turns = (a / (2.0 * 0.3 * weight / 200.0)).ceil() as usize;
            assert_eq!(rows.iter().map(|row| row.touches).sum::<usize>(), turns, "{law:?} {method:?}");
            let left = block(0.3, a, 2.2);
            close(end.ledger.friction, 100.0 * (a * a - left * left), 1e-3, "friction");
            assert!(end.imbalance.abs() <= 1e-3, "{law:?} {method:?} {:e}", end.imbalance);
        }
    }
}

/// v dv = -(k/m) d^1.5 (1 + a v) dd: with F(v) = v/a - ln(1 + a v)/a^2 the speed of leaving is the root of
/// F(-v1) = F(v0).
#[test]
fn a_dissipating_ground_takes_what_its_closed_form_says() {
    let (v0, a) = (1.0, 0.2);
    let potential = |v: f64| v / a - (a * v).ln_1p() / (a * a);
    let (mut low, mut high) = (0.0, v0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if potential(-middle) < potential(v0) { low = middle } else { high = middle }
    }
    let mut trial = Trial::point([0.0, 0.0, 0.001], [0.0, 0.0, -v0]);
    trial.law = Some(ContactLaw::Force(ForceLaw::HuntCrossley { stiffness: 1e5, dissipation: a }));
    for method in [Method::Verlet, Method::Rk4, Method::ImplicitMidpoint, Method::EnergyMomentum] {
        let rows = trial.run(method, 1e-4, 0.1);
        let end = rows.last().expect("rows");
        close(end.vel[0][2], high, 2e-4, "speed of leaving");
        close(end.ledger.impact, 0.5 * (v0 * v0 - high * high), 2e-4, "what the ground took");
        assert!(rows.iter().all(|row| row.imbalance.abs() <= 2e-4));
    }
}

/// Two stacked masses: v' of the upper one is -sqrt(v_a^2 + v_b^2) (thesis Eq. 4.13), for masses m_a and m_b too by
/// energy.
#[test]
fn stacked_masses_compensate_by_the_thesis() {
    for (below, above, fast, slow) in [(1.0, 1.0, 1.0, 1.0), (0.4, 2.5, 1.3, 0.2), (3.0, 0.5, 0.7, -0.3)] {
        let mut trial = Trial::point([0.0; 3], [0.0, 0.0, -fast]);
        trial.pos.push([0.0, 0.0, 1.0]);
        trial.vel.push([0.0, 0.0, -slow]);
        (trial.mass, trial.fixed) = (vec![below, above], vec![false; 2]);
        trial.springs = vec![spring([0, 1], 1000.0, 0.0, 1.0)];
        let eta = 0.8;
        trial.law =
            Some(ContactLaw::Compensation { eta, anchor: false, plastic_alone: false, first_receiver: 0 });
        let mut vel = trial.vel.clone();
        let mut points = vec![PointImpact::none(); 2];
        points[0].touching = true;
        let law = Compensation { eta, anchor: 0.0, plastic_alone: false, first_receiver: 0 };
        let hit = compensate(&trial.system(), law, &trial.pos, &mut vel, &mut points, |_| true);
        let after = (slow * slow + eta * below / above * fast * fast).sqrt();
        // Down, which presses the spring, as far as the ground need not pull; else up.
        let down = slow >= 0.0 && below * fast + above * (slow - after) >= 0.0;
        close(vel[0][2], 0.0, 1e-15, "the lower one stops");
        close(vel[1][2], if down { -after } else { after }, 1e-12, "the upper one");
        close(hit.lost, (1.0 - eta) * 0.5 * below * fast * fast, 1e-13, "what the law keeps");
        let impulse = above * (vel[1][2] + slow) + below * fast;
        close(points[0].impulse, impulse, 1e-12, "the ground's impulse is the change of momentum");
        assert!(impulse >= 0.0);
    }
}

/// A point strikes a facet of free corners, nobody beside them: momentum stays, (1 - eta) of M v^2/2 is lost.
#[test]
fn a_point_and_a_facet_rebound_by_their_masses() {
    let (mass, v, eta) = ([0.7, 1.0, 2.0, 0.5, 4.0], 1.5, 0.36);
    let pos = [[0.2, 0.1, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    // The facet moves along, so that the two close with v.
    let along = 0.4;
    let mut vel = [along - v, along, along, along, along].map(|z| [0.0, 0.0, z]);
    let body = Body {
        mass: &mass,
        fixed: &[false; 5],
        inverse_mass: &[],
        springs: &[],
        gravity: [0.0; 3],
        air_drag: 0.0,
        facets: &[],
        inflation: None,
        massless: Massless { points: &[], first: &[0], springs: &[] },
        grids: &[],
        patches: None,
    };
    let weights = [0.72, 0.18, 0.08, 0.02];
    let touch = Touch { point: 0, corners: [1, 2, 3, 4], weights, normal: [0.0, 0.0, 1.0] };
    let hit = pair::apply(&body, &touch, eta, &pos, &mut vel, &mut [[0.0; 3]; 5]).expect("they close");
    let inverse = 1.0 / mass[0] + (0..4).map(|j| weights[j] * weights[j] / mass[j + 1]).sum::<f64>();
    let facet: f64 = (0..4).map(|j| weights[j] * vel[j + 1][2]).sum();
    close(vel[0][2] - facet, eta.sqrt() * v, 1e-14, "they part with sqrt(eta) v");
    close(hit.impulse, (1.0 + eta.sqrt()) * v / inverse, 1e-14, "impulse");
    close(hit.lost, (1.0 - eta) * 0.5 * v * v / inverse, 1e-14, "loss");
    let momentum: f64 = (0..5).map(|i| mass[i] * vel[i][2]).sum();
    close(momentum, mass.iter().sum::<f64>() * along - mass[0] * v, 1e-14, "momentum");
}

/// Moreau's law on a point of 0.7 kg that bounces and slides: in each step its account equals the loss of energy.
#[test]
fn moreaus_accounts_of_a_thrown_point_close() {
    let mut trial = Trial::point([0.0, 0.0, 0.3], [1.5, 0.4, 0.0]);
    (trial.mass[0], trial.gravity, trial.friction) = (0.7, G, 0.35);
    trial.law = Some(ContactLaw::Moreau { restitution: 0.6 });
    let rows = trial.run(Method::SymplecticEuler, 1e-3, 2.0);
    let start = 0.5 * 0.7 * (1.5 * 1.5 + 0.4 * 0.4) + 0.7 * G * 0.3;
    let (mut impact, mut friction) = (0.0, 0.0);
    for row in &rows {
        assert!(row.ledger.impact >= impact && row.ledger.friction >= friction, "accounts never fall");
        (impact, friction) = (row.ledger.impact, row.ledger.friction);
        assert!(row.imbalance.abs() <= 2e-3 * start, "{}: {:e} of {start}", row.t, row.imbalance);
    }
    // It lies still in the end: friction has had all that moved it sideways, impacts the rest.
    let end = rows.last().expect("rows");
    assert_eq!((end.vel[0][0], end.vel[0][1]), (0.0, 0.0));
    close(friction, 0.5 * 0.7 * (1.5 * 1.5 + 0.4 * 0.4), 2e-3 * start, "friction");
    close(impact, 0.7 * G * 0.3, 5e-3 * start, "impacts");
}

/// Moreau's friction on a point that a spring pulls to and fro: at most mu times the normal impulse, and it never adds
/// energy, also in steps in which the slip reverses.
#[test]
fn moreaus_friction_takes_energy_alone() {
    let (mu, k, h) = (0.2, 20.0, 0.01);
    let mut turned = 0;
    for amplitude in 0..50 {
        let x = 0.4 + 0.01 * f64::from(amplitude);
        let mut trial = Trial::point([x, 0.0, 0.0], [0.0, 0.3, 0.0]).anchored([0.0; 3]);
        (trial.gravity, trial.friction, trial.springs) = (G, mu, vec![spring([0, 1], k, 0.0, 0.0)]);
        trial.law = Some(ContactLaw::Moreau { restitution: 0.0 });
        let (mut place, mut v) = (trial.pos[0], trial.vel[0]);
        for row in trial.run(Method::SymplecticEuler, h, 1.5) {
            let after = row.vel[0];
            // The spring acts where the point is half a step on.
            let impulse = [0, 1].map(|i| after[i] - v[i] + h * k * (place[i] + 0.5 * h * v[i]));
            let work = impulse[0] * (v[0] + after[0]) + impulse[1] * (v[1] + after[1]);
            assert!(work <= 1e-15, "{amplitude}, {}: friction puts in {work:e}", row.t);
            assert!(impulse[0].hypot(impulse[1]) <= mu * G * h * (1.0 + 1e-12), "{amplitude}: {impulse:?}");
            turned += usize::from(v[0] * after[0] + v[1] * after[1] < 0.0);
            (place, v) = (row.pos[0], after);
        }
    }
    assert!(turned >= 40, "{turned} turns");
}

/// One mass thrown at a ground N = k d^1.5: by its energy it comes d deep, 2/5 k d^2.5 = m v^2/2 + m g h, where the
/// ground's slope is 3/2 k d^0.5 and the step at most 2 sqrt(m/slope).
#[test]
fn the_stable_step_knows_how_deep_a_fall_goes() {
    let (m, k, h, v) = (0.7, 3e5_f64, 0.8, 1.2);
    let mut trial = Trial::point([0.0, 0.0, h], [v, 0.0, 0.0]);
    (trial.mass[0], trial.gravity) = (m, G);
    trial.law = Some(ContactLaw::Force(ForceLaw::HuntCrossley { stiffness: k, dissipation: 0.0 }));
    let energy = m * (0.5 * v * v + G * h);
    let depth = (2.5 * energy / k).powf(0.4);
    let longest = 2.0 * (m / (1.5 * k * depth.sqrt())).sqrt();
    let found = largest_stable_step(&trial.system(), &trial.pos, &trial.vel, &mut [Sums::none()]);
    close(found.expect("a bound"), longest, 1e-3 * longest, "the ground's spring");
    // Pressed in as deep already and let go.
    let mut pressed = Trial::point([0.0, 0.0, -depth], [0.0; 3]);
    (pressed.mass[0], pressed.law) = (m, trial.law);
    let found = largest_stable_step(&pressed.system(), &pressed.pos, &pressed.vel, &mut [Sums::none()]);
    close(found.expect("a bound"), longest, 1e-3 * longest, "the ground's spring, pressed at the start");
    // A spring to a fixed point, with a damper: h = (sqrt(C^2 + K m) - C)/K with K = k/4 and C = c/4 from that end
    // alone.
    let (k, c) = (900.0, 8.0);
    let mut hung = Trial::point([0.0; 3], [0.0; 3]).anchored([0.0, 0.0, 1.0]);
    hung.mass[0] = m;
    hung.springs = vec![spring([0, 1], k, c, 1.0)];
    let (stiff, damp) = (0.25 * k, 0.25 * c);
    let longest = ((damp * damp + stiff * m).sqrt() - damp) / stiff;
    let found = largest_stable_step(&hung.system(), &hung.pos, &hung.vel, &mut [Sums::none(); 2]);
    close(found.expect("a bound"), longest, 1e-9 * longest, "a damped spring");
}

/// A mass between fixed points, one ahead and one behind along each axis: the springs along an axis give 2 k, and those
/// across it 4 T/l where they pull. For springs to fixed points the bound is exact: 2 over the frequency.
#[test]
fn the_stable_step_knows_the_stiffness_of_tension() {
    let (m, k) = (0.7, 1000.0);
    for (rest, across) in [(0.3, 700.0), (1.0, 0.0), (1.4, 0.0)] {
        let mut star = Trial::point([0.0; 3], [0.0; 3]);
        star.mass[0] = m;
        for (axis, side) in [0, 1, 2].into_iter().flat_map(|axis| [(axis, -1.0), (axis, 1.0)]) {
            let mut end = [0.0; 3];
            end[axis] = side;
            star = star.anchored(end);
            star.springs.push(spring([0, star.pos.len() - 1], k, 0.0, rest));
        }
        let longest = 2.0 * (m / (2.0 * k + 4.0 * across)).sqrt();
        let found = largest_stable_step(&star.system(), &star.pos, &star.vel, &mut [Sums::none(); 7]);
        close(found.expect("a bound"), longest, 1e-9 * longest, "springs under tension");
    }
}

/// One touch of Newton's e with friction: J = (1 + e) m v, the slip loses mu J/m, and the accounts have both.
#[test]
fn a_touch_with_friction_is_in_the_accounts() {
    let (m, v, slip, mu, e) = (0.7, 2.0, 3.0, 0.3, 0.5);
    let mut trial = Trial::point([0.0, 0.0, 0.1], [slip, 0.0, -v]);
    trial.pos.push([5.0, 0.0, 0.1]);
    trial.vel.push([0.5, 0.0, -v]);
    (trial.mass, trial.fixed, trial.friction) = (vec![m, m], vec![false; 2], mu);
    trial.law = Some(ContactLaw::Newton { restitution: e });
    let rows = trial.run(Method::Verlet, 0.02, 0.1);
    let end = rows.last().expect("rows");
    let after = slip - mu * (1.0 + e) * v;
    close(end.vel[0][0], after, 1e-13, "slip");
    // The slower one sticks while it is struck.
    assert_eq!(end.vel[1][0], 0.0);
    close(end.ledger.friction, 0.5 * m * (slip * slip - after * after + 0.25), 1e-13, "friction");
    close(end.ledger.impact, m * v * v * (1.0 - e * e), 1e-13, "impact");
    close(end.imbalance, 0.0, 1e-13, "imbalance");
}

/// As many bounces as a step locates, and one more at its end: that one is taken out, nothing goes below the floor.
#[test]
fn what_a_step_does_not_locate_is_taken_out() {
    let (m, e, drop) = (0.7, 0.99_f64, 0.1);
    let mut trial = Trial::point([0.0, 0.0, drop], [0.0; 3]);
    (trial.mass[0], trial.gravity) = (m, G);
    trial.law = Some(ContactLaw::Newton { restitution: e });
    let speed = (2.0 * G * drop).sqrt();
    let flights: f64 = (1..=64).map(|k| 2.0 * speed * e.powi(k) / G).sum();
    let h = speed / G + flights + 1e-3;
    let rows = trial.run(Method::Verlet, h, h);
    assert!(rows[0].cut_short);
    close(rows[0].pos[0][2], 0.0, 1e-12, "it lies on the floor");
    close(rows[0].vel[0][2], 0.0, 1e-12, "at rest");
    // The end is stepped over by Euler's rule: its millisecond is not in the accounts.
    let start = m * G * drop;
    close(rows[0].ledger.impact, start, 0.02 * start, "all is taken");
}
