//! `command` of a mechanism: coordinates, or quantities that coordinates follow, as functions of time.
//!
//! In: the table of the scene, the model. Out: sections of a model that extends it, in which each commanded coordinate
//! is a closed form and each commanded quantity a definition. A model says in `[commanded]` which coordinates follow
//! which quantities: the heights of a tile's legs follow heave and slopes.

use super::value::{one_of, refuse_without_unit};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::id::Id;
use smartbed_codegen::model::document::{Key, Table, Text, Value, wrong_kind};
use smartbed_codegen::model::expression::{Expr, ExprKind};
use smartbed_codegen::model::{Commanded, Definition, DefinitionId, Model, Speed, SpeedMeaning};
use smartbed_codegen::source::Span;
use std::fmt::Write as _;

/// A coordinate that is commanded: its closed form, and where the scene says so.
struct Law<'a> {
    coordinate: &'a str,
    form: &'a str,
    /// The key of the scene's table: the coordinate's name, or the quantity that it follows.
    key: &'a Key,
}

/// The sections as text, and the coordinates that are commanded. None if something is wrong, which has been reported.
pub(super) fn sections(
    part: &str,
    table: &Table,
    base: &Model,
    found: &mut Diagnostics,
) -> Option<(String, Vec<String>)> {
    let quantities = quantities(base);
    let mut known: Vec<&str> = base.coordinates.iter().map(|c| c.name.as_str()).collect();
    known.extend(quantities.iter().map(|(_, quantity)| quantity.name.as_str()));
    let (mut definitions, mut laws) = (String::new(), Vec::<Law<'_>>::new());
    for (key, value) in &table.entries {
        let name = one_of(&key.name, key.span, ("coordinate", &known), found)?;
        let law = text_of(name, value, found)?;
        let coordinate = base.coordinates.iter().find(|c| c.name == name);
        let unit = match (coordinate, quantities.iter().find(|(_, quantity)| quantity.name == name)) {
            (Some(coordinate), _) => {
                laws.push(Law { coordinate: name, form: &law.text, key });
                Some(&coordinate.written_unit)
            }
            (None, Some((id, quantity))) => {
                let _ = writeln!(definitions, "{name} = {{ value = {:?} }}", law.text);
                for own in base.commanded.iter().filter(|own| mentions(&own.value, *id)) {
                    let coordinate = base.coordinates[own.coordinate].name.as_str();
                    let is_known = |law: &&Law<'_>| law.coordinate == coordinate && law.form == own.written;
                    if !laws.iter().any(|law| is_known(&law)) {
                        laws.push(Law { coordinate, form: &own.written, key });
                    }
                }
                quantity.written_unit.as_ref()
            }
            (None, None) => None,
        };
        if let Some(unit) = unit {
            refuse_without_unit(name, value, unit, found);
        }
    }
    refuse_twice(part, &laws, found)?;
    let mut text = if definitions.is_empty() { definitions } else { format!("[definitions]\n{definitions}") };
    text += "[coordinates]\n";
    for Law { coordinate, form, key } in &laws {
        let speed = own_speed(part, coordinate, key.span, base, found)?;
        let _ = writeln!(text, "{coordinate} = {{ closed_form = {form:?}, independent = false{speed} }}");
    }
    let is_commanded = |name: &str| laws.iter().any(|law| law.coordinate == name);
    text += &still_independent(base, is_commanded);
    Some((text, laws.iter().map(|law| law.coordinate.to_owned()).collect()))
}

/// What a scene may command beside coordinates: the definitions of a plain number that `[commanded]` mentions.
fn quantities(base: &Model) -> Vec<(DefinitionId, &Definition)> {
    let is_number = |definition: &Definition| matches!(definition.value.kind, ExprKind::Number(_));
    let named = |id| base.commanded.iter().any(|Commanded { value, .. }| mentions(value, id));
    (0..base.definitions.len())
        .map(DefinitionId::from_index)
        .map(|id| (id, &base.definitions[id]))
        .filter(|(id, definition)| is_number(definition) && named(*id))
        .collect()
}

fn mentions(value: &Expr, id: DefinitionId) -> bool {
    let mut is_there = false;
    value.visit(&mut |e| is_there |= matches!(e.kind, ExprKind::Definition(own) if own == id));
    is_there
}

/// The law as text.
fn text_of<'v>(name: &str, value: &'v Value, found: &mut Diagnostics) -> Option<&'v Text> {
    if let Value::Text(law) = value {
        return Some(law);
    }
    let error = wrong_kind(name, "an expression of the time t in quotes", value);
    found.push(error.help("for example \"0.005_m*(1 - cos(2*pi*t/20_s))\""));
    None
}

