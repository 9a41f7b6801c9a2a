//! Reads contacts: which parts touch, and by which law.

use super::join::{parts_named, unknown_part};
use super::value::{Bound, needed, number, one_of};
use crate::world::assembly::{Contact, Kind, Law, Part};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Text, Value, wrong_kind};
use smartbed_codegen::source::Span;
use smartbed_runtime::contact::ForceLaw;
use smartbed_runtime::rigid::law::{Law as Located, LawFault};
use smartbed_runtime::surface::Shape;

/// Impact laws.
const IMPACTS: [&str; 5] = ["stronge", "newton", "compensation", "plastic", "moreau"];
/// Force laws.
const FORCES: [&str; 2] = ["penalty", "hunt_crossley"];
/// Keys that not every law reads, with the laws that do.
const KEYS: [(&str, &[&str]); 5] = [
    ("share", &["compensation"]),
    ("restitution", &["stronge", "newton", "moreau"]),
    ("friction", &IMPACTS),
    ("stiffness", &FORCES),
    ("dissipation", &["hunt_crossley"]),
];

/// A `[[contacts]]` table: the pairs it means, none of which an `earlier` table may have named: two laws would share
/// one load between them in any way.
pub(super) fn contact(
    table: &Table,
    parts: &[Part],
    earlier: &[Contact],
    found: &mut Diagnostics,
) -> Vec<Contact> {
    let fields = Fields::of("contacts", table.span, table);
    let between = fields.need("between", "[\"load\", \"ground\"]", found);
    let sides = between.and_then(|value| sides(value, parts, found));
    let law = law(&fields, found);
    finish(fields, law.is_some(), found);
    let (Some([one, other]), Some(law)) = (sides, law) else { return Vec::new() };
    let mut pairs = Vec::new();
    for a in &one {
        for b in other.iter().filter(|b| *b != a) {
            if !pairs.iter().any(|c: &Contact| c.between == [*b, *a]) {
                pairs.push(Contact { between: [*a, *b], law });
            }
        }
    }
    if pairs.is_empty() {
        let error = Diagnostic::error("`between` names one part twice");
        found.push(error.label(fields_span(between, table), "these are one").help("name two parts"));
    }
    let span = fields_span(between, table);
    pairs.iter().for_each(|pair| refuse_without_depth(pair, parts, span, found));
    let again = |pair: &&Contact| {
        let [a, b] = pair.between;
        earlier.iter().any(|contact| contact.between == [a, b] || contact.between == [b, a])
    };
    if let Some(pair) = pairs.iter().find(again) {
        let [a, b] = pair.between.map(|part| &parts[part].name);
        let error = Diagnostic::error(format!("`{a}` and `{b}` have a law of contact already"));
        let help =
            "keep one of the two tables; copies of a grid are named one by one where their laws differ";
        found.push(error.label(span, "named by an earlier table").help(help));
    }
    pairs
}

/// Refuses a force law for parts whose points of contact come and go: a force that begins at a depth has no energy.
fn refuse_without_depth(pair: &Contact, parts: &[Part], span: Span, found: &mut Diagnostics) {
    let Law::Force(_) = pair.law else { return };
    let [one, other] = pair.between.map(|part| &parts[part]);
    let shape = |part: &Part| match &part.kind {
        Kind::Rigid(rigid) => Some(rigid.shape),
        _ => None,
    };
    let is_met = |shape: &Shape<f64>| matches!(shape, Shape::Sphere(_) | Shape::HalfSpace);
    let why = match (shape(one), shape(other)) {
        (Some(a), Some(b)) if !is_met(&a) && !is_met(&b) => {
            "of two boxes or capsules the points of contact change, and a force at each of them would jump"
        }
        (None, None) => "the force of a facet on a node has no potential where normals are interpolated",
        _ => return,
    };
    let error = Diagnostic::error(format!("no force law for `{}` and `{}`: {why}", one.name, other.name));
    let help = "force laws act between a ball or a half-space and any shape, and between nodes and shapes; for these parts take \
                impact = \"stronge\" or \"moreau\"";
    found.push(error.label(span, "these parts").help(help));
}

/// Reports fields that the law does not read, and says which laws read those that are known.
fn finish(fields: Fields<'_>, is_known: bool, found: &mut Diagnostics) {
    let named = ["impact", "force"].into_iter().find_map(|key| match fields.get(key) {
        Some(Value::Text(text)) if is_known => Some((key, text.text.as_str())),
        _ => None,
    });
    for (key, laws) in KEYS {
        let value = fields.get(key);
        let Some((kind, law)) = named.filter(|(_, law)| !laws.contains(law)) else { continue };
        if let Some(value) = value {
            let error = Diagnostic::error(format!("{kind} = \"{law}\" reads no `{key}`"));
            let other = if laws.iter().all(|law| FORCES.contains(law)) { "force" } else { "impact" };
            let help = format!("leave it out, or take {other} = \"{}\"", laws.join("\", \""));
            found.push(
                error.label(value.span(), format!("`{key}` is read by {}", laws.join(", "))).help(help),
            );
        }
    }
    fields.finish(found);
}

