//! Attitude of a body as a unit quaternion e = (e0, e1, e2, e3) (Euler parameters), which rotates body axes to N.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Euler parameters of the rotation from N to the body; unit length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude<S> {
    scalar: S,
    vector: Vec3<S>,
}

impl<S: Scalar> Attitude<S> {
    /// Body axes along those of N.
    #[must_use]
    pub fn identity() -> Attitude<S> {
        Attitude { scalar: S::ONE, vector: vec3::zero() }
    }

    /// From Euler parameters of any length; the identity if the length is 0, NaN if it is not finite.
    #[must_use]
    pub fn new(parameters: [S; 4]) -> Attitude<S> {
        let square = squares(parameters);
        if square.is_finite() && square * S::FAR * S::FAR > S::ONE {
            return Attitude::of_length(square.sqrt(), parameters);
        }
        let largest = parameters.iter().fold(S::ZERO, |largest, e| largest.max_size(*e));
        if largest == S::ZERO {
            return Attitude::identity();
        }
        // Brings back into range what overflows or vanishes when squared.
        let parameters = parameters.map(|e| e / largest);
        Attitude::of_length(squares(parameters).sqrt(), parameters)
    }

    fn of_length(length: S, [scalar, x, y, z]: [S; 4]) -> Attitude<S> {
        Attitude { scalar: scalar / length, vector: vec3::scale([x, y, z], S::ONE / length) }
    }

    /// The attitude with exactly these [`Attitude::parameters`], bit for bit.
    #[must_use]
    pub fn restored([scalar, x, y, z]: [S; 4]) -> Attitude<S> {
        Attitude { scalar, vector: [x, y, z] }
    }

    /// e0, e1, e2, e3.
    #[must_use]
    pub fn parameters(&self) -> [S; 4] {
        let [x, y, z] = self.vector;
        [self.scalar, x, y, z]
    }

    /// The body's axes in N.
    #[must_use]
    pub fn axes(&self) -> [Vec3<S>; 3] {
        let (zero, one) = (S::ZERO, S::ONE);
        [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|axis| self.to_inertial(axis))
    }

    /// Components in N of a vector given in body axes.
    #[must_use]
    pub fn to_inertial(&self, a: Vec3<S>) -> Vec3<S> {
        self.rotate(self.vector, a)
    }

    /// Components in body axes of a vector given in N.
    #[must_use]
    pub fn to_body(&self, a: Vec3<S>) -> Vec3<S> {
        self.rotate(vec3::scale(self.vector, -S::ONE), a)
    }

    /// Rotates a: a + 2 e x (e x a + e0 a).
    fn rotate(&self, e: Vec3<S>, a: Vec3<S>) -> Vec3<S> {
        let inner = vec3::axpy(vec3::cross(e, a), self.scalar, a);
        vec3::axpy(a, S::from_f64(2.0), vec3::cross(e, inner))
    }

    /// This rotation followed by Cayley's rotation (I - \[w\])^-1 (I + \[w\]) about w in body axes, |w| = tan(angle/2).
    #[must_use]
    pub fn turned(&self, w: Vec3<S>) -> Attitude<S> {
        let scalar = self.scalar - vec3::dot(self.vector, w);
        let vector = vec3::add(vec3::axpy(self.vector, self.scalar, w), vec3::cross(self.vector, w));
        let [x, y, z] = vector;
        Attitude::new([scalar, x, y, z])
    }
}

/// Sum of the squares of four numbers.
fn squares<S: Scalar>([scalar, x, y, z]: [S; 4]) -> S {
    scalar * scalar + vec3::dot([x, y, z], [x, y, z])
}
