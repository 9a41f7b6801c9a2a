//! Estimates how the size of an expression changes with the parameters that are set.
//!
//! In: expressions. Out: for each an estimate of its size that depends on parameters alone, so that `prepare()`
//! computes it. Terms of a sum are added by absolute value, except those that an elimination subtracts; sines and
//! cosines count as 1; a coordinate counts as its nominal value, which for a length is scaled with the model's lengths.
//! A quantity measured at the nominal parameters is carried over to other parameters by the quotient of the two sizes.

use super::quantities::Kinematics;
use super::unknowns::UnknownKind;
use crate::expr::{Binary, Dag, ExprId, Node, SymbolId, Unary};
use crate::id::Id;
use crate::model::Model;
use crate::model::unit::{self, Unit};
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;

/// Least relative size, so that a parameter of 0, such as a mass, leads to no division by zero.
const LEAST: f64 = 1e-24;

/// Sizes of the symbols of a model.
pub struct Sizes {
    /// Parameters by their nominal values.
    parameters: HashMap<SymbolId, f64>,
    /// Coordinates by their nominal values, and whether they are lengths.
    coordinates: HashMap<SymbolId, (f64, bool)>,
    /// The parameters that are lengths.
    lengths: Vec<ExprId>,
}

impl Sizes {
    /// The sizes at the nominal configuration and parameters of a model.
    #[must_use]
    pub fn new(alg: &Algebra, model: &Model, k: &Kinematics) -> Self {
        let symbols: Vec<_> = (model.parameters.ids())
            .filter_map(|id| Some((id, alg.dag.as_symbol(k.parameters[id])?)))
            .collect();
        let state =
            model.coordinates.enumerate().filter_map(|(id, c)| Some((c, k.coordinate_symbol(&alg.dag, id)?)));
        let nominal = k.samples.first().map_or(&[][..], Vec::as_slice);
        Self {
            parameters: symbols.iter().map(|&(id, symbol)| (symbol, k.parameter_values[id])).collect(),
            coordinates: state
                .zip(nominal)
                .map(|((c, symbol), &q)| (symbol, (q, is_length(&c.unit))))
                .collect(),
            lengths: symbols
                .into_iter()
                .filter(|&(id, _)| is_length(&model.parameters[id].unit))
                .map(|(id, _)| k.parameters[id])
                .collect(),
        }
    }

    /// The size of each expression relative to that at the nominal parameters.
    pub fn growth(&self, dag: &mut Dag, exprs: &[ExprId]) -> Vec<ExprId> {
        let lengths = self.growth_of_lengths(dag);
        let order = dag.reachable(exprs);
        let mut sizes: Vec<ExprId> = vec![lengths; order.last().map_or(0, |id| id.index() + 1)];
        for id in order {
            sizes[id.index()] = self.size(dag, id, lengths, &|operand| sizes[operand.index()]);
        }
        exprs.iter().map(|expr| self.relative(dag, sizes[expr.index()])).collect()
    }

    /// The size of the independent speeds relative to nominal: that of the lengths for a velocity, 1 for all others.
    pub fn growth_of_speeds(&self, alg: &mut Algebra, model: &Model, k: &Kinematics) -> Vec<ExprId> {
        let (one, lengths) = (alg.dag.one(), self.growth_of_lengths(&mut alg.dag));
        let kinds = k.unknowns.independent().into_iter().map(|unknown| k.unknowns[unknown].kind);
        let moves_along =
            |kind| matches!(kind, UnknownKind::Independent(id) if is_velocity(&model.speeds[id].unit));
        kinds.map(|kind| if moves_along(kind) { lengths } else { one }).collect()
    }

    /// The size of an expression, from the sizes of its operands.
    fn size(&self, dag: &mut Dag, id: ExprId, lengths: ExprId, of: &dyn Fn(ExprId) -> ExprId) -> ExprId {
        match dag.node(id) {
            Node::Number(number) => dag.constant(number.to_f64().abs()),
            Node::Pi => id,
            Node::Symbol(symbol) if self.parameters.contains_key(&symbol) => dag.unary(Unary::Abs, id),
            Node::Symbol(symbol) => match self.coordinates.get(&symbol) {
                Some(&(nominal, true)) if nominal != 0.0 => {
                    let nominal = dag.constant(nominal.abs());
                    dag.mul(nominal, lengths)
                }
                Some((_, true)) => lengths,
                _ => dag.one(),
            },
            Node::Negate(a) => of(a),
            Node::Binary(Binary::Sub, a, b) if divides(dag, b) => of(a),
            Node::Unary(function @ (Unary::Sqrt | Unary::Abs), a) => dag.unary(function, of(a)),
            Node::Unary(..) | Node::Binary(Binary::Atan2, ..) => dag.one(),
            Node::Binary(Binary::Add | Binary::Sub, a, b) => dag.add(of(a), of(b)),
            Node::Binary(Binary::Min | Binary::Max, a, b) => dag.binary(Binary::Max, of(a), of(b)),
            Node::Binary(operator, a, b) => dag.binary(operator, of(a), of(b)),
        }
    }

    /// A size divided by its value at the nominal parameters.
    fn relative(&self, dag: &mut Dag, size: ExprId) -> ExprId {
        let nominal = self.at_nominal(dag, size);
        if dag.is_constant(size) || !(nominal.is_finite() && nominal > 0.0) {
            return dag.one();
        }
        let (nominal, least) = (dag.constant(nominal), dag.constant(LEAST));
        let relative = dag.div(size, nominal);
        dag.binary(Binary::Max, relative, least)
    }

    /// The sum of the model's lengths divided by its nominal value; 1 if it has none.
    fn growth_of_lengths(&self, dag: &mut Dag) -> ExprId {
        let lengths: Vec<ExprId> = self.lengths.iter().map(|&length| dag.unary(Unary::Abs, length)).collect();
        let sum = dag.sum(&lengths);
        self.relative(dag, sum)
    }

    fn at_nominal(&self, dag: &Dag, size: ExprId) -> f64 {
        dag.evaluate(&[size], &|symbol| self.parameters[&symbol])[0]
    }
}

/// Is it a quotient by a pivot? In a mass matrix, what an elimination subtracts is never larger than what it is
/// subtracted from.
fn divides(dag: &Dag, id: ExprId) -> bool {
    match dag.node(id) {
        Node::Negate(a) => divides(dag, a),
        Node::Binary(Binary::Mul, a, b) => divides(dag, a) || divides(dag, b),
        Node::Binary(Binary::Add, a, b) => divides(dag, a) && divides(dag, b),
        Node::Binary(Binary::Div, _, d) => !dag.is_constant(d),
        _ => false,
    }
}

fn is_velocity(text: &str) -> bool {
    unit::parse(text.trim()).is_ok_and(|scale| Some(scale.unit) == Unit::LENGTH.per(Unit::TIME))
}

fn is_length(text: &str) -> bool {
    unit::parse(text.trim()).is_ok_and(|scale| scale.unit == Unit::LENGTH)
}
