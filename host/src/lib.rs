//! What the smartbed command is made of.

pub mod scene;
