//! M u' = forcing in absolute rates: w = u_a + u_b replaces u_b wherever M_bb is a term of M_ab.
//!
//! In relative rates the rate u_a turns everything that hangs on b too, so that M_aa, M_ab and M_bb are large and
//! nearly equal, and the elimination takes their differences. With D the differences of a row and a later one, solve (D
//! M D') y' = D forcing, then u_b' = y_b' - y_a'. Terms that two entries share are omitted from their difference
//! instead of being subtracted, so that nothing cancels.

use crate::expr::{Binary, Dag, Dependence, ExprId, Node};

/// The equations in absolute rates.
pub(super) struct Absolute {
    pub mass: Vec<Vec<ExprId>>,
    pub forcing: Vec<ExprId>,
    /// By step of the elimination: the index of the speed.
    pub order: Vec<usize>,
    /// Pairs (a, b) with y_b = u_b + y_a.
    pairs: Vec<(usize, usize)>,
}

impl Absolute {
    pub fn new(dag: &mut Dag, mass: &[Vec<ExprId>], forcing: &[ExprId]) -> Self {
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        for (b, row) in mass.iter().enumerate() {
            let own = row[b];
            let shared = |&a: &usize| !dag.is_constant(own) && without(dag, row[a], false, own).is_some();
            pairs.extend((0..b).rev().find(shared).map(|a| (a, b)));
        }
        let mut this = Self {
            mass: mass.to_vec(),
            forcing: forcing.to_vec(),
            order: (0..forcing.len()).collect(),
            pairs,
        };
        for &(a, b) in &this.pairs {
            for (entry, &other) in this.mass[a].iter_mut().zip(&mass[b]) {
                *entry = difference(dag, *entry, other);
            }
            this.forcing[a] = difference(dag, this.forcing[a], forcing[b]);
        }
        for row in &mut this.mass {
            let whole = row.clone();
            for &(a, b) in &this.pairs {
                row[a] = difference(dag, row[a], whole[b]);
            }
        }
        this.prepared_first(dag);
        this
    }

    /// Puts rates first whose diagonal entry depends on parameters alone: their pivots are computed in `prepare()`.
    fn prepared_first(&mut self, dag: &Dag) {
        let varies = |&i: &usize| dag.dependence(self.mass[i][i]) == Dependence::State;
        self.order.sort_by_key(varies);
        let order = &self.order;
        self.mass = order.iter().map(|&i| order.iter().map(|&j| self.mass[i][j]).collect()).collect();
        self.forcing = order.iter().map(|&i| self.forcing[i]).collect();
    }

    /// Converts the derivatives of the rates, in the order of the elimination, to those of the speeds.
    pub fn relative(&self, dag: &mut Dag, derivatives: &[ExprId]) -> Vec<ExprId> {
        let mut rates = derivatives.to_vec();
        for (&i, &derivative) in self.order.iter().zip(derivatives) {
            rates[i] = derivative;
        }
        let mut speeds = rates.clone();
        for &(a, b) in &self.pairs {
            speeds[b] = dag.sub(rates[b], rates[a]);
        }
        speeds
    }
}

/// a - b with the terms that both have omitted.
fn difference(dag: &mut Dag, a: ExprId, b: ExprId) -> ExprId {
    if let Some(rest) = without(dag, a, false, b) {
        return rest;
    }
    let parts = match dag.node(b) {
        Node::Binary(Binary::Add, x, y) => Some(((x, false), (y, false))),
        Node::Binary(Binary::Sub, x, y) => Some(((x, false), (y, true))),
        _ => None,
    };
    if let Some((x, y)) = parts {
        for ((term, negative), (other, minus)) in [(x, y), (y, x)] {
            if let Some(rest) = without(dag, a, negative, term) {
                let other = if minus { dag.negate(other) } else { other };
                return difference(dag, rest, other);
            }
        }
    }
    dag.sub(a, b)
}

/// The sum a without its term `term` (without -`term`, if `negative`); `None` if a has no such term.
fn without(dag: &mut Dag, a: ExprId, negative: bool, term: ExprId) -> Option<ExprId> {
    if a == term && !negative {
        return Some(dag.zero());
    }
    if a <= term {
        return None; // operands come before their sum
    }
    match dag.node(a) {
        Node::Negate(x) => without(dag, x, !negative, term).map(|rest| dag.negate(rest)),
        Node::Binary(operator @ (Binary::Add | Binary::Sub), x, y) => {
            let minus = operator == Binary::Sub;
            let join = |dag: &mut Dag, x, y| if minus { dag.sub(x, y) } else { dag.add(x, y) };
            if let Some(rest) = without(dag, x, negative, term) {
                return Some(join(dag, rest, y));
            }
            without(dag, y, negative != minus, term).map(|rest| join(dag, x, rest))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// M of two parallel hinges: M_bb = z, M_ab = d + z, M_aa = (c + d) + M_ab.
    fn hinges(dag: &mut Dag) -> ([ExprId; 3], Vec<Vec<ExprId>>) {
        let [z, d] = ["z", "d"].map(|name| dag.symbol(name));
        let c = dag.parameter("c");
        let mixed = dag.add(d, z);
        let sum = dag.add(c, d);
        let own = dag.add(sum, mixed);
        ([c, d, z], vec![vec![own, mixed], vec![mixed, z]])
    }

    #[test]
    fn what_parallel_hinges_share_is_left_out() {
        let mut dag = Dag::default();
        let ([c, d, z], mass) = hinges(&mut dag);
        let [f, g] = ["f", "g"].map(|name| dag.symbol(name));
        let both = dag.add(f, g);
        let absolute = Absolute::new(&mut dag, &mass, &[both, g]);
        assert_eq!(absolute.mass, [[c, d], [d, z]]);
        assert_eq!(absolute.forcing, [f, g]);
        let [a, b] = ["a", "b"].map(|name| dag.symbol(name));
        let difference = dag.sub(b, a);
        assert_eq!(absolute.relative(&mut dag, &[a, b]), [a, difference]);
    }

    #[test]
    fn rates_that_share_nothing_stay() {
        let mut dag = Dag::default();
        let [x, y, z, f, g] = ["x", "y", "z", "f", "g"].map(|name| dag.symbol(name));
        let mass = [vec![x, y], vec![y, z]];
        let absolute = Absolute::new(&mut dag, &mass, &[f, g]);
        assert_eq!(absolute.mass, mass);
        assert_eq!(absolute.relative(&mut dag, &[f, g]), [f, g]);
    }

    #[test]
    fn a_prepared_diagonal_comes_first() {
        let mut dag = Dag::default();
        let [x, y, f, g] = ["x", "y", "f", "g"].map(|name| dag.symbol(name));
        let c = dag.parameter("c");
        let absolute = Absolute::new(&mut dag, &[vec![x, y], vec![y, c]], &[f, g]);
        assert_eq!(absolute.mass, [[c, y], [y, x]]);
        assert_eq!(absolute.forcing, [g, f]);
        assert_eq!(absolute.relative(&mut dag, &[g, f]), [f, g]);
    }

    #[test]
    fn a_difference_keeps_the_terms_of_one_side() {
        let mut dag = Dag::default();
        let [x, y, z, w] = ["x", "y", "z", "w"].map(|name| dag.symbol(name));
        // (w - (x + y)) - (z - y) = (w - x) - z
        let sum = dag.add(x, y);
        let (a, b) = (dag.sub(w, sum), dag.sub(z, y));
        let rest = dag.sub(w, x);
        let expected = dag.sub(rest, z);
        assert_eq!(difference(&mut dag, a, b), expected);
    }
}
