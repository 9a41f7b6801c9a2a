//! Tests of the generator, one binary.

mod geometry;
mod models;
