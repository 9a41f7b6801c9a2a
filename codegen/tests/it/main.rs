//! Tests of the generator, one binary.

mod expressions;
mod geometry;
mod layering;
mod model_errors;
mod models;
mod rejected;
mod textbook;
mod units;
