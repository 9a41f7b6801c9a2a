//! Runs a scene: rows of time, state and ledger, and events as they occur.

use std::fmt::Write as _;

use smartbed_runtime::contact::System;
use smartbed_runtime::flexible::BodyError;
use smartbed_runtime::ledger::{Ledger, eval_stored};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::scene::{Event, Flow, Observer};

use super::describe::describe;
use super::read::Scene;
use super::simulation::Simulation;
use crate::contact_force::ContactForce;
use crate::world::engine::ACCOUNTS;

/// A touch or release, for plots of work against impulse and for tests.
#[derive(Clone, Debug, PartialEq)]
pub struct EventRecord {
    /// Time (s).
    pub time: f64,
    /// Points that touched: index, speed of approach (m/s), ground impulse (N s).
    pub touches: Vec<(usize, f64, f64)>,
    /// lambda of the compensation, for a touch.
    pub lambda: Option<f64>,
    /// Number of points released.
    pub released: usize,
    /// Points held after the event.
    pub held: Vec<usize>,
    /// Work and impulse of the ground, for a touch.
    pub work: Option<WorkImpulse>,
}

/// Work over impulse of one impact (thesis Eqs. 4.14 to 4.26), for all touching points together.
///
/// The impulses of the ground and along the springs grow in proportion, from 0 to those of the law: velocities change
/// in proportion to P, so that W(P) = v_0 P + P^2/(2 M) (Eq. 4.25) with 1/M = sum m dv^2/J^2. P never falls;
/// compression ends where W is smallest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkImpulse {
    /// J: P at the end, the sum of the ground's impulses (N s).
    pub impulse: f64,
    /// Q: energy of the touching points along the normal before the impact, sum of m v_b^2/2 (J).
    pub taken: f64,
    /// W at the end: minus the energy that the law removes (J).
    pub net: f64,
    /// J^2/(2 M) = sum of m dv^2/2 (J).
    pub quadratic: f64,
}

impl WorkImpulse {
    /// Fraction of the impulse at which compression ends.
    #[must_use]
    pub fn compression(&self) -> f64 {
        let end = 0.5 * (1.0 - self.net / self.quadratic);
        if end.is_finite() { end.min(1.0) } else { 1.0 }
    }

    /// (P, W) during the impact, with `pieces` intervals in each phase: compression, then restitution.
    #[must_use]
    pub fn curve(&self, pieces: usize) -> Vec<(f64, f64)> {
        let middle = self.compression();
        let parts = |n: usize| n as f64 / pieces.max(1) as f64;
        let compression = (0..=pieces).map(|n| parts(n) * middle);
        let restitution = (1..=pieces).map(|n| middle + parts(n) * (1.0 - middle));
        let work = |s: f64| s * (self.net - self.quadratic) + s * s * self.quadratic;
        compression.chain(restitution).map(|s| (s * self.impulse, work(s))).collect()
    }
}

/// From the velocity field of the impact, which the event's points still contain.
fn work_impulse<S: Scalar>(system: &System<S>, event: &Event<S>) -> Option<WorkImpulse> {
    let impact = event.impact?;
    let (mut impulse, mut taken, mut field) = (0.0, 0.0, 0.0);
    let lambda = impact.lambda.to_f64();
    for (point, mass) in event.points.iter().zip(system.body.mass) {
        let mass = mass.to_f64();
        let square: f64 = point.field.iter().map(|c| c.to_f64() * c.to_f64()).sum();
        field += 0.5 * mass * square * lambda * lambda;
        if point.touching {
            let approach = point.approach.to_f64();
            taken += 0.5 * mass * approach * approach;
            impulse += point.impulse.to_f64();
        }
    }
    let lost = impact.lost.to_f64();
    // The field has no component along the normal at touching points, so that both energies add up. Without a field the
    // points themselves rebound, by sqrt(2 (Q - lost)) beyond their stop.
    let quadratic = match lambda == 0.0 {
        true => (taken.sqrt() + (taken - lost).max(0.0).sqrt()).powi(2),
        false => taken + field,
    };
    Some(WorkImpulse { impulse, taken, net: -lost, quadratic })
}

