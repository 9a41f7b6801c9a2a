//! Vectors as sums of scalar x unit vector of a triad, and the triads they refer to.
//!
//! A [`Vector`] keeps each term in the triad where it is constant or short; [`Triads`] knows how the triads are turned
//! against each other and expresses a vector in any one of them on demand.
//! Convention: a simple rotation by angle a about axis k turns the parent's triad into the child's
//! (right-hand rule); components transform by v_parent = R v_child.

mod components;
mod merged_turn;
mod product;
mod triads;

use crate::expr::{Dag, ExprId};
use crate::model::{Axis, PointId};
use crate::sorted::Sorted;
use merged_turn::MergedTurn;

pub use components::{along_axis, cross_components, dot_components, turn_components};
pub use triads::{Components, Spin, TriadId, Triads, Turn};

/// A vector: components in one or several triads, plus multiples of the positions of lifted points.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Vector {
    /// Non-zero terms.
    pub terms: Sorted<TriadId, Components>,
    /// Coefficients of the positions of lifted points, whose velocities are unknowns of their own.
    pub points: Sorted<PointId, ExprId>,
}

impl Vector {
    /// The zero vector.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// Components in one triad.
    pub fn new(dag: &Dag, triad: TriadId, components: Components) -> Self {
        let mut vector = Self::default();
        if components.iter().any(|&c| !dag.is_zero(c)) {
            vector.terms.insert(triad, components);
        }
        vector
    }

    /// A unit vector of a triad.
    pub fn axis(dag: &mut Dag, triad: TriadId, axis: Axis) -> Self {
        let mut components = [dag.zero(); 3];
        components[axis as usize] = dag.one();
        Self::new(dag, triad, components)
    }

    /// The position of a lifted point, kept whole.
    pub fn position(dag: &mut Dag, point: PointId) -> Self {
        Self { terms: Sorted::default(), points: Sorted::from_iter([(point, dag.one())]) }
    }

    /// Zero?
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty() && self.points.is_empty()
    }

    /// a + b.
    #[must_use]
    pub fn plus(&self, dag: &mut Dag, other: &Self) -> Self {
        let mut sum = self.clone();
        for (&triad, components) in &other.terms {
            let merged = match sum.terms.get(&triad) {
                Some(mine) => std::array::from_fn(|k| dag.add(mine[k], components[k])),
                None => *components,
            };
            if merged.iter().all(|&c| dag.is_zero(c)) {
                sum.terms.remove(&triad);
            } else {
                sum.terms.insert(triad, merged);
            }
        }
        for (&point, &factor) in &other.points {
            let merged = match sum.points.get(&point) {
                Some(&mine) => dag.add(mine, factor),
                None => factor,
            };
            if dag.is_zero(merged) {
                sum.points.remove(&point);
            } else {
                sum.points.insert(point, merged);
            }
        }
        sum
    }

    /// factor a.
    #[must_use]
    pub fn scaled(&self, dag: &mut Dag, factor: ExprId) -> Self {
        if dag.is_zero(factor) {
            return Self::zero();
        }
        self.map(|x| dag.mul(factor, x))
    }

    /// -a.
    #[must_use]
    pub fn negated(&self, dag: &mut Dag) -> Self {
        self.map(|x| dag.negate(x))
    }

    /// The vector with f applied to every component and coefficient.
    fn map(&self, mut f: impl FnMut(ExprId) -> ExprId) -> Self {
        let mut vector = self.clone();
        vector.terms.values_mut().flatten().chain(vector.points.values_mut()).for_each(|x| *x = f(*x));
        vector
    }

    /// a - b.
    #[must_use]
    pub fn minus(&self, dag: &mut Dag, other: &Self) -> Self {
        let negative = other.negated(dag);
        self.plus(dag, &negative)
    }
}

/// The expressions and the triads that vectors are built from; first argument of every stage that builds any.
#[derive(Clone, Debug, Default)]
pub struct Algebra {
    /// The expressions.
    pub dag: Dag,
    /// All triads; the first is inertial.
    pub triads: Triads,
}

