//! Lays out emitted items as rustfmt would: a list stands on one line if it fits, otherwise short elements share lines
//! and long ones have one each.

use std::fmt::Write;

/// Columns of a line, rustfmt's `max_width`.
const WIDTH: usize = 100;
/// Widest list on one line, rustfmt's `array_width`.
const LIST_WIDTH: usize = 60;
/// Widest element that shares a line, rustfmt's `short_array_element_width_threshold`.
const SHORT: usize = 10;

/// Bytes of most short texts, at most.
const ROOM: usize = 128;

/// Attributes of a straight-line function, whose statements stay on one line each, however long.
pub(super) const STRAIGHT_LINE: &str = "\
#[rustfmt::skip]
#[allow(
    dead_code,
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = \"generated straight-line arithmetic\"
)]
#[must_use]
";
/// Attributes of structs whose fields have the model's names.
pub(super) const PLAIN_STRUCT: &str = "\
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(dead_code, non_snake_case, reason = \"names are the model's\")]
";

/// Attribute of items that a program need not use: a constant, a method.
pub(super) const UNREAD: &str = "#[allow(dead_code, reason = \"a program reads what it needs\")]\n";

/// Attribute of a list of numbers, which may contain pi/2.
pub(super) const NUMBERS: &str =
    "#[allow(dead_code, clippy::approx_constant, reason = \"numbers of the model\")]\n";

/// `head[a, b];`
pub(super) fn array(head: &str, elements: &[String], indent: &str) -> String {
    let (joined, inside) = (elements.join(", "), format!("{indent}    "));
    if joined.len() <= LIST_WIDTH {
        return match indent.len() + head.len() + joined.len() + "[];".len() <= WIDTH {
            true => format!("{indent}{head}[{joined}];\n"),
            false => format!("{indent}{}\n{inside}[{joined}];\n", head.trim_end()),
        };
    }
    let elements = match elements.iter().all(|element| element.len() <= SHORT) {
        true => filled(elements, &inside),
        false => elements.iter().flat_map(|element| [&inside, element.as_str(), ",\n"]).collect(),
    };
    format!("{indent}{head}[\n{elements}{indent}];\n")
}

/// `head(a, b) -> output {`
pub(super) fn signature(head: &str, arguments: &[String], output: &str, indent: &str) -> String {
    let line = format!("{indent}{head}({}) -> {output} {{", arguments.join(", "));
    if line.chars().count() <= WIDTH {
        return line + "\n";
    }
    let arguments: String = arguments.iter().map(|argument| format!("{indent}    {argument},\n")).collect();
    format!("{indent}{head}(\n{arguments}{indent}) -> {output} {{\n")
}

/// All elements on one line, otherwise as many per line as fit; rustfmt leaves the last column free.
fn filled(elements: &[String], indent: &str) -> String {
    let line = format!("{indent}{},\n", elements.join(", "));
    if line.len() <= WIDTH + "\n".len() {
        return line;
    }
    let mut text = String::new();
    let mut column = 0;
    for element in elements {
        if column > 0 && column + element.len() + 2 < WIDTH {
            text.push(' ');
            column += 1;
        } else {
            text.push_str(if column > 0 { "\n" } else { "" });
            text.push_str(indent);
            column = indent.len();
        }
        text.push_str(element);
        text.push(',');
        column += element.len() + 1;
    }
    text + "\n"
}

/// `head { a, b }` with one element a line.
pub(super) fn block(head: &str, elements: impl IntoIterator<Item = String>, indent: &str) -> String {
    let mut lines = String::new();
    for element in elements {
        for part in [indent, "    ", &element, ",\n"] {
            lines.push_str(part);
        }
    }
    if lines.is_empty() {
        return format!("{indent}{head} {{}}\n");
    }
    format!("{indent}{head} {{\n{lines}{indent}}}\n")
}

/// As `format!`, with room from the start: pieces are appended one by one, and most texts would grow several times.
pub(super) fn text(arguments: std::fmt::Arguments) -> String {
    let mut text = String::with_capacity(ROOM);
    let _ = text.write_fmt(arguments);
    text
}

/// A doc comment, with one line per line of the text.
pub(super) fn doc(text: &str) -> String {
    let marked = |line: &str| if line.is_empty() { "///\n".to_owned() } else { format!("/// {line}\n") };
    text.lines().map(marked).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_broken_where_it_does_not_fit() {
        let short: Vec<String> = ["1.", "2."].map(String::from).to_vec();
        assert_eq!(array("const A: [S; 2] = ", &short, ""), "const A: [S; 2] = [1., 2.];\n");
        let head = "h".repeat(WIDTH - "[1., 2.];".len());
        assert_eq!(array(&head, &short, "").lines().count(), 1);
        assert_eq!(array(&format!("{head}h = "), &short, ""), format!("{head}h =\n    [1., 2.];\n"));
    }

    #[test]
    fn short_elements_share_lines_and_long_ones_do_not() {
        let many = vec!["1usize".to_owned(); 12];
        let lines = format!("{}1usize,\n        1usize,\n", "1usize, ".repeat(10));
        assert_eq!(array("let a = ", &many, "    "), format!("    let a = [\n        {lines}    ];\n"));
        let long = vec!["1.000000000".to_owned(); 6];
        let lines = "    1.000000000,\n".repeat(6);
        assert_eq!(array("const A = ", &long, ""), format!("const A = [\n{lines}];\n"));
    }

    #[test]
    fn the_last_column_is_taken_by_a_whole_list_only() {
        let lengths = |n: usize| -> Vec<usize> {
            let text = array("let a = ", &vec!["1".to_owned(); n], "    ");
            text.lines().map(str::len).collect()
        };
        // Eight columns of indent, elements of three with their comma and space.
        assert_eq!(lengths(31), [13, 8 + 31 * 3 - 1, 6]);
        assert_eq!(lengths(32), [13, 8 + 30 * 3 - 1, 8 + 2 * 3 - 1, 6]);
        assert_eq!(lengths(61), [13, 97, 97, 10, 6]);
    }

    #[test]
    fn signatures_keep_their_indent() {
        let arguments: Vec<String> = ["&self", "index: usize"].map(String::from).to_vec();
        assert_eq!(signature("fn f", &arguments, "S", "    "), "    fn f(&self, index: usize) -> S {\n");
        let long = "L".repeat(WIDTH);
        let broken = format!("  fn f(\n      &self,\n      index: usize,\n  ) -> {long} {{\n");
        assert_eq!(signature("fn f", &arguments, &long, "  "), broken);
    }
}
