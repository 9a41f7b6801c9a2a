//! The imports between the files of every crate contain no cycle.
//!
//! A file may name items of another by `crate::`, `super::`, `self::` or the name of a submodule; this test builds the
//! graph of these references and looks for cycles.

use proc_macro2::{TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Crates whose files are drawn.
const CRATES: [&str; 4] = ["codegen", "runtime", "bed", "host"];

/// A module: its path from the crate's root, without `crate`.
type Module = Vec<String>;

/// Modules of a crate by the path of their files, with the items that each names.
fn modules(folder: &Path) -> BTreeMap<Module, String> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(at) = folders.pop() {
        for path in std::fs::read_dir(&at).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            // A program only calls the library that stands beside it.
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") && !path.ends_with("main.rs") {
                let inside = path.strip_prefix(folder).expect("below the folder").with_extension("");
                let mut module: Module =
                    inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
                if module.last().is_some_and(|last| ["mod", "lib"].contains(&last.as_str())) {
                    module.pop();
                }
                found.insert(module, std::fs::read_to_string(&path).expect("a text"));
            }
        }
    }
    found
}

/// Paths that a text names, written out from the root of the crate; those of other crates lead no further than the
/// module itself.
fn named(module: &Module, text: &str) -> Vec<Module> {
    let mut found = Vec::new();
    let stream: TokenStream = text.parse().unwrap_or_else(|error| panic!("{module:?}: {error}"));
    collect(module, stream, &mut found);
    found
}

fn collect(module: &Module, stream: TokenStream, found: &mut Vec<Module>) {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        // Tests stand beside what they test and may name anything.
        if is_test(&tokens[at..]) {
            while !matches!(&tokens[at], TokenTree::Group(group) if group.to_string().starts_with('{')) {
                at += 1;
            }
        } else if let TokenTree::Group(group) = &tokens[at] {
            collect(module, group.stream(), found);
        } else if let Some((start, next)) = start_of_path(module, &tokens, at) {
            at = path(start, &tokens, next, found);
            continue;
        }
        at += 1;
    }
}

/// `#[cfg(test)] mod`, whoever may see it.
fn is_test(tokens: &[TokenTree]) -> bool {
    let mut texts = tokens.iter().take(5).map(|token| token.to_string().replace(' ', ""));
    let is_asked = texts.next().as_deref() == Some("#") && texts.next().as_deref() == Some("[cfg(test)]");
    is_asked && texts.find(|text| text != "pub" && !text.starts_with('(')).as_deref() == Some("mod")
}

/// Where `crate::`, `self::` or any number of `super::` lead, or a word before `::`, and the token behind them.
fn start_of_path(module: &Module, tokens: &[TokenTree], mut at: usize) -> Option<(Module, usize)> {
    let word = |at: usize| tokens.get(at).map(ToString::to_string).unwrap_or_default();
    // The middle of a path starts none, nor does `$crate`.
    let behind = |n: usize| at.checked_sub(n).map(word).unwrap_or_default();
    if behind(1) == "$" || behind(1) == ":" && behind(2) == ":" {
        return None;
    }
    let is_word = matches!(tokens.get(at), Some(TokenTree::Ident(_)));
    if is_word && !["crate", "self", "super"].contains(&word(at).as_str()) {
        return (word(at + 1) == ":" && word(at + 2) == ":").then(|| (module.clone(), at));
    }
    let mut start = match word(at).as_str() {
        "crate" => Module::new(),
        "self" | "super" => module.clone(),
        _ => return None,
    };
    let mut steps = 0;
    while ["crate", "self", "super"].contains(&word(at).as_str())
        && word(at + 1) == ":"
        && word(at + 2) == ":"
    {
        if word(at) == "super" {
            start.pop();
        }
        (at, steps) = (at + 3, steps + 1);
    }
    (0 < steps).then_some((start, at))
}

/// Follows a path, into every branch of its braces; returns the first token behind it.
fn path(mut way: Module, tokens: &[TokenTree], mut at: usize, found: &mut Vec<Module>) -> usize {
    loop {
        match tokens.get(at) {
            Some(TokenTree::Ident(word)) => way.push(word.to_string()),
            Some(TokenTree::Group(group)) => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                for branch in
                    inside.split(|token| token.to_string() == ",").filter(|branch| !branch.is_empty())
                {
                    path(way.clone(), branch, 0, found);
                }
                return at + 1;
            }
            _ => break,
        }
        at += 1;
        let text = |at: usize| tokens.get(at).map(ToString::to_string).unwrap_or_default();
        if text(at) != ":" || text(at + 1) != ":" {
            break;
        }
        at += 2;
    }
    found.push(way);
    at
}

