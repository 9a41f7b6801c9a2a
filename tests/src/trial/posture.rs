//! A drawn mechanism at one instant: every frame, point and definition as a jet in time.
//!
//! In: time, coordinates with their first and second rates, parameters, inputs. Orientation is carried as three
//! unit vectors; angular velocity is read off them, w = 1/2 sum e_i x e_i', so no joint is known to this module.

use super::description::{Description, Entity, Frame};
use super::expression::inertial;
use crate::newton_euler::jet::{Jet, JetVector};
use nalgebra::Vector3;

/// Everything at one instant.
#[derive(Clone, Debug)]
pub struct Posture<'a> {
    /// The mechanism.
    pub description: &'a Description,
    /// Time.
    pub t: Jet,
    /// Coordinates.
    pub q: Vec<Jet>,
    /// Inputs.
    pub inputs: &'a [f64],
    /// Parameters.
    pub parameters: &'a [f64],
    /// Definitions of numbers.
    pub scalars: Vec<Jet>,
    /// Definitions of vectors.
    pub vectors: Vec<JetVector>,
    /// x, y, z of every frame.
    pub frames: Vec<[JetVector; 3]>,
    /// Points from O; `rate` is the velocity.
    pub points: Vec<JetVector>,
}

impl<'a> Posture<'a> {
    /// Evaluates all entities in order; closed forms replace what `q` says of their coordinates.
    #[must_use]
    pub fn new(
        description: &'a Description,
        parameters: &'a [f64],
        inputs: &'a [f64],
        t: f64,
        q: &[Jet],
    ) -> Self {
        let zero = JetVector::constant(Vector3::zeros());
        let mut posture = Self {
            description,
            t: Jet::new(t, 1.0, 0.0),
            q: q.to_vec(),
            inputs,
            parameters,
            scalars: vec![Jet::constant(0.0); description.scalars.len()],
            vectors: vec![zero; description.vectors.len()],
            frames: vec![inertial(); description.frames.len()],
            points: vec![zero; description.points.len()],
        };
        for &entity in &description.order {
            posture.add(entity);
        }
        posture
    }

    fn add(&mut self, entity: Entity) {
        let description = self.description;
        match entity {
            Entity::Coordinate(i) => {
                if let Some(form) = &description.coordinates[i].closed_form {
                    self.q[i] = form.at(self);
                }
            }
            Entity::Scalar(i) => self.scalars[i] = description.scalars[i].at(self),
            Entity::Vector(i) => self.vectors[i] = description.vectors[i].at(self),
            Entity::Frame(i) => self.frames[i] = self.oriented(&description.frames[i]),
            Entity::Point(i) => {
                let point = &description.points[i];
                let mut place = point.position.at(self);
                if let Some(velocity) = &point.velocity {
                    let velocity = velocity.at(self);
                    (place.rate, place.second) = (velocity.value, velocity.rate);
                }
                self.points[i] = place;
            }
        }
    }

    fn oriented(&self, frame: &Frame) -> [JetVector; 3] {
        match frame {
            Frame::Inertial => inertial(),
            Frame::Rotations(parent, steps) => {
                let mut axes = self.frames[*parent];
                for (axis, angle) in steps {
                    axes = turned(axes, *axis, angle.at(self));
                }
                axes
            }
            Frame::Directions(x, y) => {
                let (x, y) = (x.at(self), y.at(self));
                [x, y, x.cross(&y)]
            }
        }
    }

    /// Angular velocity of a frame in N; `rate` is the angular acceleration.
    #[must_use]
    pub fn angular_velocity(&self, frame: usize) -> JetVector {
        let zero = JetVector::constant(Vector3::zeros());
        self.frames[frame].iter().fold(zero, |mut w, e| {
            w.value += e.value.cross(&e.rate) * 0.5;
            w.rate += e.value.cross(&e.second) * 0.5;
            w
        })
    }
}

/// Axes turned about one of them: e_j' = cos e_j + sin e_k, e_k' = cos e_k - sin e_j.
fn turned(axes: [JetVector; 3], about: usize, angle: Jet) -> [JetVector; 3] {
    let (sin, cos) = angle.value.sin_cos();
    let (s, c) = (angle.chain(sin, cos, -sin), angle.chain(cos, -sin, -cos));
    let (j, k) = ((about + 1) % 3, (about + 2) % 3);
    let mut result = axes;
    result[j] = axes[j].scale(c) + axes[k].scale(s);
    result[k] = axes[k].scale(c) - axes[j].scale(s);
    result
}
