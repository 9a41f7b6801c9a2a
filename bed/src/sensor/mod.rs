//! Measurement: positions of screws, pressures of bladders, and a surface of antennas under the patient.
//!
//! In: true values (heights, gauge pressures, maps of pressure and shear). Out: readings with delay, resolution and
//! noise, reproducible from a seed. `drive` is a tile's instruments; a [`site`] of the surface converts loads to
//! resonances of its [`antenna`]s and back by a calibration; [`mod@array`] distinguishes four sites by frequency;
//! [`reader`] reads whole maps.

pub mod antenna;
pub mod array;
pub mod drive;
pub mod fine;
pub mod reader;
pub mod site;
pub mod table;
