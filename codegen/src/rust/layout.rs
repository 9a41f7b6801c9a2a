//! Lines of emitted items: lists stand on one line where they fit, else one element a line; whole numbers and truth
//! values share lines.

/// Columns of a line.
const WIDTH: usize = 89;

/// Of a function that nobody reads line by line.
pub(super) const STRAIGHT_LINE: &str = "\
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = \"generated straight-line arithmetic\"
)]
#[must_use]
";
/// Of structs whose fields are the model's.
pub(super) const PLAIN_STRUCT: &str = "\
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(non_snake_case, reason = \"names are the model's\")]
";

/// `head[a, b];`
pub(super) fn array(head: &str, elements: &[String]) -> String {
    list(head, ('[', ']'), elements, ";", "")
}

/// `head(a, b) -> output {`
pub(super) fn signature(head: &str, arguments: &[String], output: &str, indent: &str) -> String {
    list(head, ('(', ')'), arguments, &format!(" -> {output} {{"), indent)
}

fn list(head: &str, (open, close): (char, char), elements: &[String], tail: &str, indent: &str) -> String {
    let line = format!("{indent}{head}{open}{}{close}{tail}\n", elements.join(", "));
    if line.chars().count() <= WIDTH + 1 {
        return line;
    }
    let elements: String = if elements.iter().any(|element| element.contains(['"', '.', ':', ' '])) {
        elements.iter().map(|element| format!("{indent}    {element},\n")).collect()
    } else {
        filled(elements, &format!("{indent}    "))
    };
    format!("{indent}{head}{open}\n{elements}{indent}{close}{tail}\n")
}

/// As many elements a line as fit.
fn filled(elements: &[String], indent: &str) -> String {
    let mut text = String::new();
    let mut column = 0;
    for element in elements {
        if column > 0 && column + element.len() + 2 <= WIDTH {
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
    let elements: String = elements.into_iter().map(|e| format!("{indent}    {e},\n")).collect();
    if elements.is_empty() {
        return format!("{indent}{head} {{}}\n");
    }
    format!("{indent}{head} {{\n{elements}{indent}}}\n")
}

/// A doc comment; one line a line of the text.
pub(super) fn doc(text: &str) -> String {
    text.lines().map(|line| format!("///{line}\n")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_broken_where_it_does_not_fit() {
        let short: Vec<String> = ["1.", "2."].map(String::from).to_vec();
        assert_eq!(array("const A: [S; 2] = ", &short), "const A: [S; 2] = [1., 2.];\n");
        let head = "h".repeat(WIDTH - "[1., 2.];".len());
        assert_eq!(array(&head, &short).lines().count(), 1);
        assert_eq!(array(&format!("{head}h"), &short), format!("{head}h[\n    1.,\n    2.,\n];\n"));
    }

    #[test]
    fn whole_numbers_share_lines() {
        let many = vec!["1usize".to_owned(); 11];
        let lines = format!("{}1usize,\n    1usize,\n", "1usize, ".repeat(9));
        assert_eq!(
            array("const A: [usize; 11usize] = ", &many),
            format!("const A: [usize; 11usize] = [\n    {lines}];\n")
        );
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
