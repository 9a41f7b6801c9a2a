//! Emits a model as Rust, and says on standard output what the file holds:
//! `cargo run --release -p smartbed-codegen --example emit -- models/tile.toml tile.rs [all] [time | accuracy]`
//!
//! With `all` every effort goes into a short program; with `time` forms are chosen for time on a host instead of count,
//! with `accuracy` for rounding near singular configurations.

use serde_json::json;
use smartbed_codegen::program::Quantity;
use smartbed_codegen::{Effort, EmitOptions, Optimise, ParameterChoice, Settings, model, program, rust};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// What the words after the files say; none if one of them is unknown.
fn settings(words: &[&str]) -> Option<Settings> {
    let mut settings = Settings::default();
    for word in words {
        match *word {
            "all" => settings.effort = Effort::All,
            "time" => settings.optimise = Optimise::Time,
            "accuracy" => settings.optimise = Optimise::Accuracy,
            _ => return None,
        }
    }
    Some(settings)
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let [input, output, rest @ ..] = &words[..] else {
        eprintln!("expected: the model, the file to write and, if wanted, the words all, time or accuracy");
        return ExitCode::FAILURE;
    };
    let Some(settings) = settings(rest) else {
        eprintln!("after the model and the file to write only the words all, time and accuracy are known");
        return ExitCode::FAILURE;
    };
    let start = Instant::now();
    let derived = model::read(Path::new(input))
        .and_then(|model| program::derive_with(&model, &ParameterChoice::default(), settings));
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
