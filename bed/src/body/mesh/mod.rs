//! A rigid body given by a mesh: a closed surface of triangles, its mass properties, and the distance of points from
//! it.
//!
//! In: corners and triangles in a file's axes. Out: a [`Solid`] in its principal axes about its mass centre, and the
//! pose of these axes in the file's. Contact uses a smooth field of the distance ([`field`]) that interpolates the
//! exact one (`distance`): the latter has kinks inside the body, where a state of least energy would jump from face to
//! face.

mod check;
mod crossing;
mod distance;
pub mod field;
mod mass;
mod parts;
mod skin;
mod solid;
mod tree;
mod triangles;

pub use check::{MOST_TRIANGLES, MeshFault};
pub use skin::Patch;
pub use solid::Solid;
pub use triangles::Mesh;
