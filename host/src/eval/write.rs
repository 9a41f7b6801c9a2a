//! One evaluated state as JSON, with the names of the program and 17 significant digits.

use crate::number::{json_number, json_object};
use smartbed_codegen::program::Quantity;
use smartbed_codegen::{Answer, Program};

/// Everything known about one state.
pub(super) struct Evaluated {
    pub t: f64,
    pub q: Vec<f64>,
    /// Value and rate of every coordinate in closed form, one after the other.
    pub closed: Vec<f64>,
    pub u: Vec<f64>,
    pub q_dot: Vec<f64>,
    pub u_dot: Vec<f64>,
    pub pivot: f64,
    pub energy: [f64; 2],
    pub speeds: Vec<f64>,
    pub outputs: Vec<f64>,
    pub residual: f64,
    /// Power of the drive.
    pub drive: f64,
}

impl Evaluated {
    /// What is not a number, or infinite.
    pub fn not_finite(&self) -> Option<&'static str> {
        let lists: [(&str, &[f64]); 8] = [
            ("a coordinate in closed form", &self.closed),
            ("q_dot", &self.q_dot),
            ("u_dot", &self.u_dot),
            ("energy", &self.energy),
            ("a speed", &self.speeds),
            ("an output", &self.outputs),
            ("the constraint residual", std::slice::from_ref(&self.residual)),
            ("the power of the drive", std::slice::from_ref(&self.drive)),
        ];
        lists.into_iter().find(|(_, list)| list.iter().any(|x| !x.is_finite())).map(|(name, _)| name)
    }

    /// Appends `{"q": ..., "u": ..., ...}`.
    pub fn write(
        &self,
        program: &Program,
        closed: &[(String, String)],
        answers: &[Answer],
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
        // A state without a time is written as it was given.
        let time = (self.t != 0.0).then(|| format!("\"t\": {}", json_number(self.t)));
        let mut parts: Vec<String> = time.into_iter().collect();
        parts.push(format!("\"q\": {}", coordinates(&self.q, 0)));
        parts.push(format!("\"u\": {}", quantities(&program.u, &self.u)));
        for answer in answers {
            match answer {
                Answer::Rates => {
                    parts.push(format!("\"q_dot\": {}", coordinates(&self.q_dot, 1)));
                    parts.push(format!("\"u_dot\": {}", quantities(&program.u, &self.u_dot)));
                    parts.push(format!("\"worst_pivot\": {}", json_number(self.pivot)));
                }
                Answer::Energy => {
                    let energy = ["kinetic", "potential"].into_iter().zip(self.energy);
                    parts.push(format!("\"energy\": {}", json_object(energy)));
                }
                Answer::Speeds => parts.push(format!("\"speeds\": {}", named(&program.speeds, &self.speeds))),
                Answer::Outputs => {
                    parts.push(format!("\"outputs\": {}", named(&program.outputs, &self.outputs)));
                }
                Answer::Projection => {
                    parts.push(format!("\"constraint_residual\": {}", json_number(self.residual)));
                }
                Answer::Drive => parts.push(format!("\"drive\": {}", json_number(self.drive))),
                // A form of `derive`; the command line does not offer it here.
                Answer::Augmented => {}
            }
        }
        text.push_str(&format!("  {{{}}}", parts.join(", ")));
    }
}
