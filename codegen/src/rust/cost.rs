//! What a function costs before any compiler has seen it.
//!
//! In: a program and a function of it. Out: operations of an evaluation, and how many values wait at once: what finds no
//! register goes through the stack.

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
    /// Most values that wait for a reader at once, arguments from their first reader on and results to the end.
    pub values_alive: usize,
}

/// Cost of a function, its statements in the order that `options` ask for.
#[must_use]
pub fn cost(program: &Program, function: &Function, options: &EmitOptions) -> FunctionCost {
    let roots = program.function_roots(function);
    let prepared = Prepared::new(program, &roots);
    let takes_u_dot = program.answers_of(function).iter().any(|answer| answer.takes_u_dot);
    let parameters = Parameters::Prepared { prepared: &prepared, takes_u_dot };
    FunctionCost {
        operations: program.dag.state_cost(&roots),
        values_alive: Body::most_waiting(program, &roots, options, parameters),
    }
}
