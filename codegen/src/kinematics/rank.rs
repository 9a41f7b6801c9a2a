//! Counts degrees of freedom by the rank of all constraint rows, and words the errors that follow from it.
//!
//! Degrees of freedom = number of speeds and lifted unknowns - rank of the rows over all of them, at each sample.

use super::basis::{Bases, NumericRow, longest_entry};
use super::quantities::{Kinematics, Place, Row};
use super::random::spread;
use super::sampling;
use super::unknowns::UnknownId;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::tape::SampleTable;
use crate::model::{Model, Speed, SpeedMeaning};
use crate::vector::Algebra;
use crate::words::count;
use rustc_hash::FxHashMap as HashMap;

/// A row counts as dependent if at most this share of its length is left after projection on the others.
const DEPENDENT: f64 = 1e-8;

/// Rank of rows over the given unknowns, at every sample.
pub(super) fn ranks(
    alg: &Algebra,
    table: &mut SampleTable,
    rows: &[Row],
    unknowns: &[UnknownId],
) -> Vec<usize> {
    let column: HashMap<UnknownId, usize> = unknowns.iter().enumerate().map(|(i, &u)| (u, i)).collect();
    let mut bases = Bases::new(unknowns.len(), longest_entry(&alg.dag, rows, table), table.points());
    for row in rows {
        let row = NumericRow::new(&alg.dag, table, row, &column);
        bases.extend_where_independent(&alg.dag, &row, DEPENDENT);
    }
    bases.ranks().to_vec()
}

/// The motion constraints that follow from the configuration constraints and the motion constraints before them, at
/// every sample: their names, and whether they follow as a whole or in a component only.
///
/// A component of a vector that is 0 whatever the speeds are is no equation. One that is the rate of configuration
/// constraints whatever the parameters are, as rolling has where a wheel is kept on the ground, is needed for the vector
/// to be written. Rates of closed forms are not among the others: a constraint that says the same takes their place.
pub(super) fn implied_motions(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
) -> Vec<(Place, bool)> {
    let mut implied = dependent_motions(alg, model, k, table, None);
    if implied.iter().any(|(_, whole)| !whole) {
        let mut other = at_other_parameters(alg, model, k);
        let rates = dependent_motions(alg, model, k, &mut other, Some(&implied));
        implied.retain(|found| found.1 || !rates.contains(found));
    }
    implied
}

/// Those of them that are worth a warning: not what the configuration constraints say already, beside closed forms that
/// solve these, as it is stated for its shorter row.
pub(super) fn needless_motions(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
) -> Vec<(Place, bool)> {
    let mut needless = k.implied_motions.clone();
    if !needless.is_empty() && model.coordinates.iter().any(|c| c.closed_form.is_some()) {
        let restated = dependent_motions(alg, model, k, table, Some(&needless));
        needless.retain(|found| !restated.contains(found));
    }
    needless
}

