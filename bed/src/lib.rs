//! The bed as numbers: tiles with air bladders under a patient, what presses where, and what that is called.
//!
//! In: sizes, pressures, poses and a body. Out: equilibria, maps of pressure and shear over time, and the metrics of
//! such maps. No text of plans and no command line; files of pressure maps are read and written ([`files`]).

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
