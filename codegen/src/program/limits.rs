//! Limits on the numbers of a program: the range of single precision, and the angles of its sines and cosines.

use super::derived::Program;
use crate::expr::{ExprId, Node, Unary};
use std::collections::BTreeSet;

/// Can the number be rounded to single precision without becoming infinite, or 0 if it is not 0?
#[must_use]
pub fn fits_single(x: f64) -> bool {
    let rounded = x as f32;
    rounded.is_finite() && (rounded != 0.0 || x == 0.0)
}

impl Program {
    /// The first parameter, start value or constant that single precision cannot hold, in words.
    #[must_use]
    pub fn beyond_single(&self) -> Option<String> {
        let range = format!("{:.1e} to {:.1e}", f32::MIN_POSITIVE, f32::MAX);
        let parameter = self.parameters.iter().find(|p| !fits_single(p.value));
        if let Some(found) = parameter {
            return Some(format!(
                "the parameter `{}` = {:e} is beyond single precision ({range})",
                found.name, found.value
            ));
        }
        let start = self.stated_start.iter().find(|(_, value)| !(*value as f32).is_finite());
        if let Some((name, value)) = start {
            return Some(format!(
                "the start value `{name}` = {value:e} is beyond single precision ({range})"
            ));
        }
        // A constant that is too small only drops out of a sum; one that is too large makes results infinite.
        let constants =
            self.dag.reachable(&self.all_roots()).into_iter().filter_map(|id| match self.dag.node(id) {
                Node::Number(number) => Some(number.to_f64()),
                _ => None,
            });
        let found = constants.into_iter().find(|x| !(*x as f32).is_finite())?;
        Some(format!("a constant of the equations, {found:e}, is beyond single precision ({range})"))
    }

    /// The same program whose outputs are the arguments of all its sines, cosines and tangents, each named after the
    /// coordinates that it contains.
    #[must_use]
    pub fn angles(&self) -> Program {
        let reached = self.dag.reachable(&self.all_roots());
        let arguments: BTreeSet<ExprId> = (reached.into_iter())
            .filter_map(|id| match self.dag.node(id) {
                Node::Unary(Unary::Sin | Unary::Cos | Unary::Tan, angle) => Some(angle),
                _ => None,
            })
            .collect();
        let name = |angle: ExprId| {
            let read = self.dag.reachable(&[angle]);
            let is_read = |symbol| self.dag.find(Node::Symbol(symbol)).is_some_and(|id| read.contains(&id));
            let quantities = self.q.iter().chain(&self.u).chain(&self.inputs);
            let mut names: Vec<String> =
                quantities.filter(|q| is_read(q.symbol)).map(|q| format!("`{}`", q.name)).collect();
            if is_read(self.time) {
                names.push("`t`".to_owned());
            }
            names.join(", ")
        };
        let outputs = arguments.into_iter().map(|angle| (name(angle), angle)).collect();
        Program { outputs, ..self.clone() }
    }
}
