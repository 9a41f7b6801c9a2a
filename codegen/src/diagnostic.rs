//! Errors and warnings with a place: collected per stage, rendered with the source excerpt.
//!
//! In: a [`Source`] and [`Span`]s of it. Out: text in the layout of compilers: message, `file:line:column`, the line, a
//! caret under the place with a label, and help.
//! Invariants: rendering never fails, whatever the spans; no character of a model can move the terminal's cursor.

use std::fmt;

use crate::escape;
use crate::source::{Source, Span};

/// How bad it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Severity {
    /// The model cannot be used.
    Error,
    /// The model can be used, but is probably not what its author meant.
    Warning,
}

/// A place with what is to be said about it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// What is there.
    pub text: String,
}

/// One error or warning.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// Error or warning.
    pub severity: Severity,
    /// What is wrong.
    pub message: String,
    /// Where; the first label is the primary one.
    pub labels: Vec<Label>,
    /// What was expected and what to do.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error without a place yet.
    #[must_use]
    pub fn error(message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, message: message.into(), labels: Vec::new(), help: None }
    }

    /// A warning without a place yet.
    #[must_use]
    pub fn warning(message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(message) }
    }

    /// Adds a place; the first one added is the primary one.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// A stage reports at most this many findings.
const MOST_ITEMS: usize = 100;

/// Everything a stage found, with the text it is about.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Diagnostics {
    /// The text that the places refer to.
    pub source: Source,
    /// What was found, in order of discovery.
    pub items: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Nothing found yet.
    #[must_use]
    pub fn new(source: Source) -> Self {
        Self { source, items: Vec::new() }
    }

    /// A single finding.
    #[must_use]
    pub fn one(source: Source, item: Diagnostic) -> Self {
        Self { source, items: vec![item] }
    }

    /// Adds a finding, unless one with the same primary place is there already: a mistake inside
    /// a repeated sub-assembly is made once and reported once.
    pub fn push(&mut self, item: Diagnostic) {
        if MOST_ITEMS <= self.items.len() {
            return;
        }
        let place = item.labels.first().map(|l| l.span);
        let known = |other: &Diagnostic| {
            place.is_some()
                && other.severity == item.severity
                && other.labels.first().map(|l| l.span) == place
        };
        if !self.items.iter().any(known) {
            self.items.push(item);
        }
    }

    /// Is there an error among the findings?
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.items.iter().any(|d| d.severity == Severity::Error)
    }

    /// Ends a stage: its value if no error was found, else all findings.
    ///
    /// # Errors
    /// All findings, if one of them is an error.
    pub fn finish<T>(self, value: T) -> Result<T, Self> {
        if self.has_errors() { Err(self) } else { Ok(value) }
    }
}

impl std::error::Error for Diagnostics {}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, item) in self.items.iter().enumerate() {
            if 0 < i {
                writeln!(f)?;
            }
            render(f, &self.source, item)?;
        }
        Ok(())
    }
}

/// Longest part of a source line that is shown, in characters.
const EXCERPT: usize = 160;

fn render(f: &mut fmt::Formatter<'_>, source: &Source, item: &Diagnostic) -> fmt::Result {
    let severity = match item.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    writeln!(f, "{severity}: {}", escape::lines(&item.message))?;
    let lines = item.labels.iter().map(|l| source.line_column(l.span).0);
    let width = lines.max().unwrap_or(1).to_string().len();
    let (mut previous, mut previous_line) = (None, 0);
    for (i, label) in item.labels.iter().enumerate() {
        let (line, column) = source.line_column(label.span);
        let Some(file) = source.files.get(label.span.file as usize) else { continue };
        if previous != Some(label.span.file) {
            let arrow = if i == 0 { "-->" } else { ":::" };
            writeln!(f, "{:width$}{arrow} {}:{line}:{column}", " ", escape::line(&file.path))?;
            writeln!(f, "{:width$} |", " ")?;
            previous = Some(label.span.file);
            previous_line = 0;
        }
        let text: Vec<char> = file.text.lines().nth(line - 1).unwrap_or("").chars().collect();
        let first = (column - 1).saturating_sub(EXCERPT / 2);
        // Replaces a character by exactly one other, so that the carets stay below the place they mark.
        let visible = |c: char| match c {
            '\t' => ' ',
            c if escape::is_unseen(c) => char::REPLACEMENT_CHARACTER,
            c => c,
        };
        let shown: String = text.iter().skip(first).take(EXCERPT).map(|&c| visible(c)).collect();
        let shown = match first {
            0 => shown,
            _ => format!("...{}", shown.chars().skip(3).collect::<String>()),
        };
        if line != previous_line {
            writeln!(f, "{line:width$} | {}", shown.trim_end())?;
            previous_line = line;
        }
        let to_line_end = (text.len() + 1).saturating_sub(column).max(1);
        let length = characters(&file.text, label.span).clamp(1, to_line_end.min(EXCERPT / 2));
        let caret = if i == 0 { "^" } else { "-" };
        let marks = format!("{}{}", " ".repeat(column - 1 - first), caret.repeat(length));
        writeln!(f, "{:width$} | {}", " ", format!("{marks} {}", escape::lines(&label.text)).trim_end())?;
    }
    match &item.help {
        Some(help) => writeln!(f, "{:width$} = help: {}", " ", escape::lines(help)),
        None => Ok(()),
    }
}

/// Number of characters in a span.
fn characters(text: &str, span: Span) -> usize {
    text.get(span.start..span.end).map_or(1, |s| s.chars().count())
}
