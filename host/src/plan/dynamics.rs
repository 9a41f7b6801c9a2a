//! Reads `run.clock` and `[dynamics]`: how motion is computed.

use super::load::named;
use crate::world::read::value::{Bound, number};
use smartbed_bed::dynamics::{Impact, Matter, Method};
use smartbed_bed::plan::{DROP, Dynamics, Start};
use smartbed_bed::tissue::Tissue;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Table;

/// Most steps of a run.
const MOST_STEPS: f64 = 1e7;

/// Values of `run.clock`: is motion computed?
pub(super) const CLOCKS: [(&str, bool); 2] = [("quasi_static", false), ("dynamics", true)];

/// The contents of `[dynamics]`.
pub(super) struct Settings {
    /// Settings for motion.
    pub(super) dynamics: Dynamics,
    /// Settings for the load's fall before the first equilibrium.
    pub(super) fall: Dynamics,
}

/// Reads `[dynamics]`. `seconds` is the length of the motion, 0 with the other clock; `is_fallen` says that the load
/// falls before the first equilibrium.
pub(super) fn read(
    table: &Table,
    seconds: f64,
    is_fallen: bool,
    found: &mut Diagnostics,
) -> Option<Settings> {
    let fields = Fields::of("dynamics", table.span, table);
    let (usual, matter) = (Dynamics::default(), Matter::default());
    let mut key = |key: &'static str, of: &str, bound: Bound, usual: f64| {
        number(&fields, key, of, bound, found).unwrap_or(usual)
    };
    let step = key("step", "s", Bound::Positive, usual.step);
    let density = key("density", "kg/m^2", Bound::Positive, matter.density);
    let sheet_loss = key("sheet_loss", "s", Bound::NotNegative, matter.sheet_loss);
    let joint_loss = key("joint_loss", "s", Bound::NotNegative, matter.joint_loss);
    let tissue = Tissue {
        loss: key("tissue_loss", "s", Bound::NotNegative, matter.tissue.loss),
        at_once: key("tissue_at_once", "", Bound::Positive, matter.tissue.at_once),
        relaxation: key("tissue_relaxation", "s", Bound::Positive, matter.tissue.relaxation),
    };
    let method = named(&fields, "method", &METHODS, found);
    let impact = named(&fields, "impact", &IMPACTS, found);
    let is_f32 = named(&fields, "scalar", &SCALARS, found);
    let start = named(&fields, "start", &STARTS, found);
    let drop = number(&fields, "drop", "m", Bound::NotNegative, found);
    fields.finish(found);
    let mut refuse = |what: String, help: &str| {
        found.push(Diagnostic::error(what).label(table.span, "of this motion").help(help));
        None
    };
    if tissue.at_once < 1.0 {
        let what = format!("`tissue_at_once` is {}, expected 1 or more", tissue.at_once);
        return refuse(
            what,
            "ratio of the tissue's initial stiffness to that after relaxation; 1: no relaxation",
        );
    }
    let is_at_rest = start?;
    if is_at_rest && drop.is_some() && !is_fallen {
        return refuse("`drop` has no effect on a start at rest".to_owned(), "leave one of the two out");
    }
    if seconds / step > MOST_STEPS {
        return refuse(format!("more than {MOST_STEPS} steps"), "a longer `step`");
    }
    let matter = Matter { density, sheet_loss, joint_loss, tissue };
    let fall = Dynamics {
        step,
        method: method?,
        start: Start::Dropped(drop.unwrap_or(DROP)),
        matter,
        impact: impact?,
        is_f32: is_f32?,
    };
    let start = if is_at_rest { Start::AtRest } else { fall.start };
    Some(Settings { dynamics: Dynamics { start, ..fall }, fall })
}

/// Starts by name, the default first: is it at rest?
const STARTS: [(&str, bool); 2] = [("dropped", false), ("at_rest", true)];

/// Scalars by name, the default first: is it f32?
const SCALARS: [(&str, bool); 2] = [("f64", false), ("f32", true)];

/// Treatment of impacts of sheets on the load by name, the default first.
const IMPACTS: [(&str, Impact); 2] = [("compensation", Impact::Compensation), ("implicit", Impact::Implicit)];

/// Methods by name, the default first.
const METHODS: [(&str, Method); 4] = [
    ("bdf2", Method::Bdf2),
    ("tr_bdf2", Method::TrBdf2),
    ("backward_euler", Method::BackwardEuler),
    ("trapezoid", Method::Trapezoid),
];
