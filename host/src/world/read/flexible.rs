//! Reads a flexible part: a shape of format 1 with its keys, its start, and the gas inside.
//!
//! Numbers with units are converted and passed to the reader of format 1, which knows the shapes.

use super::value::{Bound, list, needed, number, scalar};
use crate::scene::Lists;
use crate::scene::fields::Fields as Plain;
use crate::scene::keys::{Choice, READERS, shapes};
use crate::scene::read::{AMBIENT, body};
use crate::scene::surface::open_edges;
use crate::world::assembly::Flexible;
use serde_json::{Map, Value as Json};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Value};
use smartbed_runtime::flexible::pressure::enclosed_volume;
use smartbed_runtime::gas::{Chamber, Gas, Line, Nozzle, Regulated, Source};
use smartbed_runtime::world::Content;

/// Keys of shapes and bodies with their units; whole numbers and lists of them have none.
const UNITS: [(&str, &str); 18] = [
    ("side", "m"),
    ("length", "m"),
    ("height", "m"),
    ("radius", "m"),
    ("width", "m"),
    ("depth", "m"),
    ("E", "N/m^2"),
    ("rho", "kg/m^3"),
    ("A", "m^2"),
    ("mass", "kg"),
    ("K", "N/m"),
    ("C", "N s/m"),
    ("stretch", ""),
    ("points", "m"),
    ("rest_lengths", "m"),
    ("drop_height", "m"),
    ("tilt", "rad"),
    ("initial_velocity", "m/s"),
];

/// Volume below which a surface counts as flat (m^3).
const FLAT: f64 = 1e-9;
/// Temperature of gas unless it is given (K).
const ROOM: f64 = 293.15;
/// Critical ratio of a line unless it is given (ISO 6358: valves have 0.2 to 0.5).
const CRITICAL_RATIO: f64 = 0.3;

/// Keys of every flexible part, beside those of its shape.
pub const COMMON: [&str; 4] = ["shape", "fixed", "C", "stretch"];
/// Keys that exist only in this format.
pub const OWN: [&str; 6] = ["start", "air_drag", "gas", "base", "attach", "grid"];

/// Gas, with its supply and vent.
type Filled = (Content<f64>, [Option<Line<f64>>; 2]);

/// Reads it; `offset` is the displacement of a copy in a grid.
pub(super) fn read(
    name: (&str, smartbed_codegen::source::Span),
    table: &Table,
    offset: [f64; 3],
    found: &mut Diagnostics,
) -> Option<Flexible> {
    let own = Table {
        entries: table.entries.iter().filter(|(key, _)| OWN.contains(&key.name.as_str())).cloned().collect(),
        span: table.span,
    };
    let fields = Fields::of(name.0, name.1, &own);
    let mut plain = Map::new();
    let allowed = allowed(table);
    for (key, value) in table.entries.iter().filter(|(key, _)| !OWN.contains(&key.name.as_str())) {
        if !allowed.iter().any(|a| *a == key.name) {
            let help = crate::suggest::help(&key.name, allowed.iter().copied().chain(OWN));
            let error = Diagnostic::error(format!("part `{}` has no key `{}`", name.0, key.name));
            let help = help.trim_start_matches("; ").to_owned();
            found.push(error.label(key.span, "unknown key of this part").help(help));
            return None;
        }
        plain.insert(key.name.clone(), json(value, &key.name, found)?);
    }
    let position = start(&fields, &mut plain, found);
    let air_drag = number(&fields, "air_drag", "N s/m", Bound::NotNegative, found).unwrap_or(0.0);
    let base = number(&fields, "base", "m", Bound::Positive, found);
    let tilt = plain.get("tilt").and_then(Json::as_f64).unwrap_or(0.0);
    let mut lists = match body::read(&Plain::of_map(plain)) {
        Ok(lists) => lists,
        Err(message) => {
            let (key, message) = message.split_once(": ").unwrap_or(("shape", &message));
            let span = table.entries.iter().find(|(k, _)| k.name == key).map_or(name.1, |(k, _)| k.span);
            let error = Diagnostic::error(format!("`{key}` of `{}`: {message}", name.0));
            found.push(error.label(span, "here"));
            return None;
        }
    };
    if let Some(depth) = base
        && !close_below(&mut lists, depth, tilt)
    {
        let place = fields.get("base").map_or(name.1, Value::span);
        let error = Diagnostic::error("`base` needs a surface with one open rim");
        let label = match lists.facets.is_empty() {
            true => "this part has no facets",
            false => "this part is closed, or open in several places",
        };
        found.push(error.label(place, label).help("it closes a sheet from below; leave it out elsewhere"));
        return None;
    }
    for point in &mut lists.points {
        *point = [0, 1, 2].map(|i| point[i] + position[i] + offset[i]);
    }
    let gas = match fields.table("gas", found) {
        None => None,
        Some(table) => Some(gas(table, &lists, found)?),
    };
    let (gas, lines) = gas.map_or((None, [None; 2]), |(content, lines)| (Some(content), lines));
    Some(Flexible { lists, air_drag, gas, lines })
}

