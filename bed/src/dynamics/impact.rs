//! Impacts of a sheet's nodes on a body, with energy compensation along the sheet's springs.
//!
//! In: the nodes of one sheet that will touch within a stage, velocities at its start. Out: velocities after the
//! impact. Tissue is a massless layer on a rigid core, so that node and core collide: their approach ends, and the
//! energy that this takes goes into neighbours of those nodes that touch nothing (energy compensation; `world::Setting`
//! of the runtime has the law and its roots). All nodes of one sheet that touch within a stage are treated as
//! simultaneous.

use crate::band::Band;
use crate::body::{Body, lever};
use crate::equilibrium::Touch;
use crate::equilibrium::increment::points;
use crate::method::Track;
use crate::pose::Pose;
use crate::sheet::Lattice;
use smartbed_runtime::flexible::{self, Spring};
use smartbed_runtime::rigid::contact::{Contact, Inertia, Point, Side, Twist};
use smartbed_runtime::rigid::law::Kind;
use smartbed_runtime::rigid::plastic::stop;
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::vec3::{Vec3, add, cross, dot, scale, sub};
use smartbed_runtime::world::{Setting, Spare};
use std::collections::BTreeMap;

/// Inverse inertia of segments and nodes; segments come first.
pub struct Yields {
    /// By segment: the twist about its origin per unit of impulse and angular impulse, in its free directions.
    segments: Vec<[[f64; 6]; 6]>,
    /// Masses of the segments (kg).
    masses: Vec<f64>,
    /// Inverse mass of a node (1/kg).
    node: f64,
}

/// Effects of impacts.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Blow {
    /// Number of nodes that touched.
    pub touches: usize,
    /// Energy (J) that they lost and their neighbours received.
    pub handed_on: f64,
    /// Upward impulse on segments (N s).
    pub upwards: f64,
}

impl Blow {
    /// The sum of both.
    #[must_use]
    pub fn and(self, other: Blow) -> Blow {
        Blow {
            touches: self.touches + other.touches,
            handed_on: self.handed_on + other.handed_on,
            upwards: self.upwards + other.upwards,
        }
    }
}

/// A sheet at the start of a stage.
pub struct Sheet<'a> {
    /// Springs.
    pub lattice: &'a Lattice,
    /// By node: does it touch nothing, so that it may receive energy?
    pub is_free: &'a [bool],
    /// Length of the stage (s).
    pub seconds: f64,
    /// Length of the stage before (s).
    pub last: f64,
    /// Share of a velocity difference along a spring that its damper leaves at the end of the stage. Needed because a
    /// stage longer than the damper's time constant would take a decaying velocity for a lasting one.
    pub lasting: f64,
}

impl Yields {
    /// For a body at these poses, and nodes of a mass (kg).
    pub fn new(body: &Body, poses: &[Pose], node: f64) -> Yields {
        let of = |(segment, pose): (&crate::body::Segment, &Pose)| {
            let mut mass = Band::new(6, 6);
            let arms = points(segment, pose).map(|p| lever(sub(p, pose.place)));
            for i in 0..6 {
                for j in i..6 {
                    let is_free = segment.free[i] && segment.free[j];
                    let sum: f64 = arms.iter().map(|ways| dot(ways[i], ways[j])).sum();
                    let held = if i == j { 1.0 } else { 0.0 };
                    mass.add(i, j, if is_free { segment.mass / 6.0 * sum } else { held });
                }
            }
            let factor = mass.factor();
            std::array::from_fn(|i| {
                let mut row = [0.0; 6];
                row[i] = 1.0;
                match &factor {
                    Some(factor) if segment.free[i] => factor.solve(&mut row),
                    // What is held, or has no mass, does not yield.
                    _ => row[i] = 0.0,
                }
                row
            })
        };
        let masses = body.segments.iter().map(|s| s.mass).collect();
        Yields { segments: body.segments.iter().zip(poses).map(of).collect(), masses, node: 1.0 / node }
    }

