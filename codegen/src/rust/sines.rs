//! Sines and cosines that the functions of one step share.
//!
//! In: a program. Out: the angles whose sines and cosines `begin_step` returns and from which `rates_near` computes
//! those of angles close by ([`Real::sin_cos_near`](https://docs.rs/smartbed-runtime)): sin(x + d) = s cos d + c sin d
//! with d small.

use super::prepared::Prepared;
use crate::expr::{ExprId, Node, Unary};
use crate::program::Program;

/// The source of these sines and cosines in a function.
#[derive(Clone, Copy)]
pub(super) enum Sines<'p> {
    /// It computes them.
    Own,
    /// It computes them and returns them too.
    HandedOn(&'p [ExprId]),
    /// It computes them from those of angles close by, which are an argument.
    Near(&'p [ExprId]),
}

impl<'p> Sines<'p> {
    /// The angles whose sines and cosines it returns.
    pub fn handed_on(self) -> &'p [ExprId] {
        if let Self::HandedOn(angles) = self { angles } else { &[] }
    }

    /// The angles whose sines and cosines it is given.
    pub fn given(self) -> &'p [ExprId] {
        if let Self::Near(angles) = self { angles } else { &[] }
    }
}

/// The angles whose sines and cosines an evaluation of the rates uses, except unrounded differences of two angles.
pub(super) fn angles(program: &Program, prepared: &Prepared) -> Vec<ExprId> {
    let dag = &program.dag;
    let reached = dag.reachable_above(&program.roots_of("rates"), |id| prepared.field(id).is_some());
    let mut angles: Vec<ExprId> = Vec::new();
    for id in reached {
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = dag.node(id)
            && prepared.field(id).is_none()
            && !dag.is_constant(id)
            && dag.as_difference(angle).is_none()
            && !angles.contains(&angle)
        {
            angles.push(angle);
        }
    }
    angles
}