/// Edges between the modules of a crate: each names something of the others.
fn graph(modules: &BTreeMap<Module, String>) -> Graph<'_> {
    let module_of = |way: &Module| {
        (0..=way.len())
            .rev()
            .find_map(|length| modules.get_key_value(&way[..length]).map(|(module, _)| module))
    };
    let edges = |module: &Module, text: &str| {
        named(module, text).iter().filter_map(module_of).filter(|other| *other != module).collect()
    };
    modules.iter().map(|(module, text)| (module, edges(module, text))).collect()
}

/// By module: the modules that it names.
type Graph<'m> = BTreeMap<&'m Module, BTreeSet<&'m Module>>;

/// All that a module leads to.
fn reached<'m>(graph: &Graph<'m>, from: &Module) -> BTreeSet<&'m Module> {
    let mut seen = BTreeSet::new();
    let mut next: Vec<&'m Module> = graph[from].iter().copied().collect();
    while let Some(module) = next.pop() {
        if seen.insert(module) {
            next.extend(&graph[module]);
        }
    }
    seen
}

/// Modules from which a way leads back to themselves, circle by circle.
fn circles(graph: &Graph<'_>) -> Vec<BTreeSet<String>> {
    let reach: Graph<'_> = graph.keys().map(|module| (*module, reached(graph, module))).collect();
    let mut found: BTreeSet<BTreeSet<String>> = BTreeSet::new();
    for (module, others) in &reach {
        if others.contains(module) {
            let circle = others.iter().filter(|other| reach[*other].contains(module));
            found.insert(circle.map(|module| module.join("::")).collect());
        }
    }
    found.into_iter().collect()
}

#[test]
fn files_import_one_another_without_a_circle() {
    let mut found = Vec::new();
    for name in CRATES {
        let modules = modules(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name).join("src"));
        assert!(20 < modules.len(), "{name} has files");
        found.extend(circles(&graph(&modules)).iter().map(|circle| format!("{name}: {circle:?}")));
    }
    assert!(found.is_empty(), "these files import one another in circles:\n{}", found.join("\n"));
}

#[test]
fn circles_are_found_through_every_kind_of_name() {
    let crate_of = |files: &[(&str, &str)]| -> usize {
        let module =
            |path: &str| path.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect();
        let modules = files.iter().map(|(path, text)| (module(path), (*text).to_owned())).collect();
        circles(&graph(&modules)).len()
    };
    assert_eq!(crate_of(&[("a", "use crate::b::X;"), ("b", "use crate::{c::{Y, Z}, d};"), ("c", "")]), 0);
    assert_eq!(crate_of(&[("a", "use crate::b::X;"), ("b", "use crate::{c, a::{Y, Z}};"), ("c", "")]), 1);
    assert_eq!(crate_of(&[("a", "pub use b::X; use self::b::Y;"), ("a::b", "use super::*;")]), 1);
    assert_eq!(crate_of(&[("a", "pub use b::X; use std::fs;"), ("a::b", "use crate::a::Y;")]), 1);
    assert_eq!(crate_of(&[("a", "fn f() { b::g() }"), ("a::b", "fn g() { super::f() }")]), 1);
    assert_eq!(crate_of(&[("a", "fn f() -> crate::b::X { todo() }"), ("b", "fn g(x: super::a::X) {}")]), 1);
    assert_eq!(
        crate_of(&[("a", "use crate::b::X;"), ("b", "#[cfg(test)] mod tests { use crate::a::X; }")]),
        0
    );
    let seen = "#[cfg(test)] pub(crate) mod tests { use crate::a::X; }";
    assert_eq!(crate_of(&[("a", "use crate::b::X;"), ("b", seen)]), 0);
    let three =
        [("a", "use super::b;"), ("b", "use super::c;"), ("c", "use crate::a;"), ("d", "use crate::a;")];
    assert_eq!(crate_of(&three), 1);
}
