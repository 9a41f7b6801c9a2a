//! Reads the orders to tiles over time, `[[move]]` and `[alternating]`, and the keys of a `[sweep]`.

use crate::world::read::value::{Bound, list, number, scalar};
use smartbed_bed::plan::{Layout, Move, Plan};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Value, wrong_kind};
use smartbed_codegen::source::Span;

/// Keys of a sweep with the texts of their values, in the author's order.
pub type Axes = Vec<(String, Vec<String>)>;

/// Most moves times equilibria: each equilibrium evaluates each move.
const MOST_ORDERS: f64 = 1e7;
/// Moves of a cycle of alternating pressure: two groups go down and up.
const MOVES_PER_CYCLE: f64 = 4.0;

/// All moves of a plan, sorted by their beginning, each with its place; `pressure` (Pa) is the initial one, `seconds`
/// the length of the run, `every` the interval between its moments.
pub(super) fn read(
    plan: &Fields<'_>,
    layout: &Layout,
    pressure: f64,
    [seconds, every]: [f64; 2],
    found: &mut Diagnostics,
) -> Option<Vec<(Move, Span)>> {
    let mut moves = Vec::new();
    for item in plan.array("move", found).map_or(&[][..], |(items, _)| items) {
        match item {
            Value::Table(table) => {
                moves.extend(change(table, layout, seconds, found).map(|own| (own, table.span)))
            }
            other => found.push(wrong_kind("move", "tables, each under [[move]]", other)),
        }
    }
    let mut span = plan.span;
    if let Some(table) = plan.table("alternating", found) {
        span = table.span;
        let all = alternating(table, layout, pressure, [seconds, every], found)?;
        moves.extend(all.into_iter().map(|own| (own, span)));
    }
    are_few(moves.len() as f64, seconds / every, span, found)?;
    moves.sort_by(|(a, _), (b, _)| a.at.total_cmp(&b.at));
    Some(moves)
}

/// Refuses more moves than can be evaluated at all equilibria of a run.
fn are_few(moves: f64, equilibria: f64, span: Span, found: &mut Diagnostics) -> Option<()> {
    let asked = moves * (equilibria + 2.0 * moves);
    if asked <= MOST_ORDERS {
        return Some(());
    }
    let error = Diagnostic::error(format!(
        "the number of moves times the number of equilibria is {asked:.1e}, expected at most {MOST_ORDERS:.0e}"
    ));
    found.push(error.label(span, "of these").help("fewer cycles, or a longer `every`"));
    None
}

/// Refuses more cycles of an alternation than a run of `seconds` with a moment `every` can take.
pub(super) fn cycles_are_few(
    cycle: f64,
    [seconds, every]: [f64; 2],
    span: Span,
    found: &mut Diagnostics,
) -> Option<()> {
    let cycles = (seconds / cycle).ceil();
    if cycles > Plan::MOST_CYCLES as f64 {
        let error = Diagnostic::error(format!("more than {} cycles", Plan::MOST_CYCLES));
        found.push(error.label(span, "of this alternation").help("a longer `cycle`"));
        return None;
    }
    are_few(MOVES_PER_CYCLE * cycles, seconds / every, span, found)
}

/// One `[[move]]`; a warning if it begins after the end of the run.
fn change(table: &Table, layout: &Layout, seconds: f64, found: &mut Diagnostics) -> Option<Move> {
    let fields = Fields::of("move", table.span, table);
    let at = number(&fields, "at", "s", Bound::NotNegative, found).unwrap_or(0.0);
    let over = number(&fields, "over", "s", Bound::NotNegative, found).unwrap_or(0.0);
    if at > seconds || at == seconds && over > 0.0 {
        let warning =
            Diagnostic::warning(format!("a move at {at} s has no effect: the run ends at {seconds} s"));
        let span = fields.get("at").map_or(table.span, Value::span);
        let label = if at > seconds { "after the end" } else { "it only begins at the end" };
        found.push(warning.label(span, label).help("an earlier `at`, or a larger run.seconds"));
    }
    let tiles = tiles(fields.need("tiles", "\"all\"", found)?, layout, found)?;
    let pressure = number(&fields, "pressure", "Pa", Bound::Any, found);
    let heave = number(&fields, "heave", "m", Bound::Any, found);
    let tilt = fields.get("tilt").map(|value| list::<2>(value, "tilt", "", found));
    fields.finish(found);
    if pressure.is_none() && heave.is_none() && tilt.is_none() {
        let error = Diagnostic::error("a move without pressure, heave or tilt").label(table.span, "this one");
        found.push(error.help("give it one of them"));
        return None;
    }
    let slope = match tilt {
        None => None,
        Some(angles) => {
            let angles = angles?;
            if angles.iter().any(|a| a.abs() >= 1.0) {
                let error =
                    Diagnostic::error("`tilt` must be below 57 deg").label(table.span, "in this move");
                found.push(error.help("tilt = [\"5_deg\", \"0_deg\"], towards +x and +y"));
                return None;
            }
            Some(angles.map(f64::tan))
        }
    };
    Some(Move { at, over, tiles, pressure, heave, slope })
}

