//! Assigns each value of a function to a section of the equations.
//!
//! In: the nodes of a function, some of which the derivation has labelled. Out: one section per node: a value belongs
//! to the first section that uses it. Statements stand in the order that suits the processor, so that sections
//! interleave; a comment marks the first statement of each.

use crate::expr::{Dag, ExprId, Node, Unary};
use crate::id::Id;
use crate::section::Section;

/// Sections of the nodes, and which sections have begun.
pub(super) struct Sections {
    /// By node.
    of: Vec<Section>,
    begun: Vec<Section>,
}

impl Sections {
    /// The sections of everything that `roots` depend on. Operands have smaller ids than their users.
    pub fn new(dag: &Dag, roots: &[ExprId]) -> Self {
        let nodes = dag.reachable(roots);
        let size = nodes.last().map_or(0, |id| id.index() + 1);
        let mut of = vec![Section::Results; size];
        for &id in nodes.iter().rev() {
            let mut section = of[id.index()];
            if let Some(label) = dag.label_of(id) {
                section = section.min(label.section);
            }
            if matches!(dag.node(id), Node::Unary(Unary::Sin | Unary::Cos, _)) {
                section = Section::Orientations;
            }
            of[id.index()] = section;
            for operand in dag.operands(id).into_iter().flatten() {
                of[operand.index()] = of[operand.index()].min(section);
            }
        }
        Self { of, begun: Vec::new() }
    }

    /// The heading of a node's section, if it is the section's first.
    pub fn begin(&mut self, id: ExprId) -> Option<&'static str> {
        let section = *self.of.get(id.index())?;
        if self.begun.contains(&section) {
            return None;
        }
        self.begun.push(section);
        Some(section.heading())
    }
}
