//! Reference values: high-precision evaluations of known mechanisms, stored under `tests/reference`.

pub mod data;
