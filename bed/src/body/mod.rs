//! What lies on the bed: rigid segments under soft tissue, connected by joints.
//!
//! In: shapes, masses and joints. Out: gaps, and energies of weight and joints with their derivatives. Tissue is an
//! elastic (Winkler) foundation on the rigid core: pressure = foundation modulus x depth, where the foundation modulus
//! is Young's modulus over thickness. A ball, a cylinder, a plate and a mesh are bodies of one segment.

pub mod anthropometry;
pub mod figure;
mod limits;
pub mod mesh;
pub mod shape;
mod skeleton;
mod surface;

pub use limits::{Limits, Stop};
pub use shape::Shape;
pub use skeleton::{Body, Joint, Rows, Segment, lever};
pub use surface::{Inside, Surface};
