//! Everything of the runtime that can be judged from outside.

mod double_double;
mod functions;
