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

/// The first `most` of a list, separated by commas, and how many more there are.
#[must_use]
pub fn first_of(list: &[String], most: usize) -> String {
    match list.split_at_checked(most) {
        Some((named, others)) if !others.is_empty() => {
            format!("{} and {} more", named.join(", "), others.len())
        }
        _ => list.join(", "),
    }
}

#[cfg(test)]
mod tests {
    use super::{count, first_of};

    #[test]
    fn long_lists_are_cut() {
        let list = ["a", "b", "c"].map(str::to_owned);
        assert_eq!(
            [1, 2, 3, 4].map(|most| first_of(&list, most)),
            ["a and 2 more", "a, b and 1 more", "a, b, c", "a, b, c"]
        );
        assert_eq!(first_of(&[], 2), "");
    }

    #[test]
    fn nouns_follow_their_numbers() {
        assert_eq!(count(1, "speed") + ", " + &count(2_u64, "speed"), "1 speed, 2 speeds");
        assert_eq!(count(0, "entry") + ", " + &count(1, "entry"), "0 entries, 1 entry");
        assert_eq!(count(3, "touch"), "3 touches");
    }
}
