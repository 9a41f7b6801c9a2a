//! One evaluated state as JSON, with the names of the program and 17 significant digits.

use crate::number::{json_number, json_object};
use smartbed_codegen::program::Quantity;
use smartbed_codegen::program::answer::{Part, Shape};
use smartbed_codegen::{Program, words};

/// Most outputs that are named; more are counted.
const NAMED: usize = 4;

/// All results of one state.
pub(super) struct Evaluated {
    pub t: f64,
    pub q: Vec<f64>,
    /// Value and rate of every coordinate in closed form, one after the other.
    pub closed: Vec<f64>,
    pub u: Vec<f64>,
    pub q_dot: Vec<f64>,
    pub u_dot: Vec<f64>,
    pub pivot: f64,
    /// Correction that returns the speeds to the constraints, if all of them are state.
    pub speed_correction: Vec<f64>,
    pub energy: [f64; 2],
    pub speeds: Vec<f64>,
    pub outputs: Vec<f64>,
    pub residual: f64,
    /// Answers on request, part by part.
    pub asked: Vec<f64>,
    /// Power of the drive.
    pub drive: f64,
}

impl Evaluated {
    /// What is said of the first group that contains a NaN or an infinity; outputs are named.
    pub fn not_finite(&self, program: &Program) -> Option<String> {
        let outputs = program.outputs.iter().map(|(name, _)| name.as_str()).zip(&self.outputs);
        let outputs = outputs.filter(|(_, value)| !value.is_finite());
        let named: Vec<String> = outputs.map(|(name, value)| format!("`{name}` = {value}")).collect();
        let lists: [(&str, &[f64]); 8] = [
            ("a coordinate in closed form", &self.closed),
            ("q_dot", &self.q_dot),
            ("u_dot", &self.u_dot),
            ("energy", &self.energy),
            ("a speed", &self.speeds),
            ("the constraint residual", std::slice::from_ref(&self.residual)),
            ("an answer", &self.asked),
            ("the power of the drive", std::slice::from_ref(&self.drive)),
        ];
        if let Some((what, _)) = lists.into_iter().find(|(_, list)| list.iter().any(|x| !x.is_finite())) {
            return Some(format!(
                "{what} is not finite: the configuration is singular, a number too large, or a derivative does not exist there"
            ));
        }
        (!named.is_empty()).then(|| {
            format!(
                "outputs are not finite: {}; something they are divided by is 0, a function has no value there, \
                 or a number is too large",
                words::first_of(&named, NAMED)
            )
        })
    }

    /// Appends `{"q": ..., "u": ..., ...}`.
    pub fn write(
        &self,
        program: &Program,
        closed: &[(String, String)],
        answers: &[String],
        text: &mut String,
    ) {
        let quantities = |list: &[Quantity], values: &[f64]| {
            json_object(list.iter().map(|x| x.name.as_str()).zip(values.iter().copied()))
        };
        // All coordinates: the state, then those in closed form.
        let coordinates = |values: &[f64], first: usize| {
            let state = program.q.iter().map(|x| x.name.as_str()).zip(values.iter().copied());
            let closed = closed.iter().map(|(name, _)| name.as_str());
            json_object(state.chain(closed.zip(self.closed.iter().skip(first).step_by(2).copied())))
        };
        let named = |list: &[(String, _)], values: &[f64]| {
            json_object(list.iter().map(|(name, _)| name.as_str()).zip(values.iter().copied()))
        };
        // Time is written only if it is not 0.
        let time = (self.t != 0.0).then(|| format!("\"t\": {}", json_number(self.t)));
        let mut parts: Vec<String> = time.into_iter().collect();
        parts.push(format!("\"q\": {}", coordinates(&self.q, 0)));
        parts.push(format!("\"u\": {}", quantities(&program.u, &self.u)));
        for answer in answers {
            match answer.as_str() {
                "rates" => {
                    parts.push(format!("\"q_dot\": {}", coordinates(&self.q_dot, 1)));
                    parts.push(format!("\"u_dot\": {}", quantities(&program.u, &self.u_dot)));
                    parts.push(format!("\"worst_pivot\": {}", json_number(self.pivot)));
                }
                "energy" => {
                    let energy = ["kinetic", "potential"].into_iter().zip(self.energy);
                    parts.push(format!("\"energy\": {}", json_object(energy)));
                }
                "speeds" => parts.push(format!("\"speeds\": {}", named(&program.speeds, &self.speeds))),
                "outputs" => parts.push(format!("\"outputs\": {}", named(&program.outputs, &self.outputs))),
                "projection" => {
                    parts.push(format!("\"constraint_residual\": {}", json_number(self.residual)));
                }
                "speed_projection" => {
                    parts.push(format!(
                        "\"speed_correction\": {}",
                        quantities(&program.u, &self.speed_correction)
                    ));
                }
                "drive" => parts.push(format!("\"drive\": {}", json_number(self.drive))),
                name => parts.extend(self.on_request(program, name)),
            }
        }
        text.push_str(&format!("  {{{}}}", parts.join(", ")));
    }

    /// `"pose:tool": {"position": {"x": 1, ...}, "rotation": [[...], ...]}`.
    fn on_request(&self, program: &Program, name: &str) -> Option<String> {
        let mut first = 0;
        for answer in program.answers_of(program.functions.first()?) {
            let all: usize = answer.parts.iter().map(|part| part.values.len()).sum();
            let mut values = self.asked.get(first..first + all)?;
            first += all;
            if answer.name != name {
                continue;
            }
            let parts = answer.parts.iter().map(|part| {
                let (own, rest) = values.split_at(part.values.len());
                values = rest;
                format!("\"{}\": {}", part.name, json_part(part, own))
            });
            return Some(format!("\"{name}\": {{{}}}", parts.collect::<Vec<_>>().join(", ")));
        }
        None
    }
}

/// A number, a list by the names of its entries, or the rows of a matrix.
fn json_part(part: &Part, values: &[f64]) -> String {
    let list = |values: &[f64]| {
        let numbers: Vec<String> = values.iter().map(|&x| json_number(x)).collect();
        format!("[{}]", numbers.join(", "))
    };
    match part.shape {
        Shape::Number => json_number(values[0]),
        Shape::List(n) if part.labels.is_empty() && n > 0 => list(values),
        Shape::List(_) => json_object(part.labels.iter().map(String::as_str).zip(values.iter().copied())),
        Shape::Matrix(_, columns) => {
            let rows: Vec<String> = values.chunks(columns.max(1)).map(list).collect();
            format!("[{}]", rows.join(", "))
        }
    }
}
