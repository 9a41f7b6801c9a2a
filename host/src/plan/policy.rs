//! Reads `[policy]`: the policy that gives orders while a plan runs, and its bounds.

use super::moves;
use crate::world::read::value::{Bound, count, number, one_of};
use smartbed_bed::plan::{Move, Plan};
use smartbed_bed::policy::Policy;
use smartbed_bed::policy::bounds::Bounds;
use smartbed_bed::policy::planner::{Goal, Planner};
use smartbed_bed::policy::scheduled::Scheduled;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Value, wrong_kind};

/// Keys of the planner alone.
const OF_PLANNER: [&str; 6] = ["slots", "ramp", "hold", "least", "lower", "tilt"];

/// Policies by name.
const KINDS: [&str; 2] = ["planner", "alternating"];

/// A policy that a plan names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chosen {
    /// Its name.
    pub name: &'static str,
    /// Goals of the planner; low pressure and cycle of the alternation.
    pub goal: Goal,
    /// Its bounds.
    pub bounds: Bounds,
}

/// Reads `[policy]` of a run of `seconds` with a moment `every`, whose bladders begin at a pressure (Pa).
pub(super) fn read(table: &Table, run: [f64; 2], pressure: f64, found: &mut Diagnostics) -> Option<Chosen> {
    let fields = Fields::of("policy", table.span, table);
    let (usual, bounds) = (Goal::default(), Bounds::default());
    let kind = fields.need("kind", "\"planner\"", found)?;
    let Value::Text(text) = kind else {
        found.push(wrong_kind("kind", "planner or alternating", kind));
        return None;
    };
    let name =
        KINDS.into_iter().find(|k| Some(*k) == one_of(&text.text, text.span, ("policy", &KINDS), found))?;
    let idle = OF_PLANNER.into_iter().find_map(|key| Some((key, fields.get(key)?)));
    if let Some((key, value)) = idle.filter(|_| name != "planner") {
        let error = Diagnostic::error(format!("`{key}` has no effect on the policy `{name}`"));
        found.push(
            error.label(value.span(), "of the planner alone").help("leave it out, or kind = \"planner\""),
        );
        return None;
    }
    let mut get = |key: &'static str, of: &str, usual: f64| {
        number(&fields, key, of, Bound::Positive, found).unwrap_or(usual)
    };
    let goal = Goal {
        cycle: get("cycle", "s", usual.cycle),
        ramp: get("ramp", "s", usual.ramp),
        hold: get("hold", "s", usual.hold),
        low: get("low", "Pa", usual.low),
        least: get("least", "m^2", usual.least),
        lower: usual.lower,
        tilt: usual.tilt,
        slots: usual.slots,
    };
    let bounds = Bounds {
        low: get("low_below", "Pa", bounds.low),
        support: get("support", "", bounds.support),
        most_low: bounds.most_low,
    };
    let mut not_negative = |key: &'static str, of: &str, usual: f64| {
        number(&fields, key, of, Bound::NotNegative, found).unwrap_or(usual)
    };
    let goal = Goal {
        lower: not_negative("lower", "m", goal.lower),
        tilt: not_negative("tilt", "", goal.tilt.atan()).min(1.5).tan(),
        ..goal
    };
    let goal = Goal { slots: count(&fields, "slots", 1, found).unwrap_or(goal.slots), ..goal };
    let bounds =
        Bounds { most_low: count(&fields, "most_low", 0, found).unwrap_or(bounds.most_low), ..bounds };
    fields.finish(found);
    let chosen = Chosen { name, goal, bounds };
    moves::is_lower(goal.low, pressure, table.span, found)?;
    if chosen.relief().is_none() {
        moves::cycles_are_few(goal.cycle, run, table.span, found)?;
    }
    let slot = goal.cycle / goal.slots as f64;
    // Only the planner has slots; an alternation divides its cycle itself.
    if let Some(relief) = chosen.relief().filter(|relief| *relief > slot) {
        let Goal { cycle, slots, ramp, hold, .. } = goal;
        let what = "a slot of the cycle is shorter than deflating, holding and refilling";
        let place = format!(
            "`cycle` / `slots` = {cycle} s / {slots} = {slot} s, `ramp` + `hold` + `ramp` = {ramp} + {hold} + {ramp} = {relief} s"
        );
        let help = "a longer `cycle`, fewer `slots`, or a shorter `ramp` or `hold`";
        found.push(Diagnostic::error(what).label(table.span, place).help(help));
        return None;
    }
    Some(chosen)
}

impl Chosen {
    /// Time (s) in which the planner relieves a tile and brings it back; `None` for other policies.
    #[must_use]
    pub fn relief(&self) -> Option<f64> {
        (self.name == "planner").then_some(2.0 * self.goal.ramp + self.goal.hold)
    }

    /// Moves that the policy is known to make, counted from its first decision.
    #[must_use]
    pub fn scheduled(&self, plan: &Plan) -> Vec<Move> {
        match self.relief() {
            Some(_) => Vec::new(),
            None => {
                Plan::alternating(&plan.layout, self.goal.low, plan.pressure, self.goal.cycle, plan.seconds)
            }
        }
    }

    /// Creates the policy.
    #[must_use]
    pub fn policy(&self, plan: &Plan) -> Box<dyn Policy> {
        match self.relief() {
            Some(_) => Box::new(Planner::new(self.goal)),
            None => Box::new(Scheduled::new(self.scheduled(plan))),
        }
    }
}
