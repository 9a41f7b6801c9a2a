//! Linear forms in the unknowns: sum over k of c_k y_k.
//!
//! Forms are added, scaled, and substituted for an unknown. Coefficients are scalars (rates, constraint rows,
//! generalised forces) or vectors (partial velocities); a term whose coefficient cancels is removed.

use super::unknowns::{UnknownId, Unknowns};
use crate::expr::{Dag, ExprId};
use crate::sorted::{self, Sorted};
use crate::vector::Vector;
use std::ops::{Index, RangeBounds};

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

/// sum over k of c_k y_k; stores the coefficients by unknown.
#[derive(Clone, PartialEq, Debug)]
pub struct LinearForm<C = ExprId>(Sorted<UnknownId, C>);

impl<C> Default for LinearForm<C> {
    fn default() -> Self {
        Self(Sorted::default())
    }
}

impl<C: Coefficient> LinearForm<C> {
    /// Adds a term to the coefficient of an unknown.
    pub fn add_term(&mut self, dag: &mut Dag, unknown: UnknownId, term: &C) {
        let sum = match self.0.get(&unknown) {
            Some(mine) => mine.sum(dag, term),
            None => term.clone(),
        };
        if sum.vanishes(dag) {
            self.0.remove(&unknown);
        } else {
            self.0.insert(unknown, sum);
        }
    }

    /// Adds `factor` times another form.
    pub fn add(&mut self, dag: &mut Dag, factor: ExprId, other: &Self) {
        for (&unknown, coefficient) in &other.0 {
            let term = coefficient.times(dag, factor);
            self.add_term(dag, unknown, &term);
        }
    }

    /// The value of the form, sum c_k y_k, with the symbols of the unknowns.
    pub fn value(&self, dag: &mut Dag, unknowns: &Unknowns) -> C {
        let mut total = C::zero(dag);
        for (&unknown, coefficient) in &self.0 {
            let term = coefficient.times(dag, unknowns[unknown].value);
            total = total.sum(dag, &term);
        }
        total
    }

    /// The coefficient of an unknown; 0 if the form does not contain it.
    pub fn coefficient(&self, dag: &mut Dag, unknown: UnknownId) -> C {
        self.0.get(&unknown).cloned().unwrap_or_else(|| C::zero(dag))
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

impl<C> LinearForm<C> {
    /// The coefficient of an unknown, if the form contains it.
    #[must_use]
    pub fn get(&self, unknown: &UnknownId) -> Option<&C> {
        self.0.get(unknown)
    }

    /// Does the form contain the unknown?
    #[must_use]
    pub fn contains_key(&self, unknown: &UnknownId) -> bool {
        self.0.contains_key(unknown)
    }

    /// Sets the coefficient of an unknown.
    pub fn insert(&mut self, unknown: UnknownId, coefficient: C) {
        self.0.insert(unknown, coefficient);
    }

    /// Removes an unknown; returns its coefficient, if it had one.
    pub fn remove(&mut self, unknown: &UnknownId) -> Option<C> {
        self.0.remove(unknown)
    }

    /// Keeps the terms for which `kept` holds.
    pub fn retain(&mut self, kept: impl FnMut(&UnknownId, &mut C) -> bool) {
        self.0.retain(kept);
    }

    /// Number of terms.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// No term?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Terms in the order of the unknowns.
    pub fn iter(&self) -> sorted::Iter<'_, UnknownId, C> {
        self.0.iter()
    }

    /// Terms of some unknowns.
    pub fn range(&self, unknowns: impl RangeBounds<UnknownId>) -> sorted::Iter<'_, UnknownId, C> {
        self.0.range(unknowns)
    }

    /// The unknowns that the form contains.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &UnknownId> + ExactSizeIterator + Clone {
        self.0.keys()
    }

    /// Coefficients in the order of the unknowns.
    pub fn values(&self) -> impl DoubleEndedIterator<Item = &C> + ExactSizeIterator + Clone {
        self.0.values()
    }

    /// Mutable coefficients in the order of the unknowns.
    pub fn values_mut(&mut self) -> impl DoubleEndedIterator<Item = &mut C> + ExactSizeIterator {
        self.0.values_mut()
    }
}

impl<C> Index<&UnknownId> for LinearForm<C> {
    type Output = C;
    fn index(&self, unknown: &UnknownId) -> &C {
        &self.0[unknown]
    }
}

impl<C> FromIterator<(UnknownId, C)> for LinearForm<C> {
    fn from_iter<I: IntoIterator<Item = (UnknownId, C)>>(terms: I) -> Self {
        Self(terms.into_iter().collect())
    }
}

impl<C> Extend<(UnknownId, C)> for LinearForm<C> {
    fn extend<I: IntoIterator<Item = (UnknownId, C)>>(&mut self, terms: I) {
        self.0.extend(terms);
    }
}

impl<'f, C> IntoIterator for &'f LinearForm<C> {
    type Item = (&'f UnknownId, &'f C);
    type IntoIter = sorted::Iter<'f, UnknownId, C>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl<C> IntoIterator for LinearForm<C> {
    type Item = (UnknownId, C);
    type IntoIter = std::vec::IntoIter<(UnknownId, C)>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
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
