//! Time derivatives of scalars and vectors by the frame rule.
//!
//! d/dt (s e) = s' e + s (w x e) for e fixed in a triad of angular velocity w: the dependence of rotated components on
//! q is never differentiated. A [`Motion`] holds the partial velocities v_k and the bias: v = sum_k v_k y_k, a = sum_k
//! v_k y_k' + bias, with y the unknowns (speeds, lifted twists, clock).

use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Motion, Rate};
use super::unknowns::UnknownId;
use crate::expr::number::Number;
use crate::expr::{Dag, ExprId};
use crate::id::Id;
use crate::model::CoordinateId;
use crate::vector::{Algebra, TriadId, Vector};
use rustc_hash::FxHashMap as HashMap;
use std::collections::BTreeSet;

impl Motion {
    /// Adds the partial velocities of a vector whose components in a triad have these rates.
    pub(super) fn add_components(&mut self, alg: &mut Algebra, triad: TriadId, rates: &[Rate; 3]) {
        let zero = alg.dag.zero();
        let unknowns: BTreeSet<UnknownId> = rates.iter().flat_map(|r| r.partials.keys().copied()).collect();
        for unknown in unknowns {
            let c = std::array::from_fn(|i| rates[i].partials.get(&unknown).copied().unwrap_or(zero));
            let term = Vector::new(&alg.dag, triad, c);
            self.partials.add_term(&mut alg.dag, unknown, &term);
        }
    }

    /// Adds `factor` times `other`.
    pub(super) fn add(&mut self, dag: &mut Dag, factor: ExprId, other: &Self) {
        self.partials.add(dag, factor, &other.partials);
        let bias = other.bias.scaled(dag, factor);
        self.bias = self.bias.plus(dag, &bias);
    }

    /// The velocity: `sum_k partials[k] y_k`.
    pub fn value(&self, alg: &mut Algebra, k: &Kinematics) -> Vector {
        self.partials.value(&mut alg.dag, &k.unknowns)
    }
}

impl Rate {
    /// s': `sum_k partials[k] y_k`.
    pub fn value(&self, alg: &mut Algebra, k: &Kinematics) -> ExprId {
        self.partials.value(&mut alg.dag, &k.unknowns)
    }
}

/// s' and the bias of s'' for a scalar function of the coordinates.
pub(crate) fn scalar_rate(alg: &mut Algebra, k: &Kinematics, s: ExprId) -> Rate {
    let partials = total_derivative(alg, k, s);
    let bias = bias_of(alg, k, &partials);
    Rate { partials, bias }
}

/// sum_k (d/dt partial_k) y_k: the part of the second derivative without y'.
///
/// Computed either partial by partial, which shares products of speeds, or as the rate of s' in one sweep; the shorter
/// one is returned.
pub(super) fn bias_of(alg: &mut Algebra, k: &Kinematics, partials: &LinearForm) -> ExprId {
    let mut bias = alg.dag.zero();
    for (&unknown, &partial) in partials {
        let y = k.unknowns[unknown].value;
        for (other, second) in total_derivative(alg, k, partial) {
            let z = k.unknowns[other].value;
            let product = alg.dag.mul(y, z);
            let term = alg.dag.mul(second, product);
            bias = alg.dag.add(bias, term);
        }
    }
    let value = partials.value(&mut alg.dag, &k.unknowns);
    let swept = configuration_rate(alg, k, value);
    if alg.dag.cone_cost(&[swept]) < alg.dag.cone_cost(&[bias]) { swept } else { bias }
}

/// d/dt of an expression due to the coordinates (and time) alone, with the unknowns held constant.
pub(super) fn configuration_rate(alg: &mut Algebra, k: &Kinematics, e: ExprId) -> ExprId {
    let mut rates = HashMap::default();
    for coordinate in k.rates.ids() {
        if let Some(symbol) = k.variable(&alg.dag, coordinate) {
            let rate = k.rates[coordinate].value(alg, k);
            if alg.dag.may_depend(e, symbol) {
                rates.insert(symbol, rate);
            }
        }
    }
    if let (Some(_), Some(time)) = (k.unknowns.clock(), alg.dag.as_symbol(k.time)) {
        rates.insert(time, alg.dag.one());
    }
    alg.dag.rate(e, &rates)
}

/// Coefficients of the unknowns in s'.
fn total_derivative(alg: &mut Algebra, k: &Kinematics, s: ExprId) -> LinearForm {
    let one = alg.dag.one();
    rate_of_sum(alg, k, &[(one, s)])
}

/// The rate of a sum whose coefficients c are held constant: sum c s'.
pub(crate) fn sum_of_rates(alg: &mut Algebra, k: &Kinematics, terms: &[(ExprId, ExprId)]) -> Rate {
    let partials = rate_of_sum(alg, k, terms);
    let bias = bias_of(alg, k, &partials);
    Rate { partials, bias }
}

