//! Tests of the generator, one binary.

mod models;