impl Algebra {
    /// a . b.
    pub fn dot(&mut self, a: &Vector, b: &Vector) -> ExprId {
        self.triads.dot(&mut self.dag, a, b)
    }

    /// a . a as a sum of squares: products of terms in several triads would cancel where points meet or a point stands,
    /// and rounding leave less than 0.
    pub fn square(&mut self, a: &Vector) -> ExprId {
        let candidates: Vec<TriadId> = a.terms.keys().copied().collect();
        let square = |triad| {
            let components = self.express(a, triad);
            dot_components(&mut self.dag, &components, &components)
        };
        let squares: Vec<ExprId> = candidates.into_iter().map(square).collect();
        let least = squares.into_iter().min_by_key(|square| self.dag.cone_cost(&[*square]));
        least.unwrap_or_else(|| self.dag.zero())
    }

    /// a x b.
    pub fn cross(&mut self, a: &Vector, b: &Vector) -> Vector {
        self.triads.cross(&mut self.dag, a, b)
    }

    /// Components of a vector in a triad.
    pub fn express(&mut self, vector: &Vector, target: TriadId) -> Components {
        self.triads.express(&mut self.dag, vector, target)
    }

    /// [`Self::express`], using sines and cosines of differences of angles where two rotations share an axis.
    pub fn express_by_differences(&mut self, vector: &Vector, target: TriadId) -> Components {
        self.triads.express_by_differences(&mut self.dag, vector, target)
    }

    /// The vector with those terms moved to `target` that are constant there.
    pub fn with_constants(&mut self, vector: &Vector, target: TriadId) -> Vector {
        self.triads.with_constants(&mut self.dag, vector, target)
    }
}

impl Triads {
    /// `vector` with every term moved to `target` whose unit vectors are known to be constant there.
    pub fn with_constants(&self, dag: &mut Dag, vector: &Vector, target: TriadId) -> Vector {
        let mut result = Vector { terms: Sorted::default(), points: vector.points.clone() };
        for (&triad, components) in &vector.terms {
            let replaced = match self.constant_in(dag, triad, components, target) {
                Some(constant) => Vector::new(dag, target, constant),
                None => Vector::new(dag, triad, *components),
            };
            result = result.plus(dag, &replaced);
        }
        result
    }

    /// Components in `target`, if all non-zero ones lie along axes that are constant there.
    fn constant_in(
        &self,
        dag: &mut Dag,
        triad: TriadId,
        components: &Components,
        target: TriadId,
    ) -> Option<Components> {
        let mut total = [dag.zero(); 3];
        for (axis, &component) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(components) {
            if dag.is_zero(component) {
                continue;
            }
            let places = self.constants.get(&(triad, axis))?;
            let (_, constant) = places.iter().rev().find(|(other, _)| *other == target)?;
            for k in 0..3 {
                let term = dag.mul(component, constant[k]);
                total[k] = dag.add(total[k], term);
            }
        }
        Some(total)
    }

    /// Components in `target` of a vector without terms in `points`.
    ///
    /// Terms in ancestors of `target` are summed on the way down, outermost first: each rotation then turns one sum,
    /// and vectors with the same leading terms share them.
    pub fn express(&mut self, dag: &mut Dag, vector: &Vector, target: TriadId) -> Components {
        debug_assert!(vector.points.is_empty(), "positions are flattened before they are expressed");
        let path = self.ancestors[target].clone();
        let mut total = [dag.zero(); 3];
        for &triad in path.iter().rev() {
            total = self.to_child(dag, triad, total);
            if let Some(term) = vector.terms.get(&triad)
                && self.constant_in(dag, triad, term, target).is_none()
            {
                total = std::array::from_fn(|k| dag.add(total[k], term[k]));
            }
        }
        for (&triad, components) in &vector.terms {
            let added = path.contains(&triad) && self.constant_in(dag, triad, components, target).is_none();
            if !added {
                let here = self.express_term(dag, triad, *components, target);
                total = std::array::from_fn(|k| dag.add(total[k], here[k]));
            }
        }
        total
    }

