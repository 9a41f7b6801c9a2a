//! Reads `[controllers.NAME]`: the value read, the input driven, the period, and the target.
//!
//! Targets in quotes have the dimension of `unit`; plain ones, gains and outputs are in SI units.

use super::mechanism::idle;
use super::value::{Bound, list, named_unit, needed, number, refuse_unit_unnamed, scalar};
use crate::world::assembly::{Controlling, Kind, Part};
use crate::world::places::whole;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Key, Value, wrong_kind};

/// An example of `target` that changes with time.
const TARGETS: &str = "[[\"0_s\", \"4_kPa\"], [\"1_s\", \"6_kPa\"]]";

/// Reads one.
pub(super) fn read(key: &Key, value: &Value, parts: &[Part], found: &mut Diagnostics) -> Option<Controlling> {
    let Value::Table(table) = value else {
        found.push(wrong_kind(&key.name, "a table of its own: [controllers.NAME]", value));
        return None;
    };
    let fields = Fields::of(&key.name, key.span, table);
    let reads = word(&fields, "reads", "\"bladder.gauge\"", found)?;
    let drives = word(&fields, "drives", "\"bladder.valves\"", found)?;
    let (unit, dimension) = named_unit(&fields, found)?;
    if dimension.is_none() {
        refuse_unit_unnamed(&format!("controllers.{}", key.name), table, &["target"], found)?;
    }
    let target = targets(fields.need("target", "\"4_kPa\"", found)?, &unit, found)?;
    let period = needed(&fields, "period", ("s", "\"10_ms\""), found)?;
    let mut get = |name: &'static str| number(&fields, name, "", Bound::Any, found).unwrap_or(0.0);
    let (gain, integral, bias) = (get("gain"), get("integral"), get("bias"));
    let limits = match fields.get("limits") {
        Some(value) => list(value, "limits", "", found)?,
        None => [f64::NEG_INFINITY, f64::INFINITY],
    };
    fields.finish(found);
    if limits[0] >= limits[1] {
        let error = Diagnostic::error("`limits` must be the least output, then the largest");
        found.push(
            error
                .label(key.span, format!("these are {} and {}", limits[0], limits[1]))
                .help("limits = [-1, 1]"),
        );
        return None;
    }
    if let Some((part, input)) = idle_input(&drives, parts) {
        let place = table.get("drives").map_or(key.span, Value::span);
        found.push(idle((part, input), place, "drive another input"));
        return None;
    }
    let (name, unit) = (key.name.clone(), dimension);
    Some(Controlling { name, reads, unit, drives, period, target, gain, integral, bias, limits })
}

/// The part and the input that `drives` names, if that is a mechanism which no force moves.
fn idle_input<'d>(drives: &'d str, parts: &'d [Part]) -> Option<(&'d str, &'d str)> {
    parts.iter().find_map(|part| {
        let Kind::Mechanism(mechanism) = &part.kind else { return None };
        // Of a grid, all copies are meant.
        let names = [part.name.as_str(), whole(&part.name)];
        let input = names.iter().find_map(|name| drives.strip_prefix(name)?.strip_prefix('.'))?;
        let is_input = mechanism.model.inputs.iter().any(|own| own.name == input);
        (is_input && mechanism.is_given()).then_some((part.name.as_str(), input))
    })
}

/// A required name in quotes.
fn word(fields: &Fields<'_>, key: &'static str, example: &str, found: &mut Diagnostics) -> Option<String> {
    match fields.need(key, example, found)? {
        Value::Text(text) => Some(text.text.clone()),
        other => {
            found.push(wrong_kind(key, "a name in quotes", other).help(format!("for example {example}")));
            None
        }
    }
}

/// One target, or a list of `[time, target]` in the order of time.
fn targets(value: &Value, unit: &str, found: &mut Diagnostics) -> Option<Vec<[f64; 2]>> {
    let Value::Array(items, span) = value else {
        return Some(vec![[0.0, scalar(value, "target", unit, Bound::Any, found)?]]);
    };
    let mut targets: Vec<[f64; 2]> = Vec::new();
    for item in items {
        let pair = if let Value::Array(pair, _) = item { pair.as_slice() } else { &[] };
        let [time, own] = pair else {
            found.push(wrong_kind("target", "pairs [time, target]", item).help(TARGETS));
            return None;
        };
        let time = scalar(time, "target", "s", Bound::NotNegative, found)?;
        targets.push([time, scalar(own, "target", unit, Bound::Any, found)?]);
    }
    let rises = targets.windows(2).all(|two| two[0][0] < two[1][0]);
    if !rises || targets.first().is_none_or(|[first, _]| *first != 0.0) {
        let error = Diagnostic::error("the times of `target` must begin with 0 and rise");
        found.push(error.label(*span, "this list").help(TARGETS));
        return None;
    }
    Some(targets)
}
