//! `derive --costs`: what each answer adds to the cost of its function.
//!
//! In: a program and the functions asked for. Out: one row per answer: operations and live values, from the program;
//! size, stack and instructions in f32 on a Cortex-M4F, from an image of functions with one answer more each, if the
//! machine has a toolchain for it.

use crate::engine::crate_text;
use crate::failure::Failure;
use crate::firmware::functions::{self, ChipCost, Measured};
use crate::firmware::image::straight::Instructions;
use crate::output;
use serde_json::{Value, json};
use smartbed_codegen::rust::{FunctionCost, cost, function_names};
use smartbed_codegen::{Answer, Core, EmitOptions, Function, Program, ScalarType};

/// An answer, and its function with all answers up to this one.
struct Row {
    /// Name of the whole function, as it is emitted.
    function: String,
    first: Function,
    cost: FunctionCost,
    chip: Option<ChipCost>,
}

/// Prints the sheet of these functions.
///
/// # Errors
/// Status 1 if the functions do not build for the chip, status 2 where nothing can be written.
pub fn print(
    program: &Program,
    asked: &[Function],
    core: Option<Core>,
    as_json: bool,
) -> Result<(), Failure> {
    let core = core.or(Some(Core::CortexM4));
    let options = EmitOptions { scalar: ScalarType::F32, core, ..EmitOptions::default() };
    let mut rows = rows(program, asked, &options);
    measure(program, &mut rows, options)?;
    output::print(&if as_json { json(program, &rows) } else { text(program, &rows) })
}

/// The first answers of every function, one more per row. Answers that the program does not have, or that have no
/// numbers, are left out.
fn rows(program: &Program, asked: &[Function], options: &EmitOptions) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    let emitted = function_names(program, &EmitOptions { functions: asked.to_vec(), ..options.clone() });
    for function in asked {
        let name = emitted.get(&function.name).unwrap_or(&function.name);
        for n in 0..function.requests.len() {
            let has_numbers = |answer: Answer| !answer.roots().is_empty();
            if program.answer(&function.requests[n]).is_some_and(has_numbers) {
                let requests = function.requests[..=n].to_vec();
                let first = Function { name: format!("cost_{}", rows.len()), requests };
                let cost = cost(program, &first, options);
                rows.push(Row { function: name.clone(), first, cost, chip: None });
            }
        }
    }
    rows
}

/// Measures the costs on the chip; if that is not possible, says why.
fn measure(program: &Program, rows: &mut [Row], options: EmitOptions) -> Result<(), Failure> {
    let Some(toolchain) = functions::toolchain() else {
        output::say(
            "note: code, stack and instructions need a Rust toolchain for thumbv7em-none-eabihf: `cargo smartbed \
             firmware` finds or installs one",
        );
        return Ok(());
    };
    output::say(&format!("building the functions with {}", toolchain.describe()));
    let takes_u_dot = |row: &Row| program.answers_of(&row.first).iter().any(|answer| answer.takes_u_dot);
    let measured: Vec<Measured> = rows
        .iter()
        .map(|row| Measured { name: row.first.name.clone(), takes_u_dot: takes_u_dot(row) })
        .collect();
    let options = EmitOptions { functions: rows.iter().map(|row| row.first.clone()).collect(), ..options };
    let files = crate_text::library(program, &options.scalar, &options);
    let costs = functions::costs(&toolchain, files, &measured)?;
    rows.iter_mut().zip(costs).for_each(|(row, cost)| row.chip = Some(cost));
    Ok(())
}

/// The row before, if it belongs to the same function: the difference is what the answer adds.
fn before(rows: &[Row], n: usize) -> Option<&Row> {
    rows[..n].last().filter(|_| rows[n].first.requests.len() > 1)
}

/// The last answer of a row's function.
fn answer(row: &Row) -> String {
    row.first.requests.last().map(ToString::to_string).unwrap_or_default()
}

fn text(program: &Program, rows: &[Row]) -> String {
    let head =
        ["function", "answer", "operations", "values alive", "code (bytes)", "stack (bytes)", "instructions"];
    let mut table = vec![head.map(str::to_owned)];
    let mut any_loops = false;
    for (n, row) in rows.iter().enumerate() {
        let last = before(rows, n);
        let grown = |all: Option<u64>, before: Option<u64>, mark: &str| match (all, before) {
            (None, _) => "-".to_owned(),
            (Some(all), None) => format!("{all}{mark}"),
            (Some(all), Some(before)) => {
                format!("{:+} = {all}{mark}", all.cast_signed() - before.cast_signed())
            }
        };
        let operations = |row: &Row| row.cost.operations as u64;
        let bytes = |row: &Row| row.chip.map(|chip| u64::from(chip.bytes));
        let instructions = |row: &Row| row.chip.map(|chip| chip.instructions.count);
        let has_loops = row.chip.is_some_and(|chip| chip.instructions.has_loops);
        any_loops |= has_loops;
        table.push([
            if last.is_none() { row.function.clone() } else { String::new() },
            answer(row),
            grown(Some(operations(row)), last.map(operations), ""),
            row.cost.values_alive.to_string(),
            grown(bytes(row), last.and_then(bytes), ""),
            grown(row.chip.map(|chip| u64::from(chip.stack)), None, ""),
            grown(instructions(row), last.and_then(instructions), if has_loops { "*" } else { "" }),
        ]);
    }
    let mut text = format!(
        "{} in f32 on a Cortex-M4F: what each answer adds = total of its function so far\n\n",
        program.name
    );
    let width = |column: usize| table.iter().map(|row| row[column].len()).max().unwrap_or(0);
    for row in &table {
        let cells = row.iter().enumerate().map(|(column, cell)| match column {
            0 | 1 => format!("{cell:<w$}", w = width(column)),
            _ => format!("{cell:>w$}", w = width(column)),
        });
        text += cells.collect::<Vec<_>>().join("  ").trim_end();
        text.push('\n');
    }
    if any_loops {
        text += "\n* It contains a loop, such as one that copies or clears many numbers: counted once.\n";
    }
    text
}

fn json(program: &Program, rows: &[Row]) -> String {
    let row = |(n, row): (usize, &Row)| {
        let added = row.cost.operations.cast_signed()
            - before(rows, n).map_or(0, |before| before.cost.operations.cast_signed());
        let chip = row
            .chip
            .map(|ChipCost { bytes, stack, instructions: Instructions { count, has_loops } }| {
            json!({"bytes": bytes, "stack": stack, "instructions": count, "has_loops": has_loops})
        });
        json!({
            "function": row.function,
            "answer": answer(row),
            "operations": row.cost.operations,
            "added": added,
            "values_alive": row.cost.values_alive,
            "chip": chip,
        })
    };
    let costs: Vec<Value> = rows.iter().enumerate().map(row).collect();
    format!("{}\n", json!({"model": program.name, "costs": costs}))
}
