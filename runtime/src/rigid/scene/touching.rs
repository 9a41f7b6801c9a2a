//! A feature of a pair that touches, as a contact.

use crate::real::Scalar;
use crate::rigid::contact::Contact;
use crate::rigid::hold::Held;
use crate::vec3::{self, Vec3};

/// Least cosine of the angle by which a contact's normal turns within a piece of a step. One that turns further has
/// passed from one face to another, and the piece ends there.
pub(crate) const TURN: f64 = 0.8;

/// A feature that touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touching<S> {
    /// Number of its pair.
    pub pair: usize,
    /// Number of the feature within the pair.
    pub id: u32,
    /// In how many directions the surface below is curved.
    pub(super) curved: u8,
    /// Gap (m).
    pub gap: S,
    /// Relative velocity n, t1, t2 (m/s).
    pub velocity: Vec3<S>,
    /// Contact geometry and force.
    pub held: Held<S>,
}

impl<S> AsMut<Held<S>> for Touching<S> {
    fn as_mut(&mut self) -> &mut Held<S> {
        &mut self.held
    }
}

impl<S: Scalar> Touching<S> {
    /// An empty entry of a list.
    #[must_use]
    pub fn empty() -> Touching<S> {
        let zero = vec3::zero();
        let contact = Contact::new([0, 0], zero, [S::ZERO, S::ZERO, S::ONE], [zero; 2]);
        let held = Held::new(contact, [zero; 3], zero);
        Touching { pair: 0, id: 0, curved: 0, gap: S::ZERO, velocity: zero, held }
    }

    /// Whether it is this feature.
    pub(super) fn is(&self, pair: usize, id: u32) -> bool {
        self.pair == pair && self.id == id
    }

    /// Whether it is this feature and has passed neither to another face nor from a face to an edge or an end.
    pub(super) fn stays(&self, pair: usize, feature: (u32, u8, Vec3<S>)) -> bool {
        let (id, curved, normal) = feature;
        let turned = vec3::dot(normal, self.held.contact.axes[0]) < S::from_f64(TURN);
        self.is(pair, id) && self.curved == curved && !turned
    }

    /// The same, for a feature that was detected elsewhere.
    pub(super) fn stays_as(&self, other: &Touching<S>) -> bool {
        self.stays(other.pair, (other.id, other.curved, other.held.contact.axes[0]))
    }

    /// Direction of slip in N; zero where the contact sticks.
    pub(super) fn slip(&self) -> Vec3<S> {
        let [x, y] = self.held.slip.map_or([S::ZERO; 2], |slip| slip.direction);
        self.held.contact.to_inertial([S::ZERO, x, y])
    }
}