/// Coefficients of the unknowns in sum c s'. A sum that is the model's definition of a speed becomes that speed alone.
fn rate_of_sum(alg: &mut Algebra, k: &Kinematics, terms: &[(ExprId, ExprId)]) -> LinearForm {
    let mut partials = LinearForm::default();
    let mut slopes: Vec<(CoordinateId, ExprId)> = Vec::new();
    let in_time = k.unknowns.clock().zip(alg.dag.as_symbol(k.time));
    for &(factor, s) in terms {
        if alg.dag.is_constant(s) {
            continue;
        }
        let symbols = alg.dag.symbols_of(s);
        for (coordinate, rate) in k.rates.enumerate() {
            if let Some(symbol) = k.variable(&alg.dag, coordinate).filter(|symbol| symbols.contains(symbol)) {
                let slope = alg.dag.derivative(s, symbol);
                let slope = alg.dag.mul(factor, slope);
                match k.combinations.is_empty() {
                    true => partials.add(&mut alg.dag, slope, &rate.partials),
                    false => slopes.push((coordinate, slope)),
                }
            }
        }
        if let Some((clock, time)) = in_time {
            let slope = alg.dag.derivative(s, time);
            let slope = alg.dag.mul(factor, slope);
            partials.add_term(&mut alg.dag, clock, &slope);
        }
    }
    let mut by_coordinate = LinearForm::default();
    for &(coordinate, slope) in &slopes {
        by_coordinate.add_term(&mut alg.dag, UnknownId::from_index(coordinate.index()), &slope);
    }
    match k.combinations.iter().find(|(_, combination)| *combination == by_coordinate) {
        Some((speed, _)) => {
            let one = alg.dag.one();
            partials.add_term(&mut alg.dag, *speed, &one);
        }
        None => {
            for (coordinate, slope) in slopes {
                partials.add(&mut alg.dag, slope, &k.rates[coordinate].partials);
            }
        }
    }
    partials
}

/// Coefficients of the unknowns in expressions that are linear in them, de/dy; that of the clock is the value of the
/// expression when all other unknowns are 0.
pub(super) fn coefficients<const N: usize>(
    alg: &mut Algebra,
    k: &Kinematics,
    linear: [ExprId; N],
) -> Vec<(UnknownId, [ExprId; N])> {
    let mut found = Vec::new();
    let mut at_rest = HashMap::default();
    for unknown in k.unknowns.ids().collect::<Vec<_>>() {
        let Some(symbol) = alg.dag.as_symbol(k.unknowns[unknown].value) else { continue };
        found.push((unknown, linear.map(|e| alg.dag.derivative(e, symbol))));
        at_rest.insert(symbol, alg.dag.zero());
    }
    if let Some(clock) = k.unknowns.clock() {
        let free = alg.dag.substitute(&linear, &at_rest);
        found.push((clock, std::array::from_fn(|i| free[i])));
    }
    found
}

/// The motion of a velocity that is given as linear in the unknowns: `v_k = dv/dy_k`. The bias is its rate in N with
/// the unknowns held constant, by the frame rule: rate of the components plus w x v.
pub(super) fn linear_motion(alg: &mut Algebra, k: &Kinematics, velocity: &Vector) -> Motion {
    let mut motion = Motion::default();
    for (&triad, components) in &velocity.terms {
        for (unknown, partial) in coefficients(alg, k, *components) {
            let partial = Vector::new(&alg.dag, triad, partial);
            motion.partials.add_term(&mut alg.dag, unknown, &partial);
        }
        let here = Vector::new(&alg.dag, triad, *components);
        let relative = components.map(|c| configuration_rate(alg, k, c));
        let relative = Vector::new(&alg.dag, triad, relative);
        let w = k.angular[triad].value(alg, k);
        let turning = alg.cross(&w, &here);
        motion.bias = motion.bias.plus(&mut alg.dag, &relative).plus(&mut alg.dag, &turning);
    }
    motion
}

/// Time derivative in N of a vector given as components in triads and lifted points.
pub(crate) fn derivative(alg: &mut Algebra, k: &Kinematics, vector: &Vector) -> Motion {
    let mut motion = Motion::default();
    for (&point, &factor) in &vector.points {
        motion.add(&mut alg.dag, factor, &k.velocities[point]);
    }
    for (&triad, components) in &vector.terms {
        // Positions of points along a chain begin with the same terms.
        let known = k.term_derivatives.borrow().get(&(triad, *components)).cloned();
        let term = known.unwrap_or_else(|| {
            let term = derivative_of_term(alg, k, triad, *components);
            k.term_derivatives.borrow_mut().insert((triad, *components), term.clone());
            term
        });
        let one = alg.dag.one();
        motion.add(&mut alg.dag, one, &term);
    }
    motion
}

