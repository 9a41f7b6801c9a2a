//! Checks that need numbers: frames that are not orthonormal, constraints that are redundant or singular.
//!
//! An equation whose gradient depends linearly on those of the others is redundant if it stays satisfied after a finite
//! move along them; it is then dropped with a warning. If it does not stay satisfied, the formulation is singular: to
//! first order the mechanism can move in a way that the equation forbids, so no speed can be solved from it. Such a
//! model is refused.

use super::linear;
use super::quantities::{Kinematics, Place};
use super::random::spread;
use super::rank;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::rounding::Rounded;
use crate::expr::tape::{SampleTable, Tape};
use crate::expr::{ExprId, SymbolId};
use crate::id::Id;
use crate::model::Model;
use crate::source::Span;
use crate::vector::{Algebra, Turn};
use crate::words::count;
use smartbed_runtime::real::Real;

/// A row counts as dependent if at most this share of its length is left after projection on the others.
const DEPENDENT: f64 = 1e-5;
/// Length of the finite move, in the coordinates' SI units.
const MOVE: f64 = 0.1;
/// A move that turns out too long is shortened by this factor, up to this many times.
const SHORTER: (f64, usize) = (0.1, 3);
/// A redundant equation has at most this residual after the move, relative to its terms.
const STAYS: f64 = 1e-10;
/// After the move the other equations are solved to this residual, relative to their terms.
const SATISFIED: f64 = 1e-12;
/// Most corrections after a move.
const MAX_CORRECTIONS: usize = 40;
/// A deviation from a stated constancy or from orthonormality above this is not rounding.
const NOT_CONSTANT: f64 = 1e-9;

/// Checks the frames and the configuration constraints; returns the kinematics without redundant equations, and
/// warnings.
///
/// # Errors
/// A frame whose axes are not orthonormal, a fixed vector that is not fixed, or singular constraints.
pub(crate) fn check(
    alg: &mut Algebra,
    model: &Model,
    k: Kinematics,
    table: &mut SampleTable,
) -> Result<(Kinematics, Diagnostics), Diagnostics> {
    let mut found = Diagnostics::new(model.source.clone());
    fixed_vectors(alg, &k, table, &mut found);
    axes(alg, model, &k, table, &mut found);
    let mut warnings = found.finish(Diagnostics::new(model.source.clone()))?;
    let k = match independent(alg, model, &k, &mut warnings)? {
        Some(kept) => only(k, &kept),
        None => k,
    };
    let implied_motions = rank::implied_motions(alg, model, &k, table);
    let k = Kinematics { implied_motions, ..k };
    for (place, whole) in rank::needless_motions(alg, model, &k, table) {
        let holds = "at every sampled configuration it holds where the others do".to_owned();
        warnings.push(dropped(&place, whole, holds));
    }
    Ok((k, warnings))
}

/// Largest absolute value over all samples.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| if v.is_nan() { f64::INFINITY } else { v.abs().max(m) })
}

fn fixed_vectors(alg: &Algebra, k: &Kinematics, table: &mut SampleTable, found: &mut Diagnostics) {
    for (place, difference) in &k.fixed_vectors {
        let worst = difference.iter().map(|&e| largest(table.values(&alg.dag, e))).fold(0.0, f64::max);
        if NOT_CONSTANT < worst {
            let message = format!("`{}` is not fixed in its frame", place.name);
            found.push(
                Diagnostic::error(message)
                    .label(place.span, format!("the vector differs from its stated components by up to {worst:.1e}"))
                    .help("`fixed` states what the constraints imply, at every configuration: correct the components, or remove it"),
            );
        }
    }
}

