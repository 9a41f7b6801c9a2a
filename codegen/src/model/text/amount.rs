//! Bounds the number of values in a text before any is read: a parser takes some 200 bytes for each, and `1,` takes
//! two.

/// An upper bound of the number of values, keys and lines of a TOML or JSON text: each of them has a mark of its own.
#[must_use]
pub fn marks(text: &str) -> usize {
    let (mut count, mut rest) = (0, text.as_bytes());
    while let Some(byte) = rest.first() {
        rest = match byte {
            b'"' | b'\'' => behind_string(rest),
            b'#' => rest.iter().position(|b| *b == b'\n').map_or(&[], |end| &rest[end..]),
            _ => {
                count += usize::from(matches!(byte, b',' | b'[' | b'{' | b'=' | b'\n'));
                &rest[1..]
            }
        };
    }
    count
}

/// The text after a quoted string. An unclosed string ends with its line, one in triple quotes with the text.
fn behind_string(text: &[u8]) -> &[u8] {
    let quote = text[0];
    let (long, escapes) = (text.starts_with(&[quote; 3]), quote == b'"');
    let mut at = if long { 3 } else { 1 };
    while let Some(byte) = text.get(at) {
        match *byte {
            b'\\' if escapes => at += 1,
            b'\n' if !long => return &text[at..],
            _ if *byte == quote && !long => return &text[at + 1..],
            _ if *byte == quote && text[at..].starts_with(&[quote; 3]) => return &text[at + 3..],
            _ => {}
        }
        at += 1;
    }
    &[]
}

#[cfg(test)]
mod tests {
    use super::marks;

    #[test]
    fn what_stands_in_quotes_and_comments_is_no_mark() {
        assert_eq!(marks("a = [1, 2, [3]]"), 5);
        assert_eq!(marks("a = \"1,2\\\",3\", b # c, d, e\nf = 'g,\\', 1"), 5);
        assert_eq!(marks("a = \"\"\"b, \"\" c,\n\"\"\", d = '''e,'f,''',"), 4);
        assert_eq!(marks("a = \"open, ,\nb, \"\"\" for, ever"), 3);
        assert_eq!(marks("{\"x\": [0, 1.5]}"), 3);
        assert_eq!(marks("\"\\"), 0);
    }
}
