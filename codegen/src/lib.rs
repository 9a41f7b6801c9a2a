//! Model text in, equations of motion out.

pub mod diagnostic;
pub mod id;
pub mod model;
pub mod source;
