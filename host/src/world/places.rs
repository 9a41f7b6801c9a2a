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
}

/// Places decide nothing about a world: two that differ in them alone are written alike.
impl fmt::Debug for Places {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Places")
    }
}

impl Places {
    /// Of a scene's table in its text.
    pub(super) fn new(source: Source, scene: Table) -> Self {
        Self { source, scene: Arc::new(scene) }
    }

    /// The place of the value under a path of keys; of the last key that there is, if one is left out.
    pub(super) fn key(&self, path: &[&str]) -> Span {
        let (mut table, mut place) = (&*self.scene, Span::default());
        for name in path {
            let Some((key, value)) = table.entries.iter().find(|(key, _)| key.name == *name) else { break };
            let Value::Table(inner) = value else { return value.span() };
            (table, place) = (inner, key.span);
        }
        place
    }

    /// A failure of one error, whose labels are places of this text.
    pub(super) fn failure(&self, error: Diagnostic) -> Failure {
        Failure::Found(Box::new(Diagnostics::one(self.source.clone(), error)))
    }
}
