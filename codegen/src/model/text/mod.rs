//! The text of a model: TOML, repetition, extension, names, and the expressions in its strings.
//!
//! In: text. Out: a [`Draft`](super::draft::Draft). From the notation to the sections: `document` (TOML with places,
//! `amount` of values at most), `repeat` and `extend` and `joints` (which entries there are), `scope` (names), `lexing`, `syntax` and `expression` (strings), `builder`
//! with `entry` (fields), then a file for each group of sections.

pub mod amount;
mod bodies;
mod builder;
pub mod document;
mod entry;
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
