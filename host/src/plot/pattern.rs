//! Selects names by patterns such as `--show 'h*,u_*'`: `*` stands for any letters, `?` for one.

use crate::failure::Failure;
use crate::suggest;

/// The names that match one of the patterns separated by commas, in the names' order. A comma in brackets belongs to a
/// name of a grid (`bed[0,1].x`).
///
/// # Errors
/// [`Failure::Wrong`] for a pattern that matches none.
pub fn chosen<'a>(patterns: &str, names: &[&'a str]) -> Result<Vec<&'a str>, Failure> {
    let mut depth = 0;
    let separates = |c: char| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        c == ',' && depth <= 0
    };
    let patterns: Vec<&str> = patterns.split(separates).map(str::trim).filter(|p| !p.is_empty()).collect();
    if let Some(wrong) = patterns.iter().find(|p| !names.iter().any(|n| fits(p, n))) {
        let help = suggest::help(wrong, names.iter().copied());
        return Err(Failure::Wrong(format!("--show {wrong}: no curve has such a name{help}")));
    }
    Ok(names.iter().copied().filter(|n| patterns.iter().any(|p| fits(p, n))).collect())
}

/// Does the pattern match the whole name? Each `*` first matches as little as possible, then more (backtracking).
fn fits(pattern: &str, name: &str) -> bool {
    let (pattern, name): (Vec<char>, Vec<char>) = (pattern.chars().collect(), name.chars().collect());
    let (mut p, mut n, mut star) = (0, 0, None);
    while n < name.len() {
        match pattern.get(p) {
            Some('*') => {
                star = Some((p, n));
                p += 1;
            }
            Some(c) if *c == '?' || *c == name[n] => (p, n) = (p + 1, n + 1),
            _ => match &mut star {
                Some((at, taken)) => {
                    *taken += 1;
                    (p, n) = (*at + 1, *taken);
                }
                None => return false,
            },
        }
    }
    pattern[p..].iter().all(|c| *c == '*')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_fit_whole_names() {
        for (pattern, name, expected) in [
            ("h*", "hA", true),
            ("h*", "psiA", false),
            ("*A", "psiA", true),
            ("u_*", "u_", true),
            ("*a*b", "xaabxb", true),
            ("*a*b", "xaabx", false),
            ("q?", "q1", true),
            ("q?", "q10", false),
            ("", "q", false),
        ] {
            assert_eq!(fits(pattern, name), expected, "{pattern} {name}");
        }
    }

    #[test]
    fn what_fits_nothing_is_refused() {
        assert_eq!(chosen("h*, u_hA", &["hA", "hB", "u_hA"]), Ok(vec!["hA", "hB", "u_hA"]));
        let grid = ["b[0,0].x", "b[0,1].x", "b[0,1].y", "total"];
        assert_eq!(chosen("b[0,1].*,total", &grid), Ok(grid[1..].to_vec()));
        assert!(chosen("hD", &["hA", "hB"]).expect_err("no hD").to_string().contains("did you mean"));
    }
}
