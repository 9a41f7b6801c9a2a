//! Results that a function writes to memory, each as soon as it is computed.
//!
//! A result that waits for the end of the function takes a register from other values, or is stored on the stack,
//! loaded at the end and stored again.

use super::super::name::RATES;
use super::super::options::Core;
use super::Body;
use crate::expr::ExprId;

/// Without it the compiler for the chip moves these stores to the end of the function. It is no instruction.
const FENCE: &str = "    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::Release);\n";

impl Body<'_> {
    /// Notes by value which results are to be written.
    pub(super) fn await_results(&mut self, values: &[ExprId]) {
        for (index, &value) in values.iter().take(self.places().len()).enumerate() {
            self.unwritten.entry(value).or_default().push(index);
        }
    }

    /// Writes the results whose values have got a name since the last call: `q_dot[3] = u_sA;`.
    pub(super) fn write_results(&mut self, roots: &[ExprId]) {
        let ready = std::mem::take(&mut self.ready);
        for &index in &ready {
            self.write_result(index, roots[index]);
        }
        if self.options.core() == Core::CortexM4 && !ready.is_empty() {
            self.statements.push_str(FENCE);
        }
    }

    /// Writes the results that no statement computes: arguments that nothing else reads, and constants.
    pub(super) fn write_other_results(&mut self, roots: &[ExprId]) {
        self.write_results(roots);
        let mut others: Vec<usize> = std::mem::take(&mut self.unwritten).into_values().flatten().collect();
        others.sort_unstable();
        others.into_iter().for_each(|index| self.write_result(index, roots[index]));
    }

    fn write_result(&mut self, index: usize, root: ExprId) {
        let mut text = std::mem::take(&mut self.statements);
        for part in ["    ", &self.places()[index], " = "] {
            text.push_str(part);
        }
        self.write_argument(&mut text, root);
        text.push_str(";\n");
        self.statements = text;
    }

    /// The arguments that hold the places of the results.
    pub(super) fn written(&self) -> impl Iterator<Item = String> {
        let lengths = [self.program.q.len(), self.program.u.len()];
        let underscore = |n: usize| if n == 0 { "_" } else { "" };
        RATES.iter().zip(lengths).map(move |(name, n)| format!("{}{name}: &mut [S; {n}usize]", underscore(n)))
    }
}
