//! Applies `--set parts.load.mass=7_kg`: changes keys of a scene for one run. Each setting is a text of its own in
//! messages.

use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::document::{self, Table, Value};
use smartbed_codegen::source::{File, Source, Span};
use std::sync::Arc;

/// The scene's table with the settings applied; errors in them are added to `found`.
pub(crate) fn apply(mut table: Table, settings: &[String], found: &mut Diagnostics) -> Table {
    for setting in settings {
        let file = u32::try_from(found.source.files.len()).unwrap_or(u32::MAX);
        let (text, read) = toml(setting, file);
        let mut files: Vec<File> = found.source.files.to_vec();
        files.push(File::new("--set".to_owned(), text));
        found.source = Source { files: Arc::new(files) };
        match read {
            Some(given) => merge(&mut table, given),
            None => {
                let span = Span { start: 0, end: setting.len().max(1), file };
                let error = Diagnostic::error("a setting is KEY=VALUE").label(span, "this is none");
                found.push(error.help("for example --set run.seconds=2, --set parts.load.mass=7_kg"));
            }
        }
    }
    table
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

/// Values in `given` override those of the same keys, table by table.
fn merge(table: &mut Table, given: Table) {
    for (key, value) in given.entries {
        let known = table.entries.iter_mut().find(|(own, _)| own.name == key.name);
        match (known, value) {
            (Some((_, Value::Table(own))), Value::Table(inner)) => merge(own, inner),
            (Some(entry), value) => *entry = (key, value),
            (None, value) => table.entries.push((key, value)),
        }
    }
}
