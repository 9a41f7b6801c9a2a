//! Identifiers: sanitised, never a keyword, never twice.

use rustc_hash::FxHashSet as HashSet;

/// Words that are not identifiers, or would hide what an emitted function uses.
fn is_taken(word: &str) -> bool {
    matches!(
        word,
        "as" | "async"
            | "await"
            | "break"
            | "const"
            | "continue"
            | "crate"
            | "dyn"
            | "else"
            | "enum"
            | "extern"
            | "false"
            | "fn"
            | "for"
            | "if"
            | "impl"
            | "in"
            | "let"
            | "loop"
            | "match"
            | "mod"
            | "move"
            | "mut"
            | "pub"
            | "ref"
            | "return"
            | "self"
            | "Self"
            | "static"
            | "struct"
            | "super"
            | "trait"
            | "true"
            | "type"
            | "unsafe"
            | "use"
            | "where"
            | "while"
            | "abstract"
            | "become"
            | "box"
            | "do"
            | "final"
            | "gen"
            | "macro"
            | "override"
            | "priv"
            | "try"
            | "typeof"
            | "unsized"
            | "virtual"
            | "yield"
            | "Real"
            | "S"
            | "Parameters"
            | "Prepared"
            | "NQ"
    )
}

/// A valid identifier for a model's name.
#[must_use]
pub(super) fn identifier(name: &str) -> String {
    let mut text: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' { c } else { '_' }).collect();
    if text.is_empty() || text.starts_with(|c: char| c.is_ascii_digit()) || text.chars().all(|c| c == '_') {
        text.insert(0, 'x');
    }
    if is_taken(&text) {
        text.push('_');
    }
    text
}

/// `my_tile` -> `MyTile`.
#[must_use]
pub(super) fn type_name(name: &str) -> String {
    let camel: String = identifier(name)
        .split('_')
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().map(|c| c.to_ascii_uppercase()).into_iter().chain(letters).collect::<Vec<_>>()
        })
        .collect();
    identifier(&camel)
}

/// The description with a capital, or the name where there is none.
#[must_use]
pub(super) fn sentence(doc: &str, name: &str) -> String {
    let text = if doc.is_empty() { name } else { doc };
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |c| c.to_uppercase().chain(letters).collect())
}

/// The names in scope of one function.
#[derive(Default)]
pub(super) struct Scope {
    /// All but those of temporaries, which are many and need no list.
    taken: HashSet<String>,
    temporaries: usize,
}

impl Scope {
    /// Keeps a name from being given out.
    pub fn reserve(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// The wished name, or with the first free numeric suffix.
    pub fn unique(&mut self, wished: &str) -> String {
        self.free(identifier(wished))
    }

    fn free(&mut self, wished: String) -> String {
        let mut name = wished.clone();
        let mut suffix = 2;
        while self.is_taken(&name) {
            name = format!("{wished}_{suffix}");
            suffix += 1;
        }
        self.taken.insert(name.clone());
        name
    }

    fn is_taken(&self, name: &str) -> bool {
        self.taken.contains(name) || self.is_temporary(name)
    }

    /// One of t1, t2, ... that have been given out?
    fn is_temporary(&self, name: &str) -> bool {
        let number = name.strip_prefix('t').filter(|digits| digits.starts_with(|c| matches!(c, '1'..='9')));
        number.and_then(|digits| digits.parse().ok()).is_some_and(|n: usize| n <= self.temporaries)
    }

    /// A temporary without a name from the model.
    pub fn temporary(&mut self) -> String {
        let mut name = String::with_capacity(8);
        name.push('t');
        push_number(&mut name, self.temporaries + 1);
        let name = if self.taken.contains(&name) { self.free(name) } else { name };
        self.temporaries += 1;
        name
    }
}

/// In decimal digits; the formatter takes as long as the rest of a short statement.
fn push_number(text: &mut String, n: usize) {
    if n >= 10 {
        push_number(text, n / 10);
    }
    text.push(char::from(b'0' + (n % 10) as u8));
}

#[cfg(test)]
mod tests {
    use super::Scope;

    #[test]
    fn no_name_is_given_out_twice() {
        let mut scope = Scope::default();
        assert_eq!([scope.unique("t2"), scope.temporary(), scope.temporary()], ["t2", "t1", "t2_2"]);
        assert_eq!([scope.unique("t1"), scope.unique("t2"), scope.unique("t3")], ["t1_2", "t2_3", "t3"]);
        assert_eq!([scope.temporary(), scope.unique("t01")], ["t3_2", "t01"]);
    }
}
