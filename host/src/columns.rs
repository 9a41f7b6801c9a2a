//! Names of the columns of a mechanism's run: what shares its name with another column is told apart.

use smartbed_codegen::model::Model;

/// Names of the columns of a row, in the documented order; those that a rigid mechanism does not have stay 0.
pub const ACCOUNTS: [&str; 12] = [
    "kinetic",
    "gravity",
    "spring",
    "pressure",
    "damping",
    "drag",
    "impact",
    "friction",
    "actuator",
    "external",
    "total",
    "imbalance",
];

/// One more, of driven mechanisms.
pub const DRIVE: &str = "drive";

/// The column of a coordinate or a speed: `coordinate.NAME` or `speed.NAME` where an energy or an account has the name.
#[must_use]
pub fn of_state(kind: &str, name: &str) -> String {
    let is_taken = [DRIVE].into_iter().chain(ACCOUNTS).any(|own| own == name);
    if is_taken { format!("{kind}.{name}") } else { name.to_owned() }
}

/// Names of outputs and inputs in the order of the model: `output.NAME` or `input.NAME` where an earlier column has the
/// name. `None` for an output that repeats a coordinate in closed form, which has a column already.
#[must_use]
pub fn told_apart(model: &Model) -> (Vec<Option<String>>, Vec<String>) {
    let coordinates = model.coordinates.iter().map(|own| own.name.as_str());
    let speeds = model.speeds.iter().map(|own| own.name.as_str());
    let mut taken: Vec<&str> =
        ["t", DRIVE].into_iter().chain(ACCOUNTS).chain(coordinates).chain(speeds).collect();
    let closed =
        |name: &str| model.coordinates.iter().any(|own| own.name == name && own.closed_form.is_some());
    let apart = |kind: &str, name: &str, taken: &[&str]| {
        if taken.contains(&name) { format!("{kind}.{name}") } else { name.to_owned() }
    };
    let outputs = model.outputs.iter().map(|own| own.name.as_str());
    let of_outputs =
        outputs.clone().map(|name| (!closed(name)).then(|| apart("output", name, &taken))).collect();
    taken.extend(outputs);
    let inputs = model.inputs.iter().map(|own| apart("input", &own.name, &taken)).collect();
    (of_outputs, inputs)
}
