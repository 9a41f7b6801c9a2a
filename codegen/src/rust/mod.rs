//! Program -> Rust: straight-line functions, one per answer, and the glue to the runtime's trait.
//!
//! In: a [`Program`](crate::Program). Out: formatted source text, the same bytes for the same input. Knows names and
//! layout, no mechanics. Every node that is used more than once becomes one `let`; sine and cosine of an angle are one
//! call, on a host for f64 even those of two angles; constants are rounded once, from f64 to the file's scalar.

mod answer;
mod cost;
mod few;
mod file;
mod function;
mod glue;
mod header;
mod items;
mod layout;
mod name;
mod options;
mod pairs;
mod places;
mod prepared;
mod refine;
mod schedule;
mod sections;
mod sines;
mod statement;

pub use answer::function_names;
pub use cost::{FunctionCost, cost};
pub use file::emit;
pub use glue::struct_name;
pub use options::{Core, EmitOptions, ScalarType};
