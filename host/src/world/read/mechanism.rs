//! Reads a mechanism: a model, commands of the scene, and the position of its origin.
//!
//! What a scene changes is written as a model that extends the one named, so that prescribed motion, units and places in
//! messages are those of models.

use super::command;
use super::value::{list, refuse_without_unit};
use crate::world::assembly::Mechanism;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics, Severity};
use smartbed_codegen::model::document::{Key, Value, wrong_kind};
use smartbed_codegen::model::{self, Fields, Model, RESERVED, SpeedMeaning, is_keyword};
use smartbed_codegen::source::Span;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// The key of `start` that is not a coordinate: the position of the mechanism's origin.
const PLACE: &str = "position";

/// Finds the file of a model by its name, or says that there is none.
pub type Find<'a> = &'a dyn Fn(&str) -> Result<PathBuf, String>;

/// Reads it; `offset` is the displacement of a copy in a grid.
pub(super) fn read(
    fields: &Fields<'_>,
    offset: [f64; 3],
    find: Find<'_>,
    found: &mut Diagnostics,
) -> Option<Mechanism> {
    let name = fields.text("mechanism", found)?;
    let path = match find(&name.text) {
        Ok(path) => path,
        Err(why) => {
            let error = Diagnostic::error(format!("`{}` has no model: {why}", fields.name));
            found.push(error.label(name.span, "no such model").help("name a file, or one of models/"));
            return None;
        }
    };
    let base = match model::read(&path) {
        Ok(model) => model,
        Err(wrong) => {
            let error = Diagnostic::error(format!("the model of `{}` is wrong: {wrong}", fields.name));
            found.push(
                error
                    .label(name.span, "this model")
                    .help("correct it first: `smartbed check` shows all of it"),
            );
            return None;
        }
    };
    let changed = changes(fields, &base, found)?;
    let place =
        fields.table("start", found).and_then(|start| list::<3>(start.get(PLACE)?, PLACE, "m", found));
    let place = place.unwrap_or_default();
    let place = [0, 1, 2].map(|i| place[i] + offset[i]);
    let model = if changed.is_empty() { base } else { extended(fields, &path, &changed, found)? };
    let mechanism = Mechanism { model, place };
    refuse_idle_laws(fields, &mechanism, found);
    Some(mechanism)
}

/// Refuses laws of inputs that move nothing.
fn refuse_idle_laws(fields: &Fields<'_>, mechanism: &Mechanism, found: &mut Diagnostics) {
    let laws = fields.table("law", found).filter(|_| mechanism.is_given());
    for (key, _) in laws.iter().flat_map(|table| &table.entries) {
        found.push(idle((fields.name, &key.name), key.span, "leave the law out"));
    }
}

/// The error for an input of a part that no force moves: only the work of the drive would be another one.
pub(super) fn idle((part, input): (&str, &str), place: Span, cure: &str) -> Diagnostic {
    let error = Diagnostic::error(format!(
        "`{input}` of `{part}` moves nothing: functions of the time give all its motion"
    ));
    let error = error.label(place, "no effect on the motion");
    error.help(format!("{cure}, or take a coordinate out of `command`, which is then free to move"))
}

/// Text of the sections that override those of the model.
fn changes(fields: &Fields<'_>, base: &Model, found: &mut Diagnostics) -> Option<String> {
    let (mut text, mut commanded) = (String::new(), Vec::new());
    if let Some(table) = fields.table("command", found) {
        (text, commanded) = command::sections(fields.name, table, base, found)?;
    }
    for section in ["parameters", "law", "start"] {
        let table = match section {
            "parameters" => fields.table("set", found),
            "law" => fields.table("law", found),
            _ => fields.table("start", found),
        };
        let entries = table.iter().flat_map(|table| &table.entries);
        let mut lines = String::new();
        // The position of the whole mechanism is not a coordinate of the model.
        for (key, value) in entries.filter(|(key, _)| section != "start" || key.name != PLACE) {
            if section == "start" {
                refuse_start(key, base, &commanded, found)?;
            }
            if let Some(unit) = unit_of(base, section, &key.name) {
                refuse_without_unit(&key.name, value, &unit, found);
            }
            let written = match value {
                Value::Text(text) => format!("{:?}", text.text),
                Value::Number(number, _) => format!("{number:?}"),
                other => {
                    found.push(wrong_kind(&key.name, "a number or an expression in quotes", other));
                    return None;
                }
            };
            let _ = match section {
                "parameters" => writeln!(lines, "{} = {{ value = {written} }}", key.name),
                _ => writeln!(lines, "{} = {written}", key.name),
            };
        }
        if !lines.is_empty() {
            let _ = write!(text, "[{section}]\n{lines}");
        }
    }
    let freed = base.coordinates.iter().filter(|c| c.independent && commanded.contains(&c.name)).count();
    let dof = base.dof.map(|(dof, _)| dof).filter(|_| freed > 0);
    let dof = dof.map_or(String::new(), |dof| format!("dof = {}\n", dof.saturating_sub(freed)));
    Some(if text.is_empty() { text } else { dof + &text })
}

