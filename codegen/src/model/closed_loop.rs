//! Closes the loop: replaces every input that has a law by that law.
//!
//! In: a model with `[law]`. Out: the model whose loads and outputs read the laws instead of these inputs. The inputs
//! keep their places and have no effect any more. Its linearisation is that of the closed loop.

use super::data::*;
use super::expression::{Expr, ExprKind};

impl Model {
    /// The model with its laws in place of the inputs that they command.
    #[must_use]
    pub fn closed_loop(&self) -> Self {
        let commanded = |e: &Expr| self.commanded(e);
        let mut model = self.clone();
        for load in &mut model.loads {
            match &mut load.kind {
                LoadKind::Force { force: value, point: _, reaction: _ }
                | LoadKind::Torque { torque: value, frame: _, reaction: _ } => *value = commanded(value),
                LoadKind::Spring { stiffness, rest_length: rest, damping, ends: _ }
                | LoadKind::CoordinateSpring { stiffness, rest, damping, coordinate: _ } => {
                    (*stiffness, *rest) = (commanded(stiffness), commanded(rest));
                    *damping = damping.as_ref().map(commanded);
                }
            }
        }
        model.outputs.iter_mut().for_each(|output| output.value = commanded(&output.value));
        model
    }

    /// The expression with laws for inputs; definitions that depend on such inputs are written out in full.
    fn commanded(&self, expr: &Expr) -> Expr {
        expr.replaced(&|e| match &e.kind {
            ExprKind::Input(id) => {
                let law = self.laws.iter().find(|(input, _)| input == id);
                law.map(|(_, law)| law.clone())
            }
            ExprKind::Definition(id) if self.is_commanded(&self.definitions[*id].value) => {
                Some(self.commanded(&self.definitions[*id].value))
            }
            _ => None,
        })
    }

    /// Does the expression, or a definition in it, depend on an input that has a law?
    fn is_commanded(&self, expr: &Expr) -> bool {
        let mut found = false;
        expr.visit(&mut |e| match e.kind {
            ExprKind::Input(id) => found |= self.laws.iter().any(|(input, _)| *input == id),
            ExprKind::Definition(id) => found |= self.is_commanded(&self.definitions[id].value),
            _ => {}
        });
        found
    }
}
