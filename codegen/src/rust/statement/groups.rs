//! Declares the values of a long function in groups.
//!
//! In: statements, one per line, `let x = ..;` or `let (sin_x, cos_x) = ..;`. Out: the same operations in the same
//! order, as assignments to names that one `let (x, y, ..);` declares for many statements at once.

/// Statements in a group.
const GROUP: usize = 64;
/// Most characters of a line of names.
const WIDTH: usize = 110;
const LET: &str = "    let ";

/// The statements with one declaration for each group.
pub(super) fn declared_in_groups(statements: &str) -> String {
    let mut text = String::with_capacity(statements.len());
    let lines: Vec<&str> = statements.lines().collect();
    let mut rest = lines.as_slice();
    while !rest.is_empty() {
        let (group, others) = rest.split_at(end_of_group(rest));
        declare(&mut text, group);
        for line in group {
            text += match line.strip_prefix(LET) {
                Some(_) => "    ",
                None => "",
            };
            text += line.strip_prefix(LET).unwrap_or(line);
            text.push('\n');
        }
        rest = others;
    }
    text
}

/// Number of lines up to the last statement of a group.
fn end_of_group(lines: &[&str]) -> usize {
    let mut statements = lines.iter().enumerate().filter(|(_, line)| line.starts_with(LET));
    statements.nth(GROUP - 1).map_or(lines.len(), |(place, _)| place + 1)
}

/// `let (x, y, ..);` of the names that the lines give values to.
fn declare(text: &mut String, lines: &[&str]) {
    let patterns = lines.iter().filter_map(|line| line.strip_prefix(LET)?.split_once(" = "));
    let names = patterns.flat_map(|(pattern, _)| pattern.split(|c: char| "[(, )]".contains(c)));
    let names: Vec<&str> = names.filter(|name| !name.is_empty() && *name != "_").collect();
    if names.is_empty() {
        return;
    }
    *text += "    let (\n";
    let mut line = String::from("       ");
    for name in names {
        if line.len() + name.len() > WIDTH {
            *text += &line;
            text.push('\n');
            line = String::from("       ");
        }
        line.push(' ');
        line += name;
        line.push(',');
    }
    *text += &line;
    *text += "\n    );\n";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_operations_stay_as_they_are() {
        let lines = [
            "    // Motion.",
            "    let x = q[0];",
            "    let (sin_x, _) = Real::sin_cos(x);",
            "    u_dot[0] = sin_x;",
        ];
        let text = declared_in_groups(&(lines.join("\n") + "\n"));
        let expected = "    let (\n        x, sin_x,\n    );\n    // Motion.\n    x = q[0];\n    (sin_x, _) = Real::sin_cos(x);\n    \
                        u_dot[0] = sin_x;\n";
        assert_eq!(text, expected);
        let many: String = (0..GROUP + 1).map(|i| format!("    let t{i} = q[{i}];\n")).collect();
        assert_eq!(declared_in_groups(&many).matches("let (").count(), 2);
    }
}
