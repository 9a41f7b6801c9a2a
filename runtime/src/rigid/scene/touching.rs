//! A feature of a pair that touches, as a contact.

use crate::real::Scalar;
use crate::rigid::contact::Contact;
use crate::rigid::hold::Held;
use crate::vec3::{self, Vec3};

/// A feature that touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touching<S> {
    /// Number of its pair.
    pub pair: usize,
    /// Number of the feature within the pair.
    pub id: u32,
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
        Touching { pair: 0, id: 0, gap: S::ZERO, velocity: zero, held }
    }

    /// Whether it is this feature.
    pub(super) fn is(&self, pair: usize, id: u32) -> bool {
        self.pair == pair && self.id == id
    }

    /// Direction of slip in N; zero where the contact sticks.
    pub(super) fn slip(&self) -> Vec3<S> {
        let [x, y] = self.held.slip.map_or([S::ZERO; 2], |slip| slip.direction);
        self.held.contact.to_inertial([S::ZERO, x, y])
    }
}
