//! Suggestions for unknown names.

/// Least similarity (Jaro-Winkler, 0 to 1) for a suggestion.
const ALIKE: f64 = 0.66;
/// Number of known names listed if none is similar.
const LISTED: usize = 12;

/// `; did you mean X?`, or a list of known names, to be appended to a message.
pub fn help<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.into_iter().collect();
    let best = known
        .iter()
        .map(|k| (strsim::jaro_winkler(&name.to_lowercase(), &k.to_lowercase()), *k))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    match best {
        None => "; there are none".to_owned(),
        Some((likeness, k)) if likeness >= ALIKE => format!("; did you mean `{k}`?"),
        Some(_) => {
            let more = if known.len() > LISTED { ", ..." } else { "" };
            format!("; there are {}{more}", known[..known.len().min(LISTED)].join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_understood() {
        assert_eq!(help("ha", ["hA", "hB"]), "; did you mean `hA`?");
        assert_eq!(help("zzz", ["hA", "hB"]), "; there are hA, hB");
        assert_eq!(help("zzz", []), "; there are none");
    }
}
