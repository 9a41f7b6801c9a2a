//! States files: `{"states": [{"t": value, "q": {name: value}, "u": {...}, "inputs": {...}, "parameters": {...}}]}`.
//!
//! In: text. Out: named numbers per state, then lists in a program's order. Every name must exist and belong to its
//! group; messages name the state and the name.

use crate::configuration::Configurations;
use crate::failure::Failure;
use crate::input;
use crate::json::Unique;
use crate::suggest;
use serde_json::value::RawValue;
use serde_json::{Map, Value};
use smartbed_codegen::Program;
use smartbed_codegen::model::Model;
use smartbed_codegen::program::Quantity;
use std::collections::BTreeMap;

/// The time of a state; 0 where it is left out.
const TIME: &str = "t";
/// Names of the groups of a state.
const GROUPS: [&str; 5] = ["q", "u", "inputs", "u_dot", "parameters"];
/// Most states in one file: each takes some 600 bytes.
const MOST_STATES: usize = 250_000;

/// One state as written: named numbers.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct State {
    /// Time (s).
    pub t: f64,
    /// Coordinates.
    pub q: Vec<(String, f64)>,
    /// Independent speeds.
    pub u: Vec<(String, f64)>,
    /// Inputs.
    pub inputs: Vec<(String, f64)>,
    /// Derivatives of the independent speeds, by the speeds' names.
    pub u_dot: Vec<(String, f64)>,
    /// Parameters.
    pub parameters: Vec<(String, f64)>,
}

/// One state in a program's order.
#[derive(Clone, PartialEq, Debug)]
pub struct Given {
    /// Coordinates; `None` is to be solved for.
    pub q: Vec<Option<f64>>,
    /// Coordinates in closed form.
    pub closed: Vec<Option<f64>>,
    /// Speeds that are state; an omitted one is 0, or follows from the others if all speeds are state.
    pub u: Vec<Option<f64>>,
    /// Inputs.
    pub inputs: Vec<f64>,
    /// Given derivatives of the speeds; empty if no answer uses them.
    pub u_dot: Vec<f64>,
    /// Tunable parameters.
    pub parameters: Vec<f64>,
}

/// Reads a states file; `-` is standard input.
///
/// # Errors
/// [`Failure::Wrong`] with the place.
pub fn read(path: &str) -> Result<Vec<State>, Failure> {
    let text = input::text(path).map_err(|e| Failure::Wrong(format!("cannot read {path}: {e}")))?;
    parse(&text).map_err(|message| Failure::Wrong(format!("{path}: {message}")))
}

/// Reads the text of a states file.
///
/// # Errors
/// What is wrong and where.
pub fn parse(text: &str) -> Result<Vec<State>, String> {
    let expected = "expected {\"states\": [{\"q\": {...}, \"u\": {...}, ...}, ...]}";
    // State by state: a JSON tree of the whole file would take 80 times the memory of the text.
    let file: &RawValue = serde_json::from_str(text).map_err(|e| format!("not JSON: {e}"))?;
    let keys: BTreeMap<String, &RawValue> = serde_json::from_str(file.get()).unwrap_or_default();
    let list = keys.get("states").ok_or_else(|| format!("there is no \"states\"; {expected}"))?;
    if let Some(other) = keys.keys().find(|key| *key != "states") {
        return Err(format!("unknown key `{other}`; {expected}"));
    }
    let list: Vec<&RawValue> =
        serde_json::from_str(list.get()).map_err(|_| format!("\"states\" is no list; {expected}"))?;
    if list.len() > MOST_STATES {
        return Err(format!("{} states; at most {MOST_STATES} are taken at once", list.len()));
    }
    let read = |text: &RawValue| {
        let Unique(value) = serde_json::from_str(text.get()).map_err(|e| format!(": not JSON: {e}"))?;
        state(&value)
    };
    let mut states = Vec::with_capacity(list.len());
    for (n, text) in list.into_iter().enumerate() {
        states.push(read(text).map_err(|m| format!("states[{n}]{m}"))?);
    }
    Ok(states)
}