/// Refuses the start of a commanded coordinate, or of its rate.
fn refuse_start(key: &Key, base: &Model, commanded: &[String], found: &mut Diagnostics) -> Option<()> {
    let rate = base.speeds.iter().find(|s| s.name == key.name).and_then(|s| match s.meaning {
        SpeedMeaning::RateOf(id) => Some(&base.coordinates[id].name),
        SpeedMeaning::Combination(_) => None,
    });
    let coordinate = rate.unwrap_or(&key.name);
    if !commanded.contains(coordinate) {
        return Some(());
    }
    let error = Diagnostic::error(format!("`{}` starts as `{coordinate}` is commanded", key.name));
    found.push(error.label(key.span, "no other start").help("leave it out, or change the command"));
    None
}

/// The unit in which a model reads plain numbers of a parameter, an input's law, or the start of a coordinate or its
/// rate, and its value in SI.
fn unit_of(base: &Model, section: &str, name: &str) -> Option<(String, f64)> {
    let unit = match section {
        "parameters" => &base.parameters.iter().find(|p| p.name == name)?.written_unit,
        "law" => &base.inputs.iter().find(|input| input.name == name)?.written_unit,
        _ => match base.coordinates.iter().find(|c| c.name == name) {
            Some(coordinate) => &coordinate.written_unit,
            None => {
                let SpeedMeaning::RateOf(id) = base.speeds.iter().find(|s| s.name == name)?.meaning else {
                    return None;
                };
                let (unit, factor) = &base.coordinates[id].written_unit;
                return Some((format!("{unit}/s"), *factor));
            }
        },
    };
    Some(unit.clone())
}

/// The name of a part's own model: the part's, but names of models follow Rust and those of parts need not.
fn model_name(part: &str) -> String {
    let name: String = part.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    let starts = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    let is_word = starts && name.is_ascii() && name.len() <= 64 && name != "_";
    let is_free = !RESERVED.contains(&name.as_str()) && !is_keyword(&name);
    if is_word && is_free { name } else { "part".to_owned() }
}

fn extended(fields: &Fields<'_>, path: &Path, changed: &str, found: &mut Diagnostics) -> Option<Model> {
    let file = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let name = model_name(fields.name);
    let text = format!("format = 1\nextends = {file:?}\nname = {name:?}\n{changed}");
    let shown = path.with_file_name(format!("parts.{}", fields.name));
    match model::parse(&shown.display().to_string(), &text) {
        Ok(model) => Some(model),
        Err(wrong) if told_in_scene(fields, &text, &wrong, found) => None,
        Err(wrong) => {
            let help = match fields.get("command") {
                Some(_) => "the keys of `command`, `law`, `set` and `start` are those of the model",
                None => "the keys of `law`, `set` and `start` are those of the model",
            };
            let error =
                Diagnostic::error(format!("what `{}` changes in its model is wrong: {wrong}", fields.name));
            found.push(error.label(fields.span, "this part").help(help));
            None
        }
    }
}

/// Tells errors of the model at the places of the scene that its changes were written from; false where one has none.
fn told_in_scene(fields: &Fields<'_>, text: &str, wrong: &Diagnostics, found: &mut Diagnostics) -> bool {
    let place = |item: &Diagnostic| {
        let [label] = item.labels.as_slice() else { return None };
        Some((origin(fields, text, label.span)?, label.text.clone()))
    };
    let errors = || wrong.items.iter().filter(|item| item.severity == Severity::Error);
    let Some(places) = errors().map(place).collect::<Option<Vec<_>>>() else { return false };
    for (item, (span, label)) in errors().zip(places) {
        let message = format!("what `{}` changes in its model is wrong: {}", fields.name, item.message);
        let error = Diagnostic::error(message).label(span, label);
        found.push(match &item.help {
            Some(help) => error.help(help.clone()),
            None => error,
        });
    }
    true
}

/// The place in the scene of a place in the value of a line `KEY = ...` written from it.
fn origin(fields: &Fields<'_>, text: &str, at: Span) -> Option<Span> {
    // The first file is this text; those of the model that it extends have places of their own.
    let before = text.get(..at.start).filter(|_| at.file == 0)?;
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let line = text.get(start..)?.lines().next()?;
    let (key, _) = line.split_once(" = ")?;
    let given = |section: &'static str| match fields.get(section)? {
        Value::Table(table) => match table.get(key)? {
            Value::Text(given) => {
                line.find(&format!("{:?}", given.text)).map(|quote| (given, start + quote + 1))
            }
            _ => None,
        },
        _ => None,
    };
    let (given, first) = ["command", "set", "law", "start"].into_iter().find_map(given)?;
    let inside = first <= at.start && at.end <= first + given.text.len();
    Some(if inside { given.place(at.start - first..at.end - first) } else { given.span })
}
