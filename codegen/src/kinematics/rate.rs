//! Derivatives of scalars and vectors by the frame rule, and the values of rates.
//!
//! d/dt (s e) = s' e + s (w x e) for e fixed in a triad of angular velocity w: derivatives never go
//! through the components' dependence on q. A [`Motion`] holds the partial velocities v_k and the
//! bias: v = sum_k v_k y_k, a = sum_k v_k y_k' + bias, with y the unknowns (speeds, lifted twists).

use super::quantities::{Kinematics, Motion, Rate, UnknownId};
use crate::expr::ExprId;
use crate::expr::number::Number;
use crate::vector::{TriadId, Vector};
use rustc_hash::FxHashMap as HashMap;
use std::collections::{BTreeMap, BTreeSet};

impl Motion {
    /// Adds `factor` times `other`.
    pub(super) fn add(&mut self, k: &mut Kinematics, other: &Self, factor: ExprId) {
        for (&unknown, v) in &other.partials {
            let term = v.scaled(&mut k.dag, factor);
            self.add_partial(k, unknown, &term);
        }
        let bias = other.bias.scaled(&mut k.dag, factor);
        self.bias = self.bias.plus(&mut k.dag, &bias);
    }

    pub(super) fn add_partial(&mut self, k: &mut Kinematics, unknown: UnknownId, term: &Vector) {
        let sum = match self.partials.get(&unknown) {
            Some(mine) => mine.plus(&mut k.dag, term),
            None => term.clone(),
        };
        if sum.is_zero() {
            self.partials.remove(&unknown);
        } else {
            self.partials.insert(unknown, sum);
        }
    }
}

/// s' and the bias of s'' for a scalar function of the coordinates.
pub(crate) fn scalar_rate(k: &mut Kinematics, s: ExprId) -> Rate {
    let zero = k.dag.zero();
    let mut rate = Rate { partials: BTreeMap::new(), bias: zero };
    if k.dag.is_constant(s) {
        return rate;
    }
    rate.partials = total_derivative(k, s);
    rate.bias = bias_of(k, &rate.partials);
    rate
}

/// sum_k (d/dt partial_k) y_k: what remains of the second derivative.
///
/// Either partial by partial, where products of speeds are shared, or as the rate of s' in one sweep:
/// whichever is shorter.
pub(super) fn bias_of(k: &mut Kinematics, partials: &BTreeMap<UnknownId, ExprId>) -> ExprId {
    let mut bias = k.dag.zero();
    for (&unknown, &partial) in partials {
        let y = k.unknowns[unknown].value;
        for (other, second) in total_derivative(k, partial) {
            let z = k.unknowns[other].value;
            let product = k.dag.mul(y, z);
            let term = k.dag.mul(second, product);
            bias = k.dag.add(bias, term);
        }
    }
    let rate = Rate { partials: partials.clone(), bias };
    let value = rate_value(k, &rate);
    let swept = configuration_rate(k, value);
    if k.dag.cone_cost(&[swept]) < k.dag.cone_cost(&[bias]) { swept } else { bias }
}

/// d/dt of an expression through the coordinates alone, the unknowns held.
pub(super) fn configuration_rate(k: &mut Kinematics, e: ExprId) -> ExprId {
    let mut rates = HashMap::default();
    for coordinate in k.rates.ids() {
        if let Some(symbol) = k.variable(coordinate) {
            let rate = k.rates[coordinate].clone();
            rates.insert(symbol, rate_value(k, &rate));
        }
    }
    if let (Some(_), Some(time)) = (k.clock, k.dag.as_symbol(k.time)) {
        rates.insert(time, k.dag.one());
    }
    k.dag.rate(e, &rates)
}

/// Coefficients of the unknowns in s'.
fn total_derivative(k: &mut Kinematics, s: ExprId) -> BTreeMap<UnknownId, ExprId> {
    let mut partials: BTreeMap<UnknownId, ExprId> = BTreeMap::new();
    if k.dag.is_constant(s) {
        return partials;
    }
    let symbols = k.dag.symbols_of(s);
    for coordinate in k.rates.ids() {
        let Some(symbol) = k.variable(coordinate) else { continue };
        if !symbols.contains(&symbol) {
            continue;
        }
        let slope = k.dag.derivative(s, symbol);
        let map: Vec<_> = k.rates[coordinate].partials.iter().map(|(&u, &n)| (u, n)).collect();
        for (unknown, n) in map {
            let term = k.dag.mul(slope, n);
            let sum = match partials.get(&unknown) {
                Some(&mine) => k.dag.add(mine, term),
                None => term,
            };
            partials.insert(unknown, sum);
        }
    }
    if let (Some(clock), Some(time)) = (k.clock, k.dag.as_symbol(k.time)) {
        let slope = k.dag.derivative(s, time);
        let mine = partials.get(&clock).copied().unwrap_or_else(|| k.dag.zero());
        partials.insert(clock, k.dag.add(mine, slope));
    }
    partials.retain(|_, p| !k.dag.is_zero(*p));
    partials
}

