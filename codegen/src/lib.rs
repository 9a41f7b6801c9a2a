//! Model text in, equations of motion out.

pub mod expr;
pub mod id;
pub mod model;
pub mod source;
pub mod vector;
