//! `Prepared`: what the answers need of the parameters, and `prepare`, which computes it.

use super::name::Scope;
use super::statement::{Body, Parameters};
use super::{Cost, PLAIN_STRUCT, STRAIGHT_LINE, ScalarType, layout};
use crate::expr::{Dependence, ExprId, NodeSet};
use crate::program::Program;

/// The fields of `Prepared`: their nodes and names, in order.
pub(super) struct Prepared {
    pub fields: Vec<(ExprId, String)>,
    /// The nodes of the fields: most nodes that are asked for have none.
    nodes: NodeSet,
}

impl Prepared {
    /// What `roots` need: parameters under their own names, other values under those of the model or numbered.
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

    fn roots(&self) -> Vec<ExprId> {
        self.fields.iter().map(|(id, _)| *id).collect()
    }

    /// Operations of `prepare`, by kind.
    pub fn operations(&self, program: &Program) -> Cost {
        program.dag.operations_by_kind(&self.roots(), Dependence::Parameters)
    }

    /// The struct and the function; `names` are those of the fields of `Parameters`.
    pub fn items(&self, program: &Program, names: &[String], scalar: &ScalarType, cost: &Cost) -> String {
        let fields = self.fields.iter().map(|(id, field)| match program.dag.as_symbol(*id) {
            Some(_) => format!("///The parameter `{field}`.\n    pub {field}: S"),
            None => format!("///Of parameters alone.\n    pub {field}: S"),
        });
        let body = Body::new(program, &self.roots(), scalar, Parameters::Given(names));
        let values: Vec<String> = (self.fields.iter().zip(&body.results))
            .map(|((_, field), value)| match field == value {
                true => field.clone(),
                false => format!("{field}: {value}"),
            })
            .collect();
        let operations: usize = cost.values().sum();
        format!(
            "/// What the functions below need of the parameters, from [`prepare`].\n{PLAIN_STRUCT}{}\
             /// Computes what depends on parameters alone: once, and again when one of them changes.\n\
             ///\n///{operations} operations.\n{STRAIGHT_LINE}{}{}    Prepared {{ {} }}\n}}\n",
            layout::block("pub struct Prepared", fields, ""),
            layout::signature("pub fn prepare", &body.arguments(), "Prepared", ""),
            body.statements,
            values.join(", ")
        )
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
