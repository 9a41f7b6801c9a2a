//! Oracles, references and adapters that the tests in `it/` share. No test, no product code.

pub mod cases;
pub mod closed_form;
pub mod generated;
pub mod interpreted;
pub mod loop_equations;
pub mod newton_euler;
pub mod random;
pub mod reference;
pub mod stepping;
pub mod subject;
pub mod tolerance;
pub mod trial;
