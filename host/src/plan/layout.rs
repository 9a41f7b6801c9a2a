//! Reads `[bed]`: tiles, their sheets and their limits, and the initial pressure.

use crate::world::read::value::{Bound, count, list, number};
use smartbed_bed::plan::Layout;
use smartbed_bed::plan::check::MOST_TILES;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Table;

/// Most nodes of all sheets together.
const MOST_NODES: usize = 100_000;

/// n in p V^n = constant: from isothermal changes to adiabatic ones of a monatomic gas.
const EXPONENTS: std::ops::RangeInclusive<f64> = 1.0..=1.67;

/// Reads `[bed]`: the layout, and the initial pressure (Pa).
pub(super) fn read(table: &Table, found: &mut Diagnostics) -> Option<(Layout, f64)> {
    let fields = Fields::of("bed", table.span, table);
    let usual = Layout::default();
    let mut positive = |key: &'static str, of: &str, usual: f64| {
        number(&fields, key, of, Bound::Positive, found).unwrap_or(usual)
    };
    let mut layout = Layout {
        depth: positive("depth", "m", usual.depth),
        modulus: positive("modulus", "N/m", usual.modulus),
        circle: positive("circle", "m", usual.circle),
        stroke: positive("stroke", "m", usual.stroke),
        speed: positive("speed", "m/s", usual.speed),
        step: positive("step", "m", usual.step),
        most_pressure: positive("most_pressure", "Pa", usual.most_pressure),
        above: positive("above", "m", usual.above),
        gap: positive("gap", "m", usual.gap),
        ..usual
    };
    let pressure = positive("pressure", "Pa", 4000.0);
    layout.friction = number(&fields, "friction", "", Bound::NotNegative, found).unwrap_or(usual.friction);
    layout.rubbing =
        number(&fields, "sheet_friction", "", Bound::NotNegative, found).unwrap_or(usual.rubbing);
    layout.exponent = number(&fields, "exponent", "", Bound::Positive, found).unwrap_or(usual.exponent);
    layout.rows = count(&fields, "rows", 1, found).unwrap_or(usual.rows);
    layout.columns = count(&fields, "columns", 1, found).unwrap_or(usual.columns);
    layout.is_sealed = fields.boolean("sealed", found).unwrap_or(false);
    if let Some(value) = fields.get("pitch") {
        layout.pitch = list::<2>(value, "pitch", "m", found)?;
    }
    if let Some(value) = fields.get("intervals") {
        let told = list::<2>(value, "intervals", "", found)?;
        if told.iter().any(|n| n.fract() != 0.0 || *n < 0.0) {
            let [x, y] = told;
            let error = Diagnostic::error(format!("`intervals` are {x} and {y}, expected whole numbers"));
            found.push(error.label(value.span(), "along x and y").help("intervals = [8, 10]"));
            return None;
        }
        layout.intervals = told.map(|n| n as usize);
    }
    fields.finish(found);
    let mut refuse = |what: String, help: &str| {
        found.push(Diagnostic::error(what).label(table.span, "of this bed").help(help));
        None
    };
    if !EXPONENTS.contains(&layout.exponent) {
        let [least, most] = [EXPONENTS.start(), EXPONENTS.end()];
        return refuse(
            format!("`exponent` is {}, expected {least} to {most}: n of p V^n", layout.exponent),
            "1 for isothermal changes, 1.4 for adiabatic changes of air",
        );
    }
    let tiles = layout.rows.saturating_mul(layout.columns);
    if tiles > MOST_TILES {
        return refuse(format!("{tiles} tiles, expected 1 to {MOST_TILES}"), "fewer `rows` or `columns`");
    }
    if layout.size().iter().any(|s| *s <= 0.0) {
        return refuse(
            "`gap` is not smaller than `pitch`: no room is left for a tile".to_owned(),
            "pitch = [\"225_mm\", \"285.7_mm\"]",
        );
    }
    let [nx, ny] = layout.intervals;
    if tiles.saturating_mul((nx + 1).saturating_mul(ny + 1)) > MOST_NODES {
        return refuse(format!("the sheets have more than {MOST_NODES} nodes"), "fewer `intervals`");
    }
    if let Err(error) = smartbed_bed::sheet::Lattice::new(layout.intervals, layout.size(), layout.modulus) {
        return refuse(error.to_string(), "intervals = [8, 10]");
    }
    Some((layout, pressure))
}