/// [`implied_motions`] by numbers. Of some of them: those that follow from the configuration constraints alone.
fn dependent_motions(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    some: Option<&[(Place, bool)]>,
) -> Vec<(Place, bool)> {
    if model.motion_constraints.is_empty() {
        return Vec::new();
    }
    let unknowns: Vec<UnknownId> = k.unknowns.moving().into_iter().chain(k.unknowns.clock()).collect();
    let column: HashMap<UnknownId, usize> = unknowns.iter().enumerate().map(|(i, &u)| (u, i)).collect();
    let longest = longest_entry(&alg.dag, &k.rows, table);
    let empty = Bases::new(unknowns.len(), longest, table.points());
    let mut add = |bases: &mut Bases, row: &Row| {
        let row = NumericRow::new(&alg.dag, table, row, &column);
        bases.extend_where_independent(&alg.dag, &row, DEPENDENT);
    };
    let is_other = |row: &&Row| {
        let is_motion = model.motion_constraints.iter().any(|c| c.name == row.name);
        !is_motion && !is_rate_of_closed_form(model, k, row)
    };
    let mut others = empty.clone();
    k.rows.iter().filter(is_other).for_each(|row| add(&mut others, row));
    let mut implied = Vec::new();
    let asked = |name: &str| some.is_none_or(|some| some.iter().any(|(place, _)| place.name == name));
    for constraint in model.motion_constraints.iter().filter(|constraint| asked(&constraint.name)) {
        let rows: Vec<&Row> = k.rows.iter().filter(|row| row.name == constraint.name).collect();
        // A vector is written along the axes of several triads: three of them, if independent, say all of it.
        let most = if rows.iter().any(|row| row.along.is_some()) { 3 } else { 1 };
        let mut ranks_with = |before: &Bases| {
            let mut bases = before.clone();
            let gained = |now: &Bases| -> Vec<usize> {
                now.ranks().iter().zip(before.ranks()).map(|(now, before)| now - before).collect()
            };
            for row in &rows {
                if gained(&bases).iter().all(|&gained| gained == most) {
                    break;
                }
                add(&mut bases, row);
            }
            (gained(&bases), bases)
        };
        let (added, bases) = ranks_with(&others);
        let falls_short = |of: &[usize]| added.iter().zip(of).all(|(added, own)| added < own);
        if added.iter().all(|&added| added < most) && falls_short(&ranks_with(&empty).0) {
            let place = Place { name: constraint.name.clone(), span: constraint.span };
            implied.push((place, added.iter().all(|&added| added == 0)));
        }
        if some.is_none() {
            others = bases;
        }
    }
    implied
}

/// Values at a few of the configurations with every tunable parameter changed, each by another share.
fn at_other_parameters(alg: &Algebra, model: &Model, k: &Kinematics) -> SampleTable {
    /// Ranks at parameters of no particular values need few.
    const CONFIGURATIONS: usize = 2;
    let mut values = k.parameter_values.clone();
    for (nth, (id, &expr)) in k.parameters.enumerate().enumerate() {
        let value = values[id];
        let size = if value == 0.0 { 1.0 } else { value };
        if alg.dag.as_symbol(expr).is_some() {
            values[id] = value + 0.1 * size * spread(nth);
        }
    }
    let mut samples = k.sampled();
    samples.truncate(CONFIGURATIONS);
    sampling::table_with(alg, model, k, &samples, &values)
}

/// Does the row say what the speed of a coordinate in closed form is?
fn is_rate_of_closed_form(model: &Model, k: &Kinematics, row: &Row) -> bool {
    let of = |s: &Speed| matches!(s.meaning, SpeedMeaning::RateOf(c) if !k.is_state[c]);
    model.speeds.iter().any(|s| s.name == row.name && of(s))
}

/// Do the rows determine every dependent unknown, at every sample?
pub(super) fn determined(alg: &Algebra, model: &Model, k: &Kinematics) -> bool {
    let mut table = sampling::sample_table(alg, model, k);
    determine(alg, &mut table, &k.rows, &k.unknowns.dependent())
}

/// Do these rows determine these unknowns, at every sample?
pub(super) fn determine(alg: &Algebra, table: &mut SampleTable, rows: &[Row], unknown: &[UnknownId]) -> bool {
    ranks(alg, table, rows, unknown).iter().all(|&rank| rank == unknown.len())
}

/// Degrees of freedom at the nominal configuration.
pub(crate) fn freedom(alg: &Algebra, k: &Kinematics, table: &mut SampleTable) -> usize {
    let all = k.unknowns.moving();
    all.len() - ranks(alg, table, &k.rows, &all).first().copied().unwrap_or(0)
}