/// `"all"`, or numbers from 1.
fn tiles(value: &Value, layout: &Layout, found: &mut Diagnostics) -> Option<Vec<usize>> {
    let most = layout.count();
    let mut refuse = |span: Span, what: String| {
        let error = Diagnostic::error(what).label(span, "here");
        found.push(
            error.help(format!("tiles = \"all\", or numbers from 1 to {most}, row by row from the head")),
        );
        None
    };
    match value {
        Value::Text(text) if text.text == "all" => Some((0..most).collect()),
        Value::Array(items, span) if items.is_empty() => {
            refuse(*span, "the list of tiles is empty".to_owned())
        }
        Value::Array(items, _) => {
            let mut tiles = Vec::new();
            for item in items {
                match item {
                    Value::Number(n, _) if n.fract() == 0.0 && (1.0..=most as f64).contains(n) => {
                        let tile = *n as usize - 1;
                        if tiles.contains(&tile) {
                            return refuse(item.span(), format!("tile {n} is named twice"));
                        }
                        tiles.push(tile);
                    }
                    other => return refuse(other.span(), "there is no such tile".to_owned()),
                }
            }
            Some(tiles)
        }
        other => refuse(other.span(), "expected tiles".to_owned()),
    }
}

/// `[alternating]`.
fn alternating(
    table: &Table,
    layout: &Layout,
    pressure: f64,
    [seconds, every]: [f64; 2],
    found: &mut Diagnostics,
) -> Option<Vec<Move>> {
    let fields = Fields::of("alternating", table.span, table);
    let low = scalar(fields.need("low", "\"1.6_kPa\"", found)?, "low", "Pa", Bound::NotNegative, found)?;
    let high = number(&fields, "high", "Pa", Bound::NotNegative, found).unwrap_or(pressure);
    let cycle = number(&fields, "cycle", "s", Bound::Positive, found).unwrap_or(600.0);
    fields.finish(found);
    is_lower(low, high, table.span, found)?;
    cycles_are_few(cycle, [seconds, every], table.span, found)?;
    Some(Plan::alternating(layout, low, high, cycle, seconds))
}

/// Refuses a low pressure (Pa) above the high one.
pub(super) fn is_lower(low: f64, high: f64, span: Span, found: &mut Diagnostics) -> Option<()> {
    if low <= high {
        return Some(());
    }
    let [low, high] = [low, high].map(|pressure| 1e-3 * pressure);
    let error =
        Diagnostic::error(format!("`low` is {low} kPa, expected at most the high pressure of {high} kPa"));
    found.push(error.label(span, "low is to relieve").help("a lower `low`, or a higher `bed.pressure`"));
    None
}

/// Keys and values of a sweep.
pub(super) fn axes(table: &Table, found: &mut Diagnostics) -> Axes {
    let mut axes = Axes::new();
    for (key, value) in &table.entries {
        let texts = match value {
            Value::Array(items, _) if !items.is_empty() => {
                items.iter().map(text_of).collect::<Option<Vec<_>>>()
            }
            _ => None,
        };
        match texts {
            Some(texts) => axes.push((key.name.clone(), texts)),
            None if matches!(value, Value::Array(items, _) if items.is_empty()) => {
                let error = Diagnostic::error(format!("`{}` in [sweep] has no values", key.name));
                found.push(error.label(value.span(), "an empty list").help("give at least one"));
            }
            None => found.push(
                wrong_kind(
                    &key.name,
                    "a list of values: numbers, texts, true or false, or lists of them",
                    value,
                )
                .help("\"patient.mass\" = [\"60_kg\", \"75_kg\"], \"load.place\" = [[0, 0], [0.05, 0]]"),
            ),
        }
    }
    axes
}

/// A value as the text of a setting.
fn text_of(value: &Value) -> Option<String> {
    match value {
        Value::Number(x, _) => Some(format!("{x}")),
        Value::Boolean(x, _) => Some(format!("{x}")),
        Value::Text(text) => Some(format!("{:?}", text.text)),
        Value::Array(items, _) => {
            let texts = items.iter().map(text_of).collect::<Option<Vec<_>>>()?;
            Some(format!("[{}]", texts.join(", ")))
        }
        _ => None,
    }
}
