//! The largest step that resolves the fastest motion of flexible parts, and of the carriers that hold their nodes.
//!
//! In: a world at its start. Out: the step, or the part for which the scene's step is too large. A carrier moves on the
//! springs of its nodes with all free nodes at rest, the nodes move with all carriers at rest; the squared frequency of
//! both together is at most the sum (`contact/stable_step.rs` of the runtime). Without attachments to what moves, each
//! flexible part is judged alone.

use super::{CarriedWorld, Place, words};
use crate::failure::Failure;
use crate::world::assembly::{Assembly, Kind};
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_codegen::source::Span;
use smartbed_runtime::contact::System;
use smartbed_runtime::contact::stable_step::{Sums, largest_stable_step, largest_step_beside, stable_step};
use smartbed_runtime::flexible::Body;
use smartbed_runtime::flexible::element::{Bond, Element};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::Carrier;
use std::ops::Range;

/// Steps of the power iteration.
const ITERATIONS: usize = 200;

/// Wrench on a port about its origin by a small motion of it.
type Hold = [[f64; 6]; 6];

/// A carrier on the springs of the nodes that it holds.
struct Held {
    /// Number of the carrier.
    number: usize,
    ports: Range<usize>,
    /// A quarter of the largest eigenvalues of M^-1 K (1/s^2) and M^-1 C (1/s).
    rates: [f64; 2],
    /// By node: do springs join it to a node that the carrier holds?
    bonded: Vec<bool>,
}

impl Held {
    /// The largest step that resolves its motion while all free nodes are at rest.
    fn step(&self) -> Option<f64> {
        stable_step(1.0, self.rates)
    }
}

impl CarriedWorld {
    /// The largest step that resolves the fastest motion of every flexible part and of what holds it; refuses the
    /// scene's step if that is larger.
    pub(super) fn stable_step(&mut self, assembly: &Assembly) -> Result<Option<f64>, Failure> {
        let held = self.held_by_springs().map_err(words)?;
        let mut stable: Option<f64> = None;
        let mut judge = |largest: Option<f64>, (who, part): (&str, &str)| {
            let Some(largest) = largest else { return Ok(()) };
            refuse_larger(assembly, (largest, who), assembly.places.part(part, "K"))?;
            stable = Some(stable.map_or(largest, |least| least.min(largest)));
            Ok::<(), Failure>(())
        };
        for (part, place) in assembly.parts.iter().zip(&self.places) {
            let (Kind::Flexible(body), Place::Nodes(nodes, ..)) = (&part.kind, place) else { continue };
            let (lists, springs) = (&body.lists, body.lists.elements(0).collect::<Vec<_>>());
            let (mass, fixed) = (&lists.masses, &lists.fixed);
            let air_drag = self.fixed.air_drag;
            let alone = Body { mass, fixed, springs: &springs, air_drag, ..Body::<f64>::none() };
            let alone = Body::new(alone)
                .map_err(|e| format!("`{}`: {}", part.name, crate::scene::describe::describe(&e)))?;
            let (system, mut sums) = (System::new(alone, None), vec![Sums::none(); mass.len()]);
            judge(
                largest_stable_step(&system, &lists.points, &lists.velocities, &mut sums),
                (&format!("`{}`", part.name), &part.name),
            )?;
            let holds = |carrier: &&Held| {
                let mut all = self.fixed.attachments.iter();
                all.any(|own| nodes.contains(&own.node) && carrier.ports.contains(&own.port))
            };
            for carrier in held.iter().filter(holds) {
                let beside = |node: usize| match carrier.bonded[nodes.start + node] {
                    true => carrier.rates,
                    false => [0.0; 2],
                };
                let who =
                    format!("`{}`, which holds nodes of `{}`", self.carrier_name(carrier.number), part.name);
                judge(carrier.step(), (&who, &part.name))?;
                judge(largest_step_beside(&system, &sums, beside), (&who, &part.name))?;
            }
        }
        Ok(stable)
    }

    /// The carriers that can move and hold nodes.
    fn held_by_springs(&mut self) -> Result<Vec<Held>, Fault> {
        let x = self.x.clone();
        let [all_q, all_u] = self.of_carriers(&x);
        let mut found = Vec::new();
        for (number, [q, u, port]) in self.carrier_starts().into_iter().enumerate() {
            let ports = port..port + self.carriers[number].n_ports();
            let is_held = self.fixed.attachments.iter().any(|own| ports.contains(&own.port));
            if self.carriers[number].n_u() == 0 || !is_held {
                continue;
            }
            let (stiffness, damping, bonded) = self.holds_on(&ports);
            let own = &mut self.carriers[number];
            let (q, u) = (&all_q[q..q + own.n_q()], &all_u[u..u + own.n_u()]);
            let mut inverse = vec![vec![0.0; 6 * ports.len()]; 6 * ports.len()];
            for (seen, at) in (0..ports.len()).flat_map(|seen| (0..ports.len()).map(move |at| (seen, at))) {
                for (row, entries) in own.inverse_inertia(0.0, q, u, [seen, at])?.iter().enumerate() {
                    inverse[6 * seen + row][6 * at..6 * at + 6].copy_from_slice(entries);
                }
            }
            let rates = [stiffness, damping].map(|holds| 0.25 * largest_eigenvalue(&inverse, &holds));
            found.push(Held { number, rates, ports, bonded });
        }
        Ok(found)
    }