/// Checks that axes given as directions are orthonormal wherever the constraints hold.
fn axes(alg: &mut Algebra, model: &Model, k: &Kinematics, table: &mut SampleTable, found: &mut Diagnostics) {
    for (id, frame) in model.frames.enumerate() {
        let Turn::Directions { rows, .. } = alg.triads.turn(k.frame_triad[id]).clone() else { continue };
        let rows = rows.map(|row| row.map(|e| table.values(&alg.dag, e).to_vec()));
        let product =
            |i: usize, j: usize, s: usize| -> f64 { (0..3).map(|c| rows[i][c][s] * rows[j][c][s]).sum() };
        let deviations: Vec<f64> = (0..table.points())
            .flat_map(|s| (0..9).map(move |ij| (ij / 3, ij % 3, s)))
            .map(|(i, j, s)| product(i, j, s) - f64::from(u8::from(i == j)))
            .collect();
        let worst = largest(&deviations);
        if NOT_CONSTANT < worst {
            found.push(
                Diagnostic::error(format!("the axes of frame `{}` are not orthonormal", frame.name))
                    .label(frame.span, format!("a product of two axes is off by up to {worst:.1e}"))
                    .help("give unit vectors at right angles: divide by the norm, take a cross product"),
            );
        }
    }
}

/// The components of axes that are orthonormal at the model's numbers only, not at any others.
pub(crate) fn axes_by_numbers(alg: &Algebra, model: &Model, k: &Kinematics) -> Vec<ExprId> {
    /// Products that differ by less than this from those of unit vectors are those of unit vectors.
    const IDENTICAL: f64 = 1e-9;
    let mut found = Vec::new();
    for frame in model.frames.ids() {
        let Turn::Directions { rows, .. } = alg.triads.turn(k.frame_triad[frame]).clone() else { continue };
        let all: Vec<ExprId> = rows.iter().flatten().copied().collect();
        let values: Vec<f64> = alg.dag.evaluate(&all, &elsewhere);
        let dot = |i: usize, j: usize| -> f64 { (0..3).map(|c| values[3 * i + c] * values[3 * j + c]).sum() };
        let off = |(i, j): (usize, usize)| (dot(i, j) - f64::from(u8::from(i == j))).abs();
        let orthonormal = (0..9).all(|ij| off((ij / 3, ij % 3)) < IDENTICAL);
        if !orthonormal {
            found.extend(all);
        }
    }
    found
}

/// A number between 1/2 and 3/2 for every symbol, unlike those of the others.
fn elsewhere(symbol: SymbolId) -> f64 {
    spread(symbol.index())
}

/// Residuals and their derivatives with respect to all coordinates, as numbers. Both are divided by the size of the
/// residual's terms, so that multiplying an equation changes nothing, and derivatives within rounding error are 0.
struct Equations {
    tape: Tape<Rounded>,
    arguments: Vec<Rounded>,
    /// Size of the terms of each residual at the nominal configuration.
    sizes: Vec<f64>,
    /// Rounding errors of the coordinates.
    errors: Vec<f64>,
    /// Independent coordinates whose range is a single value: a move leaves them there.
    locked: Vec<usize>,
    /// Number of equations and of coordinates.
    size: (usize, usize),
}

impl Equations {
    fn new(alg: &Algebra, model: &Model, k: &Kinematics) -> Self {
        // A copy, so that derivatives needed for numbers alone leave no nodes in the program's DAG.
        let mut dag = alg.dag.clone();
        let declared = k.q.ids().map(|c| (c, &model.coordinates[c]));
        let state: Vec<_> =
            declared.filter_map(|(id, c)| Some((k.coordinate_symbol(&alg.dag, id)?, c))).collect();
        let is_locked = |&i: &usize| state[i].1.independent && state[i].1.range.0 == state[i].1.range.1;
        let locked = (0..state.len()).filter(is_locked).collect();
        // In a driven mechanism time counts as a coordinate: a constraint may follow from the others at one time only.
        let time = alg
            .dag
            .as_symbol(k.time)
            .filter(|_| k.unknowns.clock().is_some())
            .map(|t| (t, (0.0, model.run.seconds)));
        let state = state.into_iter().map(|(symbol, coordinate)| (symbol, coordinate.range));
        let (mut symbols, ranges): (Vec<SymbolId>, Vec<(f64, f64)>) = state.chain(time).unzip();
        let errors = ranges.iter().map(|(low, high)| f64::EPSILON * low.abs().max(high.abs())).collect();
        let mut roots = k.residuals.clone();
        for &residual in &k.residuals {
            roots.extend(symbols.iter().map(|&s| dag.derivative(residual, s)));
        }
        let size = (k.residuals.len(), symbols.len());
        let mut arguments = vec![Rounded::ZERO; symbols.len()];
        for (id, &expr) in k.parameters.enumerate() {
            if let Some(symbol) = alg.dag.as_symbol(expr) {
                symbols.push(symbol);
                arguments.push(Rounded::from_f64(k.parameter_values[id]));
            }
        }
        let tape = Tape::new(&dag, &roots, &symbols);
        let mut equations = Self { tape, arguments, sizes: Vec::new(), errors, locked, size };
        equations.sizes = equations.run(&sample(k, 0))[..size.0].iter().map(|x| x.size()).collect();
        equations
    }

