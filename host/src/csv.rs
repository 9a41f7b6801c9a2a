//! Text of CSV files as RFC 4180 has it.

/// A field in quotes; quotes in it are doubled.
#[must_use]
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

/// A field: in quotes if it contains a comma, a quote or a line break.
#[must_use]
pub fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { quoted(text) } else { text.to_owned() }
}

/// The row of names that a table begins with, with its line break.
#[must_use]
pub fn header<S: AsRef<str>>(names: &[S]) -> String {
    let names: Vec<String> = names.iter().map(|name| field(name.as_ref())).collect();
    names.join(",") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_fields_that_need_quotes_have_them() {
        // Examples of RFC 4180, section 2, rules 5 to 7.
        assert_eq!(header(&["aaa", "b\r\nbb", "ccc"]), "aaa,\"b\r\nbb\",ccc\n");
        assert_eq!(header(&["aaa", "b\"bb", "ccc"]), "aaa,\"b\"\"bb\",ccc\n");
        assert_eq!(header(&["t", "bed[0,0].x"]), "t,\"bed[0,0].x\"\n");
    }
}
