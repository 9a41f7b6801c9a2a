//! The sampled configurations: nominal, those that the model states, random ones.
//!
//! In: ranges of the coordinates. Out: configurations on the branch of the nominal one that satisfy the constraints.
//! Coordinates of unit length, such as Euler parameters, are drawn together.

use super::assemble::Assembly;
use super::quantities::Kinematics;
use super::random::Random;
use super::speed_map;
use super::unit_vectors::UnitVectors;
use super::unreachable::Unreachable;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::SymbolId;
use crate::model::{CoordinateId, Model};
use crate::source::Span;
use crate::vector::Algebra;

/// Random configurations sampled besides the nominal and the stated ones.
const RANDOM_SAMPLES: usize = 64;
/// Most halvings of the way from the nominal attitudes to drawn ones that cannot be reached.
const HALVINGS: usize = 6;
/// A residual of closed forms larger than this is not rounding but a contradiction.
const CONTRADICTION: f64 = 1e-9;

/// Adds the sampled configurations: nominal, those that the model states, random ones.
pub(super) fn derive(alg: &mut Algebra, model: &Model, k: Kinematics) -> Result<Kinematics, Diagnostics> {
    let k = closed_forms(alg, model, k)?;
    let mut assembly = Assembly::new(alg, model, &k);
    let state: Vec<CoordinateId> =
        model.coordinates.ids().filter(|&c| k.coordinate_symbol(&alg.dag, c).is_some()).collect();
    let mut nominal: Vec<f64> = state.iter().map(|&c| model.coordinates[c].nominal).collect();
    match assembly.search(&nominal) {
        Ok(found) => nominal = found,
        Err(unreachable) => return Err(nominal_unreachable(model, &unreachable)),
    }
    let mut samples = vec![nominal.clone()];
    let mut times = vec![0.0];
    for configuration in &model.configurations {
        let mut target = nominal.clone();
        let mut given = Vec::new();
        for (coordinate, value) in &configuration.values {
            if let Some(i) = state.iter().position(|c| c == coordinate) {
                target[i] = *value;
                given.push(i);
            }
        }
        assembly.to_unit_length(&mut target, |i| given.contains(&i));
        samples.extend(assembly.continue_to(&nominal, &target));
    }
    times.resize(samples.len(), 0.0);
    let symbols: Vec<SymbolId> = state.iter().filter_map(|&c| k.coordinate_symbol(&alg.dag, c)).collect();
    let ranges = state.iter().map(|&c| (model.coordinates[c].independent, model.coordinates[c].range));
    let mut draw = Draw {
        random: Random(0x5EED_0F5A_3B1E),
        ranges: ranges.collect(),
        unit_vectors: UnitVectors::find(&alg.dag, &k.residuals, &symbols),
    };
    // A target outside the reachable range is rejected and drawn again, a bounded number of times.
    let wanted = samples.len() + RANDOM_SAMPLES;
    for _ in 0..4 * RANDOM_SAMPLES {
        if samples.len() == wanted {
            break;
        }
        let t =
            if k.unknowns.clock().is_some() { draw.random.between((0.0, model.run.seconds)) } else { 0.0 };
        let Ok(nominal) = at_time(&mut assembly, &nominal, t) else { continue };
        if let Some(q) = draw.configuration(&mut assembly, &nominal) {
            samples.push(q);
            times.push(t);
        }
    }
    Ok(Kinematics { samples, sample_times: times, ..k })
}

/// Draws configurations.
struct Draw {
    random: Random,
    /// By coordinate: whether it is independent, and its range.
    ranges: Vec<(bool, (f64, f64))>,
    unit_vectors: UnitVectors,
}

impl Draw {
    /// A random configuration on the branch of the nominal one; `None` if what was drawn cannot be reached.
    fn configuration(&mut self, assembly: &mut Assembly, nominal: &[f64]) -> Option<Vec<f64>> {
        let mut target = nominal.to_vec();
        for (place, &(is_independent, range)) in self.ranges.iter().enumerate() {
            if is_independent {
                target[place] = self.random.between(range);
            }
        }
        self.unit_vectors.draw(&mut self.random, &self.ranges, nominal, &mut target);
        let halvings = if self.unit_vectors.is_empty() { 0 } else { HALVINGS };
        for _ in 0..=halvings {
            if let Ok(q) = assembly.continue_to(nominal, &target)
                && self.contains(&q)
            {
                return Some(q);
            }
            self.unit_vectors.halve(&self.ranges, nominal, &mut target);
        }
        None
    }

