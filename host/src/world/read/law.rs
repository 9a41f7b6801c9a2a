//! Reads the law of a `[[contacts]]` table, and refuses laws that no step treats together.

use super::value::{Bound, needed, number, one_of};
use crate::world::assembly::{Contact, Law, mixed};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Value;
use smartbed_codegen::source::Span;
use smartbed_runtime::contact::ForceLaw;
use smartbed_runtime::rigid::law::{Law as Located, LawFault};

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

/// The law of a contact; a pair without one is refused.
pub(super) fn read(fields: &Fields<'_>, found: &mut Diagnostics) -> Option<Law> {
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

/// Reports fields that the law does not read, and says which laws read those that are known.
pub(super) fn finish(fields: Fields<'_>, is_known: bool, found: &mut Diagnostics) {
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

/// Refuses a law that locates touches beside one that does not; `places` are those of the laws by contact.
pub(super) fn refuse_mixed(contacts: &[Contact], places: &[Span], found: &mut Diagnostics) {
    let Some(other) = mixed(contacts) else { return };
    let error = Diagnostic::error("some contacts have impact = \"moreau\", others another law");
    let error = error.label(places[other], "this law").label(places[0], "does not go with this one");
    found.push(error.help("a world either locates all touches or none; take moreau for all or for none"));
}
