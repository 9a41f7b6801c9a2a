//! Random mechanisms as model texts, with an oracle of their own.
//!
//! In: a seed and a kind. Out: a [`description::Description`]; [`text`] writes it as a model, [`oracle`] solves
//! it by Newton-Euler over jets, [`verdict`] compares what was derived from the text with that.

pub mod description;
pub mod draw;
mod draw_drives;
mod draw_loads;
mod draw_loops;
mod draw_rows;
mod draw_speeds;
pub mod expression;
mod nominal;
pub mod oracle;
pub mod posture;
pub mod text;
pub mod verdict;
