//! Tests of the generator, one binary.

mod augmented;
mod chain;
mod driven;
mod driven_models;
mod emitted_bytes;
mod example_crate;
mod expr;
mod expressions;
mod forms;
mod geometry;
mod hostile;
mod layering;
mod loops;
mod machines;
mod mentioned;
mod model_errors;
mod models;
mod parallel;
mod redundant;
mod regular;
mod rejected;
mod rolling;
mod speeds;
mod textbook;
mod units;
mod value_graph;