/// The reason why the dependent unknowns cannot be solved for, or why the row named `extra` is one too many.
pub(super) fn explain(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    extra: Option<&str>,
) -> Diagnostics {
    let (all, dependent) = (k.unknowns.moving(), k.unknowns.dependent());
    let declared = all.len() - dependent.len();
    let dof = freedom(alg, k, table);
    let error = if dof != declared {
        wrong_dof(model, dof, declared, all.len(), extra)
    } else {
        let found = ranks(alg, table, &k.rows, &dependent);
        dead_point(alg, model, k, &found, dependent.len())
    };
    Diagnostics::one(model.source.clone(), error)
}

/// The error for a constraint that follows from the others except for its part without speeds.
pub(super) fn contradiction(model: &Model, name: &str) -> Diagnostics {
    let error = Diagnostic::error(format!("`{name}` prescribes a motion that the other constraints do not allow"))
        .help(
            "constraints that depend on time, or have a part without speeds, must not contradict one another, and \
             some coordinate must be free to follow them: correct this constraint, or remove one of them",
        );
    Diagnostics::one(model.source.clone(), label_constraints(model, error))
}

fn wrong_dof(model: &Model, dof: usize, declared: usize, unknowns: usize, extra: Option<&str>) -> Diagnostic {
    let message = format!(
        "the mechanism has {} of freedom, but {} ({} less constraints of rank {})",
        count(dof, "degree"),
        count(declared, "independent speed"),
        count(unknowns, "unknown speed"),
        unknowns - dof
    );
    let mut error = match extra {
        Some(name) if dof < declared => Diagnostic::error(format!("{message}: `{name}` makes them dependent"))
            .help(match model.motion_constraints.is_empty() {
                true => "declare fewer coordinates `independent`, or remove the constraint",
                false => "say which speeds the constraints give: `speed = { independent = false }` at the coordinate, or `independent = false` in [speeds]; or remove the constraint",
            }),
        _ => Diagnostic::error(message)
            .help("either a constraint is missing: state it; or more may move freely: mark more coordinates `independent = true`"),
    };
    if let Some((_, span)) = model.dof {
        error = error.label(span, "stated");
    }
    for speed in model.speeds.iter().filter(|s| s.independent) {
        error = error.label(speed.span, "declared independent");
    }
    label_constraints(model, error)
}

/// The error for independent speeds that do not determine the others although their number is right.
fn dead_point(alg: &Algebra, model: &Model, k: &Kinematics, found: &[usize], needed: usize) -> Diagnostic {
    let bad: Vec<usize> = (0..found.len()).filter(|&s| found[s] < needed).collect();
    let states = model.coordinates.ids().filter(|&c| k.coordinate_symbol(&alg.dag, c).is_some());
    let names: Vec<&str> = states.map(|c| model.coordinates[c].name.as_str()).collect();
    let (rank, place) = match bad.first() {
        Some(&s) => {
            let values: Vec<String> =
                names.iter().zip(&k.samples[s]).map(|(n, q)| format!("{n} = {q:.4}")).collect();
            (
                found[s],
                format!(
                    "at {} of {}, first at {}",
                    bad.len(),
                    count(found.len(), "sampled configuration"),
                    values.join(", ")
                ),
            )
        }
        None => (needed, "they nearly depend on each other at a sampled configuration".to_owned()),
    };
    let mut error = Diagnostic::error(format!(
        "the independent speeds do not determine the others: rank {rank} of {needed} needed; {place}"
    ))
    .help("a dead point of these independent coordinates: choose others, or keep it out of `range`, `nominal` and the configurations");
    for speed in model.speeds.iter().filter(|s| s.independent) {
        error = error.label(speed.span, "declared independent");
    }
    label_constraints(model, error)
}

fn label_constraints(model: &Model, mut error: Diagnostic) -> Diagnostic {
    for constraint in model.configuration_constraints.iter().chain(&model.motion_constraints) {
        error = error.label(constraint.span, "one of the constraints");
    }
    for point in model.points.iter().filter(|p| !p.closures.is_empty()) {
        error = error.label(point.span, "a closed loop");
    }
    error
}
