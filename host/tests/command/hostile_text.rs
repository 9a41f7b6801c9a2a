//! Texts of a model that try to become code or markup on their way through the commands.

use crate::support::{command, file, finish, lock, model, smartbed};
use std::path::PathBuf;
use std::process::Command;

/// A line that stops the compiler wherever it is code.
const CODE: &str = "compile_error!(\"a text became code\");";

/// The pendulum with such lines in its descriptions and, where files may have them, in its file's name.
fn hostile(folder: &str) -> PathBuf {
    let payload =
        format!("a\\n{}\\r{}\\n```\\n{0}\\n```\\n    {0}\\u202e \\u0000", CODE.replace('"', "\\\""), "*/");
    let model = model("pendulum").replace("mass at the end of the rod", &payload);
    let model = model.replace("Simple pendulum with friction in the pin.", &payload);
    let name = if cfg!(unix) { format!("a\n{}\nb.toml", CODE.replace('/', "")) } else { "a.toml".to_owned() };
    let path = file(folder).join(name);
    std::fs::create_dir_all(file(folder)).expect("a folder");
    std::fs::write(&path, model).expect("the test folder can be written");
    path
}

#[test]
fn a_crate_of_a_hostile_model_compiles() {
    let model = hostile("hostile_crate_model").display().to_string();
    let folder = file("hostile_crate");
    let done = smartbed(&["derive", &model, "--crate", &folder.display().to_string()]);
    assert_eq!(done.status, 0, "{done:?}");
    lock(&folder);
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["check", "--quiet"]).current_dir(&folder).env_remove("CARGO_TARGET_DIR");
    let done = finish(cargo);
    assert_eq!(done.status, 0, "{}", done.err);
}

#[test]
fn a_hostile_model_runs_compiled_as_it_runs_interpreted() {
    let model = hostile("hostile_run").display().to_string();
    let run = |engine: &str| {
        let arguments = ["run", &model, "--seconds", "0.1", "--csv", "-", "--engine", engine];
        let done = finish(command(&arguments));
        assert_eq!(done.status, 0, "{done:?}");
        done.out
    };
    assert_eq!(run("interpreter"), run("compiled"));
}

#[test]
fn a_plot_has_no_character_that_xml_lacks() {
    let payload = "a\\u0000b\\u0001c\\uFFFEd\\uFFFFe<&";
    let text = model("pendulum").replace("Simple pendulum with friction in the pin.", payload);
    let svg = file("hostile.svg").display().to_string();
    let path = file("hostile_plot.toml");
    std::fs::write(&path, text).expect("the test folder can be written");
    let done = smartbed(&["run", &path.display().to_string(), "--seconds", "0.1", "--plot", &svg]);
    assert_eq!(done.status, 0, "{done:?}");
    let plot = std::fs::read_to_string(svg).expect("a plot");
    assert!(plot.contains("a b c d e&lt;&amp;"), "{plot}");
    let lacks = |c: char| c.is_control() && c != '\n' || matches!(c, '\u{fffe}' | '\u{ffff}');
    assert!(!plot.contains(lacks), "{plot}");
}
