//! Findings of one kind as one: a chain of 40 loops has 81 redundant constraints and one thing to say about them.
//!
//! In: findings with their places. Out: the text of the first of each kind, and how many more there are, by name.
//! Of one kind are findings whose messages differ in names and numbers alone.

use smartbed_codegen::Diagnostics;
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_codegen::words::count;

/// Names listed of those that are not shown.
const NAMED: usize = 6;

/// The text.
#[must_use]
pub fn text(found: &Diagnostics) -> String {
    let mut kinds: Vec<(String, Vec<&Diagnostic>)> = Vec::new();
    for item in &found.items {
        let kind = kind(&item.message);
        match kinds.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, items)) => items.push(item),
            None => kinds.push((kind, vec![item])),
        }
    }
    let mut text = String::new();
    for (_, items) in &kinds {
        let [first, rest @ ..] = items.as_slice() else { continue };
        text += &Diagnostics::one(found.source.clone(), (*first).clone()).to_string();
        if !rest.is_empty() {
            let names: Vec<&str> = rest.iter().filter_map(|d| name(&d.message)).take(NAMED).collect();
            let dots = if rest.len() > names.len() { ", ..." } else { "" };
            text += &format!(
                "  = and {} of this kind: {}{dots}\n",
                count(rest.len(), "more finding"),
                names.join(", ")
            );
        }
    }
    text
}

/// The first name in a message, with its quotes.
fn name(message: &str) -> Option<&str> {
    let from = message.find('`')?;
    let length = message[from + 1..].find('`')?;
    message.get(from..from + length + 2)
}

/// The message without what stands in quotes and without numbers.
fn kind(message: &str) -> String {
    let outside: String = message.split('`').step_by(2).collect();
    outside.chars().filter(|c| !c.is_ascii_digit()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use smartbed_codegen::source::Source;

    #[test]
    fn findings_of_one_kind_are_told_once() {
        let mut found = Diagnostics::new(Source::new("m.toml", "a\n"));
        for n in 0..81 {
            found.push(Diagnostic::warning(format!("`loop{n}` follows from the other {n} and is dropped")));
        }
        found.push(Diagnostic::warning("`k` is never used"));
        let text = text(&found);
        assert_eq!(text.matches("warning: ").count(), 2, "{text}");
        assert!(
            text.contains("`loop0` follows") && text.contains("80 more findings of this kind: `loop1`, "),
            "{text}"
        );
        assert!(text.contains("`k` is never used"), "{text}");
    }
}