/// Energies and accounts at one time (J).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyRow {
    /// Kinetic, gravity, spring, pressure.
    pub stored: [f64; 4],
    /// Damping, drag, impact, friction, actuator.
    pub accounts: [f64; 5],
    /// Kinetic and stored energies.
    pub total: f64,
    /// Change of the total that no account explains.
    pub imbalance: f64,
}

/// One row of output.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Time (s).
    pub t: f64,
    /// Positions (m).
    pub pos: Vec<[f64; 3]>,
    /// Velocities (m/s).
    pub vel: Vec<[f64; 3]>,
    /// Forces of the ground.
    pub ground: Vec<ContactForce>,
    /// Energies.
    pub energy: EnergyRow,
    /// Touches so far.
    pub touches: usize,
    /// Steps so far that were completed without locating further events, because there were too many in one step.
    pub cut_short: usize,
}

/// Steps at most that are taken at once: progress is told, and time is looked at, behind them.
const LONGEST_SPAN: usize = 256;

struct Watch<S> {
    ledger: Ledger<S>,
    events: Vec<EventRecord>,
    touches: usize,
    cut_short: usize,
}

impl<S: Scalar> Observer<S> for Watch<S> {
    fn flow(&mut self, system: &System<S>, flow: Flow<S>) {
        self.ledger.flow(system, flow);
    }

    fn event(&mut self, system: &System<S>, event: Event<S>) {
        self.ledger.event(system, event);
        let touched = event.points.iter().enumerate().filter(|(_, p)| p.touching);
        let record = EventRecord {
            time: event.time.to_f64(),
            touches: touched.map(|(i, p)| (i, p.approach.to_f64(), p.impulse.to_f64())).collect(),
            lambda: event.impact.map(|i| i.lambda.to_f64()),
            released: event.released,
            held: event.modes.iter().enumerate().filter(|(_, m)| m.is_held()).map(|(i, _)| i).collect(),
            work: work_impulse(system, &event),
        };
        self.touches += usize::from(!record.touches.is_empty());
        if !record.touches.is_empty() || record.released > 0 {
            self.events.push(record);
        }
    }
}

/// Runs to the scene's end, handing each row to `emit`; returns the events.
///
/// # Errors
/// What stopped the run, in words, with the time.
pub fn run<S: Scalar>(scene: &Scene, mut emit: impl FnMut(&Row)) -> Result<Vec<EventRecord>, String> {
    let emit = |row: &Row| {
        emit(row);
        Ok(())
    };
    run_until::<S, String>(scene, emit, |_| Ok(()))
}

/// As [`run()`]; `emit`, and `stepped` with the time behind each step (or several, of a body that nobody has anything
/// to see of between rows), may end the run with a failure of their own.
///
/// # Errors
/// As [`run()`], or theirs.
pub fn run_until<S: Scalar, E: From<String>>(
    scene: &Scene,
    mut emit: impl FnMut(&Row) -> Result<(), E>,
    mut stepped: impl FnMut(f64) -> Result<(), E>,
) -> Result<Vec<EventRecord>, E> {
    let explain = |t: f64, e: BodyError<S>| format!("t = {t:.6} s: {}", describe(&e));
    let mut simulation =
        Simulation::<S>::new(&scene.lists, &scene.around, scene.method).map_err(|e| explain(0.0, e))?;
    let h = S::from_f64(scene.step);
    let ledger = open_ledger(&simulation);
    let mut watch = Watch { ledger, events: Vec::new(), touches: 0, cut_short: 0 };
    simulation.begin(h, &mut watch).map_err(|e| explain(0.0, e))?;
    let mut emit = |row: Row| {
        counted(&row)?;
        emit(&row)
    };
    emit(row(&simulation, &watch))?;
    let (steps, mut n) = (scene.steps(), 0);
    while n < steps {
        // Up to the next row, but for the last step, which has a length of its own.
        let span = (scene.every - n % scene.every).min(steps - 1 - n).min(LONGEST_SPAN);
        if span > 1 && simulation.can_march() {
            simulation.advance(h, span).map_err(|(_, e)| explain(simulation.t().to_f64(), e))?;
            n += span;
        } else {
            n += 1;
            let h = if n == steps { S::from_f64(scene.last_step()) } else { h };
            let report = simulation.step(h, &mut watch).map_err(|e| explain(simulation.t().to_f64(), e))?;
            watch.cut_short += usize::from(report.cut_short);
        }
        if n % scene.every == 0 || n == steps {
            emit(row(&simulation, &watch))?;
        }
        stepped(simulation.t().to_f64())?;
    }
    Ok(watch.events)
}

