//! `extends = "other.toml"`: merges this model's entries into those of the other model.
//!
//! An entry of the same section and name overrides the fields that it gives and keeps the others. An entry of another
//! section with the name of a quantity replaces that quantity: a parameter of the base may become a definition, an
//! input a definition; the law that the base has for that input goes with it.

use super::document::{Key, Value};
use super::repeat::Sections;

/// Sections whose names share one name space.
const QUANTITIES: [&str; 6] = ["parameters", "coordinates", "speeds", "inputs", "definitions", "points"];

/// The base with the extension on top.
pub fn extend(base: Option<Sections>, extension: Sections) -> Sections {
    let Some(mut base) = base else { return extension };
    for (key, value) in extension.scalars {
        put(&mut base.scalars, key, value);
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
            put(base.tables.entry(section.clone()).or_default(), key, value);
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

/// Replaces the entry of that name, or appends.
fn put(entries: &mut Vec<(Key, Value)>, key: Key, value: Value) {
    let Some((known, old)) =
        entries.iter_mut().find(|(known, _)| known.name == key.name && known.span.file != key.span.file)
    else {
        return entries.push((key, value));
    };
    (*known, *old) = overridden(std::mem::replace(old, Value::Boolean(false, key.span)), (key, value));
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