/// Keys of the part's shape that are allowed here.
fn allowed(table: &Table) -> Vec<&'static str> {
    let shape = match table.get("shape") {
        Some(Value::Text(text)) => shapes().find(|known| *known == text.text),
        _ => None,
    };
    let choice = shape.map_or(Choice::Lists, Choice::Shape);
    let keys = READERS.iter().filter(|r| r.choice == choice).flat_map(|r| r.keys.split_whitespace());
    // In this format the start and the gas are stated in `start` and `gas`.
    keys.filter(|key| !["pressure", "drop_height"].contains(key)).chain(COMMON).collect()
}

/// A value converted to SI, in the form that format 1 uses.
fn json(value: &Value, key: &str, found: &mut Diagnostics) -> Option<Json> {
    let unit = UNITS.iter().find(|(known, _)| *known == key);
    Some(match (value, unit) {
        (Value::Text(_), Some((_, unit))) => Json::from(scalar(value, key, unit, Bound::Any, found)?),
        (Value::Text(text), None) => Json::from(text.text.clone()),
        // Refused by name: JSON has no such number.
        (Value::Number(number, _), _) if !number.is_finite() => {
            Json::from(scalar(value, key, "", Bound::Any, found)?)
        }
        (Value::Number(number, _), _) if number.fract() == 0.0 && number.abs() < 1e15 => {
            Json::from(*number as i64)
        }
        (Value::Number(number, _), _) => Json::from(*number),
        (Value::Boolean(flag, _), _) => Json::from(*flag),
        (Value::Array(items, _), _) => {
            let items: Option<Vec<Json>> = items.iter().map(|item| json(item, key, found)).collect();
            Json::from(items?)
        }
        (Value::Table(_) | Value::Date(_), _) => {
            let error = Diagnostic::error(format!("`{key}` is {}", value.kind()));
            found.push(error.label(value.span(), "expected a number, a word or a list"));
            return None;
        }
    })
}

/// Reads `start = { position, height, tilt, velocity }` and returns the position; the other three are keys of format 1.
fn start(fields: &Fields<'_>, plain: &mut Map<String, Json>, found: &mut Diagnostics) -> [f64; 3] {
    let Some(table) = fields.table("start", found) else { return [0.0; 3] };
    let inner = Fields::of("start", table.span, table);
    let position = inner.get("position").and_then(|value| list(value, "position", "m", found));
    for (key, plainly, of) in [("height", "drop_height", "m"), ("tilt", "tilt", "rad")] {
        if let Some(x) = number(&inner, key, of, Bound::Any, found) {
            plain.insert(plainly.to_owned(), Json::from(x));
        }
    }
    if let Some(value) = inner.get("velocity")
        && let Some(velocity) = list::<3>(value, "velocity", "m/s", found)
    {
        plain.insert("initial_velocity".to_owned(), Json::from(velocity.to_vec()));
    }
    inner.finish(found);
    position.unwrap_or_default()
}

/// Closes a sheet that is tilted (rad) about the y axis: adds a ring of nodes below its rim, walls between the two, and
/// a flat base; false if it has no single rim.
fn close_below(lists: &mut Lists, depth: f64, tilt: f64) -> bool {
    let Some(rim) = ring(lists) else { return false };
    let low: Vec<usize> = rim
        .iter()
        .map(|node| {
            let [x, y, z] = lists.points[*node];
            let point = lists.point([x + depth * tilt.sin(), y, z - depth * tilt.cos()]);
            (lists.fixed[point], lists.masses[point]) = (true, lists.masses[*node]);
            lists.velocities.push(lists.velocities[*node]);
            point
        })
        .collect();
    for k in 0..rim.len() {
        let next = (k + 1) % rim.len();
        lists.facets.push([low[k], low[next], rim[next], rim[k]]);
    }
    for k in 1..rim.len() - 1 {
        lists.facets.push([low[0], low[k + 1], low[k], low[k]]);
    }
    true
}

/// The boundary nodes of an open surface in the order of its facets; `None` unless there is exactly one closed
/// boundary.
fn ring(lists: &Lists) -> Option<Vec<usize>> {
    let open = open_edges(&lists.facets);
    let first = *open.keys().next()?;
    let (mut nodes, mut at) = (vec![first], *open.get(&first)?);
    while at != first && nodes.len() <= open.len() {
        nodes.push(at);
        at = *open.get(&at)?;
    }
    (nodes.len() == open.len()).then_some(nodes)
}

