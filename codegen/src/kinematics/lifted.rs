//! Decides which points and frames have unknowns of their own, and removes lifted points from vectors.

use super::quantities::Kinematics;
use crate::model::{FrameId, Model, PointId};
use crate::vector::{Algebra, Vector};

/// Is the frame's angular velocity an unknown of its own? Yes if the model states vectors fixed in it.
pub(super) fn frame_is_lifted(model: &Model, frame: FrameId) -> bool {
    !model.frames[frame].fixed_vectors.is_empty()
}

/// Is the point kept as a symbol in later positions? Yes if it closes loops, so that its velocity is an unknown of its
/// own, or if its velocity is stated.
pub(super) fn point_is_lifted(model: &Model, point: PointId) -> bool {
    !model.points[point].closures.is_empty() || model.points[point].velocity.is_some()
}

/// The vector with every lifted point replaced by its first position expression.
pub(crate) fn flatten(alg: &mut Algebra, k: &Kinematics, vector: &Vector) -> Vector {
    let mut flat = Vector { terms: vector.terms.clone(), ..Vector::default() };
    for (&point, &factor) in &vector.points {
        let base = k.flat_positions[&point].scaled(&mut alg.dag, factor);
        flat = flat.plus(&mut alg.dag, &base);
    }
    flat
}
