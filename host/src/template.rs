//! Fills in a page's template: each `@NAME@` is replaced by a part.
//!
//! In: the template, and parts by name in the page's order. Out: the page. Each part is inserted once, and its text is
//! not searched for further placeholders: a title `@DATA@` remains a title.

/// The template with its parts inserted.
#[must_use]
pub fn filled(template: &str, parts: &[(&str, String)]) -> String {
    let (mut done, mut rest) = (String::new(), template);
    for (name, part) in parts {
        let found = rest.split_once(&format!("@{name}@"));
        debug_assert!(found.is_some(), "the template has no @{name}@ behind the part before it");
        let (before, after) = found.unwrap_or((rest, ""));
        done += before;
        done += part;
        rest = after;
    }
    done + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_not_looked_through() {
        let parts = [("TITLE", "@DATA@".to_owned()), ("DATA", "[1]".to_owned())];
        assert_eq!(filled("<h1>@TITLE@</h1><p>@DATA@</p>", &parts), "<h1>@DATA@</h1><p>[1]</p>");
    }
}