    /// The twist of a segment with this momentum and angular momentum about its origin.
    fn twist(&self, segment: usize, momentum: [f64; 6]) -> Twist<f64> {
        let rows = self.segments[segment];
        let of = |i: usize| rows[i].iter().zip(momentum).map(|(y, p)| y * p).sum();
        Twist { velocity: [of(0), of(1), of(2)], angular: [of(3), of(4), of(5)] }
    }

    /// The twist of a segment, from the momentum of its six points.
    fn moving(&self, segment: usize, pose: &Pose, tracks: &[Track; 6]) -> Twist<f64> {
        let mut momentum = [0.0; 6];
        for track in tracks {
            let ways = lever(sub(track.place, pose.place));
            let speeds = ways.map(|way| dot(way, track.velocity));
            momentum.iter_mut().zip(speeds).for_each(|(p, v)| *p += self.masses[segment] / 6.0 * v);
        }
        self.twist(segment, momentum)
    }

    /// The change of twist due to an impulse at a point.
    fn change(&self, at: &Point<f64>, impulse: Vec3<f64>) -> Twist<f64> {
        if at.body < self.segments.len() {
            let [x, y, z] = impulse;
            let [a, b, c] = cross(at.arm, impulse);
            self.twist(at.body, [x, y, z, a, b, c])
        } else {
            Twist { velocity: scale(impulse, self.node), angular: [0.0; 3] }
        }
    }
}

impl Inertia<f64> for Yields {
    fn response(&self, at: &Point<f64>, impulse: Vec3<f64>, seen: &Point<f64>) -> Vec3<f64> {
        if at.body == seen.body { self.change(at, impulse).at(seen.arm) } else { [0.0; 3] }
    }

    fn push(&self, at: &Point<f64>, impulse: Vec3<f64>, twists: &mut [Twist<f64>]) {
        let change = self.change(at, impulse);
        let twist = &mut twists[at.body];
        twist.velocity = add(twist.velocity, change.velocity);
        twist.angular = add(twist.angular, change.angular);
    }
}

/// Resolves the impacts of nodes that will touch; pairs that are not approaching are left alone.
pub fn strike(
    sheet: &Sheet,
    yields: &Yields,
    touches: &[Touch],
    poses: &[Pose],
    nodes: &mut [Track],
    segments: &mut [[Track; 6]],
) -> Blow {
    let mut twists: Vec<Twist<f64>> =
        (0..poses.len()).map(|s| yields.moving(s, &poses[s], &segments[s])).collect();
    let approach = |t: &Touch| {
        let at = &nodes[t.node];
        let core = twists[t.segment].at(sub(at.place, poses[t.segment].place));
        dot(t.normal, sub(core, at.velocity))
    };
    // The time of touch follows from the depth at the end of the stage and the approach speed.
    let touches: Vec<(&Touch, f64)> = touches.iter().map(|t| (t, approach(t))).collect();
    let touches: Vec<(&Touch, f64)> = touches.into_iter().filter(|(_, speed)| *speed > 0.0).collect();
    if touches.is_empty() {
        return Blow::default();
    }
    let ahead = |(touch, speed): &(&Touch, f64)| (sheet.seconds - touch.depth / speed).max(0.0);
    let party = Party::new(sheet, touches.iter().map(|(t, _)| t.node));
    twists.extend(party.nodes.iter().map(|n| Twist { velocity: nodes[*n].velocity, angular: [0.0; 3] }));
    let places: Vec<Vec3<f64>> = party.nodes.iter().map(|n| nodes[*n].place).collect();
    let contact = |(touch, _): &(&Touch, f64)| {
        let node = party.numbers[&touch.node];
        let arm = sub(places[node], poses[touch.segment].place);
        let sides = [Side::of_body(poses.len() + node, [0.0; 3]), Side::of_body(touch.segment, arm)];
        Struck::new(Contact::between(sides, touch.normal), yields)
    };
    let mut struck: Vec<Struck<f64>> = touches.iter().map(contact).collect();
    let before = twists.clone();
    let handed_on = taken(&struck, yields, &before);
    party.strike(&places, yields, sheet.lasting, &mut struck, &mut twists);
    let mean = touches.iter().map(ahead).sum::<f64>() / touches.len() as f64;
    let mut times = vec![mean; party.nodes.len()];
    touches.iter().for_each(|touch| times[party.numbers[&touch.0.node]] = ahead(touch));
    for (body, (now, was)) in twists.iter().zip(&before).enumerate() {
        let gain =
            Twist { velocity: sub(now.velocity, was.velocity), angular: sub(now.angular, was.angular) };
        if let Some(own) = segments.get_mut(body) {
            let arms = own.map(|t| sub(t.place, poses[body].place));
            own.iter_mut().zip(arms).for_each(|(t, arm)| *t = t.struck(gain.at(arm), mean, sheet.last));
        } else {
            let number = body - poses.len();
            let node = &mut nodes[party.nodes[number]];
            *node = node.struck(gain.velocity, times[number], sheet.last);
        }
    }
    let upwards = struck.iter().map(|s| -s.contact.impulse[0] * s.contact.axes[0][2]).sum();
    Blow { touches: touches.len(), handed_on, upwards }
}

