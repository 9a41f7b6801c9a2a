//! Shows errors and warnings with their places in a terminal, with its colours and width.
//!
//! In: the findings of a stage. Out: text in the layout of compilers, by `annotate-snippets`, which knows the widths of
//! letters. Text of a model's author is shown without anything that moves the cursor.

use crate::failure::Failure;
use crate::output::{self, Stream};
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics, Label, Severity};
use smartbed_codegen::escape;
use smartbed_codegen::source::Source;

/// Width in columns if the terminal's is unknown.
const WIDTH: usize = 120;

/// The text of all findings, separated by empty lines.
#[must_use]
pub fn text(found: &Diagnostics, to: Stream) -> String {
    let one = |item: &Diagnostic| render(&found.source, item, to);
    found.items.iter().map(one).collect::<Vec<String>>().join("\n")
}

/// Prints warnings to standard error.
pub fn warn(found: &Diagnostics) {
    if !found.items.is_empty() {
        output::say(text(found, Stream::Error).trim_end());
    }
}

/// Prints why a command has failed.
pub fn fail(failure: &Failure) {
    match failure {
        Failure::Found(found) => output::say(text(found, Stream::Error).trim_end()),
        other => output::say(&format!("error: {other}")),
    }
}

fn render(source: &Source, item: &Diagnostic, to: Stream) -> String {
    let level = match item.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let mut group =
        level.primary_title(escape::lines(&item.message)).elements(snippets(source, &item.labels));
    if let Some(help) = &item.help {
        group = group.element(Level::HELP.message(escape::lines(help)));
    }
    let renderer = if output::has_colour(to) { Renderer::styled() } else { Renderer::plain() };
    let width = output::columns(to).unwrap_or(WIDTH);
    renderer.term_width(width).render(&[group]).to_string() + "\n"
}

/// One excerpt per file, in the order in which labels name them; the first label is the primary one.
fn snippets<'s>(source: &'s Source, labels: &[Label]) -> Vec<Snippet<'s, annotate_snippets::Annotation<'s>>> {
    let mut files: Vec<u32> = labels.iter().map(|label| label.span.file).collect();
    let mut seen = Vec::new();
    files.retain(|file| {
        !seen.contains(file) && {
            seen.push(*file);
            true
        }
    });
    let of_file = |number: u32| {
        let file = source.files.get(number as usize)?;
        let mut snippet = Snippet::source(file.text.as_str()).path(escape::line(&file.path));
        for (n, label) in labels.iter().enumerate().filter(|(_, label)| label.span.file == number) {
            let kind = if n == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
            let span = span(&file.text, label);
            snippet = snippet.annotation(kind.span(span).label(escape::lines(&label.text)));
        }
        Some(snippet)
    };
    files.into_iter().filter_map(of_file).collect()
}

/// The bytes of a label, limited to the text and to one line, extended to whole characters, at least one.
fn span(text: &str, label: &Label) -> std::ops::Range<usize> {
    let whole = |mut at: usize| {
        at = at.min(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let (start, end) = (whole(label.span.start), whole(label.span.end));
    let line = text[start..].find('\n').map_or(text.len(), |n| start + n);
    start..end.clamp(start, line.max(start))
}

#[cfg(test)]
mod tests {
    use super::*;
    use smartbed_codegen::source::Span;

    #[test]
    fn marks_stand_under_wide_letters_and_nothing_moves_the_cursor() {
        let text = "a = 1\n\"漢字\" = \"\u{1b}[31mx\" \u{202e}\n";
        let at = text.find('x').expect("the place");
        let span = Span { start: at, end: at + 1, file: 0 };
        let item = Diagnostic::error("wrong\u{1b}[0m").label(span, "here\r").help("do\u{7}");
        let found = Diagnostics::one(Source::new("m\u{1b}.toml", text), item);
        let shown = super::text(&found, Stream::Error);
        let controls = shown.chars().filter(|c| c.is_control() && *c != '\n').count();
        assert_eq!(controls, 0, "{shown:?}");
        assert!(shown.starts_with("error: wrong") && shown.contains("help: do"), "{shown}");
        // Both letters are two columns wide: the mark is two columns further right than their number suggests.
        let lines: Vec<&str> = shown.lines().collect();
        let mark = lines.iter().position(|line| line.contains("^ here")).expect("a mark");
        let column = |line: &str, c: char| line.split(c).next().map_or(0, |part| part.chars().count());
        assert_eq!(column(lines[mark], '^'), column(lines[mark - 1], 'x') + 2, "{shown}");
    }

    #[test]
    fn places_beyond_the_text_are_at_its_end() {
        let span = Span { start: 900, end: 990, file: 0 };
        let label = Label { span, text: String::new() };
        assert_eq!(super::span("ä", &label), 2..2);
        let lines = Label { span: Span { start: 0, end: 9, file: 0 }, text: String::new() };
        assert_eq!(super::span("ab\ncd", &lines), 0..2);
    }
}
