//! The fields of the emitted struct `Prepared`: the values of parameters alone that the answers use.

use super::answer::Cost;
use super::name::Scope;
use crate::expr::{Dependence, ExprId, NodeSet};
use crate::program::Program;

/// Nodes and names of the fields, in order.
pub(super) struct Prepared {
    pub fields: Vec<(ExprId, String)>,
    /// The nodes of the fields, as a set: most queries are about nodes that have no field.
    nodes: NodeSet,
}

impl Prepared {
    /// The fields for `roots`: parameters under their own names, other values under names of the model or numbered.
    pub fn new(program: &Program, roots: &[ExprId]) -> Self {
        let mut scope = Scope::default();
        let mut fields: Vec<(ExprId, String)> = Vec::new();
        for id in program.prepared(roots) {
            let parameter = program.parameters.iter().find(|p| Some(p.symbol) == program.dag.as_symbol(id));
            let name = match (parameter, program.dag.name_of(id)) {
                (Some(parameter), _) => scope.unique(&parameter.name),
                (None, Some(name)) => scope.unique(&format!("prepared_{name}")),
                (None, None) => scope.unique(&format!("k{}", fields.len())),
            };
            fields.push((id, name));
        }
        let mut nodes = NodeSet::below(program.dag.len());
        fields.iter().for_each(|(id, _)| nodes.insert(*id));
        Self { fields, nodes }
    }

    /// The nodes of the fields, in order.
    pub fn roots(&self) -> Vec<ExprId> {
        self.fields.iter().map(|(id, _)| *id).collect()
    }

    /// Operations of `prepare`, by kind.
    pub fn operations(&self, program: &Program) -> Cost {
        program.dag.operations_by_kind(&self.roots(), Dependence::Parameters)
    }

    /// Name of the field that holds a node.
    pub fn field(&self, id: ExprId) -> Option<&str> {
        if !self.nodes.contains(id) {
            return None;
        }
        let place = self.fields.binary_search_by_key(&id, |(id, _)| *id).ok()?;
        Some(&self.fields[place].1)
    }
}
