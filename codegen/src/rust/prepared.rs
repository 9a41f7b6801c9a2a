//! `Prepared`: what the answers need of the parameters, and `prepare`, which computes it.

use super::ScalarType;
use super::name::Scope;
use super::statement::Body;
use crate::expr::{Dependence, ExprId};
use crate::program::Program;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The fields of `Prepared`: their nodes and names, in order.
pub(super) struct Prepared {
    pub fields: Vec<(ExprId, String)>,
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
        Self { fields }
    }

    fn roots(&self) -> Vec<ExprId> {
        self.fields.iter().map(|(id, _)| *id).collect()
    }

    /// Operations of `prepare`, by kind.
    pub fn operations(&self, program: &Program) -> std::collections::BTreeMap<&'static str, usize> {
        program.dag.operations_by_kind(&self.roots(), Dependence::Parameters)
    }

    /// The struct and the function, its body a placeholder; and the body's text.
    pub fn items(&self, program: &Program, scalar: &ScalarType) -> (TokenStream, String) {
        let idents: Vec<_> = self.fields.iter().map(|(_, field)| format_ident!("{field}")).collect();
        let docs = self.fields.iter().map(|(id, field)| match program.dag.as_symbol(*id) {
            Some(_) => format!("The parameter `{field}`."),
            None => "Of parameters alone.".to_owned(),
        });
        let body = Body::of_parameters(program, &self.roots(), scalar);
        let arguments = body.arguments();
        let total: usize = self.operations(program).values().sum();
        let operations = format!("{total} operations.");
        let items = quote! {
            /// What the functions below need of the parameters, from [`prepare`].
            #[derive(Clone, Copy, Debug)]
            #[repr(C)]
            #[allow(non_snake_case, reason = "names are the model's")]
            pub struct Prepared { #(#[doc = #docs] pub #idents: S),* }
            /// Computes what depends on parameters alone: once, and again when one of them changes.
            ///
            #[doc = #operations]
            #[allow(non_snake_case, clippy::all, clippy::pedantic, reason = "generated straight-line arithmetic")]
            #[must_use]
            pub fn prepare(#arguments) -> Prepared {
                body_of_prepare!();
            }
        };
        let values: Vec<String> = (self.fields.iter().zip(&body.results))
            .map(|((_, field), value)| match field == value {
                true => field.clone(),
                false => format!("{field}: {value}"),
            })
            .collect();
        let mut text: String = body.statements.iter().map(|line| format!("    {line}\n")).collect();
        text.push_str(&format!("    Prepared {{ {} }}\n", values.join(", ")));
        (items, text)
    }

    /// Name of the field that holds a node.
    pub fn field(&self, id: ExprId) -> Option<&str> {
        let place = self.fields.binary_search_by_key(&id, |(id, _)| *id).ok()?;
        Some(&self.fields[place].1)
    }
}
