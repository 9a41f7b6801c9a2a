//! Reads `[metrics]`: estimated parameters of the metrics, none of them measured.

use crate::world::read::value::{Bound, number};
use smartbed_bed::metrics::Thresholds;
use smartbed_codegen::diagnostic::Diagnostics;
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Table;

/// Reads `[metrics]`; `cycle` (s) is the run's.
pub(super) fn read(plan: &Fields<'_>, cycle: f64, found: &mut Diagnostics) -> Thresholds {
    let empty = Table::default();
    let table = plan.table("metrics", found).unwrap_or(&empty);
    let fields = Fields::of("metrics", table.span, table);
    let usual = Thresholds { cycle, ..Thresholds::default() };
    let mut get = |key: &'static str, of: &str, bound: Bound, left_out: f64| {
        number(&fields, key, of, bound, found).unwrap_or(left_out)
    };
    let thresholds = Thresholds {
        muscle_factor: get("muscle_factor", "", Bound::Positive, usual.muscle_factor),
        shear_factor: get("shear_factor", "", Bound::NotNegative, usual.shear_factor),
        shear_reference: get("shear_reference", "Pa", Bound::Positive, usual.shear_reference),
        ..usual
    };
    fields.finish(found);
    thresholds
}