    /// Are the coordinates that were not drawn by themselves within their ranges?
    fn contains(&self, q: &[f64]) -> bool {
        self.ranges.iter().zip(q).enumerate().all(|(place, (&(is_independent, (low, high)), value))| {
            (is_independent && !self.unit_vectors.contain(place)) || (low..=high).contains(value)
        })
    }
}

/// The nominal configuration continued to another time.
fn at_time(assembly: &mut Assembly, nominal: &[f64], t: f64) -> Result<Vec<f64>, Unreachable> {
    assembly.set_time(0.0);
    if t == 0.0 { Ok(nominal.to_vec()) } else { assembly.continue_in_time(nominal, t) }
}

/// Substitutes closed forms into the residuals. Residuals that then hold no other dependent coordinate are dropped:
/// they must hold by the closed forms alone, which is checked.
///
/// # Errors
/// If the closed forms violate such a residual.
fn closed_forms(alg: &mut Algebra, model: &Model, mut k: Kinematics) -> Result<Kinematics, Diagnostics> {
    if k.closed_forms.is_empty() || k.residuals.is_empty() {
        return Ok(k);
    }
    let forms = k.closed_form_values(&mut alg.dag);
    let residuals = alg.dag.substitute(&k.residuals, &forms);
    let mut table = speed_map::screening_table(alg, model, &k);
    let free: Vec<SymbolId> = (model.coordinates.enumerate())
        .filter(|(_, c)| !c.independent)
        .filter_map(|(id, _)| k.coordinate_symbol(&alg.dag, id))
        .collect();
    let mut found = Diagnostics::new(model.source.clone());
    let mut kept = Vec::new();
    for (residual, place) in residuals.into_iter().zip(std::mem::take(&mut k.residual_names)) {
        if alg.dag.symbols_of(residual).iter().any(|symbol| free.contains(symbol)) {
            kept.push((residual, place));
            continue;
        }
        // Outside the reachable range a closed form may be NaN.
        let values = table.values(&alg.dag, residual).iter().filter(|r| r.is_finite());
        let worst = values.fold(0.0_f64, |worst, r| worst.max(r.abs()));
        if CONTRADICTION < worst {
            found.push(
                Diagnostic::error(format!("the closed forms contradict `{}`", place.name))
                    .label(
                        place.span,
                        format!("off by up to {worst:.1e} within the ranges of the coordinates"),
                    )
                    .help("correct the closed forms of the coordinates that occur here, or the constraint"),
            );
        }
    }
    (k.residuals, k.residual_names) = kept.into_iter().unzip();
    found.finish(k)
}

fn nominal_unreachable(model: &Model, unreachable: &Unreachable) -> Diagnostics {
    let worst = unreachable.constraint.as_deref();
    let mut error = Diagnostic::error("the nominal configuration cannot be assembled").help(format!(
        "give nominal values nearer to a configuration that satisfies every constraint (nearest found: {unreachable})"
    ));
    let mut places: Vec<(bool, Span, &str)> = Vec::new();
    for constraint in &model.configuration_constraints {
        let is_worst = worst == Some(constraint.name.as_str());
        places.push((is_worst, constraint.span, "this constraint, among others, must hold there"));
    }
    for point in model.points.iter().filter(|p| !p.closures.is_empty()) {
        let is_worst = worst.is_some_and(|name| name.split(" closure").next() == Some(point.name.as_str()));
        places.push((is_worst, point.span, "this loop must close there"));
    }
    places.sort_by_key(|(is_worst, ..)| !is_worst);
    for (_, span, text) in places {
        error = error.label(span, text);
    }
    Diagnostics { source: model.source.clone(), items: vec![error] }
}
