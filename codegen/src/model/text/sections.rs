//! Sections -> [`Draft`]: declares all names first, then reads every entry with names resolved to ids.
//!
//! Values that must be numbers (nominal values, ranges, starts) remain expressions here; they are evaluated once the
//! parameters have been put in order and checked.

use super::builder::Builder;
use super::repeat::Sections;
use super::scope::Scope;
use crate::diagnostic::Diagnostics;
use crate::model::draft::Draft;
use crate::source::Source;

/// Reads all sections.
pub fn read(source: &Source, sections: &Sections, found: &mut Diagnostics) -> Draft {
    let mut scope = Scope::default();
    let mut builder = Builder {
        draft: Draft::empty(source),
        sections,
        scope: &mut scope,
        found,
        planned_speeds: Vec::new(),
    };
    builder.header();
    builder.declare();
    builder.parameters();
    builder.coordinates();
    builder.speeds();
    builder.inputs();
    builder.definitions();
    builder.frames();
    builder.points();
    builder.bodies();
    builder.constraints();
    builder.loads();
    builder.ports();
    builder.outputs();
    builder.values();
    builder.view();
    builder.draft
}
