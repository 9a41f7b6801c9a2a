//! A flexible body: point masses joined by spring-dampers (thesis chapter 3), as a view over the caller's slices.
//!
//! In: numbers of points, springs and facets. Out: forces and energies. Invariant: after [`Body::new`] every
//! spring and facet refers to points that exist, so kernels need no checks. Nothing here allocates.

pub mod block;
pub mod body;
pub mod element;
pub mod energy;
pub mod fault;
pub mod force;
pub mod grid;
pub mod mean;
pub mod patch;
pub mod pressure;
pub mod rest;
pub mod spring;
pub mod walk;

pub(crate) use body::ON_HOST;
pub use body::{Body, Massless};
pub use fault::{BodyError, Quantity};
pub use pressure::{Gas, Inflation, PressureForm};
pub use spring::Spring;
