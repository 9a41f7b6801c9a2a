//! Reads `[policy]`: the policy that gives orders while a plan runs, and its bounds.

use crate::world::read::value::{Bound, count, number, one_of};
use smartbed_bed::plan::Plan;
use smartbed_bed::policy::Policy;
use smartbed_bed::policy::bounds::Bounds;
use smartbed_bed::policy::planner::{Goal, Planner};
use smartbed_bed::policy::scheduled::Scheduled;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Value, wrong_kind};

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

/// Reads `[policy]`.
pub(super) fn read(table: &Table, found: &mut Diagnostics) -> Option<Chosen> {
    let fields = Fields::of("policy", table.span, table);
    let (usual, bounds) = (Goal::default(), Bounds::default());
    let kind = fields.need("kind", "\"planner\"", found)?;
    let Value::Text(text) = kind else {
        found.push(wrong_kind("kind", "planner or alternating", kind));
        return None;
    };
    let name =
        KINDS.into_iter().find(|k| Some(*k) == one_of(&text.text, text.span, ("policy", &KINDS), found))?;
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
    if 2.0 * goal.ramp + goal.hold > goal.cycle / goal.slots as f64 {
        let error =
            Diagnostic::error("a slot of the cycle is too short to deflate, hold and refill a bladder");
        found.push(
            error.label(table.span, "of this policy").help("fewer `slots`, or a shorter `ramp` or `hold`"),
        );
        return None;
    }
    Some(Chosen { name, goal, bounds })
}

impl Chosen {
    /// Creates the policy.
    #[must_use]
    pub fn policy(&self, plan: &Plan) -> Box<dyn Policy> {
        let Goal { low, cycle, .. } = self.goal;
        match self.name {
            "planner" => Box::new(Planner::new(self.goal)),
            _ => Box::new(Scheduled::alternating(&plan.layout, low, plan.pressure, cycle, plan.seconds)),
        }
    }
}
