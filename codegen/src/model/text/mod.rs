//! The text of a model: TOML, repetition, extension, names, and the expressions in its strings.
//!
//! In: text. Out: a [`Draft`](super::draft::Draft). In order: `document` parses TOML with places (`amount` bounds its
//! size); `repeat`, `extend` and `joints` produce the entries; `scope` holds the names; `lexing`, `syntax` and
//! `expression` read strings; `builder` with `entry` reads fields, and one file for each group of sections does the
//! rest.

pub mod amount;
mod bodies;
mod builder;
pub mod document;
pub(super) mod entry;
pub mod expression;
pub mod extend;
pub mod fields;
pub mod joints;
mod lexing;
mod loads;
mod mechanics;
pub mod repeat;
pub mod scope;
pub mod sections;
mod shapes;
pub mod syntax;
mod values;
mod view;
