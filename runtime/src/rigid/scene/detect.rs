//! Lists the features of all pairs that touch, with the data that the solvers need.

use super::parts::{Fault, RigidScene};
use super::touching::Touching;
use crate::real::Scalar;
use crate::rigid::RigidState;
use crate::rigid::contact::{Contact, Mobility, Twist};
use crate::rigid::hold::Held;
use crate::rigid::narrow::{Feature, Placed, features};
use crate::vec3;

impl<S: Scalar> RigidScene<'_, S> {
    /// Fills `touching` with the features within `margin` that `wanted` keeps, and computes velocities and inverse
    /// inertia of the parts; returns the number of features.
    pub(super) fn detect(
        &self,
        states: &[RigidState<S>],
        twists: &mut [Twist<S>],
        mobilities: &mut [Mobility<S>],
        touching: &mut [Touching<S>],
        margin: S,
        wanted: impl Fn(&Touching<S>) -> bool,
    ) -> Result<usize, Fault> {
        self.read_twists(states, twists);
        for ((part, state), mobility) in self.parts.iter().zip(states).zip(mobilities.iter_mut()) {
            *mobility = part.body.map_or_else(Mobility::fixed, |body| Mobility::of(&body, state));
        }
        let (mut count, mut full) = (0, false);
        self.visit(states, margin, |pair, feature| {
            let found = self.touching(pair, feature, states, twists, mobilities);
            if wanted(&found) {
                match touching.get_mut(count) {
                    Some(place) => (*place, count) = (found, count + 1),
                    None => full = true,
                }
            }
        });
        if full { Err(Fault::TooManyContacts) } else { Ok(count) }
    }

    /// Copies the velocities of the parts.
    pub(super) fn read_twists(&self, states: &[RigidState<S>], twists: &mut [Twist<S>]) {
        for ((part, state), twist) in self.parts.iter().zip(states).zip(twists) {
            *twist = part.body.map_or_else(Twist::zero, |body| Twist {
                velocity: state.velocity,
                angular: body.angular_velocity(state),
            });
        }
    }

    /// Shows every feature of every pair within `margin`.
    pub(super) fn visit(
        &self,
        states: &[RigidState<S>],
        margin: S,
        mut show: impl FnMut(usize, &Feature<S>),
    ) {
        for (number, pair) in self.pairs.iter().enumerate() {
            let [Some((a, x)), Some((b, y))] = pair.parts.map(|k| self.parts.get(k).zip(states.get(k)))
            else {
                continue;
            };
            let (one, other) = (a.frame(x), b.frame(y));
            let found = features(
                Placed { shape: &a.shape, frame: &one },
                Placed { shape: &b.shape, frame: &other },
                margin,
            );
            found.iter().for_each(|feature| show(number, &feature));
        }
    }

    fn touching(
        &self,
        number: usize,
        feature: &Feature<S>,
        states: &[RigidState<S>],
        twists: &[Twist<S>],
        mobilities: &[Mobility<S>],
    ) -> Touching<S> {
        let Some(pair) = self.pairs.get(number) else { return Touching::empty() };
        let center = |k: usize| states.get(k).map_or_else(vec3::zero, |s| s.position);
        let mut contact = Contact::new(pair.parts, feature.point, feature.normal, pair.parts.map(center));
        (contact.friction, contact.restitution) = (pair.law.friction(), pair.law.restitution());
        let velocity = contact.relative(twists);
        // omega x r' of both bodies, r' the velocity of the contact point relative to each centre of mass.
        let [mine, others] = pair.parts.map(|k| {
            let twist = twists.get(k).copied().unwrap_or_else(Twist::zero);
            vec3::cross(twist.angular, vec3::sub(feature.point_rate, twist.velocity))
        });
        let mut bias = vec3::apply(&contact.axes, vec3::sub(mine, others));
        bias[0] = bias[0] + vec3::dot(feature.normal_rate, contact.to_inertial(velocity));
        let held = Held::new(contact, contact.inverse_mass(mobilities), bias);
        Touching { pair: number, id: feature.id, curved: feature.curved, gap: feature.gap, velocity, held }
    }
}
