//! What lies on the bed: rigid cores under soft tissue, joined at points.
//!
//! In: shapes, masses and joints. Out: gaps, energies of weight and joints with their derivatives. Tissue is a bed of
//! springs on the core: pressure = foundation modulus x depth; its modulus over its thickness is that modulus. A ball, a
//! cylinder, a plate and a mesh are bodies of one segment.

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
