//! Emits a model as Rust, and says on standard output what the file holds:
//! `cargo run --release -p smartbed-codegen --example emit -- models/tile.toml tile.rs [all]`
//!
//! With `all` every effort goes into a short program.

use serde_json::json;
use smartbed_codegen::program::Quantity;
use smartbed_codegen::{Effort, EmitOptions, ParameterChoice, model, program, rust};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (input, output, effort) = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [input, output] => (input, output, Effort::Default),
        [input, output, "all"] => (input, output, Effort::All),
        _ => {
            eprintln!("expected: the model, the file to write and, if wanted, the word all");
            return ExitCode::FAILURE;
        }
    };
    let start = Instant::now();
    let derived = model::read(Path::new(input))
        .and_then(|model| program::derive_with(&model, &ParameterChoice::default(), effort));
    let program = match derived {
        Ok(program) => program,
        Err(found) => {
            eprintln!("{found}");
            return ExitCode::FAILURE;
        }
    };
    let text = rust::emit(&program, &EmitOptions::default());
    let milliseconds = start.elapsed().as_secs_f64() * 1e3;
    if let Err(error) = std::fs::write(output, text) {
        eprintln!("cannot write {output}: {error}");
        return ExitCode::FAILURE;
    }
    let names = |list: &[Quantity]| -> Vec<String> { list.iter().map(|item| item.name.clone()).collect() };
    let about = json!({
        "q": names(&program.q),
        "u": names(&program.u),
        "inputs": names(&program.inputs),
        "parameters": names(&program.parameters),
        "operations": program.operations(),
        "milliseconds": milliseconds,
    });
    println!("{about}");
    ExitCode::SUCCESS
}
