//! Where the keys of a scene stand in its text: for what is known to be wrong only once the world is built, such as a
//! sensor of a column that no mechanism has.
//!
//! In: the scene as it was read. Out: errors in the layout of those of reading.

use crate::failure::Failure;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::document::{Table, Value};
use smartbed_codegen::source::{Source, Span};
use std::fmt;
use std::sync::Arc;

/// The text of a scene and the places of its keys. Without a text, errors have no place.
#[derive(Clone, Default)]
pub struct Places {
    source: Source,
    scene: Arc<Table>,
    /// By contact: the place of its `between`.
    contacts: Vec<Span>,
}

/// Places decide nothing about a world: two that differ in them alone are written alike.
impl fmt::Debug for Places {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Places")
    }
}

impl Places {
    /// Of a scene's table in its text; `contacts` are the places of `between` by contact.
    pub(super) fn new(source: Source, scene: Table, contacts: Vec<Span>) -> Self {
        Self { source, scene: Arc::new(scene), contacts }
    }

    /// The place of the value under a path of keys; of the last key that there is, if one is left out.
    pub(super) fn key(&self, path: &[&str]) -> Span {
        let (mut table, mut place) = (&*self.scene, Span::default());
        for name in path {
            // Copies of a grid stand where the part, the sensor or the controller that is repeated does.
            let find = |name: &str| table.entries.iter().find(|(key, _)| key.name == name);
            let Some((key, value)) = find(name).or_else(|| find(whole(name))) else { break };
            let Value::Table(inner) = value else { return value.span() };
            (table, place) = (inner, key.span);
        }
        place
    }

    /// The place of a key of a part, or of the part's name.
    pub(super) fn part(&self, name: &str, key: &str) -> Span {
        self.key(&["parts", name, key])
    }

    /// The place of the names of a contact's parts.
    pub(super) fn contact(&self, number: usize) -> Span {
        self.contacts.get(number).copied().unwrap_or_default()
    }

    /// A failure of one error, whose labels are places of this text.
    pub(super) fn failure(&self, error: Diagnostic) -> Failure {
        Failure::Found(Box::new(Diagnostics::one(self.source.clone(), error)))
    }
}

/// The name in the text of what `grid` has repeated: `tile` of its copy `tile[0,0]`.
#[must_use]
pub fn whole(name: &str) -> &str {
    name.split_once('[').map_or(name, |(whole, _)| whole)
}
