//! Model text -> [`Model`]: runs the stages in order; each reports all its errors before the next one starts.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::check::{evaluate, order, reach, units};
use super::data::Model;
use super::text::amount;
use super::text::document::{self, Table, Value, wrong_kind};
use super::text::repeat::{self, Sections};
use super::text::{extend, joints, sections};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::source::File;
use crate::source::{Source, Span};

/// Largest model text in bytes.
const LARGEST_TEXT: usize = 1 << 20;
/// Most marks (of values, keys and lines) in a text: some eight for each of the entries that are allowed.
const MOST_MARKS: usize = 80_000;

/// Longest chain of models that extend one another.
const LONGEST_CHAIN: usize = 8;

/// Gives the text of the file at a path, or says why it cannot.
type Loader<'a> = &'a dyn Fn(&Path) -> Result<String, String>;

/// Reads a model from its text; `path` is its name in messages. What the model extends is read
/// from files next to it.
///
/// # Errors
/// All errors of the first stage that found any, with their places.
pub fn parse(path: &str, text: &str) -> Result<Model, Diagnostics> {
    parse_with(path, text, &text_of)
}

/// Reads a model from a file.
///
/// # Errors
/// The file cannot be read, or what [`parse`] finds.
pub fn read(path: &Path) -> Result<Model, Diagnostics> {
    read_in(Path::new(""), path)
}

/// Reads a model from a file in a folder that no message names.
///
/// # Errors
/// As [`read`].
pub fn read_in(folder: &Path, path: &Path) -> Result<Model, Diagnostics> {
    let name = path.display().to_string();
    match text_of(&folder.join(path)) {
        Ok(text) => parse_with(&name, &text, &|file| text_of(&folder.join(file))),
        Err(error) => {
            let message = format!("cannot read {name}: {error}");
            Err(Diagnostics::one(Source::new(&name, ""), Diagnostic::error(message)))
        }
    }
}

/// The text of a file, read to just beyond [`LARGEST_TEXT`] at most, because a pipe or a device may never end.
fn text_of(path: &Path) -> Result<String, String> {
    let is_file = std::fs::metadata(path).map_err(|e| e.to_string())?.is_file();
    if !is_file {
        return Err("it is no file; expected the text of a model".to_owned());
    }
    let file = std::fs::File::open(path).map_err(|e| e.to_string())?;
    let mut text = String::new();
    file.take(LARGEST_TEXT as u64 + 1).read_to_string(&mut text).map_err(|e| e.to_string())?;
    Ok(text)
}

/// As [`parse`], with the text of extended models given by `load` (path as in messages -> text).
///
/// # Errors
/// As [`parse`].
pub fn parse_with(path: &str, text: &str, load: Loader<'_>) -> Result<Model, Diagnostics> {
    let (source, tables, mut found) = chain(path, text, load);
    if found.has_errors() {
        return Err(found);
    }
    // The chain is read from its end, the model that extends no other.
    let mut sections = None;
    for table in tables.into_iter().rev() {
        sections = Some(extend::extend(sections, repeat::expand(table, &mut found)));
    }
    let mut sections: Sections = sections.unwrap_or_default();
    if !joints::expand(&mut sections, &mut found) {
        return Err(found);
    }
    let mut draft = sections::read(&source, &sections, &mut found);
    let mut found = next_stage(found)?;
    draft.model.order = order::sort(&draft.model, &mut found);
    let mut found = next_stage(found)?;
    units::check(&mut draft, &mut found);
    reach::check(&draft, &mut found);
    let mut found = next_stage(found)?;
    let model = evaluate::evaluate(draft, &mut found);
    found.finish(model)
}

/// The tables of the model and of those it extends, with all texts.
fn chain(path: &str, text: &str, load: Loader<'_>) -> (Source, Vec<Table>, Diagnostics) {
    let mut files = vec![File::new(path.to_owned(), text.to_owned())];
    let (mut tables, mut items) = (Vec::new(), Vec::new());
    let mut at = PathBuf::from(path);
    loop {
        let file = u32::try_from(files.len() - 1).unwrap_or(u32::MAX);
        let text = &files[files.len() - 1].text;
        let marks = amount::marks(text);
        let excess = if text.len() > LARGEST_TEXT {
            Some(format!("the model is larger than {LARGEST_TEXT} bytes"))
        } else if marks > MOST_MARKS {
            Some(format!("the model has {marks} values, keys and lines; at most {MOST_MARKS} are allowed"))
        } else {
            None
        };
        if let Some(message) = excess {
            items.push(
                Diagnostic::error(message)
                    .label(Span { start: 0, end: 1, file }, "split the model by `extends`, or use [repeat]"),
            );
            break;
        }
        let table = match document::parse(text, file) {
            Ok(table) => table,
            Err(errors) => {
                items.extend(errors);
                break;
            }
        };
        let base = table.get("extends").cloned();
        tables.push(table);
        let base = match base {
            None => break,
            Some(Value::Text(base)) => base,
            Some(other) => {
                items.push(wrong_kind("extends", "the path of a model in quotes", &other));
                break;
            }
        };
        at = at.parent().map_or_else(PathBuf::new, Path::to_path_buf).join(&base.text);
        let name = at.display().to_string();
        let fault = if LONGEST_CHAIN < files.len() || files.iter().any(|f| f.path == name) {
            Err("the models extend each other in a circle, or too often".to_owned())
        } else {
            load(&at)
        };
        match fault {
            Ok(text) => files.push(File::new(name, text)),
            Err(reason) => {
                let help = match !name.ends_with(".toml") && load(Path::new(&format!("{name}.toml"))).is_ok()
                {
                    true => format!("did you mean `{}.toml`?", base.text),
                    false => "the path counts from the folder of the model that extends it".to_owned(),
                };
                items.push(
                    Diagnostic::error(format!("cannot extend {name}: {reason}"))
                        .label(base.span, "this model")
                        .help(help),
                );
                break;
            }
        }
    }
    let source = Source { files: Arc::new(files) };
    (source.clone(), tables, Diagnostics { source, items })
}

/// Ends a stage: passes on the warnings if no error was found.
fn next_stage(found: Diagnostics) -> Result<Diagnostics, Diagnostics> {
    if found.has_errors() { Err(found) } else { Ok(found) }
}
