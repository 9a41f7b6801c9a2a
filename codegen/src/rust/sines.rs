//! Sines and cosines that the functions of one step share.
//!
//! In: a program. Out: the angles whose sines and cosines `begin_step` hands on and `rates_near` turns on from
//! ([`Real::sin_cos_near`](https://docs.rs/smartbed-runtime)): sin(x + d) = s cos d + c sin d with d small.

use super::prepared::Prepared;
use crate::expr::{ExprId, Node, Unary};
use crate::program::Program;

/// Where a function has the sines and cosines of such angles from.
#[derive(Clone, Copy)]
pub(super) enum Sines<'p> {
    /// It computes them.
    Own,
    /// It computes them and hands them on.
    HandedOn(&'p [ExprId]),
    /// It is given those of angles close by.
    Near(&'p [ExprId]),
}

impl<'p> Sines<'p> {
    /// The angles that it hands on.
    pub fn handed_on(self) -> &'p [ExprId] {
        if let Self::HandedOn(angles) = self { angles } else { &[] }
    }

    /// The angles that it is given.
    pub fn given(self) -> &'p [ExprId] {
        if let Self::Near(angles) = self { angles } else { &[] }
    }
}

/// The angles of whose sines and cosines an evaluation of the rates makes use; not the unrounded differences of two.
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