fn state(value: &Value) -> Result<State, String> {
    let groups = value.as_object().ok_or(": expected an object {\"q\": {...}, ...}")?;
    if let Some(unknown) = groups.keys().find(|k| *k != TIME && !GROUPS.contains(&k.as_str())) {
        let known = GROUPS.into_iter().chain([TIME]);
        return Err(format!(": unknown key `{unknown}`{}", suggest::help(unknown, known)));
    }
    let mut state = State::default();
    if let Some(time) = groups.get(TIME) {
        let seconds = time.as_f64().filter(|t| t.is_finite());
        state.t = seconds.ok_or_else(|| format!(".{TIME}: expected a number of seconds, found {time}"))?;
    }
    let lists = [&mut state.q, &mut state.u, &mut state.inputs, &mut state.u_dot, &mut state.parameters];
    for (name, list) in GROUPS.into_iter().zip(lists) {
        *list = match groups.get(name) {
            None => Vec::new(),
            Some(Value::Object(numbers)) => named_numbers(numbers).map_err(|m| format!(".{name}{m}"))?,
            Some(_) => return Err(format!(".{name}: expected an object {{name: number, ...}}")),
        };
    }
    Ok(state)
}

fn named_numbers(numbers: &Map<String, Value>) -> Result<Vec<(String, f64)>, String> {
    let number = |(name, value): (&String, &Value)| match value.as_f64() {
        Some(x) if x.is_finite() => Ok((name.clone(), x)),
        _ => Err(format!(".{name}: expected a number, found {value}")),
    };
    let mut list = Vec::with_capacity(numbers.len());
    for entry in numbers {
        list.push(number(entry)?);
    }
    Ok(list)
}

/// Names of all parameters that any state names, in the model's order.
///
/// # Errors
/// [`Failure::Wrong`] for a name that the model does not have.
pub fn parameters(states: &[State], model: &Model) -> Result<Vec<String>, Failure> {
    let known: Vec<&str> = model.parameters.iter().map(|p| p.name.as_str()).collect();
    let mut named = std::collections::BTreeSet::new();
    for (n, state) in states.iter().enumerate() {
        for (name, value) in &state.parameters {
            if let Some(message) = model.refuses(name, *value) {
                return Err(Failure::Wrong(format!("states[{n}].parameters: {message}")));
            }
            if !known.contains(&name.as_str()) {
                let help = suggest::help(name, known);
                let model = &model.name;
                return Err(Failure::Wrong(format!(
                    "states[{n}].parameters: `{model}` has no parameter `{name}`{help}"
                )));
            }
            named.insert(name.as_str());
        }
    }
    Ok(known.into_iter().filter(|name| named.contains(name)).map(str::to_owned).collect())
}

impl State {
    /// The numbers in the program's order; `closed` are the names and units of coordinates in closed form.
    ///
    /// # Errors
    /// A name that does not belong to its group; an omitted independent coordinate.
    pub fn resolve(
        &self,
        model: &Model,
        program: &Program,
        (closed, configurations): (&[(String, String)], &Configurations),
    ) -> Result<Given, String> {
        let states = program.q.iter().map(|q| q.name.as_str());
        let all: Vec<&str> = states.chain(closed.iter().map(|(name, _)| name.as_str())).collect();
        let mut q = place(&self.q, &all, "q", "coordinate")?;
        let closed = q.split_off(program.q.len());
        for (i, value) in q.iter().enumerate() {
            if value.is_none() && configurations.is_independent(i) {
                let name = &program.q[i].name;
                return Err(format!("q: the independent coordinate `{name}` is left out"));
            }
        }
        if let Some((name, _)) = self.u.iter().find(|(name, _)| {
            program.speeds.iter().any(|(s, _)| s == name) && !program.u.iter().any(|u| u.name == *name)
        }) {
            let independent: Vec<&str> = program.u.iter().map(|u| u.name.as_str()).collect();
            return Err(format!(
                "u: the speed `{name}` is dependent: it follows from {}",
                independent.join(", ")
            ));
        }
        if program.u_dot.is_empty() && !self.u_dot.is_empty() {
            return Err("u_dot: no answer that was asked for takes accelerations; expected `--answers inverse_dynamics`, \
                        or no \"u_dot\""
                .to_owned());
        }
        let mut u_dot = place(&self.u_dot, &names(&program.u), "u_dot", "independent speed")?;
        u_dot.truncate(program.u_dot.len());
        let or_default = |values: Vec<Option<f64>>, list: &[Quantity]| -> Vec<f64> {
            values.iter().zip(list).map(|(v, quantity)| v.unwrap_or(quantity.value)).collect()
        };
        Ok(Given {
            q,
            closed,
            u: place(&self.u, &names(&program.u), "u", "independent speed")?,
            inputs: or_default(
                place(&self.inputs, &names(&program.inputs), "inputs", "input")?,
                &program.inputs,
            ),
            u_dot: or_default(u_dot, &program.u_dot),
            parameters: self.values_of_parameters(model, program)?,
        })
    }

