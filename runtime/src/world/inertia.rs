//! Inverse inertia of ports and nodes: their velocity changes under impulses; ports of one mechanism move one another.
//!
//! Bodies that contacts refer to are numbered: first the ports, then the nodes. A port responds by J M^-1 J' (6 x 6), a
//! node by 1/m. Attached and fixed nodes are no bodies of their own: in a contact's side they are points of a port, or
//! nothing.

use super::carrier::{Carrier, InverseInertia};
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::rigid::contact::{Inertia, Point, Twist};
use crate::vec3::{self, Vec3};

/// Where a port's responses begin in the list, and which ports they are about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coupling {
    /// The first port that an impulse here moves, and how many.
    ports: [usize; 2],
    /// Index of the first response.
    first: usize,
}

/// Inverse inertia of all bodies of an island, in memory lent by the caller.
#[derive(Debug)]
pub struct Inertias<'a, S> {
    /// One entry per port.
    pub couplings: &'a mut [Coupling],
    /// One entry per ordered pair of ports that move one another: see [`Inertias::answers`].
    pub answers: &'a mut [InverseInertia<S>],
    /// 1/m (1/kg), one entry per node.
    pub nodes: &'a mut [S],
}

impl<S: Scalar> Inertias<'_, S> {
    /// Number of responses that a carrier's ports have.
    #[must_use]
    pub fn answers(carrier: &impl Carrier<S>) -> usize {
        (0..carrier.n_ports()).map(|port| carrier.coupled(port).len()).sum()
    }

    /// Asks the carrier at a state for the responses to impulses at those ports that are needed.
    ///
    /// # Errors
    /// [`Fault::Shape`] where memory is too small; the carrier's faults.
    pub fn ask(
        &mut self,
        carrier: &mut impl Carrier<S>,
        t: S,
        (q, u): (&[S], &[S]),
        needed: impl Fn(usize) -> bool,
    ) -> Result<(), Fault> {
        let mut place = 0;
        for (port, coupling) in self.couplings.iter_mut().enumerate() {
            let moved = if needed(port) { carrier.coupled(port) } else { 0..0 };
            *coupling = Coupling { ports: [moved.start, moved.len()], first: place };
            for seen in moved {
                let answer = self.answers.get_mut(place).ok_or(Fault::Shape)?;
                *answer = carrier.inverse_inertia(t, q, u, [seen, port])?;
                place += 1;
            }
        }
        Ok(())
    }

    /// The ports that an impulse at this port moves, with their responses.
    fn answers_of(&self, port: usize) -> impl Iterator<Item = (usize, &InverseInertia<S>)> {
        let Coupling { ports: [start, count], first } = self.couplings.get(port).copied().unwrap_or_default();
        (start..start + count).zip(self.answers.iter().skip(first))
    }
}

/// Change of velocity and angular velocity by an impulse at this arm.
fn apply<S: Scalar>(answer: &InverseInertia<S>, arm: Vec3<S>, impulse: Vec3<S>) -> Twist<S> {
    let ([a, b, c], [x, y, z]) = (impulse, vec3::cross(arm, impulse));
    let wrench = [a, b, c, x, y, z];
    let [vx, vy, vz, wx, wy, wz] =
        answer.map(|row| row.iter().zip(wrench).fold(S::ZERO, |sum, (entry, part)| sum + *entry * part));
    Twist { velocity: [vx, vy, vz], angular: [wx, wy, wz] }
}

impl<S: Scalar> Inertia<S> for Inertias<'_, S> {
    fn response(&self, at: &Point<S>, impulse: Vec3<S>, seen: &Point<S>) -> Vec3<S> {
        let ports = self.couplings.len();
        if at.body >= ports {
            let yields = self.nodes.get(at.body - ports).filter(|_| at.body == seen.body);
            return vec3::scale(impulse, yields.copied().unwrap_or(S::ZERO));
        }
        let answer = self.answers_of(at.body).find(|(port, _)| *port == seen.body);
        answer.map_or(vec3::zero(), |(_, answer)| apply(answer, at.arm, impulse).at(seen.arm))
    }

    fn push(&self, at: &Point<S>, impulse: Vec3<S>, twists: &mut [Twist<S>]) {
        let ports = self.couplings.len();
        if at.body >= ports {
            let yields = self.nodes.get(at.body - ports).copied().unwrap_or(S::ZERO);
            if let Some(twist) = twists.get_mut(at.body) {
                twist.velocity = vec3::axpy(twist.velocity, yields, impulse);
            }
            return;
        }
        for (port, answer) in self.answers_of(at.body) {
            if let Some(twist) = twists.get_mut(port) {
                let change = apply(answer, at.arm, impulse);
                twist.velocity = vec3::add(twist.velocity, change.velocity);
                twist.angular = vec3::add(twist.angular, change.angular);
            }
        }
    }
}
