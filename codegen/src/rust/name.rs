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
        while !self.taken.insert(name.clone()) {
            name = format!("{wished}_{suffix}");
            suffix += 1;
        }
        name
    }

    /// A temporary without a name from the model.
    pub fn temporary(&mut self) -> String {
        self.temporaries += 1;
        self.free(format!("t{}", self.temporaries))
    }
}
