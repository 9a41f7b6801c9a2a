//! A validated model: names resolved to ids, units checked, every place in the text kept.
//!
//! In: TOML with expression strings. Out: a [`Model`], data only. `read` is the list of stages: `text` reads, `check`
//! judges every expression that `walk` lists. Expressions are still trees over the model's own names
//! ([`expression::Expr`]); the kinematics stage lowers them into the shared expression DAG, in the order
//! [`Model::order`]. Invariants: every id is in range; every expression has been checked for type (scalar or vector)
//! and unit; `order` is topological, so an entity refers only to earlier ones.

mod check;
mod closed_loop;
pub mod colour;
mod data;
mod draft;
pub mod expression;
mod frame;
mod ids;
mod load;
mod picture;
mod read;
mod release;
mod sides;
mod text;
pub mod unit;
pub mod unit_hint;
mod walk;
mod wrench;

pub use check::quantity::quantity;
pub use data::*;
pub use expression::{Axis, Expr};
pub use ids::*;
pub use read::{parse, parse_with, read, read_in};
pub(crate) use release::COMPONENTS;
pub(crate) use sides::Cut;
pub use text::amount::marks;
pub use text::entry::is_plain;
pub use text::scope::RESERVED;
pub use text::syntax::is_keyword;
pub use text::{document, fields::Fields};
pub use walk::Role;