/// Coefficients of the unknowns in expressions that are linear in them: de/dy; the clock's are what is left
/// of the expressions when all others are 0.
pub(super) fn coefficients<const N: usize>(
    k: &mut Kinematics,
    linear: [ExprId; N],
) -> Vec<(UnknownId, [ExprId; N])> {
    let mut found = Vec::new();
    let mut at_rest = HashMap::default();
    for unknown in k.unknowns.ids().collect::<Vec<_>>() {
        let Some(symbol) = k.dag.as_symbol(k.unknowns[unknown].value) else { continue };
        found.push((unknown, linear.map(|e| k.dag.derivative(e, symbol))));
        at_rest.insert(symbol, k.dag.zero());
    }
    if let Some(clock) = k.clock {
        let free = k.dag.substitute(&linear, &at_rest);
        found.push((clock, std::array::from_fn(|i| free[i])));
    }
    found
}

/// The motion of a vector given as linear in the unknowns: `v_k = dv/dy_k`; the bias is the vector's
/// rate with the unknowns held, by the frame rule: that of its components and w x v.
pub(super) fn linear_motion(k: &mut Kinematics, velocity: &Vector) -> Motion {
    let mut motion = Motion::default();
    for (&triad, components) in &velocity.terms {
        for (unknown, partial) in coefficients(k, *components) {
            let partial = Vector::new(&k.dag, triad, partial);
            motion.add_partial(k, unknown, &partial);
        }
        let here = Vector::new(&k.dag, triad, *components);
        let relative = components.map(|c| configuration_rate(k, c));
        let relative = Vector::new(&k.dag, triad, relative);
        let angular = k.angular[triad].clone();
        let w = motion_value(k, &angular);
        let turning = k.triads.cross(&mut k.dag, &w, &here);
        motion.bias = motion.bias.plus(&mut k.dag, &relative).plus(&mut k.dag, &turning);
    }
    motion
}

/// Value of a scalar's rate: `sum_k partials[k] y_k`.
pub(crate) fn rate_value(k: &mut Kinematics, rate: &Rate) -> ExprId {
    let mut total = k.dag.zero();
    for (&unknown, &partial) in &rate.partials {
        let term = k.dag.mul(partial, k.unknowns[unknown].value);
        total = k.dag.add(total, term);
    }
    total
}

/// Value of a velocity: `sum_k partials[k] y_k`.
pub(crate) fn motion_value(k: &mut Kinematics, motion: &Motion) -> Vector {
    let mut total = Vector::zero();
    for (&unknown, partial) in &motion.partials {
        let term = partial.scaled(&mut k.dag, k.unknowns[unknown].value);
        total = total.plus(&mut k.dag, &term);
    }
    total
}

/// Time derivative in N of a vector given as components in triads and lifted points.
pub(crate) fn derivative(k: &mut Kinematics, vector: &Vector) -> Motion {
    let mut motion = Motion::default();
    for (&point, &factor) in &vector.points {
        let velocity = k.velocities[point].clone();
        motion.add(k, &velocity, factor);
    }
    for (&triad, components) in &vector.terms {
        // Points along a chain share the terms of those farther in.
        let known = k.term_derivatives.get(&(triad, *components)).cloned();
        let term = known.unwrap_or_else(|| derivative_of_term(k, triad, *components));
        k.term_derivatives.entry((triad, *components)).or_insert_with(|| term.clone());
        let one = k.dag.one();
        motion.add(k, &term, one);
    }
    motion
}

