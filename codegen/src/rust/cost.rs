//! Cost of a function, independent of any compiler.
//!
//! In: a program and a function of it. Out: operations per evaluation, and the largest number of values alive at once
//! (register pressure): values that find no register go through the stack.

use super::answer::RATES;
use super::options::EmitOptions;
use super::prepared::Prepared;
use super::statement::{Body, Parameters};
use crate::program::Program;
use crate::program::answer::Function;

/// Cost of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FunctionCost {
    /// Operations of an evaluation.
    pub operations: usize,
    /// Largest number of values alive at once; arguments count from their first use, results to the end
    /// unless they are written to memory at once, as rates are.
    pub values_alive: usize,
}

/// Cost of a function whose statements are in the order for `options`.
#[must_use]
pub fn cost(program: &Program, function: &Function, options: &EmitOptions) -> FunctionCost {
    let roots = program.function_roots(function);
    let prepared = Prepared::new(program, &roots);
    let takes_u_dot = program.answers_of(function).iter().any(|answer| answer.takes_u_dot);
    let parameters = Parameters::Prepared { prepared: &prepared, takes_u_dot };
    let is_rates = matches!(function.requests.as_slice(), [only] if only.answer == RATES);
    let written = if is_rates { program.q.len() + program.u.len() } else { 0 };
    FunctionCost {
        operations: program.dag.state_cost(&roots),
        values_alive: Body::most_waiting(program, (&roots, written), options, parameters),
    }
}