/// Refuses a row whose energies are not finite: with very large masses or springs they may overflow although positions
/// and speeds are finite.
fn counted(row: &Row) -> Result<(), String> {
    let energy = &row.energy;
    if energy.total.is_finite() && energy.imbalance.is_finite() {
        return Ok(());
    }
    let names = ["kinetic", "gravity", "spring", "pressure"];
    let which =
        names.iter().zip(energy.stored).find(|(_, e)| !e.is_finite()).map_or("total", |(name, _)| *name);
    Err(format!("t = {:.6} s: {}", row.t, no_number(which)))
}

/// The message for an energy that is not finite.
#[must_use]
pub fn no_number(energy: &str) -> String {
    format!("the {energy} energy is not finite; take smaller masses, stiffnesses or heights")
}

pub(crate) fn open_ledger<S: Scalar>(simulation: &Simulation<S>) -> Ledger<S> {
    let zero = S::ZERO;
    let start = eval_stored(&simulation.system(), simulation.pos(), simulation.vel()).total();
    Ledger { start, damping: zero, drag: zero, impact: zero, friction: zero, actuator: zero }
}

fn row<S: Scalar>(simulation: &Simulation<S>, watch: &Watch<S>) -> Row {
    let ledger = &watch.ledger;
    let energies = eval_stored(&simulation.system(), simulation.pos(), simulation.vel());
    let widen = |rows: &[[S; 3]]| rows.iter().map(|x| x.map(Scalar::to_f64)).collect();
    Row {
        t: simulation.t().to_f64(),
        pos: widen(simulation.pos()),
        vel: widen(simulation.vel()),
        ground: simulation.ground_forces(),
        energy: EnergyRow {
            stored: [energies.kinetic, energies.gravity, energies.spring, energies.pressure]
                .map(Scalar::to_f64),
            accounts: [ledger.damping, ledger.drag, ledger.impact, ledger.friction, ledger.actuator]
                .map(Scalar::to_f64),
            total: energies.total().to_f64(),
            imbalance: ledger.imbalance(&energies).to_f64(),
        },
        touches: watch.touches,
        cut_short: watch.cut_short,
    }
}
/// Header of the CSV for n points.
#[must_use]
pub fn csv_header(n: usize) -> String {
    let mut line = String::from("t");
    for i in 0..n {
        let _ = write!(line, ",x{i},y{i},z{i}");
    }
    for i in 0..n {
        let _ = write!(line, ",vx{i},vy{i},vz{i}");
    }
    line + "," + &ACCOUNTS.join(",")
}

/// One line of the CSV, 17 significant digits.
#[must_use]
pub fn csv_line(row: &Row) -> String {
    let mut line = format!("{:.16e}", row.t);
    let energy = &row.energy;
    let state = row.pos.iter().chain(&row.vel).flatten();
    let numbers =
        state.chain(&energy.stored).chain(&energy.accounts).chain([&energy.total, &energy.imbalance]);
    for x in numbers {
        let _ = write!(line, ",{x:.16e}");
    }
    line
}
