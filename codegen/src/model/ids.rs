//! Ids: indices of the named things of a model, one type for each kind.

use crate::id::ids;

ids! {
    /// A parameter.
    ParameterId,
    /// A generalised coordinate.
    CoordinateId,
    /// A generalised speed.
    SpeedId,
    /// An input (force, torque or whatever the laws command).
    InputId,
    /// A named intermediate quantity, scalar or vector.
    DefinitionId,
    /// A reference frame; the first is the inertial frame N.
    FrameId,
    /// A point; the first is the origin O, fixed in N.
    PointId,
    /// A rigid body.
    BodyId,
}
