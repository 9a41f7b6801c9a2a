//! Joint reactions: the force and the moment that a joint transmits to its outer side.
//!
//! In: a cut, `frame@point` or a point. Out: the components along the frame's axes (those of N without a frame), with
//! moments about the point. A component is determined if its release gives the mechanism one more degree of freedom; it
//! is then the force missing in Kane's equation of that speed (`model/release.rs`). If other joints hold that component
//! too, the equations of rigid bodies do not say how they share it: such components are named in the answer but not
//! computed.

use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::dynamics;
use crate::expr::cost::Optimise;
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, SymbolId};
use crate::kinematics::{self, Algebra, Kinematics, diagnose, eliminate, rank, sampling};
use crate::model::{COMPONENTS, Coordinate, CoordinateId, Cut, Model};
use rustc_hash::FxHashMap as HashMap;

const NAMES: [&str; COMPONENTS] = ["F_x", "F_y", "F_z", "M_x", "M_y", "M_z"];

pub(super) fn reaction(stages: &mut Stages, target: &Target) -> Result<Vec<Part>, Diagnostic> {
    let cut = cut_of(stages.model, target)?;
    let asked: Vec<usize> = (0..if cut.frame.is_some() { COMPONENTS } else { 3 }).collect();
    stages.model.released(cut, &asked)?;
    let underivable = |found: Diagnostics| underivable(target, &found);
    let mut determined = asked.clone();
    let mut released = Released::new(stages, cut, &asked).map_err(underivable)?;
    if !released.is_free() {
        determined.clear();
        for &component in &asked {
            if Released::new(stages, cut, &[component]).map_err(underivable)?.is_free() {
                determined.push(component);
            }
        }
        released = Released::new(stages, cut, &determined).map_err(underivable)?;
    }
    if determined.is_empty() {
        return Err(Diagnostic::error(format!("`{}`: no component is determined", target.request)).help(
            "other joints transmit every component as well: give some of them their real freedom, or ask for the \
             reaction there",
        ));
    }
    let forces = released.forces(stages).map_err(underivable)?;
    let name = |&component: &usize| NAMES[component].to_owned();
    let left: Vec<String> = asked.iter().filter(|c| !determined.contains(c)).map(name).collect();
    let axes = cut.frame.map_or("N", |frame| &stages.model.frames[frame].name);
    let mut doc = format!("on the outer side, along the axes of {axes}, moments about the point (N, N m)");
    if !left.is_empty() {
        doc += &format!("; other joints hold {} as well, which no equation determines", left.join(", "));
    }
    Ok(vec![Part::list("reaction", &doc, determined.iter().map(name).collect(), forces)])
}

/// The error for a released model whose equations cannot be derived, though those of the model itself can.
fn underivable(target: &Target, found: &Diagnostics) -> Diagnostic {
    let first = found.items.iter().find(|item| item.severity == Severity::Error);
    let why = first.map_or("", |item| &item.message);
    Diagnostic::error(format!("`{}`: with this joint released, {why}", target.request)).help(
        "the model itself can be derived: this is a limit of how reactions are; ask at a neighbouring joint",
    )
}

/// The cut named in the request.
fn cut_of(model: &Model, target: &Target) -> Result<Cut, Diagnostic> {
    let request = &target.request;
    let follows =
        |(id, c): &(CoordinateId, &Coordinate)| c.closed_form.is_some() && !model.is_prescribed(*id);
    if let Some((_, coordinate)) = model.coordinates.enumerate().find(follows) {
        return Err(Diagnostic::error(format!(
            "`{request}`: `{}` follows from other coordinates by its closed form, which does not hold once a joint \
             is released",
            coordinate.name
        ))
        .label(coordinate.span, "given in closed form")
        .help("use a model without closed forms, whose loops are closed by constraints"));
    }
    let marker = target.marker.and_then(|marker| Some((marker.point?, marker.frame)));
    marker.map(|(point, frame)| Cut { point, frame }).ok_or_else(|| {
        Diagnostic::error(format!("`{request}`: a reaction needs the joint's point"))
            .help("name it behind the frame on its outer side: `reaction:frame@point`")
    })
}

/// The model with components of a joint released, up to its constraints.
struct Released {
    model: Model,
    alg: Algebra,
    k: Kinematics,
    table: SampleTable,
    /// Number of released components.
    components: usize,
}

impl Released {
    fn new(stages: &Stages, cut: Cut, components: &[usize]) -> Result<Self, Diagnostics> {
        let model = stages.model.released(cut, components);
        let model = model.map_err(|error| Diagnostics::one(stages.model.source.clone(), error))?;
        let (mut alg, k) = kinematics::derive(&model, stages.choice, Optimise::default())?;
        let mut table = sampling::sample_table(&alg, &model, &k);
        let (k, _) = diagnose::check(&mut alg, &model, k, &mut table)?;
        Ok(Self { model, alg, k, table, components: components.len() })
    }

    /// Does every released component add a degree of freedom? If not, another joint holds it too.
    fn is_free(&mut self) -> bool {
        rank::freedom(&self.alg, &self.k, &mut self.table) == self.k.unknowns.independent().len()
    }

    /// The forces missing on the released components while these do not move, in the program's own expressions.
    fn forces(self, stages: &mut Stages) -> Result<Vec<ExprId>, Diagnostics> {
        let Self { model, mut alg, k, mut table, components } = self;
        let solution = eliminate::solve(&mut alg, &model, &k, &mut table)?;
        let zero = alg.dag.zero();
        let moving: Vec<ExprId> = stages.dynamics.u_dot.iter().map(|_| alg.dag.symbol("u_dot")).collect();
        let u_dot: Vec<ExprId> = moving.iter().copied().chain((0..components).map(|_| zero)).collect();
        let missing = dynamics::missing_forces(&mut alg, &model, &k, &solution, &u_dot);
        let forces = dynamics::on_independent(&mut alg, &k, &solution, missing);
        let values = dynamics::unknown_values(&mut alg, &model, &k, &solution);
        let lacking = alg.dag.substitute(&forces[moving.len()..], &values);
        let known = known(&alg, &k, stages, &moving);
        stages.alg.dag.graft(&alg.dag, &lacking, &known).ok_or_else(|| {
            let error =
                Diagnostic::error("its force contains a quantity that the model itself does not have");
            Diagnostics::one(stages.model.source.clone(), error)
        })
    }
}

/// The program's expressions for the symbols of the released model; 0 for the released components.
fn known(alg: &Algebra, k: &Kinematics, stages: &mut Stages, moving: &[ExprId]) -> HashMap<SymbolId, ExprId> {
    let zero = stages.alg.dag.zero();
    let own = stages.k;
    let mut known = HashMap::default();
    let mut pair = |of: ExprId, by: ExprId| {
        known.extend(alg.dag.as_symbol(of).map(|symbol| (symbol, by)));
    };
    pair(k.time, own.time);
    for (id, &q) in k.q.enumerate() {
        pair(q, own.q.get(id).copied().unwrap_or(zero));
    }
    k.inputs.iter().zip(own.inputs.iter()).for_each(|(&of, &by)| pair(of, by));
    k.parameters.iter().zip(own.parameters.iter()).for_each(|(&of, &by)| pair(of, by));
    for unknown in k.unknowns.independent() {
        pair(k.unknowns[unknown].value, zero);
    }
    for (of, by) in k.unknowns.independent().into_iter().zip(own.unknowns.independent()) {
        pair(k.unknowns[of].value, own.unknowns[by].value);
    }
    moving.iter().zip(&stages.dynamics.u_dot).for_each(|(&of, &by)| pair(of, by));
    known
}
