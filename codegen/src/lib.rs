//! Model text in, equations of motion out.
//!
//! A model file describes a mechanism: frames, points, bodies, loops, loads. This crate derives its
//! equations of motion by Kane's method, at build time, and emits straight-line `no_std` Rust, or
//! runs them at once in an interpreter that computes the same bits.
//!
//! In a build script, one line:
//! ```no_run
//! smartbed_codegen::build("models/tile.toml", &smartbed_codegen::Options::default());
//! ```
//! and in the crate: `include!(concat!(env!("OUT_DIR"), "/tile.rs"));`. A complete small crate of this
//! kind is `examples/pendulum_crate`; the language is described in `docs/models.md` of the repository.
//!
//! Without a compiler in between:
//! ```
//! use smartbed_codegen::{Interpreted, ParameterChoice, model, program};
//! use smartbed_runtime::mechanism::Mechanism;
//! # fn main() -> Result<(), smartbed_codegen::Diagnostics> {
//! let text = r#"
//! format = 1
//! name = "pendulum"
//! dof = 1
//! gravity = "-g*N.y"
//! [parameters]
//! l = { value = 0.5, unit = "m" }
//! m = { value = 1.0, unit = "kg" }
//! g = { value = 9.81, unit = "m/s^2" }
//! [coordinates]
//! q = { unit = "rad", independent = true }
//! [frames]
//! rod = { parent = "N", rotations = [["z", "q"]] }
//! [points]
//! tip = "-l*rod.y"
//! [bodies]
//! bob = { centre = "tip", mass = "m" }
//! "#;
//! let model = model::parse("pendulum.toml", text)?;
//! let program = program::derive(&model, &ParameterChoice::default())?;
//! let mut pendulum = Interpreted::<f64>::new(&program);
//! let (mut q_dot, mut u_dot) = ([0.0], [0.0]);
//! pendulum.rates(0.0, &[0.1], &[0.0], &[], &mut q_dot, &mut u_dot).expect("lengths fit");
//! assert!((u_dot[0] + 9.81 / 0.5 * 0.1_f64.sin()).abs() < 1e-14);
//! # Ok(())
//! # }
//! ```
//!
//! The stages are modules, and data flows downwards only: `model` (text to a checked tree) and `expr` (the expression
//! DAG) know nothing of each other; `vector` -> `kinematics` -> `dynamics` -> `value` -> `program` -> `rust` each use
//! only the stages before them.

pub mod escape;
pub mod expr;
pub mod id;
pub mod section;
mod sorted;
pub mod source;
pub mod words;

pub mod diagnostic;
pub mod model;
pub mod vector;

pub mod kinematics;

pub mod dynamics;

pub mod value;

pub mod program;

pub mod rust;

mod build;

pub use build::{Generated, Options, build, build_program, generate, generate_in, try_build};
pub use diagnostic::Diagnostics;
pub use kinematics::ParameterChoice;
pub use program::answer::{Answer, Asked, Function, Request};
pub use program::interpreter::Interpreted;
pub use program::{Optimise, Program, Settings};
pub use rust::{Core, EmitOptions, ScalarType};
pub use value::Effort;