    /// Residuals, then their derivatives row by row, not yet scaled.
    fn run(&mut self, q: &[f64]) -> Vec<Rounded> {
        let (m, n) = self.size;
        for ((argument, &q), &error) in self.arguments.iter_mut().zip(q).zip(&self.errors) {
            *argument = Rounded::new(q, error);
        }
        let mut values = vec![Rounded::ZERO; m * (n + 1)];
        self.tape.run(&self.arguments, &mut values);
        values
    }

    /// Scaled residuals, and one row of scaled derivatives for each.
    fn at(&mut self, q: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        let (m, n) = self.size;
        let values = self.run(q);
        let (residuals, slopes) = values.split_at(m);
        let residuals = residuals.iter().zip(&self.sizes).map(|(r, size)| r.value / size).collect();
        let row = |i: usize| slopes[i * n..(i + 1) * n].iter().map(|x| x.cleaned() / self.sizes[i]).collect();
        (residuals, (0..m).map(row).collect())
    }

    /// Moves from `q` along `direction` and back onto the equations `kept`, with shorter moves if that fails; `None` if
    /// all fail.
    fn walk(&mut self, q: &[f64], direction: &[f64], kept: &[usize]) -> Option<Vec<f64>> {
        let (shorter, times) = SHORTER;
        let mut lengths = std::iter::successors(Some(MOVE), |length| Some(length * shorter)).take(1 + times);
        lengths.find_map(|length| self.walk_by(length, q, direction, kept))
    }

    /// Moves by `length` from `q` along `direction`, then back onto the equations `kept` by Newton's method.
    fn walk_by(&mut self, length: f64, q: &[f64], direction: &[f64], kept: &[usize]) -> Option<Vec<f64>> {
        let mut at: Vec<f64> = q.iter().zip(direction).map(|(q, d)| q + length * d).collect();
        for _ in 0..MAX_CORRECTIONS {
            let (residuals, mut rows) = self.at(&at);
            rows.iter_mut().for_each(|row| self.locked.iter().for_each(|&i| row[i] = 0.0));
            let kept_residuals: Vec<f64> = kept.iter().map(|&i| residuals[i]).collect();
            if largest(&kept_residuals) < SATISFIED {
                return Some(at);
            }
            // The correction of least norm: J' y with J J' y = -residual.
            let gram: Vec<f64> = kept
                .iter()
                .flat_map(|&i| kept.iter().map(|&j| dot(&rows[i], &rows[j])).collect::<Vec<_>>())
                .collect();
            let mut right: Vec<f64> = kept_residuals.iter().map(|r| -r).collect();
            let (y, _) = linear::solve(&gram, &mut right, kept.len());
            for (&i, y) in kept.iter().zip(&y) {
                at.iter_mut().zip(&rows[i]).for_each(|(q, j)| *q += y * j);
            }
        }
        None
    }
}

