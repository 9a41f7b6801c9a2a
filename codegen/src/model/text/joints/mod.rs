//! `[joints]`: each entry says how a link is joined to another one and is replaced by entries of other sections.
//!
//! In: the sections after repetition and extension. Out: the same without `[joints]`, plus the coordinates, speeds,
//! frames, points, constraints and loads that the joints stand for; later stages know nothing of joints. `kind` is the
//! table of joints, `axis` reads axes, `parts` writes the entries.

mod axis;
mod kind;
mod parts;

use super::document::{Key, Value};
use super::fields::Fields;
use super::repeat::{self, Sections};
use super::scope::suggestion;
use crate::diagnostic::{Diagnostic, Diagnostics};
use axis::{Along, Direction, Motion};
use kind::{KINDS, Kind};
use parts::Parts;

/// The two axes of a universal joint count as perpendicular if their cosine is below this: the rounding of numbers
/// written with nine digits.
const PERPENDICULAR: f64 = 1e-9;

/// Replaces all joints by the entries that they stand for; false if one could not be read, which has been reported.
pub fn expand(sections: &mut Sections, found: &mut Diagnostics) -> bool {
    let before = found.items.len();
    sections.note_constraints();
    let joints = sections.tables.remove("joints").unwrap_or_default();
    for (key, value) in &joints {
        if let Some(fields) = Fields::new(key, value, found) {
            joint(key, &fields, sections, found);
            // Only a joint that could be read has asked for all its fields, so that any other field is an error.
            if found.items.len() == before {
                fields.finish(found);
            }
        }
    }
    if let Some((last, _)) = joints.last() {
        repeat::limit(sections, last.span, found);
    }
    found.items.len() == before
}

fn joint(key: &Key, fields: &Fields<'_>, sections: &mut Sections, found: &mut Diagnostics) {
    let kind = kind_of(fields, found);
    let child = name_in(fields, "child", "\"link\"", found);
    let Some((kind, child)) = kind.zip(child) else { return };
    let Some(axes) = axes(key, fields, kind, found) else { return };
    let parent = fields.text("parent", found).map_or_else(|| "N".to_owned(), |text| text.text.clone());
    let at = match fields.get("at") {
        None if parent == "N" => Some(Value::Text(super::document::Text::made("O", key.span))),
        None => fields.need("at", "\"...\", the vector from O to the joint", found).cloned(),
        given => given.cloned(),
    };
    let Some(at) = at else { return };
    let turned = fields.array("turned", found).map_or(&[][..], |(steps, _)| steps);
    let independent = fields.boolean("independent", found).unwrap_or(!sections.constrained);

    // A single rotation is appended to the fixed ones; any other motion needs a frame after the fixed rotations.
    let single_turn = matches!(kind.motions, [Motion::Turn(..)]);
    let base_frame = (!turned.is_empty() && !single_turn).then(|| format!("{}_base", key.name));
    let base = base_frame.clone().unwrap_or_else(|| parent.clone());
    let mut parts = Parts::new((key, fields), (base, child.clone()), independent, (sections, found));
    if let Some(base) = &base_frame {
        parts.frame(base, &parent, turned.to_vec());
    }
    parts.moves(kind.motions, &axes);
    parts.sits(at);
    match kind.rolls {
        Some(rolls) => rolls(&mut parts),
        None => {
            parts.link(if base_frame.is_some() { &[] } else { turned });
            if kind.motions.iter().any(|m| matches!(m, Motion::Slide(..))) {
                parts.place(&child);
            }
        }
    }
    parts.finish(kind.driven);
}

/// The row of the table named by the field `kind`.
fn kind_of(fields: &Fields<'_>, found: &mut Diagnostics) -> Option<&'static Kind> {
    let word = fields.text("kind", found);
    let Some(word) = word else {
        fields.need("kind", "\"revolute\"", found);
        return None;
    };
    let kind = KINDS.iter().find(|kind| kind.word == word.text);
    if kind.is_none() {
        let all = || format!("joints are {}", KINDS.map(|kind| kind.word).join(", "));
        found.push(
            Diagnostic::error(format!("unknown joint `{}`", word.text))
                .label(word.span, "no joint has this name")
                .help(suggestion(&word.text, KINDS.map(|kind| kind.word)).unwrap_or_else(all)),
        );
    }
    kind
}

/// A required field that holds a name.
fn name_in(
    fields: &Fields<'_>,
    field: &'static str,
    example: &str,
    found: &mut Diagnostics,
) -> Option<String> {
    fields.need(field, example, found)?;
    fields.text(field, found).map(|text| text.text.clone())
}

/// The axes of the joint: from the field `axis` for one, from `axes` for several.
fn axes(key: &Key, fields: &Fields<'_>, kind: &Kind, found: &mut Diagnostics) -> Option<Vec<Direction>> {
    let given: Vec<&Value> = match kind.axes {
        0 => Vec::new(),
        1 => vec![fields.need("axis", "\"z\"", found)?],
        count => match fields.need("axes", "[\"x\", \"y\"]", found)? {
            Value::Array(items, _) if items.len() == count => items.iter().collect(),
            other => {
                let message = format!("a {} joint takes {count} axes", kind.word);
                let help = "axes = [\"x\", \"y\"]: the second turns with the first";
                found.push(Diagnostic::error(message).label(other.span(), "not as many").help(help));
                return None;
            }
        },
    };
    let mut axes = Vec::new();
    for value in given {
        let Some(axis) = Direction::read(value) else {
            found.push(
                Diagnostic::error(format!("joint `{}` has an axis without direction", key.name))
                    .label(value.span(), "neither a letter nor three numbers that are not all 0")
                    .help(
                        "axis = \"z\", axis = \"-x\" or axis = [0, 0.6, 0.8], in the frame of the inner side",
                    ),
            );
            return None;
        };
        let across = kind.motions.iter().any(|m| matches!(m, Motion::Slide(Along::Across(_), _)));
        if across && !axis.is_letter() {
            found.push(
                Diagnostic::error(format!("the axis of a {} joint is x, y or z", kind.word))
                    .label(value.span(), "another direction")
                    .help("turn the joint by `turned`, such as turned = [[\"y\", \"30*deg\"]]"),
            );
            return None;
        }
        axes.push(axis);
    }
    if let [first, second] = &axes[..]
        && first.cosine(second).abs() > PERPENDICULAR
    {
        found.push(
            Diagnostic::error(format!("the axes of joint `{}` are not perpendicular", key.name))
                .label(fields.span, format!("the cosine between them is {:.3}", first.cosine(second)))
                .help("for axes at another angle, use two revolute joints with a massless link between them"),
        );
        return None;
    }
    Some(axes)
}
