//! What the bed measures: places of screws and pressures of bladders, and a surface of antennas that feels the patient.
//!
//! In: what is true (heights, gauges, maps of pressure and shear). Out: what is read, late, coarse and noisy, the same again
//! from the same seed. `drive` is a tile's instruments; a [`site`] of the surface turns loads into resonances of its
//! [`antenna`]s and back by a calibration; [`mod@array`] tells four sites apart by frequency; [`reader`] reads whole maps.

pub mod antenna;
pub mod array;
pub mod drive;
pub mod fine;
pub mod reader;
pub mod site;
pub mod table;
