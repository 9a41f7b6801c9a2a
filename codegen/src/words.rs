//! Wording shared by messages and by comments in generated code.

/// A number with what it counts: "1 speed", "2 speeds", "0 entries".
#[must_use]
pub fn count(n: impl std::fmt::Display, noun: &str) -> String {
    let n = n.to_string();
    match (n == "1", noun.strip_suffix('y')) {
        (true, _) => format!("{n} {noun}"),
        (false, Some(stem)) => format!("{n} {stem}ies"),
        (false, None) if noun.ends_with("ch") => format!("{n} {noun}es"),
        (false, None) => format!("{n} {noun}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::count;

    #[test]
    fn nouns_follow_their_numbers() {
        assert_eq!(count(1, "speed") + ", " + &count(2_u64, "speed"), "1 speed, 2 speeds");
        assert_eq!(count(0, "entry") + ", " + &count(1, "entry"), "0 entries, 1 entry");
        assert_eq!(count(3, "touch"), "3 touches");
    }
}