    /// Components in `target` of a vector given in `triad`.
    fn express_term(
        &mut self,
        dag: &mut Dag,
        triad: TriadId,
        components: Components,
        target: TriadId,
    ) -> Components {
        if triad == target {
            return components;
        }
        if let Some(&known) = self.expressed.get(&(triad, components, target)) {
            return known;
        }
        let expressed = match self.constant_in(dag, triad, &components, target) {
            Some(constant) => constant,
            None => {
                let merged =
                    dag.unrounded_differences.then(|| self.by_differences(dag, triad, components, target));
                merged.flatten().unwrap_or_else(|| self.turn_by_turn(dag, triad, components, target))
            }
        };
        self.expressed.insert((triad, components, target), expressed);
        expressed
    }

    /// [`Self::express_term`], with sines and cosines of differences of angles where that takes fewer operations.
    ///
    /// Used only in cross products, which form directions. Products that enter equations keep the sines of the angles
    /// themselves: an error of one sine then turns all equations alike, whereas the rounding of a difference would
    /// turn only some of them (the four-bar lost a factor of 5, and 2.5 at 1e-6 rad from its change point). An
    /// unrounded difference has no such error: [`Dag::as_difference`].
    fn shorter_term(&mut self, dag: &mut Dag, from: TriadId, v: Components, to: TriadId) -> Components {
        let turned = self.express_term(dag, from, v, to);
        match self.by_differences(dag, from, v, to) {
            Some(merged) if dag.cone_cost(&merged) < dag.cone_cost(&turned) => merged,
            _ => turned,
        }
    }

    /// Rotates from `from` up to the lowest common ancestor and down to `to`, one rotation at a time.
    fn turn_by_turn(&self, dag: &mut Dag, from: TriadId, components: Components, to: TriadId) -> Components {
        let (up, down) = self.ways(from, to);
        let mut v = components;
        for &t in up {
            v = self.to_parent(dag, t, v);
        }
        for &t in down.iter().rev() {
            v = self.to_child(dag, t, v);
        }
        v
    }

    /// The triads on the paths from two triads up to their lowest common ancestor, which is excluded.
    fn ways(&self, from: TriadId, to: TriadId) -> (&[TriadId], &[TriadId]) {
        let (up, down) = (&self.ancestors[from], &self.ancestors[to]);
        // Counted from the inertial triad, the two paths agree as far as their common ancestors go.
        let common = up.iter().rev().zip(down.iter().rev()).take_while(|(a, b)| a == b).count();
        (&up[..up.len() - common], &down[..down.len() - common])
    }

    /// [`Self::express`], where consecutive rotations about one axis are merged into one by the sum or difference of
    /// their angles, as for two links that are turned against the same triad by absolute angles. The merged rotation
    /// rounds as if one of the angles had an error of one rounding.
    pub fn express_by_differences(&mut self, dag: &mut Dag, vector: &Vector, target: TriadId) -> Components {
        debug_assert!(vector.points.is_empty(), "positions are flattened before they are expressed");
        let mut total = [dag.zero(); 3];
        for (&triad, &components) in &vector.terms {
            let Some(turns) = self.merged_turns(dag, triad, target) else {
                return self.express(dag, vector, target);
            };
            let v = MergedTurn::turn(&turns, dag, components);
            total = std::array::from_fn(|k| dag.add(total[k], v[k]));
        }
        total
    }

    fn to_parent(&self, dag: &mut Dag, triad: TriadId, v: Components) -> Components {
        match &self.turns[triad] {
            Turn::Inertial => v,
            Turn::Simple { axis, angle, .. } => turn_components(dag, *axis, *angle, v, false),
            Turn::Directions { rows, .. } => std::array::from_fn(|k| {
                let terms: [ExprId; 3] = std::array::from_fn(|j| dag.mul(v[j], rows[j][k]));
                dag.sum(&terms)
            }),
        }
    }

    fn to_child(&self, dag: &mut Dag, triad: TriadId, v: Components) -> Components {
        match &self.turns[triad] {
            Turn::Inertial => v,
            Turn::Simple { axis, angle, .. } => turn_components(dag, *axis, *angle, v, true),
            Turn::Directions { rows, .. } => std::array::from_fn(|j| dot_components(dag, &rows[j], &v)),
        }
    }
}
