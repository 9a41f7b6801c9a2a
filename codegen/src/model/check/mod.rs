//! Checks that turn a draft into a model: an order of computation, units, and what may depend on what.
//!
//! In: a [`Draft`](super::draft::Draft). Out: findings with their places; from `order` the order of the entities, from
//! `units` the units of outputs, from `evaluate` the numbers.

mod driven;
pub mod evaluate;
mod infer;
pub mod order;
mod plausible;
pub mod quantity;
pub mod reach;
pub mod units;
mod unused;
