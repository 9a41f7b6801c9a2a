//! Numbers, integrators, flexible bodies, contact and impact: no_std, no heap, no panic.
#![no_std]

pub mod mechanism;
pub mod real;
