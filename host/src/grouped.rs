//! Groups similar findings: a chain of 40 loops has 81 redundant constraints but needs one warning.
//!
//! In: findings with their places. Out: the text of the first of each group, and the names of the others. With `all`
//! every finding is shown. Findings belong to one group if their messages differ only in names and numbers.

use crate::diagnostics;
use crate::output::{self, Stream};
use smartbed_codegen::Diagnostics;
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_codegen::words::count;

/// Largest number of names listed for findings that are not shown.
const NAMED: usize = 6;

/// The text.
#[must_use]
pub fn text(found: &Diagnostics, to: Stream, all: bool) -> String {
    if all {
        return diagnostics::text(found, to);
    }
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
        text += &diagnostics::text(&Diagnostics::one(found.source.clone(), (*first).clone()), to);
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

/// The same for warnings without a place.
#[must_use]
pub fn lines(warnings: &[String], to: Stream, all: bool) -> String {
    let mut kinds: Vec<(String, &String, usize)> = Vec::new();
    for warning in warnings {
        let kind = if all { warning.clone() } else { kind(warning) };
        match kinds.iter_mut().find(|(known, ..)| *known == kind) {
            Some((.., more)) => *more += 1,
            None => kinds.push((kind, warning, 0)),
        }
    }
    let line = |(_, first, more): &(String, &String, usize)| {
        let more =
            if *more > 0 { format!("\n  = and {more} more of this kind: --all") } else { String::new() };
        output::tinted(&format!("warning: {first}{more}\n"), output::has_colour(to))
    };
    kinds.iter().map(line).collect()
}

/// The first quoted name in a message, with its quotes.
fn name(message: &str) -> Option<&str> {
    let from = message.find('`')?;
    let length = message[from + 1..].find('`')?;
    message.get(from..from + length + 2)
}

/// The message without quoted names and without numbers, which identifies its group.
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
        let text = super::text(&found, Stream::Out, false);
        assert_eq!(text.matches("warning: ").count(), 2, "{text}");
        assert!(
            text.contains("`loop0` follows") && text.contains("80 more findings of this kind: `loop1`, "),
            "{text}"
        );
        assert!(text.contains("`k` is never used"), "{text}");
        assert_eq!(super::text(&found, Stream::Out, true).matches("warning: ").count(), 82);
    }

    #[test]
    fn numbers_alone_make_no_new_kind() {
        let warnings = ["the pivot `a` falls to 1.0e-3", "the pivot `b + c` falls to 2.0e-3", "rank is lost"];
        let warnings = warnings.map(str::to_owned);
        let told = lines(&warnings, Stream::Out, false);
        assert_eq!(
            told,
            "warning: the pivot `a` falls to 1.0e-3\n  = and 1 more of this kind: --all\nwarning: rank is lost\n"
        );
        assert_eq!(lines(&warnings, Stream::Out, true).matches("warning: ").count(), 3);
    }
}