/// Refuses two laws for one coordinate: its own, and that of a quantity which it follows.
fn refuse_twice(part: &str, laws: &[Law<'_>], found: &mut Diagnostics) -> Option<()> {
    for (n, law) in laws.iter().enumerate() {
        let Some(other) = laws[..n].iter().find(|other| other.coordinate == law.coordinate) else { continue };
        let [first, second] = [&other.key.name, &law.key.name];
        let error = Diagnostic::error(format!("`{}` of `{part}` is commanded twice", law.coordinate))
            .label(other.key.span, format!("by `{first}`"))
            .label(law.key.span, format!("and by `{second}`"));
        found.push(error.help(format!("command `{first}` or `{second}`, not both")));
        return None;
    }
    Some(())
}

/// The field `speed` of a commanded coordinate, whose rate is not free any more. Refuses one whose rate the model
/// states by other speeds: no speed of it can be given up.
fn own_speed(part: &str, name: &str, place: Span, base: &Model, found: &mut Diagnostics) -> Option<String> {
    let own = |s: &&Speed| matches!(s.meaning, SpeedMeaning::RateOf(id) if base.coordinates[id].name == name);
    let coordinate = base.coordinates.iter().find(|c| c.name == name)?;
    let why = match base.speeds.iter().find(own) {
        Some(speed) if speed.independent => {
            return Some(format!(", speed = {{ name = {:?}, independent = false }}", speed.name));
        }
        // What is dependent for another reason than a motion constraint is left to the model's own checks.
        Some(_) if !coordinate.independent => return Some(String::new()),
        None if coordinate.closed_form.is_some() => return Some(String::new()),
        Some(_) => "motion constraints, such as rolling, state its rate",
        None => "it has no speed of its own",
    };
    let free = base.speeds.iter().filter(|speed| speed.independent);
    let free = free.filter_map(|speed| match speed.meaning {
        SpeedMeaning::RateOf(id) => Some(base.coordinates[id].name.as_str()),
        SpeedMeaning::Combination(_) => None,
    });
    let free: Vec<&str> = free.collect();
    let help = match free.as_slice() {
        [] => "the model has none that can; give it joints that turn or slide about one axis".to_owned(),
        free => format!("those that can are {}", free.join(", ")),
    };
    let error = Diagnostic::error(format!("`{name}` of `{part}` cannot be commanded: {why}"));
    found.push(error.label(place, "this coordinate").help(help));
    None
}

/// Marks what remains independent beside commanded coordinates: in a model without constraints all coordinates are
/// so without a mark, in one with a closed form none is.
fn still_independent(base: &Model, is_commanded: impl Fn(&str) -> bool) -> String {
    let mut text = String::new();
    for coordinate in base.coordinates.iter().filter(|c| c.independent && !is_commanded(&c.name)) {
        let _ = writeln!(text, "{} = {{ independent = true }}", coordinate.name);
    }
    let of_its_own = |s: &&Speed| s.independent && matches!(s.meaning, SpeedMeaning::Combination(_));
    let speeds: Vec<&Speed> = base.speeds.iter().filter(of_its_own).collect();
    if !speeds.is_empty() {
        text += "[speeds]\n";
    }
    for speed in speeds {
        let _ = writeln!(text, "{} = {{ independent = true }}", speed.name);
    }
    text
}
