//! A rigid body as a mesh: a closed surface of triangles, its mass properties, and how far points are from it.
//!
//! In: corners and triangles in a file's axes. Out: a [`Solid`] in its principal axes about its mass centre, and the pose of
//! these in the file's. Contact asks a smooth field of the distance ([`field`]), which an exact one (`distance`) fills:
//! that of triangles has kinks inside, where a state of least energy would roll from face to face.

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