/// Coordinates of a sample, followed by its time if the mechanism is driven.
fn sample(k: &Kinematics, index: usize) -> Vec<f64> {
    k.samples[index].iter().copied().chain(k.unknowns.clock().map(|_| k.sample_times[index])).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// An orthonormal basis of the rows, and the indices of rows that depend on earlier ones.
fn basis_of(rows: &[Vec<f64>]) -> (Vec<Vec<f64>>, Vec<usize>) {
    let (mut basis, mut dependent): (Vec<Vec<f64>>, _) = (Vec::new(), Vec::new());
    for (i, row) in rows.iter().enumerate() {
        let length = dot(row, row).sqrt();
        let mut rest = row.clone();
        for _ in 0..2 {
            for b in &basis {
                let part = dot(&rest, b);
                rest.iter_mut().zip(b).for_each(|(x, y)| *x -= part * y);
            }
        }
        let left = dot(&rest, &rest).sqrt();
        if left <= DEPENDENT * length {
            dependent.push(i);
        } else {
            basis.push(rest.iter().map(|x| x / left).collect());
        }
    }
    (basis, dependent)
}

/// The direction of coordinate `i` among `n`.
fn axis(i: usize, n: usize) -> Vec<f64> {
    (0..n).map(|j| f64::from(u8::from(i == j))).collect()
}

/// An orthonormal basis of the directions orthogonal to all rows.
fn free_directions(rows: &[Vec<f64>], n: usize) -> Vec<Vec<f64>> {
    let all: Vec<Vec<f64>> = rows.iter().cloned().chain((0..n).map(|i| axis(i, n))).collect();
    let (basis, _) = basis_of(&all);
    let rank = basis_of(rows).0.len();
    basis.into_iter().skip(rank).collect()
}

/// Indices of the equations that do not follow from others, with a warning for each redundant one; singular ones are
/// errors. `None` if there are no equations or no coordinates.
fn independent(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    warnings: &mut Diagnostics,
) -> Result<Option<Vec<usize>>, Diagnostics> {
    if k.residuals.is_empty() || k.samples[0].is_empty() {
        return Ok(None);
    }
    let mut equations = Equations::new(alg, model, k);
    let nominal = sample(k, 0);
    let (_, rows) = equations.at(&nominal);
    let (_, suspects) = basis_of(&rows);
    let mut kept: Vec<usize> = (0..rows.len()).collect();
    let mut errors = Diagnostics::new(model.source.clone());
    for &suspect in &suspects {
        let mut without = |row: usize| {
            let others: Vec<usize> = kept.iter().copied().filter(|&i| i != row).collect();
            (after_moves(&mut equations, &nominal, &others, row), others, row)
        };
        // If the others have two branches close together, another equation of the dependent set may be the redundant
        // one.
        let first = without(suspect);
        let residual = first.0;
        let found = (residual < STAYS).then_some(first).or_else(|| {
            let involved = involved(&rows, &suspects, suspect);
            involved.into_iter().map(without).find(|(residual, ..)| *residual < STAYS)
        });
        match found {
            Some((residual, others, row)) => {
                kept = others;
                warnings.push(redundant(k, &kept, row, residual));
            }
            None => {
                let residual = residual * equations.sizes[suspect];
                errors.push(singular(k, &mut equations, suspect, residual));
            }
        }
    }
    errors.finish(Some(kept))
}

fn redundant(k: &Kinematics, kept: &[usize], suspect: usize, residual: f64) -> Diagnostic {
    let place = &k.residual_names[suspect];
    let whole = kept.iter().all(|&i| k.residual_names[i].name != place.name);
    let stays = format!(
        "still satisfied (to {residual:.0e} of its terms) after a displacement of {MOVE} that the other constraints \
         allow"
    );
    dropped(place, whole, stays)
}

/// The warning for a constraint, or a component of one, that follows from the others; `why` says how that was found.
fn dropped(place: &Place, whole: bool, why: String) -> Diagnostic {
    let (what, help) = match whole {
        true => ("", "remove it: the others imply it"),
        false => (
            "a component of ",
            "the result is the same at these parameters; to state only the independent components, write dot(vector, axis) = 0 for each \
             of them",
        ),
    };
    Diagnostic::warning(format!("{what}`{}` follows from the other constraints and is dropped", place.name))
        .label(place.span, why)
        .help(help)
}

/// Largest residual of one equation after finite moves along every direction that the others leave free; infinite if
/// there are such directions and no move succeeds.
fn after_moves(equations: &mut Equations, q: &[f64], others: &[usize], suspect: usize) -> f64 {
    let (_, rows) = equations.at(q);
    let held = equations.locked.iter().map(|&i| axis(i, q.len()));
    let held: Vec<Vec<f64>> = others.iter().map(|&i| rows[i].clone()).chain(held).collect();
    let directions = free_directions(&held, q.len());
    let ends: Vec<Vec<f64>> = directions.iter().filter_map(|d| equations.walk(q, d, others)).collect();
    if ends.is_empty() && !directions.is_empty() {
        return f64::INFINITY;
    }
    ends.iter().map(|end| largest(&equations.at(end).0[suspect..=suspect])).fold(0.0, f64::max)
}

/// Keeps the residuals `kept`. The others become implied ones, which are watched but not solved; rows of equations that
/// are dropped as a whole become spare rows.
fn only(mut k: Kinematics, kept: &[usize]) -> Kinematics {
    let names: Vec<&str> = kept.iter().map(|&i| k.residual_names[i].name.as_str()).collect();
    let dropped: Vec<String> = (k.residual_names.iter().map(|p| p.name.clone()))
        .filter(|name| !names.contains(&name.as_str()))
        .collect();
    let (spare, rows) = std::mem::take(&mut k.rows).into_iter().partition(|row| dropped.contains(&row.name));
    (k.rows, k.spare_rows) = (rows, spare);
    let all = std::mem::take(&mut k.residuals).into_iter().zip(std::mem::take(&mut k.residual_names));
    for (i, (residual, name)) in all.enumerate() {
        let (residuals, names) = match kept.contains(&i) {
            true => (&mut k.residuals, &mut k.residual_names),
            false => (&mut k.implied, &mut k.implied_names),
        };
        residuals.push(residual);
        names.push(name);
    }
    k
}

fn singular(k: &Kinematics, equations: &mut Equations, suspect: usize, residual: f64) -> Diagnostic {
    let is_deficient = |q: &Vec<f64>, equations: &mut Equations| !basis_of(&equations.at(q).1).1.is_empty();
    let deficient = (0..k.samples.len()).filter(|&s| is_deficient(&sample(k, s), equations)).count();
    let (_, rows) = equations.at(&sample(k, 0));
    let (basis, dependent) = basis_of(&rows);
    let involved = involved(&rows, &dependent, suspect);
    let mut places: Vec<(&str, Span)> =
        vec![(&k.residual_names[suspect].name, k.residual_names[suspect].span)];
    for i in involved {
        let place = &k.residual_names[i];
        if places.iter().all(|(name, _)| *name != place.name) {
            places.push((&place.name, place.span));
        }
    }
    let names: Vec<String> = places.iter().map(|(name, _)| format!("`{name}`")).collect();
    let mut error = Diagnostic::error(format!(
        "the constraints are singular: rank {} of {} at {deficient} of {}; involved: {}",
        basis.len(),
        rows.len(),
        count(k.samples.len(), "sampled configuration"),
        names.join(", ")
    ))
    .help(
        "the rate of a constraint vanishes or follows from the other constraints, although the constraint itself \
         does not, so that no speed can be solved from it. State it in another form (unit vectors at mutual angles \
         of 120 degrees, for example: their sum is zero), or, if the mechanism is singular only there, give another \
         nominal configuration",
    );
    for (i, (_, span)) in places.iter().enumerate() {
        let text = match i {
            0 if residual.is_infinite() => "the other constraints allow no motion".to_owned(),
            0 => format!(
                "violated by {residual:.1e} after a displacement of {MOVE} that the other constraints allow"
            ),
            _ => "involved".to_owned(),
        };
        error = error.label(*span, text);
    }
    error
}

/// The equations whose gradients combine linearly to that of `suspect`.
fn involved(rows: &[Vec<f64>], dependent: &[usize], suspect: usize) -> Vec<usize> {
    /// Smaller weights are rounding.
    const WEIGHT: f64 = 1e-6;
    let others: Vec<usize> = (0..rows.len()).filter(|i| !dependent.contains(i)).collect();
    let columns = others.len();
    let columns_of = |c: usize| others.iter().map(move |&i| rows[i][c]);
    let matrix: Vec<f64> = (0..rows[suspect].len()).flat_map(columns_of).collect();
    let (weights, _) = linear::solve(&matrix, &mut rows[suspect].clone(), columns);
    others.into_iter().zip(weights).filter(|(_, w)| WEIGHT < w.abs()).map(|(i, _)| i).collect()
}
