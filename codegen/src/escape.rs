//! Escapes text of other authors for the place where it is shown; one function for each kind of place.
//!
//! In: any text, such as a model's description, a file name or a command. Out: text that its place can read only as
//! words: no line break ends the comment around it, no invisible character hides or reorders what a reader sees, and
//! in Markdown nothing becomes code, link or markup.

/// Text for a single line, as in a comment: line breaks, invisible characters and marks that change the writing
/// direction are replaced by their code points, such as `U+000A`.
#[must_use]
pub fn line(text: &str) -> String {
    if text.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        return text.to_owned();
    }
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        if is_unseen(c) { shown.push_str(&number(c)) } else { shown.push(c) }
    }
    shown
}

/// Text of several lines, each made fit by [`line()`].
#[must_use]
pub fn lines(text: &str) -> String {
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Text as plain text in Markdown, on one line; documentation comments are Markdown too.
///
/// White space shrinks to single spaces: a block indented by four would be code, and the code of a documentation
/// comment is compiled and run as a test.
#[must_use]
pub fn markdown(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    let text = words.join(" ");
    let mut shown = String::with_capacity(text.len());
    let mut before: Option<char> = None;
    let mut letters = text.chars().peekable();
    while let Some(c) = letters.next() {
        // Most of a text, and never markup.
        if c.is_ascii_alphanumeric() || c == ' ' {
            shown.push(c);
            before = Some(c);
            continue;
        }
        let next = letters.peek().copied();
        let inside_word =
            || before.is_some_and(char::is_alphanumeric) && next.is_some_and(char::is_alphanumeric);
        let is_markup = match c {
            '\\' | '`' | '*' | '[' | '|' | '~' => true,
            '<' => next.is_some_and(|c| c.is_ascii_alphabetic() || "/!?".contains(c)),
            '&' => next.is_some_and(|c| c.is_ascii_alphabetic() || c == '#'),
            '_' => !inside_word(),
            '#' | '>' | '/' => before.is_none(),
            '-' | '+' => before.is_none() && next == Some(' '),
            _ => false,
        };
        match c {
            c if is_unseen(c) => shown.push_str(&number(c)),
            c if is_markup => shown.extend(['\\', c]),
            c => shown.push(c),
        }
        before = Some(c);
    }
    shown
}

/// Text as a code span on one line of Markdown, fenced by more back ticks than it holds in a row.
#[must_use]
pub fn markdown_code(text: &str) -> String {
    let text = line(text);
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    // A space keeps back ticks at the ends apart from the fence; Markdown takes it off again.
    let space = if text.starts_with('`') || text.ends_with('`') { " " } else { "" };
    format!("{fence}{space}{text}{space}{fence}")
}

/// Does the character end a line, is it invisible, or does it change the writing direction?
#[must_use]
pub fn is_unseen(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

fn number(c: char) -> String {
    format!("U+{:04X}", u32::from(c))
}

#[cfg(test)]
mod tests {
    use super::{line, lines, markdown, markdown_code};

    #[test]
    fn a_line_stays_one() {
        assert_eq!(line("a\nb\r\u{2028}c\u{202e}d\u{1b}[2J"), "aU+000AbU+000DU+2028cU+202EdU+001B[2J");
        assert_eq!(lines("a\n\tb\r\n"), "a\nU+0009bU+000D\n");
        assert_eq!(line("Länge l_1 in mm, κ ≥ 0"), "Länge l_1 in mm, κ ≥ 0");
    }

    #[test]
    fn markdown_shows_the_text_as_it_stands() {
        assert_eq!(markdown("  a\n    b\t c  "), "a b c");
        assert_eq!(markdown("```\nx\n```"), r"\`\`\` x \`\`\`");
        assert_eq!(markdown(r"<b> \<b> [x](y) a*b |"), r"\<b> \\\<b> \[x](y) a\*b \|");
        assert_eq!(markdown("of u_hA, _so_"), r"of u_hA, \_so\_");
        assert_eq!([markdown("<= 5"), markdown("&lt; & <!"), markdown("-")], ["<= 5", r"\&lt; & \<!", "-"]);
        assert_eq!([markdown("- a"), markdown("-> a")], [r"\- a", "-> a"]);
        assert_eq!([markdown("# a"), markdown("/ a"), markdown("x - a")], [r"\# a", r"\/ a", "x - a"]);
        assert_eq!(markdown("\u{202e}\u{0}"), "U+202EU+0000");
    }

    #[test]
    fn code_has_a_fence_of_its_own() {
        assert_eq!(markdown_code("a b"), "`a b`");
        assert_eq!(markdown_code("a``b`"), "``` a``b` ```");
        assert_eq!(markdown_code("a\n|"), "`aU+000A|`");
    }
}