/// Reads `gas = { gauge, ambient, sealed, exponent, volume, temperature, supply, vent }`; keys after `sealed` require
/// sealed gas.
fn gas(table: &Table, lists: &Lists, found: &mut Diagnostics) -> Option<Filled> {
    let fields = Fields::of("gas", table.span, table);
    let gauge = scalar(fields.need("gauge", "\"4_kPa\"", found)?, "gauge", "Pa", Bound::Any, found)?;
    let sealed = fields.boolean("sealed", found).unwrap_or(false);
    let open = open_edges(&lists.facets);
    if lists.facets.is_empty() || !open.is_empty() {
        let (label, help) = match open.iter().next() {
            Some((a, b)) => (
                format!("the edge from node {a} to node {b} belongs to one facet only"),
                "close it: a sheet by base = \"40_mm\", lists by more facets, counter-clockwise seen from outside",
            ),
            None => ("the part has no facets".to_owned(), "give it facets, or leave `gas` out"),
        };
        found.push(Diagnostic::error("gas needs a closed surface").label(table.span, label).help(help));
        return None;
    }
    let enclosed = enclosed_volume(&lists.facets, &lists.points);
    let ambient = number(&fields, "ambient", "Pa", Bound::NotNegative, found).unwrap_or(AMBIENT);
    // A flat surface encloses nothing yet, but regulated gas can inflate it.
    let encloses = |volume: f64| volume > 0.0 || !sealed && volume > -FLAT;
    let given = if sealed { number(&fields, "volume", "m^3", Bound::Positive, found) } else { None };
    if !(encloses(given.unwrap_or(enclosed)) && ambient + gauge > 0.0) {
        let error = Diagnostic::error("the gas has no volume or no pressure");
        let label = format!("the facets enclose {enclosed:.3e} m^3");
        let help = "facets go counter-clockwise seen from outside; or give the `volume` at which `gauge` holds; \
                    gauge + ambient is above 0";
        found.push(error.label(table.span, label).help(help));
        return None;
    }
    let (mut supply, mut vent) = (None, None);
    let content = if sealed {
        let exponent = number(&fields, "exponent", "", Bound::Positive, found).unwrap_or(1.4);
        let adiabatic = Gas::<f64>::air().heat_capacity_ratio;
        if !(1.0..=adiabatic).contains(&exponent) {
            let place = fields.get("exponent").map_or(table.span, Value::span);
            let error = Diagnostic::error(format!("`exponent` is {exponent}, expected 1 to {adiabatic}"));
            let label = "n of p V^n, from isothermal to adiabatic changes of air";
            found.push(error.label(place, label).help("1 for slow changes, 1.4 for fast ones"));
            return None;
        }
        let temperature = number(&fields, "temperature", "K", Bound::Positive, found).unwrap_or(ROOM);
        let volume = given.unwrap_or(enclosed);
        supply = fields.table("supply", found).and_then(|table| line(table, true, ambient, found));
        vent = fields.table("vent", found).and_then(|table| {
            if ambient > 0.0 {
                return line(table, false, ambient, found);
            }
            let place = fields.get("ambient").map_or(table.span, Value::span);
            let error = Diagnostic::error("`ambient` must be above 0 where there is a `vent`");
            let label = "a vent leads to the air outside, which has this absolute pressure";
            found.push(error.label(place, label).help("give its pressure, or leave `vent` out"));
            None
        });
        let chamber = Chamber { gas: Gas::air(), exponent, reference_volume: volume, ambient };
        let state = chamber.filled(Source { pressure: ambient + gauge, temperature }, volume);
        Content::Sealed { chamber, state }
    } else {
        Content::Regulated(Regulated { gas: Gas::air(), gauge, ambient })
    };
    fields.finish(found);
    Some((content, [supply, vent]))
}

/// Reads `supply = { gauge, conductance, critical_ratio, opening, temperature }`; a vent leads to the ambient air.
fn line(table: &Table, is_supply: bool, ambient: f64, found: &mut Diagnostics) -> Option<Line<f64>> {
    let fields = Fields::of(if is_supply { "supply" } else { "vent" }, table.span, table);
    let gauge = if is_supply {
        scalar(fields.need("gauge", "\"30_kPa\"", found)?, "gauge", "Pa", Bound::Any, found)?
    } else {
        0.0
    };
    if ambient + gauge <= 0.0 {
        let error = Diagnostic::error("the supply has no pressure")
            .label(table.span, "gauge + ambient is not above 0");
        found.push(error.help("gauge is the pressure above `ambient`"));
        return None;
    }
    let conductance = needed(&fields, "conductance", ("m^3/(s Pa)", "\"1e-8 m^3/(s Pa)\""), found)?;
    let critical_ratio = number(&fields, "critical_ratio", "", Bound::Share, found).unwrap_or(CRITICAL_RATIO);
    if critical_ratio >= 1.0 {
        let error = Diagnostic::error("`critical_ratio` must be below 1").label(table.span, "this line");
        found.push(error.help("0.2 to 0.5 is usual (ISO 6358)"));
        return None;
    }
    let opening = number(&fields, "opening", "", Bound::Share, found).unwrap_or(0.0);
    let temperature = number(&fields, "temperature", "K", Bound::Positive, found).unwrap_or(ROOM);
    fields.finish(found);
    let reservoir = Source { pressure: ambient + gauge, temperature };
    Some(Line { nozzle: Nozzle { conductance, critical_ratio }, opening, reservoir })
}
