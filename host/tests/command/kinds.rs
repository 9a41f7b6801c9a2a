//! Files of another kind than a command takes: the message says what the file is and which commands take it.

use crate::support::{smartbed, written};

/// The message of a command that was given a file of a kind that it does not take.
fn refusal(arguments: &[&str]) -> String {
    let message = smartbed(arguments).message().to_owned();
    assert!(!message.contains("no `name`"), "{message}");
    message
}

#[test]
fn commands_for_models_name_the_commands_that_take_a_scene() {
    for command in [&["check"][..], &["derive"], &["eval", "--states", "none.json"], &["equilibrium"]] {
        let refusal = |file: &str| refusal(&[command, &[file]].concat());
        let body = refusal("truss");
        assert!(body.contains("this is a scene of format 1") && body.contains("`run`"), "{body}");
        let world = refusal("bed");
        assert!(world.contains("this is a scene of format 2") && world.contains("`settle`"), "{world}");
    }
}

#[test]
fn a_command_for_worlds_names_those_that_take_a_model_or_a_body() {
    let model = refusal(&["settle", "tile"]);
    assert!(model.contains("this is a model") && model.contains("`equilibrium`"), "{model}");
    let body = refusal(&["settle", "truss"]);
    assert!(body.contains("this is a scene of format 1"), "{body}");
}

#[test]
fn plans_and_models_are_not_taken_for_one_another() {
    let plan = "models/plans/alternating.toml";
    for command in ["check", "run", "settle", "firmware"] {
        let said = refusal(&[command, plan]);
        assert!(said.contains("this is a plan of the bed") && said.contains("`bed run`"), "{said}");
    }
    let model = refusal(&["bed", "run", "models/tile.toml"]);
    assert!(model.contains("expected a plan of the bed"), "{model}");
}

#[test]
fn a_world_without_parts_is_told_what_it_needs() {
    let empty = written("no_parts.toml", "format = 2\ntitle = \"empty\"\n[run]\nseconds = 1\n");
    let said = refusal(&["run", &empty]);
    assert!(said.contains("has no parts") && said.contains("[parts.NAME]"), "{said}");
}
