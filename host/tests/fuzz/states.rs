//! States files: names of the model and others, numbers of all sizes, groups in and out of place.

use crate::random::Random;

/// A model with the names that its states may use.
pub struct Subject {
    pub model: &'static str,
    q: &'static [&'static str],
    others: &'static [&'static str],
}

/// Small models: an open one, one with a loop, one with coordinates in closed form.
pub const SUBJECTS: [Subject; 3] = [
    Subject { model: "pendulum", q: &["q"], others: &["u_q", "m", "l", "c", "g"] },
    Subject { model: "slider_crank", q: &["q", "b", "x"], others: &["u_q", "u_b", "T", "r", "l", "k"] },
    Subject {
        model: "slider_crank_closed",
        q: &["q", "b", "x"],
        others: &["u_q", "u_b", "T", "r", "l", "k"],
    },
];

const NUMBERS: [&str; 14] =
    ["0", "1", "-0.4", "0.2", "2", "1e-300", "3.5", "1e300", "-1e308", "1e400", "\"x\"", "null", "[]", "{}"];
const GROUPS: [&str; 8] = ["q", "u", "inputs", "parameters", "parameters", "inputs", "Q", "states"];
const STRANGE: [&str; 4] = ["", "q ", "\\u0000", "états"];

/// A subject and the text of a states file for it.
pub fn file(random: &mut Random) -> (&'static Subject, String) {
    let subject = &SUBJECTS[random.below(SUBJECTS.len())];
    let mut states = Vec::new();
    for _ in 0..random.below(3) {
        let mut groups = vec![format!("\"q\": {{\"{}\": {}}}", subject.q[0], random.of(&NUMBERS[..6]))];
        for _ in 0..random.below(3) {
            let group = random.of(&GROUPS);
            let entries: Vec<String> = (0..random.below(3)).map(|_| entry(random, subject, group)).collect();
            groups.push(format!("\"{group}\": {{{}}}", entries.join(", ")));
        }
        states.push(format!("{{{}}}", groups.join(", ")));
    }
    let mut text = format!("{{\"states\": [{}]}}", states.join(", "));
    if random.one_in(8) {
        let mut end = random.below(text.len() + 1);
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        text.truncate(end);
    }
    (subject, text)
}

/// A name, most often one that belongs into the group, and a number, most often a small one.
fn entry(random: &mut Random, subject: &Subject, group: &str) -> String {
    let name = match (random.below(8), group) {
        (0, _) => random.of(&STRANGE),
        (1, _) => random.of(subject.others),
        (_, "q") => random.of(subject.q),
        (_, "u") => "u_q",
        (_, "inputs") => "T",
        _ => random.of(&["l", "m", "r", "k", "g"]),
    };
    let number = if random.one_in(4) { random.of(&NUMBERS) } else { random.of(&NUMBERS[..6]) };
    format!("\"{name}\": {number}")
}
