//! Tests of the generator, one binary.

mod augmented;
mod expr;
mod expressions;
mod geometry;
mod layering;
mod model_errors;
mod models;
mod rejected;
mod rolling;
mod textbook;
mod units;
