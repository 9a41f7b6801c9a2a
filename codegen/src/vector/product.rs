//! Scalar and vector products of vectors whose terms stand in different triads.

use super::{Components, TriadId, Triads, Vector, along_axis, cross_components, dot_components};
use crate::expr::{Dag, ExprId};

impl Triads {
    /// a . b: each pair of terms is multiplied in whichever of its two triads takes fewer operations.
    pub fn dot(&mut self, dag: &mut Dag, a: &Vector, b: &Vector) -> ExprId {
        let mut total = dag.zero();
        for (&s, x) in &a.terms {
            for (&t, y) in &b.terms {
                let product = match self.products.get(&[(s, *x), (t, *y)]) {
                    Some(&known) => known,
                    None => {
                        let product = self.dot_terms(dag, (s, x), (t, y));
                        self.products.insert([(s, *x), (t, *y)], product);
                        product
                    }
                };
                total = dag.add(total, product);
            }
        }
        total
    }

    fn dot_terms(
        &mut self,
        dag: &mut Dag,
        (s, x): (TriadId, &Components),
        (t, y): (TriadId, &Components),
    ) -> ExprId {
        let x_in_t = self.express_term(dag, s, *x, t);
        let mut product = dot_components(dag, &x_in_t, y);
        if s == t {
            return product;
        }
        let mut cost = dag.cone_cost(&[product]);
        let y_in_s = self.express_term(dag, t, *y, s);
        let other = dot_components(dag, x, &y_in_s);
        let others = dag.cone_cost(&[other]);
        if others < cost {
            (product, cost) = (other, others);
        }
        match self.dot_along_axes(dag, (s, x), (t, y)) {
            Some(other) if dag.cone_cost(&[other]) <= cost => other,
            _ => product,
        }
    }

    /// (x e) . (y f) = x y (e . f), for two vectors along one axis each: all such products share the cosine e . f.
    fn dot_along_axes(
        &mut self,
        dag: &mut Dag,
        a: (TriadId, &Components),
        b: (TriadId, &Components),
    ) -> Option<ExprId> {
        let [(e, x), (f, y)] = [along_axis(dag, a.1)?, along_axis(dag, b.1)?];
        let mut unit = [dag.zero(); 3];
        unit[e] = dag.one();
        let cosine = self.express_term(dag, a.0, unit, b.0)[f];
        let size = dag.mul(x, y);
        Some(dag.mul(size, cosine))
    }

    /// a x b: each pair of terms is multiplied in whichever of its two triads takes fewer operations.
    pub fn cross(&mut self, dag: &mut Dag, a: &Vector, b: &Vector) -> Vector {
        let mut total = Vector::zero();
        for (&s, x) in &a.terms {
            for (&t, y) in &b.terms {
                let x_in_t = self.shorter_term(dag, s, *x, t);
                let mut product = (t, cross_components(dag, &x_in_t, y));
                if s != t {
                    let y_in_s = self.shorter_term(dag, t, *y, s);
                    let other = cross_components(dag, x, &y_in_s);
                    if other != product.1 && dag.cone_cost(&other) < dag.cone_cost(&product.1) {
                        product = (s, other);
                    }
                }
                let product = Vector::new(dag, product.0, product.1);
                total = total.plus(dag, &product);
            }
        }
        total
    }
}
