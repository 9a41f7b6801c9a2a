//! Linear forms in the unknowns: sum over k of c_k y_k.
//!
//! Forms are added, scaled, and substituted for an unknown. Coefficients are scalars (rates, constraint rows,
//! generalised forces) or vectors (partial velocities); a term whose coefficient cancels is removed.

use super::unknowns::{UnknownId, Unknowns};
use crate::expr::{Dag, ExprId};
use crate::sorted::Sorted;
use crate::vector::Vector;

/// The type of a coefficient: scalar or vector.
pub trait Coefficient: Clone {
    /// 0.
    fn zero(dag: &mut Dag) -> Self;
    /// a + b.
    fn sum(&self, dag: &mut Dag, other: &Self) -> Self;
    /// factor a.
    fn times(&self, dag: &mut Dag, factor: ExprId) -> Self;
    /// Is it identically 0?
    fn vanishes(&self, dag: &Dag) -> bool;
}

impl Coefficient for ExprId {
    fn zero(dag: &mut Dag) -> Self {
        dag.zero()
    }

    fn sum(&self, dag: &mut Dag, other: &Self) -> Self {
        dag.add(*self, *other)
    }

    fn times(&self, dag: &mut Dag, factor: ExprId) -> Self {
        dag.mul(factor, *self)
    }

    fn vanishes(&self, dag: &Dag) -> bool {
        dag.is_zero(*self)
    }
}

impl Coefficient for Vector {
    fn zero(_: &mut Dag) -> Self {
        Self::zero()
    }

    fn sum(&self, dag: &mut Dag, other: &Self) -> Self {
        self.plus(dag, other)
    }

    fn times(&self, dag: &mut Dag, factor: ExprId) -> Self {
        self.scaled(dag, factor)
    }

    fn vanishes(&self, _: &Dag) -> bool {
        self.is_zero()
    }
}

/// sum over k of c_k y_k; the coefficients by unknown.
pub type LinearForm<C = ExprId> = Sorted<UnknownId, C>;

impl<C: Coefficient> LinearForm<C> {
    /// Adds a term to the coefficient of an unknown.
    pub fn add_term(&mut self, dag: &mut Dag, unknown: UnknownId, term: &C) {
        let sum = match self.get(&unknown) {
            Some(mine) => mine.sum(dag, term),
            None => term.clone(),
        };
        if sum.vanishes(dag) {
            self.remove(&unknown);
        } else {
            self.insert(unknown, sum);
        }
    }

    /// Adds `factor` times another form.
    pub fn add(&mut self, dag: &mut Dag, factor: ExprId, other: &Self) {
        for (&unknown, coefficient) in other {
            let term = coefficient.times(dag, factor);
            self.add_term(dag, unknown, &term);
        }
    }

    /// The value of the form, sum c_k y_k, with the symbols of the unknowns.
    pub fn value(&self, dag: &mut Dag, unknowns: &Unknowns) -> C {
        let mut total = C::zero(dag);
        for (&unknown, coefficient) in self {
            let term = coefficient.times(dag, unknowns[unknown].value);
            total = total.sum(dag, &term);
        }
        total
    }

    /// The coefficient of an unknown; 0 if the form does not contain it.
    pub fn coefficient(&self, dag: &mut Dag, unknown: UnknownId) -> C {
        self.get(&unknown).cloned().unwrap_or_else(|| C::zero(dag))
    }
}

impl LinearForm {
    /// Substitutes `form` for an unknown; returns the coefficient that the unknown had, if it had one.
    pub fn substitute(&mut self, dag: &mut Dag, unknown: UnknownId, form: &Self) -> Option<ExprId> {
        let coefficient = self.remove(&unknown)?;
        self.add(dag, coefficient, form);
        Some(coefficient)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::id::Id;

    #[test]
    fn what_cancels_is_no_term_and_a_form_takes_the_place_of_its_unknown() {
        let mut dag = Dag::default();
        let [x, y, z] = [0, 1, 2].map(UnknownId::from_index);
        let (a, b) = (dag.symbol("a"), dag.symbol("b"));
        let minus = dag.negate(a);
        let mut form = LinearForm::default();
        form.add_term(&mut dag, x, &a);
        form.add_term(&mut dag, y, &b);
        form.add_term(&mut dag, x, &minus);
        assert_eq!(form, LinearForm::from_iter([(y, b)]));
        // y = a x + b z: b y = a b x + b b z
        let of_y = LinearForm::from_iter([(x, a), (z, b)]);
        assert_eq!(form.substitute(&mut dag, y, &of_y), Some(b));
        let (ab, bb) = (dag.mul(a, b), dag.mul(b, b));
        assert_eq!(form, LinearForm::from_iter([(x, ab), (z, bb)]));
        assert_eq!(form.substitute(&mut dag, y, &of_y), None);
    }
}
