//! One free body in maximal coordinates: pose, twist and acceleration, all in the inertial frame.
//!
//! A vector b fixed in the body has b' = w x b and b'' = alpha x b + w x (w x b); everything else
//! about constraints follows from jets.

use super::jet::JetVector;
use nalgebra::{Matrix3, Vector3};

/// What a body is and what acts on it besides the joints.
#[derive(Clone, Debug)]
pub struct Body {
    /// Mass that weighs and resists (kg).
    pub mass: f64,
    /// Mass that resists but does not weigh (reflected inertia) (kg).
    pub added_mass: f64,
    /// Inertia about the mass centre in the body's frame (kg m^2); none for a particle.
    pub inertia: Option<Matrix3<f64>>,
    /// Force at the mass centre, weight excluded (N).
    pub force: Vector3<f64>,
    /// Torque (N m).
    pub torque: Vector3<f64>,
}

impl Body {
    /// A particle without force.
    #[must_use]
    pub fn particle(mass: f64) -> Self {
        Self { mass, added_mass: 0.0, inertia: None, force: Vector3::zeros(), torque: Vector3::zeros() }
    }

    /// A rigid body without force or torque.
    #[must_use]
    pub fn rigid(mass: f64, inertia: Matrix3<f64>) -> Self {
        Self { inertia: Some(inertia), ..Self::particle(mass) }
    }

    /// Velocity unknowns: 3 for a particle, 6 for a rigid body.
    #[must_use]
    pub fn n_dof(&self) -> usize {
        if self.inertia.is_some() { 6 } else { 3 }
    }
}

/// Where a body is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pose {
    /// Mass centre (m).
    pub centre: Vector3<f64>,
    /// Rotation from the body's frame to the inertial frame.
    pub rotation: Matrix3<f64>,
}

impl Pose {
    /// A particle's pose: no orientation.
    #[must_use]
    pub fn at(centre: Vector3<f64>) -> Self {
        Self { centre, rotation: Matrix3::identity() }
    }
}

/// Linear and angular part of a velocity or an acceleration, in the inertial frame.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Twist {
    /// Of the mass centre.
    pub linear: Vector3<f64>,
    /// Of the body.
    pub angular: Vector3<f64>,
}

impl Twist {
    /// At rest.
    #[must_use]
    pub fn zero() -> Self {
        Self { linear: Vector3::zeros(), angular: Vector3::zeros() }
    }
}

/// A body in motion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Moving {
    /// Where it is.
    pub pose: Pose,
    /// How fast it moves.
    pub velocity: Twist,
    /// How its velocity changes.
    pub acceleration: Twist,
}

impl Moving {
    /// A body that stands still.
    #[must_use]
    pub fn at_rest(pose: Pose) -> Self {
        Self { pose, velocity: Twist::zero(), acceleration: Twist::zero() }
    }

    /// The mass centre.
    #[must_use]
    pub fn centre(&self) -> JetVector {
        JetVector { value: self.pose.centre, rate: self.velocity.linear, second: self.acceleration.linear }
    }

    /// A vector fixed in the body, given in the body's frame.
    #[must_use]
    pub fn fixed(&self, in_body: Vector3<f64>) -> JetVector {
        let value = self.pose.rotation * in_body;
        let w = self.velocity.angular;
        let rate = w.cross(&value);
        JetVector { value, rate, second: self.acceleration.angular.cross(&value) + w.cross(&rate) }
    }

    /// A point fixed in the body, given from the mass centre in the body's frame.
    #[must_use]
    pub fn point(&self, in_body: Vector3<f64>) -> JetVector {
        self.centre() + self.fixed(in_body)
    }

    /// Velocity of the body's material point that is now at `arm` from the mass centre. The result
    /// is a velocity: its `rate` is an acceleration and its `second` is not meaningful.
    #[must_use]
    pub fn velocity_at(&self, arm: &JetVector) -> JetVector {
        let zero = Vector3::zeros();
        let linear = JetVector { value: self.velocity.linear, rate: self.acceleration.linear, second: zero };
        linear + self.angular_velocity().cross(arm)
    }

    /// Angular velocity as a jet (`second` is not meaningful).
    #[must_use]
    pub fn angular_velocity(&self) -> JetVector {
        JetVector { value: self.velocity.angular, rate: self.acceleration.angular, second: Vector3::zeros() }
    }
}