/// v = s' e + w x s e ; a = s'' e + 2 w x s' e + s (alpha x e + w x (w x e)).
///
/// If the components are constants times one scalar s, as along a rod, e is the constant vector: w x e and w x (w x e)
/// are then formed once for all multiples of it. Otherwise s = 1 and e is the whole vector.
fn derivative_of_term(alg: &mut Algebra, k: &Kinematics, triad: TriadId, components: [ExprId; 3]) -> Motion {
    let (scale, direction) = common_factor(alg, components);
    let e = Vector::new(&alg.dag, triad, direction);
    let growth = growing(alg, k, triad, scale, direction);
    let mut motion = growth.motion;
    let angular = &k.angular[triad];
    if angular.partials.is_empty() {
        return motion;
    }
    for (&unknown, w) in &angular.partials {
        let term = alg.cross(w, &e).scaled(&mut alg.dag, scale);
        motion.partials.add_term(&mut alg.dag, unknown, &term);
    }
    let w = angular.value(alg, k);
    // Expresses w in the triad of the term: all products use the same components.
    let w = in_triad(alg, &w, triad);
    let turning = alg.cross(&w, &e);
    let two = alg.dag.number(Number::integer(2));
    let coriolis = match growth.rate {
        Growth::Scalar(rate) => turning.scaled(&mut alg.dag, rate),
        Growth::Vector(relative) => alg.cross(&w, &relative),
    };
    let coriolis = coriolis.scaled(&mut alg.dag, two);
    let centripetal = alg.cross(&w, &turning);
    let euler = alg.cross(&angular.bias, &e);
    let turned = centripetal.plus(&mut alg.dag, &euler).scaled(&mut alg.dag, scale);
    motion.bias = motion.bias.plus(&mut alg.dag, &coriolis).plus(&mut alg.dag, &turned);
    motion
}

/// The motion of a term relative to its triad: s' e and s'' e.
struct Growing {
    motion: Motion,
    rate: Growth,
}

/// s' if the direction is constant, otherwise the relative velocity.
enum Growth {
    Scalar(ExprId),
    Vector(Vector),
}

fn growing(
    alg: &mut Algebra,
    k: &Kinematics,
    triad: TriadId,
    scale: ExprId,
    direction: [ExprId; 3],
) -> Growing {
    let mut motion = Motion::default();
    if direction.iter().all(|&c| alg.dag.is_constant(c)) {
        let e = Vector::new(&alg.dag, triad, direction);
        let rate = scalar_rate(alg, k, scale);
        for (&unknown, &partial) in &rate.partials {
            let term = e.scaled(&mut alg.dag, partial);
            motion.partials.add_term(&mut alg.dag, unknown, &term);
        }
        motion.bias = e.scaled(&mut alg.dag, rate.bias);
        return Growing { motion, rate: Growth::Scalar(rate.value(alg, k)) };
    }
    let rates = direction.map(|c| scalar_rate(alg, k, c));
    motion.add_components(alg, triad, &rates);
    let second = std::array::from_fn(|i| rates[i].bias);
    motion.bias = Vector::new(&alg.dag, triad, second);
    let relative = std::array::from_fn(|i| rates[i].value(alg, k));
    Growing { motion, rate: Growth::Vector(Vector::new(&alg.dag, triad, relative)) }
}

/// (s, e) with e constant and components = s e, if such an s exists; otherwise (1, components).
///
/// Along a single axis e is a unit vector, so that different multiples of a rod share their derivatives.
fn common_factor(alg: &mut Algebra, components: [ExprId; 3]) -> (ExprId, [ExprId; 3]) {
    let split = components.map(|c| alg.dag.split_coefficient(c));
    let mut factors = split.iter().filter(|(number, _)| *number != Number::ZERO).map(|(_, factor)| *factor);
    let one = alg.dag.one();
    let Some(first) = factors.next() else { return (one, components) };
    if factors.any(|factor| factor != first) {
        return (one, components);
    }
    let mut sizes = split.iter().map(|(number, _)| *number).filter(|number| *number != Number::ZERO);
    let size = match (sizes.next(), sizes.next()) {
        (Some(only), None) => only.magnitude(),
        _ => Number::ONE,
    };
    let scale = alg.dag.number(size);
    let unit = size.reciprocal();
    (alg.dag.mul(scale, first), split.map(|(number, _)| alg.dag.number(number.multiply(unit))))
}

fn in_triad(alg: &mut Algebra, vector: &Vector, triad: TriadId) -> Vector {
    let components = alg.express(vector, triad);
    Vector::new(&alg.dag, triad, components)
}
