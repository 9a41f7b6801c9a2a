//! Reads `[sensors.NAME]`: the quantity, its transducer, resolution, delay and noise.
//!
//! Numbers in quotes have the dimension of `unit`; plain ones are in SI units.

use super::value::{Bound, count, list, named_unit, number, one_of, refuse_unit_unnamed};
use crate::world::assembly::{Sensing, Transducer};
use smartbed_codegen::diagnostic::Diagnostics;
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Key, Value, wrong_kind};
use smartbed_codegen::source::fnv1a;

/// Names of the transducers.
const KINDS: [&str; 4] = ["plain", "lvdt", "pressure", "switch"];

/// Keys whose numbers are in the unit of the sensor.
const IN_UNIT: [&str; 8] = ["noise", "bias", "drift", "resolution", "reach", "closes", "hysteresis", "range"];

/// Reads one.
pub(super) fn read(key: &Key, value: &Value, found: &mut Diagnostics) -> Option<Sensing> {
    let Value::Table(table) = value else {
        found.push(wrong_kind(&key.name, "a table of its own: [sensors.NAME]", value));
        return None;
    };
    let fields = Fields::of(&key.name, key.span, table);
    let of = match fields.need("of", "\"tile.hA\"", found)? {
        Value::Text(text) => text.text.clone(),
        other => {
            found.push(wrong_kind("of", "the name of a number of the rows in quotes", other));
            return None;
        }
    };
    let (unit, dimension) = named_unit(&fields, found)?;
    if dimension.is_none() {
        refuse_unit_unnamed(&format!("sensors.{}", key.name), table, &IN_UNIT, found)?;
    }
    let mut get = |name: &'static str, unit: &str, bound: Bound, left_out: f64| {
        number(&fields, name, unit, bound, found).unwrap_or(left_out)
    };
    let (delay, period) =
        (get("delay", "s", Bound::NotNegative, 0.0), get("period", "s", Bound::Positive, f64::NAN));
    let noise = get("noise", &unit, Bound::NotNegative, 0.0);
    let bias = get("bias", &unit, Bound::NotNegative, 0.0);
    let drift = get("drift", &unit, Bound::Any, 0.0);
    let resolution = get("resolution", &unit, Bound::NotNegative, 0.0);
    let kind = fields.text("kind", found);
    let kind = match kind {
        Some(text) => one_of(&text.text, text.span, ("kind of sensor", &KINDS), found)?,
        None => "plain",
    };
    let mut get = |name: &'static str, unit: &str, bound: Bound, left_out: f64| {
        number(&fields, name, unit, bound, found).unwrap_or(left_out)
    };
    let transducer = match kind {
        "lvdt" => Transducer::Lvdt {
            reach: get("reach", &unit, Bound::Positive, 1.0),
            linearity: get("linearity", "", Bound::NotNegative, 0.0),
        },
        "pressure" => Transducer::Pressure { lag: get("lag", "s", Bound::NotNegative, 0.0) },
        "switch" => Transducer::Switch {
            closes: get("closes", &unit, Bound::Any, 0.0),
            hysteresis: get("hysteresis", &unit, Bound::NotNegative, 0.0),
            chatter: get("chatter", "s", Bound::NotNegative, 0.0),
        },
        _ => Transducer::Plain,
    };
    let range = match fields.get("range") {
        Some(value) => list(value, "range", &unit, found)?,
        None => [f64::NEG_INFINITY, f64::INFINITY],
    };
    // Sensors that share a seed share their noise, which would vanish in differences and remain in means.
    let seed = count(&fields, "seed", 0, found).map_or_else(|| fnv1a(key.name.bytes()), |seed| seed as u64);
    fields.finish(found);
    let period = Some(period).filter(|period| !period.is_nan());
    let name = key.name.clone();
    Some(Sensing {
        name,
        of,
        unit: dimension,
        transducer,
        period,
        delay,
        noise,
        bias,
        drift,
        resolution,
        range,
        seed,
    })
}
