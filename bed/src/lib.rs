//! Numerical model of the bed: tiles with air bladders under a patient, contact pressures, and their clinical metrics.
//!
//! In: sizes, pressures, poses and a body. Out: equilibria, motions, maps of pressure and shear over time, and the
//! metrics of such maps. Parses no plans and has no command line; it does read and write files of pressure maps
//! ([`files`]).

pub mod band;
pub mod body;
pub mod dynamics;
pub mod equilibrium;
pub mod files;
pub mod map;
pub mod method;
pub mod metrics;
pub mod plan;
pub mod policy;
pub mod pose;
pub mod sensor;
pub mod sheet;
pub mod soft;
pub mod tile;
pub mod tissue;