fn fields_span(value: Option<&Value>, table: &Table) -> Span {
    value.map_or(table.span, Value::span)
}

fn sides(value: &Value, parts: &[Part], found: &mut Diagnostics) -> Option<[Vec<usize>; 2]> {
    let Value::Array(items, _) = value else {
        found.push(
            wrong_kind("between", "the names of two parts", value).help("between = [\"load\", \"ground\"]"),
        );
        return None;
    };
    let [Value::Text(one), Value::Text(other)] = &items[..] else {
        let error = Diagnostic::error("`between` must name two parts");
        found.push(
            error
                .label(value.span(), format!("these are {}", items.len()))
                .help("between = [\"load\", \"ground\"]"),
        );
        return None;
    };
    let mut side = |text: &Text| {
        let named = parts_named(&text.text, parts);
        if named.is_empty() {
            unknown_part(&text.text, text.span, parts, found);
        }
        (!named.is_empty()).then_some(named)
    };
    let (one, other) = (side(one), side(other));
    Some([one?, other?])
}

/// The law of a contact; a pair without one is refused.
fn law(fields: &Fields<'_>, found: &mut Diagnostics) -> Option<Law> {
    match (fields.get("impact"), fields.get("force")) {
        (Some(_), None) => impact(fields, found),
        (None, Some(_)) => force(fields, found).map(Law::Force),
        (None, None) => {
            let error = Diagnostic::error("a pair of parts without a law");
            let help = format!(
                "add impact = \"stronge\" (known: {}), restitution and friction, or force = \"penalty\" (known: {}) and \
                 stiffness",
                IMPACTS.join(", "),
                FORCES.join(", ")
            );
            found.push(error.label(fields.span, "`impact` is missing").help(help));
            None
        }
        (Some(_), Some(force)) => {
            let error = Diagnostic::error("a pair of parts with two laws");
            let label = "beside `impact`";
            found.push(error.label(force.span(), label).help("keep one of `impact` and `force`"));
            None
        }
    }
}

/// A law of the force on an overlap.
fn force(fields: &Fields<'_>, found: &mut Diagnostics) -> Option<ForceLaw<f64>> {
    let law = fields.text("force", found)?;
    let kind = one_of(&law.text, law.span, ("force law", &FORCES), found)?;
    let unit = if kind == "penalty" { "N/m" } else { "N/m^(3/2)" };
    let stiffness = needed(fields, "stiffness", (unit, &format!("\"1e5 {unit}\"")), found)?;
    if kind == "penalty" {
        return Some(ForceLaw::Penalty { stiffness });
    }
    let dissipation = number(fields, "dissipation", "s/m", Bound::NotNegative, found).unwrap_or(0.0);
    Some(ForceLaw::HuntCrossley { stiffness, dissipation })
}

/// A law of impact.
fn impact(fields: &Fields<'_>, found: &mut Diagnostics) -> Option<Law> {
    let impact = fields.text("impact", found)?;
    let kind = one_of(&impact.text, impact.span, ("law of impact", &IMPACTS), found)?;
    let friction = number(fields, "friction", "", Bound::NotNegative, found).unwrap_or(0.0);
    if kind == "moreau" {
        let restitution = number(fields, "restitution", "", Bound::Share, found).unwrap_or(0.0);
        return Some(Law::Moreau { restitution, friction });
    }
    let law = match kind {
        "stronge" => {
            Located::stronge(number(fields, "restitution", "", Bound::Share, found).unwrap_or(0.0), friction)
        }
        "newton" => {
            Located::newton(number(fields, "restitution", "", Bound::Share, found).unwrap_or(0.0), friction)
        }
        "compensation" => {
            Located::compensation(number(fields, "share", "", Bound::Share, found).unwrap_or(1.0), friction)
        }
        _ => Located::stronge(0.0, friction),
    };
    law.map(Law::Located)
        .map_err(|why| {
            let (message, help) = match why {
                LawFault::NewtonWithFriction => (
                    "Newton's restitution with friction can create energy",
                    "take impact = \"stronge\", or friction = 0",
                ),
                LawFault::Restitution => ("restitution is from 0 to 1", "correct the number"),
                LawFault::Friction => ("friction is 0 or more", "correct the number"),
            };
            found.push(Diagnostic::error(message).label(impact.span, "this law").help(help));
        })
        .ok()
}