/// v = s' e + w x s e ; a = s'' e + 2 w x s' e + s (alpha x e + w x (w x e)).
///
/// Where the components are constants times one scalar s, as along a rod, e is their constant
/// vector: w x e and w x (w x e) are formed once for every multiple of it. Else e is all of it, s = 1.
fn derivative_of_term(k: &mut Kinematics, triad: TriadId, components: [ExprId; 3]) -> Motion {
    let (scale, direction) = common_factor(k, components);
    let e = Vector::new(&k.dag, triad, direction);
    let growth = growing(k, triad, scale, direction);
    let mut motion = growth.motion;
    let angular = k.angular[triad].clone();
    if angular.partials.is_empty() {
        return motion;
    }
    for (&unknown, w) in &angular.partials {
        let term = k.triads.cross(&mut k.dag, w, &e).scaled(&mut k.dag, scale);
        motion.add_partial(k, unknown, &term);
    }
    let w = motion_value(k, &angular);
    // w in the triad of the term: one set of components serves every product.
    let w = in_triad(k, &w, triad);
    let turning = k.triads.cross(&mut k.dag, &w, &e);
    let two = k.dag.number(Number::integer(2));
    let coriolis = match growth.rate {
        Growth::Scalar(rate) => turning.scaled(&mut k.dag, rate),
        Growth::Vector(relative) => k.triads.cross(&mut k.dag, &w, &relative),
    };
    let coriolis = coriolis.scaled(&mut k.dag, two);
    let centripetal = k.triads.cross(&mut k.dag, &w, &turning);
    let euler = k.triads.cross(&mut k.dag, &angular.bias, &e);
    let turned = centripetal.plus(&mut k.dag, &euler).scaled(&mut k.dag, scale);
    motion.bias = motion.bias.plus(&mut k.dag, &coriolis).plus(&mut k.dag, &turned);
    motion
}

/// What a term does within its triad: s' e and s'' e.
struct Growing {
    motion: Motion,
    rate: Growth,
}

/// s' of a constant direction, or the relative velocity of a direction that changes.
enum Growth {
    Scalar(ExprId),
    Vector(Vector),
}

fn growing(k: &mut Kinematics, triad: TriadId, scale: ExprId, direction: [ExprId; 3]) -> Growing {
    let mut motion = Motion::default();
    if direction.iter().all(|&c| k.dag.is_constant(c)) {
        let e = Vector::new(&k.dag, triad, direction);
        let rate = scalar_rate(k, scale);
        for (&unknown, &partial) in &rate.partials {
            let term = e.scaled(&mut k.dag, partial);
            motion.add_partial(k, unknown, &term);
        }
        motion.bias = e.scaled(&mut k.dag, rate.bias);
        return Growing { motion, rate: Growth::Scalar(rate_value(k, &rate)) };
    }
    let rates = direction.map(|c| scalar_rate(k, c));
    let zero = k.dag.zero();
    let unknowns: BTreeSet<UnknownId> = rates.iter().flat_map(|r| r.partials.keys().copied()).collect();
    for unknown in unknowns {
        let c = std::array::from_fn(|i| rates[i].partials.get(&unknown).copied().unwrap_or(zero));
        let term = Vector::new(&k.dag, triad, c);
        motion.add_partial(k, unknown, &term);
    }
    let second = std::array::from_fn(|i| rates[i].bias);
    motion.bias = Vector::new(&k.dag, triad, second);
    let relative = std::array::from_fn(|i| rate_value(k, &rates[i]));
    Growing { motion, rate: Growth::Vector(Vector::new(&k.dag, triad, relative)) }
}

/// (s, e) with e constant and components = s e, if there is such an s; else (1, components).
///
/// Along one axis e is a unit vector: half a rod and all of it share its derivatives.
fn common_factor(k: &mut Kinematics, components: [ExprId; 3]) -> (ExprId, [ExprId; 3]) {
    let split = components.map(|c| k.dag.split_coefficient(c));
    let mut factors = split.iter().filter(|(number, _)| *number != Number::ZERO).map(|(_, factor)| *factor);
    let one = k.dag.one();
    let Some(first) = factors.next() else { return (one, components) };
    if factors.any(|factor| factor != first) {
        return (one, components);
    }
    let mut sizes = split.iter().map(|(number, _)| *number).filter(|number| *number != Number::ZERO);
    let size = match (sizes.next(), sizes.next()) {
        (Some(only), None) => only.magnitude(),
        _ => Number::ONE,
    };
    let scale = k.dag.number(size);
    let unit = size.reciprocal();
    (k.dag.mul(scale, first), split.map(|(number, _)| k.dag.number(number.multiply(unit))))
}

fn in_triad(k: &mut Kinematics, vector: &Vector, triad: TriadId) -> Vector {
    let components = k.triads.express(&mut k.dag, vector, triad);
    Vector::new(&k.dag, triad, components)
}
