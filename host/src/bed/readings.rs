//! Readings of the tiles' instruments: a table as CSV, their largest errors as text and as JSON.

use crate::number::json_number;
use smartbed_bed::plan::readings::{Errors, Reading};
use std::fmt::Write as _;

/// All readings, one row per tile and moment, next to the true values.
pub fn csv(readings: &[Reading]) -> String {
    let mut text = String::from("time (s),tile");
    for (name, unit) in [
        ("encoder", " (m)"),
        ("lvdt", " (m)"),
        ("lower switch", ""),
        ("upper switch", ""),
        ("height", " (m)"),
    ] {
        (1..=3).for_each(|screw| text += &format!(",{name} {screw}{unit}"));
    }
    text += ",pressure read (Pa),pressure (Pa)\n";
    for Reading { time, tile, read, heights, gauge } in readings {
        let _ = write!(text, "{time},{}", tile + 1);
        read.encoders.iter().chain(&read.lvdts).for_each(|x| text += &format!(",{x}"));
        for side in 0..2 {
            read.switches.iter().for_each(|pair| text += &format!(",{}", u8::from(pair[side])));
        }
        heights.iter().for_each(|x| text += &format!(",{x}"));
        let _ = writeln!(text, ",{},{gauge}", read.pressure);
    }
    text
}

/// Largest errors as JSON.
pub fn json(readings: &[Reading]) -> String {
    let Errors { encoder, lvdt, pressure, disagree } = Errors::of(readings);
    format!(
        "{{\"readings\": {}, \"encoder_error\": {}, \"lvdt_error\": {}, \"pressure_error\": {}, \"disagree\": {disagree}}}",
        readings.len(),
        json_number(encoder),
        json_number(lvdt),
        json_number(pressure)
    )
}

/// Largest errors as text.
pub fn text(readings: &[Reading]) -> String {
    let Errors { encoder, lvdt, pressure, disagree } = Errors::of(readings);
    format!(
        "instruments: {} readings; encoders within {:.1} um, LVDTs within {:.1} um, pressures within {pressure:.1} Pa; \
         {disagree} of encoder and LVDT disagree\n",
        readings.len(),
        1e6 * encoder,
        1e6 * lvdt
    )
}