/// Energy (J) that is lost when the approach ends.
fn taken(struck: &[Struck<f64>], yields: &Yields, twists: &[Twist<f64>]) -> f64 {
    let (mut struck, mut after) = (struck.to_vec(), twists.to_vec());
    stop(&mut struck, yields, &mut after);
    let of = |s: &Struck<f64>| {
        let rates = s.contact.relative(twists)[0] + s.contact.relative(&after)[0];
        -0.5 * s.contact.impulse[0] * rates
    };
    struck.iter().map(of).sum()
}

/// The nodes that touch and those that may receive energy, with the springs between them.
struct Party {
    /// Indices in the sheet.
    nodes: Vec<usize>,
    /// Index in `nodes`, by index in the sheet.
    numbers: BTreeMap<usize, usize>,
    springs: Vec<Spring<f64>>,
}

impl Party {
    fn new(sheet: &Sheet, touching: impl Iterator<Item = usize>) -> Party {
        let mut party = Party { nodes: Vec::new(), numbers: BTreeMap::new(), springs: Vec::new() };
        touching.for_each(|node| _ = party.number(node));
        let count = party.nodes.len();
        let is_struck = |party: &Party, node: usize| party.numbers.get(&node).is_some_and(|n| *n < count);
        for spring in &sheet.lattice.springs {
            for [i, k] in [spring.ends, [spring.ends[1], spring.ends[0]]] {
                if is_struck(&party, i) && !is_struck(&party, k) && sheet.is_free[k] {
                    let [tail, head] = [i, k].map(|node| party.number(node));
                    // The law uses only the direction of a spring.
                    party.springs.push(Spring { tail, head, stiffness: 0.0, damping: 0.0, rest_length: 0.0 });
                }
            }
        }
        party
    }

    fn number(&mut self, node: usize) -> usize {
        let next = self.nodes.len();
        let number = *self.numbers.entry(node).or_insert(next);
        if number == next {
            self.nodes.push(node);
        }
        number
    }

    /// Resolves the impacts with energy compensation for this share.
    fn strike(
        &self,
        places: &[Vec3<f64>],
        yields: &Yields,
        lasting: f64,
        struck: &mut [Struck<f64>],
        twists: &mut [Twist<f64>],
    ) {
        let (mass, fixed) = (vec![1.0 / yields.node; self.nodes.len()], vec![false; self.nodes.len()]);
        let body =
            flexible::Body { mass: &mass, fixed: &fixed, springs: &self.springs, ..flexible::Body::none() };
        let setting = Setting { body: &body, pos: places, ports: yields.segments.len(), inertia: yields };
        let (mut lifts, mut field, mut before) = (struck.to_vec(), twists.to_vec(), twists.to_vec());
        let mut spare = Spare { lifts: &mut lifts, twists: [&mut field, &mut before] };
        // Sweeps that end early remove energy and create none.
        _ = setting.strike(struck, Some((Kind::Compensation, lasting.sqrt())), twists, &mut spare);
    }
}