    /// Stiffness and damping of the springs of attached nodes on each of these ports, all that these springs lead to at
    /// rest, and which nodes that is.
    fn holds_on(&self, ports: &Range<usize>) -> (Vec<Hold>, Vec<Hold>, Vec<bool>) {
        let none = [[0.0; 6]; 6];
        let (mut stiffness, mut damping) = (vec![none; ports.len()], vec![none; ports.len()]);
        let (pos, frames) = (&self.room.pos, &self.room.frames);
        let [still, _] = self.immovable();
        let mut port_of = vec![None; pos.len()];
        self.fixed.attachments.iter().for_each(|own| port_of[own.node] = Some(own.port));
        let mut bonded = vec![false; pos.len()];
        self.fixed.body(&[]).elements().each_bond(pos, &mut |bond: Bond<f64>| {
            let [tail, head] = bond.ends;
            for (node, other) in [(tail, head), (head, tail)] {
                let Some(port) = port_of[node].filter(|port| ports.contains(port)) else { continue };
                // Springs between nodes of one port are carried along.
                if port_of[other] == Some(port) {
                    continue;
                }
                bonded[other] = true;
                // (a - b)^2 <= 2 a^2 + 2 b^2 where carriers move both ends.
                let share = if port_of[other].is_some_and(|port| !still[port]) { 2.0 } else { 1.0 };
                let arm = vec3::sub(pos[node], frames[port].origin);
                // Tension of a spring that pulls outwards turns its arm back.
                let turning = (bond.across * vec3::dot(vec3::sub(pos[other], pos[node]), arm)).max(0.0);
                let own = port - ports.start;
                add(
                    &mut stiffness[own],
                    arm,
                    (bond.direction, share),
                    [bond.stiffness, bond.across, turning],
                );
                add(&mut damping[own], arm, (bond.direction, share), [bond.damping, 0.0, 0.0]);
            }
        });
        for attachment in self.fixed.attachments.iter().filter(|own| ports.contains(&own.port)) {
            let arm = vec3::sub(pos[attachment.node], frames[attachment.port].origin);
            add(
                &mut damping[attachment.port - ports.start],
                arm,
                (None, 1.0),
                [self.fixed.air_drag, 0.0, 0.0],
            );
        }
        (stiffness, damping, bonded)
    }

    /// The name of a carrier's part.
    fn carrier_name(&self, number: usize) -> &str {
        let is_it = |place: &Place| matches!(place, Place::Carrier(own, _) if *own == number);
        let part = self.places.iter().position(is_it);
        part.map_or("", |part| &self.names[part])
    }
}

/// Refuses the scene's step if it is larger than this one, because of what stands at a place.
pub(super) fn refuse_larger(
    assembly: &Assembly,
    (largest, who): (f64, &str),
    place: Span,
) -> Result<(), Failure> {
    if assembly.run.step <= largest {
        return Ok(());
    }
    let error = Diagnostic::error(format!(
        "run.step = {} s is larger than the largest stable step of {who}, {largest:.3e} s",
        assembly.run.step
    ));
    // A scene that says no step takes that of every scene, which stands nowhere.
    let step = assembly.places.key(&["run", "step"]);
    let error = if step == Span::default() { error } else { error.label(step, "this step") };
    let error = error.label(place, "too stiff, or damped too strongly, for it");
    Err(assembly.places.failure(error.help("take a smaller `step` under [run]")))
}

/// Adds a spring at the end of an arm, with stiffnesses along and across its direction and one against turning; without
/// a direction it acts in all.
fn add(
    hold: &mut Hold,
    arm: Vec3<f64>,
    (direction, share): (Option<Vec3<f64>>, f64),
    [along, across, turning]: [f64; 3],
) {
    let unit = |axis: usize| std::array::from_fn(|k| f64::from(u8::from(k == axis)));
    // Motions of the arm's end by unit motions of the port.
    let ways: [Vec3<f64>; 6] =
        std::array::from_fn(|k| if k < 3 { unit(k) } else { vec3::cross(unit(k - 3), arm) });
    for (row, a) in hold.iter_mut().zip(&ways) {
        for (entry, b) in row.iter_mut().zip(&ways) {
            let all = vec3::dot(*a, *b);
            let dyad = direction.map_or(all, |d| vec3::dot(*a, d) * vec3::dot(*b, d));
            *entry += share * ((along - across) * dyad + across * all);
        }
    }
    (3..6).for_each(|k| hold[k][k] += share * turning);
}

/// Largest eigenvalue of M^-1 K, with K by port, by power iteration with Rayleigh's quotient of K^1/2 M^-1 K^1/2.
fn largest_eigenvalue(inverse: &[Vec<f64>], holds: &[Hold]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // No symmetry of a shape is that of this start.
    let mut way: Vec<f64> = (0..inverse.len()).map(|k| (1.0 + k as f64).sin()).collect();
    let mut largest = 0.0;
    for _ in 0..ITERATIONS {
        let pull: Vec<f64> =
            holds.iter().zip(way.chunks(6)).flat_map(|(hold, own)| hold.map(|row| dot(&row, own))).collect();
        let next: Vec<f64> = inverse.iter().map(|row| dot(row, &pull)).collect();
        let quotient = dot(&next, &pull) / dot(&way, &pull);
        // Nothing holds it, or it does not give way.
        if !(quotient.is_finite() && quotient > 0.0) {
            break;
        }
        largest = quotient;
        let length = dot(&next, &next).sqrt();
        way = next.iter().map(|x| x / length).collect();
    }
    largest
}
