//! `extends = "other.toml"`: merges this model's entries into those of the other model.
//!
//! An entry of the same section and name overrides the fields that it gives and keeps the others; a short one, such as
//! `n = 3`, gives the field that it is short for. An entry of another section with the name of a quantity replaces that
//! quantity: a parameter of the base may become a definition, an input a definition; the law that the base has for that
//! input goes with it.

use super::document::{Key, Table, Value};
use super::repeat::Sections;

/// Sections whose names share one name space.
const QUANTITIES: [&str; 6] = ["parameters", "coordinates", "speeds", "inputs", "definitions", "points"];

/// The base with the extension on top.
pub fn extend(base: Option<Sections>, extension: Sections) -> Sections {
    let Some(mut base) = base else { return extension };
    for (key, value) in extension.scalars {
        put(&mut base.scalars, None, (key, value));
    }
    for (section, entries) in extension.tables {
        for (key, value) in entries {
            if QUANTITIES.contains(&section.as_str()) {
                for other in QUANTITIES.iter().filter(|other| **other != section) {
                    if remove(&mut base, other, &key) && *other == "inputs" {
                        remove(&mut base, "law", &key);
                    }
                }
            }
            let short_for = short_for(&section);
            put(base.tables.entry(section.clone()).or_default(), short_for, (key, value));
        }
    }
    base.configurations.extend(extension.configurations);
    base
}

/// Removes the base's entry of that name from a section; says whether there was one.
fn remove(base: &mut Sections, section: &str, key: &Key) -> bool {
    let Some(entries) = base.tables.get_mut(section) else { return false };
    let before = entries.len();
    entries.retain(|(known, _)| known.name != key.name || known.span.file == key.span.file);
    entries.len() < before
}

/// The field that an entry without braces gives, in sections where it may have either form.
fn short_for(section: &str) -> Option<&'static str> {
    match section {
        "parameters" | "definitions" | "outputs" => Some("value"),
        "points" => Some("position"),
        _ => None,
    }
}

/// An entry without braces as one with them, which gives the field that it is short for.
fn long(key: &Key, value: Value, short_for: Option<&str>) -> Value {
    let Some(field) = short_for else { return value };
    let entries = vec![(Key { name: field.to_owned(), span: key.span }, value)];
    Value::Table(Table { entries, span: key.span })
}

/// Replaces the entry of that name, or appends.
fn put(entries: &mut Vec<(Key, Value)>, short_for: Option<&str>, (key, value): (Key, Value)) {
    let Some((known, old)) =
        entries.iter_mut().find(|(known, _)| known.name == key.name && known.span.file != key.span.file)
    else {
        return entries.push((key, value));
    };
    let before = std::mem::replace(old, Value::Boolean(false, key.span));
    let (before, value) = match [&before, &value].map(|value| matches!(value, Value::Table(_))) {
        [true, false] => (before, long(&key, value, short_for)),
        [false, true] => (long(known, before, short_for), value),
        _ => (before, value),
    };
    (*known, *old) = overridden(before, (key, value));
}

/// An entry with the fields of another one on top, under the key of that one.
pub fn overridden(old: Value, (key, value): (Key, Value)) -> (Key, Value) {
    let (mut old, new) = match (old, value) {
        (Value::Table(old), Value::Table(new)) => (old, new),
        (_, value) => return (key, value),
    };
    for (field, value) in new.entries {
        match old.entries.iter_mut().find(|(known, _)| known.name == field.name) {
            Some(entry) => *entry = (field, value),
            None => old.entries.push((field, value)),
        }
    }
    (key, Value::Table(old))
}
