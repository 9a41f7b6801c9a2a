//! Model text -> [`Model`]: the stages in order, each ending with all its errors at once.

use std::path::Path;

use super::*;
use super::{build, check, document, order, repeat};
use crate::diagnostic::{Diagnostic, Diagnostics};

/// Largest model text in bytes.
const LARGEST_TEXT: usize = 4 << 20;

/// Reads a model from its text; `path` is its name in messages.
///
/// # Errors
/// All errors of the first stage that found any, with their places.
pub fn parse(path: &str, text: &str) -> Result<Model, Diagnostics> {
    let source = Source::new(path, text);
    let mut found = Diagnostics::new(source.clone());
    if LARGEST_TEXT < text.len() {
        found.push(Diagnostic::error(format!("the model is larger than {LARGEST_TEXT} bytes")));
        return Err(found);
    }
    let table = match document::parse(text, 0) {
        Ok(table) => table,
        Err(errors) => {
            errors.into_iter().for_each(|error| found.push(error));
            return Err(found);
        }
    };
    let sections = repeat::expand(&table, &mut found);
    let mut draft = build::build(&source, &sections, &mut found);
    let mut found = next_stage(found)?;
    draft.model.order = order::sort(&draft.model, &mut found);
    let mut found = next_stage(found)?;
    check::check(&mut draft, &mut found);
    let mut found = next_stage(found)?;
    let model = check::evaluate(draft, &mut found);
    found.finish(model)
}

/// Reads a model from a file.
///
/// # Errors
/// The file cannot be read, or what [`parse`] finds.
pub fn read(path: &Path) -> Result<Model, Diagnostics> {
    let name = path.display().to_string();
    match std::fs::read_to_string(path) {
        Ok(text) => parse(&name, &text),
        Err(error) => {
            let message = format!("cannot read {name}: {error}");
            Err(Diagnostics::one(Source::new(&name, ""), Diagnostic::error(message)))
        }
    }
}

/// Goes on if no error was found.
fn next_stage(found: Diagnostics) -> Result<Diagnostics, Diagnostics> {
    if found.has_errors() { Err(found) } else { Ok(found) }
}
