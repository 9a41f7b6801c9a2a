//! Reads `[[contacts]]`: the pairs of parts that touch.

use super::join::{parts_named, unknown_part};
use super::law;
use crate::world::assembly::{Contact, Kind, Law, Part, Rigid};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Text, Value, wrong_kind};
use smartbed_codegen::source::Span;
use smartbed_runtime::surface::Shape;

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
    let law = law::read(&fields, found);
    law::finish(fields, law.is_some(), found);
    let (Some([one, other]), Some(law)) = (sides, law) else { return Vec::new() };
    let mut pairs = Vec::new();
    for a in &one {
        for b in other.iter().filter(|b| *b != a) {
            if !pairs.iter().any(|c: &Contact| c.between == [*b, *a]) {
                pairs.push(Contact { between: [*a, *b], law });
            }
        }
    }
    let span = between.map_or(table.span, Value::span);
    if pairs.is_empty() {
        let error = Diagnostic::error("`between` names one part twice");
        found.push(error.label(span, "these are one").help("name two parts"));
    }
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
        let mechanism = named.iter().find(|part| matches!(parts[**part].kind, Kind::Mechanism(_)));
        if let Some(mechanism) = mechanism {
            refuse_without_surface(text, *mechanism, parts, found);
        }
        (!named.is_empty() && mechanism.is_none()).then_some(named)
    };
    let (one, other) = (side(one), side(other));
    Some([one?, other?])
}

/// Refuses a mechanism in `between`, and names what stands on its ports.
fn refuse_without_surface(text: &Text, mechanism: usize, parts: &[Part], found: &mut Diagnostics) {
    let is_on = |part: &&Part| match &part.kind {
        Kind::Rigid(Rigid { on: Some((carrier, _)), .. }) => *carrier == mechanism,
        _ => false,
    };
    let surfaces: Vec<&str> = parts.iter().filter(is_on).map(|part| part.name.as_str()).collect();
    let help = match surfaces.as_slice() {
        [] => {
            format!("give it one by a rigid part with on = \"{}.PORT\", and name that part here", text.text)
        }
        surfaces => format!("name what is on it: {}", surfaces.join(", ")),
    };
    let error = Diagnostic::error(format!("`{}` is a mechanism, which has no surface", text.text));
    found.push(error.label(text.span, "nothing can touch it").help(help));
}