    /// Values of the program's parameters: those that the model states as expressions of given ones follow.
    fn values_of_parameters(&self, model: &Model, program: &Program) -> Result<Vec<f64>, String> {
        if self.parameters.is_empty() {
            return Ok(program.parameters.iter().map(|p| p.value).collect());
        }
        let changed = model.with_values(&self.parameters.iter().cloned().collect()).map_err(|found| {
            let all: Vec<&str> = found.items.iter().map(|item| item.message.as_str()).collect();
            format!("parameters: {}", all.join("; "))
        })?;
        let values: BTreeMap<&str, f64> = changed
            .parameters
            .iter()
            .map(|p| p.name.as_str())
            .zip(changed.parameter_defaults().iter().copied())
            .collect();
        Ok(program
            .parameters
            .iter()
            .map(|p| values.get(p.name.as_str()).copied().unwrap_or(p.value))
            .collect())
    }
}

fn names(list: &[Quantity]) -> Vec<&str> {
    list.iter().map(|x| x.name.as_str()).collect()
}

/// The values of named numbers, in the order of `list`.
fn place(
    named: &[(String, f64)],
    list: &[&str],
    group: &str,
    kind: &str,
) -> Result<Vec<Option<f64>>, String> {
    let mut values = vec![None; list.len()];
    for (name, value) in named {
        let Some(index) = list.iter().position(|x| x == name) else {
            let help = suggest::help(name, list.iter().copied());
            return Err(format!("{group}: the model has no {kind} `{name}`{help}"));
        };
        values[index] = Some(*value);
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_named() {
        let cases = [
            ("[]", "there is no \"states\""),
            ("{\"states\": 3}", "no list"),
            ("{\"states\": [3]}", "states[0]: expected an object"),
            ("{\"states\": [{}, {\"Q\": {}}]}", "states[1]: unknown key `Q`"),
            ("{\"states\": [{\"q\": []}]}", "states[0].q: expected an object"),
            ("{\"states\": [{\"u\": {\"a\": \"1\"}}]}", "states[0].u.a: expected a number, found \"1\""),
            ("{\"states\": [{\"u\": {\"a\": 1e999}}]}", "not JSON"),
            ("{\"states\":\n x}", "line 2"),
        ];
        for (text, message) in cases {
            let found = parse(text).expect_err(text);
            assert!(found.contains(message), "{text}: {found}");
        }
    }

    #[test]
    fn every_digit_is_read() {
        // Half an ulp matters here: a fast parser may miss the nearest double.
        let text = "{\"states\": [{\"q\": {\"a\": 1.7976931348623157e308, \"b\": 0.1000000000000000055}}]}";
        let states = parse(text).expect("valid");
        assert_eq!(states[0].q, [("a".to_owned(), f64::MAX), ("b".to_owned(), 0.1)]);
    }
}
