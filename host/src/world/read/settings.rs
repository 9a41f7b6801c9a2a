//! Applies `--set parts.load.mass=7_kg`, `--set contacts[0].friction=0.1`: changes keys of a scene for one run. Each
//! setting is a text of its own in messages.

use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::document::{self, Key, Table, Value};
use smartbed_codegen::source::{File, Source, Span};
use std::sync::Arc;

/// The scene's table with the settings applied; errors in them are added to `found`.
pub(crate) fn apply(mut table: Table, settings: &[String], found: &mut Diagnostics) -> Table {
    for setting in settings {
        let file = u32::try_from(found.source.files.len()).unwrap_or(u32::MAX);
        let (text, read) = toml(&dotted(setting), file);
        let end = text.len().max(1);
        let mut files: Vec<File> = found.source.files.to_vec();
        files.push(File::new("--set".to_owned(), text));
        found.source = Source { files: Arc::new(files) };
        match read {
            Some(given) => merge(&mut table, given, found),
            None => {
                let span = Span { start: 0, end, file };
                let error = Diagnostic::error("a setting is KEY=VALUE").label(span, "this is none");
                found.push(error.help("for example --set run.seconds=2, --set parts.load.mass=7_kg, --set contacts[0].friction=0.1"));
            }
        }
    }
    table
}

/// Refuses two settings of one key, or of a key and then of the whole table that holds it: the first would be ignored.
///
/// # Errors
/// A message with the key.
pub fn refuse_twice(settings: &[String]) -> Result<(), String> {
    let paths: Vec<Option<Vec<String>>> = settings.iter().map(|setting| path(setting)).collect();
    let replaced = |n: usize| paths[..n].iter().flatten().find(|first| replaces(paths[n].as_ref(), first));
    let again = (1..paths.len()).find_map(|n| Some((n, replaced(n)?)));
    again.map_or(Ok(()), |(n, first)| {
        let cure = match paths[n].as_ref() == Some(first) {
            true => "leave one of them out",
            false => "this replaces the whole table: leave one of them out, or give the table first",
        };
        Err(format!("--set {}: `{}` is set twice; {cure}", settings[n], first.join(".")))
    })
}

/// Does a setting of the path `later` leave nothing of one of the path `first`: is it the same key, or a table around
/// it?
pub fn replaces(later: Option<&Vec<String>>, first: &[String]) -> bool {
    later.is_some_and(|later| first.starts_with(later))
}

/// The names that lead to the key of a setting, however they are spelled: `contacts`, `0`, `friction` for
/// `contacts[0]."friction" = 0.1`. None if it is no setting.
pub fn path(setting: &str) -> Option<Vec<String>> {
    let (text, table) = toml(&dotted(setting), 0);
    let (key, mut value) = table?.entries.into_iter().next()?;
    let mut names = vec![key.name];
    while is_path(&value, &text) {
        let Value::Table(mut inner) = value else { break };
        let (key, next) = inner.entries.pop()?;
        names.push(key.name);
        value = next;
    }
    Some(names)
}

/// The setting with the numbers of entries of lists as names: `contacts.0.friction=0.1` for `contacts[0].friction=0.1`.
fn dotted(setting: &str) -> String {
    let Some((key, value)) = setting.split_once('=').filter(|(key, _)| !key.contains('"')) else {
        return setting.to_owned();
    };
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let mut parts = key.split('[');
    let mut path = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(']').filter(|(number, _)| is_number(number)) {
            Some((number, rest)) => path += &format!(".{number}{rest}"),
            None => return setting.to_owned(),
        }
    }
    format!("{path}={value}")
}

/// A setting as TOML, with its value unchanged or, if that is no TOML, as a quoted string.
fn toml(setting: &str, file: u32) -> (String, Option<Table>) {
    if let Ok(table) = document::parse(setting, file) {
        return (setting.to_owned(), Some(table));
    }
    let Some((key, value)) = setting.split_once('=') else { return (setting.to_owned(), None) };
    let quoted = format!("{} = {:?}", key.trim(), value.trim());
    let table = document::parse(&quoted, file).ok();
    (quoted, table)
}

/// Is this value of a setting's `text` part of a path, `b` in `b.c = 1`, rather than a table in braces, which stands for
/// all of its keys?
fn is_path(value: &Value, text: &str) -> bool {
    matches!(value, Value::Table(_))
        && !text.get(value.span().start..).is_some_and(|text| text.starts_with('{'))
}

/// The text in which this value stands.
fn text_of<'a>(value: &Value, found: &'a Diagnostics) -> &'a str {
    found.source.files.get(value.span().file as usize).map_or("", |file| &file.text)
}

/// Values in `given` replace those of the same keys; paths lead into tables, and into lists by the numbers of entries.
fn merge(table: &mut Table, given: Table, found: &mut Diagnostics) {
    for (key, value) in given.entries {
        let known = table.entries.iter_mut().find(|(own, _)| own.name == key.name);
        let is_path = is_path(&value, text_of(&value, found));
        match (known, value) {
            (Some((_, Value::Table(own))), Value::Table(inner)) if is_path => merge(own, inner, found),
            (Some((_, Value::Array(own, _))), Value::Table(inner)) if is_path => {
                merge_list(&key, own, inner, found);
            }
            (Some(entry), value) => *entry = (key, value),
            (None, value) => table.entries.push((key, value)),
        }
    }
}

/// The same for the entries of a list, whose numbers are the keys.
fn merge_list(list: &Key, own: &mut [Value], given: Table, found: &mut Diagnostics) {
    let count = own.len();
    for (key, value) in given.entries {
        let is_path = is_path(&value, text_of(&value, found));
        match (key.name.parse().ok().and_then(|number: usize| own.get_mut(number)), value) {
            (Some(Value::Table(own)), Value::Table(inner)) if is_path => merge(own, inner, found),
            (Some(entry), value) => *entry = value,
            (None, _) => {
                let entries = smartbed_codegen::words::count(count, "entry");
                let message = format!("`{}` is a list of {entries}, numbered from 0", list.name);
                let error = Diagnostic::error(message).label(key.span, "no entry of it");
                found.push(error.help(format!("name one: --set {}[0]...", list.name)));
            }
        }
    }
}
